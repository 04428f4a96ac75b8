//! From a parameter to the question that reads or writes it, and from the answer to its bits: over every protocol, in
//! the ways of every family.

use crate::exchange::dp::{Place, Request as Block};
use crate::exchange::{Question, Said};
use crate::profile::{Cause, Family, Link, Param, Role, Route as Way, Type, input_register};
use crate::protocol::Protocol;
use crate::protocol::can::sdo::{self, Initiate, Multiplexer};
use crate::protocol::dp::pkw::{Answer, Pkw};
use crate::protocol::modbus::BROADCAST;
use crate::protocol::modbus::pdu::{CLEAR_COUNTERS, Exception, ParamAddress, Reply, Request, WordOrder};
use crate::protocol::vabus::{self, Address, Data, DataSet, Header, ParamNumber, SystemNode};
use crate::tick::Tick;
use std::rc::Rc;

/// A parameter number and a data set as they go on the wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Parameter number or address.
    pub number: u32,
    /// Data set on the wire, 0-9; 0 where a family has none.
    pub set: u8,
}

/// Something that a verb asks a drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inquiry {
    /// Read a parameter.
    Read(Cell, Type),
    /// Read this many neighbours in one telegram.
    ReadMany(Cell, u16),
    /// Write these bits to a parameter.
    Write(Cell, Type, u32),
    /// Write these bits to a parameter and read them back in the same exchange.
    WriteAndRead(Cell, Type, u32),
    /// Read a diagnostic counter.
    Counter(u16),
    /// Set every diagnostic counter to zero.
    ClearCounters,
}

/// Why the drive said no, as far as its reply tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum No {
    /// A Modbus exception.
    Exception(Exception),
    /// A NAK of VABus, which tells nothing.
    Nak,
    /// An abort of SDO, with its code: of a drive that is the number of the cause (EM-RES-03 manual 5.10.1).
    Abort(u32),
    /// A refusal over PKW with what stands in PWE (SJ2-PB manual 4.1.1); without it there is no right to it.
    Pkw(Option<u32>),
}

impl No {
    /// Whether it says that there is no such parameter, or none that is asked for so.
    pub fn is_of_address(self) -> bool {
        self == No::Exception(Exception::IllegalDataAddress)
    }

    /// The cause, where the refusal itself tells it.
    pub(super) fn cause(self) -> Option<u16> {
        match self {
            No::Abort(code) => sdo::AbortCode(code).of_a_drive().map(u16::from),
            No::Exception(_) | No::Nak | No::Pkw(_) => None,
        }
    }

    /// Whether it says that there is no parameter of this number (SJ2-PB manual 4.1.1).
    pub(super) fn is_of_number(self) -> bool {
        self == No::Pkw(Some(0))
    }

    /// Whether the code alone says something of what was asked for (V1.1b3 7), and not of the moment, the way there, or that the
    /// cause stands elsewhere.
    pub(super) fn is_of_what_was_asked(self) -> bool {
        use Exception::{IllegalDataAddress, IllegalDataValue, IllegalFunction};
        matches!(self, No::Exception(IllegalFunction | IllegalDataAddress | IllegalDataValue))
    }

    /// Whether it may be otherwise a moment later: busy (V1.1b3 7).
    pub(super) fn passes(self) -> bool {
        matches!(self, No::Exception(Exception::Acknowledge | Exception::DeviceBusy))
    }
}

/// What an answer carries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Content {
    /// Bits, and how wide they came.
    Bits(u32, Width),
    /// A string.
    Text(String),
    /// Only that it is done.
    Done,
}

/// How wide a value came.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Width {
    Word,
    Long,
    /// As the question said.
    AsAsked,
    /// Nobody says: always four bytes came (EM-RES-03 manual 5.10.1).
    Untold,
    /// As the catalogue says: what came names its parameter, and a slave may say the sign of a word once more in the upper half.
    AsKnown,
}

