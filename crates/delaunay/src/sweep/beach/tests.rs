use super::*;

fn in_order(beach: &Beach) -> Vec<CellId> {
    let (mut found, mut stack, mut place) = (Vec::new(), Vec::new(), beach.root);
    while place.is_some() || !stack.is_empty() {
        while let Some(ghost) = place {
            stack.push(ghost);
            place = beach.child(ghost, BEFORE);
        }
        let ghost: CellId = stack.pop().unwrap();
        found.push(ghost);
        place = beach.child(ghost, AFTER);
    }
    found
}

#[test]
fn a_beach_keeps_order_and_heap_as_a_list_does() {
    let (mut beach, mut list) = (Beach::default(), Vec::<CellId>::new());
    let mut free: Vec<usize> = (0..400).collect();
    for step in 0..4000u64 {
        let dice = usize::try_from(scatter(step) >> 33).unwrap();
        let removes = free.is_empty() || !list.is_empty() && dice % 5 > 2;
        let place = (dice / 5) % (list.len() + usize::from(!removes));
        if removes {
            let ghost = list.remove(place);
            beach.remove(ghost);
            free.push(ghost.index());
        } else {
            let ghost = CellId::new(free.swap_remove(dice / 7 % free.len()));
            let below = place.checked_sub(1).map(|i| list[i]);
            beach.insert(below, list.get(place).copied(), ghost);
            list.insert(place, ghost);
        }
        if step % 16 == 0 {
            assert_eq!(in_order(&beach), list);
            for &ghost in &list {
                let parent = beach.nodes[ghost.index()].parent;
                assert!(parent.is_none_or(|parent| hash(parent) < hash(ghost)));
            }
        }
    }
    assert!(list.len() > 50);
    for place in 0..=list.len() {
        let is_above = |ghost| list.iter().position(|&g| g == ghost).unwrap() < place;
        let expected = (place.checked_sub(1).map(|i| list[i]), list.get(place).copied());
        assert_eq!(beach.search(is_above), expected);
    }
}
