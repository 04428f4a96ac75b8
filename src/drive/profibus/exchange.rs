//! Parameters of an inverter over the PKW channel: the slave is taken for it, held by the stop word, and let go again.
//!
//! Whoever exchanges data with an SJ2-PB sends it a control word. That is 047E in every cycle: control kept, no start, OFF1. Zero
//! outputs would be no stop (a word without bit 10 may hand the motor to the terminals, or freeze the last word). However the work
//! ends, that word goes on until the actual frequency (HIW) is 0; only then go zero outputs, Clear and Unlock. Where we die, the
//! watchdog of the slave lets it go.

use super::line::Line;
use super::trouble;
use crate::exchange::dp::{Cycle, Request, Setup, Station, Told, Trouble};
use crate::failure::Failure;
use crate::gate::{Motion, Permit};
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::pkw::{self, Pkw};
use crate::tick::{Span, Tick};

/// Stop by OFF1, with control kept (SJ2-PB manual 4.1.2.1).
const STOP: u16 = 0x047E;
/// The slave lets go of us behind this: 2 s, as factors of 10 ms.
const WATCHDOG: [u8; 2] = [200, 1];
/// So many cycles in a row with a frequency of 0 prove the standstill.
const STILL: u32 = 3;
/// So long a frequency may stay as it is before the stop is given up.
const STUCK: Span = Span::from_secs(10);
/// So often a slave may leave Data_Exchange by itself.
const MOST_LEFT: u32 = 5;

/// A slave that exchanges data.
pub struct Exchange<'l, 'a> {
    line: &'l mut Line<'a>,
    address: u8,
    station: Station,
    left: u32,
    /// Actual frequency as it came last.
    actual: Option<i16>,
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
        let mut outputs = vec![0; layout.length()];
        put(&mut outputs, Pkw::default(), STOP);
        let station = Station::new(address, setup, outputs, line.now());
        Exchange { line, address, station, left: 0, actual: None }
    }

    /// Address of the slave.
    pub(super) fn address(&self) -> u8 {
        self.address
    }

    /// One exchange on the line.
    async fn cycle(&mut self) -> Result<Cycle, Failure> {
        let waits = self.station.waits();
        self.line.rest(waits).await?;
        let (station, asked) = self.station.question();
        let reply = self.line.ask(station, asked, None).await?;
        let now = self.line.now();
        let cycle = self.station.answered(now, reply).map_err(|why| self.failure(&why))?;
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
            _ => {}
        }
        Ok(cycle)
    }

    /// Reads a parameter by its index: its bits, or why not.
    pub async fn read(&mut self, index: u16) -> Result<Result<u32, Failure>, Failure> {
        let mut request = Request::read(index, self.line.now());
        loop {
            put(self.station.outputs(), request.outputs(), STOP);
            let Cycle::Inputs(data) = self.cycle().await? else { continue };
            let Some(said) = data.first_chunk::<{ pkw::LENGTH }>() else { continue };
            let Some(told) = request.inputs(self.line.now(), Pkw::decode(said)) else { continue };
            put(self.station.outputs(), Pkw::default(), STOP);
            return Ok(match told {
                Told::Value(bits) => Ok(bits),
                Told::Refused(pwe) => Err(trouble::refused(self.address, index, pwe)),
                Told::NoRight => Err(trouble::no_right(self.address, index)),
                Told::Silence => Err(trouble::no_answer(self.address, index)),
            });
        }
    }

    /// Lets the slave go: the stop word until the frequency is 0, then zero outputs, Clear, Unlock. Nobody's interrupt from before
    /// keeps it from that.
    pub async fn leave(mut self) -> Result<(), Failure> {
        self.line.note_interrupts();
        if !self.station.is_owned() {
            return Ok(());
        }
        let stopped = self.stop().await;
        if stopped.is_ok() {
            self.station.outputs().fill(0);
            self.cycle().await?;
        }
        self.station.release(stopped.is_ok());
        while self.cycle().await? != Cycle::Released {}
        stopped
    }

    /// Proves the standstill under the stop word.
    async fn stop(&mut self) -> Result<(), Failure> {
        // Whom no exchange was reached with, no word of ours moves.
        if self.actual.is_none() {
            return Ok(());
        }
        put(self.station.outputs(), Pkw::default(), STOP);
        let (mut still, mut moved): (u32, (Option<i16>, Tick)) = (0, (None, self.line.now()));
        while still < STILL {
            let Cycle::Inputs(_) = self.cycle().await? else { continue };
            let now = self.line.now();
            still = if self.actual == Some(0) { still + 1 } else { 0 };
            if moved.0 != self.actual {
                moved = (self.actual, now);
            } else if still == 0 && now.since(moved.1) > STUCK {
                return Err(trouble::unproven(self.address, self.actual.unwrap_or_default()));
            }
        }
        Ok(())
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
