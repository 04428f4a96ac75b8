//! Who it is that a run or a stop is for: as the settings say for the first word, and as the drive says behind it.

use super::{Plan, is_command, said_of, unstopped};
use crate::args::Settings;
use crate::command::{named_family, target, target_to_change, terms};
use crate::drive::motion::{FirstWord, Meant, PROOF, shout_once};
use crate::drive::{AccessError, Session, Target};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::profile::Registry;

/// The drive, asked who it is. Its word went out, so whoever interrupts that gets a stronger one. Of one that is to stop, what the
/// settings state holds where no answer tells; to any other drive than stated nothing else is done.
pub(super) async fn whom(
    session: &mut Session<'_>,
    (settings, registry): (&Settings, &Registry),
    address: u8,
    (act, stops): (Option<Relief>, bool),
    pressed: &mut bool,
) -> Result<Target, Failure> {
    if !stops {
        return target_to_change(session, settings, registry, address).await;
    }
    let recognised = match target(session, settings, registry, address, false).await {
        Err(failure) if failure.class == Class::Interrupted && is_command(act) => {
            // Who has pressed before has had that one.
            let act = if std::mem::replace(pressed, true) { Some(Relief::QuickStop) } else { act };
            stop_harder(session, (settings, registry), address, act).await?;
            target(session, settings, registry, address, false).await
        }
        recognised => recognised,
    };
    match (recognised, terms(settings, registry)?.said()) {
        (Err(failure), Some(family)) if failure.code == "data.unknown_drive" => {
            Ok(Target::new(address, family).in_word_order(settings.word_order))
        }
        (recognised, _) => recognised,
    }
}

/// Whom the first words are for.
pub(super) fn meant(settings: &Settings, registry: &Registry, addresses: &[u8]) -> Result<Vec<Meant>, Failure> {
    let family = settings.drive.as_deref().map(|name| named_family(settings, registry, name)).transpose()?;
    let one = |&address: &u8| Meant { address, family: family.clone(), order: settings.word_order };
    Ok(addresses.iter().map(one).collect())
}

/// The first word of the only drive that is meant. Whoever interrupts one that nobody acknowledges gets a stronger one.
pub(super) async fn first_said(
    session: &mut Session<'_>,
    (settings, registry): (&Settings, &Registry),
    drive: &Meant,
    act: Relief,
    plan: &mut Plan<'_>,
) -> Result<FirstWord, Failure> {
    match said_of(session, registry, drive, act, plan).await {
        Err(failure) if failure.class == Class::Interrupted && is_command(Some(act)) => {
            plan.said = true;
            stop_harder(session, (settings, registry), drive.address, Some(act)).await
        }
        said => said,
    }
}

/// Somebody interrupts before anybody knows what the drive is: the stronger word goes out, whatever it is, and who interrupts that gets the
/// strongest. Returns what became of it.
pub(super) async fn stop_harder(
    session: &mut Session<'_>,
    (settings, registry): (&Settings, &Registry),
    address: u8,
    act: Option<Relief>,
) -> Result<FirstWord, Failure> {
    session.note_interrupts();
    let once = act == Some(Relief::Disable) && session.presses() < 2;
    let mut act = if once { Relief::QuickStop } else { Relief::DisableVoltage };
    let mut word = FirstWord::default();
    for drive in meant(settings, registry, &[address])? {
        loop {
            session.note_interrupts();
            word = match shout_once(session, registry, &drive, act).await {
                Err(AccessError::Interrupted) if act == Relief::QuickStop => FirstWord::default().interrupted(act),
                said => said.map_err(|error| unstopped(error.failure(address, None), act, true))?,
            };
            if !word.pressed || act == Relief::DisableVoltage {
                break;
            }
            act = Relief::DisableVoltage;
        }
    }
    session.insist(true);
    session.end_at(Some(session.now() + PROOF));
    Ok(word.interrupted(act))
}
