//! The bench as a master meets it: the worked telegrams of the manual, the times on the wire, and the judge.

use super::*;
use crate::profile::Registry;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::Framing;
use crate::tick::{Span, Tick};

mod hand;
mod motion;
mod readings;
mod servo;
mod transitions;
mod vabus;

/// Request and reply of every worked example in RTU (CM-485 manual 8.1).
const RTU: &[(&str, &str, &str)] = &[
    ("8.1.1 ex 1", "01 03 21 74 00 01 CE 2C", "01 03 02 05 6E 3A F8"),
    ("8.1.1 ex 2", "01 03 01 74 00 02 85 ED", "01 83 02 C0 F1"),
    ("8.1.2 ex 1", "03 06 41 78 00 0F 5C 09", "03 06 41 78 00 0F 5C 09"),
    ("8.1.2 ex 2", "03 06 21 78 00 00 02 0D", "03 86 04 E2 63"),
    ("8.1.3 ex 1", "01 64 01 E1 81 DF", "01 64 00 00 03 E8 70 BC"),
    ("8.1.3 ex 2", "01 64 26 40 5B 97", "01 E4 04 6A C3"),
    ("8.1.4 ex 1", "01 65 21 77 00 00 03 E8 46 C5", "01 65 21 77 00 00 03 E8 46 C5"),
    ("8.1.4 ex 2", "01 65 21 77 00 00 03 84 46 E8", "01 E5 04 6B 53"),
    ("8.1.5 ex 1a", "01 08 00 0A 00 00 C0 09", "01 08 00 0A 00 00 C0 09"),
    ("8.1.5 ex 1b", "01 08 00 0E 00 00 81 C8", "01 08 00 0E 00 01 40 08"),
    ("8.1.5 ex 2", "01 08 00 13 00 00 11 CE", "01 88 01 87 C0"),
];

/// The same in ASCII, without CR LF (CM-485 manual 8.2; the code row of 8.2.3 ex 2 is misprinted there, sources G1).
const ASCII: &[(&str, &str, &str)] = &[
    ("8.2.1 ex 1", ":01032174000166", ":010302056E87"),
    ("8.2.1 ex 2", ":01030174000285", ":0183027A"),
    ("8.2.2 ex 1", ":03064178000F2F", ":03064178000F2F"),
    ("8.2.2 ex 2", ":0306217800005E", ":03860473"),
    ("8.2.3 ex 1", ":016401E1B9", ":0164000003E8B0"),
    ("8.2.3 ex 2", ":0164264035", ":01E40417"),
    ("8.2.4 ex 1", ":01652177000003E817", ":01652177000003E817"),
    ("8.2.4 ex 2", ":01652177000003847B", ":01E50416"),
    ("8.2.5 ex 1a", ":0108000A0000ED", ":0108000A0000ED"),
    ("8.2.5 ex 1b", ":0108000E0000E9", ":0108000E0001E8"),
    ("8.2.5 ex 2", ":010800130000E4", ":01880176"),
];

const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);

thread_local! {
    /// Read once for a test, not for every bench of it.
    static REGISTRY: Registry = Registry::open(&[]).unwrap();
}

fn bench(text: &str) -> Bench {
    REGISTRY.with(|registry| Bench::from_toml("test.toml", text, registry)).unwrap()
}

fn standard() -> Bench {
    Bench::built_in()
}

fn hex(text: &str) -> Vec<u8> {
    text.split(' ').map(|byte| u8::from_str_radix(byte, 16).unwrap()).collect()
}

fn millis(count: u64) -> Tick {
    Tick::ZERO + Span::from_millis(count)
}

/// Sends at `at` and returns what comes within a second.
fn exchange(bench: &mut Bench, at: Tick, line: LineSetting, bytes: &[u8]) -> Vec<(Tick, u8)> {
    bench.master_sends(at, line, bytes);
    bench.advance(at + Span::from_secs(1))
}

fn bytes(heard: &[(Tick, u8)]) -> Vec<u8> {
    heard.iter().map(|heard| heard.1).collect()
}

/// Sends a PDU by RTU, one second after the last, and returns the PDU of the reply.
struct Master {
    bench: Bench,
    now: Tick,
}

impl Master {
    fn new(text: &str) -> Self {
        Master { bench: bench(text), now: Tick::ZERO }
    }

