//! Codecs of CAN, both ways, by the printed frames of the EM-RES-03 manual and of CiA 301.

use super::emergency::Emergency;
use super::nmt::{Command, Life, Order};
use super::pdo::{Kind, Pdo, Place};
use super::sdo::{AbortCode, Initiate, Multiplexer, Reply, Request, Segment};
use super::{
    Body, Frame, FrameError, Identifier, LAST_DRIVE, Payload, PdoNumber, SdoChannel, Service, Telegram, candump,
    duration, slcan,
};
use proptest::prelude::*;

#[test]
fn identifiers_are_those_of_the_manual() {
    let drives = |first: fn(u8) -> Service, base: u16| {
        for node in 1..=LAST_DRIVE {
            assert_eq!(first(node).identifier(), Some(base + u16::from(node)));
        }
    };
    // 5.11.1, 5.9.4, 5.8.3, 5.9.1.1.
    drives(|node| Service::TxPdo(PdoNumber::One, node), 384);
    drives(|node| Service::RxPdo(PdoNumber::One, node), 512);
    drives(|node| Service::TxPdo(PdoNumber::Two, node), 640);
    drives(|node| Service::RxPdo(PdoNumber::Two, node), 768);
    drives(|node| Service::TxPdo(PdoNumber::Three, node), 896);
    drives(|node| Service::RxPdo(PdoNumber::Three, node), 1024);
    drives(|node| Service::SdoRequest(SdoChannel::One, node), 1536);
    drives(|node| Service::SdoReply(SdoChannel::One, node), 1408);
    drives(|node| Service::SdoRequest(SdoChannel::Two, node), 1600);
    drives(|node| Service::SdoReply(SdoChannel::Two, node), 1472);
    drives(Service::Emergency, 128);
    drives(Service::BootUp, 1792);
    assert_eq!((Service::of(0), Service::of(128), Service::of(1)), (Service::Nmt, Service::Sync, Service::Free));
    assert_eq!(Service::Emergency(0).identifier(), None, "its identifier is that of SYNC");
}

#[test]
fn every_identifier_is_the_one_of_its_service() {
    for number in 0..=Identifier::MAX_STANDARD {
        let service = Service::of(number);
        assert!(service == Service::Free || service.identifier() == Some(number), "{number}: {service:?}");
    }
    let free: Vec<u16> = (0..=0x7FF).filter(|number| Service::of(*number) == Service::Free).collect();
    assert!(free.contains(&0x101) && free.contains(&0x680) && free.contains(&0x7FF) && free.len() == 127 + 127 + 256);
}

#[test]
fn orders_and_lives_are_those_of_the_manual() {
    let printed = [
        ([1, 0], Command::Start),
        ([128, 5], Command::PreOperational),
        ([2, 5], Command::Stop),
        ([129, 5], Command::ResetNode),
        ([130, 5], Command::ResetCommunication),
    ];
    for (bytes, command) in printed {
        let order = Order::decode(&bytes).unwrap();
        assert_eq!((order.command, order.encode()), (command, bytes));
    }
    assert_eq!(Life::decode(&[0]), Some(Life::BootUp));
    assert_eq!(Life::decode(&[0x85]), Some(Life::Operational), "the top bit toggles");
    assert_eq!((Order::decode(&[1]), Life::decode(&[])), (None, None));
}

#[test]
fn an_emergency_tells_the_fault_in_its_last_bytes() {
    let bytes = [0x00, 0x10, 0x80, 0, 0, 0, 0x01, 0x22];
    let told = Emergency::decode(&bytes).unwrap();
    assert_eq!((told, told.fault, told.encode()), (Emergency::of_a_drive(0x2201), 0x2201, bytes));
    assert_eq!(Emergency::decode(&[0; 8]), Some(Emergency::CLEARED));
    assert_eq!(Emergency::decode(&[0; 7]), None);
}

