//! A stop of several drives: each hears it before any of them is looked at, and all are watched in turns.

use super::{Around, Plan, meant, on_drive, unstopped};
use crate::command::{Context, connect};
use crate::drive::motion::{FirstWord, Glimpse, Motor, Next, Shouting};
use crate::drive::{AccessError, Session, summary};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Data, ErrorDoc, Outcome, Stopped, Stops};
use crate::text::{Text, both};
use crate::tick::Span;

/// Pause between the looks at all of them.
const BEAT: Span = Span::from_millis(20);

/// One of the drives.
struct Stopping {
    address: u8,
    /// What went out to it.
    said: FirstWord,
    /// Why that was broken off.
    unsaid: Option<Failure>,
    /// What it shows, as long as it is watched.
    glimpse: Option<Glimpse>,
    watched: bool,
    came: Option<Stopped>,
    failure: Option<Failure>,
}

/// Says `act` to every drive, watches them in turns until their shafts become no slower, and proves it of each. `plan`: that of
/// one, which can do nothing else.
///
/// Fails only where the line cannot be opened: what is not proven stands beside its drive.
pub(in crate::command) async fn stop_each<'p>(
    context: &mut Context<'_>,
    addresses: &[u8],
    act: Relief,
    plan: impl Fn() -> Plan<'p>,
) -> Result<Outcome, Failure> {
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    interrupt.hear_only_keys();
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let named = meant(settings, registry, addresses)?;
    let mut shouting = Shouting::new(&named, act);
    shouting.round(&mut session, registry).await;
    let begins = |(&address, said): (&u8, FirstWord)| {
        let glimpse = Glimpse::of(&session, address, &said);
        let watched = glimpse.is_some();
        Stopping { address, said, unsaid: None, glimpse, watched, came: None, failure: None }
    };
    let mut drives: Vec<Stopping> = addresses.iter().zip(shouting.first()).map(begins).collect();
    let mut around = Around { settings, registry, interrupt, ask: *ask };
    if watch(&mut session, &mut around, &mut drives, &mut shouting, (act, &plan)).await.is_err() {
        session.note_interrupts();
        // All hear the stronger one before any of them is looked at.
        Shouting::new(&named, stronger(act)).round(&mut session, registry).await;
    }
    while shouting.goes_on() {
        shouting.round(&mut session, registry).await;
    }
    for (drive, said) in drives.iter_mut().zip(shouting.end()) {
        let failed = |error: AccessError| unstopped(error.failure(drive.address, None), act, true);
        drive.unsaid = said.err().map(failed);
    }
    for drive in &mut drives {
        prove(&mut session, &mut around, drive, act, plan()).await;
    }
    let succeeded = drives.iter().filter(|drive| drive.failure.is_none()).count();
    let failed = |drive: &mut Stopping| drive.failure.take().map(|failure| (drive.address, failure));
    let failure = told(drives.iter_mut().filter_map(failed).collect(), succeeded);
    let drives = drives.into_iter().filter_map(|drive| drive.came).collect();
    Ok(Outcome { data: Some(Data::Stops(Stops { drives })), warnings: Vec::new(), failure })
}

/// What follows where somebody interrupts the stop of several.
fn stronger(act: Relief) -> Relief {
    if act == Relief::Disable { Relief::QuickStop } else { Relief::DisableVoltage }
}

/// Looks at every drive in turn as long as one becomes slower, and says the stop on to whoever is silent. One that does not become
/// slower is taken on at once.
async fn watch<'p>(
    session: &mut Session<'_>,
    around: &mut Around<'_>,
    drives: &mut [Stopping],
    shouting: &mut Shouting<'_>,
    (act, plan): (Relief, &impl Fn() -> Plan<'p>),
) -> Result<(), Failure> {
    let permit = act.permit();
    while drives.iter().any(|drive| drive.watched) {
        for drive in drives.iter_mut().filter(|drive| drive.watched) {
            let Some(glimpse) = &mut drive.glimpse else { continue };
            let next = glimpse.look(session, &permit).await?;
            drive.watched = next == Next::Look;
            if next == Next::Prove {
                prove(session, around, drive, act, plan()).await;
            }
        }
        if around.interrupt.is_raised() {
            return Err(AccessError::Interrupted.failure(0, None));
        }
        match shouting.goes_on() {
            true => shouting.next(session, around.registry).await,
            false => session.rest(BEAT).await.map_err(|error| error.failure(0, None))?,
        }
    }
    Ok(())
}

/// Proves the stop of one drive, if that was not done yet.
async fn prove(session: &mut Session<'_>, around: &mut Around<'_>, drive: &mut Stopping, act: Relief, plan: Plan<'_>) {
    if drive.came.is_some() {
        return;
    }
    let outcome = match drive.unsaid.take() {
        Some(failure) => Err(failure),
        None => {
            let plan = Plan { said: true, ..plan };
            let glimpse = drive.glimpse.take();
            let mut heard = around.interrupt.clone();
            let is_interrupted = heard.is_raised();
            heard.note();
            session.heed(heard);
            let work = async |motor: &mut Motor<'_, '_>, ()| {
                glimpse.into_iter().for_each(|glimpse| motor.goes_on_from(glimpse));
                if is_interrupted { Err(motor.breaks_off()) } else { motor.relieve(act).await }
            };
            let drive = (drive.address, drive.said.clone());
            on_drive(session, around, drive, plan, async |_, _, _, _| Ok(()), work).await
        }
    };
    let (motion, failure) = match outcome {
        Ok(Outcome { data: Some(Data::Motion(motion)), failure, .. }) => (Some(motion), failure),
        Ok(Outcome { failure, .. }) => (None, failure),
        Err(failure) => (None, Some(failure)),
    };
    let error = failure.as_ref().map(ErrorDoc::from);
    (drive.came, drive.failure) = (Some(Stopped { address: drive.address, motion, error }), failure);
}

/// Names every drive that is not proven to stand; who reads only the last line must not miss one. Where some stand it is 9; where
/// none was proven, that of which least is known counts, whatever the order of the addresses.
fn told(failures: Vec<(u8, Failure)>, succeeded: usize) -> Option<Failure> {
    let message = Text::join(&failures.iter().map(named).collect::<Vec<_>>(), "; ");
    let addresses = failures.iter().map(|(address, _)| address.to_string()).collect::<Vec<_>>().join(", ");
    let mut failures: Vec<Failure> = failures.into_iter().map(|(_, failure)| failure).collect();
    failures.sort_by_key(|failure| LEAST_KNOWN.iter().position(|class| *class == failure.class));
    summary(failures, succeeded).map(|failure| Failure { message, ..failure }.with("addresses", addresses))
}

/// What is told of a drive, with its address once.
fn named((address, failure): &(u8, Failure)) -> Text {
    let again = both!("address {address}: ", "Adresse {address}: ", address);
    let why = Text {
        en: failure.message.en.replace(&*again.en, "").into(),
        de: failure.message.de.replace(&*again.de, "").into(),
    };
    both!("{again}{why}", "{again}{why}", again, why)
}

/// From what tells nothing of a drive to what tells most.
const LEAST_KNOWN: [Class; 11] = [
    Class::Bug,
    Class::Port,
    Class::Interrupted,
    Class::Silence,
    Class::Garbled,
    Class::Refused,
    Class::Forbidden,
    Class::No,
    Class::Partial,
    Class::Data,
    Class::Usage,
];
