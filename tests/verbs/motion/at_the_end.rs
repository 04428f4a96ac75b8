//! The end of a run: who presses Ctrl-C just then, another master in the ramp, a drive that obeys nothing, and a connection that ends
//! again and again.

use super::events::left;
use super::keypad;
use super::rig::{DISABLE, READY, drive, sent, servo};
use crate::run::{Document, Output, antrieb};
use antrieb::tick::Tick;

const ZERO: &str = "01 10 1B 1A 00 02 04 00 00 00 00";
const QUICK_STOP: &str = "01 10 1B 02 00 02 04 00 00 00 02";

/// The time of a run is over, and its ramp goes out: who presses then asks for that, and each press more for the next stronger stop.
#[test]
fn each_press_but_the_first_at_the_end_of_a_run_is_a_stronger_stop() {
    let run = ("acu", "set = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }", "sollwert 20Hz --enable --hold --duration 1s");
    let clean = keypad::run(run, "", &mut |_, _, _| {});
    let stop = clean.sent.iter().rfind(|(_, hex)| hex.starts_with(DISABLE)).unwrap().0;
    for (presses, escalated) in [(1, None), (2, Some("quick-stop")), (3, Some("coast")), (4, Some("coast"))] {
        let mut left = presses;
        let seen = keypad::run(run, "", &mut |_, at: Tick, hand| {
            if at >= stop {
                (0..std::mem::take(&mut left)).for_each(|_| hand.press());
            }
        });
        assert_eq!(seen.stop(), ("interrupted", Some(130), escalated), "{presses}: {:?}", seen.notes);
    }
}

#[test]
fn who_holds_a_run_that_is_kept_is_told_that_the_drive_goes_on() {
    let line = "-b 115200 -a 1 --yes sollwert 10Hz --enable --hold --duration 300ms --on-exit";
    for (way, told) in
        [("keep", "running; Ctrl-C ends this program, not the drive (keep)"), ("coast", "running; Ctrl-C stops: coast")]
    {
        let run = antrieb(&format!("{line} {way}")).on(&drive(READY, "")).exits(0);
        assert_eq!(run.err.matches("running; Ctrl-C").count(), 1, "{}", run.err);
        assert!(run.err.contains(told), "{}", run.err);
    }
}

/// The other end closes the connection behind every answer from somewhere in the stop on: it is made once more, and then told.
#[test]
fn a_connection_that_ends_again_and_again_in_a_stop_is_not_made_for_ever() {
    let line = "-v -b 115200 -a 1 --yes sollwert 10Hz --enable --hold --duration 300ms";
    let clean = antrieb(line).on(&drive(READY, "")).exits(0).sent();
    let stop = clean.iter().rposition(|hex| hex.starts_with(DISABLE)).unwrap();
    for from in [stop + 1, stop + 2, stop + 3] {
        let ends: String =
            (from..from + 300).map(|once| format!("[[disturb]]\nonce = {once}\nkind = \"hang-up\"\n")).collect();
        let run = antrieb(line).on(&drive(READY, &ends)).run();
        let more = run.sent().len() - from;
        assert!(more < 60 && run.exit != 0, "{from}: exit {}, {more} telegrams: {}", run.exit, run.err);
    }
}

/// It acknowledges its words and does nothing: the last of them is said as often as one that is not heard, and a setpoint of 0 is the end.
#[test]
fn the_strongest_stop_is_said_five_times_before_a_setpoint_is_the_end() {
    let ignores = "[[drive.event]]\nwhen = \"above 9Hz\"\nignores = 410";
    for (way, ways) in [("coast", "0"), ("quick-stop", "20"), ("ramp", "720")] {
        let line = format!(
            "-v -b 115200 -a 1 --yes sollwert 10Hz --enable --until reached --hold --duration 300ms --on-exit {way}"
        );
        let run = antrieb(&line).on(&drive(READY, ignores)).run();
        let begun = run.err.split("running; Ctrl-C").last().unwrap();
        let what = |hex: &str| match hex.strip_prefix("01 06 01 9A 00 0") {
            Some(word) => word.chars().next(),
            None => hex.starts_with("01 65 01 E4 00 00 00 00").then_some('z'),
        };
        let said: String = sent(begun).iter().filter_map(|(_, hex)| what(hex)).collect();
        let told = format!("{way} {said}: {}", run.err);
        let mut kinds: Vec<char> = said.chars().filter(|word| *word != 'z').collect();
        kinds.dedup();
        assert_eq!(kinds.into_iter().collect::<String>(), ways, "{told}");
        // Once beside the word, when that is not obeyed, and once in its place.
        assert!(said.ends_with('z') && said.matches('z').count() == 2, "{told}");
        assert!(said.matches('0').count() >= 5, "{told}");
    }
}

