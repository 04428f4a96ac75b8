//! `monitor` on a port that goes away, and comes back.

use crate::program::{Piped, alone};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::transport::serve::{Place, Server};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::thread::JoinHandle;
use tempfile::TempDir;
use tokio::sync::oneshot;

/// The standard bench on a pseudo terminal, until it is taken away.
struct Adapter {
    stop: oneshot::Sender<()>,
    thread: JoinHandle<()>,
}

impl Adapter {
    fn plugged_in(link: &Path) -> Self {
        let place = Place::Pty { link: Some(link.to_owned()) };
        let (stop, stopped) = oneshot::channel();
        let (ready, waits) = std::sync::mpsc::channel();
        let thread = std::thread::spawn(move || {
            let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
            runtime.block_on(async {
                let mut bench = Bench::standard(&Registry::open(&[]).unwrap());
                let mut server = Server::open(place).unwrap();
                ready.send(()).unwrap();
                let stop = async { drop(stopped.await) };
                server.run(&mut bench, stop, |_| {}).await.unwrap();
            });
        });
        waits.recv().unwrap();
        Adapter { stop, thread }
    }

    fn pulled(self) {
        self.stop.send(()).unwrap();
        self.thread.join().unwrap();
    }
}

fn bus() -> (TempDir, PathBuf) {
    let directory = tempfile::tempdir().unwrap();
    let link = directory.path().join("bus");
    (directory, link)
}

/// Every record has the form that the program itself tells.
#[track_caller]
fn fit_the_schema(records: &[Value]) {
    let (_, schema, _) = Piped::run("schema monitor");
    let schema = jsonschema::validator_for(&serde_json::from_str(&schema).unwrap()).unwrap();
    for record in records {
        let broken: Vec<String> = schema.iter_errors(record).map(|error| error.to_string()).collect();
        assert!(broken.is_empty(), "{broken:?}\n{record:#}");
    }
}

fn is(kind: &str) -> impl Fn(&Value) -> bool {
    move |record| record["type"] == kind
}

fn good(record: &Value) -> bool {
    record["type"] == "sample" && record["error"].is_null()
}

#[test]
fn a_port_that_goes_away_ends_it() {
    let _alone = alone();
    let (_directory, link) = bus();
    let adapter = Adapter::plugged_in(&link);
    let mut run = Piped::start(&format!("-p {} -a 1 monitor --interval 200ms --json", link.display()));
    run.until("sample", good);
    adapter.pulled();
    assert_eq!(run.ends(), Some(3), "{}", run.said());
    fit_the_schema(&run.records);
    // What was lost is a port, and no drive.
    let lost = run.records.iter().find(|record| record["type"] == "lost").unwrap();
    assert_eq!(lost["error"]["context"]["port"], lost["port"]);
    assert_eq!(lost["error"]["context"]["address"], Value::Null);
    assert_eq!(run.records.iter().filter(|record| record["type"] == "lost").count(), 1);
    let end = run.records.last().unwrap();
    assert_eq!((&end["summary"]["because"], &end["error"]["code"]), (&Value::from("lost"), &Value::from("port.lost")));
}

#[test]
fn a_port_that_comes_back_is_taken_up_again() {
    let _alone = alone();
    let (_directory, link) = bus();
    let adapter = Adapter::plugged_in(&link);
    let line = format!("-p {} -a 1 monitor --reconnect --interval 200ms --duration 120s --json", link.display());
    let mut run = Piped::start(&line);
    run.until("sample", good);
    adapter.pulled();
    run.until("lost port", is("lost"));
    run.until("gap", |record| record["error"]["code"] == "port.lost" && record["type"] == "sample");
    let adapter = Adapter::plugged_in(&link);
    run.until("reopened port", is("reopened"));
    run.until("sample", good);
    run.until("second sample", good);
    run.signal("-INT");
    assert_eq!(run.ends(), Some(0), "{}", run.said());
    fit_the_schema(&run.records);
    let count = |kind| run.records.iter().filter(|record| is(kind)(record)).count();
    assert_eq!((count("lost"), count("reopened")), (1, 1));
    // The clock goes on while there is no port.
    let times: Vec<f64> = run.records.iter().skip(1).map(|record| record["t"].as_f64().unwrap()).collect();
    assert!(times.windows(2).all(|pair| pair[0] <= pair[1]), "{times:?}");
    adapter.pulled();
}
