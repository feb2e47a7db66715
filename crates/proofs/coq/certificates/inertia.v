(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.


(** point-mass: The tensor of a point, applied to a spin w, is its angular momentum m r x (w x r), for every point and spin. *)

(* L = I w, x *)
Theorem point_mass_1 :
  forall m omega1 omega2 omega3 r1 r2 r3 : R,
  (- (m * r1 * r3)) * omega3 + ((- (m * r1 * r2)) * omega2 + (m * r2 * r2 + m * r3 * r3) * omega1) =
    (r2 * (omega1 * r2 - omega2 * r1) - r3 * (omega3 * r1 - omega1 * r3)) * m.
Proof.
  intros m omega1 omega2 omega3 r1 r2 r3   .
  rational.
Qed.

(* L = I w, y *)
Theorem point_mass_2 :
  forall m omega1 omega2 omega3 r1 r2 r3 : R,
  (- (m * r2 * r3)) * omega3 + ((m * r3 * r3 + m * r1 * r1) * omega2 + (- (m * r1 * r2)) * omega1) =
    (r3 * (omega2 * r3 - omega3 * r2) - r1 * (omega1 * r2 - omega2 * r1)) * m.
Proof.
  intros m omega1 omega2 omega3 r1 r2 r3   .
  rational.
Qed.

(* L = I w, z *)
Theorem point_mass_3 :
  forall m omega1 omega2 omega3 r1 r2 r3 : R,
  (m * r1 * r1 + m * r2 * r2) * omega3 + ((- (m * r2 * r3)) * omega2 + (- (m * r1 * r3)) * omega1) =
    (r1 * (omega3 * r1 - omega1 * r3) - r2 * (omega2 * r3 - omega3 * r2)) * m.
Proof.
  intros m omega1 omega2 omega3 r1 r2 r3   .
  rational.
Qed.

(* With the products without their minus. *)

(* L = I w, x *)
Theorem point_mass_mutant_1 :
  exists m omega1 omega2 omega3 r1 r2 r3 : R,
  m * r1 * r3 * omega3 + (m * r1 * r2 * omega2 + (m * r2 * r2 + m * r3 * r3) * omega1) <> (r2 *
    (omega1 * r2 - omega2 * r1) - r3 * (omega3 * r1 - omega1 * r3)) * m.
Proof.
  exists (625 / 1521), 1, (-3), 1, 7, 4, 3.
  computed.
Qed.

(* With the axes one further on. *)

(* L = I w, x *)
Theorem point_mass_mutant_2 :
  exists m omega1 omega2 omega3 r1 r2 r3 : R,
  (- (m * r1 * r2)) * omega3 + ((- (m * r2 * r3)) * omega2 + (m * r3 * r3 + m * r1 * r1) * omega1)
    <> (r2 * (omega1 * r2 - omega2 * r1) - r3 * (omega3 * r1 - omega1 * r3)) * m.
Proof.
  exists (625 / 1521), 1, (-3), 1, 7, 4, 3.
  computed.
Qed.


(** every-body-obeys-the-triangle-inequality: About every axis n, half the trace less the moment is the sum of m (n.r)², for every point and so for every body: never below zero, hence no moment above the sum of the others. *)

(* half the trace less the moment *)
Theorem every_body_obeys_the_triangle_inequality_1 :
  forall m n1 n2 n3 r1 r2 r3 : R,
  let t_1 := m * r2 * r2 + m * r3 * r3 in
  let t_2 := m * r3 * r3 + m * r1 * r1 in
  let t_3 := m * r1 * r1 + m * r2 * r2 in
  let t_4 := n1 * r1 + n2 * r2 + n3 * r3 in
  (t_1 + t_2 + t_3) / 2 * (n1 * n1 + n2 * n2 + n3 * n3) - (n1 * ((- (m * r1 * r3)) * n3 + ((- (m *
    r1 * r2)) * n2 + t_1 * n1)) + n2 * ((- (m * r2 * r3)) * n3 + (t_2 * n2 + (- (m * r1 * r2)) *
    n1)) + n3 * (t_3 * n3 + ((- (m * r2 * r3)) * n2 + (- (m * r1 * r3)) * n1))) = m * t_4 * t_4.
Proof.
  intros m n1 n2 n3 r1 r2 r3  t_1 t_2 t_3 t_4 .
  rational.
Qed.

(* With the products without their minus. *)

(* half the trace less the moment *)
Theorem every_body_obeys_the_triangle_inequality_mutant_1 :
  exists m n1 n2 n3 r1 r2 r3 : R,
  let t_1 := m * r2 * r2 + m * r3 * r3 in
  let t_2 := m * r3 * r3 + m * r1 * r1 in
  let t_3 := m * r1 * r1 + m * r2 * r2 in
  let t_4 := n1 * r1 + n2 * r2 + n3 * r3 in
  (t_1 + t_2 + t_3) / 2 * (n1 * n1 + n2 * n2 + n3 * n3) - (n1 * (m * r1 * r3 * n3 + (m * r1 * r2 *
    n2 + t_1 * n1)) + n2 * (m * r2 * r3 * n3 + (t_2 * n2 + m * r1 * r2 * n1)) + n3 * (t_3 * n3 + (m
    * r2 * r3 * n2 + m * r1 * r3 * n1))) <> m * t_4 * t_4.
Proof.
  exists (625 / 1521), 1, (-3), 1, 7, 4, 3.
  intros t_1; cut_to t_1 (15625 / 1521) computed.
  intros t_2; cut_to t_2 (36250 / 1521) computed.
  intros t_3; cut_to t_3 (3125 / 117) computed.
  intros t_4; cut_to t_4 (-2) computed.
  computed.
Qed.


(** parallel-axes: About a point away from the centre, a body's tensor is that about the centre plus that of a point with all its mass. *)

(* the tensor about d, xx *)
Theorem parallel_axes_1 :
  forall d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3 : R,
  let t_1 := (r2 * m_r + s2 * m_s + t2 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r3 * m_r + s3 * m_s + t3 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  m_r * (r2 - d2) * (r2 - d2) + m_r * (r3 - d3) * (r3 - d3) + (m_s * (s2 - d2) * (s2 - d2) + m_s *
    (s3 - d3) * (s3 - d3)) + (m_t * (t2 - d2) * (t2 - d2) + m_t * (t3 - d3) * (t3 - d3)) = m_r * (r2
    - t_1) * (r2 - t_1) + m_r * (r3 - t_2) * (r3 - t_2) + (m_s * (s2 - t_1) * (s2 - t_1) + m_s * (s3
    - t_2) * (s3 - t_2)) + (m_t * (t2 - t_1) * (t2 - t_1) + m_t * (t3 - t_2) * (t3 - t_2)) + ((m_r +
    m_s + m_t) * (t_1 - d2) * (t_1 - d2) + (m_r + m_s + m_t) * (t_2 - d3) * (t_2 - d3)).
Proof.
  intros d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3  t_1 t_2 D_1.
  rational.
Qed.

(* the tensor about d, xy *)
Theorem parallel_axes_2 :
  forall d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2 : R,
  let t_1 := (r1 * m_r + s1 * m_s + t1 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r2 * m_r + s2 * m_s + t2 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  - (m_r * (r1 - d1) * (r2 - d2)) - m_s * (s1 - d1) * (s2 - d2) - m_t * (t1 - d1) * (t2 - d2) = -
    (m_r * (r1 - t_1) * (r2 - t_2)) - m_s * (s1 - t_1) * (s2 - t_2) - m_t * (t1 - t_1) * (t2 - t_2)
    - (m_r + m_s + m_t) * (t_1 - d1) * (t_2 - d2).
Proof.
  intros d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2  t_1 t_2 D_1.
  rational.
Qed.

(* the tensor about d, xz *)
Theorem parallel_axes_3 :
  forall d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3 : R,
  let t_1 := (r1 * m_r + s1 * m_s + t1 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r3 * m_r + s3 * m_s + t3 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  - (m_r * (r1 - d1) * (r3 - d3)) - m_s * (s1 - d1) * (s3 - d3) - m_t * (t1 - d1) * (t3 - d3) = -
    (m_r * (r1 - t_1) * (r3 - t_2)) - m_s * (s1 - t_1) * (s3 - t_2) - m_t * (t1 - t_1) * (t3 - t_2)
    - (m_r + m_s + m_t) * (t_1 - d1) * (t_2 - d3).
Proof.
  intros d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3  t_1 t_2 D_1.
  rational.
Qed.

(* the tensor about d, yx *)
Theorem parallel_axes_4 :
  forall d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2 : R,
  let t_1 := (r1 * m_r + s1 * m_s + t1 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r2 * m_r + s2 * m_s + t2 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  - (m_r * (r1 - d1) * (r2 - d2)) - m_s * (s1 - d1) * (s2 - d2) - m_t * (t1 - d1) * (t2 - d2) = -
    (m_r * (r1 - t_1) * (r2 - t_2)) - m_s * (s1 - t_1) * (s2 - t_2) - m_t * (t1 - t_1) * (t2 - t_2)
    - (m_r + m_s + m_t) * (t_1 - d1) * (t_2 - d2).
Proof.
  intros d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2  t_1 t_2 D_1.
  rational.
Qed.

(* the tensor about d, yy *)
Theorem parallel_axes_5 :
  forall d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3 : R,
  let t_1 := (r3 * m_r + s3 * m_s + t3 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r1 * m_r + s1 * m_s + t1 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  m_r * (r3 - d3) * (r3 - d3) + m_r * (r1 - d1) * (r1 - d1) + (m_s * (s3 - d3) * (s3 - d3) + m_s *
    (s1 - d1) * (s1 - d1)) + (m_t * (t3 - d3) * (t3 - d3) + m_t * (t1 - d1) * (t1 - d1)) = m_r * (r3
    - t_1) * (r3 - t_1) + m_r * (r1 - t_2) * (r1 - t_2) + (m_s * (s3 - t_1) * (s3 - t_1) + m_s * (s1
    - t_2) * (s1 - t_2)) + (m_t * (t3 - t_1) * (t3 - t_1) + m_t * (t1 - t_2) * (t1 - t_2)) + ((m_r +
    m_s + m_t) * (t_1 - d3) * (t_1 - d3) + (m_r + m_s + m_t) * (t_2 - d1) * (t_2 - d1)).
Proof.
  intros d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3  t_1 t_2 D_1.
  rational.
Qed.

(* the tensor about d, yz *)
Theorem parallel_axes_6 :
  forall d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3 : R,
  let t_1 := (r2 * m_r + s2 * m_s + t2 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r3 * m_r + s3 * m_s + t3 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  - (m_r * (r2 - d2) * (r3 - d3)) - m_s * (s2 - d2) * (s3 - d3) - m_t * (t2 - d2) * (t3 - d3) = -
    (m_r * (r2 - t_1) * (r3 - t_2)) - m_s * (s2 - t_1) * (s3 - t_2) - m_t * (t2 - t_1) * (t3 - t_2)
    - (m_r + m_s + m_t) * (t_1 - d2) * (t_2 - d3).
Proof.
  intros d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3  t_1 t_2 D_1.
  rational.
Qed.

(* the tensor about d, zx *)
Theorem parallel_axes_7 :
  forall d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3 : R,
  let t_1 := (r1 * m_r + s1 * m_s + t1 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r3 * m_r + s3 * m_s + t3 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  - (m_r * (r1 - d1) * (r3 - d3)) - m_s * (s1 - d1) * (s3 - d3) - m_t * (t1 - d1) * (t3 - d3) = -
    (m_r * (r1 - t_1) * (r3 - t_2)) - m_s * (s1 - t_1) * (s3 - t_2) - m_t * (t1 - t_1) * (t3 - t_2)
    - (m_r + m_s + m_t) * (t_1 - d1) * (t_2 - d3).
Proof.
  intros d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3  t_1 t_2 D_1.
  rational.
Qed.

(* the tensor about d, zy *)
Theorem parallel_axes_8 :
  forall d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3 : R,
  let t_1 := (r2 * m_r + s2 * m_s + t2 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r3 * m_r + s3 * m_s + t3 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  - (m_r * (r2 - d2) * (r3 - d3)) - m_s * (s2 - d2) * (s3 - d3) - m_t * (t2 - d2) * (t3 - d3) = -
    (m_r * (r2 - t_1) * (r3 - t_2)) - m_s * (s2 - t_1) * (s3 - t_2) - m_t * (t2 - t_1) * (t3 - t_2)
    - (m_r + m_s + m_t) * (t_1 - d2) * (t_2 - d3).
Proof.
  intros d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3  t_1 t_2 D_1.
  rational.
Qed.

(* the tensor about d, zz *)
Theorem parallel_axes_9 :
  forall d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2 : R,
  let t_1 := (r1 * m_r + s1 * m_s + t1 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r2 * m_r + s2 * m_s + t2 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 ->
  m_r * (r1 - d1) * (r1 - d1) + m_r * (r2 - d2) * (r2 - d2) + (m_s * (s1 - d1) * (s1 - d1) + m_s *
    (s2 - d2) * (s2 - d2)) + (m_t * (t1 - d1) * (t1 - d1) + m_t * (t2 - d2) * (t2 - d2)) = m_r * (r1
    - t_1) * (r1 - t_1) + m_r * (r2 - t_2) * (r2 - t_2) + (m_s * (s1 - t_1) * (s1 - t_1) + m_s * (s2
    - t_2) * (s2 - t_2)) + (m_t * (t1 - t_1) * (t1 - t_1) + m_t * (t2 - t_2) * (t2 - t_2)) + ((m_r +
    m_s + m_t) * (t_1 - d1) * (t_1 - d1) + (m_r + m_s + m_t) * (t_2 - d2) * (t_2 - d2)).
Proof.
  intros d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2  t_1 t_2 D_1.
  rational.
Qed.

(* With subtracted, not added. *)

(* the tensor about d, xx *)
Theorem parallel_axes_mutant_1 :
  exists d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3 : R,
  let t_1 := (r2 * m_r + s2 * m_s + t2 * m_t) / (m_r + m_s + m_t) in
  let t_2 := (r3 * m_r + s3 * m_s + t3 * m_t) / (m_r + m_s + m_t) in
  m_r + m_s + m_t <> 0 /\
  m_r * (r2 - d2) * (r2 - d2) + m_r * (r3 - d3) * (r3 - d3) + (m_s * (s2 - d2) * (s2 - d2) + m_s *
    (s3 - d3) * (s3 - d3)) + (m_t * (t2 - d2) * (t2 - d2) + m_t * (t3 - d3) * (t3 - d3)) <> m_r *
    (r2 - t_1) * (r2 - t_1) + m_r * (r3 - t_2) * (r3 - t_2) + (m_s * (s2 - t_1) * (s2 - t_1) + m_s *
    (s3 - t_2) * (s3 - t_2)) + (m_t * (t2 - t_1) * (t2 - t_1) + m_t * (t3 - t_2) * (t3 - t_2)) -
    ((m_r + m_s + m_t) * (t_1 - d2) * (t_1 - d2) + (m_r + m_s + m_t) * (t_2 - d3) * (t_2 - d3)).
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2.
  intros t_1; cut_to t_1 (26 / 5) computed.
  intros t_2; cut_to t_2 (7 / 5) computed.
  split; [computed | ]. computed.
Qed.


(** parts-of-a-body: Parts put together in steps, counted from any point, make the same body; two points turn as one with their reduced mass. *)

(* centre, x *)
Theorem parts_of_a_body_1 :
  forall d1 m_r m_s m_t r1 s1 t1 : R,
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  d1 + ((r1 - d1) * m_r + (s1 - d1) * m_s + (t1 - d1) * m_t) / (m_r + m_s + m_t) = ((s1 * m_s + t1 *
    m_t) / (m_s + m_t) * (m_s + m_t) + r1 * m_r) / (m_s + m_t + m_r).
Proof.
  intros d1 m_r m_s m_t r1 s1 t1   D_1 D_2 D_3.
  rational.
Qed.

(* centre, y *)
Theorem parts_of_a_body_2 :
  forall d2 m_r m_s m_t r2 s2 t2 : R,
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  d2 + ((r2 - d2) * m_r + (s2 - d2) * m_s + (t2 - d2) * m_t) / (m_r + m_s + m_t) = ((s2 * m_s + t2 *
    m_t) / (m_s + m_t) * (m_s + m_t) + r2 * m_r) / (m_s + m_t + m_r).
Proof.
  intros d2 m_r m_s m_t r2 s2 t2   D_1 D_2 D_3.
  rational.
Qed.

(* centre, z *)
Theorem parts_of_a_body_3 :
  forall d3 m_r m_s m_t r3 s3 t3 : R,
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  d3 + ((r3 - d3) * m_r + (s3 - d3) * m_s + (t3 - d3) * m_t) / (m_r + m_s + m_t) = ((s3 * m_s + t3 *
    m_t) / (m_s + m_t) * (m_s + m_t) + r3 * m_r) / (m_s + m_t + m_r).
Proof.
  intros d3 m_r m_s m_t r3 s3 t3   D_1 D_2 D_3.
  rational.
Qed.

(* inertia, xx *)
Theorem parts_of_a_body_4 :
  forall d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3 : R,
  let t_1 := ((r2 - d2) * m_r + (s2 - d2) * m_s + (t2 - d2) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r3 - d3) * m_r + (s3 - d3) * m_s + (t3 - d3) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_4 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r2 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r3 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  m_r * (r2 - d2 - t_1) * (r2 - d2 - t_1) + m_r * (r3 - d3 - t_2) * (r3 - d3 - t_2) + (m_s * (s2 -
    d2 - t_1) * (s2 - d2 - t_1) + m_s * (s3 - d3 - t_2) * (s3 - d3 - t_2)) + (m_t * (t2 - d2 - t_1)
    * (t2 - d2 - t_1) + m_t * (t3 - d3 - t_2) * (t3 - d3 - t_2)) = m_s * (s2 - t_3) * (s2 - t_3) +
    m_s * (s3 - t_4) * (s3 - t_4) + (m_t * (t2 - t_3) * (t2 - t_3) + m_t * (t3 - t_4) * (t3 - t_4))
    + ((m_s + m_t) * (t_3 - t_5) * (t_3 - t_5) + (m_s + m_t) * (t_4 - t_6) * (t_4 - t_6)) + (m_r *
    (r2 - t_5) * (r2 - t_5) + m_r * (r3 - t_6) * (r3 - t_6)).
Proof.
  intros d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* inertia, xy *)
Theorem parts_of_a_body_5 :
  forall d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2 : R,
  let t_1 := ((r1 - d1) * m_r + (s1 - d1) * m_s + (t1 - d1) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r2 - d2) * m_r + (s2 - d2) * m_s + (t2 - d2) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_4 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r1 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r2 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  - (m_r * (r1 - d1 - t_1) * (r2 - d2 - t_2)) - m_s * (s1 - d1 - t_1) * (s2 - d2 - t_2) - m_t * (t1
    - d1 - t_1) * (t2 - d2 - t_2) = - (m_s * (s1 - t_3) * (s2 - t_4)) - m_t * (t1 - t_3) * (t2 -
    t_4) - (m_s + m_t) * (t_3 - t_5) * (t_4 - t_6) - m_r * (r1 - t_5) * (r2 - t_6).
Proof.
  intros d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* inertia, xz *)
Theorem parts_of_a_body_6 :
  forall d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3 : R,
  let t_1 := ((r1 - d1) * m_r + (s1 - d1) * m_s + (t1 - d1) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r3 - d3) * m_r + (s3 - d3) * m_s + (t3 - d3) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_4 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r1 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r3 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  - (m_r * (r1 - d1 - t_1) * (r3 - d3 - t_2)) - m_s * (s1 - d1 - t_1) * (s3 - d3 - t_2) - m_t * (t1
    - d1 - t_1) * (t3 - d3 - t_2) = - (m_s * (s1 - t_3) * (s3 - t_4)) - m_t * (t1 - t_3) * (t3 -
    t_4) - (m_s + m_t) * (t_3 - t_5) * (t_4 - t_6) - m_r * (r1 - t_5) * (r3 - t_6).
Proof.
  intros d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* inertia, yx *)
Theorem parts_of_a_body_7 :
  forall d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2 : R,
  let t_1 := ((r1 - d1) * m_r + (s1 - d1) * m_s + (t1 - d1) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r2 - d2) * m_r + (s2 - d2) * m_s + (t2 - d2) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_4 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r1 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r2 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  - (m_r * (r1 - d1 - t_1) * (r2 - d2 - t_2)) - m_s * (s1 - d1 - t_1) * (s2 - d2 - t_2) - m_t * (t1
    - d1 - t_1) * (t2 - d2 - t_2) = - (m_s * (s1 - t_3) * (s2 - t_4)) - m_t * (t1 - t_3) * (t2 -
    t_4) - (m_s + m_t) * (t_3 - t_5) * (t_4 - t_6) - m_r * (r1 - t_5) * (r2 - t_6).
Proof.
  intros d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* inertia, yy *)
Theorem parts_of_a_body_8 :
  forall d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3 : R,
  let t_1 := ((r3 - d3) * m_r + (s3 - d3) * m_s + (t3 - d3) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r1 - d1) * m_r + (s1 - d1) * m_s + (t1 - d1) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  let t_4 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r3 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r1 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  m_r * (r3 - d3 - t_1) * (r3 - d3 - t_1) + m_r * (r1 - d1 - t_2) * (r1 - d1 - t_2) + (m_s * (s3 -
    d3 - t_1) * (s3 - d3 - t_1) + m_s * (s1 - d1 - t_2) * (s1 - d1 - t_2)) + (m_t * (t3 - d3 - t_1)
    * (t3 - d3 - t_1) + m_t * (t1 - d1 - t_2) * (t1 - d1 - t_2)) = m_s * (s3 - t_3) * (s3 - t_3) +
    m_s * (s1 - t_4) * (s1 - t_4) + (m_t * (t3 - t_3) * (t3 - t_3) + m_t * (t1 - t_4) * (t1 - t_4))
    + ((m_s + m_t) * (t_3 - t_5) * (t_3 - t_5) + (m_s + m_t) * (t_4 - t_6) * (t_4 - t_6)) + (m_r *
    (r3 - t_5) * (r3 - t_5) + m_r * (r1 - t_6) * (r1 - t_6)).
Proof.
  intros d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* inertia, yz *)
Theorem parts_of_a_body_9 :
  forall d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3 : R,
  let t_1 := ((r2 - d2) * m_r + (s2 - d2) * m_s + (t2 - d2) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r3 - d3) * m_r + (s3 - d3) * m_s + (t3 - d3) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_4 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r2 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r3 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  - (m_r * (r2 - d2 - t_1) * (r3 - d3 - t_2)) - m_s * (s2 - d2 - t_1) * (s3 - d3 - t_2) - m_t * (t2
    - d2 - t_1) * (t3 - d3 - t_2) = - (m_s * (s2 - t_3) * (s3 - t_4)) - m_t * (t2 - t_3) * (t3 -
    t_4) - (m_s + m_t) * (t_3 - t_5) * (t_4 - t_6) - m_r * (r2 - t_5) * (r3 - t_6).
Proof.
  intros d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* inertia, zx *)
Theorem parts_of_a_body_10 :
  forall d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3 : R,
  let t_1 := ((r1 - d1) * m_r + (s1 - d1) * m_s + (t1 - d1) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r3 - d3) * m_r + (s3 - d3) * m_s + (t3 - d3) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_4 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r1 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r3 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  - (m_r * (r1 - d1 - t_1) * (r3 - d3 - t_2)) - m_s * (s1 - d1 - t_1) * (s3 - d3 - t_2) - m_t * (t1
    - d1 - t_1) * (t3 - d3 - t_2) = - (m_s * (s1 - t_3) * (s3 - t_4)) - m_t * (t1 - t_3) * (t3 -
    t_4) - (m_s + m_t) * (t_3 - t_5) * (t_4 - t_6) - m_r * (r1 - t_5) * (r3 - t_6).
Proof.
  intros d1 d3 m_r m_s m_t r1 r3 s1 s3 t1 t3  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* inertia, zy *)
Theorem parts_of_a_body_11 :
  forall d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3 : R,
  let t_1 := ((r2 - d2) * m_r + (s2 - d2) * m_s + (t2 - d2) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r3 - d3) * m_r + (s3 - d3) * m_s + (t3 - d3) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_4 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r2 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r3 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  - (m_r * (r2 - d2 - t_1) * (r3 - d3 - t_2)) - m_s * (s2 - d2 - t_1) * (s3 - d3 - t_2) - m_t * (t2
    - d2 - t_1) * (t3 - d3 - t_2) = - (m_s * (s2 - t_3) * (s3 - t_4)) - m_t * (t2 - t_3) * (t3 -
    t_4) - (m_s + m_t) * (t_3 - t_5) * (t_4 - t_6) - m_r * (r2 - t_5) * (r3 - t_6).
Proof.
  intros d2 d3 m_r m_s m_t r2 r3 s2 s3 t2 t3  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* inertia, zz *)
Theorem parts_of_a_body_12 :
  forall d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2 : R,
  let t_1 := ((r1 - d1) * m_r + (s1 - d1) * m_s + (t1 - d1) * m_t) / (m_r + m_s + m_t) in
  let t_2 := ((r2 - d2) * m_r + (s2 - d2) * m_s + (t2 - d2) * m_t) / (m_r + m_s + m_t) in
  let t_3 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_4 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_5 := (t_3 * (m_s + m_t) + r1 * m_r) / (m_s + m_t + m_r) in
  let t_6 := (t_4 * (m_s + m_t) + r2 * m_r) / (m_s + m_t + m_r) in
  m_r + m_s + m_t <> 0 ->
  m_s + m_t <> 0 ->
  m_s + m_t + m_r <> 0 ->
  m_r * (r1 - d1 - t_1) * (r1 - d1 - t_1) + m_r * (r2 - d2 - t_2) * (r2 - d2 - t_2) + (m_s * (s1 -
    d1 - t_1) * (s1 - d1 - t_1) + m_s * (s2 - d2 - t_2) * (s2 - d2 - t_2)) + (m_t * (t1 - d1 - t_1)
    * (t1 - d1 - t_1) + m_t * (t2 - d2 - t_2) * (t2 - d2 - t_2)) = m_s * (s1 - t_3) * (s1 - t_3) +
    m_s * (s2 - t_4) * (s2 - t_4) + (m_t * (t1 - t_3) * (t1 - t_3) + m_t * (t2 - t_4) * (t2 - t_4))
    + ((m_s + m_t) * (t_3 - t_5) * (t_3 - t_5) + (m_s + m_t) * (t_4 - t_6) * (t_4 - t_6)) + (m_r *
    (r1 - t_5) * (r1 - t_5) + m_r * (r2 - t_6) * (r2 - t_6)).
Proof.
  intros d1 d2 m_r m_s m_t r1 r2 s1 s2 t1 t2  t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2 D_3.
  rational.
Qed.

(* two points, xx *)
Theorem parts_of_a_body_13 :
  forall m_s m_t s2 s3 t2 t3 : R,
  let t_1 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_2 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  m_s * (s2 - t_1) * (s2 - t_1) + m_s * (s3 - t_2) * (s3 - t_2) + (m_t * (t2 - t_1) * (t2 - t_1) +
    m_t * (t3 - t_2) * (t3 - t_2)) = m_s * m_t / (m_s + m_t) * (s2 - t2) * (s2 - t2) + m_s * m_t /
    (m_s + m_t) * (s3 - t3) * (s3 - t3).
Proof.
  intros m_s m_t s2 s3 t2 t3  t_1 t_2 D_1.
  rational.
Qed.

(* two points, xy *)
Theorem parts_of_a_body_14 :
  forall m_s m_t s1 s2 t1 t2 : R,
  let t_1 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_2 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  - (m_s * (s1 - t_1) * (s2 - t_2)) - m_t * (t1 - t_1) * (t2 - t_2) = - (m_s * m_t / (m_s + m_t) *
    (s1 - t1) * (s2 - t2)).
Proof.
  intros m_s m_t s1 s2 t1 t2  t_1 t_2 D_1.
  rational.
Qed.

(* two points, xz *)
Theorem parts_of_a_body_15 :
  forall m_s m_t s1 s3 t1 t3 : R,
  let t_1 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_2 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  - (m_s * (s1 - t_1) * (s3 - t_2)) - m_t * (t1 - t_1) * (t3 - t_2) = - (m_s * m_t / (m_s + m_t) *
    (s1 - t1) * (s3 - t3)).
Proof.
  intros m_s m_t s1 s3 t1 t3  t_1 t_2 D_1.
  rational.
Qed.

(* two points, yx *)
Theorem parts_of_a_body_16 :
  forall m_s m_t s1 s2 t1 t2 : R,
  let t_1 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_2 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  - (m_s * (s1 - t_1) * (s2 - t_2)) - m_t * (t1 - t_1) * (t2 - t_2) = - (m_s * m_t / (m_s + m_t) *
    (s1 - t1) * (s2 - t2)).
Proof.
  intros m_s m_t s1 s2 t1 t2  t_1 t_2 D_1.
  rational.
Qed.

(* two points, yy *)
Theorem parts_of_a_body_17 :
  forall m_s m_t s1 s3 t1 t3 : R,
  let t_1 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  let t_2 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  m_s * (s3 - t_1) * (s3 - t_1) + m_s * (s1 - t_2) * (s1 - t_2) + (m_t * (t3 - t_1) * (t3 - t_1) +
    m_t * (t1 - t_2) * (t1 - t_2)) = m_s * m_t / (m_s + m_t) * (s3 - t3) * (s3 - t3) + m_s * m_t /
    (m_s + m_t) * (s1 - t1) * (s1 - t1).
Proof.
  intros m_s m_t s1 s3 t1 t3  t_1 t_2 D_1.
  rational.
Qed.

(* two points, yz *)
Theorem parts_of_a_body_18 :
  forall m_s m_t s2 s3 t2 t3 : R,
  let t_1 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_2 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  - (m_s * (s2 - t_1) * (s3 - t_2)) - m_t * (t2 - t_1) * (t3 - t_2) = - (m_s * m_t / (m_s + m_t) *
    (s2 - t2) * (s3 - t3)).
Proof.
  intros m_s m_t s2 s3 t2 t3  t_1 t_2 D_1.
  rational.
Qed.

(* two points, zx *)
Theorem parts_of_a_body_19 :
  forall m_s m_t s1 s3 t1 t3 : R,
  let t_1 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_2 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  - (m_s * (s1 - t_1) * (s3 - t_2)) - m_t * (t1 - t_1) * (t3 - t_2) = - (m_s * m_t / (m_s + m_t) *
    (s1 - t1) * (s3 - t3)).
Proof.
  intros m_s m_t s1 s3 t1 t3  t_1 t_2 D_1.
  rational.
Qed.

(* two points, zy *)
Theorem parts_of_a_body_20 :
  forall m_s m_t s2 s3 t2 t3 : R,
  let t_1 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  let t_2 := (s3 * m_s + t3 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  - (m_s * (s2 - t_1) * (s3 - t_2)) - m_t * (t2 - t_1) * (t3 - t_2) = - (m_s * m_t / (m_s + m_t) *
    (s2 - t2) * (s3 - t3)).
Proof.
  intros m_s m_t s2 s3 t2 t3  t_1 t_2 D_1.
  rational.
Qed.

(* two points, zz *)
Theorem parts_of_a_body_21 :
  forall m_s m_t s1 s2 t1 t2 : R,
  let t_1 := (s1 * m_s + t1 * m_t) / (m_s + m_t) in
  let t_2 := (s2 * m_s + t2 * m_t) / (m_s + m_t) in
  m_s + m_t <> 0 ->
  m_s * (s1 - t_1) * (s1 - t_1) + m_s * (s2 - t_2) * (s2 - t_2) + (m_t * (t1 - t_1) * (t1 - t_1) +
    m_t * (t2 - t_2) * (t2 - t_2)) = m_s * m_t / (m_s + m_t) * (s1 - t1) * (s1 - t1) + m_s * m_t /
    (m_s + m_t) * (s2 - t2) * (s2 - t2).
Proof.
  intros m_s m_t s1 s2 t1 t2  t_1 t_2 D_1.
  rational.
Qed.

(* one part alone, xx *)
Theorem parts_of_a_body_22 :
  forall d2 d3 m r2 r3 : R,
  let t_1 := r2 - d2 - (r2 - d2) * m / m in
  let t_2 := r3 - d3 - (r3 - d3) * m / m in
  m <> 0 ->
  m + (m * t_1 * t_1 + m * t_2 * t_2) = m.
Proof.
  intros d2 d3 m r2 r3  t_1 t_2 D_1.
  rational.
Qed.

(* one part alone, xy *)
Theorem parts_of_a_body_23 :
  forall d1 d2 m r1 r2 : R,
  m <> 0 ->
  - (m * (r1 - d1 - (r1 - d1) * m / m) * (r2 - d2 - (r2 - d2) * m / m)) = 0.
Proof.
  intros d1 d2 m r1 r2   D_1.
  rational.
Qed.

(* one part alone, xz *)
Theorem parts_of_a_body_24 :
  forall d1 d3 m r1 r3 : R,
  m <> 0 ->
  - (m * (r1 - d1 - (r1 - d1) * m / m) * (r3 - d3 - (r3 - d3) * m / m)) = 0.
Proof.
  intros d1 d3 m r1 r3   D_1.
  rational.
Qed.

(* one part alone, yx *)
Theorem parts_of_a_body_25 :
  forall d1 d2 m r1 r2 : R,
  m <> 0 ->
  - (m * (r1 - d1 - (r1 - d1) * m / m) * (r2 - d2 - (r2 - d2) * m / m)) = 0.
Proof.
  intros d1 d2 m r1 r2   D_1.
  rational.
Qed.

(* one part alone, yy *)
Theorem parts_of_a_body_26 :
  forall d1 d3 m r1 r3 : R,
  let t_1 := r3 - d3 - (r3 - d3) * m / m in
  let t_2 := r1 - d1 - (r1 - d1) * m / m in
  m <> 0 ->
  m + (m * t_1 * t_1 + m * t_2 * t_2) = m.
Proof.
  intros d1 d3 m r1 r3  t_1 t_2 D_1.
  rational.
Qed.

(* one part alone, yz *)
Theorem parts_of_a_body_27 :
  forall d2 d3 m r2 r3 : R,
  m <> 0 ->
  - (m * (r2 - d2 - (r2 - d2) * m / m) * (r3 - d3 - (r3 - d3) * m / m)) = 0.
Proof.
  intros d2 d3 m r2 r3   D_1.
  rational.
Qed.

(* one part alone, zx *)
Theorem parts_of_a_body_28 :
  forall d1 d3 m r1 r3 : R,
  m <> 0 ->
  - (m * (r1 - d1 - (r1 - d1) * m / m) * (r3 - d3 - (r3 - d3) * m / m)) = 0.
Proof.
  intros d1 d3 m r1 r3   D_1.
  rational.
Qed.

(* one part alone, zy *)
Theorem parts_of_a_body_29 :
  forall d2 d3 m r2 r3 : R,
  m <> 0 ->
  - (m * (r2 - d2 - (r2 - d2) * m / m) * (r3 - d3 - (r3 - d3) * m / m)) = 0.
Proof.
  intros d2 d3 m r2 r3   D_1.
  rational.
Qed.

(* one part alone, zz *)
Theorem parts_of_a_body_30 :
  forall d1 d2 m r1 r2 : R,
  let t_1 := r1 - d1 - (r1 - d1) * m / m in
  let t_2 := r2 - d2 - (r2 - d2) * m / m in
  m <> 0 ->
  m + (m * t_1 * t_1 + m * t_2 * t_2) = m.
Proof.
  intros d1 d2 m r1 r2  t_1 t_2 D_1.
  rational.
Qed.

(* With the parts' tensors added without their distances. *)

(* two points, xx *)
Theorem parts_of_a_body_mutant_1 :
  exists m_s m_t s2 s3 t2 t3 : R,
  m_s + m_t <> 0 /\
  0 <> m_s * m_t / (m_s + m_t) * (s2 - t2) * (s2 - t2) + m_s * m_t / (m_s + m_t) * (s3 - t3) * (s3 -
    t3).
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  split; [computed | ]. computed.
Qed.


(** turning-back: R I R^T and R I^-1 R^T are inverse to each other for every tensor and every attitude. *)

(* there and back, xx *)
Theorem turning_back_1 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * ((t_5 * (I_xx * I_yy - I_xy * I_xy) + (t_7 *
    (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_5 * (I_xz * I_xy -
    I_yz * I_xx) + (t_7 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz * I_xz - I_zz * I_xy))) * t_2 +
    (t_5 * (I_xy * I_yz - I_yy * I_xz) + (t_7 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy * I_zz -
    I_yz * I_yz))) * t_3)) in
  let t_11 := y * z - w * x + (y * z - w * x) in
  let t_12 := w * w - x * x + y * y - z * z in
  let t_13 := x * y + w * z + (x * y + w * z) in
  let t_14 := (t_4 * t_11 + (t_6 * t_12 + t_8 * t_13)) * ((t_11 * (I_xx * I_yy - I_xy * I_xy) +
    (t_12 * (I_xz * I_xy - I_xx * I_yz) + t_13 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_11 *
    (I_xz * I_xy - I_yz * I_xx) + (t_12 * (I_zz * I_xx - I_xz * I_xz) + t_13 * (I_yz * I_xz - I_zz *
    I_xy))) * t_2 + (t_11 * (I_xy * I_yz - I_yy * I_xz) + (t_12 * (I_yz * I_xz - I_xy * I_zz) + t_13
    * (I_yy * I_zz - I_yz * I_yz))) * t_3)) in
  let t_15 := (t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_1 * (I_xz * I_xy -
    I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_2 +
    (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_3)) in
  t_10 + (t_14 + t_15) = I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) +
    I_xz * (I_xy * I_yz - I_yy * I_xz).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* there and back, xy *)
Theorem turning_back_2 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := y * z - w * x + (y * z - w * x) in
  let t_11 := w * w - x * x + y * y - z * z in
  let t_12 := x * y + w * z + (x * y + w * z) in
  let t_13 := (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * ((t_5 * (I_xx * I_yy - I_xy * I_xy) + (t_7 *
    (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy * I_yz - I_xz * I_yy))) * t_10 + ((t_5 * (I_xz * I_xy
    - I_yz * I_xx) + (t_7 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz * I_xz - I_zz * I_xy))) * t_11
    + (t_5 * (I_xy * I_yz - I_yy * I_xz) + (t_7 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy * I_zz -
    I_yz * I_yz))) * t_12)) in
  let t_14 := (t_4 * t_10 + (t_6 * t_11 + t_8 * t_12)) * ((t_10 * (I_xx * I_yy - I_xy * I_xy) +
    (t_11 * (I_xz * I_xy - I_xx * I_yz) + t_12 * (I_xy * I_yz - I_xz * I_yy))) * t_10 + ((t_10 *
    (I_xz * I_xy - I_yz * I_xx) + (t_11 * (I_zz * I_xx - I_xz * I_xz) + t_12 * (I_yz * I_xz - I_zz *
    I_xy))) * t_11 + (t_10 * (I_xy * I_yz - I_yy * I_xz) + (t_11 * (I_yz * I_xz - I_xy * I_zz) +
    t_12 * (I_yy * I_zz - I_yz * I_yz))) * t_12)) in
  let t_15 := (t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_10 + ((t_1 * (I_xz * I_xy
    - I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_11
    + (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_12)) in
  t_13 + (t_14 + t_15) = 0.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* there and back, xz *)
Theorem turning_back_3 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * ((t_5 * (I_xx * I_yy - I_xy * I_xy) + (t_7 *
    (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy * I_yz - I_xz * I_yy))) * t_5 + ((t_5 * (I_xz * I_xy -
    I_yz * I_xx) + (t_7 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz * I_xz - I_zz * I_xy))) * t_7 +
    (t_5 * (I_xy * I_yz - I_yy * I_xz) + (t_7 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy * I_zz -
    I_yz * I_yz))) * t_9)) in
  let t_11 := y * z - w * x + (y * z - w * x) in
  let t_12 := w * w - x * x + y * y - z * z in
  let t_13 := x * y + w * z + (x * y + w * z) in
  let t_14 := (t_4 * t_11 + (t_6 * t_12 + t_8 * t_13)) * ((t_11 * (I_xx * I_yy - I_xy * I_xy) +
    (t_12 * (I_xz * I_xy - I_xx * I_yz) + t_13 * (I_xy * I_yz - I_xz * I_yy))) * t_5 + ((t_11 *
    (I_xz * I_xy - I_yz * I_xx) + (t_12 * (I_zz * I_xx - I_xz * I_xz) + t_13 * (I_yz * I_xz - I_zz *
    I_xy))) * t_7 + (t_11 * (I_xy * I_yz - I_yy * I_xz) + (t_12 * (I_yz * I_xz - I_xy * I_zz) + t_13
    * (I_yy * I_zz - I_yz * I_yz))) * t_9)) in
  let t_15 := (t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_5 + ((t_1 * (I_xz * I_xy -
    I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_7 +
    (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_9)) in
  t_10 + (t_14 + t_15) = 0.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* there and back, yx *)
Theorem turning_back_4 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x + y * y - z * z in
  let t_3 := x * y + w * z + (x * y + w * z) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := x * z + w * y + (x * z + w * y) in
  let t_11 := x * y - w * z + (x * y - w * z) in
  let t_12 := w * w + x * x - y * y - z * z in
  let t_13 := (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * ((t_5 * (I_xx * I_yy - I_xy * I_xy) + (t_7 *
    (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy * I_yz - I_xz * I_yy))) * t_10 + ((t_5 * (I_xz * I_xy
    - I_yz * I_xx) + (t_7 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz * I_xz - I_zz * I_xy))) * t_11
    + (t_5 * (I_xy * I_yz - I_yy * I_xz) + (t_7 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy * I_zz -
    I_yz * I_yz))) * t_12)) in
  let t_14 := (t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_10 + ((t_1 * (I_xz * I_xy
    - I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_11
    + (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_12)) in
  let t_15 := (t_4 * t_10 + (t_6 * t_11 + t_8 * t_12)) * ((t_10 * (I_xx * I_yy - I_xy * I_xy) +
    (t_11 * (I_xz * I_xy - I_xx * I_yz) + t_12 * (I_xy * I_yz - I_xz * I_yy))) * t_10 + ((t_10 *
    (I_xz * I_xy - I_yz * I_xx) + (t_11 * (I_zz * I_xx - I_xz * I_xz) + t_12 * (I_yz * I_xz - I_zz *
    I_xy))) * t_11 + (t_10 * (I_xy * I_yz - I_yy * I_xz) + (t_11 * (I_yz * I_xz - I_xy * I_zz) +
    t_12 * (I_yy * I_zz - I_yz * I_yz))) * t_12)) in
  t_13 + (t_14 + t_15) = 0.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* there and back, yy *)
Theorem turning_back_5 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x + y * y - z * z in
  let t_3 := x * y + w * z + (x * y + w * z) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * ((t_5 * (I_xx * I_yy - I_xy * I_xy) + (t_7 *
    (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_5 * (I_xz * I_xy -
    I_yz * I_xx) + (t_7 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz * I_xz - I_zz * I_xy))) * t_2 +
    (t_5 * (I_xy * I_yz - I_yy * I_xz) + (t_7 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy * I_zz -
    I_yz * I_yz))) * t_3)) in
  let t_11 := (t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_1 * (I_xz * I_xy -
    I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_2 +
    (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_3)) in
  let t_12 := x * z + w * y + (x * z + w * y) in
  let t_13 := x * y - w * z + (x * y - w * z) in
  let t_14 := w * w + x * x - y * y - z * z in
  let t_15 := (t_4 * t_12 + (t_6 * t_13 + t_8 * t_14)) * ((t_12 * (I_xx * I_yy - I_xy * I_xy) +
    (t_13 * (I_xz * I_xy - I_xx * I_yz) + t_14 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_12 *
    (I_xz * I_xy - I_yz * I_xx) + (t_13 * (I_zz * I_xx - I_xz * I_xz) + t_14 * (I_yz * I_xz - I_zz *
    I_xy))) * t_2 + (t_12 * (I_xy * I_yz - I_yy * I_xz) + (t_13 * (I_yz * I_xz - I_xy * I_zz) + t_14
    * (I_yy * I_zz - I_yz * I_yz))) * t_3)) in
  t_10 + (t_11 + t_15) = I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) +
    I_xz * (I_xy * I_yz - I_yy * I_xz).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* there and back, yz *)
Theorem turning_back_6 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x + y * y - z * z in
  let t_3 := x * y + w * z + (x * y + w * z) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * ((t_5 * (I_xx * I_yy - I_xy * I_xy) + (t_7 *
    (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy * I_yz - I_xz * I_yy))) * t_5 + ((t_5 * (I_xz * I_xy -
    I_yz * I_xx) + (t_7 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz * I_xz - I_zz * I_xy))) * t_7 +
    (t_5 * (I_xy * I_yz - I_yy * I_xz) + (t_7 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy * I_zz -
    I_yz * I_yz))) * t_9)) in
  let t_11 := (t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_5 + ((t_1 * (I_xz * I_xy -
    I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_7 +
    (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_9)) in
  let t_12 := x * z + w * y + (x * z + w * y) in
  let t_13 := x * y - w * z + (x * y - w * z) in
  let t_14 := w * w + x * x - y * y - z * z in
  let t_15 := (t_4 * t_12 + (t_6 * t_13 + t_8 * t_14)) * ((t_12 * (I_xx * I_yy - I_xy * I_xy) +
    (t_13 * (I_xz * I_xy - I_xx * I_yz) + t_14 * (I_xy * I_yz - I_xz * I_yy))) * t_5 + ((t_12 *
    (I_xz * I_xy - I_yz * I_xx) + (t_13 * (I_zz * I_xx - I_xz * I_xz) + t_14 * (I_yz * I_xz - I_zz *
    I_xy))) * t_7 + (t_12 * (I_xy * I_yz - I_yy * I_xz) + (t_13 * (I_yz * I_xz - I_xy * I_zz) + t_14
    * (I_yy * I_zz - I_yz * I_yz))) * t_9)) in
  t_10 + (t_11 + t_15) = 0.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* there and back, zx *)
Theorem turning_back_7 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_6 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_7 := x * z + w * y + (x * z + w * y) in
  let t_8 := x * y - w * z + (x * y - w * z) in
  let t_9 := w * w + x * x - y * y - z * z in
  let t_10 := (t_4 * t_1 + (t_5 * t_2 + t_6 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_7 + ((t_1 * (I_xz * I_xy -
    I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_8 +
    (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_9)) in
  let t_11 := y * z - w * x + (y * z - w * x) in
  let t_12 := w * w - x * x + y * y - z * z in
  let t_13 := x * y + w * z + (x * y + w * z) in
  let t_14 := (t_4 * t_11 + (t_5 * t_12 + t_6 * t_13)) * ((t_11 * (I_xx * I_yy - I_xy * I_xy) +
    (t_12 * (I_xz * I_xy - I_xx * I_yz) + t_13 * (I_xy * I_yz - I_xz * I_yy))) * t_7 + ((t_11 *
    (I_xz * I_xy - I_yz * I_xx) + (t_12 * (I_zz * I_xx - I_xz * I_xz) + t_13 * (I_yz * I_xz - I_zz *
    I_xy))) * t_8 + (t_11 * (I_xy * I_yz - I_yy * I_xz) + (t_12 * (I_yz * I_xz - I_xy * I_zz) + t_13
    * (I_yy * I_zz - I_yz * I_yz))) * t_9)) in
  let t_15 := (t_4 * t_7 + (t_5 * t_8 + t_6 * t_9)) * ((t_7 * (I_xx * I_yy - I_xy * I_xy) + (t_8 *
    (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy * I_yz - I_xz * I_yy))) * t_7 + ((t_7 * (I_xz * I_xy -
    I_yz * I_xx) + (t_8 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz * I_xz - I_zz * I_xy))) * t_8 +
    (t_7 * (I_xy * I_yz - I_yy * I_xz) + (t_8 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy * I_zz -
    I_yz * I_yz))) * t_9)) in
  t_10 + (t_14 + t_15) = 0.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* there and back, zy *)
Theorem turning_back_8 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_6 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := w * w - x * x + y * y - z * z in
  let t_9 := x * y + w * z + (x * y + w * z) in
  let t_10 := (t_4 * t_1 + (t_5 * t_2 + t_6 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_7 + ((t_1 * (I_xz * I_xy -
    I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_8 +
    (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_9)) in
  let t_11 := (t_4 * t_7 + (t_5 * t_8 + t_6 * t_9)) * ((t_7 * (I_xx * I_yy - I_xy * I_xy) + (t_8 *
    (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy * I_yz - I_xz * I_yy))) * t_7 + ((t_7 * (I_xz * I_xy -
    I_yz * I_xx) + (t_8 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz * I_xz - I_zz * I_xy))) * t_8 +
    (t_7 * (I_xy * I_yz - I_yy * I_xz) + (t_8 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy * I_zz -
    I_yz * I_yz))) * t_9)) in
  let t_12 := x * z + w * y + (x * z + w * y) in
  let t_13 := x * y - w * z + (x * y - w * z) in
  let t_14 := w * w + x * x - y * y - z * z in
  let t_15 := (t_4 * t_12 + (t_5 * t_13 + t_6 * t_14)) * ((t_12 * (I_xx * I_yy - I_xy * I_xy) +
    (t_13 * (I_xz * I_xy - I_xx * I_yz) + t_14 * (I_xy * I_yz - I_xz * I_yy))) * t_7 + ((t_12 *
    (I_xz * I_xy - I_yz * I_xx) + (t_13 * (I_zz * I_xx - I_xz * I_xz) + t_14 * (I_yz * I_xz - I_zz *
    I_xy))) * t_8 + (t_12 * (I_xy * I_yz - I_yy * I_xz) + (t_13 * (I_yz * I_xz - I_xy * I_zz) + t_14
    * (I_yy * I_zz - I_yz * I_yz))) * t_9)) in
  t_10 + (t_11 + t_15) = 0.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* there and back, zz *)
Theorem turning_back_9 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_6 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_7 := (t_4 * t_1 + (t_5 * t_2 + t_6 * t_3)) * ((t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_1 * (I_xz * I_xy -
    I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_2 +
    (t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz -
    I_yz * I_yz))) * t_3)) in
  let t_8 := y * z - w * x + (y * z - w * x) in
  let t_9 := w * w - x * x + y * y - z * z in
  let t_10 := x * y + w * z + (x * y + w * z) in
  let t_11 := (t_4 * t_8 + (t_5 * t_9 + t_6 * t_10)) * ((t_8 * (I_xx * I_yy - I_xy * I_xy) + (t_9 *
    (I_xz * I_xy - I_xx * I_yz) + t_10 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_8 * (I_xz * I_xy
    - I_yz * I_xx) + (t_9 * (I_zz * I_xx - I_xz * I_xz) + t_10 * (I_yz * I_xz - I_zz * I_xy))) * t_2
    + (t_8 * (I_xy * I_yz - I_yy * I_xz) + (t_9 * (I_yz * I_xz - I_xy * I_zz) + t_10 * (I_yy * I_zz
    - I_yz * I_yz))) * t_3)) in
  let t_12 := x * z + w * y + (x * z + w * y) in
  let t_13 := x * y - w * z + (x * y - w * z) in
  let t_14 := w * w + x * x - y * y - z * z in
  let t_15 := (t_4 * t_12 + (t_5 * t_13 + t_6 * t_14)) * ((t_12 * (I_xx * I_yy - I_xy * I_xy) +
    (t_13 * (I_xz * I_xy - I_xx * I_yz) + t_14 * (I_xy * I_yz - I_xz * I_yy))) * t_1 + ((t_12 *
    (I_xz * I_xy - I_yz * I_xx) + (t_13 * (I_zz * I_xx - I_xz * I_xz) + t_14 * (I_yz * I_xz - I_zz *
    I_xy))) * t_2 + (t_12 * (I_xy * I_yz - I_yy * I_xz) + (t_13 * (I_yz * I_xz - I_xy * I_zz) + t_14
    * (I_yy * I_zz - I_yz * I_yz))) * t_3)) in
  t_7 + (t_11 + t_15) = I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) +
    I_xz * (I_xy * I_yz - I_yy * I_xz).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* With R^T J R in place of R J R^T. *)

(* there and back, xx *)
Theorem turning_back_mutant_1 :
  exists I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := y * z - w * x + (y * z - w * x) in
  let t_11 := x * y + w * z + (x * y + w * z) in
  let t_12 := (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * ((t_5 * (I_xx * I_yy - I_xy * I_xy) + (t_10 *
    (I_xz * I_xy - I_xx * I_yz) + t_1 * (I_xy * I_yz - I_xz * I_yy))) * t_9 + ((t_5 * (I_xz * I_xy -
    I_yz * I_xx) + (t_10 * (I_zz * I_xx - I_xz * I_xz) + t_1 * (I_yz * I_xz - I_zz * I_xy))) * t_11
    + (t_5 * (I_xy * I_yz - I_yy * I_xz) + (t_10 * (I_yz * I_xz - I_xy * I_zz) + t_1 * (I_yy * I_zz
    - I_yz * I_yz))) * t_3)) in
  let t_13 := w * w - x * x + y * y - z * z in
  let t_14 := (t_4 * t_10 + (t_6 * t_13 + t_8 * t_11)) * ((t_7 * (I_xx * I_yy - I_xy * I_xy) + (t_13
    * (I_xz * I_xy - I_xx * I_yz) + t_2 * (I_xy * I_yz - I_xz * I_yy))) * t_9 + ((t_7 * (I_xz * I_xy
    - I_yz * I_xx) + (t_13 * (I_zz * I_xx - I_xz * I_xz) + t_2 * (I_yz * I_xz - I_zz * I_xy))) *
    t_11 + (t_7 * (I_xy * I_yz - I_yy * I_xz) + (t_13 * (I_yz * I_xz - I_xy * I_zz) + t_2 * (I_yy *
    I_zz - I_yz * I_yz))) * t_3)) in
  let t_15 := (t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * ((t_9 * (I_xx * I_yy - I_xy * I_xy) + (t_11 *
    (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy * I_yz - I_xz * I_yy))) * t_9 + ((t_9 * (I_xz * I_xy -
    I_yz * I_xx) + (t_11 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz * I_xz - I_zz * I_xy))) * t_11
    + (t_9 * (I_xy * I_yz - I_yy * I_xz) + (t_11 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy * I_zz
    - I_yz * I_yz))) * t_3)) in
  t_12 + (t_14 + t_15) <> I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) +
    I_xz * (I_xy * I_yz - I_yy * I_xz).
Proof.
  exists (-1 / 5), 1, 1, 1, (6 / 5), (2 / 5), (-1 / 5), (4 / 5), (2 / 5), (2 / 5).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (12 / 25) computed.
  intros t_2; cut_to t_2 (4 / 5) computed.
  intros t_3; cut_to t_3 (9 / 25) computed.
  intros t_4; cut_to t_4 (189 / 125) computed.
  intros t_5; cut_to t_5 (-3 / 5) computed.
  intros t_6; cut_to t_6 (217 / 125) computed.
  intros t_7; cut_to t_7 0 computed.
  intros t_8; cut_to t_8 (151 / 125) computed.
  intros t_9; cut_to t_9 (4 / 5) computed.
  intros t_10; cut_to t_10 (16 / 25) computed.
  intros t_11; cut_to t_11 (12 / 25) computed.
  intros t_12; cut_to t_12 (430421 / 9765625) computed.
  intros t_13; cut_to t_13 (-3 / 5) computed.
  intros t_14; cut_to t_14 (-1587324 / 9765625) computed.
  intros t_15; cut_to t_15 (23948802 / 48828125) computed.
  computed.
Qed.


(** moments-survive-turning: Turned, a tensor has the same moments about the turned axes: (R I R^T) R v = R (I v) for every v; and its trace, its second invariant and its determinant are the same, so what was possible stays possible. *)

(* the tensor along R v, x *)
Theorem moments_survive_turning_1 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := y * z - w * x + (y * z - w * x) in
  let t_11 := w * w - x * x + y * y - z * z in
  let t_12 := x * y + w * z + (x * y + w * z) in
  (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * (t_5 * v3 + (t_7 * v2 + t_9 * v1)) + ((t_4 * t_10 + (t_6 *
    t_11 + t_8 * t_12)) * (t_10 * v3 + (t_11 * v2 + t_12 * v1)) + (t_4 * t_1 + (t_6 * t_2 + t_8 *
    t_3)) * (t_1 * v3 + (t_2 * v2 + t_3 * v1))) = t_1 * (I_zz * v3 + (I_yz * v2 + I_xz * v1)) + (t_2
    * (I_yz * v3 + (I_yy * v2 + I_xy * v1)) + t_3 * (I_xz * v3 + (I_xy * v2 + I_xx * v1))).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 .
  rational.
Qed.

(* the tensor along R v, y *)
Theorem moments_survive_turning_2 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x + y * y - z * z in
  let t_3 := x * y + w * z + (x * y + w * z) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := x * z + w * y + (x * z + w * y) in
  let t_11 := x * y - w * z + (x * y - w * z) in
  let t_12 := w * w + x * x - y * y - z * z in
  (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * (t_5 * v3 + (t_7 * v2 + t_9 * v1)) + ((t_4 * t_1 + (t_6 *
    t_2 + t_8 * t_3)) * (t_1 * v3 + (t_2 * v2 + t_3 * v1)) + (t_4 * t_10 + (t_6 * t_11 + t_8 *
    t_12)) * (t_10 * v3 + (t_11 * v2 + t_12 * v1))) = t_1 * (I_zz * v3 + (I_yz * v2 + I_xz * v1)) +
    (t_2 * (I_yz * v3 + (I_yy * v2 + I_xy * v1)) + t_3 * (I_xz * v3 + (I_xy * v2 + I_xx * v1))).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 .
  rational.
Qed.

(* the tensor along R v, z *)
Theorem moments_survive_turning_3 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_6 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := w * w - x * x + y * y - z * z in
  let t_9 := x * y + w * z + (x * y + w * z) in
  let t_10 := x * z + w * y + (x * z + w * y) in
  let t_11 := x * y - w * z + (x * y - w * z) in
  let t_12 := w * w + x * x - y * y - z * z in
  (t_4 * t_1 + (t_5 * t_2 + t_6 * t_3)) * (t_1 * v3 + (t_2 * v2 + t_3 * v1)) + ((t_4 * t_7 + (t_5 *
    t_8 + t_6 * t_9)) * (t_7 * v3 + (t_8 * v2 + t_9 * v1)) + (t_4 * t_10 + (t_5 * t_11 + t_6 *
    t_12)) * (t_10 * v3 + (t_11 * v2 + t_12 * v1))) = t_1 * (I_zz * v3 + (I_yz * v2 + I_xz * v1)) +
    (t_2 * (I_yz * v3 + (I_yy * v2 + I_xy * v1)) + t_3 * (I_xz * v3 + (I_xy * v2 + I_xx * v1))).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 .
  rational.
Qed.

(* the trace *)
Theorem moments_survive_turning_4 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := y * z - w * x + (y * z - w * x) in
  let t_5 := w * w - x * x + y * y - z * z in
  let t_6 := x * y + w * z + (x * y + w * z) in
  let t_7 := w * w - x * x - y * y + z * z in
  let t_8 := y * z + w * x + (y * z + w * x) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := (t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz)) * t_1 + ((t_1 * I_yz + (t_2 * I_yy + t_3 *
    I_xy)) * t_2 + (t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx)) * t_3) + ((t_4 * I_zz + (t_5 * I_yz +
    t_6 * I_xz)) * t_4 + ((t_4 * I_yz + (t_5 * I_yy + t_6 * I_xy)) * t_5 + (t_4 * I_xz + (t_5 * I_xy
    + t_6 * I_xx)) * t_6)) + ((t_7 * I_zz + (t_8 * I_yz + t_9 * I_xz)) * t_7 + ((t_7 * I_yz + (t_8 *
    I_yy + t_9 * I_xy)) * t_8 + (t_7 * I_xz + (t_8 * I_xy + t_9 * I_xx)) * t_9)) in
  t_10 = I_xx + I_yy + I_zz.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 .
  rational.
Qed.

(* the second invariant *)
Theorem moments_survive_turning_5 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x + y * y - z * z in
  let t_3 := x * y + w * z + (x * y + w * z) in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_6 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_7 := t_4 * t_1 + (t_5 * t_2 + t_6 * t_3) in
  let t_8 := w * w - x * x - y * y + z * z in
  let t_9 := y * z + w * x + (y * z + w * x) in
  let t_10 := x * z - w * y + (x * z - w * y) in
  let t_11 := t_8 * I_zz + (t_9 * I_yz + t_10 * I_xz) in
  let t_12 := t_8 * I_yz + (t_9 * I_yy + t_10 * I_xy) in
  let t_13 := t_8 * I_xz + (t_9 * I_xy + t_10 * I_xx) in
  let t_14 := t_11 * t_8 + (t_12 * t_9 + t_13 * t_10) in
  let t_15 := x * z + w * y + (x * z + w * y) in
  let t_16 := x * y - w * z + (x * y - w * z) in
  let t_17 := w * w + x * x - y * y - z * z in
  let t_18 := t_15 * I_zz + (t_16 * I_yz + t_17 * I_xz) in
  let t_19 := t_15 * I_yz + (t_16 * I_yy + t_17 * I_xy) in
  let t_20 := t_15 * I_xz + (t_16 * I_xy + t_17 * I_xx) in
  let t_21 := t_18 * t_15 + (t_19 * t_16 + t_20 * t_17) in
  t_7 * t_14 - (t_4 * t_8 + (t_5 * t_9 + t_6 * t_10)) * (t_11 * t_1 + (t_12 * t_2 + t_13 * t_3)) +
    (t_14 * t_21 - (t_11 * t_15 + (t_12 * t_16 + t_13 * t_17)) * (t_18 * t_8 + (t_19 * t_9 + t_20 *
    t_10))) + (t_21 * t_7 - (t_18 * t_1 + (t_19 * t_2 + t_20 * t_3)) * (t_4 * t_15 + (t_5 * t_16 +
    t_6 * t_17))) = I_yy * I_zz - I_yz * I_yz + (I_zz * I_xx - I_xz * I_xz) + (I_xx * I_yy - I_xy *
    I_xy).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 .
  rational.
Qed.

(* the determinant *)
Theorem moments_survive_turning_6 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_6 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := w * w - x * x + y * y - z * z in
  let t_9 := x * y + w * z + (x * y + w * z) in
  let t_10 := t_7 * I_zz + (t_8 * I_yz + t_9 * I_xz) in
  let t_11 := t_7 * I_yz + (t_8 * I_yy + t_9 * I_xy) in
  let t_12 := t_7 * I_xz + (t_8 * I_xy + t_9 * I_xx) in
  let t_13 := t_10 * t_7 + (t_11 * t_8 + t_12 * t_9) in
  let t_14 := w * w - x * x - y * y + z * z in
  let t_15 := y * z + w * x + (y * z + w * x) in
  let t_16 := x * z - w * y + (x * z - w * y) in
  let t_17 := t_14 * I_zz + (t_15 * I_yz + t_16 * I_xz) in
  let t_18 := t_14 * I_yz + (t_15 * I_yy + t_16 * I_xy) in
  let t_19 := t_14 * I_xz + (t_15 * I_xy + t_16 * I_xx) in
  let t_20 := t_17 * t_14 + (t_18 * t_15 + t_19 * t_16) in
  let t_21 := t_10 * t_14 + (t_11 * t_15 + t_12 * t_16) in
  let t_22 := t_17 * t_7 + (t_18 * t_8 + t_19 * t_9) in
  let t_23 := t_17 * t_1 + (t_18 * t_2 + t_19 * t_3) in
  let t_24 := t_10 * t_1 + (t_11 * t_2 + t_12 * t_3) in
  (t_4 * t_1 + (t_5 * t_2 + t_6 * t_3)) * (t_13 * t_20 - t_21 * t_22) + (t_4 * t_7 + (t_5 * t_8 +
    t_6 * t_9)) * (t_21 * t_23 - t_24 * t_20) + (t_4 * t_14 + (t_5 * t_15 + t_6 * t_16)) * (t_24 *
    t_22 - t_13 * t_23) = I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) +
    I_xz * (I_xy * I_yz - I_yy * I_xz).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 .
  rational.
