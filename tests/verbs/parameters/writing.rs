//! `write` and the verbs that write: what is asked, what is sent, how it is proven, and what is never sent.

use crate::run::{Document, antrieb};
use antrieb::protocol::line::LineSetting;
use antrieb::tick::Span;
use antrieb::transport::witness;
use serde_json::{Value, json};

fn results(document: &Document) -> Vec<String> {
    let rows = document.value["data"].get("written").unwrap_or_else(|| document.data("/values"));
    let row = |row: &Value| {
        format!(
            "{}@{} {} {}",
            row["param"],
            row["data_set"],
            row["store"].as_str().unwrap(),
            row["result"].as_str().unwrap()
        )
    };
    rows.as_array().unwrap().iter().map(row).collect()
}

/// Function codes of writes among telegrams in hex.
fn writes(telegrams: &[String]) -> Vec<&String> {
    telegrams.iter().filter(|hex| ["06", "65"].contains(&&hex[3..5])).collect()
}

#[test]
fn without_a_terminal_nothing_is_sent_unless_yes() {
    let run = antrieb("-p sim -a 1 -v write 480@1=6").exits(8);
    assert_eq!(writes(&run.sent()), [""; 0]);
    assert!(run.err.contains("5.00 -> 6.00 Hz, eeprom"), "the question is shown: {}", run.err);
    assert!(run.err.contains("--yes"), "{}", run.err);
    let document = antrieb("-p sim -a 1 write 480@1=6").json().exits(8);
    assert_eq!(document.error()["code"], "forbidden.no_terminal");
    antrieb("-p sim -a 1 --yes write 480@1=6").exits(0);
}

#[test]
fn one_that_is_silent_keeps_the_value_from_all_and_that_is_said() {
    for (lang, nothing) in [("en", "nothing was written"), ("de", "es wurde nichts geschrieben")] {
        let run = antrieb(&format!("-p sim -a 1,9 -v --lang {lang} --yes write 480@1=6")).exits(4);
        assert_eq!(writes(&run.sent()), [""; 0]);
        assert_eq!(run.err.matches(nothing).count(), 1, "{}", run.err);
    }
}

#[test]
fn what_the_same_command_has_changed_before_is_no_unchanged_value() {
    // All sets have 5 Hz.
    let document = antrieb("-p sim -a 1 --yes write 480=6 480@2=5").json().exits(0);
    assert_eq!(results(&document), ["480@0 eeprom verified", "480@2 eeprom verified"]);
}

#[test]
fn what_would_be_overwritten_by_something_behind_it_is_refused() {
    for twice in ["480@2=5 480=6", "481=7 481=10", "482@ram=7 482=25", "480@2=5 480@2=6"] {
        let document = antrieb(&format!("-p sim -a 1 --yes -v write {twice}")).json().exits(2);
        assert_eq!(document.error()["code"], "usage.twice", "{twice}");
    }
    antrieb("-p sim -a 1 --yes write 482=24 482@ram=7 480@1=6 480@2=7").exits(0);
}

#[test]
fn a_no_is_a_no() {
    for answer in ["n", "", "no", "maybe", "j", "yess"] {
        let run = antrieb("-p sim -a 1 -v write 480@1=6").answered(answer).exits(8);
        assert_eq!(writes(&run.sent()), [""; 0], "{answer}");
        assert!(run.err.contains("go on? [y/N]"), "{}", run.err);
        assert!(run.err.contains("not confirmed, nothing was written"), "{}", run.err);
    }
    let document = antrieb("-p sim -a 1 write 480@1=6").answered("n").json().exits(8);
    assert_eq!(document.error()["code"], "forbidden.not_confirmed");
}

/// Who ends the input has typed no newline: what is said next stands on a line of its own all the same.
#[test]
fn the_end_of_the_input_is_a_no_and_the_refusal_begins_a_line() {
    for (lang, said) in [("en", "[y/N] \nerror: not confirmed"), ("de", "[j/N] \nFehler: nicht bestätigt")] {
        let run = antrieb(&format!("-p sim -a 1 --lang {lang} write 480@1=6")).answered_by_the_end().exits(8);
        assert!(run.err.contains(said), "{}", run.err);
    }
}

