//! `delone tree stats`, `encode` and `op`: trees given by their depth-first expressions.

use std::path::Path;

use delone_trees::{Bits, OrthTree, Quadrant, SonOrder};

use super::numbers::{numbers, tell};
use crate::cli::{Code, Encode, Kind, Operate, SetOperation, SonsIn, Stats};
use crate::failure::Failure;
use crate::output;

pub(super) fn stats(arguments: &Stats) -> Result<(), Failure> {
    let object = match arguments.kind {
        Kind::Quad => {
            let tree = read::<2>(&arguments.code)?;
            numbers(&tree, tree.depth())
        }
        Kind::Oct => {
            let tree = read::<3>(&arguments.code)?;
            numbers(&tree, tree.depth())
        }
    };
    tell(&object, arguments.voice.json);
    Ok(())
}

pub(super) fn encode(arguments: &Encode) -> Result<(), Failure> {
    output::check_paths(arguments.output.as_deref())?;
    let text = match arguments.kind {
        Kind::Quad => plane_code(&read(&arguments.code)?, arguments)?,
        Kind::Oct => code(&read::<3>(&arguments.code)?, arguments.code_as)
            .ok_or_else(|| Failure::input("pictures and orders of sons are of quadtrees"))?,
    };
    write(arguments.output.as_deref(), &text)
}

pub(super) fn operate(arguments: &Operate) -> Result<(), Failure> {
    output::check_paths(arguments.output.as_deref())?;
    let text = match arguments.kind {
        Kind::Quad => operated::<2>(arguments)?,
        Kind::Oct => operated::<3>(arguments)?,
    };
    write(arguments.output.as_deref(), &text)
}

fn operated<const N: usize>(arguments: &Operate) -> Result<String, Failure> {
    let [first, second] = [&arguments.first, &arguments.second].map(|path| read::<N>(path));
    let (first, second) = (first?, second?);
    let tree = match arguments.operation {
        SetOperation::Union => first.union(&second),
        SetOperation::Intersection => first.intersection(&second),
        SetOperation::Difference => first.difference(&second),
        SetOperation::Xor => first.symmetric_difference(&second),
    };
    Ok(tree.to_text() + "\n")
}

fn plane_code(tree: &OrthTree<2>, arguments: &Encode) -> Result<String, Failure> {
    Ok(match arguments.code_as {
        Code::Df => tree.to_text_in(order(arguments.order)) + "\n",
        Code::Pbm => tree.to_raster(tree.depth()).map_err(Failure::input)?.to_pbm(),
        other => code(tree, other).unwrap_or_default(),
    })
}

/// A code that trees of every dimension have.
fn code<const N: usize>(tree: &OrthTree<N>, code: Code) -> Option<String> {
    match code {
        Code::Df => Some(tree.to_text() + "\n"),
        Code::Bits => Some(digits(&tree.to_bits())),
        Code::Levels => Some(digits(&tree.to_level_bits())),
        Code::Linear => Some(tree.to_linear()),
        Code::Pbm => None,
    }
}

fn write(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    match path {
        Some(path) => output::text(path, text),
        None => output::print_bytes(text.as_bytes()),
    }
}

fn read<const N: usize>(path: &Path) -> Result<OrthTree<N>, Failure> {
    let failed =
        |error: &dyn std::fmt::Display| Failure::input(format!("{}: {error}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| failed(&error))?;
    OrthTree::from_text(&text).map_err(|fault| failed(&fault))
}

fn digits(bits: &Bits) -> String {
    bits.iter().map(|bit| if bit { '1' } else { '0' }).chain(['\n']).collect()
}

pub(super) fn order(order: SonsIn) -> SonOrder {
    match order {
        SonsIn::Morton => SonOrder::Morton,
        SonsIn::Nw => SonOrder::Clockwise(Quadrant::NorthWest),
        SonsIn::Ne => SonOrder::Clockwise(Quadrant::NorthEast),
        SonsIn::Se => SonOrder::Clockwise(Quadrant::SouthEast),
        SonsIn::Sw => SonOrder::Clockwise(Quadrant::SouthWest),
        SonsIn::Hilbert => SonOrder::Hilbert,
    }
}
