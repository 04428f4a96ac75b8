//! What a drive says that matters for moving it, and what keeps it from running, in words.

use super::{REMOTE_BIT, STATE_MACHINE, VOLTAGE_BIT};
use crate::drive::describe;
use crate::drive::session::{AccessError, Session};
use crate::drive::transfer::Target;
use crate::failure::{Class, Failure};
use crate::profile::{DataSets, Facts, Lang, Need, NoPlan, Param, Sets};

/// What a drive says that matters for moving it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Situation {
    /// Status word.
    pub status: u32,
    /// Slug of its state; `unknown` if it means none.
    pub state: String,
    /// P.412, as the drive works with it.
    pub mode: Option<i64>,
    /// Fault code.
    pub fault: Option<i64>,
    /// Digital inputs, bit by bit.
    pub inputs: Option<i64>,
    /// P.30.
    pub configuration: Option<i64>,
    /// P.413 in seconds.
    pub watchdog_s: Option<i64>,
    /// P.392.
    pub transition5: Option<i64>,
}

impl Situation {
    /// What the planner looks at. Enable and start contact are seen in the Remote bit, which tells only under P.412 = 1.
    pub fn facts(&self, has_voltage_bit: bool) -> Facts {
        let controlled = self.mode == Some(STATE_MACHINE);
        Facts {
            voltage: has_voltage_bit.then_some(self.status & VOLTAGE_BIT != 0),
            release: controlled.then_some(self.status & REMOTE_BIT != 0),
            positioning: self.configuration.map(|number| number % 100 == 40),
        }
    }
}

pub(super) fn has_voltage_bit(target: &Target) -> bool {
    target.family.machine.transitions.iter().any(|transition| transition.needs.contains(&Need::Voltage))
}

/// What the drive says that matters for moving it.
pub async fn look(session: &mut Session<'_>, target: &mut Target, lang: Lang) -> Result<Situation, Failure> {
    let status = role_raw(session, target, "status-word", lang).await?.unwrap_or(0) as u32;
    let watchdog_s = role_raw(session, target, "watchdog", lang).await?;
    target.known_watchdog = watchdog_s;
    Ok(Situation {
        status,
        state: describe::state(&target.family, status, lang).slug,
        mode: working_raw(session, target, "control-mode", lang).await?,
        fault: role_raw(session, target, "fault", lang).await?,
        inputs: role_raw(session, target, "digital-inputs", lang).await?,
        configuration: role_raw(session, target, "configuration", lang).await?,
        watchdog_s,
        transition5: working_raw(session, target, "transition-5", lang).await?,
    })
}

/// What keeps the drive from running, in words, and how one sees it.
pub fn missing(situation: &Situation, target: &Target, lang: Lang) -> Vec<String> {
    let mut missing = Vec::new();
    let is_acu = has_voltage_bit(target);
    if let Some(mode) = situation.mode.filter(|&mode| mode != STATE_MACHINE) {
        missing.push(match lang {
            Lang::En => format!("P.412 is {mode}: the control word is obeyed only with 1 (--take-control)"),
            Lang::De => format!("P.412 ist {mode}: auf das Steuerwort hört der Antrieb nur bei 1 (--take-control)"),
        });
    }
    let input = |bit: u8| situation.inputs.map(|word| word >> bit & 1 == 1);
    if situation.mode == Some(STATE_MACHINE) && situation.status & REMOTE_BIT == 0 {
        let enable = match (is_acu, lang) {
            (false, Lang::En) => "external enable S1IND (terminal X210A.3)",
            (false, Lang::De) => "externe Freigabe S1IND (Klemme X210A.3)",
            (true, Lang::En) => "external enable STOA and STOB (terminals X210A.3 and X210B.2)",
            (true, Lang::De) => "externe Freigabe STOA und STOB (Klemmen X210A.3 und X210B.2)",
        };
        let start = lang.pick(
            "start contact S2IND or S3IND, or P.68/P.69 set to on",
            "Startkontakt S2IND oder S3IND, oder P.68/P.69 auf Ein",
        );
        let seen = lang.pick("P.250 shows the inputs", "P.250 zeigt die Eingänge");
        let what = match (input(0), input(1).zip(input(2))) {
            (Some(true), Some((false, false))) => start.to_owned(),
            (Some(false), Some((right, left))) if right || left => enable.to_owned(),
            _ => format!("{enable}; {start}"),
        };
        missing.push(format!("{}: {what} ({seen})", lang.pick("Remote bit 9 is 0", "Remote-Bit 9 ist 0")));
    }
    if is_acu && situation.status & VOLTAGE_BIT == 0 {
        missing.push(
            lang.pick(
                "status bit 4 is 0: no mains voltage, only the 24 V supply",
                "Statusbit 4 ist 0: keine Netzspannung, nur die 24-V-Versorgung",
            )
            .to_owned(),
        );
    }
    if let Some(fault) = situation.fault.and_then(|code| describe::fault(&target.family, code as u32, lang)) {
        missing.push(format!("{} {}", fault.key, fault.name));
    }
    missing
}

