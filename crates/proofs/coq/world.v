(* The attitude in continuous time: what it keeps, and that the momentum stays in the world. *)
Require Import Tumbling.motion.
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* A quaternion q = q0 + q1 i + q2 j + q3 k that turns with the spin: q' = q w / 2. *)
Definition turns (q0 q1 q2 q3 w1 w2 w3 : R -> R) : Prop :=
  forall t,
  is_derive q0 t (- (q1 t * w1 t + q2 t * w2 t + q3 t * w3 t) / 2) /\
  is_derive q1 t ((q0 t * w1 t + q2 t * w3 t - q3 t * w2 t) / 2) /\
  is_derive q2 t ((q0 t * w2 t + q3 t * w1 t - q1 t * w3 t) / 2) /\
  is_derive q3 t ((q0 t * w3 t + q1 t * w2 t - q2 t * w1 t) / 2).

(* The components in the world, q v conj(q), of a vector of the body. *)
Definition to_world (q0 q1 q2 q3 x y z : R) : R * R * R :=
  ((q0 ^ 2 + q1 ^ 2 - q2 ^ 2 - q3 ^ 2) * x + 2 * (q1 * q2 - q0 * q3) * y + 2 * (q1 * q3 + q0 * q2) * z,
   2 * (q1 * q2 + q0 * q3) * x + (q0 ^ 2 - q1 ^ 2 + q2 ^ 2 - q3 ^ 2) * y + 2 * (q2 * q3 - q0 * q1) * z,
   2 * (q1 * q3 - q0 * q2) * x + 2 * (q2 * q3 + q0 * q1) * y + (q0 ^ 2 - q1 ^ 2 - q2 ^ 2 + q3 ^ 2) * z).

(* Finds the rate of change of a polynomial in functions whose rates are known. *)
Ltac known_rates :=
  auto_derive; [repeat split; eexists; eassumption | ];
  repeat match goal with
  | D : is_derive ?f ?t ?d |- context [Derive ?g ?t] => unify f g; change g with f; rewrite (is_derive_unique f t d D)
  end.

Theorem attitude_keeps_its_length (q0 q1 q2 q3 w1 w2 w3 : R -> R) :
  turns q0 q1 q2 q3 w1 w2 w3 -> forall s t,
  q0 s ^ 2 + q1 s ^ 2 + q2 s ^ 2 + q3 s ^ 2 = q0 t ^ 2 + q1 t ^ 2 + q2 t ^ 2 + q3 t ^ 2.
Proof.
  intros Q. apply (motion.constant (fun t => q0 t ^ 2 + q1 t ^ 2 + q2 t ^ 2 + q3 t ^ 2)).
  intros t. destruct (Q t) as (D0 & D1 & D2 & D3). known_rates. field.
Qed.

Theorem momentum_stays_in_the_world (I1 I2 I3 : R) (q0 q1 q2 q3 w1 w2 w3 : R -> R) :
  I1 <> 0 -> I2 <> 0 -> I3 <> 0 -> motion I1 I2 I3 w1 w2 w3 -> turns q0 q1 q2 q3 w1 w2 w3 -> forall s t,
  to_world (q0 s) (q1 s) (q2 s) (q3 s) (I1 * w1 s) (I2 * w2 s) (I3 * w3 s)
  = to_world (q0 t) (q1 t) (q2 t) (q3 t) (I1 * w1 t) (I2 * w2 t) (I3 * w3 t).
Proof.
  intros N1 N2 N3 M Q s t. unfold to_world. f_equal; [f_equal | ].
  all: match goal with |- ?l = _ =>
      let f := (eval pattern s in l) in match f with ?g _ => apply (motion.constant g) end
    end.
  all: clear s t; intros t; cbv beta; destruct (Q t) as (D0 & D1 & D2 & D3); destruct (M t) as (E1 & E2 & E3);
    known_rates; field; auto.
Qed.

(* A turn by the half-angle tangents c takes the momentum y along the axes after it to x along those before it if
   y + c x y = x - c x x; then the quaternion q (1 + c), made one long, takes y to where q takes x. *)
