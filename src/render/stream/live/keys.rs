//! The keys of a terminal that was taken over, and that it is gone.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

/// What a key is good for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// q, Escape: end.
    Quit,
    /// Ctrl-C, Ctrl-D, Ctrl-\: end, as the signal would.
    Interrupt,
    /// Space.
    Stop,
    /// Tab, right: the next drive.
    Next,
    /// Left: the drive before.
    Previous,
    /// Up.
    Up,
    /// Down.
    Down,
    /// Enter.
    Enter,
    /// d: the diagnosis.
    Diagnosis,
    /// The terminal has another size.
    Redraw,
    /// The terminal is gone.
    Gone,
}

/// The keys of a terminal, read by a thread of their own.
#[derive(Debug)]
pub struct Keys {
    coming: UnboundedReceiver<Key>,
    over: Arc<AtomicBool>,
}

/// What makes [`Keys`] listen, once the terminal is taken over.
#[derive(Debug)]
pub(in crate::render::stream) struct Ear {
    send: UnboundedSender<Key>,
    over: Arc<AtomicBool>,
}

impl Keys {
    /// Keys that come from when the ear listens on.
    pub(in crate::render::stream) fn new() -> (Self, Ear) {
        let (send, coming) = unbounded_channel();
        let over = Arc::<AtomicBool>::default();
        (Keys { coming, over: over.clone() }, Ear { send, over })
    }

    /// The next key; never comes where nobody listens any more.
    pub async fn next(&mut self) -> Key {
        match self.coming.recv().await {
            Some(key) => key,
            None => std::future::pending().await,
        }
    }
}

impl Drop for Keys {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
    }
}

/// So long the thread may outlive its listener, and the rest of a key may be on its way.
const LOOK: Duration = Duration::from_millis(50);

impl Ear {
    /// Listens until nobody wants to hear, or the terminal is gone, which is the last thing that is said.
    pub(super) fn listen(self) {
        thread::spawn(move || {
            let Ok(keyboard) = Keyboard::open() else { return };
            let mut typed = Typed::default();
            let mut size = None;
            while !self.over.load(Ordering::Relaxed) {
                let keys = match keyboard.arrived() {
                    Ok(None) => typed.pause().into_iter().collect(),
                    Ok(Some(bytes)) => typed.take(&bytes),
                    Err(_) => vec![Key::Gone],
                };
                let now = crate::render::terminal_size();
                let resized = size.replace(now).filter(|before| *before != now).map(|_| Key::Redraw);
                for key in keys.into_iter().chain(resized) {
                    if self.send.send(key).is_err() || key == Key::Gone {
                        return;
                    }
                }
            }
        });
    }
}

/// Where keys come from: stdin, or the terminal of this process where stdin is something else.
struct Keyboard {
    #[cfg(unix)]
    own: Option<std::fs::File>,
}

#[cfg(unix)]
impl Keyboard {
    fn open() -> io::Result<Self> {
        let is_terminal = io::IsTerminal::is_terminal(&rustix::stdio::stdin());
        Ok(Keyboard { own: if is_terminal { None } else { Some(std::fs::File::open("/dev/tty")?) } })
    }

    fn arrived(&self) -> io::Result<Option<Vec<u8>>> {
        match &self.own {
            Some(own) => arrived(std::os::fd::AsFd::as_fd(own)),
            None => arrived(rustix::stdio::stdin()),
        }
    }
}

#[cfg(not(unix))]
impl Keyboard {
    fn open() -> io::Result<Self> {
        Ok(Keyboard {})
    }

    fn arrived(&self) -> io::Result<Option<Vec<u8>>> {
        arrived()
    }
}

