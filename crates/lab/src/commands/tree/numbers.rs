//! What is known of a tree, as JSON or in lines.

use delone_trees::{BinTree, Frame, Joined, OrthTree};
use serde_json::{Value, json};

/// Volumes and surfaces are in cells of a level and their facets.
pub(super) fn numbers<const N: usize>(tree: &OrthTree<N>, depth: u8) -> Value {
    let counts = tree.counts();
    let text = |number: Option<u128>| number.map(|number| number.to_string());
    let (volume, surface) =
        if N == 2 { ("area_cells", "perimeter_sides") } else { ("volume_cells", "surface_facets") };
    json!({
        "schema": "delone.tree/1",
        "dimension": N,
        "depth": depth,
        "gray": counts.gray,
        "black": counts.black,
        "white": counts.white,
        "leaves": counts.leaves(),
        "bits": counts.nodes() + counts.leaves(),
        volume: text(tree.volume(depth)),
        surface: text(tree.surface(depth)),
        "euler": tree.euler(Joined::ByFacets),
        "components": tree.components(Joined::ByFacets).count,
        "bintree_leaves": BinTree::from(tree).counts().leaves(),
    })
}

pub(super) fn place<const N: usize>(object: &mut Value, frame: &Frame<N>) {
    object["corner"] = json!(frame.corner().to_vec());
    object["side"] = json!(frame.side());
    object["resolution"] = json!(frame.resolution());
}

pub(super) fn tell(object: &Value, as_json: bool) {
    if as_json {
        println!("{object}");
        return;
    }
    for (key, value) in object.as_object().into_iter().flatten().filter(|(key, _)| *key != "schema")
    {
        println!("{key:16} {}", value.as_str().map_or_else(|| value.to_string(), str::to_owned));
    }
}
