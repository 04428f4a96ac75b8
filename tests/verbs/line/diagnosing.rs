//! `identify`, `diag`, `statemachine`, `sollwert`: who a drive is, what ails it, and what it is told to do.

use crate::run::antrieb;
use serde_json::json;

/// An ACU with a fault and three warnings.
const ILL: &str = "[[drive]]\nmodel = \"acu\"\naddress = 2\n\
                   [[drive.event]]\nat = \"0s\"\nfault = \"F2105\"\nwarning = 0x0083\n";

#[test]
fn identify_tells_family_settings_and_modules() {
    let document = antrieb("-p sim -a 1,2 identify").json().exits(0);
    assert_eq!(document.data("/drives/0/drive"), "act");
    assert_eq!(document.data("/drives/1/drive"), "acu");
    let params: Vec<_> =
        document.data("/drives/1/values").as_array().unwrap().iter().map(|value| value["param"].clone()).collect();
    assert_eq!(params, [1376, 395, 10, 1375, 413, 412, 30, 249, 414]);
    assert_eq!(document.data("/drives/1/values/1/text"), "Modbus RTU");
    assert_eq!(document.data("/drives/0/modules/0/present"), false);
    assert_eq!(document.data("/drives/1/modules/0/present"), true);
    let named = antrieb("-p sim -a 2 --drive acu identify").json().exits(0);
    assert_eq!(named.data("/drives/0/evidence/0/asked"), "--drive");
}

#[test]
fn an_acu_without_mains_is_still_an_acu() {
    let dark = "[[drive]]\nmodel = \"acu\"\naddress = 2\nmains = false\n";
    let document = antrieb("-a 2 identify").on(dark).json().exits(0);
    assert_eq!(document.data("/drives/0/drive"), "acu");
    assert_eq!(document.data("/drives/0/evidence").as_array().unwrap().last().unwrap()["answered"], "P.11 = 3");
}

#[test]
fn a_fault_is_told_with_cause_and_remedy_and_every_warning_by_name() {
    let document = antrieb("-a 2 diag").on(ILL).json().exits(0);
    let drive = document.data("/drives/0");
    assert_eq!(drive["healthy"], false);
    assert_eq!(drive["status"]["state"]["slug"], "fault");
    assert_eq!((&drive["fault"]["key"], &drive["fault"]["node"]), (&json!("F2105"), &json!(5)));
    assert!(drive["fault"]["cause"].is_string() && drive["fault"]["remedy"].is_string());
    let bits = drive["warnings"]["bits"].as_array().unwrap();
    let set: Vec<_> = bits.iter().filter(|bit| bit["set"] == true).map(|bit| bit["slug"].as_str().unwrap()).collect();
    assert_eq!((bits.len(), set), (16, vec!["ixt", "ixt-short", "motor-temperature"]));
    assert_eq!(drive["counters"].as_array().unwrap().len(), 8);
    let german = antrieb("-a 2 --lang de diag").on(ILL).exits(0);
    for word in ["Störung", "Ursache", "Abhilfe", "Warnungen", "fehlt"] {
        assert!(german.out.contains(word), "{word}: {}", german.out);
    }
    let scan = antrieb("scan").on(ILL).json().exits(0);
    assert!(scan.data("/drives/0/fault").as_str().unwrap().starts_with("F2105 "));
    assert_eq!(antrieb("-a 2 statemachine").on(ILL).json().exits(0).data("/drives/0/fault/code"), 0x2105);
}

#[test]
fn check_is_for_scripts() {
    assert_eq!(antrieb("-a 2 diag --check").on(ILL).json().exits(1).error()["code"], "no.fault_present");
    antrieb("-p sim -a 1,2 diag --check").json().exits(0);
    antrieb("-p sim -a 1,7 diag --check").json().exits(9);
}

