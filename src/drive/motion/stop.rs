//! The stop at the end of a run: sent, proven, escalated, and said.

use super::look::raw;
use super::still::{QUICK_STOP, STOPPED, never_powered};
use super::{ENDING_ALONE, Lever, Motor, coasting, has_power};
use crate::failure::{Class, Failure, unanswered_stop};
use crate::outcome::{Event, State, Stop};
use crate::profile::{Mode, StopRow, Takes};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};

mod choice;
mod silent;
mod told;
mod unbidden;

pub use choice::StopChoice;
pub(super) use silent::PURSUED;
use silent::PURSUED_ALONE;
use told::started_by_others;

/// How often the stop at the end is tried at least on a line that does not answer.
const STOP_TRIES: u8 = 5;
/// Who has not answered for so long was not reached.
const UNHEARD: Span = Span::from_secs(2);

/// What proves a stop.
struct Proof {
    state: State,
    /// Whether the shaft stands; `None` if nothing tells.
    standing: Option<bool>,
    /// The standstill belongs to the proof.
    owed: bool,
}

/// That the drive did not work in the mode that was set for the run, so that the setpoint moved nothing and another stop may follow.
fn left_mode(set: Option<&Mode>, shown: Option<&Mode>) -> Option<Text> {
    let (set, shown) = set.zip(shown).filter(|(set, shown)| set.value != shown.value)?;
    let (set, shown) = (set.text(), shown.text());
    Some(both!(
        "the drive had left the mode '{set}': it was stopped in the mode '{shown}'",
        "der Antrieb hatte die Betriebsart '{set}' verlassen: angehalten wurde er in '{shown}'",
        set,
        shown
    ))
}

impl Motor<'_, '_> {
    /// Sends the stop and waits for the state and the standstill that prove it. Somebody who interrupts again gets a
    /// stronger one, and so does a drive that does not obey; who interrupts the end of a run for the first time asks for what is under
    /// way. Never fails: it reports.
    pub(super) async fn stop(&mut self, choice: StopChoice, because: &'static str) -> Stop {
        let mut stop = not_yet(choice, because);
        if choice == StopChoice::Keep {
            return stop;
        }
        self.comes_to("stopping", None);
        self.gap = self.session.now().since(self.heard);
        let begun = self.begin_to_stop(choice, because == "interrupted");
        // Who has pressed more than once before it was his turn is not put off with the first.
        let (mut way, mut tries, mut again) = (choice.stronger_by(self.fresh_presses().saturating_sub(1)), 1, true);
        let (mut hurry, mut is_unheard, mut is_told) = (way != choice, false, false);
        if hurry {
            self.tell_stronger(choice, way, true);
            stop.escalated = Some(way.slug());
        }
        loop {
            if self.lever == Lever::Contacts && way == StopChoice::QuickStop {
                way = self.no_quick_stop();
                stop.escalated = Some(way.slug());
                self.stops_by(way.slug());
            }
            let failure = match self.try_stop(way, hurry, tries >= STOP_TRIES).await {
                Ok(proof) => {
                    self.notes_silence(is_unheard).await;
                    return self.proven(stop, proof).await;
                }
                Err(failure) => failure,
            };
            let is_disobeyed = matches!(failure.class, Class::Forbidden | Class::Refused) && self.works;
            if is_disobeyed && self.stronger(way).is_none() && !std::mem::replace(&mut is_told, true) {
                self.tell_deaf(way);
                self.zero_besides().await;
            }
            match (failure.class, self.stronger(way)) {
                (Class::Interrupted, _) if self.asks_for_this(stop.because) => {
                    (stop.because, tries) = ("interrupted", 0);
                    self.tell_stopping(way);
                }
                // The same stop again, by what is obeyed now.
                (Class::Forbidden, _) if self.lever == Lever::ControlWord && self.was_taken().await => tries = 0,
                (Class::Interrupted | Class::Forbidden | Class::Refused, Some(next)) => {
                    self.session.note_interrupts();
                    let next = next.stronger_by(self.fresh_presses().saturating_sub(1));
                    if failure.class == Class::Interrupted {
                        (hurry, stop.because) = (true, "interrupted");
                    }
                    self.tell_stronger(way, next, failure.class == Class::Interrupted);
                    (way, tries) = (next, 0);
                    stop.escalated = Some(next.slug());
                }
                (Class::Interrupted, None) => {
                    (hurry, stop.because) = (true, "interrupted");
                    self.hurries();
                }
                // As long as the drive answers now and then the stop goes out to it.
                _ if failure.is_unheard() => {
                    is_unheard = true;
                    let is_last = hurry && self.stronger(way).is_none();
                    let given_up = (is_last || tries >= STOP_TRIES) && self.gives_up(begun, is_last).await;
                    // Who has just answered was reached, and does not obey.
                    self.unheard = given_up && self.session.now().since(self.heard) >= UNHEARD;
                    if given_up {
                        break;
                    }
                }
                // A gateway that has closed its connection may take another one.
                (Class::Port, _) if std::mem::take(&mut again) && self.session.reopen().await.is_ok() => {}
                (Class::Port, _) => break,
                (Class::Forbidden, _) if self.lever == Lever::Taken => break,
                (Class::Refused, None) if tries >= STOP_TRIES => {
                    self.notes.push(failure.told());
                    stop.standing = self.zero_as_the_last().await;
                    break;
                }
                // Nor does it help to wait on where answers come, and the strongest stop is not obeyed.
                (Class::Forbidden, None)
                    if self.relieving.is_some() && self.session.now().since(begun) >= PURSUED_ALONE =>
                {
                    break;
                }
                // Who works on as if nothing had been said may still obey his setpoint.
                (Class::Forbidden, None) if tries >= STOP_TRIES && self.works && self.lever != Lever::Setpoint => {
                    stop.standing = self.zero_as_the_last().await;
                    break;
                }
                _ if tries >= STOP_TRIES => break,
                _ => {}
            }
            tries = tries.saturating_add(1);
        }
        self.last_word(way, &mut stop).await;
        // Whoever waits no longer is told what the drive says now.
        self.session.note_interrupts();
        if hurry && self.session.is_over() {
            self.ends_within(ENDING_ALONE);
        }
        self.hurried = hurry;
        let owed = !hurry && way != StopChoice::Coast;
        match self.unheard {
            true => self.briefly(async |motor: &mut Self| motor.last_look(stop, owed).await).await,
            false => self.last_look(stop, owed).await,
        }
    }

