//! Named drives, configuration files, environment, language: who beats whom.

use crate::run::{Run, antrieb};

/// What `read 372` says of the port, address and language that it worked with.
#[track_caller]
fn taken(run: Run) -> (String, String, String) {
    let document = run.json().exits(0);
    let text = |pointer: &str| document.data(pointer).to_string().trim_matches('"').to_owned();
    (text("/values/0/drive"), text("/values/0/address"), text("/values/0/name"))
}

fn strings(expected: [&str; 3]) -> (String, String, String) {
    let [a, b, c] = expected.map(str::to_owned);
    (a, b, c)
}

const PUMP: &str = "port = \"sim\"\n[drives.pump]\naddress = 2\n[drives.fan]\naddress = 1\ndrive = \"act\"\n";

#[test]
fn a_named_drive_saves_typing() {
    let run = || antrieb("-a pump read 372").file("antrieb.toml", PUMP);
    assert_eq!(taken(run()), strings(["acu", "2", "Rated Speed"]));
    assert_eq!(taken(antrieb("-a fan read 372").file("antrieb.toml", PUMP)), strings(["act", "1", "Rated Speed"]));
    let own = "[drives.pump]\naddress = 2\nport = \"sim\"\nprotocol = \"rtu\"\nbaud = 19200\nparity = \"even\"\n";
    assert_eq!(taken(antrieb("-a pump read 372").file("antrieb.toml", own)), strings(["acu", "2", "Rated Speed"]));
}

#[test]
fn a_name_that_nobody_gave_is_told_with_those_that_are_there() {
    let document = antrieb("-a pimp read 372").file("antrieb.toml", PUMP).json().exits(2);
    let message = document.error()["message"].as_str().unwrap();
    assert!(message.contains("fan, pump"), "{message}");
}

#[test]
fn the_only_drive_of_a_project_needs_no_name() {
    let one = "port = \"sim\"\n[drives.pump]\naddress = 2\n";
    assert_eq!(taken(antrieb("read 372").file("antrieb.toml", one)), strings(["acu", "2", "Rated Speed"]));
    antrieb("--yes write 480@1=6").file("antrieb.toml", one).json().exits(0);
    antrieb("--yes write 480@1=6").file("antrieb.toml", PUMP).json().exits(2);
}

#[test]
fn flag_beats_environment_beats_project_beats_user() {
    let project = "port = \"sim\"\naddress = \"2\"\nlang = \"de\"\n";
    let user = "port = \"/dev/antrieb-has-no-such-port\"\naddress = \"1\"\nlang = \"en\"\n";
    let run = |line: &str| antrieb(line).user_file("config.toml", user).file("antrieb.toml", project);
    assert_eq!(taken(run("read 372")), strings(["acu", "2", "Bemessungsdrehzahl"]));
    assert_eq!(taken(run("-a 1 --lang en read 372")), strings(["act", "1", "Rated Speed"]));
    run("read 372").variable("ANTRIEB_PORT", "/dev/antrieb-has-no-such-port").json().exits(3);
    assert_eq!(taken(run("-p sim read 372").variable("ANTRIEB_PORT", "/dev/no")).0, "acu");
    assert_eq!(taken(run("--no-config -p sim read 372")), strings(["act", "1", "Rated Speed"]));
    let only_user = antrieb("read 372").user_file("config.toml", "port = \"sim\"\naddress = \"1\"\nlang = \"de\"\n");
    assert_eq!(taken(only_user), strings(["act", "1", "Bemessungsdrehzahl"]));
    assert_eq!(taken(antrieb("read 372 -a 1").variable("ANTRIEB_PORT", "sim")).0, "act");
}

#[test]
fn another_project_file_may_be_named() {
    let run = antrieb("--config other/line.toml read 372").file("other/line.toml", "port = \"sim\"\naddress = \"2\"\n");
    assert_eq!(taken(run).1, "2");
    antrieb("--config none.toml read 372").json().exits(7);
    antrieb("--config none.toml --no-config read 372").json().exits(2);
}

