//! What stands between the program and a drive, and does not do its part: gateways that say nothing or never stop, ports
//! that go away.

use crate::program::{AtTerminal, Piped, alone};
use antrieb::profile::Registry;
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::protocol::modbus::rtu;
use antrieb::simulator::Bench;
use antrieb::tick::Span;
use antrieb::transport::{Link, Wake};
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
    let (exit, _, err) = Piped::run(&format!("-p mbtcp://{address} -a 1 --timeout 1500ms read 411"));
    assert_eq!(exit, Some(4), "{err}");
    // The time-out is waited for once, and a second more.
    assert!(err.contains("no reply within 1 s"), "{err}");
    // Who it is, and whether it is a drive.
    assert_eq!(asked.iter().map(|question| question[7]).collect::<Vec<u8>>(), [43, 3], "{err}");
}

/// A named family needs no recognition, and what never said a word to a question after a value is not asked for the next.
#[test]
fn a_silent_gateway_costs_one_time_out_whatever_the_verb_wants_to_know() {
    let _alone = alone();
    for (family, verb) in [
        ("acu", "identify"),
        ("acu", "diag"),
        ("acu", "statemachine"),
        ("acu", "dataset show"),
        ("acu", "sollwert"),
        ("lxm05", "statemachine"),
        ("lxm05", "sollwert"),
    ] {
        let (address, asked) = server(usize::MAX, |_| Vec::new());
        let line = format!("-p mbtcp://{address} -a 1 --timeout 300ms --drive {family} {verb}");
        let (exit, _, err) = Piped::run(&line);
        assert_eq!((exit, asked.iter().count()), (Some(4), 1), "{line}: {err}");
    }
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

/// A server of a bench in virtual time, which outlives its masters: they come one after the other. A gateway, or for `mbtcp` false
/// a raw port.
fn server_of(bench: String, line: LineSetting, mbtcp: bool) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    std::thread::spawn(move || {
        let bench = Bench::from_toml("bench.toml", &bench, &Registry::open(&[]).unwrap()).unwrap();
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        let mut link = Link::open_sim(bench, line);
        let mut buffer = [0; 512];
        while let Ok((mut client, _)) = listener.accept() {
            while let Ok(count @ 1..) = client.read(&mut buffer) {
                let question = &buffer[..count];
                let asked = if mbtcp { rtu::encode(question[6], &question[7..]) } else { question.to_vec() };
                let answer = match runtime.block_on(passed_on(&mut link, &asked)) {
                    answer if mbtcp && answer.len() > 3 => behind_gateway(question, &answer[1..answer.len() - 2]),
                    answer => answer,
                };
                if client.write_all(&answer).is_err() {
                    break;
                }
            }
        }
    });
    address
}

/// What a bench answers.
async fn passed_on(link: &mut Link, asked: &[u8]) -> Vec<u8> {
    link.wait(link.now() + Span::from_millis(3)).await.unwrap();
    link.send(asked).await.unwrap();
    let mut answer = Vec::new();
    loop {
        let patience = Span::from_millis(if answer.is_empty() { 500 } else { 5 });
        match link.wait(link.now() + patience).await.unwrap() {
            Wake::Bytes(bytes) => answer.extend(bytes),
            Wake::Silence => return answer,
        }
    }
}

/// Saved, at its factory settings again, loaded, checked: the same.
#[track_caller]
fn comes_back(model: &str, protocol: &str, line: LineSetting, set: &str) {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("pump.toml").display().to_string();
    let (mbtcp, spoken) = (protocol == "mbtcp", if protocol == "mbtcp" { "rtu" } else { protocol });
    let way = if mbtcp { "-p mbtcp://".to_owned() } else { format!("--protocol {protocol} -p tcp://") };
    let on = |address: &str, verb: &str| Piped::run(&format!("{way}{address} -a 1 --yes dataset {verb} {file} --json"));
    let drive = |set: &str| {
        let bench =
            format!("[[drive]]\nmodel = \"{model}\"\nprotocol = \"{spoken}\"\naddress = 1\nset = {{ {set} }}\n");
        server_of(bench, line, mbtcp)
    };
    let before = drive(set);
    let (exit, out, err) = on(&before, "save");
    assert_eq!(exit, Some(0), "{model} {protocol}: {out}{err}");
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains(&format!("protocol = \"{protocol}\"")) && text.contains("\ntime = \"20"), "{text}");
    assert_eq!(on(&before, "check").0, Some(0), "{model} {protocol}");
    let reset = drive("");
    let (exit, out, _) = on(&reset, "check");
    let document: Value = serde_json::from_str(&out).unwrap();
    let differences = document["data"]["comparisons"][0]["differences"].as_array().unwrap();
    assert_eq!((exit, differences.len()), (Some(1), 3), "{model} {protocol}: {out}");
    let (exit, out, err) = on(&reset, "load");
    assert_eq!(exit, Some(0), "{model} {protocol}: {out}{err}");
    let (exit, out, _) = on(&reset, "check");
    assert_eq!(exit, Some(0), "{model} {protocol}: {out}");
}

const OF_ACT: &str = "\"372@2\" = 1450, \"480\" = -12.5, \"30\" = 210";
const OF_ACU: &str = "\"372@2\" = 1450, \"480\" = -12.5, \"376@4\" = 1.5";
const OF_SERVO: &str = "RAMPacc = 500, HMn = 61, JOGn_slow = 30";

#[test]
fn behind_a_gateway_what_was_saved_comes_back_after_a_factory_reset() {
    let _alone = alone();
    let line = LineSetting::rtu(19_200, Parity::Even);
    for (model, set) in [("act", OF_ACT), ("acu", OF_ACU), ("lxm05", OF_SERVO)] {
        comes_back(model, "mbtcp", line, set);
    }
}

#[test]
fn on_a_line_what_was_saved_comes_back_after_a_factory_reset() {
    let _alone = alone();
    let rtu = LineSetting::rtu(19_200, Parity::Even);
    for (model, protocol, line, set) in [
        ("act", "rtu", rtu, OF_ACT),
        ("acu", "ascii", LineSetting::ascii(19_200, Parity::Even), OF_ACU),
        ("act", "vabus", LineSetting::vabus(19_200), OF_ACT),
        ("acu", "vabus", LineSetting::vabus(19_200), OF_ACU),
        ("lxm05", "rtu", rtu, OF_SERVO),
    ] {
        comes_back(model, protocol, line, set);
    }
}
