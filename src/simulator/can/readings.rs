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
    IdentifiersAreChecked,
    SettingsHoldAtPowerOn,
    SettingsHoldAfterReset,
    RxCountsFromOff,
    ZeroTimeIsEveryMs,
    ZeroTimeIsSilent,
    TrueIsAllOnes,
    TrueIsBitZero,
    EarlierInputWins,
    SharedByteIsRefused,
    LongGivesHighWord,
    LongGivesNothing,
    EitherZeroIsUnused,
    ShortIsTaken,
    LeavingEmpties,
    SyncHandsOnFirst,
    WatchBeginsWithFirst,
    WatchedEverywhere,
    HandOverFeeds,
    SyncHasNoData,
    SyncBeginsWithBootUp,
    MasterObeys,
    ZeroTripsMaster,
    EndsWithMaster,
    TripsAgain,
    OthersTrip,
    StoppedIsMute,
    OffStaysShown,
    EmergencyComesFirst,
    MasterWaitsAgain,
    WarnsLate,
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
        // 5.8.2, 5.9.4, 5.11.1: identifiers from 129 to 191
        row("reserved_identifiers", &[("taken", None), ("abort-1", Some(R::IdentifiersAreChecked))]),
        // 5.4, 5.5 say nothing of 918 to 989 either
        row("settings", &[
            ("at-once", None), ("power-on", Some(R::SettingsHoldAtPowerOn)), ("reset-node", Some(R::SettingsHoldAfterReset)),
        ]),
        // 5.11.2 against 5.7.2
        row("rx_functions", &[("0-1", None), ("0-2", Some(R::RxCountsFromOff))]),
        // 5.11.2 against 7.2
        row("tx_time_0", &[
            ("abort-1", None), ("every-ms", Some(R::ZeroTimeIsEveryMs)), ("silent", Some(R::ZeroTimeIsSilent)),
        ]),
        // 5.11.5
        row("true", &[("0001", None), ("FFFF", Some(R::TrueIsAllOnes))]),
        row("is_true", &[("not-zero", None), ("bit-0", Some(R::TrueIsBitZero))]),
        row("shared_byte", &[
            ("later", None), ("earlier", Some(R::EarlierInputWins)), ("abort-1", Some(R::SharedByteIsRefused)),
        ]),
        row("word_of_long", &[("low", None), ("high", Some(R::LongGivesHighWord)), ("zero", Some(R::LongGivesNothing))]),
        row("other_zero", &[("a-source", None), ("unused", Some(R::EitherZeroIsUnused))]),
        row("short_pdo", &[("ignored", None), ("rest-zero", Some(R::ShortIsTaken))]),
        row("left_operational", &[("kept", None), ("zeroed", Some(R::LeavingEmpties))]),
        // 5.9.2
        row("at_sync", &[("sends-first", None), ("hands-on-first", Some(R::SyncHandsOnFirst))]),
        row("sync_with_data", &[("taken", None), ("ignored", Some(R::SyncHasNoData))]),
        // 5.11.3
        row("watch_begins", &[("operational", None), ("first-telegram", Some(R::WatchBeginsWithFirst))]),
        row("watched", &[("operational", None), ("always", Some(R::WatchedEverywhere))]),
        row("fed_by", &[("reception", None), ("hand-over", Some(R::HandOverFeeds))]),
        // 5.8.1, 5.8.2
        row("sync_begins", &[("start", None), ("boot-up", Some(R::SyncBeginsWithBootUp))]),
        row("foreign_nmt", &[("ignored", None), ("obeyed", Some(R::MasterObeys))]),
        // 5.8.3
        row("emergency_zero", &[("well", None), ("trips", Some(R::ZeroTripsMaster))]),
        row("emergency_ends", &[("slave", None), ("master", Some(R::EndsWithMaster))]),
        row("acknowledged_early", &[("stays-well", None), ("trips-again", Some(R::TripsAgain))]),
        row("emergency_above_63", &[("ignored", None), ("trips", Some(R::OthersTrip))]),
        // 5.9.3
        row("emergency_stopped", &[("sent", None), ("not", Some(R::StoppedIsMute))]),
        // 5.12
        row("after_bus_off", &[("okay", None), ("bus-off", Some(R::OffStaysShown))]),
        row("back_from_bus_off", &[("boot-up-first", None), ("emergency-first", Some(R::EmergencyComesFirst))]),
        row("can_warns", &[("96", None), ("128", Some(R::WarnsLate))]),
        row("master_bus_off", &[("goes-on", None), ("waits-again", Some(R::MasterWaitsAgain))]),
    ];

    fn bit(self) -> u32 {
        self as u32
    }
}
