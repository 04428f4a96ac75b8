//! What stands between the program and a drive, and does not do its part: gateways that say nothing or never stop, ports
//! that go away.

use crate::program::{AtTerminal, Piped, alone};
use antrieb::protocol::modbus::rtu;
use serde_json::Value;
use std::io::{Read, Write};
use std::net::TcpListener;
use std::process::Stdio;
use std::sync::mpsc::{Receiver, channel};

/// A TCP port whose first client is answered by `reply` to so many telegrams; then it hangs up. Returns its address, and
/// what was asked.
fn server(telegrams: usize, reply: impl FnMut(&[u8]) -> Vec<u8> + Send + 'static) -> (String, Receiver<Vec<u8>>) {
    server_until(telegrams, channel().1, reply)
}

/// The same; behind the last of the telegrams it hangs up when nobody has the other end of `stays` any more.
fn server_until(
    telegrams: usize,
    stays: Receiver<()>,
    mut reply: impl FnMut(&[u8]) -> Vec<u8> + Send + 'static,
) -> (String, Receiver<Vec<u8>>) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    let (sender, asked) = channel();
    std::thread::spawn(move || {
        let (mut client, _) = listener.accept().unwrap();
        let mut buffer = [0; 512];
        for _ in 0..telegrams {
            let Ok(count @ 1..) = client.read(&mut buffer) else { return };
            // Not every test counts them.
            let _unread = sender.send(buffer[..count].to_vec());
            if client.write_all(&reply(&buffer[..count])).is_err() {
                return;
            }
        }
        let _nobody = stays.recv();
    });
    (address, asked)
}

/// A reply of Modbus/TCP to a question.
fn behind_gateway(question: &[u8], pdu: &[u8]) -> Vec<u8> {
    let length = u8::try_from(pdu.len() + 1).unwrap();
    [&question[..4], &[0, length], &question[6..7], pdu].concat()
}

#[test]
fn a_silent_gateway_is_asked_nothing_twice() {
    let _alone = alone();
    let (address, asked) = server(usize::MAX, |_| Vec::new());
    let (exit, _, err) = Piped::run(&format!("-p mbtcp://{address} -a 1 --timeout 400ms read 411"));
    assert_eq!(exit, Some(4), "{err}");
    // Who it is, and whether it is a drive.
    assert_eq!(asked.iter().map(|question| question[7]).collect::<Vec<u8>>(), [43, 3], "{err}");
}

#[test]
fn a_description_that_goes_on_without_end_is_cut_off_with_a_word() {
    let _alone = alone();
    // Whatever is asked: one object, and more follows, from the next one on.
    let (address, _) = server(usize::MAX, |question| {
        let pdu = match question[7] {
            43 => vec![43, 14, 1, 1, 0xFF, question[10].wrapping_add(1), 1, question[10], 1, b'x'],
            function => vec![function | 0x80, 1],
        };
        behind_gateway(question, &pdu)
    });
    let (_, out, err) = Piped::run(&format!("-p mbtcp://{address} -a 1 --timeout 5s identify"));
    assert!(out.contains("cut off"), "{out}{err}");
}

#[test]
fn a_port_that_was_lost_at_the_question_leaves_a_row_that_was_not_begun() {
    let _alone = alone();
    // The greeting and the old value, then nobody is there any more.
    let (hang_up, stays) = channel();
    let (address, _) = server_until(2, stays, |question| match question[1] {
        8 => rtu::encode(question[0], &[8, 0, 11, 0, 1]),
        _ => rtu::encode(question[0], &[3, 2, 0, 100]),
    });
    let line = format!("-p tcp://{address} -a 1 --timeout 5s --drive act write 372=5 --json");
    let mut run = AtTerminal::start_into(&line, Stdio::piped());
    let mut out = run.child.stdout.take().unwrap();
    run.shows("go on? [y/N]");
    drop(hang_up);
    run.types("y\n");
    assert_eq!(run.ends(), Some(3), "{}", run.seen);
    let mut printed = String::new();
    out.read_to_string(&mut printed).unwrap();
    let document: Value = serde_json::from_str(&printed).unwrap();
    assert_eq!(document["data"]["values"][0]["result"], "skipped", "{document:#}");
    let message = document["error"]["message"].as_str().unwrap();
    assert!(message.contains("begun"), "{message}");
}

#[test]
fn two_answers_of_a_gateway_to_one_question_are_named() {
    let _alone = alone();
    // In one piece, the second at once behind the first: both carry the number of the question.
    let (address, _) = server(usize::MAX, |question| match question[7] {
        3 => {
            let answers = [[3, 2, 5, 110], [3, 2, 5, 210]];
            answers.iter().flat_map(|pdu| behind_gateway(question, pdu)).collect()
        }
        function => behind_gateway(question, &[function | 0x80, 1]),
    });
    let line = format!("-p mbtcp://{address} -a 1 --timeout 5s --drive act --json read 372@1 372@2");
    let (exit, out, err) = Piped::run(&line);
    let document: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(document["error"]["code"], "garbled.two_answers", "{document:#}{err}");
    assert_eq!(exit, Some(5));
}
