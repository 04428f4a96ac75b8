//! What is a master, what is noise.

use super::*;
use crate::protocol::line::Parity;
use crate::protocol::modbus::{ascii, rtu};

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
