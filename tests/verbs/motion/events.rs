//! What happens to a drive while it is moved, or stopped: somebody else sets its mode, its load is stronger than it, its power goes, the
//! connection ends. What came of the run is told as it was, and the stop goes out all the same.

use super::rig::{READY, RUNNING, drive, held, held_of, run_at_20_hz, servo};
use crate::run::{Output, antrieb};
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use serde_json::json;

/// A line that comes to a bench on which something has gone on for a while.
fn later(line: &str, text: &str, ms: u64) -> Output {
    let mut bench = Bench::from_toml("bench.toml", text, &Registry::open(&[]).unwrap()).unwrap();
    let at = Tick::ZERO + Span::from_millis(ms);
    bench.advance(at);
    assert_eq!(bench.totals().turning, 1, "{text}");
    witness::stands(bench, at);
    antrieb(line).on(text).run()
}

/// Shafts that turn, and output stages that feed a motor, once everything has run out.
pub(super) fn left() -> (u64, u64) {
    let (mut bench, at) = witness::left().unwrap();
    bench.advance(at + Span::from_secs(60));
    (bench.totals().turning, bench.totals().energised)
}

/// Somebody else runs a servo: in a mode, with settings, each event a step.
fn running(mode: i32, settings: &str, rest: &str) -> String {
    let steps = [
        format!("DCOMopmode = {mode}"),
        "DCOMcontrol = 6".to_owned(),
        "DCOMcontrol = 15".to_owned(),
        settings.to_owned(),
    ];
    let events =
        steps.iter().zip(1..).map(|(set, at)| format!("[[drive.event]]\nat = \"{at}00ms\"\nset = {{ {set} }}\n"));
    let keys = "IOposInterfac = 1, RAMPacc = 3000, RAMPdecel = 3000";
    servo(keys, &format!("servo = {{ guide = 163840, analog = 900 }}\n{}{rest}", events.collect::<String>()))
}

#[test]
fn a_shaft_that_gets_no_slower_by_a_quick_stop_loses_its_power_and_what_is_seen_of_it_is_said() {
    let dragged = "[[drive.event]]\nat = \"7s\"\ndragged = true";
    let shown = drive(RUNNING, dragged);
    let blind = drive(&format!("{RUNNING}, \"217\" = 0, \"218\" = 0"), dragged);
    let moves = running(3, "PVn_target = 600", dragged);
    let (inverter, servo) = ("01 06 01 9A 00 00", "01 10 1B 02 00 02 04 00 00 00 00");
    for (line, bench, coast, is_seen) in [
        ("-b 115200 -v", &shown, inverter, true),
        ("-b 115200 -v", &blind, inverter, false),
        ("-v", &moves, servo, true),
    ] {
        // A servo coasts by "disable operation", which needs no help.
        let verbs = if coast == servo { &["quick-stop"][..] } else { &["quick-stop", "disable"] };
        for verb in verbs {
            let run = later(&format!("{line} -a 1 statemachine {verb}"), bench, 8_000);
            let told = format!("{line} {verb}: {}", run.err);
            assert_eq!(run.exit, 8, "{told}");
            assert_eq!(run.err.contains("error: THE SHAFT MAY STILL TURN"), !is_seen, "{told}");
            assert!(run.err.contains("coast"), "{told}");
            assert!(run.sent().iter().any(|hex| hex.starts_with(coast)), "{told}");
            assert_eq!(left(), (0, 0), "{told}");
        }
    }
}

#[test]
fn a_load_that_lets_go_again_lets_the_ramp_go_on() {
    let bench = drive(RUNNING, "[[drive.event]]\nat = \"8s\"\ndragged = true\nfor = \"1s\"");
    let run = later("-b 115200 -a 1 statemachine quick-stop", &bench, 8_000);
    assert_eq!((run.exit, left()), (0, (0, 0)), "{}", run.err);
}

