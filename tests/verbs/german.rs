//! No English word in what is said in German.
//!
//! Two nets. [`same`]: a text in one language stands alike in both outputs of the same command line, so every word that both
//! have must be one that both languages have ([`ALIKE`]). [`check`]: no German output of any test has a word that only an English
//! sentence has ([`ENGLISH`]); every [`Run`](crate::run::Run) with `--lang de` that ends as it must goes through it. Names of commands, options and
//! slugs, what a user typed, telegrams and numbers are no words.

use crate::run::{Run, antrieb};
use antrieb::command::VERBS;
use std::collections::BTreeSet;

/// Words that no English sentence does without, and words of ours, in lower case; none of them is German.
const ENGLISH: &str = "
    about above address addresses after again against all allowed already always and anew answer answered answers any
    anybody anything are as asked at away back be because been before behind below between beyond both but by can
    cannot character characters checksum choose comes contact contacts could current device did different digit digits
    do does done down drive drives duplicate each either else empty enabled encoding end ends even every everybody
    everything expected fault faults few field file files finite first float for found frame from full function given
    gives goes gone got had has have he here hint how if illegal integer interrupted into invalid is it its itself
    just keeps key known later least left length less like line literal lost made make many map may maybe
    mean means missing mode more most much must named names neither never next no nobody none nor not nothing now
    number numbers of off on once one only open or other our out over own parse parsed part place please question
    questions range refused registers replies reply row rows said same second seconds see seen sent sequence
    serial setting settings several shaft shall she should shows silence silent since some somebody something speed
    stands still string such take taken telegrams tells than that the their them then there these they thing this
    those though three through time times to together told too took turns two unclosed unconfirmed under unexpected
    unit unknown unless unset until up upon used value values variant voltage warning we well were what when where
    whether which while who whole whom whose why with without would wrong yes yet you your
";

/// Words that both languages have, or that have no language: names, units, standards, words of the catalogue.
const ALIKE: &str = "
    identifier index kbd okay plan rate sender sync timeout txpdo µs act active acu adapter antrieb ascii auto baud bd bit broadcasts bus bytes disable enable last shutdown sniff clients cm code crc cube dir echo eeprom em
    exceptions exit fmax format gateway halt hz in ixt kw lexium lrc lxm man master mbtcp mech median modbus motor ms name ndjson negative
    nodeid oder ok param parameter port ram register remote repeater reset rtu rw server sim slave start stderr tcp terminal text ti
    tk type udc uint vabus version war was watchdog
    acceleration an fdl generic manual pin profibus slaves status volatile
    gnd pe rxd txd
    operational rxpdos
    ak basic block byte dch dl dp hitachi profidrive dsap element fcb fcs fcv ident ind pke pkw pwe sa ssap station zsw
";

/// What stands in a German page as it is called everywhere: sources of the catalogue, and names it gives in English.
const NAMES: &[&str] = &[
    "CM-485 manual",
    "EM-RES-03 manual",
    "LXM05 manual",
    "facts S4",
    "built-in",
    "Local/Remote",
    "RS232/RS485 Watchdog Timer",
    // SJ2-PB manual 3.2.2, 3.2.3, and the norm of PROFIBUS.
    "Run Fwd",
    "Net Ctrl",
    "Net Ref",
    "Conn Sta",
    "Faulted",
    "SRD high",
    // EM-RES-03 manual 7.2.
    "PDO1 Function",
    "PDO2 Function",
    "PDO3 Function",
    "PDO1 Time",
    "PDO2 Time",
    "PDO3 Time",
];

