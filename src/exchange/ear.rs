//! What bytes are that come in: an echo of our own, the reply of somebody who was asked, a stray telegram, garbage; or
//! nothing yet, as long as a telegram may become of them.

use super::dialect::{Dialect, Question, Said};
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// What a piece of what came is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Piece {
    /// A telegram of ours that was given back.
    Echo,
    /// The reply of a station to what it was asked.
    Reply(u8, Said),
    /// A valid telegram that is no such reply: the station that it names, and what it says if it is a reply at all.
    Stray(u8, Option<Said>),
    /// No valid telegram.
    Garbage,
}

/// Bytes of which the end has not come yet.
#[derive(Debug, Default)]
pub(super) struct Ear {
    came: Vec<u8>,
    /// When the first of them came, and the last.
    began: Tick,
    last: Tick,
}

/// Longest reply to a question that asks for one value, in any protocol.
const LONGEST_REPLY: usize = 32;

impl Ear {
    /// Bytes came.
    pub(super) fn hears(&mut self, at: Tick, bytes: &[u8]) {
        if self.came.is_empty() {
            self.began = at;
        }
        self.last = at;
        self.came.extend_from_slice(bytes);
    }

    /// Keeps the last bytes only.
    pub(super) fn keep(&mut self, most: usize) {
        let surplus = self.came.len().saturating_sub(most);
        self.came.drain(..surplus);
    }

    /// What is open.
    pub(super) fn bytes(&self) -> &[u8] {
        &self.came
    }

    /// Everything that is open is over.
    pub(super) fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.came)
    }

    /// When what came last began.
    pub(super) fn began(&self) -> Tick {
        self.began
    }

    /// When the last byte came.
    pub(super) fn last(&self) -> Tick {
        self.last
    }

    /// The next piece that is certain already, with its bytes. A little noise before a reply, when the line turns around, is
    /// nobody's. `asked`: what a station was asked, if it was.
    pub(super) fn cut<'q>(
        &mut self,
        dialect: Dialect,
        ours: &mut Ours,
        asked: impl Fn(u8) -> Option<&'q Question>,
    ) -> Option<(Piece, Vec<u8>)> {
        if let Some((start, bytes)) = ours.come_back(&self.came) {
            self.came.drain(start..start + bytes.len());
            return Some((Piece::Echo, bytes));
        }
        let (start, end, station, said) = self.reply(dialect, asked)?;
        let before: Vec<u8> = self.came.drain(..start).collect();
        if before.len() >= dialect.shortest_reply() {
            return Some((kind(dialect, &before), before));
        }
        Some((Piece::Reply(station, said), self.came.drain(..end - start).collect()))
    }

    /// The first reply, of anybody who was asked: from where to where, whose, and what it says.
    fn reply<'q>(
        &self,
        dialect: Dialect,
        asked: impl Fn(u8) -> Option<&'q Question>,
    ) -> Option<(usize, usize, u8, Said)> {
        let (came, least) = (&self.came, dialect.shortest_reply());
        (0..came.len()).find_map(|start| {
            (start + least..=came.len().min(start + LONGEST_REPLY)).find_map(|end| {
                let (station, said) = dialect.sender(came.get(start..end)?)?;
                let question = asked(station)?;
                let said = said.filter(|said| question.is_answered_by(said))?;
                Some((start, end, station, said))
            })
        })
    }
}

/// What bytes are as a whole, behind which nothing follows.
pub(super) fn kind(dialect: Dialect, bytes: &[u8]) -> Piece {
    dialect.sender(bytes).map_or(Piece::Garbage, |(station, said)| Piece::Stray(station, said))
}

/// The pieces of bytes that hold no answer: each whole reply among them for itself.
pub(super) fn pieces(dialect: Dialect, bytes: &[u8]) -> Vec<(Piece, &[u8])> {
    let (mut rest, mut pieces) = (bytes, Vec::new());
    let piece = |bytes| (kind(dialect, bytes), bytes);
    while dialect.sender(rest).is_none() {
        let Some(reply) = dialect.reply_within(rest) else { break };
        let (before, from) = rest.split_at(reply.start.min(rest.len()));
        let (reply, behind) = from.split_at(reply.len().min(from.len()));
        pieces.extend([before, reply].into_iter().filter(|bytes| !bytes.is_empty()).map(piece));
        rest = behind;
    }
    pieces.extend(Some(rest).filter(|rest| !rest.is_empty()).map(piece));
    pieces
}

/// An adapter or a server of ports gives back what we send within this time (as long as a repeater takes, docs/measured.md).
const ECHO_WITHIN: Span = Span::from_millis(600);

/// Telegrams of ours that may still come back.
#[derive(Debug, Default)]
pub(super) struct Ours(VecDeque<Sent>);

#[derive(Debug)]
struct Sent {
    at: Tick,
    bytes: Vec<u8>,
    /// It has come back; a line may double it all the same.
    came_back: bool,
}

impl Ours {
    /// We sent this.
    pub(super) fn sends(&mut self, at: Tick, bytes: Vec<u8>) {
        self.0.retain(|sent| at.since(sent.at) <= ECHO_WITHIN);
        self.0.push_back(Sent { at, bytes, came_back: false });
    }

    /// Whether this is a telegram of ours, whether it has come back already or not.
    pub(super) fn hold(&self, bytes: &[u8]) -> bool {
        self.0.iter().any(|sent| sent.bytes == bytes)
    }

