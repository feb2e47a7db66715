(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.


(** symmetric-top: With I1 = I2 the spin circles the third axis at the rate (I3 - I1) w3 / I1: w1 = A cos, w2 = A sin, w3 constant. *)

(* w', x *)
Theorem symmetric_top_1 :
  forall A I1 I3 omega3 sin : R,
  I1 <> 0 ->
  A * (- ((I3 - I1) * omega3 / I1 * sin)) = (I1 - I3) * (A * sin * omega3) / I1.
Proof.
  intros A I1 I3 omega3 sin   D_1.
  rational.
Qed.

(* w', y *)
Theorem symmetric_top_2 :
  forall A I1 I3 cos omega3 sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  I1 <> 0 ->
  A * ((I3 - I1) * omega3 / I1 * cos) = (I3 - I1) * (omega3 * (A * cos)) / I1.
Proof.
  intros A I1 I3 cos omega3 sin H_1  D_1.
  rational.
Qed.

(* w', z *)
Theorem symmetric_top_3 :
  forall A I1 I3 cos sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  I3 <> 0 ->
  0 = (I1 - I1) * (A * cos * (A * sin)) / I3.
Proof.
  intros A I1 I3 cos sin H_1  D_1.
  rational.
Qed.

(* With the other way round. *)

(* w', x *)
Theorem symmetric_top_mutant_1 :
  exists A I1 I3 omega3 sin : R,
  I1 <> 0 /\
  A * (- ((- ((I3 - I1) * omega3 / I1)) * sin)) <> (I1 - I3) * (A * sin * omega3) / I1.
Proof.
  exists 6, 1, (-3), 1, (3 / 5).
  split; [computed | ]. computed.
Qed.

(* With a sign in Euler's equations. *)

(* w', y *)
Theorem symmetric_top_mutant_2 :
  exists A I1 I3 cos omega3 sin : R,
  cos ^ 2 = - sin ^ 2 + 1 /\
  I1 <> 0 /\
  A * ((I3 - I1) * omega3 / I1 * cos) <> - ((I3 - I1) * (omega3 * (A * cos)) / I1).
Proof.
  exists 6, 1, (-3), (4 / 5), 1, (3 / 5).
  split; [computed | ]. 
  split; [computed | ]. computed.
Qed.


(** separatrix: On the separatrix the spin is (A1 sech, w tanh, A3 sech) of w t sqrt((I2 - I1)(I3 - I2) / (I1 I3)), with A1 and A3 in closed form; then L² = 2 E I2. For every body with three different moments. *)

(* w', x *)
Theorem separatrix_1 :
  forall Omega p q r sech tanh x1 x2 x3 : R,
  sech ^ 2 = - tanh ^ 2 + 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := Omega * p * q / (x1 * x3) in
  x1 <> 0 ->
  r <> 0 ->
  x3 <> 0 ->
  (0 / (x1 * r) * sech + Omega * q * x2 / (x1 * r)) * (- (sech * tanh * t_1)) + 0 / (x1 * r) * sech
    * (sech * sech * t_1) = (x2 ^ 2 - x3 ^ 2) * (Omega * tanh * (Omega * p * x2 / (x3 * r) * sech))
    / x1 ^ 2.
Proof.
  intros Omega p q r sech tanh x1 x2 x3 H_1 H_2 H_3 H_4 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* w', y *)
Theorem separatrix_2 :
  forall Omega p q r sech tanh x1 x2 x3 : R,
  sech ^ 2 = - tanh ^ 2 + 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  x1 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  Omega * (sech * sech * (Omega * p * q / (x1 * x3))) = (x3 ^ 2 - x1 ^ 2) * (Omega * p * x2 / (x3 *
    r) * sech * (Omega * q * x2 / (x1 * r) * sech)) / x2 ^ 2.
Proof.
  intros Omega p q r sech tanh x1 x2 x3 H_1 H_2 H_3 H_4  D_1 D_2 D_3 D_4.
  rational.
Qed.

(* w', z *)
Theorem separatrix_3 :
  forall Omega p q r sech tanh x1 x2 x3 : R,
  sech ^ 2 = - tanh ^ 2 + 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := Omega * p * q / (x1 * x3) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  (0 / (x3 * r) * sech + Omega * p * x2 / (x3 * r)) * (- (sech * tanh * t_1)) + 0 / (x3 * r) * sech
    * (sech * sech * t_1) = (x1 ^ 2 - x2 ^ 2) * (Omega * q * x2 / (x1 * r) * sech * (Omega * tanh))
    / x3 ^ 2.
Proof.
  intros Omega p q r sech tanh x1 x2 x3 H_1 H_2 H_3 H_4 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* L² - 2 E I2 *)
Theorem separatrix_4 :
  forall Omega p q r sech tanh x1 x2 x3 : R,
  sech ^ 2 = - tanh ^ 2 + 1 ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := Omega * q * x2 / (x1 * r) * sech in
  let t_2 := Omega * p * x2 / (x3 * r) * sech in
  x1 <> 0 ->
  r <> 0 ->
  x3 <> 0 ->
  x1 ^ 2 * t_1 * (x1 ^ 2 * t_1) + x2 ^ 2 * (Omega * tanh) * (x2 ^ 2 * (Omega * tanh)) + x3 ^ 2 * t_2
    * (x3 ^ 2 * t_2) - (t_1 * (x1 ^ 2 * t_1) + Omega * tanh * (x2 ^ 2 * (Omega * tanh)) + t_2 * (x3
    ^ 2 * t_2)) / 2 * x2 ^ 2 * 2 = 0.
Proof.
  intros Omega p q r sech tanh x1 x2 x3 H_1 H_2 H_3 H_4 t_1 t_2 D_1 D_2 D_3.
  rational.
Qed.

(* With one amplitude with the wrong sign. *)

(* w', x *)
Theorem separatrix_mutant_1 :
  exists Omega p q r sech tanh x1 x2 x3 : R,
  sech ^ 2 = - tanh ^ 2 + 1 /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := Omega * p * q / (x1 * x3) in
  x1 <> 0 /\
  r <> 0 /\
  x3 <> 0 /\
  ((- (0 / (x1 * r))) * sech - Omega * q * x2 / (x1 * r)) * (- (sech * tanh * t_1)) + (- (0 / (x1 *
    r))) * sech * (sech * sech * t_1) <> (x2 ^ 2 - x3 ^ 2) * (Omega * tanh * (Omega * p * x2 / (x3 *
    r) * sech)) / x1 ^ 2.
Proof.
  exists 6, 104, 672, 680, (4 / 5), (3 / 5), 153, 185, 697.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. 
  intros t_1; cut_to t_1 (46592 / 11849) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With a sign in Euler's equations. *)

(* w', y *)
Theorem separatrix_mutant_2 :
  exists Omega p q r sech tanh x1 x2 x3 : R,
  sech ^ 2 = - tanh ^ 2 + 1 /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  x1 <> 0 /\
  x3 <> 0 /\
  r <> 0 /\
  x2 <> 0 /\
  Omega * (sech * sech * (Omega * p * q / (x1 * x3))) <> - ((x3 ^ 2 - x1 ^ 2) * (Omega * p * x2 /
    (x3 * r) * sech * (Omega * q * x2 / (x1 * r) * sech)) / x2 ^ 2).
Proof.
  exists 6, 104, 672, 680, (4 / 5), (3 / 5), 153, 185, 697.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. 
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** circling-the-largest-axis: Off the separatrix, on the side of the largest moment, the spin is (A1 cn, A2 sn, A3 dn), with amplitudes, rate and parameter in closed form. For every body with three different moments. *)

(* w', x *)
Theorem circling_the_largest_axis_1 :
  forall Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := q * Q / (x1 * x2 * x3) in
  p <> 0 ->
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  q <> 0 ->
  0 / p / (x1 * r) * cn * (cn * dn * t_1) + (0 / p / (x1 * r) * cn + k * Q * q / p / (x1 * r)) * (-
    (sn * dn * t_1)) + 0 / p / (x1 * r) * cn * (- (m * (sn * cn * t_1))) = (x2 ^ 2 - x3 ^ 2) * (k *
    Q * q / p / (x2 * q) * sn * (Q / (x3 * r) * dn)) / x1 ^ 2.
Proof.
  intros Q cn dn k m p q r sn x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* w', y *)
Theorem circling_the_largest_axis_2 :
  forall Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := q * Q / (x1 * x2 * x3) in
  p <> 0 ->
  x2 <> 0 ->
  q <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  (0 / p / (x2 * q) * sn + k * Q * q / p / (x2 * q)) * (cn * dn * t_1) + 0 / p / (x2 * q) * sn * (-
    (sn * dn * t_1)) + 0 / p / (x2 * q) * sn * (- (m * (sn * cn * t_1))) = (x3 ^ 2 - x1 ^ 2) * (Q /
    (x3 * r) * dn * (k * Q * q / p / (x1 * r) * cn)) / x2 ^ 2.
Proof.
  intros Q cn dn k m p q r sn x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* w', z *)
Theorem circling_the_largest_axis_3 :
  forall Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := q * Q / (x1 * x2 * x3) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  p <> 0 ->
  q <> 0 ->
  0 / (x3 * r) * dn * (cn * dn * t_1) + 0 / (x3 * r) * dn * (- (sn * dn * t_1)) + (0 / (x3 * r) * dn
    + Q / (x3 * r)) * (- (m * (sn * cn * t_1))) = (x1 ^ 2 - x2 ^ 2) * (k * Q * q / p / (x1 * r) * cn
    * (k * Q * q / p / (x2 * q) * sn)) / x3 ^ 2.
Proof.
  intros Q cn dn k m p q r sn x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* With the rate reversed. *)

(* w', x *)
Theorem circling_the_largest_axis_mutant_1 :
  exists Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (m * sn ^ 2) + 1 /\
  k ^ 2 = m /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := - (q * Q / (x1 * x2 * x3)) in
  p <> 0 /\
  x1 <> 0 /\
  r <> 0 /\
  x2 <> 0 /\
  x3 <> 0 /\
  q <> 0 /\
  0 / p / (x1 * r) * cn * (cn * dn * t_1) + (0 / p / (x1 * r) * cn + k * Q * q / p / (x1 * r)) * (-
    (sn * dn * t_1)) + 0 / p / (x1 * r) * cn * (- (m * (sn * cn * t_1))) <> (x2 ^ 2 - x3 ^ 2) * (k *
    Q * q / p / (x2 * q) * sn * (Q / (x3 * r) * dn)) / x1 ^ 2.
Proof.
  exists 6, (4 / 5), (12 / 13), (25 / 39), (625 / 1521), 104, 672, 680, (3 / 5), 153, 185, 697.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. 
  intros t_1; cut_to t_1 (-448 / 2192065) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. computed.
Qed.

(* With a sign in Euler's equations. *)

(* w', y *)
Theorem circling_the_largest_axis_mutant_2 :
  exists Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (m * sn ^ 2) + 1 /\
  k ^ 2 = m /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := q * Q / (x1 * x2 * x3) in
  p <> 0 /\
  x2 <> 0 /\
  q <> 0 /\
  x1 <> 0 /\
  x3 <> 0 /\
  r <> 0 /\
  (0 / p / (x2 * q) * sn + k * Q * q / p / (x2 * q)) * (cn * dn * t_1) + 0 / p / (x2 * q) * sn * (-
    (sn * dn * t_1)) + 0 / p / (x2 * q) * sn * (- (m * (sn * cn * t_1))) <> - ((x3 ^ 2 - x1 ^ 2) *
    (Q / (x3 * r) * dn * (k * Q * q / p / (x1 * r) * cn)) / x2 ^ 2).
Proof.
  exists 6, (4 / 5), (12 / 13), (25 / 39), (625 / 1521), 104, 672, 680, (3 / 5), 153, 185, 697.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. 
  intros t_1; cut_to t_1 (448 / 2192065) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. computed.
Qed.


(** circling-the-smallest-axis: On the side of the smallest moment the spin is (A1 dn, A2 sn, A3 cn), the same with the two ends exchanged. *)

(* w', x *)
Theorem circling_the_smallest_axis_1 :
  forall Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := p * Q / (x1 * x2 * x3) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  q <> 0 ->
  p <> 0 ->
  0 / (x1 * r) * dn * (cn * dn * t_1) + 0 / (x1 * r) * dn * (- (sn * dn * t_1)) + (0 / (x1 * r) * dn
    + Q / (x1 * r)) * (- (m * (sn * cn * t_1))) = (x2 ^ 2 - x3 ^ 2) * (k * Q * p / q / (x2 * p) * sn
    * (k * Q * p / q / (x3 * r) * cn)) / x1 ^ 2.
Proof.
  intros Q cn dn k m p q r sn x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* w', y *)
Theorem circling_the_smallest_axis_2 :
  forall Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := p * Q / (x1 * x2 * x3) in
  q <> 0 ->
  x2 <> 0 ->
  p <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  (0 / q / (x2 * p) * sn + k * Q * p / q / (x2 * p)) * (cn * dn * t_1) + 0 / q / (x2 * p) * sn * (-
    (sn * dn * t_1)) + 0 / q / (x2 * p) * sn * (- (m * (sn * cn * t_1))) = (x3 ^ 2 - x1 ^ 2) * (k *
    Q * p / q / (x3 * r) * cn * (Q / (x1 * r) * dn)) / x2 ^ 2.
Proof.
  intros Q cn dn k m p q r sn x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* w', z *)
Theorem circling_the_smallest_axis_3 :
  forall Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  k ^ 2 = m ->
  x2 ^ 2 = p ^ 2 + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  let t_1 := p * Q / (x1 * x2 * x3) in
  q <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  p <> 0 ->
  0 / q / (x3 * r) * cn * (cn * dn * t_1) + (0 / q / (x3 * r) * cn + k * Q * p / q / (x3 * r)) * (-
    (sn * dn * t_1)) + 0 / q / (x3 * r) * cn * (- (m * (sn * cn * t_1))) = (x1 ^ 2 - x2 ^ 2) * (Q /
    (x1 * r) * dn * (k * Q * p / q / (x2 * p) * sn)) / x3 ^ 2.
Proof.
  intros Q cn dn k m p q r sn x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 t_1 D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* With the rate reversed. *)

(* w', x *)
Theorem circling_the_smallest_axis_mutant_1 :
  exists Q cn dn k m p q r sn x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (m * sn ^ 2) + 1 /\
  k ^ 2 = m /\
  x2 ^ 2 = p ^ 2 + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 + q ^ 2 + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  let t_1 := - (p * Q / (x1 * x2 * x3)) in
  x1 <> 0 /\
  r <> 0 /\
  x2 <> 0 /\
  x3 <> 0 /\
  q <> 0 /\
  p <> 0 /\
  0 / (x1 * r) * dn * (cn * dn * t_1) + 0 / (x1 * r) * dn * (- (sn * dn * t_1)) + (0 / (x1 * r) * dn
    + Q / (x1 * r)) * (- (m * (sn * cn * t_1))) <> (x2 ^ 2 - x3 ^ 2) * (k * Q * p / q / (x2 * p) *
    sn * (k * Q * p / q / (x3 * r) * cn)) / x1 ^ 2.
Proof.
  exists 6, (4 / 5), (12 / 13), (25 / 39), (625 / 1521), 104, 672, 680, (3 / 5), 153, 185, 697.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. 
  intros t_1; cut_to t_1 (-208 / 6576195) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. computed.
Qed.


(** which-side: L² - 2 E I2 = I3 (I3 - I2) w3² - I1 (I2 - I1) w1²: the sum of one positive and one negative square that says which end the spin circles; likewise 2 E I3 - L² and L² - 2 E I1 are sums of positive squares. *)

(* L² - 2 E I2 *)
Theorem which_side_1 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I1 * omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3) - (omega1
    * (I1 * omega1) + omega2 * (I2 * omega2) + omega3 * (I3 * omega3)) / 2 * 2 * I2 = I3 * (I3 - I2)
    * omega3 ^ 2 - I1 * (I2 - I1) * omega1 ^ 2.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   .
  rational.
Qed.

(* 2 E I3 - L² *)
Theorem which_side_2 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  (omega1 * (I1 * omega1) + omega2 * (I2 * omega2) + omega3 * (I3 * omega3)) / 2 * 2 * I3 - (I1 *
    omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3)) = I1 * (I3 -
    I1) * omega1 ^ 2 + I2 * (I3 - I2) * omega2 ^ 2.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   .
  rational.
Qed.

(* L² - 2 E I1 *)
Theorem which_side_3 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I1 * omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3) - (omega1
    * (I1 * omega1) + omega2 * (I2 * omega2) + omega3 * (I3 * omega3)) / 2 * 2 * I1 = I2 * (I2 - I1)
    * omega2 ^ 2 + I3 * (I3 - I1) * omega3 ^ 2.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   .
  rational.
Qed.

(* With a plus between the squares. *)

(* L² - 2 E I2 *)
Theorem which_side_mutant_1 :
  exists I1 I2 I3 omega1 omega2 omega3 : R,
  I1 * omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3) - (omega1
    * (I1 * omega1) + omega2 * (I2 * omega2) + omega3 * (I3 * omega3)) / 2 * 2 * I2 <> I3 * (I3 -
    I2) * omega3 ^ 2 + I1 * (I2 - I1) * omega1 ^ 2.
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  computed.
Qed.


(** jacobi-by-thetas: With sn, cn and dn as quotients of theta functions, sn² + cn² = 1 and dn² + k² sn² = 1, and sn' is a constant times cn dn. The other two rates follow. For every nome. *)

(* m² + n² *)
Theorem jacobi_by_thetas_1 :
  forall r s : R,
  ((r + s) / 2) ^ 2 + ((r - s) / 2) ^ 2 = (r ^ 2 + s ^ 2) / 2.
Proof.
  intros r s   .
  rational.
Qed.

(* (n + 1/2)² *)
Theorem jacobi_by_thetas_2 :
  forall n : R,
  (n + (1 / 2)) ^ 2 = n ^ 2 + n + (1 / 4).
Proof.
  intros n   .
  rational.
Qed.

(* (n + 1)² *)
Theorem jacobi_by_thetas_3 :
  forall n : R,
  (n + 1) ^ 2 = n ^ 2 + 2 * n + 1.
Proof.
  intros n   .
  rational.
Qed.

(* sn² + cn² *)
Theorem jacobi_by_thetas_4 :
  forall A B U V : R,
  A * B + B * A <> 0 ->
  A * U - B * V <> 0 ->
  (A * A + B * B) / (A * B + B * A) * (B * U - A * V) / (A * U - B * V) + (A * A - B * B) / (A * B +
    B * A) * (A * V + B * U) / (A * U - B * V) = 1.
Proof.
  intros A B U V   D_1 D_2.
  rational.
Qed.

(* dn² + k² sn² *)
Theorem jacobi_by_thetas_5 :
  forall A B U V : R,
  A * A + B * B <> 0 ->
  A * U - B * V <> 0 ->
  A * B + B * A <> 0 ->
  (A * A - B * B) / (A * A + B * B) * (A * U + B * V) / (A * U - B * V) + (A * B + B * A) ^ 2 / (A *
    A + B * B) ^ 2 * ((A * A + B * B) / (A * B + B * A) * (B * U - A * V) / (A * U - B * V)) = 1.
Proof.
  intros A B U V   D_1 D_2 D_3.
  rational.
Qed.

(* With a sign in a square. *)

(* sn² + cn² *)
Theorem jacobi_by_thetas_mutant_1 :
  exists A B U V : R,
  A * B + B * A <> 0 /\
  A * U + B * V <> 0 /\
  (A * A + B * B) / (A * B + B * A) * (B * U - A * V) / (A * U + B * V) + (A * A + B * B) / (A * B +
    B * A) * (A * V + B * U) / (A * U + B * V) <> 1.
Proof.
  exists 6, 1, (-3), 1.
  split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With another theta function above. *)

(* sn' *)
Theorem jacobi_by_thetas_mutant_2 :
  16 <> 0.
Proof.
  computed.
Qed.


(** attitude-by-thetas: Of a = theta4(z + w) and b = theta1(z - w) with the square of the nome, a conj(a), b conj(b) and conj(a) b are sums of two products of Jacobi's thetas of z and of w: a constant times 1 + dn/dn(w), 1 - dn/dn(w), and sn cn(w) - cn sn(w). For every nome and every zero. *)

(* m² + n² *)
Theorem attitude_by_thetas_1 :
  forall r s : R,
  ((r + s) / 2) ^ 2 + ((r - s) / 2) ^ 2 = (r ^ 2 + s ^ 2) / 2.
Proof.
  intros r s   .
  rational.
Qed.

(* (n + 1/2)² *)
Theorem attitude_by_thetas_2 :
  forall n : R,
  (n + (1 / 2)) ^ 2 = n ^ 2 + n + (1 / 4).
Proof.
  intros n   .
  rational.
Qed.

(* (n + 1)² *)
Theorem attitude_by_thetas_3 :
  forall n : R,
  (n + 1) ^ 2 = n ^ 2 + 2 * n + 1.
Proof.
  intros n   .
  rational.
Qed.

(* With a plus between the two products. *)

(* b conj(b) *)
Theorem attitude_by_thetas_mutant_1 :
  exists r s : R,
  let t_1 := (-2) + s ^ 2 * 2 + s ^ 4 * (-2) + s ^ 6 * 2 + r ^ 2 * (-2) + r ^ 2 * s ^ 2 * 2 + r ^ 2
    * s ^ 4 * (-2) + r ^ 2 * s ^ 6 * 2 + r ^ 4 * (-2) + r ^ 4 * s ^ 2 * 2 + r ^ 4 * s ^ 4 * (-2) + r
    ^ 4 * s ^ 6 * 2 + r ^ 6 * (-2) + r ^ 6 * s ^ 2 * 2 + r ^ 6 * s ^ 4 * (-2) + r ^ 6 * s ^ 6 * 2 in
  t_1 <> 0.
Proof.
  exists (7 / 2), 2.
  intros t_1; cut_to t_1 (6533151 / 32) computed.
  computed.
Qed.


(** attitude-by-complementary-thetas: The same of theta2 and theta1 with the root of the complementary nome: the same three products. *)

(* m² + n² *)
Theorem attitude_by_complementary_thetas_1 :
  forall r s : R,
  ((r + s) / 2) ^ 2 + ((r - s) / 2) ^ 2 = (r ^ 2 + s ^ 2) / 2.
Proof.
  intros r s   .
  rational.
Qed.

(* (n + 1/2)² *)
Theorem attitude_by_complementary_thetas_2 :
  forall n : R,
  (n + (1 / 2)) ^ 2 = n ^ 2 + n + (1 / 4).
Proof.
  intros n   .
  rational.
Qed.

(* (n + 1)² *)
Theorem attitude_by_complementary_thetas_3 :
  forall n : R,
  (n + 1) ^ 2 = n ^ 2 + 2 * n + 1.
Proof.
  intros n   .
  rational.
Qed.

(* With the theta of the direct series. *)

(* a conj(a) *)
Theorem attitude_by_complementary_thetas_mutant_1 :
  exists r s : R,
  1 - s ^ 2 + s ^ 4 - s ^ 6 - r ^ 2 - r ^ 2 * s ^ 2 - r ^ 2 * s ^ 4 - r ^ 2 * s ^ 6 + r ^ 4 - r ^ 4
    * s ^ 2 + r ^ 4 * s ^ 4 - r ^ 4 * s ^ 6 - r ^ 6 - r ^ 6 * s ^ 2 - r ^ 6 * s ^ 4 - r ^ 6 * s ^ 6
    <> 0.
Proof.
  exists 6, 1.
  computed.
Qed.


(** half-periods: Over half a period a stays and b changes its sign; in the complementary series both also turn by one angle. From flip to saddle theta1 and theta4, theta2 and theta3 change places. *)

(* m² + n² *)
Theorem half_periods_1 :
  forall r s : R,
  ((r + s) / 2) ^ 2 + ((r - s) / 2) ^ 2 = (r ^ 2 + s ^ 2) / 2.
Proof.
  intros r s   .
  rational.
Qed.

(* (n + 1/2)² *)
Theorem half_periods_2 :
  forall n : R,
  (n + (1 / 2)) ^ 2 = n ^ 2 + n + (1 / 4).
Proof.
  intros n   .
  rational.
Qed.

(* (n + 1)² *)
Theorem half_periods_3 :
  forall n : R,
  (n + 1) ^ 2 = n ^ 2 + 2 * n + 1.
Proof.
  intros n   .
  rational.
Qed.

(* With b without alternating signs. *)

(* the same, complementary, b *)
Theorem half_periods_mutant_1 :
  1 <> (-1).
Proof.
  computed.
Qed.


(** klein-momentum: The quaternion a + b j, with a conj(a), b conj(b) and conj(a) b as the theta functions make them, takes the momentum of the closed form to the first axis. For every body, about either axis, in either sense. *)

(* w' *)
Theorem klein_momentum_1 :
  forall Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q * Q / (x1 * x2 * x3) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1))
    + (sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_1)) =
    (x1 ^ 2 - x2 ^ 2) * (h * q * Q / (x1 * r) * cn * (h * Q / x2 * sn)) / x3 ^ 2.
Proof.
  intros Q cn dn h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* w' *)
Theorem klein_momentum_2 :
  forall Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q * Q / (x1 * x2 * x3) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  0 / (x1 * r) * cn * (cn * dn * t_1) + (0 / (x1 * r) * cn + h * q * Q / (x1 * r)) * (- (sn * dn *
    t_1)) + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * cn * t_1)) = (x2 ^ 2 - x3 ^ 2) * (h * Q /
    x2 * sn * (sigma * (Q / (x3 * r)) * dn)) / x1 ^ 2.
Proof.
  intros Q cn dn h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* w' *)
Theorem klein_momentum_3 :
  forall Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q * Q / (x1 * x2 * x3) in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  (0 / x2 * sn + h * Q / x2) * (cn * dn * t_1) + 0 / x2 * sn * (- (sn * dn * t_1)) + 0 / x2 * sn *
    (- (h ^ 2 * p ^ 2 * sn * cn * t_1)) = (x3 ^ 2 - x1 ^ 2) * (sigma * (Q / (x3 * r)) * dn * (h * q
    * Q / (x1 * r) * cn)) / x2 ^ 2.
Proof.
  intros Q cn dn h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* 2E *)
Theorem klein_momentum_4 :
  forall Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (Q / (x3 * r)) * dn in
  let t_2 := h * q * Q / (x1 * r) * cn in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  (t_1 * (x3 ^ 2 * t_1) + t_2 * (x1 ^ 2 * t_2) + h * Q / x2 * sn * (x2 ^ 2 * (h * Q / x2 * sn))) / 2
    * 2 = Q ^ 2 * (1 + h ^ 2 * q ^ 2) / r ^ 2.
Proof.
  intros Q cn dn h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* L² *)
Theorem klein_momentum_5 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := x3 ^ 2 * (sigma * (Q / (x3 * r)) * dn) in
  let t_2 := x1 ^ 2 * (h * q * Q / (x1 * r) * cn) in
  let t_3 := x2 ^ 2 * (h * Q / x2 * sn) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  t_1 * t_1 + t_2 * t_2 + t_3 * t_3 = (Q * e / r) ^ 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 D_1 D_2
    D_3 D_4.
  rational.
Qed.

(* the momentum *)
Theorem klein_momentum_6 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * (1 / 2) * h * x1 * q / e * cn in
  let t_3 := sigma * (1 / 2) * h * x2 * r / e * sn in
  e <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  Q <> 0 ->
  t_1 * t_1 + t_2 * (- t_2) - t_3 * t_3 = x3 ^ 2 * (sigma * (Q / (x3 * r)) * dn) * (t_1 * sigma / (Q
    * e / r)).
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 D_1 D_2
    D_3 D_4.
  rational.
Qed.

(* the momentum *)
Theorem klein_momentum_7 :
  forall Q cn dn e h p q r sigma sn tau x1 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * (1 / 2) * h * x1 * q / e * cn in
  e <> 0 ->
  x1 <> 0 ->
  r <> 0 ->
  Q <> 0 ->
  - (t_1 * (- t_2)) + t_2 * t_1 = x1 ^ 2 * (h * q * Q / (x1 * r) * cn) * (t_1 * sigma / (Q * e /
    r)).
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* the momentum *)
Theorem klein_momentum_8 :
  forall Q dn e h p q r sigma sn tau x1 x2 x3 : R,
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * (1 / 2) * h * x2 * r / e * sn in
  e <> 0 ->
  x2 <> 0 ->
  r <> 0 ->
  Q <> 0 ->
  t_1 * t_2 + t_2 * t_1 = x2 ^ 2 * (h * Q / x2 * sn) * (t_1 * sigma / (Q * e / r)).
Proof.
  intros Q dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* w' *)
Theorem klein_momentum_9 :
  forall Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1))
    + (sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_1)) =
    (x2 ^ 2 - x1 ^ 2) * (h * Q / x2 * sn * (h * q * Q / (x1 * r) * cn)) / x3 ^ 2.
Proof.
  intros Q cn dn h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* w' *)
Theorem klein_momentum_10 :
  forall Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  (0 / x2 * sn + h * Q / x2) * (cn * dn * t_1) + 0 / x2 * sn * (- (sn * dn * t_1)) + 0 / x2 * sn *
    (- (h ^ 2 * p ^ 2 * sn * cn * t_1)) = (x1 ^ 2 - x3 ^ 2) * (h * q * Q / (x1 * r) * cn * (sigma *
    (Q / (x3 * r)) * dn)) / x2 ^ 2.
Proof.
  intros Q cn dn h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* w' *)
Theorem klein_momentum_11 :
  forall Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  0 / (x1 * r) * cn * (cn * dn * t_1) + (0 / (x1 * r) * cn + h * q * Q / (x1 * r)) * (- (sn * dn *
    t_1)) + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * cn * t_1)) = (x3 ^ 2 - x2 ^ 2) * (sigma *
    (Q / (x3 * r)) * dn * (h * Q / x2 * sn)) / x1 ^ 2.
Proof.
  intros Q cn dn h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* 2E *)
Theorem klein_momentum_12 :
  forall Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (Q / (x3 * r)) * dn in
  let t_2 := h * q * Q / (x1 * r) * cn in
  x3 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x1 <> 0 ->
  (t_1 * (x3 ^ 2 * t_1) + h * Q / x2 * sn * (x2 ^ 2 * (h * Q / x2 * sn)) + t_2 * (x1 ^ 2 * t_2)) / 2
    * 2 = Q ^ 2 * (1 + h ^ 2 * q ^ 2) / r ^ 2.
Proof.
  intros Q cn dn h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* L² *)
Theorem klein_momentum_13 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := x3 ^ 2 * (sigma * (Q / (x3 * r)) * dn) in
  let t_2 := x2 ^ 2 * (h * Q / x2 * sn) in
  let t_3 := x1 ^ 2 * (h * q * Q / (x1 * r) * cn) in
  x3 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x1 <> 0 ->
  t_1 * t_1 + t_2 * t_2 + t_3 * t_3 = (Q * e / r) ^ 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 D_1 D_2
    D_3 D_4.
  rational.
Qed.

(* the momentum *)
Theorem klein_momentum_14 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * (1 / 2) * h * x2 * r / e * sn in
  let t_3 := sigma * (1 / 2) * h * x1 * q / e * cn in
  e <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  Q <> 0 ->
  t_1 * t_1 + t_2 * (- t_2) - t_3 * t_3 = x3 ^ 2 * (sigma * (Q / (x3 * r)) * dn) * (t_1 * sigma / (Q
    * e / r)).
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 D_1 D_2
    D_3 D_4.
  rational.
Qed.

(* the momentum *)
Theorem klein_momentum_15 :
  forall Q dn e h p q r sigma sn tau x1 x2 x3 : R,
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * (1 / 2) * h * x2 * r / e * sn in
  e <> 0 ->
  x2 <> 0 ->
  r <> 0 ->
  Q <> 0 ->
  - (t_1 * (- t_2)) + t_2 * t_1 = x2 ^ 2 * (h * Q / x2 * sn) * (t_1 * sigma / (Q * e / r)).
