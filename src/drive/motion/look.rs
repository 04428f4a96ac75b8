//! What a drive says that matters for moving it, and what keeps it from running, in words.

use super::shaft::Watch;
use crate::drive::access::{AccessError, Refusal};
use crate::drive::describe;
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::drive::transfer::Reading;
use crate::failure::{Class, Failure};
use crate::outcome::Decimal;
use crate::profile::value::format_decimal;
use crate::profile::{DataSets, DriveState, Facts, Family, Interlock, Mode, NoPlan, Param, Sets};
use crate::text::{Text, both};
use crate::tick::Span;
use std::collections::BTreeMap;

/// A shaft that still moves after so many looks turns.
const TURN_LOOKS: u8 = 14;
/// Pause between them.
const TURN_BEAT: Span = Span::from_millis(20);

/// What a drive says that matters for moving it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Situation {
    /// Status word.
    pub status: u32,
    /// Slug of its state; `unknown` if it means none.
    pub state: String,
    /// Who controls it, as it works with it; `None` if it does not say so, or has no such setting.
    pub mode: Option<i64>,
    /// Code of the fault that is present; 0 is none, `None` could not be read.
    pub fault: Option<i64>,
    /// Digital inputs, bit by bit.
    pub inputs: Option<i64>,
    /// Settings that can stand in the way, by role.
    pub settings: BTreeMap<String, i64>,
    /// The drive's watchdog in seconds; 0 is off.
    pub watchdog_s: Option<Decimal>,
}

impl Situation {
    /// Whether the control word is obeyed, as far as the drive says so.
    pub fn obeys(&self, family: &Family) -> bool {
        family.motion.control.is_none_or(|control| self.mode == Some(control.obeys))
    }

    /// What the planner looks at.
    pub fn facts(&self, family: &Family) -> Facts {
        Facts::lacking(family.motion.interlocks.iter().filter(|row| self.lacks(row, family)).map(|row| row.need))
    }

    pub(super) fn lacks(&self, row: &Interlock, family: &Family) -> bool {
        let bit = row.bit.is_some_and(|bit| self.status >> bit & 1 == 0);
        let setting = row.setting.as_ref().is_some_and(|setting| {
            self.settings.get(&setting.role).is_some_and(|value| value % setting.modulo == setting.not)
        });
        let tells = !row.controlled || self.obeys(family);
        tells && (bit || setting)
    }

    /// Which inputs of an interlock are open, where nobody obeys the control word and so the status word tells nothing of it.
    pub(super) fn open(&self, row: &Interlock, family: &Family) -> Option<Text> {
        let word = self.inputs.filter(|_| row.controlled && !self.obeys(family))?;
        let is_open = |inputs: &[u8]| !inputs.iter().any(|bit| word >> bit & 1 == 1);
        let open: Vec<_> = row.parts.iter().filter(|part| is_open(&part.inputs)).map(|part| part.text()).collect();
        (!open.is_empty()).then(|| Text::join(&open, "; "))
    }

    /// What is missing behind an interlock, and where one sees it.
    pub(super) fn told(&self, row: &Interlock) -> Option<Text> {
        let missing = row.missing.clone()?;
        let given = |inputs: &[u8]| self.inputs.is_none_or(|word| inputs.iter().any(|bit| word >> bit & 1 == 1));
        let mut parts: Vec<_> = row.parts.iter().filter(|part| !given(&part.inputs)).collect();
        if parts.is_empty() {
            parts.extend(&row.parts);
        }
        if parts.is_empty() {
            return Some(missing);
        }
        let parts: Vec<_> = parts.iter().map(|part| part.text()).collect();
        let seen = row.seen.as_ref().map_or_else(Text::default, |seen| both!(" ({seen})", " ({seen})", seen));
        let parts = Text::join(&parts, "; ");
        Some(both!("{missing}: {parts}{seen}", "{missing}: {parts}{seen}", missing, parts, seen))
    }
}

/// What the drive says that matters for moving it.
pub async fn look(session: &mut Session<'_>, target: &mut Target) -> Result<Situation, Failure> {
    let status = status_word(session, target).await?;
    let fault = present_fault(session, target, status).await?;
    Ok(Situation { fault, ..surroundings(session, target, status).await? })
}