Qed.

(* With one R left out. *)

(* the tensor along R v, x *)
Theorem moments_survive_turning_mutant_1 :
  exists I_xx I_xy I_xz I_yy I_yz I_zz v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := (t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz)) * ((w * w - x * x - y * y + z * z) * v3 + ((y
    * z + w * x + (y * z + w * x)) * v2 + (x * z - w * y + (x * z - w * y)) * v1)) + ((t_1 * I_yz +
    (t_2 * I_yy + t_3 * I_xy)) * ((y * z - w * x + (y * z - w * x)) * v3 + ((w * w - x * x + y * y -
    z * z) * v2 + (x * y + w * z + (x * y + w * z)) * v1)) + (t_1 * I_xz + (t_2 * I_xy + t_3 *
    I_xx)) * (t_1 * v3 + (t_2 * v2 + t_3 * v1))) in
  t_4 <> t_1 * (I_zz * v3 + (I_yz * v2 + I_xz * v1)) + (t_2 * (I_yz * v3 + (I_yy * v2 + I_xy * v1))
    + t_3 * (I_xz * v3 + (I_xy * v2 + I_xx * v1))).
Proof.
  exists (-4 / 9), (2 / 9), (2 / 9), (-2 / 9), (2 / 9), (2 / 3), (5 / 9), (-5 / 9), (-1 / 9), (-8 /
    9), (2 / 9), (1 / 3), (-2 / 9).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (-56 / 81) computed.
  intros t_2; cut_to t_2 (-20 / 81) computed.
  intros t_3; cut_to t_3 (55 / 81) computed.
  intros t_4; cut_to t_4 (-262172 / 531441) computed.
  computed.
