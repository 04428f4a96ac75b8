//! A setpoint that is led over PROFIBUS: by the arrows, along a ramp or a file; and a motor that is held enabled. Every end of it is that of
//! every other run.

use super::rig::{Came, Hand, RESTS, Said, die, does, module, no_lost_port_leaves_a_shaft_turning};
use crate::run::antrieb;
use antrieb::drive::Button;
use antrieb::outcome::{Event, Record};
use antrieb::tick::Span;

const TAKES: &str = "--enable --hold --take-control --watchdog 2s";
/// 4000h is 50 Hz there.
const FULL: i64 = 5_000;

fn led(line: &str, hand: Hand<'_>) -> Came {
    does(&format!("sollwert {line} {TAKES}"), &module(RESTS, "", ""), hand)
}

/// Setpoints behind a start word, 0.01 Hz, each once.
fn setpoints(came: &Came) -> Vec<i64> {
    let basic = came.is_basic();
    let words = came.moments().into_iter().filter_map(|moment| match moment.said {
        Said::Words(stw, hsw) if stw & 3 == 3 || (basic && stw & 3 != 0) => Some(i64::from(hsw)),
        _ => None,
    });
    let mut all: Vec<i64> = words.map(|hsw| if basic { hsw } else { (hsw * FULL + 0x2000) / 0x4000 }).collect();
    all.dedup();
    all
}

/// What the records say of the setpoint, in their order.
fn told(came: &Came) -> Vec<(&'static str, Option<i64>)> {
    let news = came.story.iter().filter_map(|event| match event {
        Event::Record(record) => match &**record {
            Record::Run(news) => Some((news.phase, news.setpoint.map(|setpoint| setpoint.raw))),
            _ => None,
        },
        _ => None,
    });
    news.collect()
}

fn notes(came: &Came) -> Vec<&str> {
    came.story.iter().filter_map(|event| if let Event::Note(told) = event { Some(&*told.en) } else { None }).collect()
}

#[test]
fn the_arrows_change_the_setpoint_within_what_was_agreed() {
    for mode in ["", "--mode basic"] {
        let (more, less) = (Button::More, Button::Less);
        let buttons = [(400, more), (450, more), (500, more), (560, less), (800, Button::End)];
        let line = format!("10Hz --view --step 2Hz --max 14Hz --duration 60s {mode}");
        let line = if mode.is_empty() {
            format!("sollwert {line} {TAKES}")
        } else {
            format!("sollwert {line} --enable --hold")
        };
        let came = does(&line, &module(RESTS, "", ""), Hand { buttons: &buttons, ..Hand::default() });
        assert_eq!(came.code(), ("", 0), "{mode}: {:?}", came.failure());
        let sent = setpoints(&came);
        assert!(sent.ends_with(&[1_000, 1_200, 1_400, 1_200]), "{mode}: {sent:?}");
        assert!(notes(&came).iter().any(|note| note.starts_with("agreed are 0.00 to 14.00 Hz")), "{mode}");
        let agreed = &came.asked.last().unwrap().details;
        assert!(
            agreed.iter().any(|told| told.en.contains("by 2.00 Hz, from 0.00 Hz to 14.00 Hz")),
            "{mode}: {agreed:?}"
        );
        let held: Vec<_> =
            told(&came).into_iter().filter(|(phase, _)| *phase == "held").filter_map(|(_, at)| at).collect();
        assert_eq!(held, [1_000, 1_200, 1_400, 1_200], "{mode}");
        let setpoint = came.motion().setpoint.as_ref().unwrap();
        assert_eq!((setpoint.value.raw, setpoint.reached), (1_200, Some(true)), "{mode}");
        assert_eq!((came.stop().because, came.stop().standing), ("key", Some(true)), "{mode}");
        came.holds(mode);
    }
}

