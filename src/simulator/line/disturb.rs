//! Faults of the line, by script: what happens to a reply on its way to the master.

use super::babble::{Babbler, Said, other_value};
use super::speech::Spoken;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::LAST_STATION;
use crate::protocol::vabus::{Address, Reply};
use crate::simulator::dice::Dice;
use crate::tick::{Span, Tick};

/// What is done to a reply.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// It comes later than the drive sent it.
    Late(Span),
    /// It does not come.
    Lost,
    /// One bit of one byte is flipped.
    Garbled,
    /// Its last third does not come.
    Truncated,
    /// A byte comes right before it.
    Noise(u8),
    /// The master hears its own request, so much later: concerns the request, not the reply.
    Echo(Span),
    /// It comes twice, the second time so long after the end of the first.
    Doubled(Option<Span>),
    /// A reply of the next station comes in its place.
    Foreign,
    /// A Modbus exception comes in its place: what was asked is done, or not, but the answer says no. Over VABus nothing.
    Exception(u8),
    /// A second drive at the address answers too, with other values, so long after the end of the first.
    Twin(Span),
    /// The device server between ends the connection, and the reply goes nowhere. It takes a new one at once.
    HangsUp(Parting),
    /// Behind this reply the master's port takes no bytes for so long.
    Stuck(Span),
}

/// How a connection over a network ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parting {
    /// In order (FIN).
    Closed,
    /// At once (RST).
    Reset,
}

/// Which reply is hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum When {
    /// Every n-th one.
    Every(u64),
    /// Only the n-th one.
    Once(u64),
    /// The first one from this time on.
    From(Tick),
}

/// One line of the script.
#[derive(Clone, Debug)]
pub(crate) struct Rule {
    pub(crate) when: When,
    pub(crate) kind: Kind,
    /// Only replies of this station; `None` for all.
    pub(crate) station: Option<u8>,
    seen: u64,
    done: bool,
}

impl Rule {
    pub(crate) fn new(when: When, kind: Kind, station: Option<u8>) -> Self {
        Rule { when, kind, station, seen: 0, done: false }
    }

    fn strikes(&mut self, now: Tick, station: u8) -> bool {
        if self.station.is_some_and(|only| only != station) {
            return false;
        }
        self.seen = self.seen.saturating_add(1);
        match self.when {
            When::Every(n) => n > 0 && self.seen.is_multiple_of(n),
            When::Once(n) => self.seen == n,
            When::From(at) => now >= at && !std::mem::replace(&mut self.done, true),
        }
    }
}

/// A reply as a drive sends it.
#[derive(Clone, Debug)]
pub(crate) struct Outgoing {
    pub(crate) station: u8,
    pub(crate) spoken: Spoken,
    pub(crate) line: LineSetting,
    pub(crate) frame: Vec<u8>,
}

/// The script and its chance.
#[derive(Clone, Debug)]
pub(crate) struct Disturber {
    rules: Vec<Rule>,
    /// An adapter that always hears itself.
    echo: bool,
    /// Who speaks on the line unasked.
    pub(crate) babblers: Vec<Babbler>,
    dice: Dice,
    /// The connection was ended, which nobody was told yet.
    hung_up: Option<Parting>,
    /// The master's port takes no bytes until then.
    stuck_until: Tick,
}

impl Disturber {
    pub(crate) fn new(rules: Vec<Rule>, echo: bool, seed: u64) -> Self {
        Disturber { rules, echo, babblers: Vec::new(), dice: Dice::new(seed), hung_up: None, stuck_until: Tick::ZERO }
    }

    /// Whether the connection was ended since this was asked last, and how.
    pub(crate) fn hangs_up(&mut self) -> Option<Parting> {
        self.hung_up.take()
    }

    /// Until when the master's port takes no bytes, if it was stuck once.
    pub(crate) fn stuck_until(&self) -> Tick {
        self.stuck_until
    }

    /// When somebody speaks next unasked.
    pub(crate) fn next_babble(&self) -> Option<Tick> {
        self.babblers.iter().filter_map(Babbler::next).min()
    }

    /// What somebody says now unasked.
    pub(crate) fn babble(&mut self, now: Tick, line: LineSetting) -> Option<Said> {
        let dice = &mut self.dice;
        self.babblers.iter_mut().find(|babbler| babbler.next().is_some_and(|next| next <= now))?.speak(now, line, dice)
    }

    /// Whether the master hears the telegram that it sends now, and how much later.
    pub(crate) fn echoes(&mut self, now: Tick, station: u8) -> Option<Span> {
        let mut echo = self.echo.then_some(Span::ZERO);
        for rule in &mut self.rules {
            // Every rule counts every telegram, also when another has struck already.
            if let Kind::Echo(by) = rule.kind
                && rule.strikes(now, station)
            {
                echo = echo.max(Some(by));
            }
        }
        echo
    }

