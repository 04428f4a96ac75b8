//! Cuts what an adapter says into words.

use crate::protocol::can::slcan::Word;

/// Bytes of the longest word, and some: a frame of 29 bits and eight bytes with its time has 30 (Lawicel CANUSB manual).
const LONGEST: usize = 40;
const BELL: u8 = 7;

/// What an adapter says, word by word.
#[derive(Debug, Default)]
pub(super) struct Words {
    bytes: Vec<u8>,
    /// Bytes that are no word.
    garbage: u64,
    /// What was damaged and nobody took yet, the first of it.
    damaged: Vec<Vec<u8>>,
}

/// Damaged words that are kept until somebody takes them.
const MOST: usize = 1_024;

impl Words {
    /// What ends a word.
    pub(super) const END: u8 = b'\r';

    /// The words that end with these bytes.
    pub(super) fn feed(&mut self, bytes: &[u8]) -> Vec<Word> {
        let mut words = Vec::new();
        for &byte in bytes {
            match byte {
                Self::END => words.extend(self.end()),
                BELL => {
                    // What stood before it is nothing that an adapter ends so.
                    self.spoilt();
                    words.push(Word::Refused);
                }
                b'\n' => {}
                byte if self.bytes.len() < LONGEST => self.bytes.push(byte),
                _ => self.garbage += 1,
            }
        }
        words
    }

    /// Bytes so far that were no word.
    pub(super) fn garbage(&self) -> u64 {
        self.garbage + self.bytes.len() as u64
    }

    fn end(&mut self) -> Option<Word> {
        let bytes = std::mem::take(&mut self.bytes);
        let word = std::str::from_utf8(&bytes).ok().and_then(|text| Word::read(text).ok());
        if word.is_none() {
            self.discard(bytes);
        }
        word
    }

    fn spoilt(&mut self) {
        let bytes = std::mem::take(&mut self.bytes);
        self.discard(bytes);
    }

    fn discard(&mut self, bytes: Vec<u8>) {
        self.garbage += bytes.len() as u64;
        if !bytes.is_empty() && self.damaged.len() < MOST {
            self.damaged.push(bytes);
        }
    }

    /// What was damaged since, word by word.
    pub(super) fn damaged(&mut self) -> Vec<Vec<u8>> {
        std::mem::take(&mut self.damaged)
    }
}