#[test]
fn a_connection_that_ends_while_the_other_side_listens_is_made_once_more_for_the_stop() {
    for (kind, model) in [("hang-up", "acu"), ("reset", "lxm05")] {
        let bench = |once: usize| {
            let disturb =
                if once == 0 { String::new() } else { format!("[[disturb]]\nonce = {once}\nkind = \"{kind}\"\n") };
            let set = if model == "acu" { "set = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }" } else { "" };
            format!("[[drive]]\nmodel = \"{model}\"\n{set}\n{disturb}")
        };
        let unit = if model == "acu" { "10Hz" } else { "100rpm" };
        let line = format!("-v -a 1 --yes sollwert {unit} --enable --hold --duration 1s");
        let sent = antrieb(&line).on(&bench(0)).exits(0).sent();
        let (mut lost, word) =
            (0, if model == "acu" { "01 06 01 9A 00 0F" } else { "01 10 1B 02 00 02 04 00 00 00 0F" });
        let enabled = sent.iter().position(|hex| hex.starts_with(word)).unwrap() + 1;
        for once in (enabled..sent.len() - 20).step_by(4) {
            let run = antrieb(&line).on(&bench(once)).json();
            let told = format!("{model} {once}: {:#} {}", run.value, run.err);
            assert_eq!(left(), (0, 0), "{told}");
            assert_eq!(run.data("/stop/acknowledged"), &json!(true), "{told}");
            // What was lost in the stop was said again, and came to what was promised.
            assert!([0, 3].contains(&run.exit), "{told}");
            lost += i32::from(run.exit == 3);
        }
        assert!(lost > 2, "{model} {lost}");
    }
}

/// The same of a verb that stops, whichever of its telegrams the connection ends at.
#[test]
fn a_connection_that_ends_is_made_once_more_for_a_verb_that_stops() {
    for verb in ["statemachine quick-stop", "statemachine disable", "sollwert 0"] {
        for once in 1..12 {
            let disturb = format!("[[disturb]]\nonce = {once}\nkind = \"hang-up\"\n");
            let run = later(&format!("-v -b 115200 -a 1 {verb}"), &drive(RUNNING, &disturb), 4_000);
            // A setpoint of zero leaves the power.
            assert_eq!(left(), (0, u64::from(verb == "sollwert 0")), "{verb} {once}: {}", run.err);
        }
    }
}

#[test]
fn a_port_that_takes_bytes_again_takes_the_stop() {
    let set = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n";
    let servo = "[[drive]]\nmodel = \"lxm05\"\n";
    let drives = [(set, "10Hz"), (servo, "300rpm")];
    for by in ["300ms", "2600ms", "3s", "3500ms", "4s"] {
        for way in ["ramp", "quick-stop", "coast"] {
            for (drive, setpoint) in drives {
                let bench = format!("{drive}[[disturb]]\nat = \"1s\"\nkind = \"stuck\"\nby = \"{by}\"\n");
                let line = format!("-v -a 1 --yes sollwert {setpoint} --enable --hold --duration 1s --on-exit {way}");
                let run = antrieb(&line).on(&bench).json();
                let told = format!("{by} {way} {setpoint}: {:#} {}", run.value, run.err);
                assert_eq!((left(), run.data("/stop/acknowledged")), ((0, 0), &json!(true)), "{told}");
            }
        }
    }
}

#[test]
fn a_port_that_takes_no_bytes_for_a_while_keeps_no_act_that_stops_from_its_drive() {
    for verb in ["statemachine quick-stop", "statemachine disable", "sollwert 0"] {
        for by in ["400ms", "1s", "2s", "3500ms", "6s"] {
            let stuck = format!("[[disturb]]\nonce = 1\nkind = \"stuck\"\nby = \"{by}\"");
            let run = later(&format!("-b 115200 -a 1 {verb}"), &drive(RUNNING, &stuck), 8_000);
            assert_eq!(left().0, 0, "{verb} {by}: {}", run.err);
        }
    }
}

