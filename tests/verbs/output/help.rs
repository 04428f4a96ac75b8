//! What the help says: short enough for a screen, true, and with examples that work.

use crate::run::antrieb;
use antrieb::command::VERBS;
use std::collections::BTreeSet;

/// Every command with those within it, as it is typed.
fn commands() -> Vec<String> {
    let mut found = vec!["schema".to_owned(), "completions".to_owned()];
    for verb in VERBS {
        found.push(verb.name.to_owned());
        found.extend((verb.command)().get_subcommands().map(|inner| format!("{} {}", verb.name, inner.get_name())));
    }
    found
}

/// Lines of a terminal of 80 x 24, one of which is its prompt.
const SCREEN: usize = 23;

#[test]
fn short_help_has_a_line_for_each_option_and_fits_a_screen() {
    for command in commands() {
        let page = antrieb(&format!("{command} -h")).exits(0).out;
        for line in page.lines() {
            assert!(line.chars().count() <= 80, "{command}: {line}");
        }
        let folded = page.lines().filter(|line| line.starts_with("                  "));
        assert_eq!(folded.count(), 0, "{command}: an option takes two lines\n{page}");
        assert!(page.lines().count() <= SCREEN, "{command}: {} lines\n{page}", page.lines().count());
        let common = page.lines().skip_while(|line| !line.starts_with("Options of every verb")).skip(1);
        assert!(common.take_while(|line| !line.is_empty()).count() <= 10, "{command}\n{page}");
        // Where room is short the setting of the line gives way, and never what every call needs.
        for needed in ["--port", "--address", "--dry-run", "--yes"] {
            let verb = VERBS.iter().find(|verb| command.split(' ').next() == Some(verb.name));
            let is_first = verb.is_some_and(|verb| antrieb(&format!("{} -h", verb.name)).run().out.contains(needed));
            // A part of a verb that has no use for it does not tell it at all.
            let is_offered = || antrieb(&format!("{command} --help")).run().out.contains(needed);
            assert!(!is_first || page.contains(needed) || !is_offered(), "{command} {needed}\n{page}");
        }
    }
}

/// Own options go first, then those of every verb in the order in which they matter; what is left to `--help` is counted.
#[test]
fn what_short_help_leaves_out_is_counted_and_own_options_go_before_common_ones() {
    let is_name =
        |name: &str| name.chars().all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '-');
    let options = |page: &str| -> BTreeSet<String> {
        let lines = page.lines().filter(|line| line.trim_start().starts_with('-'));
        let names = lines.filter_map(|line| line.split("--").nth(1)?.split([' ', '.']).next());
        names.filter(|name| is_name(name)).map(str::to_owned).collect()
    };
    for command in commands() {
        let page = |help: &str| antrieb(&format!("{command} {help}")).exits(0).out;
        let (short, long) = (page("-h"), page("--help"));
        let left: Vec<String> = options(&long).difference(&options(&short)).cloned().collect();
        let said =
            short.split_once("Options of every verb (").and_then(|(_, rest)| rest.split(' ').next()?.parse().ok());
        assert_eq!(said.unwrap_or(0), left.len(), "{command}: {left:?}\n{short}");
        // A common option that gives way stands there only where every own one does, but for those of PROFIBUS.
        let is_common = |name: &str| ["baud", "parity", "lang", "format", "verbose"].contains(&name);
        let own = short.contains(" of them of this verb)");
        let of_profibus = ["gsd", "user-prm", "slot-time", "mode", "cfg"];
        let lacks = left.iter().any(|name| long_of(&long, name) && !of_profibus.contains(&name.as_str()));
        let has_room = short.lines().count() < SCREEN;
        assert!(!(own && lacks && has_room), "{command}: {left:?}\n{short}");
        assert!(!lacks || !options(&short).iter().any(|name| is_common(name)), "{command}: {left:?}\n{short}");
    }
}

/// Whether it stands under the options of the verb itself, or those of a run.
fn long_of(page: &str, name: &str) -> bool {
    let mut heading = "";
    page.lines().any(|line| {
        if !line.starts_with(' ') && line.ends_with(':') {
            heading = line;
        }
        ["Options:", "Run:", "Keypad:"].contains(&heading) && line.trim_start().starts_with(&format!("--{name}"))
    })
}

