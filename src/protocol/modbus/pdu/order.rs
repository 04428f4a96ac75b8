//! 32 bits in two registers.

/// Which half of a 32-bit value stands in the first register. The LXM05 keeps it in MBdword_order (LXM05 manual 4.1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum WordOrder {
    /// The upper 16 bits: factory setting.
    #[default]
    HighFirst,
    /// The lower 16 bits.
    LowFirst,
}

impl WordOrder {
    /// The two registers of a value, in the order of the telegram.
    pub const fn split(self, value: u32) -> [u16; 2] {
        let (high, low) = ((value >> 16) as u16, value as u16);
        match self {
            WordOrder::HighFirst => [high, low],
            WordOrder::LowFirst => [low, high],
        }
    }

    /// The value of two registers, in the order of the telegram.
    pub const fn join(self, [first, second]: [u16; 2]) -> u32 {
        let (high, low) = match self {
            WordOrder::HighFirst => (first, second),
            WordOrder::LowFirst => (second, first),
        };
        (high as u32) << 16 | low as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_example_of_the_manual_goes_both_ways() {
        // LXM05 manual 4.1: 1234 5678h.
        for (order, words) in [(WordOrder::HighFirst, [0x1234, 0x5678]), (WordOrder::LowFirst, [0x5678, 0x1234])] {
            assert_eq!((order.split(0x1234_5678), order.join(words)), (words, 0x1234_5678));
        }
    }
}
