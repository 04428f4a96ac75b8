//! What a line is opened with where nobody says otherwise.

use super::session::Opening;
use crate::profile::Lang;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::Framing;
use crate::transport::{Port, Rs485};

impl<'a> Opening<'a> {
    /// A line as drives of the ACTIVE family speak on it from the factory: Modbus RTU, 19200 baud, even parity (CM-485
    /// manual 5). What is another way is put in its place: `Opening { retries: Some(0), ..Opening::at(&port) }`.
    pub fn at(port: &'a Port) -> Self {
        Opening {
            port,
            line: LineSetting::rtu(19_200, Parity::Even),
            rs485: Rs485::default(),
            protocol: Framing::Rtu.into(),
            timeout: None,
            retries: None,
            trace: None,
            verbose: false,
            lang: Lang::En,
        }
    }
}
