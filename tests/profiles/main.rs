//! The shipped catalogue against the facts: what the manuals print is there, and nothing is there twice or dangling.
//!
//! The lists are copied from the project's fact base (facts/bonfiglioli_*.csv), which is not part of the clone.

#![expect(clippy::unwrap_used, reason = "helpers of tests panic as tests do")]

mod lexium05;
mod parameter_files;

use antrieb::profile::value::parse_decimal;
use antrieb::profile::{Access, Family, HazardKind, Lang, Registry, Text};
use std::collections::{BTreeMap, BTreeSet};

/// Every parameter number of facts/bonfiglioli_params.csv.
#[rustfmt::skip]
const NUMBERS: [u32; 199] = [
    10, 11, 17, 18, 19, 30, 34, 62, 63, 66, 67, 68, 69, 70, 72, 73, 75, 76, 83, 99, 103, 131, 137, 210, 211, 213,
    217, 218, 219, 220, 228, 229, 230, 235, 241, 249, 250, 251, 253, 254, 260, 269, 270, 282, 283, 372, 373, 375,
    376, 381, 382, 392, 394, 395, 400, 405, 406, 407, 408, 410, 411, 412, 413, 414, 415, 417, 418, 419, 424, 425,
    426, 434, 450, 452, 474, 475, 476, 478, 480, 481, 482, 483, 484, 485, 486, 487, 488, 492, 506, 507, 510, 518,
    519, 524, 530, 531, 532, 533, 534, 540, 541, 542, 543, 544, 545, 549, 560, 561, 562, 563, 564, 565, 566, 567,
    568, 570, 600, 601, 602, 603, 604, 630, 631, 632, 637, 638, 680, 719, 728, 766, 791, 792, 900, 903, 904, 918,
    919, 921, 922, 923, 924, 925, 926, 927, 928, 929, 930, 931, 932, 933, 934, 935, 936, 937, 938, 939, 941, 942,
    945, 946, 947, 948, 949, 950, 951, 952, 953, 954, 955, 956, 957, 958, 959, 960, 961, 962, 963, 964, 965, 966,
    967, 968, 969, 972, 973, 974, 975, 976, 977, 978, 979, 989, 1200, 1201, 1202, 1375, 1376, 1457, 1458,
];

