//! The lecture's soups of boundary edges, each under each rule: areas exactly, chains by the operators of the complex,
//! components and holes by its Betti numbers. Areas are sums and differences of squares and triangles, done by hand.
//!
//! Rings are counter-clockwise around what is meant to be inside, clockwise around holes.

use delone::Pslg;
use delone::cdt::{Cdt, Domain, Fill, Interior, Role, algorithms, cdt_of_arrangement};
use delone::lar::{Chain, Coefficients, Complex};
use delone::sites::{Arrangement, Noded};

struct Soup {
    name: &'static str,
    points: Vec<[f64; 2]>,
    segments: Vec<[usize; 2]>,
    /// By even-odd, nonzero, nesting and exterior; where there is no chain, the points where the input does not close.
    areas: [Result<&'static str, &'static [u32]>; 4],
    /// Components and holes of what nesting says is inside.
    betti: [usize; 2],
}

/// A ring of new points.
fn ring(soup: &mut Soup, points: &[[f64; 2]]) {
    let first = soup.points.len();
    soup.points.extend(points);
    let next = |i: usize| first + (i + 1) % points.len();
    soup.segments.extend((0..points.len()).map(|i| [first + i, next(i)]));
}

fn soup(
    name: &'static str,
    rings: &[&[[f64; 2]]],
    more: &[[usize; 2]],
    areas: [Result<&'static str, &'static [u32]>; 4],
    betti: [usize; 2],
) -> Soup {
    let mut soup = Soup { name, points: vec![], segments: vec![], areas, betti };
    rings.iter().for_each(|points| ring(&mut soup, points));
    soup.segments.extend(more);
    soup
}

fn square(low: f64, high: f64) -> Vec<[f64; 2]> {
    vec![[low, low], [high, low], [high, high], [low, high]]
}

/// Clockwise.
fn turned(mut ring: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    ring.reverse();
    ring
}

/// Counter-clockwise, right-angled at the lower left.
fn corner(x: f64, y: f64, side: f64) -> Vec<[f64; 2]> {
    vec![[x, y], [x + side, y], [x, y + side]]
}

/// A 6 x 5 rectangle less a quadrilateral of area 3/4 at each corner: 27.
fn dodecagon() -> Vec<[f64; 2]> {
    let corner = [[0.0, 2.0], [0.375, 0.375], [2.0, 0.0]];
    let place = |[x, y]: [f64; 2], right: bool, up: bool| {
        [2.0 + if right { 6.0 - x } else { x }, 2.0 + if up { 5.0 - y } else { y }]
    };
    let mut ring = Vec::new();
    for (right, up) in [(false, false), (true, false), (true, true), (false, true)] {
        let mut points = corner.map(|p| place(p, right, up));
        if right != up {
            points.reverse();
        }
        ring.extend(points);
    }
    ring
}

/// Cases A to F.
fn holes() -> Vec<Soup> {
    let outer = square(0.0, 10.0);
    let hole = turned(corner(2.0, 2.0, 3.0));
    let hexagon = [[10.0, 0.0], [5.0, 8.0], [-5.0, 8.0], [-10.0, 0.0], [-5.0, -8.0], [5.0, -8.0]];
    vec![
        soup(
            "A triangular hole",
            &[&outer, &hole],
            &[],
            [Ok("191/2"), Ok("191/2"), Ok("191/2"), Ok("100")],
            [1, 1],
        ),
        soup(
            "B square hole",
            &[&outer, &turned(square(3.0, 7.0))],
            &[],
            [Ok("84"), Ok("84"), Ok("84"), Ok("100")],
            [1, 1],
        ),
        soup(
            "C dodecagonal hole",
            &[&outer, &turned(dodecagon())],
            &[],
            [Ok("73"), Ok("73"), Ok("73"), Ok("100")],
            [1, 1],
        ),
        soup(
            "D island in a hole",
            &[&square(0.0, 20.0), &turned(corner(4.0, 4.0, 12.0)), &corner(6.0, 6.0, 3.0)],
            &[],
            [Ok("665/2"), Ok("665/2"), Ok("665/2"), Ok("400")],
            [2, 1],
        ),
        soup(
            "E three nested squares",
            &[&square(0.0, 20.0), &turned(square(3.0, 17.0)), &square(6.0, 14.0)],
            &[],
            [Ok("268"), Ok("268"), Ok("268"), Ok("400")],
            [2, 1],
        ),
        soup(
            "F hexagon and three chords",
            &[&hexagon],
            &[[0, 2], [2, 4], [4, 0]],
            [Ok("120"), Ok("240"), Ok("120"), Ok("240")],
            [1, 1],
        ),
    ]
}

