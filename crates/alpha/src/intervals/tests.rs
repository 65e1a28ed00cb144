use delone_workloads::Rng;

use super::*;
use crate::testing::of;

/// From the complex alone: what is in, which cofaces of a simplex are in, whether its cells surround it.
fn by_definition<const D: usize>(filtration: &AlphaFiltration<D>, cut: Cut, id: usize) -> Status {
    let simplices = filtration.simplices();
    let top = simplices.dimension().unwrap();
    let own = simplices.vertices(SimplexId::new(id));
    let holds = |other: usize| {
        let vertices = simplices.vertices(SimplexId::new(other));
        own.iter().all(|v| vertices.contains(v))
    };
    let is_in = |other: &usize| cut.holds(filtration.ranks()[*other]);
    if !is_in(&id) {
        return Status::Exterior;
    }
    let is_cell = own.len() == top + 1;
    let cofaces: Vec<usize> = (0..simplices.len()).filter(|&o| o != id && holds(o)).collect();
    if !is_cell && !cofaces.iter().any(is_in) {
        return Status::Singular;
    }
    let mut cells = simplices.of_dimension(top).filter(|&o| holds(o));
    let facets = simplices.of_dimension(top.saturating_sub(1));
    let on_hull = !is_cell
        && facets.filter(|&f| holds(f)).any(|f| {
            let of_facet = simplices
                .of_dimension(top)
                .filter(|&cell| simplices.facets(SimplexId::new(cell)).contains(&narrow(f)));
            of_facet.count() == 1
        });
    if !on_hull && cells.all(|cell| is_in(&cell)) { Status::Interior } else { Status::Regular }
}

fn check<const D: usize>(points: &[[f64; D]]) -> [usize; 4] {
    let filtration = of(points);
    let mut seen = [0; 4];
    for ranks in 0..=narrow(filtration.rank_count()) {
        let cut = Cut::new(ranks);
        let statuses = filtration.classify(cut, VertexConvention::Em94);
        for (id, &status) in statuses.iter().enumerate() {
            assert_eq!(
                status,
                by_definition(&filtration, cut, id),
                "{id} at {ranks} of {points:?}"
            );
            seen[status as usize] += 1;
        }
        let general = filtration.shape(cut, Mode::General);
        let regularized = filtration.shape(cut, Mode::Regularized);
        assert!(regularized.iter().all(|simplex| general.contains(simplex)));
        let singular = statuses.iter().filter(|&&status| status == Status::Singular).count();
        assert_eq!(general.len() - regularized.len(), singular);
    }
    seen
}

#[test]
fn statuses_are_those_of_the_definition() {
    let mut rng = Rng::new(5);
    let mut seen = [0; 4];
    for _ in 0..6 {
        let plane: Vec<[f64; 2]> = (0..12).map(|_| [0; 2].map(|_| rng.below(7) as f64)).collect();
        let space: Vec<[f64; 3]> = (0..9).map(|_| [0; 3].map(|_| rng.below(5) as f64)).collect();
        for counts in [check(&plane), check(&space)] {
            seen.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
        }
    }
    assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
}

#[test]
fn few_sites_have_statuses() {
    check(&[[1.0, 1.0]]);
    check(&[[1.0, 1.0], [2.0, 3.0]]);
    check(&[[1.0, 1.0], [2.0, 2.0], [5.0, 5.0]]);
    assert_eq!(of::<2>(&[]).classify(Cut::new(0), VertexConvention::Em94), []);
}

#[test]
fn vertices_have_two_conventions() {
    let filtration = of(&[[0.0, 0.0], [2.0, 0.0], [1.0, 8.0]]);
    let cut = filtration.cut(crate::AlphaParam::Squared(1.0)).unwrap(); // the short edge is in
    let em94 = filtration.classify(cut, VertexConvention::Em94);
    let cgal = filtration.classify(cut, VertexConvention::Cgal2);
    assert_eq!(em94[..3], [Status::Regular, Status::Regular, Status::Singular]);
    assert_eq!(cgal[..3], [Status::Singular; 3]);
    assert_eq!(em94[3..], cgal[3..]);
    let nothing = filtration.classify(Cut::new(0), VertexConvention::Cgal2);
    assert_eq!(nothing[..3], [Status::Singular; 3]);
}
