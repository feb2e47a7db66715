(* The position stage of the library's engine (src/step/position_stage/turn.rs): a turn by the half-angle tangents
   c, and the spin after it, with three roots and any pace. *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

Definition coupling (I J K : R) : R := (J - K) / I.

(* The sum of the spins before and after about the first of three axes in cyclic order, times the divisor over the
   pace. *)
Definition passed (X Q1 Q2 Q3 k1 h w1 w2 w3 : R) : R := w1 * (X + Q2 * Q3) + k1 * (h * w2) * w3 * Q1.

Definition divisor (X Q1 Q2 Q3 k1 k2 k3 h w1 w2 w3 : R) : R :=
  X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + k1 * (h * w2) * (k2 * (h * w3)) * (k3 * (h * w1)))).

Section Stage.
Variables I1 I2 I3 X h b Q1 Q2 Q3 s1 s2 s3 : R.
Hypothesis N1 : I1 <> 0.
Hypothesis N2 : I2 <> 0.
Hypothesis N3 : I3 <> 0.
Hypothesis R1 : Q1 ^ 2 = X + (I3 - I1) * (I1 - I2) * I2 * I3 * (h * s1) ^ 2.
Hypothesis R2 : Q2 ^ 2 = X + (I1 - I2) * (I2 - I3) * I3 * I1 * (h * s2) ^ 2.
Hypothesis R3 : Q3 ^ 2 = X + (I2 - I3) * (I3 - I1) * I1 * I2 * (h * s3) ^ 2.
(* Spins in units that leave no quotient under the roots. *)
Let w1 := I2 * I3 * s1.
Let w2 := I3 * I1 * s2.
Let w3 := I1 * I2 * s3.
Let k1 := (I2 - I3) / I1.
Let k2 := (I3 - I1) / I2.
Let k3 := (I1 - I2) / I3.
Let S1 := w1 * (X + Q2 * Q3) + k1 * (h * w2) * w3 * Q1.
Let S2 := w2 * (X + Q3 * Q1) + k2 * (h * w3) * w1 * Q2.
Let S3 := w3 * (X + Q1 * Q2) + k3 * (h * w1) * w2 * Q3.
Let d := X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + k1 * (h * w2) * (k2 * (h * w3)) * (k3 * (h * w1)))).
Let g1 := k1 * h * (S2 * S3).
Let g2 := k2 * h * (S3 * S1).
Let g3 := k3 * h * (S1 * S2).

Lemma gains_nothing :
  g1 * (I1 * (2 * (w1 * d) + g1)) + g2 * (I2 * (2 * (w2 * d) + g2)) + g3 * (I3 * (2 * (w3 * d) + g3)) = 0.
Proof. unfold g1, g2, g3, d, S1, S2, S3, w1, w2, w3, k1, k2, k3 in *. field [R1 R2 R3]. repeat split; assumption. Qed.

Let m1 := 1 + I1 * b.
Let m2 := 1 + I2 * b.
Let m3 := 1 + I3 * b.

Lemma turned_1 :
  d * (I1 * g1) + h * X * (m2 * S2 * (I3 * (2 * (w3 * d) + g3)) - m3 * S3 * (I2 * (2 * (w2 * d) + g2))) = 0.
Proof. unfold g1, g2, g3, d, S1, S2, S3, w1, w2, w3, k1, k2, k3, m1, m2, m3 in *. field [R1 R2 R3]. repeat split; assumption. Qed.
Lemma turned_2 :
  d * (I2 * g2) + h * X * (m3 * S3 * (I1 * (2 * (w1 * d) + g1)) - m1 * S1 * (I3 * (2 * (w3 * d) + g3))) = 0.
Proof. unfold g1, g2, g3, d, S1, S2, S3, w1, w2, w3, k1, k2, k3, m1, m2, m3 in *. field [R1 R2 R3]. repeat split; assumption. Qed.
Lemma turned_3 :
  d * (I3 * g3) + h * X * (m1 * S1 * (I2 * (2 * (w2 * d) + g2)) - m2 * S2 * (I1 * (2 * (w1 * d) + g1))) = 0.
Proof. unfold g1, g2, g3, d, S1, S2, S3, w1, w2, w3, k1, k2, k3, m1, m2, m3 in *. field [R1 R2 R3]. repeat split; assumption. Qed.
End Stage.