#[test]
fn a_ramp_and_a_file_lead_it_and_the_last_setpoint_is_held() {
    let came = led("--ramp 0Hz:20Hz:5s --duration 2s", Hand::default());
    assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
    let sent = setpoints(&came);
    // The scale is measured at 3 % first.
    let way = &sent[sent.iter().position(|at| *at == 0).unwrap()..];
    assert!(way.len() > 40 && way.is_sorted() && way.last() == Some(&2_000), "{sent:?}");
    let phases: Vec<_> = told(&came).into_iter().map(|(phase, _)| phase).collect();
    let mut parts = phases.clone();
    parts.dedup();
    assert_eq!(parts, ["waiting", "starting", "led", "held", "stopping"]);
    // Every cycle has another setpoint, and not each of them is a record.
    assert!((10..30).contains(&phases.len()), "{}", phases.len());
    assert_eq!(came.motion().setpoint.as_ref().unwrap().reached, Some(true));
    came.holds("a ramp");
    assert!(came.is_given_back());
    for mode in ["", "--mode basic"] {
        let takes = if mode.is_empty() { TAKES } else { "--enable --hold" };
        let line = format!("sollwert --profile {{dir}}/way.csv --duration 3s {mode} {takes}");
        let came = does(&line, &module(RESTS, "", ""), Hand::default());
        assert_eq!(came.code(), ("", 0), "{mode}: {:?}", came.failure());
        assert!(setpoints(&came).ends_with(&[500, 1_500, 800]), "{mode}: {:?}", setpoints(&came));
        came.holds(mode);
    }
}

#[test]
fn the_other_way_round_is_led_as_well_and_percents_are() {
    for (ramp, last, stw) in [("0Hz:-20Hz:2s", 2_000, 0x0C7F), ("40%:10%:2s", 500, 0x047F)] {
        let came = led(&format!("--ramp {ramp} --duration 3s"), Hand::default());
        assert_eq!(came.code(), ("", 0), "{ramp}: {:?}", came.failure());
        assert_eq!(setpoints(&came).last(), Some(&last), "{ramp}");
        assert!(came.words().contains(&stw), "{ramp}: {:04X?}", came.words());
        came.holds(ramp);
    }
}

#[test]
fn arrows_wait_for_the_end_of_the_way() {
    let buttons = [(350, Button::More), (360, Button::More), (900, Button::More), (1_100, Button::End)];
    let came = led("--ramp 0Hz:10Hz:12s --view --step 1Hz --max 20Hz", Hand { buttons: &buttons, ..Hand::default() });
    assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
    assert_eq!(notes(&came).iter().filter(|note| note.contains("when the way is at its end")).count(), 1);
    assert_eq!(setpoints(&came).last(), Some(&1_100), "{:?}", setpoints(&came));
    came.holds("arrows behind a way");
}

#[test]
fn a_motor_is_held_enabled_and_stands() {
    let came = does(
        "statemachine enable --hold --duration 3s --take-control --watchdog 2s",
        &module(RESTS, "", ""),
        Hand::default(),
    );
    assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
    assert_eq!((came.motion().action.as_str(), came.stop().because), ("enable", "end"));
    assert!(came.words().contains(&0x047F), "{:04X?}", came.words());
    assert!(came.moments().iter().all(|moment| moment.shaft == 0));
    assert!(came.is_given_back());
    came.holds("enabled");
    let details = &came.asked[1].details;
    assert!(details.iter().all(|text| !text.en.contains("measured")), "it is not: {details:?}");
}

#[test]
fn what_a_way_over_profibus_cannot_be_is_refused_before_anything_is_opened() {
    for (line, code) in [
        ("--ramp -5Hz:5Hz:2s", "usage.setpoint"),
        ("10Hz --view --step 1Hz --min -5Hz", "usage.setpoint"),
        ("--ramp 5Hz:10%:2s", "usage.setpoint"),
        ("--ramp 5Hz:10Hz", "usage.setpoint"),
        ("10Hz --step 1Hz", "usage.keys"),
        ("10Hz --view --step 1%", "usage.keys"),
        ("10Hz --view --step 0Hz", "usage.keys"),
        ("10Hz --view --step 1Hz --max 9Hz", "usage.keys"),
        ("--ramp 0Hz:500Hz:2s", "usage.setpoint"),
        ("10Hz --view --step 1Hz --max 500Hz", "usage.setpoint"),
    ] {
        let came = led(line, Hand::default());
        assert_eq!(came.code(), (code, 2), "{line}: {:?}", came.failure());
        assert!(came.sent.is_empty(), "{line}");
    }
    let came = does("sollwert --ramp 0Hz:5Hz:2s --enable", &module(RESTS, "", ""), Hand::default());
    assert_eq!(came.code().0, "usage.hold");
    let came = does("sollwert --ramp 0Hz:5Hz:2s --hold", &module(RESTS, "", ""), Hand::default());
    assert_eq!(came.code().0, "usage.enable");
    let plan =
        antrieb("-p sim --protocol dp -a 3 --dry-run sollwert --ramp 0Hz:9Hz:5s --enable --hold").json().exits(0);
    let notes = plan.data("/notes").to_string();
    assert!(notes.contains("led in 5 s") && notes.contains("0.00 Hz … 9.00 Hz"), "{notes}");
}

