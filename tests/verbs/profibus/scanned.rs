//! Stations of a PROFIBUS line, found by the general verbs, and as they come and go.

use super::rig::{event, module};
use super::{is_let_go, later, line};
use crate::run::antrieb;
use antrieb::transport::witness;

#[test]
fn a_scan_is_the_live_list_as_drives() {
    let run = antrieb("-p sim --protocol dp scan").json().exits(0);
    let drives = run.data("/drives").as_array().unwrap();
    let told = |at: usize, key: &str| drives[at][key].clone();
    assert_eq!([told(0, "address"), told(1, "address")], [3, 5]);
    assert_eq!((told(0, "drive"), told(0, "product")), ("unknown".into(), "0BE7".into()));
    assert_eq!(drives[0]["state"]["slug"], "wait-prm");
    // The same words as `profibus live` has for it.
    assert_eq!(drives[0]["state"]["name"], "waits for Set_Prm");
    assert_eq!([run.data("/asked"), run.data("/addresses")], [126, 126]);
    assert_eq!(run.data("/complete"), true);
    let bus = later();
    assert!(is_let_go(&bus) && bus.remarks().is_empty());
    let run = antrieb("-p sim --protocol dp -a 9,10 scan").json().exits(1);
    assert_eq!(run.error()["code"], "no.station");
    let run = antrieb("-p sim --protocol dp scan --until-first").json().exits(0);
    assert_eq!(run.data("/drives").as_array().unwrap().len(), 1);
    assert_eq!(run.data("/searches/0/open"), "4-125");
    let run = antrieb("-p sim --protocol dp scan --within 200ms").json().exits(9);
    assert_eq!(run.data("/complete"), false);
    for option in ["--thorough", "--fast", "--resume x.json"] {
        antrieb(&format!("-p sim --protocol dp scan {option}")).exits(2);
    }
}

#[test]
fn a_speed_that_nobody_knows_is_found() {
    for baud in [9_600, 93_750, 500_000] {
        let text = line(&format!("baud = {baud}"), "");
        let run = antrieb("--protocol dp --baud auto -a 1-5 scan").on(&text).json().exits(0);
        assert_eq!(run.data("/drives/0/line"), &format!("{baud} 8E1"));
        assert_eq!(run.data("/drives").as_array().unwrap().len(), 1);
        assert!(is_let_go(&later()), "{baud}");
    }
    let run = antrieb("-p sim --protocol dp --baud auto -a 9 scan").json().exits(1);
    assert_eq!(run.data("/settings"), 6);
    let run = antrieb("-p sim --protocol dp --baud auto --dry-run scan").json().exits(0);
    assert!(run.data("/notes/0").as_str().unwrap().contains("6 speed(s)"));
    antrieb("-p sim --protocol dp --baud auto -a 3 --yes read F002").exits(2);
}

#[test]
fn who_a_slave_is_is_told_by_itself_and_its_gsd() {
    const GSD: &str =
        "#Profibus_DP\nModel_Name=\"bench\"\nIdent_Number=0x0BE7\nModule=\"PPO 1\" 0xF3,0xF1\n1\nEndModule\n";
    let typed = "-a 3 --protocol dp --yes identify --gsd {dir}/slave.gsd";
    let run = antrieb(typed).file("slave.gsd", GSD).on(&line("", "")).json();
    assert_eq!(run.data("/drives/0/drive"), "l200");
    assert_eq!(run.data("/drives/0/product"), "bench");
    assert_eq!(run.data("/drives/0/evidence/0/answered"), "0BE7h");
    let params: Vec<_> = run.data("/drives/0/values").as_array().unwrap().iter().collect();
    let raw = |id: u32| params.iter().find(|value| value["param"] == id).unwrap()["raw"].clone();
    assert_eq!([raw(624), raw(801), raw(918)], [0x20, 0x200, 3]);
    assert_eq!(params.iter().filter(|value| value["param"] == 964).count(), 5);
    assert!(is_let_go(&later()));
    antrieb("-a 3 --protocol dp identify").on(&line("", "")).exits(8);
    assert!(witness::left_profibus().is_none(), "no line was opened");
    antrieb("-a 9 --protocol dp --yes identify").on(&line("", "")).exits(4);
    antrieb("-p sim -a 1 identify --gsd x.gsd").exits(2);
}

#[test]
fn a_station_that_goes_and_comes_is_told() {
    let events = event("3s", "cut = true") + &event("6s", "cut = false");
    let typed = "-a 2-4 profibus live --follow --duration 9s --format ndjson";
    let run = antrieb(typed).on(&module("", "", &events)).exits(0);
    let records: Vec<serde_json::Value> = run.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let news: Vec<_> = records.iter().filter(|record| record["type"] == "station").collect();
    let told: Vec<_> =
        news.iter().map(|news| (news["change"].as_str().unwrap(), news["station"]["address"].clone())).collect();
    assert_eq!(told, [("came", 3.into()), ("went", 3.into()), ("came", 3.into())]);
    let at = |nth: usize| news[nth]["t"].as_f64().unwrap();
    assert!(at(0) < 1.0 && (1.0..4.0).contains(&at(1)) && (4.0..7.0).contains(&at(2)), "{news:?}");
    assert_eq!(news[0]["station"]["ident"], "0BE7");
    assert_eq!(records.last().unwrap()["type"], "end");
    let run = antrieb("-a 3 profibus live --follow --duration 1s").on(&module("", "", "")).exits(0);
    assert!(
        run.out.contains("came") && run.out.contains("0BE7") && run.out.contains("waits for Set_Prm"),
        "{}",
        run.out
    );
    let run = antrieb("-a 3 profibus live --follow --duration 1s").on(&module("", "", "")).json().exits(0);
    assert_eq!(run.data("/stations/0/address"), 3);
}
