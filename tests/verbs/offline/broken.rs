//! Every kind of file that a user writes, broken in every way that its reader knows: told in both languages, with the place.

use crate::german;
use crate::run::antrieb;

/// The file, and the command line that reads it.
const READERS: &[(&str, &str, &str)] = &[
    ("catalogue", "x.toml", "--catalogue x.toml params 372"),
    ("bench", "x.toml", "-p sim:x.toml -a 1 read 411"),
    ("project", "antrieb.toml", "params 372"),
    ("values", "x.toml", "dataset diff x.toml factory"),
    ("bus", "x.toml", "systembus plan x.toml"),
];

/// What every file begins with, so that the rest is what is wrong with it.
const CATALOGUE: &str = "schema = 1\nfamily = \"active\"\n";
const DRIVE: &str = "[[drive]]\nmodel = \"act\"\n";
const SERVO: &str = "[[drive]]\nmodel = \"lxm05\"\n";
const VALUES: &str = "antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n";

/// What is wrong with how this is told: it ends with 7, names its place, says the same in both languages but for their words,
/// and quotes nothing that could be said.
fn amiss(kind: &str, text: &str) -> Option<String> {
    let (_, name, line) = READERS.iter().find(|row| row.0 == kind).unwrap();
    let [english, german] = ["en", "de"].map(|lang| antrieb(&format!("--lang {lang} {line}")).file(name, text).run());
    let why = english.err.lines().next().unwrap_or_default().rsplit(": ").next().unwrap_or_default();
    let same = german::alike(&english.err, &german.err);
    let is_well = [
        (english.exit, german.exit) == (7, 7),
        english.err.contains(".toml:") && german.err.contains(".toml:"),
        same.is_empty(),
        !german.err.contains(&format!("\"{why}\"")),
    ];
    (is_well != [true; 4]).then(|| format!("{text}: {is_well:?} {same:?}\n{}{}", english.err, german.err))
}

#[track_caller]
fn told(kind: &str, texts: &[String]) {
    let amiss: Vec<String> = texts.iter().filter_map(|text| amiss(kind, text)).collect();
    assert!(amiss.is_empty(), "{}", amiss.join("\n"));
}

/// Each of these behind what the file begins with.
#[track_caller]
fn all(kind: &str, head: &str, rests: &[&str]) {
    told(kind, &rests.iter().map(|rest| format!("{head}{rest}\n")).collect::<Vec<_>>());
}

#[test]
fn a_broken_catalogue_is_told_in_both_languages() {
    let rows = [
        "colour = 1",
        "schema = 2",
        "[link]",
        "[fault_codes]\nx = 1",
        "[roles]\nstatus-wrod = 411",
        "[roles]\nstatus-word = 4711",
        "[groups]\nmine = [4711]",
        "[enums.mine]\nx = { en = \"x\", de = \"x\" }",
        "[enums.modbus-parity]\n0 = { en = \"x\", de = \"x\" }",
        "[bits.mine]\n0 = { slug = \"x\", en = \"\\u001b\", de = \"x\" }",
        "[synonyms]\na = 1",
        "transitions = [{ number = 99, from = \"x\", to = \"y\", command = \"fly\" }]",
        "faults = [{ code = 0x0500, key = \"F0500\", en = \"x\", de = \"x\", cause = { en = \"x\", de = \"x\" }, remedy = { en = \"x\", de = \"x\" } }]",
        "faults = [{ code = 0x7FFF, last = 1, key = \"F7FFF\", en = \"x\", de = \"x\", cause = { en = \"x\", de = \"x\" }, remedy = { en = \"x\", de = \"x\" } }]",
        "states = [1]",
        "params = 1",
        "params = [",
    ];
    all("catalogue", CATALOGUE, &rows);
    let keys = [
        "id = \"x\"",
        "id = -1",
        "id = 1500",
        "id = 1500, de = \"x\", en = \"x\"",
        "id = 1500, de = \"x\", en = \"x\", access = \"x\"",
        "id = 1500, de = \"x\", en = \"x\", access = 1",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", type = \"nibble\"",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", min = true",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", hex = 1",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", drives = \"act\"",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", drives = [\"toaster\"]",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", min = 2, max = 1",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", min = \"x\"",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", decimals = 40",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", decimals = 1, min = 0.25",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", type = \"float\", min = 1",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", enum = \"no\"",
        "id = 1500, de = \"x\", en = \"x\", access = \"r\", bits = \"no\"",
        "id = 372, de = \"x\", en = \"x\", access = \"r\"",
        "id = 1500, slug = \"rated-speed\", de = \"x\", en = \"x\", access = \"r\"",
        "id = 484, slug = \"frequency-setpoint\", de = \"x\", en = \"x\", access = \"rw\", replace = true",
    ];
    told("catalogue", &keys.map(|keys| format!("{CATALOGUE}params = [\n  {{ {keys} }},\n]\n")));
    let long = "x".repeat(3_000);
    let row = |id: u32, name: &str| format!("{{ id = {id}, de = \"x\", en = \"{name}\", access = \"r\" }},");
    let twice = format!("{}{}", row(1500, "a"), row(1500, "b"));
    told("catalogue", &[row(1500, &long), twice].map(|rows| format!("{CATALOGUE}params = [{rows}]")));
    let own = "schema = 1\nfamily = \"own\"\n";
    let link = "drives = [{ id = \"own\", en = \"x\", de = \"x\" }]\n[link]\nprotocols = [\"rtu\"]\n";
    let texts = [
        own.to_owned(),
        "schema = 1\nfamily = \"x".to_owned(),
        format!("{own}{link}route = \"plane\"\n"),
        "#".repeat((4 << 20) + 1),
    ];
    told("catalogue", &texts);
}

