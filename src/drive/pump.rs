//! Carries out a conversation on a link: the only loop between `exchange` and `transport`.

use super::interrupt::Interrupt;
use crate::exchange::{Conversation, Master, Step};
use crate::tick::{Span, Tick};
use crate::transport::{Link, LinkError, Wake};

/// Why a conversation did not come to its end.
#[derive(Debug, thiserror::Error)]
pub(super) enum PumpError {
    #[error(transparent)]
    Link(#[from] LinkError),
    #[error("interrupted")]
    Interrupted,
}

/// Waits on the line without a question; what comes is nobody's answer.
pub(super) async fn rest(
    master: &mut Master,
    link: &mut Link,
    interrupt: &Interrupt,
    span: Span,
) -> Result<(), PumpError> {
    let until = link.now() + span;
    loop {
        match hear(link, interrupt, until).await? {
            Wake::Bytes(bytes) => master.feed(link.now(), &bytes),
            Wake::Silence => return Ok(()),
        }
        if link.now() >= until {
            return Ok(()); // bytes that come all the time do not prolong it
        }
    }
}

/// Waits until bytes come or the time is over.
pub(super) async fn hear(link: &mut Link, interrupt: &Interrupt, until: Tick) -> Result<Wake, PumpError> {
    // Gives the signal handlers a turn, also on the bench, where nothing ever waits.
    tokio::task::yield_now().await;
    if interrupt.is_raised() {
        return Err(PumpError::Interrupted);
    }
    tokio::select! {
        wake = link.wait(until) => Ok(wake?),
        () = interrupt.raised() => Err(PumpError::Interrupted),
    }
}

/// Runs a conversation until it has something to tell.
pub(super) async fn run<C: Conversation>(
    conversation: &mut C,
    link: &mut Link,
    interrupt: &Interrupt,
) -> Result<C::End, PumpError> {
    loop {
        // Gives the signal handlers a turn, also on the bench, where nothing ever waits.
        tokio::task::yield_now().await;
        if interrupt.is_raised() {
            return Err(PumpError::Interrupted);
        }
        match conversation.step(link.now()) {
            Step::Done(outcome) => return Ok(outcome),
            Step::Send(bytes) => link.send(&bytes).await?,
            Step::Wait(until) => {
                let wake = tokio::select! {
                    wake = link.wait(until) => wake?,
                    () = interrupt.raised() => return Err(PumpError::Interrupted),
                };
                if let Wake::Bytes(bytes) = wake {
                    conversation.feed(link.now(), &bytes);
                }
            }
        }
    }
}
