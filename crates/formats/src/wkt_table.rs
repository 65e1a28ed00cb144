//! Tables of WKT, as SFCGAL's tests have them: fields between `|`, those that are geometries each a document.
//!
//! `#` starts a comment line. A field may begin with a flag `0` or `1`. Fields that are no geometry (names, numbers,
//! references `@name`, what a test expects of an exception) are left out.

use crate::document::Document;
use crate::error::ReadError;
use crate::text::lines;
use crate::wkt;

pub(crate) fn read(text: &str) -> Result<Vec<Document>, ReadError> {
    let mut documents = Vec::new();
    for line in lines(text, None).filter(|line| !line.text.starts_with('#')) {
        for field in line.text.split('|') {
            let geometry = field.trim_start_matches(|c: char| c.is_ascii_digit() || c == ' ');
            if wkt::looks_like(geometry) {
                let document = wkt::read_one(geometry.trim_end());
                documents.push(document.map_err(|error| error.after_line(line.number))?);
            }
        }
    }
    Ok(documents)
}
