//! The options that every verb takes.

use crate::profile::Lang;
use crate::protocol::line::Parity;
use crate::protocol::modbus::pdu::WordOrder;
use crate::render::Format;
use crate::text::{Text, Wrong, both};
use crate::tick::Span;
use crate::transport::{Port, Rs485Mode};
use clap::{ArgAction, Args, ValueEnum};
use std::path::PathBuf;

/// Options of every verb.
#[derive(Clone, Debug, Default, Args)]
pub struct Globals {
    /// Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`
    ///
    /// Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench. [env: ANTRIEB_PORT]
    /// tcp://HOST:PORT is a raw serial server, rfc2217://HOST:PORT one whose line is set from here, mbtcp://HOST:PORT a
    /// Modbus/TCP gateway; sim:FILE.toml is a bench of your own, tape:FILE a recording of --trace. Without a port the one
    /// USB serial adapter that is plugged in is taken. `scan` searches several at once: -p A -p B.
    #[arg(short, long, global = true, value_name = "PORT", help_heading = "Line")]
    pub port: Vec<Port>,

    /// Drives: `1`, `1,2,5-9`, or names of antrieb.toml
    ///
    /// 0 writes to everybody. Over VABus, 3.17 is node 17 of the system bus behind drive 3. Verbs that only read take address 1 if none is
    /// given.
    #[arg(short, long, global = true, value_name = "LIST", help_heading = "Line")]
    pub address: Option<String>,

    /// Speed in baud, or auto for `scan` [default: 19200]
    #[arg(short, long, global = true, value_name = "BAUD", help_heading = "Line", value_parser = parse_baud)]
    pub baud: Option<Auto<u32>>,

    /// even, odd, none, or auto for `scan` [default: even]
    #[arg(long, global = true, value_name = "PARITY", help_heading = "Line", value_parser = parse_parity)]
    pub parity: Option<Auto<Parity>>,

    /// Stop bits [default: 1; 2 without parity]
    #[arg(long, global = true, value_name = "BITS", help_heading = "Line", value_parser = clap::value_parser!(u8).range(1..=2))]
    pub stop_bits: Option<u8>,

    /// Data bits [default: 8 for RTU, 7 for ASCII]
    #[arg(long, global = true, value_name = "BITS", help_heading = "Line", value_parser = clap::value_parser!(u8).range(7..=8))]
    pub data_bits: Option<u8>,

    /// Who switches RS-485 to sending [default: auto]
    ///
    /// auto, kernel, rts or adapter switches the line between sending and listening;
    /// auto leaves it to the adapter unless the kernel does it already.
    #[arg(long, global = true, value_name = "WHO", help_heading = "Line")]
    pub rs485: Option<Rs485Mode>,

    /// Pause before a telegram, such as 1ms [default: 0]
    ///
    /// Waits so long between switching an RS-485 line to sending and the telegram.
    #[arg(long, global = true, value_name = "TIME", help_heading = "Line", value_parser = parse_span)]
    pub rs485_before: Option<Span>,

    /// Pause behind a telegram, such as 1ms [default: 0]
    ///
    /// Waits so long between the telegram and switching an RS-485 line to listening.
    #[arg(long, global = true, value_name = "TIME", help_heading = "Line", value_parser = parse_span)]
    pub rs485_after: Option<Span>,

    /// rtu, ascii, vabus, sdo, dp, auto [default: rtu]
    #[arg(long, global = true, value_name = "NAME", help_heading = "Line")]
    pub protocol: Option<String>,

    /// act, acu, lxm05, l200, sj200, x200 [default: auto]
    #[arg(long, global = true, value_name = "FAMILY", help_heading = "Line")]
    pub drive: Option<String>,

    /// First half of 32 bits: high, low [default: ask]
    ///
    /// Which half of a 32-bit value goes first, where values take two registers. Without it the drive is asked.
    #[arg(long, global = true, value_name = "ORDER", hide_possible_values = true, help_heading = "Line")]
    pub word_order: Option<FirstHalf>,

    /// Wait for a reply [default: 500ms; 3s behind a gateway]
    #[arg(long, global = true, value_name = "TIME", help_heading = "Line", value_parser = parse_span)]
    pub timeout: Option<Span>,

    /// Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]
    ///
    /// How often a question is repeated that got no valid reply.
    #[arg(long, global = true, value_name = "N", help_heading = "Line", value_parser = clap::value_parser!(u8).range(0..=20))]
    pub retries: Option<u8>,

    /// table, json (--json), ndjson, csv [default: table]
    #[arg(long, global = true, value_name = "FORMAT", help_heading = "Output")]
    pub format: Option<Format>,

    /// Same as --format json
    #[arg(long, global = true, conflicts_with = "format", help_heading = "Output")]
    pub json: bool,

    /// en, de [default: from LC_ALL, LC_MESSAGES, LANG]
    ///
    /// The language of names and texts.
    #[arg(long, global = true, value_name = "LANG", help_heading = "Output")]
    pub lang: Option<Lang>,

    /// Less on stderr
    #[arg(short, long, global = true, conflicts_with = "verbose", help_heading = "Output")]
    pub quiet: bool,