/// The way to the parameters of one drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Route {
    /// What is spoken on the line.
    pub protocol: Protocol,
    /// Codes and addressing of the family.
    pub way: Way,
    /// Address of the drive; 0 is everybody.
    pub address: u8,
    /// System-bus node behind it; 0 is the drive itself.
    pub node: u8,
    /// Which half of a value in two registers comes first.
    pub order: WordOrder,
}

/// Whom a telegram is for, as far as it is known before anything is asked.
#[derive(Clone, Debug)]
pub struct Meant {
    /// Where it is.
    pub address: u8,
    /// Its family, if somebody named it.
    pub family: Option<Rc<Family>>,
    /// Which half of a value comes first, if somebody named it.
    pub order: Option<WordOrder>,
}

impl Meant {
    /// The telegrams that say something to a family: `both` times if it matters which half of a value comes first, and
    /// nobody named that.
    pub(super) fn questions(
        &self,
        protocol: Protocol,
        node: u8,
        family: &Family,
        inquiry: Inquiry,
        both: bool,
    ) -> Vec<Question> {
        let orders = match self.order {
            Some(order) => vec![order],
            None if both => vec![WordOrder::HighFirst, WordOrder::LowFirst],
            None => vec![WordOrder::default()],
        };
        let route = Route { node, ..Route::new(protocol, &family.link, self.address) };
        orders.into_iter().filter_map(|order| Route { order, ..route }.question(inquiry)).collect()
    }
}

impl Route {
    /// The way to a drive of a family.
    pub fn new(protocol: Protocol, link: &Link, address: u8) -> Self {
        let order = if link.low_half_first { WordOrder::LowFirst } else { WordOrder::default() };
        Route { protocol, way: link.route, address, node: 0, order }
    }

    /// The question, if the protocol and the family have it and the number fits.
    pub fn question(self, inquiry: Inquiry) -> Option<Question> {
        match (self.protocol, self.way) {
            (Protocol::Pkw, Way::Pkw) => block(inquiry).map(Question::from),
            (Protocol::Vabus, Way::Active) => self.vabus(inquiry).map(Question::from),
            (Protocol::Sdo(_), Way::Active) => object(inquiry).map(Question::from),
            // Nobody but the ACTIVE drives is known to speak these.
            (Protocol::Vabus | Protocol::Sdo(_), Way::Registers32 | Way::Registers)
            | (_, Way::Pkw)
            | (Protocol::Pkw, _) => None,
            (Protocol::Modbus(_), Way::Active) => active(inquiry).map(Question::from),
            (Protocol::Modbus(_), Way::Registers32) => self.registers32(inquiry).map(Question::from),
            (Protocol::Modbus(_), Way::Registers) => self.registers(inquiry).map(Question::from),
        }
    }

    /// The question without whose answer no write is taken behind a refusal, where there is one.
    pub(super) fn unlocks(self, family: &Family) -> Option<Question> {
        (self.protocol == Protocol::Vabus).then(|| self.cause(family, No::Nak)).flatten()
    }

    /// The question that tells why the drive said no, if this no has a cause that can be asked for.
    pub(super) fn cause(self, family: &Family, no: No) -> Option<Question> {
        let told = match (self.way, no) {
            (Way::Active, No::Exception(code)) => {
                matches!(code, Exception::DeviceFailure | Exception::IllegalDataAddress)
            }
            (_, No::Abort(_) | No::Pkw(_)) => false,
            _ => true,
        };
        if !told {
            return None;
        }
        match family.link.cause {
            // The register is the one of the drive that stands on the line, whatever is behind it (sources A2).
            Cause::ErrorRegister => Route { node: 0, ..self }.question(register(family)?),
            Cause::Diagnostics(sub) => self.question(Inquiry::Counter(sub)),
        }
    }

