//! No file is a room too large to know, and none holds an unfinished marker.

use super::Source;

const LINES_MAX: usize = 500;

pub(crate) fn broken(sources: &[Source]) -> Vec<String> {
    let mut broken = Vec::new();
    for source in sources.iter().filter(|source| source.has_extension("rs")) {
        let path = source.path.display();
        let lines = source.text.lines().count();
        if lines > LINES_MAX {
            broken.push(format!("{path}: {lines} lines are over {LINES_MAX}: split the file"));
        }
        let markers = [
            concat!("TO", "DO"),
            concat!("FIX", "ME"),
            concat!("todo", "!("),
            concat!("unimplemented", "!("),
        ];
        for (number, line) in source.text.lines().enumerate() {
            if let Some(marker) = markers.iter().find(|marker| line.contains(**marker)) {
                broken.push(format!("{path}:{}: {marker} is left", number + 1));
            }
        }
    }
    broken
}
