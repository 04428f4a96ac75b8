//! A channel that only listens: every frame that is heard, and nothing that ever goes out on the bus.

use super::words::Words;
use crate::protocol::can::Frame;
use crate::protocol::can::slcan::Word;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

/// What was heard and not taken yet.
#[derive(Debug, Default)]
pub struct Overheard {
    /// Frames; when they are too many, the newest are lost.
    pub frames: VecDeque<Frame>,
    /// Frames that were lost so.
    pub lost: u64,
    /// What the adapter said that is no word.
    pub damaged: VecDeque<Vec<u8>>,
    /// Status flags of the adapter, as it told them last.
    pub flags: Option<u8>,
}

/// Frames that are kept; a bus of 1 Mbit/s brings so many in two seconds.
const MOST: usize = 16_384;

/// An open channel that listens.
#[derive(Debug)]
pub struct Ear {
    words: Words,
    overheard: Rc<RefCell<Overheard>>,
    /// A word was heard from its beginning: what comes first may be the rest of one.
    is_in: bool,
}

impl Ear {
    /// What is heard goes there.
    pub fn new(overheard: Rc<RefCell<Overheard>>) -> Self {
        Ear { words: Words::default(), overheard, is_in: false }
    }

    /// Asks the adapter how the bus is; the bus hears nothing of it.
    pub fn asks() -> Vec<u8> {
        format!("{}\r", Word::Status).into_bytes()
    }

    /// Takes what the adapter says; a byte for everything that somebody may wait for.
    pub fn take(&mut self, said: &[u8]) -> Vec<u8> {
        let mut overheard = self.overheard.borrow_mut();
        let words = self.words.feed(said);
        let damaged = self.words.damaged().into_iter();
        let mut count = 0;
        for bytes in damaged.skip(usize::from(!self.is_in && words.is_empty())) {
            if overheard.damaged.len() < MOST {
                overheard.damaged.push_back(bytes);
            }
            count += 1;
        }
        self.is_in |= said.contains(&Words::END);
        for word in words {
            match word {
                Word::Frame { frame, .. } if overheard.frames.len() < MOST => overheard.frames.push_back(frame),
                Word::Frame { .. } => overheard.lost += 1,
                Word::Flags(flags) => overheard.flags = Some(flags),
                _ => continue,
            }
            count += 1;
        }
        vec![0; count]
    }
}
