use super::*;

#[test]
fn counts_tally_each_kind_under_its_own_name() {
    let mut counts = Counts::default();
    let events = [
        Event::Orient,
        Event::InSphere,
        Event::InSphere,
        Event::Site { done: 1, total: 2 },
        Event::WalkStep,
        Event::Cavity { cells: 5 },
        Event::Cavity { cells: 3 },
        Event::Flip,
        Event::CircleEvent,
        Event::CircleEvent,
        Event::CircleEvent,
        Event::CellMade,
        Event::EdgeCrossed,
        Event::Subsegment,
        Event::SteinerPoint,
        Event::SteinerPoint,
    ];
    events.iter().for_each(|&event| counts.on(event));
    let values: Vec<u64> = counts.named().iter().map(|&(_, value)| value).collect();
    assert_eq!(values, [1, 2, 1, 1, 2, 8, 5, 1, 3, 1, 1, 1, 2]);
}

#[test]
fn a_borrowed_probe_is_a_probe() {
    fn report(probe: &mut impl Probe) {
        probe.on(Event::Flip);
    }
    let mut counts = Counts::default();
    report(&mut &mut counts);
    assert_eq!(counts.flips, 1);
}
