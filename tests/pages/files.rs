//! What lies in the folder of a page before its first command, and which bench stands for which port.

use crate::page;

/// What a page finds: files, and the bench of what names no port.
pub(crate) struct Around {
    pub(crate) files: Vec<(&'static str, String)>,
    pub(crate) bench: &'static str,
    pub(crate) ports: &'static [(&'static str, &'static str)],
}

/// Ports of the pages, and what stands for them.
const PORTS: &[(&str, &str)] = &[
    ("/dev/ttyUSB0", "sim:line.bench"),
    ("/dev/ttyUSB1", "sim:servo.bench"),
    ("slcan:/dev/ttyACM0", "sim:can.bench --protocol sdo"),
    ("slcan:tcp://192.168.1.50:3333", "sim:can.bench --protocol sdo"),
    ("can:can0", "sim:can.bench --protocol sdo"),
];

/// The bench of PROFIBUS is that of `sim` itself.
const PROFIBUS: &[(&str, &str)] = &[("/dev/ttyUSB0", "sim")];

/// Of these somebody only listens.
const HEARD: &[(&str, &str)] = &[("/dev/ttyUSB0", "tape:heard.txt")];

pub(crate) fn of(page: &str) -> Around {
    let mut files = vec![
        (
            "line.bench",
            line_of(&[
                (1, "act"),
                (2, "acu"),
                (3, "act"),
                (4, "act"),
                (5, "act"),
                (6, "act"),
                (7, "acu"),
                (8, "act"),
                (9, "act"),
            ]),
        ),
        ("servo.bench", example("servo.toml")),
        ("can.bench", CAN.to_owned()),
    ];
    let mut more = |name, text: &str| files.push((name, text.to_owned()));
    let (mut bench, mut ports) = ("sim:line.bench", PORTS);
    match page {
        "README.md" => {
            more("fresh.bench", "[[drive]]\nmodel = \"act\"\naddress = 1\nprotocol = \"vabus\"\ndata_bits = 7\n");
            more("factory.bench", "[[drive]]\nmodel = \"act\"\naddress = 1\n");
            more("mine.csv", MINE);
            more("pump.toml", BASE);
            more("project.toml", &on_bench(&first_toml(page)));
        }
        "docs/can.md" => {
            more("bus.txt", HEARD_CAN);
        }
        "docs/parameter-files.md" => {
            more("line.bench", &line_of(&[(1, "act"), (2, "act"), (3, "act"), (4, "act")]));
            more("base.toml", BASE);
            more("old.toml", &first_toml(page));
            more("new.toml", &first_toml(page).replace("1450", "1400"));
        }
        "docs/profibus.md" => {
            ports = PROFIBUS;
            more("HITA0BE7.GSD", GSD);
            more("heard.txt", HEARD_DP);
            more("tripped.bench", TRIPPED);
        }
        "docs/recording.md" => {
            more("docs/examples/record.csv", RECORD);
            more("antrieb.toml", &first_toml(page));
        }
        "docs/report.md" => {
            more("ramp.ndjson", RECORD);
            more("antrieb.toml", &first_toml(page));
            more("logo.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
        }
        "docs/sniffing.md" => {
            ports = HEARD;
            more("heard.txt", HEARD_RTU);
            more(
                "busy.bench",
                "[[drive]]\nmodel = \"act\"\n[[disturb]]\nkind = \"babble\"\npattern = \"master\"\nby = \"100ms\"\n",
            );
        }
        "docs/system-bus.md" => {
            bench = "sim:cubes.bench";
            more("cubes.bench", CUBES);
            more("pdo.bench", PDO);
            more("bus.toml", &example("system-bus-setpoint.toml"));
            more("antrieb.toml", "[drives.drive-1]\naddress = 1\n[drives.drive-2]\naddress = 2\n");
        }
        "docs/plant.md" => {
            more("plant.toml", &on_bench(&first_toml(page)));
            more("base.toml", BASE);
            more("pump.toml", BASE);
            more("fan.toml", OF_ACU);
        }
        _ => {}
    }
    Around { files, bench, ports }
}

/// The first file that a page shows.
fn first_toml(page: &str) -> String {
    let text = std::fs::read_to_string(page::root().join(page)).unwrap();
    text.split("```toml\n").nth(1).unwrap().split("```").next().unwrap().to_owned()
}

fn on_bench(file: &str) -> String {
    file.replace("/dev/ttyUSB0", "sim:line.bench")
}

fn example(name: &str) -> String {
    std::fs::read_to_string(page::root().join("docs/examples").join(name)).unwrap()
}

/// A bench of these drives, each to be led from the line, with fast ramps.
fn line_of(drives: &[(u8, &str)]) -> String {
    let of = |(address, model): &(u8, &str)| {
        format!(
            "[[drive]]\nmodel = \"{model}\"\naddress = {address}\nset = {{ \"412\" = 1, \"480@2\" = {address} }}\n\
             ramps = {{ up_right = 200, down_right = 200, up_left = 200, down_left = 200 }}\n"
        )
    };
    drives.iter().map(of).collect()
}

const RECORD: &str = include_str!("../../docs/examples/record.csv");

/// One node that somebody may look at alone.
const CAN: &str = "[[drive]]\nmodel = \"acu\"\naddress = 5\n";

/// A bus with its master.
pub(crate) const MASTER: &str = "[[drive]]\nmodel = \"acu\"\naddress = 0\n[[drive]]\nmodel = \"acu\"\naddress = 5\n";

/// Somebody else asks node 5 for P.411 and for one that it has not.
pub(crate) const ASKED: &str = "[[drive]]\nmodel = \"acu\"\naddress = 5\n\
    [[foreign]]\nframe = \"645#409B010000000000\"\nevery = \"2s\"\n\
    [[foreign]]\nframe = \"645#403F060000000000\"\nevery = \"3s\"\n";

/// What went to and from an adapter as node 5 was asked for the same.
const HEARD_CAN: &str = "# antrieb trace 1, CAN 500 kbit/s, sdo\n\
    1357000 > 4F 0D\n1358000 < 0D\n\
    1358000 > 74 36 34 35 38 34 30 39 42 30 31 30 30 30 30 30 30 30 30 30 30 0D\n1359000 < 7A 0D\n\
    1360540 < 74 35 43 35 38 34 32 39 42 30 31 30 30 33 33 30 30 30 30 30 30 0D\n1361000 > 43 0D\n";

/// The TxPDO of the plan of the manual's example.
const PDO: &str = "[[drive]]\nmodel = \"acu\"\naddress = 1\n\
    [[foreign]]\nframe = \"181#0F00000000000000\"\nevery = \"8ms\"\n";

/// Drives on a serial line that have the module of the system bus.
const CUBES: &str = "[[drive]]\nmodel = \"acu\"\naddress = 1\nmodules = [\"EM-RES-03\"]\n\
    [[drive]]\nmodel = \"acu\"\naddress = 2\nmodules = [\"EM-RES-03\"]\n\
    [[drive]]\nmodel = \"acu\"\naddress = 3\nmodules = [\"EM-RES-03\"]\n";

/// A master asks station 1 for P.372, and for what it has not.
const HEARD_RTU: &str = "# antrieb trace 1, 19200 8E1, rtu\n\
    23180 < 01 03 11 74 00 01 C1 2C\n38337 < 01 03 02 05 6E 3A F8\n\
    111515 < 01 03 06 3F 00 01 B4 8E\n126672 < 01 83 04 40 F3\n";

/// A master asks station 3 for its diagnosis, and exchanges data with it.
const HEARD_DP: &str = "# antrieb trace 1, 19200 8E1, dp\n\
    1250000 < 68 05 05 68 83 80 6D 3C 3E EA 16\n1258231 < 68 0B 0B 68 80 83 08 3E 3C 02 05 00 FF 0B E7 7D 16\n\
    1313079 < 68 0F 0F 68 03 00 7D 00 00 00 00 00 00 00 00 04 7E 00 00 02 16\n";

/// An inverter with a trip that waits for its reset.
const TRIPPED: &str = "[[module]]\ndrive = \"l200\"\naddress = 3\n[[module.event]]\nat = \"0s\"\ntrip = true\n";

/// What the bench says of itself: its ident number is made up, and no source tells what a true GSD has.
const GSD: &str = "#Profibus_DP\nModel_Name=\"bench\"\nIdent_Number=0x0BE7\nModule=\"PPO 1\" 0xF3,0xF1\n1\nEndModule\n";

/// The list of README.md, with its rows filled in.
const MINE: &str = "Nr.;Bezeichnung;Einheit;Typ;Nachkommastellen;Min;Max;Zugriff\n\
    P.370;Bemessungsspannung;V;uint;1;0;500;rw\nP.371;Bemessungsstrom;A;uint;1;0;100;rw\n\
    P.420;Hochlauf rechts;Hz/s;uint;2;0;9999;rw\nP.421;Runterlauf rechts;Hz/s;uint;2;0;9999;rw\n\
    P.422;Hochlauf links;Hz/s;uint;2;0;9999;rw\nP.423;Runterlauf links;Hz/s;uint;2;0;9999;rw\n";

/// Settings of an ACT that the bench has otherwise.
pub(crate) const BASE: &str =
    "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n372 = \"1450 1/min\"\n480 = \"12.5 Hz\"\n";

/// The same of an ACU.
pub(crate) const OF_ACU: &str = "antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n372 = \"1450 1/min\"\n";

/// What a load of `F002 = 7 s` would have left.
pub(crate) const UNDO: &str =
    "antrieb = 1\n[drive]\nfamily = \"l200\"\n[values]\n7 = \"10.00 s\"\n[undo]\nvalues = { 7 = \"7.00 s\" }\n";

/// A plant on one line.
pub(crate) const PLANT: &str = "[drives.pump]\naddress = 3\nfiles = [\"pump.toml\"]\n[groups]\npumps = [\"pump\"]\n";

/// Names for the drives whose settings were saved.
pub(crate) const NAMES: &str = "[drives.one]\naddress = 1\n[drives.two]\naddress = 2\n";