pub(super) fn no_plan(why: &NoPlan, target: &Target, lang: Lang) -> Failure {
    match why {
        NoPlan::Unreachable { from, goal } => {
            let name = |slug: &str| {
                target
                    .family
                    .states
                    .iter()
                    .find(|row| row.slug == slug)
                    .map_or(slug.to_owned(), |row| row.name(lang).to_owned())
            };
            let text = match lang {
                Lang::En => format!("no command leads from '{}' to '{}'", name(from), name(goal)),
                Lang::De => format!("kein Befehl führt von '{}' nach '{}'", name(from), name(goal)),
            };
            Failure::new(Class::Forbidden, "forbidden.unreachable", text)
        }
        NoPlan::Missing(needs) => {
            let word = |need: &Need| match need {
                Need::Voltage => lang.pick("mains voltage (status bit 4)", "Netzspannung (Statusbit 4)"),
                Need::Release => lang.pick(
                    "external enable and start contact (Remote bit 9)",
                    "externe Freigabe und Startkontakt (Remote-Bit 9)",
                ),
                Need::NoPositioning => lang.pick(
                    "a configuration without positioning (P.30)",
                    "eine Konfiguration ohne Positionierung (P.30)",
                ),
                Need::Lock => lang.pick("15 s since the fault", "15 s seit der Störung"),
            };
            let words: Vec<_> = needs.iter().map(word).collect();
            let text = format!(
                "{}: {}",
                lang.pick("the drive cannot be enabled, missing", "der Antrieb ist nicht freizugeben, es fehlt"),
                words.join(", ")
            );
            let slugs = needs.iter().map(|need| format!("{need:?}").to_lowercase()).collect::<Vec<_>>();
            Failure::new(Class::Forbidden, "forbidden.interlock", text).with("missing", slugs.join(","))
        }
    }
}

/// The raw value of the parameter with a role; `None` if the drive refuses it.
pub async fn role_raw(
    session: &mut Session<'_>,
    target: &mut Target,
    role: &str,
    lang: Lang,
) -> Result<Option<i64>, Failure> {
    let Some(param) = target.family.role(role).cloned() else { return Ok(None) };
    raw(session, target, &param, 0, lang).await
}

/// The raw value that the drive works with: RAM of the active data set.
pub async fn working_raw(
    session: &mut Session<'_>,
    target: &mut Target,
    role: &str,
    lang: Lang,
) -> Result<Option<i64>, Failure> {
    let Some(param) = target.family.role(role).cloned() else { return Ok(None) };
    let set = ram_set(session, target, &param, lang).await?;
    raw(session, target, &param, set, lang).await
}

pub(super) async fn raw(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    set: u8,
    lang: Lang,
) -> Result<Option<i64>, Failure> {
    match target.read_set(session, param, set).await {
        Ok(reading) => Ok(Some(reading.raw)),
        Err(AccessError::Refused(_)) => Ok(None),
        Err(error) => Err(error.failure(target.address, Some(&target.family), lang)),
    }
}

/// The RAM data set in which the drive works with a parameter.
pub(super) async fn ram_set(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    lang: Lang,
) -> Result<u8, Failure> {
    if param.sets != Some(Sets::Four) {
        return Ok(DataSets::RAM_OFFSET);
    }
    let active = role_raw(session, target, "active-set", lang).await?.unwrap_or(1);
    Ok(DataSets::RAM_OFFSET + u8::try_from(active).unwrap_or(1).clamp(1, 4))
}
