//! Texts in commands of a shell.

/// A word of a shell's command that means this text.
pub(super) fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=@%+,".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        return text.to_owned();
    }
    format!("'{}'", text.replace('\'', r"'\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_shell_mean_the_text() {
        for text in ["/a/b.toml", "", "it's here", "$HOME `x` \"y\" \\ \n!", "s3://bucket/a b"] {
            let said = std::process::Command::new("bash").args(["-c", &format!("printf %s {}", quoted(text))]).output();
            assert_eq!(said.expect("bash").stdout, text.as_bytes(), "{text}");
        }
        assert_eq!(quoted("/a/b.toml"), "/a/b.toml");
    }
}
