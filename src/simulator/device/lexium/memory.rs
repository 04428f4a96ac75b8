//! The fault memory, newest entry first.
//!
//! Where reading FLT_err_num moves on, the next reading shows the entry before; behind the oldest come zeros once, then
//! the newest again.

/// Number, class, time, qualifier.
type Entry = [i32; 4];

/// Entries that are kept.
const MOST: usize = 7;

#[derive(Clone, Debug, Default)]
pub(crate) struct Memory {
    entries: Vec<Entry>,
    shown: usize,
}

impl Memory {
    /// A new entry; it is shown next.
    pub(crate) fn keep(&mut self, entry: Entry) {
        self.entries.insert(0, entry);
        self.entries.truncate(MOST);
        self.shown = 0;
    }

    /// Goes to the entry before; `None` behind the oldest.
    pub(crate) fn move_on(&mut self) -> Option<Entry> {
        self.shown = if self.shown >= self.entries.len() { 0 } else { self.shown + 1 };
        self.entries.get(self.shown).copied()
    }
}
