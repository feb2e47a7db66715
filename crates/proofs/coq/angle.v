(* The attitude of a free motion by the angle psi about its momentum: the turn that takes the momentum to the third axis
   by the shortest way, followed by a turn by psi about that axis. *)
Require Import Tumbling.motion.
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Section Angle.
Variables (I1 I2 I3 L : R) (w1 w2 w3 psi : R -> R) (t : R).
Hypothesis N1 : I1 <> 0.
Hypothesis N2 : I2 <> 0.
Hypothesis N3 : I3 <> 0.
Hypothesis P : 0 < L.
Hypothesis M : motion I1 I2 I3 w1 w2 w3.
Hypothesis Q : (I1 * w1 t) ^ 2 + (I2 * w2 t) ^ 2 + (I3 * w3 t) ^ 2 = L ^ 2.
Hypothesis O : 0 < L + I3 * w3 t.
Hypothesis T : is_derive psi t ((I1 * w1 t ^ 2 + I2 * w2 t ^ 2 + I3 * w3 t ^ 2 + L * w3 t) / (L + I3 * w3 t)).

(* The shortest turn is r + b1 i + b2 j. *)
Definition r (t : R) := sqrt ((L + I3 * w3 t) / (2 * L)).
Definition b1 (t : R) := I2 * w2 t / (2 * L * r t).
Definition b2 (t : R) := - (I1 * w1 t / (2 * L * r t)).
Definition q0 (t : R) := cos (psi t / 2) * r t.
Definition q1 (t : R) := cos (psi t / 2) * b1 t - sin (psi t / 2) * b2 t.
Definition q2 (t : R) := cos (psi t / 2) * b2 t + sin (psi t / 2) * b1 t.
Definition q3 (t : R) := sin (psi t / 2) * r t.

(* Both derivatives are taken; what is left is k times what the momentum's length leaves over. *)
Ltac derivative k :=
  destruct (M t) as (D1 & D2 & D3);
  assert (E1 : ex_derive w1 t) by (eexists; exact D1);
  assert (E2 : ex_derive w2 t) by (eexists; exact D2);
  assert (E3 : ex_derive w3 t) by (eexists; exact D3);
  assert (E4 : ex_derive psi t) by (eexists; exact T);
  assert (V : 0 < (L + I3 * w3 t) / (2 * L)) by (apply Rdiv_lt_0_compat; lra);
  assert (S0 := sqrt_lt_R0 _ V); assert (S2 := sqrt_sqrt _ (Rlt_le _ _ V));
  unfold q0, q1, q2, q3, b1, b2, r; auto_derive;
  [repeat split; auto; try exact V; try (apply Rgt_not_eq, Rmult_lt_0_compat; [lra | exact S0]) | ];
  try replace (Derive (fun x => w1 x) t) with ((I2 - I3) * (w2 t * w3 t) / I1) by (symmetry; apply is_derive_unique; exact D1);
  try replace (Derive (fun x => w2 x) t) with ((I3 - I1) * (w3 t * w1 t) / I2) by (symmetry; apply is_derive_unique; exact D2);
  try replace (Derive (fun x => w3 x) t) with ((I1 - I2) * (w1 t * w2 t) / I3) by (symmetry; apply is_derive_unique; exact D3);
  try replace (Derive (fun x => psi x) t)
    with ((I1 * w1 t ^ 2 + I2 * w2 t ^ 2 + I3 * w3 t ^ 2 + L * w3 t) / (L + I3 * w3 t))
    by (symmetry; apply is_derive_unique; exact T);
  change ((L + I3 * w3 t) / (2 * L)) with ((L + I3 * w3 t) * / (2 * L)) in *;
  change (psi t / 2) with (psi t * / 2);
  set (S := sqrt ((L + I3 * w3 t) * / (2 * L))) in *;
  assert (W : w3 t = (2 * L * (S * S) - L) / I3) by (rewrite S2; field; lra);
  clearbody S; rewrite W in Q |- *; clear W;
  set (C := cos (psi t * / 2)); set (Z := sin (psi t * / 2)); clearbody C Z;
  assert (LSS : L + (2 * L * (S * S) - L) <> 0)
    by (replace (L + (2 * L * (S * S) - L)) with (2 * L * (S * S)) by ring;
        apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; lra);
  apply Rminus_diag_uniq;
  transitivity (k C Z (w1 t) (w2 t) / (8 * L ^ 2 * S ^ 3) *
    ((I1 * w1 t) ^ 2 + (I2 * w2 t) ^ 2 + (I3 * ((2 * L * (S * S) - L) / I3)) ^ 2 - L ^ 2));
  [field; repeat split; lra | rewrite Q; ring].

Lemma first_part : is_derive q0 t (- (q1 t * w1 t + q2 t * w2 t + q3 t * w3 t) / 2).
Proof. derivative (fun _ _ _ _ : R => 0). Qed.

Lemma second_part : is_derive q1 t ((q0 t * w1 t + q2 t * w3 t - q3 t * w2 t) / 2).
Proof. derivative (fun C Z x y : R => C * x - Z * y). Qed.

Lemma third_part : is_derive q2 t ((q0 t * w2 t + q3 t * w1 t - q1 t * w3 t) / 2).
Proof. derivative (fun C Z x y : R => C * y + Z * x). Qed.

Lemma fourth_part : is_derive q3 t ((q0 t * w3 t + q1 t * w2 t - q2 t * w1 t) / 2).
Proof. derivative (fun _ _ _ _ : R => 0). Qed.
End Angle.
