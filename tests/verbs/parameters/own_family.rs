//! A family that only a catalogue of the user describes: read and written over plain Modbus, and never moved.

use crate::run::{Run, antrieb};
use serde_json::json;

const PUMPS: &str = r#"
schema = 1
family = "hydra"
title = { en = "Hydra pumps", de = "Hydra-Pumpen" }
drives = [{ id = "hydra3", en = "Hydra 3", de = "Hydra 3" }]
params = [
  { id = 100, slug = "speed", en = "Speed", de = "Drehzahl", unit = "1/min", decimals = 0, type = "int", access = "rw", min = -3000, max = 3000 },
  { id = 102, slug = "energy", en = "Energy", de = "Energie", unit = "kWh", decimals = 1, type = "long", access = "r" },
  { id = 104, slug = "limit", en = "Limit", de = "Grenze", unit = "bar", decimals = 2, type = "long", access = "rw", min = 0, max = 16 },
  { id = 106, slug = "fault", en = "Fault", de = "Störung", type = "uint", decimals = 0, access = "r" },
]
[link]
route = "registers"
[roles]
fault = 106
[groups]
actual = [100, 102]
"#;

/// A slave that knows the norm and no drive of ours.
const BENCH: &str = "[[drive]]\nmodel = \"foreign\"\naddress = 5\n\
    registers = { 100 = 64086, 102 = 1, 103 = 34464, 104 = 0, 105 = 650, 106 = 7 }\n";

fn hydra(line: &str) -> Run {
    let named = format!("--catalogue {{dir}}/hydra.toml --drive hydra3 -a 5 {line}");
    antrieb(&named).file("hydra.toml", PUMPS).on(BENCH)
}

#[test]
fn it_is_read_and_written_as_the_norm_says() {
    let read = hydra("read speed energy limit").json().exits(0);
    let values: Vec<_> = (0..3).map(|row| read.data(&format!("/values/{row}/value")).clone()).collect();
    assert_eq!(values, [json!(-1450), json!(10000.0), json!(6.5)]);
    let written = hydra("-v write speed=1200 limit=7,5 --yes").exits(0);
    let told = written.telegrams('>').join("\n");
    // V1.1b3 6.6 for one register, 6.12 for two.
    assert!(told.contains("05 06 00 64 04 B0"), "{told}");
    assert!(told.contains("05 10 00 68 00 02 04 00 00 02 EE"), "{told}");
    assert!(written.out.matches("verified").count() == 2, "{}", written.out);
    hydra("write limit=17 --yes").exits(7);
    hydra("write energy=1 --yes").exits(7);
}

#[test]
fn the_half_that_goes_first_is_a_fact_of_the_family_and_can_be_named() {
    let low_first = PUMPS.replace("route = \"registers\"", "route = \"registers\"\nlow_half_first = true");
    let swapped = |line: &str| {
        let line = format!("--catalogue {{dir}}/low.toml --drive hydra3 -a 5 {line} read limit");
        *antrieb(&line).file("low.toml", &low_first).on(BENCH).json().exits(0).data("/values/0/raw") == json!(650)
    };
    assert!(!swapped(""));
    assert!(swapped("--word-order high"));
    assert!(hydra("--word-order low read limit").json().exits(0).data("/values/0/raw") != &json!(650));
}

/// Whatever asks a drive for its state, its setpoint or its line says that no catalogue tells of it.
#[test]
fn nothing_moves_it() {
    for line in [
        "statemachine",
        "statemachine enable --yes",
        "statemachine goto operation-enabled --yes",
        "sollwert",
        "sollwert 10rpm --yes",
        "sollwert 0",
    ] {
        let refused = hydra(line).exits(7);
        assert!(
            refused.err.contains("no catalogue tells how a drive of the family hydra3 is moved"),
            "{line}: {}",
            refused.err
        );
        assert_eq!(refused.sent(), [""; 0], "{line}");
    }
    let line = hydra("line set --baud 9600 --yes").exits(7);
    assert!(line.err.contains("no catalogue tells how the line"), "{}", line.err);
    hydra("--protocol vabus read speed").exits(7);
}

#[test]
fn every_other_verb_takes_it_as_it_is() {
    assert_eq!(hydra("identify").json().exits(0).data("/drives/0/title"), &json!("Hydra 3"));
    hydra("params").exits(0);
    let told = hydra("diag").json().exits(0);
    assert_eq!(told.data("/drives/0/fault_code"), &json!(7));
    assert_eq!(hydra("monitor --duration 300ms").exits(0).err.matches("gaps").count(), 1);
    // A check that could check nothing has not found that all is well.
    let silent = PUMPS.replace("[roles]\nfault = 106\n", "");
    let line = "--catalogue {dir}/silent.toml --drive hydra3 -a 5 diag --check";
    let untold = antrieb(line).file("silent.toml", &silent).on(BENCH).exits(7);
    assert!(untold.err.contains("nothing tells whether a fault is present at address 5"), "{}", untold.err);
    let faulted = hydra("diag --check").exits(1);
    assert!(faulted.err.contains("a fault is present at address 5"), "{}", faulted.err);
}