Proof.
  intros Q dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* the momentum *)
Theorem klein_momentum_16 :
  forall Q cn dn e h p q r sigma sn tau x1 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * (1 / 2) * h * x1 * q / e * cn in
  e <> 0 ->
  x1 <> 0 ->
  r <> 0 ->
  Q <> 0 ->
  t_1 * t_2 + t_2 * t_1 = x1 ^ 2 * (h * q * Q / (x1 * r) * cn) * (t_1 * sigma / (Q * e / r)).
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 D_1 D_2 D_3 D_4.
  rational.
Qed.

(* With the zero on the other side. *)

(* the momentum *)
Theorem klein_momentum_mutant_1 :
  exists Q cn dn e h p q r sigma sn tau x1 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 /\
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 /\
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  sigma ^ 2 = 1 /\
  tau ^ 2 = 1 /\
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * (1 / 2) * h * x1 * q / e * cn in
  e <> 0 /\
  x1 <> 0 /\
  r <> 0 /\
  Q <> 0 /\
  - (t_1 * t_2) + (- t_2) * t_1 <> x1 ^ 2 * (h * q * Q / (x1 * r) * cn) * (t_1 * sigma / (Q * e /
    r)).
Proof.
  exists (7 / 5), (-4 / 5), (sqrt (14329 / 15625)), (sqrt (11296 / 15625)), (-3 / 5), (-4 / 5), (-2
    / 5), (sqrt (4 / 5)), 1, (-3 / 5), (-1), (6 / 5), (4 / 5).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* With a sign in Euler's equations. *)

(* w' *)
Theorem klein_momentum_mutant_2 :
  exists Q cn dn h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 /\
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  sigma ^ 2 = 1 /\
  tau ^ 2 = 1 /\
  let t_1 := - (sigma * tau * q * Q / (x1 * x2 * x3)) in
  x3 <> 0 /\
  r <> 0 /\
  x1 <> 0 /\
  x2 <> 0 /\
  sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1))
    + (sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_1))
    <> (x1 ^ 2 - x2 ^ 2) * (h * q * Q / (x1 * r) * cn * (h * Q / x2 * sn)) / x3 ^ 2.
Proof.
  exists (7 / 5), (-4 / 5), (sqrt (14329 / 15625)), (-3 / 5), (-4 / 5), (-2 / 5), (sqrt (4 / 5)), 1,
    (-3 / 5), (-1), (6 / 5), (sqrt (4 / 5)), (4 / 5).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.


(** klein-attitude: Turned by half the angle about the momentum, which is a theta function's angle and a steady drift, a + b j satisfies q' = q w/2. For every body, about either axis, in either sense. *)

(* q' *)
Theorem klein_attitude_1 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_3 := - (x1 * q * x2 * r * h ^ 2 / e ^ 2) in
  e <> 0 ->
  r <> 0 ->
  x3 <> 0 ->
  Q * e / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  1 + x3 / e <> 0 ->
  1 + dn * (x3 / e) <> 0 ->
  t_1 * ((sigma * (Q ^ 2 * (1 + h ^ 2 * q ^ 2) / r ^ 2 + Q * e / r * (Q / (x3 * r))) / (Q * e / r +
    x3 ^ 2 * (Q / (x3 * r))) - t_2 * t_3 / (1 + x3 / e) + t_2 * dn * t_3 / (1 + dn * (x3 / e))) / 2)
    = (t_1 * (sigma * (Q / (x3 * r)) * dn) + sigma * (1 / 2) * h * x2 * r / e * sn * (h * Q / x2 *
    sn) - (- (sigma * (1 / 2) * h * x1 * q / e * cn)) * (h * q * Q / (x1 * r) * cn)) / 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 D_1 D_2
    D_3 D_4 D_5 D_6 D_7 D_8.
  rational.
Qed.

(* q' *)
Theorem klein_attitude_2 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (1 / 2) * h * x2 * r / e in
  let t_2 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_3 := - (h ^ 2 * p ^ 2 * sn * cn * t_2) in
  let t_4 := (1 + dn * (x3 / e)) / 2 in
  let t_5 := sigma * (1 / 2) * h * x1 * q / e * cn in
  let t_6 := - (x1 * q * x2 * r * h ^ 2 / e ^ 2) in
  let t_7 := (0 / e * sn + t_1) * (cn * dn * t_2) + 0 / e * sn * (- (sn * dn * t_2)) + 0 / e * sn *
    t_3 - t_1 * sn * ((dn * (0 / e) / 2 * (cn * dn * t_2) + dn * (0 / e) / 2 * (- (sn * dn * t_2)) +
    (x3 / e + dn * (0 / e)) / 2 * t_3) / (t_4 * 2)) + t_5 * ((sigma * (Q ^ 2 * (1 + h ^ 2 * q ^ 2) /
    r ^ 2 + Q * e / r * (Q / (x3 * r))) / (Q * e / r + x3 ^ 2 * (Q / (x3 * r))) - t_2 * t_6 / (1 +
    x3 / e) + t_2 * dn * t_6 / (1 + dn * (x3 / e))) / 2) in
  e <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  1 + dn * (x3 / e) <> 0 ->
  r <> 0 ->
  Q * e / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 ->
  1 + x3 / e <> 0 ->
  t_7 = (t_4 * (h * q * Q / (x1 * r) * cn) + (- t_5) * (sigma * (Q / (x3 * r)) * dn)) / 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 D_1 D_2 D_3 D_4 D_5 D_6 D_7 D_8.
  rational.
Qed.

(* q' *)
Theorem klein_attitude_3 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_2 := sigma * (1 / 2) * h * x1 * q / e in
  let t_3 := - (h ^ 2 * p ^ 2 * sn * cn * t_1) in
  let t_4 := (1 + dn * (x3 / e)) / 2 in
  let t_5 := sigma * (1 / 2) * h * x2 * r / e * sn in
  let t_6 := - (x1 * q * x2 * r * h ^ 2 / e ^ 2) in
  let t_7 := (- (0 / e * cn)) * (cn * dn * t_1) + (- (0 / e * cn + t_2)) * (- (sn * dn * t_1)) + (-
    (0 / e * cn)) * t_3 - (- (t_2 * cn)) * ((dn * (0 / e) / 2 * (cn * dn * t_1) + dn * (0 / e) / 2 *
    (- (sn * dn * t_1)) + (x3 / e + dn * (0 / e)) / 2 * t_3) / (t_4 * 2)) + t_5 * ((sigma * (Q ^ 2 *
    (1 + h ^ 2 * q ^ 2) / r ^ 2 + Q * e / r * (Q / (x3 * r))) / (Q * e / r + x3 ^ 2 * (Q / (x3 *
    r))) - t_1 * t_6 / (1 + x3 / e) + t_1 * dn * t_6 / (1 + dn * (x3 / e))) / 2) in
  e <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  1 + dn * (x3 / e) <> 0 ->
  r <> 0 ->
  Q * e / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 ->
  1 + x3 / e <> 0 ->
  t_7 = (t_4 * (h * Q / x2 * sn) - t_5 * (sigma * (Q / (x3 * r)) * dn)) / 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 D_1 D_2 D_3 D_4 D_5 D_6 D_7 D_8.
  rational.
Qed.

(* q' *)
Theorem klein_attitude_4 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_2 := - (h ^ 2 * p ^ 2 * sn * cn * t_1) in
  let t_3 := (1 + dn * (x3 / e)) / 2 in
  e <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  1 + dn * (x3 / e) <> 0 ->
  r <> 0 ->
  dn * (0 / e) / 2 * (cn * dn * t_1) + dn * (0 / e) / 2 * (- (sn * dn * t_1)) + (x3 / e + dn * (0 /
    e)) / 2 * t_2 - t_3 * ((dn * (0 / e) / 2 * (cn * dn * t_1) + dn * (0 / e) / 2 * (- (sn * dn *
    t_1)) + (x3 / e + dn * (0 / e)) / 2 * t_2) / (t_3 * 2)) = (- (sigma * (1 / 2) * h * x2 * r / e *
    sn * (h * q * Q / (x1 * r) * cn)) - (- (sigma * (1 / 2) * h * x1 * q / e * cn)) * (h * Q / x2 *
    sn)) / 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 D_1 D_2
    D_3 D_4 D_5 D_6.
  rational.
Qed.

(* q' *)
Theorem klein_attitude_5 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_3 := - (x1 * q * x2 * r * h ^ 2 / e ^ 2) in
  e <> 0 ->
  r <> 0 ->
  x3 <> 0 ->
  Q * e / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  1 + x3 / e <> 0 ->
  1 + dn * (x3 / e) <> 0 ->
  t_1 * ((sigma * (Q ^ 2 * (1 + h ^ 2 * q ^ 2) / r ^ 2 + Q * e / r * (Q / (x3 * r))) / (Q * e / r +
    x3 ^ 2 * (Q / (x3 * r))) - (- t_2) * t_3 / (1 + x3 / e) + (- t_2) * dn * t_3 / (1 + dn * (x3 /
    e))) / 2) = (t_1 * (sigma * (Q / (x3 * r)) * dn) + sigma * (1 / 2) * h * x1 * q / e * cn * (h *
    q * Q / (x1 * r) * cn) - (- (sigma * (1 / 2) * h * x2 * r / e * sn)) * (h * Q / x2 * sn)) / 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 D_1 D_2
    D_3 D_4 D_5 D_6 D_7 D_8.
  rational.
Qed.

(* q' *)
Theorem klein_attitude_6 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_2 := sigma * (1 / 2) * h * x1 * q / e in
  let t_3 := - (h ^ 2 * p ^ 2 * sn * cn * t_1) in
  let t_4 := (1 + dn * (x3 / e)) / 2 in
  let t_5 := sigma * (1 / 2) * h * x2 * r / e * sn in
  let t_6 := - (x1 * q * x2 * r * h ^ 2 / e ^ 2) in
  let t_7 := 0 / e * cn * (cn * dn * t_1) + (0 / e * cn + t_2) * (- (sn * dn * t_1)) + 0 / e * cn *
    t_3 - t_2 * cn * ((dn * (0 / e) / 2 * (cn * dn * t_1) + dn * (0 / e) / 2 * (- (sn * dn * t_1)) +
    (x3 / e + dn * (0 / e)) / 2 * t_3) / (t_4 * 2)) + t_5 * ((sigma * (Q ^ 2 * (1 + h ^ 2 * q ^ 2) /
    r ^ 2 + Q * e / r * (Q / (x3 * r))) / (Q * e / r + x3 ^ 2 * (Q / (x3 * r))) - (- t_1) * t_6 / (1
    + x3 / e) + (- t_1) * dn * t_6 / (1 + dn * (x3 / e))) / 2) in
  e <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  1 + dn * (x3 / e) <> 0 ->
  r <> 0 ->
  Q * e / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 ->
  1 + x3 / e <> 0 ->
  t_7 = (t_4 * (h * Q / x2 * sn) + (- t_5) * (sigma * (Q / (x3 * r)) * dn)) / 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 D_1 D_2 D_3 D_4 D_5 D_6 D_7 D_8.
  rational.
Qed.

(* q' *)
Theorem klein_attitude_7 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (1 / 2) * h * x2 * r / e in
  let t_2 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_3 := - (h ^ 2 * p ^ 2 * sn * cn * t_2) in
  let t_4 := (1 + dn * (x3 / e)) / 2 in
  let t_5 := sigma * (1 / 2) * h * x1 * q / e * cn in
  let t_6 := - (x1 * q * x2 * r * h ^ 2 / e ^ 2) in
  let t_7 := (- (0 / e * sn + t_1)) * (cn * dn * t_2) + (- (0 / e * sn)) * (- (sn * dn * t_2)) + (-
    (0 / e * sn)) * t_3 - (- (t_1 * sn)) * ((dn * (0 / e) / 2 * (cn * dn * t_2) + dn * (0 / e) / 2 *
    (- (sn * dn * t_2)) + (x3 / e + dn * (0 / e)) / 2 * t_3) / (t_4 * 2)) + t_5 * ((sigma * (Q ^ 2 *
    (1 + h ^ 2 * q ^ 2) / r ^ 2 + Q * e / r * (Q / (x3 * r))) / (Q * e / r + x3 ^ 2 * (Q / (x3 *
    r))) - (- t_2) * t_6 / (1 + x3 / e) + (- t_2) * dn * t_6 / (1 + dn * (x3 / e))) / 2) in
  e <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  1 + dn * (x3 / e) <> 0 ->
  r <> 0 ->
  Q * e / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 ->
  1 + x3 / e <> 0 ->
  t_7 = (t_4 * (h * q * Q / (x1 * r) * cn) - t_5 * (sigma * (Q / (x3 * r)) * dn)) / 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 D_1 D_2 D_3 D_4 D_5 D_6 D_7 D_8.
  rational.
Qed.

(* q' *)
Theorem klein_attitude_8 :
  forall Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_2 := - (h ^ 2 * p ^ 2 * sn * cn * t_1) in
  let t_3 := (1 + dn * (x3 / e)) / 2 in
  e <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  1 + dn * (x3 / e) <> 0 ->
  r <> 0 ->
  dn * (0 / e) / 2 * (cn * dn * t_1) + dn * (0 / e) / 2 * (- (sn * dn * t_1)) + (x3 / e + dn * (0 /
    e)) / 2 * t_2 - t_3 * ((dn * (0 / e) / 2 * (cn * dn * t_1) + dn * (0 / e) / 2 * (- (sn * dn *
    t_1)) + (x3 / e + dn * (0 / e)) / 2 * t_2) / (t_3 * 2)) = (- (sigma * (1 / 2) * h * x1 * q / e *
    cn * (h * Q / x2 * sn)) - (- (sigma * (1 / 2) * h * x2 * r / e * sn)) * (h * q * Q / (x1 * r) *
    cn)) / 2.
Proof.
  intros Q cn dn e h p q r sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8 t_1 t_2 t_3 D_1 D_2
    D_3 D_4 D_5 D_6.
  rational.
Qed.

(* With the zero on the other side. *)

(* q' *)
Theorem klein_attitude_mutant_1 :
  exists Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 /\
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 /\
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  sigma ^ 2 = 1 /\
  tau ^ 2 = 1 /\
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_3 := - (x1 * q * x2 * r * h ^ 2 / e ^ 2) in
  e <> 0 /\
  r <> 0 /\
  x3 <> 0 /\
  Q * e / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 /\
  x1 <> 0 /\
  x2 <> 0 /\
  1 + x3 / e <> 0 /\
  1 + dn * (x3 / e) <> 0 /\
  t_1 * ((sigma * (Q ^ 2 * (1 + h ^ 2 * q ^ 2) / r ^ 2 + Q * e / r * (Q / (x3 * r))) / (Q * e / r +
    x3 ^ 2 * (Q / (x3 * r))) - t_2 * t_3 / (1 + x3 / e) + t_2 * dn * t_3 / (1 + dn * (x3 / e))) / 2)
    <> (t_1 * (sigma * (Q / (x3 * r)) * dn) + sigma * (1 / 2) * h * x2 * r / e * sn * (h * Q / x2 *
    sn) - sigma * (1 / 2) * h * x1 * q / e * cn * (h * q * Q / (x1 * r) * cn)) / 2.
Proof.
  exists (7 / 5), (4 / 5), (sqrt (14329 / 15625)), (sqrt (11296 / 15625)), (-3 / 5), (-4 / 5), (-2 /
    5), (sqrt (4 / 5)), 1, (-3 / 5), (-1), (6 / 5), (sqrt (4 / 5)), (4 / 5).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* With the theta function's angle reversed. *)

(* q' *)
Theorem klein_attitude_mutant_2 :
  exists Q cn dn e h p q r sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 /\
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 /\
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  sigma ^ 2 = 1 /\
  tau ^ 2 = 1 /\
  let t_1 := (1 + dn * (x3 / e)) / 2 in
  let t_2 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_3 := - (x1 * q * x2 * r * h ^ 2 / e ^ 2) in
  e <> 0 /\
  r <> 0 /\
  x3 <> 0 /\
  Q * e / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 /\
  x1 <> 0 /\
  x2 <> 0 /\
  1 + x3 / e <> 0 /\
  1 + dn * (x3 / e) <> 0 /\
  t_1 * ((sigma * (Q ^ 2 * (1 + h ^ 2 * q ^ 2) / r ^ 2 + Q * e / r * (Q / (x3 * r))) / (Q * e / r +
    x3 ^ 2 * (Q / (x3 * r))) + t_2 * t_3 / (1 + x3 / e) - t_2 * dn * t_3 / (1 + dn * (x3 / e))) / 2)
    <> (t_1 * (sigma * (Q / (x3 * r)) * dn) + sigma * (1 / 2) * h * x2 * r / e * sn * (h * Q / x2 *
    sn) - (- (sigma * (1 / 2) * h * x1 * q / e * cn)) * (h * q * Q / (x1 * r) * cn)) / 2.
Proof.
  exists (7 / 5), (4 / 5), (sqrt (14329 / 15625)), (sqrt (11296 / 15625)), (-3 / 5), (-4 / 5), (-2 /
    5), (sqrt (4 / 5)), 1, (-3 / 5), (-1), (6 / 5), (sqrt (4 / 5)), (4 / 5).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.


(** limit-coin: Where the middle moment comes to equal the one across, dn is constant, and the closed form is that of the symmetric top: its rate, and a constant a. *)

(* the rate *)
Theorem limit_coin_1 :
  forall Q q sigma tau x1 x3 : R,
  x3 ^ 2 = q ^ 2 * tau + x1 ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  x1 <> 0 ->
  x3 <> 0 ->
  q <> 0 ->
  sigma * tau * q * Q / (x1 * x1 * x3) = (x3 ^ 2 - x1 ^ 2) * (sigma * (Q / (x3 * q))) / x1 ^ 2.
Proof.
  intros Q q sigma tau x1 x3 H_1 H_2 H_3  D_1 D_2 D_3.
  rational.
Qed.

(* the amplitudes *)
Theorem limit_coin_2 :
  forall Q h q x1 : R,
  x1 <> 0 ->
  q <> 0 ->
  h * q * Q / (x1 * q) = h * Q / x1.
Proof.
  intros Q h q x1   D_1 D_2.
  rational.
Qed.

(* the rate of a *)
Theorem limit_coin_3 :
  forall Q cn e h q sigma sn tau x1 x3 : R,
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x3 ^ 2 = q ^ 2 * tau + x1 ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q * Q / (x1 * x1 * x3) in
  e <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  0 / e / 2 * (cn * t_1) + 0 / e / 2 * (- (sn * t_1)) = 0.
Proof.
  intros Q cn e h q sigma sn tau x1 x3 H_1 H_2 H_3 H_4 t_1 D_1 D_2 D_3.
  rational.
Qed.

(* With the rate reversed. *)

(* the rate *)
Theorem limit_coin_mutant_1 :
  exists Q q sigma tau x1 x3 : R,
  x3 ^ 2 = q ^ 2 * tau + x1 ^ 2 /\
  sigma ^ 2 = 1 /\
  tau ^ 2 = 1 /\
  x1 <> 0 /\
  x3 <> 0 /\
  q <> 0 /\
  sigma * tau * q * Q / (x1 * x1 * x3) <> - ((x3 ^ 2 - x1 ^ 2) * (sigma * (Q / (x3 * q))) / x1 ^ 2).
Proof.
  exists 5, 3, (-1), (-1), 5, (-4).
  split; [computed | ]. split; [computed | ]. split; [computed | ]. 
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** limit-separatrix: At modulus one cn and dn are sech, L² = 2 E I2, and the turn about the momentum comes to the rate L/I2. *)

(* cn' and dn' *)
Theorem limit_separatrix_1 :
  forall Q cn p q sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  x1 <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  p <> 0 ->
  - (sn * cn * (sigma * tau * q * Q / (x1 * x2 * x3))) = - ((1 / p) ^ 2 * p ^ 2 * sn * cn * (sigma *
    tau * q * Q / (x1 * x2 * x3))).
Proof.
  intros Q cn p q sigma sn tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5  D_1 D_2 D_3 D_4.
  rational.
Qed.

(* L² *)
Theorem limit_separatrix_2 :
  forall Q p q r tau x1 x2 : R,
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  tau ^ 2 = 1 ->
  p <> 0 ->
  r <> 0 ->
  (Q * (x2 * r / p) / r) ^ 2 = Q ^ 2 * (1 + (1 / p) ^ 2 * q ^ 2) / r ^ 2 * x2 ^ 2.
Proof.
  intros Q p q r tau x1 x2 H_1 H_2 H_3  D_1 D_2.
  rational.
Qed.

(* the turn *)
Theorem limit_separatrix_3 :
  forall Q p q r sigma tau x1 x2 x3 : R,
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := Q * (x2 * r / p) / r in
  p <> 0 ->
  r <> 0 ->
  x3 <> 0 ->
  t_1 + x3 ^ 2 * (Q / (x3 * r)) <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  1 + x3 / (x2 * r / p) <> 0 ->
  sigma * (Q ^ 2 * (1 + (1 / p) ^ 2 * q ^ 2) / r ^ 2 + t_1 * (Q / (x3 * r))) / (t_1 + x3 ^ 2 * (Q /
    (x3 * r))) - sigma * tau * q * Q / (x1 * x2 * x3) * (- (x1 * q * x2 * r * (1 / p) ^ 2 / (x2 * r
    / p) ^ 2)) / (1 + x3 / (x2 * r / p)) = sigma * (Q * (x2 * r / p) / r) / x2 ^ 2.
Proof.
  intros Q p q r sigma tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 t_1 D_1 D_2 D_3 D_4 D_5 D_6 D_7.
  rational.
Qed.

(* With cn and dn opposite. *)

(* cn' and dn' *)
Theorem limit_separatrix_mutant_1 :
  exists Q cn p q sigma sn tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 /\
  sigma ^ 2 = 1 /\
  tau ^ 2 = 1 /\
  x1 <> 0 /\
  x2 <> 0 /\
  x3 <> 0 /\
  p <> 0 /\
  - (sn * (- cn) * (sigma * tau * q * Q / (x1 * x2 * x3))) <> - ((1 / p) ^ 2 * p ^ 2 * sn * cn *
    (sigma * tau * q * Q / (x1 * x2 * x3))).
Proof.
  exists 6, (4 / 5), 104, 672, 1, (3 / 5), 1, 153, 185, 697.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. 
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** limit-steady: Without a wobble b vanishes and the body turns about the circled axis at the rate of its spin. *)

(* b *)
Theorem limit_steady_1 :
  forall cn p q sn tau x1 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  tau ^ 2 = 1 ->
  x3 <> 0 ->
  0 / x3 * sn - 0 / x3 * cn = 0.
Proof.
  intros cn p q sn tau x1 x3 H_1 H_2 H_3  D_1.
  rational.
Qed.

(* the turn *)
Theorem limit_steady_2 :
  forall Q p q r sigma tau x1 x2 x3 : R,
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q * Q / (x1 * x2 * x3) in
  r <> 0 ->
  x3 <> 0 ->
  Q * x3 / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  1 + x3 / x3 <> 0 ->
  sigma * (Q ^ 2 / r ^ 2 + Q * x3 / r * (Q / (x3 * r))) / (Q * x3 / r + x3 ^ 2 * (Q / (x3 * r))) -
    t_1 * (- (0 / x3 ^ 2)) / (1 + x3 / x3) + t_1 * (- (0 / x3 ^ 2)) / (1 + x3 / x3) = sigma * (Q /
    (x3 * r)).
Proof.
  intros Q p q r sigma tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 t_1 D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* With the spin the other way. *)

(* the turn *)
Theorem limit_steady_mutant_1 :
  exists Q p q r sigma tau x1 x2 x3 : R,
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  sigma ^ 2 = 1 /\
  tau ^ 2 = 1 /\
  let t_1 := - (sigma * tau * q * Q / (x1 * x2 * x3)) in
  r <> 0 /\
  x3 <> 0 /\
  Q * x3 / r + x3 ^ 2 * (Q / (x3 * r)) <> 0 /\
  x1 <> 0 /\
  x2 <> 0 /\
  1 + x3 / x3 <> 0 /\
  sigma * (Q ^ 2 / r ^ 2 + Q * x3 / r * (Q / (x3 * r))) / (Q * x3 / r + x3 ^ 2 * (Q / (x3 * r))) -
    t_1 * (- (0 / x3 ^ 2)) / (1 + x3 / x3) + t_1 * (- (0 / x3 ^ 2)) / (1 + x3 / x3) <> - (sigma * (Q
    / (x3 * r))).
Proof.
  exists 6, 104, 672, 680, 1, 1, 153, 185, 697.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. 
  intros t_1; cut_to t_1 (-448 / 2192065) computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. computed.
Qed.


(** gauss-mean: The integral of 1/sqrt((t² + a²)(t² + b²)) over all t is the same for the arithmetic and the geometric mean of a and b, by u = (t - a b/t)/2, and is pi/m for a = b = m. With t = k' tan, half of it for 1 and k' is the quarter period. For all a and b. *)

(* the integrand *)
Theorem gauss_mean_1 :
  forall a b t : R,
  let t_1 := (t - a * b / t) / 2 in
  t <> 0 ->
  ((1 - (0 / t - a * b / t ^ 2)) / 2) ^ 2 * ((t ^ 2 + a ^ 2) * (t ^ 2 + b ^ 2)) = (t_1 ^ 2 + ((a +
    b) / 2) ^ 2) * (t_1 ^ 2 + a * b) * 4.
Proof.
  intros a b t  t_1 D_1.
  rational.
Qed.

(* u rises from below all numbers to above all *)
Theorem gauss_mean_2 :
  forall a b t : R,
  0 < a ->
  0 < b ->
  0 < t ->
  (1 - (0 / t - a * b / t ^ 2)) / 2 > 0.
Proof.
  intros a b t H_1 H_2 H_3  .
  unnamed.
  assert (t <> 0) by (apply Rgt_not_eq; positive).
  assert (t ^ 2 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 2) * a * b + (1 / 2) * t ^ 2) (t ^ 2)); [positive | positive |
    rational].
Qed.

(* of two equal numbers *)
Theorem gauss_mean_3 :
  forall cos m sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  cos <> 0 ->
  m <> 0 ->
  m / cos * cos + (0 / cos - m * sin / cos ^ 2) * (- sin) = (m * sin / cos) ^ 2 / m + m.
Proof.
  intros cos m sin H_1  D_1 D_2.
  rational.
Qed.

(* the quarter period *)
Theorem gauss_mean_4 :
  forall cos kp sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  cos <> 0 ->
  (kp / cos * cos + (0 / cos - kp * sin / cos ^ 2) * (- sin)) ^ 2 * (1 - (1 - kp ^ 2) * sin ^ 2) =
    ((kp * sin / cos) ^ 2 + 1) * ((kp * sin / cos) ^ 2 + kp ^ 2).
Proof.
  intros cos kp sin H_1  D_1.
  rational.
Qed.

(* With a plus in the change of variable. *)

(* the integrand *)
Theorem gauss_mean_mutant_1 :
  exists a b t : R,
  let t_1 := (t + a * b / t) / 2 in
  t <> 0 /\
  ((1 + (0 / t - a * b / t ^ 2)) / 2) ^ 2 * ((t ^ 2 + a ^ 2) * (t ^ 2 + b ^ 2)) <> (t_1 ^ 2 + ((a +
    b) / 2) ^ 2) * (t_1 ^ 2 + a * b) * 4.
Proof.
  exists 6, 1, (-3).
  intros t_1; cut_to t_1 (-5 / 2) computed.
  split; [computed | ]. computed.
Qed.

(* With a third of the sum for the mean. *)

(* the integrand *)
Theorem gauss_mean_mutant_2 :
  exists a b t : R,
  let t_1 := (t - a * b / t) / 2 in
  t <> 0 /\
  ((1 - (0 / t - a * b / t ^ 2)) / 2) ^ 2 * ((t ^ 2 + a ^ 2) * (t ^ 2 + b ^ 2)) <> (t_1 ^ 2 + ((a +
    b) / 3) ^ 2) * (t_1 ^ 2 + a * b) * 4.
Proof.
  exists 6, 1, (-3).
  intros t_1; cut_to t_1 (-1 / 2) computed.
  split; [computed | ]. computed.
Qed.


(** last-mean: Of two numbers with mean m and difference d, the next mean is m - d²/(16 m), but for the square of the next difference over 16 m. *)

(* the next mean *)
Theorem last_mean_1 :
  forall d g m : R,
  d ^ 2 = - (4 * g ^ 2) + 4 * m ^ 2 ->
  m <> 0 ->
  m - d ^ 2 / (m * 16) - (m + g) / 2 = (m - g) ^ 2 / (m * 4).
Proof.
  intros d g m H_1  D_1.
  rational.
Qed.

(* With twice as much taken off. *)

(* the next mean *)
Theorem last_mean_mutant_1 :
  exists d g m : R,
  d ^ 2 = - (4 * g ^ 2) + 4 * m ^ 2 /\
  m <> 0 /\
  m - d ^ 2 / (m * 8) - (m + g) / 2 <> (m - g) ^ 2 / (m * 4).
Proof.
  exists (-8 / 3), 1, (5 / 3).
  split; [computed | ]. 
  split; [computed | ]. computed.
Qed.


(** carlson-duplication: With s = t + XY + YZ + ZX, where X² = t + x and so on, ds/sqrt((s+x)(s+y)(s+z)) is half of dt/(XYZ): so R_F keeps its value when lambda is added to all three and they are divided by four, and R_D but for a quarter and 3/(sqrt(z) (z + lambda)). *)

(* s + x *)
Theorem carlson_duplication_1 :
  forall X Y Z t : R,
  t + X * Y + Y * Z + Z * X + X ^ 2 - t = (X + Y) * (Z + X).
Proof.
  intros X Y Z t   .
  rational.
Qed.

(* s + y *)
Theorem carlson_duplication_2 :
  forall X Y Z t : R,
  t + X * Y + Y * Z + Z * X + Y ^ 2 - t = (X + Y) * (Y + Z).
Proof.
  intros X Y Z t   .
  rational.
Qed.

(* s + z *)
Theorem carlson_duplication_3 :
  forall X Y Z t : R,
  t + X * Y + Y * Z + Z * X + Z ^ 2 - t = (Y + Z) * (Z + X).
Proof.
  intros X Y Z t   .
  rational.
Qed.

(* the integrand of R_F *)
Theorem carlson_duplication_4 :
  forall X Y Z : R,
  X <> 0 ->
  Y <> 0 ->
  Z <> 0 ->
  X + Y <> 0 ->
  Y + Z <> 0 ->
  Z + X <> 0 ->
  (1 + (Y + Z) * (1 / (2 * X)) + (X + Z) * (1 / (2 * Y)) + (Y + X) * (1 / (2 * Z))) / ((X + Y) * (Y
    + Z) * (Z + X)) = 1 / (2 * (X * Y * Z)).
Proof.
  intros X Y Z   D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* the integrand of R_D *)
Theorem carlson_duplication_5 :
  forall X Y Z : R,
  let t_1 := Z * (Y + Z) * (Z + X) in
  Z <> 0 ->
  X <> 0 ->
  Y <> 0 ->
  Y + Z <> 0 ->
  Z + X <> 0 ->
  X + Y <> 0 ->
  3 / (2 * Z ^ 2 * (X * Y * Z)) - 3 * (1 + (Y + Z) * (1 / (2 * X)) + (X + Z) * (1 / (2 * Y)) + (Y +
    X) * (1 / (2 * Z))) / ((Y + Z) * (Z + X) * ((X + Y) * (Y + Z) * (Z + X))) = - (0 / t_1 + (0 /
    t_1 - 3 * (Z * (Y + Z)) / t_1 ^ 2) * (1 / (2 * X)) + (0 / t_1 - 3 * (Z * (Z + X)) / t_1 ^ 2) *
    (1 / (2 * Y)) + (0 / t_1 - 3 * ((Y + Z + Z) * (Z + X) + Z * (Y + Z)) / t_1 ^ 2) * (1 / (2 *
    Z))).
Proof.
  intros X Y Z  t_1 D_1 D_2 D_3 D_4 D_5 D_6.
  rational.
Qed.

(* With a product of roots the other way. *)

(* s + x *)
Theorem carlson_duplication_mutant_1 :
  exists X Y Z t : R,
  t + X * Y + Y * Z - Z * X + X ^ 2 - t <> (X + Y) * (Z + X).
Proof.
  exists 6, 1, (-3), 1.
  computed.
Qed.

(* With another term taken off. *)

(* the integrand of R_D *)
Theorem carlson_duplication_mutant_2 :
  exists X Y Z : R,
  let t_1 := Z * (Y + Z) * (Z + X) in
  Z <> 0 /\
  X <> 0 /\
  Y <> 0 /\
  Y + Z <> 0 /\
  Z + X <> 0 /\
  X + Y <> 0 /\
  3 / (2 * Z ^ 2 * (X * Y * Z)) - 3 * (1 + (Y + Z) * (1 / (2 * X)) + (X + Z) * (1 / (2 * Y)) + (Y +
    X) * (1 / (2 * Z))) / ((Y + Z) * (Z + X) * ((X + Y) * (Y + Z) * (Z + X))) <> - (0 / t_1 + (0 /
    t_1 - 2 * (Z * (Y + Z)) / t_1 ^ 2) * (1 / (2 * X)) + (0 / t_1 - 2 * (Z * (Z + X)) / t_1 ^ 2) *
    (1 / (2 * Y)) + (0 / t_1 - 2 * ((Y + Z + Z) * (Z + X) + Z * (Y + Z)) / t_1 ^ 2) * (1 / (2 *
    Z))).
Proof.
  exists 6, 1, (-3).
  intros t_1; cut_to t_1 18 computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. split;
    [computed | ]. split; [computed | ]. computed.
Qed.


(** carlson-series: The series of R_F and of R_D near three equal numbers are the binomial series of their integrands, integrated term by term, to the seventh order. *)

(* three distances *)
Theorem carlson_series_1 :
  forall a b t : R,
  (t - a) * (t - b) * (t + (a + b)) = t ^ 3 + (a * b - (- (a + b)) ^ 2) * t - a * b * (- (a + b)).
Proof.
  intros a b t   .
  rational.
Qed.

(* five distances *)
Theorem carlson_series_2 :
  forall a b t : R,
  (t - a) * (t - b) * (t - (- (a + b)) / 3) * (t - (- (a + b)) / 3) * (t - (- (a + b)) / 3) = t ^ 5
    + (a * b - 6 * ((- (a + b)) / 3) ^ 2) * t ^ 3 - (3 * (a * b) - 8 * ((- (a + b)) / 3) ^ 2) * ((-
    (a + b)) / 3) * t ^ 2 + 3 * (a * b - ((- (a + b)) / 3) ^ 2) * ((- (a + b)) / 3) ^ 2 * t - a * b
    * ((- (a + b)) / 3) ^ 2 * ((- (a + b)) / 3).
Proof.
  intros a b t   .
  rational.
Qed.

(* With a coefficient of R_F. *)

(* R_F, power 4 *)
Theorem carlson_series_mutant_1 :
  exists E2 : R,
  (3 / 44) * E2 ^ 2 <> 0.
Proof.
  exists 6.
  computed.
Qed.

(* With a coefficient of R_D. *)

(* R_D, power 5 *)
Theorem carlson_series_mutant_2 :
  exists E5 : R,
  - ((1 / 14) * E5) <> 0.
Proof.
  exists 6.
  computed.
Qed.


(** legendre-by-carlson: Jacobi's argument of a sine s is s R_F(1 - s², 1 - m s², 1), what is left of it to the quarter period the same of cn/dn, and that of the theta zero the same with the complementary modulus. Its derivative by m is s³ R_D(1 - s², 1, 1 - m s²)/6. *)

(* t + x *)
Theorem legendre_by_carlson_1 :
  forall cos s sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  sin <> 0 ->
  s ^ 2 / sin ^ 2 - 1 + (1 - s ^ 2) = (s * cos / sin) ^ 2.
Proof.
  intros cos s sin H_1  D_1.
  rational.
Qed.

(* t + y *)
Theorem legendre_by_carlson_2 :
  forall Delta m s sin : R,
  Delta ^ 2 = - (m * sin ^ 2) + 1 ->
  sin <> 0 ->
  s ^ 2 / sin ^ 2 - 1 + (1 - m * s ^ 2) = (s * Delta / sin) ^ 2.
Proof.
  intros Delta m s sin H_1  D_1.
  rational.
Qed.

(* t + z *)
Theorem legendre_by_carlson_3 :
  forall s sin : R,
  sin <> 0 ->
  s ^ 2 / sin ^ 2 - 1 + 1 = (s / sin) ^ 2.
Proof.
  intros s sin   D_1.
  rational.
Qed.

(* the argument *)
Theorem legendre_by_carlson_4 :
  forall Delta cos m s sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  Delta ^ 2 = - (m * sin ^ 2) + 1 ->
  sin <> 0 ->
  s <> 0 ->
  cos <> 0 ->
  Delta <> 0 ->
  s * (- ((0 / sin ^ 2 - s ^ 2 * (2 * sin) / (sin ^ 2) ^ 2) * cos)) / (2 * (s * cos / sin * (s *
    Delta / sin) * (s / sin))) = 1 / Delta.
Proof.
  intros Delta cos m s sin H_1 H_2  D_1 D_2 D_3 D_4.
  rational.
Qed.

(* its derivative *)
Theorem legendre_by_carlson_5 :
  forall Delta cos m s sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  Delta ^ 2 = - (m * sin ^ 2) + 1 ->
  sin <> 0 ->
  s <> 0 ->
  Delta <> 0 ->
  cos <> 0 ->
  s ^ 3 / 6 * (3 / 2) * (- ((0 / sin ^ 2 - s ^ 2 * (2 * sin) / (sin ^ 2) ^ 2) * cos)) / ((s * Delta
    / sin) ^ 2 * (s * cos / sin * (s * Delta / sin) * (s / sin))) = (0 / Delta - 1 / Delta ^ 2) * (-
    (sin ^ 2 / (2 * Delta))).
Proof.
  intros Delta cos m s sin H_1 H_2  D_1 D_2 D_3 D_4.
  rational.
Qed.

(* the cosine of what is left *)
Theorem legendre_by_carlson_6 :
  forall cn dn kp m sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  kp ^ 2 = - m + 1 ->
  dn <> 0 ->
  (kp * sn / dn) ^ 2 = 1 - (cn / dn) ^ 2.
Proof.
  intros cn dn kp m sn H_1 H_2 H_3  D_1.
  rational.
Qed.

(* its dn *)
Theorem legendre_by_carlson_7 :
  forall cn dn kp m sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  kp ^ 2 = - m + 1 ->
  dn <> 0 ->
  (kp / dn) ^ 2 = 1 - m * (cn / dn) ^ 2.
Proof.
  intros cn dn kp m sn H_1 H_2 H_3  D_1.
  rational.
Qed.

(* its rate *)
Theorem legendre_by_carlson_8 :
  forall cn dn kp m sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  kp ^ 2 = - m + 1 ->
  dn <> 0 ->
  0 / dn * (cn * dn) + 1 / dn * (- (sn * dn)) + (0 / dn - cn / dn ^ 2) * (- (m * (sn * cn))) = - (kp
    * sn / dn * (kp / dn)).
Proof.
  intros cn dn kp m sn H_1 H_2 H_3  D_1.
  rational.
Qed.

(* the zero's cosine *)
Theorem legendre_by_carlson_9 :
  forall p q r tau x1 x2 x3 : R,
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  tau ^ 2 = 1 ->
  x2 <> 0 ->
  r <> 0 ->
  (x1 * q / (x2 * r)) ^ 2 + (x3 * p / (x2 * r)) ^ 2 - 1 = 0.
Proof.
  intros p q r tau x1 x2 x3 H_1 H_2 H_3 H_4  D_1 D_2.
  rational.
Qed.

(* the zero's dn *)
Theorem legendre_by_carlson_10 :
  forall e h kp p q r tau x1 x2 x3 : R,
  kp ^ 2 = - (h ^ 2 * p ^ 2) + 1 ->
  e ^ 2 = h ^ 2 * q ^ 2 * x1 ^ 2 + x3 ^ 2 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  tau ^ 2 = 1 ->
  x2 <> 0 ->
  r <> 0 ->
  (p * e / (x2 * r)) ^ 2 + (x1 * q / (x2 * r)) ^ 2 * kp ^ 2 - 1 = 0.
Proof.
  intros e h kp p q r tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6  D_1 D_2.
  rational.
Qed.

(* With the parameter's sign. *)

(* t + y *)
Theorem legendre_by_carlson_mutant_1 :
  exists Delta m s sin : R,
  Delta ^ 2 = - (m * sin ^ 2) + 1 /\
  sin <> 0 /\
  s ^ 2 / sin ^ 2 - 1 + (1 + m * s ^ 2) <> (s * Delta / sin) ^ 2.
Proof.
  exists (12 / 13), (625 / 1521), 1, (3 / 5).
  split; [computed | ]. 
  split; [computed | ]. computed.
Qed.

(* With a third for the sixth. *)

(* its derivative *)
Theorem legendre_by_carlson_mutant_2 :
  exists Delta cos m s sin : R,
  cos ^ 2 = - sin ^ 2 + 1 /\
  Delta ^ 2 = - (m * sin ^ 2) + 1 /\
  sin <> 0 /\
  s <> 0 /\
  Delta <> 0 /\
  cos <> 0 /\
  s ^ 3 / 3 * (3 / 2) * (- ((0 / sin ^ 2 - s ^ 2 * (2 * sin) / (sin ^ 2) ^ 2) * cos)) / ((s * Delta
    / sin) ^ 2 * (s * cos / sin * (s * Delta / sin) * (s / sin))) <> (0 / Delta - 1 / Delta ^ 2) *
    (- (sin ^ 2 / (2 * Delta))).
Proof.
  exists (12 / 13), (4 / 5), (625 / 1521), 1, (3 / 5).
  split; [computed | ]. split; [computed | ]. 
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** variational-equations: Euler's equations to first order are W_a' = k_a (W_b w_c + w_b W_c), and what a change of a moment or of a product of inertia adds at a fixed spin is as the power series take it. For every body. *)

(* W', x *)
Theorem variational_equations_1 :
  forall I1 I2 I3 W1 W2 W3 omega2 omega3 : R,
  I1 <> 0 ->
  0 / I1 * W1 + (I2 - I3) * omega3 / I1 * W2 + (I2 - I3) * omega2 / I1 * W3 = (I2 - I3) / I1 * (W2 *
    omega3 + omega2 * W3).
Proof.
  intros I1 I2 I3 W1 W2 W3 omega2 omega3   D_1.
  rational.
Qed.

(* W', y *)
Theorem variational_equations_2 :
  forall I1 I2 I3 W1 W2 W3 omega1 omega3 : R,
  I2 <> 0 ->
  (I3 - I1) * omega3 / I2 * W1 + 0 / I2 * W2 + (I3 - I1) * omega1 / I2 * W3 = (I3 - I1) / I2 * (W3 *
    omega1 + omega3 * W1).
Proof.
  intros I1 I2 I3 W1 W2 W3 omega1 omega3   D_1.
  rational.
Qed.

(* W', z *)
Theorem variational_equations_3 :
  forall I1 I2 I3 W1 W2 W3 omega1 omega2 : R,
  I3 <> 0 ->
  (I1 - I2) * omega2 / I3 * W1 + (I1 - I2) * omega1 / I3 * W2 + 0 / I3 * W3 = (I1 - I2) / I3 * (W1 *
    omega2 + omega1 * W2).
Proof.
  intros I1 I2 I3 W1 W2 W3 omega1 omega2   D_1.
  rational.
Qed.

(* by a moment, x *)
Theorem variational_equations_4 :
  forall I1 I2 I3 omega2 omega3 : R,
  I1 <> 0 ->
  (- ((I2 - I3) * (omega2 * omega3) / I1)) * (1 / I1) = - ((I2 - I3) / I1 * (1 / I1) * omega2 *
    omega3).
Proof.
  intros I1 I2 I3 omega2 omega3   D_1.
  rational.
Qed.

(* by a moment, y *)
Theorem variational_equations_5 :
  forall I2 omega1 omega3 : R,
  I2 <> 0 ->
  (- (omega1 * omega3)) * (1 / I2) = - (1 / I2 * omega3 * omega1).
Proof.
  intros I2 omega1 omega3   D_1.
  rational.
Qed.

(* by a moment, z *)
Theorem variational_equations_6 :
  forall I3 omega1 omega2 : R,
  I3 <> 0 ->
  omega1 * omega2 * (1 / I3) = 1 / I3 * omega1 * omega2.
Proof.
  intros I3 omega1 omega2   D_1.
  rational.
Qed.

(* by a product, x *)
Theorem variational_equations_7 :
  forall I1 omega2 omega3 : R,
  I1 <> 0 ->
  (omega3 * omega3 - omega2 * omega2) * (1 / I1) = 1 / I1 * (omega3 - omega2) * (omega3 + omega2).
Proof.
  intros I1 omega2 omega3   D_1.
  rational.
Qed.

(* by a product, y *)
Theorem variational_equations_8 :
  forall I1 I2 I3 omega1 omega2 : R,
  I3 <> 0 ->
  I2 <> 0 ->
  (omega2 * omega1 - (I1 - I2) * (omega1 * omega2) / I3) * (1 / I2) = (I2 + I3 - I1) * (1 / I2) * (1
    / I3) * omega2 * omega1.
Proof.
  intros I1 I2 I3 omega1 omega2   D_1 D_2.
  rational.
Qed.

(* by a product, z *)
Theorem variational_equations_9 :
  forall I1 I2 I3 omega1 omega3 : R,
  I2 <> 0 ->
  I3 <> 0 ->
  (- (omega3 * omega1) - (I3 - I1) * (omega3 * omega1) / I2) * (1 / I3) = - ((I2 + I3 - I1) * (1 /
    I2) * (1 / I3) * omega3 * omega1).
Proof.
  intros I1 I2 I3 omega1 omega3   D_1 D_2.
  rational.
Qed.

(* by a moment, x *)
Theorem variational_equations_10 :
  forall I1 omega2 omega3 : R,
  I1 <> 0 ->
  omega2 * omega3 * (1 / I1) = 1 / I1 * omega2 * omega3.
Proof.
  intros I1 omega2 omega3   D_1.
  rational.
Qed.

(* by a moment, y *)
Theorem variational_equations_11 :
  forall I1 I2 I3 omega1 omega3 : R,
  I2 <> 0 ->
  (- ((I3 - I1) * (omega3 * omega1) / I2)) * (1 / I2) = - ((I3 - I1) / I2 * (1 / I2) * omega3 *
    omega1).
Proof.
  intros I1 I2 I3 omega1 omega3   D_1.
  rational.
Qed.

(* by a moment, z *)
Theorem variational_equations_12 :
  forall I3 omega1 omega2 : R,
  I3 <> 0 ->
  (- (omega2 * omega1)) * (1 / I3) = - (1 / I3 * omega1 * omega2).
Proof.
  intros I3 omega1 omega2   D_1.
  rational.
Qed.

(* by a product, x *)
Theorem variational_equations_13 :
  forall I1 I2 I3 omega1 omega2 : R,
  I3 <> 0 ->
  I1 <> 0 ->
  (- (omega1 * omega2) - (I1 - I2) * (omega1 * omega2) / I3) * (1 / I1) = - ((I3 + I1 - I2) * (1 /
    I3) * (1 / I1) * omega1 * omega2).
Proof.
  intros I1 I2 I3 omega1 omega2   D_1 D_2.
  rational.
Qed.

(* by a product, y *)
Theorem variational_equations_14 :
  forall I2 omega1 omega3 : R,
  I2 <> 0 ->
  (omega1 * omega1 - omega3 * omega3) * (1 / I2) = 1 / I2 * (omega1 - omega3) * (omega1 + omega3).
Proof.
  intros I2 omega1 omega3   D_1.
  rational.
Qed.

(* by a product, z *)
Theorem variational_equations_15 :
  forall I1 I2 I3 omega2 omega3 : R,
  I1 <> 0 ->
  I3 <> 0 ->
  (omega3 * omega2 - (I2 - I3) * (omega2 * omega3) / I1) * (1 / I3) = (I3 + I1 - I2) * (1 / I3) * (1
    / I1) * omega3 * omega2.
Proof.
  intros I1 I2 I3 omega2 omega3   D_1 D_2.
  rational.
Qed.

(* by a moment, x *)
Theorem variational_equations_16 :
  forall I1 omega2 omega3 : R,
  I1 <> 0 ->
  (- (omega3 * omega2)) * (1 / I1) = - (1 / I1 * omega2 * omega3).
Proof.
  intros I1 omega2 omega3   D_1.
  rational.
Qed.

(* by a moment, y *)
Theorem variational_equations_17 :
  forall I2 omega1 omega3 : R,
  I2 <> 0 ->
  omega3 * omega1 * (1 / I2) = 1 / I2 * omega3 * omega1.
Proof.
  intros I2 omega1 omega3   D_1.
  rational.
Qed.

(* by a moment, z *)
Theorem variational_equations_18 :
  forall I1 I2 I3 omega1 omega2 : R,
  I3 <> 0 ->
  (- ((I1 - I2) * (omega1 * omega2) / I3)) * (1 / I3) = - ((I1 - I2) / I3 * (1 / I3) * omega1 *
    omega2).
Proof.
  intros I1 I2 I3 omega1 omega2   D_1.
  rational.
Qed.

(* by a product, x *)
Theorem variational_equations_19 :
  forall I1 I2 I3 omega1 omega3 : R,
  I2 <> 0 ->
  I1 <> 0 ->
  (omega1 * omega3 - (I3 - I1) * (omega3 * omega1) / I2) * (1 / I1) = (I1 + I2 - I3) * (1 / I1) * (1
    / I2) * omega1 * omega3.
Proof.
  intros I1 I2 I3 omega1 omega3   D_1 D_2.
  rational.
Qed.

(* by a product, y *)
Theorem variational_equations_20 :
  forall I1 I2 I3 omega2 omega3 : R,
  I1 <> 0 ->
  I2 <> 0 ->
  (- (omega2 * omega3) - (I2 - I3) * (omega2 * omega3) / I1) * (1 / I2) = - ((I1 + I2 - I3) * (1 /
    I1) * (1 / I2) * omega2 * omega3).
Proof.
  intros I1 I2 I3 omega2 omega3   D_1 D_2.
  rational.
Qed.

(* by a product, z *)
Theorem variational_equations_21 :
  forall I3 omega1 omega2 : R,
  I3 <> 0 ->
  (omega2 * omega2 - omega1 * omega1) * (1 / I3) = 1 / I3 * (omega2 - omega1) * (omega2 + omega1).
Proof.
  intros I3 omega1 omega2   D_1.
  rational.
Qed.

(* With a minus between the products. *)

(* W', x *)
Theorem variational_equations_mutant_1 :
  exists I1 I2 I3 W1 W2 W3 omega2 omega3 : R,
  I1 <> 0 /\
  0 / I1 * W1 + (I2 - I3) * omega3 / I1 * W2 + (I2 - I3) * omega2 / I1 * W3 <> (I2 - I3) / I1 * (W2
    * omega3 - omega2 * W3).
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3.
  split; [computed | ]. computed.
Qed.


(** sensitivity-of-the-spin: The closed form's derivatives by its two constants and by the moments, with the derivative of Jacobi's argument at a fixed angle, obey Euler's equations to first order. For every body, about either axis, in either sense. *)

(* by Q, component 1 *)
Theorem sensitivity_of_the_spin_1 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q / (x1 * x2 * x3) in
  let t_2 := sigma * (0 / (x3 * r)) * dn in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := - (sn * dn * (t * t_1)) in
  let t_5 := sigma * (0 / (x3 * r)) * dn in
  let t_6 := h ^ 2 * p ^ 2 * sn * cn in
  let t_7 := - (t_6 * (t * t_1)) - 0 / (2 * dn) in
  let t_8 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_9 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_1)) +
    t_2 * (cn * dn * t_3)) + (sigma * (0 / (x3 * r)) * dn * t_4 + t_5 * (- (dn * (t * t_1) + sn * dn
    * t_3))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2 * p ^
    2 * cn * (t * t_1) + t_6 * t_3) - 0 / (2 * dn))) in
  let t_10 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_1)) +
    t_2 * (dn * (t * t_1) + cn * dn * t_11)) + (sigma * (0 / (x3 * r)) * dn * t_4 + t_5 * (- (sn *
    dn * t_11))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2 *
    p ^ 2 * sn * (t * t_1) + t_6 * t_11) - 0 / (2 * dn))) in
  let t_13 := t * (0 / (x1 * x2 * x3)) in
  let t_14 := sigma * (0 / (x3 * r)) * dn + sigma * (1 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (cn * dn * (t * t_1)) + t_2 * (cn * (t * t_1) + cn * dn * t_13)) +
    ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_4 + t_5 * (- (sn * (t * t_1) + sn *
    dn * t_13))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + sigma * (0 / (x3 * r)))
    * t_7 + t_8 * (- (t_6 * t_13) - (0 / (2 * dn) - 0 / (2 * dn) ^ 2))) in
  let t_15 := t_1 + t * (0 / (x1 * x2 * x3)) in
  let t_16 := t_9 * (cn * dn * t_10) + t_12 * (- (sn * dn * t_10)) + t_14 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_10)) + (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t *
    t_1)) + t_2 * (cn * dn * t_15)) + (sigma * (0 / (x3 * r)) * dn * t_4 + t_5 * (- (sn * dn *
    t_15))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_6 * t_15)
    - 0 / (2 * dn)))) in
  let t_17 := t * (0 / (x1 * x2 * x3)) in
  let t_18 := t_16 + (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t *
    t_1)) + t_2 * (cn * dn * t_17)) + (sigma * (0 / (x3 * r)) * dn * t_4 + t_5 * (- (sn * dn *
    t_17))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_6 * t_17)
    - 0 / (2 * dn)))) * (t_10 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_19 := h * q * Q / (x1 * r) in
  let t_20 := (x1 ^ 2 - x2 ^ 2) * (h * q / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (h / x2 *
    sn)) / x3 ^ 2 + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (0 / x2
    * sn + h * Q / x2)) / x3 ^ 2 * (cn * dn * (t * t_1)) + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1 * r) * cn +
    t_19) * (h * Q / x2 * sn) + t_19 * cn * (0 / x2 * sn)) / x3 ^ 2 * t_4 in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  dn <> 0 ->
  t_18 = t_20 + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (0 / x2 *
    sn)) / x3 ^ 2 * t_7.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by Q, component 2 *)