Qed.

(* With R^T I R in place of R I R^T. *)

(* the tensor along R v, x *)
Theorem moments_survive_turning_mutant_2 :
  exists I_xx I_xy I_xz I_yy I_yz I_zz v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  let t_1 := x * z - w * y + (x * z - w * y) in
  let t_2 := x * y + w * z + (x * y + w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * I_zz + (t_2 * I_yz + t_3 * I_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * I_yz + (t_2 * I_yy + t_3 * I_xy) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := t_1 * I_xz + (t_2 * I_xy + t_3 * I_xx) in
  let t_9 := x * z + w * y + (x * z + w * y) in
  let t_10 := y * z + w * x + (y * z + w * x) in
  let t_11 := w * w - x * x + y * y - z * z in
  let t_12 := x * y - w * z + (x * y - w * z) in
  (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * (t_5 * v3 + (t_10 * v2 + t_1 * v1)) + ((t_4 * t_10 + (t_6
    * t_11 + t_8 * t_12)) * (t_7 * v3 + (t_11 * v2 + t_2 * v1)) + (t_4 * t_1 + (t_6 * t_2 + t_8 *
    t_3)) * (t_9 * v3 + (t_12 * v2 + t_3 * v1))) <> t_9 * (I_zz * v3 + (I_yz * v2 + I_xz * v1)) +
    (t_12 * (I_yz * v3 + (I_yy * v2 + I_xy * v1)) + t_3 * (I_xz * v3 + (I_xy * v2 + I_xx * v1))).
Proof.
  exists (-4 / 9), (2 / 9), (2 / 9), (-2 / 9), (2 / 9), (2 / 3), (5 / 9), (-5 / 9), (-1 / 9), (-8 /
    9), (2 / 9), (1 / 3), (-2 / 9).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (40 / 81) computed.
  intros t_2; cut_to t_2 (44 / 81) computed.
  intros t_3; cut_to t_3 (55 / 81) computed.
  intros t_4; cut_to t_4 (146 / 243) computed.
  intros t_5; cut_to t_5 (55 / 81) computed.
  intros t_6; cut_to t_6 (34 / 243) computed.
  intros t_7; cut_to t_7 (20 / 81) computed.
  intros t_8; cut_to t_8 (-52 / 729) computed.
  intros t_9; cut_to t_9 (-56 / 81) computed.
  intros t_10; cut_to t_10 (-44 / 81) computed.
  intros t_11; cut_to t_11 (65 / 81) computed.
  intros t_12; cut_to t_12 (-20 / 81) computed.
  computed.
Qed.


(** spin-from-momentum: w = R J R^T L is: take L into the body, apply J, carry the spin out; and it gives L back. *)

(* w, x *)
Theorem spin_from_momentum_1 :
  forall J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z : R,
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * J_zz + (t_2 * J_yz + t_3 * J_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * J_yz + (t_2 * J_yy + t_3 * J_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * J_xz + (t_2 * J_xy + t_3 * J_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := y * z - w * x + (y * z - w * x) in
  let t_11 := w * w - x * x + y * y - z * z in
  let t_12 := x * y + w * z + (x * y + w * z) in
  let t_13 := t_5 * L3 + (t_10 * L2 + t_1 * L1) in
  let t_14 := t_7 * L3 + (t_11 * L2 + t_2 * L1) in
  let t_15 := t_9 * L3 + (t_12 * L2 + t_3 * L1) in
  (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * L3 + ((t_4 * t_10 + (t_6 * t_11 + t_8 * t_12)) * L2 + (t_4
    * t_1 + (t_6 * t_2 + t_8 * t_3)) * L1) = t_1 * (J_zz * t_13 + (J_yz * t_14 + J_xz * t_15)) +
    (t_2 * (J_yz * t_13 + (J_yy * t_14 + J_xy * t_15)) + t_3 * (J_xz * t_13 + (J_xy * t_14 + J_xx *
    t_15))).
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* w, y *)
Theorem spin_from_momentum_2 :
  forall J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z : R,
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x + y * y - z * z in
  let t_3 := x * y + w * z + (x * y + w * z) in
  let t_4 := t_1 * J_zz + (t_2 * J_yz + t_3 * J_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * J_yz + (t_2 * J_yy + t_3 * J_xy) in
  let t_7 := y * z + w * x + (y * z + w * x) in
  let t_8 := t_1 * J_xz + (t_2 * J_xy + t_3 * J_xx) in
  let t_9 := x * z - w * y + (x * z - w * y) in
  let t_10 := x * z + w * y + (x * z + w * y) in
  let t_11 := x * y - w * z + (x * y - w * z) in
  let t_12 := w * w + x * x - y * y - z * z in
  let t_13 := t_5 * L3 + (t_1 * L2 + t_10 * L1) in
  let t_14 := t_7 * L3 + (t_2 * L2 + t_11 * L1) in
  let t_15 := t_9 * L3 + (t_3 * L2 + t_12 * L1) in
  (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * L3 + ((t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * L2 + (t_4 *
    t_10 + (t_6 * t_11 + t_8 * t_12)) * L1) = t_1 * (J_zz * t_13 + (J_yz * t_14 + J_xz * t_15)) +
    (t_2 * (J_yz * t_13 + (J_yy * t_14 + J_xy * t_15)) + t_3 * (J_xz * t_13 + (J_xy * t_14 + J_xx *
    t_15))).
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* w, z *)
Theorem spin_from_momentum_3 :
  forall J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z : R,
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := t_1 * J_zz + (t_2 * J_yz + t_3 * J_xz) in
  let t_5 := t_1 * J_yz + (t_2 * J_yy + t_3 * J_xy) in
  let t_6 := t_1 * J_xz + (t_2 * J_xy + t_3 * J_xx) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := w * w - x * x + y * y - z * z in
  let t_9 := x * y + w * z + (x * y + w * z) in
  let t_10 := x * z + w * y + (x * z + w * y) in
  let t_11 := x * y - w * z + (x * y - w * z) in
  let t_12 := w * w + x * x - y * y - z * z in
  let t_13 := t_1 * L3 + (t_7 * L2 + t_10 * L1) in
  let t_14 := t_2 * L3 + (t_8 * L2 + t_11 * L1) in
  let t_15 := t_3 * L3 + (t_9 * L2 + t_12 * L1) in
  (t_4 * t_1 + (t_5 * t_2 + t_6 * t_3)) * L3 + ((t_4 * t_7 + (t_5 * t_8 + t_6 * t_9)) * L2 + (t_4 *
    t_10 + (t_5 * t_11 + t_6 * t_12)) * L1) = t_1 * (J_zz * t_13 + (J_yz * t_14 + J_xz * t_15)) +
    (t_2 * (J_yz * t_13 + (J_yy * t_14 + J_xy * t_15)) + t_3 * (J_xz * t_13 + (J_xy * t_14 + J_xx *
    t_15))).
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 t_13 t_14 t_15 .
  rational.
Qed.

(* L = R I R^T w, x *)
Theorem spin_from_momentum_4 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz L1 L2 L3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := w * w - x * x - y * y + z * z in
  let t_3 := y * z + w * x + (y * z + w * x) in
  let t_4 := x * z - w * y + (x * z - w * y) in
  let t_5 := t_2 * (I_xx * I_yy - I_xy * I_xy) + (t_3 * (I_xz * I_xy - I_xx * I_yz) + t_4 * (I_xy *
    I_yz - I_xz * I_yy)) in
  let t_6 := t_2 * (I_xz * I_xy - I_yz * I_xx) + (t_3 * (I_zz * I_xx - I_xz * I_xz) + t_4 * (I_yz *
    I_xz - I_zz * I_xy)) in
  let t_7 := t_2 * (I_xy * I_yz - I_yy * I_xz) + (t_3 * (I_yz * I_xz - I_xy * I_zz) + t_4 * (I_yy *
    I_zz - I_yz * I_yz)) in
  let t_8 := y * z - w * x + (y * z - w * x) in
  let t_9 := w * w - x * x + y * y - z * z in
  let t_10 := x * y + w * z + (x * y + w * z) in
  let t_11 := x * y - w * z + (x * y - w * z) in
  let t_12 := w * w + x * x - y * y - z * z in
  let t_13 := (t_5 * t_2 + (t_6 * t_3 + t_7 * t_4)) * L3 + ((t_5 * t_8 + (t_6 * t_9 + t_7 * t_10)) *
    L2 + (t_5 * t_1 + (t_6 * t_11 + t_7 * t_12)) * L1) in
  let t_14 := t_8 * (I_xx * I_yy - I_xy * I_xy) + (t_9 * (I_xz * I_xy - I_xx * I_yz) + t_10 * (I_xy
    * I_yz - I_xz * I_yy)) in
  let t_15 := t_8 * (I_xz * I_xy - I_yz * I_xx) + (t_9 * (I_zz * I_xx - I_xz * I_xz) + t_10 * (I_yz
    * I_xz - I_zz * I_xy)) in
  let t_16 := t_8 * (I_xy * I_yz - I_yy * I_xz) + (t_9 * (I_yz * I_xz - I_xy * I_zz) + t_10 * (I_yy
    * I_zz - I_yz * I_yz)) in
  let t_17 := (t_14 * t_2 + (t_15 * t_3 + t_16 * t_4)) * L3 + ((t_14 * t_8 + (t_15 * t_9 + t_16 *
    t_10)) * L2 + (t_14 * t_1 + (t_15 * t_11 + t_16 * t_12)) * L1) in
  let t_18 := t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_11 * (I_xz * I_xy - I_xx * I_yz) + t_12 * (I_xy
    * I_yz - I_xz * I_yy)) in
  let t_19 := t_1 * (I_xz * I_xy - I_yz * I_xx) + (t_11 * (I_zz * I_xx - I_xz * I_xz) + t_12 * (I_yz
    * I_xz - I_zz * I_xy)) in
  let t_20 := t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_11 * (I_yz * I_xz - I_xy * I_zz) + t_12 * (I_yy
    * I_zz - I_yz * I_yz)) in
  let t_21 := (t_18 * t_2 + (t_19 * t_3 + t_20 * t_4)) * L3 + ((t_18 * t_8 + (t_19 * t_9 + t_20 *
    t_10)) * L2 + (t_18 * t_1 + (t_19 * t_11 + t_20 * t_12)) * L1) in
  let t_22 := t_2 * t_13 + (t_8 * t_17 + t_1 * t_21) in
  let t_23 := t_3 * t_13 + (t_9 * t_17 + t_11 * t_21) in
  let t_24 := t_4 * t_13 + (t_10 * t_17 + t_12 * t_21) in
  t_1 * (I_zz * t_22 + (I_yz * t_23 + I_xz * t_24)) + (t_11 * (I_yz * t_22 + (I_yy * t_23 + I_xy *
    t_24)) + t_12 * (I_xz * t_22 + (I_xy * t_23 + I_xx * t_24))) = L1 * (I_xx * (I_yy * I_zz - I_yz
    * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) + I_xz * (I_xy * I_yz - I_yy * I_xz)).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz L1 L2 L3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 .
  rational.
Qed.

(* L = R I R^T w, y *)
Theorem spin_from_momentum_5 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz L1 L2 L3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x - y * y + z * z in
  let t_3 := y * z + w * x + (y * z + w * x) in
  let t_4 := x * z - w * y + (x * z - w * y) in
  let t_5 := t_2 * (I_xx * I_yy - I_xy * I_xy) + (t_3 * (I_xz * I_xy - I_xx * I_yz) + t_4 * (I_xy *
    I_yz - I_xz * I_yy)) in
  let t_6 := t_2 * (I_xz * I_xy - I_yz * I_xx) + (t_3 * (I_zz * I_xx - I_xz * I_xz) + t_4 * (I_yz *
    I_xz - I_zz * I_xy)) in
  let t_7 := t_2 * (I_xy * I_yz - I_yy * I_xz) + (t_3 * (I_yz * I_xz - I_xy * I_zz) + t_4 * (I_yy *
    I_zz - I_yz * I_yz)) in
  let t_8 := w * w - x * x + y * y - z * z in
  let t_9 := x * y + w * z + (x * y + w * z) in
  let t_10 := x * z + w * y + (x * z + w * y) in
  let t_11 := x * y - w * z + (x * y - w * z) in
  let t_12 := w * w + x * x - y * y - z * z in
  let t_13 := (t_5 * t_2 + (t_6 * t_3 + t_7 * t_4)) * L3 + ((t_5 * t_1 + (t_6 * t_8 + t_7 * t_9)) *
    L2 + (t_5 * t_10 + (t_6 * t_11 + t_7 * t_12)) * L1) in
  let t_14 := t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_8 * (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy *
    I_yz - I_xz * I_yy)) in
  let t_15 := t_1 * (I_xz * I_xy - I_yz * I_xx) + (t_8 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz *
    I_xz - I_zz * I_xy)) in
  let t_16 := t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_8 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy *
    I_zz - I_yz * I_yz)) in
  let t_17 := (t_14 * t_2 + (t_15 * t_3 + t_16 * t_4)) * L3 + ((t_14 * t_1 + (t_15 * t_8 + t_16 *
    t_9)) * L2 + (t_14 * t_10 + (t_15 * t_11 + t_16 * t_12)) * L1) in
  let t_18 := t_10 * (I_xx * I_yy - I_xy * I_xy) + (t_11 * (I_xz * I_xy - I_xx * I_yz) + t_12 *
    (I_xy * I_yz - I_xz * I_yy)) in
  let t_19 := t_10 * (I_xz * I_xy - I_yz * I_xx) + (t_11 * (I_zz * I_xx - I_xz * I_xz) + t_12 *
    (I_yz * I_xz - I_zz * I_xy)) in
  let t_20 := t_10 * (I_xy * I_yz - I_yy * I_xz) + (t_11 * (I_yz * I_xz - I_xy * I_zz) + t_12 *
    (I_yy * I_zz - I_yz * I_yz)) in
  let t_21 := (t_18 * t_2 + (t_19 * t_3 + t_20 * t_4)) * L3 + ((t_18 * t_1 + (t_19 * t_8 + t_20 *
    t_9)) * L2 + (t_18 * t_10 + (t_19 * t_11 + t_20 * t_12)) * L1) in
  let t_22 := t_2 * t_13 + (t_1 * t_17 + t_10 * t_21) in
  let t_23 := t_3 * t_13 + (t_8 * t_17 + t_11 * t_21) in
  let t_24 := t_4 * t_13 + (t_9 * t_17 + t_12 * t_21) in
  t_1 * (I_zz * t_22 + (I_yz * t_23 + I_xz * t_24)) + (t_8 * (I_yz * t_22 + (I_yy * t_23 + I_xy *
    t_24)) + t_9 * (I_xz * t_22 + (I_xy * t_23 + I_xx * t_24))) = L2 * (I_xx * (I_yy * I_zz - I_yz *
    I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) + I_xz * (I_xy * I_yz - I_yy * I_xz)).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz L1 L2 L3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 .
  rational.
Qed.

(* L = R I R^T w, z *)
Theorem spin_from_momentum_6 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz L1 L2 L3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := t_1 * (I_xx * I_yy - I_xy * I_xy) + (t_2 * (I_xz * I_xy - I_xx * I_yz) + t_3 * (I_xy *
    I_yz - I_xz * I_yy)) in
  let t_5 := t_1 * (I_xz * I_xy - I_yz * I_xx) + (t_2 * (I_zz * I_xx - I_xz * I_xz) + t_3 * (I_yz *
    I_xz - I_zz * I_xy)) in
  let t_6 := t_1 * (I_xy * I_yz - I_yy * I_xz) + (t_2 * (I_yz * I_xz - I_xy * I_zz) + t_3 * (I_yy *
    I_zz - I_yz * I_yz)) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := w * w - x * x + y * y - z * z in
  let t_9 := x * y + w * z + (x * y + w * z) in
  let t_10 := x * z + w * y + (x * z + w * y) in
  let t_11 := x * y - w * z + (x * y - w * z) in
  let t_12 := w * w + x * x - y * y - z * z in
  let t_13 := (t_4 * t_1 + (t_5 * t_2 + t_6 * t_3)) * L3 + ((t_4 * t_7 + (t_5 * t_8 + t_6 * t_9)) *
    L2 + (t_4 * t_10 + (t_5 * t_11 + t_6 * t_12)) * L1) in
  let t_14 := t_7 * (I_xx * I_yy - I_xy * I_xy) + (t_8 * (I_xz * I_xy - I_xx * I_yz) + t_9 * (I_xy *
    I_yz - I_xz * I_yy)) in
  let t_15 := t_7 * (I_xz * I_xy - I_yz * I_xx) + (t_8 * (I_zz * I_xx - I_xz * I_xz) + t_9 * (I_yz *
    I_xz - I_zz * I_xy)) in
  let t_16 := t_7 * (I_xy * I_yz - I_yy * I_xz) + (t_8 * (I_yz * I_xz - I_xy * I_zz) + t_9 * (I_yy *
    I_zz - I_yz * I_yz)) in
  let t_17 := (t_14 * t_1 + (t_15 * t_2 + t_16 * t_3)) * L3 + ((t_14 * t_7 + (t_15 * t_8 + t_16 *
    t_9)) * L2 + (t_14 * t_10 + (t_15 * t_11 + t_16 * t_12)) * L1) in
  let t_18 := t_10 * (I_xx * I_yy - I_xy * I_xy) + (t_11 * (I_xz * I_xy - I_xx * I_yz) + t_12 *
    (I_xy * I_yz - I_xz * I_yy)) in
  let t_19 := t_10 * (I_xz * I_xy - I_yz * I_xx) + (t_11 * (I_zz * I_xx - I_xz * I_xz) + t_12 *
    (I_yz * I_xz - I_zz * I_xy)) in
  let t_20 := t_10 * (I_xy * I_yz - I_yy * I_xz) + (t_11 * (I_yz * I_xz - I_xy * I_zz) + t_12 *
    (I_yy * I_zz - I_yz * I_yz)) in
  let t_21 := (t_18 * t_1 + (t_19 * t_2 + t_20 * t_3)) * L3 + ((t_18 * t_7 + (t_19 * t_8 + t_20 *
    t_9)) * L2 + (t_18 * t_10 + (t_19 * t_11 + t_20 * t_12)) * L1) in
  let t_22 := t_1 * t_13 + (t_7 * t_17 + t_10 * t_21) in
  let t_23 := t_2 * t_13 + (t_8 * t_17 + t_11 * t_21) in
  let t_24 := t_3 * t_13 + (t_9 * t_17 + t_12 * t_21) in
  t_1 * (I_zz * t_22 + (I_yz * t_23 + I_xz * t_24)) + (t_2 * (I_yz * t_22 + (I_yy * t_23 + I_xy *
    t_24)) + t_3 * (I_xz * t_22 + (I_xy * t_23 + I_xx * t_24))) = L3 * (I_xx * (I_yy * I_zz - I_yz *
    I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) + I_xz * (I_xy * I_yz - I_yy * I_xz)).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz L1 L2 L3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 .
  rational.
Qed.

(* With R and R^T swapped. *)

(* w, x *)
Theorem spin_from_momentum_mutant_1 :
  exists J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z : R,
  let t_1 := x * z - w * y + (x * z - w * y) in
  let t_2 := x * y + w * z + (x * y + w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := t_1 * J_zz + (t_2 * J_yz + t_3 * J_xz) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := t_1 * J_yz + (t_2 * J_yy + t_3 * J_xy) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := t_1 * J_xz + (t_2 * J_xy + t_3 * J_xx) in
  let t_9 := x * z + w * y + (x * z + w * y) in
  let t_10 := y * z + w * x + (y * z + w * x) in
  let t_11 := w * w - x * x + y * y - z * z in
  let t_12 := x * y - w * z + (x * y - w * z) in
  let t_13 := t_5 * L3 + (t_7 * L2 + t_9 * L1) in
  let t_14 := t_10 * L3 + (t_11 * L2 + t_12 * L1) in
  let t_15 := t_1 * L3 + (t_2 * L2 + t_3 * L1) in
  (t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * L3 + ((t_4 * t_10 + (t_6 * t_11 + t_8 * t_12)) * L2 + (t_4
    * t_1 + (t_6 * t_2 + t_8 * t_3)) * L1) <> t_9 * (J_zz * t_13 + (J_yz * t_14 + J_xz * t_15)) +
    (t_12 * (J_yz * t_13 + (J_yy * t_14 + J_xy * t_15)) + t_3 * (J_xz * t_13 + (J_xy * t_14 + J_xx *
    t_15))).
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6, (-2).
  intros t_1; cut_to t_1 (-68) computed.
  intros t_2; cut_to t_2 4 computed.
  intros t_3; cut_to t_3 (-11) computed.
  intros t_4; cut_to t_4 (-211) computed.
  intros t_5; cut_to t_5 (-11) computed.
  intros t_6; cut_to t_6 (-483) computed.
  intros t_7; cut_to t_7 (-44) computed.
  intros t_8; cut_to t_8 142 computed.
  intros t_9; cut_to t_9 52 computed.
  intros t_10; cut_to t_10 (-4) computed.
  intros t_11; cut_to t_11 53 computed.
  intros t_12; cut_to t_12 44 computed.
  intros t_13; cut_to t_13 2 computed.
  intros t_14; cut_to t_14 283 computed.
  intros t_15; cut_to t_15 (-157) computed.
  computed.
Qed.

(* With J not turned. *)

(* w, x *)
Theorem spin_from_momentum_mutant_2 :
  exists J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z : R,
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := (w * w - x * x - y * y + z * z) * L3 + ((y * z - w * x + (y * z - w * x)) * L2 + t_1 *
    L1) in
  let t_3 := x * y - w * z + (x * y - w * z) in
  let t_4 := (y * z + w * x + (y * z + w * x)) * L3 + ((w * w - x * x + y * y - z * z) * L2 + t_3 *
    L1) in
  let t_5 := w * w + x * x - y * y - z * z in
  let t_6 := (x * z - w * y + (x * z - w * y)) * L3 + ((x * y + w * z + (x * y + w * z)) * L2 + t_5
    * L1) in
  J_xz * L3 + (J_xy * L2 + J_xx * L1) <> t_1 * (J_zz * t_2 + (J_yz * t_4 + J_xz * t_6)) + (t_3 *
    (J_yz * t_2 + (J_yy * t_4 + J_xy * t_6)) + t_5 * (J_xz * t_2 + (J_xy * t_4 + J_xx * t_6))).
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6, (-2).
  intros t_1; cut_to t_1 52 computed.
  intros t_2; cut_to t_2 2 computed.
  intros t_3; cut_to t_3 44 computed.
  intros t_4; cut_to t_4 283 computed.
  intros t_5; cut_to t_5 (-11) computed.
  intros t_6; cut_to t_6 (-157) computed.
  computed.
Qed.


(** gap-of-a-box: For every box spun equally about x and y the tangent of the gap is (a² - b²)/(a² + b² + 2 c²), whatever it weighs; for edges 2, 1, 3 that is 3/23. *)

(* the tangent *)
Theorem gap_of_a_box_1 :
  forall a b c m : R,
  let t_1 := (b * b + c * c) * (m / 12) in
  let t_2 := (c * c + a * a) * (m / 12) in
  t_1 + t_2 <> 0 ->
  a ^ 2 + b ^ 2 + 2 * c ^ 2 <> 0 ->
  (- (t_1 - t_2)) / (t_1 + t_2) = (a ^ 2 - b ^ 2) / (a ^ 2 + b ^ 2 + 2 * c ^ 2).
Proof.
  intros a b c m  t_1 t_2 D_1 D_2.
  rational.
Qed.

(* With edges a and b swapped. *)

(* the tangent *)
Theorem gap_of_a_box_mutant_1 :
  exists a b c m : R,
  let t_1 := (a * a + c * c) * (m / 12) in
  let t_2 := (c * c + b * b) * (m / 12) in
  t_1 + t_2 <> 0 /\
  a ^ 2 + b ^ 2 + 2 * c ^ 2 <> 0 /\
  (- (t_1 - t_2)) / (t_1 + t_2) <> (a ^ 2 - b ^ 2) / (a ^ 2 + b ^ 2 + 2 * c ^ 2).
Proof.
  exists 6, 1, (-3), (625 / 1521).
  intros t_1; cut_to t_1 (3125 / 2028) computed.
  intros t_2; cut_to t_2 (3125 / 9126) computed.
  split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With edges b and c swapped. *)

(* the tangent *)
Theorem gap_of_a_box_mutant_2 :
  exists a b c m : R,
  let t_1 := (c * c + b * b) * (m / 12) in
  let t_2 := (b * b + a * a) * (m / 12) in
  t_1 + t_2 <> 0 /\
  a ^ 2 + b ^ 2 + 2 * c ^ 2 <> 0 /\
  (- (t_1 - t_2)) / (t_1 + t_2) <> (a ^ 2 - b ^ 2) / (a ^ 2 + b ^ 2 + 2 * c ^ 2).
Proof.
  exists 6, 1, (-3), (625 / 1521).
  intros t_1; cut_to t_1 (3125 / 9126) computed.
  intros t_2; cut_to t_2 (23125 / 18252) computed.
  split; [computed | ]. split; [computed | ]. computed.
Qed.


(** gap-is-zero-on-principal-axes-alone: |L x w|² is a sum of squares, one for each pair of axes, each with a positive factor if the moments differ: it vanishes only where two of the three components of the spin do. *)

(* the factor of a pair *)
Theorem gap_is_zero_on_principal_axes_alone_1 :
  forall I1 a : R,
  0 < I1 ->
  0 < a ->
  (I1 - (I1 + a)) ^ 2 > 0.
Proof.
  intros I1 a H_1 H_2  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (a ^ 2) (1)); [positive | positive | rational].
Qed.

(* the factor of a pair *)
Theorem gap_is_zero_on_principal_axes_alone_2 :
  forall I1 a b : R,
  0 < I1 ->
  0 < a ->
  0 < b ->
  (I1 + a - (I1 + a + b)) ^ 2 > 0.
Proof.
  intros I1 a b H_1 H_2 H_3  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (b ^ 2) (1)); [positive | positive | rational].
Qed.

(* the factor of a pair *)
Theorem gap_is_zero_on_principal_axes_alone_3 :
  forall I1 a b : R,
  0 < I1 ->
  0 < a ->
  0 < b ->
  (I1 + a + b - I1) ^ 2 > 0.
Proof.
  intros I1 a b H_1 H_2 H_3  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (a ^ 2 + 2 * a * b + b ^ 2) (1)); [positive | positive | rational].
