//! What a bench has counted.

use super::judge::Gaps;

/// Closing counts of a bench.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Totals {
    /// Telegrams of the master, whole or not.
    pub received: u64,
    /// Broadcasts that drives obey.
    pub broadcasts: u64,
    /// Replies that drives sent, exceptions included.
    pub answered: u64,
    /// Exception replies among them.
    pub exceptions: u64,
    /// Telegrams that nobody answers.
    pub ignored: Ignored,
    /// EEPROM cells written, all drives together.
    pub eeprom_writes: u64,
    /// Remarks of the judge.
    pub remarks: u64,
    /// Pauses that the master kept behind replies.
    pub gaps: Gaps,
    /// Shafts that turn now, with power or without, those of a system bus too.
    pub turning: u64,
    /// Drives whose output stage feeds the motor now, turning or not.
    pub energised: u64,
}

/// Why telegrams were ignored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ignored {
    /// Wrong check value, torn, or no telegram at all.
    pub malformed: u64,
    /// No drive has this address.
    pub no_station: u64,
    /// The drive listens with another speed, parity or width.
    pub wrong_line: u64,
    /// The drive speaks another protocol.
    pub wrong_protocol: u64,
    /// The drive is off the bus: reset, power or script.
    pub away: u64,
    /// Broadcasts that are no write.
    pub broadcast_reads: u64,
}
