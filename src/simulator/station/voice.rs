//! The voice of a station: when its replies go out.
//!
//! Choice where the manual is silent: two requests in a row are answered in a row; of more than [`QUEUE`] the rest is
//! forgotten.

use super::setup::Setup;
use crate::protocol::line::LineSetting;
use crate::simulator::device::contract::{Effect, TURNAROUND};
use crate::simulator::dice::Dice;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// Most replies that wait to be sent.
const QUEUE: usize = 4;

/// A reply with its frame, and what follows it.
#[derive(Clone, Debug)]
pub(crate) struct QueuedReply {
    pub(crate) frame: Vec<u8>,
    pub(crate) effect: Effect,
    pub(crate) exception: bool,
}

/// Replies that wait or go out.
#[derive(Clone, Debug)]
pub(crate) struct Voice {
    pending: VecDeque<(Tick, QueuedReply)>,
    sending: Option<(Tick, Effect)>,
    delay: Span,
    jitter: Span,
    dice: Dice,
    pub(crate) answered: u64,
    pub(crate) exceptions: u64,
}

impl Voice {
    pub(crate) fn new(setup: &Setup) -> Self {
        Voice {
            pending: VecDeque::new(),
            sending: None,
            delay: setup.delay,
            jitter: setup.jitter,
            dice: Dice::new(setup.seed),
            answered: 0,
            exceptions: 0,
        }
    }

    /// Nothing goes out any more.
    pub(crate) fn hush(&mut self) {
        self.pending.clear();
        self.sending = None;
    }

    /// Whether it speaks at this time, by what it says now.
    pub(crate) fn speaks(&self, at: Tick) -> bool {
        self.sending.is_some_and(|(until, _)| at < until)
    }

    /// Queues a reply to a request that ended at `last`: not before 10 ms or what the bench file says, and never before
    /// the silence `rest` (CM-485 manual 6.8, 6.7.1.3).
    pub(crate) fn queue(&mut self, line: LineSetting, last: Tick, rest: Span, said: QueuedReply) {
        if self.pending.len() >= QUEUE {
            return;
        }
        let jitter = Span::from_micros(self.dice.below(self.jitter.as_micros().saturating_add(1)));
        let mut start = last + self.delay + jitter;
        let before = self.pending.back().map(|(start, said)| *start + line.chars(said.frame.len() as u64));
        if let Some(free) = before.or(self.sending.map(|(until, _)| until)) {
            start = start.max(free + TURNAROUND.longer(rest));
        }
        self.pending.push_back((start.max(last + rest), said));
    }

    /// When it begins or ends to speak.
    pub(crate) fn next(&self) -> Option<Tick> {
        match self.sending {
            Some((until, _)) => Some(until),
            None => self.pending.front().map(|reply| reply.0),
        }
    }

    /// The end of a reply that is out by `now`, and what follows it.
    pub(crate) fn ended(&mut self, now: Tick) -> Option<(Tick, Effect)> {
        self.sending.take_if(|(until, _)| *until <= now)
    }

    /// The frame of a reply that starts now.
    pub(crate) fn starts(&mut self, now: Tick, line: LineSetting) -> Option<Vec<u8>> {
        if self.sending.is_some() {
            return None;
        }
        self.pending.front().filter(|reply| reply.0 <= now)?;
        let (_, said) = self.pending.pop_front()?;
        self.sending = Some((now + line.chars(said.frame.len() as u64), said.effect));
        self.answered += 1;
        self.exceptions += u64::from(said.exception);
        Some(said.frame)
    }
}
