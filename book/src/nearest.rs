//! Which names are nearest to one that does not exist.

/// A sentence to append: ` Did you mean ...?`, or nothing where no name is near.
pub(crate) fn perhaps<'a>(wrong: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let wrong = wrong.to_lowercase();
    let mut near: Vec<(f64, &str)> = known
        .into_iter()
        .map(|name| {
            // A part of a name typed right counts as near: `gap` for `gap-by-direction`.
            let whole = strsim::normalized_damerau_levenshtein(&wrong, name);
            let part = wrong.len() >= 3 && name.contains(&wrong);
            (if part { whole.max(0.9) } else { whole }, name)
        })
        .filter(|(likeness, _)| *likeness >= 0.45)
        .collect();
    near.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    let names: Vec<String> = near.iter().take(3).map(|(_, name)| format!("`{name}`")).collect();
    match names.as_slice() {
        [] => String::new(),
        [one] => format!(" Did you mean {one}?"),
        [most @ .., last] => format!(" Did you mean {} or {last}?", most.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::perhaps;

    #[test]
    fn near_names_come_nearest_first_and_far_ones_not_at_all() {
        let known = ["two-arrows", "two-axes", "polhodes", "gap-by-direction"];
        assert_eq!(perhaps("two-arows", known), " Did you mean `two-arrows` or `two-axes`?");
        assert_eq!(perhaps("Polhode", known), " Did you mean `polhodes`?");
        assert_eq!(perhaps("gap", known), " Did you mean `gap-by-direction`?");
        assert_eq!(perhaps("zzzzzzzz", known), "");
        assert_eq!(perhaps("", known), "");
    }
}
