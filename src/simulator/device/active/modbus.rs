//! The Modbus slave of an ACT or ACU: function codes, exceptions, diagnostic counters (CM-485 manual 6.4 to 6.6).
//!
//! Where the manual contradicts itself, the worked telegrams of its chapter 8 decide (sources C): a register count
//! other than 1 is exception 2, everything that concerns the parameter itself is exception 4 with its cause in P.11.

use super::access::Width;
use super::cause::Cause;
use super::readings::Reading;
use super::state::Active;
use crate::protocol::modbus::pdu::{CLEAR_COUNTERS, COUNTERS, Exception, ParamAddress, PduError, Reply, Request};
use crate::simulator::device::contract::Effect;
use crate::simulator::device::counters::Counters;
use crate::tick::Tick;

/// Executes a request and makes the reply. An exception is counted.
pub(crate) fn answer(drive: &mut Active, counters: &mut Counters, now: Tick, pdu: &[u8]) -> (Reply, Effect) {
    let function = pdu.first().copied().unwrap_or(0);
    match execute(drive, counters, now, pdu) {
        Ok(done) => done,
        Err(code) => {
            counters.count(Counters::EXCEPTIONS);
            (Reply::Exception { function, code }, Effect::None)
        }
    }
}

fn execute(drive: &mut Active, counters: &mut Counters, now: Tick, pdu: &[u8]) -> Result<(Reply, Effect), Exception> {
    // A known function code with a wrong length is exception 3, an unknown one exception 1 (6.6).
    let request = Request::decode(pdu).map_err(|error| match error {
        PduError::Length { .. } | PduError::ByteCount { .. } | PduError::TooLong { .. } => Exception::IllegalDataValue,
        PduError::Empty => Exception::IllegalFunction,
    })?;
    // 6.4 lists exception 2 for addresses, the worked telegram of 8.1.3 shows 4.
    let address = drive.has(Reading::UnknownIsException2);
    let failed = move |cause| match cause {
        Cause::Unknown if address => Exception::IllegalDataAddress,
        _ => Exception::DeviceFailure,
    };
    let reply = match request {
        Request::ReadRegisters { count, .. } if count != 1 => return Err(Exception::IllegalDataAddress),
        Request::ReadRegisters { start, .. } => {
            let bits = drive.read(now, ParamAddress::from_word(start), Width::Word).map_err(failed)?;
            Reply::Registers(vec![bits as u16])
        }
        Request::ReadLong { address } => {
            Reply::Long(drive.read(now, ParamAddress::from_word(address), Width::Long).map_err(failed)?)
        }
        Request::WriteRegister { address, value } => {
            let effect =
                drive.write(now, ParamAddress::from_word(address), Width::Word, value.into()).map_err(failed)?;
            return Ok((Reply::RegisterWritten { address, value }, effect));
        }
        Request::WriteLong { address, value } => {
            let effect = drive.write(now, ParamAddress::from_word(address), Width::Long, value).map_err(failed)?;
            return Ok((Reply::LongWritten { address, value }, effect));
        }
        Request::Diagnostics { sub, data } => diagnostics(counters, sub, data)?,
        _ => return Err(Exception::IllegalFunction),
    };
    Ok((reply, Effect::None))
}

fn diagnostics(counters: &mut Counters, sub: u16, data: u16) -> Result<Reply, Exception> {
    let known = sub == CLEAR_COUNTERS || COUNTERS.contains(&sub);
    match (known, data) {
        (false, _) => Err(Exception::IllegalFunction),
        (true, 1..) => Err(Exception::IllegalDataValue),
        (true, 0) if sub == CLEAR_COUNTERS => {
            *counters = Counters::default();
            Ok(Reply::Diagnostics { sub, data })
        }
        (true, 0) => Ok(Reply::Diagnostics { sub, data: counters.get(sub) }),
    }
}