#[test]
fn a_yes_is_a_yes_in_the_language_of_the_question() {
    for answer in ["y", "Y", "yes", " y "] {
        let run = antrieb("-p sim -a 1 -v write 480@1=6").answered(answer).exits(0);
        assert_eq!(writes(&run.sent()).len(), 1, "{answer}");
    }
    antrieb("-p sim -a 1 --lang de write 480@1=6").answered("j").exits(0);
    antrieb("-p sim -a 1 --lang de write 480@1=6").answered("n").exits(8);
}

#[test]
fn the_question_names_address_family_old_and_new_and_where_it_goes() {
    let run = antrieb("-p sim -a 1 write 480@2=7,5 480@3ram=-12,5Hz").answered("y").exits(0);
    for line in [
        "write 2 values",
        "  drive 1 (act): P.480@2 Fixed Frequency 1: 5.00 -> 7.50 Hz, eeprom",
        "  drive 1 (act): P.480@3 Fixed Frequency 1: 5.00 -> -12.50 Hz, ram",
    ] {
        assert!(run.err.lines().any(|shown| shown == line), "{line}\n{}", run.err);
    }
    assert!(run.err.contains("MOTION") && run.err.contains("EEPROM"), "{}", run.err);
}

#[test]
fn ram_is_the_tools_job() {
    let run = antrieb("-p sim -a 1 --drive act --yes -v write 480@2ram=7.5").exits(0);
    assert_eq!(writes(&run.sent()), ["01 65 71 E0 00 00 02 EE BE DA"]);
    assert!(!run.err.contains("EEPROM"), "{}", run.err);
    for (place, word) in [("ram", "51 E0"), ("@1", "11 E0"), ("@0", "01 E0")] {
        let at = if place.starts_with('@') { place.to_owned() } else { format!("@{place}") };
        let run = antrieb(&format!("-p sim -a 1 --drive act --yes -v write 480{at}=7.5")).exits(0);
        assert_eq!(writes(&run.sent())[0][6..11], *word, "{at}");
    }
    let all = antrieb("-p sim -a 1 --yes write 480@all=7.5").json().exits(0);
    let expected = [1, 2, 3, 4].map(|set| format!("480@{set} eeprom verified"));
    assert_eq!(results(&all), expected);
}

#[test]
fn what_changes_nothing_is_not_sent_and_not_asked() {
    let run = antrieb("-p sim -a 1 -v write 480@1=5 376@4=0.8kW").exits(0);
    assert_eq!(writes(&run.sent()), [""; 0]);
    assert!(!run.err.contains("write "), "no question: {}", run.err);
    let document = antrieb("-p sim -a 1 --yes write 480@1=5 480@2=6").json().exits(0);
    assert_eq!(results(&document), ["480@1 eeprom unchanged", "480@2 eeprom verified"]);
    let forced = antrieb("-p sim -a 1 --yes -v write 480@1=5 --force").exits(0);
    assert_eq!(writes(&forced.sent()).len(), 1);
}

#[test]
fn writes_are_read_back() {
    let run = antrieb("-p sim -a 1 --drive act --yes -v write 480@2=7.5").exits(0);
    let read = "01 64 21 E0 59 DF".to_owned();
    let sent = run.questions();
    assert_eq!((&sent[0], &sent[2]), (&read, &read), "old value before, proof behind: {}", run.err);
    assert_eq!(sent.len(), 3);
}

#[test]
fn what_cannot_be_read_is_written_on_its_echo() {
    let document = antrieb("-p sim -a 2 --yes write 484=10Hz").json().exits(0);
    assert_eq!(results(&document), ["484@0 ram written"]);
    assert_eq!(document.data("/values/0/old"), &Value::Null);
}

#[test]
fn a_lost_echo_is_settled_by_reading() {
    // Old value, echo, proof: the echo is the second reply.
    let lost = "[[drive]]\nmodel = \"act\"\n[[disturb]]\nonce = 2\nkind = \"lost\"\n";
    let document = antrieb("-a 1 --drive act --yes write 480@2=7.5").on(lost).json().exits(0);
    assert_eq!(results(&document), ["480@2 eeprom verified"]);
    let run = antrieb("-a 1 --drive act --yes -v write 480@2=7.5").on(lost).exits(0);
    assert_eq!(writes(&run.sent()).len(), 1, "the drive had it, so it is not sent again: {}", run.err);
}

