//! TeX is read as it is meant, and what could be read in two ways is refused.

use proptest::prelude::*;
use tumbling_proofs::equations::laws;
use tumbling_proofs::symbols::{attitude, diagonal, symmetric, vector};
use tumbling_proofs::tex::{Scope, Statement, parse};
use tumbling_proofs::{Fraction, Polynomial};

fn one(tex: &str) -> Statement {
    parse(tex).unwrap_or_else(|error| panic!("{tex}: {error}")).swap_remove(0)
}

fn letters() -> Scope {
    let scope = ["a", "b", "c", "x"]
        .iter()
        .fold(Scope::default(), |scope, name| scope.with(name, Fraction::variable(name)));
    scope.with("x'", Fraction::variable("y")).with("m_1", Fraction::variable("m")).positive(["a"])
}

fn vectors() -> Scope {
    let names = [r"\mathbf{u}", r"\mathbf{v}", r"\mathbf{w}"];
    let scope = names.iter().fold(letters(), |scope, name| scope.with(name, vector(&name[8..9])));
    scope.with("I", symmetric("I")).with("D", diagonal(&vector("d")))
}

fn holds(scope: &Scope, tex: &str) -> bool {
    one(tex).prove(scope).is_ok()
}

fn refused(tex: &str) -> String {
    parse(tex).map_or_else(|error| error.to_string(), |read| panic!("{tex} is read as {read:?}"))
}

#[test]
fn products_bind_tighter_than_sums_and_powers_tighter_than_products() {
    let scope = letters();
    for tex in [
        "a b + c = c + b a",
        "a + b c^2 = a + b (c^2)",
        "-a^2 = -(a a)",
        "a - b - c = a - (b + c)",
        "2 a^2 b = 2 b a a",
        "a/b + c = (a + b c)/b",
        "a b/c = a (b/c)",
        r"\frac{a + b}{c} = a/c + b/c",
        r"\tfrac{1}{2} a \cdot b = a b/2",
        r"3 \times a = a + a + a",
        "a^{-1} a = 1 + b - b",
        "x' x = x x'",
        "m_1 + m_{1} = 2 m_1",
        "0.5 a = a/2",
        "+a = a",
    ] {
        assert!(holds(&scope, tex), "{tex}");
    }
    for tex in
        ["a b + c = a (b + c)", "-a^2 = (-a)^2", "a - b - c = a - (b - c)", "x' = x", "a/b + c = a/(b + c)"]
    {
        assert!(!holds(&scope, tex), "{tex}");
    }
}

#[test]
fn side_by_side_binds_tighter_than_dot_and_cross() {
    let scope = vectors();
    for tex in [
        r"\mathbf{u} \times \mathbf{v} = -\mathbf{v} \times \mathbf{u}",
        r"(I\,\mathbf{u}) \times \mathbf{v} = I\,\mathbf{u} \times \mathbf{v}",
        r"\mathbf{u} \times (\mathbf{v} \times \mathbf{w}) = \mathbf{v} (\mathbf{u} \cdot \mathbf{w}) - \mathbf{w} (\mathbf{u} \cdot \mathbf{v})",
        r"\mathbf{u} \cdot (\mathbf{v} \times \mathbf{w}) = \mathbf{v} \cdot (\mathbf{w} \times \mathbf{u})",
        r"(I\,D)^{\mathsf{T}} = D\,I",
        r"I^T = I",
        r"D^{-1} \mathbf{u} = D^{-1} (D D^{-1} \mathbf{u})",
        r"I^{-1} I = \begin{pmatrix} 1 & a - a & 0 \\ 0 & 1 & 0 \\ 0 & 0 & 1 \end{pmatrix} + a I - I a",
        r"\begin{pmatrix} a \\ b \\ c \end{pmatrix} = (a, b, c)",
        r"(a, b) = (a, b, c - c)",
    ] {
        assert_eq!(one(tex).prove(&scope), Ok(()), "{tex}");
    }
    for tex in [
        r"\mathbf{u} \times \mathbf{v} = \mathbf{v} \times \mathbf{u}",
        r"I\,D = D\,I",
        r"\mathbf{u}\,\mathbf{v} = \mathbf{v}\,\mathbf{u}",
        r"\mathbf{u} + a = a + \mathbf{u}",
        r"\mathbf{u}\,I = I\,\mathbf{u}",
        r"\mathbf{u}^2 = \mathbf{u} \cdot \mathbf{u}",
        r"\mathbf{u} < \mathbf{v}",
        r"a = \mathbf{u}",
        r"a = q",
        r"a = \sum a",
        r"I = \begin{pmatrix} a & b \\ b & a \end{pmatrix}",
        r"a/\mathbf{u} = a/\mathbf{u}",
        "a/(b - b) = a/(b - b)",
    ] {
        assert!(!holds(&scope, tex), "{tex}");
    }
}

