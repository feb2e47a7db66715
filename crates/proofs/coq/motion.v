(* The free body in continuous time: what stays, which axes are stable, and which is not. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* Euler's equations of a free body with principal moments I1, I2, I3. *)
Definition motion (I1 I2 I3 : R) (w1 w2 w3 : R -> R) : Prop :=
  forall t,
  is_derive w1 t ((I2 - I3) * (w2 t * w3 t) / I1) /\
  is_derive w2 t ((I3 - I1) * (w3 t * w1 t) / I2) /\
  is_derive w3 t ((I1 - I2) * (w1 t * w2 t) / I3).

(* What has no rate of change has one value. *)
Lemma constant (f : R -> R) : (forall t, is_derive f t 0) -> forall s t, f s = f t.
Proof.
  intros F s t. destruct (Rtotal_order s t) as [L | [-> | L]]; [ | reflexivity | symmetry];
    apply (eq_is_derive f); auto.
Qed.

(* Sums of the squares of the components, each with a number before it. *)
Lemma squares (I1 I2 I3 a1 a2 a3 : R) (w1 w2 w3 : R -> R) :
  I1 <> 0 -> I2 <> 0 -> I3 <> 0 -> motion I1 I2 I3 w1 w2 w3 ->
  a1 * (I2 - I3) / I1 + a2 * (I3 - I1) / I2 + a3 * (I1 - I2) / I3 = 0 ->
  forall s t,
  a1 * w1 s ^ 2 + a2 * w2 s ^ 2 + a3 * w3 s ^ 2 = a1 * w1 t ^ 2 + a2 * w2 t ^ 2 + a3 * w3 t ^ 2.
Proof.
  intros N1 N2 N3 M Z. apply (constant (fun t => a1 * w1 t ^ 2 + a2 * w2 t ^ 2 + a3 * w3 t ^ 2)).
  intros t. destruct (M t) as (D1 & D2 & D3).
  auto_derive.
  - repeat split; eexists; eassumption.
  - change (fun x : R => w1 x) with w1. change (fun x : R => w2 x) with w2. change (fun x : R => w3 x) with w3.
    rewrite (is_derive_unique _ _ _ D1), (is_derive_unique _ _ _ D2), (is_derive_unique _ _ _ D3).
    transitivity (2 * (w1 t * w2 t * w3 t)
      * (a1 * (I2 - I3) / I1 + a2 * (I3 - I1) / I2 + a3 * (I1 - I2) / I3)); [field; auto | rewrite Z; ring].
Qed.

Theorem energy_is_constant (I1 I2 I3 : R) (w1 w2 w3 : R -> R) :
  I1 <> 0 -> I2 <> 0 -> I3 <> 0 -> motion I1 I2 I3 w1 w2 w3 -> forall s t,
  I1 * w1 s ^ 2 + I2 * w2 s ^ 2 + I3 * w3 s ^ 2 = I1 * w1 t ^ 2 + I2 * w2 t ^ 2 + I3 * w3 t ^ 2.
Proof. intros N1 N2 N3 M. apply (squares I1 I2 I3); auto. field; auto. Qed.

Theorem momentum_has_constant_length (I1 I2 I3 : R) (w1 w2 w3 : R -> R) :
  I1 <> 0 -> I2 <> 0 -> I3 <> 0 -> motion I1 I2 I3 w1 w2 w3 -> forall s t,
  (I1 * w1 s) ^ 2 + (I2 * w2 s) ^ 2 + (I3 * w3 s) ^ 2 = (I1 * w1 t) ^ 2 + (I2 * w2 t) ^ 2 + (I3 * w3 t) ^ 2.
Proof.
  intros N1 N2 N3 M s t.
  assert (E := squares I1 I2 I3 (I1 ^ 2) (I2 ^ 2) (I3 ^ 2) w1 w2 w3 N1 N2 N3 M).
  rewrite !Rpow_mult_distr. apply E. field; auto.
Qed.

(* Two numbers whose squares, with positive numbers a and b before them, add up to at most those of two others
   below d, are below e. *)
Lemma bounded (a b x y x0 y0 d e : R) :
  0 < a -> 0 < b -> 0 < e -> 0 < d -> (a + b) * d ^ 2 <= a * e ^ 2 -> (a + b) * d ^ 2 <= b * e ^ 2 ->
  a * x ^ 2 + b * y ^ 2 = a * x0 ^ 2 + b * y0 ^ 2 -> Rabs x0 < d -> Rabs y0 < d ->
  Rabs x < e /\ Rabs y < e.
Proof.
  intros A B E D FA FB S X0 Y0.
  assert (X2 : x0 ^ 2 < d ^ 2) by (apply Rabs_def2 in X0; nra).
  assert (Y2 : y0 ^ 2 < d ^ 2) by (apply Rabs_def2 in Y0; nra).
  assert (X : x ^ 2 < e ^ 2) by nra.
  assert (Y : y ^ 2 < e ^ 2) by nra.
  split; apply Rabs_def1; nra.
Qed.

(* Small enough for the above. *)
Lemma enough (a b e : R) : 0 < a -> 0 < b -> 0 < e ->
  exists d, 0 < d /\ (a + b) * d ^ 2 <= a * e ^ 2 /\ (a + b) * d ^ 2 <= b * e ^ 2.
Proof.
  intros A B E.
  assert (P : 0 < Rmin a b / (a + b)) by (apply Rdiv_lt_0_compat; [apply Rmin_pos | ]; lra).
  exists (e * sqrt (Rmin a b / (a + b))).
  assert (S : (a + b) * (e * sqrt (Rmin a b / (a + b))) ^ 2 = Rmin a b * e ^ 2).
  { rewrite Rpow_mult_distr, pow2_sqrt by lra. field; lra. }
  rewrite S. repeat split.
  - apply Rmult_lt_0_compat; [ | apply sqrt_lt_R0]; assumption.
  - apply Rmult_le_compat_r; [nra | apply Rmin_l].
  - apply Rmult_le_compat_r; [nra | apply Rmin_r].
Qed.

(* The axis of the largest moment is stable: a spin that starts near it stays near it for all times, for every
   body. The first two components stay as small as wanted if they start small enough. *)
Theorem largest_axis_is_stable (I1 I2 I3 e : R) :
  0 < I1 -> 0 < I2 -> I1 < I3 -> I2 < I3 -> 0 < e ->
  exists d, 0 < d /\ forall w1 w2 w3, motion I1 I2 I3 w1 w2 w3 -> forall s,
  Rabs (w1 s) < d -> Rabs (w2 s) < d -> forall t, Rabs (w1 t) < e /\ Rabs (w2 t) < e.
Proof.
  intros P1 P2 L1 L2 E.
  assert (A : 0 < I1 * (I3 - I1)) by nra. assert (B : 0 < I2 * (I3 - I2)) by nra.
  destruct (enough _ _ e A B E) as (d & D & FA & FB).
  exists d. split; [exact D | ]. intros w1 w2 w3 M s X Y t.
  apply (bounded _ _ _ _ (w1 s) (w2 s) d e A B E D FA FB); try assumption.
  assert (K := squares I1 I2 I3 (I1 * (I3 - I1)) (I2 * (I3 - I2)) 0 w1 w2 w3).
  assert (H : forall s t, I1 * (I3 - I1) * w1 s ^ 2 + I2 * (I3 - I2) * w2 s ^ 2 + 0 * w3 s ^ 2 =
    I1 * (I3 - I1) * w1 t ^ 2 + I2 * (I3 - I2) * w2 t ^ 2 + 0 * w3 t ^ 2).
  { apply K; auto; try lra. field; lra. }
  specialize (H t s). lra.
Qed.

(* So is that of the smallest. *)
Theorem smallest_axis_is_stable (I1 I2 I3 e : R) :
  0 < I1 -> I1 < I2 -> I1 < I3 -> 0 < e ->
  exists d, 0 < d /\ forall w1 w2 w3, motion I1 I2 I3 w1 w2 w3 -> forall s,
  Rabs (w2 s) < d -> Rabs (w3 s) < d -> forall t, Rabs (w2 t) < e /\ Rabs (w3 t) < e.
Proof.
  intros P1 L2 L3 E.
  assert (A : 0 < I2 * (I2 - I1)) by nra. assert (B : 0 < I3 * (I3 - I1)) by nra.
  destruct (enough _ _ e A B E) as (d & D & FA & FB).
  exists d. split; [exact D | ]. intros w1 w2 w3 M s X Y t.
  apply (bounded _ _ _ _ (w2 s) (w3 s) d e A B E D FA FB); try assumption.
  assert (K := squares I1 I2 I3 0 (I2 * (I2 - I1)) (I3 * (I3 - I1)) w1 w2 w3).
  assert (H : forall s t, 0 * w1 s ^ 2 + I2 * (I2 - I1) * w2 s ^ 2 + I3 * (I3 - I1) * w3 s ^ 2 =
    0 * w1 t ^ 2 + I2 * (I2 - I1) * w2 t ^ 2 + I3 * (I3 - I1) * w3 t ^ 2).
  { apply K; auto; try lra. field; lra. }
  specialize (H t s). lra.
Qed.

(* The motion on the separatrix, with E = s exp (k t): amplitudes a and c and the rate k as Euler's equations
   want them. *)
Lemma separatrix (I1 I2 I3 W a c k s : R) :
  I1 <> 0 -> I2 <> 0 -> I3 <> 0 ->
  I1 * (a * k) = (I3 - I2) * (W * c) -> I3 * (c * k) = (I2 - I1) * (W * a) ->
  I2 * (W * k) = (I3 - I1) * (a * c) ->
  motion I1 I2 I3
    (fun t => 2 * a * (s * exp (k * t)) / (1 + (s * exp (k * t)) ^ 2))
    (fun t => W * (1 - (s * exp (k * t)) ^ 2) / (1 + (s * exp (k * t)) ^ 2))
    (fun t => - (2 * c * (s * exp (k * t)) / (1 + (s * exp (k * t)) ^ 2))).
Proof.
  intros N1 N2 N3 A C B t.
  assert (P : 1 + (s * exp (k * t)) ^ 2 <> 0) by (assert (0 <= (s * exp (k * t)) ^ 2) by apply pow2_ge_0; lra).
  assert (P' : 1 + s * exp (k * t) * (s * exp (k * t) * 1) <> 0) by (simpl in P; exact P).
  split; [ | split]; (auto_derive; [ exact P' | ]); set (E := s * exp (k * t)) in *.
  - apply (Rmult_eq_reg_l I1); [ | exact N1].
    transitivity ((I1 * (a * k)) * (2 * E * (1 - E ^ 2) / (1 + E ^ 2) ^ 2)).
    + unfold E in *. field. exact P.
    + rewrite A. field. split; assumption.
  - apply (Rmult_eq_reg_l I2); [ | exact N2].
    transitivity ((I2 * (W * k)) * (- 4 * E ^ 2 / (1 + E ^ 2) ^ 2)).
    + unfold E in *. field. exact P.
    + rewrite B. field. split; assumption.
  - apply (Rmult_eq_reg_l I3); [ | exact N3].
    transitivity ((I3 * (c * k)) * (- (2 * E * (1 - E ^ 2) / (1 + E ^ 2) ^ 2))).
    + unfold E in *. field. exact P.
    + rewrite C. field. split; assumption.
Qed.

(* The axis of the middle moment is unstable, for every body with three different moments: as near to a steady
   spin W about it as wanted there starts a motion that turns over, its spin about that axis taking the opposite
   value later. *)
Theorem middle_axis_is_unstable (I1 I2 I3 W d : R) :
  0 < I1 -> I1 < I2 -> I2 < I3 -> 0 < W -> 0 < d ->
  exists w1 w2 w3, motion I1 I2 I3 w1 w2 w3 /\
  Rabs (w1 0) < d /\ Rabs (w2 0 - W) < d /\ Rabs (w3 0) < d /\
  exists t, 0 < t /\ 0 < w2 0 /\ w2 t = - w2 0.
Proof.
  intros P L2 L3 PW D.
  set (a := W * sqrt (I2 * (I3 - I2) / (I1 * (I3 - I1)))).
  set (k := W * sqrt ((I2 - I1) * (I3 - I2) / (I1 * I3))).
  assert (QA : 0 < I2 * (I3 - I2) / (I1 * (I3 - I1))) by (apply Rdiv_lt_0_compat; nra).
  assert (QK : 0 < (I2 - I1) * (I3 - I2) / (I1 * I3)) by (apply Rdiv_lt_0_compat; nra).
  assert (PA : 0 < a) by (apply Rmult_lt_0_compat; [ | apply sqrt_lt_R0]; assumption).
  assert (PK : 0 < k) by (apply Rmult_lt_0_compat; [ | apply sqrt_lt_R0]; assumption).
  assert (SA : a ^ 2 = W ^ 2 * (I2 * (I3 - I2) / (I1 * (I3 - I1))))
    by (unfold a; rewrite Rpow_mult_distr, pow2_sqrt by lra; reflexivity).
  assert (SK : k ^ 2 = W ^ 2 * ((I2 - I1) * (I3 - I2) / (I1 * I3)))
    by (unfold k; rewrite Rpow_mult_distr, pow2_sqrt by lra; reflexivity).
  clearbody a k.
  set (c := I1 * (a * k) / ((I3 - I2) * W)).
  assert (PC : 0 < c).
  { unfold c. apply Rdiv_lt_0_compat; repeat apply Rmult_lt_0_compat; lra. }
  (* How far from the axis it starts. *)
  set (s := Rmin (1 / 2) (d / (2 * (2 * a + 2 * W + 2 * c)))).
  assert (S0 : 0 < s) by (apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra]).
  assert (S1 : s <= 1 / 2) by apply Rmin_l.
  assert (S2 : s * (2 * a + 2 * W + 2 * c) < d).
  { apply Rle_lt_trans with (d / 2); [ | lra].
    replace (d / 2) with (d / (2 * (2 * a + 2 * W + 2 * c)) * (2 * a + 2 * W + 2 * c)) by (field; lra).
    apply Rmult_le_compat_r; [lra | apply Rmin_r]. }
  clearbody s.
  assert (F : forall x, 0 < x -> 0 < x * s / (1 + s ^ 2) <= x * s).
  { intros x X. split; [apply Rdiv_lt_0_compat; nra | ].
    apply (Rmult_le_reg_r (1 + s ^ 2)); [nra | ].
    replace (x * s / (1 + s ^ 2) * (1 + s ^ 2)) with (x * s) by (field; nra).
    assert (0 <= x * s * s ^ 2) by (repeat apply Rmult_le_pos; nra). nra. }
  exists (fun t => 2 * a * (s * exp (k * t)) / (1 + (s * exp (k * t)) ^ 2)),
    (fun t => W * (1 - (s * exp (k * t)) ^ 2) / (1 + (s * exp (k * t)) ^ 2)),
    (fun t => - (2 * c * (s * exp (k * t)) / (1 + (s * exp (k * t)) ^ 2))).
  split.
  { apply separatrix; try lra.
    - unfold c. field. lra.
    - unfold c. transitivity (I3 * I1 * a * k ^ 2 / ((I3 - I2) * W)); [field; lra | ].
      rewrite SK. field. lra.
    - unfold c. transitivity ((I3 - I1) * I1 * k * (a ^ 2) / ((I3 - I2) * W)); [ | field; lra].
      rewrite SA. field. lra. }
  rewrite Rmult_0_r, exp_0, Rmult_1_r.
  assert (X := F (2 * a) ltac:(lra)). assert (Z := F (2 * c) ltac:(lra)).
  assert (Y := F (2 * W * s) ltac:(nra)).
  assert (V : 0 < W * (1 - s ^ 2) / (1 + s ^ 2)) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat | ]; nra).
  assert (0 < s * a) by nra. assert (0 < s * W) by nra. assert (0 < s * c) by nra.
  split; [ | split; [ | split]].
  - apply Rabs_def1; lra.
  - replace (W * (1 - s ^ 2) / (1 + s ^ 2) - W) with (- (2 * W * s * s / (1 + s ^ 2))) by (field; nra).
    apply Rabs_def1; nra.
  - apply Rabs_def1; lra.
  - exists (2 * ln (/ s) / k).
    assert (LN : 0 < ln (/ s)).
    { rewrite <- ln_1. apply ln_increasing; [lra | ]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
    assert (T : s * exp (k * (2 * ln (/ s) / k)) = / s).
    { replace (k * (2 * ln (/ s) / k)) with (ln (/ s) + ln (/ s)) by (field; lra).
      rewrite exp_plus, exp_ln by (apply Rinv_0_lt_compat; lra). field. lra. }
    rewrite T. repeat split; [apply Rdiv_lt_0_compat; lra | exact V | field; split; nra].
Qed.
