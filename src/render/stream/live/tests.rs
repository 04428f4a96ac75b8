//! The live view on terminals of every size.

use super::chart::bounds;
use super::picture::lines as drawn;
use super::screen::Screen;
use crate::failure::{Class, Failure, may_turn, unanswered_stop};
use crate::outcome::{
    Column, Decimal, ErrorDoc, Record, RunKeys, RunNews, Sample, SampleValue, State, StreamStart, Value, WatchedDrive,
};
use crate::profile::Lang;
use crate::text::Text;

fn column(param: u32, name: Text, unit: Option<&str>, role: &'static str) -> Column {
    Column {
        param,
        data_set: 0,
        store: "ram",
        slug: role.to_owned(),
        name,
        unit: unit.map(str::to_owned),
        role: Some(role),
        scaled: true,
        is_word: false,
    }
}

fn watched(address: u8) -> WatchedDrive {
    let columns = vec![
        column(411, Text::new("Status word", "Statuswort"), None, "status-word"),
        column(283, Text::new("Ramp reference frequency", "Rampensollwert Frequenz"), Some("Hz"), "setpoint-ramp"),
        column(210, Text::new("Stator frequency", "Ständerfrequenz"), Some("Hz"), "stator-frequency"),
        column(260, Text::new("Current error", "Aktueller Fehler"), None, "fault"),
    ];
    WatchedDrive { address, node: 0, called: None, drive: "act".to_owned(), title: None, columns }
}

fn at(second: i64) -> Decimal {
    Decimal { raw: second * 1_000_000, decimals: 6 }
}

/// A sample of every column; `None` is a gap.
fn sample(address: u8, n: u64, raw: Option<i64>) -> Record {
    let t = at(n as i64);
    let columns = watched(address).columns;
    let error = raw
        .is_none()
        .then(|| ErrorDoc::from(&Failure::new(Class::Silence, "silence.no_reply", Text::name("no reply"))));
    let value = |column: Column| Value {
        address,
        node: 0,
        drive: "act".to_owned(),
        param: column.param,
        index: None,
        slug: column.slug,
        name: column.name,
        data_set: 0,
        store: "ram",
        raw: if column.param == 260 { raw.map(|_| 0) } else { raw },
        value: raw.map(|raw| Decimal { raw, decimals: 2 }),
        decimals: Some(2),
        unit: column.unit,
        text: None,
        word: None,
        kind: None,
        origin: String::new(),
        unconfirmed: Vec::new(),
        expected: None,
        error: error.clone(),
        hex: false,
    };
    Record::Sample(Sample {
        t,
        n,
        port: None,
        address,
        node: 0,
        called: None,
        drive: "act".to_owned(),
        state: raw.map(|_| State {
            slug: "operation-enabled".to_owned(),
            name: Text::new("Operation enabled", "Betrieb freigegeben"),
        }),
        values: columns.into_iter().map(|column| SampleValue { t, value: value(column) }).collect(),
        error: error.clone(),
        line: None,
    })
}

fn screen(drives: u8, samples: &[Option<i64>]) -> Screen {
    screen_in(Lang::En, "monitor", drives, samples)
}

fn screen_in(lang: Lang, command: &'static str, drives: u8, samples: &[Option<i64>]) -> Screen {
    let mut screen = Screen::new(lang, false);
    screen.record(&Record::Start(StreamStart {
        t: at(0),
        schema: 1,
        tool: "antrieb",
        command,
        port: "sim".to_owned(),
        begun: None,
        line: "19200 8E1".to_owned(),
        protocol: "rtu",
        interval: Some(at(1)),
        waits: None,
        drives: (1..=drives)
            .map(watched)
            .map(|mut drive| {
                // What a catalogue calls a parameter may be no text for a terminal.
                drive.columns.iter_mut().filter(|row| row.param == 260 && command == "monitor").for_each(|row| {
                    row.name = Text::name("Current\u{1b} error");
                });
                drive
            })
            .collect(),
    }));
    for (n, raw) in (0..).zip(samples) {
        (1..=drives).for_each(|address| screen.record(&sample(address, n, *raw)));
    }
    screen
}