Qed.

(* |L x w|² *)
Theorem gap_is_zero_on_principal_axes_alone_4 :
  forall I1 a b omega1 omega2 omega3 : R,
  let t_1 := (I1 + a - (I1 + a + b)) * (omega2 * omega3) in
  let t_2 := (I1 + a + b - I1) * (omega3 * omega1) in
  let t_3 := (I1 - (I1 + a)) * (omega1 * omega2) in
  t_1 * t_1 + t_2 * t_2 + t_3 * t_3 = (I1 - (I1 + a)) ^ 2 * omega1 ^ 2 * omega2 ^ 2 + (I1 + a - (I1
    + a + b)) ^ 2 * omega2 ^ 2 * omega3 ^ 2 + (I1 + a + b - I1) ^ 2 * omega3 ^ 2 * omega1 ^ 2.
Proof.
  intros I1 a b omega1 omega2 omega3  t_1 t_2 t_3 .
  rational.
Qed.

(* With one pair left out. *)

(* |L x w|² *)
Theorem gap_is_zero_on_principal_axes_alone_mutant_1 :
  exists I1 a b omega1 omega2 omega3 : R,
  let t_1 := (I1 + a - (I1 + a + b)) * (omega2 * omega3) in
  let t_2 := (I1 - (I1 + a)) * (omega1 * omega2) in
  t_1 * t_1 + t_2 * t_2 <> (I1 - (I1 + a)) ^ 2 * omega1 ^ 2 * omega2 ^ 2 + (I1 + a - (I1 + a + b)) ^
    2 * omega2 ^ 2 * omega3 ^ 2 + (I1 + a + b - I1) ^ 2 * omega3 ^ 2 * omega1 ^ 2.
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  intros t_1; cut_to t_1 84 computed.
  intros t_2; cut_to t_2 (-7) computed.
  computed.
