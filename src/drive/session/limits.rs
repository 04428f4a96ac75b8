//! How long is waited for answers, and when questions end.

use super::{Session, UNHURRIED};
use crate::exchange::Limits;
use crate::tick::{Span, Tick};

impl Session<'_> {
    /// Time limits.
    pub fn limits(&self) -> Limits {
        self.limits
    }

    /// Other time limits from now on.
    pub fn set_limits(&mut self, limits: Limits) {
        self.limits = limits;
        self.line.borrow_mut().master.set_limits(limits);
    }

    /// From now on a shaft depends on the answers.
    pub fn hastens(&mut self) {
        self.set_limits(Limits { hastens: true, ..self.limits });
    }

    /// From now on no answer is waited for longer than what insists does, whatever `--timeout` says.
    pub(in crate::drive) fn wait_briefly(&mut self) {
        let limits = self.limits();
        self.set_limits(Limits { reply_timeout: limits.reply_timeout.min(UNHURRIED), ..limits });
    }

    /// The same with as much time for an answer as a drive may take: asked again sooner, nobody knows which one came.
    pub(in crate::drive) fn patient(&self) -> Limits {
        Limits { reply_timeout: self.usual, ..self.limits }
    }

    /// Works within these time limits; afterwards those from before hold again.
    pub(in crate::drive) async fn within<T>(&mut self, limits: Limits, work: impl AsyncFnOnce(&mut Self) -> T) -> T {
        let before = self.limits();
        self.set_limits(limits);
        let done = work(self).await;
        self.set_limits(before);
        done
    }

    /// Other number of repeats from now on; returns the one that held until now.
    pub fn set_retries(&mut self, retries: u8) -> u8 {
        let limits = self.limits();
        self.set_limits(Limits { retries, ..limits });
        limits.retries
    }

    /// From now on every question ends at this time, whatever has come of it, and none is asked any more; `None`: each has
    /// the time that it needs. For what ends by the clock, and for what must not be pursued for ever.
    pub fn end_at(&mut self, at: Option<Tick>) {
        self.ends_at = at;
    }

    /// Where questions end at some time, that is not sooner than so much later.
    pub fn ends_later(&mut self, least: Span) {
        let soonest = self.now() + least;
        self.ends_at = self.ends_at.map(|at| at.max(soonest));
    }
}
