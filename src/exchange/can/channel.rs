//! An open channel of an adapter, between the frames of a conversation and what the adapter is told.

use super::traffic::Traffic;
use super::words::Words;
use crate::protocol::can::slcan::Word;
use crate::protocol::can::{Frame, Identifier, SdoChannel, Service, Telegram, telegram_frame};
use std::cell::RefCell;
use std::rc::Rc;

/// Answers that are kept until somebody takes them; many more than questions may be open.
const MOST: usize = 64;

/// An open channel that passes on the SDOs of one kind, and nothing else.
#[derive(Debug)]
pub struct Channel {
    sdo: SdoChannel,
    words: Words,
    traffic: Rc<RefCell<Traffic>>,
    /// Frames of ours that nobody answered so far, one behind the other.
    unanswered: u32,
    /// Status flags of the adapter, as they were told since then.
    flags: Option<u8>,
    /// The adapter refused what it was told.
    is_refused: bool,
}

impl Channel {
    /// A channel that is open; what is heard goes into the traffic.
    pub fn new(sdo: SdoChannel, traffic: Rc<RefCell<Traffic>>) -> Self {
        Channel { sdo, words: Words::default(), traffic, unanswered: 0, flags: None, is_refused: false }
    }

    /// What the adapter is to be told so that a frame goes out. Where the one before it was not answered it is asked how the bus is,
    /// too. What is no SDO, such as a command to nodes, is answered by nobody.
    pub fn put(&mut self, telegram: &[u8]) -> Vec<u8> {
        let frame = telegram_frame(telegram);
        let is_answered = Telegram::decode(telegram).is_some();
        let mut told = String::new();
        if self.unanswered > 0 && is_answered {
            told += "F\r";
        }
        if let Some(frame) = frame {
            told += &format!("{}\r", Word::Frame { frame, at_ms: None });
        }
        if is_answered {
            (self.unanswered, self.flags) = (self.unanswered.saturating_add(1), None);
        }
        told.into_bytes()
    }

    /// The frames among what the adapter says that are SDOs of this kind, also those that are too short for one.
    pub fn take(&mut self, said: &[u8]) -> Vec<u8> {
        let mut telegrams = Vec::new();
        for word in self.words.feed(said) {
            match word {
                Word::Frame { frame, .. } => {
                    self.traffic.borrow_mut().hears(&frame);
                    let whole = Telegram::of(&frame).map(|telegram| telegram.encode());
                    let bytes = whole.or_else(|| Telegram::cut_short(&frame));
                    telegrams.extend(bytes.filter(|_| self.is_meant(&frame)));
                }
                Word::Flags(flags) => self.flags = Some(flags),
                Word::Refused => self.is_refused = true,
                _ => {}
            }
        }
        if !telegrams.is_empty() {
            self.unanswered = 0;
        }
        telegrams.into_iter().take(MOST).flatten().collect()
    }

    /// Whether the adapter refused something, once.
    pub fn refused(&mut self) -> bool {
        std::mem::take(&mut self.is_refused)
    }

    /// The flags of the adapter, if nobody has answered for a while and they tell of errors.
    pub fn ails(&self) -> Option<u8> {
        self.flags.filter(|flags| flags & Word::ERRORS != 0)
    }

    /// What closes it.
    pub fn farewell() -> &'static [u8] {
        b"C\r"
    }

    fn is_meant(&self, frame: &Frame) -> bool {
        let Identifier::Standard(identifier) = frame.identifier else { return false };
        match Service::of(identifier) {
            Service::SdoReply(channel, _) | Service::SdoRequest(channel, _) => channel == self.sdo,
            _ => false,
        }
    }
}
