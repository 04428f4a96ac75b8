//! Cuts what is heard into telegrams and what is none.

use crate::exchange::dialect::Cut;
use crate::protocol::dp::Telegram;
use crate::protocol::dp::frame::{cut, length};

/// So many bytes that are no telegram are given up as such.
const MOST: usize = 512;

/// Takes the first telegram out of what was heard: what stands before it and is none, the telegram, its bytes. `None` as long as there is
/// none that is whole.
pub(super) fn first(heard: &mut Vec<u8>) -> Option<(Vec<u8>, Telegram, Vec<u8>)> {
    let mut at = 0;
    loop {
        let rest = heard.get(at..).filter(|rest| !rest.is_empty())?;
        let whole = match length(rest) {
            // What has begun is nothing else: a value may have the bytes of SC or of a token.
            Ok(Some(length)) if length > rest.len() => return None,
            Ok(None) => return None,
            length => length.ok().flatten().and_then(|length| rest.get(..length)),
        };
        let told = whole.and_then(|bytes| Some((Telegram::decode(bytes).ok()?, bytes.to_vec())));
        // These have no check: what stands before them tells that they are bytes of something else.
        let is_bare = |told: &(Telegram, _)| matches!(told.0, Telegram::Ack | Telegram::Token { .. });
        if let Some((telegram, bytes)) = told.filter(|told| at == 0 || !is_bare(told)) {
            let before = heard.drain(..at + bytes.len()).take(at).collect();
            return Some((before, telegram, bytes));
        }
        at += 1;
    }
}

/// Everything that is heard, for somebody who never asks.
#[derive(Debug, Default)]
pub(in crate::exchange) struct Telegrams {
    heard: Vec<u8>,
}

impl Cut for Telegrams {
    fn feed(&mut self, bytes: &[u8]) -> Vec<Vec<u8>> {
        self.heard.extend(bytes);
        let mut pieces = Vec::new();
        while let Some((before, _, bytes)) = first(&mut self.heard) {
            pieces.extend([before, bytes].into_iter().filter(|piece| !piece.is_empty()));
        }
        if self.heard.len() > MOST {
            pieces.push(std::mem::take(&mut self.heard));
        }
        pieces
    }

    fn silence(&mut self) -> Vec<Vec<u8>> {
        cut(&std::mem::take(&mut self.heard)).into_iter().map(<[u8]>::to_vec).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STATUS: [u8; 6] = [0x10, 0x08, 0x02, 0x49, 0x53, 0x16];

    #[test]
    fn every_byte_comes_out_once_and_in_order_however_it_came() {
        let line = [
            &STATUS[..],
            &[0xE5],
            &[0x68, 0x05, 0x05, 0x68, 0x88, 0x82, 0x6D, 0x3C, 0x3E, 0xF1, 0x16],
            &[0xDC, 0x03, 0x02],
        ];
        let bad = [&[0x55, 0xE5][..], &STATUS];
        let all = [line.concat(), bad.concat()].concat();
        let expected: Vec<Vec<u8>> = line.into_iter().chain(bad).map(<[u8]>::to_vec).collect();
        for step in 1..all.len() {
            let mut cut = Telegrams::default();
            let mut pieces: Vec<_> = all.chunks(step).flat_map(|chunk| cut.feed(chunk)).collect();
            pieces.extend(cut.silence());
            assert_eq!(pieces, expected, "{step}");
        }
    }

    /// Data may have the bytes of a telegram: they are none as long as that around them may still come.
    #[test]
    fn a_telegram_inside_another_is_none() {
        let inner = [&[0x88, 0x82, 0x6D, 0x3C, 0x3E][..], &STATUS].concat();
        let check = inner.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte));
        let length = inner.len() as u8;
        let whole = [&[0x68, length, length, 0x68][..], &inner, &[check, 0x16]].concat();
        for step in 1..=whole.len() {
            let mut cut = Telegrams::default();
            let pieces: Vec<_> = whole.chunks(step).flat_map(|chunk| cut.feed(chunk)).collect();
            assert_eq!(pieces, std::slice::from_ref(&whole), "{step}");
        }
    }

    #[test]
    fn noise_is_given_up() {
        let mut cut = Telegrams::default();
        assert_eq!(cut.feed(&[0x55; MOST]), Vec::<Vec<u8>>::new());
        assert_eq!(cut.feed(&[0x55; 1]), [vec![0x55; MOST + 1]]);
        assert_eq!(cut.feed(&STATUS), [STATUS.to_vec()]);
    }
}