#[test]
fn it_draws_on_every_terminal() {
    let many = screen(9, &[Some(0), None, Some(-500), Some(2_500)]);
    for screen in [Screen::new(Lang::De, true), screen(0, &[]), screen(1, &[None]), many] {
        for width in [1, 2, 9, 36, 59, 60, 130] {
            [1, 2, 3, 4, 5, 8, 12, 15, 30].into_iter().for_each(|height| drop(drawn(&screen, width, height)));
        }
    }
}

#[test]
fn a_wide_terminal_shows_chart_and_table() {
    let shown = drawn(&screen(1, &[Some(0), Some(1_250), Some(2_500), None, Some(2_500)]), 100, 30);
    let page = shown.join("\n");
    assert!(shown[0].contains("sim  19200 8E1 rtu  4.000 s  #5  gaps: 1"), "{page}");
    assert!(shown[1].contains("1 act  Operation enabled  fault: none"), "{page}");
    assert!(shown[2].contains("setpoint 25.00 Hz") && shown[2].contains("actual 25.00 Hz"), "{page}");
    assert!(page.contains('×') && page.contains("gap"), "{page}");
    assert!(shown[28].contains("260 Current\\u{1b} error"), "{page}");
    assert!(shown.iter().any(|line| line.starts_with("25.0│")), "{page}");
}

#[test]
fn a_narrow_terminal_shows_less() {
    let screen = screen(1, &[Some(0), Some(2_500)]);
    // Chart and table.
    assert!(drawn(&screen, 60, 20).iter().any(|line| line.contains('│')));
    // The table without the chart, then only the drive.
    let small = drawn(&screen, 40, 8);
    assert!(!small.iter().any(|line| line.contains('│')) && small.iter().any(|line| line.contains("25.00")));
    assert_eq!(drawn(&screen, 40, 1), [" 1 act  Operation enabled  fault: none"]);
    assert_eq!(drawn(&screen, 26, 1), [" 1 act  Operation enabled"]);
}

/// The name of a row is whole where there is room for it, and leaves some to the words of the others.
#[test]
fn names_are_whole_as_far_as_there_is_room() {
    let named = |name: &'static str| {
        let mut screen = screen(1, &[Some(2_500)]);
        for column in screen.drives.iter_mut().flat_map(|drive| &mut drive.about.columns) {
            column.name = Text::name(name);
        }
        drawn(&screen, 80, 24).join("\n")
    };
    assert!(named("Output frequency of the gateway").contains("Output frequency of the gateway  "));
    assert!(
        named("Output frequency of the gateway, and so on and on")
            .contains("Output frequency of the gateway, and so  ")
    );
}

#[test]
fn lines_of_a_chart_end_where_a_gap_begins() {
    let mut screen = screen(1, &[Some(2_500), Some(2_500), None, None, None, Some(2_500), Some(2_500)]);
    let top = |screen: &Screen| drawn(screen, 100, 30)[3].clone();
    assert!(top(&screen).trim_end_matches(' ').contains("   "), "{}", top(&screen));
    screen.turn(1);
    assert_eq!(screen.turned_to, 0);
}

/// A run is seen before its values are asked for, and while it stops nothing is asked for besides.
#[test]
fn what_was_not_asked_for_yet_is_no_gap_and_what_is_old_says_so() {
    let changed = |n: u64, change: &dyn Fn(&mut Sample)| match sample(1, n, Some(2_500)) {
        Record::Sample(mut sample) => {
            change(&mut sample);
            Record::Sample(sample)
        }
        other => other,
    };
    let mut screen = screen(1, &[]);
    (0..3).for_each(|n| screen.record(&changed(n, &|sample| sample.values.clear())));
    let page = drawn(&screen, 100, 30).join("\n");
    assert!(page.contains("gaps: 0") && !page.contains('×'), "{page}");
    screen.record(&changed(4, &|sample| sample.values.iter_mut().skip(1).for_each(|value| value.t = at(1))));
    let page = drawn(&screen, 100, 30).join("\n");
    assert_eq!(page.matches("3.0 s ago").count(), watched(1).columns.len() - 1, "{page}");
}

