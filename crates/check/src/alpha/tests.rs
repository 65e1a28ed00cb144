use dashu_int::IBig;

use super::*;

type Told = Vec<(Vec<u32>, String)>;

fn claim(values: &[(&[u32], &str)]) -> Told {
    values.iter().map(|&(vertices, value)| (vertices.to_vec(), value.to_owned())).collect()
}

/// A square of side 2 and its diagonal 1 2, by hand: 1 for sides, 2 for the rest.
fn square() -> ([[f64; 2]; 4], Told) {
    let told = claim(&[
        (&[0], "0"),
        (&[1], "0"),
        (&[2], "0"),
        (&[3], "0.0"),
        (&[0, 1], "1"),
        (&[0, 2], "1e0"),
        (&[3, 1], "1"),
        (&[2, 3], "1"),
        (&[1, 2], "2"),
        (&[0, 1, 2], "2"),
        (&[1, 3, 2], "2"),
    ]);
    ([[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 2.0]], told)
}

#[test]
fn a_square_is_accepted_and_every_change_is_found() {
    let (points, told) = square();
    let judge = |told: &[(Vec<u32>, String)]| judge_alpha(&points, None, told, &Options::foreign());
    let verdict = judge(&told);
    assert!(verdict.ok && verdict.level == Level::AlphaFiltration, "{verdict}");
    for i in 0..told.len() {
        let mut wrong = told.clone();
        wrong[i].1 = "1.0000000000000002".to_owned();
        assert!(judge(&wrong).has("wrong-value"), "{i}");
        wrong[i].1 = "nonsense".to_owned();
        assert!(judge(&wrong).has("wrong-value"), "{i}");
        let mut twice = told.clone();
        twice.push(told[i].clone());
        assert!(!judge(&twice).ok, "{i}");
        let mut fewer = told.clone();
        fewer.remove(i);
        assert!(!judge(&fewer).ok, "{i}");
    }
    let mut stranger = told.clone();
    stranger.push((vec![0, 3], "2".to_owned()));
    assert!(judge(&stranger).has("extra-simplex"));
    let mut fewer = told;
    fewer.remove(8);
    assert!(judge(&fewer).has("missing-simplex"));
}

#[test]
fn a_long_edge_has_the_value_of_its_triangle() {
    let points = [[0.0, 0.0], [8.0, 0.0], [4.0, 1.0]];
    // R = abc / 4A = 8 * 17 / 16, of the edge too; the circle of the long edge holds the apex.
    let told = |long: &str| {
        claim(&[
            (&[0], "0"),
            (&[1], "0"),
            (&[2], "0"),
            (&[0, 2], "17/4"),
            (&[1, 2], "17/4"),
            (&[0, 1], long),
            (&[0, 1, 2], "289/4"),
        ])
    };
    assert!(judge_alpha(&points, None, &told("578/8"), &Options::foreign()).ok);
    assert!(judge_alpha(&points, None, &told("16"), &Options::foreign()).has("wrong-value"));
    assert!(judge_alpha(&points, None, &told("72.25"), &Options::foreign()).has("wrong-value"));
}

#[test]
fn doubles_must_be_the_nearest() {
    // A third of 2^-2: no double.
    let value = Radius { above: IBig::from(1), below: IBig::from(3), exponent: -2 };
    let nearest = 1.0 / 12.0f64;
    let tells = |x: f64| Claimed::Nearest(x).tells(&value);
    assert!(tells(nearest) && !tells(nearest.next_up()) && !tells(nearest.next_down()));
    let zero = Radius { above: IBig::ZERO, below: IBig::from(3), exponent: 7 };
    assert!(
        Claimed::Nearest(0.0).tells(&zero) && !Claimed::Nearest(f64::MIN_POSITIVE).tells(&zero)
    );
    assert!(Claimed::read("1/0", true).is_none() && Claimed::read("inf", false).is_none());
}

#[test]
fn weights_shift_and_hide() {
    // Two balls on a line: the orthogonal circle of the edge is where both powers are equal, at x = (16 + 3) / 8.
    let points = [[0.0, 0.0], [4.0, 0.0], [1.0, 0.0]];
    let weights = [3.0, 0.0, -9.0];
    let told = claim(&[(&[0], "-3"), (&[1], "0"), (&[0, 1], "169/64")]);
    let verdict = judge_alpha(&points, Some(&weights), &told, &Options::foreign());
    assert!(verdict.ok, "{verdict}");
}

#[test]
fn nothing_is_a_filtration_of_nothing() {
    assert!(judge_alpha::<2>(&[], None, &[], &Options::foreign()).ok);
    let one = claim(&[(&[0], "0")]);
    assert!(judge_alpha(&[[3.0, 4.0]], None, &one, &Options::foreign()).ok);
    let empty_cell = claim(&[(&[], "0")]);
    assert!(!judge_alpha(&[[3.0, 4.0]], None, &empty_cell, &Options::foreign()).ok);
}
