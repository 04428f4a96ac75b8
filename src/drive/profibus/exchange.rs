//! A slave that exchanges data with us: it is taken, asked over the PKW channel, and let go again (`ending`).
//!
//! Whoever exchanges data with an SJ2-PB sends it a control word. That is 047E in every cycle, or 0050 in Basic mode, as long as nothing
//! else was agreed to: control kept, no start. Zero outputs would be no stop (a word without bit 10 may hand the motor to the terminals,
//! or freeze the last word; in Basic mode they hand it to the terminals). Where we die, the watchdog of the slave lets it go.

use super::beside::{Beside, saying};
use super::line::Line;
use super::mode::{Mode, Seen, Words};
use super::shown::Shown;
use super::still::Still;
use super::trouble;
use crate::drive::{Panel, Stays};
use crate::exchange::dp::{Cycle, Place, Request, Setup, Station, Told, Trouble, Unanswered};
use crate::failure::{Class, Failure};
use crate::gate::{Motion, Permit};
use crate::outcome::Event;
use crate::protocol::dp::pkw::Pkw;
use crate::text::Text;
use crate::tick::{Span, Tick};
use std::pin::pin;

/// A parameter that was changed for the time of the exchange.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lent {
    pub(super) place: Place,
    pub(super) old: u16,
    pub(super) new: u16,
    pub(super) restored: bool,
    /// It stays as it is, because giving it back would start the motor.
    pub(super) stays: bool,
}

/// Right to control (5.1), and what a lost connection does in both modes (5.2, 5.3).
pub(super) const RIGHT: u16 = 928;
pub(super) const LOST: u16 = 703;
/// P.703: whoever loses its master leaves the motor to terminals and keypad (5.2).
pub(super) const TO_TERMINALS: u32 = 4;
/// The slave lets go of us behind this, where nothing else was asked for.
pub const WATCHDOG: Span = Span::from_secs(2);
/// One step of the watchdog (IEC 61158-6-3).
const STEP_MS: u64 = 10;
/// So often a slave may leave Data_Exchange by itself.
const MOST_LEFT: u32 = 5;
/// So much longer than its watchdog nothing may be heard of a slave that was heard: behind it, it is led to Data_Exchange anew.
const BEYOND: Span = Span::from_secs(3);

/// How a slave is taken.
#[derive(Clone, Debug)]
pub struct Taking {
    /// How it is led.
    pub mode: Mode,
    /// User parameters of Set_Prm.
    pub user: Vec<u8>,
    /// It lets go of us behind this.
    pub watchdog: Span,
    /// The ident number of its GSD, where one was given.
    pub ident: Option<u16>,
}

/// A slave that exchanges data.
pub struct Exchange<'l, 'a> {
    pub(super) line: &'l mut Line<'a>,
    address: u8,
    mode: Mode,
    pub(super) station: Station,
    left: u32,
    pub(super) words: Words,
    pub(super) pkw: Pkw,
    /// What came last.
    pub(super) seen: Option<Seen>,
    /// The further words that came with it, and what is mapped to them.
    pub(super) more: Vec<u16>,
    pub(super) mapped: Vec<u16>,
    pub(super) still: Still,
    heard: Tick,
    /// Nothing has come since what came last: that may be so no more.
    pub(super) is_lost: bool,
    /// So long nothing may be heard of it.
    unheard: Span,
    /// Nor before this moment is it given up: its end has begun.
    pub(super) at_least: Tick,
    /// From here on the words are those of the stop: the time of the run is over.
    pub(super) ends: Option<Tick>,
    /// So long from the word that starts the motor on, or from the last sight of a motor that does not turn yet.
    pub(super) lasts: Option<Span>,
    /// A start word went out.
    pub(super) started: bool,
    /// The motor turned, and no start word of ours had gone out.
    pub(super) driven: bool,
    /// A start word went out, or the motor is to be stopped: whoever interrupts wants it to stop sooner.
    pub(super) ours: bool,
    /// The run came to its own end: who interrupts for the first time asks for the stop that is under way.
    pub(super) own_end: bool,
    /// Somebody interrupted that end.
    pub(super) hastened: bool,
    /// The end is on its way: no interrupt and no short silence keeps it from going out.
    pub(super) insists: bool,
    /// Whoever watches is told of every silence.
    pub(super) watches: bool,
    pub(super) lent: Vec<Lent>,
    /// What is to be known of its end besides.
    pub(super) notes: Vec<Text>,
    /// What the slave does with the motor if it loses us: P.703 as it stands, where it was told.
    pub(super) behind: Option<u32>,
    /// What decides on the motor without us, as it was found, and with P.703 as a run lends it.
    pub(super) parting: Option<[Text; 2]>,
    /// What went out beside another master.
    pub(super) beside: Beside,
    /// What is shown of a run, if this is one.
    pub(super) shown: Option<Shown>,
    /// Who goes on looking at it behind its end, and for how long; whatever went wrong with it.
    pub(super) stays: Option<(Panel, Stays, Option<Text>)>,
}

