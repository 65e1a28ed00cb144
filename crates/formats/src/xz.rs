//! `.xz` around any file. Memory is bounded: the dictionary by 128 MiB, the content by 1 GiB.

use std::io::Read;

use lzma_rust2::XzReader;

use crate::error::{ReadError, at};

const DICTIONARY_KIB_MAX: u32 = 128 << 10;
const CONTENT_MAX: u64 = 1 << 30;

pub(crate) fn looks_like(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xFD7zXZ\0")
}

pub(crate) fn decompress(bytes: &[u8]) -> Result<Vec<u8>, ReadError> {
    let mut content = Vec::new();
    let reader = XzReader::new_mem_limit(bytes, true, DICTIONARY_KIB_MAX);
    match reader.take(CONTENT_MAX + 1).read_to_end(&mut content) {
        Ok(_) if u64::try_from(content.len()).is_ok_and(|length| length <= CONTENT_MAX) => {
            Ok(content)
        }
        Ok(_) => {
            Err(ReadError::Compression { at: at(0), found: "more than 1 GiB of content".into() })
        }
        Err(error) => Err(ReadError::Compression { at: at(0), found: error.to_string() }),
    }
}

#[cfg(test)]
mod tests;