/// What matters for moving a drive besides its status word and its fault, which somebody has read.
pub async fn surroundings(session: &mut Session<'_>, target: &mut Target, status: u32) -> Result<Situation, Failure> {
    let watchdog = working_raw(session, target, "watchdog").await?;
    target.known_watchdog = watchdog;
    let mut situation = Situation {
        status,
        state: describe::state(&target.family, status).slug,
        mode: working_raw(session, target, "control-mode").await?,
        fault: None,
        inputs: role_raw(session, target, "digital-inputs").await?,
        settings: BTreeMap::new(),
        watchdog_s: watchdog.map(|raw| watchdog_seconds(&target.family, raw)),
    };
    let family = target.family.clone();
    for setting in family.motion.interlocks.iter().filter_map(|row| row.setting.as_ref()) {
        if let Some(raw) = role_raw(session, target, &setting.role).await? {
            situation.settings.insert(setting.role.clone(), raw);
        }
    }
    Ok(situation)
}

/// The state of a drive now, by its name in the catalogue.
pub async fn state_now(session: &mut Session<'_>, target: &mut Target) -> Result<String, Failure> {
    let status = status_word(session, target).await?;
    Ok(describe::state(&target.family, status).slug)
}

/// The status word. A drive that refuses it has said nothing of its state, and most likely is another one than was named.
pub(super) async fn status_word(session: &mut Session<'_>, target: &mut Target) -> Result<u32, Failure> {
    let family = target.family.clone();
    let none = || {
        Failure::new(
            Class::Data,
            "data.role",
            both!("this drive has no status word", "dieser Antrieb hat kein Statuswort"),
        )
    };
    let param = family.role("status-word").ok_or_else(none)?;
    match target.read_set(session, param, 0).await {
        Ok(reading) => Ok(reading.raw as u32),
        // Who is busy says nothing of who he is.
        Err(error @ AccessError::Refused(Refusal { no, .. })) if !no.passes() => {
            Err(error.failure(target.address, Some(&family)).hint(both!(
                "{param} tells the state of every {drive}, and this drive refuses it: is --drive right?",
                "{param} nennt den Zustand jedes {drive}, und dieser Antrieb lehnt es ab: stimmt --drive?",
                param = param.label(),
                drive = family.drive
            )))
        }
        Err(error) => Err(error.failure(target.address, Some(&family))),
    }
}

/// Code of the fault that is present; 0 is none. A memory is not touched without need: on some drives reading moves on.
async fn present_fault(session: &mut Session<'_>, target: &mut Target, status: u32) -> Result<Option<i64>, Failure> {
    if target.family.present_fault(Some(status), u32::MAX).is_none() {
        return Ok(Some(0));
    }
    role_raw(session, target, "fault").await
}

/// Refuses to change the operating mode of a shaft that somebody else turns: a drive may refuse it then (LXM05 manual 6.3.1),
/// and at the end of the run the other's movement would be stopped.
pub async fn may_change_mode(
    session: &mut Session<'_>,
    target: &mut Target,
    state: &str,
    mode: &Mode,
) -> Result<(), Failure> {
    let active = match mode.value.filter(|_| state == "operation-enabled") {
        Some(_) => role_raw(session, target, "mode-active").await?,
        None => None,
    };
    if active == mode.value || active.is_none() || !turns(session, target).await? {
        return Ok(());
    }
    let present = target.family.modes.iter().find(|row| row.value == active).map(Mode::text);
    let text = both!(
        "the shaft turns in mode '{present}'; '{wanted}' is selected at standstill only",
        "die Welle dreht in der Betriebsart '{present}'; '{wanted}' wird nur im Stillstand gewählt",
        present = present.unwrap_or_else(|| Text::name("?")),
        wanted = mode.text()
    );
    let hint = both!(
        "`antrieb statemachine quick-stop` stops it first",
        "`antrieb statemachine quick-stop` hält sie vorher an"
    );
    Err(Failure::new(Class::Forbidden, "forbidden.turning", text).hint(hint))
}

