//! What the ports know of each other whose drives are stopped at the same time: whoever leaves sees nobody any more, so all leave at once.

use std::cell::Cell;

/// All of them.
#[derive(Default)]
pub(super) struct Ports {
    /// So many are not through yet.
    busy: Cell<usize>,
    /// So often drives were stopped anew behind their proof, or that came to its end.
    stops: Cell<u32>,
}

/// One of them.
pub(super) struct Port<'a> {
    all: &'a Ports,
    /// Its drives are looked at until the others are through, and so it is waited for.
    waits: bool,
    /// It is counted among those that are not through.
    counts: Cell<bool>,
}

impl Ports {
    /// So many, of which nobody knows yet whether their drives are at rest.
    pub(super) fn new(ports: usize) -> Self {
        Ports { busy: Cell::new(ports), stops: Cell::default() }
    }

    /// One of those.
    pub(super) fn port(&self) -> Port<'_> {
        Port { all: self, waits: true, counts: Cell::new(true) }
    }

    /// A port with the eyes of one of several lines: it neither waits nor is waited for, since the others have their turn behind it.
    pub(super) fn one_of_several_lines(&self) -> Port<'_> {
        Port { all: self, waits: false, counts: Cell::new(false) }
    }

    /// So often drives were stopped anew, or that came to its end: who was seen before saw less than all.
    pub(super) fn stops(&self) -> u32 {
        self.stops.get()
    }
}

impl Port<'_> {
    /// Its drives are at rest, and were seen so a moment ago; or were not reached.
    pub(super) fn is_done(&self) {
        if self.counts.replace(false) {
            self.all.busy.set(self.all.busy.get().saturating_sub(1));
        }
    }

    /// Nobody knows of its drives whether they are at rest.
    pub(super) fn is_busy(&self) {
        if self.waits && !self.counts.replace(true) {
            self.all.busy.set(self.all.busy.get() + 1);
        }
    }

    /// Its drives are stopped anew.
    pub(super) fn begins_anew(&self) {
        self.is_busy();
        self.counts_a_stop();
    }

    /// A stop begins, or has come to its end.
    pub(super) fn counts_a_stop(&self) {
        self.all.stops.set(self.stops().saturating_add(1));
    }

    /// As [`Ports::stops`].
    pub(super) fn stops(&self) -> u32 {
        self.all.stops()
    }

    /// Whether it has to wait for others.
    pub(super) fn others_are_busy(&self) -> bool {
        self.waits && self.all.busy.get() > usize::from(self.counts.get())
    }
}