    /// The time of what only takes motion away is over, and the drive works on as if nothing had been said: the strongest word goes
    /// out all the same.
    async fn last_word(&mut self, way: StopChoice, stop: &mut Stop) {
        if self.relieving.is_some() && self.works && way == StopChoice::QuickStop && self.stronger(way).is_some() {
            self.tell_stronger(way, StopChoice::Coast, false);
            stop.escalated = Some(StopChoice::Coast.slug());
            let _told_by_the_last_look = self.write_control(0).await;
        }
    }

    /// What everything else waits for from now on; returns when it began.
    fn begin_to_stop(&mut self, choice: StopChoice, interrupted: bool) -> Tick {
        if interrupted && !self.hurried {
            self.tell_stopping(choice);
        }
        self.stopping = true;
        self.doubts = self.session.tally().fences;
        self.had_power = self.enabled && self.sight.on == Some(true);
        // A drive on its way to operation shows for a while that it is without power.
        self.shown = None;
        self.sight.forget();
        self.session.insist(true);
        self.session.warns(unanswered_stop());
        let begun = self.session.now();
        (self.heard, self.unheard) = (begun, false);
        if self.relieving.is_none() {
            self.bound = None;
            self.session.end_at(None);
        }
        if self.hurried {
            self.hurries();
        }
        self.has_time_for_a_word();
        begun
    }

    /// What is left to stop it with.
    fn stronger(&self, way: StopChoice) -> Option<StopChoice> {
        match self.lever {
            Lever::ControlWord => way.stronger(),
            // There is no quick stop by contacts.
            Lever::Contacts => way.stronger().map(|_| StopChoice::Coast),
            Lever::Setpoint | Lever::Taken => None,
        }
    }

    /// What takes the place of a quick stop by contacts: what brings the shaft to rest, or, where a ramp was not waited for,
    /// what takes the power at once.
    fn no_quick_stop(&mut self) -> StopChoice {
        let way = if self.relieving.is_some() { StopChoice::Coast } else { StopChoice::Ramp };
        let (label, slug) = (self.target.family.role_label("control-mode"), way.slug());
        let text = both!(
            "{label} is 2, and contacts know no quick stop: {slug} in its place",
            "{label} ist 2, und Kontakte kennen keinen Schnellhalt: stattdessen {slug}"
        );
        self.session.tell(Event::Note(text.clone()));
        self.instead = Some(text);
        way
    }

