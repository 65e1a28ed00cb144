//! `delone tree`: quadtrees of shapes, their numbers, their codes.

use std::path::Path;

use delone_trees::{
    BinTree, Bits, Frame, Joined, LeafRule, OrthTree, Quadrant, Rule, Shape, SonOrder,
};
use serde_json::{Value, json};

use crate::cli::{Build, Code, Encode, Inside, Leaves, SonsIn, Stats, Tree, TreeAction};
use crate::failure::Failure;
use crate::progress::Busy;
use crate::{input, output};

pub(crate) fn tree(arguments: &Tree) -> Result<(), Failure> {
    match &arguments.action {
        TreeAction::Build(arguments) => build(arguments),
        TreeAction::Stats(arguments) => stats(arguments),
        TreeAction::Encode(arguments) => encode(arguments),
    }
}

fn build(arguments: &Build) -> Result<(), Failure> {
    output::check_paths(arguments.output.as_deref())?;
    let busy = Busy::new(arguments.voice.quiet, "growing");
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    let points = document.points_2d().map_err(Failure::input)?;
    let segments: Vec<[usize; 2]> =
        document.segments.iter().map(|ends| ends.map(|end| end as usize)).collect();
    let shape = Shape::new(&points, &segments, rule(arguments.inside)).map_err(Failure::input)?;
    let frame = shape.frame(arguments.depth).map_err(Failure::input)?;
    let tree = shape.tree(&frame, leaves(arguments.rule));
    if let Some(path) = &arguments.output {
        output::text(path, &(tree.to_text() + "\n"))?;
    }
    let mut object = numbers(&tree, arguments.depth);
    place(&mut object, &frame);
    drop(busy);
    tell(&object, arguments.voice.json);
    if !arguments.voice.quiet {
        document.notes.iter().for_each(|note| eprintln!("note: {note}"));
    }
    Ok(())
}

fn stats(arguments: &Stats) -> Result<(), Failure> {
    let tree = read(&arguments.code)?;
    tell(&numbers(&tree, tree.depth()), arguments.voice.json);
    Ok(())
}

fn encode(arguments: &Encode) -> Result<(), Failure> {
    output::check_paths(arguments.output.as_deref())?;
    let tree = read(&arguments.code)?;
    let text = match arguments.code_as {
        Code::Df => tree.to_text_in(order(arguments.order)) + "\n",
        Code::Bits => digits(&tree.to_bits()),
        Code::Levels => digits(&tree.to_level_bits()),
        Code::Linear => tree.to_linear(),
        Code::Pbm => tree.to_raster(tree.depth()).map_err(Failure::input)?.to_pbm(),
    };
    match &arguments.output {
        Some(path) => output::text(path, &text),
        None => output::print_bytes(text.as_bytes()),
    }
}

fn read(path: &Path) -> Result<OrthTree<2>, Failure> {
    let failed =
        |error: &dyn std::fmt::Display| Failure::input(format!("{}: {error}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| failed(&error))?;
    OrthTree::from_text(&text).map_err(|fault| failed(&fault))
}

fn digits(bits: &Bits) -> String {
    bits.iter().map(|bit| if bit { '1' } else { '0' }).chain(['\n']).collect()
}

/// What is known of a tree; areas and perimeters in cells of a level and their sides.
fn numbers(tree: &OrthTree<2>, depth: u8) -> Value {
    let counts = tree.counts();
    let text = |number: Option<u128>| number.map(|number| number.to_string());
    json!({
        "schema": "delone.tree/1",
        "depth": depth,
        "gray": counts.gray,
        "black": counts.black,
        "white": counts.white,
        "leaves": counts.leaves(),
        "bits": counts.nodes() + counts.leaves(),
        "area_cells": text(tree.volume(depth)),
        "perimeter_sides": text(tree.surface(depth)),
        "euler": tree.euler(Joined::ByFacets),
        "components": tree.components(Joined::ByFacets).count,
        "bintree_leaves": BinTree::from(tree).counts().leaves(),
    })
}

fn place(object: &mut Value, frame: &Frame<2>) {
    object["corner"] = json!(frame.corner());
    object["side"] = json!(frame.side());
    object["resolution"] = json!(frame.resolution());
}

fn tell(object: &Value, as_json: bool) {
    if as_json {
        println!("{object}");
        return;
    }
    for (key, value) in object.as_object().into_iter().flatten().filter(|(key, _)| *key != "schema")
    {
        println!("{key:16} {}", value.as_str().map_or_else(|| value.to_string(), str::to_owned));
    }
}

fn rule(inside: Inside) -> Rule {
    match inside {
        Inside::EvenOdd => Rule::EvenOdd,
        Inside::Nonzero => Rule::NonZero,
    }
}

fn leaves(rule: Leaves) -> LeafRule {
    match rule {
        Leaves::Inner => LeafRule::Inner,
        Leaves::Outer => LeafRule::Outer,
        Leaves::Centre => LeafRule::Centre,
    }
}

fn order(order: SonsIn) -> SonOrder {
    match order {
        SonsIn::Morton => SonOrder::Morton,
        SonsIn::Nw => SonOrder::Clockwise(Quadrant::NorthWest),
        SonsIn::Ne => SonOrder::Clockwise(Quadrant::NorthEast),
        SonsIn::Se => SonOrder::Clockwise(Quadrant::SouthEast),
        SonsIn::Sw => SonOrder::Clockwise(Quadrant::SouthWest),
        SonsIn::Hilbert => SonOrder::Hilbert,
    }
}
