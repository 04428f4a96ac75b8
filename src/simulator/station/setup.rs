//! Everything that makes a station before it is switched on, but for the device behind it.

use super::script::Event;
use crate::simulator::device::contract::NodeSetting;
use crate::tick::Span;

/// Earliest reply (CM-485 manual 6.8).
pub(crate) const REPLY_DELAY: Span = Span::from_millis(10);

/// Everything that makes a station.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    pub(crate) place: NodeSetting,
    pub(crate) delay: Span,
    pub(crate) jitter: Span,
    pub(crate) strict_silence: bool,
    pub(crate) script: Vec<Event>,
    pub(crate) seed: u64,
}

impl Setup {
    /// A station with nothing special about it.
    pub(crate) fn plain(place: NodeSetting) -> Self {
        Setup {
            place,
            delay: REPLY_DELAY,
            jitter: Span::ZERO,
            strict_silence: false,
            script: Vec::new(),
            seed: place.address.into(),
        }
    }
}