    fn ask(&mut self, station: u8, pdu: &[u8]) -> Option<Vec<u8>> {
        let heard = exchange(&mut self.bench, self.now, LINE, &Framing::Rtu.encode(station, pdu));
        self.now += Span::from_secs(1);
        Framing::Rtu.decode(&bytes(&heard)).ok().filter(|adu| adu.station == station).map(|adu| adu.pdu)
    }

    fn wait(&mut self, millis: u64) {
        self.now += Span::from_millis(millis);
        assert_eq!(self.bench.advance(self.now), []);
    }

    fn sins(&self) -> Vec<Sin> {
        self.bench.remarks().iter().map(|remark| remark.kind).collect()
    }
}

const ACT: &str = "[[drive]]\nmodel = \"act\"\n";
const READ: &[u8] = &[3, 0x21, 0x74, 0, 1];

#[test]
fn what_nobody_reads_of_a_flood_is_lost_when_the_drivers_buffer_is_full() {
    let mut bench =
        bench("[[drive]]\nmodel = \"act\"\n[[disturb]]\nkind = \"babble\"\npattern = \"55 AA\"\nby = \"0ms\"\n");
    // Two minutes at 19200 Bd are 200,000 characters.
    assert_eq!(bench.advance(Tick::ZERO + Span::from_secs(120)).len(), 65_536);
    let more = bench.advance(Tick::ZERO + Span::from_secs(121));
    assert!((1_500..2_000).contains(&more.len()), "{}", more.len());
}

#[test]
fn all_worked_rtu_telegrams() {
    let mut bench = bench("[[drive]]\nmodel = \"act\"\n[[drive]]\nmodel = \"acu\"\naddress = 3\n");
    let mut at = Tick::ZERO;
    for (name, request, reply) in RTU {
        let heard = exchange(&mut bench, at, LINE, &hex(request));
        assert_eq!(bytes(&heard), hex(reply), "{name}");
        at += Span::from_secs(1);
    }
    assert_eq!(bench.remarks(), []);
    assert_eq!((bench.totals().received, bench.totals().answered, bench.totals().exceptions), (11, 11, 5));
}

#[test]
fn all_worked_ascii_telegrams() {
    let text = "[[drive]]\nmodel = \"acu\"\nprotocol = \"ascii\"\n[[drive]]\nmodel = \"act\"\naddress = 3\nprotocol = \"ascii\"";
    let mut bench = bench(text);
    let line = LineSetting::ascii(19_200, Parity::Even);
    let mut at = Tick::ZERO;
    for (name, request, reply) in ASCII {
        let heard = exchange(&mut bench, at, line, format!("{request}\r\n").as_bytes());
        assert_eq!(String::from_utf8(bytes(&heard)).unwrap(), format!("{reply}\r\n"), "{name}");
        at += Span::from_secs(1);
    }
    assert_eq!(bench.remarks(), []);
}

#[test]
fn a_reply_begins_10_ms_after_the_last_bit_and_takes_its_time() {
    let mut bench = standard();
    let request = hex(RTU[0].1);
    bench.master_sends(millis(5), LINE, &request);
    let first = millis(15) + LINE.chars(8) + LINE.chars(1);
    while let Some(next) = bench.next_event() {
        let heard = bench.advance(next);
        if let Some((at, byte)) = heard.first() {
            assert_eq!((*at, *byte, next), (first, 1, first));
            break;
        }
    }
    let heard = bench.advance(millis(1_000));
    assert_eq!(heard.last().unwrap().0, millis(15) + LINE.chars(8) + LINE.chars(7));
    assert_eq!(bench.next_event(), None);
}

#[test]
fn a_scan_finds_two_drives_and_costs_nothing() {
    let mut bench = standard();
    let mut at = Tick::ZERO;
    let mut found = Vec::new();
    for station in 1..=247 {
        let heard = exchange(&mut bench, at, LINE, &Framing::Rtu.encode(station, &[8, 0, 0x0E, 0, 0]));
        found.extend((!heard.is_empty()).then_some(station));
        at += Span::from_secs(1);
    }
    assert_eq!(found, [1, 2]);
    assert_eq!(bench.remarks(), []);
    assert_eq!(bench.totals().ignored.no_station, 245);
}

