//! The trial with dice: many short sessions, each on a line with hazards of its own.

use super::dice::Dice;
use super::line::{Hazards, HostileLine};
use super::stations::{Asked, STATIONS};
use antrieb::exchange::{Answer, ExchangeError, Limits, Master, Record, Said, Step};
use antrieb::protocol::Protocol;
use antrieb::protocol::line::Parity;
use antrieb::protocol::modbus::Framing;
use antrieb::protocol::modbus::pdu::Reply;
use antrieb::protocol::vabus;
use antrieb::tick::{Span, Tick};

/// Questions of one session.
const SESSION: u64 = 50;

/// What came of many reads.
#[derive(Debug, Default)]
pub(crate) struct Score {
    pub(crate) right: u64,
    /// A value that is none of the place that was asked, in a telegram that somebody sent whole.
    pub(crate) wrong: u64,
    pub(crate) unread: u64,
    /// Of two drives at one address, the value of the second.
    pub(crate) twin: u64,
    /// Nobody ever sent this telegram: a spoilt one whose check value happens to be right.
    pub(crate) chance: u64,
    /// Seconds that all of it took.
    pub(crate) seconds: u64,
    /// Two drives at the address were named.
    pub(crate) named: u64,
    /// The telegrams of a session that is played again.
    pub(crate) telegrams: Vec<Record>,
    replays: bool,
    /// Seed and question of the first wrong values.
    pub(crate) found: Vec<String>,
}

impl Score {
    /// What another trial came to as well.
    pub(crate) fn add(&mut self, other: &Score) {
        self.right += other.right;
        self.wrong += other.wrong;
        self.unread += other.unread;
        self.twin += other.twin;
        self.chance += other.chance;
        self.seconds += other.seconds;
    }
}

/// One way to set up the line.
pub(crate) struct Manner {
    pub(crate) name: &'static str,
    pub(crate) set: fn(&mut Hazards, &mut Dice),
    /// What comes in a pause is read before the next question, as the program does; or stays in the driver.
    pub(crate) drained: bool,
    /// Wires, or a gateway that hands bytes on as it likes.
    pub(crate) wired: bool,
    /// So many of ten thousand values may be wrong: where two speak with one voice and the sign of it is lost, late or spoilt
    /// before the first value is, nobody can tell. A serial reply names neither its question nor who gave it, and every other
    /// sign of a second drive is one that a single drive behind a bad line gives as well.
    pub(crate) most: u64,
}

pub(crate) const MANNERS: [Manner; 14] = [
    Manner { name: "clean", set: |hazards, _| *hazards = Hazards::default(), drained: true, wired: true, most: 0 },
    Manner {
        name: "slow",
        set: |hazards, dice| *hazards = Hazards { late: 2 + dice.below(20), ..Hazards::default() },
        drained: true,
        wired: true,
        most: 0,
    },
    Manner {
        name: "lossy",
        set: |hazards, dice| *hazards = Hazards { lost: 2 + dice.below(20), ..Hazards::default() },
        drained: true,
        wired: true,
        most: 0,
    },
    Manner { name: "faults", set: |_, _| {}, drained: true, wired: true, most: 0 },
    Manner {
        name: "undrained",
        set: |hazards, dice| hazards.pause = 1 + dice.below(5),
        drained: false,
        wired: true,
        most: 0,
    },
    Manner {
        name: "gateway",
        set: |hazards, dice| hazards.pause = 1 + dice.below(9),
        drained: true,
        wired: false,
        most: 0,
    },
    Manner {
        name: "overtaking",
        set: |hazards, dice| *hazards = Hazards { overtaken: 2 + dice.below(8), ..Hazards::default() },
        drained: true,
        wired: false,
        most: 0,
    },
    Manner {
        name: "overtaking, lost",
        set: |hazards, dice| {
            let (overtaken, lost, pause) = (2 + dice.below(8), 2 + dice.below(20), dice.pick(&[0, 1, 5]));
            *hazards = Hazards { overtaken, lost, pause, ..Hazards::default() };
        },
        drained: true,
        wired: false,
        most: 0,
    },
    Manner {
        name: "twins alone",
        set: |hazards, _| *hazards = Hazards { twins: true, ..Hazards::default() },
        drained: true,
        wired: true,
        most: 1,
    },
    Manner {
        name: "twins, late",
        set: |hazards, dice| *hazards = Hazards { twins: true, late: 2 + dice.below(20), ..Hazards::default() },
        drained: true,
        wired: true,
        most: 10,
    },
    Manner {
        name: "another master alone",
        set: |hazards, dice| {
            let master = Some(dice.pick(&[12, 25, 60, 200]));
            *hazards = Hazards { master, shared: true, ..Hazards::default() };
        },
        drained: true,
        wired: true,
        most: 0,
    },
    Manner { name: "twins", set: |hazards, _| hazards.twins = true, drained: true, wired: true, most: 8 },
    Manner {
        name: "another master",
        set: |hazards, dice| hazards.master = Some(dice.pick(&[12, 25, 60, 200])),
        drained: true,
        wired: true,
        most: 0,
    },
    Manner {
        name: "another master, same stations",
        set: |hazards, dice| (hazards.master, hazards.shared) = (Some(dice.pick(&[12, 25, 60, 200])), true),
        drained: true,
        wired: true,
        most: 0,
    },
];