Theorem sensitivity_of_the_spin_2 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q / (x1 * x2 * x3) in
  let t_2 := t * (0 / (x1 * x2 * x3)) in
  let t_3 := - (sn * dn * (t * t_1)) in
  let t_4 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_5 := h ^ 2 * p ^ 2 * sn * cn in
  let t_6 := - (t_5 * (t * t_1)) - 0 / (2 * dn) in
  let t_7 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * (t * t_1)) + 0 / (x1 * r) * cn *
    (cn * dn * t_2)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_3 + t_4 * (- (dn * (t * t_1) + sn *
    dn * t_2))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn * (t * t_1)
    + t_5 * t_2) - 0 / (2 * dn))) in
  let t_8 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_9 := t * (0 / (x1 * x2 * x3)) in
  let t_10 := 0 / (x1 * r) * cn + h * q / (x1 * r) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (cn * dn
    * (t * t_1)) + 0 / (x1 * r) * cn * (dn * (t * t_1) + cn * dn * t_9)) + ((0 / (x1 * r) * cn + 0 /
    (x1 * r) + 0 / (x1 * r)) * t_3 + t_4 * (- (sn * dn * t_9))) + ((0 / (x1 * r) * cn + 0 / (x1 *
    r)) * t_6 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * (t * t_1) + t_5 * t_9) - 0 / (2 * dn)))
    in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * (t * t_1)) + 0 / (x1 * r) * cn *
    (cn * (t * t_1) + cn * dn * t_11)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_3 + t_4 * (- (sn *
    (t * t_1) + sn * dn * t_11))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_5 * t_11) -
    (0 / (2 * dn) - 0 / (2 * dn) ^ 2))) in
  let t_13 := t_1 + t * (0 / (x1 * x2 * x3)) in
  let t_14 := t_7 * (cn * dn * t_8) + t_10 * (- (sn * dn * t_8)) + t_12 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_8)) + (0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * (t * t_1)) + 0 / (x1 * r) * cn
    * (cn * dn * t_13)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_3 + t_4 * (- (sn * dn * t_13))) +
    (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_5 * t_13) - 0 / (2 * dn)))) in
  let t_15 := t * (0 / (x1 * x2 * x3)) in
  let t_16 := (0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * (t * t_1)) + 0 / (x1 * r) * cn *
    (cn * dn * t_15)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_3 + t_4 * (- (sn * dn * t_15))) + (0
    / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_5 * t_15) - 0 / (2 * dn)))) * (t_8 * sn ^ 2 /
    (2 * dn ^ 2)) in
  let t_17 := sigma * (Q / (x3 * r)) * dn in
  let t_18 := (x2 ^ 2 - x3 ^ 2) * (h / x2 * sn * t_17 + h * Q / x2 * sn * (sigma * (1 / (x3 * r)) *
    dn)) / x1 ^ 2 + (x2 ^ 2 - x3 ^ 2) * ((0 / x2 * sn + h * Q / x2) * t_17 + h * Q / x2 * sn *
    (sigma * (0 / (x3 * r)) * dn)) / x1 ^ 2 * (cn * dn * (t * t_1)) + (x2 ^ 2 - x3 ^ 2) * (0 / x2 *
    sn * t_17 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) * dn)) / x1 ^ 2 * t_3 in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  t_14 + t_16 = t_18 + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_17 + h * Q / x2 * sn * (sigma * (0 / (x3
    * r)) * dn + sigma * (Q / (x3 * r)))) / x1 ^ 2 * t_6.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by Q, component 3 *)
Theorem sensitivity_of_the_spin_3 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * tau * q / (x1 * x2 * x3) in
  let t_2 := 0 / x2 * sn + h * Q / x2 in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := - (sn * dn * (t * t_1)) in
  let t_5 := h ^ 2 * p ^ 2 * sn * cn in
  let t_6 := - (t_5 * (t * t_1)) - 0 / (2 * dn) in
  let t_7 := 0 / x2 * sn + h / x2 + ((0 / x2 * sn + 0 / x2 + 0 / x2) * (cn * dn * (t * t_1)) + t_2 *
    (cn * dn * t_3)) + ((0 / x2 * sn + 0 / x2) * t_4 + 0 / x2 * sn * (- (dn * (t * t_1) + sn * dn *
    t_3))) + ((0 / x2 * sn + 0 / x2) * t_6 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * (t * t_1) + t_5
    * t_3) - 0 / (2 * dn))) in
  let t_8 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_9 := t * (0 / (x1 * x2 * x3)) in
  let t_10 := (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_1)) + t_2 * (dn * (t * t_1)
    + cn * dn * t_9)) + (0 / x2 * sn * t_4 + 0 / x2 * sn * (- (sn * dn * t_9))) + (0 / x2 * sn * t_6
    + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * sn * (t * t_1) + t_5 * t_9) - 0 / (2 * dn)))) * (- (sn * dn
    * t_8)) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_1)) + t_2 * (cn * (t * t_1)
    + cn * dn * t_11)) + (0 / x2 * sn * t_4 + 0 / x2 * sn * (- (sn * (t * t_1) + sn * dn * t_11))) +
    (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_5 * t_11) - (0 / (2 * dn) - 0 / (2 * dn) ^ 2)))) * (-
    (h ^ 2 * p ^ 2 * sn * cn * t_8)) in
  let t_13 := t_1 + t * (0 / (x1 * x2 * x3)) in
  let t_14 := t * (0 / (x1 * x2 * x3)) in
  let t_15 := t_7 * (cn * dn * t_8) + t_10 + t_12 + (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn *
    dn * (t * t_1)) + t_2 * (cn * dn * t_13)) + (0 / x2 * sn * t_4 + 0 / x2 * sn * (- (sn * dn *
    t_13))) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_5 * t_13) - 0 / (2 * dn)))) + (0 / x2 * sn +
    ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_1)) + t_2 * (cn * dn * t_14)) + (0 / x2 * sn * t_4 +
    0 / x2 * sn * (- (sn * dn * t_14))) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_5 * t_14) - 0 /
    (2 * dn)))) * (t_8 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_16 := h * q * Q / (x1 * r) in
  let t_17 := sigma * (Q / (x3 * r)) * dn in
  let t_18 := (x3 ^ 2 - x1 ^ 2) * (sigma * (1 / (x3 * r)) * dn * (t_16 * cn) + t_17 * (h * q / (x1 *
    r) * cn)) / x2 ^ 2 + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_16 * cn) + t_17 * (0
    / (x1 * r) * cn)) / x2 ^ 2 * (cn * dn * (t * t_1)) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r))
    * dn * (t_16 * cn) + t_17 * (0 / (x1 * r) * cn + t_16)) / x2 ^ 2 * t_4 in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  r <> 0 ->
  t_15 = t_18 + (x3 ^ 2 - x1 ^ 2) * ((sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) * (t_16
    * cn) + t_17 * (0 / (x1 * r) * cn)) / x2 ^ 2 * t_6.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by h, component 1 *)
Theorem sensitivity_of_the_spin_4 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 * J in
  let t_2 := sigma * (0 / (x3 * r)) * dn in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := sigma * (0 / (x3 * r)) * dn in
  let t_5 := h ^ 2 * p ^ 2 * sn * cn in
  let t_6 := 2 * h * p ^ 2 * sn ^ 2 in
  let t_7 := - (t_5 * t_1) - t_6 / (2 * dn) in
  let t_8 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_9 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (cn * dn * t_3)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (dn * t_1 + sn
    * dn * t_3))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2
    * p ^ 2 * cn * t_1 + t_5 * t_3) - 2 * h * p ^ 2 * (2 * sn) / (2 * dn))) in
  let t_10 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (dn * t_1 + cn * dn * t_11)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn
    * dn * t_11))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2
    * p ^ 2 * sn * t_1 + t_5 * t_11) - 0 / (2 * dn))) in
  let t_13 := t * (0 / (x1 * x2 * x3)) in
  let t_14 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (cn * dn * t_1) + t_2 * (cn * t_1 + cn * dn * t_13)) + ((sigma * (0 /
    (x3 * r)) * dn + sigma * (0 / (x3 * r))) * (- (sn * dn * t_1)) + t_4 * (- (sn * t_1 + sn * dn *
    t_13))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + sigma * (0 / (x3 * r))) * t_7
    + t_8 * (- (t_5 * t_13) - (0 / (2 * dn) - t_6 * 2 / (2 * dn) ^ 2))) in
  let t_15 := 0 / (x1 * x2 * x3) + t * (0 / (x1 * x2 * x3)) in
  let t_16 := t_9 * (cn * dn * t_10) + t_12 * (- (sn * dn * t_10)) + t_14 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_10)) + (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) +
    t_2 * (cn * dn * t_15)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn * dn
    * t_15))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_5 *
    t_15) - 0 / (2 * dn)))) in
  let t_17 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 in
  let t_18 := (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (cn * dn * t_17)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn * dn *
    t_17))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_5 * t_17)
    - 0 / (2 * dn)))) * (t_10 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_19 := h * q * Q / (x1 * r) in
  let t_20 := (x1 ^ 2 - x2 ^ 2) * (q * Q / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (Q / x2 *
    sn)) / x3 ^ 2 + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (0 / x2
    * sn + h * Q / x2)) / x3 ^ 2 * (cn * dn * t_1) + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1 * r) * cn + t_19)
    * (h * Q / x2 * sn) + t_19 * cn * (0 / x2 * sn)) / x3 ^ 2 * (- (sn * dn * t_1)) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  dn <> 0 ->
  t_16 + t_18 = t_20 + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (0 /
    x2 * sn)) / x3 ^ 2 * t_7.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by h, component 2 *)
