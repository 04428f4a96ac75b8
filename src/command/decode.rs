//! `decode`: what do these bytes, this word, this code say? Without a drive.

mod dp;

use super::verb::{Verb, Working};
use super::{Context, offline_family, output, telegram_reader};
use crate::args::{Settings, Takes};
use crate::drive::decode::dp::Cyclic;
use crate::drive::decode::{is_can, log};
use crate::drive::describe;
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::{Data, Decode, Document, Event, Outcome, TelegramDoc};
use crate::profile::Family;
use crate::text::{Text, both};
use clap::{Args as ClapArgs, Subcommand};
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Explains telegrams, words and codes. No drive is needed.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    what: What,
}

#[derive(Clone, Debug, Subcommand)]
enum What {
    /// A telegram of Modbus, VABus or PROFIBUS-DP
    ///
    /// Hex bytes, or an ASCII telegram from its colon on; several of PROFIBUS one behind the other.
    Telegram {
        /// 01 03 21 74 00 01 CE 2C, or :01032174000166
        ///
        /// Over VABus 04 41 30 32 33 37 32 05, over PROFIBUS 10 08 02 49 53 16.
        #[arg(required = true, value_name = "BYTES")]
        bytes: Vec<String>,
        /// What PROFIBUS carries: basic, ppo1 to ppo5, or hex
        ///
        /// No telegram of Data_Exchange tells what its bytes are; the configuration of the slave does. For an SJ2-PB it is one of
        /// these, or the bytes of Chk_Cfg, such as F3F1.
        #[arg(long, value_name = "CFG")]
        cfg: Option<Cyclic>,
    },
    /// Frames of CAN, as candump logs them or SLCAN has them
    ///
    /// 605#4074010200000000, also with blanks or points between the bytes, or t60584074010200000000. A recording is taken by
    /// `decode trace`. What an identifier is for is told by the predefined connection set; drives may have been given others.
    Can {
        /// 605#4074010200000000, or t60584074010200000000
        #[arg(required = true, value_name = "FRAME")]
        frames: Vec<String>,
    },
    /// A recording: of --trace, of candump, or of an SLCAN adapter
    Trace {
        /// The file
        file: PathBuf,
        /// What PROFIBUS carries: basic, ppo1 to ppo5, or hex
        ///
        /// As for `decode telegram`. A recording that says dp is one of PROFIBUS; --protocol dp takes one so that says nothing.
        #[arg(long, value_name = "CFG")]
        cfg: Option<Cyclic>,
        /// Write the CAN frames of it as a log of candump
        ///
        /// Written whole, or not at all; --force replaces an old one.
        #[arg(long, value_name = "FILE")]
        candump: Option<PathBuf>,
    },
    /// A status word (P.411), such as 0x0237
    Status {
        /// The word
        word: String,
    },
    /// A control word (P.410), such as 0x000F
    Control {
        /// The word
        word: String,
        /// Control mode (P.412)
        ///
        /// It decides what the bits mean: 0 contacts, 1 state machine, 2 remote contacts.
        #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u8).range(0..=44))]
        mode: u8,
    },
    /// A warning word (P.270), such as 0x008B
    Warnings {
        /// The word
        word: String,
    },
    /// A fault code (P.260, FLT_err_num), such as F0500
    ///
    /// Or EB303, 0x0500, 1280.
    Fault {
        /// The code
        #[arg(id = "fault_code", value_name = "CODE")]
        code: String,
    },
    /// A code of the error register (P.11), such as 11
    Error {
        /// The code
        code: String,
    },
    #[command(flatten)]
    Profibus(dp::What),
}

impl Verb for Args {
    const NAME: &'static str = "decode";
    const TAKES: Takes = Takes::EXPLAINS;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb decode telegram 01 03 21 74 00 01 CE 2C",
        "antrieb decode can 605#4074010200000000 585#427401026E050000",
        "antrieb decode trace line.txt",
        "antrieb decode status 0x0237",
        "antrieb decode control 0x000F",
        "antrieb decode warnings 0x008B",
        "antrieb decode fault F0500",
        "antrieb decode error 11",
        "antrieb decode telegram 10 08 02 49 53 16",
        "antrieb decode pkw 7393 0100 0000 0022",
        "antrieb decode diagnosis 02 05 00 FF 0A 35",
        "antrieb decode basic-status 0x0DD0",
        "antrieb decode basic-control 0x0050",
    ];
    const PROFIBUS: bool = true;
    const SDO: bool = true;
    type Prints = Document<Decode>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(std::future::ready(run(self, context)))
    }
}

