//! What an LXM05 answers: function codes, refusals, settings of the line, and whatever else comes over it.

use super::*;
use proptest::collection::vec;
use proptest::prelude::*;

#[test]
fn addresses_lengths_and_ranges_are_refused_with_their_codes() {
    let mut hand = Hand::on("");
    for (pdu, code) in [
        ("06 1B 02 00 06", 1), // code 6
        ("64 1B 02", 1),       // ACTIVE's own code
        ("03 00 00 00 02", 2), // no parameter
        ("03 1E 15 00 02", 2), // the second register of one
        ("03 1E 14 00 04", 2), // no neighbour
        ("03 1E 14 00 01", 3), // half a parameter
        ("03 1E 14 00 00", 3),
        ("03 1E 14 00 7E", 3),
        ("03 1E 14 00", 3),
        ("10 1B 02 00 02 02 00 06", 3), // bytes and registers
        ("10 1B 02 00 02 03 00 00 00 06", 3),
        ("10 1B 04 00 02 04 00 00 00 00", 4), // the status word
        ("10 1B 06 00 02 04 00 00 00 02", 3), // no such mode
        ("10 16 06 00 02 04 00 00 96 01", 3), // no such baud rate
        ("10 16 0C 00 02 04 00 00 27 11", 3), // over 10000 ms
        ("17 1E 15 00 02 1B 02 00 02 04 00 00 00 06", 2),
        ("08 00 03 00 00", 1), // reserved
        ("08 00 0E 00 00", 1), // not in table 5.2
        ("08 00 0B 00 01", 3),
        ("08 00 01 12 34", 3),
    ] {
        assert_eq!(hand.ask(pdu), [hex(pdu)[0] | 0x80, code], "{pdu}");
    }
    assert_eq!(hand.status() & 0x6F, 0x40, "nothing of it was obeyed");
    assert_eq!(hand.ask("2B 0E 02 00"), hex("AB 0E 03"), "with the type");
    assert_eq!(hand.ask("2B 0D 01 00"), hex("AB 0E 01"));
}

#[test]
fn several_values_are_checked_before_the_first_is_written() {
    let mut hand = Hand::on("");
    // PPn_target is the neighbour of PPp_targetusr, and has a limit.
    assert_eq!(hand.ask("10 1B 1C 00 04 08 00 00 00 30 00 FF FF FF"), hex("90 03"));
    assert_eq!(hand.read(6_940), 0);
    assert_eq!(hand.ask("10 1B 1C 00 04 08 00 00 00 30 00 00 00 FF"), hex("10 1B 1C 00 04"));
    assert_eq!(hand.ask("03 1B 1C 00 04"), hex("03 08 00 00 00 30 00 00 00 FF"));
    // The software limit switches (manual 5.3, example 2).
    assert_eq!(hand.ask("10 06 08 00 04 08 00 00 10 00 FF FF F0 00"), hex("10 06 08 00 04"));
    assert_eq!((hand.read(1_544), hand.read(1_546)), (4_096, -4_096));
}

#[test]
fn code_23_writes_first_and_then_reads() {
    let mut hand = Hand::on("");
    assert_eq!(hand.ask("17 1B 04 00 02 1B 02 00 02 04 00 00 00 06"), hex("17 04 00 00 02 31"));
    assert_eq!(hand.ask("17 1B 1A 00 02 1B 1A 00 02 04 FF FF FF 9C"), hex("17 04 FF FF FF 9C"));
}

#[test]
fn code_43_tells_who_it_is_in_one_piece_or_in_several() {
    let mut hand = Hand::on("servo = { vendor = \"V\", product = \"P\" }");
    let whole = "2B 0E 01 02 00 00 03 00 01 56 01 01 50 03 07 56 30 32 2E 30 30 31";
    assert_eq!(hand.ask("2B 0E 01 00"), hex(whole));
    assert_eq!(hand.ask("2B 0E 01 7F"), hex(whole), "unknown: from the beginning");
    let keys = "servo = { vendor = \"V\", product = \"P\", revision = \"R\", revision_object = 2, in_pieces = true }";
    let mut hand = Hand::on(keys);
    assert_eq!(hand.ask("2B 0E 01 00"), hex("2B 0E 01 02 FF 01 01 00 01 56"));
    assert_eq!(hand.ask("2B 0E 01 01"), hex("2B 0E 01 02 FF 02 01 01 01 50"));
    assert_eq!(hand.ask("2B 0E 01 02"), hex("2B 0E 01 02 00 00 01 02 01 52"));
}

