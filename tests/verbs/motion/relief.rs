//! What stops goes out before anything is asked, also where nothing, or little, or the wrong thing comes back.

use super::rig::{RUNNING, drive, held};
use super::runs::with_motor;
use super::to_the_letter::zeros;
use crate::run::antrieb;
use antrieb::drive::motion::{Meant, Motor, StopChoice, shout, shout_zero};
use antrieb::gate::Relief;
use antrieb::profile::Registry;
use antrieb::tick::Span;
use antrieb::transport::witness;
use serde_json::json;

/// What a line can do to replies.
const LINES: [(&str, &str); 10] = [
    ("fine", ""),
    ("silent", "every = 1\nkind = \"lost\""),
    ("late 300", "every = 1\nkind = \"late\"\nby = \"300ms\""),
    ("late 600", "every = 1\nkind = \"late\"\nby = \"600ms\""),
    ("late 900", "every = 1\nkind = \"late\"\nby = \"900ms\""),
    ("lost 1 of 3", "every = 3\nkind = \"lost\""),
    ("doubled", "every = 2\nkind = \"doubled\"\nby = \"40ms\""),
    ("garbled", "every = 1\nkind = \"garbled\""),
    ("noise", "every = 1\nkind = \"noise\""),
    ("busy", "every = 1\nkind = \"exception\""),
];

const VERBS: [&str; 3] = ["quick-stop", "disable", "disable-voltage"];

fn active(model: &str, mode: u8, rest: &str) -> String {
    let baud = if rest.is_empty() { 115_200 } else { 19_200 };
    format!(
        "[[drive]]\nmodel = \"{model}\"\nbaud = {baud}\nset = {{ \"410\" = 15, \"412\" = {mode}, \"434\" = 2, \"484\" = 20, \
         \"418\" = 0 }}\n{rest}\n"
    )
}

/// Milliseconds to the first telegram that begins with one of these, as `-v` shows it.
fn first(err: &str, stops: &[&str]) -> Option<f64> {
    err.lines().find_map(|line| {
        let (at, hex) = line.split_once(" ms > ")?;
        stops.iter().any(|stop| hex.starts_with(stop)).then(|| at.trim().parse().unwrap())
    })
}

/// Runs a verb on a bench that is asked afterwards; when the first stop went out, its exit code, what it said, and how many
/// shafts turn.
fn stopped(line: &str, bench: &str, stops: &[&str]) -> (Option<f64>, u8, String, u64) {
    let run = antrieb(line).on(bench).run();
    let (mut bench, at) = witness::left().unwrap();
    bench.advance(at + Span::from_secs(60));
    (first(&run.err, stops), run.exit, run.err, bench.totals().turning)
}

