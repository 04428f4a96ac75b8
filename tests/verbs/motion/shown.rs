//! What is shown of a run that is held: every value, fresh, and no sooner than anybody can read it; and for how long behind
//! its end.

use super::keypad::{DRIVES, Seen, run};
use crate::pictures::are_documented;
use antrieb::drive::Button;
use antrieb::tick::{Span, Tick};
use std::collections::BTreeMap;

/// From when on a phase was shown, in microseconds.
fn since(seen: &Seen, phase: &str) -> i64 {
    seen.news.iter().find(|news| news.phase == phase).map(|news| news.t.raw).unwrap()
}

#[test]
fn every_value_of_a_held_run_is_shown_and_kept_fresh() {
    for drive in DRIVES {
        let seen = run(drive, "--view --duration 8s", &mut |_, _, _| {});
        assert_eq!(seen.stop(), ("end", None, None), "{}: {:?}", drive.0, seen.failure);
        let (held, stopping) = (since(&seen, "held"), since(&seen, "stopping"));
        assert!((7_900_000..8_100_000).contains(&(stopping - held)), "{}: {held} {stopping}", drive.0);
        assert!(seen.samples.iter().enumerate().all(|(index, sample)| sample.n == index as u64), "{}", drive.0);
        assert!(seen.samples.windows(2).all(|pair| pair[1].t.raw - pair[0].t.raw >= 200_000), "{}", drive.0);
        let mut read = BTreeMap::<u32, Vec<i64>>::new();
        for sample in seen.samples.iter().filter(|sample| (held..stopping).contains(&sample.t.raw)) {
            for value in &sample.values {
                read.entry(value.value.param).or_default().push(value.t.raw);
            }
        }
        let mut columns = seen.columns.clone();
        columns.sort_unstable();
        assert!(read.keys().eq(&columns), "{}: {:?}", drive.0, read.keys());
        for (param, mut times) in read {
            times.dedup();
            // Twice in a second at least, a cheap line gives it in every round.
            assert!(times.len() >= 16, "{} {param}: {times:?}", drive.0);
        }
    }
}

/// When the view began to show the end, and when it was closed.
fn view_closed(seen: &Seen) -> Span {
    let ended = Tick::from_micros(since(seen, "ended").unsigned_abs());
    // The records begin with the view, some telegrams behind the session.
    let begun = seen.begun.unwrap();
    seen.at.since(begun + ended.since(Tick::ZERO))
}

#[test]
fn a_run_that_a_fault_has_ended_is_shown_for_a_minute_more_without_its_setpoint() {
    let (model, keys, line) = DRIVES[1];
    let keys = format!("{keys}\n[[drive.event]]\nat = \"4s\"\nfault = \"F0500\"");
    let seen = run((model, &keys, line), "--view", &mut |_, _, _| {});
    assert!(seen.failure.as_ref().is_some_and(|failure| failure.code == "forbidden.fault"), "{:?}", seen.failure);
    let stays = view_closed(&seen).as_millis();
    assert!((59_500..61_500).contains(&stays), "{stays}");
    let ended = since(&seen, "ended");
    assert!(seen.samples.iter().filter(|sample| sample.t.raw > ended).count() > 100, "it is looked at on");
    for news in &seen.news {
        let shows = (news.setpoint.map(|setpoint| setpoint.raw), news.unit.as_deref());
        match news.phase {
            "held" => assert_eq!(shows, (Some(-1_000), Some("Hz")), "{news:?}"),
            "stopping" | "ended" => assert_eq!(shows, (None, None), "{news:?}"),
            _ => {}
        }
    }
}

#[test]
fn behind_a_run_that_came_to_its_end_the_view_stays_until_no_key_repeats() {
    let quiet = run(DRIVES[0], "--view --duration 1s", &mut |_, _, _| {});
    let mut last = None;
    let pressed = run(DRIVES[0], "--view --duration 1s", &mut |_, at, hand| {
        if at < Tick::ZERO + Span::from_secs(6) {
            hand.button(Button::More, at);
            last = Some(at);
        }
    });
    let told = quiet.notes.join("\n");
    assert!(told.contains("the stop was acknowledged, the shaft stands"), "{told}");
    let stays = view_closed(&quiet).as_millis();
    assert!((1_100..1_600).contains(&stays), "{stays}");
    let stays = pressed.at.since(last.unwrap()).as_millis();
    assert!((900..1_900).contains(&stays), "{stays}");
    assert_eq!((quiet.failure.is_some(), pressed.failure.is_some()), (false, false));
}

