//! How long a stop goes on to a drive that does not answer, or whose proof nobody waits for.

use super::super::Motor;
use super::super::still::STOPPED;
use crate::text::{Text, both};
use crate::tick::{Span, Tick};

/// The stop is given up when the drive has not answered for so long.
const SILENT: Span = Span::from_secs(10);
/// And after so long where it answers now and then, but never as far as a proof.
pub(in crate::drive::motion) const PURSUED: Span = Span::from_secs(20);
/// The same where somebody waits for what only takes motion away.
pub(super) const PURSUED_ALONE: Span = Span::from_secs(6);
/// A silence behind a stop that is told.
const UNTOLD: Span = Span::from_secs(1);
/// A drive that is without power for a moment is there again no sooner; it is asked whether it was.
const OFF: Span = Span::from_millis(600);
/// Who interrupts the strongest stop waits so long for it to be heard and proven.
const HURRIED: Span = Span::from_secs(3);
/// A drive that has been silent for long is asked no longer than this how it is, whatever `--timeout` says.
const BRIEFLY: Span = Span::from_secs(2);

impl Motor<'_, '_> {
    /// A word that follows goes out, and is proven for a while, also where the time of what only takes motion away is over.
    pub(super) fn has_time_for_a_word(&mut self) {
        if self.relieving.is_some() && self.session.is_over() {
            self.ends_within(HURRIED);
        }
    }

    /// A drive that hears its stop so much later, or from which nothing came for a while from just before it on, may have done anything
    /// meanwhile, such as coast without power.
    pub(super) async fn notes_silence(&mut self, is_unheard: bool) {
        let span = self.gap;
        if is_unheard && span >= UNTOLD {
            self.notes.push(both!(
                "nothing answered the stop for {span}: what the shaft did meanwhile is not known",
                "{span} lang hat nichts auf den Halt geantwortet: was die Welle inzwischen tat, ist unbekannt"
            ));
        }
        if span >= OFF && self.instead.is_none() {
            self.instead = self.has_restarted().await;
        }
    }

    /// What shows that a drive which was silent has restarted, so that its shaft coasted before any stop came to it.
    async fn has_restarted(&mut self) -> Option<Text> {
        if self.entered
            && let (Some(told), None) = self.mode_shown().await
        {
            let label = self.target.family.role_label("mode-active");
            return Some(both!(
                "the drive had lost its mode of operation ({label} = {told}), as behind a restart: the shaft may have coasted before",
                "der Antrieb hatte seine Betriebsart verloren ({label} = {told}), wie nach einem Neustart: die Welle lief vorher \
                 vielleicht aus"
            ));
        }
        self.undone().await
    }

    /// How often somebody has pressed since this was asked last.
    pub(super) fn fresh_presses(&mut self) -> u32 {
        let presses = self.session.presses();
        presses.saturating_sub(std::mem::replace(&mut self.heeded, presses))
    }

    /// Whether who interrupts asks for no more than the stop that the end of a run has brought already.
    pub(super) fn asks_for_this(&mut self, because: &str) -> bool {
        if because != "end" || self.relieving.is_some() {
            return false;
        }
        let heeded = self.heeded;
        self.session.note_interrupts();
        let is_first = self.fresh_presses() <= 1;
        if !is_first {
            // Who has pressed twice meanwhile has insisted.
            self.heeded = heeded + 1;
        }
        is_first
    }

    /// Somebody interrupts the strongest stop: it must have gone out, also into a busy line, but little more is waited for.
    pub(super) fn hurries(&mut self) {
        self.session.note_interrupts();
        if self.bound.is_none() {
            self.ends_within(HURRIED);
        }
    }

    /// Whether a stop that brings no answers is given up: as long as the drive answers now and then it goes out to it.
    /// `hurry`: somebody has asked for the strongest, and so for an end.
    pub(super) async fn gives_up(&mut self, begun: Tick, hurry: bool) -> bool {
        self.session.note_interrupts();
        let now = self.session.now();
        let limit = if self.relieving.is_some() || hurry { PURSUED_ALONE } else { PURSUED };
        let pursued = now.since(begun) >= limit || self.session.is_over();
        pursued || (now.since(self.heard) >= SILENT && !self.runs_on().await)
    }

    /// Whether the drive answers after all, and has power.
    async fn runs_on(&mut self) -> bool {
        let state = self.briefly(async |motor: &mut Self| motor.state().await).await;
        state.is_ok_and(|state| !STOPPED.contains(&state.slug.as_str()))
    }

    /// Asks a drive that is silent no longer than it is worth. What only takes motion away has an end of its own.
    pub(super) async fn briefly<T>(&mut self, ask: impl AsyncFnOnce(&mut Self) -> T) -> T {
        let bound = self.bound;
        if self.relieving.is_none() {
            let at = self.session.now() + BRIEFLY;
            self.bound = Some(bound.map_or(at, |bound| bound.min(at)));
            self.session.end_at(self.bound);
        }
        let told = ask(self).await;
        if self.relieving.is_none() {
            self.bound = bound;
            self.session.end_at(bound);
        }
        told
    }
}
