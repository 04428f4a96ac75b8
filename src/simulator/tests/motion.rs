//! What the shaft does: ramps, stops, contacts, watchdog, load, and the script.

use super::hand::Hand;
use super::*;

const INHIBIT: u16 = 0x40;
const ON: u16 = 0x23;
const ENABLED: u16 = 0x27;
const QUICK: u16 = 0x07;

fn act(set: &str) -> Hand {
    Hand::on("act", "", set)
}

#[test]
fn ramps_go_per_direction() {
    let mut hand = act("\"418\" = 0");
    hand.write_long(484, 4_000);
    hand.write_word(410, 0x0F);
    // Half an exchange of 50 ms is the telegram; 50 Hz/s up.
    hand.wait(350);
    assert!((1_700..=2_000).contains(&hand.shaft()), "{}", hand.shaft());
    hand.wait(1_000);
    assert_eq!((hand.shaft(), hand.read_long(283), hand.read_long(282)), (4_000, Some(4_000), Some(4_000)));
    // 25 Hz/s down through zero, 40 Hz/s up on the other side.
    hand.write_long(484, -4_000);
    hand.wait(1_550);
    assert!((-50..=50).contains(&hand.shaft()), "{}", hand.shaft());
    hand.wait(1_200);
    assert_eq!(
        (hand.shaft(), hand.read_long(210), hand.read_word(218)),
        (-4_000, Some(-4_000), Some(-1_200i16 as u16))
    );
    // 20 Hz/s down.
    hand.write_long(484, 0);
    hand.wait(950);
    assert!((-2_150..=-1_950).contains(&hand.shaft()), "{}", hand.shaft());
}

#[test]
fn the_line_setpoint_alone_keeps_f_min_with_the_sign_of_the_last_one() {
    let mut hand = act("\"434\" = 2, \"418\" = \"3.5\"");
    let goal = |hand: &mut Hand, setpoint: i32| {
        hand.write_long(484, setpoint);
        hand.wait(3_000);
        hand.shaft()
    };
    assert_eq!(hand.command(0x0F), ENABLED);
    hand.wait(500);
    assert_eq!(hand.shaft(), 350, "after power-on +f_min");
    assert_eq!(goal(&mut hand, 100), 350);
    assert_eq!(goal(&mut hand, -100), -350);
    assert_eq!(goal(&mut hand, 0), -350);
    assert_eq!(goal(&mut hand, -1_000), -1_000);
    assert_eq!(goal(&mut hand, 1_000), 1_000);
    assert_eq!(goal(&mut hand, 0), 350);
    assert!(!hand.bit(11));
    // A reset forgets the sign.
    goal(&mut hand, -1_000);
    hand.command(0);
    hand.write_word(34, 123);
    hand.wait(4_000);
    hand.command(0x0F);
    hand.wait(1_000);
    assert_eq!(hand.shaft(), 350);
}

#[test]
fn three_ways_to_form_the_setpoint_and_one_limit() {
    for (mode, goal) in [(1, 1_200), (2, -500), (3, 700)] {
        let mut hand = act("\"228\" = 12, \"418\" = 2");
        hand.write_word(434, mode);
        hand.write_long(484, -500);
        hand.command(0x0F);
        hand.wait(3_000);
        assert_eq!((hand.shaft(), hand.read_long(228), hand.bit(10)), (goal, Some(1_200), true), "P.434 = {mode}");
    }
    let mut hand = act("\"228\" = 12, \"419\" = 30");
    hand.write_long(484, 3_000);
    hand.command(0x0F);
    hand.wait(3_000);
    assert_eq!((hand.shaft(), hand.status() & 0xC00), (3_000, 0x800), "bit 11 and not bit 10");
    hand.write_long(484, -9_000);
    hand.wait(5_000);
    assert_eq!((hand.shaft(), hand.bit(11)), (-3_000, true));
}