/// What was typed within a moment; `None`: nothing. A terminal that is gone is an error.
#[cfg(unix)]
fn arrived(input: rustix::fd::BorrowedFd<'_>) -> io::Result<Option<Vec<u8>>> {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    let mut watched = [PollFd::new(&input, PollFlags::IN)];
    let look = Timespec { tv_sec: 0, tv_nsec: i64::from(LOOK.subsec_nanos()) };
    match poll(&mut watched, Some(&look)) {
        Ok(0) => return Ok(None),
        // A signal is no pause: an ESC that has come may be the beginning of an arrow.
        Err(rustix::io::Errno::INTR) => return Ok(Some(Vec::new())),
        Ok(_) => {}
        Err(error) => return Err(error.into()),
    }
    let mut bytes = [0; 256];
    // Not by `io::stdin`, whose lock whoever waits for an answer may hold.
    match rustix::io::read(input, &mut bytes) {
        Ok(0) => Err(io::ErrorKind::UnexpectedEof.into()),
        Ok(count) => Ok(Some(bytes.get(..count).unwrap_or_default().to_vec())),
        Err(rustix::io::Errno::INTR | rustix::io::Errno::AGAIN) => Ok(Some(Vec::new())),
        Err(error) => Err(error.into()),
    }
}

#[cfg(not(unix))]
fn arrived() -> io::Result<Option<Vec<u8>>> {
    use ratatui::crossterm::event::{self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
    if !event::poll(LOOK)? {
        return Ok(None);
    }
    let Event::Key(KeyEvent { code, modifiers, kind: KeyEventKind::Press | KeyEventKind::Repeat, .. }) = event::read()?
    else {
        return Ok(None);
    };
    let bytes: &[u8] = match code {
        KeyCode::Char('c' | 'd') if modifiers.contains(KeyModifiers::CONTROL) => b"\x03",
        KeyCode::Char(letter) if letter.is_ascii() => return Ok(Some(vec![letter as u8])),
        KeyCode::Esc => b"q",
        KeyCode::Enter => b"\r",
        KeyCode::Tab => b"\t",
        KeyCode::Up => b"\x1b[A",
        KeyCode::Down => b"\x1b[B",
        KeyCode::Right => b"\x1b[C",
        KeyCode::Left => b"\x1b[D",
        _ => return Ok(None),
    };
    Ok(Some(bytes.to_vec()))
}

/// What is typed, as keys. A terminal sends arrows as ESC and more letters (ECMA-48 CSI; SS3 in "application mode"), which may
/// come in pieces; what is pasted stands between CSI 200~ and CSI 201~ and means nothing here.
#[derive(Debug, Default)]
struct Typed {
    /// The beginning of a sequence.
    begun: Vec<u8>,
    pasted: bool,
}

/// No sequence that means something here is longer; what is, is none.
const LONGEST: usize = 32;

impl Typed {
    fn take(&mut self, bytes: &[u8]) -> Vec<Key> {
        bytes.iter().filter_map(|&byte| self.byte(byte)).collect()
    }

    /// Nothing came for a moment: an ESC was the key, and a paste without an end is over. A key that stops must work again.
    fn pause(&mut self) -> Option<Key> {
        self.pasted = false;
        (std::mem::take(&mut self.begun) == [ESC]).then_some(Key::Quit)
    }

    fn byte(&mut self, byte: u8) -> Option<Key> {
        // It is no part of any sequence, and nobody pastes it.
        if let 0x03 | 0x04 | 0x1C = byte {
            self.begun.clear();
            return Some(Key::Interrupt);
        }
        match (self.begun.as_slice(), byte) {
            ([], ESC) => self.begun.push(byte),
            ([], _) => return plain(byte).filter(|_| !self.pasted),
            // ESC twice: the first was the key.
            ([ESC], ESC) => return Some(Key::Quit).filter(|_| !self.pasted),
            ([ESC], b'[' | b'O') => self.begun.push(byte),
            // Alt and a letter.
            ([ESC], _) => self.begun.clear(),
            ([_, b'['], _) | ([_, _, _, ..], _) if !is_last(byte) && self.begun.len() < LONGEST => {
                self.begun.push(byte)
            }
            (begun, last) => {
                let key = sequence(begun, last);
                match (begun, last) {
                    ([_, _, b'2', b'0', b'0'], b'~') => self.pasted = true,
                    ([_, _, b'2', b'0', b'1'], b'~') => self.pasted = false,
                    _ => {}
                }
                self.begun.clear();
                return key.filter(|_| !self.pasted);
            }
        }
        None
    }
}

const ESC: u8 = 0x1B;

/// ECMA-48 5.4: the final byte of a control sequence.
fn is_last(byte: u8) -> bool {
    (0x40..=0x7E).contains(&byte)
}

fn plain(byte: u8) -> Option<Key> {
    Some(match byte {
        b' ' => Key::Stop,
        b'q' | b'Q' => Key::Quit,
        b'd' | b'D' => Key::Diagnosis,
        b'\r' | b'\n' => Key::Enter,
        b'\t' => Key::Next,
        0x0C => Key::Redraw,
        _ => return None,
    })
}

fn sequence(begun: &[u8], last: u8) -> Option<Key> {
    // An arrow with Shift or Alt has numbers before its letter, and is none that is meant here.
    if begun.len() != 2 {
        return None;
    }
    Some(match last {
        b'A' => Key::Up,
        b'B' => Key::Down,
        b'C' => Key::Next,
        b'D' | b'Z' => Key::Previous,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys(typed: &mut Typed, text: &str) -> Vec<Key> {
        typed.take(text.as_bytes())
    }

    #[test]
    fn every_key_is_known_however_it_comes() {
        let mut typed = Typed::default();
        let all = [Key::Quit, Key::Stop, Key::Diagnosis, Key::Enter, Key::Interrupt, Key::Next, Key::Redraw];
        assert_eq!(keys(&mut typed, "q dx\r\u{3}\t\u{c}ä1"), all);
        let arrows = [Key::Up, Key::Down, Key::Next, Key::Previous, Key::Up, Key::Previous];
        assert_eq!(keys(&mut typed, "\u{1b}[A\u{1b}[B\u{1b}[C\u{1b}[D\u{1b}OA\u{1b}[Z"), arrows);
        let pieces: Vec<Key> = ["\u{1b}", "[", "A"].iter().flat_map(|piece| keys(&mut typed, piece)).collect();
        assert_eq!(pieces, [Key::Up]);
    }

    #[test]
    fn an_escape_alone_is_a_key_once_nothing_follows() {
        let mut typed = Typed::default();
        assert_eq!((keys(&mut typed, "\u{1b}"), typed.pause(), typed.pause()), (vec![], Some(Key::Quit), None));
        assert_eq!(keys(&mut typed, "\u{1b}\u{1b}[A"), [Key::Quit, Key::Up]);
    }

    #[test]
    fn what_is_no_key_of_ours_means_nothing_and_swallows_nothing() {
        let mut typed = Typed::default();
        let noise = "\u{1b}[1;5A\u{1b}[15~\u{1b}[?2004h\u{1b}OP\u{1b}x\u{1b}[<0;1;2M";
        assert_eq!(keys(&mut typed, noise), []);
        assert_eq!(keys(&mut typed, " "), [Key::Stop]);
        let endless = format!("\u{1b}[{}", "1".repeat(500));
        keys(&mut typed, &endless);
        typed.pause();
        assert_eq!(keys(&mut typed, " q"), [Key::Stop, Key::Quit]);
    }

    #[test]
    fn what_is_pasted_means_nothing_but_for_ctrl_c() {
        let mut typed = Typed::default();
        assert_eq!(keys(&mut typed, "\u{1b}[200~q d\u{1b}[A\r\u{3}\u{1b}[201~"), [Key::Interrupt]);
        assert_eq!(keys(&mut typed, " "), [Key::Stop]);
        assert_eq!(keys(&mut typed, "\u{1b}[200~q d"), []);
        assert_eq!(typed.pause(), None);
        assert_eq!(keys(&mut typed, " "), [Key::Stop], "a paste whose end was lost does not take the stop away");
    }

    #[test]
    fn no_bytes_break_it() {
        let mut typed = Typed::default();
        let mut seed = 1u32;
        for _ in 0..100_000 {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            typed.byte((seed >> 24) as u8);
            assert!(typed.begun.len() <= LONGEST);
        }
        typed.pause();
        assert_eq!(keys(&mut typed, " "), [Key::Stop]);
    }
}