Theorem sensitivity_of_the_spin_5 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 * J in
  let t_2 := t * (0 / (x1 * x2 * x3)) in
  let t_3 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_4 := h ^ 2 * p ^ 2 * sn * cn in
  let t_5 := 2 * h * p ^ 2 * sn ^ 2 in
  let t_6 := - (t_4 * t_1) - t_5 / (2 * dn) in
  let t_7 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * t_1) + 0 / (x1 * r) * cn * (cn * dn
    * t_2)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (- (dn * t_1 + sn *
    dn * t_2))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn * t_1 + t_4
    * t_2) - 2 * h * p ^ 2 * (2 * sn) / (2 * dn))) in
  let t_8 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_9 := t * (0 / (x1 * x2 * x3)) in
  let t_10 := 0 / (x1 * r) * cn + q * Q / (x1 * r) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (cn * dn
    * t_1) + 0 / (x1 * r) * cn * (dn * t_1 + cn * dn * t_9)) + ((0 / (x1 * r) * cn + 0 / (x1 * r) +
    0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (- (sn * dn * t_9))) + ((0 / (x1 * r) * cn + 0 / (x1
    * r)) * t_6 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * t_1 + t_4 * t_9) - 0 / (2 * dn))) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * t_1) + 0 / (x1 * r) * cn * (cn *
    t_1 + cn * dn * t_11)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (-
    (sn * t_1 + sn * dn * t_11))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_4 * t_11) -
    (0 / (2 * dn) - t_5 * 2 / (2 * dn) ^ 2))) in
  let t_13 := 0 / (x1 * x2 * x3) + t * (0 / (x1 * x2 * x3)) in
  let t_14 := t_7 * (cn * dn * t_8) + t_10 * (- (sn * dn * t_8)) + t_12 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_8)) + (0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * t_1) + 0 / (x1 * r) * cn * (cn
    * dn * t_13)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (- (sn * dn *
    t_13))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_4 * t_13) - 0 / (2 * dn)))) in
  let t_15 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 in
  let t_16 := (0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * t_1) + 0 / (x1 * r) * cn * (cn *
    dn * t_15)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (- (sn * dn *
    t_15))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_4 * t_15) - 0 / (2 * dn)))) *
    (t_8 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_17 := sigma * (Q / (x3 * r)) * dn in
  let t_18 := (x2 ^ 2 - x3 ^ 2) * (Q / x2 * sn * t_17 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) *
    dn)) / x1 ^ 2 + (x2 ^ 2 - x3 ^ 2) * ((0 / x2 * sn + h * Q / x2) * t_17 + h * Q / x2 * sn *
    (sigma * (0 / (x3 * r)) * dn)) / x1 ^ 2 * (cn * dn * t_1) + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn *
    t_17 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) * dn)) / x1 ^ 2 * (- (sn * dn * t_1)) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  t_14 + t_16 = t_18 + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_17 + h * Q / x2 * sn * (sigma * (0 / (x3
    * r)) * dn + sigma * (Q / (x3 * r)))) / x1 ^ 2 * t_6.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by h, component 3 *)
Theorem sensitivity_of_the_spin_6 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 * J in
  let t_2 := 0 / x2 * sn + h * Q / x2 in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := h ^ 2 * p ^ 2 * sn * cn in
  let t_5 := 2 * h * p ^ 2 * sn ^ 2 in
  let t_6 := - (t_4 * t_1) - t_5 / (2 * dn) in
  let t_7 := 0 / x2 * sn + Q / x2 + ((0 / x2 * sn + 0 / x2 + 0 / x2) * (cn * dn * t_1) + t_2 * (cn *
    dn * t_3)) + ((0 / x2 * sn + 0 / x2) * (- (sn * dn * t_1)) + 0 / x2 * sn * (- (dn * t_1 + sn *
    dn * t_3))) + ((0 / x2 * sn + 0 / x2) * t_6 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * t_1 + t_4 *
    t_3) - 2 * h * p ^ 2 * (2 * sn) / (2 * dn))) in
  let t_8 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_9 := t * (0 / (x1 * x2 * x3)) in
  let t_10 := (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_1) + t_2 * (dn * t_1 + cn * dn *
    t_9)) + (0 / x2 * sn * (- (sn * dn * t_1)) + 0 / x2 * sn * (- (sn * dn * t_9))) + (0 / x2 * sn *
    t_6 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * sn * t_1 + t_4 * t_9) - 0 / (2 * dn)))) * (- (sn * dn *
    t_8)) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_1) + t_2 * (cn * t_1 + cn * dn *
    t_11)) + (0 / x2 * sn * (- (sn * dn * t_1)) + 0 / x2 * sn * (- (sn * t_1 + sn * dn * t_11))) +
    (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_4 * t_11) - (0 / (2 * dn) - t_5 * 2 / (2 * dn) ^ 2))))
    * (- (h ^ 2 * p ^ 2 * sn * cn * t_8)) in
  let t_13 := 0 / (x1 * x2 * x3) + t * (0 / (x1 * x2 * x3)) in
  let t_14 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 in
  let t_15 := t_7 * (cn * dn * t_8) + t_10 + t_12 + (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn *
    dn * t_1) + t_2 * (cn * dn * t_13)) + (0 / x2 * sn * (- (sn * dn * t_1)) + 0 / x2 * sn * (- (sn
    * dn * t_13))) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_4 * t_13) - 0 / (2 * dn)))) + (0 / x2
    * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_1) + t_2 * (cn * dn * t_14)) + (0 / x2 * sn * (-
    (sn * dn * t_1)) + 0 / x2 * sn * (- (sn * dn * t_14))) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (-
    (t_4 * t_14) - 0 / (2 * dn)))) * (t_8 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_16 := h * q * Q / (x1 * r) in
  let t_17 := sigma * (Q / (x3 * r)) * dn in
  let t_18 := (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_16 * cn) + t_17 * (q * Q / (x1 *
    r) * cn)) / x2 ^ 2 + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_16 * cn) + t_17 * (0
    / (x1 * r) * cn)) / x2 ^ 2 * (cn * dn * t_1) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn
    * (t_16 * cn) + t_17 * (0 / (x1 * r) * cn + t_16)) / x2 ^ 2 * (- (sn * dn * t_1)) in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  r <> 0 ->
  t_15 = t_18 + (x3 ^ 2 - x1 ^ 2) * ((sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) * (t_16
    * cn) + t_17 * (0 / (x1 * r) * cn)) / x2 ^ 2 * t_6.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by x1, component 1 *)
Theorem sensitivity_of_the_spin_7 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (0 / (x3 * r)) * dn in
  let t_2 := sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) in
  let t_3 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_4 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_5 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x2 * x3) / (x1 * x2 * x3) ^ 2 + t_3 * (x1 /
    x2) + t_4 * (x1 / x3) in
  let t_6 := sigma * (0 / (x3 * r)) * dn in
  let t_7 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_4 * (0 / x3))) in
  let t_8 := - (sn * dn * (t * t_5)) in
  let t_9 := sigma * (0 / (x3 * r)) * dn in
  let t_10 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (x1 / x2) + t_1 * (0 /
    x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (x1 / x3) + t_2 * dn * (0 / x3)) +
    (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_5)) + t_6 * (cn * dn * t_7)) + (sigma * (0 /
    (x3 * r)) * dn * t_8 + t_9 * (- (dn * (t * t_5) + sn * dn * t_7))) in
  let t_11 := h ^ 2 * p ^ 2 * sn * cn in
  let t_12 := - (t_11 * (t * t_5)) - 0 / (2 * dn) in
  let t_13 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_14 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_15 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_4 * (0 / x3))) in
  let t_16 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (x1 / x2) + t_1 * (0 /
    x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (x1 / x3) + t_2 * dn * (0 / x3)) +
    (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_5)) + t_6 * (dn * (t * t_5) + cn * dn * t_15))
    + (sigma * (0 / (x3 * r)) * dn * t_8 + t_9 * (- (sn * dn * t_15))) in
  let t_17 := (t_10 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_12 + t_13 * (- (h
    ^ 2 * p ^ 2 * cn * (t * t_5) + t_11 * t_7) - 0 / (2 * dn)))) * (cn * dn * t_14) + (t_16 +
    ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_12 + t_13 * (- (h ^ 2 * p ^ 2 * sn *
    (t * t_5) + t_11 * t_15) - 0 / (2 * dn)))) * (- (sn * dn * t_14)) in
  let t_18 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_4 * (0 / x3))) in
  let t_19 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (x1 / x2) + t_1 * (0 / x2)) + ((sigma * (0 / (x3 * r) - 0 / (x3 * r) ^
    2) * dn + t_2) * (x1 / x3) + t_2 * dn * (0 / x3)) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 /
    (x3 * r))) * (cn * dn * (t * t_5)) + t_6 * (cn * (t * t_5) + cn * dn * t_18)) in
  let t_20 := t_5 + t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 /
    (x1 * x2 * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^
    2) * (x1 / x3) + t_4 * (0 / x3))) in
  let t_21 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (x1 / x2) + t_1 * (0 /
    x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (x1 / x3) + t_2 * dn * (0 / x3)) +
    (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_5)) + t_6 * (cn * dn * t_20)) + (sigma * (0 /
    (x3 * r)) * dn * t_8 + t_9 * (- (sn * dn * t_20))) in
  let t_22 := t_17 + (t_19 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_8 + t_9 *
    (- (sn * (t * t_5) + sn * dn * t_18))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))
    + sigma * (0 / (x3 * r))) * t_12 + t_13 * (- (t_11 * t_18) - (0 / (2 * dn) - 0 / (2 * dn) ^
    2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_14)) + (t_21 + ((sigma * (0 / (x3 * r)) * dn + sigma *
    (0 / (x3 * r))) * t_12 + t_13 * (- (t_11 * t_20) - 0 / (2 * dn)))) in
  let t_23 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_4 * (0 / x3))) in
  let t_24 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (x1 / x2) + t_1 * (0 /
    x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (x1 / x3) + t_2 * dn * (0 / x3)) +
    (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_5)) + t_6 * (cn * dn * t_23)) + (sigma * (0 /
    (x3 * r)) * dn * t_8 + t_9 * (- (sn * dn * t_23))) in
  let t_25 := h * q * Q / (x1 * r) in
  let t_26 := t_25 * cn * (h * Q / x2 * sn) in
  let t_27 := (2 * x1 * t_26 + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1 * r) - h * q * Q * r / (x1 * r) ^ 2) *
    cn * (h * Q / x2 * sn) + t_25 * cn * (0 / x2 * sn))) / x3 ^ 2 + ((- (2 * x2)) * t_26 + (x1 ^ 2 -
    x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_25 * cn * ((0 / x2 - h * Q / x2 ^ 2) *
    sn))) / x3 ^ 2 * (x1 / x2) in
  let t_28 := t_27 + ((x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_25 * cn * (0 /
    x2 * sn)) / x3 ^ 2 - (x1 ^ 2 - x2 ^ 2) * t_26 * (2 * x3) / (x3 ^ 2) ^ 2) * (x1 / x3) + (x1 ^ 2 -
    x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_25 * cn * (0 / x2 * sn + h * Q / x2)) / x3
    ^ 2 * (cn * dn * (t * t_5)) in
  x3 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  t_22 + (t_24 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_12 + t_13 * (- (t_11 *
    t_23) - 0 / (2 * dn)))) * (t_14 * sn ^ 2 / (2 * dn ^ 2)) = t_28 + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1
    * r) * cn + t_25) * (h * Q / x2 * sn) + t_25 * cn * (0 / x2 * sn)) / x3 ^ 2 * t_8 + (x1 ^ 2 - x2
    ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_25 * cn * (0 / x2 * sn)) / x3 ^ 2 * t_12.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26
    t_27 t_28 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by x1, component 2 *)
Theorem sensitivity_of_the_spin_8 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_2 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_3 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x2 * x3) / (x1 * x2 * x3) ^ 2 + t_1 * (x1 /
    x2) + t_2 * (x1 / x3) in
  let t_4 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_1 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_2 * (0 / x3))) in
  let t_5 := - (sn * dn * (t * t_3)) in
  let t_6 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_7 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) * cn * (x1 / x2) + 0 / (x1 * r)
    * cn * (0 / x2)) + (0 / (x1 * r) * cn * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (0 / (x1 *
    r) * cn * (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (cn * dn * t_4)) + ((0 / (x1 * r) * cn + 0
    / (x1 * r)) * t_5 + t_6 * (- (dn * (t * t_3) + sn * dn * t_4))) in
  let t_8 := h ^ 2 * p ^ 2 * sn * cn in
  let t_9 := - (t_8 * (t * t_3)) - 0 / (2 * dn) in
  let t_10 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_11 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_1 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_2 * (0 / x3))) in
  let t_12 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) - h * q * Q * r / (x1 * r) ^ 2)
    + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (x1 / x2) + 0 / (x1 * r) * cn * (0 / x2)) + ((0 / (x1 *
    r) * cn + 0 / (x1 * r)) * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) * cn + 0 /
    (x1 * r)) * (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (dn * (t * t_3) + cn * dn * t_11)) in
  let t_13 := (t_7 + (0 / (x1 * r) * cn * t_9 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn * (t *
    t_3) + t_8 * t_4) - 0 / (2 * dn)))) * (cn * dn * t_10) + (t_12 + ((0 / (x1 * r) * cn + 0 / (x1 *
    r) + 0 / (x1 * r)) * t_5 + t_6 * (- (sn * dn * t_11))) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) *
    t_9 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * (t * t_3) + t_8 * t_11) - 0 / (2 * dn)))) *
    (- (sn * dn * t_10)) in
  let t_14 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_1 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_2 * (0 / x3))) in
  let t_15 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) * cn * (x1 / x2) + 0 / (x1 * r)
    * cn * (0 / x2)) + (0 / (x1 * r) * cn * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (0 / (x1 *
    r) * cn * (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (cn * (t * t_3) + cn * dn * t_14)) + ((0 /
    (x1 * r) * cn + 0 / (x1 * r)) * t_5 + t_6 * (- (sn * (t * t_3) + sn * dn * t_14))) in
  let t_16 := t_3 + t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 /
    (x1 * x2 * x3) ^ 2) * (x1 / x2) + t_1 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^
    2) * (x1 / x3) + t_2 * (0 / x3))) in
  let t_17 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) * cn * (x1 / x2) + 0 / (x1 * r)
    * cn * (0 / x2)) + (0 / (x1 * r) * cn * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (0 / (x1 *
    r) * cn * (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (cn * dn * t_16)) + ((0 / (x1 * r) * cn +
    0 / (x1 * r)) * t_5 + t_6 * (- (sn * dn * t_16))) in
  let t_18 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_1 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_2 * (0 / x3))) in
  let t_19 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) * cn * (x1 / x2) + 0 / (x1 * r)
    * cn * (0 / x2)) + (0 / (x1 * r) * cn * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (0 / (x1 *
    r) * cn * (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (cn * dn * t_18)) + ((0 / (x1 * r) * cn +
    0 / (x1 * r)) * t_5 + t_6 * (- (sn * dn * t_18))) in
  let t_20 := t_13 + (t_15 + (0 / (x1 * r) * cn * t_9 + 0 / (x1 * r) * cn * (- (t_8 * t_14) - (0 /
    (2 * dn) - 0 / (2 * dn) ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_10)) + (t_17 + (0 / (x1 * r) *
    cn * t_9 + 0 / (x1 * r) * cn * (- (t_8 * t_16) - 0 / (2 * dn)))) + (t_19 + (0 / (x1 * r) * cn *
    t_9 + 0 / (x1 * r) * cn * (- (t_8 * t_18) - 0 / (2 * dn)))) * (t_10 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_21 := sigma * (Q / (x3 * r)) * dn in
  let t_22 := h * Q / x2 * sn * t_21 in
  let t_23 := (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) *
    dn)) / x1 ^ 2 - (x2 ^ 2 - x3 ^ 2) * t_22 * (2 * x1) / (x1 ^ 2) ^ 2 + (2 * x2 * t_22 + (x2 ^ 2 -
    x3 ^ 2) * ((0 / x2 - h * Q / x2 ^ 2) * sn * t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) *
    dn))) / x1 ^ 2 * (x1 / x2) in
  let t_24 := t_23 + ((- (2 * x3)) * t_22 + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_21 + h * Q / x2 *
    sn * (sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) * dn))) / x1 ^ 2 * (x1 / x3) + (x2 ^ 2 - x3
    ^ 2) * ((0 / x2 * sn + h * Q / x2) * t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) * dn)) /
    x1 ^ 2 * (cn * dn * (t * t_3)) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  t_20 = t_24 + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r))
    * dn)) / x1 ^ 2 * t_5 + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_21 + h * Q / x2 * sn * (sigma * (0
    / (x3 * r)) * dn + sigma * (Q / (x3 * r)))) / x1 ^ 2 * t_9.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1 D_2
    D_3 D_4 D_5.
  rational.
Qed.

(* by x1, component 3 *)
Theorem sensitivity_of_the_spin_9 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / x2 - h * Q / x2 ^ 2 in
  let t_2 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_3 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_4 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x2 * x3) / (x1 * x2 * x3) ^ 2 + t_2 * (x1 /
    x2) + t_3 * (x1 / x3) in
  let t_5 := 0 / x2 * sn + h * Q / x2 in
  let t_6 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_3 * (0 / x3))) in
  let t_7 := - (sn * dn * (t * t_4)) in
  let t_8 := 0 / x2 * sn + 0 / x2 + (((0 / x2 - 0 / x2 ^ 2) * sn + t_1) * (x1 / x2) + t_1 * sn * (0
    / x2)) + ((0 / x2 * sn + 0 / x2) * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2
    + 0 / x2) * (cn * dn * (t * t_4)) + t_5 * (cn * dn * t_6)) + ((0 / x2 * sn + 0 / x2) * t_7 + 0 /
    x2 * sn * (- (dn * (t * t_4) + sn * dn * t_6))) in
  let t_9 := h ^ 2 * p ^ 2 * sn * cn in
  let t_10 := - (t_9 * (t * t_4)) - 0 / (2 * dn) in
  let t_11 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_12 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_3 * (0 / x3))) in
  let t_13 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (x1 / x2) + t_1 * sn * (0 / x2)) + (0 / x2
    * sn * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_4)) +
    t_5 * (dn * (t * t_4) + cn * dn * t_12)) + (0 / x2 * sn * t_7 + 0 / x2 * sn * (- (sn * dn *
    t_12))) in
  let t_14 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_3 * (0 / x3))) in
  let t_15 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (x1 / x2) + t_1 * sn * (0 / x2)) + (0 / x2
    * sn * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_4)) +
    t_5 * (cn * (t * t_4) + cn * dn * t_14)) + (0 / x2 * sn * t_7 + 0 / x2 * sn * (- (sn * (t * t_4)
    + sn * dn * t_14))) in
  let t_16 := (t_8 + ((0 / x2 * sn + 0 / x2) * t_10 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * (t *
    t_4) + t_9 * t_6) - 0 / (2 * dn)))) * (cn * dn * t_11) + (t_13 + (0 / x2 * sn * t_10 + 0 / x2 *
    sn * (- (h ^ 2 * p ^ 2 * sn * (t * t_4) + t_9 * t_12) - 0 / (2 * dn)))) * (- (sn * dn * t_11)) +
    (t_15 + (0 / x2 * sn * t_10 + 0 / x2 * sn * (- (t_9 * t_14) - (0 / (2 * dn) - 0 / (2 * dn) ^
    2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_11)) in
  let t_17 := t_4 + t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 /
    (x1 * x2 * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^
    2) * (x1 / x3) + t_3 * (0 / x3))) in
  let t_18 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (x1 / x2) + t_1 * sn * (0 / x2)) + (0 / x2
    * sn * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_4)) +
    t_5 * (cn * dn * t_17)) + (0 / x2 * sn * t_7 + 0 / x2 * sn * (- (sn * dn * t_17))) + (0 / x2 *
    sn * t_10 + 0 / x2 * sn * (- (t_9 * t_17) - 0 / (2 * dn))) in
  let t_19 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_3 * (0 / x3))) in
  let t_20 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (x1 / x2) + t_1 * sn * (0 / x2)) + (0 / x2
    * sn * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_4)) +
    t_5 * (cn * dn * t_19)) + (0 / x2 * sn * t_7 + 0 / x2 * sn * (- (sn * dn * t_19))) + (0 / x2 *
    sn * t_10 + 0 / x2 * sn * (- (t_9 * t_19) - 0 / (2 * dn))) in
  let t_21 := sigma * (Q / (x3 * r)) * dn in
  let t_22 := h * q * Q / (x1 * r) in
  let t_23 := ((- (2 * x1)) * (t_21 * (t_22 * cn)) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) *
    dn * (t_22 * cn) + t_21 * ((0 / (x1 * r) - h * q * Q * r / (x1 * r) ^ 2) * cn))) / x2 ^ 2 + ((x3
    ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_22 * cn) + t_21 * (0 / (x1 * r) * cn)) / x2 ^
    2 - (x3 ^ 2 - x1 ^ 2) * (t_21 * (t_22 * cn)) * (2 * x2) / (x2 ^ 2) ^ 2) * (x1 / x2) in
  let t_24 := t_23 + (2 * x3 * (t_21 * (t_22 * cn)) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r) - Q
    * r / (x3 * r) ^ 2) * dn * (t_22 * cn) + t_21 * (0 / (x1 * r) * cn))) / x2 ^ 2 * (x1 / x3) + (x3
    ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_22 * cn) + t_21 * (0 / (x1 * r) * cn)) / x2 ^
    2 * (cn * dn * (t * t_4)) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_22 * cn) +
    t_21 * (0 / (x1 * r) * cn + t_22)) / x2 ^ 2 * t_7 in
  x2 <> 0 ->
  x3 <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  r <> 0 ->
  t_16 + t_18 + t_20 * (t_11 * sn ^ 2 / (2 * dn ^ 2)) = t_24 + (x3 ^ 2 - x1 ^ 2) * ((sigma * (0 /
    (x3 * r)) * dn + sigma * (Q / (x3 * r))) * (t_22 * cn) + t_21 * (0 / (x1 * r) * cn)) / x2 ^ 2 *
    t_10.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1 D_2
    D_3 D_4 D_5.
  rational.
Qed.

(* by p, component 1 *)
Theorem sensitivity_of_the_spin_10 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (0 / (x3 * r)) * dn in
  let t_2 := sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) in
  let t_3 := sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) in
  let t_4 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_5 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_6 := 0 / (x1 * x2 * x3) + t_4 * (tau * p / x2) + t_5 * (tau * p / x3) + 0 / (x1 * x2 * x3) *
    (p / r) in
  let t_7 := t * t_6 - h ^ 2 * (2 * p) * J in
  let t_8 := sigma * (0 / (x3 * r)) * dn in
  let t_9 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_5 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_10 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (tau * p / x2) + t_1 * (0
    / x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau * p / x3) + t_2 * dn * (0 / x3))
    + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (p / r) + t_3 * dn * (0 / r)) + (sigma * (0
    / (x3 * r)) * dn * (cn * dn * t_7) + t_8 * (cn * dn * t_9)) in
  let t_11 := sigma * (0 / (x3 * r)) * dn in
  let t_12 := h ^ 2 * p ^ 2 * sn * cn in
  let t_13 := h ^ 2 * (2 * p) * sn ^ 2 in
  let t_14 := - (t_12 * t_7) - t_13 / (2 * dn) in
  let t_15 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_16 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_17 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_5 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_18 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (tau * p / x2) + t_1 * (0
    / x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau * p / x3) + t_2 * dn * (0 / x3))
    + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (p / r) + t_3 * dn * (0 / r)) + (sigma * (0
    / (x3 * r)) * dn * (cn * dn * t_7) + t_8 * (dn * t_7 + cn * dn * t_17)) in
  let t_19 := (t_10 + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_7)) + t_11 * (- (dn * t_7 + sn
    * dn * t_9))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_14 + t_15 * (- (h ^
    2 * p ^ 2 * cn * t_7 + t_12 * t_9) - h ^ 2 * (2 * p) * (2 * sn) / (2 * dn)))) * (cn * dn * t_16)
    + (t_18 + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_7)) + t_11 * (- (sn * dn * t_17))) +
    ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_14 + t_15 * (- (h ^ 2 * p ^ 2 * sn *
    t_7 + t_12 * t_17) - 0 / (2 * dn)))) * (- (sn * dn * t_16)) in
  let t_20 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (tau * p / x2) + t_1 * (0 / x2)) + ((sigma * (0 / (x3 * r) - 0 / (x3 *
    r) ^ 2) * dn + t_2) * (tau * p / x3) + t_2 * dn * (0 / x3)) + ((sigma * (0 / (x3 * r) - 0 / (x3
    * r) ^ 2) * dn + t_3) * (p / r) + t_3 * dn * (0 / r)) in
  let t_21 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_5 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_22 := t_20 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * (cn * dn * t_7) + t_8
    * (cn * t_7 + cn * dn * t_21)) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * (-
    (sn * dn * t_7)) + t_11 * (- (sn * t_7 + sn * dn * t_21))) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r)) + sigma * (0 / (x3 * r))) * t_14 + t_15 * (- (t_12 * t_21) - (0 / (2 *
    dn) - t_13 * 2 / (2 * dn) ^ 2))) in
  let t_23 := t_6 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * p / x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) +
    t_5 * (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_24 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (tau * p / x2) + t_1 * (0
    / x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau * p / x3) + t_2 * dn * (0 / x3))
    + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (p / r) + t_3 * dn * (0 / r)) + (sigma * (0
    / (x3 * r)) * dn * (cn * dn * t_7) + t_8 * (cn * dn * t_23)) in
  let t_25 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_5 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) - h ^ 2 * (2 * p) in
  let t_26 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (tau * p / x2) + t_1 * (0
    / x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau * p / x3) + t_2 * dn * (0 / x3))
    + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (p / r) + t_3 * dn * (0 / r)) + (sigma * (0
    / (x3 * r)) * dn * (cn * dn * t_7) + t_8 * (cn * dn * t_25)) in
  let t_27 := t_19 + t_22 * (- (h ^ 2 * p ^ 2 * sn * cn * t_16)) + (t_24 + (sigma * (0 / (x3 * r)) *
    dn * (- (sn * dn * t_7)) + t_11 * (- (sn * dn * t_23))) + ((sigma * (0 / (x3 * r)) * dn + sigma
    * (0 / (x3 * r))) * t_14 + t_15 * (- (t_12 * t_23) - 0 / (2 * dn)))) + (t_26 + (sigma * (0 / (x3
    * r)) * dn * (- (sn * dn * t_7)) + t_11 * (- (sn * dn * t_25))) + ((sigma * (0 / (x3 * r)) * dn
    + sigma * (0 / (x3 * r))) * t_14 + t_15 * (- (t_12 * t_25) - 0 / (2 * dn)))) * (t_16 * sn ^ 2 /
    (2 * dn ^ 2)) in
  let t_28 := h * q * Q / (x1 * r) in
  let t_29 := t_28 * cn * (h * Q / x2 * sn) in
  let t_30 := (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_28 * cn * (0 / x2 *
    sn)) / x3 ^ 2 + ((- (2 * x2)) * t_29 + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 *
    sn) + t_28 * cn * ((0 / x2 - h * Q / x2 ^ 2) * sn))) / x3 ^ 2 * (tau * p / x2) + ((x1 ^ 2 - x2 ^
    2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_28 * cn * (0 / x2 * sn)) / x3 ^ 2 - (x1 ^ 2 - x2
    ^ 2) * t_29 * (2 * x3) / (x3 ^ 2) ^ 2) * (tau * p / x3) in
  let t_31 := t_30 + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2) * cn * (h *
    Q / x2 * sn) + t_28 * cn * (0 / x2 * sn)) / x3 ^ 2 * (p / r) + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r)
    * cn * (h * Q / x2 * sn) + t_28 * cn * (0 / x2 * sn + h * Q / x2)) / x3 ^ 2 * (cn * dn * t_7) in
  x3 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  t_27 = t_31 + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1 * r) * cn + t_28) * (h * Q / x2 * sn) + t_28 * cn * (0
    / x2 * sn)) / x3 ^ 2 * (- (sn * dn * t_7)) + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q /
    x2 * sn) + t_28 * cn * (0 / x2 * sn)) / x3 ^ 2 * t_14.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25
    t_26 t_27 t_28 t_29 t_30 t_31 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by p, component 2 *)
Theorem sensitivity_of_the_spin_11 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2 in
  let t_2 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_3 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_4 := 0 / (x1 * x2 * x3) + t_2 * (tau * p / x2) + t_3 * (tau * p / x3) + 0 / (x1 * x2 * x3) *
    (p / r) in
  let t_5 := t * t_4 - h ^ 2 * (2 * p) * J in
  let t_6 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_3 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_7 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * p / x2) + 0 / (x1 * r) * cn * (0 / x2))
    + (0 / (x1 * r) * cn * (tau * p / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) - 0 / (x1
    * r) ^ 2) * cn * (p / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn * (cn * dn * t_5) + 0 / (x1
    * r) * cn * (cn * dn * t_6)) in
  let t_8 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_9 := h ^ 2 * p ^ 2 * sn * cn in
  let t_10 := h ^ 2 * (2 * p) * sn ^ 2 in
  let t_11 := - (t_9 * t_5) - t_10 / (2 * dn) in
  let t_12 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_13 := 0 / (x1 * r) * cn + 0 / (x1 * r) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (tau * p /
    x2) + 0 / (x1 * r) * cn * (0 / x2)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (tau * p / x3) + 0 /
    (x1 * r) * cn * (0 / x3)) + (((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + t_1) * (p / r) + t_1 * cn
    * (0 / r)) in
  let t_14 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_3 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_15 := t_13 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (cn * dn * t_5) + 0 / (x1 * r) * cn * (dn
    * t_5 + cn * dn * t_14)) + ((0 / (x1 * r) * cn + 0 / (x1 * r) + 0 / (x1 * r)) * (- (sn * dn *
    t_5)) + t_8 * (- (sn * dn * t_14))) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_11 + 0 / (x1 * r)
    * cn * (- (h ^ 2 * p ^ 2 * sn * t_5 + t_9 * t_14) - 0 / (2 * dn))) in
  let t_16 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_3 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_17 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * p / x2) + 0 / (x1 * r) * cn * (0 /
    x2)) + (0 / (x1 * r) * cn * (tau * p / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) - 0
    / (x1 * r) ^ 2) * cn * (p / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn * (cn * dn * t_5) + 0
    / (x1 * r) * cn * (cn * t_5 + cn * dn * t_16)) in
  let t_18 := (t_7 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_5)) + t_8 * (- (dn * t_5
    + sn * dn * t_6))) + (0 / (x1 * r) * cn * t_11 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn *
    t_5 + t_9 * t_6) - h ^ 2 * (2 * p) * (2 * sn) / (2 * dn)))) * (cn * dn * t_12) + t_15 * (- (sn *
    dn * t_12)) + (t_17 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_5)) + t_8 * (- (sn *
    t_5 + sn * dn * t_16))) + (0 / (x1 * r) * cn * t_11 + 0 / (x1 * r) * cn * (- (t_9 * t_16) - (0 /
    (2 * dn) - t_10 * 2 / (2 * dn) ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_12)) in
  let t_19 := t_4 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * p / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) +
    t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_20 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * p / x2) + 0 / (x1 * r) * cn * (0 /
    x2)) + (0 / (x1 * r) * cn * (tau * p / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) - 0
    / (x1 * r) ^ 2) * cn * (p / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn * (cn * dn * t_5) + 0
    / (x1 * r) * cn * (cn * dn * t_19)) in
  let t_21 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_3 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) - h ^ 2 * (2 * p) in
  let t_22 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * p / x2) + 0 / (x1 * r) * cn * (0 /
    x2)) + (0 / (x1 * r) * cn * (tau * p / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) - 0
    / (x1 * r) ^ 2) * cn * (p / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn * (cn * dn * t_5) + 0
    / (x1 * r) * cn * (cn * dn * t_21)) in
  let t_23 := t_18 + (t_20 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_5)) + t_8 * (-
    (sn * dn * t_19))) + (0 / (x1 * r) * cn * t_11 + 0 / (x1 * r) * cn * (- (t_9 * t_19) - 0 / (2 *
    dn)))) + (t_22 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_5)) + t_8 * (- (sn * dn *
    t_21))) + (0 / (x1 * r) * cn * t_11 + 0 / (x1 * r) * cn * (- (t_9 * t_21) - 0 / (2 * dn)))) *
    (t_12 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_24 := sigma * (Q / (x3 * r)) * dn in
  let t_25 := h * Q / x2 * sn * t_24 in
  let t_26 := (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_24 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) *
    dn)) / x1 ^ 2 + (2 * x2 * t_25 + (x2 ^ 2 - x3 ^ 2) * ((0 / x2 - h * Q / x2 ^ 2) * sn * t_24 + h
    * Q / x2 * sn * (sigma * (0 / (x3 * r)) * dn))) / x1 ^ 2 * (tau * p / x2) + ((- (2 * x3)) * t_25
    + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_24 + h * Q / x2 * sn * (sigma * (0 / (x3 * r) - Q * r /
    (x3 * r) ^ 2) * dn))) / x1 ^ 2 * (tau * p / x3) in
  let t_27 := t_26 + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_24 + h * Q / x2 * sn * (sigma * (0 / (x3 *
    r) - Q * x3 / (x3 * r) ^ 2) * dn)) / x1 ^ 2 * (p / r) + (x2 ^ 2 - x3 ^ 2) * ((0 / x2 * sn + h *
    Q / x2) * t_24 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) * dn)) / x1 ^ 2 * (cn * dn * t_5) +
    (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_24 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) * dn)) / x1
    ^ 2 * (- (sn * dn * t_5)) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  t_23 = t_27 + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_24 + h * Q / x2 * sn * (sigma * (0 / (x3 * r))
    * dn + sigma * (Q / (x3 * r)))) / x1 ^ 2 * t_11.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25
    t_26 t_27 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by p, component 3 *)