/// The words of a page that could be those of a language, in lower case.
fn words(page: &str) -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    // The settings are told by the names that they have in a file.
    let names = ["$ antrieb", "-----", "Anmerkung: Einstellungen:", "note: settings:"];
    for line in page.lines().filter(|line| !names.iter().any(|name| line.starts_with(name))) {
        // What is to be typed goes to the end of its line.
        let mut line = line.split("antrieb ").next().unwrap_or_default().to_owned();
        NAMES.iter().for_each(|name| line = line.replace(name, " "));
        // What a device or a library said, and what stands for something to be typed.
        line = outside(&outside(&line, '"', '"'), '<', '>');
        for (nth, part) in line.split('`').enumerate() {
            // What stands between backticks is to be typed; what stands behind an option is its value.
            if nth % 2 == 0 {
                let parts: Vec<&str> = part.split(is_blank).collect();
                let is_value = |at: usize| at > 0 && parts.get(at - 1).is_some_and(|option| option.starts_with("--"));
                words.extend((0..parts.len()).filter(|at| !is_value(*at)).filter_map(|at| word(parts[at])));
            }
        }
    }
    words
}

/// A line without what stands between these two.
fn outside(line: &str, open: char, close: char) -> String {
    let mut rest = line;
    let mut kept = String::new();
    while let Some((before, inside)) = rest.split_once(open) {
        kept.push_str(before);
        rest = inside.split_once(close).map_or("", |(_, behind)| behind);
    }
    kept + rest
}

fn is_blank(letter: char) -> bool {
    letter.is_whitespace() || matches!(letter, '(' | ')' | ',' | ';' | '!' | '?' | '…' | '„' | '“' | '[' | ']' | '|')
}

/// One that has letters only. `--drive`, `operation-enabled`, `P.412`, `'typed'` and `quick_stop` are names, `CE` is a byte.
fn word(part: &str) -> Option<String> {
    let part = part.trim_end_matches(['.', ':']);
    let is_byte = part.len() == 2 && part.chars().all(|letter| matches!(letter, 'A'..='F'));
    let is_word = part.chars().count() > 1 && part.chars().all(char::is_alphabetic);
    (is_word && !is_byte).then(|| part.to_lowercase())
}

