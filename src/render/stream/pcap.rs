//! Telegrams as a capture for Wireshark: classic pcap, link type RTAC Serial (250), whose payload `rtacser.data` its Modbus RTU dissector
//! takes (`-d rtacser.data,mbrtu`). Proven with tshark in tests/peers/capture.py; docs/sniffing.md shows how.

use super::Form;
use crate::outcome::{Record, TelegramDoc};
use std::io::{self, Write};

pub(super) struct Pcap<'a> {
    out: Box<dyn Write + 'a>,
}

/// LINKTYPE_RTAC_SERIAL (tcpdump.org/linktypes.html).
const RTAC_SERIAL: u32 = 250;
/// Longest packet that may come.
const MOST: u32 = 65_535;
/// A telegram that the master began, and one that came to it (rtacser: DATA_TX_START, DATA_RX_START). Who is heard of whom nobody can
/// tell counts as the latter.
const FROM_MASTER: u8 = 1;
const TO_MASTER: u8 = 2;

impl<'a> Pcap<'a> {
    /// Begins a capture: whoever reads it live knows at once what it is.
    pub(super) fn new(mut out: Box<dyn Write + 'a>) -> io::Result<Self> {
        let mut head = Vec::new();
        // Magic number of microseconds, version 2.4, UTC, accuracy.
        head.extend(0xA1B2_C3D4u32.to_le_bytes());
        head.extend([2u16, 4].into_iter().flat_map(u16::to_le_bytes));
        head.extend([0u32, 0, MOST, RTAC_SERIAL].into_iter().flat_map(u32::to_le_bytes));
        out.write_all(&head)?;
        out.flush()?;
        Ok(Pcap { out })
    }

    fn telegram(&mut self, doc: &TelegramDoc) -> io::Result<()> {
        let bytes = bytes(&doc.hex);
        let at = doc.since_1970_us.or(doc.at_us).unwrap_or(0);
        let (seconds, micros) = ((at / 1_000_000) as u32, (at % 1_000_000) as u32);
        let event = if doc.direction == Some("request") { FROM_MASTER } else { TO_MASTER };
        // The header of the link: time, event, no state of control lines, reserved.
        let mut packet = Vec::with_capacity(bytes.len() + 12);
        packet.extend([seconds, micros].into_iter().flat_map(u32::to_be_bytes));
        packet.extend([event, 0, 0, 0]);
        packet.extend(bytes);
        let length = packet.len() as u32;
        let mut whole: Vec<u8> = [seconds, micros, length, length].into_iter().flat_map(u32::to_le_bytes).collect();
        whole.extend(packet);
        // At once: a file holds whole packets only.
        self.out.write_all(&whole)?;
        self.out.flush()
    }
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

    #[test]
    fn a_capture_has_the_head_and_the_packets_that_its_format_wants() {
        let mut out = Vec::new();
        let mut pcap = Pcap::new(Box::new(&mut out)).unwrap();
        let doc = TelegramDoc::blank("rtu", "01 83 02 C0 F1".to_owned(), true);
        let doc = TelegramDoc { at_us: Some(2_000_003), direction: Some("reply"), ..doc };
        pcap.record(&Record::Telegram(doc)).unwrap();
        drop(pcap);
        assert_eq!(out[..8], [0xD4, 0xC3, 0xB2, 0xA1, 2, 0, 4, 0]);
        assert_eq!(out[16..24], [0xFF, 0xFF, 0, 0, 250, 0, 0, 0]);
        assert_eq!(out[24..40], [2, 0, 0, 0, 3, 0, 0, 0, 17, 0, 0, 0, 17, 0, 0, 0]);
        assert_eq!(out[40..], [0, 0, 0, 2, 0, 0, 0, 3, 2, 0, 0, 0, 1, 0x83, 2, 0xC0, 0xF1]);
    }
}