/// Whether the shaft turns now, as far as the drive tells.
pub async fn turns(session: &mut Session<'_>, target: &mut Target) -> Result<bool, Failure> {
    let mut watch = Watch::new(target.family.motion.movement);
    for _ in 0..TURN_LOOKS {
        let Some(raw) = role_raw(session, target, "movement").await? else { return Ok(false) };
        watch.see(session.now(), Some(raw));
        if watch.stands() {
            return Ok(false);
        }
        let rested = session.rest(TURN_BEAT).await;
        rested.map_err(|error| error.failure(target.address, Some(&target.family)))?;
    }
    Ok(true)
}

/// A value of the drive's watchdog in seconds.
pub fn watchdog_seconds(family: &Family, raw: i64) -> Decimal {
    Decimal { raw, decimals: watchdog_decimals(family) }
}

/// The value that sets the drive's watchdog to a time: a part of its unit counts as one.
///
/// Refused beyond what the drive takes: a shorter time than was asked for would trip by surprise.
pub fn watchdog_raw(family: &Family, span: Span) -> Result<i64, Failure> {
    let decimals = watchdog_decimals(family);
    let raw = i64::try_from(span.as_micros().div_ceil(1_000_000 / 10u64.pow(decimals.into()))).unwrap_or(i64::MAX);
    let Some(param) = family.role("watchdog").filter(|param| param.max.is_some_and(|max| raw > max)) else {
        return Ok(raw.max(1));
    };
    let (label, given, most) =
        (param.label(), format_decimal(raw, decimals), format_decimal(param.max.unwrap_or(i64::MAX), decimals));
    let text = both!(
        "--watchdog {given} s: {label} takes at most {most} s",
        "--watchdog {given} s: {label} nimmt höchstens {most} s"
    );
    Err(Failure::new(Class::Data, "data.range", text).with("param", param.id))
}

fn watchdog_decimals(family: &Family) -> u8 {
    let in_ms = family.role("watchdog").is_some_and(|param| param.unit.as_deref() == Some("ms"));
    if in_ms { 3 } else { 0 }
}

pub(super) fn no_plan(why: &NoPlan, situation: &Situation, family: &Family) -> Failure {
    match why {
        NoPlan::Unreachable { from, goal } => {
            let text = both!(
                "no command leads from '{from}' to '{goal}'",
                "kein Befehl führt von '{from}' nach '{goal}'",
                from = state_name(family, from),
                goal = state_name(family, goal)
            );
            Failure::new(Class::Forbidden, "forbidden.unreachable", text)
        }
        NoPlan::Missing(needs) => {
            let rows = needs.iter().filter_map(|need| family.motion.interlock(*need));
            // The inputs tell which part of it is missing.
            let words: Vec<_> = rows.map(|row| situation.told(row).unwrap_or_else(|| row.what.clone())).collect();
            let text = both!(
                "the drive cannot be enabled, missing: {missing}",
                "der Antrieb ist nicht freizugeben, es fehlt: {missing}",
                missing = Text::join(&words, ", ")
            );
            let slugs = needs.iter().map(|need| format!("{need:?}").to_lowercase()).collect::<Vec<_>>();
            Failure::new(Class::Forbidden, "forbidden.interlock", text).with("missing", slugs.join(","))
        }
    }
}

pub(super) fn state_name(family: &Family, slug: &str) -> Text {
    family.states.iter().find(|row| row.slug == slug).map_or_else(|| Text::name(slug), DriveState::text)
}

/// The raw value of the parameter with a role; `None` if the drive refuses it or has none.
pub async fn role_raw(session: &mut Session<'_>, target: &mut Target, role: &str) -> Result<Option<i64>, Failure> {
    let Some(param) = target.family.role(role).cloned() else { return Ok(None) };
    raw(session, target, &param, 0).await
}

/// The raw value that the drive works with: RAM of the active data set.
pub async fn working_raw(session: &mut Session<'_>, target: &mut Target, role: &str) -> Result<Option<i64>, Failure> {
    let Some(param) = target.family.role(role).cloned() else { return Ok(None) };
    working(session, target, &param).await
}

