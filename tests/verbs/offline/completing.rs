//! `complete`, which the completion scripts call: what could stand where somebody types.

use crate::run::{Run, antrieb};

const PLANT: &str = "[drives.pump]\naddress = 1\ndrive = \"act\"\n[drives.fan]\naddress = 2\ndrive = \"acu\"\n\
                     [drives.servo]\naddress = 3\ndrive = \"lxm05\"\n";

fn asked(typed: &str) -> Run {
    antrieb(&format!("complete bash -- {typed}")).file("antrieb.toml", PLANT)
}

#[track_caller]
fn candidates(typed: &str) -> Vec<String> {
    let ended = asked(typed).exits(0);
    assert_eq!(ended.err, "", "{typed}");
    ended.out.lines().filter(|line| !line.starts_with('\t')).map(str::to_owned).collect()
}

/// Over PROFIBUS those of its inverters: whose drive is not named is taken for one of them there as well.
#[test]
fn over_profibus_the_parameters_of_its_inverters_are_offered() {
    for (verb, whole) in [
        ("sollwert 10Hz --set F00", "F002="),
        ("read F00", "F002"),
        ("monitor acceleration-t", "acceleration-time-2"),
        ("write F00", "F002="),
    ] {
        for line in ["--protocol dp", "--drive sj200 --protocol dp", "--protocol dp --drive l200"] {
            let found = candidates(&format!("{line} {verb}"));
            assert!(found.iter().any(|found| found == whole), "{line} {verb}: {found:?}");
        }
    }
    assert_eq!(candidates("--protocol dp sollwert 10Hz --set rated-mech"), [""; 0]);
    assert_eq!(candidates("--protocol dp --drive act sollwert 10Hz --set rated-mech"), ["rated-mechanical-power="]);
}

#[test]
fn every_kind_of_value_is_completed() {
    for (typed, whole) in [
        ("read rated-sp", "rated-speed"),
        ("read 37", "372"),
        ("read @act", "@actual"),
        ("read 372@2", "372@2"),
        ("read rated-speed@al", "rated-speed@all"),
        ("monitor @mod", "@modbus"),
        ("dataset copy 1 2 @mot", "@motor"),
        ("params rated-sp", "rated-speed"),
        ("write rated-sp", "rated-speed="),
        ("write 395=modbus-r", "395=modbus-rtu"),
        ("write 395 modbus-r", "modbus-rtu"),
        ("--drive lxm05 read _p_a", "_p_act"),
        ("-a servo read _p_a", "_p_act"),
        ("sollwert --mode fre", "frequency"),
        ("statemachine goto op", "operation-enabled"),
        ("state goto op", "operation-enabled"),
        ("protocol set a", "ascii"),
        ("schema sta", "statemachine"),
        ("procedure f", "first-contact"),
        ("procedure li", "list"),
        ("procedure commission pow", "power="),
        ("dataset select 2", "2"),
        ("dataset copy 1 3", "3"),
        ("decode fault F201", "F2010"),
        ("-a p", "pump"),
        ("-a pump,f", "pump,fan"),
        ("-p si", "sim"),
        ("read --port=si", "--port=sim"),
        ("--drive lx", "lxm05"),
        ("read --format nd", "ndjson"),
        ("line set --parity o", "odd"),
        ("dataset load --only mo", "motor"),
        ("dataset load --except ramps,mot", "ramps,motor"),
        ("write 480 5 395 modbus-r", "modbus-rtu"),
        ("write 480 5 rated-sp", "rated-speed="),
        ("-psi", "-psim"),
        ("--lang de read Bemessungsdreh", "bemessungsdrehzahl"),
    ] {
        assert!(candidates(typed).iter().any(|found| found == whole), "{typed}: {:?}", candidates(typed));
    }
}

/// The named drive decides whose names are offered; without one all are.
#[test]
fn the_names_are_those_of_the_chosen_drive() {
    assert!(candidates("-a servo read rated-sp").is_empty());
    assert!(candidates("--drive act read _p_a").is_empty());
    assert!(!candidates("read _p_a").is_empty() && !candidates("read rated-sp").is_empty());
}

/// No PowerShell runs here: its script is held to what it must do. It asks the program that was typed, with the words behind it
/// as they stand, and says when a new word begins; what it asks is what is answered.
#[test]
fn the_script_for_powershell_asks_with_the_words_that_are_understood() {
    let script = antrieb("completions powershell").exits(0).out;
    let call = script.lines().map(str::trim).find(|line| line.contains("& $typed[0]")).unwrap();
    assert_eq!(call, "$found = @(& $typed[0] complete powershell @next '--' @behind 2>$null)");
    for line in [
        "Register-ArgumentCompleter -Native -CommandName 'antrieb' -ScriptBlock {",
        "param($wordToComplete, $commandAst, $cursorPosition)",
        "$next = @(if ($wordToComplete -eq '') { '--next' })",
        "$value, $told = $_ -split \"`t\", 2",
    ] {
        assert_eq!(script.matches(line).count(), 1, "{line}");
    }
    let asks = script.find(call).unwrap();
    assert!(asks < script.find("$completions = @(switch").unwrap(), "values come before the table of options");
    // Every bracket that is opened is closed, outside of texts.
    for (open, close) in [('{', '}'), ('(', ')'), ('[', ']')] {
        let bare: String = script.lines().map(|line| outside_of_quotes(line.trim())).collect();
        assert_eq!(bare.matches(open).count(), bare.matches(close).count(), "{open}{close}");
    }
    let asked = call.split("$typed[0] ").nth(1).unwrap().split(" 2>").next().unwrap();
    for (next, behind, first) in [("", "read rated-sp", "rated-speed\t"), ("--next", "read", "@actual\t")] {
        let line = asked.replace("@next", next).replace("'--'", "--").replace("@behind", behind);
        let told = antrieb(&line).exits(0).out;
        assert!(told.starts_with(first), "{line}: {told}");
    }
}

