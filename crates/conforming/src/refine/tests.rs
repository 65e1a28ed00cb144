use delone_check::Promise;
use delone_workloads::Rng;

use super::*;
use crate::SteinerPoint;
use crate::testing::{judged, judged_with_angles, pslg};

const METHODS: [(Centre, Encroachment); 4] = [
    (Centre::Circumcentre, Encroachment::Disk),
    (Centre::Circumcentre, Encroachment::Lens),
    (Centre::OffCentre, Encroachment::Disk),
    (Centre::OffCentre, Encroachment::Lens),
];

/// Refines by every method; the mesh judged, and whether the angles are those asked for where nothing is left alone.
fn refined(graph: &Pslg, angle_deg_min: f64, area_max: f64) -> Vec<Refined> {
    METHODS
        .into_iter()
        .map(|(centre, encroachment)| {
            let limits = Limits { vertices_max: 30_000 };
            let options =
                RefineOptions { centre, encroachment, angle_deg_min, area_max, size: None, limits };
            let refined = refine(graph, &Fill::Exterior, &options, &mut ()).unwrap();
            assert!(refined.is_complete(), "{centre:?} {encroachment:?}");
            let verdict = judged_with_angles(graph, &refined, options.cosine_square());
            assert!(verdict.ok, "{centre:?} {encroachment:?}: {verdict}");
            assert!(refined.angle_deg_min_elsewhere() >= angle_deg_min - 1e-9);
            refined
        })
        .collect()
}

fn polygon(corners: &[[f64; 2]]) -> Pslg {
    let segments: Vec<[usize; 2]> =
        (0..corners.len()).map(|i| [i, (i + 1) % corners.len()]).collect();
    pslg(corners, &segments)
}

#[test]
fn a_square_is_refined() {
    let square = polygon(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]);
    for refined in refined(&square, 20.7, 1.0) {
        assert_eq!(refined.left_alone(), []);
        assert!(refined.cells().count() >= 64, "an area of 64 in parts of one at most");
    }
}

#[test]
fn slivers_get_the_angle_asked_for() {
    for (corners, angle) in [
        (vec![[0.0, 0.0], [10.0, 0.0], [10.0, 4.0], [0.0, 1.0]], 30.0),
        (vec![[0.0, 0.0], [1000.0, 0.0], [1000.0, 1.0], [0.0, 1.0]], 20.7),
        (vec![[0.0, 0.0], [100.0, 0.0], [50.0, 1.0]], 20.7),
        (vec![[0.0, 0.0], [1.0, 0.0], [1e3, 1e3], [0.0, 1.0]], 25.0),
    ] {
        refined(&polygon(&corners), angle, f64::INFINITY);
    }
}

#[test]
fn nothing_inside_is_nothing_to_do() {
    let graph = pslg(&[[0.0, 0.0], [1.0, 5.0], [2.0, 0.0], [9.0, 9.0]], &[[0, 1], [1, 2]]);
    for refined in refined(&graph, 30.0, 0.1) {
        assert_eq!((refined.cells().count(), refined.triangulation().kernel().len()), (0, 4));
    }
}

/// A square of four units in the last place: no triangle whose corners are doubles is as small as is asked for.
#[test]
fn triangles_are_smaller_than_doubles_can_tell() {
    let (ulp, high) = (f64::EPSILON, 1.0 + 4.0 * f64::EPSILON);
    let graph = polygon(&[[1.0, 1.0], [high, 1.0], [high, high], [1.0, high]]);
    for refined in refined(&graph, 20.7, ulp * ulp / 8.0) {
        assert_eq!(refined.left_alone(), []);
        assert!(refined.cells().count() >= 128, "an area of 16 in parts of an eighth at most");
    }
    let size = |_: [f64; 2]| ulp / 8.0;
    let options = RefineOptions { size: Some(&size), ..RefineOptions::default() };
    let refined = refine(&graph, &Fill::Exterior, &options, &mut ()).unwrap();
    assert_eq!((refined.is_complete(), refined.left_alone()), (true, &[][..]));
    assert!(refined.cells().count() >= 2 * 32 * 32, "edges of an eighth, in a square of 32");
    let steiner = refined.triangulation().steiner_points();
    assert!(steiner.iter().any(|point| matches!(point, SteinerPoint::FreeExactly { .. })));
}

