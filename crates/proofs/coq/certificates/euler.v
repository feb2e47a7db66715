(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.


(** euler-from-constant-momentum: Differentiate R I w, with R' as the attitude's own rate: it equals the world's torque exactly if I w' = (I w) x w + torque. For every tensor, attitude, spin and torque. *)

(* the rate of R I w, x *)
Theorem euler_from_constant_momentum_1 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz alpha1 alpha2 alpha3 omega1 omega2 omega3 tau1 tau2 tau3 w x
    y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_2 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_3 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_4 := ((y + y) * t_1 + ((- z - z) * t_2 + (w + w) * t_3)) * ((- (x * omega1) - y * omega2 - z
    * omega3) / 2) + ((z + z) * t_1 + ((y + y) * t_2 + (x + x) * t_3)) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + ((w + w) * t_1 + ((x + x) * t_2 + (- (y + y)) * t_3)) * ((w * omega2 - x *
    omega3 + z * omega1) / 2) + ((x + x) * t_1 + ((- w - w) * t_2 + (- (z + z)) * t_3)) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) in
  let t_5 := x * z + w * y + (x * z + w * y) in
  let t_6 := x * y - w * z + (x * y - w * z) in
  let t_7 := w * w + x * x - y * y - z * z in
  let t_8 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_9 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_10 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  t_4 + (t_5 * I_xz + (t_6 * I_xy + t_7 * I_xx)) * alpha1 + (t_5 * I_yz + (t_6 * I_yy + t_7 * I_xy))
    * alpha2 + (t_5 * I_zz + (t_6 * I_yz + t_7 * I_xz)) * alpha3 - (t_5 * tau3 + (t_6 * tau2 + t_7 *
    tau1)) = t_5 * (I_zz * alpha3 + (I_yz * alpha2 + I_xz * alpha1) - (t_8 * omega2 - t_9 * omega1 +
    tau3)) + (t_6 * (I_yz * alpha3 + (I_yy * alpha2 + I_xy * alpha1) - (t_10 * omega1 - t_8 * omega3
    + tau2)) + t_7 * (I_xz * alpha3 + (I_xy * alpha2 + I_xx * alpha1) - (t_9 * omega3 - t_10 *
    omega2 + tau1))).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz alpha1 alpha2 alpha3 omega1 omega2 omega3 tau1 tau2 tau3 w x
    y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 .
  rational.
Qed.

(* the rate of R I w, z *)
Theorem euler_from_constant_momentum_2 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz alpha1 alpha2 alpha3 omega1 omega2 omega3 tau1 tau2 tau3 w x
    y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_2 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_3 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_4 := ((w + w) * t_1 + ((x + x) * t_2 + (- y - y) * t_3)) * ((- (x * omega1) - y * omega2 - z
    * omega3) / 2) + ((- (x + x)) * t_1 + ((w + w) * t_2 + (z + z) * t_3)) * ((w * omega1 + y *
    omega3 - z * omega2) / 2) + ((- (y + y)) * t_1 + ((z + z) * t_2 + (- w - w) * t_3)) * ((w *
    omega2 - x * omega3 + z * omega1) / 2) in
  let t_5 := w * w - x * x - y * y + z * z in
  let t_6 := y * z + w * x + (y * z + w * x) in
  let t_7 := x * z - w * y + (x * z - w * y) in
  let t_8 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_9 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_10 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  t_4 + ((z + z) * t_1 + ((y + y) * t_2 + (x + x) * t_3)) * ((w * omega3 + x * omega2 - y * omega1)
    / 2) + (t_5 * I_xz + (t_6 * I_xy + t_7 * I_xx)) * alpha1 + (t_5 * I_yz + (t_6 * I_yy + t_7 *
    I_xy)) * alpha2 + (t_5 * I_zz + (t_6 * I_yz + t_7 * I_xz)) * alpha3 - (t_5 * tau3 + (t_6 * tau2
    + t_7 * tau1)) = t_5 * (I_zz * alpha3 + (I_yz * alpha2 + I_xz * alpha1) - (t_8 * omega2 - t_9 *
    omega1 + tau3)) + (t_6 * (I_yz * alpha3 + (I_yy * alpha2 + I_xy * alpha1) - (t_10 * omega1 - t_8
    * omega3 + tau2)) + t_7 * (I_xz * alpha3 + (I_xy * alpha2 + I_xx * alpha1) - (t_9 * omega3 -
    t_10 * omega2 + tau1))).
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz alpha1 alpha2 alpha3 omega1 omega2 omega3 tau1 tau2 tau3 w x
    y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 .
  rational.
Qed.

(* With w x (I w) for (I w) x w. *)