#[test]
fn what_cannot_be_settled_is_called_unknown() {
    let dead = "[[drive]]\nmodel = \"act\"\n[[drive.event]]\nat = \"163ms\"\nsilent = \"1000s\"\n";
    let document = antrieb("-a 1 --drive act --yes write 480@2=7.5 481@2=8").on(dead).json().exits(4);
    assert_eq!(results(&document), ["480@2 eeprom unknown", "481@2 eeprom skipped"]);
    assert!(document.error()["message"].as_str().unwrap().contains("unknown"), "{}", document.error());
}

#[test]
fn the_first_refusal_skips_the_rest() {
    let document = antrieb("-p sim -a 1 --yes write 480@1=6 376@2=0 481@1=7").json().exits(9);
    assert_eq!(results(&document), ["480@1 eeprom verified", "376@2 eeprom refused", "481@1 eeprom skipped"]);
    assert_eq!(document.error()["class"], "partial");
    assert_eq!(document.data("/values/1/error/context/p11"), "1");
}

#[test]
fn nothing_is_written_anywhere_if_one_of_the_drives_is_silent() {
    let run = antrieb("-p sim -a 1,7 --yes -v write 480@1=6").exits(4);
    assert_eq!(writes(&run.sent()), [""; 0]);
}

#[test]
fn everybody_is_written_to_and_nobody_answers() {
    let run = antrieb("-p sim -a 0 --yes -v write 480=7.5").exits(0);
    assert_eq!(run.sent(), ["00 65 01 E0 00 00 02 EE 74 26"]);
    assert_eq!(run.telegrams('<'), [""; 0]);
    let document = antrieb("-p sim -a 0 --yes write 480=7.5").json().exits(0);
    assert_eq!(document.data("/values/0/result"), "broadcast");
    assert_eq!(document.data("/values/0/address"), 0);
    let run = antrieb("-p sim -a 0 -v write 480=7.5").exits(8);
    assert_eq!(run.sent(), [""; 0]);
    for verb in ["read 372", "scan", "identify", "diag", "statemachine", "sollwert", "dataset active"] {
        antrieb(&format!("-p sim -a 0 {verb}")).json().exits(2);
    }
    antrieb("-p sim -a 0 --yes dataset select 2").json().exits(2);
}

#[test]
fn a_dry_run_opens_nothing_and_prints_the_telegrams() {
    let port = "-p /dev/antrieb-has-no-such-port";
    let run = antrieb(&format!("{port} -a 1 --dry-run write 480@2=7.5 376@4ram=1.5kW")).exits(0);
    assert!(run.out.contains("01 65 21 E0 00 00 02 EE B2 8A"), "{}", run.out);
    assert!(run.out.contains("01 06 91 78 00 0F"), "{}", run.out);
    let document = antrieb(&format!("{port} -a 1,2 --dry-run write 480@2=7.5")).json().exits(0);
    assert_eq!(document.data("/dry_run"), true);
    assert_eq!(results(&document), ["480@2 eeprom planned", "480@2 eeprom planned"]);
    assert_eq!(document.data("/values/1/telegram").as_str().unwrap()[..2], *"02");
    let ascii = antrieb(&format!("{port} -a 1 --protocol ascii --dry-run write 480@2=7.5")).exits(0);
    assert!(ascii.out.contains("3A 30 31 36 35 32 31 45 30"), "{}", ascii.out);
    let run = antrieb(&format!("{port} -a 1 --dry-run write 212=1")).json().exits(7);
    assert!(run.error()["hint"].as_str().unwrap().contains("--type"), "{}", run.error());
}

#[test]
fn values_are_taken_as_technicians_type_them() {
    for (value, raw) in
        [("7.5", 750), ("7,5", 750), ("7.50Hz", 750), ("'7,5 Hz'", 750), ("-120Hz", -12_000), ("0x0F", 15)]
    {
        let document = antrieb(&format!("-p sim -a 1 --yes write 480@1={value}")).json().exits(0);
        assert_eq!(document.data("/values/0/raw"), raw, "{value}");
    }
    for (line, raw) in [("1375=odd", 1), ("1375=Ungerade", 1), ("'10=57600 Bd'", 5), ("376@1=1600W", 16)] {
        let document = antrieb(&format!("-p sim -a 1 --yes write {line}")).json().exits(0);
        assert_eq!(document.data("/values/0/raw"), raw, "{line}");
    }
}

