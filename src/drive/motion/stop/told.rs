//! What is said of a stop while it is under way.

use super::super::Motor;
use super::StopChoice;
use crate::drive::motion::lacking::what_stops_it;
use crate::failure::may_turn;
use crate::outcome::Event;
use crate::text::{Text, both};

impl Motor<'_, '_> {
    /// Says once how a run that is held ends.
    pub(in crate::drive::motion) fn tell_held(&mut self) {
        let Some(choice) = self.stops.take() else { return };
        self.session.tell(Event::Note(match choice {
            StopChoice::Keep => both!(
                "running; Ctrl-C ends this program, not the drive (keep)",
                "läuft; Strg-C beendet dieses Programm, nicht den Antrieb (keep)"
            ),
            choice => {
                both!("running; Ctrl-C stops: {slug}", "läuft; Strg-C hält an: {slug}", slug = choice.slug())
            }
        }));
    }

    /// Says that the stop is under way, and what another interrupt does.
    pub(super) fn tell_stopping(&mut self, choice: StopChoice) {
        let slug = choice.slug();
        self.session.tell(Event::Note(match self.stronger(choice) {
            Some(next) => both!(
                "stopping: {slug}; another Ctrl-C: {next}",
                "der Halt läuft: {slug}; noch ein Strg-C: {next}",
                next = next.slug()
            ),
            None => both!(
                "stopping: {slug}; another Ctrl-C waits no longer",
                "der Halt läuft: {slug}; noch ein Strg-C wartet ihn nicht ab"
            ),
        }));
    }

    pub(super) fn tell_stronger(&mut self, way: StopChoice, next: StopChoice, interrupted: bool) {
        let (way, next) = (way.slug(), next.slug());
        let text = match interrupted {
            true => both!("interrupted again: {next} in place of {way}", "erneut unterbrochen: {next} statt {way}"),
            false => {
                both!("{way} is not obeyed: {next} in its place", "{way} wird nicht befolgt: stattdessen {next}")
            }
        };
        self.stops_by(next);
        // Who works on as if nothing had been said is stopped by somebody else, if need be.
        match !interrupted && self.works {
            true => self.tell_works_on(&text),
            false => self.session.tell(Event::Note(text.clone())),
        }
        self.notes.push(text);
        self.has_time_for_a_word();
    }

    /// Says that the last stop that is left is not obeyed; it goes out on and on.
    pub(super) fn tell_deaf(&mut self, way: StopChoice) {
        let way = way.slug();
        self.tell_works_on(&both!("{way} is not obeyed", "{way} wird nicht befolgt"));
    }

    fn tell_works_on(&mut self, text: &Text) {
        // Of a drive that is only taken for one of its kind nobody knows the terminal.
        let family = Some(&*self.target.family).filter(|_| self.first_word.kind.is_none());
        let (turns, stops) = (may_turn(), what_stops_it(family));
        let text = both!("{turns}: {text}; {stops}", "{turns}: {text}; {stops}", turns, text, stops);
        self.session.tell(Event::Note(text));
    }
}

/// What is said of a drive that turns on at a setpoint of 0 that is all we can give it.
pub(super) fn started_by_others() -> Text {
    both!(
        "its contacts or its keypad start and stop it, and only they take its power: a setpoint of 0 does not",
        "seine Kontakte oder seine Bedieneinheit starten und halten ihn, nur sie nehmen ihm den Strom; ein Sollwert \
         0 nicht"
    )
}
