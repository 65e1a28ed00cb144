//! A report: one HTML file that needs nothing else.

mod base64;
mod canvas;
mod scene;
mod table;

use crate::svg::{Picture, Style};
use crate::text::Escaped;
pub use scene::{Scene, Span, Step};
use std::fmt::Write;
use std::io;
pub use table::{Cell, Table, Tone};

/// Contents longer than this are folded away.
const CONTENTS_SHOWN_MAX: usize = 30;

/// A picture with more edges than this becomes a canvas: browsers draw larger SVGs slowly.
pub const SVG_EDGES_MAX: usize = 10_000;

const STYLE: &str = include_str!("html/report.css");
const SCRIPT: &str = include_str!("html/report.js");
const SCENE_SCRIPT: &str = include_str!("html/scene.js");

/// A place in a report that links can go to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Anchor(String);

impl Anchor {
    /// From any text: letters and digits stay, everything else becomes a dash. Equal texts give equal anchors.
    #[must_use]
    pub fn new(text: &str) -> Self {
        let dashed = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
        Self(format!("at-{}", text.chars().map(dashed).collect::<String>()))
    }
}

/// A report under construction; what is added appears in the order of the calls.
#[derive(Clone, Debug)]
pub struct Report {
    title: String,
    lead: String,
    body: String,
    contents: Vec<(Anchor, String)>,
    canvases: usize,
}

impl Report {
    /// An empty report.
    #[must_use]
    pub fn new(title: &str) -> Self {
        Self {
            title: title.to_owned(),
            lead: String::new(),
            body: String::new(),
            contents: Vec::new(),
            canvases: 0,
        }
    }

    /// A line under the title: what was run, with what.
    pub fn lead(&mut self, text: &str) {
        text.clone_into(&mut self.lead);
    }

    /// A heading, listed in the contents, that links to `anchor` go to.
    pub fn heading(&mut self, text: &str, anchor: &Anchor) {
        self.contents.push((anchor.clone(), text.to_owned()));
        self.add(format_args!("<h2 id=\"{}\">{}</h2>\n", anchor.0, Escaped(text)));
    }

    /// A heading below the last one.
    pub fn subheading(&mut self, text: &str) {
        self.add(format_args!("<h3>{}</h3>\n", Escaped(text)));
    }

    /// A paragraph of plain text.
    pub fn paragraph(&mut self, text: &str) {
        self.add(format_args!("<p>{}</p>\n", Escaped(text)));
    }

    /// A paragraph that stands out: the verdict, a fault, a warning.
    pub fn notice(&mut self, tone: Tone, text: &str) {
        self.add(format_args!("<p class=\"notice {}\">{}</p>\n", tone.class(), Escaped(text)));
    }

    /// Text in fixed width, line breaks kept: a replay command, coordinates.
    pub fn code(&mut self, text: &str) {
        self.add(format_args!("<pre><code>{}</code></pre>\n", Escaped(text)));
    }

    /// A table, sortable by a click on a column's head.
    pub fn table(&mut self, table: &Table) {
        table.write(&mut self.body);
    }

    /// An SVG element, such as [`Picture::svg`](crate::Picture::svg) or [`Solid::svg`](crate::Solid::svg) return; taken as it is.
    pub fn svg(&mut self, svg: &str, caption: &str) {
        self.add(format_args!("<figure><div class=\"plate\">{}</div>", svg.trim_end()));
        self.caption(caption);
    }

    /// A picture: as SVG up to [`SVG_EDGES_MAX`] edges, as a canvas with pan and zoom above.
    pub fn picture(&mut self, picture: &Picture<'_>, style: &Style, caption: &str) {
        let edges = picture.edges();
        let count = edges.len() + picture.segments.len();
        if count.max(picture.points.len()) <= SVG_EDGES_MAX {
            return self.svg(&picture.svg(style), caption);
        }
        self.canvases += 1;
        canvas::write(&mut self.body, self.canvases, picture, &edges, style);
        self.caption(caption);
    }

    /// A scene: layers to switch and, if it moves, steps to go through.
    pub fn scene(&mut self, scene: &Scene, style: &Style, caption: &str) {
        self.canvases += 1;
        scene.write(&mut self.body, self.canvases, style);
        self.caption(caption);
    }

    /// Whatever `fill` adds, folded away under `summary` until asked for. Printing shows it.
    pub fn details(&mut self, summary: &str, fill: impl FnOnce(&mut Self)) {
        self.add(format_args!("<details><summary>{}</summary>\n", Escaped(summary)));
        fill(self);
        self.body.push_str("</details>\n");
    }

    /// Whatever `fill` adds, in columns as far as the window is wide: a picture beside its table.
    pub fn columns(&mut self, fill: impl FnOnce(&mut Self)) {
        self.body.push_str("<div class=\"columns\">\n");
        fill(self);
        self.body.push_str("</div>\n");
    }

    /// The whole file.
    #[must_use]
    pub fn finish(&self) -> String {
        let title = Escaped(&self.title);
        let mut out = format!(
            "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n\
             <meta charset=\"utf-8\"/>\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
             <meta name=\"color-scheme\" content=\"light dark\"/>\n\
             <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
             <header><h1>{title}</h1>\n"
        );
        // Writing to a String cannot fail.
        if !self.lead.is_empty() {
            let _ = writeln!(out, "<p class=\"lead\">{}</p>", Escaped(&self.lead));
        }
        if self.contents.len() > 2 {
            let folded = self.contents.len() > CONTENTS_SHOWN_MAX;
            if folded {
                let count = self.contents.len();
                let _ = write!(out, "<details><summary>Contents ({count})</summary>");
            }
            out.push_str("<nav aria-label=\"Contents\">");
            for (anchor, text) in &self.contents {
                let _ = write!(out, "<a href=\"#{}\">{}</a> ", anchor.0, Escaped(text));
            }
            out.push_str(if folded { "</nav></details>\n" } else { "</nav>\n" });
        }
        let _ = write!(out, "</header>\n<main>\n{}</main>\n", self.body);
        // The markers hide the script's `<` and `&` from an XML parser, and are comments to JavaScript.
        let _ = write!(
            out,
            "<script>//<![CDATA[\n{SCRIPT}{SCENE_SCRIPT}//]]></script>\n</body>\n</html>\n"
        );
        out
    }

    /// [`Report::finish`] into a file or the like.
    ///
    /// # Errors
    /// If writing fails.
    pub fn write(&self, out: &mut impl io::Write) -> io::Result<()> {
        out.write_all(self.finish().as_bytes())
    }

    fn caption(&mut self, text: &str) {
        self.add(format_args!("<figcaption>{}</figcaption></figure>\n", Escaped(text)));
    }

    fn add(&mut self, text: std::fmt::Arguments<'_>) {
        let _ = self.body.write_fmt(text);
    }
}

#[cfg(test)]
mod tests;
