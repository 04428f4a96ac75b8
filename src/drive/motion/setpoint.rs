//! Operating modes, setpoints and contacts: giving them, waiting until they are reached, and holding a run.

use super::before::{Standing, standing};
use super::look::{raw, working_raw};
use super::own::{otherwise, shown};
use super::shaft::Watch;
use super::walk::NOT_OBEYED;
use super::{Lever, Motor};
use crate::drive::describe;
use crate::drive::trouble::TIME_OVER;
use crate::failure::{Class, Failure};
use crate::outcome::{Decimal, Setpoint};
use crate::profile::{Control, Mode, Movement, Param, Start};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};

/// How far the ramp may be from its goal and still be there, raw: a source that is added may be an analog one.
const RAMP_BAND: u64 = 10;
/// How far the actual value may be from its goal and still be there, at least, raw: a motor under load slips.
const NEAR: u64 = 100;
/// A setpoint that acts late leaves the bit of the one before standing: so long it must stand that never fell.
const LAG: Span = Span::from_secs(1);
/// How often a run looks whether it still has control: somebody else may change that, and the status word does not always
/// tell.
const CONTROL_LOOKS: Span = Span::from_secs(1);

/// The drive left the run by itself.
const LEFT_RUN: &str = "forbidden.left_run";

impl Motor<'_, '_> {
    /// What is going to be set: decides how the run is stopped and when a setpoint is reached.
    pub fn prepare(&mut self, mode: &Mode) {
        self.mode = Some(mode.clone());
    }

    /// Takes away what stands in the drive from before and would turn the shaft as soon as it is enabled.
    pub(super) async fn clear(&mut self) -> Result<(), Failure> {
        for row in standing(self.session, self.target).await? {
            let Standing { param, shown } = &row;
            // What this run has given itself was agreed to.
            if self.again.as_ref().is_some_and(|(given, raw)| given.id == param.id && *raw == shown.1) {
                continue;
            }
            let sent = self.write(param, 0, 0).await;
            let left = match param.id == shown.0.id {
                true => raw(self.session, self.target, param, 0).await?,
                // What shows it may show more than that.
                false => sent.is_err().then_some(shown.1),
            };
            if left.is_some_and(|left| left != 0) {
                let text = both!(
                    "what stands in the drive would turn the shaft as soon as it is enabled, and cannot be set to 0: \
                     {label}",
                    "was im Antrieb steht, würde die Welle mit der Freigabe drehen und lässt sich nicht auf 0 \
                     setzen: {label}",
                    label = param.label()
                );
                let failure = Failure::new(Class::Forbidden, "forbidden.standing_setpoint", text);
                return Err(failure.with("param", param.id));
            }
            self.notes.push(row.told());
        }
        Ok(())
    }

    /// Selects the operating mode, if the family has any, and proves that it is active.
    pub async fn enter(&mut self) -> Result<(), Failure> {
        let Some(mode) = self.mode.clone() else { return Ok(()) };
        let family = self.target.family.clone();
        if let (Some(value), Some(selects), Some(shows)) = (mode.value, family.role("mode"), family.role("mode-active"))
        {
            // 0 is no mode that could be given back.
            self.touched = true;
            let is_mode = |old| family.modes.iter().any(|mode| mode.value == Some(old));
            self.remember_if(selects, 0, value, is_mode).await?;
            self.write(selects, 0, value).await?;
            self.until_mode((selects, shows), value, &mode.text()).await?;
        }
        Ok(())
    }

    /// Writes what makes the setpoint of the mode count: the shaft turns from there on, unless it stands at 0.
    pub async fn make_it_count(&mut self) -> Result<(), Failure> {
        let Some(mode) = self.mode.clone() else { return Ok(()) };
        for preset in &mode.engage {
            let param = self.target.family.param_or_unknown(preset.param);
            self.touched = true;
            self.remember(&param, 0, preset.value).await?;
            if !mode.zero {
                self.may_turn();
            }
            self.write(&param, 0, preset.value).await?;
        }
        Ok(())
    }

