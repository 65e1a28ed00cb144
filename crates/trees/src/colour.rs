//! White, black, gray.

/// What is known of a cell: no leaf is gray, and nothing else is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Outside, all of it.
    White,
    /// Inside, all of it.
    Black,
    /// Cut into sons.
    Gray,
}

impl Colour {
    /// Black if inside, white if not.
    #[must_use]
    pub fn of(inside: bool) -> Self {
        if inside { Self::Black } else { Self::White }
    }

    /// White for black, black for white, gray for gray.
    #[must_use]
    pub fn complement(self) -> Self {
        match self {
            Self::White => Self::Black,
            Self::Black => Self::White,
            Self::Gray => Self::Gray,
        }
    }
}