#[test]
fn another_mode_in_the_run_ends_it_whoever_set_it() {
    for set in ["DCOMopmode = -2, GEARreference = 1", "DCOMopmode = 1"] {
        for after in [40, 55, 70] {
            let bench = servo(
                "IOposInterfac = 1, RAMPacc = 3000, RAMPdecel = 3000",
                &format!(
                    "servo = {{ guide = 163840 }}\nreadings = {{ references_after_mode = \"kept\" }}\n\
                     [[drive.event]]\nafter_telegrams = {after}\nset = {{ {set} }}\n"
                ),
            );
            let run = antrieb("-a 1 --yes sollwert 300rpm --enable --hold --duration 8s").on(&bench).json();
            let told = format!("{set} {after}: {:#} {}", run.value, run.err);
            assert_eq!((run.exit, &run.error()["code"]), (8, &json!("forbidden.otherwise")), "{told}");
            assert!(run.err.contains("has left the mode"), "{told}");
            assert_eq!(run.data("/stop/acknowledged"), &json!(true), "{told}");
            assert_eq!(left(), (0, 0), "{told}");
        }
    }
}

/// Somebody else selects another mode just as a run comes to its end: its ramp is that of the other mode, and that is told.
#[test]
fn a_mode_that_was_left_just_before_the_end_is_told() {
    let line = "-v -a 1 --yes sollwert 300rpm --enable --hold --duration 1s";
    let bench = |event: &str| servo("IOposInterfac = 1, RAMPacc = 3000, RAMPdecel = 3000", event);
    let calm = antrieb(line).on(&bench("")).exits(0).sent();
    let given = calm.iter().rposition(|hex| hex.starts_with("01 10 1B 1A 00 02 04 00 00 01 2C")).unwrap();
    let zero =
        given + calm[given..].iter().position(|hex| hex.starts_with("01 10 1B 1A 00 02 04 00 00 00 00")).unwrap();
    let mut told = 0;
    for after in zero - 4..zero + 2 {
        let event = format!("[[drive.event]]\nafter_telegrams = {after}\nset = {{ DCOMopmode = 1 }}\n");
        let run = antrieb(line).on(&bench(&event)).json();
        let is_told = run.err.contains("the drive had left the mode 'Velocity profile': it was stopped in the mode");
        assert_eq!(left(), (0, 0), "{after}: {:#} {}", run.value, run.err);
        told += usize::from(is_told);
    }
    assert!(told > 0);
}

#[test]
fn a_servo_that_loses_its_power_during_the_ramp_is_not_said_to_have_ramped() {
    let bench = |after: usize| {
        let event = format!("[[drive.event]]\nafter_telegrams = {after}\npower_cycle = true\n");
        servo("RAMPacc = 3000, RAMPdecel = 100", if after == 0 { "" } else { &event })
    };
    let line = "-v -a 1 --yes sollwert 300rpm --enable --hold --duration 1s";
    let sent = antrieb(line).on(&bench(0)).exits(0).sent();
    // The first zero behind the setpoint is that of the stop.
    let given = sent.iter().position(|hex| hex.starts_with("01 10 1B 1A 00 02 04 00 00 01 2C")).unwrap();
    let zero =
        given + sent[given..].iter().position(|hex| hex.starts_with("01 10 1B 1A 00 02 04 00 00 00 00")).unwrap();
    for after in [zero + 2, zero + 5, zero + 9, zero + 14] {
        let run = antrieb(line).on(&bench(after)).json();
        let told = format!("{after}: {:#} {}", run.value, run.err);
        assert_eq!((run.exit, left()), (8, (0, 0)), "{told}");
        assert!(["had lost its mode", "lost its power"].iter().any(|why| told.contains(why)), "{told}");
    }
}

#[test]
fn an_inverter_that_loses_its_power_during_the_ramp_says_so() {
    let ramps = "ramps = { up_right = 50, down_right = 5, up_left = 50, down_left = 5 }";
    let bench = drive(READY, &format!("{ramps}\n[[drive.event]]\nat = \"4s\"\npower_cycle = true"));
    let run = antrieb("-b 115200 -a 1 --yes sollwert 20Hz --enable --hold --duration 2s").on(&bench).json().exits(8);
    assert!(run.err.contains("lost its power during the ramp"), "{:#} {}", run.value, run.err);
    assert_eq!(left(), (0, 0));
}