    /// What an answer carries; `None` if it does not fit.
    pub(super) fn content(self, said: &Said) -> Option<Content> {
        Some(match said {
            Said::Modbus(Reply::Registers(words) | Reply::Inputs(words) | Reply::RegistersExchanged(words)) => {
                self.words(words)?
            }
            Said::Modbus(Reply::Long(bits)) => Content::Bits(*bits, Width::Long),
            Said::Modbus(Reply::Diagnostics { data, .. }) => Content::Bits((*data).into(), Width::Word),
            Said::Modbus(_) => Content::Done,
            Said::Vabus(vabus::Reply::Value { data, .. }) => match (data.as_word(), data.as_long()) {
                (Some(word), _) => Content::Bits(word.into(), Width::Word),
                (_, Some(long)) => Content::Bits(long, Width::Long),
                _ => Content::Text(String::from_utf8_lossy(data.characters()).into_owned()),
            },
            Said::Sdo(sdo::Reply::Upload(_, Initiate::Expedited { bytes, size })) => {
                let bits = u32::from_le_bytes(*bytes);
                match size {
                    Some(2) => Content::Bits(bits & 0xFFFF, Width::Word),
                    Some(4) => Content::Bits(bits, Width::Long),
                    _ => Content::Bits(bits, Width::Untold),
                }
            }
            Said::Pkw(block) if !said.is_refusal() => Content::Bits(block.pwe, Width::AsKnown),
            Said::Vabus(_) | Said::Sdo(_) | Said::Pkw(_) => Content::Done,
        })
    }

    /// The bytes of a reply whose value has not the form that its type has over VABus: four or eight upper-case digits
    /// (sources A2); a check character of eight bits lets such through. Or over SDO announces pieces, which no drive does (EM-RES-03 manual
    /// 5.10.1): what stands in it is a length.
    pub(super) fn misshapen(self, said: &Said, kind: Type) -> Option<Vec<u8>> {
        if let Said::Sdo(reply @ sdo::Reply::Upload(_, Initiate::Segmented { .. })) = said {
            return Some(reply.encode().to_vec());
        }
        let Said::Vabus(reply @ vabus::Reply::Value { data, .. }) = said else { return None };
        let fits = match kind.bits() {
            Some(32) => data.as_long().is_some(),
            Some(_) => data.as_word().is_some(),
            None => true,
        };
        (!fits).then(|| reply.encode())
    }

    /// Whether an answer carries these bits, read back in the exchange that wrote them.
    pub(super) fn tells(self, said: &Said, bits: u32) -> bool {
        matches!(said, Said::Modbus(Reply::RegistersExchanged(_)))
            && matches!(self.content(said), Some(Content::Bits(read, _)) if read == bits)
    }

    /// The 16 bits that an answer carries, if it carries a number.
    pub(super) fn number(self, said: &Said) -> Option<u16> {
        match self.content(said)? {
            Content::Bits(bits, _) => u16::try_from(bits).ok(),
            Content::Text(_) | Content::Done => None,
        }
    }

    fn words(self, words: &[u16]) -> Option<Content> {
        Some(match (self.way, words) {
            (Way::Registers32, &[first, second, ..]) => Content::Bits(self.order.join([first, second]), Width::AsAsked),
            (Way::Registers, &[first, second]) => Content::Bits(self.order.join([first, second]), Width::Long),
            (_, &[word, ..]) => Content::Bits(word.into(), Width::Word),
            _ => return None,
        })
    }

    /// The values of neighbours that came in one telegram.
    pub(super) fn values(self, said: &Said) -> Vec<u32> {
        match said {
            Said::Modbus(Reply::Registers(words)) if self.way == Way::Registers32 => {
                words.as_chunks().0.iter().map(|pair| self.order.join(*pair)).collect()
            }
            _ => Vec::new(),
        }
    }

    /// LXM05: every parameter in two registers (LXM05 manual 5.2, 5.3).
    fn registers32(self, inquiry: Inquiry) -> Option<Request> {
        let start = |cell: Cell| u16::try_from(cell.number).ok();
        Some(match inquiry {
            Inquiry::Read(cell, _) => Request::ReadRegisters { start: start(cell)?, count: 2 },
            Inquiry::ReadMany(cell, count) => Request::ReadRegisters { start: start(cell)?, count: count * 2 },
            Inquiry::Write(cell, _, bits) => {
                Request::WriteRegisters { start: start(cell)?, values: self.order.split(bits).to_vec() }
            }
            Inquiry::WriteAndRead(cell, _, bits) => Request::ExchangeRegisters {
                start: start(cell)?,
                count: 2,
                write_start: start(cell)?,
                values: self.order.split(bits).to_vec(),
            },
            Inquiry::Counter(sub) => Request::Diagnostics { sub, data: 0 },
            Inquiry::ClearCounters => Request::Diagnostics { sub: CLEAR_COUNTERS, data: 0 },
        })
    }

