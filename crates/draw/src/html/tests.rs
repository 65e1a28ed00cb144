use super::base64::encode;
use super::{Anchor, Cell, Report, SVG_EDGES_MAX, Table, Tone};
use crate::{Picture, Style};
use roxmltree::{Document, ParsingOptions};

const NASTY: &str = "</script><b>&'\"]]>\u{0}";

fn parse(html: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(html, options).unwrap()
}

fn nasty() -> Report {
    let mut report = Report::new(NASTY);
    report.lead(NASTY);
    for _ in 0..3 {
        report.heading(NASTY, &Anchor::new(NASTY));
    }
    report.subheading(NASTY);
    report.paragraph(NASTY);
    report.notice(Tone::Fault, NASTY);
    report.code(NASTY);
    let mut table = Table::new([NASTY, "n"]);
    table.caption(NASTY);
    table.row([Cell::text(NASTY).hover(NASTY).fault(), Cell::count(1234)]);
    table.group();
    table.row([Cell::link(NASTY, &Anchor::new(NASTY)), Cell::real(f64::NAN, 2)]);
    table.row([
        Cell::code(NASTY).ok(),
        Cell::real(-1234.5, 2).bar(f64::NAN),
        Cell::text("dropped"),
    ]);
    table.row([]);
    report.table(&table);
    let style = Style { title: NASTY.to_owned(), ..Style::default() };
    report.picture(&Picture { points: &[[0.0, 0.0]], ..Picture::default() }, &style, NASTY);
    let many = vec![[0.0, 1.0]; SVG_EDGES_MAX + 1];
    report.picture(&Picture { points: &many, ..Picture::default() }, &style, NASTY);
    report.details(NASTY, |inner| inner.columns(|inner| inner.paragraph(NASTY)));
    report
}

#[test]
fn text_is_escaped_wherever_it_goes() {
    let html = nasty().finish();
    let document = parse(&html);
    assert!(!html.contains("<b>"));
    let shown = NASTY.replace('\0', "\u{fffd}");
    for tag in ["title", "h1", "h2", "h3", "p", "code", "caption", "td", "summary", "figcaption"] {
        let has = |n: roxmltree::Node<'_, '_>| {
            n.tag_name().name() == tag && n.descendants().any(|d| d.text() == Some(&shown))
        };
        assert!(document.descendants().any(has), "{tag}");
    }
}

#[test]
fn an_empty_report_is_well_formed_and_nothing_is_fetched() {
    let empty = Report::new("").finish();
    parse(&empty);
    let html = nasty().finish();
    let document = parse(&html);
    for node in document.descendants() {
        assert!(node.attribute("src").is_none() && node.tag_name().name() != "link");
        assert!(node.attribute("href").is_none_or(|to| to.starts_with('#')));
    }
    assert!(!html.contains("url(") && !html.contains("@import") && !html.contains("fetch("));
    assert_eq!(html, nasty().finish());
}

#[test]
fn links_find_their_anchors() {
    let html = nasty().finish();
    let document = parse(&html);
    let ids: Vec<_> = document.descendants().filter_map(|n| n.attribute("id")).collect();
    let mut links = document.descendants().filter_map(|n| n.attribute("href"));
    assert!(links.all(|to| ids.contains(&&to[1..])));
}

#[test]
fn columns_of_numbers_are_to_the_right_and_keep_their_keys() {
    let mut table = Table::new(["name", "count", "mixed"]);
    table.row([Cell::text("a"), Cell::count(1_234_567), Cell::count(1)]);
    table.row([Cell::text("b"), Cell::real(f64::INFINITY, 1), Cell::text("refused")]);
    let mut out = String::new();
    table.write(&mut out);
    assert!(
        out.contains("<td class=\"number\" data-key=\"1234567\">1\u{202f}234\u{202f}567</td>"),
        "{out}"
    );
    assert_eq!(out.matches("<th scope=\"col\" class=\"number\">").count(), 1);
    assert!(out.contains("\u{2013}"));
}

#[test]
fn large_pictures_become_canvases_with_all_their_data() {
    let n = 200_u32;
    let points: Vec<[f64; 2]> = (0..n * n).map(|i| [f64::from(i % n), f64::from(i / n)]).collect();
    let corner = |i: u32| [i, i + 1, i + n];
    let triangles: Vec<[u32; 3]> = (0..n * (n - 1)).filter(|i| i % n + 1 < n).map(corner).collect();
    let classes = vec![1; triangles.len()];
    let picture =
        Picture { points: &points, triangles: &triangles, classes: &classes, ..Picture::default() };
    let mut report = Report::new("large");
    report.picture(&picture, &Style::default(), "");
    let html = report.finish();
    let document = parse(&html);
    let data = |name: &str| {
        let node = document.descendants().find(|n| n.attribute("data-name") == Some(name)).unwrap();
        node.text().map_or(0, |text| text.len() / 4 * 3)
    };
    assert!(data("points").abs_diff(8 * points.len()) < 3);
    assert!(data("edges").abs_diff(8 * picture.edges().len()) < 3);
    assert!(data("fills").abs_diff(16 * triangles.len()) < 3);
}

/// The vectors of RFC 4648, section 10.
#[test]
fn base64_is_the_standard_one() {
    let cases = ["", "f", "fo", "foo", "foob", "fooba", "foobar"];
    let codes = ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"];
    for (text, code) in cases.into_iter().zip(codes) {
        assert_eq!(encode(text.as_bytes()), code);
    }
    assert_eq!(encode(&[0xfb, 0xff]), "+/8=");
}
