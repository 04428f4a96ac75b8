//! One test per defect that was found in the verbs, so that it does not come back.

use crate::run::antrieb;
use antrieb::drive::{AccessError, Interrupt, Opening, ScanPlan, Session, Target, recognise, scan};
use antrieb::profile::{DataSets, Registry};
use antrieb::protocol::modbus::pdu::Request;
use antrieb::transport::Port;
use serde_json::Value;

/// A device that refuses whatever a drive would know.
const FOREIGN: &str = "[[drive]]\nmodel = \"foreign\"\naddress = 9\nregisters = { \"0\" = 17 }\n";

#[test]
fn a_pipe_that_closes_behind_the_first_buffer_of_csv_is_a_success() {
    let run = antrieb("params --format csv").into_pipe_of(10_000).exits(0);
    assert_eq!(run.err, "");
}

#[test]
fn what_could_not_be_read_is_not_called_healthy() {
    let diag = antrieb("-a 9 --drive acu diag --check").on(FOREIGN).json().exits(6);
    assert_eq!(diag.data("/drives/0/healthy"), false);
    for verb in ["diag", "statemachine"] {
        let run = antrieb(&format!("-a 9 --drive acu {verb}")).on(FOREIGN).exits(6);
        assert!(
            !run.out.lines().any(|line| line.starts_with("fault") && line.ends_with("none")),
            "{verb}: {}",
            run.out
        );
    }
}

#[test]
fn a_device_that_refuses_everything_is_no_success() {
    for verb in ["sollwert", "statemachine", "diag", "identify", "dataset active"] {
        antrieb(&format!("-a 9 --drive acu {verb}")).on(FOREIGN).json().exits(6);
    }
}

#[test]
fn no_verb_opens_anything_in_a_dry_run() {
    for verb in [
        "read 372",
        "scan",
        "identify",
        "diag",
        "statemachine",
        "sollwert",
        "dataset show 372",
        "dataset active",
        "dataset diff 1 2 372",
        "dataset select 3",
        "write 480@1=6",
    ] {
        antrieb(&format!("-p /dev/antrieb-has-no-such-port -a 1 --dry-run {verb}")).json().exits(0);
    }
    let run = antrieb("-p sim -a 1 --dry-run --yes -v diag --clear").exits(0);
    assert_eq!(run.sent(), [""; 0]);
    assert!(run.out.contains("01 08 00 0A 00 00 C0 09"), "{}", run.out);
}

#[test]
fn a_dry_run_decodes_what_it_would_send() {
    let run = antrieb("-p sim -a 1 --dry-run write 480@2=7.5").exits(0);
    assert!(run.out.contains("01 65 21 E0 00 00 02 EE B2 8A"), "{}", run.out);
    assert!(run.out.contains("write P.480@2 Fixed Frequency 1 = 7.50 Hz"), "{}", run.out);
    let run = antrieb("-p sim -a 1 --dry-run read 372@2").exits(0);
    assert!(run.out.contains("read P.372@2"), "{}", run.out);
}

#[test]
fn what_no_telegram_can_name_is_refused_by_us_and_not_in_the_name_of_the_drive() {
    for line in ["read 70000", "read 4096@2", "--yes write 70000=1 --type uint", "dataset show 5000"] {
        let document = antrieb(&format!("-p /dev/antrieb-has-no-such-port -a 1 {line}")).json();
        assert_eq!((document.exit, &document.error()["class"]), (7, &"data".into()), "{line}: {}", document.error());
    }
    antrieb("-p sim -a 1 read 4095").json().exits(6);
}

#[test]
fn usage_errors_in_json_say_what_is_missing_and_for_which_verb() {
    let document = antrieb("write").json().exits(2);
    assert_eq!(document.value["command"], "write");
    assert!(document.error()["message"].as_str().unwrap().contains("PARAMETER=VALUE"), "{}", document.error());
    let document = antrieb("-p sim state --nope").json().exits(2);
    assert_eq!(document.value["command"], "statemachine");
}

