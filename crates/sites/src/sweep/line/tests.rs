use super::*;
use crate::scatter;

/// The list against a plain sorted vector: it grows to some thousands and shrinks to nothing, twice.
#[test]
fn the_line_is_a_sorted_list() {
    let (mut line, mut model) = (Line::default(), Vec::<u32>::new());
    for step in 0..40_000u64 {
        let value = u32::try_from(scatter(step) % 30_000).unwrap();
        let place = line.search(|other| other < value);
        let index = model.partition_point(|&other| other < value);
        let before = index.checked_sub(1).map(|before| model[before]);
        assert_eq!(line.around(place), [before, model.get(index).copied()]);
        let grows = step / 10_000 % 2 == 0;
        if grows && model.get(index) != Some(&value) {
            model.insert(index, value);
            let put = line.insert(place, value);
            assert_eq!(line.around(put), [before, Some(value)]);
            let found = line.find(value).map(|place| line.around(place));
            assert_eq!(found, Some([before, Some(value)]));
        } else if !grows && !model.is_empty() {
            let place = if index < model.len() { place } else { line.search(|_| false) };
            let index = if index < model.len() { index } else { 0 };
            let gone = model.remove(index);
            let after = line.remove(place);
            assert_eq!(line.at(after), model.get(index).copied());
            assert!(line.find(gone).is_none());
        }
    }
    assert!(model.is_empty() && line.chunks.is_empty());
}
