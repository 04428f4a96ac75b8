//! What an ear makes of bytes, however they come.

use super::*;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::{Framing, rtu};
use crate::protocol::{Protocol, vabus};

const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);
const READ: &[u8] = &[0x01, 0x03, 0x21, 0x74, 0x00, 0x01, 0xCE, 0x2C];

fn ear(protocol: Protocol) -> Ear<'static> {
    let reader = Reader { protocol, node: 0, family: None, order: None };
    let terms = Terms { thousand: LINE.chars(1_000), pause: None, patience: Span::from_millis(500), everybody: 0 };
    let census = Census::new(terms, Tick::from_micros(0));
    Ear::new(reader, Cutter::new(protocol, LINE), Span::from_millis(500), census)
}

fn rtu() -> Ear<'static> {
    ear(Framing::Rtu.into())
}

fn at(ms: u64) -> Tick {
    Tick::from_micros(ms * 1_000)
}

/// Sign of direction and bytes of every telegram.
fn short(docs: &[TelegramDoc]) -> Vec<(&'static str, &str)> {
    let sign = |doc: &TelegramDoc| if doc.check_ok { doc.direction.unwrap_or("either") } else { "garbled" };
    docs.iter().map(|doc| (sign(doc), doc.hex.as_str())).collect()
}

/// What comes of chunks however they are cut, with the silence at the end.
fn all_cuts(protocol: Protocol, bytes: &[u8]) -> Vec<(&'static str, String)> {
    let run = |size: usize| {
        let mut ear = ear(protocol);
        let mut docs: Vec<_> = bytes.chunks(size).flat_map(|chunk| ear.feed(at(1), chunk)).collect();
        docs.extend(ear.silence());
        assert!(ear.arrivals.is_empty());
        short(&docs).into_iter().map(|(sign, hex)| (sign, hex.to_owned())).collect::<Vec<_>>()
    };
    let whole = run(bytes.len());
    (1..bytes.len()).for_each(|size| assert_eq!(run(size), whole, "chunks of {size}"));
    whole
}