    /// Show settings and telegrams, on stderr
    ///
    /// The settings with where each comes from, and every telegram, decoded, with its time; and notes on what was found on the way.
    #[arg(short, long, global = true, action = ArgAction::Count, help_heading = "Output")]
    pub verbose: u8,

    /// Record the line to a new file
    ///
    /// `decode trace` and --port tape:FILE read it; --force replaces an old one.
    #[arg(long, global = true, value_name = "FILE", help_heading = "Output")]
    pub trace: Option<PathBuf>,

    /// Colour [default: auto]
    #[arg(long, global = true, value_name = "WHEN", help_heading = "Output")]
    pub color: Option<ColorChoice>,

    /// No progress bar
    #[arg(long, global = true, help_heading = "Output")]
    pub no_progress: bool,

    /// More catalogue files; later ones win (repeatable)
    #[arg(long, global = true, value_name = "FILE", help_heading = "Files")]
    pub catalogue: Vec<PathBuf>,

    /// Project file to read in place of ./antrieb.toml
    #[arg(long, global = true, value_name = "FILE", conflicts_with = "no_config", help_heading = "Files")]
    pub config: Option<PathBuf>,

    /// Read no project file and no user configuration
    #[arg(long, global = true, help_heading = "Files")]
    pub no_config: bool,

    /// Show the telegrams that would be sent; open nothing
    #[arg(long, global = true, help_heading = "Safety")]
    pub dry_run: bool,

    /// Replace the file of --trace if it exists
    ///
    /// And do what the verb does not do unasked.
    #[arg(long, global = true, help_heading = "Safety")]
    pub force: bool,

    /// Answer the safety question with yes
    ///
    /// Never taken from environment or files.
    #[arg(long, global = true, help_heading = "Safety")]
    pub yes: bool,
}

/// A setting of the line that may have to be found out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Auto<T> {
    /// Nobody knows it.
    Auto,
    /// This.
    Is(T),
}

impl<T> Auto<T> {
    /// What it is, if that is known.
    pub fn known(self) -> Option<T> {
        match self {
            Auto::Auto => None,
            Auto::Is(value) => Some(value),
        }
    }
}

/// Speeds that are believed.
const BAUD_RATES: std::ops::RangeInclusive<u32> = 300..=1_250_000;

/// Speeds that ports and drives have.
const USUAL: [u32; 21] = [
    300, 600, 1_200, 1_800, 2_400, 4_800, 9_600, 14_400, 19_200, 28_800, 38_400, 57_600, 76_800, 115_200, 128_000,
    230_400, 256_000, 460_800, 500_000, 921_600, 1_000_000,
];

/// A speed that is believed. One that no line could tell from a usual one (2 %) is a slip of the keyboard.
pub(super) fn usual_baud(baud: u32) -> Result<u32, Text> {
    let (first, last) = (BAUD_RATES.start(), BAUD_RATES.end());
    if !BAUD_RATES.contains(&baud) {
        return Err(both!("expected {first} to {last}, got {baud}", "erwartet: {first} bis {last}; angegeben: {baud}"));
    }
    match USUAL.iter().find(|usual| **usual != baud && usual.abs_diff(baud) * 50 <= **usual) {
        Some(usual) => Err(both!(
            "expected {first} to {last}, but nothing right beside a usual speed; got {baud} (perhaps {usual} is meant)",
            "erwartet: {first} bis {last}, aber nichts dicht neben einer üblichen Geschwindigkeit; angegeben: {baud} (gemeint ist vielleicht {usual})"
        )),
        None => Ok(baud),
    }
}

fn parse_baud(text: &str) -> Result<Auto<u32>, Wrong> {
    if text.eq_ignore_ascii_case(AUTO) {
        return Ok(Auto::Auto);
    }
    let (first, last) = (BAUD_RATES.start(), BAUD_RATES.end());
    let expected = |_| {
        both!(
            "expected {first} to {last}, or auto; got '{text}'",
            "erwartet: {first} bis {last}, oder auto; angegeben: '{text}'"
        )
    };
    let baud = text.parse().map_err(expected).and_then(usual_baud);
    baud.map(Auto::Is).map_err(Wrong)
}

fn parse_parity(text: &str) -> Result<Auto<Parity>, Wrong> {
    if text.eq_ignore_ascii_case(AUTO) {
        return Ok(Auto::Auto);
    }
    text.parse().map(Auto::Is).map_err(|_: Wrong| {
        Wrong(both!(
            "expected even, odd, none or auto, got '{text}'",
            "erwartet: even, odd, none oder auto; angegeben: '{text}'"
        ))
    })
}

/// What says that a setting is to be found out.
pub(super) const AUTO: &str = "auto";

/// Which half of a value in two registers goes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FirstHalf {
    /// The upper 16 bits.
    High,
    /// The lower 16 bits.
    Low,
}

impl From<FirstHalf> for WordOrder {
    fn from(first: FirstHalf) -> Self {
        match first {
            FirstHalf::High => WordOrder::HighFirst,
            FirstHalf::Low => WordOrder::LowFirst,
        }
    }
}

/// When to use colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ColorChoice {
    /// On a terminal, unless NO_COLOR is set or TERM is dumb.
    #[default]
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// Reads `500ms`, `2s`, `1.5 s`, `2m`.
pub fn parse_span(text: &str) -> Result<Span, Wrong> {
    text.parse()
}
