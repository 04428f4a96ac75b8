//! The parts that telegrams are made of, each with the characters that stand for it.

use super::TelegramError;
use std::fmt;

/// Who is spoken to: one drive, or all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Address(u8);

impl Address {
    /// Highest node id of a drive, P.394 (CM-485 manual 11.2).
    pub const LAST: u8 = 30;
    /// All drives obey, nobody answers (sources A1: address 32).
    pub const BROADCAST: Address = Address(32);
    /// Character of address 0, if it existed.
    const BASE: u8 = 0x40;

    /// The drive with this node id, 1-30; `None` for any other number.
    pub fn drive(id: u8) -> Option<Self> {
        (1..=Self::LAST).contains(&id).then_some(Address(id))
    }

    /// Node id 1-30, or 32 for a broadcast.
    pub const fn id(self) -> u8 {
        self.0
    }

    /// Whether all drives are spoken to.
    pub fn is_broadcast(self) -> bool {
        self == Self::BROADCAST
    }

    /// The character on the wire: 40h + id (sources A1).
    pub const fn character(self) -> u8 {
        Self::BASE + self.0
    }

    /// The address that a character stands for.
    pub fn from_character(byte: u8) -> Result<Self, TelegramError> {
        let id = byte.wrapping_sub(Self::BASE);
        let broadcast = (id == Self::BROADCAST.0).then_some(Self::BROADCAST);
        Self::drive(id).or(broadcast).ok_or(TelegramError::Address(byte))
    }
}

/// Prints the node id, or `*` for all.
impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_broadcast() { f.write_str("*") } else { write!(f, "{}", self.0) }
    }
}

/// Which drive behind the addressed one is meant: 0 itself, 1-63 a node of the system bus that it is the master of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SystemNode(u8);

impl SystemNode {
    /// The addressed drive itself.
    pub const SELF: SystemNode = SystemNode(0);
    /// Highest node of the system bus (EM-RES-03 manual 5.10.2.2).
    pub const LAST: u8 = 63;

    /// A node, 0-63; `None` beyond.
    pub fn new(id: u8) -> Option<Self> {
        (id <= Self::LAST).then_some(SystemNode(id))
    }

    /// 0 for the addressed drive, else the node id 1-63.
    pub const fn id(self) -> u8 {
        self.0
    }

    /// The character on the wire: `0`, or 40h + id (EM-RES-03 manual 5.10.2.2).
    pub const fn character(self) -> u8 {
        match self.0 {
            0 => b'0',
            id => 0x40 + id,
        }
    }

    /// The node that a character stands for.
    pub fn from_character(byte: u8) -> Result<Self, TelegramError> {
        match byte {
            b'0' => Ok(Self::SELF),
            0x41..=0x7F => Ok(SystemNode(byte - 0x40)),
            _ => Err(TelegramError::Node(byte)),
        }
    }
}

/// Data set: 0-4 EEPROM, 5-9 RAM (sources A2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct DataSet(u8);

impl DataSet {
    /// Highest data set.
    pub const LAST: u8 = 9;
    /// What the RAM copies add to the number of a data set.
    const RAM: u8 = 5;

    /// A data set, 0-9; `None` beyond.
    pub fn new(number: u8) -> Option<Self> {
        (number <= Self::LAST).then_some(DataSet(number))
    }

    /// The number, 0-9.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// What a drive puts into its reply: always `0` to `4` (sources A2).
    pub const fn as_replied(self) -> Self {
        DataSet(self.0 % Self::RAM)
    }

    fn from_character(byte: u8) -> Result<Self, TelegramError> {
        Self::new(byte.wrapping_sub(b'0')).ok_or(TelegramError::Set(byte))
    }
}

/// Parameter number, 0-1599.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ParamNumber(u16);

impl ParamNumber {
    /// Highest number that three characters can carry.
    pub const LAST: u16 = 1599;
    /// The error register that tells the cause of a NAK (sources A2).
    pub const ERROR_REGISTER: ParamNumber = ParamNumber(11);

    /// A number, 0-1599; `None` beyond.
    pub fn new(number: u16) -> Option<Self> {
        (number <= Self::LAST).then_some(ParamNumber(number))
    }

    /// The number.
    pub const fn get(self) -> u16 {
        self.0
    }

    /// The three characters on the wire: `000` to `999`; above, a letter stands for the hundreds: `A00` is 1000,
    /// `F99` is 1599 (sources A2).
    pub fn characters(self) -> [u8; 3] {
        let hundreds = (self.0 / 100) as u8;
        let first = if hundreds < 10 { b'0' + hundreds } else { b'A' + (hundreds - 10) };
        [first, b'0' + (self.0 / 10 % 10) as u8, b'0' + (self.0 % 10) as u8]
    }