Qed.

(* With moments in no order, whose differences may vanish. *)

(* the factor of a pair *)
Theorem gap_is_zero_on_principal_axes_alone_mutant_2 :
  exists I1 I2 : R,
  0 < I1 /\
  0 < I2 /\
  (I1 - I2) ^ 2 <= 0.
Proof.
  exists (3 / 5), (3 / 5).
  split; [computed | ]. split; [computed | ]. 
  computed.
Qed.


(** momentum-leans-to-the-heavier-axis: For all moments, L is turned from w towards the axis with the larger moment: L_j / L_i - w_j / w_i is positive if I_j exceeds I_i and the components are positive. *)

(* the lean *)
Theorem momentum_leans_to_the_heavier_axis_1 :
  forall I1 a omega1 omega2 : R,
  0 < I1 ->
  0 < a ->
  0 < omega1 ->
  0 < omega2 ->
  (I1 + a) * omega2 / (I1 * omega1) - omega2 / omega1 > 0.
Proof.
  intros I1 a omega1 omega2 H_1 H_2 H_3 H_4  .
  unnamed.
  assert (I1 <> 0) by (apply Rgt_not_eq; positive).
  assert (omega1 <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 * omega1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (a * omega2) (I1 * omega1)); [positive | positive | rational].
Qed.