#[test]
fn another_speed_parity_or_width_is_not_heard() {
    for line in [
        LineSetting::rtu(9_600, Parity::Even),
        LineSetting::rtu(19_200, Parity::Odd),
        LineSetting::rtu(19_200, Parity::None),
        LineSetting::ascii(19_200, Parity::Even),
    ] {
        let mut master = Master::new(ACT);
        assert_eq!(exchange(&mut master.bench, Tick::ZERO, line, &hex(RTU[0].1)), []);
        assert_eq!(master.bench.totals().ignored.wrong_line, 1, "{line}");
        master.now = millis(2_000);
        assert_eq!(master.ask(1, &[8, 0, 0x0C, 0, 0]), Some(vec![8, 0, 0x0C, 0, 1]), "{line}");
    }
    // Stop bits do not matter.
    let two = LineSetting { stop_bits: 2, ..LINE };
    assert_eq!(bytes(&exchange(&mut standard(), Tick::ZERO, two, &hex(RTU[0].1))), hex(RTU[0].2));
}

#[test]
fn counters_tell_what_was_on_the_bus() {
    let mut master = Master::new("[[drive]]\nmodel = \"act\"\n[[drive]]\nmodel = \"act\"\naddress = 2\n");
    let counter = |master: &mut Master, sub: u8| {
        let reply = master.ask(1, &[8, 0, sub, 0, 0]).unwrap();
        u16::from(reply[3]) << 8 | u16::from(reply[4])
    };
    master.ask(1, &[8, 0, 0x0A, 0, 0]);
    assert_eq!(counter(&mut master, 0x0E), 1);
    master.ask(2, READ); // counts twice: the question and the answer of the other drive
    assert_eq!(counter(&mut master, 0x0B), 4);
    assert_eq!(master.ask(0, &[6, 0x21, 0x74, 5, 0]), None);
    assert_eq!((counter(&mut master, 0x0F), counter(&mut master, 0x0D)), (1, 0));
    master.ask(1, &[1, 0, 0, 0, 0]);
    assert_eq!(counter(&mut master, 0x0D), 1);
    let mut broken = Framing::Rtu.encode(1, READ);
    broken[3] ^= 1;
    assert_eq!(exchange(&mut master.bench, master.now, LINE, &broken), []);
    master.wait(1_000);
    assert_eq!((counter(&mut master, 0x0C), counter(&mut master, 0x10), counter(&mut master, 0x11)), (1, 0, 0));
    assert_eq!(master.sins(), [Sin::Malformed]);
    assert_eq!(master.bench.drive(2).unwrap().eeprom(372, 2), Some(0x500));
}

#[test]
fn a_broadcast_read_is_a_sin_and_gets_nothing() {
    let mut master = Master::new(ACT);
    assert_eq!(master.ask(0, READ), None);
    assert_eq!(master.sins(), [Sin::BroadcastRead]);
}

#[test]
fn a_gap_inside_a_telegram_gets_no_answer() {
    let mut bench = standard();
    let request = hex(RTU[0].1);
    bench.master_sends(Tick::ZERO, LINE, &request[..4]);
    let rest = Tick::ZERO + LINE.chars(4) + LINE.t15() + Span::from_micros(2);
    assert_eq!(exchange(&mut bench, rest, LINE, &request[4..]), []);
    assert_eq!(bench.remarks()[0].kind, Sin::GapInside);
    assert_eq!(
        bench.remarks()[0].to_string(),
        "3.1 ms: 862 us of silence inside a telegram, at most 860 us allowed (gap-inside)"
    );
}

#[test]
fn speaking_into_a_reply_spoils_both() {
    let mut bench = standard();
    bench.master_sends(Tick::ZERO, LINE, &hex(RTU[0].1));
    bench.advance(millis(16));
    let heard = exchange(&mut bench, millis(16), LINE, &Framing::Rtu.encode(2, READ));
    assert!(Framing::Rtu.decode(&bytes(&heard)).is_err());
    let kinds: Vec<_> = bench.remarks().iter().map(|remark| remark.kind).collect();
    assert_eq!(kinds, [Sin::WhileBusy]);
}

