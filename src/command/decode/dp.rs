//! `decode` for PROFIBUS-DP and the Hitachi SJ2-PB: what stands in telegrams, without the telegram.

use super::{Context, bad_code, blank, number};
use crate::drive::decode::dp::{self, Cyclic, Reader};
use crate::failure::{Class, Failure};
use crate::outcome::{Decode, Parts};
use crate::profile::{Family, Route};
use crate::text::{Text, both};
use clap::Subcommand;
use std::rc::Rc;

pub(super) use dp::{is_recorded, is_spoken};

#[derive(Clone, Debug, Subcommand)]
pub(super) enum What {
    /// A PKW block of PROFIBUS, such as 7393 0100 0000 0022
    ///
    /// Eight bytes: PKE, IND and PWE. What a master asks, or with --reply what the slave answers.
    Pkw {
        /// The eight bytes
        #[arg(required = true, value_name = "BYTES")]
        bytes: Vec<String>,
        /// The slave says it
        #[arg(long)]
        reply: bool,
    },
    /// A diagnosis of PROFIBUS (Slave_Diag)
    ///
    /// Six bytes and more, such as 02 05 00 FF 0A 35.
    Diagnosis {
        /// The bytes
        #[arg(required = true, value_name = "BYTES")]
        bytes: Vec<String>,
    },
    /// A status word of the SJ2-PB in Basic mode, such as 0x0DD0
    BasicStatus {
        /// The word
        word: String,
    },
    /// A control word of the SJ2-PB in Basic mode, such as 0x0050
    BasicControl {
        /// The word
        word: String,
    },
}

/// The inverter whose names are told: the one that was named, else an L200. Their words are the same in all three series.
pub(super) fn inverter(context: &Context<'_>, family: &Rc<Family>) -> Rc<Family> {
    let usual = context.registry.family("l200").filter(|_| context.settings.drive.is_none());
    usual.unwrap_or_else(|| family.clone())
}

/// Names come from a catalogue only if it is that of an inverter behind an SJ2-PB.
pub(super) fn reader(family: &Family, cyclic: Option<Cyclic>) -> Reader<'_> {
    Reader { family: Some(family).filter(|family| family.link.route == Route::Pkw), cyclic }
}

pub(super) fn explain(what: &What, family: &Family) -> Result<Decode, Failure> {
    let (kind, input, parts) = match what {
        What::Pkw { bytes, reply } => {
            let input = bytes.join(" ");
            let parts = reader(family, None).pkw(&input, !reply).map_err(usage)?;
            ("pkw", input, parts)
        }
        What::Diagnosis { bytes } => {
            let input = bytes.join(" ");
            let parts = dp::diagnosis(&input).map_err(usage)?;
            ("diagnosis", input, parts)
        }
        What::BasicStatus { word } => ("basic-status", word.clone(), basic(word, false)?),
        What::BasicControl { word } => ("basic-control", word.clone(), basic(word, true)?),
    };
    Ok(Decode { parts: Some(parts), ..blank(kind, &input) })
}

fn basic(text: &str, is_control: bool) -> Result<Parts, Failure> {
    let word = number(text).and_then(|word| u16::try_from(word).ok());
    let such = both!("a 16-bit word such as 0x0050 or 80", "ein 16-Bit-Wort wie 0x0050 oder 80");
    word.map(|word| dp::basic(word, is_control)).ok_or_else(|| bad_code(text, &such))
}

fn usage(why: Text) -> Failure {
    Failure::new(Class::Usage, "usage.bytes", why)
}
