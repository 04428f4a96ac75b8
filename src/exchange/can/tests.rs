//! Adapters of every kind, by hand.

use super::words::Words;
use super::{Channel, Ear, Opening, Overheard, Unopened};
use crate::exchange::{Conversation, Step};
use crate::protocol::can::slcan::Word;
use crate::protocol::can::{SdoChannel, Telegram, telegram_frame};
use crate::tick::{Span, Tick};
use proptest::prelude::*;
use std::cell::RefCell;
use std::rc::Rc;

/// Opens behind an adapter that says this to that; how it ended, what it was told, and when.
fn opened(says: impl Fn(&str) -> Vec<u8>) -> (<Opening as Conversation>::End, Vec<String>, Span) {
    let (mut opening, mut now, mut told) = (Opening::new(6), Tick::ZERO, Vec::new());
    loop {
        match opening.step(now) {
            Step::Done(end) => return (end, told, now.since(Tick::ZERO)),
            Step::Wait(until) => {
                opening.feed(now, &says(""));
                now = until.max(now + Span::from_millis(1));
            }
            Step::Send(bytes) => {
                let word = String::from_utf8(bytes).unwrap().trim_end().to_owned();
                opening.feed(now, &says(&word));
                told.push(word);
            }
        }
    }
}

fn channel(sdo: SdoChannel) -> Channel {
    Channel::new(sdo, Rc::default())
}

/// What an adapter says is cut at its ends; what is too long for a word counts byte by byte, and what is damaged is kept to be told.
#[test]
fn words_end_where_the_adapter_ends_them() {
    let mut words = Words::default();
    assert_eq!(words.feed(b"V10\n13\r\n"), [Word::Version("1013".to_owned())]);
    assert_eq!((words.garbage(), words.damaged()), (0, Vec::new()));
    assert_eq!(words.feed(&[&[b'x'; 40][..], b"\r\x07"].concat()), [Word::Refused]);
    assert_eq!((words.garbage(), words.damaged()), (40, vec![vec![b'x'; 40]]), "nothing stood before the bell");
    words.feed(&[b'x'; 42]);
    assert_eq!(words.garbage(), 40 + 42);
    words.feed(b"\r");
    assert_eq!((words.garbage(), words.damaged()), (40 + 42, vec![vec![b'x'; 40]]));
    words.feed("x\r".repeat(1_024 + 1).as_bytes());
    assert_eq!(words.damaged().len(), 1_024);
}

/// Who says what an adapter says is one, whatever else came from it.
#[test]
fn noise_of_an_adapter_that_answers_does_not_end_it() {
    let says = |word: &str| if word == "V" { b"???\rV1013\r".to_vec() } else { b"\r".to_vec() };
    assert!(opened(says).0.is_ok());
    let says = |word: &str| match word {
        "V" => b"???\r".to_vec(),
        "F" => b"F00\r".to_vec(),
        _ => Vec::new(),
    };
    assert!(opened(says).0.is_ok_and(|opened| !opened.is_mute), "it tells its flags, and nothing else");
}

/// Behind a frame of the bus comes what the adapter says to a word.
#[test]
fn a_frame_that_comes_first_is_not_what_an_adapter_says() {
    let but = |refused: &'static str| {
        opened(move |word| match word {
            "" => Vec::new(),
            "F" => b"t1230\rF84\r".to_vec(),
            word if word == refused => b"t1230\r\x07".to_vec(),
            _ => b"t1230\r\r".to_vec(),
        })
    };
    assert_eq!((but("S6").0, but("O").0), (Err(Unopened::Rate), Err(Unopened::Refused)));
    assert!(but("L").0.unwrap().acknowledged);
}

/// A bus of 1 Mbit/s brings more than anybody reads: the first are kept, and how many were lost is told.
#[test]
fn what_is_heard_beyond_what_is_kept_is_counted_as_lost() {
    let overheard = Rc::new(RefCell::new(Overheard::default()));
    let mut ear = Ear::new(overheard.clone());
    for said in ["t1230\r".repeat(16_384 + 2), "x\r".repeat(16_384 + 2)] {
        for words in said.as_bytes().chunks(1_000) {
            ear.take(words);
        }
    }
    let heard = overheard.borrow();
    assert_eq!((heard.frames.len(), heard.lost, heard.damaged.len()), (16_384, 2, 16_384));
}

const WORDS: [&str; 8] = ["", "C", "V", "S6", "L", "F", "C", "O"];