#[test]
fn quaternions_multiply_as_hamilton_said() {
    let (q, unit) = attitude();
    let scope = vectors().with("q", q).under(unit);
    assert!(holds(
        &scope,
        r"(0, \mathbf{u})\,(0, \mathbf{v}) = (-\mathbf{u} \cdot \mathbf{v}, \mathbf{u} \times \mathbf{v})"
    ));
    assert!(holds(&scope, r"q\,(a, \mathbf{u} - \mathbf{u}) = a\,q"));
    assert!(!holds(&scope, r"q\,(0, \mathbf{u}) = (0, \mathbf{u})\,q"));
}

#[test]
fn inequalities_are_shown_by_signs() {
    let scope = letters();
    for tex in [
        "a > 0",
        "a + b^2 > 0",
        "b^2 \\ge 0",
        "a + b^2 + 1 \\ge 1",
        "0 < a",
        "0 \\le b^2 a",
        "-a < 0 < a",
        "(a + 1)/a > 0",
    ] {
        assert!(holds(&scope, tex), "{tex}");
    }
    for tex in [
        "b > 0",
        "b^2 > 0",
        "a < 0",
        "a - 1 > 0",
        "a b \\ge 0",
        "1/(a - a) > 0",
        "-a < a < 0",
        "1/(a - 1) > 0",
    ] {
        assert!(!holds(&scope, tex), "{tex}");
    }
    // A root is not below zero.
    assert!(holds(&scope, r"\sqrt{a^2} = a"));
    assert!(!holds(&scope, r"\sqrt{b^2} = b"));
    assert!(!holds(&scope, r"\sqrt{a^2} = -a"));
}

#[test]
fn lists_rows_and_marks_of_the_sentence_are_told_apart() {
    let count = |tex: &str| parse(tex).unwrap().len();
    assert_eq!(count(r"a = b, \qquad c = d."), 2);
    assert_eq!(count(r"a = b \qquad\text{(wrong, in the world)}"), 1);
    assert_eq!(count(r"a, \qquad b = c,"), 2);
    assert_eq!(count("a = b, c = d"), 2);
    assert_eq!(count(r"\begin{aligned} a &= b, \\ c &= d, \\ e &= f. \end{aligned}"), 3);
    assert_eq!(one(r"a = 2.").others[0].1.text, "2");
    assert_eq!(
        one(r"x_{\text{body}} = \dot{\boldsymbol{\omega}}_1").text,
        r"x_{\text{body}}= \dot{\boldsymbol{\omega}}_1"
    );
    // A tuple of numbers is the value of a vector, which is set bold.
    assert!(one(r"\boldsymbol{a} = (0.833,\; 1, -2)").gives_values());
    assert!(!one(r"a = (0.833,\; 1, -2)").gives_values());
    assert!(!one("0 = a").gives_values());
}

#[test]
fn what_is_not_read_is_refused_with_its_place() {
    for (tex, error) in [
        ("", "expected a number, a name or a bracket at byte 0"),
        ("a = ", "expected a number, a name or a bracket at byte 4"),
        ("a = b)", "expected an operator, a factor or the end at byte 5"),
        ("(a = b", "expected a comma or a closing bracket at byte 3"),
        (r"a \times b \times c", "expected brackets that say which product comes first at byte 11"),
        ("a/b c", "expected brackets that say what is under the bar at byte 4"),
        ("x^12", "expected a whole power from 0 to 16, in braces unless one digit at byte 2"),
        ("x^{17}", "expected a whole power from 0 to 16, in braces unless one digit at byte 3"),
        ("x^y", "expected a whole power or the T of a transpose at byte 2"),
        ("x^2^2", "expected brackets, not a second exponent or an index after one at byte 3"),
        ("x_12", "expected braces around the index at byte 2"),
        ("x_{}", "expected an index of letters, digits or text at byte 3"),
        (r"\mathcal{L}", "expected a name, or a command that the book's equations use at byte 0"),
        (r"\tfrac12 a", "expected an opening brace at byte 6"),
        (r"\frac{a}", "expected an opening brace at byte 8"),
        (r"\sin(a + b)", "expected a closing bracket: only functions of a name are read at byte 7"),
        (r"\text{open", "expected a closing brace at byte 10"),
        (
            r"\begin{pmatrix} a & b",
            "expected the next entry, the next row or the end of the matrix at byte 21",
        ),
        ("a \\", "expected a command after the backslash at byte 2"),
    ] {
        assert_eq!(refused(tex), error, "{tex}");
    }
    assert!(refused(&"(".repeat(100_000)).contains("this deep"));
    assert!(refused(&r"\dot".repeat(100_000)).contains("this deep"));
    assert!(refused(&r"\sum".repeat(100_000)).contains("this deep"));
    assert!(refused(&r"\sqrt{".repeat(100_000)).contains("this deep"));
}

