//! Keeping a line while something else is waited for, and opening it anew.

use super::Session;
use crate::drive::access::AccessError;
use crate::drive::open_line::OpenLine;
use crate::tick::Span;

impl<'a> Session<'a> {
    /// Waits for something that is not on the line, such as the answer to a question, and keeps the line meanwhile: what
    /// comes is nobody's answer. Ends early with an error if somebody interrupts, also in the same moment, or if the port
    /// is lost. The time of the bench stands still.
    pub async fn during<T>(&mut self, wait: impl Future<Output = T>) -> Result<T, AccessError> {
        let interrupt = self.interrupt.clone();
        let virtual_time = self.bench().is_some();
        let keep = async {
            loop {
                match virtual_time {
                    true => interrupt.raised().await,
                    false => self.rest(Span::from_secs(60)).await?,
                }
                if interrupt.is_raised() {
                    return Err(AccessError::Interrupted);
                }
            }
        };
        let waited = tokio::select! {
            biased;
            waited = wait => waited,
            failed = keep => failed?,
        };
        if self.interrupt.is_raised() { Err(AccessError::Interrupted) } else { Ok(waited) }
    }

    /// Opens a port that was lost anew; its clock goes on. Then listens for as long as a reply may take, so that what
    /// was on its way to a lost question is nobody's answer.
    pub async fn reopen(&mut self) -> Result<(), AccessError> {
        let interrupt = self.interrupt.clone();
        let reopen = async |line: &mut OpenLine<'a>| line.link.reopen().await;
        tokio::select! {
            reopened = self.on_line(reopen) => reopened?,
            () = interrupt.raised() => return Err(AccessError::Interrupted),
        }
        if let Some(name) = self.line.borrow().link.name() {
            name.clone_into(&mut self.port);
        }
        self.rest(self.limits().reply_timeout).await
    }
}
