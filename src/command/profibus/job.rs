//! What a motor is to do over PROFIBUS, as it was typed.

use super::given::SlaveArgs;
use super::spoken::{Choice, usage};
use crate::args::{MotionArgs, StopArg};
use crate::command::running::leads::Way;
use crate::drive::profibus::{Mode, Wanted};
use crate::failure::Failure;
use crate::gate::Relief;
use crate::profile::value::{format_decimal, parse_decimal};
use crate::text::{Text, both};

/// What a motor is to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::command) enum Action {
    /// Runs as long as this program holds it: the furthest of its setpoints.
    Run(Wanted),
    /// Only takes motion away.
    Stop(Relief),
    /// Acknowledges a fault.
    Reset,
}

/// What was typed for it.
pub(in crate::command) struct Job<'j> {
    pub(in crate::command) action: Action,
    /// Word for JSON.
    pub(in crate::command) word: &'static str,
    pub(in crate::command) motion: &'j MotionArgs,
    pub(in crate::command) slave: &'j SlaveArgs,
    pub(in crate::command) choice: Choice,
    /// Where the setpoint of a run goes; nowhere without one.
    pub(in crate::command) way: Option<Way>,
    /// The setpoint is waited for: what that means for a run.
    pub(in crate::command) until: Option<Text>,
}

/// A setpoint as it was typed: `20Hz`, `-12.5Hz`, `30%`.
pub(in crate::command) fn wanted(text: &str) -> Result<Wanted, Failure> {
    let text = text.trim();
    let of = |number: &str| parse_decimal(number.trim(), 2).ok();
    let hertz = text.strip_suffix("Hz").or_else(|| text.strip_suffix("hz")).and_then(of).map(Wanted::Hertz);
    let percent = || text.strip_suffix('%').and_then(of).map(Wanted::Percent);
    let zero = || of(text).filter(|value| *value == 0).map(Wanted::Hertz);
    hertz.or_else(percent).or_else(zero).ok_or_else(|| {
        usage(both!(
            "expected a setpoint such as 20Hz, -12.5Hz or 30%, got '{text}'",
            "erwartet: ein Sollwert wie 20Hz, -12.5Hz oder 30%; angegeben: '{text}'"
        ))
    })
}

impl Job<'_> {
    /// The verb that was typed.
    pub(super) fn verb(&self) -> &'static str {
        if self.word == "sollwert" { "sollwert" } else { "statemachine" }
    }

    /// Whether it only takes motion away.
    pub(super) fn is_stop(&self) -> bool {
        matches!(self.action, Action::Stop(_))
    }

    /// How it ends, by the words of `--on-exit`. Nothing coasts by a word of the Basic block.
    pub(super) fn stop(&self, mode: Mode) -> &'static str {
        let coasts = match self.action {
            Action::Stop(act) => act == Relief::DisableVoltage,
            Action::Run(_) => self.motion.on_exit == StopArg::Coast,
            Action::Reset => false,
        };
        if coasts && !mode.is_basic() { "coast" } else { "ramp" }
    }

    pub(super) fn why(&self) -> Text {
        match self.action {
            Action::Run(_) => both!(
                "to run its motor; you are asked again before",
                "um ihren Motor zu fahren; davor wird erneut gefragt"
            ),
            Action::Stop(_) => both!("to stop its motor", "um ihren Motor anzuhalten"),
            Action::Reset => both!("to acknowledge its fault", "um ihre Störung zu quittieren"),
        }
    }
}

/// How a setpoint is said.
pub(super) fn spoken(wanted: Wanted) -> String {
    format!("{} {}", format_decimal(wanted.value(), DECIMALS), wanted.unit())
}

/// Decimals of a setpoint.
pub(super) const DECIMALS: u8 = 2;

/// A run on a way: the furthest that the setpoint may ever be. The start word says the direction, so a way has one.
pub(in crate::command) fn run_on(first: Wanted, Way { schedule, keys }: &Way) -> Result<Action, Failure> {
    let all = schedule.values().chain(keys.iter().flat_map(|keys| [keys.min, keys.max]));
    let (least, most) = all.fold((0, 0), |(least, most): (i64, i64), value| (least.min(value), most.max(value)));
    if least < 0 && most > 0 {
        return Err(usage(both!(
            "over PROFIBUS a run has one direction, which its start word says: expected setpoints on one side of 0",
            "am PROFIBUS hat ein Lauf eine Richtung, und die sagt sein Startwort: erwartet werden Sollwerte auf einer Seite von 0"
        ))
        .hint(both!("stop it, and run it the other way", "anhalten, und andersherum fahren")));
    }
    Ok(Action::Run(first.at(if least < 0 { least } else { most })))
}
