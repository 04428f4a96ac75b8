//! `init`, `plan`, `apply`, `check`: a plant of several lines, and whatever goes wrong on one of them.

use super::ends::{End, Ended, brought_to_end};
use crate::run::{Document, Run, antrieb};
use antrieb::failure::Class;
use antrieb::outcome::{Data, Outcome, Plant, PlantState};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::transport::witness;
use std::path::Path;

const ACT: &str = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"372@1\" = 1440\n\"480@2\" = \"20 Hz\"\n";
const ACU: &str = "antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n\"480@1\" = \"20 Hz\"\n";
const SERVO: &str = "antrieb = 1\n[drive]\nfamily = \"lxm05\"\n[values]\nRAMPacc = 3000\n";

/// Three ports: two drives, two, and one.
const PLANT: &str = "\
[ports.left]
path = \"sim:{dir}/left.bench\"
[ports.middle]
path = \"sim:{dir}/middle.bench\"
[ports.right]
path = \"sim:{dir}/right.bench\"
[drives.a1]
port = \"left\"
address = 1
files = [\"act.toml\"]
[drives.a2]
port = \"left\"
address = 2
files = [\"acu.toml\"]
[drives.b1]
port = \"middle\"
address = 1
files = [\"act.toml\"]
[drives.b2]
port = \"middle\"
address = 2
files = [\"acu.toml\"]
[drives.c3]
port = \"right\"
address = 3
files = [\"servo.toml\"]
[groups]
ones = [\"a1\", \"b1\"]
";

pub(crate) const TWO: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive]]\nmodel = \"acu\"\naddress = 2\n";
pub(crate) const ONE: &str = "[[drive]]\nmodel = \"lxm05\"\naddress = 3\n";

pub(crate) fn with(run: Run, config: &str, [left, middle, right]: [&str; 3]) -> Run {
    let config = config.replace("{dir}", &run.directory().display().to_string());
    let files = [
        ("antrieb.toml", config.as_str()),
        ("left.bench", left),
        ("middle.bench", middle),
        ("right.bench", right),
        ("act.toml", ACT),
        ("acu.toml", ACU),
        ("servo.toml", SERVO),
    ];
    files.into_iter().fold(run, |run, (name, text)| run.file(name, text))
}

/// The plant, with these benches.
pub(crate) fn plant(line: &str, benches: [&str; 3]) -> Run {
    with(antrieb(line), PLANT, benches)
}

/// How each drive stands: `a1 done, a2 skipped`.
pub(super) fn states(document: &Document) -> String {
    let drives = document.data("/drives").as_array().unwrap().iter();
    let told = drives.map(|row| format!("{} {}", row["called"].as_str().unwrap(), row["state"].as_str().unwrap()));
    told.collect::<Vec<_>>().join(", ")
}

/// What a drive's error says.
fn error<'d>(document: &'d Document, name: &str) -> &'d str {
    let drives = document.data("/drives").as_array().unwrap();
    drives.iter().find(|row| row["called"] == name).unwrap()["error"]["code"].as_str().unwrap()
}

/// What stands at `372@1` of the ACT and `480@1` of the ACU of each bench that was left.
fn stored() -> Vec<[Option<i64>; 2]> {
    let of = |bench: &Bench| [(1, 372), (2, 480)].map(|(address, id)| bench.drive(address)?.eeprom(id, 1));
    witness::all_left().iter().map(|(bench, _)| of(bench)).collect()
}

const BEFORE: [Option<i64>; 2] = [Some(1390), Some(500)];
const AFTER: [Option<i64>; 2] = [Some(1440), Some(2000)];

#[test]
fn three_ports_have_one_plan_one_question_and_one_report() {
    let planned = plant("plan", [TWO, TWO, ONE]).json().exits(1);
    assert_eq!(states(&planned), "a1 planned, a2 planned, b1 planned, b2 planned, c3 planned");
    assert_eq!(planned.error()["code"], "no.differences");
    assert_eq!(stored()[..2], [BEFORE, BEFORE], "a plan writes nothing");

    let asked = plant("apply", [TWO, TWO, ONE]).answered("y").exits(0);
    assert_eq!(asked.err.matches("[y/N]").count(), 1, "{}", asked.err);
    assert!(asked.err.contains("5 drives: write 7 values"), "{}", asked.err);
    assert_eq!(stored()[..2], [AFTER, AFTER]);
    for name in ["a1", "a2", "b1", "b2", "c3"] {
        assert!(asked.text_of(&format!("{name}.undo.toml")).contains("[undo]"));
    }
    plant("apply", [TWO, TWO, ONE]).answered("n").exits(8);
    assert_eq!(stored()[..2], [BEFORE, BEFORE]);
}

#[test]
fn what_is_equal_is_no_difference_and_asks_nobody() {
    let act = "[[drive]]\nmodel = \"act\"\naddress = 1\nset = { \"372@1\" = 1440, \"480@2\" = 20 }\n\
               [[drive]]\nmodel = \"acu\"\naddress = 2\n";
    for verb in ["plan", "apply", "check"] {
        plant(&format!("-a a1 {verb}"), [act, TWO, ONE]).json().exits(0);
    }
    let ram = act.replacen("set = { ", "set = { \"480@2ram\" = 7, ", 1);
    let works = plant("-a a1 check", [&ram, TWO, ONE]).json().exits(0);
    assert_eq!(works.warnings(), ["check.in_force"], "{:#}", works.value);
    let drifted = plant("check", [act, TWO, ONE]).json().exits(1);
    assert_eq!(drifted.data("/drives/0/equal"), true);
    assert_eq!(drifted.data("/drives/1/differences/0/b_raw"), 500);
}

/// The pipe concerns what is printed, not what became of the drives: `| head` makes no drift the same.
#[test]
fn a_closed_pipe_makes_no_failure_a_success() {
    for (line, exit) in [("plan", 9), ("check", 9), ("apply --yes", 9), ("-a a1,b1 check", 1), ("-a a1,b1 plan", 1)] {
        for form in ["", "--json"] {
            let run = plant(line, [TWO, "[[drive]]\nmodel = \"act\"\naddress = 1\n", ONE]).and(form);
            let ended = run.into_pipe_of(5).exits(exit);
            assert!(ended.err.contains("error: "), "{line}: {}", ended.err);
        }
    }
    plant("-a a1 apply --yes", [TWO, TWO, ONE]).into_pipe_of(5).exits(0);
}

#[test]
fn who_is_silent_or_another_one_is_left_out_and_named() {
    let family = "[[drive]]\nmodel = \"acu\"\naddress = 1\n[[drive]]\nmodel = \"acu\"\naddress = 2\n";
    let alone = "[[drive]]\nmodel = \"act\"\naddress = 1\n";
    for verb in ["plan", "apply --yes"] {
        let done = if verb == "plan" { "planned" } else { "done" };
        let ended = plant(verb, [family, alone, ONE]).json().exits(9);
        assert_eq!(states(&ended), format!("a1 skipped, a2 {done}, b1 {done}, b2 skipped, c3 {done}"));
        assert_eq!(error(&ended, "a1"), "data.other_family");
        assert_eq!(error(&ended, "b2"), "silence.no_reply");
        let families = ["/drives/0/drive", "/drives/3/drive"].map(|place| ended.data(place).clone());
        assert_eq!(families, ["acu", "unknown"], "what a drive is was found out, of who is silent it was not");
        let told = ended.data("/drives/0/error/message").as_str().unwrap();
        assert!(told.contains("address 1 is of the family acu"), "{told}");
        let message = ended.error()["message"].as_str().unwrap();
        assert!(message.contains("2 of 5 drives could not be looked at (a1, b2)"), "{message}");
    }
    let checked = plant("check", [family, alone, ONE]).json().exits(9);
    assert_eq!(error(&checked, "a1"), "data.other_family");
    // Of who is silent nobody says how he is, and what would change is said all the same.
    let planned = plant("plan", [alone, TWO, ONE]).exits(9).err;
    assert!(planned.contains("1 of 5 drives did not answer (a2); a2: address 2: no reply"), "{planned}");
    assert!(planned.contains("; 4 drives would change: a1, b1, b2, c3"), "{planned}");
    // All or none: nothing is begun.
    let none = plant("apply --yes --atomic", [family, alone, ONE]).json().exits(7);
    assert_eq!(states(&none), "a1 skipped, a2 skipped, b1 skipped, b2 skipped, c3 skipped");
    assert_eq!(stored()[1], [Some(1390), None]);
}

#[test]
fn who_calls_himself_otherwise_is_not_written_to() {
    for (product, exit) in [("LXM05AD10M2", 9), ("0", 9)] {
        let config = format!(
            "{PLANT}[drives.other]\naddress = 4\nport = \"right\"\nproduct = \"{product}\"\nfiles = [\"servo.toml\"]\n"
        );
        let servos = format!("{ONE}[[drive]]\nmodel = \"lxm05\"\naddress = 4\nservo = {{ product = \"another\" }}\n");
        let ended = with(antrieb("-a c3,other apply --yes"), &config, [TWO, TWO, &servos]).json().exits(exit);
        assert_eq!(states(&ended), "c3 done, other skipped");
        assert_eq!(error(&ended, "other"), "data.other_drive");
    }
}

#[test]
fn a_drive_that_fails_goes_back_and_stops_the_others_only_if_that_is_wanted() {
    // It refuses 480@2, behind 372@1.
    let failing = TWO.replacen("address = 1\n", "address = 1\n[[drive.event]]\nat = \"0s\"\nrefuses = 8672\n", 1);
    let ended = plant("apply --yes", [TWO, &failing, ONE]).json().exits(9);
    assert_eq!(states(&ended), "a1 done, a2 done, b1 back, b2 done, c3 done");
    assert_eq!(stored()[..2], [AFTER, [Some(1390), Some(2000)]]);
    let atomic = plant("apply --yes --atomic", [TWO, &failing, ONE]).json().exits(9);
    assert!(states(&atomic).starts_with("a1 back, a2 back, b1 back, b2 skipped, c3 "), "{}", states(&atomic));
    assert!(!states(&atomic).contains("done"), "{}", states(&atomic));
    assert_eq!(stored()[..2], [BEFORE, BEFORE]);
    assert!(atomic.error()["message"].as_str().unwrap().contains("b1: P.480@2"), "{}", atomic.error());
}

#[test]
fn a_drive_that_runs_is_left_out() {
    let runs = "address = 1\nset = { \"412\" = 1, \"410\" = 15, \"484\" = 10 }\n";
    let running = TWO.replacen("address = 1\n", runs, 1);
    let ended = plant("-a @ones apply --yes", [&running, TWO, ONE]).json();
    assert_eq!(ended.exit, 9, "{:#}", ended.value);
    assert_eq!(states(&ended), "a1 skipped, b1 done");
    assert_eq!(error(&ended, "a1"), "forbidden.running");
}

/// Runs with a wish to end behind so many telegrams.
fn wished(directory: &Path, words: &str, after: usize) -> (usize, Outcome) {
    let Ended { telegrams, outcome, .. } =
        brought_to_end(directory, words, &Registry::open(&[]).unwrap(), End::Wish, after);
    (telegrams, outcome)
}

/// Ctrl-C behind every telegram: what is said of each drive is true.
#[test]
fn a_wish_to_end_takes_back_what_is_under_way_and_begins_nothing_else() {
    let run = plant("plan", [TWO, TWO, ONE]);
    let (telegrams, whole) = wished(run.directory(), "-a a1,a2,b1 apply", usize::MAX);
    assert!(whole.failure.is_none(), "{:?}", whole.failure);
    let mut seen = [false; 2];
    for atomic in ["", " --atomic"] {
        for after in (1..telegrams).step_by(3) {
            let (_, ended) = wished(run.directory(), &format!("-a a1,a2,b1 apply{atomic}"), after);
            let left = stored();
            let Some(Data::Plant(Plant { drives, .. })) = ended.data else { continue };
            let class = ended.failure.as_ref().map(|failure| failure.class);
            assert_eq!(class, Some(Class::Interrupted), "{after}{atomic}: {:?}", ended.failure);
            let stands = [left[0][0] == AFTER[0], left[0][1] == AFTER[1], left[1][0] == AFTER[0]];
            for (drive, stands) in drives.iter().zip(stands) {
                assert_eq!(drive.state == PlantState::Done, stands, "{after}{atomic}: {drive:?}");
                assert_ne!(drive.state, PlantState::Torn, "{after}{atomic}: {drive:?}");
                seen[0] |= stands;
                seen[1] |= drive.state == PlantState::Back;
            }
            assert!(atomic.is_empty() || stands == [false; 3], "{after}: {drives:?}");
        }
    }
    assert_eq!(seen, [true; 2], "some were done, some were put back");
}

/// The adapter of one port is pulled, behind every telegram: the others are done all the same.
#[test]
fn a_line_that_is_cut_is_named_and_the_others_go_on() {
    let run = plant("plan", [TWO, TWO, ONE]);
    let mut torn = 0;
    for after in (4..80).step_by(5) {
        witness::call(true);
        witness::pull_one_after(after);
        let (_, ended) = wished(run.directory(), "apply", usize::MAX);
        witness::pull_after(None);
        let left = stored();
        let Some(Data::Plant(Plant { drives, .. })) = ended.data else { panic!("{after}: {:?}", ended.failure) };
        let failed: Vec<&str> =
            drives.iter().filter(|row| row.error.is_some()).map(|row| row.called.as_str()).collect();
        let Some(failure) = ended.failure else {
            assert!(failed.is_empty());
            continue;
        };
        assert_eq!(failure.class, Class::Partial, "{after}: {failure:?}");
        let port = drives.iter().find(|row| row.error.is_some()).unwrap().port.clone();
        for row in drives.iter().filter(|row| row.port != port) {
            assert_eq!(row.state, PlantState::Done, "{after}: {row:?}");
        }
        torn += usize::from(drives.iter().any(|row| row.state == PlantState::Torn));
        let cells = [("a1", 0, 0), ("a2", 0, 1), ("b1", 1, 0), ("b2", 1, 1)];
        for (name, bench, cell) in cells {
            let row = drives.iter().find(|row| row.called == name).unwrap();
            let (now, is_torn) = (left[bench][cell], row.state == PlantState::Torn);
            assert!(
                is_torn || (row.state == PlantState::Done) == (now == AFTER[cell]),
                "{after} {name}: {now:?} {row:?}"
            );
        }
    }
    assert!(torn > 0, "no line was cut in the middle of a transaction");
}

/// The power of a drive fails for a moment: what went into its RAM is lost, and nobody calls that done.
#[test]
fn power_that_fails_in_one_drive_is_noticed() {
    for after in (2..40).step_by(3) {
        let event = format!("address = 1\n[[drive.event]]\nafter_telegrams = {after}\npower_cycle = true\n");
        let failing = TWO.replacen("address = 1\n", &event, 1);
        let ended = plant("-a @ones apply --yes --ram", [&failing, TWO, ONE]).json();
        let left = witness::all_left();
        let ram = |bench: &Bench| bench.drive(1).unwrap().ram(372, 1);
        let state = ended.data("/drives/0/state").as_str().unwrap();
        let is_there = ram(&left[0].0) == Some(1440);
        assert!(state != "done" || is_there, "{after}: {state}");
        assert_eq!(ended.data("/drives/1/state"), "done", "{after}");
        assert_eq!(ended.exit == 0, state == "done", "{after}");
    }
}

#[test]
fn a_file_that_does_not_do_is_told_before_anything_is_opened() {
    let broken = |run: Run, name: &str, text: &str| run.file(name, text).json().exits(7).error()["message"].to_string();
    let told = broken(
        plant("apply --yes", [TWO, TWO, ONE]),
        "acu.toml",
        "antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\nnone = 1\n",
    );
    assert!(told.contains("acu.toml:5:1"), "{told}");
    let told = broken(plant("plan", [TWO, TWO, ONE]), "act.toml", "antrieb = 1\n[drive\n");
    assert!(told.contains("act.toml:2:"), "{told}");
    assert!(stored().is_empty(), "nothing was opened");
    for (text, told) in [
        ("[drives.a]\naddress = 1\nfiles = [\"act.toml\", \"none.toml\"]\n", "antrieb.toml:3:22: there is no file"),
        ("[drives.a]\naddress = 1\nfile = \"act.toml\"\n", "antrieb.toml:3:1: unknown field `file`"),
        (
            "[drives.a]\naddress = 1\n[drives.b]\naddress = 1\n",
            "antrieb.toml:4:1: drives a and b have the same address 1",
        ),
        ("[drives.a]\naddress = 1\n[groups]\ng1 = []\n", "antrieb.toml:4:1: the group g1 has no drives"),
        ("[drives.a]\naddress = 1\n[groups]\nall3 = [\"a\", \"c\"]\n", "antrieb.toml:4:14: there is no drive 'c'"),
        (
            "[ports.x]\npath = \"sim\"\n[drives.a]\naddress = 1\nport = \"y\"\n",
            "antrieb.toml:5:1: there is no port 'y'",
        ),
        ("[drives.all]\naddress = 1\n", "antrieb.toml:1:9: `all`, `@group` and lists"),
        ("[drives.a]\naddress = 1\n", "no parameter files, and not looked at: a"),
        (
            "port = \"sim\"\n[drives.a]\naddress = 1\nfiles = [\"act.toml\"]\n[drives.b]\naddress = 2\nbaud = 9600\nfiles = [\"acu.toml\"]\n",
            "antrieb.toml:5:9: b is at 9600 8E1 rtu, a on the same port at 19200 8E1 rtu",
        ),
    ] {
        let failure =
            with(antrieb("-p sim plan"), text, [TWO, TWO, ONE]).json().exits(7).error()["message"].to_string();
        assert!(failure.replace("\\\"", "\"").contains(told), "{told}: {failure}");
        let german = with(antrieb("--lang de -p sim plan"), text, [TWO, TWO, ONE]);
        german.exits(7);
    }
}

#[test]
fn all_and_groups_go_with_every_verb_of_one_line() {
    let rows = |line: &str| {
        let read = plant(line, [TWO, TWO, ONE]).json().exits(0);
        let rows = read.data("/values").as_array().unwrap().clone();
        rows.iter().map(|row| row["address"].as_u64().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(rows("-a all -p sim:{dir}/left.bench read 372@1"), [1, 2]);
    assert_eq!(rows("-a @ones -p sim:{dir}/middle.bench read 372@1"), [1]);
    assert_eq!(rows("-a a2,a1,@ones -p sim:{dir}/left.bench read 372@1"), [2, 1]);
    let refused = plant("-a all statemachine enable --yes", [TWO, TWO, ONE]).exits(2).err;
    assert!(refused.contains("is not on the line of the others"), "{refused}");
    assert!(refused.contains("every stop goes over all"), "{refused}");
    let several = plant("-a all -p sim:{dir}/left.bench statemachine enable --yes", [TWO, TWO, ONE]).exits(2).err;
    assert!(several.contains("one drive"), "{several}");
    for (line, told) in [
        ("-a @none plan", "there is no group 'none'"),
        ("-a a1,7 plan", "got '7'"),
        ("-a all -p sim plan", "names no such drive at sim"),
        ("-a @ones -p sim read 372", "names no such drive at sim"),
    ] {
        let refused = plant(line, [TWO, TWO, ONE]).exits(2).err;
        assert!(refused.contains(told), "{line}: {refused}");
    }
    let refused = antrieb("-a all -p sim read 372").exits(2).err;
    assert!(refused.contains("no drive has a name"), "{refused}");
}

#[test]
fn init_writes_what_it_found_and_replaces_nothing_unasked() {
    let bench = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive]]\nmodel = \"lxm05\"\naddress = 3\n\
                 [[drive]]\nmodel = \"foreign\"\naddress = 9\nregisters = { \"0\" = 17 }\n";
    for lang in ["en", "de"] {
        let written = antrieb(&format!("-a 1-9 --lang {lang} init")).on(bench).exits(0);
        let text = written.text_of("antrieb.toml");
        for part in [
            "[ports.bench]",
            "[drives.act-1]",
            "address = 3\ndrive = \"lxm05\"",
            "# files = [\"base.toml\", \"act-1.toml\"]",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        let unknown = if lang == "en" { "# address 9 at" } else { "# Adresse 9 an" };
        assert!(text.contains(unknown), "{text}");
        let again = written.then("-a 1 -p sim:{dir}/bench.toml init").exits(7);
        assert!(again.err.contains("--force replaces it"), "{}", again.err);
        assert_eq!(again.text_of("antrieb.toml"), text);
        let forced = again.then("-a 1 -p sim:{dir}/bench.toml --force init").exits(0);
        assert!(!forced.text_of("antrieb.toml").contains("lxm05"));
        let read = forced.then("-a act-1 read 372@1").exits(0);
        let none = read.then("plan").exits(7);
        assert!(none.err.contains("no parameter files, and not looked at: act-1"), "{}", none.err);
    }
    let nobody = antrieb("-a 3-5 init").on(TWO).exits(1);
    assert!(!nobody.directory().join("antrieb.toml").exists());
}

#[test]
fn init_searches_for_the_drives_that_were_named() {
    let config = "port = \"sim:{dir}/left.bench\"\n[drives.fan]\naddress = 1\n[drives.pump]\naddress = 2\n\
                  [groups]\none = [\"fan\"]\n";
    for who in ["fan", "@one", "1"] {
        let run = antrieb(&format!("-a {who} init {{dir}}/new.toml"));
        let text = with(run, config, [TWO, TWO, ONE]).exits(0).text_of("new.toml");
        assert!(text.contains("address = 1\n") && !text.contains("address = 2"), "{who}: {text}");
    }
}

/// Every command of docs/plant.md, each in a directory of its own.
#[test]
fn the_commands_of_the_page_work() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/plant.md")).unwrap();
    let commands: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("    antrieb ")).collect();
    assert!(commands.len() > 7, "{commands:?}");
    let config = "port = \"sim\"\n[drives.act-1]\naddress = 1\nfiles = [\"act.toml\"]\n[drives.pump]\nport = \"sim:{dir}/left.bench\"\n\
                  address = 1\nfiles = [\"act.toml\"]\n[groups]\nwater = [\"pump\"]\n";
    let undo = "antrieb = 1\ndrive.family = \"act\"\nvalues.372 = 1390\n[undo]\nvalues = { 372 = 1440 }\n";
    for command in commands {
        let words = command
            .split(' ')
            .map(|word| if word.ends_with(".toml") { format!("{{dir}}/{word}") } else { word.to_owned() });
        let run = antrieb(&words.collect::<Vec<_>>().join(" "));
        let run = if command.contains("init") { run } else { with(run, config, [TWO, TWO, ONE]) };
        let ended = run.file("pump.undo.toml", undo).run();
        assert!(ended.exit < 2, "{command}: exit {}\n{}\n{}", ended.exit, ended.out, ended.err);
    }
    // And the example of a project file is one.
    let example = page.split("```toml\n").nth(1).unwrap().split("```").next().unwrap();
    let run = antrieb("-a @water plan --dry-run").file("antrieb.toml", example);
    let base = ["base.toml", "pump.toml", "fan.toml"];
    base.into_iter().fold(run, |run, name| run.file(name, ACT)).exits(0);
}

/// One file for several drives holds the address of one of them.
#[test]
fn what_goes_in_only_by_its_name_is_told_where_nothing_else_is_to_do() {
    let held = ACT.replace("[values]\n", "[values]\n\"1376\" = 9\n");
    let same = "[[drive]]\nmodel = \"act\"\naddress = 1\nset = { \"372@1\" = 1440, \"480@2\" = 20 }\n";
    let on = |line: &str| plant(line, [same, TWO, ONE]).file("act.toml", &held);
    for verb in ["plan", "apply --yes"] {
        let nothing = on(&format!("-a a1 {verb}")).exits(0);
        assert!(nothing.out.contains("left out until named  1376"), "{}", nothing.out);
    }
    let drift = on("-a a1 check").exits(1);
    assert!(drift.err.contains("-a a1 plan --only 1376`") && !drift.err.contains("would bring back"), "{}", drift.err);
    let both = plant("-a a1 check", [TWO, TWO, ONE]).file("act.toml", &held).exits(1);
    assert!(both.err.contains("plan --only 1376`") && both.err.contains("would bring back"), "{}", both.err);
    let motor = plant("-a a1 check --only motor --sets 1", [TWO, TWO, ONE]).exits(1);
    assert!(motor.err.contains("-a a1 apply --only motor --sets 1-1` would bring back"), "{}", motor.err);
}