#[test]
fn sdo_is_as_the_manual_prints_it() {
    let of = Multiplexer { index: 372, sub: 2 };
    // 5.10.1: read, its reply, and an abort with its code in byte 4.
    assert_eq!(Request::Upload(of).encode(), [0x40, 0x74, 0x01, 2, 0, 0, 0, 0]);
    let value = [0x42, 0x74, 0x01, 2, 0x6E, 0x05, 0, 0];
    assert_eq!(Reply::decode(value), Reply::Upload(of, Initiate::untold(1390)));
    assert_eq!(Reply::Upload(of, Initiate::untold(1390)).encode(), value);
    let refused = Reply::decode([0x80, 0x74, 0x01, 2, 11, 0, 0, 0]);
    assert_eq!(refused, Reply::Abort(of, AbortCode(11)));
    assert_eq!((AbortCode(11).of_a_drive(), AbortCode(0x0602_0000).of_a_drive()), (Some(11), None));
    // Write: 22h as printed, 2Bh and 23h for strict servers; 60h.
    let write = |control| Request::decode([control, 0x74, 0x01, 2, 0x6E, 0x05, 0, 0]);
    assert_eq!(write(0x22), Request::Download(of, Initiate::untold(1390)));
    assert_eq!(write(0x2B), Request::Download(of, Initiate::word(1390)));
    assert_eq!(write(0x23), Request::Download(of, Initiate::long(1390)));
    assert_eq!(Request::Download(of, Initiate::word(1390)).encode()[0], 0x2B);
    assert_eq!(Request::Download(of, Initiate::long(1390)).encode()[0], 0x23);
    assert_eq!(Reply::decode([0x60, 0x74, 0x01, 2, 0, 0, 0, 0]), Reply::Downloaded(of));
}

#[test]
fn sdo_is_as_cia_301_has_it() {
    let of = Multiplexer { index: 0x1008, sub: 0 };
    let begun = [0x41, 0x08, 0x10, 0, 12, 0, 0, 0];
    assert_eq!(Reply::decode(begun), Reply::Upload(of, Initiate::Segmented { size: Some(12) }));
    assert_eq!(Request::decode([0x70, 0, 0, 0, 0, 0, 0, 0]), Request::UploadSegment { toggle: true });
    let piece = [0x00, b'A', b'n', b't', b'r', b'i', b'e', b'b'];
    let last = [0x1D, b'!', 0, 0, 0, 0, 0, 0];
    assert_eq!(Reply::decode(piece), Reply::UploadSegment(Segment::new(false, false, b"Antrieb").unwrap()));
    let Reply::UploadSegment(end) = Reply::decode(last) else { panic!("a segment") };
    assert_eq!((end.bytes(), end.is_last, end.toggle), (&b"!"[..], true, true));
    assert_eq!(Reply::decode([0x4F, 0, 0x10, 0, 7, 0, 0, 0]), {
        let bytes = [7, 0, 0, 0];
        Reply::Upload(Multiplexer { index: 0x1000, sub: 0 }, Initiate::Expedited { bytes, size: Some(1) })
    });
    assert_eq!(Request::decode([0xA0, 0, 0, 0, 0, 0, 0, 0]), Request::Other(0xA0), "a block transfer");
}

#[test]
fn a_pdo_has_its_places() {
    assert_eq!(Place::all().count(), 10);
    let place = |kind, number| Place::new(kind, number).unwrap();
    let (word4, long2) = (place(Kind::Word, 4), place(Kind::Long, 2));
    assert_eq!((word4.bytes(), long2.bytes(), place(Kind::Boolean, 2).bytes()), (6..8, 4..8, 2..4));
    assert!(word4.meets(long2) && !word4.meets(place(Kind::Word, 3)));
    let mut pdo = Pdo::default();
    pdo.set(long2, 0x1234_5678);
    assert_eq!((pdo.0, pdo.get(word4)), ([0, 0, 0, 0, 0x78, 0x56, 0x34, 0x12], 0x1234));
    assert!(Place::new(Kind::Long, 3).is_none() && Place::new(Kind::Word, 0).is_none());
}