#[test]
fn percentages_are_summed() {
    let mut hand = act("\"229\" = 30");
    assert_eq!(hand.drive().ram(229, 0), Some(3_000));
    assert!(hand.write_long(524, -4_550));
    assert_eq!(hand.drive().ram(229, 0), Some(-1_550));
    assert!(hand.write_long(524, 30_000));
    assert_eq!(hand.drive().ram(229, 0), Some(30_000));
}

#[test]
fn transition_5_three_ways() {
    // Coast: no power at once.
    let mut hand = act("\"392\" = 0");
    hand.run();
    assert_eq!((hand.command(0x07), hand.energised()), (ON, false));
    assert!(hand.shaft() > 0);
    hand.wait(1_000);
    assert_eq!(hand.shaft(), 0);
    // DC brake: 10.00 s by the factory setting of the bench; no word is accepted before.
    let mut hand = act("\"392\" = 1, \"632\" = 3");
    hand.run();
    assert_eq!((hand.command(0x07), hand.energised(), hand.read_long(210)), (ENABLED, true, Some(0)));
    assert_eq!((hand.command(0x0F), hand.command(0x00)), (ENABLED, ENABLED));
    hand.wait(1_000);
    assert_eq!((hand.shaft(), hand.energised(), hand.state()), (0, true, ENABLED));
    hand.wait(2_000);
    assert_eq!((hand.state(), hand.energised()), (INHIBIT, false), "then the word that stands");
    // Ramp: 25 Hz/s down to 0.5 Hz, then 0.2 s.
    let mut hand = act("\"392\" = 2");
    hand.run();
    assert_eq!(hand.command(0x07), ENABLED);
    hand.wait(380);
    assert_eq!((hand.state(), hand.shaft(), hand.energised()), (ENABLED, 0, true));
    hand.wait(100);
    assert_eq!((hand.state(), hand.energised()), (ON, false));
}

#[test]
fn the_ramp_of_transition_5_is_called_back() {
    let mut hand = act("\"392\" = 2");
    hand.run();
    assert_eq!(hand.command(0x07), ENABLED);
    hand.wait(100);
    let low = hand.shaft();
    assert!((300..800).contains(&low), "{low}");
    assert!(!hand.bit(10));
    assert_eq!(hand.command(0x0F), ENABLED);
    hand.wait(1_000);
    assert_eq!((hand.shaft(), hand.state(), hand.bit(10)), (1_000, ENABLED, true));
}

#[test]
fn dc_braking_only_in_v_f_configurations() {
    let mut hand = act("\"30\" = 210");
    assert!(!hand.write_word(392, 1));
    assert_eq!(hand.read_word(11), Some(1));
    assert!(hand.write_word(30, 110) && hand.write_word(392, 1) && hand.write_word(30, 210));
    assert_eq!(hand.read_word(392), Some(2), "the configuration takes it back");
}

#[test]
fn a_quick_stop_has_its_own_ramps_and_holds() {
    for (setpoint, slope) in [(4_000, 10_000), (-4_000, 8_000)] {
        let mut hand = act("\"418\" = 0");
        hand.write_long(484, setpoint);
        hand.command(0x0F);
        hand.wait(2_000);
        let begin = hand.bench.now.since(Tick::ZERO).as_micros() / 1_000 + 7;
        assert_eq!(hand.command(0x02), QUICK);
        // Down to P.637 = 1 % of 50 Hz, then P.638 = 0.2 s.
        let end = begin + (4_000 - 50) * 1_000 / slope + 200;
        hand.wait(end - 100 - hand.bench.now.since(Tick::ZERO).as_micros() / 1_000);
        assert_eq!((hand.state(), hand.shaft(), hand.energised()), (QUICK, 0, true), "{setpoint}");
        hand.wait(100);
        assert_eq!((hand.state(), hand.energised()), (INHIBIT, false), "12 by itself");
    }
}