/// The raw value of a parameter that the drive works with; `None` if it refuses it.
pub async fn working(session: &mut Session<'_>, target: &mut Target, param: &Param) -> Result<Option<i64>, Failure> {
    let (_, reading) = read_working(session, target, param).await?;
    told(reading, target)
}

/// Reads a parameter where the drive works with it: says also in which data set. One that is the same in all sets as far as
/// the catalogue knows may yet differ: then it is that of the active set.
pub(super) async fn read_working(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
) -> Result<(u8, Result<Reading, AccessError>), Failure> {
    let set = ram_set(session, target, param).await?;
    let reading = target.read_set(session, param, set).await;
    if set != DataSets::RAM_OFFSET || !reading.as_ref().is_err_and(AccessError::sets_differ) {
        return Ok((set, reading));
    }
    let set = active_ram_set(session, target).await?;
    Ok((set, target.read_set(session, param, set).await))
}

pub(super) async fn raw(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    set: u8,
) -> Result<Option<i64>, Failure> {
    let reading = target.read_set(session, param, set).await;
    told(reading, target)
}

fn told(reading: Result<Reading, AccessError>, target: &Target) -> Result<Option<i64>, Failure> {
    match reading {
        Ok(reading) => Ok(Some(reading.raw)),
        Err(AccessError::Refused(_)) => Ok(None),
        Err(error) => Err(error.failure(target.address, Some(&target.family))),
    }
}

/// The RAM data set in which the drive works with a parameter; 0 where there are no data sets.
async fn ram_set(session: &mut Session<'_>, target: &mut Target, param: &Param) -> Result<u8, Failure> {
    // An actual value has one place, whatever the data set.
    if !target.family.link.route.has_data_sets() || !param.access.writes() {
        return Ok(0);
    }
    if param.sets != Some(Sets::Four) {
        return Ok(DataSets::RAM_OFFSET);
    }
    active_ram_set(session, target).await
}

