//! `antrieb`: the commissioning tool for industrial drives on serial lines.
//!
//! A library of pure protocol and drive knowledge, and a thin command-line program on it. The rooms, from the floor up:
//!
//! | room | what it knows |
//! |---|---|
//! | [`tick`], [`text`], [`failure`], [`files`], [`gate`], [`outcome`] | time, texts, failures, files, permits, what was found: the floor |
//! | [`protocol`] | bytes to telegrams and back |
//! | [`profile`] | what a drive is: catalogues and pure decoding |
//! | [`scope`] | curves over time, and a picture of them |
//! | [`systembus`] | plans of a system bus: relations, checks, load |
//! | [`exchange`] | conversations without I/O |
//! | [`simulator`] | drives that answer, on a bus that judges timing |
//! | [`transport`] | what carries bytes, and the clock |
//! | [`drive`] | use-cases on connected drives |
//! | [`args`], [`command`], [`render`], [`cli`] | the program: settings, verbs, output, dispatch |
//!
//! The last row is there with the feature `cli`, which is on by default. Without it this is a library: here it finds a drive
//! on the built-in bench, whose time is virtual, and reads a parameter. A serial port takes the place of the bench by its
//! name.
//!
//! ```
//! use antrieb::drive::{Interrupt, Opening, Port, ScanPlan, Session, Target, scan};
//! use antrieb::profile::{Registry, value::format_decimal};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let registry = Registry::open(&[])?;
//! let port: Port = "sim".parse()?;
//! let mut told = |_event| {};
//! let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
//! runtime.block_on(async {
//!     let mut session = Session::open(Opening::at(&port), &registry, Interrupt::default(), &mut told).await?;
//!     let found = scan(&mut session, &ScanPlan::new(1..=3), &registry).await;
//!     let drive = found.drives.first().ok_or("nobody answers")?;
//!     assert_eq!((drive.address, drive.drive.as_str()), (1, "act"));
//!
//!     let family = registry.family(&drive.drive).ok_or("no drive that we know")?;
//!     let rated_speed = family.param(372).cloned().ok_or("no such parameter")?;
//!     let mut target = Target::new(drive.address, family);
//!     let reading = target.read_set(&mut session, &rated_speed, 2).await?;
//!     let shown = format_decimal(reading.raw, rated_speed.decimals_or_zero());
//!     assert_eq!((shown.as_str(), rated_speed.unit.as_deref()), ("1390", Some("1/min")));
//!     Ok(())
//! })
//! # }
//! ```
//!
//! Who may name whom is law, and `tests/house` holds it. ARCHITECTURE.md is the floor plan. "sources A2"
//! in a comment is a section of docs/sources.md.

#[cfg(feature = "cli")]
pub mod args;
#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "cli")]
pub mod command;
pub mod drive;
pub mod exchange;
pub mod failure;
pub mod files;
pub mod gate;
pub mod outcome;
pub mod profile;
pub mod protocol;
#[cfg(feature = "cli")]
pub mod render;
pub mod scope;
pub mod simulator;
pub mod systembus;
pub mod text;
pub mod tick;
pub mod transport;

#[cfg(feature = "cli")]
pub use cli::run;