/// The parameter that a telegram writes.
pub(crate) fn written(pdu: &[u8]) -> Option<u16> {
    match Request::decode(pdu) {
        Ok(Request::WriteRegister { address, .. } | Request::WriteLong { address, .. }) => {
            Some(ParamAddress::from_word(address).number())
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;
    use crate::protocol::line::{LineSetting, Parity};
    use crate::simulator::device::active::setup::Setup;
    use crate::simulator::device::contract::NodeSetting;
    use crate::simulator::line::speech::Spoken;

    fn drive(model: &str) -> Active {
        let registry = Registry::open(&[]).unwrap();
        let family = registry.family(model).unwrap();
        let place = NodeSetting { address: 1, spoken: Spoken::RTU, line: LineSetting::rtu(19_200, Parity::Even) };
        Active::new(&Setup::plain(model == "acu"), place, Some(&family))
    }

    /// What one request gives: the reply PDU.
    fn ask(drive: &mut Active, pdu: &[u8]) -> Vec<u8> {
        answer(drive, &mut Counters::default(), Tick::from_micros(1), pdu).0.encode()
    }

    /// The error register after a refused request.
    fn cause(drive: &mut Active, pdu: &[u8]) -> u8 {
        let function = pdu[0] | 0x80;
        assert_eq!(ask(drive, pdu), [function, 4], "{pdu:02X?}");
        let [.., code] = ask(drive, &[3, 0, 11, 0, 1])[..] else { panic!("no register") };
        assert_eq!(ask(drive, &[3, 0, 11, 0, 1]), [3, 2, 0, 0], "reading clears the register");
        code
    }

    #[test]
    fn causes_of_refusal() {
        let acu = &mut drive("acu");
        let mut act = drive("act");
        for (pdu, code, what) in [
            (&[3, 0x06, 0x40, 0, 1][..], 11, "beyond 1599"),
            (&[3, 0x00, 0x01, 0, 1], 11, "not in the catalogue"),
            (&[3, 0xA1, 0x74, 0, 1], 2, "data set 10"),
            (&[3, 0x10, 0x0A, 0, 1], 2, "set 1 of a parameter that exists once"),
            (&[100, 0x01, 0xE4], 3, "484 is write-only on the ACU"),
            (&[6, 0x01, 0x04, 0, 0], 4, "260 is read-only"),
            (&[6, 0x01, 0x8B, 0, 9], 1, "395 goes to 3"),
            (&[3, 0x01, 0xE0, 0, 1], 14, "480 is long"),
            (&[100, 0x21, 0x74], 14, "372 is a word"),
        ] {
            assert_eq!(cause(acu, pdu), code, "{what}");
        }
        assert_eq!(ask(&mut act, &[100, 0x01, 0xE4]), [100, 0, 0, 0, 0], "the ACT tells its 484");
    }

    #[test]
    fn exceptions_that_leave_no_cause() {
        let mut act = drive("act");
        for (pdu, code) in [
            (&[1, 0, 0, 0, 1][..], 1),
            (&[16, 0, 0, 0, 1, 2, 0, 0], 1),
            (&[8, 0, 0x13, 0, 0], 1),
            (&[8, 0, 0, 0, 0], 1),
            (&[3, 0x21, 0x74, 0, 2], 2),
            (&[3, 0x21, 0x74, 0], 3),
            (&[101, 0x21, 0x77, 0, 0], 3),
            (&[8, 0, 0x0B, 0, 1], 3),
        ] {
            assert_eq!(ask(&mut act, pdu), [pdu[0] | 0x80, code], "{pdu:02X?}");
        }
        assert_eq!(ask(&mut act, &[3, 0, 11, 0, 1]), [3, 2, 0, 0]);
    }

    #[test]
    fn sets_memories_and_wear() {
        let mut act = drive("act");
        assert_eq!(ask(&mut act, &[6, 0x01, 0x74, 0x05, 0xDC]), [6, 0x01, 0x74, 0x05, 0xDC]);
        assert_eq!((act.eeprom_writes(), act.eeprom(372, 3)), (4, Some(1_500)));
        ask(&mut act, &[6, 0x21, 0x74, 0x05, 0x78]);
        assert_eq!((act.eeprom_writes(), act.ram(372, 7)), (5, Some(1_400)));
        assert_eq!(cause(&mut act, &[3, 0x01, 0x74, 0, 1]), 9);
        assert_eq!(cause(&mut act, &[3, 0x51, 0x74, 0, 1]), 9);
        // Data set 7 is the RAM copy of data set 2.
        ask(&mut act, &[6, 0x71, 0x74, 0x05, 0xDC]);
        assert_eq!((act.eeprom_writes(), act.eeprom(372, 2), act.ram(372, 2)), (5, Some(1_400), Some(1_500)));
        assert_eq!(ask(&mut act, &[3, 0x21, 0x74, 0, 1]), [3, 2, 0x05, 0x78]);
        assert_eq!(ask(&mut act, &[3, 0x71, 0x74, 0, 1]), [3, 2, 0x05, 0xDC]);
        act.power_up(Tick::from_micros(9), Tick::from_micros(9));
        assert_eq!(ask(&mut act, &[3, 0x71, 0x74, 0, 1]), [3, 2, 0x05, 0x78]);
        // The control word never goes to the EEPROM, and only data set 0 has it.
        ask(&mut act, &[6, 0x01, 0x9A, 0, 6]);
        assert_eq!((act.eeprom_writes(), act.ram(410, 0), act.eeprom(410, 0)), (5, Some(6), None));
        assert_eq!(cause(&mut act, &[6, 0x11, 0x9A, 0, 6]), 2);
    }

    #[test]
    fn the_state_machine_answers_to_the_control_word() {
        let mut acu = drive("acu");
        let status = |acu: &mut Active| {
            let [.., high, low] = ask(acu, &[3, 0x01, 0x9B, 0, 1])[..] else { panic!("no status") };
            u16::from(high) << 8 | u16::from(low)
        };
        assert_eq!(status(&mut acu) & 0x6F, 0x23, "under the keypad");
        ask(&mut acu, &[6, 0x01, 0x9C, 0, 1]);
        assert_eq!(status(&mut acu), 0x0250);
        ask(&mut acu, &[6, 0x01, 0x9A, 0, 0x0F]);
        assert_eq!(status(&mut acu) & 0xFF, 0x37);
        assert_eq!(cause(&mut acu, &[6, 0, 34, 0, 123]), 8);
        acu.warn(0x0082);
        assert_eq!(status(&mut acu) & 0x8080, 0x8080);
        assert_eq!(ask(&mut acu, &[3, 0x01, 0x0E, 0, 1]), [3, 2, 0x00, 0x83]);
    }
}
