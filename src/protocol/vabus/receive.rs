//! Telegrams out of a stream of bytes that may hold anything.

use super::telegram::Stop;
use super::{EOT, MAX_TELEGRAM, Reply, Request, Telegram, TelegramError};

/// What the bytes that have come so far are to a master who waits for a reply.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Arrival {
    /// No telegram is complete yet: wait for more.
    Pending,
    /// The reply.
    Reply {
        /// What it says.
        reply: Reply,
        /// Bytes before it that belong to nothing.
        noise: usize,
        /// Bytes of the buffer that are dealt with, noise and reply.
        len: usize,
    },
    /// A whole telegram, but no reply to this question: late, from another drive, or the master's own echo.
    Stray {
        /// What it is.
        telegram: Telegram,
        /// Bytes before it that belong to nothing.
        noise: usize,
        /// Bytes of the buffer that are dealt with. Drop them and ask again.
        len: usize,
    },
    /// A telegram was begun and is spoilt.
    Spoilt {
        /// What is wrong with it.
        error: TelegramError,
        /// Bytes of the buffer that are dealt with. Drop them and ask again.
        len: usize,
    },
}

/// What `buffer`, everything that has come since the question went out, is to the master who asked `request`.
///
/// Bytes that begin no telegram are skipped. A telegram that was begun is counted to its end, so nothing inside a spoilt
/// one is taken for another. An EOT alone is skipped too: it says nothing to a master. A telegram right behind an EOT
/// is a master's, so the echo of a SELECT is not taken for the reply to an ENQUIRY, which has the same form.
pub fn arrival(request: &Request, buffer: &[u8]) -> Arrival {
    let mut noise = 0;
    while let Some(rest) = buffer.get(noise..).filter(|rest| !rest.is_empty()) {
        match Telegram::parse(rest) {
            Err(Stop::Short) => return Arrival::Pending,
            Err(Stop::Bad { len: 1, .. }) | Ok((Telegram::End, _)) => noise += 1,
            Err(Stop::Bad { error, len }) => return Arrival::Spoilt { error, len: noise + len },
            Ok((Telegram::Reply(reply), len)) if request.is_answered_by(&reply) => {
                return Arrival::Reply { reply, noise, len: noise + len };
            }
            Ok((telegram, len)) => return Arrival::Stray { telegram, noise, len: noise + len },
        }
    }
    Arrival::Pending
}

/// What a listener heard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Heard {
    /// A whole telegram and its bytes.
    Telegram(Telegram, Vec<u8>),
    /// Bytes that are no telegram, and what is wrong with them if one was begun.
    Noise(Vec<u8>, Option<TelegramError>),
}

/// Cuts what is heard on the line, both sides, into telegrams; the same come out however the stream is split.
#[derive(Clone, Debug, Default)]
pub struct Receiver {
    open: Vec<u8>,
    noise: Vec<u8>,
}

impl Receiver {
    /// Takes bytes; returns what they complete.
    pub fn feed(&mut self, bytes: &[u8]) -> Vec<Heard> {
        self.open.extend(bytes);
        self.cut(false)
    }

    /// The line has gone silent: nothing that is open will be completed. Returns what is left.
    pub fn silence(&mut self) -> Vec<Heard> {
        let mut heard = self.cut(true);
        heard.extend(self.take_noise());
        heard
    }

    /// Bytes of the telegram that has begun.
    pub fn pending(&self) -> &[u8] {
        &self.open
    }

    fn cut(&mut self, over: bool) -> Vec<Heard> {
        let mut heard = Vec::new();
        while !self.open.is_empty() {
            if self.noise.len() >= MAX_TELEGRAM {
                heard.extend(self.take_noise());
            }
            match Telegram::parse(&self.open) {
                Ok((telegram, len)) => self.take(telegram, len, &mut heard),
                Err(Stop::Short) if !over => break,
                Err(Stop::Short) if self.open == [EOT] => self.take(Telegram::End, 1, &mut heard),
                Err(Stop::Short) | Err(Stop::Bad { len: 1, .. }) => self.noise.push(self.open.remove(0)),
                Err(Stop::Bad { error, len }) => {
                    heard.extend(self.take_noise());
                    heard.push(Heard::Noise(self.open.drain(..len).collect(), Some(error)));
                }
            }
        }
        heard
    }

    fn take(&mut self, telegram: Telegram, len: usize, heard: &mut Vec<Heard>) {
        heard.extend(self.take_noise());
        heard.push(Heard::Telegram(telegram, self.open.drain(..len).collect()));
    }

