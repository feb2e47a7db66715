(* The closed form of the free motion solves Euler's equations, with Jacobi's functions known by their derivatives. *)
Require Import Tumbling.motion.
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* Jacobi's functions sn, cn, dn of the parameter m, by their rates of change and their values at zero. *)
Definition jacobi (m : R) (sn cn dn : R -> R) : Prop :=
  (forall u, is_derive sn u (cn u * dn u)) /\
  (forall u, is_derive cn u (- (sn u * dn u))) /\
  (forall u, is_derive dn u (- (m * (sn u * cn u)))) /\
  sn 0 = 0 /\ cn 0 = 1 /\ dn 0 = 1.

Lemma amplitudes_solve (I1 I2 I3 a b c n m e : R) (sn cn dn : R -> R) :
  I1 <> 0 -> I2 <> 0 -> I3 <> 0 -> jacobi m sn cn dn ->
  I1 * (a * n) = (I3 - I2) * (b * c) -> I2 * (b * n) = (I3 - I1) * (c * a) ->
  I3 * (m * (c * n)) = (I2 - I1) * (a * b) ->
  motion I1 I2 I3 (fun t => a * cn (n * t + e)) (fun t => b * sn (n * t + e)) (fun t => c * dn (n * t + e)).
Proof.
  intros N1 N2 N3 (S & C & D & _) A B M t.
  assert (L : is_derive (fun t => n * t + e) t n) by (auto_derive; [exact I | ring]).
  assert (G : forall f g k, (forall u, is_derive f u (g u)) ->
    is_derive (fun t => k * f (n * t + e)) t (k * (n * g (n * t + e)))).
  { intros f g k F. apply (is_derive_scal (fun t => f (n * t + e))).
    exact (is_derive_comp f (fun t => n * t + e) t _ _ (F _) L). }
  set (u := n * t + e) in *. split; [ | split].
  - replace (_ / I1) with (a * (n * - (sn u * dn u))); [exact (G cn _ a C) | ].
    apply (Rmult_eq_reg_l I1); [ | exact N1].
    transitivity (- (I1 * (a * n)) * (sn u * dn u)); [ring | rewrite A; field; exact N1].
  - replace (_ / I2) with (b * (n * (cn u * dn u))); [exact (G sn _ b S) | ].
    apply (Rmult_eq_reg_l I2); [ | exact N2].
    transitivity (I2 * (b * n) * (cn u * dn u)); [ring | rewrite B; field; exact N2].
  - replace (_ / I3) with (c * (n * - (m * (sn u * cn u)))); [exact (G dn _ c D) | ].
    apply (Rmult_eq_reg_l I3); [ | exact N3].
    transitivity (- (I3 * (m * (c * n))) * (sn u * cn u)); [ring | rewrite M; field; exact N3].
Qed.

(* Every motion that circles the third axis, of the largest or the smallest moment: a and c are its largest spins
   about the first and the third axis, each of either sign, so for all four pairs of signs there are such numbers. *)
Theorem closed_form (I1 I2 I3 a c e : R) :
  0 < I1 -> 0 < I2 -> 0 < I3 -> 0 < (I3 - I2) * (I2 - I1) -> c <> 0 ->
  let n := sqrt (c ^ 2 * ((I3 - I2) * (I3 - I1) / (I1 * I2))) in
  let b := I1 * a * n / ((I3 - I2) * c) in
  let m := I1 * (I2 - I1) * a ^ 2 / (I3 * (I3 - I2) * c ^ 2) in
  0 < n /\ 0 <= m /\
  forall sn cn dn, jacobi m sn cn dn ->
  motion I1 I2 I3 (fun t => a * cn (n * t + e)) (fun t => b * sn (n * t + e)) (fun t => c * dn (n * t + e)).
