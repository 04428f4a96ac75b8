//! A record holds what goes back into a drive, and is a file that anybody can change: before anything is opened, and again before
//! anything is written, it is held against what its procedure ever sets for its time.

use super::aim::{Params, fits};
use super::record::{begin_anew, wrong};
use crate::drive::motion::place_name;
use crate::failure::Failure;
use crate::outcome::{Left, Lent, ProcedureRecord};
use crate::profile::procedure::{Act, Procedure};
use crate::profile::value::{ValueError, written};
use crate::profile::{Family, Param, Role, Sets};
use crate::text::{Text, both};
use std::path::Path;

/// Data sets of a parameter.
const SETS: u8 = 4;

/// A row of a record: what it would set back, and how it calls that.
struct Row<'r> {
    param: u32,
    name: &'r str,
    data_set: u8,
    old: i64,
    stood: &'r str,
    /// What a run has set.
    set: Vec<i64>,
}

/// Holds what a record would set back against what its procedure sets, in this family.
///
/// # Errors
/// It names something else, or a value that cannot have stood there.
pub(super) fn held(
    path: &Path,
    record: &ProcedureRecord,
    procedure: &Procedure,
    family: &Family,
) -> Result<(), Failure> {
    let lent = record.lent.iter().map(|lent| {
        let Lent { param, name, data_set, old, stood, new, was, .. } = lent;
        let set = [*new].into_iter().chain(*was).collect();
        Row { param: *param, name, data_set: *data_set, old: *old, stood, set }
    });
    let left = record.left.iter().map(|left| {
        let Left { param, name, data_set, old, stood, .. } = left;
        Row { param: *param, name, data_set: *data_set, old: *old, stood, set: Vec::new() }
    });
    let ever = ever_lent(procedure, family);
    lent.chain(left).try_for_each(|row| row.fits(&ever, family)).map_err(|why| {
        let name = &procedure.slug;
        let message = both!(
            "{why}: that is not what {name} has left, so nothing of the record is set back",
            "{why}: das hat {name} nicht hinterlassen, deshalb wird aus der Aufzeichnung nichts zurückgestellt",
            why
        );
        wrong(path, &message).hint(begin_anew())
    })
}

/// What the runs of a procedure set for their time: the watchdog, who is obeyed, where the setpoint comes from, and for a search its
/// limits and the offset.
fn ever_lent(procedure: &Procedure, family: &Family) -> Vec<Param> {
    let does = |is: fn(Act) -> bool| procedure.steps_of(&family.drive).iter().any(|step| is(step.act));
    if !does(Act::turns) {
        return Vec::new();
    }
    let roles = [Role::Watchdog, Role::ControlMode].into_iter().filter_map(|role| family.role(role).cloned());
    let sources = family.modes.iter().filter_map(|mode| family.param(mode.source.as_ref()?.param).cloned());
    let sought = does(|act| act == Act::Offset).then(|| Params::of(family).ok()).flatten();
    let sought = sought.into_iter().flat_map(|params| [params.limit, params.current, params.offset]);
    roles.chain(sources).chain(sought).collect()
}

impl Row<'_> {
    fn fits(&self, ever: &[Param], family: &Family) -> Result<(), Text> {
        let Row { param, data_set, old, .. } = *self;
        let unknown = family.param_or_unknown(param);
        let known = ever.iter().find(|known| known.id == param);
        let label = place_name(family, known.unwrap_or(&unknown), data_set);
        let stood = written(known.unwrap_or(&unknown), old);
        let would = |why: Text| {
            both!("it would set {label} back to {stood}{why}", "sie würde {label} auf {stood} zurückstellen{why}", why)
        };
        let Some(known) = known else { return Err(would(Text::default())) };
        let most = if known.sets == Some(Sets::One) || !family.link.route.has_data_sets() { 0 } else { SETS };
        if data_set > most || self.name != label || self.stood != stood {
            let (name, told) = (self.name, self.stood);
            return Err(would(both!(", and calls it {name} = {told}", " und nennt das {name} = {told}")));
        }
        let out = |error: ValueError| would(both!(" ({why})", " ({why})", why = error.text()));
        self.set.iter().chain([&old]).try_for_each(|&raw| fits(known, raw)).map_err(out)?;
        // Who is obeyed is taken by one value, and is given back from that alone.
        let obeys = family.motion.control.filter(|_| family.role(Role::ControlMode).is_some_and(|row| row.id == param));
        match obeys.and_then(|control| self.set.iter().find(|&&raw| raw != control.obeys)) {
            Some(other) => Err(would(both!(" where it is {other}", ", wo {other} steht"))),
            None => Ok(()),
        }
    }
}