fn listed(list: &'static str) -> BTreeSet<&'static str> {
    list.split_whitespace().collect()
}

/// Words of a page that only an English sentence has.
fn english(page: &str) -> Vec<String> {
    let english = listed(ENGLISH);
    words(page).into_iter().filter(|word| english.contains(&**word)).collect()
}

/// English words of a German page, and those that stand alike in the English one and are not of both languages.
pub(crate) fn alike(english_page: &str, german_page: &str) -> Vec<String> {
    let (alike, there) = (listed(ALIKE), words(english_page));
    let is_odd = |word: &String| there.contains(word) && !alike.contains(&**word);
    words(german_page).into_iter().filter(is_odd).chain(english(german_page)).collect()
}

/// Fails for a word that only an English sentence has.
#[track_caller]
pub(crate) fn check(page: &str) {
    let found = english(page);
    assert!(found.is_empty(), "English in German: {found:?}\n{page}");
}

/// Fails for a word that stands alike in both outputs, and is not one of both languages.
#[track_caller]
pub(crate) fn same(english: &str, german: &str) {
    let found = alike(english, german);
    assert!(found.is_empty(), "alike in both languages: {found:?}\n{german}");
}

/// What does not work, and what is said of it: every way to a usage error, to bad data, to a port that is none.
const WRONG: &[(u8, &str)] = &[
    (2, "frobnicate"),
    (2, "statemachin"),
    (2, "enable"),
    (2, "-p sim read --type float 372"),
    (2, "-p sim -a 1 write"),
    (2, "-p sim --baud 5 scan"),
    (2, "-p sim --baud"),
    (2, "-p sim --parity mark scan"),
    (2, "-p sim --stop-bits 3 scan"),
    (2, "-p sim --data-bits 9 scan"),
    (2, "-p sim --data-bits 7 scan"),
    (2, "-p sim --retries 99 scan"),
    (2, "-p sim --timeout soon scan"),
    (2, "-p sim --timeout 0ms scan"),
    (2, "-p sim --rs485 maybe scan"),
    (2, "-p sim --word-order middle scan"),
    (2, "-p sim --format xml scan"),
    (2, "-p sim --color blue scan"),
    (2, "-p sim --protocol profibus scan"),
    (2, "-p sim --protocol auto -a 1 read 411"),
    (2, "-p sim --quiet --verbose scan"),
    (2, "-p tcp://x scan"),
    (2, "-p mbtcp://127.0.0.1:1 --protocol rtu scan"),
    (2, "-p sim --protocol tcp scan"),
    (2, "-p sim -p sim read 411"),
    (2, "-p rfc2217:// scan"),
    (2, "-p sim -a 300 read 372"),
    (2, "-p sim -a 5-2 read 372"),
    (2, "-p sim -a nobody read 372"),
    (2, "-p sim -a 3.17 read 372"),
    (2, "-p sim -a 3.99 --protocol vabus version read 372"),
    (2, "-p sim -a 0 read 372"),
    (2, "-p sim write 480=1"),
    (2, "-p sim -a 1,2 statemachine enable"),
    (2, "-p sim -a 0 statemachine enable"),
    (2, "-p sim -a 1 statemachine goto nowhere"),
    (2, "-p sim -a 1 statemachine contacts S9IND"),
    (2, "-p sim -a 1 statemachine enable --hold --duration never"),
    (2, "-p sim -a 1 statemachine enable --duration 5s"),
    (2, "-p sim -a 1 sollwert 25Hz --mode nonsense"),
    (2, "-p sim -a 1 sollwert 25bananas"),
    (2, "-p sim -a 1 procedure nothing-such"),
    (2, "-p sim -a 1 procedure commission power=1kW"),
    (7, "-p sim -a 1 procedure commission power=1kW voltage=400V current=1A frequency=50Hz speed=1390rpm"),
    (7, "-p sim -a 1 procedure commission power=x voltage=400V current=1A frequency=50Hz speed=1390rpm"),
    (2, "-p sim -a 1 procedure first-contact watchdog"),
    (2, "-p sim -a 1 procedure first-contact nothing=1"),
    (7, "-p sim -a 1 procedure first-contact watchdog=soon"),
    (7, "-p sim -a 1 procedure first-contact --record {dir}/file"),
    (7, "-p sim -a 1 procedure first-contact --given {dir}/file"),
    (8, "-p sim -a 1 procedure first-contact"),
    (2, "-p sim -a 1 sollwert Hz"),
    (2, "-p sim -a 1 sollwert 25Hz --ramp soon"),
    (2, "-p sim -a 1 monitor --interval soon 411"),
    (2, "-p sim -a 1 monitor --count 0 411"),
    (2, "-p sim -a 1 protocol set morse"),
    (2, "-p sim -a 1 protocol set"),
    (2, "-p sim -a 1 line set"),
    (2, "-p sim -a 1 line"),
    (2, "-p sim -a 1 protocol"),
    (2, "-p sim -a 1 dataset"),
    (2, "decode"),
    (2, "-p sim -a 1 line set --parity mark"),
    (2, "-p sim -a 1 dataset show 372@7"),
    (2, "-p sim -a 1 dataset copy 2 2 372"),
    (2, "-p sim -a 1 dataset copy 2 9 372"),
    (2, "-p sim -a 1 read 372@77"),
    (7, "-p sim -a 1 read @nogroup"),
    (2, "-p sim -a 1 read 9-3"),
    (7, "-p sim -a 1 read nonsense"),
    (7, "-p sim -a 1 --yes write 480@1=1000"),
    (7, "-p sim -a 1 --yes write 480@1=abc"),
    (7, "-p sim -a 1 --yes write 480@1=1.2345"),
    (7, "-p sim -a 1 --yes write 480@1=5kg"),
    (2, "-p sim -a 1 --yes write 480@1"),
    (7, "-p sim -a 1 --yes write 412=nonsense"),
    (2, "-p sim -a 1 --drive nobody read 411"),
    (2, "decode telegram"),
    (2, "decode telegram xyz"),
    (5, "decode telegram 01"),
    (5, "decode telegram 01 03 21 74 00 01 CE 2D"),
    (5, "decode telegram ':01032174000167'"),
    (5, "decode telegram ':0103217400016X'"),
    (2, "decode status nonsense"),
    (2, "decode pkw 7393"),
    (2, "profibus"),
    (2, "profibus module L200"),
    (2, "profibus module set deceleration"),
    (2, "profibus module L200 set nothing-such"),
    (2, "profibus module L200 set 264"),
    (2, "profibus module L200 set d001"),
    (2, "profibus module L200 set F003 generic"),
    (2, "profibus module L200 get F003 min 1 max 2"),
    (2, "profibus module L200 get 614 address based"),
    (2, "profibus module 01"),
    (2, "--drive l200 -p sim -a 1 read 7"),
    (2, "--drive l200 -p sim -a 1 read 7 --dry-run"),
    (2, "decode diagnosis 02 05"),
    (2, "decode basic-status nonsense"),
    (2, "decode telegram 10 08 02 49 53 16 --cfg ppo9"),
    (2, "--protocol dp read 480"),
    (8, "-p sim --protocol dp -a 3 sollwert 20Hz --jog 5s"),
    (8, "-p sim --protocol dp -a 3 --yes sollwert 20Hz --jog 1s"),
    (7, "-p sim --protocol dp -a 3 --yes sollwert 51Hz --jog 1s"),
    (8, "-p sim --protocol dp -a 3 --yes statemachine reset"),
    (4, "-p sim --protocol dp -a 9 statemachine disable"),
    (4, "-p sim --protocol dp -a 9 sollwert 0"),
    (2, "-p sim --protocol dp -a 3 sollwert"),
    (2, "-p sim --protocol dp -a 3 sollwert 20"),
    (2, "-p sim --protocol dp -a 3 sollwert 500Hz --jog 1s"),
    (2, "-p sim --protocol dp -a 3 sollwert 20Hz"),
    (2, "-p sim --protocol dp -a 3 sollwert 20Hz --enable"),
    (2, "-p sim --protocol dp -a 3 sollwert 20Hz --jog 1s --watchdog 2min"),
    (2, "-p sim --protocol dp -a 3 sollwert 20Hz --jog 1s --on-exit keep"),
    (2, "-p sim --protocol dp -a 3 statemachine enable"),
    (2, "-p sim --protocol dp -a 3 statemachine disable --take-control"),
    (2, "-p sim --protocol dp -a 1,3 statemachine disable"),
    (5, "--protocol dp decode telegram 55"),
    (5, "--protocol dp decode telegram 68 05 06 68"),
    (5, "--protocol dp decode telegram 10 08 02 49 53 17"),
    (2, "decode fault nonsense"),
    (7, "decode trace {dir}/no-file"),
    (7, "decode trace {dir}/file"),
    (7, "-p sim --catalogue {dir}/no-file read 411"),
    (7, "-p sim --catalogue {dir}/file read 411"),
    (7, "-p sim --catalogue {dir}/bad.toml read 411"),
    (7, "-p sim --config {dir}/file read 411"),
    (7, "-p sim --config {dir}/strange.toml read 411"),
    (7, "-p sim --config {dir}/far.toml read 411"),
    (7, "-p sim:{dir}/no-file -a 1 read 411"),
    (7, "-p sim:{dir}/file -a 1 read 411"),
    (7, "-p sim:{dir}/strange.toml -a 1 read 411"),
    (7, "-p tape:{dir}/file -a 1 read 411"),
    (7, "-p tape:{dir}/no-file -a 1 read 411"),
    (7, "-p sim scan --resume {dir}/file"),
    (7, "-p sim -a 1 sollwert --profile {dir}/file --yes"),
    (7, "-p sim -a 1 sollwert --profile {dir}/ramp.csv --yes"),
    (7, "simulate {dir}/file"),
    (3, "simulate --tcp 10.0.0.1:1"),
    (2, "params --drive nobody"),
    (3, "-p /dev/antrieb-has-no-such-port scan"),
    (3, "-p tcp://127.0.0.1:1 scan"),
    (4, "-p sim -a 9 read 372"),
    (6, "-p sim -a 1 read 1600"),
    (8, "-p sim -a 1 write 480@1=6"),
    (8, "-p sim -a 1 statemachine enable"),
];

/// Names of settings, modes and values.
const NAMED: &[&str] = &[
    "sdo",
    "contact",
    "first",
    "first-contact",
    "list",
    "commission",
    "power",
    "current",
    "speed",
    "gear",
    "homing",
    "jog",
    "position",
    "velocity",
    "voltage",
    "address",
    "all",
    "allram",
    "always",
    "csv",
    "even",
    "frequency",
    "high",
    "influx",
    "int",
    "json",
    "kernel",
    "long",
    "low",
    "never",
    "openmetrics",
    "none",
    "odd",
    "percent",
    "profibus",
    "protocol",
    "rts",
    "setpoint",
    "state",
    "table",
    "timeout",
    "word",
];

/// Whether a verb, or what stands behind one, is called so.
fn is_command(word: &str) -> bool {
    let command = |verb: &antrieb::command::Entry| (verb.command)();
    VERBS.iter().map(command).any(|verb| verb.get_name() == word || verb.find_subcommand(word).is_some())
}

/// All that does not work, in a language.
pub(crate) fn wrong(lang: &str) -> impl Iterator<Item = Run> {
    WRONG.iter().map(move |(_, line)| {
        let files = [
            ("file", "nonsense = [\n"),
            ("strange.toml", "colour = 1\n"),
            ("far.toml", "[drives.pump]\naddress = 999\n"),
            ("bad.toml", "[family]\ndrive = \"act\"\n[[param]]\nid = \"x\"\n"),
            ("ramp.csv", "time_s,frequency_hz\n0,1\n5,nonsense\n"),
        ];
        let run = antrieb(&format!("--lang {lang} {line}"));
        files.iter().fold(run, |run, (name, text)| run.file(name, text))
    })
}

#[test]
fn what_does_not_work_is_told_in_german_without_an_english_word() {
    let mut amiss = Vec::new();
    for ((code, line), (english, german)) in WRONG.iter().zip(wrong("en").zip(wrong("de"))) {
        let (english, german) = (english.run(), german.run());
        let told = |page: &str| page.lines().filter(|line| !line.contains("antrieb --")).collect::<Vec<_>>().join("\n");
        // Words of options and commands, of which a message lists those that would be right.
        let listed = |word: &String| NAMED.contains(&&**word) || is_command(word);
        let found: Vec<_> =
            alike(&told(&english.err), &told(&german.err)).into_iter().filter(|word| !listed(word)).collect();
        if (german.exit, found.is_empty()) != (*code, true) {
            amiss.push(format!("{line}: exit {} {found:?}\n{}", german.exit, german.err));
        }
    }
    assert!(amiss.is_empty(), "{}", amiss.join("\n"));
}

#[test]
fn a_verb_that_needs_a_word_behind_it_says_which_there_are() {
    for (line, en, de) in [
        ("-a 1 line", "expected behind `line`: show, set", "erwartet hinter `line`: show, set"),
        ("-a 1 protocol", "expected behind `protocol`: show, set", "erwartet hinter `protocol`: show, set"),
        ("-a 1 dataset", "expected behind `dataset`: show, active", "erwartet hinter `dataset`: show, active"),
    ] {
        for (lang, told) in [("en", en), ("de", de)] {
            let line = format!("-p sim --lang {lang} {line}");
            let page = antrieb(&line).exits(2);
            assert!(page.err.contains(told), "{}", page.err);
            let document = antrieb(&line).json().exits(2);
            assert!(document.error()["message"].as_str().unwrap().starts_with(told), "{:#}", document.value);
        }
    }
}
