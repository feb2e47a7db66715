(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.


(** attitudes-are-rotations: The matrix of every unit quaternion is a rotation: R R^T = 1, and its determinant is 1, so it mirrors nothing. *)

(* R R^T = 1, xx *)
Theorem attitudes_are_rotations_1 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  t_1 * t_1 + (t_2 * t_2 + t_3 * t_3) = 1.
Proof.
  intros w x y z H_1 t_1 t_2 t_3 .
  rational.
Qed.

(* R R^T = 1, xy *)
Theorem attitudes_are_rotations_2 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (x * z + w * y + (x * z + w * y)) * (y * z - w * x + (y * z - w * x)) + ((x * y - w * z + (x * y -
    w * z)) * (w * w - x * x + y * y - z * z) + (w * w + x * x - y * y - z * z) * (x * y + w * z +
    (x * y + w * z))) = 0.
Proof.
  intros w x y z H_1  .
  rational.
Qed.

(* R R^T = 1, xz *)
Theorem attitudes_are_rotations_3 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (x * z + w * y + (x * z + w * y)) * (w * w - x * x - y * y + z * z) + ((x * y - w * z + (x * y - w
    * z)) * (y * z + w * x + (y * z + w * x)) + (w * w + x * x - y * y - z * z) * (x * z - w * y +
    (x * z - w * y))) = 0.
Proof.
  intros w x y z H_1  .
  rational.
Qed.

(* R R^T = 1, yx *)
Theorem attitudes_are_rotations_4 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (y * z - w * x + (y * z - w * x)) * (x * z + w * y + (x * z + w * y)) + ((w * w - x * x + y * y -
    z * z) * (x * y - w * z + (x * y - w * z)) + (x * y + w * z + (x * y + w * z)) * (w * w + x * x
    - y * y - z * z)) = 0.
Proof.
  intros w x y z H_1  .
  rational.
Qed.

(* R R^T = 1, yy *)
Theorem attitudes_are_rotations_5 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x + y * y - z * z in
  let t_3 := x * y + w * z + (x * y + w * z) in
  t_1 * t_1 + (t_2 * t_2 + t_3 * t_3) = 1.
Proof.
  intros w x y z H_1 t_1 t_2 t_3 .
  rational.
Qed.

(* R R^T = 1, yz *)
Theorem attitudes_are_rotations_6 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (y * z - w * x + (y * z - w * x)) * (w * w - x * x - y * y + z * z) + ((w * w - x * x + y * y - z
    * z) * (y * z + w * x + (y * z + w * x)) + (x * y + w * z + (x * y + w * z)) * (x * z - w * y +
    (x * z - w * y))) = 0.
Proof.
  intros w x y z H_1  .
  rational.
Qed.

(* R R^T = 1, zx *)
Theorem attitudes_are_rotations_7 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (w * w - x * x - y * y + z * z) * (x * z + w * y + (x * z + w * y)) + ((y * z + w * x + (y * z + w
    * x)) * (x * y - w * z + (x * y - w * z)) + (x * z - w * y + (x * z - w * y)) * (w * w + x * x -
    y * y - z * z)) = 0.
Proof.
  intros w x y z H_1  .
  rational.
Qed.

(* R R^T = 1, zy *)
Theorem attitudes_are_rotations_8 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (w * w - x * x - y * y + z * z) * (y * z - w * x + (y * z - w * x)) + ((y * z + w * x + (y * z + w
    * x)) * (w * w - x * x + y * y - z * z) + (x * z - w * y + (x * z - w * y)) * (x * y + w * z +
    (x * y + w * z))) = 0.
Proof.
  intros w x y z H_1  .
  rational.
Qed.

(* R R^T = 1, zz *)
Theorem attitudes_are_rotations_9 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  t_1 * t_1 + (t_2 * t_2 + t_3 * t_3) = 1.
Proof.
  intros w x y z H_1 t_1 t_2 t_3 .
  rational.
Qed.

(* the determinant of R *)
Theorem attitudes_are_rotations_10 :
  forall w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x + y * y - z * z in
  let t_2 := w * w - x * x - y * y + z * z in
  let t_3 := y * z - w * x + (y * z - w * x) in
  let t_4 := y * z + w * x + (y * z + w * x) in
  let t_5 := x * z - w * y + (x * z - w * y) in
  let t_6 := x * y + w * z + (x * y + w * z) in
  (w * w + x * x - y * y - z * z) * (t_1 * t_2 - t_3 * t_4) + (x * y - w * z + (x * y - w * z)) *
    (t_3 * t_5 - t_6 * t_2) + (x * z + w * y + (x * z + w * y)) * (t_6 * t_4 - t_1 * t_5) = 1.
Proof.
  intros w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 .
  rational.
Qed.

(* With one entry's sign changed. *)

(* R R^T = 1, xy *)
Theorem attitudes_are_rotations_mutant_1 :
  exists w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  (x * z + w * y + (x * z + w * y)) * (y * z - w * x + (y * z - w * x)) + ((- (x * y - w * z + (x *
    y - w * z))) * (w * w - x * x + y * y - z * z) + (w * w + x * x - y * y - z * z) * (x * y + w *
    z + (x * y + w * z))) <> 0.
Proof.
  exists (1 / 6), (5 / 6), (1 / 2), (1 / 6).
  split; [computed | ]. 
  computed.
Qed.

(* With mirrored. *)

(* the determinant of R *)
Theorem attitudes_are_rotations_mutant_2 :
  exists w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  let t_1 := - (w * w - x * x + y * y - z * z) in
  let t_2 := - (w * w - x * x - y * y + z * z) in
  let t_3 := - (y * z - w * x + (y * z - w * x)) in
  let t_4 := - (y * z + w * x + (y * z + w * x)) in
  let t_5 := - (x * z - w * y + (x * z - w * y)) in
  let t_6 := - (x * y + w * z + (x * y + w * z)) in
  (- (w * w + x * x - y * y - z * z)) * (t_1 * t_2 - t_3 * t_4) + (- (x * y - w * z + (x * y - w *
    z))) * (t_3 * t_5 - t_6 * t_2) + (- (x * z + w * y + (x * z + w * y))) * (t_6 * t_4 - t_1 * t_5)
    <> 1.
Proof.
  exists (1 / 6), (5 / 6), (1 / 2), (1 / 6).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (4 / 9) computed.
  intros t_2; cut_to t_2 (8 / 9) computed.
  intros t_3; cut_to t_3 (1 / 9) computed.
  intros t_4; cut_to t_4 (-4 / 9) computed.
  intros t_5; cut_to t_5 (-1 / 9) computed.
  intros t_6; cut_to t_6 (-8 / 9) computed.
  computed.
Qed.


(** attitudes-multiply-as-rotations: The matrix of a product of quaternions is the product of their matrices, in the same order. *)

(* R(p q), xx *)
Theorem attitudes_multiply_as_rotations_1 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := w2 * w - x2 * x - y2 * y - z2 * z in
  let t_2 := w2 * x + x2 * w + y2 * z - z2 * y in
  let t_3 := w2 * y - x2 * z + y2 * w + z2 * x in
  let t_4 := w2 * z + x2 * y - y2 * x + z2 * w in
  t_1 * t_1 + t_2 * t_2 - t_3 * t_3 - t_4 * t_4 = (x2 * z2 + w2 * y2 + (x2 * z2 + w2 * y2)) * (x * z
    - w * y + (x * z - w * y)) + ((x2 * y2 - w2 * z2 + (x2 * y2 - w2 * z2)) * (x * y + w * z + (x *
    y + w * z)) + (w2 * w2 + x2 * x2 - y2 * y2 - z2 * z2) * (w * w + x * x - y * y - z * z)).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 t_2 t_3 t_4 .
  rational.
Qed.

(* R(p q), xy *)
Theorem attitudes_multiply_as_rotations_2 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := (w2 * x + x2 * w + y2 * z - z2 * y) * (w2 * y - x2 * z + y2 * w + z2 * x) - (w2 * w -
    x2 * x - y2 * y - z2 * z) * (w2 * z + x2 * y - y2 * x + z2 * w) in
  t_1 + t_1 = (x2 * z2 + w2 * y2 + (x2 * z2 + w2 * y2)) * (y * z + w * x + (y * z + w * x)) + ((x2 *
    y2 - w2 * z2 + (x2 * y2 - w2 * z2)) * (w * w - x * x + y * y - z * z) + (w2 * w2 + x2 * x2 - y2
    * y2 - z2 * z2) * (x * y - w * z + (x * y - w * z))).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 .
  rational.
Qed.

(* R(p q), xz *)
Theorem attitudes_multiply_as_rotations_3 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := (w2 * x + x2 * w + y2 * z - z2 * y) * (w2 * z + x2 * y - y2 * x + z2 * w) + (w2 * w -
    x2 * x - y2 * y - z2 * z) * (w2 * y - x2 * z + y2 * w + z2 * x) in
  t_1 + t_1 = (x2 * z2 + w2 * y2 + (x2 * z2 + w2 * y2)) * (w * w - x * x - y * y + z * z) + ((x2 *
    y2 - w2 * z2 + (x2 * y2 - w2 * z2)) * (y * z - w * x + (y * z - w * x)) + (w2 * w2 + x2 * x2 -
    y2 * y2 - z2 * z2) * (x * z + w * y + (x * z + w * y))).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 .
  rational.
Qed.

(* R(p q), yx *)
Theorem attitudes_multiply_as_rotations_4 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := (w2 * x + x2 * w + y2 * z - z2 * y) * (w2 * y - x2 * z + y2 * w + z2 * x) + (w2 * w -
    x2 * x - y2 * y - z2 * z) * (w2 * z + x2 * y - y2 * x + z2 * w) in
  t_1 + t_1 = (y2 * z2 - w2 * x2 + (y2 * z2 - w2 * x2)) * (x * z - w * y + (x * z - w * y)) + ((w2 *
    w2 - x2 * x2 + y2 * y2 - z2 * z2) * (x * y + w * z + (x * y + w * z)) + (x2 * y2 + w2 * z2 + (x2
    * y2 + w2 * z2)) * (w * w + x * x - y * y - z * z)).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 .
  rational.
Qed.

(* R(p q), yy *)
Theorem attitudes_multiply_as_rotations_5 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := w2 * w - x2 * x - y2 * y - z2 * z in
  let t_2 := w2 * x + x2 * w + y2 * z - z2 * y in
  let t_3 := w2 * y - x2 * z + y2 * w + z2 * x in
  let t_4 := w2 * z + x2 * y - y2 * x + z2 * w in
  t_1 * t_1 - t_2 * t_2 + t_3 * t_3 - t_4 * t_4 = (y2 * z2 - w2 * x2 + (y2 * z2 - w2 * x2)) * (y * z
    + w * x + (y * z + w * x)) + ((w2 * w2 - x2 * x2 + y2 * y2 - z2 * z2) * (w * w - x * x + y * y -
    z * z) + (x2 * y2 + w2 * z2 + (x2 * y2 + w2 * z2)) * (x * y - w * z + (x * y - w * z))).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 t_2 t_3 t_4 .
  rational.
Qed.

(* R(p q), yz *)
Theorem attitudes_multiply_as_rotations_6 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := (w2 * y - x2 * z + y2 * w + z2 * x) * (w2 * z + x2 * y - y2 * x + z2 * w) - (w2 * w -
    x2 * x - y2 * y - z2 * z) * (w2 * x + x2 * w + y2 * z - z2 * y) in
  t_1 + t_1 = (y2 * z2 - w2 * x2 + (y2 * z2 - w2 * x2)) * (w * w - x * x - y * y + z * z) + ((w2 *
    w2 - x2 * x2 + y2 * y2 - z2 * z2) * (y * z - w * x + (y * z - w * x)) + (x2 * y2 + w2 * z2 + (x2
    * y2 + w2 * z2)) * (x * z + w * y + (x * z + w * y))).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 .
  rational.
Qed.

(* R(p q), zx *)
Theorem attitudes_multiply_as_rotations_7 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := (w2 * x + x2 * w + y2 * z - z2 * y) * (w2 * z + x2 * y - y2 * x + z2 * w) - (w2 * w -
    x2 * x - y2 * y - z2 * z) * (w2 * y - x2 * z + y2 * w + z2 * x) in
  t_1 + t_1 = (w2 * w2 - x2 * x2 - y2 * y2 + z2 * z2) * (x * z - w * y + (x * z - w * y)) + ((y2 *
    z2 + w2 * x2 + (y2 * z2 + w2 * x2)) * (x * y + w * z + (x * y + w * z)) + (x2 * z2 - w2 * y2 +
    (x2 * z2 - w2 * y2)) * (w * w + x * x - y * y - z * z)).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 .
  rational.
Qed.

(* R(p q), zy *)
Theorem attitudes_multiply_as_rotations_8 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := (w2 * y - x2 * z + y2 * w + z2 * x) * (w2 * z + x2 * y - y2 * x + z2 * w) + (w2 * w -
    x2 * x - y2 * y - z2 * z) * (w2 * x + x2 * w + y2 * z - z2 * y) in
  t_1 + t_1 = (w2 * w2 - x2 * x2 - y2 * y2 + z2 * z2) * (y * z + w * x + (y * z + w * x)) + ((y2 *
    z2 + w2 * x2 + (y2 * z2 + w2 * x2)) * (w * w - x * x + y * y - z * z) + (x2 * z2 - w2 * y2 + (x2
    * z2 - w2 * y2)) * (x * y - w * z + (x * y - w * z))).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 .
  rational.
Qed.

(* R(p q), zz *)
Theorem attitudes_multiply_as_rotations_9 :
  forall w w2 x x2 y y2 z z2 : R,
  let t_1 := w2 * w - x2 * x - y2 * y - z2 * z in
  let t_2 := w2 * x + x2 * w + y2 * z - z2 * y in
  let t_3 := w2 * y - x2 * z + y2 * w + z2 * x in
  let t_4 := w2 * z + x2 * y - y2 * x + z2 * w in
  t_1 * t_1 - t_2 * t_2 - t_3 * t_3 + t_4 * t_4 = (w2 * w2 - x2 * x2 - y2 * y2 + z2 * z2) * (w * w -
    x * x - y * y + z * z) + ((y2 * z2 + w2 * x2 + (y2 * z2 + w2 * x2)) * (y * z - w * x + (y * z -
    w * x)) + (x2 * z2 - w2 * y2 + (x2 * z2 - w2 * y2)) * (x * z + w * y + (x * z + w * y))).
Proof.
  intros w w2 x x2 y y2 z z2  t_1 t_2 t_3 t_4 .
  rational.
Qed.

(* With the factors swapped. *)

(* R(p q), xx *)
Theorem attitudes_multiply_as_rotations_mutant_1 :
  exists w w2 x x2 y y2 z z2 : R,
  let t_1 := w * w2 - x * x2 - y * y2 - z * z2 in
  let t_2 := w * x2 + x * w2 + y * z2 - z * y2 in
  let t_3 := w * y2 - x * z2 + y * w2 + z * x2 in
  let t_4 := w * z2 + x * y2 - y * x2 + z * w2 in
  t_1 * t_1 + t_2 * t_2 - t_3 * t_3 - t_4 * t_4 <> (x2 * z2 + w2 * y2 + (x2 * z2 + w2 * y2)) * (x *
    z - w * y + (x * z - w * y)) + ((x2 * y2 - w2 * z2 + (x2 * y2 - w2 * z2)) * (x * y + w * z + (x
    * y + w * z)) + (w2 * w2 + x2 * x2 - y2 * y2 - z2 * z2) * (w * w + x * x - y * y - z * z)).
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3.
  intros t_1; cut_to t_1 (-28) computed.
  intros t_2; cut_to t_2 12 computed.
  intros t_3; cut_to t_3 43 computed.
  intros t_4; cut_to t_4 2 computed.
  computed.
Qed.


(** attitude-rate: q' = q (0, w) / 2 turns the body at the spin w: R' = R [w], and the length of q stays. *)

(* R', xx *)
Theorem attitude_rate_1 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (w + w) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (x + x) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + (- (y + y)) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (- (z + z)) *
    ((w * omega3 + x * omega2 - y * omega1) / 2) = (x * z + w * y + (x * z + w * y)) * (- omega2) +
    (x * y - w * z + (x * y - w * z)) * omega3.
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* R', xy *)
Theorem attitude_rate_2 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (- z - z) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (y + y) * ((w * omega1 + y * omega3
    - z * omega2) / 2) + (x + x) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (- w - w) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) = (x * z + w * y + (x * z + w * y)) * omega1 + (w * w + x
    * x - y * y - z * z) * (- omega3).
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* R', xz *)
Theorem attitude_rate_3 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (y + y) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (z + z) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + (w + w) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (x + x) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) = (x * y - w * z + (x * y - w * z)) * (- omega1) + (w * w
    + x * x - y * y - z * z) * omega2.
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* R', yx *)
Theorem attitude_rate_4 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (z + z) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (y + y) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + (x + x) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (w + w) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) = (y * z - w * x + (y * z - w * x)) * (- omega2) + (w * w
    - x * x + y * y - z * z) * omega3.
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* R', yy *)
Theorem attitude_rate_5 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (w + w) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (- (x + x)) * ((w * omega1 + y *
    omega3 - z * omega2) / 2) + (y + y) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (- (z + z))
    * ((w * omega3 + x * omega2 - y * omega1) / 2) = (y * z - w * x + (y * z - w * x)) * omega1 + (x
    * y + w * z + (x * y + w * z)) * (- omega3).
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* R', yz *)
Theorem attitude_rate_6 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (- x - x) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (- w - w) * ((w * omega1 + y *
    omega3 - z * omega2) / 2) + (z + z) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (y + y) *
    ((w * omega3 + x * omega2 - y * omega1) / 2) = (w * w - x * x + y * y - z * z) * (- omega1) + (x
    * y + w * z + (x * y + w * z)) * omega2.
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* R', zx *)
Theorem attitude_rate_7 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (- y - y) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (z + z) * ((w * omega1 + y * omega3
    - z * omega2) / 2) + (- w - w) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (x + x) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) = (w * w - x * x - y * y + z * z) * (- omega2) + (y * z +
    w * x + (y * z + w * x)) * omega3.
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* R', zy *)
Theorem attitude_rate_8 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (x + x) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (w + w) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + (z + z) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (y + y) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) = (w * w - x * x - y * y + z * z) * omega1 + (x * z - w *
    y + (x * z - w * y)) * (- omega3).
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* R', zz *)
Theorem attitude_rate_9 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (w + w) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (- (x + x)) * ((w * omega1 + y *
    omega3 - z * omega2) / 2) + (- (y + y)) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (z + z)
    * ((w * omega3 + x * omega2 - y * omega1) / 2) = (y * z + w * x + (y * z + w * x)) * (- omega1)
    + (x * z - w * y + (x * z - w * y)) * omega2.
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* the rate of |q|² *)
Theorem attitude_rate_10 :
  forall omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  (w + w) * ((- (x * omega1) - y * omega2 - z * omega3) / 2) + (x + x) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + (y + y) * ((w * omega2 - x * omega3 + z * omega1) / 2) + (z + z) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) = 0.