/// For how long no value came of the parameter that was left waiting the longest while the run was held, and for how long no
/// look at the state; in milliseconds.
fn waited(seen: &Seen) -> (i64, i64) {
    let (held, stopping) = (since(seen, "held"), since(seen, "stopping"));
    let inside: Vec<_> = seen.samples.iter().filter(|sample| (held..stopping).contains(&sample.t.raw)).collect();
    let mut times: BTreeMap<u32, Vec<i64>> = seen.columns.iter().map(|&param| (param, vec![held])).collect();
    for value in inside.iter().flat_map(|sample| &sample.values) {
        times.entry(value.value.param).or_default().push(value.t.raw);
    }
    times.values_mut().for_each(|times| times.push(stopping));
    let longest = |times: &[i64]| times.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap() / 1_000;
    let looks: Vec<i64> = inside.iter().map(|sample| sample.t.raw).collect();
    (times.values().map(|times| longest(times)).max().unwrap(), longest(&looks))
}

/// One answer is lost: of the view, then it asks nothing for 5 s; or of the run, then the view goes on behind it.
#[test]
fn a_lost_answer_keeps_the_view_from_asking_only_where_it_was_its_own() {
    let (model, keys, line) = DRIVES[1];
    let (mut own, mut others) = (0, 0);
    for once in 60..84 {
        let keys = format!("{keys}\n[[disturb]]\nonce = {once}\nkind = \"lost\"");
        let (value, look) = waited(&run((model, &keys, line), "--view --duration 8s", &mut |_, _, _| {}));
        // What the run asks itself is waited for, and asked again.
        if look > 600 {
            others += 1;
            assert!(value < 2_000, "{once}: {value} {look}");
        } else {
            own += 1;
            assert!((4_900..7_500).contains(&value), "{once}: {value} {look}");
        }
    }
    assert!(own > 10 && others > 4, "{own} {others}");
}

/// Not all of it fits into one pause: it takes turns, and asks nothing that would be cut off.
#[test]
fn on_a_slow_line_the_values_of_a_run_take_turns() {
    let (model, keys, line) = DRIVES[1];
    for (delay, oldest, seldom) in [(20, 2_000, 500), (40, 2_000, 500), (150, 5_000, 1_500), (300, 14_000, 2_500)] {
        let keys = format!("{keys}\nreply_delay = \"{delay}ms\"");
        let seen = run((model, &keys, line), "--view --duration 20s", &mut |_, _, _| {});
        let (value, look) = waited(&seen);
        assert!(value < oldest && look < seldom, "{delay}: {value} {look}");
        let end = since(&seen, "stopping");
        let all = seen.samples.iter().flat_map(|sample| &sample.values);
        let status = all.filter(|value| value.value.param == 411).map(|value| value.value.raw);
        assert!(
            status.clone().count() > 5 && status.flatten().all(|raw| raw > 0),
            "{delay}: the setpoint stands in its own column"
        );
        let held = seen.samples.iter().filter(|sample| (since(&seen, "held")..end).contains(&sample.t.raw));
        let whole = held.skip_while(|sample| sample.values.len() < seen.columns.len());
        let lacking = whole.clone().filter(|sample| sample.values.len() < seen.columns.len()).count();
        assert!(whole.count() > 5 && lacking == 0, "{delay}: a value stays until its turn comes again, {lacking}");
        assert!(
            (18_500_000..20_300_000).contains(&(end - since(&seen, "held"))),
            "{delay}: {} {end}",
            since(&seen, "held")
        );
    }
}

/// What was given is what stands, where there was no time to ask for it yet.
#[test]
fn the_setpoint_of_a_slow_servo_is_shown_before_its_turn_comes() {
    let (model, keys, line) = DRIVES[2];
    let keys = format!("{keys}\nreply_delay = \"300ms\"");
    let seen = run((model, &keys, line), "--view --duration 4s", &mut |_, _, _| {});
    let held =
        seen.samples.iter().filter(|sample| (since(&seen, "held")..since(&seen, "stopping")).contains(&sample.t.raw));
    let told = held
        .map(|sample| sample.values.iter().find(|value| value.value.param == 6_938).and_then(|value| value.value.raw));
    let told: Vec<_> = told.collect();
    assert!(told.len() > 3 && told.iter().all(|raw| *raw == Some(300)), "{told:?}");
}