#[test]
fn what_does_not_fit_is_refused_before_anything_is_sent() {
    for (line, code) in [
        ("480@1=1000", "data.range"),
        ("480@1=5A", "data.value"),
        ("480@1=1.234", "data.value"),
        ("480@1=fast", "data.value"),
        ("372@1=70000", "data.width"),
        ("1375=mark", "data.value"),
        ("260=0", "data.read_only"),
        ("nonsense=1", "data.unknown_parameter"),
    ] {
        // The port does not exist: nothing is opened.
        let document = antrieb(&format!("-p /dev/antrieb-has-no-such-port -a 1 --yes write {line}")).json().exits(7);
        assert_eq!(document.error()["code"], code, "{line}");
    }
    antrieb("-p sim -a 1 --yes write 480@1").json().exits(2);
    antrieb("-p sim --yes write 480@1=5").json().exits(2);
}

#[test]
fn force_lets_the_drive_judge() {
    let document = antrieb("-p sim -a 1 --yes write 480@1=1000 --force").json().exits(6);
    assert_eq!(document.error()["context"]["p11"], "1");
    let document = antrieb("-p sim -a 1 --yes write 480@1=99999999 --force --type uint").json().exits(7);
    assert_eq!(document.error()["code"], "data.width", "what no telegram can carry stays refused");
}

#[test]
fn an_unknown_parameter_is_written_raw() {
    let document = antrieb("-p sim -a 1 --yes write 212=1 --type uint").json().exits(6);
    assert_eq!(document.error()["code"], "refused.unknown_parameter");
    let document = antrieb("-p sim -a 1 --yes write 241=0x1 --force").json().exits(6);
    assert_eq!(document.error()["code"], "refused.not_writable", "the width was found by reading");
}

#[test]
fn the_way_back_is_printed_when_the_line_is_cut() {
    let document = antrieb("-p sim -a 1 --yes write 1376=5").json().exits(0);
    assert_eq!(document.warnings(), ["line.changed"]);
    assert_eq!(results(&document), ["1376@0 eeprom verified"]);
    let run = antrieb("-p sim -a 1 --yes write 10=5").exits(0);
    assert!(run.err.contains("LINE: this can cut the line"), "{}", run.err);
    assert!(run.err.contains("after the next reset") && run.err.contains("write 4"), "{}", run.err);
    assert!(run.out.contains("takes effect after a reset"), "{}", run.out);
}

#[test]
fn a_reset_is_announced_and_not_read_back() {
    let run = antrieb("-p sim -a 1 --yes -v write 34=123").exits(0);
    assert!(run.err.contains("RESET"), "{}", run.err);
    assert!(run.sent().last().unwrap().starts_with("01 06 00 22"), "{}", run.err);
}

#[test]
fn data_sets_are_shown_compared_and_selected() {
    let differing = "[[drive]]\nmodel = \"act\"\nset = { \"372@2\" = 1450, \"480@3\" = -12.5 }\n";
    let document = antrieb("-a 1 dataset show 372 376").on(differing).json().exits(0);
    assert_eq!(document.data("/active"), 1);
    assert_eq!(document.data("/selection/param"), 414);
    assert_eq!(document.data("/rows/0/equal"), false);
    assert_eq!(document.data("/rows/0/values/1/value"), 1450);
    assert_eq!(document.data("/rows/1/equal"), true);
    let document = antrieb("-a 1 dataset diff 1 2").on(differing).json().exits(1);
    assert_eq!(document.error()["code"], "no.differences");
    assert_eq!(document.data("/rows").as_array().unwrap().len(), 1);
    assert_eq!(document.data("/rows/0/param"), 372);
    antrieb("-a 1 dataset diff 1 4").on(differing).json().exits(0);
    let equal = antrieb("-a 1 dataset diff 1 4").on(differing).exits(0);
    assert!(equal.err.contains("data sets 1 and 4 are equal in "), "{}", equal.err);
    for bad in ["diff 1 1", "diff 1 5", "diff 0 1", "copy 2 2", "select 5"] {
        antrieb(&format!("-a 1 --yes dataset {bad}")).on(differing).json().exits(2);
    }
    let document = antrieb("-p sim -a 1 --yes dataset select 3").json().exits(0);
    assert_eq!(results(&document), ["414@0 eeprom verified"]);
    assert_eq!(document.data("/active"), 3);
    let document = antrieb("-p sim -a 1 --yes dataset select 3 --ram").json().exits(0);
    assert_eq!(results(&document), ["414@0 ram verified"]);
    antrieb("-p sim -a 1 dataset select 3").json().exits(8);
}

