//! The master of a PROFIBUS line against modules of the bench on bad lines: no answer is lost that repeats can bring, none is
//! taken that is not the answer, no idle time is too short, and every question has an end.

use super::spoilt::spoilt;
use antrieb::exchange::Verdict;
use antrieb::exchange::dp::{Asked, Fdl, Heard, Listening, MASTER, Reply, Timing, Unanswered};
use antrieb::exchange::{Conversation, Step};
use antrieb::profile::Registry;
use antrieb::protocol::dp::control::{Station, Status};
use antrieb::protocol::dp::{Control, Diagnosis, Frame, Service, Telegram};
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::simulator::Profibus;
use antrieb::tick::{Span, Tick};
use proptest::prelude::*;

const RATES: [u32; 4] = [9_600, 19_200, 93_750, 500_000];
/// FDL status of master 2 to station 3, a token of master 4, and an answer to master 2.
const ASKED: [u8; 6] = [0x10, 0x03, 0x02, 0x49, 0x4E, 0x16];
const TOKEN: [u8; 3] = [0xDC, 0x05, 0x04];
const ANSWERED: [u8; 6] = [0x10, 0x02, 0x03, 0x00, 0x05, 0x16];

/// A line with one module at 3, and what else stands in its file.
struct Bus {
    bus: Profibus,
    fdl: Fdl,
    line: LineSetting,
    now: Tick,
}

impl Bus {
    fn new(baud: u32, more: &str) -> Self {
        let registry = Registry::open(&[]).unwrap();
        let text = format!("[line]\nbaud = {baud}\n{more}\n[[module]]\ndrive = \"l200\"\naddress = 3\n");
        let bus = Profibus::from_toml("line.toml", &text, &registry).unwrap();
        let (line, now) = (LineSetting::rtu(baud, Parity::Even), Tick::ZERO + Span::from_secs(1));
        Bus { bus, fdl: Fdl::new(MASTER, line, Timing::of(line), now), line, now }
    }

    fn carry<C: Conversation>(bus: &mut Profibus, now: &mut Tick, line: LineSetting, talk: &mut C) -> C::End {
        loop {
            match talk.step(*now) {
                Step::Done(end) => return end,
                Step::Send(bytes) => bus.master_sends(*now, line, &bytes),
                Step::Wait(until) => {
                    *now = bus.next_event().map_or(until, |event| event.min(until)).max(*now + Span::from_micros(1));
                    let bytes: Vec<u8> = bus.advance(*now).into_iter().map(|(_, byte)| byte).collect();
                    if !bytes.is_empty() {
                        talk.feed(*now, &bytes);
                    }
                }
            }
        }
    }

    fn ask(&mut self, station: u8, asked: Asked) -> Result<Reply, Unanswered> {
        self.fdl.ask(station, asked, None, self.now);
        Bus::carry(&mut self.bus, &mut self.now, self.line, &mut self.fdl)
    }

    fn service(&mut self, service: Service) -> Result<Vec<u8>, Unanswered> {
        match self.ask(3, Asked::service(service, Vec::new()))? {
            Reply::Frame { data, .. } => Ok(data),
            other => panic!("{other:?}"),
        }
    }

    /// What is asked in turns, so that an old answer would be seen.
    #[track_caller]
    fn is_answered(&mut self, times: usize) {
        for _ in 0..times {
            let diagnosis = Diagnosis::decode(&self.service(Service::SlaveDiag).unwrap()).unwrap();
            assert_eq!(diagnosis.flags().collect::<Vec<_>>(), ["Station_Not_Ready", "Prm_Req"]);
            assert_eq!(diagnosis.ident, 0x0BE7);
            assert_eq!(self.service(Service::GetCfg), Ok(vec![0xF3, 0xF1]));
            assert!(matches!(self.ask(3, Asked::STATUS), Ok(Reply::Frame { .. })));
        }
    }
}

#[test]
fn on_a_good_line_every_question_is_asked_once_and_no_idle_time_is_too_short() {
    for baud in RATES {
        for more in ["", "echo = true"] {
            let mut bus = Bus::new(baud, more);
            bus.is_answered(50);
            assert_eq!((bus.bus.remarks(), bus.fdl.repeats(3)), (&[][..], 0), "{baud} {more}");
        }
    }
}