/// Cases H to P.
fn oddities() -> Vec<Soup> {
    let outer = square(0.0, 10.0);
    let hole = turned(corner(2.0, 2.0, 3.0));
    let all = |area| [Ok(area); 4];
    let with_middle = |area: &'static str| [Ok(area), Ok(area), Ok(area), Ok("100")];
    let mut slit = soup("H slit", &[&outer], &[[4, 5]], all("100"), [1, 0]);
    slit.points.extend([[3.0, 4.0], [6.0, 5.0]]);
    let three = [[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [6.0, 3.0], [4.0, 6.0], [2.0, 3.0]];
    let triforce = [[1, 5], [5, 3], [3, 1]]; // clockwise
    let mut twice = soup(
        "J hole given twice",
        &[&outer, &hole],
        &[],
        [Ok("100"), Ok("100"), Ok("191/2"), Ok("100")],
        [1, 1],
    );
    twice.segments.extend_from_within(4..);
    let middle = [[2.0, 2.0], [2.0, 6.0], [6.0, 2.0], [4.0, 2.0]]; // clockwise, the last one in line
    let mut free = soup(
        "M free vertex on a hole's edge",
        &[&outer, &middle[..3]],
        &[],
        with_middle("92"),
        [1, 1],
    );
    free.points.push([4.0, 2.0]);
    let bow = [[0.0, 0.0], [10.0, 10.0], [10.0, 0.0], [0.0, 10.0]];
    vec![
        slit,
        soup("I triforce", &[&three], &triforce, [Ok("18"), Ok("18"), Ok("18"), Ok("24")], [1, 1]),
        twice,
        soup("K hole on a bridge", &[&outer, &hole], &[[0, 6]], with_middle("191/2"), [1, 1]),
        soup(
            "L vertex in line on a hole's edge",
            &[&outer, &middle],
            &[],
            with_middle("92"),
            [1, 1],
        ),
        free,
        soup(
            "N diagonal",
            &[&outer],
            &[[0, 2]],
            [Err(&[0, 2]), Err(&[0, 2]), Ok("100"), Ok("100")],
            [1, 0],
        ),
        soup("O bow-tie", &[&bow], &[], all("50"), [1, 0]),
        soup(
            "P overlapping squares",
            &[&square(0.0, 6.0), &square(3.0, 9.0)],
            &[],
            [Ok("54"), Ok("63"), Ok("54"), Ok("63")],
            [1, 1],
        ),
    ]
}

fn soups() -> Vec<Soup> {
    let soups: Vec<Soup> = holes().into_iter().chain(oddities()).collect();
    assert_eq!(soups.len(), 15);
    soups
}

const RULES: [Fill; 4] = [Fill::EvenOdd, Fill::NonZero, Fill::Nesting, Fill::Exterior];

fn check(soup: &Soup, cdt: &Cdt, graph: &impl Noded) {
    for (rule, expected) in RULES.iter().zip(soup.areas) {
        let which = format!("{}, {rule:?}", soup.name);
        match (Domain::new(cdt, graph, rule), expected) {
            (Ok(domain), Ok(area)) => {
                assert_eq!(domain.area().to_string(), area, "{which}");
                check_chain(&which, cdt, graph, &domain, rule);
                check_numbers(&which, soup, cdt, graph, domain, rule);
            }
            (Err(error), Err(points)) => {
                use delone::cdt::FillError::{OddVertices, Unbalanced};
                let (OddVertices(open) | Unbalanced(open)) = &error else { panic!("{error}") };
                let found: Vec<u32> = open.iter().map(|vertex| vertex.point).collect();
                assert_eq!(found, points, "{which}");
            }
            (found, _) => panic!("{which}: {found:?} is not {expected:?}"),
        }
    }
}

/// The boundary of the chain of regions, by the operator of the whole complex, is the input: over the integers for nonzero,
/// modulo 2 for even-odd.
fn check_chain(which: &str, cdt: &Cdt, graph: &impl Noded, domain: &Domain, rule: &Fill) {
    let Some(coefficients) = domain.chain() else { return };
    let complex = Complex::of_mesh(graph.positions(), cdt.mesh(), |_| true);
    let signs = complex.orientations(2);
    let terms = cdt.cells().map(|cell| {
        let corners: Vec<u32> =
            cdt.mesh().corners(cell).iter().map(|v| delone_tests::id(v.index())).collect();
        let number = complex.find(&corners).expect("a cell of the mesh");
        let coefficient = coefficients[domain.regions().of_cell(cell) as usize];
        (number, coefficient * signs[number])
    });
    let found = Chain::new(2, terms).boundary(&complex);
    let coverage = graph.coverage();
    let separating =
        graph.subsegments().iter().enumerate().filter(|&(s, _)| domain.regions().separates(s));
    let expected = Chain::new(
        1,
        separating.map(|(s, ends)| {
            let number = complex.find(ends).expect("a subsegment is an edge");
            (
                number,
                if *rule == Fill::NonZero { coverage[s].net } else { i64::from(coverage[s].times) },
            )
        }),
    );
    if *rule == Fill::NonZero {
        assert_eq!(found, expected, "{which}");
    } else {
        assert_eq!(found.mod_2(), expected.mod_2(), "{which}");
    }
}

/// Components and holes, for nesting; the lists fit each other, for all.
fn check_numbers(
    which: &str,
    soup: &Soup,
    cdt: &Cdt,
    graph: &impl Noded,
    domain: Domain,
    rule: &Fill,
) {
    let interior = Interior::of(cdt, graph, domain);
    let mut points = soup.points.clone();
    points.extend(&graph.positions()[graph.sites().len()..]);
    let cells: Vec<&[u32]> = interior.fv.iter().map(<[u32; 3]>::as_slice).collect();
    let complex = Complex::closure(points, &cells).expect("triangles over the vertices");
    assert_eq!(complex.cells(2).len(), interior.fv.len(), "{which}");
    assert!(
        complex.cells(1).iter().map(Vec::as_slice).eq(interior.ev.iter().map(<[u32; 2]>::as_slice)),
        "{which}"
    );
    if *rule == Fill::Nesting {
        let used = interior.fv.as_flattened();
        let unused =
            (0..complex.vertices().len()).filter(|&v| !used.contains(&delone_tests::id(v))).count();
        for field in [Coefficients::Two, Coefficients::Rational] {
            let betti = complex.betti(field);
            assert_eq!(
                [betti[0] - unused, betti[1], betti[2]],
                [soup.betti[0], soup.betti[1], 0],
                "{which}"
            );
        }
    }
}

#[test]
fn every_soup_has_the_right_area_under_every_rule() {
    for soup in soups() {
        let graph = Arrangement::new(&soup.points, &soup.segments).expect("finite");
        let first = cdt_of_arrangement(&graph, &mut ());
        check(&soup, &first, &graph);
        for algorithm in algorithms() {
            let cdt = (algorithm.run_crossed)(&graph, &mut ());
            assert_eq!(cdt.canonical(), first.canonical(), "{}: {}", soup.name, algorithm.name);
            check(&soup, &cdt, &graph);
        }
        match Pslg::new(&soup.points, &soup.segments) {
            Ok(pslg) => {
                let cdt = delone::cdt::chew(&pslg, &Default::default(), &mut ());
                assert_eq!(cdt.canonical(), first.canonical(), "{}", soup.name);
                check(&soup, &cdt, &pslg);
            }
            Err(error) => {
                assert!("OP".contains(&soup.name[..1]), "{}: {error}", soup.name);
            }
        }
    }
}

/// A chord that is a material interface bounds nothing: tags say so.
#[test]
fn tagged_chords_are_interfaces() {
    let soups = holes();
    let hexagon = &soups[5];
    let graph = Arrangement::new(&hexagon.points, &hexagon.segments).expect("finite");
    let cdt = cdt_of_arrangement(&graph, &mut ());
    let roles = [[Role::Boundary; 6].as_slice(), &[Role::Interface; 3]].concat();
    let domain = Domain::new(&cdt, &graph, &Fill::Tagged(roles)).expect("the hexagon closes");
    assert_eq!((domain.area().to_string(), domain.regions().count()), ("240".to_owned(), 5));
}

/// Nothing changes when edges are turned, listed in another order, or cut in two; nor, for nesting, when slits are added.
#[test]
fn rules_do_not_see_how_the_soup_is_written() {
    for soup in soups() {
        let area = |points: &[[f64; 2]], segments: &[[usize; 2]], rule: &Fill| {
            let graph = Arrangement::new(points, segments).expect("finite");
            let cdt = cdt_of_arrangement(&graph, &mut ());
            Domain::new(&cdt, &graph, rule).map(|domain| domain.area().to_string()).ok()
        };
        let mut points = soup.points.clone();
        let mut halves = Vec::new();
        for &[a, b] in soup.segments.iter().rev() {
            let middle = [0, 1].map(|x| f64::midpoint(soup.points[a][x], soup.points[b][x])); // exact here
            halves.extend([[points.len(), b], [a, points.len()]]);
            points.push(middle);
        }
        let backwards: Vec<[usize; 2]> = soup.segments.iter().rev().map(|&[a, b]| [b, a]).collect();
        for rule in &RULES {
            let first = area(&soup.points, &soup.segments, rule);
            assert_eq!(area(&points, &halves, rule), first, "{}, cut, {rule:?}", soup.name);
            assert_eq!(
                area(&soup.points, &backwards, rule),
                first,
                "{}, turned, {rule:?}",
                soup.name
            );
        }
        let mut slit = soup.segments.clone();
        slit.push([points.len(), points.len() + 1]);
        points.extend([[0.5, 1.0], [0.75, 1.25]]);
        let nesting = area(&soup.points, &soup.segments, &Fill::Nesting);
        assert_eq!(area(&points, &slit, &Fill::Nesting), nesting, "{}, with a slit", soup.name);
    }
}
