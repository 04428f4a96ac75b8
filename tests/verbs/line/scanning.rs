//! `scan` in virtual time: how long it takes, whom it finds, and what it says of whom it cannot understand.

use crate::run::antrieb;
use antrieb::drive::{First, Interrupt, Manner, Opening, ScanPlan, ScanResult, Session, Unknown, scan};
use antrieb::outcome::{Event, FoundDrive, SearchNews};
use antrieb::profile::{Lang, Registry};
use antrieb::tick::{Span, Tick};
use antrieb::transport::Port;
use serde_json::{Value, json};

/// What came of a scan of a bench.
pub(super) struct Played {
    pub(super) result: ScanResult,
    pub(super) took: Span,
    /// Each find with its time.
    pub(super) found: Vec<(Span, FoundDrive)>,
    /// What was told on the way.
    pub(super) news: Vec<SearchNews>,
    /// Telegrams that went out.
    pub(super) sent: usize,
    remarks: Vec<String>,
}

impl Played {
    pub(super) fn addresses(&self) -> Vec<u8> {
        self.result.drives.iter().map(|drive| drive.address).collect()
    }

    fn warnings(&self) -> Vec<&str> {
        self.result.warnings.iter().map(|warning| warning.code.as_str()).collect()
    }
}

/// Scans a bench from 19200 8E1 on.
pub(super) fn play(bench: &str, plan: &ScanPlan) -> Played {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("bench.toml");
    std::fs::write(&path, bench).unwrap();
    let registry = Registry::open(&[]).unwrap();
    let port = Port::Sim(Some(path));
    let opening = Opening { verbose: true, ..Opening::at(&port) };
    let (mut found, mut news, mut sent) = (Vec::new(), Vec::new(), 0);
    // Time by the telegrams, which are told before what they bring.
    let mut now = 0;
    let mut observe = |event| match event {
        Event::Telegram { at_us, direction, .. } => {
            now = at_us;
            sent += usize::from(direction == '>');
        }
        Event::Found(drive) => found.push((Span::from_micros(now), *drive)),
        Event::Sought(told) => news.push(*told),
        _ => {}
    };
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    let (result, took, remarks) = runtime.block_on(async {
        let mut session = Session::open(opening, &registry, Interrupt::default(), &mut observe).await.unwrap();
        let result = scan(&mut session, plan, &registry).await;
        let took = session.now().since(Tick::ZERO);
        (result, took, session.bench().unwrap().remarks().iter().map(ToString::to_string).collect())
    });
    Played { result, took, found, news, sent, remarks }
}

pub(super) fn drives(rows: &[(u8, &str)]) -> String {
    let row = |(address, more): &(u8, &str)| format!("[[drive]]\nmodel = \"act\"\naddress = {address}\n{more}\n");
    rows.iter().map(row).collect()
}

fn whole_line() -> ScanPlan {
    ScanPlan::new(1..=247)
}

#[test]
fn the_whole_line_takes_less_than_eight_seconds() {
    let played = play(&drives(&[(1, ""), (17, ""), (42, "")]), &whole_line());
    assert_eq!(played.addresses(), [1, 17, 42]);
    assert!(played.took < Span::from_secs(8), "{}", played.took);
    let first = played.found.first().unwrap().0;
    assert!(first < Span::from_millis(200), "a factory drive shows up at once: {first}");
    let others = played.remarks.iter().filter(|remark| !remark.ends_with("(impatient)"));
    assert_eq!(others.collect::<Vec<_>>(), [""; 0], "asking on after a short window is the only liberty");
}

/// Scans a line where one of three drives answers late.
fn play_late(slow: u8, delay: u64, plan: &ScanPlan) -> Played {
    let late = format!("reply_delay = \"{delay}ms\"");
    let rows = [1, 17, 42].map(|address| (address, if address == slow { late.as_str() } else { "" }));
    play(&drives(&rows), plan)
}

#[test]
fn a_drive_that_answers_after_300_ms_is_found_in_eight_seconds() {
    for slow in [1, 17, 42] {
        let played = play_late(slow, 300, &whole_line());
        let mut found = played.addresses();
        found.sort_unstable();
        assert_eq!(found, [1, 17, 42], "{slow}");
        assert!(played.took < Span::from_secs(8), "{slow}: {}", played.took);
        assert_eq!(played.warnings(), ["scan.late"]);
    }
}

