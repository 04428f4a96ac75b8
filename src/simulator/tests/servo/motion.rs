//! What the shaft of an LXM05 does: targets, quick stop, modes, errors, limit switches, homing.

use super::*;

#[test]
fn targets_add_up_or_not_by_bit_6() {
    for (keys, relative, absolute) in [("", 0x5F, 0x1F), ("servo = { bit6 = \"absolute\" }", 0x1F, 0x5F)] {
        let mut hand = Hand::on(keys);
        hand.enable(1);
        let mut go = |word: i32, target: i32| {
            hand.write(6_940, target);
            hand.write(6_914, word);
            assert_eq!(hand.status() & 0x1400, 0x1000, "acknowledged, and not there yet");
            hand.wait(8_000);
            assert_eq!(hand.status() & 0x1400, 0x1400);
            hand.write(6_914, 0x0F);
            hand.read(7_700)
        };
        let came = [go(relative, 20_000), go(relative, 20_000), go(absolute, 20_000), go(relative, -50_000)];
        assert_eq!(came, [20_000, 40_000, 20_000, -30_000], "{keys}");
        // Without an edge nothing starts.
        hand.write(6_940, 5);
        hand.write(6_914, 0x0F);
        hand.wait(2_000);
        assert_eq!(hand.read(7_700), -30_000);
    }
}

#[test]
fn a_second_target_waits_or_is_taken_at_once() {
    let mut hand = Hand::on("set = { PPn_target = 600, RAMPacc = 6000, RAMPdecel = 6000 }");
    hand.enable(1);
    let start = |hand: &mut Hand, word, target| {
        hand.write(6_940, target);
        hand.write(6_914, word);
        hand.write(6_914, 0x0F);
    };
    start(&mut hand, 0x1F, 163_840);
    start(&mut hand, 0x1F, 0);
    assert!((0..1_000).any(|_| {
        hand.wait(10);
        hand.servo().position_usr >= 163_000
    }));
    hand.wait(3_000);
    assert_eq!((hand.servo().position_usr, hand.status() & 0x0400), (0, 0x0400));
    start(&mut hand, 0x1F, 163_840);
    hand.wait(300);
    start(&mut hand, 0x3F, 0);
    assert!((0..300).all(|_| {
        hand.wait(10);
        hand.servo().position_usr < 120_000
    }));
    assert_eq!(hand.servo().position_usr, 0);
}

#[test]
fn the_shaft_waits_while_bit_8_holds_it() {
    let mut hand = Hand::on("");
    hand.enable(3);
    hand.write(6_938, 300);
    hand.wait(1_000);
    hand.write(6_914, 0x010F);
    hand.wait(1_000);
    assert_eq!((hand.speed(), hand.servo().state), (0, 0x27));
    hand.write(6_914, 0x0F);
    hand.wait(1_000);
    assert_eq!(hand.speed(), 300);
}

#[test]
fn a_quick_stop_brakes_and_disable_voltage_lets_coast() {
    for (word, braking, after) in [(0x02, 0x07, 100), (0x00, 0x40, 1_000)] {
        let mut hand = Hand::on("set = { RAMPacc = 100000 }");
        hand.enable(3);
        hand.write(6_938, 1_000);
        hand.wait(100);
        hand.write(6_914, word);
        assert_eq!(hand.servo().state, braking);
        assert!(hand.speed() > 100);
        hand.wait(after);
        assert_eq!((hand.speed(), hand.servo().state, hand.drive().is_energised()), (0, 0x40, false));
    }
}

#[test]
fn a_mode_changes_at_rest_and_takes_its_sources_with_it() {
    let mut hand = Hand::on("");
    hand.enable(-4);
    hand.write(6_946, 2);
    hand.write(8_456, 300);
    hand.wait(1_000);
    assert_eq!(hand.speed(), 300);
    hand.write(6_918, 3);
    assert_eq!(hand.read(6_920), -4);
    hand.wait(1_000);
    assert_eq!((hand.read(6_920), hand.speed(), hand.read(6_946), hand.read(8_456)), (3, 0, 0, 300));
}

