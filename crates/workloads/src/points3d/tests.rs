use crate::{Points, generate};

fn space(name: &str, n: usize) -> Vec<[f64; 3]> {
    let Points::Space(points) = generate(name, n, 3).unwrap().points else { panic!("{name}") };
    points
}

#[test]
fn cospherical_is_exact_and_distinct_and_as_many_as_jacobi_says() {
    for n in [1, 2, 8, 9, 1000, 5000] {
        let mut points: Vec<[i64; 3]> = space("cospherical", n)
            .iter()
            .map(|p| p.map(|x| format!("{x}").parse().unwrap()))
            .collect();
        assert_eq!(points.len(), n);
        let norm = |p: &[i64; 3]| p.iter().map(|x| x * x).sum::<i64>();
        assert!(points.iter().all(|p| norm(p) == norm(&points[0])));
        points.sort_unstable();
        points.dedup();
        assert_eq!(points.len(), n);
    }
}

#[test]
fn flat_sets_are_flat() {
    assert!(space("coplanar", 99).iter().all(|p| p[2] == 1.0));
    assert!(space("coplanar-tilted", 99).iter().all(|[x, y, z]| *z == 2.0 * x + 3.0 * y));
    let on_cube = |p: &[f64; 3]| p.iter().any(|&x| x == 0.0 || x == 1.0);
    assert!(space("cube-surface", 99).iter().all(on_cube));
    assert!(
        space("sphere", 99)
            .iter()
            .all(|p| (p.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-14)
    );
}