(* the rate of R I w, x *)
Theorem euler_from_constant_momentum_mutant_1 :
  exists I_xx I_xy I_xz I_yy I_yz I_zz alpha1 alpha2 alpha3 omega1 omega2 omega3 tau1 tau2 tau3 w x
    y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  let t_1 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_2 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_3 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_4 := ((y + y) * t_1 + ((- z - z) * t_2 + (w + w) * t_3)) * ((- (x * omega1) - y * omega2 - z
    * omega3) / 2) + ((z + z) * t_1 + ((y + y) * t_2 + (x + x) * t_3)) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + ((w + w) * t_1 + ((x + x) * t_2 + (- (y + y)) * t_3)) * ((w * omega2 - x *
    omega3 + z * omega1) / 2) + ((x + x) * t_1 + ((- w - w) * t_2 + (- (z + z)) * t_3)) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) in
  let t_5 := x * z + w * y + (x * z + w * y) in
  let t_6 := x * y - w * z + (x * y - w * z) in
  let t_7 := w * w + x * x - y * y - z * z in
  let t_8 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_9 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_10 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  t_4 + (t_5 * I_xz + (t_6 * I_xy + t_7 * I_xx)) * alpha1 + (t_5 * I_yz + (t_6 * I_yy + t_7 * I_xy))
    * alpha2 + (t_5 * I_zz + (t_6 * I_yz + t_7 * I_xz)) * alpha3 - (t_5 * tau3 + (t_6 * tau2 + t_7 *
    tau1)) <> t_5 * (I_zz * alpha3 + (I_yz * alpha2 + I_xz * alpha1) + (t_8 * omega2 - t_9 * omega1
    - tau3)) + (t_6 * (I_yz * alpha3 + (I_yy * alpha2 + I_xy * alpha1) + (t_10 * omega1 - t_8 *
    omega3 - tau2)) + t_7 * (I_xz * alpha3 + (I_xy * alpha2 + I_xx * alpha1) + (t_9 * omega3 - t_10
    * omega2 - tau1))).
Proof.
  exists (3 / 5), (-3 / 5), (6 / 5), (4 / 5), 1, 1, (2 / 5), 1, (2 / 5), (4 / 5), (-4 / 5), (3 / 5),
    (-7 / 5), (1 / 5), (-1 / 5), (4 / 5), (2 / 5), (-1 / 5), (2 / 5).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (19 / 25) computed.
  intros t_2; cut_to t_2 (-13 / 25) computed.
  intros t_3; cut_to t_3 (42 / 25) computed.
  intros t_4; cut_to t_4 (-311 / 625) computed.
  intros t_5; cut_to t_5 0 computed.
  intros t_6; cut_to t_6 (-4 / 5) computed.
  intros t_7; cut_to t_7 (3 / 5) computed.
  intros t_8; cut_to t_8 (42 / 25) computed.
  intros t_9; cut_to t_9 (-13 / 25) computed.
  intros t_10; cut_to t_10 (19 / 25) computed.
  computed.
Qed.

(* With the gyroscopic term left out. *)

(* the rate of R I w, x *)
Theorem euler_from_constant_momentum_mutant_2 :
  exists I_xx I_xy I_xz I_yy I_yz I_zz alpha1 alpha2 alpha3 omega1 omega2 omega3 tau1 tau2 tau3 w x
    y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  let t_1 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_2 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_3 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_4 := ((y + y) * t_1 + ((- z - z) * t_2 + (w + w) * t_3)) * ((- (x * omega1) - y * omega2 - z
    * omega3) / 2) + ((z + z) * t_1 + ((y + y) * t_2 + (x + x) * t_3)) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + ((w + w) * t_1 + ((x + x) * t_2 + (- (y + y)) * t_3)) * ((w * omega2 - x *
    omega3 + z * omega1) / 2) + ((x + x) * t_1 + ((- w - w) * t_2 + (- (z + z)) * t_3)) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) in
  let t_5 := x * z + w * y + (x * z + w * y) in
  let t_6 := x * y - w * z + (x * y - w * z) in
  let t_7 := w * w + x * x - y * y - z * z in
  t_4 + (t_5 * I_xz + (t_6 * I_xy + t_7 * I_xx)) * alpha1 + (t_5 * I_yz + (t_6 * I_yy + t_7 * I_xy))
    * alpha2 + (t_5 * I_zz + (t_6 * I_yz + t_7 * I_xz)) * alpha3 - (t_5 * tau3 + (t_6 * tau2 + t_7 *
    tau1)) <> t_5 * (I_zz * alpha3 + (I_yz * alpha2 + I_xz * alpha1) - tau3) + (t_6 * (I_yz * alpha3
    + (I_yy * alpha2 + I_xy * alpha1) - tau2) + t_7 * (I_xz * alpha3 + (I_xy * alpha2 + I_xx *
    alpha1) - tau1)).
Proof.
  exists (3 / 5), (-3 / 5), (6 / 5), (4 / 5), 1, 1, (2 / 5), 1, (2 / 5), (4 / 5), (-4 / 5), (3 / 5),
    (-7 / 5), (1 / 5), (-1 / 5), (4 / 5), (2 / 5), (-1 / 5), (2 / 5).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (19 / 25) computed.
  intros t_2; cut_to t_2 (-13 / 25) computed.
  intros t_3; cut_to t_3 (42 / 25) computed.
  intros t_4; cut_to t_4 (-311 / 625) computed.
  intros t_5; cut_to t_5 0 computed.
  intros t_6; cut_to t_6 (-4 / 5) computed.
  intros t_7; cut_to t_7 (3 / 5) computed.
  computed.
Qed.

