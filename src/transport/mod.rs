//! What carries bytes, and the clock that goes with it: a serial port, or the built-in bench.
//!
//! Every link tells its own time: real on a tty, virtual on the bench, where a scan of 247 silent addresses takes no
//! time at all and every run of it is the same. This room knows no telegrams.

mod serial;
pub mod serve;
mod sim;
mod trace;

pub use serial::{PortInfo, list_ports};
pub use trace::{Trace, TraceLine, read_trace};

use crate::protocol::line::LineSetting;
use crate::simulator::Bench;
use crate::tick::Tick;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// Where the drives are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Port {
    /// A serial port by its path or name.
    Serial(String),
    /// The built-in bench: the standard one, or one from a file.
    Sim(Option<PathBuf>),
}

impl FromStr for Port {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once(':') {
            _ if text.is_empty() => {
                Err("the name of the port is empty; expected a tty such as /dev/ttyUSB0, or sim".to_owned())
            }
            _ if text == "sim" => Ok(Port::Sim(None)),
            Some(("sim", "")) => Err("expected sim:FILE.toml, or just sim".to_owned()),
            Some(("sim", file)) => Ok(Port::Sim(Some(PathBuf::from(file)))),
            Some((scheme @ ("tcp" | "rfc2217" | "mbtcp" | "slcan" | "can"), _)) => Err(format!(
                "{scheme}: ports are not supported by this version; expected a tty such as /dev/ttyUSB0, or sim"
            )),
            _ => Ok(Port::Serial(text.to_owned())),
        }
    }
}

impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Port::Serial(name) => f.write_str(name),
            Port::Sim(None) => f.write_str("sim"),
            Port::Sim(Some(file)) => write!(f, "sim:{}", file.display()),
        }
    }
}

/// What ended a wait.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wake {
    /// Bytes came.
    Bytes(Vec<u8>),
    /// The time is over.
    Silence,
}

/// Why a link cannot be opened or does not go on.
#[derive(Debug, thiserror::Error)]
pub enum LinkError {
    /// There is no such port.
    #[error("there is no port '{0}'")]
    NotFound(String),
    /// Somebody else has it.
    #[error("port '{0}' is in use by another program")]
    Busy(String),
    /// The user may not open it.
    #[error("no permission to open port '{0}'")]
    Permission(String),
    /// The driver does not do what was asked.
    #[error("port '{port}': {message}")]
    Setting {
        /// The port.
        port: String,
        /// What the driver said, or what it set in place of what was asked.
        message: String,
    },
    /// The adapter was unplugged, or the other end hung up.
    #[error("port '{0}' was lost: the adapter was unplugged or the other end hung up")]
    Lost(String),
}

/// A way to the drives.
#[derive(Debug)]
pub struct Link {
    carrier: Carrier,
    trace: Option<Trace>,
}

#[derive(Debug)]
enum Carrier {
    Serial(Box<serial::SerialLink>),
    Sim(Box<sim::SimLink>),
}

impl Link {
    /// Opens a serial port, exclusively, with its input cleared.
    pub fn open_serial(name: &str, line: LineSetting) -> Result<Self, LinkError> {
        let carrier = Carrier::Serial(Box::new(serial::SerialLink::open(name, line)?));
        Ok(Link { carrier, trace: None })
    }

    /// A bench in virtual time.
    pub fn open_sim(bench: Bench, line: LineSetting) -> Self {
        Link { carrier: Carrier::Sim(Box::new(sim::SimLink::new(bench, line))), trace: None }
    }

    /// Writes every chunk of bytes to a trace from now on.
    pub fn record_to(&mut self, trace: Trace) {
        self.trace = Some(trace);
    }

    /// Lets the time of the bench follow the wall clock from now on, for verbs that watch or hold: waiting really
    /// waits. The times that the link tells stay those of the bench. A real line does so anyway.
    pub fn pace(&mut self) {
        match &mut self.carrier {
            Carrier::Serial(_) => {}
            Carrier::Sim(link) => link.pace(),
        }
    }

    /// Opens a port that was lost anew, under its name, with its clock going on. Until that succeeds nothing can be
    /// sent, and waiting only passes the time.
    pub fn reopen(&mut self) -> Result<(), LinkError> {
        match &mut self.carrier {
            Carrier::Serial(link) => link.reopen(),
            Carrier::Sim(_) => Ok(()),
        }
    }

    /// What the driver set in place of what was asked, if it did not obey in all.
    pub fn deviations(&self) -> &[String] {
        match &self.carrier {
            Carrier::Serial(link) => link.deviations(),
            Carrier::Sim(_) => &[],
        }
    }

    /// The time of this link.
    pub fn now(&self) -> Tick {
        match &self.carrier {
            Carrier::Serial(link) => link.now(),
            Carrier::Sim(link) => link.now(),
        }
    }

    /// Puts bytes on the line. They may still be on their way when this returns.
    pub async fn send(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        let at = self.now();
        match &mut self.carrier {
            Carrier::Serial(link) => link.send(bytes).await?,
            Carrier::Sim(link) => link.send(bytes),
        }
        if let Some(trace) = &mut self.trace {
            trace.sent(at, bytes);
        }
        Ok(())
    }

    /// Waits until bytes come or the time is over; bytes that are there already come at once.
    pub async fn wait(&mut self, until: Tick) -> Result<Wake, LinkError> {
        let wake = match &mut self.carrier {
            Carrier::Serial(link) => link.wait(until).await?,
            Carrier::Sim(link) => link.wait(until).await,
        };
        if let (Some(trace), Wake::Bytes(bytes)) = (&mut self.trace, &wake) {
            let at = match &self.carrier {
                Carrier::Serial(link) => link.now(),
                Carrier::Sim(link) => link.now(),
            };
            trace.received(at, bytes);
        }
        Ok(wake)
    }

    /// Keeps the line until a moment without listening, whatever else happens; on the bench there is nobody to wait for.
    pub fn outlast(&mut self, until: Tick) {
        match &self.carrier {
            Carrier::Serial(link) => link.sleep_until(until),
            Carrier::Sim(_) => {}
        }
    }

    /// The bench behind the link, if it is one.
    pub fn bench(&mut self) -> Option<&mut Bench> {
        match &mut self.carrier {
            Carrier::Serial(_) => None,
            Carrier::Sim(link) => Some(link.bench()),
        }
    }
}
