//! The PKW channel: when an answer appears, and what stands there meanwhile (manual 4.1.1).

use super::readings::{Reading, Readings};
use crate::protocol::dp::pkw::Pkw;
use crate::tick::{Span, Tick};

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Channel {
    /// The request that stands there.
    asked: Pkw,
    due: Option<Tick>,
    shown: Pkw,
}

impl Channel {
    /// The request whose answer is due.
    pub(crate) fn due(&mut self, now: Tick) -> Option<Pkw> {
        self.due.take_if(|due| *due <= now).map(|_| self.asked)
    }

    /// Shows an answer from now on.
    pub(crate) fn show(&mut self, answer: Pkw) {
        self.shown = answer;
    }

    /// What the master reads in this cycle; the request that came with it is taken afterwards.
    pub(crate) fn exchange(&mut self, now: Tick, request: Pkw, takes: Span, readings: Readings) -> Pkw {
        let shown = self.shown;
        if request != self.asked {
            self.asked = request;
            self.due = Some(now + takes);
            if readings.has(Reading::PkwEmpties) {
                self.shown = Pkw::default();
            }
        } else if readings.has(Reading::PkwRepeats) && self.due.is_none() {
            self.due = Some(now + takes);
        }
        shown
    }
}
