//! A run that is held: kept alive, looked at, and ended in time.

use super::Motor;
use super::patience::ROUND;
use super::watchdog::watchdog_words;
use crate::failure::{Class, Failure};
use crate::outcome::Decimal;
use crate::text::{Text, both};
use crate::tick::{Span, Tick};

/// An end that comes so late is told: this program was held up.
const LATE: Span = Span::from_millis(500);

impl Motor<'_, '_> {
    /// Keeps the run alive for a time, or until something ends it: looks at the state, which also feeds the drive's
    /// watchdog, and ends with an error if the drive trips or, having been enabled, is so no longer. `each` is called in
    /// every round; it may be called twice in one, where no valid answer came.
    pub async fn hold(
        &mut self,
        duration: Option<Span>,
        mut each: impl AsyncFnMut(&mut Self, Span) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        // Whoever else talks on the line puts off neither the refresh nor the end.
        self.session.insist(true);
        self.tell_held();
        let begun = self.session.now();
        self.comes_to("held", duration.map(|duration| begun + duration));
        // A question that is under way then puts off nothing.
        self.session.end_at(duration.map(|duration| begun + duration));
        self.gap = Span::ZERO;
        let held = self.hold_on(begun, duration, &mut each).await;
        let over = self.session.is_over();
        self.session.end_at(None);
        match held {
            Err(failure) if over && failure.is_unheard() => {
                self.notes_late_end(begun, duration);
                Ok(())
            }
            Err(failure) => Err(self.names_watchdog(failure)),
            Ok(()) => {
                self.notes_late_end(begun, duration);
                Ok(())
            }
        }
    }

    async fn hold_on(
        &mut self,
        begun: Tick,
        duration: Option<Span>,
        each: &mut impl AsyncFnMut(&mut Self, Span) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let end = duration.map(|duration| begun + duration);
        let mut looked = begun;
        loop {
            let gone = self.session.now().since(begun);
            self.gap = self.gap.longer(self.session.now().since(self.heard));
            if duration.is_some_and(|duration| gone >= duration) {
                return Ok(());
            }
            // Both together are over before the drive's watchdog would be.
            let last = self.guard.map(|guard| looked + Span::from_micros(guard.as_micros() / 16 * 15));
            self.session.end_at(end.into_iter().chain(last).min());
            let given = self.bear(async |motor: &mut Self| each(motor, gone).await).await;
            self.session.end_at(end);
            given?;
            // Neither does a look put off what is given again before the drive's watchdog misses it.
            let due = self.guard.map(|guard| self.session.now() + Span::from_micros(guard.as_micros() / 2));
            self.session.end_at(end.into_iter().chain(due).chain(last).min());
            let asked = self.session.now();
            let seen = self.look_on().await;
            let now = self.session.now();
            let patience = self.guard.map_or(Span::ZERO, |guard| Span::from_micros(guard.as_micros() / 4 * 3));
            let cut = self.session.is_over() && now.since(looked) < patience;
            self.session.end_at(end);
            match seen {
                Err(failure) if cut && failure.is_unheard() => continue,
                seen => seen?,
            };
            looked = self.shown.map_or(now, |(_, at)| at);
            let takes = now.since(asked);
            // What is given again and the look at the state come in time behind it.
            let room = self.guard.map(|guard| Span::from_micros(guard.as_micros() / 16 * 15) - takes.times(2));
            let by = room.map(|room| looked + room);
            self.keeps(takes, by).await?;
            let gone = self.session.now().since(begun);
            self.spend(self.round(duration, gone), end).await?;
        }
    }

    /// Tells an end that came late: nothing on a line puts it off, so this program did not go on for a while.
    fn notes_late_end(&mut self, begun: Tick, duration: Option<Span>) {
        let Some(late) = duration.map(|duration| self.session.now().since(begun + duration)) else { return };
        if late >= LATE {
            self.notes.push(both!(
                "the end came {late} late: this program was held up meanwhile",
                "das Ende kam {late} zu spät: dieses Programm wurde zwischendurch aufgehalten"
            ));
        }
    }

    /// Names the drive's watchdog where it was not asked for longer than that allows.
    fn names_watchdog(&self, failure: Failure) -> Failure {
        let gap = self.gap.longer(self.session.now().since(self.heard));
        let Some(guard) = self.guard.filter(|guard| gap >= *guard) else { return failure };
        if matches!(failure.class, Class::Port | Class::Interrupted) {
            return failure;
        }
        let seconds = Decimal { raw: i64::try_from(guard.as_millis()).unwrap_or(i64::MAX), decimals: 3 };
        let told = both!(
            "nothing came from it for {gap}, longer than its watchdog allows; {words}",
            "{gap} lang kam nichts von ihm, länger als sein Watchdog zulässt; {words}",
            words = watchdog_words(&self.target.family, Some(seconds))
        );
        let hints: Vec<Text> = std::iter::once(told).chain(failure.hint.as_deref().cloned()).collect();
        failure.hint(Text::join(&hints, "; "))
    }

    /// The pause before the next round of a run that is held.
    fn round(&self, duration: Option<Span>, gone: Span) -> Span {
        let round = self.beat().times(ROUND);
        // Within a third of the watchdog, with room for the telegrams.
        let round = self.guard.map_or(round, |guard| round.min(Span::from_micros(guard.as_micros() / 4)));
        duration.map_or(round, |duration| round.min(duration - gone))
    }
}
