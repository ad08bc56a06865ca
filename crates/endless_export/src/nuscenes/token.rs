//! Tokens: 32 hexadecimal digits.

/// The token of a row, of the words that name it.
pub(super) fn token(table: &str, words: &[&str]) -> String {
    let mut hasher = blake3::Hasher::new();
    hasher.update(table.as_bytes());
    for word in words {
        hasher.update(&[0]);
        hasher.update(word.as_bytes());
    }
    hasher.finalize().to_hex()[..32].to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_differ_where_their_words_do() {
        let all = [token("a", &["b", "c"]), token("a", &["bc"]), token("ab", &["c"]), token("a", &["b", "d"])];
        assert!(all.iter().all(|t| t.len() == 32));
        assert!((0..4).all(|i| (0..i).all(|j| all[i] != all[j])));
    }
}
