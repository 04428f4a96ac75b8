//! The bus as its manual has it, spoken to by hand.

use super::bus::Can;
use crate::profile::Registry;
use crate::tick::{Span, Tick};

fn bus(text: &str) -> Can {
    Can::from_toml("bus.toml", text, &Registry::open(&[]).unwrap()).unwrap()
}

/// What the adapter says until a time, when it was told this at another; the channel is open.
fn told(bus: &mut Can, at_ms: u64, words: &str, until_ms: u64) -> String {
    let at = |ms| Tick::ZERO + Span::from_millis(ms);
    bus.advance(at(at_ms));
    bus.master_sends(at(at_ms), words.replace(' ', "\r").as_bytes());
    let said = bus.advance(at(until_ms)).into_iter().map(|(_, byte)| byte).collect();
    String::from_utf8(said).unwrap().replace('\r', " ").replace('\u{7}', "!")
}

fn drive(rest: &str) -> String {
    format!("{rest}\n[[drive]]\nmodel = \"acu\"\naddress = 5\n")
}

const OPEN: &str = "C S6 O ";

#[test]
fn an_adapter_obeys_the_words_of_its_manual() {
    let mut can = bus(&drive(""));
    assert_eq!(told(&mut can, 0, "C O V S6 S6 t0000 O F O S5 L C C ", 10), "!!V0001   ! F00 !!! !");
    let mut mute = bus(&drive("[adapter]\nacknowledges = false"));
    assert_eq!(told(&mut mute, 0, OPEN, 10), "");
    assert!(mute.is_open());
}

#[test]
fn parameters_are_answered_over_both_channels_as_the_manual_prints_it() {
    let mut can = bus(&drive(""));
    told(&mut can, 0, OPEN, 10);
    // P.411 over SDO1 and SDO2, P.900 = 5, an unknown one, P.484, which an ACU does not show.
    assert_eq!(told(&mut can, 20, "t6058409B010000000000 ", 40), "z t5858429B010021000000 ".replace("21", &low(&can)));
    assert_eq!(told(&mut can, 50, "t64584084030000000000 ", 70), "z t5C584284030005000000 ");
    assert_eq!(
        told(&mut can, 80, "t645840FFFF0000000000 ", 100),
        "z t5C580FFFF00".replace("580F", "5880F") + "0B000000 "
    );
    assert_eq!(told(&mut can, 110, "t645840E4010000000000 ", 130), "z t5C5880E4010003000000 ");
    assert!(can.remarks().is_empty());
}

/// The low byte of the status word.
fn low(can: &Can) -> String {
    format!("{:02X}", can.ram(5, 411, 0).unwrap() & 0xFF)
}

#[test]
fn the_smallest_identifier_wins_and_frames_take_their_time() {
    let mut can = bus(&drive(
        "[[foreign]]\nframe = \"080#\"\nevery = \"10ms\"\n[[foreign]]\nframe = \"000#0100\"\nevery = \"10ms\"",
    ));
    told(&mut can, 0, "S6 O ", 1);
    assert_eq!(told(&mut can, 9, "", 12), "t00020100 t0800 ");
}

#[test]
fn a_stopped_node_is_silent_and_says_its_boot_up_behind_a_reset() {
    let mut can = bus(&drive(""));
    told(&mut can, 0, OPEN, 10);
    assert_eq!(told(&mut can, 20, "t00020205 t6458409B010000000000 ", 100), "z z ");
    assert_eq!(told(&mut can, 110, "t00028105 ", 300), "z t705100 ");
    assert_eq!(can.remarks().len(), 2, "the network is the master's");
}

#[test]
fn a_master_drive_starts_everybody_again_and_again() {
    let text = drive("") + "[[drive]]\nmodel = \"acu\"\naddress = 0\nset = { \"904\" = 4000, \"919\" = 1000 }\n";
    let mut can = bus(&text);
    told(&mut can, 0, OPEN, 10);
    assert_eq!(told(&mut can, 3_990, "", 6_500), "t00020100 t0800 t0800 t0800 ");
    assert_eq!(can.ram(5, 978, 0), Some(2));
}

#[test]
fn a_fault_is_an_emergency() {
    let mut can = bus(&(drive("") + "[[drive.event]]\nat = \"1s\"\nfault = \"F0500\"\n"));
    told(&mut can, 0, OPEN, 10);
    assert_eq!(told(&mut can, 900, "", 1_100), "t0858001080000000".to_owned() + "0005 ");
}

#[test]
fn another_bit_rate_is_heard_as_errors_and_disturbs_who_takes_part() {
    let mut can = bus(&drive("[[foreign]]\nframe = \"080#\"\nevery = \"10ms\""));
    assert_eq!(told(&mut can, 0, "S5 L ", 50), "  ");
    assert_eq!(told(&mut can, 60, "F ", 70), "F84 ");
    assert!(can.remarks().is_empty(), "who listens disturbs nobody");
    told(&mut can, 80, "C O ", 100);
    assert!(!can.remarks().is_empty());
}
