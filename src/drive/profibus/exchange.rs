//! A slave that exchanges data with us: it is taken, asked over the PKW channel, and let go again (`ending`).
//!
//! Whoever exchanges data with an SJ2-PB sends it a control word. That is 047E in every cycle, as long as nothing else was agreed to:
//! control kept, no start, OFF1. Zero outputs would be no stop (a word without bit 10 may hand the motor to the terminals, or freeze
//! the last word). Where we die, the watchdog of the slave lets it go.

use super::line::Line;
use super::trouble;
use crate::exchange::dp::{Cycle, Place, Request, Setup, Station, Told, Trouble};
use crate::failure::{Class, Failure};
use crate::gate::{Motion, Permit};
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::pkw::{self, Pkw};
use crate::tick::{Span, Tick};
use std::pin::pin;

/// OFF1, with control kept (SJ2-PB manual 4.1.2.1).
pub(super) const STOP: u16 = 0x047E;
/// The slave lets go of us behind this: 2 s, as factors of 10 ms.
const WATCHDOG: [u8; 2] = [200, 1];
/// So often a slave may leave Data_Exchange by itself.
const MOST_LEFT: u32 = 5;
/// So long nothing may be heard of a slave that was heard: longer than its watchdog, behind which it is led to Data_Exchange anew.
const UNHEARD: Span = Span::from_secs(5);

/// A slave that exchanges data.
pub struct Exchange<'l, 'a> {
    pub(super) line: &'l mut Line<'a>,
    address: u8,
    pub(super) station: Station,
    left: u32,
    /// Control word; the setpoint is always 0.
    pub(super) word: u16,
    pub(super) pkw: Pkw,
    /// Actual frequency as it came last.
    pub(super) actual: Option<i16>,
    heard: Tick,
    /// The end is on its way: no interrupt and no short silence keeps it from going out.
    pub(super) insists: bool,
}

impl std::fmt::Debug for Exchange<'_, '_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Exchange").field("station", &self.station).finish_non_exhaustive()
    }
}

impl<'l, 'a> Exchange<'l, 'a> {
    /// Takes the slave; PPO1, with these user parameters. It must be left by [`Exchange::leave`], however the work ends.
    pub fn new(line: &'l mut Line<'a>, address: u8, user: Vec<u8>, _permit: &Permit<Motion>) -> Self {
        let layout = Layout::Ppo(1);
        let setup = Setup { watchdog: WATCHDOG, user, cfg: layout.bytes().to_vec() };
        let now = line.now();
        let station = Station::new(address, setup, vec![0; layout.length()], now);
        Exchange {
            line,
            address,
            station,
            left: 0,
            word: STOP,
            pkw: Pkw::default(),
            actual: None,
            heard: now,
            insists: false,
        }
    }

    /// Address of the slave.
    pub(super) fn address(&self) -> u8 {
        self.address
    }

    /// One exchange on the line.
    pub(super) async fn cycle(&mut self) -> Result<Cycle, Failure> {
        loop {
            match self.once().await {
                Err(failure) if self.bears(&failure) => {}
                done => return done,
            }
        }
    }

    async fn once(&mut self) -> Result<Cycle, Failure> {
        let waits = self.station.waits();
        self.line.rest(waits).await?;
        put(self.station.outputs(), self.pkw, self.word);
        let (station, asked) = self.station.question();
        let reply = self.line.ask(station, asked, None).await?;
        let now = self.line.now();
        let cycle = self.station.answered(now, reply).map_err(|why| self.failure(&why))?;
        self.heard = now;
        match &cycle {
            Cycle::Left => {
                self.left += 1;
                if self.left > MOST_LEFT {
                    return Err(self.failure(&Trouble::NotReady));
                }
            }
            Cycle::Inputs(data) => {
                let word = data.get(pkw::LENGTH + 2..pkw::LENGTH + 4).and_then(|word| word.try_into().ok());
                self.actual = word.map(i16::from_be_bytes);
            }
            Cycle::Prepared | Cycle::Released => {}
        }
        Ok(cycle)
    }

    /// Whether it goes on in spite of it. A slave that has exchanged data may miss some; its watchdog is shorter than what is borne.
    fn bears(&mut self, failure: &Failure) -> bool {
        match failure.class {
            Class::Interrupted if self.insists => {
                self.line.note_interrupts();
                true
            }
            Class::Silence | Class::Garbled if self.insists || self.actual.is_some() => {
                self.line.now().since(self.heard) < UNHEARD
            }
            _ => false,
        }
    }

    /// Puts a request and waits for what comes of it.
    pub(super) async fn request(&mut self, mut request: Request) -> Result<Told, Failure> {
        loop {
            self.pkw = request.outputs();
            let told = match self.cycle().await? {
                Cycle::Inputs(data) => {
                    let said = data.first_chunk::<{ pkw::LENGTH }>();
                    said.and_then(|said| request.inputs(self.line.now(), Pkw::decode(said)))
                }
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

    /// Reads a value: its bits, or why not.
    pub async fn read(&mut self, place: Place) -> Result<Result<u32, Failure>, Failure> {
        let told = self.request(Request::read(place, self.line.now())).await?;
        Ok(trouble::told(self.address, place, told))
    }

    /// Keeps the slave going while something else is waited for, such as the answer to a question. The time of a bench that is not
    /// paced stands still.
    pub async fn during<T>(&mut self, wait: impl Future<Output = T>) -> Result<T, Failure> {
        let mut wait = pin!(wait);
        let mut waited = None;
        if self.line.stands_still() {
            let interrupt = self.line.interrupt();
            tokio::select! {
                biased;
                came = &mut wait => waited = Some(came),
                () = interrupt.raised() => {}
            }
        }
        while waited.is_none() && !self.line.interrupt().is_raised() {
            let mut cycle = pin!(self.cycle());
            loop {
                tokio::select! {
                    biased;
                    came = &mut wait, if waited.is_none() => waited = Some(came),
                    kept = &mut cycle => {
                        kept?;
                        break;
                    }
                }
            }
        }
        match waited {
            Some(waited) if !self.line.interrupt().is_raised() => Ok(waited),
            _ => Err(trouble::interrupted()),
        }
    }

    fn failure(&self, why: &Trouble) -> Failure {
        match why {
            Trouble::Unanswered(why) => trouble::unanswered(self.address, why),
            other => trouble::not_exchanging(self.address, other),
        }
    }
}

/// Puts a PKW block and a control word into the outputs of PPO1, with a setpoint of 0.
fn put(outputs: &mut [u8], pkw: Pkw, word: u16) {
    let [high, low] = word.to_be_bytes();
    let bytes = pkw.encode().into_iter().chain([high, low, 0, 0]);
    outputs.iter_mut().zip(bytes).for_each(|(own, byte)| *own = byte);
}
