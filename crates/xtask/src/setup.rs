//! What the tests need beyond Rust, and how it gets here.
//!
//! | need | Debian package | for |
//! |---|---|---|
//! | `g++` | g++ | the CGAL peer |
//! | CGAL's headers | libcgal-dev | the CGAL peer |
//! | GMP and MPFR headers | libgmp-dev, libmpfr-dev | the CGAL peer |
//! | `qdelaunay` | qhull-bin | the Qhull peer |
//! | `m4`, `make` | m4, make | the `rug` backend of the judge, which builds GMP |
//!
//! The program itself needs none of this.

use std::path::Path;
use std::process::Command;

use crate::run::{run, succeeds};

struct Need {
    package: &'static str,
    is_here: fn() -> bool,
}

const NEEDS: [Need; 7] = [
    Need { package: "g++", is_here: || succeeds("g++", &["--version"]) },
    Need { package: "m4", is_here: || succeeds("m4", &["--version"]) },
    Need { package: "make", is_here: || succeeds("make", &["--version"]) },
    Need { package: "libcgal-dev", is_here: || header("CGAL/version.h") },
    Need { package: "libgmp-dev", is_here: || header("gmp.h") },
    Need { package: "qhull-bin", is_here: || succeeds("qdelaunay", &["-V"]) },
    Need { package: "libmpfr-dev", is_here: || header("mpfr.h") },
];

/// Whether the C++ compiler finds a header.
fn header(name: &str) -> bool {
    let folders = ["/usr/include", "/usr/include/x86_64-linux-gnu", "/usr/local/include"];
    folders.iter().any(|folder| Path::new(folder).join(name).exists())
}

fn missing() -> Vec<&'static str> {
    NEEDS.iter().filter(|need| !(need.is_here)()).map(|need| need.package).collect()
}

/// Installs what is missing.
pub(crate) fn setup() -> Result<(), String> {
    let packages = missing();
    if packages.is_empty() {
        return Ok(());
    }
    println!("The tests need {}.", packages.join(", "));
    if !succeeds("apt-get", &["--version"]) {
        return Err(format!("install {} with your package manager", packages.join(", ")));
    }
    run(&mut apt(&["update"]))?;
    let mut words = vec!["install", "--yes", "--no-install-recommends"];
    words.extend(&packages);
    run(&mut apt(&words))?;
    match missing() {
        left if left.is_empty() => Ok(()),
        left => Err(format!("still missing after installation: {}", left.join(", "))),
    }
}

/// `apt-get`, through sudo unless we are root.
fn apt(arguments: &[&str]) -> Command {
    let is_root = succeeds("sh", &["-c", "test $(id -u) = 0"]);
    let mut command = if is_root {
        Command::new("apt-get")
    } else {
        let mut sudo = Command::new("sudo");
        sudo.arg("apt-get");
        sudo
    };
    command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive");
    command
}
