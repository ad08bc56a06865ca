//! Choices from lists that may grow.

use endless_world::{Stream, fnv1a};

/// One of some alternatives, in proportion to their weights, each by its name: one more in a list changes only the
/// people who get it.
///
/// # Panics
/// If no weight is positive.
pub(crate) fn choose<T: Copy + Into<&'static str>>(s: &mut Stream, alternatives: &[(T, f64)]) -> T {
    let keyed = alternatives.iter().map(|&(name, weight)| {
        let name: &str = name.into();
        (fnv1a(name.bytes()), weight)
    });
    let index = s.weighted_by_key(keyed);
    alternatives[index.expect("some alternative has a weight")].0
}

#[cfg(test)]
mod tests {
    use super::super::appearance::Hat;
    use super::*;

    #[test]
    fn a_hat_more_changes_only_the_people_who_wear_it() {
        let few = [(Hat::None, 74.0), (Hat::Cap, 12.0), (Hat::Brimmed, 5.0)];
        let more = [(Hat::Beanie, 14.0), (Hat::None, 74.0), (Hat::Cap, 12.0), (Hat::Brimmed, 5.0)];
        let mut beanies = 0;
        for person in 0..2000 {
            let [mut before, mut after] = [Stream::new(person, &[]), Stream::new(person, &[])];
            let hats = [choose(&mut before, &few), choose(&mut after, &more)];
            beanies += usize::from(hats[1] == Hat::Beanie);
            assert!(hats[0] == hats[1] || hats[1] == Hat::Beanie, "{hats:?}");
            assert_eq!(before.next_u64(), after.next_u64(), "what is drawn next depends on the list");
        }
        assert!((200..340).contains(&beanies), "{beanies} of 2000 wear a beanie");
    }
}
