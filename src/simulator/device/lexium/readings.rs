//! What the manual of the LXM05 leaves open.

use crate::simulator::device::readings::{self, OpenQuestion, row};

/// A reading that differs from the standard bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    ModeChangeRefused,
    ReferencesOutliveRun,
    ReferencesOutliveMode,
    SetpointsEndWithRun,
    SetpointsEndWithMode,
    Control7Brakes,
    Control7Refused,
    GuardQuickStop,
    QuickStopStays,
    GuardFedByWrites,
    ExchangeReadsFirst,
    WritesOneByOne,
    AddressAtOnce,
    BaudAtOnce,
    WordOrderAtOnce,
    FaultMemoryMovesOn,
    Exception1,
    Exception2,
    Exception3,
    Exception4,
    SaveByCommand,
}

/// The readings of one drive.
pub(crate) type Readings = readings::Readings<Reading>;

use Reading as R;

impl readings::Reading for Reading {
    /// All of them: docs/open-points.md.
    #[rustfmt::skip]
    const QUESTIONS: &'static [OpenQuestion<Self>] = &[
        // LXM05 manual 6.3.1: a command that a running movement forbids
        row("mode_change", &[("accepted", None), ("refused", Some(R::ModeChangeRefused))]),
        row("references_after_run", &[("zeroed", None), ("kept", Some(R::ReferencesOutliveRun))]),
        row("references_after_mode", &[("zeroed", None), ("kept", Some(R::ReferencesOutliveMode))]),
        row("setpoints_after_run", &[("kept", None), ("zeroed", Some(R::SetpointsEndWithRun))]),
        row("setpoints_after_mode", &[("kept", None), ("zeroed", Some(R::SetpointsEndWithMode))]),
        row("control_7", &[("coasts", None), ("brakes", Some(R::Control7Brakes)), ("refused", Some(R::Control7Refused))]),
        // LXM05 manual 5.6
        row("node_guard", &[("fault", None), ("quick-stop", Some(R::GuardQuickStop))]),
        row("node_guard_fed_by", &[("all", None), ("writes", Some(R::GuardFedByWrites))]),
        row("quick_stop", &[("ends", None), ("stays", Some(R::QuickStopStays))]),
        row("code_23", &[("writes-first", None), ("reads-first", Some(R::ExchangeReadsFirst))]),
        row("code_16", &[("whole", None), ("one-by-one", Some(R::WritesOneByOne))]),
        // LXM05 manual 4.1
        row("mbadr", &[("power-on", None), ("at-once", Some(R::AddressAtOnce))]),
        row("mbbaud", &[("power-on", None), ("at-once", Some(R::BaudAtOnce))]),
        row("mbdword_order", &[("power-on", None), ("at-once", Some(R::WordOrderAtOnce))]),
        row("flt_err_num", &[("stays", None), ("moves-on", Some(R::FaultMemoryMovesOn))]),
        // LXM05 manual 6.2
        row("exceptions", &[("by-cause", None), ("1", Some(R::Exception1)), ("2", Some(R::Exception2)),
            ("3", Some(R::Exception3)), ("4", Some(R::Exception4))]),
        row("persistence", &[("at-once", None), ("by-command", Some(R::SaveByCommand))]),
    ];

    fn bit(self) -> u32 {
        self as u32
    }
}