/// A line of PowerShell without its texts and comments.
fn outside_of_quotes(line: &str) -> String {
    let (mut quote, mut bare) = (None, String::new());
    for letter in line.chars() {
        match quote {
            None if letter == '#' => break,
            None if matches!(letter, '\'' | '"') => quote = Some(letter),
            None => bare.push(letter),
            Some(open) if open == letter => quote = None,
            Some(_) => {}
        }
    }
    bare
}

/// What stands there already is not offered once more, and what nobody but who types knows is not offered at all.
#[test]
fn a_candidate_is_offered_once() {
    assert_eq!(candidates("-a pump,"), ["pump,fan", "pump,servo", "pump,all"]);
    assert_eq!(candidates("dataset select ''"), ["1", "2", "3", "4", "0"]);
    let open = candidates("procedure commission power=2.2kW ''");
    assert!(open.contains(&"voltage=".to_owned()) && !open.contains(&"power=".to_owned()), "{open:?}");
    for nothing in ["procedure commission power=", "procedure list ''", "procedure nonsense ''"] {
        assert_eq!(candidates(nothing), [""; 0], "{nothing}");
    }
}

/// A completion that has nothing to say, or cannot, is silent: it stands in somebody's command line.
#[test]
fn what_cannot_be_completed_is_left_to_the_shell() {
    for typed in [
        "decode trace fi",
        "diag li",
        "read --ba",
        "nonsense x",
        "read rated-speed --trace /tm",
        "--drive nobody read 3",
    ] {
        let ended = asked(typed).exits(0);
        assert!(ended.err.is_empty(), "{typed}: {}", ended.err);
    }
    let broken = antrieb("complete bash -- read rated-sp").file("antrieb.toml", "this is no TOML").exits(0);
    assert_eq!((broken.out.as_str(), broken.err.as_str()), ("rated-speed\n", ""));
    let told = antrieb("complete zsh -- read rated-sp").exits(0).out;
    assert_eq!(told, "rated-speed\t372 Rated Speed\n");
    let bare = antrieb("complete fish -- read --port=si").exits(0).out;
    assert!(bare.starts_with("sim\t"), "fish keeps the option itself: {bare}");
    let next = antrieb("complete powershell --next -- read").exits(0).out;
    assert!(next.starts_with("@actual\t"), "{next}");
}

/// What a shell finds to be the beginning of everything that is offered it types: of a value that would be another value.
#[test]
fn no_character_is_added_to_a_value() {
    for typed in [
        "write 480=",
        "write 372=",
        "write rated-speed=",
        "write 480@2=",
        "write 376@4=",
        "write 480=-",
        "write 480 ''",
        "write 480 -",
        "write 395=",
        "write 395=1",
        "write 13",
        "read 13",
        "read 480@2",
        "write 48@1",
        "-a @",
        "-a1",
        "sollwert ''",
        "sollwert -5",
        "sollwert --duration ''",
    ] {
        let (next, words) = typed.strip_suffix(" ''").map_or(("", typed), |words| ("--next", words));
        let typed_last = if next.is_empty() { words.rsplit(' ').next().unwrap_or_default() } else { "" };
        let offered = antrieb(&format!("complete bash {next} -- {words}")).exits(0).out;
        let mut offered: Vec<_> = offered.lines().filter(|line| !line.starts_with('\t')).collect();
        offered.sort_unstable();
        let (Some(first), Some(last)) = (offered.first(), offered.last()) else { continue };
        let common: String = first.chars().zip(last.chars()).take_while(|(a, b)| a == b).map(|(a, _)| a).collect();
        assert_eq!(common, typed_last, "{typed}: {offered:?}");
    }
}

/// Where a value stands that the program cannot offer it says whether a file can be it; options and verbs know the scripts.
#[test]
fn a_shell_is_told_where_a_value_stands() {
    for (typed, told) in [
        ("write 480=", "\tnothing\n"),
        ("-a @", "\tnothing\n"),
        ("sollwert 5", "\tnothing\n"),
        ("write 480 -5", "\tnothing\n"),
        ("dataset load b", "\tfiles\n"),
        ("dataset undo b", "\tfiles\n"),
        ("dataset diff b", "\tfiles\n"),
        ("plot b", "\tfiles\n"),
        ("--trace=b", "\tfiles\n"),
        ("--port=sim:b", "\tfiles\n"),
        ("--port=tcp://h", "\tnothing\n"),
        ("read --ba", ""),
        ("datas", ""),
    ] {
        let ended = antrieb(&format!("complete zsh -- {typed}")).exits(0);
        assert_eq!(ended.out, told, "{typed}");
    }
}
