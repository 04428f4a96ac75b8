//! The stations of a hostile line: what they are asked, what they understand, and the truth that they tell.

use super::line::HostileLine;
use antrieb::exchange::{Question, Said};
use antrieb::protocol::Protocol;
use antrieb::protocol::can::sdo;
use antrieb::protocol::modbus::Framing;
use antrieb::protocol::modbus::mbap;
use antrieb::protocol::modbus::pdu::{Exception, ParamAddress, Reply, Request};
use antrieb::protocol::vabus::{self, Address, Data, DataSet, Header, ParamNumber};

/// Stations that are asked. What is foreign names the one behind.
pub(crate) const STATIONS: [u8; 2] = [1, 3];
/// Only somebody else asks this one.
pub(super) const STRANGER: u8 = 9;
/// Number, data set, width.
pub(super) const CELLS: [(u16, u8, bool); 8] = [
    (372, 1, false),
    (372, 2, false),
    (372, 3, false),
    (376, 1, false),
    (376, 4, false),
    (481, 1, true),
    (481, 2, true),
    (480, 3, true),
];

/// A question with the only right answer, and that of the other drive at the address.
#[derive(Debug)]
pub(crate) struct Asked {
    pub(crate) station: u8,
    pub(crate) question: Question,
    pub(crate) right: Said,
    pub(crate) twin: Said,
}

impl HostileLine {
    /// The next question, by chance.
    pub(crate) fn question(&mut self) -> Asked {
        let (station, (number, set, long)) = (self.dice.pick(&STATIONS), self.dice.pick(&CELLS));
        let question: Question = match self.protocol {
            Protocol::Vabus => {
                let number = ParamNumber::new(number).unwrap();
                let header = Header { number, set: DataSet::new(set).unwrap(), ..Header::default() };
                vabus::Request::Enquiry { address: Address::drive(station).unwrap(), header }.into()
            }
            Protocol::Sdo(_) => sdo::Request::Upload(sdo::Multiplexer { index: number, sub: set }).into(),
            Protocol::Pkw => unreachable!("a block of a slave goes over no line of characters"),
            Protocol::Modbus(_) => {
                let address = ParamAddress::new(set, number).unwrap().word();
                match long {
                    true => Request::ReadLong { address },
                    false => Request::ReadRegisters { start: address, count: 1 },
                }
                .into()
            }
        };
        let (right, twin) = (self.says(station, &question, false), self.says(station, &question, true));
        Asked { station, question, right: right.unwrap(), twin: twin.unwrap() }
    }

    /// What the program asks every station first: who it is.
    pub(crate) fn introduction(&self, station: u8) -> Option<Asked> {
        let question = Question::from(Request::ReadIdentification { category: 1, object: 0 });
        let right = self.says(station, &question, false)?;
        let is_modbus = matches!(self.protocol, Protocol::Modbus(_));
        is_modbus.then_some(Asked { station, question, twin: right.clone(), right })
    }

    pub(super) fn understand(&self, bytes: &[u8]) -> Option<(u8, Question, u16)> {
        match self.protocol {
            Protocol::Vabus => {
                let request = vabus::Request::decode(bytes).ok()?;
                Some((request.address().id(), request.into(), 0))
            }
            // Frames are cut out of what an adapter says before a conversation hears of them.
            Protocol::Sdo(_) | Protocol::Pkw => None,
            Protocol::Modbus(Framing::Tcp) => {
                let (number, adu) = mbap::decode(bytes).ok()?;
                Some((adu.station, Request::decode(&adu.pdu).ok()?.into(), number))
            }
            Protocol::Modbus(framing) => {
                let adu = framing.decode(bytes).ok()?;
                Some((adu.station, Request::decode(&adu.pdu).ok()?.into(), 0))
            }
        }
    }

    /// The truth: no two cells of all stations and twins hold the same.
    pub(super) fn says(&self, station: u8, question: &Question, twin: bool) -> Option<Said> {
        if !STATIONS.contains(&station) && station != STRANGER {
            return None;
        }
        let value = |cell: u32| cell.wrapping_mul(64) + u32::from(station) * 2 + u32::from(twin);
        let place = |word: u16| value(u32::from(word) % 509);
        Some(match question {
            Question::Modbus(Request::ReadRegisters { start, .. }) => {
                Said::Modbus(Reply::Registers(vec![place(*start) as u16]))
            }
            // An ACTIVE drive does not know code 43 (CM-485 manual 6.4).
            Question::Modbus(Request::ReadIdentification { .. }) => {
                Said::Modbus(Reply::Exception { function: 0x2B, code: Exception::IllegalFunction })
            }
            Question::Modbus(Request::ReadLong { address }) => Said::Modbus(Reply::Long(0x5A_0000 + place(*address))),
            Question::Modbus(Request::Diagnostics { sub: sub @ (0x0B | 0x0E), .. }) => {
                Said::Modbus(Reply::Diagnostics {
                    sub: *sub,
                    data: self.count.wrapping_add(self.ahead * u16::from(twin)),
                })
            }
            Question::Modbus(Request::Diagnostics { sub, .. }) => {
                Said::Modbus(Reply::Diagnostics { sub: *sub, data: 0 })
            }
            Question::Vabus(vabus::Request::Enquiry { address, header }) => {
                let cell = u32::from(header.number.get()) * 5 + u32::from(header.set.number());
                let data = Data::word(value(cell % 1_021) as u16);
                Said::Vabus(vabus::Reply::Value { address: *address, header: *header, data })
            }
            _ => return None,
        })
    }

    pub(super) fn frame(&self, station: u8, said: &Said, number: u16) -> Vec<u8> {
        match (said, self.protocol) {
            (Said::Modbus(reply), Protocol::Modbus(Framing::Tcp)) => mbap::encode(number, station, &reply.encode()),
            (said, _) => self.telegram(station, said),
        }
    }

    /// The bytes of a reply; on Modbus/TCP without a number.
    pub(crate) fn telegram(&self, station: u8, said: &Said) -> Vec<u8> {
        match (said, self.protocol) {
            (Said::Modbus(reply), Protocol::Modbus(framing)) => framing.encode(station, &reply.encode()),
            (Said::Vabus(reply), _) => reply.encode(),
            _ => Vec::new(),
        }
    }

    /// The same from the station behind.
    pub(super) fn of_another(&self, frame: &[u8]) -> Option<Vec<u8>> {
        match self.protocol {
            Protocol::Vabus => {
                let vabus::Reply::Value { header, data, address } = vabus::Reply::decode(frame).ok()? else {
                    return None;
                };
                let address = Address::drive(address.id() + 1)?;
                Some(vabus::Reply::Value { address, header, data }.encode())
            }
            Protocol::Sdo(_) | Protocol::Pkw => None,
            Protocol::Modbus(Framing::Tcp) => {
                let (number, adu) = mbap::decode(frame).ok()?;
                Some(mbap::encode(number.wrapping_sub(1), adu.station, &adu.pdu))
            }
            Protocol::Modbus(framing) => {
                let adu = framing.decode(frame).ok()?;
                Some(framing.encode(adu.station + 1, &adu.pdu))
            }
        }
    }
}