/// Every command stands in it, by what it is for (`cli::overview`).
#[test]
fn the_help_of_the_program_fits_a_screen() {
    let page = antrieb("-h").exits(0).out;
    assert!(page.lines().count() <= SCREEN, "{} lines\n{page}", page.lines().count());
    assert!(page.lines().all(|line| line.chars().count() <= 80), "{page}");
    for needed in ["--port", "--address", "--dry-run", "--yes", "antrieb --help", "  Motion  statemachine "] {
        assert!(page.contains(needed), "{needed}\n{page}");
    }
}

/// The limit of listening first.
#[test]
fn the_help_of_a_search_says_what_listening_first_does_not_hear() {
    let page = antrieb("scan --help").exits(0).out;
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(page.contains("listened to for 1.25 s") && page.contains("A master who begins later is heard"), "{page}");
}

/// `--duration` everywhere, and `--for` as well.
#[test]
fn how_long_is_asked_by_either_name_everywhere() {
    for line in ["sniff", "simulate", "monitor", "sollwert 0Hz --hold", "statemachine enable --hold"] {
        for option in ["--duration", "--for"] {
            let wrong = antrieb(&format!("-p sim -a 1 {line} {option} soon")).exits(2).err;
            assert!(wrong.contains("'soon' does not fit '--duration <TIME>'"), "{line} {option}: {wrong}");
        }
    }
}

#[test]
fn long_help_tells_all_that_a_verb_takes_and_short_help_nothing_else() {
    for verb in VERBS {
        let [short, long] = ["-h", "--help"].map(|help| antrieb(&format!("{} {help}", verb.name)).exits(0).out);
        for (option, flag) in [("port", "--port"), ("baud", "--baud"), ("trace", "--trace"), ("drive", "--drive")] {
            assert_eq!(long.contains(&format!("{flag} <")), verb.takes.offers(option), "{} {flag}", verb.name);
            assert!(!short.contains(&format!("{flag} <")) || verb.takes.offers(option), "{} {flag}", verb.name);
        }
    }
}

/// Behind the verb what it has no use for is refused; before it settings are those of the bus. What would have to
/// happen and will not is refused in both places.
#[test]
fn an_option_without_use_is_refused_behind_its_verb() {
    for line in [
        "params --baud 9600",
        "params -p sim 372",
        "params 372 --parity=even",
        "params -a 1",
        "decode status 0x0237 --timeout 1s",
        "decode --port sim status 0x0237",
        "simulate --drive act",
        "simulate --dry-run",
        "--dry-run simulate",
        "schema --baud 9600",
        "completions bash -b 9600",
        "--trace {dir}/x params 372",
        "params --trace {dir}/x",
        "--trace {dir}/x schema",
    ] {
        let english = antrieb(line).exits(2);
        assert!(english.err.starts_with("error: `") && english.err.contains("has no use for --"), "{}", english.err);
        assert!(english.err.contains("\nhint: "), "{}", english.err);
        let german = antrieb(&format!("--lang de {line}")).exits(2);
        assert!(german.err.starts_with("Fehler: `"), "{}", german.err);
    }
    let document = antrieb("params --baud 9600").json().exits(2);
    assert_eq!(document.error()["code"], "usage.no_use");
    for line in
        ["-p sim -b 9600 -a 1 params 372", "--yes --drive act decode status 0x0237", "params 372 --dry-run --yes"]
    {
        antrieb(line).exits(0);
    }
}

