//! An LXM05 as a master meets it. The seven worked sequences of the LXM05 manual are typed in as telegrams, with the
//! addresses and the 32-bit values that it prints.

use super::*;
use proptest::collection::vec;
use proptest::prelude::*;

/// One exchange takes this long.
const STEP: Span = Span::from_millis(30);
/// Longest that a movement here may take, in exchanges.
const PATIENCE: usize = 2_000;

/// A master at one LXM05 with address 1.
pub(crate) struct Hand {
    pub(crate) bench: Bench,
    pub(crate) now: Tick,
}

/// What the manual lets a master do.
#[derive(Clone, Copy)]
enum Step {
    /// Code 16, acknowledged.
    Write(&'static str),
    /// Code 3, again and again until the masked value is there.
    Until(&'static str, u32, u32),
}
use Step::{Until, Write};

impl Hand {
    pub(crate) fn on(keys: &str) -> Self {
        Hand::with(&format!("[[drive]]\nmodel = \"lxm05\"\n{keys}\n"))
    }

    pub(crate) fn with(text: &str) -> Self {
        Hand { bench: bench(text), now: Tick::ZERO }
    }

    pub(crate) fn ask_station(&mut self, station: u8, pdu: &[u8]) -> Option<Vec<u8>> {
        self.bench.master_sends(self.now, LINE, &Framing::Rtu.encode(station, pdu));
        self.now += STEP;
        let heard = bytes(&self.bench.advance(self.now));
        Framing::Rtu.decode(&heard).ok().map(|adu| adu.pdu)
    }

    pub(crate) fn ask(&mut self, pdu: &str) -> Vec<u8> {
        self.ask_station(1, &hex(pdu)).unwrap_or_default()
    }

    pub(crate) fn wait(&mut self, millis: u64) {
        self.now += Span::from_millis(millis);
        assert_eq!(self.bench.advance(self.now), []);
    }

    pub(crate) fn read(&mut self, address: u16) -> i32 {
        let [a, b] = address.to_be_bytes();
        match self.ask_station(1, &[3, a, b, 0, 2]).as_deref() {
            Some([3, 4, value @ ..]) => i32::from_be_bytes(value.try_into().unwrap()),
            other => panic!("{address}: {other:?}"),
        }
    }

    /// Tells what the drive answers: 0, or the exception code.
    pub(crate) fn try_write(&mut self, address: u16, value: i32) -> u8 {
        let [a, b] = address.to_be_bytes();
        let pdu = [vec![16, a, b, 0, 2, 4], value.to_be_bytes().to_vec()].concat();
        match self.ask_station(1, &pdu).as_deref() {
            Some([16, echo @ ..]) if *echo == [a, b, 0, 2] => 0,
            Some([0x90, code]) => *code,
            other => panic!("{address}: {other:?}"),
        }
    }

    pub(crate) fn write(&mut self, address: u16, value: i32) {
        assert_eq!(self.try_write(address, value), 0, "{address} = {value}");
    }

    fn run(&mut self, steps: &[Step]) {
        for step in steps {
            match *step {
                Write(pdu) => assert_eq!(self.ask(pdu), hex(pdu)[..5], "{pdu}"),
                Until(pdu, mask, wanted) => {
                    let reached = (0..PATIENCE).any(|_| match self.ask(pdu)[..] {
                        [3, 4, a, b, c, d] => u32::from_be_bytes([a, b, c, d]) & mask == wanted,
                        ref other => panic!("{pdu}: {other:02X?}"),
                    });
                    assert!(reached, "{pdu} never was {wanted:X}");
                }
            }
        }
    }

    pub(crate) fn drive(&self) -> &Drive {
        self.bench.drive(1).unwrap()
    }

    pub(crate) fn drive_mut(&mut self) -> &mut Drive {
        self.bench.drive_mut(1).unwrap()
    }

    pub(crate) fn servo(&self) -> Servo {
        self.drive().servo(self.now).unwrap()
    }

    /// 1/min, whole.
    pub(crate) fn speed(&self) -> i64 {
        self.servo().speed_milli_rpm / 1_000
    }

    pub(crate) fn status(&mut self) -> i32 {
        self.read(6_916)
    }

    /// "Operation enabled" in a mode.
    pub(crate) fn enable(&mut self, mode: i32) {
        self.run(WALK);
        self.write(6_918, mode);
        self.wait(20);
        assert_eq!((self.read(6_920), self.servo().state), (mode, 0x27));
    }
}

/// Disable voltage, shut down, operation enable, check of the state: the same in all sequences.
const WALK: &[Step] = &[
    Write("10 1B 02 00 02 04 00 00 00 00"),
    Write("10 1B 02 00 02 04 00 00 00 06"),
    Write("10 1B 02 00 02 04 00 00 00 0F"),
    Until("03 1B 04 00 02", 0x07, 0x07),
];

/// Manual 5.4.1 to 5.4.3 and 5.5.1 to 5.5.4: what goes before the walk, and what follows it.
const POINT_TO_POINT: (&[Step], &[Step]) = (
    &[
        Write("10 06 14 00 02 04 00 00 07 D0"),
        Write("10 06 16 00 02 04 00 00 0F A0"),
        Write("10 06 12 00 02 04 00 00 17 70"),
        Write("10 1B 1E 00 02 04 00 00 0F A0"),
    ],
    &[
        Write("10 1B 06 00 02 04 00 00 00 01"),
        Until("03 1B 08 00 02", u32::MAX, 1),
        Write("10 1B 1C 00 02 04 00 00 00 30"),
        Write("10 1B 02 00 02 04 00 00 00 5F"),
        Until("03 1B 04 00 02", 0x0400, 0x0400),
        Write("10 1B 02 00 02 04 00 00 00 0F"),
    ],
);
const VELOCITY: (&[Step], &[Step]) = (
    &[
        Write("10 06 14 00 02 04 00 00 07 D0"),
        Write("10 06 16 00 02 04 00 00 27 10"),
        Write("10 06 12 00 02 04 00 00 27 10"),
    ],
    &[
        Write("10 1B 06 00 02 04 00 00 00 03"),
        Until("03 1B 08 00 02", u32::MAX, 3),
        Write("10 1B 1A 00 02 04 00 00 03 E8"),
        Until("03 1B 04 00 02", 0x0400, 0x0400),
    ],
);
const VELOCITY_END: &[Step] = &[Write("10 1B 1A 00 02 04 00 00 00 00"), Until("03 1B 04 00 02", 0x0400, 0x0400)];
const HOMING: (&[Step], &[Step]) = (
    &[Write("10 28 08 00 02 04 00 00 00 64"), Write("10 28 0A 00 02 04 00 00 00 0A")],
    &[
        Write("10 1B 06 00 02 04 00 00 00 06"),
        Until("03 1B 08 00 02", u32::MAX, 6),
        Write("10 1B 18 00 02 04 00 00 00 11"),
        Write("10 1B 02 00 02 04 00 00 00 1F"),
        Until("03 1B 04 00 02", 0x1000, 0x1000),
        Write("10 1B 02 00 02 04 00 00 00 0F"),
    ],
);
const CURRENT: &[Step] = &[
    Write("10 1B 06 00 02 04 FF FF FF FD"),
    Until("03 1B 08 00 02", u32::MAX, 0xFFFF_FFFD),
    Write("10 1B 20 00 02 04 00 00 00 02"),
    Write("10 20 08 00 02 04 00 00 03 E8"),
];
const SPEED: &[Step] = &[
    Write("10 1B 06 00 02 04 FF FF FF FC"),
    Until("03 1B 08 00 02", u32::MAX, 0xFFFF_FFFC),
    Write("10 1B 22 00 02 04 00 00 00 02"),
    Write("10 21 08 00 02 04 00 00 03 E8"),
];
const GEAR: (&[Step], &[Step]) = (
    &[Write("10 05 04 00 02 04 00 00 00 01")],
    &[
        Write("10 1B 06 00 02 04 FF FF FF FE"),
        Until("03 1B 08 00 02", u32::MAX, 0xFFFF_FFFE),
        Write("10 1B 24 00 02 04 00 00 00 01"),
        Write("10 26 06 00 02 04 00 00 00 03"),
        Write("10 26 08 00 02 04 00 00 00 02"),
    ],
);
const JOG: (&[Step], &[Step]) = (
    &[Write("10 29 08 00 02 04 00 00 00 64"), Write("10 29 0A 00 02 04 00 00 00 FA")],
    &[
        Write("10 1B 06 00 02 04 FF FF FF FF"),
        Until("03 1B 08 00 02", u32::MAX, 0xFFFF_FFFF),
        Write("10 1B 12 00 02 04 00 00 00 01"),
    ],
);
const JOG_FAST: &[Step] = &[Write("10 1B 12 00 02 04 00 00 00 05")];

/// Runs a sequence; the judge finds nothing.
fn follow((before, after): (&[Step], &[Step]), keys: &str) -> Hand {
    let mut hand = Hand::on(keys);
    hand.run(before);
    hand.run(WALK);
    hand.run(after);
    assert_eq!(hand.bench.remarks(), []);
    assert!(hand.drive().is_energised());
    hand
}

#[test]
fn sequence_5_4_1_point_to_point() {
    let mut hand = follow(POINT_TO_POINT, "");
    assert_eq!((hand.servo().position_usr, hand.speed(), hand.read(7_700)), (48, 0, 48));
    assert_eq!(hand.status() & 0x1400, 0x0400, "reached, and the start bit is put back");
}

#[test]
fn sequence_5_4_2_velocity_profile() {
    let mut hand = follow(VELOCITY, "");
    assert_eq!((hand.speed(), hand.drive().shaft_speed(hand.now)), (1_000, 1_666));
    hand.run(VELOCITY_END);
    assert_eq!((hand.speed(), hand.status() & 0x1400), (0, 0x1400));
}

#[test]
fn sequence_5_4_3_homing_to_the_negative_limit_switch() {
    let mut hand = follow(HOMING, "servo = { limn = -30000 }");
    hand.wait(1_000);
    // Zero is where the switch lets go; the shaft comes to rest a little behind it.
    assert_eq!((hand.servo().referenced, hand.speed()), (true, 0));
    assert!((0..100).contains(&hand.servo().position_usr), "{:?}", hand.servo());
    assert_eq!(hand.status() & 0x1400, 0x1400);
}

#[test]
fn sequence_5_5_1_current_control() {
    let mut hand = follow((&[], CURRENT), "");
    hand.wait(3_000);
    assert_eq!(hand.speed(), 1_000);
}

#[test]
fn sequence_5_5_2_speed_control() {
    let mut hand = follow((&[], SPEED), "");
    hand.wait(3_000);
    assert_eq!((hand.speed(), hand.status() & 0x0400), (1_000, 0x0400));
}

#[test]
fn sequence_5_5_3_electronic_gear() {
    let mut hand = follow(GEAR, "servo = { guide = 32768 }");
    hand.wait(3_000);
    // Two turns of the guide a second, by 2/3.
    assert_eq!(hand.speed(), 80);
}

#[test]
fn sequence_5_5_4_jog() {
    let mut hand = follow(JOG, "");
    hand.wait(1_000);
    assert_eq!(hand.speed(), 100);
    hand.run(JOG_FAST);
    hand.wait(1_000);
    assert_eq!(hand.speed(), 250);
    hand.write(6_930, 2);
    hand.wait(2_000);
    assert_eq!(hand.speed(), -100);
}

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