    /// What the proof tells. A shaft that turns on without power is said, also where nobody waited for it, and so is that
    /// nothing tells.
    async fn proven(&mut self, mut stop: Stop, proof: Proof) -> Stop {
        if self.no_zero_stops() {
            let (_, shown) = self.mode_shown().await;
            self.instead = self.instead.take().or_else(|| left_mode(self.mode.as_ref(), shown.as_ref()));
        }
        let off = self.lever != Lever::Taken || has_power(&proof.state.slug) == Some(false);
        stop.acknowledged = off
            && match proof.standing {
                Some(stands) => stands || !proof.owed,
                // The state is the proof of a drive that never had power; of its shaft it is none, which the verdict knows.
                None => !(proof.owed && self.powered),
            };
        if !off {
            stop.note = Some(both!(
                "the setpoint is 0; its contacts or its keypad keep the drive enabled",
                "der Sollwert ist 0; seine Kontakte oder seine Bedieneinheit halten den Antrieb freigegeben"
            ));
        } else if self.powered || proof.standing == Some(false) {
            let crept = self.crept().filter(|_| proof.standing.is_none());
            stop.note = crept.or_else(|| coasting(proof.standing));
            if !stop.acknowledged && proof.standing.is_none() && stop.because != "error" {
                let why = self.why_unseen().await.why;
                stop.note = stop.note.map(|note| Text::join([&note, &why], "; "));
            }
        } else if proof.standing.is_none() && proof.owed && stop.because != "error" {
            stop.note = Some(never_powered());
        }
        (stop.state, stop.standing) = (Some(proof.state), proof.standing);
        stop
    }

    /// The stop was not proven: what does the drive say now?
    async fn last_look(&mut self, mut stop: Stop, owed: bool) -> Stop {
        let by_others = self.lever == Lever::Setpoint;
        if let Ok(state) = self.state().await {
            if STOPPED.contains(&state.slug.as_str()) && !by_others {
                let standing = self.stands_now().await.ok().flatten();
                return self.proven(stop, Proof { state, standing, owed }).await;
            }
            stop.state = Some(state);
        }
        let watchdog = self.watchdog_note().await;
        stop.note = Some(match &stop.state {
            Some(state) if by_others && has_power(&state.slug) == Some(true) => {
                Text::join([&started_by_others(), &watchdog], "; ")
            }
            _ => watchdog,
        });
        stop
    }

    /// The row of the catalogue that says how: another one in modes that no setpoint 0 stops. What counts is the mode
    /// that the drive shows: it may have refused the one that was wanted.
    async fn way_to_stop(&mut self, choice: StopChoice) -> Option<StopRow> {
        let family = self.target.family.clone();
        let row = family.motion.stop(choice.slug())?;
        if !row.zero {
            return Some(row.clone());
        }
        if self.no_zero_stops() {
            return row.otherwise.as_ref().map_or(Some(row), |slug| family.motion.stop(slug)).cloned();
        }
        self.zero_at_once().await;
        let (told, shown) = self.mode_shown().await;
        self.instead = self.instead.take().or_else(|| left_mode(self.mode.as_ref(), shown.as_ref()));
        self.zeroes = shown.as_ref().filter(|mode| mode.zero_stops()).map(|mode| mode.setpoint);
        if let Some(mode) = shown.as_ref().filter(|mode| mode.zero_stops())
            && let Some(why) = self.follows_another(mode).await
        {
            self.zeroes = None;
            self.instead = self.instead.take().or(Some(why));
        }
        let other = row.otherwise.as_ref().filter(|_| self.zeroes.is_none());
        if other.is_some()
            && let Some(told) = told
        {
            self.instead = self.instead.take().or_else(|| self.shows_no_mode(told));
        }
        other.map_or(Some(row), |slug| family.motion.stop(slug)).cloned()
    }

