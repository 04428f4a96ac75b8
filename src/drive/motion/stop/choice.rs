//! The ways to stop, and their words.

/// How a run is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopChoice {
    /// The gentlest way that the family has.
    Ramp,
    /// Quick stop.
    QuickStop,
    /// Disable voltage.
    Coast,
    /// Not at all.
    Keep,
}

impl StopChoice {
    /// The word that names it in catalogues and JSON.
    pub fn slug(self) -> &'static str {
        match self {
            StopChoice::Ramp => "ramp",
            StopChoice::QuickStop => "quick-stop",
            StopChoice::Coast => "coast",
            StopChoice::Keep => "keep",
        }
    }

    /// The choice that a word names.
    pub(in crate::drive::motion) fn of(slug: &str) -> Self {
        let all = [StopChoice::Ramp, StopChoice::QuickStop, StopChoice::Keep];
        all.into_iter().find(|choice| choice.slug() == slug).unwrap_or(StopChoice::Coast)
    }

    /// The same, made stronger so often, as far as that goes.
    pub(in crate::drive::motion) fn stronger_by(self, times: u32) -> StopChoice {
        (0..times).try_fold(self, |way, _| way.stronger().ok_or(way)).unwrap_or_else(|strongest| strongest)
    }

    /// What is left where this one does not do, or somebody cannot wait for it.
    pub(in crate::drive::motion) fn stronger(self) -> Option<StopChoice> {
        match self {
            StopChoice::Ramp => Some(StopChoice::QuickStop),
            StopChoice::QuickStop => Some(StopChoice::Coast),
            StopChoice::Coast | StopChoice::Keep => None,
        }
    }
}