/// What a drive refuses to tell is not asked again, and the state is not asked by the view at all.
#[test]
fn a_value_that_was_refused_is_left_out_of_the_view() {
    let (model, keys, line) = DRIVES[1];
    let mut refused = 0;
    for once in 75..=80 {
        let keys = format!("{keys}\n[[disturb]]\nonce = {once}\nkind = \"exception\"");
        let seen = run((model, &keys, line), "--view --duration 4s", &mut |_, _, _| {});
        let asked = |from: usize, hex: &str| seen.sent[from..].iter().filter(|sent| sent.1 == hex).count();
        let (other, hex) = (&seen.sent[once - 2].1, &seen.sent[once - 1].1);
        // The frequency (P.210) is asked by the stop as well, and what the ramp asks for (P.283) by the run.
        if !["01 64 00 D2", "01 64 01 1B"].iter().any(|asked| hex.starts_with(asked)) {
            refused += 1;
            assert_eq!(asked(once, hex), 0, "{once}: {hex}");
        }
        assert!(asked(once, other) > 10, "{once}: {other}");
        let looks = asked(0, "01 03 01 9B 00 01 F4 19");
        assert!(looks < 40, "{once}: {looks}");
    }
    assert!(refused >= 4, "{refused}");
}

#[test]
fn what_a_drive_said_of_its_state_long_ago_is_no_state() {
    let (model, keys, line) = DRIVES[1];
    let keys = format!("{keys}\n[[drive.event]]\nat = \"4s\"\nsilent = \"600s\"");
    let seen = run((model, &keys, line), "--view", &mut |_, _, _| {});
    assert!(seen.failure.is_some());
    let last_known = seen.samples.iter().rposition(|sample| sample.state.is_some()).unwrap();
    let (known, gaps) = seen.samples.split_at(last_known + 1);
    let since = known.last().unwrap().t.raw;
    assert!((2_000_000..5_000_000).contains(&since), "{since}");
    // Until it is given up who watches sees that no answer comes, and for how long.
    assert!(gaps.iter().all(|gap| gap.error.is_some() && gap.values.is_empty()), "{gaps:?}");
    let times: Vec<i64> = gaps.iter().map(|gap| gap.t.raw).take_while(|t| *t < since + 10_000_000).collect();
    assert!(times.len() > 5, "{times:?}");
    let longest = [&[since], &times[..]].concat().windows(2).map(|pair| pair[1] - pair[0]).max().unwrap();
    assert!(longest < 1_600_000, "{times:?}");
}

/// The stop is what one watches: what proves it is shown as it comes, without a telegram more.
#[test]
fn a_stop_is_shown_until_the_shaft_stands() {
    for drive in DRIVES {
        let seen = run(drive, "--view --duration 5s", &mut |_, _, _| {});
        let (stopping, ended) = (since(&seen, "stopping"), since(&seen, "ended"));
        let times = seen.samples.iter().map(|sample| sample.t.raw).filter(|t| (stopping..ended).contains(t));
        let times: Vec<i64> = [stopping].into_iter().chain(times).chain([ended]).collect();
        let longest = times.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap();
        assert!(times.len() > 3 && longest < 400_000, "{}: {longest} {times:?}", drive.0);
    }
}

/// Whoever presses Ctrl-C sees by which stop it is stopped now, and a drive that does not obey is stopped by another one.
#[test]
fn the_stop_that_is_under_way_is_the_one_that_is_shown() {
    let (model, keys, line) = DRIVES[1];
    let keys = format!("{keys}\n[[drive.event]]\nat = \"4s\"\nsilent = \"600s\"");
    let mut pressed = 0;
    let seen = run((model, &keys, line), "--view", &mut |_, at, hand| {
        if pressed < 2 && at > Tick::ZERO + Span::from_secs(5 + 2 * pressed) {
            pressed += 1;
            hand.press();
        }
    });
    let mut stops: Vec<&str> = seen.news.iter().filter(|news| news.phase == "stopping").map(|news| news.stop).collect();
    stops.dedup();
    assert_eq!(stops, ["ramp", "quick-stop"], "{:?}", seen.notes);
}