#[test]
fn the_locale_chooses_the_language() {
    let name = |variables: &[(&str, &str)]| {
        let run =
            variables.iter().fold(antrieb("-p sim -a 1 read 372"), |run, (name, value)| run.variable(name, value));
        taken(run).2
    };
    assert_eq!(name(&[]), "Rated Speed");
    for german in ["de_DE.UTF-8", "de_AT", "de", "de_CH@euro"] {
        assert_eq!(name(&[("LANG", german)]), "Bemessungsdrehzahl", "{german}");
    }
    for other in ["C", "POSIX", "en_US.UTF-8", "fr_FR", "den_CA"] {
        assert_eq!(name(&[("LANG", other)]), "Rated Speed", "{other}");
    }
    assert_eq!(name(&[("LANG", "de_DE"), ("LC_MESSAGES", "en_US")]), "Rated Speed");
    assert_eq!(name(&[("LC_MESSAGES", "en_US"), ("LC_ALL", "de_DE")]), "Bemessungsdrehzahl");
    assert_eq!(name(&[("LC_ALL", ""), ("LANG", "de_DE")]), "Bemessungsdrehzahl", "an empty variable is not set");
    let help = antrieb("read --help").variable("LANG", "de_DE").exits(0).out;
    assert!(help.contains("Reads parameters"), "help is English");
}

#[test]
fn errors_in_configurations_name_file_line_and_column() {
    for (text, place) in [
        ("port = \"sim\"\nspeed = 1\n", "antrieb.toml:2:1"),
        ("port = \"sim\"\n[drives.pump]\naddress = 999\n", "antrieb.toml:3:11"),
        ("port = ", "antrieb.toml:1:"),
        ("[drives.pump]\ncolour = 1\naddress = 1\n", "antrieb.toml:2:1"),
    ] {
        let document = antrieb("-p sim -a 1 read 372").file("antrieb.toml", text).json().exits(7);
        let message = document.error()["message"].as_str().unwrap();
        assert!(message.contains(place), "{place}: {message}");
    }
}

#[test]
fn values_in_configurations_are_held_to_the_same_rules() {
    for text in [
        "baud = 5\n",
        "parity = \"mark\"\n",
        "timeout = \"soon\"\n",
        "lang = \"fr\"\n",
        "protocol = \"profibus\"\n",
        "port = \"tcp://x\"\n",
        "stop_bits = 3\n",
    ] {
        let document = antrieb("-a 1 read 372").file("antrieb.toml", text).json();
        assert_eq!((document.exit, &document.error()["code"]), (7, &"data.config".into()), "{text}");
    }
    let run = antrieb("-p sim -a 1 read 372").file("antrieb.toml", "format = \"xml\"\n").exits(7);
    assert!(run.err.contains("expected table, json, ndjson, csv, influx or openmetrics, got 'xml'"), "{}", run.err);
    let json = antrieb("-p sim -a 1 read 372").file("antrieb.toml", "format = \"json\"\n").exits(0);
    assert!(json.out.starts_with('{'), "{}", json.out);
}

#[test]
fn yes_never_comes_from_a_file_or_the_environment() {
    antrieb("-p sim -a 1 write 480@1=6").file("antrieb.toml", "yes = true\n").json().exits(7);
    antrieb("-p sim -a 1 write 480@1=6").variable("ANTRIEB_YES", "1").json().exits(8);
}

#[test]
fn hostile_names_in_a_project_file_are_escaped() {
    let hostile = "[drives.\"\\u001b[31mred\"]\naddress = 1\n[drives.b]\naddress = 2\n";
    let run = antrieb("-p sim -a nope read 372").file("antrieb.toml", hostile).exits(2);
    assert!(!run.err.contains('\u{1b}'), "{:?}", run.err);
    assert!(run.err.contains("\\u{1b}[31mred"), "{}", run.err);
}

#[test]
fn what_holds_is_told_with_where_it_comes_from() {
    let file = "retries = 1\n[drives.pump]\naddress = 2\ndrive = \"acu\"\n";
    let run = antrieb("-p sim -v read 411").file("antrieb.toml", file).exits(0);
    for told in ["port sim (command line)", "address 2 (antrieb.toml: drives.pump)", "retries 1 (antrieb.toml)"] {
        assert!(run.err.contains(told), "{told}\n{}", run.err);
    }
    assert!(run.err.contains("baud 19200 (default)") && run.err.contains("drive acu (antrieb.toml: drives.pump)"));
}

