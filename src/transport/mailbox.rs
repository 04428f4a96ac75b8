//! A link to somebody who works beside us in the same thread and has a line of his own, such as whoever keeps a slave of PROFIBUS going:
//! what is sent lies there until he takes it, what he puts there is the answer, and his time is that of the link.

use super::{LinkError, Wake};
use crate::text::Text;
use crate::tick::Tick;
use std::fmt;
use std::future::poll_fn;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll, Waker};

/// What lies between the two. Each has a clone of it.
#[derive(Clone, Debug)]
pub struct Mailbox {
    name: String,
    shared: Arc<Mutex<Shared>>,
}

#[derive(Debug)]
struct Shared {
    now: Tick,
    question: Option<Vec<u8>>,
    answer: Option<Vec<u8>>,
    /// So many wait on the link.
    waiting: usize,
    lost: Option<Loss>,
    sleepers: Vec<Waker>,
}

/// Why nobody answers any more.
#[derive(Clone, Debug)]
enum Loss {
    /// The port of who answers is gone.
    Port,
    /// Whoever should answer is, and why.
    Drive(Text),
}

impl Shared {
    fn wakes(&mut self) {
        self.sleepers.drain(..).for_each(Waker::wake);
    }

    fn sleeps<T>(&mut self, context: &Context<'_>) -> Poll<T> {
        self.sleepers.push(context.waker().clone());
        Poll::Pending
    }
}

impl Mailbox {
    /// Nothing lies in it yet. `name` is the port of who answers.
    pub fn new(name: String, now: Tick) -> Self {
        let shared = Shared { now, question: None, answer: None, waiting: 0, lost: None, sleepers: Vec::new() };
        Mailbox { name, shared: Arc::new(Mutex::new(shared)) }
    }

    /// What is asked, if anything is; it is asked once.
    pub fn take(&self) -> Option<Vec<u8>> {
        self.open().question.take()
    }

    /// The answer to what was taken; nobody's where something else is asked by now.
    pub fn put(&self, answer: Vec<u8>) {
        let mut shared = self.open();
        if shared.question.is_none() {
            shared.answer = Some(answer);
        }
        shared.wakes();
    }

    /// So late it is.
    pub fn passes(&self, now: Tick) {
        let mut shared = self.open();
        shared.now = now;
        shared.wakes();
    }

    /// The port of who answers is gone.
    pub fn lose(&self) {
        self.loses(Loss::Port);
    }

    /// Whoever should answer does not any more, though the port is there.
    pub fn fall_silent(&self, why: Text) {
        self.loses(Loss::Drive(why));
    }

    fn loses(&self, loss: Loss) {
        let mut shared = self.open();
        shared.lost = Some(loss);
        shared.wakes();
    }

    /// Waits until something is asked, or somebody waits for the time to pass.
    pub async fn wanted(&self) {
        poll_fn(|context| {
            let mut shared = self.open();
            let is_wanted = shared.question.is_some() || shared.waiting > 0;
            if is_wanted { Poll::Ready(()) } else { shared.sleeps(context) }
        })
        .await;
    }

    pub(super) fn now(&self) -> Tick {
        self.open().now
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn send(&self, bytes: &[u8]) -> Result<(), LinkError> {
        let mut shared = self.open();
        if let Some(loss) = &shared.lost {
            return Err(self.lost(loss));
        }
        (shared.question, shared.answer) = (Some(bytes.to_vec()), None);
        shared.wakes();
        Ok(())
    }

    pub(super) async fn wait(&self, until: Tick) -> Result<Wake, LinkError> {
        let _waits = Waits::on(self);
        poll_fn(|context| {
            let mut shared = self.open();
            match (shared.answer.take(), &shared.lost) {
                (Some(answer), _) => Poll::Ready(Ok(Wake::Bytes(answer))),
                (None, Some(loss)) => Poll::Ready(Err(self.lost(loss))),
                (None, None) if shared.now >= until => Poll::Ready(Ok(Wake::Silence)),
                (None, None) => shared.sleeps(context),
            }
        })
        .await
    }

    fn open(&self) -> MutexGuard<'_, Shared> {
        self.shared.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn lost(&self, loss: &Loss) -> LinkError {
        match loss {
            Loss::Port => LinkError::Lost(self.name.clone()),
            Loss::Drive(why) => LinkError::Gone { port: self.name.clone(), why: why.clone() },
        }
    }
}

/// Somebody waits as long as this is held.
struct Waits<'m>(&'m Mailbox);

impl<'m> Waits<'m> {
    fn on(mailbox: &'m Mailbox) -> Self {
        let mut shared = mailbox.open();
        shared.waiting += 1;
        shared.wakes();
        drop(shared);
        Waits(mailbox)
    }
}

impl Drop for Waits<'_> {
    fn drop(&mut self) {
        self.0.open().waiting -= 1;
    }
}

impl PartialEq for Mailbox {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.shared, &other.shared)
    }
}

impl Eq for Mailbox {}

impl fmt::Display for Mailbox {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}