#[test]
fn a_late_reply_that_meets_a_question_hides_nobody() {
    // At some of these delays the reply meets a question, at some it is over before that question is.
    for slow in [1, 17] {
        for delay in (281..=320).step_by(2) {
            let played = play_late(slow, delay, &whole_line());
            assert_eq!(played.addresses().len(), 3, "{slow} after {delay} ms");
            assert!(played.took < Span::from_secs(12), "{slow} after {delay} ms: {}", played.took);
        }
    }
    // Behind the first addresses, which are asked twice, one that leaves no trace is found by the book.
    let hidden = (282..=320).step_by(2).filter(|&delay| play_late(42, delay, &whole_line()).addresses().len() < 3);
    let hidden: Vec<u64> = hidden.collect();
    assert_eq!(hidden, [290, 312]);
    let plan = ScanPlan { manner: Manner::Thorough, ..ScanPlan::new(40..=45) };
    assert_eq!(play_late(42, 290, &plan).addresses(), [42]);
}

#[test]
fn any_of_36_settings_is_found_within_four_seconds_in_the_middle() {
    let plan = ScanPlan {
        unknown: Unknown { baud: true, parity: true, protocol: true },
        until_first: Some(First::default()),
        ..whole_line()
    };
    let mut times = Vec::new();
    for protocol in ["rtu", "ascii"] {
        for parity in ["even", "odd", "none"] {
            for baud in [2_400, 4_800, 9_600, 19_200, 57_600, 115_200] {
                let setting = format!("baud = {baud}\nparity = \"{parity}\"\nprotocol = \"{protocol}\"");
                let played = play(&drives(&[(1, &setting)]), &plan_again(&plan));
                assert_eq!(played.addresses(), [1], "{setting}");
                let drive = &played.result.drives[0];
                assert!(drive.line.starts_with(&baud.to_string()) && drive.protocol == protocol, "{drive:?}");
                times.push((played.took, setting.replace('\n', ", ")));
            }
        }
    }
    times.sort();
    let median = times[times.len() / 2].0;
    println!("36 settings: median {median}, {} to {}", times[0].0, times[35].0);
    assert_eq!(times.len(), 36);
    assert!(median < Span::from_secs(4), "{median}");
    assert!(times.last().unwrap().0 < Span::from_secs(8), "{:?}", times.last());
    let factory = times.first().unwrap();
    assert!(factory.1.contains("19200, parity = \"even\", protocol = \"rtu\""), "{factory:?}");
}

/// The same plan for another run.
fn plan_again(plan: &ScanPlan) -> ScanPlan {
    ScanPlan { until_first: plan.until_first.is_some().then(First::default), ..plan.clone() }
}

#[test]
fn by_the_book_the_judge_has_no_remark() {
    let plan = ScanPlan { manner: Manner::Thorough, ..ScanPlan::new(1..=30) };
    let played = play(&drives(&[(1, ""), (17, "reply_delay = \"310ms\"")]), &plan);
    assert_eq!(played.addresses(), [1, 17]);
    assert_eq!(played.remarks, [""; 0]);
    assert_eq!(played.warnings(), [""; 0], "nobody is late who is waited for");
}

#[test]
fn fast_is_one_time_around() {
    let bench = drives(&[(1, ""), (17, "reply_delay = \"40ms\""), (30, "reply_delay = \"40ms\"")]);
    let plan = ScanPlan { manner: Manner::Fast, ..ScanPlan::new(1..=30) };
    let played = play(&bench, &plan);
    assert_eq!(played.addresses(), [1, 17], "who is late is credited, but nobody waits for the last one");
    assert!(played.result.searched[0].is_complete());
    assert!(played.took < Span::from_millis(30 * 23 + 300), "{}", played.took);
}

#[test]
fn two_drives_with_one_address_are_named() {
    let played = play(&drives(&[(1, ""), (17, ""), (17, "")]), &whole_line());
    assert_eq!(played.addresses(), [1]);
    assert_eq!(played.warnings(), ["scan.same_address"]);
    assert!(played.result.warnings[0].message.get(Lang::En).contains("address 17: every reply is garbage"));
    assert!(played.took < Span::from_secs(11), "{}", played.took);
    // One answers behind the other: both are heard, and the status words differ.
    let other = "reply_delay = \"28ms\"\nset = { \"411\" = \"0x0021\" }";
    let played = play(&drives(&[(1, ""), (17, ""), (17, other)]), &ScanPlan::new(15..=20));
    assert!(played.warnings().contains(&"scan.same_address"), "{:?}", played.warnings());
}

