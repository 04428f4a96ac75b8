//! OpenMetrics 1.0 text: after each round everything that is known, ended by `# EOF`. Prometheus and whatever reads it take it. Its
//! node_exporter (textfile) reads the older text 0.0.4, in which type and help name a counter with its `_total`.

use super::Form;
use super::metrics::{Label, Origin, error, number};
use crate::outcome::{LineNews, Record, Sample, Value};
use crate::profile::value::format_decimal;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// The last sample of every drive, as a text that is whole.
#[derive(Debug, Default)]
pub(super) struct Exposition {
    origin: Origin,
    /// In the older text.
    is_older: bool,
    samples: BTreeMap<u8, Sample>,
    /// Drives that were read in this round.
    read: usize,
}

/// A metric: name, kind, what it is, and its samples.
struct Metric {
    name: &'static str,
    kind: &'static str,
    help: &'static str,
    rows: Vec<Row>,
}

/// A sample of a metric: what stands behind the name, whose it is, and how much.
struct Row {
    suffix: &'static str,
    labels: Vec<Label>,
    number: String,
}

impl Exposition {
    /// Notes a record; the text whenever a round is complete.
    pub(super) fn note(&mut self, record: &Record) -> Option<String> {
        match record {
            Record::Start(start) => {
                let is_older = self.is_older;
                *self = Exposition { origin: Origin::of(start), is_older, ..Exposition::default() };
                None
            }
            Record::Sample(sample) => {
                self.samples.insert(sample.address, sample.clone());
                self.read += 1;
                (self.read >= self.origin.drives).then(|| {
                    self.read = 0;
                    self.text()
                })
            }
            _ => None,
        }
    }

    fn text(&self) -> String {
        let mut text: String = {
            let metrics = self.of_drives().into_iter().chain(self.of_the_line());
            metrics.map(|metric| told(&metric, self.is_older)).collect()
        };
        text.push_str("# EOF\n");
        text
    }

    fn of_drives(&self) -> [Metric; 5] {
        [
            Metric {
                name: "antrieb_reachable",
                kind: "gauge",
                help: "Whether the drive answered in the last round.",
                rows: self.rows(|sample| vec![(Vec::new(), u8::from(sample.error.is_none()).to_string())]),
            },
            Metric {
                name: "antrieb_error",
                kind: "gauge",
                help: "What went wrong in the last round.",
                rows: self.words("code", |sample| error(sample).map(str::to_owned)),
            },
            Metric {
                name: "antrieb_state",
                kind: "gauge",
                help: "The state of the drive.",
                rows: self.words("state", |sample| sample.state.as_ref().map(|state| state.slug.clone())),
            },
            Metric {
                name: "antrieb_value",
                kind: "gauge",
                help: "A parameter of the drive, in its unit.",
                rows: self.values(|value| value.value.is_some()),
            },
            Metric {
                name: "antrieb_raw",
                kind: "gauge",
                help: "A parameter of the drive: a word, or a number whose decimals nobody knows.",
                rows: self.values(|value| value.value.is_none()),
            },
        ]
    }

    /// What all drives share.
    fn of_the_line(&self) -> Vec<Metric> {
        let last = self.samples.values().filter(|sample| sample.line.is_some()).max_by_key(|sample| sample.t.raw);
        let Some(line) = last.and_then(|sample| sample.line.as_ref()) else { return Vec::new() };
        let row = |suffix, number| Row { suffix, labels: vec![self.origin.line()], number };
        let mut metrics: Vec<_> = COUNTS
            .map(|(name, help, count)| Metric {
                name,
                kind: "counter",
                help,
                rows: vec![row("_total", count(line).to_string())],
            })
            .into();
        let waited = format_decimal(line.waited.raw, line.waited.decimals);
        metrics.push(Metric {
            name: "antrieb_line_reply_seconds",
            kind: "summary",
            help: "How long replies were waited for.",
            rows: vec![row("_sum", waited), row("_count", line.replies.to_string())],
        });
        metrics
    }