#[test]
fn a_broken_bench_is_told_in_both_languages() {
    all(
        "bench",
        "",
        &[
            "",
            "[[drive]]",
            "[[drive]]\nmodel = \"vfd\"",
            "[line]\nseed = \"x\"\n[[drive]]\nmodel = \"act\"",
            "drive = 1",
            "x =",
        ],
    );
    all(
        "bench",
        DRIVE,
        &[
            "address = 248",
            "address = \"1\"",
            "address = 31\nprotocol = \"vabus\"",
            "parity = \"mark\"",
            "baud = 5",
            "data_bits = 7",
            "stop_bits = 1",
            "colour = 1",
            "enable = 1",
            "set = { \"372@5\" = 1 }",
            "set = { \"1\" = 1 }",
            "set = { \"411@2\" = 1 }",
            "set = { \"376\" = \"1.55\" }",
            "set = { \"376\" = [1] }",
            "set = { \"376\" = \"0xG\" }",
            "set = { \"372\" = 99999999 }",
            "set = { \"12\" = 1 }",
            "eeprom = { \"480@2ram\" = \"refuses\" }",
            "eeprom = { \"480@2\" = \"burns\" }",
            "modules = [\"X\"]",
            "reply_delay = \"10\"",
            "readings = { weather = \"fine\" }",
            "registers = { 1 = 1 }",
            "busy = true",
            "nodes = [{ id = 99, model = \"act\" }]",
            "nodes = [{ id = 2, model = \"act\" }, { id = 2, model = \"act\" }]",
            "nodes = [{ id = 2, model = \"lxm05\" }]",
            "torque = 1001",
            "stoa = false",
            "ramps = { up_right = 0 }",
            "ramps = { up_right = 1.234 }",
            "ramps = { up_right = true }",
            "[[drive.event]]\nat = \"1s\"",
            "[[drive.event]]\nfault = \"F0500\"",
            "[[drive.event]]\nat = \"1s\"\nfault = \"500\"",
            "[[drive.event]]\nat = \"1s\"\nclass = 1\nfault = \"F0500\"",
            "[[drive.event]]\nat = \"1s\"\nfault = \"F0500\"\nfor = \"1s\"",
            "[[drive.event]]\nat = \"1s\"\nstob = false",
            "[[drive.event]]\nwhen = \"standing\"\nmains = false",
            "[[drive.event]]\nafter_writes = 0\nmains = false",
            "[[disturb]]\nkind = \"lost\"",
            "[[disturb]]\nevery = 1\nkind = \"rain\"",
            "[[disturb]]\nevery = 1\nkind = \"lost\"\nby = \"1s\"",
            "[[disturb]]\nevery = 1\nkind = \"lost\"\nbyte = 1",
            "[[disturb]]\nevery = 1\nkind = \"lost\"\nbyte = 256",
            "[[disturb]]\nevery = 1\nkind = \"twin\"\nfor = \"1s\"",
            "[[disturb]]\nkind = \"babble\"\nevery = 3",
            "[[disturb]]\nkind = \"babble\"\npattern = \"5\"",
        ],
    );
    all(
        "bench",
        "[[drive]]\nmodel = \"foreign\"\n",
        &["registers = { 70000 = 1 }", "nodes = [{ id = 2, model = \"act\" }]"],
    );
    all(
        "bench",
        SERVO,
        &[
            "torque = 3",
            "protocol = \"ascii\"",
            "baud = 5",
            "stop_bits = 2",
            "servo = { vendor = \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\" }",
            "servo = { revision_object = 4 }",
            "servo = { bit6 = \"x\" }",
            "set = { nothing = 1 }",
            "set = { _p_act = 1 }",
            "set = { rampacc = \"0xG\" }",
            "set = { rampacc = 0 }",
            "[[drive.event]]\nat = \"1s\"\nwarning = 1",
            "[[drive.event]]\nat = \"1s\"\nfault = \"F2300\"",
            "[[drive.event]]\nat = \"1s\"\nfault = \"E2300\"\nclass = 5",
        ],
    );
    told("bench", &["#".repeat((1 << 20) + 1)]);
}