/// Explains.
pub fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let mut family = offline_family(context.settings, context.registry)?;
    if let (What::Fault { code }, None) = (&args.what, &context.settings.drive) {
        // The letter of a displayed code tells whose it is, and where two have the letter, who knows the code.
        let shown = |family: &Rc<Family>| family.fault_codes.code(code);
        let all = || context.registry.families();
        let knows = |family: &Rc<Family>| shown(family).is_some_and(|code| family.fault(code).is_some());
        let told = all().find(knows).or_else(|| all().find(|family| shown(family).is_some()));
        family = told.unwrap_or(family);
    }
    let reader = telegram_reader(context.settings, &family);
    let decode = match &args.what {
        What::Telegram { bytes, cfg } => {
            let input = bytes.join(" ");
            if context.settings.is_can() {
                let cube = cube(context, &family);
                return checked(blank("can", &input), telegram_reader(context.settings, &cube).frames(&input));
            }
            let is_profibus = context.settings.profibus || cfg.is_some() || dp::is_spoken(&input);
            let docs = match is_profibus {
                true => dp::reader(&dp::inverter(context, &family), *cfg).typed(&input),
                false => reader.typed(&input),
            };
            return checked(blank("telegram", &input), docs.map_err(|error| error.text()));
        }
        What::Can { frames } => {
            let input = frames.join(" ");
            let cube = cube(context, &family);
            return checked(blank("can", &input), telegram_reader(context.settings, &cube).frames(&input));
        }
        What::Trace { file, cfg, candump } => {
            let shown = file.display().to_string();
            let wrong =
                |why: Text| Failure::new(Class::Data, "data.trace", both!("{shown}: {why}", "{shown}: {why}", why));
            let text = files::read(file, files::RECORDING).map_err(|error| wrong(error.text()))?;
            let telegrams = match dp::is_recorded(&text, context.settings.profibus || cfg.is_some()) {
                true => dp::reader(&dp::inverter(context, &family), *cfg).recording(&text),
                false if is_can(&text, context.settings.is_can()) => {
                    telegram_reader(context.settings, &cube(context, &family)).recording(&text)
                }
                false => reader.recording(&text),
            };
            let telegrams = telegrams.map_err(wrong)?;
            if let Some(path) = candump {
                let note = write_log(&text, path, context.settings)?;
                (context.observe)(Event::Note(note));
            }
            Decode { telegrams, ..blank("trace", &shown) }
        }
        What::Status { word } => word_of(&family, "status-word", "status", word, None)?,
        What::Control { word, mode } => word_of(&family, "control-word", "control", word, Some(*mode))?,
        What::Warnings { word } => word_of(&family, "warnings", "warnings", word, None)?,
        What::Fault { code } => {
            Decode { fault: describe::fault(&family, fault_number(code, &family)?), ..blank("fault", code) }
        }
        What::Error { code } => {
            let number = number(code).ok_or_else(|| bad_code(code, &both!("a code such as 11", "ein Code wie 11")))?;
            Decode { register: Some(describe::register(&family, number)), ..blank("error", code) }
        }
        What::Profibus(what) => dp::explain(what, &dp::inverter(context, &family))?,
    };
    if let Some(note) = base(&args.what, &family) {
        (context.observe)(Event::Note(note));
    }
    Ok(Outcome::of(Data::Decode(decode)))
}

/// What was typed, taken apart; one that is damaged is told, and is a failure.
fn checked(blank: Decode, docs: Result<Vec<TelegramDoc>, Text>) -> Result<Outcome, Failure> {
    let docs = docs.map_err(|why| Failure::new(Class::Usage, "usage.telegram", why))?;
    let broken = docs.iter().find(|doc| !doc.check_ok);
    let failure = broken.map(|doc| Failure::new(Class::Garbled, "garbled.telegram", doc.meaning.clone()));
    let data = Data::Decode(Decode { telegrams: docs, ..blank });
    Ok(Outcome { data: Some(data), warnings: Vec::new(), failure })
}

/// The family whose system bus is spoken of: the one that was named, else that of the module with the bus (EM-RES-03).
fn cube(context: &Context<'_>, family: &Rc<Family>) -> Rc<Family> {
    let cube = context.registry.family("acu").filter(|_| context.settings.drive.is_none());
    cube.unwrap_or_else(|| family.clone())
}

