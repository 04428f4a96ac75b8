//! Modbus in all framings: what is understood is the same again when it is sent.
#![no_main]

use antrieb::protocol::modbus::pdu::{Reply, Request};
use antrieb::protocol::modbus::{Framing, ascii, mbap, rtu};
use antrieb::protocol::{Protocol, line::Parity};
use antrieb::tick::Tick;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(request) = Request::decode(bytes) {
        assert_eq!(Request::decode(&request.encode()).as_ref(), Ok(&request));
    }
    if let Ok(reply) = Reply::decode(bytes) {
        assert_eq!(Reply::decode(&reply.encode()).as_ref(), Ok(&reply));
    }
    for framing in [Framing::Rtu, Framing::Ascii] {
        if let Ok(adu) = framing.decode(bytes) {
            assert_eq!(framing.decode(&framing.encode(adu.station, &adu.pdu)), Ok(adu));
        }
    }
    if let Ok((number, adu)) = mbap::decode(bytes) {
        assert_eq!(mbap::decode(&mbap::encode(number, adu.station, &adu.pdu)), Ok((number, adu)));
    }
    let line = Protocol::Modbus(Framing::Rtu).line(19_200, Parity::Even);
    let (mut bursts, mut lines) = (rtu::Receiver::new(line), ascii::Receiver::default());
    let mut at = Tick::ZERO;
    for &byte in bytes {
        // Every byte comes somewhat later than the last: some at once, some behind a pause.
        at = at + line.chars(1 + u64::from(byte % 5));
        bursts.feed(at, byte);
        lines.feed(at, byte);
    }
});
