//! Vectors of the plane in numbers of any length.

use delone_predicates::Dyadic;

/// Two coordinates.
pub(crate) type Vector = [Dyadic; 2];

/// From one point to another.
pub(crate) fn between(from: &Vector, to: &Vector) -> Vector {
    [0, 1].map(|axis| to[axis].clone() - &from[axis])
}

pub(crate) fn dot(u: &Vector, v: &Vector) -> Dyadic {
    &u[0] * &v[0] + &u[1] * &v[1]
}

/// Twice the area of the triangle of two vectors, positive if the second is to the left.
pub(crate) fn cross(u: &Vector, v: &Vector) -> Dyadic {
    &u[0] * &v[1] - &u[1] * &v[0]
}

/// The squared length.
pub(crate) fn square(u: &Vector) -> Dyadic {
    dot(u, u)
}
