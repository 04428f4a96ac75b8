//! Before the first byte: does somebody else speak on the line?

use super::*;
use crate::exchange::talk::{WINDOW, Window};
use crate::text::both;

/// Settings at which it is listened to at least if somebody speaks: two tell too little of how often he does.
const LEAST: usize = 4;

impl Search<'_, '_, '_> {
    /// Listens before anything is asked, and if somebody speaks, at every setting: whose line it is, is known before it is searched.
    pub(super) async fn overhear(&mut self) -> Result<(), AccessError> {
        if self.searched.len() == 1 {
            return Ok(());
        }
        let lines = self.ears();
        let most = lines.len().max(LEAST);
        self.tell_listening(None);
        // Who must end soon listens for half of his time to noise: the rest is for the questions.
        let (began, named) = (self.session.now(), self.named_end());
        let half = named.map(|at| began + Span::from_micros(at.since(began).as_micros() / 2).longer(WINDOW));
        for (index, &tuning) in lines.iter().cycle().take(most).enumerate() {
            let now = self.session.now();
            let is_over = half.is_some_and(|at| now >= at);
            if index > 0 && (self.talk.is_silent() || self.talk.certain().is_some() || is_over) {
                break;
            }
            if index == 1 {
                self.tell_listening(Some(most));
            }
            self.listen_at(tuning).await?;
        }
        self.pace.overhears(self.talk.listened, self.talk.bursts);
        self.yields_to(self.talk.verdict());
        Ok(())
    }

    /// The settings at which it is listened to: 8 bits tell what 7 do, and a protocol is none of a line.
    fn ears(&self) -> Vec<Tuning> {
        let all = || self.searched.iter().map(|searched| searched.tuning);
        let eight = all().any(|ear| ear.line.data_bits == 8);
        let mut ears: Vec<Tuning> = Vec::new();
        for ear in all().filter(|ear| !eight || ear.line.data_bits == 8) {
            if !ears.iter().any(|known| known.line == ear.line) {
                ears.push(ear);
            }
        }
        ears
    }

    async fn listen_at(&mut self, tuning: Tuning) -> Result<(), AccessError> {
        self.retune(tuning).await?;
        let now = self.session.now();
        let until = self.named_end().map_or(now + WINDOW, |at| at.min(now + WINDOW));
        let mut window = Window::new(tuning.line, now, until);
        self.session.eavesdrop(&mut window).await?;
        if window.is_occupied() {
            // Whatever the parity is: bytes come all the time.
            let same = self.searched.iter_mut().filter(|searched| searched.tuning.line.baud == tuning.line.baud);
            same.for_each(|searched| searched.occupied = true);
        }
        window.adds_to(&mut self.talk, self.session.now());
        Ok(())
    }

    /// Leaves the line to somebody, unless it was ordered to go on beside him.
    pub(super) fn yields_to(&mut self, talker: Option<Talker>) {
        let occupied = self.searched.iter().any(|searched| searched.occupied);
        // Of a line that is never silent that is told.
        let Some(to) = talker.filter(|&to| to == Talker::Master || !occupied) else { return };
        let unasked = self.searched.iter().all(|searched| searched.rounds == 0);
        let Talk { bursts, listened, .. } = self.talk;
        let yielded = Yielded { to, bursts, listened, unasked };
        match self.plan.force {
            true if unasked => self.warnings.push(look::beside(yielded)),
            true => {}
            false => _ = self.yielded.get_or_insert(yielded),
        }
    }

    fn tell_listening(&mut self, settings: Option<usize>) {
        let text = match settings {
            None => both!("listening first, for {WINDOW}", "zuerst wird {WINDOW} zugehört"),
            Some(settings) => both!(
                "somebody speaks on the line; listening at up to {settings} settings, for {most} at most",
                "jemand spricht auf der Leitung; es wird mit bis zu {settings} Einstellungen zugehört, höchstens {most}",
                most = WINDOW.times(settings as u64)
            ),
        };
        self.session.tell(Event::Note(text));
    }
}
