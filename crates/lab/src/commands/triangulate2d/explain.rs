//! `--explain`: one numbered picture for each step from the soup to its inside.

use std::path::Path;

use delone_cdt::{Cdt, EdgeKind};
use delone_draw::{Picture, Style};

use super::Soup;
use crate::failure::Failure;
use crate::output;

/// Writes `1-soup.svg`, `2-cdt.svg`, `3-edges.svg`, `4-regions.svg` and `5-inside.svg` to a folder, made if there is none.
pub(super) fn explain(soup: &Soup<'_>, cdt: &Cdt, folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::input(format!("{}: {error}", folder.display())))?;
    let names = soup.subject.names();
    let name = |v: delone_mesh::VertexId| names[v.index()];
    let regions = soup.interior.domain.regions();
    let (mut triangles, mut classes) = (Vec::new(), Vec::new());
    for cell in cdt.cells() {
        let corners = cdt.mesh().corners(cell);
        triangles.push([0, 1, 2].map(|corner| name(corners[corner])));
        classes.push(regions.of_cell(cell));
    }
    let pieces: Vec<[u32; 2]> =
        cdt.constrained_edges().iter().map(|ends| ends.map(|v| names[v as usize])).collect();
    let edges = soup.interior.ev.iter().zip(&soup.interior.kinds);
    let one_sided = |kind: Option<EdgeKind>| matches!(kind, Some(EdgeKind::Shell | EdgeKind::Hole));
    let (bounds, inner): (Vec<_>, Vec<_>) = edges.partition(|(_, kind)| one_sided(**kind));
    let [bounds, inner] = [bounds, inner].map(|list| list.into_iter().map(|(e, _)| *e).collect());
    let (bounds, inner): (Vec<[u32; 2]>, Vec<[u32; 2]>) = (bounds, inner);
    let all = Picture { points: &soup.vertices, ..Picture::default() };
    let steps = [
        (
            "1-soup",
            "the edges as given",
            Picture { segments: &soup.subject.document.segments, ..all },
        ),
        (
            "2-cdt",
            "constrained Delaunay triangulation of the hull",
            Picture { triangles: &triangles, segments: &pieces, ..all },
        ),
        (
            "3-edges",
            "edges with an inner triangle on one side, in red, and on both",
            Picture { segments: &inner, highlights: &bounds, ..all },
        ),
        (
            "4-regions",
            "what the edges separate",
            Picture { triangles: &triangles, classes: &classes, segments: &pieces, ..all },
        ),
        (
            "5-inside",
            "the triangles inside",
            Picture { triangles: &soup.interior.fv, segments: &bounds, ..all },
        ),
    ];
    for (file, title, picture) in steps {
        let style = Style { title: title.to_owned(), numbered: true, ..Style::default() };
        output::text(&folder.join(file).with_extension("svg"), &picture.svg(&style))?;
    }
    Ok(())
}
