//! What a line costs that is honest but not smooth: stations answer everything once, in order, and rightly, but replies come
//! late, in pieces, behind a little noise, or all in the same words. Nothing of that is a second drive, so little of it may
//! cost more than itself. In virtual time, by dice with a seed.

use super::dice::Dice;
use antrieb::exchange::{Answer, ExchangeError, INSIST, Limits, Master, Question, Record, Said, Step, Verdict};
use antrieb::protocol::Protocol;
use antrieb::protocol::can::sdo;
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::protocol::modbus::pdu::{COUNTERS, Exception, Reply, Request};
use antrieb::protocol::modbus::{Framing, mbap};
use antrieb::protocol::vabus::{self, Address, Data, Header, ParamNumber};
use antrieb::tick::{Span, Tick};
use std::collections::{BTreeMap, VecDeque};

/// What is done to replies.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Weather {
    /// So many of a hundred replies are held back.
    pub(crate) late: u64,
    /// For so many milliseconds, from and to.
    pub(crate) by: (u64, u64),
    /// Bytes of one piece, and milliseconds between pieces; 0: in one piece.
    pub(crate) pieces: (usize, u64),
    /// So many of a hundred replies come behind noise.
    pub(crate) noise: u64,
    /// All cells hold the same.
    pub(crate) alike: bool,
    /// Bytes take their time on the line.
    pub(crate) wired: bool,
    /// What must not wait is asked so.
    pub(crate) insists: bool,
}

/// What so many questions cost.
#[derive(Debug, Default)]
pub(crate) struct Cost {
    pub(crate) total: Span,
    /// What the line itself took beyond its smooth time.
    pub(crate) delays: Span,
    pub(crate) unread: u64,
    pub(crate) wrong: u64,
    pub(crate) fences: u64,
    /// Milliseconds by what was waited for.
    pub(crate) waits: BTreeMap<(&'static str, &'static str), (u64, u64)>,
}

struct Rough {
    now: Tick,
    protocol: Protocol,
    line: LineSetting,
    weather: Weather,
    dice: Dice,
    coming: VecDeque<(Tick, Vec<u8>)>,
    count: u16,
    delays: Span,
}

const STATIONS: [u8; 2] = [1, 3];

impl Cost {
    /// Each wait between two telegrams, by what they were.
    fn note(&mut self, began: Tick, ended: Tick, records: Vec<Record>) {
        let name = |verdict: Verdict| match verdict {
            Verdict::Request => "question",
            Verdict::Fence => "fence",
            Verdict::Reply => "reply",
            Verdict::Stray { .. } => "stray",
            Verdict::Garbage => "garbage",
            Verdict::Farewell | Verdict::Echo | Verdict::Copy => "other",
        };
        let (mut then, mut what) = (began, "begin");
        let records = records.into_iter().map(|record| (record.at, name(record.verdict)));
        for (at, next) in records.chain([(ended, "end")]) {
            let wait = self.waits.entry((what, next)).or_default();
            (wait.0, wait.1) = (wait.0 + 1, wait.1 + at.since(then).as_micros());
            (then, what) = (at.max(then), next);
        }
    }
}

impl Rough {
    fn ask(&mut self, master: &mut Master, station: u8, question: Question) -> Result<Answer, ExchangeError> {
        master.ask(station, question, self.now);
        loop {
            match master.step(self.now) {
                Step::Send(bytes) => self.send(&bytes),
                Step::Wait(until) => {
                    let bytes = self.wait(until);
                    if !bytes.is_empty() {
                        master.feed(self.now, &bytes);
                    }
                }
                Step::Done(outcome) => return outcome,
            }
        }
    }

    fn reply(&mut self, bytes: &[u8]) -> Option<Vec<u8>> {
        self.count = self.count.wrapping_add(1);
        let value = |cell: u16| if self.weather.alike { 0 } else { cell.wrapping_mul(3) };
        if self.protocol == Protocol::Vabus {
            let vabus::Request::Enquiry { address, header } = vabus::Request::decode(bytes).ok()? else { return None };
            let data = Data::word(value(header.number.get()));
            return Some(vabus::Reply::Value { address, header, data }.encode());
        }
        let Protocol::Modbus(framing) = self.protocol else { return None };
        let (number, adu) = match framing {
            Framing::Tcp => mbap::decode(bytes).ok()?,
            _ => (0, framing.decode(bytes).ok()?),
        };
        let reply = match Request::decode(&adu.pdu).ok()? {
            Request::ReadRegisters { start, .. } => Reply::Registers(vec![value(start)]),
            Request::ReadLong { address } => Reply::Long(value(address).into()),
            Request::Diagnostics { sub: sub @ (0x0B | 0x0E), .. } => Reply::Diagnostics { sub, data: self.count },
            Request::Diagnostics { sub, .. } => Reply::Diagnostics { sub, data: 0 },
            request => Reply::Exception { function: request.function(), code: Exception::IllegalFunction },
        };
        Some(match framing {
            Framing::Tcp => mbap::encode(number, adu.station, &reply.encode()),
            framing => framing.encode(adu.station, &reply.encode()),
        })
    }

