//! Chains are chosen first, their boundaries are the input: the fill must find them again.

use delone_mesh::VertexId;
use delone_sites::scatter;

use super::*;

struct Dice(u64);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        self.0 = scatter(self.0);
        usize::try_from(self.0 % count as u64).unwrap()
    }
}

/// A number for each triangle of the Delaunay triangulation of some points, and its boundary with multiplicities.
struct Chain {
    points: Vec<[f64; 2]>,
    numbers: Vec<([u32; 3], i64)>,
    segments: Vec<[usize; 2]>,
}

fn sorted(corners: &[VertexId]) -> [u32; 3] {
    let mut ids = [0, 1, 2].map(|i| u32::try_from(corners[i].index()).unwrap());
    ids.sort_unstable();
    ids
}

fn chain(dice: &mut Dice, range: i64) -> Chain {
    let side = 3 + dice.below(6);
    let count = 3 + dice.below(20);
    let grid: Vec<[u32; 2]> =
        (0..count).map(|_| [(); 2].map(|()| u32::try_from(dice.below(side)).unwrap())).collect();
    let mut points: Vec<[f64; 2]> = grid.iter().map(|p| p.map(f64::from)).collect();
    points.sort_by(|p, q| p.partial_cmp(q).unwrap());
    points.dedup(); // so that sites are points
    let pslg = Pslg::new(&points, &[]).unwrap();
    let cdt = cavity(&pslg, &Options::default(), &mut ());
    let mesh = cdt.mesh();
    let mut chain = Chain { points, numbers: Vec::new(), segments: Vec::new() };
    let mut number_of = vec![0; mesh.cell_count()];
    if mesh.dimension() != Some(2) {
        return chain;
    }
    for cell in mesh.solid_cells() {
        let number = i64::try_from(dice.below(3)).unwrap() * [-1, 1][dice.below(2)] % range;
        number_of[cell.index()] = number;
        chain.numbers.push((sorted(mesh.corners(cell)), number));
    }
    for h in mesh.cells().flat_map(|cell| mesh.facets(cell)) {
        let [a, b] = [mesh.origin(h), mesh.destination(h)];
        if a.is_ghost() || b.is_ghost() {
            continue;
        }
        let jump = number_of[h.cell().index()] - number_of[mesh.twin(h).cell().index()];
        for _ in 0..jump.max(0) {
            chain.segments.push([a.index(), b.index()]);
        }
        // Now and then an edge to and fro, which changes nothing.
        if dice.below(8) == 0 {
            chain.segments.extend([[a.index(), b.index()], [b.index(), a.index()]]);
        }
    }
    chain
}

#[test]
fn the_winding_numbers_are_found_again() {
    let mut dice = Dice(1);
    let mut wound = 0;
    for _ in 0..400 {
        let chain = chain(&mut dice, 3);
        let (cdt, pslg) = graph(&chain.points, &chain.segments);
        for rule in [Fill::NonZero, Fill::Positive, Fill::EvenOdd] {
            let domain = Domain::new(&cdt, &pslg, &rule).unwrap();
            let found = domain.chain().unwrap();
            let mut cells = 0;
            for cell in cdt.cells().filter(|_| cdt.mesh().dimension() == Some(2)) {
                let corners = sorted(cdt.mesh().corners(cell));
                let (_, number) = chain.numbers.iter().find(|(c, _)| *c == corners).unwrap();
                let region = domain.regions().of_cell(cell);
                let (expected, inside) = match rule {
                    Fill::NonZero => (*number, *number != 0),
                    Fill::Positive => (*number, *number > 0),
                    _ => (number.rem_euclid(2), number % 2 != 0),
                };
                assert_eq!(found[region as usize], expected, "{rule:?} {:?}", chain.points);
                assert_eq!(domain.is_inside(region), inside);
                wound += usize::from(expected != 0);
                cells += usize::from(inside);
            }
            assert_eq!(domain.cells(&cdt).count(), cells);
        }
    }
    assert!(wound > 1000, "{wound}");
}

#[expect(clippy::cast_possible_truncation, reason = "a small whole number")]
fn whole(x: f64) -> i64 {
    x as i64
}

/// The sum of winding number times area is the shoelace formula over the input segments.
#[test]
fn areas_fit_the_shoelace_formula() {
    let mut dice = Dice(2);
    let mut sum_of_sizes = 0;
    for _ in 0..300 {
        let chain = chain(&mut dice, 3);
        let at = |v: usize| chain.points[v].map(whole);
        let twice: i64 =
            chain.segments.iter().map(|&[a, b]| at(a)[0] * at(b)[1] - at(a)[1] * at(b)[0]).sum();
        let domain = fill(&chain.points, &chain.segments, &Fill::NonZero);
        let mut sum = Area::default();
        for (region, &number) in (0u32..).zip(domain.chain().unwrap()) {
            let area = domain.region_area(region);
            for _ in 0..number.abs() {
                sum += &if number > 0 { area.clone() } else { area.negative() };
            }
        }
        assert_eq!(sum, Area::dyadic(twice.into(), -1), "{:?} {:?}", chain.points, chain.segments);
        sum_of_sizes += twice.abs();
    }
    assert!(sum_of_sizes > 1000);
}

/// Each region's own point is where no other region is: seeds at the points of all holes leave what was inside.
#[test]
fn seeds_at_the_points_of_holes_give_the_same_fill() {
    let mut dice = Dice(3);
    let mut holes = 0;
    for _ in 0..300 {
        let chain = chain(&mut dice, 2);
        let (cdt, pslg) = graph(&chain.points, &chain.segments);
        for rule in [Fill::EvenOdd, Fill::Nesting] {
            let domain = Domain::new(&cdt, &pslg, &rule).unwrap();
            let seeds: Vec<[f64; 2]> =
                domain.holes().map(|hole| domain.interior_point(hole).unwrap()).collect();
            holes += seeds.len();
            let seeded = Domain::new(&cdt, &pslg, &Fill::Seeds(seeds)).unwrap();
            let inside = |domain: &Domain| domain.cells(&cdt).collect::<Vec<_>>();
            assert_eq!(inside(&seeded), inside(&domain));
            assert_eq!(seeded.area(), domain.area());
        }
    }
    assert!(holes > 100, "{holes}");
}