    /// What the norm says, and nothing more: 16 bits in one register, 32 in two (V1.1b3 6.3, 6.4, 6.6, 6.8, 6.12).
    fn registers(self, inquiry: Inquiry) -> Option<Request> {
        let start = |cell: Cell| u16::try_from(cell.number).ok();
        let count = |kind: Type| if kind.bits() == Some(32) { 2 } else { 1 };
        Some(match inquiry {
            Inquiry::Read(cell, kind) => match input_register(cell.number) {
                Some(start) => Request::ReadInputs { start, count: count(kind) },
                None => Request::ReadRegisters { start: start(cell)?, count: count(kind) },
            },
            Inquiry::Write(cell, kind, bits) if kind.bits() == Some(32) => {
                Request::WriteRegisters { start: start(cell)?, values: self.order.split(bits).to_vec() }
            }
            Inquiry::Write(cell, _, bits) => Request::WriteRegister { address: start(cell)?, value: bits as u16 },
            Inquiry::Counter(sub) => Request::Diagnostics { sub, data: 0 },
            Inquiry::ClearCounters => Request::Diagnostics { sub: CLEAR_COUNTERS, data: 0 },
            Inquiry::ReadMany(..) | Inquiry::WriteAndRead(..) => return None,
        })
    }

    fn vabus(self, inquiry: Inquiry) -> Option<vabus::Request> {
        let address = match self.address {
            BROADCAST => Address::BROADCAST,
            id => Address::drive(id)?,
        };
        let header = |cell: Cell| {
            let number = ParamNumber::new(u16::try_from(cell.number).ok()?)?;
            Some(Header { node: SystemNode::new(self.node)?, set: DataSet::new(cell.set)?, number })
        };
        match inquiry {
            Inquiry::Read(cell, _) => Some(vabus::Request::Enquiry { address, header: header(cell)? }),
            Inquiry::Write(cell, kind, bits) => {
                let data = if kind.bits() == Some(32) { Data::long(bits) } else { Data::word(bits as u16) };
                Some(vabus::Request::Select { address, header: header(cell)?, data })
            }
            _ => None,
        }
    }
}

/// Codes 3 and 6 for 16 bits, 100 and 101 for 32 (CM-485 manual 6.4).
fn active(inquiry: Inquiry) -> Option<Request> {
    let word = |cell: Cell| Some(ParamAddress::new(cell.set, u16::try_from(cell.number).ok()?)?.word());
    Some(match inquiry {
        Inquiry::Read(cell, kind) if kind.bits() == Some(32) => Request::ReadLong { address: word(cell)? },
        Inquiry::Read(cell, _) => Request::ReadRegisters { start: word(cell)?, count: 1 },
        Inquiry::Write(cell, kind, bits) if kind.bits() == Some(32) => {
            Request::WriteLong { address: word(cell)?, value: bits }
        }
        Inquiry::Write(cell, _, bits) => Request::WriteRegister { address: word(cell)?, value: bits as u16 },
        Inquiry::Counter(sub) => Request::Diagnostics { sub, data: 0 },
        Inquiry::ClearCounters => Request::Diagnostics { sub: CLEAR_COUNTERS, data: 0 },
        Inquiry::ReadMany(..) | Inquiry::WriteAndRead(..) => return None,
    })
}

