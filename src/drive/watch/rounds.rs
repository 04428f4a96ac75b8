//! When the next round comes: by the clock, or when somebody calls for it.

use super::{Source, Watch, Window};
use crate::failure::{Class, Failure};
use crate::files::of_system;
use crate::outcome::{Event, Record};
use crate::text::both;
use crate::tick::{Span, Tick};
use std::io;
use tokio::sync::mpsc;
use tokio::sync::mpsc::error::TryRecvError;

/// How often, and until when.
#[derive(Debug)]
pub struct Rounds {
    /// When the next one comes.
    pub when: When,
    /// It ends after this time.
    pub duration: Option<Span>,
    /// It ends after so many rounds.
    pub count: Option<u64>,
    /// A lost port is waited for.
    pub reconnect: bool,
    /// What lies around a trigger.
    pub window: Window,
}

/// When the next round comes.
#[derive(Debug)]
pub enum When {
    /// So long behind the one before; zero is as fast as the line allows.
    Every(Span),
    /// When somebody calls for it. It ends when nobody can call any more.
    Called(Calls),
}

impl When {
    /// The time from round to round, if it is the clock that says when they come.
    pub(super) fn interval(&self) -> Option<Span> {
        match *self {
            When::Every(interval) => Some(interval),
            When::Called(_) => None,
        }
    }
}

/// Somebody who calls for rounds, one by one; nothing comes any more when he has left. An error: he cannot be heard.
pub type Calls = mpsc::Receiver<io::Result<()>>;

/// How often a lost port is tried.
const TRY_AGAIN: Span = Span::from_millis(500);

/// What came of waiting.
enum Came {
    Nothing,
    /// Somebody calls for a round.
    Call,
    /// Nobody will call any more.
    End,
}

impl Watch<'_> {
    /// Waits until the next round is due; `last` is when the one before began. If none comes any more: why.
    pub(super) async fn pause(&mut self, session: &mut impl Source, last: Option<Tick>) -> Option<&'static str> {
        let next = match (&self.rounds.when, last) {
            (When::Called(_), _) => None,
            (When::Every(_), None) => return None,
            (When::Every(interval), Some(last)) => Some(self.next_slot(*interval, last, session.now())),
        };
        let end = self.end.map(|(end, _)| end);
        let until = next.into_iter().chain(end).min();
        while until.is_none_or(|until| session.now() < until) {
            match self.wait(session, until).await {
                Ok(Came::Nothing) => {}
                Ok(Came::Call) => break,
                Ok(Came::End) => return Some("input"),
                Err(failure) => {
                    if let Some(because) = self.trouble(session, failure) {
                        return Some(because);
                    }
                }
            }
        }
        self.end.filter(|(end, _)| session.now() >= *end).map(|(_, because)| because)
    }

    /// The next point of the grid of rounds that is still ahead.
    fn next_slot(&self, interval: Span, slot: Tick, now: Tick) -> Tick {
        if interval == Span::ZERO {
            // Without a port there is nothing that would hold up the next round.
            return if self.lost.is_some() { now + TRY_AGAIN } else { now };
        }
        let step = interval.as_micros();
        let (done, gone) = (slot.since(self.begin).as_micros() / step, now.since(self.begin).as_micros() / step);
        self.begin + interval.times(gone.max(done) + 1)
    }

    /// Waits for the port if it is lost, for a call, or for the end of the time.
    async fn wait(&mut self, session: &mut impl Source, until: Option<Tick>) -> Result<Came, Failure> {
        if self.lost.is_some() {
            let sought = self.seek_port(session, until.unwrap_or(session.now() + TRY_AGAIN)).await;
            let call = match &mut self.rounds.when {
                When::Every(_) => Err(TryRecvError::Empty),
                When::Called(calls) => calls.try_recv(),
            };
            return match call {
                Err(TryRecvError::Empty) => sought.map(|()| Came::Nothing),
                call => Ok(self.came(call.ok())),
            };
        }
        let waited = match (&mut self.rounds.when, until) {
            (When::Called(calls), _) => session.during_until(calls.recv(), until).await,
            (When::Every(_), until) => {
                let now = session.now();
                session.rest(until.unwrap_or(now).since(now)).await.map(|()| None)
            }
        };
        Ok(waited?.map_or(Came::Nothing, |call| self.came(call)))
    }

    fn came(&mut self, call: Option<io::Result<()>>) -> Came {
        match call {
            Some(Ok(())) => return Came::Call,
            Some(Err(error)) => {
                let error = of_system(&error);
                let text = both!("cannot read stdin: {error}", "stdin lässt sich nicht lesen: {error}", error);
                self.unheard = Some(Failure::new(Class::Data, "data.stdin", text));
            }
            None => {}
        }
        Came::End
    }

    /// What to do when the session is over: end with this reason, or go on without a port.
    pub(super) fn trouble(&mut self, session: &mut impl Source, failure: Failure) -> Option<&'static str> {
        let reconnect = self.rounds.reconnect;
        if failure.class == Class::Interrupted {
            return Some("interrupted");
        }
        if failure.class != Class::Port {
            self.lost = Some(failure);
            return Some("lost");
        }
        if self.lost.is_none() {
            let change = self.port_change(session, Some(&failure));
            self.emit(session, Record::Lost(change));
            if reconnect {
                let text = both!("{why}; waiting for it", "{why}; es wird darauf gewartet", why = failure.told());
                session.tell(Event::Note(text));
            }
        }
        self.lost = Some(failure);
        (!reconnect).then_some("lost")
    }

    /// Tries to open a lost port, and waits a little if that does not work.
    async fn seek_port(&mut self, session: &mut impl Source, until: Tick) -> Result<(), Failure> {
        let reopened = session.reopen().await;
        if reopened.is_ok() {
            self.lost = None;
            let change = self.port_change(session, None);
            let text = both!("{port}: the port is back", "{port}: der Anschluss ist wieder da", port = change.port);
            session.tell(Event::Note(text));
            self.emit(session, Record::Reopened(change));
            return Ok(());
        }
        // Another adapter under the old name is told once, and left alone.
        if let Err(failure) = reopened
            && failure.code == "port.stranger"
            && self.lost.as_ref().is_some_and(|known| known.message != failure.message)
        {
            session.tell(Event::Note(both!(
                "{why}; waiting for the one that was lost",
                "{why}; es wird auf den verlorenen gewartet",
                why = failure.told()
            )));
            self.lost = Some(failure);
        }
        let pause = TRY_AGAIN.min(until.since(session.now()));
        session.rest(pause).await
    }
}
