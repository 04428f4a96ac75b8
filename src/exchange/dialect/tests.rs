//! What can be taken for what, in every protocol.

use super::modbus::has_form_of_reply;
use super::*;
use crate::protocol::can::sdo::{self as can, AbortCode, Initiate, Multiplexer};
use crate::protocol::can::{SdoChannel, Service, Telegram};
use crate::protocol::dp::pkw::Pkw;
use crate::protocol::modbus::pdu::{Reply, Request};
use crate::protocol::modbus::{Framing, ascii, rtu};
use crate::protocol::vabus::{self, Header};

fn dialect(framing: Framing) -> Dialect {
    Dialect::new(framing.into())
}

fn vabus() -> Dialect {
    Dialect::new(Protocol::Vabus)
}

fn read(start: u16) -> Question {
    Question::Modbus(Request::ReadRegisters { start, count: 1 })
}

fn write(value: u16) -> Question {
    Question::Modbus(Request::WriteRegister { address: 410, value })
}

fn counter(sub: u16) -> Question {
    Question::Modbus(Request::Diagnostics { sub, data: 0 })
}

/// Asks for P.480 of a data set.
fn enquiry(set: u8) -> Question {
    let header = Header {
        set: vabus::DataSet::new(set).unwrap(),
        number: vabus::ParamNumber::new(480).unwrap(),
        ..Header::default()
    };
    Question::Vabus(vabus::Request::Enquiry { address: vabus::Address::drive(1).unwrap(), header })
}

#[test]
fn a_telegram_straggles_no_longer_than_the_longest() {
    let ascii = dialect(Framing::Ascii);
    assert_eq!(ascii.straggle(b":0103"), ascii::MAX_PAUSE);
    assert_eq!(ascii.straggle(b":0103FC\r\n"), STRAGGLE);
    assert_eq!(ascii.longest_straggle(), ascii::MAX_PAUSE);
    for dialect in [dialect(Framing::Rtu), dialect(Framing::Tcp), vabus()] {
        assert_eq!((dialect.straggle(b":0103"), dialect.longest_straggle()), (STRAGGLE, STRAGGLE));
    }
}

#[test]
fn what_names_what_it_answers_is_not_confused() {
    let confuses = |dialect: Dialect, missing, question| dialect.confuses(&missing, &question);
    for framing in [Framing::Rtu, Framing::Ascii] {
        let dialect = dialect(framing);
        assert!(confuses(dialect, read(1), read(2)), "a value names nothing");
        assert!(!confuses(dialect, read(1), read(1)), "the same question has the same answer");
        assert!(!confuses(dialect, write(1), write(2)), "a write is echoed");
        assert!(!confuses(dialect, counter(11), counter(12)) && !confuses(dialect, read(1), write(1)));
    }
    assert!(!confuses(dialect(Framing::Tcp), read(1), read(2)), "telegrams are numbered");
    // A drive names the data sets 0 to 4, in RAM as well.
    for (missing, question, confused) in [(2, 7, true), (7, 2, true), (7, 7, false), (1, 2, false), (7, 1, false)] {
        assert_eq!(confuses(vabus(), enquiry(missing), enquiry(question)), confused, "{missing} {question}");
    }
}

#[test]
fn a_refusal_names_the_function_and_over_vabus_nothing() {
    let alike = |dialect: Dialect, missing, question| dialect.refuses_alike(&missing, &question);
    let rtu = dialect(Framing::Rtu);
    assert!(alike(rtu, read(1), read(2)) && alike(rtu, write(1), write(2)));
    assert!(!alike(rtu, read(1), write(1)) && !alike(rtu, read(1), read(1)));
    assert!(!alike(dialect(Framing::Tcp), read(1), read(2)));
    assert!(alike(vabus(), enquiry(1), enquiry(2)) && !alike(vabus(), enquiry(1), enquiry(1)));
}

