//! Where the manual of the system bus leaves things open, and which way the drives of this bus take. The first word of a row is the
//! standard one: what is printed.

use crate::simulator::device::readings::{self, OpenQuestion, row};

/// A reading that differs from the standard bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    SignIsExtended,
    TailIsRefused,
    SegmentsAreWrongType,
    SegmentsAreSilent,
    NoRam,
    SetsAreTaken,
    PlaceHoldsAtOnce,
    PlaceHoldsAfterReset,
    OwnParametersUnknown,
    MasterBootsUp,
    MasterServesSdo1,
}

/// The readings of a bus.
pub(crate) type Readings = readings::Readings<Reading>;

use Reading as R;

impl readings::Reading for Reading {
    #[rustfmt::skip]
    const QUESTIONS: &'static [OpenQuestion<Self>] = &[
        // EM-RES-03 manual 5.10.1
        row("below_zero", &[("zeros", None), ("extended", Some(R::SignIsExtended))]),
        row("word_tail", &[("ignored", None), ("abort-1", Some(R::TailIsRefused))]),
        row("segments", &[
            ("abort-15", None), ("abort-10", Some(R::SegmentsAreWrongType)), ("silence", Some(R::SegmentsAreSilent)),
        ]),
        row("ram_sets", &[("ram", None), ("abort-2", Some(R::NoRam))]),
        row("set_of_none", &[("abort-2", None), ("taken", Some(R::SetsAreTaken))]),
        // 5.4, 5.5
        row("place", &[
            ("power-on", None), ("at-once", Some(R::PlaceHoldsAtOnce)), ("reset-node", Some(R::PlaceHoldsAfterReset)),
        ]),
        // 5.13
        row("own_parameters", &[("there", None), ("abort-11", Some(R::OwnParametersUnknown))]),
        // 5.8.3, 5.9.1.1
        row("master_boots_up", &[("no", None), ("yes", Some(R::MasterBootsUp))]),
        // 5.7.1, 5.9.4
        row("master_sdo1", &[("none", None), ("served", Some(R::MasterServesSdo1))]),
    ];

    fn bit(self) -> u32 {
        self as u32
    }
}
