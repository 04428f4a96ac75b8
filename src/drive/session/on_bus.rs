//! What a session does on a CAN bus besides asking: it hears frames, and tells nodes something as master of the network.

use super::Session;
use crate::drive::access::AccessError;
use crate::drive::open_line::OpenLine;
use crate::protocol::can::Frame;
use crate::protocol::can::nmt::Order;
use crate::protocol::can::slcan::Word;
use crate::tick::{Span, Tick};

/// How long an adapter gets to tell how the bus is.
const ANSWER: Span = Span::from_millis(300);

impl<'a> Session<'a> {
    /// The frames that come until a moment, as soon as there are any, on a bus that is only listened to.
    pub(in crate::drive) async fn frames(&mut self, until: Tick) -> Result<Vec<Frame>, AccessError> {
        self.hear(until).await?;
        Ok(self.heard_frames().unwrap_or_default())
    }

    /// The frames that were heard and not taken yet; `None` on what is no bus that is only listened to.
    pub(in crate::drive) fn heard_frames(&self) -> Option<Vec<Frame>> {
        self.ears.as_ref().map(|ear| ear.borrow_mut().frames.drain(..).collect())
    }

    /// Frames that came faster than they were taken.
    pub(in crate::drive) fn frames_lost(&self) -> u64 {
        self.ears.as_ref().map_or(0, |ear| ear.borrow().lost)
    }

    /// What the adapter said that is no word, and was not taken yet.
    pub(in crate::drive) fn damaged_words(&self) -> Vec<Vec<u8>> {
        self.ears.as_ref().map_or_else(Vec::new, |ear| ear.borrow_mut().damaged.drain(..).collect())
    }

    /// The status flags of the adapter, if it tells them and they tell of errors.
    pub(in crate::drive) async fn bus_errors(&mut self) -> Result<Option<u8>, AccessError> {
        Ok(self.bus_flags().await?.filter(|flags| flags & Word::ERRORS != 0))
    }

    /// Whether the adapter itself tells that it lost frames; whoever interrupted waits for that.
    pub(in crate::drive) async fn was_overrun(&mut self) -> bool {
        self.note_interrupts();
        self.bus_flags().await.ok().flatten().is_some_and(|flags| flags & Word::OVERRUNS != 0)
    }

    async fn bus_flags(&mut self) -> Result<Option<u8>, AccessError> {
        let ask = async |line: &mut OpenLine<'a>| line.link.send(&[]).await;
        self.on_line(ask).await?;
        let until = self.now() + ANSWER;
        let told = |session: &Self| session.ears.as_ref().and_then(|ear| ear.borrow_mut().flags.take());
        loop {
            // Frames go on coming, and each of them ends the wait.
            self.hear(until).await?;
            match told(self) {
                None if self.now() < until => {}
                flags => return Ok(flags),
            }
        }
    }

    /// Fault keys that a station told by itself since the bus was opened, 0 for one that was acknowledged.
    pub fn emergencies(&self, station: u8) -> Vec<u16> {
        let traffic = self.traffic().unwrap_or_default();
        let own = traffic.emergencies.iter().filter(|row| row.0 == station);
        own.map(|(_, told)| told.fault).collect()
    }

    /// Tells nodes something as master of the network. Nobody answers that.
    pub(in crate::drive) async fn order(&mut self, order: Order) -> Result<(), AccessError> {
        let order = async |line: &mut OpenLine<'a>| line.say(&order.telegram()).await;
        Ok(self.on_line(order).await?)
    }

    /// What was heard of nodes so far counts no more.
    pub(in crate::drive) fn forget_nodes(&self) {
        if let Some(heard) = &self.heard {
            heard.borrow_mut().nodes.clear();
        }
    }
}
