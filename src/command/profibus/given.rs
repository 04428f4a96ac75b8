//! How a slave is taken, as it was typed; and parameters with elements.

use crate::args::{Settings, parse_span};
use crate::command::selecting::select_failure;
use crate::drive::decode::dp::Cyclic;
use crate::drive::profibus;
use crate::failure::{Class, Failure};
use crate::profile::{Family, Param, Selector};
use crate::text::{Wrong, both};
use crate::tick::Span;
use clap::Args;
use std::path::PathBuf;

/// How a slave is taken.
#[derive(Clone, Debug, Default, Args)]
pub struct SlaveArgs {
    /// The GSD of the slave
    ///
    /// Its ident number must be that of the slave, and its user parameters go into Set_Prm with those of the module that has the
    /// bytes of the mode. Two GSDs of an SJ2-PB choose between Basic and ProfiDrive mode.
    #[arg(long, value_name = "FILE", conflicts_with = "user_prm", hide_short_help = true, help_heading = "PROFIBUS")]
    pub gsd: Option<PathBuf>,
    /// User parameters of Set_Prm (hex), if the GSD wants any
    #[arg(long, value_name = "HEX", hide_short_help = true, help_heading = "PROFIBUS")]
    pub user_prm: Option<UserPrm>,
    /// Its configuration: basic, ppo1 to ppo5, or hex
    ///
    /// What Chk_Cfg says, and so how the slave is led. Without it Get_Cfg or --mode decide between the Basic block and PPO1. PPO2, PPO4 and
    /// PPO5 have further words: nothing may be mapped to those that are written (P.915), which is looked at first. PPO3 and PPO4 tell no parameters.
    #[arg(long, value_name = "CFG", hide_short_help = true, help_heading = "PROFIBUS")]
    pub cfg: Option<Cyclic>,
    /// How soon an answer begins [default: 30ms or 8ms]
    ///
    /// 8 ms hold from 93750 Bd on. An adapter that holds bytes back needs more.
    #[arg(long, value_name = "TIME", value_parser = parse_span, hide_short_help = true, help_heading = "PROFIBUS")]
    pub slot_time: Option<Span>,
}

impl SlaveArgs {
    /// Whether a slave is meant: PROFIBUS is spoken. Fails if only the options say so.
    pub(in crate::command) fn is_meant(&self, settings: &Settings) -> Result<bool, Failure> {
        let is_given = self.gsd.is_some() || self.user_prm.is_some() || self.slot_time.is_some() || self.cfg.is_some();
        if settings.profibus || !is_given {
            return Ok(settings.profibus);
        }
        let message = both!(
            "--gsd, --user-prm, --cfg and --slot-time mean something on PROFIBUS alone",
            "--gsd, --user-prm, --cfg und --slot-time bedeuten nur am PROFIBUS etwas"
        );
        Err(Failure::new(Class::Usage, "usage.profibus", message)
            .hint(both!("add --protocol dp, or leave them out", "--protocol dp angeben oder sie weglassen")))
    }

    pub(super) fn user(&self) -> Vec<u8> {
        self.user_prm.as_ref().map(|user| user.0.clone()).unwrap_or_default()
    }
}

/// Bytes that the GSD wants in Set_Prm.
#[derive(Clone, Debug)]
pub struct UserPrm(Vec<u8>);

impl std::str::FromStr for UserPrm {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let expected = || {
            both!(
                "expected bytes in hex such as C7FFFF, got '{text}'",
                "erwartet: Bytes in Hex wie C7FFFF; angegeben: '{text}'"
            )
        };
        profibus::user_parameters(text).map(UserPrm).ok_or_else(|| Wrong(expected()))
    }
}

/// A parameter as it was typed, and the element behind its number: `915.1`.
pub(super) fn element(text: &str) -> (&str, Option<u8>) {
    let parts = text.split_once('.').filter(|(number, _)| number.parse::<u32>().is_ok());
    let element =
        parts.and_then(|(number, element)| Some((number, element.parse().ok().filter(|element| *element > 0)?)));
    element.map_or((text, None), |(number, element)| (number, Some(element)))
}

/// Parameters to read, each with its element; an array without one is all of its elements.
pub(super) fn params(typed: &[String], family: &Family) -> Result<Vec<(Param, Option<u8>)>, Failure> {
    let mut params = Vec::new();
    for text in typed {
        let (text, element) = element(text);
        let selector: Selector = text.parse().map_err(|error| select_failure(&error))?;
        for selection in selector.resolve(family).map_err(|error| select_failure(&error))? {
            crate::command::check_number(family, &selection.param)?;
            crate::command::check_sets(family, selection.sets)?;
            let param = selection.param;
            if !param.access.reads() {
                continue;
            }
            match param.elements.filter(|_| element.is_none()) {
                // An array has no value as a whole.
                Some(count) => params.extend((1..=count).map(|element| (param.clone(), Some(element)))),
                None => params.push((param, element)),
            }
        }
    }
    Ok(params)
}