#[test]
fn losing_the_enable_lets_the_shaft_coast() {
    for (model, off, on) in [
        ("act", "enable = false", "enable = true"),
        ("acu", "stoa = false", "enable = true"),
        ("acu", "stob = false", "stob = true"),
        ("acu", "start_right = false", "start_left = true"),
    ] {
        let script = format!("[[drive.event]]\nat = \"1s\"\n{off}\n[[drive.event]]\nat = \"5s\"\n{on}");
        let mut hand = Hand::on(model, &script, "\"392\" = 2");
        hand.run();
        hand.wait(400);
        assert_eq!((hand.state(), hand.energised(), hand.bit(9)), (ON, false, false), "{model}: {off}");
        let coasting = hand.shaft();
        assert!(coasting > 0);
        // Nothing measures it in this configuration but the encoder.
        assert_eq!((hand.drive().ram(241, 0), hand.drive().ram(217, 0)), (Some(0), Some(coasting)));
        assert_eq!(hand.read_long(210), Some(0), "the field is gone");
        hand.wait(2_000);
        assert_eq!(hand.shaft(), 0);
        hand.wait(2_500);
        assert_eq!(hand.state(), ENABLED, "0x0F still stands");
    }
}

#[test]
fn a_drive_may_show_its_coasting_shaft_and_may_have_no_encoder() {
    let script = "[[drive.event]]\nat = \"1s\"\nenable = false\n[drive.readings]\ncoast_shows = \"shaft\"";
    let mut hand = Hand::on("act", script, "\"392\" = 2, \"217\" = 0, \"218\" = 0");
    hand.run();
    hand.wait(400);
    let coasting = hand.shaft();
    assert!(coasting > 0 && !hand.energised());
    assert_eq!((hand.drive().ram(210, 0), hand.drive().ram(217, 0)), (Some(coasting), Some(0)));
}

#[test]
fn losing_the_mains() {
    let script = "[[drive.event]]\nat = \"1s\"\nmains = false\n[[drive.event]]\nat = \"3s\"\nmains = true";
    let mut acu = Hand::on("acu", script, "\"392\" = 2");
    acu.run();
    acu.wait(400);
    assert_eq!((acu.read_word(260), acu.energised(), acu.bit(4)), (Some(0x0702), false, false));
    acu.wait(3_000);
    assert!(acu.bit(4) && acu.drive().in_fault());
    // An ACT has no other power.
    let mut act = Hand::on("act", script, "\"392\" = 2");
    act.run();
    act.wait(400);
    assert_eq!((act.read_word(411), act.energised()), (None, false));
    assert!(act.shaft() > 0, "it coasts");
    act.wait(2_000);
    assert_eq!((act.read_word(411), act.shaft()), (None, 0));
    act.wait(3_000);
    assert_eq!((act.state(), act.read_word(410)), (INHIBIT, Some(0)));
}

#[test]
fn contacts_of_a_dead_act_start_nothing() {
    let mut hand = Hand::on("act", "mains = false\n[[drive.event]]\nat = \"5s\"\nmains = true", "\"228\" = 10");
    hand.bench.drive_mut(1).unwrap().power_cycle(Tick::ZERO);
    hand.wait(4_000);
    assert_eq!((hand.energised(), hand.shaft(), hand.drive().ram(411, 0)), (false, 0, Some(0x0200)));
    hand.wait(5_000);
    assert_eq!(hand.state(), INHIBIT);
}

#[test]
fn remote_contacts_need_the_hardware_enable_too() {
    let script = "[[drive.event]]\nat = \"5s\"\nenable = true";
    for model in ["act", "acu"] {
        let mut hand = Hand::on(model, &format!("enable = false\nstart_right = false\n{script}"), "\"228\" = 10");
        assert!(hand.write_word(412, 2));
        // S1IND and S2IND by word, no hardware enable: nothing.
        assert_eq!((hand.command(0x03), hand.bit(9), hand.read_word(250)), (ON, false, Some(0)));
        assert!(!hand.energised());
        hand.wait(5_000);
        assert_eq!((hand.state(), hand.bit(9), hand.read_word(250)), (ENABLED, true, Some(3)));
        hand.wait(1_000);
        assert_eq!(hand.shaft(), 1_000);
        // The other direction, and inputs that mean nothing here.
        hand.command(0x3FD | 0x8000);
        hand.wait(2_000);
        assert_eq!((hand.shaft(), hand.read_word(250)), (-1_000, Some(0x3FD)));
        // Without its bit 0: coast, nothing is shown, and the Remote bit stays.
        assert_eq!((hand.command(0x3FC), hand.energised()), (ON, false));
        assert_eq!((hand.bit(9), hand.read_word(250)), (true, Some(0)));
        // Start contact away: the ramp.
        hand.command(0x03);
        hand.wait(2_000);
        assert_eq!((hand.command(0x01), hand.energised()), (ENABLED, true));
        hand.wait(1_000);
        assert_eq!((hand.state(), hand.shaft(), hand.energised()), (ON, 0, false));
    }
}

