(* Numbers of the book that no fraction gives, from a formula or an integral: each rounds to the digits that the
   book prints, and not to the next ones. *)
From Coq Require Import Reals Lra.
From Interval Require Import Tactic.
Open Scope R_scope.
From Coquelicot Require Import Coquelicot.

(** Degrees between spin and momentum of a box with edges 2, 1 and 3 m, spun along (1, 1, 0). It rounds to 7.4. *)
Theorem gap_of_the_box :
  147 / 20 < atan (3 / 23) * 180 / PI < 149 / 20.
Proof. cbv zeta. split; interval. Qed.

(* With the last digit raised by one. *)
Theorem gap_of_the_box_mutant_1 :
  ~ (149 / 20 < atan (3 / 23) * 180 / PI < 151 / 20).
Proof. cbv zeta. intros [H _]. revert H. apply Rle_not_lt. interval. Qed.

(** Degrees between the first axis and the same momentum. It rounds to 52.4. *)
Theorem momentum_of_the_box :
  1047 / 20 < atan (13 / 10) * 180 / PI < 1049 / 20.
Proof. cbv zeta. split; interval. Qed.

(* With the last digit raised by one. *)
Theorem momentum_of_the_box_mutant_1 :
  ~ (1049 / 20 < atan (13 / 10) * 180 / PI < 1051 / 20).
Proof. cbv zeta. intros [H _]. revert H. apply Rle_not_lt. interval. Qed.

(** The rate, per second, at which a push grows of the box that spins at 10 rad/s about its middle axis. It rounds to 4.80. *)
Theorem growth_of_the_box :
  959 / 200 < 10 * sqrt (3 / 13) < 961 / 200.
Proof. cbv zeta. split; interval. Qed.

(* With the last digit raised by one. *)
Theorem growth_of_the_box_mutant_1 :
  ~ (961 / 200 < 10 * sqrt (3 / 13) < 963 / 200).
Proof. cbv zeta. intros [H _]. revert H. apply Rle_not_lt. interval. Qed.

(** The seconds in which it doubles. It rounds to 0.14. *)
Theorem doubling_of_the_box :
  27 / 200 < ln 2 / (10 * sqrt (3 / 13)) < 29 / 200.
Proof. cbv zeta. split; interval. Qed.

(* With the last digit raised by one. *)
Theorem doubling_of_the_box_mutant_1 :
  ~ (29 / 200 < ln 2 / (10 * sqrt (3 / 13)) < 31 / 200).
Proof. cbv zeta. intros [H _]. revert H. apply Rle_not_lt. interval. Qed.

(** The seconds to the first flip of the tossed book, by Legendre's integral. It rounds to 0.64. *)
Theorem first_flip_of_the_book :
  let across := 17041 / 1000000 in
  let middle := 39604 / 1000000 in
  let circled := 55845 / 1000000 in
  let spin := 4 * PI in
  let small := spin / 20 in
  let p2 := across * (circled - across) * small ^ 2 + middle * (circled - middle) * spin ^ 2 in
  let q2 := middle * (middle - across) * spin ^ 2 + circled * (circled - across) * small ^ 2 in
  let m := (middle - across) * p2 / ((circled - middle) * q2) in
  let eta := sqrt ((circled - middle) * q2 / (across * middle * circled)) in
  let start := atan (20 * sqrt (middle * (circled - middle) / (across * (circled - across)))) in
  127 / 200 < RInt (fun t => 1 / sqrt (1 - m * sin t ^ 2)) start PI / eta < 129 / 200.
Proof. cbv zeta. split; integral. Qed.

(* With the last digit raised by one. *)
Theorem first_flip_of_the_book_mutant_1 :
  let across := 17041 / 1000000 in
  let middle := 39604 / 1000000 in
  let circled := 55845 / 1000000 in
  let spin := 4 * PI in
  let small := spin / 20 in
  let p2 := across * (circled - across) * small ^ 2 + middle * (circled - middle) * spin ^ 2 in
  let q2 := middle * (middle - across) * spin ^ 2 + circled * (circled - across) * small ^ 2 in
  let m := (middle - across) * p2 / ((circled - middle) * q2) in
  let eta := sqrt ((circled - middle) * q2 / (across * middle * circled)) in
  let start := atan (20 * sqrt (middle * (circled - middle) / (across * (circled - across)))) in
  ~ (129 / 200 < RInt (fun t => 1 / sqrt (1 - m * sin t ^ 2)) start PI / eta < 131 / 200).
Proof. cbv zeta. intros [H _]. revert H. apply Rle_not_lt. integral. Qed.

(** The seconds from one flip to the next. It rounds to 1.08. *)
Theorem between_flips_of_the_book :
  let across := 17041 / 1000000 in
  let middle := 39604 / 1000000 in
  let circled := 55845 / 1000000 in
  let spin := 4 * PI in
  let small := spin / 20 in
  let p2 := across * (circled - across) * small ^ 2 + middle * (circled - middle) * spin ^ 2 in
  let q2 := middle * (middle - across) * spin ^ 2 + circled * (circled - across) * small ^ 2 in
  let m := (middle - across) * p2 / ((circled - middle) * q2) in
  let eta := sqrt ((circled - middle) * q2 / (across * middle * circled)) in
  let start := atan (20 * sqrt (middle * (circled - middle) / (across * (circled - across)))) in
  215 / 200 < RInt (fun t => 1 / sqrt (1 - m * sin t ^ 2)) 0 PI / eta < 217 / 200.
Proof. cbv zeta. split; integral. Qed.

(* With the last digit raised by one. *)
Theorem between_flips_of_the_book_mutant_1 :
  let across := 17041 / 1000000 in
  let middle := 39604 / 1000000 in
  let circled := 55845 / 1000000 in
  let spin := 4 * PI in
  let small := spin / 20 in
  let p2 := across * (circled - across) * small ^ 2 + middle * (circled - middle) * spin ^ 2 in
  let q2 := middle * (middle - across) * spin ^ 2 + circled * (circled - across) * small ^ 2 in
  let m := (middle - across) * p2 / ((circled - middle) * q2) in
  let eta := sqrt ((circled - middle) * q2 / (across * middle * circled)) in
  let start := atan (20 * sqrt (middle * (circled - middle) / (across * (circled - across)))) in
  ~ (217 / 200 < RInt (fun t => 1 / sqrt (1 - m * sin t ^ 2)) 0 PI / eta < 219 / 200).
Proof. cbv zeta. intros [H _]. revert H. apply Rle_not_lt. integral. Qed.
