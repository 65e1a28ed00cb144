#![allow(clippy::all, clippy::pedantic, clippy::restriction, missing_docs)]
use delone_conforming::*;
use delone_formats::read_all;
use delone_sites::{Pslg, Snapped};
use std::path::Path;
use std::time::*;
struct D(Instant);
impl delone_probe::Probe for D {
    fn on(&mut self, _: delone_probe::Event) {}
    fn goes_on(&mut self) -> bool { self.0 > Instant::now() }
}
fn main() {
    for file in std::env::args().skip(1) {
        for document in read_all(Path::new(&file)).unwrap_or_default() {
            let segments: Vec<[usize; 2]> = document.segments.iter().map(|e| e.map(|v| v as usize)).collect();
            let Ok(points) = document.points_2d() else { continue };
            if segments.is_empty() { continue }
            let pslg = match Pslg::new(points, &segments) {
                Ok(p) => p,
                Err(_) => {
                    if segments.len() > 1000 { continue }
                    let Some(cut) = Snapped::new(points, &segments, 20).ok().filter(|c| c.is_settled) else { continue };
                    let Ok(p) = Pslg::new(&cut.points, &cut.segments) else { continue };
                    p
                }
            };
            if pslg.sites().len() > 20000 { continue }
            let o = ConformOptions { limits: Limits { vertices_max: 10 * pslg.sites().len() + 100_000 }, ..Default::default() };
            let mut row = format!("{} {}", document.name, pslg.sites().len());
            for m in methods().iter().take(std::env::var("ALL").map_or(2, |_| 3)) {
                let r = (m.run)(&pslg, &o, &mut D(Instant::now() + Duration::from_secs(std::env::var("SECS").ok().and_then(|s| s.parse().ok()).unwrap_or(5))));
                row += &format!(" | {} {}{}", m.name, r.steiner_points().len(), if r.is_complete() { "" } else { " INCOMPLETE" });
            }
            println!("{row}{}", if std::env::var("ALL").is_ok() { "" } else { " | saalfeld" });
        }
    }
}
