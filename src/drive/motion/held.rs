//! A run that is held: kept alive, looked at, and ended in time.

use super::Motor;
use super::patience::ROUND;
use super::watchdog::watchdog_words;
use crate::drive::trouble::{NO_TIME, time_over};
use crate::failure::{Class, Failure};
use crate::outcome::Decimal;
use crate::text::{Text, both};
use crate::tick::{Span, Tick};

/// An end that comes so late is told: this program was held up.
const LATE: Span = Span::from_millis(500);

/// The time of a run that is held. It counts from the word that can turn the shaft, not from an answer to it, which may be
/// lost: the shaft turns all the same.
#[derive(Clone, Copy, Debug, Default)]
pub(super) enum Clock {
    /// Nothing is held.
    #[default]
    Stopped,
    /// It begins with the next word that can turn the shaft, and lasts so long, or until somebody ends it.
    Waits(Option<Span>),
    /// It begins when the setpoint is reached.
    Approaches(Option<Span>),
    Runs {
        begun: Tick,
        lasts: Option<Span>,
    },
}

/// What was not answered when the time of the run was over: that is no fault of the line.
fn cut_off(failure: Failure) -> Failure {
    let told = both!(
        "--duration was over before the drive had answered, and the stop did not wait for it",
        "--duration war um, ehe der Antrieb geantwortet hatte, und der Halt hat darauf nicht gewartet"
    );
    Failure { message: told, ..failure }.hint(both!(
        "choose a longer --duration, several times as long as an answer takes (`diag line` shows that)",
        "--duration länger wählen, mehrmals so lang wie eine Antwort braucht (`diag line` zeigt das)"
    ))
}

impl Motor<'_, '_> {
    /// The run will be held, from the next word on that can turn the shaft; so long, or until somebody ends it.
    pub fn will_hold(&mut self, lasts: Option<Span>) {
        if !matches!(self.clock, Clock::Runs { .. }) {
            self.clock = Clock::Waits(lasts);
        }
    }

    /// The run will be held from its setpoint on; so long, or until somebody ends it.
    pub fn will_hold_there(&mut self, lasts: Option<Span>) {
        self.clock = Clock::Approaches(lasts);
    }

    /// The setpoint is reached, and has been shown so since then, which is when the time of the run began.
    pub(super) fn begins_there(&mut self, since: Tick) {
        if let Clock::Approaches(lasts) = self.clock {
            // It ends now at the soonest.
            let now = self.session.now();
            let ends_now = |lasts: Span| Tick::from_micros(now.as_micros().saturating_sub(lasts.as_micros()));
            self.begins(since.max(lasts.map_or(since, ends_now)), lasts);
        }
    }

    fn begins(&mut self, begun: Tick, lasts: Option<Span>) {
        self.clock = Clock::Runs { begun, lasts };
        self.ends_by_the_clock();
    }

    /// The drive was asked then, and is not enabled yet: so far nothing turned its shaft.
    pub(super) fn turns_not_before(&mut self, asked: Tick) {
        if let Clock::Runs { lasts, .. } = self.clock {
            self.begins(asked, lasts);
        }
    }

    /// A word goes out that can turn the shaft: from here on nothing puts off what the run says, nor its end.
    pub(super) fn may_turn(&mut self) {
        match self.clock {
            Clock::Waits(lasts) => {
                self.session.insist(true);
                self.begins(self.session.now(), lasts);
            }
            // No question on the way keeps anybody from seeing that the setpoint is reached.
            Clock::Approaches(_) => self.session.insist(true),
            Clock::Stopped | Clock::Runs { .. } => {}
        }
    }

    /// Every question ends with the run, whatever has come of it.
    pub(super) fn ends_by_the_clock(&mut self) {
        self.session.end_at(self.end());
    }

    /// When the run ends by the clock.
    pub(super) fn end(&self) -> Option<Tick> {
        if let Clock::Runs { begun, lasts } = self.clock { lasts.map(|lasts| begun + lasts) } else { None }
    }

    /// Keeps the run alive until it has lasted so long, or something ends it: looks at the state, which also feeds the
    /// drive's watchdog, and ends with an error if the drive trips or, having been enabled, is so no longer. `each` is called
    /// in every round; it may be called twice in one, where no valid answer came.
    pub async fn hold(
        &mut self,
        lasts: Option<Span>,
        mut each: impl AsyncFnMut(&mut Self, Span) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let begun = self.runs_at_the_latest_now();
        let end = lasts.map(|lasts| begun + lasts);
        // Whoever else talks on the line puts off neither the refresh nor the end.
        self.session.insist(true);
        self.tell_held();
        self.comes_to("held", end);
        // A question that is under way then puts off nothing.
        self.session.end_at(end);
        self.gap = Span::ZERO;
        let held = self.hold_on(begun, end, &mut each).await;
        let over = self.session.is_over();
        self.ends_by_the_clock();
        match held {
            Err(failure) if over && failure.is_unheard() => {
                self.notes_late_end(end);
                Ok(())
            }
            Err(failure) => Err(self.names_watchdog(failure)),
            Ok(()) => {
                self.notes_late_end(end);
                Ok(())
            }
        }
    }

