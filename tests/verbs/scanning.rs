//! `scan` in virtual time: how long it takes, whom it finds, and what it says of whom it cannot understand.

use crate::run::antrieb;
use antrieb::drive::{First, Interrupt, Manner, Opening, ScanPlan, ScanResult, Session, Unknown, scan};
use antrieb::outcome::{Event, FoundDrive};
use antrieb::profile::{Lang, Registry};
use antrieb::protocol::Protocol;
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::protocol::modbus::Framing;
use antrieb::tick::{Span, Tick};
use antrieb::transport::Port;
use serde_json::json;

/// What came of a scan of a bench.
struct Played {
    result: ScanResult,
    took: Span,
    /// Each find with its time.
    found: Vec<(Span, FoundDrive)>,
    remarks: Vec<String>,
}

impl Played {
    fn addresses(&self) -> Vec<u8> {
        self.result.drives.iter().map(|drive| drive.address).collect()
    }

    fn warnings(&self) -> Vec<&str> {
        self.result.warnings.iter().map(|warning| warning.code.as_str()).collect()
    }
}

/// Scans a bench from 19200 8E1 on.
fn play(bench: &str, plan: &ScanPlan) -> Played {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("bench.toml");
    std::fs::write(&path, bench).unwrap();
    let registry = Registry::open(&[]).unwrap();
    let opening = Opening {
        port: &Port::Sim(Some(path)),
        line: LineSetting::rtu(19_200, Parity::Even),
        rs485: antrieb::transport::Rs485::default(),
        protocol: Protocol::Modbus(Framing::Rtu),
        timeout: None,
        retries: None,
        trace: None,
        verbose: true,
        lang: Lang::En,
    };
    let mut found = Vec::new();
    // Time by the telegrams, which are told before what they bring.
    let mut now = 0;
    let mut observe = |event| match event {
        Event::Telegram { at_us, .. } => now = at_us,
        Event::Found(drive) => found.push((Span::from_micros(now), drive)),
        _ => {}
    };
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    let (result, took, remarks) = runtime.block_on(async {
        let mut session = Session::open(opening, &registry, Interrupt::default(), &mut observe).await.unwrap();
        let result = scan(&mut session, plan, &registry).await;
        let took = session.now().since(Tick::ZERO);
        (result, took, session.bench().unwrap().remarks().iter().map(ToString::to_string).collect())
    });
    Played { result, took, found, remarks }
}

fn drives(rows: &[(u8, &str)]) -> String {
    let row = |(address, more): &(u8, &str)| format!("[[drive]]\nmodel = \"act\"\naddress = {address}\n{more}\n");
    rows.iter().map(row).collect()
}

fn whole_line() -> ScanPlan {
    ScanPlan::new(1..=247, Lang::En)
}

#[test]
fn the_whole_line_takes_less_than_eight_seconds() {
    let played = play(&drives(&[(1, ""), (17, ""), (42, "")]), &whole_line());
    assert_eq!(played.addresses(), [1, 17, 42]);
    println!("three usual drives: {}", played.took);
    assert!(played.took < Span::from_secs(8), "{}", played.took);
    let first = played.found.first().unwrap().0;
    assert!(first < Span::from_millis(200), "a factory drive shows up at once: {first}");
    let others = played.remarks.iter().filter(|remark| !remark.ends_with("(impatient)"));
    assert_eq!(others.collect::<Vec<_>>(), [""; 0], "asking on after a short window is the only liberty");
}

#[test]
fn a_drive_that_answers_late_costs_no_more_than_that() {
    for slow in [1, 17, 42] {
        for delay in [150, 290, 295, 300, 305, 310, 400] {
            let delay_row = format!("reply_delay = \"{delay}ms\"");
            let rows = [1, 17, 42].map(|address| (address, if address == slow { delay_row.as_str() } else { "" }));
            let played = play(&drives(&rows), &whole_line());
            let mut found = played.addresses();
            found.sort_unstable();
            println!("{slow} after {delay} ms: {} {found:?} {:?}", played.took, played.warnings());
            assert_eq!(found, [1, 17, 42], "{slow} after {delay} ms");
            assert!(played.took < Span::from_secs(8), "{slow} after {delay} ms: {}", played.took);
            assert_eq!(played.warnings(), ["scan.late"]);
        }
    }
}
