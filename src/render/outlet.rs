//! A stream whose reader may stop reading while a shaft turns: what is written waits in a queue, and a thread of its own
//! hands it on. Nobody who writes here ever waits.

use std::io::{self, Write};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// Most bytes that wait for the reader. What comes then is left out, and how much it was is told.
const ROOM: usize = 1 << 20;
/// Bytes that are handed on at a time.
const PIECE: usize = 4096;

/// The writing end; every clone writes into the same queue.
#[derive(Clone, Debug)]
pub struct Outlet {
    shared: Arc<Shared>,
}

#[derive(Debug, Default)]
struct Shared {
    queue: Mutex<Queue>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Queue {
    waiting: Vec<u8>,
    /// A piece is on its way to the reader.
    on_its_way: bool,
    /// Pieces that the reader has taken.
    taken: u64,
    /// Writes that found no room.
    left_out: usize,
    /// The reader has gone away.
    broken: bool,
}

impl Outlet {
    /// Begins to hand on to `to`, in a thread that ends with the program.
    pub fn new(to: impl Write + Send + 'static) -> Self {
        let shared = Arc::<Shared>::default();
        let outlet = Outlet { shared: shared.clone() };
        thread::spawn(move || {
            write_from_the_background();
            shared.hand_on(to);
        });
        outlet
    }

    /// Waits until everything is out: as long as it takes, or until the reader has taken nothing for as long as this.
    pub fn drain(&self, patience: Option<Duration>) {
        let mut queue = self.shared.lock();
        while !(queue.broken || queue.waiting.is_empty() && !queue.on_its_way) {
            let taken = queue.taken;
            let step = patience.unwrap_or(Duration::MAX);
            let waited = self.shared.changed.wait_timeout(queue, step).unwrap_or_else(PoisonError::into_inner);
            if waited.1.timed_out() && waited.0.taken == taken {
                return;
            }
            queue = waited.0;
        }
    }
}

/// Lets this thread write to the terminal also as a job in the background (`stty tostop`): it would be stopped for it, and with
/// it whatever holds a shaft. Heard and answered with a text, the signal would come again for ever.
pub fn write_from_the_background() {
    #[cfg(unix)]
    {
        let mut signals = nix::sys::signal::SigSet::empty();
        signals.add(nix::sys::signal::Signal::SIGTTOU);
        let _cannot_be_had = signals.thread_block();
    }
}

impl Write for Outlet {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut queue = self.shared.lock();
        if queue.broken {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        if queue.left_out > 0 && queue.waiting.len() < ROOM / 2 {
            let told = format!("(… {} messages left out / Meldungen ausgelassen …)\n", queue.left_out);
            queue.waiting.extend_from_slice(told.as_bytes());
            queue.left_out = 0;
        }
        match queue.left_out == 0 && queue.waiting.len() + bytes.len() <= ROOM {
            true => queue.waiting.extend_from_slice(bytes),
            false => queue.left_out += 1,
        }
        self.shared.changed.notify_all();
        Ok(bytes.len())
    }

    /// Waits until the reader has taken everything.
    fn flush(&mut self) -> io::Result<()> {
        self.drain(None);
        Ok(())
    }
}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn hand_on(&self, mut to: impl Write) {
        loop {
            let mut queue = self.lock();
            while queue.waiting.is_empty() {
                queue = self.changed.wait(queue).unwrap_or_else(PoisonError::into_inner);
            }
            let end = queue.waiting.len().min(PIECE);
            let piece: Vec<u8> = queue.waiting.drain(..end).collect();
            queue.on_its_way = true;
            drop(queue);
            let written = to.write_all(&piece).and_then(|()| to.flush());
            let mut queue = self.lock();
            queue.on_its_way = false;
            queue.taken += 1;
            queue.broken = written.is_err();
            self.changed.notify_all();
            if queue.broken {
                return;
            }
        }
    }
}
