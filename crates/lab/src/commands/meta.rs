//! What the program says about itself: algorithms and papers, completions, the manual page.

use clap::CommandFactory;
use clap_complete::Shell;

use crate::cli::Arguments;
use crate::failure::Failure;
use crate::output::print_bytes;

pub(crate) fn cite() -> Result<(), Failure> {
    let mut text =
        String::from("Algorithms and the papers that they follow (papers/ has a note on each):\n");
    let delaunay = delone_delaunay::algorithms::<2>();
    let delaunay = delaunay.iter().map(|a| ("delaunay", a.name, a.papers));
    let cdt = delone_cdt::algorithms();
    let cdt = cdt.iter().map(|a| ("cdt", a.name, a.papers));
    let conform = delone_conforming::methods();
    let conform = conform.iter().map(|m| ("conform", m.name, m.papers));
    for (command, name, papers) in delaunay.chain(cdt).chain(conform) {
        text.push_str(&format!("  {command:10} {name:16} {}\n", papers.join(", ")));
    }
    print_bytes(text.as_bytes())
}

pub(crate) fn completions(shell: Shell) -> Result<(), Failure> {
    let mut bytes = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "delone", &mut bytes);
    print_bytes(&bytes)
}

pub(crate) fn man() -> Result<(), Failure> {
    let mut bytes = Vec::new();
    clap_mangen::Man::new(Arguments::command()).render(&mut bytes).map_err(Failure::input)?;
    print_bytes(&bytes)
}
