//! Lines of a text, for messages of parsers.

/// Tells the lines of bytes, from 1, while a reader goes forward.
#[derive(Debug, Clone)]
pub struct LineNumbers<'a> {
    text: &'a [u8],
    at: usize,
    line: usize,
}

impl<'a> LineNumbers<'a> {
    /// Of a text.
    pub fn new(text: &'a str) -> Self {
        Self { text: text.as_bytes(), at: 0, line: 1 }
    }

    /// The line of a byte not before those asked for already; before them, the last answer.
    pub fn of(&mut self, place: usize) -> usize {
        let place = place.min(self.text.len());
        if place > self.at {
            self.line += self.text[self.at..place].iter().filter(|&&byte| byte == b'\n').count();
            self.at = place;
        }
        self.line
    }
}