    fn take_noise(&mut self) -> Option<Heard> {
        (!self.noise.is_empty()).then(|| Heard::Noise(std::mem::take(&mut self.noise), None))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::vabus::{Address, Data, DataSet, Header, NAK, ParamNumber, SystemNode};

    /// A telegram alone is read as a whole: what follows it is told by its length.
    #[test]
    fn bytes_behind_a_telegram_are_told() {
        let longer = |bytes: Vec<u8>| [bytes, vec![0; 3]].concat();
        let extra = TelegramError::TooLong { extra: 3 };
        assert_eq!(Request::decode(&longer(enquiry().encode())), Err(extra));
        assert_eq!(Reply::decode(&longer(value().encode())), Err(extra));
    }

    /// Noise is handed on as soon as there is as much of it as the longest telegram has.
    #[test]
    fn noise_is_told_in_pieces_of_a_telegram() {
        let mut receiver = Receiver::default();
        let told = receiver.feed(&[0x80; 2 * MAX_TELEGRAM]);
        let lengths = told.iter().map(|heard| match heard {
            Heard::Noise(bytes, _) => bytes.len(),
            other => panic!("{other:?}"),
        });
        assert_eq!(lengths.collect::<Vec<_>>(), [MAX_TELEGRAM]);
    }

    fn header(set: u8, number: u16) -> Header {
        let (set, number) = (DataSet::new(set).unwrap(), ParamNumber::new(number).unwrap());
        Header { node: SystemNode::SELF, set, number }
    }

    fn one() -> Address {
        Address::drive(1).unwrap()
    }

    fn enquiry() -> Request {
        Request::Enquiry { address: one(), header: header(2, 372) }
    }

    fn select() -> Request {
        Request::Select { address: one(), header: header(2, 372), data: Data::word(1_390) }
    }

    fn value() -> Reply {
        Reply::Value { address: one(), header: header(2, 372), data: Data::word(1_390) }
    }

    #[test]
    fn a_reply_is_complete_with_its_last_byte_and_noise_before_it_is_told() {
        let bytes = [&[0x00, 0x41, 0xFF, 0x04][..], &value().encode()].concat();
        // The stray 41h may be the address of a reply, the EOT the begin of a master's telegram.
        let noisy = [&[0x00, 0x41, 0xFF][..], &value().encode()].concat();
        for end in 0..noisy.len() {
            assert_eq!(arrival(&enquiry(), &noisy[..end]), Arrival::Pending);
        }
        let (noise, len) = (3, noisy.len());
        assert_eq!(arrival(&enquiry(), &noisy), Arrival::Reply { reply: value(), noise, len });
        let Arrival::Stray { telegram: Telegram::Request(request), .. } = arrival(&enquiry(), &bytes) else {
            panic!("behind an EOT stands a master's telegram")
        };
        assert_eq!(request, select());
    }

    #[test]
    fn what_does_not_answer_the_question_is_a_stray() {
        let (ack, nak) = (Reply::Ack { address: one() }, Reply::Nak { address: one() });
        let other = Reply::Ack { address: Address::drive(2).unwrap() };
        let foreign = Reply::Value { address: one(), header: header(2, 373), data: Data::word(2) };
        for (request, reply, fits) in [
            (enquiry(), nak.clone(), true),
            (enquiry(), ack.clone(), false),
            (enquiry(), foreign, false),
            (select(), ack, true),
            (select(), nak, true),
            (select(), value(), false),
            (select(), other, false),
        ] {
            let got = arrival(&request, &reply.encode());
            assert_eq!(matches!(got, Arrival::Reply { .. }), fits, "{got:?}");
            assert_eq!(matches!(got, Arrival::Stray { .. }), !fits, "{got:?}");
        }
    }

    #[test]
    fn an_echo_is_skipped_before_the_reply() {
        let (request, ack) = (select(), Reply::Ack { address: one() });
        let bytes = [request.encode(), ack.encode()].concat();
        let Arrival::Stray { telegram, len, .. } = arrival(&request, &bytes) else { panic!("the echo") };
        assert_eq!(telegram, Telegram::Request(request.clone()));
        assert_eq!(arrival(&request, &bytes[len..]), Arrival::Reply { reply: ack, noise: 0, len: 2 });
    }

    #[test]
    fn nothing_inside_a_spoilt_telegram_is_taken_for_another() {
        let data = Data::word(0x0A50);
        let mut bytes = Reply::Value { address: one(), header: header(2, 372), data }.encode();
        let five = bytes.iter().rposition(|&byte| byte == b'5').unwrap();
        bytes[five] ^= 0x20;
        assert_eq!(bytes[five - 1..=five], [one().character(), NAK]);
        let len = bytes.len();
        assert_eq!(arrival(&enquiry(), &bytes), Arrival::Spoilt { error: TelegramError::Text(NAK), len });
    }

    #[test]
    fn a_listener_hears_both_sides() {
        let stream = [
            vec![0xFF],
            enquiry().encode(),
            value().encode(),
            vec![EOT],
            select().encode(),
            Reply::Nak { address: one() }.encode(),
            vec![EOT],
        ]
        .concat();
        let mut whole = Receiver::default();
        let mut heard = whole.feed(&stream);
        assert_eq!(whole.pending(), [EOT]);
        heard.extend(whole.silence());
        let telegrams: Vec<_> = heard
            .iter()
            .map(|heard| match heard {
                Heard::Telegram(telegram, bytes) => Ok((telegram.clone(), bytes.len())),
                Heard::Noise(bytes, _) => Err(bytes.clone()),
            })
            .collect();
        let expected = [
            Err(vec![0xFF]),
            Ok((Telegram::Request(enquiry()), 8)),
            Ok((Telegram::Reply(value()), 15)),
            Ok((Telegram::End, 1)),
            Ok((Telegram::Request(select()), 16)),
            Ok((Telegram::Reply(Reply::Nak { address: one() }), 2)),
            Ok((Telegram::End, 1)),
        ];
        assert_eq!(telegrams, expected);
        let mut split = Receiver::default();
        let mut pieces: Vec<_> = stream.iter().flat_map(|&byte| split.feed(&[byte])).collect();
        pieces.extend(split.silence());
        assert_eq!(pieces, heard);
    }

    #[test]
    fn silence_ends_what_was_begun() {
        let mut receiver = Receiver::default();
        let cut = &value().encode()[..9];
        assert!(receiver.feed(cut).is_empty());
        assert_eq!(receiver.silence(), [Heard::Noise(cut.to_vec(), None)]);
        assert_eq!(receiver.pending(), [0u8; 0]);
    }
}