#[test]
fn candump_is_read_in_both_of_its_forms() {
    let log = "(1436509052.249713) can0 585#427401026E050000";
    let entry = candump::Entry::read(log).unwrap();
    assert_eq!((entry.to_string(), entry.at_us), (log.to_owned(), Some(1_436_509_052_249_713)));
    let frame = Frame::data(0x585, &[0x42, 0x74, 1, 2, 0x6E, 5, 0, 0]).unwrap();
    for shown in ["  can0  585   [8]  42 74 01 02 6E 05 00 00   'Bt..n...'", "can0 585#42.74.01.02.6E.05.00.00 T"] {
        assert_eq!(candump::Entry::read(shown).unwrap().what, candump::What::Frame(frame), "{shown}");
    }
    let asked = candump::Entry::read(" (000.000010)  can0  705   [1]  remote request").unwrap();
    assert_eq!(asked.to_string(), "(0000000000.000010) can0 705#R1");
    let off = candump::Entry::read("(1.5) can0 20000040#0000000000000000").unwrap();
    assert!(matches!(off.what, candump::What::Trouble { class: 0x40, .. }));
    for wrong in ["(x) can0 1#", "can0 800#", "can0 123##100", "can0 123#0", "can0 123 [9] 00", "can0 123#+1", ""] {
        assert!(candump::Entry::read(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn slcan_is_read_and_written() {
    for word in [
        "t5858427401026E050000",
        "r7051",
        "T1FFFFFFF0",
        "S6",
        "sC01C",
        "O",
        "L",
        "C",
        "F",
        "F80",
        "V1013",
        "NA123",
        "N",
        "Z0",
        "Z1",
        "\u{7}",
    ] {
        assert_eq!(slcan::Word::read(word).unwrap().to_string(), word);
    }
    let stamped = slcan::Word::read("t0000EA5F").unwrap();
    assert!(matches!(stamped, slcan::Word::Frame { at_ms: Some(59_999), .. }));
    for wrong in [
        "t8000", "t1239", "t12310", "S9", "sC01", "sC01CC", "sC0+C", "O1", "x", "t1231+1", "Fzz", "NA1234", "Z2",
        "tüüü",
    ] {
        assert!(slcan::Word::read(wrong).is_err(), "{wrong}");
    }
    assert_eq!(slcan::cut("S6\rO\r\u{7}t1230\r\n").collect::<Vec<_>>(), ["S6", "O", "\u{7}", "t1230"]);
    assert!(slcan::is_text("S6\rt1230\rt12\r") && !slcan::is_text("S6\rhello\r") && !slcan::is_text(""));
}

#[test]
fn a_line_of_candump_is_known_by_its_form() {
    for (line, is_one) in [
        ("(1.5) can0 20000040#00", true),
        ("can0 123#11", true),
        ("can0 123 [1] 11", true),
        ("123#11", false),
        ("can0 123 [1 11", false),
        ("can0 123 1] 11", false),
        ("t12311", false),
        ("", false),
    ] {
        assert_eq!(candump::is_line(line), is_one, "{line}");
    }
}

#[test]
fn what_candump_shows_says_its_length_and_its_bytes() {
    let bytes = |line: &str| match candump::Entry::read(line)?.what {
        candump::What::Frame(frame) => Ok(frame.bytes().to_vec()),
        trouble => panic!("{trouble:?}"),
    };
    assert_eq!(bytes("123#11"), Ok(vec![0x11]));
    // Behind the bytes stands what they are in letters.
    assert_eq!(bytes("can0 123 [2] 11 22 '.\"'"), Ok(vec![0x11, 0x22]));
    assert_eq!(bytes("can0 123 [8] 1 2 3 4 5 6 7 8"), Err(FrameError::Length("[8]".to_owned())));
    assert_eq!(bytes("can0 123 [2] 11 2G"), Err(FrameError::Length("[2]".to_owned())));
    assert_eq!(bytes("can0 123 [12] 11"), Err(FrameError::Fd));
    for line in ["can0 123 [1 11", "can0 123 1] 11"] {
        assert!(matches!(bytes(line), Err(FrameError::Form(_))), "{line}");
    }
}

#[test]
fn a_time_has_seconds_and_at_most_six_decimals() {
    let at = |time: &str| candump::Entry::read(&format!("({time}) can0 123#11")).ok().and_then(|entry| entry.at_us);
    assert_eq!(["1", "1.5", "1.123456"].map(at), [Some(1_000_000), Some(1_500_000), Some(1_123_456)]);
    assert_eq!(["1.1234567", "+1.5", "1.+5", "a", "1.a"].map(at), [None; 5]);
}

#[test]
fn a_remote_frame_of_no_length_is_logged_without_one() {
    let line = "(0000000001.500000) can0 705#R";
    assert_eq!(candump::Entry::read(line).unwrap().to_string(), line);
}

#[test]
fn what_is_no_emergency_of_a_drive_is_told_apart() {
    assert!(Emergency::CLEARED.is_of_a_drive() && Emergency::of_a_drive(0x0700).is_of_a_drive());
    let drive = Emergency::of_a_drive(0x0700);
    for other in [
        Emergency { code: 0x8130, ..drive },
        Emergency { register: 1, ..drive },
        Emergency { between: [1, 0, 0], ..drive },
    ] {
        assert!(!other.is_of_a_drive(), "{other:?}");
    }
}

#[test]
fn a_state_that_nobody_knows_is_said_as_it_came() {
    assert_eq!(Life::decode(&[3]), Some(Life::Unknown(3)));
    assert_eq!(Life::Unknown(3).encode(), [3]);
}

/// CiA 301: the toggle is bit 4, the end of a transfer has the specifier 4.
#[test]
fn segments_toggle_and_a_transfer_is_ended_by_both() {
    for (bit, toggle) in [(0, false), (0x10, true)] {
        assert_eq!(Request::decode([0x60 | bit, 0, 0, 0, 0, 0, 0, 0]), Request::UploadSegment { toggle });
        assert_eq!(Reply::decode([0x20 | bit, 0, 0, 0, 0, 0, 0, 0]), Reply::SegmentDownloaded { toggle });
    }
    let ended = [0x80, 0x74, 0x01, 0x02, 0, 0, 4, 5];
    assert!(matches!(Request::decode(ended), Request::Abort(_, AbortCode(0x0504_0000))));
    assert!(matches!(Reply::decode(ended), Reply::Abort(_, AbortCode(0x0504_0000))));
}

/// Of both kinds the largest is one, and the next is none.
#[test]
fn identifiers_end_where_their_bits_do() {
    assert_eq!([0x7FF, 0x800].map(|number| Identifier::standard(number).is_some()), [true, false]);
    assert_eq!([0x1FFF_FFFF, 0x2000_0000].map(|number| Identifier::extended(number).is_some()), [true, false]);
    let telegram = |identifier: u16| Telegram::decode(&[&identifier.to_be_bytes()[..], &[0; 8]].concat()).is_some();
    assert_eq!([0x7FF, 0x800].map(telegram), [true, false]);
    assert_eq!([SdoChannel::One, SdoChannel::Two].map(SdoChannel::number), [1, 2]);
}

/// A frame of eight bytes is a telegram as it is, and one of fewer is cut short.
#[test]
fn a_frame_of_eight_bytes_is_not_cut_short() {
    for len in 0..=8 {
        let frame =
            Frame { identifier: Identifier::Standard(0x583), body: Body::Data(Payload::new(&vec![7; len]).unwrap()) };
        assert_eq!(
            (Telegram::cut_short(&frame).is_some(), Telegram::of(&frame).is_some()),
            (len < 8, len == 8),
            "{len}"
        );
    }
}

/// A frame of eight bytes has at most 135 bits with those that are stuffed, of 11 bits and with the three behind it (ISO 11898-1).
#[test]
fn a_frame_takes_its_bits() {
    assert_eq!([0, 1, 8].map(|bytes| duration(1_000_000, bytes).as_micros()), [55, 65, 135]);
    assert_eq!(duration(125_000, 8).as_micros(), 1_080);
}

/// A piece of a value from the client and what asks for the next one are told apart, and neither is what begins.
#[test]
fn pieces_of_a_value_are_known_by_their_specifier() {
    let segment = Segment::new(true, true, &[1, 2, 3]).unwrap();
    assert_eq!(Request::decode([0x19, 1, 2, 3, 0, 0, 0, 0]), Request::DownloadSegment(segment));
    assert_eq!(Request::decode([0x70, 0, 0, 0, 0, 0, 0, 0]), Request::UploadSegment { toggle: true });
    assert_eq!(Reply::decode([0x19, 1, 2, 3, 0, 0, 0, 0]), Reply::UploadSegment(segment));
}

#[test]
fn words_of_an_adapter_have_their_lengths() {
    let said = |word: &str| slcan::Word::read(word).is_ok();
    assert_eq!(["F", "F0", "F04", "F004"].map(said), [true, false, true, false]);
    assert_eq!(["V1013", "V10133", "NA123", "NA1234"].map(said), [true, false, true, false]);
    assert_eq!(["t+230", "t1230", "t1+2", "t"].map(said), [false, true, false, false]);
}

fn frames() -> impl Strategy<Value = Frame> {
    let identifier = prop_oneof![
        (0..=Identifier::MAX_STANDARD).prop_map(Identifier::Standard),
        (0..=Identifier::MAX_EXTENDED).prop_map(Identifier::Extended),
    ];
    let body = prop_oneof![
        prop::collection::vec(any::<u8>(), 0..=8).prop_map(|bytes| Body::Data(Payload::new(&bytes).unwrap())),
        (0_u8..=8).prop_map(Body::Remote),
    ];
    (identifier, body).prop_map(|(identifier, body)| Frame { identifier, body })
}

proptest! {
    #[test]
    fn frames_come_back_from_every_text(frame in frames(), at_us in 0..u64::MAX / 2, at_ms in prop::option::of(0_u16..60_000)) {
        let word = slcan::Word::Frame { frame, at_ms };
        prop_assert_eq!(slcan::Word::read(&word.to_string()).unwrap(), word);
        let what = candump::What::Frame(frame);
        let entry = candump::Entry { at_us: Some(at_us), interface: Some("vcan0".to_owned()), what };
        prop_assert_eq!(candump::Entry::read(&entry.to_string()).unwrap(), entry);
        prop_assert_eq!(candump::what(&frame.to_string().replace(' ', "")).unwrap(), what);
    }

    #[test]
    fn what_sdo_says_is_said_again_the_same(bytes in any::<[u8; 8]>()) {
        let again = Request::decode(Request::decode(bytes).encode());
        prop_assert_eq!(again, Request::decode(bytes));
        prop_assert_eq!(Reply::decode(Reply::decode(bytes).encode()), Reply::decode(bytes));
    }

    #[test]
    fn no_bytes_bring_a_codec_down(bytes in prop::collection::vec(any::<u8>(), 0..9), text in "\\PC{0,40}") {
        if let Some(told) = Emergency::decode(&bytes) {
            prop_assert_eq!(&told.encode()[..], &bytes[..]);
        }
        if let Some(order) = Order::decode(&bytes) {
            prop_assert_eq!(&order.encode()[..], &bytes[..]);
        }
        let _ = Life::decode(&bytes).map(Life::encode);
        let _ = (candump::Entry::read(&text), slcan::Word::read(&text), slcan::is_text(&text), candump::is_line(&text));
        let _ = slcan::Word::read(&format!("t{text}"));
        let _ = candump::Entry::read(&format!("(1.0) can0 123#{text}"));
    }
}
