//! What stands between the program and a drive, and does not do its part: gateways that say nothing or never stop, ports
//! that go away. In real time, behind a TCP port of this machine.

use crate::run::antrieb;
use antrieb::protocol::modbus::rtu;
use std::io::{Read, Write};
use std::net::TcpListener;
use std::time::{Duration, Instant};

/// A TCP port whose first client is answered by `reply` to so many telegrams; then it hangs up.
pub(super) fn server(telegrams: usize, mut reply: impl FnMut(&[u8]) -> Vec<u8> + Send + 'static) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    std::thread::spawn(move || {
        let (mut client, _) = listener.accept().unwrap();
        let mut buffer = [0; 512];
        for _ in 0..telegrams {
            let Ok(count @ 1..) = client.read(&mut buffer) else { return };
            if client.write_all(&reply(&buffer[..count])).is_err() {
                return;
            }
        }
    });
    address
}

/// A reply of Modbus/TCP to a question.
pub(super) fn behind_gateway(question: &[u8], pdu: &[u8]) -> Vec<u8> {
    let length = u8::try_from(pdu.len() + 1).unwrap();
    [&question[..4], &[0, length], &question[6..7], pdu].concat()
}

#[expect(clippy::disallowed_methods, reason = "a time-out behind a real port takes real time")]
fn took(line: &str, exit: u8) -> (Duration, crate::run::Output) {
    let began = Instant::now();
    let output = antrieb(line).exits(exit);
    (began.elapsed(), output)
}

#[test]
fn a_silent_gateway_costs_one_time_out() {
    let address = server(usize::MAX, |_| Vec::new());
    let (took, _) = took(&format!("-p mbtcp://{address} -a 1 --timeout 400ms read 411"), 4);
    assert!(took < Duration::from_millis(1_000), "{took:?}");
}

#[test]
fn a_description_that_goes_on_without_end_is_cut_off_with_a_word() {
    // Whatever is asked: one object, and more follows, from the next one on.
    let address = server(usize::MAX, |question| {
        let pdu = match question[7] {
            43 => vec![43, 14, 1, 1, 0xFF, question[10].wrapping_add(1), 1, question[10], 1, b'x'],
            function => vec![function | 0x80, 1],
        };
        behind_gateway(question, &pdu)
    });
    let line = format!("-p mbtcp://{address} -a 1 --timeout 400ms identify");
    let output = antrieb(&line).run();
    assert!(output.out.contains("cut off"), "{}{}", output.out, output.err);
}

#[test]
fn a_port_that_was_lost_at_the_question_leaves_a_row_that_was_not_begun() {
    // The greeting and the old value, then nobody is there any more.
    let address = server(2, |question| match question[1] {
        8 => rtu::encode(question[0], &[8, 0, 11, 0, 1]),
        _ => rtu::encode(question[0], &[3, 2, 0, 100]),
    });
    let line = format!("-p tcp://{address} -a 1 --drive act write 372=5 --json");
    let output = antrieb(&line).answered("y").exits(3);
    let document: serde_json::Value = serde_json::from_str(&output.out).unwrap();
    assert_eq!(document["data"]["values"][0]["result"], "skipped", "{document:#}");
    let message = document["error"]["message"].as_str().unwrap();
    assert!(message.contains("begun"), "{message}");
}