#[test]
fn whatever_the_line_does_nobody_is_hidden() {
    for kind in ["late\"\nby = \"150ms", "lost", "garbled", "truncated", "noise", "doubled", "foreign", "echo"] {
        let bench = drives(&[(1, ""), (5, ""), (9, "")]) + &format!("[[disturb]]\nevery = 3\nkind = \"{kind}\"\n");
        let played = play(&bench, &ScanPlan::new(1..=40));
        let mut found = played.addresses();
        found.sort_unstable();
        assert_eq!(found, [1, 5, 9], "{kind}: {:?}", played.result.warnings);
    }
}

#[test]
fn an_echoing_line_with_a_late_drive_is_understood() {
    let bench = "[line]\necho = true\n".to_owned() + &drives(&[(1, ""), (5, "reply_delay = \"203ms\"")]);
    let mut found = play(&bench, &ScanPlan::new(1..=40)).addresses();
    found.sort_unstable();
    assert_eq!(found, [1, 5]);
}

/// As an adapter on a slow hub gives back what it sends: the telegrams by which a find is looked at come back as well.
#[test]
fn telegrams_of_ours_that_come_back_late_are_no_other_master() {
    for by in [4, 25, 40, 60] {
        for address in [1, 7] {
            let echo = format!("[[disturb]]\nevery = 1\nkind = \"echo\"\nby = \"{by}ms\"\n");
            let played = play(&(drives(&[(address, "")]) + &echo), &ScanPlan::new(1..=12));
            let told = (played.result.yielded.is_some(), played.addresses());
            assert_eq!(told, (false, vec![address]), "{by} ms: {:?}", played.warnings());
        }
    }
}

#[test]
fn the_setting_of_a_find_is_searched_to_the_end_at_once() {
    let setting = "baud = 9600\nparity = \"none\"";
    let bench = drives(&[(1, setting), (200, setting)]);
    let plan = ScanPlan {
        unknown: Unknown { baud: true, parity: true, protocol: true },
        manner: Manner::Fast,
        ..whole_line()
    };
    let played = play(&bench, &plan);
    let found: Vec<_> = played.result.drives.iter().map(|drive| (drive.address, drive.line.as_str())).collect();
    assert_eq!(found, [(1, "9600 8N2"), (200, "9600 8N2")]);
    assert!(played.took < Span::from_secs(12), "{}", played.took);
}

#[test]
fn an_empty_line_is_searched_at_every_setting_and_ends() {
    let bench = drives(&[(247, "baud = 2400\nparity = \"odd\"\nprotocol = \"ascii\"")]);
    let plan = ScanPlan { unknown: Unknown { baud: true, parity: true, protocol: true }, ..whole_line() };
    let played = play(&bench, &plan);
    assert_eq!(played.addresses(), [247], "the last address at the last setting");
    assert!(played.result.searched.iter().all(|searched| searched.is_complete()));
    assert!(played.took < Span::from_secs(700), "{}", played.took);
}

#[test]
fn a_search_for_settings_tells_them() {
    let bench = drives(&[(3, "baud = 57600\nparity = \"odd\"")]);
    let auto = "--baud auto --parity auto --protocol auto";
    let document = antrieb(&format!("-a 1-5 {auto} scan --until-first")).on(&bench).json().exits(0);
    assert_eq!((document.data("/line"), document.data("/protocol")), (&json!("auto"), &json!("auto")));
    let drive = document.data("/drives/0");
    assert_eq!(
        (&drive["address"], &drive["line"], &drive["protocol"]),
        (&json!(3), &json!("57600 8O1"), &json!("rtu"))
    );
    assert_eq!(document.data("/complete"), false);
    let table = antrieb(&format!("-a 1-5 --lang de {auto} scan --until-first")).on(&bench).exits(0);
    assert!(table.out.contains("57600 8O1") && table.out.contains("Protokoll"), "{}", table.out);
    let none = antrieb("-p sim -a 9 --parity auto scan").json().exits(1);
    assert!(none.error()["hint"].as_str().unwrap().contains("no setting brought an answer"));
    assert_eq!(none.data("/addresses"), 3);
}

