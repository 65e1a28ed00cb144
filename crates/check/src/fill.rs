//! The judge of fills: which cells of a triangulation are inside, by a rule.
//!
//! **Definition.** A ray from inside a cell to infinity crosses segments. Even-odd: an odd number of them; nonzero: those from
//! its right to its left less those the other way are not zero; positive: are more. Segments that have one region on both
//! sides (slits) do not count. Nesting: the fewest segments on any way from infinity, each counted once, are odd. Exterior: any
//! segment is in the way. Seeds: any segment is in the way, from infinity and from each of these points.
//!
//! **Method.** F1: the flags of cells agree across edges on no segment, and free edges of the hull have outside behind them. F2:
//! one cell of each piece agrees with its ray, which runs from the cell's centroid, exactly: the centroid times three is an
//! integer. For nesting and exterior, instead of a ray, breadth first over the pieces.
//! **Cost.** For r pieces and m edges on segments O(r m), and sorting.

use crate::cells::{Complex, Triangulation};
use crate::chains::{Cover, Edges, cover};
use crate::exact::lattice::Span;
use crate::exact::{Integer, Lattice, Number, Pure, Sign};
use crate::facets::{Facets, Pieces};
use crate::fault::Fault;
use crate::options::Options;
use crate::sites::witnesses;
use crate::triangulation::{check_triangulation, facets_of};
use crate::verdict::{Level, Report, Verdict};
use std::collections::VecDeque;

/// What is inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FillRule<'s> {
    /// An odd number of segments on the way to infinity.
    EvenOdd,
    /// A winding number that is not zero.
    NonZero,
    /// A positive winding number.
    Positive,
    /// An odd number of segments on the shortest way from infinity.
    Nesting,
    /// Not reached from infinity without crossing a segment.
    Exterior,
    /// Not reached from infinity, nor from any of these points, without crossing a segment. None of them is on one.
    Seeds(&'s [[f64; 2]]),
}

/// Judges whether exactly the cells are inside that the rule says; `inside` has an entry for each cell. That the input has an
/// answer under the rule (that it closes) is not looked at, only whether this is it.
///
/// ```
/// use delone_check::{Complex, FillRule, Options, judge_fill};
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
/// let complex = Complex { points: &points, dimension: Some(2), cells: &[0, 1, 2, 0, 2, 3] };
/// let half = [[0, 1], [1, 2], [2, 0]];
/// assert!(judge_fill(&complex, &half, &[true, false], FillRule::EvenOdd, &Options::default()).ok);
/// let verdict = judge_fill(&complex, &half, &[true, true], FillRule::EvenOdd, &Options::default());
/// assert!(verdict.has("fill-leaks"));
/// ```
#[must_use]
pub fn judge_fill(
    complex: &Complex<'_, 2>,
    segments: &[[u32; 2]],
    inside: &[bool],
    rule: FillRule<'_>,
    options: &Options,
) -> Verdict {
    let mut report = Report::new(options.faults_max);
    let Some(t) = Triangulation::<2, Pure>::read(complex, options, &mut report) else {
        return report.verdict();
    };
    if t.signs.len() != inside.len() {
        let expected = format!("one entry for each of {} cells", t.signs.len());
        report.fault(Fault::BadLength { array: "inside", length: inside.len(), expected });
        return report.verdict();
    }
    let facets = facets_of(&t);
    check_triangulation(&t, &facets, &mut report);
    if t.dimension != 2 || !report.is_clean() {
        return report.verdict();
    }
    let mut edges = Edges::of(&t, &facets);
    let mut covered = Vec::new();
    report.check("K2, K4: every segment is an exactly collinear chain of edges", |report| {
        covered = cover(&t, &mut edges, segments, report, |_, _, _| None);
    });
    let walls = Walls::new(&t, &facets, &covered);
    report.check("F1: the fill changes across segments only", |report| {
        for (group, _) in facets.groups().zip(&covered).filter(|(_, c)| c.first.is_none()) {
            let sides = [0, 1].map(|i| group.get(i).is_some_and(|f| inside[facets.cell_number(f)]));
            if sides[0] != sides[1] {
                let edge = witnesses(t.space.points, &facets.vertices(&group[0]));
                report.fault(Fault::FillLeaks { edge });
            }
        }
    });
    report.check("F2: each region is on the side that the rule says", |report| {
        for (cell, expected) in walls.expected(&t, rule) {
            if inside[cell] != expected {
                let corners = witnesses(t.space.points, t.cell(cell));
                report.fault(Fault::WrongSide { cell: corners, inside: inside[cell] });
            }
        }
    });
    if report.is_clean() {
        report.reached(Level::Triangulation);
    }
    report.verdict()
}

/// An edge on segments with different pieces on its sides.
struct Wall {
    /// Smaller vertex first.
    ends: [u32; 2],
    cover: Cover,
    pieces: [usize; 2],
}

/// The pieces that segments cut the cells into, and what is between them. A piece is named by one of its cells; the outside by
/// the number of cells.
struct Walls {
    walls: Vec<Wall>,
    pieces: Vec<usize>,
    outside: usize,
}