async fn active_ram_set(session: &mut Session<'_>, target: &mut Target) -> Result<u8, Failure> {
    let active = role_raw(session, target, "active-set").await?.unwrap_or(1);
    Ok(DataSets::RAM_OFFSET + u8::try_from(active).unwrap_or(1).clamp(1, 4))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drive::motion::lacking::{missing, no_control, tripped};
    use crate::profile::Registry;
    use crate::text::Lang;
    use std::rc::Rc;

    fn family(drive: &str) -> Rc<Family> {
        Registry::open(&[]).unwrap().family(drive).unwrap()
    }

    fn situation(status: u32, mode: Option<i64>) -> Situation {
        Situation { status, mode, ..Situation::default() }
    }

    #[test]
    fn a_watchdog_time_is_never_rounded_down_and_never_off() {
        let raw = |drive: &str, us: u64| watchdog_raw(&family(drive), Span::from_micros(us)).ok();
        for (drive, us, expected) in [
            ("acu", 2_000_000, 2),
            ("acu", 2_000_001, 3),
            ("acu", 1, 1),
            ("acu", 0, 1),
            ("lxm05", 700_000, 700),
            ("lxm05", 700_001, 701),
            ("lxm05", 1, 1),
        ] {
            assert_eq!(raw(drive, us), Some(expected), "{drive} {us}");
        }
        for (drive, unit_us) in [("acu", 1_000_000), ("lxm05", 1_000)] {
            let most = family(drive).role("watchdog").unwrap().max.unwrap();
            assert_eq!(raw(drive, most as u64 * unit_us), Some(most), "{drive}");
            let beyond = watchdog_raw(&family(drive), Span::from_micros(most as u64 * unit_us + 1)).unwrap_err();
            assert_eq!(beyond.code, "data.range", "{drive}");
            assert!(beyond.message.get(Lang::De).contains("höchstens"), "{beyond:?}");
        }
        assert_eq!(watchdog_seconds(&family("acu"), 2), Decimal { raw: 2, decimals: 0 });
        assert_eq!(watchdog_seconds(&family("lxm05"), 700), Decimal { raw: 700, decimals: 3 });
    }

    #[test]
    fn what_does_not_say_who_controls_it_is_not_refused() {
        let target = |drive: &str| Target::new(1, family(drive));
        let refused = |drive: &str, mode| no_control(&situation(0, mode), &target(drive)).map(|f| f.to_string());
        assert_eq!([refused("acu", None), refused("acu", Some(1)), refused("lxm05", Some(0))], [None, None, None]);
        let text = refused("act", Some(2)).unwrap();
        assert!(text.contains("P.412 is 2, it must be 1"), "{text}");
        let obeys = |drive: &str, mode| situation(0, mode).obeys(&family(drive));
        assert_eq!([obeys("acu", Some(1)), obeys("acu", Some(2)), obeys("acu", None)], [true, false, false]);
        assert!(obeys("lxm05", None), "a servo always obeys");
    }

    #[test]
    fn only_what_is_missing_is_named() {
        let acu = Target::new(1, family("acu"));
        let told = |seen: &Situation| missing(seen, &acu).into_iter().map(|text| text.en).collect::<Vec<_>>();
        // Remote and mains are given: bits 9 and 4.
        let ready = situation(0x0210, Some(1));
        assert_eq!(told(&ready), [""; 0]);
        let open = |inputs| Situation { inputs: Some(inputs), ..situation(0x0010, Some(1)) };
        let (enable, start) = ("external enable STOA", "start contact S2IND");
        for (inputs, has_enable, has_start) in [(0b110, true, false), (0b001, false, true), (0b000, true, true)] {
            let told = told(&open(inputs));
            assert_eq!(told.len(), 1, "{inputs:b}: {told:?}");
            let named = told.first().map(|text| (text.contains(enable), text.contains(start), text.contains("P.250")));
            assert_eq!(named, Some((has_enable, has_start, true)), "{inputs:b}: {told:?}");
        }
        // All inputs are there, and yet: everything is named, because one of them lies.
        assert!(told(&open(0b011)).iter().all(|text| text.contains(enable) && text.contains(start)));
        let dark = told(&situation(0x0200, Some(1)));
        assert!(dark.len() == 1 && dark.iter().all(|text| text.contains("no mains voltage")), "{dark:?}");
        // Remote tells nothing where nobody would obey it.
        let foreign = told(&situation(0x0010, Some(0)));
        assert!(foreign.len() == 1 && foreign.iter().all(|text| text.contains("P.412 is 0")), "{foreign:?}");
        // But the inputs do.
        let open = told(&Situation { inputs: Some(0b010), ..situation(0x0010, Some(0)) });
        assert!(open.len() == 2 && open.iter().any(|text| text.contains(enable) && !text.contains(start)), "{open:?}");
        let tripped = told(&Situation { fault: Some(0x0500), ..ready.clone() });
        assert!(tripped.len() == 1 && tripped.iter().all(|text| text.starts_with("F0500 ")), "{tripped:?}");
    }

    #[test]
    fn a_configuration_with_positioning_is_known_by_its_last_digits() {
        let family = family("acu");
        let with = |p30| Situation {
            settings: BTreeMap::from([("configuration".to_owned(), p30)]),
            ..situation(0x0210, Some(1))
        };
        for (p30, by_steps) in [(240, true), (440, true), (40, true), (110, false), (410, false), (241, false)] {
            let facts = with(p30).facts(&family);
            let way = family.machine.plan("switch-on-disabled", "operation-enabled", &facts).unwrap();
            assert_eq!(way.len() > 1, by_steps, "P.30 = {p30}: {way:?}");
        }
    }

    #[test]
    fn a_state_without_a_name_is_called_by_its_word() {
        let family = family("acu");
        assert_eq!(state_name(&family, "fault").de, "Störung");
        assert_eq!(state_name(&family, "switched-on").en, "Switched on");
        assert_eq!(state_name(&family, "unknown"), Text::name("unknown"));
    }

    #[test]
    fn a_trip_is_named_with_its_remedy() {
        let acu = family("acu");
        let known = tripped(&acu, 0x0500);
        assert!(known.to_string().starts_with("the drive has tripped: F0500 "), "{known}");
        assert_eq!(tripped(&acu, 0).to_string(), "the drive has tripped");
    }
}