#[test]
fn a_broken_project_is_told_in_both_languages() {
    all(
        "project",
        "",
        &[
            "colour = 1",
            "port = 1",
            "address = 1",
            "address = \"300\"",
            "baud = \"fast\"",
            "baud = -1",
            "retries = 300",
            "catalogue = \"x.toml\"",
            "catalogue = [1]",
            "port = ",
            "port = \"x",
            "= 1",
            "port = \"a\"\nport = \"b\"",
            "[ports.l1]",
            "[drives.p1]",
            "[drives.p1]\naddress = \"1\"",
            "[drives.p1]\naddress = 0",
            "[drives.p1]\naddress = 999",
            "[drives.p1]\naddress = 1.5",
            "[drives.17]\naddress = 1",
            "[drives.all]\naddress = 1",
            "[drives.p1]\naddress = 1\nfiles = \"x.toml\"",
            "[drives.p1]\naddress = 1\nfile = \"x.toml\"",
            "[drives.p1]\naddress = 1\n[drives.f2]\naddress = 1",
            "[ports.l1]\npath = \"/dev/x\"\n[drives.p1]\naddress = 1\nport = \"r2\"",
            "[drives.p1]\naddress = 1\n[groups]\ng1 = []",
            "[drives.p1]\naddress = 1\n[groups]\ng1 = [\"f2\"]",
            "[drives]\np1 = 1",
            "[triggers.trip]",
            "[triggers.trip]\nwhen = 1",
        ],
    );
    let typed = antrieb("params 372").file("antrieb.toml", "[drives.p1]\naddress = \"1\"\n").exits(7).err;
    assert!(typed.contains("antrieb.toml:2:11: expected a whole number, got the text \"1\""), "{typed}");
}

#[test]
fn a_broken_parameter_file_is_told_in_both_languages() {
    all(
        "values",
        "",
        &[
            "",
            "antrieb = 0",
            "antrieb = 2",
            "antrieb = 1\n[values]",
            "antrieb = 1\n[drive]\nfamily = \"acu\"",
            "antrieb = 1\ndrive = 1",
        ],
    );
    all(
        "values",
        VALUES,
        &[
            "372 = ",
            "372 = 1\n372 = 2",
            "372 = true",
            "372 = 1\n\"rated-speed\" = 2",
            "rated-sped = 2",
            "\"372@2ram\" = 2",
            "\"480-482\" = 2",
            "\"372@7x\" = 2",
            "4097 = 2",
            "\"480@2\" = \"5 A\"",
            "480 = \"fast\"",
            "480 = 5.123",
            "417 = \"5 Hz\"",
            "395 = 70000",
            "480 = \"a\\u0007\"",
            "[saved]\nwhen = 1",
            "[saved]\ncomplete = 1",
            "[saved]\nsignature = \"12\"",
            "[not-held]\nrefused = \"all\"",
            "[not-held]\nlazy = \"1\"",
            "[types]\n417 = \"string\"",
            "[types]\n417 = \"nibble\"",
            "[undo]",
            "[undo]\nmemory = \"paper\"\n[undo.values]",
        ],
    );
    all("values", "antrieb = 1\n[drive]\nfamily = \"lxm05\"\n[values]\n", &["\"5640@2\" = 1"]);
}

#[test]
fn a_broken_plan_of_a_bus_is_told_in_both_languages() {
    all(
        "bus",
        "",
        &["", "bus = 1", "[bus]", "[bus]\nrate = \"x\"", "[bus]\nrate = 7", "[bus]\nrate = 250\ncolour = 1", "x ="],
    );
}
