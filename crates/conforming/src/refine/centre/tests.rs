use delone_workloads::Rng;

use super::*;

/// The cotangent of half of 20 degrees.
fn cotangent() -> f64 {
    1.0 / 10f64.to_radians().tan()
}

fn exactly(corners: [[f64; 2]; 3], kind: Centre) -> Option<[f64; 2]> {
    let corners = corners.map(|p| p.map(Dyadic::from));
    exact_centre(&corners, kind, cotangent()).map(|p| p.map(|x| x.to_f64()))
}

#[test]
fn centres_are_on_the_bisector() {
    let corners = [[0.0, 0.0], [4.0, 0.0], [2.0, 8.0]];
    for kind in [Centre::Circumcentre, Centre::OffCentre] {
        // Its least angle is 28 degrees: the off-centre would be further.
        assert_eq!(centre(corners, kind, cotangent()), Some([2.0, 3.75]), "15 / 4");
        assert_eq!(exactly(corners, kind), Some([2.0, 3.75]));
    }
    let slim = [[0.0, 0.0], [4.0, 0.0], [2.0, 800.0]];
    assert_eq!(centre(slim, Centre::Circumcentre, cotangent()).map(|p| p[1].round()), Some(400.0));
    let off = centre(slim, Centre::OffCentre, cotangent()).unwrap();
    let angle = 2.0 * (2.0 / off[1]).atan().to_degrees();
    assert!(
        off[0] == 2.0 && (20.0..21.5).contains(&angle),
        "a little more than was asked for: {angle}"
    );
}

#[test]
fn both_ways_agree() {
    let mut random = Rng::new(2);
    for _ in 0..300 {
        let [x, y] = [0; 2].map(|_| random.between(-1.0, 1.0));
        let height = random.between(1.0, 50.0);
        let corners = [[x, y], [x + 1.0, y + 0.1], [x + random.between(0.0, 1.0), y + height]];
        for kind in [Centre::Circumcentre, Centre::OffCentre] {
            let (near, exact) = (centre(corners, kind, cotangent()), exactly(corners, kind));
            let (near, exact) = (near.unwrap(), exact.unwrap());
            let off = (near[0] - exact[0]).hypot(near[1] - exact[1]);
            assert!(off < 1e-10, "{corners:?} {kind:?}: {off}");
        }
    }
}

/// Rounding turns triangles over that are nearly flat; no centre gets to the wrong side of the shortest edge for that.
#[test]
fn flat_triangles_have_their_centres_on_the_right_side() {
    let mut random = Rng::new(4);
    let mut turned = 0;
    for _ in 0..2000 {
        let [near, far] = [random.between(0.01, 0.1), random.between(1.0, 50.0)];
        let mut corners = [0.0, near, far].map(|t| [0.1 + t, 0.3 + 3.0 * t]);
        let area = |corners: [[f64; 2]; 3]| {
            let [p, q, r] = corners.map(|p| p.map(Dyadic::from));
            cross(&between(&r, &p), &between(&r, &q)).sign()
        };
        if area(corners) == Sign::Negative {
            corners.swap(0, 1);
        }
        if area(corners) == Sign::Zero {
            continue;
        }
        let [p, q, r] = corners;
        let off = centre(corners, Centre::OffCentre, cotangent()).unwrap();
        assert_eq!(area([p, q, off]), Sign::Positive, "{corners:?}");
        let [a, b] = [p, q].map(|p| [p[0] - r[0], p[1] - r[1]]);
        turned += usize::from(a[0] * b[1] - a[1] * b[0] < 0.0);
    }
    assert!(turned > 10, "{turned}");
}

#[test]
fn exact_centres_are_short() {
    let third = Dyadic::from(1.0 / 3.0);
    let long = (0..30i64).fold(Dyadic::ZERO, |x, i| x + third.clone().scaled(-50 * i));
    let small = |x: f64| Dyadic::from(x).scaled(-300);
    let at = |x: f64, y: f64| [long.clone() + small(x), small(y)];
    let [x, y] = exact_centre(
        &[at(0.0, 0.0), at(4.0, 0.0), at(2.0, 8.0)],
        Centre::Circumcentre,
        cotangent(),
    )
    .unwrap();
    let off = [x.clone() - &long - &small(2.0), y - &small(3.75)];
    assert!(off.iter().all(|off| off.magnitude().is_none_or(|size| size < -330)), "{off:?}");
    assert!(x.mantissa().len() <= 7, "300 bits and 40, not 1500");
    assert_eq!(
        exact_centre(&[at(0.0, 0.0), at(1.0, 0.0), at(3.0, 0.0)], Centre::OffCentre, 2.0),
        None,
        "flat"
    );
}
