//! What is otherwise where a drive is moved on a CAN bus, over that bus (EM-RES-03 manual 5.4, 5.5, 5.9.4). When any of it holds is in no
//! source, so the drive is looked for at both.

use super::journey::{follow, is_taken};
use super::plot::Plot;
use super::said::{no_other_channel, not_alone};
use super::{Change, Leg, Place, Then, Wish, coded, rates};
use crate::drive::can::forbidden;
use crate::drive::can::trouble::other_master;
use crate::exchange::Limits;
use crate::failure::Failure;
use crate::profile::Role;
use crate::protocol::Protocol;
use crate::protocol::can::sdo::{Multiplexer, Request};
use crate::protocol::can::{LAST_DRIVE, MASTER_STATION, SdoChannel};
use crate::protocol::line::LineSetting;
use crate::text::{Text, both};
use crate::tick::Span;

/// Values of P.923, and over what a drive is asked then.
pub(super) const CHANNELS: [(i64, Protocol); 2] =
    [(0, Protocol::Sdo(SdoChannel::One)), (1, Protocol::Sdo(SdoChannel::Two))];
/// Between two questions that look who else is there; what comes later is heard as well.
const PACE: Span = Span::from_millis(20);
/// Every drive has the parameter that holds its node.
const NODE: Multiplexer = Multiplexer { index: 900, sub: 0 };

/// What there is to be known of a step, besides what it changes.
pub(super) fn besides(then: Then) -> Option<Text> {
    match then {
        Then::Perhaps(Change::Rate(_)) => Some(both!(
            "everybody else on this bus keeps the rate: nobody else may be on it, a silent one without SDO2 either",
            "alle anderen am Bus behalten die Bitrate: es darf niemand sonst daran sein, auch kein stiller ohne SDO2"
        )),
        Then::Perhaps(Change::Address(_)) => Some(both!(
            "a stopped node, and one without SDO2, answers nobody: that the new number is free is seen only as far as others answer",
            "ein gestoppter Knoten und einer ohne SDO2 antwortet niemandem: dass die neue Nummer frei ist, zeigt sich nur, soweit andere \
             antworten"
        )),
        Then::Perhaps(Change::Channel(SdoChannel::One)) => Some(both!(
            "SDO1 is the master's: beside one this drive is out of reach then",
            "SDO1 gehört dem Master: neben einem ist dieser Umrichter dann nicht mehr erreichbar"
        )),
        _ => None,
    }
}

impl Plot<'_, '_> {
    /// The way on a bus: channel, node, rate, one behind the other.
    pub(super) async fn over_bus(&mut self, wish: &Wish) -> Result<(), Failure> {
        if let Some((Protocol::Sdo(channel), raw)) = coded(&CHANNELS, wish.protocol) {
            self.channel(channel, raw).await?;
        }
        if let Some(address) = wish.address.filter(|&address| address != u32::from(self.here.address)) {
            self.readdress(address)?;
        }
        let family = self.target.family.clone();
        if let Some((rate, raw)) = coded(rates(&family, true), wish.baud) {
            self.rate(rate, raw).await?;
        }
        Ok(())
    }

    /// P.923, so that the drive is asked over a channel from then on.
    async fn channel(&mut self, to: SdoChannel, raw: i64) -> Result<(), Failure> {
        let there = Place { protocol: Protocol::Sdo(to), ..self.here };
        let old = self.stored(Role::BusTool).await?;
        if there == self.here && old == raw {
            return Ok(());
        }
        if to == SdoChannel::One {
            self.calls(MASTER_STATION).await?;
            self.listen().await?;
        }
        let traffic = self.session.traffic().unwrap_or_default();
        let is_led = to == SdoChannel::One && traffic.nodes.contains_key(&MASTER_STATION);
        if is_led {
            return Err(other_master());
        }
        forbidden(&traffic, to).map_or(Ok(()), Err)?;
        let (session, target) = (&mut *self.session, &mut *self.target);
        let answers = is_taken(session, target, there).await;
        let back = follow(session, target, self.here).await;
        let answers = answers.and_then(|answers| back.map(|()| answers));
        let answers = answers.map_err(|error| error.failure(self.here.address, None))?;
        match to {
            SdoChannel::One if !answers => return Err(no_other_channel()),
            // It has it already.
            SdoChannel::Two if answers && old == raw => return Ok(()),
            _ => {}
        }
        self.here = there;
        if old != raw {
            let then = Then::Perhaps(Change::Channel(to));
            self.legs.push(Leg { param: self.row(Role::BusTool)?, old: Some(old), raw, then });
        }
        Ok(())
    }

    /// P.903, with nobody else on the bus.
    async fn rate(&mut self, rate: u32, raw: i64) -> Result<(), Failure> {
        let old = self.stored(Role::BusRate).await?;
        if old == raw && self.here.line.baud == rate {
            return Ok(());
        }
        if !self.session.can_retune() {
            return Err(super::said::fixed_rate(self.session.port()));
        }
        let others = self.others().await?;
        if !others.is_empty() {
            return Err(not_alone(&others));
        }
        self.here.line = LineSetting::can(rate);
        if old != raw {
            let then = Then::Perhaps(Change::Rate(rate));
            self.legs.push(Leg { param: self.row(Role::BusRate)?, old: Some(old), raw, then });
        }
        Ok(())
    }

    /// Asks a node that is there perhaps; who answers is heard, also late.
    async fn calls(&mut self, station: u8) -> Result<(), Failure> {
        let once = Limits { retries: 0, reply_timeout: PACE, ..self.session.limits() };
        match self.session.ask_within(station, Request::Upload(NODE), once).await {
            Err(error) if error.is_fatal() => Err(error.failure(self.target.address, None)),
            _ => Ok(()),
        }
    }

    /// Waits for what a master says by itself, and for what comes late.
    async fn listen(&mut self) -> Result<(), Failure> {
        let rest = self.session.limits().reply_timeout;
        self.session.rest(rest).await.map_err(|error| error.failure(self.target.address, None))
    }

    /// Who else is on the bus, as far as anybody shows himself: everybody is asked, and what is heard late counts as well.
    async fn others(&mut self) -> Result<String, Failure> {
        let own = self.target.address;
        for station in (1..=LAST_DRIVE).chain([MASTER_STATION]).filter(|station| *station != own) {
            self.calls(station).await?;
        }
        self.listen().await?;
        let traffic = self.session.traffic().unwrap_or_default();
        let name = |station: &u8| if *station == MASTER_STATION { "master".to_owned() } else { station.to_string() };
        let mut others: Vec<String> = traffic.nodes.keys().filter(|station| **station != own).map(name).collect();
        if traffic.has_master && !others.iter().any(|other| other == "master") {
            others.push("master".to_owned());
        }
        Ok(others.join(", "))
    }
}
