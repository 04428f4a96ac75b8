//! What is a master, what is noise.

use super::*;
use crate::protocol::line::Parity;
use crate::protocol::modbus::{ascii, rtu};
use crate::protocol::vabus;

const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);

/// What is heard in so many windows one after another of somebody who says these bursts, each so many milliseconds behind the
/// one before.
fn heard(windows: usize, says: &[(u64, Vec<u8>)]) -> Talk {
    let (mut talk, mut now) = (Talk::default(), Tick::ZERO);
    let mut said = says.iter().cycle();
    let mut next = said.next().map(|(gap, bytes)| (now + Span::from_millis(*gap), bytes));
    for _ in 0..windows {
        let mut window = Window::new(LINE, now, now + WINDOW);
        while let Step::Wait(until) = window.step(now) {
            assert!(until > now, "it goes on");
            match next.filter(|next| next.0 <= until) {
                Some((at, bytes)) => {
                    now = at.max(now);
                    window.feed(now, bytes);
                    next = said.next().map(|(gap, bytes)| (now + Span::from_millis(*gap), bytes));
                }
                None => now = until,
            }
        }
        window.adds_to(&mut talk, now);
        if talk.certain().is_some() {
            break;
        }
    }
    talk
}

fn noise(gap: u64, bytes: usize) -> Vec<(u64, Vec<u8>)> {
    vec![(gap, (0..bytes as u8).map(|byte| byte.wrapping_mul(37) ^ 0x5B).collect())]
}

/// Question and answer at a wrong setting, as long as here or as half of it.
fn poll(every: u64, bytes: usize) -> Vec<(u64, Vec<u8>)> {
    vec![(every - 30, vec![0x81; bytes]), (30, vec![0x42; bytes - 1])]
}

#[test]
fn a_few_stray_bytes_now_and_then_are_noise() {
    for (gap, bytes) in [(1_000, 6), (1_300, 2), (3_000, 5), (900, 6), (25_000, 20), (200, 1), (60, 1), (700, 2)] {
        assert_eq!(heard(21, &noise(gap, bytes)).verdict(), None, "{bytes} every {gap} ms");
    }
    assert!(heard(1, &noise(2_000, 5)).is_silent());
}

#[test]
fn who_polls_is_noticed_also_where_nobody_understands_him() {
    for every in [100, 200, 350, 500, 1_000] {
        for bytes in [4, 8] {
            let talk = heard(21, &poll(every, bytes));
            assert_eq!(talk.verdict(), Some(Talker::Somebody), "every {every} ms, {bytes}: {talk:?}");
            assert!(every > 350 || talk.listened < Span::from_millis(2_600), "at once: {}", talk.listened);
        }
    }
    assert_eq!(heard(21, &noise(50, 6)).verdict(), Some(Talker::Somebody), "who babbles cannot be told from a master");
    // In one piece, as an adapter brings it, or from a slower line.
    assert_eq!(heard(21, &noise(1_000, 15)).verdict(), Some(Talker::Somebody));
}

#[test]
fn a_telegram_tells_a_master_at_once() {
    let question = rtu::encode(7, &[3, 1, 0x9B, 0, 1]);
    let of_ascii = ascii::encode(7, &[3, 1, 0x9B, 0, 1]).into_iter().map(|byte| byte | (0x80 * (byte & 1))).collect();
    for asks in [question, of_ascii] {
        let talk = heard(3, &[(900, asks)]);
        assert_eq!((talk.certain(), talk.bursts), (Some(Talker::Master), 1));
    }
    let reply = rtu::encode(7, &[3, 2, 0, 0x40]);
    assert_eq!(heard(1, &[(900, reply.clone()), (9_000, vec![1])]).certain(), None, "the late reply of who has left");
    assert_eq!(heard(3, &[(900, reply)]).certain(), Some(Talker::Master));
    // Two at once are enough, and each question counts, whatever protocol it is in.
    let ascii = ascii::encode(7, &[3, 2, 0, 0x40]);
    assert_eq!(telegrams(&[&ascii[..], &ascii].concat()), (0, 2));
    let address = vabus::Address::drive(1).unwrap();
    let header = vabus::Header { number: vabus::ParamNumber::new(411).unwrap(), ..vabus::Header::default() };
    let enquiry = vabus::Request::Enquiry { address, header }.encode();
    assert_eq!(telegrams(&enquiry), (1, 0));
    assert_eq!(telegrams(&ascii::encode(7, &[3, 1, 0x9B, 0, 1])), (1, 0));
}