    /// The first of them that stands in what came, and where; it is not looked for again.
    fn come_back(&mut self, came: &[u8]) -> Option<(usize, Vec<u8>)> {
        self.0.iter_mut().filter(|sent| !sent.came_back).find_map(|sent| {
            let start = came.windows(sent.bytes.len().max(1)).position(|window| window == sent.bytes)?;
            sent.came_back = true;
            Some((start, sent.bytes.clone()))
        })
    }
}
#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::modbus::pdu::{Reply, Request};
    use crate::protocol::modbus::{Framing, rtu};

    fn rtu() -> Dialect {
        Dialect::new(Framing::Rtu.into())
    }

    fn question() -> Question {
        Request::ReadRegisters { start: 411, count: 1 }.into()
    }

    fn sent(station: u8) -> Vec<u8> {
        rtu().encode(station, &question())
    }

    fn reply(station: u8) -> Vec<u8> {
        rtu::encode(station, &Reply::Registers(vec![7]).encode())
    }

    fn at(ms: u64) -> Tick {
        Tick::ZERO + Span::from_millis(ms)
    }

    /// The pieces of bytes where stations 1 and 2 were asked, and what stays open.
    fn cut(bytes: &[u8]) -> (Vec<Piece>, usize) {
        let (mut ear, mut ours, question) = (Ear::default(), Ours::default(), question());
        (1..=2).for_each(|station| ours.sends(at(0), sent(station)));
        ear.hears(at(1), bytes);
        let asked = |station| (station <= 2).then_some(&question);
        let pieces = std::iter::from_fn(|| Some(ear.cut(rtu(), &mut ours, asked)?.0)).collect();
        (pieces, ear.bytes().len())
    }

    #[test]
    fn bytes_are_cut_into_echoes_replies_and_what_stands_before_them() {
        let said = Said::Modbus(Reply::Registers(vec![7]));
        let answer = |station| Piece::Reply(station, said.clone());
        assert_eq!(cut(&[sent(1), reply(1)].concat()), (vec![Piece::Echo, answer(1)], 0));
        assert_eq!(cut(&[reply(2), sent(2), sent(1)].concat()), (vec![Piece::Echo, Piece::Echo, answer(2)], 0));
        assert_eq!(cut(&[&[0x55][..], &reply(1)].concat()), (vec![answer(1)], 0), "a little noise is nobody's");
        assert_eq!(cut(&[&[0x55; 5][..], &reply(1)].concat()), (vec![Piece::Garbage, answer(1)], 0));
        let foreign = Piece::Stray(9, Some(said.clone()));
        assert_eq!(cut(&[reply(9), reply(1)].concat()), (vec![foreign, answer(1)], 0));
        assert_eq!(cut(&reply(1)[..4]), (vec![], 4), "the rest may still come");
        assert_eq!(cut(&[sent(1), sent(1)].concat()), (vec![Piece::Echo], 8), "it comes back once");
    }

    #[test]
    fn what_is_no_answer_is_told_reply_by_reply() {
        let kinds = |bytes: &[u8]| {
            let kind = |(piece, bytes): (Piece, &[u8])| (matches!(piece, Piece::Stray(..)), bytes.len());
            pieces(rtu(), bytes).into_iter().map(kind).collect::<Vec<_>>()
        };
        assert_eq!(kinds(&reply(3)), [(true, 7)]);
        assert_eq!(
            kinds(&[&[0x55][..], &reply(3), &reply(4), &[0x55, 1]].concat()),
            [(false, 1), (true, 7), (true, 7), (false, 2)]
        );
        assert!(kinds(&[]).is_empty());
    }

    /// A bus brings what another tool asks and is answered in one piece with ours.
    #[test]
    fn frames_of_sdo_that_come_at_once_are_told_one_by_one() {
        use crate::protocol::Protocol;
        use crate::protocol::can::{Frame, SdoChannel, Telegram};
        let sdo = Dialect::new(Protocol::Sdo(SdoChannel::Two));
        let asked = Telegram::request(SdoChannel::Two, 5, [0x40, 0x9B, 1, 0, 0, 0, 0, 0]).unwrap().encode();
        let short = Telegram::cut_short(&Frame::data(0x5C5, &[0x42, 0x9B, 1]).unwrap()).unwrap();
        let bytes = [asked, short, asked].concat();
        let told: Vec<_> =
            pieces(sdo, &bytes).into_iter().map(|(piece, bytes)| (piece, sdo.shortness(bytes))).collect();
        let stray = Piece::Stray(5, None);
        assert_eq!(told, [(stray.clone(), None), (stray.clone(), Some(3)), (stray, None)]);
        assert_eq!((sdo.shortness(&asked), sdo.shortness(&short[1..])), (None, None));
    }

    #[test]
    fn of_what_is_open_the_last_bytes_are_kept() {
        let mut ear = Ear::default();
        ear.hears(at(1), &[1, 2, 3]);
        ear.keep(3);
        assert_eq!(ear.bytes(), [1, 2, 3]);
        ear.keep(2);
        assert_eq!(ear.take(), [2, 3]);
    }

    #[test]
    fn a_telegram_of_ours_is_known_again_for_as_long_as_it_may_come_back() {
        let mut ours = Ours::default();
        ours.sends(at(0), sent(1));
        ours.sends(at(600), sent(2));
        assert!(ours.hold(&sent(1)) && ours.hold(&sent(2)) && !ours.hold(&sent(3)));
        assert!(ours.come_back(&sent(1)).is_some() && ours.come_back(&sent(1)).is_none());
        assert!(ours.hold(&sent(1)), "a line may double it");
        ours.sends(at(601), sent(3));
        assert!(!ours.hold(&sent(1)) && ours.hold(&sent(2)));
    }
}