#[test]
fn a_fence_settles_by_what_is_neither_its_echo_nor_older() {
    let rtu = dialect(Framing::Rtu);
    let fence = counter(11);
    let said = |data| Said::Modbus(Reply::Diagnostics { sub: 11, data });
    let settles = |said: &Said, missing: &[Question], may_echo| rtu.settles(&fence, said, missing, may_echo);
    assert!(settles(&said(7), &[read(1)], true) && settles(&said(7), &[read(1)], false));
    assert!(!settles(&said(0), &[read(1)], true), "in the bytes of its echo");
    assert!(settles(&said(0), &[read(1)], false), "which this line does not bring");
    let refused = Said::Modbus(Reply::decode(&[0x88, 1]).unwrap());
    assert!(settles(&refused, &[read(1)], true), "a read is not refused so");
    assert!(!settles(&refused, &[read(1), counter(12)], false), "it may be the refusal of what is missing");
}

#[test]
fn a_reply_is_known_by_its_form() {
    let rtu = |pdu: &[u8]| has_form_of_reply(Framing::Rtu, &rtu::encode(1, pdu));
    assert!(rtu(&[3, 2, 5, 6]) && !rtu(&[3, 2, 5]) && !rtu(&[0x55, 1, 2]) && !has_form_of_reply(Framing::Rtu, &[1]));
    let ascii = |bytes: &[u8]| has_form_of_reply(Framing::Ascii, bytes);
    assert!(ascii(b":0103FC\r\n") && !ascii(b"0103FC\r\n") && !ascii(b":0103FC"));
    assert!(!has_form_of_reply(Framing::Tcp, b":0103FC\r\n"));
}

/// Writes P.480 of a drive.
fn select() -> Question {
    let Question::Vabus(vabus::Request::Enquiry { address, header }) = enquiry(0) else { unreachable!() };
    Question::Vabus(vabus::Request::Select { address, header, data: vabus::Data::word(7) })
}

#[test]
fn what_is_harmless_is_asked_for_its_answer_alone() {
    let Question::Vabus(vabus::Request::Enquiry { address, header }) = enquiry(0) else { unreachable!() };
    let header = Header { number: vabus::ParamNumber::ERROR_REGISTER, ..header };
    let cleared = Question::Vabus(vabus::Request::Enquiry { address, header });
    let harmless = |question: Question| question.is_harmless();
    assert!(harmless(enquiry(0)) && !harmless(select()) && !harmless(cleared), "P.11 is cleared by reading");
    assert!(!harmless(read(1)) && !harmless(counter(11)) && !harmless(write(1)));
}

#[test]
fn an_order_and_a_question_of_vabus_are_told_apart() {
    let Question::Vabus(vabus::Request::Enquiry { address, header }) = enquiry(2) else { unreachable!() };
    assert!(select().is_write() && !enquiry(2).is_write());
    assert_eq!([select().function(), enquiry(2).function()], [1, 0]);
    let value = |header| Said::Vabus(vabus::Reply::Value { address, header, data: vabus::Data::word(7) });
    let other = Header { number: vabus::ParamNumber::new(481).unwrap(), ..header };
    assert!(enquiry(2).is_answered_by(&value(header)) && !enquiry(2).is_answered_by(&value(other)));
    assert!(!enquiry(2).is_answered_by(&Said::Modbus(Reply::Registers(vec![7]))));
    assert!(vabus().confuses(&select(), &other_select()), "an ACK names nothing");
    assert!(!vabus().confuses(&select(), &enquiry(2)) && !vabus().confuses(&enquiry(2), &select()));
}

fn other_select() -> Question {
    let Question::Vabus(vabus::Request::Select { address, header, .. }) = select() else { unreachable!() };
    Question::Vabus(vabus::Request::Select { address, header, data: vabus::Data::word(8) })
}

/// A block of P.303, or of an element of another.
fn block(ak: u8, element: u8) -> Pkw {
    Pkw { ak, pnu: if element == 0 { 303 } else { 918 }, ind: u16::from(element) << 8, ..Pkw::default() }
}