Proof.
  intros P1 P2 P3 O C n b m.
  assert (D : I3 - I2 <> 0) by nra.
  assert (C2 : 0 < c ^ 2) by (apply pow2_gt_0; exact C).
  assert (Q : 0 < c ^ 2 * ((I3 - I2) * (I3 - I1) / (I1 * I2))).
  { apply Rmult_lt_0_compat; [exact C2 | ]. apply Rdiv_lt_0_compat; [nra | apply Rmult_lt_0_compat; assumption]. }
  assert (N : 0 < n) by (apply sqrt_lt_R0; exact Q).
  assert (S : n * n = c ^ 2 * ((I3 - I2) * (I3 - I1) / (I1 * I2))) by (apply sqrt_sqrt; lra).
  split; [exact N | split].
  - unfold m. replace (_ / _) with (I1 * a ^ 2 * ((I3 - I2) * (I2 - I1)) / (I3 * c ^ 2 * (I3 - I2) ^ 2)) by (field; lra).
    apply Rdiv_le_0_compat.
    + apply Rmult_le_pos; [apply Rmult_le_pos; [lra | apply pow2_ge_0] | rewrite Rmult_comm; lra].
    + apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; assumption | apply pow2_gt_0, D].
  - intros sn cn dn J. apply (amplitudes_solve I1 I2 I3 a b c n m e); try lra; try exact J; clearbody n; unfold b, m.
    + field. split; [exact C | lra].
    + transitivity (I2 * I1 * a * (n * n) / ((I3 - I2) * c)); [field; split; [exact C | lra] | ].
      rewrite S. field. repeat split; lra.
    + field. repeat split; lra.
Qed.

(* The functions for the parameters zero and one: the steady wobble and the separatrix. *)
Theorem jacobi_of_zero : jacobi 0 sin cos (fun _ => 1).
Proof.
  unfold jacobi. split; [ | split; [ | split; [ | auto using sin_0, cos_0]]]; intros u; auto_derive; try exact I; ring.
Qed.

Theorem jacobi_of_one : jacobi 1
  (fun u => (exp u - exp (- u)) / (exp u + exp (- u)))
  (fun u => 2 / (exp u + exp (- u))) (fun u => 2 / (exp u + exp (- u))).
Proof.
  assert (P : forall u, exp u + exp (- u) <> 0) by (intros u; assert (A := exp_pos u); assert (B := exp_pos (- u)); lra).
  unfold jacobi. split; [ | split; [ | split; [ | rewrite Ropp_0, exp_0; repeat split; field]]];
    intros u; (auto_derive; [apply P | ]); rewrite exp_Ropp; assert (X := exp_pos u); field; repeat split; nra.
Qed.

(* The largest spins a and c of a motion on the separatrix may have any signs. *)
Theorem separatrix_of_all_signs (a c e : R) :
  a ^ 2 = 2 -> c ^ 2 = 1 ->
  exists n b, let u t := n * t + e in let cosh t := (exp (u t) + exp (- u t)) / 2 in
  motion 4 6 8 (fun t => a * (1 / cosh t)) (fun t => b * ((exp (u t) - exp (- u t)) / 2 / cosh t))
    (fun t => c * (1 / cosh t)).
Proof.
  intros A C.
  destruct (closed_form 4 6 8 a c e ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(intros ->; lra)) as (_ & _ & M).
  rewrite A, C in M. specialize (M (fun u => (exp u - exp (- u)) / (exp u + exp (- u)))
    (fun u => 2 / (exp u + exp (- u))) (fun u => 2 / (exp u + exp (- u)))).
  match type of M with jacobi ?m _ _ _ -> _ => replace m with 1 in M by field end.
  specialize (M jacobi_of_one).
  match type of M with motion _ _ _ _ (fun t => ?b * _) _ => exists (sqrt (1 * ((8 - 6) * (8 - 4) / (4 * 6)))), b end.
  cbv zeta. intros t. specialize (M t). cbv beta in M.
  assert (P : forall u, exp u + exp (- u) <> 0) by (intros u; assert (X := exp_pos u); assert (Y := exp_pos (- u)); lra).
  assert (S : forall k u, k * (1 / ((exp u + exp (- u)) / 2)) = k * (2 / (exp u + exp (- u))))
    by (intros k u; field; apply P).
  assert (T : forall k u, k * ((exp u - exp (- u)) / 2 / ((exp u + exp (- u)) / 2))
    = k * ((exp u - exp (- u)) / (exp u + exp (- u)))) by (intros k u; field; apply P).
  rewrite !S, !T. destruct M as (M1 & M2 & M3).
  split; [ | split]; (eapply is_derive_ext; [intros; first [apply eq_sym, S | apply eq_sym, T] | eassumption]).
Qed.