Theorem sensitivity_of_the_spin_12 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / x2 - h * Q / x2 ^ 2 in
  let t_2 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_3 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_4 := 0 / (x1 * x2 * x3) + t_2 * (tau * p / x2) + t_3 * (tau * p / x3) + 0 / (x1 * x2 * x3) *
    (p / r) in
  let t_5 := t * t_4 - h ^ 2 * (2 * p) * J in
  let t_6 := 0 / x2 * sn + h * Q / x2 in
  let t_7 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_3 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_8 := 0 / x2 * sn + 0 / x2 + (((0 / x2 - 0 / x2 ^ 2) * sn + t_1) * (tau * p / x2) + t_1 * sn
    * (0 / x2)) + ((0 / x2 * sn + 0 / x2) * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn
    + 0 / x2) * (p / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2 + 0 / x2) * (cn * dn *
    t_5) + t_6 * (cn * dn * t_7)) in
  let t_9 := h ^ 2 * p ^ 2 * sn * cn in
  let t_10 := h ^ 2 * (2 * p) * sn ^ 2 in
  let t_11 := - (t_9 * t_5) - t_10 / (2 * dn) in
  let t_12 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_13 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_3 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_14 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (tau * p / x2) + t_1 * sn * (0 / x2)) + (0
    / x2 * sn * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn * (p / r) + 0 / x2 * sn * (0
    / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_5) + t_6 * (dn * t_5 + cn * dn * t_13)) in
  let t_15 := (t_8 + ((0 / x2 * sn + 0 / x2) * (- (sn * dn * t_5)) + 0 / x2 * sn * (- (dn * t_5 + sn
    * dn * t_7))) + ((0 / x2 * sn + 0 / x2) * t_11 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * t_5 +
    t_9 * t_7) - h ^ 2 * (2 * p) * (2 * sn) / (2 * dn)))) * (cn * dn * t_12) + (t_14 + (0 / x2 * sn
    * (- (sn * dn * t_5)) + 0 / x2 * sn * (- (sn * dn * t_13))) + (0 / x2 * sn * t_11 + 0 / x2 * sn
    * (- (h ^ 2 * p ^ 2 * sn * t_5 + t_9 * t_13) - 0 / (2 * dn)))) * (- (sn * dn * t_12)) in
  let t_16 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_3 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_17 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (tau * p / x2) + t_1 * sn * (0 / x2)) + (0
    / x2 * sn * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn * (p / r) + 0 / x2 * sn * (0
    / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_5) + t_6 * (cn * t_5 + cn * dn * t_16)) in
  let t_18 := t_4 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * p / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) +
    t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_19 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (tau * p / x2) + t_1 * sn * (0 / x2)) + (0
    / x2 * sn * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn * (p / r) + 0 / x2 * sn * (0
    / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_5) + t_6 * (cn * dn * t_18)) + (0 / x2 * sn * (-
    (sn * dn * t_5)) + 0 / x2 * sn * (- (sn * dn * t_18))) in
  let t_20 := t_15 + (t_17 + (0 / x2 * sn * (- (sn * dn * t_5)) + 0 / x2 * sn * (- (sn * t_5 + sn *
    dn * t_16))) + (0 / x2 * sn * t_11 + 0 / x2 * sn * (- (t_9 * t_16) - (0 / (2 * dn) - t_10 * 2 /
    (2 * dn) ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_12)) + (t_19 + (0 / x2 * sn * t_11 + 0 / x2 *
    sn * (- (t_9 * t_18) - 0 / (2 * dn)))) in
  let t_21 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_3 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) - h ^ 2 * (2 * p) in
  let t_22 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (tau * p / x2) + t_1 * sn * (0 / x2)) + (0
    / x2 * sn * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn * (p / r) + 0 / x2 * sn * (0
    / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_5) + t_6 * (cn * dn * t_21)) + (0 / x2 * sn * (-
    (sn * dn * t_5)) + 0 / x2 * sn * (- (sn * dn * t_21))) in
  let t_23 := h * q * Q / (x1 * r) in
  let t_24 := sigma * (Q / (x3 * r)) * dn in
  let t_25 := (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_23 * cn) + t_24 * (0 / (x1 * r)
    * cn)) / x2 ^ 2 + ((x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_23 * cn) + t_24 * (0 /
    (x1 * r) * cn)) / x2 ^ 2 - (x3 ^ 2 - x1 ^ 2) * (t_24 * (t_23 * cn)) * (2 * x2) / (x2 ^ 2) ^ 2) *
    (tau * p / x2) + (2 * x3 * (t_24 * (t_23 * cn)) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r) - Q
    * r / (x3 * r) ^ 2) * dn * (t_23 * cn) + t_24 * (0 / (x1 * r) * cn))) / x2 ^ 2 * (tau * p / x3)
    in
  let t_26 := t_25 + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) * dn *
    (t_23 * cn) + t_24 * ((0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2) * cn)) / x2 ^ 2 * (p / r) +
    (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_23 * cn) + t_24 * (0 / (x1 * r) * cn)) /
    x2 ^ 2 * (cn * dn * t_5) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_23 * cn) + t_24
    * (0 / (x1 * r) * cn + t_23)) / x2 ^ 2 * (- (sn * dn * t_5)) in
  x2 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  t_20 + (t_22 + (0 / x2 * sn * t_11 + 0 / x2 * sn * (- (t_9 * t_21) - 0 / (2 * dn)))) * (t_12 * sn
    ^ 2 / (2 * dn ^ 2)) = t_26 + (x3 ^ 2 - x1 ^ 2) * ((sigma * (0 / (x3 * r)) * dn + sigma * (Q /
    (x3 * r))) * (t_23 * cn) + t_24 * (0 / (x1 * r) * cn)) / x2 ^ 2 * t_11.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25
    t_26 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by q, component 1 *)
Theorem sensitivity_of_the_spin_13 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) in
  let t_2 := sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) in
  let t_3 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_4 := sigma * tau * Q / (x1 * x2 * x3) + t_3 * (tau * q / x3) + 0 / (x1 * x2 * x3) * (q / r)
    in
  let t_5 := sigma * (0 / (x3 * r)) * dn in
  let t_6 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_7 := - (sn * dn * (t * t_4)) in
  let t_8 := sigma * (0 / (x3 * r)) * dn in
  let t_9 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau *
    q / x3) + t_1 * dn * (0 / x3)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (q / r) + t_2
    * dn * (0 / r)) + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_4)) + t_5 * (cn * dn * t_6))
    + (sigma * (0 / (x3 * r)) * dn * t_7 + t_8 * (- (dn * (t * t_4) + sn * dn * t_6))) in
  let t_10 := h ^ 2 * p ^ 2 * sn * cn in
  let t_11 := - (t_10 * (t * t_4)) - 0 / (2 * dn) in
  let t_12 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_13 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_14 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_15 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau *
    q / x3) + t_1 * dn * (0 / x3)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (q / r) + t_2
    * dn * (0 / r)) + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_4)) + t_5 * (dn * (t * t_4) +
    cn * dn * t_14)) in
  let t_16 := (t_9 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_11 + t_12 * (- (h ^
    2 * p ^ 2 * cn * (t * t_4) + t_10 * t_6) - 0 / (2 * dn)))) * (cn * dn * t_13) + (t_15 + (sigma *
    (0 / (x3 * r)) * dn * t_7 + t_8 * (- (sn * dn * t_14))) + ((sigma * (0 / (x3 * r)) * dn + sigma
    * (0 / (x3 * r))) * t_11 + t_12 * (- (h ^ 2 * p ^ 2 * sn * (t * t_4) + t_10 * t_14) - 0 / (2 *
    dn)))) * (- (sn * dn * t_13)) in
  let t_17 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_18 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r) - 0 /
    (x3 * r) ^ 2) * dn + t_1) * (tau * q / x3) + t_1 * dn * (0 / x3)) + ((sigma * (0 / (x3 * r) - 0
    / (x3 * r) ^ 2) * dn + t_2) * (q / r) + t_2 * dn * (0 / r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (cn * dn * (t * t_4)) + t_5 * (cn * (t * t_4) + cn * dn * t_17)) in
  let t_19 := t_4 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * q / x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_20 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau *
    q / x3) + t_1 * dn * (0 / x3)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (q / r) + t_2
    * dn * (0 / r)) + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_4)) + t_5 * (cn * dn * t_19))
    + (sigma * (0 / (x3 * r)) * dn * t_7 + t_8 * (- (sn * dn * t_19))) in
  let t_21 := t_16 + (t_18 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 *
    (- (sn * (t * t_4) + sn * dn * t_17))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))
    + sigma * (0 / (x3 * r))) * t_11 + t_12 * (- (t_10 * t_17) - (0 / (2 * dn) - 0 / (2 * dn) ^
    2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_13)) + (t_20 + ((sigma * (0 / (x3 * r)) * dn + sigma *
    (0 / (x3 * r))) * t_11 + t_12 * (- (t_10 * t_19) - 0 / (2 * dn)))) in
  let t_22 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_23 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau *
    q / x3) + t_1 * dn * (0 / x3)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (q / r) + t_2
    * dn * (0 / r)) + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_4)) + t_5 * (cn * dn * t_22))
    + (sigma * (0 / (x3 * r)) * dn * t_7 + t_8 * (- (sn * dn * t_22))) in
  let t_24 := h * q * Q / (x1 * r) in
  let t_25 := (x1 ^ 2 - x2 ^ 2) * (h * Q / (x1 * r) * cn * (h * Q / x2 * sn) + t_24 * cn * (0 / x2 *
    sn)) / x3 ^ 2 + ((x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_24 * cn * (0 /
    x2 * sn)) / x3 ^ 2 - (x1 ^ 2 - x2 ^ 2) * (t_24 * cn * (h * Q / x2 * sn)) * (2 * x3) / (x3 ^ 2) ^
    2) * (tau * q / x3) in
  let t_26 := t_25 + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2) * cn * (h *
    Q / x2 * sn) + t_24 * cn * (0 / x2 * sn)) / x3 ^ 2 * (q / r) + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r)
    * cn * (h * Q / x2 * sn) + t_24 * cn * (0 / x2 * sn + h * Q / x2)) / x3 ^ 2 * (cn * dn * (t *
    t_4)) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  dn <> 0 ->
  t_21 + (t_23 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_11 + t_12 * (- (t_10 *
    t_22) - 0 / (2 * dn)))) * (t_13 * sn ^ 2 / (2 * dn ^ 2)) = t_26 + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1
    * r) * cn + t_24) * (h * Q / x2 * sn) + t_24 * cn * (0 / x2 * sn)) / x3 ^ 2 * t_7 + (x1 ^ 2 - x2
    ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_24 * cn * (0 / x2 * sn)) / x3 ^ 2 * t_11.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26
    D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by q, component 2 *)
Theorem sensitivity_of_the_spin_14 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2 in
  let t_2 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_3 := sigma * tau * Q / (x1 * x2 * x3) + t_2 * (tau * q / x3) + 0 / (x1 * x2 * x3) * (q / r)
    in
  let t_4 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_5 := - (sn * dn * (t * t_3)) in
  let t_6 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_7 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * q / x3) + 0 / (x1 * r) * cn * (0 / x3))
    + ((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn * (q / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn *
    (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (cn * dn * t_4)) + ((0 / (x1 * r) * cn + 0 / (x1 *
    r)) * t_5 + t_6 * (- (dn * (t * t_3) + sn * dn * t_4))) in
  let t_8 := h ^ 2 * p ^ 2 * sn * cn in
  let t_9 := - (t_8 * (t * t_3)) - 0 / (2 * dn) in
  let t_10 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_11 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_12 := 0 / (x1 * r) * cn + h * Q / (x1 * r) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (tau * q
    / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + t_1) * (q /
    r) + t_1 * cn * (0 / r)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (cn * dn * (t * t_3)) + 0 / (x1
    * r) * cn * (dn * (t * t_3) + cn * dn * t_11)) in
  let t_13 := (t_7 + (0 / (x1 * r) * cn * t_9 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn * (t *
    t_3) + t_8 * t_4) - 0 / (2 * dn)))) * (cn * dn * t_10) + (t_12 + ((0 / (x1 * r) * cn + 0 / (x1 *
    r) + 0 / (x1 * r)) * t_5 + t_6 * (- (sn * dn * t_11))) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) *
    t_9 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * (t * t_3) + t_8 * t_11) - 0 / (2 * dn)))) *
    (- (sn * dn * t_10)) in
  let t_14 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_15 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * q / x3) + 0 / (x1 * r) * cn * (0 /
    x3)) + ((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn * (q / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) *
    cn * (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (cn * (t * t_3) + cn * dn * t_14)) + ((0 / (x1
    * r) * cn + 0 / (x1 * r)) * t_5 + t_6 * (- (sn * (t * t_3) + sn * dn * t_14))) in
  let t_16 := t_3 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * q / x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_17 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * q / x3) + 0 / (x1 * r) * cn * (0 /
    x3)) + ((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn * (q / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) *
    cn * (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (cn * dn * t_16)) + ((0 / (x1 * r) * cn + 0 /
    (x1 * r)) * t_5 + t_6 * (- (sn * dn * t_16))) in
  let t_18 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_19 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * q / x3) + 0 / (x1 * r) * cn * (0 /
    x3)) + ((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn * (q / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) *
    cn * (cn * dn * (t * t_3)) + 0 / (x1 * r) * cn * (cn * dn * t_18)) + ((0 / (x1 * r) * cn + 0 /
    (x1 * r)) * t_5 + t_6 * (- (sn * dn * t_18))) in
  let t_20 := t_13 + (t_15 + (0 / (x1 * r) * cn * t_9 + 0 / (x1 * r) * cn * (- (t_8 * t_14) - (0 /
    (2 * dn) - 0 / (2 * dn) ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_10)) + (t_17 + (0 / (x1 * r) *
    cn * t_9 + 0 / (x1 * r) * cn * (- (t_8 * t_16) - 0 / (2 * dn)))) + (t_19 + (0 / (x1 * r) * cn *
    t_9 + 0 / (x1 * r) * cn * (- (t_8 * t_18) - 0 / (2 * dn)))) * (t_10 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_21 := sigma * (Q / (x3 * r)) * dn in
  let t_22 := (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) *
    dn)) / x1 ^ 2 + ((- (2 * x3)) * (h * Q / x2 * sn * t_21) + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn *
    t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) * dn))) / x1 ^ 2 * (tau
    * q / x3) + (x2 ^ 2 - x3 ^ 2) * (0 / x2 * sn * t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r) -
    Q * x3 / (x3 * r) ^ 2) * dn)) / x1 ^ 2 * (q / r) in
  let t_23 := t_22 + (x2 ^ 2 - x3 ^ 2) * ((0 / x2 * sn + h * Q / x2) * t_21 + h * Q / x2 * sn *
    (sigma * (0 / (x3 * r)) * dn)) / x1 ^ 2 * (cn * dn * (t * t_3)) + (x2 ^ 2 - x3 ^ 2) * (0 / x2 *
    sn * t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) * dn)) / x1 ^ 2 * t_5 + (x2 ^ 2 - x3 ^ 2)
    * (0 / x2 * sn * t_21 + h * Q / x2 * sn * (sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 *
    r)))) / x1 ^ 2 * t_9 in
  x1 <> 0 ->
  r <> 0 ->
  x3 <> 0 ->
  x2 <> 0 ->
  dn <> 0 ->
  t_20 = t_23.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 D_1 D_2 D_3
    D_4 D_5.
  rational.
Qed.

(* by q, component 3 *)
Theorem sensitivity_of_the_spin_15 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / (x1 * x2 * x3) - sigma * tau * q * Q * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_2 := sigma * tau * Q / (x1 * x2 * x3) + t_1 * (tau * q / x3) + 0 / (x1 * x2 * x3) * (q / r)
    in
  let t_3 := 0 / x2 * sn + h * Q / x2 in
  let t_4 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_1 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_5 := - (sn * dn * (t * t_2)) in
  let t_6 := 0 / x2 * sn + 0 / x2 + ((0 / x2 * sn + 0 / x2) * (tau * q / x3) + 0 / x2 * sn * (0 /
    x3)) + ((0 / x2 * sn + 0 / x2) * (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2 + 0 /
    x2) * (cn * dn * (t * t_2)) + t_3 * (cn * dn * t_4)) + ((0 / x2 * sn + 0 / x2) * t_5 + 0 / x2 *
    sn * (- (dn * (t * t_2) + sn * dn * t_4))) in
  let t_7 := h ^ 2 * p ^ 2 * sn * cn in
  let t_8 := - (t_7 * (t * t_2)) - 0 / (2 * dn) in
  let t_9 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_10 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_1 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_11 := 0 / x2 * sn + (0 / x2 * sn * (tau * q / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn *
    (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_2)) + t_3 * (dn *
    (t * t_2) + cn * dn * t_10)) + (0 / x2 * sn * t_5 + 0 / x2 * sn * (- (sn * dn * t_10))) in
  let t_12 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_1 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_13 := 0 / x2 * sn + (0 / x2 * sn * (tau * q / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn *
    (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_2)) + t_3 * (cn *
    (t * t_2) + cn * dn * t_12)) + (0 / x2 * sn * t_5 + 0 / x2 * sn * (- (sn * (t * t_2) + sn * dn *
    t_12))) in
  let t_14 := (t_6 + ((0 / x2 * sn + 0 / x2) * t_8 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * (t *
    t_2) + t_7 * t_4) - 0 / (2 * dn)))) * (cn * dn * t_9) + (t_11 + (0 / x2 * sn * t_8 + 0 / x2 * sn
    * (- (h ^ 2 * p ^ 2 * sn * (t * t_2) + t_7 * t_10) - 0 / (2 * dn)))) * (- (sn * dn * t_9)) +
    (t_13 + (0 / x2 * sn * t_8 + 0 / x2 * sn * (- (t_7 * t_12) - (0 / (2 * dn) - 0 / (2 * dn) ^
    2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * t_9)) in
  let t_15 := t_2 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * q / x3) + t_1 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_16 := 0 / x2 * sn + (0 / x2 * sn * (tau * q / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn *
    (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_2)) + t_3 * (cn *
    dn * t_15)) + (0 / x2 * sn * t_5 + 0 / x2 * sn * (- (sn * dn * t_15))) + (0 / x2 * sn * t_8 + 0
    / x2 * sn * (- (t_7 * t_15) - 0 / (2 * dn))) in
  let t_17 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_1 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_18 := 0 / x2 * sn + (0 / x2 * sn * (tau * q / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn *
    (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_2)) + t_3 * (cn *
    dn * t_17)) + (0 / x2 * sn * t_5 + 0 / x2 * sn * (- (sn * dn * t_17))) + (0 / x2 * sn * t_8 + 0
    / x2 * sn * (- (t_7 * t_17) - 0 / (2 * dn))) in
  let t_19 := h * q * Q / (x1 * r) in
  let t_20 := sigma * (Q / (x3 * r)) * dn in
  let t_21 := (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_19 * cn) + t_20 * (h * Q / (x1 *
    r) * cn)) / x2 ^ 2 + (2 * x3 * (t_20 * (t_19 * cn)) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)
    - Q * r / (x3 * r) ^ 2) * dn * (t_19 * cn) + t_20 * (0 / (x1 * r) * cn))) / x2 ^ 2 * (tau * q /
    x3) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) * dn * (t_19 * cn) +
    t_20 * ((0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2) * cn)) / x2 ^ 2 * (q / r) in
  let t_22 := t_21 + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (t_19 * cn) + t_20 * (0 /
    (x1 * r) * cn)) / x2 ^ 2 * (cn * dn * (t * t_2)) + (x3 ^ 2 - x1 ^ 2) * (sigma * (0 / (x3 * r)) *
    dn * (t_19 * cn) + t_20 * (0 / (x1 * r) * cn + t_19)) / x2 ^ 2 * t_5 + (x3 ^ 2 - x1 ^ 2) *
    ((sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) * (t_19 * cn) + t_20 * (0 / (x1 * r) *
    cn)) / x2 ^ 2 * t_8 in
  x2 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  t_14 + t_16 + t_18 * (t_9 * sn ^ 2 / (2 * dn ^ 2)) = t_22.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 D_1 D_2 D_3 D_4
    D_5.
  rational.
Qed.

(* by Q, component 1 *)
Theorem sensitivity_of_the_spin_16 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q / (x1 * x2 * x3) in
  let t_2 := sigma * (0 / (x3 * r)) * dn in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := - (sn * dn * (t * t_1)) in
  let t_5 := sigma * (0 / (x3 * r)) * dn in
  let t_6 := h ^ 2 * p ^ 2 * sn * cn in
  let t_7 := - (t_6 * (t * t_1)) - 0 / (2 * dn) in
  let t_8 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_9 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_1)) +
    t_2 * (cn * dn * t_3)) + (sigma * (0 / (x3 * r)) * dn * t_4 + t_5 * (- (dn * (t * t_1) + sn * dn
    * t_3))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2 * p ^
    2 * cn * (t * t_1) + t_6 * t_3) - 0 / (2 * dn))) in
  let t_10 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_1)) +
    t_2 * (dn * (t * t_1) + cn * dn * t_11)) + (sigma * (0 / (x3 * r)) * dn * t_4 + t_5 * (- (sn *
    dn * t_11))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2 *
    p ^ 2 * sn * (t * t_1) + t_6 * t_11) - 0 / (2 * dn))) in
  let t_13 := t * (0 / (x1 * x2 * x3)) in
  let t_14 := sigma * (0 / (x3 * r)) * dn + sigma * (1 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (cn * dn * (t * t_1)) + t_2 * (cn * (t * t_1) + cn * dn * t_13)) +
    ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_4 + t_5 * (- (sn * (t * t_1) + sn *
    dn * t_13))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + sigma * (0 / (x3 * r)))
    * t_7 + t_8 * (- (t_6 * t_13) - (0 / (2 * dn) - 0 / (2 * dn) ^ 2))) in
  let t_15 := t_1 + t * (0 / (x1 * x2 * x3)) in
  let t_16 := t_9 * (cn * dn * t_10) + t_12 * (- (sn * dn * t_10)) + t_14 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_10)) + (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t *
    t_1)) + t_2 * (cn * dn * t_15)) + (sigma * (0 / (x3 * r)) * dn * t_4 + t_5 * (- (sn * dn *
    t_15))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_6 * t_15)
    - 0 / (2 * dn)))) in
  let t_17 := t * (0 / (x1 * x2 * x3)) in
  let t_18 := t_16 + (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t *
    t_1)) + t_2 * (cn * dn * t_17)) + (sigma * (0 / (x3 * r)) * dn * t_4 + t_5 * (- (sn * dn *
    t_17))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_6 * t_17)
    - 0 / (2 * dn)))) * (t_10 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_19 := h * q * Q / (x1 * r) in
  let t_20 := (x2 ^ 2 - x1 ^ 2) * (h / x2 * sn * (t_19 * cn) + h * Q / x2 * sn * (h * q / (x1 * r) *
    cn)) / x3 ^ 2 + (x2 ^ 2 - x1 ^ 2) * ((0 / x2 * sn + h * Q / x2) * (t_19 * cn) + h * Q / x2 * sn
    * (0 / (x1 * r) * cn)) / x3 ^ 2 * (cn * dn * (t * t_1)) + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn *
    (t_19 * cn) + h * Q / x2 * sn * (0 / (x1 * r) * cn + t_19)) / x3 ^ 2 * t_4 in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  dn <> 0 ->
  t_18 = t_20 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_19 * cn) + h * Q / x2 * sn * (0 / (x1 * r) *
    cn)) / x3 ^ 2 * t_7.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by Q, component 2 *)
Theorem sensitivity_of_the_spin_17 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q / (x1 * x2 * x3) in
  let t_2 := 0 / x2 * sn + h * Q / x2 in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := - (sn * dn * (t * t_1)) in
  let t_5 := h ^ 2 * p ^ 2 * sn * cn in
  let t_6 := - (t_5 * (t * t_1)) - 0 / (2 * dn) in
  let t_7 := 0 / x2 * sn + h / x2 + ((0 / x2 * sn + 0 / x2 + 0 / x2) * (cn * dn * (t * t_1)) + t_2 *
    (cn * dn * t_3)) + ((0 / x2 * sn + 0 / x2) * t_4 + 0 / x2 * sn * (- (dn * (t * t_1) + sn * dn *
    t_3))) + ((0 / x2 * sn + 0 / x2) * t_6 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * (t * t_1) + t_5
    * t_3) - 0 / (2 * dn))) in
  let t_8 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_9 := t * (0 / (x1 * x2 * x3)) in
  let t_10 := (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_1)) + t_2 * (dn * (t * t_1)
    + cn * dn * t_9)) + (0 / x2 * sn * t_4 + 0 / x2 * sn * (- (sn * dn * t_9))) + (0 / x2 * sn * t_6
    + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * sn * (t * t_1) + t_5 * t_9) - 0 / (2 * dn)))) * (- (sn * dn
    * t_8)) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_1)) + t_2 * (cn * (t * t_1)
    + cn * dn * t_11)) + (0 / x2 * sn * t_4 + 0 / x2 * sn * (- (sn * (t * t_1) + sn * dn * t_11))) +
    (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_5 * t_11) - (0 / (2 * dn) - 0 / (2 * dn) ^ 2)))) * (-
    (h ^ 2 * p ^ 2 * sn * cn * t_8)) in
  let t_13 := t_1 + t * (0 / (x1 * x2 * x3)) in
  let t_14 := t * (0 / (x1 * x2 * x3)) in
  let t_15 := t_7 * (cn * dn * t_8) + t_10 + t_12 + (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn *
    dn * (t * t_1)) + t_2 * (cn * dn * t_13)) + (0 / x2 * sn * t_4 + 0 / x2 * sn * (- (sn * dn *
    t_13))) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_5 * t_13) - 0 / (2 * dn)))) + (0 / x2 * sn +
    ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_1)) + t_2 * (cn * dn * t_14)) + (0 / x2 * sn * t_4 +
    0 / x2 * sn * (- (sn * dn * t_14))) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_5 * t_14) - 0 /
    (2 * dn)))) * (t_8 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_16 := sigma * (Q / (x3 * r)) * dn in
  let t_17 := h * q * Q / (x1 * r) in
  let t_18 := (x1 ^ 2 - x3 ^ 2) * (h * q / (x1 * r) * cn * t_16 + t_17 * cn * (sigma * (1 / (x3 *
    r)) * dn)) / x2 ^ 2 + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_16 + t_17 * cn * (sigma * (0 /
    (x3 * r)) * dn)) / x2 ^ 2 * (cn * dn * (t * t_1)) + (x1 ^ 2 - x3 ^ 2) * ((0 / (x1 * r) * cn +
    t_17) * t_16 + t_17 * cn * (sigma * (0 / (x3 * r)) * dn)) / x2 ^ 2 * t_4 in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  r <> 0 ->
  t_15 = t_18 + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_16 + t_17 * cn * (sigma * (0 / (x3 * r))
    * dn + sigma * (Q / (x3 * r)))) / x2 ^ 2 * t_6.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by Q, component 3 *)
Theorem sensitivity_of_the_spin_18 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q / (x1 * x2 * x3) in
  let t_2 := t * (0 / (x1 * x2 * x3)) in
  let t_3 := - (sn * dn * (t * t_1)) in
  let t_4 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_5 := h ^ 2 * p ^ 2 * sn * cn in
  let t_6 := - (t_5 * (t * t_1)) - 0 / (2 * dn) in
  let t_7 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * (t * t_1)) + 0 / (x1 * r) * cn *
    (cn * dn * t_2)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_3 + t_4 * (- (dn * (t * t_1) + sn *
    dn * t_2))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn * (t * t_1)
    + t_5 * t_2) - 0 / (2 * dn))) in
  let t_8 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_9 := t * (0 / (x1 * x2 * x3)) in
  let t_10 := 0 / (x1 * r) * cn + h * q / (x1 * r) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (cn * dn
    * (t * t_1)) + 0 / (x1 * r) * cn * (dn * (t * t_1) + cn * dn * t_9)) + ((0 / (x1 * r) * cn + 0 /
    (x1 * r) + 0 / (x1 * r)) * t_3 + t_4 * (- (sn * dn * t_9))) + ((0 / (x1 * r) * cn + 0 / (x1 *
    r)) * t_6 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * (t * t_1) + t_5 * t_9) - 0 / (2 * dn)))
    in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * (t * t_1)) + 0 / (x1 * r) * cn *
    (cn * (t * t_1) + cn * dn * t_11)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_3 + t_4 * (- (sn *
    (t * t_1) + sn * dn * t_11))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_5 * t_11) -
    (0 / (2 * dn) - 0 / (2 * dn) ^ 2))) in
  let t_13 := t_1 + t * (0 / (x1 * x2 * x3)) in
  let t_14 := t_7 * (cn * dn * t_8) + t_10 * (- (sn * dn * t_8)) + t_12 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_8)) + (0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * (t * t_1)) + 0 / (x1 * r) * cn
    * (cn * dn * t_13)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_3 + t_4 * (- (sn * dn * t_13))) +
    (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_5 * t_13) - 0 / (2 * dn)))) in
  let t_15 := t * (0 / (x1 * x2 * x3)) in
  let t_16 := (0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * (t * t_1)) + 0 / (x1 * r) * cn *
    (cn * dn * t_15)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_3 + t_4 * (- (sn * dn * t_15))) + (0
    / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_5 * t_15) - 0 / (2 * dn)))) * (t_8 * sn ^ 2 /
    (2 * dn ^ 2)) in
  let t_17 := sigma * (Q / (x3 * r)) * dn in
  let t_18 := (x3 ^ 2 - x2 ^ 2) * (sigma * (1 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_17 * (h / x2
    * sn)) / x1 ^ 2 + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_17 *
    (0 / x2 * sn + h * Q / x2)) / x1 ^ 2 * (cn * dn * (t * t_1)) + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 /
    (x3 * r)) * dn * (h * Q / x2 * sn) + t_17 * (0 / x2 * sn)) / x1 ^ 2 * t_3 in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  t_14 + t_16 = t_18 + (x3 ^ 2 - x2 ^ 2) * ((sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) *
    (h * Q / x2 * sn) + t_17 * (0 / x2 * sn)) / x1 ^ 2 * t_6.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by h, component 1 *)