impl std::fmt::Debug for Exchange<'_, '_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Exchange").field("station", &self.station).finish_non_exhaustive()
    }
}

impl<'l, 'a> Exchange<'l, 'a> {
    /// Takes the slave. It must be left by [`Exchange::leave`], however the work ends.
    pub fn new(line: &'l mut Line<'a>, address: u8, taking: Taking, _permit: &Permit<Motion>) -> Self {
        let Taking { mode, user, watchdog, ident } = taking;
        let layout = mode.layout();
        let setup = Setup { watchdog: factors(watchdog), user, cfg: layout.bytes().to_vec(), ident };
        let now = line.now();
        let station = Station::new(address, setup, vec![0; layout.length()], now);
        Exchange {
            line,
            address,
            mode,
            station,
            left: 0,
            words: mode.stop(),
            pkw: Pkw::default(),
            seen: None,
            more: Vec::new(),
            mapped: Vec::new(),
            still: Still::new(mode.slow()),
            heard: now,
            is_lost: false,
            unheard: watchdog + BEYOND,
            at_least: now,
            ends: None,
            lasts: None,
            started: false,
            driven: false,
            ours: false,
            own_end: false,
            hastened: false,
            insists: false,
            watches: false,
            lent: Vec::new(),
            notes: Vec::new(),
            behind: None,
            parting: None,
            beside: Beside::default(),
            shown: None,
            stays: None,
        }
    }

    /// Address of the slave.
    pub fn address(&self) -> u8 {
        self.address
    }

    /// The ident number that it told, once it was asked.
    pub fn ident(&self) -> Option<u16> {
        self.station.ident()
    }

    /// How it is led.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// Tells whoever watches.
    pub fn tell(&mut self, event: Event) {
        self.line.tell(event);
    }

    /// What came last; `None` before the first exchange.
    pub fn seen(&self) -> Option<Seen> {
        self.seen
    }

    /// One exchange on the line.
    pub(super) async fn cycle(&mut self) -> Result<Cycle, Failure> {
        loop {
            let done = self.once().await;
            match &done {
                Ok(_) => self.is_lost = false,
                Err(failure) => self.is_lost |= failure.class != Class::Interrupted,
            }
            match done {
                Err(failure) if self.bears(&failure) => {}
                done => return done,
            }
        }
    }

    /// Whether the time of the run is over.
    pub(super) fn is_over(&self) -> bool {
        self.ends.is_some_and(|end| end <= self.line.now())
    }

    async fn once(&mut self) -> Result<Cycle, Failure> {
        let waits = self.station.waits();
        self.line.rest(waits).await?;
        if self.is_over() {
            self.words = self.mode.stop();
        }
        let outputs = self.mode.outputs(self.pkw, self.words);
        self.station.outputs().copy_from_slice(&outputs);
        let (station, asked) = self.station.question();
        let said =
            self.line.fdl.beside().map(|_| {
                (saying(&asked, (self.words.stw, self.pkw), self.station.is_leaving()), self.line.tally().sent)
            });
        let reply = self.line.ask(station, asked, None).await;
        if let Some((said, _)) = said.filter(|(_, sent)| self.line.tally().sent > *sent) {
            self.beside.went_out(said);
        }
        let reply = reply?;
        let now = self.line.now();
        let cycle = self.station.answered(now, reply).map_err(|why| self.failure(&why))?;
        self.heard = now;
        match &cycle {
            Cycle::Left => {
                self.left += 1;
                // Led to its exchange anew, it finds no start word there.
                if !self.still.coasts {
                    self.words = self.mode.stop();
                }
                if self.left > MOST_LEFT {
                    return Err(self.failure(&Trouble::NotReady));
                }
            }
            Cycle::Inputs(data) => {
                if let Some((_, seen)) = self.mode.inputs(data) {
                    self.still.sees(now, seen);
                    self.driven |= !self.started && seen.is_driven();
                    (self.seen, self.more) = (Some(seen), self.mode.more(data));
                    self.shows(seen);
                }
            }
            Cycle::Prepared | Cycle::Released => {}
        }
        Ok(cycle)
    }

