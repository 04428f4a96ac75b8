//! A question and its answer with the line in the fuzzer's hand: it ends in time, and does not run in circles.
#![no_main]

use antrieb::exchange::{Limits, Master, Question};
use antrieb::protocol::modbus::pdu::Request;
use antrieb::protocol::vabus::{self, Address, Data, Header, ParamNumber};
use antrieb::protocol::{Protocol, line::Parity};
use antrieb::tick::Tick;
use antrieb_fuzz::{Line, carry};
use libfuzzer_sys::fuzz_target;

fn question(protocol: Protocol, which: u8) -> Question {
    let number = |number| Header { number: ParamNumber::new(number).expect("three digits"), ..Header::default() };
    let address = Address::drive(1).expect("an address");
    match (protocol, which % 4) {
        (Protocol::Vabus, 3) => vabus::Request::Select { address, header: number(410), data: Data::word(7) }.into(),
        (Protocol::Vabus, _) => vabus::Request::Enquiry { address, header: number(372) }.into(),
        (_, 0) => Request::ReadRegisters { start: 0x2174, count: 1 }.into(),
        (_, 1) => Request::ReadIdentification { category: 1, object: 0 }.into(),
        (_, 2) => Request::ReadLong { address: 0x01E1 }.into(),
        (_, _) => Request::WriteRegister { address: 410, value: 7 }.into(),
    }
}

fuzz_target!(|said: (u8, bool, Vec<u8>)| {
    let (kind, wired, said) = said;
    let protocol = Protocol::ALL[usize::from(kind) % Protocol::ALL.len()];
    let line = protocol.line(19_200, Parity::Even);
    let limits = Limits::default();
    let mut master = Master::new(protocol, line, limits);
    master.set_wired(wired);
    let mut line_of = Line::new(said);
    let mut now = Tick::ZERO;
    for which in [kind, kind >> 2, kind >> 4] {
        master.ask_within(1, question(protocol, which), limits, now);
        let _ = carry(&mut master, &mut line_of, &mut now, limits.longest(protocol, line));
        master.take_records();
    }
});