#[test]
fn an_adapter_that_holds_bytes_back_costs_repeats_at_most() {
    for (baud, latency) in [(9_600, 16), (19_200, 16), (93_750, 4), (500_000, 4)] {
        for echo in [true, false] {
            let mut bus = Bus::new(baud, &format!("latency = \"{latency}ms\"\necho = {echo}"));
            bus.is_answered(50);
            assert_eq!((bus.bus.remarks(), bus.fdl.repeats(3)), (&[][..], 0), "{baud} {echo}");
        }
    }
}

#[test]
fn repeats_heal_a_bad_line() {
    for baud in RATES {
        for seed in 1..4 {
            for more in ["flips = 6", "losses = 8", "flips = 3\nlosses = 4\necho = true"] {
                let mut bus = Bus::new(baud, &format!("seed = {seed}\n{more}"));
                bus.is_answered(60);
                assert!(bus.fdl.repeats(3) > 0, "{baud} {more}");
            }
        }
    }
}

/// What a master that asks once makes of these bytes, all there is.
fn believed(asked: &Asked, bytes: &[u8]) -> Option<Reply> {
    let (line, mut now) = (LineSetting::rtu(19_200, Parity::Even), Tick::ZERO + Span::from_secs(1));
    let mut fdl = Fdl::new(MASTER, line, Timing::of(line), now);
    let mut came = None;
    fdl.ask(3, asked.clone(), Some(0), now);
    loop {
        match fdl.step(now) {
            Step::Done(end) => return end.ok(),
            Step::Send(question) => {
                now += line.chars(question.len() as u64);
                // What came before the question would be none.
                came = Some(bytes);
            }
            Step::Wait(until) => match came.take_if(|_| until > now + Span::from_millis(1)) {
                Some(bytes) => {
                    now += Span::from_millis(1);
                    fdl.feed(now, bytes);
                }
                None => now = until,
            },
        }
    }
}

/// Every answer, spoilt in every way: what is believed is what the whole one says, or a whole telegram stands in it by chance: SC has no check,
/// and that of the others is a sum.
#[test]
fn spoilt_answers_are_not_believed() {
    let mut bus = Bus::new(19_200, "");
    let services = [Service::SlaveDiag, Service::GetCfg].map(|service| Asked::service(service, Vec::new()));
    let mut exchanges = Vec::new();
    for asked in services.into_iter().chain([Asked::STATUS]) {
        let right = bus.ask(3, asked.clone()).unwrap();
        let records = bus.fdl.take_records();
        let whole = records.into_iter().rfind(|record| record.verdict == Verdict::Reply).unwrap().bytes;
        assert_eq!(believed(&asked, &whole).as_ref(), Some(&right), "{whole:02X?}");
        exchanges.push((asked, right, whole));
    }
    let (mut tried, mut chance) = (0, 0);
    for (asked, right, whole) in &exchanges {
        for bytes in spoilt(whole, exchanges.iter().map(|(_, _, other)| &other[..])) {
            tried += 1;
            if let Some(said) = believed(asked, &bytes).filter(|said| said != right) {
                let is_whole = |length| bytes.windows(length).any(|window| Telegram::decode(window).is_ok());
                assert!((1..=bytes.len()).any(is_whole), "{bytes:02X?} as {said:?}");
                chance += 1;
            }
        }
    }
    println!("PROFIBUS: {tried} spoilt replies, {chance} believed because the check value was right");
    assert!(tried > 1_000);
}

#[test]
fn a_mute_station_is_asked_four_times_and_costs_four_slots() {
    let mut bus = Bus::new(19_200, "");
    let begun = bus.now;
    let slot = Span::from_millis(30);
    assert_eq!(bus.ask(9, Asked::STATUS), Err(Unanswered::Silence { slot, asked: 4 }));
    let took = bus.now.since(begun);
    assert!(took >= slot.times(4) && took < slot.times(4) + Span::from_millis(30), "{took}");
    assert_eq!(bus.bus.remarks(), [] as [String; 0]);
    bus.is_answered(1);
}