    /// Waits until the drive shows the mode that was selected. Somebody else may select another one meanwhile, in which its shaft turns.
    async fn until_mode(&mut self, (selects, shows): (&Param, &Param), value: i64, name: &Text) -> Result<(), Failure> {
        let (wait, begun) = (self.wait(), self.session.now());
        let mut first = None;
        loop {
            self.demand_time()?;
            self.look_on().await?;
            let active = raw(self.session, self.target, shows, 0).await?;
            if active == Some(value) {
                self.entered = true;
                return Ok(());
            }
            // No manual says that a drive tells what was written, nor how soon: that it tells otherwise than before is what counts.
            let now = (raw(self.session, self.target, selects, 0).await?, active);
            let is_another = now.0 == now.1 && self.session.now().since(begun) >= LAG;
            let has_changed = now != *first.get_or_insert(now);
            if let Some(other) = now.0.filter(|other| *other != value && (is_another || has_changed)) {
                return Err(mode_of_others(selects, name, other));
            }
            if wait.is_over(self.session.now()) {
                let text = both!(
                    "the drive does not take the mode '{name}'",
                    "der Antrieb übernimmt die Betriebsart nicht: '{name}'",
                    name
                );
                let label = shows.label();
                return Err(Failure::new(Class::Forbidden, "forbidden.mode", text)
                    .hint(both!("{label} must show {value}", "{label} muss {value} zeigen")));
            }
            self.rest(self.beat()).await?;
        }
    }

    /// Writes a parameter that belongs to the setpoint; it is given back at the end of a run that is bounded.
    pub async fn set(&mut self, param: &Param, raw: i64) -> Result<(), Failure> {
        self.touched = true;
        self.sight.forget();
        self.still = None;
        self.write(param, 0, raw).await
    }

    /// Gives a setpoint.
    pub async fn give(&mut self, param: &Param, raw: i64, unit: &str) -> Result<(), Failure> {
        let before = self.setpoint.take();
        let value = Decimal { raw, decimals: param.decimals_or_zero() };
        let makes = self.expects.filter(|makes| makes.0 == raw).map(|makes| makes.1);
        let effective = makes.map(|raw| Decimal { raw, ..value });
        let writes = before.as_ref().map_or(0, |setpoint| setpoint.writes) + 1;
        self.setpoint = Some(Setpoint {
            param: param.id,
            value,
            denominator: None,
            effective,
            unit: unit.to_owned(),
            writes,
            reached: None,
            actual: None,
        });
        self.again = Some((param.clone(), raw));
        if raw != 0 {
            self.may_turn();
        }
        let given = self.set(param, raw).await;
        match &given {
            Err(failure) if failure.class == Class::Refused => (self.setpoint, self.again) = (before, None),
            // It counts as written: it may stand in the drive.
            Err(_) => self.notes.push(both!(
                "whether {label} was written is not known",
                "ob {label} geschrieben wurde, ist unbekannt",
                label = param.label()
            )),
            Ok(()) => {
                let change = self.changes.iter_mut().find(|change| change.param == param.id);
                change.into_iter().for_each(|change| change.new = raw);
            }
        }
        given
    }

    /// Sends nothing for a time, as if this program were gone; whoever interrupts ends it.
    pub async fn say_nothing(&mut self, span: Span) -> Result<(), Failure> {
        self.rest(span).await
    }

    /// The time of the line.
    pub fn now(&self) -> Tick {
        self.session.now()
    }

    /// Gives the same setpoint again, so that a run that is held keeps saying what it wants.
    pub async fn refresh(&mut self, param: &Param, raw: i64) -> Result<(), Failure> {
        self.again = Some((param.clone(), raw));
        self.write(param, 0, raw).await
    }

    /// Starts the movement to the setpoint, waits for its end, and takes the start back. A run that is bounded ends by then, wherever
    /// the shaft is.
    pub async fn travel(&mut self, start: &Start) -> Result<(), Failure> {
        // Once only: the second time could be another movement.
        self.touched = true;
        self.may_turn();
        self.write_once(&self.control_word()?, 0, start.word.into()).await?;
        let by = self.end();
        if by.is_some() {
            self.tell_held();
            self.comes_to("held", by);
        }
        match self.until_reached().await {
            // The stop takes the start back.
            Err(failure) if self.session.is_over() && (failure.is_unheard() || failure.code == TIME_OVER) => {
                self.notes.push(both!(
                    "the movement was not at its end when --duration was over",
                    "die Fahrt war nicht zu Ende, als --duration um war"
                ));
                return Ok(());
            }
            reached => reached?,
        }
        let enable = self.target.family.machine.command("enable").map_or(0, |command| command.word);
        let said = self.write_control(enable).await;
        self.or_over(said)
    }

