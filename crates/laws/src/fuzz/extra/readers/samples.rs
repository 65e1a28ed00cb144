//! Small files, one or more of each format.

use delone::formats::Format;

use crate::choices::Choices;

/// Texts.
pub(super) const SAMPLES: [(Format, &str); 35] = [
    (Format::Node, "4 2 1 1\n1 0 0 0.5 1\n\n2 1 0 -1 1 # two\r\n3 1 1 2 0\n4 0 1e-3 0 0\n"),
    (Format::Node, "2 3 0 0\n0 0 0 1\n1 3 2 -1e-3\n"),
    (
        Format::Poly,
        "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n3 1\n0 0 1 5\n1 1 2 -6\n2 2 0 7\n1\n0 1 1\n2\n0 1 2 3 0.5\n1 2 1 4\n",
    ),
    (
        Format::Poly,
        "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n3 0\n1\n3 1 2 3\n2 0\n4 1 2\n 3 4\n2 1 4\n1 1\n3 2 3 4\n1 0.5 0.5 0.5\n0\n",
    ),
    (Format::Smesh, "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n1 0\n3 1 2 3\n0\n0\n"),
    (Format::Csv, "id,x,y,w\n7,0.5,1,2\n8,3,4,5\n"),
    (Format::Xyz, "2\n1 2 3\n4 5 6\n"),
    (Format::Xyz, "0 -0\r\n1.5\t2\r\n"),
    (Format::Lar, "{\"V\": [[0,0],[1,-0],[0.1,1e300]],\n\"EV\": [[0,1]],\n\"FV\": [[0,1,2]]}\n"),
    (Format::Off, "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n"),
    (Format::Off, "nOFF\n2\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n"),
    (
        Format::Obj,
        "# o\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nl 1 2 3\nf -1 -2 -3\n",
    ),
    (
        Format::Ply,
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0.1\n3 0 1 2\n",
    ),
    (
        Format::Stl,
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\nendsolid s\n",
    ),
    (
        Format::GeoJson,
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":null,\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[0,1],[0,0]]]}},{\"type\":\"Feature\",\"properties\":{},\"geometry\":{\"type\":\"Point\",\"coordinates\":[5,6,7]}}]}",
    ),
    (
        Format::Json,
        "{\"note\":\"n\",\"points\":[[\"0\",\"0\"],[\"1.5\",\"0\"]],\"edges\":[[0,1]],\"segments\":[[\"1.5\",\"0\",\"2\",\"2\"]],\"hole_points\":[[\"9\",\"9\"]]}",
    ),
    (
        Format::Json,
        "{\"num_points\":4,\"points_x\":[0,9,0,1],\"points_y\":[0,0,9,1],\"region_boundary\":[0,1,2],\"num_constraints\":1,\"additional_constraints\":[[0,3]]}",
    ),
    (
        Format::Json,
        "{\"type\":\"Topology\",\"transform\":{\"scale\":[2,1],\"translate\":[10,0]},\"objects\":{},\"arcs\":[[[0,0],[1,1],[1,0]]]}",
    ),
    (
        Format::Json,
        "{\"glyphs\":{\"o\":{\"path\":[[\"moveTo\",[[0,0]]],[\"qCurveTo\",[[2,0],[2,2],[0,2]]],[\"lineTo\",[[0,1]]],[\"closePath\",[]]]}}}",
    ),
    (Format::Json, "[[[0,0],[1,0],[0,1]],[[5,5]]]"),
    (
        Format::Wkt,
        "GEOMETRYCOLLECTION(POINT(0.1 1e300),LINESTRING(0 -0,1 0))\nPOLYGON Z((0 0 1,1 0 1,0 1 1,0 0 1),EMPTY)\nMULTIPOINT((1 2),3 4)\n",
    ),
    (Format::WktTable, "#c\n2|POINT(0 0)|@A|LINESTRING(0 0,1 0)\n0 POLYGON((0 0,1 0,0 1))\n"),
    (
        Format::JtsXml,
        "<run>\n<case><desc>d</desc>\n<a>\n POINT(1 2)\n</a><b>0101000000000000000000F03F0000000000000040</b>\n<test><op name=\"x\" arg1=\"A\">true</op></test></case>\n<case><a>LINESTRING(0 0,1 1)</a></case></run>",
    ),
    (
        Format::Svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><g transform='translate(10) rotate(30)'><rect width='1' height='2' transform='scale(2)'/><path d='M0 0 Q 1 2 2 0 C 3 1 4 1 5 0 a 1 2 30 0 1 3 3 h 2 v -1 S 1 1 2 2 T 3 4 Z M 9 9 l 1 0'/><polygon points='0,0 1,0 0,1'/><ellipse rx='2' ry='1'/></g></svg>",
    ),
    (Format::Gshhg, "# note\n> 1 1 0.5 4\n0 0\n1 0\n0 1\n0 0\n"),
    (Format::Cin, "s 0 0 1 0 r\np 0 0\np 5 5\n"),
    (Format::VertexEdge, "3 2\n0 0\n0 0\n1 1\n0 2\n1 1\n"),
    (Format::Detria, "3 1 1\n3\n0\n0 0\n1 0\n0 1\n0\n1\n2\n0 1\n"),
    (Format::Boost, "1\n5 5\n1\n0 0 1 0\n"),
    (Format::SegmentList, "2\n0/1 1/3 1 1\n1 1 2/2 0\n"),
    (Format::P2t, "0 0\n9 0\n0 9\nHOLE\n1 1\n2 1\n1 2\nSTEINER\n3 3\n"),
    (Format::RingList, "2\n3\n0 0\n1 0\n0 1\n3\n0 0\n1 0\n0 1\n"),
    (Format::PolylineList, "3 0 0 9 0 0 9\n1\n3 1 1 2 1 1 2\n"),
    (
        Format::Clipper,
        "CAPTION: 1.\nSUBJECTS\n0,0, 9,0, 0,9\nSUBJECTS_OPEN\n1,1 2,2\nCLIPS\n5,5 6,5 5,6\n\nCAPTION: 2.\n",
    ),
    (Format::Manifold, "One 1 -1.0 1\n3\n0 0\n1 0\n0 1\nTwo 1 5e-6 0\n"),
];

/// A binary STL or PLY file of one triangle, or its corners as a table of NumPy's.
pub(super) fn binary(choices: &mut dyn Choices) -> (Format, Vec<u8>) {
    let corners: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.5];
    if choices.one_in(3) {
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        let header = "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }\n";
        bytes.extend(u16::try_from(header.len()).expect("short").to_le_bytes());
        bytes.extend(header.bytes());
        bytes.extend(corners.iter().flat_map(|&x| f64::from(x).to_le_bytes()));
        return (Format::Npy, bytes);
    }
    if choices.one_in(2) {
        let mut bytes = vec![0; 80];
        bytes.extend(1_u32.to_le_bytes());
        bytes.extend([0.0; 3].iter().chain(&corners).flat_map(|x: &f32| x.to_le_bytes()));
        bytes.extend([0, 0]);
        return (Format::Stl, bytes);
    }
    let is_big = choices.one_in(2);
    let order = if is_big { "big" } else { "little" };
    let head = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
         element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    );
    let mut bytes = head.into_bytes();
    let put = |word: [u8; 4]| if is_big { [word[3], word[2], word[1], word[0]] } else { word };
    bytes.extend(corners.iter().flat_map(|x| put(x.to_le_bytes())));
    bytes.push(3);
    bytes.extend([0_u32, 1, 2].iter().flat_map(|id| put(id.to_le_bytes())));
    (Format::Ply, bytes)
}
