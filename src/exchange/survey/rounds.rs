//! Who is asked again: whoever may have sent garbage, and at the first addresses whoever was silent.

use super::*;

/// So often garbage must come when a station is asked alone before it is given up.
pub(super) const TRIES: u32 = 3;
/// From so many questions on it can be told that the line itself makes the garbage.
const NOISE_SAMPLE: u32 = 8;
/// Times around: windows double from one to the next, so by then every station has been asked by the book, and often enough.
const MOST_ROUNDS: u32 = 16;

/// One time around.
#[derive(Clone, Copy, Debug)]
pub(super) struct Round {
    pub(super) number: u32,
    pub(super) window: Span,
    pub(super) asked: u32,
    pub(super) garbage: u32,
}

impl Survey {
    /// Silent stations that garbage came from: again and again, or right after the only question to them.
    pub fn garbled(&self) -> impl Iterator<Item = u8> {
        let soon = |station: &u8| self.suspects.get(station).is_some_and(|&delay| delay <= self.patience.window);
        let once = move |station: &u8| !self.patience.again && soon(station);
        let silent = self.stations.iter().filter(|(_, known)| !known.heard);
        silent.filter(move |(station, known)| known.garbled >= TRIES || once(station)).map(|(&station, _)| station)
    }

    /// Who is to be asked again, and how long before the garbage he was asked.
    pub(super) fn suspicious(&self) -> impl Iterator<Item = (u8, Span)> {
        let first = if self.round.number == 0 { self.patience.twice } else { 0 };
        let again = self.order.iter().take(first).filter(|station| !self.suspects.contains_key(station));
        let suspects = self.suspects.iter().map(|(&station, &delay)| (station, delay));
        let all = suspects.chain(again.map(|&station| (station, self.patience.full)));
        all.filter(|(station, _)| self.stations.get(station).is_some_and(|known| !known.heard && known.garbled < TRIES))
    }

    /// Whether garbage comes so often that it is the line's own: then nobody is asked again for it.
    fn is_usual(&self) -> bool {
        self.round.asked >= NOISE_SAMPLE && self.round.garbage > self.round.asked / 2
    }

    /// How many are still to be asked, or asked again.
    pub fn pending(&self) -> usize {
        let again = if self.is_usual() || !self.patience.again { 0 } else { self.suspects.len() };
        self.queue.len() + again
    }

    /// Puts the suspects into the queue; `false` if there are none.
    pub(super) fn next_round(&mut self) -> bool {
        if !self.patience.again {
            // Who is suspected stays it: somebody else decides what becomes of him.
            self.noisy |= self.is_usual();
            return false;
        }
        let mut suspects: Vec<(u8, Span)> = self.suspicious().collect();
        self.suspects.clear();
        // The most suspicious first: who was asked right before the garbage came.
        suspects.sort_by_key(|suspect| suspect.1);
        let usual = self.is_usual();
        self.noisy |= usual;
        let enough = self.round.number >= MOST_ROUNDS;
        if suspects.is_empty() || usual || enough {
            return false;
        }
        let window = match self.round.number {
            _ if suspects.len() == 1 => self.patience.full,
            0 => self.patience.second_window(),
            _ => self.round.window.times(2).min(self.patience.full),
        };
        self.queue = suspects.into_iter().map(|suspect| suspect.0).collect();
        self.round = Round { number: self.round.number + 1, window, asked: 0, garbage: 0 };
        true
    }

    /// Whoever may have sent what began last and nobody understands, or what nobody was asked for.
    pub(super) fn suspect(&mut self) {
        self.round.garbage += 1;
        self.garbage += 1;
        let (began, full) = (self.ear.began(), self.patience.full);
        let silent = self.stations.iter().filter(|(_, station)| !station.heard);
        let within = silent.map(|(&station, known)| (station, began.since(known.end)));
        let suspects: Vec<(u8, Span)> = within.filter(|&(_, delay)| delay < full).collect();
        if let [(only, _)] = suspects.as_slice()
            && let Some(known) = self.stations.get_mut(only)
        {
            known.garbled += 1;
        }
        for (station, delay) in suspects {
            let shortest = self.suspects.entry(station).or_insert(delay);
            *shortest = delay.min(*shortest);
        }
    }
}