#[test]
fn the_bus_is_listened_to_before_the_channel_is_opened() {
    let (end, told, took) = opened(|word| match word {
        "V" => b"V1013\r".to_vec(),
        "F" => b"F00\r".to_vec(),
        "C" => b"\x07".to_vec(),
        _ => b"\r".to_vec(),
    });
    let end = end.unwrap();
    assert_eq!((told, end.version.as_deref(), end.is_mute), (WORDS.map(str::to_owned).to_vec(), Some("1013"), false));
    assert!(took >= Span::from_millis(1_250) && took < Span::from_secs(3), "{took}");
}

#[test]
fn an_adapter_that_says_nothing_is_opened_and_known() {
    let (end, told, took) = opened(|_| Vec::new());
    assert!(end.unwrap().is_mute && told == WORDS && took < Span::from_secs(5), "{took}");
}

#[test]
fn what_is_refused_ends_it_and_what_only_listens_for_itself_does_not() {
    let but = |refused: &'static str| {
        opened(move |word| match word {
            "F" => b"F00\r".to_vec(),
            word if word == refused => b"\x07".to_vec(),
            _ => b"\r".to_vec(),
        })
    };
    assert_eq!(but("S6").0, Err(Unopened::Rate));
    assert_eq!(but("O").0, Err(Unopened::Refused));
    let (end, told, _) = but("L");
    assert!(end.unwrap().acknowledged);
    assert_eq!(told[4..], ["L", "O", "F"]);
}

#[test]
fn errors_without_a_frame_are_another_bit_rate() {
    let says = |frame: &'static [u8]| {
        move |word: &str| match word {
            "F" => b"F84\r".to_vec(),
            "L" => [b"\r", frame].concat(),
            _ => b"\r".to_vec(),
        }
    };
    assert_eq!(opened(says(b"")).0, Err(Unopened::Errors(0x84)));
    assert_eq!(opened(says(b"t0800\r")).0.unwrap().traffic.frames, 1);
}

#[test]
fn a_flood_and_what_is_no_adapter_end_it_in_time() {
    let (end, _, took) = opened(|_| vec![0x55; 2_000]);
    assert!(matches!(end, Err(Unopened::NoAdapter(bytes)) if bytes > 2_000) && took < Span::from_secs(5), "{took}");
}

#[test]
fn a_channel_passes_on_its_own_sdos_and_nothing_else() {
    let mut channel = channel(SdoChannel::Two);
    let asked = Telegram::request(SdoChannel::Two, 5, [0x40, 0x9B, 1, 0, 0, 0, 0, 0]).unwrap();
    assert_eq!(channel.put(&asked.encode()), b"t6458409B010000000000\r");
    assert!(channel.take(b"z\rt0800\rt585842").is_empty());
    assert!(channel.take(b"9B010033000000\rt5C5842").is_empty(), "the other channel");
    let reply = channel.take(b"9B010033000000\rT000005C50\r");
    assert_eq!(reply, [5, 0xC5, 0x42, 0x9B, 1, 0, 0x33, 0, 0, 0]);
    // An answer that is too short is passed on as one that is none (EM-RES-03 manual 5.10.1: always eight bytes).
    let short = channel.take(b"t5C54429B0100\rt5854429B0100\r");
    assert_eq!((short.len(), Telegram::decode(&short)), (Telegram::LEN, None));
    assert_eq!(telegram_frame(&short).unwrap().to_string(), "5C5#42 9B 01 00");
    // Nobody answers: the adapter is asked how the bus is, and tells.
    channel.put(&asked.encode());
    assert_eq!(channel.put(&asked.encode()), b"F\rt6458409B010000000000\r");
    assert_eq!((channel.take(b"FA4\rz\r").len(), channel.ails(), channel.refused()), (0, Some(0xA4), false));
    channel.take(b"\x07");
    assert!(channel.refused() && !channel.refused());
}

#[test]
fn who_listens_hears_what_is_damaged_but_for_what_he_came_into() {
    let overheard = Rc::new(RefCell::new(Overheard::default()));
    let mut ear = Ear::new(overheard.clone());
    // The rest of a word that began before the channel was opened.
    assert!(ear.take(b"00\r").is_empty() && overheard.borrow().damaged.is_empty());
    assert_eq!(ear.take(b"t18").len(), 0);
    assert_eq!(ear.take(b"XYZ\rt0800\r\xFF\x00\x07").len(), 3);
    let mut overheard = overheard.borrow_mut();
    assert_eq!(overheard.damaged.drain(..).collect::<Vec<_>>(), [b"t18XYZ".to_vec(), vec![0xFF, 0]]);
    assert_eq!(overheard.frames.len(), 1);
}

proptest! {
    #[test]
    fn no_bytes_bring_it_down(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let mut channel = channel(SdoChannel::One);
        prop_assert!(channel.take(&bytes).len().is_multiple_of(Telegram::LEN));
        let (_, _, took) = opened(|_| bytes.clone());
        prop_assert!(took < Span::from_secs(6));
    }
}
