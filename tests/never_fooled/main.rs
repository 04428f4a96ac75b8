//! The trial of the late replies: a line on which every fifth reply comes after its time-out, and much else goes wrong.
//! A value that belongs to another question must never be believed. In virtual time, so every run is the same.

#![expect(clippy::unwrap_used, reason = "what a test needs and does not get ends it")]

mod adversary;
mod dice;
mod endless;
mod jitter;
mod line;
mod once;
mod profibus;
mod spoilt;
mod stations;
mod thrown;

use antrieb::exchange::{Answer, Limits, Master, Record, Said, Step, Tally};
use antrieb::profile::Registry;
use antrieb::protocol::Protocol;
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::protocol::modbus::Framing;
use antrieb::protocol::modbus::pdu::{ParamAddress, Reply, Request};
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};

/// Parameters with values that no other one has: number, data set, width, raw value.
const CELLS: [(u16, u8, bool, u32); 8] = [
    (372, 1, false, 1_391),
    (372, 2, false, 1_392),
    (372, 3, false, 1_393),
    (376, 1, false, 11),
    (376, 4, false, 14),
    (481, 1, true, 1_001),
    (481, 2, true, 1_002),
    (480, 3, true, 0x1234_5678),
];

/// A foreign telegram names the next station, which nobody asks.
const STATIONS: [u8; 2] = [1, 3];

/// Every n-th reply suffers this; primes, so that everything meets everything.
const FAULTS: &str = r#"
[[disturb]]
every = 5
kind = "late"
by = "150ms"
[[disturb]]
every = 7
kind = "lost"
[[disturb]]
every = 11
kind = "foreign"
[[disturb]]
every = 13
kind = "echo"
[[disturb]]
every = 17
kind = "doubled"
[[disturb]]
every = 19
kind = "noise"
[[disturb]]
every = 23
kind = "truncated"
[[disturb]]
every = 29
kind = "garbled"
"#;

fn bench(protocol: Framing, faults: &str) -> Bench {
    let mut text = String::from("[line]\nseed = 11\n");
    for address in STATIONS {
        text +=
            &format!("[[drive]]\nmodel = \"act\"\naddress = {address}\nprotocol = \"{}\"\nset = {{ ", protocol.name());
        let cells = CELLS
            .iter()
            .map(|(number, set, _, raw)| format!("\"{number}@{set}\" = \"0x{:X}\"", raw + u32::from(address)));
        text += &cells.collect::<Vec<_>>().join(", ");
        text += " }\n";
    }
    text += faults;
    Bench::from_toml("trial", &text, &Registry::open(&[]).unwrap()).unwrap()
}

/// What came of many reads.
#[derive(Debug, Default)]
struct Count {
    right: u64,
    wrong: u64,
    unread: u64,
}

struct Trial {
    bench: Bench,
    line: LineSetting,
    now: Tick,
}

impl Trial {
    fn new(framing: Framing, faults: &str) -> Self {
        let line = Protocol::from(framing).line(19_200, Parity::Even);
        Trial { bench: bench(framing, faults), line, now: Tick::ZERO }
    }

    fn master(&self, framing: Framing, limits: Limits) -> Master {
        let mut master = Master::new(framing.into(), self.line, limits);
        master.set_wired(true);
        master
    }

    /// Waits on the bench; what comes, comes at once.
    fn wait(&mut self, until: Tick) -> Vec<u8> {
        while self.now < until {
            self.now = self.bench.next_event().map_or(until, |event| event.min(until)).max(self.now);
            let bytes = self.bench.advance(self.now);
            if !bytes.is_empty() {
                return bytes.into_iter().map(|(_, byte)| byte).collect();
            }
        }
        Vec::new()
    }

    fn read(&mut self, master: &mut Master, station: u8, request: Request) -> Option<Reply> {
        master.ask(station, request, self.now);
        loop {
            match master.step(self.now) {
                Step::Send(bytes) => self.bench.master_sends(self.now, self.line, &bytes),
                Step::Wait(until) => {
                    let bytes = self.wait(until);
                    if !bytes.is_empty() {
                        master.feed(self.now, &bytes);
                    }
                }
                Step::Done(Ok(Answer::Reply { said: Said::Modbus(reply), .. })) => return Some(reply),
                Step::Done(_) => return None,
            }
        }
    }
}

