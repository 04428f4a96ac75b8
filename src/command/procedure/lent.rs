//! What a run that was broken off has left in a drive, for which its record holds what it was before and what the run has set: whoever
//! goes on gives back what still stands as the run has set it, and names what does not.

use super::guide::{Deed, Guide, Turn};
use super::held::held;
use super::record;
use crate::drive::motion::{has_power, look};
use crate::drive::{Reading, Target, job};
use crate::failure::{Class, Failure};
use crate::outcome::{Left, Lent, ProcedureRecord, Warning};
use crate::profile::procedure::{Act, Step};
use crate::profile::value::written;
use crate::profile::{DataSets, Family, Need, Param};
use crate::text::{Text, both};

/// What stands in a drive of what was lent.
#[derive(Default)]
struct Found {
    /// As a run has set it: it goes back.
    ours: Vec<(Lent, job::Step)>,
    /// The same in words.
    told: Vec<Text>,
    /// Neither so nor as before.
    left: Vec<Left>,
}

impl Guide<'_> {
    /// Gives back what is noted as lent, where it stands as a run has set it. Only to a drive without power: a limit that is raised,
    /// or a watchdog that ends, would be a surprise to a shaft that turns. What stands otherwise is somebody else's, and is left alone.
    pub(super) async fn give_back(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let mut target = self.known().await?;
        self.allow();
        let family = target.family.clone();
        held(&self.path, &self.record, self.procedure, &family)?;
        let found = self.stands(&mut target).await?;
        let seen = look(&mut self.session, &mut target).await?;
        if !found.ours.is_empty() && has_power(&seen.state) != Some(false) {
            return Err(powered(&Text::join(&found.told, ", "), &seen.state));
        }
        let (stays, goes): (Vec<_>, Vec<_>) =
            found.ours.into_iter().partition(|(lent, _)| may_start(lent, &family, seen.status));
        if !goes.is_empty() {
            let step = self.returning(turn);
            self.write(turn.with(&step), deed, goes.into_iter().map(|(_, step)| step).collect()).await?;
        }
        self.record.lent = stays.into_iter().rev().map(|(lent, _)| Lent { stays: true, ..lent }).collect();
        let known = self.still_left(&mut target).await?;
        let told = found.left.iter().map(|Left { name, stands, stood, .. }| otherwise(name, stands, stood));
        let told: Vec<Text> = told.collect();
        self.record.left = known.into_iter().chain(found.left).collect();
        record::save(&self.path, &self.record)?;
        if told.is_empty() { Ok(()) } else { Err(left_alone(&Text::join(&told, ", "), &self.record.left)) }
    }

    /// Reads what was lent where it was set.
    async fn stands(&mut self, target: &mut Target) -> Result<Found, Failure> {
        let mut found = Found::default();
        for lent in self.record.lent.clone().into_iter().rev() {
            let (param, set) = placed(&target.family, lent.param, lent.data_set);
            let reading = self.reads(target, &param, set).await?;
            let (now, before) = (reading.raw, lent.old);
            if now == before {
                continue;
            }
            if !lent.is_left(now) {
                let Lent { param: number, name, data_set, old, stood, .. } = lent;
                let stands = written(&param, now);
                found.left.push(Left { param: number, name, data_set, old, stood, now, stands });
                continue;
            }
            found.told.push(otherwise(&lent.name, &written(&param, now), &lent.stood));
            found.ours.push((lent, job::Step { kind: Some(reading.kind), raw: before, param, set, at: None }));
        }
        Ok(found)
    }

    /// What was left alone before and does not stand again as it was.
    async fn still_left(&mut self, target: &mut Target) -> Result<Vec<Left>, Failure> {
        let mut still = Vec::new();
        for left in self.record.left.clone() {
            let (param, set) = placed(&target.family, left.param, left.data_set);
            let now = self.reads(target, &param, set).await?.raw;
            still.extend((now != left.old).then(|| Left { now, stands: written(&param, now), ..left }));
        }
        Ok(still)
    }

    async fn reads(&mut self, target: &mut Target, param: &Param, set: u8) -> Result<Reading, Failure> {
        let told = target.read_set(&mut self.session, param, set).await;
        told.map_err(|error| error.failure(target.address, Some(&target.family)))
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

/// A parameter, and the data set of its RAM.
fn placed(family: &Family, param: u32, data_set: u8) -> (Param, u8) {
    let ram = if family.link.route.has_data_sets() { DataSets::RAM_OFFSET } else { 0 };
    (family.param_or_unknown(param), data_set + ram)
}

/// Whether the drive may start by its contacts once this goes back.
fn may_start(lent: &Lent, family: &Family, status: u32) -> bool {
    let is_control = family.role("control-mode").is_some_and(|param| param.id == lent.param);
    let obeys = family.motion.control.is_some_and(|control| control.obeys == lent.old);
    let bit = family.motion.interlock(Need::Release).and_then(|row| row.bit);
    is_control && !obeys && bit.is_none_or(|bit| status >> bit & 1 == 1)
}

/// What the record that is replaced still had to give back: nobody does that any more.
pub(super) fn forgotten(replaced: &ProcedureRecord) -> Option<Warning> {
    let rows = replaced.lent.iter().map(|lent| (&lent.name, &lent.stood));
    let rows = rows.chain(replaced.left.iter().map(|left| (&left.name, &left.stood)));
    let told = rows.map(|(name, stood)| format!("{name} = {stood}")).collect::<Vec<_>>().join(", ");
    let message = both!(
        "the record that was replaced had not given everything back; before its procedure this stood in its drive: {told}",
        "die ersetzte Aufzeichnung hatte noch nicht alles zurückgegeben; vor ihrer Prozedur stand in ihrem Antrieb: {told}"
    );
    (!told.is_empty()).then(|| Warning { code: "procedure.forgotten".to_owned(), message })
}

/// What stands in the place of what was lent.
fn otherwise(name: &str, stands: &str, stood: &str) -> Text {
    both!("{name} = {stands} (was {stood})", "{name} = {stands} (war {stood})")
}

fn left_alone(told: &Text, left: &[Left]) -> Failure {
    let message = both!(
        "left alone: {told}; a run that was broken off had changed it, but what stands there now is not what it had set: somebody else has \
         set it since, the drive has restarted, or it is another one",
        "nicht angerührt: {told}; ein abgebrochener Lauf hatte das geändert, aber was jetzt dort steht, hat nicht er gesetzt: jemand \
         anderes hat es seitdem gestellt, der Antrieb ist neu gestartet, oder es ist ein anderer",
        told
    );
    let back = left.iter().map(|left| format!("{}={}", left.name.trim_start_matches("P."), left.stood));
    let back = back.collect::<Vec<_>>().join(" ");
    Failure::new(Class::Partial, "partial.not_given_back", message).hint(both!(
        "see that it is the right drive and what its values are to be; `antrieb write {back}` sets what stood before",
        "nachsehen, ob es der richtige Antrieb ist und was gelten soll; `antrieb write {back}` stellt her, was vorher stand"
    ))
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
