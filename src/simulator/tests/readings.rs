//! Each reading of an open question makes another drive than the standard bench.

use super::servo::Hand;
use super::*;

fn servo(readings: &str) -> Hand {
    Hand::on(&format!("readings = {{ {readings} }}"))
}

/// Turning at 900 1/min in the velocity profile.
fn turning(readings: &str) -> Hand {
    let mut hand = servo(readings);
    hand.enable(3);
    hand.write(1_556, 3_000);
    hand.write(6_938, 900);
    hand.wait(500);
    assert_eq!(hand.speed(), 900);
    hand
}

#[test]
fn a_mode_change_while_turning_is_accepted_or_refused() {
    let mut standard = turning("");
    standard.write(6_918, -4);
    standard.wait(3_000);
    assert_eq!((standard.read(6_920), standard.speed()), (-4, 0));
    let mut strict = turning("mode_change = \"refused\"");
    assert_eq!(strict.try_write(6_918, -4), 4);
    strict.wait(500);
    assert_eq!((strict.read(6_920), strict.speed()), (3, 900));
}

#[test]
fn setpoints_and_references_end_or_outlive() {
    for (readings, reference, setpoint) in
        [("", 0, 500), ("references_after_run = \"kept\"", 2, 500), ("setpoints_after_run = \"zeroed\"", 0, 0)]
    {
        let mut hand = servo(readings);
        hand.enable(-4);
        hand.write(6_946, 2);
        hand.write(8_456, 500);
        hand.write(6_914, 0);
        hand.wait(5_000);
        assert_eq!((hand.read(6_946), hand.read(8_456)), (reference, setpoint), "{readings}");
    }
    for (readings, reference, setpoint) in
        [("", 0, 500), ("references_after_mode = \"kept\"", 2, 500), ("setpoints_after_mode = \"zeroed\"", 0, 0)]
    {
        let mut hand = servo(readings);
        hand.enable(-4);
        hand.write(6_946, 2);
        hand.write(8_456, 500);
        hand.write(6_918, 3);
        hand.wait(5_000);
        assert_eq!((hand.read(6_946), hand.read(8_456)), (reference, setpoint), "{readings}");
    }
}

#[test]
fn control_7_coasts_brakes_or_is_refused() {
    let mut coasts = turning("");
    coasts.write(6_914, 7);
    assert_eq!(coasts.servo().state, 0x23);
    let mut brakes = turning("control_7 = \"brakes\"");
    brakes.write(6_914, 7);
    assert_eq!(brakes.servo().state, 0x27);
    brakes.wait(2_000);
    assert_eq!((brakes.servo().state, brakes.speed()), (0x23, 0));
    let mut refuses = turning("control_7 = \"refused\"");
    assert_eq!(refuses.try_write(6_914, 7), 4);
    assert_eq!((refuses.servo().state, refuses.speed()), (0x27, 900));
}

#[test]
fn node_guarding_makes_a_fault_or_a_quick_stop_that_stays() {
    let mut fault = turning("");
    fault.write(5_644, 100);
    fault.wait(3_000);
    assert_eq!(fault.servo().state, 0x08);
    let mut stays = turning("node_guard = \"quick-stop\"");
    stays.write(5_644, 100);
    stays.wait(3_000);
    assert_eq!((stays.servo().state, stays.speed()), (0x07, 0));
    for word in [7, 0x0F, 6] {
        stays.write(6_914, word);
        assert_eq!(stays.servo().state, 0x07, "{word}");
    }
    stays.write(6_914, 0);
    assert_eq!(stays.servo().state, 0x40);
}

#[test]
fn node_guarding_is_fed_by_everything_or_by_writes_only() {
    for (readings, state) in [("", 0x27), ("node_guard_fed_by = \"writes\"", 0x08)] {
        let mut hand = turning(readings);
        hand.write(5_644, 100);
        for _ in 0..100 {
            hand.status();
        }
        assert_eq!(hand.servo().state, state, "{readings}");
    }
}

#[test]
fn telegrams_of_several_registers_and_the_refusals() {
    let exchange = "17 06 14 00 02 06 14 00 02 04 00 00 07 D0";
    assert_eq!(servo("").ask(exchange), hex("17 04 00 00 07 D0"));
    assert_eq!(servo("code_23 = \"reads-first\"").ask(exchange), hex("17 04 00 00 02 58"));
    let half = "10 06 14 00 04 08 00 00 07 D0 00 00 00 00";
    for (readings, acceleration) in [("", 600), ("code_16 = \"one-by-one\"", 2_000)] {
        let mut hand = servo(readings);
        assert_eq!(hand.ask(half)[0], 0x90);
        assert_eq!(hand.read(1_556), acceleration, "{readings}");
    }
    for code in 1..=4 {
        let mut hand = servo(&format!("exceptions = \"{code}\""));
        assert_eq!((hand.ask("03 00 01 00 02"), hand.try_write(6_916, 1)), (vec![0x83, code], code));
    }
}

#[test]
fn settings_of_the_line_hold_at_once_or_from_power_on() {
    let mut later = servo("");
    later.write(5_640, 7);
    assert!(later.ask_station(7, &hex("03 1B 04 00 02")).is_none());
    let mut now = servo("mbadr = \"at-once\", mbdword_order = \"at-once\"");
    now.write(5_646, 1);
    assert_eq!(now.ask("03 16 0E 00 02"), hex("03 04 00 01 00 00"));
    assert_eq!(now.ask("10 16 08 00 02 04 00 07 00 00"), hex("10 16 08 00 02"));
    assert!(now.ask_station(7, &hex("03 1B 04 00 02")).is_some());
    let mut fast = servo("mbbaud = \"at-once\"");
    fast.write(5_638, 9_600);
    fast.wait(1);
    assert_eq!(fast.drive().line().baud, 9_600);
}

