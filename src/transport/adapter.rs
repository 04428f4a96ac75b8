//! What is known of the adapter behind a serial port, and what is asked of its driver for as long as the port is open:
//! low latency, and the direction of an RS-485 line.

use super::door::SideDoor;
use super::ioctl::{self, KernelRs485};
use super::rs485::{Rs485, Rs485Mode};
use crate::text::{Text, both};
use crate::tick::Span;
use std::io;
use std::path::{Path, PathBuf};

/// The adapter behind a link, as far as the system tells.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AdapterInfo {
    /// Name of the port, links resolved: `/dev/ttyUSB0`.
    pub name: String,
    /// Driver of the port: `ftdi_sio`.
    pub driver: Option<String>,
    /// Maker, product and USB identity: `FTDI FT232R USB UART 0403:6001`.
    pub about: Option<String>,
    /// How long the adapter holds bytes back before it passes them on, in milliseconds, where the driver tells (FTDI).
    pub latency_timer_ms: Option<u32>,
    /// What came of asking for low latency.
    pub low_latency: LowLatency,
    /// Who switches the direction of an RS-485 line, with the delays that hold; never [`Rs485Mode::Auto`] on a tty.
    pub rs485: Rs485,
    /// What the driver counted since it was loaded, where it counts.
    pub error_counts: Option<ErrorCounts>,
}

/// What came of asking the driver for low latency (Linux: ASYNC_LOW_LATENCY).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LowLatency {
    /// It is on.
    Granted,
    /// The driver knows the question and did not do it.
    Refused,
    /// There is nothing to ask.
    #[default]
    Unsupported,
}

/// Characters that a driver received with an error, and breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ErrorCounts {
    /// Stop bit missing: usually another speed or format.
    pub frame: u32,
    /// Lost because nobody fetched them in time.
    pub overrun: u32,
    /// Parity wrong.
    pub parity: u32,
    /// Line held down for longer than a character.
    pub brk: u32,
}

/// A driver that does what was asked of it until this is dropped.
#[derive(Debug)]
pub(super) struct Tuned {
    tty: SideDoor,
    low_latency: LowLatency,
    /// Low latency goes off again.
    restore_latency: bool,
    /// The RS-485 setting that was found.
    restore_rs485: Option<KernelRs485>,
}

impl Tuned {
    /// Asks for low latency, which no driver has to grant.
    pub(super) fn new(tty: SideDoor) -> Self {
        let (low_latency, restore_latency) = match ioctl::serial(&tty) {
            Err(_) => (LowLatency::Unsupported, false),
            Ok(found) if found.low_latency() => (LowLatency::Granted, false),
            Ok(found) => {
                let _best_effort = ioctl::set_serial(&tty, found.with_low_latency(true));
                let granted = ioctl::serial(&tty).is_ok_and(|serial| serial.low_latency());
                (if granted { LowLatency::Granted } else { LowLatency::Refused }, granted)
            }
        };
        Tuned { tty, low_latency, restore_latency, restore_rs485: None }
    }

    pub(super) fn tty(&self) -> &SideDoor {
        &self.tty
    }

    /// Whether the driver switches an RS-485 line already.
    pub(super) fn switches_direction(&self) -> bool {
        ioctl::rs485(&self.tty).is_ok_and(KernelRs485::is_enabled)
    }

    /// Has the driver switch the direction of the line; tells what it set in place of what was asked.
    pub(super) fn switch_direction(&mut self, before: Span, after: Span) -> io::Result<Vec<Text>> {
        let found = ioctl::rs485(&self.tty)?;
        let (before, after) = (whole_millis(before), whole_millis(after));
        let set = ioctl::set_rs485(&self.tty, found.enabled(before, after))?;
        self.restore_rs485.get_or_insert(found);
        if !set.is_enabled() {
            return Err(io::ErrorKind::Unsupported.into());
        }
        let delays = [
            (both!("before", "vor"), before, set.delay_before_send),
            (both!("after", "nach"), after, set.delay_after_send),
        ];
        let deviating = delays.into_iter().filter(|(_, asked, set)| asked != set);
        let told = deviating.map(|(which, asked, set)| {
            both!(
                "asked for {asked} ms {which} a telegram to switch the direction, the driver set {set} ms",
                "verlangt sind {asked} ms {which} einem Telegramm zum Umschalten, der Treiber stellte {set} ms ein",
                which
            )
        });
        Ok(told.collect())
    }

    /// What the system tells of the port at `name`.
    pub(super) fn info(&self, name: &str) -> AdapterInfo {
        let by_kernel = ioctl::rs485(&self.tty).ok().filter(|set| set.is_enabled());
        AdapterInfo {
            low_latency: self.low_latency,
            rs485: by_kernel.map_or(Rs485 { mode: Rs485Mode::Adapter, ..Rs485::default() }, |set| Rs485 {
                mode: Rs485Mode::Kernel,
                before: Span::from_millis(set.delay_before_send.into()),
                after: Span::from_millis(set.delay_after_send.into()),
            }),
            error_counts: ioctl::counters(&self.tty).ok().map(|counters| ErrorCounts {
                frame: counters.frame.cast_unsigned(),
                overrun: counters.overrun.cast_unsigned(),
                parity: counters.parity.cast_unsigned(),
                brk: counters.brk.cast_unsigned(),
            }),
            ..AdapterInfo::of_port(name)
        }
    }
}

impl Drop for Tuned {
    fn drop(&mut self) {
        if let Some(found) = self.restore_rs485 {
            let _best_effort = ioctl::set_rs485(&self.tty, found);
        }
        if self.restore_latency
            && let Ok(serial) = ioctl::serial(&self.tty)
        {
            let _best_effort = ioctl::set_serial(&self.tty, serial.with_low_latency(false));
        }
    }
}

impl AdapterInfo {
    /// What can be told of a port without asking its driver.
    pub(super) fn of_port(name: &str) -> Self {
        let path = std::fs::canonicalize(name).unwrap_or_else(|_| PathBuf::from(name));
        let name = path.display().to_string();
        let device = path.file_name().map(|tty| Path::new("/sys/class/tty").join(tty).join("device"));
        let driver = device.as_ref().and_then(|device| std::fs::canonicalize(device.join("driver")).ok());
        let latency_timer = device.and_then(|device| std::fs::read_to_string(device.join("latency_timer")).ok());
        let listed = super::list_ports().into_iter().find(|port| port.name == name);
        AdapterInfo {
            driver: driver.and_then(|driver| Some(driver.file_name()?.to_string_lossy().into_owned())),
            about: listed.map(|port| port.about).filter(|about| !about.is_empty()),
            latency_timer_ms: latency_timer.and_then(|text| text.trim().parse().ok()),
            name,
            ..AdapterInfo::default()
        }
    }
}

fn whole_millis(span: Span) -> u32 {
    u32::try_from(span.as_micros().div_ceil(1_000)).unwrap_or(u32::MAX)
}
