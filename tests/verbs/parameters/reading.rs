//! `read`: how parameters and data sets are named, what is asked for them, and in how many telegrams.

use crate::run::{Document, antrieb};
use serde_json::Value;

/// Data sets 2 of P.372 and 3 of P.480 differ from the rest.
const DIFFERING: &str = "[[drive]]\nmodel = \"act\"\nset = { \"372@2\" = 1450, \"480@3\" = -12.5 }\n";

/// `param@set` of every value, with `ram` for the RAM copy.
fn names(document: &Document) -> Vec<String> {
    let name = |value: &Value| {
        let ram = if value["store"] == "ram" { "ram" } else { "" };
        format!("{}@{}{ram}", value["param"], value["data_set"])
    };
    document.data("/values").as_array().unwrap().iter().map(name).collect()
}

fn read(what: &str) -> Vec<String> {
    names(&antrieb(&format!("-p sim -a 1 --drive act read {what}")).json().exits(0))
}

/// Telegrams that reading takes, without those that tell the family.
fn asked(what: &str) -> Vec<String> {
    antrieb(&format!("--drive act -a 1 -v read {what}")).on(DIFFERING).exits(0).questions()
}

#[test]
fn parameters_have_a_number_a_slug_and_two_names() {
    for name in
        ["372", "P.372", "rated-speed", "'Rated Speed'", "'RATED SPEED'", "bemessungsdrehzahl", "Bemessungsdreh"]
    {
        assert_eq!(read(name), ["372@0"], "{name}");
    }
    for name in ["'Modbus Parität'", "'modbus paritaet'", "'modbus paritat'", "modbus-parity"] {
        assert_eq!(read(name), ["1375@0"], "{name}");
    }
}

#[test]
fn data_sets_stand_behind_an_at() {
    assert_eq!(read("372@2"), ["372@2"]);
    assert_eq!(read("372@all"), ["372@1", "372@2", "372@3", "372@4"]);
    assert_eq!(read("480@ram"), ["480@0ram"]);
    assert_eq!(read("480@2ram"), ["480@2ram"]);
    assert_eq!(read("480@7"), ["480@2ram"]);
    assert_eq!(read("480-482@2"), ["480@2", "481@2", "482@2"]);
    assert_eq!(read("@motor"), ["372@0", "373@0", "375@0", "376@0"]);
    assert_eq!(
        read("rated-speed@3 411 372@1"),
        ["372@3", "411@0ram", "372@1"].map(|name| name.replace("411@0ram", &read("411")[0]))
    );
}

#[test]
fn without_a_parameter_the_actual_values_are_read() {
    let all = read("");
    assert_eq!(all, read("@actual"));
    assert!(all.iter().any(|name| name.starts_with("411@")));
}

#[test]
fn data_set_2_in_ram_is_number_7_on_the_wire() {
    assert_eq!(asked("372@2ram"), ["01 03 71 74 00 01 DF 2C"]);
    assert_eq!(asked("372@2"), ["01 03 21 74 00 01 CE 2C"]);
}

#[test]
fn differing_data_sets_stand_side_by_side() {
    let document = antrieb("-a 1 read 372").on(DIFFERING).json().exits(0);
    assert_eq!(names(&document), ["372@1", "372@2", "372@3", "372@4"]);
    let raws: Vec<_> = document.data("/values").as_array().unwrap().iter().map(|value| value["raw"].clone()).collect();
    assert_eq!(raws, [1390, 1450, 1390, 1390]);
    assert_eq!(document.warnings(), [""; 0]);
}

#[test]
fn set_0_is_asked_first_and_alone_if_the_sets_are_equal() {
    assert_eq!(asked("376"), ["01 03 01 78 00 01 05 EF"], "one telegram for four equal sets");
    let words: Vec<String> = asked("372").iter().map(|hex| hex[6..11].to_owned()).collect();
    // Set 0 is refused, P.11 = 9 tells why, then each set; the first that says what another one said is asked twice.
    assert_eq!(words, ["01 74", "00 0B", "11 74", "21 74", "31 74", "31 74", "41 74"]);
}

#[test]
fn set_0_by_name_falls_back_too() {
    let document = antrieb("-a 1 read 372@0 480@1").on(DIFFERING).json().exits(0);
    assert_eq!(names(&document), ["372@1", "372@2", "372@3", "372@4", "480@1"]);
}