#[test]
fn code_8_echoes_counts_and_silences() {
    let mut hand = Hand::on("");
    assert_eq!(hand.ask("08 00 00 A5 37"), hex("08 00 00 A5 37"));
    assert_eq!(hand.ask("08 00 0A 00 00"), hex("08 00 0A 00 00"));
    hand.ask("03 00 00 00 02");
    assert_eq!(hand.ask("08 00 0D 00 00"), hex("08 00 0D 00 01"));
    assert_eq!(hand.ask("08 00 0B 00 00"), hex("08 00 0B 00 03"));
    assert_eq!(hand.ask("08 00 02 00 00"), hex("08 00 02 00 02"));
    assert_eq!(hand.ask("08 00 0A 00 00"), hex("08 00 0A 00 00"));
    assert_eq!(hand.ask("08 00 02 00 00"), hex("08 00 02 00 00"));
    for sub in ["0C", "10", "11", "12"] {
        assert_eq!(hand.ask(&format!("08 00 {sub} 00 00")), hex(&format!("08 00 {sub} 00 00")));
    }
    assert!(hand.ask("08 00 04 00 00").is_empty());
    assert_eq!(hand.ask_station(2, &hex("08 00 00 00 00")), None);
    assert_eq!(hand.bench.remarks(), [], "nobody waits for a drive that was silenced");
    hand.wait(500);
    assert!(hand.ask("10 1B 02 00 02 04 00 00 00 06").is_empty());
    hand.wait(500);
    assert!(hand.ask("08 00 01 FF 00").is_empty(), "ends it, and is not answered");
    hand.wait(500);
    assert_eq!(hand.status() & 0x6F, 0x40);
    assert_eq!(hand.ask("08 00 01 00 00"), hex("08 00 01 00 00"));
    assert_eq!(hand.ask("08 00 0B 00 00"), hex("08 00 0B 00 01"));
}

#[test]
fn settings_of_the_line_act_from_the_next_power_on() {
    let script = "[[drive.event]]\nat = \"1s\"\npower_cycle = true";
    let mut hand = Hand::on(script);
    for (address, value) in [(5_638, 38_400), (5_640, 7), (5_642, 4), (5_646, 1), (5_644, 700)] {
        hand.write(address, value);
        assert_eq!(hand.read(address), value);
    }
    assert_eq!((hand.drive().line().to_string(), hand.drive().eeprom_writes()), ("19200 8E1".to_owned(), 4));
    hand.now = millis(2_000);
    assert!(hand.ask("03 16 06 00 02").is_empty());
    hand.now = millis(5_000);
    assert_eq!(hand.bench.drive(7).unwrap().line().to_string(), "38400 8N2");
    let line = LineSetting { baud: 38_400, parity: Parity::None, stop_bits: 2, ..LINE };
    let heard = exchange(&mut hand.bench, hand.now, line, &Framing::Rtu.encode(7, &hex("03 16 06 00 0A")));
    let pdu = Framing::Rtu.decode(&bytes(&heard)).unwrap().pdu;
    // Baud rate, address, format, node guard (not kept), word order, low word first.
    assert_eq!(pdu, hex("03 14 96 00 00 00 00 07 00 00 00 04 00 00 00 00 00 00 00 01 00 00"));
}

#[test]
fn position_and_reference_point_are_lost_without_power() {
    let mut hand = Hand::on("[[drive.event]]\nat = \"20s\"\npower_cycle = true");
    hand.enable(6);
    hand.write(6_936, 35);
    hand.write(6_914, 0x1F);
    assert!(hand.servo().referenced);
    hand.enable(1);
    hand.write(6_940, 1_000);
    hand.write(6_914, 0x1F);
    hand.wait(5_000);
    assert_eq!(hand.servo().position_usr, 1_000);
    hand.now = millis(24_000);
    assert_eq!((hand.read(6_914), hand.read(6_920), hand.read(7_700), hand.status() & 0x6F), (0, 0, 0, 0x40));
    assert!(!hand.servo().referenced);
}

#[test]
fn a_broadcast_is_obeyed_and_not_answered() {
    let mut hand = Hand::on("");
    assert_eq!(hand.ask_station(0, &hex("10 1B 02 00 02 04 00 00 00 06")), None);
    hand.wait(100);
    assert_eq!(hand.status() & 0x6F, 0x21);
    assert_eq!(hand.bench.totals().broadcasts, 1);
}

#[test]
fn three_families_share_a_bus_without_a_remark() {
    let text = "[[drive]]\nmodel = \"act\"\n[[drive]]\nmodel = \"acu\"\naddress = 2\n[[drive]]\nmodel = \"lxm05\"\naddress = 3";
    let mut hand = Hand::with(text);
    for _ in 0..3 {
        assert_eq!(hand.ask_station(1, READ), Some(vec![3, 2, 0x05, 0x6E]));
        assert_eq!(hand.ask_station(2, READ), Some(vec![3, 2, 0x05, 0x6E]));
        assert_eq!(hand.ask_station(3, &hex("03 1B 04 00 02")), Some(hex("03 04 00 00 02 50")));
        // Nobody knows the codes of the others.
        assert_eq!(hand.ask_station(1, &hex("2B 0E 01 00")), Some(hex("AB 01")));
        assert_eq!(hand.ask_station(2, &hex("10 1B 02 00 02 04 00 00 00 06")), Some(hex("90 01")));
    }
    assert_eq!(hand.bench.remarks(), []);
    let models: Vec<_> = hand.bench.drives().map(Drive::model).collect();
    assert_eq!(models, ["act", "acu", "lxm05"]);
}