(* the lean *)
Theorem momentum_leans_to_the_heavier_axis_2 :
  forall I1 a b omega2 omega3 : R,
  0 < I1 ->
  0 < a ->
  0 < b ->
  0 < omega2 ->
  0 < omega3 ->
  (I1 + a + b) * omega3 / ((I1 + a) * omega2) - omega3 / omega2 > 0.
Proof.
  intros I1 a b omega2 omega3 H_1 H_2 H_3 H_4 H_5  .
  unnamed.
  assert (I1 + a <> 0) by (apply Rgt_not_eq; positive).
  assert (omega2 <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 * omega2 + a * omega2 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (b * omega3) (I1 * omega2 + a * omega2)); [positive | positive | rational].
Qed.

(* the lean *)
Theorem momentum_leans_to_the_heavier_axis_3 :
  forall I1 a b omega1 omega3 : R,
  0 < I1 ->
  0 < a ->
  0 < b ->
  0 < omega1 ->
  0 < omega3 ->
  (I1 + a + b) * omega3 / (I1 * omega1) - omega3 / omega1 > 0.
Proof.
  intros I1 a b omega1 omega3 H_1 H_2 H_3 H_4 H_5  .
  unnamed.
  assert (I1 <> 0) by (apply Rgt_not_eq; positive).
  assert (omega1 <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 * omega1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (a * omega3 + b * omega3) (I1 * omega1)); [positive | positive | rational].
