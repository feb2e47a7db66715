(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics.


(** right-engine: The right engine keeps all: momentum, its length, energy, Euler's equations, and the spin belongs to its momentum. *)

(* Turned, Momentum *)
Theorem right_engine_2 :
  forall I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * (1 / I3) in
  let t_2 := t_1 * (w * w + w * w) * v3 in
  let t_3 := I3 * ((w * w + w * w) * t_2) in
  let t_4 := (w * w + w * w) * ((w * w + w * w) * (1 / I3) * (w * w + w * w) * v3) in
  let t_5 := - (w * w) - w * w in
  let t_6 := (w * w + w * w) * ((w * w + w * w) * (0 / I3) * (w * w + w * w) * v3 + ((t_1 * (- w -
    w) + ((w + w) * (1 / I2) * (w * w - w * w) + (w + w) * (1 / I1) * (w * w + w * w))) * v2 + (t_1
    * (w + w) + ((w + w) * (1 / I2) * t_5 + (w + w) * (1 / I1) * (w * w - w * w))) * v1)) in
  let t_7 := (w * w - w * w) * (1 / I2) in
  let t_8 := (w * w + w * w) * (1 / I1) in
  let t_9 := (t_7 * (w * w - w * w) + t_8 * (w * w + w * w)) * v2 + (t_7 * t_5 + t_8 * (w * w - w *
    w)) * v1 in
  let t_10 := (w * w - w * w) * (1 / I1) in
  let t_11 := (t_5 * (1 / I2) * (w * w - w * w) + t_10 * (w * w + w * w)) * v2 + (t_5 * (1 / I2) *
    t_5 + t_10 * (w * w - w * w)) * v1 in
  let t_12 := I2 * ((w * w - w * w) * t_9 + t_5 * t_11) in
  let t_13 := I1 * ((w * w + w * w) * t_9 + (w * w - w * w) * t_11) in
  let t_14 := (w * w - w * w) * (1 / I2) in
  let t_15 := (w * w + w * w) * (1 / I1) in
  let t_16 := - (w * w) - w * w in
  let t_17 := (t_14 * (w * w - w * w) + t_15 * (w * w + w * w)) * v2 + (t_14 * t_16 + t_15 * (w * w
    - w * w)) * v1 in
  let t_18 := (w * w - w * w) * (1 / I1) in
  let t_19 := (t_16 * (1 / I2) * (w * w - w * w) + t_18 * (w * w + w * w)) * v2 + (t_16 * (1 / I2) *
    t_16 + t_18 * (w * w - w * w)) * v1 in
  let t_20 := (w * w + w * w) * t_17 + (w * w - w * w) * t_19 in
  let t_21 := (w * w - w * w) * t_17 + t_16 * t_19 in
  let t_22 := ((w + w) * t_3 + (w * w + w * w) * (I3 * ((w + w) * t_2 + (w * w + w * w) * ((((w + w)
    * (1 / I3) + (w * w + w * w) * (0 / I3)) * (w * w + w * w) + t_1 * (w + w)) * v3)))) * ((- (w *
    t_4)) / 2) + ((w * w + w * w) * (I3 * (t_6 + ((- w - w) * t_9 + (w + w) * t_11))) + ((w + w) *
    t_12 + (w + w) * t_13)) * ((w * t_20 - w * t_21) / 2) in
  let t_23 := (- w - w) * (1 / I1) in
  let t_24 := (w * w + w * w) * ((w * w + w * w) * (0 / I3) * (w * w + w * w) * v3 + ((t_1 * (w + w)
    + ((w + w) * (1 / I2) * (w * w - w * w) + t_23 * (w * w + w * w))) * v2 + (t_1 * (w + w) + ((w +
    w) * (1 / I2) * t_5 + t_23 * (w * w - w * w))) * v1)) + ((w + w) * t_9 + (w + w) * t_11) in
  let t_25 := t_22 + ((w * w + w * w) * (I3 * t_24) + ((w + w) * t_12 + (- w - w) * t_13)) * ((w *
    t_21 + w * t_20) / 2) + ((w + w) * t_3 + (w * w + w * w) * (I3 * ((w + w) * t_2 + (w * w + w *
    w) * ((((w + w) * (1 / I3) + (w * w + w * w) * (0 / I3)) * (w * w + w * w) + t_1 * (w + w)) *
    v3)))) * (w * t_4 / 2) in
  I3 <> 0 ->
  I2 <> 0 ->
  I1 <> 0 ->
  t_25 = 0.
Proof.
  intros I1 I2 I3 v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15
    t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 D_1 D_2 D_3.
  cut_to t_1 ((1) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_2 ((v3) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_3 (v3) ltac:(field [H_1]; nonzero).
  cut_to t_4 ((v3) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_5 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_6 ((2 * I1 * I2 * v1 * w - 2 * I1 * I2 * v2 * w - 2 * I1 * I3 * v1 * w + 2 * I2 * I3 * v2
    * w) / (I1 * I2 * I3)) ltac:(field [H_1]; nonzero).
  cut_to t_7 (0) ltac:(field [H_1]; nonzero).
  cut_to t_8 ((1) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_9 ((v2) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_10 (0) ltac:(field [H_1]; nonzero).
  cut_to t_11 ((v1) / (I2)) ltac:(field [H_1]; nonzero).
  cut_to t_12 (- v1) ltac:(field [H_1]; nonzero).
  cut_to t_13 (v2) ltac:(field [H_1]; nonzero).
  cut_to t_14 (0) ltac:(field [H_1]; nonzero).
  cut_to t_15 ((1) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_16 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_17 ((v2) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_18 (0) ltac:(field [H_1]; nonzero).
  cut_to t_19 ((v1) / (I2)) ltac:(field [H_1]; nonzero).
  cut_to t_20 ((v2) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_21 ((- v1) / (I2)) ltac:(field [H_1]; nonzero).
  cut_to t_22 ((- (2 * v3 ^ 2)) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_23 ((- (2 * w)) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_24 ((2 * v1 * w + 2 * v2 * w) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_25 (0) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* Turned, Euler *)
Theorem right_engine_10 :
  forall I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * (1 / I3) in
  let t_2 := t_1 * (w * w + w * w) * v3 in
  let t_3 := (w * w + w * w) * ((w * w + w * w) * (1 / I3) * (w * w + w * w) * v3) in
  let t_4 := - (w * w) - w * w in
  let t_5 := (w * w + w * w) * ((w * w + w * w) * (0 / I3) * (w * w + w * w) * v3 + ((t_1 * (- w -
    w) + ((w + w) * (1 / I2) * (w * w - w * w) + (w + w) * (1 / I1) * (w * w + w * w))) * v2 + (t_1
    * (w + w) + ((w + w) * (1 / I2) * t_4 + (w + w) * (1 / I1) * (w * w - w * w))) * v1)) in
  let t_6 := (w * w - w * w) * (1 / I2) in
  let t_7 := (w * w + w * w) * (1 / I1) in
  let t_8 := (t_6 * (w * w - w * w) + t_7 * (w * w + w * w)) * v2 + (t_6 * t_4 + t_7 * (w * w - w *
    w)) * v1 in
  let t_9 := (w * w - w * w) * (1 / I1) in
  let t_10 := (t_4 * (1 / I2) * (w * w - w * w) + t_9 * (w * w + w * w)) * v2 + (t_4 * (1 / I2) *
    t_4 + t_9 * (w * w - w * w)) * v1 in
  let t_11 := (w * w - w * w) * (1 / I2) in
  let t_12 := (w * w + w * w) * (1 / I1) in
  let t_13 := - (w * w) - w * w in
  let t_14 := (t_11 * (w * w - w * w) + t_12 * (w * w + w * w)) * v2 + (t_11 * t_13 + t_12 * (w * w
    - w * w)) * v1 in
  let t_15 := (w * w - w * w) * (1 / I1) in
  let t_16 := (t_13 * (1 / I2) * (w * w - w * w) + t_15 * (w * w + w * w)) * v2 + (t_13 * (1 / I2) *
    t_13 + t_15 * (w * w - w * w)) * v1 in
  let t_17 := (w * w + w * w) * t_14 + (w * w - w * w) * t_16 in
  let t_18 := (w * w - w * w) * t_14 + t_13 * t_16 in
  let t_19 := (- w - w) * (1 / I1) in
  let t_20 := (w * w + w * w) * ((w * w + w * w) * (0 / I3) * (w * w + w * w) * v3 + ((t_1 * (w + w)
    + ((w + w) * (1 / I2) * (w * w - w * w) + t_19 * (w * w + w * w))) * v2 + (t_1 * (w + w) + ((w +
    w) * (1 / I2) * t_4 + t_19 * (w * w - w * w))) * v1)) + ((w + w) * t_8 + (w + w) * t_10) in
  let t_21 := ((w + w) * t_2 + (w * w + w * w) * ((((w + w) * (1 / I3) + (w * w + w * w) * (0 / I3))
    * (w * w + w * w) + t_1 * (w + w)) * v3)) * ((- (w * t_3)) / 2) + (t_5 + ((- w - w) * t_8 + (w +
    w) * t_10)) * ((w * t_17 - w * t_18) / 2) + t_20 * ((w * t_18 + w * t_17) / 2) + ((w + w) * t_2
    + (w * w + w * w) * ((((w + w) * (1 / I3) + (w * w + w * w) * (0 / I3)) * (w * w + w * w) + t_1
    * (w + w)) * v3)) * (w * t_3 / 2) in
  let t_22 := (w * w + w * w) * t_8 + (w * w - w * w) * t_10 in
  let t_23 := (w * w - w * w) * t_8 + t_4 * t_10 in
  I3 <> 0 ->
  I2 <> 0 ->
  I1 <> 0 ->
  I3 * t_21 - (I1 * t_22 * t_23 - I2 * t_23 * t_22) = 0.
Proof.
  intros I1 I2 I3 v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15
    t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 D_1 D_2 D_3.
  cut_to t_1 ((1) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_2 ((v3) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_3 ((v3) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_4 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_5 ((2 * I1 * I2 * v1 * w - 2 * I1 * I2 * v2 * w - 2 * I1 * I3 * v1 * w + 2 * I2 * I3 * v2
    * w) / (I1 * I2 * I3)) ltac:(field [H_1]; nonzero).
  cut_to t_6 (0) ltac:(field [H_1]; nonzero).
  cut_to t_7 ((1) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_8 ((v2) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_9 (0) ltac:(field [H_1]; nonzero).
  cut_to t_10 ((v1) / (I2)) ltac:(field [H_1]; nonzero).
  cut_to t_11 (0) ltac:(field [H_1]; nonzero).
  cut_to t_12 ((1) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_13 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_14 ((v2) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_15 (0) ltac:(field [H_1]; nonzero).
  cut_to t_16 ((v1) / (I2)) ltac:(field [H_1]; nonzero).
  cut_to t_17 ((v2) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_18 ((- v1) / (I2)) ltac:(field [H_1]; nonzero).
  cut_to t_19 ((- (2 * w)) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_20 ((2 * v1 * w + 2 * v2 * w) / (I3)) ltac:(field [H_1]; nonzero).
  cut_to t_21 ((- (I1 * v1 * v2) + I2 * v1 * v2) / (I1 * I2 * I3)) ltac:(field [H_1]; nonzero).
  cut_to t_22 ((v2) / (I1)) ltac:(field [H_1]; nonzero).
  cut_to t_23 ((- v1) / (I2)) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum *)
Theorem right_engine_14 :
  forall I1 I2 v1 v2 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := - (w * w) - w * w in
  let t_2 := (w * w - w * w) * I1 in
  let t_3 := (w * w - w * w) * (1 / I2) in
  let t_4 := (w * w + w * w) * (1 / I1) in
  let t_5 := (w * w - w * w) * (1 / I1) in
  let t_6 := (t_1 * I2 * (w * w - w * w) + t_2 * (w * w + w * w)) * ((t_3 * (w * w - w * w) + t_4 *
    (w * w + w * w)) * v2 + (t_3 * t_1 + t_4 * (w * w - w * w)) * v1) + (t_1 * I2 * t_1 + t_2 * (w *
    w - w * w)) * ((t_1 * (1 / I2) * (w * w - w * w) + t_5 * (w * w + w * w)) * v2 + (t_1 * (1 / I2)
    * t_1 + t_5 * (w * w - w * w)) * v1) in
  I2 <> 0 ->
  I1 <> 0 ->
  t_6 - v1 = 0.
Proof.
  intros I1 I2 v1 v2 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 D_1 D_2.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum *)
Theorem right_engine_15 :
  forall I1 I2 v1 v2 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w - w * w) * I2 in
  let t_2 := (w * w + w * w) * I1 in
  let t_3 := (w * w - w * w) * (1 / I2) in
  let t_4 := (w * w + w * w) * (1 / I1) in
  let t_5 := - (w * w) - w * w in
  let t_6 := (w * w - w * w) * (1 / I1) in
  let t_7 := (t_1 * (w * w - w * w) + t_2 * (w * w + w * w)) * ((t_3 * (w * w - w * w) + t_4 * (w *
    w + w * w)) * v2 + (t_3 * t_5 + t_4 * (w * w - w * w)) * v1) + (t_1 * t_5 + t_2 * (w * w - w *
    w)) * ((t_5 * (1 / I2) * (w * w - w * w) + t_6 * (w * w + w * w)) * v2 + (t_5 * (1 / I2) * t_5 +
    t_6 * (w * w - w * w)) * v1) in
  I2 <> 0 ->
  I1 <> 0 ->
  t_7 - v2 = 0.
Proof.
  intros I1 I2 v1 v2 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 D_1 D_2.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum *)
Theorem right_engine_16 :
  forall I3 v3 w : R,
  w ^ 2 = (1 / 2) ->
  I3 <> 0 ->
  (w * w + w * w) * I3 * (w * w + w * w) * ((w * w + w * w) * (1 / I3) * (w * w + w * w) * v3) - v3
    = 0.
Proof.
  intros I3 v3 w H_1  D_1.
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum, x *)
Theorem right_engine_17 :
  forall I1 I2 I3 v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := w * w - x * x - y * y + z * z in
  let t_3 := x * y - w * z + (x * y - w * z) in
  let t_4 := y * z + w * x + (y * z + w * x) in
  let t_5 := w * w + x * x - y * y - z * z in
  let t_6 := x * z - w * y + (x * z - w * y) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := w * w - x * x + y * y - z * z in
  let t_9 := x * y + w * z + (x * y + w * z) in
  let t_10 := (t_1 * I3 * t_7 + (t_3 * I2 * t_8 + t_5 * I1 * t_9)) * ((t_7 * (1 / I3) * t_2 + (t_8 *
    (1 / I2) * t_4 + t_9 * (1 / I1) * t_6)) * v3 + ((t_7 * (1 / I3) * t_7 + (t_8 * (1 / I2) * t_8 +
    t_9 * (1 / I1) * t_9)) * v2 + (t_7 * (1 / I3) * t_1 + (t_8 * (1 / I2) * t_3 + t_9 * (1 / I1) *
    t_5)) * v1)) + (t_1 * I3 * t_1 + (t_3 * I2 * t_3 + t_5 * I1 * t_5)) * ((t_1 * (1 / I3) * t_2 +
    (t_3 * (1 / I2) * t_4 + t_5 * (1 / I1) * t_6)) * v3 + ((t_1 * (1 / I3) * t_7 + (t_3 * (1 / I2) *
    t_8 + t_5 * (1 / I1) * t_9)) * v2 + (t_1 * (1 / I3) * t_1 + (t_3 * (1 / I2) * t_3 + t_5 * (1 /
    I1) * t_5)) * v1)) in
  I3 <> 0 ->
  I2 <> 0 ->
  I1 <> 0 ->
  (t_1 * I3 * t_2 + (t_3 * I2 * t_4 + t_5 * I1 * t_6)) * ((t_2 * (1 / I3) * t_2 + (t_4 * (1 / I2) *
    t_4 + t_6 * (1 / I1) * t_6)) * v3 + ((t_2 * (1 / I3) * t_7 + (t_4 * (1 / I2) * t_8 + t_6 * (1 /
    I1) * t_9)) * v2 + (t_2 * (1 / I3) * t_1 + (t_4 * (1 / I2) * t_3 + t_6 * (1 / I1) * t_5)) * v1))
    + t_10 - v1 = 0.
Proof.
  intros I1 I2 I3 v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 D_1 D_2 D_3.
  cut_to t_1 (2 * w * y + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_2 (- (2 * x ^ 2) - 2 * y ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_3 (- (2 * w * z) + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_4 (2 * w * x + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_5 (- (2 * y ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_6 (- (2 * w * y) + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_7 (- (2 * w * x) + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_8 (- (2 * x ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_9 (2 * w * z + 2 * x * y) ltac:(field [H_1]; nonzero).
  subst t_10.
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum, y *)
Theorem right_engine_18 :
  forall I1 I2 I3 v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x - y * y + z * z in
  let t_3 := w * w - x * x + y * y - z * z in
  let t_4 := y * z + w * x + (y * z + w * x) in
  let t_5 := x * y + w * z + (x * y + w * z) in
  let t_6 := x * z - w * y + (x * z - w * y) in
  let t_7 := x * z + w * y + (x * z + w * y) in
  let t_8 := x * y - w * z + (x * y - w * z) in
  let t_9 := w * w + x * x - y * y - z * z in
  let t_10 := (t_1 * I3 * t_1 + (t_3 * I2 * t_3 + t_5 * I1 * t_5)) * ((t_1 * (1 / I3) * t_2 + (t_3 *
    (1 / I2) * t_4 + t_5 * (1 / I1) * t_6)) * v3 + ((t_1 * (1 / I3) * t_1 + (t_3 * (1 / I2) * t_3 +
    t_5 * (1 / I1) * t_5)) * v2 + (t_1 * (1 / I3) * t_7 + (t_3 * (1 / I2) * t_8 + t_5 * (1 / I1) *
    t_9)) * v1)) + (t_1 * I3 * t_7 + (t_3 * I2 * t_8 + t_5 * I1 * t_9)) * ((t_7 * (1 / I3) * t_2 +
    (t_8 * (1 / I2) * t_4 + t_9 * (1 / I1) * t_6)) * v3 + ((t_7 * (1 / I3) * t_1 + (t_8 * (1 / I2) *
    t_3 + t_9 * (1 / I1) * t_5)) * v2 + (t_7 * (1 / I3) * t_7 + (t_8 * (1 / I2) * t_8 + t_9 * (1 /
    I1) * t_9)) * v1)) in
  I3 <> 0 ->
  I2 <> 0 ->
  I1 <> 0 ->
  (t_1 * I3 * t_2 + (t_3 * I2 * t_4 + t_5 * I1 * t_6)) * ((t_2 * (1 / I3) * t_2 + (t_4 * (1 / I2) *
    t_4 + t_6 * (1 / I1) * t_6)) * v3 + ((t_2 * (1 / I3) * t_1 + (t_4 * (1 / I2) * t_3 + t_6 * (1 /
    I1) * t_5)) * v2 + (t_2 * (1 / I3) * t_7 + (t_4 * (1 / I2) * t_8 + t_6 * (1 / I1) * t_9)) * v1))
    + t_10 - v2 = 0.
Proof.
  intros I1 I2 I3 v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 D_1 D_2 D_3.
  cut_to t_1 (- (2 * w * x) + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_2 (- (2 * x ^ 2) - 2 * y ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_3 (- (2 * x ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_4 (2 * w * x + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_5 (2 * w * z + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_6 (- (2 * w * y) + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_7 (2 * w * y + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_8 (- (2 * w * z) + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_9 (- (2 * y ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  subst t_10.
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum, z *)
Theorem right_engine_19 :
  forall I1 I2 I3 v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := y * z - w * x + (y * z - w * x) in
  let t_5 := w * w - x * x + y * y - z * z in
  let t_6 := x * y + w * z + (x * y + w * z) in
  let t_7 := x * z + w * y + (x * z + w * y) in
  let t_8 := x * y - w * z + (x * y - w * z) in
  let t_9 := w * w + x * x - y * y - z * z in
  let t_10 := (t_1 * I3 * t_4 + (t_2 * I2 * t_5 + t_3 * I1 * t_6)) * ((t_4 * (1 / I3) * t_1 + (t_5 *
    (1 / I2) * t_2 + t_6 * (1 / I1) * t_3)) * v3 + ((t_4 * (1 / I3) * t_4 + (t_5 * (1 / I2) * t_5 +
    t_6 * (1 / I1) * t_6)) * v2 + (t_4 * (1 / I3) * t_7 + (t_5 * (1 / I2) * t_8 + t_6 * (1 / I1) *
    t_9)) * v1)) + (t_1 * I3 * t_7 + (t_2 * I2 * t_8 + t_3 * I1 * t_9)) * ((t_7 * (1 / I3) * t_1 +
    (t_8 * (1 / I2) * t_2 + t_9 * (1 / I1) * t_3)) * v3 + ((t_7 * (1 / I3) * t_4 + (t_8 * (1 / I2) *
    t_5 + t_9 * (1 / I1) * t_6)) * v2 + (t_7 * (1 / I3) * t_7 + (t_8 * (1 / I2) * t_8 + t_9 * (1 /
    I1) * t_9)) * v1)) in
  I3 <> 0 ->
  I2 <> 0 ->
  I1 <> 0 ->
  (t_1 * I3 * t_1 + (t_2 * I2 * t_2 + t_3 * I1 * t_3)) * ((t_1 * (1 / I3) * t_1 + (t_2 * (1 / I2) *
    t_2 + t_3 * (1 / I1) * t_3)) * v3 + ((t_1 * (1 / I3) * t_4 + (t_2 * (1 / I2) * t_5 + t_3 * (1 /
    I1) * t_6)) * v2 + (t_1 * (1 / I3) * t_7 + (t_2 * (1 / I2) * t_8 + t_3 * (1 / I1) * t_9)) * v1))
    + t_10 - v3 = 0.
Proof.
  intros I1 I2 I3 v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 D_1 D_2 D_3.
  cut_to t_1 (- (2 * x ^ 2) - 2 * y ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_2 (2 * w * x + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_3 (- (2 * w * y) + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_4 (- (2 * w * x) + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_5 (- (2 * x ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_6 (2 * w * z + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_7 (2 * w * y + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_8 (- (2 * w * z) + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_9 (- (2 * y ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  subst t_10.
  field [H_1]; nonzero.
Qed.

(* With the frozen tensor in its place. *)

(* Frozen, Momentum *)
Theorem right_engine_mutant_1 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := - (w * w) - w * w in
  let t_2 := I2 * ((w * w - w * w) * v2 + t_1 * v1) in
  let t_3 := I1 * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_4 := (w * w + w * w) * v3 in
  let t_5 := I3 * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_7 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_8 := ((- w - w) * t_2 + t_1 * (I2 * ((w + w) * v2 + (- w - w) * v1)) + ((w + w) * t_3 + (w *
    w - w * w) * (I1 * ((w + w) * v2 + (w + w) * v1)))) * ((- (w * t_4)) / 2) + ((w + w) * t_5 +
    (t_1 * (I2 * ((w + w) * v3)) + (w * w - w * w) * (I1 * ((w + w) * v3)))) * ((w * t_6 - w * t_7)
    / 2) in
  let t_9 := t_8 + ((w + w) * t_5 + (t_1 * (I2 * ((w + w) * v3)) + (w * w - w * w) * (I1 * ((- w -
    w) * v3)))) * ((w * t_7 + w * t_6) / 2) + ((- w - w) * t_2 + t_1 * (I2 * ((- (w + w)) * v2 + (-
    w - w) * v1)) + ((- (w + w)) * t_3 + (w * w - w * w) * (I1 * ((w + w) * v2 + (- (w + w)) *
    v1)))) * (w * t_4 / 2) in
  I1 <> 0 /\
  I2 <> 0 /\
  t_9 + (t_1 * (I2 * t_1) + (w * w - w * w) * (I1 * (w * w - w * w))) * (1 / I1 * (I2 * v2 * v3 - I3
    * v3 * v2)) + (t_1 * (I2 * (w * w - w * w)) + (w * w - w * w) * (I1 * (w * w + w * w))) * (1 /
    I2 * (I3 * v3 * v1 - I1 * v1 * v3)) <> 0.
Proof.
  exists 6, (-1), (-7), 4, 5, 3, (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.


(** frozen-tensor: With the tensor frozen in the world (pitfall 1), momentum, its length, energy and Euler's equations all break as soon as the body has turned. *)

(* Frozen, Momentum *)
Theorem frozen_tensor_1 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := - (w * w) - w * w in
  let t_2 := I2 * ((w * w - w * w) * v2 + t_1 * v1) in
  let t_3 := I1 * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_4 := (w * w + w * w) * v3 in
  let t_5 := I3 * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_7 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_8 := ((- w - w) * t_2 + t_1 * (I2 * ((w + w) * v2 + (- w - w) * v1)) + ((w + w) * t_3 + (w *
    w - w * w) * (I1 * ((w + w) * v2 + (w + w) * v1)))) * ((- (w * t_4)) / 2) + ((w + w) * t_5 +
    (t_1 * (I2 * ((w + w) * v3)) + (w * w - w * w) * (I1 * ((w + w) * v3)))) * ((w * t_6 - w * t_7)
    / 2) in
  let t_9 := t_8 + ((w + w) * t_5 + (t_1 * (I2 * ((w + w) * v3)) + (w * w - w * w) * (I1 * ((- w -
    w) * v3)))) * ((w * t_7 + w * t_6) / 2) + ((- w - w) * t_2 + t_1 * (I2 * ((- (w + w)) * v2 + (-
    w - w) * v1)) + ((- (w + w)) * t_3 + (w * w - w * w) * (I1 * ((w + w) * v2 + (- (w + w)) *
    v1)))) * (w * t_4 / 2) in
  I1 <> 0 /\
  I2 <> 0 /\
  t_9 + (t_1 * (I2 * t_1) + (w * w - w * w) * (I1 * (w * w - w * w))) * (1 / I1 * (I2 * v2 * v3 - I3
    * v3 * v2)) + (t_1 * (I2 * (w * w - w * w)) + (w * w - w * w) * (I1 * (w * w + w * w))) * (1 /
    I2 * (I3 * v3 * v1 - I1 * v1 * v3)) <> 0.
Proof.
  exists 6, (-1), (-7), 4, 5, 3, (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* Frozen, LengthOfMomentum *)
Theorem frozen_tensor_2 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := I1 * ((w + w) * v2 + (w + w) * v1) in
  let t_2 := I1 * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_3 := I2 * ((w + w) * v2 + (- w - w) * v1) in
  let t_4 := - (w * w) - w * w in
  let t_5 := I2 * ((w * w - w * w) * v2 + t_4 * v1) in
  let t_6 := I3 * ((w * w + w * w) * v3) in
  let t_7 := (w * w + w * w) * v3 in
  let t_8 := I3 * ((- w - w) * v2 + (w + w) * v1) in
  let t_9 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_10 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_11 := (t_1 * t_2 + t_2 * t_1 + (t_3 * t_5 + t_5 * t_3) + (I3 * ((w + w) * v3) * t_6 + t_6 *
    (I3 * ((w + w) * v3)))) * ((- (w * t_7)) / 2) + (I1 * ((w + w) * v3) * t_2 + t_2 * (I1 * ((w +
    w) * v3)) + (I2 * ((w + w) * v3) * t_5 + t_5 * (I2 * ((w + w) * v3))) + (t_8 * t_6 + t_6 * t_8))
    * ((w * t_9 - w * t_10) / 2) in
  let t_12 := I1 * ((- w - w) * v3) in
  let t_13 := I3 * ((w + w) * v2 + (w + w) * v1) in
  let t_14 := I1 * ((w + w) * v2 + (- (w + w)) * v1) in
  let t_15 := I2 * ((- (w + w)) * v2 + (- w - w) * v1) in
  let t_16 := I1 * (w * w - w * w) in
  let t_17 := t_11 + (t_12 * t_2 + t_2 * t_12 + (I2 * ((w + w) * v3) * t_5 + t_5 * (I2 * ((w + w) *
    v3))) + (t_13 * t_6 + t_6 * t_13)) * ((w * t_10 + w * t_9) / 2) + (t_14 * t_2 + t_2 * t_14 +
    (t_15 * t_5 + t_5 * t_15) + (I3 * ((w + w) * v3) * t_6 + t_6 * (I3 * ((w + w) * v3)))) * (w *
    t_7 / 2) + (t_16 * t_2 + t_2 * t_16 + (I2 * t_4 * t_5 + t_5 * (I2 * t_4))) * (1 / I1 * (I2 * v2
    * v3 - I3 * v3 * v2)) in
  let t_18 := I1 * (w * w + w * w) in
  let t_19 := I2 * (w * w - w * w) in
  let t_20 := I3 * (w * w + w * w) in
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  t_17 + (t_18 * t_2 + t_2 * t_18 + (t_19 * t_5 + t_5 * t_19)) * (1 / I2 * (I3 * v3 * v1 - I1 * v1 *
    v3)) + (t_20 * t_6 + t_6 * t_20) * (1 / I3 * (I1 * v1 * v2 - I2 * v2 * v1)) <> 0.
Proof.
  exists 6, (-1), (-7), 4, 5, 3, (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* Frozen, Energy *)
Theorem frozen_tensor_3 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := (w + w) * v2 + (w + w) * v1 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w + w) * v2 + (- w - w) * v1 in
  let t_4 := - (w * w) - w * w in
  let t_5 := (w * w - w * w) * v2 + t_4 * v1 in
  let t_6 := (w * w + w * w) * v3 in
  let t_7 := (w * w + w * w) * v3 in
  let t_8 := (- w - w) * v2 + (w + w) * v1 in
  let t_9 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_10 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_11 := (t_1 * (I1 * t_2) + t_2 * (I1 * t_1) + (t_3 * (I2 * t_5) + t_5 * (I2 * t_3)) + ((w +
    w) * v3 * (I3 * t_6) + t_6 * (I3 * ((w + w) * v3)))) / 2 * ((- (w * t_7)) / 2) + ((w + w) * v3 *
    (I1 * t_2) + t_2 * (I1 * ((w + w) * v3)) + ((w + w) * v3 * (I2 * t_5) + t_5 * (I2 * ((w + w) *
    v3))) + (t_8 * (I3 * t_6) + t_6 * (I3 * t_8))) / 2 * ((w * t_9 - w * t_10) / 2) in
  let t_12 := (w + w) * v2 + (w + w) * v1 in
  let t_13 := (w + w) * v2 + (- (w + w)) * v1 in
  let t_14 := (- (w + w)) * v2 + (- w - w) * v1 in
  let t_15 := t_11 + ((- w - w) * v3 * (I1 * t_2) + t_2 * (I1 * ((- w - w) * v3)) + ((w + w) * v3 *
    (I2 * t_5) + t_5 * (I2 * ((w + w) * v3))) + (t_12 * (I3 * t_6) + t_6 * (I3 * t_12))) / 2 * ((w *
    t_10 + w * t_9) / 2) + (t_13 * (I1 * t_2) + t_2 * (I1 * t_13) + (t_14 * (I2 * t_5) + t_5 * (I2 *
    t_14)) + ((w + w) * v3 * (I3 * t_6) + t_6 * (I3 * ((w + w) * v3)))) / 2 * (w * t_7 / 2) in
  let t_16 := t_15 + ((w * w - w * w) * (I1 * t_2) + t_2 * (I1 * (w * w - w * w)) + (t_4 * (I2 *
    t_5) + t_5 * (I2 * t_4))) / 2 * (1 / I1 * (I2 * v2 * v3 - I3 * v3 * v2)) + ((w * w + w * w) *
    (I1 * t_2) + t_2 * (I1 * (w * w + w * w)) + ((w * w - w * w) * (I2 * t_5) + t_5 * (I2 * (w * w -
    w * w)))) / 2 * (1 / I2 * (I3 * v3 * v1 - I1 * v1 * v3)) in
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  t_16 + ((w * w + w * w) * (I3 * t_6) + t_6 * (I3 * (w * w + w * w))) / 2 * (1 / I3 * (I1 * v1 * v2
    - I2 * v2 * v1)) <> 0.
Proof.
  exists 6, (-1), (-7), 4, 5, 3, (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* Frozen, Euler *)
Theorem frozen_tensor_4 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := (w * w + w * w) * v3 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_4 := ((w + w) * v2 + (w + w) * v1) * ((- (w * t_1)) / 2) + (w + w) * v3 * ((w * t_2 - w *
    t_3) / 2) + (- w - w) * v3 * ((w * t_3 + w * t_2) / 2) + ((w + w) * v2 + (- (w + w)) * v1) * (w
    * t_1 / 2) + (w * w - w * w) * (1 / I1 * (I2 * v2 * v3 - I3 * v3 * v2)) + (w * w + w * w) * (1 /
    I2 * (I3 * v3 * v1 - I1 * v1 * v3)) in
  let t_5 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_6 := (w * w + w * w) * v3 in
  I1 <> 0 /\
  I2 <> 0 /\
  I1 * t_4 - (I2 * t_5 * t_6 - I3 * t_6 * t_5) <> 0.
Proof.
  exists 6, (-1), (-7), 4, 5, 3, (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* With said to keep the energy. *)

(* Frozen, Energy *)
Theorem frozen_tensor_mutant_1 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := (w + w) * v2 + (w + w) * v1 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w + w) * v2 + (- w - w) * v1 in
  let t_4 := - (w * w) - w * w in
  let t_5 := (w * w - w * w) * v2 + t_4 * v1 in
  let t_6 := (w * w + w * w) * v3 in
  let t_7 := (w * w + w * w) * v3 in
  let t_8 := (- w - w) * v2 + (w + w) * v1 in
  let t_9 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_10 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_11 := (t_1 * (I1 * t_2) + t_2 * (I1 * t_1) + (t_3 * (I2 * t_5) + t_5 * (I2 * t_3)) + ((w +
    w) * v3 * (I3 * t_6) + t_6 * (I3 * ((w + w) * v3)))) / 2 * ((- (w * t_7)) / 2) + ((w + w) * v3 *
    (I1 * t_2) + t_2 * (I1 * ((w + w) * v3)) + ((w + w) * v3 * (I2 * t_5) + t_5 * (I2 * ((w + w) *
    v3))) + (t_8 * (I3 * t_6) + t_6 * (I3 * t_8))) / 2 * ((w * t_9 - w * t_10) / 2) in
  let t_12 := (w + w) * v2 + (w + w) * v1 in
  let t_13 := (w + w) * v2 + (- (w + w)) * v1 in
  let t_14 := (- (w + w)) * v2 + (- w - w) * v1 in
  let t_15 := t_11 + ((- w - w) * v3 * (I1 * t_2) + t_2 * (I1 * ((- w - w) * v3)) + ((w + w) * v3 *
    (I2 * t_5) + t_5 * (I2 * ((w + w) * v3))) + (t_12 * (I3 * t_6) + t_6 * (I3 * t_12))) / 2 * ((w *
    t_10 + w * t_9) / 2) + (t_13 * (I1 * t_2) + t_2 * (I1 * t_13) + (t_14 * (I2 * t_5) + t_5 * (I2 *
    t_14)) + ((w + w) * v3 * (I3 * t_6) + t_6 * (I3 * ((w + w) * v3)))) / 2 * (w * t_7 / 2) in
  let t_16 := t_15 + ((w * w - w * w) * (I1 * t_2) + t_2 * (I1 * (w * w - w * w)) + (t_4 * (I2 *
    t_5) + t_5 * (I2 * t_4))) / 2 * (1 / I1 * (I2 * v2 * v3 - I3 * v3 * v2)) + ((w * w + w * w) *
    (I1 * t_2) + t_2 * (I1 * (w * w + w * w)) + ((w * w - w * w) * (I2 * t_5) + t_5 * (I2 * (w * w -
    w * w)))) / 2 * (1 / I2 * (I3 * v3 * v1 - I1 * v1 * v3)) in
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  t_16 + ((w * w + w * w) * (I3 * t_6) + t_6 * (I3 * (w * w + w * w))) / 2 * (1 / I3 * (I1 * v1 * v2
    - I2 * v2 * v1)) <> 0.
Proof.
  exists 6, (-1), (-7), 4, 5, 3, (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* With the right engine in its place. *)


(** momentum-for-spin: With momentum taken for spin (pitfall 2) energy and the length of momentum stay, but the body's own momentum turns away, is not the one carried, and Euler's equations break. *)

(* MomentumForSpin, Momentum *)
Theorem momentum_for_spin_1 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := v2 * 3 / (I1 + I2 + I3) in
  let t_2 := - (w * w) - w * w in
  let t_3 := v1 * 3 / (I1 + I2 + I3) in
  let t_4 := I2 * ((w * w - w * w) * t_1 + t_2 * t_3) in
  let t_5 := I1 * ((w * w + w * w) * t_1 + (w * w - w * w) * t_3) in
  let t_6 := (- w - w) * t_4 + t_2 * (I2 * ((w + w) * t_1 + (w * w - w * w) * (0 / (I1 + I2 + I3)) +
    ((- w - w) * t_3 + t_2 * (0 / (I1 + I2 + I3))))) + ((w + w) * t_5 + (w * w - w * w) * (I1 * ((w
    + w) * t_1 + (w * w + w * w) * (0 / (I1 + I2 + I3)) + ((w + w) * t_3 + (w * w - w * w) * (0 /
    (I1 + I2 + I3)))))) in
  let t_7 := (w * w + w * w) * (v3 * 3 / (I1 + I2 + I3)) in
  let t_8 := v3 * 3 / (I1 + I2 + I3) in
  let t_9 := I3 * ((w * w + w * w) * t_8) in
  let t_10 := v2 * 3 / (I1 + I2 + I3) in
  let t_11 := v1 * 3 / (I1 + I2 + I3) in
  let t_12 := (w * w + w * w) * t_10 + (w * w - w * w) * t_11 in
  let t_13 := (w * w - w * w) * t_10 + (- (w * w) - w * w) * t_11 in
  let t_14 := t_6 * ((- (w * t_7)) / 2) + ((w + w) * t_9 + (t_2 * (I2 * ((w + w) * t_8 + ((w * w - w
    * w) * (0 / (I1 + I2 + I3)) + t_2 * (0 / (I1 + I2 + I3))))) + (w * w - w * w) * (I1 * ((w + w) *
    t_8 + ((w * w + w * w) * (0 / (I1 + I2 + I3)) + (w * w - w * w) * (0 / (I1 + I2 + I3))))))) *
    ((w * t_12 - w * t_13) / 2) in
  let t_15 := ((w + w) * t_9 + (t_2 * (I2 * ((w + w) * t_8 + ((w * w - w * w) * (0 / (I1 + I2 + I3))
    + t_2 * (0 / (I1 + I2 + I3))))) + (w * w - w * w) * (I1 * ((- w - w) * t_8 + ((w * w + w * w) *
    (0 / (I1 + I2 + I3)) + (w * w - w * w) * (0 / (I1 + I2 + I3))))))) * ((w * t_13 + w * t_12) / 2)
    in
  let t_16 := (- w - w) * t_4 + t_2 * (I2 * ((- (w + w)) * t_1 + (w * w - w * w) * (0 / (I1 + I2 +
    I3)) + ((- w - w) * t_3 + t_2 * (0 / (I1 + I2 + I3))))) + ((- (w + w)) * t_5 + (w * w - w * w) *
    (I1 * ((w + w) * t_1 + (w * w + w * w) * (0 / (I1 + I2 + I3)) + ((- (w + w)) * t_3 + (w * w - w
    * w) * (0 / (I1 + I2 + I3)))))) in
  I1 + I2 + I3 <> 0 /\
  t_14 + t_15 + t_16 * (w * t_7 / 2) <> 0.
Proof.
  exists 4, 4, 6, 4, 5, (-2), (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. enclosed.
Qed.

(* MomentumForSpin, Euler *)
Theorem momentum_for_spin_6 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := v2 * 3 / (I1 + I2 + I3) in
  let t_2 := v1 * 3 / (I1 + I2 + I3) in
  let t_3 := (w * w + w * w) * (v3 * 3 / (I1 + I2 + I3)) in
  let t_4 := v3 * 3 / (I1 + I2 + I3) in
  let t_5 := v2 * 3 / (I1 + I2 + I3) in
  let t_6 := v1 * 3 / (I1 + I2 + I3) in
  let t_7 := (w * w + w * w) * t_5 + (w * w - w * w) * t_6 in
  let t_8 := (w * w - w * w) * t_5 + (- (w * w) - w * w) * t_6 in
  let t_9 := ((w + w) * t_1 + (w * w + w * w) * (0 / (I1 + I2 + I3)) + ((w + w) * t_2 + (w * w - w *
    w) * (0 / (I1 + I2 + I3)))) * ((- (w * t_3)) / 2) + ((w + w) * t_4 + ((w * w + w * w) * (0 / (I1
    + I2 + I3)) + (w * w - w * w) * (0 / (I1 + I2 + I3)))) * ((w * t_7 - w * t_8) / 2) + ((- w - w)
    * t_4 + ((w * w + w * w) * (0 / (I1 + I2 + I3)) + (w * w - w * w) * (0 / (I1 + I2 + I3)))) * ((w
    * t_8 + w * t_7) / 2) in
  let t_10 := (w * w - w * w) * t_1 + (- (w * w) - w * w) * t_2 in
  let t_11 := (w * w + w * w) * t_4 in
  I1 + I2 + I3 <> 0 /\
  I1 * (t_9 + ((w + w) * t_1 + (w * w + w * w) * (0 / (I1 + I2 + I3)) + ((- (w + w)) * t_2 + (w * w
    - w * w) * (0 / (I1 + I2 + I3)))) * (w * t_3 / 2)) - (I2 * t_10 * t_11 - I3 * t_11 * t_10) <> 0.
Proof.
  exists 4, 4, 6, 4, 5, (-2), (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. enclosed.
Qed.

(* MomentumForSpin, SpinFromMomentum *)
Theorem momentum_for_spin_7 :
  exists I1 I2 I3 v1 v2 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := - (w * w) - w * w in
  let t_2 := (w * w - w * w) * I1 in
  I1 + I2 + I3 <> 0 /\
  (t_1 * I2 * (w * w - w * w) + t_2 * (w * w + w * w)) * (v2 * 3 / (I1 + I2 + I3)) + (t_1 * I2 * t_1
    + t_2 * (w * w - w * w)) * (v1 * 3 / (I1 + I2 + I3)) - v1 <> 0.
Proof.
  exists 5, 1, 1, 7, 4, (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. enclosed.
Qed.

(* With said to keep momentum. *)

(* MomentumForSpin, Momentum *)
Theorem momentum_for_spin_mutant_1 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := v2 * 3 / (I1 + I2 + I3) in
  let t_2 := - (w * w) - w * w in
  let t_3 := v1 * 3 / (I1 + I2 + I3) in
  let t_4 := I2 * ((w * w - w * w) * t_1 + t_2 * t_3) in
  let t_5 := I1 * ((w * w + w * w) * t_1 + (w * w - w * w) * t_3) in
  let t_6 := (- w - w) * t_4 + t_2 * (I2 * ((w + w) * t_1 + (w * w - w * w) * (0 / (I1 + I2 + I3)) +
    ((- w - w) * t_3 + t_2 * (0 / (I1 + I2 + I3))))) + ((w + w) * t_5 + (w * w - w * w) * (I1 * ((w
    + w) * t_1 + (w * w + w * w) * (0 / (I1 + I2 + I3)) + ((w + w) * t_3 + (w * w - w * w) * (0 /
    (I1 + I2 + I3)))))) in
  let t_7 := (w * w + w * w) * (v3 * 3 / (I1 + I2 + I3)) in
  let t_8 := v3 * 3 / (I1 + I2 + I3) in
  let t_9 := I3 * ((w * w + w * w) * t_8) in
  let t_10 := v2 * 3 / (I1 + I2 + I3) in
  let t_11 := v1 * 3 / (I1 + I2 + I3) in
  let t_12 := (w * w + w * w) * t_10 + (w * w - w * w) * t_11 in
  let t_13 := (w * w - w * w) * t_10 + (- (w * w) - w * w) * t_11 in
  let t_14 := t_6 * ((- (w * t_7)) / 2) + ((w + w) * t_9 + (t_2 * (I2 * ((w + w) * t_8 + ((w * w - w
    * w) * (0 / (I1 + I2 + I3)) + t_2 * (0 / (I1 + I2 + I3))))) + (w * w - w * w) * (I1 * ((w + w) *
    t_8 + ((w * w + w * w) * (0 / (I1 + I2 + I3)) + (w * w - w * w) * (0 / (I1 + I2 + I3))))))) *
    ((w * t_12 - w * t_13) / 2) in
  let t_15 := ((w + w) * t_9 + (t_2 * (I2 * ((w + w) * t_8 + ((w * w - w * w) * (0 / (I1 + I2 + I3))
    + t_2 * (0 / (I1 + I2 + I3))))) + (w * w - w * w) * (I1 * ((- w - w) * t_8 + ((w * w + w * w) *
    (0 / (I1 + I2 + I3)) + (w * w - w * w) * (0 / (I1 + I2 + I3))))))) * ((w * t_13 + w * t_12) / 2)
    in
  let t_16 := (- w - w) * t_4 + t_2 * (I2 * ((- (w + w)) * t_1 + (w * w - w * w) * (0 / (I1 + I2 +
    I3)) + ((- w - w) * t_3 + t_2 * (0 / (I1 + I2 + I3))))) + ((- (w + w)) * t_5 + (w * w - w * w) *
    (I1 * ((w + w) * t_1 + (w * w + w * w) * (0 / (I1 + I2 + I3)) + ((- (w + w)) * t_3 + (w * w - w
    * w) * (0 / (I1 + I2 + I3)))))) in
  I1 + I2 + I3 <> 0 /\
  t_14 + t_15 + t_16 * (w * t_7 / 2) <> 0.
Proof.
  exists 4, 4, 6, 4, 5, (-2), (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. enclosed.
Qed.

(* With said to break the energy. *)


(** no-gyroscopic-term: With constant spin (pitfall 3) energy and the length of momentum stay, which is why it looks right, but momentum turns with the body and Euler's equations break. *)

(* NoGyroscopicTerm, Momentum *)
Theorem no_gyroscopic_term_1 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := - (w * w) - w * w in
  let t_2 := I2 * ((w * w - w * w) * v2 + t_1 * v1) in
  let t_3 := I1 * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_4 := (w * w + w * w) * v3 in
  let t_5 := I3 * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_7 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_8 := ((- w - w) * t_2 + t_1 * (I2 * ((w + w) * v2 + (- w - w) * v1)) + ((w + w) * t_3 + (w *
    w - w * w) * (I1 * ((w + w) * v2 + (w + w) * v1)))) * ((- (w * t_4)) / 2) + ((w + w) * t_5 +
    (t_1 * (I2 * ((w + w) * v3)) + (w * w - w * w) * (I1 * ((w + w) * v3)))) * ((w * t_6 - w * t_7)
    / 2) in
  let t_9 := t_8 + ((w + w) * t_5 + (t_1 * (I2 * ((w + w) * v3)) + (w * w - w * w) * (I1 * ((- w -
    w) * v3)))) * ((w * t_7 + w * t_6) / 2) + ((- w - w) * t_2 + t_1 * (I2 * ((- (w + w)) * v2 + (-
    w - w) * v1)) + ((- (w + w)) * t_3 + (w * w - w * w) * (I1 * ((w + w) * v2 + (- (w + w)) *
    v1)))) * (w * t_4 / 2) in
  t_9 <> 0.
Proof.
  exists 4, 4, 6, 4, 5, (-2), (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  enclosed.
Qed.

(* NoGyroscopicTerm, LengthOfMomentum *)
Theorem no_gyroscopic_term_2 :
  forall I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := I1 * ((w + w) * v2 + (w + w) * v1) in
  let t_2 := I1 * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_3 := I2 * ((w + w) * v2 + (- w - w) * v1) in
  let t_4 := I2 * ((w * w - w * w) * v2 + (- (w * w) - w * w) * v1) in
  let t_5 := I3 * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v3 in
  let t_7 := I3 * ((- w - w) * v2 + (w + w) * v1) in
  let t_8 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_9 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_10 := (t_1 * t_2 + t_2 * t_1 + (t_3 * t_4 + t_4 * t_3) + (I3 * ((w + w) * v3) * t_5 + t_5 *
    (I3 * ((w + w) * v3)))) * ((- (w * t_6)) / 2) + (I1 * ((w + w) * v3) * t_2 + t_2 * (I1 * ((w +
    w) * v3)) + (I2 * ((w + w) * v3) * t_4 + t_4 * (I2 * ((w + w) * v3))) + (t_7 * t_5 + t_5 * t_7))
    * ((w * t_8 - w * t_9) / 2) in
  let t_11 := I1 * ((- w - w) * v3) in
  let t_12 := I3 * ((w + w) * v2 + (w + w) * v1) in
  let t_13 := I1 * ((w + w) * v2 + (- (w + w)) * v1) in
  let t_14 := I2 * ((- (w + w)) * v2 + (- w - w) * v1) in
  t_10 + (t_11 * t_2 + t_2 * t_11 + (I2 * ((w + w) * v3) * t_4 + t_4 * (I2 * ((w + w) * v3))) +
    (t_12 * t_5 + t_5 * t_12)) * ((w * t_9 + w * t_8) / 2) + (t_13 * t_2 + t_2 * t_13 + (t_14 * t_4
    + t_4 * t_14) + (I3 * ((w + w) * v3) * t_5 + t_5 * (I3 * ((w + w) * v3)))) * (w * t_6 / 2) = 0.
Proof.
  intros I1 I2 I3 v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Energy *)
Theorem no_gyroscopic_term_4 :
  forall I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w + w) * v2 + (w + w) * v1 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w + w) * v2 + (- w - w) * v1 in
  let t_4 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_5 := (w * w + w * w) * v3 in
  let t_6 := (w * w + w * w) * v3 in
  let t_7 := (- w - w) * v2 + (w + w) * v1 in
  let t_8 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_9 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_10 := (t_1 * (I1 * t_2) + t_2 * (I1 * t_1) + (t_3 * (I2 * t_4) + t_4 * (I2 * t_3)) + ((w +
    w) * v3 * (I3 * t_5) + t_5 * (I3 * ((w + w) * v3)))) / 2 * ((- (w * t_6)) / 2) + ((w + w) * v3 *
    (I1 * t_2) + t_2 * (I1 * ((w + w) * v3)) + ((w + w) * v3 * (I2 * t_4) + t_4 * (I2 * ((w + w) *
    v3))) + (t_7 * (I3 * t_5) + t_5 * (I3 * t_7))) / 2 * ((w * t_8 - w * t_9) / 2) in
  let t_11 := (w + w) * v2 + (w + w) * v1 in
  let t_12 := (w + w) * v2 + (- (w + w)) * v1 in
  let t_13 := (- (w + w)) * v2 + (- w - w) * v1 in
  let t_14 := t_10 + ((- w - w) * v3 * (I1 * t_2) + t_2 * (I1 * ((- w - w) * v3)) + ((w + w) * v3 *
    (I2 * t_4) + t_4 * (I2 * ((w + w) * v3))) + (t_11 * (I3 * t_5) + t_5 * (I3 * t_11))) / 2 * ((w *
    t_9 + w * t_8) / 2) + (t_12 * (I1 * t_2) + t_2 * (I1 * t_12) + (t_13 * (I2 * t_4) + t_4 * (I2 *
    t_13)) + ((w + w) * v3 * (I3 * t_5) + t_5 * (I3 * ((w + w) * v3)))) / 2 * (w * t_6 / 2) in
  t_14 = 0.
Proof.
  intros I1 I2 I3 v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Euler *)
Theorem no_gyroscopic_term_6 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := (w * w + w * w) * v3 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_4 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_5 := (w * w + w * w) * v3 in
  I1 * (((w + w) * v2 + (w + w) * v1) * ((- (w * t_1)) / 2) + (w + w) * v3 * ((w * t_2 - w * t_3) /
    2) + (- w - w) * v3 * ((w * t_3 + w * t_2) / 2) + ((w + w) * v2 + (- (w + w)) * v1) * (w * t_1 /
    2)) - (I2 * t_4 * t_5 - I3 * t_5 * t_4) <> 0.
Proof.
  exists 4, 4, 6, 4, 5, (-2), (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  enclosed.
Qed.

(* With said to keep Euler's equations. *)

(* NoGyroscopicTerm, Euler *)
Theorem no_gyroscopic_term_mutant_1 :
  exists I1 I2 I3 v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := (w * w + w * w) * v3 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_4 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_5 := (w * w + w * w) * v3 in
  I1 * (((w + w) * v2 + (w + w) * v1) * ((- (w * t_1)) / 2) + (w + w) * v3 * ((w * t_2 - w * t_3) /
    2) + (- w - w) * v3 * ((w * t_3 + w * t_2) / 2) + ((w + w) * v2 + (- (w + w)) * v1) * (w * t_1 /
    2)) - (I2 * t_4 * t_5 - I3 * t_5 * t_4) <> 0.
Proof.
  exists 4, 4, 6, 4, 5, (-2), (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  enclosed.
Qed.


(** wrong-engines-are-right-for-a-ball: For a body with three equal moments every engine, right or wrong, keeps every law. *)

(* Turned, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_2 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * (1 / I) in
  let t_2 := t_1 * (w * w + w * w) * v3 in
  let t_3 := I * ((w * w + w * w) * t_2) in
  let t_4 := (w * w + w * w) * ((w * w + w * w) * (1 / I) * (w * w + w * w) * v3) in
  let t_5 := - (w * w) - w * w in
  let t_6 := (w * w + w * w) * ((w * w + w * w) * (0 / I) * (w * w + w * w) * v3 + ((t_1 * (- w - w)
    + ((w + w) * (1 / I) * (w * w - w * w) + (w + w) * (1 / I) * (w * w + w * w))) * v2 + (t_1 * (w
    + w) + ((w + w) * (1 / I) * t_5 + (w + w) * (1 / I) * (w * w - w * w))) * v1)) in
  let t_7 := (w * w - w * w) * (1 / I) in
  let t_8 := (w * w + w * w) * (1 / I) in
  let t_9 := (t_7 * (w * w - w * w) + t_8 * (w * w + w * w)) * v2 + (t_7 * t_5 + t_8 * (w * w - w *
    w)) * v1 in
  let t_10 := (w * w - w * w) * (1 / I) in
  let t_11 := (t_5 * (1 / I) * (w * w - w * w) + t_10 * (w * w + w * w)) * v2 + (t_5 * (1 / I) * t_5
    + t_10 * (w * w - w * w)) * v1 in
  let t_12 := I * ((w * w - w * w) * t_9 + t_5 * t_11) in
  let t_13 := I * ((w * w + w * w) * t_9 + (w * w - w * w) * t_11) in
  let t_14 := (w * w - w * w) * (1 / I) in
  let t_15 := (w * w + w * w) * (1 / I) in
  let t_16 := - (w * w) - w * w in
  let t_17 := (t_14 * (w * w - w * w) + t_15 * (w * w + w * w)) * v2 + (t_14 * t_16 + t_15 * (w * w
    - w * w)) * v1 in
  let t_18 := (w * w - w * w) * (1 / I) in
  let t_19 := (t_16 * (1 / I) * (w * w - w * w) + t_18 * (w * w + w * w)) * v2 + (t_16 * (1 / I) *
    t_16 + t_18 * (w * w - w * w)) * v1 in
  let t_20 := (w * w + w * w) * t_17 + (w * w - w * w) * t_19 in
  let t_21 := (w * w - w * w) * t_17 + t_16 * t_19 in
  let t_22 := ((w + w) * t_3 + (w * w + w * w) * (I * ((w + w) * t_2 + (w * w + w * w) * ((((w + w)
    * (1 / I) + (w * w + w * w) * (0 / I)) * (w * w + w * w) + t_1 * (w + w)) * v3)))) * ((- (w *
    t_4)) / 2) + ((w * w + w * w) * (I * (t_6 + ((- w - w) * t_9 + (w + w) * t_11))) + ((w + w) *
    t_12 + (w + w) * t_13)) * ((w * t_20 - w * t_21) / 2) in
  let t_23 := (- w - w) * (1 / I) in
  let t_24 := (w * w + w * w) * ((w * w + w * w) * (0 / I) * (w * w + w * w) * v3 + ((t_1 * (w + w)
    + ((w + w) * (1 / I) * (w * w - w * w) + t_23 * (w * w + w * w))) * v2 + (t_1 * (w + w) + ((w +
    w) * (1 / I) * t_5 + t_23 * (w * w - w * w))) * v1)) + ((w + w) * t_9 + (w + w) * t_11) in
  let t_25 := t_22 + ((w * w + w * w) * (I * t_24) + ((w + w) * t_12 + (- w - w) * t_13)) * ((w *
    t_21 + w * t_20) / 2) + ((w + w) * t_3 + (w * w + w * w) * (I * ((w + w) * t_2 + (w * w + w * w)
    * ((((w + w) * (1 / I) + (w * w + w * w) * (0 / I)) * (w * w + w * w) + t_1 * (w + w)) * v3))))
    * (w * t_4 / 2) in
  I <> 0 ->
  t_25 = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 D_1.
  cut_to t_1 ((1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_2 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_3 (v3) ltac:(field [H_1]; nonzero).
  cut_to t_4 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_5 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_6 (0) ltac:(field [H_1]; nonzero).
  cut_to t_7 (0) ltac:(field [H_1]; nonzero).
  cut_to t_8 ((1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_9 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_10 (0) ltac:(field [H_1]; nonzero).
  cut_to t_11 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_12 (- v1) ltac:(field [H_1]; nonzero).
  cut_to t_13 (v2) ltac:(field [H_1]; nonzero).
  cut_to t_14 (0) ltac:(field [H_1]; nonzero).
  cut_to t_15 ((1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_16 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_17 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_18 (0) ltac:(field [H_1]; nonzero).
  cut_to t_19 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_20 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_21 ((- v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_22 ((- (2 * v3 ^ 2)) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_23 ((- (2 * w)) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_24 ((2 * v1 * w + 2 * v2 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_25 (0) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* Turned, Euler *)
Theorem wrong_engines_are_right_for_a_ball_10 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * (1 / I) in
  let t_2 := t_1 * (w * w + w * w) * v3 in
  let t_3 := (w * w + w * w) * ((w * w + w * w) * (1 / I) * (w * w + w * w) * v3) in
  let t_4 := - (w * w) - w * w in
  let t_5 := (w * w + w * w) * ((w * w + w * w) * (0 / I) * (w * w + w * w) * v3 + ((t_1 * (- w - w)
    + ((w + w) * (1 / I) * (w * w - w * w) + (w + w) * (1 / I) * (w * w + w * w))) * v2 + (t_1 * (w
    + w) + ((w + w) * (1 / I) * t_4 + (w + w) * (1 / I) * (w * w - w * w))) * v1)) in
  let t_6 := (w * w - w * w) * (1 / I) in
  let t_7 := (w * w + w * w) * (1 / I) in
  let t_8 := (t_6 * (w * w - w * w) + t_7 * (w * w + w * w)) * v2 + (t_6 * t_4 + t_7 * (w * w - w *
    w)) * v1 in
  let t_9 := (w * w - w * w) * (1 / I) in
  let t_10 := (t_4 * (1 / I) * (w * w - w * w) + t_9 * (w * w + w * w)) * v2 + (t_4 * (1 / I) * t_4
    + t_9 * (w * w - w * w)) * v1 in
  let t_11 := (w * w - w * w) * (1 / I) in
  let t_12 := (w * w + w * w) * (1 / I) in
  let t_13 := - (w * w) - w * w in
  let t_14 := (t_11 * (w * w - w * w) + t_12 * (w * w + w * w)) * v2 + (t_11 * t_13 + t_12 * (w * w
    - w * w)) * v1 in
  let t_15 := (w * w - w * w) * (1 / I) in
  let t_16 := (t_13 * (1 / I) * (w * w - w * w) + t_15 * (w * w + w * w)) * v2 + (t_13 * (1 / I) *
    t_13 + t_15 * (w * w - w * w)) * v1 in
  let t_17 := (w * w + w * w) * t_14 + (w * w - w * w) * t_16 in
  let t_18 := (w * w - w * w) * t_14 + t_13 * t_16 in
  let t_19 := (- w - w) * (1 / I) in
  let t_20 := (w * w + w * w) * ((w * w + w * w) * (0 / I) * (w * w + w * w) * v3 + ((t_1 * (w + w)
    + ((w + w) * (1 / I) * (w * w - w * w) + t_19 * (w * w + w * w))) * v2 + (t_1 * (w + w) + ((w +
    w) * (1 / I) * t_4 + t_19 * (w * w - w * w))) * v1)) + ((w + w) * t_8 + (w + w) * t_10) in
  let t_21 := ((w + w) * t_2 + (w * w + w * w) * ((((w + w) * (1 / I) + (w * w + w * w) * (0 / I)) *
    (w * w + w * w) + t_1 * (w + w)) * v3)) * ((- (w * t_3)) / 2) + (t_5 + ((- w - w) * t_8 + (w +
    w) * t_10)) * ((w * t_17 - w * t_18) / 2) + t_20 * ((w * t_18 + w * t_17) / 2) + ((w + w) * t_2
    + (w * w + w * w) * ((((w + w) * (1 / I) + (w * w + w * w) * (0 / I)) * (w * w + w * w) + t_1 *
    (w + w)) * v3)) * (w * t_3 / 2) in
  let t_22 := (w * w + w * w) * t_8 + (w * w - w * w) * t_10 in
  let t_23 := (w * w - w * w) * t_8 + t_4 * t_10 in
  I <> 0 ->
  I * t_21 - (I * t_22 * t_23 - I * t_23 * t_22) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 D_1.
  cut_to t_1 ((1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_2 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_3 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_4 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_5 (0) ltac:(field [H_1]; nonzero).
  cut_to t_6 (0) ltac:(field [H_1]; nonzero).
  cut_to t_7 ((1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_8 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_9 (0) ltac:(field [H_1]; nonzero).
  cut_to t_10 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_11 (0) ltac:(field [H_1]; nonzero).
  cut_to t_12 ((1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_13 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_14 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_15 (0) ltac:(field [H_1]; nonzero).
  cut_to t_16 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_17 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_18 ((- v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_19 ((- (2 * w)) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_20 ((2 * v1 * w + 2 * v2 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_21 (0) ltac:(field [H_1]; nonzero).
  cut_to t_22 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_23 ((- v1) / (I)) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum *)
Theorem wrong_engines_are_right_for_a_ball_14 :
  forall I v1 v2 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := - (w * w) - w * w in
  let t_2 := (w * w - w * w) * I in
  let t_3 := (w * w - w * w) * (1 / I) in
  let t_4 := (w * w + w * w) * (1 / I) in
  let t_5 := (w * w - w * w) * (1 / I) in
  let t_6 := (t_1 * I * (w * w - w * w) + t_2 * (w * w + w * w)) * ((t_3 * (w * w - w * w) + t_4 *
    (w * w + w * w)) * v2 + (t_3 * t_1 + t_4 * (w * w - w * w)) * v1) + (t_1 * I * t_1 + t_2 * (w *
    w - w * w)) * ((t_1 * (1 / I) * (w * w - w * w) + t_5 * (w * w + w * w)) * v2 + (t_1 * (1 / I) *
    t_1 + t_5 * (w * w - w * w)) * v1) in
  I <> 0 ->
  t_6 - v1 = 0.
Proof.
  intros I v1 v2 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum *)
Theorem wrong_engines_are_right_for_a_ball_15 :
  forall I v1 v2 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w - w * w) * I in
  let t_2 := (w * w + w * w) * I in
  let t_3 := (w * w - w * w) * (1 / I) in
  let t_4 := (w * w + w * w) * (1 / I) in
  let t_5 := - (w * w) - w * w in
  let t_6 := (w * w - w * w) * (1 / I) in
  let t_7 := (t_1 * (w * w - w * w) + t_2 * (w * w + w * w)) * ((t_3 * (w * w - w * w) + t_4 * (w *
    w + w * w)) * v2 + (t_3 * t_5 + t_4 * (w * w - w * w)) * v1) + (t_1 * t_5 + t_2 * (w * w - w *
    w)) * ((t_5 * (1 / I) * (w * w - w * w) + t_6 * (w * w + w * w)) * v2 + (t_5 * (1 / I) * t_5 +
    t_6 * (w * w - w * w)) * v1) in
  I <> 0 ->
  t_7 - v2 = 0.
Proof.
  intros I v1 v2 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum *)
Theorem wrong_engines_are_right_for_a_ball_16 :
  forall I v3 w : R,
  w ^ 2 = (1 / 2) ->
  I <> 0 ->
  (w * w + w * w) * I * (w * w + w * w) * ((w * w + w * w) * (1 / I) * (w * w + w * w) * v3) - v3 =
    0.
Proof.
  intros I v3 w H_1  D_1.
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum, x *)
Theorem wrong_engines_are_right_for_a_ball_17 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := w * w - x * x - y * y + z * z in
  let t_3 := x * y - w * z + (x * y - w * z) in
  let t_4 := y * z + w * x + (y * z + w * x) in
  let t_5 := w * w + x * x - y * y - z * z in
  let t_6 := x * z - w * y + (x * z - w * y) in
  let t_7 := y * z - w * x + (y * z - w * x) in
  let t_8 := w * w - x * x + y * y - z * z in
  let t_9 := x * y + w * z + (x * y + w * z) in
  let t_10 := (t_1 * I * t_7 + (t_3 * I * t_8 + t_5 * I * t_9)) * ((t_7 * (1 / I) * t_2 + (t_8 * (1
    / I) * t_4 + t_9 * (1 / I) * t_6)) * v3 + ((t_7 * (1 / I) * t_7 + (t_8 * (1 / I) * t_8 + t_9 *
    (1 / I) * t_9)) * v2 + (t_7 * (1 / I) * t_1 + (t_8 * (1 / I) * t_3 + t_9 * (1 / I) * t_5)) *
    v1)) + (t_1 * I * t_1 + (t_3 * I * t_3 + t_5 * I * t_5)) * ((t_1 * (1 / I) * t_2 + (t_3 * (1 /
    I) * t_4 + t_5 * (1 / I) * t_6)) * v3 + ((t_1 * (1 / I) * t_7 + (t_3 * (1 / I) * t_8 + t_5 * (1
    / I) * t_9)) * v2 + (t_1 * (1 / I) * t_1 + (t_3 * (1 / I) * t_3 + t_5 * (1 / I) * t_5)) * v1))
    in
  I <> 0 ->
  (t_1 * I * t_2 + (t_3 * I * t_4 + t_5 * I * t_6)) * ((t_2 * (1 / I) * t_2 + (t_4 * (1 / I) * t_4 +
    t_6 * (1 / I) * t_6)) * v3 + ((t_2 * (1 / I) * t_7 + (t_4 * (1 / I) * t_8 + t_6 * (1 / I) *
    t_9)) * v2 + (t_2 * (1 / I) * t_1 + (t_4 * (1 / I) * t_3 + t_6 * (1 / I) * t_5)) * v1)) + t_10 -
    v1 = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 D_1.
  cut_to t_1 (2 * w * y + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_2 (- (2 * x ^ 2) - 2 * y ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_3 (- (2 * w * z) + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_4 (2 * w * x + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_5 (- (2 * y ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_6 (- (2 * w * y) + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_7 (- (2 * w * x) + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_8 (- (2 * x ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_9 (2 * w * z + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_10 (v1) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum, y *)
Theorem wrong_engines_are_right_for_a_ball_18 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x - y * y + z * z in
  let t_3 := w * w - x * x + y * y - z * z in
  let t_4 := y * z + w * x + (y * z + w * x) in
  let t_5 := x * y + w * z + (x * y + w * z) in
  let t_6 := x * z - w * y + (x * z - w * y) in
  let t_7 := x * z + w * y + (x * z + w * y) in
  let t_8 := x * y - w * z + (x * y - w * z) in
  let t_9 := w * w + x * x - y * y - z * z in
  let t_10 := (t_1 * I * t_1 + (t_3 * I * t_3 + t_5 * I * t_5)) * ((t_1 * (1 / I) * t_2 + (t_3 * (1
    / I) * t_4 + t_5 * (1 / I) * t_6)) * v3 + ((t_1 * (1 / I) * t_1 + (t_3 * (1 / I) * t_3 + t_5 *
    (1 / I) * t_5)) * v2 + (t_1 * (1 / I) * t_7 + (t_3 * (1 / I) * t_8 + t_5 * (1 / I) * t_9)) *
    v1)) + (t_1 * I * t_7 + (t_3 * I * t_8 + t_5 * I * t_9)) * ((t_7 * (1 / I) * t_2 + (t_8 * (1 /
    I) * t_4 + t_9 * (1 / I) * t_6)) * v3 + ((t_7 * (1 / I) * t_1 + (t_8 * (1 / I) * t_3 + t_9 * (1
    / I) * t_5)) * v2 + (t_7 * (1 / I) * t_7 + (t_8 * (1 / I) * t_8 + t_9 * (1 / I) * t_9)) * v1))
    in
  I <> 0 ->
  (t_1 * I * t_2 + (t_3 * I * t_4 + t_5 * I * t_6)) * ((t_2 * (1 / I) * t_2 + (t_4 * (1 / I) * t_4 +
    t_6 * (1 / I) * t_6)) * v3 + ((t_2 * (1 / I) * t_1 + (t_4 * (1 / I) * t_3 + t_6 * (1 / I) *
    t_5)) * v2 + (t_2 * (1 / I) * t_7 + (t_4 * (1 / I) * t_8 + t_6 * (1 / I) * t_9)) * v1)) + t_10 -
    v2 = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 D_1.
  cut_to t_1 (- (2 * w * x) + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_2 (- (2 * x ^ 2) - 2 * y ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_3 (- (2 * x ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_4 (2 * w * x + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_5 (2 * w * z + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_6 (- (2 * w * y) + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_7 (2 * w * y + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_8 (- (2 * w * z) + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_9 (- (2 * y ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_10 (v2) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* Turned, SpinFromMomentum, z *)
Theorem wrong_engines_are_right_for_a_ball_19 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := y * z - w * x + (y * z - w * x) in
  let t_5 := w * w - x * x + y * y - z * z in
  let t_6 := x * y + w * z + (x * y + w * z) in
  let t_7 := x * z + w * y + (x * z + w * y) in
  let t_8 := x * y - w * z + (x * y - w * z) in
  let t_9 := w * w + x * x - y * y - z * z in
  let t_10 := (t_1 * I * t_4 + (t_2 * I * t_5 + t_3 * I * t_6)) * ((t_4 * (1 / I) * t_1 + (t_5 * (1
    / I) * t_2 + t_6 * (1 / I) * t_3)) * v3 + ((t_4 * (1 / I) * t_4 + (t_5 * (1 / I) * t_5 + t_6 *
    (1 / I) * t_6)) * v2 + (t_4 * (1 / I) * t_7 + (t_5 * (1 / I) * t_8 + t_6 * (1 / I) * t_9)) *
    v1)) + (t_1 * I * t_7 + (t_2 * I * t_8 + t_3 * I * t_9)) * ((t_7 * (1 / I) * t_1 + (t_8 * (1 /
    I) * t_2 + t_9 * (1 / I) * t_3)) * v3 + ((t_7 * (1 / I) * t_4 + (t_8 * (1 / I) * t_5 + t_9 * (1
    / I) * t_6)) * v2 + (t_7 * (1 / I) * t_7 + (t_8 * (1 / I) * t_8 + t_9 * (1 / I) * t_9)) * v1))
    in
  I <> 0 ->
  (t_1 * I * t_1 + (t_2 * I * t_2 + t_3 * I * t_3)) * ((t_1 * (1 / I) * t_1 + (t_2 * (1 / I) * t_2 +
    t_3 * (1 / I) * t_3)) * v3 + ((t_1 * (1 / I) * t_4 + (t_2 * (1 / I) * t_5 + t_3 * (1 / I) *
    t_6)) * v2 + (t_1 * (1 / I) * t_7 + (t_2 * (1 / I) * t_8 + t_3 * (1 / I) * t_9)) * v1)) + t_10 -
    v3 = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 D_1.
  cut_to t_1 (- (2 * x ^ 2) - 2 * y ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_2 (2 * w * x + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_3 (- (2 * w * y) + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_4 (- (2 * w * x) + 2 * y * z) ltac:(field [H_1]; nonzero).
  cut_to t_5 (- (2 * x ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_6 (2 * w * z + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_7 (2 * w * y + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_8 (- (2 * w * z) + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_9 (- (2 * y ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_10 (0) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* Frozen, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_20 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := - (w * w) - w * w in
  let t_2 := I * ((w * w - w * w) * v2 + t_1 * v1) in
  let t_3 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_4 := (w * w + w * w) * v3 in
  let t_5 := I * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_7 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_8 := ((- w - w) * t_2 + t_1 * (I * ((w + w) * v2 + (- w - w) * v1)) + ((w + w) * t_3 + (w *
    w - w * w) * (I * ((w + w) * v2 + (w + w) * v1)))) * ((- (w * t_4)) / 2) + ((w + w) * t_5 + (t_1
    * (I * ((w + w) * v3)) + (w * w - w * w) * (I * ((w + w) * v3)))) * ((w * t_6 - w * t_7) / 2) in
  let t_9 := t_8 + ((w + w) * t_5 + (t_1 * (I * ((w + w) * v3)) + (w * w - w * w) * (I * ((- w - w)
    * v3)))) * ((w * t_7 + w * t_6) / 2) + ((- w - w) * t_2 + t_1 * (I * ((- (w + w)) * v2 + (- w -
    w) * v1)) + ((- (w + w)) * t_3 + (w * w - w * w) * (I * ((w + w) * v2 + (- (w + w)) * v1)))) *
    (w * t_4 / 2) in
  I <> 0 ->
  t_9 + (t_1 * (I * t_1) + (w * w - w * w) * (I * (w * w - w * w))) * (1 / I * (I * v2 * v3 - I * v3
    * v2)) + (t_1 * (I * (w * w - w * w)) + (w * w - w * w) * (I * (w * w + w * w))) * (1 / I * (I *
    v3 * v1 - I * v1 * v3)) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Frozen, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_21 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := - (w * w) - w * w in
  let t_2 := I * ((w * w - w * w) * v2 + t_1 * v1) in
  let t_3 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_4 := (w * w + w * w) * v3 in
  let t_5 := I * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_7 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_8 := ((w + w) * t_2 + (w * w - w * w) * (I * ((w + w) * v2 + (- w - w) * v1)) + ((w + w) *
    t_3 + (w * w + w * w) * (I * ((w + w) * v2 + (w + w) * v1)))) * ((- (w * t_4)) / 2) + ((- w - w)
    * t_5 + ((w * w - w * w) * (I * ((w + w) * v3)) + (w * w + w * w) * (I * ((w + w) * v3)))) * ((w
    * t_6 - w * t_7) / 2) in
  let t_9 := t_8 + ((w + w) * t_5 + ((w * w - w * w) * (I * ((w + w) * v3)) + (w * w + w * w) * (I *
    ((- w - w) * v3)))) * ((w * t_7 + w * t_6) / 2) + ((- (w + w)) * t_2 + (w * w - w * w) * (I *
    ((- (w + w)) * v2 + (- w - w) * v1)) + ((w + w) * t_3 + (w * w + w * w) * (I * ((w + w) * v2 +
    (- (w + w)) * v1)))) * (w * t_4 / 2) in
  I <> 0 ->
  t_9 + ((w * w - w * w) * (I * t_1) + (w * w + w * w) * (I * (w * w - w * w))) * (1 / I * (I * v2 *
    v3 - I * v3 * v2)) + ((w * w - w * w) * (I * (w * w - w * w)) + (w * w + w * w) * (I * (w * w +
    w * w))) * (1 / I * (I * v3 * v1 - I * v1 * v3)) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Frozen, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_22 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := I * ((w * w + w * w) * v3) in
  let t_2 := (w * w + w * w) * v3 in
  let t_3 := I * ((w * w - w * w) * v2 + (- (w * w) - w * w) * v1) in
  let t_4 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_5 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_6 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_7 := ((w + w) * t_1 + (w * w + w * w) * (I * ((w + w) * v3))) * ((- (w * t_2)) / 2) + ((w *
    w + w * w) * (I * ((- w - w) * v2 + (w + w) * v1)) + ((w + w) * t_3 + (w + w) * t_4)) * ((w *
    t_5 - w * t_6) / 2) + ((w * w + w * w) * (I * ((w + w) * v2 + (w + w) * v1)) + ((w + w) * t_3 +
    (- w - w) * t_4)) * ((w * t_6 + w * t_5) / 2) in
  I <> 0 ->
  t_7 + ((w + w) * t_1 + (w * w + w * w) * (I * ((w + w) * v3))) * (w * t_2 / 2) + (w * w + w * w) *
    (I * (w * w + w * w)) * (1 / I * (I * v1 * v2 - I * v2 * v1)) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Frozen, LengthOfMomentum *)
Theorem wrong_engines_are_right_for_a_ball_24 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := I * ((w + w) * v2 + (w + w) * v1) in
  let t_2 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_3 := I * ((w + w) * v2 + (- w - w) * v1) in
  let t_4 := - (w * w) - w * w in
  let t_5 := I * ((w * w - w * w) * v2 + t_4 * v1) in
  let t_6 := I * ((w * w + w * w) * v3) in
  let t_7 := (w * w + w * w) * v3 in
  let t_8 := I * ((- w - w) * v2 + (w + w) * v1) in
  let t_9 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_10 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_11 := (t_1 * t_2 + t_2 * t_1 + (t_3 * t_5 + t_5 * t_3) + (I * ((w + w) * v3) * t_6 + t_6 *
    (I * ((w + w) * v3)))) * ((- (w * t_7)) / 2) + (I * ((w + w) * v3) * t_2 + t_2 * (I * ((w + w) *
    v3)) + (I * ((w + w) * v3) * t_5 + t_5 * (I * ((w + w) * v3))) + (t_8 * t_6 + t_6 * t_8)) * ((w
    * t_9 - w * t_10) / 2) in
  let t_12 := I * ((- w - w) * v3) in
  let t_13 := I * ((w + w) * v2 + (w + w) * v1) in
  let t_14 := I * ((w + w) * v2 + (- (w + w)) * v1) in
  let t_15 := I * ((- (w + w)) * v2 + (- w - w) * v1) in
  let t_16 := I * (w * w - w * w) in
  let t_17 := t_11 + (t_12 * t_2 + t_2 * t_12 + (I * ((w + w) * v3) * t_5 + t_5 * (I * ((w + w) *
    v3))) + (t_13 * t_6 + t_6 * t_13)) * ((w * t_10 + w * t_9) / 2) + (t_14 * t_2 + t_2 * t_14 +
    (t_15 * t_5 + t_5 * t_15) + (I * ((w + w) * v3) * t_6 + t_6 * (I * ((w + w) * v3)))) * (w * t_7
    / 2) + (t_16 * t_2 + t_2 * t_16 + (I * t_4 * t_5 + t_5 * (I * t_4))) * (1 / I * (I * v2 * v3 - I
    * v3 * v2)) in
  let t_18 := I * (w * w + w * w) in
  let t_19 := I * (w * w - w * w) in
  let t_20 := I * (w * w + w * w) in
  I <> 0 ->
  t_17 + (t_18 * t_2 + t_2 * t_18 + (t_19 * t_5 + t_5 * t_19)) * (1 / I * (I * v3 * v1 - I * v1 *
    v3)) + (t_20 * t_6 + t_6 * t_20) * (1 / I * (I * v1 * v2 - I * v2 * v1)) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 D_1.
  cut_to t_1 (2 * I * v1 * w + 2 * I * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_2 (I * v2) ltac:(field [H_1]; nonzero).
  cut_to t_3 (- (2 * I * v1 * w) + 2 * I * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_4 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_5 (- (I * v1)) ltac:(field [H_1]; nonzero).
  cut_to t_6 (I * v3) ltac:(field [H_1]; nonzero).
  cut_to t_7 (v3) ltac:(field [H_1]; nonzero).
  cut_to t_8 (2 * I * v1 * w - 2 * I * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_9 (v2) ltac:(field [H_1]; nonzero).
  cut_to t_10 (- v1) ltac:(field [H_1]; nonzero).
  cut_to t_11 (- (I ^ 2 * v1 ^ 2 * v3) - I ^ 2 * v2 ^ 2 * v3 - I ^ 2 * v3 ^ 3) ltac:(field [H_1];
    nonzero).
  cut_to t_12 (- (2 * I * v3 * w)) ltac:(field [H_1]; nonzero).
  cut_to t_13 (2 * I * v1 * w + 2 * I * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_14 (- (2 * I * v1 * w) + 2 * I * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_15 (- (2 * I * v1 * w) - 2 * I * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_16 (0) ltac:(field [H_1]; nonzero).
  cut_to t_17 (0) ltac:(field [H_1]; nonzero).
  cut_to t_18 (I) ltac:(field [H_1]; nonzero).
  cut_to t_19 (0) ltac:(field [H_1]; nonzero).
  cut_to t_20 (I) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* Frozen, Energy *)
Theorem wrong_engines_are_right_for_a_ball_26 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w + w) * v2 + (w + w) * v1 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w + w) * v2 + (- w - w) * v1 in
  let t_4 := - (w * w) - w * w in
  let t_5 := (w * w - w * w) * v2 + t_4 * v1 in
  let t_6 := (w * w + w * w) * v3 in
  let t_7 := (w * w + w * w) * v3 in
  let t_8 := (- w - w) * v2 + (w + w) * v1 in
  let t_9 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_10 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_11 := (t_1 * (I * t_2) + t_2 * (I * t_1) + (t_3 * (I * t_5) + t_5 * (I * t_3)) + ((w + w) *
    v3 * (I * t_6) + t_6 * (I * ((w + w) * v3)))) / 2 * ((- (w * t_7)) / 2) + ((w + w) * v3 * (I *
    t_2) + t_2 * (I * ((w + w) * v3)) + ((w + w) * v3 * (I * t_5) + t_5 * (I * ((w + w) * v3))) +
    (t_8 * (I * t_6) + t_6 * (I * t_8))) / 2 * ((w * t_9 - w * t_10) / 2) in
  let t_12 := (w + w) * v2 + (w + w) * v1 in
  let t_13 := (w + w) * v2 + (- (w + w)) * v1 in
  let t_14 := (- (w + w)) * v2 + (- w - w) * v1 in
  let t_15 := t_11 + ((- w - w) * v3 * (I * t_2) + t_2 * (I * ((- w - w) * v3)) + ((w + w) * v3 * (I
    * t_5) + t_5 * (I * ((w + w) * v3))) + (t_12 * (I * t_6) + t_6 * (I * t_12))) / 2 * ((w * t_10 +
    w * t_9) / 2) + (t_13 * (I * t_2) + t_2 * (I * t_13) + (t_14 * (I * t_5) + t_5 * (I * t_14)) +
    ((w + w) * v3 * (I * t_6) + t_6 * (I * ((w + w) * v3)))) / 2 * (w * t_7 / 2) in
  let t_16 := t_15 + ((w * w - w * w) * (I * t_2) + t_2 * (I * (w * w - w * w)) + (t_4 * (I * t_5) +
    t_5 * (I * t_4))) / 2 * (1 / I * (I * v2 * v3 - I * v3 * v2)) + ((w * w + w * w) * (I * t_2) +
    t_2 * (I * (w * w + w * w)) + ((w * w - w * w) * (I * t_5) + t_5 * (I * (w * w - w * w)))) / 2 *
    (1 / I * (I * v3 * v1 - I * v1 * v3)) in
  I <> 0 ->
  t_16 + ((w * w + w * w) * (I * t_6) + t_6 * (I * (w * w + w * w))) / 2 * (1 / I * (I * v1 * v2 - I
    * v2 * v1)) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Frozen, Euler *)
Theorem wrong_engines_are_right_for_a_ball_28 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * v3 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_4 := ((w + w) * v2 + (w + w) * v1) * ((- (w * t_1)) / 2) + (w + w) * v3 * ((w * t_2 - w *
    t_3) / 2) + (- w - w) * v3 * ((w * t_3 + w * t_2) / 2) + ((w + w) * v2 + (- (w + w)) * v1) * (w
    * t_1 / 2) + (w * w - w * w) * (1 / I * (I * v2 * v3 - I * v3 * v2)) + (w * w + w * w) * (1 / I
    * (I * v3 * v1 - I * v1 * v3)) in
  let t_5 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_6 := (w * w + w * w) * v3 in
  I <> 0 ->
  I * t_4 - (I * t_5 * t_6 - I * t_6 * t_5) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Frozen, Euler *)
Theorem wrong_engines_are_right_for_a_ball_29 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * v3 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_4 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_5 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_6 := I * ((w + w) * v3 * ((- (w * t_1)) / 2) + ((- w - w) * v2 + (w + w) * v1) * ((w * t_2 -
    w * t_3) / 2) + ((w + w) * v2 + (w + w) * v1) * ((w * t_3 + w * t_2) / 2) + (w + w) * v3 * (w *
    t_1 / 2) + (w * w + w * w) * (1 / I * (I * v1 * v2 - I * v2 * v1))) - (I * t_4 * t_5 - I * t_5 *
    t_4) in
  I <> 0 ->
  t_6 = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Frozen, Euler, x *)
Theorem wrong_engines_are_right_for_a_ball_30 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := (x * z - w * y + (x * z - w * y)) * v3 + ((x * y + w * z + (x * y + w * z)) * v2 + (w *
    w + x * x - y * y - z * z) * v1) in
  let t_2 := (y * z + w * x + (y * z + w * x)) * v3 + ((w * w - x * x + y * y - z * z) * v2 + (x * y
    - w * z + (x * y - w * z)) * v1) in
  let t_3 := (w * w - x * x - y * y + z * z) * v3 + ((y * z - w * x + (y * z - w * x)) * v2 + (x * z
    + w * y + (x * z + w * y)) * v1) in
  let t_4 := ((- y - y) * v3 + ((z + z) * v2 + (w + w) * v1)) * ((- (x * t_1) - y * t_2 - z * t_3) /
    2) + ((z + z) * v3 + ((y + y) * v2 + (x + x) * v1)) * ((w * t_1 + y * t_3 - z * t_2) / 2) + ((-
    w - w) * v3 + ((x + x) * v2 + (- (y + y)) * v1)) * ((w * t_2 - x * t_3 + z * t_1) / 2) + ((x +
    x) * v3 + ((w + w) * v2 + (- (z + z)) * v1)) * ((w * t_3 + x * t_2 - y * t_1) / 2) in
  let t_5 := (y * z + w * x + (y * z + w * x)) * v3 + ((w * w - x * x + y * y - z * z) * v2 + (x * y
    - w * z + (x * y - w * z)) * v1) in
  let t_6 := (w * w - x * x - y * y + z * z) * v3 + ((y * z - w * x + (y * z - w * x)) * v2 + (x * z
    + w * y + (x * z + w * y)) * v1) in
  let t_7 := I * (t_4 + (w * w + x * x - y * y - z * z) * (1 / I * (I * v2 * v3 - I * v3 * v2)) + (x
    * y + w * z + (x * y + w * z)) * (1 / I * (I * v3 * v1 - I * v1 * v3)) + (x * z - w * y + (x * z
    - w * y)) * (1 / I * (I * v1 * v2 - I * v2 * v1))) - (I * t_5 * t_6 - I * t_6 * t_5) in
  I <> 0 ->
  t_7 = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* Frozen, Euler, z *)
Theorem wrong_engines_are_right_for_a_ball_31 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := (x * z - w * y + (x * z - w * y)) * v3 + ((x * y + w * z + (x * y + w * z)) * v2 + (w *
    w + x * x - y * y - z * z) * v1) in
  let t_2 := (y * z + w * x + (y * z + w * x)) * v3 + ((w * w - x * x + y * y - z * z) * v2 + (x * y
    - w * z + (x * y - w * z)) * v1) in
  let t_3 := (w * w - x * x - y * y + z * z) * v3 + ((y * z - w * x + (y * z - w * x)) * v2 + (x * z
    + w * y + (x * z + w * y)) * v1) in
  let t_4 := ((w + w) * v3 + ((- x - x) * v2 + (y + y) * v1)) * ((- (x * t_1) - y * t_2 - z * t_3) /
    2) + ((- (x + x)) * v3 + ((- w - w) * v2 + (z + z) * v1)) * ((w * t_1 + y * t_3 - z * t_2) / 2)
    + ((- (y + y)) * v3 + ((z + z) * v2 + (w + w) * v1)) * ((w * t_2 - x * t_3 + z * t_1) / 2) in
  let t_5 := t_4 + ((z + z) * v3 + ((y + y) * v2 + (x + x) * v1)) * ((w * t_3 + x * t_2 - y * t_1) /
    2) + (x * z + w * y + (x * z + w * y)) * (1 / I * (I * v2 * v3 - I * v3 * v2)) + (y * z - w * x
    + (y * z - w * x)) * (1 / I * (I * v3 * v1 - I * v1 * v3)) + (w * w - x * x - y * y + z * z) *
    (1 / I * (I * v1 * v2 - I * v2 * v1)) in
  let t_6 := (x * z - w * y + (x * z - w * y)) * v3 + ((x * y + w * z + (x * y + w * z)) * v2 + (w *
    w + x * x - y * y - z * z) * v1) in
  let t_7 := (y * z + w * x + (y * z + w * x)) * v3 + ((w * w - x * x + y * y - z * z) * v2 + (x * y
    - w * z + (x * y - w * z)) * v1) in
  I <> 0 ->
  I * t_5 - (I * t_6 * t_7 - I * t_7 * t_6) = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_32 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := v2 * 3 / (I + I + I) in
  let t_2 := - (w * w) - w * w in
  let t_3 := v1 * 3 / (I + I + I) in
  let t_4 := I * ((w * w - w * w) * t_1 + t_2 * t_3) in
  let t_5 := I * ((w * w + w * w) * t_1 + (w * w - w * w) * t_3) in
  let t_6 := (- w - w) * t_4 + t_2 * (I * ((w + w) * t_1 + (w * w - w * w) * (0 / (I + I + I)) + ((-
    w - w) * t_3 + t_2 * (0 / (I + I + I))))) + ((w + w) * t_5 + (w * w - w * w) * (I * ((w + w) *
    t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_3 + (w * w - w * w) * (0 / (I + I +
    I)))))) in
  let t_7 := (w * w + w * w) * (v3 * 3 / (I + I + I)) in
  let t_8 := v3 * 3 / (I + I + I) in
  let t_9 := I * ((w * w + w * w) * t_8) in
  let t_10 := v2 * 3 / (I + I + I) in
  let t_11 := v1 * 3 / (I + I + I) in
  let t_12 := (w * w + w * w) * t_10 + (w * w - w * w) * t_11 in
  let t_13 := (w * w - w * w) * t_10 + (- (w * w) - w * w) * t_11 in
  let t_14 := t_6 * ((- (w * t_7)) / 2) + ((w + w) * t_9 + (t_2 * (I * ((w + w) * t_8 + ((w * w - w
    * w) * (0 / (I + I + I)) + t_2 * (0 / (I + I + I))))) + (w * w - w * w) * (I * ((w + w) * t_8 +
    ((w * w + w * w) * (0 / (I + I + I)) + (w * w - w * w) * (0 / (I + I + I))))))) * ((w * t_12 - w
    * t_13) / 2) in
  let t_15 := ((w + w) * t_9 + (t_2 * (I * ((w + w) * t_8 + ((w * w - w * w) * (0 / (I + I + I)) +
    t_2 * (0 / (I + I + I))))) + (w * w - w * w) * (I * ((- w - w) * t_8 + ((w * w + w * w) * (0 /
    (I + I + I)) + (w * w - w * w) * (0 / (I + I + I))))))) * ((w * t_13 + w * t_12) / 2) in
  let t_16 := (- w - w) * t_4 + t_2 * (I * ((- (w + w)) * t_1 + (w * w - w * w) * (0 / (I + I + I))
    + ((- w - w) * t_3 + t_2 * (0 / (I + I + I))))) + ((- (w + w)) * t_5 + (w * w - w * w) * (I *
    ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((- (w + w)) * t_3 + (w * w - w * w) * (0
    / (I + I + I)))))) in
  I + I + I <> 0 ->
  t_14 + t_15 + t_16 * (w * t_7 / 2) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_33 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := v2 * 3 / (I + I + I) in
  let t_2 := - (w * w) - w * w in
  let t_3 := v1 * 3 / (I + I + I) in
  let t_4 := I * ((w * w - w * w) * t_1 + t_2 * t_3) in
  let t_5 := I * ((w * w + w * w) * t_1 + (w * w - w * w) * t_3) in
  let t_6 := (w + w) * t_4 + (w * w - w * w) * (I * ((w + w) * t_1 + (w * w - w * w) * (0 / (I + I +
    I)) + ((- w - w) * t_3 + t_2 * (0 / (I + I + I))))) + ((w + w) * t_5 + (w * w + w * w) * (I *
    ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_3 + (w * w - w * w) * (0 /
    (I + I + I)))))) in
  let t_7 := (w * w + w * w) * (v3 * 3 / (I + I + I)) in
  let t_8 := v3 * 3 / (I + I + I) in
  let t_9 := I * ((w * w + w * w) * t_8) in
  let t_10 := v2 * 3 / (I + I + I) in
  let t_11 := v1 * 3 / (I + I + I) in
  let t_12 := (w * w + w * w) * t_10 + (w * w - w * w) * t_11 in
  let t_13 := (w * w - w * w) * t_10 + (- (w * w) - w * w) * t_11 in
  let t_14 := ((- w - w) * t_9 + ((w * w - w * w) * (I * ((w + w) * t_8 + ((w * w - w * w) * (0 / (I
    + I + I)) + t_2 * (0 / (I + I + I))))) + (w * w + w * w) * (I * ((w + w) * t_8 + ((w * w + w *
    w) * (0 / (I + I + I)) + (w * w - w * w) * (0 / (I + I + I))))))) * ((w * t_12 - w * t_13) / 2)
    in
  let t_15 := ((w + w) * t_9 + ((w * w - w * w) * (I * ((w + w) * t_8 + ((w * w - w * w) * (0 / (I +
    I + I)) + t_2 * (0 / (I + I + I))))) + (w * w + w * w) * (I * ((- w - w) * t_8 + ((w * w + w *
    w) * (0 / (I + I + I)) + (w * w - w * w) * (0 / (I + I + I))))))) * ((w * t_13 + w * t_12) / 2)
    in
  let t_16 := (- (w + w)) * t_4 + (w * w - w * w) * (I * ((- (w + w)) * t_1 + (w * w - w * w) * (0 /
    (I + I + I)) + ((- w - w) * t_3 + t_2 * (0 / (I + I + I))))) + ((w + w) * t_5 + (w * w + w * w)
    * (I * ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((- (w + w)) * t_3 + (w * w - w *
    w) * (0 / (I + I + I)))))) in
  I + I + I <> 0 ->
  t_6 * ((- (w * t_7)) / 2) + t_14 + t_15 + t_16 * (w * t_7 / 2) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_34 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := v3 * 3 / (I + I + I) in
  let t_2 := I * ((w * w + w * w) * t_1) in
  let t_3 := (w * w + w * w) * (v3 * 3 / (I + I + I)) in
  let t_4 := v2 * 3 / (I + I + I) in
  let t_5 := v1 * 3 / (I + I + I) in
  let t_6 := I * ((w * w - w * w) * t_4 + (- (w * w) - w * w) * t_5) in
  let t_7 := I * ((w * w + w * w) * t_4 + (w * w - w * w) * t_5) in
  let t_8 := v2 * 3 / (I + I + I) in
  let t_9 := v1 * 3 / (I + I + I) in
  let t_10 := (w * w + w * w) * t_8 + (w * w - w * w) * t_9 in
  let t_11 := (w * w - w * w) * t_8 + (- (w * w) - w * w) * t_9 in
  let t_12 := ((w + w) * t_2 + (w * w + w * w) * (I * ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I
    + I))))) * ((- (w * t_3)) / 2) + ((w * w + w * w) * (I * ((w * w + w * w) * (0 / (I + I + I)) +
    ((- w - w) * t_4 + (w + w) * t_5))) + ((w + w) * t_6 + (w + w) * t_7)) * ((w * t_10 - w * t_11)
    / 2) in
  let t_13 := t_12 + ((w * w + w * w) * (I * ((w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_4 +
    (w + w) * t_5))) + ((w + w) * t_6 + (- w - w) * t_7)) * ((w * t_11 + w * t_10) / 2) + ((w + w) *
    t_2 + (w * w + w * w) * (I * ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I))))) * (w * t_3
    / 2) in
  I + I + I <> 0 ->
  t_13 = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, LengthOfMomentum *)
Theorem wrong_engines_are_right_for_a_ball_36 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := v2 * 3 / (I + I + I) in
  let t_2 := v1 * 3 / (I + I + I) in
  let t_3 := I * ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_2 + (w * w - w
    * w) * (0 / (I + I + I)))) in
  let t_4 := I * ((w * w + w * w) * t_1 + (w * w - w * w) * t_2) in
  let t_5 := - (w * w) - w * w in
  let t_6 := I * ((w + w) * t_1 + (w * w - w * w) * (0 / (I + I + I)) + ((- w - w) * t_2 + t_5 * (0
    / (I + I + I)))) in
  let t_7 := I * ((w * w - w * w) * t_1 + t_5 * t_2) in
  let t_8 := v3 * 3 / (I + I + I) in
  let t_9 := I * ((w + w) * t_8 + (w * w + w * w) * (0 / (I + I + I))) in
  let t_10 := I * ((w * w + w * w) * t_8) in
  let t_11 := (w * w + w * w) * (v3 * 3 / (I + I + I)) in
  let t_12 := I * ((w + w) * t_8 + ((w * w + w * w) * (0 / (I + I + I)) + (w * w - w * w) * (0 / (I
    + I + I)))) in
  let t_13 := I * ((w + w) * t_8 + ((w * w - w * w) * (0 / (I + I + I)) + t_5 * (0 / (I + I + I))))
    in
  let t_14 := I * ((w * w + w * w) * (0 / (I + I + I)) + ((- w - w) * t_1 + (w + w) * t_2)) in
  let t_15 := v2 * 3 / (I + I + I) in
  let t_16 := v1 * 3 / (I + I + I) in
  let t_17 := (w * w + w * w) * t_15 + (w * w - w * w) * t_16 in
  let t_18 := (w * w - w * w) * t_15 + (- (w * w) - w * w) * t_16 in
  let t_19 := I * ((- w - w) * t_8 + ((w * w + w * w) * (0 / (I + I + I)) + (w * w - w * w) * (0 /
    (I + I + I)))) in
  let t_20 := I * ((w + w) * t_8 + ((w * w - w * w) * (0 / (I + I + I)) + t_5 * (0 / (I + I + I))))
    in
  let t_21 := I * ((w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_1 + (w + w) * t_2)) in
  let t_22 := I * ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((- (w + w)) * t_2 + (w * w
    - w * w) * (0 / (I + I + I)))) in
  let t_23 := I * ((- (w + w)) * t_1 + (w * w - w * w) * (0 / (I + I + I)) + ((- w - w) * t_2 + t_5
    * (0 / (I + I + I)))) in
  let t_24 := I * ((w + w) * t_8 + (w * w + w * w) * (0 / (I + I + I))) in
  let t_25 := (t_3 * t_4 + t_4 * t_3 + (t_6 * t_7 + t_7 * t_6) + (t_9 * t_10 + t_10 * t_9)) * ((- (w
    * t_11)) / 2) + (t_12 * t_4 + t_4 * t_12 + (t_13 * t_7 + t_7 * t_13) + (t_14 * t_10 + t_10 *
    t_14)) * ((w * t_17 - w * t_18) / 2) + (t_19 * t_4 + t_4 * t_19 + (t_20 * t_7 + t_7 * t_20) +
    (t_21 * t_10 + t_10 * t_21)) * ((w * t_18 + w * t_17) / 2) + (t_22 * t_4 + t_4 * t_22 + (t_23 *
    t_7 + t_7 * t_23) + (t_24 * t_10 + t_10 * t_24)) * (w * t_11 / 2) in
  I + I + I <> 0 ->
  t_25 = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 D_1.
  cut_to t_1 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_2 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_3 (2 * v1 * w + 2 * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_4 (v2) ltac:(field [H_1]; nonzero).
  cut_to t_5 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_6 (- (2 * v1 * w) + 2 * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_7 (- v1) ltac:(field [H_1]; nonzero).
  cut_to t_8 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_9 (2 * v3 * w) ltac:(field [H_1]; nonzero).
  cut_to t_10 (v3) ltac:(field [H_1]; nonzero).
  cut_to t_11 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_12 (2 * v3 * w) ltac:(field [H_1]; nonzero).
  cut_to t_13 (2 * v3 * w) ltac:(field [H_1]; nonzero).
  cut_to t_14 (2 * v1 * w - 2 * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_15 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_16 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_17 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_18 ((- v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_19 (- (2 * v3 * w)) ltac:(field [H_1]; nonzero).
  cut_to t_20 (2 * v3 * w) ltac:(field [H_1]; nonzero).
  cut_to t_21 (2 * v1 * w + 2 * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_22 (- (2 * v1 * w) + 2 * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_23 (- (2 * v1 * w) - 2 * v2 * w) ltac:(field [H_1]; nonzero).
  cut_to t_24 (2 * v3 * w) ltac:(field [H_1]; nonzero).
  cut_to t_25 (0) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, Energy *)
Theorem wrong_engines_are_right_for_a_ball_38 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := v2 * 3 / (I + I + I) in
  let t_2 := v1 * 3 / (I + I + I) in
  let t_3 := (w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_2 + (w * w - w * w)
    * (0 / (I + I + I))) in
  let t_4 := (w * w + w * w) * t_1 + (w * w - w * w) * t_2 in
  let t_5 := - (w * w) - w * w in
  let t_6 := (w + w) * t_1 + (w * w - w * w) * (0 / (I + I + I)) + ((- w - w) * t_2 + t_5 * (0 / (I
    + I + I))) in
  let t_7 := (w * w - w * w) * t_1 + t_5 * t_2 in
  let t_8 := v3 * 3 / (I + I + I) in
  let t_9 := (w + w) * t_8 + (w * w + w * w) * (0 / (I + I + I)) in
  let t_10 := (w * w + w * w) * t_8 in
  let t_11 := (w * w + w * w) * (v3 * 3 / (I + I + I)) in
  let t_12 := (w + w) * t_8 + ((w * w + w * w) * (0 / (I + I + I)) + (w * w - w * w) * (0 / (I + I +
    I))) in
  let t_13 := (w + w) * t_8 + ((w * w - w * w) * (0 / (I + I + I)) + t_5 * (0 / (I + I + I))) in
  let t_14 := (w * w + w * w) * (0 / (I + I + I)) + ((- w - w) * t_1 + (w + w) * t_2) in
  let t_15 := v2 * 3 / (I + I + I) in
  let t_16 := v1 * 3 / (I + I + I) in
  let t_17 := (w * w + w * w) * t_15 + (w * w - w * w) * t_16 in
  let t_18 := (w * w - w * w) * t_15 + (- (w * w) - w * w) * t_16 in
  let t_19 := (- w - w) * t_8 + ((w * w + w * w) * (0 / (I + I + I)) + (w * w - w * w) * (0 / (I + I
    + I))) in
  let t_20 := (w + w) * t_8 + ((w * w - w * w) * (0 / (I + I + I)) + t_5 * (0 / (I + I + I))) in
  let t_21 := (w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_1 + (w + w) * t_2) in
  let t_22 := (t_3 * (I * t_4) + t_4 * (I * t_3) + (t_6 * (I * t_7) + t_7 * (I * t_6)) + (t_9 * (I *
    t_10) + t_10 * (I * t_9))) / 2 * ((- (w * t_11)) / 2) + (t_12 * (I * t_4) + t_4 * (I * t_12) +
    (t_13 * (I * t_7) + t_7 * (I * t_13)) + (t_14 * (I * t_10) + t_10 * (I * t_14))) / 2 * ((w *
    t_17 - w * t_18) / 2) + (t_19 * (I * t_4) + t_4 * (I * t_19) + (t_20 * (I * t_7) + t_7 * (I *
    t_20)) + (t_21 * (I * t_10) + t_10 * (I * t_21))) / 2 * ((w * t_18 + w * t_17) / 2) in
  let t_23 := (w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((- (w + w)) * t_2 + (w * w - w
    * w) * (0 / (I + I + I))) in
  let t_24 := (- (w + w)) * t_1 + (w * w - w * w) * (0 / (I + I + I)) + ((- w - w) * t_2 + t_5 * (0
    / (I + I + I))) in
  let t_25 := (w + w) * t_8 + (w * w + w * w) * (0 / (I + I + I)) in
  I + I + I <> 0 ->
  t_22 + (t_23 * (I * t_4) + t_4 * (I * t_23) + (t_24 * (I * t_7) + t_7 * (I * t_24)) + (t_25 * (I *
    t_10) + t_10 * (I * t_25))) / 2 * (w * t_11 / 2) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 D_1.
  cut_to t_1 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_2 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_3 ((2 * v1 * w + 2 * v2 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_4 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_5 ((-1)) ltac:(field [H_1]; nonzero).
  cut_to t_6 ((- (2 * v1 * w) + 2 * v2 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_7 ((- v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_8 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_9 ((2 * v3 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_10 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_11 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_12 ((2 * v3 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_13 ((2 * v3 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_14 ((2 * v1 * w - 2 * v2 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_15 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_16 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_17 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_18 ((- v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_19 ((- (2 * v3 * w)) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_20 ((2 * v3 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_21 ((2 * v1 * w + 2 * v2 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_22 ((- ((1 / 2) * v1 ^ 2 * v3) - (1 / 2) * v2 ^ 2 * v3 - (1 / 2) * v3 ^ 3) / (I ^ 2))
    ltac:(field [H_1]; nonzero).
  cut_to t_23 ((- (2 * v1 * w) + 2 * v2 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_24 ((- (2 * v1 * w) - 2 * v2 * w) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_25 ((2 * v3 * w) / (I)) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, Euler *)
Theorem wrong_engines_are_right_for_a_ball_40 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := v2 * 3 / (I + I + I) in
  let t_2 := v1 * 3 / (I + I + I) in
  let t_3 := (w * w + w * w) * (v3 * 3 / (I + I + I)) in
  let t_4 := v3 * 3 / (I + I + I) in
  let t_5 := v2 * 3 / (I + I + I) in
  let t_6 := v1 * 3 / (I + I + I) in
  let t_7 := (w * w + w * w) * t_5 + (w * w - w * w) * t_6 in
  let t_8 := (w * w - w * w) * t_5 + (- (w * w) - w * w) * t_6 in
  let t_9 := ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_2 + (w * w - w * w)
    * (0 / (I + I + I)))) * ((- (w * t_3)) / 2) + ((w + w) * t_4 + ((w * w + w * w) * (0 / (I + I +
    I)) + (w * w - w * w) * (0 / (I + I + I)))) * ((w * t_7 - w * t_8) / 2) + ((- w - w) * t_4 + ((w
    * w + w * w) * (0 / (I + I + I)) + (w * w - w * w) * (0 / (I + I + I)))) * ((w * t_8 + w * t_7)
    / 2) in
  let t_10 := (w * w - w * w) * t_1 + (- (w * w) - w * w) * t_2 in
  let t_11 := (w * w + w * w) * t_4 in
  I + I + I <> 0 ->
  I * (t_9 + ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I)) + ((- (w + w)) * t_2 + (w * w - w
    * w) * (0 / (I + I + I)))) * (w * t_3 / 2)) - (I * t_10 * t_11 - I * t_11 * t_10) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, Euler *)
Theorem wrong_engines_are_right_for_a_ball_41 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := v2 * 3 / (I + I + I) in
  let t_2 := v1 * 3 / (I + I + I) in
  let t_3 := - (w * w) - w * w in
  let t_4 := (w * w + w * w) * (v3 * 3 / (I + I + I)) in
  let t_5 := v3 * 3 / (I + I + I) in
  let t_6 := v2 * 3 / (I + I + I) in
  let t_7 := v1 * 3 / (I + I + I) in
  let t_8 := (w * w + w * w) * t_6 + (w * w - w * w) * t_7 in
  let t_9 := (w * w - w * w) * t_6 + (- (w * w) - w * w) * t_7 in
  let t_10 := ((w + w) * t_1 + (w * w - w * w) * (0 / (I + I + I)) + ((- w - w) * t_2 + t_3 * (0 /
    (I + I + I)))) * ((- (w * t_4)) / 2) + ((w + w) * t_5 + ((w * w - w * w) * (0 / (I + I + I)) +
    t_3 * (0 / (I + I + I)))) * ((w * t_8 - w * t_9) / 2) + ((w + w) * t_5 + ((w * w - w * w) * (0 /
    (I + I + I)) + t_3 * (0 / (I + I + I)))) * ((w * t_9 + w * t_8) / 2) in
  let t_11 := (w * w + w * w) * t_5 in
  let t_12 := (w * w + w * w) * t_1 + (w * w - w * w) * t_2 in
  I + I + I <> 0 ->
  I * (t_10 + ((- (w + w)) * t_1 + (w * w - w * w) * (0 / (I + I + I)) + ((- w - w) * t_2 + t_3 * (0
    / (I + I + I)))) * (w * t_4 / 2)) - (I * t_11 * t_12 - I * t_12 * t_11) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, Euler *)
Theorem wrong_engines_are_right_for_a_ball_42 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := v3 * 3 / (I + I + I) in
  let t_2 := (w * w + w * w) * (v3 * 3 / (I + I + I)) in
  let t_3 := v2 * 3 / (I + I + I) in
  let t_4 := v1 * 3 / (I + I + I) in
  let t_5 := v2 * 3 / (I + I + I) in
  let t_6 := v1 * 3 / (I + I + I) in
  let t_7 := (w * w + w * w) * t_5 + (w * w - w * w) * t_6 in
  let t_8 := (w * w - w * w) * t_5 + (- (w * w) - w * w) * t_6 in
  let t_9 := ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I))) * ((- (w * t_2)) / 2) + ((w * w +
    w * w) * (0 / (I + I + I)) + ((- w - w) * t_3 + (w + w) * t_4)) * ((w * t_7 - w * t_8) / 2) +
    ((w * w + w * w) * (0 / (I + I + I)) + ((w + w) * t_3 + (w + w) * t_4)) * ((w * t_8 + w * t_7) /
    2) in
  let t_10 := (w * w + w * w) * t_3 + (w * w - w * w) * t_4 in
  let t_11 := (w * w - w * w) * t_3 + (- (w * w) - w * w) * t_4 in
  I + I + I <> 0 ->
  I * (t_9 + ((w + w) * t_1 + (w * w + w * w) * (0 / (I + I + I))) * (w * t_2 / 2)) - (I * t_10 *
    t_11 - I * t_11 * t_10) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, Euler, x *)
Theorem wrong_engines_are_right_for_a_ball_43 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := v3 * 3 / (I + I + I) in
  let t_2 := x * z - w * y + (x * z - w * y) in
  let t_3 := v2 * 3 / (I + I + I) in
  let t_4 := x * y + w * z + (x * y + w * z) in
  let t_5 := v1 * 3 / (I + I + I) in
  let t_6 := w * w + x * x - y * y - z * z in
  let t_7 := v3 * 3 / (I + I + I) in
  let t_8 := v2 * 3 / (I + I + I) in
  let t_9 := v1 * 3 / (I + I + I) in
  let t_10 := (x * z - w * y + (x * z - w * y)) * t_7 + ((x * y + w * z + (x * y + w * z)) * t_8 +
    (w * w + x * x - y * y - z * z) * t_9) in
  let t_11 := (y * z + w * x + (y * z + w * x)) * t_7 + ((w * w - x * x + y * y - z * z) * t_8 + (x
    * y - w * z + (x * y - w * z)) * t_9) in
  let t_12 := (w * w - x * x - y * y + z * z) * t_7 + ((y * z - w * x + (y * z - w * x)) * t_8 + (x
    * z + w * y + (x * z + w * y)) * t_9) in
  let t_13 := ((- y - y) * t_1 + t_2 * (0 / (I + I + I)) + ((z + z) * t_3 + t_4 * (0 / (I + I + I))
    + ((w + w) * t_5 + t_6 * (0 / (I + I + I))))) * ((- (x * t_10) - y * t_11 - z * t_12) / 2) + ((z
    + z) * t_1 + t_2 * (0 / (I + I + I)) + ((y + y) * t_3 + t_4 * (0 / (I + I + I)) + ((x + x) * t_5
    + t_6 * (0 / (I + I + I))))) * ((w * t_10 + y * t_12 - z * t_11) / 2) in
  let t_14 := t_13 + ((- w - w) * t_1 + t_2 * (0 / (I + I + I)) + ((x + x) * t_3 + t_4 * (0 / (I + I
    + I)) + ((- (y + y)) * t_5 + t_6 * (0 / (I + I + I))))) * ((w * t_11 - x * t_12 + z * t_10) / 2)
    + ((x + x) * t_1 + t_2 * (0 / (I + I + I)) + ((w + w) * t_3 + t_4 * (0 / (I + I + I)) + ((- (z +
    z)) * t_5 + t_6 * (0 / (I + I + I))))) * ((w * t_12 + x * t_11 - y * t_10) / 2) in
  let t_15 := (y * z + w * x + (y * z + w * x)) * t_1 + ((w * w - x * x + y * y - z * z) * t_3 + (x
    * y - w * z + (x * y - w * z)) * t_5) in
  let t_16 := (w * w - x * x - y * y + z * z) * t_1 + ((y * z - w * x + (y * z - w * x)) * t_3 + (x
    * z + w * y + (x * z + w * y)) * t_5) in
  I + I + I <> 0 ->
  I * t_14 - (I * t_15 * t_16 - I * t_16 * t_15) = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15
    t_16 D_1.
  cut_to t_1 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_2 (- (2 * w * y) + 2 * x * z) ltac:(field [H_1]; nonzero).
  cut_to t_3 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_4 (2 * w * z + 2 * x * y) ltac:(field [H_1]; nonzero).
  cut_to t_5 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_6 (- (2 * y ^ 2) - 2 * z ^ 2 + 1) ltac:(field [H_1]; nonzero).
  cut_to t_7 ((v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_8 ((v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_9 ((v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_10 ((- (2 * v1 * y ^ 2) - 2 * v1 * z ^ 2 + 2 * v2 * w * z + 2 * v2 * x * y - 2 * v3 * w *
    y + 2 * v3 * x * z + v1) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_11 ((- (2 * v1 * w * z) + 2 * v1 * x * y - 2 * v2 * x ^ 2 - 2 * v2 * z ^ 2 + 2 * v3 * w *
    x + 2 * v3 * y * z + v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_12 ((2 * v1 * w * y + 2 * v1 * x * z - 2 * v2 * w * x + 2 * v2 * y * z - 2 * v3 * x ^ 2 -
    2 * v3 * y ^ 2 + v3) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_13 (0) ltac:(field [H_1]; nonzero).
  cut_to t_14 (0) ltac:(field [H_1]; nonzero).
  cut_to t_15 ((- (2 * v1 * w * z) + 2 * v1 * x * y - 2 * v2 * x ^ 2 - 2 * v2 * z ^ 2 + 2 * v3 * w *
    x + 2 * v3 * y * z + v2) / (I)) ltac:(field [H_1]; nonzero).
  cut_to t_16 ((2 * v1 * w * y + 2 * v1 * x * z - 2 * v2 * w * x + 2 * v2 * y * z - 2 * v3 * x ^ 2 -
    2 * v3 * y ^ 2 + v3) / (I)) ltac:(field [H_1]; nonzero).
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, SpinFromMomentum *)
Theorem wrong_engines_are_right_for_a_ball_44 :
  forall I v1 v2 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := - (w * w) - w * w in
  let t_2 := (w * w - w * w) * I in
  I + I + I <> 0 ->
  (t_1 * I * (w * w - w * w) + t_2 * (w * w + w * w)) * (v2 * 3 / (I + I + I)) + (t_1 * I * t_1 +
    t_2 * (w * w - w * w)) * (v1 * 3 / (I + I + I)) - v1 = 0.
Proof.
  intros I v1 v2 w H_1 t_1 t_2 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, SpinFromMomentum *)
Theorem wrong_engines_are_right_for_a_ball_45 :
  forall I v1 v2 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w - w * w) * I in
  let t_2 := (w * w + w * w) * I in
  I + I + I <> 0 ->
  (t_1 * (w * w - w * w) + t_2 * (w * w + w * w)) * (v2 * 3 / (I + I + I)) + (t_1 * (- (w * w) - w *
    w) + t_2 * (w * w - w * w)) * (v1 * 3 / (I + I + I)) - v2 = 0.
Proof.
  intros I v1 v2 w H_1 t_1 t_2 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, SpinFromMomentum *)
Theorem wrong_engines_are_right_for_a_ball_46 :
  forall I v3 w : R,
  w ^ 2 = (1 / 2) ->
  I + I + I <> 0 ->
  (w * w + w * w) * I * (w * w + w * w) * (v3 * 3 / (I + I + I)) - v3 = 0.
Proof.
  intros I v3 w H_1  D_1.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, SpinFromMomentum, x *)
Theorem wrong_engines_are_right_for_a_ball_47 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := x * z + w * y + (x * z + w * y) in
  let t_2 := x * y - w * z + (x * y - w * z) in
  let t_3 := w * w + x * x - y * y - z * z in
  let t_4 := (t_1 * I * (w * w - x * x - y * y + z * z) + (t_2 * I * (y * z + w * x + (y * z + w *
    x)) + t_3 * I * (x * z - w * y + (x * z - w * y)))) * (v3 * 3 / (I + I + I)) + ((t_1 * I * (y *
    z - w * x + (y * z - w * x)) + (t_2 * I * (w * w - x * x + y * y - z * z) + t_3 * I * (x * y + w
    * z + (x * y + w * z)))) * (v2 * 3 / (I + I + I)) + (t_1 * I * t_1 + (t_2 * I * t_2 + t_3 * I *
    t_3)) * (v1 * 3 / (I + I + I))) in
  I + I + I <> 0 ->
  t_4 - v1 = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, SpinFromMomentum, y *)
Theorem wrong_engines_are_right_for_a_ball_48 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := y * z - w * x + (y * z - w * x) in
  let t_2 := w * w - x * x + y * y - z * z in
  let t_3 := x * y + w * z + (x * y + w * z) in
  let t_4 := (t_1 * I * (w * w - x * x - y * y + z * z) + (t_2 * I * (y * z + w * x + (y * z + w *
    x)) + t_3 * I * (x * z - w * y + (x * z - w * y)))) * (v3 * 3 / (I + I + I)) + ((t_1 * I * t_1 +
    (t_2 * I * t_2 + t_3 * I * t_3)) * (v2 * 3 / (I + I + I)) + (t_1 * I * (x * z + w * y + (x * z +
    w * y)) + (t_2 * I * (x * y - w * z + (x * y - w * z)) + t_3 * I * (w * w + x * x - y * y - z *
    z))) * (v1 * 3 / (I + I + I))) in
  I + I + I <> 0 ->
  t_4 - v2 = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* MomentumForSpin, SpinFromMomentum, z *)
Theorem wrong_engines_are_right_for_a_ball_49 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := w * w - x * x - y * y + z * z in
  let t_2 := y * z + w * x + (y * z + w * x) in
  let t_3 := x * z - w * y + (x * z - w * y) in
  let t_4 := (t_1 * I * (y * z - w * x + (y * z - w * x)) + (t_2 * I * (w * w - x * x + y * y - z *
    z) + t_3 * I * (x * y + w * z + (x * y + w * z)))) * (v2 * 3 / (I + I + I)) + (t_1 * I * (x * z
    + w * y + (x * z + w * y)) + (t_2 * I * (x * y - w * z + (x * y - w * z)) + t_3 * I * (w * w + x
    * x - y * y - z * z))) * (v1 * 3 / (I + I + I)) in
  I + I + I <> 0 ->
  (t_1 * I * t_1 + (t_2 * I * t_2 + t_3 * I * t_3)) * (v3 * 3 / (I + I + I)) + t_4 - v3 = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 D_1.
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_50 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := - (w * w) - w * w in
  let t_2 := I * ((w * w - w * w) * v2 + t_1 * v1) in
  let t_3 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_4 := (w * w + w * w) * v3 in
  let t_5 := I * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_7 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_8 := ((- w - w) * t_2 + t_1 * (I * ((w + w) * v2 + (- w - w) * v1)) + ((w + w) * t_3 + (w *
    w - w * w) * (I * ((w + w) * v2 + (w + w) * v1)))) * ((- (w * t_4)) / 2) + ((w + w) * t_5 + (t_1
    * (I * ((w + w) * v3)) + (w * w - w * w) * (I * ((w + w) * v3)))) * ((w * t_6 - w * t_7) / 2) in
  let t_9 := t_8 + ((w + w) * t_5 + (t_1 * (I * ((w + w) * v3)) + (w * w - w * w) * (I * ((- w - w)
    * v3)))) * ((w * t_7 + w * t_6) / 2) + ((- w - w) * t_2 + t_1 * (I * ((- (w + w)) * v2 + (- w -
    w) * v1)) + ((- (w + w)) * t_3 + (w * w - w * w) * (I * ((w + w) * v2 + (- (w + w)) * v1)))) *
    (w * t_4 / 2) in
  t_9 = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_51 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := I * ((w * w - w * w) * v2 + (- (w * w) - w * w) * v1) in
  let t_2 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_3 := (w * w + w * w) * v3 in
  let t_4 := I * ((w * w + w * w) * v3) in
  let t_5 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_6 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_7 := ((w + w) * t_1 + (w * w - w * w) * (I * ((w + w) * v2 + (- w - w) * v1)) + ((w + w) *
    t_2 + (w * w + w * w) * (I * ((w + w) * v2 + (w + w) * v1)))) * ((- (w * t_3)) / 2) + ((- w - w)
    * t_4 + ((w * w - w * w) * (I * ((w + w) * v3)) + (w * w + w * w) * (I * ((w + w) * v3)))) * ((w
    * t_5 - w * t_6) / 2) in
  let t_8 := t_7 + ((w + w) * t_4 + ((w * w - w * w) * (I * ((w + w) * v3)) + (w * w + w * w) * (I *
    ((- w - w) * v3)))) * ((w * t_6 + w * t_5) / 2) + ((- (w + w)) * t_1 + (w * w - w * w) * (I *
    ((- (w + w)) * v2 + (- w - w) * v1)) + ((w + w) * t_2 + (w * w + w * w) * (I * ((w + w) * v2 +
    (- (w + w)) * v1)))) * (w * t_3 / 2) in
  t_8 = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_52 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := I * ((w * w + w * w) * v3) in
  let t_2 := (w * w + w * w) * v3 in
  let t_3 := I * ((w * w - w * w) * v2 + (- (w * w) - w * w) * v1) in
  let t_4 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_5 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_6 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_7 := ((w + w) * t_1 + (w * w + w * w) * (I * ((w + w) * v3))) * ((- (w * t_2)) / 2) + ((w *
    w + w * w) * (I * ((- w - w) * v2 + (w + w) * v1)) + ((w + w) * t_3 + (w + w) * t_4)) * ((w *
    t_5 - w * t_6) / 2) + ((w * w + w * w) * (I * ((w + w) * v2 + (w + w) * v1)) + ((w + w) * t_3 +
    (- w - w) * t_4)) * ((w * t_6 + w * t_5) / 2) in
  t_7 + ((w + w) * t_1 + (w * w + w * w) * (I * ((w + w) * v3))) * (w * t_2 / 2) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, LengthOfMomentum *)
Theorem wrong_engines_are_right_for_a_ball_54 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := I * ((w + w) * v2 + (w + w) * v1) in
  let t_2 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_3 := I * ((w + w) * v2 + (- w - w) * v1) in
  let t_4 := I * ((w * w - w * w) * v2 + (- (w * w) - w * w) * v1) in
  let t_5 := I * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v3 in
  let t_7 := I * ((- w - w) * v2 + (w + w) * v1) in
  let t_8 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_9 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_10 := (t_1 * t_2 + t_2 * t_1 + (t_3 * t_4 + t_4 * t_3) + (I * ((w + w) * v3) * t_5 + t_5 *
    (I * ((w + w) * v3)))) * ((- (w * t_6)) / 2) + (I * ((w + w) * v3) * t_2 + t_2 * (I * ((w + w) *
    v3)) + (I * ((w + w) * v3) * t_4 + t_4 * (I * ((w + w) * v3))) + (t_7 * t_5 + t_5 * t_7)) * ((w
    * t_8 - w * t_9) / 2) in
  let t_11 := I * ((- w - w) * v3) in
  let t_12 := I * ((w + w) * v2 + (w + w) * v1) in
  let t_13 := I * ((w + w) * v2 + (- (w + w)) * v1) in
  let t_14 := I * ((- (w + w)) * v2 + (- w - w) * v1) in
  t_10 + (t_11 * t_2 + t_2 * t_11 + (I * ((w + w) * v3) * t_4 + t_4 * (I * ((w + w) * v3))) + (t_12
    * t_5 + t_5 * t_12)) * ((w * t_9 + w * t_8) / 2) + (t_13 * t_2 + t_2 * t_13 + (t_14 * t_4 + t_4
    * t_14) + (I * ((w + w) * v3) * t_5 + t_5 * (I * ((w + w) * v3)))) * (w * t_6 / 2) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Energy *)
Theorem wrong_engines_are_right_for_a_ball_56 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w + w) * v2 + (w + w) * v1 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w + w) * v2 + (- w - w) * v1 in
  let t_4 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_5 := (w * w + w * w) * v3 in
  let t_6 := (w * w + w * w) * v3 in
  let t_7 := (- w - w) * v2 + (w + w) * v1 in
  let t_8 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_9 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_10 := (t_1 * (I * t_2) + t_2 * (I * t_1) + (t_3 * (I * t_4) + t_4 * (I * t_3)) + ((w + w) *
    v3 * (I * t_5) + t_5 * (I * ((w + w) * v3)))) / 2 * ((- (w * t_6)) / 2) + ((w + w) * v3 * (I *
    t_2) + t_2 * (I * ((w + w) * v3)) + ((w + w) * v3 * (I * t_4) + t_4 * (I * ((w + w) * v3))) +
    (t_7 * (I * t_5) + t_5 * (I * t_7))) / 2 * ((w * t_8 - w * t_9) / 2) in
  let t_11 := (w + w) * v2 + (w + w) * v1 in
  let t_12 := (w + w) * v2 + (- (w + w)) * v1 in
  let t_13 := (- (w + w)) * v2 + (- w - w) * v1 in
  let t_14 := t_10 + ((- w - w) * v3 * (I * t_2) + t_2 * (I * ((- w - w) * v3)) + ((w + w) * v3 * (I
    * t_4) + t_4 * (I * ((w + w) * v3))) + (t_11 * (I * t_5) + t_5 * (I * t_11))) / 2 * ((w * t_9 +
    w * t_8) / 2) + (t_12 * (I * t_2) + t_2 * (I * t_12) + (t_13 * (I * t_4) + t_4 * (I * t_13)) +
    ((w + w) * v3 * (I * t_5) + t_5 * (I * ((w + w) * v3)))) / 2 * (w * t_6 / 2) in
  t_14 = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Euler *)
Theorem wrong_engines_are_right_for_a_ball_58 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * v3 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_4 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_5 := (w * w + w * w) * v3 in
  I * (((w + w) * v2 + (w + w) * v1) * ((- (w * t_1)) / 2) + (w + w) * v3 * ((w * t_2 - w * t_3) /
    2) + (- w - w) * v3 * ((w * t_3 + w * t_2) / 2) + ((w + w) * v2 + (- (w + w)) * v1) * (w * t_1 /
    2)) - (I * t_4 * t_5 - I * t_5 * t_4) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Euler *)
Theorem wrong_engines_are_right_for_a_ball_59 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * v3 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_4 := (w * w + w * w) * v3 in
  let t_5 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  I * (((w + w) * v2 + (- w - w) * v1) * ((- (w * t_1)) / 2) + (w + w) * v3 * ((w * t_2 - w * t_3) /
    2) + (w + w) * v3 * ((w * t_3 + w * t_2) / 2) + ((- (w + w)) * v2 + (- w - w) * v1) * (w * t_1 /
    2)) - (I * t_4 * t_5 - I * t_5 * t_4) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Euler *)
Theorem wrong_engines_are_right_for_a_ball_60 :
  forall I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) ->
  let t_1 := (w * w + w * w) * v3 in
  let t_2 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_3 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_4 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_5 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  I * ((w + w) * v3 * ((- (w * t_1)) / 2) + ((- w - w) * v2 + (w + w) * v1) * ((w * t_2 - w * t_3) /
    2) + ((w + w) * v2 + (w + w) * v1) * ((w * t_3 + w * t_2) / 2) + (w + w) * v3 * (w * t_1 / 2)) -
    (I * t_4 * t_5 - I * t_5 * t_4) = 0.
Proof.
  intros I v1 v2 v3 w H_1 t_1 t_2 t_3 t_4 t_5 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Euler, x *)
Theorem wrong_engines_are_right_for_a_ball_61 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := (x * z - w * y + (x * z - w * y)) * v3 + ((x * y + w * z + (x * y + w * z)) * v2 + (w *
    w + x * x - y * y - z * z) * v1) in
  let t_2 := (y * z + w * x + (y * z + w * x)) * v3 + ((w * w - x * x + y * y - z * z) * v2 + (x * y
    - w * z + (x * y - w * z)) * v1) in
  let t_3 := (w * w - x * x - y * y + z * z) * v3 + ((y * z - w * x + (y * z - w * x)) * v2 + (x * z
    + w * y + (x * z + w * y)) * v1) in
  let t_4 := ((- y - y) * v3 + ((z + z) * v2 + (w + w) * v1)) * ((- (x * t_1) - y * t_2 - z * t_3) /
    2) + ((z + z) * v3 + ((y + y) * v2 + (x + x) * v1)) * ((w * t_1 + y * t_3 - z * t_2) / 2) + ((-
    w - w) * v3 + ((x + x) * v2 + (- (y + y)) * v1)) * ((w * t_2 - x * t_3 + z * t_1) / 2) + ((x +
    x) * v3 + ((w + w) * v2 + (- (z + z)) * v1)) * ((w * t_3 + x * t_2 - y * t_1) / 2) in
  let t_5 := (y * z + w * x + (y * z + w * x)) * v3 + ((w * w - x * x + y * y - z * z) * v2 + (x * y
    - w * z + (x * y - w * z)) * v1) in
  let t_6 := (w * w - x * x - y * y + z * z) * v3 + ((y * z - w * x + (y * z - w * x)) * v2 + (x * z
    + w * y + (x * z + w * y)) * v1) in
  I * t_4 - (I * t_5 * t_6 - I * t_6 * t_5) = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* NoGyroscopicTerm, Euler, z *)
Theorem wrong_engines_are_right_for_a_ball_62 :
  forall I v1 v2 v3 w x y z : R,
  w ^ 2 = - x ^ 2 - y ^ 2 - z ^ 2 + 1 ->
  let t_1 := (x * z - w * y + (x * z - w * y)) * v3 + ((x * y + w * z + (x * y + w * z)) * v2 + (w *
    w + x * x - y * y - z * z) * v1) in
  let t_2 := (y * z + w * x + (y * z + w * x)) * v3 + ((w * w - x * x + y * y - z * z) * v2 + (x * y
    - w * z + (x * y - w * z)) * v1) in
  let t_3 := (w * w - x * x - y * y + z * z) * v3 + ((y * z - w * x + (y * z - w * x)) * v2 + (x * z
    + w * y + (x * z + w * y)) * v1) in
  let t_4 := ((w + w) * v3 + ((- x - x) * v2 + (y + y) * v1)) * ((- (x * t_1) - y * t_2 - z * t_3) /
    2) + ((- (x + x)) * v3 + ((- w - w) * v2 + (z + z) * v1)) * ((w * t_1 + y * t_3 - z * t_2) / 2)
    + ((- (y + y)) * v3 + ((z + z) * v2 + (w + w) * v1)) * ((w * t_2 - x * t_3 + z * t_1) / 2) in
  let t_5 := (x * z - w * y + (x * z - w * y)) * v3 + ((x * y + w * z + (x * y + w * z)) * v2 + (w *
    w + x * x - y * y - z * z) * v1) in
  let t_6 := (y * z + w * x + (y * z + w * x)) * v3 + ((w * w - x * x + y * y - z * z) * v2 + (x * y
    - w * z + (x * y - w * z)) * v1) in
  I * (t_4 + ((z + z) * v3 + ((y + y) * v2 + (x + x) * v1)) * ((w * t_3 + x * t_2 - y * t_1) / 2)) -
    (I * t_5 * t_6 - I * t_6 * t_5) = 0.
Proof.
  intros I v1 v2 v3 w x y z H_1 t_1 t_2 t_3 t_4 t_5 t_6 .
  unnamed.
  field [H_1]; nonzero.
Qed.

(* With one moment larger. *)

(* Frozen, Momentum *)
Theorem wrong_engines_are_right_for_a_ball_mutant_1 :
  exists I v1 v2 v3 w : R,
  w ^ 2 = (1 / 2) /\
  let t_1 := - (w * w) - w * w in
  let t_2 := (I + 1) * ((w * w - w * w) * v2 + t_1 * v1) in
  let t_3 := I * ((w * w + w * w) * v2 + (w * w - w * w) * v1) in
  let t_4 := (w * w + w * w) * v3 in
  let t_5 := I * ((w * w + w * w) * v3) in
  let t_6 := (w * w + w * w) * v2 + (w * w - w * w) * v1 in
  let t_7 := (w * w - w * w) * v2 + (- (w * w) - w * w) * v1 in
  let t_8 := ((- w - w) * t_2 + t_1 * ((I + 1) * ((w + w) * v2 + (- w - w) * v1)) + ((w + w) * t_3 +
    (w * w - w * w) * (I * ((w + w) * v2 + (w + w) * v1)))) * ((- (w * t_4)) / 2) + ((w + w) * t_5 +
    (t_1 * ((I + 1) * ((w + w) * v3)) + (w * w - w * w) * (I * ((w + w) * v3)))) * ((w * t_6 - w *
    t_7) / 2) in
  let t_9 := t_8 + ((w + w) * t_5 + (t_1 * ((I + 1) * ((w + w) * v3)) + (w * w - w * w) * (I * ((- w
    - w) * v3)))) * ((w * t_7 + w * t_6) / 2) + ((- w - w) * t_2 + t_1 * ((I + 1) * ((- (w + w)) *
    v2 + (- w - w) * v1)) + ((- (w + w)) * t_3 + (w * w - w * w) * (I * ((w + w) * v2 + (- (w + w))
    * v1)))) * (w * t_4 / 2) in
  I <> 0 /\
  I + 1 <> 0 /\
  t_9 + (t_1 * ((I + 1) * t_1) + (w * w - w * w) * (I * (w * w - w * w))) * (1 / I * ((I + 1) * v2 *
    v3 - I * v3 * v2)) + (t_1 * ((I + 1) * (w * w - w * w)) + (w * w - w * w) * (I * (w * w + w *
    w))) * (1 / (I + 1) * (I * v3 * v1 - I * v1 * v3)) <> 0.
Proof.
  exists 3, (-6), (-4), 3, (sqrt (1 / 2)).
  split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.


(** order-of-rk4: One step of the Runge-Kutta method agrees with the exact motion of every free body through h⁴, in every component of attitude and momentum, and not through h⁵: its order is 4 and no more. *)

(* the power 0 of the step *)
Theorem order_of_rk4_1 :
  forall L1 : R,
  L1 = L1.
Proof.
  intros L1   .
  ring.
Qed.

(* the power 0 of the step *)
Theorem order_of_rk4_2 :
  forall L2 : R,
  L2 = L2.
Proof.
  intros L2   .
  ring.
Qed.

(* the power 0 of the step *)
Theorem order_of_rk4_3 :
  forall L3 : R,
  L3 = L3.
Proof.
  intros L3   .
  ring.
Qed.

(* the power 1 of the step *)
Theorem order_of_rk4_4 :
  forall J1 L1 : R,
  J1 * L1 / 2 * (1 / 6) + J1 * L1 / 2 * (1 / 3) + J1 * L1 / 2 * (1 / 3) + J1 * L1 / 2 * (1 / 6) = J1
    * L1 / 2.
Proof.
  intros J1 L1   .
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem order_of_rk4_5 :
  forall J2 L2 : R,
  J2 * L2 / 2 * (1 / 6) + J2 * L2 / 2 * (1 / 3) + J2 * L2 / 2 * (1 / 3) + J2 * L2 / 2 * (1 / 6) = J2
    * L2 / 2.
Proof.
  intros J2 L2   .
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem order_of_rk4_6 :
  forall J3 L3 : R,
  J3 * L3 / 2 * (1 / 6) + J3 * L3 / 2 * (1 / 3) + J3 * L3 / 2 * (1 / 3) + J3 * L3 / 2 * (1 / 6) = J3
    * L3 / 2.
Proof.
  intros J3 L3   .
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem order_of_rk4_7 :
  forall J2 J3 L2 L3 : R,
  (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 6) + (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 3) + (L2 *
    (J3 * L3) - L3 * (J2 * L2)) * (1 / 3) + (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 6) = L2 * (J3 *
    L3) - L3 * (J2 * L2).
Proof.
  intros J2 J3 L2 L3   .
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem order_of_rk4_8 :
  forall J1 J3 L1 L3 : R,
  (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 6) + (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 3) + (L3 *
    (J1 * L1) - L1 * (J3 * L3)) * (1 / 3) + (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 6) = L3 * (J1 *
    L1) - L1 * (J3 * L3).
Proof.
  intros J1 J3 L1 L3   .
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem order_of_rk4_9 :
  forall J1 J2 L1 L2 : R,
  (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 6) + (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 3) + (L1 *
    (J2 * L2) - L2 * (J1 * L1)) * (1 / 3) + (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 6) = L1 * (J2 *
    L2) - L2 * (J1 * L1).
Proof.
  intros J1 J2 L1 L2   .
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem order_of_rk4_10 :
  forall J1 J2 J3 L2 L3 : R,
  let t_1 := (J1 * ((L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2)) + J2 * L2 / 2 * (1 / 2) * (J3 * L3)
    - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2 * (1 / 3) + (J1 * ((L2 * (J3 * L3) - L3 * (J2 * L2)) *
    (1 / 2)) + J2 * L2 / 2 * (1 / 2) * (J3 * L3) - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2 * (1 / 3)
    + (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) /
    2 * (1 / 6) in
  t_1 = (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2))
    / 2 / 2.
Proof.
  intros J1 J2 J3 L2 L3  t_1 .
  unnamed.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem order_of_rk4_11 :
  forall J1 J2 J3 L1 L3 : R,
  let t_1 := (J2 * ((L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2)) - J1 * L1 / 2 * (1 / 2) * (J3 * L3)
    + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 3) + (J2 * ((L3 * (J1 * L1) - L1 * (J3 * L3)) *
    (1 / 2)) - J1 * L1 / 2 * (1 / 2) * (J3 * L3) + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 3)
    + (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) /
    2 * (1 / 6) in
  t_1 = (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1))
    / 2 / 2.
Proof.
  intros J1 J2 J3 L1 L3  t_1 .
  unnamed.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem order_of_rk4_12 :
  forall J1 J2 J3 L1 L2 : R,
  let t_1 := (J3 * ((L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2)) + J1 * L1 / 2 * (1 / 2) * (J2 * L2)
    - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 3) + (J3 * ((L1 * (J2 * L2) - L2 * (J1 * L1)) *
    (1 / 2)) + J1 * L1 / 2 * (1 / 2) * (J2 * L2) - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 3)
    + (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1)) + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) /
    2 * (1 / 6) in
  t_1 = (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1)) + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1))
    / 2 / 2.
Proof.
  intros J1 J2 J3 L1 L2  t_1 .
  unnamed.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem order_of_rk4_13 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (- (J1 * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 /
    2 * (1 / 2) * (J3 * L3)) / 2 * (1 / 3) + (- (J1 * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 *
    (1 / 2) * (J2 * L2) - J3 * L3 / 2 * (1 / 2) * (J3 * L3)) / 2 * (1 / 3) + (- (J1 * L1 / 2 * (J1 *
    L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 * (1 / 6) in
  t_1 = (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 .
  unnamed.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem order_of_rk4_14 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_2 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_3 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_4 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_5 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_6 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_7 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_8 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  (L2 * (J3 * t_1) + t_2 * (J3 * L3) - (L3 * (J2 * t_2) + t_1 * (J2 * L2))) * (1 / 3) + (L2 * (J3 *
    t_3) + t_4 * (J3 * L3) - (L3 * (J2 * t_4) + t_3 * (J2 * L2))) * (1 / 3) + (L2 * (J3 * t_5) + t_6
    * (J3 * L3) - (L3 * (J2 * t_6) + t_5 * (J2 * L2))) * (1 / 6) = (L2 * (J3 * t_7) + t_8 * (J3 *
    L3) - (L3 * (J2 * t_8) + t_7 * (J2 * L2))) / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 .
  unnamed.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem order_of_rk4_15 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_2 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_3 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_4 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_5 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_6 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_7 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_8 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  (L3 * (J1 * t_1) + t_2 * (J1 * L1) - (L1 * (J3 * t_2) + t_1 * (J3 * L3))) * (1 / 3) + (L3 * (J1 *
    t_3) + t_4 * (J1 * L1) - (L1 * (J3 * t_4) + t_3 * (J3 * L3))) * (1 / 3) + (L3 * (J1 * t_5) + t_6
    * (J1 * L1) - (L1 * (J3 * t_6) + t_5 * (J3 * L3))) * (1 / 6) = (L3 * (J1 * t_7) + t_8 * (J1 *
    L1) - (L1 * (J3 * t_8) + t_7 * (J3 * L3))) / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 .
  unnamed.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem order_of_rk4_16 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_2 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_3 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_4 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_5 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_6 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_7 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_8 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  (L1 * (J2 * t_1) + t_2 * (J2 * L2) - (L2 * (J1 * t_2) + t_1 * (J1 * L1))) * (1 / 3) + (L1 * (J2 *
    t_3) + t_4 * (J2 * L2) - (L2 * (J1 * t_4) + t_3 * (J1 * L1))) * (1 / 3) + (L1 * (J2 * t_5) + t_6
    * (J2 * L2) - (L2 * (J1 * t_6) + t_5 * (J1 * L1))) * (1 / 6) = (L1 * (J2 * t_7) + t_8 * (J2 *
    L2) - (L2 * (J1 * t_8) + t_7 * (J1 * L1))) / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 .
  unnamed.
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem order_of_rk4_17 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_2 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_3 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_4 := J1 * ((L2 * (J3 * t_1) + t_2 * (J3 * L3) - (L3 * (J2 * t_2) + t_1 * (J2 * L2))) * (1 /
    2)) + (- (J1 * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 / 2 *
    (1 / 2) * (J3 * L3)) / 2 * (1 / 2) * (J1 * L1) + (J2 * L2 / 2 * (1 / 2) * (J3 * t_3) + (J2 * t_2
    - J1 * L1 / 2 * (1 / 2) * (J3 * L3) + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 2) * (J3 *
    L3)) in
  let t_5 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_6 := J1 * (L2 * (J3 * t_3) + t_5 * (J3 * L3) - (L3 * (J2 * t_5) + t_3 * (J2 * L2))) + (- (J1
    * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 / 2 * (1 / 2) *
    (J3 * L3)) / 2 * (J1 * L1) + (J2 * L2 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1))) + (J2 * t_5
    - J1 * L1 / 2 * (1 / 2) * (J3 * L3) + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J3 * L3)) in
  let t_7 := (J2 * L2 / 2 * (1 / 2) * (J3 * t_1) - J3 * L3 / 2 * (1 / 2) * (J2 * t_2)) / 2 * (1 / 3)
    + (t_4 - (J3 * L3 / 2 * (1 / 2) * (J2 * t_5) + (J3 * t_1 + J1 * L1 / 2 * (1 / 2) * (J2 * L2) -
    J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 2) * (J2 * L2))) / 2 * (1 / 3) + (t_6 - (J3 * L3 /
    2 * (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3))) + (J3 * t_3 + J1 * L1 / 2 * (1 / 2) * (J2 * L2) -
    J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J2 * L2))) / 2 * (1 / 6) in
  let t_8 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_9 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_10 := J1 * ((L2 * (J3 * t_8) + t_9 * (J3 * L3) - (L3 * (J2 * t_9) + t_8 * (J2 * L2))) / 2) +
    (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 * (J1
    * L1) + (J2 * L2 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1))) + (J2 * t_9 - J1 * L1 / 2 * (J3
    * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 * (J3 * L3)) in
  t_7 = (t_10 - (J3 * L3 / 2 * (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3))) + (J3 * t_8 + J1 * L1 / 2 *
    (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 * (J2 * L2))) / 2 / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 .
  unnamed.
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem order_of_rk4_18 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_2 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_3 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_4 := J2 * ((L3 * (J1 * t_2) + t_1 * (J1 * L1) - (L1 * (J3 * t_1) + t_2 * (J3 * L3))) * (1 /
    2)) + (- (J1 * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 / 2 *
    (1 / 2) * (J3 * L3)) / 2 * (1 / 2) * (J2 * L2) - (J1 * L1 / 2 * (1 / 2) * (J3 * t_3) + (J1 * t_2
    + J2 * L2 / 2 * (1 / 2) * (J3 * L3) - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2 * (1 / 2) * (J3 *
    L3)) in
  let t_5 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_6 := J2 * (L3 * (J1 * t_5) + t_3 * (J1 * L1) - (L1 * (J3 * t_3) + t_5 * (J3 * L3))) + (- (J1
    * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 / 2 * (1 / 2) *
    (J3 * L3)) / 2 * (J2 * L2) - (J1 * L1 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1))) + (J1 * t_5
    + J2 * L2 / 2 * (1 / 2) * (J3 * L3) - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2 * (J3 * L3)) in
  let t_7 := (- (J1 * L1 / 2 * (1 / 2) * (J3 * t_1)) + J3 * L3 / 2 * (1 / 2) * (J1 * t_2)) / 2 * (1
    / 3) + (t_4 + (J3 * L3 / 2 * (1 / 2) * (J1 * t_5) + (J3 * t_1 + J1 * L1 / 2 * (1 / 2) * (J2 *
    L2) - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 2) * (J1 * L1))) / 2 * (1 / 3) + (t_6 + (J3
    * L3 / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (J3 * t_3 + J1 * L1 / 2 * (1 / 2) * (J2 *
    L2) - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J1 * L1))) / 2 * (1 / 6) in
  let t_8 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_9 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_10 := J2 * ((L3 * (J1 * t_8) + t_9 * (J1 * L1) - (L1 * (J3 * t_9) + t_8 * (J3 * L3))) / 2) +
    (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 * (J2
    * L2) - (J1 * L1 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1))) + (J1 * t_8 + J2 * L2 / 2 * (J3
    * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 * (J3 * L3)) in
  t_7 = (t_10 + (J3 * L3 / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (J3 * t_9 + J1 * L1 / 2 *
    (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 * (J1 * L1))) / 2 / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 .
  unnamed.
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem order_of_rk4_19 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_2 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_3 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_4 := J3 * ((L1 * (J2 * t_1) + t_2 * (J2 * L2) - (L2 * (J1 * t_2) + t_1 * (J1 * L1))) * (1 /
    2)) + (- (J1 * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 / 2 *
    (1 / 2) * (J3 * L3)) / 2 * (1 / 2) * (J3 * L3) + (J1 * L1 / 2 * (1 / 2) * (J2 * t_3) + (J1 * t_2
    + J2 * L2 / 2 * (1 / 2) * (J3 * L3) - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2 * (1 / 2) * (J2 *
    L2)) in
  let t_5 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_6 := J3 * (L1 * (J2 * t_3) + t_5 * (J2 * L2) - (L2 * (J1 * t_5) + t_3 * (J1 * L1))) + (- (J1
    * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 / 2 * (1 / 2) *
    (J3 * L3)) / 2 * (J3 * L3) + (J1 * L1 / 2 * (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3))) + (J1 * t_5
    + J2 * L2 / 2 * (1 / 2) * (J3 * L3) - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2 * (J2 * L2)) in
  let t_7 := (J1 * L1 / 2 * (1 / 2) * (J2 * t_1) - J2 * L2 / 2 * (1 / 2) * (J1 * t_2)) / 2 * (1 / 3)
    + (t_4 - (J2 * L2 / 2 * (1 / 2) * (J1 * t_5) + (J2 * t_1 - J1 * L1 / 2 * (1 / 2) * (J3 * L3) +
    J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 2) * (J1 * L1))) / 2 * (1 / 3) + (t_6 - (J2 * L2 /
    2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (J2 * t_3 - J1 * L1 / 2 * (1 / 2) * (J3 * L3) +
    J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J1 * L1))) / 2 * (1 / 6) in
  let t_8 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_9 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_10 := J3 * ((L1 * (J2 * t_8) + t_9 * (J2 * L2) - (L2 * (J1 * t_9) + t_8 * (J1 * L1))) / 2) +
    (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 * (J3
    * L3) + (J1 * L1 / 2 * (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3))) + (J1 * t_9 + J2 * L2 / 2 * (J3
    * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 * (J2 * L2)) in
  t_7 = (t_10 - (J2 * L2 / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (J2 * t_8 - J1 * L1 / 2 *
    (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 * (J1 * L1))) / 2 / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 .
  unnamed.
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem order_of_rk4_20 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := J1 * ((L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2)) in
  let t_2 := J2 * ((L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2)) in
  let t_3 := J3 * ((L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2)) in
  let t_4 := J1 * ((L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2)) in
  let t_5 := J2 * ((L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2)) in
  let t_6 := J3 * ((L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2)) in
  let t_7 := - (J1 * L1 / 2 * (1 / 2) * t_4 + (t_1 + J2 * L2 / 2 * (1 / 2) * (J3 * L3) - J3 * L3 / 2
    * (1 / 2) * (J2 * L2)) / 2 * (1 / 2) * (J1 * L1)) - (J2 * L2 / 2 * (1 / 2) * t_5 + (t_2 - J1 *
    L1 / 2 * (1 / 2) * (J3 * L3) + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (1 / 2) * (J2 * L2)) -
    (J3 * L3 / 2 * (1 / 2) * t_6 + (t_3 + J1 * L1 / 2 * (1 / 2) * (J2 * L2) - J2 * L2 / 2 * (1 / 2)
    * (J1 * L1)) / 2 * (1 / 2) * (J3 * L3)) in
  let t_8 := - (J1 * L1 / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (t_4 + J2 * L2 / 2 * (1 /
    2) * (J3 * L3) - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2 * (J1 * L1)) - (J2 * L2 / 2 * (J2 * (L3
    * (J1 * L1) - L1 * (J3 * L3))) + (t_5 - J1 * L1 / 2 * (1 / 2) * (J3 * L3) + J3 * L3 / 2 * (1 /
    2) * (J1 * L1)) / 2 * (J2 * L2)) in
  let t_9 := - (J1 * L1 / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (J1 * (L2 * (J3 * L3) - L3
    * (J2 * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 * (J1 * L1)) - (J2 *
    L2 / 2 * (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3))) + (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3)) - J1
    * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 * (J2 * L2)) in
  (- (J1 * L1 / 2 * (1 / 2) * t_1) - J2 * L2 / 2 * (1 / 2) * t_2 - J3 * L3 / 2 * (1 / 2) * t_3) / 2
    * (1 / 3) + t_7 / 2 * (1 / 3) + (t_8 - (J3 * L3 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1))) +
    (t_6 + J1 * L1 / 2 * (1 / 2) * (J2 * L2) - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J3 * L3)))
    / 2 * (1 / 6) = (t_9 - (J3 * L3 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1))) + (J3 * (L1 * (J2
    * L2) - L2 * (J1 * L1)) + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 * (J3 *
    L3))) / 2 / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 .
  unnamed.
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem order_of_rk4_21 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_2 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_3 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_4 := (L1 * (J2 * t_1) + t_3 * (J2 * L2) - (L2 * (J1 * t_3) + t_1 * (J1 * L1))) * (1 / 2) in
  let t_5 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_6 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_7 := (L3 * (J1 * t_3) + t_2 * (J1 * L1) - (L1 * (J3 * t_2) + t_3 * (J3 * L3))) * (1 / 2) in
  let t_8 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_9 := L1 * (J2 * t_5) + t_8 * (J2 * L2) - (L2 * (J1 * t_8) + t_5 * (J1 * L1)) in
  let t_10 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_11 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_12 := L3 * (J1 * t_8) + t_6 * (J1 * L1) - (L1 * (J3 * t_6) + t_8 * (J3 * L3)) in
  let t_13 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_14 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_15 := (L1 * (J2 * t_13) + t_14 * (J2 * L2) - (L2 * (J1 * t_14) + t_13 * (J1 * L1))) / 2 in
  let t_16 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_17 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_18 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_19 := (L3 * (J1 * t_14) + t_18 * (J1 * L1) - (L1 * (J3 * t_18) + t_14 * (J3 * L3))) / 2 in
  (t_1 * (J3 * t_2) - t_2 * (J2 * t_1)) * (1 / 3) + (L2 * (J3 * t_4) + t_5 * (J3 * t_6) + t_7 * (J3
    * L3) - (L3 * (J2 * t_7) + t_6 * (J2 * t_5) + t_4 * (J2 * L2))) * (1 / 3) + (L2 * (J3 * t_9) +
    t_10 * (J3 * t_11) + t_12 * (J3 * L3) - (L3 * (J2 * t_12) + t_11 * (J2 * t_10) + t_9 * (J2 *
    L2))) * (1 / 6) = (L2 * (J3 * t_15) + t_16 * (J3 * t_17) + t_19 * (J3 * L3) - (L3 * (J2 * t_19)
    + t_17 * (J2 * t_16) + t_15 * (J2 * L2))) / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 .
  unnamed.
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem order_of_rk4_22 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_2 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_3 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_4 := (L2 * (J3 * t_1) + t_3 * (J3 * L3) - (L3 * (J2 * t_3) + t_1 * (J2 * L2))) * (1 / 2) in
  let t_5 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_6 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_7 := (L1 * (J2 * t_3) + t_2 * (J2 * L2) - (L2 * (J1 * t_2) + t_3 * (J1 * L1))) * (1 / 2) in
  let t_8 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_9 := L2 * (J3 * t_5) + t_8 * (J3 * L3) - (L3 * (J2 * t_8) + t_5 * (J2 * L2)) in
  let t_10 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_11 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_12 := L1 * (J2 * t_8) + t_6 * (J2 * L2) - (L2 * (J1 * t_6) + t_8 * (J1 * L1)) in
  let t_13 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_14 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_15 := (L2 * (J3 * t_13) + t_14 * (J3 * L3) - (L3 * (J2 * t_14) + t_13 * (J2 * L2))) / 2 in
  let t_16 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_17 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_18 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_19 := (L1 * (J2 * t_14) + t_18 * (J2 * L2) - (L2 * (J1 * t_18) + t_14 * (J1 * L1))) / 2 in
  (t_1 * (J1 * t_2) - t_2 * (J3 * t_1)) * (1 / 3) + (L3 * (J1 * t_4) + t_5 * (J1 * t_6) + t_7 * (J1
    * L1) - (L1 * (J3 * t_7) + t_6 * (J3 * t_5) + t_4 * (J3 * L3))) * (1 / 3) + (L3 * (J1 * t_9) +
    t_10 * (J1 * t_11) + t_12 * (J1 * L1) - (L1 * (J3 * t_12) + t_11 * (J3 * t_10) + t_9 * (J3 *
    L3))) * (1 / 6) = (L3 * (J1 * t_15) + t_16 * (J1 * t_17) + t_19 * (J1 * L1) - (L1 * (J3 * t_19)
    + t_17 * (J3 * t_16) + t_15 * (J3 * L3))) / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 .
  unnamed.
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem order_of_rk4_23 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_2 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_3 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_4 := (L3 * (J1 * t_1) + t_3 * (J1 * L1) - (L1 * (J3 * t_3) + t_1 * (J3 * L3))) * (1 / 2) in
  let t_5 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_6 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_7 := (L2 * (J3 * t_3) + t_2 * (J3 * L3) - (L3 * (J2 * t_2) + t_3 * (J2 * L2))) * (1 / 2) in
  let t_8 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_9 := L3 * (J1 * t_5) + t_8 * (J1 * L1) - (L1 * (J3 * t_8) + t_5 * (J3 * L3)) in
  let t_10 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_11 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_12 := L2 * (J3 * t_8) + t_6 * (J3 * L3) - (L3 * (J2 * t_6) + t_8 * (J2 * L2)) in
  let t_13 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_14 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_15 := (L3 * (J1 * t_13) + t_14 * (J1 * L1) - (L1 * (J3 * t_14) + t_13 * (J3 * L3))) / 2 in
  let t_16 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_17 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_18 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_19 := (L2 * (J3 * t_14) + t_18 * (J3 * L3) - (L3 * (J2 * t_18) + t_14 * (J2 * L2))) / 2 in
  (t_1 * (J2 * t_2) - t_2 * (J1 * t_1)) * (1 / 3) + (L1 * (J2 * t_4) + t_5 * (J2 * t_6) + t_7 * (J2
    * L2) - (L2 * (J1 * t_7) + t_6 * (J1 * t_5) + t_4 * (J1 * L1))) * (1 / 3) + (L1 * (J2 * t_9) +
    t_10 * (J2 * t_11) + t_12 * (J2 * L2) - (L2 * (J1 * t_12) + t_11 * (J1 * t_10) + t_9 * (J1 *
    L1))) * (1 / 6) = (L1 * (J2 * t_15) + t_16 * (J2 * t_17) + t_19 * (J2 * L2) - (L2 * (J1 * t_19)
    + t_17 * (J1 * t_16) + t_15 * (J1 * L1))) / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 .
  unnamed.
  field; nonzero.
Qed.

(* the power 5 of the step *)
Theorem order_of_rk4_31 :
  exists J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (- (J1 * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 /
    2 * (1 / 2) * (J3 * L3)) / 2 * (1 / 2) in
  let t_2 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_3 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_4 := (L2 * (J3 * t_2) + t_3 * (J3 * L3) - (L3 * (J2 * t_3) + t_2 * (J2 * L2))) * (1 / 2) in
  let t_5 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_6 := (- (J1 * L1 / 2 * (1 / 2) * (J1 * t_5)) - J2 * L2 / 2 * (1 / 2) * (J2 * t_3) - J3 * L3
    / 2 * (1 / 2) * (J3 * t_2)) / 2 * (1 / 2) in
  let t_7 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_8 := (t_5 * (J2 * t_3) - t_3 * (J1 * t_5)) * (1 / 2) in
  let t_9 := (J2 * t_3 - J1 * L1 / 2 * (1 / 2) * (J3 * L3) + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2
    * (1 / 2) in
  let t_10 := (L1 * (J2 * t_3) + t_5 * (J2 * L2) - (L2 * (J1 * t_5) + t_3 * (J1 * L1))) * (1 / 2) in
  let t_11 := (- (J1 * L1 / 2 * (1 / 2) * (J3 * t_2)) + J3 * L3 / 2 * (1 / 2) * (J1 * t_5)) / 2 * (1
    / 2) in
  let t_12 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_13 := (t_2 * (J1 * t_5) - t_5 * (J3 * t_2)) * (1 / 2) in
  let t_14 := (J3 * t_2 + J1 * L1 / 2 * (1 / 2) * (J2 * L2) - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2
    * (1 / 2) in
  let t_15 := (L3 * (J1 * t_5) + t_2 * (J1 * L1) - (L1 * (J3 * t_2) + t_5 * (J3 * L3))) * (1 / 2) in
  let t_16 := (J1 * L1 / 2 * (1 / 2) * (J2 * t_3) - J2 * L2 / 2 * (1 / 2) * (J1 * t_5)) / 2 * (1 /
    2) in
  let t_17 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_18 := J1 * (L2 * (J3 * t_8) + t_17 * (J3 * t_10) + t_15 * (J3 * t_12) + t_13 * (J3 * L3) -
    (L3 * (J2 * t_13) + t_12 * (J2 * t_15) + t_10 * (J2 * t_17) + t_8 * (J2 * L2))) + (- (J1 * L1 /
    2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 / 2 * (1 / 2) * (J3 *
    L3)) / 2 * (J1 * (L2 * (J3 * t_12) + t_17 * (J3 * L3) - (L3 * (J2 * t_17) + t_12 * (J2 * L2))))
    in
  let t_19 := (J1 * t_5 + J2 * L2 / 2 * (1 / 2) * (J3 * L3) - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2
    * (1 / 2) in
  let t_20 := (J2 * L2 / 2 * (1 / 2) * (J3 * t_2) - J3 * L3 / 2 * (1 / 2) * (J2 * t_3)) / 2 * (1 /
    2) in
  let t_21 := t_18 + (- (J1 * L1 / 2 * (1 / 2) * (J1 * t_7) + t_19 * (J1 * L1)) - (J2 * L2 / 2 * (1
    / 2) * (J2 * t_17) + t_9 * (J2 * L2)) - (J3 * L3 / 2 * (1 / 2) * (J3 * t_12) + t_14 * (J3 *
    L3))) / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (- (J1 * L1 / 2 * (1 / 2) * (J1 * t_4) +
    t_19 * (J1 * t_7) + t_20 * (J1 * L1)) - (J2 * L2 / 2 * (1 / 2) * (J2 * t_15) + t_9 * (J2 * t_17)
    + t_11 * (J2 * L2)) - (J3 * L3 / 2 * (1 / 2) * (J3 * t_10) + t_14 * (J3 * t_12) + t_16 * (J3 *
    L3))) / 2 * (J1 * L1) in
  let t_22 := J2 * L2 / 2 * (J3 * (L1 * (J2 * t_15) + t_7 * (J2 * t_17) + t_4 * (J2 * L2) - (L2 *
    (J1 * t_4) + t_17 * (J1 * t_7) + t_15 * (J1 * L1)))) + (J2 * t_17 - J1 * L1 / 2 * (1 / 2) * (J3
    * L3) + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J3 * (L1 * (J2 * t_17) + t_7 * (J2 * L2) - (L2
    * (J1 * t_7) + t_17 * (J1 * L1)))) + (J2 * t_15 + t_1 * (J2 * L2) - (J1 * L1 / 2 * (1 / 2) * (J3
    * t_12) + t_19 * (J3 * L3)) + (J3 * L3 / 2 * (1 / 2) * (J1 * t_7) + t_14 * (J1 * L1))) / 2 * (J3
    * (L1 * (J2 * L2) - L2 * (J1 * L1))) in
  let t_23 := J3 * L3 / 2 * (J2 * (L3 * (J1 * t_4) + t_12 * (J1 * t_7) + t_10 * (J1 * L1) - (L1 *
    (J3 * t_10) + t_7 * (J3 * t_12) + t_4 * (J3 * L3)))) + (J3 * t_12 + J1 * L1 / 2 * (1 / 2) * (J2
    * L2) - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J2 * (L3 * (J1 * t_7) + t_12 * (J1 * L1) - (L1
    * (J3 * t_12) + t_7 * (J3 * L3)))) + (J3 * t_10 + t_1 * (J3 * L3) + (J1 * L1 / 2 * (1 / 2) * (J2
    * t_17) + t_19 * (J2 * L2)) - (J2 * L2 / 2 * (1 / 2) * (J1 * t_7) + t_9 * (J1 * L1))) / 2 * (J2
    * (L3 * (J1 * L1) - L1 * (J3 * L3))) in
  let t_24 := t_21 + (t_22 + (J2 * t_13 + t_1 * (J2 * t_17) + t_6 * (J2 * L2) - (J1 * L1 / 2 * (1 /
    2) * (J3 * t_10) + t_19 * (J3 * t_12) + t_20 * (J3 * L3)) + (J3 * L3 / 2 * (1 / 2) * (J1 * t_4)
    + t_14 * (J1 * t_7) + t_16 * (J1 * L1))) / 2 * (J3 * L3)) - (t_23 + (J3 * t_8 + t_1 * (J3 *
    t_12) + t_6 * (J3 * L3) + (J1 * L1 / 2 * (1 / 2) * (J2 * t_15) + t_19 * (J2 * t_17) + t_20 * (J2
    * L2)) - (J2 * L2 / 2 * (1 / 2) * (J1 * t_4) + t_9 * (J1 * t_7) + t_11 * (J1 * L1))) / 2 * (J2 *
    L2)) in
  let t_25 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_26 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_27 := (L3 * (J1 * t_25) + t_26 * (J1 * L1) - (L1 * (J3 * t_26) + t_25 * (J3 * L3))) / 2 in
  let t_28 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_29 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_30 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_31 := (L2 * (J3 * t_26) + t_30 * (J3 * L3) - (L3 * (J2 * t_30) + t_26 * (J2 * L2))) / 2 in
  let t_32 := (L1 * (J2 * t_27) + t_28 * (J2 * t_29) + t_31 * (J2 * L2) - (L2 * (J1 * t_31) + t_29 *
    (J1 * t_28) + t_27 * (J1 * L1))) / 3 in
  let t_33 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_34 := (L1 * (J2 * t_29) + t_28 * (J2 * L2) - (L2 * (J1 * t_28) + t_29 * (J1 * L1))) / 2 in
  let t_35 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_36 := (L3 * (J1 * t_28) + t_35 * (J1 * L1) - (L1 * (J3 * t_35) + t_28 * (J3 * L3))) / 2 in
  let t_37 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_38 := (L1 * (J2 * t_30) + t_25 * (J2 * L2) - (L2 * (J1 * t_25) + t_30 * (J1 * L1))) / 2 in
  let t_39 := (L3 * (J1 * t_31) + t_35 * (J1 * t_28) + t_38 * (J1 * L1) - (L1 * (J3 * t_38) + t_28 *
    (J3 * t_35) + t_31 * (J3 * L3))) / 3 in
  let t_40 := J1 * ((L2 * (J3 * t_32) + t_33 * (J3 * t_34) + t_36 * (J3 * t_37) + t_39 * (J3 * L3) -
    (L3 * (J2 * t_39) + t_37 * (J2 * t_36) + t_34 * (J2 * t_33) + t_32 * (J2 * L2))) / 4) + (- (J1 *
    L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 * (J1 * ((L2 *
    (J3 * t_37) + t_33 * (J3 * L3) - (L3 * (J2 * t_33) + t_37 * (J2 * L2))) / 2)) in
  let t_41 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_42 := (J1 * t_28 + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 in
  let t_43 := (J2 * t_29 - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 in
  let t_44 := (J3 * t_35 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 in
  let t_45 := (L2 * (J3 * t_35) + t_29 * (J3 * L3) - (L3 * (J2 * t_29) + t_35 * (J2 * L2))) / 2 in
  let t_46 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2
    / 2 in
  let t_47 := (J2 * t_30 - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 in
  let t_48 := (J3 * t_26 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 in
  let t_49 := (J1 * t_31 + t_46 * (J1 * L1) + (J2 * L2 / 2 * (J3 * t_35) + t_47 * (J3 * L3)) - (J3 *
    L3 / 2 * (J2 * t_29) + t_48 * (J2 * L2))) / 2 / 3 in
  let t_50 := (J1 * t_25 + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 in
  let t_51 := (J2 * t_27 + t_46 * (J2 * L2) - (J1 * L1 / 2 * (J3 * t_35) + t_50 * (J3 * L3)) + (J3 *
    L3 / 2 * (J1 * t_28) + t_48 * (J1 * L1))) / 2 / 3 in
  let t_52 := (J3 * t_38 + t_46 * (J3 * L3) + (J1 * L1 / 2 * (J2 * t_29) + t_50 * (J2 * L2)) - (J2 *
    L2 / 2 * (J1 * t_28) + t_47 * (J1 * L1))) / 2 / 3 in
  let t_53 := t_40 + (- (J1 * L1 / 2 * (J1 * t_41) + t_42 * (J1 * L1)) - (J2 * L2 / 2 * (J2 * t_33)
    + t_43 * (J2 * L2)) - (J3 * L3 / 2 * (J3 * t_37) + t_44 * (J3 * L3))) / 2 / 3 * (J1 * (L2 * (J3
    * L3) - L3 * (J2 * L2))) + (- (J1 * L1 / 2 * (J1 * t_45) + t_42 * (J1 * t_41) + t_49 * (J1 *
    L1)) - (J2 * L2 / 2 * (J2 * t_36) + t_43 * (J2 * t_33) + t_51 * (J2 * L2)) - (J3 * L3 / 2 * (J3
    * t_34) + t_44 * (J3 * t_37) + t_52 * (J3 * L3))) / 2 / 4 * (J1 * L1) in
  let t_54 := J2 * L2 / 2 * (J3 * ((L1 * (J2 * t_36) + t_41 * (J2 * t_33) + t_45 * (J2 * L2) - (L2 *
    (J1 * t_45) + t_33 * (J1 * t_41) + t_36 * (J1 * L1))) / 3)) + (J2 * t_33 - J1 * L1 / 2 * (J3 *
    L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 * (J3 * ((L1 * (J2 * t_33) + t_41 * (J2 * L2) - (L2 * (J1
    * t_41) + t_33 * (J1 * L1))) / 2)) in
  let t_55 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2
    / 2 in
  let t_56 := (- (J1 * L1 / 2 * (J1 * t_28) + t_50 * (J1 * L1)) - (J2 * L2 / 2 * (J2 * t_29) + t_47
    * (J2 * L2)) - (J3 * L3 / 2 * (J3 * t_35) + t_48 * (J3 * L3))) / 2 / 3 in
  let t_57 := t_54 + (J2 * t_36 + t_55 * (J2 * L2) - (J1 * L1 / 2 * (J3 * t_37) + t_42 * (J3 * L3))
    + (J3 * L3 / 2 * (J1 * t_41) + t_44 * (J1 * L1))) / 2 / 3 * (J3 * (L1 * (J2 * L2) - L2 * (J1 *
    L1))) + (J2 * t_39 + t_55 * (J2 * t_33) + t_56 * (J2 * L2) - (J1 * L1 / 2 * (J3 * t_34) + t_42 *
    (J3 * t_37) + t_49 * (J3 * L3)) + (J3 * L3 / 2 * (J1 * t_45) + t_44 * (J1 * t_41) + t_52 * (J1 *
    L1))) / 2 / 4 * (J3 * L3) in
  let t_58 := J3 * L3 / 2 * (J2 * ((L3 * (J1 * t_45) + t_37 * (J1 * t_41) + t_34 * (J1 * L1) - (L1 *
    (J3 * t_34) + t_41 * (J3 * t_37) + t_45 * (J3 * L3))) / 3)) + (J3 * t_37 + J1 * L1 / 2 * (J2 *
    L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 * (J2 * ((L3 * (J1 * t_41) + t_37 * (J1 * L1) - (L1 * (J3
    * t_37) + t_41 * (J3 * L3))) / 2)) in
  let t_59 := t_58 + (J3 * t_34 + t_55 * (J3 * L3) + (J1 * L1 / 2 * (J2 * t_33) + t_42 * (J2 * L2))
    - (J2 * L2 / 2 * (J1 * t_41) + t_43 * (J1 * L1))) / 2 / 3 * (J2 * (L3 * (J1 * L1) - L1 * (J3 *
    L3))) + (J3 * t_32 + t_55 * (J3 * t_37) + t_56 * (J3 * L3) + (J1 * L1 / 2 * (J2 * t_36) + t_42 *
    (J2 * t_33) + t_49 * (J2 * L2)) - (J2 * L2 / 2 * (J1 * t_45) + t_43 * (J1 * t_41) + t_51 * (J1 *
    L1))) / 2 / 4 * (J2 * L2) in
  (t_1 * (J1 * t_4) + t_6 * (J1 * t_7) + (J2 * L2 / 2 * (1 / 2) * (J3 * t_8) + t_9 * (J3 * t_10) +
    t_11 * (J3 * t_12)) - (J3 * L3 / 2 * (1 / 2) * (J2 * t_13) + t_14 * (J2 * t_15) + t_16 * (J2 *
    t_17))) / 2 * (1 / 3) + t_24 / 2 * (1 / 6) <> (t_53 + t_57 - t_59) / 2 / 5.
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  intros t_1; cut_to t_1 (-229 / 16) computed.
  intros t_2; cut_to t_2 (-35 / 2) computed.
  intros t_3; cut_to t_3 18 computed.
  intros t_4; cut_to t_4 101 computed.
  intros t_5; cut_to t_5 (-56) computed.
  intros t_6; cut_to t_6 (315 / 2) computed.
  intros t_7; cut_to t_7 (-56) computed.
  intros t_8; cut_to t_8 2520 computed.
  intros t_9; cut_to t_9 (9 / 2) computed.
  intros t_10; cut_to t_10 935 computed.
  intros t_11; cut_to t_11 (3717 / 16) computed.
  intros t_12; cut_to t_12 (-35 / 2) computed.
  intros t_13; cut_to t_13 4410 computed.
  intros t_14; cut_to t_14 (105 / 8) computed.
  intros t_15; cut_to t_15 (-4347 / 4) computed.
  intros t_16; cut_to t_16 (615 / 4) computed.
  intros t_17; cut_to t_17 18 computed.
  intros t_18; cut_to t_18 (-3483537 / 2) computed.
  intros t_19; cut_to t_19 (-84) computed.
  intros t_20; cut_to t_20 (1167 / 32) computed.
  intros t_21; cut_to t_21 (-9097509 / 4) computed.
  intros t_22; cut_to t_22 (-5941155 / 32) computed.
  intros t_23; cut_to t_23 (-1837431 / 8) computed.
  intros t_24; cut_to t_24 (-71528937 / 32) computed.
  intros t_25; cut_to t_25 (-112) computed.
  intros t_26; cut_to t_26 (-35) computed.
  intros t_27; cut_to t_27 (-4347 / 2) computed.
  intros t_28; cut_to t_28 (-112) computed.
  intros t_29; cut_to t_29 36 computed.
  intros t_30; cut_to t_30 36 computed.
  intros t_31; cut_to t_31 202 computed.
  intros t_32; cut_to t_32 (47915 / 6) computed.
  intros t_33; cut_to t_33 36 computed.
  intros t_34; cut_to t_34 1870 computed.
  intros t_35; cut_to t_35 (-35) computed.
  intros t_36; cut_to t_36 (-4347 / 2) computed.
  intros t_37; cut_to t_37 (-35) computed.
  intros t_38; cut_to t_38 1870 computed.
  intros t_39; cut_to t_39 19794 computed.
  intros t_40; cut_to t_40 (-3411019 / 2) computed.
  intros t_41; cut_to t_41 (-112) computed.
  intros t_42; cut_to t_42 (-168) computed.
  intros t_43; cut_to t_43 9 computed.
  intros t_44; cut_to t_44 (105 / 4) computed.
  intros t_45; cut_to t_45 202 computed.
  intros t_46; cut_to t_46 (-229 / 8) computed.
  intros t_47; cut_to t_47 9 computed.
  intros t_48; cut_to t_48 (105 / 4) computed.
  intros t_49; cut_to t_49 222 computed.
  intros t_50; cut_to t_50 (-168) computed.
  intros t_51; cut_to t_51 (-4123 / 48) computed.
  intros t_52; cut_to t_52 (-2691 / 4) computed.
  intros t_53; cut_to t_53 (-143662147 / 64) computed.
  intros t_54; cut_to t_54 (-537365 / 4) computed.
  intros t_55; cut_to t_55 (-229 / 8) computed.
  intros t_56; cut_to t_56 630 computed.
  intros t_57; cut_to t_57 (-3046381 / 16) computed.
  intros t_58; cut_to t_58 (-1406547 / 8) computed.
  intros t_59; cut_to t_59 (-7611251 / 32) computed.
  computed.
Qed.

(* With said to be 5. *)

(* the power 5 of the step *)
Theorem order_of_rk4_mutant_1 :
  exists J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (- (J1 * L1 / 2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 /
    2 * (1 / 2) * (J3 * L3)) / 2 * (1 / 2) in
  let t_2 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_3 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_4 := (L2 * (J3 * t_2) + t_3 * (J3 * L3) - (L3 * (J2 * t_3) + t_2 * (J2 * L2))) * (1 / 2) in
  let t_5 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_6 := (- (J1 * L1 / 2 * (1 / 2) * (J1 * t_5)) - J2 * L2 / 2 * (1 / 2) * (J2 * t_3) - J3 * L3
    / 2 * (1 / 2) * (J3 * t_2)) / 2 * (1 / 2) in
  let t_7 := (L2 * (J3 * L3) - L3 * (J2 * L2)) * (1 / 2) in
  let t_8 := (t_5 * (J2 * t_3) - t_3 * (J1 * t_5)) * (1 / 2) in
  let t_9 := (J2 * t_3 - J1 * L1 / 2 * (1 / 2) * (J3 * L3) + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2
    * (1 / 2) in
  let t_10 := (L1 * (J2 * t_3) + t_5 * (J2 * L2) - (L2 * (J1 * t_5) + t_3 * (J1 * L1))) * (1 / 2) in
  let t_11 := (- (J1 * L1 / 2 * (1 / 2) * (J3 * t_2)) + J3 * L3 / 2 * (1 / 2) * (J1 * t_5)) / 2 * (1
    / 2) in
  let t_12 := (L1 * (J2 * L2) - L2 * (J1 * L1)) * (1 / 2) in
  let t_13 := (t_2 * (J1 * t_5) - t_5 * (J3 * t_2)) * (1 / 2) in
  let t_14 := (J3 * t_2 + J1 * L1 / 2 * (1 / 2) * (J2 * L2) - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2
    * (1 / 2) in
  let t_15 := (L3 * (J1 * t_5) + t_2 * (J1 * L1) - (L1 * (J3 * t_2) + t_5 * (J3 * L3))) * (1 / 2) in
  let t_16 := (J1 * L1 / 2 * (1 / 2) * (J2 * t_3) - J2 * L2 / 2 * (1 / 2) * (J1 * t_5)) / 2 * (1 /
    2) in
  let t_17 := (L3 * (J1 * L1) - L1 * (J3 * L3)) * (1 / 2) in
  let t_18 := J1 * (L2 * (J3 * t_8) + t_17 * (J3 * t_10) + t_15 * (J3 * t_12) + t_13 * (J3 * L3) -
    (L3 * (J2 * t_13) + t_12 * (J2 * t_15) + t_10 * (J2 * t_17) + t_8 * (J2 * L2))) + (- (J1 * L1 /
    2 * (1 / 2) * (J1 * L1)) - J2 * L2 / 2 * (1 / 2) * (J2 * L2) - J3 * L3 / 2 * (1 / 2) * (J3 *
    L3)) / 2 * (J1 * (L2 * (J3 * t_12) + t_17 * (J3 * L3) - (L3 * (J2 * t_17) + t_12 * (J2 * L2))))
    in
  let t_19 := (J1 * t_5 + J2 * L2 / 2 * (1 / 2) * (J3 * L3) - J3 * L3 / 2 * (1 / 2) * (J2 * L2)) / 2
    * (1 / 2) in
  let t_20 := (J2 * L2 / 2 * (1 / 2) * (J3 * t_2) - J3 * L3 / 2 * (1 / 2) * (J2 * t_3)) / 2 * (1 /
    2) in
  let t_21 := t_18 + (- (J1 * L1 / 2 * (1 / 2) * (J1 * t_7) + t_19 * (J1 * L1)) - (J2 * L2 / 2 * (1
    / 2) * (J2 * t_17) + t_9 * (J2 * L2)) - (J3 * L3 / 2 * (1 / 2) * (J3 * t_12) + t_14 * (J3 *
    L3))) / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (- (J1 * L1 / 2 * (1 / 2) * (J1 * t_4) +
    t_19 * (J1 * t_7) + t_20 * (J1 * L1)) - (J2 * L2 / 2 * (1 / 2) * (J2 * t_15) + t_9 * (J2 * t_17)
    + t_11 * (J2 * L2)) - (J3 * L3 / 2 * (1 / 2) * (J3 * t_10) + t_14 * (J3 * t_12) + t_16 * (J3 *
    L3))) / 2 * (J1 * L1) in
  let t_22 := J2 * L2 / 2 * (J3 * (L1 * (J2 * t_15) + t_7 * (J2 * t_17) + t_4 * (J2 * L2) - (L2 *
    (J1 * t_4) + t_17 * (J1 * t_7) + t_15 * (J1 * L1)))) + (J2 * t_17 - J1 * L1 / 2 * (1 / 2) * (J3
    * L3) + J3 * L3 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J3 * (L1 * (J2 * t_17) + t_7 * (J2 * L2) - (L2
    * (J1 * t_7) + t_17 * (J1 * L1)))) + (J2 * t_15 + t_1 * (J2 * L2) - (J1 * L1 / 2 * (1 / 2) * (J3
    * t_12) + t_19 * (J3 * L3)) + (J3 * L3 / 2 * (1 / 2) * (J1 * t_7) + t_14 * (J1 * L1))) / 2 * (J3
    * (L1 * (J2 * L2) - L2 * (J1 * L1))) in
  let t_23 := J3 * L3 / 2 * (J2 * (L3 * (J1 * t_4) + t_12 * (J1 * t_7) + t_10 * (J1 * L1) - (L1 *
    (J3 * t_10) + t_7 * (J3 * t_12) + t_4 * (J3 * L3)))) + (J3 * t_12 + J1 * L1 / 2 * (1 / 2) * (J2
    * L2) - J2 * L2 / 2 * (1 / 2) * (J1 * L1)) / 2 * (J2 * (L3 * (J1 * t_7) + t_12 * (J1 * L1) - (L1
    * (J3 * t_12) + t_7 * (J3 * L3)))) + (J3 * t_10 + t_1 * (J3 * L3) + (J1 * L1 / 2 * (1 / 2) * (J2
    * t_17) + t_19 * (J2 * L2)) - (J2 * L2 / 2 * (1 / 2) * (J1 * t_7) + t_9 * (J1 * L1))) / 2 * (J2
    * (L3 * (J1 * L1) - L1 * (J3 * L3))) in
  let t_24 := t_21 + (t_22 + (J2 * t_13 + t_1 * (J2 * t_17) + t_6 * (J2 * L2) - (J1 * L1 / 2 * (1 /
    2) * (J3 * t_10) + t_19 * (J3 * t_12) + t_20 * (J3 * L3)) + (J3 * L3 / 2 * (1 / 2) * (J1 * t_4)
    + t_14 * (J1 * t_7) + t_16 * (J1 * L1))) / 2 * (J3 * L3)) - (t_23 + (J3 * t_8 + t_1 * (J3 *
    t_12) + t_6 * (J3 * L3) + (J1 * L1 / 2 * (1 / 2) * (J2 * t_15) + t_19 * (J2 * t_17) + t_20 * (J2
    * L2)) - (J2 * L2 / 2 * (1 / 2) * (J1 * t_4) + t_9 * (J1 * t_7) + t_11 * (J1 * L1))) / 2 * (J2 *
    L2)) in
  let t_25 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_26 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_27 := (L3 * (J1 * t_25) + t_26 * (J1 * L1) - (L1 * (J3 * t_26) + t_25 * (J3 * L3))) / 2 in
  let t_28 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_29 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_30 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_31 := (L2 * (J3 * t_26) + t_30 * (J3 * L3) - (L3 * (J2 * t_30) + t_26 * (J2 * L2))) / 2 in
  let t_32 := (L1 * (J2 * t_27) + t_28 * (J2 * t_29) + t_31 * (J2 * L2) - (L2 * (J1 * t_31) + t_29 *
    (J1 * t_28) + t_27 * (J1 * L1))) / 3 in
  let t_33 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_34 := (L1 * (J2 * t_29) + t_28 * (J2 * L2) - (L2 * (J1 * t_28) + t_29 * (J1 * L1))) / 2 in
  let t_35 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_36 := (L3 * (J1 * t_28) + t_35 * (J1 * L1) - (L1 * (J3 * t_35) + t_28 * (J3 * L3))) / 2 in
  let t_37 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_38 := (L1 * (J2 * t_30) + t_25 * (J2 * L2) - (L2 * (J1 * t_25) + t_30 * (J1 * L1))) / 2 in
  let t_39 := (L3 * (J1 * t_31) + t_35 * (J1 * t_28) + t_38 * (J1 * L1) - (L1 * (J3 * t_38) + t_28 *
    (J3 * t_35) + t_31 * (J3 * L3))) / 3 in
  let t_40 := J1 * ((L2 * (J3 * t_32) + t_33 * (J3 * t_34) + t_36 * (J3 * t_37) + t_39 * (J3 * L3) -
    (L3 * (J2 * t_39) + t_37 * (J2 * t_36) + t_34 * (J2 * t_33) + t_32 * (J2 * L2))) / 4) + (- (J1 *
    L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 * (J1 * ((L2 *
    (J3 * t_37) + t_33 * (J3 * L3) - (L3 * (J2 * t_33) + t_37 * (J2 * L2))) / 2)) in
  let t_41 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_42 := (J1 * t_28 + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 in
  let t_43 := (J2 * t_29 - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 in
  let t_44 := (J3 * t_35 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 in
  let t_45 := (L2 * (J3 * t_35) + t_29 * (J3 * L3) - (L3 * (J2 * t_29) + t_35 * (J2 * L2))) / 2 in
  let t_46 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2
    / 2 in
  let t_47 := (J2 * t_30 - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 in
  let t_48 := (J3 * t_26 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 in
  let t_49 := (J1 * t_31 + t_46 * (J1 * L1) + (J2 * L2 / 2 * (J3 * t_35) + t_47 * (J3 * L3)) - (J3 *
    L3 / 2 * (J2 * t_29) + t_48 * (J2 * L2))) / 2 / 3 in
  let t_50 := (J1 * t_25 + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 in
  let t_51 := (J2 * t_27 + t_46 * (J2 * L2) - (J1 * L1 / 2 * (J3 * t_35) + t_50 * (J3 * L3)) + (J3 *
    L3 / 2 * (J1 * t_28) + t_48 * (J1 * L1))) / 2 / 3 in
  let t_52 := (J3 * t_38 + t_46 * (J3 * L3) + (J1 * L1 / 2 * (J2 * t_29) + t_50 * (J2 * L2)) - (J2 *
    L2 / 2 * (J1 * t_28) + t_47 * (J1 * L1))) / 2 / 3 in
  let t_53 := t_40 + (- (J1 * L1 / 2 * (J1 * t_41) + t_42 * (J1 * L1)) - (J2 * L2 / 2 * (J2 * t_33)
    + t_43 * (J2 * L2)) - (J3 * L3 / 2 * (J3 * t_37) + t_44 * (J3 * L3))) / 2 / 3 * (J1 * (L2 * (J3
    * L3) - L3 * (J2 * L2))) + (- (J1 * L1 / 2 * (J1 * t_45) + t_42 * (J1 * t_41) + t_49 * (J1 *
    L1)) - (J2 * L2 / 2 * (J2 * t_36) + t_43 * (J2 * t_33) + t_51 * (J2 * L2)) - (J3 * L3 / 2 * (J3
    * t_34) + t_44 * (J3 * t_37) + t_52 * (J3 * L3))) / 2 / 4 * (J1 * L1) in
  let t_54 := J2 * L2 / 2 * (J3 * ((L1 * (J2 * t_36) + t_41 * (J2 * t_33) + t_45 * (J2 * L2) - (L2 *
    (J1 * t_45) + t_33 * (J1 * t_41) + t_36 * (J1 * L1))) / 3)) + (J2 * t_33 - J1 * L1 / 2 * (J3 *
    L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 * (J3 * ((L1 * (J2 * t_33) + t_41 * (J2 * L2) - (L2 * (J1
    * t_41) + t_33 * (J1 * L1))) / 2)) in
  let t_55 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2
    / 2 in
  let t_56 := (- (J1 * L1 / 2 * (J1 * t_28) + t_50 * (J1 * L1)) - (J2 * L2 / 2 * (J2 * t_29) + t_47
    * (J2 * L2)) - (J3 * L3 / 2 * (J3 * t_35) + t_48 * (J3 * L3))) / 2 / 3 in
  let t_57 := t_54 + (J2 * t_36 + t_55 * (J2 * L2) - (J1 * L1 / 2 * (J3 * t_37) + t_42 * (J3 * L3))
    + (J3 * L3 / 2 * (J1 * t_41) + t_44 * (J1 * L1))) / 2 / 3 * (J3 * (L1 * (J2 * L2) - L2 * (J1 *
    L1))) + (J2 * t_39 + t_55 * (J2 * t_33) + t_56 * (J2 * L2) - (J1 * L1 / 2 * (J3 * t_34) + t_42 *
    (J3 * t_37) + t_49 * (J3 * L3)) + (J3 * L3 / 2 * (J1 * t_45) + t_44 * (J1 * t_41) + t_52 * (J1 *
    L1))) / 2 / 4 * (J3 * L3) in
  let t_58 := J3 * L3 / 2 * (J2 * ((L3 * (J1 * t_45) + t_37 * (J1 * t_41) + t_34 * (J1 * L1) - (L1 *
    (J3 * t_34) + t_41 * (J3 * t_37) + t_45 * (J3 * L3))) / 3)) + (J3 * t_37 + J1 * L1 / 2 * (J2 *
    L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 * (J2 * ((L3 * (J1 * t_41) + t_37 * (J1 * L1) - (L1 * (J3
    * t_37) + t_41 * (J3 * L3))) / 2)) in
  let t_59 := t_58 + (J3 * t_34 + t_55 * (J3 * L3) + (J1 * L1 / 2 * (J2 * t_33) + t_42 * (J2 * L2))
    - (J2 * L2 / 2 * (J1 * t_41) + t_43 * (J1 * L1))) / 2 / 3 * (J2 * (L3 * (J1 * L1) - L1 * (J3 *
    L3))) + (J3 * t_32 + t_55 * (J3 * t_37) + t_56 * (J3 * L3) + (J1 * L1 / 2 * (J2 * t_36) + t_42 *
    (J2 * t_33) + t_49 * (J2 * L2)) - (J2 * L2 / 2 * (J1 * t_45) + t_43 * (J1 * t_41) + t_51 * (J1 *
    L1))) / 2 / 4 * (J2 * L2) in
  (t_1 * (J1 * t_4) + t_6 * (J1 * t_7) + (J2 * L2 / 2 * (1 / 2) * (J3 * t_8) + t_9 * (J3 * t_10) +
    t_11 * (J3 * t_12)) - (J3 * L3 / 2 * (1 / 2) * (J2 * t_13) + t_14 * (J2 * t_15) + t_16 * (J2 *
    t_17))) / 2 * (1 / 3) + t_24 / 2 * (1 / 6) <> (t_53 + t_57 - t_59) / 2 / 5.
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  intros t_1; cut_to t_1 (-229 / 16) computed.
  intros t_2; cut_to t_2 (-35 / 2) computed.
  intros t_3; cut_to t_3 18 computed.
  intros t_4; cut_to t_4 101 computed.
  intros t_5; cut_to t_5 (-56) computed.
  intros t_6; cut_to t_6 (315 / 2) computed.
  intros t_7; cut_to t_7 (-56) computed.
  intros t_8; cut_to t_8 2520 computed.
  intros t_9; cut_to t_9 (9 / 2) computed.
  intros t_10; cut_to t_10 935 computed.
  intros t_11; cut_to t_11 (3717 / 16) computed.
  intros t_12; cut_to t_12 (-35 / 2) computed.
  intros t_13; cut_to t_13 4410 computed.
  intros t_14; cut_to t_14 (105 / 8) computed.
  intros t_15; cut_to t_15 (-4347 / 4) computed.
  intros t_16; cut_to t_16 (615 / 4) computed.
  intros t_17; cut_to t_17 18 computed.
  intros t_18; cut_to t_18 (-3483537 / 2) computed.
  intros t_19; cut_to t_19 (-84) computed.
  intros t_20; cut_to t_20 (1167 / 32) computed.
  intros t_21; cut_to t_21 (-9097509 / 4) computed.
  intros t_22; cut_to t_22 (-5941155 / 32) computed.
  intros t_23; cut_to t_23 (-1837431 / 8) computed.
  intros t_24; cut_to t_24 (-71528937 / 32) computed.
  intros t_25; cut_to t_25 (-112) computed.
  intros t_26; cut_to t_26 (-35) computed.
  intros t_27; cut_to t_27 (-4347 / 2) computed.
  intros t_28; cut_to t_28 (-112) computed.
  intros t_29; cut_to t_29 36 computed.
  intros t_30; cut_to t_30 36 computed.
  intros t_31; cut_to t_31 202 computed.
  intros t_32; cut_to t_32 (47915 / 6) computed.
  intros t_33; cut_to t_33 36 computed.
  intros t_34; cut_to t_34 1870 computed.
  intros t_35; cut_to t_35 (-35) computed.
  intros t_36; cut_to t_36 (-4347 / 2) computed.
  intros t_37; cut_to t_37 (-35) computed.
  intros t_38; cut_to t_38 1870 computed.
  intros t_39; cut_to t_39 19794 computed.
  intros t_40; cut_to t_40 (-3411019 / 2) computed.
  intros t_41; cut_to t_41 (-112) computed.
  intros t_42; cut_to t_42 (-168) computed.
  intros t_43; cut_to t_43 9 computed.
  intros t_44; cut_to t_44 (105 / 4) computed.
  intros t_45; cut_to t_45 202 computed.
  intros t_46; cut_to t_46 (-229 / 8) computed.
  intros t_47; cut_to t_47 9 computed.
  intros t_48; cut_to t_48 (105 / 4) computed.
  intros t_49; cut_to t_49 222 computed.
  intros t_50; cut_to t_50 (-168) computed.
  intros t_51; cut_to t_51 (-4123 / 48) computed.
  intros t_52; cut_to t_52 (-2691 / 4) computed.
  intros t_53; cut_to t_53 (-143662147 / 64) computed.
  intros t_54; cut_to t_54 (-537365 / 4) computed.
  intros t_55; cut_to t_55 (-229 / 8) computed.
  intros t_56; cut_to t_56 630 computed.
  intros t_57; cut_to t_57 (-3046381 / 16) computed.
  intros t_58; cut_to t_58 (-1406547 / 8) computed.
  intros t_59; cut_to t_59 (-7611251 / 32) computed.
  computed.
Qed.

(* With said to be 3. *)

(* With the step a hundredth longer. *)

(* the power 1 of the step *)
Theorem order_of_rk4_mutant_3 :
  exists J1 L1 : R,
  J1 * L1 / 2 * (101 / 600) + J1 * L1 / 2 * (101 / 300) + J1 * L1 / 2 * (101 / 300) + J1 * L1 / 2 *
    (101 / 600) <> J1 * L1 / 2.
Proof.
  exists 6, 1.
  computed.
Qed.

(* With a single slope, as in Euler's method. *)

(* the power 2 of the step *)
Theorem order_of_rk4_mutant_4 :
  exists J1 J2 J3 L2 L3 : R,
  0 <> (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2))
    / 2 / 2.
Proof.
  exists 6, 1, (-3), 1, 7.
  computed.
Qed.


(** the-engine-s-law: The law that the right engine integrates, with the momentum in the world, is the one in the body: the same attitude to h⁴ for every body, the momentum being carried out by it. *)

(* the power 0 of the step *)
Theorem the_engine_s_law_1 :
  forall J1 L1 : R,
  J1 <> 0 ->
  1 / J1 * (J1 * L1) = L1.
Proof.
  intros J1 L1   D_1.
  field; nonzero.
Qed.

(* the power 0 of the step *)
Theorem the_engine_s_law_2 :
  forall J2 L2 : R,
  J2 <> 0 ->
  1 / J2 * (J2 * L2) = L2.
Proof.
  intros J2 L2   D_1.
  field; nonzero.
Qed.

(* the power 0 of the step *)
Theorem the_engine_s_law_3 :
  forall J3 L3 : R,
  J3 <> 0 ->
  1 / J3 * (J3 * L3) = L3.
Proof.
  intros J3 L3   D_1.
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem the_engine_s_law_4 :
  forall J1 L1 : R,
  J1 * L1 / 2 = J1 * L1 / 2.
Proof.
  intros J1 L1   .
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem the_engine_s_law_5 :
  forall J2 L2 : R,
  J2 * L2 / 2 = J2 * L2 / 2.
Proof.
  intros J2 L2   .
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem the_engine_s_law_6 :
  forall J3 L3 : R,
  J3 * L3 / 2 = J3 * L3 / 2.
Proof.
  intros J3 L3   .
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem the_engine_s_law_7 :
  forall J1 J2 J3 L2 L3 : R,
  let t_1 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_2 := J3 * L3 / 2 + J3 * L3 / 2 in
  J1 <> 0 ->
  1 / J1 * (t_1 * (J3 * L3) + (t_2 * (J2 * L2) + (((J2 * L2 / 2 + J2 * L2 / 2) * J3 + J1 * t_1) * L3
    + ((- (J3 * L3 / 2) - J3 * L3 / 2) * J2 + J1 * t_2) * L2))) = L2 * (J3 * L3) - L3 * (J2 * L2).
Proof.
  intros J1 J2 J3 L2 L3  t_1 t_2 D_1.
  unnamed.
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem the_engine_s_law_8 :
  forall J1 J2 J3 L1 L3 : R,
  let t_1 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_2 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  J2 <> 0 ->
  1 / J2 * (t_1 * (J3 * L3) + (((- (J1 * L1 / 2) - J1 * L1 / 2) * J3 + J2 * t_1) * L3 + (J2 * t_2 +
    (J3 * L3 / 2 + J3 * L3 / 2) * J1) * L1 + t_2 * (J1 * L1))) = L3 * (J1 * L1) - L1 * (J3 * L3).
Proof.
  intros J1 J2 J3 L1 L3  t_1 t_2 D_1.
  unnamed.
  field; nonzero.
Qed.

(* the power 1 of the step *)
Theorem the_engine_s_law_9 :
  forall J1 J2 J3 L1 L2 : R,
  J3 <> 0 ->
  1 / J3 * ((J3 * (- (J1 * L1 / 2) - J1 * L1 / 2) + (J1 * L1 / 2 + J1 * L1 / 2) * J2) * L2 + (J3 *
    (J2 * L2 / 2 + J2 * L2 / 2) + (- (J2 * L2 / 2) - J2 * L2 / 2) * J1) * L1) = L1 * (J2 * L2) - L2
    * (J1 * L1).
Proof.
  intros J1 J2 J3 L1 L2   D_1.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem the_engine_s_law_10 :
  forall J1 J2 J3 L2 L3 : R,
  let t_1 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_2 := J3 * L3 / 2 + J3 * L3 / 2 in
  (t_1 * (J3 * L3) + (t_2 * (J2 * L2) + (((J2 * L2 / 2 + J2 * L2 / 2) * J3 + J1 * t_1) * L3 + ((-
    (J3 * L3 / 2) - J3 * L3 / 2) * J2 + J1 * t_2) * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 *
    (J2 * L2)) / 2 / 2 = (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3
    / 2 * (J2 * L2)) / 2 / 2.
Proof.
  intros J1 J2 J3 L2 L3  t_1 t_2 .
  unnamed.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem the_engine_s_law_11 :
  forall J1 J2 J3 L1 L3 : R,
  let t_1 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_2 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  (t_1 * (J3 * L3) + (((- (J1 * L1 / 2) - J1 * L1 / 2) * J3 + J2 * t_1) * L3 + (J2 * t_2 + (J3 * L3
    / 2 + J3 * L3 / 2) * J1) * L1 + t_2 * (J1 * L1)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 *
    L1)) / 2 / 2 = (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 *
    (J1 * L1)) / 2 / 2.
Proof.
  intros J1 J2 J3 L1 L3  t_1 t_2 .
  unnamed.
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem the_engine_s_law_12 :
  forall J1 J2 J3 L1 L2 : R,
  ((J3 * (- (J1 * L1 / 2) - J1 * L1 / 2) + (J1 * L1 / 2 + J1 * L1 / 2) * J2) * L2 + (J3 * (J2 * L2 /
    2 + J2 * L2 / 2) + (- (J2 * L2 / 2) - J2 * L2 / 2) * J1) * L1 + J1 * L1 / 2 * (J2 * L2) - J2 *
    L2 / 2 * (J1 * L1)) / 2 / 2 = (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1)) + J1 * L1 / 2 * (J2 * L2)
    - J2 * L2 / 2 * (J1 * L1)) / 2 / 2.
Proof.
  intros J1 J2 J3 L1 L2   .
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem the_engine_s_law_13 :
  forall J1 J2 J3 L1 L2 L3 : R,
  (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 = (- (J1
    * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3   .
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem the_engine_s_law_14 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_2 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_3 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_4 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_5 := J1 * L1 / 2 * (J3 * L3 / 2) in
  let t_6 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_7 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_8 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_9 := (t_6 * (J3 * L3) + ((t_7 * J3 + J2 * t_6) * L3 + (J2 * t_8 + (J3 * L3 / 2 + J3 * L3 /
    2) * J1) * L1 + t_8 * (J1 * L1)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 in
  let t_10 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_11 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_12 := J1 * L1 / 2 * (J2 * L2 / 2) in
  let t_13 := ((J3 * t_7 + t_6 * J2) * L2 + (J3 * (J2 * L2 / 2 + J2 * L2 / 2) + (- (J2 * L2 / 2) -
    J2 * L2 / 2) * J1) * L1 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 in
  let t_14 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2
    / 2 in
  let t_15 := t_14 + t_14 + J1 * L1 / 2 * (J1 * L1 / 2) - J2 * L2 / 2 * (J2 * L2 / 2) - J3 * L3 / 2
    * (J3 * L3 / 2) in
  let t_16 := t_10 * ((t_2 * J3 + J2 * t_3) * L3 + (J2 * t_11 + t_10 * J1) * L1) + (t_12 + t_13 +
    (t_12 + t_13)) * (J2 * L2) + (((t_5 + t_9 + (t_5 + t_9)) * J3 + (t_11 * J2 * t_3 + J1 * (t_5 -
    t_9 + (t_5 - t_9)))) * L3 + ((t_4 * J3 * t_2 + ((t_12 - t_13 + (t_12 - t_13)) * J2 + J1 * (t_12
    + t_13 + (t_12 + t_13)))) * L2 + (t_4 * J3 * t_4 + (t_11 * J2 * t_11 + (J1 * t_15 + t_15 * J1)))
    * L1) + t_15 * (J1 * L1)) in
  let t_17 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_18 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  J1 <> 0 ->
  1 / J1 * (t_1 * ((J3 * t_2 + t_3 * J2) * L2 + (J3 * t_4 + t_1 * J1) * L1) + (t_5 - t_9 + (t_5 -
    t_9)) * (J3 * L3) + t_16) = (L2 * (J3 * t_17) + t_18 * (J3 * L3) - (L3 * (J2 * t_18) + t_17 *
    (J2 * L2))) / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 D_1.
  cut_to t_1 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_2 (- (J1 * L1)) ltac:(field; nonzero).
  cut_to t_3 (J1 * L1) ltac:(field; nonzero).
  cut_to t_4 (J2 * L2) ltac:(field; nonzero).
  cut_to t_5 ((1 / 4) * J1 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_6 (J1 * L1) ltac:(field; nonzero).
  cut_to t_7 (- (J1 * L1)) ltac:(field; nonzero).
  cut_to t_8 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_9 ((1 / 4) * J1 * J2 * L1 * L3 - (1 / 4) * J2 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_10 (J3 * L3) ltac:(field; nonzero).
  cut_to t_11 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_12 ((1 / 4) * J1 * J2 * L1 * L2) ltac:(field; nonzero).
  cut_to t_13 (- ((1 / 4) * J1 * J3 * L1 * L2) + (1 / 4) * J2 * J3 * L1 * L2) ltac:(field; nonzero).
  cut_to t_14 (- ((1 / 8) * J1 ^ 2 * L1 ^ 2) - (1 / 8) * J2 ^ 2 * L2 ^ 2 - (1 / 8) * J3 ^ 2 * L3 ^
    2) ltac:(field; nonzero).
  cut_to t_15 (- ((1 / 2) * J2 ^ 2 * L2 ^ 2) - (1 / 2) * J3 ^ 2 * L3 ^ 2) ltac:(field; nonzero).
  cut_to t_16 ((1 / 2) * J1 ^ 2 * J2 * L1 * L2 ^ 2 - (1 / 2) * J1 ^ 2 * J2 * L1 * L3 ^ 2 - (1 / 2) *
    J1 ^ 2 * J3 * L1 * L2 ^ 2 + (1 / 2) * J1 ^ 2 * J3 * L1 * L3 ^ 2 - (1 / 2) * J1 * J2 ^ 2 * L1 *
    L2 ^ 2 - (1 / 2) * J1 * J2 * J3 * L1 * L2 ^ 2 + J1 * J2 * J3 * L1 * L3 ^ 2 - J1 * J3 ^ 2 * L1 *
    L3 ^ 2 + J2 ^ 2 * J3 * L1 * L2 ^ 2 - (1 / 2) * J2 * J3 ^ 2 * L1 * L3 ^ 2) ltac:(field; nonzero).
  cut_to t_17 (- (J1 * L1 * L2) + J2 * L1 * L2) ltac:(field; nonzero).
  cut_to t_18 (J1 * L1 * L3 - J3 * L1 * L3) ltac:(field; nonzero).
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem the_engine_s_law_15 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_2 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_3 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_4 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_5 := J2 * L2 / 2 * (J3 * L3 / 2) in
  let t_6 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_7 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_8 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_9 := (t_6 * (J3 * L3) + (t_7 * (J2 * L2) + ((t_8 * J3 + J1 * t_6) * L3 + ((- (J3 * L3 / 2) -
    J3 * L3 / 2) * J2 + J1 * t_7) * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 /
    2 in
  let t_10 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_11 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2
    / 2 in
  let t_12 := t_11 + t_11 - J1 * L1 / 2 * (J1 * L1 / 2) + J2 * L2 / 2 * (J2 * L2 / 2) - J3 * L3 / 2
    * (J3 * L3 / 2) in
  let t_13 := J1 * L1 / 2 * (J2 * L2 / 2) in
  let t_14 := ((J3 * (- (J1 * L1 / 2) - J1 * L1 / 2) + (J1 * L1 / 2 + J1 * L1 / 2) * J2) * L2 + (J3
    * t_8 + t_6 * J1) * L1 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 in
  let t_15 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_16 := ((t_5 - t_9 + (t_5 - t_9)) * J3 + (J2 * (t_5 + t_9 + (t_5 + t_9)) + t_10 * J1 * t_4))
    * L3 + ((t_2 * J3 * t_2 + (J2 * t_12 + t_12 * J2 + t_10 * J1 * t_10)) * L2 + (t_2 * J3 * t_3 +
    (J2 * (t_13 - t_14 + (t_13 - t_14)) + (t_13 + t_14 + (t_13 + t_14)) * J1)) * L1) + t_12 * (J2 *
    L2) + (t_15 * ((t_3 * J3 + J1 * t_4) * L3 + (t_15 * J2 + J1 * t_10) * L2) + (t_13 - t_14 + (t_13
    - t_14)) * (J1 * L1)) in
  let t_17 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_18 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  J2 <> 0 ->
  1 / J2 * (t_1 * ((J3 * t_2 + t_1 * J2) * L2 + (J3 * t_3 + t_4 * J1) * L1) + (t_5 + t_9 + (t_5 +
    t_9)) * (J3 * L3) + t_16) = (L3 * (J1 * t_17) + t_18 * (J1 * L1) - (L1 * (J3 * t_18) + t_17 *
    (J3 * L3))) / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 D_1.
  cut_to t_1 (J1 * L1) ltac:(field; nonzero).
  cut_to t_2 (- (J1 * L1)) ltac:(field; nonzero).
  cut_to t_3 (J2 * L2) ltac:(field; nonzero).
  cut_to t_4 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_5 ((1 / 4) * J2 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_6 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_7 (J3 * L3) ltac:(field; nonzero).
  cut_to t_8 (J2 * L2) ltac:(field; nonzero).
  cut_to t_9 (- ((1 / 4) * J1 * J2 * L2 * L3) + (1 / 4) * J1 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_10 (J3 * L3) ltac:(field; nonzero).
  cut_to t_11 (- ((1 / 8) * J1 ^ 2 * L1 ^ 2) - (1 / 8) * J2 ^ 2 * L2 ^ 2 - (1 / 8) * J3 ^ 2 * L3 ^
    2) ltac:(field; nonzero).
  cut_to t_12 (- ((1 / 2) * J1 ^ 2 * L1 ^ 2) - (1 / 2) * J3 ^ 2 * L3 ^ 2) ltac:(field; nonzero).
  cut_to t_13 ((1 / 4) * J1 * J2 * L1 * L2) ltac:(field; nonzero).
  cut_to t_14 (- ((1 / 4) * J1 * J3 * L1 * L2) + (1 / 4) * J2 * J3 * L1 * L2) ltac:(field; nonzero).
  cut_to t_15 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_16 (- ((1 / 2) * J1 ^ 2 * J2 * L1 ^ 2 * L2) + J1 ^ 2 * J3 * L1 ^ 2 * L2 + (1 / 2) * J1 *
    J2 ^ 2 * L1 ^ 2 * L2 - (1 / 2) * J1 * J2 ^ 2 * L2 * L3 ^ 2 - (1 / 2) * J1 * J2 * J3 * L1 ^ 2 *
    L2 + J1 * J2 * J3 * L2 * L3 ^ 2 - (1 / 2) * J1 * J3 ^ 2 * L2 * L3 ^ 2 - (1 / 2) * J2 ^ 2 * J3 *
    L1 ^ 2 * L2 + (1 / 2) * J2 ^ 2 * J3 * L2 * L3 ^ 2 - J2 * J3 ^ 2 * L2 * L3 ^ 2) ltac:(field;
    nonzero).
  cut_to t_17 (- (J2 * L2 * L3) + J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_18 (- (J1 * L1 * L2) + J2 * L1 * L2) ltac:(field; nonzero).
  field; nonzero.
Qed.

(* the power 2 of the step *)
Theorem the_engine_s_law_16 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 /
    2 in
  let t_2 := t_1 + t_1 - J1 * L1 / 2 * (J1 * L1 / 2) - J2 * L2 / 2 * (J2 * L2 / 2) + J3 * L3 / 2 *
    (J3 * L3 / 2) in
  let t_3 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_4 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_5 := J2 * L2 / 2 * (J3 * L3 / 2) in
  let t_6 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_7 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_8 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_9 := (t_6 * (J3 * L3) + (t_7 * (J2 * L2) + (((J2 * L2 / 2 + J2 * L2 / 2) * J3 + J1 * t_6) *
    L3 + (t_8 * J2 + J1 * t_7) * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2
    in
  let t_10 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_11 := J1 * L1 / 2 * (J3 * L3 / 2) in
  let t_12 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_13 := (t_12 * (J3 * L3) + (((- (J1 * L1 / 2) - J1 * L1 / 2) * J3 + J2 * t_12) * L3 + (J2 *
    t_8 + t_7 * J1) * L1 + t_8 * (J1 * L1)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2
    / 2 in
  let t_14 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_15 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_16 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_17 := (J3 * t_2 + t_2 * J3 + (t_3 * J2 * t_3 + t_4 * J1 * t_4)) * L3 + ((J3 * (t_5 - t_9 +
    (t_5 - t_9)) + ((t_5 + t_9 + (t_5 + t_9)) * J2 + t_4 * J1 * t_10)) * L2 + (J3 * (t_11 + t_13 +
    (t_11 + t_13)) + (t_3 * J2 * t_14 + (t_11 - t_13 + (t_11 - t_13)) * J1)) * L1) + t_2 * (J3 * L3)
    + (t_15 * ((t_15 * J3 + J2 * t_3) * L3 + (J2 * t_14 + t_10 * J1) * L1) + (t_5 - t_9 + (t_5 -
    t_9)) * (J2 * L2) + (t_16 * ((t_16 * J3 + J1 * t_4) * L3 + (t_14 * J2 + J1 * t_10) * L2) + (t_11
    + t_13 + (t_11 + t_13)) * (J1 * L1))) in
  let t_18 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_19 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  J3 <> 0 ->
  1 / J3 * t_17 = (L1 * (J2 * t_18) + t_19 * (J2 * L2) - (L2 * (J1 * t_19) + t_18 * (J1 * L1))) / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 D_1.
  cut_to t_1 (- ((1 / 8) * J1 ^ 2 * L1 ^ 2) - (1 / 8) * J2 ^ 2 * L2 ^ 2 - (1 / 8) * J3 ^ 2 * L3 ^ 2)
    ltac:(field; nonzero).
  cut_to t_2 (- ((1 / 2) * J1 ^ 2 * L1 ^ 2) - (1 / 2) * J2 ^ 2 * L2 ^ 2) ltac:(field; nonzero).
  cut_to t_3 (J1 * L1) ltac:(field; nonzero).
  cut_to t_4 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_5 ((1 / 4) * J2 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_6 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_7 (J3 * L3) ltac:(field; nonzero).
  cut_to t_8 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_9 (- ((1 / 4) * J1 * J2 * L2 * L3) + (1 / 4) * J1 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_10 (J3 * L3) ltac:(field; nonzero).
  cut_to t_11 ((1 / 4) * J1 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_12 (J1 * L1) ltac:(field; nonzero).
  cut_to t_13 ((1 / 4) * J1 * J2 * L1 * L3 - (1 / 4) * J2 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_14 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_15 (- (J1 * L1)) ltac:(field; nonzero).
  cut_to t_16 (J2 * L2) ltac:(field; nonzero).
  cut_to t_17 (- ((1 / 2) * J1 ^ 2 * J3 * L1 ^ 2 * L3) + (1 / 2) * J1 * J2 * J3 * L1 ^ 2 * L3 + (1 /
    2) * J1 * J2 * J3 * L2 ^ 2 * L3 + (1 / 2) * J1 * J3 ^ 2 * L1 ^ 2 * L3 - (1 / 2) * J1 * J3 ^ 2 *
    L2 ^ 2 * L3 - (1 / 2) * J2 ^ 2 * J3 * L2 ^ 2 * L3 - (1 / 2) * J2 * J3 ^ 2 * L1 ^ 2 * L3 + (1 /
    2) * J2 * J3 ^ 2 * L2 ^ 2 * L3) ltac:(field; nonzero).
  cut_to t_18 (J1 * L1 * L3 - J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_19 (- (J2 * L2 * L3) + J3 * L2 * L3) ltac:(field; nonzero).
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem the_engine_s_law_17 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_2 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_3 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_4 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_5 := (J3 * t_2 + t_3 * J2) * L2 + (J3 * t_4 + t_1 * J1) * L1 in
  let t_6 := J1 * L1 / 2 * (J3 * L3 / 2) in
  let t_7 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_8 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_9 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_10 := (t_7 * (J3 * L3) + ((t_8 * J3 + J2 * t_7) * L3 + (J2 * t_9 + (J3 * L3 / 2 + J3 * L3 /
    2) * J1) * L1 + t_9 * (J1 * L1)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 in
  let t_11 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_12 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_13 := (t_2 * J3 + J2 * t_3) * L3 + (J2 * t_12 + t_11 * J1) * L1 in
  let t_14 := J1 * L1 / 2 * (J2 * L2 / 2) in
  let t_15 := ((J3 * t_8 + t_7 * J2) * L2 + (J3 * (J2 * L2 / 2 + J2 * L2 / 2) + (- (J2 * L2 / 2) -
    J2 * L2 / 2) * J1) * L1 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 in
  let t_16 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2
    / 2 in
  let t_17 := t_16 + t_16 + J1 * L1 / 2 * (J1 * L1 / 2) - J2 * L2 / 2 * (J2 * L2 / 2) - J3 * L3 / 2
    * (J3 * L3 / 2) in
  let t_18 := t_1 * t_5 + (t_6 - t_10 + (t_6 - t_10)) * (J3 * L3) + (t_11 * t_13 + (t_14 + t_15 +
    (t_14 + t_15)) * (J2 * L2) + (((t_6 + t_10 + (t_6 + t_10)) * J3 + (t_12 * J2 * t_3 + J1 * (t_6 -
    t_10 + (t_6 - t_10)))) * L3 + ((t_4 * J3 * t_2 + ((t_14 - t_15 + (t_14 - t_15)) * J2 + J1 *
    (t_14 + t_15 + (t_14 + t_15)))) * L2 + (t_4 * J3 * t_4 + (t_12 * J2 * t_12 + (J1 * t_17 + t_17 *
    J1))) * L1) + t_17 * (J1 * L1))) in
  let t_19 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_20 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_21 := J1 * ((L2 * (J3 * t_19) + t_20 * (J3 * L3) - (L3 * (J2 * t_20) + t_19 * (J2 * L2))) /
    2) + (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 *
    (J1 * L1) + (J2 * L2 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1))) + (J2 * t_20 - J1 * L1 / 2 *
    (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 * (J3 * L3)) in
  (t_18 + t_16 * (J1 * L1) + (J2 * L2 / 2 * t_5 + t_10 * (J3 * L3)) - (J3 * L3 / 2 * (t_3 * (J3 *
    L3) + (t_13 + t_12 * (J1 * L1))) + t_15 * (J2 * L2))) / 2 / 3 = (t_21 - (J3 * L3 / 2 * (J2 * (L3
    * (J1 * L1) - L1 * (J3 * L3))) + (J3 * t_19 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1))
    / 2 / 2 * (J2 * L2))) / 2 / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 .
  cut_to t_1 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_2 (- (J1 * L1)) ltac:(field; nonzero).
  cut_to t_3 (J1 * L1) ltac:(field; nonzero).
  cut_to t_4 (J2 * L2) ltac:(field; nonzero).
  cut_to t_5 (- (J1 * J3 * L1 * L2) + J2 * J3 * L1 * L2) ltac:(field; nonzero).
  cut_to t_6 ((1 / 4) * J1 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_7 (J1 * L1) ltac:(field; nonzero).
  cut_to t_8 (- (J1 * L1)) ltac:(field; nonzero).
  cut_to t_9 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_10 ((1 / 4) * J1 * J2 * L1 * L3 - (1 / 4) * J2 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_11 (J3 * L3) ltac:(field; nonzero).
  cut_to t_12 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_13 (J1 * J2 * L1 * L3 - J2 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_14 ((1 / 4) * J1 * J2 * L1 * L2) ltac:(field; nonzero).
  cut_to t_15 (- ((1 / 4) * J1 * J3 * L1 * L2) + (1 / 4) * J2 * J3 * L1 * L2) ltac:(field; nonzero).
  cut_to t_16 (- ((1 / 8) * J1 ^ 2 * L1 ^ 2) - (1 / 8) * J2 ^ 2 * L2 ^ 2 - (1 / 8) * J3 ^ 2 * L3 ^
    2) ltac:(field; nonzero).
  cut_to t_17 (- ((1 / 2) * J2 ^ 2 * L2 ^ 2) - (1 / 2) * J3 ^ 2 * L3 ^ 2) ltac:(field; nonzero).
  cut_to t_18 ((1 / 2) * J1 ^ 2 * J2 * L1 * L2 ^ 2 - (1 / 2) * J1 ^ 2 * J2 * L1 * L3 ^ 2 - (1 / 2) *
    J1 ^ 2 * J3 * L1 * L2 ^ 2 + (1 / 2) * J1 ^ 2 * J3 * L1 * L3 ^ 2 - (1 / 2) * J1 * J2 ^ 2 * L1 *
    L2 ^ 2 + (1 / 2) * J1 * J2 * J3 * L1 * L2 ^ 2 + (1 / 2) * J1 * J2 * J3 * L1 * L3 ^ 2 - (1 / 2) *
    J1 * J3 ^ 2 * L1 * L3 ^ 2) ltac:(field; nonzero).
  cut_to t_19 (- (J1 * L1 * L2) + J2 * L1 * L2) ltac:(field; nonzero).
  cut_to t_20 (J1 * L1 * L3 - J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_21 (- ((1 / 8) * J1 ^ 3 * L1 ^ 3) + (1 / 2) * J1 ^ 2 * J2 * L1 * L2 ^ 2 - (1 / 2) * J1 ^
    2 * J2 * L1 * L3 ^ 2 - (1 / 2) * J1 ^ 2 * J3 * L1 * L2 ^ 2 + (1 / 2) * J1 ^ 2 * J3 * L1 * L3 ^ 2
    - (5 / 8) * J1 * J2 ^ 2 * L1 * L2 ^ 2 + (3 / 4) * J1 * J2 * J3 * L1 * L3 ^ 2 - (5 / 8) * J1 * J3
    ^ 2 * L1 * L3 ^ 2 + (1 / 2) * J2 ^ 2 * J3 * L1 * L2 ^ 2 - (1 / 4) * J2 * J3 ^ 2 * L1 * L3 ^ 2)
    ltac:(field; nonzero).
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem the_engine_s_law_18 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_2 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_3 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_4 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_5 := (J3 * t_2 + t_1 * J2) * L2 + (J3 * t_3 + t_4 * J1) * L1 in
  let t_6 := J2 * L2 / 2 * (J3 * L3 / 2) in
  let t_7 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_8 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_9 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_10 := (t_7 * (J3 * L3) + (t_8 * (J2 * L2) + ((t_9 * J3 + J1 * t_7) * L3 + ((- (J3 * L3 / 2)
    - J3 * L3 / 2) * J2 + J1 * t_8) * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2
    / 2 in
  let t_11 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_12 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2
    / 2 in
  let t_13 := t_12 + t_12 - J1 * L1 / 2 * (J1 * L1 / 2) + J2 * L2 / 2 * (J2 * L2 / 2) - J3 * L3 / 2
    * (J3 * L3 / 2) in
  let t_14 := J1 * L1 / 2 * (J2 * L2 / 2) in
  let t_15 := ((J3 * (- (J1 * L1 / 2) - J1 * L1 / 2) + (J1 * L1 / 2 + J1 * L1 / 2) * J2) * L2 + (J3
    * t_9 + t_7 * J1) * L1 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1)) / 2 / 2 in
  let t_16 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_17 := (t_3 * J3 + J1 * t_4) * L3 + (t_16 * J2 + J1 * t_11) * L2 in
  let t_18 := t_1 * t_5 + (t_6 + t_10 + (t_6 + t_10)) * (J3 * L3) + (((t_6 - t_10 + (t_6 - t_10)) *
    J3 + (J2 * (t_6 + t_10 + (t_6 + t_10)) + t_11 * J1 * t_4)) * L3 + ((t_2 * J3 * t_2 + (J2 * t_13
    + t_13 * J2 + t_11 * J1 * t_11)) * L2 + (t_2 * J3 * t_3 + (J2 * (t_14 - t_15 + (t_14 - t_15)) +
    (t_14 + t_15 + (t_14 + t_15)) * J1)) * L1) + t_13 * (J2 * L2) + (t_16 * t_17 + (t_14 - t_15 +
    (t_14 - t_15)) * (J1 * L1))) in
  let t_19 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_20 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_21 := J2 * ((L3 * (J1 * t_19) + t_20 * (J1 * L1) - (L1 * (J3 * t_20) + t_19 * (J3 * L3))) /
    2) + (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 *
    (J2 * L2) - (J1 * L1 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1))) + (J1 * t_19 + J2 * L2 / 2 *
    (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 * (J3 * L3)) in
  (t_18 + t_12 * (J2 * L2) - (J1 * L1 / 2 * t_5 + t_10 * (J3 * L3)) + (J3 * L3 / 2 * (t_4 * (J3 *
    L3) + (t_11 * (J2 * L2) + t_17)) + t_15 * (J1 * L1))) / 2 / 3 = (t_21 + (J3 * L3 / 2 * (J1 * (L2
    * (J3 * L3) - L3 * (J2 * L2))) + (J3 * t_20 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1))
    / 2 / 2 * (J1 * L1))) / 2 / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 .
  cut_to t_1 (J1 * L1) ltac:(field; nonzero).
  cut_to t_2 (- (J1 * L1)) ltac:(field; nonzero).
  cut_to t_3 (J2 * L2) ltac:(field; nonzero).
  cut_to t_4 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_5 (- (J1 * J3 * L1 * L2) + J2 * J3 * L1 * L2) ltac:(field; nonzero).
  cut_to t_6 ((1 / 4) * J2 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_7 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_8 (J3 * L3) ltac:(field; nonzero).
  cut_to t_9 (J2 * L2) ltac:(field; nonzero).
  cut_to t_10 (- ((1 / 4) * J1 * J2 * L2 * L3) + (1 / 4) * J1 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_11 (J3 * L3) ltac:(field; nonzero).
  cut_to t_12 (- ((1 / 8) * J1 ^ 2 * L1 ^ 2) - (1 / 8) * J2 ^ 2 * L2 ^ 2 - (1 / 8) * J3 ^ 2 * L3 ^
    2) ltac:(field; nonzero).
  cut_to t_13 (- ((1 / 2) * J1 ^ 2 * L1 ^ 2) - (1 / 2) * J3 ^ 2 * L3 ^ 2) ltac:(field; nonzero).
  cut_to t_14 ((1 / 4) * J1 * J2 * L1 * L2) ltac:(field; nonzero).
  cut_to t_15 (- ((1 / 4) * J1 * J3 * L1 * L2) + (1 / 4) * J2 * J3 * L1 * L2) ltac:(field; nonzero).
  cut_to t_16 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_17 (- (J1 * J2 * L2 * L3) + J1 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_18 (- ((1 / 2) * J1 ^ 2 * J2 * L1 ^ 2 * L2) + (1 / 2) * J1 * J2 ^ 2 * L1 ^ 2 * L2 - (1 /
    2) * J1 * J2 ^ 2 * L2 * L3 ^ 2 + (1 / 2) * J1 * J2 * J3 * L1 ^ 2 * L2 + (1 / 2) * J1 * J2 * J3 *
    L2 * L3 ^ 2 - (1 / 2) * J2 ^ 2 * J3 * L1 ^ 2 * L2 + (1 / 2) * J2 ^ 2 * J3 * L2 * L3 ^ 2 - (1 /
    2) * J2 * J3 ^ 2 * L2 * L3 ^ 2) ltac:(field; nonzero).
  cut_to t_19 (- (J2 * L2 * L3) + J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_20 (- (J1 * L1 * L2) + J2 * L1 * L2) ltac:(field; nonzero).
  cut_to t_21 (- ((5 / 8) * J1 ^ 2 * J2 * L1 ^ 2 * L2) + (1 / 2) * J1 ^ 2 * J3 * L1 ^ 2 * L2 + (1 /
    2) * J1 * J2 ^ 2 * L1 ^ 2 * L2 - (1 / 2) * J1 * J2 ^ 2 * L2 * L3 ^ 2 + (3 / 4) * J1 * J2 * J3 *
    L2 * L3 ^ 2 - (1 / 4) * J1 * J3 ^ 2 * L2 * L3 ^ 2 - (1 / 8) * J2 ^ 3 * L2 ^ 3 - (1 / 2) * J2 ^ 2
    * J3 * L1 ^ 2 * L2 + (1 / 2) * J2 ^ 2 * J3 * L2 * L3 ^ 2 - (5 / 8) * J2 * J3 ^ 2 * L2 * L3 ^ 2)
    ltac:(field; nonzero).
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem the_engine_s_law_19 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 /
    2 in
  let t_2 := t_1 + t_1 - J1 * L1 / 2 * (J1 * L1 / 2) - J2 * L2 / 2 * (J2 * L2 / 2) + J3 * L3 / 2 *
    (J3 * L3 / 2) in
  let t_3 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_4 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_5 := J2 * L2 / 2 * (J3 * L3 / 2) in
  let t_6 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_7 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_8 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_9 := (t_6 * (J3 * L3) + (t_7 * (J2 * L2) + (((J2 * L2 / 2 + J2 * L2 / 2) * J3 + J1 * t_6) *
    L3 + (t_8 * J2 + J1 * t_7) * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2
    in
  let t_10 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_11 := J1 * L1 / 2 * (J3 * L3 / 2) in
  let t_12 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_13 := (t_12 * (J3 * L3) + (((- (J1 * L1 / 2) - J1 * L1 / 2) * J3 + J2 * t_12) * L3 + (J2 *
    t_8 + t_7 * J1) * L1 + t_8 * (J1 * L1)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2
    / 2 in
  let t_14 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_15 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_16 := (t_15 * J3 + J2 * t_3) * L3 + (J2 * t_14 + t_10 * J1) * L1 in
  let t_17 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_18 := (t_17 * J3 + J1 * t_4) * L3 + (t_14 * J2 + J1 * t_10) * L2 in
  let t_19 := (J3 * t_2 + t_2 * J3 + (t_3 * J2 * t_3 + t_4 * J1 * t_4)) * L3 + ((J3 * (t_5 - t_9 +
    (t_5 - t_9)) + ((t_5 + t_9 + (t_5 + t_9)) * J2 + t_4 * J1 * t_10)) * L2 + (J3 * (t_11 + t_13 +
    (t_11 + t_13)) + (t_3 * J2 * t_14 + (t_11 - t_13 + (t_11 - t_13)) * J1)) * L1) + t_2 * (J3 * L3)
    + (t_15 * t_16 + (t_5 - t_9 + (t_5 - t_9)) * (J2 * L2) + (t_17 * t_18 + (t_11 + t_13 + (t_11 +
    t_13)) * (J1 * L1))) in
  let t_20 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  let t_21 := L2 * (J3 * L3) - L3 * (J2 * L2) in
  let t_22 := J3 * ((L1 * (J2 * t_20) + t_21 * (J2 * L2) - (L2 * (J1 * t_21) + t_20 * (J1 * L1))) /
    2) + (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 / 2 *
    (J3 * L3) + (J1 * L1 / 2 * (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3))) + (J1 * t_21 + J2 * L2 / 2 *
    (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 * (J2 * L2)) in
  (t_19 + t_1 * (J3 * L3) + (J1 * L1 / 2 * (t_3 * (J3 * L3) + (t_16 + t_14 * (J1 * L1))) + t_9 * (J2
    * L2)) - (J2 * L2 / 2 * (t_4 * (J3 * L3) + (t_10 * (J2 * L2) + t_18)) + t_13 * (J1 * L1))) / 2 /
    3 = (t_22 - (J2 * L2 / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (J2 * t_20 - J1 * L1 / 2 *
    (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 * (J1 * L1))) / 2 / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 .
  cut_to t_1 (- ((1 / 8) * J1 ^ 2 * L1 ^ 2) - (1 / 8) * J2 ^ 2 * L2 ^ 2 - (1 / 8) * J3 ^ 2 * L3 ^ 2)
    ltac:(field; nonzero).
  cut_to t_2 (- ((1 / 2) * J1 ^ 2 * L1 ^ 2) - (1 / 2) * J2 ^ 2 * L2 ^ 2) ltac:(field; nonzero).
  cut_to t_3 (J1 * L1) ltac:(field; nonzero).
  cut_to t_4 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_5 ((1 / 4) * J2 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_6 (- (J2 * L2)) ltac:(field; nonzero).
  cut_to t_7 (J3 * L3) ltac:(field; nonzero).
  cut_to t_8 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_9 (- ((1 / 4) * J1 * J2 * L2 * L3) + (1 / 4) * J1 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_10 (J3 * L3) ltac:(field; nonzero).
  cut_to t_11 ((1 / 4) * J1 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_12 (J1 * L1) ltac:(field; nonzero).
  cut_to t_13 ((1 / 4) * J1 * J2 * L1 * L3 - (1 / 4) * J2 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_14 (- (J3 * L3)) ltac:(field; nonzero).
  cut_to t_15 (- (J1 * L1)) ltac:(field; nonzero).
  cut_to t_16 (J1 * J2 * L1 * L3 - J2 * J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_17 (J2 * L2) ltac:(field; nonzero).
  cut_to t_18 (- (J1 * J2 * L2 * L3) + J1 * J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_19 (- ((1 / 2) * J1 ^ 2 * J3 * L1 ^ 2 * L3) + (1 / 2) * J1 * J2 * J3 * L1 ^ 2 * L3 + (1 /
    2) * J1 * J2 * J3 * L2 ^ 2 * L3 + (1 / 2) * J1 * J3 ^ 2 * L1 ^ 2 * L3 - (1 / 2) * J1 * J3 ^ 2 *
    L2 ^ 2 * L3 - (1 / 2) * J2 ^ 2 * J3 * L2 ^ 2 * L3 - (1 / 2) * J2 * J3 ^ 2 * L1 ^ 2 * L3 + (1 /
    2) * J2 * J3 ^ 2 * L2 ^ 2 * L3) ltac:(field; nonzero).
  cut_to t_20 (J1 * L1 * L3 - J3 * L1 * L3) ltac:(field; nonzero).
  cut_to t_21 (- (J2 * L2 * L3) + J3 * L2 * L3) ltac:(field; nonzero).
  cut_to t_22 ((1 / 2) * J1 ^ 2 * J2 * L1 ^ 2 * L3 - (5 / 8) * J1 ^ 2 * J3 * L1 ^ 2 * L3 - (1 / 4) *
    J1 * J2 ^ 2 * L2 ^ 2 * L3 + (3 / 4) * J1 * J2 * J3 * L2 ^ 2 * L3 + (1 / 2) * J1 * J3 ^ 2 * L1 ^
    2 * L3 - (1 / 2) * J1 * J3 ^ 2 * L2 ^ 2 * L3 - (5 / 8) * J2 ^ 2 * J3 * L2 ^ 2 * L3 - (1 / 2) *
    J2 * J3 ^ 2 * L1 ^ 2 * L3 + (1 / 2) * J2 * J3 ^ 2 * L2 ^ 2 * L3 - (1 / 8) * J3 ^ 3 * L3 ^ 3)
    ltac:(field; nonzero).
  field; nonzero.
Qed.

(* the power 3 of the step *)
Theorem the_engine_s_law_20 :
  forall J1 J2 J3 L1 L2 L3 : R,
  let t_1 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_2 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_3 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_4 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_5 := - (J2 * L2 / 2) - J2 * L2 / 2 in
  let t_6 := J3 * L3 / 2 + J3 * L3 / 2 in
  let t_7 := J2 * L2 / 2 + J2 * L2 / 2 in
  let t_8 := - (J3 * L3 / 2) - J3 * L3 / 2 in
  let t_9 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_10 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_11 := J1 * L1 / 2 + J1 * L1 / 2 in
  let t_12 := - (J1 * L1 / 2) - J1 * L1 / 2 in
  let t_13 := - (J1 * L1 / 2 * (t_1 * (J3 * L3) + (t_2 * (J2 * L2) + ((t_3 * J3 + J1 * t_1) * L3 +
    (t_4 * J2 + J1 * t_2) * L2))) + (t_5 * (J3 * L3) + (t_6 * (J2 * L2) + ((t_7 * J3 + J1 * t_5) *
    L3 + (t_8 * J2 + J1 * t_6) * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 *
    (J1 * L1)) - (J2 * L2 / 2 * (t_9 * (J3 * L3) + ((t_10 * J3 + J2 * t_9) * L3 + (J2 * t_4 + t_2 *
    J1) * L1 + t_4 * (J1 * L1))) + (t_11 * (J3 * L3) + ((t_12 * J3 + J2 * t_11) * L3 + (J2 * t_8 +
    t_6 * J1) * L1 + t_8 * (J1 * L1)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 *
    (J2 * L2)) in
  let t_14 := - (J1 * L1 / 2 * (J1 * (L2 * (J3 * L3) - L3 * (J2 * L2))) + (J1 * (L2 * (J3 * L3) - L3
    * (J2 * L2)) + J2 * L2 / 2 * (J3 * L3) - J3 * L3 / 2 * (J2 * L2)) / 2 / 2 * (J1 * L1)) - (J2 *
    L2 / 2 * (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3))) + (J2 * (L3 * (J1 * L1) - L1 * (J3 * L3)) - J1
    * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 / 2 * (J2 * L2)) in
  (t_13 - (J3 * L3 / 2 * ((J3 * t_10 + t_9 * J2) * L2 + (J3 * t_3 + t_1 * J1) * L1) + ((J3 * t_12 +
    t_11 * J2) * L2 + (J3 * t_7 + t_5 * J1) * L1 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 *
    L1)) / 2 / 2 * (J3 * L3))) / 2 / 3 = (t_14 - (J3 * L3 / 2 * (J3 * (L1 * (J2 * L2) - L2 * (J1 *
    L1))) + (J3 * (L1 * (J2 * L2) - L2 * (J1 * L1)) + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 *
    L1)) / 2 / 2 * (J3 * L3))) / 2 / 3.
Proof.
  intros J1 J2 J3 L1 L2 L3  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 .
  unnamed.
  field; nonzero.
Qed.

(* With the frozen tensor. *)

(* the power 2 of the step *)
Theorem the_engine_s_law_mutant_1 :
  exists J1 J2 J3 L1 L2 L3 : R,
  let t_1 := J2 * (1 / J3 * (J3 * L3) * (J1 * L1) - 1 / J1 * (J1 * L1) * (J3 * L3)) in
  let t_2 := J1 * L1 / 2 * (J3 * L3 / 2) - ((J1 * L1 / 2 + J1 * L1 / 2) * (J3 * L3) + (t_1 + (- (J3
    * L3 / 2) - J3 * L3 / 2) * (J1 * L1)) - J1 * L1 / 2 * (J3 * L3) + J3 * L3 / 2 * (J1 * L1)) / 2 /
    2 in
  let t_3 := J3 * (1 / J1 * (J1 * L1) * (J2 * L2) - 1 / J2 * (J2 * L2) * (J1 * L1)) in
  let t_4 := J1 * L1 / 2 * (J2 * L2 / 2) + (t_3 + J1 * L1 / 2 * (J2 * L2) - J2 * L2 / 2 * (J1 * L1))
    / 2 / 2 in
  let t_5 := (- (J1 * L1 / 2 * (J1 * L1)) - J2 * L2 / 2 * (J2 * L2) - J3 * L3 / 2 * (J3 * L3)) / 2 /
    2 in
  let t_6 := (J3 * L3 / 2 + J3 * L3 / 2) * (J2 * (1 / J3 * (J3 * L3) * (J1 * L1) - 1 / J1 * (J1 *
    L1) * (J3 * L3))) + (t_4 + t_4) * (J2 * L2) + (J1 * (1 / J2 * (J2 * L2) * t_3 + 1 / J2 * t_1 *
    (J3 * L3) - (1 / J3 * (J3 * L3) * t_1 + 1 / J3 * t_3 * (J2 * L2))) / 2 + (t_5 + t_5 + J1 * L1 /
    2 * (J1 * L1 / 2) - J2 * L2 / 2 * (J2 * L2 / 2) - J3 * L3 / 2 * (J3 * L3 / 2)) * (J1 * L1)) in
  let t_7 := L1 * (J2 * L2) - L2 * (J1 * L1) in
  let t_8 := L3 * (J1 * L1) - L1 * (J3 * L3) in
  J1 <> 0 /\
  J2 <> 0 /\
  J3 <> 0 /\
  1 / J1 * ((- (J2 * L2 / 2) - J2 * L2 / 2) * (J3 * (1 / J1 * (J1 * L1) * (J2 * L2) - 1 / J2 * (J2 *
    L2) * (J1 * L1))) + (t_2 + t_2) * (J3 * L3) + t_6) <> (L2 * (J3 * t_7) + t_8 * (J3 * L3) - (L3 *
    (J2 * t_8) + t_7 * (J2 * L2))) / 2.
Proof.
  exists 6, 1, (-3), 1, 7, 4.
  intros t_1; cut_to t_1 36 computed.
  intros t_2; cut_to t_2 (-27) computed.
  intros t_3; cut_to t_3 105 computed.
  intros t_4; cut_to t_4 (147 / 4) computed.
  intros t_5; cut_to t_5 (-229 / 8) computed.
  intros t_6; cut_to t_6 (1431 / 2) computed.
  intros t_7; cut_to t_7 (-35) computed.
  intros t_8; cut_to t_8 36 computed.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** position-stage-keeps-energy: The turn of the position stage leaves the energy as it was, for every body, spin, time step, pace and weight b. *)

(* the energy gained *)
Theorem position_stage_keeps_energy_1 :
  forall I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 : R,
  Q1 ^ 2 = - (I1 ^ 2 * I2 * I3 * h ^ 2 * s1 ^ 2) + I1 * I2 ^ 2 * I3 * h ^ 2 * s1 ^ 2 + I1 * I2 * I3
    ^ 2 * h ^ 2 * s1 ^ 2 - I2 ^ 2 * I3 ^ 2 * h ^ 2 * s1 ^ 2 + X ->
  Q2 ^ 2 = I1 ^ 2 * I2 * I3 * h ^ 2 * s2 ^ 2 - I1 ^ 2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 - I1 * I2 ^ 2 * I3 *
    h ^ 2 * s2 ^ 2 + I1 * I2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 + X ->
  Q3 ^ 2 = - (I1 ^ 2 * I2 ^ 2 * h ^ 2 * s3 ^ 2) + I1 ^ 2 * I2 * I3 * h ^ 2 * s3 ^ 2 + I1 * I2 ^ 2 *
    I3 * h ^ 2 * s3 ^ 2 - I1 * I2 * I3 ^ 2 * h ^ 2 * s3 ^ 2 + X ->
  let t_1 := (I3 - I1) / I2 * (I1 * I2 * s3 * h) in
  let t_2 := I3 * I1 * s2 * (X + Q3 * Q1) + t_1 * (I2 * I3 * s1) * Q2 in
  let t_3 := (I1 - I2) / I3 * (I2 * I3 * s1 * h) in
  let t_4 := I1 * I2 * s3 * (X + Q1 * Q2) + t_3 * (I3 * I1 * s2) * Q3 in
  let t_5 := (1 + I1 * b) * ((I2 - I3) / I1 * (t_2 * h * t_4)) / (1 + I1 * b) in
  let t_6 := (I2 - I3) / I1 * (I3 * I1 * s2 * h) in
  let t_7 := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + t_6 * t_1 * t_3)) in
  let t_8 := I2 * I3 * s1 * (X + Q2 * Q3) + t_6 * (I1 * I2 * s3) * Q1 in
  let t_9 := (1 + I2 * b) * ((I3 - I1) / I2 * (t_4 * h * t_8)) / (1 + I2 * b) in
  let t_10 := (1 + I3 * b) * ((I1 - I2) / I3 * (t_8 * h * t_2)) / (1 + I3 * b) in
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  1 + I1 * b <> 0 ->
  1 + I2 * b <> 0 ->
  1 + I3 * b <> 0 ->
  (t_5 * (I1 * (I2 * I3 * s1 * t_7 + t_5 + I2 * I3 * s1 * t_7)) + t_9 * (I2 * (I3 * I1 * s2 * t_7 +
    t_9 + I3 * I1 * s2 * t_7)) + t_10 * (I3 * (I1 * I2 * s3 * t_7 + t_10 + I1 * I2 * s3 * t_7))) / 2
    = 0.
Proof.
  intros I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 H_1 H_2 H_3 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 D_1
    D_2 D_3 D_4 D_5 D_6.
  unnamed.
  field [H_1 H_2 H_3]; nonzero.
Qed.

(* With one moment larger in the energy. *)

(* the energy gained *)
Theorem position_stage_keeps_energy_mutant_1 :
  exists I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 : R,
  Q1 ^ 2 = - (I1 ^ 2 * I2 * I3 * h ^ 2 * s1 ^ 2) + I1 * I2 ^ 2 * I3 * h ^ 2 * s1 ^ 2 + I1 * I2 * I3
    ^ 2 * h ^ 2 * s1 ^ 2 - I2 ^ 2 * I3 ^ 2 * h ^ 2 * s1 ^ 2 + X /\
  Q2 ^ 2 = I1 ^ 2 * I2 * I3 * h ^ 2 * s2 ^ 2 - I1 ^ 2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 - I1 * I2 ^ 2 * I3 *
    h ^ 2 * s2 ^ 2 + I1 * I2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 + X /\
  Q3 ^ 2 = - (I1 ^ 2 * I2 ^ 2 * h ^ 2 * s3 ^ 2) + I1 ^ 2 * I2 * I3 * h ^ 2 * s3 ^ 2 + I1 * I2 ^ 2 *
    I3 * h ^ 2 * s3 ^ 2 - I1 * I2 * I3 ^ 2 * h ^ 2 * s3 ^ 2 + X /\
  let t_1 := (I3 - I1) / I2 * (I1 * I2 * s3 * h) in
  let t_2 := I3 * I1 * s2 * (X + Q3 * Q1) + t_1 * (I2 * I3 * s1) * Q2 in
  let t_3 := (I1 - I2) / I3 * (I2 * I3 * s1 * h) in
  let t_4 := I1 * I2 * s3 * (X + Q1 * Q2) + t_3 * (I3 * I1 * s2) * Q3 in
  let t_5 := (1 + I1 * b) * ((I2 - I3) / I1 * (t_2 * h * t_4)) / (1 + I1 * b) in
  let t_6 := (I2 - I3) / I1 * (I3 * I1 * s2 * h) in
  let t_7 := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + t_6 * t_1 * t_3)) in
  let t_8 := I2 * I3 * s1 * (X + Q2 * Q3) + t_6 * (I1 * I2 * s3) * Q1 in
  let t_9 := (1 + I2 * b) * ((I3 - I1) / I2 * (t_4 * h * t_8)) / (1 + I2 * b) in
  let t_10 := (1 + I3 * b) * ((I1 - I2) / I3 * (t_8 * h * t_2)) / (1 + I3 * b) in
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  1 + I1 * b <> 0 /\
  1 + I2 * b <> 0 /\
  1 + I3 * b <> 0 /\
  (t_5 * (I1 * (I2 * I3 * s1 * t_7 + t_5 + I2 * I3 * s1 * t_7)) + t_9 * (I2 * (I3 * I1 * s2 * t_7 +
    t_9 + I3 * I1 * s2 * t_7)) + t_10 * ((I3 + 1) * (I1 * I2 * s3 * t_7 + t_10 + I1 * I2 * s3 *
    t_7))) / 2 <> 0.
Proof.
  exists (-2 / 3), (-5 / 6), (5 / 6), (sqrt (6023 / 5184)), (sqrt (28441 / 23328)), (sqrt (1799 /
    2592)), (7 / 6), (-1), (1 / 2), (-1 / 3), (7 / 6), (-7 / 6).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* With a root of another pace. *)

(* the energy gained *)
Theorem position_stage_keeps_energy_mutant_2 :
  exists I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 : R,
  Q1 ^ 2 = - (I1 ^ 2 * I2 * I3 * h ^ 2 * s1 ^ 2) + I1 * I2 ^ 2 * I3 * h ^ 2 * s1 ^ 2 + I1 * I2 * I3
    ^ 2 * h ^ 2 * s1 ^ 2 - I2 ^ 2 * I3 ^ 2 * h ^ 2 * s1 ^ 2 + X + 1 /\
  Q2 ^ 2 = I1 ^ 2 * I2 * I3 * h ^ 2 * s2 ^ 2 - I1 ^ 2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 - I1 * I2 ^ 2 * I3 *
    h ^ 2 * s2 ^ 2 + I1 * I2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 + X /\
  Q3 ^ 2 = - (I1 ^ 2 * I2 ^ 2 * h ^ 2 * s3 ^ 2) + I1 ^ 2 * I2 * I3 * h ^ 2 * s3 ^ 2 + I1 * I2 ^ 2 *
    I3 * h ^ 2 * s3 ^ 2 - I1 * I2 * I3 ^ 2 * h ^ 2 * s3 ^ 2 + X /\
  let t_1 := (I3 - I1) / I2 * (I1 * I2 * s3 * h) in
  let t_2 := I3 * I1 * s2 * (X + Q3 * Q1) + t_1 * (I2 * I3 * s1) * Q2 in
  let t_3 := (I1 - I2) / I3 * (I2 * I3 * s1 * h) in
  let t_4 := I1 * I2 * s3 * (X + Q1 * Q2) + t_3 * (I3 * I1 * s2) * Q3 in
  let t_5 := (1 + I1 * b) * ((I2 - I3) / I1 * (t_2 * h * t_4)) / (1 + I1 * b) in
  let t_6 := (I2 - I3) / I1 * (I3 * I1 * s2 * h) in
  let t_7 := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + t_6 * t_1 * t_3)) in
  let t_8 := I2 * I3 * s1 * (X + Q2 * Q3) + t_6 * (I1 * I2 * s3) * Q1 in
  let t_9 := (1 + I2 * b) * ((I3 - I1) / I2 * (t_4 * h * t_8)) / (1 + I2 * b) in
  let t_10 := (1 + I3 * b) * ((I1 - I2) / I3 * (t_8 * h * t_2)) / (1 + I3 * b) in
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  1 + I1 * b <> 0 /\
  1 + I2 * b <> 0 /\
  1 + I3 * b <> 0 /\
  (t_5 * (I1 * (I2 * I3 * s1 * t_7 + t_5 + I2 * I3 * s1 * t_7)) + t_9 * (I2 * (I3 * I1 * s2 * t_7 +
    t_9 + I3 * I1 * s2 * t_7)) + t_10 * (I3 * (I1 * I2 * s3 * t_7 + t_10 + I1 * I2 * s3 * t_7))) / 2
    <> 0.
Proof.
  exists (-2 / 3), (-5 / 6), (5 / 6), (sqrt (11207 / 5184)), (sqrt (28441 / 23328)), (sqrt (1799 /
    2592)), (7 / 6), (-1), (1 / 2), (-1 / 3), (7 / 6), (-7 / 6).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.


(** position-stage-keeps-momentum: The turn of the position stage takes the momentum along the axes before it to that along the axes after it: in the world the momentum stays, for every body, spin, time step, pace and weight b. *)

(* the momentum, x *)
Theorem position_stage_keeps_momentum_1 :
  forall I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 : R,
  Q1 ^ 2 = - (I1 ^ 2 * I2 * I3 * h ^ 2 * s1 ^ 2) + I1 * I2 ^ 2 * I3 * h ^ 2 * s1 ^ 2 + I1 * I2 * I3
    ^ 2 * h ^ 2 * s1 ^ 2 - I2 ^ 2 * I3 ^ 2 * h ^ 2 * s1 ^ 2 + X ->
  Q2 ^ 2 = I1 ^ 2 * I2 * I3 * h ^ 2 * s2 ^ 2 - I1 ^ 2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 - I1 * I2 ^ 2 * I3 *
    h ^ 2 * s2 ^ 2 + I1 * I2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 + X ->
  Q3 ^ 2 = - (I1 ^ 2 * I2 ^ 2 * h ^ 2 * s3 ^ 2) + I1 ^ 2 * I2 * I3 * h ^ 2 * s3 ^ 2 + I1 * I2 ^ 2 *
    I3 * h ^ 2 * s3 ^ 2 - I1 * I2 * I3 ^ 2 * h ^ 2 * s3 ^ 2 + X ->
  let t_1 := (I2 - I3) / I1 * (I3 * I1 * s2 * h) in
  let t_2 := (I3 - I1) / I2 * (I1 * I2 * s3 * h) in
  let t_3 := (I1 - I2) / I3 * (I2 * I3 * s1 * h) in
  let t_4 := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + t_1 * t_2 * t_3)) in
  let t_5 := I1 * (I2 * I3 * s1 * t_4) in
  let t_6 := I3 * I1 * s2 * (X + Q3 * Q1) + t_2 * (I2 * I3 * s1) * Q2 in
  let t_7 := I1 * I2 * s3 * (X + Q1 * Q2) + t_3 * (I3 * I1 * s2) * Q3 in
  let t_8 := (1 + I2 * b) * (t_6 * h * X) in
  let t_9 := I3 * (I1 * I2 * s3 * t_4) in
  let t_10 := I2 * I3 * s1 * (X + Q2 * Q3) + t_1 * (I1 * I2 * s3) * Q1 in
  let t_11 := (1 + I3 * b) * (t_7 * h * X) in
  let t_12 := I2 * (I3 * I1 * s2 * t_4) in
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  1 + I1 * b <> 0 ->
  1 + I3 * b <> 0 ->
  1 + I2 * b <> 0 ->
  (t_5 + I1 * ((1 + I1 * b) * ((I2 - I3) / I1 * (t_6 * h * t_7)) / (1 + I1 * b))) * t_4 + (t_8 *
    (t_9 + I3 * ((1 + I3 * b) * ((I1 - I2) / I3 * (t_10 * h * t_6)) / (1 + I3 * b))) - t_11 * (t_12
    + I2 * ((1 + I2 * b) * ((I3 - I1) / I2 * (t_7 * h * t_10)) / (1 + I2 * b)))) = t_5 * t_4 - (t_8
    * t_9 - t_11 * t_12).
Proof.
  intros I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 H_1 H_2 H_3 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 D_1 D_2 D_3 D_4 D_5 D_6.
  unnamed.
  field [H_1 H_2 H_3]; nonzero.
Qed.

(* the momentum, y *)
Theorem position_stage_keeps_momentum_2 :
  forall I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 : R,
  Q1 ^ 2 = - (I1 ^ 2 * I2 * I3 * h ^ 2 * s1 ^ 2) + I1 * I2 ^ 2 * I3 * h ^ 2 * s1 ^ 2 + I1 * I2 * I3
    ^ 2 * h ^ 2 * s1 ^ 2 - I2 ^ 2 * I3 ^ 2 * h ^ 2 * s1 ^ 2 + X ->
  Q2 ^ 2 = I1 ^ 2 * I2 * I3 * h ^ 2 * s2 ^ 2 - I1 ^ 2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 - I1 * I2 ^ 2 * I3 *
    h ^ 2 * s2 ^ 2 + I1 * I2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 + X ->
  Q3 ^ 2 = - (I1 ^ 2 * I2 ^ 2 * h ^ 2 * s3 ^ 2) + I1 ^ 2 * I2 * I3 * h ^ 2 * s3 ^ 2 + I1 * I2 ^ 2 *
    I3 * h ^ 2 * s3 ^ 2 - I1 * I2 * I3 ^ 2 * h ^ 2 * s3 ^ 2 + X ->
  let t_1 := (I2 - I3) / I1 * (I3 * I1 * s2 * h) in
  let t_2 := (I3 - I1) / I2 * (I1 * I2 * s3 * h) in
  let t_3 := (I1 - I2) / I3 * (I2 * I3 * s1 * h) in
  let t_4 := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + t_1 * t_2 * t_3)) in
  let t_5 := I2 * (I3 * I1 * s2 * t_4) in
  let t_6 := I1 * I2 * s3 * (X + Q1 * Q2) + t_3 * (I3 * I1 * s2) * Q3 in
  let t_7 := I2 * I3 * s1 * (X + Q2 * Q3) + t_1 * (I1 * I2 * s3) * Q1 in
  let t_8 := (1 + I3 * b) * (t_6 * h * X) in
  let t_9 := I1 * (I2 * I3 * s1 * t_4) in
  let t_10 := I3 * I1 * s2 * (X + Q3 * Q1) + t_2 * (I2 * I3 * s1) * Q2 in
  let t_11 := (1 + I1 * b) * (t_7 * h * X) in
  let t_12 := I3 * (I1 * I2 * s3 * t_4) in
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  1 + I2 * b <> 0 ->
  1 + I1 * b <> 0 ->
  1 + I3 * b <> 0 ->
  (t_5 + I2 * ((1 + I2 * b) * ((I3 - I1) / I2 * (t_6 * h * t_7)) / (1 + I2 * b))) * t_4 + (t_8 *
    (t_9 + I1 * ((1 + I1 * b) * ((I2 - I3) / I1 * (t_10 * h * t_6)) / (1 + I1 * b))) - t_11 * (t_12
    + I3 * ((1 + I3 * b) * ((I1 - I2) / I3 * (t_7 * h * t_10)) / (1 + I3 * b)))) = t_5 * t_4 - (t_8
    * t_9 - t_11 * t_12).
Proof.
  intros I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 H_1 H_2 H_3 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 D_1 D_2 D_3 D_4 D_5 D_6.
  unnamed.
  field [H_1 H_2 H_3]; nonzero.
Qed.

(* the momentum, z *)
Theorem position_stage_keeps_momentum_3 :
  forall I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 : R,
  Q1 ^ 2 = - (I1 ^ 2 * I2 * I3 * h ^ 2 * s1 ^ 2) + I1 * I2 ^ 2 * I3 * h ^ 2 * s1 ^ 2 + I1 * I2 * I3
    ^ 2 * h ^ 2 * s1 ^ 2 - I2 ^ 2 * I3 ^ 2 * h ^ 2 * s1 ^ 2 + X ->
  Q2 ^ 2 = I1 ^ 2 * I2 * I3 * h ^ 2 * s2 ^ 2 - I1 ^ 2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 - I1 * I2 ^ 2 * I3 *
    h ^ 2 * s2 ^ 2 + I1 * I2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 + X ->
  Q3 ^ 2 = - (I1 ^ 2 * I2 ^ 2 * h ^ 2 * s3 ^ 2) + I1 ^ 2 * I2 * I3 * h ^ 2 * s3 ^ 2 + I1 * I2 ^ 2 *
    I3 * h ^ 2 * s3 ^ 2 - I1 * I2 * I3 ^ 2 * h ^ 2 * s3 ^ 2 + X ->
  let t_1 := (I2 - I3) / I1 * (I3 * I1 * s2 * h) in
  let t_2 := (I3 - I1) / I2 * (I1 * I2 * s3 * h) in
  let t_3 := (I1 - I2) / I3 * (I2 * I3 * s1 * h) in
  let t_4 := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + t_1 * t_2 * t_3)) in
  let t_5 := I3 * (I1 * I2 * s3 * t_4) in
  let t_6 := I2 * I3 * s1 * (X + Q2 * Q3) + t_1 * (I1 * I2 * s3) * Q1 in
  let t_7 := I3 * I1 * s2 * (X + Q3 * Q1) + t_2 * (I2 * I3 * s1) * Q2 in
  let t_8 := (1 + I1 * b) * (t_6 * h * X) in
  let t_9 := I2 * (I3 * I1 * s2 * t_4) in
  let t_10 := I1 * I2 * s3 * (X + Q1 * Q2) + t_3 * (I3 * I1 * s2) * Q3 in
  let t_11 := (1 + I2 * b) * (t_7 * h * X) in
  let t_12 := I1 * (I2 * I3 * s1 * t_4) in
  I1 <> 0 ->
  I2 <> 0 ->
  I3 <> 0 ->
  1 + I3 * b <> 0 ->
  1 + I2 * b <> 0 ->
  1 + I1 * b <> 0 ->
  (t_5 + I3 * ((1 + I3 * b) * ((I1 - I2) / I3 * (t_6 * h * t_7)) / (1 + I3 * b))) * t_4 + (t_8 *
    (t_9 + I2 * ((1 + I2 * b) * ((I3 - I1) / I2 * (t_10 * h * t_6)) / (1 + I2 * b))) - t_11 * (t_12
    + I1 * ((1 + I1 * b) * ((I2 - I3) / I1 * (t_7 * h * t_10)) / (1 + I1 * b)))) = t_5 * t_4 - (t_8
    * t_9 - t_11 * t_12).
Proof.
  intros I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 H_1 H_2 H_3 t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11
    t_12 D_1 D_2 D_3 D_4 D_5 D_6.
  unnamed.
  field [H_1 H_2 H_3]; nonzero.
Qed.

(* With another weight about one axis. *)

(* the momentum, y *)
Theorem position_stage_keeps_momentum_mutant_1 :
  exists I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 : R,
  Q1 ^ 2 = - (I1 ^ 2 * I2 * I3 * h ^ 2 * s1 ^ 2) + I1 * I2 ^ 2 * I3 * h ^ 2 * s1 ^ 2 + I1 * I2 * I3
    ^ 2 * h ^ 2 * s1 ^ 2 - I2 ^ 2 * I3 ^ 2 * h ^ 2 * s1 ^ 2 + X /\
  Q2 ^ 2 = I1 ^ 2 * I2 * I3 * h ^ 2 * s2 ^ 2 - I1 ^ 2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 - I1 * I2 ^ 2 * I3 *
    h ^ 2 * s2 ^ 2 + I1 * I2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 + X /\
  Q3 ^ 2 = - (I1 ^ 2 * I2 ^ 2 * h ^ 2 * s3 ^ 2) + I1 ^ 2 * I2 * I3 * h ^ 2 * s3 ^ 2 + I1 * I2 ^ 2 *
    I3 * h ^ 2 * s3 ^ 2 - I1 * I2 * I3 ^ 2 * h ^ 2 * s3 ^ 2 + X /\
  let t_1 := (I2 - I3) / I1 * (I3 * I1 * s2 * h) in
  let t_2 := (I3 - I1) / I2 * (I1 * I2 * s3 * h) in
  let t_3 := (I1 - I2) / I3 * (I2 * I3 * s1 * h) in
  let t_4 := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + t_1 * t_2 * t_3)) in
  let t_5 := I2 * (I3 * I1 * s2 * t_4) in
  let t_6 := I1 * I2 * s3 * (X + Q1 * Q2) + t_3 * (I3 * I1 * s2) * Q3 in
  let t_7 := I2 * I3 * s1 * (X + Q2 * Q3) + t_1 * (I1 * I2 * s3) * Q1 in
  let t_8 := (1 + I3 * b) * (t_6 * h * X) in
  let t_9 := I1 * (I2 * I3 * s1 * t_4) in
  let t_10 := I3 * I1 * s2 * (X + Q3 * Q1) + t_2 * (I2 * I3 * s1) * Q2 in
  let t_11 := (1 + I1 * b + 1) * (t_7 * h * X) in
  let t_12 := I3 * (I1 * I2 * s3 * t_4) in
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  1 + I2 * b <> 0 /\
  1 + I1 * b + 1 <> 0 /\
  1 + I3 * b <> 0 /\
  (t_5 + I2 * ((1 + I2 * b) * ((I3 - I1) / I2 * (t_6 * h * t_7)) / (1 + I2 * b))) * t_4 + (t_8 *
    (t_9 + I1 * ((1 + I1 * b + 1) * ((I2 - I3) / I1 * (t_10 * h * t_6)) / (1 + I1 * b + 1))) - t_11
    * (t_12 + I3 * ((1 + I3 * b) * ((I1 - I2) / I3 * (t_7 * h * t_10)) / (1 + I3 * b)))) <> t_5 *
    t_4 - (t_8 * t_9 - t_11 * t_12).
Proof.
  exists (-2 / 3), (-5 / 6), (5 / 6), (sqrt (6023 / 5184)), (sqrt (28441 / 23328)), (sqrt (1799 /
    2592)), (7 / 6), (-1), (1 / 2), (-1 / 3), (7 / 6), (-7 / 6).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.

(* With a root of another pace. *)

(* the momentum, x *)
Theorem position_stage_keeps_momentum_mutant_2 :
  exists I1 I2 I3 Q1 Q2 Q3 X b h s1 s2 s3 : R,
  Q1 ^ 2 = - (I1 ^ 2 * I2 * I3 * h ^ 2 * s1 ^ 2) + I1 * I2 ^ 2 * I3 * h ^ 2 * s1 ^ 2 + I1 * I2 * I3
    ^ 2 * h ^ 2 * s1 ^ 2 - I2 ^ 2 * I3 ^ 2 * h ^ 2 * s1 ^ 2 + X + 1 /\
  Q2 ^ 2 = I1 ^ 2 * I2 * I3 * h ^ 2 * s2 ^ 2 - I1 ^ 2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 - I1 * I2 ^ 2 * I3 *
    h ^ 2 * s2 ^ 2 + I1 * I2 * I3 ^ 2 * h ^ 2 * s2 ^ 2 + X /\
  Q3 ^ 2 = - (I1 ^ 2 * I2 ^ 2 * h ^ 2 * s3 ^ 2) + I1 ^ 2 * I2 * I3 * h ^ 2 * s3 ^ 2 + I1 * I2 ^ 2 *
    I3 * h ^ 2 * s3 ^ 2 - I1 * I2 * I3 ^ 2 * h ^ 2 * s3 ^ 2 + X /\
  let t_1 := (I2 - I3) / I1 * (I3 * I1 * s2 * h) in
  let t_2 := (I3 - I1) / I2 * (I1 * I2 * s3 * h) in
  let t_3 := (I1 - I2) / I3 * (I2 * I3 * s1 * h) in
  let t_4 := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + t_1 * t_2 * t_3)) in
  let t_5 := I1 * (I2 * I3 * s1 * t_4) in
  let t_6 := I3 * I1 * s2 * (X + Q3 * Q1) + t_2 * (I2 * I3 * s1) * Q2 in
  let t_7 := I1 * I2 * s3 * (X + Q1 * Q2) + t_3 * (I3 * I1 * s2) * Q3 in
  let t_8 := (1 + I2 * b) * (t_6 * h * X) in
  let t_9 := I3 * (I1 * I2 * s3 * t_4) in
  let t_10 := I2 * I3 * s1 * (X + Q2 * Q3) + t_1 * (I1 * I2 * s3) * Q1 in
  let t_11 := (1 + I3 * b) * (t_7 * h * X) in
  let t_12 := I2 * (I3 * I1 * s2 * t_4) in
  I1 <> 0 /\
  I2 <> 0 /\
  I3 <> 0 /\
  1 + I1 * b <> 0 /\
  1 + I3 * b <> 0 /\
  1 + I2 * b <> 0 /\
  (t_5 + I1 * ((1 + I1 * b) * ((I2 - I3) / I1 * (t_6 * h * t_7)) / (1 + I1 * b))) * t_4 + (t_8 *
    (t_9 + I3 * ((1 + I3 * b) * ((I1 - I2) / I3 * (t_10 * h * t_6)) / (1 + I3 * b))) - t_11 * (t_12
    + I2 * ((1 + I2 * b) * ((I3 - I1) / I2 * (t_7 * h * t_10)) / (1 + I2 * b)))) <> t_5 * t_4 - (t_8
    * t_9 - t_11 * t_12).
Proof.
  exists (-2 / 3), (-5 / 6), (5 / 6), (sqrt (11207 / 5184)), (sqrt (28441 / 23328)), (sqrt (1799 /
    2592)), (7 / 6), (-1), (1 / 2), (-1 / 3), (7 / 6), (-7 / 6).
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. 
  cbv zeta.
  split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split; [enclosed | ]. split;
    [enclosed | ]. split; [enclosed | ]. enclosed.
Qed.


(** position-stage-spin-belongs-to-its-momentum: The change of the spin that the position stage adds in the world is that of the body's own spin, turned with it. *)

(* the change of the spin, x *)
Theorem position_stage_spin_belongs_to_its_momentum_1 :
  forall c1 c2 c3 d v1 v2 v3 w1 w2 w3 : R,
  let t_1 := v1 * d + (c2 * v3 - c3 * v2) - (w1 * d - (c2 * w3 - c3 * w2)) in
  let t_2 := v3 * d + (c1 * v2 - c2 * v1) - (w3 * d - (c1 * w2 - c2 * w1)) in
  let t_3 := v2 * d + (c3 * v1 - c1 * v3) - (w2 * d - (c3 * w1 - c1 * w3)) in
  d * (d * t_1 + (c2 * t_2 - c3 * t_3)) + c1 * (c1 * t_1 + c2 * t_3 + c3 * t_2) = ((c1 * c3 + d * c2
    + (c1 * c3 + d * c2)) * v3 + ((c1 * c2 - d * c3 + (c1 * c2 - d * c3)) * v2 + (d * d + c1 * c1 -
    c2 * c2 - c3 * c3) * v1) - (d * d + (c1 * c1 + c2 * c2 + c3 * c3)) * w1) * d.
Proof.
  intros c1 c2 c3 d v1 v2 v3 w1 w2 w3  t_1 t_2 t_3 .
  unnamed.
  ring.
Qed.

(* the change of the spin, y *)
Theorem position_stage_spin_belongs_to_its_momentum_2 :
  forall c1 c2 c3 d v1 v2 v3 w1 w2 w3 : R,
  let t_1 := v2 * d + (c3 * v1 - c1 * v3) - (w2 * d - (c3 * w1 - c1 * w3)) in
  let t_2 := v1 * d + (c2 * v3 - c3 * v2) - (w1 * d - (c2 * w3 - c3 * w2)) in
  let t_3 := v3 * d + (c1 * v2 - c2 * v1) - (w3 * d - (c1 * w2 - c2 * w1)) in
  d * (d * t_1 + (c3 * t_2 - c1 * t_3)) + c2 * (c1 * t_2 + c2 * t_1 + c3 * t_3) = ((c2 * c3 - d * c1
    + (c2 * c3 - d * c1)) * v3 + ((d * d - c1 * c1 + c2 * c2 - c3 * c3) * v2 + (c1 * c2 + d * c3 +
    (c1 * c2 + d * c3)) * v1) - (d * d + (c1 * c1 + c2 * c2 + c3 * c3)) * w2) * d.
Proof.
  intros c1 c2 c3 d v1 v2 v3 w1 w2 w3  t_1 t_2 t_3 .
  unnamed.
  ring.
Qed.

(* the change of the spin, z *)
Theorem position_stage_spin_belongs_to_its_momentum_3 :
  forall c1 c2 c3 d v1 v2 v3 w1 w2 w3 : R,
  let t_1 := v3 * d + (c1 * v2 - c2 * v1) - (w3 * d - (c1 * w2 - c2 * w1)) in
  let t_2 := v2 * d + (c3 * v1 - c1 * v3) - (w2 * d - (c3 * w1 - c1 * w3)) in
  let t_3 := v1 * d + (c2 * v3 - c3 * v2) - (w1 * d - (c2 * w3 - c3 * w2)) in
  d * (d * t_1 + (c1 * t_2 - c2 * t_3)) + c3 * (c1 * t_3 + c2 * t_2 + c3 * t_1) = ((d * d - c1 * c1
    - c2 * c2 + c3 * c3) * v3 + ((c2 * c3 + d * c1 + (c2 * c3 + d * c1)) * v2 + (c1 * c3 - d * c2 +
    (c1 * c3 - d * c2)) * v1) - (d * d + (c1 * c1 + c2 * c2 + c3 * c3)) * w3) * d.
Proof.
  intros c1 c2 c3 d v1 v2 v3 w1 w2 w3  t_1 t_2 t_3 .
  unnamed.
  ring.
Qed.

(* With the change left as the slip. *)

(* the change of the spin, x *)
Theorem position_stage_spin_belongs_to_its_momentum_mutant_1 :
  exists c1 c2 c3 d v1 v2 v3 w1 w2 w3 : R,
  v1 * d + (c2 * v3 - c3 * v2) - (w1 * d - (c2 * w3 - c3 * w2)) <> ((c1 * c3 + d * c2 + (c1 * c3 + d
    * c2)) * v3 + ((c1 * c2 - d * c3 + (c1 * c2 - d * c3)) * v2 + (d * d + c1 * c1 - c2 * c2 - c3 *
    c3) * v1) - (d * d + (c1 * c1 + c2 * c2 + c3 * c3)) * w1) * d.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5.
  computed.
Qed.


(** energy-gained-is-work-done: An impulse of torque P, in any direction of body or world, raises the energy by P . (w + w')/2, w and w' being the spins before and after it; half of a constant torque's impulse before the position stage and half after it, by the sum of the two; taking the share s of the spin away takes the share 2 s - s² of the energy. The position stage adds nothing to it. *)

(* an impulse *)
Theorem energy_gained_is_work_done_1 :
  forall J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 P1 P2 P3 : R,
  let t_1 := ((J_xz * (L3 + P3) + (J_xy * (L2 + P2) + J_xx * (L1 + P1))) * (L1 + P1) + (J_yz * (L3 +
    P3) + (J_yy * (L2 + P2) + J_xy * (L1 + P1))) * (L2 + P2) + (J_zz * (L3 + P3) + (J_yz * (L2 + P2)
    + J_xz * (L1 + P1))) * (L3 + P3)) / 2 - ((J_xz * L3 + (J_xy * L2 + J_xx * L1)) * L1 + (J_yz * L3
    + (J_yy * L2 + J_xy * L1)) * L2 + (J_zz * L3 + (J_yz * L2 + J_xz * L1)) * L3) / 2 in
  t_1 = (P1 * (J_xz * L3 + (J_xy * L2 + J_xx * L1) + (J_xz * (L3 + P3) + (J_xy * (L2 + P2) + J_xx *
    (L1 + P1)))) + P2 * (J_yz * L3 + (J_yy * L2 + J_xy * L1) + (J_yz * (L3 + P3) + (J_yy * (L2 + P2)
    + J_xy * (L1 + P1)))) + P3 * (J_zz * L3 + (J_yz * L2 + J_xz * L1) + (J_zz * (L3 + P3) + (J_yz *
    (L2 + P2) + J_xz * (L1 + P1))))) / 2.
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 P1 P2 P3  t_1 .
  unnamed.
  field; nonzero.
Qed.

(* two halves *)
Theorem energy_gained_is_work_done_2 :
  forall J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 M1 M2 M3 P1 P2 P3 R1 R2 R3 : R,
  let t_1 := ((J_xz * (L3 + P3) + (J_xy * (L2 + P2) + J_xx * (L1 + P1))) * (L1 + P1) + (J_yz * (L3 +
    P3) + (J_yy * (L2 + P2) + J_xy * (L1 + P1))) * (L2 + P2) + (J_zz * (L3 + P3) + (J_yz * (L2 + P2)
    + J_xz * (L1 + P1))) * (L3 + P3)) / 2 - ((J_xz * L3 + (J_xy * L2 + J_xx * L1)) * L1 + (J_yz * L3
    + (J_yy * L2 + J_xy * L1)) * L2 + (J_zz * L3 + (J_yz * L2 + J_xz * L1)) * L3) / 2 in
  let t_2 := t_1 + ((J_xz * (M3 + R3) + (J_xy * (M2 + R2) + J_xx * (M1 + R1))) * (M1 + R1) + (J_yz *
    (M3 + R3) + (J_yy * (M2 + R2) + J_xy * (M1 + R1))) * (M2 + R2) + (J_zz * (M3 + R3) + (J_yz * (M2
    + R2) + J_xz * (M1 + R1))) * (M3 + R3)) / 2 - ((J_xz * M3 + (J_xy * M2 + J_xx * M1)) * M1 +
    (J_yz * M3 + (J_yy * M2 + J_xy * M1)) * M2 + (J_zz * M3 + (J_yz * M2 + J_xz * M1)) * M3) / 2 in
  let t_3 := (P1 * (J_xz * L3 + (J_xy * L2 + J_xx * L1) + (J_xz * (L3 + P3) + (J_xy * (L2 + P2) +
    J_xx * (L1 + P1)))) + P2 * (J_yz * L3 + (J_yy * L2 + J_xy * L1) + (J_yz * (L3 + P3) + (J_yy *
    (L2 + P2) + J_xy * (L1 + P1)))) + P3 * (J_zz * L3 + (J_yz * L2 + J_xz * L1) + (J_zz * (L3 + P3)
    + (J_yz * (L2 + P2) + J_xz * (L1 + P1))))) / 2 + (R1 * (J_xz * M3 + (J_xy * M2 + J_xx * M1) +
    (J_xz * (M3 + R3) + (J_xy * (M2 + R2) + J_xx * (M1 + R1)))) + R2 * (J_yz * M3 + (J_yy * M2 +
    J_xy * M1) + (J_yz * (M3 + R3) + (J_yy * (M2 + R2) + J_xy * (M1 + R1)))) + R3 * (J_zz * M3 +
    (J_yz * M2 + J_xz * M1) + (J_zz * (M3 + R3) + (J_yz * (M2 + R2) + J_xz * (M1 + R1))))) / 2 in
  t_2 = t_3.
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 M1 M2 M3 P1 P2 P3 R1 R2 R3  t_1 t_2 t_3 .
  unnamed.
  field; nonzero.
Qed.

(* damping *)
Theorem energy_gained_is_work_done_3 :
  forall J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 s : R,
  let t_1 := ((J_xz * L3 + (J_xy * L2 + J_xx * L1)) * L1 + (J_yz * L3 + (J_yy * L2 + J_xy * L1)) *
    L2 + (J_zz * L3 + (J_yz * L2 + J_xz * L1)) * L3) / 2 - ((J_xz * (L3 * (1 - s)) + (J_xy * (L2 *
    (1 - s)) + J_xx * (L1 * (1 - s)))) * (L1 * (1 - s)) + (J_yz * (L3 * (1 - s)) + (J_yy * (L2 * (1
    - s)) + J_xy * (L1 * (1 - s)))) * (L2 * (1 - s)) + (J_zz * (L3 * (1 - s)) + (J_yz * (L2 * (1 -
    s)) + J_xz * (L1 * (1 - s)))) * (L3 * (1 - s))) / 2 in
  t_1 = ((J_xz * L3 + (J_xy * L2 + J_xx * L1)) * L1 + (J_yz * L3 + (J_yy * L2 + J_xy * L1)) * L2 +
    (J_zz * L3 + (J_yz * L2 + J_xz * L1)) * L3) / 2 * ((2 - s) * s).
Proof.
  intros J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 s  t_1 .
  unnamed.
  field; nonzero.
Qed.

(* an impulse *)
Theorem energy_gained_is_work_done_4 :
  forall J1 J2 J3 L1 L2 L3 P1 P2 P3 : R,
  (J1 * (L1 + P1) * (L1 + P1) + J2 * (L2 + P2) * (L2 + P2) + J3 * (L3 + P3) * (L3 + P3)) / 2 - (J1 *
    L1 * L1 + J2 * L2 * L2 + J3 * L3 * L3) / 2 = (P1 * (J1 * L1 + J1 * (L1 + P1)) + P2 * (J2 * L2 +
    J2 * (L2 + P2)) + P3 * (J3 * L3 + J3 * (L3 + P3))) / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3 P1 P2 P3   .
  field; nonzero.
Qed.

(* two halves *)
Theorem energy_gained_is_work_done_5 :
  forall J1 J2 J3 L1 L2 L3 M1 M2 M3 P1 P2 P3 R1 R2 R3 : R,
  let t_1 := (J1 * (L1 + P1) * (L1 + P1) + J2 * (L2 + P2) * (L2 + P2) + J3 * (L3 + P3) * (L3 + P3))
    / 2 - (J1 * L1 * L1 + J2 * L2 * L2 + J3 * L3 * L3) / 2 + (J1 * (M1 + R1) * (M1 + R1) + J2 * (M2
    + R2) * (M2 + R2) + J3 * (M3 + R3) * (M3 + R3)) / 2 - (J1 * M1 * M1 + J2 * M2 * M2 + J3 * M3 *
    M3) / 2 in
  t_1 = (P1 * (J1 * L1 + J1 * (L1 + P1)) + P2 * (J2 * L2 + J2 * (L2 + P2)) + P3 * (J3 * L3 + J3 *
    (L3 + P3))) / 2 + (R1 * (J1 * M1 + J1 * (M1 + R1)) + R2 * (J2 * M2 + J2 * (M2 + R2)) + R3 * (J3
    * M3 + J3 * (M3 + R3))) / 2.
Proof.
  intros J1 J2 J3 L1 L2 L3 M1 M2 M3 P1 P2 P3 R1 R2 R3  t_1 .
  unnamed.
  field; nonzero.
Qed.

(* damping *)
Theorem energy_gained_is_work_done_6 :
  forall J1 J2 J3 L1 L2 L3 s : R,
  (J1 * L1 * L1 + J2 * L2 * L2 + J3 * L3 * L3) / 2 - (J1 * (L1 * (1 - s)) * (L1 * (1 - s)) + J2 *
    (L2 * (1 - s)) * (L2 * (1 - s)) + J3 * (L3 * (1 - s)) * (L3 * (1 - s))) / 2 = (J1 * L1 * L1 + J2
    * L2 * L2 + J3 * L3 * L3) / 2 * ((2 - s) * s).
Proof.
  intros J1 J2 J3 L1 L2 L3 s   .
  field; nonzero.
Qed.

(* With with the spin before alone. *)

(* an impulse *)
Theorem energy_gained_is_work_done_mutant_1 :
  exists J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 P1 P2 P3 : R,
  let t_1 := ((J_xz * (L3 + P3) + (J_xy * (L2 + P2) + J_xx * (L1 + P1))) * (L1 + P1) + (J_yz * (L3 +
    P3) + (J_yy * (L2 + P2) + J_xy * (L1 + P1))) * (L2 + P2) + (J_zz * (L3 + P3) + (J_yz * (L2 + P2)
    + J_xz * (L1 + P1))) * (L3 + P3)) / 2 - ((J_xz * L3 + (J_xy * L2 + J_xx * L1)) * L1 + (J_yz * L3
    + (J_yy * L2 + J_xy * L1)) * L2 + (J_zz * L3 + (J_yz * L2 + J_xz * L1)) * L3) / 2 in
  t_1 <> P1 * (J_xz * L3 + (J_xy * L2 + J_xx * L1)) + P2 * (J_yz * L3 + (J_yy * L2 + J_xy * L1)) +
    P3 * (J_zz * L3 + (J_yz * L2 + J_xz * L1)).
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6.
  intros t_1; cut_to t_1 388 computed.
  computed.
Qed.

(* With with the spin after alone. *)

(* an impulse *)
Theorem energy_gained_is_work_done_mutant_2 :
  exists J_xx J_xy J_xz J_yy J_yz J_zz L1 L2 L3 P1 P2 P3 : R,
  let t_1 := ((J_xz * (L3 + P3) + (J_xy * (L2 + P2) + J_xx * (L1 + P1))) * (L1 + P1) + (J_yz * (L3 +
    P3) + (J_yy * (L2 + P2) + J_xy * (L1 + P1))) * (L2 + P2) + (J_zz * (L3 + P3) + (J_yz * (L2 + P2)
    + J_xz * (L1 + P1))) * (L3 + P3)) / 2 - ((J_xz * L3 + (J_xy * L2 + J_xx * L1)) * L1 + (J_yz * L3
    + (J_yy * L2 + J_xy * L1)) * L2 + (J_zz * L3 + (J_yz * L2 + J_xz * L1)) * L3) / 2 in
  t_1 <> P1 * (J_xz * (L3 + P3) + (J_xy * (L2 + P2) + J_xx * (L1 + P1))) + P2 * (J_yz * (L3 + P3) +
    (J_yy * (L2 + P2) + J_xy * (L1 + P1))) + P3 * (J_zz * (L3 + P3) + (J_yz * (L2 + P2) + J_xz * (L1
    + P1))).
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6.
  intros t_1; cut_to t_1 388 computed.
  computed.
Qed.
