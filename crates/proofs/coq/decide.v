(* Decides equations between quotients of polynomials: a normal form that Coq's virtual machine computes, proven
   right once for all. What is divided by is a variable with powers below zero, until the end, where all is
   multiplied by it; a named part is put in its normal form once, wherever it occurs. *)
From Coq Require Import Reals ZArith QArith Qreals List Lra Lia.
Import ListNotations.
Open Scope R_scope.

(* Equations as data. Variables are numbered: even numbers have values other than zero. *)
Inductive term :=
  | Var (i : positive) | Num (n : Z) | Add (a b : term) | Sub (a b : term) | Mul (a b : term) | Div (a b : term)
  | Neg (a : term) | Pow (a : term) (n : nat).

(* A power of each variable, in the order of their numbers; and sums of such products, in falling order. *)
Definition monomial := list (positive * Z).
Definition polynomial := list (monomial * Q).

(* Sums of numbers in lowest terms. *)
Definition plus (a b : Q) : Q :=
  match a, b with
  | Qmake x 1, Qmake y 1 => Qmake (x + y) 1
  | _, _ => Qred (a + b)
  end.
Definition times (a b : Q) : Q :=
  match a, b with
  | Qmake x 1, Qmake y 1 => Qmake (x * y) 1
  | _, _ => Qred (a * b)
  end.
Definition negligible (a : Q) : bool := match Qnum a with Z0 => true | _ => false end.

Fixpoint compared (a b : monomial) : comparison :=
  match a, b with
  | [], [] => Eq
  | [], (_, y) :: _ => match y with Zneg _ => Gt | _ => Lt end
  | (_, x) :: _, [] => match x with Zneg _ => Lt | _ => Gt end
  | (i, x) :: a', (j, y) :: b' =>
      match Pos.compare i j with
      | Lt => match x with Zneg _ => Lt | _ => Gt end
      | Gt => match y with Zneg _ => Gt | _ => Lt end
      | Eq => match Z.compare x y with Eq => compared a' b' | c => c end
      end
  end.

(* The sum of two powers. One of a number that may be zero is never negative. *)
Definition joined (i : positive) (x y : Z) : Z := match i with xO _ => x + y | _ => Z.abs x + Z.abs y end.

Fixpoint product (a : monomial) : monomial -> monomial :=
  match a with
  | [] => fun b => b
  | (i, x) :: a' =>
      fix inner (b : monomial) : monomial :=
        match b with
        | [] => a
        | (j, y) :: b' =>
            match Pos.compare i j with
            | Lt => (i, x) :: product a' b
            | Gt => (j, y) :: inner b'
            | Eq => match joined i x y with Z0 => product a' b' | s => (i, s) :: product a' b' end
            end
        end
  end.

Fixpoint sum (p : polynomial) : polynomial -> polynomial :=
  match p with
  | [] => fun q => q
  | (m, c) :: p' =>
      fix inner (q : polynomial) : polynomial :=
        match q with
        | [] => p
        | (n, d) :: q' =>
            match compared m n with
            | Gt => (m, c) :: sum p' q
            | Lt => (n, d) :: inner q'
            | Eq => let s := plus c d in if negligible s then sum p' q' else (m, s) :: sum p' q'
            end
        end
  end.

Fixpoint scaled (m : monomial) (c : Q) (p : polynomial) : polynomial :=
  match p with
  | [] => []
  | (n, d) :: p' => (product m n, times c d) :: scaled m c p'
  end.

(* Sums of pairs, of pairs of pairs, and so on. *)
Fixpoint pairs (ps : list polynomial) : list polynomial :=
  match ps with
  | p :: q :: ps' => sum p q :: pairs ps'
  | _ => ps
  end.
Fixpoint total (rounds : nat) (ps : list polynomial) : polynomial :=
  match rounds, ps with
  | _, [] => []
  | _, [p] => p
  | S n, _ => total n (pairs ps)
  | O, _ => fold_right sum [] ps
  end.

