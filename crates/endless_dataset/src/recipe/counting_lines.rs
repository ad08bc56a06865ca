//! Counting lines as users write them.

use super::option::{OptionError, OptionValue, RecipeOption};
use endless_annotate::CountingLine;
use std::collections::BTreeSet;

impl OptionValue for Vec<CountingLine> {
    /// `MAP/NAME:X,Y,X,Y`, and more after semicolons.
    fn from_flag(text: &str) -> Result<Self, String> {
        text.split(';').map(line_from_text).collect()
    }

    fn check(&mut self, option: &RecipeOption) -> Result<(), OptionError> {
        let refuse = |line: &CountingLine, rule: &str| OptionError::OutOfRange {
            field: option.key,
            given: format!("{}/{}", line.map, line.name),
            rule: rule.to_owned(),
        };
        let mut names = BTreeSet::new();
        for line in self.iter() {
            let finite = line.from.iter().chain(&line.to).all(|number| number.is_finite());
            if !finite || line.from == line.to {
                return Err(refuse(line, "its ends are two places, in metres"));
            }
            if line.name.is_empty() || !names.insert((&line.map, &line.name)) {
                return Err(refuse(line, "each line of a map has a name of its own"));
            }
        }
        Ok(())
    }
}

fn line_from_text(text: &str) -> Result<CountingLine, String> {
    let parse = || {
        let (place, ends) = text.split_once(':')?;
        let (map, name) = place.trim().split_once('/')?;
        let numbers: Vec<f64> = ends.split(',').map(|number| number.trim().parse().ok()).collect::<Option<_>>()?;
        let [x0, y0, x1, y1] = numbers[..] else { return None };
        Some(CountingLine { map: map.to_owned(), name: name.to_owned(), from: [x0, y0], to: [x1, y1] })
    };
    parse().ok_or_else(|| format!("'{text}' is no line: write MAP/NAME:X,Y,X,Y, for example Town03/gate:-8,20,4,20"))
}

#[cfg(test)]
mod tests {
    use crate::RecipeDraft;

    fn draft(text: &str) -> Result<RecipeDraft, String> {
        let mut draft = RecipeDraft::default();
        draft.set("counting_lines", text)?;
        draft.check().map_err(|error| error.to_string())?;
        Ok(draft)
    }

    #[test]
    fn lines_are_read_and_refused() {
        let read = draft("Town03/gate:-8,20,4,20.5;Town01/gate:0,0,1,1").expect("two lines").counting_lines;
        let [gate, other] = &read.expect("given")[..] else { panic!("two lines") };
        assert_eq!((gate.from, gate.to, other.map.as_str()), ([-8.0, 20.0], [4.0, 20.5], "Town01"));
        for (wrong, why) in [
            ("gate:1,2,3,4", "MAP/NAME"),
            ("Town03/gate:1,2,3", "MAP/NAME"),
            ("Town03/gate:1,2,1,2", "two places"),
            ("Town03/gate:1,2,nan,2", "two places"),
            ("Town03/gate:1,2,3,4;Town03/gate:1,2,3,5", "a name of its own"),
        ] {
            let error = draft(wrong).expect_err(wrong);
            assert!(error.contains(why), "{error}");
        }
    }
}
