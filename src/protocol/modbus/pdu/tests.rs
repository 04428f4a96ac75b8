//! Codecs of the PDU, both ways.

use super::identification::{BASIC, Object, SINGLE};
use super::*;
use crate::protocol::modbus::MAX_PDU;
use proptest::collection::vec;
use proptest::prelude::*;

#[test]
fn address_word_of_the_manual() {
    let address = ParamAddress::new(2, 372).unwrap();
    assert_eq!(address.word(), 0x2174); // CM-485 manual 6.4.1
    assert_eq!((address.set(), address.number()), (2, 372));
    assert_eq!(ParamAddress::new(9, ParamAddress::LAST_NUMBER).unwrap().word(), 0x963F);
    assert_eq!(ParamAddress::new(0, 0x1000), None);
}

#[test]
fn what_is_as_long_as_it_may_be_is_read_and_no_more() {
    use crate::protocol::modbus::{FrameError, ascii, mbap, rtu};
    assert!(ParamAddress::new(15, ParamAddress::MAX_NUMBER).is_some() && ParamAddress::new(16, 0).is_none());
    for (len, fits) in [(1, true), (MAX_PDU, true), (MAX_PDU + 1, false)] {
        let pdu = [&[0x55], &vec![7; len - 1][..]].concat();
        assert_eq!(Request::decode(&pdu).is_ok(), fits, "{len}");
        assert_eq!(
            Reply::decode(&pdu),
            if fits {
                Ok(Reply::Other { function: 0x55, data: pdu[1..].to_vec() })
            } else {
                Err(PduError::TooLong { len })
            }
        );
        let decoded = [
            rtu::decode(&rtu::encode(1, &pdu)),
            ascii::decode(&ascii::encode(1, &pdu)),
            mbap::decode(&mbap::encode(9, 1, &pdu)).map(|(_, adu)| adu),
        ];
        for adu in decoded {
            match adu {
                Ok(adu) => assert!(fits && adu.pdu == pdu),
                Err(error) => assert!(!fits && matches!(error, FrameError::TooLong { .. }), "{len}: {error}"),
            }
        }
    }
}

#[test]
fn codes_that_are_in_no_norm_come_back_as_they_came() {
    assert_eq!(Exception::from_code(7).code(), 7);
    assert_eq!(Reply::decode(&[0x83, 2, 2]), Err(PduError::Length { function: 0x83, len: 2, expected: 1 }));
    assert_eq!(Reply::decode(&[4, 2, 0, 7]), Ok(Reply::Inputs(vec![7])));
    assert_eq!(Reply::decode(&[43, 13, 0]), Ok(Reply::Other { function: 43, data: vec![13, 0] }));
    let of = |function| Request::Other { function, data: vec![1] };
    let answer = Reply::Other { function: 0x55, data: vec![2] };
    assert!(of(0x55).is_answered_by(&answer) && !of(0x56).is_answered_by(&answer));
}

#[test]
fn a_long_that_was_written_is_echoed_with_its_address() {
    let write = Request::WriteLong { address: 210, value: 0x1_0002 };
    for (address, value, is_answer) in [(210, 0x1_0002, true), (211, 0x1_0002, false), (210, 0x1_0003, false)] {
        assert_eq!(write.is_answered_by(&Reply::LongWritten { address, value }), is_answer, "{address} {value}");
    }
}

/// What is missing of words is told in bytes.
#[test]
fn a_telegram_of_words_says_how_long_it_should_be() {
    let refused = Request::decode(&[3, 0, 1, 0]);
    assert_eq!(refused, Err(PduError::Length { function: 3, len: 3, expected: 4 }));
}

/// What is missing of an identification is told in bytes.
#[test]
fn an_identification_that_is_cut_off_says_how_long_it_should_be() {
    let expected = |data: &[u8]| match Reply::decode(&[&[43], data].concat()) {
        Err(PduError::Length { expected, .. }) => expected,
        other => panic!("{other:?}"),
    };
    assert_eq!(expected(&[IDENTIFICATION, 1, 1, 0, 0]), 6);
    assert_eq!(expected(&[IDENTIFICATION, 1, 1, 0, 0, 1, 0]), 9);
    assert_eq!(expected(&[IDENTIFICATION, 1, 1, 0, 0, 1, 0, 3, b'a']), 11);
    assert_eq!(expected(&[IDENTIFICATION, 1, 1, 0, 0, 1, 0, 1, b'a', 9, 9]), 9);
}

#[test]
fn reply_length_is_known_from_the_request() {
    let read = Request::ReadRegisters { start: 0x2174, count: 1 };
    assert_eq!(read.reply_end().length(&[3]), None);
    assert_eq!(read.reply_end().length(&[3, 2]), Some(4));
    assert_eq!(read.reply_end().length(&[0x83]), Some(2));
    assert_eq!(Request::ReadLong { address: 1 }.reply_end().length(&[100]), Some(5));
}