/// A question with the reply that is the only right one.
fn question(round: u64) -> (u8, Request, Reply) {
    let station = STATIONS[(round / 3 % 2) as usize];
    let (number, set, long, raw) = CELLS[(round * 5 % 8) as usize];
    let address = ParamAddress::new(set, number).unwrap().word();
    let raw = raw + u32::from(station);
    match long {
        true => (station, Request::ReadLong { address }, Reply::Long(raw)),
        false => (station, Request::ReadRegisters { start: address, count: 1 }, Reply::Registers(vec![raw as u16])),
    }
}

fn judge(count: &mut Count, reply: Option<Reply>, right: &Reply) {
    match reply {
        Some(reply) if reply == *right => count.right += 1,
        Some(Reply::Exception { .. }) | None => count.unread += 1,
        Some(_) => count.wrong += 1,
    }
}

fn ours(framing: Framing, rounds: u64) -> (Count, Tally, f64) {
    let mut trial = Trial::new(framing, FAULTS);
    let limits = Limits { reply_timeout: Span::from_millis(100), ..Limits::default() };
    let mut master = trial.master(framing, limits);
    let mut count = Count::default();
    for round in 0..rounds {
        let (station, request, right) = question(round);
        let reply = trial.read(&mut master, station, request);
        judge(&mut count, reply, &right);
        master.take_records();
    }
    let seconds = trial.now.as_micros() as f64 / 1e6;
    (count, master.tally(), rounds as f64 / seconds)
}

#[test]
fn ten_thousand_disturbed_reads_believe_no_wrong_value() {
    for (framing, rounds) in [(Framing::Rtu, 10_000), (Framing::Ascii, 2_000)] {
        let (count, tally, rate) = ours(framing, rounds);
        println!("{}: {count:?}, {rate:.1} reads a second, {tally:?}", framing.name());
        assert_eq!(count.wrong, 0, "{count:?} {tally:?}");
        // Half of all replies suffer; three tries bring more than nine of ten values all the same.
        assert!(count.right > rounds * 9 / 10, "{count:?} {tally:?}");
        assert!([tally.fences, tally.strays, tally.echoes].iter().all(|&count| count > rounds / 20), "{tally:?}");
    }
}

/// A repeater, a radio link: every n-th reply comes once more, up to half a second later. Every row is a session of its own.
#[test]
fn doubled_replies_believe_no_wrong_value() {
    let mut all = Count::default();
    for every in 1..=7 {
        for by in [0, 2, 5, 9, 14, 17, 23, 38, 50, 55, 77, 100, 120, 150, 200, 333, 500] {
            let faults = format!("[[disturb]]\nevery = {every}\nkind = \"doubled\"\nby = \"{by}ms\"\n");
            let mut trial = Trial::new(Framing::Rtu, &faults);
            let mut master = trial.master(Framing::Rtu, Limits::default());
            let mut count = Count::default();
            for round in 0..48 {
                let (station, request, right) = question(round);
                let reply = trial.read(&mut master, station, request);
                judge(&mut count, reply, &right);
            }
            let seconds = trial.now.as_micros() as f64 / 1e6;
            if count.wrong + count.unread > 0 || seconds > 4.0 {
                println!("every {every} by {by} ms: {count:?}, {seconds:.1} s, {:?}", master.tally());
            }
            all.wrong += count.wrong;
            all.right += count.right;
            all.unread += count.unread;
        }
    }
    println!("doubled: {all:?}");
    assert_eq!(all.wrong, 0, "{all:?}");
    assert!(all.unread * 50 < all.right, "{all:?}");
}

/// Reads of the long form: `ANTRIEB_TRIAL=1000000 cargo test --release --test never_fooled dice -- --nocapture`, others with another
/// ANTRIEB_TRIAL_SEED; `benches/reliability` takes one such share after the other. One
/// protocol and manner: `ANTRIEB_TRIAL_OF="rtu/twins"`; one session of it, with all its telegrams: `rtu/twins/7000045`.
#[expect(clippy::disallowed_methods, reason = "a variable is how a test is told to take its time")]
fn told(name: &str) -> Option<String> {
    std::env::var(name).ok()
}