impl Walls {
    fn new(t: &Triangulation<'_, 2, Pure>, facets: &Facets<'_>, covered: &[Cover]) -> Self {
        let outside = t.signs.len();
        let sides = |group: &[crate::facets::Facet]| {
            [0, 1].map(|i| group.get(i).map_or(outside, |f| facets.cell_number(f)))
        };
        let mut joined = Pieces::new(outside + 1);
        for (group, _) in facets.groups().zip(covered).filter(|(_, c)| c.first.is_none()) {
            let [a, b] = sides(group);
            joined.join(a, b);
        }
        let pieces: Vec<usize> = (0..=outside).map(|cell| joined.root(cell)).collect();
        let wall = |(group, &cover): (&[crate::facets::Facet], &Cover)| {
            let pieces = sides(group).map(|cell| pieces[cell]);
            let ends = <[u32; 2]>::try_from(facets.vertices(&group[0])).ok()?;
            (cover.first.is_some() && pieces[0] != pieces[1]).then_some(Wall {
                ends,
                cover,
                pieces,
            })
        };
        let walls = facets.groups().zip(covered).filter_map(wall).collect();
        let outside = pieces[outside];
        Self { walls, pieces, outside }
    }

    /// For one cell of each piece, whether it is inside.
    fn expected(&self, t: &Triangulation<'_, 2, Pure>, rule: FillRule<'_>) -> Vec<(usize, bool)> {
        let mut names: Vec<usize> = self.pieces.clone();
        names.sort_unstable();
        names.dedup();
        let cells = names.into_iter().filter(|&name| name < t.signs.len());
        let depths = self.depths();
        let drained: Vec<usize> = match rule {
            FillRule::Seeds(seeds) => {
                let holding = seeds.iter().filter_map(|&seed| holding(t, seed));
                holding.map(|cell| self.pieces[cell]).collect()
            }
            _ => Vec::new(),
        };
        let side = |cell: usize| match rule {
            FillRule::EvenOdd => self.ray(t, cell).0 % 2 != 0,
            FillRule::NonZero => self.ray(t, cell).1 != 0,
            FillRule::Positive => self.ray(t, cell).1 > 0,
            FillRule::Nesting => depths[cell] % 2 == 1,
            FillRule::Exterior => self.pieces[cell] != self.outside,
            FillRule::Seeds(_) => {
                let piece = self.pieces[cell];
                piece != self.outside && !drained.contains(&piece)
            }
        };
        cells.map(|cell| (cell, side(cell))).collect()
    }

    /// How many segments the ray to the right from a cell's centroid crosses, and those from its right to its left less those
    /// the other way.
    fn ray(&self, t: &Triangulation<'_, 2, Pure>, cell: usize) -> (i64, i64) {
        let points = t.space.points;
        let span = Span::of(points.iter().flatten().copied());
        let lattice: Lattice<Pure> = Lattice::new(span.map_or(0, |span| span.low));
        let at = |v: u32| points[v as usize].map(|x| lattice.integer(x));
        let corners = t.cell(cell);
        let centre = [0, 1].map(|x| {
            let sum = at(corners[0])[x].plus(&at(corners[1])[x]);
            sum.plus(&at(corners[2])[x])
        });
        let from_centre = |v: u32| at(v).map(|x| x.scaled(3));
        let (mut times, mut winding) = (0, 0);
        for Wall { ends, cover, .. } in &self.walls {
            let [p, q] = ends.map(from_centre);
            let below = [&p, &q].map(|v| v[1].minus(&centre[1]).exact_sign() != Sign::Positive);
            if below[0] == below[1] {
                continue;
            }
            let d = |v: &[Pure; 2]| [v[0].minus(&centre[0]), v[1].minus(&centre[1])];
            let (p, q) = (d(&p), d(&q));
            let turn = p[0].times(&q[1]).minus(&p[1].times(&q[0])).exact_sign();
            // Upwards with the centre on its left, or downwards with it on its right: to the right of it.
            let is_ahead = turn == if below[0] { Sign::Positive } else { Sign::Negative };
            if is_ahead {
                times += cover.times;
                winding += if below[0] { cover.net } else { -cover.net };
            }
        }
        (times, winding)
    }

    /// The fewest walls on any way from outside, by piece.
    fn depths(&self) -> Vec<u32> {
        let mut depths = vec![u32::MAX; self.pieces.len()];
        let mut beyond = vec![Vec::new(); self.pieces.len()];
        for Wall { pieces: [a, b], .. } in &self.walls {
            beyond[*a].push(*b);
            beyond[*b].push(*a);
        }
        depths[self.outside] = 0;
        let mut queue = VecDeque::from([self.outside]);
        while let Some(piece) = queue.pop_front() {
            for &next in &beyond[piece] {
                if depths[next] == u32::MAX {
                    depths[next] = depths[piece] + 1;
                    queue.push_back(next);
                }
            }
        }
        depths
    }
}

/// A cell that holds a finite point, its boundary included, if one does.
fn holding(t: &Triangulation<'_, 2, Pure>, seed: [f64; 2]) -> Option<usize> {
    let points = t.space.points;
    let span = Span::of(points.iter().chain([&seed]).flatten().copied());
    let lattice: Lattice<Pure> = Lattice::new(span.map_or(0, |span| span.low));
    let from_seed = |v: u32| {
        let v = points[v as usize];
        [0, 1].map(|x| lattice.integer(v[x]).minus(&lattice.integer(seed[x])))
    };
    (0..t.signs.len()).find(|&cell| {
        let corners = [0, 1, 2].map(|i| from_seed(t.cell(cell)[i]));
        let turns = [0, 1, 2].map(|i| {
            let [p, q] = [&corners[i], &corners[(i + 1) % 3]];
            p[0].times(&q[1]).minus(&p[1].times(&q[0])).exact_sign()
        });
        !(turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative))
    })
}

#[cfg(test)]
mod tests;
