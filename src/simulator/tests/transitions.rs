//! Every transition of both state machines, driven by control words over the bus, and every one that is refused
//! (CM-485 manual 9.1.2, 10.2; numbers: sources H).

use super::hand::Hand;

const INHIBIT: u16 = 0x40;
const READY: u16 = 0x21;
const ON: u16 = 0x23;
const ENABLED: u16 = 0x27;
const QUICK: u16 = 0x07;
const REACTION: u16 = 0x0F;
const FAULT: u16 = 0x08;

/// Control words from switch-on inhibit to a state.
fn way(state: u16) -> &'static [u16] {
    match state {
        READY => &[0x06],
        ON => &[0x06, 0x07],
        ENABLED => &[0x0F],
        QUICK => &[0x0F, 0x02],
        _ => &[],
    }
}

/// A drive in a state, with a holding time that lets the quick stop last.
fn hand(model: &str, keys: &str, set: &str, state: u16) -> Hand {
    let mut hand = Hand::on(model, keys, &format!("\"638\" = 20, {set}"));
    for &word in way(state) {
        hand.command(word);
    }
    assert_eq!(hand.state(), state, "{model}");
    hand
}

#[test]
fn every_command_in_every_state() {
    // Rows: state; columns: disable voltage, quick stop, shut down, switch on, enable. P.392 = 0: at once.
    let words = [0x00, 0x02, 0x06, 0x07, 0x0F];
    let act = [
        (INHIBIT, [INHIBIT, INHIBIT, READY, INHIBIT, ENABLED]), // 2, 4
        (READY, [INHIBIT, READY, READY, ON, ENABLED]),          // 7, 3, 3 and 4
        (ON, [INHIBIT, ON, READY, ON, ENABLED]),                // 10, 6, 4
        (ENABLED, [INHIBIT, QUICK, READY, ON, ENABLED]),        // 9, 11, 8, 5
        (QUICK, [INHIBIT, QUICK, QUICK, QUICK, QUICK]),         // 12
    ];
    let mut acu = act;
    acu[1].1[1] = INHIBIT; // 7 by quick stop
    acu[2].1[1] = INHIBIT; // 10 by quick stop
    for (model, table) in [("act", act), ("acu", acu)] {
        for (from, row) in table {
            for (word, to) in words.into_iter().zip(row) {
                let mut hand = hand(model, "", "\"392\" = 0", from);
                assert_eq!(hand.command(word), to, "{model}: {word:#04x} in {from:#04x}");
                assert_eq!(hand.energised(), to == ENABLED || to == QUICK);
                assert_eq!(hand.status() & 0x10 != 0, model == "acu", "bit 4 is the mains of an ACU");
            }
        }
    }
}

#[test]
fn transitions_0_and_1_take_the_time_of_a_restart() {
    for model in ["act", "acu"] {
        let mut hand = hand(model, "[[drive.event]]\nat = \"1s\"\npower_cycle = true", "\"392\" = 2", READY);
        hand.wait(2_000);
        assert_eq!(hand.drive().ram(411, 0).map(|word| word & 0x6F), Some(0x00));
        assert_eq!(hand.read_word(411), None, "off the bus");
        hand.wait(2_000);
        assert_eq!(hand.state(), INHIBIT);
    }
}

#[test]
fn transitions_13_to_15() {
    for model in ["act", "acu"] {
        for from in [INHIBIT, READY, ON, ENABLED, QUICK] {
            let mut hand = hand(model, "[[drive.event]]\nat = \"1s\"\nfault = \"F0500\"", "\"392\" = 2", from);
            let now = way(from).len() as u64 * 100 + 50;
            hand.wait(1_000 - now);
            let reaction = if from == ENABLED || from == QUICK { REACTION } else { FAULT };
            assert_eq!((hand.state(), hand.energised()), (reaction, false));
            hand.wait(100);
            assert_eq!((hand.state(), hand.read_word(260)), (FAULT, Some(0x0500)));
            assert_eq!(hand.command(0x0F), FAULT, "nothing but an edge of bit 7 leads out");
            hand.wait(14_600);
            // Too early by 0.1 s, then late enough but without an edge.
            assert_eq!(hand.command(0x80), FAULT);
            hand.wait(2_000);
            assert_eq!(hand.command(0x86), FAULT);
            assert_eq!(hand.command(0x00), FAULT);
            assert_eq!((hand.command(0x80), hand.read_word(260)), (INHIBIT, Some(0)));
        }
    }
}