/// Of two triangles with a small angle of the input, the one with sides of one length is an exception though its turn does not come.
#[test]
fn exceptions_are_told_at_the_limit_too() {
    let (sine, cosine) = 10f64.to_radians().sin_cos();
    for (length, is_exception) in [(8.0, true), (5.0, false)] {
        let graph = polygon(&[[0.0, 0.0], [8.0, 0.0], [length * cosine, length * sine]]);
        let limits = Limits { vertices_max: 0 };
        let options = RefineOptions { limits, ..RefineOptions::default() };
        let refined = refine(&graph, &Fill::Exterior, &options, &mut ()).unwrap();
        let [exceptions, others] =
            [Reason::InputAngle, Reason::Limit].map(|reason| refined.left_alone_for(reason));
        assert_eq!([exceptions == 1, others == 1], [is_exception, !is_exception]);
        assert!(!refined.is_complete(), "pieces were not looked at");
    }
}

/// A flat triangle, its hull bare: the centre is beyond the long edge, which is split only if it is a segment.
#[test]
fn centres_beyond_a_bare_hull_are_told() {
    let corners = [[0.0, 0.0], [10.0, 0.0], [5.0, 1.0]];
    let bare = refine(&pslg(&corners, &[]), &Fill::Hull, &RefineOptions::default(), &mut ());
    let bare = bare.unwrap();
    assert!(bare.is_complete() && bare.left_alone_for(Reason::Unreachable) == 1);
    let (counts, exceptions) = bare.promised();
    assert!(exceptions.is_empty() && counts == [false], "no promise of what is out of reach");
    let refined = refine(&polygon(&corners), &Fill::Hull, &RefineOptions::default(), &mut ());
    assert_eq!(refined.unwrap().left_alone_for(Reason::Unreachable), 0);
}

/// Between two chains that share their ends there are 1e-28, so that points on both have the same nearest doubles: what is in a lens and what is
/// not, only exact numbers tell.
#[test]
fn a_gap_far_below_the_doubles_ends() {
    let points = [[-1.0, 2.0], [0.0, 0.0], [2.0, -1.0], [0.0, 1e-28]];
    let graph = pslg(&points, &[[0, 1], [1, 2], [2, 3], [3, 0]]);
    refined(&graph, 30.0, f64::INFINITY);
}

/// Vertices come and go; the mesh stays the CDT, and pieces know their edges.
#[test]
fn free_vertices_come_and_go() {
    let mut random = Rng::new(3);
    let frame = [[0.0, 0.0], [16.0, 0.0], [16.0, 16.0], [0.0, 16.0], [3.0, 5.0], [11.0, 9.0]];
    let graph = pslg(&frame, &[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]]);
    for _ in 0..30 {
        let cdt = cavity(&graph, &Options::default(), &mut ());
        let mut live = Live::new(&cdt, &graph);
        for cell in cdt.cells() {
            live.region_at[cell.index()] = 1;
        }
        let mut present: Vec<VertexId> = Vec::new();
        let (mut region, mut removed) = (Region::default(), Vec::new());
        for _ in 0..60 {
            if !present.is_empty() && random.below(3) == 0 {
                let place = usize::try_from(random.below(present.len() as u64)).unwrap();
                let v = present.swap_remove(place);
                let cells = cells_of(&live);
                let cell = cells.into_iter().find(|&c| live.mesh.corners(c).contains(&v)).unwrap();
                live.remove_free(v, cell, &mut ());
                removed.push(v);
                continue;
            }
            let [x, y] = [0; 2].map(|_| f64::from(u32::try_from(random.below(15)).unwrap()) + 1.0);
            let p = live.kernel.push_plain([x, y]);
            let p = VertexId::new(p as usize);
            let start = cells_of(&live).into_iter().find(|&c| !live.mesh.is_ghost(c)).unwrap();
            match live.locate(start, p, &mut ()) {
                Some(place @ (Place::Inside(_) | Place::On(_))) => {
                    live.search(place, p, &mut region, &mut ());
                    let cell = live.insert_free(place, p, &mut region, &mut ());
                    assert!(live.mesh.corners(cell).contains(&p));
                    present.push(p);
                }
                _ => assert!(live.kernel.pop()),
            }
        }
        // As refinement ends: by what is left.
        let options = RefineOptions { angle_deg_min: 0.0, ..RefineOptions::default() };
        let work = Work {
            apexes: Apexes::new(&cdt, &live),
            live,
            quality: Quality::new(&options, 16.0),
            inside: vec![false, true],
            options: &options,
            pieces: VecDeque::new(),
            triangles: Queue::default(),
            region: Region::default(),
            left_alone: Vec::new(),
            removed,
        };
        let refined = work.finish(true);
        let vertices = refined.triangulation().kernel().len();
        assert_eq!(vertices, 6 + present.len());
        let verdict = judged(&graph, refined.triangulation(), Promise::Constrained);
        assert!(verdict.ok, "{verdict}");
    }
}

