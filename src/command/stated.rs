//! What the settings say of a drive: what was typed is believed, what a file states is asked.

use super::speech;
use crate::args::Settings;
use crate::drive::{Session, Stated, Target, Terms};
use crate::failure::{Class, Failure};
use crate::profile::{Family, Registry};
use crate::text::{Text, both};
use std::rc::Rc;

/// What the settings say of the line and its drives.
pub(super) fn terms<'a>(settings: &Settings, registry: &'a Registry) -> Result<Terms<'a>, Failure> {
    let said = settings.drive.as_deref().map(|name| named_family(settings, registry, name)).transpose()?;
    let stated = |family| Stated { family, whence: settings.origin("drive").name(), refuses: false };
    let (named, stated) = match settings.named_drive() {
        Some(_) => (said, None),
        None => (None, said.map(stated)),
    };
    let (word_order, line) = (settings.word_order, settings.line);
    Ok(Terms { registry, named, stated, word_order, line, speech: speech(settings) })
}

/// The drive at an address. `shows_register`: see [`Terms::target`].
pub(super) async fn target(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
    shows_register: bool,
) -> Result<Target, Failure> {
    terms(settings, registry)?.target(session, address, shows_register).await
}

/// The drive at an address that is to be written to or moved: of another family than the settings state it is refused.
pub(super) async fn target_to_change(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
) -> Result<Target, Failure> {
    let mut terms = terms(settings, registry)?;
    if let Some(stated) = &mut terms.stated {
        stated.refuses = true;
    }
    terms.target(session, address, false).await
}

/// The family that `--drive` names.
pub(super) fn named_family(settings: &Settings, registry: &Registry, name: &str) -> Result<Rc<Family>, Failure> {
    registry.family(name).ok_or_else(|| {
        let known: Vec<_> = registry.drives().into_iter().map(|drive| drive.id).collect();
        let message = both!(
            "unknown drive '{name}' (expected: auto, {known})",
            "unbekannter Antrieb '{name}' (erwartet: auto, {known})",
            known = known.join(", ")
        );
        let titles = registry
            .drives()
            .into_iter()
            .map(|drive| both!("{id} = {title}", "{id} = {title}", id = drive.id, title = drive.title));
        let titles = Text::join(&titles.collect::<Vec<_>>(), ", ");
        let in_file = settings.wrong_in_file("drive", &message);
        in_file.unwrap_or_else(|| Failure::new(Class::Usage, "usage.drive", message)).hint(both!(
            "{titles}; auto, or no --drive, asks the drive what it is",
            "{titles}; auto oder kein --drive fragt den Antrieb, was er ist",
            titles
        ))
    })
}
