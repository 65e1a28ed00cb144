//! Exploded pictures: the triangles moved apart, so that each is seen for itself.

use super::Picture;

/// The triangles of a picture, each with corners of its own, moved away from the middle. Vertices keep their numbers; edges are
/// numbered anew, as each side is an edge for itself.
///
/// ```
/// use delone_draw::{Exploded, Picture, Style};
///
/// let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// let picture = Picture { points: &points, triangles: &[[0, 1, 2], [0, 2, 3]], ..Picture::default() };
/// let exploded = Exploded::new(&picture, 1.5);
/// assert_eq!(exploded.picture().points.len(), 6);
/// assert!(exploded.picture().svg(&Style::default()).starts_with("<svg"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Exploded {
    points: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
    segments: Vec<[u32; 2]>,
    classes: Vec<u32>,
    names: Vec<u32>,
}

impl Exploded {
    /// Moves the centroid of each triangle `factor` times as far from the middle as it is; 1 only takes the triangles apart.
    /// Segments that are sides of triangles are drawn on each of these; others, and points of no triangle, are left out.
    #[must_use]
    pub fn new(picture: &Picture<'_>, factor: f64) -> Self {
        let frame = picture.frame();
        let [wide, high] = frame.proportions;
        // Coordinates of the unit square, so that nothing overflows.
        let place = |v: u32| {
            let p = crate::num::at(picture.points, v).and_then(|p| frame.unit(p))?;
            Some([(p[0] - 0.5) * wide, (p[1] - 0.5) * high])
        };
        let mut strong: Vec<[u32; 2]> =
            picture.segments.iter().map(|&ends| ascending(ends)).collect();
        strong.sort_unstable();
        let mut exploded = Self {
            points: vec![],
            triangles: vec![],
            segments: vec![],
            classes: vec![],
            names: vec![],
        };
        for (i, &[a, b, c]) in picture.triangles.iter().enumerate() {
            let (Some(p), Some(q), Some(r)) = (place(a), place(b), place(c)) else { continue };
            let shift = [0, 1].map(|x| (factor - 1.0) * (p[x] + q[x] + r[x]) / 3.0);
            let Ok(first) = u32::try_from(exploded.points.len()) else { break };
            exploded.points.extend([p, q, r].map(|p| [p[0] + shift[0], p[1] + shift[1]]));
            exploded.names.extend([a, b, c]);
            exploded.triangles.push([first, first + 1, first + 2]);
            exploded.classes.push(picture.classes.get(i).copied().unwrap_or(1));
            let sides = [([a, b], [0, 1]), ([b, c], [1, 2]), ([c, a], [2, 0])];
            let on_segments = sides
                .into_iter()
                .filter(|(side, _)| strong.binary_search(&ascending(*side)).is_ok());
            exploded.segments.extend(on_segments.map(|(_, ends)| ends.map(|end| first + end)));
        }
        exploded
    }

    /// What to draw.
    #[must_use]
    pub fn picture(&self) -> Picture<'_> {
        Picture {
            points: &self.points,
            triangles: &self.triangles,
            segments: &self.segments,
            classes: &self.classes,
            names: &self.names,
            ..Picture::default()
        }
    }
}

fn ascending([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