Theorem sensitivity_of_the_spin_19 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 * J in
  let t_2 := sigma * (0 / (x3 * r)) * dn in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := sigma * (0 / (x3 * r)) * dn in
  let t_5 := h ^ 2 * p ^ 2 * sn * cn in
  let t_6 := 2 * h * p ^ 2 * sn ^ 2 in
  let t_7 := - (t_5 * t_1) - t_6 / (2 * dn) in
  let t_8 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_9 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (cn * dn * t_3)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (dn * t_1 + sn
    * dn * t_3))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2
    * p ^ 2 * cn * t_1 + t_5 * t_3) - 2 * h * p ^ 2 * (2 * sn) / (2 * dn))) in
  let t_10 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (dn * t_1 + cn * dn * t_11)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn
    * dn * t_11))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2
    * p ^ 2 * sn * t_1 + t_5 * t_11) - 0 / (2 * dn))) in
  let t_13 := t * (0 / (x1 * x2 * x3)) in
  let t_14 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (cn * dn * t_1) + t_2 * (cn * t_1 + cn * dn * t_13)) + ((sigma * (0 /
    (x3 * r)) * dn + sigma * (0 / (x3 * r))) * (- (sn * dn * t_1)) + t_4 * (- (sn * t_1 + sn * dn *
    t_13))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + sigma * (0 / (x3 * r))) * t_7
    + t_8 * (- (t_5 * t_13) - (0 / (2 * dn) - t_6 * 2 / (2 * dn) ^ 2))) in
  let t_15 := 0 / (x1 * x2 * x3) + t * (0 / (x1 * x2 * x3)) in
  let t_16 := t_9 * (cn * dn * t_10) + t_12 * (- (sn * dn * t_10)) + t_14 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_10)) + (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) +
    t_2 * (cn * dn * t_15)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn * dn
    * t_15))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_5 *
    t_15) - 0 / (2 * dn)))) in
  let t_17 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 in
  let t_18 := (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (cn * dn * t_17)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn * dn *
    t_17))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_5 * t_17)
    - 0 / (2 * dn)))) * (t_10 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_19 := h * q * Q / (x1 * r) in
  let t_20 := (x2 ^ 2 - x1 ^ 2) * (Q / x2 * sn * (t_19 * cn) + h * Q / x2 * sn * (q * Q / (x1 * r) *
    cn)) / x3 ^ 2 + (x2 ^ 2 - x1 ^ 2) * ((0 / x2 * sn + h * Q / x2) * (t_19 * cn) + h * Q / x2 * sn
    * (0 / (x1 * r) * cn)) / x3 ^ 2 * (cn * dn * t_1) + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_19 *
    cn) + h * Q / x2 * sn * (0 / (x1 * r) * cn + t_19)) / x3 ^ 2 * (- (sn * dn * t_1)) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  dn <> 0 ->
  t_16 + t_18 = t_20 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_19 * cn) + h * Q / x2 * sn * (0 / (x1 *
    r) * cn)) / x3 ^ 2 * t_7.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by h, component 2 *)
Theorem sensitivity_of_the_spin_20 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 * J in
  let t_2 := 0 / x2 * sn + h * Q / x2 in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := h ^ 2 * p ^ 2 * sn * cn in
  let t_5 := 2 * h * p ^ 2 * sn ^ 2 in
  let t_6 := - (t_4 * t_1) - t_5 / (2 * dn) in
  let t_7 := 0 / x2 * sn + Q / x2 + ((0 / x2 * sn + 0 / x2 + 0 / x2) * (cn * dn * t_1) + t_2 * (cn *
    dn * t_3)) + ((0 / x2 * sn + 0 / x2) * (- (sn * dn * t_1)) + 0 / x2 * sn * (- (dn * t_1 + sn *
    dn * t_3))) + ((0 / x2 * sn + 0 / x2) * t_6 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * t_1 + t_4 *
    t_3) - 2 * h * p ^ 2 * (2 * sn) / (2 * dn))) in
  let t_8 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_9 := t * (0 / (x1 * x2 * x3)) in
  let t_10 := (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_1) + t_2 * (dn * t_1 + cn * dn *
    t_9)) + (0 / x2 * sn * (- (sn * dn * t_1)) + 0 / x2 * sn * (- (sn * dn * t_9))) + (0 / x2 * sn *
    t_6 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * sn * t_1 + t_4 * t_9) - 0 / (2 * dn)))) * (- (sn * dn *
    t_8)) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_1) + t_2 * (cn * t_1 + cn * dn *
    t_11)) + (0 / x2 * sn * (- (sn * dn * t_1)) + 0 / x2 * sn * (- (sn * t_1 + sn * dn * t_11))) +
    (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_4 * t_11) - (0 / (2 * dn) - t_5 * 2 / (2 * dn) ^ 2))))
    * (- (h ^ 2 * p ^ 2 * sn * cn * t_8)) in
  let t_13 := 0 / (x1 * x2 * x3) + t * (0 / (x1 * x2 * x3)) in
  let t_14 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 in
  let t_15 := t_7 * (cn * dn * t_8) + t_10 + t_12 + (0 / x2 * sn + ((0 / x2 * sn + 0 / x2) * (cn *
    dn * t_1) + t_2 * (cn * dn * t_13)) + (0 / x2 * sn * (- (sn * dn * t_1)) + 0 / x2 * sn * (- (sn
    * dn * t_13))) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (t_4 * t_13) - 0 / (2 * dn)))) + (0 / x2
    * sn + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_1) + t_2 * (cn * dn * t_14)) + (0 / x2 * sn * (-
    (sn * dn * t_1)) + 0 / x2 * sn * (- (sn * dn * t_14))) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (-
    (t_4 * t_14) - 0 / (2 * dn)))) * (t_8 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_16 := sigma * (Q / (x3 * r)) * dn in
  let t_17 := h * q * Q / (x1 * r) in
  let t_18 := (x1 ^ 2 - x3 ^ 2) * (q * Q / (x1 * r) * cn * t_16 + t_17 * cn * (sigma * (0 / (x3 *
    r)) * dn)) / x2 ^ 2 + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_16 + t_17 * cn * (sigma * (0 /
    (x3 * r)) * dn)) / x2 ^ 2 * (cn * dn * t_1) + (x1 ^ 2 - x3 ^ 2) * ((0 / (x1 * r) * cn + t_17) *
    t_16 + t_17 * cn * (sigma * (0 / (x3 * r)) * dn)) / x2 ^ 2 * (- (sn * dn * t_1)) in
  x2 <> 0 ->
  x1 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  r <> 0 ->
  t_15 = t_18 + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_16 + t_17 * cn * (sigma * (0 / (x3 * r))
    * dn + sigma * (Q / (x3 * r)))) / x2 ^ 2 * t_6.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by h, component 3 *)
Theorem sensitivity_of_the_spin_21 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 * J in
  let t_2 := t * (0 / (x1 * x2 * x3)) in
  let t_3 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_4 := h ^ 2 * p ^ 2 * sn * cn in
  let t_5 := 2 * h * p ^ 2 * sn ^ 2 in
  let t_6 := - (t_4 * t_1) - t_5 / (2 * dn) in
  let t_7 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * t_1) + 0 / (x1 * r) * cn * (cn * dn
    * t_2)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (- (dn * t_1 + sn *
    dn * t_2))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn * t_1 + t_4
    * t_2) - 2 * h * p ^ 2 * (2 * sn) / (2 * dn))) in
  let t_8 := (- sigma) * tau * q * Q / (x1 * x2 * x3) in
  let t_9 := t * (0 / (x1 * x2 * x3)) in
  let t_10 := 0 / (x1 * r) * cn + q * Q / (x1 * r) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (cn * dn
    * t_1) + 0 / (x1 * r) * cn * (dn * t_1 + cn * dn * t_9)) + ((0 / (x1 * r) * cn + 0 / (x1 * r) +
    0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (- (sn * dn * t_9))) + ((0 / (x1 * r) * cn + 0 / (x1
    * r)) * t_6 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * t_1 + t_4 * t_9) - 0 / (2 * dn))) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * t_1) + 0 / (x1 * r) * cn * (cn *
    t_1 + cn * dn * t_11)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (-
    (sn * t_1 + sn * dn * t_11))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_4 * t_11) -
    (0 / (2 * dn) - t_5 * 2 / (2 * dn) ^ 2))) in
  let t_13 := 0 / (x1 * x2 * x3) + t * (0 / (x1 * x2 * x3)) in
  let t_14 := t_7 * (cn * dn * t_8) + t_10 * (- (sn * dn * t_8)) + t_12 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_8)) + (0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * t_1) + 0 / (x1 * r) * cn * (cn
    * dn * t_13)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (- (sn * dn *
    t_13))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_4 * t_13) - 0 / (2 * dn)))) in
  let t_15 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 in
  let t_16 := (0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (cn * dn * t_1) + 0 / (x1 * r) * cn * (cn *
    dn * t_15)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_1)) + t_3 * (- (sn * dn *
    t_15))) + (0 / (x1 * r) * cn * t_6 + 0 / (x1 * r) * cn * (- (t_4 * t_15) - 0 / (2 * dn)))) *
    (t_8 * sn ^ 2 / (2 * dn ^ 2)) in
  let t_17 := sigma * (Q / (x3 * r)) * dn in
  let t_18 := (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_17 * (Q / x2
    * sn)) / x1 ^ 2 + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_17 *
    (0 / x2 * sn + h * Q / x2)) / x1 ^ 2 * (cn * dn * t_1) + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 *
    r)) * dn * (h * Q / x2 * sn) + t_17 * (0 / x2 * sn)) / x1 ^ 2 * (- (sn * dn * t_1)) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  t_14 + t_16 = t_18 + (x3 ^ 2 - x2 ^ 2) * ((sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) *
    (h * Q / x2 * sn) + t_17 * (0 / x2 * sn)) / x1 ^ 2 * t_6.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by x1, component 1 *)
Theorem sensitivity_of_the_spin_22 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (0 / (x3 * r)) * dn in
  let t_2 := sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) in
  let t_3 := (- sigma) * tau * q * Q in
  let t_4 := 0 / (x1 * x2 * x3) - t_3 * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_5 := 0 / (x1 * x2 * x3) - t_3 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_6 := 0 / (x1 * x2 * x3) - t_3 * (x2 * x3) / (x1 * x2 * x3) ^ 2 + t_4 * (x1 / x2) + t_5 * (x1
    / x3) in
  let t_7 := sigma * (0 / (x3 * r)) * dn in
  let t_8 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_5 * (0 / x3))) in
  let t_9 := - (sn * dn * (t * t_6)) in
  let t_10 := sigma * (0 / (x3 * r)) * dn in
  let t_11 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (x1 / x2) + t_1 * (0 /
    x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (x1 / x3) + t_2 * dn * (0 / x3)) +
    (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_6)) + t_7 * (cn * dn * t_8)) + (sigma * (0 /
    (x3 * r)) * dn * t_9 + t_10 * (- (dn * (t * t_6) + sn * dn * t_8))) in
  let t_12 := h ^ 2 * p ^ 2 * sn * cn in
  let t_13 := - (t_12 * (t * t_6)) - 0 / (2 * dn) in
  let t_14 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_15 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_5 * (0 / x3))) in
  let t_16 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (x1 / x2) + t_1 * (0 /
    x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (x1 / x3) + t_2 * dn * (0 / x3)) +
    (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_6)) + t_7 * (dn * (t * t_6) + cn * dn * t_15))
    + (sigma * (0 / (x3 * r)) * dn * t_9 + t_10 * (- (sn * dn * t_15))) in
  let t_17 := (t_11 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_13 + t_14 * (- (h
    ^ 2 * p ^ 2 * cn * (t * t_6) + t_12 * t_8) - 0 / (2 * dn)))) * (cn * dn * (t_3 / (x1 * x2 *
    x3))) + (t_16 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_13 + t_14 * (- (h ^
    2 * p ^ 2 * sn * (t * t_6) + t_12 * t_15) - 0 / (2 * dn)))) * (- (sn * dn * (t_3 / (x1 * x2 *
    x3)))) in
  let t_18 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_5 * (0 / x3))) in
  let t_19 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (x1 / x2) + t_1 * (0 / x2)) + ((sigma * (0 / (x3 * r) - 0 / (x3 * r) ^
    2) * dn + t_2) * (x1 / x3) + t_2 * dn * (0 / x3)) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 /
    (x3 * r))) * (cn * dn * (t * t_6)) + t_7 * (cn * (t * t_6) + cn * dn * t_18)) in
  let t_20 := (t_19 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_9 + t_10 * (- (sn
    * (t * t_6) + sn * dn * t_18))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + sigma
    * (0 / (x3 * r))) * t_13 + t_14 * (- (t_12 * t_18) - (0 / (2 * dn) - 0 / (2 * dn) ^ 2)))) * (-
    (h ^ 2 * p ^ 2 * sn * cn * (t_3 / (x1 * x2 * x3)))) in
  let t_21 := t_6 + t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 /
    (x1 * x2 * x3) ^ 2) * (x1 / x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^
    2) * (x1 / x3) + t_5 * (0 / x3))) in
  let t_22 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (x1 / x2) + t_1 * (0 /
    x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (x1 / x3) + t_2 * dn * (0 / x3)) +
    (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_6)) + t_7 * (cn * dn * t_21)) + (sigma * (0 /
    (x3 * r)) * dn * t_9 + t_10 * (- (sn * dn * t_21))) in
  let t_23 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_4 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_5 * (0 / x3))) in
  let t_24 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (x1 / x2) + t_1 * (0 /
    x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (x1 / x3) + t_2 * dn * (0 / x3)) +
    (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_6)) + t_7 * (cn * dn * t_23)) + (sigma * (0 /
    (x3 * r)) * dn * t_9 + t_10 * (- (sn * dn * t_23))) in
  let t_25 := h * q * Q / (x1 * r) in
  let t_26 := h * Q / x2 * sn * (t_25 * cn) in
  let t_27 := ((- (2 * x1)) * t_26 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_25 * cn) + h * Q / x2 *
    sn * ((0 / (x1 * r) - h * q * Q * r / (x1 * r) ^ 2) * cn))) / x3 ^ 2 + (2 * x2 * t_26 + (x2 ^ 2
    - x1 ^ 2) * ((0 / x2 - h * Q / x2 ^ 2) * sn * (t_25 * cn) + h * Q / x2 * sn * (0 / (x1 * r) *
    cn))) / x3 ^ 2 * (x1 / x2) in
  let t_28 := t_27 + ((x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_25 * cn) + h * Q / x2 * sn * (0 / (x1 *
    r) * cn)) / x3 ^ 2 - (x2 ^ 2 - x1 ^ 2) * t_26 * (2 * x3) / (x3 ^ 2) ^ 2) * (x1 / x3) + (x2 ^ 2 -
    x1 ^ 2) * ((0 / x2 * sn + h * Q / x2) * (t_25 * cn) + h * Q / x2 * sn * (0 / (x1 * r) * cn)) /
    x3 ^ 2 * (cn * dn * (t * t_6)) in
  x3 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  t_17 + t_20 + (t_22 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_13 + t_14 * (-
    (t_12 * t_21) - 0 / (2 * dn)))) + (t_24 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 *
    r))) * t_13 + t_14 * (- (t_12 * t_23) - 0 / (2 * dn)))) * (t_3 / (x1 * x2 * x3) * sn ^ 2 / (2 *
    dn ^ 2)) = t_28 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_25 * cn) + h * Q / x2 * sn * (0 / (x1 *
    r) * cn + t_25)) / x3 ^ 2 * t_9 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_25 * cn) + h * Q / x2 *
    sn * (0 / (x1 * r) * cn)) / x3 ^ 2 * t_13.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26
    t_27 t_28 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by x1, component 2 *)
Theorem sensitivity_of_the_spin_23 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / x2 - h * Q / x2 ^ 2 in
  let t_2 := (- sigma) * tau * q * Q in
  let t_3 := 0 / (x1 * x2 * x3) - t_2 * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_4 := 0 / (x1 * x2 * x3) - t_2 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_5 := 0 / (x1 * x2 * x3) - t_2 * (x2 * x3) / (x1 * x2 * x3) ^ 2 + t_3 * (x1 / x2) + t_4 * (x1
    / x3) in
  let t_6 := 0 / x2 * sn + h * Q / x2 in
  let t_7 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_4 * (0 / x3))) in
  let t_8 := - (sn * dn * (t * t_5)) in
  let t_9 := 0 / x2 * sn + 0 / x2 + (((0 / x2 - 0 / x2 ^ 2) * sn + t_1) * (x1 / x2) + t_1 * sn * (0
    / x2)) + ((0 / x2 * sn + 0 / x2) * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2
    + 0 / x2) * (cn * dn * (t * t_5)) + t_6 * (cn * dn * t_7)) + ((0 / x2 * sn + 0 / x2) * t_8 + 0 /
    x2 * sn * (- (dn * (t * t_5) + sn * dn * t_7))) in
  let t_10 := h ^ 2 * p ^ 2 * sn * cn in
  let t_11 := - (t_10 * (t * t_5)) - 0 / (2 * dn) in
  let t_12 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_4 * (0 / x3))) in
  let t_13 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (x1 / x2) + t_1 * sn * (0 / x2)) + (0 / x2
    * sn * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_5)) +
    t_6 * (dn * (t * t_5) + cn * dn * t_12)) + (0 / x2 * sn * t_8 + 0 / x2 * sn * (- (sn * dn *
    t_12))) in
  let t_14 := (t_9 + ((0 / x2 * sn + 0 / x2) * t_11 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * (t *
    t_5) + t_10 * t_7) - 0 / (2 * dn)))) * (cn * dn * (t_2 / (x1 * x2 * x3))) + (t_13 + (0 / x2 * sn
    * t_11 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * sn * (t * t_5) + t_10 * t_12) - 0 / (2 * dn)))) * (-
    (sn * dn * (t_2 / (x1 * x2 * x3)))) in
  let t_15 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_4 * (0 / x3))) in
  let t_16 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (x1 / x2) + t_1 * sn * (0 / x2)) + (0 / x2
    * sn * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_5)) +
    t_6 * (cn * (t * t_5) + cn * dn * t_15)) + (0 / x2 * sn * t_8 + 0 / x2 * sn * (- (sn * (t * t_5)
    + sn * dn * t_15))) in
  let t_17 := t_5 + t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 /
    (x1 * x2 * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^
    2) * (x1 / x3) + t_4 * (0 / x3))) in
  let t_18 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (x1 / x2) + t_1 * sn * (0 / x2)) + (0 / x2
    * sn * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_5)) +
    t_6 * (cn * dn * t_17)) + (0 / x2 * sn * t_8 + 0 / x2 * sn * (- (sn * dn * t_17))) + (0 / x2 *
    sn * t_11 + 0 / x2 * sn * (- (t_10 * t_17) - 0 / (2 * dn))) in
  let t_19 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_4 * (0 / x3))) in
  let t_20 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (x1 / x2) + t_1 * sn * (0 / x2)) + (0 / x2
    * sn * (x1 / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_5)) +
    t_6 * (cn * dn * t_19)) + (0 / x2 * sn * t_8 + 0 / x2 * sn * (- (sn * dn * t_19))) + (0 / x2 *
    sn * t_11 + 0 / x2 * sn * (- (t_10 * t_19) - 0 / (2 * dn))) in
  let t_21 := h * q * Q / (x1 * r) in
  let t_22 := sigma * (Q / (x3 * r)) * dn in
  let t_23 := (2 * x1 * (t_21 * cn * t_22) + (x1 ^ 2 - x3 ^ 2) * ((0 / (x1 * r) - h * q * Q * r /
    (x1 * r) ^ 2) * cn * t_22 + t_21 * cn * (sigma * (0 / (x3 * r)) * dn))) / x2 ^ 2 + ((x1 ^ 2 - x3
    ^ 2) * (0 / (x1 * r) * cn * t_22 + t_21 * cn * (sigma * (0 / (x3 * r)) * dn)) / x2 ^ 2 - (x1 ^ 2
    - x3 ^ 2) * (t_21 * cn * t_22) * (2 * x2) / (x2 ^ 2) ^ 2) * (x1 / x2) in
  let t_24 := t_23 + ((- (2 * x3)) * (t_21 * cn * t_22) + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn *
    t_22 + t_21 * cn * (sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) * dn))) / x2 ^ 2 * (x1 / x3) +
    (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_22 + t_21 * cn * (sigma * (0 / (x3 * r)) * dn)) / x2
    ^ 2 * (cn * dn * (t * t_5)) + (x1 ^ 2 - x3 ^ 2) * ((0 / (x1 * r) * cn + t_21) * t_22 + t_21 * cn
    * (sigma * (0 / (x3 * r)) * dn)) / x2 ^ 2 * t_8 in
  x2 <> 0 ->
  x3 <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  r <> 0 ->
  t_14 + (t_16 + (0 / x2 * sn * t_11 + 0 / x2 * sn * (- (t_10 * t_15) - (0 / (2 * dn) - 0 / (2 * dn)
    ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * (t_2 / (x1 * x2 * x3)))) + t_18 + t_20 * (t_2 / (x1 * x2
    * x3) * sn ^ 2 / (2 * dn ^ 2)) = t_24 + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_22 + t_21 *
    cn * (sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)))) / x2 ^ 2 * t_11.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1 D_2
    D_3 D_4 D_5.
  rational.
Qed.

(* by x1, component 3 *)
Theorem sensitivity_of_the_spin_24 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q * Q in
  let t_2 := 0 / (x1 * x2 * x3) - t_1 * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_3 := 0 / (x1 * x2 * x3) - t_1 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_4 := 0 / (x1 * x2 * x3) - t_1 * (x2 * x3) / (x1 * x2 * x3) ^ 2 + t_2 * (x1 / x2) + t_3 * (x1
    / x3) in
  let t_5 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_3 * (0 / x3))) in
  let t_6 := - (sn * dn * (t * t_4)) in
  let t_7 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_8 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) * cn * (x1 / x2) + 0 / (x1 * r)
    * cn * (0 / x2)) + (0 / (x1 * r) * cn * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (0 / (x1 *
    r) * cn * (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (cn * dn * t_5)) + ((0 / (x1 * r) * cn + 0
    / (x1 * r)) * t_6 + t_7 * (- (dn * (t * t_4) + sn * dn * t_5))) in
  let t_9 := h ^ 2 * p ^ 2 * sn * cn in
  let t_10 := - (t_9 * (t * t_4)) - 0 / (2 * dn) in
  let t_11 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_3 * (0 / x3))) in
  let t_12 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) - h * q * Q * r / (x1 * r) ^ 2)
    + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (x1 / x2) + 0 / (x1 * r) * cn * (0 / x2)) + ((0 / (x1 *
    r) * cn + 0 / (x1 * r)) * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) * cn + 0 /
    (x1 * r)) * (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (dn * (t * t_4) + cn * dn * t_11)) in
  let t_13 := (t_8 + (0 / (x1 * r) * cn * t_10 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn * (t *
    t_4) + t_9 * t_5) - 0 / (2 * dn)))) * (cn * dn * (t_1 / (x1 * x2 * x3))) + (t_12 + ((0 / (x1 *
    r) * cn + 0 / (x1 * r) + 0 / (x1 * r)) * t_6 + t_7 * (- (sn * dn * t_11))) + ((0 / (x1 * r) * cn
    + 0 / (x1 * r)) * t_10 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * (t * t_4) + t_9 * t_11) -
    0 / (2 * dn)))) * (- (sn * dn * (t_1 / (x1 * x2 * x3)))) in
  let t_14 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_3 * (0 / x3))) in
  let t_15 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) * cn * (x1 / x2) + 0 / (x1 * r)
    * cn * (0 / x2)) + (0 / (x1 * r) * cn * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (0 / (x1 *
    r) * cn * (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (cn * (t * t_4) + cn * dn * t_14)) + ((0 /
    (x1 * r) * cn + 0 / (x1 * r)) * t_6 + t_7 * (- (sn * (t * t_4) + sn * dn * t_14))) in
  let t_16 := t_4 + t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 /
    (x1 * x2 * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^
    2) * (x1 / x3) + t_3 * (0 / x3))) in
  let t_17 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) * cn * (x1 / x2) + 0 / (x1 * r)
    * cn * (0 / x2)) + (0 / (x1 * r) * cn * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (0 / (x1 *
    r) * cn * (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (cn * dn * t_16)) + ((0 / (x1 * r) * cn +
    0 / (x1 * r)) * t_6 + t_7 * (- (sn * dn * t_16))) in
  let t_18 := t * (0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2 + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2
    * x3) ^ 2) * (x1 / x2) + t_2 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (x1
    / x3) + t_3 * (0 / x3))) in
  let t_19 := (0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + (0 / (x1 * r) * cn * (x1 / x2) + 0 / (x1 * r)
    * cn * (0 / x2)) + (0 / (x1 * r) * cn * (x1 / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (0 / (x1 *
    r) * cn * (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (cn * dn * t_18)) + ((0 / (x1 * r) * cn +
    0 / (x1 * r)) * t_6 + t_7 * (- (sn * dn * t_18))) in
  let t_20 := t_13 + (t_15 + (0 / (x1 * r) * cn * t_10 + 0 / (x1 * r) * cn * (- (t_9 * t_14) - (0 /
    (2 * dn) - 0 / (2 * dn) ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * (t_1 / (x1 * x2 * x3)))) + (t_17
    + (0 / (x1 * r) * cn * t_10 + 0 / (x1 * r) * cn * (- (t_9 * t_16) - 0 / (2 * dn)))) + (t_19 + (0
    / (x1 * r) * cn * t_10 + 0 / (x1 * r) * cn * (- (t_9 * t_18) - 0 / (2 * dn)))) * (t_1 / (x1 * x2
    * x3) * sn ^ 2 / (2 * dn ^ 2)) in
  let t_21 := sigma * (Q / (x3 * r)) * dn in
  let t_22 := t_21 * (h * Q / x2 * sn) in
  let t_23 := (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_21 * (0 / x2
    * sn)) / x1 ^ 2 - (x3 ^ 2 - x2 ^ 2) * t_22 * (2 * x1) / (x1 ^ 2) ^ 2 + ((- (2 * x2)) * t_22 +
    (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_21 * ((0 / x2 - h * Q /
    x2 ^ 2) * sn))) / x1 ^ 2 * (x1 / x2) in
  let t_24 := t_23 + (2 * x3 * t_22 + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r) - Q * r / (x3 * r)
    ^ 2) * dn * (h * Q / x2 * sn) + t_21 * (0 / x2 * sn))) / x1 ^ 2 * (x1 / x3) + (x3 ^ 2 - x2 ^ 2)
    * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_21 * (0 / x2 * sn + h * Q / x2)) / x1 ^ 2
    * (cn * dn * (t * t_4)) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  t_20 = t_24 + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_21 * (0 /
    x2 * sn)) / x1 ^ 2 * t_6 + (x3 ^ 2 - x2 ^ 2) * ((sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3
    * r))) * (h * Q / x2 * sn) + t_21 * (0 / x2 * sn)) / x1 ^ 2 * t_10.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1 D_2
    D_3 D_4 D_5.
  rational.
Qed.

(* by p, component 1 *)
Theorem sensitivity_of_the_spin_25 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (0 / (x3 * r)) * dn in
  let t_2 := sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) in
  let t_3 := sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) in
  let t_4 := (- sigma) * tau * q * Q in
  let t_5 := 0 / (x1 * x2 * x3) - t_4 * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_6 := 0 / (x1 * x2 * x3) - t_4 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_7 := 0 / (x1 * x2 * x3) + t_5 * (tau * p / x2) + t_6 * (tau * p / x3) + 0 / (x1 * x2 * x3) *
    (p / r) in
  let t_8 := t * t_7 - h ^ 2 * (2 * p) * J in
  let t_9 := sigma * (0 / (x3 * r)) * dn in
  let t_10 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_5 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_6 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_11 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (tau * p / x2) + t_1 * (0
    / x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau * p / x3) + t_2 * dn * (0 / x3))
    + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (p / r) + t_3 * dn * (0 / r)) + (sigma * (0
    / (x3 * r)) * dn * (cn * dn * t_8) + t_9 * (cn * dn * t_10)) in
  let t_12 := sigma * (0 / (x3 * r)) * dn in
  let t_13 := h ^ 2 * p ^ 2 * sn * cn in
  let t_14 := h ^ 2 * (2 * p) * sn ^ 2 in
  let t_15 := - (t_13 * t_8) - t_14 / (2 * dn) in
  let t_16 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_17 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_5 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_6 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_18 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (tau * p / x2) + t_1 * (0
    / x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau * p / x3) + t_2 * dn * (0 / x3))
    + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (p / r) + t_3 * dn * (0 / r)) + (sigma * (0
    / (x3 * r)) * dn * (cn * dn * t_8) + t_9 * (dn * t_8 + cn * dn * t_17)) in
  let t_19 := (t_11 + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_8)) + t_12 * (- (dn * t_8 + sn
    * dn * t_10))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_15 + t_16 * (- (h ^
    2 * p ^ 2 * cn * t_8 + t_13 * t_10) - h ^ 2 * (2 * p) * (2 * sn) / (2 * dn)))) * (cn * dn * (t_4
    / (x1 * x2 * x3))) + (t_18 + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_8)) + t_12 * (- (sn
    * dn * t_17))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_15 + t_16 * (- (h ^
    2 * p ^ 2 * sn * t_8 + t_13 * t_17) - 0 / (2 * dn)))) * (- (sn * dn * (t_4 / (x1 * x2 * x3))))
    in
  let t_20 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (tau * p / x2) + t_1 * (0 / x2)) + ((sigma * (0 / (x3 * r) - 0 / (x3 *
    r) ^ 2) * dn + t_2) * (tau * p / x3) + t_2 * dn * (0 / x3)) + ((sigma * (0 / (x3 * r) - 0 / (x3
    * r) ^ 2) * dn + t_3) * (p / r) + t_3 * dn * (0 / r)) in
  let t_21 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_5 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_6 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_22 := t_20 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * (cn * dn * t_8) + t_9
    * (cn * t_8 + cn * dn * t_21)) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * (-
    (sn * dn * t_8)) + t_12 * (- (sn * t_8 + sn * dn * t_21))) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r)) + sigma * (0 / (x3 * r))) * t_15 + t_16 * (- (t_13 * t_21) - (0 / (2 *
    dn) - t_14 * 2 / (2 * dn) ^ 2))) in
  let t_23 := t_7 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * p / x2) + t_5 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) +
    t_6 * (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_24 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (tau * p / x2) + t_1 * (0
    / x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau * p / x3) + t_2 * dn * (0 / x3))
    + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (p / r) + t_3 * dn * (0 / r)) + (sigma * (0
    / (x3 * r)) * dn * (cn * dn * t_8) + t_9 * (cn * dn * t_23)) in
  let t_25 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_5 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_6 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) - h ^ 2 * (2 * p) in
  let t_26 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (tau * p / x2) + t_1 * (0
    / x2)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau * p / x3) + t_2 * dn * (0 / x3))
    + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (p / r) + t_3 * dn * (0 / r)) + (sigma * (0
    / (x3 * r)) * dn * (cn * dn * t_8) + t_9 * (cn * dn * t_25)) in
  let t_27 := t_19 + t_22 * (- (h ^ 2 * p ^ 2 * sn * cn * (t_4 / (x1 * x2 * x3)))) + (t_24 + (sigma
    * (0 / (x3 * r)) * dn * (- (sn * dn * t_8)) + t_12 * (- (sn * dn * t_23))) + ((sigma * (0 / (x3
    * r)) * dn + sigma * (0 / (x3 * r))) * t_15 + t_16 * (- (t_13 * t_23) - 0 / (2 * dn)))) + (t_26
    + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_8)) + t_12 * (- (sn * dn * t_25))) + ((sigma *
    (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_15 + t_16 * (- (t_13 * t_25) - 0 / (2 * dn))))
    * (t_4 / (x1 * x2 * x3) * sn ^ 2 / (2 * dn ^ 2)) in
  let t_28 := h * q * Q / (x1 * r) in
  let t_29 := h * Q / x2 * sn * (t_28 * cn) in
  let t_30 := (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_28 * cn) + h * Q / x2 * sn * (0 / (x1 * r) *
    cn)) / x3 ^ 2 + (2 * x2 * t_29 + (x2 ^ 2 - x1 ^ 2) * ((0 / x2 - h * Q / x2 ^ 2) * sn * (t_28 *
    cn) + h * Q / x2 * sn * (0 / (x1 * r) * cn))) / x3 ^ 2 * (tau * p / x2) + ((x2 ^ 2 - x1 ^ 2) *
    (0 / x2 * sn * (t_28 * cn) + h * Q / x2 * sn * (0 / (x1 * r) * cn)) / x3 ^ 2 - (x2 ^ 2 - x1 ^ 2)
    * t_29 * (2 * x3) / (x3 ^ 2) ^ 2) * (tau * p / x3) in
  let t_31 := t_30 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_28 * cn) + h * Q / x2 * sn * ((0 / (x1 *
    r) - h * q * Q * x1 / (x1 * r) ^ 2) * cn)) / x3 ^ 2 * (p / r) + (x2 ^ 2 - x1 ^ 2) * ((0 / x2 *
    sn + h * Q / x2) * (t_28 * cn) + h * Q / x2 * sn * (0 / (x1 * r) * cn)) / x3 ^ 2 * (cn * dn *
    t_8) in
  x3 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  t_27 = t_31 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_28 * cn) + h * Q / x2 * sn * (0 / (x1 * r) *
    cn + t_28)) / x3 ^ 2 * (- (sn * dn * t_8)) + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_28 * cn) + h
    * Q / x2 * sn * (0 / (x1 * r) * cn)) / x3 ^ 2 * t_15.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25
    t_26 t_27 t_28 t_29 t_30 t_31 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by p, component 2 *)
