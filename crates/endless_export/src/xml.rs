//! Text in XML files.

/// With the five characters that mean something to XML as entities; what XML cannot say at all is left out.
pub(crate) fn escaped(text: &str) -> String {
    let said: String = text.chars().filter(|&c| !c.is_control() || matches!(c, '\t' | '\n' | '\r')).collect();
    quick_xml::escape::escape(said.as_str()).into_owned()
}

#[cfg(test)]
mod tests {
    #[test]
    fn markup_is_text() {
        assert_eq!(super::escaped("a<b>&\"c\"\u{1}"), "a&lt;b&gt;&amp;&quot;c&quot;");
    }
}