#[test]
fn contacts_at_the_terminals() {
    let script = "[[drive.event]]\nat = \"2s\"\nstart_right = true\n[[drive.event]]\nat = \"4s\"\nenable = false";
    let mut hand = Hand::on("act", &format!("start_right = false\n{script}"), "\"228\" = 10");
    assert!(hand.write_word(412, 0));
    assert_eq!((hand.state(), hand.read_word(250), hand.bit(9)), (ON, Some(1), false));
    hand.wait(3_000);
    assert_eq!((hand.state(), hand.shaft(), hand.read_word(250)), (ENABLED, 1_000, Some(3)));
    hand.wait(1_000);
    assert_eq!((hand.state(), hand.energised()), (ON, false));
}

#[test]
fn the_watchdog_stops_the_shaft() {
    for model in ["act", "acu"] {
        let mut hand = Hand::on(model, "[[drive]]\nmodel = \"foreign\"\naddress = 2", "\"392\" = 2");
        assert!(hand.write_word(413 | 5 << 12, 2), "in the RAM");
        hand.run();
        for _ in 0..6 {
            hand.wait(900);
            assert_eq!(hand.state(), ENABLED, "every exchange holds it off");
        }
        // Exchanges with others and broadcasts do not.
        for station in [0, 2, 2, 0, 2] {
            hand.bench.master_sends(hand.bench.now, LINE, &Framing::Rtu.encode(station, &[6, 1, 0xE0, 0, 0]));
            let next = hand.bench.now + Span::from_millis(500);
            hand.bench.advance(next);
        }
        assert!(hand.drive().in_fault() && !hand.energised());
        let next = hand.bench.now + Span::from_secs(1);
        hand.bench.advance(next);
        assert_eq!((hand.bench.totals().turning, hand.bench.totals().energised), (0, 0));
        assert_eq!((hand.drive().ram(260, 0), hand.drive().eeprom_writes()), (Some(0x2010), 0));
    }
}

#[test]
fn under_load_the_actual_value_differs_and_a_limit_holds_the_drive() {
    let set = "\"375\" = 50, \"372\" = 1390, \"373\" = 2, \"376\" = \"1.5\", \"419\" = 60";
    let script =
        "torque = 40\n[[drive.event]]\nat = \"10s\"\ntorque = 100\n[[drive.event]]\nat = \"20s\"\ntorque = 200";
    let mut hand = Hand::on("act", script, set);
    hand.write_long(484, 4_000);
    hand.command(0x0F);
    hand.wait(3_000);
    // 40 % of a slip of 3.67 Hz; P.549 = 5 % of 60.00 - 3.50 Hz.
    let slow = 4_000 - 367 * 40 / 100;
    assert_eq!((hand.shaft(), hand.read_long(241), hand.read_long(210)), (slow, Some(slow as i32), Some(4_000)));
    assert_eq!((hand.status() & 0xC00, hand.read_word(211), hand.read_word(213)), (0x400, Some(21), Some(5)));
    hand.wait(7_000);
    assert_eq!((hand.read_long(241), hand.status() & 0xC00), (Some(4_000 - 367), 0), "too far away");
    hand.wait(13_000);
    assert_eq!((hand.read_long(210), hand.status() & 0x8C80), (Some(0), 0x0880));
    assert_eq!((hand.read_word(270), hand.read_word(211)), (Some(0x0020), Some(51)));
    // Field-oriented control leads the rotor; the stator runs ahead.
    let mut hand = Hand::on("acu", "torque = 100", &format!("{set}, \"30\" = 210"));
    hand.write_long(484, 4_000);
    hand.command(0x0F);
    hand.wait(3_000);
    assert_eq!((hand.read_long(241), hand.read_long(210), hand.bit(10)), (Some(4_000), Some(4_367), true));
}

