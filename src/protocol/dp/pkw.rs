//! The PKW block: parameters over cyclic data (PROFIdrive V2; SJ2-PB manual 4.1, 4.1.1; facts F).

/// Four words: PKE, IND and a value of 32 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pkw {
    /// What is asked or answered: bits 15 to 12 of PKE.
    pub ak: u8,
    /// Bit 11 of PKE: a change is announced.
    pub spm: bool,
    /// Parameter: bits 10 to 0 of PKE.
    pub pnu: u16,
    /// Sub-index in the high byte (manual 4.1.2.5); no source tells what the low byte says.
    pub ind: u16,
    /// Value, or the number of a refusal.
    pub pwe: u32,
}

/// Length of the block.
pub const LENGTH: usize = 8;
/// Bit 11 of PKE.
const SPM: u16 = 0x0800;
/// Bits 10 to 0 of PKE.
const PNU: u16 = 0x07FF;

impl Pkw {
    /// Reads the block.
    pub fn decode(bytes: &[u8; LENGTH]) -> Self {
        let &[a, b, c, d, e, f, g, h] = bytes;
        let pke = u16::from_be_bytes([a, b]);
        Pkw {
            ak: (pke >> 12) as u8,
            spm: pke & SPM != 0,
            pnu: pke & PNU,
            ind: u16::from_be_bytes([c, d]),
            pwe: u32::from_be_bytes([e, f, g, h]),
        }
    }

    /// The bytes that say this.
    pub fn encode(self) -> [u8; LENGTH] {
        let spm = if self.spm { SPM } else { 0 };
        let pke = u16::from(self.ak & 0x0F) << 12 | spm | self.pnu & PNU;
        let ([a, b], [c, d], [e, f, g, h]) = (pke.to_be_bytes(), self.ind.to_be_bytes(), self.pwe.to_be_bytes());
        [a, b, c, d, e, f, g, h]
    }

    /// Element of an array, from 1; 0 where none is meant.
    pub fn sub_index(self) -> u8 {
        self.ind.to_be_bytes()[0]
    }
}

/// Rows: name in Rust, number.
macro_rules! keys {
    ($(#[$about:meta])* $name:ident { $($row:ident $code:literal $what:literal,)* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name {
            $(#[doc = $what] $row,)*
            /// One that is not told here.
            Other(u8),
        }

        impl $name {
            /// What a number says.
            pub fn of(ak: u8) -> Self {
                match ak { $($code => $name::$row,)* other => $name::Other(other) }
            }
        }
    };
}

keys! {
    /// What a master asks (manual 4.1.1, "Master -> Slave"; facts F).
    Task {
        None 0 "Nothing.",
        Read 1 "The value.",
        WriteWord 2 "A new value of 16 bits.",
        WriteDouble 3 "A new value of 32 bits.",
        ReadDescription 4 "An element of the description.",
        WriteDescription 5 "A new element of the description.",
        ReadElement 6 "The value of an element of an array.",
        WriteElementWord 7 "A new value of 16 bits for an element.",
        WriteElementDouble 8 "A new value of 32 bits for an element.",
        CountElements 9 "How many elements the array has.",
    }
}

keys! {
    /// What a slave answers (manual 4.1.1, "Slave -> Master"; facts F).
    Answer {
        None 0 "Nothing was asked.",
        Word 1 "The value, 16 bits.",
        Double 2 "The value, 32 bits.",
        Description 3 "An element of the description.",
        ElementWord 4 "The value of an element, 16 bits.",
        ElementDouble 5 "The value of an element, 32 bits.",
        Count 6 "The number of elements.",
        Refused 7 "No, and why stands in PWE.",
        NoRight 8 "No right to change anything from here.",
    }
}

impl Task {
    /// Whether a value goes to the slave.
    pub fn writes(self) -> bool {
        matches!(
            self,
            Task::WriteWord
                | Task::WriteDouble
                | Task::WriteDescription
                | Task::WriteElementWord
                | Task::WriteElementDouble
        )
    }

    /// Whether the element in IND counts.
    pub fn has_element(self) -> bool {
        matches!(self, Task::ReadElement | Task::WriteElementWord | Task::WriteElementDouble)
    }

    /// Whether the value has 32 bits.
    pub fn is_double(self) -> bool {
        matches!(self, Task::WriteDouble | Task::WriteElementDouble)
    }

    /// Whether the manual names it and adds that the SJ2-PB does not support it (4.1.1, note).
    pub fn is_unsupported(self) -> bool {
        matches!(self, Task::ReadDescription | Task::WriteDescription | Task::WriteElementDouble)
    }
}

impl Answer {
    /// Whether the element in IND counts.
    pub fn has_element(self) -> bool {
        matches!(self, Answer::ElementWord | Answer::ElementDouble)
    }

    /// Whether the value has 32 bits.
    pub fn is_double(self) -> bool {
        matches!(self, Answer::Double | Answer::ElementDouble)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn words(words: [u16; 4]) -> [u8; 8] {
        words.map(u16::to_be_bytes).concat().try_into().unwrap()
    }

    /// Which keys carry two words, an element, a value to the slave; and which the manual names and the module does not know (4.1.1).
    #[test]
    fn keys_say_what_they_carry() {
        let tasks = |is: fn(Task) -> bool| (0..16).filter(|ak| is(Task::of(*ak))).collect::<Vec<_>>();
        assert_eq!(tasks(Task::writes), [2, 3, 5, 7, 8]);
        assert_eq!(tasks(Task::has_element), [6, 7, 8]);
        assert_eq!(tasks(Task::is_double), [3, 8]);
        assert_eq!(tasks(Task::is_unsupported), [4, 5, 8]);
        let answers = |is: fn(Answer) -> bool| (0..16).filter(|ak| is(Answer::of(*ak))).collect::<Vec<_>>();
        assert_eq!(answers(Answer::has_element), [4, 5]);
        assert_eq!(answers(Answer::is_double), [2, 5]);
    }

    /// Manual 4.1: what is received for the motor current, and A038 put into PZD3.
    #[test]
    fn the_blocks_of_the_manual() {
        let current = Pkw { ak: 1, spm: false, pnu: 0xF0, ind: 0, pwe: 0xA0 };
        assert_eq!(current.encode(), words([0x10F0, 0, 0, 0xA0]));
        let sent = Pkw { ak: 7, spm: false, pnu: 915, ind: 0x0100, pwe: 34 };
        assert_eq!(sent.encode(), words([0x7393, 0x0100, 0, 0x22]));
        assert_eq!((Task::of(sent.ak), sent.sub_index()), (Task::WriteElementWord, 1));
        let received = Pkw::decode(&words([0x4393, 0x0100, 0, 0x22]));
        assert_eq!((Answer::of(received.ak), received.pnu, received.pwe), (Answer::ElementWord, 915, 34));
    }

    proptest! {
        #[test]
        fn every_block_comes_back_as_it_was(bytes in any::<[u8; 8]>()) {
            prop_assert_eq!(Pkw::decode(&bytes).encode(), bytes);
        }
    }
}
