//! Who calls for something by lines on stdin, as Telegraf's execd does.

use super::Input;
use std::io;
use std::thread;
use tokio::sync::mpsc;

/// Each line of the input as a call, until its end. It is read in a thread of its own, and no further than somebody takes the
/// calls; a thread that nobody waits for any more ends with the program.
pub fn calls(mut input: Input) -> mpsc::Receiver<io::Result<()>> {
    let (called, calls) = mpsc::channel(1);
    thread::spawn(move || {
        loop {
            let call = match next_line(&mut input) {
                Ok(true) => Ok(()),
                Ok(false) => return,
                Err(error) => Err(error),
            };
            let is_last = call.is_err();
            if called.blocking_send(call).is_err() || is_last {
                return;
            }
        }
    });
    calls
}

/// Reads to the end of the next line, whatever it says and however long it is; `false` if there is none. The last one needs no
/// newline.
fn next_line(input: &mut Input) -> io::Result<bool> {
    let mut begun = false;
    loop {
        let piece = match input.fill_buf() {
            Ok(piece) => piece,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
        };
        if piece.is_empty() {
            return Ok(begun);
        }
        begun = true;
        let end = piece.iter().position(|&byte| byte == b'\n');
        let taken = end.map_or(piece.len(), |end| end + 1);
        input.consume(taken);
        if end.is_some() {
            return Ok(true);
        }
    }
}