/// Index = parameter, sub-index = data set; a word is written as one, because strict servers want that (EM-RES-03 manual 5.10.1).
fn object(inquiry: Inquiry) -> Option<sdo::Request> {
    let of = |cell: Cell| Some(Multiplexer { index: u16::try_from(cell.number).ok()?, sub: cell.set });
    match inquiry {
        Inquiry::Read(cell, _) => Some(sdo::Request::Upload(of(cell)?)),
        Inquiry::Write(cell, kind, bits) => {
            let is_long = kind.bits() == Some(32);
            let initiate = if is_long { Initiate::long(bits) } else { Initiate::word(bits as u16) };
            Some(sdo::Request::Download(of(cell)?, initiate))
        }
        _ => None,
    }
}

/// By index, and the element of an array by its own number (SJ2-PB manual 4.1.1, 4.1.2.5); no value of four bytes can be written (5.5).
fn block(inquiry: Inquiry) -> Option<Pkw> {
    let of = |cell: Cell| {
        let param = Param::unknown(cell.number);
        let place = Place::of(param.number(), param.element());
        // A parameter of the second set has an index of its own.
        (place.pnu <= LAST_PNU && cell.set == 0).then_some(place)
    };
    let request = match inquiry {
        Inquiry::Read(cell, _) => Block::read(of(cell)?, Tick::ZERO),
        Inquiry::Write(cell, kind, bits) if kind.bytes().is_none_or(|bytes| bytes <= 2) => {
            Block::write(of(cell)?, bits as u16, Tick::ZERO)
        }
        _ => return None,
    };
    Some(request.asked())
}

/// Bits 10 to 0 of PKE.
const LAST_PNU: u16 = 0x07FF;

/// The question for the error register of a family that has one.
pub(super) fn register(family: &Family) -> Option<Inquiry> {
    let register = family.role(Role::ErrorRegister)?;
    Some(Inquiry::Read(Cell { number: register.id, set: 0 }, Type::Uint))
}

/// Whether the answer is a no.
pub(super) fn no(said: &Said) -> Option<No> {
    match said {
        Said::Modbus(Reply::Exception { code, .. }) => Some(No::Exception(*code)),
        Said::Vabus(vabus::Reply::Nak { .. }) => Some(No::Nak),
        Said::Sdo(sdo::Reply::Abort(_, code)) => Some(No::Abort(code.0)),
        Said::Pkw(block) if said.is_refusal() => {
            Some(No::Pkw(Some(block.pwe).filter(|_| Answer::of(block.ak) == Answer::Refused)))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;

    #[test]
    fn a_value_over_vabus_has_the_form_of_its_type() {
        let family = Registry::open(&[]).unwrap().family("act").unwrap();
        let route = Route::new(Protocol::Vabus, &family.link, 1);
        let header = Header { node: SystemNode::SELF, set: DataSet::default(), number: ParamNumber::new(419).unwrap() };
        let address = Address::drive(1).unwrap();
        for (digits, word, long) in [
            ("056E", true, false),
            ("0000056E", false, true),
            ("056e", false, false),
            ("G56E", false, false),
            ("00056E", false, false),
            ("0000056e", false, false),
        ] {
            let data = Data::text(digits.as_bytes()).unwrap();
            let said = Said::Vabus(vabus::Reply::Value { address, header, data });
            assert_eq!(route.misshapen(&said, Type::Uint).is_none(), word, "{digits}");
            assert_eq!(route.misshapen(&said, Type::Long).is_none(), long, "{digits}");
            assert!(route.misshapen(&said, Type::String).is_none(), "{digits}");
        }
    }

    /// A length is no value.
    #[test]
    fn pieces_that_are_announced_over_sdo_are_no_value() {
        let family = Registry::open(&[]).unwrap().family("acu").unwrap();
        let route = Route::new(Protocol::Sdo(crate::protocol::can::SdoChannel::Two), &family.link, 1);
        for (command, is_value) in
            [(0x40, false), (0x41, false), (0x50, false), (0x42, true), (0x43, true), (0x4B, true)]
        {
            let said = Said::Sdo(sdo::Reply::decode([command, 0xE0, 0x01, 0x02, 0xF4, 0x01, 0, 0]));
            assert_eq!(route.misshapen(&said, Type::Long).is_none(), is_value, "{command:02X}");
        }
    }
}
