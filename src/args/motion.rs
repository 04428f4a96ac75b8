//! Arguments of everything that can turn a shaft.

use super::below_zero;
use super::globals::parse_span;
use crate::tick::Span;
use clap::{Args, ValueEnum};

/// How long a drive may run, and how it is stopped.
#[derive(Clone, Debug, Args)]
pub struct MotionArgs {
    /// Run only while this program runs, then --on-exit
    #[arg(long, help_heading = "Run")]
    pub hold: bool,

    /// With --hold: end after this time
    ///
    /// It counts from the word that can turn the shaft, whether that is answered or not; behind `--ramp` from its end, with `--until reached` from then on.
    #[arg(long, visible_alias = "for", value_name = "TIME", value_parser = parse_span, requires = "hold", help_heading = "Run")]
    pub duration: Option<Span>,

    /// Then ramp (default), quick-stop, coast or keep
    ///
    /// How to stop at the end, on Ctrl-C, on an error: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast,
    /// keep. PROFIBUS: ramp (OFF1), coast (OFF3). Another Ctrl-C takes the next stronger way.
    #[arg(
        long,
        value_name = "STOP",
        default_value = "ramp",
        hide_default_value = true,
        hide_possible_values = true,
        help_heading = "Run"
    )]
    pub on_exit: StopArg,

    /// Set the drive's own watchdog for the run
    ///
    /// P.413, MBnode_guard: in RAM; given back behind --hold, a stop and a reset. PROFIBUS: that of the slave, 0.1 to 60 s, and
    /// P.703 = 2 for the run where a lost bus would not stop the motor.
    #[arg(long, value_name = "TIME", value_parser = parse_span, hide_short_help = true, help_heading = "Run")]
    pub watchdog: Option<Span>,

    /// ACTIVE: take control with P.412 = 1 for the run
    ///
    /// In RAM; given back behind --hold, a stop and a reset, where that starts nothing. PROFIBUS: P.928 = 1, given back.
    #[arg(long, help_heading = "Run")]
    pub take_control: bool,

    /// How long to wait for a state [default: 3s]
    ///
    /// Beyond what ramps and holding times need, at most 10 min in all unless this is longer;
    /// and how long missing answers are borne where the drive has no watchdog (with one: half of its time).
    #[arg(long, value_name = "TIME", value_parser = parse_span, hide_short_help = true, help_heading = "Run")]
    pub wait: Option<Span>,

    /// With --hold: chart and keypad; space stops
    ///
    /// The whole terminal shows the run, and keys act as on a drive's keypad: space stops, q stops and ends, d shows the diagnosis;
    /// arrows see `sollwert --step`.
    #[arg(long, help_heading = "Run")]
    pub view: bool,

    /// Like --view: runs only while a key is held
    ///
    /// Enter or an arrow. Who lets go stops it, within 0.3 s, and a tap within 0.8 s: keyboards wait so long before they repeat.
    /// Stopped it stays so, and the view stays until q; no key starts it again.
    #[arg(long, hide_short_help = true, help_heading = "Run")]
    pub dead_man: bool,
}

impl MotionArgs {
    /// Whether the whole terminal and its keys are wanted.
    pub fn wants_keys(&self) -> bool {
        self.view || self.dead_man
    }

    /// Whether the run is held, and its end is a stop.
    pub fn ends_in_a_stop(&self) -> bool {
        self.hold && self.on_exit != StopArg::Keep
    }

    /// The same without what bounds a run: a stop is none.
    pub fn of_a_stop(&self) -> MotionArgs {
        MotionArgs { hold: false, duration: None, view: false, dead_man: false, ..self.clone() }
    }
}

/// What the arrows of the keypad do.
#[derive(Clone, Debug, Args)]
pub struct KeypadArgs {
    /// With --view: the arrows change the setpoint by this
    ///
    /// Such as 0.5Hz, within --min and --max, which the question names.
    #[arg(long, value_name = "STEP", hide_short_help = true, help_heading = "Run")]
    pub step: Option<String>,

    /// With --step: no lower than this
    ///
    /// Without it the lowest setpoint of the run, or 0 if that is lower.
    #[arg(
        long,
        value_name = "SETPOINT",
        allow_hyphen_values = true,
        value_parser = below_zero::word,
        requires = "step",
        hide_short_help = true,
        help_heading = "Run"
    )]
    pub min: Option<String>,

    /// With --step: no higher than this
    ///
    /// Without it the highest setpoint of the run, or 0 if that is higher.
    #[arg(
        long,
        value_name = "SETPOINT",
        allow_hyphen_values = true,
        value_parser = below_zero::word,
        requires = "step",
        hide_short_help = true,
        help_heading = "Run"
    )]
    pub max: Option<String>,
}

/// A way to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StopArg {
    /// Disable operation: transition 5, which coasts, brakes or ramps as P.392 says.
    Ramp,
    /// Quick stop: the emergency ramps P.424 and P.425.
    QuickStop,
    /// Disable voltage: the shaft coasts.
    Coast,
    /// Leave it running.
    Keep,
}