#[test]
fn warnings_set_bit_7_and_critical_ones_bit_15() {
    for (bit, status) in [(0, 0x8080), (1, 0x8080), (3, 0x8080), (5, 0x0080), (7, 0x8080), (8, 0x8080), (15, 0x0080)] {
        let mut hand = act("\"392\" = 2");
        hand.bench.drive_mut(1).unwrap().warn(1 << bit);
        assert_eq!(hand.status() & 0x8080, status, "bit {bit}");
    }
}

#[test]
fn every_fault_of_the_catalogue_can_be_injected() {
    let registry = Registry::open(&[]).unwrap();
    let family = registry.family("acu").unwrap();
    assert!(family.faults.len() > 20);
    for code in family.faults.iter().map(|row| row.code).filter(|&code| code != 0) {
        let script = format!("[[drive.event]]\nwhen = \"running\"\nfault = \"F{code:04X}\"");
        let mut hand = Hand::on("acu", &script, "\"392\" = 2");
        hand.wait(500);
        assert!(!hand.drive().in_fault());
        hand.write_word(410, 0x0F);
        assert_eq!((hand.read_word(260), hand.energised()), (u16::try_from(code).ok(), false));
    }
}

#[test]
fn a_script_waits_for_conditions() {
    // The very moment at which the field passes 20 Hz, though nobody speaks.
    let mut hand = Hand::on("act", "[[drive.event]]\nwhen = \"above 20Hz\"\nfault = \"F0700\"", "\"418\" = 0");
    hand.write_long(484, -4_000);
    hand.write_word(410, 0x0F);
    hand.wait(250);
    assert!(!hand.drive().in_fault() && hand.shaft().abs() < 1_500);
    let at = hand.bench.next_event().unwrap();
    hand.bench.advance(at);
    assert!(hand.drive().in_fault());
    assert_eq!(hand.shaft().abs(), 2_000);
    // 20 Hz sharp is not above it.
    let mut hand = Hand::on("act", "[[drive.event]]\nwhen = \"above 20Hz\"\nfault = \"F0700\"", "\"418\" = 0");
    hand.write_long(484, 2_000);
    hand.command(0x0F);
    hand.wait(2_000);
    assert_eq!((hand.drive().in_fault(), hand.bench.next_event()), (false, None));
    // After the third write: it is obeyed, but the drive is gone before it can tell.
    let mut hand = Hand::on("act", "[[drive.event]]\nafter_writes = 3\nsilent = \"1s\"", "\"418\" = 0");
    assert!(hand.write_long(484, 500) && hand.write_word(410, 0x06));
    assert_eq!(hand.state(), 0x21);
    assert!(!hand.write_word(410, 0x0F));
    assert_eq!(hand.read_word(411), None);
    assert!(hand.energised());
    hand.wait(1_000);
    assert_eq!(hand.state(), ENABLED);
}

#[test]
fn closing_counts_tell_what_still_turns() {
    let mut hand = act("\"392\" = 0");
    assert_eq!((hand.bench.totals().turning, hand.bench.totals().energised), (0, 0));
    hand.run();
    assert_eq!((hand.bench.totals().turning, hand.bench.totals().energised), (1, 1));
    hand.command(0x07);
    assert_eq!((hand.bench.totals().turning, hand.bench.totals().energised), (1, 0));
    // What will be, asked now.
    let later = hand.bench.now + Span::from_secs(2);
    assert_eq!(hand.drive().shaft_speed(later), 0);
    hand.wait(2_000);
    assert_eq!(hand.bench.totals().turning, 0);
}