    /// Waits until the drive says that the setpoint is reached, as long as the shaft still changes. A drive that shows
    /// its movement only by its position must say so twice: the first time may still be about the setpoint before.
    pub async fn until_reached(&mut self) -> Result<(), Failure> {
        let family = self.target.family.clone();
        let bit = self.mode.as_ref().and_then(|mode| mode.reached).unwrap_or(family.motion.reached);
        let travels = self.mode.as_ref().is_some_and(|mode| !mode.starts.is_empty());
        let looks = if family.motion.movement == Movement::Position { 2 } else { 1 };
        let mut watch = Watch::new(family.motion.movement);
        let (mut seen, mut told, mut since) = (None, 0, Tick::ZERO);
        let (mut wait, mut fell) = (self.wait(), self.session.now());
        let mut has_fallen = travels || looks == 1;
        loop {
            self.demand_time()?;
            let status = self.look_on().await?;
            let shown = self.heard;
            // A movement shows "reached" in the modes of others as well.
            if status >> bit & 1 == 0 || travels {
                self.stays_on_course().await?;
            }
            let movement = self.movement().await?;
            if status >> bit & 1 == 0 {
                (fell, has_fallen) = (self.session.now(), true);
            }
            let changed = watch.see(self.session.now(), movement).changes;
            // The drive's own band may be wide: what its ramp asks for must be what it will run at.
            let reached = status >> bit & 1 == 1 && self.ramp_is_through().await?;
            self.note_actual(reached, movement);
            let is_there = reached && self.is_near(movement);
            told = if is_there && (!travels || looks == 1 || told == 0 || watch.stands()) { told + 1 } else { 0 };
            if told <= 1 {
                since = shown;
            }
            let is_told = told >= looks && (has_fallen || self.session.now().since(fell) >= LAG);
            if is_told {
                self.begins_there(since);
                return Ok(());
            }
            // On its way to a target a shaft may turn evenly for long.
            if changed || seen != Some(status) || (travels && !watch.stands()) {
                seen = Some(status);
                wait.renew(self.session.now());
            }
            if wait.is_over(self.session.now()) {
                if reached && !is_there {
                    return Err(self.in_its_band_only());
                }
                let text = both!(
                    "the setpoint is not reached and the actual value does not move any more",
                    "der Sollwert wird nicht erreicht und der Istwert bewegt sich nicht mehr"
                );
                return Err(Failure::new(Class::No, "no.not_reached", text).hint(family.motion.not_reached.clone()));
            }
            self.rest(self.beat()).await?;
        }
    }

    /// What is on another way has not reached its setpoint.
    async fn stays_on_course(&mut self) -> Result<(), Failure> {
        let looked = self.bear(async |motor: &mut Self| motor.look_at_course(Span::ZERO, None).await).await;
        if let (Err(_), Some(setpoint)) = (&looked, &mut self.setpoint) {
            setpoint.reached = Some(false);
        }
        looked
    }

    /// The failure of a setpoint that the drive's own limits make another one.
    pub fn bent(&self, told: i64, runs_at: i64) -> Failure {
        let family = &self.target.family;
        let param = self.setpoint.as_ref().and_then(|setpoint| family.param(setpoint.param));
        let value = |raw: i64| param.map_or_else(|| raw.to_string(), |param| shown(param, raw));
        let (told, runs_at) = (value(told), value(runs_at));
        let text = both!(
            "{told} is not reached: by its own limits the drive runs at {runs_at}",
            "{told} wird nicht erreicht: durch seine Grenzen läuft der Antrieb mit {runs_at}"
        );
        Failure::new(Class::No, "no.not_reached", text).hint(family.motion.not_reached.clone())
    }

