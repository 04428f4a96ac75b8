//! Arguments of everything that can turn a shaft.

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
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "hold", help_heading = "Run")]
    pub duration: Option<Span>,

    /// Then ramp, quick-stop, coast or keep [default: ramp]
    ///
    /// How to stop at the end, on Ctrl-C, on an error: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast,
    /// keep. Another Ctrl-C takes the next stronger way.
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
    /// P.413, MBnode_guard: in RAM, and restored afterwards.
    #[arg(long, value_name = "TIME", value_parser = parse_span, help_heading = "Run")]
    pub watchdog: Option<Span>,

    /// ACTIVE: take control with P.412 = 1 for the run
    ///
    /// In RAM, and given back afterwards.
    #[arg(long, help_heading = "Run")]
    pub take_control: bool,

    /// How long to wait for a state [default: 3s]
    ///
    /// Beyond what ramps and holding times need, at most 10 min in all unless this is longer;
    /// and how long missing answers are borne where the drive has no watchdog (with one: half of its time).
    #[arg(long, value_name = "TIME", value_parser = parse_span, help_heading = "Run")]
    pub wait: Option<Span>,
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