#[test]
fn the_schema_verb_fails_in_json_too_and_knows_the_aliases() {
    assert_eq!(antrieb("schema nope").json().exits(2).error()["class"], "usage");
    for (alias, verb) in [("state", "statemachine"), ("setpoint", "sollwert")] {
        let [of_alias, of_verb] = [alias, verb].map(|name| antrieb(&format!("schema {name}")).exits(0).out);
        assert_eq!(of_alias, of_verb);
    }
}

#[test]
fn the_hint_for_bench_files_leads_to_their_format() {
    let document = antrieb("scan").on("[[drive]]\ncolour = 1\n").json().exits(7);
    let hint = document.error()["hint"].as_str().unwrap();
    let command = hint.split('`').nth(1).unwrap_or_else(|| panic!("no command in: {hint}"));
    let page = antrieb(command.trim_start_matches("antrieb ")).exits(0).out;
    for word in ["[[drive]]", "model", "[[disturb]]"] {
        assert!(page.contains(word), "{word} in {command}: {page}");
    }
}

/// Leaves a cause in the error register of the drive at 1, does something, and reads the register.
fn cause_after(work: impl AsyncFnOnce(&mut Session<'_>, &Registry)) -> i64 {
    let registry = Registry::open(&[]).unwrap();
    let port = Port::Sim(None);
    let opening = Opening::at(&port);
    let mut observe = |_| {};
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    runtime.block_on(async {
        let opened = Session::open(opening, &registry, Interrupt::default(), &mut observe).await;
        let mut session = opened.unwrap();
        // P.376@2 = 0: exception 4, P.11 = 1 (CM-485 manual 8.1.2).
        session.ask(1, Request::WriteRegister { address: 0x2178, value: 0 }).await.unwrap();
        work(&mut session, &registry).await;
        let mut target = Target::new(1, registry.family("act").unwrap());
        let register = target.family.param(11).unwrap().clone();
        target.read_set(&mut session, &register, 0).await.unwrap().raw
    })
}

#[test]
fn nothing_but_a_refusal_of_its_own_reads_the_cause_away() {
    assert_eq!(cause_after(async |_, _| {}), 1);
    let scanned = cause_after(async |session, registry| {
        let plan = ScanPlan::new(vec![1, 2, 3]);
        assert_eq!(scan(session, &plan, registry).await.drives.len(), 2);
    });
    assert_eq!(scanned, 1, "a scan leaves the register of an ACT alone");
    let read = cause_after(async |session, registry| {
        let finding = recognise(session, registry, 1, false).await.unwrap();
        let mut target = finding.target(1, registry).unwrap();
        let param = target.family.param(372).unwrap().clone();
        let rows: Vec<Result<_, AccessError>> =
            target.read(session, &param, DataSets::Unnamed).await.into_iter().map(|row| row.1).collect();
        assert!(rows[0].is_ok());
    });
    assert_eq!(read, 1, "neither telling the family nor reading another parameter clears it");
}

#[test]
fn a_bad_text_in_any_table_of_a_catalogue_is_refused_at_its_place() {
    let head = "schema = 1\nfamily = \"active\"\nparams = []\n";
    for (table, place) in [
        ("[bits.mine]\n1 = { slug = \"x\", en = \"a\\u001bb\", de = \"x\" }\n", "mine.toml:5:"),
        (
            "[enums.mine]\n0 = { en = \"fine\", de = \"fein\" }\n1 = { en = \"a\\u001bb\", de = \"x\" }\n",
            "mine.toml:6:",
        ),
        (
            "faults = [\n{ code = 0x0999, key = \"F0999\", en = \"a\\u001bb\", de = \"x\", cause = { en = \"\", de = \"\" }, remedy = { en = \"\", de = \"\" } },\n]\n",
            "mine.toml:5:",
        ),
    ] {
        let document = antrieb("--catalogue {dir}/mine.toml params 372")
            .file("mine.toml", &format!("{head}{table}"))
            .json()
            .exits(7);
        let message = document.error()["message"].as_str().unwrap();
        assert!(message.contains(place) && message.contains("U+001B"), "{place}: {message}");
    }
}

#[test]
fn a_fault_of_the_user_is_never_ignored_in_silence() {
    let catalogue = |rest: &str| {
        format!(
            "schema = 1\nfamily = \"active\"\nparams = []\nfaults = [\n{{ code = 0x0500, key = \"F0500\", en = \"mine\", de = \"meins\", cause = {{ en = \"c\", de = \"c\" }}, remedy = {{ en = \"r\", de = \"r\" }}{rest} }},\n]\n"
        )
    };
    let decode = |text: &str| antrieb("--catalogue {dir}/mine.toml decode fault F0500").file("mine.toml", text);
    let refused = decode(&catalogue("")).json().exits(7);
    assert!(refused.error()["message"].as_str().unwrap().contains("mine.toml:5:"), "{}", refused.error());
    let replaced = decode(&catalogue(", replace = true")).json().exits(0);
    assert_eq!(replaced.data("/fault/name"), "mine");
}

#[test]
fn a_group_leaves_out_what_exists_once() {
    // P.373 is in @motor and has no four sets on the bench.
    let shown = antrieb("-p sim -a 1 dataset show @motor").json().exits(0);
    let params: Vec<_> = shown.data("/rows").as_array().unwrap().iter().map(|row| row["param"].clone()).collect();
    assert_eq!(params, [372, 375, 376]);
    antrieb("-p sim -a 1 --yes dataset copy 1 2 @motor").json().exits(0);
    antrieb("-p sim -a 1 dataset diff 1 2 @motor").json().exits(0);
}

#[test]
fn the_active_data_set_stands_in_every_format() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"414\" = 3 }\n";
    for format in ["csv", "ndjson"] {
        let run = antrieb(&format!("-a 1 --format {format} dataset active")).on(bench).exits(0);
        assert!(run.out.contains("active"), "{format}: {}", run.out);
    }
    let csv = antrieb("-a 1 --format csv dataset active").on(bench).exits(0).out;
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let column = reader.headers().unwrap().iter().position(|name| name == "active").unwrap();
    assert_eq!(&reader.records().next().unwrap().unwrap()[column], "3");
}

