//! `delone tree growth`: how trees grow with their depth.

use delone_trees::{Joined, OrthTree};
use serde_json::{Value, json};

use super::boundary::{Boundary, Grown, read, with_tree};
use crate::cli::Growth;
use crate::failure::Failure;

pub(super) fn growth(arguments: &Growth) -> Result<(), Failure> {
    let document = read(&arguments.source, arguments.voice.quiet)?;
    let boundary = Boundary::of(&document, arguments.inside)?;
    if !arguments.voice.json {
        println!("depth  gray       leaves     times  leaves/border  bintree/leaves  components");
    }
    let mut before = None;
    for depth in arguments.from..=arguments.to {
        let grown = boundary.tree(depth, arguments.rule)?;
        let row = with_tree!(&grown, tree, _frame => row(tree, depth, before));
        before = row["leaves"].as_u64();
        if arguments.voice.json {
            println!("{row}");
        } else {
            tell(&row);
        }
    }
    Ok(())
}

/// The numbers of a tree; how often the leaves of the tree before; the leaves for each facet of a smallest cell in the border.
fn row<const N: usize>(tree: &OrthTree<N>, depth: u8, before: Option<u64>) -> Value {
    let counts = tree.counts();
    let leaves = counts.leaves();
    let surface = tree.surface(depth).unwrap_or(0);
    let bintree = delone_trees::BinTree::from(tree).counts().leaves();
    json!({
        "schema": "delone.tree-growth/1",
        "depth": depth,
        "gray": counts.gray,
        "leaves": leaves,
        "times": before.map(|before| leaves as f64 / before as f64),
        "leaves_by_border": leaves as f64 / surface as f64,
        "bintree_by_leaves": bintree as f64 / leaves as f64,
        "components": tree.components(Joined::ByFacets).count,
    })
}

fn tell(row: &Value) {
    let number =
        |key: &str| row[key].as_f64().map_or_else(|| "-".to_owned(), |x| format!("{x:.3}"));
    println!(
        "{:<6} {:<10} {:<10} {:<6} {:<14} {:<15} {}",
        row["depth"],
        row["gray"],
        row["leaves"],
        number("times"),
        number("leaves_by_border"),
        number("bintree_by_leaves"),
        row["components"]
    );
}
