(* What whole methods keep or lose in a step of any size, for every body. *)
From Coq Require Import Reals List Lra Psatz Nsatz.
Import ListNotations.
Open Scope R_scope.

(* The implicit midpoint rule, L' - L = h M x (J M) with M half of L + L', keeps the length of the momentum and
   the energy, for every symmetric J. *)
Section Midpoint.
Variables J11 J22 J33 J12 J13 J23 h L1 L2 L3 N1 N2 N3 : R.
Let M1 := (L1 + N1) / 2.
Let M2 := (L2 + N2) / 2.
Let M3 := (L3 + N3) / 2.
Let w1 := J11 * M1 + J12 * M2 + J13 * M3.
Let w2 := J12 * M1 + J22 * M2 + J23 * M3.
Let w3 := J13 * M1 + J23 * M2 + J33 * M3.
Hypothesis S1 : N1 - L1 = h * (M2 * w3 - M3 * w2).
Hypothesis S2 : N2 - L2 = h * (M3 * w1 - M1 * w3).
Hypothesis S3 : N3 - L3 = h * (M1 * w2 - M2 * w1).

Theorem midpoint_keeps_momentum : N1 ^ 2 + N2 ^ 2 + N3 ^ 2 = L1 ^ 2 + L2 ^ 2 + L3 ^ 2.
Proof.
  apply Rminus_diag_uniq.
  transitivity (2 * (M1 * (N1 - L1) + M2 * (N2 - L2) + M3 * (N3 - L3))); [unfold M1, M2, M3; field | ].
  rewrite S1, S2, S3. ring.
Qed.

Theorem midpoint_keeps_energy :
  N1 * (J11 * N1 + J12 * N2 + J13 * N3) + N2 * (J12 * N1 + J22 * N2 + J23 * N3)
    + N3 * (J13 * N1 + J23 * N2 + J33 * N3)
  = L1 * (J11 * L1 + J12 * L2 + J13 * L3) + L2 * (J12 * L1 + J22 * L2 + J23 * L3)
    + L3 * (J13 * L1 + J23 * L2 + J33 * L3).
Proof.
  apply Rminus_diag_uniq.
  transitivity (2 * (w1 * (N1 - L1) + w2 * (N2 - L2) + w3 * (N3 - L3)));
    [unfold w1, w2, w3, M1, M2, M3; field | ].
  rewrite S1, S2, S3. ring.
Qed.
End Midpoint.

(* Turns about the three axes, by their cosines and sines, as the splitting methods make them. *)
Inductive turn := About1 (c s : R) | About2 (c s : R) | About3 (c s : R).

Definition proper (t : turn) : Prop :=
  match t with About1 c s | About2 c s | About3 c s => c ^ 2 + s ^ 2 = 1 end.

Definition turned (t : turn) (v : R * R * R) : R * R * R :=
  let '(x, y, z) := v in
  match t with
  | About1 c s => (x, c * y + s * z, c * z - s * y)
  | About2 c s => (c * x - s * z, y, c * z + s * x)
  | About3 c s => (c * x + s * y, c * y - s * x, z)
  end.

Definition square (v : R * R * R) : R := let '(x, y, z) := v in x ^ 2 + y ^ 2 + z ^ 2.

(* A splitting of any order, with any shares of the step, keeps the length of the momentum. *)
Theorem splitting_keeps_momentum (turns : list turn) (L : R * R * R) :
  Forall proper turns -> square (fold_right turned L turns) = square L.
Proof.
  induction 1 as [ | t turns P _ H]; [reflexivity | ].
  simpl. rewrite <- H. destruct (fold_right turned L turns) as [[x y] z].
  destruct t; simpl in *; nsatz.
Qed.

(* Implicit Euler in the body, I (w' - w) = h (I w') x w': the energy falls by that of the change of the spin. *)
Section Implicit.
Variables I1 I2 I3 h a1 a2 a3 b1 b2 b3 : R.
Hypothesis S1 : I1 * (b1 - a1) = h * ((I2 - I3) * b2 * b3).
Hypothesis S2 : I2 * (b2 - a2) = h * ((I3 - I1) * b3 * b1).
Hypothesis S3 : I3 * (b3 - a3) = h * ((I1 - I2) * b1 * b2).

Theorem implicit_euler_energy :
  (I1 * b1 ^ 2 + I2 * b2 ^ 2 + I3 * b3 ^ 2) / 2
  = (I1 * a1 ^ 2 + I2 * a2 ^ 2 + I3 * a3 ^ 2) / 2
    - (I1 * (b1 - a1) ^ 2 + I2 * (b2 - a2) ^ 2 + I3 * (b3 - a3) ^ 2) / 2.
Proof.
  apply Rminus_diag_uniq.
  transitivity (b1 * (I1 * (b1 - a1)) + b2 * (I2 * (b2 - a2)) + b3 * (I3 * (b3 - a3))); [field | ].
  rewrite S1, S2, S3. ring.
Qed.

Theorem implicit_euler_never_gains :
  0 < I1 -> 0 < I2 -> 0 < I3 ->
  I1 * b1 ^ 2 + I2 * b2 ^ 2 + I3 * b3 ^ 2 <= I1 * a1 ^ 2 + I2 * a2 ^ 2 + I3 * a3 ^ 2.
Proof.
  intros P1 P2 P3. assert (E := implicit_euler_energy).
  assert (0 <= I1 * (b1 - a1) ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
  assert (0 <= I2 * (b2 - a2) ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
  assert (0 <= I3 * (b3 - a3) ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
  lra.
Qed.
End Implicit.

(* Explicit Euler, L' = L + h L x w, adds h² |L x w|² to the square of the momentum's length, whatever w is. *)
Theorem explicit_euler_lengthens (h L1 L2 L3 w1 w2 w3 : R) :
  let c1 := L2 * w3 - L3 * w2 in let c2 := L3 * w1 - L1 * w3 in let c3 := L1 * w2 - L2 * w1 in
  square (L1 + h * c1, L2 + h * c2, L3 + h * c3) = square (L1, L2, L3) + h ^ 2 * square (c1, c2, c3).
Proof. cbv zeta. unfold square. ring. Qed.
