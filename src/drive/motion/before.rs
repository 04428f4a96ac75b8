//! What stands in a drive from before, and turns the shaft once it is enabled.

use super::has_power;
use super::look::{raw, role_raw, status_word, working};
use super::own::{Promise, shown};
use crate::drive::describe;
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::failure::Failure;
use crate::profile::{Mode, Param};
use crate::text::{Text, both};

/// A setpoint, or the source of one, that stands in the drive from before and turns the shaft once it is enabled.
#[derive(Clone, Debug)]
pub struct Standing {
    /// Parameter that is to be 0.
    pub param: Param,
    /// Parameter that shows it, and what it shows.
    pub shown: (Param, i64),
}

/// Everything that stands in the drive from before.
pub async fn standing(session: &mut Session<'_>, target: &mut Target) -> Result<Vec<Standing>, Failure> {
    let family = target.family.clone();
    let mut found = Vec::new();
    for row in &family.motion.rest {
        let shows = family.param_or_unknown(row.shown.unwrap_or(row.param));
        if let Some(value) = raw(session, target, &shows, 0).await?.filter(|&value| value != 0) {
            found.push(Standing { param: family.param_or_unknown(row.param), shown: (shows, value) });
        }
    }
    Ok(found)
}

/// What the drive does now, told before something is written that can move its shaft; nothing where it does not say. `starts`:
/// what is written may start it, so what it runs at then is told too.
pub async fn present(session: &mut Session<'_>, target: &mut Target, starts: bool) -> Vec<Text> {
    let Ok(status) = status_word(session, target).await else { return Vec::new() };
    let (address, state) = (target.address, describe::state(&target.family, status));
    let name = state.name;
    if has_power(&state.slug) == Some(true) {
        return vec![both!(
            "address {address}: now in {name}, with power: what is written acts at once",
            "Adresse {address}: jetzt in {name}, unter Strom: was geschrieben wird, wirkt sofort",
            name
        )];
    }
    let now = both!("address {address}: now in {name}", "Adresse {address}: jetzt in {name}", name);
    let runs_at = if starts { runs_at(session, target).await.ok() } else { None };
    std::iter::once(now).chain(runs_at.into_iter().flat_map(|(told, _)| told)).collect()
}

/// What the shaft does once it is enabled, in words: what stands there from before and is set to 0 first, and what the
/// drive runs at by its own settings even then; and what of it must still be so when somebody has agreed.
pub async fn upon_enabling(
    session: &mut Session<'_>,
    target: &mut Target,
) -> Result<(Vec<Text>, Vec<Promise>), Failure> {
    let told = standing(session, target).await?.iter().map(Standing::told).collect();
    with_own(session, target, told).await
}

/// The same for contacts that start it: what stands there from before stays.
pub async fn runs_at(session: &mut Session<'_>, target: &mut Target) -> Result<(Vec<Text>, Vec<Promise>), Failure> {
    let mut told = Vec::new();
    for Standing { param, shown: (shows, value) } in standing(session, target).await? {
        let (label, value) = (param.label(), shown(&shows, value));
        told.push(both!("{label} stands at {value}: it runs at that", "{label} steht auf {value}: damit läuft er"));
    }
    with_own(session, target, told).await
}

async fn with_own(
    session: &mut Session<'_>,
    target: &mut Target,
    mut told: Vec<Text>,
) -> Result<(Vec<Text>, Vec<Promise>), Failure> {
    let promises = own_setpoints(session, target).await?;
    told.extend(promises.iter().filter_map(|promise| promise.runs_at(&target.family)));
    Ok((told, promises))
}

/// What the drive runs at by its own settings, whatever the line says.
pub async fn own_setpoints(session: &mut Session<'_>, target: &mut Target) -> Result<Vec<Promise>, Failure> {
    let family = target.family.clone();
    let mut found = Vec::new();
    for mode in family.modes.iter().filter(|mode| mode.source.is_some()) {
        found.push(Promise::read(session, target, mode, &[]).await?);
    }
    Ok(found)
}

/// The setting by which a drive takes another setpoint than that of a mode, from elsewhere, and its value; `None` where it does not, or
/// does not tell. A source of 0 is none.
pub async fn elsewhere(
    session: &mut Session<'_>,
    target: &mut Target,
    mode: &Mode,
) -> Result<Option<(Param, i64)>, Failure> {
    for preset in &mode.engage {
        let param = target.family.param_or_unknown(preset.param);
        let told = raw(session, target, &param, 0).await?;
        if let Some(now) = told.filter(|&now| now != preset.value && now != 0) {
            return Ok(Some((param, now)));
        }
    }
    Ok(None)
}

/// Whether a controller may make the drive's own setpoint of that of a mode.
pub async fn is_controlled(session: &mut Session<'_>, target: &mut Target, mode: &Mode) -> Result<bool, Failure> {
    let Some((modulo, is)) = mode.adds.and_then(|adds| adds.controls) else { return Ok(false) };
    let configuration = role_raw(session, target, "configuration").await?;
    Ok(configuration.and_then(|raw| raw.checked_rem(modulo)) == Some(is))
}

/// Whether a setpoint of zero can only slow the shaft. In its own mode nothing else is left, but where the drive adds a setpoint of its
/// own to it (CM-485 manual 9.2.1): that must not turn the shaft the other way. A drive without power turns nothing.
pub async fn zero_only_slows(
    session: &mut Session<'_>,
    target: &mut Target,
    mode: &Mode,
    state: &str,
) -> Result<bool, Failure> {
    let Some(source) = mode.source.as_ref().filter(|_| state == "operation-enabled") else { return Ok(true) };
    let param = target.family.param_or_unknown(source.param);
    let present = working(session, target, &param).await?;
    if !source.choices.iter().any(|choice| choice.slug == "sum" && Some(choice.value) == present) {
        return Ok(true);
    }
    let internal = role_raw(session, target, "setpoint-internal").await?;
    let line = role_raw(session, target, "setpoint-bus").await?;
    Ok(internal.zip(line).is_some_and(|(internal, line)| internal.signum() * line.signum() >= 0))
}

impl Standing {
    pub(super) fn told(&self) -> Text {
        let (label, value) = (self.param.label(), shown(&self.shown.0, self.shown.1));
        both!(
            "{label} still stands at {value}: it is set to 0 before the drive is enabled",
            "{label} steht noch auf {value}: wird vor der Freigabe auf 0 gesetzt"
        )
    }
}