/// A servo whose ramp from 300 1/min takes a second, the time at which that begins in a run, and what goes out from then on.
fn ramp(value: &str, event: impl Fn(f64) -> String) -> (f64, Vec<(f64, String)>, Document) {
    let bench = |event: &str| {
        let world = "servo = { guide = 1500, analog = 5 }\n\
                     readings = { references_after_mode = \"kept\", references_after_run = \"kept\" }\n";
        servo("IOposInterfac = 1, RAMPacc = 3000, RAMPdecel = 300, RAMPn_max = 3000", &format!("{world}{event}"))
    };
    let line = format!("-v -a 1 --yes sollwert {value} --enable --hold --duration 2s");
    let zero = if value.contains("speed") { "01 10 21 08 00 02 04 00 00 00 00" } else { ZERO };
    let behind = |err: &str| sent(err.split("running; Ctrl-C").last().unwrap());
    let calm = behind(&antrieb(&line).on(&bench("")).exits(0).err);
    let begun = calm.iter().find(|(_, hex)| hex.starts_with(zero)).unwrap().0;
    let run = antrieb(&line).on(&bench(&event(begun))).json();
    (begun, behind(&run.err), run)
}

/// Another master chooses another mode while the ramp goes on, in which the shaft turns on slowly: a setpoint of 0 stops nothing there.
#[test]
fn a_shaft_that_creeps_on_in_another_mode_behind_its_ramp_gets_the_quick_stop() {
    for (value, set) in [
        ("300rpm", "DCOMopmode = -2, GEARreference = 1"),
        ("300rpm", "DCOMopmode = -4, SPEEDreference = 1"),
        ("300rpm --mode speed", "DCOMopmode = -2, GEARreference = 1"),
    ] {
        for behind in [100.0, 300.0, 700.0] {
            let event = |begun| format!("[[drive.event]]\nat = \"{}ms\"\nset = {{ {set} }}\n", (begun + behind) as u64);
            let (begun, all, run) = ramp(value, event);
            let quick = all.iter().find(|(_, hex)| hex.starts_with(QUICK_STOP)).map(|(at, _)| at - begun);
            let told = format!("{value} {set} {behind}: {quick:?} {:#} {}", run.value, run.err);
            assert!(quick.is_some_and(|quick| quick < 3_700.0), "{told}");
            assert_eq!((left(), run.data("/stop/escalated")), ((0, 0), &"quick-stop".into()), "{told}");
        }
    }
}

/// It works in its mode all the time, and a load holds its shaft at speed for two seconds: that is no reason for a harder stop.
#[test]
fn a_load_that_lets_go_again_costs_a_servo_no_ramp() {
    for value in ["300rpm", "300rpm --mode speed"] {
        let event = |begun: f64| {
            let at =
                |ms: f64, on: bool| format!("[[drive.event]]\nat = \"{}ms\"\ndragged = {on}\n", (begun + ms) as u64);
            at(200.0, true) + &at(2_200.0, false)
        };
        let (begun, all, run) = ramp(value, event);
        let told = format!("{value}: {:#} {}", run.value, run.err);
        assert!(!all.iter().any(|(at, hex)| *at > begun && hex.starts_with(QUICK_STOP)), "{told}");
        assert_eq!((run.exit, run.data("/stop/escalated").is_null(), left()), (0, true, (0, 0)), "{told}");
    }
}