/// Every example of every help, each on the bench; ports of its own become the bench or a recording of it.
#[test]
fn every_example_works() {
    let mut examples = BTreeSet::new();
    for command in commands() {
        let page = antrieb(&format!("{command} --help")).exits(0).out;
        let shown: Vec<&str> = page.split("Examples:\n").nth(1).unwrap_or_default().lines().map(str::trim).collect();
        assert!(!shown.is_empty(), "{command} shows no example");
        shown.iter().for_each(|line| assert!(line.chars().count() <= 78, "{command}: {line}"));
        examples.extend(shown.into_iter().filter(|line| !line.is_empty()).map(str::to_owned));
    }
    let recorded = |typed: &str| {
        let run = antrieb(&format!("-p sim --trace {{dir}}/line.txt {typed}")).exits(0);
        std::fs::read_to_string(run.directory().join("line.txt")).unwrap()
    };
    // As somebody hears it who only listens.
    let overheard = |recorded: &str| recorded.replace(" > ", " < ");
    let recorded_dp = overheard(&recorded("--protocol dp -a 3 read F002 --yes"));
    let recorded = recorded("-a 1 read 372");
    let overheard = overheard(&recorded);
    for example in &examples {
        let line = example.strip_prefix("antrieb ").unwrap();
        let line = line.replace("line.txt", "{dir}/line.txt").replace("bench.toml", "{dir}/bench.toml");
        let line = line.replace("list.csv", "{dir}/list.csv").replace("save pump.toml", "save new.toml");
        let line = line.replace("pump.toml", "{dir}/pump.toml").replace("new.toml", "{dir}/new.toml");
        let line = line.replace("'drive-", "'{dir}/drive-");
        let line = line.replace("line.pcap", "{dir}/line.pcap");
        let line = line.replace("pump.html", "{dir}/pump.html");
        let line = line.replace("plant.html", "{dir}/plant.html").replace("plant.md", "{dir}/plant.md");
        let line = line.replace("run.csv", "{dir}/run.csv");
        let line = line.replace("record.csv", "{dir}/record.csv").replace("ramp.svg", "{dir}/ramp.svg");
        let line = line.replace("plant.toml", "{dir}/plant.toml");
        let line = line.replace("mixer.toml", "{dir}/mixer.toml");
        let line = line.replace(" drive.toml", " {dir}/drive.toml").replace("input.svg", "{dir}/input.svg");
        let line = line.replace("bus.toml", "{dir}/bus.toml").replace("bus.svg", "{dir}/bus.svg");
        let line = line.replace("--dcf .", "--dcf {dir}");
        let line = line.replace("base.", "{dir}/base.").replace("extra.toml", "{dir}/extra.toml");
        let line = line.replace("slcan:/dev/ttyACM0", "sim:{dir}/can.toml --protocol sdo");
        let line = line.replace("/dev/ttyUSB0", "tape:{dir}/line.txt").replace("--link drive", "--link {dir}/drive");
        // What is paced by the wall clock need not take its time here.
        let line = line.replace(":5s", ":300ms").replace(" 5s", " 300ms").replace(":5020", ":0");
        let paced = if line.contains("simulate") { line.replace("1m", "20ms") } else { line };
        let paced = if paced.contains("--tcp") { format!("{paced} --for 20ms") } else { paced };
        let bench = "[[drive]]\naddress = 1\nmodel = \"act\"\n";
        let ended = antrieb(&paced)
            .file(
                "line.txt",
                match (example.contains("sniff"), example.contains("--protocol dp")) {
                    (true, true) => &recorded_dp,
                    (true, false) => &overheard,
                    _ => &recorded,
                },
            )
            .file("bench.toml", bench)
            .file("can.toml", "[[drive]]\nmodel = \"acu\"\n[[foreign]]\nframe = \"080#\"\nevery = \"100ms\"\n")
            .file("record.csv", include_str!("../../../docs/examples/record.csv"))
            .file("bus.toml", include_str!("../../../docs/examples/system-bus-setpoint.toml"))
            .file("list.csv", "Nr.;Name\n1500;Head\n")
            .file("pump.toml", "antrieb = 1\ndrive.family = \"act\"\nvalues.372 = 1390\n")
            .file("drive.toml", "antrieb = 1\ndrive.family = \"acu\"\n[values]\n562 = \"1\"\n564 = \"-70.00 %\"\n")
            .file("base.toml", BASE)
            .file("extra.toml", BASE)
            .file("plant.toml", PLANT)
            .file("base.undo.toml", &format!("{BASE}[undo]\nvalues = {{ 372 = 1390 }}\n"))
            .run();
        // Two data sets that differ are an answer, and so is a plan.
        let is_no = [" diff ", " plan", " check"].iter().any(|verb| example.contains(verb));
        let fine = ended.exit == 0 || ended.exit == 1 && is_no;
        assert!(fine, "{example}: exit {}\n{}\n{}", ended.exit, ended.out, ended.err);
    }
}

/// A plant on it.
const PLANT: &str = "[drives.pump]\naddress = 1\nfiles = [\"base.toml\"]\n[groups]\nwater = [\"pump\"]\n";
/// A parameter file for the bench of the examples.
const BASE: &str = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n372 = 1450\n";
