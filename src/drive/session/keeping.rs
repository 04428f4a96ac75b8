//! Keeping a line while something else is waited for, and opening it anew.

use super::Session;
use crate::drive::access::AccessError;
use crate::drive::can;
use crate::drive::open_line::OpenLine;
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::Framing;
use crate::tick::{Span, Tick};
use std::pin::pin;

/// What is waited for away from a paced bench leaves its clock so far behind at most.
const STEP: Span = Span::from_millis(20);

impl<'a> Session<'a> {
    /// Waits for something that is not on the line, such as the answer to a question, and keeps the line meanwhile: what
    /// comes is nobody's answer. Ends early with an error if somebody interrupts, also in the same moment, or if the port
    /// is lost. A bench that follows the wall clock goes on meanwhile; the time of any other one stands still.
    pub async fn during<T>(&mut self, wait: impl Future<Output = T>) -> Result<T, AccessError> {
        // Without a moment there is no other end.
        self.during_until(wait, None).await?.ok_or(AccessError::Interrupted)
    }

    /// The same, until a moment at most; then `None`. Where the time stands still, the moment does not come.
    pub async fn during_until<T>(
        &mut self,
        wait: impl Future<Output = T>,
        until: Option<Tick>,
    ) -> Result<Option<T>, AccessError> {
        let stands = self.line.borrow().link.stands_still();
        let mut wait = pin!(wait);
        while until.is_none_or(|until| self.now() < until) {
            let step = until.map_or(STEP, |until| until.since(self.now()).min(STEP));
            let interrupt = self.interrupt.clone();
            let keep = async {
                match stands {
                    true => interrupt.raised().await,
                    false => self.rest(step).await?,
                }
                Ok::<(), AccessError>(())
            };
            let waited = tokio::select! {
                biased;
                waited = &mut wait => Some(waited),
                kept = keep => kept.map(|()| None)?,
            };
            if self.interrupt.is_raised() {
                return Err(AccessError::Interrupted);
            }
            if waited.is_some() {
                return Ok(waited);
            }
        }
        Ok(None)
    }

    /// Other speed, format or protocol from now on; on a CAN bus another channel or bit rate.
    pub async fn retune(&mut self, protocol: Protocol, line: LineSetting) -> Result<(), AccessError> {
        let (heard, interrupt) = (self.heard.clone().unwrap_or_default(), self.interrupt.clone());
        let retune = async |on: &mut OpenLine<'a>| {
            let Protocol::Sdo(channel) = protocol else {
                on.link.set_line(line).await?;
                on.master.retune(protocol, line, on.link.now());
                return Ok(());
            };
            let rate = (on.master.line() != line).then_some(line.baud);
            on.master.retune(protocol, line, on.link.now());
            can::retune(&mut on.link, channel, rate, &heard, &interrupt).await
        };
        self.on_line(retune).await
    }

    /// Opens a port that was lost anew; its clock goes on. Then listens for as long as a reply may take, so that what
    /// was on its way to a lost question is nobody's answer; over Modbus/TCP that is gone with its connection.
    pub async fn reopen(&mut self) -> Result<(), AccessError> {
        let interrupt = self.interrupt.clone();
        let (bus, ends) = (self.protocol(), interrupt.clone());
        let reopen = async |line: &mut OpenLine<'a>| match bus {
            Protocol::Sdo(channel) => can::reopen(&mut line.link, line.master.line().baud, channel, &ends).await,
            _ => Ok(line.link.reopen().await?),
        };
        tokio::select! {
            reopened = self.on_line(reopen) => reopened?,
            () = interrupt.raised() => {
                if matches!(bus, Protocol::Sdo(_)) {
                    can::close(&mut self.line.borrow_mut().link);
                }
                return Err(AccessError::Interrupted);
            }
        }
        if let Some(name) = self.line.borrow().link.name() {
            name.clone_into(&mut self.port);
        }
        match self.protocol() {
            Protocol::Modbus(Framing::Tcp) => Ok(()),
            _ => self.rest(self.limits().reply_timeout).await,
        }
    }
}