Proof.
  intros omega1 omega2 omega3 w x y z H_1  .
  rational.
Qed.

(* With the half left out. *)

(* R', xx *)
Theorem attitude_rate_mutant_1 :
  exists omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  (w + w) * ((- (x * (omega1 * 2)) - y * (omega2 * 2) - z * (omega3 * 2)) / 2) + (x + x) * ((w *
    (omega1 * 2) + y * (omega3 * 2) - z * (omega2 * 2)) / 2) + (- (y + y)) * ((w * (omega2 * 2) - x
    * (omega3 * 2) + z * (omega1 * 2)) / 2) + (- (z + z)) * ((w * (omega3 * 2) + x * (omega2 * 2) -
    y * (omega1 * 2)) / 2) <> (x * z + w * y + (x * z + w * y)) * (- omega2) + (x * y - w * z + (x *
    y - w * z)) * omega3.
Proof.
  exists (1 / 6), (1 / 3), (1 / 2), (-1 / 2), (-1 / 2), (1 / 2), (-1 / 2).
  split; [computed | ]. 
  computed.
Qed.

(* With the spin in world axes. *)

(* R', xx *)
Theorem attitude_rate_mutant_2 :
  exists omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  (w + w) * (- (omega1 / 2 * x) - omega2 / 2 * y - omega3 / 2 * z) + (x + x) * (omega1 / 2 * w +
    omega2 / 2 * z - omega3 / 2 * y) + (- (y + y)) * (- (omega1 / 2 * z) + omega2 / 2 * w + omega3 /
    2 * x) + (- (z + z)) * (omega1 / 2 * y - omega2 / 2 * x + omega3 / 2 * w) <> (x * z + w * y + (x
    * z + w * y)) * (- omega2) + (x * y - w * z + (x * y - w * z)) * omega3.
Proof.
  exists (1 / 6), (1 / 3), (1 / 2), (-1 / 2), (-1 / 2), (1 / 2), (-1 / 2).
  split; [computed | ]. 
  computed.
Qed.
