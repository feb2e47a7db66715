(* What Coq checks of the book's physics, on one page: definitions, then theorems. Each proof is a name in another
   file; nothing of that file needs to be read, since what is stated here is all that counts. Numbers are Coq's
   real numbers, derivatives and integrals are Coquelicot's. *)
From Coq Require Import Reals List.
From Coquelicot Require Import Coquelicot.
Require Tumbling.bodies Tumbling.box Tumbling.motion Tumbling.closed Tumbling.world Tumbling.angle Tumbling.steps
  Tumbling.stage.
Open Scope R_scope.

(* ---- Definitions. Axes are the principal axes of the body unless the world's are named. *)

(* Three numbers that are moments of inertia of a body in three dimensions. *)
Definition body (I1 I2 I3 : R) : Prop :=
  0 < I1 /\ 0 < I2 /\ 0 < I3 /\ I1 <= I2 + I3 /\ I2 <= I3 + I1 /\ I3 <= I1 + I2.

(* A motion that nothing disturbs: at each time the spin w obeys Euler's equations. *)
Definition motion (I1 I2 I3 : R) (w1 w2 w3 : R -> R) : Prop :=
  forall t,
  is_derive w1 t ((I2 - I3) * (w2 t * w3 t) / I1) /\
  is_derive w2 t ((I3 - I1) * (w3 t * w1 t) / I2) /\
  is_derive w3 t ((I1 - I2) * (w1 t * w2 t) / I3).

Definition energy (I1 I2 I3 w1 w2 w3 : R) : R := (I1 * w1 ^ 2 + I2 * w2 ^ 2 + I3 * w3 ^ 2) / 2.

(* The square of the length of the momentum. *)
Definition momentum2 (I1 I2 I3 w1 w2 w3 : R) : R := (I1 * w1) ^ 2 + (I2 * w2) ^ 2 + (I3 * w3) ^ 2.

(* An attitude that turns with the spin: the quaternion q0 + q1 i + q2 j + q3 k with q' = q w / 2. *)
Definition turns (q0 q1 q2 q3 w1 w2 w3 : R -> R) : Prop :=
  forall t,
  is_derive q0 t (- (q1 t * w1 t + q2 t * w2 t + q3 t * w3 t) / 2) /\
  is_derive q1 t ((q0 t * w1 t + q2 t * w3 t - q3 t * w2 t) / 2) /\
  is_derive q2 t ((q0 t * w2 t + q3 t * w1 t - q1 t * w3 t) / 2) /\
  is_derive q3 t ((q0 t * w3 t + q1 t * w2 t - q2 t * w1 t) / 2).

(* The components in the world, q v conj(q), of a vector v = (x, y, z) of the body. *)
Definition to_world (q0 q1 q2 q3 x y z : R) : R * R * R :=
  ((q0 ^ 2 + q1 ^ 2 - q2 ^ 2 - q3 ^ 2) * x + 2 * (q1 * q2 - q0 * q3) * y + 2 * (q1 * q3 + q0 * q2) * z,
   2 * (q1 * q2 + q0 * q3) * x + (q0 ^ 2 - q1 ^ 2 + q2 ^ 2 - q3 ^ 2) * y + 2 * (q2 * q3 - q0 * q1) * z,
   2 * (q1 * q3 - q0 * q2) * x + 2 * (q2 * q3 + q0 * q1) * y + (q0 ^ 2 - q1 ^ 2 - q2 ^ 2 + q3 ^ 2) * z).

(* Jacobi's functions of the parameter m. *)
Definition jacobi (m : R) (sn cn dn : R -> R) : Prop :=
  (forall u, is_derive sn u (cn u * dn u)) /\
  (forall u, is_derive cn u (- (sn u * dn u))) /\
  (forall u, is_derive dn u (- (m * (sn u * cn u)))) /\
  sn 0 = 0 /\ cn 0 = 1 /\ dn 0 = 1.

(* A step of length h of an engine's position stage, from the spin w to the spin v, with the turn by the half-angle
   tangents c. The pace X and the weight b may be any numbers. *)
Definition coupling (I J K : R) : R := (J - K) / I.
Definition passed (X Q1 Q2 Q3 k1 h w1 w2 w3 : R) : R := w1 * (X + Q2 * Q3) + k1 * (h * w2) * w3 * Q1.
Definition divisor (X Q1 Q2 Q3 k1 k2 k3 h w1 w2 w3 : R) : R :=
  X * (X * (Q1 + Q2 + Q3) + (Q1 * (Q2 * Q3) + k1 * (h * w2) * (k2 * (h * w3)) * (k3 * (h * w1)))).
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

(* ---- Theorems. *)

(* 1. No moment of inertia of any points exceeds the sum of the other two. *)
Theorem triangle_inequality (points : list bodies.point) :
  List.Forall (fun p => 0 <= bodies.m p) points ->
  let sum f := fold_right (fun p s => f p + s) 0 points in
  sum (fun p => bodies.m p * (bodies.y p ^ 2 + bodies.z p ^ 2))
  <= sum (fun p => bodies.m p * (bodies.z p ^ 2 + bodies.x p ^ 2))
    + sum (fun p => bodies.m p * (bodies.x p ^ 2 + bodies.y p ^ 2)).
Proof. exact (bodies.triangle_inequality points). Qed.

(* 2. The moment of a box of density r with edges 2 a, 2 b, 2 c about its first axis, as an integral: a twelfth of
   its mass times the sum of the squares of the other edges. *)
Theorem moment_of_a_box (r a b c : R) :
  RInt (fun x => RInt (fun y => RInt (fun z => r * (y ^ 2 + z ^ 2)) (- c) c) (- b) b) (- a) a
  = r * (2 * a) * (2 * b) * (2 * c) * ((2 * b) ^ 2 + (2 * c) ^ 2) / 12.
Proof. exact (box.moment_of_a_box r a b c). Qed.

(* 3. Energy and length of the momentum stay. *)
Theorem energy_and_momentum_stay (I1 I2 I3 : R) (w1 w2 w3 : R -> R) :
  body I1 I2 I3 -> motion I1 I2 I3 w1 w2 w3 -> forall s t,
  energy I1 I2 I3 (w1 s) (w2 s) (w3 s) = energy I1 I2 I3 (w1 t) (w2 t) (w3 t) /\
  momentum2 I1 I2 I3 (w1 s) (w2 s) (w3 s) = momentum2 I1 I2 I3 (w1 t) (w2 t) (w3 t).
Proof.
  intros (P1 & P2 & P3 & _) M s t. apply Rgt_not_eq in P1, P2, P3.
  split; [apply (f_equal (fun x => x / 2)), motion.energy_is_constant | apply motion.momentum_has_constant_length]; assumption.
Qed.

(* 4. The attitude keeps its length, and the momentum stays in the world. *)
Theorem momentum_stays_in_the_world (I1 I2 I3 : R) (q0 q1 q2 q3 w1 w2 w3 : R -> R) :
  body I1 I2 I3 -> motion I1 I2 I3 w1 w2 w3 -> turns q0 q1 q2 q3 w1 w2 w3 -> forall s t,
  q0 s ^ 2 + q1 s ^ 2 + q2 s ^ 2 + q3 s ^ 2 = q0 t ^ 2 + q1 t ^ 2 + q2 t ^ 2 + q3 t ^ 2 /\
  to_world (q0 s) (q1 s) (q2 s) (q3 s) (I1 * w1 s) (I2 * w2 s) (I3 * w3 s)
  = to_world (q0 t) (q1 t) (q2 t) (q3 t) (I1 * w1 t) (I2 * w2 t) (I3 * w3 t).
Proof.
  intros (P1 & P2 & P3 & _) M Q s t. apply Rgt_not_eq in P1, P2, P3.
  split; [exact (world.attitude_keeps_its_length _ _ _ _ _ _ _ Q s t) | apply world.momentum_stays_in_the_world; assumption].
Qed.

(* 5, 6. The axes of the largest and of the smallest moment are stable for all times: the spin across stays as small
   as wanted if it starts small enough. *)
Theorem largest_axis_is_stable (I1 I2 I3 e : R) :
  0 < I1 -> 0 < I2 -> I1 < I3 -> I2 < I3 -> 0 < e ->
  exists d, 0 < d /\ forall w1 w2 w3, motion I1 I2 I3 w1 w2 w3 -> forall s,
  Rabs (w1 s) < d -> Rabs (w2 s) < d -> forall t, Rabs (w1 t) < e /\ Rabs (w2 t) < e.
Proof. exact (motion.largest_axis_is_stable I1 I2 I3 e). Qed.

Theorem smallest_axis_is_stable (I1 I2 I3 e : R) :
  0 < I1 -> I1 < I2 -> I1 < I3 -> 0 < e ->
  exists d, 0 < d /\ forall w1 w2 w3, motion I1 I2 I3 w1 w2 w3 -> forall s,
  Rabs (w2 s) < d -> Rabs (w3 s) < d -> forall t, Rabs (w2 t) < e /\ Rabs (w3 t) < e.
Proof. exact (motion.smallest_axis_is_stable I1 I2 I3 e). Qed.

(* 7. The middle axis is unstable: as near to a steady spin W about it as wanted starts a motion that turns over. *)
Theorem middle_axis_is_unstable (I1 I2 I3 W d : R) :
  0 < I1 -> I1 < I2 -> I2 < I3 -> 0 < W -> 0 < d ->
  exists w1 w2 w3, motion I1 I2 I3 w1 w2 w3 /\
  Rabs (w1 0) < d /\ Rabs (w2 0 - W) < d /\ Rabs (w3 0) < d /\
  exists t, 0 < t /\ 0 < w2 0 /\ w2 t = - w2 0.
Proof. exact (motion.middle_axis_is_unstable I1 I2 I3 W d). Qed.

(* 8. The closed form solves Euler's equations, about the axis of the largest or of the smallest moment, whichever
   the third is. The largest spins a and c about the first and third axes are of either sign; e is the phase. *)
Theorem closed_form_solves_Eulers_equations (I1 I2 I3 a c e : R) :
  0 < I1 -> 0 < I2 -> 0 < I3 -> 0 < (I3 - I2) * (I2 - I1) -> c <> 0 ->
  let n := sqrt (c ^ 2 * ((I3 - I2) * (I3 - I1) / (I1 * I2))) in
  let b := I1 * a * n / ((I3 - I2) * c) in
  let m := I1 * (I2 - I1) * a ^ 2 / (I3 * (I3 - I2) * c ^ 2) in
  0 < n /\ 0 <= m /\
  forall sn cn dn, jacobi m sn cn dn ->
  motion I1 I2 I3 (fun t => a * cn (n * t + e)) (fun t => b * sn (n * t + e)) (fun t => c * dn (n * t + e)).
Proof. exact (closed.closed_form I1 I2 I3 a c e). Qed.

(* 9. An engine's position stage keeps energy and momentum for any step, pace and weight: the quaternion q (1 + c),
   made one long by n, takes the momentum after it to where q takes that before it. *)
Theorem position_stage_keeps_energy_and_momentum (I1 I2 I3 X h b w1 w2 w3 v1 v2 v3 c1 c2 c3 : R) :
  body I1 I2 I3 -> stage I1 I2 I3 X h b w1 w2 w3 v1 v2 v3 c1 c2 c3 ->
  energy I1 I2 I3 v1 v2 v3 = energy I1 I2 I3 w1 w2 w3 /\
  forall q0 q1 q2 q3 n, n ^ 2 = 1 + c1 ^ 2 + c2 ^ 2 + c3 ^ 2 ->
  to_world ((q0 - q1 * c1 - q2 * c2 - q3 * c3) / n) ((q1 + q0 * c1 + q2 * c3 - q3 * c2) / n)
    ((q2 + q0 * c2 + q3 * c1 - q1 * c3) / n) ((q3 + q0 * c3 + q1 * c2 - q2 * c1) / n) (I1 * v1) (I2 * v2) (I3 * v3)
  = to_world q0 q1 q2 q3 (I1 * w1) (I2 * w2) (I3 * w3).
Proof.
  intros (P1 & P2 & P3 & _) S. apply Rgt_not_eq in P1, P2, P3.
  destruct (stage.stage_keeps _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P1 P2 P3 S) as (E & M1 & M2 & M3).
  split; [exact (f_equal (fun x => x / 2) E) | ].
  intros q0 q1 q2 q3 n N. exact (world.turn_carries_the_momentum _ _ _ _ _ _ _ _ _ _ _ _ _ _ N M1 M2 M3).
Qed.

(* 10. A splitting method, turns about the axes in any number and order, keeps the length of the momentum. *)
Theorem splitting_keeps_momentum (turns : list steps.turn) (L : R * R * R) :
  List.Forall steps.proper turns -> steps.square (fold_right steps.turned L turns) = steps.square L.
Proof. exact (steps.splitting_keeps_momentum turns L). Qed.

(* 11. The attitude of a free motion, with the momentum of length L along the third axis of the world: the turn that
   takes the momentum to this axis by the shortest way, followed by a turn by psi about it, if psi has the rate below
   and the momentum is never opposite to the third axis of the body. *)
Theorem attitude_by_the_angle (I1 I2 I3 L : R) (w1 w2 w3 psi : R -> R) :
  body I1 I2 I3 -> motion I1 I2 I3 w1 w2 w3 -> 0 < L ->
  momentum2 I1 I2 I3 (w1 0) (w2 0) (w3 0) = L ^ 2 -> (forall t, 0 < L + I3 * w3 t) ->
  (forall t, is_derive psi t ((2 * energy I1 I2 I3 (w1 t) (w2 t) (w3 t) + L * w3 t) / (L + I3 * w3 t))) ->
  let r t := sqrt ((L + I3 * w3 t) / (2 * L)) in
  let b1 t := I2 * w2 t / (2 * L * r t) in let b2 t := - (I1 * w1 t / (2 * L * r t)) in
  let c t := cos (psi t / 2) in let s t := sin (psi t / 2) in
  turns (fun t => c t * r t) (fun t => c t * b1 t - s t * b2 t) (fun t => c t * b2 t + s t * b1 t)
    (fun t => s t * r t) w1 w2 w3.
Proof.
  intros B M P L0 O T. assert (K := fun t => proj2 (energy_and_momentum_stay _ _ _ _ _ _ B M t 0)).
  unfold momentum2 in K, L0. destruct B as (P1 & P2 & P3 & _). apply Rgt_not_eq in P1, P2, P3.
  assert (Q : forall t, (I1 * w1 t) ^ 2 + (I2 * w2 t) ^ 2 + (I3 * w3 t) ^ 2 = L ^ 2)
    by (intros t; rewrite (K t); exact L0).
  unfold energy in T.
  assert (T' : forall t, is_derive psi t ((I1 * w1 t ^ 2 + I2 * w2 t ^ 2 + I3 * w3 t ^ 2 + L * w3 t) / (L + I3 * w3 t)))
    by (intros t; replace (_ / (L + I3 * w3 t)) with
      ((2 * ((I1 * w1 t ^ 2 + I2 * w2 t ^ 2 + I3 * w3 t ^ 2) / 2) + L * w3 t) / (L + I3 * w3 t));
      [exact (T t) | field; apply Rgt_not_eq, O]).
  intros r b1 b2 c s t. split; [ | split; [ | split]].
  - apply angle.first_part; auto.
  - apply angle.second_part; auto.
  - apply angle.third_part; auto.
  - apply angle.fourth_part; auto.
Qed.

(* ---- That the hypotheses above can be met. *)

Theorem a_body : body 4 5 7.
Proof. unfold body. repeat split; Lra.lra. Qed.

Theorem a_motion_with_its_attitude (I1 I2 I3 w : R) :
  body I1 I2 I3 ->
  motion I1 I2 I3 (fun _ => 0) (fun _ => 0) (fun _ => w) /\
  turns (fun t => cos (w * t / 2)) (fun _ => 0) (fun _ => 0) (fun t => sin (w * t / 2))
    (fun _ => 0) (fun _ => 0) (fun _ => w).
Proof. intros (_ & _ & P & _). exact (world.steady_spin I1 I2 I3 w (Rgt_not_eq _ _ P)). Qed.

(* Jacobi's functions for the parameters zero and one: a steady wobble, and the separatrix. That they exist for those
   between is not proven here. *)
Theorem jacobi_of_zero : jacobi 0 sin cos (fun _ => 1).
Proof. exact closed.jacobi_of_zero. Qed.

Theorem jacobi_of_one : jacobi 1
  (fun u => (exp u - exp (- u)) / (exp u + exp (- u)))
  (fun u => 2 / (exp u + exp (- u))) (fun u => 2 / (exp u + exp (- u))).
Proof. exact closed.jacobi_of_one. Qed.

(* On the separatrix, for all four pairs of signs of the largest spins a and c. *)
Theorem motions_of_all_signs (a c e : R) :
  a ^ 2 = 2 -> c ^ 2 = 1 ->
  exists n b, let u t := n * t + e in let cosh t := (exp (u t) + exp (- u t)) / 2 in
  motion 4 6 8 (fun t => a * (1 / cosh t)) (fun t => b * ((exp (u t) - exp (- u t)) / 2 / cosh t))
    (fun t => c * (1 / cosh t)).
Proof. exact (closed.separatrix_of_all_signs a c e). Qed.

(* A stage with three real roots. *)
Theorem a_stage : exists v1 v2 v3 c1 c2 c3, stage 4 5 7 1 (1 / 2) 0 1 1 1 v1 v2 v3 c1 c2 c3.
Proof. exact stage.a_stage. Qed.

(* An angle with this rate, where the momentum is along the third axis. *)
Theorem an_angle (w : R) : 0 < w -> forall t,
  0 < 7 * w + 7 * w /\ is_derive (fun t => w * t) t ((2 * energy 4 5 7 0 0 w + 7 * w * w) / (7 * w + 7 * w)).
Proof.
  intros P t. split; [Lra.lra | ]. unfold energy. auto_derive; [exact I | field; Lra.lra].
Qed.
