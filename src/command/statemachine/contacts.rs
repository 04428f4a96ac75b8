//! `statemachine contacts`: virtual contacts through the control word.

use super::dry_run;
use crate::args::{MotionArgs, StopArg};
use crate::command::running::{self, Plan};
use crate::command::{Context, offline_family};
use crate::drive::motion::{Motor, Situation, no_control_word, runs_at};
use crate::drive::{Session, Target};
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::profile::Family;
use crate::text::{Text, both};

/// Closes virtual contacts by name. They act only with the hardware enable given (CM-485 manual 9.1.3, 10.1).
pub(super) async fn set(
    context: &mut Context<'_>,
    contacts: &[String],
    motion: &MotionArgs,
) -> Result<Outcome, Failure> {
    let family = offline_family(context.settings, context.registry)?;
    let word = contact_word(&family, contacts)?;
    knows_the_stop(motion)?;
    if context.settings.dry_run {
        return dry_run(context, &family, motion, (false, false), None, |told| {
            let control = family.motion.control.filter(|_| motion.take_control);
            if let (Some(control), Some(param)) = (control, family.role("control-mode")) {
                told.change(param, control.contacts);
            }
            told.control(word);
        });
    }
    let shown = if contacts.is_empty() { "-".to_owned() } else { contacts.join(" ") };
    let announce = both!(
        "close these contacts, open all others: {shown}",
        "diese Kontakte schließen, alle anderen öffnen: {shown}"
    );
    let plan = Plan { needs_control: false, ..Plan::of("contacts", announce, motion) };
    let (hold, take) = (motion.hold.then_some(motion.duration), motion.take_control);
    running::run(
        context,
        plan,
        async |session, target, before, plan| heard(session, target, before, plan, word).await,
        async |motor, contacts| {
            if take {
                motor.take_control(contacts, Some(word)).await?;
            }
            motor.holding(hold, async |motor: &mut Motor<'_, '_>| motor.contacts(word).await).await
        },
    )
    .await
}

/// There is no quick stop by contacts; refused before anything is opened.
fn knows_the_stop(motion: &MotionArgs) -> Result<(), Failure> {
    if motion.hold && motion.on_exit == StopArg::QuickStop {
        let text = both!("contacts know no quick stop", "Kontakte kennen keinen Schnellhalt");
        return Err(Failure::new(Class::Usage, "usage.on_exit", text).hint(both!(
            "--on-exit ramp opens the start contacts first, --on-exit coast opens all at once",
            "--on-exit ramp öffnet zuerst die Startkontakte, --on-exit coast alle zugleich",
        )));
    }
    Ok(())
}

/// Refuses what the drive would not listen to, and tells what the contacts start; returns the control mode in which they are
/// some.
async fn heard(
    session: &mut Session<'_>,
    target: &mut Target,
    before: &Situation,
    plan: &mut Plan<'_>,
    word: u16,
) -> Result<i64, Failure> {
    if plan.args.hold {
        plan.details.push(opened(plan.args.on_exit));
    }
    let Some(control) = target.family.motion.control else {
        let text = both!("this drive has no virtual contacts", "dieser Antrieb hat keine virtuellen Kontakte");
        return Err(Failure::new(Class::Forbidden, "forbidden.no_contacts", text));
    };
    if before.mode != Some(control.contacts) && !plan.args.take_control {
        return Err(unheard(before, &target.family, control.contacts));
    }
    if word != 0 {
        let (told, promises) = runs_at(session, target).await?;
        plan.tells(session, told);
        plan.promises.extend(promises);
    }
    Ok(control.contacts)
}

/// The failure to show where the control word is no contacts.
fn unheard(before: &Situation, family: &Family, needed: i64) -> Failure {
    let mode = before.mode.map_or_else(|| "?".to_owned(), |mode| mode.to_string());
    let label = family.role_label("control-mode");
    let text = both!(
        "the drive does not listen to virtual contacts: {label} is {mode}, it must be {needed}",
        "der Antrieb hört nicht auf virtuelle Kontakte: {label} ist {mode}, nötig ist {needed}"
    );
    Failure::new(Class::Forbidden, "forbidden.control_mode", text).hint(both!(
        "--take-control sets it in RAM; behind a --hold it is given back",
        "--take-control stellt es im RAM um; nach --hold geht es zurück",
    ))
}

/// What each way to stop is where contacts decide.
fn opened(stop: StopArg) -> Text {
    match stop {
        StopArg::Ramp => both!(
            "at the end the start contacts S2IND and S3IND open, the enable only once the drive is without power",
            "am Ende öffnen die Startkontakte S2IND und S3IND, die Freigabe erst, wenn der Antrieb ohne Strom ist",
        ),
        StopArg::Coast | StopArg::QuickStop => {
            both!("at the end all contacts open, and the shaft coasts", "am Ende öffnen alle, die Welle läuft aus")
        }
        StopArg::Keep => both!("the contacts stay closed", "die Kontakte bleiben geschlossen"),
    }
}

/// The control word whose bits are the contacts with these names.
fn contact_word(family: &Family, contacts: &[String]) -> Result<u16, Failure> {
    let param = family.role("control-word");
    let param = param.ok_or_else(no_control_word)?;
    let bits = family.word(param, 0, |_| Some(2));
    let fold = |name: &str| name.to_uppercase().replace(['-', '_', ' '], "");
    let mut word = 0;
    for contact in contacts {
        let bit = bits.iter().find(|bit| bit.row.is_some_and(|row| fold(&row.en) == fold(contact)));
        let bit = bit.ok_or_else(|| {
            let known: Vec<_> = bits.iter().filter_map(|bit| bit.row.map(|row| row.en.as_str())).collect();
            let message = both!(
                "there is no contact '{contact}' (expected: {known})",
                "es gibt keinen Kontakt '{contact}' (möglich: {known})",
                known = known.join(", ")
            );
            Failure::new(Class::Usage, "usage.contact", message)
        })?;
        word |= 1 << bit.bit;
    }
    Ok(word)
}
