//! Plans of a system bus, by the printed examples of the EM-RES-03 manual (5.11, 5.14), and every rule that one can break.

use super::*;
use crate::profile::{Family, Registry};
use crate::protocol::can::PdoNumber;
use crate::protocol::can::pdo::{Kind, Place};
use proptest::prelude::*;
use std::rc::Rc;

fn family() -> Rc<Family> {
    Registry::open(&[]).unwrap().family("acu").unwrap()
}

const RELATIONS: &str = include_str!("../../docs/examples/system-bus-relations.toml");
const LINKS: &str = include_str!("../../docs/examples/system-bus-links.toml");
const WORDS: &str = include_str!("../../docs/examples/system-bus-links-as-words.toml");
const SETPOINT: &str = include_str!("../../docs/examples/system-bus-setpoint.toml");

fn codes(plan: &Plan) -> Vec<(Level, &'static str)> {
    check(plan, &family()).into_iter().map(|remark| (remark.level, remark.code)).collect()
}

#[track_caller]
fn has(text: &str, level: Level, code: &str) {
    let plan = read(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert!(codes(&plan).contains(&(level, code)), "{:#?}\n{text}", check(&plan, &family()));
}

fn value(plan: &Plan, drive: usize, param: u32) -> Option<i64> {
    settings(plan, &plan.drives[drive]).into_iter().find(|setting| setting.param == param).and_then(|row| row.value)
}

#[test]
fn telegram_times_and_the_table_of_loads_are_those_that_are_printed() {
    // EM-RES-03 manual 5.14.3.
    let times = Rate::ALL.map(|rate| (rate.kbd(), rate.telegram_us()));
    assert_eq!(times, [(1000, 140), (500, 280), (250, 560), (125, 1120), (100, 1400), (50, 2800)]);
    let printed = [
        "14 7 4.7 3.5 2.8 2.3 2 1.8 1.6 1.4",
        "28 14 9.3 7 5.6 4.7 4 3.5 3.1 2.8",
        "56 28 18.7 14 11.2 9.3 8 7 6.2 5.6",
        "112 56 37.3 28 22.4 18.7 16 14 12.4 11.2",
        "140 70 46.7 35 28 23.3 20 17.5 15.6 14",
        "280 140 93.3 70 56 46.7 40 35 31.1 28",
    ];
    for (rate, printed) in Rate::ALL.into_iter().zip(printed) {
        let row: Vec<String> = (1..=10).map(|ms| rate.load(ms).unwrap().to_string()).collect();
        assert_eq!(row.join(" "), printed, "{} kBd", rate.kbd());
    }
}

#[test]
fn limits_are_judged_on_the_exact_sum() {
    let budget = |kbd, ms: &[u32]| Budget::new(Rate::of_kbd(kbd).unwrap(), ms.iter().copied().map(Some)).total;
    // The sheet of 5.14.3: five PDOs every millisecond at 1000 kBd.
    assert_eq!(budget(1000, &[1; 5]).to_string(), "70");
    // 80 is still okay, 90 still critical; the rounded rows would say otherwise.
    for (kbd, ms, verdict) in [
        (50, &[7, 7][..], Verdict::Okay),
        (50, &[6, 6, 6][..], Verdict::NotFeasible),
        (100, &[2, 14][..], Verdict::Okay),
        (100, &[2, 7][..], Verdict::Critical),
    ] {
        let total = budget(kbd, ms);
        assert_eq!(total.verdict(), verdict, "{kbd} {ms:?}: {total}");
    }
    assert_eq!((budget(50, &[7, 7]), budget(100, &[2, 7])), (Load::percent(80), Load::percent(90)));
    // Three thirds are a whole: 3 x 14/3 = 14, though each row shows 4.7.
    assert_eq!(budget(1000, &[3; 3]), Load::percent(14));
    assert!(!budget(50, &[21; 6]).exceeds(80) && budget(50, &[21; 6]) == Load::percent(80));
    assert!(Rate::of_kbd(50).unwrap().load(0).is_none());
}

#[test]
fn ends_are_those_of_the_tables() {
    let place = |kind, number| Place::new(kind, number).unwrap();
    let input = |pdo, kind, number| ends::input(pdo, place(kind, number));
    use PdoNumber::{One, Three, Two};
    assert_eq!([input(One, Kind::Boolean, 1), input(One, Kind::Word, 4), input(One, Kind::Long, 2)], [946, 953, 955]);
    assert_eq!([input(Two, Kind::Boolean, 2), input(Two, Kind::Word, 1), input(Two, Kind::Long, 1)], [957, 960, 964]);
    assert_eq!([input(Three, Kind::Boolean, 4), input(Three, Kind::Word, 1)], [969, 972]);
    assert_eq!([input(Three, Kind::Word, 4), input(Three, Kind::Long, 2)], [975, 977]);
    assert_eq!([ends::source(One, place(Kind::Long, 2)), ends::source(Three, place(Kind::Word, 4))], [709, 727]);
    // Every one of them is called so by the catalogue.
    let family = family();
    for pdo in PdoNumber::ALL {
        for place in Place::all() {
            let name = format!("TxPDO{} {}", pdo.number(), place).to_lowercase();
            assert_eq!(family.param(ends::input(pdo, place)).unwrap().name.de.to_lowercase(), name);
            let source = i64::from(ends::source(pdo, place));
            let told = family.text_of(family.param(946).unwrap(), source).unwrap();
            assert_eq!(told.en.to_lowercase(), name.replace("tx", "rx"));
        }
    }
}

#[test]
fn the_relations_of_the_manual_are_those_of_its_table() {
    let plan = read(RELATIONS).unwrap();
    let told: Vec<_> = relations(&plan)
        .iter()
        .map(|relation| {
            let receivers: Vec<_> = relation.receivers.iter().map(|one| (one.drive, one.rx.number.number())).collect();
            (relation.identifier, relation.sender, receivers)
        })
        .collect();
    assert_eq!(
        told,
        [
            (385, Some("inverter-1"), vec![("inverter-2", 1), ("inverter-3", 1)]),
            (641, Some("inverter-1"), vec![("inverter-2", 2)]),
            (642, Some("inverter-3"), vec![("inverter-2", 3)]),
        ]
    );
    let found = codes(&plan);
    assert!(!found.iter().any(|remark| remark.0 == Level::Error), "{found:?}");
    assert!(found.contains(&(Level::Note, "identifier_preset")), "642 is TxPDO2 of node 2: {found:?}");
    assert_eq!((value(&plan, 1, 926), value(&plan, 1, 928), value(&plan, 1, 932)), (Some(641), Some(642), Some(0)));
}

#[test]
fn virtual_links_are_those_of_the_manual() {
    let set = |text: &str, drive, params: &[u32]| -> Vec<i64> {
        let plan = read(text).unwrap();
        assert!(!codes(&plan).iter().any(|remark| remark.0 == Level::Error));
        params.iter().map(|param| value(&plan, drive, *param).unwrap()).collect()
    };
    // 5.11.5.3, example 1.
    assert_eq!(set(SETPOINT, 0, &[950, 955, 925, 930]), [740, 62, 385, 1]);
    assert_eq!(set(SETPOINT, 1, &[99, 137, 924, 936]), [704, 709, 385, 1]);
    // 5.11.5, example 2, in both corrected forms (facts G3.2).
    assert_eq!((set(LINKS, 0, &[977, 972]), set(LINKS, 1, &[125, 187])), (vec![27, 5], vec![729, 724]));
    assert_eq!((set(WORDS, 0, &[975, 972]), set(WORDS, 1, &[125, 187])), (vec![27, 5], vec![727, 724]));
    // As printed: P.977 with 727.
    has(&LINKS.replace("take = { long2", "take = { word4"), Level::Error, "places_differ");
    let plan = read(SETPOINT).unwrap();
    let told: Vec<_> = links(&plan).iter().map(|link| (link.input, link.output)).collect();
    assert_eq!(told, [(Some((950, 740)), Some((99, 704))), (Some((955, 62)), Some((137, 709)))]);
    // What is not used is switched off and emptied, as the example says.
    assert_eq!(set(SETPOINT, 0, &[932, 934, 946, 951, 954, 977]), [0, 0, 7, 9, 9, 9]);
}

/// A plan of two drives with one PDO, and something changed in it.
fn changed(old: &str, new: &str) -> String {
    assert!(SETPOINT.contains(old), "{old}");
    SETPOINT.replacen(old, new, 1)
}

#[test]
fn every_rule_of_the_manual_is_checked() {
    use Level::{Error, Note, Warning};
    for (old, new, level, code) in [
        ("node = 1", "node = 0", Error, "node_twice"),
        ("sync-every = 10", "master = \"external\"", Error, "two_masters"),
        ("node = 0                # the master", "node = 2", Warning, "no_master"),
        ("identifier = 385", "identifier = 150", Error, "identifier_emergency"),
        ("identifier = 385", "identifier = 128", Error, "identifier_taken"),
        ("identifier = 385", "identifier = 1537", Error, "identifier_taken"),
        ("identifier = 385", "identifier = 1793", Error, "identifier_taken"),
        ("identifier = 385", "identifier = 384", Warning, "identifier_advised"),
        ("identifier = 385", "", Warning, "identifier_advised"),
        ("identifier = 385", "identifier = 513", Note, ""),
        ("sync-every = 10", "sync-every = 10\nsync-identifier = 130", Error, "identifier_emergency"),
        ("sync-every = 10", "sync-every = 10\nsync-identifier = 385", Error, "identifier_taken"),
        ("sync-every = 10", "sync-every = 10\nsync-identifier = 100", Warning, "sync_identifier"),
        ("node = 1", "node = 1\nrx-sdo1-identifier = 1700", Error, "sdo_identifier"),
        ("word1 = 740,", "word4 = 740,", Error, "byte_twice"),
        ("word1 = 99,", "word4 = 99,", Error, "byte_twice"),
        ("word1 = 740,", "boolean1 = 740,", Warning, "source_kind"),
        ("word1 = 740,", "word1 = 9,", Warning, "unused"),
        ("word1 = 740,", "word1 = 999,", Note, "source_unknown"),
        ("word1 = 99, long2 = 137", "word1 = 137, long2 = 137", Error, "parameter_twice"),
        ("word1 = 99,", "word1 = 480,", Warning, "no_source"),
        ("word1 = 99,", "word1 = 99,", Note, "motion"),
        ("every = 8", "every = 0", Error, "send_time"),
        ("every = 8", "every = 50001", Error, "send_time"),
        ("timeout = 40", "timeout = 60001", Error, "timeout_range"),
        ("timeout = 40", "timeout = 8", Error, "timeout_short"),
        ("timeout = 40", "timeout = 15", Warning, "timeout_tight"),
        ("timeout = 40", "timeout = 0", Note, "unwatched"),
        ("sync-timeout = 0", "sync-timeout = 50", Warning, "sync_timeout_idle"),
        ("rx-functions = \"0-2\"", "", Note, "rx_functions"),
        ("boot-up-delay = 3500", "boot-up-delay = 100", Error, "boot_up_delay"),
        ("node = 1", "node = 1\nemergency-reaction = \"warning\"", Warning, "not_master"),
    ] {
        if code.is_empty() {
            assert!(!codes(&read(&changed(old, new)).unwrap()).iter().any(|remark| remark.0 == Error));
        } else {
            has(&changed(old, new), level, code);
        }
    }
    let by_sync = changed("every = 8", "on-sync = true");
    has(&by_sync.replace("sync-every = 10", "sync-every = 0"), Error, "no_sync");
    has(&by_sync.replace("sync-every = 10", ""), Error, "no_sync");
    has(&by_sync.replace("sync-timeout = 0", "sync-timeout = 10"), Error, "timeout_short");
    has(&changed("rate = 500", "rate = 50").replace("every = 8", "every = 2"), Error, "pdo_load");
    has(&changed("rate = 500", "rate = 50").replace("every = 8", "every = 3"), Error, "bus_load");
    let twice = format!("{SETPOINT}\n[[pdo]]\nfrom = \"drive-2\"\nnumber = 1\nidentifier = 385\nevery = 8\n");
    has(&twice, Error, "identifier_twice");
    has(&twice.replace("from = \"drive-2\"", "from = \"drive-1\""), Error, "pdo_twice");
    has(&twice.replace("number = 1\nidentifier = 385\nevery = 8\n", "number = 2\nevery = 8\n"), Note, "unheard");
    has(&changed("drive = \"drive-2\"", "drive = \"drive-1\""), Warning, "own_pdo");
}

#[test]
fn a_controller_may_send_and_its_plan_says_so() {
    let text = changed("from = \"drive-1\"\nnumber = 1\n", "from = \"plc\"\n")
        .replace("put = { word1 = 740, long2 = 62 }", "");
    let plan = read(&text).unwrap();
    assert_eq!((plan.foreign[0].name.as_str(), plan.foreign[0].identifier), ("plc", 385));
    assert_eq!((value(&plan, 1, 99), value(&plan, 0, 930)), (Some(704), Some(0)));
    assert!(!codes(&plan).iter().any(|remark| remark.0 == Level::Error), "{:?}", codes(&plan));
}

#[test]
fn what_is_no_plan_is_refused_with_its_place() {
    for (old, new, line) in [
        ("rate = 500", "rate = 300", 3),
        ("rate = 500", "rate = \"x\"", 3),
        ("node = 1", "node = 64", 12),
        ("node = 1", "knoten = 1", 12),
        ("from = \"drive-1\"", "from = \"frist\"", 16),
        ("drive = \"drive-2\"", "drive = \"secnod\"", 23),
        ("identifier = 385", "identifier = 2048", 18),
        ("word1 = 740", "word5 = 740", 20),
        ("every = 8", "", 16),
        ("every = 8", "every = 8\non-sync = true", 16),
        ("number = 1", "number = 4", 17),
    ] {
        let error = read(&changed(old, new)).unwrap_err();
        assert_eq!(error.line, line, "{new}: {error}");
    }
}

#[test]
fn a_dcf_comes_back_as_the_plan_that_it_was_made_of() {
    for text in [RELATIONS, LINKS, WORDS, SETPOINT] {
        let plan = read(text).unwrap();
        let files: Vec<(String, String)> =
            plan.drives.iter().map(|drive| (drive.name.clone(), dcf(&plan, drive, &family()).0)).collect();
        let mut back = from_dcf(&files).unwrap();
        // What a DCF has no room for.
        (back.has_external_master, back.sync_every_ms) = (plan.has_external_master, plan.sync_every_ms);
        back.drives.iter_mut().zip(&plan.drives).for_each(|(back, drive)| back.numbering = drive.numbering);
        for (back, drive) in back.drives.iter_mut().zip(&plan.drives) {
            let sorted = |rx: &mut Vec<(Place, u32)>| rx.sort_unstable();
            back.rx.iter_mut().for_each(|rx| sorted(&mut rx.outputs));
            let mut expected = drive.clone();
            expected.rx.iter_mut().for_each(|rx| sorted(&mut rx.outputs));
            expected.tx.iter_mut().for_each(|tx| tx.inputs.sort_unstable());
            back.tx.iter_mut().for_each(|tx| tx.inputs.sort_unstable());
            expected.tx.sort_by_key(|tx| tx.number);
            assert_eq!(*back, expected);
        }
    }
}

#[test]
fn a_dcf_is_spelt_as_the_standard_has_it_and_read_in_both_ways() {
    let plan = read(SETPOINT).unwrap();
    let (text, open) = dcf(&plan, &plan.drives[1], &family());
    assert!(text.contains("[DeviceComissioning]\nNodeID=1\nNodeName=drive-2\nBaudrate=500\n") && open.is_empty());
    assert!(text.contains("\n[0063]\nParameterName=") && text.contains("ParameterValue=704"));
    let read_back = |text: String| from_dcf(&[("x.dcf".to_owned(), text)]);
    assert!(read_back(text.replace("Comissioning", "Commissioning")).is_ok());
    assert!(read_back(text.replace("ParameterValue=704", "ParameterValue=7o4")).is_err());
    assert!(read_back(text.replace("NodeID=1", "").replace("ParameterValue=1\n", "")).is_err());
    let relative = read_back(text.replace("ParameterValue=385", "ParameterValue=$NODEID+0x180")).unwrap();
    assert_eq!(relative.drives[0].rx[0].identifier, 385);
    // Which functions a drive counts how is not known: they are left out, and said to be.
    let plan = read(LINKS).unwrap();
    assert_eq!(dcf(&plan, &plan.drives[1], &family()).1, [938]);
}

proptest! {
    #[test]
    fn no_text_brings_a_reader_down(text in "\\PC{0,60}", at in 0..900_usize) {
        let _ = read(&text);
        let mut broken = SETPOINT.to_owned();
        let at = (0..=at.min(broken.len())).rev().find(|at| broken.is_char_boundary(*at)).unwrap();
        broken.insert_str(at, &text);
        if let Ok(plan) = read(&broken) {
            let _ = (check(&plan, &family()), links(&plan), relations(&plan), plan.budget());
        }
        let _ = from_dcf(&[("x".to_owned(), format!("[0384]\nParameterValue={text}\n{text}"))]);
    }
}

/// A load that is more than the limit and rounds to it is shown with the digits that tell it.
#[test]
fn a_load_just_above_a_limit_is_not_shown_as_the_limit() {
    let load = |every_ms: &[u32]| Budget::new(Rate::of_kbd(1000).unwrap(), every_ms.iter().copied().map(Some)).total;
    // 140 us each: 14 % every ms, so six are 84, and the rest 6.02.
    let total = load(&[1, 1, 1, 1, 1, 1, 5, 5, 50, 100]);
    assert!(total.exceeds(90) && total.to_string() == "90", "{total} {}", total.rounded());
    assert_eq!(total.beyond(90), "90.02");
    assert_eq!((load(&[1]).beyond(90), load(&[1]).beyond(80)), ("14".to_owned(), "14".to_owned()));
}
