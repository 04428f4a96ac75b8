//! The only end of an exchange: the stop word with control kept until the frequency is 0, then zero outputs, Clear, Unlock. Zero
//! outputs alone are no stop.

use super::exchange::{Exchange, STOP};
use super::trouble;
use crate::exchange::dp::{Cycle, Place, Request};
use crate::failure::Failure;
use crate::protocol::dp::pkw::Pkw;
use crate::tick::{Span, Tick};

/// So many cycles in a row with a frequency of 0, over this time, and the output is off.
const ZEROS: u32 = 3;
const QUIET: Span = Span::from_millis(100);
/// So long a frequency may stay as it is before the stop is given up.
const STUCK: Span = Span::from_secs(10);
/// The output frequency, 0.01 Hz (SJ2-PB manual 5.3).
const FREQUENCY: Place = Place { pnu: 614, element: None };

impl Exchange<'_, '_> {
    /// Lets the slave go: the stop word until the frequency is 0, then zero outputs, Clear, Unlock. Nobody's interrupt keeps it from
    /// that, and no silence that is shorter than the watchdog of the slave.
    pub async fn leave(mut self) -> Result<(), Failure> {
        self.insists = true;
        self.line.note_interrupts();
        (self.word, self.pkw) = (STOP, Pkw::default());
        if !self.station.is_owned() {
            return Ok(());
        }
        let stopped = self.stop().await;
        if stopped.is_ok() {
            self.word = 0;
            self.cycle().await?;
        }
        self.station.release(stopped.is_ok());
        let released = loop {
            match self.cycle().await {
                Ok(Cycle::Released) => break Ok(()),
                Ok(_) => {}
                Err(failure) => break Err(failure),
            }
        };
        stopped.and(released)
    }

    /// Proves under the stop word that the output is off, by HIW and by P.614, where that is told.
    async fn stop(&mut self) -> Result<(), Failure> {
        // Whom no exchange was reached with, no word of ours moves.
        let Some(first) = self.actual else { return Ok(()) };
        let (mut zeros, mut since) = (0, self.line.now());
        let mut moved: (i16, Tick) = (first, since);
        loop {
            let Cycle::Inputs(_) = self.cycle().await? else { continue };
            let (now, frequency) = (self.line.now(), self.actual.unwrap_or_default());
            match frequency {
                0 if zeros == 0 => (zeros, since) = (1, now),
                0 => zeros += 1,
                _ => zeros = 0,
            }
            if zeros >= ZEROS && now.since(since) >= QUIET {
                if self.is_off().await? && self.actual == Some(0) {
                    return Ok(());
                }
                zeros = 0;
            }
            if moved.0 != frequency {
                moved = (frequency, now);
            } else if now.since(moved.1) > STUCK {
                return Err(trouble::unproven(self.address(), frequency));
            }
        }
    }

    /// Whether P.614 agrees. Where it is refused, HIW alone has told.
    async fn is_off(&mut self) -> Result<bool, Failure> {
        let told = self.request(Request::read(FREQUENCY, self.line.now())).await?;
        Ok(!matches!(told, crate::exchange::dp::Told::Value(frequency) if frequency & 0xFFFF != 0))
    }
}