    /// Whether the ramp asks for what the drive will run at, as far as both are known.
    async fn ramp_is_through(&mut self) -> Result<bool, Failure> {
        let Some((_, goal)) = self.expects else { return Ok(true) };
        let ramp = self.bear(async |motor: &mut Self| motor.role_raw("setpoint-ramp").await).await?;
        Ok(ramp.is_none_or(|ramp| ramp.abs_diff(goal) <= (goal.unsigned_abs() / 500).max(RAMP_BAND)))
    }

    /// Whether the actual value is near what the drive will run at, as far as both are known: its own band may be wide.
    fn is_near(&self, movement: Option<i64>) -> bool {
        let family = &self.target.family;
        let scale = |param: &Param| (param.unit.clone(), param.decimals_or_zero());
        let given = self.setpoint.as_ref().and_then(|setpoint| family.param(setpoint.param)).map(scale);
        let is_alike = family.motion.movement == Movement::Speed && family.role("movement").map(scale) == given;
        let known = self.expects.map(|(_, goal)| goal).zip(movement).filter(|_| is_alike);
        known.is_none_or(|(goal, raw)| raw.abs_diff(goal) <= (goal.unsigned_abs() / 10).max(NEAR))
    }

    /// The shaft does not come nearer, and the drive calls that reached: its own band is wide.
    fn in_its_band_only(&mut self) -> Failure {
        let family = self.target.family.clone();
        let actual = self.setpoint.as_ref().and_then(|setpoint| setpoint.actual).map_or(0, |actual| actual.raw);
        let actual = family.role("movement").map(|param| shown(param, actual)).unwrap_or_default();
        if let Some(setpoint) = &mut self.setpoint {
            setpoint.reached = Some(false);
        }
        let text = both!(
            "the setpoint is not reached: the shaft stays at {actual}, and that the drive calls it reached is its own wide band \
             ({label})",
            "der Sollwert wird nicht erreicht: die Welle bleibt bei {actual}; erreicht nennt ihn der Antrieb nur, weil sein eigenes \
             Band so weit ist ({label})",
            label = family.role_label("control-deviation")
        );
        Failure::new(Class::No, "no.not_reached", text).hint(family.motion.not_reached.clone())
    }

    /// A position is no actual value of a speed or a current.
    fn note_actual(&mut self, reached: bool, movement: Option<i64>) {
        let shown = self.target.family.role("movement").map(|param| param.decimals_or_zero());
        let is_speed = self.target.family.motion.movement == Movement::Speed;
        let Some(setpoint) = &mut self.setpoint else { return };
        setpoint.reached = Some(reached);
        if let (Some(raw), Some(decimals), true) = (movement, shown, is_speed) {
            setpoint.actual = Some(Decimal { raw, decimals });
        }
    }

    /// The status of a drive that runs or is about to, and now and then who has control.
    pub(super) async fn look_on(&mut self) -> Result<u32, Failure> {
        let status = self.works_on().await?;
        if self.enabled {
            self.mind_control().await?;
        }
        Ok(status)
    }

    /// The status of a drive that runs or is about to; an error if it tripped or, having been enabled, is so no longer:
    /// then the run is over, before the enable comes back and the shaft runs up by itself.
    async fn works_on(&mut self) -> Result<u32, Failure> {
        let status = self.status().await?;
        let state = describe::state(&self.target.family, status);
        match state.slug.as_str() {
            "operation-enabled" => {
                self.enabled = true;
                if self.lever == Lever::ControlWord && self.is_remote(status).is_some_and(|remote| self.lost(remote)) {
                    return Err(self.taken().await);
                }
            }
            slug if slug.starts_with("fault") => return Err(self.fault_failure().await),
            _ if !self.enabled => {}
            _ => {
                let text = both!(
                    "the drive left the run by itself; it is now {state}",
                    "der Antrieb ist von selbst ausgestiegen, jetzt: {state}",
                    state = state.name
                );
                // Why is asked once the stop is out: the enable may come back meanwhile.
                return Err(Failure::new(Class::Forbidden, LEFT_RUN, text));
            }
        }
        Ok(status)
    }