/// Whose value it is stands in every block, so that an answer of before is none to what was asked behind it.
#[test]
fn a_block_of_pkw_names_its_station_its_parameter_and_its_element() {
    let pkw = Dialect::new(Protocol::Pkw);
    let question = Question::from(block(6, 2));
    let telegram = |station: u8, said: Pkw| [&[station], &said.encode()[..]].concat();
    let found = |came: &[Vec<u8>]| pkw.find(&came.concat(), 3, &question).map(|found| (found.start, found.end));
    let answer = telegram(3, block(4, 2));
    assert_eq!(found(std::slice::from_ref(&answer)), Some((0, 9)));
    for other in [telegram(4, block(4, 2)), telegram(3, block(4, 1)), telegram(3, block(1, 0))] {
        assert_eq!(found(std::slice::from_ref(&other)), None, "{other:02X?}");
        assert_eq!(found(&[other, answer.clone()]), Some((9, 18)));
    }
    assert_eq!(pkw.sender(&answer), Some((3, Some(Said::Pkw(block(4, 2))))));
    assert_eq!(pkw.sender(&answer[1..]), None, "a block that is not whole");
    assert_eq!((pkw.names_its_question(), pkw.shortest_reply()), (true, 9));
    for (missing, confused) in [(block(6, 2), false), (block(7, 2), false), (block(6, 1), true), (block(1, 0), true)] {
        let missing = Question::from(missing);
        assert_eq!(pkw.answers_alike(&missing, &question), !confused, "{missing:?}");
        assert_eq!(pkw.refuses_alike(&missing, &question), !confused && missing != question, "{missing:?}");
    }
}

const SDO: Dialect = Dialect::Sdo(sdo::Sdo(SdoChannel::Two));

fn of(index: u16) -> Multiplexer {
    Multiplexer { index, sub: 0 }
}

fn upload(index: u16) -> Question {
    Question::from(can::Request::Upload(of(index)))
}

fn download(index: u16) -> Question {
    Question::from(can::Request::Download(of(index), Initiate::word(1)))
}

/// What a node says over a channel.
fn said(channel: SdoChannel, node: u8, reply: &can::Reply) -> Vec<u8> {
    let identifier = Service::SdoReply(channel, node).identifier().unwrap();
    Telegram { identifier, data: reply.encode() }.encode().to_vec()
}

#[test]
fn a_refusal_of_sdo_names_the_parameter_and_not_what_was_done_with_it() {
    let write = download(0x2174);
    assert!(SDO.refuses_alike(&upload(0x2174), &write) && !SDO.refuses_alike(&upload(0x2175), &write));
    let alike = [download(0x2174), download(0x2175), upload(0x2174)].map(|missing| SDO.answers_alike(&missing, &write));
    assert_eq!(alike, [true, false, false], "an acknowledgement is no value");
    assert!(Said::Sdo(can::Reply::Abort(of(1), AbortCode(0))).is_refusal());
    assert!(!Said::Sdo(can::Reply::Downloaded(of(1))).is_refusal());
}

/// An answer is known by its channel, its node and its parameter, wherever it comes among others.
#[test]
fn an_answer_of_sdo_is_found_among_others() {
    let (mine, other) = (SdoChannel::Two, SdoChannel::One);
    let value = |index| can::Reply::Upload(of(index), Initiate::word(7));
    let found = |came: &[Vec<u8>]| SDO.find(&came.concat(), 3, &upload(0x2174)).map(|found| (found.start, found.end));
    let answer = said(mine, 3, &value(0x2174));
    let others = [said(other, 3, &value(0x2174)), said(mine, 4, &value(0x2174)), said(mine, 3, &value(0x2175))];
    assert_eq!(found(&others), None);
    assert_eq!(found(&[&others[..], std::slice::from_ref(&answer)].concat()), Some((30, 40)));
    assert_eq!(SDO.shortest_reply(), 10);
    let within = [&answer[..], &[&answer[..], &[3]].concat()].map(|bytes| SDO.reply_within(bytes));
    assert_eq!(within, [None, Some(0..10)]);
    for (channel, asked) in [(mine, Some((3, upload(0x2174)))), (other, None)] {
        let request = Telegram::request(channel, 3, can::Request::Upload(of(0x2174)).encode()).unwrap();
        assert_eq!(SDO.question(&request.encode()), asked, "{channel:?}");
    }
    assert_eq!(SDO.question(&answer), None);
    assert!(SDO.names_its_question());
    let queues = [SDO, dialect(Framing::Rtu), vabus()].map(|dialect| dialect.queues());
    assert_eq!(queues, [true, false, false], "an adapter of CAN keeps frames until the bus takes them");
    let numbered = [Framing::Rtu, Framing::Ascii, Framing::Tcp].map(|framing| dialect(framing).is_numbered());
    assert_eq!(numbered, [false, false, true]);
}