(* With the torque's sign. *)

(* the rate of R I w, x *)
Theorem euler_from_constant_momentum_mutant_3 :
  exists I_xx I_xy I_xz I_yy I_yz I_zz alpha1 alpha2 alpha3 omega1 omega2 omega3 tau1 tau2 tau3 w x
    y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  let t_1 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_2 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_3 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_4 := ((y + y) * t_1 + ((- z - z) * t_2 + (w + w) * t_3)) * ((- (x * omega1) - y * omega2 - z
    * omega3) / 2) + ((z + z) * t_1 + ((y + y) * t_2 + (x + x) * t_3)) * ((w * omega1 + y * omega3 -
    z * omega2) / 2) + ((w + w) * t_1 + ((x + x) * t_2 + (- (y + y)) * t_3)) * ((w * omega2 - x *
    omega3 + z * omega1) / 2) + ((x + x) * t_1 + ((- w - w) * t_2 + (- (z + z)) * t_3)) * ((w *
    omega3 + x * omega2 - y * omega1) / 2) in
  let t_5 := x * z + w * y + (x * z + w * y) in
  let t_6 := x * y - w * z + (x * y - w * z) in
  let t_7 := w * w + x * x - y * y - z * z in
  let t_8 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_9 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_10 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  t_4 + (t_5 * I_xz + (t_6 * I_xy + t_7 * I_xx)) * alpha1 + (t_5 * I_yz + (t_6 * I_yy + t_7 * I_xy))
    * alpha2 + (t_5 * I_zz + (t_6 * I_yz + t_7 * I_xz)) * alpha3 - (t_5 * tau3 + (t_6 * tau2 + t_7 *
    tau1)) <> t_5 * (I_zz * alpha3 + (I_yz * alpha2 + I_xz * alpha1) - (t_8 * omega2 - t_9 * omega1
    - tau3)) + (t_6 * (I_yz * alpha3 + (I_yy * alpha2 + I_xy * alpha1) - (t_10 * omega1 - t_8 *
    omega3 - tau2)) + t_7 * (I_xz * alpha3 + (I_xy * alpha2 + I_xx * alpha1) - (t_9 * omega3 - t_10
    * omega2 - tau1))).
Proof.
  exists (3 / 5), (-3 / 5), (6 / 5), (4 / 5), 1, 1, (2 / 5), 1, (2 / 5), (4 / 5), (-4 / 5), (3 / 5),
    (-7 / 5), (1 / 5), (-1 / 5), (4 / 5), (2 / 5), (-1 / 5), (2 / 5).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (19 / 25) computed.
  intros t_2; cut_to t_2 (-13 / 25) computed.
  intros t_3; cut_to t_3 (42 / 25) computed.
  intros t_4; cut_to t_4 (-311 / 625) computed.
  intros t_5; cut_to t_5 0 computed.
  intros t_6; cut_to t_6 (-4 / 5) computed.
  intros t_7; cut_to t_7 (3 / 5) computed.
  intros t_8; cut_to t_8 (42 / 25) computed.
  intros t_9; cut_to t_9 (-13 / 25) computed.
  intros t_10; cut_to t_10 (19 / 25) computed.
  computed.
Qed.


(** momentum-form: L' = L x (J L) + torque is the same law as I w' = (I w) x w + torque, with L = I w and J I = 1, for every tensor. *)

(* L', x *)
Theorem momentum_form_1 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz omega1 omega2 omega3 tau1 : R,
  let t_1 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_2 := I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) + I_xz * (I_xy
    * I_yz - I_yy * I_xz) in
  let t_3 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_4 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  t_2 <> 0 ->
  t_1 * ((I_xx * I_yy - I_xy * I_xy) / t_2 * t_3 + ((I_xz * I_xy - I_yz * I_xx) / t_2 * t_1 + (I_xy
    * I_yz - I_yy * I_xz) / t_2 * t_4)) - t_3 * ((I_xz * I_xy - I_xx * I_yz) / t_2 * t_3 + ((I_zz *
    I_xx - I_xz * I_xz) / t_2 * t_1 + (I_yz * I_xz - I_xy * I_zz) / t_2 * t_4)) + tau1 = (I_yz *
    omega3 + (I_yy * omega2 + I_xy * omega1)) * omega3 - (I_zz * omega3 + (I_yz * omega2 + I_xz *
    omega1)) * omega2 + tau1.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz omega1 omega2 omega3 tau1  t_1 t_2 t_3 t_4 D_1.
  rational.
Qed.

(* L', y *)
Theorem momentum_form_2 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz omega1 omega2 omega3 tau2 : R,
  let t_1 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_2 := I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) + I_xz * (I_xy
    * I_yz - I_yy * I_xz) in
  let t_3 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_4 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  t_2 <> 0 ->
  t_1 * ((I_xy * I_yz - I_xz * I_yy) / t_2 * t_1 + ((I_yz * I_xz - I_zz * I_xy) / t_2 * t_3 + (I_yy
    * I_zz - I_yz * I_yz) / t_2 * t_4)) - t_4 * ((I_xx * I_yy - I_xy * I_xy) / t_2 * t_1 + ((I_xz *
    I_xy - I_yz * I_xx) / t_2 * t_3 + (I_xy * I_yz - I_yy * I_xz) / t_2 * t_4)) + tau2 = (I_zz *
    omega3 + (I_yz * omega2 + I_xz * omega1)) * omega1 - (I_xz * omega3 + (I_xy * omega2 + I_xx *
    omega1)) * omega3 + tau2.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz omega1 omega2 omega3 tau2  t_1 t_2 t_3 t_4 D_1.
  rational.
Qed.

(* L', z *)
Theorem momentum_form_3 :
  forall I_xx I_xy I_xz I_yy I_yz I_zz omega1 omega2 omega3 tau3 : R,
  let t_1 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  let t_2 := I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) + I_xz * (I_xy
    * I_yz - I_yy * I_xz) in
  let t_3 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_4 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  t_2 <> 0 ->
  t_1 * ((I_xz * I_xy - I_xx * I_yz) / t_2 * t_3 + ((I_zz * I_xx - I_xz * I_xz) / t_2 * t_4 + (I_yz
    * I_xz - I_xy * I_zz) / t_2 * t_1)) - t_4 * ((I_xy * I_yz - I_xz * I_yy) / t_2 * t_3 + ((I_yz *
    I_xz - I_zz * I_xy) / t_2 * t_4 + (I_yy * I_zz - I_yz * I_yz) / t_2 * t_1)) + tau3 = (I_xz *
    omega3 + (I_xy * omega2 + I_xx * omega1)) * omega2 - (I_yz * omega3 + (I_yy * omega2 + I_xy *
    omega1)) * omega1 + tau3.
Proof.
  intros I_xx I_xy I_xz I_yy I_yz I_zz omega1 omega2 omega3 tau3  t_1 t_2 t_3 t_4 D_1.
  rational.
Qed.

(* With (J L) x L for L x (J L). *)

(* L', x *)
Theorem momentum_form_mutant_1 :
  exists I_xx I_xy I_xz I_yy I_yz I_zz omega1 omega2 omega3 tau1 : R,
  let t_1 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_2 := I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) + I_xz * (I_xy
    * I_yz - I_yy * I_xz) in
  let t_3 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_4 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  t_2 <> 0 /\
  - (t_1 * ((I_xx * I_yy - I_xy * I_xy) / t_2 * t_3 + ((I_xz * I_xy - I_yz * I_xx) / t_2 * t_1 +
    (I_xy * I_yz - I_yy * I_xz) / t_2 * t_4)) - t_3 * ((I_xz * I_xy - I_xx * I_yz) / t_2 * t_3 +
    ((I_zz * I_xx - I_xz * I_xz) / t_2 * t_1 + (I_yz * I_xz - I_xy * I_zz) / t_2 * t_4)) - tau1) <>
    (I_yz * omega3 + (I_yy * omega2 + I_xy * omega1)) * omega3 - (I_zz * omega3 + (I_yz * omega2 +
    I_xz * omega1)) * omega2 + tau1.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5.
  intros t_1; cut_to t_1 20 computed.
  intros t_2; cut_to t_2 (-325) computed.
  intros t_3; cut_to t_3 20 computed.
  intros t_4; cut_to t_4 15 computed.
  split; [computed | ]. computed.
Qed.

(* With the torque left out. *)

(* L', x *)
Theorem momentum_form_mutant_2 :
  exists I_xx I_xy I_xz I_yy I_yz I_zz omega1 omega2 omega3 tau1 : R,
  let t_1 := I_yz * omega3 + (I_yy * omega2 + I_xy * omega1) in
  let t_2 := I_xx * (I_yy * I_zz - I_yz * I_yz) + I_xy * (I_yz * I_xz - I_xy * I_zz) + I_xz * (I_xy
    * I_yz - I_yy * I_xz) in
  let t_3 := I_zz * omega3 + (I_yz * omega2 + I_xz * omega1) in
  let t_4 := I_xz * omega3 + (I_xy * omega2 + I_xx * omega1) in
  t_2 <> 0 /\
  t_1 * ((I_xx * I_yy - I_xy * I_xy) / t_2 * t_3 + ((I_xz * I_xy - I_yz * I_xx) / t_2 * t_1 + (I_xy
    * I_yz - I_yy * I_xz) / t_2 * t_4)) - t_3 * ((I_xz * I_xy - I_xx * I_yz) / t_2 * t_3 + ((I_zz *
    I_xx - I_xz * I_xz) / t_2 * t_1 + (I_yz * I_xz - I_xy * I_zz) / t_2 * t_4)) <> (I_yz * omega3 +
    (I_yy * omega2 + I_xy * omega1)) * omega3 - (I_zz * omega3 + (I_yz * omega2 + I_xz * omega1)) *
    omega2 + tau1.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5.
  intros t_1; cut_to t_1 20 computed.
  intros t_2; cut_to t_2 (-325) computed.
  intros t_3; cut_to t_3 20 computed.
  intros t_4; cut_to t_4 15 computed.
  split; [computed | ]. computed.
Qed.


(** principal-form: Along principal axes the law is I1 w1' = (I2 - I3) w2 w3 + torque1 and so on round, as Euler wrote it. *)

(* the coupling, x *)
Theorem principal_form_1 :
  forall I2 I3 omega2 omega3 tau1 : R,
  (I2 - I3) * (omega2 * omega3) + tau1 = I2 * omega2 * omega3 - I3 * omega3 * omega2 + tau1.
Proof.
  intros I2 I3 omega2 omega3 tau1   .
  rational.
Qed.

(* the coupling, y *)
Theorem principal_form_2 :
  forall I1 I3 omega1 omega3 tau2 : R,
  (I3 - I1) * (omega3 * omega1) + tau2 = I3 * omega3 * omega1 - I1 * omega1 * omega3 + tau2.
Proof.
  intros I1 I3 omega1 omega3 tau2   .
  rational.
Qed.

(* the coupling, z *)
Theorem principal_form_3 :
  forall I1 I2 omega1 omega2 tau3 : R,
  (I1 - I2) * (omega1 * omega2) + tau3 = I1 * omega1 * omega2 - I2 * omega2 * omega1 + tau3.
Proof.
  intros I1 I2 omega1 omega2 tau3   .
  rational.
Qed.

(* I w', x *)
Theorem principal_form_4 :
  forall I1 I2 I3 omega2 omega3 tau1 : R,
  I1 <> 0 ->
  ((I2 - I3) * (omega2 * omega3) + tau1) / I1 * I1 = I2 * omega2 * omega3 - I3 * omega3 * omega2 +
    tau1.
Proof.
  intros I1 I2 I3 omega2 omega3 tau1   D_1.
  rational.
Qed.

(* I w', y *)
Theorem principal_form_5 :
  forall I1 I2 I3 omega1 omega3 tau2 : R,
  I2 <> 0 ->
  ((I3 - I1) * (omega3 * omega1) + tau2) / I2 * I2 = I3 * omega3 * omega1 - I1 * omega1 * omega3 +
    tau2.
Proof.
  intros I1 I2 I3 omega1 omega3 tau2   D_1.
  rational.
Qed.

(* I w', z *)
Theorem principal_form_6 :
  forall I1 I2 I3 omega1 omega2 tau3 : R,
  I3 <> 0 ->
  ((I1 - I2) * (omega1 * omega2) + tau3) / I3 * I3 = I1 * omega1 * omega2 - I2 * omega2 * omega1 +
    tau3.
Proof.
  intros I1 I2 I3 omega1 omega2 tau3   D_1.
  rational.
Qed.

(* With the sign of one equation. *)

(* the coupling, y *)
Theorem principal_form_mutant_1 :
  exists I1 I3 omega1 omega3 tau2 : R,
  - ((I3 - I1) * (omega3 * omega1)) + tau2 <> I3 * omega3 * omega1 - I1 * omega1 * omega3 + tau2.
Proof.
  exists 6, 1, (-3), 1, 7.
  computed.
Qed.

(* With two moments swapped. *)

(* the coupling, x *)
Theorem principal_form_mutant_2 :
  exists I1 I2 I3 omega2 omega3 tau1 : R,
  (I1 - I3) * (omega2 * omega3) + tau1 <> I2 * omega2 * omega3 - I3 * omega3 * omega2 + tau1.
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  computed.
Qed.

(* With the torque not divided by the moments. *)

(* I w', x *)
Theorem principal_form_mutant_3 :
  exists I1 I2 I3 omega2 omega3 tau1 : R,
  I1 <> 0 /\
  ((I2 - I3) * (omega2 * omega3) / I1 + tau1) * I1 <> I2 * omega2 * omega3 - I3 * omega3 * omega2 +
    tau1.
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  split; [computed | ]. computed.
Qed.


(** spin-rate-in-both-frames: The rate of the spin is the same seen from body and world: (R w)' = R w', since w x w = 0. *)

(* the rate of R w, x *)
Theorem spin_rate_in_both_frames_1 :
  forall alpha1 alpha2 alpha3 omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := ((y + y) * omega3 + ((- z - z) * omega2 + (w + w) * omega1)) * ((- (x * omega1) - y *
    omega2 - z * omega3) / 2) + ((z + z) * omega3 + ((y + y) * omega2 + (x + x) * omega1)) * ((w *
    omega1 + y * omega3 - z * omega2) / 2) + ((w + w) * omega3 + ((x + x) * omega2 + (- (y + y)) *
    omega1)) * ((w * omega2 - x * omega3 + z * omega1) / 2) + ((x + x) * omega3 + ((- w - w) *
    omega2 + (- (z + z)) * omega1)) * ((w * omega3 + x * omega2 - y * omega1) / 2) in
  let t_2 := w * w + x * x - y * y - z * z in
  let t_3 := x * y - w * z + (x * y - w * z) in
  let t_4 := x * z + w * y + (x * z + w * y) in
  t_1 + t_2 * alpha1 + t_3 * alpha2 + t_4 * alpha3 = t_4 * alpha3 + (t_3 * alpha2 + t_2 * alpha1).
Proof.
  intros alpha1 alpha2 alpha3 omega1 omega2 omega3 w x y z H_1 t_1 t_2 t_3 t_4 .
  rational.
Qed.

(* the rate of R w, z *)
Theorem spin_rate_in_both_frames_2 :
  forall alpha1 alpha2 alpha3 omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := ((w + w) * omega3 + ((x + x) * omega2 + (- y - y) * omega1)) * ((- (x * omega1) - y *
    omega2 - z * omega3) / 2) + ((- (x + x)) * omega3 + ((w + w) * omega2 + (z + z) * omega1)) * ((w
    * omega1 + y * omega3 - z * omega2) / 2) + ((- (y + y)) * omega3 + ((z + z) * omega2 + (- w - w)
    * omega1)) * ((w * omega2 - x * omega3 + z * omega1) / 2) in
  let t_2 := x * z - w * y + (x * z - w * y) in
  let t_3 := y * z + w * x + (y * z + w * x) in
  let t_4 := w * w - x * x - y * y + z * z in
  t_1 + ((z + z) * omega3 + ((y + y) * omega2 + (x + x) * omega1)) * ((w * omega3 + x * omega2 - y *
    omega1) / 2) + t_2 * alpha1 + t_3 * alpha2 + t_4 * alpha3 = t_4 * alpha3 + (t_3 * alpha2 + t_2 *
    alpha1).
Proof.
  intros alpha1 alpha2 alpha3 omega1 omega2 omega3 w x y z H_1 t_1 t_2 t_3 t_4 .
  rational.
Qed.

(* With the attitude turning about a fixed axis in place of the spin. *)

(* the rate of R w, x *)
Theorem spin_rate_in_both_frames_mutant_1 :
  exists alpha1 alpha2 alpha3 e1 e2 e3 omega1 omega2 omega3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 /\
  let t_1 := ((y + y) * omega3 + ((- z - z) * omega2 + (w + w) * omega1)) * ((- (x * e1) - y * e2 -
    z * e3) / 2) + ((z + z) * omega3 + ((y + y) * omega2 + (x + x) * omega1)) * ((w * e1 + y * e3 -
    z * e2) / 2) + ((w + w) * omega3 + ((x + x) * omega2 + (- (y + y)) * omega1)) * ((w * e2 - x *
    e3 + z * e1) / 2) + ((x + x) * omega3 + ((- w - w) * omega2 + (- (z + z)) * omega1)) * ((w * e3
    + x * e2 - y * e1) / 2) in
  let t_2 := w * w + x * x - y * y - z * z in
  let t_3 := x * y - w * z + (x * y - w * z) in
  let t_4 := x * z + w * y + (x * z + w * y) in
  t_1 + t_2 * alpha1 + t_3 * alpha2 + t_4 * alpha3 <> t_4 * alpha3 + (t_3 * alpha2 + t_2 * alpha1).
Proof.
  exists (-4 / 9), (2 / 9), (2 / 9), (-2 / 9), (2 / 9), (2 / 3), (5 / 9), (-5 / 9), (-1 / 9), (-8 /
    9), (2 / 9), (1 / 3), (-2 / 9).
  split; [computed | ]. 
  intros t_1; cut_to t_1 (980 / 6561) computed.
  intros t_2; cut_to t_2 (55 / 81) computed.
  intros t_3; cut_to t_3 (-20 / 81) computed.
  intros t_4; cut_to t_4 (-56 / 81) computed.
  computed.
Qed.


(** energy: The energy changes at the rate w.torque, and not at all without: in both forms of the law, for every tensor and spin. *)

(* by L' = L x (J L) + torque *)
Theorem energy_1 :
  forall J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 tau1 tau2 tau3 : R,
  let t_1 := J_xz * L3 + (J_xy * L2 + J_xx * L1) in
  let t_2 := J_zz * L3 + (J_yz * L2 + J_xz * L1) in
  let t_3 := J_yz * L3 + (J_yy * L2 + J_xy * L1) in
  let t_4 := J_yz * L3 + (J_yy * L2 + J_xy * L1) in
  let t_5 := J_xz * L3 + (J_xy * L2 + J_xx * L1) in
  let t_6 := J_zz * L3 + (J_yz * L2 + J_xz * L1) in
  (J_xx * L1 + t_1 + J_xy * L2 + J_xz * L3) / 2 * (L2 * t_2 - L3 * t_3 + tau1) + (J_xy * L1 + (J_yy
    * L2 + t_4) + J_yz * L3) / 2 * (L3 * t_5 - L1 * t_2 + tau2) + (J_xz * L1 + J_yz * L2 + (J_zz *
    L3 + t_6)) / 2 * (L1 * t_3 - L2 * t_5 + tau3) = t_1 * tau1 + t_4 * tau2 + t_6 * tau3.
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 tau1 tau2 tau3  t_1 t_2 t_3 t_4 t_5 t_6 .
  rational.
Qed.

(* by I w' = (I w) x w + torque *)
Theorem energy_2 :
  forall I1 I2 I3 omega1 omega2 omega3 tau1 tau2 tau3 : R,
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  (I1 * omega1 + omega1 * I1) / 2 * (((I2 - I3) * (omega2 * omega3) + tau1) / I1) + (I2 * omega2 +
    omega2 * I2) / 2 * (((I3 - I1) * (omega3 * omega1) + tau2) / I2) + (I3 * omega3 + omega3 * I3) /
    2 * (((I1 - I2) * (omega1 * omega2) + tau3) / I3) = omega1 * tau1 + omega2 * tau2 + omega3 *
    tau3.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3 tau1 tau2 tau3   D_1 D_2 D_3.
  rational.
Qed.

(* With the torque taken twice. *)

(* by L' = L x (J L) + torque *)
Theorem energy_mutant_1 :
  exists J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 tau1 tau2 tau3 : R,
  let t_1 := J_xz * L3 + (J_xy * L2 + J_xx * L1) in
  let t_2 := J_zz * L3 + (J_yz * L2 + J_xz * L1) in
  let t_3 := J_yz * L3 + (J_yy * L2 + J_xy * L1) in
  let t_4 := J_yz * L3 + (J_yy * L2 + J_xy * L1) in
  let t_5 := J_xz * L3 + (J_xy * L2 + J_xx * L1) in
  let t_6 := J_zz * L3 + (J_yz * L2 + J_xz * L1) in
  (J_xx * L1 + t_1 + J_xy * L2 + J_xz * L3) / 2 * (L2 * t_2 - L3 * t_3 + tau1 * 2) + (J_xy * L1 +
    (J_yy * L2 + t_4) + J_yz * L3) / 2 * (L3 * t_5 - L1 * t_2 + tau2 * 2) + (J_xz * L1 + J_yz * L2 +
    (J_zz * L3 + t_6)) / 2 * (L1 * t_3 - L2 * t_5 + tau3 * 2) <> t_1 * tau1 + t_4 * tau2 + t_6 *
    tau3.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6.
  intros t_1; cut_to t_1 15 computed.
  intros t_2; cut_to t_2 20 computed.
  intros t_3; cut_to t_3 20 computed.
  intros t_4; cut_to t_4 20 computed.
  intros t_5; cut_to t_5 15 computed.
  intros t_6; cut_to t_6 20 computed.
  computed.
Qed.

(* With the sign of one of Euler's equations. *)

(* by I w' = (I w) x w + torque *)
Theorem energy_mutant_2 :
  exists I1 I2 I3 omega1 omega2 omega3 tau1 tau2 tau3 : R,
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  (I1 * omega1 + omega1 * I1) / 2 * (((I2 - I3) * (omega2 * omega3) + tau1) / I1) + (I2 * omega2 +
    omega2 * I2) / 2 * (tau2 / I2 * 2 - ((I3 - I1) * (omega3 * omega1) + tau2) / I2) + (I3 * omega3
    + omega3 * I3) / 2 * (((I1 - I2) * (omega1 * omega2) + tau3) / I3) <> omega1 * tau1 + omega2 *
    tau2 + omega3 * tau3.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With L1' without its gyroscopic term. *)

(* by L' = L x (J L) + torque *)
Theorem energy_mutant_3 :
  exists J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 tau1 tau2 tau3 : R,
  let t_1 := J_xz * L3 + (J_xy * L2 + J_xx * L1) in
  let t_2 := J_yz * L3 + (J_yy * L2 + J_xy * L1) in
  let t_3 := J_xz * L3 + (J_xy * L2 + J_xx * L1) in
  let t_4 := J_zz * L3 + (J_yz * L2 + J_xz * L1) in
  (J_xx * L1 + t_1 + J_xy * L2 + J_xz * L3) / 2 * tau1 + (J_xy * L1 + (J_yy * L2 + t_2) + J_yz * L3)
    / 2 * (L3 * t_3 - L1 * (J_zz * L3 + (J_yz * L2 + J_xz * L1)) + tau2) + (J_xz * L1 + J_yz * L2 +
    (J_zz * L3 + t_4)) / 2 * (L1 * (J_yz * L3 + (J_yy * L2 + J_xy * L1)) - L2 * t_3 + tau3) <> t_1 *
    tau1 + t_2 * tau2 + t_4 * tau3.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6.
  intros t_1; cut_to t_1 15 computed.
  intros t_2; cut_to t_2 20 computed.
  intros t_3; cut_to t_3 15 computed.
  intros t_4; cut_to t_4 20 computed.
  computed.
Qed.


(** length-of-momentum: |L|² changes at the rate 2 L.torque, and not at all without, for every tensor and spin. *)

(* by L' = L x (J L) + torque *)
Theorem length_of_momentum_1 :
  forall J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 tau1 tau2 tau3 : R,
  let t_1 := J_zz * L3 + (J_yz * L2 + J_xz * L1) in
  let t_2 := J_yz * L3 + (J_yy * L2 + J_xy * L1) in
  let t_3 := J_xz * L3 + (J_xy * L2 + J_xx * L1) in
  (L1 + L1) * (L2 * t_1 - L3 * t_2 + tau1) + (L2 + L2) * (L3 * t_3 - L1 * t_1 + tau2) + (L3 + L3) *
    (L1 * t_2 - L2 * t_3 + tau3) = (L1 * tau1 + L2 * tau2 + L3 * tau3) * 2.
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 tau1 tau2 tau3  t_1 t_2 t_3 .
  rational.
Qed.

(* by I w' = (I w) x w + torque *)
Theorem length_of_momentum_2 :
  forall I1 I2 I3 omega1 omega2 omega3 tau1 tau2 tau3 : R,
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  (I1 * (I1 * omega1) + I1 * omega1 * I1) * (((I2 - I3) * (omega2 * omega3) + tau1) / I1) + (I2 *
    (I2 * omega2) + I2 * omega2 * I2) * (((I3 - I1) * (omega3 * omega1) + tau2) / I2) + (I3 * (I3 *
    omega3) + I3 * omega3 * I3) * (((I1 - I2) * (omega1 * omega2) + tau3) / I3) = (I1 * omega1 *
    tau1 + I2 * omega2 * tau2 + I3 * omega3 * tau3) * 2.
Proof.
  intros I1 I2 I3 omega1 omega2 omega3 tau1 tau2 tau3   D_1 D_2 D_3.
  rational.
Qed.

(* With the sign of one of Euler's equations. *)

(* by I w' = (I w) x w + torque *)
Theorem length_of_momentum_mutant_1 :
  exists I1 I2 I3 omega1 omega2 omega3 tau1 tau2 tau3 : R,
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  (I1 * (I1 * omega1) + I1 * omega1 * I1) * (((I2 - I3) * (omega2 * omega3) + tau1) / I1) + (I2 *
    (I2 * omega2) + I2 * omega2 * I2) * (tau2 / I2 * 2 - ((I3 - I1) * (omega3 * omega1) + tau2) /
    I2) + (I3 * (I3 * omega3) + I3 * omega3 * I3) * (((I1 - I2) * (omega1 * omega2) + tau3) / I3) <>
    (I1 * omega1 * tau1 + I2 * omega2 * tau2 + I3 * omega3 * tau3) * 2.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With L x (J L) becomes L x (J L) + L. *)

(* by L' = L x (J L) + torque *)
Theorem length_of_momentum_mutant_2 :
  exists J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 tau1 tau2 tau3 : R,
  let t_1 := J_zz * L3 + (J_yz * L2 + J_xz * L1) in
  let t_2 := J_yz * L3 + (J_yy * L2 + J_xy * L1) in
  let t_3 := J_xz * L3 + (J_xy * L2 + J_xx * L1) in
  (L1 + L1) * (L2 * t_1 - L3 * t_2 + tau1 + L1) + (L2 + L2) * (L3 * t_3 - L1 * t_1 + tau2 + L2) +
    (L3 + L3) * (L1 * t_2 - L2 * t_3 + tau3 + L3) <> (L1 * tau1 + L2 * tau2 + L3 * tau3) * 2.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6.
  intros t_1; cut_to t_1 20 computed.
  intros t_2; cut_to t_2 20 computed.
  intros t_3; cut_to t_3 15 computed.
  computed.
Qed.


(** spin-is-not-conserved: |w|² changes at the rate -2 (I1 - I2)(I2 - I3)(I3 - I1) w1 w2 w3 / (I1 I2 I3), a body and a spin for which that is not zero being found by search; it is zero for every body with two equal moments. *)

(* the rate of |w|² *)
Theorem spin_is_not_conserved_1 :
  exists I1 I2 I3 omega1 omega2 omega3 : R,
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  (omega1 + omega1) * ((I2 - I3) * (omega2 * omega3) / I1) + (omega2 + omega2) * ((I3 - I1) *
    (omega3 * omega1) / I2) + (omega3 + omega3) * ((I1 - I2) * (omega1 * omega2) / I3) <> 0.
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* the rate of |w|² *)
Theorem spin_is_not_conserved_2 :
  forall I1 I2 I3 omega1 omega2 omega3 : R,
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  (omega1 + omega1) * ((I2 - I3) * (omega2 * omega3) / I1) + (omega2 + omega2) * ((I3 - I1) *
    (omega3 * omega1) / I2) + (omega3 + omega3) * ((I1 - I2) * (omega1 * omega2) / I3) = (-2) * ((I1
    - I2) * (I2 - I3) * (I3 - I1) / (I1 * I2 * I3)) * (omega1 * omega2 * omega3).
Proof.
  intros I1 I2 I3 omega1 omega2 omega3   D_1 D_2 D_3.
  rational.
Qed.

(* two equal moments *)
Theorem spin_is_not_conserved_3 :
  forall I2 I3 omega1 omega2 omega3 : R,
  I2 <> 0 ->
  I3 <> 0 ->
  (omega1 + omega1) * ((I2 - I3) * (omega2 * omega3) / I2) + (omega2 + omega2) * ((I3 - I2) *
    (omega3 * omega1) / I2) + (omega3 + omega3) * ((I2 - I2) * (omega1 * omega2) / I3) = 0.
Proof.
  intros I2 I3 omega1 omega2 omega3   D_1 D_2.
  rational.
Qed.

(* two equal moments *)
Theorem spin_is_not_conserved_4 :
  forall I1 I3 omega1 omega2 omega3 : R,
  I1 <> 0 ->
  I3 <> 0 ->
  (omega1 + omega1) * ((I3 - I3) * (omega2 * omega3) / I1) + (omega2 + omega2) * ((I3 - I1) *
    (omega3 * omega1) / I3) + (omega3 + omega3) * ((I1 - I3) * (omega1 * omega2) / I3) = 0.
Proof.
  intros I1 I3 omega1 omega2 omega3   D_1 D_2.
  rational.
Qed.

(* two equal moments *)
Theorem spin_is_not_conserved_5 :
  forall I1 I2 omega1 omega2 omega3 : R,
  I1 <> 0 ->
  I2 <> 0 ->
  (omega1 + omega1) * ((I2 - I1) * (omega2 * omega3) / I1) + (omega2 + omega2) * ((I1 - I1) *
    (omega3 * omega1) / I2) + (omega3 + omega3) * ((I1 - I2) * (omega1 * omega2) / I1) = 0.
Proof.
  intros I1 I2 omega1 omega2 omega3   D_1 D_2.
  rational.
Qed.

(* With the law of a ball. *)

(* the rate of |w|² *)
Theorem spin_is_not_conserved_mutant_1_1 :
  0 = 0.
Proof.
  intros    .
  rational.
Qed.

(* With a steady spin. *)

(* the rate of |w|² *)
Theorem spin_is_not_conserved_mutant_2_1 :
  0 = 0.
Proof.
  intros    .
  rational.
Qed.
