(* The moments of inertia of a box, as integrals over it. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* Coquelicot's equations of real numbers, as the field's tactics know them. *)
Ltac real := match goal with |- @eq _ ?a ?b => change (@eq R a b) end.

Lemma integral (p q h : R) : RInt (fun x => p + q * x ^ 2) (- h) h = 2 * h * (p + q * h ^ 2 / 3).
Proof.
  apply is_RInt_unique.
  replace (2 * h * _) with (minus (p * h + q * h ^ 3 / 3) (p * (- h) + q * (- h) ^ 3 / 3))
    by (unfold minus, plus, opp; simpl; field).
  apply (is_RInt_derive (fun x => p * x + q * x ^ 3 / 3)).
  - intros x _. auto_derive; [exact I | field].
  - intros x _. apply (ex_derive_continuous (fun x => p + q * x ^ 2)). auto_derive. exact I.
Qed.

(* Of density r, with edges 2 a, 2 b and 2 c, about the axis through its centre along the first edge. *)
Theorem moment_of_a_box (r a b c : R) :
  RInt (fun x => RInt (fun y => RInt (fun z => r * (y ^ 2 + z ^ 2)) (- c) c) (- b) b) (- a) a
  = r * (2 * a) * (2 * b) * (2 * c) * ((2 * b) ^ 2 + (2 * c) ^ 2) / 12.
Proof.
  assert (Z : forall y, RInt (fun z => r * (y ^ 2 + z ^ 2)) (- c) c = 2 * c * r * c ^ 2 / 3 + 2 * c * r * y ^ 2).
  { intros y. rewrite (RInt_ext _ (fun z => r * y ^ 2 + r * z ^ 2)) by (intros; real; ring). rewrite integral. real. field. }
  rewrite (RInt_ext _ (fun x => 2 * b * (2 * c * r * c ^ 2 / 3 + 2 * c * r * b ^ 2 / 3) + 0 * x ^ 2)).
  - rewrite integral. real. field.
  - intros x _. rewrite (RInt_ext _ (fun y => 2 * c * r * c ^ 2 / 3 + 2 * c * r * y ^ 2)) by (intros; apply Z).
    rewrite integral. real. field.
Qed.
