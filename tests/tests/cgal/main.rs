//! CGAL: the same triangulation as ours, cell for cell.
//!
//! CGAL breaks ties in its side-of-circle and side-of-sphere by the same perturbation, so everything is compared with
//! `==`: degenerate inputs, all sites in a plane or a line, coordinates from end to end of the doubles. Constrained
//! triangulations too: CGAL does not promise that the order of insertion leaves no trace in its ties, but its flips ask the
//! perturbed predicate, and no input has been found on which it differs. If one is, the message tells ties from cells.
//! CGAL is given sites and subsegments: it neither merges duplicates nor nodes as we do.
//!
//! | module | inputs |
//! |---|---|
//! | `workloads` | the corpus: workloads, inputs by hand, regressions; subsets of small grids |
//! | `regular` | the corpus with several kinds of weights |
//! | `files` | the collected files |
//! | `alpha` | alpha values, as exact fractions |

mod alpha;
mod files;
mod regular;
mod workloads;

use delone::delaunay::Delaunay;
use delone_tests::cgal::{Answer, Cgal};

/// Demands that CGAL finds the same cells; whether it answered.
fn equals_cgal<const D: usize>(
    name: &str,
    points: &[[f64; D]],
    ours: &Delaunay<D>,
    cgal: &mut Cgal,
) -> bool {
    match cgal.delaunay(points) {
        Answer::Refused(_) => false,
        Answer::Cells { dimension, cells } => {
            let ours_has = ours.mesh().dimension().map_or(-1, |k| i32::try_from(k).unwrap_or(-2));
            assert_eq!(dimension, ours_has, "{name}: dimension");
            if cells != ours.canonical() {
                dump(name, points, &ours.canonical(), &cells, ours.mesh().corner_count());
            }
            true
        }
    }
}

/// Fails with the cells that only one of the two has.
fn dump<const D: usize>(
    name: &str,
    points: &[[f64; D]],
    ours: &[u32],
    theirs: &[u32],
    corners: usize,
) -> ! {
    let only = |some: &[u32], other: &[u32]| -> Vec<Vec<[f64; D]>> {
        let other: Vec<&[u32]> = other.chunks(corners).collect();
        let extra = some.chunks(corners).filter(|cell| other.binary_search(cell).is_err());
        extra.take(3).map(|cell| cell.iter().map(|&v| points[v as usize]).collect()).collect()
    };
    panic!("{name}: only ours {:?}, only CGAL's {:?}", only(ours, theirs), only(theirs, ours));
}
