//! `delone convert`: from any format that is read to any that is written; what would be lost is said.

use serde_json::json;

use crate::cli;
use crate::failure::Failure;
use crate::progress::Busy;
use crate::{input, output};

pub(crate) fn convert(arguments: &cli::Convert) -> Result<(), Failure> {
    for path in &arguments.outputs {
        output::format_to_write(path)?;
    }
    output::check_paths(arguments.outputs.iter().map(std::path::PathBuf::as_path))?;
    let busy = Busy::new(arguments.voice.quiet, "reading");
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    let mut notes = document.notes.clone();
    busy.at("writing");
    for path in &arguments.outputs {
        let lost = output::document(path, &document)?;
        notes.extend(lost.into_iter().map(|lost| format!("{}: {lost}", path.display())));
    }
    drop(busy);
    if arguments.voice.json {
        let object = json!({
            "schema": "delone.convert/1",
            "input": {
                "path": document.name,
                "sites": document.point_count(),
                "segments": document.segments.len(),
            },
            "outputs": arguments.outputs,
            "notes": notes,
        });
        println!("{object}");
    } else if !arguments.voice.quiet {
        notes.iter().for_each(|note| eprintln!("note: {note}"));
    }
    Ok(())
}
