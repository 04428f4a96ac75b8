//! What can be taken for what, in every protocol.

use super::modbus::has_form_of_reply;
use super::*;
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