/// Number, decimals, lower and upper limit, factory setting, as printed; empty where nothing is printed.
///
/// Left out: rows whose sources contradict each other (11, 250, 931-938), depend on the configuration (418) or on the
/// drive (412: the factory setting is printed for the ACU only), or are given in another form (410, 411), and 375 and
/// 376, for which no range is printed.
#[rustfmt::skip]
const PRINTED: &[(u32, u8, &str, &str, &str)] = &[
    (10, 0, "1", "6", "4"), (34, 0, "0", "9999", ""), (219, 2, "0.0", "999.99", ""), (220, 0, "0", "60000", ""),
    (228, 2, "-1000.0", "1000.0", ""), (229, 2, "-300.0", "300.0", ""), (249, 0, "1", "4", ""),
    (260, 0, "0", "65535", ""), (270, 0, "0", "65535", ""), (282, 2, "-1000.0", "1000.0", ""),
    (283, 2, "-1000.0", "1000.0", ""), (381, 0, "1", "7", "1"), (382, 1, "-360.0", "360.0", "0.0"),
    (392, 0, "0", "2", "2"), (394, 0, "1", "30", ""), (395, 0, "0", "3", "0"), 
    (413, 0, "0", "10000", "0"), (414, 0, "0", "4", "0"), (419, 2, "0.0", "999.99", "50.0"),
    (424, 2, "0.01", "9999.99", ""), (425, 2, "0.01", "9999.99", ""), (434, 0, "1", "3", "3"),
    (450, 2, "0.0", "25.0", "2.0"), (480, 2, "-999.0", "999.0", "5.0"), (484, 2, "-999.99", "999.99", "0.0"),
    (492, 0, "0", "1", "0"), (518, 2, "0.0", "300.0", "0.0"), (519, 2, "0.0", "300.0", "100.0"),
    (524, 2, "-300.0", "300.0", "0.0"), (549, 2, "0.01", "20.0", ""), (560, 2, "0.0", "25.0", "2.0"),
    (564, 2, "-100.0", "100.0", "-98.0"), (565, 2, "-100.0", "100.0", "-100.0"),
    (566, 2, "-100.0", "100.0", "98.0"), (567, 2, "-100.0", "100.0", "100.0"), (600, 1, "0.0", "100.0", "5.0"),
    (601, 0, "-100", "200", "10"), (602, 0, "0", "100", "20"), (603, 1, "60.0", "560.0", "400.0"),
    (604, 2, "0.0", "599.0", "50.0"), (632, 1, "0.0", "200.0", ""), (637, 1, "0.0", "100.0", ""),
    (638, 1, "0.0", "200.0", ""), (766, 0, "1", "2", "1"), (900, 0, "-1", "63", "-1"), (903, 0, "3", "8", ""),
    (904, 0, "3500", "50000", "3500"), (918, 0, "0", "2047", "0"), (919, 0, "0", "50000", ""),
    (921, 0, "0", "2047", "0"), (922, 0, "0", "2047", "0"), (923, 0, "0", "1", ""), (924, 0, "0", "2047", "0"),
    (925, 0, "0", "2047", "0"), (926, 0, "0", "2047", "0"), (927, 0, "0", "2047", "0"), (928, 0, "0", "2047", "0"),
    (929, 0, "0", "2047", "0"), (930, 0, "0", "2", ""), (932, 0, "0", "2", ""), (934, 0, "0", "2", ""),
    (939, 0, "0", "60000", "0"), (941, 0, "0", "60000", "0"), (942, 0, "0", "60000", "0"),
    (945, 0, "0", "60000", "0"), (946, 0, "", "", "7"), (947, 0, "", "", "7"), (948, 0, "", "", "7"),
    (949, 0, "", "", "7"), (950, 0, "", "", "9"), (951, 0, "", "", "9"), (952, 0, "", "", "9"),
    (953, 0, "", "", "9"), (954, 0, "", "", "9"), (955, 0, "", "", "9"), (956, 0, "", "", "7"),
    (957, 0, "", "", "7"), (958, 0, "", "", "7"), (959, 0, "", "", "7"), (960, 0, "", "", "9"),
    (961, 0, "", "", "9"), (962, 0, "", "", "9"), (963, 0, "", "", "9"), (964, 0, "", "", "9"),
    (965, 0, "", "", "9"), (966, 0, "", "", "7"), (967, 0, "", "", "7"), (968, 0, "", "", "7"),
    (969, 0, "", "", "7"), (972, 0, "", "", "9"), (973, 0, "", "", "9"), (974, 0, "", "", "9"),
    (975, 0, "", "", "9"), (976, 0, "", "", "9"), (977, 0, "", "", "9"), (978, 0, "1", "3", ""),
    (979, 0, "1", "3", ""), (989, 0, "0", "1", ""), (1375, 0, "0", "2", "0"), (1376, 0, "1", "247", "1"),
];

/// Every key of facts/bonfiglioli_errors.csv; F21nn carries a node id in its low byte.
#[rustfmt::skip]
const FAULTS: [&str; 48] = [
    "F0000", "F0100", "F0102", "F0103", "F0200", "F0201", "F0300", "F0301", "F0400", "F0401", "F0402", "F0403",
    "F0500", "F0503", "F0504", "F0505", "F0506", "F0507", "F0700", "F0701", "F0702", "F0703", "F0704", "F0705",
    "F0706", "F0801", "F0804", "F1100", "F1101", "F1300", "F1301", "F1310", "F1401", "F1407", "F1421", "F1422",
    "F1423", "F1424", "F1430", "F1431", "F1432", "F2010", "F21nn", "F2200", "F2201", "F2202", "F2203", "F2210",
];

/// Every code of facts/bonfiglioli_sst_errors_11.csv.
const ERRORS: [u32; 19] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 20, 21, 30];

/// Parameters of the catalogue with the settings of the line, of the EEPROM-free commands, of the reset.
const LINE: [u32; 4] = [10, 395, 1375, 1376];
const COMMANDS: [u32; 3] = [410, 484, 524];

fn family(drive: &str) -> Family {
    Family::clone(&Registry::open(&[]).unwrap().family(drive).unwrap())
}

fn both() -> [Family; 2] {
    ["act", "acu"].map(family)
}

#[test]
fn six_drives_are_shipped() {
    let drives: Vec<_> = Registry::open(&[]).unwrap().drives().into_iter().map(|drive| drive.id).collect();
    assert_eq!(drives, ["act", "acu", "lxm05", "l200", "sj200", "x200"]);
}

#[test]
fn every_parameter_of_the_facts_is_there() {
    let [act, acu] = both();
    let missing: Vec<_> = NUMBERS.iter().filter(|id| act.param(**id).or(acu.param(**id)).is_none()).collect();
    assert!(missing.is_empty(), "{missing:?}");
    assert_eq!(NUMBERS.iter().collect::<BTreeSet<_>>().len(), 199);
    let unheard: Vec<_> = acu.params.keys().chain(act.params.keys()).filter(|id| !NUMBERS.contains(id)).collect();
    assert!(unheard.is_empty(), "no source: {unheard:?}");
}