/// Frames come whole; what is left of one when the bus is silent is told as it is.
#[test]
fn frames_are_cut_where_they_end() {
    let (mut cutter, _) = SDO.cutter(LineSetting::rtu(9_600, crate::protocol::line::Parity::Even));
    assert_eq!(cutter.feed(&[1; 9]), Vec::<Vec<u8>>::new());
    assert_eq!(cutter.feed(&[1; 14]), [vec![1; 10], vec![1; 10]]);
    assert_eq!(cutter.silence(), [vec![1; 3]]);
    assert_eq!(cutter.silence(), Vec::<Vec<u8>>::new());
}

#[test]
fn what_sdo_and_pkw_ask_is_harmless_where_it_reads_what_stays() {
    // The error register (P.11) is cleared by reading.
    let told = [upload(0x2174), upload(11), download(0x2174)];
    assert_eq!(told.each_ref().map(Question::is_harmless), [true, false, false]);
    assert_eq!(told.each_ref().map(Question::is_write), [false, false, true]);
    assert_eq!(told.map(|question| question.function()), [0, 0, 1]);
    let blocks = [block(1, 0), block(2, 0), block(6, 2), block(7, 2)].map(Question::from);
    assert_eq!(blocks.each_ref().map(Question::is_harmless), [true, false, true, false]);
    assert_eq!(blocks.each_ref().map(Question::is_write), [false, true, false, true]);
    assert_eq!(blocks.map(|question| question.function()), [1, 2, 6, 7]);
    // Over a line of another protocol it goes out as it would over its own.
    let mut sdo = SDO;
    assert_eq!(vabus().encode(3, &upload(0x2174)), sdo.encode(3, &upload(0x2174)));
}

/// Everybody answers who is asked for a value over Modbus, if only by a refusal; a counter need not be there.
#[test]
fn a_value_is_asked_for_by_reading_alone() {
    assert!(read(1).asks_for_a_value() && Question::Modbus(Request::ReadLong { address: 210 }).asks_for_a_value());
    assert!(!write(1).asks_for_a_value() && !counter(11).asks_for_a_value() && !enquiry(1).asks_for_a_value());
}

#[test]
fn a_question_of_somebody_else_is_known_by_its_bytes() {
    let asked = |dialect: Dialect, bytes: &[u8]| crate::exchange::foreign::last(dialect, bytes, |_| false);
    let rtu = |request: Request| rtu::encode(9, &request.encode());
    // A telegram that ends in 0 is a whole one without it, too: it may be a reply and a little noise.
    let all = (0..u16::MAX).map(|start| rtu(Request::ReadRegisters { start, count: 1 }));
    let zero: Vec<Vec<u8>> = all.filter(|bytes| bytes.last() == Some(&0)).collect();
    let decode = |bytes: &[u8]| Framing::Rtu.decode(bytes).is_ok();
    assert!(zero.iter().all(|bytes| decode(&bytes[..7]) && asked(dialect(Framing::Rtu), bytes).is_none()));
    for bytes in [rtu(Request::ReadLong { address: 210 }), rtu(Request::WriteRegister { address: 1, value: 2 })] {
        assert_eq!(asked(dialect(Framing::Rtu), &bytes).map(|found| found.0), Some(9), "{bytes:?}");
    }
    let nobodys = [
        Request::Diagnostics { sub: 11, data: 0 },
        Request::ReadIdentification { category: 1, object: 0 },
        Request::Other { function: 0x55, data: vec![1] },
    ];
    for request in nobodys.map(rtu) {
        assert_eq!(asked(dialect(Framing::Rtu), &request), None, "{request:?} may be an answer as well");
    }
    assert_eq!(asked(vabus(), &enquiry(2).telegram(Protocol::Vabus, 1)), Some((1, enquiry(2))));
}

