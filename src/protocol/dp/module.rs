//! Parameter bytes of a module of the SJ2-PB in Basic mode (manual 3.1.1 and 3.1.2).
//!
//! L200 and SJ200 have one format, X200 a shorter one; an even number of bytes is always an X200, an odd one never. How the bytes
//! of all modules stand in Set_Prm, and what may stand in front of them, says only the GSD.

/// A module of a configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Module {
    /// Which format, and which inverter is expected.
    pub series: Series,
    /// What it carries.
    pub content: Content,
    /// Low byte first, or what else the manual may mean by it (3.1.1, bit 4).
    pub swapped: bool,
}

/// Which inverter the module expects; the configuration is not taken over if another one is there (3.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Series {
    /// Bit 7 of the first byte set.
    L200,
    /// The same format with bit 7 clear.
    Sj200,
    /// The shorter format.
    X200,
}

/// What a module carries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Content {
    /// Four words in and out (3.2).
    Basic,
    /// One parameter.
    Parameter {
        /// By index or by address.
        target: Target,
        /// To the inverter, not from it.
        is_output: bool,
        /// Bytes of the value: 1 to 8 on L200 and SJ200; the format of X200 does not tell.
        length: Option<u8>,
        /// Least and largest value of an output.
        limits: Limits,
    },
}

/// How a parameter is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Number of the parameter list (5.5), of the gateway or of PROFIdrive.
    Index(u16),
    /// Address of the inverter's option port.
    Address(u16),
}

/// Least and largest value that the module lets through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limits {
    /// Not generic: none are said.
    None,
    /// Of one byte.
    Byte(u8, u8),
    /// Of two bytes.
    Word(u16, u16),
    /// Generic, and no bytes follow.
    Missing,
}

/// Why bytes are no module, or a module cannot be said in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ModuleError {
    /// No format has this many bytes.
    #[error("length {0}; a module has 3, 5 or 7 bytes (L200, SJ200), or 2, 4 or 6 (X200)")]
    Length(usize),
    /// The index or address does not fit into the format.
    #[error("{0:04X}h does not fit into the module's bytes")]
    Target(u16),
}

/// Flags of the first byte of L200 and SJ200 (3.1.1).
mod long {
    pub(super) const L200: u8 = 0x80;
    pub(super) const OUTPUT: u8 = 0x40;
    pub(super) const GENERIC: u8 = 0x20;
    pub(super) const SWAPPED: u8 = 0x10;
    pub(super) const ADDRESS: u8 = 0x08;
    pub(super) const LENGTH: u8 = 0x07;
    /// In place of an index: the Basic block.
    pub(super) const BASIC: u16 = 0xFFFF;
    /// The Basic block has eight bytes in each direction, and is printed as an output: C7 FF FF.
    pub(super) const BLOCK: u8 = OUTPUT | LENGTH;
}

/// Flags of the first byte of X200 (3.1.2).
mod short {
    pub(super) const OUTPUT: u8 = 0x80;
    pub(super) const GENERIC: u8 = 0x40;
    pub(super) const SWAPPED: u8 = 0x20;
    pub(super) const ADDRESS: u8 = 0x10;
    /// In place of an index: the Basic block, printed 8F FF.
    pub(super) const BASIC: u16 = 0x0FFF;
    /// An address lies from here on; 12 bits of it are said.
    pub(super) const FIRST: u16 = 0x1000;
}

impl Module {
    /// Reads the bytes of one module.
    pub fn decode(bytes: &[u8]) -> Result<Self, ModuleError> {
        match *bytes {
            [flags, high, low, ref rest @ ..] if !bytes.len().is_multiple_of(2) => {
                Self::long(flags, u16::from_be_bytes([high, low]), rest).ok_or(ModuleError::Length(bytes.len()))
            }
            [flags, low, ref rest @ ..] => {
                let number = u16::from_be_bytes([flags & 0x0F, low]);
                Self::short(flags, number, rest).ok_or(ModuleError::Length(bytes.len()))
            }
            _ => Err(ModuleError::Length(bytes.len())),
        }
    }

