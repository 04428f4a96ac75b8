//! What is said of a setpoint before somebody agrees to it.

use super::wanted::Wanted;
use crate::command::running::Plan;
use crate::drive::motion::Promise;
use crate::drive::{Session, Target, motion};
use crate::failure::Failure;
use crate::profile::{Family, Start};
use crate::text::{Text, both};

pub(super) fn announce(wanted: &Wanted, family: &Family, enable: bool) -> Text {
    let shown =
        |values: &[i64]| Text::join(&values.iter().map(|&raw| wanted.shown(raw, family)).collect::<Vec<_>>(), " … ");
    let way = wanted.schedule.turns();
    let what = shown(&way);
    let sums: Option<Vec<i64>> =
        wanted.effective.and_then(|effective| way.iter().map(|&raw| effective.of(raw)).collect());
    let makes = sums.filter(|sums| *sums != way).map(|sums| shown(&sums));
    let what = match makes {
        Some(sum) => both!("{what} (the drive runs at {sum})", "{what} (der Antrieb läuft mit {sum})", what, sum),
        None => what,
    };
    let enables = enable.then(|| both!("enable operation", "Betrieb freigeben"));
    let mode = wanted.mode.value.map(|_| wanted.mode.text());
    let setpoint = both!("setpoint {what}", "Sollwert {what}", what);
    let start = wanted.start.as_ref().map(Start::text);
    let parts: Vec<Text> = [enables, mode, Some(setpoint), start].into_iter().flatten().collect();
    Text::join(&parts, ", ")
}

/// What to know of a setpoint besides: that it needs no control, and what the drive runs at by itself where its mode adds
/// nothing.
pub(super) async fn tells_more(
    session: &mut Session<'_>,
    target: &mut Target,
    plan: &mut Plan<'_>,
    wanted: &Wanted,
) -> Result<(), Failure> {
    if plan.aim.is_some() && plan.args.take_control {
        let told = both!(
            "control is not taken: a setpoint of 0 needs none",
            "die Steuerung wird nicht übernommen: ein Sollwert 0 braucht sie nicht"
        );
        plan.tells(session, vec![told]);
    }
    if wanted.mode.zero && !wanted.mode.zero_stops() && wanted.schedule.values().all(|raw| raw == 0) {
        let told = both!(
            "a setpoint of 0 does not bring the shaft to rest in this mode: {mode}; `antrieb statemachine quick-stop` does",
            "in dieser Betriebsart bringt ein Sollwert 0 die Welle nicht zum Stillstand: {mode}; `antrieb statemachine \
             quick-stop` tut es",
            mode = wanted.mode.text()
        );
        plan.tells(session, vec![told]);
    }
    if plan.aim.is_none() && wanted.mode.source.is_none() {
        let mut promises = motion::own_setpoints(session, target).await?;
        let told = promises.iter().filter_map(|promise| promise.runs_at(&target.family)).collect();
        plan.tells(session, told);
        if !promises.is_empty() && motion::is_controlled(session, target, &wanted.mode).await? {
            promises = promises.into_iter().map(Promise::led).collect();
        }
        plan.promises.extend(promises);
    }
    Ok(())
}

pub(super) fn begins_later() -> Text {
    both!(
        "its time begins when the setpoint is reached: until then it turns as well",
        "seine Zeit beginnt, wenn der Sollwert erreicht ist: auch bis dahin dreht er"
    )
}