/// P.219, frequency of the resolver.
const ENCODER_2: u32 = 219;

#[test]
fn ranges_and_factory_settings_are_those_that_are_printed() {
    let mut wrong = Vec::new();
    for family in both() {
        for &(id, decimals, min, max, default) in PRINTED {
            let Some(param) = family.param(id) else { continue };
            let raw = |text: &str| (!text.is_empty()).then(|| parse_decimal(text, decimals).unwrap());
            let told = (param.decimals_or_zero(), param.min, param.max, param.default);
            // Printed is 0 as the least, beside a text by which it is negative one way round (EM-RES-03 manual 6.4.1, 7.1).
            let least = if id == ENCODER_2 { None } else { raw(min) };
            let printed = (decimals, least, raw(max), raw(default));
            if told != printed {
                wrong.push(format!("{} {id}: {told:?} in place of {printed:?}", family.drive));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_factory_setting_of_the_control_mode_is_printed_for_the_acu() {
    let control_mode = family("acu").param(412).unwrap().clone();
    assert_eq!((control_mode.min, control_mode.max, control_mode.default), (Some(0), Some(44), Some(44)));
}

#[test]
fn no_range_is_invented_where_none_is_printed() {
    // CM-485 manual 8.1.2 and 8.1.4 show that 0 kW and 9.00 Hz are refused, but no table prints a limit.
    for family in both() {
        for id in [375, 376] {
            let param = family.param(id).unwrap();
            assert_eq!((param.min, param.max), (None, None), "{} {id}", family.drive);
        }
    }
}

#[test]
fn every_row_has_both_names_a_source_and_an_origin() {
    for family in both() {
        for param in family.params.values() {
            for name in param.name.both() {
                assert!(!name.trim().is_empty(), "{} {}", family.drive, param.id);
            }
            assert!(!param.source.is_empty(), "{} {}", family.drive, param.id);
            assert_eq!(param.origin, "built-in active.toml");
            for (raw, names) in family.choices(param) {
                assert!(names.iter().all(|name| !name.trim().is_empty()), "{} {} = {raw}", family.drive, param.id);
            }
        }
    }
}

#[test]
fn slugs_are_unique_and_stable_words() {
    for family in both() {
        let mut slugs = BTreeMap::new();
        for param in family.params.values() {
            let fits = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '-';
            assert!(!param.slug.is_empty() && param.slug.chars().all(fits), "{}: {}", param.id, param.slug);
            assert!(!param.slug.bytes().all(|byte| byte.is_ascii_digit()), "{}: {}", param.id, param.slug);
            if let Some(twin) = slugs.insert(param.slug.clone(), param.id) {
                panic!("{}: {} and {} are both called {}", family.drive, twin, param.id, param.slug);
            }
            assert_eq!(family.find(&param.slug).unwrap().id, param.id, "{}", param.slug);
        }
    }
}

/// "Fault" is how the name of its acknowledgment begins, which is 0 while there is one.
#[test]
fn a_word_that_is_the_start_of_one_name_and_stands_in_another_is_ambiguous() {
    for family in both() {
        for query in ["fault", "Fehler", "Störung"] {
            let told = family.find(query).unwrap_err().to_string();
            assert!(told.contains(query) && told.contains("103") && told.contains("260"), "{told}");
        }
        assert_eq!(family.find("nenndreh").unwrap().id, 372);
    }
}

#[test]
fn one_number_has_one_slug_on_both_drives() {
    let [act, acu] = both();
    for param in act.params.values() {
        let Some(twin) = acu.param(param.id) else { continue };
        assert_eq!(param.slug, twin.slug, "{}", param.id);
    }
}

#[test]
fn the_48_faults_have_name_group_cause_and_remedy() {
    for family in both() {
        let keys: Vec<_> = family.faults.iter().map(|row| row.key.as_str()).collect();
        assert_eq!(keys.iter().collect::<BTreeSet<_>>(), FAULTS.iter().collect::<BTreeSet<_>>());
        assert_eq!(keys.len(), 48, "none twice");
        for row in &family.faults {
            for lang in [Lang::En, Lang::De] {
                assert!(!row.name(lang).is_empty(), "{}", row.key);
                if row.code != 0 {
                    let told = [&row.cause, &row.remedy];
                    let is_told = |text: &Option<Text>| text.as_ref().is_some_and(|text| !text.get(lang).is_empty());
                    assert!(told.into_iter().all(is_told), "{}", row.key);
                    assert!(!family.fault_group(row.code).unwrap().name(lang).is_empty(), "{}", row.key);
                }
            }
            if row.key != "F21nn" {
                assert_eq!(row.key, format!("F{:04X}", row.code));
            }
        }
        for code in [0x2101, 0x2105, 0x213F] {
            assert_eq!(family.fault(code).unwrap().key, "F21nn", "{code:04X}");
        }
        for code in [0x2100, 0x2140, 0x0999] {
            assert!(family.fault(code).is_none(), "{code:04X}");
        }
    }
}

#[test]
fn all_16_bits_of_the_warning_word_are_named_and_explained() {
    for family in both() {
        let bits = family.word(family.role("warnings").unwrap(), 0xFFFF, |_| None);
        assert_eq!(bits.len(), 16);
        let slugs: BTreeSet<_> = bits.iter().map(|bit| bit.row.unwrap().slug.as_str()).collect();
        assert_eq!(slugs.len(), 16);
        for bit in bits {
            let row = bit.row.unwrap();
            let help = row.help.as_ref().unwrap();
            assert!([&*row.en, &*row.de, &*help.en, &*help.de].iter().all(|text| !text.is_empty()), "{}", bit.bit);
        }
    }
}

#[test]
fn the_error_register_is_complete() {
    for family in both() {
        let codes: Vec<_> = family.errors.iter().map(|row| row.code).collect();
        assert_eq!(codes.iter().copied().collect::<BTreeSet<_>>(), ERRORS.into_iter().collect());
        assert_eq!(codes.len(), ERRORS.len(), "none twice");
        let slugs: BTreeSet<_> = family.errors.iter().map(|row| row.slug.as_str()).collect();
        assert_eq!(slugs.len(), ERRORS.len());
        for row in &family.errors {
            assert!(
                [&*row.en, &*row.de, &*row.hint.en, &*row.hint.de].iter().all(|text| !text.is_empty()),
                "{}",
                row.code
            );
        }
    }
}

#[test]
fn bit_4_of_the_status_word_is_another_one_on_each_drive() {
    let slug = |drive: &str| {
        let family = family(drive);
        let bits = family.word(family.role("status-word").unwrap(), 0x0010, |_| None);
        bits.iter().find(|bit| bit.bit == 4).unwrap().row.unwrap().slug.clone()
    };
    assert_eq!((slug("act").as_str(), slug("acu").as_str()), ("voltage-disabled", "voltage-enabled"));
}

#[test]
fn every_state_is_the_meaning_of_some_status_word() {
    for family in both() {
        let met: BTreeSet<&str> = (0..=0x7F).filter_map(|word| Some(family.state(word)?.slug.as_str())).collect();
        let known: BTreeSet<&str> = family.states.iter().map(|state| state.slug.as_str()).collect();
        assert_eq!(met, known, "{}: no row hides another", family.drive);
        for (word, state) in [(0x0F, "fault-reaction-active"), (0x08, "fault"), (0x27, "operation-enabled")] {
            assert_eq!(family.state(word).unwrap().slug, state);
        }
        assert!(family.states.iter().all(|state| !state.en.is_empty() && !state.de.is_empty()));
    }
}

#[test]
fn the_control_word_has_names_for_every_control_mode() {
    for family in both() {
        let control = family.role("control-word").unwrap();
        let named = |mode: i64| {
            let bits = family.word(control, 0, |id| (id == 412).then_some(mode));
            bits.iter().map(|bit| bit.row.unwrap().slug.clone()).collect::<Vec<_>>()
        };
        assert!(named(1).contains(&"enable-operation".to_owned()), "{}", family.drive);
        assert_eq!(named(2)[0], "s1ind");
        assert!(named(0).is_empty(), "by contacts the word has no function");
    }
}

#[test]
fn values_with_names_have_them() {
    for family in both() {
        for (id, raws) in [
            (10, vec![1, 2, 3, 4, 5, 6]),
            (392, vec![0, 1, 2]),
            (395, vec![0, 2, 3]),
            (412, vec![0, 1, 2]),
            (414, vec![0, 1, 2, 3, 4]),
            (434, vec![1, 2, 3]),
            (1375, vec![0, 1, 2]),
        ] {
            let param = family.param(id).unwrap();
            for raw in raws {
                assert!(family.text_of(param, raw).is_some(), "{} {id} = {raw}", family.drive);
            }
        }
        for (id, raws) in [(978, [1, 2, 3]), (979, [1, 2, 3])] {
            let Some(param) = family.param(id) else { continue };
            assert!(raws.iter().all(|&raw| family.text_of(param, raw).is_some()), "{} {id}", family.drive);
        }
    }
    assert!(family("acu").param(978).is_some(), "the ACU may have the module");
}

#[test]
fn roles_and_groups_resolve_on_both_drives() {
    for family in both() {
        for role in [
            "status-word",
            "control-word",
            "fault",
            "warnings",
            "error-register",
            "control-mode",
            "active-set",
            "set-selection",
            "watchdog",
            "configuration",
            "baud-rate",
            "protocol",
            "parity",
            "address",
            "reset",
            "setpoint-frequency",
            "setpoint-percent",
            "setpoint-internal",
            "setpoint-bus",
            "setpoint-ramp",
            "percent-reference",
            "actual-frequency",
            "stator-frequency",
            "current",
            "ramp-setpoint",
            "transition-5",
            "min-frequency",
            "max-frequency",
        ] {
            assert!(family.role(role).is_some(), "{}: {role}", family.drive);
        }
        let names: Vec<String> = family.group_names().map(str::to_owned).collect();
        for name in ["actual", "modbus", "systembus", "all"] {
            assert!(names.iter().any(|known| known == name), "{}: @{name}", family.drive);
        }
        for name in &names {
            let members = family.group(name).unwrap();
            assert!(members.iter().all(|id| family.param(*id).is_some_and(|param| param.access.reads())), "@{name}");
            let once: BTreeSet<_> = members.iter().collect();
            assert_eq!(once.len(), members.len(), "@{name} names something twice");
        }
        assert!(!family.group("actual").unwrap().is_empty());
        assert!(family.group("nope").is_none());
    }
}

#[test]
fn the_error_register_and_the_commands_are_in_no_group() {
    for family in both() {
        let names: Vec<String> = family.group_names().map(str::to_owned).collect();
        for name in names {
            let members = family.group(&name).unwrap();
            assert!(!members.contains(&11), "@{name} would read P.11 away");
            if name != "all" {
                assert!(!members.iter().any(|id| COMMANDS.contains(id)), "@{name}");
            }
        }
    }
}

#[test]
fn what_is_dangerous_is_marked() {
    for family in both() {
        let hazard = |id: u32| family.param(id).unwrap().hazard;
        for id in LINE {
            assert_eq!(hazard(id), Some(HazardKind::Line), "{} {id}", family.drive);
        }
        for id in [68, 69, 410, 412, 480, 481, 484, 524] {
            assert_eq!(hazard(id), Some(HazardKind::Motion), "{} {id}", family.drive);
        }
        assert_eq!(hazard(34), Some(HazardKind::Reset));
        for id in COMMANDS {
            assert!(family.param(id).unwrap().volatile, "{} {id} lives in RAM only", family.drive);
        }
    }
}

#[test]
fn access_is_that_of_the_facts() {
    let [act, acu] = both();
    for id in [210, 211, 228, 241, 249, 250, 260, 270, 411] {
        assert_eq!(act.param(id).unwrap().access, Access::Read, "{id}");
        assert_eq!(acu.param(id).unwrap().access, Access::Read, "{id}");
    }
    // CM-485 manual 10.2.3: write-only on the ACU; chapter 9 reads it on the ACT.
    assert_eq!(acu.param(484).unwrap().access, Access::Write);
    assert!(act.param(484).unwrap().access.reads());
}

#[test]
fn what_no_second_source_confirms_says_so() {
    let acu = family("acu");
    for id in [418, 419, 483, 485, 486, 487, 488] {
        let unconfirmed = &acu.param(id).unwrap().unconfirmed;
        assert!(unconfirmed.iter().any(|field| field == "type" || field == "row"), "{id}: the type is assumed");
    }
    for id in [17, 18, 19, 99, 137] {
        assert!(!acu.param(id).unwrap().unconfirmed.is_empty(), "{id}: the row itself is doubtful");
    }
    for param in acu.params.values() {
        let known =
            ["row", "de", "en", "type", "decimals", "min", "max", "default", "access", "sets", "unit", "enum", "bits"];
        for field in &param.unconfirmed {
            assert!(known.contains(&field.as_str()), "{}: '{field}' is no field", param.id);
        }
    }
}

#[test]
fn the_counters_of_code_8_are_all_explained() {
    for family in both() {
        let subs: Vec<_> = family.counters.iter().map(|row| row.sub).collect();
        assert_eq!(subs, [0x0B, 0x0C, 0x0D, 0x0E, 0x0F, 0x10, 0x11, 0x12]);
        for row in &family.counters {
            assert!(
                [&*row.en, &*row.de, &*row.help.en, &*row.help.de].iter().all(|text| !text.is_empty()),
                "{}",
                row.slug
            );
        }
    }
}
