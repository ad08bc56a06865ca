//! XML elements to write.

use std::fmt::Display;

/// An element with its attributes, children and text.
#[derive(Debug, Clone, Default)]
pub(super) struct ElementWriter {
    name: &'static str,
    attributes: Vec<(&'static str, String)>,
    children: Vec<ElementWriter>,
    text: String,
}

impl ElementWriter {
    pub(super) fn new(name: &'static str) -> Self {
        Self { name, ..Self::default() }
    }

    pub(super) fn with(mut self, name: &'static str, value: impl Display) -> Self {
        self.attributes.push((name, format!("{value}")));
        self
    }

    /// With the four coefficients of a cubic.
    pub(super) fn with_cubic(self, abcd: [f64; 4]) -> Self {
        let [a, b, c, d] = abcd.map(number);
        self.with("a", a).with("b", b).with("c", c).with("d", d)
    }

    pub(super) fn text(mut self, text: &str) -> Self {
        self.text = text.to_owned();
        self
    }

    pub(super) fn push(&mut self, child: ElementWriter) {
        self.children.push(child);
    }

    pub(super) fn holding(mut self, children: impl IntoIterator<Item = ElementWriter>) -> Self {
        self.children.extend(children);
        self
    }

    pub(super) fn write(&self, depth: usize, out: &mut String) {
        let indent = "  ".repeat(depth);
        out.push_str(&indent);
        out.push('<');
        out.push_str(self.name);
        for (name, value) in &self.attributes {
            out.push(' ');
            out.push_str(name);
            out.push_str("=\"");
            escape(value, out);
            out.push('"');
        }
        if self.children.is_empty() && self.text.is_empty() {
            out.push_str("/>\n");
            return;
        }
        out.push('>');
        if !self.text.is_empty() {
            // `]]>` would end the section early.
            out.push_str(&format!("<![CDATA[{}]]>", self.text.replace("]]>", "]] >")));
        }
        if !self.children.is_empty() {
            out.push('\n');
            for child in &self.children {
                child.write(depth + 1, out);
            }
            out.push_str(&indent);
        }
        out.push_str(&format!("</{}>\n", self.name));
    }
}

fn escape(value: &str, out: &mut String) {
    for c in value.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
}

/// A number to a tenth of a nanometre.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.10}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_needs_escaping_is_escaped() {
        let mut text = String::new();
        ElementWriter::new("a")
            .with("x", "1 < \"2\" & 3")
            .holding([ElementWriter::new("b").text("t")])
            .write(0, &mut text);
        assert_eq!(text, "<a x=\"1 &lt; &quot;2&quot; &amp; 3\">\n  <b><![CDATA[t]]></b>\n</a>\n");
        assert_eq!([0.0, -0.0, 1.5, -2.25e-3, 1e5].map(number), ["0", "0", "1.5", "-0.00225", "100000"]);
    }
}
