//! Finds the way from where a drive is to what is wished for.

use super::said::{
    ADDRESS, behind_another, cannot_follow, of_the_bus, out_of_range, speaks_one_only, unknown_settings,
};
use super::{Change, Course, Leg, Place, Then, Wish, coded, meaning, number, parities, protocols};
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::failure::Failure;
use crate::profile::{Holds, Param, Role};
use crate::protocol::Protocol;
use crate::protocol::can::LAST_DRIVE;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::LAST_STATION;
use crate::protocol::vabus::Address;

/// Finds the way to what is wished for, by reading the settings of the drive; says why if there is none.
pub async fn course(session: &mut Session<'_>, target: &mut Target, wish: &Wish) -> Result<Course, Failure> {
    let family = target.family.clone();
    wish.check(std::slice::from_ref(&family), session.protocol())?;
    if session.node() != 0 {
        return Err(behind_another());
    }
    let is_on_bus = session.protocol().is_can();
    if is_on_bus && target.address > LAST_DRIVE {
        return Err(of_the_bus());
    }
    let from = Place { protocol: session.protocol(), line: session.line(), address: target.address };
    let mut plot = Plot { session, target, here: from, legs: Vec::new(), restarts: false };
    if is_on_bus {
        plot.over_bus(wish).await?;
        return Ok(Course { from, to: plot.here, legs: plot.legs, after_reset: family.link.after_reset.clone() });
    }
    if let Some(protocol) = wish.protocol.filter(|to| *to != from.protocol) {
        let (protocol, raw) =
            coded(&protocols(&family), Some(protocol)).ok_or_else(|| speaks_one_only(&from.protocol))?;
        plot.speak(protocol, raw).await?;
    }
    if let Some(address) = wish.address.filter(|&address| address != u32::from(plot.here.address)) {
        plot.readdress(address)?;
    }
    if let Some((baud, raw)) = coded(&family.link.line.baud_rates, wish.baud) {
        let line = LineSetting { baud, ..plot.here.line };
        plot.restarts |= plot.store(Role::BaudRate, raw, line).await? || from.line.baud != baud;
        plot.here.line.baud = baud;
    }
    if let Some((parity, raw)) = coded(&parities(&family), wish.parity) {
        let line = plot.here.protocol.line(plot.here.line.baud, parity);
        plot.restarts |= plot.store(&family.link.line.parity, raw, line).await?;
        plot.check(parity);
    }
    if let Some(raw) = family.link.line.restart.filter(|_| plot.restarts) {
        let leg = Leg { param: plot.row(Role::Reset)?, old: None, raw, then: Then::Restart(plot.here) };
        plot.legs.push(leg);
    }
    let moves = |leg: &Leg| match leg.then {
        Then::At(place) | Then::Restart(place) => place.line != from.line,
        Then::Perhaps(change) => change.of(from).line != from.line,
        Then::Stored => false,
    };
    if plot.legs.iter().any(moves) && !plot.session.can_retune() {
        return Err(cannot_follow(plot.session.port()));
    }
    Ok(Course { from, to: plot.here, legs: plot.legs, after_reset: family.link.after_reset.clone() })
}

/// A way that is being drawn.
pub(super) struct Plot<'p, 's> {
    pub(super) session: &'p mut Session<'s>,
    pub(super) target: &'p mut Target,
    /// Where the drive is after what is drawn so far.
    pub(super) here: Place,
    pub(super) legs: Vec<Leg>,
    /// Something waits for a restart.
    restarts: bool,
}

impl Plot<'_, '_> {
    /// Another protocol; the address is the one that the drive has for it.
    async fn speak(&mut self, protocol: Protocol, raw: i64) -> Result<(), Failure> {
        let family = self.target.family.clone();
        let old = number(&protocols(&family), &self.here.protocol);
        let address = self.stored(address_role(protocol)).await?;
        let address = u8::try_from(address).map_err(|_| out_of_range(&ADDRESS, "1-247", &address))?;
        // From VABus nobody sees what parity Modbus has in force; it is looked for, from the stored one on.
        let parity = match self.here.protocol {
            Protocol::Modbus(_) => self.here.line.parity,
            Protocol::Vabus | Protocol::Sdo(_) | Protocol::Pkw => {
                meaning(&parities(&family), self.stored(&family.link.line.parity).await?).unwrap_or(Parity::Even)
            }
        };
        self.here = Place::usual(protocol, self.here.line.baud, parity, address);
        let leg = Leg { param: self.row(Role::Protocol)?, old, raw, then: Then::At(self.here) };
        self.legs.push(leg);
        Ok(())
    }

    pub(super) fn readdress(&mut self, address: u32) -> Result<(), Failure> {
        let last = match self.here.protocol {
            Protocol::Vabus => Address::LAST,
            Protocol::Sdo(_) => LAST_DRIVE,
            Protocol::Pkw => crate::protocol::dp::LAST_STATION,
            Protocol::Modbus(_) => LAST_STATION,
        };
        let fits = u8::try_from(address).ok().filter(|address| *address <= last);
        let address = fits.ok_or_else(|| out_of_range(&ADDRESS, &format!("1-{last}"), &address))?;
        let param = self.row(address_role(self.here.protocol))?;
        let old = Some(self.here.address.into());
        self.here.address = address;
        let then = match (self.target.family.link.line.address, self.here.protocol) {
            // When a node holds is in no source (EM-RES-03 manual 5.5).
            (_, Protocol::Sdo(_)) | (Holds::Unsaid, _) => Then::Perhaps(Change::Address(address)),
            (Holds::AtOnce, _) => Then::At(self.here),
        };
        self.legs.push(Leg { param, old, raw: address.into(), then });
        Ok(())
    }

    /// Writes a setting that waits for a restart, unless it stands there already; tells whether.
    async fn store(&mut self, role: impl AsRef<str> + Copy, raw: i64, line: LineSetting) -> Result<bool, Failure> {
        let old = self.stored(role).await?;
        // Without a restart at hand nobody waits for one: it is looked whether the drive has changed already.
        let restarts = self.target.family.link.line.restart.is_some();
        let then = if restarts { Then::Stored } else { Then::Perhaps(Change::Line(line)) };
        if old != raw {
            let leg = Leg { param: self.row(role)?, old: Some(old), raw, then };
            self.legs.push(leg);
        }
        Ok(old != raw)
    }

    /// The parity after the restart: P.1375 is that of Modbus; VABus has its own.
    fn check(&mut self, parity: Parity) {
        if self.here.protocol != Protocol::Vabus && self.here.line.parity != parity {
            self.restarts = true;
            self.here.line = self.here.protocol.line(self.here.line.baud, parity);
        }
    }

    pub(super) fn row(&self, role: impl AsRef<str>) -> Result<Param, Failure> {
        self.target.family.role(role).cloned().ok_or_else(unknown_settings)
    }

    pub(super) async fn stored(&mut self, role: impl AsRef<str>) -> Result<i64, Failure> {
        let param = self.row(role)?;
        let (address, family) = (self.target.address, self.target.family.clone());
        let reading = self.target.read_set(self.session, &param, 0).await;
        reading.map(|reading| reading.raw).map_err(|error| error.failure(address, Some(&family)))
    }
}

/// The parameter that holds the address in a protocol.
pub(super) fn address_role(protocol: Protocol) -> Role {
    match protocol {
        Protocol::Vabus => Role::NodeId,
        Protocol::Sdo(_) => Role::BusNode,
        Protocol::Modbus(_) | Protocol::Pkw => Role::Address,
    }
}