#[test]
fn impatience_is_noted_and_differs_by_who_was_asked() {
    let mut bench = standard();
    let mut at = Tick::ZERO;
    for (station, wait) in [(1, 8), (77, 60), (1, 100), (1, 0)] {
        bench.master_sends(at, LINE, &Framing::Rtu.encode(station, READ));
        at += Span::from_millis(wait);
        bench.advance(at);
    }
    let kinds: Vec<_> = bench.remarks().iter().map(|remark| remark.kind).collect();
    assert_eq!(kinds, [Sin::WhileBusy, Sin::Impatient]);
}

#[test]
fn a_request_right_after_a_reply_is_too_early_but_only_the_strict_drive_is_deaf() {
    for (strict, answered) in [(false, true), (true, false)] {
        let mut bench = bench(&format!("{ACT}strict_silence = {strict}"));
        let request = hex(RTU[0].1);
        bench.master_sends(Tick::ZERO, LINE, &request);
        let end = millis(10) + LINE.chars(8) + LINE.chars(7);
        assert_eq!(bench.advance(end).len(), 7);
        let heard = exchange(&mut bench, end + Span::from_millis(1), LINE, &request);
        assert_eq!(!heard.is_empty(), answered);
        assert_eq!(bench.remarks()[0].kind, Sin::TooEarly);
    }
}

#[test]
fn two_drives_with_one_address_spoil_each_other() {
    let mut bench = bench(&format!("{ACT}{ACT}"));
    let heard = exchange(&mut bench, Tick::ZERO, LINE, &hex(RTU[0].1));
    assert!(!heard.is_empty() && Framing::Rtu.decode(&bytes(&heard)).is_err());
}

#[test]
fn high_load_answers_after_the_time_out_and_answers_pile_up() {
    let mut bench = bench(&format!("{ACT}load = \"high\""));
    bench.master_sends(Tick::ZERO, LINE, &Framing::Rtu.encode(1, READ));
    bench.advance(millis(510));
    bench.master_sends(millis(510), LINE, &Framing::Rtu.encode(1, &[3, 1, 0x9B, 0, 1]));
    let heard = bench.advance(millis(2_000));
    assert_eq!(bytes(&heard[..7]), hex(RTU[0].2));
    assert!(heard[0].0 > millis(700) && heard[7].0 > millis(1_210));
    assert_eq!(bench.remarks(), []);
}

#[test]
fn a_new_address_holds_after_the_echo_and_a_new_speed_after_a_reset() {
    let mut master = Master::new(ACT);
    assert!(master.ask(1, &[6, 0x05, 0x60, 0, 9]).is_some());
    assert_eq!((master.ask(1, READ), master.ask(9, READ).is_some()), (None, true));
    assert!(master.ask(9, &[6, 0, 10, 0, 3]).is_some());
    assert!(master.ask(9, READ).is_some());
    assert!(master.ask(9, &[6, 0, 34, 0, 123]).is_some());
    assert_eq!(master.bench.totals().ignored.no_station, 1);
    assert_eq!(master.ask(9, READ), None);
    assert_eq!(master.bench.totals().ignored.away, 1);
    master.wait(3_000);
    assert_eq!(master.ask(9, READ), None);
    let slow = LineSetting::rtu(9_600, Parity::Even);
    assert_eq!(exchange(&mut master.bench, master.now, slow, &Framing::Rtu.encode(9, READ)).len(), 7);
}

#[test]
fn a_wrong_protocol_falls_silent_at_once() {
    let mut master = Master::new(ACT);
    assert!(master.ask(1, &[6, 1, 0x8B, 0, 0]).is_some());
    assert_eq!(master.ask(1, READ), None);
    assert_eq!((master.bench.drive(1).unwrap().protocol(), master.bench.totals().ignored.wrong_protocol), ("vabus", 1));
    let mut master = Master::new(ACT);
    master.ask(1, &[6, 1, 0x8B, 0, 3]);
    let ascii = LineSetting::ascii(19_200, Parity::Even);
    assert!(!exchange(&mut master.bench, master.now, ascii, &Framing::Ascii.encode(1, READ)).is_empty());
}

#[test]
fn the_watchdog_trips_when_nobody_speaks() {
    let mut master = Master::new(ACT);
    master.ask(1, &[6, 1, 0x9D, 0, 2]);
    master.wait(500);
    assert_eq!(master.ask(1, &[3, 1, 4, 0, 1]), Some(vec![3, 2, 0, 0]));
    assert!(!master.bench.drive(1).unwrap().in_fault());
    master.wait(1_100);
    assert!(master.bench.drive(1).unwrap().in_fault());
    assert_eq!(master.ask(1, &[3, 1, 4, 0, 1]), Some(vec![3, 2, 0x20, 0x10]));
}