/// The cells of the first row of what is printed as CSV, by the names of their columns.
fn first_row(csv: &str) -> std::collections::BTreeMap<String, String> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let names: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let cells = reader.records().next().unwrap().unwrap();
    names.into_iter().zip(cells.iter().map(str::to_owned)).collect()
}

#[test]
fn a_cell_holds_what_was_counted_and_which_fault_and_not_only_what_it_is_called() {
    let bench = "[[drive]]\nmodel = \"act\"\n[[drive.event]]\nat = \"0s\"\nfault = \"F0500\"\n";
    let csv = |line: &str| first_row(&antrieb(&format!("-a 1 --format csv {line}")).on(bench).run().out);
    let diag = csv("diag");
    let counted = diag["counters"].split("; ").map(|one| one.rsplit(' ').next().unwrap().parse::<u16>());
    assert!(counted.clone().all(|count| count.is_ok()) && counted.count() == 8, "{}", diag["counters"]);
    assert_eq!(diag["error_register"], "0 No error");
    assert!(diag["fault"].starts_with("F0500 "), "{}", diag["fault"]);
    let field = first_row(&antrieb("--format csv decode telegram 01 65 21 77 00 00 03 E8 46 C5").exits(0).out);
    assert!(field["fields"].starts_with("01 "), "{}", field["fields"]);
    assert!(field["fields"].contains("00 00 03 E8 ") && field["fields"].contains("10.00 Hz"), "{}", field["fields"]);
    // A module that is not there is none of those that are.
    let found = antrieb("-a 1 identify").on(bench).json().exits(0);
    let modules = found.data("/drives/0/modules").as_array().unwrap();
    let there = modules.iter().filter(|one| one["present"] == true).map(|one| one["name"].as_str().unwrap());
    assert_eq!(csv("identify")["modules"], there.collect::<Vec<_>>().join("; "));
}

