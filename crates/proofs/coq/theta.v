(* Products of theta functions, coefficient by coefficient.

   A theta function is the sum of +-q^(n^2) exp(2 i n z) over all integers n, or over all halves of odd ones; the first
   is -i times its own. In f(z + w) g(z - w) the term of m and n has q^(m^2 + n^2) exp(2 i ((m + n) z + (m - n) w)). So
   a product is known by its coefficients at r = 2 (m + n) and s = 2 (m - n), each of which comes from one m and one n.
   Both sides of each theorem have the same coefficient at every r and s, of which there are infinitely many. That the
   double sums converge, and may be ordered by r and s, is not proven here. *)
From Coq Require Import ZArith Bool List Lia.
Open Scope Z_scope.

Record theta := { halves : bool; alternating : bool }.
Definition theta1 := {| halves := true; alternating := true |}.
Definition theta2 := {| halves := true; alternating := false |}.
Definition theta3 := {| halves := false; alternating := false |}.
Definition theta4 := {| halves := false; alternating := true |}.

(* The sign of the term with n = t / 2; zero where there is none. *)
Definition sign (f : theta) (t : Z) : Z :=
  if eqb (Z.odd t) (halves f) then if alternating f && Z.odd (t / 2) then -1 else 1 else 0.

(* The two factors -i, where both are the first. *)
Definition times_i (f g : theta) (x : Z) : Z :=
  if halves f && alternating f && (halves g && alternating g) then - x else x.

(* f(z + w) g(z - w); f(z) g(w) of the root of the nome; f(2 z) g(2 w) of its square. *)
Definition product f g r s :=
  times_i f g (if Z.even (r + s) then sign f ((r + s) / 2) * sign g ((r - s) / 2) else 0).
Definition of_the_root f g r s := times_i f g (sign f r * sign g s).
Definition of_the_square f g r s :=
  times_i f g (if Z.even r && Z.even s then sign f (r / 2) * sign g (s / 2) else 0).

(* With 2 m = (r + s) / 2 and 2 n = (r - s) / 2, the exponent of the nome is that of r and s. *)
Theorem exponents (m n : Z) : 2 * (m ^ 2 + n ^ 2) = (m + n) ^ 2 + (m - n) ^ 2.
Proof. ring. Qed.

(* All of these repeat when r or s moves by eight. *)
Definition repeats (F : Z -> Z -> Z) := forall r s a b, F (r + 8 * a) (s + 8 * b) = F r s.

Lemma half_moves (t k : Z) : (t + 2 * k) / 2 = t / 2 + k.
Proof. rewrite Z.mul_comm, Z.div_add; lia. Qed.

Lemma sign_repeats (f : theta) (t k : Z) : sign f (t + 4 * k) = sign f t.
Proof.
  unfold sign. replace (t + 4 * k) with (t + 2 * (2 * k)) by ring.
  now rewrite half_moves, !Z.odd_add_mul_2.
Qed.

Lemma product_repeats f g : repeats (product f g).
Proof.
  intros r s a b. unfold product.
  replace (r + 8 * a + (s + 8 * b)) with (r + s + 2 * (4 * (a + b))) by ring.
  replace (r + 8 * a - (s + 8 * b)) with (r - s + 2 * (4 * (a - b))) by ring.
  now rewrite Z.even_add_mul_2, !half_moves, !sign_repeats.
Qed.

Lemma root_repeats f g : repeats (of_the_root f g).
Proof.
  intros r s a b. unfold of_the_root.
  replace (8 * a) with (4 * (2 * a)) by ring. replace (8 * b) with (4 * (2 * b)) by ring. now rewrite !sign_repeats.
Qed.

Lemma square_repeats f g : repeats (of_the_square f g).
Proof.
  intros r s a b. unfold of_the_square.
  replace (8 * a) with (2 * (4 * a)) by ring. replace (8 * b) with (2 * (4 * b)) by ring.
  now rewrite !Z.even_add_mul_2, !half_moves, !sign_repeats.
Qed.

Definition eight := 0 :: 1 :: 2 :: 3 :: 4 :: 5 :: 6 :: 7 :: nil.

Lemma by_table (F G : Z -> Z -> Z) :
  repeats F -> repeats G -> forallb (fun r => forallb (fun s => F r s =? G r s) eight) eight = true ->
  forall r s, F r s = G r s.
Proof.
  intros RF RG T r s.
  assert (I : forall t, In (t mod 8) eight)
    by (intros t; assert (B := Z.mod_pos_bound t 8 eq_refl); unfold eight; simpl; lia).
  rewrite (Z.div_mod r 8), (Z.div_mod s 8), (Z.add_comm (8 * _) (r mod 8)), (Z.add_comm (8 * _) (s mod 8)), RF, RG by lia.
  apply Z.eqb_eq. rewrite forallb_forall in T. specialize (T _ (I r)). rewrite forallb_forall in T. exact (T _ (I s)).
Qed.

Ltac table :=
  apply by_table; [ | | vm_compute; reflexivity];
  intros ? ? ? ?; rewrite ?product_repeats, ?root_repeats, ?square_repeats; reflexivity.

(* The attitude's pair a = theta4, b = theta1 at a complex phase, both of the square of the nome: for a real z and an
   imaginary w the left sides are twice a conj(a), twice b conj(b) and twice conj(a) b. *)
Theorem a_times_its_conjugate : forall r s,
  2 * product theta4 theta4 r s = of_the_root theta4 theta3 r s + of_the_root theta3 theta4 r s.
Proof. table. Qed.

Theorem b_times_its_conjugate : forall r s,
  2 * product theta1 theta1 r s = of_the_root theta4 theta3 r s - of_the_root theta3 theta4 r s.
Proof. table. Qed.

Theorem b_times_conjugate_of_a : forall r s,
  2 * product theta4 theta1 r s = of_the_root theta1 theta2 r s - of_the_root theta2 theta1 r s.
Proof. table. Qed.

(* The pair of the complementary series, of the nome on the left. *)
Theorem complementary_a_times_its_conjugate : forall r s,
  product theta2 theta2 r s = of_the_square theta2 theta3 r s + of_the_square theta3 theta2 r s.
Proof. table. Qed.

Theorem complementary_b_times_its_conjugate : forall r s,
  product theta1 theta1 r s = of_the_square theta3 theta2 r s - of_the_square theta2 theta3 r s.
Proof. table. Qed.

Theorem complementary_b_times_conjugate_of_a : forall r s,
  product theta2 theta1 r s = of_the_square theta1 theta4 r s - of_the_square theta4 theta1 r s.
Proof. table. Qed.

(* What makes sn^2 + cn^2 and dn^2 + k^2 sn^2 one, where these are quotients of theta functions. *)
Theorem squares : forall r s,
  product theta3 theta3 r s = of_the_square theta3 theta3 r s + of_the_square theta2 theta2 r s /\
  product theta4 theta4 r s = of_the_square theta3 theta3 r s - of_the_square theta2 theta2 r s /\
  product theta2 theta2 r s = of_the_square theta2 theta3 r s + of_the_square theta3 theta2 r s.
Proof. intros r s. repeat split; revert r s; table. Qed.

(* A wrong sign is refuted. *)
Theorem a_minus_in_the_first_fails : exists r s,
  2 * product theta4 theta4 r s <> of_the_root theta4 theta3 r s - of_the_root theta3 theta4 r s.
Proof. exists 0, 0. vm_compute. discriminate. Qed.
