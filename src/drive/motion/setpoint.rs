//! Giving setpoints and contacts, waiting until they are reached, and holding a run.

use super::{Lever, Motor, POLL, REACHED_BIT, ROUND};
use crate::drive::describe;
use crate::failure::{Class, Failure};
use crate::outcome::{Decimal, Setpoint};
use crate::profile::Param;
use crate::profile::setpoint::DECIMALS;
use crate::tick::Span;

impl Motor<'_, '_> {
    /// Gives a setpoint.
    pub async fn give(&mut self, param: &Param, raw: i64, unit: &str) -> Result<(), Failure> {
        self.touched = true;
        self.write(param, 0, raw).await?;
        let value = Decimal { raw, decimals: DECIMALS };
        let writes = self.setpoint.as_ref().map_or(0, |setpoint| setpoint.writes) + 1;
        self.setpoint =
            Some(Setpoint { param: param.id, value, unit: unit.to_owned(), writes, reached: None, actual: None });
        Ok(())
    }

    /// Gives the same setpoint again, so that a run that is held keeps saying what it wants.
    pub async fn refresh(&mut self, param: &Param, raw: i64) -> Result<(), Failure> {
        self.write(param, 0, raw).await
    }

    /// Waits until the drive says that the setpoint is reached, as long as the actual value still moves.
    pub async fn until_reached(&mut self) -> Result<(), Failure> {
        let mut seen = None;
        let mut since = self.session.now();
        loop {
            let status = self.status().await?;
            let speed = self.speed().await?;
            let decimals = DECIMALS;
            if let Some(setpoint) = &mut self.setpoint {
                setpoint.actual = speed.map(|raw| Decimal { raw, decimals });
                setpoint.reached = Some(status & REACHED_BIT != 0);
            }
            if status & REACHED_BIT != 0 {
                return Ok(());
            }
            if describe::state(&self.target.family, status, self.lang).slug.starts_with("fault") {
                return Err(self.fault_failure().await);
            }
            if seen != Some((status, speed)) {
                seen = Some((status, speed));
                since = self.session.now();
            }
            if self.session.now().since(since) > self.patience {
                let text = self.lang.pick(
                    "the setpoint is not reached and the actual value does not move any more",
                    "der Sollwert wird nicht erreicht und der Istwert bewegt sich nicht mehr",
                );
                return Err(Failure::new(Class::No, "no.not_reached", text).hint(self.lang.pick(
                    "a limit (status bit 11), P.434, P.418/P.419 or P.549 can be the reason",
                    "Ursache kann ein Grenzwert (Statusbit 11), P.434, P.418/P.419 oder P.549 sein",
                )));
            }
            self.rest(POLL).await?;
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
            let status = self.status().await?;
            let state = describe::state(&self.target.family, status, self.lang);
            match state.slug.as_str() {
                "operation-enabled" => was_enabled = true,
                _ if !was_enabled && !state.slug.starts_with("fault") => {}
                slug if slug.starts_with("fault") => return Err(self.fault_failure().await),
                _ => {
                    let text = self.lang.pick(
                        "the drive left the run by itself; it is now",
                        "der Antrieb ist von selbst ausgestiegen, jetzt:",
                    );
                    return Err(Failure::new(Class::Forbidden, "forbidden.left_run", format!("{text} {}", state.name)));
                }
            }
            let rest = duration.map_or(ROUND, |duration| ROUND.min(duration - gone));
            self.rest(rest.max(POLL)).await?;
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
            let status = self.status().await?;
            if describe::state(&self.target.family, status, self.lang).slug.starts_with("fault") {
                return Err(self.fault_failure().await);
            }
            let rest = duration.map_or(ROUND, |duration| ROUND.min(duration - gone));
            self.rest(rest.max(POLL)).await?;
        }
    }
}