/// Each text is short; worked out, each would fill a library.
#[test]
fn towers_of_powers_are_refused() {
    for base in ["9", "a", "(a + b + c + 1)", "(a + 1/b)"] {
        let tower = (0..12).fold(base.to_owned(), |tower, _| format!("({tower})^9"));
        let error = one(&format!("{tower} = 1 + b")).prove(&letters()).unwrap_err();
        assert!(error.contains("is not worked out"), "{error}");
    }
}

/// TeX of an expression, and its worth computed on the side.
fn expression() -> impl Strategy<Value = (String, Polynomial)> {
    let number = (0..20_i64).prop_map(|n| (n.to_string(), Polynomial::from(n)));
    let name =
        prop::sample::select(vec!["a", "b", "c"]).prop_map(|n| (n.to_owned(), Polynomial::variable(n)));
    prop_oneof![number, name].prop_recursive(4, 24, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|((s, x), (t, y))| (format!("({s} + {t})"), x + y)),
            (inner.clone(), inner.clone()).prop_map(|((s, x), (t, y))| (format!("({s} - {t})"), x - y)),
            (inner.clone(), inner.clone()).prop_map(|((s, x), (t, y))| (format!("({s})\\,({t})"), x * y)),
            (inner.clone(), inner.clone()).prop_map(|((s, x), (t, y))| (format!("({s} \\cdot {t})"), x * y)),
            inner.clone().prop_map(|(s, x)| (format!("(-{s})"), -x)),
            inner.prop_map(|(s, x)| (format!("({s})^2"), x.pow(2))),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn expressions_are_worth_what_they_say((tex, worth) in expression(), off in 1..5_i64) {
        let scope = letters().with("e", Fraction::from(worth.clone()));
        let wrong = letters().with("e", Fraction::from(worth + Polynomial::from(off)));
        let statement = one(&format!("{tex} = e"));
        prop_assert_eq!(statement.prove(&scope), Ok(()));
        prop_assert!(statement.prove(&wrong).is_err());
    }

    #[test]
    fn no_text_makes_the_reader_stop(text in any::<String>(), tex in tex_like()) {
        for text in [text, tex] {
            if let Ok(statements) = parse(&text) {
                for statement in statements {
                    let _ = statement.prove(&vectors());
                }
            }
        }
    }
}

/// Pieces of TeX in any order.
fn tex_like() -> impl Strategy<Value = String> {
    let pieces = r"a b I \mathbf{u} \boldsymbol{\omega} 2 0 0.5 + - = < \ge ( ) , ^2 ^{-1} ^{\mathsf{T}} _1 _{xy} { } \frac \sqrt \sum \times \cdot / ' \, \qquad \begin{pmatrix} \end{pmatrix} \begin{aligned} \end{aligned} & \\ \text{x} \dot \tan . \ é";
    let pieces: Vec<_> = pieces.split(' ').collect();
    prop::collection::vec(prop::sample::select(pieces), 0..16).prop_map(|pieces| pieces.join(" "))
}

/// The quotients of (C16), (C29) and (C30), whose factors belong to the law: with another one it is refused.
#[test]
fn jacobis_functions_are_the_quotients_of_the_librarys_sums() {
    for (law, tex, factor) in [
        (laws::SN_BY_THETAS, r"\operatorname{sn} = \frac{n_3\,\theta_1 \sin z}{n_2\,\theta_4}", "n_3"),
        (
            laws::CN_NEAR_THE_SADDLE,
            r"\operatorname{cn} = \frac{k'\,m_3^2\,\theta'_1}{2\,e\,m_4\,m_2\,\theta'_3}",
            "m_4",
        ),
    ] {
        assert_eq!(law.holds(tex), Ok(()));
        assert!(law.holds(&tex.replacen(factor, "3", 1)).is_err(), "{tex}");
    }
}
