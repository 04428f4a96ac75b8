//! Operating modes, setpoints and contacts: giving them, waiting until they are reached, and holding a run.

use super::look::raw;
use super::shaft::Watch;
use super::{Lever, Motor, ROUND, state_name};
use crate::drive::describe;
use crate::failure::{Class, Failure};
use crate::outcome::{Decimal, Setpoint, State};
use crate::profile::{Mode, Movement, Param, Start};
use crate::tick::Span;

impl Motor<'_, '_> {
    /// What is going to be set: decides how the run is stopped and when a setpoint is reached.
    pub fn prepare(&mut self, mode: &Mode) {
        self.mode = Some(mode.clone());
    }

    /// Selects the operating mode, if the family has any, proves that it is active, and writes what it needs.
    pub async fn enter(&mut self) -> Result<(), Failure> {
        let Some(mode) = self.mode.clone() else { return Ok(()) };
        let family = self.target.family.clone();
        if let (Some(value), Some(selects), Some(shows)) = (mode.value, family.role("mode"), family.role("mode-active"))
        {
            self.touched = true;
            self.write(selects, 0, value).await?;
            self.until_mode(shows, value, mode.name(self.lang)).await?;
        }
        for preset in &mode.engage {
            self.touched = true;
            self.write(&family.param_or_unknown(preset.param), 0, preset.value).await?;
        }
        Ok(())
    }

    async fn until_mode(&mut self, shows: &Param, value: i64, name: &str) -> Result<(), Failure> {
        let since = self.session.now();
        loop {
            let active = raw(self.session, self.target, shows, 0, self.lang).await?;
            if active == Some(value) {
                return Ok(());
            }
            if self.session.now().since(since) > self.patience {
                let text =
                    self.lang.pick("the drive does not take the mode", "der Antrieb übernimmt die Betriebsart nicht:");
                let failure = Failure::new(Class::Forbidden, "forbidden.mode", format!("{text} '{name}'"));
                return Err(failure.hint(match self.lang {
                    crate::profile::Lang::En => format!("{} must show {value}", shows.label()),
                    crate::profile::Lang::De => format!("{} muss {value} zeigen", shows.label()),
                }));
            }
            self.rest(self.beat).await?;
        }
    }

    /// Writes a parameter that belongs to the setpoint.
    pub async fn set(&mut self, param: &Param, raw: i64) -> Result<(), Failure> {
        self.touched = true;
        self.write(param, 0, raw).await
    }

    /// Gives a setpoint.
    pub async fn give(&mut self, param: &Param, raw: i64, unit: &str) -> Result<(), Failure> {
        self.set(param, raw).await?;
        let value = Decimal { raw, decimals: param.decimals_or_zero() };
        let writes = self.setpoint.as_ref().map_or(0, |setpoint| setpoint.writes) + 1;
        self.setpoint =
            Some(Setpoint { param: param.id, value, unit: unit.to_owned(), writes, reached: None, actual: None });
        Ok(())
    }

    /// Gives the same setpoint again, so that a run that is held keeps saying what it wants.
    pub async fn refresh(&mut self, param: &Param, raw: i64) -> Result<(), Failure> {
        self.write(param, 0, raw).await
    }

    /// Starts the movement to the setpoint, waits for its end, and takes the start back.
    pub async fn travel(&mut self, start: &Start) -> Result<(), Failure> {
        self.write_control(start.word).await?;
        self.until_reached().await?;
        let enable = self.target.family.machine.command("enable").map_or(0, |command| command.word);
        self.write_control(enable).await
    }