/// Above what 4000h is nothing goes, whoever leads it there.
#[test]
fn no_way_goes_beyond_the_maximum() {
    for line in ["--ramp 0Hz:51Hz:2s", "10Hz --view --step 1Hz --max 51Hz"] {
        let came = led(line, Hand::default());
        assert_eq!(came.code().0, "data.range", "{line}: {:?}", came.failure());
        assert!(came.moments().iter().all(|moment| moment.shaft == 0), "{line}");
        came.holds(line);
    }
}

const WAY: &str = "--ramp 0Hz:20Hz:3s --duration 1s";

#[test]
fn a_led_run_that_ends_anywhere_leaves_no_shaft_turning() {
    no_lost_port_leaves_a_shaft_turning(|| led(WAY, Hand::default()), 0x047F);
    let whole = led(WAY, Hand::default());
    let killed = whole.killed();
    assert!(killed.iter().all(|shaft| *shaft == 0), "who is killed leaves it to the watchdog");
    for press in (0..whole.sent.len()).step_by(13) {
        let came = led(WAY, Hand { presses: &[press], ..Hand::default() });
        came.holds(&format!("Ctrl-C behind telegram {press}"));
    }
}

/// Whatever keys come, in whatever order, the run stays within its bounds, and its end is that of every run.
#[test]
fn dice_over_keys_leave_no_shaft_turning() {
    let mut roll = die(16);
    for round in 0..25 {
        let mut buttons: Vec<(usize, Button)> = (0..roll(12))
            .map(|_| (250 + roll(700), [Button::More, Button::Less, Button::Hold, Button::Stop][roll(9).min(3) % 4]))
            .collect();
        buttons.retain(|(_, button)| *button != Button::Stop || roll(2) == 0);
        buttons.push((500 + roll(900), Button::End));
        buttons.sort_by_key(|(at, _)| *at);
        let presses: Vec<usize> = (0..roll(2)).map(|_| roll(1_200)).collect();
        let hand = Hand { buttons: &buttons, presses: &presses, ..Hand::default() };
        let came = led("10Hz --view --step 3Hz --min 4Hz --max 19Hz", hand);
        let what = format!("{round}: {buttons:?} {presses:?}");
        came.holds(&what);
        let fastest = came.moments().iter().map(|moment| moment.shaft).max().unwrap();
        assert!(fastest <= 1_900, "{what}: {fastest}");
    }
}

/// The small setpoint at which the scale is measured turns the motor as well.
#[test]
fn the_time_of_a_run_counts_from_the_first_word_that_starts_the_motor() {
    for (line, readings) in [("20Hz", ""), ("40%", ""), ("20Hz", "a004 = \"0.1hz\"")] {
        for duration in [400, 1_000, 3_000] {
            let line = format!("sollwert {line} --enable --hold --duration {duration}ms --take-control --watchdog 2s");
            let came = does(&line, &module(RESTS, readings, ""), Hand::default());
            let moments = came.moments();
            let starts = moments.iter().position(|moment| matches!(moment.said, Said::Words(0x047F, _))).unwrap();
            let ends = moments[starts..].iter().find(|moment| matches!(moment.said, Said::Words(0x047E, _))).unwrap();
            let took = ends.at.since(moments[starts].at);
            // A cycle behind its end comes the stop.
            let most = Span::from_millis(duration + 60);
            assert!(took <= most, "{line} {readings}: {took}");
        }
    }
}