#[test]
fn ram_copies_differ_too() {
    let document = antrieb("-a 1 read 480@ram").on(DIFFERING).json().exits(0);
    assert_eq!(names(&document), ["480@1ram", "480@2ram", "480@3ram", "480@4ram"]);
    assert_eq!(document.data("/values/2/value"), -12.5);
}

#[test]
fn an_unknown_width_is_found_by_asking_16_bits_then_32_and_remembered() {
    let run = antrieb("-p sim -a 1 --drive act -v read 241 241").exits(0);
    let functions: Vec<String> = run.questions().iter().map(|hex| hex[3..11].to_owned()).collect();
    // Code 3 is refused, P.11 = 14; code 100 is right, and for the second time asked at once.
    assert_eq!(functions, ["03 00 F1", "03 00 0B", "64 00 F1", "64 00 F1"], "{}", run.err);
    assert_eq!(antrieb("-p sim -a 1 read 241").json().exits(0).data("/values/0/data_type"), "long");
    // A word is a word at the first question.
    let run = antrieb("-p sim -a 1 --drive act -v read 373").exits(0);
    assert_eq!(run.questions().len(), 1);
}

#[test]
fn a_named_type_is_taken_whatever_the_catalogue_says() {
    let run = antrieb("-p sim -a 1 --drive act -v read 372 --type long").exits(6);
    assert_eq!(run.questions()[0], "01 64 01 74 41 B0");
    assert!(run.err.contains("P.11 = 14"), "{}", run.err);
    let document = antrieb("-p sim -a 1 read 372 --decimals 2").json().exits(0);
    assert_eq!(document.data("/values/0/value"), 13.9);
    assert_eq!(document.data("/values/0/decimals"), 2);
}

#[test]
fn a_parameter_that_no_catalogue_knows_is_asked_for_all_the_same() {
    let document = antrieb("-p sim -a 1 read 212").json().exits(6);
    assert_eq!(document.error()["code"], "refused.unknown_parameter");
    assert_eq!(document.data("/values/0/origin"), "unknown");
    assert_eq!(document.data("/values/0/unconfirmed/0"), "row");
}

#[test]
fn the_cause_of_a_refusal_is_fetched_at_once_and_by_nobody_else() {
    let run = antrieb("-p sim -a 1 --drive act -v read 1600 11").exits(9);
    let sent = run.questions();
    assert_eq!(sent[0][..11], *"01 03 06 40");
    assert_eq!(sent[1], "01 03 00 0B 00 01 F5 C8", "right behind the refused question");
    assert!(run.err.contains("P.11 = 11"), "{}", run.err);
    let document = antrieb("-p sim -a 1 read 1600 11").json().exits(9);
    assert_eq!(document.data("/values/0/error/context/p11"), "11");
    assert_eq!(document.data("/values/1/raw"), 0, "reading has cleared it");
}

#[test]
fn no_group_reads_the_error_register_away() {
    for group in ["@actual", "@modbus", "@all", "@setpoints", "@motor", "@systembus"] {
        let document = antrieb(&format!("-p sim -a 2 --drive acu read {group}")).json();
        assert!(!names(&document).iter().any(|name| name.starts_with("11@")), "{group}");
    }
}

#[test]
fn of_a_group_a_drive_need_not_have_everything() {
    // An ACT without option modules: rows with an error, and yet all that can be read was read.
    let document = antrieb("-p sim -a 1 read @all").json().exits(0);
    let values = document.data("/values").as_array().unwrap();
    assert!(values.iter().any(|value| value["error"]["class"] == "refused"));
    assert!(values.iter().filter(|value| value["error"].is_null()).count() > 50);
}

#[test]
fn values_come_out_exact() {
    let bench =
        "[[drive]]\nmodel = \"acu\"\nset = { \"210\" = \"-120.07\", \"211\" = \"10.3\", \"480@1\" = \"0.07\" }\n";
    let run = antrieb("-a 1 read 210 211 480@1 --json").on(bench).exits(0);
    for number in ["\"value\": -120.07,", "\"value\": 10.3,", "\"value\": 0.07,", "\"raw\": -12007,"] {
        assert!(run.out.contains(number), "{number}: {}", run.out);
    }
    let table = antrieb("-a 1 read 210 211 480@1").on(bench).exits(0);
    for number in ["-120.07  Hz", "10.3  A", "0.07  Hz"] {
        assert!(table.out.contains(number), "{number}: {}", table.out);
    }
}