#[test]
fn a_script_lets_things_happen() {
    let mut master = Master::new(&format!(
        "{ACT}[[drive.event]]\nat = \"2s\"\nfault = \"F0500\"\nwarning = 0x0002\n[[drive.event]]\nat = \"5500ms\"\nsilent = \"1s\""
    ));
    assert_eq!(master.ask(1, &[3, 1, 4, 0, 1]), Some(vec![3, 2, 0, 0]));
    assert_eq!(master.bench.next_event(), Some(millis(2_000)));
    master.wait(2_000);
    assert_eq!(master.ask(1, &[3, 1, 4, 0, 1]), Some(vec![3, 2, 5, 0]));
    assert_eq!(master.ask(1, &[3, 1, 0x0E, 0, 1]), Some(vec![3, 2, 0, 3]));
    master.wait(1_000);
    assert_eq!(master.ask(1, READ), None);
    assert!(master.ask(1, READ).is_some());
}

#[test]
fn the_shaft_follows_the_setpoint_of_the_bus() {
    let mut master = Master::new("[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }");
    master.ask(1, &[101, 1, 0xE4, 0, 0, 0x03, 0xE8]);
    master.ask(1, &[6, 1, 0x9A, 0, 0x0F]);
    let frequency = |master: &mut Master| {
        let reply = master.ask(1, &[100, 0, 210]).unwrap();
        i64::from(u16::from(reply[3]) << 8 | u16::from(reply[4]))
    };
    assert!((490..=510).contains(&frequency(&mut master)));
    master.wait(2_000);
    assert_eq!(frequency(&mut master), 1_000);
    let status = master.ask(1, &[3, 1, 0x9B, 0, 1]).unwrap();
    assert_eq!(status, [3, 2, 0x06, 0x37]);
}

#[test]
fn a_disturbed_line_does_what_the_file_says() {
    let heard = |kind: &str| {
        let mut bench = bench(&format!("{ACT}[[disturb]]\nonce = 1\nkind = \"{kind}\""));
        let heard = exchange(&mut bench, Tick::ZERO, LINE, &hex(RTU[0].1));
        assert_eq!(bench.remarks(), []);
        (heard[..].first().map(|heard| heard.0), bytes(&heard))
    };
    let (start, reply) = heard("doubled");
    assert_eq!(reply, [hex(RTU[0].2), hex(RTU[0].2)].concat());
    assert_eq!(heard("late").0, start.map(|start| start + Span::from_millis(150)));
    assert_eq!(heard("lost").1, Vec::<u8>::new());
    assert_eq!(heard("echo").1, [hex(RTU[0].1), hex(RTU[0].2)].concat());
    assert_eq!(heard("noise").1, [vec![0], hex(RTU[0].2)].concat());
    assert_eq!(heard("truncated").1, hex(RTU[0].2)[..4]);
}

#[test]
fn the_judge_and_the_bench_survive_anything() {
    let mut bench = standard();
    let mut dice = dice::Dice::new(3);
    let mut at = Tick::ZERO;
    for _ in 0..600 {
        let bytes: Vec<u8> = (0..dice.below(300)).map(|_| dice.below(256) as u8).collect();
        let baud = [0, 2_400, 19_200, 115_200, u32::MAX][dice.below(5) as usize];
        let line = LineSetting { baud, data_bits: dice.below(10) as u8, parity: Parity::Even, stop_bits: 1 };
        bench.master_sends(at, line, &bytes);
        at += Span::from_micros(dice.below(40_000));
        bench.advance(at);
    }
    for function in 0..=255 {
        let pdu: Vec<u8> = std::iter::once(function).chain((0..dice.below(8)).map(|_| dice.below(256) as u8)).collect();
        bench.master_sends(at, LINE, &Framing::Rtu.encode(1, &pdu));
        at += Span::from_millis(600);
        bench.advance(at);
    }
    bench.master_sends(at, LineSetting { baud: 1, ..LINE }, &[1; 300]);
    bench.master_sends(Tick::from_micros(u64::MAX), LINE, &[1, 2, 3]);
    bench.advance(Tick::from_micros(u64::MAX));
    assert!(bench.totals().received > 200);
}
