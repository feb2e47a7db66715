(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.


(** energy-in-both-frames: Half of w.L is the same number in body and world axes, for every body and attitude. *)

(* half of w.L *)
Theorem energy_in_both_frames_1 :
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
  let t_13 := t_10 * J_zz + (t_11 * J_yz + t_12 * J_xz) in
  let t_14 := t_10 * J_yz + (t_11 * J_yy + t_12 * J_xy) in
  let t_15 := t_10 * J_xz + (t_11 * J_xy + t_12 * J_xx) in
  let t_16 := t_5 * J_zz + (t_7 * J_yz + t_9 * J_xz) in
  let t_17 := t_5 * J_yz + (t_7 * J_yy + t_9 * J_xy) in
  let t_18 := t_5 * J_xz + (t_7 * J_xy + t_9 * J_xx) in
  let t_19 := ((t_4 * t_5 + (t_6 * t_7 + t_8 * t_9)) * L3 + ((t_4 * t_10 + (t_6 * t_11 + t_8 *
    t_12)) * L2 + (t_4 * t_1 + (t_6 * t_2 + t_8 * t_3)) * L1)) * L1 + ((t_13 * t_5 + (t_14 * t_7 +
    t_15 * t_9)) * L3 + ((t_13 * t_10 + (t_14 * t_11 + t_15 * t_12)) * L2 + (t_13 * t_1 + (t_14 *
    t_2 + t_15 * t_3)) * L1)) * L2 + ((t_16 * t_5 + (t_17 * t_7 + t_18 * t_9)) * L3 + ((t_16 * t_10
    + (t_17 * t_11 + t_18 * t_12)) * L2 + (t_16 * t_1 + (t_17 * t_2 + t_18 * t_3)) * L1)) * L3 in
  let t_20 := t_5 * L3 + (t_10 * L2 + t_1 * L1) in
  let t_21 := t_7 * L3 + (t_11 * L2 + t_2 * L1) in
  let t_22 := t_9 * L3 + (t_12 * L2 + t_3 * L1) in
  t_19 / 2 = ((J_xz * t_20 + (J_xy * t_21 + J_xx * t_22)) * t_22 + (J_yz * t_20 + (J_yy * t_21 +
    J_xy * t_22)) * t_21 + (J_zz * t_20 + (J_yz * t_21 + J_xz * t_22)) * t_20) / 2.
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10
    t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 .
  rational.
Qed.

(* the kinetic energy of a point *)
Theorem energy_in_both_frames_2 :
  forall m omega1 omega2 omega3 r1 r2 r3 : R,
  let t_1 := omega1 * ((- (m * r1 * r3)) * omega3 + ((- (m * r1 * r2)) * omega2 + (m * r2 * r2 + m *
    r3 * r3) * omega1)) + omega2 * ((- (m * r2 * r3)) * omega3 + ((m * r3 * r3 + m * r1 * r1) *
    omega2 + (- (m * r1 * r2)) * omega1)) + omega3 * ((m * r1 * r1 + m * r2 * r2) * omega3 + ((- (m
    * r2 * r3)) * omega2 + (- (m * r1 * r3)) * omega1)) in
  t_1 / 2 = m * ((omega2 * r3 - omega3 * r2) * (omega2 * r3 - omega3 * r2) + (omega3 * r1 - omega1 *
    r3) * (omega3 * r1 - omega1 * r3) + (omega1 * r2 - omega2 * r1) * (omega1 * r2 - omega2 * r1)) /
    2.
Proof.
  intros m omega1 omega2 omega3 r1 r2 r3  t_1 .
  rational.
Qed.

(* With the inverse not turned. *)

(* half of w.L *)
Theorem energy_in_both_frames_mutant_1 :
  exists J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 w x y z : R,
  let t_1 := (w * w - x * x - y * y + z * z) * L3 + ((y * z - w * x + (y * z - w * x)) * L2 + (x * z
    + w * y + (x * z + w * y)) * L1) in
  let t_2 := (y * z + w * x + (y * z + w * x)) * L3 + ((w * w - x * x + y * y - z * z) * L2 + (x * y
    - w * z + (x * y - w * z)) * L1) in
  let t_3 := (x * z - w * y + (x * z - w * y)) * L3 + ((x * y + w * z + (x * y + w * z)) * L2 + (w *
    w + x * x - y * y - z * z) * L1) in
  ((J_xz * L3 + (J_xy * L2 + J_xx * L1)) * L1 + (J_yz * L3 + (J_yy * L2 + J_xy * L1)) * L2 + (J_zz *
    L3 + (J_yz * L2 + J_xz * L1)) * L3) / 2 <> ((J_xz * t_1 + (J_xy * t_2 + J_xx * t_3)) * t_3 +
    (J_yz * t_1 + (J_yy * t_2 + J_xy * t_3)) * t_2 + (J_zz * t_1 + (J_yz * t_2 + J_xz * t_3)) * t_1)
    / 2.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6, (-2).
  intros t_1; cut_to t_1 2 computed.
  intros t_2; cut_to t_2 283 computed.
  intros t_3; cut_to t_3 (-157) computed.
  computed.
Qed.