    /// The number that three characters stand for.
    pub fn from_characters(text: [u8; 3]) -> Result<Self, TelegramError> {
        let [first, tens, units] = text;
        let hundreds = match first {
            b'0'..=b'9' => first - b'0',
            b'A'..=b'F' => first - b'A' + 10,
            _ => return Err(TelegramError::Number(text)),
        };
        if !tens.is_ascii_digit() || !units.is_ascii_digit() {
            return Err(TelegramError::Number(text));
        }
        let digit = |byte: u8| u16::from(byte - b'0');
        Ok(ParamNumber(u16::from(hundreds) * 100 + digit(tens) * 10 + digit(units)))
    }
}

/// What a telegram is about: SYS, data set and parameter number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Header {
    /// Which drive behind the addressed one.
    pub node: SystemNode,
    /// Data set.
    pub set: DataSet,
    /// Parameter number.
    pub number: ParamNumber,
}

impl Header {
    /// Characters on the wire.
    pub(super) const LEN: usize = 5;

    /// Whether a data reply with this header answers a question with that one: a drive names data sets 0-4 only, so
    /// the copies in EEPROM and RAM cannot be told apart in a reply (sources A2).
    pub fn answers(self, asked: Header) -> bool {
        let set = self.set == asked.set || self.set == asked.set.as_replied();
        set && (self.node, self.number) == (asked.node, asked.number)
    }

    pub(super) fn characters(self) -> [u8; Self::LEN] {
        let [first, second, third] = self.number.characters();
        [self.node.character(), b'0' + self.set.0, first, second, third]
    }

    pub(super) fn from_characters(text: [u8; Self::LEN]) -> Result<Self, TelegramError> {
        let [node, set, first, second, third] = text;
        Ok(Header {
            node: SystemNode::from_character(node)?,
            set: DataSet::from_character(set)?,
            number: ParamNumber::from_characters([first, second, third])?,
        })
    }
}

/// The value in a telegram: 1 to 99 characters, hexadecimal digits of a number or a string.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Data(Vec<u8>);

impl Data {
    /// Most characters that the two digits of the length can tell (sources A1).
    pub const MOST: usize = 99;

    /// Four digits, for 16 bits (sources A2).
    pub fn word(bits: u16) -> Self {
        Data(format!("{bits:04X}").into_bytes())
    }

    /// Eight digits, for 32 bits (sources A2).
    pub fn long(bits: u32) -> Self {
        Data(format!("{bits:08X}").into_bytes())
    }

    /// A string of 1 to 99 characters without control codes.
    pub fn text(characters: &[u8]) -> Result<Self, TelegramError> {
        let control = characters.iter().find(|byte| byte.is_ascii_control() && **byte != 0x7F);
        match (control, characters.len()) {
            (Some(&byte), _) => Err(TelegramError::Text(byte)),
            (None, 0) => Err(TelegramError::TooShort { len: 0 }),
            (None, ..=Self::MOST) => Ok(Data(characters.to_vec())),
            (None, len) => Err(TelegramError::TooLong { extra: len - Self::MOST }),
        }
    }

    /// The characters as they stand in the telegram.
    pub fn characters(&self) -> &[u8] {
        &self.0
    }

    /// The 16 bits, if these are four upper-case digits.
    pub fn as_word(&self) -> Option<u16> {
        self.digits(4).and_then(|bits| u16::try_from(bits).ok())
    }

    /// The 32 bits, if these are eight upper-case digits.
    pub fn as_long(&self) -> Option<u32> {
        self.digits(8)
    }

    fn digits(&self, count: usize) -> Option<u32> {
        let upper = |byte: &u8| matches!(byte, b'0'..=b'9' | b'A'..=b'F');
        let text = std::str::from_utf8(&self.0).ok()?;
        (self.0.len() == count && self.0.iter().all(upper)).then(|| u32::from_str_radix(text, 16).ok())?
    }

    pub(super) fn length(&self) -> [u8; 2] {
        let len = self.0.len() as u8;
        [b'0' + len / 10, b'0' + len % 10]
    }

    pub(super) fn length_from(text: [u8; 2]) -> Result<usize, TelegramError> {
        let [tens, units] = text;
        let digits = tens.is_ascii_digit() && units.is_ascii_digit() && text != *b"00";
        let value = || usize::from(tens - b'0') * 10 + usize::from(units - b'0');
        digits.then(value).ok_or(TelegramError::Length(text))
    }
}

