//! `delone shrink`: a failing input made as small as possible.

use delone_laws::fuzz::{Broken, Input, Subject};
use serde_json::json;

use super::fuzz::program::Program;
use super::fuzz::{files, findings, target_for};
use crate::cli;
use crate::failure::Failure;
use crate::output;
use crate::progress::spinner;

pub(crate) fn shrink(arguments: &cli::Shrink) -> Result<(), Failure> {
    output::check_paths(arguments.output.as_deref())?;
    let input = files::read(&arguments.input, arguments.target.as_deref())?;
    let mut program = Program::new(&arguments.program)?;
    let target = target_for(arguments.target.as_deref(), &input)?;
    let one = match (&program, &arguments.law) {
        (None, Some(law)) => target.only(law).ok_or_else(|| {
            let known = target.laws().join(", ");
            Failure::input(format!("{} has no law called {law}: there are {known}", target.name))
        })?,
        _ => target,
    };
    let mut run = |input: &Input| -> Option<Broken> {
        match &mut program {
            Some(program) => program.try_on(input).err(),
            None => (&mut &one).try_on(input).err(),
        }
    };
    let Some(broken) = run(&input) else {
        let name = arguments.input.display();
        return Err(Failure::input(format!(
            "{name}: nothing fails here, so nothing can be made smaller"
        )));
    };
    let bar = spinner(arguments.voice.quiet);
    bar.set_message("making it smaller");
    let small = findings::smallest(&input, &broken, arguments.tests, &mut run);
    bar.finish_and_clear();
    let file = arguments.output.clone().unwrap_or_else(|| {
        let stem = arguments.input.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let folder = arguments.input.parent().unwrap_or(std::path::Path::new(""));
        files::path(folder, &format!("{stem}.min"), &small)
    });
    let broken = run(&small).unwrap_or(broken);
    files::keep(&file, &small, &broken)?;
    let [before, after] = [&input, &small].map(|input| [input.points(), input.segments()]);
    if arguments.voice.json {
        println!(
            "{}",
            json!({
                "schema": "delone.shrink/1", "law": broken.law, "place": broken.place, "message": broken.message,
                "before": before, "points": after[0], "segments": after[1], "file": file.to_string_lossy(),
            })
        );
    } else {
        println!("{broken}");
        println!(
            "{} points and {} segments, from {} and {}: {}",
            after[0],
            after[1],
            before[0],
            before[1],
            file.display()
        );
    }
    Ok(())
}
