//! Questions that somebody else asks: the sign of another master on the line.

use super::dialect::{Dialect, Question};

/// How many questions stand among bytes that are no reply to us: what only a master sends, and no telegram of ours, which a line may
/// double. Question and reply of somebody else come as one piece where his pauses are short.
pub(super) fn questions(dialect: Dialect, bytes: &[u8], is_ours: impl Fn(&[u8]) -> bool) -> u32 {
    let (mut rest, mut count) = (bytes, 0);
    while !rest.is_empty() {
        let ends = 1..=rest.len().min(LONGEST_QUESTION);
        let mut pieces = ends.filter_map(|end| rest.split_at_checked(end));
        match pieces.find(|(piece, _)| dialect.question(piece).is_some()) {
            Some((piece, after)) => {
                count += u32::from(!is_ours(piece));
                rest = after;
            }
            None => rest = rest.get(1..).unwrap_or_default(),
        }
    }
    count
}

/// Longest question that is looked for, in bytes; one in ASCII takes 17.
pub(super) const LONGEST_QUESTION: usize = 32;

/// The question that ends where these bytes end, unless it is one of ours, which an adapter gives back.
pub(super) fn last(dialect: Dialect, bytes: &[u8], is_ours: impl Fn(&[u8]) -> bool) -> Option<(u8, Question)> {
    let begins = (4..=bytes.len().min(LONGEST_QUESTION)).filter_map(|length| bytes.get(bytes.len() - length..));
    let others = begins.filter(|piece| dialect.has_form_of_question(piece) && !is_ours(piece));
    others.into_iter().find_map(|piece| dialect.question(piece))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::modbus::{Framing, rtu};

    fn telegram(station: u8, pdu: &[u8]) -> Vec<u8> {
        rtu::encode(station, pdu)
    }

    fn counted(bytes: &[u8], ours: &[u8]) -> u32 {
        questions(Dialect::new(Framing::Rtu.into()), bytes, |piece| piece == ours)
    }

    #[test]
    fn questions_are_found_among_replies_and_noise_but_not_our_own() {
        let (read, order) = (telegram(9, &[3, 1, 0x9B, 0, 1]), telegram(9, &[6, 1, 0x9A, 0, 15]));
        let (reply, refusal) = (telegram(9, &[3, 2, 0, 35]), telegram(9, &[0x83, 2]));
        let mixed = [&[0x55, 0][..], &read, &reply, &order, &refusal, &read].concat();
        assert_eq!(counted(&mixed, &[]), 3);
        assert_eq!(counted(&mixed, &read), 1);
        let zero_behind = [&reply[..], &[0]].concat();
        for alone in [reply, zero_behind, refusal, telegram(9, &[8, 0, 0, 1, 2]), vec![0x55; 200], Vec::new()] {
            assert_eq!(counted(&alone, &[]), 0, "{alone:?}");
        }
    }

    /// The check value of its first six bytes happens to stand in the value 9904619.
    #[test]
    fn the_beginning_of_a_reply_is_nobody_s_read_of_more_than_a_telegram_holds() {
        let reply = telegram(6, &[3, 4, 0x00, 0x97, 0x21, 0xEB]);
        assert_eq!(reply, [0x06, 0x03, 0x04, 0x00, 0x97, 0x21, 0xEB, 0x65, 0x00]);
        let dialect = Dialect::new(Framing::Rtu.into());
        assert!((1..=reply.len()).all(|end| last(dialect, &reply[..end], |_| false).is_none()));
        let read = telegram(6, &[3, 4, 0, 0, 125]);
        assert!(last(dialect, &read, |_| false).is_some());
    }
}