(* The engine's stage from a spin w to a spin v with the tangents c. *)
Definition stage (I1 I2 I3 X h b w1 w2 w3 v1 v2 v3 c1 c2 c3 : R) : Prop :=
  let k1 := coupling I1 I2 I3 in let k2 := coupling I2 I3 I1 in let k3 := coupling I3 I1 I2 in
  exists Q1 Q2 Q3,
  Q1 ^ 2 = X + k2 * k3 * (h * w1) ^ 2 /\
  Q2 ^ 2 = X + k3 * k1 * (h * w2) ^ 2 /\
  Q3 ^ 2 = X + k1 * k2 * (h * w3) ^ 2 /\
  let S1 := passed X Q1 Q2 Q3 k1 h w1 w2 w3 in
  let S2 := passed X Q2 Q3 Q1 k2 h w2 w3 w1 in
  let S3 := passed X Q3 Q1 Q2 k3 h w3 w1 w2 in
  let d := divisor X Q1 Q2 Q3 k1 k2 k3 h w1 w2 w3 in
  d <> 0 /\
  v1 = w1 + k1 * h * (S2 * S3) / d /\ v2 = w2 + k2 * h * (S3 * S1) / d /\ v3 = w3 + k3 * h * (S1 * S2) / d /\
  c1 = (1 + I1 * b) * h * X * S1 / d /\ c2 = (1 + I2 * b) * h * X * S2 / d /\ c3 = (1 + I3 * b) * h * X * S3 / d.

Theorem stage_keeps (I1 I2 I3 X h b w1 w2 w3 v1 v2 v3 c1 c2 c3 : R) :
  I1 <> 0 -> I2 <> 0 -> I3 <> 0 -> stage I1 I2 I3 X h b w1 w2 w3 v1 v2 v3 c1 c2 c3 ->
  I1 * v1 ^ 2 + I2 * v2 ^ 2 + I3 * v3 ^ 2 = I1 * w1 ^ 2 + I2 * w2 ^ 2 + I3 * w3 ^ 2 /\
  I1 * v1 + (c2 * (I3 * v3) - c3 * (I2 * v2)) = I1 * w1 - (c2 * (I3 * w3) - c3 * (I2 * w2)) /\
  I2 * v2 + (c3 * (I1 * v1) - c1 * (I3 * v3)) = I2 * w2 - (c3 * (I1 * w1) - c1 * (I3 * w3)) /\
  I3 * v3 + (c1 * (I2 * v2) - c2 * (I1 * v1)) = I3 * w3 - (c1 * (I2 * w2) - c2 * (I1 * w1)).
Proof.
  intros N1 N2 N3 (Q1 & Q2 & Q3 & R1 & R2 & R3 & D & -> & -> & -> & -> & -> & ->).
  assert (U : exists s1 s2 s3, w1 = I2 * I3 * s1 /\ w2 = I3 * I1 * s2 /\ w3 = I1 * I2 * s3).
  { exists (w1 / (I2 * I3)), (w2 / (I3 * I1)), (w3 / (I1 * I2)). repeat split; field; auto. }
  destruct U as (s1 & s2 & s3 & -> & -> & ->). unfold passed, divisor, coupling in *.
  assert (T1 : Q1 ^ 2 = X + (I3 - I1) * (I1 - I2) * I2 * I3 * (h * s1) ^ 2) by (rewrite R1; field; auto).
  assert (T2 : Q2 ^ 2 = X + (I1 - I2) * (I2 - I3) * I3 * I1 * (h * s2) ^ 2) by (rewrite R2; field; auto).
  assert (T3 : Q3 ^ 2 = X + (I2 - I3) * (I3 - I1) * I1 * I2 * (h * s3) ^ 2) by (rewrite R3; field; auto).
  clear R1 R2 R3.
  assert (E := gains_nothing I1 I2 I3 X h Q1 Q2 Q3 s1 s2 s3 N1 N2 N3 T1 T2 T3).
  assert (M1 := turned_1 I1 I2 I3 X h b Q1 Q2 Q3 s1 s2 s3 N1 N2 N3 T1 T2 T3).
  assert (M2 := turned_2 I1 I2 I3 X h b Q1 Q2 Q3 s1 s2 s3 N1 N2 N3 T1 T2 T3).
  assert (M3 := turned_3 I1 I2 I3 X h b Q1 Q2 Q3 s1 s2 s3 N1 N2 N3 T1 T2 T3).
  cbv zeta in *. clear T1 T2 T3.
  set (w1 := I2 * I3 * s1) in *. set (w2 := I3 * I1 * s2) in *. set (w3 := I1 * I2 * s3) in *.
  set (k1 := (I2 - I3) / I1) in *. set (k2 := (I3 - I1) / I2) in *. set (k3 := (I1 - I2) / I3) in *.
  match type of D with ?x <> 0 => set (d := x) in * end.
  set (S1 := w1 * _ + _) in *. set (S2 := w2 * _ + _) in *. set (S3 := w3 * _ + _) in *.
  clearbody d S1 S2 S3 k1 k2 k3 w1 w2 w3.
  assert (Z : forall l r e, e = 0 -> l - r = e / d ^ 2 -> l = r).
  { intros l r e -> Q. unfold Rdiv in Q. rewrite Rmult_0_l in Q. lra. }
  split; [apply (Z _ _ _ E); field; exact D | ].
  split; [apply (Z _ _ _ M1); field; exact D | split; [apply (Z _ _ _ M2) | apply (Z _ _ _ M3)]; field; exact D].
Qed.

Lemma not_zero (q1 q2 q3 k : R) :
  0 < q1 -> 0 < q2 -> 0 < q3 -> 0 < k -> 1 * (1 * (q1 + q2 + q3) + (q1 * (q2 * q3) + k)) <> 0.
Proof. intros A B C D. assert (0 < q1 * (q2 * q3)) by (repeat apply Rmult_lt_0_compat; assumption). lra. Qed.

(* Such a stage there is: with three real roots, for spins about all axes. *)
Theorem a_stage : exists v1 v2 v3 c1 c2 c3, stage 4 5 7 1 (1 / 2) 0 1 1 1 v1 v2 v3 c1 c2 c3.
Proof.
  unfold stage, divisor, coupling. do 6 eexists.
  exists (sqrt (1 + (7 - 4) / 5 * ((4 - 5) / 7) * (1 / 2 * 1) ^ 2)),
    (sqrt (1 + (4 - 5) / 7 * ((5 - 7) / 4) * (1 / 2 * 1) ^ 2)),
    (sqrt (1 + (5 - 7) / 4 * ((7 - 4) / 5) * (1 / 2 * 1) ^ 2)).
  do 3 (split; [apply pow2_sqrt; lra | ]). split; [ | repeat split; reflexivity].
  apply not_zero; try (apply sqrt_lt_R0); lra.
Qed.
