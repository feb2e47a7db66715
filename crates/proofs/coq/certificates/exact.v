(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics.


(** symmetric-top: With I1 = I2 the spin circles the third axis at the rate (I3 - I1) w3 / I1: w1 = A cos, w2 = A sin, w3 constant. *)

(* w', x *)
Theorem symmetric_top_1 :
  forall A I1 I3 omega3 sin : R,
  I1 <> 0 ->
  A * (- ((I3 - I1) * omega3 / I1 * sin)) = (I1 - I3) * (A * sin * omega3) / I1.
Proof.
  intros A I1 I3 omega3 sin   D_1.
  field; nonzero.
Qed.

(* w', y *)
Theorem symmetric_top_2 :
  forall A I1 I3 cos omega3 sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  I1 <> 0 ->
  A * ((I3 - I1) * omega3 / I1 * cos) = (I3 - I1) * (omega3 * (A * cos)) / I1.
Proof.
  intros A I1 I3 cos omega3 sin H_1  D_1.
  field [H_1]; nonzero.
Qed.

(* w', z *)
Theorem symmetric_top_3 :
  forall A I1 I3 cos sin : R,
  cos ^ 2 = - sin ^ 2 + 1 ->
  I3 <> 0 ->
  0 = (I1 - I1) * (A * cos * (A * sin)) / I3.
Proof.
  intros A I1 I3 cos sin H_1  D_1.
  field [H_1]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4]; nonzero.
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
  field [H_1 H_2 H_3 H_4]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6]; nonzero.
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
  field; nonzero.
Qed.

(* 2 E I3 - L² *)
Theorem which_side_2 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  (omega1 * (I1 * omega1) + omega2 * (I2 * omega2) + omega3 * (I3 * omega3)) / 2 * 2 * I3 - (I1 *
    omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3)) = I1 * (I3 -
    I1) * omega1 ^ 2 + I2 * (I3 - I2) * omega2 ^ 2.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   .
  field; nonzero.
Qed.

(* L² - 2 E I1 *)
Theorem which_side_3 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I1 * omega1 * (I1 * omega1) + I2 * omega2 * (I2 * omega2) + I3 * omega3 * (I3 * omega3) - (omega1
    * (I1 * omega1) + omega2 * (I2 * omega2) + omega3 * (I3 * omega3)) / 2 * 2 * I1 = I2 * (I2 - I1)
    * omega2 ^ 2 + I3 * (I3 - I1) * omega3 ^ 2.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   .
  field; nonzero.
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
  field; nonzero.
Qed.

(* (n + 1/2)² *)
Theorem jacobi_by_thetas_2 :
  forall n : R,
  (n + (1 / 2)) ^ 2 = n ^ 2 + n + (1 / 4).
Proof.
  intros n   .
  field; nonzero.
Qed.

(* (n + 1)² *)
Theorem jacobi_by_thetas_3 :
  forall n : R,
  (n + 1) ^ 2 = n ^ 2 + 2 * n + 1.
Proof.
  intros n   .
  ring.
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
  field; nonzero.
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
  field; nonzero.
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
  field; nonzero.
Qed.

(* (n + 1/2)² *)
Theorem attitude_by_thetas_2 :
  forall n : R,
  (n + (1 / 2)) ^ 2 = n ^ 2 + n + (1 / 4).
Proof.
  intros n   .
  field; nonzero.
Qed.

(* (n + 1)² *)
Theorem attitude_by_thetas_3 :
  forall n : R,
  (n + 1) ^ 2 = n ^ 2 + 2 * n + 1.
Proof.
  intros n   .
  ring.
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
  field; nonzero.
Qed.

(* (n + 1/2)² *)
Theorem attitude_by_complementary_thetas_2 :
  forall n : R,
  (n + (1 / 2)) ^ 2 = n ^ 2 + n + (1 / 4).
Proof.
  intros n   .
  field; nonzero.
Qed.

(* (n + 1)² *)
Theorem attitude_by_complementary_thetas_3 :
  forall n : R,
  (n + 1) ^ 2 = n ^ 2 + 2 * n + 1.
Proof.
  intros n   .
  ring.
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
  field; nonzero.
Qed.

(* (n + 1/2)² *)
Theorem half_periods_2 :
  forall n : R,
  (n + (1 / 2)) ^ 2 = n ^ 2 + n + (1 / 4).
Proof.
  intros n   .
  field; nonzero.
Qed.

(* (n + 1)² *)
Theorem half_periods_3 :
  forall n : R,
  (n + 1) ^ 2 = n ^ 2 + 2 * n + 1.
Proof.
  intros n   .
  ring.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5 H_6 H_7 H_8]; nonzero.
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
  field [H_1 H_2 H_3]; nonzero.
Qed.

(* the amplitudes *)
Theorem limit_coin_2 :
  forall Q h q x1 : R,
  x1 <> 0 ->
  q <> 0 ->
  h * q * Q / (x1 * q) = h * Q / x1.
Proof.
  intros Q h q x1   D_1 D_2.
  field; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4]; nonzero.
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
  field [H_1 H_2 H_3 H_4 H_5]; nonzero.
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
  field [H_1 H_2 H_3]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5]; nonzero.
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
  field [H_1 H_2 H_3]; nonzero.
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
  unnamed.
  field [H_1 H_2 H_3 H_4 H_5]; nonzero.
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