Theorem turn_carries_the_momentum (q0 q1 q2 q3 c1 c2 c3 n x1 x2 x3 y1 y2 y3 : R) :
  n ^ 2 = 1 + c1 ^ 2 + c2 ^ 2 + c3 ^ 2 ->
  y1 + (c2 * y3 - c3 * y2) = x1 - (c2 * x3 - c3 * x2) ->
  y2 + (c3 * y1 - c1 * y3) = x2 - (c3 * x1 - c1 * x3) ->
  y3 + (c1 * y2 - c2 * y1) = x3 - (c1 * x2 - c2 * x1) ->
  to_world ((q0 - q1 * c1 - q2 * c2 - q3 * c3) / n) ((q1 + q0 * c1 + q2 * c3 - q3 * c2) / n)
    ((q2 + q0 * c2 + q3 * c1 - q1 * c3) / n) ((q3 + q0 * c3 + q1 * c2 - q2 * c1) / n) y1 y2 y3
  = to_world q0 q1 q2 q3 x1 x2 x3.
Proof.
  intros N E1 E2 E3.
  assert (P : 0 < n ^ 2) by (assert (A := pow2_ge_0 c1); assert (B := pow2_ge_0 c2); assert (C := pow2_ge_0 c3); lra).
  assert (Z : n <> 0) by (intros ->; lra).
  (* The turn alone. *)
  assert (T : forall x y, n ^ 2 * x - y = 0 -> y = n ^ 2 * x) by (intros; lra).
  assert (F1 : (1 + c1 ^ 2 - c2 ^ 2 - c3 ^ 2) * y1 + 2 * (c1 * c2 - c3) * y2 + 2 * (c1 * c3 + c2) * y3 = n ^ 2 * x1).
  { apply T. rewrite N.
    transitivity ((1 + c1 ^ 2) * (x1 - (c2 * x3 - c3 * x2) - (y1 + (c2 * y3 - c3 * y2)))
      + (c1 * c2 - c3) * (x2 - (c3 * x1 - c1 * x3) - (y2 + (c3 * y1 - c1 * y3)))
      + (c1 * c3 + c2) * (x3 - (c1 * x2 - c2 * x1) - (y3 + (c1 * y2 - c2 * y1)))); [ring | rewrite E1, E2, E3; ring]. }
  assert (F2 : 2 * (c1 * c2 + c3) * y1 + (1 - c1 ^ 2 + c2 ^ 2 - c3 ^ 2) * y2 + 2 * (c2 * c3 - c1) * y3 = n ^ 2 * x2).
  { apply T. rewrite N.
    transitivity ((c1 * c2 + c3) * (x1 - (c2 * x3 - c3 * x2) - (y1 + (c2 * y3 - c3 * y2)))
      + (1 + c2 ^ 2) * (x2 - (c3 * x1 - c1 * x3) - (y2 + (c3 * y1 - c1 * y3)))
      + (c2 * c3 - c1) * (x3 - (c1 * x2 - c2 * x1) - (y3 + (c1 * y2 - c2 * y1)))); [ring | rewrite E1, E2, E3; ring]. }
  assert (F3 : 2 * (c1 * c3 - c2) * y1 + 2 * (c2 * c3 + c1) * y2 + (1 - c1 ^ 2 - c2 ^ 2 + c3 ^ 2) * y3 = n ^ 2 * x3).
  { apply T. rewrite N.
    transitivity ((c1 * c3 - c2) * (x1 - (c2 * x3 - c3 * x2) - (y1 + (c2 * y3 - c3 * y2)))
      + (c2 * c3 + c1) * (x2 - (c3 * x1 - c1 * x3) - (y2 + (c3 * y1 - c1 * y3)))
      + (1 + c3 ^ 2) * (x3 - (c1 * x2 - c2 * x1) - (y3 + (c1 * y2 - c2 * y1)))); [ring | rewrite E1, E2, E3; ring]. }
  clear T N E1 E2 E3 P.
  assert (W : forall x, n ^ 2 * x / n ^ 2 = x) by (intros; field; exact Z).
  unfold to_world. f_equal; [f_equal | ].
  all: rewrite <- (W x1), <- (W x2), <- (W x3), <- F1, <- F2, <- F3; field; exact Z.
Qed.

(* A steady spin about the third axis, with its attitude: such motions there are. *)
Theorem steady_spin (I1 I2 I3 w : R) :
  I3 <> 0 ->
  motion I1 I2 I3 (fun _ => 0) (fun _ => 0) (fun _ => w) /\
  turns (fun t => cos (w * t / 2)) (fun _ => 0) (fun _ => 0) (fun t => sin (w * t / 2))
    (fun _ => 0) (fun _ => 0) (fun _ => w).
Proof.
  intros N3. split; intros t.
  - split; [ | split]; (auto_derive; [exact I | unfold Rdiv; ring]).
  - split; [ | split; [ | split]]; (auto_derive; [exact I | unfold Rdiv; ring]).
Qed.