#[test]
fn data_sets_are_copied_as_far_as_they_differ() {
    let differing = "[[drive]]\nmodel = \"act\"\nset = { \"372@2\" = 1450, \"480@2\" = -12.5 }\n";
    let document = antrieb("-a 1 --yes dataset copy 2 3 372 376 480").on(differing).json().exits(0);
    assert_eq!(results(&document), ["372@3 eeprom verified", "376@3 eeprom unchanged", "480@3 eeprom verified"]);
    let document = antrieb("-a 1 --yes dataset copy 2 3 372 --ram").on(differing).json().exits(0);
    assert_eq!(results(&document), ["372@3 ram verified"]);
    let document = antrieb("-a 1 --yes dataset copy 2 3").on(differing).json().exits(0);
    let changed: Vec<_> = results(&document).into_iter().filter(|row| !row.ends_with("unchanged")).collect();
    assert_eq!(changed, ["372@3 eeprom verified", "480@3 eeprom verified"]);
    let run = antrieb("-a 1 -v dataset copy 2 3 372").on(differing).answered("n").exits(8);
    assert_eq!(writes(&run.sent()), [""; 0]);
    // What a copy writes depends on what it reads, and a dry run opens nothing.
    // A parameter that the drive has not: which one, and in which data set.
    let refused = antrieb("-a 1 --yes dataset copy 2 3 372 5").on(differing).exits(6).err;
    assert!(refused.contains("nothing was copied, because 5@2 could not be read: drive 1 refused"), "{refused}");
    antrieb("-p /dev/antrieb-has-no-such-port -a 1 --dry-run dataset copy 2 3 372").json().exits(2);
}

const DRIVE: &str = "[[drive]]\nmodel = \"act\"\n";

/// CM-485 manual 5.2.1: P.34 is a command.
#[test]
fn a_command_is_not_said_to_wear_the_eeprom() {
    let asked = antrieb("-a 1 write 34=1").on(DRIVE).answered("n").exits(8).err;
    assert!(asked.contains("RESET") && !asked.to_lowercase().contains("eeprom"), "{asked}");
}

/// CM-485 manual 5.2.2: P.1376 holds at once; behind it the drive is at another address.
#[test]
fn what_cuts_the_line_goes_last_and_not_beside_another() {
    let run = antrieb("-a 1 --yes write 1376=9 480@1=3Hz 481@1=4Hz").on(DRIVE).json().exits(0);
    let order: Vec<_> = run.data("/values").as_array().unwrap().iter().map(|row| row["param"].clone()).collect();
    assert_eq!(order, [480, 481, 1_376]);
    for both in ["1376=9 395=1", "34=123 1376=9"] {
        let refused = antrieb(&format!("-v -a 1 --yes write {both}")).on(DRIVE).json().exits(2);
        assert_eq!(refused.error()["code"], "usage.cuts", "{both}");
        assert!(!refused.err.contains("> 01 "), "{both}: {}", refused.err);
    }
}

#[test]
fn what_cannot_go_to_everybody_names_the_way_that_can() {
    for (drive, way) in [("act", "-a 0 write 410=0"), ("lxm05", "-a 0 write DCOMcontrol=0")] {
        for verb in ["statemachine disable-voltage", "sollwert 0"] {
            let refused = antrieb(&format!("-a 0 --drive {drive} {verb}")).on(DRIVE).json().exits(2);
            assert!(refused.error()["hint"].as_str().unwrap().contains(way), "{:#}", refused.value);
        }
    }
}