#[test]
fn no_fault_is_acknowledged_under_contacts() {
    let mut hand = Hand::on("act", "[[drive.event]]\nat = \"0s\"\nfault = \"F0500\"", "\"392\" = 2");
    assert!(hand.write_word(412, 2));
    hand.wait(16_000);
    assert_eq!(hand.command(0x80), FAULT);
    assert!(hand.write_word(412, 1));
    assert_eq!(hand.state(), FAULT, "the edge was earlier");
    hand.command(0);
    assert_eq!(hand.command(0x80), INHIBIT);
}

#[test]
fn without_mains_an_acu_speaks_but_3_4_and_the_short_cut_are_refused() {
    let mut dark = hand("acu", "mains = false", "\"392\" = 2", INHIBIT);
    assert_eq!(dark.status() & 0x10, 0);
    assert_eq!(dark.command(0x0F), INHIBIT);
    assert_eq!(dark.command(0x06), READY);
    assert_eq!(dark.command(0x07), READY);
    assert_eq!(dark.command(0x0F), READY);
    // The mains go while it is switched on.
    let mut hand = hand("acu", "[[drive.event]]\nat = \"1s\"\nmains = false", "\"392\" = 2", ON);
    hand.wait(1_000);
    assert_eq!((hand.state(), hand.bit(4)), (ON, false));
    assert_eq!(hand.command(0x0F), ON);
}

#[test]
fn without_enable_or_start_contact_4_and_the_short_cut_are_refused() {
    for (model, keys) in [
        ("act", "enable = false"),
        ("act", "start_right = false"),
        ("acu", "enable = false"),
        ("acu", "stoa = false"),
        ("acu", "stob = false"),
        ("acu", "start_right = false"),
    ] {
        let mut hand = hand(model, keys, "\"392\" = 2", INHIBIT);
        assert!(!hand.bit(9), "no Remote bit: {model} {keys}");
        assert_eq!(hand.command(0x0F), INHIBIT);
        assert_eq!([0x06, 0x07, 0x0F].map(|word| hand.command(word)), [READY, ON, ON], "{model} {keys}");
    }
    // Either start contact will do, also one that is tied to "on" by P.68 or P.69.
    for (keys, set) in [
        ("start_right = false\nstart_left = true", "\"68\" = 71"),
        ("start_right = false", "\"68\" = 6"),
        ("start_right = false", "\"69\" = 6"),
    ] {
        let mut hand = hand("act", keys, set, INHIBIT);
        assert!(hand.bit(9));
        assert_eq!(hand.command(0x0F), ENABLED);
    }
}

#[test]
fn positioning_has_no_short_cut() {
    let mut hand = hand("acu", "start_right = false", "\"30\" = 240", INHIBIT);
    assert!(hand.bit(9), "start contacts have no function");
    assert_eq!(hand.command(0x0F), INHIBIT);
    assert_eq!([0x06, 0x07, 0x0F].map(|word| hand.command(word)), [READY, ON, ENABLED]);
    // An ACT knows no positioning.
    assert_eq!(self::hand("act", "", "\"30\" = 240", INHIBIT).command(0x0F), ENABLED);
}

#[test]
fn a_strict_drive_needs_the_remote_bit_for_everything() {
    let keys = "strict_remote = true\nenable = false\n[[drive.event]]\nat = \"1s\"\nenable = true";
    for model in ["act", "acu"] {
        let mut hand = hand(model, keys, "\"392\" = 2", INHIBIT);
        assert_eq!(hand.command(0x06), INHIBIT);
        hand.wait(1_000);
        assert_eq!(hand.state(), READY, "the word still stands");
    }
}

#[test]
fn under_another_control_mode_the_control_word_does_nothing() {
    for mode in [0, 3, 44] {
        let mut hand = hand("acu", "start_right = false", "\"392\" = 2", INHIBIT);
        assert!(hand.write_word(412, mode));
        assert_eq!([0x06, 0x0F, 0x02].map(|word| hand.command(word)), [ON; 3]);
        assert!(!hand.bit(9));
    }
}