Qed.

(* With towards the lighter axis. *)

(* the lean *)
Theorem momentum_leans_to_the_heavier_axis_mutant_1 :
  exists I1 a omega1 omega2 : R,
  0 < I1 /\
  0 < a /\
  0 < omega1 /\
  0 < omega2 /\
  - ((I1 + a) * omega2 / (I1 * omega1) - omega2 / omega1) <= 0.
Proof.
  exists 6, 1, 3, 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. 
  computed.
Qed.


(** gap-is-never-a-right-angle: w.L is positive for every spin but none: the angle between them stays below a right angle. *)

(* w.L *)
Theorem gap_is_never_a_right_angle_1 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  0 < I1 ->
  0 < I2 ->
  0 < I3 ->
  0 < omega1 ->
  0 < omega2 ->
  0 < omega3 ->
  omega1 * (I1 * omega1) + omega2 * (I2 * omega2) + omega3 * (I3 * omega3) > 0.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3 H_1 H_2 H_3 H_4 H_5 H_6  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (I1 * omega1 ^ 2 + I2 * omega2 ^ 2 + I3 * omega3 ^ 2) (1)); [positive |
    positive | rational].
Qed.

(* With one moment with a minus. *)

(* w.L *)
Theorem gap_is_never_a_right_angle_mutant_1 :
  exists I1 I2 I3 omega1 omega2 omega3 : R,
  0 < I1 /\
  0 < I2 /\
  0 < I3 /\
  0 < omega1 /\
  0 < omega2 /\
  0 < omega3 /\
  omega1 * (I1 * omega1) + omega2 * ((- I2) * omega2) + omega3 * (I3 * omega3) <= 0.
