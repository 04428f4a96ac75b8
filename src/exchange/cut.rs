//! Cuts what somebody hears who never asks into telegrams and what is none.

use super::dialect::{Cut, Dialect};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::tick::Span;

/// Cuts bytes into telegrams and what is none; every byte comes out once, in order. Nobody has asked, so no question says how a
/// reply ends; adapters deliver bytes in chunks, so silences tell little.
#[derive(Debug)]
pub struct Cutter {
    cut: Box<dyn Cut>,
    pause: Span,
}

impl Cutter {
    /// A cutter of what is spoken so on a line.
    pub fn new(protocol: Protocol, line: LineSetting) -> Self {
        let (cut, pause) = Dialect::new(protocol).cutter(line);
        Cutter { cut, pause }
    }

    /// The pieces that are certain now that these bytes came.
    pub fn feed(&mut self, bytes: &[u8]) -> Vec<Vec<u8>> {
        self.cut.feed(bytes)
    }

    /// The pieces of everything that is open, as nothing followed for [`Cutter::pause`].
    pub fn silence(&mut self) -> Vec<Vec<u8>> {
        self.cut.silence()
    }

    /// A silence that leaves nothing open.
    pub fn pause(&self) -> Span {
        self.pause
    }
}
