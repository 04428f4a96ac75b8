//! Carries out a conversation on a link: the only loop between `exchange` and `transport`.

use super::interrupt::Interrupt;
use crate::exchange::{Conversation, ExchangeError, Master, Step};
use crate::tick::Tick;
use crate::transport::{Link, LinkError, Wake};

/// Why a conversation did not come to its end.
#[derive(Debug, thiserror::Error)]
pub(super) enum PumpError {
    #[error(transparent)]
    Link(#[from] LinkError),
    #[error("interrupted")]
    Interrupted,
    /// The time that was set for it is over; what came of the question by then.
    #[error("time is up: {0}")]
    TimeUp(ExchangeError),
}

/// Waits on the line without a question; what comes is nobody's answer.
pub(super) async fn rest(
    master: &mut Master,
    link: &mut Link,
    interrupt: &Interrupt,
    until: Tick,
) -> Result<(), PumpError> {
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

/// So many chunks are taken before a question, however much more is there: a flood must not hold it up.
const MOST_STALE: usize = 64;

/// Takes what is there already without waiting: bytes that the driver kept while nobody listened are nobody's answer.
pub(super) async fn drain(master: &mut Master, link: &mut Link) -> Result<(), PumpError> {
    for _ in 0..MOST_STALE {
        match link.wait(link.now()).await? {
            Wake::Bytes(bytes) => master.feed(link.now(), &bytes),
            Wake::Silence => return Ok(()),
        }
    }
    Ok(())
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

/// Runs a conversation until it has something to tell, or the time is over at which it ends in any case.
pub(super) async fn run<C: Conversation>(
    conversation: &mut C,
    link: &mut Link,
    interrupt: &Interrupt,
    ends_at: Option<Tick>,
) -> Result<C::End, PumpError> {
    loop {
        // Gives the signal handlers a turn, also on the bench, where nothing ever waits.
        tokio::task::yield_now().await;
        if interrupt.is_raised() {
            return Err(PumpError::Interrupted);
        }
        match conversation.step(link.now()) {
            Step::Done(outcome) => return Ok(outcome),
            _ if ends_at.is_some_and(|at| link.now() >= at) => {
                return Err(PumpError::TimeUp(ExchangeError::NoTime { asked: 0 }));
            }
            Step::Send(bytes) => link.send(&bytes).await?,
            Step::Wait(until) => {
                let until = ends_at.map_or(until, |at| until.min(at));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exchange::Limits;
    use crate::protocol::line::{LineSetting, Parity};
    use crate::protocol::modbus::{Framing, rtu};
    use crate::transport::Rs485;
    use std::io::Write;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the bytes really lie in the system's buffer")]
    fn what_the_driver_kept_is_taken_before_a_question() {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        runtime.block_on(async {
            let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
            let port = format!("tcp://{}", listener.local_addr().unwrap()).parse().unwrap();
            let line = LineSetting::rtu(19_200, Parity::Even);
            let mut link = Link::open(&port, line, Rs485::default()).await.unwrap();
            let (mut server, _) = listener.accept().unwrap();
            server.write_all(&rtu::encode(1, &[3, 2, 0, 1])).unwrap();
            std::thread::sleep(std::time::Duration::from_millis(50));
            let mut master = Master::new(Framing::Rtu.into(), line, Limits::default());
            drain(&mut master, &mut link).await.unwrap();
            assert_eq!(master.tally().strays, 1);
        });
    }
}
