//! `systembus` through the program: plans, DCFs, pictures, loads.

use crate::run::antrieb;
use serde_json::json;

const PLAN: &str = include_str!("../../../docs/examples/system-bus-setpoint.toml");

#[test]
fn a_plan_goes_into_dcfs_and_comes_back() {
    let plan = antrieb("systembus plan {dir}/bus.toml").file("bus.toml", PLAN).json().exits(0);
    let run = antrieb("systembus plan {dir}/bus.toml --dcf {dir}").file("bus.toml", PLAN).exits(0);
    let dcf = run.text_of("drive-2.dcf");
    assert!(dcf.contains("[DeviceComissioning]\nNodeID=1\n"), "{dcf}");
    let back = antrieb("systembus plan {dir}/drive-1.dcf {dir}/drive-2.dcf")
        .file("drive-1.dcf", &run.text_of("drive-1.dcf"))
        .file("drive-2.dcf", &dcf)
        .json()
        .exits(0);
    for part in ["relations", "links", "total", "master", "sync_every_ms"] {
        assert_eq!(back.value["data"][part], plan.value["data"][part], "{part}");
    }
    // What is there already is not replaced unasked.
    let again = run.then("systembus plan {dir}/bus.toml --dcf {dir}");
    let again = again.exits(7);
    assert!(again.err.contains("--force"), "{}", again.err);
}

#[test]
fn a_plan_becomes_settings_links_and_a_load() {
    let run = antrieb("systembus plan {dir}/bus.toml").file("bus.toml", PLAN).json().exits(0);
    assert_eq!(*run.data("/total"), json!({"load_percent": 3.5, "verdict": "okay", "incomplete": false}));
    let link = run.data("/links/1");
    assert_eq!(json!([link["sender_param"], link["sender_source"]]), json!([955, 62]));
    assert_eq!(json!([link["receiver_param"], link["receiver_source"]]), json!([137, 709]));
    let settings = run.data("/drives/1/settings").as_array().unwrap();
    let of = |param: u32| settings.iter().find(|row| row["param"] == param).map(|row| row["raw"].clone());
    let page = antrieb("systembus plan {dir}/bus.toml --settings").file("bus.toml", PLAN).exits(0).out;
    assert!(page.contains("drive-2 (node 1)\n") && page.contains("TxPDO1 function"), "{page}");
    assert_eq!((of(99), of(924), of(936)), (Some(json!(704)), Some(json!(385)), Some(json!(1))));
}

#[test]
fn a_picture_is_drawn_in_both_languages_and_not_of_a_broken_plan() {
    for (lang, said) in [("en", "node 0, master"), ("de", "Knoten 0, Master")] {
        let line = format!("--lang {lang} systembus plan {{dir}}/bus.toml --svg {{dir}}/bus.svg");
        let picture = antrieb(&line).file("bus.toml", PLAN).exits(0).text_of("bus.svg");
        assert!(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"));
        assert!(picture.contains(said) && picture.contains("P.950 = 740"), "{picture}");
    }
    let broken = PLAN.replace("identifier = 385", "identifier = 150");
    let run =
        antrieb("systembus plan {dir}/bus.toml --svg {dir}/bus.svg --dcf {dir}").file("bus.toml", &broken).exits(1);
    assert!(run.err.contains("nothing was written"), "{}", run.err);
    assert!(!run.directory().join("bus.svg").exists() && !run.directory().join("drive-1.dcf").exists());
}

#[test]
fn what_is_no_plan_is_refused_with_its_place() {
    let wrong = PLAN.replace("rate = 500", "rate = 300");
    let run = antrieb("systembus plan {dir}/bus.toml").file("bus.toml", &wrong).json().exits(7);
    let message = run.error()["message"].as_str().unwrap();
    assert!(message.contains("bus.toml:3:8: ") && message.contains("300"), "{message}");
    antrieb("systembus plan {dir}/bus.toml {dir}/bus.toml").file("bus.toml", PLAN).exits(2);
    antrieb("systembus plan {dir}/none.toml").exits(7);
    antrieb("systembus plan {dir}/x.dcf").file("x.dcf", "hello").exits(7);
}

#[test]
fn loads_are_judged_on_the_exact_sum() {
    for (line, code, verdict) in [
        ("50 7 7", 0, "okay"),
        ("100 2 7", 0, "critical"),
        ("50 6 6", 1, "not_feasible"),
        ("1000 1 1 1 1 1", 0, "okay"),
    ] {
        let run = antrieb(&format!("systembus load {line}")).json().exits(code);
        assert_eq!(run.data("/total")["verdict"], verdict, "{line}");
    }
    antrieb("systembus load 300").exits(2);
    antrieb("systembus load 500 0").exits(2);
}