#[test]
fn a_width_that_was_found_out_is_said_to_who_wants_to_know_or_cannot_know() {
    let run = antrieb("-p sim -a 1 -v read 241").exits(0);
    assert!(run.err.contains("parameter 241: 32 bit"), "{}", run.err);
    let document = antrieb("-p sim -a 1 -v read 373").json().exits(0);
    assert!(document.err.contains("parameter 373: 16 bit"), "{}", document.err);
    for line in ["-p sim -a 1 read 241 373", "-p sim -a 1 read @all"] {
        assert!(!antrieb(line).run().err.contains("found out by asking"), "the rows tell it: data_type");
    }
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"1234\" = 5 }\n";
    let raw = antrieb("-a 1 read 1234").on(bench).run();
    assert!(raw.exit != 0 || raw.err.contains("parameter 1234: 16 bit"), "no catalogue knows it: {}", raw.err);
    assert!(!antrieb("-p sim -a 1 read 372").exits(0).err.contains("bit"), "what the catalogue tells is not asked");
}

#[test]
fn the_rows_say_which_drive_failed() {
    for verb in ["read 372", "identify", "diag", "statemachine", "sollwert"] {
        for format in ["ndjson", "csv"] {
            let run = antrieb(&format!("-p sim -a 1,7 --format {format} {verb}")).exits(9);
            let rows: Vec<&str> = run.out.lines().filter(|line| !line.contains("\"type\":\"end\"")).collect();
            let named = rows.iter().any(|row| match format {
                "csv" => row.starts_with("7,"),
                _ => serde_json::from_str::<Value>(row).unwrap()["address"] == 7,
            });
            assert!(named, "{verb} {format}: {}", run.out);
        }
    }
}

#[test]
fn counts_in_a_partial_failure_are_of_one_kind() {
    // Two drives were asked, one failed; how many values the other one has is another matter.
    for verb in ["identify", "diag", "statemachine", "sollwert"] {
        let document = antrieb(&format!("-p sim -a 1,7 {verb}")).json().exits(9);
        let message = document.error()["message"].as_str().unwrap();
        assert!(message.starts_with("1 of 2 "), "{verb}: {message}");
    }
}

#[test]
fn no_message_mixes_two_languages() {
    for line in [
        "-p sim -a 1,7 read 372",
        "-p sim -a 1 read 372 1600",
        "-p sim -a 1,7 diag",
        "decode telegram 01 02 03",
        "decode telegram 01 03 21 74 00 01 CE 2D",
        "decode fault F2105",
    ] {
        let run = antrieb(&format!("--lang de {line}")).run();
        for english in [" failed", "the first", "too few", "check value", "expected", "node 5"] {
            assert!(
                !run.out.contains(english) && !run.err.contains(english),
                "{line}: '{english}'\n{}{}",
                run.out,
                run.err
            );
        }
    }
}

#[test]
fn a_fault_of_a_slave_names_the_slave() {
    let document = antrieb("decode fault F2105").json().exits(0);
    let name = document.data("/fault/name").as_str().unwrap();
    assert!(!name.contains("nn"), "the node is known: {name}");
}

#[test]
fn an_empty_result_is_explained() {
    // The standard ACT has no module with a system bus.
    let run = antrieb("-p sim -a 1 dataset show @systembus").run();
    assert!(!run.err.is_empty(), "exit {} and not a word: {}", run.exit, run.out);
}

#[test]
fn a_negative_value_for_an_unsigned_word_is_not_sent() {
    // Nothing proves the sign of this word, so it is read as unsigned: -1 would become 65535 1/min.
    let run = antrieb("-p sim -a 1 --yes -v write 372=-1").run();
    assert!(!run.sent().iter().any(|hex| hex.starts_with("01 06")), "{}", run.err);
    assert_eq!(run.exit, 7, "{}", run.err);
    antrieb("-p sim -a 1 --yes write 372=-1 --type int").exits(0);
}

#[test]
fn rtu_with_7_data_bits_is_a_usage_error() {
    antrieb("-p sim -a 1 --data-bits 7 read 372").json().exits(2);
    antrieb("-p sim -a 1 --protocol ascii --data-bits 8 read 372").json().exits(4);
}

#[test]
fn no_time_at_all_is_no_timeout() {
    antrieb("-p sim -a 1 --timeout 0ms read 372").json().exits(2);
}
