//! Cuts what somebody hears who never asks into telegrams and what is none.

use super::dialect::{Cut, Dialect, STRAGGLE};
use super::dp::Telegrams;
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::tick::Span;

/// Cuts bytes into telegrams and what is none; every byte comes out once, in order. Nobody has asked, so no question says how a
/// reply ends; adapters deliver bytes in chunks, so silences tell little.
#[derive(Debug)]
pub struct Cutter {
    cut: Box<dyn Cut>,
    pause: Span,
}

impl Cutter {
    /// A cutter of what is spoken so on a line.
    pub fn new(protocol: Protocol, line: LineSetting) -> Self {
        let (cut, pause) = Dialect::new(protocol).cutter(line);
        Cutter { cut, pause }
    }

    /// A cutter of PROFIBUS-DP, whose telegrams tell how long they are.
    pub fn dp() -> Self {
        Cutter { cut: Box::new(Telegrams::default()), pause: STRAGGLE }
    }

    /// The pieces that are certain now that these bytes came.
    pub fn feed(&mut self, bytes: &[u8]) -> Vec<Vec<u8>> {
        self.cut.feed(bytes)
    }

    /// The pieces of everything that is open, as nothing followed for [`Cutter::pause`].
    pub fn silence(&mut self) -> Vec<Vec<u8>> {
        self.cut.silence()
    }

    /// A silence that leaves nothing open.
    pub fn pause(&self) -> Span {
        self.pause
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;
    use crate::protocol::modbus::{Framing, ascii, rtu};

    fn cutter(framing: Framing) -> Cutter {
        Cutter::new(framing.into(), LineSetting::rtu(19_200, Parity::Even))
    }

    fn reply_of(value: u8) -> Vec<u8> {
        rtu::encode(1, &[3, 2, value, 6])
    }

    #[test]
    fn telegrams_come_out_whole_and_noise_in_pieces_no_longer_than_a_telegram() {
        let mut cutter = cutter(Framing::Rtu);
        assert_eq!(cutter.pause(), Span::from_millis(50));
        let reply = reply_of(5);
        assert_eq!(cutter.feed(&[&[0x55][..], &reply, &reply[..3]].concat()), [] as [Vec<u8>; 0], "nothing is certain");
        assert_eq!(cutter.silence(), [vec![0x55], reply.clone(), reply[..3].to_vec()]);
        let question = rtu::encode(1, &[3, 1, 0x9B, 0, 1]);
        assert_eq!(cutter.feed(&[&reply[..], &question].concat()), [reply, question]);
        assert_eq!((cutter.silence(), cutter.feed(&[0x55; 510]).len()), (vec![], 0));
        assert_eq!(
            (cutter.feed(&[0x55]).len(), cutter.silence().len()),
            (1, 1),
            "256 of 511 are no telegram for certain"
        );
        // What has the form of a reply is none without its check value.
        let spoilt = [&reply_of(5)[..5], &[0, 0, 9]].concat();
        let pieces = [cutter.feed(&[&spoilt[..], &reply_of(5)].concat()), cutter.silence()].concat();
        assert_eq!(pieces, [spoilt, reply_of(5)]);
        let noise = vec![0x55; 700];
        let pieces = [cutter.feed(&noise), cutter.silence()].concat();
        assert_eq!(pieces.iter().map(Vec::len).collect::<Vec<_>>(), [256, 256, 188]);
    }

    #[test]
    fn telegrams_of_vabus_are_cut_as_they_come() {
        let mut cutter = Cutter::new(Protocol::Vabus, LineSetting::ascii(9_600, Parity::Even));
        let question = b"\x04A00411\x05";
        assert_eq!(cutter.feed(question), [question.to_vec()]);
    }

    #[test]
    fn a_line_of_ascii_is_cut_where_it_begins_and_where_it_ends() {
        let mut cutter = cutter(Framing::Ascii);
        assert_eq!(cutter.pause(), ascii::MAX_PAUSE);
        let longest = ascii::encode(1, &[3; 253]);
        assert_eq!(longest.len(), ascii::MAX_FRAME);
        assert_eq!(cutter.feed(&[b":01", &longest[..], b"x"].concat()), [b":01".to_vec(), longest]);
        assert_eq!(cutter.silence(), [b"x".to_vec()]);
        let pieces = [cutter.feed(&[b'A'; 1_100]), cutter.silence()].concat();
        assert_eq!(pieces.iter().map(Vec::len).collect::<Vec<_>>(), [514, 514, 72], "nothing is kept without end");
    }
}
