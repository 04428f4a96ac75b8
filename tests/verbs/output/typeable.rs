//! What a hint tells to type works as it stands there: at the port and the drive of the run that it is about.

use crate::parameters::plant::{ONE, TWO, plant};
use crate::run::{Output, antrieb};

const VALUES: &str = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"372@1\" = 1440\n\"480@2\" = \"20 Hz\"\n";
const SILENT: &str = "[[drive]]\nmodel = \"act\"\naddress = 3\n[[drive.event]]\nafter_writes = 1\nsilent = \"10h\"\n";
const RUNNING: &str = "[[drive]]
model = \"act\"
address = 3
set = { \"412\" = 1, \"410\" = 15, \"484\" = 10 }
";

/// The commands that stand in what was said.
fn commands(said: &str) -> Vec<String> {
    let parts = said.split('`').enumerate().filter(|(nth, _)| nth % 2 == 1);
    let commands = parts.filter_map(|(_, part)| part.strip_prefix("antrieb "));
    commands.map(|command| command.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

/// Types what was told; none of it may be told that it is typed wrong.
#[track_caller]
fn type_it(mut output: Output, at_least: &[&str]) {
    let told = commands(&output.err);
    for expected in at_least {
        assert!(told.iter().any(|command| command.contains(expected)), "{expected}: {}", output.err);
    }
    // What is to be written is for people to say.
    for command in told.into_iter().filter(|command| !command.ends_with(" write")) {
        let needs_yes = ["undo", "apply"].iter().any(|verb| command.contains(verb));
        let line = if needs_yes { format!("{command} --yes") } else { command };
        output = output.then(&line).run();
        assert_ne!(output.exit, 2, "antrieb {line}\n{}", output.err);
    }
}

#[test]
fn an_undo_knows_the_drive_that_fell_silent() {
    for lang in ["en", "de"] {
        let line = format!("--lang {lang} -b 19200 -a 3 dataset load {{dir}}/new.toml --yes");
        let torn = antrieb(&line).on(SILENT).file("new.toml", VALUES).exits(9);
        type_it(torn, &["-b 19200 -a 3 dataset undo ", "/new.undo.toml"]);
    }
}

#[test]
fn a_file_with_blanks_in_its_name_is_named_as_a_shell_takes_it() {
    let torn = antrieb("-a 3 dataset load '{dir}/new one.toml' --yes").on(SILENT).file("new one.toml", VALUES).exits(9);
    type_it(torn, &["-a 3 dataset undo '", "/new one.undo.toml'"]);
}

#[test]
fn a_word_for_a_stop_becomes_a_stop_of_this_drive() {
    for line in ["-a 3 stop", "notaus -a 3", "--address=3 halt", "-a 3 statemachine stop", "-a3 -b 19200 quickstop"] {
        let stopped = antrieb(line).on(RUNNING).exits(2);
        let [stop] = &commands(&stopped.err)[..] else { panic!("{}", stopped.err) };
        assert!(stop.contains("-p sim:") && stop.contains("-a 3 ") && stop.ends_with("quick-stop"), "{stop}");
        let stop = stop.clone();
        let stopped = stopped.then(&stop).run();
        assert_ne!(stopped.exit, 2, "{stop}: {}", stopped.err);
    }
}

#[test]
fn a_german_verb_becomes_a_verb_with_all_that_was_typed() {
    for (line, verb) in [
        ("-a 3 schreib 480=5", "-a 3 write 480=5"),
        ("-a 3 lesen 480", "-a 3 read 480"),
        ("suchen --fast", "scan --fast"),
        ("-a 3 schreiben '372@1=1440 1/min'", "-a 3 write '372@1=1440 1/min'"),
    ] {
        let unknown = antrieb(line).on(RUNNING).exits(2);
        assert!(unknown.err.contains("it is `antrieb -p sim:"), "{}", unknown.err);
        type_it(unknown, &[verb]);
    }
}

#[test]
fn a_plant_names_the_drive_that_it_is_about() {
    let running = TWO.replacen(
        "address = 1
",
        "address = 1
set = { \"412\" = 1, \"410\" = 15, \"484\" = 10 }
",
        1,
    );
    for verb in ["plan", "apply --yes"] {
        let told = plant(verb, [&running, TWO, ONE]).exits(9);
        assert!(verb != "plan" || !told.err.contains("was written"), "{}", told.err);
        type_it(told, &["-a a1 statemachine disable"]);
    }
    let other = TWO.replacen("\"act\"", "\"acu\"", 1);
    let told = plant("plan", [&other, TWO, ONE]).exits(9);
    assert!(
        commands(&told.err).iter().any(|scan| scan.starts_with("-p sim:") && scan.ends_with("scan")),
        "{}",
        told.err
    );
}

#[test]
fn failures_of_every_kind_tell_what_works() {
    for (line, commands) in [
        ("-a 77 read 480", &["scan"][..]),
        ("write 480=5", &["scan"]),
        ("-a 3 write 480=5 --type long", &[]),
        ("-a 3 dataset load {dir}/new.toml", &["-a 3 statemachine disable"]),
        ("-a 3 dataset load {dir}/new.undo.toml", &[]),
        ("-a 3 sollwert 0Hz", &[]),
        ("-a 3 --drive act params Drehzal", &[]),
        ("-a 3 sollwert 10Hz --enable --yes", &[]),
    ] {
        let output = antrieb(line).on(RUNNING).file("new.toml", VALUES).run();
        if output.exit != 0 {
            type_it(output, commands);
        }
    }
}

#[test]
fn a_save_that_was_cut_short_goes_on_under_the_name_that_was_typed() {
    let drives = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive]]\nmodel = \"act\"\naddress = 2\n";
    let silent = format!("{drives}[[drive.event]]\nafter_telegrams = 60\nsilent = \"10h\"\n");
    for (name, part) in [("'{dir}/{address}.toml'", "2.toml.part"), ("{dir}", "drive-2.toml.part")] {
        let cut = antrieb(&format!("-a 1,2 dataset save {name}")).on(&silent).exits(9);
        assert!(cut.directory().join(part).exists());
        let [goes_on] = &commands(&cut.err)[..] else { panic!("{}", cut.err) };
        let goes_on =
            goes_on.replace(cut.directory().to_str().unwrap(), "{dir}").replace("-p sim:{dir}/bench.toml ", "");
        assert!(goes_on.contains("-a 1,2 dataset save ") && goes_on.ends_with(" --resume"), "{goes_on}");
        let mut whole = cut.then(&goes_on).on(drives).exits(0);
        assert!(!whole.directory().join(part).exists());
        // What it has left is completed at the drive that it is of, whoever is asked about.
        std::fs::rename(whole.directory().join(part.trim_end_matches(".part")), whole.directory().join(part)).unwrap();
        let text = whole.text_of(part).replace("[saved]\n", "[saved]\ncomplete = false\n");
        std::fs::write(whole.directory().join(part), text).unwrap();
        for line in ["-a 1 dataset load {dir}/", "-a 2 dataset check {dir}/"] {
            let refused = whole.then(&format!("{line}{part} --yes")).on(drives).run();
            let [completes] = &commands(&refused.err)[..] else { panic!("{}", refused.err) };
            let completes = completes
                .replace(refused.directory().to_str().unwrap(), "{dir}")
                .replace("-p sim:{dir}/bench.toml ", "");
            let file = part.trim_end_matches(".part");
            assert!(completes.ends_with(&format!("-a 2 dataset save {{dir}}/{file} --resume")), "{completes}");
            whole = refused;
        }
    }
}
