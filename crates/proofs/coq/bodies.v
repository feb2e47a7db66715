(* Any number of points: no moment of inertia exceeds the sum of the other two. *)
From Coq Require Import Reals List Lra Psatz.
Import ListNotations.
Open Scope R_scope.

(* A point: its mass and where it is. *)
Record point := { m : R; x : R; y : R; z : R }.

Definition sum (f : point -> R) (body : list point) : R := fold_right (fun p s => f p + s) 0 body.

(* The moments of inertia about the three axes through the origin. *)
Definition Ix := sum (fun p => m p * (y p ^ 2 + z p ^ 2)).
Definition Iy := sum (fun p => m p * (z p ^ 2 + x p ^ 2)).
Definition Iz := sum (fun p => m p * (x p ^ 2 + y p ^ 2)).

(* Whatever axes are chosen, half the sum of the three moments less one of them is the sum of m x²: it is never
   negative. *)
Lemma excess (body : list point) : Iy body + Iz body - Ix body = 2 * sum (fun p => m p * x p ^ 2) body.
Proof.
  unfold Ix, Iy, Iz. induction body as [ | p body H]; simpl in *; [ring | ].
  replace (2 * _) with (2 * (m p * (x p * (x p * 1))) + 2 * sum (fun p => m p * (x p * (x p * 1))) body) by ring.
  rewrite <- H. ring.
Qed.

Lemma not_negative (f : point -> R) (body : list point) :
  Forall (fun p => 0 <= m p) body -> 0 <= sum (fun p => m p * f p ^ 2) body.
Proof.
  induction 1 as [ | p body P _ H]; simpl in *; [lra | ].
  assert (0 <= m p * (f p * (f p * 1))) by (apply Rmult_le_pos; nra). lra.
Qed.

Theorem triangle_inequality (body : list point) :
  Forall (fun p => 0 <= m p) body -> Ix body <= Iy body + Iz body.
Proof. intros P. assert (E := excess body). assert (N := not_negative x body P). lra. Qed.