    /// Whether the run works in a mode of the drive in which no setpoint 0 stops it. What stops it there does so in every mode, and goes
    /// out before anything is asked.
    fn no_zero_stops(&self) -> bool {
        self.entered && self.mode.as_ref().is_some_and(|mode| mode.value.is_some() && !mode.zero_stops())
    }

    /// Sets the setpoint that was given to 0 before the drive is asked for its mode: in any other it moves nothing, and a line
    /// that leaves questions unanswered must not keep the stop back.
    async fn zero_at_once(&mut self) {
        self.zeroed = None;
        let given = self.setpoint.as_ref().map(|setpoint| setpoint.param);
        let stops =
            self.mode.as_ref().filter(|mode| mode.zero_stops() && mode.value.is_some()).map(|mode| mode.setpoint);
        let Some(param) = given.filter(|_| given == stops).map(|id| self.target.family.param_or_unknown(id)) else {
            return;
        };
        let retries = self.session.set_retries(0);
        self.zeroed = self.write_once(&param, 0, 0).await.is_ok().then_some(param.id);
        self.session.set_retries(retries);
    }

    /// What the drive shows of its mode, and which that is; of a family without modes what was set. Asked once: what needs no
    /// mode can stop it too.
    pub(super) async fn mode_shown(&mut self) -> (Option<i64>, Option<Mode>) {
        let family = self.target.family.clone();
        let Some(shows) = family.role("mode-active") else { return (None, self.mode.clone()) };
        let retries = self.session.set_retries(0);
        let value = raw(self.session, self.target, shows, 0).await;
        self.session.set_retries(retries);
        let told = value.ok().flatten();
        (told, family.modes.iter().find(|mode| told.is_some() && mode.value == told).cloned())
    }

    /// Sends a stop once and waits for what proves it. `hurry`: the state must do, the shaft is not waited for.
    async fn try_stop(&mut self, way: StopChoice, hurry: bool, last: bool) -> Result<Proof, Failure> {
        let Some(row) = self.way_to_stop(way).await else {
            let text = both!("no stop '{slug}'", "diesen Halt gibt es nicht: '{slug}'", slug = way.slug());
            return Err(Failure::new(Class::Data, "data.stop", text));
        };
        let state = match self.lever {
            Lever::ControlWord => self.stop_by_commands(&row, last).await?,
            Lever::Contacts => self.open_contacts(way, last).await?,
            Lever::Taken => {
                // Whatever it stands for now, 0 starts nothing.
                self.write_control(0).await?;
                self.zero().await?;
                self.until_still().await?
            }
            Lever::Setpoint => {
                self.zero().await?;
                self.until_still().await?
            }
        };
        let standing = match way {
            _ if hurry => self.stands_now().await,
            StopChoice::Coast => self.coasts_out().await,
            _ => self.standstill().await,
        };
        let owed = !hurry && way != StopChoice::Coast;
        match standing {
            Ok(standing) => Ok(Proof { state, standing, owed }),
            // Without power it is already; nothing stronger makes it stand sooner.
            Err(failure) if failure.class == Class::Interrupted => {
                Ok(Proof { state, standing: self.last_seen(), owed: false })
            }
            Err(failure) => Err(failure),
        }
    }

    /// Opens virtual contacts: for a ramp the start contacts first, because without the enable the power is gone at once
    /// (CM-485 manual 9.1.3); any other stop opens all.
    pub(super) async fn open_contacts(&mut self, way: StopChoice, last: bool) -> Result<State, Failure> {
        let starts = self.target.family.motion.control.map_or(0, |control| control.start_contacts);
        let without = self.word & !starts;
        if way == StopChoice::Ramp && without != 0 {
            let ramped = match self.write_control(without).await {
                Ok(()) => self.until(STOPPED, Some(Takes::Transition5), true).await.map(|_| ()),
                failed => failed,
            };
            match ramped {
                Err(failure) if last && failure.is_unheard() => {}
                ramped => ramped?,
            }
        }
        self.write_control(0).await?;
        self.until(STOPPED, Some(Takes::Transition5), true).await
    }

