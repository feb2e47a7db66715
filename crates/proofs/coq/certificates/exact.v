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
