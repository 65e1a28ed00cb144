//! Tables: numbers to the right, verdicts in colour, sorted by a click.

use super::Anchor;
use crate::text::{Escaped, Short, grouped};
use std::fmt::Write;

/// What a colour says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tone {
    /// Nothing.
    #[default]
    Plain,
    /// Proved, equal, best.
    Ok,
    /// Refused, left out, worth a look.
    Warn,
    /// Wrong.
    Fault,
}

impl Tone {
    pub(super) fn class(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Ok => "ok",
            Self::Warn => "warn",
            Self::Fault => "fault",
        }
    }
}

/// One cell.
#[derive(Clone, Debug, Default)]
pub struct Cell {
    text: String,
    /// The key by which the column is sorted, where that is a number.
    number: Option<f64>,
    tone: Tone,
    link: Option<Anchor>,
    hover: String,
    bar: Option<f64>,
    code: bool,
}

impl Cell {
    /// Plain text.
    #[must_use]
    pub fn text(text: &str) -> Self {
        Self { text: text.to_owned(), ..Self::default() }
    }

    /// Text in fixed width: a fingerprint, a command.
    #[must_use]
    pub fn code(text: &str) -> Self {
        Self { code: true, ..Self::text(text) }
    }

    /// Text that leads to an anchor.
    #[must_use]
    pub fn link(text: &str, to: &Anchor) -> Self {
        Self { link: Some(to.clone()), ..Self::text(text) }
    }

    /// A count, its digits in groups of three.
    #[must_use]
    pub fn count(count: u64) -> Self {
        Self { number: Some(count as f64), ..Self::text(&grouped(&count.to_string())) }
    }

    /// A number with so many decimals; a dash if it is not finite.
    #[must_use]
    pub fn real(x: f64, decimals: usize) -> Self {
        if !x.is_finite() {
            return Self::text("\u{2013}");
        }
        let text = format!("{:.decimals$}", x.abs());
        let (whole, rest) = text.split_at(text.find('.').unwrap_or(text.len()));
        let sign = if x < 0.0 { "\u{2212}" } else { "" };
        Self { number: Some(x), ..Self::text(&format!("{sign}{}{rest}", grouped(whole))) }
    }

    /// In the colour of what is right.
    #[must_use]
    pub fn ok(self) -> Self {
        self.tone(Tone::Ok)
    }

    /// In the colour of what is wrong.
    #[must_use]
    pub fn fault(self) -> Self {
        self.tone(Tone::Fault)
    }

    /// In a colour.
    #[must_use]
    pub fn tone(self, tone: Tone) -> Self {
        Self { tone, ..self }
    }

    /// With a remark for a hovering mouse.
    #[must_use]
    pub fn hover(self, text: &str) -> Self {
        Self { hover: text.to_owned(), ..self }
    }

    /// With a bar behind the number, 0 to 1 of the cell's width.
    #[must_use]
    pub fn bar(self, part: f64) -> Self {
        Self { bar: Some(if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.0 }), ..self }
    }

    fn write(&self, out: &mut String, right: bool) {
        let tone = if self.tone == Tone::Plain { "" } else { self.tone.class() };
        let side = if right { "number" } else { "" };
        let _ = write!(out, "<td class=\"{}\"", [side, tone].join(" ").trim());
        if let Some(key) = self.number {
            let _ = write!(out, " data-key=\"{key}\"");
        }
        if let Some(part) = self.bar {
            let _ = write!(out, " style=\"--part:{}%\"", Short(100.0 * part));
        }
        if !self.hover.is_empty() {
            let _ = write!(out, " title=\"{}\"", Escaped(&self.hover));
        }
        out.push('>');
        let (open, close) = match &self.link {
            Some(Anchor(id)) => (format!("<a href=\"#{id}\">"), "</a>"),
            None if self.code => ("<code>".to_owned(), "</code>"),
            None if self.tone != Tone::Plain => ("<span>".to_owned(), "</span>"),
            None => (String::new(), ""),
        };
        let _ = write!(out, "{open}{}{close}</td>", Escaped(&self.text));
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::text(text)
    }
}

impl From<u64> for Cell {
    fn from(count: u64) -> Self {
        Self::count(count)
    }
}

/// A table under construction.
#[derive(Clone, Debug)]
pub struct Table {
    caption: String,
    heads: Vec<String>,
    /// Rows, and whether each begins a group.
    rows: Vec<(Vec<Cell>, bool)>,
    group: bool,
}

impl Table {
    /// A table with these columns.
    #[must_use]
    pub fn new<'h>(heads: impl IntoIterator<Item = &'h str>) -> Self {
        let heads = heads.into_iter().map(str::to_owned).collect();
        Self { caption: String::new(), heads, rows: Vec::new(), group: false }
    }

    /// A line above the table.
    pub fn caption(&mut self, text: &str) {
        text.clone_into(&mut self.caption);
    }

    /// A row; cells that are missing are empty, those beyond the last column are dropped.
    pub fn row(&mut self, cells: impl IntoIterator<Item = Cell>) {
        let mut cells: Vec<Cell> = cells.into_iter().collect();
        cells.resize(self.heads.len(), Cell::default());
        self.rows.push((cells, std::mem::take(&mut self.group)));
    }

    /// The next row begins a group: a line is drawn above it.
    pub fn group(&mut self) {
        self.group = !self.rows.is_empty();
    }

    /// A column is to the right if it has a number, and nothing else but dashes and gaps.
    fn is_numeric(&self, column: usize) -> bool {
        let mut cells = self.rows.iter().map(|(cells, _)| &cells[column]);
        let quiet = |cell: &Cell| cell.number.is_some() || cell.text.chars().count() <= 1;
        cells.clone().any(|cell| cell.number.is_some()) && cells.all(quiet)
    }

    pub(super) fn write(&self, out: &mut String) {
        out.push_str("<div class=\"scroll\"><table>");
        if !self.caption.is_empty() {
            let _ = write!(out, "<caption>{}</caption>", Escaped(&self.caption));
        }
        let right: Vec<bool> = (0..self.heads.len()).map(|i| self.is_numeric(i)).collect();
        out.push_str("<thead><tr>");
        for (head, &right) in self.heads.iter().zip(&right) {
            let class = if right { " class=\"number\"" } else { "" };
            let _ = write!(
                out,
                "<th scope=\"col\"{class}><button type=\"button\">{}</button></th>",
                Escaped(head)
            );
        }
        out.push_str("</tr></thead>\n<tbody>\n");
        for (cells, begins) in &self.rows {
            out.push_str(if *begins { "<tr class=\"group\">" } else { "<tr>" });
            cells.iter().zip(&right).for_each(|(cell, &right)| cell.write(out, right));
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody></table></div>\n");
    }
}