#[test]
fn an_undocumented_fault_and_an_undefined_bit_are_shown() {
    let odd = "[[drive]]\nmodel = \"act\"\nset = { \"411\" = \"0x1023\" }\n\
               [[drive.event]]\nat = \"0s\"\nfault = \"F0999\"\n";
    let document = antrieb("-a 1 diag").on(odd).json().exits(0);
    assert_eq!(document.data("/drives/0/fault/key"), "F0999");
    assert_eq!(document.data("/drives/0/fault/cause"), &json!(null));
    assert_eq!(document.data("/drives/0/status/unknown"), &json!([12]));
}

#[test]
fn counters_are_cleared_only_after_asking() {
    let run = antrieb("-p sim -a 1 -v diag --clear").exits(8);
    assert_eq!(run.sent(), [""; 0]);
    let run = antrieb("-p sim -a 1 -v diag --clear").answered("n").exits(8);
    assert_eq!(run.sent(), [""; 0]);
    let document = antrieb("-p sim -a 1 diag --clear").answered("y").json().exits(0);
    assert_eq!(document.data("/drives/0/counters_cleared"), true);
    assert!(document.data("/drives/0/counters/0/count").as_u64().unwrap() > 0, "shown before they are lost");
}

#[test]
fn the_link_test_counts_and_measures() {
    let fine = antrieb("-p sim -a 1 diag --link-test 50").json().exits(0);
    let link = fine.data("/drives/0/link");
    assert_eq!((&link["asked"], &link["replies"], &link["error_rate_percent"]), (&json!(50), &json!(50), &json!(0.0)));
    assert!(link["fastest_us"].as_u64().unwrap() >= 10_000, "not before 10 ms (CM-485 manual 6.8)");
    let lossy = "[[drive]]\nmodel = \"act\"\n[[disturb]]\nevery = 5\nkind = \"lost\"\n";
    let lossy = antrieb("-a 1 diag --link-test 100").on(lossy).json().exits(0);
    let link = lossy.data("/drives/0/link");
    assert_eq!(link["replies"].as_u64().unwrap() + link["silent"].as_u64().unwrap(), 100);
    assert!(link["silent"].as_u64().unwrap() > 10, "{link}");
    assert!(link["error_rate_percent"].as_f64().unwrap() > 10.0, "{link}");
    for bad in ["0", "-1", "x"] {
        antrieb(&format!("-p sim -a 1 diag --link-test {bad}")).json().exits(2);
    }
}

#[test]
fn the_state_names_the_control_word_by_the_control_mode() {
    let bench = |mode: &str| format!("[[drive]]\nmodel = \"act\"\nset = {{ \"412\" = {mode} }}\n");
    let slugs = |mode: &str| {
        let document = antrieb("-a 1 statemachine").on(&bench(mode)).json().exits(0);
        assert_eq!(document.data("/drives/0/control_mode/param"), 412);
        let bits = document.data("/drives/0/control/bits").as_array().unwrap().clone();
        bits.iter().map(|bit| bit["slug"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert!(slugs("1").contains(&"enable-operation".to_owned()));
    assert!(slugs("2").contains(&"s1ind".to_owned()));
    assert_eq!(slugs("0"), [""; 0], "by contacts the word has no function");
    antrieb("-p sim -a 1 statemachine show").exits(0);
    assert_eq!(antrieb("-p sim -a 1 state").exits(0).out, antrieb("-p sim -a 1 statemachine").exits(0).out);
    assert_eq!(antrieb("-p sim -a 1 state").json().value["command"], "statemachine");
}

#[test]
fn setpoints_and_actual_values_stand_side_by_side() {
    let bench = "[[drive]]\nmodel = \"acu\"\nset = { \"228\" = \"12.5\", \"210\" = \"12.49\", \"434\" = 1 }\n";
    let document = antrieb("-a 1 sollwert").on(bench).json().exits(0);
    assert_eq!(document.data("/drives/0/setpoints/0/value"), 12.5);
    assert_eq!(document.data("/drives/0/actual/1/value"), 12.49);
    assert_eq!(document.data("/drives/0/sources/0/param"), 434);
    assert_eq!(antrieb("-a 1 setpoint").on(bench).json().value["command"], "sollwert");
}
