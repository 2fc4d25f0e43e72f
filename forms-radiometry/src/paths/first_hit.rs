//! First hits of rays.

/// First hits of one or several rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FirstHit {
    /// Whether any first hit emits light.
    pub(crate) is_emitter: bool,
    /// The surface that all rays hit, or `None` if all rays miss; an error if the rays differ.
    pub(crate) surface: Result<Option<usize>, Several>,
}

/// Rays that hit several surfaces, or that partly hit and partly miss.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Several;

impl FirstHit {
    /// First hits of rays that all miss.
    pub(crate) const NOTHING: Self = Self { is_emitter: false, surface: Ok(None) };

    /// Combines the first hits of two sets of rays.
    pub(super) fn with(self, other: Self) -> Self {
        let surface = if self.surface == other.surface { self.surface } else { Err(Several) };
        Self { is_emitter: self.is_emitter || other.is_emitter, surface }
    }
}
