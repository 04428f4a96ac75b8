//! A slave as its GSD describes it, and how it answers.

use super::rig::module;
use super::{is_let_go, later, line};
use crate::run::{Run, antrieb};

/// What the bench says of itself: its ident number is made up, and no source tells what a true GSD has.
const GSD: &str = "#Profibus_DP\nModel_Name=\"bench\"\nIdent_Number=0x0BE7\nModule=\"PPO 1\" 0xF3,0xF1\n1\nEndModule\n\
    Module=\"L200 Basic\" 0xF3\n2\nExt_User_Prm_Data_Const(0)=0xC7,0xFF,0xFF\nEndModule\n\
    Module=\"SJ200 Basic\" 0xF3\n3\nExt_User_Prm_Data_Const(0)=0x47,0xFF,0xFF\nEndModule\n";

fn with(gsd: &str, typed: &str) -> Run {
    antrieb(&format!("-a 3 --protocol dp --yes {typed} --gsd {{dir}}/slave.gsd")).file("slave.gsd", gsd)
}

#[test]
fn its_ident_number_and_its_module_go_into_set_prm() {
    let run = with(GSD, "read F002").on(&line("", "")).json().exits(0);
    assert_eq!(run.data("/values/0/raw"), -1_000);
    assert!(is_let_go(&later()));
    let run = with(GSD, "--drive l200 statemachine --mode basic").on(&module("", "", "")).json().exits(0);
    assert_eq!(run.data("/drives/0/state/slug"), "stop");
}

#[test]
fn another_slave_than_the_gsd_describes_is_asked_and_nothing_else() {
    let other = GSD.replace("0x0BE7", "0x1337");
    let run = with(&other, "read F002").on(&line("", "")).json().exits(7);
    assert_eq!(run.error()["code"], "data.ident");
    assert!(run.error()["message"].as_str().unwrap().contains("0BE7h"));
    let bus = later();
    assert!(is_let_go(&bus) && bus.remarks().is_empty());
}

#[test]
fn a_module_that_is_missing_or_one_of_several_is_named_before_a_line_is_opened() {
    let run = with(GSD, "statemachine --mode basic").on(&line("", "")).json().exits(7);
    assert_eq!(run.error()["code"], "data.gsd_module");
    assert!(run.error()["message"].as_str().unwrap().contains("SJ200 Basic (F3)"));
    let without = GSD.replace("0xF3,0xF1", "0xF3,0xF5");
    let run = with(&without, "statemachine --mode profidrive").on(&line("", "")).json().exits(7);
    assert_eq!(run.error()["code"], "data.gsd_module");
}

#[test]
fn what_is_no_gsd_is_told_with_its_line() {
    // Each part fits into Set_Prm, and the two together do not.
    let long = GSD.replace("0xF3,0xF1\n", "0xF3,0xF1\nExt_User_Prm_Data_Const(230)=1\n");
    let long = long.replace("Ident_Number", "User_Prm_Data=1,2,3,4,5,6,7,8\nIdent_Number");
    for (from, to, told) in [("#Profibus_DP", "", "#Profibus_DP"), ("0xF3,0xF1", "0xF3,PPO", ":5:"), ("", "", "239")] {
        let run = with(&long.replace(from, to), "read F002").on(&line("", "")).json().exits(7);
        assert_eq!(run.error()["code"], "data.gsd");
        assert!(run.error()["message"].as_str().unwrap().contains(told), "{}", run.error());
    }
    antrieb("-a 3 read F002 --gsd none.gsd").on(&line("", "")).exits(2);
    antrieb("-a 3 --protocol dp read F002 --gsd none.gsd").on(&line("", "")).exits(7);
}

#[test]
fn a_station_that_is_asked_often_shows_how_it_answers() {
    let run = antrieb("-a 3 profibus live --questions 200").on(&line("losses = 20", "")).json().exits(0);
    let answers = run.data("/stations/0/answers");
    let repeats: Vec<u64> =
        answers["repeats"].as_array().unwrap().iter().map(|count| count.as_u64().unwrap()).collect();
    let others = answers["silences"].as_u64().unwrap() + answers["garbled"].as_u64().unwrap();
    assert_eq!(repeats.iter().sum::<u64>() + others, 200, "{answers}");
    assert!(repeats[0] > 100 && repeats[1] > 0, "{answers}");
    let [least, median, most] = ["least_us", "median_us", "most_us"].map(|key| answers[key].as_u64().unwrap());
    assert!(least > 3_000 && least <= median && median <= most && most < 30_000, "{answers}");
    let run = antrieb("-a 3 profibus live --questions 50").on(&line("", "")).exits(0);
    assert!(run.out.contains("0: 50") && run.out.contains("median"), "{}", run.out);
}