/// A drive of another family than somebody named refuses the words of that one. So it is told in those of the others as well,
/// and nothing is claimed of a state that nobody heard.
#[test]
fn under_the_name_of_another_family_a_drive_is_stopped_and_nothing_is_claimed() {
    let inverter = active("act", 1, "");
    let servo = "[[drive]]\nmodel = \"lxm05\"\n";
    let vabus = inverter.replace("baud = 115200", "protocol = \"vabus\"");
    let stops = ["statemachine quick-stop", "statemachine disable", "statemachine disable-voltage"];
    let mut sins = Vec::new();
    for (bench, drive, words) in [
        (inverter.as_str(), "-b 115200 --drive lxm05", ["> 01 06 01 9A 00", "> 01 65 01 E4 00 00 00 00"]),
        // It has no telegram for the other family.
        (vabus.as_str(), "--protocol vabus --drive lxm05", ["", "write P.484"]),
        // DCOMcontrol, 6914 = 1B02h, and PVn_target.
        (servo, "--drive act", ["> 01 10 1B 02 00 02 04 00 00 00", "> 01 10 1B 1A 00 02 04 00 00 00 00"]),
    ] {
        for act in stops.iter().chain(&["sollwert 0"]) {
            let line = format!("-v {drive} -a 1 {act}");
            let (_, exit, err, turning) = stopped(&line, bench, &[]);
            let is_told = err.contains("THE SHAFT MAY STILL TURN") && !err.contains("stop was acknowledged");
            let is_told = is_told && err.contains("is --drive right?");
            let word = words[usize::from(*act == "sollwert 0")];
            let code = if drive.contains("vabus") { 7 } else { 6 };
            if exit != code || !is_told || turning > 0 || !err.contains(word) {
                sins.push(format!("{line}: exit {exit}, {turning} turning, {err}"));
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

/// What turns when the wrong name is given stands afterwards.
#[test]
fn a_servo_that_turns_is_stopped_under_the_name_of_an_inverter() {
    for act in [Relief::QuickStop, Relief::Disable, Relief::DisableVoltage, Relief::Zero] {
        with_motor(
            "lxm05",
            "[[drive]]\nmodel = \"lxm05\"\nset = { RAMPacc = 3000, RAMPdecel = 3000 }\n",
            async |session, target, permit| {
                let velocity = target.family.mode("velocity").unwrap().clone();
                let setpoint = target.family.param_or_unknown(velocity.setpoint);
                let mut motor = Motor::new(session, target, permit, None);
                motor.prepare(&velocity);
                motor.walk("operation-enabled").await.unwrap();
                motor.enter().await.unwrap();
                motor.give(&setpoint, 300, "rpm").await.unwrap();
                motor.until_reached().await.unwrap();
                assert_eq!(session.bench().unwrap().totals().turning, 1);
                let registry = Registry::open(&[]).unwrap();
                let meant = Meant { address: 1, family: registry.family("act"), order: None };
                match act {
                    Relief::Zero => assert!(shout_zero(session, &registry, &meant, &zeros).await.unwrap()),
                    act => drop(shout(session, &registry, &meant, act).await.unwrap()),
                }
                session.rest(Span::from_secs(20)).await.unwrap();
            },
            |bench| assert_eq!(bench.totals().turning, 0, "{act:?}"),
        );
    }
}

/// What a zero would do more than stop is not done under any name: behind a line setpoint of 0 the internal one is left.
#[test]
fn a_zero_that_would_turn_the_shaft_the_other_way_goes_out_under_no_name() {
    for drive in ["lxm05", "acu"] {
        let bench = active("acu", 1, "").replace("\"434\" = 2", "\"434\" = 3, \"228\" = -40");
        let run = antrieb(&format!("-v -b 115200 -a 1 --drive {drive} sollwert 0")).on(&bench).run();
        assert!(!run.sent().iter().any(|hex| hex.starts_with(ZEROS[0])), "{drive}: {}", run.err);
    }
}

/// A device that refuses at once is not asked thousands of times in the time that it is given.
#[test]
fn who_says_no_at_once_is_asked_again_behind_a_pause() {
    for kind in ["exception", "garbled"] {
        let how = format!("reply_delay = \"0ms\"\n[[disturb]]\nevery = 1\nkind = \"{kind}\"\n");
        let bench = active("acu", 1, &how).replace("baud = 19200", "baud = 115200");
        for act in ["sollwert 0", "statemachine disable"] {
            let run = antrieb(&format!("-v -b 115200 -a 1 --drive acu {act}")).on(&bench).run();
            // P.228; P.410 by code 3.
            let asked = ["01 64 00 E4", "01 03 01 9A"];
            let times = run.sent().iter().filter(|hex| asked.iter().any(|asked| hex.starts_with(asked))).count();
            assert!(times < 60, "{kind}, {act}: {times} times");
        }
    }
}

/// P.410: 00h, 02h, 07h; by code 6, or a SELECT of VABus.
const WORDS: [&str; 3] = ["01 06 01 9A 00 00", "01 06 01 9A 00 02", "01 06 01 9A 00 07"];

#[test]
fn a_stop_goes_out_at_once_on_every_line() {
    let mut sins = Vec::new();
    for model in ["act", "acu"] {
        for (name, how) in LINES {
            for verb in VERBS {
                for (drive, within) in [(format!("--drive {model}"), 700.0), (String::new(), 1_100.0)] {
                    let how = if how.is_empty() { String::new() } else { format!("[[disturb]]\n{how}") };
                    let bench = active(model, 1, &how);
                    let baud = if how.is_empty() { 115_200 } else { 19_200 };
                    let line = format!("-v -b {baud} -a 1 {drive} statemachine {verb}");
                    let (at, exit, err, turning) = stopped(&line, &bench, &WORDS);
                    let in_time = at.is_some_and(|at| at < within);
                    let told = exit == 0
                        || ["THE SHAFT MAY STILL TURN", "the stop was acknowledged", "without power"]
                            .iter()
                            .any(|says| err.contains(says));
                    if !in_time || turning > 0 || !told {
                        let error = err.lines().find(|line| line.contains("error:")).unwrap_or("-");
                        sins.push(format!("{line} ({name}): {at:?} ms, exit {exit}, {turning} turning, {error}"));
                    }
                }
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

/// Who says nothing for as long as a drive may take is asked nothing more: every kind that it may be has been told by then,
/// whatever --timeout is.
#[test]
fn nobody_who_is_silent_waits_for_his_first_stop() {
    let mut sins = Vec::new();
    for (model, verb, words, within) in [
        ("acu", "statemachine disable", &WORDS[..], [700.0, 600.0]),
        ("act", "statemachine disable", &WORDS[..], [700.0, 600.0]),
        ("lxm05", "statemachine disable", &["01 10 1B 02 00 02 04"][..], [100.0, 200.0]),
        ("acu", "sollwert 0", &ZEROS[..1], [700.0, 600.0]),
        ("lxm05", "sollwert 0", &ZEROS[1..], [600.0, 200.0]),
    ] {
        let silent = "[[disturb]]\nevery = 1\nkind = \"lost\"\n";
        let bench = format!("[[drive]]\nmodel = \"{model}\"\n{silent}");
        for timeout in ["", "--timeout 3s", "--timeout 60s"] {
            for (named, within) in [format!("--drive {model}"), String::new()].into_iter().zip(within) {
                let run = antrieb(&format!("-v {timeout} -a 1 {named} {verb}")).on(&bench).run();
                let at = first(&run.err, words);
                if at.is_none_or(|at| at > within) {
                    sins.push(format!("{model} {verb} {timeout} {named}: {at:?} ms of {within}"));
                }
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

#[test]
fn with_its_family_named_the_stop_is_the_first_telegram() {
    for (verb, word) in [("quick-stop", WORDS[1]), ("disable-voltage", WORDS[0])] {
        let run =
            antrieb(&format!("-v -b 115200 -a 1 --drive acu statemachine {verb}")).on(&active("acu", 1, "")).run();
        assert!(run.sent()[0].starts_with(word), "{verb}: {:?}", run.sent());
    }
}

#[test]
fn disable_never_closes_contacts_and_keeps_its_ramp() {
    for (mode, how, closes) in [(1, "", true), (2, "", false), (2, "[[disturb]]\nevery = 1\nkind = \"lost\"", false)] {
        let baud = if how.is_empty() { 115_200 } else { 19_200 };
        let line = format!("-v -b {baud} -a 1 --drive acu statemachine disable");
        let run =
            antrieb(&line).on(&active("acu", mode, how).replace("= 15", if mode == 2 { "= 3" } else { "= 15" })).run();
        let disables = run.sent().iter().any(|hex| hex.starts_with(WORDS[2]));
        assert_eq!(disables, closes, "{mode} {how}: {:?}", run.sent());
    }
}

#[test]
fn a_stop_that_is_not_obeyed_goes_out_and_says_so() {
    for verb in VERBS {
        let run =
            antrieb(&format!("-v -b 115200 -a 1 --drive acu statemachine {verb}")).on(&active("acu", 0, "")).run();
        assert_eq!(run.exit, 8, "{}", run.err);
        assert!(first(&run.err, &WORDS).is_some_and(|at| at < 500.0), "{}", run.err);
        assert!(run.err.contains("sent all the same, but it is not obeyed"), "{}", run.err);
    }
}

#[test]
fn a_servo_hears_its_stop_in_both_word_orders_at_once() {
    for (name, how) in LINES {
        for verb in VERBS {
            for drive in ["--drive lxm05", ""] {
                let how = if how.is_empty() { String::new() } else { format!("[[disturb]]\n{how}") };
                let bench = format!("[[drive]]\nmodel = \"lxm05\"\n{how}\n");
                let run = antrieb(&format!("-v -a 1 {drive} statemachine {verb}")).on(&bench).run();
                let at = first(&run.err, &["01 10 1B 02 00 02 04"]);
                assert!(at.is_some_and(|at| at < 1_500.0), "{drive} {verb}, {name}: {at:?}\n{}", run.err);
            }
        }
    }
}

/// Which half comes first is not known yet, so one of both telegrams is refused: that is no refusal of the stop.
#[test]
fn a_word_that_is_refused_in_one_order_of_its_halves_is_no_stop_that_is_refused() {
    for order in [0, 1] {
        let bench = format!("[[drive]]\nmodel = \"lxm05\"\nset = {{ MBdword_order = {order} }}\n");
        for verb in VERBS {
            let run = antrieb(&format!("-v -a 1 --drive lxm05 statemachine {verb}")).on(&bench).exits(0);
            assert!(first(&run.err, &["01 10 1B 02 00 02 04"]).is_some_and(|at| at < 100.0), "{}", run.err);
            assert!(!run.err.contains("is --drive right?"), "{order} {verb}: {}", run.err);
        }
    }
    // Who is another one refuses both.
    let run = antrieb("-b 115200 -a 1 --drive lxm05 statemachine quick-stop").on(&active("acu", 1, "")).run();
    assert!(run.err.contains("is --drive right?"), "{}", run.err);
}

#[test]
fn over_vabus_nobody_is_asked_who_he_is() {
    for (name, how) in LINES {
        for verb in ["quick-stop", "disable-voltage"] {
            let how = if how.is_empty() { String::new() } else { format!("[[disturb]]\n{how}") };
            let bench = active("acu", 1, &format!("protocol = \"vabus\"\n{how}"));
            let run = antrieb(&format!("-v -b 19200 --protocol vabus -a 1 statemachine {verb}")).on(&bench).run();
            // P.410 = 019Ah in the digits of VABus: nothing else goes out before it but the address.
            let sent: Vec<_> = run.err.lines().filter_map(|line| line.split_once(" ms > ")).collect();
            assert!(sent.first().is_some_and(|(_, told)| told.contains("410")), "{verb}, {name}: {sent:?}");
        }
    }
}

#[test]
fn a_shaft_that_coasts_is_said_to_turn() {
    let run = antrieb("-b 115200 -a 1 statemachine disable-voltage").on(&active("acu", 1, "")).json().exits(0);
    assert_eq!(run.data("/running"), &json!(false));
    let notes = run.data("/notes").to_string();
    assert!(notes.contains("coasts"), "{notes} {}", run.value);
}

/// The setpoint 0: P.484 by code 65h, PVn_target by code 16; over VABus the number stands in digits.
const ZEROS: [&str; 2] = ["01 65 01 E4 00 00 00 00", "01 10 1B 1A 00 02 04 00 00 00 00"];

#[test]
fn a_zero_goes_out_at_once_on_every_line() {
    let busy = [
        ("drip", "kind = \"babble\"\npattern = \"55\"\nby = \"20ms\""),
        ("master", "kind = \"babble\"\npattern = \"master\"\nby = \"12ms\""),
        ("flood", "kind = \"babble\"\npattern = \"random\"\nby = \"1ms\""),
    ];
    let mut sins = Vec::new();
    for (model, protocol) in [("act", "rtu"), ("acu", "rtu"), ("acu", "ascii"), ("acu", "vabus"), ("lxm05", "rtu")] {
        for (name, how) in LINES.into_iter().chain(busy) {
            for drive in [format!("--drive {model}"), String::new()] {
                let how = if how.is_empty() { String::new() } else { format!("[[disturb]]\n{how}") };
                let set = if model == "lxm05" {
                    ""
                } else {
                    "\"410\" = 15, \"412\" = 1, \"434\" = 3, \"228\" = 0, \"484\" = 20"
                };
                let bench =
                    format!("[[drive]]\nmodel = \"{model}\"\nprotocol = \"{protocol}\"\nset = {{ {set} }}\n{how}\n");
                let run = antrieb(&format!("-v --protocol {protocol} -a 1 {drive} sollwert 0")).on(&bench).run();
                let sent = run.err.lines().find_map(|line| {
                    let (at, told) = line.split_once(" ms > ")?;
                    let vabus = told.contains("write") && told.contains("484");
                    let ascii = told.contains("484") && told.contains("= 0");
                    (ZEROS.iter().any(|zero| told.starts_with(zero)) || vabus || ascii)
                        .then(|| at.trim().parse::<f64>().unwrap())
                });
                // Whoever is not named is asked who he is.
                if sent.is_none_or(|at| at > if drive.is_empty() { 1_150.0 } else { 750.0 }) {
                    sins.push(format!("{model} {protocol} {drive} {name}: {sent:?}, exit {}", run.exit));
                }
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

#[test]
fn a_zero_behind_which_the_shaft_would_turn_the_other_way_never_goes_out_unseen() {
    for (name, how) in LINES {
        let how = if how.is_empty() { String::new() } else { format!("[[disturb]]\n{how}") };
        let bench = active("acu", 1, &how).replace("\"434\" = 2", "\"434\" = 3, \"228\" = -40");
        let baud = if how.is_empty() { 115_200 } else { 19_200 };
        let run = antrieb(&format!("-v -b {baud} -a 1 --drive acu sollwert 0")).on(&bench).run();
        // Where nothing comes back in time nobody can tell, and the order is carried out.
        let unseen = ["silent", "garbled", "late 600", "late 900", "busy"].contains(&name);
        assert!(unseen || !run.sent().iter().any(|hex| hex.starts_with(ZEROS[0])), "{name}: {}", run.err);
    }
}

#[test]
fn a_quick_stop_in_place_of_a_ramp_is_told() {
    let bench = active("act", 1, "reply_delay = \"700ms\"");
    for (lang, told) in [("en", "a quick stop in place of the ramp"), ("de", "Schnellhalt statt Rampe")] {
        let run = antrieb(&format!("--lang {lang} -a 1 --drive act statemachine disable")).on(&bench).run();
        assert!(run.err.contains(told), "{}", run.err);
        // Told, and no success: another stop was asked for.
        assert!(run.exit != 0, "{}", run.err);
    }
    let prompt = antrieb("-b 115200 -a 1 --drive act statemachine disable").on(&active("act", 1, "")).run();
    assert!(!prompt.err.contains("in place of"), "{}", prompt.err);
}

/// Whoever takes the power waits for no shaft that coasts; whoever asks for a ramp or a quick stop is told when it stands.
#[test]
fn what_takes_the_power_waits_for_no_coasting_shaft() {
    let ramps = "ramps = { up_right = 999, down_right = 100, up_left = 999, down_left = 100 }";
    let bench = active("acu", 1, ramps).replace("baud = 19200", "baud = 19200\nreply_delay = \"1ms\"").replace(
        "\"484\" = 20",
        "\"484\" = 300, \"419\" = 400, \"549\" = 5, \"30\" = 210, \"424\" = 100, \"425\" = 100",
    );
    for (act, turning) in [(Relief::DisableVoltage, 1), (Relief::QuickStop, 0), (Relief::Disable, 0)] {
        with_motor(
            "acu",
            &bench,
            async |session, target, permit| {
                session.rest(Span::from_secs(2)).await.unwrap();
                let begun = session.now();
                let mut motor = Motor::new(session, target, permit, None);
                motor.relieve(act).await.unwrap();
                let took = session.now().since(begun);
                assert_eq!(act == Relief::DisableVoltage, took < Span::from_secs(1), "{act:?}: {took}");
                assert_eq!(session.bench().unwrap().totals().turning, turning, "{act:?}: {took}");
            },
            |bench| assert_eq!(bench.totals().energised, 0, "{act:?}"),
        );
    }
}

/// Where no look tells anything the stop is said again, whatever went out before.
#[test]
fn what_stops_is_said_again_to_a_drive_that_says_nothing() {
    for (act, word) in [(Relief::QuickStop, "00 02"), (Relief::DisableVoltage, "00 00")] {
        let silent = drive(RUNNING, "[[drive.event]]\nat = \"300ms\"\nsilent = \"600s\"");
        let came = held(&silent, &[], StopChoice::Keep, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.look().await?;
            while motor.look().await.is_ok() {}
            motor.relieve(act).await
        });
        assert!(came.ended.result.is_err(), "{act:?}");
        assert!(
            came.sent.iter().any(|hex| hex.starts_with(&format!("01 06 01 9A {word}"))),
            "{act:?}: {:?}",
            came.sent
        );
    }
}