/// Those that are not retired, by the numbers that they have.
fn cells_of(live: &Live) -> Vec<CellId> {
    let mut mesh = live.mesh.clone();
    let mut number: Vec<CellId> = mesh.cells().collect();
    mesh.compact(|from, to| number[to.index()] = number[from.index()]);
    number.truncate(mesh.cell_count());
    number
}

/// The hull is inside, and no segment is on it.
#[test]
fn a_point_on_a_bare_hull_stays() {
    let points = [[0.0, 0.0], [4.0, 0.0], [-2.0, -8.0], [0.0, 1.0]];
    let graph = Pslg::new(&points, &[[0, 2], [1, 2]]).unwrap();
    for (centre, encroachment) in METHODS {
        let limits = Limits { vertices_max: 200 };
        let options = RefineOptions { centre, encroachment, limits, ..RefineOptions::default() };
        let refined = refine(&graph, &Fill::Hull, &options, &mut ()).unwrap();
        let verdict = judged(&graph, refined.triangulation(), Promise::Constrained);
        assert!(verdict.ok, "{centre:?} {encroachment:?}: {verdict}");
    }
}

/// Three segments of an apex: the first two meet at 40 degrees, the last two at 64. Points at one distance from it on the former subtend the small
/// angle, those on the latter do not, whatever else the apex has.
#[test]
fn only_small_angles_are_input_angles() {
    let points = [[0.0, 0.0], [8.0, 0.0], [6.0, 5.0], [-2.0, 8.0]];
    let graph = pslg(&points, &[[0, 1], [0, 2], [0, 3]]);
    let cdt = cavity(&graph, &Options::default(), &mut ());
    let mut live = Live::new(&cdt, &graph);
    let apexes = Apexes::new(&cdt, &live);
    let on = [0, 1, 2].map(|piece| {
        let share = 1.0 / live.length(piece).unwrap();
        let t = if live.segments[piece as usize][0] == 0 { share } else { 1.0 - share };
        live.split_piece(piece, crate::parameter::Parameter::Double(t), &mut ())
    });
    let [r, s] = [1, 3].map(VertexId::new);
    assert!(subtends_input_angle(&live, &apexes, [on[0], on[1], s]));
    assert!(!subtends_input_angle(&live, &apexes, [on[1], on[2], r]));
}

/// Where nothing is outside but beyond the hull, and corners are wide, no subsegment is left with a vertex in its disk.
#[test]
fn no_subsegment_is_left_encroached() {
    let wide = polygon(&[[0.0, 0.0], [10.0, 0.0], [13.0, 7.0], [6.0, 12.0], [-3.0, 8.0]]);
    // A site on top is in the disk of the bottom, whose middle then is in that of the longer part of the top.
    let strip = polygon(&[[0.0, 0.0], [40.0, 0.0], [40.0, 1.0], [15.0, 1.0], [0.0, 1.0]]);
    let areas = [8.0, 2.0, 0.5, 0.125].into_iter().flat_map(|area| [(&wide, area), (&strip, area)]);
    for (graph, area_max) in areas.chain([(&strip, f64::INFINITY)]) {
        let (encroachment, angle_deg_min) =
            (Encroachment::Disk, if area_max < 9.0 { 20.7 } else { 0.0 });
        let options =
            RefineOptions { angle_deg_min, area_max, encroachment, ..RefineOptions::default() };
        let refined = refine(graph, &Fill::Exterior, &options, &mut ()).unwrap();
        let verdict = judged(graph, refined.triangulation(), Promise::EmptyDisks);
        assert!(verdict.ok, "{area_max}: {verdict}");
    }
}