#[test]
fn an_echo_with_another_value_is_no_answer() {
    let write = Request::WriteRegister { address: 0x4178, value: 15 };
    assert!(write.is_answered_by(&Reply::RegisterWritten { address: 0x4178, value: 15 }));
    assert!(!write.is_answered_by(&Reply::RegisterWritten { address: 0x4178, value: 16 }));
    assert!(!write.is_answered_by(&Reply::Registers(vec![15])));
    assert!(write.is_answered_by(&Reply::Exception { function: 6, code: Exception::DeviceFailure }));
}

/// Telegrams of the LXM05 manual, chapters 5.2 and 5.3, with the lengths as corrected in sources G4. The manual prints
/// fields, not bytes; these are its fields in order.
fn lexium() -> Vec<(Request, &'static str, Reply, &'static str)> {
    let object = |id, text: &str| Object { id, value: text.into() };
    let objects = vec![object(0, "abc"), object(1, ""), object(3, "V02.001")];
    let told = Identification { category: BASIC, conformity: 2, next: None, objects };
    vec![
        (
            // 5.2.1: _p_act
            Request::ReadRegisters { start: 7_700, count: 2 },
            "03 1E 14 00 02",
            Reply::Registers(vec![0xFFFF, 0xFFFE]),
            "03 04 FF FF FF FE",
        ),
        (
            // 5.2.3: PPp_targetusr
            Request::WriteRegisters { start: 6_940, values: vec![0, 0x30] },
            "10 1B 1C 00 02 04 00 00 00 30",
            Reply::RegistersWritten { start: 6_940, count: 2 },
            "10 1B 1C 00 02",
        ),
        (
            // 5.2.4
            Request::ExchangeRegisters { start: 6_916, count: 2, write_start: 6_914, values: vec![0, 6] },
            "17 1B 04 00 02 1B 02 00 02 04 00 00 00 06",
            Reply::RegistersExchanged(vec![0, 0x21]),
            "17 04 00 00 00 21",
        ),
        (
            // 5.2.5
            Request::ReadIdentification { category: BASIC, object: 0 },
            "2B 0E 01 00",
            Reply::Identification(told),
            "2B 0E 01 02 00 00 03 00 03 61 62 63 01 00 03 07 56 30 32 2E 30 30 31",
        ),
        (
            // 5.3, example 1: a fault memory entry
            Request::ReadRegisters { start: 15_362, count: 8 },
            "03 3C 02 00 08",
            Reply::Registers(vec![0, 1, 0, 2, 0, 3, 0, 4]),
            "03 10 00 00 00 01 00 00 00 02 00 00 00 03 00 00 00 04",
        ),
        (
            // 5.3, example 2: the software limit switches
            Request::WriteRegisters { start: 1_544, values: vec![0, 1, 0xFFFF, 0xFFFF] },
            "10 06 08 00 04 08 00 00 00 01 FF FF FF FF",
            Reply::RegistersWritten { start: 1_544, count: 4 },
            "10 06 08 00 04",
        ),
    ]
}

fn hex(text: &str) -> Vec<u8> {
    text.split(' ').map(|byte| u8::from_str_radix(byte, 16).unwrap()).collect()
}

#[test]
fn telegrams_of_the_lexium_manual_go_both_ways() {
    for (request, asked, reply, answered) in lexium() {
        assert_eq!((request.encode(), Request::decode(&hex(asked))), (hex(asked), Ok(request.clone())));
        assert_eq!((reply.encode(), Reply::decode(&hex(answered))), (hex(answered), Ok(reply.clone())));
        assert!(request.is_answered_by(&reply), "{asked}");
        let end = request.reply_end();
        let known = (0..=hex(answered).len()).find_map(|bytes| end.length(&hex(answered)[..bytes]));
        assert_eq!(known, Some(hex(answered).len()), "{asked}");
    }
}

#[test]
fn refusals_of_the_lexium_manual_carry_the_type_only_behind_code_43() {
    // LXM05 manual 6.2.
    for (function, request) in lexium().into_iter().map(|row| (row.0.function(), row.0)) {
        let refused = Reply::Exception { function, code: Exception::IllegalDataAddress };
        assert_eq!(request.reply_end().length(&refused.encode()), Some(2));
        assert!(request.is_answered_by(&refused));
    }
    let pdu = refused_identification(Exception::IllegalDataValue);
    assert_eq!(pdu, [0xAB, 14, 3]);
    let request = Request::ReadIdentification { category: BASIC, object: 0 };
    let lengths = [1, 2, 3].map(|bytes| request.reply_end().length(&pdu[..bytes]));
    assert_eq!(lengths, [None, Some(3), Some(3)]);
    // The norm leaves the type out.
    assert_eq!(request.reply_end().length(&[0xAB, 3]), Some(2));
    assert_eq!(Reply::decode(&pdu), Reply::decode(&[0xAB, 3]));
    assert!(Reply::decode(&[0x83, 14, 3]).is_err());
}