#[test]
fn jog_is_refused_outside_its_mode() {
    let mut hand = Hand::on("");
    hand.enable(3);
    assert_eq!(hand.try_write(6_930, 1), 4);
    assert_eq!(hand.ask("08 00 02 00 00"), hex("08 00 02 00 06"), "the synchronous error");
    hand.write(6_930, 0);
}

#[test]
fn a_lost_master_stops_the_shaft() {
    let mut hand = Hand::on("set = { MBnode_guard = 500 }");
    hand.enable(3);
    hand.write(6_938, 500);
    (0..50).for_each(|_| hand.wait_and_look(400));
    assert_eq!(hand.speed(), 500);
    hand.wait(470); // the last telegram ended some 15 ms after its start
    assert_eq!(hand.servo().state, 0x27);
    hand.wait(40);
    assert_eq!((hand.servo().state, hand.drive().is_energised()), (0x0F, true));
    hand.wait(500);
    assert_eq!((hand.servo().state, hand.speed(), hand.drive().is_energised()), (0x08, 0, false));
    // Number, class, time, qualifier in one telegram (manual 5.3, example 1).
    let memory = hand.ask("03 3C 02 00 08");
    assert_eq!(memory, hex("03 10 00 00 01 01 00 00 00 01 00 00 00 16 00 00 00 00"));
    assert_eq!(hand.status() & 0x6F, 0x08);
    hand.write(6_914, 0x80);
    assert_eq!(hand.status() & 0x6F, 0x40);
    assert_eq!(hand.bench.remarks(), []);
}

impl Hand {
    fn wait_and_look(&mut self, millis: u64) {
        self.wait(millis);
        self.status();
    }
}

#[test]
fn errors_of_a_script_act_by_their_class() {
    let event =
        |class: u8| format!("[[drive.event]]\nwhen = \"above 5Hz\"\nfault = \"E2300\"\nclass = {class}\nqualifier = 7");
    for (class, at_rest) in [(0, 0xA7), (2, 0x08), (3, 0x08), (4, 0x08)] {
        let mut hand = Hand::on(&event(class));
        hand.enable(3);
        hand.write(6_938, 600);
        hand.wait(3_000);
        assert_eq!(hand.status() & 0xEF, at_rest, "{class}");
        assert_eq!([15_362, 15_364, 15_368].map(|address| hand.read(address)), [0x2300, class.into(), 7]);
        hand.write(6_914, 0x00);
        hand.write(6_914, 0x80);
        assert_eq!(hand.drive().in_fault(), class == 4);
    }
}

#[test]
fn limit_switches_stop_only_where_the_file_says_so() {
    for (limits, state) in [(false, 0x27), (true, 0x08)] {
        let mut hand = Hand::on(&format!("servo = {{ limp = 10000, limits = {limits} }}"));
        hand.enable(3);
        hand.write(6_938, 300);
        hand.wait(3_000);
        assert_eq!(hand.servo().state, state);
    }
}

#[test]
fn homing_finds_both_switches_and_can_be_broken_off() {
    for (method, way) in [(17, -1), (18, 1), (35, 0)] {
        let mut hand = Hand::on("");
        hand.enable(6);
        hand.write(6_936, method);
        hand.write(6_914, 0x1F);
        hand.wait(100);
        assert_eq!(hand.speed().signum(), way, "{method}");
        hand.wait(30_000);
        assert!(hand.servo().referenced && hand.servo().position_usr.abs() < 200, "{method}: {:?}", hand.servo());
    }
    let mut hand = Hand::on("");
    hand.enable(6);
    hand.write(6_914, 0x1F);
    hand.wait(500);
    hand.write(6_914, 0x0F);
    hand.wait(60_000);
    assert_eq!((hand.servo().referenced, hand.speed(), hand.status() & 0x1000), (false, 0, 0));
    assert_eq!(hand.try_write(6_936, 1), 3, "no such method on this bench");
}
