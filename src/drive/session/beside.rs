//! Several conversations side by side on one line, each in a session of its own.

use super::Session;
use crate::drive::pump::PumpError;
use crate::drive::turns::seats;
use crate::exchange::{Answer, ExchangeError, INSIST};
use crate::outcome::Event;
use crate::text::both;
use crate::tick::Tick;
use futures_util::future::join_all;
use std::rc::Rc;

impl<'a> Session<'a> {
    /// Works on several stations side by side. Each work is written as if it had the line to itself: whenever it rests, or asks in
    /// vain, it is the turn of another. Returns what came of each, in their order.
    pub async fn side_by_side<T>(
        &mut self,
        stations: &[u8],
        work: impl AsyncFn(&mut Session<'a>, usize) -> T,
    ) -> Vec<T> {
        let work = &work;
        let works: Vec<_> = (seats(stations.len(), self.now()).into_iter().zip(stations).enumerate())
            .map(|(at, (seat, &station))| {
                let heard = (self.limits, self.interrupt.clone());
                let mut beside = Session::on(self.port.clone(), Rc::clone(&self.line), heard);
                (beside.node, beside.seat, beside.named) = (self.node, Some(seat), Some(station));
                async move {
                    if let Some(seat) = &beside.seat {
                        seat.begin().await;
                    }
                    work(&mut beside, at).await
                }
            })
            .collect();
        join_all(works).await
    }

    /// Whether others talk over the line too.
    pub fn is_shared(&self) -> bool {
        self.seat.is_some()
    }

    /// From now on notes say that they are about this station; `None`: there is but one.
    pub fn speaks_of(&mut self, station: Option<u8>) {
        self.named = station;
    }

    /// Lets the others talk until `due`, if there are any. What is answered in its turns has the time that the others take added to
    /// its own.
    pub(super) async fn give_way(&mut self, due: Tick) {
        let (Some(seat), now) = (&self.seat, self.now()) else { return };
        seat.give_way(now, due, &self.interrupt).await;
        let waited = self.now().since(now.max(due));
        if !seat.is_quiet() {
            self.ends_at = self.ends_at.map(|at| at + waited);
        }
    }

    /// Lets whoever waits talk before another question; returns when that ends. Who is silent waits on his own time, but what he
    /// had time for as he began to wait goes out when it is his turn: it may be a stop.
    pub(super) async fn take_turn(&mut self) -> Option<Tick> {
        let asks = self.now();
        if !self.seat.as_ref().is_some_and(|seat| seat.is_over(asks)) {
            return self.ends_at;
        }
        let left = self.ends_at.map(|at| at.since(asks));
        self.give_way(asks).await;
        let one = self.now() + left.unwrap_or_default().min(self.patient().reply_timeout).longer(INSIST);
        self.ends_at.map(|at| at.max(one))
    }

    /// How often a question is repeated within one turn.
    pub(super) fn tries(&self, retries: u8) -> u8 {
        if self.gives_way() { 0 } else { retries }
    }

    /// Whether others wait for the line.
    pub(super) fn gives_way(&self) -> bool {
        self.seat.as_ref().is_some_and(|seat| !seat.is_alone())
    }

    /// Takes note of whether the station answers.
    pub(super) fn hear_of(&self, outcome: &Result<Result<Answer, ExchangeError>, PumpError>) {
        if let (Some(seat), Ok(outcome)) = (&self.seat, outcome) {
            seat.was_answered(outcome.is_ok());
        }
    }

    /// Where several are talked to at once, what is told says of whom.
    pub(super) fn addressed(&self, event: Event) -> Event {
        match (event, self.named) {
            (Event::Note(note), Some(station)) => {
                Event::Note(both!("address {station}: {note}", "Adresse {station}: {note}", station, note))
            }
            (event, _) => event,
        }
    }
}