/// Time that passes without this program, as when it is frozen.
async fn frozen(motor: &mut Motor<'_, '_>, rounds: &mut u32) -> Result<(), antrieb::failure::Failure> {
    *rounds += 1;
    if *rounds == 2 { motor.say_nothing(Span::from_secs(3)).await } else { Ok(()) }
}

#[test]
fn an_end_that_comes_late_is_told() {
    let came = held(&drive(READY, ""), &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        let mut rounds = 0;
        motor.walk("operation-enabled").await?;
        motor
            .hold(Some(Span::from_secs(2)), async |motor: &mut Motor<'_, '_>, _| frozen(motor, &mut rounds).await)
            .await
    });
    assert!(came.notes.iter().any(|note| note.starts_with("the end came 1.")), "{:#?}", came.notes);
    let came = held(&drive(READY, ""), &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        run_at_20_hz(motor, Some(Span::from_secs(2))).await
    });
    assert!(!came.notes.iter().any(|note| note.contains("the end came")), "{:#?}", came.notes);
}

#[test]
fn a_watchdog_that_acted_meanwhile_is_named_also_where_it_makes_no_fault() {
    for reading in ["quick-stop", "fault"] {
        let bench =
            servo("MBnode_guard = 1000, RAMPacc = 3000", &format!("readings = {{ node_guard = \"{reading}\" }}"));
        let came = held_of("lxm05", &bench, &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            let mut rounds = 0;
            motor.walk("operation-enabled").await?;
            motor
                .hold(Some(Span::from_secs(9)), async |motor: &mut Motor<'_, '_>, _| frozen(motor, &mut rounds).await)
                .await
        });
        let failure = came.ended.result.as_ref().unwrap_err();
        let told = format!("{:?} {:?}", failure.message.en, failure.hint.as_ref().map(|hint| hint.en.clone()));
        assert!(told.contains("MBnode_guard") && told.contains("nothing was asked for 3"), "{reading}: {told}");
        assert!(!told.contains("second master"), "{reading}: {told}");
    }
}

#[test]
fn a_setpoint_that_only_the_wide_band_of_the_drive_lets_through_is_not_reached() {
    let bench = |shows: &str| drive(&format!("{READY}, \"549\" = 20{shows}"), "");
    let line = "-b 115200 -a 1 --yes sollwert 10Hz --enable --until reached";
    let run = antrieb(line).on(&bench(", \"210\" = 5")).json().exits(1);
    let told = run.error()["message"].as_str().unwrap();
    assert!(told.contains("stays at 5.00 Hz") && told.contains("P.549"), "{told}");
    assert_eq!(run.data("/setpoint/reached"), &json!(false), "{}", run.value);
    let run = antrieb(line).on(&bench("")).json().exits(0);
    assert_eq!(run.data("/setpoint/reached"), &json!(true), "{}", run.value);
}

#[test]
fn a_zero_that_stops_nothing_in_this_mode_says_that_the_shaft_turns() {
    for (mode, settings, zero) in [
        (-2, "GEARreference = 1", "0"),
        (-3, "CURreference = 2, CUR_I_target = 3", "0"),
        (-4, "SPEEDreference = 1", "0"),
        (-4, "SPEEDreference = 1", "0rpm --mode speed"),
    ] {
        let run = later(&format!("-a 1 sollwert {zero}"), &running(mode, settings, ""), 3_000);
        assert_eq!(run.exit, 8, "{mode}: {}", run.err);
        assert!(run.err.contains("error: THE SHAFT MAY STILL TURN"), "{mode}: {}", run.err);
        assert!(run.err.contains("quick-stop` stops it"), "{mode}: {}", run.err);
    }
}