    /// Adds to a failure what keeps a drive from running that left the run by itself, or does not go where it is told.
    pub(super) async fn explained(&mut self, failure: Failure) -> Failure {
        let asks = failure.code == LEFT_RUN || (self.relieving.is_some() && failure.code == NOT_OBEYED);
        if asks { self.with_what_is_missing(failure).await } else { failure }
    }

    /// Asks now and then who has control. That no answer comes is for the look at the state to judge.
    async fn mind_control(&mut self) -> Result<(), Failure> {
        let now = self.session.now();
        let Some(control) = self.target.family.motion.control else { return Ok(()) };
        let ours = match self.lever {
            Lever::ControlWord => control.obeys,
            Lever::Contacts => control.contacts,
            Lever::Setpoint | Lever::Taken => return Ok(()),
        };
        if now.since(self.minded) < CONTROL_LOOKS {
            return Ok(());
        }
        self.minded = now;
        let retries = self.session.set_retries(0);
        let mode = working_raw(self.session, self.target, "control-mode").await;
        self.session.set_retries(retries);
        match mode {
            Ok(Some(mode)) if mode != ours => Err(self.taken().await),
            // A lost port and an interrupt are there for the next question as well.
            _ => Ok(()),
        }
    }

    /// Whether the drive no longer obeys the control word; notes that it does.
    fn lost(&mut self, remote: bool) -> bool {
        self.remote |= remote;
        self.remote && !remote
    }

    /// Whether control was taken away where the status word does not tell: it shows Remote for contacts as well.
    pub(super) async fn was_taken(&mut self) -> bool {
        let Some(control) = self.target.family.motion.control else { return false };
        let taken = self.mode_in_force().await.is_some_and(|mode| mode != control.obeys);
        if taken {
            let failure = self.taken().await;
            self.notes.push(failure.told());
        }
        taken
    }

    /// What the drive takes its control word for, and nothing besides: a stop may wait for that.
    async fn mode_in_force(&mut self) -> Option<i64> {
        working_raw(self.session, self.target, "control-mode").await.ok().flatten()
    }

    /// Control was taken away, such as by another data set: who has it now decides what can still be done.
    async fn taken(&mut self) -> Failure {
        let mode = self.mode_in_force().await;
        let family = self.target.family.clone();
        let is = |with: fn(&Control) -> i64| family.motion.control.is_some_and(|control| mode == Some(with(&control)));
        self.lever = match () {
            () if is(|control| control.contacts) => Lever::Contacts,
            () if is(|control| control.obeys) => Lever::ControlWord,
            () => Lever::Taken,
        };
        let label = family.role_label("control-mode");
        let mode = mode.map_or_else(|| "?".to_owned(), |mode| mode.to_string());
        let text = match self.lever {
            Lever::ControlWord => both!(
                "control was changed in the run: {label} in force is {mode}, so contacts by the line are not obeyed",
                "die Steuerung wurde im Lauf umgestellt: {label} wirkt mit {mode}, Kontakte über die Leitung also nicht"
            ),
            _ => both!(
                "control was taken away in the run: {label} in force is {mode}, so the control word is not obeyed",
                "die Steuerung wurde im Lauf entzogen: {label} wirkt mit {mode}, das Steuerwort also nicht"
            ),
        };
        Failure::new(Class::Forbidden, "forbidden.control_taken", text).hint(both!(
            "another data set is active? `dataset` shows it; --take-control takes control in the one that is",
            "ein anderer Datensatz aktiv? `dataset` zeigt ihn; --take-control übernimmt im aktiven"
        ))
    }

    /// Writes virtual contacts.
    pub async fn contacts(&mut self, word: u16) -> Result<(), Failure> {
        self.lever = Lever::Contacts;
        self.write_control(word).await
    }
}

/// Somebody else has selected a mode, in which the shaft turns by a setpoint that nobody agreed to.
fn mode_of_others(selects: &Param, name: &Text, now: i64) -> Failure {
    otherwise(both!(
        "somebody else has selected another mode than '{name}': {label} = {now}",
        "jemand anderes hat eine andere Betriebsart gewählt als '{name}': {label} = {now}",
        name,
        label = selects.label()
    ))
}
