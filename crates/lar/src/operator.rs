//! Boundary and coboundary as sparse matrices.

use std::io::{self, Write};

use sprs::CsMat;

use crate::Complex;
use crate::complex::without;

/// A signed operator between chains: entries -1 and 1.
pub type Operator = CsMat<i8>;

impl<const D: usize> Complex<D> {
    /// The boundary operator from chains of dimension `k` to those of dimension `k - 1`: one row for each face, one column
    /// for each cell, compressed by columns. The boundary of vertices has no rows.
    ///
    /// # Panics
    /// Never: a complex holds the faces of its cells.
    #[must_use]
    pub fn boundary(&self, k: usize) -> Operator {
        let rows = k.checked_sub(1).map_or(0, |k| self.cells(k).len());
        let (mut starts, mut indices, mut entries) = (vec![0], Vec::new(), Vec::new());
        for cell in self.cells(k) {
            if k > 0 {
                // The face without the last vertex comes first in order.
                for i in (0..=k).rev() {
                    let face = self.find(&without(cell, i));
                    indices.push(face.expect("a complex holds the faces of its cells"));
                    entries.push(if i % 2 == 0 { 1 } else { -1 });
                }
            }
            starts.push(indices.len());
        }
        CsMat::new_csc((rows, self.cells(k).len()), starts, indices, entries)
    }

    /// The coboundary operator from chains of dimension `k` to those of dimension `k + 1`: the boundary of these, transposed.
    #[must_use]
    pub fn coboundary(&self, k: usize) -> Operator {
        self.boundary(k + 1).transpose_into()
    }

    /// Writes the boundary operator of dimension `k` in the Matrix Market exchange format; indices there go from 1.
    ///
    /// ```
    /// # use delone_lar::Complex;
    /// let edge = Complex::closure(vec![[0.0], [1.0]], &[&[0, 1]]).unwrap();
    /// let mut text = Vec::new();
    /// edge.write_matrix_market(1, &mut text).unwrap();
    /// assert_eq!(text, b"%%MatrixMarket matrix coordinate integer general\n2 1 2\n1 1 -1\n2 1 1\n");
    /// ```
    ///
    /// # Errors
    /// If writing fails.
    pub fn write_matrix_market(&self, k: usize, out: &mut impl Write) -> io::Result<()> {
        let operator = self.boundary(k);
        writeln!(out, "%%MatrixMarket matrix coordinate integer general")?;
        writeln!(out, "{} {} {}", operator.rows(), operator.cols(), operator.nnz())?;
        for (column, entries) in operator.outer_iterator().enumerate() {
            for (row, entry) in entries.iter() {
                writeln!(out, "{} {} {entry}", row + 1, column + 1)?;
            }
        }
        Ok(())
    }
}
