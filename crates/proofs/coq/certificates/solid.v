(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.


(** box: The moments of every box are the integrals of y² + z² and so on over it; its products vanish. *)

(* centre, x *)
Theorem box_1 :
  forall a b c : R,
  a <> 0 ->
  b <> 0 ->
  c <> 0 ->
  0 = 0 / (a * b * c).
Proof.
  intros a b c   D_1 D_2 D_3.
  rational.
Qed.

(* inertia, xx *)
Theorem box_2 :
  forall a b c m : R,
  a <> 0 ->
  b <> 0 ->
  c <> 0 ->
  (b * b + c * c) * (m / 12) = ((1 / 12) * a * b ^ 3 * c + (1 / 12) * a * b * c ^ 3) * (m / (a * b *
    c)).
Proof.
  intros a b c m   D_1 D_2 D_3.
  rational.
Qed.

(* inertia, yy *)
Theorem box_3 :
  forall a b c m : R,
  a <> 0 ->
  b <> 0 ->
  c <> 0 ->
  (c * c + a * a) * (m / 12) = ((1 / 12) * a ^ 3 * b * c + (1 / 12) * a * b * c ^ 3) * (m / (a * b *
    c)).
Proof.
  intros a b c m   D_1 D_2 D_3.
  rational.
Qed.

(* inertia, zz *)
Theorem box_4 :
  forall a b c m : R,
  a <> 0 ->
  b <> 0 ->
  c <> 0 ->
  (a * a + b * b) * (m / 12) = ((1 / 12) * a ^ 3 * b * c + (1 / 12) * a * b ^ 3 * c) * (m / (a * b *
    c)).
Proof.
  intros a b c m   D_1 D_2 D_3.
  rational.
Qed.

(* With edges a and b swapped. *)

(* inertia, xx *)
Theorem box_mutant_1 :
  exists a b c m : R,
  a <> 0 /\
  b <> 0 /\
  c <> 0 /\
  (a * a + c * c) * (m / 12) <> ((1 / 12) * a * b ^ 3 * c + (1 / 12) * a * b * c ^ 3) * (m / (a * b
    * c)).
Proof.
  exists 6, 1, (-3), (625 / 1521).
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With 12 becomes 8. *)

(* inertia, xx *)
Theorem box_mutant_2 :
  exists a b c m : R,
  a <> 0 /\
  b <> 0 /\
  c <> 0 /\
  (b * b + c * c) * (m * (3 / 2) / 12) <> ((1 / 12) * a * b ^ 3 * c + (1 / 12) * a * b * c ^ 3) * (m
    / (a * b * c)).
Proof.
  exists 6, 1, (-3), (625 / 1521).
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With b² + c² becomes b² - c². *)

(* inertia, xx *)
Theorem box_mutant_3 :
  exists a b c m : R,
  a <> 0 /\
  b <> 0 /\
  c <> 0 /\
  (b * b + c * c) * (m / 12) - m * c * c / 6 <> ((1 / 12) * a * b ^ 3 * c + (1 / 12) * a * b * c ^
    3) * (m / (a * b * c)).
Proof.
  exists 6, 1, (-3), (625 / 1521).
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** ellipsoid: The moments of every ellipsoid, by integrating over it; its products vanish. *)

(* centre, x *)
Theorem ellipsoid_1 :
  forall a b c pi : R,
  a <> 0 ->
  b <> 0 ->
  c <> 0 ->
  pi <> 0 ->
  0 = 0 / ((4 / 3) * a * b * c * pi).
Proof.
  intros a b c pi   D_1 D_2 D_3 D_4.
  rational.
Qed.

(* inertia, xx *)
Theorem ellipsoid_2 :
  forall a b c m pi : R,
  a <> 0 ->
  b <> 0 ->
  c <> 0 ->
  pi <> 0 ->
  (b * b + c * c) * (m / 5) = ((4 / 15) * a * b ^ 3 * c * pi + (4 / 15) * a * b * c ^ 3 * pi) * (m /
    ((4 / 3) * a * b * c * pi)).
Proof.
  intros a b c m pi   D_1 D_2 D_3 D_4.
  rational.
Qed.

(* inertia, yy *)
Theorem ellipsoid_3 :
  forall a b c m pi : R,
  a <> 0 ->
  b <> 0 ->
  c <> 0 ->
  pi <> 0 ->
  (c * c + a * a) * (m / 5) = ((4 / 15) * a ^ 3 * b * c * pi + (4 / 15) * a * b * c ^ 3 * pi) * (m /
    ((4 / 3) * a * b * c * pi)).
Proof.
  intros a b c m pi   D_1 D_2 D_3 D_4.
  rational.
Qed.

(* inertia, zz *)
Theorem ellipsoid_4 :
  forall a b c m pi : R,
  a <> 0 ->
  b <> 0 ->
  c <> 0 ->
  pi <> 0 ->
  (a * a + b * b) * (m / 5) = ((4 / 15) * a ^ 3 * b * c * pi + (4 / 15) * a * b ^ 3 * c * pi) * (m /
    ((4 / 3) * a * b * c * pi)).
Proof.
  intros a b c m pi   D_1 D_2 D_3 D_4.
  rational.
Qed.

(* With axes b and c swapped. *)

(* inertia, yy *)
Theorem ellipsoid_mutant_1 :
  exists a b c m pi : R,
  a <> 0 /\
  b <> 0 /\
  c <> 0 /\
  pi <> 0 /\
  (b * b + a * a) * (m / 5) <> ((4 / 15) * a ^ 3 * b * c * pi + (4 / 15) * a * b * c ^ 3 * pi) * (m
    / ((4 / 3) * a * b * c * pi)).
Proof.
  exists 6, 1, (-3), (625 / 1521), 7.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With 5 becomes 4. *)

(* inertia, xx *)
Theorem ellipsoid_mutant_2 :
  exists a b c m pi : R,
  a <> 0 /\
  b <> 0 /\
  c <> 0 /\
  pi <> 0 /\
  (b * b + c * c) * (m * (5 / 4) / 5) <> ((4 / 15) * a * b ^ 3 * c * pi + (4 / 15) * a * b * c ^ 3 *
    pi) * (m / ((4 / 3) * a * b * c * pi)).
Proof.
  exists 6, 1, (-3), (625 / 1521), 7.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** ball: The moment of every ball about any axis through its centre is 2/5 m r². *)

(* centre, x *)
Theorem ball_1 :
  forall pi r : R,
  pi <> 0 ->
  r <> 0 ->
  0 = 0 / ((4 / 3) * pi * r ^ 3).
Proof.
  intros pi r   D_1 D_2.
  rational.
Qed.

(* inertia, xx *)
Theorem ball_2 :
  forall m pi r : R,
  pi <> 0 ->
  r <> 0 ->
  2 * m * (r * r) / 5 = (8 / 15) * pi * r ^ 5 * (m / ((4 / 3) * pi * r ^ 3)).
Proof.
  intros m pi r   D_1 D_2.
  rational.
Qed.

(* With 2/5 becomes 2/3, that of a shell. *)

(* inertia, xx *)
Theorem ball_mutant_1 :
  exists m pi r : R,
  pi <> 0 /\
  r <> 0 /\
  2 * (m * (5 / 3)) * (r * r) / 5 <> (8 / 15) * pi * r ^ 5 * (m / ((4 / 3) * pi * r ^ 3)).
Proof.
  exists (625 / 1521), 1, (-3).
  split; [computed | ]. split; [computed | ]. computed.
Qed.


(** hollow-sphere: The moment of every hollow sphere is that of a ball less that of its hole, for the mass that is left; with equal radii it is 2/3 m r². *)

(* centre, x *)
Theorem hollow_sphere_1 :
  forall i o pi : R,
  (4 / 3) * o ^ 3 * pi - (4 / 3) * i ^ 3 * pi <> 0 ->
  0 = 0 / ((4 / 3) * o ^ 3 * pi - (4 / 3) * i ^ 3 * pi).
Proof.
  intros i o pi   D_1.
  rational.
Qed.

(* inertia, xx *)
Theorem hollow_sphere_2 :
  forall i m o pi : R,
  o * o + i * o + i * i <> 0 ->
  (4 / 3) * o ^ 3 * pi - (4 / 3) * i ^ 3 * pi <> 0 ->
  2 * m * (o * o * (o * o) + o * o * (i * o) + o * o * (i * i) + i * i * (i * o) + i * i * (i * i))
    / (5 * (o * o + i * o + i * i)) = ((8 / 15) * o ^ 5 * pi - (8 / 15) * i ^ 5 * pi) * (m / ((4 /
    3) * o ^ 3 * pi - (4 / 3) * i ^ 3 * pi)).
Proof.
  intros i m o pi   D_1 D_2.
  rational.
Qed.

(* a thin shell *)
Theorem hollow_sphere_3 :
  forall m o : R,
  o * o + o * o + o * o <> 0 ->
  2 * m * (o * o * (o * o) + o * o * (o * o) + o * o * (o * o) + o * o * (o * o) + o * o * (o * o))
    / (5 * (o * o + o * o + o * o)) = (2 / 3) * m * o * o.
Proof.
  intros m o   D_1.
  rational.
Qed.

(* With the hole filled. *)

(* inertia, xx *)
Theorem hollow_sphere_mutant_1 :
  exists i m o pi : R,
  (4 / 3) * o ^ 3 * pi - (4 / 3) * i ^ 3 * pi <> 0 /\
  2 * m * (o * o) / 5 <> ((8 / 15) * o ^ 5 * pi - (8 / 15) * i ^ 5 * pi) * (m / ((4 / 3) * o ^ 3 *
    pi - (4 / 3) * i ^ 3 * pi)).
Proof.
  exists 6, (625 / 1521), (-3), 1.
  split; [computed | ]. computed.
Qed.


(** cylinder: The moments of every full cylinder, by integrating over it; its products vanish. *)

(* centre, x *)
Theorem cylinder_1 :
  forall h pi r : R,
  h <> 0 ->
  pi <> 0 ->
  r <> 0 ->
  0 = 0 / (h * pi * r ^ 2).
Proof.
  intros h pi r   D_1 D_2 D_3.
  rational.
Qed.

(* inertia, xx *)
Theorem cylinder_2 :
  forall h m pi r : R,
  h <> 0 ->
  pi <> 0 ->
  r <> 0 ->
  m * (3 * (r * r) + h * h) / 12 = ((1 / 12) * h ^ 3 * pi * r ^ 2 + (1 / 4) * h * pi * r ^ 4) * (m /
    (h * pi * r ^ 2)).
Proof.
  intros h m pi r   D_1 D_2 D_3.
  rational.
Qed.

(* inertia, zz *)
Theorem cylinder_3 :
  forall h m pi r : R,
  h <> 0 ->
  pi <> 0 ->
  r <> 0 ->
  m * (r * r) / 2 = (1 / 2) * h * pi * r ^ 4 * (m / (h * pi * r ^ 2)).
Proof.
  intros h m pi r   D_1 D_2 D_3.
  rational.
Qed.

(* With axis along x, not z. *)

(* inertia, xx *)
Theorem cylinder_mutant_1 :
  exists h m pi r : R,
  h <> 0 /\
  pi <> 0 /\
  r <> 0 /\
  m * (r * r) / 2 <> ((1 / 12) * h ^ 3 * pi * r ^ 2 + (1 / 4) * h * pi * r ^ 4) * (m / (h * pi * r ^
    2)).
Proof.
  exists 6, (625 / 1521), (-3), 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With the height doubled. *)

(* inertia, xx *)
Theorem cylinder_mutant_2 :
  exists h m pi r : R,
  h <> 0 /\
  pi <> 0 /\
  r <> 0 /\
  m * (3 * (r * r) + h * 2 * (h * 2)) / 12 <> ((1 / 12) * h ^ 3 * pi * r ^ 2 + (1 / 4) * h * pi * r
    ^ 4) * (m / (h * pi * r ^ 2)).
Proof.
  exists 6, (625 / 1521), (-3), 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** tube: The moments of every tube are those of a cylinder less those of its hole, for the mass that is left. *)

(* centre, x *)
Theorem tube_1 :
  forall h i o pi : R,
  h * o ^ 2 * pi - h * i ^ 2 * pi <> 0 ->
  0 = 0 / (h * o ^ 2 * pi - h * i ^ 2 * pi).
Proof.
  intros h i o pi   D_1.
  rational.
Qed.

(* inertia, xx *)
Theorem tube_2 :
  forall h i m o pi : R,
  h * o ^ 2 * pi - h * i ^ 2 * pi <> 0 ->
  m * (3 * (i * i + o * o) + h * h) / 12 = ((1 / 12) * h ^ 3 * o ^ 2 * pi + (1 / 4) * h * o ^ 4 * pi
    + (- ((1 / 12) * h ^ 3 * i ^ 2 * pi) - (1 / 4) * h * i ^ 4 * pi)) * (m / (h * o ^ 2 * pi - h * i
    ^ 2 * pi)).
Proof.
  intros h i m o pi   D_1.
  rational.
Qed.

(* inertia, zz *)
Theorem tube_3 :
  forall h i m o pi : R,
  h * o ^ 2 * pi - h * i ^ 2 * pi <> 0 ->
  m * (i * i + o * o) / 2 = ((1 / 2) * h * o ^ 4 * pi - (1 / 2) * h * i ^ 4 * pi) * (m / (h * o ^ 2
    * pi - h * i ^ 2 * pi)).
Proof.
  intros h i m o pi   D_1.
  rational.
Qed.

(* With i² + o² becomes o². *)

(* inertia, xx *)
Theorem tube_mutant_1 :
  exists h i m o pi : R,
  h * o ^ 2 * pi - h * i ^ 2 * pi <> 0 /\
  m * (3 * (o * o) + h * h) / 12 <> ((1 / 12) * h ^ 3 * o ^ 2 * pi + (1 / 4) * h * o ^ 4 * pi + (-
    ((1 / 12) * h ^ 3 * i ^ 2 * pi) - (1 / 4) * h * i ^ 4 * pi)) * (m / (h * o ^ 2 * pi - h * i ^ 2
    * pi)).
Proof.
  exists 4, 3, 3, 2, 5.
  split; [computed | ]. computed.
Qed.


(** cone: The centre of every full cone is a quarter of the way up; its moments about that centre, by integrating over it. *)

(* centre, x *)
Theorem cone_1 :
  forall h pi r : R,
  h <> 0 ->
  pi <> 0 ->
  r <> 0 ->
  0 = 0 / ((1 / 3) * h * pi * r ^ 2).
Proof.
  intros h pi r   D_1 D_2 D_3.
  rational.
Qed.

(* centre, z *)
Theorem cone_2 :
  forall h pi r : R,
  h <> 0 ->
  pi <> 0 ->
  r <> 0 ->
  h / 4 = (1 / 12) * h ^ 2 * pi * r ^ 2 / ((1 / 3) * h * pi * r ^ 2).
Proof.
  intros h pi r   D_1 D_2 D_3.
  rational.
Qed.

(* inertia, xx *)
Theorem cone_3 :
  forall h m pi r : R,
  h <> 0 ->
  pi <> 0 ->
  r <> 0 ->
  3 * m * (4 * (r * r) + h * h) / 80 + m * (h / 4) * (h / 4) = ((1 / 30) * h ^ 3 * pi * r ^ 2 + (1 /
    20) * h * pi * r ^ 4) * (m / ((1 / 3) * h * pi * r ^ 2)).
Proof.
  intros h m pi r   D_1 D_2 D_3.
  rational.
Qed.

(* inertia, zz *)
Theorem cone_4 :
  forall h m pi r : R,
  h <> 0 ->
  pi <> 0 ->
  r <> 0 ->
  3 * m * (r * r) / 10 = (1 / 10) * h * pi * r ^ 4 * (m / ((1 / 3) * h * pi * r ^ 2)).
Proof.
  intros h m pi r   D_1 D_2 D_3.
  rational.
Qed.

(* With the centre a third of the way up. *)

(* centre, z *)
Theorem cone_mutant_1 :
  exists h pi r : R,
  h <> 0 /\
  pi <> 0 /\
  r <> 0 /\
  h / 3 <> (1 / 12) * h ^ 2 * pi * r ^ 2 / ((1 / 3) * h * pi * r ^ 2).
Proof.
  exists 6, 1, (-3).
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.

(* With radius and height swapped. *)

(* inertia, xx *)
Theorem cone_mutant_2 :
  exists h m pi r : R,
  h <> 0 /\
  pi <> 0 /\
  r <> 0 /\
  3 * m * (4 * (h * h) + r * r) / 80 + m * (h / 4) * (h / 4) <> ((1 / 30) * h ^ 3 * pi * r ^ 2 + (1
    / 20) * h * pi * r ^ 4) * (m / ((1 / 3) * h * pi * r ^ 2)).
Proof.
  exists 6, (625 / 1521), (-3), 1.
  split; [computed | ]. split; [computed | ]. split; [computed | ]. computed.
Qed.


(** capsule: The moments of every capsule, by integrating over its cylinder and its two half balls. *)

(* centre, x *)
Theorem capsule_1 :
  forall l pi r : R,
  l * pi * r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3 <> 0 ->
  0 = 0 / (l * pi * r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3).
Proof.
  intros l pi r   D_1.
  rational.
Qed.

(* centre, z *)
Theorem capsule_2 :
  forall l pi r : R,
  l * pi * r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3 <> 0 ->
  0 = ((1 / 3) * l * pi * r ^ 3 + (1 / 4) * pi * r ^ 4 + (- ((1 / 3) * l * pi * r ^ 3) - (1 / 4) *
    pi * r ^ 4)) / (l * pi * r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3).
Proof.
  intros l pi r   D_1.
  rational.
Qed.

(* inertia, xx *)
Theorem capsule_3 :
  forall l m pi r : R,
  3 * l + 4 * r <> 0 ->
  l * pi * r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3 <> 0 ->
  m * (3 * l) / (3 * l + 4 * r) * (3 * (r * r) + l * l) / 12 + m * (4 * r) / (3 * l + 4 * r) * (2 *
    (r * r) / 5 + 3 * (l * r) / 8 + l * l / 4) = ((1 / 12) * l ^ 3 * pi * r ^ 2 + (1 / 4) * l * pi *
    r ^ 4 + ((1 / 6) * l ^ 2 * pi * r ^ 3 + (1 / 4) * l * pi * r ^ 4 + (4 / 15) * pi * r ^ 5) + ((1
    / 6) * l ^ 2 * pi * r ^ 3 + (1 / 4) * l * pi * r ^ 4 + (4 / 15) * pi * r ^ 5)) * (m / (l * pi *
    r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3)).
Proof.
  intros l m pi r   D_1 D_2.
  rational.
Qed.

(* inertia, zz *)
Theorem capsule_4 :
  forall l m pi r : R,
  3 * l + 4 * r <> 0 ->
  l * pi * r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3 <> 0 ->
  m * (3 * l) / (3 * l + 4 * r) * (r * r) / 2 + m * (4 * r) / (3 * l + 4 * r) * (2 * (r * r) / 5) =
    ((1 / 2) * l * pi * r ^ 4 + (4 / 15) * pi * r ^ 5 + (4 / 15) * pi * r ^ 5) * (m / (l * pi * r ^
    2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3)).
Proof.
  intros l m pi r   D_1 D_2.
  rational.
Qed.

(* With the caps' 3/8 l r left out. *)

(* inertia, xx *)
Theorem capsule_mutant_1 :
  exists l m pi r : R,
  3 * l + 4 * r <> 0 /\
  l * pi * r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^ 3 <> 0 /\
  m * (3 * l) / (3 * l + 4 * r) * (3 * (r * r) + l * l) / 12 + m * (4 * r) / (3 * l + 4 * r) * (2 *
    (r * r) / 5 + 3 * (l * r) / 8 + l * l / 4) - (3 / 2) * r * r * l * m / (3 * l + 4 * r) <> ((1 /
    12) * l ^ 3 * pi * r ^ 2 + (1 / 4) * l * pi * r ^ 4 + ((1 / 6) * l ^ 2 * pi * r ^ 3 + (1 / 4) *
    l * pi * r ^ 4 + (4 / 15) * pi * r ^ 5) + ((1 / 6) * l ^ 2 * pi * r ^ 3 + (1 / 4) * l * pi * r ^
    4 + (4 / 15) * pi * r ^ 5)) * (m / (l * pi * r ^ 2 + (2 / 3) * pi * r ^ 3 + (2 / 3) * pi * r ^
    3)).
Proof.
  exists 6, (625 / 1521), (-3), 1.
  split; [computed | ]. split; [computed | ]. computed.
Qed.


(** thin-bodies: Rod, plate and disk are what remains of box and cylinder as a size goes to zero. *)

(* rod, xx *)
Theorem thin_bodies_1 :
  forall c m : R,
  m * (c * c) / 12 = (1 / 12) * c ^ 2 * m.
Proof.
  intros c m   .
  rational.
Qed.

(* plate, xx *)
Theorem thin_bodies_2 :
  forall b m : R,
  m * (b * b) / 12 = (1 / 12) * b ^ 2 * m.
Proof.
  intros b m   .
  rational.
Qed.

(* plate, yy *)
Theorem thin_bodies_3 :
  forall a m : R,
  m * (a * a) / 12 = (1 / 12) * a ^ 2 * m.
Proof.
  intros a m   .
  rational.
Qed.

(* plate, zz *)
Theorem thin_bodies_4 :
  forall a b m : R,
  m * (b * b) / 12 + m * (a * a) / 12 = (1 / 12) * a ^ 2 * m + (1 / 12) * b ^ 2 * m.
Proof.
  intros a b m   .
  rational.
Qed.

(* disk, xx *)
Theorem thin_bodies_5 :
  forall m r : R,
  m * (r * r) / 4 = (1 / 4) * m * r ^ 2.
Proof.
  intros m r   .
  rational.
Qed.

(* disk, zz *)
Theorem thin_bodies_6 :
  forall m r : R,
  m * (r * r) / 4 + m * (r * r) / 4 = (1 / 2) * m * r ^ 2.
Proof.
  intros m r   .
  rational.
Qed.

(* With the rod along x. *)

(* rod, xx *)
Theorem thin_bodies_mutant_1 :
  exists c m : R,
  0 <> (1 / 12) * c ^ 2 * m.
Proof.
  exists 6, (625 / 1521).
  computed.
Qed.

(* With the plate's edges swapped. *)

(* plate, xx *)
Theorem thin_bodies_mutant_2 :
  exists a b m : R,
  m * (a * a) / 12 <> (1 / 12) * b ^ 2 * m.
Proof.
  exists 6, 1, (625 / 1521).
  computed.
Qed.

(* With the disk twice as heavy. *)

(* disk, xx *)
Theorem thin_bodies_mutant_3 :
  exists m r : R,
  m * 2 * (r * r) / 4 <> (1 / 4) * m * r ^ 2.
Proof.
  exists (625 / 1521), 1.
  computed.
Qed.


(** tetrahedron: Centre and inertia of every tetrahedron, wherever its corners are, by integrating over it. *)

(* centre, x *)
Theorem tetrahedron_1 :
  forall x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := - ((1 / 24) * x1 ^ 2 * y2 * z3) + (1 / 24) * x1 ^ 2 * y2 * z4 + (1 / 24) * x1 ^ 2 * y3
    * z2 - (1 / 24) * x1 ^ 2 * y3 * z4 - (1 / 24) * x1 ^ 2 * y4 * z2 + (1 / 24) * x1 ^ 2 * y4 * z3 +
    (1 / 24) * x1 * x2 * y1 * z3 - (1 / 24) * x1 * x2 * y1 * z4 - (1 / 24) * x1 * x2 * y2 * z3 + (1
    / 24) * x1 * x2 * y2 * z4 - (1 / 24) * x1 * x2 * y3 * z1 in
  let t_2 := t_1 + (1 / 24) * x1 * x2 * y3 * z2 + (1 / 24) * x1 * x2 * y4 * z1 - (1 / 24) * x1 * x2
    * y4 * z2 - (1 / 24) * x1 * x3 * y1 * z2 + (1 / 24) * x1 * x3 * y1 * z4 + (1 / 24) * x1 * x3 *
    y2 * z1 - (1 / 24) * x1 * x3 * y2 * z3 + (1 / 24) * x1 * x3 * y3 * z2 - (1 / 24) * x1 * x3 * y3
    * z4 - (1 / 24) * x1 * x3 * y4 * z1 in
  let t_3 := t_2 + (1 / 24) * x1 * x3 * y4 * z3 + (1 / 24) * x1 * x4 * y1 * z2 - (1 / 24) * x1 * x4
    * y1 * z3 - (1 / 24) * x1 * x4 * y2 * z1 + (1 / 24) * x1 * x4 * y2 * z4 + (1 / 24) * x1 * x4 *
    y3 * z1 - (1 / 24) * x1 * x4 * y3 * z4 - (1 / 24) * x1 * x4 * y4 * z2 + (1 / 24) * x1 * x4 * y4
    * z3 + (1 / 24) * x2 ^ 2 * y1 * z3 in
  let t_4 := t_3 - (1 / 24) * x2 ^ 2 * y1 * z4 - (1 / 24) * x2 ^ 2 * y3 * z1 + (1 / 24) * x2 ^ 2 *
    y3 * z4 + (1 / 24) * x2 ^ 2 * y4 * z1 - (1 / 24) * x2 ^ 2 * y4 * z3 - (1 / 24) * x2 * x3 * y1 *
    z2 + (1 / 24) * x2 * x3 * y1 * z3 + (1 / 24) * x2 * x3 * y2 * z1 - (1 / 24) * x2 * x3 * y2 * z4
    - (1 / 24) * x2 * x3 * y3 * z1 + (1 / 24) * x2 * x3 * y3 * z4 in
  let t_5 := t_4 + (1 / 24) * x2 * x3 * y4 * z2 - (1 / 24) * x2 * x3 * y4 * z3 + (1 / 24) * x2 * x4
    * y1 * z2 - (1 / 24) * x2 * x4 * y1 * z4 - (1 / 24) * x2 * x4 * y2 * z1 + (1 / 24) * x2 * x4 *
    y2 * z3 - (1 / 24) * x2 * x4 * y3 * z2 + (1 / 24) * x2 * x4 * y3 * z4 + (1 / 24) * x2 * x4 * y4
    * z1 - (1 / 24) * x2 * x4 * y4 * z3 in
  let t_6 := t_5 - (1 / 24) * x3 ^ 2 * y1 * z2 + (1 / 24) * x3 ^ 2 * y1 * z4 + (1 / 24) * x3 ^ 2 *
    y2 * z1 - (1 / 24) * x3 ^ 2 * y2 * z4 - (1 / 24) * x3 ^ 2 * y4 * z1 + (1 / 24) * x3 ^ 2 * y4 *
    z2 - (1 / 24) * x3 * x4 * y1 * z3 + (1 / 24) * x3 * x4 * y1 * z4 + (1 / 24) * x3 * x4 * y2 * z3
    - (1 / 24) * x3 * x4 * y2 * z4 + (1 / 24) * x3 * x4 * y3 * z1 in
  let t_7 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_8 := (t_6 - (1 / 24) * x3 * x4 * y3 * z2 - (1 / 24) * x3 * x4 * y4 * z1 + (1 / 24) * x3 * x4
    * y4 * z2 + (1 / 24) * x4 ^ 2 * y1 * z2 - (1 / 24) * x4 ^ 2 * y1 * z3 - (1 / 24) * x4 ^ 2 * y2 *
    z1 + (1 / 24) * x4 ^ 2 * y2 * z3 + (1 / 24) * x4 ^ 2 * y3 * z1 - (1 / 24) * x4 ^ 2 * y3 * z2) /
    (t_7 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2) in
  t_7 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4
    * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 *
    y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  x1 + (x2 - x1 + (x3 - x1) + (x4 - x1)) / 4 = t_8.
Proof.
  intros x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 D_1.
  rational.
Qed.

(* centre, y *)
Theorem tetrahedron_2 :
  forall x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := - ((1 / 24) * x1 * y1 * y2 * z3) + (1 / 24) * x1 * y1 * y2 * z4 + (1 / 24) * x1 * y1 *
    y3 * z2 - (1 / 24) * x1 * y1 * y3 * z4 - (1 / 24) * x1 * y1 * y4 * z2 + (1 / 24) * x1 * y1 * y4
    * z3 - (1 / 24) * x1 * y2 ^ 2 * z3 + (1 / 24) * x1 * y2 ^ 2 * z4 + (1 / 24) * x1 * y2 * y3 * z2
    - (1 / 24) * x1 * y2 * y3 * z3 - (1 / 24) * x1 * y2 * y4 * z2 in
  let t_2 := t_1 + (1 / 24) * x1 * y2 * y4 * z4 + (1 / 24) * x1 * y3 ^ 2 * z2 - (1 / 24) * x1 * y3 ^
    2 * z4 + (1 / 24) * x1 * y3 * y4 * z3 - (1 / 24) * x1 * y3 * y4 * z4 - (1 / 24) * x1 * y4 ^ 2 *
    z2 + (1 / 24) * x1 * y4 ^ 2 * z3 + (1 / 24) * x2 * y1 ^ 2 * z3 - (1 / 24) * x2 * y1 ^ 2 * z4 +
    (1 / 24) * x2 * y1 * y2 * z3 - (1 / 24) * x2 * y1 * y2 * z4 in
  let t_3 := t_2 - (1 / 24) * x2 * y1 * y3 * z1 + (1 / 24) * x2 * y1 * y3 * z3 + (1 / 24) * x2 * y1
    * y4 * z1 - (1 / 24) * x2 * y1 * y4 * z4 - (1 / 24) * x2 * y2 * y3 * z1 + (1 / 24) * x2 * y2 *
    y3 * z4 + (1 / 24) * x2 * y2 * y4 * z1 - (1 / 24) * x2 * y2 * y4 * z3 - (1 / 24) * x2 * y3 ^ 2 *
    z1 + (1 / 24) * x2 * y3 ^ 2 * z4 - (1 / 24) * x2 * y3 * y4 * z3 in
  let t_4 := t_3 + (1 / 24) * x2 * y3 * y4 * z4 + (1 / 24) * x2 * y4 ^ 2 * z1 - (1 / 24) * x2 * y4 ^
    2 * z3 - (1 / 24) * x3 * y1 ^ 2 * z2 + (1 / 24) * x3 * y1 ^ 2 * z4 + (1 / 24) * x3 * y1 * y2 *
    z1 - (1 / 24) * x3 * y1 * y2 * z2 - (1 / 24) * x3 * y1 * y3 * z2 + (1 / 24) * x3 * y1 * y3 * z4
    - (1 / 24) * x3 * y1 * y4 * z1 + (1 / 24) * x3 * y1 * y4 * z4 in
  let t_5 := t_4 + (1 / 24) * x3 * y2 ^ 2 * z1 - (1 / 24) * x3 * y2 ^ 2 * z4 + (1 / 24) * x3 * y2 *
    y3 * z1 - (1 / 24) * x3 * y2 * y3 * z4 + (1 / 24) * x3 * y2 * y4 * z2 - (1 / 24) * x3 * y2 * y4
    * z4 - (1 / 24) * x3 * y3 * y4 * z1 + (1 / 24) * x3 * y3 * y4 * z2 - (1 / 24) * x3 * y4 ^ 2 * z1
    + (1 / 24) * x3 * y4 ^ 2 * z2 + (1 / 24) * x4 * y1 ^ 2 * z2 in
  let t_6 := t_5 - (1 / 24) * x4 * y1 ^ 2 * z3 - (1 / 24) * x4 * y1 * y2 * z1 + (1 / 24) * x4 * y1 *
    y2 * z2 + (1 / 24) * x4 * y1 * y3 * z1 - (1 / 24) * x4 * y1 * y3 * z3 + (1 / 24) * x4 * y1 * y4
    * z2 - (1 / 24) * x4 * y1 * y4 * z3 - (1 / 24) * x4 * y2 ^ 2 * z1 + (1 / 24) * x4 * y2 ^ 2 * z3
    - (1 / 24) * x4 * y2 * y3 * z2 + (1 / 24) * x4 * y2 * y3 * z3 in
  let t_7 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_8 := (t_6 - (1 / 24) * x4 * y2 * y4 * z1 + (1 / 24) * x4 * y2 * y4 * z3 + (1 / 24) * x4 * y3
    ^ 2 * z1 - (1 / 24) * x4 * y3 ^ 2 * z2 + (1 / 24) * x4 * y3 * y4 * z1 - (1 / 24) * x4 * y3 * y4
    * z2) / (t_7 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 /
    6) * x3 * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 -
    (1 / 6) * x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 *
    z2) in
  t_7 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4
    * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 *
    y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  y1 + (y2 - y1 + (y3 - y1) + (y4 - y1)) / 4 = t_8.
Proof.
  intros x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 D_1.
  rational.
Qed.

(* centre, z *)
Theorem tetrahedron_3 :
  forall x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := - ((1 / 24) * x1 * y2 * z1 * z3) + (1 / 24) * x1 * y2 * z1 * z4 - (1 / 24) * x1 * y2 *
    z2 * z3 + (1 / 24) * x1 * y2 * z2 * z4 - (1 / 24) * x1 * y2 * z3 ^ 2 + (1 / 24) * x1 * y2 * z4 ^
    2 + (1 / 24) * x1 * y3 * z1 * z2 - (1 / 24) * x1 * y3 * z1 * z4 + (1 / 24) * x1 * y3 * z2 ^ 2 +
    (1 / 24) * x1 * y3 * z2 * z3 - (1 / 24) * x1 * y3 * z3 * z4 in
  let t_2 := t_1 - (1 / 24) * x1 * y3 * z4 ^ 2 - (1 / 24) * x1 * y4 * z1 * z2 + (1 / 24) * x1 * y4 *
    z1 * z3 - (1 / 24) * x1 * y4 * z2 ^ 2 - (1 / 24) * x1 * y4 * z2 * z4 + (1 / 24) * x1 * y4 * z3 ^
    2 + (1 / 24) * x1 * y4 * z3 * z4 + (1 / 24) * x2 * y1 * z1 * z3 - (1 / 24) * x2 * y1 * z1 * z4 +
    (1 / 24) * x2 * y1 * z2 * z3 - (1 / 24) * x2 * y1 * z2 * z4 in
  let t_3 := t_2 + (1 / 24) * x2 * y1 * z3 ^ 2 - (1 / 24) * x2 * y1 * z4 ^ 2 - (1 / 24) * x2 * y3 *
    z1 ^ 2 - (1 / 24) * x2 * y3 * z1 * z2 - (1 / 24) * x2 * y3 * z1 * z3 + (1 / 24) * x2 * y3 * z2 *
    z4 + (1 / 24) * x2 * y3 * z3 * z4 + (1 / 24) * x2 * y3 * z4 ^ 2 + (1 / 24) * x2 * y4 * z1 ^ 2 +
    (1 / 24) * x2 * y4 * z1 * z2 + (1 / 24) * x2 * y4 * z1 * z4 in
  let t_4 := t_3 - (1 / 24) * x2 * y4 * z2 * z3 - (1 / 24) * x2 * y4 * z3 ^ 2 - (1 / 24) * x2 * y4 *
    z3 * z4 - (1 / 24) * x3 * y1 * z1 * z2 + (1 / 24) * x3 * y1 * z1 * z4 - (1 / 24) * x3 * y1 * z2
    ^ 2 - (1 / 24) * x3 * y1 * z2 * z3 + (1 / 24) * x3 * y1 * z3 * z4 + (1 / 24) * x3 * y1 * z4 ^ 2
    + (1 / 24) * x3 * y2 * z1 ^ 2 + (1 / 24) * x3 * y2 * z1 * z2 in
  let t_5 := t_4 + (1 / 24) * x3 * y2 * z1 * z3 - (1 / 24) * x3 * y2 * z2 * z4 - (1 / 24) * x3 * y2
    * z3 * z4 - (1 / 24) * x3 * y2 * z4 ^ 2 - (1 / 24) * x3 * y4 * z1 ^ 2 - (1 / 24) * x3 * y4 * z1
    * z3 - (1 / 24) * x3 * y4 * z1 * z4 + (1 / 24) * x3 * y4 * z2 ^ 2 + (1 / 24) * x3 * y4 * z2 * z3
    + (1 / 24) * x3 * y4 * z2 * z4 + (1 / 24) * x4 * y1 * z1 * z2 in
  let t_6 := t_5 - (1 / 24) * x4 * y1 * z1 * z3 + (1 / 24) * x4 * y1 * z2 ^ 2 + (1 / 24) * x4 * y1 *
    z2 * z4 - (1 / 24) * x4 * y1 * z3 ^ 2 - (1 / 24) * x4 * y1 * z3 * z4 - (1 / 24) * x4 * y2 * z1 ^
    2 - (1 / 24) * x4 * y2 * z1 * z2 - (1 / 24) * x4 * y2 * z1 * z4 + (1 / 24) * x4 * y2 * z2 * z3 +
    (1 / 24) * x4 * y2 * z3 ^ 2 + (1 / 24) * x4 * y2 * z3 * z4 in
  let t_7 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_8 := (t_6 + (1 / 24) * x4 * y3 * z1 ^ 2 + (1 / 24) * x4 * y3 * z1 * z3 + (1 / 24) * x4 * y3
    * z1 * z4 - (1 / 24) * x4 * y3 * z2 ^ 2 - (1 / 24) * x4 * y3 * z2 * z3 - (1 / 24) * x4 * y3 * z2
    * z4) / (t_7 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 /
    6) * x3 * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 -
    (1 / 6) * x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 *
    z2) in
  t_7 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4
    * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 *
    y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  z1 + (z2 - z1 + (z3 - z1) + (z4 - z1)) / 4 = t_8.
Proof.
  intros x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 D_1.
  rational.
Qed.

(* inertia, xx *)
Theorem tetrahedron_4 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (y2 - y1 + (y3 - y1) + (y4 - y1)) / 4 in
  let t_2 := (z2 - z1 + (z3 - z1) + (z4 - z1)) / 4 in
  let t_3 := m / 20 * t_1 * t_1 + m / 20 * t_2 * t_2 + (m / 20 * (y2 - y1 - t_1) * (y2 - y1 - t_1) +
    m / 20 * (z2 - z1 - t_2) * (z2 - z1 - t_2)) + (m / 20 * (y3 - y1 - t_1) * (y3 - y1 - t_1) + m /
    20 * (z3 - z1 - t_2) * (z3 - z1 - t_2)) + (m / 20 * (y4 - y1 - t_1) * (y4 - y1 - t_1) + m / 20 *
    (z4 - z1 - t_2) * (z4 - z1 - t_2)) in
  let t_4 := - ((1 / 60) * x1 * y1 ^ 2 * y2 * z3) + (1 / 60) * x1 * y1 ^ 2 * y2 * z4 + (1 / 60) * x1
    * y1 ^ 2 * y3 * z2 - (1 / 60) * x1 * y1 ^ 2 * y3 * z4 - (1 / 60) * x1 * y1 ^ 2 * y4 * z2 + (1 /
    60) * x1 * y1 ^ 2 * y4 * z3 - (1 / 60) * x1 * y1 * y2 ^ 2 * z3 + (1 / 60) * x1 * y1 * y2 ^ 2 *
    z4 + (1 / 60) * x1 * y1 * y2 * y3 * z2 in
  let t_5 := t_4 - (1 / 60) * x1 * y1 * y2 * y3 * z3 - (1 / 60) * x1 * y1 * y2 * y4 * z2 + (1 / 60)
    * x1 * y1 * y2 * y4 * z4 + (1 / 60) * x1 * y1 * y3 ^ 2 * z2 - (1 / 60) * x1 * y1 * y3 ^ 2 * z4 +
    (1 / 60) * x1 * y1 * y3 * y4 * z3 - (1 / 60) * x1 * y1 * y3 * y4 * z4 - (1 / 60) * x1 * y1 * y4
    ^ 2 * z2 + (1 / 60) * x1 * y1 * y4 ^ 2 * z3 in
  let t_6 := t_5 - (1 / 60) * x1 * y2 ^ 3 * z3 + (1 / 60) * x1 * y2 ^ 3 * z4 + (1 / 60) * x1 * y2 ^
    2 * y3 * z2 - (1 / 60) * x1 * y2 ^ 2 * y3 * z3 - (1 / 60) * x1 * y2 ^ 2 * y4 * z2 + (1 / 60) *
    x1 * y2 ^ 2 * y4 * z4 + (1 / 60) * x1 * y2 * y3 ^ 2 * z2 - (1 / 60) * x1 * y2 * y3 ^ 2 * z3 - (1
    / 60) * x1 * y2 * y4 ^ 2 * z2 + (1 / 60) * x1 * y2 * y4 ^ 2 * z4 in
  let t_7 := t_6 - (1 / 60) * x1 * y2 * z1 ^ 2 * z3 + (1 / 60) * x1 * y2 * z1 ^ 2 * z4 - (1 / 60) *
    x1 * y2 * z1 * z2 * z3 + (1 / 60) * x1 * y2 * z1 * z2 * z4 - (1 / 60) * x1 * y2 * z1 * z3 ^ 2 +
    (1 / 60) * x1 * y2 * z1 * z4 ^ 2 - (1 / 60) * x1 * y2 * z2 ^ 2 * z3 + (1 / 60) * x1 * y2 * z2 ^
    2 * z4 - (1 / 60) * x1 * y2 * z2 * z3 ^ 2 in
  let t_8 := t_7 + (1 / 60) * x1 * y2 * z2 * z4 ^ 2 - (1 / 60) * x1 * y2 * z3 ^ 3 + (1 / 60) * x1 *
    y2 * z4 ^ 3 + (1 / 60) * x1 * y3 ^ 3 * z2 - (1 / 60) * x1 * y3 ^ 3 * z4 + (1 / 60) * x1 * y3 ^ 2
    * y4 * z3 - (1 / 60) * x1 * y3 ^ 2 * y4 * z4 + (1 / 60) * x1 * y3 * y4 ^ 2 * z3 - (1 / 60) * x1
    * y3 * y4 ^ 2 * z4 + (1 / 60) * x1 * y3 * z1 ^ 2 * z2 in
  let t_9 := t_8 - (1 / 60) * x1 * y3 * z1 ^ 2 * z4 + (1 / 60) * x1 * y3 * z1 * z2 ^ 2 + (1 / 60) *
    x1 * y3 * z1 * z2 * z3 - (1 / 60) * x1 * y3 * z1 * z3 * z4 - (1 / 60) * x1 * y3 * z1 * z4 ^ 2 +
    (1 / 60) * x1 * y3 * z2 ^ 3 + (1 / 60) * x1 * y3 * z2 ^ 2 * z3 + (1 / 60) * x1 * y3 * z2 * z3 ^
    2 - (1 / 60) * x1 * y3 * z3 ^ 2 * z4 in
  let t_10 := t_9 - (1 / 60) * x1 * y3 * z3 * z4 ^ 2 - (1 / 60) * x1 * y3 * z4 ^ 3 - (1 / 60) * x1 *
    y4 ^ 3 * z2 + (1 / 60) * x1 * y4 ^ 3 * z3 - (1 / 60) * x1 * y4 * z1 ^ 2 * z2 + (1 / 60) * x1 *
    y4 * z1 ^ 2 * z3 - (1 / 60) * x1 * y4 * z1 * z2 ^ 2 - (1 / 60) * x1 * y4 * z1 * z2 * z4 + (1 /
    60) * x1 * y4 * z1 * z3 ^ 2 + (1 / 60) * x1 * y4 * z1 * z3 * z4 in
  let t_11 := t_10 - (1 / 60) * x1 * y4 * z2 ^ 3 - (1 / 60) * x1 * y4 * z2 ^ 2 * z4 - (1 / 60) * x1
    * y4 * z2 * z4 ^ 2 + (1 / 60) * x1 * y4 * z3 ^ 3 + (1 / 60) * x1 * y4 * z3 ^ 2 * z4 + (1 / 60) *
    x1 * y4 * z3 * z4 ^ 2 + (1 / 60) * x2 * y1 ^ 3 * z3 - (1 / 60) * x2 * y1 ^ 3 * z4 + (1 / 60) *
    x2 * y1 ^ 2 * y2 * z3 - (1 / 60) * x2 * y1 ^ 2 * y2 * z4 in
  let t_12 := t_11 - (1 / 60) * x2 * y1 ^ 2 * y3 * z1 + (1 / 60) * x2 * y1 ^ 2 * y3 * z3 + (1 / 60)
    * x2 * y1 ^ 2 * y4 * z1 - (1 / 60) * x2 * y1 ^ 2 * y4 * z4 + (1 / 60) * x2 * y1 * y2 ^ 2 * z3 -
    (1 / 60) * x2 * y1 * y2 ^ 2 * z4 - (1 / 60) * x2 * y1 * y2 * y3 * z1 + (1 / 60) * x2 * y1 * y2 *
    y3 * z3 + (1 / 60) * x2 * y1 * y2 * y4 * z1 in
  let t_13 := t_12 - (1 / 60) * x2 * y1 * y2 * y4 * z4 - (1 / 60) * x2 * y1 * y3 ^ 2 * z1 + (1 / 60)
    * x2 * y1 * y3 ^ 2 * z3 + (1 / 60) * x2 * y1 * y4 ^ 2 * z1 - (1 / 60) * x2 * y1 * y4 ^ 2 * z4 +
    (1 / 60) * x2 * y1 * z1 ^ 2 * z3 - (1 / 60) * x2 * y1 * z1 ^ 2 * z4 + (1 / 60) * x2 * y1 * z1 *
    z2 * z3 - (1 / 60) * x2 * y1 * z1 * z2 * z4 in
  let t_14 := t_13 + (1 / 60) * x2 * y1 * z1 * z3 ^ 2 - (1 / 60) * x2 * y1 * z1 * z4 ^ 2 + (1 / 60)
    * x2 * y1 * z2 ^ 2 * z3 - (1 / 60) * x2 * y1 * z2 ^ 2 * z4 + (1 / 60) * x2 * y1 * z2 * z3 ^ 2 -
    (1 / 60) * x2 * y1 * z2 * z4 ^ 2 + (1 / 60) * x2 * y1 * z3 ^ 3 - (1 / 60) * x2 * y1 * z4 ^ 3 -
    (1 / 60) * x2 * y2 ^ 2 * y3 * z1 + (1 / 60) * x2 * y2 ^ 2 * y3 * z4 in
  let t_15 := t_14 + (1 / 60) * x2 * y2 ^ 2 * y4 * z1 - (1 / 60) * x2 * y2 ^ 2 * y4 * z3 - (1 / 60)
    * x2 * y2 * y3 ^ 2 * z1 + (1 / 60) * x2 * y2 * y3 ^ 2 * z4 - (1 / 60) * x2 * y2 * y3 * y4 * z3 +
    (1 / 60) * x2 * y2 * y3 * y4 * z4 + (1 / 60) * x2 * y2 * y4 ^ 2 * z1 - (1 / 60) * x2 * y2 * y4 ^
    2 * z3 - (1 / 60) * x2 * y3 ^ 3 * z1 in
  let t_16 := t_15 + (1 / 60) * x2 * y3 ^ 3 * z4 - (1 / 60) * x2 * y3 ^ 2 * y4 * z3 + (1 / 60) * x2
    * y3 ^ 2 * y4 * z4 - (1 / 60) * x2 * y3 * y4 ^ 2 * z3 + (1 / 60) * x2 * y3 * y4 ^ 2 * z4 - (1 /
    60) * x2 * y3 * z1 ^ 3 - (1 / 60) * x2 * y3 * z1 ^ 2 * z2 - (1 / 60) * x2 * y3 * z1 ^ 2 * z3 -
    (1 / 60) * x2 * y3 * z1 * z2 ^ 2 - (1 / 60) * x2 * y3 * z1 * z2 * z3 in
  let t_17 := t_16 - (1 / 60) * x2 * y3 * z1 * z3 ^ 2 + (1 / 60) * x2 * y3 * z2 ^ 2 * z4 + (1 / 60)
    * x2 * y3 * z2 * z3 * z4 + (1 / 60) * x2 * y3 * z2 * z4 ^ 2 + (1 / 60) * x2 * y3 * z3 ^ 2 * z4 +
    (1 / 60) * x2 * y3 * z3 * z4 ^ 2 + (1 / 60) * x2 * y3 * z4 ^ 3 + (1 / 60) * x2 * y4 ^ 3 * z1 -
    (1 / 60) * x2 * y4 ^ 3 * z3 + (1 / 60) * x2 * y4 * z1 ^ 3 in
  let t_18 := t_17 + (1 / 60) * x2 * y4 * z1 ^ 2 * z2 + (1 / 60) * x2 * y4 * z1 ^ 2 * z4 + (1 / 60)
    * x2 * y4 * z1 * z2 ^ 2 + (1 / 60) * x2 * y4 * z1 * z2 * z4 + (1 / 60) * x2 * y4 * z1 * z4 ^ 2 -
    (1 / 60) * x2 * y4 * z2 ^ 2 * z3 - (1 / 60) * x2 * y4 * z2 * z3 ^ 2 - (1 / 60) * x2 * y4 * z2 *
    z3 * z4 - (1 / 60) * x2 * y4 * z3 ^ 3 in
  let t_19 := t_18 - (1 / 60) * x2 * y4 * z3 ^ 2 * z4 - (1 / 60) * x2 * y4 * z3 * z4 ^ 2 - (1 / 60)
    * x3 * y1 ^ 3 * z2 + (1 / 60) * x3 * y1 ^ 3 * z4 + (1 / 60) * x3 * y1 ^ 2 * y2 * z1 - (1 / 60) *
    x3 * y1 ^ 2 * y2 * z2 - (1 / 60) * x3 * y1 ^ 2 * y3 * z2 + (1 / 60) * x3 * y1 ^ 2 * y3 * z4 - (1
    / 60) * x3 * y1 ^ 2 * y4 * z1 + (1 / 60) * x3 * y1 ^ 2 * y4 * z4 in
  let t_20 := t_19 + (1 / 60) * x3 * y1 * y2 ^ 2 * z1 - (1 / 60) * x3 * y1 * y2 ^ 2 * z2 + (1 / 60)
    * x3 * y1 * y2 * y3 * z1 - (1 / 60) * x3 * y1 * y2 * y3 * z2 - (1 / 60) * x3 * y1 * y3 ^ 2 * z2
    + (1 / 60) * x3 * y1 * y3 ^ 2 * z4 - (1 / 60) * x3 * y1 * y3 * y4 * z1 + (1 / 60) * x3 * y1 * y3
    * y4 * z4 - (1 / 60) * x3 * y1 * y4 ^ 2 * z1 in
  let t_21 := t_20 + (1 / 60) * x3 * y1 * y4 ^ 2 * z4 - (1 / 60) * x3 * y1 * z1 ^ 2 * z2 + (1 / 60)
    * x3 * y1 * z1 ^ 2 * z4 - (1 / 60) * x3 * y1 * z1 * z2 ^ 2 - (1 / 60) * x3 * y1 * z1 * z2 * z3 +
    (1 / 60) * x3 * y1 * z1 * z3 * z4 + (1 / 60) * x3 * y1 * z1 * z4 ^ 2 - (1 / 60) * x3 * y1 * z2 ^
    3 - (1 / 60) * x3 * y1 * z2 ^ 2 * z3 in
  let t_22 := t_21 - (1 / 60) * x3 * y1 * z2 * z3 ^ 2 + (1 / 60) * x3 * y1 * z3 ^ 2 * z4 + (1 / 60)
    * x3 * y1 * z3 * z4 ^ 2 + (1 / 60) * x3 * y1 * z4 ^ 3 + (1 / 60) * x3 * y2 ^ 3 * z1 - (1 / 60) *
    x3 * y2 ^ 3 * z4 + (1 / 60) * x3 * y2 ^ 2 * y3 * z1 - (1 / 60) * x3 * y2 ^ 2 * y3 * z4 + (1 /
    60) * x3 * y2 ^ 2 * y4 * z2 - (1 / 60) * x3 * y2 ^ 2 * y4 * z4 in
  let t_23 := t_22 + (1 / 60) * x3 * y2 * y3 ^ 2 * z1 - (1 / 60) * x3 * y2 * y3 ^ 2 * z4 + (1 / 60)
    * x3 * y2 * y3 * y4 * z2 - (1 / 60) * x3 * y2 * y3 * y4 * z4 + (1 / 60) * x3 * y2 * y4 ^ 2 * z2
    - (1 / 60) * x3 * y2 * y4 ^ 2 * z4 + (1 / 60) * x3 * y2 * z1 ^ 3 + (1 / 60) * x3 * y2 * z1 ^ 2 *
    z2 + (1 / 60) * x3 * y2 * z1 ^ 2 * z3 in
  let t_24 := t_23 + (1 / 60) * x3 * y2 * z1 * z2 ^ 2 + (1 / 60) * x3 * y2 * z1 * z2 * z3 + (1 / 60)
    * x3 * y2 * z1 * z3 ^ 2 - (1 / 60) * x3 * y2 * z2 ^ 2 * z4 - (1 / 60) * x3 * y2 * z2 * z3 * z4 -
    (1 / 60) * x3 * y2 * z2 * z4 ^ 2 - (1 / 60) * x3 * y2 * z3 ^ 2 * z4 - (1 / 60) * x3 * y2 * z3 *
    z4 ^ 2 - (1 / 60) * x3 * y2 * z4 ^ 3 in
  let t_25 := t_24 - (1 / 60) * x3 * y3 ^ 2 * y4 * z1 + (1 / 60) * x3 * y3 ^ 2 * y4 * z2 - (1 / 60)
    * x3 * y3 * y4 ^ 2 * z1 + (1 / 60) * x3 * y3 * y4 ^ 2 * z2 - (1 / 60) * x3 * y4 ^ 3 * z1 + (1 /
    60) * x3 * y4 ^ 3 * z2 - (1 / 60) * x3 * y4 * z1 ^ 3 - (1 / 60) * x3 * y4 * z1 ^ 2 * z3 - (1 /
    60) * x3 * y4 * z1 ^ 2 * z4 - (1 / 60) * x3 * y4 * z1 * z3 ^ 2 in
  let t_26 := t_25 - (1 / 60) * x3 * y4 * z1 * z3 * z4 - (1 / 60) * x3 * y4 * z1 * z4 ^ 2 + (1 / 60)
    * x3 * y4 * z2 ^ 3 + (1 / 60) * x3 * y4 * z2 ^ 2 * z3 + (1 / 60) * x3 * y4 * z2 ^ 2 * z4 + (1 /
    60) * x3 * y4 * z2 * z3 ^ 2 + (1 / 60) * x3 * y4 * z2 * z3 * z4 + (1 / 60) * x3 * y4 * z2 * z4 ^
    2 + (1 / 60) * x4 * y1 ^ 3 * z2 - (1 / 60) * x4 * y1 ^ 3 * z3 in
  let t_27 := t_26 - (1 / 60) * x4 * y1 ^ 2 * y2 * z1 + (1 / 60) * x4 * y1 ^ 2 * y2 * z2 + (1 / 60)
    * x4 * y1 ^ 2 * y3 * z1 - (1 / 60) * x4 * y1 ^ 2 * y3 * z3 + (1 / 60) * x4 * y1 ^ 2 * y4 * z2 -
    (1 / 60) * x4 * y1 ^ 2 * y4 * z3 - (1 / 60) * x4 * y1 * y2 ^ 2 * z1 + (1 / 60) * x4 * y1 * y2 ^
    2 * z2 - (1 / 60) * x4 * y1 * y2 * y4 * z1 in
  let t_28 := t_27 + (1 / 60) * x4 * y1 * y2 * y4 * z2 + (1 / 60) * x4 * y1 * y3 ^ 2 * z1 - (1 / 60)
    * x4 * y1 * y3 ^ 2 * z3 + (1 / 60) * x4 * y1 * y3 * y4 * z1 - (1 / 60) * x4 * y1 * y3 * y4 * z3
    + (1 / 60) * x4 * y1 * y4 ^ 2 * z2 - (1 / 60) * x4 * y1 * y4 ^ 2 * z3 + (1 / 60) * x4 * y1 * z1
    ^ 2 * z2 - (1 / 60) * x4 * y1 * z1 ^ 2 * z3 in
  let t_29 := t_28 + (1 / 60) * x4 * y1 * z1 * z2 ^ 2 + (1 / 60) * x4 * y1 * z1 * z2 * z4 - (1 / 60)
    * x4 * y1 * z1 * z3 ^ 2 - (1 / 60) * x4 * y1 * z1 * z3 * z4 + (1 / 60) * x4 * y1 * z2 ^ 3 + (1 /
    60) * x4 * y1 * z2 ^ 2 * z4 + (1 / 60) * x4 * y1 * z2 * z4 ^ 2 - (1 / 60) * x4 * y1 * z3 ^ 3 -
    (1 / 60) * x4 * y1 * z3 ^ 2 * z4 - (1 / 60) * x4 * y1 * z3 * z4 ^ 2 in
  let t_30 := t_29 - (1 / 60) * x4 * y2 ^ 3 * z1 + (1 / 60) * x4 * y2 ^ 3 * z3 - (1 / 60) * x4 * y2
    ^ 2 * y3 * z2 + (1 / 60) * x4 * y2 ^ 2 * y3 * z3 - (1 / 60) * x4 * y2 ^ 2 * y4 * z1 + (1 / 60) *
    x4 * y2 ^ 2 * y4 * z3 - (1 / 60) * x4 * y2 * y3 ^ 2 * z2 + (1 / 60) * x4 * y2 * y3 ^ 2 * z3 - (1
    / 60) * x4 * y2 * y3 * y4 * z2 + (1 / 60) * x4 * y2 * y3 * y4 * z3 in
  let t_31 := t_30 - (1 / 60) * x4 * y2 * y4 ^ 2 * z1 + (1 / 60) * x4 * y2 * y4 ^ 2 * z3 - (1 / 60)
    * x4 * y2 * z1 ^ 3 - (1 / 60) * x4 * y2 * z1 ^ 2 * z2 - (1 / 60) * x4 * y2 * z1 ^ 2 * z4 - (1 /
    60) * x4 * y2 * z1 * z2 ^ 2 - (1 / 60) * x4 * y2 * z1 * z2 * z4 - (1 / 60) * x4 * y2 * z1 * z4 ^
    2 + (1 / 60) * x4 * y2 * z2 ^ 2 * z3 + (1 / 60) * x4 * y2 * z2 * z3 ^ 2 in
  let t_32 := t_31 + (1 / 60) * x4 * y2 * z2 * z3 * z4 + (1 / 60) * x4 * y2 * z3 ^ 3 + (1 / 60) * x4
    * y2 * z3 ^ 2 * z4 + (1 / 60) * x4 * y2 * z3 * z4 ^ 2 + (1 / 60) * x4 * y3 ^ 3 * z1 - (1 / 60) *
    x4 * y3 ^ 3 * z2 + (1 / 60) * x4 * y3 ^ 2 * y4 * z1 - (1 / 60) * x4 * y3 ^ 2 * y4 * z2 + (1 /
    60) * x4 * y3 * y4 ^ 2 * z1 - (1 / 60) * x4 * y3 * y4 ^ 2 * z2 in
  let t_33 := t_32 + (1 / 60) * x4 * y3 * z1 ^ 3 + (1 / 60) * x4 * y3 * z1 ^ 2 * z3 + (1 / 60) * x4
    * y3 * z1 ^ 2 * z4 + (1 / 60) * x4 * y3 * z1 * z3 ^ 2 + (1 / 60) * x4 * y3 * z1 * z3 * z4 + (1 /
    60) * x4 * y3 * z1 * z4 ^ 2 - (1 / 60) * x4 * y3 * z2 ^ 3 - (1 / 60) * x4 * y3 * z2 ^ 2 * z3 -
    (1 / 60) * x4 * y3 * z2 ^ 2 * z4 - (1 / 60) * x4 * y3 * z2 * z3 ^ 2 in
  let t_34 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_35 := (t_33 - (1 / 60) * x4 * y3 * z2 * z3 * z4 - (1 / 60) * x4 * y3 * z2 * z4 ^ 2) * (m /
    (t_34 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3
    * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2)) in
  t_34 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  t_3 + (m * (y1 + t_1) * (y1 + t_1) + m * (z1 + t_2) * (z1 + t_2)) = t_35.
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31
    t_32 t_33 t_34 t_35 D_1.
  rational.
Qed.

(* inertia, xy *)
Theorem tetrahedron_5 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (x2 - x1 + (x3 - x1) + (x4 - x1)) / 4 in
  let t_2 := (y2 - y1 + (y3 - y1) + (y4 - y1)) / 4 in
  let t_3 := (1 / 60) * x1 ^ 2 * y1 * y2 * z3 - (1 / 60) * x1 ^ 2 * y1 * y2 * z4 - (1 / 60) * x1 ^ 2
    * y1 * y3 * z2 + (1 / 60) * x1 ^ 2 * y1 * y3 * z4 + (1 / 60) * x1 ^ 2 * y1 * y4 * z2 - (1 / 60)
    * x1 ^ 2 * y1 * y4 * z3 + (1 / 120) * x1 ^ 2 * y2 ^ 2 * z3 - (1 / 120) * x1 ^ 2 * y2 ^ 2 * z4 -
    (1 / 120) * x1 ^ 2 * y2 * y3 * z2 + (1 / 120) * x1 ^ 2 * y2 * y3 * z3 in
  let t_4 := t_3 + (1 / 120) * x1 ^ 2 * y2 * y4 * z2 - (1 / 120) * x1 ^ 2 * y2 * y4 * z4 - (1 / 120)
    * x1 ^ 2 * y3 ^ 2 * z2 + (1 / 120) * x1 ^ 2 * y3 ^ 2 * z4 - (1 / 120) * x1 ^ 2 * y3 * y4 * z3 +
    (1 / 120) * x1 ^ 2 * y3 * y4 * z4 + (1 / 120) * x1 ^ 2 * y4 ^ 2 * z2 - (1 / 120) * x1 ^ 2 * y4 ^
    2 * z3 - (1 / 60) * x1 * x2 * y1 ^ 2 * z3 + (1 / 60) * x1 * x2 * y1 ^ 2 * z4 in
  let t_5 := t_4 + (1 / 60) * x1 * x2 * y1 * y3 * z1 - (1 / 120) * x1 * x2 * y1 * y3 * z2 - (1 /
    120) * x1 * x2 * y1 * y3 * z3 - (1 / 60) * x1 * x2 * y1 * y4 * z1 + (1 / 120) * x1 * x2 * y1 *
    y4 * z2 + (1 / 120) * x1 * x2 * y1 * y4 * z4 + (1 / 60) * x1 * x2 * y2 ^ 2 * z3 - (1 / 60) * x1
    * x2 * y2 ^ 2 * z4 + (1 / 120) * x1 * x2 * y2 * y3 * z1 in
  let t_6 := t_5 - (1 / 60) * x1 * x2 * y2 * y3 * z2 + (1 / 120) * x1 * x2 * y2 * y3 * z3 - (1 /
    120) * x1 * x2 * y2 * y4 * z1 + (1 / 60) * x1 * x2 * y2 * y4 * z2 - (1 / 120) * x1 * x2 * y2 *
    y4 * z4 + (1 / 120) * x1 * x2 * y3 ^ 2 * z1 - (1 / 120) * x1 * x2 * y3 ^ 2 * z2 - (1 / 120) * x1
    * x2 * y4 ^ 2 * z1 + (1 / 120) * x1 * x2 * y4 ^ 2 * z2 in
  let t_7 := t_6 + (1 / 60) * x1 * x3 * y1 ^ 2 * z2 - (1 / 60) * x1 * x3 * y1 ^ 2 * z4 - (1 / 60) *
    x1 * x3 * y1 * y2 * z1 + (1 / 120) * x1 * x3 * y1 * y2 * z2 + (1 / 120) * x1 * x3 * y1 * y2 * z3
    + (1 / 60) * x1 * x3 * y1 * y4 * z1 - (1 / 120) * x1 * x3 * y1 * y4 * z3 - (1 / 120) * x1 * x3 *
    y1 * y4 * z4 - (1 / 120) * x1 * x3 * y2 ^ 2 * z1 in
  let t_8 := t_7 + (1 / 120) * x1 * x3 * y2 ^ 2 * z3 - (1 / 120) * x1 * x3 * y2 * y3 * z1 - (1 /
    120) * x1 * x3 * y2 * y3 * z2 + (1 / 60) * x1 * x3 * y2 * y3 * z3 - (1 / 60) * x1 * x3 * y3 ^ 2
    * z2 + (1 / 60) * x1 * x3 * y3 ^ 2 * z4 + (1 / 120) * x1 * x3 * y3 * y4 * z1 - (1 / 60) * x1 *
    x3 * y3 * y4 * z3 + (1 / 120) * x1 * x3 * y3 * y4 * z4 in
  let t_9 := t_8 + (1 / 120) * x1 * x3 * y4 ^ 2 * z1 - (1 / 120) * x1 * x3 * y4 ^ 2 * z3 - (1 / 60)
    * x1 * x4 * y1 ^ 2 * z2 + (1 / 60) * x1 * x4 * y1 ^ 2 * z3 + (1 / 60) * x1 * x4 * y1 * y2 * z1 -
    (1 / 120) * x1 * x4 * y1 * y2 * z2 - (1 / 120) * x1 * x4 * y1 * y2 * z4 - (1 / 60) * x1 * x4 *
    y1 * y3 * z1 + (1 / 120) * x1 * x4 * y1 * y3 * z3 in
  let t_10 := t_9 + (1 / 120) * x1 * x4 * y1 * y3 * z4 + (1 / 120) * x1 * x4 * y2 ^ 2 * z1 - (1 /
    120) * x1 * x4 * y2 ^ 2 * z4 + (1 / 120) * x1 * x4 * y2 * y4 * z1 + (1 / 120) * x1 * x4 * y2 *
    y4 * z2 - (1 / 60) * x1 * x4 * y2 * y4 * z4 - (1 / 120) * x1 * x4 * y3 ^ 2 * z1 + (1 / 120) * x1
    * x4 * y3 ^ 2 * z4 - (1 / 120) * x1 * x4 * y3 * y4 * z1 in
  let t_11 := t_10 - (1 / 120) * x1 * x4 * y3 * y4 * z3 + (1 / 60) * x1 * x4 * y3 * y4 * z4 + (1 /
    60) * x1 * x4 * y4 ^ 2 * z2 - (1 / 60) * x1 * x4 * y4 ^ 2 * z3 - (1 / 120) * x2 ^ 2 * y1 ^ 2 *
    z3 + (1 / 120) * x2 ^ 2 * y1 ^ 2 * z4 - (1 / 60) * x2 ^ 2 * y1 * y2 * z3 + (1 / 60) * x2 ^ 2 *
    y1 * y2 * z4 + (1 / 120) * x2 ^ 2 * y1 * y3 * z1 in
  let t_12 := t_11 - (1 / 120) * x2 ^ 2 * y1 * y3 * z3 - (1 / 120) * x2 ^ 2 * y1 * y4 * z1 + (1 /
    120) * x2 ^ 2 * y1 * y4 * z4 + (1 / 60) * x2 ^ 2 * y2 * y3 * z1 - (1 / 60) * x2 ^ 2 * y2 * y3 *
    z4 - (1 / 60) * x2 ^ 2 * y2 * y4 * z1 + (1 / 60) * x2 ^ 2 * y2 * y4 * z3 + (1 / 120) * x2 ^ 2 *
    y3 ^ 2 * z1 - (1 / 120) * x2 ^ 2 * y3 ^ 2 * z4 + (1 / 120) * x2 ^ 2 * y3 * y4 * z3 in
  let t_13 := t_12 - (1 / 120) * x2 ^ 2 * y3 * y4 * z4 - (1 / 120) * x2 ^ 2 * y4 ^ 2 * z1 + (1 /
    120) * x2 ^ 2 * y4 ^ 2 * z3 + (1 / 120) * x2 * x3 * y1 ^ 2 * z2 - (1 / 120) * x2 * x3 * y1 ^ 2 *
    z3 - (1 / 120) * x2 * x3 * y1 * y2 * z1 + (1 / 60) * x2 * x3 * y1 * y2 * z2 - (1 / 120) * x2 *
    x3 * y1 * y2 * z3 + (1 / 120) * x2 * x3 * y1 * y3 * z1 in
  let t_14 := t_13 + (1 / 120) * x2 * x3 * y1 * y3 * z2 - (1 / 60) * x2 * x3 * y1 * y3 * z3 - (1 /
    60) * x2 * x3 * y2 ^ 2 * z1 + (1 / 60) * x2 * x3 * y2 ^ 2 * z4 - (1 / 60) * x2 * x3 * y2 * y4 *
    z2 + (1 / 120) * x2 * x3 * y2 * y4 * z3 + (1 / 120) * x2 * x3 * y2 * y4 * z4 + (1 / 60) * x2 *
    x3 * y3 ^ 2 * z1 - (1 / 60) * x2 * x3 * y3 ^ 2 * z4 in
  let t_15 := t_14 - (1 / 120) * x2 * x3 * y3 * y4 * z2 + (1 / 60) * x2 * x3 * y3 * y4 * z3 - (1 /
    120) * x2 * x3 * y3 * y4 * z4 - (1 / 120) * x2 * x3 * y4 ^ 2 * z2 + (1 / 120) * x2 * x3 * y4 ^ 2
    * z3 - (1 / 120) * x2 * x4 * y1 ^ 2 * z2 + (1 / 120) * x2 * x4 * y1 ^ 2 * z4 + (1 / 120) * x2 *
    x4 * y1 * y2 * z1 - (1 / 60) * x2 * x4 * y1 * y2 * z2 in
  let t_16 := t_15 + (1 / 120) * x2 * x4 * y1 * y2 * z4 - (1 / 120) * x2 * x4 * y1 * y4 * z1 - (1 /
    120) * x2 * x4 * y1 * y4 * z2 + (1 / 60) * x2 * x4 * y1 * y4 * z4 + (1 / 60) * x2 * x4 * y2 ^ 2
    * z1 - (1 / 60) * x2 * x4 * y2 ^ 2 * z3 + (1 / 60) * x2 * x4 * y2 * y3 * z2 - (1 / 120) * x2 *
    x4 * y2 * y3 * z3 - (1 / 120) * x2 * x4 * y2 * y3 * z4 in
  let t_17 := t_16 + (1 / 120) * x2 * x4 * y3 ^ 2 * z2 - (1 / 120) * x2 * x4 * y3 ^ 2 * z4 + (1 /
    120) * x2 * x4 * y3 * y4 * z2 + (1 / 120) * x2 * x4 * y3 * y4 * z3 - (1 / 60) * x2 * x4 * y3 *
    y4 * z4 - (1 / 60) * x2 * x4 * y4 ^ 2 * z1 + (1 / 60) * x2 * x4 * y4 ^ 2 * z3 + (1 / 120) * x3 ^
    2 * y1 ^ 2 * z2 - (1 / 120) * x3 ^ 2 * y1 ^ 2 * z4 in
  let t_18 := t_17 - (1 / 120) * x3 ^ 2 * y1 * y2 * z1 + (1 / 120) * x3 ^ 2 * y1 * y2 * z2 + (1 /
    60) * x3 ^ 2 * y1 * y3 * z2 - (1 / 60) * x3 ^ 2 * y1 * y3 * z4 + (1 / 120) * x3 ^ 2 * y1 * y4 *
    z1 - (1 / 120) * x3 ^ 2 * y1 * y4 * z4 - (1 / 120) * x3 ^ 2 * y2 ^ 2 * z1 + (1 / 120) * x3 ^ 2 *
    y2 ^ 2 * z4 - (1 / 60) * x3 ^ 2 * y2 * y3 * z1 + (1 / 60) * x3 ^ 2 * y2 * y3 * z4 in
  let t_19 := t_18 - (1 / 120) * x3 ^ 2 * y2 * y4 * z2 + (1 / 120) * x3 ^ 2 * y2 * y4 * z4 + (1 /
    60) * x3 ^ 2 * y3 * y4 * z1 - (1 / 60) * x3 ^ 2 * y3 * y4 * z2 + (1 / 120) * x3 ^ 2 * y4 ^ 2 *
    z1 - (1 / 120) * x3 ^ 2 * y4 ^ 2 * z2 + (1 / 120) * x3 * x4 * y1 ^ 2 * z3 - (1 / 120) * x3 * x4
    * y1 ^ 2 * z4 - (1 / 120) * x3 * x4 * y1 * y3 * z1 + (1 / 60) * x3 * x4 * y1 * y3 * z3 in
  let t_20 := t_19 - (1 / 120) * x3 * x4 * y1 * y3 * z4 + (1 / 120) * x3 * x4 * y1 * y4 * z1 + (1 /
    120) * x3 * x4 * y1 * y4 * z3 - (1 / 60) * x3 * x4 * y1 * y4 * z4 - (1 / 120) * x3 * x4 * y2 ^ 2
    * z3 + (1 / 120) * x3 * x4 * y2 ^ 2 * z4 + (1 / 120) * x3 * x4 * y2 * y3 * z2 - (1 / 60) * x3 *
    x4 * y2 * y3 * z3 + (1 / 120) * x3 * x4 * y2 * y3 * z4 in
  let t_21 := t_20 - (1 / 120) * x3 * x4 * y2 * y4 * z2 - (1 / 120) * x3 * x4 * y2 * y4 * z3 + (1 /
    60) * x3 * x4 * y2 * y4 * z4 - (1 / 60) * x3 * x4 * y3 ^ 2 * z1 + (1 / 60) * x3 * x4 * y3 ^ 2 *
    z2 + (1 / 60) * x3 * x4 * y4 ^ 2 * z1 - (1 / 60) * x3 * x4 * y4 ^ 2 * z2 - (1 / 120) * x4 ^ 2 *
    y1 ^ 2 * z2 + (1 / 120) * x4 ^ 2 * y1 ^ 2 * z3 in
  let t_22 := t_21 + (1 / 120) * x4 ^ 2 * y1 * y2 * z1 - (1 / 120) * x4 ^ 2 * y1 * y2 * z2 - (1 /
    120) * x4 ^ 2 * y1 * y3 * z1 + (1 / 120) * x4 ^ 2 * y1 * y3 * z3 - (1 / 60) * x4 ^ 2 * y1 * y4 *
    z2 + (1 / 60) * x4 ^ 2 * y1 * y4 * z3 + (1 / 120) * x4 ^ 2 * y2 ^ 2 * z1 - (1 / 120) * x4 ^ 2 *
    y2 ^ 2 * z3 + (1 / 120) * x4 ^ 2 * y2 * y3 * z2 - (1 / 120) * x4 ^ 2 * y2 * y3 * z3 in
  let t_23 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_24 := (t_22 + (1 / 60) * x4 ^ 2 * y2 * y4 * z1 - (1 / 60) * x4 ^ 2 * y2 * y4 * z3 - (1 /
    120) * x4 ^ 2 * y3 ^ 2 * z1 + (1 / 120) * x4 ^ 2 * y3 ^ 2 * z2 - (1 / 60) * x4 ^ 2 * y3 * y4 *
    z1 + (1 / 60) * x4 ^ 2 * y3 * y4 * z2) * (m / (t_23 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2
    * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 *
    y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) *
    x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2)) in
  t_23 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  - (m / 20 * t_1 * t_2) - m / 20 * (x2 - x1 - t_1) * (y2 - y1 - t_2) - m / 20 * (x3 - x1 - t_1) *
    (y3 - y1 - t_2) - m / 20 * (x4 - x1 - t_1) * (y4 - y1 - t_2) - m * (x1 + t_1) * (y1 + t_2) =
    t_24.
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1.
  rational.
Qed.

(* inertia, xz *)
Theorem tetrahedron_6 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (x2 - x1 + (x3 - x1) + (x4 - x1)) / 4 in
  let t_2 := (z2 - z1 + (z3 - z1) + (z4 - z1)) / 4 in
  let t_3 := (1 / 60) * x1 ^ 2 * y2 * z1 * z3 - (1 / 60) * x1 ^ 2 * y2 * z1 * z4 + (1 / 120) * x1 ^
    2 * y2 * z2 * z3 - (1 / 120) * x1 ^ 2 * y2 * z2 * z4 + (1 / 120) * x1 ^ 2 * y2 * z3 ^ 2 - (1 /
    120) * x1 ^ 2 * y2 * z4 ^ 2 - (1 / 60) * x1 ^ 2 * y3 * z1 * z2 + (1 / 60) * x1 ^ 2 * y3 * z1 *
    z4 - (1 / 120) * x1 ^ 2 * y3 * z2 ^ 2 - (1 / 120) * x1 ^ 2 * y3 * z2 * z3 in
  let t_4 := t_3 + (1 / 120) * x1 ^ 2 * y3 * z3 * z4 + (1 / 120) * x1 ^ 2 * y3 * z4 ^ 2 + (1 / 60) *
    x1 ^ 2 * y4 * z1 * z2 - (1 / 60) * x1 ^ 2 * y4 * z1 * z3 + (1 / 120) * x1 ^ 2 * y4 * z2 ^ 2 + (1
    / 120) * x1 ^ 2 * y4 * z2 * z4 - (1 / 120) * x1 ^ 2 * y4 * z3 ^ 2 - (1 / 120) * x1 ^ 2 * y4 * z3
    * z4 - (1 / 60) * x1 * x2 * y1 * z1 * z3 + (1 / 60) * x1 * x2 * y1 * z1 * z4 in
  let t_5 := t_4 - (1 / 120) * x1 * x2 * y1 * z2 * z3 + (1 / 120) * x1 * x2 * y1 * z2 * z4 - (1 /
    120) * x1 * x2 * y1 * z3 ^ 2 + (1 / 120) * x1 * x2 * y1 * z4 ^ 2 + (1 / 120) * x1 * x2 * y2 * z1
    * z3 - (1 / 120) * x1 * x2 * y2 * z1 * z4 + (1 / 60) * x1 * x2 * y2 * z2 * z3 - (1 / 60) * x1 *
    x2 * y2 * z2 * z4 + (1 / 120) * x1 * x2 * y2 * z3 ^ 2 in
  let t_6 := t_5 - (1 / 120) * x1 * x2 * y2 * z4 ^ 2 + (1 / 60) * x1 * x2 * y3 * z1 ^ 2 + (1 / 120)
    * x1 * x2 * y3 * z1 * z3 - (1 / 60) * x1 * x2 * y3 * z2 ^ 2 - (1 / 120) * x1 * x2 * y3 * z2 * z3
    - (1 / 60) * x1 * x2 * y4 * z1 ^ 2 - (1 / 120) * x1 * x2 * y4 * z1 * z4 + (1 / 60) * x1 * x2 *
    y4 * z2 ^ 2 + (1 / 120) * x1 * x2 * y4 * z2 * z4 in
  let t_7 := t_6 + (1 / 60) * x1 * x3 * y1 * z1 * z2 - (1 / 60) * x1 * x3 * y1 * z1 * z4 + (1 / 120)
    * x1 * x3 * y1 * z2 ^ 2 + (1 / 120) * x1 * x3 * y1 * z2 * z3 - (1 / 120) * x1 * x3 * y1 * z3 *
    z4 - (1 / 120) * x1 * x3 * y1 * z4 ^ 2 - (1 / 60) * x1 * x3 * y2 * z1 ^ 2 - (1 / 120) * x1 * x3
    * y2 * z1 * z2 + (1 / 120) * x1 * x3 * y2 * z2 * z3 in
  let t_8 := t_7 + (1 / 60) * x1 * x3 * y2 * z3 ^ 2 - (1 / 120) * x1 * x3 * y3 * z1 * z2 + (1 / 120)
    * x1 * x3 * y3 * z1 * z4 - (1 / 120) * x1 * x3 * y3 * z2 ^ 2 - (1 / 60) * x1 * x3 * y3 * z2 * z3
    + (1 / 60) * x1 * x3 * y3 * z3 * z4 + (1 / 120) * x1 * x3 * y3 * z4 ^ 2 + (1 / 60) * x1 * x3 *
    y4 * z1 ^ 2 + (1 / 120) * x1 * x3 * y4 * z1 * z4 in
  let t_9 := t_8 - (1 / 60) * x1 * x3 * y4 * z3 ^ 2 - (1 / 120) * x1 * x3 * y4 * z3 * z4 - (1 / 60)
    * x1 * x4 * y1 * z1 * z2 + (1 / 60) * x1 * x4 * y1 * z1 * z3 - (1 / 120) * x1 * x4 * y1 * z2 ^ 2
    - (1 / 120) * x1 * x4 * y1 * z2 * z4 + (1 / 120) * x1 * x4 * y1 * z3 ^ 2 + (1 / 120) * x1 * x4 *
    y1 * z3 * z4 + (1 / 60) * x1 * x4 * y2 * z1 ^ 2 in
  let t_10 := t_9 + (1 / 120) * x1 * x4 * y2 * z1 * z2 - (1 / 120) * x1 * x4 * y2 * z2 * z4 - (1 /
    60) * x1 * x4 * y2 * z4 ^ 2 - (1 / 60) * x1 * x4 * y3 * z1 ^ 2 - (1 / 120) * x1 * x4 * y3 * z1 *
    z3 + (1 / 120) * x1 * x4 * y3 * z3 * z4 + (1 / 60) * x1 * x4 * y3 * z4 ^ 2 + (1 / 120) * x1 * x4
    * y4 * z1 * z2 - (1 / 120) * x1 * x4 * y4 * z1 * z3 in
  let t_11 := t_10 + (1 / 120) * x1 * x4 * y4 * z2 ^ 2 + (1 / 60) * x1 * x4 * y4 * z2 * z4 - (1 /
    120) * x1 * x4 * y4 * z3 ^ 2 - (1 / 60) * x1 * x4 * y4 * z3 * z4 - (1 / 120) * x2 ^ 2 * y1 * z1
    * z3 + (1 / 120) * x2 ^ 2 * y1 * z1 * z4 - (1 / 60) * x2 ^ 2 * y1 * z2 * z3 + (1 / 60) * x2 ^ 2
    * y1 * z2 * z4 - (1 / 120) * x2 ^ 2 * y1 * z3 ^ 2 in
  let t_12 := t_11 + (1 / 120) * x2 ^ 2 * y1 * z4 ^ 2 + (1 / 120) * x2 ^ 2 * y3 * z1 ^ 2 + (1 / 60)
    * x2 ^ 2 * y3 * z1 * z2 + (1 / 120) * x2 ^ 2 * y3 * z1 * z3 - (1 / 60) * x2 ^ 2 * y3 * z2 * z4 -
    (1 / 120) * x2 ^ 2 * y3 * z3 * z4 - (1 / 120) * x2 ^ 2 * y3 * z4 ^ 2 - (1 / 120) * x2 ^ 2 * y4 *
    z1 ^ 2 - (1 / 60) * x2 ^ 2 * y4 * z1 * z2 - (1 / 120) * x2 ^ 2 * y4 * z1 * z4 in
  let t_13 := t_12 + (1 / 60) * x2 ^ 2 * y4 * z2 * z3 + (1 / 120) * x2 ^ 2 * y4 * z3 ^ 2 + (1 / 120)
    * x2 ^ 2 * y4 * z3 * z4 + (1 / 120) * x2 * x3 * y1 * z1 * z2 - (1 / 120) * x2 * x3 * y1 * z1 *
    z3 + (1 / 60) * x2 * x3 * y1 * z2 ^ 2 - (1 / 60) * x2 * x3 * y1 * z3 ^ 2 - (1 / 120) * x2 * x3 *
    y2 * z1 ^ 2 - (1 / 60) * x2 * x3 * y2 * z1 * z2 in
  let t_14 := t_13 - (1 / 120) * x2 * x3 * y2 * z1 * z3 + (1 / 60) * x2 * x3 * y2 * z2 * z4 + (1 /
    120) * x2 * x3 * y2 * z3 * z4 + (1 / 120) * x2 * x3 * y2 * z4 ^ 2 + (1 / 120) * x2 * x3 * y3 *
    z1 ^ 2 + (1 / 120) * x2 * x3 * y3 * z1 * z2 + (1 / 60) * x2 * x3 * y3 * z1 * z3 - (1 / 120) * x2
    * x3 * y3 * z2 * z4 - (1 / 60) * x2 * x3 * y3 * z3 * z4 in
  let t_15 := t_14 - (1 / 120) * x2 * x3 * y3 * z4 ^ 2 - (1 / 60) * x2 * x3 * y4 * z2 ^ 2 - (1 /
    120) * x2 * x3 * y4 * z2 * z4 + (1 / 60) * x2 * x3 * y4 * z3 ^ 2 + (1 / 120) * x2 * x3 * y4 * z3
    * z4 - (1 / 120) * x2 * x4 * y1 * z1 * z2 + (1 / 120) * x2 * x4 * y1 * z1 * z4 - (1 / 60) * x2 *
    x4 * y1 * z2 ^ 2 + (1 / 60) * x2 * x4 * y1 * z4 ^ 2 in
  let t_16 := t_15 + (1 / 120) * x2 * x4 * y2 * z1 ^ 2 + (1 / 60) * x2 * x4 * y2 * z1 * z2 + (1 /
    120) * x2 * x4 * y2 * z1 * z4 - (1 / 60) * x2 * x4 * y2 * z2 * z3 - (1 / 120) * x2 * x4 * y2 *
    z3 ^ 2 - (1 / 120) * x2 * x4 * y2 * z3 * z4 + (1 / 60) * x2 * x4 * y3 * z2 ^ 2 + (1 / 120) * x2
    * x4 * y3 * z2 * z3 - (1 / 120) * x2 * x4 * y3 * z3 * z4 in
  let t_17 := t_16 - (1 / 60) * x2 * x4 * y3 * z4 ^ 2 - (1 / 120) * x2 * x4 * y4 * z1 ^ 2 - (1 /
    120) * x2 * x4 * y4 * z1 * z2 - (1 / 60) * x2 * x4 * y4 * z1 * z4 + (1 / 120) * x2 * x4 * y4 *
    z2 * z3 + (1 / 120) * x2 * x4 * y4 * z3 ^ 2 + (1 / 60) * x2 * x4 * y4 * z3 * z4 + (1 / 120) * x3
    ^ 2 * y1 * z1 * z2 - (1 / 120) * x3 ^ 2 * y1 * z1 * z4 in
  let t_18 := t_17 + (1 / 120) * x3 ^ 2 * y1 * z2 ^ 2 + (1 / 60) * x3 ^ 2 * y1 * z2 * z3 - (1 / 60)
    * x3 ^ 2 * y1 * z3 * z4 - (1 / 120) * x3 ^ 2 * y1 * z4 ^ 2 - (1 / 120) * x3 ^ 2 * y2 * z1 ^ 2 -
    (1 / 120) * x3 ^ 2 * y2 * z1 * z2 - (1 / 60) * x3 ^ 2 * y2 * z1 * z3 + (1 / 120) * x3 ^ 2 * y2 *
    z2 * z4 + (1 / 60) * x3 ^ 2 * y2 * z3 * z4 + (1 / 120) * x3 ^ 2 * y2 * z4 ^ 2 in
  let t_19 := t_18 + (1 / 120) * x3 ^ 2 * y4 * z1 ^ 2 + (1 / 60) * x3 ^ 2 * y4 * z1 * z3 + (1 / 120)
    * x3 ^ 2 * y4 * z1 * z4 - (1 / 120) * x3 ^ 2 * y4 * z2 ^ 2 - (1 / 60) * x3 ^ 2 * y4 * z2 * z3 -
    (1 / 120) * x3 ^ 2 * y4 * z2 * z4 + (1 / 120) * x3 * x4 * y1 * z1 * z3 - (1 / 120) * x3 * x4 *
    y1 * z1 * z4 + (1 / 60) * x3 * x4 * y1 * z3 ^ 2 in
  let t_20 := t_19 - (1 / 60) * x3 * x4 * y1 * z4 ^ 2 - (1 / 120) * x3 * x4 * y2 * z2 * z3 + (1 /
    120) * x3 * x4 * y2 * z2 * z4 - (1 / 60) * x3 * x4 * y2 * z3 ^ 2 + (1 / 60) * x3 * x4 * y2 * z4
    ^ 2 - (1 / 120) * x3 * x4 * y3 * z1 ^ 2 - (1 / 60) * x3 * x4 * y3 * z1 * z3 - (1 / 120) * x3 *
    x4 * y3 * z1 * z4 + (1 / 120) * x3 * x4 * y3 * z2 ^ 2 in
  let t_21 := t_20 + (1 / 60) * x3 * x4 * y3 * z2 * z3 + (1 / 120) * x3 * x4 * y3 * z2 * z4 + (1 /
    120) * x3 * x4 * y4 * z1 ^ 2 + (1 / 120) * x3 * x4 * y4 * z1 * z3 + (1 / 60) * x3 * x4 * y4 * z1
    * z4 - (1 / 120) * x3 * x4 * y4 * z2 ^ 2 - (1 / 120) * x3 * x4 * y4 * z2 * z3 - (1 / 60) * x3 *
    x4 * y4 * z2 * z4 - (1 / 120) * x4 ^ 2 * y1 * z1 * z2 in
  let t_22 := t_21 + (1 / 120) * x4 ^ 2 * y1 * z1 * z3 - (1 / 120) * x4 ^ 2 * y1 * z2 ^ 2 - (1 / 60)
    * x4 ^ 2 * y1 * z2 * z4 + (1 / 120) * x4 ^ 2 * y1 * z3 ^ 2 + (1 / 60) * x4 ^ 2 * y1 * z3 * z4 +
    (1 / 120) * x4 ^ 2 * y2 * z1 ^ 2 + (1 / 120) * x4 ^ 2 * y2 * z1 * z2 + (1 / 60) * x4 ^ 2 * y2 *
    z1 * z4 - (1 / 120) * x4 ^ 2 * y2 * z2 * z3 - (1 / 120) * x4 ^ 2 * y2 * z3 ^ 2 in
  let t_23 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_24 := (t_22 - (1 / 60) * x4 ^ 2 * y2 * z3 * z4 - (1 / 120) * x4 ^ 2 * y3 * z1 ^ 2 - (1 /
    120) * x4 ^ 2 * y3 * z1 * z3 - (1 / 60) * x4 ^ 2 * y3 * z1 * z4 + (1 / 120) * x4 ^ 2 * y3 * z2 ^
    2 + (1 / 120) * x4 ^ 2 * y3 * z2 * z3 + (1 / 60) * x4 ^ 2 * y3 * z2 * z4) * (m / (t_23 + (1 / 6)
    * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4 * z1 + (1 /
    6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 * y2 * z1 +
    (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2)) in
  t_23 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  - (m / 20 * t_1 * t_2) - m / 20 * (x2 - x1 - t_1) * (z2 - z1 - t_2) - m / 20 * (x3 - x1 - t_1) *
    (z3 - z1 - t_2) - m / 20 * (x4 - x1 - t_1) * (z4 - z1 - t_2) - m * (x1 + t_1) * (z1 + t_2) =
    t_24.
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1.
  rational.
Qed.

(* inertia, yx *)
Theorem tetrahedron_7 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (x2 - x1 + (x3 - x1) + (x4 - x1)) / 4 in
  let t_2 := (y2 - y1 + (y3 - y1) + (y4 - y1)) / 4 in
  let t_3 := (1 / 60) * x1 ^ 2 * y1 * y2 * z3 - (1 / 60) * x1 ^ 2 * y1 * y2 * z4 - (1 / 60) * x1 ^ 2
    * y1 * y3 * z2 + (1 / 60) * x1 ^ 2 * y1 * y3 * z4 + (1 / 60) * x1 ^ 2 * y1 * y4 * z2 - (1 / 60)
    * x1 ^ 2 * y1 * y4 * z3 + (1 / 120) * x1 ^ 2 * y2 ^ 2 * z3 - (1 / 120) * x1 ^ 2 * y2 ^ 2 * z4 -
    (1 / 120) * x1 ^ 2 * y2 * y3 * z2 + (1 / 120) * x1 ^ 2 * y2 * y3 * z3 in
  let t_4 := t_3 + (1 / 120) * x1 ^ 2 * y2 * y4 * z2 - (1 / 120) * x1 ^ 2 * y2 * y4 * z4 - (1 / 120)
    * x1 ^ 2 * y3 ^ 2 * z2 + (1 / 120) * x1 ^ 2 * y3 ^ 2 * z4 - (1 / 120) * x1 ^ 2 * y3 * y4 * z3 +
    (1 / 120) * x1 ^ 2 * y3 * y4 * z4 + (1 / 120) * x1 ^ 2 * y4 ^ 2 * z2 - (1 / 120) * x1 ^ 2 * y4 ^
    2 * z3 - (1 / 60) * x1 * x2 * y1 ^ 2 * z3 + (1 / 60) * x1 * x2 * y1 ^ 2 * z4 in
  let t_5 := t_4 + (1 / 60) * x1 * x2 * y1 * y3 * z1 - (1 / 120) * x1 * x2 * y1 * y3 * z2 - (1 /
    120) * x1 * x2 * y1 * y3 * z3 - (1 / 60) * x1 * x2 * y1 * y4 * z1 + (1 / 120) * x1 * x2 * y1 *
    y4 * z2 + (1 / 120) * x1 * x2 * y1 * y4 * z4 + (1 / 60) * x1 * x2 * y2 ^ 2 * z3 - (1 / 60) * x1
    * x2 * y2 ^ 2 * z4 + (1 / 120) * x1 * x2 * y2 * y3 * z1 in
  let t_6 := t_5 - (1 / 60) * x1 * x2 * y2 * y3 * z2 + (1 / 120) * x1 * x2 * y2 * y3 * z3 - (1 /
    120) * x1 * x2 * y2 * y4 * z1 + (1 / 60) * x1 * x2 * y2 * y4 * z2 - (1 / 120) * x1 * x2 * y2 *
    y4 * z4 + (1 / 120) * x1 * x2 * y3 ^ 2 * z1 - (1 / 120) * x1 * x2 * y3 ^ 2 * z2 - (1 / 120) * x1
    * x2 * y4 ^ 2 * z1 + (1 / 120) * x1 * x2 * y4 ^ 2 * z2 in
  let t_7 := t_6 + (1 / 60) * x1 * x3 * y1 ^ 2 * z2 - (1 / 60) * x1 * x3 * y1 ^ 2 * z4 - (1 / 60) *
    x1 * x3 * y1 * y2 * z1 + (1 / 120) * x1 * x3 * y1 * y2 * z2 + (1 / 120) * x1 * x3 * y1 * y2 * z3
    + (1 / 60) * x1 * x3 * y1 * y4 * z1 - (1 / 120) * x1 * x3 * y1 * y4 * z3 - (1 / 120) * x1 * x3 *
    y1 * y4 * z4 - (1 / 120) * x1 * x3 * y2 ^ 2 * z1 in
  let t_8 := t_7 + (1 / 120) * x1 * x3 * y2 ^ 2 * z3 - (1 / 120) * x1 * x3 * y2 * y3 * z1 - (1 /
    120) * x1 * x3 * y2 * y3 * z2 + (1 / 60) * x1 * x3 * y2 * y3 * z3 - (1 / 60) * x1 * x3 * y3 ^ 2
    * z2 + (1 / 60) * x1 * x3 * y3 ^ 2 * z4 + (1 / 120) * x1 * x3 * y3 * y4 * z1 - (1 / 60) * x1 *
    x3 * y3 * y4 * z3 + (1 / 120) * x1 * x3 * y3 * y4 * z4 in
  let t_9 := t_8 + (1 / 120) * x1 * x3 * y4 ^ 2 * z1 - (1 / 120) * x1 * x3 * y4 ^ 2 * z3 - (1 / 60)
    * x1 * x4 * y1 ^ 2 * z2 + (1 / 60) * x1 * x4 * y1 ^ 2 * z3 + (1 / 60) * x1 * x4 * y1 * y2 * z1 -
    (1 / 120) * x1 * x4 * y1 * y2 * z2 - (1 / 120) * x1 * x4 * y1 * y2 * z4 - (1 / 60) * x1 * x4 *
    y1 * y3 * z1 + (1 / 120) * x1 * x4 * y1 * y3 * z3 in
  let t_10 := t_9 + (1 / 120) * x1 * x4 * y1 * y3 * z4 + (1 / 120) * x1 * x4 * y2 ^ 2 * z1 - (1 /
    120) * x1 * x4 * y2 ^ 2 * z4 + (1 / 120) * x1 * x4 * y2 * y4 * z1 + (1 / 120) * x1 * x4 * y2 *
    y4 * z2 - (1 / 60) * x1 * x4 * y2 * y4 * z4 - (1 / 120) * x1 * x4 * y3 ^ 2 * z1 + (1 / 120) * x1
    * x4 * y3 ^ 2 * z4 - (1 / 120) * x1 * x4 * y3 * y4 * z1 in
  let t_11 := t_10 - (1 / 120) * x1 * x4 * y3 * y4 * z3 + (1 / 60) * x1 * x4 * y3 * y4 * z4 + (1 /
    60) * x1 * x4 * y4 ^ 2 * z2 - (1 / 60) * x1 * x4 * y4 ^ 2 * z3 - (1 / 120) * x2 ^ 2 * y1 ^ 2 *
    z3 + (1 / 120) * x2 ^ 2 * y1 ^ 2 * z4 - (1 / 60) * x2 ^ 2 * y1 * y2 * z3 + (1 / 60) * x2 ^ 2 *
    y1 * y2 * z4 + (1 / 120) * x2 ^ 2 * y1 * y3 * z1 in
  let t_12 := t_11 - (1 / 120) * x2 ^ 2 * y1 * y3 * z3 - (1 / 120) * x2 ^ 2 * y1 * y4 * z1 + (1 /
    120) * x2 ^ 2 * y1 * y4 * z4 + (1 / 60) * x2 ^ 2 * y2 * y3 * z1 - (1 / 60) * x2 ^ 2 * y2 * y3 *
    z4 - (1 / 60) * x2 ^ 2 * y2 * y4 * z1 + (1 / 60) * x2 ^ 2 * y2 * y4 * z3 + (1 / 120) * x2 ^ 2 *
    y3 ^ 2 * z1 - (1 / 120) * x2 ^ 2 * y3 ^ 2 * z4 + (1 / 120) * x2 ^ 2 * y3 * y4 * z3 in
  let t_13 := t_12 - (1 / 120) * x2 ^ 2 * y3 * y4 * z4 - (1 / 120) * x2 ^ 2 * y4 ^ 2 * z1 + (1 /
    120) * x2 ^ 2 * y4 ^ 2 * z3 + (1 / 120) * x2 * x3 * y1 ^ 2 * z2 - (1 / 120) * x2 * x3 * y1 ^ 2 *
    z3 - (1 / 120) * x2 * x3 * y1 * y2 * z1 + (1 / 60) * x2 * x3 * y1 * y2 * z2 - (1 / 120) * x2 *
    x3 * y1 * y2 * z3 + (1 / 120) * x2 * x3 * y1 * y3 * z1 in
  let t_14 := t_13 + (1 / 120) * x2 * x3 * y1 * y3 * z2 - (1 / 60) * x2 * x3 * y1 * y3 * z3 - (1 /
    60) * x2 * x3 * y2 ^ 2 * z1 + (1 / 60) * x2 * x3 * y2 ^ 2 * z4 - (1 / 60) * x2 * x3 * y2 * y4 *
    z2 + (1 / 120) * x2 * x3 * y2 * y4 * z3 + (1 / 120) * x2 * x3 * y2 * y4 * z4 + (1 / 60) * x2 *
    x3 * y3 ^ 2 * z1 - (1 / 60) * x2 * x3 * y3 ^ 2 * z4 in
  let t_15 := t_14 - (1 / 120) * x2 * x3 * y3 * y4 * z2 + (1 / 60) * x2 * x3 * y3 * y4 * z3 - (1 /
    120) * x2 * x3 * y3 * y4 * z4 - (1 / 120) * x2 * x3 * y4 ^ 2 * z2 + (1 / 120) * x2 * x3 * y4 ^ 2
    * z3 - (1 / 120) * x2 * x4 * y1 ^ 2 * z2 + (1 / 120) * x2 * x4 * y1 ^ 2 * z4 + (1 / 120) * x2 *
    x4 * y1 * y2 * z1 - (1 / 60) * x2 * x4 * y1 * y2 * z2 in
  let t_16 := t_15 + (1 / 120) * x2 * x4 * y1 * y2 * z4 - (1 / 120) * x2 * x4 * y1 * y4 * z1 - (1 /
    120) * x2 * x4 * y1 * y4 * z2 + (1 / 60) * x2 * x4 * y1 * y4 * z4 + (1 / 60) * x2 * x4 * y2 ^ 2
    * z1 - (1 / 60) * x2 * x4 * y2 ^ 2 * z3 + (1 / 60) * x2 * x4 * y2 * y3 * z2 - (1 / 120) * x2 *
    x4 * y2 * y3 * z3 - (1 / 120) * x2 * x4 * y2 * y3 * z4 in
  let t_17 := t_16 + (1 / 120) * x2 * x4 * y3 ^ 2 * z2 - (1 / 120) * x2 * x4 * y3 ^ 2 * z4 + (1 /
    120) * x2 * x4 * y3 * y4 * z2 + (1 / 120) * x2 * x4 * y3 * y4 * z3 - (1 / 60) * x2 * x4 * y3 *
    y4 * z4 - (1 / 60) * x2 * x4 * y4 ^ 2 * z1 + (1 / 60) * x2 * x4 * y4 ^ 2 * z3 + (1 / 120) * x3 ^
    2 * y1 ^ 2 * z2 - (1 / 120) * x3 ^ 2 * y1 ^ 2 * z4 in
  let t_18 := t_17 - (1 / 120) * x3 ^ 2 * y1 * y2 * z1 + (1 / 120) * x3 ^ 2 * y1 * y2 * z2 + (1 /
    60) * x3 ^ 2 * y1 * y3 * z2 - (1 / 60) * x3 ^ 2 * y1 * y3 * z4 + (1 / 120) * x3 ^ 2 * y1 * y4 *
    z1 - (1 / 120) * x3 ^ 2 * y1 * y4 * z4 - (1 / 120) * x3 ^ 2 * y2 ^ 2 * z1 + (1 / 120) * x3 ^ 2 *
    y2 ^ 2 * z4 - (1 / 60) * x3 ^ 2 * y2 * y3 * z1 + (1 / 60) * x3 ^ 2 * y2 * y3 * z4 in
  let t_19 := t_18 - (1 / 120) * x3 ^ 2 * y2 * y4 * z2 + (1 / 120) * x3 ^ 2 * y2 * y4 * z4 + (1 /
    60) * x3 ^ 2 * y3 * y4 * z1 - (1 / 60) * x3 ^ 2 * y3 * y4 * z2 + (1 / 120) * x3 ^ 2 * y4 ^ 2 *
    z1 - (1 / 120) * x3 ^ 2 * y4 ^ 2 * z2 + (1 / 120) * x3 * x4 * y1 ^ 2 * z3 - (1 / 120) * x3 * x4
    * y1 ^ 2 * z4 - (1 / 120) * x3 * x4 * y1 * y3 * z1 + (1 / 60) * x3 * x4 * y1 * y3 * z3 in
  let t_20 := t_19 - (1 / 120) * x3 * x4 * y1 * y3 * z4 + (1 / 120) * x3 * x4 * y1 * y4 * z1 + (1 /
    120) * x3 * x4 * y1 * y4 * z3 - (1 / 60) * x3 * x4 * y1 * y4 * z4 - (1 / 120) * x3 * x4 * y2 ^ 2
    * z3 + (1 / 120) * x3 * x4 * y2 ^ 2 * z4 + (1 / 120) * x3 * x4 * y2 * y3 * z2 - (1 / 60) * x3 *
    x4 * y2 * y3 * z3 + (1 / 120) * x3 * x4 * y2 * y3 * z4 in
  let t_21 := t_20 - (1 / 120) * x3 * x4 * y2 * y4 * z2 - (1 / 120) * x3 * x4 * y2 * y4 * z3 + (1 /
    60) * x3 * x4 * y2 * y4 * z4 - (1 / 60) * x3 * x4 * y3 ^ 2 * z1 + (1 / 60) * x3 * x4 * y3 ^ 2 *
    z2 + (1 / 60) * x3 * x4 * y4 ^ 2 * z1 - (1 / 60) * x3 * x4 * y4 ^ 2 * z2 - (1 / 120) * x4 ^ 2 *
    y1 ^ 2 * z2 + (1 / 120) * x4 ^ 2 * y1 ^ 2 * z3 in
  let t_22 := t_21 + (1 / 120) * x4 ^ 2 * y1 * y2 * z1 - (1 / 120) * x4 ^ 2 * y1 * y2 * z2 - (1 /
    120) * x4 ^ 2 * y1 * y3 * z1 + (1 / 120) * x4 ^ 2 * y1 * y3 * z3 - (1 / 60) * x4 ^ 2 * y1 * y4 *
    z2 + (1 / 60) * x4 ^ 2 * y1 * y4 * z3 + (1 / 120) * x4 ^ 2 * y2 ^ 2 * z1 - (1 / 120) * x4 ^ 2 *
    y2 ^ 2 * z3 + (1 / 120) * x4 ^ 2 * y2 * y3 * z2 - (1 / 120) * x4 ^ 2 * y2 * y3 * z3 in
  let t_23 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_24 := (t_22 + (1 / 60) * x4 ^ 2 * y2 * y4 * z1 - (1 / 60) * x4 ^ 2 * y2 * y4 * z3 - (1 /
    120) * x4 ^ 2 * y3 ^ 2 * z1 + (1 / 120) * x4 ^ 2 * y3 ^ 2 * z2 - (1 / 60) * x4 ^ 2 * y3 * y4 *
    z1 + (1 / 60) * x4 ^ 2 * y3 * y4 * z2) * (m / (t_23 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2
    * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 *
    y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) *
    x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2)) in
  t_23 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  - (m / 20 * t_1 * t_2) - m / 20 * (x2 - x1 - t_1) * (y2 - y1 - t_2) - m / 20 * (x3 - x1 - t_1) *
    (y3 - y1 - t_2) - m / 20 * (x4 - x1 - t_1) * (y4 - y1 - t_2) - m * (x1 + t_1) * (y1 + t_2) =
    t_24.
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1.
  rational.
Qed.

(* inertia, yy *)
Theorem tetrahedron_8 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (z2 - z1 + (z3 - z1) + (z4 - z1)) / 4 in
  let t_2 := (x2 - x1 + (x3 - x1) + (x4 - x1)) / 4 in
  let t_3 := m / 20 * t_1 * t_1 + m / 20 * t_2 * t_2 + (m / 20 * (z2 - z1 - t_1) * (z2 - z1 - t_1) +
    m / 20 * (x2 - x1 - t_2) * (x2 - x1 - t_2)) + (m / 20 * (z3 - z1 - t_1) * (z3 - z1 - t_1) + m /
    20 * (x3 - x1 - t_2) * (x3 - x1 - t_2)) + (m / 20 * (z4 - z1 - t_1) * (z4 - z1 - t_1) + m / 20 *
    (x4 - x1 - t_2) * (x4 - x1 - t_2)) in
  let t_4 := - ((1 / 60) * x1 ^ 3 * y2 * z3) + (1 / 60) * x1 ^ 3 * y2 * z4 + (1 / 60) * x1 ^ 3 * y3
    * z2 - (1 / 60) * x1 ^ 3 * y3 * z4 - (1 / 60) * x1 ^ 3 * y4 * z2 + (1 / 60) * x1 ^ 3 * y4 * z3 +
    (1 / 60) * x1 ^ 2 * x2 * y1 * z3 - (1 / 60) * x1 ^ 2 * x2 * y1 * z4 - (1 / 60) * x1 ^ 2 * x2 *
    y2 * z3 + (1 / 60) * x1 ^ 2 * x2 * y2 * z4 - (1 / 60) * x1 ^ 2 * x2 * y3 * z1 in
  let t_5 := t_4 + (1 / 60) * x1 ^ 2 * x2 * y3 * z2 + (1 / 60) * x1 ^ 2 * x2 * y4 * z1 - (1 / 60) *
    x1 ^ 2 * x2 * y4 * z2 - (1 / 60) * x1 ^ 2 * x3 * y1 * z2 + (1 / 60) * x1 ^ 2 * x3 * y1 * z4 + (1
    / 60) * x1 ^ 2 * x3 * y2 * z1 - (1 / 60) * x1 ^ 2 * x3 * y2 * z3 + (1 / 60) * x1 ^ 2 * x3 * y3 *
    z2 - (1 / 60) * x1 ^ 2 * x3 * y3 * z4 in
  let t_6 := t_5 - (1 / 60) * x1 ^ 2 * x3 * y4 * z1 + (1 / 60) * x1 ^ 2 * x3 * y4 * z3 + (1 / 60) *
    x1 ^ 2 * x4 * y1 * z2 - (1 / 60) * x1 ^ 2 * x4 * y1 * z3 - (1 / 60) * x1 ^ 2 * x4 * y2 * z1 + (1
    / 60) * x1 ^ 2 * x4 * y2 * z4 + (1 / 60) * x1 ^ 2 * x4 * y3 * z1 - (1 / 60) * x1 ^ 2 * x4 * y3 *
    z4 - (1 / 60) * x1 ^ 2 * x4 * y4 * z2 in
  let t_7 := t_6 + (1 / 60) * x1 ^ 2 * x4 * y4 * z3 + (1 / 60) * x1 * x2 ^ 2 * y1 * z3 - (1 / 60) *
    x1 * x2 ^ 2 * y1 * z4 - (1 / 60) * x1 * x2 ^ 2 * y2 * z3 + (1 / 60) * x1 * x2 ^ 2 * y2 * z4 - (1
    / 60) * x1 * x2 ^ 2 * y3 * z1 + (1 / 60) * x1 * x2 ^ 2 * y3 * z2 + (1 / 60) * x1 * x2 ^ 2 * y4 *
    z1 - (1 / 60) * x1 * x2 ^ 2 * y4 * z2 in
  let t_8 := t_7 - (1 / 60) * x1 * x2 * x3 * y1 * z2 + (1 / 60) * x1 * x2 * x3 * y1 * z3 + (1 / 60)
    * x1 * x2 * x3 * y2 * z1 - (1 / 60) * x1 * x2 * x3 * y2 * z3 - (1 / 60) * x1 * x2 * x3 * y3 * z1
    + (1 / 60) * x1 * x2 * x3 * y3 * z2 + (1 / 60) * x1 * x2 * x4 * y1 * z2 - (1 / 60) * x1 * x2 *
    x4 * y1 * z4 - (1 / 60) * x1 * x2 * x4 * y2 * z1 in
  let t_9 := t_8 + (1 / 60) * x1 * x2 * x4 * y2 * z4 + (1 / 60) * x1 * x2 * x4 * y4 * z1 - (1 / 60)
    * x1 * x2 * x4 * y4 * z2 - (1 / 60) * x1 * x3 ^ 2 * y1 * z2 + (1 / 60) * x1 * x3 ^ 2 * y1 * z4 +
    (1 / 60) * x1 * x3 ^ 2 * y2 * z1 - (1 / 60) * x1 * x3 ^ 2 * y2 * z3 + (1 / 60) * x1 * x3 ^ 2 *
    y3 * z2 - (1 / 60) * x1 * x3 ^ 2 * y3 * z4 in
  let t_10 := t_9 - (1 / 60) * x1 * x3 ^ 2 * y4 * z1 + (1 / 60) * x1 * x3 ^ 2 * y4 * z3 - (1 / 60) *
    x1 * x3 * x4 * y1 * z3 + (1 / 60) * x1 * x3 * x4 * y1 * z4 + (1 / 60) * x1 * x3 * x4 * y3 * z1 -
    (1 / 60) * x1 * x3 * x4 * y3 * z4 - (1 / 60) * x1 * x3 * x4 * y4 * z1 + (1 / 60) * x1 * x3 * x4
    * y4 * z3 + (1 / 60) * x1 * x4 ^ 2 * y1 * z2 in
  let t_11 := t_10 - (1 / 60) * x1 * x4 ^ 2 * y1 * z3 - (1 / 60) * x1 * x4 ^ 2 * y2 * z1 + (1 / 60)
    * x1 * x4 ^ 2 * y2 * z4 + (1 / 60) * x1 * x4 ^ 2 * y3 * z1 - (1 / 60) * x1 * x4 ^ 2 * y3 * z4 -
    (1 / 60) * x1 * x4 ^ 2 * y4 * z2 + (1 / 60) * x1 * x4 ^ 2 * y4 * z3 - (1 / 60) * x1 * y2 * z1 ^
    2 * z3 + (1 / 60) * x1 * y2 * z1 ^ 2 * z4 in
  let t_12 := t_11 - (1 / 60) * x1 * y2 * z1 * z2 * z3 + (1 / 60) * x1 * y2 * z1 * z2 * z4 - (1 /
    60) * x1 * y2 * z1 * z3 ^ 2 + (1 / 60) * x1 * y2 * z1 * z4 ^ 2 - (1 / 60) * x1 * y2 * z2 ^ 2 *
    z3 + (1 / 60) * x1 * y2 * z2 ^ 2 * z4 - (1 / 60) * x1 * y2 * z2 * z3 ^ 2 + (1 / 60) * x1 * y2 *
    z2 * z4 ^ 2 - (1 / 60) * x1 * y2 * z3 ^ 3 in
  let t_13 := t_12 + (1 / 60) * x1 * y2 * z4 ^ 3 + (1 / 60) * x1 * y3 * z1 ^ 2 * z2 - (1 / 60) * x1
    * y3 * z1 ^ 2 * z4 + (1 / 60) * x1 * y3 * z1 * z2 ^ 2 + (1 / 60) * x1 * y3 * z1 * z2 * z3 - (1 /
    60) * x1 * y3 * z1 * z3 * z4 - (1 / 60) * x1 * y3 * z1 * z4 ^ 2 + (1 / 60) * x1 * y3 * z2 ^ 3 +
    (1 / 60) * x1 * y3 * z2 ^ 2 * z3 + (1 / 60) * x1 * y3 * z2 * z3 ^ 2 in
  let t_14 := t_13 - (1 / 60) * x1 * y3 * z3 ^ 2 * z4 - (1 / 60) * x1 * y3 * z3 * z4 ^ 2 - (1 / 60)
    * x1 * y3 * z4 ^ 3 - (1 / 60) * x1 * y4 * z1 ^ 2 * z2 + (1 / 60) * x1 * y4 * z1 ^ 2 * z3 - (1 /
    60) * x1 * y4 * z1 * z2 ^ 2 - (1 / 60) * x1 * y4 * z1 * z2 * z4 + (1 / 60) * x1 * y4 * z1 * z3 ^
    2 + (1 / 60) * x1 * y4 * z1 * z3 * z4 in
  let t_15 := t_14 - (1 / 60) * x1 * y4 * z2 ^ 3 - (1 / 60) * x1 * y4 * z2 ^ 2 * z4 - (1 / 60) * x1
    * y4 * z2 * z4 ^ 2 + (1 / 60) * x1 * y4 * z3 ^ 3 + (1 / 60) * x1 * y4 * z3 ^ 2 * z4 + (1 / 60) *
    x1 * y4 * z3 * z4 ^ 2 + (1 / 60) * x2 ^ 3 * y1 * z3 - (1 / 60) * x2 ^ 3 * y1 * z4 - (1 / 60) *
    x2 ^ 3 * y3 * z1 + (1 / 60) * x2 ^ 3 * y3 * z4 + (1 / 60) * x2 ^ 3 * y4 * z1 in
  let t_16 := t_15 - (1 / 60) * x2 ^ 3 * y4 * z3 - (1 / 60) * x2 ^ 2 * x3 * y1 * z2 + (1 / 60) * x2
    ^ 2 * x3 * y1 * z3 + (1 / 60) * x2 ^ 2 * x3 * y2 * z1 - (1 / 60) * x2 ^ 2 * x3 * y2 * z4 - (1 /
    60) * x2 ^ 2 * x3 * y3 * z1 + (1 / 60) * x2 ^ 2 * x3 * y3 * z4 + (1 / 60) * x2 ^ 2 * x3 * y4 *
    z2 - (1 / 60) * x2 ^ 2 * x3 * y4 * z3 + (1 / 60) * x2 ^ 2 * x4 * y1 * z2 in
  let t_17 := t_16 - (1 / 60) * x2 ^ 2 * x4 * y1 * z4 - (1 / 60) * x2 ^ 2 * x4 * y2 * z1 + (1 / 60)
    * x2 ^ 2 * x4 * y2 * z3 - (1 / 60) * x2 ^ 2 * x4 * y3 * z2 + (1 / 60) * x2 ^ 2 * x4 * y3 * z4 +
    (1 / 60) * x2 ^ 2 * x4 * y4 * z1 - (1 / 60) * x2 ^ 2 * x4 * y4 * z3 - (1 / 60) * x2 * x3 ^ 2 *
    y1 * z2 + (1 / 60) * x2 * x3 ^ 2 * y1 * z3 in
  let t_18 := t_17 + (1 / 60) * x2 * x3 ^ 2 * y2 * z1 - (1 / 60) * x2 * x3 ^ 2 * y2 * z4 - (1 / 60)
    * x2 * x3 ^ 2 * y3 * z1 + (1 / 60) * x2 * x3 ^ 2 * y3 * z4 + (1 / 60) * x2 * x3 ^ 2 * y4 * z2 -
    (1 / 60) * x2 * x3 ^ 2 * y4 * z3 + (1 / 60) * x2 * x3 * x4 * y2 * z3 - (1 / 60) * x2 * x3 * x4 *
    y2 * z4 - (1 / 60) * x2 * x3 * x4 * y3 * z2 in
  let t_19 := t_18 + (1 / 60) * x2 * x3 * x4 * y3 * z4 + (1 / 60) * x2 * x3 * x4 * y4 * z2 - (1 /
    60) * x2 * x3 * x4 * y4 * z3 + (1 / 60) * x2 * x4 ^ 2 * y1 * z2 - (1 / 60) * x2 * x4 ^ 2 * y1 *
    z4 - (1 / 60) * x2 * x4 ^ 2 * y2 * z1 + (1 / 60) * x2 * x4 ^ 2 * y2 * z3 - (1 / 60) * x2 * x4 ^
    2 * y3 * z2 + (1 / 60) * x2 * x4 ^ 2 * y3 * z4 in
  let t_20 := t_19 + (1 / 60) * x2 * x4 ^ 2 * y4 * z1 - (1 / 60) * x2 * x4 ^ 2 * y4 * z3 + (1 / 60)
    * x2 * y1 * z1 ^ 2 * z3 - (1 / 60) * x2 * y1 * z1 ^ 2 * z4 + (1 / 60) * x2 * y1 * z1 * z2 * z3 -
    (1 / 60) * x2 * y1 * z1 * z2 * z4 + (1 / 60) * x2 * y1 * z1 * z3 ^ 2 - (1 / 60) * x2 * y1 * z1 *
    z4 ^ 2 + (1 / 60) * x2 * y1 * z2 ^ 2 * z3 in
  let t_21 := t_20 - (1 / 60) * x2 * y1 * z2 ^ 2 * z4 + (1 / 60) * x2 * y1 * z2 * z3 ^ 2 - (1 / 60)
    * x2 * y1 * z2 * z4 ^ 2 + (1 / 60) * x2 * y1 * z3 ^ 3 - (1 / 60) * x2 * y1 * z4 ^ 3 - (1 / 60) *
    x2 * y3 * z1 ^ 3 - (1 / 60) * x2 * y3 * z1 ^ 2 * z2 - (1 / 60) * x2 * y3 * z1 ^ 2 * z3 - (1 /
    60) * x2 * y3 * z1 * z2 ^ 2 - (1 / 60) * x2 * y3 * z1 * z2 * z3 in
  let t_22 := t_21 - (1 / 60) * x2 * y3 * z1 * z3 ^ 2 + (1 / 60) * x2 * y3 * z2 ^ 2 * z4 + (1 / 60)
    * x2 * y3 * z2 * z3 * z4 + (1 / 60) * x2 * y3 * z2 * z4 ^ 2 + (1 / 60) * x2 * y3 * z3 ^ 2 * z4 +
    (1 / 60) * x2 * y3 * z3 * z4 ^ 2 + (1 / 60) * x2 * y3 * z4 ^ 3 + (1 / 60) * x2 * y4 * z1 ^ 3 +
    (1 / 60) * x2 * y4 * z1 ^ 2 * z2 + (1 / 60) * x2 * y4 * z1 ^ 2 * z4 in
  let t_23 := t_22 + (1 / 60) * x2 * y4 * z1 * z2 ^ 2 + (1 / 60) * x2 * y4 * z1 * z2 * z4 + (1 / 60)
    * x2 * y4 * z1 * z4 ^ 2 - (1 / 60) * x2 * y4 * z2 ^ 2 * z3 - (1 / 60) * x2 * y4 * z2 * z3 ^ 2 -
    (1 / 60) * x2 * y4 * z2 * z3 * z4 - (1 / 60) * x2 * y4 * z3 ^ 3 - (1 / 60) * x2 * y4 * z3 ^ 2 *
    z4 - (1 / 60) * x2 * y4 * z3 * z4 ^ 2 in
  let t_24 := t_23 - (1 / 60) * x3 ^ 3 * y1 * z2 + (1 / 60) * x3 ^ 3 * y1 * z4 + (1 / 60) * x3 ^ 3 *
    y2 * z1 - (1 / 60) * x3 ^ 3 * y2 * z4 - (1 / 60) * x3 ^ 3 * y4 * z1 + (1 / 60) * x3 ^ 3 * y4 *
    z2 - (1 / 60) * x3 ^ 2 * x4 * y1 * z3 + (1 / 60) * x3 ^ 2 * x4 * y1 * z4 + (1 / 60) * x3 ^ 2 *
    x4 * y2 * z3 - (1 / 60) * x3 ^ 2 * x4 * y2 * z4 + (1 / 60) * x3 ^ 2 * x4 * y3 * z1 in
  let t_25 := t_24 - (1 / 60) * x3 ^ 2 * x4 * y3 * z2 - (1 / 60) * x3 ^ 2 * x4 * y4 * z1 + (1 / 60)
    * x3 ^ 2 * x4 * y4 * z2 - (1 / 60) * x3 * x4 ^ 2 * y1 * z3 + (1 / 60) * x3 * x4 ^ 2 * y1 * z4 +
    (1 / 60) * x3 * x4 ^ 2 * y2 * z3 - (1 / 60) * x3 * x4 ^ 2 * y2 * z4 + (1 / 60) * x3 * x4 ^ 2 *
    y3 * z1 - (1 / 60) * x3 * x4 ^ 2 * y3 * z2 in
  let t_26 := t_25 - (1 / 60) * x3 * x4 ^ 2 * y4 * z1 + (1 / 60) * x3 * x4 ^ 2 * y4 * z2 - (1 / 60)
    * x3 * y1 * z1 ^ 2 * z2 + (1 / 60) * x3 * y1 * z1 ^ 2 * z4 - (1 / 60) * x3 * y1 * z1 * z2 ^ 2 -
    (1 / 60) * x3 * y1 * z1 * z2 * z3 + (1 / 60) * x3 * y1 * z1 * z3 * z4 + (1 / 60) * x3 * y1 * z1
    * z4 ^ 2 - (1 / 60) * x3 * y1 * z2 ^ 3 in
  let t_27 := t_26 - (1 / 60) * x3 * y1 * z2 ^ 2 * z3 - (1 / 60) * x3 * y1 * z2 * z3 ^ 2 + (1 / 60)
    * x3 * y1 * z3 ^ 2 * z4 + (1 / 60) * x3 * y1 * z3 * z4 ^ 2 + (1 / 60) * x3 * y1 * z4 ^ 3 + (1 /
    60) * x3 * y2 * z1 ^ 3 + (1 / 60) * x3 * y2 * z1 ^ 2 * z2 + (1 / 60) * x3 * y2 * z1 ^ 2 * z3 +
    (1 / 60) * x3 * y2 * z1 * z2 ^ 2 + (1 / 60) * x3 * y2 * z1 * z2 * z3 in
  let t_28 := t_27 + (1 / 60) * x3 * y2 * z1 * z3 ^ 2 - (1 / 60) * x3 * y2 * z2 ^ 2 * z4 - (1 / 60)
    * x3 * y2 * z2 * z3 * z4 - (1 / 60) * x3 * y2 * z2 * z4 ^ 2 - (1 / 60) * x3 * y2 * z3 ^ 2 * z4 -
    (1 / 60) * x3 * y2 * z3 * z4 ^ 2 - (1 / 60) * x3 * y2 * z4 ^ 3 - (1 / 60) * x3 * y4 * z1 ^ 3 -
    (1 / 60) * x3 * y4 * z1 ^ 2 * z3 - (1 / 60) * x3 * y4 * z1 ^ 2 * z4 in
  let t_29 := t_28 - (1 / 60) * x3 * y4 * z1 * z3 ^ 2 - (1 / 60) * x3 * y4 * z1 * z3 * z4 - (1 / 60)
    * x3 * y4 * z1 * z4 ^ 2 + (1 / 60) * x3 * y4 * z2 ^ 3 + (1 / 60) * x3 * y4 * z2 ^ 2 * z3 + (1 /
    60) * x3 * y4 * z2 ^ 2 * z4 + (1 / 60) * x3 * y4 * z2 * z3 ^ 2 + (1 / 60) * x3 * y4 * z2 * z3 *
    z4 + (1 / 60) * x3 * y4 * z2 * z4 ^ 2 in
  let t_30 := t_29 + (1 / 60) * x4 ^ 3 * y1 * z2 - (1 / 60) * x4 ^ 3 * y1 * z3 - (1 / 60) * x4 ^ 3 *
    y2 * z1 + (1 / 60) * x4 ^ 3 * y2 * z3 + (1 / 60) * x4 ^ 3 * y3 * z1 - (1 / 60) * x4 ^ 3 * y3 *
    z2 + (1 / 60) * x4 * y1 * z1 ^ 2 * z2 - (1 / 60) * x4 * y1 * z1 ^ 2 * z3 + (1 / 60) * x4 * y1 *
    z1 * z2 ^ 2 + (1 / 60) * x4 * y1 * z1 * z2 * z4 in
  let t_31 := t_30 - (1 / 60) * x4 * y1 * z1 * z3 ^ 2 - (1 / 60) * x4 * y1 * z1 * z3 * z4 + (1 / 60)
    * x4 * y1 * z2 ^ 3 + (1 / 60) * x4 * y1 * z2 ^ 2 * z4 + (1 / 60) * x4 * y1 * z2 * z4 ^ 2 - (1 /
    60) * x4 * y1 * z3 ^ 3 - (1 / 60) * x4 * y1 * z3 ^ 2 * z4 - (1 / 60) * x4 * y1 * z3 * z4 ^ 2 -
    (1 / 60) * x4 * y2 * z1 ^ 3 - (1 / 60) * x4 * y2 * z1 ^ 2 * z2 in
  let t_32 := t_31 - (1 / 60) * x4 * y2 * z1 ^ 2 * z4 - (1 / 60) * x4 * y2 * z1 * z2 ^ 2 - (1 / 60)
    * x4 * y2 * z1 * z2 * z4 - (1 / 60) * x4 * y2 * z1 * z4 ^ 2 + (1 / 60) * x4 * y2 * z2 ^ 2 * z3 +
    (1 / 60) * x4 * y2 * z2 * z3 ^ 2 + (1 / 60) * x4 * y2 * z2 * z3 * z4 + (1 / 60) * x4 * y2 * z3 ^
    3 + (1 / 60) * x4 * y2 * z3 ^ 2 * z4 in
  let t_33 := t_32 + (1 / 60) * x4 * y2 * z3 * z4 ^ 2 + (1 / 60) * x4 * y3 * z1 ^ 3 + (1 / 60) * x4
    * y3 * z1 ^ 2 * z3 + (1 / 60) * x4 * y3 * z1 ^ 2 * z4 + (1 / 60) * x4 * y3 * z1 * z3 ^ 2 + (1 /
    60) * x4 * y3 * z1 * z3 * z4 + (1 / 60) * x4 * y3 * z1 * z4 ^ 2 - (1 / 60) * x4 * y3 * z2 ^ 3 -
    (1 / 60) * x4 * y3 * z2 ^ 2 * z3 - (1 / 60) * x4 * y3 * z2 ^ 2 * z4 in
  let t_34 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_35 := (t_33 - (1 / 60) * x4 * y3 * z2 * z3 ^ 2 - (1 / 60) * x4 * y3 * z2 * z3 * z4 - (1 /
    60) * x4 * y3 * z2 * z4 ^ 2) * (m / (t_34 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1
    / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 -
    (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 *
    z1 - (1 / 6) * x4 * y3 * z2)) in
  t_34 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  t_3 + (m * (z1 + t_1) * (z1 + t_1) + m * (x1 + t_2) * (x1 + t_2)) = t_35.
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31
    t_32 t_33 t_34 t_35 D_1.
  rational.
Qed.

(* inertia, yz *)
Theorem tetrahedron_9 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (y2 - y1 + (y3 - y1) + (y4 - y1)) / 4 in
  let t_2 := (z2 - z1 + (z3 - z1) + (z4 - z1)) / 4 in
  let t_3 := (1 / 60) * x1 * y1 * y2 * z1 * z3 - (1 / 60) * x1 * y1 * y2 * z1 * z4 + (1 / 120) * x1
    * y1 * y2 * z2 * z3 - (1 / 120) * x1 * y1 * y2 * z2 * z4 + (1 / 120) * x1 * y1 * y2 * z3 ^ 2 -
    (1 / 120) * x1 * y1 * y2 * z4 ^ 2 - (1 / 60) * x1 * y1 * y3 * z1 * z2 + (1 / 60) * x1 * y1 * y3
    * z1 * z4 - (1 / 120) * x1 * y1 * y3 * z2 ^ 2 in
  let t_4 := t_3 - (1 / 120) * x1 * y1 * y3 * z2 * z3 + (1 / 120) * x1 * y1 * y3 * z3 * z4 + (1 /
    120) * x1 * y1 * y3 * z4 ^ 2 + (1 / 60) * x1 * y1 * y4 * z1 * z2 - (1 / 60) * x1 * y1 * y4 * z1
    * z3 + (1 / 120) * x1 * y1 * y4 * z2 ^ 2 + (1 / 120) * x1 * y1 * y4 * z2 * z4 - (1 / 120) * x1 *
    y1 * y4 * z3 ^ 2 - (1 / 120) * x1 * y1 * y4 * z3 * z4 in
  let t_5 := t_4 + (1 / 120) * x1 * y2 ^ 2 * z1 * z3 - (1 / 120) * x1 * y2 ^ 2 * z1 * z4 + (1 / 60)
    * x1 * y2 ^ 2 * z2 * z3 - (1 / 60) * x1 * y2 ^ 2 * z2 * z4 + (1 / 120) * x1 * y2 ^ 2 * z3 ^ 2 -
    (1 / 120) * x1 * y2 ^ 2 * z4 ^ 2 - (1 / 120) * x1 * y2 * y3 * z1 * z2 + (1 / 120) * x1 * y2 * y3
    * z1 * z3 - (1 / 60) * x1 * y2 * y3 * z2 ^ 2 in
  let t_6 := t_5 + (1 / 60) * x1 * y2 * y3 * z3 ^ 2 + (1 / 120) * x1 * y2 * y4 * z1 * z2 - (1 / 120)
    * x1 * y2 * y4 * z1 * z4 + (1 / 60) * x1 * y2 * y4 * z2 ^ 2 - (1 / 60) * x1 * y2 * y4 * z4 ^ 2 -
    (1 / 120) * x1 * y3 ^ 2 * z1 * z2 + (1 / 120) * x1 * y3 ^ 2 * z1 * z4 - (1 / 120) * x1 * y3 ^ 2
    * z2 ^ 2 - (1 / 60) * x1 * y3 ^ 2 * z2 * z3 in
  let t_7 := t_6 + (1 / 60) * x1 * y3 ^ 2 * z3 * z4 + (1 / 120) * x1 * y3 ^ 2 * z4 ^ 2 - (1 / 120) *
    x1 * y3 * y4 * z1 * z3 + (1 / 120) * x1 * y3 * y4 * z1 * z4 - (1 / 60) * x1 * y3 * y4 * z3 ^ 2 +
    (1 / 60) * x1 * y3 * y4 * z4 ^ 2 + (1 / 120) * x1 * y4 ^ 2 * z1 * z2 - (1 / 120) * x1 * y4 ^ 2 *
    z1 * z3 + (1 / 120) * x1 * y4 ^ 2 * z2 ^ 2 in
  let t_8 := t_7 + (1 / 60) * x1 * y4 ^ 2 * z2 * z4 - (1 / 120) * x1 * y4 ^ 2 * z3 ^ 2 - (1 / 60) *
    x1 * y4 ^ 2 * z3 * z4 - (1 / 60) * x2 * y1 ^ 2 * z1 * z3 + (1 / 60) * x2 * y1 ^ 2 * z1 * z4 - (1
    / 120) * x2 * y1 ^ 2 * z2 * z3 + (1 / 120) * x2 * y1 ^ 2 * z2 * z4 - (1 / 120) * x2 * y1 ^ 2 *
    z3 ^ 2 + (1 / 120) * x2 * y1 ^ 2 * z4 ^ 2 - (1 / 120) * x2 * y1 * y2 * z1 * z3 in
  let t_9 := t_8 + (1 / 120) * x2 * y1 * y2 * z1 * z4 - (1 / 60) * x2 * y1 * y2 * z2 * z3 + (1 / 60)
    * x2 * y1 * y2 * z2 * z4 - (1 / 120) * x2 * y1 * y2 * z3 ^ 2 + (1 / 120) * x2 * y1 * y2 * z4 ^ 2
    + (1 / 60) * x2 * y1 * y3 * z1 ^ 2 + (1 / 120) * x2 * y1 * y3 * z1 * z2 - (1 / 120) * x2 * y1 *
    y3 * z2 * z3 - (1 / 60) * x2 * y1 * y3 * z3 ^ 2 in
  let t_10 := t_9 - (1 / 60) * x2 * y1 * y4 * z1 ^ 2 - (1 / 120) * x2 * y1 * y4 * z1 * z2 + (1 /
    120) * x2 * y1 * y4 * z2 * z4 + (1 / 60) * x2 * y1 * y4 * z4 ^ 2 + (1 / 120) * x2 * y2 * y3 * z1
    ^ 2 + (1 / 60) * x2 * y2 * y3 * z1 * z2 + (1 / 120) * x2 * y2 * y3 * z1 * z3 - (1 / 60) * x2 *
    y2 * y3 * z2 * z4 - (1 / 120) * x2 * y2 * y3 * z3 * z4 in
  let t_11 := t_10 - (1 / 120) * x2 * y2 * y3 * z4 ^ 2 - (1 / 120) * x2 * y2 * y4 * z1 ^ 2 - (1 /
    60) * x2 * y2 * y4 * z1 * z2 - (1 / 120) * x2 * y2 * y4 * z1 * z4 + (1 / 60) * x2 * y2 * y4 * z2
    * z3 + (1 / 120) * x2 * y2 * y4 * z3 ^ 2 + (1 / 120) * x2 * y2 * y4 * z3 * z4 + (1 / 120) * x2 *
    y3 ^ 2 * z1 ^ 2 + (1 / 120) * x2 * y3 ^ 2 * z1 * z2 in
  let t_12 := t_11 + (1 / 60) * x2 * y3 ^ 2 * z1 * z3 - (1 / 120) * x2 * y3 ^ 2 * z2 * z4 - (1 / 60)
    * x2 * y3 ^ 2 * z3 * z4 - (1 / 120) * x2 * y3 ^ 2 * z4 ^ 2 + (1 / 120) * x2 * y3 * y4 * z2 * z3
    - (1 / 120) * x2 * y3 * y4 * z2 * z4 + (1 / 60) * x2 * y3 * y4 * z3 ^ 2 - (1 / 60) * x2 * y3 *
    y4 * z4 ^ 2 - (1 / 120) * x2 * y4 ^ 2 * z1 ^ 2 in
  let t_13 := t_12 - (1 / 120) * x2 * y4 ^ 2 * z1 * z2 - (1 / 60) * x2 * y4 ^ 2 * z1 * z4 + (1 /
    120) * x2 * y4 ^ 2 * z2 * z3 + (1 / 120) * x2 * y4 ^ 2 * z3 ^ 2 + (1 / 60) * x2 * y4 ^ 2 * z3 *
    z4 + (1 / 60) * x3 * y1 ^ 2 * z1 * z2 - (1 / 60) * x3 * y1 ^ 2 * z1 * z4 + (1 / 120) * x3 * y1 ^
    2 * z2 ^ 2 + (1 / 120) * x3 * y1 ^ 2 * z2 * z3 - (1 / 120) * x3 * y1 ^ 2 * z3 * z4 in
  let t_14 := t_13 - (1 / 120) * x3 * y1 ^ 2 * z4 ^ 2 - (1 / 60) * x3 * y1 * y2 * z1 ^ 2 - (1 / 120)
    * x3 * y1 * y2 * z1 * z3 + (1 / 60) * x3 * y1 * y2 * z2 ^ 2 + (1 / 120) * x3 * y1 * y2 * z2 * z3
    + (1 / 120) * x3 * y1 * y3 * z1 * z2 - (1 / 120) * x3 * y1 * y3 * z1 * z4 + (1 / 120) * x3 * y1
    * y3 * z2 ^ 2 + (1 / 60) * x3 * y1 * y3 * z2 * z3 in
  let t_15 := t_14 - (1 / 60) * x3 * y1 * y3 * z3 * z4 - (1 / 120) * x3 * y1 * y3 * z4 ^ 2 + (1 /
    60) * x3 * y1 * y4 * z1 ^ 2 + (1 / 120) * x3 * y1 * y4 * z1 * z3 - (1 / 120) * x3 * y1 * y4 * z3
    * z4 - (1 / 60) * x3 * y1 * y4 * z4 ^ 2 - (1 / 120) * x3 * y2 ^ 2 * z1 ^ 2 - (1 / 60) * x3 * y2
    ^ 2 * z1 * z2 - (1 / 120) * x3 * y2 ^ 2 * z1 * z3 in
  let t_16 := t_15 + (1 / 60) * x3 * y2 ^ 2 * z2 * z4 + (1 / 120) * x3 * y2 ^ 2 * z3 * z4 + (1 /
    120) * x3 * y2 ^ 2 * z4 ^ 2 - (1 / 120) * x3 * y2 * y3 * z1 ^ 2 - (1 / 120) * x3 * y2 * y3 * z1
    * z2 - (1 / 60) * x3 * y2 * y3 * z1 * z3 + (1 / 120) * x3 * y2 * y3 * z2 * z4 + (1 / 60) * x3 *
    y2 * y3 * z3 * z4 + (1 / 120) * x3 * y2 * y3 * z4 ^ 2 in
  let t_17 := t_16 - (1 / 60) * x3 * y2 * y4 * z2 ^ 2 - (1 / 120) * x3 * y2 * y4 * z2 * z3 + (1 /
    120) * x3 * y2 * y4 * z3 * z4 + (1 / 60) * x3 * y2 * y4 * z4 ^ 2 + (1 / 120) * x3 * y3 * y4 * z1
    ^ 2 + (1 / 60) * x3 * y3 * y4 * z1 * z3 + (1 / 120) * x3 * y3 * y4 * z1 * z4 - (1 / 120) * x3 *
    y3 * y4 * z2 ^ 2 - (1 / 60) * x3 * y3 * y4 * z2 * z3 in
  let t_18 := t_17 - (1 / 120) * x3 * y3 * y4 * z2 * z4 + (1 / 120) * x3 * y4 ^ 2 * z1 ^ 2 + (1 /
    120) * x3 * y4 ^ 2 * z1 * z3 + (1 / 60) * x3 * y4 ^ 2 * z1 * z4 - (1 / 120) * x3 * y4 ^ 2 * z2 ^
    2 - (1 / 120) * x3 * y4 ^ 2 * z2 * z3 - (1 / 60) * x3 * y4 ^ 2 * z2 * z4 - (1 / 60) * x4 * y1 ^
    2 * z1 * z2 + (1 / 60) * x4 * y1 ^ 2 * z1 * z3 - (1 / 120) * x4 * y1 ^ 2 * z2 ^ 2 in
  let t_19 := t_18 - (1 / 120) * x4 * y1 ^ 2 * z2 * z4 + (1 / 120) * x4 * y1 ^ 2 * z3 ^ 2 + (1 /
    120) * x4 * y1 ^ 2 * z3 * z4 + (1 / 60) * x4 * y1 * y2 * z1 ^ 2 + (1 / 120) * x4 * y1 * y2 * z1
    * z4 - (1 / 60) * x4 * y1 * y2 * z2 ^ 2 - (1 / 120) * x4 * y1 * y2 * z2 * z4 - (1 / 60) * x4 *
    y1 * y3 * z1 ^ 2 - (1 / 120) * x4 * y1 * y3 * z1 * z4 in
  let t_20 := t_19 + (1 / 60) * x4 * y1 * y3 * z3 ^ 2 + (1 / 120) * x4 * y1 * y3 * z3 * z4 - (1 /
    120) * x4 * y1 * y4 * z1 * z2 + (1 / 120) * x4 * y1 * y4 * z1 * z3 - (1 / 120) * x4 * y1 * y4 *
    z2 ^ 2 - (1 / 60) * x4 * y1 * y4 * z2 * z4 + (1 / 120) * x4 * y1 * y4 * z3 ^ 2 + (1 / 60) * x4 *
    y1 * y4 * z3 * z4 + (1 / 120) * x4 * y2 ^ 2 * z1 ^ 2 in
  let t_21 := t_20 + (1 / 60) * x4 * y2 ^ 2 * z1 * z2 + (1 / 120) * x4 * y2 ^ 2 * z1 * z4 - (1 / 60)
    * x4 * y2 ^ 2 * z2 * z3 - (1 / 120) * x4 * y2 ^ 2 * z3 ^ 2 - (1 / 120) * x4 * y2 ^ 2 * z3 * z4 +
    (1 / 60) * x4 * y2 * y3 * z2 ^ 2 + (1 / 120) * x4 * y2 * y3 * z2 * z4 - (1 / 60) * x4 * y2 * y3
    * z3 ^ 2 - (1 / 120) * x4 * y2 * y3 * z3 * z4 in
  let t_22 := t_21 + (1 / 120) * x4 * y2 * y4 * z1 ^ 2 + (1 / 120) * x4 * y2 * y4 * z1 * z2 + (1 /
    60) * x4 * y2 * y4 * z1 * z4 - (1 / 120) * x4 * y2 * y4 * z2 * z3 - (1 / 120) * x4 * y2 * y4 *
    z3 ^ 2 - (1 / 60) * x4 * y2 * y4 * z3 * z4 - (1 / 120) * x4 * y3 ^ 2 * z1 ^ 2 - (1 / 60) * x4 *
    y3 ^ 2 * z1 * z3 - (1 / 120) * x4 * y3 ^ 2 * z1 * z4 in
  let t_23 := t_22 + (1 / 120) * x4 * y3 ^ 2 * z2 ^ 2 + (1 / 60) * x4 * y3 ^ 2 * z2 * z3 + (1 / 120)
    * x4 * y3 ^ 2 * z2 * z4 - (1 / 120) * x4 * y3 * y4 * z1 ^ 2 - (1 / 120) * x4 * y3 * y4 * z1 * z3
    - (1 / 60) * x4 * y3 * y4 * z1 * z4 + (1 / 120) * x4 * y3 * y4 * z2 ^ 2 + (1 / 120) * x4 * y3 *
    y4 * z2 * z3 + (1 / 60) * x4 * y3 * y4 * z2 * z4 in
  let t_24 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  t_24 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  - (m / 20 * t_1 * t_2) - m / 20 * (y2 - y1 - t_1) * (z2 - z1 - t_2) - m / 20 * (y3 - y1 - t_1) *
    (z3 - z1 - t_2) - m / 20 * (y4 - y1 - t_1) * (z4 - z1 - t_2) - m * (y1 + t_1) * (z1 + t_2) =
    t_23 * (m / (t_24 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 -
    (1 / 6) * x3 * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 *
    z3 - (1 / 6) * x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 *
    y3 * z2)).
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1.
  rational.
Qed.

(* inertia, zx *)
Theorem tetrahedron_10 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (x2 - x1 + (x3 - x1) + (x4 - x1)) / 4 in
  let t_2 := (z2 - z1 + (z3 - z1) + (z4 - z1)) / 4 in
  let t_3 := (1 / 60) * x1 ^ 2 * y2 * z1 * z3 - (1 / 60) * x1 ^ 2 * y2 * z1 * z4 + (1 / 120) * x1 ^
    2 * y2 * z2 * z3 - (1 / 120) * x1 ^ 2 * y2 * z2 * z4 + (1 / 120) * x1 ^ 2 * y2 * z3 ^ 2 - (1 /
    120) * x1 ^ 2 * y2 * z4 ^ 2 - (1 / 60) * x1 ^ 2 * y3 * z1 * z2 + (1 / 60) * x1 ^ 2 * y3 * z1 *
    z4 - (1 / 120) * x1 ^ 2 * y3 * z2 ^ 2 - (1 / 120) * x1 ^ 2 * y3 * z2 * z3 in
  let t_4 := t_3 + (1 / 120) * x1 ^ 2 * y3 * z3 * z4 + (1 / 120) * x1 ^ 2 * y3 * z4 ^ 2 + (1 / 60) *
    x1 ^ 2 * y4 * z1 * z2 - (1 / 60) * x1 ^ 2 * y4 * z1 * z3 + (1 / 120) * x1 ^ 2 * y4 * z2 ^ 2 + (1
    / 120) * x1 ^ 2 * y4 * z2 * z4 - (1 / 120) * x1 ^ 2 * y4 * z3 ^ 2 - (1 / 120) * x1 ^ 2 * y4 * z3
    * z4 - (1 / 60) * x1 * x2 * y1 * z1 * z3 + (1 / 60) * x1 * x2 * y1 * z1 * z4 in
  let t_5 := t_4 - (1 / 120) * x1 * x2 * y1 * z2 * z3 + (1 / 120) * x1 * x2 * y1 * z2 * z4 - (1 /
    120) * x1 * x2 * y1 * z3 ^ 2 + (1 / 120) * x1 * x2 * y1 * z4 ^ 2 + (1 / 120) * x1 * x2 * y2 * z1
    * z3 - (1 / 120) * x1 * x2 * y2 * z1 * z4 + (1 / 60) * x1 * x2 * y2 * z2 * z3 - (1 / 60) * x1 *
    x2 * y2 * z2 * z4 + (1 / 120) * x1 * x2 * y2 * z3 ^ 2 in
  let t_6 := t_5 - (1 / 120) * x1 * x2 * y2 * z4 ^ 2 + (1 / 60) * x1 * x2 * y3 * z1 ^ 2 + (1 / 120)
    * x1 * x2 * y3 * z1 * z3 - (1 / 60) * x1 * x2 * y3 * z2 ^ 2 - (1 / 120) * x1 * x2 * y3 * z2 * z3
    - (1 / 60) * x1 * x2 * y4 * z1 ^ 2 - (1 / 120) * x1 * x2 * y4 * z1 * z4 + (1 / 60) * x1 * x2 *
    y4 * z2 ^ 2 + (1 / 120) * x1 * x2 * y4 * z2 * z4 in
  let t_7 := t_6 + (1 / 60) * x1 * x3 * y1 * z1 * z2 - (1 / 60) * x1 * x3 * y1 * z1 * z4 + (1 / 120)
    * x1 * x3 * y1 * z2 ^ 2 + (1 / 120) * x1 * x3 * y1 * z2 * z3 - (1 / 120) * x1 * x3 * y1 * z3 *
    z4 - (1 / 120) * x1 * x3 * y1 * z4 ^ 2 - (1 / 60) * x1 * x3 * y2 * z1 ^ 2 - (1 / 120) * x1 * x3
    * y2 * z1 * z2 + (1 / 120) * x1 * x3 * y2 * z2 * z3 in
  let t_8 := t_7 + (1 / 60) * x1 * x3 * y2 * z3 ^ 2 - (1 / 120) * x1 * x3 * y3 * z1 * z2 + (1 / 120)
    * x1 * x3 * y3 * z1 * z4 - (1 / 120) * x1 * x3 * y3 * z2 ^ 2 - (1 / 60) * x1 * x3 * y3 * z2 * z3
    + (1 / 60) * x1 * x3 * y3 * z3 * z4 + (1 / 120) * x1 * x3 * y3 * z4 ^ 2 + (1 / 60) * x1 * x3 *
    y4 * z1 ^ 2 + (1 / 120) * x1 * x3 * y4 * z1 * z4 in
  let t_9 := t_8 - (1 / 60) * x1 * x3 * y4 * z3 ^ 2 - (1 / 120) * x1 * x3 * y4 * z3 * z4 - (1 / 60)
    * x1 * x4 * y1 * z1 * z2 + (1 / 60) * x1 * x4 * y1 * z1 * z3 - (1 / 120) * x1 * x4 * y1 * z2 ^ 2
    - (1 / 120) * x1 * x4 * y1 * z2 * z4 + (1 / 120) * x1 * x4 * y1 * z3 ^ 2 + (1 / 120) * x1 * x4 *
    y1 * z3 * z4 + (1 / 60) * x1 * x4 * y2 * z1 ^ 2 in
  let t_10 := t_9 + (1 / 120) * x1 * x4 * y2 * z1 * z2 - (1 / 120) * x1 * x4 * y2 * z2 * z4 - (1 /
    60) * x1 * x4 * y2 * z4 ^ 2 - (1 / 60) * x1 * x4 * y3 * z1 ^ 2 - (1 / 120) * x1 * x4 * y3 * z1 *
    z3 + (1 / 120) * x1 * x4 * y3 * z3 * z4 + (1 / 60) * x1 * x4 * y3 * z4 ^ 2 + (1 / 120) * x1 * x4
    * y4 * z1 * z2 - (1 / 120) * x1 * x4 * y4 * z1 * z3 in
  let t_11 := t_10 + (1 / 120) * x1 * x4 * y4 * z2 ^ 2 + (1 / 60) * x1 * x4 * y4 * z2 * z4 - (1 /
    120) * x1 * x4 * y4 * z3 ^ 2 - (1 / 60) * x1 * x4 * y4 * z3 * z4 - (1 / 120) * x2 ^ 2 * y1 * z1
    * z3 + (1 / 120) * x2 ^ 2 * y1 * z1 * z4 - (1 / 60) * x2 ^ 2 * y1 * z2 * z3 + (1 / 60) * x2 ^ 2
    * y1 * z2 * z4 - (1 / 120) * x2 ^ 2 * y1 * z3 ^ 2 in
  let t_12 := t_11 + (1 / 120) * x2 ^ 2 * y1 * z4 ^ 2 + (1 / 120) * x2 ^ 2 * y3 * z1 ^ 2 + (1 / 60)
    * x2 ^ 2 * y3 * z1 * z2 + (1 / 120) * x2 ^ 2 * y3 * z1 * z3 - (1 / 60) * x2 ^ 2 * y3 * z2 * z4 -
    (1 / 120) * x2 ^ 2 * y3 * z3 * z4 - (1 / 120) * x2 ^ 2 * y3 * z4 ^ 2 - (1 / 120) * x2 ^ 2 * y4 *
    z1 ^ 2 - (1 / 60) * x2 ^ 2 * y4 * z1 * z2 - (1 / 120) * x2 ^ 2 * y4 * z1 * z4 in
  let t_13 := t_12 + (1 / 60) * x2 ^ 2 * y4 * z2 * z3 + (1 / 120) * x2 ^ 2 * y4 * z3 ^ 2 + (1 / 120)
    * x2 ^ 2 * y4 * z3 * z4 + (1 / 120) * x2 * x3 * y1 * z1 * z2 - (1 / 120) * x2 * x3 * y1 * z1 *
    z3 + (1 / 60) * x2 * x3 * y1 * z2 ^ 2 - (1 / 60) * x2 * x3 * y1 * z3 ^ 2 - (1 / 120) * x2 * x3 *
    y2 * z1 ^ 2 - (1 / 60) * x2 * x3 * y2 * z1 * z2 in
  let t_14 := t_13 - (1 / 120) * x2 * x3 * y2 * z1 * z3 + (1 / 60) * x2 * x3 * y2 * z2 * z4 + (1 /
    120) * x2 * x3 * y2 * z3 * z4 + (1 / 120) * x2 * x3 * y2 * z4 ^ 2 + (1 / 120) * x2 * x3 * y3 *
    z1 ^ 2 + (1 / 120) * x2 * x3 * y3 * z1 * z2 + (1 / 60) * x2 * x3 * y3 * z1 * z3 - (1 / 120) * x2
    * x3 * y3 * z2 * z4 - (1 / 60) * x2 * x3 * y3 * z3 * z4 in
  let t_15 := t_14 - (1 / 120) * x2 * x3 * y3 * z4 ^ 2 - (1 / 60) * x2 * x3 * y4 * z2 ^ 2 - (1 /
    120) * x2 * x3 * y4 * z2 * z4 + (1 / 60) * x2 * x3 * y4 * z3 ^ 2 + (1 / 120) * x2 * x3 * y4 * z3
    * z4 - (1 / 120) * x2 * x4 * y1 * z1 * z2 + (1 / 120) * x2 * x4 * y1 * z1 * z4 - (1 / 60) * x2 *
    x4 * y1 * z2 ^ 2 + (1 / 60) * x2 * x4 * y1 * z4 ^ 2 in
  let t_16 := t_15 + (1 / 120) * x2 * x4 * y2 * z1 ^ 2 + (1 / 60) * x2 * x4 * y2 * z1 * z2 + (1 /
    120) * x2 * x4 * y2 * z1 * z4 - (1 / 60) * x2 * x4 * y2 * z2 * z3 - (1 / 120) * x2 * x4 * y2 *
    z3 ^ 2 - (1 / 120) * x2 * x4 * y2 * z3 * z4 + (1 / 60) * x2 * x4 * y3 * z2 ^ 2 + (1 / 120) * x2
    * x4 * y3 * z2 * z3 - (1 / 120) * x2 * x4 * y3 * z3 * z4 in
  let t_17 := t_16 - (1 / 60) * x2 * x4 * y3 * z4 ^ 2 - (1 / 120) * x2 * x4 * y4 * z1 ^ 2 - (1 /
    120) * x2 * x4 * y4 * z1 * z2 - (1 / 60) * x2 * x4 * y4 * z1 * z4 + (1 / 120) * x2 * x4 * y4 *
    z2 * z3 + (1 / 120) * x2 * x4 * y4 * z3 ^ 2 + (1 / 60) * x2 * x4 * y4 * z3 * z4 + (1 / 120) * x3
    ^ 2 * y1 * z1 * z2 - (1 / 120) * x3 ^ 2 * y1 * z1 * z4 in
  let t_18 := t_17 + (1 / 120) * x3 ^ 2 * y1 * z2 ^ 2 + (1 / 60) * x3 ^ 2 * y1 * z2 * z3 - (1 / 60)
    * x3 ^ 2 * y1 * z3 * z4 - (1 / 120) * x3 ^ 2 * y1 * z4 ^ 2 - (1 / 120) * x3 ^ 2 * y2 * z1 ^ 2 -
    (1 / 120) * x3 ^ 2 * y2 * z1 * z2 - (1 / 60) * x3 ^ 2 * y2 * z1 * z3 + (1 / 120) * x3 ^ 2 * y2 *
    z2 * z4 + (1 / 60) * x3 ^ 2 * y2 * z3 * z4 + (1 / 120) * x3 ^ 2 * y2 * z4 ^ 2 in
  let t_19 := t_18 + (1 / 120) * x3 ^ 2 * y4 * z1 ^ 2 + (1 / 60) * x3 ^ 2 * y4 * z1 * z3 + (1 / 120)
    * x3 ^ 2 * y4 * z1 * z4 - (1 / 120) * x3 ^ 2 * y4 * z2 ^ 2 - (1 / 60) * x3 ^ 2 * y4 * z2 * z3 -
    (1 / 120) * x3 ^ 2 * y4 * z2 * z4 + (1 / 120) * x3 * x4 * y1 * z1 * z3 - (1 / 120) * x3 * x4 *
    y1 * z1 * z4 + (1 / 60) * x3 * x4 * y1 * z3 ^ 2 in
  let t_20 := t_19 - (1 / 60) * x3 * x4 * y1 * z4 ^ 2 - (1 / 120) * x3 * x4 * y2 * z2 * z3 + (1 /
    120) * x3 * x4 * y2 * z2 * z4 - (1 / 60) * x3 * x4 * y2 * z3 ^ 2 + (1 / 60) * x3 * x4 * y2 * z4
    ^ 2 - (1 / 120) * x3 * x4 * y3 * z1 ^ 2 - (1 / 60) * x3 * x4 * y3 * z1 * z3 - (1 / 120) * x3 *
    x4 * y3 * z1 * z4 + (1 / 120) * x3 * x4 * y3 * z2 ^ 2 in
  let t_21 := t_20 + (1 / 60) * x3 * x4 * y3 * z2 * z3 + (1 / 120) * x3 * x4 * y3 * z2 * z4 + (1 /
    120) * x3 * x4 * y4 * z1 ^ 2 + (1 / 120) * x3 * x4 * y4 * z1 * z3 + (1 / 60) * x3 * x4 * y4 * z1
    * z4 - (1 / 120) * x3 * x4 * y4 * z2 ^ 2 - (1 / 120) * x3 * x4 * y4 * z2 * z3 - (1 / 60) * x3 *
    x4 * y4 * z2 * z4 - (1 / 120) * x4 ^ 2 * y1 * z1 * z2 in
  let t_22 := t_21 + (1 / 120) * x4 ^ 2 * y1 * z1 * z3 - (1 / 120) * x4 ^ 2 * y1 * z2 ^ 2 - (1 / 60)
    * x4 ^ 2 * y1 * z2 * z4 + (1 / 120) * x4 ^ 2 * y1 * z3 ^ 2 + (1 / 60) * x4 ^ 2 * y1 * z3 * z4 +
    (1 / 120) * x4 ^ 2 * y2 * z1 ^ 2 + (1 / 120) * x4 ^ 2 * y2 * z1 * z2 + (1 / 60) * x4 ^ 2 * y2 *
    z1 * z4 - (1 / 120) * x4 ^ 2 * y2 * z2 * z3 - (1 / 120) * x4 ^ 2 * y2 * z3 ^ 2 in
  let t_23 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_24 := (t_22 - (1 / 60) * x4 ^ 2 * y2 * z3 * z4 - (1 / 120) * x4 ^ 2 * y3 * z1 ^ 2 - (1 /
    120) * x4 ^ 2 * y3 * z1 * z3 - (1 / 60) * x4 ^ 2 * y3 * z1 * z4 + (1 / 120) * x4 ^ 2 * y3 * z2 ^
    2 + (1 / 120) * x4 ^ 2 * y3 * z2 * z3 + (1 / 60) * x4 ^ 2 * y3 * z2 * z4) * (m / (t_23 + (1 / 6)
    * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4 * z1 + (1 /
    6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 * y2 * z1 +
    (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2)) in
  t_23 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  - (m / 20 * t_1 * t_2) - m / 20 * (x2 - x1 - t_1) * (z2 - z1 - t_2) - m / 20 * (x3 - x1 - t_1) *
    (z3 - z1 - t_2) - m / 20 * (x4 - x1 - t_1) * (z4 - z1 - t_2) - m * (x1 + t_1) * (z1 + t_2) =
    t_24.
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1.
  rational.
Qed.

(* inertia, zy *)
Theorem tetrahedron_11 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (y2 - y1 + (y3 - y1) + (y4 - y1)) / 4 in
  let t_2 := (z2 - z1 + (z3 - z1) + (z4 - z1)) / 4 in
  let t_3 := (1 / 60) * x1 * y1 * y2 * z1 * z3 - (1 / 60) * x1 * y1 * y2 * z1 * z4 + (1 / 120) * x1
    * y1 * y2 * z2 * z3 - (1 / 120) * x1 * y1 * y2 * z2 * z4 + (1 / 120) * x1 * y1 * y2 * z3 ^ 2 -
    (1 / 120) * x1 * y1 * y2 * z4 ^ 2 - (1 / 60) * x1 * y1 * y3 * z1 * z2 + (1 / 60) * x1 * y1 * y3
    * z1 * z4 - (1 / 120) * x1 * y1 * y3 * z2 ^ 2 in
  let t_4 := t_3 - (1 / 120) * x1 * y1 * y3 * z2 * z3 + (1 / 120) * x1 * y1 * y3 * z3 * z4 + (1 /
    120) * x1 * y1 * y3 * z4 ^ 2 + (1 / 60) * x1 * y1 * y4 * z1 * z2 - (1 / 60) * x1 * y1 * y4 * z1
    * z3 + (1 / 120) * x1 * y1 * y4 * z2 ^ 2 + (1 / 120) * x1 * y1 * y4 * z2 * z4 - (1 / 120) * x1 *
    y1 * y4 * z3 ^ 2 - (1 / 120) * x1 * y1 * y4 * z3 * z4 in
  let t_5 := t_4 + (1 / 120) * x1 * y2 ^ 2 * z1 * z3 - (1 / 120) * x1 * y2 ^ 2 * z1 * z4 + (1 / 60)
    * x1 * y2 ^ 2 * z2 * z3 - (1 / 60) * x1 * y2 ^ 2 * z2 * z4 + (1 / 120) * x1 * y2 ^ 2 * z3 ^ 2 -
    (1 / 120) * x1 * y2 ^ 2 * z4 ^ 2 - (1 / 120) * x1 * y2 * y3 * z1 * z2 + (1 / 120) * x1 * y2 * y3
    * z1 * z3 - (1 / 60) * x1 * y2 * y3 * z2 ^ 2 in
  let t_6 := t_5 + (1 / 60) * x1 * y2 * y3 * z3 ^ 2 + (1 / 120) * x1 * y2 * y4 * z1 * z2 - (1 / 120)
    * x1 * y2 * y4 * z1 * z4 + (1 / 60) * x1 * y2 * y4 * z2 ^ 2 - (1 / 60) * x1 * y2 * y4 * z4 ^ 2 -
    (1 / 120) * x1 * y3 ^ 2 * z1 * z2 + (1 / 120) * x1 * y3 ^ 2 * z1 * z4 - (1 / 120) * x1 * y3 ^ 2
    * z2 ^ 2 - (1 / 60) * x1 * y3 ^ 2 * z2 * z3 in
  let t_7 := t_6 + (1 / 60) * x1 * y3 ^ 2 * z3 * z4 + (1 / 120) * x1 * y3 ^ 2 * z4 ^ 2 - (1 / 120) *
    x1 * y3 * y4 * z1 * z3 + (1 / 120) * x1 * y3 * y4 * z1 * z4 - (1 / 60) * x1 * y3 * y4 * z3 ^ 2 +
    (1 / 60) * x1 * y3 * y4 * z4 ^ 2 + (1 / 120) * x1 * y4 ^ 2 * z1 * z2 - (1 / 120) * x1 * y4 ^ 2 *
    z1 * z3 + (1 / 120) * x1 * y4 ^ 2 * z2 ^ 2 in
  let t_8 := t_7 + (1 / 60) * x1 * y4 ^ 2 * z2 * z4 - (1 / 120) * x1 * y4 ^ 2 * z3 ^ 2 - (1 / 60) *
    x1 * y4 ^ 2 * z3 * z4 - (1 / 60) * x2 * y1 ^ 2 * z1 * z3 + (1 / 60) * x2 * y1 ^ 2 * z1 * z4 - (1
    / 120) * x2 * y1 ^ 2 * z2 * z3 + (1 / 120) * x2 * y1 ^ 2 * z2 * z4 - (1 / 120) * x2 * y1 ^ 2 *
    z3 ^ 2 + (1 / 120) * x2 * y1 ^ 2 * z4 ^ 2 - (1 / 120) * x2 * y1 * y2 * z1 * z3 in
  let t_9 := t_8 + (1 / 120) * x2 * y1 * y2 * z1 * z4 - (1 / 60) * x2 * y1 * y2 * z2 * z3 + (1 / 60)
    * x2 * y1 * y2 * z2 * z4 - (1 / 120) * x2 * y1 * y2 * z3 ^ 2 + (1 / 120) * x2 * y1 * y2 * z4 ^ 2
    + (1 / 60) * x2 * y1 * y3 * z1 ^ 2 + (1 / 120) * x2 * y1 * y3 * z1 * z2 - (1 / 120) * x2 * y1 *
    y3 * z2 * z3 - (1 / 60) * x2 * y1 * y3 * z3 ^ 2 in
  let t_10 := t_9 - (1 / 60) * x2 * y1 * y4 * z1 ^ 2 - (1 / 120) * x2 * y1 * y4 * z1 * z2 + (1 /
    120) * x2 * y1 * y4 * z2 * z4 + (1 / 60) * x2 * y1 * y4 * z4 ^ 2 + (1 / 120) * x2 * y2 * y3 * z1
    ^ 2 + (1 / 60) * x2 * y2 * y3 * z1 * z2 + (1 / 120) * x2 * y2 * y3 * z1 * z3 - (1 / 60) * x2 *
    y2 * y3 * z2 * z4 - (1 / 120) * x2 * y2 * y3 * z3 * z4 in
  let t_11 := t_10 - (1 / 120) * x2 * y2 * y3 * z4 ^ 2 - (1 / 120) * x2 * y2 * y4 * z1 ^ 2 - (1 /
    60) * x2 * y2 * y4 * z1 * z2 - (1 / 120) * x2 * y2 * y4 * z1 * z4 + (1 / 60) * x2 * y2 * y4 * z2
    * z3 + (1 / 120) * x2 * y2 * y4 * z3 ^ 2 + (1 / 120) * x2 * y2 * y4 * z3 * z4 + (1 / 120) * x2 *
    y3 ^ 2 * z1 ^ 2 + (1 / 120) * x2 * y3 ^ 2 * z1 * z2 in
  let t_12 := t_11 + (1 / 60) * x2 * y3 ^ 2 * z1 * z3 - (1 / 120) * x2 * y3 ^ 2 * z2 * z4 - (1 / 60)
    * x2 * y3 ^ 2 * z3 * z4 - (1 / 120) * x2 * y3 ^ 2 * z4 ^ 2 + (1 / 120) * x2 * y3 * y4 * z2 * z3
    - (1 / 120) * x2 * y3 * y4 * z2 * z4 + (1 / 60) * x2 * y3 * y4 * z3 ^ 2 - (1 / 60) * x2 * y3 *
    y4 * z4 ^ 2 - (1 / 120) * x2 * y4 ^ 2 * z1 ^ 2 in
  let t_13 := t_12 - (1 / 120) * x2 * y4 ^ 2 * z1 * z2 - (1 / 60) * x2 * y4 ^ 2 * z1 * z4 + (1 /
    120) * x2 * y4 ^ 2 * z2 * z3 + (1 / 120) * x2 * y4 ^ 2 * z3 ^ 2 + (1 / 60) * x2 * y4 ^ 2 * z3 *
    z4 + (1 / 60) * x3 * y1 ^ 2 * z1 * z2 - (1 / 60) * x3 * y1 ^ 2 * z1 * z4 + (1 / 120) * x3 * y1 ^
    2 * z2 ^ 2 + (1 / 120) * x3 * y1 ^ 2 * z2 * z3 - (1 / 120) * x3 * y1 ^ 2 * z3 * z4 in
  let t_14 := t_13 - (1 / 120) * x3 * y1 ^ 2 * z4 ^ 2 - (1 / 60) * x3 * y1 * y2 * z1 ^ 2 - (1 / 120)
    * x3 * y1 * y2 * z1 * z3 + (1 / 60) * x3 * y1 * y2 * z2 ^ 2 + (1 / 120) * x3 * y1 * y2 * z2 * z3
    + (1 / 120) * x3 * y1 * y3 * z1 * z2 - (1 / 120) * x3 * y1 * y3 * z1 * z4 + (1 / 120) * x3 * y1
    * y3 * z2 ^ 2 + (1 / 60) * x3 * y1 * y3 * z2 * z3 in
  let t_15 := t_14 - (1 / 60) * x3 * y1 * y3 * z3 * z4 - (1 / 120) * x3 * y1 * y3 * z4 ^ 2 + (1 /
    60) * x3 * y1 * y4 * z1 ^ 2 + (1 / 120) * x3 * y1 * y4 * z1 * z3 - (1 / 120) * x3 * y1 * y4 * z3
    * z4 - (1 / 60) * x3 * y1 * y4 * z4 ^ 2 - (1 / 120) * x3 * y2 ^ 2 * z1 ^ 2 - (1 / 60) * x3 * y2
    ^ 2 * z1 * z2 - (1 / 120) * x3 * y2 ^ 2 * z1 * z3 in
  let t_16 := t_15 + (1 / 60) * x3 * y2 ^ 2 * z2 * z4 + (1 / 120) * x3 * y2 ^ 2 * z3 * z4 + (1 /
    120) * x3 * y2 ^ 2 * z4 ^ 2 - (1 / 120) * x3 * y2 * y3 * z1 ^ 2 - (1 / 120) * x3 * y2 * y3 * z1
    * z2 - (1 / 60) * x3 * y2 * y3 * z1 * z3 + (1 / 120) * x3 * y2 * y3 * z2 * z4 + (1 / 60) * x3 *
    y2 * y3 * z3 * z4 + (1 / 120) * x3 * y2 * y3 * z4 ^ 2 in
  let t_17 := t_16 - (1 / 60) * x3 * y2 * y4 * z2 ^ 2 - (1 / 120) * x3 * y2 * y4 * z2 * z3 + (1 /
    120) * x3 * y2 * y4 * z3 * z4 + (1 / 60) * x3 * y2 * y4 * z4 ^ 2 + (1 / 120) * x3 * y3 * y4 * z1
    ^ 2 + (1 / 60) * x3 * y3 * y4 * z1 * z3 + (1 / 120) * x3 * y3 * y4 * z1 * z4 - (1 / 120) * x3 *
    y3 * y4 * z2 ^ 2 - (1 / 60) * x3 * y3 * y4 * z2 * z3 in
  let t_18 := t_17 - (1 / 120) * x3 * y3 * y4 * z2 * z4 + (1 / 120) * x3 * y4 ^ 2 * z1 ^ 2 + (1 /
    120) * x3 * y4 ^ 2 * z1 * z3 + (1 / 60) * x3 * y4 ^ 2 * z1 * z4 - (1 / 120) * x3 * y4 ^ 2 * z2 ^
    2 - (1 / 120) * x3 * y4 ^ 2 * z2 * z3 - (1 / 60) * x3 * y4 ^ 2 * z2 * z4 - (1 / 60) * x4 * y1 ^
    2 * z1 * z2 + (1 / 60) * x4 * y1 ^ 2 * z1 * z3 - (1 / 120) * x4 * y1 ^ 2 * z2 ^ 2 in
  let t_19 := t_18 - (1 / 120) * x4 * y1 ^ 2 * z2 * z4 + (1 / 120) * x4 * y1 ^ 2 * z3 ^ 2 + (1 /
    120) * x4 * y1 ^ 2 * z3 * z4 + (1 / 60) * x4 * y1 * y2 * z1 ^ 2 + (1 / 120) * x4 * y1 * y2 * z1
    * z4 - (1 / 60) * x4 * y1 * y2 * z2 ^ 2 - (1 / 120) * x4 * y1 * y2 * z2 * z4 - (1 / 60) * x4 *
    y1 * y3 * z1 ^ 2 - (1 / 120) * x4 * y1 * y3 * z1 * z4 in
  let t_20 := t_19 + (1 / 60) * x4 * y1 * y3 * z3 ^ 2 + (1 / 120) * x4 * y1 * y3 * z3 * z4 - (1 /
    120) * x4 * y1 * y4 * z1 * z2 + (1 / 120) * x4 * y1 * y4 * z1 * z3 - (1 / 120) * x4 * y1 * y4 *
    z2 ^ 2 - (1 / 60) * x4 * y1 * y4 * z2 * z4 + (1 / 120) * x4 * y1 * y4 * z3 ^ 2 + (1 / 60) * x4 *
    y1 * y4 * z3 * z4 + (1 / 120) * x4 * y2 ^ 2 * z1 ^ 2 in
  let t_21 := t_20 + (1 / 60) * x4 * y2 ^ 2 * z1 * z2 + (1 / 120) * x4 * y2 ^ 2 * z1 * z4 - (1 / 60)
    * x4 * y2 ^ 2 * z2 * z3 - (1 / 120) * x4 * y2 ^ 2 * z3 ^ 2 - (1 / 120) * x4 * y2 ^ 2 * z3 * z4 +
    (1 / 60) * x4 * y2 * y3 * z2 ^ 2 + (1 / 120) * x4 * y2 * y3 * z2 * z4 - (1 / 60) * x4 * y2 * y3
    * z3 ^ 2 - (1 / 120) * x4 * y2 * y3 * z3 * z4 in
  let t_22 := t_21 + (1 / 120) * x4 * y2 * y4 * z1 ^ 2 + (1 / 120) * x4 * y2 * y4 * z1 * z2 + (1 /
    60) * x4 * y2 * y4 * z1 * z4 - (1 / 120) * x4 * y2 * y4 * z2 * z3 - (1 / 120) * x4 * y2 * y4 *
    z3 ^ 2 - (1 / 60) * x4 * y2 * y4 * z3 * z4 - (1 / 120) * x4 * y3 ^ 2 * z1 ^ 2 - (1 / 60) * x4 *
    y3 ^ 2 * z1 * z3 - (1 / 120) * x4 * y3 ^ 2 * z1 * z4 in
  let t_23 := t_22 + (1 / 120) * x4 * y3 ^ 2 * z2 ^ 2 + (1 / 60) * x4 * y3 ^ 2 * z2 * z3 + (1 / 120)
    * x4 * y3 ^ 2 * z2 * z4 - (1 / 120) * x4 * y3 * y4 * z1 ^ 2 - (1 / 120) * x4 * y3 * y4 * z1 * z3
    - (1 / 60) * x4 * y3 * y4 * z1 * z4 + (1 / 120) * x4 * y3 * y4 * z2 ^ 2 + (1 / 120) * x4 * y3 *
    y4 * z2 * z3 + (1 / 60) * x4 * y3 * y4 * z2 * z4 in
  let t_24 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  t_24 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  - (m / 20 * t_1 * t_2) - m / 20 * (y2 - y1 - t_1) * (z2 - z1 - t_2) - m / 20 * (y3 - y1 - t_1) *
    (z3 - z1 - t_2) - m / 20 * (y4 - y1 - t_1) * (z4 - z1 - t_2) - m * (y1 + t_1) * (z1 + t_2) =
    t_23 * (m / (t_24 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 -
    (1 / 6) * x3 * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 *
    z3 - (1 / 6) * x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 *
    y3 * z2)).
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 D_1.
  rational.
Qed.

(* inertia, zz *)
Theorem tetrahedron_12 :
  forall m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (x2 - x1 + (x3 - x1) + (x4 - x1)) / 4 in
  let t_2 := (y2 - y1 + (y3 - y1) + (y4 - y1)) / 4 in
  let t_3 := m / 20 * t_1 * t_1 + m / 20 * t_2 * t_2 + (m / 20 * (x2 - x1 - t_1) * (x2 - x1 - t_1) +
    m / 20 * (y2 - y1 - t_2) * (y2 - y1 - t_2)) + (m / 20 * (x3 - x1 - t_1) * (x3 - x1 - t_1) + m /
    20 * (y3 - y1 - t_2) * (y3 - y1 - t_2)) + (m / 20 * (x4 - x1 - t_1) * (x4 - x1 - t_1) + m / 20 *
    (y4 - y1 - t_2) * (y4 - y1 - t_2)) in
  let t_4 := - ((1 / 60) * x1 ^ 3 * y2 * z3) + (1 / 60) * x1 ^ 3 * y2 * z4 + (1 / 60) * x1 ^ 3 * y3
    * z2 - (1 / 60) * x1 ^ 3 * y3 * z4 - (1 / 60) * x1 ^ 3 * y4 * z2 + (1 / 60) * x1 ^ 3 * y4 * z3 +
    (1 / 60) * x1 ^ 2 * x2 * y1 * z3 - (1 / 60) * x1 ^ 2 * x2 * y1 * z4 - (1 / 60) * x1 ^ 2 * x2 *
    y2 * z3 + (1 / 60) * x1 ^ 2 * x2 * y2 * z4 - (1 / 60) * x1 ^ 2 * x2 * y3 * z1 in
  let t_5 := t_4 + (1 / 60) * x1 ^ 2 * x2 * y3 * z2 + (1 / 60) * x1 ^ 2 * x2 * y4 * z1 - (1 / 60) *
    x1 ^ 2 * x2 * y4 * z2 - (1 / 60) * x1 ^ 2 * x3 * y1 * z2 + (1 / 60) * x1 ^ 2 * x3 * y1 * z4 + (1
    / 60) * x1 ^ 2 * x3 * y2 * z1 - (1 / 60) * x1 ^ 2 * x3 * y2 * z3 + (1 / 60) * x1 ^ 2 * x3 * y3 *
    z2 - (1 / 60) * x1 ^ 2 * x3 * y3 * z4 in
  let t_6 := t_5 - (1 / 60) * x1 ^ 2 * x3 * y4 * z1 + (1 / 60) * x1 ^ 2 * x3 * y4 * z3 + (1 / 60) *
    x1 ^ 2 * x4 * y1 * z2 - (1 / 60) * x1 ^ 2 * x4 * y1 * z3 - (1 / 60) * x1 ^ 2 * x4 * y2 * z1 + (1
    / 60) * x1 ^ 2 * x4 * y2 * z4 + (1 / 60) * x1 ^ 2 * x4 * y3 * z1 - (1 / 60) * x1 ^ 2 * x4 * y3 *
    z4 - (1 / 60) * x1 ^ 2 * x4 * y4 * z2 in
  let t_7 := t_6 + (1 / 60) * x1 ^ 2 * x4 * y4 * z3 + (1 / 60) * x1 * x2 ^ 2 * y1 * z3 - (1 / 60) *
    x1 * x2 ^ 2 * y1 * z4 - (1 / 60) * x1 * x2 ^ 2 * y2 * z3 + (1 / 60) * x1 * x2 ^ 2 * y2 * z4 - (1
    / 60) * x1 * x2 ^ 2 * y3 * z1 + (1 / 60) * x1 * x2 ^ 2 * y3 * z2 + (1 / 60) * x1 * x2 ^ 2 * y4 *
    z1 - (1 / 60) * x1 * x2 ^ 2 * y4 * z2 in
  let t_8 := t_7 - (1 / 60) * x1 * x2 * x3 * y1 * z2 + (1 / 60) * x1 * x2 * x3 * y1 * z3 + (1 / 60)
    * x1 * x2 * x3 * y2 * z1 - (1 / 60) * x1 * x2 * x3 * y2 * z3 - (1 / 60) * x1 * x2 * x3 * y3 * z1
    + (1 / 60) * x1 * x2 * x3 * y3 * z2 + (1 / 60) * x1 * x2 * x4 * y1 * z2 - (1 / 60) * x1 * x2 *
    x4 * y1 * z4 - (1 / 60) * x1 * x2 * x4 * y2 * z1 in
  let t_9 := t_8 + (1 / 60) * x1 * x2 * x4 * y2 * z4 + (1 / 60) * x1 * x2 * x4 * y4 * z1 - (1 / 60)
    * x1 * x2 * x4 * y4 * z2 - (1 / 60) * x1 * x3 ^ 2 * y1 * z2 + (1 / 60) * x1 * x3 ^ 2 * y1 * z4 +
    (1 / 60) * x1 * x3 ^ 2 * y2 * z1 - (1 / 60) * x1 * x3 ^ 2 * y2 * z3 + (1 / 60) * x1 * x3 ^ 2 *
    y3 * z2 - (1 / 60) * x1 * x3 ^ 2 * y3 * z4 in
  let t_10 := t_9 - (1 / 60) * x1 * x3 ^ 2 * y4 * z1 + (1 / 60) * x1 * x3 ^ 2 * y4 * z3 - (1 / 60) *
    x1 * x3 * x4 * y1 * z3 + (1 / 60) * x1 * x3 * x4 * y1 * z4 + (1 / 60) * x1 * x3 * x4 * y3 * z1 -
    (1 / 60) * x1 * x3 * x4 * y3 * z4 - (1 / 60) * x1 * x3 * x4 * y4 * z1 + (1 / 60) * x1 * x3 * x4
    * y4 * z3 + (1 / 60) * x1 * x4 ^ 2 * y1 * z2 in
  let t_11 := t_10 - (1 / 60) * x1 * x4 ^ 2 * y1 * z3 - (1 / 60) * x1 * x4 ^ 2 * y2 * z1 + (1 / 60)
    * x1 * x4 ^ 2 * y2 * z4 + (1 / 60) * x1 * x4 ^ 2 * y3 * z1 - (1 / 60) * x1 * x4 ^ 2 * y3 * z4 -
    (1 / 60) * x1 * x4 ^ 2 * y4 * z2 + (1 / 60) * x1 * x4 ^ 2 * y4 * z3 - (1 / 60) * x1 * y1 ^ 2 *
    y2 * z3 + (1 / 60) * x1 * y1 ^ 2 * y2 * z4 in
  let t_12 := t_11 + (1 / 60) * x1 * y1 ^ 2 * y3 * z2 - (1 / 60) * x1 * y1 ^ 2 * y3 * z4 - (1 / 60)
    * x1 * y1 ^ 2 * y4 * z2 + (1 / 60) * x1 * y1 ^ 2 * y4 * z3 - (1 / 60) * x1 * y1 * y2 ^ 2 * z3 +
    (1 / 60) * x1 * y1 * y2 ^ 2 * z4 + (1 / 60) * x1 * y1 * y2 * y3 * z2 - (1 / 60) * x1 * y1 * y2 *
    y3 * z3 - (1 / 60) * x1 * y1 * y2 * y4 * z2 in
  let t_13 := t_12 + (1 / 60) * x1 * y1 * y2 * y4 * z4 + (1 / 60) * x1 * y1 * y3 ^ 2 * z2 - (1 / 60)
    * x1 * y1 * y3 ^ 2 * z4 + (1 / 60) * x1 * y1 * y3 * y4 * z3 - (1 / 60) * x1 * y1 * y3 * y4 * z4
    - (1 / 60) * x1 * y1 * y4 ^ 2 * z2 + (1 / 60) * x1 * y1 * y4 ^ 2 * z3 - (1 / 60) * x1 * y2 ^ 3 *
    z3 + (1 / 60) * x1 * y2 ^ 3 * z4 + (1 / 60) * x1 * y2 ^ 2 * y3 * z2 in
  let t_14 := t_13 - (1 / 60) * x1 * y2 ^ 2 * y3 * z3 - (1 / 60) * x1 * y2 ^ 2 * y4 * z2 + (1 / 60)
    * x1 * y2 ^ 2 * y4 * z4 + (1 / 60) * x1 * y2 * y3 ^ 2 * z2 - (1 / 60) * x1 * y2 * y3 ^ 2 * z3 -
    (1 / 60) * x1 * y2 * y4 ^ 2 * z2 + (1 / 60) * x1 * y2 * y4 ^ 2 * z4 + (1 / 60) * x1 * y3 ^ 3 *
    z2 - (1 / 60) * x1 * y3 ^ 3 * z4 + (1 / 60) * x1 * y3 ^ 2 * y4 * z3 in
  let t_15 := t_14 - (1 / 60) * x1 * y3 ^ 2 * y4 * z4 + (1 / 60) * x1 * y3 * y4 ^ 2 * z3 - (1 / 60)
    * x1 * y3 * y4 ^ 2 * z4 - (1 / 60) * x1 * y4 ^ 3 * z2 + (1 / 60) * x1 * y4 ^ 3 * z3 + (1 / 60) *
    x2 ^ 3 * y1 * z3 - (1 / 60) * x2 ^ 3 * y1 * z4 - (1 / 60) * x2 ^ 3 * y3 * z1 + (1 / 60) * x2 ^ 3
    * y3 * z4 + (1 / 60) * x2 ^ 3 * y4 * z1 - (1 / 60) * x2 ^ 3 * y4 * z3 in
  let t_16 := t_15 - (1 / 60) * x2 ^ 2 * x3 * y1 * z2 + (1 / 60) * x2 ^ 2 * x3 * y1 * z3 + (1 / 60)
    * x2 ^ 2 * x3 * y2 * z1 - (1 / 60) * x2 ^ 2 * x3 * y2 * z4 - (1 / 60) * x2 ^ 2 * x3 * y3 * z1 +
    (1 / 60) * x2 ^ 2 * x3 * y3 * z4 + (1 / 60) * x2 ^ 2 * x3 * y4 * z2 - (1 / 60) * x2 ^ 2 * x3 *
    y4 * z3 + (1 / 60) * x2 ^ 2 * x4 * y1 * z2 in
  let t_17 := t_16 - (1 / 60) * x2 ^ 2 * x4 * y1 * z4 - (1 / 60) * x2 ^ 2 * x4 * y2 * z1 + (1 / 60)
    * x2 ^ 2 * x4 * y2 * z3 - (1 / 60) * x2 ^ 2 * x4 * y3 * z2 + (1 / 60) * x2 ^ 2 * x4 * y3 * z4 +
    (1 / 60) * x2 ^ 2 * x4 * y4 * z1 - (1 / 60) * x2 ^ 2 * x4 * y4 * z3 - (1 / 60) * x2 * x3 ^ 2 *
    y1 * z2 + (1 / 60) * x2 * x3 ^ 2 * y1 * z3 in
  let t_18 := t_17 + (1 / 60) * x2 * x3 ^ 2 * y2 * z1 - (1 / 60) * x2 * x3 ^ 2 * y2 * z4 - (1 / 60)
    * x2 * x3 ^ 2 * y3 * z1 + (1 / 60) * x2 * x3 ^ 2 * y3 * z4 + (1 / 60) * x2 * x3 ^ 2 * y4 * z2 -
    (1 / 60) * x2 * x3 ^ 2 * y4 * z3 + (1 / 60) * x2 * x3 * x4 * y2 * z3 - (1 / 60) * x2 * x3 * x4 *
    y2 * z4 - (1 / 60) * x2 * x3 * x4 * y3 * z2 in
  let t_19 := t_18 + (1 / 60) * x2 * x3 * x4 * y3 * z4 + (1 / 60) * x2 * x3 * x4 * y4 * z2 - (1 /
    60) * x2 * x3 * x4 * y4 * z3 + (1 / 60) * x2 * x4 ^ 2 * y1 * z2 - (1 / 60) * x2 * x4 ^ 2 * y1 *
    z4 - (1 / 60) * x2 * x4 ^ 2 * y2 * z1 + (1 / 60) * x2 * x4 ^ 2 * y2 * z3 - (1 / 60) * x2 * x4 ^
    2 * y3 * z2 + (1 / 60) * x2 * x4 ^ 2 * y3 * z4 in
  let t_20 := t_19 + (1 / 60) * x2 * x4 ^ 2 * y4 * z1 - (1 / 60) * x2 * x4 ^ 2 * y4 * z3 + (1 / 60)
    * x2 * y1 ^ 3 * z3 - (1 / 60) * x2 * y1 ^ 3 * z4 + (1 / 60) * x2 * y1 ^ 2 * y2 * z3 - (1 / 60) *
    x2 * y1 ^ 2 * y2 * z4 - (1 / 60) * x2 * y1 ^ 2 * y3 * z1 + (1 / 60) * x2 * y1 ^ 2 * y3 * z3 + (1
    / 60) * x2 * y1 ^ 2 * y4 * z1 - (1 / 60) * x2 * y1 ^ 2 * y4 * z4 in
  let t_21 := t_20 + (1 / 60) * x2 * y1 * y2 ^ 2 * z3 - (1 / 60) * x2 * y1 * y2 ^ 2 * z4 - (1 / 60)
    * x2 * y1 * y2 * y3 * z1 + (1 / 60) * x2 * y1 * y2 * y3 * z3 + (1 / 60) * x2 * y1 * y2 * y4 * z1
    - (1 / 60) * x2 * y1 * y2 * y4 * z4 - (1 / 60) * x2 * y1 * y3 ^ 2 * z1 + (1 / 60) * x2 * y1 * y3
    ^ 2 * z3 + (1 / 60) * x2 * y1 * y4 ^ 2 * z1 in
  let t_22 := t_21 - (1 / 60) * x2 * y1 * y4 ^ 2 * z4 - (1 / 60) * x2 * y2 ^ 2 * y3 * z1 + (1 / 60)
    * x2 * y2 ^ 2 * y3 * z4 + (1 / 60) * x2 * y2 ^ 2 * y4 * z1 - (1 / 60) * x2 * y2 ^ 2 * y4 * z3 -
    (1 / 60) * x2 * y2 * y3 ^ 2 * z1 + (1 / 60) * x2 * y2 * y3 ^ 2 * z4 - (1 / 60) * x2 * y2 * y3 *
    y4 * z3 + (1 / 60) * x2 * y2 * y3 * y4 * z4 in
  let t_23 := t_22 + (1 / 60) * x2 * y2 * y4 ^ 2 * z1 - (1 / 60) * x2 * y2 * y4 ^ 2 * z3 - (1 / 60)
    * x2 * y3 ^ 3 * z1 + (1 / 60) * x2 * y3 ^ 3 * z4 - (1 / 60) * x2 * y3 ^ 2 * y4 * z3 + (1 / 60) *
    x2 * y3 ^ 2 * y4 * z4 - (1 / 60) * x2 * y3 * y4 ^ 2 * z3 + (1 / 60) * x2 * y3 * y4 ^ 2 * z4 + (1
    / 60) * x2 * y4 ^ 3 * z1 - (1 / 60) * x2 * y4 ^ 3 * z3 in
  let t_24 := t_23 - (1 / 60) * x3 ^ 3 * y1 * z2 + (1 / 60) * x3 ^ 3 * y1 * z4 + (1 / 60) * x3 ^ 3 *
    y2 * z1 - (1 / 60) * x3 ^ 3 * y2 * z4 - (1 / 60) * x3 ^ 3 * y4 * z1 + (1 / 60) * x3 ^ 3 * y4 *
    z2 - (1 / 60) * x3 ^ 2 * x4 * y1 * z3 + (1 / 60) * x3 ^ 2 * x4 * y1 * z4 + (1 / 60) * x3 ^ 2 *
    x4 * y2 * z3 - (1 / 60) * x3 ^ 2 * x4 * y2 * z4 + (1 / 60) * x3 ^ 2 * x4 * y3 * z1 in
  let t_25 := t_24 - (1 / 60) * x3 ^ 2 * x4 * y3 * z2 - (1 / 60) * x3 ^ 2 * x4 * y4 * z1 + (1 / 60)
    * x3 ^ 2 * x4 * y4 * z2 - (1 / 60) * x3 * x4 ^ 2 * y1 * z3 + (1 / 60) * x3 * x4 ^ 2 * y1 * z4 +
    (1 / 60) * x3 * x4 ^ 2 * y2 * z3 - (1 / 60) * x3 * x4 ^ 2 * y2 * z4 + (1 / 60) * x3 * x4 ^ 2 *
    y3 * z1 - (1 / 60) * x3 * x4 ^ 2 * y3 * z2 in
  let t_26 := t_25 - (1 / 60) * x3 * x4 ^ 2 * y4 * z1 + (1 / 60) * x3 * x4 ^ 2 * y4 * z2 - (1 / 60)
    * x3 * y1 ^ 3 * z2 + (1 / 60) * x3 * y1 ^ 3 * z4 + (1 / 60) * x3 * y1 ^ 2 * y2 * z1 - (1 / 60) *
    x3 * y1 ^ 2 * y2 * z2 - (1 / 60) * x3 * y1 ^ 2 * y3 * z2 + (1 / 60) * x3 * y1 ^ 2 * y3 * z4 - (1
    / 60) * x3 * y1 ^ 2 * y4 * z1 + (1 / 60) * x3 * y1 ^ 2 * y4 * z4 in
  let t_27 := t_26 + (1 / 60) * x3 * y1 * y2 ^ 2 * z1 - (1 / 60) * x3 * y1 * y2 ^ 2 * z2 + (1 / 60)
    * x3 * y1 * y2 * y3 * z1 - (1 / 60) * x3 * y1 * y2 * y3 * z2 - (1 / 60) * x3 * y1 * y3 ^ 2 * z2
    + (1 / 60) * x3 * y1 * y3 ^ 2 * z4 - (1 / 60) * x3 * y1 * y3 * y4 * z1 + (1 / 60) * x3 * y1 * y3
    * y4 * z4 - (1 / 60) * x3 * y1 * y4 ^ 2 * z1 in
  let t_28 := t_27 + (1 / 60) * x3 * y1 * y4 ^ 2 * z4 + (1 / 60) * x3 * y2 ^ 3 * z1 - (1 / 60) * x3
    * y2 ^ 3 * z4 + (1 / 60) * x3 * y2 ^ 2 * y3 * z1 - (1 / 60) * x3 * y2 ^ 2 * y3 * z4 + (1 / 60) *
    x3 * y2 ^ 2 * y4 * z2 - (1 / 60) * x3 * y2 ^ 2 * y4 * z4 + (1 / 60) * x3 * y2 * y3 ^ 2 * z1 - (1
    / 60) * x3 * y2 * y3 ^ 2 * z4 + (1 / 60) * x3 * y2 * y3 * y4 * z2 in
  let t_29 := t_28 - (1 / 60) * x3 * y2 * y3 * y4 * z4 + (1 / 60) * x3 * y2 * y4 ^ 2 * z2 - (1 / 60)
    * x3 * y2 * y4 ^ 2 * z4 - (1 / 60) * x3 * y3 ^ 2 * y4 * z1 + (1 / 60) * x3 * y3 ^ 2 * y4 * z2 -
    (1 / 60) * x3 * y3 * y4 ^ 2 * z1 + (1 / 60) * x3 * y3 * y4 ^ 2 * z2 - (1 / 60) * x3 * y4 ^ 3 *
    z1 + (1 / 60) * x3 * y4 ^ 3 * z2 + (1 / 60) * x4 ^ 3 * y1 * z2 in
  let t_30 := t_29 - (1 / 60) * x4 ^ 3 * y1 * z3 - (1 / 60) * x4 ^ 3 * y2 * z1 + (1 / 60) * x4 ^ 3 *
    y2 * z3 + (1 / 60) * x4 ^ 3 * y3 * z1 - (1 / 60) * x4 ^ 3 * y3 * z2 + (1 / 60) * x4 * y1 ^ 3 *
    z2 - (1 / 60) * x4 * y1 ^ 3 * z3 - (1 / 60) * x4 * y1 ^ 2 * y2 * z1 + (1 / 60) * x4 * y1 ^ 2 *
    y2 * z2 + (1 / 60) * x4 * y1 ^ 2 * y3 * z1 - (1 / 60) * x4 * y1 ^ 2 * y3 * z3 in
  let t_31 := t_30 + (1 / 60) * x4 * y1 ^ 2 * y4 * z2 - (1 / 60) * x4 * y1 ^ 2 * y4 * z3 - (1 / 60)
    * x4 * y1 * y2 ^ 2 * z1 + (1 / 60) * x4 * y1 * y2 ^ 2 * z2 - (1 / 60) * x4 * y1 * y2 * y4 * z1 +
    (1 / 60) * x4 * y1 * y2 * y4 * z2 + (1 / 60) * x4 * y1 * y3 ^ 2 * z1 - (1 / 60) * x4 * y1 * y3 ^
    2 * z3 + (1 / 60) * x4 * y1 * y3 * y4 * z1 in
  let t_32 := t_31 - (1 / 60) * x4 * y1 * y3 * y4 * z3 + (1 / 60) * x4 * y1 * y4 ^ 2 * z2 - (1 / 60)
    * x4 * y1 * y4 ^ 2 * z3 - (1 / 60) * x4 * y2 ^ 3 * z1 + (1 / 60) * x4 * y2 ^ 3 * z3 - (1 / 60) *
    x4 * y2 ^ 2 * y3 * z2 + (1 / 60) * x4 * y2 ^ 2 * y3 * z3 - (1 / 60) * x4 * y2 ^ 2 * y4 * z1 + (1
    / 60) * x4 * y2 ^ 2 * y4 * z3 - (1 / 60) * x4 * y2 * y3 ^ 2 * z2 in
  let t_33 := t_32 + (1 / 60) * x4 * y2 * y3 ^ 2 * z3 - (1 / 60) * x4 * y2 * y3 * y4 * z2 + (1 / 60)
    * x4 * y2 * y3 * y4 * z3 - (1 / 60) * x4 * y2 * y4 ^ 2 * z1 + (1 / 60) * x4 * y2 * y4 ^ 2 * z3 +
    (1 / 60) * x4 * y3 ^ 3 * z1 - (1 / 60) * x4 * y3 ^ 3 * z2 + (1 / 60) * x4 * y3 ^ 2 * y4 * z1 -
    (1 / 60) * x4 * y3 ^ 2 * y4 * z2 + (1 / 60) * x4 * y3 * y4 ^ 2 * z1 in
  let t_34 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_35 := (t_33 - (1 / 60) * x4 * y3 * y4 ^ 2 * z2) * (m / (t_34 + (1 / 6) * x3 * y1 * z4 + (1 /
    6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 * y4 * z1 + (1 / 6) * x3 * y4 * z2 +
    (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) * x4 * y2 * z1 + (1 / 6) * x4 * y2 *
    z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2)) in
  t_34 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 ->
  t_3 + (m * (x1 + t_1) * (x1 + t_1) + m * (y1 + t_2) * (y1 + t_2)) = t_35.
Proof.
  intros m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12
    t_13 t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31
    t_32 t_33 t_34 t_35 D_1.
  rational.
Qed.

(* With a twentieth becomes a quarter, as if all mass sat at the corners. *)

(* inertia, xx *)
Theorem tetrahedron_mutant_1 :
  exists m x1 x2 x3 x4 y1 y2 y3 y4 z1 z2 z3 z4 : R,
  let t_1 := (y2 - y1 + (y3 - y1) + (y4 - y1)) / 4 in
  let t_2 := (z2 - z1 + (z3 - z1) + (z4 - z1)) / 4 in
  let t_3 := m / 20 * t_1 * t_1 + m / 20 * t_2 * t_2 + (m / 20 * (y2 - y1 - t_1) * (y2 - y1 - t_1) +
    m / 20 * (z2 - z1 - t_2) * (z2 - z1 - t_2)) + (m / 20 * (y3 - y1 - t_1) * (y3 - y1 - t_1) + m /
    20 * (z3 - z1 - t_2) * (z3 - z1 - t_2)) + (m / 20 * (y4 - y1 - t_1) * (y4 - y1 - t_1) + m / 20 *
    (z4 - z1 - t_2) * (z4 - z1 - t_2)) in
  let t_4 := - ((1 / 60) * x1 * y1 ^ 2 * y2 * z3) + (1 / 60) * x1 * y1 ^ 2 * y2 * z4 + (1 / 60) * x1
    * y1 ^ 2 * y3 * z2 - (1 / 60) * x1 * y1 ^ 2 * y3 * z4 - (1 / 60) * x1 * y1 ^ 2 * y4 * z2 + (1 /
    60) * x1 * y1 ^ 2 * y4 * z3 - (1 / 60) * x1 * y1 * y2 ^ 2 * z3 + (1 / 60) * x1 * y1 * y2 ^ 2 *
    z4 + (1 / 60) * x1 * y1 * y2 * y3 * z2 in
  let t_5 := t_4 - (1 / 60) * x1 * y1 * y2 * y3 * z3 - (1 / 60) * x1 * y1 * y2 * y4 * z2 + (1 / 60)
    * x1 * y1 * y2 * y4 * z4 + (1 / 60) * x1 * y1 * y3 ^ 2 * z2 - (1 / 60) * x1 * y1 * y3 ^ 2 * z4 +
    (1 / 60) * x1 * y1 * y3 * y4 * z3 - (1 / 60) * x1 * y1 * y3 * y4 * z4 - (1 / 60) * x1 * y1 * y4
    ^ 2 * z2 + (1 / 60) * x1 * y1 * y4 ^ 2 * z3 in
  let t_6 := t_5 - (1 / 60) * x1 * y2 ^ 3 * z3 + (1 / 60) * x1 * y2 ^ 3 * z4 + (1 / 60) * x1 * y2 ^
    2 * y3 * z2 - (1 / 60) * x1 * y2 ^ 2 * y3 * z3 - (1 / 60) * x1 * y2 ^ 2 * y4 * z2 + (1 / 60) *
    x1 * y2 ^ 2 * y4 * z4 + (1 / 60) * x1 * y2 * y3 ^ 2 * z2 - (1 / 60) * x1 * y2 * y3 ^ 2 * z3 - (1
    / 60) * x1 * y2 * y4 ^ 2 * z2 + (1 / 60) * x1 * y2 * y4 ^ 2 * z4 in
  let t_7 := t_6 - (1 / 60) * x1 * y2 * z1 ^ 2 * z3 + (1 / 60) * x1 * y2 * z1 ^ 2 * z4 - (1 / 60) *
    x1 * y2 * z1 * z2 * z3 + (1 / 60) * x1 * y2 * z1 * z2 * z4 - (1 / 60) * x1 * y2 * z1 * z3 ^ 2 +
    (1 / 60) * x1 * y2 * z1 * z4 ^ 2 - (1 / 60) * x1 * y2 * z2 ^ 2 * z3 + (1 / 60) * x1 * y2 * z2 ^
    2 * z4 - (1 / 60) * x1 * y2 * z2 * z3 ^ 2 in
  let t_8 := t_7 + (1 / 60) * x1 * y2 * z2 * z4 ^ 2 - (1 / 60) * x1 * y2 * z3 ^ 3 + (1 / 60) * x1 *
    y2 * z4 ^ 3 + (1 / 60) * x1 * y3 ^ 3 * z2 - (1 / 60) * x1 * y3 ^ 3 * z4 + (1 / 60) * x1 * y3 ^ 2
    * y4 * z3 - (1 / 60) * x1 * y3 ^ 2 * y4 * z4 + (1 / 60) * x1 * y3 * y4 ^ 2 * z3 - (1 / 60) * x1
    * y3 * y4 ^ 2 * z4 + (1 / 60) * x1 * y3 * z1 ^ 2 * z2 in
  let t_9 := t_8 - (1 / 60) * x1 * y3 * z1 ^ 2 * z4 + (1 / 60) * x1 * y3 * z1 * z2 ^ 2 + (1 / 60) *
    x1 * y3 * z1 * z2 * z3 - (1 / 60) * x1 * y3 * z1 * z3 * z4 - (1 / 60) * x1 * y3 * z1 * z4 ^ 2 +
    (1 / 60) * x1 * y3 * z2 ^ 3 + (1 / 60) * x1 * y3 * z2 ^ 2 * z3 + (1 / 60) * x1 * y3 * z2 * z3 ^
    2 - (1 / 60) * x1 * y3 * z3 ^ 2 * z4 in
  let t_10 := t_9 - (1 / 60) * x1 * y3 * z3 * z4 ^ 2 - (1 / 60) * x1 * y3 * z4 ^ 3 - (1 / 60) * x1 *
    y4 ^ 3 * z2 + (1 / 60) * x1 * y4 ^ 3 * z3 - (1 / 60) * x1 * y4 * z1 ^ 2 * z2 + (1 / 60) * x1 *
    y4 * z1 ^ 2 * z3 - (1 / 60) * x1 * y4 * z1 * z2 ^ 2 - (1 / 60) * x1 * y4 * z1 * z2 * z4 + (1 /
    60) * x1 * y4 * z1 * z3 ^ 2 + (1 / 60) * x1 * y4 * z1 * z3 * z4 in
  let t_11 := t_10 - (1 / 60) * x1 * y4 * z2 ^ 3 - (1 / 60) * x1 * y4 * z2 ^ 2 * z4 - (1 / 60) * x1
    * y4 * z2 * z4 ^ 2 + (1 / 60) * x1 * y4 * z3 ^ 3 + (1 / 60) * x1 * y4 * z3 ^ 2 * z4 + (1 / 60) *
    x1 * y4 * z3 * z4 ^ 2 + (1 / 60) * x2 * y1 ^ 3 * z3 - (1 / 60) * x2 * y1 ^ 3 * z4 + (1 / 60) *
    x2 * y1 ^ 2 * y2 * z3 - (1 / 60) * x2 * y1 ^ 2 * y2 * z4 in
  let t_12 := t_11 - (1 / 60) * x2 * y1 ^ 2 * y3 * z1 + (1 / 60) * x2 * y1 ^ 2 * y3 * z3 + (1 / 60)
    * x2 * y1 ^ 2 * y4 * z1 - (1 / 60) * x2 * y1 ^ 2 * y4 * z4 + (1 / 60) * x2 * y1 * y2 ^ 2 * z3 -
    (1 / 60) * x2 * y1 * y2 ^ 2 * z4 - (1 / 60) * x2 * y1 * y2 * y3 * z1 + (1 / 60) * x2 * y1 * y2 *
    y3 * z3 + (1 / 60) * x2 * y1 * y2 * y4 * z1 in
  let t_13 := t_12 - (1 / 60) * x2 * y1 * y2 * y4 * z4 - (1 / 60) * x2 * y1 * y3 ^ 2 * z1 + (1 / 60)
    * x2 * y1 * y3 ^ 2 * z3 + (1 / 60) * x2 * y1 * y4 ^ 2 * z1 - (1 / 60) * x2 * y1 * y4 ^ 2 * z4 +
    (1 / 60) * x2 * y1 * z1 ^ 2 * z3 - (1 / 60) * x2 * y1 * z1 ^ 2 * z4 + (1 / 60) * x2 * y1 * z1 *
    z2 * z3 - (1 / 60) * x2 * y1 * z1 * z2 * z4 in
  let t_14 := t_13 + (1 / 60) * x2 * y1 * z1 * z3 ^ 2 - (1 / 60) * x2 * y1 * z1 * z4 ^ 2 + (1 / 60)
    * x2 * y1 * z2 ^ 2 * z3 - (1 / 60) * x2 * y1 * z2 ^ 2 * z4 + (1 / 60) * x2 * y1 * z2 * z3 ^ 2 -
    (1 / 60) * x2 * y1 * z2 * z4 ^ 2 + (1 / 60) * x2 * y1 * z3 ^ 3 - (1 / 60) * x2 * y1 * z4 ^ 3 -
    (1 / 60) * x2 * y2 ^ 2 * y3 * z1 + (1 / 60) * x2 * y2 ^ 2 * y3 * z4 in
  let t_15 := t_14 + (1 / 60) * x2 * y2 ^ 2 * y4 * z1 - (1 / 60) * x2 * y2 ^ 2 * y4 * z3 - (1 / 60)
    * x2 * y2 * y3 ^ 2 * z1 + (1 / 60) * x2 * y2 * y3 ^ 2 * z4 - (1 / 60) * x2 * y2 * y3 * y4 * z3 +
    (1 / 60) * x2 * y2 * y3 * y4 * z4 + (1 / 60) * x2 * y2 * y4 ^ 2 * z1 - (1 / 60) * x2 * y2 * y4 ^
    2 * z3 - (1 / 60) * x2 * y3 ^ 3 * z1 in
  let t_16 := t_15 + (1 / 60) * x2 * y3 ^ 3 * z4 - (1 / 60) * x2 * y3 ^ 2 * y4 * z3 + (1 / 60) * x2
    * y3 ^ 2 * y4 * z4 - (1 / 60) * x2 * y3 * y4 ^ 2 * z3 + (1 / 60) * x2 * y3 * y4 ^ 2 * z4 - (1 /
    60) * x2 * y3 * z1 ^ 3 - (1 / 60) * x2 * y3 * z1 ^ 2 * z2 - (1 / 60) * x2 * y3 * z1 ^ 2 * z3 -
    (1 / 60) * x2 * y3 * z1 * z2 ^ 2 - (1 / 60) * x2 * y3 * z1 * z2 * z3 in
  let t_17 := t_16 - (1 / 60) * x2 * y3 * z1 * z3 ^ 2 + (1 / 60) * x2 * y3 * z2 ^ 2 * z4 + (1 / 60)
    * x2 * y3 * z2 * z3 * z4 + (1 / 60) * x2 * y3 * z2 * z4 ^ 2 + (1 / 60) * x2 * y3 * z3 ^ 2 * z4 +
    (1 / 60) * x2 * y3 * z3 * z4 ^ 2 + (1 / 60) * x2 * y3 * z4 ^ 3 + (1 / 60) * x2 * y4 ^ 3 * z1 -
    (1 / 60) * x2 * y4 ^ 3 * z3 + (1 / 60) * x2 * y4 * z1 ^ 3 in
  let t_18 := t_17 + (1 / 60) * x2 * y4 * z1 ^ 2 * z2 + (1 / 60) * x2 * y4 * z1 ^ 2 * z4 + (1 / 60)
    * x2 * y4 * z1 * z2 ^ 2 + (1 / 60) * x2 * y4 * z1 * z2 * z4 + (1 / 60) * x2 * y4 * z1 * z4 ^ 2 -
    (1 / 60) * x2 * y4 * z2 ^ 2 * z3 - (1 / 60) * x2 * y4 * z2 * z3 ^ 2 - (1 / 60) * x2 * y4 * z2 *
    z3 * z4 - (1 / 60) * x2 * y4 * z3 ^ 3 in
  let t_19 := t_18 - (1 / 60) * x2 * y4 * z3 ^ 2 * z4 - (1 / 60) * x2 * y4 * z3 * z4 ^ 2 - (1 / 60)
    * x3 * y1 ^ 3 * z2 + (1 / 60) * x3 * y1 ^ 3 * z4 + (1 / 60) * x3 * y1 ^ 2 * y2 * z1 - (1 / 60) *
    x3 * y1 ^ 2 * y2 * z2 - (1 / 60) * x3 * y1 ^ 2 * y3 * z2 + (1 / 60) * x3 * y1 ^ 2 * y3 * z4 - (1
    / 60) * x3 * y1 ^ 2 * y4 * z1 + (1 / 60) * x3 * y1 ^ 2 * y4 * z4 in
  let t_20 := t_19 + (1 / 60) * x3 * y1 * y2 ^ 2 * z1 - (1 / 60) * x3 * y1 * y2 ^ 2 * z2 + (1 / 60)
    * x3 * y1 * y2 * y3 * z1 - (1 / 60) * x3 * y1 * y2 * y3 * z2 - (1 / 60) * x3 * y1 * y3 ^ 2 * z2
    + (1 / 60) * x3 * y1 * y3 ^ 2 * z4 - (1 / 60) * x3 * y1 * y3 * y4 * z1 + (1 / 60) * x3 * y1 * y3
    * y4 * z4 - (1 / 60) * x3 * y1 * y4 ^ 2 * z1 in
  let t_21 := t_20 + (1 / 60) * x3 * y1 * y4 ^ 2 * z4 - (1 / 60) * x3 * y1 * z1 ^ 2 * z2 + (1 / 60)
    * x3 * y1 * z1 ^ 2 * z4 - (1 / 60) * x3 * y1 * z1 * z2 ^ 2 - (1 / 60) * x3 * y1 * z1 * z2 * z3 +
    (1 / 60) * x3 * y1 * z1 * z3 * z4 + (1 / 60) * x3 * y1 * z1 * z4 ^ 2 - (1 / 60) * x3 * y1 * z2 ^
    3 - (1 / 60) * x3 * y1 * z2 ^ 2 * z3 in
  let t_22 := t_21 - (1 / 60) * x3 * y1 * z2 * z3 ^ 2 + (1 / 60) * x3 * y1 * z3 ^ 2 * z4 + (1 / 60)
    * x3 * y1 * z3 * z4 ^ 2 + (1 / 60) * x3 * y1 * z4 ^ 3 + (1 / 60) * x3 * y2 ^ 3 * z1 - (1 / 60) *
    x3 * y2 ^ 3 * z4 + (1 / 60) * x3 * y2 ^ 2 * y3 * z1 - (1 / 60) * x3 * y2 ^ 2 * y3 * z4 + (1 /
    60) * x3 * y2 ^ 2 * y4 * z2 - (1 / 60) * x3 * y2 ^ 2 * y4 * z4 in
  let t_23 := t_22 + (1 / 60) * x3 * y2 * y3 ^ 2 * z1 - (1 / 60) * x3 * y2 * y3 ^ 2 * z4 + (1 / 60)
    * x3 * y2 * y3 * y4 * z2 - (1 / 60) * x3 * y2 * y3 * y4 * z4 + (1 / 60) * x3 * y2 * y4 ^ 2 * z2
    - (1 / 60) * x3 * y2 * y4 ^ 2 * z4 + (1 / 60) * x3 * y2 * z1 ^ 3 + (1 / 60) * x3 * y2 * z1 ^ 2 *
    z2 + (1 / 60) * x3 * y2 * z1 ^ 2 * z3 in
  let t_24 := t_23 + (1 / 60) * x3 * y2 * z1 * z2 ^ 2 + (1 / 60) * x3 * y2 * z1 * z2 * z3 + (1 / 60)
    * x3 * y2 * z1 * z3 ^ 2 - (1 / 60) * x3 * y2 * z2 ^ 2 * z4 - (1 / 60) * x3 * y2 * z2 * z3 * z4 -
    (1 / 60) * x3 * y2 * z2 * z4 ^ 2 - (1 / 60) * x3 * y2 * z3 ^ 2 * z4 - (1 / 60) * x3 * y2 * z3 *
    z4 ^ 2 - (1 / 60) * x3 * y2 * z4 ^ 3 in
  let t_25 := t_24 - (1 / 60) * x3 * y3 ^ 2 * y4 * z1 + (1 / 60) * x3 * y3 ^ 2 * y4 * z2 - (1 / 60)
    * x3 * y3 * y4 ^ 2 * z1 + (1 / 60) * x3 * y3 * y4 ^ 2 * z2 - (1 / 60) * x3 * y4 ^ 3 * z1 + (1 /
    60) * x3 * y4 ^ 3 * z2 - (1 / 60) * x3 * y4 * z1 ^ 3 - (1 / 60) * x3 * y4 * z1 ^ 2 * z3 - (1 /
    60) * x3 * y4 * z1 ^ 2 * z4 - (1 / 60) * x3 * y4 * z1 * z3 ^ 2 in
  let t_26 := t_25 - (1 / 60) * x3 * y4 * z1 * z3 * z4 - (1 / 60) * x3 * y4 * z1 * z4 ^ 2 + (1 / 60)
    * x3 * y4 * z2 ^ 3 + (1 / 60) * x3 * y4 * z2 ^ 2 * z3 + (1 / 60) * x3 * y4 * z2 ^ 2 * z4 + (1 /
    60) * x3 * y4 * z2 * z3 ^ 2 + (1 / 60) * x3 * y4 * z2 * z3 * z4 + (1 / 60) * x3 * y4 * z2 * z4 ^
    2 + (1 / 60) * x4 * y1 ^ 3 * z2 - (1 / 60) * x4 * y1 ^ 3 * z3 in
  let t_27 := t_26 - (1 / 60) * x4 * y1 ^ 2 * y2 * z1 + (1 / 60) * x4 * y1 ^ 2 * y2 * z2 + (1 / 60)
    * x4 * y1 ^ 2 * y3 * z1 - (1 / 60) * x4 * y1 ^ 2 * y3 * z3 + (1 / 60) * x4 * y1 ^ 2 * y4 * z2 -
    (1 / 60) * x4 * y1 ^ 2 * y4 * z3 - (1 / 60) * x4 * y1 * y2 ^ 2 * z1 + (1 / 60) * x4 * y1 * y2 ^
    2 * z2 - (1 / 60) * x4 * y1 * y2 * y4 * z1 in
  let t_28 := t_27 + (1 / 60) * x4 * y1 * y2 * y4 * z2 + (1 / 60) * x4 * y1 * y3 ^ 2 * z1 - (1 / 60)
    * x4 * y1 * y3 ^ 2 * z3 + (1 / 60) * x4 * y1 * y3 * y4 * z1 - (1 / 60) * x4 * y1 * y3 * y4 * z3
    + (1 / 60) * x4 * y1 * y4 ^ 2 * z2 - (1 / 60) * x4 * y1 * y4 ^ 2 * z3 + (1 / 60) * x4 * y1 * z1
    ^ 2 * z2 - (1 / 60) * x4 * y1 * z1 ^ 2 * z3 in
  let t_29 := t_28 + (1 / 60) * x4 * y1 * z1 * z2 ^ 2 + (1 / 60) * x4 * y1 * z1 * z2 * z4 - (1 / 60)
    * x4 * y1 * z1 * z3 ^ 2 - (1 / 60) * x4 * y1 * z1 * z3 * z4 + (1 / 60) * x4 * y1 * z2 ^ 3 + (1 /
    60) * x4 * y1 * z2 ^ 2 * z4 + (1 / 60) * x4 * y1 * z2 * z4 ^ 2 - (1 / 60) * x4 * y1 * z3 ^ 3 -
    (1 / 60) * x4 * y1 * z3 ^ 2 * z4 - (1 / 60) * x4 * y1 * z3 * z4 ^ 2 in
  let t_30 := t_29 - (1 / 60) * x4 * y2 ^ 3 * z1 + (1 / 60) * x4 * y2 ^ 3 * z3 - (1 / 60) * x4 * y2
    ^ 2 * y3 * z2 + (1 / 60) * x4 * y2 ^ 2 * y3 * z3 - (1 / 60) * x4 * y2 ^ 2 * y4 * z1 + (1 / 60) *
    x4 * y2 ^ 2 * y4 * z3 - (1 / 60) * x4 * y2 * y3 ^ 2 * z2 + (1 / 60) * x4 * y2 * y3 ^ 2 * z3 - (1
    / 60) * x4 * y2 * y3 * y4 * z2 + (1 / 60) * x4 * y2 * y3 * y4 * z3 in
  let t_31 := t_30 - (1 / 60) * x4 * y2 * y4 ^ 2 * z1 + (1 / 60) * x4 * y2 * y4 ^ 2 * z3 - (1 / 60)
    * x4 * y2 * z1 ^ 3 - (1 / 60) * x4 * y2 * z1 ^ 2 * z2 - (1 / 60) * x4 * y2 * z1 ^ 2 * z4 - (1 /
    60) * x4 * y2 * z1 * z2 ^ 2 - (1 / 60) * x4 * y2 * z1 * z2 * z4 - (1 / 60) * x4 * y2 * z1 * z4 ^
    2 + (1 / 60) * x4 * y2 * z2 ^ 2 * z3 + (1 / 60) * x4 * y2 * z2 * z3 ^ 2 in
  let t_32 := t_31 + (1 / 60) * x4 * y2 * z2 * z3 * z4 + (1 / 60) * x4 * y2 * z3 ^ 3 + (1 / 60) * x4
    * y2 * z3 ^ 2 * z4 + (1 / 60) * x4 * y2 * z3 * z4 ^ 2 + (1 / 60) * x4 * y3 ^ 3 * z1 - (1 / 60) *
    x4 * y3 ^ 3 * z2 + (1 / 60) * x4 * y3 ^ 2 * y4 * z1 - (1 / 60) * x4 * y3 ^ 2 * y4 * z2 + (1 /
    60) * x4 * y3 * y4 ^ 2 * z1 - (1 / 60) * x4 * y3 * y4 ^ 2 * z2 in
  let t_33 := t_32 + (1 / 60) * x4 * y3 * z1 ^ 3 + (1 / 60) * x4 * y3 * z1 ^ 2 * z3 + (1 / 60) * x4
    * y3 * z1 ^ 2 * z4 + (1 / 60) * x4 * y3 * z1 * z3 ^ 2 + (1 / 60) * x4 * y3 * z1 * z3 * z4 + (1 /
    60) * x4 * y3 * z1 * z4 ^ 2 - (1 / 60) * x4 * y3 * z2 ^ 3 - (1 / 60) * x4 * y3 * z2 ^ 2 * z3 -
    (1 / 60) * x4 * y3 * z2 ^ 2 * z4 - (1 / 60) * x4 * y3 * z2 * z3 ^ 2 in
  let t_34 := - ((1 / 6) * x1 * y2 * z3) + (1 / 6) * x1 * y2 * z4 + (1 / 6) * x1 * y3 * z2 - (1 / 6)
    * x1 * y3 * z4 - (1 / 6) * x1 * y4 * z2 + (1 / 6) * x1 * y4 * z3 + (1 / 6) * x2 * y1 * z3 - (1 /
    6) * x2 * y1 * z4 - (1 / 6) * x2 * y3 * z1 + (1 / 6) * x2 * y3 * z4 + (1 / 6) * x2 * y4 * z1 -
    (1 / 6) * x2 * y4 * z3 - (1 / 6) * x3 * y1 * z2 in
  let t_35 := (t_33 - (1 / 60) * x4 * y3 * z2 * z3 * z4 - (1 / 60) * x4 * y3 * z2 * z4 ^ 2) * (m /
    (t_34 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3
    * y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2)) in
  t_34 + (1 / 6) * x3 * y1 * z4 + (1 / 6) * x3 * y2 * z1 - (1 / 6) * x3 * y2 * z4 - (1 / 6) * x3 *
    y4 * z1 + (1 / 6) * x3 * y4 * z2 + (1 / 6) * x4 * y1 * z2 - (1 / 6) * x4 * y1 * z3 - (1 / 6) *
    x4 * y2 * z1 + (1 / 6) * x4 * y2 * z3 + (1 / 6) * x4 * y3 * z1 - (1 / 6) * x4 * y3 * z2 <> 0 /\
  t_3 * 5 + (m * (y1 + t_1) * (y1 + t_1) + m * (z1 + t_2) * (z1 + t_2)) <> t_35.
Proof.
  exists (625 / 1521), 153, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6, (-2).
  intros t_1; cut_to t_1 (-1) computed.
  intros t_2; cut_to t_2 (-9 / 4) computed.
  intros t_3; cut_to t_3 (20375 / 24336) computed.
  intros t_4; cut_to t_4 (-714) computed.
  intros t_5; cut_to t_5 (-2448 / 5) computed.
  intros t_6; cut_to t_6 (-9486 / 5) computed.
  intros t_7; cut_to t_7 (-30294 / 5) computed.
  intros t_8; cut_to t_8 (-64413 / 10) computed.
  intros t_9; cut_to t_9 (-18972 / 5) computed.
  intros t_10; cut_to t_10 (-13566 / 5) computed.
  intros t_11; cut_to t_11 (-1942) computed.
  intros t_12; cut_to t_12 (-9889 / 5) computed.
  intros t_13; cut_to t_13 (-10218 / 5) computed.
  intros t_14; cut_to t_14 (-42603 / 20) computed.
  intros t_15; cut_to t_15 (-8421 / 4) computed.
  intros t_16; cut_to t_16 (-10149 / 5) computed.
  intros t_17; cut_to t_17 (-20029 / 10) computed.
  intros t_18; cut_to t_18 (-19761 / 10) computed.
  intros t_19; cut_to t_19 (-19897 / 10) computed.
  intros t_20; cut_to t_20 (-59779 / 30) computed.
  intros t_21; cut_to t_21 (-60299 / 30) computed.
  intros t_22; cut_to t_22 (-2011) computed.
  intros t_23; cut_to t_23 (-9948 / 5) computed.
  intros t_24; cut_to t_24 (-9863 / 5) computed.
  intros t_25; cut_to t_25 (-1988) computed.
  intros t_26; cut_to t_26 (-30208 / 15) computed.
  intros t_27; cut_to t_27 (-10389 / 5) computed.
  intros t_28; cut_to t_28 (-6400 / 3) computed.
  intros t_29; cut_to t_29 (-2264) computed.
  intros t_30; cut_to t_30 (-44503 / 20) computed.
  intros t_31; cut_to t_31 (-22409 / 10) computed.
  intros t_32; cut_to t_32 (-43411 / 20) computed.
  intros t_33; cut_to t_33 (-10382 / 5) computed.
  intros t_34; cut_to t_34 (-647 / 6) computed.
  intros t_35; cut_to t_35 (3875 / 507) computed.
  split; [computed | ]. computed.
Qed.


(** mesh-of-a-box: The mesh formula on the twelve triangles of a box with any sides, standing anywhere, gives that box, whatever point it counts from. *)

(* volume *)
Theorem mesh_of_a_box_1 :
  forall a b c u v w x y z : R,
  let t_1 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) + ((x
    - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z) * (x - x) -
    (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x))) in
  let t_2 := t_1 + ((x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) *
    ((z - z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) *
    (y + b - y) - (y + b - y) * (x + a - (x + a)))) + ((x + a - u) * ((y + b - y) * (z + c - z) - (z
    + c - z) * (y - y)) + (y - v) * ((z + c - z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c -
    z)) + (z - w) * ((x + a - (x + a)) * (y - y) - (y + b - y) * (x + a - (x + a)))) in
  let t_3 := t_2 + ((x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x
    + a - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a -
    x))) + ((x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) * (x
    - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x))) in
  let t_4 := t_3 + ((x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) +
    (y + b - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b
    - (y + b)) - (y + b - (y + b)) * (x + a - x))) + ((x - u) * ((y + b - (y + b)) * (z - z) - (z +
    c - z) * (y + b - (y + b))) + (y + b - v) * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z))
    + (z - w) * ((x + a - x) * (y + b - (y + b)) - (y + b - (y + b)) * (x + a - x))) in
  let t_5 := t_4 + ((x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) *
    (x + a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a -
    x))) + ((x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a - x)
    - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x))) in
  let t_6 := t_5 + ((x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a
    - x) * (y + b - y) - (y - y) * (x + a - x))) + ((x - u) * ((y + b - y) * (z + c - (z + c)) - (z
    + c - (z + c)) * (y + b - y)) + (y - v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c -
    (z + c))) + (z + c - w) * ((x + a - x) * (y + b - y) - (y + b - y) * (x - x))) in
  t_6 / 6 = a * b * c.
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 .
  rational.
Qed.

(* centre, x *)
Theorem mesh_of_a_box_2 :
  forall a b c u v w x y z : R,
  let t_1 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_2 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_3 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_4 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c -
    z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_5 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_6 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) * (x
    - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_7 := (x - u + (x - u) + (x - u)) * t_1 + (x - u + (x - u) + (x - u)) * t_2 + (x + a - u + (x
    + a - u) + (x + a - u)) * t_3 + (x + a - u + (x + a - u) + (x + a - u)) * t_4 + (x - u + (x + a
    - u) + (x + a - u)) * t_5 + (x - u + (x + a - u) + (x - u)) * t_6 in
  let t_8 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_9 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b - v)
    * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_10 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_11 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_12 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_13 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_14 := t_7 + (x - u + (x - u) + (x + a - u)) * t_8 + (x - u + (x + a - u) + (x + a - u)) *
    t_9 + (x - u + (x - u) + (x + a - u)) * t_10 + (x - u + (x + a - u) + (x + a - u)) * t_11 + (x -
    u + (x + a - u) + (x + a - u)) * t_12 + (x - u + (x + a - u) + (x - u)) * t_13 in
  t_1 + t_2 + t_3 + t_4 + t_5 + t_6 + t_8 + t_9 + t_10 + t_11 + t_12 + t_13 <> 0 ->
  u + t_14 / (4 * (t_1 + t_2 + t_3 + t_4 + t_5 + t_6 + t_8 + t_9 + t_10 + t_11 + t_12 + t_13)) = x +
    a / 2.
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 D_1.
  rational.
Qed.

(* centre, y *)
Theorem mesh_of_a_box_3 :
  forall a b c u v w x y z : R,
  let t_1 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_2 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_3 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_4 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c -
    z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_5 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_6 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) * (x
    - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_7 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_8 := (y - v + (y - v) + (y + b - v)) * t_1 + (y - v + (y + b - v) + (y + b - v)) * t_2 + (y
    - v + (y + b - v) + (y + b - v)) * t_3 + (y - v + (y + b - v) + (y - v)) * t_4 + (y - v + (y -
    v) + (y - v)) * t_5 + (y - v + (y - v) + (y - v)) * t_6 + (y + b - v + (y + b - v) + (y + b -
    v)) * t_7 in
  let t_9 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b - v)
    * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_10 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_11 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_12 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_13 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_14 := (t_8 + (y + b - v + (y + b - v) + (y + b - v)) * t_9 + (y - v + (y + b - v) + (y + b -
    v)) * t_10 + (y - v + (y + b - v) + (y - v)) * t_11 + (y - v + (y - v) + (y + b - v)) * t_12 +
    (y - v + (y + b - v) + (y + b - v)) * t_13) / (4 * (t_1 + t_2 + t_3 + t_4 + t_5 + t_6 + t_7 +
    t_9 + t_10 + t_11 + t_12 + t_13)) in
  t_1 + t_2 + t_3 + t_4 + t_5 + t_6 + t_7 + t_9 + t_10 + t_11 + t_12 + t_13 <> 0 ->
  v + t_14 = y + b / 2.
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 D_1.
  rational.
Qed.

(* centre, z *)
Theorem mesh_of_a_box_4 :
  forall a b c u v w x y z : R,
  let t_1 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_2 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_3 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_4 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c -
    z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_5 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_6 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) * (x
    - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_7 := (z - w + (z + c - w) + (z + c - w)) * t_1 + (z - w + (z + c - w) + (z - w)) * t_2 + (z
    - w + (z - w) + (z + c - w)) * t_3 + (z - w + (z + c - w) + (z + c - w)) * t_4 + (z - w + (z -
    w) + (z + c - w)) * t_5 + (z - w + (z + c - w) + (z + c - w)) * t_6 in
  let t_8 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_9 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b - v)
    * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_10 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_11 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_12 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_13 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_14 := t_7 + (z - w + (z + c - w) + (z + c - w)) * t_8 + (z - w + (z + c - w) + (z - w)) *
    t_9 + (z - w + (z - w) + (z - w)) * t_10 + (z - w + (z - w) + (z - w)) * t_11 + (z + c - w + (z
    + c - w) + (z + c - w)) * t_12 + (z + c - w + (z + c - w) + (z + c - w)) * t_13 in
  t_1 + t_2 + t_3 + t_4 + t_5 + t_6 + t_8 + t_9 + t_10 + t_11 + t_12 + t_13 <> 0 ->
  w + t_14 / (4 * (t_1 + t_2 + t_3 + t_4 + t_5 + t_6 + t_8 + t_9 + t_10 + t_11 + t_12 + t_13)) = z +
    c / 2.
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 D_1.
  rational.
Qed.

(* inertia, xx *)
Theorem mesh_of_a_box_5 :
  forall a b c u v w x y z : R,
  let t_1 := x - u + (x - u) + (x - u) in
  let t_2 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_3 := x - u + (x - u) + (x - u) in
  let t_4 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_5 := x + a - u + (x + a - u) + (x + a - u) in
  let t_6 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_7 := ((x - u) * (x - u) + (x - u) * (x - u) + (x - u) * (x - u) + t_1 * t_1) * t_2 + ((x -
    u) * (x - u) + (x - u) * (x - u) + (x - u) * (x - u) + t_3 * t_3) * t_4 + ((x + a - u) * (x + a
    - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + t_5 * t_5) * t_6 in
  let t_8 := x + a - u + (x + a - u) + (x + a - u) in
  let t_9 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c -
    z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_10 := x - u + (x + a - u) + (x + a - u) in
  let t_11 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_12 := x - u + (x + a - u) + (x - u) in
  let t_13 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) *
    (x - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_14 := t_7 + ((x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a -
    u) + t_8 * t_8) * t_9 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a -
    u) + t_10 * t_10) * t_11 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x - u) * (x - u) +
    t_12 * t_12) * t_13 in
  let t_15 := x - u + (x - u) + (x + a - u) in
  let t_16 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_17 := x - u + (x + a - u) + (x + a - u) in
  let t_18 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b -
    v) * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y
    + b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_19 := x - u + (x - u) + (x + a - u) in
  let t_20 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_21 := t_14 + ((x - u) * (x - u) + (x - u) * (x - u) + (x + a - u) * (x + a - u) + t_15 *
    t_15) * t_16 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + t_17
    * t_17) * t_18 + ((x - u) * (x - u) + (x - u) * (x - u) + (x + a - u) * (x + a - u) + t_19 *
    t_19) * t_20 in
  let t_22 := x - u + (x + a - u) + (x + a - u) in
  let t_23 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_24 := x - u + (x + a - u) + (x + a - u) in
  let t_25 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_26 := x - u + (x + a - u) + (x - u) in
  let t_27 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_28 := t_21 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) +
    t_22 * t_22) * t_23 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u)
    + t_24 * t_24) * t_25 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x - u) * (x - u) +
    t_26 * t_26) * t_27 in
  let t_29 := t_2 + t_4 + t_6 + t_9 + t_11 + t_13 + t_16 + t_18 + t_20 + t_23 + t_25 + t_27 in
  let t_30 := (t_1 * t_2 + t_3 * t_4 + t_5 * t_6 + t_8 * t_9 + t_10 * t_11 + t_12 * t_13 + t_15 *
    t_16 + t_17 * t_18 + t_19 * t_20 + t_22 * t_23 + t_24 * t_25 + t_26 * t_27) / (4 * t_29) in
  let t_31 := t_28 / 120 - t_30 * t_30 * (t_29 / 6) in
  let t_32 := y - v + (y - v) + (y + b - v) in
  let t_33 := y - v + (y + b - v) + (y + b - v) in
  let t_34 := y - v + (y + b - v) + (y + b - v) in
  let t_35 := ((y - v) * (y - v) + (y - v) * (y - v) + (y + b - v) * (y + b - v) + t_32 * t_32) *
    t_2 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_33 * t_33)
    * t_4 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_34 *
    t_34) * t_6 in
  let t_36 := y - v + (y + b - v) + (y - v) in
  let t_37 := y - v + (y - v) + (y - v) in
  let t_38 := y - v + (y - v) + (y - v) in
  let t_39 := y + b - v + (y + b - v) + (y + b - v) in
  let t_40 := t_35 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y - v) * (y - v) + t_36 *
    t_36) * t_9 + ((y - v) * (y - v) + (y - v) * (y - v) + (y - v) * (y - v) + t_37 * t_37) * t_11 +
    ((y - v) * (y - v) + (y - v) * (y - v) + (y - v) * (y - v) + t_38 * t_38) * t_13 + ((y + b - v)
    * (y + b - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_39 * t_39) * t_16 in
  let t_41 := y + b - v + (y + b - v) + (y + b - v) in
  let t_42 := y - v + (y + b - v) + (y + b - v) in
  let t_43 := y - v + (y + b - v) + (y - v) in
  let t_44 := t_40 + ((y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b -
    v) + t_41 * t_41) * t_18 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b
    - v) + t_42 * t_42) * t_20 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y - v) * (y - v)
    + t_43 * t_43) * t_23 in
  let t_45 := y - v + (y - v) + (y + b - v) in
  let t_46 := y - v + (y + b - v) + (y + b - v) in
  let t_47 := (t_32 * t_2 + t_33 * t_4 + t_34 * t_6 + t_36 * t_9 + t_37 * t_11 + t_38 * t_13 + t_39
    * t_16 + t_41 * t_18 + t_42 * t_20 + t_43 * t_23 + t_45 * t_25 + t_46 * t_27) / (4 * t_29) in
  let t_48 := z - w + (z + c - w) + (z + c - w) in
  let t_49 := z - w + (z + c - w) + (z - w) in
  let t_50 := z - w + (z - w) + (z + c - w) in
  let t_51 := ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_48 *
    t_48) * t_2 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z - w) * (z - w) + t_49 * t_49)
    * t_4 + ((z - w) * (z - w) + (z - w) * (z - w) + (z + c - w) * (z + c - w) + t_50 * t_50) * t_6
    in
  let t_52 := z - w + (z + c - w) + (z + c - w) in
  let t_53 := z - w + (z - w) + (z + c - w) in
  let t_54 := z - w + (z + c - w) + (z + c - w) in
  let t_55 := t_51 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) +
    t_52 * t_52) * t_9 + ((z - w) * (z - w) + (z - w) * (z - w) + (z + c - w) * (z + c - w) + t_53 *
    t_53) * t_11 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_54
    * t_54) * t_13 in
  let t_56 := z - w + (z + c - w) + (z + c - w) in
  let t_57 := z - w + (z + c - w) + (z - w) in
  let t_58 := z - w + (z - w) + (z - w) in
  let t_59 := t_55 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) +
    t_56 * t_56) * t_16 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z - w) * (z - w) + t_57
    * t_57) * t_18 + ((z - w) * (z - w) + (z - w) * (z - w) + (z - w) * (z - w) + t_58 * t_58) *
    t_20 in
  let t_60 := z - w + (z - w) + (z - w) in
  let t_61 := z + c - w + (z + c - w) + (z + c - w) in
  let t_62 := z + c - w + (z + c - w) + (z + c - w) in
  let t_63 := t_59 + ((z - w) * (z - w) + (z - w) * (z - w) + (z - w) * (z - w) + t_60 * t_60) *
    t_23 + ((z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_61
    * t_61) * t_25 + ((z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c -
    w) + t_62 * t_62) * t_27 in
  let t_64 := (t_48 * t_2 + t_49 * t_4 + t_50 * t_6 + t_52 * t_9 + t_53 * t_11 + t_54 * t_13 + t_56
    * t_16 + t_57 * t_18 + t_58 * t_20 + t_60 * t_23 + t_61 * t_25 + t_62 * t_27) / (4 * t_29) in
  t_29 <> 0 ->
  t_31 + ((t_44 + ((y - v) * (y - v) + (y - v) * (y - v) + (y + b - v) * (y + b - v) + t_45 * t_45)
    * t_25 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_46 *
    t_46) * t_27) / 120 - t_47 * t_47 * (t_29 / 6)) + (t_63 / 120 - t_64 * t_64 * (t_29 / 6)) - t_31
    = (b * b + c * c) * (a * b * c / 12).
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31 t_32 t_33 t_34 t_35
    t_36 t_37 t_38 t_39 t_40 t_41 t_42 t_43 t_44 t_45 t_46 t_47 t_48 t_49 t_50 t_51 t_52 t_53 t_54
    t_55 t_56 t_57 t_58 t_59 t_60 t_61 t_62 t_63 t_64 D_1.
  rational.
Qed.

(* inertia, xy *)
Theorem mesh_of_a_box_6 :
  forall a b c u v w x y z : R,
  let t_1 := x - u + (x - u) + (x - u) in
  let t_2 := y - v + (y - v) + (y + b - v) in
  let t_3 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_4 := x - u + (x - u) + (x - u) in
  let t_5 := y - v + (y + b - v) + (y + b - v) in
  let t_6 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_7 := x + a - u + (x + a - u) + (x + a - u) in
  let t_8 := y - v + (y + b - v) + (y + b - v) in
  let t_9 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_10 := ((x - u) * (y - v) + (x - u) * (y - v) + (x - u) * (y + b - v) + t_1 * t_2) * t_3 +
    ((x - u) * (y - v) + (x - u) * (y + b - v) + (x - u) * (y + b - v) + t_4 * t_5) * t_6 + ((x + a
    - u) * (y - v) + (x + a - u) * (y + b - v) + (x + a - u) * (y + b - v) + t_7 * t_8) * t_9 in
  let t_11 := x + a - u + (x + a - u) + (x + a - u) in
  let t_12 := y - v + (y + b - v) + (y - v) in
  let t_13 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c
    - z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y
    - y) - (y + b - y) * (x + a - (x + a))) in
  let t_14 := x - u + (x + a - u) + (x + a - u) in
  let t_15 := y - v + (y - v) + (y - v) in
  let t_16 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_17 := x - u + (x + a - u) + (x - u) in
  let t_18 := y - v + (y - v) + (y - v) in
  let t_19 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) *
    (x - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_20 := t_10 + ((x + a - u) * (y - v) + (x + a - u) * (y + b - v) + (x + a - u) * (y - v) +
    t_11 * t_12) * t_13 + ((x - u) * (y - v) + (x + a - u) * (y - v) + (x + a - u) * (y - v) + t_14
    * t_15) * t_16 + ((x - u) * (y - v) + (x + a - u) * (y - v) + (x - u) * (y - v) + t_17 * t_18) *
    t_19 in
  let t_21 := x - u + (x - u) + (x + a - u) in
  let t_22 := y + b - v + (y + b - v) + (y + b - v) in
  let t_23 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_24 := x - u + (x + a - u) + (x + a - u) in
  let t_25 := y + b - v + (y + b - v) + (y + b - v) in
  let t_26 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b -
    v) * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y
    + b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_27 := x - u + (x - u) + (x + a - u) in
  let t_28 := y - v + (y + b - v) + (y + b - v) in
  let t_29 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_30 := t_20 + ((x - u) * (y + b - v) + (x - u) * (y + b - v) + (x + a - u) * (y + b - v) +
    t_21 * t_22) * t_23 + ((x - u) * (y + b - v) + (x + a - u) * (y + b - v) + (x + a - u) * (y + b
    - v) + t_24 * t_25) * t_26 + ((x - u) * (y - v) + (x - u) * (y + b - v) + (x + a - u) * (y + b -
    v) + t_27 * t_28) * t_29 in
  let t_31 := x - u + (x + a - u) + (x + a - u) in
  let t_32 := y - v + (y + b - v) + (y - v) in
  let t_33 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_34 := x - u + (x + a - u) + (x + a - u) in
  let t_35 := y - v + (y - v) + (y + b - v) in
  let t_36 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_37 := x - u + (x + a - u) + (x - u) in
  let t_38 := y - v + (y + b - v) + (y + b - v) in
  let t_39 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_40 := t_30 + ((x - u) * (y - v) + (x + a - u) * (y + b - v) + (x + a - u) * (y - v) + t_31 *
    t_32) * t_33 + ((x - u) * (y - v) + (x + a - u) * (y - v) + (x + a - u) * (y + b - v) + t_34 *
    t_35) * t_36 + ((x - u) * (y - v) + (x + a - u) * (y + b - v) + (x - u) * (y + b - v) + t_37 *
    t_38) * t_39 in
  let t_41 := t_3 + t_6 + t_9 + t_13 + t_16 + t_19 + t_23 + t_26 + t_29 + t_33 + t_36 + t_39 in
  let t_42 := (t_1 * t_3 + t_4 * t_6 + t_7 * t_9 + t_11 * t_13 + t_14 * t_16 + t_17 * t_19 + t_21 *
    t_23 + t_24 * t_26 + t_27 * t_29 + t_31 * t_33 + t_34 * t_36 + t_37 * t_39) / (4 * t_41) * ((t_2
    * t_3 + t_5 * t_6 + t_8 * t_9 + t_12 * t_13 + t_15 * t_16 + t_18 * t_19 + t_22 * t_23 + t_25 *
    t_26 + t_28 * t_29 + t_32 * t_33 + t_35 * t_36 + t_38 * t_39) / (4 * t_41)) in
  t_41 <> 0 ->
  - (t_40 / 120 - t_42 * (t_41 / 6)) = 0.
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31 t_32 t_33 t_34 t_35
    t_36 t_37 t_38 t_39 t_40 t_41 t_42 D_1.
  rational.
Qed.

(* inertia, yy *)
Theorem mesh_of_a_box_7 :
  forall a b c u v w x y z : R,
  let t_1 := x - u + (x - u) + (x - u) in
  let t_2 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_3 := x - u + (x - u) + (x - u) in
  let t_4 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_5 := x + a - u + (x + a - u) + (x + a - u) in
  let t_6 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_7 := ((x - u) * (x - u) + (x - u) * (x - u) + (x - u) * (x - u) + t_1 * t_1) * t_2 + ((x -
    u) * (x - u) + (x - u) * (x - u) + (x - u) * (x - u) + t_3 * t_3) * t_4 + ((x + a - u) * (x + a
    - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + t_5 * t_5) * t_6 in
  let t_8 := x + a - u + (x + a - u) + (x + a - u) in
  let t_9 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c -
    z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_10 := x - u + (x + a - u) + (x + a - u) in
  let t_11 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_12 := x - u + (x + a - u) + (x - u) in
  let t_13 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) *
    (x - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_14 := t_7 + ((x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a -
    u) + t_8 * t_8) * t_9 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a -
    u) + t_10 * t_10) * t_11 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x - u) * (x - u) +
    t_12 * t_12) * t_13 in
  let t_15 := x - u + (x - u) + (x + a - u) in
  let t_16 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_17 := x - u + (x + a - u) + (x + a - u) in
  let t_18 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b -
    v) * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y
    + b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_19 := x - u + (x - u) + (x + a - u) in
  let t_20 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_21 := t_14 + ((x - u) * (x - u) + (x - u) * (x - u) + (x + a - u) * (x + a - u) + t_15 *
    t_15) * t_16 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + t_17
    * t_17) * t_18 + ((x - u) * (x - u) + (x - u) * (x - u) + (x + a - u) * (x + a - u) + t_19 *
    t_19) * t_20 in
  let t_22 := x - u + (x + a - u) + (x + a - u) in
  let t_23 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_24 := x - u + (x + a - u) + (x + a - u) in
  let t_25 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_26 := x - u + (x + a - u) + (x - u) in
  let t_27 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_28 := t_21 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) +
    t_22 * t_22) * t_23 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u)
    + t_24 * t_24) * t_25 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x - u) * (x - u) +
    t_26 * t_26) * t_27 in
  let t_29 := t_2 + t_4 + t_6 + t_9 + t_11 + t_13 + t_16 + t_18 + t_20 + t_23 + t_25 + t_27 in
  let t_30 := (t_1 * t_2 + t_3 * t_4 + t_5 * t_6 + t_8 * t_9 + t_10 * t_11 + t_12 * t_13 + t_15 *
    t_16 + t_17 * t_18 + t_19 * t_20 + t_22 * t_23 + t_24 * t_25 + t_26 * t_27) / (4 * t_29) in
  let t_31 := y - v + (y - v) + (y + b - v) in
  let t_32 := y - v + (y + b - v) + (y + b - v) in
  let t_33 := y - v + (y + b - v) + (y + b - v) in
  let t_34 := ((y - v) * (y - v) + (y - v) * (y - v) + (y + b - v) * (y + b - v) + t_31 * t_31) *
    t_2 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_32 * t_32)
    * t_4 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_33 *
    t_33) * t_6 in
  let t_35 := y - v + (y + b - v) + (y - v) in
  let t_36 := y - v + (y - v) + (y - v) in
  let t_37 := y - v + (y - v) + (y - v) in
  let t_38 := y + b - v + (y + b - v) + (y + b - v) in
  let t_39 := t_34 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y - v) * (y - v) + t_35 *
    t_35) * t_9 + ((y - v) * (y - v) + (y - v) * (y - v) + (y - v) * (y - v) + t_36 * t_36) * t_11 +
    ((y - v) * (y - v) + (y - v) * (y - v) + (y - v) * (y - v) + t_37 * t_37) * t_13 + ((y + b - v)
    * (y + b - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_38 * t_38) * t_16 in
  let t_40 := y + b - v + (y + b - v) + (y + b - v) in
  let t_41 := y - v + (y + b - v) + (y + b - v) in
  let t_42 := y - v + (y + b - v) + (y - v) in
  let t_43 := t_39 + ((y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b -
    v) + t_40 * t_40) * t_18 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b
    - v) + t_41 * t_41) * t_20 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y - v) * (y - v)
    + t_42 * t_42) * t_23 in
  let t_44 := y - v + (y - v) + (y + b - v) in
  let t_45 := y - v + (y + b - v) + (y + b - v) in
  let t_46 := (t_31 * t_2 + t_32 * t_4 + t_33 * t_6 + t_35 * t_9 + t_36 * t_11 + t_37 * t_13 + t_38
    * t_16 + t_40 * t_18 + t_41 * t_20 + t_42 * t_23 + t_44 * t_25 + t_45 * t_27) / (4 * t_29) in
  let t_47 := (t_43 + ((y - v) * (y - v) + (y - v) * (y - v) + (y + b - v) * (y + b - v) + t_44 *
    t_44) * t_25 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_45
    * t_45) * t_27) / 120 - t_46 * t_46 * (t_29 / 6) in
  let t_48 := z - w + (z + c - w) + (z + c - w) in
  let t_49 := z - w + (z + c - w) + (z - w) in
  let t_50 := z - w + (z - w) + (z + c - w) in
  let t_51 := ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_48 *
    t_48) * t_2 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z - w) * (z - w) + t_49 * t_49)
    * t_4 + ((z - w) * (z - w) + (z - w) * (z - w) + (z + c - w) * (z + c - w) + t_50 * t_50) * t_6
    in
  let t_52 := z - w + (z + c - w) + (z + c - w) in
  let t_53 := z - w + (z - w) + (z + c - w) in
  let t_54 := z - w + (z + c - w) + (z + c - w) in
  let t_55 := t_51 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) +
    t_52 * t_52) * t_9 + ((z - w) * (z - w) + (z - w) * (z - w) + (z + c - w) * (z + c - w) + t_53 *
    t_53) * t_11 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_54
    * t_54) * t_13 in
  let t_56 := z - w + (z + c - w) + (z + c - w) in
  let t_57 := z - w + (z + c - w) + (z - w) in
  let t_58 := z - w + (z - w) + (z - w) in
  let t_59 := t_55 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) +
    t_56 * t_56) * t_16 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z - w) * (z - w) + t_57
    * t_57) * t_18 + ((z - w) * (z - w) + (z - w) * (z - w) + (z - w) * (z - w) + t_58 * t_58) *
    t_20 in
  let t_60 := z - w + (z - w) + (z - w) in
  let t_61 := z + c - w + (z + c - w) + (z + c - w) in
  let t_62 := z + c - w + (z + c - w) + (z + c - w) in
  let t_63 := t_59 + ((z - w) * (z - w) + (z - w) * (z - w) + (z - w) * (z - w) + t_60 * t_60) *
    t_23 + ((z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_61
    * t_61) * t_25 + ((z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c -
    w) + t_62 * t_62) * t_27 in
  let t_64 := (t_48 * t_2 + t_49 * t_4 + t_50 * t_6 + t_52 * t_9 + t_53 * t_11 + t_54 * t_13 + t_56
    * t_16 + t_57 * t_18 + t_58 * t_20 + t_60 * t_23 + t_61 * t_25 + t_62 * t_27) / (4 * t_29) in
  t_29 <> 0 ->
  t_28 / 120 - t_30 * t_30 * (t_29 / 6) + t_47 + (t_63 / 120 - t_64 * t_64 * (t_29 / 6)) - t_47 = (c
    * c + a * a) * (a * b * c / 12).
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31 t_32 t_33 t_34 t_35
    t_36 t_37 t_38 t_39 t_40 t_41 t_42 t_43 t_44 t_45 t_46 t_47 t_48 t_49 t_50 t_51 t_52 t_53 t_54
    t_55 t_56 t_57 t_58 t_59 t_60 t_61 t_62 t_63 t_64 D_1.
  rational.
Qed.

(* inertia, yz *)
Theorem mesh_of_a_box_8 :
  forall a b c u v w x y z : R,
  let t_1 := y - v + (y - v) + (y + b - v) in
  let t_2 := z - w + (z + c - w) + (z + c - w) in
  let t_3 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_4 := y - v + (y + b - v) + (y + b - v) in
  let t_5 := z - w + (z + c - w) + (z - w) in
  let t_6 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_7 := y - v + (y + b - v) + (y + b - v) in
  let t_8 := z - w + (z - w) + (z + c - w) in
  let t_9 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_10 := ((y - v) * (z - w) + (y - v) * (z + c - w) + (y + b - v) * (z + c - w) + t_1 * t_2) *
    t_3 + ((y - v) * (z - w) + (y + b - v) * (z + c - w) + (y + b - v) * (z - w) + t_4 * t_5) * t_6
    + ((y - v) * (z - w) + (y + b - v) * (z - w) + (y + b - v) * (z + c - w) + t_7 * t_8) * t_9 in
  let t_11 := y - v + (y + b - v) + (y - v) in
  let t_12 := z - w + (z + c - w) + (z + c - w) in
  let t_13 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c
    - z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y
    - y) - (y + b - y) * (x + a - (x + a))) in
  let t_14 := y - v + (y - v) + (y - v) in
  let t_15 := z - w + (z - w) + (z + c - w) in
  let t_16 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_17 := y - v + (y - v) + (y - v) in
  let t_18 := z - w + (z + c - w) + (z + c - w) in
  let t_19 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) *
    (x - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_20 := t_10 + ((y - v) * (z - w) + (y + b - v) * (z + c - w) + (y - v) * (z + c - w) + t_11 *
    t_12) * t_13 + ((y - v) * (z - w) + (y - v) * (z - w) + (y - v) * (z + c - w) + t_14 * t_15) *
    t_16 + ((y - v) * (z - w) + (y - v) * (z + c - w) + (y - v) * (z + c - w) + t_17 * t_18) * t_19
    in
  let t_21 := y + b - v + (y + b - v) + (y + b - v) in
  let t_22 := z - w + (z + c - w) + (z + c - w) in
  let t_23 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_24 := y + b - v + (y + b - v) + (y + b - v) in
  let t_25 := z - w + (z + c - w) + (z - w) in
  let t_26 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b -
    v) * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y
    + b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_27 := y - v + (y + b - v) + (y + b - v) in
  let t_28 := z - w + (z - w) + (z - w) in
  let t_29 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_30 := t_20 + ((y + b - v) * (z - w) + (y + b - v) * (z + c - w) + (y + b - v) * (z + c - w)
    + t_21 * t_22) * t_23 + ((y + b - v) * (z - w) + (y + b - v) * (z + c - w) + (y + b - v) * (z -
    w) + t_24 * t_25) * t_26 + ((y - v) * (z - w) + (y + b - v) * (z - w) + (y + b - v) * (z - w) +
    t_27 * t_28) * t_29 in
  let t_31 := y - v + (y + b - v) + (y - v) in
  let t_32 := z - w + (z - w) + (z - w) in
  let t_33 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_34 := y - v + (y - v) + (y + b - v) in
  let t_35 := z + c - w + (z + c - w) + (z + c - w) in
  let t_36 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_37 := y - v + (y + b - v) + (y + b - v) in
  let t_38 := z + c - w + (z + c - w) + (z + c - w) in
  let t_39 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_40 := t_30 + ((y - v) * (z - w) + (y + b - v) * (z - w) + (y - v) * (z - w) + t_31 * t_32) *
    t_33 + ((y - v) * (z + c - w) + (y - v) * (z + c - w) + (y + b - v) * (z + c - w) + t_34 * t_35)
    * t_36 + ((y - v) * (z + c - w) + (y + b - v) * (z + c - w) + (y + b - v) * (z + c - w) + t_37 *
    t_38) * t_39 in
  let t_41 := t_3 + t_6 + t_9 + t_13 + t_16 + t_19 + t_23 + t_26 + t_29 + t_33 + t_36 + t_39 in
  let t_42 := (t_1 * t_3 + t_4 * t_6 + t_7 * t_9 + t_11 * t_13 + t_14 * t_16 + t_17 * t_19 + t_21 *
    t_23 + t_24 * t_26 + t_27 * t_29 + t_31 * t_33 + t_34 * t_36 + t_37 * t_39) / (4 * t_41) * ((t_2
    * t_3 + t_5 * t_6 + t_8 * t_9 + t_12 * t_13 + t_15 * t_16 + t_18 * t_19 + t_22 * t_23 + t_25 *
    t_26 + t_28 * t_29 + t_32 * t_33 + t_35 * t_36 + t_38 * t_39) / (4 * t_41)) in
  t_41 <> 0 ->
  - (t_40 / 120 - t_42 * (t_41 / 6)) = 0.
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31 t_32 t_33 t_34 t_35
    t_36 t_37 t_38 t_39 t_40 t_41 t_42 D_1.
  rational.
Qed.

(* inertia, zz *)
Theorem mesh_of_a_box_9 :
  forall a b c u v w x y z : R,
  let t_1 := x - u + (x - u) + (x - u) in
  let t_2 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_3 := x - u + (x - u) + (x - u) in
  let t_4 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_5 := x + a - u + (x + a - u) + (x + a - u) in
  let t_6 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_7 := ((x - u) * (x - u) + (x - u) * (x - u) + (x - u) * (x - u) + t_1 * t_1) * t_2 + ((x -
    u) * (x - u) + (x - u) * (x - u) + (x - u) * (x - u) + t_3 * t_3) * t_4 + ((x + a - u) * (x + a
    - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + t_5 * t_5) * t_6 in
  let t_8 := x + a - u + (x + a - u) + (x + a - u) in
  let t_9 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c -
    z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_10 := x - u + (x + a - u) + (x + a - u) in
  let t_11 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_12 := x - u + (x + a - u) + (x - u) in
  let t_13 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) *
    (x - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_14 := t_7 + ((x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a -
    u) + t_8 * t_8) * t_9 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a -
    u) + t_10 * t_10) * t_11 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x - u) * (x - u) +
    t_12 * t_12) * t_13 in
  let t_15 := x - u + (x - u) + (x + a - u) in
  let t_16 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_17 := x - u + (x + a - u) + (x + a - u) in
  let t_18 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b -
    v) * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y
    + b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_19 := x - u + (x - u) + (x + a - u) in
  let t_20 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_21 := t_14 + ((x - u) * (x - u) + (x - u) * (x - u) + (x + a - u) * (x + a - u) + t_15 *
    t_15) * t_16 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + t_17
    * t_17) * t_18 + ((x - u) * (x - u) + (x - u) * (x - u) + (x + a - u) * (x + a - u) + t_19 *
    t_19) * t_20 in
  let t_22 := x - u + (x + a - u) + (x + a - u) in
  let t_23 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_24 := x - u + (x + a - u) + (x + a - u) in
  let t_25 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_26 := x - u + (x + a - u) + (x - u) in
  let t_27 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_28 := t_21 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) +
    t_22 * t_22) * t_23 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u)
    + t_24 * t_24) * t_25 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x - u) * (x - u) +
    t_26 * t_26) * t_27 in
  let t_29 := t_2 + t_4 + t_6 + t_9 + t_11 + t_13 + t_16 + t_18 + t_20 + t_23 + t_25 + t_27 in
  let t_30 := (t_1 * t_2 + t_3 * t_4 + t_5 * t_6 + t_8 * t_9 + t_10 * t_11 + t_12 * t_13 + t_15 *
    t_16 + t_17 * t_18 + t_19 * t_20 + t_22 * t_23 + t_24 * t_25 + t_26 * t_27) / (4 * t_29) in
  let t_31 := y - v + (y - v) + (y + b - v) in
  let t_32 := y - v + (y + b - v) + (y + b - v) in
  let t_33 := y - v + (y + b - v) + (y + b - v) in
  let t_34 := ((y - v) * (y - v) + (y - v) * (y - v) + (y + b - v) * (y + b - v) + t_31 * t_31) *
    t_2 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_32 * t_32)
    * t_4 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_33 *
    t_33) * t_6 in
  let t_35 := y - v + (y + b - v) + (y - v) in
  let t_36 := y - v + (y - v) + (y - v) in
  let t_37 := y - v + (y - v) + (y - v) in
  let t_38 := y + b - v + (y + b - v) + (y + b - v) in
  let t_39 := t_34 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y - v) * (y - v) + t_35 *
    t_35) * t_9 + ((y - v) * (y - v) + (y - v) * (y - v) + (y - v) * (y - v) + t_36 * t_36) * t_11 +
    ((y - v) * (y - v) + (y - v) * (y - v) + (y - v) * (y - v) + t_37 * t_37) * t_13 + ((y + b - v)
    * (y + b - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_38 * t_38) * t_16 in
  let t_40 := y + b - v + (y + b - v) + (y + b - v) in
  let t_41 := y - v + (y + b - v) + (y + b - v) in
  let t_42 := y - v + (y + b - v) + (y - v) in
  let t_43 := t_39 + ((y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b -
    v) + t_40 * t_40) * t_18 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b
    - v) + t_41 * t_41) * t_20 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y - v) * (y - v)
    + t_42 * t_42) * t_23 in
  let t_44 := y - v + (y - v) + (y + b - v) in
  let t_45 := y - v + (y + b - v) + (y + b - v) in
  let t_46 := (t_31 * t_2 + t_32 * t_4 + t_33 * t_6 + t_35 * t_9 + t_36 * t_11 + t_37 * t_13 + t_38
    * t_16 + t_40 * t_18 + t_41 * t_20 + t_42 * t_23 + t_44 * t_25 + t_45 * t_27) / (4 * t_29) in
  let t_47 := z - w + (z + c - w) + (z + c - w) in
  let t_48 := z - w + (z + c - w) + (z - w) in
  let t_49 := z - w + (z - w) + (z + c - w) in
  let t_50 := ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_47 *
    t_47) * t_2 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z - w) * (z - w) + t_48 * t_48)
    * t_4 + ((z - w) * (z - w) + (z - w) * (z - w) + (z + c - w) * (z + c - w) + t_49 * t_49) * t_6
    in
  let t_51 := z - w + (z + c - w) + (z + c - w) in
  let t_52 := z - w + (z - w) + (z + c - w) in
  let t_53 := z - w + (z + c - w) + (z + c - w) in
  let t_54 := t_50 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) +
    t_51 * t_51) * t_9 + ((z - w) * (z - w) + (z - w) * (z - w) + (z + c - w) * (z + c - w) + t_52 *
    t_52) * t_11 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_53
    * t_53) * t_13 in
  let t_55 := z - w + (z + c - w) + (z + c - w) in
  let t_56 := z - w + (z + c - w) + (z - w) in
  let t_57 := z - w + (z - w) + (z - w) in
  let t_58 := t_54 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) +
    t_55 * t_55) * t_16 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z - w) * (z - w) + t_56
    * t_56) * t_18 + ((z - w) * (z - w) + (z - w) * (z - w) + (z - w) * (z - w) + t_57 * t_57) *
    t_20 in
  let t_59 := z - w + (z - w) + (z - w) in
  let t_60 := z + c - w + (z + c - w) + (z + c - w) in
  let t_61 := z + c - w + (z + c - w) + (z + c - w) in
  let t_62 := t_58 + ((z - w) * (z - w) + (z - w) * (z - w) + (z - w) * (z - w) + t_59 * t_59) *
    t_23 + ((z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_60
    * t_60) * t_25 + ((z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c -
    w) + t_61 * t_61) * t_27 in
  let t_63 := (t_47 * t_2 + t_48 * t_4 + t_49 * t_6 + t_51 * t_9 + t_52 * t_11 + t_53 * t_13 + t_55
    * t_16 + t_56 * t_18 + t_57 * t_20 + t_59 * t_23 + t_60 * t_25 + t_61 * t_27) / (4 * t_29) in
  let t_64 := t_62 / 120 - t_63 * t_63 * (t_29 / 6) in
  t_29 <> 0 ->
  t_28 / 120 - t_30 * t_30 * (t_29 / 6) + ((t_43 + ((y - v) * (y - v) + (y - v) * (y - v) + (y + b -
    v) * (y + b - v) + t_44 * t_44) * t_25 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b
    - v) * (y + b - v) + t_45 * t_45) * t_27) / 120 - t_46 * t_46 * (t_29 / 6)) + t_64 - t_64 = (a *
    a + b * b) * (a * b * c / 12).
Proof.
  intros a b c u v w x y z  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13 t_14 t_15 t_16
    t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31 t_32 t_33 t_34 t_35
    t_36 t_37 t_38 t_39 t_40 t_41 t_42 t_43 t_44 t_45 t_46 t_47 t_48 t_49 t_50 t_51 t_52 t_53 t_54
    t_55 t_56 t_57 t_58 t_59 t_60 t_61 t_62 t_63 t_64 D_1.
  rational.
Qed.

(* With one triangle turned inside out. *)

(* volume *)
Theorem mesh_of_a_box_mutant_1 :
  exists a b c u v w x y z : R,
  let t_1 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) + ((x
    - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z) * (x - x) -
    (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x))) in
  let t_2 := (x + a - u) * ((y - (y + b)) * (z + c - (z + c)) - (z - (z + c)) * (y - (y + b))) + (y
    + b - v) * ((z - (z + c)) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - (z + c))) + (z + c
    - w) * ((x + a - (x + a)) * (y - (y + b)) - (y - (y + b)) * (x + a - (x + a))) in
  let t_3 := t_1 + ((x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) *
    ((z - z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) *
    (y + b - y) - (y + b - y) * (x + a - (x + a)))) + t_2 + ((x - u) * ((y - y) * (z + c - z) - (z -
    z) * (y - y)) + (y - v) * ((z - z) * (x + a - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x +
    a - x) * (y - y) - (y - y) * (x + a - x))) in
  let t_4 := t_3 + ((x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c -
    z) * (x - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x -
    x))) + ((x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b -
    v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x))) in
  let t_5 := t_4 + ((x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y +
    b - v) * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b -
    (y + b)) - (y + b - (y + b)) * (x + a - x))) + ((x - u) * ((y + b - y) * (z - z) - (z - z) * (y
    + b - y)) + (y - v) * ((z - z) * (x + a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b
    - y) - (y + b - y) * (x + a - x))) in
  let t_6 := t_5 + ((x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x
    + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a -
    x))) + ((x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x))) in
  (t_6 + ((x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x) *
    (y + b - y) - (y + b - y) * (x - x)))) / 6 <> a * b * c.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2.
  intros t_1; cut_to t_1 12 computed.
  intros t_2; cut_to t_2 24 computed.
  intros t_3; cut_to t_3 (-60) computed.
  intros t_4; cut_to t_4 (-78) computed.
  intros t_5; cut_to t_5 (-12) computed.
  intros t_6; cut_to t_6 (-30) computed.
  computed.
Qed.

(* With edges a and c swapped in the box. *)

(* inertia, xx *)
Theorem mesh_of_a_box_mutant_2 :
  exists a b c u v w x y z : R,
  let t_1 := x - u + (x - u) + (x - u) in
  let t_2 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - y) - (y - y) * (x - x)) in
  let t_3 := x - u + (x - u) + (x - u) in
  let t_4 := (x - u) * ((y + b - y) * (z - z) - (z + c - z) * (y + b - y)) + (y - v) * ((z + c - z)
    * (x - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_5 := x + a - u + (x + a - u) + (x + a - u) in
  let t_6 := (x + a - u) * ((y + b - y) * (z + c - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z)
    * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y + b -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_7 := ((x - u) * (x - u) + (x - u) * (x - u) + (x - u) * (x - u) + t_1 * t_1) * t_2 + ((x -
    u) * (x - u) + (x - u) * (x - u) + (x - u) * (x - u) + t_3 * t_3) * t_4 + ((x + a - u) * (x + a
    - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + t_5 * t_5) * t_6 in
  let t_8 := x + a - u + (x + a - u) + (x + a - u) in
  let t_9 := (x + a - u) * ((y + b - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c -
    z) * (x + a - (x + a)) - (x + a - (x + a)) * (z + c - z)) + (z - w) * ((x + a - (x + a)) * (y -
    y) - (y + b - y) * (x + a - (x + a))) in
  let t_10 := x - u + (x + a - u) + (x + a - u) in
  let t_11 := (x - u) * ((y - y) * (z + c - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x + a - x)) in
  let t_12 := x - u + (x + a - u) + (x - u) in
  let t_13 := (x - u) * ((y - y) * (z + c - z) - (z + c - z) * (y - y)) + (y - v) * ((z + c - z) *
    (x - x) - (x + a - x) * (z + c - z)) + (z - w) * ((x + a - x) * (y - y) - (y - y) * (x - x)) in
  let t_14 := t_7 + ((x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a -
    u) + t_8 * t_8) * t_9 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a -
    u) + t_10 * t_10) * t_11 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x - u) * (x - u) +
    t_12 * t_12) * t_13 in
  let t_15 := x - u + (x - u) + (x + a - u) in
  let t_16 := (x - u) * ((y + b - (y + b)) * (z + c - z) - (z + c - z) * (y + b - (y + b))) + (y + b
    - v) * ((z + c - z) * (x + a - x) - (x - x) * (z + c - z)) + (z - w) * ((x - x) * (y + b - (y +
    b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_17 := x - u + (x + a - u) + (x + a - u) in
  let t_18 := (x - u) * ((y + b - (y + b)) * (z - z) - (z + c - z) * (y + b - (y + b))) + (y + b -
    v) * ((z + c - z) * (x + a - x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y + b - (y
    + b)) - (y + b - (y + b)) * (x + a - x)) in
  let t_19 := x - u + (x - u) + (x + a - u) in
  let t_20 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y + b - y)) + (y - v) * ((z - z) * (x +
    a - x) - (x - x) * (z - z)) + (z - w) * ((x - x) * (y + b - y) - (y + b - y) * (x + a - x)) in
  let t_21 := t_14 + ((x - u) * (x - u) + (x - u) * (x - u) + (x + a - u) * (x + a - u) + t_15 *
    t_15) * t_16 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) + t_17
    * t_17) * t_18 + ((x - u) * (x - u) + (x - u) * (x - u) + (x + a - u) * (x + a - u) + t_19 *
    t_19) * t_20 in
  let t_22 := x - u + (x + a - u) + (x + a - u) in
  let t_23 := (x - u) * ((y + b - y) * (z - z) - (z - z) * (y - y)) + (y - v) * ((z - z) * (x + a -
    x) - (x + a - x) * (z - z)) + (z - w) * ((x + a - x) * (y - y) - (y + b - y) * (x + a - x)) in
  let t_24 := x - u + (x + a - u) + (x + a - u) in
  let t_25 := (x - u) * ((y - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y - v) *
    ((z + c - (z + c)) * (x + a - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a - x)
    * (y + b - y) - (y - y) * (x + a - x)) in
  let t_26 := x - u + (x + a - u) + (x - u) in
  let t_27 := (x - u) * ((y + b - y) * (z + c - (z + c)) - (z + c - (z + c)) * (y + b - y)) + (y -
    v) * ((z + c - (z + c)) * (x - x) - (x + a - x) * (z + c - (z + c))) + (z + c - w) * ((x + a -
    x) * (y + b - y) - (y + b - y) * (x - x)) in
  let t_28 := t_21 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u) +
    t_22 * t_22) * t_23 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x + a - u) * (x + a - u)
    + t_24 * t_24) * t_25 + ((x - u) * (x - u) + (x + a - u) * (x + a - u) + (x - u) * (x - u) +
    t_26 * t_26) * t_27 in
  let t_29 := t_2 + t_4 + t_6 + t_9 + t_11 + t_13 + t_16 + t_18 + t_20 + t_23 + t_25 + t_27 in
  let t_30 := (t_1 * t_2 + t_3 * t_4 + t_5 * t_6 + t_8 * t_9 + t_10 * t_11 + t_12 * t_13 + t_15 *
    t_16 + t_17 * t_18 + t_19 * t_20 + t_22 * t_23 + t_24 * t_25 + t_26 * t_27) / (4 * t_29) in
  let t_31 := t_28 / 120 - t_30 * t_30 * (t_29 / 6) in
  let t_32 := y - v + (y - v) + (y + b - v) in
  let t_33 := y - v + (y + b - v) + (y + b - v) in
  let t_34 := y - v + (y + b - v) + (y + b - v) in
  let t_35 := ((y - v) * (y - v) + (y - v) * (y - v) + (y + b - v) * (y + b - v) + t_32 * t_32) *
    t_2 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_33 * t_33)
    * t_4 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_34 *
    t_34) * t_6 in
  let t_36 := y - v + (y + b - v) + (y - v) in
  let t_37 := y - v + (y - v) + (y - v) in
  let t_38 := y - v + (y - v) + (y - v) in
  let t_39 := y + b - v + (y + b - v) + (y + b - v) in
  let t_40 := t_35 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y - v) * (y - v) + t_36 *
    t_36) * t_9 + ((y - v) * (y - v) + (y - v) * (y - v) + (y - v) * (y - v) + t_37 * t_37) * t_11 +
    ((y - v) * (y - v) + (y - v) * (y - v) + (y - v) * (y - v) + t_38 * t_38) * t_13 + ((y + b - v)
    * (y + b - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_39 * t_39) * t_16 in
  let t_41 := y + b - v + (y + b - v) + (y + b - v) in
  let t_42 := y - v + (y + b - v) + (y + b - v) in
  let t_43 := y - v + (y + b - v) + (y - v) in
  let t_44 := t_40 + ((y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b -
    v) + t_41 * t_41) * t_18 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b
    - v) + t_42 * t_42) * t_20 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y - v) * (y - v)
    + t_43 * t_43) * t_23 in
  let t_45 := y - v + (y - v) + (y + b - v) in
  let t_46 := y - v + (y + b - v) + (y + b - v) in
  let t_47 := (t_32 * t_2 + t_33 * t_4 + t_34 * t_6 + t_36 * t_9 + t_37 * t_11 + t_38 * t_13 + t_39
    * t_16 + t_41 * t_18 + t_42 * t_20 + t_43 * t_23 + t_45 * t_25 + t_46 * t_27) / (4 * t_29) in
  let t_48 := z - w + (z + c - w) + (z + c - w) in
  let t_49 := z - w + (z + c - w) + (z - w) in
  let t_50 := z - w + (z - w) + (z + c - w) in
  let t_51 := ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_48 *
    t_48) * t_2 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z - w) * (z - w) + t_49 * t_49)
    * t_4 + ((z - w) * (z - w) + (z - w) * (z - w) + (z + c - w) * (z + c - w) + t_50 * t_50) * t_6
    in
  let t_52 := z - w + (z + c - w) + (z + c - w) in
  let t_53 := z - w + (z - w) + (z + c - w) in
  let t_54 := z - w + (z + c - w) + (z + c - w) in
  let t_55 := t_51 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) +
    t_52 * t_52) * t_9 + ((z - w) * (z - w) + (z - w) * (z - w) + (z + c - w) * (z + c - w) + t_53 *
    t_53) * t_11 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_54
    * t_54) * t_13 in
  let t_56 := z - w + (z + c - w) + (z + c - w) in
  let t_57 := z - w + (z + c - w) + (z - w) in
  let t_58 := z - w + (z - w) + (z - w) in
  let t_59 := t_55 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) +
    t_56 * t_56) * t_16 + ((z - w) * (z - w) + (z + c - w) * (z + c - w) + (z - w) * (z - w) + t_57
    * t_57) * t_18 + ((z - w) * (z - w) + (z - w) * (z - w) + (z - w) * (z - w) + t_58 * t_58) *
    t_20 in
  let t_60 := z - w + (z - w) + (z - w) in
  let t_61 := z + c - w + (z + c - w) + (z + c - w) in
  let t_62 := z + c - w + (z + c - w) + (z + c - w) in
  let t_63 := t_59 + ((z - w) * (z - w) + (z - w) * (z - w) + (z - w) * (z - w) + t_60 * t_60) *
    t_23 + ((z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + t_61
    * t_61) * t_25 + ((z + c - w) * (z + c - w) + (z + c - w) * (z + c - w) + (z + c - w) * (z + c -
    w) + t_62 * t_62) * t_27 in
  let t_64 := (t_48 * t_2 + t_49 * t_4 + t_50 * t_6 + t_52 * t_9 + t_53 * t_11 + t_54 * t_13 + t_56
    * t_16 + t_57 * t_18 + t_58 * t_20 + t_60 * t_23 + t_61 * t_25 + t_62 * t_27) / (4 * t_29) in
  t_29 <> 0 /\
  t_31 + ((t_44 + ((y - v) * (y - v) + (y - v) * (y - v) + (y + b - v) * (y + b - v) + t_45 * t_45)
    * t_25 + ((y - v) * (y - v) + (y + b - v) * (y + b - v) + (y + b - v) * (y + b - v) + t_46 *
    t_46) * t_27) / 120 - t_47 * t_47 * (t_29 / 6)) + (t_63 / 120 - t_64 * t_64 * (t_29 / 6)) - t_31
    <> (b * b + a * a) * (a * b * c / 12).
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2.
  intros t_1; cut_to t_1 6 computed.
  intros t_2; cut_to t_2 6 computed.
  intros t_3; cut_to t_3 6 computed.
  intros t_4; cut_to t_4 6 computed.
  intros t_5; cut_to t_5 24 computed.
  intros t_6; cut_to t_6 (-24) computed.
  intros t_7; cut_to t_7 (-17856) computed.
  intros t_8; cut_to t_8 24 computed.
  intros t_9; cut_to t_9 (-24) computed.
  intros t_10; cut_to t_10 18 computed.
  intros t_11; cut_to t_11 (-72) computed.
  intros t_12; cut_to t_12 12 computed.
  intros t_13; cut_to t_13 (-72) computed.
  intros t_14; cut_to t_14 (-84672) computed.
  intros t_15; cut_to t_15 12 computed.
  intros t_16; cut_to t_16 54 computed.
  intros t_17; cut_to t_17 18 computed.
  intros t_18; cut_to t_18 54 computed.
  intros t_19; cut_to t_19 12 computed.
  intros t_20; cut_to t_20 12 computed.
  intros t_21; cut_to t_21 (-45792) computed.
  intros t_22; cut_to t_22 18 computed.
  intros t_23; cut_to t_23 12 computed.
  intros t_24; cut_to t_24 18 computed.
  intros t_25; cut_to t_25 (-30) computed.
  intros t_26; cut_to t_26 12 computed.
  intros t_27; cut_to t_27 (-30) computed.
  intros t_28; cut_to t_28 (-60480) computed.
  intros t_29; cut_to t_29 (-108) computed.
  intros t_30; cut_to t_30 5 computed.
  intros t_31; cut_to t_31 (-54) computed.
  intros t_32; cut_to t_32 (-11) computed.
  intros t_33; cut_to t_33 (-10) computed.
  intros t_34; cut_to t_34 (-10) computed.
  intros t_35; cut_to t_35 (-1440) computed.
  intros t_36; cut_to t_36 (-11) computed.
  intros t_37; cut_to t_37 (-12) computed.
  intros t_38; cut_to t_38 (-12) computed.
  intros t_39; cut_to t_39 (-9) computed.
  intros t_40; cut_to t_40 (-27144) computed.
  intros t_41; cut_to t_41 (-9) computed.
  intros t_42; cut_to t_42 (-10) computed.
  intros t_43; cut_to t_43 (-11) computed.
  intros t_44; cut_to t_44 (-17760) computed.
  intros t_45; cut_to t_45 (-11) computed.
  intros t_46; cut_to t_46 (-10) computed.
  intros t_47; cut_to t_47 (-7 / 2) computed.
  intros t_48; cut_to t_48 (-12) computed.
  intros t_49; cut_to t_49 (-9) computed.
  intros t_50; cut_to t_50 (-9) computed.
  intros t_51; cut_to t_51 (-864) computed.
  intros t_52; cut_to t_52 (-12) computed.
  intros t_53; cut_to t_53 (-9) computed.
  intros t_54; cut_to t_54 (-12) computed.
  intros t_55; cut_to t_55 (-28080) computed.
  intros t_56; cut_to t_56 (-12) computed.
  intros t_57; cut_to t_57 (-9) computed.
  intros t_58; cut_to t_58 (-6) computed.
  intros t_59; cut_to t_59 (-10656) computed.
  intros t_60; cut_to t_60 (-6) computed.
  intros t_61; cut_to t_61 (-15) computed.
  intros t_62; cut_to t_62 (-15) computed.
  intros t_63; cut_to t_63 (-28080) computed.
  intros t_64; cut_to t_64 (-7 / 2) computed.
  split; [computed | ]. computed.
Qed.


(** mesh-of-a-tetrahedron: The mesh formula on the four faces of any tetrahedron gives that tetrahedron: the solid into which every other with flat faces is cut. *)

(* mass *)
Theorem mesh_of_a_tetrahedron_1 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    + ((- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)) +
    ((- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)) + ((x2
    - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) * (x4 - x2) - (x3
    - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))) in
  t_1 / 6 = ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6.
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 .
  rational.
Qed.

(* centre, x *)
Theorem mesh_of_a_tetrahedron_2 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_2 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_3 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_4 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  t_1 + t_2 + t_3 + t_4 <> 0 ->
  u + ((- u + (x3 - u) + (x2 - u)) * t_1 + (- u + (x4 - u) + (x3 - u)) * t_2 + (- u + (x2 - u) + (x4
    - u)) * t_3 + (x2 - u + (x3 - u) + (x4 - u)) * t_4) / (4 * (t_1 + t_2 + t_3 + t_4)) = (x2 + x3 +
    x4) / 4.
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 D_1.
  rational.
Qed.

(* centre, y *)
Theorem mesh_of_a_tetrahedron_3 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_2 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_3 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_4 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  t_1 + t_2 + t_3 + t_4 <> 0 ->
  v + ((- v + (y3 - v) + (y2 - v)) * t_1 + (- v + (y4 - v) + (y3 - v)) * t_2 + (- v + (y2 - v) + (y4
    - v)) * t_3 + (y2 - v + (y3 - v) + (y4 - v)) * t_4) / (4 * (t_1 + t_2 + t_3 + t_4)) = (y2 + y3 +
    y4) / 4.
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 D_1.
  rational.
Qed.

(* centre, z *)
Theorem mesh_of_a_tetrahedron_4 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_2 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_3 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_4 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  t_1 + t_2 + t_3 + t_4 <> 0 ->
  w + ((- w + (z3 - w) + (z2 - w)) * t_1 + (- w + (z4 - w) + (z3 - w)) * t_2 + (- w + (z2 - w) + (z4
    - w)) * t_3 + (z2 - w + (z3 - w) + (z4 - w)) * t_4) / (4 * (t_1 + t_2 + t_3 + t_4)) = (z2 + z3 +
    z4) / 4.
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 D_1.
  rational.
Qed.

(* inertia, xx *)
Theorem mesh_of_a_tetrahedron_5 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - u + (x3 - u) + (x2 - u) in
  let t_2 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_3 := - u + (x4 - u) + (x3 - u) in
  let t_4 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_5 := - u + (x2 - u) + (x4 - u) in
  let t_6 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_7 := x2 - u + (x3 - u) + (x4 - u) in
  let t_8 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_9 := ((- u) * (- u) + (x3 - u) * (x3 - u) + (x2 - u) * (x2 - u) + t_1 * t_1) * t_2 + ((- u)
    * (- u) + (x4 - u) * (x4 - u) + (x3 - u) * (x3 - u) + t_3 * t_3) * t_4 + ((- u) * (- u) + (x2 -
    u) * (x2 - u) + (x4 - u) * (x4 - u) + t_5 * t_5) * t_6 + ((x2 - u) * (x2 - u) + (x3 - u) * (x3 -
    u) + (x4 - u) * (x4 - u) + t_7 * t_7) * t_8 in
  let t_10 := (t_1 * t_2 + t_3 * t_4 + t_5 * t_6 + t_7 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_11 := (t_2 + t_4 + t_6 + t_8) / 6 in
  let t_12 := t_9 / 120 - t_10 * t_10 * t_11 in
  let t_13 := - v + (y3 - v) + (y2 - v) in
  let t_14 := - v + (y4 - v) + (y3 - v) in
  let t_15 := - v + (y2 - v) + (y4 - v) in
  let t_16 := y2 - v + (y3 - v) + (y4 - v) in
  let t_17 := ((- v) * (- v) + (y3 - v) * (y3 - v) + (y2 - v) * (y2 - v) + t_13 * t_13) * t_2 + ((-
    v) * (- v) + (y4 - v) * (y4 - v) + (y3 - v) * (y3 - v) + t_14 * t_14) * t_4 + ((- v) * (- v) +
    (y2 - v) * (y2 - v) + (y4 - v) * (y4 - v) + t_15 * t_15) * t_6 + ((y2 - v) * (y2 - v) + (y3 - v)
    * (y3 - v) + (y4 - v) * (y4 - v) + t_16 * t_16) * t_8 in
  let t_18 := (t_13 * t_2 + t_14 * t_4 + t_15 * t_6 + t_16 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_19 := - w + (z3 - w) + (z2 - w) in
  let t_20 := - w + (z4 - w) + (z3 - w) in
  let t_21 := - w + (z2 - w) + (z4 - w) in
  let t_22 := z2 - w + (z3 - w) + (z4 - w) in
  let t_23 := ((- w) * (- w) + (z3 - w) * (z3 - w) + (z2 - w) * (z2 - w) + t_19 * t_19) * t_2 + ((-
    w) * (- w) + (z4 - w) * (z4 - w) + (z3 - w) * (z3 - w) + t_20 * t_20) * t_4 + ((- w) * (- w) +
    (z2 - w) * (z2 - w) + (z4 - w) * (z4 - w) + t_21 * t_21) * t_6 + ((z2 - w) * (z2 - w) + (z3 - w)
    * (z3 - w) + (z4 - w) * (z4 - w) + t_22 * t_22) * t_8 in
  let t_24 := (t_19 * t_2 + t_20 * t_4 + t_21 * t_6 + t_22 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_25 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  let t_26 := y2 - (y2 + y3 + y4) / 4 in
  let t_27 := z2 - (z2 + z3 + z4) / 4 in
  let t_28 := y3 - (y2 + y3 + y4) / 4 in
  let t_29 := z3 - (z2 + z3 + z4) / 4 in
  let t_30 := y4 - (y2 + y3 + y4) / 4 in
  let t_31 := z4 - (z2 + z3 + z4) / 4 in
  t_2 + t_4 + t_6 + t_8 <> 0 ->
  t_12 + (t_17 / 120 - t_18 * t_18 * t_11) + (t_23 / 120 - t_24 * t_24 * t_11) - t_12 = t_25 * ((y2
    + y3 + y4) / 4) * ((y2 + y3 + y4) / 4) + t_25 * ((z2 + z3 + z4) / 4) * ((z2 + z3 + z4) / 4) +
    (t_25 * t_26 * t_26 + t_25 * t_27 * t_27) + (t_25 * t_28 * t_28 + t_25 * t_29 * t_29) + (t_25 *
    t_30 * t_30 + t_25 * t_31 * t_31).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31 D_1.
  rational.
Qed.

(* inertia, xy *)
Theorem mesh_of_a_tetrahedron_6 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - u + (x3 - u) + (x2 - u) in
  let t_2 := - v + (y3 - v) + (y2 - v) in
  let t_3 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_4 := - u + (x4 - u) + (x3 - u) in
  let t_5 := - v + (y4 - v) + (y3 - v) in
  let t_6 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_7 := - u + (x2 - u) + (x4 - u) in
  let t_8 := - v + (y2 - v) + (y4 - v) in
  let t_9 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_10 := x2 - u + (x3 - u) + (x4 - u) in
  let t_11 := y2 - v + (y3 - v) + (y4 - v) in
  let t_12 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_13 := ((- u) * (- v) + (x3 - u) * (y3 - v) + (x2 - u) * (y2 - v) + t_1 * t_2) * t_3 + ((- u)
    * (- v) + (x4 - u) * (y4 - v) + (x3 - u) * (y3 - v) + t_4 * t_5) * t_6 + ((- u) * (- v) + (x2 -
    u) * (y2 - v) + (x4 - u) * (y4 - v) + t_7 * t_8) * t_9 + ((x2 - u) * (y2 - v) + (x3 - u) * (y3 -
    v) + (x4 - u) * (y4 - v) + t_10 * t_11) * t_12 in
  let t_14 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  t_3 + t_6 + t_9 + t_12 <> 0 ->
  - (t_13 / 120 - (t_1 * t_3 + t_4 * t_6 + t_7 * t_9 + t_10 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))
    * ((t_2 * t_3 + t_5 * t_6 + t_8 * t_9 + t_11 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))) * ((t_3 +
    t_6 + t_9 + t_12) / 6)) = - (t_14 * ((x2 + x3 + x4) / 4) * ((y2 + y3 + y4) / 4)) - t_14 * (x2 -
    (x2 + x3 + x4) / 4) * (y2 - (y2 + y3 + y4) / 4) - t_14 * (x3 - (x2 + x3 + x4) / 4) * (y3 - (y2 +
    y3 + y4) / 4) - t_14 * (x4 - (x2 + x3 + x4) / 4) * (y4 - (y2 + y3 + y4) / 4).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 D_1.
  rational.
Qed.

(* inertia, xz *)
Theorem mesh_of_a_tetrahedron_7 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - u + (x3 - u) + (x2 - u) in
  let t_2 := - w + (z3 - w) + (z2 - w) in
  let t_3 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_4 := - u + (x4 - u) + (x3 - u) in
  let t_5 := - w + (z4 - w) + (z3 - w) in
  let t_6 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_7 := - u + (x2 - u) + (x4 - u) in
  let t_8 := - w + (z2 - w) + (z4 - w) in
  let t_9 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_10 := x2 - u + (x3 - u) + (x4 - u) in
  let t_11 := z2 - w + (z3 - w) + (z4 - w) in
  let t_12 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_13 := ((- u) * (- w) + (x3 - u) * (z3 - w) + (x2 - u) * (z2 - w) + t_1 * t_2) * t_3 + ((- u)
    * (- w) + (x4 - u) * (z4 - w) + (x3 - u) * (z3 - w) + t_4 * t_5) * t_6 + ((- u) * (- w) + (x2 -
    u) * (z2 - w) + (x4 - u) * (z4 - w) + t_7 * t_8) * t_9 + ((x2 - u) * (z2 - w) + (x3 - u) * (z3 -
    w) + (x4 - u) * (z4 - w) + t_10 * t_11) * t_12 in
  let t_14 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  t_3 + t_6 + t_9 + t_12 <> 0 ->
  - (t_13 / 120 - (t_1 * t_3 + t_4 * t_6 + t_7 * t_9 + t_10 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))
    * ((t_2 * t_3 + t_5 * t_6 + t_8 * t_9 + t_11 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))) * ((t_3 +
    t_6 + t_9 + t_12) / 6)) = - (t_14 * ((x2 + x3 + x4) / 4) * ((z2 + z3 + z4) / 4)) - t_14 * (x2 -
    (x2 + x3 + x4) / 4) * (z2 - (z2 + z3 + z4) / 4) - t_14 * (x3 - (x2 + x3 + x4) / 4) * (z3 - (z2 +
    z3 + z4) / 4) - t_14 * (x4 - (x2 + x3 + x4) / 4) * (z4 - (z2 + z3 + z4) / 4).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 D_1.
  rational.
Qed.

(* inertia, yx *)
Theorem mesh_of_a_tetrahedron_8 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - v + (y3 - v) + (y2 - v) in
  let t_2 := - u + (x3 - u) + (x2 - u) in
  let t_3 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_4 := - v + (y4 - v) + (y3 - v) in
  let t_5 := - u + (x4 - u) + (x3 - u) in
  let t_6 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_7 := - v + (y2 - v) + (y4 - v) in
  let t_8 := - u + (x2 - u) + (x4 - u) in
  let t_9 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_10 := y2 - v + (y3 - v) + (y4 - v) in
  let t_11 := x2 - u + (x3 - u) + (x4 - u) in
  let t_12 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_13 := ((- v) * (- u) + (y3 - v) * (x3 - u) + (y2 - v) * (x2 - u) + t_1 * t_2) * t_3 + ((- v)
    * (- u) + (y4 - v) * (x4 - u) + (y3 - v) * (x3 - u) + t_4 * t_5) * t_6 + ((- v) * (- u) + (y2 -
    v) * (x2 - u) + (y4 - v) * (x4 - u) + t_7 * t_8) * t_9 + ((y2 - v) * (x2 - u) + (y3 - v) * (x3 -
    u) + (y4 - v) * (x4 - u) + t_10 * t_11) * t_12 in
  let t_14 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  t_3 + t_6 + t_9 + t_12 <> 0 ->
  - (t_13 / 120 - (t_1 * t_3 + t_4 * t_6 + t_7 * t_9 + t_10 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))
    * ((t_2 * t_3 + t_5 * t_6 + t_8 * t_9 + t_11 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))) * ((t_3 +
    t_6 + t_9 + t_12) / 6)) = - (t_14 * ((x2 + x3 + x4) / 4) * ((y2 + y3 + y4) / 4)) - t_14 * (x2 -
    (x2 + x3 + x4) / 4) * (y2 - (y2 + y3 + y4) / 4) - t_14 * (x3 - (x2 + x3 + x4) / 4) * (y3 - (y2 +
    y3 + y4) / 4) - t_14 * (x4 - (x2 + x3 + x4) / 4) * (y4 - (y2 + y3 + y4) / 4).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 D_1.
  rational.
Qed.

(* inertia, yy *)
Theorem mesh_of_a_tetrahedron_9 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - u + (x3 - u) + (x2 - u) in
  let t_2 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_3 := - u + (x4 - u) + (x3 - u) in
  let t_4 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_5 := - u + (x2 - u) + (x4 - u) in
  let t_6 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_7 := x2 - u + (x3 - u) + (x4 - u) in
  let t_8 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_9 := ((- u) * (- u) + (x3 - u) * (x3 - u) + (x2 - u) * (x2 - u) + t_1 * t_1) * t_2 + ((- u)
    * (- u) + (x4 - u) * (x4 - u) + (x3 - u) * (x3 - u) + t_3 * t_3) * t_4 + ((- u) * (- u) + (x2 -
    u) * (x2 - u) + (x4 - u) * (x4 - u) + t_5 * t_5) * t_6 + ((x2 - u) * (x2 - u) + (x3 - u) * (x3 -
    u) + (x4 - u) * (x4 - u) + t_7 * t_7) * t_8 in
  let t_10 := (t_1 * t_2 + t_3 * t_4 + t_5 * t_6 + t_7 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_11 := (t_2 + t_4 + t_6 + t_8) / 6 in
  let t_12 := - v + (y3 - v) + (y2 - v) in
  let t_13 := - v + (y4 - v) + (y3 - v) in
  let t_14 := - v + (y2 - v) + (y4 - v) in
  let t_15 := y2 - v + (y3 - v) + (y4 - v) in
  let t_16 := ((- v) * (- v) + (y3 - v) * (y3 - v) + (y2 - v) * (y2 - v) + t_12 * t_12) * t_2 + ((-
    v) * (- v) + (y4 - v) * (y4 - v) + (y3 - v) * (y3 - v) + t_13 * t_13) * t_4 + ((- v) * (- v) +
    (y2 - v) * (y2 - v) + (y4 - v) * (y4 - v) + t_14 * t_14) * t_6 + ((y2 - v) * (y2 - v) + (y3 - v)
    * (y3 - v) + (y4 - v) * (y4 - v) + t_15 * t_15) * t_8 in
  let t_17 := (t_12 * t_2 + t_13 * t_4 + t_14 * t_6 + t_15 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_18 := t_16 / 120 - t_17 * t_17 * t_11 in
  let t_19 := - w + (z3 - w) + (z2 - w) in
  let t_20 := - w + (z4 - w) + (z3 - w) in
  let t_21 := - w + (z2 - w) + (z4 - w) in
  let t_22 := z2 - w + (z3 - w) + (z4 - w) in
  let t_23 := ((- w) * (- w) + (z3 - w) * (z3 - w) + (z2 - w) * (z2 - w) + t_19 * t_19) * t_2 + ((-
    w) * (- w) + (z4 - w) * (z4 - w) + (z3 - w) * (z3 - w) + t_20 * t_20) * t_4 + ((- w) * (- w) +
    (z2 - w) * (z2 - w) + (z4 - w) * (z4 - w) + t_21 * t_21) * t_6 + ((z2 - w) * (z2 - w) + (z3 - w)
    * (z3 - w) + (z4 - w) * (z4 - w) + t_22 * t_22) * t_8 in
  let t_24 := (t_19 * t_2 + t_20 * t_4 + t_21 * t_6 + t_22 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_25 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  let t_26 := z2 - (z2 + z3 + z4) / 4 in
  let t_27 := x2 - (x2 + x3 + x4) / 4 in
  let t_28 := z3 - (z2 + z3 + z4) / 4 in
  let t_29 := x3 - (x2 + x3 + x4) / 4 in
  let t_30 := z4 - (z2 + z3 + z4) / 4 in
  let t_31 := x4 - (x2 + x3 + x4) / 4 in
  t_2 + t_4 + t_6 + t_8 <> 0 ->
  t_9 / 120 - t_10 * t_10 * t_11 + t_18 + (t_23 / 120 - t_24 * t_24 * t_11) - t_18 = t_25 * ((z2 +
    z3 + z4) / 4) * ((z2 + z3 + z4) / 4) + t_25 * ((x2 + x3 + x4) / 4) * ((x2 + x3 + x4) / 4) +
    (t_25 * t_26 * t_26 + t_25 * t_27 * t_27) + (t_25 * t_28 * t_28 + t_25 * t_29 * t_29) + (t_25 *
    t_30 * t_30 + t_25 * t_31 * t_31).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31 D_1.
  rational.
Qed.

(* inertia, yz *)
Theorem mesh_of_a_tetrahedron_10 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - v + (y3 - v) + (y2 - v) in
  let t_2 := - w + (z3 - w) + (z2 - w) in
  let t_3 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_4 := - v + (y4 - v) + (y3 - v) in
  let t_5 := - w + (z4 - w) + (z3 - w) in
  let t_6 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_7 := - v + (y2 - v) + (y4 - v) in
  let t_8 := - w + (z2 - w) + (z4 - w) in
  let t_9 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_10 := y2 - v + (y3 - v) + (y4 - v) in
  let t_11 := z2 - w + (z3 - w) + (z4 - w) in
  let t_12 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_13 := ((- v) * (- w) + (y3 - v) * (z3 - w) + (y2 - v) * (z2 - w) + t_1 * t_2) * t_3 + ((- v)
    * (- w) + (y4 - v) * (z4 - w) + (y3 - v) * (z3 - w) + t_4 * t_5) * t_6 + ((- v) * (- w) + (y2 -
    v) * (z2 - w) + (y4 - v) * (z4 - w) + t_7 * t_8) * t_9 + ((y2 - v) * (z2 - w) + (y3 - v) * (z3 -
    w) + (y4 - v) * (z4 - w) + t_10 * t_11) * t_12 in
  let t_14 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  t_3 + t_6 + t_9 + t_12 <> 0 ->
  - (t_13 / 120 - (t_1 * t_3 + t_4 * t_6 + t_7 * t_9 + t_10 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))
    * ((t_2 * t_3 + t_5 * t_6 + t_8 * t_9 + t_11 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))) * ((t_3 +
    t_6 + t_9 + t_12) / 6)) = - (t_14 * ((y2 + y3 + y4) / 4) * ((z2 + z3 + z4) / 4)) - t_14 * (y2 -
    (y2 + y3 + y4) / 4) * (z2 - (z2 + z3 + z4) / 4) - t_14 * (y3 - (y2 + y3 + y4) / 4) * (z3 - (z2 +
    z3 + z4) / 4) - t_14 * (y4 - (y2 + y3 + y4) / 4) * (z4 - (z2 + z3 + z4) / 4).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 D_1.
  rational.
Qed.

(* inertia, zx *)
Theorem mesh_of_a_tetrahedron_11 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - w + (z3 - w) + (z2 - w) in
  let t_2 := - u + (x3 - u) + (x2 - u) in
  let t_3 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_4 := - w + (z4 - w) + (z3 - w) in
  let t_5 := - u + (x4 - u) + (x3 - u) in
  let t_6 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_7 := - w + (z2 - w) + (z4 - w) in
  let t_8 := - u + (x2 - u) + (x4 - u) in
  let t_9 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_10 := z2 - w + (z3 - w) + (z4 - w) in
  let t_11 := x2 - u + (x3 - u) + (x4 - u) in
  let t_12 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_13 := ((- w) * (- u) + (z3 - w) * (x3 - u) + (z2 - w) * (x2 - u) + t_1 * t_2) * t_3 + ((- w)
    * (- u) + (z4 - w) * (x4 - u) + (z3 - w) * (x3 - u) + t_4 * t_5) * t_6 + ((- w) * (- u) + (z2 -
    w) * (x2 - u) + (z4 - w) * (x4 - u) + t_7 * t_8) * t_9 + ((z2 - w) * (x2 - u) + (z3 - w) * (x3 -
    u) + (z4 - w) * (x4 - u) + t_10 * t_11) * t_12 in
  let t_14 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  t_3 + t_6 + t_9 + t_12 <> 0 ->
  - (t_13 / 120 - (t_1 * t_3 + t_4 * t_6 + t_7 * t_9 + t_10 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))
    * ((t_2 * t_3 + t_5 * t_6 + t_8 * t_9 + t_11 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))) * ((t_3 +
    t_6 + t_9 + t_12) / 6)) = - (t_14 * ((x2 + x3 + x4) / 4) * ((z2 + z3 + z4) / 4)) - t_14 * (x2 -
    (x2 + x3 + x4) / 4) * (z2 - (z2 + z3 + z4) / 4) - t_14 * (x3 - (x2 + x3 + x4) / 4) * (z3 - (z2 +
    z3 + z4) / 4) - t_14 * (x4 - (x2 + x3 + x4) / 4) * (z4 - (z2 + z3 + z4) / 4).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 D_1.
  rational.
Qed.

(* inertia, zy *)
Theorem mesh_of_a_tetrahedron_12 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - w + (z3 - w) + (z2 - w) in
  let t_2 := - v + (y3 - v) + (y2 - v) in
  let t_3 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_4 := - w + (z4 - w) + (z3 - w) in
  let t_5 := - v + (y4 - v) + (y3 - v) in
  let t_6 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_7 := - w + (z2 - w) + (z4 - w) in
  let t_8 := - v + (y2 - v) + (y4 - v) in
  let t_9 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_10 := z2 - w + (z3 - w) + (z4 - w) in
  let t_11 := y2 - v + (y3 - v) + (y4 - v) in
  let t_12 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_13 := ((- w) * (- v) + (z3 - w) * (y3 - v) + (z2 - w) * (y2 - v) + t_1 * t_2) * t_3 + ((- w)
    * (- v) + (z4 - w) * (y4 - v) + (z3 - w) * (y3 - v) + t_4 * t_5) * t_6 + ((- w) * (- v) + (z2 -
    w) * (y2 - v) + (z4 - w) * (y4 - v) + t_7 * t_8) * t_9 + ((z2 - w) * (y2 - v) + (z3 - w) * (y3 -
    v) + (z4 - w) * (y4 - v) + t_10 * t_11) * t_12 in
  let t_14 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  t_3 + t_6 + t_9 + t_12 <> 0 ->
  - (t_13 / 120 - (t_1 * t_3 + t_4 * t_6 + t_7 * t_9 + t_10 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))
    * ((t_2 * t_3 + t_5 * t_6 + t_8 * t_9 + t_11 * t_12) / (4 * (t_3 + t_6 + t_9 + t_12))) * ((t_3 +
    t_6 + t_9 + t_12) / 6)) = - (t_14 * ((y2 + y3 + y4) / 4) * ((z2 + z3 + z4) / 4)) - t_14 * (y2 -
    (y2 + y3 + y4) / 4) * (z2 - (z2 + z3 + z4) / 4) - t_14 * (y3 - (y2 + y3 + y4) / 4) * (z3 - (z2 +
    z3 + z4) / 4) - t_14 * (y4 - (y2 + y3 + y4) / 4) * (z4 - (z2 + z3 + z4) / 4).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 D_1.
  rational.
Qed.

(* inertia, zz *)
Theorem mesh_of_a_tetrahedron_13 :
  forall u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := - u + (x3 - u) + (x2 - u) in
  let t_2 := (- u) * (y3 * z2 - z3 * y2) + (- v) * (z3 * x2 - x3 * z2) + (- w) * (x3 * y2 - y3 * x2)
    in
  let t_3 := - u + (x4 - u) + (x3 - u) in
  let t_4 := (- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)
    in
  let t_5 := - u + (x2 - u) + (x4 - u) in
  let t_6 := (- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)
    in
  let t_7 := x2 - u + (x3 - u) + (x4 - u) in
  let t_8 := (x2 - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) *
    (x4 - x2) - (x3 - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))
    in
  let t_9 := ((- u) * (- u) + (x3 - u) * (x3 - u) + (x2 - u) * (x2 - u) + t_1 * t_1) * t_2 + ((- u)
    * (- u) + (x4 - u) * (x4 - u) + (x3 - u) * (x3 - u) + t_3 * t_3) * t_4 + ((- u) * (- u) + (x2 -
    u) * (x2 - u) + (x4 - u) * (x4 - u) + t_5 * t_5) * t_6 + ((x2 - u) * (x2 - u) + (x3 - u) * (x3 -
    u) + (x4 - u) * (x4 - u) + t_7 * t_7) * t_8 in
  let t_10 := (t_1 * t_2 + t_3 * t_4 + t_5 * t_6 + t_7 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_11 := (t_2 + t_4 + t_6 + t_8) / 6 in
  let t_12 := - v + (y3 - v) + (y2 - v) in
  let t_13 := - v + (y4 - v) + (y3 - v) in
  let t_14 := - v + (y2 - v) + (y4 - v) in
  let t_15 := y2 - v + (y3 - v) + (y4 - v) in
  let t_16 := ((- v) * (- v) + (y3 - v) * (y3 - v) + (y2 - v) * (y2 - v) + t_12 * t_12) * t_2 + ((-
    v) * (- v) + (y4 - v) * (y4 - v) + (y3 - v) * (y3 - v) + t_13 * t_13) * t_4 + ((- v) * (- v) +
    (y2 - v) * (y2 - v) + (y4 - v) * (y4 - v) + t_14 * t_14) * t_6 + ((y2 - v) * (y2 - v) + (y3 - v)
    * (y3 - v) + (y4 - v) * (y4 - v) + t_15 * t_15) * t_8 in
  let t_17 := (t_12 * t_2 + t_13 * t_4 + t_14 * t_6 + t_15 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_18 := - w + (z3 - w) + (z2 - w) in
  let t_19 := - w + (z4 - w) + (z3 - w) in
  let t_20 := - w + (z2 - w) + (z4 - w) in
  let t_21 := z2 - w + (z3 - w) + (z4 - w) in
  let t_22 := ((- w) * (- w) + (z3 - w) * (z3 - w) + (z2 - w) * (z2 - w) + t_18 * t_18) * t_2 + ((-
    w) * (- w) + (z4 - w) * (z4 - w) + (z3 - w) * (z3 - w) + t_19 * t_19) * t_4 + ((- w) * (- w) +
    (z2 - w) * (z2 - w) + (z4 - w) * (z4 - w) + t_20 * t_20) * t_6 + ((z2 - w) * (z2 - w) + (z3 - w)
    * (z3 - w) + (z4 - w) * (z4 - w) + t_21 * t_21) * t_8 in
  let t_23 := (t_18 * t_2 + t_19 * t_4 + t_20 * t_6 + t_21 * t_8) / (4 * (t_2 + t_4 + t_6 + t_8)) in
  let t_24 := t_22 / 120 - t_23 * t_23 * t_11 in
  let t_25 := ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6 /
    20 in
  let t_26 := x2 - (x2 + x3 + x4) / 4 in
  let t_27 := y2 - (y2 + y3 + y4) / 4 in
  let t_28 := x3 - (x2 + x3 + x4) / 4 in
  let t_29 := y3 - (y2 + y3 + y4) / 4 in
  let t_30 := x4 - (x2 + x3 + x4) / 4 in
  let t_31 := y4 - (y2 + y3 + y4) / 4 in
  t_2 + t_4 + t_6 + t_8 <> 0 ->
  t_9 / 120 - t_10 * t_10 * t_11 + (t_16 / 120 - t_17 * t_17 * t_11) + t_24 - t_24 = t_25 * ((x2 +
    x3 + x4) / 4) * ((x2 + x3 + x4) / 4) + t_25 * ((y2 + y3 + y4) / 4) * ((y2 + y3 + y4) / 4) +
    (t_25 * t_26 * t_26 + t_25 * t_27 * t_27) + (t_25 * t_28 * t_28 + t_25 * t_29 * t_29) + (t_25 *
    t_30 * t_30 + t_25 * t_31 * t_31).
Proof.
  intros u v w x2 x3 x4 y2 y3 y4 z2 z3 z4  t_1 t_2 t_3 t_4 t_5 t_6 t_7 t_8 t_9 t_10 t_11 t_12 t_13
    t_14 t_15 t_16 t_17 t_18 t_19 t_20 t_21 t_22 t_23 t_24 t_25 t_26 t_27 t_28 t_29 t_30 t_31 D_1.
  rational.
Qed.

(* With one face turned inside out. *)

(* mass *)
Theorem mesh_of_a_tetrahedron_mutant_1 :
  exists u v w x2 x3 x4 y2 y3 y4 z2 z3 z4 : R,
  let t_1 := (- u) * (y2 * z3 - z2 * y3) + (- v) * (z2 * x3 - x2 * z3) + (- w) * (x2 * y3 - y2 * x3)
    + ((- u) * (y4 * z3 - z4 * y3) + (- v) * (z4 * x3 - x4 * z3) + (- w) * (x4 * y3 - y4 * x3)) +
    ((- u) * (y2 * z4 - z2 * y4) + (- v) * (z2 * x4 - x2 * z4) + (- w) * (x2 * y4 - y2 * x4)) + ((x2
    - u) * ((y3 - y2) * (z4 - z2) - (z3 - z2) * (y4 - y2)) + (y2 - v) * ((z3 - z2) * (x4 - x2) - (x3
    - x2) * (z4 - z2)) + (z2 - w) * ((x3 - x2) * (y4 - y2) - (y3 - y2) * (x4 - x2))) in
  t_1 / 6 <> ((y2 * z3 - z2 * y3) * x4 + (z2 * x3 - x2 * z3) * y4 + (x2 * y3 - y2 * x3) * z4) / 6.
Proof.
  exists 6, 1, (-3), 1, 7, 4, 3, 3, 2, 5, 2, 6.
  intros t_1; cut_to t_1 (-144) computed.
  computed.
Qed.


(** triangle-inequality: No moment of any solid exceeds the sum of the other two: I1 + I2 - I3 has no negative term; for flat bodies it is zero. *)

(* box *)
Theorem triangle_inequality_1 :
  forall a b c m : R,
  0 < a ->
  0 < b ->
  0 < c ->
  0 < m ->
  (b * b + c * c) * (m / 12) + (c * c + a * a) * (m / 12) - (a * a + b * b) * (m / 12) > 0.
Proof.
  intros a b c m H_1 H_2 H_3 H_4  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 6) * c ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* box *)
Theorem triangle_inequality_2 :
  forall a b c m : R,
  0 < a ->
  0 < b ->
  0 < c ->
  0 < m ->
  (c * c + a * a) * (m / 12) + (a * a + b * b) * (m / 12) - (b * b + c * c) * (m / 12) > 0.
Proof.
  intros a b c m H_1 H_2 H_3 H_4  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 6) * a ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* box *)
Theorem triangle_inequality_3 :
  forall a b c m : R,
  0 < a ->
  0 < b ->
  0 < c ->
  0 < m ->
  (a * a + b * b) * (m / 12) + (b * b + c * c) * (m / 12) - (c * c + a * a) * (m / 12) > 0.
Proof.
  intros a b c m H_1 H_2 H_3 H_4  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 6) * b ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* ellipsoid *)
Theorem triangle_inequality_4 :
  forall a b c m : R,
  0 < a ->
  0 < b ->
  0 < c ->
  0 < m ->
  (b * b + c * c) * (m / 5) + (c * c + a * a) * (m / 5) - (a * a + b * b) * (m / 5) > 0.
Proof.
  intros a b c m H_1 H_2 H_3 H_4  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((2 / 5) * c ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* ellipsoid *)
Theorem triangle_inequality_5 :
  forall a b c m : R,
  0 < a ->
  0 < b ->
  0 < c ->
  0 < m ->
  (c * c + a * a) * (m / 5) + (a * a + b * b) * (m / 5) - (b * b + c * c) * (m / 5) > 0.
Proof.
  intros a b c m H_1 H_2 H_3 H_4  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((2 / 5) * a ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* ellipsoid *)
Theorem triangle_inequality_6 :
  forall a b c m : R,
  0 < a ->
  0 < b ->
  0 < c ->
  0 < m ->
  (a * a + b * b) * (m / 5) + (b * b + c * c) * (m / 5) - (c * c + a * a) * (m / 5) > 0.
Proof.
  intros a b c m H_1 H_2 H_3 H_4  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((2 / 5) * b ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* ball *)
Theorem triangle_inequality_7 :
  forall m r : R,
  0 < m ->
  0 < r ->
  let t_1 := 2 * m * (r * r) / 5 in
  t_1 + t_1 - t_1 > 0.
Proof.
  intros m r H_1 H_2 t_1 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((2 / 5) * m * r ^ 2) (1)); [positive | positive | rational].
Qed.

(* hollow sphere *)
Theorem triangle_inequality_8 :
  forall a m r : R,
  0 < a ->
  0 < m ->
  0 < r ->
  let t_1 := 2 * m * ((r + a) * (r + a) * ((r + a) * (r + a)) + (r + a) * (r + a) * (r * (r + a)) +
    (r + a) * (r + a) * (r * r) + r * r * (r * (r + a)) + r * r * (r * r)) / (5 * ((r + a) * (r + a)
    + r * (r + a) + r * r)) in
  t_1 + t_1 - t_1 > 0.
Proof.
  intros a m r H_1 H_2 H_3 t_1 .
  unnamed.
  assert ((r + a) * (r + a) + r * (r + a) + r * r <> 0) by (apply Rgt_not_eq; positive).
  assert (a ^ 2 + 3 * a * r + 3 * r ^ 2 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((2 / 5) * a ^ 4 * m + 2 * a ^ 3 * m * r + 4 * a ^ 2 * m * r ^ 2 + 4 * a * m *
    r ^ 3 + 2 * m * r ^ 4) (a ^ 2 + 3 * a * r + 3 * r ^ 2)); [positive | positive | rational].
Qed.

(* cylinder *)
Theorem triangle_inequality_9 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := m * (3 * (r * r) + h * h) / 12 in
  t_1 + t_1 - m * (r * r) / 2 > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 6) * h ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* cylinder *)
Theorem triangle_inequality_10 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := m * (3 * (r * r) + h * h) / 12 in
  t_1 + m * (r * r) / 2 - t_1 > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 2) * m * r ^ 2) (1)); [positive | positive | rational].
Qed.

(* cylinder *)
Theorem triangle_inequality_11 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := m * (3 * (r * r) + h * h) / 12 in
  m * (r * r) / 2 + t_1 - t_1 > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 2) * m * r ^ 2) (1)); [positive | positive | rational].
Qed.

(* tube *)
Theorem triangle_inequality_12 :
  forall a h m r : R,
  0 < a ->
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := r * r + (r + a) * (r + a) in
  let t_2 := m * (3 * t_1 + h * h) / 12 in
  t_2 + t_2 - m * t_1 / 2 > 0.
Proof.
  intros a h m r H_1 H_2 H_3 H_4 t_1 t_2 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 6) * h ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* tube *)
Theorem triangle_inequality_13 :
  forall a h m r : R,
  0 < a ->
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := r * r + (r + a) * (r + a) in
  let t_2 := m * (3 * t_1 + h * h) / 12 in
  t_2 + m * t_1 / 2 - t_2 > 0.
Proof.
  intros a h m r H_1 H_2 H_3 H_4 t_1 t_2 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 2) * a ^ 2 * m + a * m * r + m * r ^ 2) (1)); [positive | positive |
    rational].
Qed.

(* tube *)
Theorem triangle_inequality_14 :
  forall a h m r : R,
  0 < a ->
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := r * r + (r + a) * (r + a) in
  let t_2 := m * (3 * t_1 + h * h) / 12 in
  m * t_1 / 2 + t_2 - t_2 > 0.
Proof.
  intros a h m r H_1 H_2 H_3 H_4 t_1 t_2 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 2) * a ^ 2 * m + a * m * r + m * r ^ 2) (1)); [positive | positive |
    rational].
Qed.

(* cone *)
Theorem triangle_inequality_15 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := 3 * m * (4 * (r * r) + h * h) / 80 in
  t_1 + t_1 - 3 * m * (r * r) / 10 > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((3 / 40) * h ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* cone *)
Theorem triangle_inequality_16 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := 3 * m * (4 * (r * r) + h * h) / 80 in
  t_1 + 3 * m * (r * r) / 10 - t_1 > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((3 / 10) * m * r ^ 2) (1)); [positive | positive | rational].
Qed.

(* cone *)
Theorem triangle_inequality_17 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := 3 * m * (4 * (r * r) + h * h) / 80 in
  3 * m * (r * r) / 10 + t_1 - t_1 > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((3 / 10) * m * r ^ 2) (1)); [positive | positive | rational].
Qed.

(* capsule *)
Theorem triangle_inequality_18 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := m * (3 * h) / (3 * h + 4 * r) in
  let t_2 := t_1 * (3 * (r * r) + h * h) / 12 in
  let t_3 := m * (4 * r) / (3 * h + 4 * r) in
  let t_4 := t_3 * (2 * (r * r) / 5 + 3 * (h * r) / 8 + h * h / 4) in
  t_2 + t_4 + (t_2 + t_4) - (t_1 * (r * r) / 2 + t_3 * (2 * (r * r) / 5)) > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 t_2 t_3 t_4 .
  unnamed.
  assert (3 * h + 4 * r <> 0) by (apply Rgt_not_eq; positive).
  assert (3 * h + 4 * r <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 2) * h ^ 3 * m + 2 * h ^ 2 * m * r + 3 * h * m * r ^ 2 + (8 / 5) * m * r
    ^ 3) (3 * h + 4 * r)); [positive | positive | rational].
Qed.

(* capsule *)
Theorem triangle_inequality_19 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := m * (3 * h) / (3 * h + 4 * r) in
  let t_2 := t_1 * (3 * (r * r) + h * h) / 12 in
  let t_3 := m * (4 * r) / (3 * h + 4 * r) in
  let t_4 := t_3 * (2 * (r * r) / 5 + 3 * (h * r) / 8 + h * h / 4) in
  t_2 + t_4 + (t_1 * (r * r) / 2 + t_3 * (2 * (r * r) / 5)) - (t_2 + t_4) > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 t_2 t_3 t_4 .
  unnamed.
  assert (3 * h + 4 * r <> 0) by (apply Rgt_not_eq; positive).
  assert (3 * h + 4 * r <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((3 / 2) * h * m * r ^ 2 + (8 / 5) * m * r ^ 3) (3 * h + 4 * r)); [positive |
    positive | rational].
Qed.

(* capsule *)
Theorem triangle_inequality_20 :
  forall h m r : R,
  0 < h ->
  0 < m ->
  0 < r ->
  let t_1 := m * (3 * h) / (3 * h + 4 * r) in
  let t_2 := m * (4 * r) / (3 * h + 4 * r) in
  let t_3 := t_1 * (3 * (r * r) + h * h) / 12 in
  let t_4 := t_2 * (2 * (r * r) / 5 + 3 * (h * r) / 8 + h * h / 4) in
  t_1 * (r * r) / 2 + t_2 * (2 * (r * r) / 5) + (t_3 + t_4) - (t_3 + t_4) > 0.
Proof.
  intros h m r H_1 H_2 H_3 t_1 t_2 t_3 t_4 .
  unnamed.
  assert (3 * h + 4 * r <> 0) by (apply Rgt_not_eq; positive).
  assert (3 * h + 4 * r <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((3 / 2) * h * m * r ^ 2 + (8 / 5) * m * r ^ 3) (3 * h + 4 * r)); [positive |
    positive | rational].
Qed.

(* rod *)
Theorem triangle_inequality_21 :
  forall h m : R,
  0 < h ->
  0 < m ->
  m * (h * h) / 12 + m * (h * h) / 12 > 0.
Proof.
  intros h m H_1 H_2  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 6) * h ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* plate *)
Theorem triangle_inequality_22 :
  forall a b m : R,
  0 < a ->
  0 < b ->
  0 < m ->
  m * (a * a) / 12 + (m * (b * b) / 12 + m * (a * a) / 12) - m * (b * b) / 12 > 0.
Proof.
  intros a b m H_1 H_2 H_3  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 6) * a ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* plate *)
Theorem triangle_inequality_23 :
  forall a b m : R,
  0 < a ->
  0 < b ->
  0 < m ->
  m * (b * b) / 12 + m * (a * a) / 12 + m * (b * b) / 12 - m * (a * a) / 12 > 0.
Proof.
  intros a b m H_1 H_2 H_3  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 6) * b ^ 2 * m) (1)); [positive | positive | rational].
Qed.

(* disk *)
Theorem triangle_inequality_24 :
  forall m r : R,
  0 < m ->
  0 < r ->
  m * (r * r) / 4 + (m * (r * r) / 4 + m * (r * r) / 4) - m * (r * r) / 4 > 0.
Proof.
  intros m r H_1 H_2  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 2) * m * r ^ 2) (1)); [positive | positive | rational].
Qed.

(* disk *)
Theorem triangle_inequality_25 :
  forall m r : R,
  0 < m ->
  0 < r ->
  m * (r * r) / 4 + m * (r * r) / 4 + m * (r * r) / 4 - m * (r * r) / 4 > 0.
Proof.
  intros m r H_1 H_2  .
  unnamed.
  assert (1 <> 0) by (apply Rgt_not_eq; positive).
  apply (above_zero _ ((1 / 2) * m * r ^ 2) (1)); [positive | positive | rational].
Qed.

(* plate *)
Theorem triangle_inequality_26 :
  forall a b m : R,
  m * (b * b) / 12 + m * (a * a) / 12 = m * (b * b) / 12 + m * (a * a) / 12.
Proof.
  intros a b m   .
  rational.
Qed.

(* disk *)
Theorem triangle_inequality_27 :
  forall m r : R,
  m * (r * r) / 4 + m * (r * r) / 4 = m * (r * r) / 4 + m * (r * r) / 4.
Proof.
  intros m r   .
  rational.
Qed.

(* With a box whose first moment has b² + 3 c². *)

(* box *)
Theorem triangle_inequality_mutant_1 :
  exists a b c m : R,
  0 < a /\
  0 < b /\
  0 < c /\
  0 < m /\
  (c * c + a * a) * (m / 12) + (a * a + b * b) * (m / 12) - ((b * b + c * c) * (m / 12) + m * c * c
    / 6) <= 0.
Proof.
  exists 1, (5 / 2), 1, (625 / 1521).
  split; [computed | ]. split; [computed | ]. split; [computed | ]. split; [computed | ]. 
  computed.
Qed.
