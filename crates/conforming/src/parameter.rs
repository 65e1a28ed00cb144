//! Parameters on segments: doubles where these are precise enough, numbers of any length elsewhere.

use delone_predicates::Dyadic;

/// How far along a segment, its length being one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Parameter {
    /// This double.
    Double(f64),
    /// No double.
    Long(Box<Dyadic>),
}

impl From<Dyadic> for Parameter {
    fn from(t: Dyadic) -> Self {
        let near = t.to_f64();
        if Dyadic::from(near) == t { Self::Double(near) } else { Self::Long(Box::new(t)) }
    }
}

impl Parameter {
    pub(crate) fn exact(&self) -> Dyadic {
        match self {
            Self::Double(t) => Dyadic::from(*t),
            Self::Long(t) => Dyadic::clone(t),
        }
    }

    /// The distance from an end of the segment, to the nearest double.
    pub(crate) fn away_from(&self, end: usize) -> f64 {
        match (self, end) {
            (Self::Double(t), 0) => *t,
            (Self::Double(t), _) => 1.0 - t,
            (Self::Long(t), 0) => t.to_f64(),
            (Self::Long(t), _) => (Dyadic::from(1) - &**t).to_f64(),
        }
    }

    /// The same exactly.
    pub(crate) fn exactly_away_from(&self, end: usize) -> Dyadic {
        if end == 0 { self.exact() } else { Dyadic::from(1) - self.exact() }
    }

    pub(crate) fn is_less(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Double(s), Self::Double(t)) => s < t,
            _ => self.exact() < other.exact(),
        }
    }
}
