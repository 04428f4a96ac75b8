//! What a transaction does at the moment, told on the way.

use crate::outcome::Event;
use crate::profile::Param;
use crate::text::both;

/// What is done with a value.
#[derive(Clone, Copy)]
pub(super) enum Doing {
    Reads,
    Writes,
    Proves,
    PutsBack,
}

/// What is done now, behind `done` of `total` values.
pub(super) fn progress(doing: Doing, done: usize, total: usize, param: &Param) -> Event {
    let label = param.label();
    let what = match doing {
        Doing::Reads => both!("reading {label}", "{label} wird gelesen", label),
        Doing::Writes => both!("writing {label}", "{label} wird geschrieben", label),
        Doing::Proves => both!("proving {label}", "{label} wird geprüft", label),
        Doing::PutsBack => both!("putting back {label}", "{label} wird zurückgenommen", label),
    };
    Event::Progress { done: done as u64, total: total as u64, what }
}