    /// Does `work`, whose words can turn the shaft, and holds what came of it, where that is wanted, for so long.
    pub async fn holding(
        &mut self,
        hold: Option<Option<Span>>,
        work: impl AsyncFnOnce(&mut Self) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let Some(lasts) = hold else { return work(self).await };
        self.will_hold(lasts);
        work(self).await?;
        self.hold(lasts, async |_, _| Ok(())).await
    }

    /// When the run began, which is now if no word could turn the shaft.
    fn runs_at_the_latest_now(&mut self) -> Tick {
        self.may_turn();
        if let Clock::Runs { begun, .. } = self.clock { begun } else { self.session.now() }
    }

    /// Whether the time of the run is over.
    fn is_late(&self) -> bool {
        self.end().is_some_and(|end| self.session.now() >= end)
    }

    /// Fails where it is.
    pub(super) fn demand_time(&self) -> Result<(), Failure> {
        if self.is_late() { Err(time_over()) } else { Ok(()) }
    }

    /// The last thing that is said in a run may stay unanswered where its time is over: that was its end.
    pub fn or_over(&self, said: Result<(), Failure>) -> Result<(), Failure> {
        let Clock::Runs { begun, .. } = self.clock else { return said };
        said.or_else(|failure| match failure.is_unheard() && self.session.is_over() && self.heard >= begun {
            true => Ok(()),
            false => Err(failure),
        })
    }

    /// What follows has no time of its own.
    pub fn counts_no_more(&mut self) {
        if matches!(std::mem::take(&mut self.clock), Clock::Runs { .. }) {
            self.session.end_at(None);
        }
    }

    /// Behind the work: no clock puts an end to what follows.
    pub(super) fn stops_the_clock<T>(&mut self, result: Result<T, Failure>) -> Result<T, Failure> {
        let is_late = self.is_late();
        self.counts_no_more();
        result.map_err(|failure| if is_late && failure.is_unheard() { cut_off(failure) } else { failure })
    }

    async fn hold_on(
        &mut self,
        begun: Tick,
        end: Option<Tick>,
        each: &mut impl AsyncFnMut(&mut Self, Span) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let mut looked = self.session.now();
        loop {
            let gone = self.session.now().since(begun);
            if end.is_some_and(|end| self.session.now() >= end) {
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
            looked = self.shown.map_or(now, |shown| shown.told);
            let takes = now.since(asked);
            self.expects_answers_within(takes);
            // What is given again and the look at the state come in time behind it.
            let room = self.guard.map(|guard| Span::from_micros(guard.as_micros() / 16 * 15) - takes.times(2));
            let by = room.map(|room| looked + room);
            self.keeps(takes, by).await?;
            self.spend(self.round(end), end).await?;
        }
    }

    /// Tells an end that came late: nothing on a line puts it off, so this program did not go on for a while.
    fn notes_late_end(&mut self, end: Option<Tick>) {
        let Some(late) = end.map(|end| self.session.now().since(end)) else { return };
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
        let words = watchdog_words(&self.target.family, Some(seconds));
        if failure.code == NO_TIME {
            // Nothing on a line keeps this program from asking.
            let text = both!(
                "this program was held up, so that nothing was asked for {gap}, longer than the drive's watchdog allows",
                "dieses Programm wurde aufgehalten und hat {gap} lang nichts gefragt, länger als der Watchdog des Antriebs zulässt"
            );
            return Failure { message: text, ..failure }.hint(both!(
                "{words}; was it suspended, or the machine asleep or overloaded?",
                "{words}; war es angehalten, der Rechner im Schlaf oder überlastet?",
                words
            ));
        }
        let told = both!(
            "nothing came from it for {gap}, longer than its watchdog allows; {words}",
            "{gap} lang kam nichts von ihm, länger als sein Watchdog zulässt; {words}",
            words
        );
        let hints: Vec<Text> = std::iter::once(told).chain(failure.hint.as_deref().cloned()).collect();
        failure.hint(Text::join(&hints, "; "))
    }

    /// The pause before the next round of a run that is held.
    fn round(&self, end: Option<Tick>) -> Span {
        let round = self.beat().times(ROUND);
        // Within a third of the watchdog, with room for the telegrams.
        let round = self.guard.map_or(round, |guard| round.min(Span::from_micros(guard.as_micros() / 4)));
        end.map_or(round, |end| round.min(end.since(self.session.now())))
    }
}
