//! Predicates against GMP: orient in 2, 3, 4 dimensions, lifted and in_sphere in 2 and 3, in_sphere_within, cross; of both
//! kernels; on more than 10^5 calls.
//!
//! | module | what |
//! |---|---|
//! | `oracle` | the exact signs, by rationals and by integers: two ways that share nothing |
//! | `inputs` | random, ULP neighbourhoods, integer grids, exact completions, wide exponents, wild |
//! | `signs` | the comparison |
//! | `bound` | inputs whose floating-point determinant is near the filter's error bound |
//! | `algebra` | permutations, scaling, translation, the perturbation |
//! | `classroom` | published lines near which plain doubles are wrong |
//! | `constructed` | points on segments, crossings of lines and planes, against rationals |
//! | `headroom` | determinants that fill the exact integers |
//! | `fixtures` | the collected ones of another program |
//! | `laws` | permutations, scaling, translation, reflection, duality: of all kernels, in 2 to 6 dimensions |
//! | `metric` | lengths, angles and radii, against rationals |
//! | `known` | inputs on which other programs are wrong |

mod algebra;
mod bound;
mod classroom;
mod constructed;
mod fixtures;
mod headroom;
mod inputs;
mod known;
mod laws;
mod metric;
mod oracle;
mod signs;
