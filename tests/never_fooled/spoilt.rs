//! Replies that a line spoils: none is believed for what it does not say.

use antrieb::exchange::{Answer, Limits, Master, Question, Said, Step};
use antrieb::protocol::Protocol;
use antrieb::protocol::line::Parity;
use antrieb::protocol::modbus::Framing;
use antrieb::protocol::modbus::pdu::identification::Object;
use antrieb::protocol::modbus::pdu::{Exception, Identification, Reply, Request};
use antrieb::protocol::vabus::{self, Address, Data, Header, ParamNumber};
use antrieb::tick::{Span, Tick};

/// One of every kind: what is asked, and what the right answer is on the wire.
fn exchanges(protocol: Protocol) -> Vec<(Question, Vec<u8>)> {
    if protocol == Protocol::Vabus {
        let header = Header { number: ParamNumber::new(372).unwrap(), ..Header::default() };
        let address = Address::drive(1).unwrap();
        let data = [Data::word(1390), Data::long(0x0012_D687)];
        let enquiry = vabus::Request::Enquiry { address, header };
        let values = data.into_iter().map(|data| vabus::Reply::Value { address, header, data });
        let replies = values.chain([vabus::Reply::Nak { address }]).map(|reply| (enquiry.clone(), reply));
        let select = vabus::Request::Select { address, header, data: Data::word(1391) };
        let written = [(select.clone(), vabus::Reply::Ack { address }), (select, vabus::Reply::Nak { address })];
        return replies.chain(written).map(|(question, reply)| (question.into(), reply.encode())).collect();
    }
    let refused = |function| Reply::Exception { function, code: Exception::DeviceFailure };
    let object = |id, text: &str| Object { id, value: text.as_bytes().to_vec() };
    let told = Identification {
        category: 1,
        conformity: 1,
        next: None,
        objects: vec![object(0, "maker"), object(1, "LXM05"), object(2, "1.2")],
    };
    let read = |count| Request::ReadRegisters { start: 0x2174, count };
    let written = Request::WriteRegister { address: 0x4178, value: 15 };
    let many = Request::WriteRegisters { start: 6918, values: vec![0, 15] };
    let exchange = Request::ExchangeRegisters { start: 6918, count: 2, write_start: 6918, values: vec![0, 15] };
    let describe = Request::ReadIdentification { category: 1, object: 0 };
    let counter = Request::Diagnostics { sub: 0x0B, data: 0 };
    let long = Request::WriteLong { address: 0x01E1, value: 1000 };
    let rows = [
        (read(1), Reply::Registers(vec![1390])),
        (read(4), Reply::Registers(vec![1, 2, 3, 0xFFFF])),
        (read(1), refused(3)),
        (written.clone(), Reply::RegisterWritten { address: 0x4178, value: 15 }),
        (written, refused(6)),
        (counter, Reply::Diagnostics { sub: 0x0B, data: 515 }),
        (many, Reply::RegistersWritten { start: 6918, count: 2 }),
        (exchange, Reply::RegistersExchanged(vec![0, 15])),
        (describe, Reply::Identification(told)),
        (Request::ReadLong { address: 0x01E1 }, Reply::Long(0x0012_D687)),
        (long.clone(), Reply::LongWritten { address: 0x01E1, value: 1000 }),
        (long, refused(101)),
    ];
    let Protocol::Modbus(framing) = protocol else { return Vec::new() };
    rows.into_iter().map(|(request, reply)| (request.into(), framing.encode(1, &reply.encode()))).collect()
}

/// What a master that knows that its line does not echo makes of these bytes, all there is.
fn believed(protocol: Protocol, question: &Question, bytes: &[u8]) -> Option<Said> {
    let line = protocol.line(19_200, Parity::Even);
    let mut master = Master::new(protocol, line, Limits { retries: 0, ..Limits::default() });
    let mut now = Tick::ZERO;
    let mut ask = |question: &Question, came: &[u8]| {
        master.ask(1, question.clone(), now);
        let mut came = Some(came.to_vec());
        loop {
            match master.step(now) {
                Step::Send(_) => {}
                Step::Wait(until) => match came.take_if(|_| until > now + Span::from_millis(100)) {
                    Some(bytes) => {
                        now += Span::from_millis(20);
                        master.feed(now, &bytes);
                    }
                    None => now = until,
                },
                Step::Done(Ok(Answer::Reply { said, .. })) => return Some(said),
                Step::Done(_) => return None,
            }
        }
    };
    let (plain, reply) = exchanges(protocol).remove(0);
    ask(&plain, &reply);
    ask(question, bytes)
}