Definition multiplied (p q : polynomial) : polynomial :=
  match p, q with
  | [([], c)], _ => scaled [] c q
  | _, _ => total 20 (map (fun '(m, c) => scaled m c q) p)
  end.

Definition number (c : Q) : polynomial := if negligible c then [] else [([], c)].
Definition variable (i : positive) (n : Z) : polynomial := [([(i, n)], 1%Q)].
Definition minus_one : Q := Qmake (-1) 1.

(* The power of a variable in a monomial, and the rest. *)
Fixpoint without (i : positive) (m : monomial) : Z * monomial :=
  match m with
  | [] => (0%Z, [])
  | (j, x) :: m' => if Pos.eqb i j then (x, m') else let '(y, r) := without i m' in (y, (j, x) :: r)
  end.

(* A polynomial as one in a single variable, falling. *)
Fixpoint put (e : Z) (m : monomial) (c : Q) (parts : list (Z * polynomial)) : list (Z * polynomial) :=
  match parts with
  | [] => [(e, [(m, c)])]
  | (f, p) :: parts' =>
      match Z.compare e f with
      | Eq => (f, (m, c) :: p) :: parts'
      | Gt => (e, [(m, c)]) :: parts
      | Lt => (f, p) :: put e m c parts'
      end
  end.
Definition parted (i : positive) (p : polynomial) : list (Z * polynomial) :=
  fold_right (fun '(m, c) parts => let '(e, r) := without i m in put e r c parts) [] p.

(* What ties variables: squares, and what they equal. *)
Definition ties := list (positive * polynomial).

Fixpoint powers (multiply : polynomial -> polynomial -> polynomial) (p : polynomial) (n : nat) : polynomial :=
  match n with
  | O => number 1
  | S O => p
  | S n => multiply p (powers multiply p n)
  end.

Definition squared (i : positive) (q : polynomial) (part : Z * polynomial) : polynomial :=
  let '(e, p) := part in
  let power := if Z.eqb (e mod 2) 0 then [] else [(i, e mod 2)%Z] in
  multiplied (scaled power 1 (powers multiplied q (Z.to_nat (e / 2)))) p.
Definition high (part : Z * polynomial) : bool := Z.leb 2 (fst part).
Definition back (i : positive) (part : Z * polynomial) : polynomial :=
  let '(e, p) := part in if Z.eqb e 0 then p else scaled [(i, e)] 1 p.
Fixpoint reduced (t : ties) (p : polynomial) : polynomial :=
  match t with
  | [] => p
  | (i, q) :: t' =>
      let parts := parted i p in
      if existsb high parts
      then reduced t' (total 20 (map (fun part => if high part then squared i q part else back i part) parts))
      else reduced t' p
  end.

Section Normal.
Variable t : ties.
(* Divisors, each with the number of the variable that stands for it. *)
Variable divisors : list (positive * term).

Definition mul (p q : polynomial) : polynomial := reduced t (multiplied p q).

Fixpoint same (a b : term) : bool :=
  match a, b with
  | Var i, Var j => Pos.eqb i j
  | Num x, Num y => Z.eqb x y
  | Add a b, Add c d | Sub a b, Sub c d | Mul a b, Mul c d | Div a b, Div c d => same a c && same b d
  | Neg a, Neg c => same a c
  | Pow a n, Pow c m => same a c && Nat.eqb n m
  | _, _ => false
  end.

(* Named parts that are known: their normal form, and that of one over them if it is a product. *)
Definition known := list (positive * (polynomial * option polynomial)).
Fixpoint found {T : Type} (i : positive) (k : list (positive * T)) : option T :=
  match k with
  | [] => None
  | (j, x) :: k' => if Pos.eqb i j then Some x else found i k'
  end.

Definition both (f : polynomial -> polynomial -> polynomial) (a b : option polynomial) : option polynomial :=
  match a, b with Some p, Some q => Some (f p q) | _, _ => None end.

(* The normal form, and that of one over it. *)
Fixpoint normal (k : known) (e : term) : option polynomial :=
  match e with
  | Var i => match found i k with Some (p, _) => Some p | None => Some (variable i 1) end
  | Num n => Some (number (inject_Z n))
  | Add a b => both sum (normal k a) (normal k b)
  | Sub a b => both (fun p q => sum p (scaled [] minus_one q)) (normal k a) (normal k b)
  | Mul a b => both mul (normal k a) (normal k b)
  | Div a b => both mul (normal k a) (inverse k b)
  | Neg a => option_map (scaled [] minus_one) (normal k a)
  | Pow a n => option_map (fun p => powers mul p n) (normal k a)
  end
with inverse (k : known) (e : term) : option polynomial :=
  match find (fun '(_, d) => same d e) divisors with
  | Some (z, _) => Some (variable (xO z) (-1))
  | None =>
      match e with
      | Var i =>
          match found i k with
          | Some (_, q) => q
          | None => match i with xO _ => Some (variable i (-1)) | _ => None end
          end
      | Num n => match n with Z0 => None | _ => Some (number (Qinv (inject_Z n))) end
      | Mul a b => both mul (inverse k a) (inverse k b)
      | Div a b => both mul (inverse k a) (normal k b)
      | Neg a => option_map (scaled [] minus_one) (inverse k a)
      | Pow a n => option_map (fun p => powers mul p n) (inverse k a)
      | Add _ _ | Sub _ _ => None
      end
  end.
End Normal.

(* What is stated: named parts, divisors and ties. *)
Record statement := {
  squares : list (positive * term);
  below : list (positive * term);
  parts : list (positive * term) }.

Fixpoint tied (t : ties) (all : list (positive * term)) : option ties :=
  match all with
  | [] => Some t
  | (i, e) :: all' =>
      match normal t [] [] e, tied t all' with Some p, Some t' => Some ((i, p) :: t') | _, _ => None end
  end.

Fixpoint learned (t : ties) (d : list (positive * term)) (k : known) (all : list (positive * term)) : option known :=
  match all with
  | [] => Some k
  | (i, e) :: all' =>
      match normal t d k e with
      | None => None
      | Some p =>
          let q := match i with
                   | xO _ => Some (variable i (-1))
                   | _ => match e with Add _ _ | Sub _ _ => None | _ => inverse t d k e end
                   end in
          learned t d ((i, (p, q)) :: k) all'
      end
  end.

(* Multiplied by a power of what stands for a divisor, and the divisor put in. *)
Fixpoint horner (t : ties) (q acc : polynomial) (e : Z) (ps : list (Z * polynomial)) : option polynomial :=
  match ps with
  | [] => Some acc
  | (f, p) :: ps' =>
      if Z.leb f e
      then horner t q (sum (mul t acc (powers (mul t) q (Z.to_nat (e - f)))) p) f ps'
      else None
  end.
Definition cleared (t : ties) (z : positive) (q p : polynomial) : option polynomial :=
  match parted (xO z) p with
  | [] => Some []
  | (e, acc) :: ps => if Z.leb 0 e then
      match e, ps with Z0, [] => Some p | _, _ => horner t q acc e ps end
    else horner t q [] 0 ((e, acc) :: ps)
  end.
Fixpoint eliminated (t : ties) (d : list (positive * term)) (k : known) (all : list (positive * term)) (p : polynomial)
  : option polynomial :=
  match all with
  | [] => Some p
  | (z, e) :: all' =>
      match eliminated t d k all' p with
      | None => None
      | Some [] => Some []
      | Some p' => match normal t d k e with None => None | Some q => cleared t z q p' end
      end
  end.
(* Powers below zero of variables that are tied. *)
Fixpoint lifted (t : ties) (all : ties) (p : polynomial) : polynomial :=
  match all with
  | [] => p
  | (xO z, _) :: all' =>
      let least := fold_right Z.min 0%Z (map fst (parted (xO z) p)) in
      lifted t all' (if Z.eqb least 0 then p else mul t p (variable (xO z) (- least)))
  | _ :: all' => lifted t all' p
  end.

Definition decided (s : statement) (l r : term) : bool :=
  match tied [] (squares s) with
  | None => false
  | Some t =>
      match learned t (below s) [] (parts s) with
      | None => false
      | Some k =>
          match both (fun p q => sum p (scaled [] minus_one q)) (normal t (below s) k l) (normal t (below s) k r) with
          | None => false
          | Some p =>
              match eliminated t (below s) k (below s) p with
              | None => false
              | Some p' => match lifted t t p' with [] => true | _ => false end
              end
          end
      end
  end.

(* Whether a polynomial is above zero since all its coefficients are, and all its variables; and a number, for that. *)
Definition rising (p : polynomial) : bool :=
  match p with
  | [] => false
  | _ => forallb (fun '(m, c) =>
      Z.ltb 0 (Qnum c) && forallb (fun '(i, _) => match i with xO _ => true | _ => false end) m) p
  end.
Definition rises (s : statement) (l : term) : bool :=
  match learned [] (below s) [] (parts s) with
  | None => false
  | Some k =>
      match normal [] (below s) k l with
      | None => false
      | Some p => match eliminated [] (below s) k (below s) p with None => false | Some r => rising r end
      end
  end.

(* ---- That this is right. *)
Inductive tree := Leaf | Node (x : R) (even odd : tree).
Fixpoint at_place (i : positive) (t : tree) {struct t} : R :=
  match t with
  | Leaf => 1
  | Node x even odd =>
      match i with xH => x | xO j => at_place j even | xI j => at_place j odd end
  end.

Section Right.
Variables other some : tree.
Hypothesis nonzero : forall i, at_place i some <> 0.

Definition value (i : positive) : R :=
  match i with xO p => at_place p some | xI p => at_place p other | xH => 0 end.

Fixpoint meaning (e : term) : R :=
  match e with
  | Var i => value i
  | Num n => IZR n
  | Add a b => meaning a + meaning b
  | Sub a b => meaning a - meaning b
  | Mul a b => meaning a * meaning b
  | Div a b => meaning a / meaning b
  | Neg a => - meaning a
  | Pow a n => meaning a ^ n
  end.

Definition power (i : positive) (n : Z) : R :=
  match i with xO _ => powerRZ (value i) n | _ => value i ^ Z.abs_nat n end.

Fixpoint mono (m : monomial) : R := match m with [] => 1 | (i, n) :: m' => power i n * mono m' end.
Fixpoint poly (p : polynomial) : R := match p with [] => 0 | (m, c) :: p' => Q2R c * mono m + poly p' end.

Lemma power_0 i : power i 0 = 1.
Proof. destruct i; reflexivity. Qed.

Lemma power_joined i x y : power i (joined i x y) = power i x * power i y.
Proof.
  destruct i as [p | p | ]; unfold power, joined.
  2: apply powerRZ_add, nonzero.
  all: rewrite <- pow_add; f_equal; lia.
Qed.

Lemma power_split i x y : (0 <= x)%Z -> (0 <= y)%Z -> power i (x + y) = power i x * power i y.
Proof.
  intros X Y. destruct i as [p | p | ]; unfold power.
  2: apply powerRZ_add, nonzero.
  all: rewrite <- pow_add; f_equal; lia.
Qed.

Lemma product_right a b : mono (product a b) = mono a * mono b.
Proof.
  revert b. induction a as [ | [i x] a IH]; intros b; [simpl; ring | ].
  induction b as [ | [j y] b IHb]; [simpl; ring | ].
  simpl. destruct (Pos.compare i j) eqn:C.
  - apply Pos.compare_eq in C. subst j.
    assert (P := power_joined i x y). destruct (joined i x y) eqn:S; simpl; rewrite IH.
    + rewrite power_0 in P. transitivity (1 * (mono a * mono b)); [ring | rewrite P; ring].
    + rewrite P. ring.
    + rewrite P. ring.
  - simpl. rewrite IH. simpl. ring.
  - simpl in *. rewrite IHb. ring.
Qed.

Lemma compared_right a b : compared a b = Eq -> a = b.
Proof.
  revert b. induction a as [ | [i x] a IH]; intros [ | [j y] b]; simpl; try easy.
  - destruct y; easy.
  - destruct x; easy.
  - destruct (Pos.compare i j) eqn:C.
    + apply Pos.compare_eq in C. destruct (Z.compare x y) eqn:D; try easy.
      apply Z.compare_eq in D. intros E. apply IH in E. congruence.
    + destruct x; easy.
    + destruct y; easy.
Qed.

Lemma reduced_number a : Q2R (Qred a) = Q2R a.
Proof. apply Qeq_eqR, Qred_correct. Qed.
Lemma whole x : Q2R (Qmake x 1) = IZR x.
Proof. unfold Q2R. simpl. field. Qed.
Lemma plus_right a b : Q2R (plus a b) = Q2R a + Q2R b.
Proof.
  assert (G := reduced_number (a + b)). rewrite Q2R_plus in G. rewrite <- G.
  destruct a as [x u], b as [y v]. unfold plus. destruct u; try reflexivity. destruct v; try reflexivity.
  rewrite G, !whole. apply plus_IZR.
Qed.
Lemma times_right a b : Q2R (times a b) = Q2R a * Q2R b.
Proof.
  assert (G := reduced_number (a * b)). rewrite Q2R_mult in G. rewrite <- G.
  destruct a as [x u], b as [y v]. unfold times. destruct u; try reflexivity. destruct v; try reflexivity.
  rewrite G, !whole. apply mult_IZR.
Qed.
Lemma negligible_right a : negligible a = true -> Q2R a = 0.
Proof. destruct a as [[ | x | x] u]; try easy. intros _. unfold Q2R. simpl. ring. Qed.

Lemma sum_right p q : poly (sum p q) = poly p + poly q.
Proof.
  revert q. induction p as [ | [m c] p IH]; intros q; [simpl; ring | ].
  induction q as [ | [n d] q IHq]; [simpl; ring | ].
  simpl. destruct (compared m n) eqn:C.
  - apply compared_right in C. subst n.
    assert (S := plus_right c d). destruct (negligible (plus c d)) eqn:N.
    + apply negligible_right in N. rewrite IH. simpl.
      transitivity ((Q2R c + Q2R d) * mono m + (poly p + poly q)); [rewrite <- S, N | ]; ring.
    + simpl. rewrite IH, S. ring.
  - simpl in *. rewrite IHq. ring.
  - simpl. rewrite IH. simpl. ring.
Qed.

Lemma scaled_right m c p : poly (scaled m c p) = Q2R c * mono m * poly p.
Proof.
  induction p as [ | [n d] p IH]; simpl; [ring | ].
  rewrite IH, product_right, times_right. ring.
Qed.

Definition all (ps : list polynomial) : R := fold_right (fun p s => poly p + s) 0 ps.

Lemma pairs_right n ps : (length ps <= n)%nat -> all (pairs ps) = all ps.
Proof.
  revert ps. induction n as [ | n IH]; intros [ | p [ | q ps]] L; simpl in *; try reflexivity; try lia.
  change (poly (sum p q) + all (pairs ps) = poly p + (poly q + all ps)).
  rewrite IH, sum_right by lia. ring.
Qed.

Lemma fold_sum_right ps : poly (fold_right sum [] ps) = all ps.
Proof. induction ps as [ | p ps IH]; simpl; [reflexivity | rewrite sum_right, IH; reflexivity]. Qed.

Lemma total_right n ps : poly (total n ps) = all ps.
Proof.
  revert ps. induction n as [ | n IH]; intros [ | p [ | q ps]]; try (simpl; ring).
  - unfold total. apply fold_sum_right.
  - change (poly (total n (pairs (p :: q :: ps))) = all (p :: q :: ps)).
    rewrite IH. apply (pairs_right (length (p :: q :: ps))). reflexivity.
Qed.

Lemma one : Q2R 1 = 1.
Proof. unfold Q2R. simpl. field. Qed.

Lemma multiplied_right p q : poly (multiplied p q) = poly p * poly q.
Proof.
  assert (G : poly (total 20 (map (fun '(m, c) => scaled m c q) p)) = poly p * poly q).
  { rewrite total_right. induction p as [ | [m c] p IH]; simpl; [ring | ].
    simpl in *. fold (all (map (fun '(m0, c0) => scaled m0 c0 q) p)). rewrite IH, scaled_right. ring. }
  unfold multiplied. destruct p as [ | [[ | x m] c] [ | y p]]; exact G.
Qed.

Opaque total multiplied scaled sum.

Lemma number_right c : poly (number c) = Q2R c.
Proof. unfold number. destruct (negligible c) eqn:N; simpl; [symmetry; apply negligible_right, N | ring]. Qed.
Lemma variable_right i n : poly (variable i n) = power i n.
Proof. simpl. rewrite one. ring. Qed.
Lemma minus_right p : poly (scaled [] minus_one p) = - poly p.
Proof. rewrite scaled_right. unfold minus_one. rewrite whole. simpl. ring. Qed.

Lemma without_right i m : let '(e, r) := without i m in mono m = power i e * mono r.
Proof.
  induction m as [ | [j x] m IH]; simpl; [rewrite power_0; ring | ].
  destruct (Pos.eqb_spec i j) as [-> | N]; [reflexivity | ].
  destruct (without i m) as [e r]. simpl. rewrite IH. ring.
Qed.

Definition value_of_parts (i : positive) (ps : list (Z * polynomial)) : R :=
  fold_right (fun '(e, p) s => power i e * poly p + s) 0 ps.

Lemma put_right i e m c ps :
  value_of_parts i (put e m c ps) = power i e * (Q2R c * mono m) + value_of_parts i ps.
Proof.
  induction ps as [ | [f p] ps IH]; simpl; [ring | ].
  destruct (Z.compare e f) eqn:C; simpl.
  - apply Z.compare_eq in C. subst f. ring.
  - simpl in *. rewrite IH. ring.
  - ring.
Qed.

Lemma parted_right i p : value_of_parts i (parted i p) = poly p.
Proof.
  induction p as [ | [m c] p IH]; [reflexivity | ].
  simpl. assert (W := without_right i m). destruct (without i m) as [e r].
  rewrite put_right. fold (parted i p). rewrite IH, W. ring.
Qed.

Definition tied_right (t : ties) : Prop := Forall (fun '(i, q) => value i ^ 2 = poly q) t.

Lemma powers_right f p n :
  (forall a b, poly (f a b) = poly a * poly b) -> poly (powers f p n) = poly p ^ n.
Proof.
  intros F. induction n as [ | [ | n] IH].
  - change (poly (number 1) = 1). rewrite number_right. apply one.
  - simpl. ring.
  - change (poly (f p (powers f p (S n))) = poly p ^ S (S n)). rewrite F, IH. reflexivity.
Qed.

Lemma power_even i q n : value i ^ 2 = poly q -> (0 <= n)%Z -> power i (2 * n) = poly q ^ Z.to_nat n.
Proof.
  intros T N. rewrite <- T, <- pow_mult. destruct i as [p | p | ]; unfold power.
  2: rewrite <- (Z2Nat.id (2 * n)) by lia; rewrite <- pow_powerRZ.
  all: f_equal; lia.
Qed.

Lemma squared_right i q e p :
  value i ^ 2 = poly q -> (2 <= e)%Z -> poly (squared i q (e, p)) = power i e * poly p.
Proof.
  intros T E. unfold squared.
  assert (D := Z.div_mod e 2 ltac:(lia)). assert (B := Z.mod_pos_bound e 2 ltac:(lia)).
  assert (P : power i e = power i (2 * (e / 2)) * power i (e mod 2)).
  { rewrite <- power_split by (try apply Z.mul_nonneg_nonneg; try apply Z.div_pos; lia). f_equal. exact D. }
  rewrite P, (power_even i q) by (auto; apply Z.div_pos; lia).
  rewrite multiplied_right, scaled_right, one, (powers_right multiplied) by apply multiplied_right.
  destruct (Z.eqb_spec (e mod 2) 0) as [Z | Z]; [rewrite Z, power_0 | ]; cbn [mono]; ring.
Qed.

Lemma back_right i e p : poly (back i (e, p)) = power i e * poly p.
Proof.
  unfold back. destruct (Z.eqb_spec e 0) as [-> | N]; [rewrite power_0; ring | ].
  rewrite scaled_right, one. cbn [mono]. ring.
Qed.

Lemma reduced_right t p : tied_right t -> poly (reduced t p) = poly p.
Proof.
  intros T. revert p. induction T as [ | [i q] t S T IH]; intros p; [reflexivity | ].
  cbn [reduced]. destruct (existsb high (parted i p)); [ | apply IH].
  rewrite IH, total_right. rewrite <- (parted_right i p).
  generalize (parted i p). intros ps. induction ps as [ | [e r] ps IHps]; [reflexivity | ].
  change (poly (if high (e, r) then squared i q (e, r) else back i (e, r))
    + all (map (fun part => if high part then squared i q part else back i part) ps)
    = power i e * poly r + value_of_parts i ps).
  rewrite IHps. f_equal. unfold high. cbn [fst]. destruct (Z.leb_spec 2 e); [apply squared_right | apply back_right]; assumption.
Qed.

Lemma mul_right t p q : tied_right t -> poly (mul t p q) = poly p * poly q.
Proof. intros T. unfold mul. rewrite reduced_right by assumption. apply multiplied_right. Qed.

Lemma same_right a b : same a b = true -> a = b.
Proof.
  revert b. induction a; intros b; destruct b; simpl; try easy.
  - intros E. apply Pos.eqb_eq in E. congruence.
  - intros E. apply Z.eqb_eq in E. congruence.
  - intros E. apply andb_prop in E. destruct E. f_equal; auto.
  - intros E. apply andb_prop in E. destruct E. f_equal; auto.
  - intros E. apply andb_prop in E. destruct E. f_equal; auto.
  - intros E. apply andb_prop in E. destruct E. f_equal; auto.
  - intros E. f_equal; auto.
  - intros E. apply andb_prop in E. destruct E as [E F]. apply Nat.eqb_eq in F. f_equal; auto.
Qed.

Definition known_right (k : known) : Prop :=
  Forall (fun '(i, (p, q)) => poly p = value i /\ match q with Some q => poly q = / value i | None => True end) k.
Definition divisors_right (d : list (positive * term)) : Prop := Forall (fun '(z, e) => value (xO z) = meaning e) d.

Lemma found_right {T} (P : positive * T -> Prop) i k x : Forall P k -> found i k = Some x -> P (i, x).
Proof.
  induction 1 as [ | [j y] k Y K IH]; simpl; [easy | ].
  destruct (Pos.eqb_spec i j) as [-> | N]; [intros E; injection E as ->; exact Y | exact IH].
Qed.

Lemma power_1 i : power i 1 = value i.
Proof. destruct i; simpl; ring. Qed.
Lemma power_below p : power (xO p) (-1) = / value (xO p).
Proof. simpl. rewrite Rmult_1_r. reflexivity. Qed.

Lemma normal_right t d k e :
  tied_right t -> divisors_right d -> known_right k ->
  (forall p, normal t d k e = Some p -> poly p = meaning e)
  /\ (forall p, inverse t d k e = Some p -> poly p = / meaning e).
Proof.
  intros T D K.
  assert (L : forall e z f, find (fun '(_, d) => same d e) d = Some (z, f) ->
    forall v p, v = meaning e -> Some (variable (xO z) (-1)) = Some p -> poly p = / v).
  { intros g z f F v p -> E. injection E as <-. rewrite variable_right, power_below.
    apply find_some in F. destruct F as [I F]. apply same_right in F. subst f.
    unfold divisors_right in D. rewrite Forall_forall in D. rewrite (D _ I). reflexivity. }
  assert (U : forall f a b p, both f a b = Some p -> exists x y, a = Some x /\ b = Some y /\ p = f x y).
  { intros f [x | ] [y | ] p E; try easy. injection E as <-. eauto. }
  assert (M := fun a b => mul_right t a b T).
  induction e as [i | n | a [Pa Ia] b [Pb Ib] | a [Pa Ia] b [Pb Ib] | a [Pa Ia] b [Pb Ib] | a [Pa Ia] b [Pb Ib]
    | a [Pa Ia] | a [Pa Ia] n]; split; intros p; cbn [normal inverse meaning];
  try (match goal with |- context [find ?f ?l] => destruct (find f l) as [[z g] | ] eqn:F end;
    [eapply L; [eassumption | reflexivity] | ]).
  - destruct (found i k) as [[q r] | ] eqn:F; intros E; injection E as <-.
    + apply (found_right _ _ _ _ K) in F. apply F.
    + rewrite variable_right. apply power_1.
  - destruct (found i k) as [[q r] | ] eqn:G.
    + apply (found_right _ _ _ _ K) in G. intros ->. apply G.
    + destruct i; try easy. intros E. injection E as <-. rewrite variable_right. apply power_below.
  - intros E. injection E as <-. rewrite number_right. apply whole.
  - intros E. assert (N : n <> 0%Z) by (intros ->; discriminate).
    assert (E' : Some (number (/ inject_Z n)) = Some p) by (destruct n; [easy | exact E | exact E]).
    injection E' as <-. rewrite number_right, Q2R_inv.
    + f_equal. apply whole.
    + unfold Qeq. simpl. lia.
  - intros E. apply U in E. destruct E as (x & y & X & Y & ->). rewrite sum_right, (Pa _ X), (Pb _ Y). reflexivity.
  - easy.
  - intros E. apply U in E. destruct E as (x & y & X & Y & ->).
    rewrite sum_right, minus_right, (Pa _ X), (Pb _ Y). reflexivity.
  - easy.
  - intros E. apply U in E. destruct E as (x & y & X & Y & ->). rewrite M, (Pa _ X), (Pb _ Y). reflexivity.
  - intros E. apply U in E. destruct E as (x & y & X & Y & ->). rewrite M, (Ia _ X), (Ib _ Y), Rinv_mult. reflexivity.
  - intros E. apply U in E. destruct E as (x & y & X & Y & ->). rewrite M, (Pa _ X), (Ib _ Y). reflexivity.
  - intros E. apply U in E. destruct E as (x & y & X & Y & ->). rewrite M, (Ia _ X), (Pb _ Y). unfold Rdiv.
    rewrite Rinv_mult, Rinv_inv. reflexivity.
  - destruct (normal t d k a) as [x | ] eqn:X; try easy. intros E. injection E as <-.
    rewrite minus_right, (Pa _ eq_refl). reflexivity.
  - destruct (inverse t d k a) as [x | ] eqn:X; try easy. intros E. injection E as <-.
    rewrite minus_right, (Ia _ eq_refl), Rinv_opp. reflexivity.
  - destruct (normal t d k a) as [x | ] eqn:X; try easy. intros E. injection E as <-.
    rewrite (powers_right (mul t)), (Pa _ eq_refl) by exact M. reflexivity.
  - destruct (inverse t d k a) as [x | ] eqn:X; try easy. intros E. injection E as <-.
    rewrite (powers_right (mul t)), (Ia _ eq_refl), pow_inv by exact M. reflexivity.
Qed.

Definition holds (e : positive * term) : Prop := value (fst e) = meaning (snd e).

Lemma tied_right_of squares t u :
  tied_right t -> Forall (fun '(i, e) => value i ^ 2 = meaning e) squares -> tied t squares = Some u -> tied_right u.
Proof.
  intros T S. revert u. induction S as [ | [i e] squares S Ss IH]; intros u; simpl.
  - intros E. injection E as <-. exact T.
  - destruct (normal t [] [] e) as [p | ] eqn:P; try easy. destruct (tied t squares) as [t' | ]; try easy.
    intros E. injection E as <-. constructor; [ | apply IH; reflexivity].
    rewrite S. symmetry. eapply normal_right; [exact T | constructor | constructor | exact P].
Qed.

Lemma learned_right t d k all u :
  tied_right t -> divisors_right d -> known_right k -> Forall holds all -> learned t d k all = Some u -> known_right u.
Proof.
  intros T D K A. revert k K. induction A as [ | [i e] all A As IH]; intros k K; simpl.
  - intros E. injection E as <-. exact K.
  - destruct (normal t d k e) as [p | ] eqn:P; try easy. apply IH. constructor; [ | exact K].
    unfold holds in A. simpl in A. rewrite A. destruct (normal_right t d k e T D K) as [N I].
    split; [apply N, P | ].
    assert (G : match match e with Add _ _ | Sub _ _ => None | _ => inverse t d k e end with
      | Some q => poly q = / meaning e | None => True end).
    { destruct e; try exact Logic.I;
      match goal with |- context [inverse t d k ?x] => destruct (inverse t d k x) eqn:J end; auto. }
    destruct i; try exact G. rewrite variable_right, power_below, A. reflexivity.
Qed.

Lemma horner_right t q acc z e ps r :
  tied_right t -> poly q = value (xO z) -> horner t q acc e ps = Some r ->
  exists n, power (xO z) e * poly acc + value_of_parts (xO z) ps = power (xO z) n * poly r.
Proof.
  intros T Q. revert acc e. induction ps as [ | [f p] ps IH]; intros acc e; simpl.
  - intros E. injection E as <-. exists e. ring.
  - destruct (Z.leb_spec f e) as [F | F]; try easy. intros E. destruct (IH _ _ E) as [n H]. exists n.
    rewrite sum_right, mul_right, (powers_right (mul t)), Q in H by (auto; intros; apply mul_right; auto).
    simpl in H. rewrite <- H. simpl.
    replace (powerRZ (at_place z some) e)
      with (powerRZ (at_place z some) f * at_place z some ^ Z.to_nat (e - f)); [ring | ].
    rewrite pow_powerRZ, <- powerRZ_add by apply nonzero. f_equal. lia.
Qed.

Lemma cleared_right t z q p r :
  tied_right t -> poly q = value (xO z) -> cleared t z q p = Some r -> exists n, poly p = power (xO z) n * poly r.
Proof.
  intros T Q C. rewrite <- (parted_right (xO z)). revert C. unfold cleared.
  destruct (parted (xO z) p) as [ | [e acc] ps] eqn:P.
  - intros E. injection E as <-. exists 0%Z. simpl. ring.
  - destruct (Z.leb 0 e).
    + assert (G : horner t q acc e ps = Some r ->
        exists n, value_of_parts (xO z) ((e, acc) :: ps) = power (xO z) n * poly r)
        by (intros H; exact (horner_right _ _ _ _ _ _ _ T Q H)).
      destruct e; try exact G. destruct ps; try exact G. intros E. injection E as <-. exists 0%Z.
      rewrite <- P, parted_right. simpl. ring.
    + intros H. destruct (horner_right t q [] z 0 _ r T Q H) as [n N]. exists n. rewrite <- N. simpl. ring.
Qed.

(* What is multiplied by on the way: never zero, and above zero where all divisors are. *)
Definition harmless (c : R) : Prop := c <> 0 /\ ((forall i, 0 < at_place i some) -> 0 < c).

Lemma eliminated_right t d k all p r :
  tied_right t -> divisors_right d -> known_right k -> divisors_right all ->
  eliminated t d k all p = Some r -> exists c, harmless c /\ poly p = c * poly r.
Proof.
  intros T D K A. revert r. induction A as [ | [z e] all A As IH]; intros r; simpl.
  - intros E. injection E as <-. exists 1. repeat split; intros; lra.
  - destruct (eliminated t d k all p) as [p' | ]; try easy. destruct (IH p' eq_refl) as (c & (N & P) & ->).
    destruct p' as [ | x p'].
    + intros E. injection E as <-. exists c. repeat split; assumption.
    + destruct (normal t d k e) as [q | ] eqn:M; try easy. intros C.
      apply cleared_right in C; [ | exact T | rewrite A; exact (proj1 (normal_right t d k e T D K) q M)].
      destruct C as [n ->]. exists (c * powerRZ (at_place z some) n). repeat split.
      * apply Rmult_integral_contrapositive. split; [exact N | apply powerRZ_NOR, nonzero].
      * intros S. apply Rmult_lt_0_compat; [apply P, S | apply powerRZ_lt, S].
      * simpl. ring.
Qed.

Lemma lifted_right t all p : tied_right t -> poly (lifted t all p) = 0 -> poly p = 0.
Proof.
  intros T. revert p. induction all as [ | [i q] all IH]; intros p; simpl; [easy | ].
  destruct i as [i | i | ]; [apply IH | | apply IH].
  intros Z. apply IH in Z. revert Z.
  destruct (Z.eqb _ 0); [easy | ].
  rewrite mul_right, variable_right by exact T. intros Z. apply Rmult_integral in Z.
  destruct Z as [Z | Z]; [exact Z | ]. exfalso. revert Z. apply powerRZ_NOR, nonzero.
Qed.

Theorem decided_right s l r :
  Forall (fun '(i, e) => value i ^ 2 = meaning e) (squares s) -> divisors_right (below s) -> Forall holds (parts s) ->
  decided s l r = true -> meaning l = meaning r.
Proof.
  intros S D P. unfold decided.
  destruct (tied [] (squares s)) as [t | ] eqn:T; try easy.
  apply tied_right_of in T; [ | constructor | exact S].
  destruct (learned t (below s) [] (parts s)) as [k | ] eqn:K; try easy.
  apply learned_right in K; [ | exact T | exact D | constructor | exact P].
  destruct (normal_right t (below s) k l T D K) as [L _]. destruct (normal_right t (below s) k r T D K) as [Q _].
  destruct (normal t (below s) k l) as [x | ]; try easy. destruct (normal t (below s) k r) as [y | ]; try easy.
  simpl. destruct (eliminated _ _ _ _ _) as [z | ] eqn:E; try easy.
  destruct (lifted t t z) eqn:F; try easy. intros _.
  apply Rminus_diag_uniq. rewrite <- (L x eq_refl), <- (Q y eq_refl).
  assert (Z : poly z = 0) by (apply (lifted_right t t z T); rewrite F; reflexivity).
  destruct (eliminated_right _ _ _ _ _ _ T D K D E) as (c & _ & V).
  rewrite sum_right, minus_right, Z, Rmult_0_r in V. exact V.
Qed.

Lemma rising_right p : (forall i, 0 < at_place i some) -> rising p = true -> 0 < poly p.
Proof.
  intros S R.
  assert (G : forall p, rising p = true \/ p = [] -> 0 <= poly p /\ (p <> [] -> 0 < poly p)).
  { clear p R. induction p as [ | [m c] p IH]; intros R; [split; [simpl; lra | easy] | ].
    destruct R as [R | R]; [ | easy]. simpl in R. apply andb_prop in R. destruct R as [R A].
    apply andb_prop in R. destruct R as [C M].
    assert (0 < mono m).
    { clear IH A. induction m as [ | [i n] m IH]; [simpl; lra | ]. simpl in M. apply andb_prop in M. destruct M as [I M].
      destruct i as [ | i | ]; try easy. simpl. apply Rmult_lt_0_compat; [apply powerRZ_lt, S | apply IH, M]. }
    assert (0 < Q2R c).
    { apply Z.ltb_lt in C. unfold Q2R. apply Rmult_lt_0_compat; [apply (IZR_lt 0), C | ].
      apply Rinv_0_lt_compat, (IZR_lt 0). reflexivity. }
    destruct (IH ltac:(destruct p; auto)) as [P _].
    assert (0 < Q2R c * mono m) by (apply Rmult_lt_0_compat; assumption). simpl. lra. }
  apply G; [left; exact R | intros ->; discriminate].
Qed.

Theorem rises_right s l :
  (forall i, 0 < at_place i some) -> divisors_right (below s) -> Forall holds (parts s) ->
  rises s l = true -> 0 < meaning l.
Proof.
  intros S D P. unfold rises. assert (T : tied_right []) by constructor.
  destruct (learned [] (below s) [] (parts s)) as [k | ] eqn:K; try easy.
  apply learned_right in K; [ | exact T | exact D | constructor | exact P].
  destruct (normal_right [] (below s) k l T D K) as [L _].
  destruct (normal [] (below s) k l) as [x | ]; try easy.
  destruct (eliminated [] (below s) k (below s) x) as [r | ] eqn:E; try easy. intros R.
  destruct (eliminated_right _ _ _ _ _ _ T D K D E) as (c & [_ C] & V).
  rewrite <- (L x eq_refl), V. apply Rmult_lt_0_compat; [apply C, S | apply rising_right; assumption].
Qed.
End Right.
Transparent total multiplied scaled sum.

(* ---- The same for a goal whose hypotheses are read off. *)
Fixpoint apart (t : tree) : Prop := match t with Leaf => True | Node x e o => x <> 0 /\ apart e /\ apart o end.
Fixpoint every (f : positive * term -> Prop) (l : list (positive * term)) : Prop :=
  match l with [] => True | e :: l' => f e /\ every f l' end.

Lemma apart_right i t : apart t -> at_place i t <> 0.
Proof. revert i. induction t as [ | x e E o O]; simpl; [intros; exact R1_neq_R0 | ]. intros [i | i | ] (N & A & B); auto. Qed.

Lemma every_right f l : every f l -> Forall f l.
Proof. induction l; simpl; constructor; [apply H | apply IHl, H]. Qed.

Lemma alike {T} (f g : T -> R) all values : values = map f all -> values = map g all -> Forall (fun e => f e = g e) all.
Proof.
  revert values. induction all as [ | e all IH]; intros values F G; constructor; subst values; injection G as E G; auto.
  eapply IH; [reflexivity | exact G].
Qed.

Theorem decide_right other some s l r x y names numbers :
  apart some ->
  every (fun e => value other some (fst e) ^ 2 = meaning other some (snd e)) (squares s) ->
  numbers = map (fun e => value other some (xO (fst e))) (below s) ->
  numbers = map (fun e => meaning other some (snd e)) (below s) ->
  names = map (fun e => value other some (fst e)) (parts s) ->
  names = map (fun e => meaning other some (snd e)) (parts s) ->
  x = meaning other some l -> y = meaning other some r -> decided s l r = true -> x = y.
Proof.
  intros A S D D' P P' -> ->. apply decided_right.
  - intros i. apply apart_right, A.
  - apply every_right in S. revert S. apply Forall_impl. intros [i e]. exact (fun H => H).
  - assert (B := alike _ _ _ _ D D'). revert B. apply Forall_impl. intros [i e]. exact (fun H => H).
  - exact (alike _ _ _ _ P P').
Qed.

Fixpoint positive_tree (t : tree) : Prop :=
  match t with Leaf => True | Node x e o => 0 < x /\ positive_tree e /\ positive_tree o end.
Lemma positive_right i t : positive_tree t -> 0 < at_place i t.
Proof. revert i. induction t as [ | x e E o O]; simpl; [intros; exact Rlt_0_1 | ]. intros [i | i | ] (N & A & B); auto. Qed.

Theorem rise_right other some s l x names numbers :
  positive_tree some ->
  numbers = map (fun e => value other some (xO (fst e))) (below s) ->
  numbers = map (fun e => meaning other some (snd e)) (below s) ->
  names = map (fun e => value other some (fst e)) (parts s) ->
  names = map (fun e => meaning other some (snd e)) (parts s) ->
  x = meaning other some l -> rises s l = true -> x > 0.
Proof.
  intros A D D' P P' ->. apply rises_right.
  - intros i. apply Rgt_not_eq, positive_right, A.
  - intros i. apply positive_right, A.
  - assert (B := alike _ _ _ _ D D'). revert B. apply Forall_impl. intros [i e]. exact (fun H => H).
  - exact (alike _ _ _ _ P P').
Qed.

Lemma positive_node x e o : 0 < x -> positive_tree e -> positive_tree o -> positive_tree (Node x e o).
Proof. exact (fun n a b => conj n (conj a b)). Qed.
Lemma apart_node x e o : x <> 0 -> apart e -> apart o -> apart (Node x e o).
Proof. exact (fun n a b => conj n (conj a b)). Qed.
Lemma every_cons (f : positive * term -> Prop) e l : f e -> every f l -> every f (e :: l).
Proof. exact (fun h t => conj h t). Qed.

(* What stands for a variable is put in before a named part is. *)
Strategy expand [meaning value at_place fst snd].

From Ltac2 Require Import Ltac2.
From Ltac2 Require Array Constr Control Ident List Ltac1 Std.
Set Default Proof Mode "Classic".

Ltac2 app f xs := Constr.Unsafe.make (Constr.Unsafe.App f (Array.of_list xs)).

(* The list of these, and the conjunction of proofs. *)
Ltac2 rec listed (kind : constr) xs :=
  match xs with
  | [] => app '@nil [kind]
  | x :: xs => app '@cons [kind; x; listed kind xs]
  end.

(* A tree of these, the first at its root, and of proofs about them. *)
Ltac2 rec every_other xs :=
  match xs with [] => ([], []) | x :: xs => match every_other xs with (a, b) => (x :: b, a) end end.
Ltac2 rec tree leaf node xs :=
  match xs with
  | [] => leaf
  | x :: xs => match every_other xs with (a, b) => node x (tree leaf node a) (tree leaf node b) end
  end.

(* What stands in for what: names with their numbers. *)
Ltac2 rec number_of (numbers : (ident * constr) list) (x : ident) :=
  match numbers with
  | [] => Control.zero (Tactic_failure None)
  | n :: rest => match n with (y, i) => if Ident.equal x y then i else number_of rest x end
  end.

Ltac2 reader (numbers : (ident * constr) list) :=
  let plus := 'Rplus in let minus := 'Rminus in let mult := 'Rmult in let div := 'Rdiv in let opp := 'Ropp in
  let pow := 'Rpow_def.pow in let number := 'IZR in
  let var := 'Var in let num := 'Num in let neg := 'Neg in let power := 'Pow in
  let add := 'Add in let sub := 'Sub in let mul := 'Mul in let quot := 'Div in
  let rec go x :=
    match Constr.Unsafe.kind x with
    | Constr.Unsafe.Var v => app var [number_of numbers v]
    | Constr.Unsafe.Cast x _ _ => go x
    | Constr.Unsafe.App f xs =>
        if Constr.equal f number then app num [Array.get xs 0]
        else if Constr.equal f opp then app neg [go (Array.get xs 0)]
        else if Constr.equal f pow then app power [go (Array.get xs 0); Array.get xs 1]
        else
          let both := [go (Array.get xs 0); go (Array.get xs 1)] in
          if Constr.equal f mult then app mul both
          else if Constr.equal f plus then app add both
          else if Constr.equal f minus then app sub both
          else if Constr.equal f div then app quot both
          else Control.zero (Tactic_failure None)
    | _ => Control.zero (Tactic_failure None)
    end in
  go.

Ltac2 Type hypothesis := [
| Free (ident)
| Part (ident, constr)
| Nonzero (constr, constr)
| Tie (ident, constr, constr)
| Nothing ].

(* For a claim that something is above zero, hypotheses that say so count; else those that it is not zero. *)
Ltac2 classified positive h :=
  match h with
  | (name, body, kind) =>
      match body with
      | Some body => if Constr.equal kind 'R then Part name body else Nothing
      | None =>
          let proof := Constr.Unsafe.make (Constr.Unsafe.Var name) in
          if Constr.equal kind 'R then Free name
          else lazy_match! kind with
          | ?x <> 0 => if positive then Nothing else Nonzero x proof
          | 0 < ?x => if positive then Nonzero x proof else
              match Constr.Unsafe.kind x with
              | Constr.Unsafe.Var _ => Nonzero x (app '(fun x => Rgt_not_eq x 0) [x; proof])
              | _ => Nothing end
          | ?x ^ 2 = ?q => match Constr.Unsafe.kind x with
              | Constr.Unsafe.Var v => Tie v q proof
              | _ => Nothing end
          | _ => Nothing
          end
      end
  end.

Ltac2 next i := Std.eval_vm None (app 'Pos.succ [i]).

Ltac2 decide () :=
  let (positive, l, r) := lazy_match! goal with
  | [ |- @eq R ?l ?r ] => (false, l, r)
  | [ |- ?l > ?r ] => (true, l, r)
  end in
      let all := List.map (classified positive) (Control.hyps ()) in
      let real := 'R in
      (* The numbers: those that are not zero first. *)
      let rec nonzeros i all :=
        match all with
        | [] => []
        | h :: all => match h with
            | Nonzero x proof => (i, x, proof) :: nonzeros (next i) all
            | _ => nonzeros i all end
        end in
      let above := nonzeros 'xH all in
      let named := List.fold_right (fun e rest => match e with (i, x, _) =>
        match Constr.Unsafe.kind x with
        | Constr.Unsafe.Var v => (v, app 'xO [i]) :: rest
        | _ => rest end end) [] above in
      let known v := List.exist (fun n => match n with (w, _) => Ident.equal v w end) named in
      let rec others i all :=
        match all with
        | [] => []
        | h :: all =>
            let take v := if known v then others i all else (i, v) :: others (next i) all in
            match h with Free v => take v | Part v _ => take v | _ => others i all end
        end in
      let others := others 'xH all in
      let numbers := List.append named (List.map (fun e => match e with (i, v) => (v, app 'xI [i]) end) others) in
      let read := reader numbers in
      let entry := '(positive * term)%type in
      let value e := match e with (_, x, _) => x end in
      let values := tree 'Leaf (fun x a b => app 'Node [x; a; b]) in
      let some := values (List.map value above) in
      let other := values
        (List.map (fun e => match e with (_, v) => Constr.Unsafe.make (Constr.Unsafe.Var v) end) others) in
      let pair e := match e with (i, x, _) => app '@pair ['positive; 'term; i; x] end in
      (* Each entry with its proof, and the proof of all. *)
      let entries es := listed entry (List.map pair es) in
      let rec proofs f es :=
        match es with
        | [] => 'I
        | e :: rest => match e with (_, _, proof) =>
            app 'every_cons [f; pair e; entries rest; proof; proofs f rest] end
        end in
      let node := if positive then 'positive_node else 'apart_node in
      let nonzero es := match tree ('Leaf, 'I) (fun e a b => match e with (_, x, proof) =>
          match a with (a, p) => match b with (b, q) =>
            (app 'Node [x; a; b], app node [x; a; b; proof; p; q]) end end end) es with (_, p) => p end in
      let body v := List.find_opt (fun h => match h with Part w _ => Ident.equal v w | _ => false end) all in
      let reflexivity x := app '@eq_refl [real; x] in
      let rec below es :=
        match es with
        | [] => []
        | e :: rest => match e with (i, x, _) =>
            let taken := (i, read x, x) :: below rest in
            match Constr.Unsafe.kind x with
            | Constr.Unsafe.Var v => match body v with Some _ => taken | None => below rest end
            | _ => taken
            end end
        end in
      let below := below above in
      let rec ties hs :=
        match hs with
        | [] => []
        | h :: rest => match h with
            | Tie v q proof => (number_of numbers v, read q, proof) :: ties rest
            | _ => ties rest end
        end in
      let ties := ties all in
      let rec parts hs :=
        match hs with
        | [] => []
        | h :: rest => match h with
            | Part v x => (number_of numbers v, read x, Constr.Unsafe.make (Constr.Unsafe.Var v)) :: parts rest
            | _ => parts rest end
        end in
      let parts := parts all in
      let s := app 'Build_statement [entries ties; entries below; entries parts] in
      let both := [other; some] in
      let tie := app '(fun other some (e : positive * term) => value other some (fst e) ^ 2 = meaning other some (snd e)) both in
      let x := l in let y := r in let l := read l in let r := read r in
      let machine := match Constr.Unsafe.kind '(I <: True) with
        | Constr.Unsafe.Cast _ c _ => c | _ => Control.zero (Tactic_failure None) end in
      let claim := app '@eq ['bool; if positive then app 'rises [s; l] else app 'decided [s; l; r]; 'true] in
      let computed := Constr.Unsafe.make (Constr.Unsafe.Cast '(@eq_refl bool true) machine claim) in
      let values es := listed real (List.map (fun e => match e with (_, _, x) => x end) es) in
      let numbers := values below in let names := values parts in
      let alike xs := app '@eq_refl ['(list R); xs] in
      let named := [alike numbers; alike numbers; alike names; alike names] in
      let t :=
        if positive then
          app 'rise_right (List.append [other; some; s; l; x; names; numbers; nonzero above]
            (List.append named [reflexivity x; computed]))
        else
          app 'decide_right (List.append [other; some; s; l; r; x; y; names; numbers; nonzero above; proofs tie ties]
            (List.append named [reflexivity x; reflexivity y; computed])) in
      ltac1:(t |- exact_no_check t) (Ltac1.of_constr t).

Ltac rational := ltac2:(decide ()).

(* What is false is refused, and so is what holds only where a divisor is not zero, unless that is given. *)
Goal forall x y w : R, w ^ 2 = 1 / 2 -> x - y <> 0 -> (x ^ 2 - y ^ 2) / (x - y) = 2 * w ^ 2 * (x + y).
Proof. intros x y w W D. rational. Qed.
Goal forall x y w : R, w ^ 2 = 1 / 2 -> x - y <> 0 -> (x ^ 2 - y ^ 2) / (x - y) = 2 * w * (x + y).
Proof. intros x y w W D. rational. Fail Qed. Abort.
Goal forall x : R, x / x = 1.
Proof. intros x. rational. Fail Qed. Abort.
Goal forall x y : R, 0 < x -> 0 < y -> 0 < x + y -> 1 - x / (x + y) > 0.
Proof. intros x y X Y S. rational. Qed.
Goal forall x y : R, 0 < x -> 0 < y -> 0 < x + y -> 1 - 2 * x / (x + y) > 0.
Proof. intros x y X Y S. rational. Fail Qed. Abort.
Goal forall x y : R, 0 < x -> x + y > 0.
Proof. intros x y X. rational. Fail Qed. Abort.
