//! What a run that was broken off has left in a drive, for which its record holds what it was before: whoever goes on gives it back,
//! and names what it cannot.

use super::guide::{Deed, Guide, Turn};
use super::record;
use crate::drive::job;
use crate::drive::motion::{has_power, look};
use crate::failure::{Class, Failure};
use crate::outcome::Lent;
use crate::profile::procedure::{Act, Step};
use crate::profile::value::written;
use crate::profile::{DataSets, Family, Need};
use crate::text::{Text, both};

impl Guide<'_> {
    /// Gives back what is noted as lent, if it does not stand there again. Only to a drive without power: a limit that is raised,
    /// or a watchdog that ends, would be a surprise to a shaft that turns.
    pub(super) async fn give_back(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let mut target = self.known().await?;
        self.allow();
        let family = target.family.clone();
        let (mut left, mut steps) = (Vec::new(), Vec::new());
        for lent in self.record.lent.clone().into_iter().rev() {
            let param = family.param_or_unknown(lent.param);
            let set = lent.data_set + if family.link.route.has_data_sets() { DataSets::RAM_OFFSET } else { 0 };
            let told = target.read_set(&mut self.session, &param, set).await;
            let reading = told.map_err(|error| error.failure(target.address, Some(&family)))?;
            if reading.raw != lent.old {
                let before = lent.old;
                let (name, now, old) = (&lent.name, written(&param, reading.raw), written(&param, before));
                left.push(both!("{name} = {now} (was {old})", "{name} = {now} (war {old})"));
                steps.push((lent, job::Step { kind: Some(reading.kind), raw: before, param, set, at: None }));
            }
        }
        let seen = look(&mut self.session, &mut target).await?;
        if !steps.is_empty() && has_power(&seen.state) != Some(false) {
            return Err(powered(&Text::join(&left, ", "), &seen.state));
        }
        let (stays, steps): (Vec<_>, Vec<_>) =
            steps.into_iter().partition(|(lent, _)| may_start(lent, &family, seen.status));
        deed.found.extend(stays.iter().map(|(lent, step)| stays_so(lent, &step.param.label())));
        if !steps.is_empty() {
            let step = self.returning(turn);
            self.write(turn.with(&step), deed, steps.into_iter().map(|(_, step)| step).collect()).await?;
        }
        self.record.lent.clear();
        record::save(&self.path, &self.record)
    }

    fn returning(&self, turn: Turn<'_>) -> Step {
        Step {
            slug: turn.step.slug.clone(),
            act: Act::Confirm,
            drives: Vec::new(),
            title: both!("What a run has left that was broken off", "Was ein abgebrochener Lauf hinterlassen hat"),
            does: both!(
                "It had set this in RAM for its time. It is set back to what its record says of before.",
                "Er hatte das für seine Zeit im RAM gesetzt. Es wird auf das zurückgestellt, was laut Aufzeichnung vorher stand."
            ),
            warning: None,
            source: turn.step.source.clone(),
        }
    }
}

/// Whether the drive may start by its contacts once this goes back.
fn may_start(lent: &Lent, family: &Family, status: u32) -> bool {
    let is_control = family.role("control-mode").is_some_and(|param| param.id == lent.param);
    let obeys = family.motion.control.is_some_and(|control| control.obeys == lent.old);
    let bit = family.motion.interlock(Need::Release).and_then(|row| row.bit);
    is_control && !obeys && bit.is_none_or(|bit| status >> bit & 1 == 1)
}

fn stays_so(lent: &Lent, label: &str) -> Text {
    let Lent { name, old, new, .. } = lent;
    let back = name.trim_start_matches("P.");
    both!(
        "{name} stays {new} (was {old}): enable and start contact are closed and could start the drive; `antrieb write {back}={old}` \
         sets it back, when nothing can start ({label})",
        "{name} bleibt {new} (war {old}): Freigabe und Startkontakt sind geschlossen und könnten den Antrieb starten; `antrieb write \
         {back}={old}` stellt es zurück, wenn nichts anlaufen kann ({label})"
    )
}

fn powered(left: &Text, state: &str) -> Failure {
    let message = both!(
        "a run that was broken off has left {left}; nothing is set back while the drive has power (now '{state}')",
        "ein abgebrochener Lauf hat hinterlassen: {left}; solange der Antrieb Spannung gibt (jetzt '{state}'), wird nichts \
         zurückgestellt",
        left
    );
    Failure::new(Class::Forbidden, "forbidden.powered", message).hint(both!(
        "`antrieb statemachine disable-voltage` takes it",
        "`antrieb statemachine disable-voltage` nimmt sie"
    ))
}
