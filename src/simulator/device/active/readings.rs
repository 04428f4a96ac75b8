//! What the manuals of ACT and ACU leave open.

use crate::simulator::device::readings::{self, OpenQuestion, row};

/// A reading that differs from the standard bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    ControlByEdge,
    ReadsInForce,
    RamNotShown,
    UnknownIsException2,
    SetAsAsked,
    LineReplyLost,
    LineReplyNew,
    ResetNeedsRemote,
    CoastShowsShaft,
    OtherModesAreContacts,
    SilentAfterNak,
    SilentOnWrongCheck,
    LinkedWordIsBeside,
}

/// The readings of one drive.
pub(crate) type Readings = readings::Readings<Reading>;

use Reading as R;

impl readings::Reading for Reading {
    /// All of them: docs/open-points.md.
    #[rustfmt::skip]
    const QUESTIONS: &'static [OpenQuestion<Self>] = &[
        // CM-485 manual 9.1.2, 10.2
        row("control_word", &[("level", None), ("edge", Some(R::ControlByEdge))]),
        // CM-485 manual 7
        row("ram_reads", &[("eeprom", None), ("in-force", Some(R::ReadsInForce)), ("refused", Some(R::RamNotShown))]),
        // CM-485 manual 6.4 against 8.1.3
        row("unknown_parameter", &[("4", None), ("2", Some(R::UnknownIsException2))]),
        row("set_character", &[("folded", None), ("as-asked", Some(R::SetAsAsked))]),
        // CM-485 manual 5.2.1
        row("line_reply", &[("old", None), ("lost", Some(R::LineReplyLost)), ("new", Some(R::LineReplyNew))]),
        // CM-485 manual 9.1
        row("reset", &[("free", None), ("needs-remote", Some(R::ResetNeedsRemote))]),
        // CM-485 manual 9.2.1: what the frequency of the stator (P.210) is while the shaft coasts
        row("coast_shows", &[("nothing", None), ("shaft", Some(R::CoastShowsShaft))]),
        // CM-485 manual 9: "keypad and digital signals"
        row("other_modes", &[("keypad", None), ("contacts", Some(R::OtherModesAreContacts))]),
        row("after_nak", &[("nak", None), ("silence", Some(R::SilentAfterNak))]),
        row("wrong_bcc", &[("nak", None), ("silence", Some(R::SilentOnWrongCheck))]),
        // EM-RES-03 manual 5.11.5.3: what P.410 is where P.99 takes the control word from the system bus
        row("linked_word", &[("alone", None), ("beside", Some(R::LinkedWordIsBeside))]),
    ];

    fn bit(self) -> u32 {
        self as u32
    }
}