    fn chars(&self, bytes: usize) -> Span {
        if self.protocol == Framing::Tcp.into() { Span::ZERO } else { self.line.chars(bytes as u64) }
    }

    fn send(&mut self, bytes: &[u8]) {
        let Some(mut reply) = self.reply(bytes) else { return };
        let smooth = self.now + self.chars(bytes.len()) + Span::from_micros(10_000 + self.dice.below(2_000));
        let smooth_end = smooth + self.chars(reply.len());
        let mut at = smooth;
        let weather = self.weather;
        if self.dice.below(100) < weather.late {
            at += Span::from_millis(weather.by.0 + self.dice.below(weather.by.1 - weather.by.0 + 1));
        }
        if self.dice.below(100) < weather.noise {
            let count = 5 + self.dice.below(4);
            reply = [self.dice.bytes(count), reply].concat();
        }
        let size = if weather.pieces.0 == 0 { reply.len() } else { weather.pieces.0 };
        for piece in reply.chunks(size) {
            at += self.chars(piece.len());
            let last = self.coming.back().map_or(at, |last| last.0);
            self.coming.push_back((at.max(last), piece.to_vec()));
            at += Span::from_millis(weather.pieces.1);
        }
        let end = self.coming.back().map_or(smooth_end, |last| last.0);
        self.delays = self.delays + end.since(smooth_end);
    }

    fn wait(&mut self, until: Tick) -> Vec<u8> {
        match self.coming.front() {
            Some((at, _)) if *at <= until => {
                self.now = self.now.max(*at);
                self.coming.pop_front().map(|piece| piece.1).unwrap_or_default()
            }
            _ => {
                self.now = self.now.max(until);
                Vec::new()
            }
        }
    }
}

fn question(protocol: Protocol, round: u64) -> (u8, Question) {
    let station = STATIONS[(round / 7 % 2) as usize];
    let number = [372, 376, 411, 241, 228, 259, 11, 210, 434][(round % 9) as usize];
    let question = match protocol {
        Protocol::Vabus => {
            let header = Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
            vabus::Request::Enquiry { address: Address::drive(station).unwrap(), header }.into()
        }
        Protocol::Sdo(_) => sdo::Request::Upload(sdo::Multiplexer { index: number, sub: 0 }).into(),
        Protocol::Pkw => unreachable!("a block of a slave goes over no line of characters"),
        Protocol::Modbus(_) if number == 210 || number == 228 => Request::ReadLong { address: number }.into(),
        Protocol::Modbus(_) => Request::ReadRegisters { start: number, count: 1 }.into(),
    };
    (station, question)
}

/// So many reads in this weather.
pub(crate) fn read(protocol: Protocol, weather: Weather, reads: u64, seed: u64) -> Cost {
    let line = protocol.line(19_200, Parity::Even);
    let limits = Limits { insist: weather.insists.then_some(INSIST), ..Limits::default() };
    let mut master = Master::new(protocol, line, limits);
    master.set_wired(weather.wired);
    STATIONS.iter().for_each(|&station| master.has_counters(station, COUNTERS));
    let (now, dice, coming) = (Tick::ZERO, Dice::new(seed), VecDeque::new());
    let mut rough = Rough { now, protocol, line, weather, dice, coming, count: 0, delays: Span::ZERO };
    let mut cost = Cost::default();
    for round in 0..reads {
        let (station, question) = question(protocol, round);
        let right = right(&question, weather);
        let began = rough.now;
        match rough.ask(&mut master, station, question) {
            Ok(Answer::Reply { said, .. }) if said == right => {}
            Ok(_) => cost.wrong += 1,
            Err(_) => cost.unread += 1,
        }
        cost.note(began, rough.now, master.take_records());
    }
    (cost.total, cost.delays, cost.fences) = (rough.now.since(Tick::ZERO), rough.delays, master.tally().fences);
    cost
}

