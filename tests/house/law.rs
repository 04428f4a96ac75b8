//! The law itself. Paths are those of modules; a path holds for everything below it.

/// Room or part of one, and what it may name outside itself. The longest path that fits a file is its row.
pub(crate) const LAW: &[(&str, &[&str])] = &[
    ("tick", &["text"]),
    ("text", &[]),
    ("failure", &["text"]),
    ("files", &["text"]),
    ("gate", &["text"]),
    ("outcome", &["failure", "text"]),
    ("profile", &["text"]),
    ("scope", &["text"]),
    ("protocol", &["text", "tick"]),
    ("exchange", &["protocol", "tick"]),
    ("simulator", &["protocol", "profile", "text", "tick"]),
    ("simulator::line", &["simulator::dice", "protocol", "tick"]),
    ("simulator::device", &["simulator::line::speech", "protocol", "profile", "tick"]),
    (
        "simulator::station",
        &[
            "simulator::device::contract",
            "simulator::device::counters",
            "simulator::line",
            "simulator::dice",
            "protocol",
            "tick",
        ],
    ),
    ("simulator::station::modbus", &["simulator::line", "protocol", "tick"]),
    ("simulator::station::vabus", &["simulator::line", "protocol", "tick"]),
    ("simulator::judge", &["simulator::line::speech", "protocol", "tick"]),
    (
        "simulator::bench",
        &["simulator::judge", "simulator::line", "simulator::station", "simulator::totals", "protocol", "tick"],
    ),
    ("transport", &["simulator", "files", "text", "protocol::line", "protocol::Hex", "tick"]),
    (
        "drive",
        &[
            "exchange",
            "transport",
            "profile",
            "gate",
            "failure",
            "files",
            "outcome",
            "text",
            "tick",
            "simulator",
            "protocol",
        ],
    ),
    ("render", &["outcome", "failure", "gate", "profile", "text"]),
    (
        "args",
        &[
            "transport",
            "profile",
            "render",
            "failure",
            "files",
            "text",
            "tick",
            "protocol::line",
            "protocol::modbus",
            "protocol::Protocol",
        ],
    ),
    ("command", &["args", "drive", "profile", "scope", "gate", "outcome", "failure", "files", "text", "tick"]),
    ("cli", &["args", "command", "drive", "profile", "render", "outcome", "failure", "files", "text", "tick"]),
];

/// Files of `drive` that may name `protocol` and `simulator`; the rest of the room speaks of parameters.
pub(crate) const TELEGRAMS: &[(&str, &[&str])] = &[
    (
        "protocol",
        &[
            "drive",
            "drive::account",
            "drive::decode",
            "drive::decode::can",
            "drive::decode::can::names",
            "drive::decode::can::recording",
            "drive::decode::can::sdo",
            "drive::decode::modbus",
            "drive::decode::registers",
            "drive::decode::services",
            "drive::decode::vabus",
            "drive::decode::wrong",
            "drive::diag",
            "drive::opening",
            "drive::probe",
            "drive::recognise",
            "drive::recognise::active",
            "drive::recognise::description",
            "drive::relocate",
            "drive::relocate::journey",
            "drive::relocate::plot",
            "drive::route",
            "drive::scan",
            "drive::scan::order",
            "drive::scan::search",
            "drive::session",
            "drive::target",
            "drive::terms",
            "drive::transfer",
            "drive::trouble",
            "drive::upper",
            "drive::trouble::port",
            "drive::write",
        ],
    ),
    ("simulator", &["drive::bench", "drive::session"]),
];

/// Rooms whose parts do not name each other, but for some that all of them may name.
pub(crate) const SIBLINGS: &[(&str, &[&str])] = &[(
    "simulator::device",
    &[
        "simulator::device::cia402",
        "simulator::device::contract",
        "simulator::device::counters",
        "simulator::device::motor",
        "simulator::device::readings",
        "simulator::device::shaft",
    ],
)];

/// Rooms in which not even a module and what lies inside it name each other.
pub(crate) const STRICT: &[&str] = &["profile", "simulator"];
