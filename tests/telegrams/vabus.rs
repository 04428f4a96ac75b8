//! Every VABus telegram of the store, both ways, and what the codec promises for any bytes.

use antrieb::protocol::vabus::{
    Address, Arrival, Data, DataSet, Header, Heard, MAX_TELEGRAM, ParamNumber, Receiver, Reply, Request, SystemNode,
    Telegram, arrival, bcc,
};
use proptest::prelude::*;

fn address(id: u8) -> Address {
    Address::drive(id).unwrap()
}

fn header(set: u8, number: u16) -> Header {
    let (set, number) = (DataSet::new(set).unwrap(), ParamNumber::new(number).unwrap());
    Header { node: SystemNode::SELF, set, number }
}

fn enquiry(id: u8, set: u8, number: u16) -> Telegram {
    Telegram::Request(Request::Enquiry { address: address(id), header: header(set, number) })
}

fn select(id: u8, set: u8, number: u16, data: Data) -> Telegram {
    Telegram::Request(Request::Select { address: address(id), header: header(set, number), data })
}

fn value(id: u8, set: u8, number: u16, data: Data) -> Telegram {
    Telegram::Reply(Reply::Value { address: address(id), header: header(set, number), data })
}

fn text(characters: &str) -> Data {
    Data::text(characters.as_bytes()).unwrap()
}

/// What is said, and its bytes: the telegrams that prove VABus (sources A4).
#[rustfmt::skip]
fn vectors() -> Vec<(Telegram, &'static str)> {
    vec![
        (enquiry(1, 2, 372), "04 41 30 32 33 37 32 05"),
        (value(1, 2, 372, Data::word(0x056E)), "41 02 30 32 33 37 32 30 34 30 35 36 45 03 45"),
        (select(3, 4, 376, Data::word(15)), "04 43 02 30 34 33 37 36 30 34 30 30 30 46 03 47"),
        (Telegram::Reply(Reply::Ack { address: address(3) }), "43 06"),
        (Telegram::Reply(Reply::Nak { address: address(3) }), "43 15"),
        (enquiry(1, 0, 481), "04 41 30 30 34 38 31 05"),
        (value(1, 0, 481, Data::long(1_000)), "41 02 30 30 34 38 31 30 38 30 30 30 30 30 33 45 38 03 48"),
        (select(1, 0, 480, Data::long(-12_000_i32 as u32)), "04 41 02 30 30 34 38 30 30 38 46 46 46 46 44 31 32 30 03 40"),
        (select(1, 0, 17, text("002100021100213")), "04 41 02 30 30 30 31 37 31 35 30 30 32 31 30 30 30 32 31 31 30 30 32 31 33 03 00"),
        (value(1, 0, 19, text("00002A5D00660028")), "41 02 30 30 30 31 39 31 36 30 30 30 30 32 41 35 44 30 30 36 36 30 30 32 38 03 34"),
    ]
}

fn bytes(hex: &str) -> Vec<u8> {
    hex.split(' ').map(|pair| u8::from_str_radix(pair, 16).unwrap()).collect()
}

fn encode(telegram: &Telegram) -> Vec<u8> {
    match telegram {
        Telegram::Request(request) => request.encode(),
        Telegram::Reply(reply) => reply.encode(),
        Telegram::End => vec![0x04],
    }
}

#[test]
fn every_vector_encodes_and_decodes_to_the_byte() {
    for (telegram, hex) in vectors() {
        let bytes = bytes(hex);
        assert_eq!(encode(&telegram), bytes, "{hex}");
        match telegram {
            Telegram::Request(request) => assert_eq!(Request::decode(&bytes), Ok(request)),
            Telegram::Reply(reply) => assert_eq!(Reply::decode(&bytes), Ok(reply)),
            Telegram::End => unreachable!(),
        }
    }
}

#[test]
fn the_vectors_in_one_stream() {
    let stream: Vec<u8> = vectors().iter().flat_map(|(_, hex)| bytes(hex)).collect();
    let heard = Receiver::default().feed(&stream);
    let telegrams: Vec<_> = heard
        .into_iter()
        .map(|heard| match heard {
            Heard::Telegram(telegram, _) => telegram,
            Heard::Noise(bytes, error) => panic!("{bytes:02X?} {error:?}"),
        })
        .collect();
    assert_eq!(telegrams, vectors().into_iter().map(|row| row.0).collect::<Vec<_>>());
}

#[test]
fn the_longest_telegram() {
    let longest = select(30, 9, 1599, text(&"~".repeat(99)));
    assert_eq!(encode(&longest).len(), MAX_TELEGRAM);
}