/// A telegram with every bit flipped, cut at every place, with every byte lost, every byte twice, and merged at every place with every
/// other one.
pub(crate) fn spoilt<'t>(whole: &'t [u8], others: impl Iterator<Item = &'t [u8]>) -> Vec<Vec<u8>> {
    let places = 0..whole.len();
    let split = |at: usize| whole.split_at(at);
    let flipped = places.clone().flat_map(|at| (0..8).map(move |bit| (at, bit))).map(|(at, bit)| {
        let mut flipped = whole.to_vec();
        flipped[at] ^= 1 << bit;
        flipped
    });
    let cut = places.clone().map(|at| split(at).0.to_vec());
    let lost = places.clone().map(|at| [split(at).0, split(at + 1).1].concat());
    let doubled = places.clone().map(|at| [split(at + 1).0, split(at).1].concat());
    let merged = others.flat_map(|other| {
        let places = (1..whole.len()).flat_map(|cut| (0..other.len()).map(move |skip| (cut, skip)));
        places.map(|(cut, skip)| [&whole[..cut], &other[skip..]].concat())
    });
    flipped.chain(cut).chain(lost).chain(doubled).chain(merged).collect()
}

/// Every reply, spoilt in every way: what is believed is what the whole reply says, or the check value happens to be right, which is
/// counted. Over TCP and CAN what comes has a check of its own, below us.
#[test]
fn spoilt_replies_are_not_believed() {
    for protocol in [Protocol::Modbus(Framing::Rtu), Protocol::Modbus(Framing::Ascii), Protocol::Vabus] {
        let exchanges = exchanges(protocol);
        let (mut tried, mut chance) = (0, 0);
        for (question, whole) in &exchanges {
            let right = believed(protocol, question, whole).unwrap_or_else(|| panic!("{question:?} {whole:02X?}"));
            for bytes in spoilt(whole, exchanges.iter().map(|(_, other)| &other[..])) {
                tried += 1;
                match believed(protocol, question, &bytes) {
                    Some(said) if said != right && !holds_whole(&bytes, &exchanges) => {
                        assert!(check_is_right(protocol, &bytes, &said), "{protocol}: {bytes:02X?} as {said:?}");
                        chance += 1;
                    }
                    _ => {}
                }
            }
        }
        println!("{protocol}: {tried} spoilt replies, {chance} believed because the check value was right");
        assert!(tried > 1_000);
    }
}

/// A telegram of RTU with two zeros behind it has a right check value once more, and code 100 answers in two bytes more than
/// it asks. The ten thousand found it: an adapter that echoes now and then, and noise of zeros.
#[test]
fn an_echo_with_zeros_behind_it_is_no_reply() {
    let question = Question::from(Request::ReadLong { address: 0x31E0 });
    let rtu = Protocol::Modbus(Framing::Rtu);
    let echo = question.telegram(rtu, 1);
    assert_eq!(believed(rtu, &question, &[&echo[..], &[0, 0]].concat()), None);
}

/// Whether an undamaged reply stands in these bytes: then believing it is right.
fn holds_whole(bytes: &[u8], exchanges: &[(Question, Vec<u8>)]) -> bool {
    exchanges.iter().any(|(_, whole)| bytes.windows(whole.len()).any(|window| window == whole))
}

/// Whether the telegram that was believed stands in the bytes with a right check value; ACK and NAK have none.
fn check_is_right(protocol: Protocol, bytes: &[u8], said: &Said) -> bool {
    let telegram = match (protocol, said) {
        (Protocol::Modbus(framing), Said::Modbus(reply)) => framing.encode(1, &reply.encode()),
        (_, Said::Vabus(reply)) => reply.encode(),
        _ => return false,
    };
    bytes.windows(telegram.len()).any(|window| window == telegram)
}