Theorem sensitivity_of_the_spin_26 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / x2 - h * Q / x2 ^ 2 in
  let t_2 := (- sigma) * tau * q * Q in
  let t_3 := 0 / (x1 * x2 * x3) - t_2 * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_4 := 0 / (x1 * x2 * x3) - t_2 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_5 := 0 / (x1 * x2 * x3) + t_3 * (tau * p / x2) + t_4 * (tau * p / x3) + 0 / (x1 * x2 * x3) *
    (p / r) in
  let t_6 := t * t_5 - h ^ 2 * (2 * p) * J in
  let t_7 := 0 / x2 * sn + h * Q / x2 in
  let t_8 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_4 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_9 := 0 / x2 * sn + 0 / x2 + (((0 / x2 - 0 / x2 ^ 2) * sn + t_1) * (tau * p / x2) + t_1 * sn
    * (0 / x2)) + ((0 / x2 * sn + 0 / x2) * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + ((0 / x2 * sn
    + 0 / x2) * (p / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2 + 0 / x2) * (cn * dn *
    t_6) + t_7 * (cn * dn * t_8)) in
  let t_10 := h ^ 2 * p ^ 2 * sn * cn in
  let t_11 := h ^ 2 * (2 * p) * sn ^ 2 in
  let t_12 := - (t_10 * t_6) - t_11 / (2 * dn) in
  let t_13 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_4 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_14 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (tau * p / x2) + t_1 * sn * (0 / x2)) + (0
    / x2 * sn * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn * (p / r) + 0 / x2 * sn * (0
    / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_6) + t_7 * (dn * t_6 + cn * dn * t_13)) in
  let t_15 := (t_9 + ((0 / x2 * sn + 0 / x2) * (- (sn * dn * t_6)) + 0 / x2 * sn * (- (dn * t_6 + sn
    * dn * t_8))) + ((0 / x2 * sn + 0 / x2) * t_12 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * t_6 +
    t_10 * t_8) - h ^ 2 * (2 * p) * (2 * sn) / (2 * dn)))) * (cn * dn * (t_2 / (x1 * x2 * x3))) +
    (t_14 + (0 / x2 * sn * (- (sn * dn * t_6)) + 0 / x2 * sn * (- (sn * dn * t_13))) + (0 / x2 * sn
    * t_12 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * sn * t_6 + t_10 * t_13) - 0 / (2 * dn)))) * (- (sn *
    dn * (t_2 / (x1 * x2 * x3)))) in
  let t_16 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_4 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_17 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (tau * p / x2) + t_1 * sn * (0 / x2)) + (0
    / x2 * sn * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn * (p / r) + 0 / x2 * sn * (0
    / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_6) + t_7 * (cn * t_6 + cn * dn * t_16)) in
  let t_18 := t_5 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * p / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) +
    t_4 * (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_19 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (tau * p / x2) + t_1 * sn * (0 / x2)) + (0
    / x2 * sn * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn * (p / r) + 0 / x2 * sn * (0
    / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_6) + t_7 * (cn * dn * t_18)) + (0 / x2 * sn * (-
    (sn * dn * t_6)) + 0 / x2 * sn * (- (sn * dn * t_18))) in
  let t_20 := t_15 + (t_17 + (0 / x2 * sn * (- (sn * dn * t_6)) + 0 / x2 * sn * (- (sn * t_6 + sn *
    dn * t_16))) + (0 / x2 * sn * t_12 + 0 / x2 * sn * (- (t_10 * t_16) - (0 / (2 * dn) - t_11 * 2 /
    (2 * dn) ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * (t_2 / (x1 * x2 * x3)))) + (t_19 + (0 / x2 * sn
    * t_12 + 0 / x2 * sn * (- (t_10 * t_18) - 0 / (2 * dn)))) in
  let t_21 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_4 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) - h ^ 2 * (2 * p) in
  let t_22 := 0 / x2 * sn + ((0 / x2 - 0 / x2 ^ 2) * sn * (tau * p / x2) + t_1 * sn * (0 / x2)) + (0
    / x2 * sn * (tau * p / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn * (p / r) + 0 / x2 * sn * (0
    / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * t_6) + t_7 * (cn * dn * t_21)) + (0 / x2 * sn * (-
    (sn * dn * t_6)) + 0 / x2 * sn * (- (sn * dn * t_21))) in
  let t_23 := sigma * (Q / (x3 * r)) * dn in
  let t_24 := h * q * Q / (x1 * r) in
  let t_25 := (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_23 + t_24 * cn * (sigma * (0 / (x3 * r)) *
    dn)) / x2 ^ 2 + ((x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_23 + t_24 * cn * (sigma * (0 / (x3 *
    r)) * dn)) / x2 ^ 2 - (x1 ^ 2 - x3 ^ 2) * (t_24 * cn * t_23) * (2 * x2) / (x2 ^ 2) ^ 2) * (tau *
    p / x2) + ((- (2 * x3)) * (t_24 * cn * t_23) + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_23 +
    t_24 * cn * (sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) * dn))) / x2 ^ 2 * (tau * p / x3) in
  let t_26 := t_25 + (x1 ^ 2 - x3 ^ 2) * ((0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2) * cn * t_23
    + t_24 * cn * (sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) * dn)) / x2 ^ 2 * (p / r) + (x1 ^
    2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_23 + t_24 * cn * (sigma * (0 / (x3 * r)) * dn)) / x2 ^ 2 *
    (cn * dn * t_6) + (x1 ^ 2 - x3 ^ 2) * ((0 / (x1 * r) * cn + t_24) * t_23 + t_24 * cn * (sigma *
    (0 / (x3 * r)) * dn)) / x2 ^ 2 * (- (sn * dn * t_6)) in
  x2 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  t_20 + (t_22 + (0 / x2 * sn * t_12 + 0 / x2 * sn * (- (t_10 * t_21) - 0 / (2 * dn)))) * (t_2 / (x1
    * x2 * x3) * sn ^ 2 / (2 * dn ^ 2)) = t_26 + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_23 +
    t_24 * cn * (sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)))) / x2 ^ 2 * t_12.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25
    t_26 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by p, component 3 *)
Theorem sensitivity_of_the_spin_27 :
  forall J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2 in
  let t_2 := (- sigma) * tau * q * Q in
  let t_3 := 0 / (x1 * x2 * x3) - t_2 * (x1 * x3) / (x1 * x2 * x3) ^ 2 in
  let t_4 := 0 / (x1 * x2 * x3) - t_2 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_5 := 0 / (x1 * x2 * x3) + t_3 * (tau * p / x2) + t_4 * (tau * p / x3) + 0 / (x1 * x2 * x3) *
    (p / r) in
  let t_6 := t * t_5 - h ^ 2 * (2 * p) * J in
  let t_7 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_4 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_8 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * p / x2) + 0 / (x1 * r) * cn * (0 / x2))
    + (0 / (x1 * r) * cn * (tau * p / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) - 0 / (x1
    * r) ^ 2) * cn * (p / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn * (cn * dn * t_6) + 0 / (x1
    * r) * cn * (cn * dn * t_7)) in
  let t_9 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_10 := h ^ 2 * p ^ 2 * sn * cn in
  let t_11 := h ^ 2 * (2 * p) * sn ^ 2 in
  let t_12 := - (t_10 * t_6) - t_11 / (2 * dn) in
  let t_13 := 0 / (x1 * r) * cn + 0 / (x1 * r) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (tau * p /
    x2) + 0 / (x1 * r) * cn * (0 / x2)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (tau * p / x3) + 0 /
    (x1 * r) * cn * (0 / x3)) + (((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + t_1) * (p / r) + t_1 * cn
    * (0 / r)) in
  let t_14 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_4 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_15 := t_13 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (cn * dn * t_6) + 0 / (x1 * r) * cn * (dn
    * t_6 + cn * dn * t_14)) + ((0 / (x1 * r) * cn + 0 / (x1 * r) + 0 / (x1 * r)) * (- (sn * dn *
    t_6)) + t_9 * (- (sn * dn * t_14))) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * t_12 + 0 / (x1 * r)
    * cn * (- (h ^ 2 * p ^ 2 * sn * t_6 + t_10 * t_14) - 0 / (2 * dn))) in
  let t_16 := (t_8 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_6)) + t_9 * (- (dn * t_6
    + sn * dn * t_7))) + (0 / (x1 * r) * cn * t_12 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn *
    t_6 + t_10 * t_7) - h ^ 2 * (2 * p) * (2 * sn) / (2 * dn)))) * (cn * dn * (t_2 / (x1 * x2 *
    x3))) + t_15 * (- (sn * dn * (t_2 / (x1 * x2 * x3)))) in
  let t_17 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_4 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_18 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * p / x2) + 0 / (x1 * r) * cn * (0 /
    x2)) + (0 / (x1 * r) * cn * (tau * p / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) - 0
    / (x1 * r) ^ 2) * cn * (p / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn * (cn * dn * t_6) + 0
    / (x1 * r) * cn * (cn * t_6 + cn * dn * t_17)) in
  let t_19 := t_5 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * p / x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) +
    t_4 * (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_20 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * p / x2) + 0 / (x1 * r) * cn * (0 /
    x2)) + (0 / (x1 * r) * cn * (tau * p / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) - 0
    / (x1 * r) ^ 2) * cn * (p / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn * (cn * dn * t_6) + 0
    / (x1 * r) * cn * (cn * dn * t_19)) in
  let t_21 := t_16 + (t_18 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_6)) + t_9 * (-
    (sn * t_6 + sn * dn * t_17))) + (0 / (x1 * r) * cn * t_12 + 0 / (x1 * r) * cn * (- (t_10 * t_17)
    - (0 / (2 * dn) - t_11 * 2 / (2 * dn) ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * (t_2 / (x1 * x2 *
    x3)))) + (t_20 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_6)) + t_9 * (- (sn * dn *
    t_19))) + (0 / (x1 * r) * cn * t_12 + 0 / (x1 * r) * cn * (- (t_10 * t_19) - 0 / (2 * dn)))) in
  let t_22 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p /
    x2) + t_3 * (0 / x2)) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * p / x3) + t_4 *
    (0 / x3)) + (0 / (x1 * x2 * x3) * (p / r) + 0 / (x1 * x2 * x3) * (0 / r))) - h ^ 2 * (2 * p) in
  let t_23 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * p / x2) + 0 / (x1 * r) * cn * (0 /
    x2)) + (0 / (x1 * r) * cn * (tau * p / x3) + 0 / (x1 * r) * cn * (0 / x3)) + ((0 / (x1 * r) - 0
    / (x1 * r) ^ 2) * cn * (p / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn * (cn * dn * t_6) + 0
    / (x1 * r) * cn * (cn * dn * t_22)) in
  let t_24 := sigma * (Q / (x3 * r)) * dn in
  let t_25 := t_24 * (h * Q / x2 * sn) in
  let t_26 := (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_24 * (0 / x2
    * sn)) / x1 ^ 2 + ((- (2 * x2)) * t_25 + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h *
    Q / x2 * sn) + t_24 * ((0 / x2 - h * Q / x2 ^ 2) * sn))) / x1 ^ 2 * (tau * p / x2) + (2 * x3 *
    t_25 + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) * dn * (h * Q / x2 *
    sn) + t_24 * (0 / x2 * sn))) / x1 ^ 2 * (tau * p / x3) in
  let t_27 := t_26 + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) * dn * (h *
    Q / x2 * sn) + t_24 * (0 / x2 * sn)) / x1 ^ 2 * (p / r) + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3
    * r)) * dn * (h * Q / x2 * sn) + t_24 * (0 / x2 * sn + h * Q / x2)) / x1 ^ 2 * (cn * dn * t_6) +
    (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_24 * (0 / x2 * sn)) /
    x1 ^ 2 * (- (sn * dn * t_6)) in
  x1 <> 0 ->
  r <> 0 ->
  x2 <> 0 ->
  x3 <> 0 ->
  dn <> 0 ->
  t_21 + (t_23 + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (- (sn * dn * t_6)) + t_9 * (- (sn * dn *
    t_22))) + (0 / (x1 * r) * cn * t_12 + 0 / (x1 * r) * cn * (- (t_10 * t_22) - 0 / (2 * dn)))) *
    (t_2 / (x1 * x2 * x3) * sn ^ 2 / (2 * dn ^ 2)) = t_27 + (x3 ^ 2 - x2 ^ 2) * ((sigma * (0 / (x3 *
    r)) * dn + sigma * (Q / (x3 * r))) * (h * Q / x2 * sn) + t_24 * (0 / x2 * sn)) / x1 ^ 2 * t_12.
Proof.
  intros J Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5
    t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25
    t_26 t_27 D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by q, component 1 *)
Theorem sensitivity_of_the_spin_28 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) in
  let t_2 := sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) in
  let t_3 := (- sigma) * tau * q * Q in
  let t_4 := 0 / (x1 * x2 * x3) - t_3 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_5 := (- sigma) * tau * Q / (x1 * x2 * x3) + t_4 * (tau * q / x3) + 0 / (x1 * x2 * x3) * (q /
    r) in
  let t_6 := sigma * (0 / (x3 * r)) * dn in
  let t_7 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_4 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_8 := - (sn * dn * (t * t_5)) in
  let t_9 := sigma * (0 / (x3 * r)) * dn in
  let t_10 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau *
    q / x3) + t_1 * dn * (0 / x3)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (q / r) + t_2
    * dn * (0 / r)) + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_5)) + t_6 * (cn * dn * t_7))
    + (sigma * (0 / (x3 * r)) * dn * t_8 + t_9 * (- (dn * (t * t_5) + sn * dn * t_7))) in
  let t_11 := h ^ 2 * p ^ 2 * sn * cn in
  let t_12 := - (t_11 * (t * t_5)) - 0 / (2 * dn) in
  let t_13 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_14 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_4 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_15 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau *
    q / x3) + t_1 * dn * (0 / x3)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (q / r) + t_2
    * dn * (0 / r)) + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_5)) + t_6 * (dn * (t * t_5) +
    cn * dn * t_14)) in
  let t_16 := (t_10 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_12 + t_13 * (- (h
    ^ 2 * p ^ 2 * cn * (t * t_5) + t_11 * t_7) - 0 / (2 * dn)))) * (cn * dn * (t_3 / (x1 * x2 *
    x3))) + (t_15 + (sigma * (0 / (x3 * r)) * dn * t_8 + t_9 * (- (sn * dn * t_14))) + ((sigma * (0
    / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_12 + t_13 * (- (h ^ 2 * p ^ 2 * sn * (t * t_5) +
    t_11 * t_14) - 0 / (2 * dn)))) * (- (sn * dn * (t_3 / (x1 * x2 * x3)))) in
  let t_17 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_4 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_18 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r) - 0 /
    (x3 * r) ^ 2) * dn + t_1) * (tau * q / x3) + t_1 * dn * (0 / x3)) + ((sigma * (0 / (x3 * r) - 0
    / (x3 * r) ^ 2) * dn + t_2) * (q / r) + t_2 * dn * (0 / r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (cn * dn * (t * t_5)) + t_6 * (cn * (t * t_5) + cn * dn * t_17)) in
  let t_19 := (t_18 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_8 + t_9 * (- (sn *
    (t * t_5) + sn * dn * t_17))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + sigma *
    (0 / (x3 * r))) * t_12 + t_13 * (- (t_11 * t_17) - (0 / (2 * dn) - 0 / (2 * dn) ^ 2)))) * (- (h
    ^ 2 * p ^ 2 * sn * cn * (t_3 / (x1 * x2 * x3)))) in
  let t_20 := t_5 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * q / x3) + t_4 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_21 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau *
    q / x3) + t_1 * dn * (0 / x3)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (q / r) + t_2
    * dn * (0 / r)) + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_5)) + t_6 * (cn * dn * t_20))
    + (sigma * (0 / (x3 * r)) * dn * t_8 + t_9 * (- (sn * dn * t_20))) in
  let t_22 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_4 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_23 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (tau *
    q / x3) + t_1 * dn * (0 / x3)) + (sigma * (0 / (x3 * r) - 0 / (x3 * r) ^ 2) * dn * (q / r) + t_2
    * dn * (0 / r)) + (sigma * (0 / (x3 * r)) * dn * (cn * dn * (t * t_5)) + t_6 * (cn * dn * t_22))
    + (sigma * (0 / (x3 * r)) * dn * t_8 + t_9 * (- (sn * dn * t_22))) in
  let t_24 := h * q * Q / (x1 * r) in
  let t_25 := (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_24 * cn) + h * Q / x2 * sn * (h * Q / (x1 * r) *
    cn)) / x3 ^ 2 + ((x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_24 * cn) + h * Q / x2 * sn * (0 / (x1 *
    r) * cn)) / x3 ^ 2 - (x2 ^ 2 - x1 ^ 2) * (h * Q / x2 * sn * (t_24 * cn)) * (2 * x3) / (x3 ^ 2) ^
    2) * (tau * q / x3) in
  let t_26 := t_25 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_24 * cn) + h * Q / x2 * sn * ((0 / (x1 *
    r) - h * q * Q * x1 / (x1 * r) ^ 2) * cn)) / x3 ^ 2 * (q / r) + (x2 ^ 2 - x1 ^ 2) * ((0 / x2 *
    sn + h * Q / x2) * (t_24 * cn) + h * Q / x2 * sn * (0 / (x1 * r) * cn)) / x3 ^ 2 * (cn * dn * (t
    * t_5)) in
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  x2 <> 0 ->
  dn <> 0 ->
  t_16 + t_19 + (t_21 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_12 + t_13 * (-
    (t_11 * t_20) - 0 / (2 * dn)))) + (t_23 + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 *
    r))) * t_12 + t_13 * (- (t_11 * t_22) - 0 / (2 * dn)))) * (t_3 / (x1 * x2 * x3) * sn ^ 2 / (2 *
    dn ^ 2)) = t_26 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_24 * cn) + h * Q / x2 * sn * (0 / (x1 *
    r) * cn + t_24)) / x3 ^ 2 * t_8 + (x2 ^ 2 - x1 ^ 2) * (0 / x2 * sn * (t_24 * cn) + h * Q / x2 *
    sn * (0 / (x1 * r) * cn)) / x3 ^ 2 * t_12.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26
    D_1 D_2 D_3 D_4 D_5.
  rational.
Qed.

(* by q, component 2 *)
Theorem sensitivity_of_the_spin_29 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := (- sigma) * tau * q * Q in
  let t_2 := 0 / (x1 * x2 * x3) - t_1 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_3 := (- sigma) * tau * Q / (x1 * x2 * x3) + t_2 * (tau * q / x3) + 0 / (x1 * x2 * x3) * (q /
    r) in
  let t_4 := 0 / x2 * sn + h * Q / x2 in
  let t_5 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_6 := - (sn * dn * (t * t_3)) in
  let t_7 := 0 / x2 * sn + 0 / x2 + ((0 / x2 * sn + 0 / x2) * (tau * q / x3) + 0 / x2 * sn * (0 /
    x3)) + ((0 / x2 * sn + 0 / x2) * (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2 + 0 /
    x2) * (cn * dn * (t * t_3)) + t_4 * (cn * dn * t_5)) + ((0 / x2 * sn + 0 / x2) * t_6 + 0 / x2 *
    sn * (- (dn * (t * t_3) + sn * dn * t_5))) in
  let t_8 := h ^ 2 * p ^ 2 * sn * cn in
  let t_9 := - (t_8 * (t * t_3)) - 0 / (2 * dn) in
  let t_10 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_11 := 0 / x2 * sn + (0 / x2 * sn * (tau * q / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn *
    (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_3)) + t_4 * (dn *
    (t * t_3) + cn * dn * t_10)) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (sn * dn * t_10))) in
  let t_12 := (t_7 + ((0 / x2 * sn + 0 / x2) * t_9 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * cn * (t *
    t_3) + t_8 * t_5) - 0 / (2 * dn)))) * (cn * dn * (t_1 / (x1 * x2 * x3))) + (t_11 + (0 / x2 * sn
    * t_9 + 0 / x2 * sn * (- (h ^ 2 * p ^ 2 * sn * (t * t_3) + t_8 * t_10) - 0 / (2 * dn)))) * (-
    (sn * dn * (t_1 / (x1 * x2 * x3)))) in
  let t_13 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_14 := 0 / x2 * sn + (0 / x2 * sn * (tau * q / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn *
    (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_3)) + t_4 * (cn *
    (t * t_3) + cn * dn * t_13)) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (sn * (t * t_3) + sn * dn *
    t_13))) in
  let t_15 := t_3 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * q / x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_16 := 0 / x2 * sn + (0 / x2 * sn * (tau * q / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn *
    (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_3)) + t_4 * (cn *
    dn * t_15)) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (sn * dn * t_15))) + (0 / x2 * sn * t_9 + 0
    / x2 * sn * (- (t_8 * t_15) - 0 / (2 * dn))) in
  let t_17 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_2 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_18 := 0 / x2 * sn + (0 / x2 * sn * (tau * q / x3) + 0 / x2 * sn * (0 / x3)) + (0 / x2 * sn *
    (q / r) + 0 / x2 * sn * (0 / r)) + ((0 / x2 * sn + 0 / x2) * (cn * dn * (t * t_3)) + t_4 * (cn *
    dn * t_17)) + (0 / x2 * sn * t_6 + 0 / x2 * sn * (- (sn * dn * t_17))) + (0 / x2 * sn * t_9 + 0
    / x2 * sn * (- (t_8 * t_17) - 0 / (2 * dn))) in
  let t_19 := sigma * (Q / (x3 * r)) * dn in
  let t_20 := h * q * Q / (x1 * r) in
  let t_21 := (x1 ^ 2 - x3 ^ 2) * (h * Q / (x1 * r) * cn * t_19 + t_20 * cn * (sigma * (0 / (x3 *
    r)) * dn)) / x2 ^ 2 + ((- (2 * x3)) * (t_20 * cn * t_19) + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) *
    cn * t_19 + t_20 * cn * (sigma * (0 / (x3 * r) - Q * r / (x3 * r) ^ 2) * dn))) / x2 ^ 2 * (tau *
    q / x3) + (x1 ^ 2 - x3 ^ 2) * ((0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2) * cn * t_19 + t_20
    * cn * (sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) * dn)) / x2 ^ 2 * (q / r) in
  let t_22 := t_21 + (x1 ^ 2 - x3 ^ 2) * (0 / (x1 * r) * cn * t_19 + t_20 * cn * (sigma * (0 / (x3 *
    r)) * dn)) / x2 ^ 2 * (cn * dn * (t * t_3)) + (x1 ^ 2 - x3 ^ 2) * ((0 / (x1 * r) * cn + t_20) *
    t_19 + t_20 * cn * (sigma * (0 / (x3 * r)) * dn)) / x2 ^ 2 * t_6 + (x1 ^ 2 - x3 ^ 2) * (0 / (x1
    * r) * cn * t_19 + t_20 * cn * (sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)))) / x2 ^ 2
    * t_9 in
  x2 <> 0 ->
  x3 <> 0 ->
  r <> 0 ->
  x1 <> 0 ->
  dn <> 0 ->
  t_12 + (t_14 + (0 / x2 * sn * t_9 + 0 / x2 * sn * (- (t_8 * t_13) - (0 / (2 * dn) - 0 / (2 * dn) ^
    2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * (t_1 / (x1 * x2 * x3)))) + t_16 + t_18 * (t_1 / (x1 * x2 *
    x3) * sn ^ 2 / (2 * dn ^ 2)) = t_22.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 D_1 D_2 D_3 D_4
    D_5.
  rational.
Qed.

(* by q, component 3 *)
Theorem sensitivity_of_the_spin_30 :
  forall Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 ->
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 ->
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 ->
  r ^ 2 = p ^ 2 + q ^ 2 ->
  sigma ^ 2 = 1 ->
  tau ^ 2 = 1 ->
  let t_1 := 0 / (x1 * r) - h * q * Q * x1 / (x1 * r) ^ 2 in
  let t_2 := (- sigma) * tau * q * Q in
  let t_3 := 0 / (x1 * x2 * x3) - t_2 * (x1 * x2) / (x1 * x2 * x3) ^ 2 in
  let t_4 := (- sigma) * tau * Q / (x1 * x2 * x3) + t_3 * (tau * q / x3) + 0 / (x1 * x2 * x3) * (q /
    r) in
  let t_5 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_6 := - (sn * dn * (t * t_4)) in
  let t_7 := 0 / (x1 * r) * cn + h * q * Q / (x1 * r) in
  let t_8 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * q / x3) + 0 / (x1 * r) * cn * (0 / x3))
    + ((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn * (q / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) * cn *
    (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (cn * dn * t_5)) + ((0 / (x1 * r) * cn + 0 / (x1 *
    r)) * t_6 + t_7 * (- (dn * (t * t_4) + sn * dn * t_5))) in
  let t_9 := h ^ 2 * p ^ 2 * sn * cn in
  let t_10 := - (t_9 * (t * t_4)) - 0 / (2 * dn) in
  let t_11 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_12 := 0 / (x1 * r) * cn + h * Q / (x1 * r) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (tau * q
    / x3) + 0 / (x1 * r) * cn * (0 / x3)) + (((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn + t_1) * (q /
    r) + t_1 * cn * (0 / r)) + ((0 / (x1 * r) * cn + 0 / (x1 * r)) * (cn * dn * (t * t_4)) + 0 / (x1
    * r) * cn * (dn * (t * t_4) + cn * dn * t_11)) in
  let t_13 := (t_8 + (0 / (x1 * r) * cn * t_10 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * cn * (t *
    t_4) + t_9 * t_5) - 0 / (2 * dn)))) * (cn * dn * (t_2 / (x1 * x2 * x3))) + (t_12 + ((0 / (x1 *
    r) * cn + 0 / (x1 * r) + 0 / (x1 * r)) * t_6 + t_7 * (- (sn * dn * t_11))) + ((0 / (x1 * r) * cn
    + 0 / (x1 * r)) * t_10 + 0 / (x1 * r) * cn * (- (h ^ 2 * p ^ 2 * sn * (t * t_4) + t_9 * t_11) -
    0 / (2 * dn)))) * (- (sn * dn * (t_2 / (x1 * x2 * x3)))) in
  let t_14 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_15 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * q / x3) + 0 / (x1 * r) * cn * (0 /
    x3)) + ((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn * (q / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) *
    cn * (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (cn * (t * t_4) + cn * dn * t_14)) + ((0 / (x1
    * r) * cn + 0 / (x1 * r)) * t_6 + t_7 * (- (sn * (t * t_4) + sn * dn * t_14))) in
  let t_16 := t_4 + t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau
    * q / x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_17 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * q / x3) + 0 / (x1 * r) * cn * (0 /
    x3)) + ((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn * (q / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) *
    cn * (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (cn * dn * t_16)) + ((0 / (x1 * r) * cn + 0 /
    (x1 * r)) * t_6 + t_7 * (- (sn * dn * t_16))) in
  let t_18 := t * (0 / (x1 * x2 * x3) + ((0 / (x1 * x2 * x3) - 0 / (x1 * x2 * x3) ^ 2) * (tau * q /
    x3) + t_3 * (0 / x3)) + (0 / (x1 * x2 * x3) * (q / r) + 0 / (x1 * x2 * x3) * (0 / r))) in
  let t_19 := 0 / (x1 * r) * cn + (0 / (x1 * r) * cn * (tau * q / x3) + 0 / (x1 * r) * cn * (0 /
    x3)) + ((0 / (x1 * r) - 0 / (x1 * r) ^ 2) * cn * (q / r) + t_1 * cn * (0 / r)) + (0 / (x1 * r) *
    cn * (cn * dn * (t * t_4)) + 0 / (x1 * r) * cn * (cn * dn * t_18)) + ((0 / (x1 * r) * cn + 0 /
    (x1 * r)) * t_6 + t_7 * (- (sn * dn * t_18))) in
  let t_20 := t_13 + (t_15 + (0 / (x1 * r) * cn * t_10 + 0 / (x1 * r) * cn * (- (t_9 * t_14) - (0 /
    (2 * dn) - 0 / (2 * dn) ^ 2)))) * (- (h ^ 2 * p ^ 2 * sn * cn * (t_2 / (x1 * x2 * x3)))) + (t_17
    + (0 / (x1 * r) * cn * t_10 + 0 / (x1 * r) * cn * (- (t_9 * t_16) - 0 / (2 * dn)))) + (t_19 + (0
    / (x1 * r) * cn * t_10 + 0 / (x1 * r) * cn * (- (t_9 * t_18) - 0 / (2 * dn)))) * (t_2 / (x1 * x2
    * x3) * sn ^ 2 / (2 * dn ^ 2)) in
  let t_21 := sigma * (Q / (x3 * r)) * dn in
  let t_22 := (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_21 * (0 / x2
    * sn)) / x1 ^ 2 + (2 * x3 * (t_21 * (h * Q / x2 * sn)) + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 *
    r) - Q * r / (x3 * r) ^ 2) * dn * (h * Q / x2 * sn) + t_21 * (0 / x2 * sn))) / x1 ^ 2 * (tau * q
    / x3) + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r) - Q * x3 / (x3 * r) ^ 2) * dn * (h * Q / x2 *
    sn) + t_21 * (0 / x2 * sn)) / x1 ^ 2 * (q / r) in
  let t_23 := t_22 + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 / (x3 * r)) * dn * (h * Q / x2 * sn) + t_21 *
    (0 / x2 * sn + h * Q / x2)) / x1 ^ 2 * (cn * dn * (t * t_4)) + (x3 ^ 2 - x2 ^ 2) * (sigma * (0 /
    (x3 * r)) * dn * (h * Q / x2 * sn) + t_21 * (0 / x2 * sn)) / x1 ^ 2 * t_6 + (x3 ^ 2 - x2 ^ 2) *
    ((sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r))) * (h * Q / x2 * sn) + t_21 * (0 / x2 *
    sn)) / x1 ^ 2 * t_10 in
  x1 <> 0 ->
  r <> 0 ->
  x3 <> 0 ->
  x2 <> 0 ->
  dn <> 0 ->
  t_20 = t_23.