Proof.
  exists 1, 2, 3, 1, (5 / 2), (1 / 2).
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. 
  computed.
Qed.


(** largest-gap: Between two axes with moments I and J the gap is largest where the spin's slope squared is I / J; its tangent squared is then (J - I)² / (4 I J), and everywhere else less, by a square. *)

(* the square's divisor *)
Theorem largest_gap_1 :
  forall I J t : R,
  0 < I ->
  0 < J ->
  0 < t ->
  4 * I * J * (I + J * t ^ 2) ^ 2 > 0.
Proof.
  intros I J t H_1 H_2 H_3  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (4 * I * J ^ 3 * t ^ 4 + 8 * I ^ 2 * J ^ 2 * t ^ 2 + 4 * I ^ 3 * J) (1));
    [positive | positive | rational].
Qed.

(* the tangent squared *)
Theorem largest_gap_2 :
  forall I J t : R,
  I + t * (J * t) <> 0 ->
  I <> 0 ->
  J <> 0 ->
  I + J * t ^ 2 <> 0 ->
  ((I - J) * t / (I + t * (J * t))) ^ 2 = (J - I) ^ 2 / (4 * I * J) - (J - I) ^ 2 * (J * t ^ 2 - I)
    ^ 2 / (4 * I * J * (I + J * t ^ 2) ^ 2).
Proof.
  intros I J t   D_1 D_2 D_3 D_4.
  rational.
Qed.

(* With 4 becomes 2. *)

(* the tangent squared *)
Theorem largest_gap_mutant_1 :
  exists I J t : R,
  I + t * (J * t) <> 0 /\
  I <> 0 /\
  J <> 0 /\
  I + J * t ^ 2 <> 0 /\
  ((I - J) * t / (I + t * (J * t))) ^ 2 <> (J - I) ^ 2 / (2 * I * J) - (J - I) ^ 2 * (J * t ^ 2 - I)
    ^ 2 / (4 * I * J * (I + J * t ^ 2) ^ 2).
Proof.
  exists 6, 1, (-3).
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.
