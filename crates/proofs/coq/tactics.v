(* What every certificate uses: real numbers, and the tactics that close its proofs. *)
From Coq Require Export Reals Lra.
From Coq Require Export Psatz Nsatz.
From Interval Require Export Tactic.
Open Scope R_scope.

(* Above zero, if all that is added, multiplied and divided is. *)
Ltac positive :=
  repeat first
    [ assumption
    | apply Rplus_lt_0_compat | apply Rmult_lt_0_compat | apply Rdiv_lt_0_compat | apply pow_lt
    | lra ].

(* Divisors that are not zero: by hypothesis, by sign, or since a product that contains them is not. *)
Ltac nonzero :=
  repeat split;
  first
    [ assumption
    | lra
    | apply Rgt_not_eq; solve [positive]
    | match goal with
      | N : _ <> 0 |- _ <> 0 =>
          let Z := fresh "Z" in intro Z; apply N; solve [ring_simplify in Z; rewrite Z; ring | nsatz]
      end
    | match goal with
      | N : _ <> 0 |- _ <> 0 =>
          let Z := fresh "Z" in
          intro Z; apply N; field_simplify_eq; [solve [lra | nsatz] | repeat split; assumption]
      end ].

(* A statement about numbers without variables. *)
Ltac computed :=
  idtac; match goal with
  | |- _ = _ => first [lra | field; nonzero]
  | |- _ <> _ => first [lra | apply Rlt_not_eq; interval | apply Rgt_not_eq; interval]
  | |- _ => lra
  end.

(* The same with roots. *)
Ltac enclosed :=
  idtac; match goal with
  | |- sqrt _ ^ 2 = _ => rewrite pow2_sqrt; lra
  | |- _ = _ => lra
  | |- _ <> _ => first [lra | apply Rlt_not_eq; interval | apply Rgt_not_eq; interval]
  end.

(* Puts a simpler form for a named part of a statement, after proving that it is the same. *)
Tactic Notation "cut_to" ident(t) constr(form) tactic3(proof) :=
  let E := fresh "E" in
  assert (E : t = form) by (unfold t; proof);
  clearbody t; subst t.

(* Puts what they stand for in place of all named parts. *)
Ltac unnamed := repeat match goal with t := _ : R |- _ => subst t end.