#[test]
fn the_factory_address_is_taken_and_said() {
    let run = antrieb("-p sim read 372").exits(0);
    assert!(run.err.contains("note: no address given, taking 1"), "{}", run.err);
    assert_eq!(antrieb("-p sim -q read 372").exits(0).err, "");
}

#[test]
fn several_drives_are_read_in_the_order_in_which_they_were_named() {
    let document = antrieb("-p sim -a 2,1 read 372 376").json().exits(0);
    let rows = document.data("/values").as_array().unwrap();
    let order: Vec<_> = rows
        .iter()
        .map(|row| format!("{}{}{}", row["address"], row["drive"].as_str().unwrap(), row["param"]))
        .collect();
    assert_eq!(order, ["2acu372", "2acu376", "1act372", "1act376"]);
}

#[test]
fn what_names_nothing_is_told_with_what_comes_near() {
    let ambiguous = antrieb("-p sim -a 1 read drehzahl").json().exits(7);
    assert_eq!(ambiguous.error()["code"], "data.ambiguous_parameter");
    assert!(ambiguous.error()["message"].as_str().unwrap().contains("218 (encoder-1-speed)"));
    let near = antrieb("-p sim -a 1 read leistung").json().exits(7);
    assert!(near.error()["hint"].as_str().unwrap().contains("376 (rated-mechanical-power)"), "{}", near.error());
    let unknown = antrieb("-p sim -a 1 read nonsense").json().exits(7);
    assert_eq!(unknown.error()["code"], "data.unknown_parameter");
    let group = antrieb("-p sim -a 1 read @nope").json().exits(7);
    assert!(group.error()["message"].as_str().unwrap().contains("@motor"));
    for (text, code) in [("372@10", 2), ("372@", 2), ("480-9", 2), ("'@ '", 7)] {
        antrieb(&format!("-p sim -a 1 read {text}")).json().exits(code);
    }
}

#[test]
fn names_are_checked_before_the_port_is_opened() {
    antrieb("-p /dev/antrieb-has-no-such-port -a 1 read nonsense").exits(7);
    antrieb("-p /dev/antrieb-has-no-such-port -a 1 read 372").exits(3);
}

#[test]
fn a_raw_number_stands_beside_no_unit() {
    for (lang, remark) in [("en", "(raw, decimals unknown: Hz)"), ("de", "(roh, Nachkommastellen unbekannt: Hz)")] {
        let run = antrieb(&format!("--lang {lang} -p sim -a 1 sollwert")).exits(0);
        let row = run.out.lines().find(|line| line.trim_start().starts_with("241 ")).unwrap();
        assert!(row.contains(remark), "{row}");
        assert!(!row.split('(').next().unwrap().contains("Hz"), "{row}");
    }
}

#[test]
fn a_width_whose_question_was_lost_is_no_refusal() {
    for (kind, first) in [("lost", 2), ("late", 3)] {
        for every in first..=7 {
            let by = if kind == "late" { "by = \"2500ms\"\n" } else { "" };
            let bench = format!("[[drive]]\nmodel = \"act\"\n[[disturb]]\nevery = {every}\nkind = \"{kind}\"\n{by}");
            for verb in ["--drive act read 241", "read 241", "sollwert"] {
                let run = antrieb(&format!("-a 1 {verb}")).on(&bench).run();
                let told = format!("{kind}, every {every}, {verb}: {}{}", run.out, run.err);
                assert!(run.exit != 6 && !run.out.contains("refused"), "{told}");
                assert!(
                    run.exit != 0 || run.out.lines().any(|row| row.contains("241") && row.contains("raw")),
                    "{told}"
                );
            }
        }
    }
}

#[test]
fn a_lost_cause_is_asked_for_by_another_refusal_or_set_by_set() {
    let bench = format!("{DIFFERING}[[disturb]]\nonce = 3\nkind = \"lost\"\n");
    for retries in ["", "--retries 0"] {
        let run = antrieb(&format!("-v -a 1 --drive act {retries} read 372")).on(&bench).json().exits(0);
        assert_eq!(names(&run), ["372@1", "372@2", "372@3", "372@4"], "{retries}");
        // A cause that is asked for twice may be that of another refusal.
        let asked = run.err.matches("> 01 03 00 0B").count();
        assert!(asked <= 2 && (retries.is_empty() || asked == 1), "{retries}: {}", run.err);
    }
}

