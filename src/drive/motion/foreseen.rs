//! What a drive that has its setpoint from several sources runs at once something else is written (CM-485 manual 9.2.1).

use super::look::{raw, role_raw, working};
use super::own::{Total, shown};
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::failure::Failure;
use crate::profile::{DataSets, Mode, Param, Sets};
use crate::text::{Text, both};

/// A value that is going to be written: parameter, data set as on the wire, raw.
type Coming<'c> = (&'c Param, u8, i64);

/// What the shaft turns at behind that, in words, as far as the drive tells what it is formed of; nothing where none of it counts for that.
pub async fn foreseen(
    session: &mut Session<'_>,
    target: &mut Target,
    coming: &[(&Param, u8, i64)],
) -> Result<Vec<Text>, Failure> {
    let family = target.family.clone();
    let selects = family.role("set-selection").map(|param| param.id);
    let mut told = Vec::new();
    for mode in family.modes.iter().filter(|mode| mode.source.is_some()) {
        let floor = mode.floor.as_ref().map(|floor| floor.param);
        let counts = |id: u32| mode.params().chain(floor).any(|param| param == id) || selects == Some(id);
        if coming.iter().any(|(param, ..)| counts(param.id)) {
            told.extend(of_mode(session, target, mode, coming, selects).await?);
        }
    }
    Ok(told)
}

async fn of_mode(
    session: &mut Session<'_>,
    target: &mut Target,
    mode: &Mode,
    coming: &[Coming<'_>],
    selects: Option<u32>,
) -> Result<Option<Text>, Failure> {
    let Some(source) = &mode.source else { return Ok(None) };
    let active = role_raw(session, target, "active-set").await?.unwrap_or(1);
    let selected = coming.iter().find(|(param, ..)| selects == Some(param.id)).map(|(_, _, raw)| *raw);
    let setting = family_param(target, source.param);
    if selected == Some(0) {
        return Ok(Some(both!(
            "the digital inputs select the data set then, and with it what it runs at",
            "die Digitaleingänge wählen dann den Datensatz und damit, womit er läuft"
        )));
    }
    let set = selected.unwrap_or(active);
    let moves = set != active;
    let by = value(session, target, &setting, coming, (set, moves)).await?;
    let chosen = |slug: &str| source.choices.iter().any(|row| row.slug == slug && Some(row.value) == by);
    let (own, line) = (!chosen("line"), by != Some(source.ignored));
    // What shows its own setpoint shows that of the data set in use.
    let added = match mode.adds.map(|adds| family_param(target, adds.param)) {
        Some(shows) if own && !moves => raw(session, target, &shows, 0).await?,
        _ => None,
    };
    let told = match coming.iter().find(|(param, ..)| param.id == mode.setpoint) {
        _ if !line => None,
        Some((_, _, raw)) => Some(*raw),
        None => role_raw(session, target, "setpoint-bus").await?,
    };
    let least = match mode.floor.as_ref().filter(|floor| Some(floor.source) == by) {
        Some(floor) => value(session, target, &family_param(target, floor.param), coming, (set, moves)).await?,
        None => None,
    };
    let limit = match mode.limit {
        Some(limit) => value(session, target, &family_param(target, limit), coming, (set, moves)).await?,
        None => None,
    };
    let is_known = by.is_some() && own == added.is_some() && line == told.is_some();
    let runs_at = Total { added: added.unwrap_or(0), limit, least }.of(told.unwrap_or(0)).filter(|_| is_known);
    let by_setting = format!("{} = {}", setting.label(), by.map_or_else(|| "?".to_owned(), |raw| raw.to_string()));
    Ok(Some(match runs_at {
        Some(sum) => both!(
            "behind that it runs at {sum} when it is enabled ({by_setting})",
            "danach läuft er freigegeben mit {sum} ({by_setting})",
            sum = shown(&family_param(target, mode.setpoint), sum)
        ),
        None => both!(
            "what it runs at behind that is not told before ({by_setting})",
            "womit er danach läuft, wird vorher nicht gesagt ({by_setting})"
        ),
    }))
}

fn family_param(target: &Target, id: u32) -> Param {
    target.family.param_or_unknown(id)
}

/// What a setting is in a data set by then: as it is written, or as it stands in the RAM.
async fn value(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    coming: &[Coming<'_>],
    (set, moves): (i64, bool),
) -> Result<Option<i64>, Failure> {
    let set = u8::try_from(set).unwrap_or(1).clamp(1, 4);
    let ram = DataSets::RAM_OFFSET + set;
    let acts = |at: u8| [0, set, DataSets::RAM_OFFSET, ram].contains(&at);
    if let Some((_, _, raw)) = coming.iter().rev().find(|(written, at, _)| written.id == param.id && acts(*at)) {
        return Ok(Some(*raw));
    }
    match moves && param.sets == Some(Sets::Four) {
        true => raw(session, target, param, ram).await,
        false => working(session, target, param).await,
    }
}