/// A short holding time takes the power before anybody sees the shaft stand: that is no shaft under power.
#[test]
fn a_shaft_that_crept_as_its_power_went_is_no_danger() {
    let ramps = "ramps = { up_right = 50, down_right = 1, up_left = 50, down_left = 1 }";
    let line = "-b 115200 -a 1 --yes sollwert 3Hz --enable --hold --duration 1s";
    let blind = format!("{READY}, \"217\" = 0, \"218\" = 0");
    let run = antrieb(line).on(&drive(&format!("{blind}, \"638\" = 0.4"), ramps)).json().exits(8);
    let told = format!("{:#} {}", run.value, run.err);
    assert!(!told.contains("MAY STILL TURN") && told.contains("last seen at 0."), "{told}");
    // Far from standstill it is one.
    for hertz in [1, 4] {
        let run = antrieb(line).on(&drive(&format!("{blind}, \"637\" = {hertz}, \"638\" = 0"), ramps)).json().exits(8);
        assert!(run.err.contains("MAY STILL TURN"), "{hertz}: {:#} {}", run.value, run.err);
    }
}

#[test]
fn beside_a_watchdog_nothing_keeps_running_for_ever() {
    let question = |rest: &str| {
        antrieb(&format!("-b 115200 -a 1 sollwert 10Hz --enable {rest}"))
            .on(&drive(READY, ""))
            .answered("n")
            .exits(8)
            .err
    };
    for rest in ["--watchdog 2s", "--watchdog 2s --hold --on-exit keep"] {
        let asked = question(rest);
        assert!(asked.contains("until its watchdog stops it") && !asked.contains("KEEPS RUNNING"), "{rest}: {asked}");
    }
    assert!(question("").contains("KEEPS RUNNING"));
}

#[test]
fn a_write_is_refused_over_vabus_too() {
    let bench = "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\n[[drive.event]]\nat = \"0s\"\nrefuses = 480\n";
    let run = antrieb("--protocol vabus -a 1 --yes write 480@1=7Hz").on(bench).run();
    assert_eq!(run.exit, 6, "{}", run.err);
    let (bench, _) = witness::left().unwrap();
    assert_ne!(bench.drive(1).unwrap().ram(480, 1), Some(700));
}

/// What is asked before something is written that moves a shaft says what the drive does now.
#[test]
fn a_write_that_can_move_a_shaft_names_the_state_it_meets() {
    let asked = |line: &str, bench: &str| antrieb(line).on(bench).answered("n").exits(8).err;
    let told = asked("-b 115200 -a 1 write 484@ram=-20Hz", &drive(RUNNING, ""));
    assert!(told.contains("now in Operation enabled, with power"), "{told}");
    let idle = drive(&format!("{READY}, \"484\" = 20"), "");
    let told = asked("-b 115200 -a 1 write 410=15", &idle);
    assert!(told.contains("now in Switch-on disabled") && told.contains("20.00 Hz"), "{told}");
    let quiet = antrieb("-v -b 115200 -a 1 --yes write 480@1=7Hz").on(&idle).exits(0);
    assert!(!quiet.err.contains("now in"), "{}", quiet.err);
}

