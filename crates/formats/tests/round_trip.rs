//! Writing and reading back is the identity, bit for bit, on everything the format can hold.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

mod common;

use delone_formats::{Document, Format, Region, Source, one, read_bytes, write};
use proptest::collection::vec;
use proptest::prelude::*;

/// Any finite double: tiny, huge, subnormal, both zeros.
fn real() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
        (-3_i8..4).prop_map(f64::from),
        Just(-0.0),
    ]
}

/// A document whose every part is filled.
fn document() -> impl Strategy<Value = Document> {
    (2_usize..4, 1_usize..12, 0_usize..3, 0_u32..2).prop_flat_map(
        |(dimension, n, per, first_index)| {
            let last = u32::try_from(n).unwrap() - 1;
            let v = move || 0..=last;
            let points = vec(real(), n * dimension);
            let attributes = vec(real(), n * per);
            let markers = prop_oneof![Just(vec![]), vec(any::<i64>(), n)];
            let segments = vec((v().prop_flat_map(move |a| (Just(a), v())), any::<i64>()), 0..6);
            let triangles = vec([v(), v(), v()], 0..5);
            let tets = vec([v(), v(), v(), v()], 0..5);
            let polygons = vec(vec(v(), 4..7), 0..3);
            let holes = vec(real(), dimension);
            let region = (vec(real(), dimension), real(), proptest::option::of(real()));
            (
                (points, attributes, markers, segments, triangles),
                (tets, polygons, holes, region, vec(real(), n)),
            )
                .prop_map(
                    move |((points, attributes, point_markers, segments, triangles), rest)| {
                        let (tets, polygons, holes, (seed, attribute, size_max), weights) = rest;
                        Document {
                            points,
                            attributes,
                            attributes_per_point: per,
                            point_markers,
                            segment_markers: segments.iter().map(|s| s.1).collect(),
                            segments: segments.into_iter().map(|s| s.0.into()).collect(),
                            triangles,
                            tets,
                            polygons,
                            holes,
                            regions: vec![Region { seed, attribute, size_max }],
                            weights: Some(weights),
                            first_index,
                            ..Document::new(dimension)
                        }
                    },
                )
        },
    )
}

fn written(document: &Document, format: Format) -> Vec<u8> {
    let mut out = Vec::new();
    write(document, format, &mut out).unwrap();
    out
}

fn through(document: &Document, format: Format) -> Document {
    let (bytes, nodes) = (written(document, format), written(document, Format::Node));
    let source = Source { name: "", bytes: &bytes, format: Some(format), nodes: Some(&nodes) };
    one(read_bytes(&source).unwrap(), "").unwrap()
}

/// `Debug` tells the two zeros apart, `==` does not.
fn same<T: std::fmt::Debug>(a: &T, b: &T) {
    assert_eq!(format!("{a:?}"), format!("{b:?}"));
}

fn same_nodes(a: &Document, b: &Document) {
    same(&a.dimension, &b.dimension);
    same(&a.points, &b.points);
    same(&a.attributes, &b.attributes);
    same(&a.attributes_per_point, &b.attributes_per_point);
    same(&a.point_markers, &b.point_markers);
    same(&a.first_index, &b.first_index);
}

proptest! {
    #![proptest_config(common::cases(200))]

    #[test]
    fn node(document in document()) {
        same_nodes(&through(&document, Format::Node), &document);
    }

    #[test]
    fn poly(document in document()) {
        let again = through(&document, Format::Poly);
        same_nodes(&again, &document);
        same(&again.segments, &document.segments);
        same(&again.holes, &document.holes);
        same(&again.regions, &document.regions);
        if document.dimension == 2 {
            same(&again.segment_markers, &document.segment_markers);
        } else {
            same(&again.triangles, &document.triangles);
            same(&again.polygons, &document.polygons);
        }
    }

    #[test]
    fn ele(document in document()) {
        let again = through(&document, Format::Ele);
        same_nodes(&again, &document);
        if document.dimension == 2 {
            same(&again.triangles, &document.triangles);
        } else {
            same(&again.tets, &document.tets);
        }
    }

    #[test]
    fn edge(document in document()) {
        let again = through(&document, Format::Edge);
        same_nodes(&again, &document);
        same(&again.segments, &document.segments);
        same(&again.segment_markers, &document.segment_markers);
    }

    #[test]
    fn csv(document in document()) {
        let again = through(&document, Format::Csv);
        same(&again.points, &document.points);
        same(&again.weights, &document.weights);
        same(&again.attributes, &document.attributes);
    }

    #[test]
    fn xyz(document in document()) {
        same(&through(&document, Format::Xyz).points, &document.points);
    }

    #[test]
    fn lar(document in document()) {
        let again = through(&document, Format::Lar);
        same(&again.points, &document.points);
        same(&again.segments, &document.segments);
        same(&again.triangles, &document.triangles);
        same(&again.polygons, &document.polygons);
        same(&again.tets, &document.tets);
    }

    #[test]
    fn off_and_obj(mut document in document()) {
        // Space stays space: a plane of zeros would be read as 2D.
        if document.dimension == 3 {
            document.points[2] = 1.0;
        }
        for format in [Format::Off, Format::Obj] {
            let again = through(&document, format);
            same(&again.points, &document.points);
            same(&again.triangles, &document.triangles);
            same(&again.polygons, &document.polygons);
        }
        same(&through(&document, Format::Obj).segments, &document.segments);
    }
}