#[test]
fn axes_hold_all_values_at_round_numbers() {
    assert_eq!(bounds([0.0].into_iter()), (0.0, 1.0));
    assert_eq!(bounds([3.0, 24.9].into_iter()), (0.0, 25.0));
    assert_eq!(bounds([-12.0, 49.0].into_iter()), (-15.0, 50.0));
    assert_eq!(bounds(std::iter::empty()), (0.0, 1.0));
}

fn course(phase: &'static str) -> Record {
    let value = |raw| Decimal { raw, decimals: 2 };
    let keys = RunKeys { step: value(50), min: value(-1_000), max: value(3_000), unit: "Hz".to_owned() };
    let (setpoint, unit) = (Some(value(2_500)), Some("Hz".to_owned()));
    Record::Run(RunNews {
        t: at(0),
        address: 1,
        phase,
        setpoint,
        unit,
        ends: Some(at(9)),
        stop: "ramp",
        keys: Some(keys),
    })
}

#[test]
fn a_run_shows_where_it_is_and_what_the_keys_do() {
    let mut screen = screen(1, &[Some(0), Some(1_250), Some(2_500)]);
    screen.record(&course("held"));
    screen.note("agreed are …");
    let shown = drawn(&screen, 80, 24);
    let foot = [
        " space stop  q stop and end  \u{2191}\u{2193} 0.50 Hz (-10.00 … 30.00)  d diagnosis",
        " held  setpoint 25.00 Hz  7.0 s left  stop: ramp",
        " agreed are …",
    ];
    assert_eq!(shown[21..], foot);
    assert_eq!(drawn(&screen, 50, 24)[21], " space stop  q stop and end");
    screen.record(&course("stopping"));
    assert!(drawn(&screen, 80, 24)[21..].iter().all(|line| !line.contains("space")), "it stops already");
    assert_eq!(drawn(&screen, 80, 24)[23], "", "what was said before is over");
    screen.record(&course("ended"));
    assert_eq!(drawn(&screen, 80, 24)[21], " q ends  d diagnosis");
}

/// A key at its bound is told so; behind the next one that is taken this is over, and who leans on it hears it once.
#[test]
fn what_a_key_was_told_is_over_with_the_next_one() {
    let mut screen = screen_in(Lang::En, "sollwert", 1, &[Some(0), Some(1_250), Some(2_500)]);
    screen.record(&course("held"));
    (0..5).for_each(|_| screen.note("agreed are …"));
    assert_eq!(screen.notes.len(), 1);
    let Record::Run(mut news) = course("held") else { unreachable!() };
    // Two keys at once, the second of which was refused.
    news.setpoint = Some(Decimal { raw: 3_000, decimals: 2 });
    news.t = Decimal { raw: screen.t.raw + 300_000, decimals: 6 };
    screen.record(&Record::Run(news.clone()));
    let page = drawn(&screen, 80, 24).join("\n");
    assert!(page.contains("setpoint 30.00 Hz") && page.contains("agreed"), "{page}");
    news.setpoint = Some(Decimal { raw: 2_450, decimals: 2 });
    news.t = Decimal { raw: screen.t.raw + 2_000_000, decimals: 6 };
    screen.record(&Record::Run(news));
    let page = drawn(&screen, 80, 24).join("\n");
    assert!(page.contains("setpoint 24.50 Hz") && !page.contains("agreed"), "{page}");
}

/// What a key was told pushes nothing off the screen that says that the shaft may turn; an answer of the drive ends it.
#[test]
fn that_the_shaft_may_turn_stays_whatever_else_is_said() {
    let mut screen = screen_in(Lang::De, "sollwert", 1, &[Some(0), Some(1_250), None]);
    screen.record(&course("stopping"));
    screen.note("DIE WELLE KANN NOCH DREHEN: keine gültige Antwort auf den Halt, der weiter gesendet wird");
    screen.note("erneut unterbrochen: coast statt quick-stop");
    for height in [24, 8] {
        let page = drawn(&screen, 80, height).join("\n");
        assert!(page.contains("KANN NOCH DREHEN"), "{page}");
    }
    assert!(drawn(&screen, 80, 24).join("\n").contains("erneut unterbrochen"));
    screen.record(&course("ended"));
    assert!(!drawn(&screen, 80, 24).join("\n").contains("KANN NOCH DREHEN"));
}