/// And what it will run at behind that, by its source, its limits and the data set that is in use then.
#[test]
fn a_write_that_changes_what_a_drive_runs_at_names_it() {
    let set =
        "\"412\" = 1, \"414\" = 1, \"434\" = 2, \"434@2\" = 3, \"434@3\" = 2, \"228\" = -30, \"484\" = 10, \"418\" = 0";
    for (verb, runs_at) in [
        ("write 484=-20Hz", "it runs at -20.00 Hz when it is enabled (P.434 = 2)"),
        ("write 434@ram=3", "it runs at -20.00 Hz when it is enabled (P.434 = 3)"),
        ("write 434@ram=1", "it runs at -30.00 Hz when it is enabled (P.434 = 1)"),
        ("write 418@ram=20Hz", "it runs at 20.00 Hz when it is enabled (P.434 = 2)"),
        ("write 434@3ram=1", "it runs at 10.00 Hz when it is enabled (P.434 = 2)"),
        ("write 419@ram=5Hz", "it runs at 5.00 Hz when it is enabled (P.434 = 2)"),
        ("write 414@ram=2", "what it runs at behind that is not told before (P.434 = 3)"),
        ("dataset select 3 --ram", "it runs at 10.00 Hz when it is enabled (P.434 = 2)"),
        ("dataset select 0 --ram", "the digital inputs select the data set then"),
    ] {
        for state in [15, 0] {
            let bench = drive(&format!("{set}, \"410\" = {state}"), "");
            let run = antrieb(&format!("-b 115200 -a 1 {verb}")).on(&bench).answered("n").exits(8);
            assert!(run.err.contains(runs_at), "{state} {verb}: {}", run.err);
        }
    }
    let german = antrieb("--lang de -b 115200 -a 1 write 484=-20Hz").on(&drive(RUNNING, "")).answered("n").exits(8);
    assert!(german.err.contains("danach läuft er freigegeben mit -20.00 Hz"), "{}", german.err);
}

#[test]
fn a_second_drive_that_begins_to_answer_in_the_run_leaves_nothing_proven() {
    let mut two = 0;
    let set = "\"412\" = 1, \"434\" = 2, \"418\" = 0";
    // The later ones come to questions long behind their own.
    for by in [5, 30, 100, 200, 350, 500, 700] {
        for way in ["ramp", "coast"] {
            let twins = |once| format!("[[disturb]]\nonce = {once}\nkind = \"twin\"\nby = \"{by}ms\"\n");
            let bench = drive(set, &(60..400).map(twins).collect::<String>());
            let line = format!("-b 115200 -a 1 --yes sollwert 10Hz --enable --hold --duration 2s --on-exit {way}");
            let run = antrieb(&line).on(&bench).json();
            let told = format!("{by} {way}: {:#} {}", run.value, run.err);
            if by < 200 && !run.err.contains("answered in two ways") && !told.contains("more than one answer") {
                continue;
            }
            two += 1;
            assert!([5, 8].contains(&run.exit) && run.err.contains("error: THE SHAFT MAY STILL TURN"), "{told}");
            for place in ["/running", "/standing", "/stop/standing"] {
                assert!(run.value.pointer(&format!("/data{place}")).is_none_or(serde_json::Value::is_null), "{told}");
            }
            assert_eq!(run.data("/stop/acknowledged"), &json!(false), "{told}");
        }
    }
    assert!(two > 0);
}

/// Of two drives with one address only one is told of at a time.
#[test]
fn where_one_question_was_answered_in_two_ways_a_stop_that_failed_tells_no_state() {
    let mut two = 0;
    for mode in [0, 1] {
        for by in [8, 30] {
            let set = RUNNING.replace("\"412\" = 1", &format!("\"412\" = {mode}"));
            let bench = drive(&set, &format!("[[disturb]]\nevery = 1\nkind = \"twin\"\nby = \"{by}ms\"\n"));
            for verb in ["quick-stop", "disable"] {
                let run = antrieb(&format!("-b 115200 -a 1 statemachine {verb}")).on(&bench).json();
                if run.exit == 0 {
                    // What is proven is told.
                    assert_eq!(run.data("/running"), &json!(false), "{mode} {by} {verb}: {}", run.err);
                    assert!(run.value.pointer("/data/to").is_some_and(|to| !to.is_null()), "{}", run.err);
                }
                if run.exit == 0 || !run.err.contains("answered in two ways") {
                    continue;
                }
                two += 1;
                let told = format!("{mode} {by} {verb}: {:#} {}", run.value, run.err);
                assert!(run.err.contains("error: THE SHAFT MAY STILL TURN"), "{told}");
                assert!(run.value.pointer("/data/running").is_none_or(serde_json::Value::is_null), "{told}");
            }
        }
    }
    assert!(two > 0);
}