/// Writes the frames of a recording as candump logs them, and says how many.
fn write_log(text: &str, path: &Path, settings: &Settings) -> Result<Text, Failure> {
    let shown = path.display();
    let no_can = || {
        let message = both!("expected a recording of CAN", "erwartet: eine Aufzeichnung von CAN");
        Failure::new(Class::Data, "data.trace", message)
    };
    let written =
        log(text, settings.is_can()).ok_or_else(no_can)?.map_err(|why| Failure::new(Class::Data, "data.trace", why))?;
    output::write(path, &written.log, settings.force)?;
    let frames = Text::count(written.frames, ["frame", "frames"], ["Frame", "Frames"]);
    Ok(match written.left_out {
        0 => both!("{frames} written to {shown}", "{frames} nach {shown} geschrieben", frames),
        left_out => both!(
            "{frames} written to {shown}; {left_out} words of the adapter and damaged ones left out",
            "{frames} nach {shown} geschrieben; {left_out} Worte des Adapters und beschädigte weggelassen",
            frames
        ),
    })
}

/// Nothing decoded yet.
fn blank(kind: &'static str, input: &str) -> Decode {
    let input = input.to_owned();
    Decode { kind, input, telegrams: Vec::new(), word: None, fault: None, register: None, parts: None }
}

fn fault_number(code: &str, family: &Family) -> Result<u32, Failure> {
    let number = family.fault_codes.code(code).or_else(|| number(code));
    number.ok_or_else(|| {
        let (raw, shown) = if family.fault_codes.decimal { (7, "0x0007") } else { (1280, "0x0500") };
        let displayed = family.fault_codes.displayed(raw);
        let such =
            both!("a fault such as {displayed}, {shown} or {raw}", "eine Störung wie {displayed}, {shown} oder {raw}");
        bad_code(code, &such)
    })
}

/// In which base digits were read that may be meant in another one: keypads and manuals write words and faults without a prefix.
fn base(what: &What, family: &Family) -> Option<Text> {
    let (name, text, prefix) = match what {
        What::Status { word } => ("status", word, "0x"),
        What::Control { word, .. } => ("control", word, "0x"),
        What::Warnings { word } => ("warnings", word, "0x"),
        What::Fault { .. } if family.fault_codes.decimal => return None,
        What::Fault { code } => ("fault", code, &*family.fault_codes.letter),
        What::Telegram { .. } | What::Can { .. } | What::Trace { .. } | What::Error { .. } | What::Profibus(_) => {
            return None;
        }
    };
    let text = text.trim();
    let is_written_so = text.len() == DIGITS && text.bytes().all(|digit| digit.is_ascii_digit());
    let number = number(text).filter(|_| is_written_so)?;
    Some(both!(
        "{text} was read as the decimal number {number} = {number:04X}h; as it is displayed, in hexadecimal digits: \
         `antrieb decode {name} {prefix}{text}`",
        "{text} wurde als Dezimalzahl {number} = {number:04X}h gelesen; so, wie es angezeigt wird, in Hexadezimalziffern: \
         `antrieb decode {name} {prefix}{text}`"
    ))
}

/// Digits of a word of 16 bits.
const DIGITS: usize = 4;

fn word_of(family: &Family, role: &str, kind: &'static str, text: &str, mode: Option<u8>) -> Result<Decode, Failure> {
    let raw = number(text).ok_or_else(|| {
        bad_code(text, &both!("a 16-bit word such as 0x0237 or 567", "ein 16-Bit-Wort wie 0x0237 oder 567"))
    })?;
    let param = family.role(role).ok_or_else(|| {
        Failure::new(Class::Data, "data.role", both!("this family has no {role}", "diese Familie hat kein {role}"))
    })?;
    let word = describe::word(family, param, raw, &|_| mode.map(i64::from));
    Ok(Decode { word: Some(word), ..blank(kind, text) })
}

/// Reads `0x0237`, `0237h` or `567` as 16 bits.
fn number(text: &str) -> Option<u32> {
    let text = text.trim();
    let hex = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).or_else(|| text.strip_suffix(['h', 'H']));
    let number = match hex {
        Some(digits) if digits.bytes().all(|digit| digit.is_ascii_hexdigit()) => {
            u32::from_str_radix(digits, 16).ok()?
        }
        Some(_) => return None,
        None => text.parse().ok()?,
    };
    (number <= 0xFFFF).then_some(number)
}

fn bad_code(text: &str, expected: &Text) -> Failure {
    Failure::new(
        Class::Usage,
        "usage.number",
        both!("expected {expected}, got '{text}'", "erwartet: {expected}; angegeben: '{text}'", expected),
    )
}