/// One session once more, with its telegrams.
pub(crate) fn replay(protocol: Protocol, manner: &Manner, seed: u64) -> Score {
    let mut score = Score { replays: true, ..Score::default() };
    play_session(protocol, manner, seed, &mut score);
    score
}

/// So many reads of one protocol in one manner.
pub(crate) fn play(protocol: Protocol, manner: &Manner, reads: u64, seed: u64) -> Score {
    let mut score = Score::default();
    for session in 0..reads.div_ceil(SESSION) {
        play_session(protocol, manner, seed.wrapping_mul(1_000_003).wrapping_add(session), &mut score);
    }
    score
}

pub(crate) fn play_session(protocol: Protocol, manner: &Manner, seed: u64, score: &mut Score) {
    let mut dice = Dice::new(seed);
    let setting = protocol.line(dice.pick(&[9_600, 19_200, 115_200]), Parity::Even);
    let mut hazards = Hazards::thrown(&mut dice);
    (manner.set)(&mut hazards, &mut dice);
    let is_tcp = protocol == Protocol::Modbus(Framing::Tcp);
    if is_tcp {
        // TCP has a check of its own; what comes is whole.
        (hazards.flipped, hazards.torn, hazards.noise, hazards.echo) = (0, 0, 0, 0);
    }
    let limits = Limits {
        reply_timeout: Span::from_millis(dice.pick(&[100, 500])),
        retries: dice.below(4) as u8,
        ..Limits::default()
    };
    let mut master = Master::new(protocol, setting, limits);
    master.set_wired(manner.wired && !is_tcp);
    let mut line = HostileLine::new(protocol, setting, hazards, dice);
    for asked in STATIONS.map(|station| line.introduction(station)).into_iter().flatten() {
        ask(&mut master, &mut line, &asked, score);
    }
    let mut paused = Span::ZERO;
    for round in 0..SESSION {
        let before = line.now;
        line.pause();
        if manner.drained {
            let bytes = line.waiting();
            if !bytes.is_empty() {
                master.feed(line.now, &bytes);
            }
        }
        paused = paused + line.now.since(before);
        let asked = line.question();
        let said = ask(&mut master, &mut line, &asked, score);
        judge(score, &line, &asked, said, || {
            format!("{protocol} {} seed {seed} read {round} {hazards:?}", manner.name)
        });
        score.telegrams.extend(master.take_records().into_iter().filter(|_| score.replays));
    }
    score.seconds += (line.now.since(Tick::ZERO).as_micros() - paused.as_micros()) / 1_000_000;
}

fn ask(master: &mut Master, line: &mut HostileLine, asked: &Asked, score: &mut Score) -> Option<Said> {
    let by = line.now + master.limits().longest(master.protocol(), master.line());
    master.ask(asked.station, asked.question.clone(), line.now);
    loop {
        match master.step(line.now) {
            Step::Send(bytes) => line.send(&bytes),
            Step::Wait(until) => {
                let bytes = line.wait(until);
                if !bytes.is_empty() {
                    master.feed(line.now, &bytes);
                }
            }
            Step::Done(outcome) => {
                assert!(line.now <= by, "{:?} late: {asked:?} {outcome:?}", line.now.since(by));
                score.named += u64::from(matches!(outcome, Err(ExchangeError::TwoAnswers { .. })));
                return match outcome {
                    Ok(Answer::Reply { said, .. }) => Some(said),
                    _ => None,
                };
            }
        }
    }
}

fn judge(score: &mut Score, line: &HostileLine, asked: &Asked, said: Option<Said>, place: impl Fn() -> String) {
    match said {
        None | Some(Said::Modbus(Reply::Exception { .. }) | Said::Vabus(vabus::Reply::Nak { .. })) => {
            score.unread += 1;
        }
        Some(said) if said == asked.right => score.right += 1,
        Some(said) if line.hazards.twins && said == asked.twin => score.twin += 1,
        Some(said) if line.is_numbered() || line.was_told(&line.telegram(asked.station, &said)) => {
            score.wrong += 1;
            if score.found.len() < 20 {
                score.found.push(format!("{}: {:?} gave {said:?}, not {:?}", place(), asked.question, asked.right));
            }
        }
        Some(_) => score.chance += 1,
    }
}
