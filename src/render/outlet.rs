//! A stream whose reader may stop reading while a shaft turns: what is written waits in a queue, and a thread of its own
//! hands it on. Nobody who writes here ever waits.

use std::io::{self, Write};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError};
use std::thread;
use std::time::Duration;

/// Most bytes that wait for the reader. What comes then is left out, and how much it was is told.
const ROOM: usize = 1 << 20;
/// Bytes that are handed on at a time.
const PIECE: usize = 4096;

/// How long a reader is waited for that takes nothing: for ever, as any program does, until that is limited. All clones are one.
#[derive(Clone, Debug, Default)]
pub struct Patience {
    most: Arc<OnceLock<Duration>>,
}

impl Patience {
    /// From now on no longer than this; the first one counts.
    pub fn limit(&self, most: Duration) {
        self.most.get_or_init(|| most);
    }
}

/// The writing end; every clone writes into the same queue.
#[derive(Clone, Debug)]
pub struct Outlet {
    shared: Arc<Shared>,
    patience: Patience,
    /// Most bytes that wait.
    room: usize,
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
    /// That something was left out is not told among what is written.
    lossy: bool,
    /// The reader has gone away, or nothing can be written.
    broken: Option<io::Error>,
    /// It was waited for in vain: it is waited for no more.
    given_up: bool,
}

impl Outlet {
    /// Begins to hand on to `to`, in a thread that ends with the program.
    pub fn new(to: impl Write + Send + 'static, patience: Patience) -> Self {
        let shared = Arc::<Shared>::default();
        let outlet = Outlet { shared: shared.clone(), patience, room: ROOM };
        thread::spawn(move || {
            write_from_the_background();
            shared.hand_on(to);
        });
        outlet
    }

    /// stdout for data that nobody waits for: what is left out is not told among it.
    pub fn of_stdout(patience: Patience) -> Self {
        let outlet = Self::new(Unbuffered, patience);
        outlet.shared.lock().lossy = true;
        outlet
    }

    /// The writing end once more, on which not even flushing waits for the reader.
    pub fn at_once(&self) -> AtOnce {
        AtOnce(self.clone())
    }

    /// Whether the reader has taken everything.
    pub fn is_idle(&self) -> bool {
        let queue = self.shared.lock();
        queue.broken.is_some() || queue.waiting.is_empty() && !queue.on_its_way
    }

    /// Waits until everything is out: as long as it takes, or until the reader has taken nothing for as long as this.
    pub fn drain(&self, patience: Option<Duration>) {
        let mut queue = self.shared.lock();
        while (queue.on_its_way || !queue.waiting.is_empty()) && !queue.given_up && queue.broken.is_none() {
            let taken = queue.taken;
            let step = patience.unwrap_or(Duration::MAX);
            let waited = self.shared.changed.wait_timeout(queue, step).unwrap_or_else(PoisonError::into_inner);
            queue = waited.0;
            queue.given_up |= waited.1.timed_out() && queue.taken == taken;
        }
    }
}

/// stdout. It is written to as any program does it, so that a slow reader slows us down and loses nothing; but where
/// patience has an end, what is written goes through an [`Outlet`], and the reader who takes nothing loses it.
#[derive(Debug)]
pub struct Stdout {
    plain: io::Stdout,
    patience: Patience,
    outlet: Option<Outlet>,
}

impl Stdout {
    /// Waits for its reader as this says.
    pub fn new(patience: Patience) -> Self {
        Stdout { plain: io::stdout(), patience, outlet: None }
    }

    fn to(&mut self) -> &mut dyn Write {
        if self.outlet.is_none() && self.patience.most.get().is_some() {
            let outlet = Outlet::new(Unbuffered, self.patience.clone());
            self.outlet = Some(Outlet { room: usize::MAX, ..outlet });
        }
        match &mut self.outlet {
            Some(outlet) => outlet,
            None => &mut self.plain,
        }
    }
}

impl Write for Stdout {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.to().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to().flush()
    }
}

/// stdout without the buffer that the end of the program would write out, and wait for.
#[derive(Debug)]
struct Unbuffered;

impl Write for Unbuffered {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        #[cfg(unix)]
        return Ok(rustix::io::write(rustix::stdio::stdout(), bytes)?);
        #[cfg(not(unix))]
        io::stdout().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        #[cfg(not(unix))]
        io::stdout().flush()?;
        Ok(())
    }
}

/// The same error once more.
fn again(error: &io::Error) -> io::Error {
    error.raw_os_error().map_or_else(|| error.kind().into(), io::Error::from_raw_os_error)
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

/// An [`Outlet`] that nobody waits for.
#[derive(Debug)]
pub struct AtOnce(Outlet);

impl Write for AtOnce {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Write for Outlet {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut queue = self.shared.lock();
        if let Some(error) = &queue.broken {
            return Err(again(error));
        }
        if queue.left_out > 0 && queue.waiting.len() < ROOM / 2 && !queue.lossy {
            let told = format!("(… {} messages left out / Meldungen ausgelassen …)\n", queue.left_out);
            queue.waiting.extend_from_slice(told.as_bytes());
            queue.left_out = 0;
        }
        if queue.lossy {
            queue.left_out = 0;
        }
        match queue.left_out == 0 && queue.waiting.len().saturating_add(bytes.len()) <= self.room {
            true => queue.waiting.extend_from_slice(bytes),
            false => queue.left_out += 1,
        }
        self.shared.changed.notify_all();
        Ok(bytes.len())
    }

    /// Waits until the reader has taken everything, as long as patience lasts.
    fn flush(&mut self) -> io::Result<()> {
        self.drain(self.patience.most.get().copied());
        let queue = self.shared.lock();
        match &queue.broken {
            Some(error) => Err(again(error)),
            None if queue.given_up => Err(io::ErrorKind::TimedOut.into()),
            None => Ok(()),
        }
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
            queue.broken = written.err();
            self.changed.notify_all();
            if queue.broken.is_some() {
                return;
            }
        }
    }
}