/// A dead man's key is waited for with the drive in sight: whether it turns already, or has a fault.
#[test]
fn the_drive_is_seen_while_the_key_is_waited_for() {
    let seen = run(DRIVES[1], "--dead-man --duration 1s", &mut |_, at, hand| {
        // Behind its end the view stays as long as a key repeats.
        if at < Tick::ZERO + Span::from_secs(8) {
            hand.button(Button::Hold, at);
        }
    });
    let starting = since(&seen, "starting");
    let before: Vec<_> = seen.samples.iter().filter(|sample| sample.t.raw <= starting).collect();
    assert!(before.iter().any(|sample| sample.state.is_some()), "{before:?}");
}

/// Of a servo no source tells the address of its speed: its position and what takes the setpoint are shown.
#[test]
fn the_setpoint_and_the_position_of_a_servo_are_columns() {
    let (model, keys, line) = DRIVES[2];
    for (line, setpoint) in [(line, 6_938), ("sollwert 16384 --mode position --start absolute --enable --hold", 6_940)]
    {
        let seen = run((model, keys, line), "--view --duration 2s", &mut |_, _, _| {});
        let shown = [6_916, setpoint, 7_700].iter().all(|param| seen.columns.contains(param));
        assert!(shown, "{line} {:?} {:?}", seen.columns, seen.failure);
        let last = seen.samples.iter().rfind(|sample| sample.values.len() == seen.columns.len()).unwrap();
        let raw = |param| last.values.iter().find(|value| value.value.param == param).and_then(|value| value.value.raw);
        assert!(raw(7_700).is_some_and(|position| position > 0), "{line}: {:?}", raw(7_700));
        assert!(raw(setpoint).is_some(), "{line}");
    }
}

/// What was seen before a port was lost is not shown as if it were of now.
#[test]
fn a_port_that_is_lost_is_a_gap_at_once() {
    for (model, keys, line) in [DRIVES[0], DRIVES[2]] {
        let keys = format!("{keys}\n[[disturb]]\nonce = 150\nkind = \"hang-up\"");
        let seen = run((model, &keys, line), "--view --duration 30s", &mut |_, _, _| {});
        let stopping = since(&seen, "stopping");
        let gap = seen.samples.iter().find(|sample| sample.error.is_some()).unwrap();
        let why = gap.error.as_ref().map(|error| error.class);
        assert_eq!((why, gap.state.is_some(), gap.values.len()), (Some(antrieb::failure::Class::Port), false, 0));
        let before = seen.samples.iter().filter(|sample| sample.n < gap.n);
        assert!(before.clone().count() > 5 && before.clone().all(|sample| sample.t.raw <= gap.t.raw), "{model}");
        assert!(gap.t.raw <= stopping, "{model}: {} {stopping}", gap.t.raw);
    }
}

/// `docs/screens/run.*.txt`: a run that the space bar stops, on a terminal of 80 x 24.
#[test]
fn pictures_of_a_run_are_those_of_the_bench() {
    let seen = run(DRIVES[0], "--view", &mut |telegram, at, hand| match telegram {
        1_000 => hand.button(Button::Stop, at),
        telegram if telegram > 2_000 => hand.button(Button::End, at),
        _ => {}
    });
    let moments = [
        ("starting", 1, false),
        ("held", 20, false),
        ("held", 21, true),
        ("stopping", 4, false),
        ("ended", 4, false),
        ("ended", 5, true),
    ];
    are_documented("run", &seen.story, &moments);
    let seen = run(DRIVES[2], "--view --duration 5s", &mut |_, _, _| {});
    are_documented("run-servo", &seen.story, &[("held", 12, false)]);
}

/// `docs/screens/view.*.txt`: the live view of `monitor`, over a drive that trips.
#[test]
fn pictures_of_a_watch_are_those_of_the_bench() {
    let keys = "set = { \"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 10, \"418\" = 0 }\n[[drive.event]]\nat = \"4s\"\nwarning = 0x0041\n[[drive.event]]\nat = \"9s\"\nfault = \"F0401\"\n";
    let seen = run(("acu", keys, "monitor --interval 500ms --count 30 --unpaced"), "", &mut |_, _, _| {});
    are_documented("view", &seen.story, &[("", 12, false), ("", 28, false)]);
}
