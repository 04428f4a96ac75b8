//! An LXM05 as a master meets it. The seven worked sequences of the LXM05 manual are typed in as telegrams, with the
//! addresses and the 32-bit values that it prints.

mod codes;
mod motion;

use super::*;

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
