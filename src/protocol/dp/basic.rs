//! The words of the Basic block of an SJ2-PB (manual 3.2.2, 3.2.3).

/// Bits 13 to 8 of the status word: the cause of a trip.
pub fn trip_cause(status: u16) -> u8 {
    (status >> 8 & 0x3F) as u8
}

/// The status word without the cause of a trip.
pub fn flags(status: u16) -> u16 {
    status & !0x3F00
}

/// Whether the inverter has tripped; without it the cause says nothing, because 0 is one too.
pub fn is_faulted(status: u16) -> bool {
    status & FAULTED != 0
}

/// Bit 7 of the status word.
const FAULTED: u16 = 0x0080;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cause_is_parted_from_the_flags() {
        // Earth fault (0Dh) under control of the bus.
        let status = 0x0D80 | 0x0050;
        assert_eq!((trip_cause(status), flags(status), is_faulted(status)), (0x0D, 0x00D0, true));
        assert_eq!((trip_cause(0x0051), flags(0x0051), is_faulted(0x0051)), (0, 0x0051, false));
        assert_eq!((trip_cause(0xFFFF), flags(0xFFFF)), (0x3F, 0xC0FF));
    }
}