#[test]
fn who_is_never_silent_is_known_within_little_more_than_a_second() {
    let mut window = Window::new(LINE, Tick::ZERO, Tick::ZERO + WINDOW);
    let mut now = Tick::ZERO;
    while let Step::Wait(until) = window.step(now) {
        now = until.min(now + Span::from_millis(15));
        window.feed(now, &[0x55]);
    }
    assert!(window.is_occupied() && now < Tick::ZERO + Span::from_millis(1_100), "{now:?}");
}

#[test]
fn what_was_heard_says_who_speaks_from_so_much_on() {
    let talk = |bursts, telegrams, ms| Talk { bursts, telegrams, listened: Span::from_millis(ms), ..Talk::default() };
    // More than 30 bursts in 10 s are certain once it was listened to for 2 s; more than 15 are told at the end.
    let certain = [(7, 2_000), (6, 2_000), (7, 1_999)].map(|(bursts, ms)| talk(bursts, bursts, ms).certain());
    assert_eq!(certain, [Some(Talker::Somebody), None, None]);
    let told =
        [(16, 16), (15, 15), (16, 4), (16, 3)].map(|(bursts, telegrams)| talk(bursts, telegrams, 10_000).verdict());
    assert_eq!(
        told,
        [Some(Talker::Somebody), None, Some(Talker::Somebody), None],
        "a quarter of them are like telegrams"
    );
    let long = [2, 3].map(|long| Talk { long, bursts: long, ..talk(0, 0, 60_000) }.verdict());
    assert_eq!(long, [None, Some(Talker::Somebody)]);
    let replies = [1, 2].map(|replies| Talk { replies, ..talk(1, 1, 60_000) }.certain());
    assert_eq!(replies, [None, Some(Talker::Master)]);
    let mut talk = Talk::default();
    assert!(talk.is_silent());
    [3, 4, 11, 12].into_iter().for_each(|burst| talk.note(burst));
    assert_eq!((talk.bursts, talk.bytes, talk.telegrams, talk.long), (4, 30, 3, 1));
    assert!(!talk.is_silent());
}

/// A window into which a byte came again and again, each so long behind the one before.
fn dripped(every: Span, count: u64) -> (Window, Tick) {
    let mut window = Window::new(LINE, Tick::ZERO, Tick::ZERO + Span::from_secs(100));
    let mut at = Tick::ZERO;
    for _ in 0..count {
        at += every;
        window.feed(at, &[0x55]);
    }
    (window, at)
}

#[test]
fn a_pause_is_longer_than_an_adapter_and_two_characters() {
    let pause = Span::from_millis(20) + LINE.chars(2);
    let more = Span::from_micros(1);
    let (mut window, at) = dripped(pause, 1);
    assert_eq!(window.step(at), Step::Wait(at + pause));
    for (every, occupied) in [(pause, true), (pause + more, false), (pause + pause, false)] {
        let (mut window, at) = dripped(every, 60);
        let ended = window.step(at) == Step::Done(());
        assert_eq!((ended, window.is_occupied()), (occupied, occupied), "{every}");
    }
    // Without a pause for a second it is somebody else's, not before.
    for (late, occupied) in [(0, true), (1, false)] {
        let (mut window, at) = dripped(Span::from_millis(10), 101);
        let began = Tick::ZERO + Span::from_millis(10);
        assert_eq!(at, began + BABBLE);
        let ended = window.step(began + (BABBLE - Span::from_micros(late))) == Step::Done(());
        assert_eq!((ended, window.is_occupied()), (occupied, occupied), "{late}");
    }
}

#[test]
fn a_burst_ends_by_more_than_the_gap_and_is_recorded_with_what_came_in_it() {
    let bursts = |every, count| {
        let (mut window, at) = dripped(every, count);
        window.close();
        let records: Vec<usize> = window.take_records().into_iter().map(|record| record.bytes.len()).collect();
        let mut talk = Talk::default();
        window.adds_to(&mut talk, at);
        (records, talk.bursts, talk.bytes)
    };
    assert_eq!(bursts(GAP, 3), (vec![3], 1, 3));
    assert_eq!(bursts(GAP + Span::from_micros(1), 3), (vec![1; 3], 3, 3));
    let most = MOST_RECORDS as u64;
    assert_eq!(bursts(GAP + GAP, most + 9), (vec![1; MOST_RECORDS], most as u32 + 9, most as u32 + 9));
}
