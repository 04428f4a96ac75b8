//! Cuts what an adapter says into words.

use crate::protocol::can::slcan::Word;

/// Bytes of the longest word, and some: a frame of 29 bits and eight bytes with its time has 30 (Lawicel CANUSB manual).
const LONGEST: usize = 40;
const END: u8 = b'\r';
const BELL: u8 = 7;

/// What an adapter says, word by word.
#[derive(Debug, Default)]
pub(super) struct Words {
    bytes: Vec<u8>,
    /// Bytes that are no word.
    garbage: u64,
}

impl Words {
    /// The words that end with these bytes.
    pub(super) fn feed(&mut self, bytes: &[u8]) -> Vec<Word> {
        let mut words = Vec::new();
        for &byte in bytes {
            match byte {
                END => words.extend(self.end()),
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
            self.garbage += bytes.len() as u64;
        }
        word
    }

    fn spoilt(&mut self) {
        self.garbage += std::mem::take(&mut self.bytes).len() as u64;
    }
}
