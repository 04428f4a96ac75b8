//! Arguments of everything that can turn a shaft.

use super::globals::parse_span;
use crate::tick::Span;
use clap::{Args, ValueEnum};

/// How long a drive may run, and how it is stopped.
#[derive(Clone, Debug, Args)]
pub struct MotionArgs {
    /// Keep the drive running only while this program runs, then stop it as --on-exit says
    #[arg(long, help_heading = "Safety")]
    pub hold: bool,

    /// With --hold: end after this time
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "hold", help_heading = "Safety")]
    pub duration: Option<Span>,

    /// How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in
    /// modes that it does not stop), quick-stop, coast, keep
    #[arg(long, value_name = "STOP", default_value = "ramp", help_heading = "Safety")]
    pub on_exit: StopArg,

    /// Set the drive's own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards
    #[arg(long, value_name = "TIME", value_parser = parse_span, help_heading = "Safety")]
    pub watchdog: Option<Span>,

    /// ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards
    #[arg(long, help_heading = "Safety")]
    pub take_control: bool,

    /// How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer;
    /// and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]
    #[arg(long, value_name = "TIME", value_parser = parse_span, help_heading = "Safety")]
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
