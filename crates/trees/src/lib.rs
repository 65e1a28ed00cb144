//! Domain trees: 2^N-trees of black, white and gray cells.

mod cell;
mod codes;
mod colour;
mod fault;
mod frame;
mod measure;
mod orth;
mod raster;
mod sets;
mod shape;
mod writer;

#[cfg(test)]
mod testing;

pub use cell::{Cell, DEPTH_MAX};
pub use codes::Bits;
pub use colour::Colour;
pub use fault::CodeFault;
pub use frame::{Frame, FrameFault};
pub use measure::{Components, Joined};
pub use orth::{Counts, OrthTree};
pub use raster::{RASTER_BITS_MAX, Raster};
pub use shape::{LeafRule, Rule, Shape, ShapeFault};
