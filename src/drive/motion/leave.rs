//! What is known of the drive as the program leaves: only what is reported, and in one short time.

use super::look::{watchdog_seconds, working_raw};
use super::{Motor, Situation};
use crate::drive::describe;
use crate::outcome::Decimal;

impl Motor<'_, '_> {
    /// What the drive says as the program leaves. Where it says nothing more, what was seen last still tells that it was
    /// without power; `None` if nothing does.
    pub async fn leave(&mut self) -> Option<Situation> {
        let status = match (self.status().await, self.shown) {
            (Ok(status), _) => status,
            (Err(failure), Some((status, _))) if self.is_off() => {
                self.tell_lost(&failure);
                status
            }
            _ => return None,
        };
        let state = describe::state(&self.target.family, status).slug;
        // A memory that moves on with every reading is left alone where there is no fault.
        let fault = match state.starts_with("fault") {
            true => self.role_raw("fault").await.ok().flatten(),
            false => Some(0),
        };
        let watchdog_s = self.watchdog_in_force().await;
        Some(Situation { status, state, fault, watchdog_s, ..Situation::default() })
    }

    /// The drive's watchdog as it is now; `None` if that was told at no time.
    async fn watchdog_in_force(&mut self) -> Option<Decimal> {
        let family = self.target.family.clone();
        let param = family.role("watchdog")?.id;
        let changed = self.changes.iter().find(|change| change.param == param);
        let known = changed.map(|change| if change.restored { change.old } else { change.new });
        let raw = match known.or(self.target.known_watchdog) {
            Some(raw) => Some(raw),
            None => working_raw(self.session, self.target, "watchdog").await.ok().flatten(),
        };
        raw.map(|raw| watchdog_seconds(&family, raw))
    }
}
