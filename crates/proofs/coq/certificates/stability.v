(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.


(** steady-spins: A spin about a principal axis does not change, for every body and every axis. *)

(* w' about axis 1, x *)
Theorem steady_spins_1 :
  forall I1 : R,
  I1 <> 0 ->
  0 / I1 = 0.
Proof.
  intros I1   D_1.
  rational.
Qed.

(* w' about axis 1, y *)
Theorem steady_spins_2 :
  forall I2 : R,
  I2 <> 0 ->
  0 / I2 = 0.
Proof.
  intros I2   D_1.
  rational.
Qed.

(* w' about axis 1, z *)
Theorem steady_spins_3 :
  forall I3 : R,
  I3 <> 0 ->
  0 / I3 = 0.
Proof.
  intros I3   D_1.
  rational.
Qed.

(* w' about axis 2, x *)
Theorem steady_spins_4 :
  forall I1 : R,
  I1 <> 0 ->
  0 / I1 = 0.
Proof.
  intros I1   D_1.
  rational.
Qed.

(* w' about axis 2, y *)
Theorem steady_spins_5 :
  forall I2 : R,
  I2 <> 0 ->
  0 / I2 = 0.
Proof.
  intros I2   D_1.
  rational.
Qed.

(* w' about axis 2, z *)
Theorem steady_spins_6 :
  forall I3 : R,
  I3 <> 0 ->
  0 / I3 = 0.
Proof.
  intros I3   D_1.
  rational.
Qed.

(* w' about axis 3, x *)
Theorem steady_spins_7 :
  forall I1 : R,
  I1 <> 0 ->
  0 / I1 = 0.
Proof.
  intros I1   D_1.
  rational.
Qed.

(* w' about axis 3, y *)
Theorem steady_spins_8 :
  forall I2 : R,
  I2 <> 0 ->
  0 / I2 = 0.
Proof.
  intros I2   D_1.
  rational.
Qed.

(* w' about axis 3, z *)
Theorem steady_spins_9 :
  forall I3 : R,
  I3 <> 0 ->
  0 / I3 = 0.
Proof.
  intros I3   D_1.
  rational.
Qed.

(* With w1 w1 for w2 w3 in the second equation. *)

(* w' about axis 1, y *)
Theorem steady_spins_mutant_1 :
  exists I1 I2 I3 Omega : R,
  I2 <> 0 /\
  (I3 - I1) * Omega * Omega / I2 <> 0.
Proof.
  exists 6, 1, (-3), 1.
  split; [computed | ]. computed.
Qed.


(** rates-of-the-wobble: Linearised about each axis, Euler's equations leave the spin itself alone and drive the two small components by each other, so that their second rate is the library's rate squared times themselves. *)

(* a slope that should vanish *)
Theorem rates_of_the_wobble_1 :
  forall I1 : R,
  I1 <> 0 ->
  0 / I1 = 0.
Proof.
  intros I1   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_2 :
  forall I2 : R,
  I2 <> 0 ->
  0 / I2 = 0.
Proof.
  intros I2   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_3 :
  forall I3 : R,
  I3 <> 0 ->
  0 / I3 = 0.
Proof.
  intros I3   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_4 :
  forall I2 : R,
  I2 <> 0 ->
  0 / I2 = 0.
Proof.
  intros I2   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_5 :
  forall I3 : R,
  I3 <> 0 ->
  0 / I3 = 0.
Proof.
  intros I3   D_1.
  rational.
Qed.

(* the rate squared about axis 1 *)
Theorem rates_of_the_wobble_6 :
  forall I1 I2 I3 Omega : R,
  I2 <> 0 ->
  I3 <> 0 ->
  (I3 - I1) * Omega / I2 * ((I1 - I2) * Omega / I3) = Omega * Omega * ((I1 - I2) / I2) * ((I3 - I1)
    / I3).
Proof.
  intros I1 I2 I3 Omega   D_1 D_2.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_7 :
  forall I2 : R,
  I2 <> 0 ->
  0 / I2 = 0.
Proof.
  intros I2   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_8 :
  forall I3 : R,
  I3 <> 0 ->
  0 / I3 = 0.
Proof.
  intros I3   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_9 :
  forall I1 : R,
  I1 <> 0 ->
  0 / I1 = 0.
Proof.
  intros I1   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_10 :
  forall I3 : R,
  I3 <> 0 ->
  0 / I3 = 0.
Proof.
  intros I3   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_11 :
  forall I1 : R,
  I1 <> 0 ->
  0 / I1 = 0.
Proof.
  intros I1   D_1.
  rational.
Qed.

(* the rate squared about axis 2 *)
Theorem rates_of_the_wobble_12 :
  forall I1 I2 I3 Omega : R,
  I3 <> 0 ->
  I1 <> 0 ->
  (I1 - I2) * Omega / I3 * ((I2 - I3) * Omega / I1) = Omega * Omega * ((I2 - I3) / I3) * ((I1 - I2)
    / I1).
Proof.
  intros I1 I2 I3 Omega   D_1 D_2.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_13 :
  forall I3 : R,
  I3 <> 0 ->
  0 / I3 = 0.
Proof.
  intros I3   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_14 :
  forall I1 : R,
  I1 <> 0 ->
  0 / I1 = 0.
Proof.
  intros I1   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_15 :
  forall I2 : R,
  I2 <> 0 ->
  0 / I2 = 0.
Proof.
  intros I2   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_16 :
  forall I1 : R,
  I1 <> 0 ->
  0 / I1 = 0.
Proof.
  intros I1   D_1.
  rational.
Qed.

(* a slope that should vanish *)
Theorem rates_of_the_wobble_17 :
  forall I2 : R,
  I2 <> 0 ->
  0 / I2 = 0.
Proof.
  intros I2   D_1.
  rational.
Qed.

(* the rate squared about axis 3 *)
Theorem rates_of_the_wobble_18 :
  forall I1 I2 I3 Omega : R,
  I1 <> 0 ->
  I2 <> 0 ->
  (I2 - I3) * Omega / I1 * ((I3 - I1) * Omega / I2) = Omega * Omega * ((I3 - I1) / I1) * ((I2 - I3)
    / I2).
Proof.
  intros I1 I2 I3 Omega   D_1 D_2.
  rational.
Qed.

(* With the sign. *)

(* the rate squared about axis 1 *)
Theorem rates_of_the_wobble_mutant_1 :
  exists I1 I2 I3 Omega : R,
  I2 <> 0 /\
  I3 <> 0 /\
  (I3 - I1) * Omega / I2 * ((I1 - I2) * Omega / I3) <> - (Omega * Omega * ((I1 - I2) / I2) * ((I3 -
    I1) / I3)).
Proof.
  exists 6, 1, (-3), 1.
  split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With divided by the wrong moment. *)

(* the rate squared about axis 1 *)
Theorem rates_of_the_wobble_mutant_2 :
  exists I1 I2 I3 Omega : R,
  I2 <> 0 /\
  I3 <> 0 /\
  I1 <> 0 /\
  (I3 - I1) * Omega / I2 * ((I1 - I2) * Omega / I3) <> Omega * Omega * ((I1 - I2) / I2) * ((I3 - I1)
    / I3) * I2 / I1.
Proof.
  exists 6, 1, (-3), 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** the-middle-axis: For every body with I1 < I2 < I3 the wobble grows about the middle axis and swings about the other two: with I2 = I1 + a and I3 = I1 + a + b all coefficients have one sign. *)

(* the rate squared about axis 1 *)
Theorem the_middle_axis_1 :
  forall I1 Omega a b : R,
  0 < I1 ->
  0 < Omega ->
  0 < a ->
  0 < b ->
  - (Omega * Omega * ((I1 - (I1 + a)) / (I1 + a)) * ((I1 + a + b - I1) / (I1 + a + b))) > 0.
Proof.
  intros I1 Omega a b H_1 H_2 H_3 H_4  .
  unnamed.
  assert (I1 + a <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 + a + b <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 ^ 2 + 2 * I1 * a + I1 * b + a ^ 2 + a * b <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (Omega ^ 2 * a ^ 2 + Omega ^ 2 * a * b) (I1 ^ 2 + 2 * I1 * a + I1 * b + a ^ 2
    + a * b)); [positive | positive | rational].
Qed.

(* the rate squared about axis 2 *)
Theorem the_middle_axis_2 :
  forall I1 Omega a b : R,
  0 < I1 ->
  0 < Omega ->
  0 < a ->
  0 < b ->
  Omega * Omega * ((I1 + a - (I1 + a + b)) / (I1 + a + b)) * ((I1 - (I1 + a)) / I1) > 0.
Proof.
  intros I1 Omega a b H_1 H_2 H_3 H_4  .
  unnamed.
  assert (I1 + a + b <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 ^ 2 + I1 * a + I1 * b <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (Omega ^ 2 * a * b) (I1 ^ 2 + I1 * a + I1 * b)); [positive | positive |
    rational].
Qed.

(* the rate squared about axis 3 *)
Theorem the_middle_axis_3 :
  forall I1 Omega a b : R,
  0 < I1 ->
  0 < Omega ->
  0 < a ->
  0 < b ->
  - (Omega * Omega * ((I1 + a + b - I1) / I1) * ((I1 + a - (I1 + a + b)) / (I1 + a))) > 0.
Proof.
  intros I1 Omega a b H_1 H_2 H_3 H_4  .
  unnamed.
  assert (I1 <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 + a <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 ^ 2 + I1 * a <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (Omega ^ 2 * a * b + Omega ^ 2 * b ^ 2) (I1 ^ 2 + I1 * a)); [positive |
    positive | rational].
Qed.

(* With the sign. *)

(* the rate squared about axis 1 *)
Theorem the_middle_axis_mutant_1 :
  exists I1 Omega a b : R,
  0 < I1 /\
  0 < Omega /\
  0 < a /\
  0 < b /\
  Omega * Omega * ((I1 - (I1 + a)) / (I1 + a)) * ((I1 + a + b - I1) / (I1 + a + b)) <= 0.
Proof.
  exists 6, 1, 3, 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. 
  computed.
Qed.

(* With the smallest axis taken for the middle one. *)

(* the rate squared about axis 1 *)
Theorem the_middle_axis_mutant_2 :
  exists I1 Omega a b : R,
  0 < I1 /\
  0 < Omega /\
  0 < a /\
  0 < b /\
  Omega * Omega * ((I1 - (I1 + a)) / (I1 + a)) * ((I1 + a + b - I1) / (I1 + a + b)) <= 0.
Proof.
  exists 6, 1, 3, 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. 
  computed.
Qed.


(** equal-moments: About either of two axes with equal moments the rate is zero: neither growth nor swing; about the third it swings. *)

(* the rate squared of an equal pair *)
Theorem equal_moments_1 :
  forall I1 Omega a : R,
  I1 <> 0 ->
  I1 + a <> 0 ->
  Omega * Omega * ((I1 - I1) / I1) * ((I1 + a - I1) / (I1 + a)) = 0.
Proof.
  intros I1 Omega a   D_1 D_2.
  rational.
Qed.

(* the rate squared of an equal pair *)
Theorem equal_moments_2 :
  forall I1 Omega a : R,
  I1 + a <> 0 ->
  I1 <> 0 ->
  Omega * Omega * ((I1 - (I1 + a)) / (I1 + a)) * ((I1 - I1) / I1) = 0.
Proof.
  intros I1 Omega a   D_1 D_2.
  rational.
Qed.

(* the swing about the lone axis *)
Theorem equal_moments_3 :
  forall I1 Omega a : R,
  0 < I1 ->
  0 < Omega ->
  0 < a ->
  - (Omega * Omega * ((I1 + a - I1) / I1) * ((I1 - (I1 + a)) / I1)) > 0.
Proof.
  intros I1 Omega a H_1 H_2 H_3  .
  unnamed.
  assert (I1 <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 ^ 2 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (Omega ^ 2 * a ^ 2) (I1 ^ 2)); [positive | positive | rational].
Qed.

(* the rate squared of an equal pair *)
Theorem equal_moments_4 :
  forall I1 Omega a : R,
  I1 + a <> 0 ->
  I1 <> 0 ->
  Omega * Omega * ((I1 + a - (I1 + a)) / (I1 + a)) * ((I1 - (I1 + a)) / I1) = 0.
Proof.
  intros I1 Omega a   D_1 D_2.
  rational.
Qed.

(* the rate squared of an equal pair *)
Theorem equal_moments_5 :
  forall I1 Omega a : R,
  I1 <> 0 ->
  I1 + a <> 0 ->
  Omega * Omega * ((I1 + a - I1) / I1) * ((I1 + a - (I1 + a)) / (I1 + a)) = 0.
Proof.
  intros I1 Omega a   D_1 D_2.
  rational.
Qed.

(* the swing about the lone axis *)
Theorem equal_moments_6 :
  forall I1 Omega a : R,
  0 < I1 ->
  0 < Omega ->
  0 < a ->
  - (Omega * Omega * ((I1 - (I1 + a)) / (I1 + a)) * ((I1 + a - I1) / (I1 + a))) > 0.
Proof.
  intros I1 Omega a H_1 H_2 H_3  .
  unnamed.
  assert (I1 + a <> 0) by (apply Rgt_not_eq; positive).
  assert (I1 ^ 2 + 2 * I1 * a + a ^ 2 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ (Omega ^ 2 * a ^ 2) (I1 ^ 2 + 2 * I1 * a + a ^ 2)); [positive | positive |
    rational].
Qed.

(* With w² added. *)

(* the rate squared of an equal pair *)
Theorem equal_moments_mutant_1 :
  exists I1 Omega a : R,
  I1 <> 0 /\
  I1 + a <> 0 /\
  Omega * Omega * ((I1 - I1) / I1) * ((I1 + a - I1) / (I1 + a)) + Omega ^ 2 <> 0.
Proof.
  exists 6, 1, (-3).
  split; [computed | ]. split; [computed | ]. computed.
Qed.