    fn long(flags: u8, number: u16, rest: &[u8]) -> Option<Self> {
        let has = |bit: u8| flags & bit != 0;
        let series = if has(long::L200) { Series::L200 } else { Series::Sj200 };
        let swapped = has(long::SWAPPED);
        let is_block = number == long::BASIC && rest.is_empty();
        if is_block && flags & !long::L200 & !long::SWAPPED == long::BLOCK {
            return Some(Module { series, content: Content::Basic, swapped });
        }
        let target = if has(long::ADDRESS) { Target::Address(number) } else { Target::Index(number) };
        let limits = limits(rest, has(long::GENERIC))?;
        let length = Some((flags & long::LENGTH) + 1);
        let content = Content::Parameter { target, is_output: has(long::OUTPUT), length, limits };
        Some(Module { series, content, swapped })
    }

    fn short(flags: u8, number: u16, rest: &[u8]) -> Option<Self> {
        let has = |bit: u8| flags & bit != 0;
        let (series, swapped) = (Series::X200, has(short::SWAPPED));
        if number == short::BASIC && rest.is_empty() && flags & 0xD0 == short::OUTPUT {
            return Some(Module { series, content: Content::Basic, swapped });
        }
        let target = match has(short::ADDRESS) {
            true => Target::Address(short::FIRST | number),
            false => Target::Index(number),
        };
        let limits = limits(rest, has(short::GENERIC))?;
        let content = Content::Parameter { target, is_output: has(short::OUTPUT), length: None, limits };
        Some(Module { series, content, swapped })
    }

    /// The bytes that say this.
    pub fn encode(&self) -> Result<Vec<u8>, ModuleError> {
        match self.series {
            Series::L200 => Ok(self.encode_long(long::L200)),
            Series::Sj200 => Ok(self.encode_long(0)),
            Series::X200 => self.encode_short(),
        }
    }

    fn encode_long(&self, series: u8) -> Vec<u8> {
        let bit = |is: bool, bit: u8| if is { bit } else { 0 };
        let common = series | bit(self.swapped, long::SWAPPED);
        let Content::Parameter { target, is_output, length, limits } = self.content else {
            return vec![common | long::BLOCK, 0xFF, 0xFF];
        };
        let (number, is_address) = target.split();
        let flags = common
            | bit(is_output, long::OUTPUT)
            | bit(limits != Limits::None, long::GENERIC)
            | bit(is_address, long::ADDRESS)
            | (length.unwrap_or(1).clamp(1, 8) - 1);
        let [high, low] = number.to_be_bytes();
        [&[flags, high, low], &limits.bytes()[..]].concat()
    }

    fn encode_short(&self) -> Result<Vec<u8>, ModuleError> {
        let bit = |is: bool, bit: u8| if is { bit } else { 0 };
        let swapped = bit(self.swapped, short::SWAPPED);
        let Content::Parameter { target, is_output, limits, .. } = self.content else {
            return Ok(vec![short::OUTPUT | swapped | 0x0F, 0xFF]);
        };
        let (number, is_address) = target.split();
        let base = if is_address { short::FIRST } else { 0 };
        // 0FFFh is the Basic block, so the last index is 0FFEh and the last address 1FFEh (3.1.2).
        let twelve =
            number.checked_sub(base).filter(|number| *number < short::BASIC).ok_or(ModuleError::Target(number))?;
        let [high, low] = twelve.to_be_bytes();
        let flags = bit(is_output, short::OUTPUT)
            | bit(limits != Limits::None, short::GENERIC)
            | swapped
            | bit(is_address, short::ADDRESS)
            | high;
        Ok([&[flags, low], &limits.bytes()[..]].concat())
    }
}

impl Target {
    /// Number, and whether it is an address.
    fn split(self) -> (u16, bool) {
        match self {
            Target::Index(number) => (number, false),
            Target::Address(number) => (number, true),
        }
    }
}

impl Limits {
    fn bytes(self) -> Vec<u8> {
        match self {
            Limits::None | Limits::Missing => Vec::new(),
            Limits::Byte(min, max) => vec![min, max],
            Limits::Word(min, max) => [min.to_be_bytes(), max.to_be_bytes()].concat(),
        }
    }
}