Proof.
  intros Q cn dn h p q r sigma sn t tau x1 x2 x3 H_1 H_2 H_3 H_4 H_5 H_6 H_7 t_1 t_2 t_3 t_4 t_5 t_6
    t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 D_1 D_2 D_3
    D_4 D_5.
  rational.
Qed.

(* With that derivative growing the other way. *)

(* by h, component 1 *)
Theorem sensitivity_of_the_spin_mutant_1 :
  exists J Q cn dn h p q r sigma sn t tau x1 x2 x3 : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  dn ^ 2 = - (h ^ 2 * p ^ 2 * sn ^ 2) + 1 /\
  x2 ^ 2 = p ^ 2 * tau + x1 ^ 2 /\
  x3 ^ 2 = p ^ 2 * tau + q ^ 2 * tau + x1 ^ 2 /\
  r ^ 2 = p ^ 2 + q ^ 2 /\
  sigma ^ 2 = 1 /\
  tau ^ 2 = 1 /\
  let t_1 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 * J in
  let t_2 := sigma * (0 / (x3 * r)) * dn in
  let t_3 := t * (0 / (x1 * x2 * x3)) in
  let t_4 := sigma * (0 / (x3 * r)) * dn in
  let t_5 := h ^ 2 * p ^ 2 * sn * cn in
  let t_6 := 2 * h * p ^ 2 * sn ^ 2 in
  let t_7 := - (t_5 * t_1) - t_6 / (2 * dn) in
  let t_8 := sigma * (0 / (x3 * r)) * dn + sigma * (Q / (x3 * r)) in
  let t_9 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (cn * dn * t_3)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (dn * t_1 + sn
    * dn * t_3))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2
    * p ^ 2 * cn * t_1 + t_5 * t_3) - 2 * h * p ^ 2 * (2 * sn) / (2 * dn))) in
  let t_10 := sigma * tau * q * Q / (x1 * x2 * x3) in
  let t_11 := t * (0 / (x1 * x2 * x3)) in
  let t_12 := sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (dn * t_1 + cn * dn * t_11)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn
    * dn * t_11))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (h ^ 2
    * p ^ 2 * sn * t_1 + t_5 * t_11) - 0 / (2 * dn))) in
  let t_13 := t * (0 / (x1 * x2 * x3)) in
  let t_14 := sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + ((sigma * (0 / (x3 * r)) * dn +
    sigma * (0 / (x3 * r))) * (cn * dn * t_1) + t_2 * (cn * t_1 + cn * dn * t_13)) + ((sigma * (0 /
    (x3 * r)) * dn + sigma * (0 / (x3 * r))) * (- (sn * dn * t_1)) + t_4 * (- (sn * t_1 + sn * dn *
    t_13))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r)) + sigma * (0 / (x3 * r))) * t_7
    + t_8 * (- (t_5 * t_13) - (0 / (2 * dn) - t_6 * 2 / (2 * dn) ^ 2))) in
  let t_15 := 0 / (x1 * x2 * x3) + t * (0 / (x1 * x2 * x3)) in
  let t_16 := t_9 * (cn * dn * t_10) + t_12 * (- (sn * dn * t_10)) + t_14 * (- (h ^ 2 * p ^ 2 * sn *
    cn * t_10)) + (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) +
    t_2 * (cn * dn * t_15)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn * dn
    * t_15))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_5 *
    t_15) - 0 / (2 * dn)))) in
  let t_17 := t * (0 / (x1 * x2 * x3)) - 2 * h * p ^ 2 in
  let t_18 := (sigma * (0 / (x3 * r)) * dn + (sigma * (0 / (x3 * r)) * dn * (cn * dn * t_1) + t_2 *
    (cn * dn * t_17)) + (sigma * (0 / (x3 * r)) * dn * (- (sn * dn * t_1)) + t_4 * (- (sn * dn *
    t_17))) + ((sigma * (0 / (x3 * r)) * dn + sigma * (0 / (x3 * r))) * t_7 + t_8 * (- (t_5 * t_17)
    - 0 / (2 * dn)))) * (- (t_10 * sn ^ 2 / (2 * dn ^ 2))) in
  let t_19 := h * q * Q / (x1 * r) in
  let t_20 := (x1 ^ 2 - x2 ^ 2) * (q * Q / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (Q / x2 *
    sn)) / x3 ^ 2 + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (0 / x2
    * sn + h * Q / x2)) / x3 ^ 2 * (cn * dn * t_1) + (x1 ^ 2 - x2 ^ 2) * ((0 / (x1 * r) * cn + t_19)
    * (h * Q / x2 * sn) + t_19 * cn * (0 / x2 * sn)) / x3 ^ 2 * (- (sn * dn * t_1)) in
  x3 <> 0 /\
  r <> 0 /\
  x1 <> 0 /\
  x2 <> 0 /\
  dn <> 0 /\
  t_16 + t_18 <> t_20 + (x1 ^ 2 - x2 ^ 2) * (0 / (x1 * r) * cn * (h * Q / x2 * sn) + t_19 * cn * (0
    / x2 * sn)) / x3 ^ 2 * t_7.
Proof.
  exists (2 / 9), (1 / 3), (sqrt (77 / 81)), (sqrt (58985 / 59049)), (2 / 3), (2 / 9), (-5 / 9),
    (sqrt (29 / 81)), (-1), (-2 / 9), (2 / 3), (-1), (2 / 3), (sqrt (32 / 81)), (sqrt (7 / 81)).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. enclosed.
Qed.


(** sensitivity-at-the-start: At the start those derivatives, put together for the three components of the spin and for a moment, are one for a component by itself and zero for all else. *)

(* row 1, column 1 *)
Theorem sensitivity_at_the_start_1 :
  forall AX cn sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  AX <> 0 ->
  cn * cn - AX * sn * (- (sn / AX)) = 1.
Proof.
  intros AX cn sn H_1  D_1.
  rational.
Qed.

(* row 2, column 1 *)
Theorem sensitivity_at_the_start_2 :
  forall AM AX cn sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  AM <> 0 ->
  AX <> 0 ->
  cn / (AX / AM) * sn + AM * cn * (- (sn / AX)) = 0.
Proof.
  intros AM AX cn sn H_1  D_1 D_2.
  rational.
Qed.

(* row 3, column 1 *)
Theorem sensitivity_at_the_start_3 :
  forall AC AX cn dn m sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  AX <> 0 ->
  AC <> 0 ->
  dn <> 0 ->
  AC * sn * (sn * (- (2 * (m * AC ^ 2 / AX ^ 2) * AX * cn / AC ^ 2)) / (2 * dn) - m * cn / dn * (-
    (sn / AX))) = 0.
Proof.
  intros AC AX cn dn m sn H_1 H_2  D_1 D_2 D_3.
  rational.
Qed.

(* row 1, column 2 *)
Theorem sensitivity_at_the_start_4 :
  forall AM AX cn sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  AM <> 0 ->
  AX / AM * sn * cn - AX * sn * (cn / AM) = 0.
Proof.
  intros AM AX cn sn H_1  D_1.
  rational.
Qed.

(* row 2, column 2 *)
Theorem sensitivity_at_the_start_5 :
  forall AM cn sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  AM <> 0 ->
  sn * sn + AM * cn * (cn / AM) = 1.
Proof.
  intros AM cn sn H_1  D_1.
  rational.
Qed.

(* row 3, column 2 *)
Theorem sensitivity_at_the_start_6 :
  forall AC AM cn dn m sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  AM <> 0 ->
  AC <> 0 ->
  dn <> 0 ->
  m * AC ^ 2 / AM ^ 2 * AM / AC * sn * dn + AC * sn * (sn * (- (2 * (1 - m) * (m * AC ^ 2 / AM ^ 2)
    * AM * sn / AC ^ 2)) / (2 * dn) - m * cn / dn * (cn / AM)) = 0.
Proof.
  intros AC AM cn dn m sn H_1 H_2  D_1 D_2 D_3.
  rational.
Qed.

(* row 3, column 3 *)
Theorem sensitivity_at_the_start_7 :
  forall AC dn m sn : R,
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  AC <> 0 ->
  dn <> 0 ->
  dn * dn + AC * sn * (sn * (2 * m * dn / AC) / (2 * dn)) = 1.
Proof.
  intros AC dn m sn H_1  D_1 D_2.
  rational.
Qed.

(* row 1, column 4 *)
Theorem sensitivity_at_the_start_8 :
  forall AX cn r sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  (1 / 2) * AX * sn ^ 2 * r * cn - AX * sn * ((1 / 2) * sn * cn * r) = 0.
Proof.
  intros AX cn r sn H_1  .
  rational.
Qed.

(* row 2, column 4 *)
Theorem sensitivity_at_the_start_9 :
  forall AM cn r sn : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  (- ((1 / 2) * AM * cn ^ 2 * r)) * sn + AM * cn * ((1 / 2) * sn * cn * r) = 0.
Proof.
  intros AM cn r sn H_1  .
  rational.
Qed.

(* row 3, column 4 *)
Theorem sensitivity_at_the_start_10 :
  forall AC cn dn m r sn t : R,
  cn ^ 2 = - sn ^ 2 + 1 ->
  dn ^ 2 = - (m * sn ^ 2) + 1 ->
  dn <> 0 ->
  (1 / 2) * AC * m * sn ^ 2 * (r + t) * dn + AC * sn * (sn * (- (m * (cn ^ 2 * t + (1 - m) * sn ^ 2
    * (r + t)))) / (2 * dn) - m * cn / dn * ((1 / 2) * sn * cn * r)) = 0.
Proof.
  intros AC cn dn m r sn t H_1 H_2  D_1.
  rational.
Qed.

(* With the phase shifted the other way. *)

(* row 1, column 1 *)
Theorem sensitivity_at_the_start_mutant_1 :
  exists AX cn sn : R,
  cn ^ 2 = - sn ^ 2 + 1 /\
  AX <> 0 /\
  cn * cn - AX * sn * (sn / AX) <> 1.
Proof.
  exists 6, (4 / 5), (3 / 5).
  split; [computed | ]. 
  split; [computed | ]. computed.
Qed.


(** sensitivity-of-the-attitude: A small turn e of the attitude changes as e' = w - omega x e with the change w of the spin; so e x M and the change of the momentum turn with the room, e . M has the rate w . M, and with the change of the energy this gives e. *)

(* q' *)
Theorem sensitivity_of_the_attitude_1 :
  forall W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3 : R,
  ((- (q1 * e1) - q2 * e2 - q3 * e3) / 2 * omega1 + (q0 * e2 - q1 * e3 + q3 * e1) / 2 * omega3 - (q0
    * e3 + q1 * e2 - q2 * e1) / 2 * omega2) / 2 + (q0 * W1 + q2 * W3 - q3 * W2) / 2 = ((- (q1 *
    omega1) - q2 * omega2 - q3 * omega3) / 2 * e1 + (q0 * omega2 - q1 * omega3 + q3 * omega1) / 2 *
    e3 - (q0 * omega3 + q1 * omega2 - q2 * omega1) / 2 * e2) / 2 + (q0 * (W1 - (omega2 * e3 - omega3
    * e2)) + q2 * (W3 - (omega1 * e2 - omega2 * e1)) - q3 * (W2 - (omega3 * e1 - omega1 * e3))) / 2.
Proof.
  intros W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3   .
  rational.
Qed.

(* q' *)
Theorem sensitivity_of_the_attitude_2 :
  forall W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3 : R,
  ((- (q1 * e1) - q2 * e2 - q3 * e3) / 2 * omega2 - (q0 * e1 + q2 * e3 - q3 * e2) / 2 * omega3 + (q0
    * e3 + q1 * e2 - q2 * e1) / 2 * omega1) / 2 + (q0 * W2 - q1 * W3 + q3 * W1) / 2 = ((- (q1 *
    omega1) - q2 * omega2 - q3 * omega3) / 2 * e2 - (q0 * omega1 + q2 * omega3 - q3 * omega2) / 2 *
    e3 + (q0 * omega3 + q1 * omega2 - q2 * omega1) / 2 * e1) / 2 + (q0 * (W2 - (omega3 * e1 - omega1
    * e3)) - q1 * (W3 - (omega1 * e2 - omega2 * e1)) + q3 * (W1 - (omega2 * e3 - omega3 * e2))) / 2.
Proof.
  intros W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3   .
  rational.
Qed.

(* q' *)
Theorem sensitivity_of_the_attitude_3 :
  forall W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3 : R,
  ((- (q1 * e1) - q2 * e2 - q3 * e3) / 2 * omega3 + (q0 * e1 + q2 * e3 - q3 * e2) / 2 * omega2 - (q0
    * e2 - q1 * e3 + q3 * e1) / 2 * omega1) / 2 + (q0 * W3 + q1 * W2 - q2 * W1) / 2 = ((- (q1 *
    omega1) - q2 * omega2 - q3 * omega3) / 2 * e3 + (q0 * omega1 + q2 * omega3 - q3 * omega2) / 2 *
    e2 - (q0 * omega2 - q1 * omega3 + q3 * omega1) / 2 * e1) / 2 + (q0 * (W3 - (omega1 * e2 - omega2
    * e1)) + q1 * (W2 - (omega3 * e1 - omega1 * e3)) - q2 * (W1 - (omega2 * e3 - omega3 * e2))) / 2.
Proof.
  intros W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3   .
  rational.
Qed.

(* q' *)
Theorem sensitivity_of_the_attitude_4 :
  forall W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3 : R,
  (- ((q0 * e1 + q2 * e3 - q3 * e2) / 2 * omega1) - (q0 * e2 - q1 * e3 + q3 * e1) / 2 * omega2 - (q0
    * e3 + q1 * e2 - q2 * e1) / 2 * omega3) / 2 + (- (q1 * W1) - q2 * W2 - q3 * W3) / 2 = (- ((q0 *
    omega1 + q2 * omega3 - q3 * omega2) / 2 * e1) - (q0 * omega2 - q1 * omega3 + q3 * omega1) / 2 *
    e2 - (q0 * omega3 + q1 * omega2 - q2 * omega1) / 2 * e3) / 2 + (- (q1 * (W1 - (omega2 * e3 -
    omega3 * e2))) - q2 * (W2 - (omega3 * e1 - omega1 * e3)) - q3 * (W3 - (omega1 * e2 - omega2 *
    e1))) / 2.
Proof.
  intros W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3   .
  rational.
Qed.

(* in the room, x *)
Theorem sensitivity_of_the_attitude_5 :
  forall I1 I2 I3 W2 W3 dxy dxz dyy dyz dzz e1 e2 e3 omega1 omega2 omega3 : R,
  let t_1 := I2 * W2 + (dyz * omega3 + (dyy * omega2 + dxy * omega1)) in
  let t_2 := I3 * W3 + (dzz * omega3 + (dyz * omega2 + dxz * omega1)) in
  (W2 - (omega3 * e1 - omega1 * e3)) * (I3 * omega3) - (W3 - (omega1 * e2 - omega2 * e1)) * (I2 *
    omega2) + (e2 * (I1 * omega1 * omega2 - I2 * omega2 * omega1) - e3 * (I3 * omega3 * omega1 - I1
    * omega1 * omega3)) + (t_1 * omega3 - t_2 * omega2 + (I2 * omega2 * W3 - I3 * omega3 * W2)) = -
    (omega2 * (e1 * (I2 * omega2) - e2 * (I1 * omega1) + t_2) - omega3 * (e3 * (I1 * omega1) - e1 *
    (I3 * omega3) + t_1)).
Proof.
  intros I1 I2 I3 W2 W3 dxy dxz dyy dyz dzz e1 e2 e3 omega1 omega2 omega3  t_1 t_2 .
  rational.
Qed.

(* in the room, y *)
Theorem sensitivity_of_the_attitude_6 :
  forall I1 I2 I3 W1 W3 dxx dxy dxz dyz dzz e1 e2 e3 omega1 omega2 omega3 : R,
  let t_1 := I3 * W3 + (dzz * omega3 + (dyz * omega2 + dxz * omega1)) in
  let t_2 := I1 * W1 + (dxz * omega3 + (dxy * omega2 + dxx * omega1)) in
  (W3 - (omega1 * e2 - omega2 * e1)) * (I1 * omega1) - (W1 - (omega2 * e3 - omega3 * e2)) * (I3 *
    omega3) + (e3 * (I2 * omega2 * omega3 - I3 * omega3 * omega2) - e1 * (I1 * omega1 * omega2 - I2
    * omega2 * omega1)) + (t_1 * omega1 - t_2 * omega3 + (I3 * omega3 * W1 - I1 * omega1 * W3)) = -
    (omega3 * (e2 * (I3 * omega3) - e3 * (I2 * omega2) + t_2) - omega1 * (e1 * (I2 * omega2) - e2 *
    (I1 * omega1) + t_1)).
Proof.
  intros I1 I2 I3 W1 W3 dxx dxy dxz dyz dzz e1 e2 e3 omega1 omega2 omega3  t_1 t_2 .
  rational.
Qed.

(* in the room, z *)
Theorem sensitivity_of_the_attitude_7 :
  forall I1 I2 I3 W1 W2 dxx dxy dxz dyy dyz e1 e2 e3 omega1 omega2 omega3 : R,
  let t_1 := I1 * W1 + (dxz * omega3 + (dxy * omega2 + dxx * omega1)) in
  let t_2 := I2 * W2 + (dyz * omega3 + (dyy * omega2 + dxy * omega1)) in
  (W1 - (omega2 * e3 - omega3 * e2)) * (I2 * omega2) - (W2 - (omega3 * e1 - omega1 * e3)) * (I1 *
    omega1) + (e1 * (I3 * omega3 * omega1 - I1 * omega1 * omega3) - e2 * (I2 * omega2 * omega3 - I3
    * omega3 * omega2)) + (t_1 * omega2 - t_2 * omega1 + (I1 * omega1 * W2 - I2 * omega2 * W1)) = -
    (omega1 * (e3 * (I1 * omega1) - e1 * (I3 * omega3) + t_2) - omega2 * (e2 * (I3 * omega3) - e3 *
    (I2 * omega2) + t_1)).
Proof.
  intros I1 I2 I3 W1 W2 dxx dxy dxz dyy dyz e1 e2 e3 omega1 omega2 omega3  t_1 t_2 .
  rational.
Qed.

(* e . M *)
Theorem sensitivity_of_the_attitude_8 :
  forall I1 I2 I3 W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 : R,
  (W1 - (omega2 * e3 - omega3 * e2)) * (I1 * omega1) + (W2 - (omega3 * e1 - omega1 * e3)) * (I2 *
    omega2) + (W3 - (omega1 * e2 - omega2 * e1)) * (I3 * omega3) + (e1 * (I2 * omega2 * omega3 - I3
    * omega3 * omega2) + e2 * (I3 * omega3 * omega1 - I1 * omega1 * omega3) + e3 * (I1 * omega1 *
    omega2 - I2 * omega2 * omega1)) = W1 * (I1 * omega1) + W2 * (I2 * omega2) + W3 * (I3 * omega3).
Proof.
  intros I1 I2 I3 W1 W2 W3 e1 e2 e3 omega1 omega2 omega3   .
  rational.
Qed.

(* the energy *)
Theorem sensitivity_of_the_attitude_9 :
  forall I1 I2 I3 W1 W2 W3 dxx dxy dxz dyy dyz dzz omega1 omega2 omega3 : R,
  let t_1 := (I1 - I2) * (omega1 * omega2) / I3 in
  let t_2 := (I3 - I1) * (omega3 * omega1) / I2 in
  let t_3 := (I2 - I3) * (omega2 * omega3) / I1 in
  let t_4 := (0 / I1 * W1 + (I2 - I3) * omega3 / I1 * W2 + (I2 - I3) * omega2 / I1 * W3 + ((dyz *
    omega3 + (dyy * omega2 + dxy * omega1)) * omega3 - (dzz * omega3 + (dyz * omega2 + dxz *
    omega1)) * omega2 - (dxz * t_1 + (dxy * t_2 + dxx * t_3))) / I1) * (I1 * omega1) + ((I3 - I1) *
    omega3 / I2 * W1 + 0 / I2 * W2 + (I3 - I1) * omega1 / I2 * W3 + ((dzz * omega3 + (dyz * omega2 +
    dxz * omega1)) * omega1 - (dxz * omega3 + (dxy * omega2 + dxx * omega1)) * omega3 - (dyz * t_1 +
    (dyy * t_2 + dxy * t_3))) / I2) * (I2 * omega2) in
  let t_5 := (t_4 + ((I1 - I2) * omega2 / I3 * W1 + (I1 - I2) * omega1 / I3 * W2 + 0 / I3 * W3 +
    ((dxz * omega3 + (dxy * omega2 + dxx * omega1)) * omega2 - (dyz * omega3 + (dyy * omega2 + dxy *
    omega1)) * omega1 - (dzz * t_1 + (dyz * t_2 + dxz * t_3))) / I3) * (I3 * omega3)) * 2 + (W1 *
    (I2 * omega2 * omega3 - I3 * omega3 * omega2) + W2 * (I3 * omega3 * omega1 - I1 * omega1 *
    omega3) + W3 * (I1 * omega1 * omega2 - I2 * omega2 * omega1)) * 2 in
  let t_6 := (I1 - I2) * (omega1 * omega2) / I3 in
  let t_7 := (I3 - I1) * (omega3 * omega1) / I2 in
  let t_8 := (I2 - I3) * (omega2 * omega3) / I1 in
  I1 <> 0 ->
  I3 <> 0 ->
  I2 <> 0 ->
  t_5 + (omega1 * (dxz * t_6 + (dxy * t_7 + dxx * t_8)) + omega2 * (dyz * t_6 + (dyy * t_7 + dxy *
    t_8)) + omega3 * (dzz * t_6 + (dyz * t_7 + dxz * t_8))) * 2 = 0.
Proof.
  intros I1 I2 I3 W1 W2 W3 dxx dxy dxz dyy dyz dzz omega1 omega2 omega3  t_1 t_2 t_3 t_4 t_5 t_6 t_7
    t_8 D_1 D_2 D_3.
  rational.
Qed.

(* e, x *)
Theorem sensitivity_of_the_attitude_10 :
  forall I1 I2 I3 e1 e2 e3 omega1 omega2 omega3 : R,
  I2 * omega2 * (e1 * (I2 * omega2) - e2 * (I1 * omega1)) - I3 * omega3 * (e3 * (I1 * omega1) - e1 *
    (I3 * omega3)) + I1 * omega1 * (e1 * (I1 * omega1) + e2 * (I2 * omega2) + e3 * (I3 * omega3)) =
    e1 * (I1 * omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3)).
Proof.
  intros I1 I2 I3 e1 e2 e3 omega1 omega2 omega3   .
  rational.
Qed.

(* e, y *)
Theorem sensitivity_of_the_attitude_11 :
  forall I1 I2 I3 e1 e2 e3 omega1 omega2 omega3 : R,
  I3 * omega3 * (e2 * (I3 * omega3) - e3 * (I2 * omega2)) - I1 * omega1 * (e1 * (I2 * omega2) - e2 *
    (I1 * omega1)) + I2 * omega2 * (e1 * (I1 * omega1) + e2 * (I2 * omega2) + e3 * (I3 * omega3)) =
    e2 * (I1 * omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3)).
Proof.
  intros I1 I2 I3 e1 e2 e3 omega1 omega2 omega3   .
  rational.
Qed.

(* e, z *)
Theorem sensitivity_of_the_attitude_12 :
  forall I1 I2 I3 e1 e2 e3 omega1 omega2 omega3 : R,
  I1 * omega1 * (e3 * (I1 * omega1) - e1 * (I3 * omega3)) - I2 * omega2 * (e2 * (I3 * omega3) - e3 *
    (I2 * omega2)) + I3 * omega3 * (e1 * (I1 * omega1) + e2 * (I2 * omega2) + e3 * (I3 * omega3)) =
    e3 * (I1 * omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3)).
Proof.
  intros I1 I2 I3 e1 e2 e3 omega1 omega2 omega3   .
  rational.
Qed.

(* With e carried along the other way. *)

(* q' *)
Theorem sensitivity_of_the_attitude_mutant_1 :
  exists W1 W2 W3 e1 e2 e3 omega1 omega2 omega3 q0 q1 q2 q3 : R,
  ((- (q1 * e1) - q2 * e2 - q3 * e3) / 2 * omega1 + (q0 * e2 - q1 * e3 + q3 * e1) / 2 * omega3 - (q0
    * e3 + q1 * e2 - q2 * e1) / 2 * omega2) / 2 + (q0 * W1 + q2 * W3 - q3 * W2) / 2 <> ((- (q1 *
    omega1) - q2 * omega2 - q3 * omega3) / 2 * e1 + (q0 * omega2 - q1 * omega3 + q3 * omega1) / 2 *
    e3 - (q0 * omega3 + q1 * omega2 - q2 * omega1) / 2 * e2) / 2 + (q0 * (W1 + (omega2 * e3 - omega3
    * e2)) + q2 * (W3 + (omega1 * e2 - omega2 * e1)) - q3 * (W2 + (omega3 * e1 - omega1 * e3))) / 2.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6, (-2).
  computed.
Qed.


(** sensitivity-by-products: A product of inertia turns two principal axes about the third by itself over the difference of their moments: the spin turned so obeys Euler's equations with the changed tensor to first order. *)

(* w', x *)
Theorem sensitivity_by_products_1 :
  forall I1 I2 I3 omega2 omega3 : R,
  I1 <> 0 ->
  I2 - I3 <> 0 ->
  0 = (I2 - I3) * omega3 / I1 * (- (1 / (I2 - I3) * omega3)) + (I2 - I3) * omega2 / I1 * (1 / (I2 -
    I3) * omega2) + (omega3 * omega3 - omega2 * omega2) / I1.
Proof.
  intros I1 I2 I3 omega2 omega3   D_1 D_2.
  rational.
Qed.

(* w', y *)
Theorem sensitivity_by_products_2 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I2 - I3 <> 0 ->
  I3 <> 0 ->
  I2 <> 0 ->
  - (1 / (I2 - I3) * ((I1 - I2) * (omega1 * omega2) / I3)) = 0 / I2 * (- (1 / (I2 - I3) * omega3)) +
    (I3 - I1) * omega1 / I2 * (1 / (I2 - I3) * omega2) + (omega2 * omega1 - (I1 - I2) * (omega1 *
    omega2) / I3) / I2.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   D_1 D_2 D_3.
  rational.
Qed.

(* w', z *)
Theorem sensitivity_by_products_3 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I2 - I3 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  1 / (I2 - I3) * ((I3 - I1) * (omega3 * omega1) / I2) = (I1 - I2) * omega1 / I3 * (- (1 / (I2 - I3)
    * omega3)) + 0 / I3 * (1 / (I2 - I3) * omega2) + (- (omega3 * omega1) - (I3 - I1) * (omega3 *
    omega1) / I2) / I3.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   D_1 D_2 D_3.
  rational.
Qed.

(* w', x *)
Theorem sensitivity_by_products_4 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I3 - I1 <> 0 ->
  I3 <> 0 ->
  I1 <> 0 ->
  1 / (I3 - I1) * ((I1 - I2) * (omega1 * omega2) / I3) = 0 / I1 * (1 / (I3 - I1) * omega3) + (I2 -
    I3) * omega2 / I1 * (- (1 / (I3 - I1) * omega1)) + (- (omega1 * omega2) - (I1 - I2) * (omega1 *
    omega2) / I3) / I1.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   D_1 D_2 D_3.
  rational.
Qed.

(* w', y *)
Theorem sensitivity_by_products_5 :
  forall I1 I2 I3 omega1 omega3 : R,
  I2 <> 0 ->
  I3 - I1 <> 0 ->
  0 = (I3 - I1) * omega3 / I2 * (1 / (I3 - I1) * omega3) + (I3 - I1) * omega1 / I2 * (- (1 / (I3 -
    I1) * omega1)) + (omega1 * omega1 - omega3 * omega3) / I2.
Proof.
  intros I1 I2 I3 omega1 omega3   D_1 D_2.
  rational.
Qed.

(* w', z *)
Theorem sensitivity_by_products_6 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I3 - I1 <> 0 ->
  I1 <> 0 ->
  I3 <> 0 ->
  - (1 / (I3 - I1) * ((I2 - I3) * (omega2 * omega3) / I1)) = (I1 - I2) * omega2 / I3 * (1 / (I3 -
    I1) * omega3) + 0 / I3 * (- (1 / (I3 - I1) * omega1)) + (omega3 * omega2 - (I2 - I3) * (omega2 *
    omega3) / I1) / I3.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   D_1 D_2 D_3.
  rational.
Qed.

(* w', x *)
Theorem sensitivity_by_products_7 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I1 - I2 <> 0 ->
  I2 <> 0 ->
  I1 <> 0 ->
  - (1 / (I1 - I2) * ((I3 - I1) * (omega3 * omega1) / I2)) = 0 / I1 * (- (1 / (I1 - I2) * omega2)) +
    (I2 - I3) * omega3 / I1 * (1 / (I1 - I2) * omega1) + (omega1 * omega3 - (I3 - I1) * (omega3 *
    omega1) / I2) / I1.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   D_1 D_2 D_3.
  rational.
Qed.

(* w', y *)
Theorem sensitivity_by_products_8 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I1 - I2 <> 0 ->
  I1 <> 0 ->
  I2 <> 0 ->
  1 / (I1 - I2) * ((I2 - I3) * (omega2 * omega3) / I1) = (I3 - I1) * omega3 / I2 * (- (1 / (I1 - I2)
    * omega2)) + 0 / I2 * (1 / (I1 - I2) * omega1) + (- (omega2 * omega3) - (I2 - I3) * (omega2 *
    omega3) / I1) / I2.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   D_1 D_2 D_3.
  rational.
Qed.

(* w', z *)
Theorem sensitivity_by_products_9 :
  forall I1 I2 I3 omega1 omega2 : R,
  I3 <> 0 ->
  I1 - I2 <> 0 ->
  0 = (I1 - I2) * omega2 / I3 * (- (1 / (I1 - I2) * omega2)) + (I1 - I2) * omega1 / I3 * (1 / (I1 -
    I2) * omega1) + (omega2 * omega2 - omega1 * omega1) / I3.
Proof.
  intros I1 I2 I3 omega1 omega2   D_1 D_2.
  rational.
Qed.

(* With turned the other way. *)

(* w', x *)
Theorem sensitivity_by_products_mutant_1 :
  exists I1 I2 I3 omega2 omega3 : R,
  I1 <> 0 /\
  I2 - I3 <> 0 /\
  0 <> (I2 - I3) * omega3 / I1 * (- ((-1) / (I2 - I3) * omega3)) + (I2 - I3) * omega2 / I1 * ((-1) /
    (I2 - I3) * omega2) + (omega3 * omega3 - omega2 * omega2) / I1.
Proof.
  exists 6, 1, (-3), 1, 7.
  split; [computed | ]. split; [computed | ]. computed.
Qed.