/// What a catalogue of one's own does not say leaves no gap, and is said to be unknown in the language of the page.
#[test]
fn what_its_catalogue_does_not_say_leaves_no_gap() {
    let told = hydra("identify").exits(0).out;
    assert!(!told.contains("\n\n\n"), "{told:?}");
    let silent = PUMPS.replace("[roles]\nfault = 106\n", "");
    let line = "--lang de --catalogue {dir}/silent.toml --drive hydra3 -a 5 diag";
    let told = antrieb(line).file("silent.toml", &silent).on(BENCH).exits(0).out;
    assert!(told.contains("Störung  der Katalog nennt keinen Parameter dafür"), "{told}");
    let told = hydra("--lang de write limit=12bar --yes").exits(0).out;
    assert!(told.contains("unbekannt") && !told.contains("unknown"), "{told}");
}

#[test]
fn its_line_is_measured_by_what_it_shows_and_not_by_what_only_an_active_has() {
    for line in ["diag line --count 3", "diag --link-test 3"] {
        let told = hydra(&format!("-v {line}")).exits(0).telegrams('>').join("\n");
        // Register 100, the first of its map, and nothing of the ACTIVE's (P.411, code 8).
        assert!(told.matches("05 03 00 64 00 01").count() >= 3, "{line}:\n{told}");
        assert!(!told.contains("05 03 01 9B") && !told.contains("05 08"), "{line}:\n{told}");
    }
}

#[test]
fn a_family_that_is_only_half_said_is_refused_with_what_is_missing() {
    for (from, to, why) in [
        (
            "[link]\nroute = \"registers\"\n",
            "",
            "unknown family 'hydra' (expected: active, hitachi, lexium05; one that is new says in `[link]`",
        ),
        ("id = \"hydra3\"", "id = \"acu\"", "the id of a drive, 'acu', is taken"),
        ("id = \"hydra3\"", "id = \"auto\"", "the id of a drive, 'auto', is taken"),
        ("id = \"hydra3\"", "id = \"Hydra 3\"", "the id of a drive is made of a-z"),
        ("fault = 106", "control-word = 100", "roles.control-word: a family from a catalogue of one's own"),
        ("route = \"registers\"", "route = \"carrier-pigeon\"", "hydra.toml:13:9"),
    ] {
        let text = PUMPS.replace(from, to);
        assert_ne!(text, PUMPS, "{from}");
        let refused = antrieb("--catalogue {dir}/hydra.toml params").file("hydra.toml", &text).exits(7);
        assert!(refused.err.contains(why), "{why}\n{}", refused.err);
    }
}

/// Nothing of it tells whether it runs.
#[test]
fn who_loads_a_file_into_it_is_told_that_nobody_could_look_whether_it_runs() {
    let load = |more: &str| {
        let text = "antrieb = 1\n[drive]\nfamily = \"hydra3\"\n[values]\nspeed = 1200\n";
        hydra(&format!("{more} dataset load {{dir}}/f.toml")).file("f.toml", text)
    };
    assert_eq!(load("--yes").json().exits(0).warnings(), ["load.unwatched"]);
    let asked = load("").answered("y").exits(0).err;
    let question = asked.split("[y/N]").next().unwrap();
    assert!(question.contains("the family hydra3 tells no state"), "{asked}");
}

/// Without a word about what its actual values are there is nothing to watch, and rows without a value tell nobody.
#[test]
fn it_is_watched_by_its_actual_values_or_by_name() {
    let watched = hydra("monitor --count 1 --unpaced --format csv").exits(0);
    assert!(watched.out.lines().next().unwrap().contains("speed"), "{}", watched.out);
    let bare: String = PUMPS.split("[roles]").next().unwrap_or_default().to_owned();
    let line = "--catalogue {dir}/bare.toml --drive hydra3 -a 5 monitor --count 1 --unpaced";
    let refused = antrieb(line).file("bare.toml", &bare).on(BENCH).exits(2);
    assert!(
        refused.err.contains("name the parameters") && refused.err.contains("params` lists them"),
        "{}",
        refused.err
    );
    let line = format!("{line} speed");
    antrieb(&line).file("bare.toml", &bare).on(BENCH).exits(0);
}