    /// Whether it goes on in spite of it. A slave that has exchanged data may miss some; its watchdog is shorter than what is borne.
    /// Who interrupts the end wants the motor to stop sooner; only the first time at the own end of a run it is what comes anyway.
    fn bears(&mut self, failure: &Failure) -> bool {
        match failure.class {
            Class::Interrupted if self.insists => {
                let presses = self.line.note_interrupts();
                if self.ours && !self.still.is_dark(self.line.now()) {
                    self.hastened |= self.own_end;
                    let is_first = std::mem::take(&mut self.own_end) && presses <= 1;
                    if !is_first {
                        self.take_power();
                    }
                }
                true
            }
            // A port that takes no bytes may take them again, and the motor may run on meanwhile.
            _ if failure.is_unheard() && (self.insists || (self.seen.is_some() && !self.watches)) => {
                self.misses(failure);
                let now = self.line.now();
                now < self.at_least || now.since(self.heard) < self.unheard
            }
            _ => false,
        }
    }

    /// From now on OFF3 goes out, where there is one.
    pub(super) fn take_power(&mut self) {
        if let Some(words) = self.mode.coast() {
            (self.words, self.still.coasts) = (words, true);
            self.stops_by("coast");
        }
    }

    /// Puts a request and waits for what comes of it.
    pub(super) async fn request(&mut self, mut request: Request) -> Result<Told, Failure> {
        loop {
            self.pkw = request.outputs();
            let cycle = self.cycle().await.inspect_err(|_| self.pkw = Pkw::default())?;
            let told = match cycle {
                Cycle::Inputs(data) => {
                    let said = self.mode.inputs(&data);
                    said.and_then(|(said, _)| request.inputs(self.line.now(), said))
                }
                // A motor that was started stands, or does what its loss of us has it do: that ends its run.
                Cycle::Left if self.started && !self.insists => return Err(trouble::left(self.address)),
                // What was on its way may have come; it is not said twice.
                Cycle::Left if request.writes() => Some(Told::Silence),
                _ => None,
            };
            if let Some(told) = told {
                self.pkw = Pkw::default();
                return Ok(told);
            }
        }
    }

    /// Reads a value: its bits, or why not. Nothing is asked in Basic mode, which has no PKW block.
    pub async fn read(&mut self, place: Place) -> Result<Result<u32, Failure>, Failure> {
        if !self.mode.has_pkw() {
            return Ok(Err(trouble::no_pkw(self.address)));
        }
        let told = self.request(Request::read(place, self.line.now())).await?;
        Ok(trouble::told(self.address, place, told))
    }

    /// Keeps the slave going while something else is waited for, such as the answer to a question. The time of a bench that is not
    /// paced stands still.
    pub async fn during<T>(&mut self, wait: impl Future<Output = T>) -> Result<T, Failure> {
        self.during_until(wait, None).await?.ok_or_else(trouble::interrupted)
    }

    /// The same, until a moment at most; then `None`.
    pub(super) async fn during_until<T>(
        &mut self,
        wait: impl Future<Output = T>,
        until: Option<Tick>,
    ) -> Result<Option<T>, Failure> {
        let mut wait = pin!(wait);
        let mut waited = None;
        if self.line.stands_still() && until.is_none() {
            let interrupt = self.line.interrupt();
            tokio::select! {
                biased;
                came = &mut wait => waited = Some(came),
                () = interrupt.raised() => {}
            }
        }
        while waited.is_none()
            && !self.line.interrupt().is_raised()
            && until.is_none_or(|until| self.line.now() < until)
        {
            let mut cycle = pin!(self.cycle());
            loop {
                tokio::select! {
                    biased;
                    came = &mut wait, if waited.is_none() => waited = Some(came),
                    kept = &mut cycle => match kept {
                        // What was waited for is there, and the next cycle tells it again.
                        Err(why) if waited.is_none() => return Err(why),
                        _ => break,
                    },
                }
            }
        }
        if self.line.interrupt().is_raised() { Err(trouble::interrupted()) } else { Ok(waited) }
    }

    fn failure(&self, why: &Trouble) -> Failure {
        match why {
            Trouble::Unanswered(Unanswered::OtherMaster(master)) => {
                trouble::other_master_beside(*master).with("address", self.address)
            }
            Trouble::Unanswered(why) => trouble::unanswered(self.address, why),
            other => trouble::not_exchanging(self.address, other, self.mode),
        }
    }
}

/// The factors of a watchdog that is no shorter; at most 650 s.
fn factors(watchdog: Span) -> [u8; 2] {
    let steps = watchdog.as_millis().div_ceil(STEP_MS).max(1);
    let second = steps.div_ceil(255);
    let first = steps.div_ceil(second.max(1));
    [first, second].map(|factor| u8::try_from(factor).unwrap_or(u8::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_watchdog_is_never_shorter_than_asked_for() {
        for (ms, expected) in
            [(1, [1, 1]), (2_000, [200, 1]), (2_550, [255, 1]), (2_560, [128, 2]), (60_000, [250, 24])]
        {
            let got = factors(Span::from_millis(ms));
            assert_eq!(got, expected);
            assert!(u64::from(got[0]) * u64::from(got[1]) * STEP_MS >= ms);
        }
    }
}
