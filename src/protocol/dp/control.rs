//! The control byte FC: who asks or answers, and whether a question is new (IEC 61158-4-3; fieldbus facts).

/// What the control byte says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    /// A question of a master.
    Request {
        /// What is wanted.
        function: Function,
        /// Whether it is a new question or the last one again.
        count: Count,
    },
    /// An answer.
    Reply {
        /// What the station is.
        station: Station,
        /// What came of the question.
        status: Status,
    },
}

/// Frame count bits FCB and FCV. The same bit and the same bytes as before are a repeat, and get the same answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Count {
    /// FCB 0, FCV 0: nothing is counted.
    Unused,
    /// FCB 1, FCV 0: the counting begins.
    First,
    /// FCV 1, and FCB as it is.
    Bit(bool),
}

/// Rows: name in Rust, low nibble, abbreviation of the norm.
macro_rules! nibbles {
    ($(#[$about:meta])* $name:ident { $($row:ident $code:literal $short:literal $what:literal,)* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name {
            $(#[doc = $what] $row,)*
            /// One that is not told here.
            Other(u8),
        }

        impl $name {
            /// Every row that has a name.
            pub const ALL: &[$name] = &[$($name::$row),*];

            fn decode(code: u8) -> Self {
                match code { $($code => $name::$row,)* other => $name::Other(other) }
            }

            /// Its number.
            pub fn code(self) -> u8 {
                match self { $($name::$row => $code,)* $name::Other(code) => code }
            }

            /// The abbreviation of the norm; empty for a number that has none here.
            pub fn short(self) -> &'static str {
                match self { $($name::$row => $short,)* $name::Other(_) => "" }
            }
        }
    };
}

nibbles! {
    /// What a question wants.
    Function {
        SdaLow 0x3 "SDA low" "Send data, acknowledged, low priority.",
        SdnLow 0x4 "SDN low" "Send data, not acknowledged, low priority.",
        SdaHigh 0x5 "SDA high" "Send data, acknowledged, high priority.",
        SdnHigh 0x6 "SDN high" "Send data, not acknowledged, high priority.",
        FdlStatus 0x9 "FDL status" "Is anybody there, and what?",
        SrdLow 0xC "SRD low" "Send and request data, low priority.",
        SrdHigh 0xD "SRD high" "Send and request data, high priority.",
        Ident 0xE "ident" "Who is it?",
        LsapStatus 0xF "LSAP status" "What is at an access point?",
    }
}

nibbles! {
    /// What came of a question.
    Status {
        Ok 0x0 "OK" "Done.",
        UserError 0x1 "UE" "The user of the station refused it.",
        NoResource 0x2 "RR" "There is no room for it.",
        NoService 0x3 "RS" "The access point is not in use: to Data_Exchange, the slave has left it.",
        DataLow 0x8 "DL" "Data, low priority.",
        NoData 0x9 "NR" "There are no data.",
        DataHigh 0xA "DH" "Data, high priority: in Data_Exchange, a diagnosis is there.",
        DataLowNoResource 0xC "RDL" "Data, low priority; no room for what was sent.",
        DataHighNoResource 0xD "RDH" "Data, high priority; no room for what was sent.",
    }
}

/// What a station is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Station {
    /// A slave.
    Slave,
    /// A master that is not ready.
    NotReady,
    /// A master that waits to be let into the ring.
    Ready,
    /// A master in the ring.
    InRing,
}

const REQUEST: u8 = 0x40;
const FCB: u8 = 0x20;
const FCV: u8 = 0x10;
const NIBBLE: u8 = 0x0F;

impl Control {
    /// Reads the byte; `None` if bit 7 is set, which no telegram has.
    pub fn decode(byte: u8) -> Option<Self> {
        let (first, second) = (byte & FCB != 0, byte & FCV != 0);
        let nibble = byte & NIBBLE;
        Some(match byte & !NIBBLE & !FCB & !FCV {
            REQUEST => Control::Request {
                function: Function::decode(nibble),
                count: match (first, second) {
                    (false, false) => Count::Unused,
                    (true, false) => Count::First,
                    (bit, true) => Count::Bit(bit),
                },
            },
            0 => Control::Reply {
                station: match (first, second) {
                    (false, false) => Station::Slave,
                    (false, true) => Station::NotReady,
                    (true, false) => Station::Ready,
                    (true, true) => Station::InRing,
                },
                status: Status::decode(nibble),
            },
            _ => return None,
        })
    }

    /// The byte that says this.
    pub fn encode(self) -> u8 {
        let bits = |first: bool, second: bool| if first { FCB } else { 0 } | if second { FCV } else { 0 };
        match self {
            Control::Request { function, count } => {
                let count = match count {
                    Count::Unused => 0,
                    Count::First => FCB,
                    Count::Bit(bit) => bits(bit, true),
                };
                REQUEST | count | function.code() & NIBBLE
            }
            Control::Reply { station, status } => {
                let (first, second) = match station {
                    Station::Slave => (false, false),
                    Station::NotReady => (false, true),
                    Station::Ready => (true, false),
                    Station::InRing => (true, true),
                };
                bits(first, second) | status.code() & NIBBLE
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_without_bit_7_comes_back() {
        for byte in 0..=u8::MAX {
            match Control::decode(byte) {
                Some(control) => assert_eq!(control.encode(), byte),
                None => assert!(byte & 0x80 != 0),
            }
        }
        // The first question of the facts, and the one behind it.
        let request = |byte| match Control::decode(byte) {
            Some(Control::Request { function, count }) => (function, count),
            other => panic!("{other:?}"),
        };
        assert_eq!(request(0x6D), (Function::SrdHigh, Count::First));
        assert_eq!(request(0x5D), (Function::SrdHigh, Count::Bit(false)));
        assert_eq!(request(0x49), (Function::FdlStatus, Count::Unused));
    }
}