#[test]
fn behind_a_reply_of_an_lxm05_the_silence_of_the_norm_is_enough() {
    let text = "[[drive]]\nmodel = \"act\"\nbaud = 57600\n[[drive]]\nmodel = \"lxm05\"\naddress = 3\nbaud = 38400";
    let mut bench = bench(text);
    let line = LineSetting { baud: 38_400, ..LINE };
    let request = Framing::Rtu.encode(3, &hex("03 1B 04 00 02"));
    let heard = exchange(&mut bench, Tick::ZERO, line, &request);
    let (last, _) = *heard.last().unwrap();
    // A second bench, so that the next request can come when it wants to.
    let mut bench = self::bench(text);
    bench.master_sends(Tick::ZERO, line, &request);
    bench.advance(last);
    let heard = exchange(&mut bench, last + line.t35(), line, &request);
    assert_eq!((heard.len(), bench.remarks()), (9, &[][..]));
}

#[test]
fn nonsense_does_no_harm() {
    let mut hand = Hand::on("servo = { guide = 9223372036854775807, limn = 9223372036854775807 }");
    for mode in [1, 3, 6, -1, -2, -3, -4] {
        hand.enable(mode);
        for (address, value) in [
            (6_940, i32::MIN),
            (6_938, -13_200),
            (9_736, i32::MIN),
            (9_734, 1),
            (6_948, 1),
            (1_284, 1),
            (1_556, 3_000_000),
            (1_558, 1),
            (6_942, 13_200),
            (6_930, 3),
            (6_914, 0x5F),
            (6_940, i32::MAX),
        ] {
            hand.try_write(address, value);
        }
        hand.wait(100_000);
        hand.write(6_914, 0);
        hand.wait(60_000);
        assert_eq!(hand.speed(), 0, "{mode}");
        // A ramp of 1 1/min a second would keep the next mode waiting.
        hand.write(1_558, 3_000_000);
        hand.write(6_938, 0);
    }
}

/// Addresses of what moves the shaft, and around it.
fn any_address() -> impl Strategy<Value = u16> {
    let named = vec![1_284, 1_554, 1_556, 1_558, 5_644, 6_914, 6_918, 6_930, 6_936, 6_938, 6_940, 6_942, 8_200, 9_736];
    prop_oneof![4 => proptest::sample::select(named), 1 => any::<u16>()]
}

/// Values that mean something, and any.
fn any_value() -> impl Strategy<Value = i32> {
    let words = vec![0, 1, 3, 6, 7, 0x0F, 0x1F, 0x5F, 0x8F, 2, -1, -2, -3, -4, 500, -500];
    prop_oneof![4 => proptest::sample::select(words), 1 => any::<i32>()]
}

fn any_pdu() -> impl Strategy<Value = Vec<u8>> {
    let write = (any_address(), any_value()).prop_map(|(address, value)| {
        [vec![16], address.to_be_bytes().to_vec(), vec![0, 2, 4], value.to_be_bytes().to_vec()].concat()
    });
    prop_oneof![4 => write, 1 => vec(any::<u8>(), 1..30)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever comes, in whatever order: it is answered or not, it never panics, and without power nothing turns on.
    #[test]
    fn any_telegrams_do_no_harm(telegrams in vec((any_pdu(), 0u64..3_000), 1..40)) {
        let mut hand = Hand::on("servo = { limits = true, guide = 5000 }");
        for (pdu, pause) in telegrams {
            hand.ask_station(1, &pdu);
            hand.now += Span::from_millis(pause);
            hand.bench.advance(hand.now);
            let status = hand.servo().state;
            prop_assert!([0x40, 0x21, 0x23, 0x27, 0x07, 0x0F, 0x08].contains(&status));
            prop_assert_eq!(hand.drive().is_energised(), [0x27, 0x07, 0x0F].contains(&status));
        }
        let now = hand.now;
        hand.drive_mut().trip(now, 1);
        hand.now += Span::from_secs(60);
        hand.bench.advance(hand.now);
        prop_assert_eq!((hand.servo().state, hand.servo().speed_milli_rpm), (0x08, 0));
    }

    /// What the drive does hangs on the time, and not on who looks when.
    #[test]
    fn looking_changes_nothing(looks in vec(1u64..400_000, 0..60)) {
        let run = |looks: &[u64]| {
            let mut hand = Hand::on("set = { MBnode_guard = 5000 }");
            hand.enable(1);
            hand.write(6_940, 100_000);
            hand.write(6_914, 0x1F);
            let end = hand.now + Span::from_secs(8);
            for look in looks {
                let at = hand.now + Span::from_micros(*look);
                if at < end {
                    hand.now = at;
                    hand.bench.advance(at);
                }
            }
            hand.bench.advance(end);
            hand.drive().servo(end)
        };
        prop_assert_eq!(run(&looks), run(&[]));
    }
}