#[test]
fn reading_the_fault_number_may_move_the_memory_on() {
    for (readings, seen) in [("", [2, 2, 2, 2]), ("flt_err_num = \"moves-on\"", [2, 1, 0, 2])] {
        let mut hand = servo(readings);
        let now = hand.now;
        hand.drive_mut().trip(now, 1);
        hand.drive_mut().trip(now, 2);
        assert_eq!([(); 4].map(|()| hand.read(15_362)), seen, "{readings}");
    }
}

#[test]
fn what_nobody_saves_may_be_lost() {
    for (readings, acceleration) in [("", 700), ("persistence = \"by-command\"", 600)] {
        let mut hand = servo(readings);
        hand.write(1_556, 700);
        let now = hand.now;
        hand.drive_mut().power_cycle(now);
        hand.wait(4_000);
        assert_eq!(hand.read(1_556), acceleration, "{readings}");
    }
}

/// An ACU under the control word.
fn acu(rest: &str) -> Hand {
    Hand::with(&format!("[[drive]]\nmodel = \"acu\"\nset = {{ \"412\" = 1 }}\n{rest}\n"))
}

fn word(hand: &mut Hand, number: u16) -> u16 {
    let [a, b] = number.to_be_bytes();
    match hand.ask_station(1, &[3, a, b, 0, 1]).as_deref() {
        Some(&[3, 2, high, low]) => u16::from_be_bytes([high, low]),
        other => panic!("{number}: {other:?}"),
    }
}

#[test]
fn a_standing_control_word_starts_by_level_or_not_by_edge() {
    let lost = "[[drive.event]]\nat = \"1s\"\nenable = false\nfor = \"1s\"";
    for (readings, state) in [("", 0x27), ("[drive.readings]\ncontrol_word = \"edge\"", 0x23)] {
        let mut hand = acu(&format!("{readings}\n{lost}"));
        hand.ask("06 01 9A 00 0F");
        assert_eq!(word(&mut hand, 411) & 0x6F, 0x27, "{readings}");
        hand.wait(1_000);
        assert_eq!(word(&mut hand, 411) & 0x6F, 0x23, "{readings}");
        hand.wait(1_500);
        assert_eq!(word(&mut hand, 411) & 0x6F, state, "{readings}");
        hand.ask("06 01 9A 00 0F");
        assert_eq!(word(&mut hand, 411) & 0x6F, 0x27, "{readings}");
    }
}

#[test]
fn reading_and_refusing_of_an_active() {
    for (readings, told) in [("", 1_390), ("readings = { ram_reads = \"in-force\" }", 1_500)] {
        let mut hand = acu(readings);
        hand.ask("06 51 74 05 DC");
        assert_eq!(word(&mut hand, 372), told, "{readings}");
    }
    for (readings, code, cause) in [("", 4, 11), ("readings = { unknown_parameter = \"2\" }", 2, 0)] {
        let mut hand = acu(readings);
        assert_eq!(hand.ask("03 00 01 00 01"), [0x83, code]);
        assert_eq!(word(&mut hand, 11), cause, "{readings}");
    }
}

#[test]
fn the_reply_to_a_new_address_comes_from_the_old_one_the_new_one_or_nobody() {
    for (reply, from) in [("old", Some(1)), ("new", Some(5)), ("lost", None)] {
        let mut hand = acu(&format!("readings = {{ line_reply = \"{reply}\" }}"));
        hand.bench.master_sends(hand.now, LINE, &Framing::Rtu.encode(1, &hex("06 05 60 00 05")));
        hand.now += Span::from_millis(100);
        let heard = bytes(&hand.bench.advance(hand.now));
        assert_eq!(heard.first().copied(), from, "{reply}");
        assert!(hand.ask_station(5, &hex("03 01 9B 00 01")).is_some(), "{reply}");
    }
}

#[test]
fn a_fault_is_acknowledged_with_or_without_the_remote_bit() {
    for (reset, state) in [("free", 0x40), ("needs-remote", 0x08)] {
        let mut hand = acu(&format!("readings = {{ reset = \"{reset}\" }}\nstart_right = false"));
        let now = hand.now;
        hand.drive_mut().trip(now, 0x0500);
        hand.wait(16_000);
        hand.ask("06 01 9A 00 00");
        hand.ask("06 01 9A 00 80");
        assert_eq!(word(&mut hand, 411) & 0x6F, state, "{reset}");
    }
}

#[test]
fn an_event_may_count_every_telegram() {
    let mut hand = acu("[[drive.event]]\nafter_telegrams = 3\nfault = \"F0500\"");
    assert_eq!([(); 4].map(|()| word(&mut hand, 260)), [0, 0, 0, 0x0500]);
}

#[test]
fn a_reading_must_be_one_of_its_model() {
    let refused = |text: &str| REGISTRY.with(|registry| Bench::from_toml("b", text, registry)).unwrap_err().message.en;
    let servo = refused("[[drive]]\nmodel = \"lxm05\"\nreadings = { control_7 = \"jumps\" }\n");
    assert!(servo.contains("coasts, brakes, refused"), "{servo}");
    let other = refused("[[drive]]\nmodel = \"act\"\nreadings = { control_7 = \"brakes\" }\n");
    assert!(other.contains("no question"), "{other}");
}