    /// What every drive tells: further labels, and a number.
    fn rows(&self, tell: impl Fn(&Sample) -> Vec<(Vec<Label>, String)>) -> Vec<Row> {
        let row = |sample| {
            let whole = |(more, number)| Row {
                suffix: "",
                labels: self.origin.labels(sample).into_iter().chain::<Vec<_>>(more).collect(),
                number,
            };
            tell(sample).into_iter().map(whole).collect::<Vec<_>>()
        };
        self.samples.values().flat_map(row).collect()
    }

    /// A word of every drive that has one, as the label of a 1.
    fn words(&self, name: &'static str, tell: impl Fn(&Sample) -> Option<String>) -> Vec<Row> {
        self.rows(|sample| tell(sample).into_iter().map(|word| (vec![(name, word)], "1".to_owned())).collect())
    }

    fn values(&self, of: impl Fn(&Value) -> bool) -> Vec<Row> {
        self.rows(|sample| {
            let values = sample.values.iter().map(|row| &row.value).filter(|value| of(value));
            values.filter_map(|value| Some((which(value), number(value)?))).collect()
        })
    }
}

/// Which parameter it is.
fn which(value: &Value) -> Vec<Label> {
    vec![
        ("param", value.param.to_string()),
        ("name", value.slug.clone()),
        ("data_set", value.data_set.to_string()),
        ("store", value.store.to_owned()),
        ("unit", value.unit.clone().unwrap_or_default()),
    ]
}

fn told(metric: &Metric, is_older: bool) -> String {
    let Metric { name, kind, help, rows } = metric;
    if rows.is_empty() {
        return String::new();
    }
    let rows = rows.iter().map(|Row { suffix, labels, number }| {
        let labels: Vec<_> = labels.iter().map(|(name, what)| format!("{name}=\"{}\"", escaped(what))).collect();
        format!("{name}{suffix}{{{}}} {number}\n", labels.join(","))
    });
    let whole = if is_older && *kind == "counter" { "_total" } else { "" };
    format!("# TYPE {name}{whole} {kind}\n# HELP {name}{whole} {help}\n{}", rows.collect::<String>())
}

/// A count of the line: name, what it is, where it stands.
type Count = (&'static str, &'static str, fn(&LineNews) -> u64);

const COUNTS: [Count; 4] = [
    ("antrieb_line_telegrams", "Telegrams sent, repeats included.", |line| line.telegrams),
    ("antrieb_line_repeats", "Repeats.", |line| line.repeats),
    ("antrieb_line_silences", "Requests that nobody answered in time.", |line| line.silences),
    ("antrieb_line_garbled", "Requests answered by garbage only.", |line| line.garbled),
];

/// A value of a label.
fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n")
}

/// Every round to stdout.
pub(super) struct OpenMetrics<'a> {
    out: &'a mut dyn Write,
    exposition: Exposition,
}

impl<'a> OpenMetrics<'a> {
    pub(super) fn new(out: &'a mut dyn Write) -> Self {
        OpenMetrics { out, exposition: Exposition::default() }
    }
}

impl Form for OpenMetrics<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        let Some(text) = self.exposition.note(record) else { return Ok(()) };
        self.out.write_all(text.as_bytes())?;
        self.out.flush()
    }
}

/// What takes the text of a round, whole.
pub type Keep = Box<dyn FnMut(&str) -> io::Result<()>>;

/// Every round beside another form, in the older text.
pub(super) struct Beside {
    keep: Keep,
    exposition: Exposition,
}

impl Beside {
    pub(super) fn new(keep: Keep) -> Self {
        Beside { keep, exposition: Exposition { is_older: true, ..Exposition::default() } }
    }

    pub(super) fn record(&mut self, record: &Record) -> io::Result<()> {
        self.exposition.note(record).map_or(Ok(()), |text| (self.keep)(&text))
    }
}
