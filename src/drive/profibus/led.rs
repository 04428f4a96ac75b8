//! A setpoint that is led while the motor runs: along its way, then by whoever presses the arrows. Start word and direction stand; only the
//! setpoint word changes, in the cycle behind the one that asked for it.

use super::exchange::Exchange;
use super::run::Run;
use super::words::{Lead, hundredths, part};
use crate::failure::Failure;
use crate::outcome::Event;
use crate::tick::Span;

impl Exchange<'_, '_> {
    /// A setpoint as a word; `maximum` is what 4000h is.
    pub(super) fn hsw(&self, value: i64, maximum: i64) -> u16 {
        if self.mode().is_basic() { hundredths(value) } else { part(value, maximum) }
    }

    /// Leads it along its way, and proves at the end that the motor turns.
    pub(super) async fn leads(
        &mut self,
        lead: &mut Lead<'_>,
        (maximum, wait): (i64, Span),
        run: &mut Run,
    ) -> Result<(), Failure> {
        if lead.takes == Span::ZERO {
            return Ok(());
        }
        let begun = self.line.now();
        self.comes_to("led", Some(begun + lead.takes));
        loop {
            let gone = self.line.now().since(begun);
            self.follows(lead, Some(gone.min(lead.takes)), maximum, run);
            if gone >= lead.takes {
                break;
            }
            run.actual = Some(self.obeying().await?.hiw);
        }
        let hsw = self.words.hsw;
        self.turns(hsw, wait, run).await
    }

    /// Holds it, wherever the arrows bring it.
    pub(super) async fn holds(&mut self, lead: &mut Lead<'_>, maximum: i64, run: &mut Run) -> Result<(), Failure> {
        run.held = true;
        self.comes_to("held", self.ends);
        while !self.is_over() {
            self.follows(lead, None, maximum, run);
            let hsw = self.words.hsw;
            let seen = self.obeying().await?;
            run.actual = Some(seen.hiw);
            run.reached = Some(self.is_near(seen, hsw) || seen.is_reached());
        }
        Ok(())
    }

    /// From the next cycle on the setpoint is where it is led to.
    fn follows(&mut self, lead: &mut Lead<'_>, gone: Option<Span>, maximum: i64, run: &mut Run) {
        let (value, told) = (lead.next)(gone);
        told.into_iter().for_each(|told| self.tell(Event::Note(told)));
        if run.given != Some(value) {
            run.given = Some(value);
            run.setpoints += 1;
            self.words.hsw = self.hsw(value, maximum);
            self.is_set(value);
        }
    }
}
