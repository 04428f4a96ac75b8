//! The law itself. Paths are those of modules; a path holds for everything below it.

/// Room or part of one, and what it may name outside itself. The longest path that fits a file is its row.
pub(crate) const LAW: &[(&str, &[&str])] = &[
    ("tick", &[]),
    ("failure", &[]),
    ("files", &[]),
    ("gate", &[]),
    ("outcome", &["failure"]),
    ("profile", &[]),
    ("protocol", &["tick"]),
    ("exchange", &["protocol", "tick"]),
    ("simulator", &["protocol", "profile", "tick"]),
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
    ("transport", &["simulator", "files", "protocol::line", "protocol::Hex", "tick"]),
    (
        "drive",
        &["exchange", "transport", "profile", "gate", "failure", "files", "outcome", "tick", "simulator", "protocol"],
    ),
    ("render", &["outcome", "failure", "gate", "profile"]),
    (
        "args",
        &[
            "transport",
            "profile",
            "render",
            "failure",
            "files",
            "tick",
            "protocol::line",
            "protocol::modbus",
            "protocol::Protocol",
        ],
    ),
    ("command", &["args", "drive", "profile", "gate", "outcome", "failure", "files", "tick"]),
    ("cli", &["args", "command", "drive", "profile", "render", "outcome", "failure"]),
];

/// Files of `drive` that may name `protocol` and `simulator`; the rest of the room speaks of parameters.
pub(crate) const TELEGRAMS: &[(&str, &[&str])] = &[
    (
        "protocol",
        &[
            "drive",
            "drive::decode",
            "drive::decode::modbus",
            "drive::decode::registers",
            "drive::decode::services",
            "drive::decode::vabus",
            "drive::diag",
            "drive::family",
            "drive::opening",
            "drive::relocate",
            "drive::relocate::journey",
            "drive::relocate::plot",
            "drive::route",
            "drive::scan",
            "drive::scan::order",
            "drive::session",
            "drive::sniff",
            "drive::terms",
            "drive::transfer",
            "drive::trouble",
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

/// Arrows that close a circle of files, and are still to go: from, to. The list only becomes shorter.
pub(crate) const CIRCLES: &[(&str, &str)] = &[
    ("args::address", "args::low"),
    ("drive::session", "drive::family"),
    ("drive::session", "drive::trouble"),
    ("exchange::job", "exchange::master"),
    ("render::console", "render::ask"),
];