/// Whatever the dice throw: late by up to 6 s, doubled, twins, lost, foreign, echoed, noisy, torn, flipped, left in the
/// driver, another master; in every protocol.
#[test]
fn the_dice_bring_no_wrong_value() {
    let manners = &thrown::MANNERS;
    let reads = told("ANTRIEB_TRIAL").and_then(|text| text.parse().ok()).unwrap_or(5_000_u64);
    let from = told("ANTRIEB_TRIAL_SEED").and_then(|text| text.parse().ok()).unwrap_or(7);
    let only = told("ANTRIEB_TRIAL_OF").unwrap_or_default();
    let seed = only.split('/').nth(2).and_then(|seed| seed.parse().ok());
    let share = reads / (manners.len() as u64 * 4);
    let (mut found, mut total) = (Vec::new(), thrown::Score::default());
    for protocol in Protocol::ALL {
        let is_meant = |manner: &&thrown::Manner| {
            let mut parts = only.split('/');
            [&protocol.to_string(), manner.name]
                .iter()
                .all(|name| parts.next().is_none_or(|part| part.is_empty() || part == *name))
        };
        for manner in manners.iter().filter(is_meant) {
            let score = match seed {
                Some(seed) => thrown::replay(protocol, manner, seed),
                None => thrown::play(protocol, manner, share, from),
            };
            total.add(&score);
            for Record { at, verdict, bytes } in &score.telegrams {
                println!("{:>12} {verdict:?} {bytes:02X?}", at.as_micros());
            }
            let thrown::Score { right, wrong, unread, twin, chance, seconds, named, .. } = score;
            println!(
                "{protocol:>6} {:30} right {right}, wrong {wrong}, unread {unread} ({named} named), of the twin {twin}, chance {chance}, {seconds} s",
                manner.name
            );
            let all = right + wrong + unread + twin + chance;
            assert!(manner.name != "clean" || right == all, "{protocol}: every read of a clean line is right");
            if !only.is_empty() {
                score.found.iter().for_each(|found| println!("{found}"));
            }
            let most = (manner.most * all).div_ceil(10_000);
            // And what chance adds to a few.
            if wrong > most + 3 * most.saturating_sub(1).isqrt() {
                found.extend(score.found);
            }
        }
    }
    let thrown::Score { right, wrong, unread, twin, chance, seconds, .. } = total;
    println!(
        "total: {{\"right\": {right}, \"wrong\": {wrong}, \"unread\": {unread}, \"twin\": {twin}, \"chance\": {chance}, \"seconds\": {seconds}}}"
    );
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// A gateway that hands replies on in another order: so many reads that a master which trusts in the order of what comes behind a fence
/// believes wrong ones.
#[test]
fn replies_that_overtake_each_other_bring_no_wrong_value() {
    for framing in [Framing::Rtu, Framing::Ascii] {
        for manner in thrown::MANNERS.iter().filter(|manner| manner.name.starts_with("overtaking")) {
            let score = thrown::play(framing.into(), manner, 5_000, 7);
            assert_eq!((score.wrong, score.chance), (0, 0), "{}", score.found.join("\n"));
            assert!(score.right > 3_500, "{}: {score:?}", manner.name);
        }
    }
}

/// The same trial with a master that does what most do: take the next telegram with the right address, code and check
/// value. If this one believed nothing wrong, the trial would prove nothing.
#[test]
fn a_master_without_fences_is_fooled_by_the_same_trial() {
    let mut trial = Trial::new(Framing::Rtu, FAULTS);
    let mut count = Count::default();
    for round in 0..600 {
        let (station, request, right) = question(round);
        let sent = Framing::Rtu.encode(station, &request.encode());
        trial.now += trial.line.t35();
        trial.bench.master_sends(trial.now, trial.line, &sent);
        let deadline = trial.now + trial.line.chars(sent.len() as u64) + Span::from_millis(100);
        let mut came = Vec::new();
        let reply = loop {
            came.extend(trial.wait(deadline));
            if let Ok(adu) = Framing::Rtu.decode(&came) {
                break Reply::decode(&adu.pdu)
                    .ok()
                    .filter(|reply| request.is_answered_by(reply) && adu.station == station);
            }
            if trial.now >= deadline {
                break None;
            }
        };
        judge(&mut count, reply, &right);
    }
    println!("without fences: {count:?}");
    assert!(count.wrong > 5, "{count:?}");
}