#[test]
fn auto_and_several_ports_are_for_scan_only() {
    for line in ["--baud auto read 372", "--parity auto identify", "--protocol auto diag", "-p sim -p sim:x read 372"] {
        let document = antrieb(&format!("-p sim {line}")).json().exits(2);
        assert!(document.error()["hint"].as_str().unwrap().contains("scan"), "{line}");
    }
    antrieb("-p sim -p sim scan").json().exits(2);
    antrieb("-p sim -p sim:x --trace {dir}/t scan").json().exits(2);
    antrieb("-p sim scan --fast --thorough").json().exits(2);
    antrieb("-p sim --baud automatic scan").json().exits(2);
}

#[test]
fn several_ports_are_searched_in_one_go() {
    let one = drives(&[(1, ""), (3, "")]);
    let two = drives(&[(2, "")]);
    let line = "-p sim:{dir}/one.toml -p sim:{dir}/two.toml -a 1-5";
    let run = |more: &str| antrieb(&format!("{line} {more}")).file("one.toml", &one).file("two.toml", &two);
    let document = run("scan").json().exits(0);
    let found = document.data("/drives").as_array().unwrap();
    let found: Vec<_> = found.iter().map(|row| (row["address"].as_u64().unwrap(), file_name(&row["port"]))).collect();
    assert_eq!(found, [(1, "one.toml"), (3, "one.toml"), (2, "two.toml")]);
    assert_eq!((document.data("/addresses"), document.data("/asked")), (&json!(10), &json!(10)));
    let table = run("scan").exits(0);
    assert_eq!(table.rows().len(), 3);
    assert!(table.out.contains("two.toml"), "{}", table.out);
    let partly = antrieb("-p sim:{dir}/one.toml -p /dev/antrieb-has-no-such-port -a 1-5 scan").file("one.toml", &one);
    let document = partly.json().exits(9);
    assert_eq!(document.data("/drives/0/address"), 1);
    assert_eq!(document.data("/complete"), false);
}

fn file_name(port: &Value) -> &str {
    port.as_str().unwrap().rsplit('/').next().unwrap()
}

#[test]
fn a_search_goes_on_where_it_ended() {
    let bench = drives(&[(1, ""), (4, "baud = 9600")]);
    let first = antrieb("-a 1-5 --baud auto scan --until-first").on(&bench).json().exits(0);
    assert_eq!(first.data("/drives").as_array().unwrap().len(), 1);
    let mut saved = first.value.clone();
    // The bench of the second run stands in another directory.
    let port = "sim:again.toml";
    for place in ["/data/drives/0/port", "/data/searches/0/port"] {
        *saved.pointer_mut(place).unwrap() = json!(port);
    }
    let again = |saved: &Value, more: &str| {
        let line = format!("-p sim:{{dir}}/bench.toml -v -a 1-5 --baud auto {more} scan --resume {{dir}}/saved.json");
        let run = antrieb(&line).file("bench.toml", &bench);
        let text = saved.to_string().replace(port, &format!("sim:{}/bench.toml", run.directory().display()));
        run.file("saved.json", &text)
    };
    let document = again(&saved, "").json().exits(0);
    let found: Vec<_> = document.data("/drives").as_array().unwrap().iter().map(|row| row["address"].clone()).collect();
    assert_eq!(found, [1, 4]);
    assert_eq!(document.data("/complete"), true);
    let asked_at_first: Vec<_> = document.err.lines().filter(|line| line.contains(" ms > 01 03")).collect();
    assert!(asked_at_first.len() <= 7 * 3, "not at 19200 8E1 again: {asked_at_first:?}");
    // Where a drive was found is searched to the end before anything else is tried.
    let sent: Vec<&str> = document.err.lines().filter_map(|line| Some(&line.split_once(" ms > ")?.1[..5])).collect();
    assert_eq!(sent[..2], ["02 03", "03 03"]);
    // What it cannot go on from.
    let other = again(&json!({"schema": 1, "command": "read", "data": null}), "").json().exits(7);
    assert_eq!(other.error()["code"], "data.resume");
    let mut elsewhere = saved.clone();
    elsewhere["data"]["searches"][0]["port"] = json!("/dev/ttyUSB9");
    assert!(again(&elsewhere, "").json().exits(7).error()["message"].as_str().unwrap().contains("expected one of"));
    antrieb("-p sim scan --resume {dir}/none.json").json().exits(7);
    antrieb("-p sim scan --resume {dir}/cut.json").file("cut.json", "{\"schema\": 1, \"comm").json().exits(7);
}