/// Limits follow where the bit says so; that they follow without it is one way to read 3.1.2, which no example bears out.
fn limits(rest: &[u8], is_generic: bool) -> Option<Limits> {
    match *rest {
        [] if is_generic => Some(Limits::Missing),
        [] => Some(Limits::None),
        [min, max] if is_generic => Some(Limits::Byte(min, max)),
        [a, b, c, d] if is_generic => Some(Limits::Word(u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d]))),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn parameter(series: Series, target: Target, is_output: bool, limits: Limits, swapped: bool) -> Module {
        let length = (series != Series::X200).then_some(2);
        Module { series, content: Content::Parameter { target, is_output, length, limits }, swapped }
    }

    /// The examples of 3.1.1 and 3.1.2, both ways.
    #[test]
    fn the_modules_of_the_manual() {
        use {Limits::Word, Series::*, Target::*};
        let block = |series| Module { series, content: Content::Basic, swapped: false };
        let examples: [(Module, &[u8]); 8] = [
            (parameter(L200, Index(7), false, Limits::None, false), &[0x81, 0x00, 0x07]),
            (parameter(L200, Address(0x1210), false, Limits::None, true), &[0x99, 0x12, 0x10]),
            (block(L200), &[0xC7, 0xFF, 0xFF]),
            (parameter(L200, Index(9), true, Word(1, 0x7530), false), &[0xE1, 0x00, 0x09, 0x00, 0x01, 0x75, 0x30]),
            (parameter(X200, Index(7), false, Limits::None, false), &[0x00, 0x07]),
            (parameter(X200, Address(0x1210), false, Limits::None, true), &[0x32, 0x10]),
            (block(X200), &[0x8F, 0xFF]),
            (parameter(X200, Index(9), true, Word(1, 0x7530), false), &[0xC0, 0x09, 0x00, 0x01, 0x75, 0x30]),
        ];
        for (module, bytes) in examples {
            assert_eq!(module.encode().as_deref(), Ok(bytes));
            assert_eq!(Module::decode(bytes), Ok(module));
        }
        assert_eq!(block(Sj200).encode().unwrap(), [0x47, 0xFF, 0xFF]);
    }

    /// FFFh is the Basic block only where nothing follows and it is as the manual's (3.1.2).
    #[test]
    fn what_is_almost_a_basic_block_is_none() {
        for bytes in
            [&[0x0F, 0xFF][..], &[0x80, 0x07], &[0xCF, 0xFF, 0, 1, 0, 2], &[0x41, 0xFF, 0xFF], &[0xC7, 0x00, 0x07]]
        {
            let content = Module::decode(bytes).map(|module| module.content);
            assert!(matches!(content, Ok(Content::Parameter { .. })), "{bytes:02X?}: {content:?}");
        }
    }

    #[test]
    fn limits_of_a_byte_are_two_bytes() {
        let limited = parameter(Series::X200, Target::Index(9), true, Limits::Byte(1, 2), false);
        assert_eq!(Module::decode(&[0xC0, 0x09, 1, 2]), Ok(limited));
        let far = parameter(Series::X200, Target::Index(0x0FFF), true, Limits::None, false);
        assert_eq!(far.encode(), Err(ModuleError::Target(0x0FFF)));
    }

    #[test]
    fn what_is_no_module_is_refused() {
        for bytes in [&[][..], &[1], &[1; 8], &[1; 9], &[0x41, 0, 9, 1, 2]] {
            assert_eq!(Module::decode(bytes), Err(ModuleError::Length(bytes.len())), "{bytes:02X?}");
        }
        let far = parameter(Series::X200, Target::Address(0x2000), true, Limits::None, false);
        assert_eq!(far.encode(), Err(ModuleError::Target(0x2000)));
    }

    proptest! {
        #[test]
        fn every_module_comes_back_as_it_was(bytes in proptest::collection::vec(any::<u8>(), 0..9)) {
            if let Ok(module) = Module::decode(&bytes) && module.content != Content::Basic {
                match module.encode() {
                    Ok(again) => prop_assert_eq!(again, bytes),
                    Err(ModuleError::Target(number)) => prop_assert!(matches!(number, 0x0FFF | 0x1FFF)),
                    Err(other) => prop_assert!(false, "{}", other),
                }
            }
        }
    }
}