#[test]
fn a_value_that_is_another_one_in_ram_is_no_value_that_stands() {
    for reads in ["eeprom", "in-force"] {
        let bench = format!(
            "[[drive]]\nmodel = \"acu\"\nset = {{ \"480@2\" = 10, \"480@2ram\" = \"12.5\" }}\nreadings = {{ ram_reads = \"{reads}\" }}"
        );
        // What is in force is 12.50 Hz, so 10 Hz is to be written under both readings.
        let back = antrieb("-a 1 --yes write 480@2=10Hz").on(&bench).json().exits(0);
        assert_eq!(back.data("/values/0/result"), "verified", "{reads}");
        let same = antrieb("-a 1 --yes write 480@2=12.5Hz").on(&bench).json().exits(0);
        let told = same.data("/values/0/note").to_string();
        assert_eq!(same.data("/values/0/result") == "unchanged", told.contains("--force stores it"), "{reads}: {told}");
    }
}

/// Told is what selects the data set, not what is stored and does not.
#[test]
fn a_data_set_that_was_selected_in_ram_is_told_as_selected() {
    let selected = antrieb("-p sim -a 1 --yes dataset select 2 --ram").json().exits(0);
    assert_eq!(selected.data("/active"), 2);
    assert_eq!((selected.data("/selection/raw"), selected.data("/selection/store")), (&2.into(), &"ram".into()));
    assert_eq!(selected.data("/selection_stored/raw"), 0);
    let stored = antrieb("-p sim -a 1 dataset active").json().exits(0);
    assert_eq!(
        (stored.data("/selection/raw"), stored.data("/selection_stored")),
        (&0.into(), &serde_json::Value::Null)
    );
}

/// What a row says that it replaces is what stood there, not what was shown a while ago.
#[test]
fn what_changes_while_somebody_is_asked_is_told_as_what_it_replaces() {
    let bench = |after: usize| {
        format!(
            "[[drive]]\nmodel = \"acu\"\nset = {{ \"480\" = 5 }}\n[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"480@1\" = 6 }}\n"
        )
    };
    let line = "-v -a 1 write 480@1=7Hz";
    let asked = antrieb(line).on(&bench(99)).answered("n").exits(8).sent().len();
    let run = antrieb(line).on(&bench(asked)).answered("y").json().exits(0);
    assert!(run.err.contains("5.00 -> 7.00"), "{}", run.err);
    assert_eq!(run.data("/values/0/old"), &json!(6.0), "{:#}", run.value);
    assert_eq!(run.data("/values/0/note"), "it changed while you were asked: 5.00 -> 6.00");
    // Nobody was asked: no state for a question, and nothing had time to change.
    let usual = antrieb(line).on(&bench(99)).answered("y").exits(0).sent().len();
    let at_once = antrieb(line).and("--yes").on(&bench(99)).exits(0).sent().len();
    assert_eq!(at_once + 2, usual);
}

/// A drive that has refused over VABus takes no write until it was asked why: what another master has left so keeps no write of ours back,
/// and its cause is not told as ours.
#[test]
fn a_refusal_that_another_master_has_left_keeps_no_write_back() {
    let bench = "[[drive]]\nmodel = \"act\"\nprotocol = \"vabus\"\n";
    for line in ["write 480@1=8", "dataset load {dir}/f.toml --undo-file {dir}/u.toml", "dataset copy 1 2"] {
        let first = antrieb("-a 1 --protocol vabus read 411").on(bench).exits(0);
        let (mut bench, at) = witness::left().unwrap();
        // SELECT of P.411, which is only read.
        let mut told = vec![0x04, 0x41, 0x02];
        told.extend(b"00411040007\x03");
        let check = told[3..].iter().fold(0, |sum, byte| sum ^ byte);
        told.push(check);
        let at = at + Span::from_millis(50);
        bench.master_sends(at, LineSetting::vabus(19_200), &told);
        let later = at + Span::from_millis(200);
        assert!(bench.advance(later).iter().any(|(_, byte)| *byte == 0x15), "refused");
        witness::stands(bench, later);
        let run = first.then(&format!("-p sim:{{dir}}/bench.toml -a 1 --protocol vabus --yes {line}"));
        let run = run.file("f.toml", "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"480@1\" = 8\n");
        run.exits(0);
    }
}