/// Of a group a drive need not have everything; who names a range wants all of it.
#[test]
fn what_is_refused_of_a_range_is_counted() {
    let some = antrieb("-p sim -a 1 read 420-423 480").json().exits(9);
    assert!(some.error()["message"].as_str().unwrap().contains("4 of 5"), "{}", some.error());
    antrieb("-p sim -a 1 read 480-483").exits(0);
    antrieb("-p sim -a 1 read @all").exits(0);
}

/// Number of the first reply that tells the register of P.11, and a verb that reads it: named, or recognised on the way.
const CLEARED_BY_READING: [(u64, &str); 3] = [(2, "--drive act read 11"), (4, "read 11"), (4, "diag")];

/// The exit code, what is told of the register, and how often it was asked for, with its first answer disturbed.
fn register(verb: &str, reply: u64, disturbed: &str) -> (u8, Value, usize) {
    let bench = format!(
        "[[drive]]\nmodel = \"act\"\nset = {{ \"11\" = 9 }}\n[[disturb]]\nonce = {reply}\nkind = {disturbed}\n"
    );
    let run = antrieb(&format!("-v -a 1 {verb}")).on(&bench).json();
    let place = if verb == "diag" { "/drives/0/error_register/code" } else { "/values/0/raw" };
    let told = run.value["data"].pointer(place).unwrap_or(&Value::Null);
    (run.exit, told.clone(), run.err.matches("> 01 03 00 0B").count())
}

#[test]
fn what_reading_clears_is_asked_once_and_a_lost_answer_is_never_told_as_nothing() {
    for (reply, verb) in CLEARED_BY_READING {
        for (kind, exit) in [("lost", 4), ("garbled", 5), ("truncated", 5)] {
            let exit = if verb == "diag" { 9 } else { exit };
            assert_eq!(register(verb, reply, &format!("\"{kind}\"")), (exit, Value::Null, 1), "{kind}, {verb}");
        }
    }
}

#[test]
fn what_reading_clears_is_waited_for_twice_as_long() {
    for (reply, verb) in CLEARED_BY_READING {
        assert_eq!(register(verb, reply, "\"late\"\nby = \"800ms\""), (0, 9.into(), 1), "{verb}");
    }
}

#[test]
fn a_refusal_of_something_older_is_not_taken_for_an_answer_without_a_cause() {
    for by in (1_000..=7_000).step_by(350) {
        let bench = format!("[[drive]]\nmodel = \"act\"\n[[disturb]]\nevery = 2\nkind = \"late\"\nby = \"{by}ms\"\n");
        for verb in ["--drive act read 241", "read 241"] {
            let run = antrieb(&format!("-v -a 1 {verb}")).on(&bench).run();
            assert_ne!(run.exit, 6, "{by} ms, {verb}: {}{}", run.out, run.err);
        }
    }
}

#[test]
fn a_drive_that_never_answers_is_not_asked_for_everything() {
    // Three questions at most, each with its two repeats, the greeting before and the fences behind them.
    for line in ["dataset show", "read @actual", "read 480-490", "dataset diff 1 2"] {
        let silent = antrieb(&format!("--drive act -a 9 -v {line}")).on(DIFFERING).exits(4);
        let asked = silent.questions().len();
        assert!(asked < 32, "{line}: {asked} questions\n{}", silent.err);
    }
    let rows = antrieb("--drive act -a 9 read 480-484").on(DIFFERING).json().exits(4);
    let told: Vec<_> = rows.data("/values").as_array().unwrap().iter().map(|row| &row["error"]["class"]).collect();
    assert_eq!(told, ["silence"; 5], "every value has its row");
}

/// A row that was left out counts as one, also of a drive that does not answer at all.
#[test]
fn every_row_of_a_silent_drive_is_counted() {
    for (params, told) in [("411 372", "2 of 4 failed"), ("411 372 480", "3 of 6 failed"), ("372@all", "4 of 8 failed")]
    {
        let run =
            antrieb(&format!("-a 1,9 read {params}")).on("[[drive]]\nmodel = \"act\"\naddress = 1\n").json().exits(9);
        let message = run.value["error"]["message"].as_str().unwrap();
        assert!(message.starts_with(told), "{params}: {message}");
    }
    // Where nothing was read there is one thing to say.
    let run = antrieb("-a 9 read 411 372").on("[[drive]]\nmodel = \"act\"\naddress = 1\n").exits(4);
    assert!(!run.err.contains(" of "), "{}", run.err);
}
