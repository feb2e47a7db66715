(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics.


(** energy-in-both-frames: Half of w.L is the same number in body and world axes, for every body and attitude. *)

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
  unnamed.
  field; nonzero.
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