/// Another master gives its setpoint again and again within a ramp: behind four zeros that it overrules, or a second in which the shaft is
/// faster, the quick stop follows.
#[test]
fn who_is_overruled_in_its_ramp_for_a_second_or_four_times_stops_by_the_quick_stop() {
    let bench = |events: &str| servo("IOposInterfac = 1, RAMPacc = 3000, RAMPdecel = 1500, RAMPn_max = 3000", events);
    let ramp = |run: &Output| sent(run.err.split("running; Ctrl-C").last().unwrap());
    let line = "-v -a 1 --yes sollwert 900rpm --jog 1s";
    let begun = ramp(&antrieb(line).on(&bench("")).exits(0)).iter().find(|(_, hex)| hex.starts_with(ZERO)).unwrap().0;
    for every in [40, 700] {
        let each = |nth: u32| {
            let at = begun as u32 + 300 + every * nth;
            format!("[[drive.event]]\nat = \"{at}ms\"\nset = {{ PVn_target = 1500 }}\n")
        };
        let run = antrieb(line).on(&bench(&(0..6_000 / every).map(each).collect::<String>())).run();
        let all = ramp(&run);
        let quick =
            all.iter().position(|(_, hex)| hex.starts_with(QUICK_STOP)).unwrap_or_else(|| panic!("{}", run.err));
        let zeros = all[..quick].iter().filter(|(_, hex)| hex.starts_with(ZERO)).count();
        let took = all[quick].0 - begun;
        assert!(
            if every == 40 { took < 2_000.0 } else { zeros == 1 + 4 },
            "{every}: {zeros} in {took} ms: {}",
            run.err
        );
        assert_eq!(left(), (0, 0), "{every}: {}", run.err);
    }
}

/// Its power goes and is back as the ramp begins: what went out in its place is told.
#[test]
fn a_ramp_of_a_servo_that_has_lost_its_mode_is_told_as_the_quick_stop_that_it_is() {
    let line = "-v -a 1 --yes sollwert 900rpm --enable --hold --duration 5s";
    let bench = |event: &str| servo("RAMPacc = 3000, RAMPdecel = 3000", event);
    let calm = antrieb(line).on(&bench("")).exits(0);
    assert!(!calm.out.contains("in place of the ramp"), "{}", calm.out);
    let ramp = sent(calm.err.split("running; Ctrl-C").last().unwrap());
    let begun = ramp.iter().find(|(_, hex)| hex.starts_with(ZERO)).unwrap().0;
    let mut told = 0;
    for before in (2_700..3_200).step_by(50) {
        let cycle = format!("[[drive.event]]\nat = \"{}ms\"\npower_cycle = true\n", begun as u64 - before);
        let run = antrieb(line).on(&bench(&cycle)).run();
        let lost = "had lost its mode of operation";
        let error = run.err.lines().find(|line| line.starts_with("error: ")).unwrap_or_default();
        assert_eq!(
            error.contains("a quick stop was sent in place of the ramp"),
            error.contains(lost),
            "{before}: {error}"
        );
        told += u32::from(error.contains(lost));
    }
    assert!(told > 2, "{told}");
}

/// It never tells which fault it is: that it trips is shown all the same.
#[test]
fn a_fault_whose_code_is_not_told_is_shown() {
    let trips = "[[drive.event]]\nwhen = \"above 9Hz\"\nfault = \"F0500\"";
    let keys = format!("set = {{ \"412\" = 1, \"434\" = 2, \"418\" = 0, \"260\" = 0 }}\n{trips}");
    let seen = keypad::run(("acu", &keys, "sollwert 10Hz --enable --hold --duration 5s"), "--view", &mut |_, _, _| {});
    let states: Vec<_> = seen.samples.iter().filter_map(|sample| Some(sample.state.as_ref()?.slug.clone())).collect();
    assert!(states.iter().any(|state| state == "fault"), "{states:?}");
}

/// Slow answers lengthen the pauses of a run that is shown, and not so far that the watchdog of the drive misses it.
#[test]
fn what_is_shown_of_a_slow_drive_trips_no_watchdog() {
    let line = "sollwert 300rpm --enable --hold --duration 8s --watchdog 1s";
    for delay in [200, 300] {
        let keys = format!(
            "set = {{ RAMPacc = 3000 }}\nreply_delay = \"{delay}ms\"\nreadings = {{ node_guard_fed_by = \"writes\" }}"
        );
        let seen = keypad::run(("lxm05", &keys, line), "--view", &mut |_, _, _| {});
        let why = seen.failure.as_ref().map(|failure| failure.message.en.to_string());
        assert_eq!(seen.stop(), ("end", None, None), "{delay}: {why:?}");
    }
}
