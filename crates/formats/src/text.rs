//! Text as lines and as tokens, each with its line number, and the numbers in them.
//!
//! Headers are never trusted: an announced count only bounds a loop whose every turn takes a token, so a count of
//! 10^18 costs one turn more than the file has tokens, and nothing is allocated by it.

use crate::error::{ReadError, at, shorten};

/// A line with something on it, trimmed, without its comment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<'a> {
    pub(crate) number: usize,
    pub(crate) text: &'a str,
}

impl<'a> Line<'a> {
    /// Fields between blanks, commas or semicolons.
    pub(crate) fn fields(&self) -> impl Iterator<Item = &'a str> + Clone + use<'a> {
        self.text.split(is_separator).filter(|field| !field.is_empty())
    }
}

fn is_separator(c: char) -> bool {
    c.is_whitespace() || c == ',' || c == ';'
}

/// Bytes as text: a byte order mark goes, bytes that are no UTF-8 (old comments) become replacement characters.
pub(crate) fn decode(bytes: &[u8]) -> std::borrow::Cow<'_, str> {
    String::from_utf8_lossy(bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes))
}

/// Lines that are not blank once the comment from `comment` on is cut off.
pub(crate) fn lines(text: &str, comment: Option<char>) -> impl Iterator<Item = Line<'_>> + Clone {
    text.split('\n').enumerate().filter_map(move |(i, text)| {
        let text = match comment.and_then(|mark| text.find(mark)) {
            Some(end) => &text[..end],
            None => text,
        };
        let text = text.trim();
        (!text.is_empty()).then_some(Line { number: i + 1, text })
    })
}

/// One field and where it stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Token<'a> {
    pub(crate) text: &'a str,
    pub(crate) line: usize,
    /// First on its line.
    pub(crate) leads: bool,
}

/// All fields of a text, with a cursor that can be set back.
#[derive(Clone, Debug)]
pub(crate) struct Tokens<'a> {
    items: Vec<Token<'a>>,
    pub(crate) cursor: usize,
    last_line: usize,
}

impl<'a> Tokens<'a> {
    pub(crate) fn new(text: &'a str, comment: Option<char>) -> Self {
        let mut items = Vec::new();
        for line in lines(text, comment) {
            for (i, text) in line.fields().enumerate() {
                items.push(Token { text, line: line.number, leads: i == 0 });
            }
        }
        let last_line = items.last().map_or(1, |token| token.line);
        Self { items, cursor: 0, last_line }
    }

    pub(crate) fn len(&self) -> usize {
        self.items.len()
    }

    pub(crate) fn is_done(&self) -> bool {
        self.cursor >= self.items.len()
    }

    pub(crate) fn peek(&self) -> Option<Token<'a>> {
        self.items.get(self.cursor).copied()
    }

    pub(crate) fn next(&mut self, expected: &str) -> Result<Token<'a>, ReadError> {
        let token = self.peek().ok_or_else(|| ReadError::truncated(self.last_line, expected))?;
        self.cursor += 1;
        Ok(token)
    }

    pub(crate) fn number(&mut self, expected: &str) -> Result<f64, ReadError> {
        let token = self.next(expected)?;
        number(token.text, token.line, expected)
    }

    pub(crate) fn count(&mut self, expected: &str) -> Result<usize, ReadError> {
        let token = self.next(expected)?;
        count(token.text, token.line, expected)
    }

    /// An index among `points` points numbered from `first`, 0-based.
    pub(crate) fn index(&mut self, first: usize, points: usize) -> Result<u32, ReadError> {
        let token = self.next("a point index")?;
        index(token.text, token.line, first, points)
    }

    pub(crate) fn finish(&self, expected: &str) -> Result<(), ReadError> {
        match self.peek() {
            None => Ok(()),
            Some(token) => Err(ReadError::malformed(token.line, expected, token.text)),
        }
    }
}

/// The nearest double; `1.5D+3` of Fortran is understood, `inf` and `nan` are passed on.
pub(crate) fn parse_number(text: &str) -> Option<f64> {
    text.parse().ok().or_else(|| {
        let mantissa = text.find(['d', 'D'])?;
        let (head, tail) = text.split_at(mantissa);
        let plain = |s: &str| s.bytes().all(|b| b.is_ascii_digit() || b"+-.".contains(&b));
        let exponent = &tail[1..];
        (plain(head) && plain(exponent)).then(|| format!("{head}e{exponent}").parse().ok())?
    })
}

pub(crate) fn number(text: &str, line: usize, expected: &str) -> Result<f64, ReadError> {
    parse_number(text).ok_or_else(|| ReadError::malformed(line, expected, text))
}

pub(crate) fn count(text: &str, line: usize, expected: &str) -> Result<usize, ReadError> {
    text.parse().map_err(|_| ReadError::malformed(line, expected, text))
}

pub(crate) fn index(
    text: &str,
    line: usize,
    first: usize,
    points: usize,
) -> Result<u32, ReadError> {
    if text.parse::<i128>().is_err() {
        return Err(ReadError::malformed(line, "a point index", text));
    }
    text.parse::<usize>()
        .ok()
        .and_then(|i| i.checked_sub(first))
        .filter(|&i| i < points)
        .and_then(|i| u32::try_from(i).ok())
        .ok_or_else(|| ReadError::IndexOutOfRange {
            at: at(line),
            index: shorten(text),
            first,
            count: points,
        })
}

/// Whole numbers, the text's own word for a count: `12`, not `12.0` and not `-1`.
pub(crate) fn is_count(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

#[cfg(test)]
mod tests;