fn any_header() -> impl Strategy<Value = Header> {
    (0..=63_u8, 0..=9_u8, 0..=1599_u16)
        .prop_map(|(node, set, number)| Header { node: SystemNode::new(node).unwrap(), ..header(set, number) })
}

fn any_data() -> impl Strategy<Value = Data> {
    prop_oneof![
        any::<u16>().prop_map(Data::word),
        any::<u32>().prop_map(Data::long),
        proptest::collection::vec(0x20..=0x7F_u8, 1..=99).prop_map(|text| Data::text(&text).unwrap()),
    ]
}

fn any_exchange() -> impl Strategy<Value = (Request, Reply)> {
    (1..=30_u8, any_header(), any_data(), 0..4_u8).prop_map(|(id, header, data, kind)| {
        let address = address(id);
        let replied = Header { set: header.set.as_replied(), ..header };
        match kind {
            0 => (Request::Enquiry { address, header }, Reply::Value { address, header: replied, data }),
            1 => (Request::Enquiry { address, header }, Reply::Nak { address }),
            2 => (Request::Select { address, header, data }, Reply::Ack { address }),
            _ => (Request::Select { address, header, data }, Reply::Nak { address }),
        }
    })
}

proptest! {
    #[test]
    fn there_and_back((request, reply) in any_exchange()) {
        prop_assert_eq!(Request::decode(&request.encode()), Ok(request.clone()));
        prop_assert_eq!(Reply::decode(&reply.encode()), Ok(reply.clone()));
        let len = reply.encode().len();
        prop_assert_eq!(arrival(&request, &reply.encode()), Arrival::Reply { reply, noise: 0, len });
    }

    /// A flipped bit makes no other reply of a reply: it is spoilt, a stray or still open, never believed.
    #[test]
    fn a_flipped_bit_is_never_believed((request, reply) in any_exchange(), place: prop::sample::Index, bit in 0..8_u8) {
        let mut bytes = reply.encode();
        let place = place.index(bytes.len());
        bytes[place] ^= 1 << bit;
        for end in 0..=bytes.len() {
            let arrival = arrival(&request, &bytes[..end]);
            prop_assert!(!matches!(arrival, Arrival::Reply { .. }), "{:02X?}: {:?}", bytes, arrival);
        }
    }

    /// The check character finds every flipped bit behind the STX, and a drive obeys nothing that was flipped.
    #[test]
    fn a_flipped_select_is_none(id in 1..=30_u8, header in any_header(), data in any_data(), place: prop::sample::Index, bit in 0..8_u8) {
        let request = Request::Select { address: address(id), header, data };
        let mut bytes = request.encode();
        let place = 2 + place.index(bytes.len() - 2);
        bytes[place] ^= 1 << bit;
        prop_assert!(Request::decode(&bytes).is_err());
    }

    #[test]
    fn any_bytes_are_cut_alike_and_none_is_lost(stream in proptest::collection::vec(prop_oneof![
        Just(0x02_u8), Just(0x03), Just(0x04), Just(0x05), Just(0x06), Just(0x15), Just(b'A'), Just(b'0'), Just(b'1'), any::<u8>(),
    ], 0..200), cut: prop::sample::Index) {
        let listen = |pieces: &[&[u8]]| {
            let mut receiver = Receiver::default();
            let mut heard: Vec<_> = pieces.iter().flat_map(|piece| receiver.feed(piece)).collect();
            heard.extend(receiver.silence());
            heard
        };
        let heard = listen(&[&stream]);
        let (front, back) = stream.split_at(cut.index(stream.len() + 1));
        prop_assert_eq!(&listen(&[front, back]), &heard);
        let all: Vec<u8> = heard
            .into_iter()
            .flat_map(|heard| match heard {
                Heard::Telegram(_, bytes) | Heard::Noise(bytes, _) => bytes,
            })
            .collect();
        prop_assert_eq!(all, stream);
    }

    /// The check character may be anything, control codes too; the end is counted.
    #[test]
    fn check_characters_of_any_value(data in any_data(), number in 0..=1599_u16) {
        let reply = Reply::Value { address: address(1), header: header(0, number), data };
        let bytes = reply.encode();
        let (check, rest) = bytes.split_last().unwrap();
        prop_assert_eq!(bcc(&rest[2..rest.len() - 1]), *check);
        let asked = Request::Enquiry { address: address(1), header: header(0, number) };
        prop_assert_eq!(arrival(&asked, rest), Arrival::Pending);
    }
}