#[test]
fn a_bad_setting_names_the_file_that_it_stands_in() {
    for (slip, told) in [
        ("drive = \"acx\"", "antrieb.toml:2:1: `drive`: unknown drive 'acx'"),
        ("parity = \"mark\"", "antrieb.toml:2:1: `parity`: "),
        (
            "baud = 19201",
            "antrieb.toml:2:1: `baud`: expected 300 to 1250000, but nothing right beside a usual speed; got 19201 (perhaps 19200",
        ),
        ("data_bits = 9", "antrieb.toml:2:1: `data_bits`: "),
    ] {
        // The values of a parity are words of the command line.
        for lang in ["en", "de"].into_iter().filter(|lang| *lang == "en" || !slip.contains("mark")) {
            let file = format!("# one slip\n{slip}\n");
            let run = antrieb(&format!("-p sim -a 1 --lang {lang} read 411")).file("antrieb.toml", &file).exits(7);
            assert!(lang == "de" || run.err.contains(told), "{}", run.err);
            let of_drive = format!("[drives.pump]\naddress = 1\n{slip}\nfiles = [\"pump.toml\"]\n");
            for line in ["-a pump read 411", "plan"] {
                let run = antrieb(&format!("-p sim --lang {lang} {line}")).file("antrieb.toml", &of_drive);
                let run =
                    run.file("pump.toml", "antrieb = 1\ndrive.family = \"act\"\n[values]\n\"480\" = 5\n").exits(7);
                assert!(run.err.contains("antrieb.toml:3:1: "), "{slip} {line}: {}", run.err);
            }
        }
    }
    // A speed that no line could tell from a usual one; an unusual one is taken.
    assert!(antrieb("-p sim -a 1 -b 9601 read 411").exits(2).err.contains("got 9601 (perhaps 9600 is meant)"));
    assert!(!antrieb("-p sim -a 1 -b 12500 read 411").run().err.contains("expected"));
}

#[test]
fn a_family_that_is_not_that_of_its_files_is_a_slip_in_the_project_file() {
    let project = "[drives.pump]\naddress = 1\nfiles = [\"pump.toml\"]\ndrive = \"acu\"\n";
    let plan = |line: &str| {
        let run = antrieb(line).file("antrieb.toml", project);
        run.file("pump.toml", "antrieb = 1\ndrive.family = \"act\"\n[values]\n\"480\" = 5\n")
    };
    for line in ["plan", "apply --yes", "check"] {
        let err = plan(&format!("-p sim {line}")).exits(7).err;
        assert!(
            err.contains("antrieb.toml:4:1: `drive`: 'acu' is stated, and") && err.contains("family 'act'"),
            "{err}"
        );
        plan(&format!("-p sim --lang de {line}")).exits(7);
    }
}

/// Drive 1 was meant, and drive 2 would start.
#[test]
fn the_name_of_a_drive_never_reads_as_an_address() {
    for name in ["1", "0", "1-3", "1,2", "3.17"] {
        let file = format!("port = \"sim\"\n[drives.\"{name}\"]\naddress = 2\n");
        let refused = antrieb(&format!("-a {name} read 372")).file("antrieb.toml", &file).exits(7);
        assert!(
            refused.err.contains("antrieb.toml:2:") && refused.err.contains("reads as an address"),
            "{}",
            refused.err
        );
    }
    // The line is that of the drive itself.
    let second = "port = \"sim\"\n[drives.fan]\naddress = 2\n[drives.7]\naddress = 3\n";
    let refused = antrieb("-a fan read 372").file("antrieb.toml", second).exits(7);
    assert!(refused.err.contains("antrieb.toml:4:"), "{}", refused.err);
    let bare = "port = \"sim\"\n[drives.Pumpe Nord]\naddress = 2\n";
    let refused = antrieb("-a fan read 372").file("antrieb.toml", bare).exits(7);
    assert!(refused.err.contains("antrieb.toml:2:") && refused.err.contains("in quotes"), "{}", refused.err);
    let pump2 = "port = \"sim\"\n[drives.\"2nd\"]\naddress = 2\n";
    assert_eq!(taken(antrieb("-a 2nd read 372").file("antrieb.toml", pump2)), strings(["acu", "2", "Rated Speed"]));
}
