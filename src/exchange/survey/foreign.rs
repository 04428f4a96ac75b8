//! Questions that somebody else asks: the sign of another master on the line.

use super::super::dialect::Question;
use crate::protocol::Protocol;
use crate::protocol::modbus::pdu::{Reply, Request};
use crate::protocol::modbus::{Framing, ascii};
use crate::protocol::vabus;
use crate::tick::Tick;
use std::collections::VecDeque;

/// How many questions stand among bytes that are no reply to us: what only a master sends, and not `ours`, which a line may
/// double. Question and reply of somebody else come as one piece where his pauses are short.
pub(super) fn questions(protocol: Protocol, bytes: &[u8], ours: &VecDeque<(Tick, Vec<u8>)>) -> u32 {
    let (mut rest, mut count) = (bytes, 0);
    while !rest.is_empty() {
        let ends = 1..=rest.len().min(LONGEST_QUESTION);
        let question =
            ends.filter_map(|end| rest.split_at_checked(end)).find(|(piece, _)| is_question(protocol, piece));
        match question {
            Some((piece, after)) => {
                count += u32::from(!ours.iter().any(|(_, sent)| sent == piece));
                rest = after;
            }
            None => rest = rest.get(1..).unwrap_or_default(),
        }
    }
    count
}

/// Longest question that is looked for, in bytes; one in ASCII takes 17.
pub(in crate::exchange) const LONGEST_QUESTION: usize = 32;

/// The question that ends where these bytes end, unless it is among `ours`, which an adapter gives back.
pub(in crate::exchange) fn last(protocol: Protocol, bytes: &[u8], ours: &[Vec<u8>]) -> Option<(u8, Question)> {
    let begins = (4..=bytes.len().min(LONGEST_QUESTION)).filter_map(|length| bytes.get(bytes.len() - length..));
    let others = begins.filter(|piece| has_form(protocol, piece) && !ours.iter().any(|sent| sent == piece));
    others.into_iter().find_map(|piece| question(protocol, piece))
}

/// Whether it looks like a question, before its check value is computed.
fn has_form(protocol: Protocol, bytes: &[u8]) -> bool {
    match protocol {
        Protocol::Modbus(Framing::Rtu) => {
            let pdu = bytes.get(1..bytes.len().saturating_sub(2)).unwrap_or_default();
            Request::decode(pdu).is_ok_and(|request| !matches!(request, Request::Other { .. }))
        }
        Protocol::Modbus(Framing::Ascii) => bytes.first() == Some(&ascii::START) && bytes.ends_with(ascii::END),
        Protocol::Modbus(Framing::Tcp) | Protocol::Vabus => true,
    }
}

/// The station that is asked, and what, if this is a telegram that can only come from a master.
fn question(protocol: Protocol, bytes: &[u8]) -> Option<(u8, Question)> {
    if !is_question(protocol, bytes) {
        return None;
    }
    match protocol {
        Protocol::Vabus => vabus::Request::decode(bytes).ok().map(|asked| (asked.address().id(), asked.into())),
        Protocol::Modbus(framing) => {
            let adu = framing.decode(bytes).ok()?;
            Some((adu.station, Request::decode(&adu.pdu).ok()?.into()))
        }
    }
}

/// Whether this is a telegram that asks or orders. A reply to an order looks like the order, and a survey orders nothing.
fn is_question(protocol: Protocol, bytes: &[u8]) -> bool {
    let framing = match protocol {
        Protocol::Vabus => return vabus::Request::decode(bytes).is_ok(),
        Protocol::Modbus(framing) => framing,
    };
    let Ok(adu) = framing.decode(bytes) else { return false };
    if is_zero_behind_telegram(framing, bytes) {
        return false;
    }
    match Request::decode(&adu.pdu) {
        Ok(Request::Other { .. } | Request::Diagnostics { .. } | Request::ReadIdentification { .. }) | Err(_) => false,
        Ok(request) if request.is_write() => true,
        Ok(_) => !Reply::decode(&adu.pdu).is_ok_and(|reply| !matches!(reply, Reply::Other { .. })),
    }
}

/// Whether this is a whole telegram and a zero of noise: the remainder of a CRC and itself is 0, so in RTU its check value is
/// right once more, and the reply to a read in one byte more has the form of a read.
fn is_zero_behind_telegram(framing: Framing, bytes: &[u8]) -> bool {
    let Some((0, telegram)) = bytes.split_last() else { return false };
    framing == Framing::Rtu && framing.decode(telegram).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::modbus::rtu;

    const RTU: Protocol = Protocol::Modbus(Framing::Rtu);

    fn telegram(station: u8, pdu: &[u8]) -> Vec<u8> {
        rtu::encode(station, pdu)
    }

    #[test]
    fn questions_are_found_among_replies_and_noise_but_not_our_own() {
        let (read, order) = (telegram(9, &[3, 1, 0x9B, 0, 1]), telegram(9, &[6, 1, 0x9A, 0, 15]));
        let (reply, refusal) = (telegram(9, &[3, 2, 0, 35]), telegram(9, &[0x83, 2]));
        let mixed = [&[0x55, 0][..], &read, &reply, &order, &refusal, &read].concat();
        let ours = |sent: &Vec<u8>| VecDeque::from([(Tick::ZERO, sent.clone())]);
        assert_eq!(questions(RTU, &mixed, &VecDeque::new()), 3);
        assert_eq!(questions(RTU, &mixed, &ours(&read)), 1);
        let zero_behind = [&reply[..], &[0]].concat();
        for alone in [reply, zero_behind, refusal, telegram(9, &[8, 0, 0, 1, 2]), vec![0x55; 200], Vec::new()] {
            assert_eq!(questions(RTU, &alone, &VecDeque::new()), 0, "{alone:?}");
        }
    }
}