/// Behind the end of a run answers go on coming: they prove nothing of a stop that was not proven.
#[test]
fn that_a_stop_was_not_proven_stays_until_somebody_leaves() {
    for (lang, told, stops) in [
        (Lang::De, "DIE WELLE KANN NOCH DREHEN: der Halt wurde NICHT bestätigt; was ihn jetzt anhält: STO", "STO"),
        (Lang::En, "THE SHAFT MAY STILL TURN: the stop was NOT acknowledged; what stops it now: STO", "STO"),
    ] {
        let mut screen = screen_in(lang, "sollwert", 1, &[Some(0), Some(1_250), None]);
        screen.record(&course("stopping"));
        screen.note(unanswered_stop().get(lang));
        assert!(drawn(&screen, 80, 24).join(" ").contains(may_turn().get(lang)));
        // Who answers again is heard.
        screen.record(&sample(1, 3, Some(1_000)));
        assert!(!drawn(&screen, 80, 24).join(" ").contains(may_turn().get(lang)));
        // What is not obeyed stays, also where the line falls silent and comes back meanwhile, and ends what was said of it before.
        screen.note("stopping: ramp");
        screen.note(told);
        assert!(!drawn(&screen, 80, 24).join(" ").contains("stopping: ramp"));
        screen.note(unanswered_stop().get(lang));
        screen.record(&sample(1, 4, Some(1_000)));
        assert!(drawn(&screen, 80, 24).join(" ").contains(stops));
        screen.record(&course("ended"));
        screen.note(told);
        for n in 0..20 {
            screen.record(&sample(1, n, Some(1_000)));
            screen.record(&course("ended"));
        }
        for height in [24, 12] {
            let page = drawn(&screen, 80, height).join(" ");
            assert!(page.contains(may_turn().get(lang)) && page.contains(stops), "{page}");
        }
    }
}

/// The end of a warning may be what matters.
#[test]
fn what_was_said_last_of_a_run_is_shown_whole() {
    let mut screen = screen_in(Lang::En, "sollwert", 1, &[Some(0), Some(1_250), Some(2_500)]);
    screen.record(&course("ended"));
    screen.note(
        "address 2: no reply within 500 ms, asked once; what follows is longer than one line; THE SHAFT MAY STILL TURN",
    );
    let shown = drawn(&screen, 80, 24);
    assert!(shown[22..].join(" ").contains("THE SHAFT MAY STILL TURN"), "{shown:#?}");
    for (width, height) in [(1, 1), (20, 5), (80, 8)] {
        drawn(&screen, width, height);
    }
}

/// "running; Ctrl-C stops" is no diagnosis of a run that stops, nor "stopping" of one that is over.
#[test]
fn the_diagnosis_tells_nothing_of_a_part_of_the_run_that_is_over() {
    let mut screen = screen(1, &[Some(0), Some(1_250)]);
    screen.diagnoses = true;
    for (phase, said, before) in [
        ("held", "running", "-"),
        ("stopping", "stopping: ramp", "running"),
        ("ended", "the shaft stands", "stopping: ramp"),
    ] {
        screen.record(&course(phase));
        screen.note(said);
        screen.note("and more");
        let page = drawn(&screen, 80, 24)[..21].join("\n");
        assert!(page.contains(said) && !page.contains(before), "{phase}: {page}");
    }
}

#[test]
fn the_diagnosis_of_a_run_tells_in_words_and_asks_nothing() {
    let mut screen = screen(1, &[Some(0)]);
    screen.record(&course("held"));
    (0..20).for_each(|nth| screen.note(&format!("said {nth}")));
    screen.diagnoses = true;
    let page = drawn(&screen, 80, 24).join("\n");
    assert!(page.contains(" state: Operation enabled") && page.contains(" fault: none"), "{page}");
    // The last one stands below, and nowhere else.
    assert_eq!(page.matches("said 19").count(), 1, "{page}");
    assert!(page.contains(" said 18\n said 17") && page.contains("said 12") && !page.contains("said 11"), "{page}");
    for width in [1, 9, 36, 80] {
        [1, 2, 3, 5, 8, 24].into_iter().for_each(|height| drop(drawn(&screen, width, height)));
    }
}