fn right(question: &Question, weather: Weather) -> Said {
    let value = |cell: u16| if weather.alike { 0 } else { cell.wrapping_mul(3) };
    match question {
        Question::Modbus(Request::ReadLong { address }) => Said::Modbus(Reply::Long(value(*address).into())),
        Question::Modbus(Request::ReadRegisters { start, .. }) => Said::Modbus(Reply::Registers(vec![value(*start)])),
        Question::Vabus(vabus::Request::Enquiry { address, header }) => {
            let data = Data::word(value(header.number.get()));
            Said::Vabus(vabus::Reply::Value { address: *address, header: *header, data })
        }
        other => panic!("{other:?}"),
    }
}

/// What a line costs in this weather, as a ratio to its smooth time and the delays themselves; every value is right.
#[expect(clippy::print_stdout, reason = "the ratios are what benches/waits shows")]
fn ratio(protocol: Protocol, name: &str, weather: Weather) -> f64 {
    let mut worst = 0.0_f64;
    for seed in 1..=3 {
        for wired in [true, false] {
            let undisturbed = read(protocol, Weather { wired, ..Weather::default() }, 200, seed).total;
            let cost = read(protocol, Weather { wired, ..weather }, 200, seed);
            let ratio = cost.total.as_micros() as f64 / (undisturbed + cost.delays).as_micros() as f64;
            assert_eq!((cost.wrong, cost.unread), (0, 0), "{protocol} {name} seed {seed} {weather:?}");
            if ratio > worst {
                worst = ratio;
                let mut waits: Vec<_> = cost.waits.into_iter().collect();
                waits.sort_by_key(|wait| std::cmp::Reverse(wait.1.1));
                let longest = waits.into_iter().take(3);
                let longest =
                    longest.map(|((a, b), (count, micros))| format!("{a}-{b} {count} x {} ms", micros / 1000 / count));
                let longest = longest.collect::<Vec<_>>().join(", ");
                println!("{protocol:>5} {name:26} {ratio:5.2} ({}, {} fences; {longest})", cost.total, cost.fences);
            }
        }
    }
    worst
}

/// One way that a line is rough, and whether all values are alike, and whether what is asked insists.
fn rough(name: &str, weather: Weather) -> Vec<(String, Weather)> {
    let ways = [(false, false), (true, false), (false, true), (true, true)];
    let of = |(alike, insists)| {
        let name = [name, if alike { "alike" } else { "" }, if insists { "insisting" } else { "" }].join(" ");
        (name, Weather { alike, insists, ..weather })
    };
    ways.map(of).into()
}

#[test]
fn late_replies_cost_what_they_are_late_and_little_more() {
    for late in [5, 10, 20] {
        for (name, weather) in rough(&format!("late {late} %"), Weather { late, by: (50, 350), ..Weather::default() }) {
            for protocol in Protocol::ALL {
                let ratio = ratio(protocol, &name, weather);
                assert!(ratio < 1.4, "{protocol} {name}: {ratio:.2}");
            }
        }
    }
}

#[test]
fn replies_in_pieces_cost_their_pauses_and_nothing_more() {
    for size in [1, 2, 5] {
        for (name, weather) in rough(&format!("pieces of {size}"), Weather { pieces: (size, 16), ..Weather::default() })
        {
            // What is alike is doubted for the first two words: a fence and a question each.
            for protocol in Protocol::ALL {
                let ratio = ratio(protocol, &name, weather);
                assert!(ratio < 1.08, "{protocol} {name}: {ratio:.2}");
            }
        }
    }
    let both = Weather { late: 10, by: (50, 350), pieces: (2, 16), ..Weather::default() };
    for (name, weather) in rough("late, in pieces", both) {
        for protocol in Protocol::ALL {
            let ratio = ratio(protocol, &name, weather);
            assert!(ratio < 1.15, "{protocol} {name}: {ratio:.2}");
        }
    }
}

/// Replies later than the time-out are asked for again, and parted from what is asked next.
#[test]
fn replies_behind_their_time_out_cost_little_more_than_they_are_late() {
    for (name, weather) in rough("later than the time-out", Weather { late: 10, by: (200, 900), ..Weather::default() })
    {
        for protocol in Protocol::ALL {
            let ratio = ratio(protocol, &name, weather);
            assert!(ratio < 1.5, "{protocol} {name}: {ratio:.2}");
        }
    }
}

/// Two telegrams may have met where garbage comes: that is found out once, and not before every value again.
#[test]
fn garbage_before_answers_is_settled_once() {
    for noise in [10, 50, 100] {
        for (name, weather) in rough(&format!("noise {noise} %"), Weather { noise, ..Weather::default() }) {
            for protocol in [Framing::Rtu.into(), Framing::Ascii.into(), Protocol::Vabus] {
                let ratio = ratio(protocol, &name, weather);
                assert!(ratio < 2.5, "{protocol} {name}: {ratio:.2}");
            }
        }
    }
}