    /// What comes of a reply that starts now: telegrams with the time at which they start.
    pub(crate) fn pass(&mut self, now: Tick, reply: &Outgoing) -> Vec<(Tick, Vec<u8>)> {
        let mut out = vec![(now, reply.frame.clone())];
        for rule in self.rules.iter_mut().filter(|rule| !matches!(rule.kind, Kind::Echo(_))) {
            if !rule.strikes(now, reply.station) {
                continue;
            }
            match rule.kind {
                Kind::Late(by) => out.iter_mut().for_each(|(at, _)| *at += by),
                Kind::Lost => out.clear(),
                Kind::Garbled => out.iter_mut().for_each(|(_, frame)| flip(frame, &mut self.dice)),
                Kind::Truncated => {
                    out.iter_mut().for_each(|(_, frame)| frame.truncate(frame.len() - frame.len().div_ceil(3)));
                }
                Kind::Noise(byte) => out.iter_mut().for_each(|(_, frame)| frame.insert(0, byte)),
                Kind::Doubled(by) => {
                    let pause = by.unwrap_or(reply.line.t35() + reply.line.chars(1));
                    let again: Vec<_> = out
                        .iter()
                        .map(|(at, frame)| (*at + reply.line.chars(frame.len() as u64) + pause, frame.clone()))
                        .collect();
                    out.extend(again);
                }
                Kind::Twin(pause) => {
                    let twin = |(at, frame): &(Tick, Vec<u8>)| {
                        let end = *at + reply.line.chars(frame.len() as u64);
                        (end + pause, other_value(reply.spoken, frame))
                    };
                    let twins: Vec<_> = out.iter().map(twin).collect();
                    out.extend(twins);
                }
                Kind::Foreign => replace(&mut out, |frame| foreign(reply.spoken, frame)),
                Kind::Exception(code) => replace(&mut out, |frame| exception(reply.spoken, frame, code)),
                Kind::HangsUp(parting) => {
                    out.clear();
                    self.hung_up = Some(parting);
                }
                Kind::Stuck(span) => self.stuck_until = now + span,
                Kind::Echo(_) => {}
            }
        }
        out
    }
}

/// Puts something else in the place of the telegrams that have something else.
fn replace(out: &mut [(Tick, Vec<u8>)], other: impl Fn(&[u8]) -> Option<Vec<u8>>) {
    for (_, frame) in out {
        if let Some(other) = other(frame) {
            *frame = other;
        }
    }
}

/// A no in its place (V1.1b3 7); `None` where the protocol has none.
fn exception(spoken: Spoken, frame: &[u8], code: u8) -> Option<Vec<u8>> {
    let Spoken::Modbus(framing) = spoken else { return None };
    let adu = framing.decode(frame).ok()?;
    Some(framing.encode(adu.station, &[adu.pdu.first()? | 0x80, code]))
}

/// The same reply from the next station; `None` if it is none any more.
fn foreign(spoken: Spoken, frame: &[u8]) -> Option<Vec<u8>> {
    match spoken {
        Spoken::Modbus(framing) => {
            let adu = framing.decode(frame).ok()?;
            Some(framing.encode(adu.station % LAST_STATION + 1, &adu.pdu))
        }
        Spoken::Vabus => {
            let next = Address::drive(Reply::decode(frame).ok()?.address().id() % Address::LAST + 1)?;
            let (_, text) = frame.split_first()?;
            Some([&[next.character()], text].concat())
        }
        Spoken::PBus => None,
    }
}

fn flip(frame: &mut [u8], dice: &mut Dice) {
    let (place, bit) = (dice.below(frame.len() as u64), dice.below(7));
    if let Some(byte) = usize::try_from(place).ok().and_then(|place| frame.get_mut(place)) {
        *byte ^= 1 << bit;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;
    use crate::protocol::modbus::Framing;

    fn pass(rules: Vec<Rule>, replies: usize) -> Vec<Vec<(Tick, Vec<u8>)>> {
        let mut disturber = Disturber::new(rules, false, 1);
        let line = LineSetting::rtu(19_200, Parity::Even);
        let frame = Framing::Rtu.encode(1, &[3, 2, 5, 0x6E]);
        let reply = Outgoing { station: 1, spoken: Spoken::RTU, line, frame };
        (0..replies).map(|_| disturber.pass(Tick::ZERO, &reply)).collect()
    }

    #[test]
    fn every_third_reply_is_lost() {
        let passed = pass(vec![Rule::new(When::Every(3), Kind::Lost, None)], 6);
        assert_eq!(passed.iter().map(Vec::len).collect::<Vec<_>>(), [1, 1, 0, 1, 1, 0]);
    }

    #[test]
    fn what_comes_of_a_reply() {
        let once = |kind| pass(vec![Rule::new(When::Once(1), kind, None)], 1).remove(0);
        assert_eq!(once(Kind::Late(Span::from_millis(150)))[0].0, Tick::from_micros(150_000));
        assert_eq!(once(Kind::Truncated)[0].1, [1, 3, 2, 5]);
        assert_eq!(once(Kind::Noise(0))[0].1[..3], [0, 1, 3]);
        assert_eq!(once(Kind::Doubled(None)).len(), 2);
        let later = once(Kind::Doubled(Some(Span::from_millis(30))))[1].0;
        assert_eq!(later.since(Tick::ZERO), Span::from_millis(30) + LineSetting::rtu(19_200, Parity::Even).chars(7));
        assert_eq!(Framing::Rtu.decode(&once(Kind::Foreign)[0].1).unwrap().station, 2);
        assert!(Framing::Rtu.decode(&once(Kind::Garbled)[0].1).is_err());
        let other = Rule::new(When::Every(1), Kind::Lost, Some(2));
        assert_eq!(pass(vec![other], 1)[0].len(), 1);
    }
}