impl fmt::Debug for Data {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\"", self.0.escape_ascii())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_of_the_manual() {
        for id in 1..=30 {
            let address = Address::drive(id).unwrap();
            assert_eq!(address.character(), 0x40 + id);
            assert_eq!(Address::from_character(0x40 + id), Ok(address));
        }
        assert_eq!(Address::BROADCAST.character(), 0x60);
        assert_eq!(Address::from_character(0x60), Ok(Address::BROADCAST));
        for byte in [0x00, 0x3F, 0x40, 0x5F, 0x61, 0x7F, 0xC1] {
            assert_eq!(Address::from_character(byte), Err(TelegramError::Address(byte)));
        }
        assert_eq!((Address::drive(0), Address::drive(31), Address::drive(32)), (None, None, None));
    }

    /// The characters of the table in EM-RES-03 manual 5.10.2.2, nodes 1 to 62; 63 is 7Fh.
    const TABLE: &[u8; 62] = br"ABCDEFGHIJKLMNOPQRSTUVWXYZ[\]^_`abcdefghijklmnopqrstuvwxyz{|}~";

    #[test]
    fn nodes_of_the_manual() {
        for (id, &byte) in (1..).zip(TABLE.iter().chain(&[0x7F])) {
            assert_eq!(SystemNode::new(id).map(SystemNode::character), Some(byte));
            assert_eq!(SystemNode::from_character(byte).map(SystemNode::id), Ok(id));
        }
        assert_eq!(SystemNode::SELF.character(), b'0');
        assert_eq!(SystemNode::from_character(b'0'), Ok(SystemNode::SELF));
        assert_eq!(SystemNode::new(64), None);
        for byte in [0x00, b'1', 0x40, 0x80, 0xB0] {
            assert_eq!(SystemNode::from_character(byte), Err(TelegramError::Node(byte)));
        }
    }

    #[test]
    fn every_number_there_and_back() {
        for number in (0..=1599).map(|number| ParamNumber::new(number).unwrap()) {
            assert_eq!(ParamNumber::from_characters(number.characters()), Ok(number));
        }
        assert_eq!(ParamNumber::new(1600), None);
        let shown = |number| ParamNumber::new(number).map(ParamNumber::characters);
        for (number, text) in [(0, b"000"), (999, b"999"), (1000, b"A00"), (1375, b"D75"), (1599, b"F99")] {
            assert_eq!(shown(number), Some(*text));
        }
        for text in [b"G00", b"a00", b"0A0", b"00 ", b"-10"] {
            assert_eq!(ParamNumber::from_characters(*text), Err(TelegramError::Number(*text)));
        }
    }

    #[test]
    fn numbers_have_four_or_eight_upper_case_digits() {
        assert_eq!(Data::word(0x67).characters(), b"0067");
        assert_eq!(Data::long(-12_000_i32 as u32).characters(), b"FFFFD120");
        assert_eq!(Data::word(0xABCD).as_word(), Some(0xABCD));
        assert_eq!(Data::long(10_025).as_long(), Some(10_025));
        for text in [&b"abcd"[..], b"+0AB", b"12345", b"00 1"] {
            let data = Data::text(text).unwrap();
            assert_eq!((data.as_word(), data.as_long()), (None, None), "{data:?}");
        }
    }

    #[test]
    fn strings_have_1_to_99_characters() {
        assert_eq!(Data::text(b""), Err(TelegramError::TooShort { len: 0 }));
        assert_eq!(Data::text(&[b'x'; 100]), Err(TelegramError::TooLong { extra: 1 }));
        assert_eq!(Data::text(b"a\x03"), Err(TelegramError::Text(3)));
        assert_eq!(Data::text(&[b'x'; 99]).map(|data| data.length()), Ok(*b"99"));
        for len in 1..=99 {
            assert_eq!(Data::length_from(Data(vec![b'x'; len]).length()), Ok(len));
        }
        assert_eq!(Data::length_from(*b"00"), Err(TelegramError::Length(*b"00")));
        assert_eq!(Data::length_from(*b"0A"), Err(TelegramError::Length(*b"0A")));
    }

    #[test]
    fn replies_name_the_data_set_without_its_memory() {
        let header = |set| Header { set: DataSet::new(set).unwrap(), ..Header::default() };
        assert!(header(2).answers(header(2)) && header(2).answers(header(7)));
        assert!(!header(7).answers(header(2)) && !header(3).answers(header(2)));
    }
}
