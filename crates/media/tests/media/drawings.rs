//! What is read as a drawing, and what is not.

use tumbling_media::Drawing;

fn text(words: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"20\"><title>a &lt; b</title>\
         <text y=\"15\">{words}</text></svg>"
    )
}

#[test]
fn letters_that_the_fonts_lack_are_named() {
    let refused = Drawing::read(&text("ω = 3 rad/s 小")).unwrap_err().to_string();
    assert_eq!(refused, "the fonts of exported drawings have no letters for `小`");
}

#[test]
fn letters_of_europe_and_of_formulas_are_there() {
    let all = "Łódź žluťoučký Größe αβγδεζηθικλμνξοπρστυφχψω ΔΣΩ ⁻⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂ − × · ½ ° ± ≤ ≥ ≈ √ ∞ → “”’…";
    Drawing::read(&text(all)).unwrap();
}

#[test]
fn a_drawing_keeps_its_title_and_takes_its_size() {
    let drawing = Drawing::read(&text("spin")).unwrap();
    assert_eq!(drawing.size(), [100.0, 20.0]);
    let svg = drawing.svg(Some(250));
    assert!(svg.starts_with(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"250\" height=\"50\" viewBox=\"0 0 100 20\">"
    ));
    assert!(svg.contains("<title>a &lt; b</title>") && svg.ends_with("</svg>\n"), "{svg}");
    let picture = drawing.picture(250).unwrap();
    assert_eq!((picture.width, picture.height, picture.pixels.len()), (250, 50, 250 * 50));
    assert!(picture.pixels.contains(&[0, 0, 0]) && picture.pixels.contains(&[255, 255, 255]));
}

#[test]
fn no_picture_and_too_large_a_one_are_refused_in_a_sentence() {
    let drawing = Drawing::read(&text("spin")).unwrap();
    for width in [0, 1_000_000] {
        let refused = drawing.picture(width).unwrap_err().to_string();
        assert!(refused.ends_with("pixels are no picture, or too large a one"), "{refused}");
    }
    assert!(Drawing::read("<p>").unwrap_err().to_string().starts_with("the drawing: "));
}
