//! The lists of `delone alpha`: the filtration, its signature, its persistence; as text in columns, or in JSON.

use delone_alpha::{AlphaFiltration, Cut, SimplexId, fraction};
use serde_json::{Value, json};

use super::{Task, figures};
use crate::failure::Failure;
use crate::output;

/// A list: the key in JSON, the names of its columns, its rows.
struct List {
    key: &'static str,
    columns: Vec<String>,
    rows: Vec<Vec<Value>>,
}

pub(super) fn tell<const D: usize>(
    task: &Task<'_>,
    filtration: &AlphaFiltration<D>,
    build: f64,
) -> Result<(), Failure> {
    let asked = &task.arguments.asked;
    let values: Vec<Value> = filtration
        .spectrum()
        .map(
            |value| {
                if task.arguments.exact { json!(fraction(&value)) } else { json!(value.to_f64()) }
            },
        )
        .collect();
    if let Some(path) = &task.arguments.svg {
        let svg = if asked.signature {
            figures::betti_numbers(filtration)
        } else {
            figures::persistence(filtration)
        };
        output::text(path, &svg)?;
    }
    let list = if asked.filtration {
        simplices(task, filtration, &values)
    } else if asked.signature {
        signature(filtration, &values)
    } else {
        persistence(filtration, &values)
    };
    if task.arguments.voice.json {
        let mut object = task.head(filtration, build, filtration.whole());
        object["columns"] = json!(list.columns);
        object[list.key] = json!(list.rows);
        println!("{object}");
        return Ok(());
    }
    output::print_bytes(list.text().as_bytes())
}

impl List {
    fn text(&self) -> String {
        let word = |value: &Value| match value {
            Value::String(text) => text.clone(),
            Value::Null => "inf".to_owned(),
            Value::Array(list) => {
                list.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
            }
            other => other.to_string(),
        };
        let mut text = format!("# {}\n", self.columns.join(" "));
        for row in &self.rows {
            text.push_str(&row.iter().map(word).collect::<Vec<_>>().join(" "));
            text.push('\n');
        }
        text
    }
}

fn columns(names: &[&str]) -> Vec<String> {
    names.iter().map(|&name| name.to_owned()).collect()
}

/// `dimension vertices value`, in order.
fn simplices<const D: usize>(
    task: &Task<'_>,
    filtration: &AlphaFiltration<D>,
    values: &[Value],
) -> List {
    let names = task.subject.names();
    let row = |id: u32| {
        let simplex = SimplexId::new(id as usize);
        let vertices = filtration.simplices().vertices(simplex);
        let vertices: Vec<u32> = vertices.iter().map(|&v| names[v as usize]).collect();
        let value = values[filtration.rank(simplex) as usize].clone();
        vec![json!(vertices.len() - 1), json!(vertices), value]
    };
    List {
        key: "filtration",
        columns: columns(&["dimension", "vertices", "squared_radius"]),
        rows: filtration.order().into_iter().map(row).collect(),
    }
}

/// A row for every value: what there is up to it.
fn signature<const D: usize>(filtration: &AlphaFiltration<D>, values: &[Value]) -> List {
    let (counts, betti) = (filtration.simplex_curves(), filtration.betti_curves());
    let measures = filtration.plane_measures();
    let numbered = |name: &str, count: usize| (0..count).map(|k| format!("{name}{k}")).collect();
    let mut columns = columns(&["squared_radius"]);
    let whole = filtration.whole();
    let names: [Vec<String>; 2] =
        [numbered("simplices_", counts.at(whole).len()), numbered("betti_", betti.at(whole).len())];
    columns.extend(names.into_iter().flatten());
    columns.push("euler".to_owned());
    if measures.is_some() {
        columns.extend(["area".to_owned(), "perimeter".to_owned()]);
    }
    let row = |(ranks, value): (u32, &Value)| {
        let (cut, mut row) = (Cut::new(ranks), vec![value.clone()]);
        let numbers = counts.at(cut);
        row.extend(numbers.iter().map(|&count| json!(count)));
        row.extend(betti.at(cut).iter().map(|&count| json!(count)));
        let even: usize = numbers.iter().step_by(2).sum();
        let odd: usize = numbers.iter().skip(1).step_by(2).sum();
        row.push(if even >= odd { json!(even - odd) } else { json!(-json_number(odd - even)) });
        if let Some(measures) = &measures {
            let [area, perimeter] = measures[ranks as usize];
            row.extend([json!(area), json!(perimeter)]);
        }
        row
    };
    List { key: "signature", columns, rows: (1..).zip(values).map(row).collect() }
}

fn json_number(number: usize) -> i64 {
    i64::try_from(number).expect("fewer than 2^63 simplices")
}

/// `dimension birth death`, without classes that die at once.
fn persistence<const D: usize>(filtration: &AlphaFiltration<D>, values: &[Value]) -> List {
    let value = |rank: u32| values[rank as usize].clone();
    let bars = filtration.persistence().bars(filtration);
    let row = |bar: &delone_alpha::Bar| {
        vec![json!(bar.dimension), value(bar.birth), bar.death.map_or(Value::Null, value)]
    };
    List {
        key: "persistence",
        columns: columns(&["dimension", "birth", "death"]),
        rows: bars.iter().map(row).collect(),
    }
}