#[test]
fn what_a_protocol_says_of_its_telegrams() {
    let [rtu, ascii, tcp] = [Framing::Rtu, Framing::Ascii, Framing::Tcp].map(dialect);
    assert_eq!([rtu, ascii, tcp, vabus()].map(|dialect| dialect.shortest_reply()), [5, 11, 9, 2]);
    let line = LineSetting::rtu(9_600, crate::protocol::line::Parity::Even);
    assert_eq!(rtu.least_turnaround(line), line.t35());
    assert_eq!([ascii, vabus()].map(|dialect| dialect.least_turnaround(line).as_micros()), [0, 1_000]);
    // A question of another protocol goes out as it would on a serial line of its own.
    assert_eq!(vabus().encode(9, &read(1)), rtu::encode(9, &[3, 0, 1, 0, 1]));
    // An exchange of registers names as many as it reads.
    let exchange = |count| {
        Question::Modbus(Request::ExchangeRegisters { start: 1, count, write_start: 5, values: vec![count, 0] })
    };
    assert!(rtu.confuses(&exchange(2), &{
        let values = vec![9];
        Question::Modbus(Request::ExchangeRegisters { start: 3, count: 2, write_start: 5, values })
    }));
    assert!(!rtu.confuses(&exchange(2), &exchange(3)));
    // Registers that were written are told by their first one and their number.
    let written = |start, count| Question::Modbus(Request::WriteRegisters { start, values: vec![7; count] });
    let other = Question::Modbus(Request::WriteRegisters { start: 1, values: vec![8, 9] });
    let confused = [other, written(2, 2), written(1, 3)].map(|question| rtu.confuses(&written(1, 2), &question));
    assert_eq!(confused, [true, false, false]);
}

#[test]
fn a_reply_is_found_behind_noise_as_soon_as_it_can_end() {
    let refusal = rtu::encode(1, &[0x83, 2]);
    let within =
        |noise: usize| dialect(Framing::Rtu).reply_within(&[&vec![0x55; noise][..], &refusal, &[0x55]].concat());
    assert_eq!([0, 1, 2, 3, 9].map(within), [0, 1, 2, 3, 9].map(|noise| Some(noise..noise + 5)));
}

#[test]
fn a_fence_is_a_counter_that_counts_itself_or_one_that_was_asked_in_vain() {
    let rtu = dialect(Framing::Rtu);
    let fence = |missing: &[Question], question: Question, counters: &[u16]| {
        rtu.fence(&Old { missing, question: &question, known: &[], counters: Some(counters) })
    };
    assert_eq!(fence(&[read(2)], read(1), &[0x0C, 0x0E, 0x12]), Some(counter(0x0E)));
    assert_eq!(fence(&[read(2), counter(0x0E)], read(1), &[0x0C, 0x0E]), Some(counter(0x0C)));
    assert_eq!(fence(&[read(2), counter(0x0E)], read(1), &[0x0E]), Some(counter(0x0E)), "asked in vain");
    assert_eq!(fence(&[counter(0x0E), read(2)], read(1), &[0x0E]), None, "something was asked since");
    assert_eq!(fence(&[counter(0x0E)], counter(0x0E), &[0x0E]), None);
    let stands = [0x0B, 0x0E, 0x0C, 0x12].map(|sub| rtu.may_stand_still(&counter(sub)));
    assert_eq!(stands, [false, false, true, true], "these two count the very question");
    assert!(!rtu.may_stand_still(&read(1)) && !vabus().may_stand_still(&enquiry(1)));
}

#[test]
fn an_older_count_is_lower_and_over_vabus_nothing_is_an_echo() {
    let rtu = dialect(Framing::Rtu);
    let counted = |data| Said::Modbus(Reply::Diagnostics { sub: 11, data });
    assert_eq!([4, 7, 8].map(|data| rtu.is_older(&counted(data), &counted(7))), [true, false, false]);
    assert!(!rtu.is_older(&Said::Modbus(Reply::Registers(vec![1])), &counted(7)));
    let Question::Vabus(vabus::Request::Enquiry { address, header }) = enquiry(1) else { unreachable!() };
    let said = Said::Vabus(vabus::Reply::Value { address, header, data: vabus::Data::word(7) });
    assert!(vabus().settles(&enquiry(1), &said, &[select()], true) && !vabus().is_older(&said, &said));
}
