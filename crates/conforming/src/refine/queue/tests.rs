use delone_workloads::Rng;

use super::*;

/// Beside a list that is searched.
#[test]
fn the_most_urgent_come_first_and_the_rest_in_order() {
    let mut random = Rng::new(5);
    let mut queue = Queue::default();
    let mut list: Vec<([usize; 2], CellId)> = Vec::new();
    for number in 0..3_000 {
        if random.below(5) < 3 {
            let [edge, angle] = [0; 2].map(|_| f64::from(u8::try_from(random.below(200)).unwrap()));
            let urgency = Urgency::new(edge * 1e-3, angle * angle * 1e-6);
            queue.push(urgency, CellId::new(number), [VertexId::GHOST; 3]);
            list.push(([urgency.level, urgency.step], CellId::new(number)));
        } else {
            let first = (0..list.len()).min_by_key(|&i| list[i].0);
            let expected = first.map(|i| list.remove(i).1);
            assert_eq!(queue.pop().map(|(cell, _)| cell), expected);
        }
    }
}

#[test]
fn shorter_edges_then_smaller_angles_are_more_urgent() {
    let key = |shortest, tangent| {
        let Urgency { level, step } = Urgency::new(shortest, tangent);
        [level, step]
    };
    assert!(key(1.0, 0.3) < key(4.0, 1e-9), "edges first");
    assert!(key(1.0, 1e-3) < key(1.0, 0.3), "then angles");
    assert_eq!(key(1.0, 0.0), key(1.4, 1e-12), "up to a factor");
    assert!(key(1.0, 0.3) < key(1.5, 0.0), "which is less than 1.5");
    let extremes = [f64::MAX, f64::INFINITY, 0.0, 5e-324];
    assert!(extremes.into_iter().all(|x| {
        let [level, step] = key(x, x);
        level < LEVELS && step < STEPS
    }));
}
