//! Where the manual of the SJ2-PB leaves things open, and which way a module of this bench takes. The first word of a row is
//! the standard one: the strictest for a master where safety hangs on it, otherwise what is printed.

use crate::protocol::dp::cfg::Layout;
use crate::simulator::device::readings::{self, OpenQuestion, row};

/// A reading that differs from the standard bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    FedByTelegrams,
    SeriesIsPrmFault,
    UnconfiguredIsBasic,
    UnlockIsNoLoss,
    ClearIsLoss,
    WithoutControlRamps,
    WithoutControlIsLocal,
    RunsFromRest,
    RightStarts,
    ProfidriveOff,
    UnsignedSetpoint,
    AtRestIsReached,
    PkwEmpties,
    PkwRepeats,
    LockedIsError,
    ErrorInHighWord,
    SignedPwe,
    A004InTenths,
    A004InHundredths,
    RunIsCommand,
    ConnStaAlone,
    GatewayAlone,
    LimitsHold,
    BasicEndsLocal,
    TripIsSilent,
}

/// The readings of one module.
pub(crate) type Readings = readings::Readings<Reading>;

use Reading as R;

impl readings::Reading for Reading {
    #[rustfmt::skip]
    const QUESTIONS: &'static [OpenQuestion<Self>] = &[
        row("watchdog", &[("exchange", None), ("telegrams", Some(R::FedByTelegrams))]),
        // SJ2-PB manual 3.1
        row("wrong_series", &[("cfg-fault", None), ("prm-fault", Some(R::SeriesIsPrmFault))]),
        row("unconfigured", &[("ppo1", None), ("basic", Some(R::UnconfiguredIsBasic))]),
        // P.703, P.620: which end is a lost connection
        row("unlock", &[("loss", None), ("no-loss", Some(R::UnlockIsNoLoss))]),
        row("clear", &[("zeros", None), ("loss", Some(R::ClearIsLoss))]),
        // 4.1.2.1, 4.1.2.4: a word without bit 10 behind a run
        row("without_control", &[
            ("freeze", None), ("ramp", Some(R::WithoutControlRamps)), ("local", Some(R::WithoutControlIsLocal)),
        ]),
        // 4.1.2.2 against 4.1.2.4
        row("start", &[("edge", None), ("level", Some(R::RunsFromRest))]),
        // P.928
        row("right", &[("needs-edge", None), ("starts", Some(R::RightStarts))]),
        // 4.1.2.1
        row("off2_off3", &[("ramp-coast", None), ("coast-brake", Some(R::ProfidriveOff))]),
        // 4.1.2.3
        row("negative_setpoint", &[("reverse", None), ("zero", Some(R::UnsignedSetpoint))]),
        // 4.1.2.2
        row("reached_at_rest", &[("no", None), ("yes", Some(R::AtRestIsReached))]),
        // 4.1.1
        row("pkw_waits", &[("old", None), ("empty", Some(R::PkwEmpties))]),
        row("pkw_again", &[("once", None), ("every-cycle", Some(R::PkwRepeats))]),
        // P.927
        row("locked", &[("no-right", None), ("error-11", Some(R::LockedIsError))]),
        row("error_word", &[("low", None), ("high", Some(R::ErrorInHighWord))]),
        // 5.5 index 7
        row("negative_pwe", &[("word", None), ("extended", Some(R::SignedPwe))]),
        // 5.5 index 13-16
        row("a004", &[("1hz", None), ("0.1hz", Some(R::A004InTenths)), ("0.01hz", Some(R::A004InHundredths))]),
        // 3.2.3
        row("run_bits", &[("shaft", None), ("command", Some(R::RunIsCommand))]),
        // 3.2.2 against P.620: what keeps a motor running that loses its master in Basic mode
        row("basic_lost", &[
            ("either", None), ("conn-sta", Some(R::ConnStaAlone)), ("p620", Some(R::GatewayAlone)),
        ]),
        // 3.2.2, 6.2: a ramp of 0 or above 3000 s in the Basic block
        row("basic_ramps", &[("ignored", None), ("held", Some(R::LimitsHold))]),
        // 3.2.1, the note: A001 and A002 hold without a connection
        row("basic_end", &[("stops", None), ("local", Some(R::BasicEndsLocal))]),
        row("trip", &[("diagnosis", None), ("silent", Some(R::TripIsSilent))]),
    ];

    fn bit(self) -> u32 {
        self as u32
    }
}

/// What Get_Cfg tells before anything was configured.
pub(crate) fn unconfigured(readings: Readings) -> Layout {
    if readings.has(R::UnconfiguredIsBasic) { Layout::Basic } else { Layout::Ppo(1) }
}

/// Raw units of A003 and A004 in 1 Hz (5.5 index 13-16: no raw range is printed).
pub(crate) fn a004_scale(readings: Readings) -> i64 {
    match () {
        () if readings.has(R::A004InTenths) => 10,
        () if readings.has(R::A004InHundredths) => 100,
        () => 1,
    }
}
