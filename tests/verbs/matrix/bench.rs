//! What the matrix plays on: a bench, files beside it, a recording.

/// An ACU with a fault and a warning, an ACT whose data sets differ, and a device that is no drive.
pub(super) const BENCH: &str = "\
[[drive]]
model = \"act\"
address = 1
set = { \"372@2\" = 1450, \"480@3\" = -12.5 }
[[drive]]
model = \"acu\"
address = 2
modules = [\"EM-RES-03\"]
set = { \"412\" = 1, \"210\" = 12.49, \"228\" = 12.5 }
[[drive.event]]
at = \"0s\"
fault = \"F0500\"
warning = 0x0020
[[drive]]
model = \"foreign\"
address = 9
registers = { \"0\" = 17 }
";

/// An L200 behind an SJ2-PB, and an X200 that was configured for nothing yet.
pub(super) const MODULES: &str = "\
[[module]]
drive = \"l200\"
address = 3
[[module]]
drive = \"x200\"
address = 12
readings = { unconfigured = \"basic\" }
";

/// Parameter files, and what takes one back.
pub(super) const FILES: &[(&str, &str)] = &[
    (
        "base.toml",
        "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n30 = 210\n372 = 1440\n\"392@1\" = 2\n10 = 3\n210 = 5\n410 = 7\n",
    ),
    ("record.csv", include_str!("../../../docs/examples/record.csv")),
    ("bus.toml", include_str!("../../../docs/examples/system-bus-setpoint.toml")),
    ("relations.toml", include_str!("../../../docs/examples/system-bus-relations.toml")),
    (
        "broken.toml",
        "[bus]\nrate = 50\n[drives.d1]\nnode = 1\n[[pdo]]\nfrom = \"d1\"\nnumber = 1\nidentifier = 130\nevery = 2\n\
         put = { word4 = 740, long2 = 62 }\n[[pdo.to]]\ndrive = \"d1\"\nnumber = 1\ntimeout = 1\ntake = { word3 = 99 }\n",
    ),
    ("pump.toml", "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"372@2\" = 1450\n\"480@1\" = \"20 Hz\"\n"),
    ("same.toml", "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"372@2\" = 1450\n"),
    ("wild.toml", "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n418 = \"1200 Hz\"\n372 = 1440\n"),
    ("refused.toml", "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n372 = 1440\n376 = 0\n"),
    (
        "undo.toml",
        "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"372@2\" = 1400\n[undo]\nvalues = { \"372@2\" = 1450 }\n",
    ),
    (
        "stale.toml",
        "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"372@2\" = 1400\n480 = 7\n[undo]\nvalues = { \"372@2\" = 1460, 480 = 5, \"480@3\" = -12.5 }\n",
    ),
    ("fan.toml", "antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n\"480@1\" = \"20 Hz\"\n"),
    (
        "plant.toml",
        "[drives.pump-1]\naddress = 1\nfiles = [\"base.toml\", \"pump.toml\"]\n[drives.fan-2]\naddress = 2\nfiles = [\"fan.toml\"]\n\
         [drives.ghost-7]\naddress = 7\nfiles = [\"same.toml\"]\n[drives.stranger-9]\naddress = 9\nfiles = [\"same.toml\"]\n\
         [drives.bare-8]\naddress = 8\n[groups]\nline = [\"pump-1\", \"fan-2\"]\n",
    ),
    ("same-plant.toml", "[drives.pump-1]\naddress = 1\nfiles = [\"same.toml\"]\n"),
    ("wild-plant.toml", "[drives.pump-1]\naddress = 1\nfiles = [\"wild.toml\"]\n"),
    (
        "torn-plant.toml",
        "[drives.fan-2]\naddress = 2\nfiles = [\"fan.toml\"]\n[drives.pump-1]\naddress = 1\nfiles = [\"refused.toml\"]\n",
    ),
];
/// What the first of them was to hold.
pub(super) const HELD: &str = "\
antrieb = 1
drive.family = \"act\"
[values]
372 = \"1390 1/min\"
395 = \"Modbus RTU\"
400 = 4
417 = \"raw 0\"
480 = \"5 Hz\"
";

/// What was heard while somebody else asked.
pub(super) const TAPE: &str = "# antrieb trace 1, 19200 8E1, rtu
1000 < 01 03 21 74 00 01 CE 2C 01 03 02 05 6E 3A F8
30000 < 03 06 41 78 00 0F 5C 09
36000 < 03 06 41 78 00 0F 5C 09
60000 < 01 83 02 C0 F1
";