    async fn stop_by_commands(&mut self, row: &StopRow, last: bool) -> Result<State, Failure> {
        if row.zero {
            match self.ramp_down().await {
                // On a line without answers the commands must go out all the same, in the end.
                Err(failure) if last && failure.is_unheard() => {}
                ramped => ramped?,
            }
        }
        let family = self.target.family.clone();
        let word = |slug: &String| family.machine.command(slug).map(|command| command.word);
        let words: Vec<u16> = match self.seen.as_deref().is_some_and(|state| OFF.contains(&state)) {
            // Any other command would lead up from there.
            true => vec![0],
            false => row.commands.iter().filter_map(word).collect(),
        };
        for (index, word) in words.into_iter().enumerate() {
            if index > 0 {
                self.until_still().await?;
            }
            self.said_quick_stop |= row.slug == "quick-stop";
            self.write_control(word).await?;
        }
        // Looked at behind the commands: on a line without answers they must have gone out.
        if self.state().await?.slug == QUICK_STOP {
            return self.leave_quick_stop().await;
        }
        // A drive that tripped, or that lies in a state below the goal, has no power either.
        let state = self.until(STOPPED, row.takes, true).await?;
        self.notes_lost_power(row, &state);
        Ok(state)
    }

    /// Sets a setpoint of 0 beside the strongest stop that is not obeyed, for a drive that may still obey that. Once: no answer keeps
    /// the stop back.
    async fn zero_besides(&mut self) {
        if self.lever == Lever::Setpoint || self.mode.as_ref().is_some_and(|mode| !mode.zero_stops()) {
            return;
        }
        let Some(param) = self.setpoint.as_ref().map(|setpoint| setpoint.param) else { return };
        let (param, retries) = (self.target.family.param_or_unknown(param), self.session.set_retries(0));
        let _told_by_its_standstill = self.write_once(&param, 0, 0).await;
        self.session.set_retries(retries);
    }

    /// A drive that refuses its control word may still obey its setpoint. Whether its shaft stands then, as far as it tells.
    async fn zero_as_the_last(&mut self) -> Option<bool> {
        let given = self.setpoint.as_ref().map(|setpoint| setpoint.param);
        given.filter(|_| self.mode.as_ref().is_none_or(Mode::zero_stops))?;
        self.zeroed = None;
        self.zero().await.ok()?;
        self.notes.push(both!(
            "it does not obey its control word; the setpoint went to 0 in its place",
            "er befolgt sein Steuerwort nicht; stattdessen ging der Sollwert auf 0"
        ));
        self.standstill().await.ok().flatten()
    }

    async fn ramp_down(&mut self) -> Result<(), Failure> {
        self.zero().await?;
        self.until_still().await.map(|_| ())
    }

    async fn zero(&mut self) -> Result<(), Failure> {
        let given = self.setpoint.as_ref().map(|setpoint| setpoint.param);
        let Some(param) = self.zeroes.or(given) else { return Ok(()) };
        let is_done = self.zeroed.take() == Some(param);
        let param = self.target.family.param_or_unknown(param);
        self.again = Some((param.clone(), 0));
        if is_done { Ok(()) } else { self.write(&param, 0, 0).await }
    }

    /// A quick stop that the drive began by itself, because of its watchdog: no command is obeyed there but the one that
    /// leads out, where the drive does not leave it by itself.
    pub(super) async fn leave_quick_stop(&mut self) -> Result<State, Failure> {
        let family = self.target.family.clone();
        let ways = || family.machine.transitions.iter().filter(|row| row.from == QUICK_STOP);
        if let Some(way) = ways().find(|way| way.command.is_none())
            && let Ok(state) = self.until(STOPPED, way.takes, true).await
        {
            return Ok(state);
        }
        let still = self.until_still().await?;
        let Some(command) = ways().find_map(|way| family.machine.command(way.command.as_ref()?)) else {
            return Ok(still);
        };
        self.write_control(command.word).await?;
        self.until(STOPPED, None, true).await
    }
}

/// States from which a command of a stop would lead up.
const OFF: &[&str] = &["switch-on-disabled", "ready-to-switch-on", "fault", "not-ready"];

#[cfg(test)]
mod tests;

/// A stop of which nothing is known yet; of none at all that it is so.
fn not_yet(choice: StopChoice, because: &'static str) -> Stop {
    let kept = || both!("the drive keeps running, as asked for", "der Antrieb läuft weiter, wie verlangt");
    Stop {
        choice: choice.slug(),
        escalated: None,
        because,
        acknowledged: false,
        standing: None,
        state: None,
        note: (choice == StopChoice::Keep).then(kept),
    }
}
