(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.


(** errata-rate-about-the-smallest-axis: With the momentum (s B13 dn, -B21 sn, B31 cn) of λ t, s = ±1, Euler's equations want the rate -s λ3. *)

(* w', x *)
Theorem errata_rate_about_the_smallest_axis_1 :
  forall cn dn k m p q r s sn x1 x2 x3 z : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  s ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := - (z * r * q * p / (x1 * x2 * x3) * s) in
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  0 / x1 ^ 2 * (cn * dn * t_1) + 0 / x1 ^ 2 * (- (sn * dn * t_1)) + s * x1 * q * z / x1 ^ 2 * (- (m
    * (sn * cn * t_1))) = (x2 ^ 2 - x3 ^ 2) * ((- (x2 * k * z * r * sn)) / x2 ^ 2 * (x3 * (k * z *
    p) * cn / x3 ^ 2)) / x1 ^ 2.
Proof.
  intros cn dn k m p q r s sn x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* w', y *)
Theorem errata_rate_about_the_smallest_axis_2 :
  forall cn dn k m p q r s sn x1 x2 x3 z : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  s ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := - (z * r * q * p / (x1 * x2 * x3) * s) in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  (- (x2 * k * z * r)) / x2 ^ 2 * (cn * dn * t_1) + 0 / x2 ^ 2 * (- (sn * dn * t_1)) + 0 / x2 ^ 2 *
    (- (m * (sn * cn * t_1))) = (x3 ^ 2 - x1 ^ 2) * (x3 * (k * z * p) * cn / x3 ^ 2 * (s * x1 * q *
    z * dn / x1 ^ 2)) / x2 ^ 2.
Proof.
  intros cn dn k m p q r s sn x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* w', z *)
Theorem errata_rate_about_the_smallest_axis_3 :
  forall cn dn k m p q r s sn x1 x2 x3 z : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  s ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := - (z * r * q * p / (x1 * x2 * x3) * s) in
  x3 <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  0 / x3 ^ 2 * (cn * dn * t_1) + x3 * (k * z * p) / x3 ^ 2 * (- (sn * dn * t_1)) + 0 / x3 ^ 2 * (-
    (m * (sn * cn * t_1))) = (x1 ^ 2 - x2 ^ 2) * (s * x1 * q * z * dn / x1 ^ 2 * ((- (x2 * k * z * r
    * sn)) / x2 ^ 2)) / x3 ^ 2.
Proof.
  intros cn dn k m p q r s sn x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* With the rate s λ3. *)

(* w', x *)
Theorem errata_rate_about_the_smallest_axis_mutant_1 :
  exists cn dn k m p q r s sn x1 x2 x3 z : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (m * sn ^ 2) + 1 /\
  k ^ 2 = m /\
  s ^ 2 = 1 /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := z * r * q * p / (x1 * x2 * x3) * s in
  x1 <> 0 /\
  x2 <> 0 /\
  x3 <> 0 /\
  0 / x1 ^ 2 * (cn * dn * t_1) + 0 / x1 ^ 2 * (- (sn * dn * t_1)) + s * x1 * q * z / x1 ^ 2 * (- (m
    * (sn * cn * t_1))) <> (x2 ^ 2 - x3 ^ 2) * ((- (x2 * k * z * r * sn)) / x2 ^ 2 * (x3 * (k * z *
    p) * cn / x3 ^ 2)) / x1 ^ 2.
Proof.
  exists (4 / 5), (12 / 13), (25 / 39), (625 / 1521), 104, 672, 680, 1, (3 / 5), 153, 185, 697, 4.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. split; [computed | ]. 
  intros t_1; cut_to t_1 (745472 / 77367) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** errata-rate-about-the-largest-axis: With the momentum (B13 cn, -B23 sn, s B31 dn) of λ t, s = ±1, Euler's equations want the rate -s λ1. *)

(* w', x *)
Theorem errata_rate_about_the_largest_axis_1 :
  forall cn dn k m p q r s sn x1 x2 x3 z : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  s ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := - (z * r * p * q / (x1 * x2 * x3) * s) in
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  0 / x1 ^ 2 * (cn * dn * t_1) + x1 * (k * z * q) / x1 ^ 2 * (- (sn * dn * t_1)) + 0 / x1 ^ 2 * (-
    (m * (sn * cn * t_1))) = (x2 ^ 2 - x3 ^ 2) * ((- (x2 * k * z * r * sn)) / x2 ^ 2 * (s * x3 * p *
    z * dn / x3 ^ 2)) / x1 ^ 2.
Proof.
  intros cn dn k m p q r s sn x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* w', y *)
Theorem errata_rate_about_the_largest_axis_2 :
  forall cn dn k m p q r s sn x1 x2 x3 z : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  s ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := - (z * r * p * q / (x1 * x2 * x3) * s) in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  (- (x2 * k * z * r)) / x2 ^ 2 * (cn * dn * t_1) + 0 / x2 ^ 2 * (- (sn * dn * t_1)) + 0 / x2 ^ 2 *
    (- (m * (sn * cn * t_1))) = (x3 ^ 2 - x1 ^ 2) * (s * x3 * p * z * dn / x3 ^ 2 * (x1 * (k * z *
    q) * cn / x1 ^ 2)) / x2 ^ 2.
Proof.
  intros cn dn k m p q r s sn x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* w', z *)
Theorem errata_rate_about_the_largest_axis_3 :
  forall cn dn k m p q r s sn x1 x2 x3 z : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  s ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := - (z * r * p * q / (x1 * x2 * x3) * s) in
  x3 <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  0 / x3 ^ 2 * (cn * dn * t_1) + 0 / x3 ^ 2 * (- (sn * dn * t_1)) + s * x3 * p * z / x3 ^ 2 * (- (m
    * (sn * cn * t_1))) = (x1 ^ 2 - x2 ^ 2) * (x1 * (k * z * q) * cn / x1 ^ 2 * ((- (x2 * k * z * r
    * sn)) / x2 ^ 2)) / x3 ^ 2.
Proof.
  intros cn dn k m p q r s sn x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* With the rate s λ1. *)

(* w', x *)
Theorem errata_rate_about_the_largest_axis_mutant_1 :
  exists cn dn k m p q r s sn x1 x2 x3 z : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (m * sn ^ 2) + 1 /\
  k ^ 2 = m /\
  s ^ 2 = 1 /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := z * r * p * q / (x1 * x2 * x3) * s in
  x1 <> 0 /\
  x2 <> 0 /\
  x3 <> 0 /\
  0 / x1 ^ 2 * (cn * dn * t_1) + x1 * (k * z * q) / x1 ^ 2 * (- (sn * dn * t_1)) + 0 / x1 ^ 2 * (-
    (m * (sn * cn * t_1))) <> (x2 ^ 2 - x3 ^ 2) * ((- (x2 * k * z * r * sn)) / x2 ^ 2 * (s * x3 * p
    * z * dn / x3 ^ 2)) / x1 ^ 2.
Proof.
  exists (4 / 5), (12 / 13), (25 / 39), (625 / 1521), 104, 672, 680, 1, (3 / 5), 153, 185, 697, 4.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. split; [computed | ]. 
  intros t_1; cut_to t_1 (745472 / 77367) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** errata-signs-on-the-separatrix: On the separatrix the momentum (s B13 sech, G tanh, s' B31 sech) of s s' λ2 t, with two signs of its own, obeys Euler's equations. *)

(* w', x *)
Theorem errata_signs_on_the_separatrix_1 :
  forall p q r s s_ sech tanh x1 x2 x3 z : R,
  sech ^ 2 = - tanh ^ 2 + 1 ->
  s ^ 2 = 1 ->
  s_ ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := z * p * q / (x1 * x3 * x2 ^ 2) * s * s_ in
  x2 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  (0 / (x2 * r) * sech + s * x1 * q * z / (x2 * r)) / x1 ^ 2 * (- (sech * tanh * t_1)) + 0 / (x2 *
    r) * sech / x1 ^ 2 * (sech * sech * t_1) = (x2 ^ 2 - x3 ^ 2) * (z * tanh / x2 ^ 2 * (s_ * x3 * p
    * z / (x2 * r) * sech / x3 ^ 2)) / x1 ^ 2.
Proof.
  intros p q r s s_ sech tanh x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* w', y *)
Theorem errata_signs_on_the_separatrix_2 :
  forall p q r s s_ sech tanh x1 x2 x3 z : R,
  sech ^ 2 = - tanh ^ 2 + 1 ->
  s ^ 2 = 1 ->
  s_ ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := z * p * q / (x1 * x3 * x2 ^ 2) * s * s_ in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  0 / x2 ^ 2 * (- (sech * tanh * t_1)) + z / x2 ^ 2 * (sech * sech * t_1) = (x3 ^ 2 - x1 ^ 2) * (s_
    * x3 * p * z / (x2 * r) * sech / x3 ^ 2 * (s * x1 * q * z / (x2 * r) * sech / x1 ^ 2)) / x2 ^ 2.
Proof.
  intros p q r s s_ sech tanh x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* w', z *)
Theorem errata_signs_on_the_separatrix_3 :
  forall p q r s s_ sech tanh x1 x2 x3 z : R,
  sech ^ 2 = - tanh ^ 2 + 1 ->
  s ^ 2 = 1 ->
  s_ ^ 2 = 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := z * p * q / (x1 * x3 * x2 ^ 2) * s * s_ in
  x2 <> 0 ->
  r <> 0 ->
  x3 <> 0 ->
  x1 <> 0 ->
  (0 / (x2 * r) * sech + s_ * x3 * p * z / (x2 * r)) / x3 ^ 2 * (- (sech * tanh * t_1)) + 0 / (x2 *
    r) * sech / x3 ^ 2 * (sech * sech * t_1) = (x1 ^ 2 - x2 ^ 2) * (s * x1 * q * z / (x2 * r) * sech
    / x1 ^ 2 * (z * tanh / x2 ^ 2)) / x3 ^ 2.
Proof.
  intros p q r s s_ sech tanh x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* With one sign for both ends in the rate. *)

(* w', x *)
Theorem errata_signs_on_the_separatrix_mutant_1 :
  exists p q r s s_ sech tanh x1 x2 x3 z : R,
  sech ^ 2 = - tanh ^ 2 + 1 /\
  s ^ 2 = 1 /\
  s_ ^ 2 = 1 /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := z * p * q / (x1 * x3 * x2 ^ 2) * s in
  x2 <> 0 /\
  r <> 0 /\
  x1 <> 0 /\
  x3 <> 0 /\
  (0 / (x2 * r) * sech + s * x1 * q * z / (x2 * r)) / x1 ^ 2 * (- (sech * tanh * t_1)) + 0 / (x2 *
    r) * sech / x1 ^ 2 * (sech * sech * t_1) <> (x2 ^ 2 - x3 ^ 2) * (z * tanh / x2 ^ 2 * (s_ * x3 *
    p * z / (x2 * r) * sech / x3 ^ 2)) / x1 ^ 2.
Proof.
  exists 104, 672, 680, 1, (-1), (4 / 5), (3 / 5), 153, 185, 697, 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. 
  intros t_1; cut_to t_1 (23296 / 1216596075) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With a rate without signs. *)

(* w', x *)
Theorem errata_signs_on_the_separatrix_mutant_2 :
  exists p q r s s_ sech tanh x1 x2 x3 z : R,
  sech ^ 2 = - tanh ^ 2 + 1 /\
  s ^ 2 = 1 /\
  s_ ^ 2 = 1 /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := z * p * q / (x1 * x3 * x2 ^ 2) in
  x2 <> 0 /\
  r <> 0 /\
  x1 <> 0 /\
  x3 <> 0 /\
  (0 / (x2 * r) * sech + s * x1 * q * z / (x2 * r)) / x1 ^ 2 * (- (sech * tanh * t_1)) + 0 / (x2 *
    r) * sech / x1 ^ 2 * (sech * sech * t_1) <> (x2 ^ 2 - x3 ^ 2) * (z * tanh / x2 ^ 2 * (s_ * x3 *
    p * z / (x2 * r) * sech / x3 ^ 2)) / x1 ^ 2.
Proof.
  exists 104, 672, 680, 1, (-1), (4 / 5), (3 / 5), 153, 185, 697, 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. 
  intros t_1; cut_to t_1 (23296 / 1216596075) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** errata-rate-of-the-angle: The attitude that takes the momentum to the third axis by the shortest way and then turns by ψ about it obeys q' = q ω / 2 if ψ' = (2 T + G m3 / I3) / (G + m3). *)

(* q' - q w / 2 *)
Theorem errata_rate_of_the_angle_1 :
  forall G I1 I2 I3 m1 m2 m3 : R,
  G ^ 2 = m1 ^ 2 + m2 ^ 2 + m3 ^ 2 ->
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  G + m3 <> 0 ->
  - (((m1 / I1 * m1 + m2 / I2 * m2 + m3 / I3 * m3) / 2 * 2 + G * (m3 / I3)) / (G + m3) / 2 * (- m1))
    + (m3 * (m1 / I1) - m1 * (m3 / I3) - m2 * ((m1 * (m2 / I2) - m2 * (m1 / I1)) / ((G + m3) * 2)))
    - ((G + m3) * (m1 / I1) + (- m1) * (m3 / I3)) / 2 = 0.
Proof.
  intros G I1 I2 I3 m1 m2 m3 H_1  D_1 D_2 D_3 D_4.
  rational.
Qed.

(* q' - q w / 2 *)
Theorem errata_rate_of_the_angle_2 :
  forall G I1 I2 I3 m1 m2 m3 : R,
  G ^ 2 = m1 ^ 2 + m2 ^ 2 + m3 ^ 2 ->
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  G + m3 <> 0 ->
  ((m1 / I1 * m1 + m2 / I2 * m2 + m3 / I3 * m3) / 2 * 2 + G * (m3 / I3)) / (G + m3) / 2 * m2 + (-
    (m2 * (m3 / I3) - m3 * (m2 / I2)) - (- m1) * ((m1 * (m2 / I2) - m2 * (m1 / I1)) / ((G + m3) *
    2))) - ((G + m3) * (m2 / I2) - m2 * (m3 / I3)) / 2 = 0.
Proof.
  intros G I1 I2 I3 m1 m2 m3 H_1  D_1 D_2 D_3 D_4.
  rational.
Qed.

(* q' - q w / 2 *)
Theorem errata_rate_of_the_angle_3 :
  forall G I1 I2 I3 m1 m2 m3 : R,
  G ^ 2 = m1 ^ 2 + m2 ^ 2 + m3 ^ 2 ->
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  G + m3 <> 0 ->
  ((m1 / I1 * m1 + m2 / I2 * m2 + m3 / I3 * m3) / 2 * 2 + G * (m3 / I3)) / (G + m3) / 2 * (G + m3) -
    ((G + m3) * (m3 / I3) + m2 * (m2 / I2) - (- m1) * (m1 / I1)) / 2 = 0.
Proof.
  intros G I1 I2 I3 m1 m2 m3 H_1  D_1 D_2 D_3 D_4.
  rational.
Qed.

(* q' - q w / 2 *)
Theorem errata_rate_of_the_angle_4 :
  forall G I1 I2 m1 m2 m3 : R,
  G ^ 2 = m1 ^ 2 + m2 ^ 2 + m3 ^ 2 ->
  let t_1 := m1 * (m2 / I2) - m2 * (m1 / I1) in
  I2 <> 0 ->
  I1 <> 0 ->
  G + m3 <> 0 ->
  t_1 - (G + m3) * (t_1 / ((G + m3) * 2)) - (- (m2 * (m1 / I1)) - (- m1) * (m2 / I2)) / 2 = 0.
Proof.
  intros G I1 I2 m1 m2 m3 H_1 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* With a minus in the numerator. *)

(* q' - q w / 2 *)
Theorem errata_rate_of_the_angle_mutant_1 :
  exists G I1 I2 I3 m1 m2 m3 : R,
  G ^ 2 = m1 ^ 2 + m2 ^ 2 + m3 ^ 2 /\
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  G + m3 <> 0 /\
  - (((m1 / I1 * m1 + m2 / I2 * m2 + m3 / I3 * m3) / 2 * 2 - G * (m3 / I3)) / (G + m3) / 2 * (- m1))
    + (m3 * (m1 / I1) - m1 * (m3 / I3) - m2 * ((m1 * (m2 / I2) - m2 * (m1 / I1)) / ((G + m3) * 2)))
    - ((G + m3) * (m1 / I1) + (- m1) * (m3 / I3)) / 2 <> 0.
Proof.
  exists 3, 2, (-2), (-2 / 3), (-1), 2, (-2).
  split; [computed | ]. 
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** errata-sign-of-the-angle: That rate is the derivative of G t / I3 + G I31 / (λ I1 I3) (Π - (B31 / G) (B13 / B21) arctan((B21 / B13) sd)), with -(B31 / B13)² for the characteristic of Π. *)

(* the angle's rate *)
Theorem errata_sign_of_the_angle_1 :
  forall G cn dn k m p q r sn x1 x2 x3 z : R,
  G ^ 2 = m * p ^ 4 * z ^ 2 + m * p ^ 2 * q ^ 2 * z ^ 2 + m * p ^ 2 * x1 ^ 2 * z ^ 2 + q ^ 2 * x1 ^
    2 * z ^ 2 ->
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := x3 * k * p * z * cn in
  x3 <> 0 ->
  x1 <> 0 ->
  q <> 0 ->
  z <> 0 ->
  1 + (x3 * k * p * z / (x1 * q * z)) ^ 2 * sn ^ 2 <> 0 ->
  x2 <> 0 ->
  k <> 0 ->
  r <> 0 ->
  G <> 0 ->
  dn ^ 2 + (x2 * k * z * r / (x1 * q * z)) ^ 2 * sn ^ 2 <> 0 ->
  G + t_1 <> 0 ->
  G / x3 ^ 2 + G * r ^ 2 / (x1 ^ 2 * x3 ^ 2) * (1 / (1 + (x3 * k * p * z / (x1 * q * z)) ^ 2 * sn ^
    2) + (- (x3 * k * p * z * (x1 * q * z) / (x2 * k * z * r))) / G * (x2 * k * z * r / (x1 * q * z)
    * cn / (dn ^ 2 + (x2 * k * z * r / (x1 * q * z)) ^ 2 * sn ^ 2))) = ((x1 * q * z) ^ 2 / x1 ^ 2 +
    (x3 * k * p * z) ^ 2 / x3 ^ 2 + G * t_1 / x3 ^ 2) / (G + t_1).
Proof.
  intros G cn dn k m p q r sn x1 x2 x3 z H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3 D_4 D_5 D_6 D_7
    D_8 D_9 D_10 D_11.
  rational.
Qed.

(* With a plus before the arctangent. *)

(* the angle's rate *)
Theorem errata_sign_of_the_angle_mutant_1 :
  exists G cn dn k m p q r sn x1 x2 x3 z : R,
  G ^ 2 = m * p ^ 4 * z ^ 2 + m * p ^ 2 * q ^ 2 * z ^ 2 + m * p ^ 2 * x1 ^ 2 * z ^ 2 + q ^ 2 * x1 ^
    2 * z ^ 2 /\
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (m * sn ^ 2) + 1 /\
  k ^ 2 = m /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := x3 * k * p * z * cn in
  x3 <> 0 /\
  x1 <> 0 /\
  q <> 0 /\
  z <> 0 /\
  1 + (x3 * k * p * z / (x1 * q * z)) ^ 2 * sn ^ 2 <> 0 /\
  x2 <> 0 /\
  k <> 0 /\
  r <> 0 /\
  G <> 0 /\
  dn ^ 2 + (x2 * k * z * r / (x1 * q * z)) ^ 2 * sn ^ 2 <> 0 /\
  G + t_1 <> 0 /\
  G / x3 ^ 2 + G * r ^ 2 / (x1 ^ 2 * x3 ^ 2) * (1 / (1 + (x3 * k * p * z / (x1 * q * z)) ^ 2 * sn ^
    2) + x3 * k * p * z * (x1 * q * z) / (x2 * k * z * r) / G * (x2 * k * z * r / (x1 * q * z) * cn
    / (dn ^ 2 + (x2 * k * z * r / (x1 * q * z)) ^ 2 * sn ^ 2))) <> ((x1 * q * z) ^ 2 / x1 ^ 2 + (x3
    * k * p * z) ^ 2 / x3 ^ 2 + G * t_1 / x3 ^ 2) / (G + t_1).
Proof.
  exists (sqrt (458290114816 / 9)), (4 / 5), (12 / 13), (25 / 39), (625 / 1521), 104, 672, 680, (3 /
    5), 153, 185, 697, (-2).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* With B31 not divided by G. *)

(* the angle's rate *)
Theorem errata_sign_of_the_angle_mutant_2 :
  exists G cn dn k m p q r sn x1 x2 x3 z : R,
  G ^ 2 = m * p ^ 4 * z ^ 2 + m * p ^ 2 * q ^ 2 * z ^ 2 + m * p ^ 2 * x1 ^ 2 * z ^ 2 + q ^ 2 * x1 ^
    2 * z ^ 2 /\
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (m * sn ^ 2) + 1 /\
  k ^ 2 = m /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := x3 * k * p * z * cn in
  x3 <> 0 /\
  x1 <> 0 /\
  q <> 0 /\
  z <> 0 /\
  1 + (x3 * k * p * z / (x1 * q * z)) ^ 2 * sn ^ 2 <> 0 /\
  x2 <> 0 /\
  k <> 0 /\
  r <> 0 /\
  dn ^ 2 + (x2 * k * z * r / (x1 * q * z)) ^ 2 * sn ^ 2 <> 0 /\
  G + t_1 <> 0 /\
  G / x3 ^ 2 + G * r ^ 2 / (x1 ^ 2 * x3 ^ 2) * (1 / (1 + (x3 * k * p * z / (x1 * q * z)) ^ 2 * sn ^
    2) + (- (x3 * k * p * z * (x1 * q * z) / (x2 * k * z * r))) * (x2 * k * z * r / (x1 * q * z) *
    cn / (dn ^ 2 + (x2 * k * z * r / (x1 * q * z)) ^ 2 * sn ^ 2))) <> ((x1 * q * z) ^ 2 / x1 ^ 2 +
    (x3 * k * p * z) ^ 2 / x3 ^ 2 + G * t_1 / x3 ^ 2) / (G + t_1).
Proof.
  exists (sqrt (458290114816 / 9)), (4 / 5), (12 / 13), (25 / 39), (625 / 1521), 104, 672, 680, (3 /
    5), 153, 185, 697, (-2).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.


(** errata-characteristic-on-the-separatrix: On the separatrix G⁴ / (B21² B23²) is one, so that an integral over one minus it divides by zero. *)

(* the characteristic *)
Theorem errata_characteristic_on_the_separatrix_1 :
  forall G I1 I2 I3 : R,
  I2 <> 0 ->
  I2 - I1 <> 0 ->
  I2 - I3 <> 0 ->
  G ^ 2 - G ^ 2 / I2 * I1 <> 0 ->
  G ^ 2 - G ^ 2 / I2 * I3 <> 0 ->
  (G ^ 2) ^ 2 / (I2 * (G ^ 2 - G ^ 2 / I2 * I1) / (I2 - I1) * (I2 * (G ^ 2 - G ^ 2 / I2 * I3) / (I2
    - I3))) = 1.
Proof.
  intros G I1 I2 I3   D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* With any energy. *)

(* the characteristic *)
Theorem errata_characteristic_on_the_separatrix_mutant_1 :
  exists G I1 I2 I3 T : R,
  I2 - I1 <> 0 /\
  I2 - I3 <> 0 /\
  I2 <> 0 /\
  G ^ 2 - T * 2 * I1 <> 0 /\
  G ^ 2 - T * 2 * I3 <> 0 /\
  (G ^ 2) ^ 2 / (I2 * (G ^ 2 - T * 2 * I1) / (I2 - I1) * (I2 * (G ^ 2 - T * 2 * I3) / (I2 - I3))) <>
    1.
Proof.
  exists 6, 1, (-3), 1, 7.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. computed.
Qed.


(** errata-acceleration: The rate of the spin (o1 cn, o2 sn, o3 dn) of λ t is λ (-o1 sn dn, o2 cn dn, -m o3 sn cn). *)

(* w', x *)
Theorem errata_acceleration_1 :
  forall dn lambda m o1 sn : R,
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  o1 * (- (sn * dn * lambda)) = o1 * (- (sn * dn)) * lambda.
Proof.
  intros dn lambda m o1 sn H_1  .
  rational.
Qed.

(* w', y *)
Theorem errata_acceleration_2 :
  forall cn dn lambda m o2 sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  o2 * (cn * dn * lambda) = o2 * (cn * dn) * lambda.
Proof.
  intros cn dn lambda m o2 sn H_1 H_2  .
  rational.
Qed.

(* w', z *)
Theorem errata_acceleration_3 :
  forall cn lambda m o3 sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  o3 * (- (m * (sn * cn * lambda))) = (- (o3 * m * sn * cn)) * lambda.
Proof.
  intros cn lambda m o3 sn H_1  .
  rational.
Qed.

(* With the first two exchanged. *)

(* w', x *)
Theorem errata_acceleration_mutant_1 :
  exists cn dn lambda m o1 sn : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (m * sn ^ 2) + 1 /\
  o1 * (- (sn * dn * lambda)) <> o1 * (cn * dn) * lambda.
Proof.
  exists (4 / 5), (12 / 13), 6, (625 / 1521), (-3), (3 / 5).
  split; [computed | ]. split; [computed | ]. 
  computed.
Qed.


(** errata-precession: Euler's angle φ, whose rate is M (I1 w1² + I2 w2²) / (M² - (I3 w3)²), gains (M / I3) (1 + I32 I31 / (I1 I32 + I3 I21 sn²)) along the motion. *)

(* the rate of the angle *)
Theorem errata_precession_1 :
  forall D I1 I2 I3 M cn sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  let t_1 := D / (I1 * (I3 - I1)) * cn ^ 2 in
  let t_2 := D / (I2 * (I3 - I2)) * sn ^ 2 in
  I3 <> 0 ->
  I1 * (I3 - I2) + I3 * (I2 - I1) * sn ^ 2 <> 0 ->
  I1 <> 0 ->
  I3 - I1 <> 0 ->
  I2 <> 0 ->
  I3 - I2 <> 0 ->
  I1 ^ 2 * t_1 + I2 ^ 2 * t_2 <> 0 ->
  M / I3 * (1 + (I3 - I2) * (I3 - I1) / (I1 * (I3 - I2) + I3 * (I2 - I1) * sn ^ 2)) = M * (I1 * t_1
    + I2 * t_2) / (I1 ^ 2 * t_1 + I2 ^ 2 * t_2).
Proof.
  intros D I1 I2 I3 M cn sn H_1 t_1 t_2 D_1 D_2 D_3 D_4 D_5 D_6 D_7.
  rational.
Qed.

(* With a minus before the quotient. *)

(* the rate of the angle *)
Theorem errata_precession_mutant_1 :
  exists D I1 I2 I3 M cn sn : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  let t_1 := D / (I1 * (I3 - I1)) * cn ^ 2 in
  let t_2 := D / (I2 * (I3 - I2)) * sn ^ 2 in
  I3 <> 0 /\
  I1 * (I3 - I2) + I3 * (I2 - I1) * sn ^ 2 <> 0 /\
  I1 <> 0 /\
  I3 - I1 <> 0 /\
  I2 <> 0 /\
  I3 - I2 <> 0 /\
  I1 ^ 2 * t_1 + I2 ^ 2 * t_2 <> 0 /\
  M / I3 * (1 - (I3 - I2) * (I3 - I1) / (I1 * (I3 - I2) + I3 * (I2 - I1) * sn ^ 2)) <> M * (I1 * t_1
    + I2 * t_2) / (I1 ^ 2 * t_1 + I2 ^ 2 * t_2).
Proof.
  exists (-1), (-2), 3, (-1), (5 / 2), (4 / 5), (3 / 5).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (8 / 25) computed.
  intros t_2; cut_to t_2 (3 / 100) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.