    /// Waits until the drive says that the setpoint is reached, as long as the shaft still changes. A drive that shows
    /// its movement only by its position must say so twice: the first time may still be about the setpoint before.
    pub async fn until_reached(&mut self) -> Result<(), Failure> {
        let family = self.target.family.clone();
        let bit = self.mode.as_ref().and_then(|mode| mode.reached).unwrap_or(family.motion.reached);
        let travels = self.mode.as_ref().is_some_and(|mode| !mode.starts.is_empty());
        let looks = if family.motion.movement == Movement::Position { 2 } else { 1 };
        let mut watch = Watch::new(family.motion.movement);
        let (mut seen, mut told) = (None, 0);
        let mut since = self.session.now();
        loop {
            let status = self.status().await?;
            let movement = self.movement().await?;
            let changed = watch.see(self.session.now(), movement);
            let reached = status >> bit & 1 == 1;
            self.note_actual(reached, movement);
            told = if reached && (!travels || looks == 1 || told == 0 || watch.stands()) { told + 1 } else { 0 };
            if told == looks {
                return Ok(());
            }
            if describe::state(&family, status, self.lang).slug.starts_with("fault") {
                return Err(self.fault_failure().await);
            }
            // On its way to a target a shaft may turn evenly for long.
            if changed || seen != Some(status) || (travels && !watch.stands()) {
                seen = Some(status);
                since = self.session.now();
            }
            if self.session.now().since(since) > self.patience {
                let text = self.lang.pick(
                    "the setpoint is not reached and the actual value does not move any more",
                    "der Sollwert wird nicht erreicht und der Istwert bewegt sich nicht mehr",
                );
                let hint = family.motion.not_reached.get(self.lang);
                return Err(Failure::new(Class::No, "no.not_reached", text).hint(hint));
            }
            self.rest(self.beat).await?;
        }
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

    /// Keeps the run alive for a time, or until something ends it: looks at the state, which also feeds the drive's
    /// watchdog, and ends with an error if the drive trips or, having been enabled, is so no longer. `each` is called in every round.
    pub async fn hold(
        &mut self,
        duration: Option<Span>,
        mut each: impl AsyncFnMut(&mut Self, Span) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let begun = self.session.now();
        let mut was_enabled = false;
        loop {
            let gone = self.session.now().since(begun);
            if duration.is_some_and(|duration| gone >= duration) {
                return Ok(());
            }
            each(self, gone).await?;
            let state = self.state().await?;
            match state.slug.as_str() {
                "operation-enabled" => was_enabled = true,
                _ if !was_enabled && !state.slug.starts_with("fault") => {}
                slug if slug.starts_with("fault") => return Err(self.fault_failure().await),
                slug => {
                    let text = self.lang.pick(
                        "the drive left the run by itself; it is now",
                        "der Antrieb ist von selbst ausgestiegen, jetzt:",
                    );
                    let name = state_name(&self.target.family, slug, self.lang);
                    return Err(Failure::new(Class::Forbidden, "forbidden.left_run", format!("{text} {name}")));
                }
            }
            self.rest(self.round(duration, gone)).await?;
        }
    }

    /// Writes virtual contacts.
    pub async fn contacts(&mut self, word: u16) -> Result<(), Failure> {
        self.lever = Lever::Contacts;
        self.write_control(word).await
    }

    /// Keeps virtual contacts closed for a time; ends with an error if the drive trips.
    pub async fn hold_contacts(&mut self, duration: Option<Span>) -> Result<(), Failure> {
        let begun = self.session.now();
        loop {
            let gone = self.session.now().since(begun);
            if duration.is_some_and(|duration| gone >= duration) {
                return Ok(());
            }
            if self.state().await?.slug.starts_with("fault") {
                return Err(self.fault_failure().await);
            }
            self.rest(self.round(duration, gone)).await?;
        }
    }

    async fn state(&mut self) -> Result<State, Failure> {
        let status = self.status().await?;
        Ok(describe::state(&self.target.family, status, self.lang))
    }

    /// The pause before the next round of a run that is held.
    fn round(&self, duration: Option<Span>, gone: Span) -> Span {
        let round = self.beat.times(ROUND);
        duration.map_or(round, |duration| round.min(duration - gone)).max(self.beat)
    }
}