fn told(expected: &[(&'static str, &str)]) -> Vec<(&'static str, String)> {
    expected.iter().map(|(sign, hex)| (*sign, (*hex).to_owned())).collect()
}

#[test]
fn rtu_telegrams_that_are_glued_are_parted_however_the_chunks_fall() {
    let reply = rtu::encode(1, &[3, 2, 0x05, 0x6E]);
    let refusal = rtu::encode(1, &[0x83, 2]);
    let bytes = [READ, &reply, READ, &refusal].concat();
    let expected = [
        ("request", "01 03 21 74 00 01 CE 2C"),
        ("reply", "01 03 02 05 6E 3A F8"),
        ("request", "01 03 21 74 00 01 CE 2C"),
        ("reply", "01 83 02 C0 F1"),
    ];
    assert_eq!(all_cuts(Framing::Rtu.into(), &bytes), told(&expected));
}

#[test]
fn noise_between_rtu_telegrams_is_told_and_costs_no_telegram() {
    let bytes = [&[0x00, 0xFF], READ, &[0x55], READ].concat();
    let mut ear = rtu();
    let mut docs = ear.feed(at(1), &bytes);
    docs.extend(ear.silence());
    let request = ("request", "01 03 21 74 00 01 CE 2C");
    assert_eq!(short(&docs), [("garbled", "00 FF"), request, ("garbled", "55"), request]);
}

#[test]
fn endless_noise_does_not_pile_up_and_is_left_behind() {
    let mut ear = rtu();
    let noise = ear.feed(at(1), &[0xFF; 2_000]);
    assert!(noise.len() >= 6 && noise.iter().all(|doc| !doc.check_ok), "{}", noise.len());
    assert!(ear.arrivals.len() <= 2 * rtu::MAX_FRAME);
    ear.silence();
    assert_eq!(short(&ear.feed(at(100), READ)), [("request", "01 03 21 74 00 01 CE 2C")]);
}

#[test]
fn a_function_code_that_nobody_knows_ends_with_silence() {
    let mut ear = rtu();
    let strange = rtu::encode(5, &[0x41, 1, 2, 3]);
    assert!(ear.feed(at(1), &strange).is_empty());
    assert_eq!(ear.ends(at(1)), Some(at(51)));
    let docs = ear.silence();
    assert_eq!((docs.len(), docs[0].check_ok, docs[0].function), (1, true, Some(0x41)));
}

#[test]
fn a_telegram_that_is_torn_by_the_adapter_keeps_the_time_of_its_first_byte() {
    let mut ear = rtu();
    assert!(ear.feed(at(7), &READ[..3]).is_empty());
    let docs = ear.feed(at(23), &READ[3..]);
    assert_eq!((docs.len(), docs[0].at_us), (1, Some(7_000)));
}

#[test]
fn of_telegrams_that_look_alike_the_first_is_the_request_once_something_was_heard() {
    let write = rtu::encode(3, &[6, 0x41, 0x78, 0, 0x0F]);
    let mut ear = rtu();
    let directions: Vec<_> = [(0, &*write), (10, READ), (20, &write), (30, &write), (40, &write), (900, &write)]
        .into_iter()
        .flat_map(|(ms, bytes)| ear.feed(at(ms), bytes))
        .map(|doc| doc.direction)
        .collect();
    // At 900 ms the request of 40 ms is long lost.
    let (request, reply) = (Some("request"), Some("reply"));
    assert_eq!(directions, [None, request, request, reply, request, request]);
}

/// Directions and counts of what came at these times, behind a read that was answered in 17 ms if one is `known`.
fn heard(known: bool, times: &[u64]) -> (Vec<Option<&'static str>>, crate::outcome::SniffedStation) {
    let (write, reply) = (rtu::encode(1, &[6, 0x01, 0xE0, 1, 0xF4]), rtu::encode(1, &[3, 2, 5, 0x6E]));
    let mut ear = rtu();
    if known {
        ear.feed(at(0), READ);
        ear.feed(at(17), &reply);
    }
    let told = times.iter().flat_map(|ms| ear.feed(at(1_000 + ms), &write)).map(|doc| doc.direction).collect();
    (told, ear.census.count(at(60_000)).stations.swap_remove(0))
}

#[test]
fn a_write_that_is_repeated_and_never_answered_is_not_called_answered() {
    let times: Vec<u64> = (0..12).map(|nth| nth * 300).collect();
    let (directions, station) = heard(false, &times);
    assert!(directions.iter().all(Option::is_none), "{directions:?}");
    assert_eq!((station.requests, station.replies, station.unanswered, station.either), (1, 0, 0, 11));
    assert_eq!(station.median_us, None);
    // A master with a time-out beyond that of drives, such as pymodbus with its 3 s: each is a request.
    let (directions, station) = heard(true, &[0, 3_000, 6_000]);
    assert_eq!(directions, [Some("request"); 3]);
    assert_eq!((station.requests, station.replies, station.unanswered, station.either), (4, 1, 3, 0));
}

#[test]
fn a_retry_behind_a_lost_reply_is_a_request_and_turns_nothing_round() {
    let (request, reply) = (Some("request"), Some("reply"));
    for known in [true, false] {
        let (directions, station) = heard(known, &[0, 16, 1_000, 1_400, 1_416, 2_000, 2_016]);
        let first = if known { request } else { None };
        assert_eq!(
            directions,
            [first, reply, request, None, reply, request, reply],
            "the retry is known behind its reply"
        );
        let read = u64::from(known);
        let counts = (station.requests, station.replies, station.unanswered, station.either);
        assert_eq!(counts, (4 + read, 3 + read, 1, 0));
        assert!(station.slowest_us < Some(20_000), "{station:?}");
        assert_eq!(station.repeats.iter().map(|row| (row.times, row.questions)).collect::<Vec<_>>(), [(1, 1)]);
    }
    // Another value is another request, however soon it comes.
    let mut ear = rtu();
    ear.feed(at(1), READ);
    let writes = [1u8, 2].map(|value| rtu::encode(1, &[6, 1, 0xE0, 0, value]));
    let told: Vec<_> = writes.iter().flat_map(|bytes| ear.feed(at(50), bytes)).map(|doc| doc.direction).collect();
    assert_eq!(told, [request; 2]);
}

/// A token names neither a question nor whom it is for: the reader of Modbus, which tells the two apart, has no say in it.
#[test]
fn a_token_stays_one_and_is_neither_a_question_nor_garbled() {
    let (token, asks): (&[u8], &[u8]) = (&[0xDC, 0x02, 0x01], &[0x10, 0x03, 0x01, 0x49, 0x4D, 0x16]);
    let tells: &[u8] = &[0x10, 0x01, 0x03, 0x00, 0x04, 0x16];
    let mut ear = rtu();
    ear.cutter = Cutter::dp();
    ear.profibus = Some(dp::Reader { family: None, cyclic: None });
    let heard = [(0, token), (10, asks), (15, tells), (20, token), (30, asks), (40, token), (41, token)];
    let docs: Vec<_> = heard.into_iter().flat_map(|(ms, bytes)| ear.feed(at(ms), bytes)).collect();
    let token = ("either", "DC 02 01");
    let asks = ("request", "10 03 01 49 4D 16");
    assert_eq!(short(&docs), [token, asks, ("reply", "10 01 03 00 04 16"), token, asks, token, token]);
    assert!(docs.iter().filter(|doc| doc.direction.is_none()).all(|doc| doc.meaning.en.contains("token")), "{docs:?}");
    let count = ear.census.count(at(60_000));
    let station = &count.stations[0];
    assert_eq!((count.heard, count.garbled, count.stations.len()), (7, 0, 1));
    let counts = (station.requests, station.replies, station.unanswered, station.either, station.check_errors);
    assert_eq!((station.address, counts), (3, (2, 1, 1, 0, 0)));
}

#[test]
fn ascii_telegrams_end_with_their_line_or_with_the_next_colon() {
    // B6h is a '6' with the parity bit that some drivers leave in.
    let bytes = b"\r\n:01032174000166\r\n:0103:010321740001\xB66\r\n:01830";
    let all = all_cuts(Framing::Ascii.into(), bytes);
    let signs: Vec<_> = all.iter().map(|(sign, _)| *sign).collect();
    assert_eq!(signs, ["garbled", "request", "garbled", "request", "garbled"]);
}

#[test]
fn vabus_is_cut_by_its_characters_and_a_check_value_of_zero_is_one() {
    let address = vabus::Address::drive(1).unwrap();
    let number = vabus::ParamNumber::new(372).unwrap();
    let node = vabus::SystemNode::new(50).unwrap();
    let header = vabus::Header { node, number, ..vabus::Header::default() };
    let reply = |bits| vabus::Reply::Value { address, header, data: vabus::Data::word(bits) }.encode();
    let zero = (0..u16::MAX).map(reply).find(|bytes| bytes.last() == Some(&0)).unwrap();
    let question = vabus::Request::Enquiry { address, header }.encode();
    let bytes = [&*question, &zero, &question, b"\x41\x15", b"\x04"].concat();
    let signs: Vec<_> = all_cuts(Protocol::Vabus, &bytes).into_iter().map(|(sign, _)| sign).collect();
    assert_eq!(signs, ["request", "reply", "request", "reply", "request"]);
}
