use crate::format::Format;
use crate::testing::{all, refusal};

#[test]
fn geometries_of_cases_are_documents() {
    let text = "<run>\n<case><desc>d</desc>\n<a>\n POINT(1 2)\n</a><b>0101000000000000000000F03F0000000000000040</b>\n<test><op name=\"x\" arg1=\"A\">true</op></test></case>\n<case><a>LINESTRING(0 0,1 1)</a></case></run>";
    let documents = all("a.xml", text);
    let names: Vec<&str> = documents.iter().map(|d| d.name.as_str()).collect();
    assert_eq!(names, ["a.xml#1a", "a.xml#1b", "a.xml#2a"]);
    assert_eq!(documents[1].points, [1.0, 2.0]);
}

#[test]
fn faults_have_their_line() {
    let text = "<run>\n<case>\n<a>\nPOINT(x)</a></case></run>";
    assert_eq!(refusal(Format::JtsXml, text), "t:4: expected a coordinate, found `x)`");
    assert!(refusal(Format::JtsXml, "<run>").contains("well-formed XML"));
    assert!(refusal(Format::JtsXml, "<html/>").contains("a test suite"));
    assert!(refusal(Format::JtsXml, &"<a>".repeat(100_000)).contains("XML"));
}