#[test]
fn who_asks_besides_is_heard_before_and_between_our_questions() {
    for (bytes, master) in [(&ASKED[..], 2), (&TOKEN, 4), (&ANSWERED, 2)] {
        let mut listening = Listening::new(Tick::ZERO);
        assert!(matches!(listening.step(Tick::ZERO), Step::Wait(_)));
        listening.feed(Tick::ZERO, &[&[0x00], bytes].concat());
        assert_eq!(listening.step(Tick::ZERO), Step::Done(Heard::Master(master)));
        let mut bus = Bus::new(19_200, "");
        bus.fdl.ask(3, Asked::STATUS, None, bus.now);
        while !matches!(bus.fdl.step(bus.now), Step::Send(_)) {
            bus.now += Span::from_millis(1);
        }
        bus.fdl.feed(bus.now, bytes);
        assert_eq!(bus.fdl.step(bus.now), Step::Done(Err(Unanswered::OtherMaster(master))));
    }
    for (noise, heard) in [(2, Heard::Nobody), (40, Heard::Somebody)] {
        let mut listening = Listening::new(Tick::ZERO);
        listening.feed(Tick::ZERO, &vec![0x55; noise]);
        assert_eq!(listening.step(Tick::ZERO + Span::from_secs(2)), Step::Done(heard));
    }
}

#[test]
fn a_question_that_was_left_alone_has_its_time_before_the_next() {
    let mut bus = Bus::new(19_200, "");
    for micros in (0..12_000).step_by(500) {
        bus.fdl.ask(3, Asked::service(Service::SlaveDiag, Vec::new()), None, bus.now);
        let until = bus.now + Span::from_micros(micros);
        while bus.now < until {
            if let Step::Send(bytes) = bus.fdl.step(bus.now) {
                bus.bus.master_sends(bus.now, bus.line, &bytes);
            }
            bus.now += Span::from_micros(100);
        }
        assert_eq!(bus.service(Service::GetCfg), Ok(vec![0xF3, 0xF1]));
    }
    assert_eq!(bus.bus.remarks(), [] as [String; 0]);
}

/// An adapter hands bytes over one by one, and those of a value are nobody's telegram: a token has no check, and SC is one byte.
#[test]
fn a_value_may_have_the_bytes_of_a_short_acknowledgement_or_of_a_token() {
    let line = LineSetting::rtu(19_200, Parity::Even);
    for byte in [0xE5, 0xDC, 0x10, 0xA2, 0x68] {
        let mut fdl = Fdl::new(MASTER, line, Timing::of(line), Tick::ZERO);
        let mut now = Tick::ZERO + Span::from_secs(1);
        fdl.ask(3, Asked::service(Service::DataExchange, vec![0; 4]), None, now);
        assert!(matches!(fdl.step(now), Step::Send(_)));
        let control = Control::Reply { station: Station::Slave, status: Status::DataLow };
        let data = vec![0, byte, 0, byte];
        let reply = Frame { to: MASTER, from: 3, control, dsap: None, ssap: None, data: data.clone(), is_fixed: false };
        now += Span::from_millis(10);
        for byte in Telegram::Frame(reply).encode() {
            now += Span::from_micros(573);
            fdl.feed(now, &[byte]);
        }
        let Step::Done(Ok(Reply::Frame { data: told, .. })) = fdl.step(now) else { panic!("{byte:02X}") };
        assert_eq!(told, data);
    }
}

proptest! {
    /// Whatever comes, a question ends, within the time of its tries, and is believed only where an answer came.
    #[test]
    fn no_bytes_put_off_the_end(
        chunks in proptest::collection::vec((0_u64..20_000, proptest::collection::vec(any::<u8>(), 0..40)), 0..400),
    ) {
        let line = LineSetting::rtu(19_200, Parity::Even);
        let mut fdl = Fdl::new(MASTER, line, Timing::of(line), Tick::ZERO);
        fdl.ask(3, Asked::service(Service::SlaveDiag, Vec::new()), None, Tick::ZERO);
        let (mut now, mut chunks) = (Tick::ZERO, chunks.into_iter());
        let end = loop {
            match fdl.step(now) {
                Step::Done(end) => break end,
                Step::Send(_) => {}
                Step::Wait(until) => match chunks.next() {
                    Some((after, bytes)) if !bytes.is_empty() => {
                        now = until.min(now + Span::from_micros(after)).max(now + Span::from_micros(1));
                        fdl.feed(now, &bytes);
                    }
                    _ => now = until,
                },
            }
            prop_assert!(now < Tick::ZERO + Span::from_secs(10));
        };
        prop_assert!(end.is_err(), "{end:?}");
    }
}
