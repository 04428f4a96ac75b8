//! What a master says in Set_Prm (IEC 61158-6-3; fieldbus facts, "Set_Prm").

use crate::tick::Span;

/// Seven bytes that every slave takes, and those that its GSD asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// Byte 0, bit by bit: [`LOCK`] to [`WATCHDOG`].
    pub status: u8,
    /// Factors of the watchdog; their product times 10 ms is its time.
    pub watchdog: [u8; 2],
    /// Least pause of the slave before its answer, in bit times.
    pub min_tsdr: u8,
    /// Ident number that the slave must have.
    pub ident: u16,
    /// Groups that Global_Control reaches it by.
    pub groups: u8,
    /// What the GSD and the modules ask for.
    pub user: Vec<u8>,
}

/// The slave is this master's.
pub const LOCK: u8 = 0x80;
/// The slave is let go.
pub const UNLOCK: u8 = 0x40;
/// Outputs can be held.
pub const SYNC: u8 = 0x20;
/// Inputs can be held.
pub const FREEZE: u8 = 0x10;
/// The watchdog is on.
pub const WATCHDOG: u8 = 0x08;

impl Parameters {
    /// Reads the bytes; `None` if there are fewer than seven.
    pub fn decode(bytes: &[u8]) -> Option<Self> {
        let &[status, first, second, min_tsdr, high, low, groups, ref user @ ..] = bytes else { return None };
        let ident = u16::from_be_bytes([high, low]);
        Some(Parameters { status, watchdog: [first, second], min_tsdr, ident, groups, user: user.to_vec() })
    }

    /// The bytes that say this.
    pub fn encode(&self) -> Vec<u8> {
        let [high, low] = self.ident.to_be_bytes();
        let [first, second] = self.watchdog;
        [&[self.status, first, second, self.min_tsdr, high, low, self.groups], &self.user[..]].concat()
    }

    /// Time after which the slave lets go of its outputs; `None` if the watchdog is off.
    pub fn watchdog_time(&self) -> Option<Span> {
        let [first, second] = self.watchdog.map(u64::from);
        (self.status & WATCHDOG != 0).then(|| Span::from_millis(first * second * 10))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_telegram_of_the_facts() {
        let said = Parameters::decode(&[0xB8, 0x1E, 1, 0, 0x0A, 0x35, 1, 0, 0, 0, 0x82, 0, 0, 0]).unwrap();
        assert_eq!(said.status, LOCK | SYNC | FREEZE | WATCHDOG);
        assert_eq!((said.watchdog_time(), said.ident), (Some(Span::from_millis(300)), 0x0A35));
        assert_eq!((said.groups, said.user.len()), (1, 7));
        let watched = |status, watchdog| Parameters { status, watchdog, ..said.clone() }.watchdog_time();
        assert_eq!(watched(WATCHDOG, [10, 20]), Some(Span::from_secs(2)), "the product times 10 ms");
        assert_eq!(watched(LOCK | SYNC | FREEZE, [10, 20]), None, "it is off");
    }

    proptest! {
        #[test]
        fn every_telegram_comes_back_as_it_was(bytes in proptest::collection::vec(any::<u8>(), 0..244)) {
            match Parameters::decode(&bytes) {
                Some(said) => prop_assert_eq!(said.encode(), bytes),
                None => prop_assert!(bytes.len() < 7),
            }
        }
    }
}
