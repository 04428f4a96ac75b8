//! Telegrams as a capture for Wireshark: classic pcap, link type RTAC Serial (250), whose payload `rtacser.data` its Modbus RTU dissector
//! takes (`-d rtacser.data,mbrtu`); frames of CAN with the link type of SocketCAN (227). Proven with tshark in tests/peers/capture.py;
//! docs/sniffing.md shows how.

use super::Form;
use crate::outcome::{Record, TelegramDoc};
use std::io::{self, Write};

pub(super) struct Pcap<'a> {
    out: Box<dyn Write + 'a>,
    is_can: bool,
}

/// LINKTYPE_RTAC_SERIAL and LINKTYPE_CAN_SOCKETCAN (tcpdump.org/linktypes.html).
const RTAC_SERIAL: u32 = 250;
const CAN_SOCKETCAN: u32 = 227;
/// What a SocketCAN identifier says besides: 29 bits, and a request for a frame.
const EXTENDED: u32 = 1 << 31;
const REMOTE: u32 = 1 << 30;
/// Digits of an identifier of 29 bits.
const LONG: usize = 8;
/// Longest packet that may come.
const MOST: u32 = 65_535;
/// A telegram that the master began, and one that came to it (rtacser: DATA_TX_START, DATA_RX_START). Who is heard of whom nobody can
/// tell counts as the latter.
const FROM_MASTER: u8 = 1;
const TO_MASTER: u8 = 2;

impl<'a> Pcap<'a> {
    /// Begins a capture: whoever reads it live knows at once what it is.
    pub(super) fn new(mut out: Box<dyn Write + 'a>, is_can: bool) -> io::Result<Self> {
        let link = if is_can { CAN_SOCKETCAN } else { RTAC_SERIAL };
        let mut head = Vec::new();
        // Magic number of microseconds, version 2.4, UTC, accuracy.
        head.extend(0xA1B2_C3D4u32.to_le_bytes());
        head.extend([2u16, 4].into_iter().flat_map(u16::to_le_bytes));
        head.extend([0u32, 0, MOST, link].into_iter().flat_map(u32::to_le_bytes));
        out.write_all(&head)?;
        out.flush()?;
        Ok(Pcap { out, is_can })
    }

    fn telegram(&mut self, doc: &TelegramDoc) -> io::Result<()> {
        let at = doc.since_1970_us.or(doc.at_us).unwrap_or(0);
        let (seconds, micros) = ((at / 1_000_000) as u32, (at % 1_000_000) as u32);
        let packet = if self.is_can { frame(doc) } else { Some(serial(doc, [seconds, micros])) };
        let Some(packet) = packet else { return Ok(()) };
        let length = packet.len() as u32;
        let mut whole: Vec<u8> = [seconds, micros, length, length].into_iter().flat_map(u32::to_le_bytes).collect();
        whole.extend(packet);
        // At once: a file holds whole packets only.
        self.out.write_all(&whole)?;
        self.out.flush()
    }
}

/// The header of the link (time, event, no state of control lines, reserved), and the bytes.
fn serial(doc: &TelegramDoc, at: [u32; 2]) -> Vec<u8> {
    let bytes = bytes(&doc.hex);
    let event = if doc.direction == Some("request") { FROM_MASTER } else { TO_MASTER };
    let mut packet = Vec::with_capacity(bytes.len() + 12);
    packet.extend(at.into_iter().flat_map(u32::to_be_bytes));
    packet.extend([event, 0, 0, 0]);
    packet.extend(bytes);
    packet
}

/// Identifier with its flags, length, three bytes that are unused, and the data of a frame as it is told: `585#42 74`, `705#R1`. `None` for
/// what was never on the bus.
fn frame(doc: &TelegramDoc) -> Option<Vec<u8>> {
    let identifier = doc.can.as_ref()?.identifier?;
    let (digits, body) = doc.hex.split_once('#')?;
    let asked = body.strip_prefix('R');
    let data = if asked.is_some() { Vec::new() } else { bytes(body) };
    let length = asked.map_or(data.len() as u8, |length| length.parse().unwrap_or(0));
    let flag = |is_so: bool, flag: u32| if is_so { flag } else { 0 };
    let flagged = identifier | flag(digits.len() == LONG, EXTENDED) | flag(asked.is_some(), REMOTE);
    Some(flagged.to_be_bytes().into_iter().chain([length, 0, 0, 0]).chain(data).collect())
}

impl Form for Pcap<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Telegram(telegram) => self.telegram(telegram),
            _ => Ok(()),
        }
    }
}

/// The bytes of a telegram as it is told: `01 03 21 74`.
fn bytes(hex: &str) -> Vec<u8> {
    hex.split(' ').filter_map(|pair| u8::from_str_radix(pair, 16).ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::CanDoc;

    #[test]
    fn a_capture_has_the_head_and_the_packets_that_its_format_wants() {
        let mut out = Vec::new();
        let mut pcap = Pcap::new(Box::new(&mut out), false).unwrap();
        let doc = TelegramDoc::blank("rtu", "01 83 02 C0 F1".to_owned(), true);
        let doc = TelegramDoc { at_us: Some(2_000_003), direction: Some("reply"), ..doc };
        pcap.record(&Record::Telegram(doc)).unwrap();
        drop(pcap);
        assert_eq!(out[..8], [0xD4, 0xC3, 0xB2, 0xA1, 2, 0, 4, 0]);
        assert_eq!(out[16..24], [0xFF, 0xFF, 0, 0, 250, 0, 0, 0]);
        assert_eq!(out[24..40], [2, 0, 0, 0, 3, 0, 0, 0, 17, 0, 0, 0, 17, 0, 0, 0]);
        assert_eq!(out[40..], [0, 0, 0, 2, 0, 0, 0, 3, 2, 0, 0, 0, 1, 0x83, 2, 0xC0, 0xF1]);
    }

    #[test]
    fn frames_of_can_are_packets_of_socketcan() {
        let told = |hex: &str, identifier: Option<u32>| {
            let mut out = Vec::new();
            let mut pcap = Pcap::new(Box::new(&mut out), true).unwrap();
            let (interface, sent, channel, param, data_set, raw) = (None, None, None, None, None, None);
            let can = CanDoc { interface, sent, identifier, service: "free", channel, param, data_set, raw };
            let doc = TelegramDoc { can: Some(can), ..TelegramDoc::blank("can", hex.to_owned(), true) };
            pcap.record(&Record::Telegram(doc)).unwrap();
            drop(pcap);
            assert_eq!(out[20..24], [227, 0, 0, 0]);
            out.get(40..).unwrap_or_default().to_vec()
        };
        assert_eq!(told("585#42 74 01", Some(0x585)), [0, 0, 5, 0x85, 3, 0, 0, 0, 0x42, 0x74, 1]);
        assert_eq!(told("080#", Some(0x80)), [0, 0, 0, 0x80, 0, 0, 0, 0]);
        assert_eq!(told("00000123#01", Some(0x123)), [0x80, 0, 1, 0x23, 1, 0, 0, 0, 1]);
        assert_eq!(told("705#R1", Some(0x705)), [0x40, 0, 7, 5, 1, 0, 0, 0]);
        assert!(told("z", None).is_empty());
    }
}
