//! A small soak in every test run, and the oracle against its second formulation.

use delone_benches::adversary::{
    Tally, points, round, round_of_constructed, round_of_cross, round_of_metric, round_of_power,
};
use delone_benches::oracle;
use delone_benches::predicates::{Input, Predicate, contestants, tuples};
use delone_benches::random::Random;

fn soak(seed: u64, rounds: usize, round: fn(&mut Random, &mut Tally)) {
    let (mut random, mut tally) = (Random::new(seed), Tally::default());
    (0..rounds).for_each(|_| round(&mut random, &mut tally));
    assert_eq!(tally.wrong, 0, "{tally:?}");
    assert!(tally.zeros * 50 > tally.calls / 5, "there are degenerate calls: {tally:?}");
}

#[test]
fn predicates_agree_with_the_oracle() {
    soak(11, 1000, round::<1, 3>);
    soak(12, 4000, round::<2, 4>);
    soak(13, 4000, round::<3, 5>);
    soak(14, 200, round::<4, 6>);
    soak(15, 20, round::<5, 7>);
    soak(16, 10, round::<6, 8>);
    soak(17, 4, round::<7, 9>);
}

#[test]
fn cross_products_agree_with_the_oracle() {
    soak(18, 4000, round_of_cross);
}

#[test]
fn power_tests_agree_with_the_oracle() {
    soak(20, 400, round_of_power::<2, 4>);
    soak(21, 400, round_of_power::<3, 5>);
    soak(22, 40, round_of_power::<4, 6>);
}

#[test]
fn constructed_points_agree_with_the_oracle() {
    soak(23, 300, round_of_constructed::<2>);
    soak(24, 150, round_of_constructed::<3>);
    soak(25, 20, round_of_constructed::<4>);
}

#[test]
fn lengths_radii_and_smallest_spheres_agree_with_the_oracle() {
    soak(26, 300, round_of_metric::<2>);
    soak(27, 200, round_of_metric::<3>);
}

#[test]
fn the_oracle_agrees_with_elimination_over_rationals() {
    let mut random = Random::new(19);
    for _ in 0..300 {
        let plane: [[f64; 2]; 4] = points(&mut random);
        assert_eq!(oracle::orient(&plane[..3]), oracle::by_elimination(&plane[..3], false));
        assert_eq!(oracle::in_sphere(&plane), oracle::by_elimination(&plane, true));
        let space: [[f64; 3]; 5] = points(&mut random);
        assert_eq!(oracle::orient(&space[..4]), oracle::by_elimination(&space[..4], false));
        assert_eq!(oracle::in_sphere(&space), oracle::by_elimination(&space, true));
    }
}

/// The benchmark, tiny, as a test: our answers are those of the oracle on its inputs, the naive ones are not.
#[test]
fn the_contestants_that_are_right_agree() {
    for predicate in Predicate::ALL {
        for input in Input::ALL {
            let contestants = contestants(predicate, &tuples(predicate, input, 50));
            let answers = |name| {
                let of_name = contestants.iter().find(|contestant| contestant.name == name);
                (of_name.expect("a contestant").run)()
            };
            for name in ["kernel", "exact", "free"] {
                assert_eq!(
                    answers(name),
                    answers("rug integers"),
                    "{name} {predicate:?} {input:?}"
                );
            }
        }
    }
}
