//! What a run sets besides its setpoint, named before somebody agrees.

use super::Plan;
use crate::drive::motion::{Situation, goes_now, taken_over, would_change};
use crate::drive::{Session, Target};
use crate::failure::Failure;
use crate::profile::{Family, Param};
use crate::text::{Text, both};

impl Plan<'_> {
    /// The control mode that is set for the run.
    pub(super) fn takes(&self, family: &Family) -> Option<i64> {
        let control = family.motion.control.filter(|_| self.args.take_control)?;
        if self.action == "contacts" { Some(control.contacts) } else { self.needs_control.then_some(control.obeys) }
    }

    /// Whether nothing runs on behind it, so that what it sets goes back. A zero that takes another source leaves it: by the old one the shaft
    /// may turn.
    pub(super) fn gives_back(&self) -> bool {
        let stops = self.aim.is_some() && self.sets.is_empty();
        self.args.ends_in_a_stop() || stops || self.action == "reset"
    }

    /// Names every setting that changes for the run, in the order in which they are written, and what becomes of a drive that
    /// somebody else runs.
    pub(super) async fn tells_sets(
        &mut self,
        session: &mut Session<'_>,
        target: &mut Target,
        before: &Situation,
        watchdog: Option<i64>,
    ) -> Result<(), Failure> {
        let family = target.family.clone();
        let takes = self.takes(&family);
        if let Some(told) =
            takes.and_then(|new| taken_over(before, &family, new, self.runs)).filter(|_| self.aim.is_none())
        {
            let told = std::iter::once(told).chain(goes_now(session, target).await?).collect();
            self.tells(session, told);
        }
        let of = |role: &str, raw: Option<i64>| family.role(role).cloned().zip(raw);
        let first = [of("watchdog", watchdog), of("control-mode", takes)];
        let sets: Vec<(Param, i64)> = first.into_iter().flatten().chain(self.sets.iter().cloned()).collect();
        for (param, new) in sets {
            if let Some((name, old, new)) = would_change(session, target, &param, new).await? {
                let then = self.then(family.link.route.has_data_sets());
                // Contacts that are closed would start it.
                let may_stay = self.gives_back() && family.role("control-mode").is_some_and(|mode| mode.id == param.id);
                let where_idle = both!(" where that starts nothing", ", wo das nichts startet");
                let then = if may_stay { Text::join([&then, &where_idle], "") } else { then };
                self.details.push(both!("{name}: {old} -> {new}, {then}", "{name}: {old} -> {new}, {then}", then));
            }
        }
        Ok(())
    }

    /// Where it is set, and for how long.
    fn then(&self, ram: bool) -> Text {
        match (ram, self.gives_back()) {
            (true, true) => both!("in RAM, given back at the end", "im RAM, am Ende zurückgegeben"),
            (true, false) => both!("in RAM, and stays so", "im RAM, und bleibt so"),
            (false, true) => both!("given back at the end", "am Ende zurückgegeben"),
            (false, false) => both!("and stays so", "und bleibt so"),
        }
    }
}
