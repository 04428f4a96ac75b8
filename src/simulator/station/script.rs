//! The script of a station: what happens to it, and when.

use crate::simulator::device::contract::{Action, Device};
use crate::tick::{Span, Tick};

/// Something that the script lets happen, once.
#[derive(Clone, Debug)]
pub(crate) struct Event {
    pub(crate) trigger: Trigger,
    pub(crate) action: Action,
    /// The opposite follows after this time.
    pub(crate) lasts: Option<Span>,
}

/// What it waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Trigger {
    /// A time.
    At(Tick),
    /// The output stage works.
    Running,
    /// The turning field is faster than this, in either direction; 0.01 Hz.
    Above(i64),
    /// So many writes have come to it, broadcasts included, obeyed or refused. The last of them is obeyed first; its
    /// reply comes after the event.
    Writes(u64),
    /// So many telegrams have come to it. The last of them is obeyed first; its reply comes after the event.
    Telegrams(u64),
}

/// What is still to happen, and what some of it waits for.
#[derive(Clone, Debug)]
pub(crate) struct Script {
    events: Vec<Event>,
    /// Telegrams, and writes among them, that have come to the station.
    telegrams: u64,
    writes: u64,
}

impl Script {
    pub(crate) fn new(events: Vec<Event>) -> Self {
        Script { events, telegrams: 0, writes: 0 }
    }

    /// A telegram has come.
    pub(crate) fn count(&mut self, is_write: bool) {
        self.telegrams += 1;
        self.writes += u64::from(is_write);
    }

    /// A broadcast of VABus has come.
    pub(crate) fn count_broadcast(&mut self, is_write: bool) {
        self.writes += u64::from(is_write);
    }

    /// When it goes on, as far as that can be told.
    pub(crate) fn next(&self, device: &dyn Device) -> Option<Tick> {
        let scenes = self.events.iter().filter_map(|event| match event.trigger {
            Trigger::At(at) => Some(at),
            Trigger::Above(limit) => device.rises_above(limit),
            Trigger::Running | Trigger::Writes(_) | Trigger::Telegrams(_) => None,
        });
        scenes.min()
    }

    /// What is due now; call again until nothing is.
    pub(crate) fn due(&mut self, now: Tick, device: &dyn Device) -> Option<Action> {
        let place = self.events.iter().position(|event| self.is_due(event.trigger, now, device))?;
        let event = self.events.remove(place);
        let back = event.lasts.zip(event.action.opposite());
        self.events.extend(back.map(|(span, action)| Event { trigger: Trigger::At(now + span), action, lasts: None }));
        Some(event.action)
    }

    fn is_due(&self, trigger: Trigger, now: Tick, device: &dyn Device) -> bool {
        match trigger {
            Trigger::At(at) => at <= now,
            Trigger::Writes(count) => count <= self.writes,
            Trigger::Telegrams(count) => count <= self.telegrams,
            Trigger::Running => device.runs(),
            Trigger::Above(limit) => device.is_above(now, limit),
        }
    }
}