#[test]
fn a_request_whose_counts_contradict_each_other_is_none() {
    let function = WRITE_REGISTERS;
    let refused = |pdu: &str| Request::decode(&hex(pdu)).unwrap_err();
    assert_eq!(refused("10 06 08 00 02 04 00 00 00"), PduError::Length { function, len: 8, expected: 9 });
    assert_eq!(refused("10 06 08 00 02"), PduError::Length { function, len: 4, expected: 9 });
    assert_eq!(refused("10 06 08 00 02 02 00 00 00 01"), PduError::ByteCount { function, got: 2, count: 2 });
    assert!(matches!(refused("17 06 08 00 02 06 08 00 01 04 00 01"), PduError::ByteCount { got: 4, count: 1, .. }));
    assert!(matches!(refused("17 06 08 00 02 06 08"), PduError::Length { len: 6, expected: 9, .. }));
    assert_eq!(refused("2B 0E 01"), PduError::Length { function: ENCAPSULATED, len: 2, expected: 3 });
    // Another type is nobody's business here.
    assert!(matches!(Request::decode(&hex("2B 0D 01")), Ok(Request::Other { function: ENCAPSULATED, .. })));
}

#[test]
fn an_answer_to_another_question_is_none() {
    let write = Request::WriteRegisters { start: 1_544, values: vec![0, 1] };
    assert!(!write.is_answered_by(&Reply::RegistersWritten { start: 1_544, count: 1 }));
    assert!(!write.is_answered_by(&Reply::RegistersWritten { start: 1_546, count: 2 }));
    let echo = Request::Diagnostics { sub: ECHO, data: 0x1234 };
    assert!(echo.is_answered_by(&Reply::Diagnostics { sub: ECHO, data: 0x1234 }));
    assert!(!echo.is_answered_by(&Reply::Diagnostics { sub: ECHO, data: 0x1235 }));
    let told = |id| {
        let objects = vec![Object { id, value: Vec::new() }];
        Reply::Identification(Identification { category: SINGLE, conformity: 0x81, next: None, objects })
    };
    let one = Request::ReadIdentification { category: SINGLE, object: 3 };
    assert!(one.is_answered_by(&told(3)) && !one.is_answered_by(&told(2)));
}

#[test]
fn nobody_answers_a_request_for_silence() {
    let silence = Request::Diagnostics { sub: LISTEN_ONLY, data: 0 };
    assert_eq!((silence.reply_end(), silence.is_write()), (ReplyEnd::Never, true));
    let counter = Request::Diagnostics { sub: 0x0B, data: 0 };
    assert_eq!((counter.reply_end(), counter.is_write()), (ReplyEnd::Fixed(5), false));
}

fn registers(most: u16) -> impl Strategy<Value = Vec<u16>> {
    vec(any::<u16>(), 0..=usize::from(most))
}

fn told() -> impl Strategy<Value = Identification> {
    let object = (any::<u8>(), vec(any::<u8>(), 0..20)).prop_map(|(id, value)| Object { id, value });
    (any::<u8>(), any::<u8>(), any::<Option<u8>>(), vec(object, 0..9))
        .prop_map(|(category, conformity, next, objects)| Identification { category, conformity, next, objects })
}

proptest! {
    #[test]
    fn requests_round_trip(
        start: u16, count: u16, category: u8, object: u8,
        written in registers(MOST_WRITTEN), exchanged in registers(MOST_EXCHANGED),
    ) {
        for request in [
            Request::WriteRegisters { start, values: written.clone() },
            Request::ExchangeRegisters { start, count, write_start: !start, values: exchanged.clone() },
            Request::ReadIdentification { category, object },
        ] {
            let pdu = request.encode();
            prop_assert!(pdu.len() <= MAX_PDU);
            prop_assert_eq!(Request::decode(&pdu), Ok(request));
        }
    }

    /// The end of a reply is known with its bytes, and never sooner than it is right.
    #[test]
    fn replies_round_trip_and_their_end_is_never_guessed(start: u16, read in registers(MOST_READ), told in told()) {
        let count = read.len() as u16;
        let exchange = Request::ExchangeRegisters { start, count, write_start: start, values: Vec::new() };
        let write = Request::WriteRegisters { start, values: read.clone() };
        let identify = Request::ReadIdentification { category: told.category, object: 0 };
        for (request, reply) in [
            (exchange, Reply::RegistersExchanged(read.clone())),
            (write, Reply::RegistersWritten { start, count }),
            (identify, Reply::Identification(told.clone())),
        ] {
            let pdu = reply.encode();
            for bytes in 0..=pdu.len() {
                let length = request.reply_end().length(&pdu[..bytes]);
                prop_assert!(length == Some(pdu.len()) || (length.is_none() && bytes < pdu.len()));
            }
            prop_assert_eq!(Reply::decode(&pdu), Ok(reply));
        }
    }

    #[test]
    fn any_bytes_have_an_end_or_none(bytes in vec(any::<u8>(), 0..300), code in prop_oneof![Just(16u8), Just(23), Just(43), Just(0xAB)]) {
        let pdu = [vec![code, IDENTIFICATION], bytes].concat();
        let _ = (Request::decode(&pdu), Reply::decode(&pdu), ReplyEnd::Objects.length(&pdu));
    }
}
