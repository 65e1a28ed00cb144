//! Which format a file is in: by its ending, and where several formats share one, by its content.
//!
//! | ending | format |
//! |---|---|
//! | `.node .poly .smesh .ele .edge .neigh .csv .off .obj .ply .stl .npy .wkt .svg .edg .lar.json .geojson` | that of the name |
//! | `.xyz .pts .pwn` | point list |
//! | `.json .xml .txt .dat .xy .cin` and all others | by content |
//! | `..xz` | by the name without it |
//!
//! Three things no content can tell, so the name does: `x y` lines are a ring in a `.dat` file and points elsewhere;
//! counted runs of points are open lines if the name contains `polyline`; a single counted run is a point list if
//! the name contains `point`.

mod sniff;

use std::fmt;

/// A file format. `Json` stands for all dialects that are told apart by their structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Format {
    /// Triangle and TetGen `.node`.
    Node,
    /// Triangle and TetGen `.poly`.
    Poly,
    /// TetGen `.smesh`, read only.
    Smesh,
    /// Triangle and TetGen `.ele`.
    Ele,
    /// Triangle `.edge`.
    Edge,
    /// Triangle and TetGen `.neigh`, written only.
    Neigh,
    /// Table with named columns.
    Csv,
    /// Point list.
    Xyz,
    /// LAR JSON.
    Lar,
    /// OFF and nOFF.
    Off,
    /// Wavefront OBJ.
    Obj,
    /// PLY, read only.
    Ply,
    /// STL, read only.
    Stl,
    /// NumPy's table of doubles, a point a row.
    Npy,
    /// GeoJSON.
    GeoJson,
    /// Any JSON dialect, read only.
    Json,
    /// Well-known text.
    Wkt,
    /// Lines of fields between `|`, those that are WKT read; read only.
    WktTable,
    /// JTS and GEOS test suites, read only.
    JtsXml,
    /// SVG drawings, read only.
    Svg,
    /// GSHHG shorelines, read only.
    Gshhg,
    /// Sites `p x y`, `s x1 y1 x2 y2`, read only.
    Cin,
    /// artem-ogre/CDT, read only.
    VertexEdge,
    /// detria, read only.
    Detria,
    /// Boost.Polygon Voronoi, read only.
    Boost,
    /// Counted segments, read only.
    SegmentList,
    /// poly2tri, read only.
    P2t,
    /// Counted runs of points, closed, read only.
    RingList,
    /// Counted runs of points, open, read only.
    PolylineList,
    /// Clipper2 test suites, read only.
    Clipper,
    /// Manifold test sets, read only.
    Manifold,
}

impl Format {
    /// All formats with the names that `--format` takes.
    pub const NAMES: [(Self, &str); 31] = [
        (Self::Node, "node"),
        (Self::Poly, "poly"),
        (Self::Smesh, "smesh"),
        (Self::Ele, "ele"),
        (Self::Edge, "edge"),
        (Self::Neigh, "neigh"),
        (Self::Csv, "csv"),
        (Self::Xyz, "xyz"),
        (Self::Lar, "lar.json"),
        (Self::Off, "off"),
        (Self::Obj, "obj"),
        (Self::Ply, "ply"),
        (Self::Stl, "stl"),
        (Self::Npy, "npy"),
        (Self::GeoJson, "geojson"),
        (Self::Json, "json"),
        (Self::Wkt, "wkt"),
        (Self::WktTable, "wkt-table"),
        (Self::JtsXml, "xml"),
        (Self::Svg, "svg"),
        (Self::Gshhg, "gshhg"),
        (Self::Cin, "cin"),
        (Self::VertexEdge, "vertex-edge"),
        (Self::Detria, "detria"),
        (Self::Boost, "boost"),
        (Self::SegmentList, "segments"),
        (Self::P2t, "p2t"),
        (Self::RingList, "rings"),
        (Self::PolylineList, "polylines"),
        (Self::Clipper, "clipper"),
        (Self::Manifold, "manifold"),
    ];

    /// The format `--format` names.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(_, known)| *known == name).map(|(format, _)| *format)
    }

    /// The format a file's ending names, if that alone decides; for files to be written.
    #[must_use]
    pub fn from_path(path: &str) -> Option<Self> {
        let name = plain_name(path);
        if name.ends_with(".lar.json") {
            return Some(Self::Lar);
        }
        let (_, ending) = name.rsplit_once('.')?;
        Some(match ending {
            "xyz" | "pts" | "pwn" => Self::Xyz,
            "edg" => Self::SegmentList,
            "node" | "poly" | "smesh" | "ele" | "edge" | "neigh" | "csv" | "off" | "obj"
            | "ply" | "stl" | "npy" | "geojson" | "wkt" | "svg" => return Self::from_name(ending),
            _ => return None,
        })
    }

    /// Whether [`crate::write`] writes it.
    #[must_use]
    pub fn is_written(self) -> bool {
        matches!(
            self,
            Self::Node
                | Self::Poly
                | Self::Ele
                | Self::Edge
                | Self::Neigh
                | Self::Csv
                | Self::Xyz
                | Self::Lar
                | Self::Off
                | Self::Obj
                | Self::Npy
                | Self::GeoJson
                | Self::Wkt
        )
    }

    /// The format of a file from its name and, where that does not decide, its content.
    #[must_use]
    pub fn detect(path: &str, bytes: &[u8]) -> Option<Self> {
        let by_name = Self::from_path(path);
        if by_name == Some(Self::Poly) && !sniff::is_triangle_poly(bytes) {
            return Some(Self::RingList);
        }
        by_name.or_else(|| sniff::by_content(&path.to_ascii_lowercase(), bytes))
    }

    /// Whether the points are in a `.node` file beside.
    pub(crate) fn wants_nodes(self) -> bool {
        matches!(self, Self::Poly | Self::Smesh | Self::Ele | Self::Edge)
    }
}

/// The last part of a path in lower case, without `.xz`.
fn plain_name(path: &str) -> String {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path).to_ascii_lowercase();
    name.strip_suffix(".xz").map_or(name.clone(), str::to_owned)
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name =
            Self::NAMES.iter().find(|(format, _)| format == self).map_or("?", |(_, name)| name);
        f.pad(name)
    }
}

#[cfg(test)]
mod tests;
