//! What is said of a stop while it is under way.

use super::super::Motor;
use super::StopChoice;
use crate::outcome::Event;
use crate::profile::Lang;

impl Motor<'_, '_> {
    /// Says once how a run that is held ends.
    pub(in crate::drive::motion) fn tell_held(&mut self) {
        let Some(choice) = self.stops.take() else { return };
        let text = match (choice, self.lang) {
            (StopChoice::Keep, Lang::En) => "running; Ctrl-C ends this program, not the drive (keep)".to_owned(),
            (StopChoice::Keep, Lang::De) => {
                "läuft; Ctrl-C beendet dieses Programm, nicht den Antrieb (keep)".to_owned()
            }
            (choice, Lang::En) => format!("running; Ctrl-C stops: {}", choice.slug()),
            (choice, Lang::De) => format!("läuft; Ctrl-C hält an: {}", choice.slug()),
        };
        self.session.tell(Event::Note(text.into()));
    }

    /// Says that the stop is under way, and what another interrupt does.
    pub(super) fn tell_stopping(&mut self, choice: StopChoice) {
        let (slug, stronger) = (choice.slug(), self.stronger(choice));
        let text = match (stronger, self.lang) {
            (Some(next), Lang::En) => format!("stopping: {slug}; another Ctrl-C: {}", next.slug()),
            (Some(next), Lang::De) => format!("der Halt läuft: {slug}; noch ein Ctrl-C: {}", next.slug()),
            (None, Lang::En) => format!("stopping: {slug}; another Ctrl-C waits no longer"),
            (None, Lang::De) => format!("der Halt läuft: {slug}; noch ein Ctrl-C wartet ihn nicht ab"),
        };
        self.session.tell(Event::Note(text.into()));
    }

    pub(super) fn tell_stronger(&mut self, way: StopChoice, next: StopChoice, interrupted: bool) {
        let (way, next) = (way.slug(), next.slug());
        let text = match (interrupted, self.lang) {
            (true, Lang::En) => format!("interrupted again: {next} in place of {way}"),
            (true, Lang::De) => format!("erneut unterbrochen: {next} statt {way}"),
            (false, Lang::En) => format!("{way} is not obeyed: {next} in its place"),
            (false, Lang::De) => format!("{way} wird nicht befolgt: stattdessen {next}"),
        };
        self.session.tell(Event::Note(text.clone().into()));
        self.notes.push(text);
    }
}

/// What is said of a drive that turns on at a setpoint of 0 that is all we can give it.
pub(super) fn started_by_others(lang: Lang) -> &'static str {
    lang.pick(
        "its contacts or its keypad start and stop it, and only they take its power: a setpoint of 0 does not",
        "seine Kontakte oder seine Bedieneinheit starten und halten ihn, nur sie nehmen ihm den Strom; ein Sollwert 0 nicht",
    )
}
