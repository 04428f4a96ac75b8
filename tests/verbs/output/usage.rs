//! What is said of a command line that cannot be read: in both languages, for people and for programs, with a hint of the
//! level at which it went wrong.

use crate::run::antrieb;
use antrieb::text::Lang;

/// A kind of mistake: the line, what is said, what to do next.
struct Mistake {
    line: &'static str,
    message: [&'static str; 2],
    hint: [&'static str; 2],
}

const fn mistake(line: &'static str, message: [&'static str; 2], hint: [&'static str; 2]) -> Mistake {
    Mistake { line, message, hint }
}

const MISTAKES: &[Mistake] = &[
    mistake(
        "write --frce 480=1",
        ["'--frce' is not expected behind `write`", "'--frce' wird hinter `write` nicht erwartet"],
        ["did you mean '--force'?", "gemeint ist vielleicht '--force'"],
    ),
    mistake(
        "read --record x 372",
        ["'--record' is not expected behind `read`", "'--record' wird hinter `read` nicht erwartet"],
        ["`--record` is an option of `monitor`", "`--record` ist eine Option von `monitor`"],
    ),
    mistake(
        "--protocol dp statemachine disable --mode basic",
        [
            "'--mode' is not expected behind `statemachine disable`",
            "'--mode' wird hinter `statemachine disable` nicht erwartet",
        ],
        [
            "it stands before `disable`: `antrieb --protocol dp … statemachine --mode … disable`",
            "sie steht vor `disable`: `antrieb --protocol dp … statemachine --mode … disable`",
        ],
    ),
    mistake(
        "--enable sollwert 10Hz",
        [
            "'--enable' stands before `sollwert`, whose option it is",
            "'--enable' steht vor `sollwert` und gehört dahinter",
        ],
        [
            "options of a verb stand behind it: `antrieb … sollwert … --enable`",
            "Optionen eines Befehls stehen hinter ihm: `antrieb … sollwert … --enable`",
        ],
    ),
    mistake(
        "monitor --resume x",
        ["'--resume' is not expected behind `monitor`", "'--resume' wird hinter `monitor` nicht erwartet"],
        [
            "`--resume` is an option of `scan`, `dataset save`, `init`",
            "`--resume` ist eine Option von `scan`, `dataset save`, `init`",
        ],
    ),
    mistake(
        "dataset save -x",
        ["'-x' is not expected behind `dataset save`", "'-x' wird hinter `dataset save` nicht erwartet"],
        [
            "`antrieb dataset save -h` shows what is taken there",
            "`antrieb dataset save -h` zeigt, was dort angenommen wird",
        ],
    ),
    mistake(
        "--zzz",
        ["'--zzz' is not expected here", "'--zzz' wird hier nicht erwartet"],
        ["`antrieb --help` shows what there is", "`antrieb --help` zeigt, was es gibt"],
    ),
    mistake(
        "dataset copy 1",
        ["missing behind `dataset copy`: <TO>", "es fehlt hinter `dataset copy`: <NACH>"],
        [
            "it is called as `antrieb dataset copy <FROM> <TO> [PARAMETER]...`; `antrieb dataset copy -h` shows the rest",
            "der Aufruf ist `antrieb dataset copy <VON> <NACH> [PARAMETER]...`; `antrieb dataset copy -h` zeigt das Übrige",
        ],
    ),
    mistake(
        "state goto",
        ["missing behind `statemachine goto`: <STATE>", "es fehlt hinter `statemachine goto`: <ZUSTAND>"],
        ["it is called as `antrieb statemachine goto <STATE>`", "der Aufruf ist `antrieb statemachine goto <ZUSTAND>`"],
    ),
    mistake(
        "read 372 --decimals",
        ["a value for '--decimals <N>' is missing", "für '--decimals <N>' fehlt ein Wert"],
        ["`antrieb read -h` shows", "`antrieb read -h` zeigt"],
    ),
    mistake(
        "read 372 --decimals 9",
        [
            "'9' does not fit '--decimals <N>': expected a whole number, 0 to 6",
            "'9' passt nicht für '--decimals <N>': erwartet wird eine ganze Zahl, 0 bis 6",
        ],
        ["`antrieb read -h` shows", "`antrieb read -h` zeigt"],
    ),
    mistake(
        "monitor --count 0",
        ["expected a whole number from 1 on", "erwartet wird eine ganze Zahl ab 1"],
        ["`antrieb monitor -h` shows", "`antrieb monitor -h` zeigt"],
    ),
    mistake(
        "read 372 --format xml",
        [
            "'xml' does not fit '--format <FORMAT>': expected table, json, ndjson, csv, influx or openmetrics, got 'xml'",
            "'xml' passt nicht für '--format <FORMAT>': erwartet: table, json, ndjson, csv, influx oder openmetrics; angegeben: 'xml'",
        ],
        ["`antrieb read -h` shows", "`antrieb read -h` zeigt"],
    ),
    mistake(
        "statemachine enable --on-exit rmp",
        ["'rmp' does not fit '--on-exit <STOP>' (expected: ", "'rmp' passt nicht für '--on-exit <STOP>' (erwartet: "],
        ["did you mean 'ramp'?", "gemeint ist vielleicht 'ramp'"],
    ),
    mistake(
        "simulate --tcp nowhere",
        [
            "expected an address and a port such as 127.0.0.1:5020",
            "erwartet werden Adresse und Port wie 127.0.0.1:5020",
        ],
        ["`antrieb simulate -h` shows", "`antrieb simulate -h` zeigt"],
    ),
    mistake(
        "statemachin",
        ["there is no verb 'statemachin'", "den Befehl 'statemachin' gibt es nicht"],
        ["did you mean 'statemachine'?", "gemeint ist vielleicht 'statemachine'"],
    ),
    mistake(
        "enable",
        ["there is no verb 'enable'", "den Befehl 'enable' gibt es nicht"],
        ["it is `antrieb statemachine enable`", "es heißt `antrieb statemachine enable`"],
    ),
    mistake(
        "protocol 5",
        ["expected behind `protocol`: show, set; got '5'", "erwartet hinter `protocol`: show, set; angegeben: '5'"],
        ["`antrieb protocol -h` shows", "`antrieb protocol -h` zeigt"],
    ),
    mistake(
        "dataset",
        ["expected behind `dataset`: show, active, ", "erwartet hinter `dataset`: show, active, "],
        ["`antrieb dataset -h` shows", "`antrieb dataset -h` zeigt"],
    ),
    mistake(
        "decode 01 03 21 74 00 01 CE 2C",
        ["expected behind `decode`: telegram, can, trace, ", "erwartet hinter `decode`: telegram, can, trace, "],
        [
            "it is `antrieb decode telegram 01 03 21 74 00 01 CE 2C`",
            "es heißt `antrieb decode telegram 01 03 21 74 00 01 CE 2C`",
        ],
    ),
    mistake(
        "-p sim",
        ["expected a verb: scan, identify", "erwartet: ein Befehl: scan, identify"],
        ["`antrieb --help` shows", "`antrieb --help` zeigt"],
    ),
    mistake(
        "scan -q -v",
        ["'--quiet' does not go together with '--verbose'", "'--quiet' geht nicht zusammen mit '--verbose'"],
        ["`antrieb scan -h` shows", "`antrieb scan -h` zeigt"],
    ),
    mistake(
        "scan --port sim --config a --config b",
        ["'--config <FILE>' is there twice", "'--config <DATEI>' steht zweimal da"],
        ["`antrieb scan -h` shows", "`antrieb scan -h` zeigt"],
    ),
    mistake(
        "read 372 --yes=5",
        ["'5' is a value too many for '--yes'", "'5' ist für '--yes' ein Wert zu viel"],
        ["`antrieb read -h` shows", "`antrieb read -h` zeigt"],
    ),
    mistake(
        "params --baud 9600",
        ["`params` has no use for --baud", "`params` kann mit --baud nichts anfangen"],
        ["leave it out; `antrieb params -h` shows", "weglassen; `antrieb params -h` zeigt"],
    ),
    mistake(
        "-p sim -a 1 --drive foo read 372",
        [
            "unknown drive 'foo' (expected: auto, act, acu, lxm05, l200, sj200, x200)",
            "unbekannter Antrieb 'foo' (erwartet: auto, act, acu, lxm05, l200, sj200, x200)",
        ],
        ["act = ACTIVE (ACT), acu = ", "act = ACTIVE (ACT), acu = "],
    ),
    mistake(
        "-p sim -a 1 line set",
        [
            "expected at least one of --baud, --parity, --address",
            "hinter `line set` wird mindestens eines von --baud, --parity, --address erwartet",
        ],
        ["for example `line set --baud 57600`", "zum Beispiel `line set --baud 57600`"],
    ),
    mistake(
        "schema frobnicate",
        ["'frobnicate' has no JSON output", "'frobnicate' hat keine JSON-Ausgabe"],
        ["there are: scan, ", "es gibt: scan, "],
    ),
    mistake(
        "man frobnicate",
        ["there is no verb 'frobnicate'", "es gibt keinen Befehl 'frobnicate'"],
        ["there are: scan, ", "es gibt: scan, "],
    ),
    mistake(
        "-a read 411",
        [
            "-a takes 'read' as its value: the address is missing",
            "-a nimmt 'read' als seinen Wert: es fehlt die Adresse",
        ],
        ["it is `antrieb ", "es heißt `antrieb "],
    ),
    mistake(
        "-a diag line",
        [
            "-a takes 'diag' as its value: the address is missing",
            "-a nimmt 'diag' als seinen Wert: es fehlt die Adresse",
        ],
        ["it is `antrieb ", "es heißt `antrieb "],
    ),
    mistake(
        "-b read 411",
        [
            "-b takes 'read' as its value: the speed is missing",
            "-b nimmt 'read' als seinen Wert: es fehlt die Baudrate",
        ],
        ["it is `antrieb ", "es heißt `antrieb "],
    ),
    mistake(
        "-p sim --drive read 411",
        ["--drive takes 'read' as its value: the family is missing", "--drive nimmt 'read' als seinen Wert: es fehlt"],
        ["it is `antrieb ", "es heißt `antrieb "],
    ),
    mistake(
        "--port scan",
        ["--port takes 'scan' as its value: the port is missing", "--port nimmt 'scan' als seinen Wert: es fehlt der"],
        ["it is `antrieb ", "es heißt `antrieb "],
    ),
    mistake("stop", ["there is no verb 'stop'", "den Befehl 'stop' gibt es nicht"], STOP),
    mistake("halt", ["there is no verb 'halt'", "den Befehl 'halt' gibt es nicht"], STOP),
    mistake("stpo", ["there is no verb 'stpo'", "den Befehl 'stpo' gibt es nicht"], STOP),
    mistake("statemachine stop", ["expected behind `statemachine`: ", "erwartet hinter `statemachine`: "], STOP),
    mistake("state halt", ["expected behind `statemachine`: ", "erwartet hinter `statemachine`: "], STOP),
    mistake("-p sim -a 1 statemachine goto stop", ["there is no state 'stop'", "es gibt keinen Zustand 'stop'"], STOP),
    mistake("-p sim -a 1 sollwert stop", ["expected a setpoint with its", "erwartet: Sollwert mit Einheit"], STOP),
    mistake(
        "sollwert 1Hz --hold --duration 3",
        ["'3' without a unit: 3s, or 3ms?", "'3' ohne Einheit: 3s oder 3ms?"],
        ["`antrieb sollwert -h` shows", "`antrieb sollwert -h` zeigt"],
    ),
    mistake(
        "read 411 --timeout 500",
        ["'500' without a unit: 500s, or 500ms?", "'500' ohne Einheit: 500s oder 500ms?"],
        ["`antrieb read -h` shows", "`antrieb read -h` zeigt"],
    ),
];

/// A word that means a stop is never answered with one that starts something.
const STOP: [&str; 2] = [
    "a drive is stopped by `antrieb statemachine quick-stop`",
    "ein Antrieb wird angehalten mit `antrieb statemachine quick-stop`",
];

#[test]
fn every_kind_of_mistake_is_told_in_both_languages_with_a_hint_of_its_level() {
    for Mistake { line, message, hint } in MISTAKES {
        for (lang, said, next) in [(Lang::En, message[0], hint[0]), (Lang::De, message[1], hint[1])] {
            let name = lang.pick("en", "de");
            // Names of commands are English words too; `german` knows them.
            let told = antrieb(&format!("--lang {name} {line}")).run();
            assert_eq!(told.exit, 2, "{line}");
            let [wrong, to_do] = lang.pick(["error: ", "hint: "], ["Fehler: ", "Hinweis: "]);
            let told_there = told.err.replace("`antrieb -p sim -a 1 ", "`antrieb ");
            let starts = |start: &str| told_there.lines().find_map(|line| line.strip_prefix(start));
            assert!(starts(wrong).is_some_and(|told| told.contains(said)), "{line}\n{}", told.err);
            assert!(starts(to_do).is_some_and(|told| told.starts_with(next)), "{line}\n{}", told.err);
        }
    }
}

#[test]
fn a_program_gets_the_same_words_in_their_fields() {
    for Mistake { line, message, hint } in MISTAKES {
        for (lang, said, next) in [("en", message[0], hint[0]), ("de", message[1], hint[1])] {
            let document = antrieb(&format!("--lang {lang} {line}")).json().exits(2);
            let error = document.error();
            let [told, to_do] = ["message", "hint"].map(|field| {
                error[field].as_str().unwrap().replace(" --json", "").replace("`antrieb -p sim -a 1 ", "`antrieb ")
            });
            assert!(told.contains(said) && to_do.starts_with(next), "{line}\n{error:#}");
            assert_eq!(error["class"], "usage");
            assert!(!told.contains("antrieb ") && !told.contains('\n'), "{line}: a hint in the message\n{error:#}");
        }
    }
}

/// Alone it is no mistake that could be named: the help is shown.
#[test]
fn without_a_word_the_help_is_shown() {
    let page = antrieb("").exits(2);
    assert!(page.err.contains("Usage:") && !page.err.contains("error:"), "{}", page.err);
    assert_eq!(page.err, antrieb("-h").exits(0).out);
}
