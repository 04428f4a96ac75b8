//! A drive on a line: what is known of it in this run, and the way to it.

use super::access::AccessError;
use super::route::{Cell, Content, Inquiry, Route};
use super::session::Session;
use crate::exchange::ExchangeError;
use crate::profile::{Family, Param, Role, Type};
use crate::protocol::modbus::pdu::WordOrder;
use crate::protocol::modbus::{BROADCAST, Framing};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// A drive on the line.
#[derive(Debug)]
pub struct Target {
    /// Address of the drive; 0 is everybody.
    pub address: u8,
    /// What it is.
    pub family: Rc<Family>,
    /// Which half of a value in two registers comes first, once it is known or given.
    pub order: Option<WordOrder>,
    /// It refused the code that writes and reads back in one exchange.
    pub(super) lacks_exchange: bool,
    /// It was asked for something whose answer cannot be mistaken.
    pub(super) introduced: bool,
    /// What it refused to tell together with its neighbours: each is asked for alone.
    pub(super) apart: Vec<u32>,
    /// Widths that were found out by asking, for this run.
    pub(super) widths: BTreeMap<u32, Type>,
    /// Parameters whose width neither anybody has told nor the line tells.
    pub(super) unstated: BTreeSet<u32>,
    /// What the error register held before identifying the drive could overwrite it, or why nobody knows that any more.
    pub(super) kept_register: Option<Result<u16, ExchangeError>>,
    /// It refused a question while it was recognised, which is its last synchronous error now.
    pub refused_on_the_way: bool,
    /// The drive's watchdog in seconds, as it was read last.
    pub(super) known_watchdog: Option<i64>,
}

impl Target {
    /// A drive of a known family.
    pub fn new(address: u8, family: Rc<Family>) -> Self {
        Target {
            address,
            family,
            order: None,
            lacks_exchange: false,
            introduced: false,
            apart: Vec::new(),
            widths: BTreeMap::new(),
            unstated: BTreeSet::new(),
            kept_register: None,
            refused_on_the_way: false,
            known_watchdog: None,
        }
    }

    /// The same with the word order that somebody gave, if any.
    #[must_use]
    pub fn in_word_order(self, order: Option<WordOrder>) -> Self {
        Target { order, ..self }
    }

    /// The same, as one that was greeted before in this run.
    #[must_use]
    pub fn greeted(self) -> Self {
        Target { introduced: true, ..self }
    }

    /// The way to this drive on the line of the session. Before the first question it is greeted.
    pub async fn route(&mut self, session: &mut Session<'_>) -> Result<Route, AccessError> {
        let usual = Route::new(session.protocol(), &self.family.link, self.address);
        let mut route = Route { node: session.node(), order: self.order.unwrap_or(usual.order), ..usual };
        session.knows(self.address, &self.family, route.order);
        if self.address == BROADCAST {
            return Ok(route);
        }
        if self.order.is_none()
            && let Some(setting) = self.family.clone().role(Role::WordOrder)
        {
            route.order = self.order_in_force(session, route, setting).await?;
            self.order = Some(route.order);
            session.knows(self.address, &self.family, route.order);
        }
        // Behind the word order, so that nothing is asked that it refuses.
        self.greet(session, route).await?;
        Ok(route)
    }

    /// Which half of a value in two registers comes first: told by the address, which is never 0 and so proves the order in
    /// force. The setting of the order proves it only if it is not 0, and may hold from the next power-on.
    async fn order_in_force(
        &self,
        session: &mut Session<'_>,
        route: Route,
        setting: &Param,
    ) -> Result<WordOrder, AccessError> {
        for param in self.family.role(Role::Address).into_iter().chain([setting]) {
            let cell = Cell { number: param.id, set: 0 };
            let question = route.question(Inquiry::Read(cell, Type::Long)).ok_or(AccessError::Unspeakable)?;
            let answer = match session.demand(route, &self.family, question).await {
                Err(AccessError::Refused(_)) => None,
                answer => answer?,
            };
            let content = answer.and_then(|(said, _)| route.content(&said));
            if let Some(order) = content.and_then(|content| order_told(param, &content)) {
                return Ok(order);
            }
        }
        // Without an answer that tells, the factory setting is presumed.
        Ok(WordOrder::default())
    }

    /// Asks a drive that somebody named, and that was not recognised, for a counter, once: it touches nothing in the drive,
    /// and its answer cannot be mistaken. Where two drives answer at the address, the second answer is the sign of it,
    /// before any value is believed; it may meet the next question, so behind the first value a second one is listened for.
    /// (Not behind the greeting: two drives alike would count the same.) Whoever does not know counters is asked for the
    /// value all the same. A stop greets nobody, and behind a gateway every answer names its question.
    async fn greet(&mut self, session: &mut Session<'_>, route: Route) -> Result<(), AccessError> {
        if self.introduced || session.is_insisting() {
            return Ok(());
        }
        self.introduced = true;
        if route.protocol == Framing::Tcp.into() {
            return Ok(());
        }
        let counter = self.family.counters.first();
        if let Some(question) = counter.and_then(|counter| route.question(Inquiry::Counter(counter.sub))) {
            match session.hail(self.address, question).await {
                Err(error @ AccessError::Exchange(ExchangeError::TwoAnswers { .. })) => return Err(error),
                Ok(_) | Err(AccessError::Exchange(_)) => {}
                Err(error) => return Err(error),
            }
        }
        session.listen();
        Ok(())
    }
}

/// The word order that a value of a small parameter proves, read with the upper half first; 0 proves nothing.
fn order_told(param: &Param, content: &Content) -> Option<WordOrder> {
    let Content::Bits(bits, _) = content else { return None };
    let fits = |half: u32| half != 0 && param.max.is_none_or(|max| i64::from(half) <= max);
    match (bits >> 16, bits & 0xFFFF) {
        (0, low) if fits(low) => Some(WordOrder::HighFirst),
        (high, 0) if fits(high) => Some(WordOrder::LowFirst),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drive::route::Width;
    use crate::profile::Registry;

    #[test]
    fn the_address_proves_the_word_order_in_force_and_a_setting_of_0_proves_nothing() {
        let family = Registry::open(&[]).unwrap().family("lxm05").unwrap();
        let told = |role, bits| order_told(family.role(role).unwrap(), &Content::Bits(bits, Width::AsAsked));
        assert_eq!(told("address", 0x0000_0001), Some(WordOrder::HighFirst));
        assert_eq!(told("address", 0x00F7_0000), Some(WordOrder::LowFirst));
        assert_eq!(told("word-order", 0x0001_0000), Some(WordOrder::LowFirst));
        for (role, bits) in [("word-order", 0), ("address", 0), ("address", 0x00F8_0000), ("address", 0x0001_0001)] {
            assert_eq!(told(role, bits), None, "{role} {bits:08X}");
        }
    }
}
