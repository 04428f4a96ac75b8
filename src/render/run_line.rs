//! The one line of a run that is held, on stderr: state, setpoint and actual value, current, warnings, what is left of its time,
//! and how it is stopped. What does not fit is left out as a whole, the least important first.

use super::stream::cells::{GAP, find, first_of, long, number};
use super::words::word;
use super::{clean, progress_width};
use crate::outcome::{Column, Decimal, Record, RunNews, Sample, Value};
use crate::profile::value::format_decimal;
use crate::text::Lang;
use unicode_width::UnicodeWidthStr;

/// Columns of a terminal that does not tell.
const USUAL: u16 = 80;

/// Warnings by their names take no more columns than this; of longer ones the first is named, and the others are counted.
const MOST: usize = 30;

/// The line, and what it knows.
pub(super) struct RunLine {
    lang: Lang,
    columns: Vec<Column>,
    news: Option<RunNews>,
    /// What was seen last; once the drive has fallen silent that it is.
    last: Option<Sample>,
    /// When it answered last.
    answered: Option<Decimal>,
    /// Columns of what stands there now.
    shown: usize,
}

impl RunLine {
    pub(super) fn new(lang: Lang) -> Self {
        RunLine { lang, columns: Vec::new(), news: None, last: None, answered: None, shown: 0 }
    }

    /// What is to be written for a record, if anything.
    pub(super) fn record(&mut self, record: &Record) -> Option<String> {
        match record {
            Record::Start(start) => {
                self.columns = start.drives.iter().flat_map(|drive| drive.columns.iter().cloned()).collect();
                None
            }
            Record::Run(news) => {
                self.news = Some(news.clone());
                self.last.clone().map(|last| self.written(&last))
            }
            Record::Sample(sample) => {
                if sample.error.is_none() {
                    self.answered = Some(sample.t);
                }
                self.last = Some(sample.clone());
                Some(self.written(sample))
            }
            _ => None,
        }
    }

    /// The line, over the one that stands there.
    fn written(&mut self, sample: &Sample) -> String {
        // The last column stays free: some terminals begin a new line behind it.
        let width = usize::from(progress_width().unwrap_or(USUAL)).saturating_sub(1);
        let line = self.line(sample, width);
        let columns = line.width();
        // Blanks wipe what it does not cover, on every terminal there is.
        let blanks = " ".repeat(self.shown.min(width).saturating_sub(columns));
        self.shown = columns;
        format!("\r{line}{blanks}")
    }

    /// What takes the line away, where one stands.
    pub(super) fn wiped(&mut self) -> Option<String> {
        let shown = std::mem::take(&mut self.shown);
        (shown > 0).then(|| format!("\r{}\r", " ".repeat(shown)))
    }

    fn value<'s>(&'s self, sample: &'s Sample, roles: &[&str]) -> Option<(&'s Column, &'s Value)> {
        let column = self.columns.iter().find(|column| column.role.is_some_and(|own| roles.contains(&own)))?;
        Some((column, find(column, sample)?))
    }

    fn has(&self, role: &str) -> bool {
        self.columns.iter().any(|column| column.role == Some(role))
    }

    /// Its parts in their order, each with its weight: the greatest is left out first.
    fn parts(&self, sample: &Sample) -> Vec<(u8, String)> {
        let mut parts = Vec::new();
        if sample.error.is_some() {
            parts.push((0, self.silence(sample.t)));
        }
        if let Some(state) = &sample.state {
            parts.push((0, state.name.get(self.lang).to_owned()));
        }
        parts.extend(self.speed(sample).map(|speed| (1, speed)));
        if let Some((column, position)) = self.value(sample, &["position"]) {
            let unit = column.unit.as_deref().unwrap_or("");
            let text = format!("{} {} {unit}", word(self.lang, "position"), number(position));
            parts.push((2, text.trim_end().to_owned()));
        }
        if let Some((column, warnings)) = self.value(sample, &["warnings"]).filter(|(_, value)| value.raw != Some(0)) {
            let named = long(column, warnings, self.lang);
            let told = if named.width() > MOST { first_of(column, warnings, self.lang) } else { named };
            parts.push((2, format!("{}: {told}", word(self.lang, "warnings"))));
        }
        if let Some((column, current)) = self.value(sample, &["current"]) {
            let unit = column.unit.as_deref().unwrap_or("");
            parts.push((5, format!("{} {unit}", number(current)).trim_end().to_owned()));
        }
        parts.extend(self.left(sample).map(|left| (4, left)));
        parts.extend(self.end().map(|end| (3, end)));
        parts
    }

    /// That nothing is known of the drive, and since when.
    fn silence(&self, t: Decimal) -> String {
        let Some(since) = self.answered else { return self.lang.pick("NO ANSWER", "KEINE ANTWORT").to_owned() };
        let gone = format_decimal(t.raw.saturating_sub(since.raw).max(0) / 100_000, 1);
        self.lang.pick("NO ANSWER for {} s", "KEINE ANTWORT seit {} s").replace("{}", &gone)
    }

    /// `25.00 -> 24.93 Hz`
    fn speed(&self, sample: &Sample) -> Option<String> {
        let given = self.news.as_ref().and_then(|news| {
            let Decimal { raw, decimals } = news.setpoint?;
            Some((format_decimal(raw, decimals), news.unit.clone().unwrap_or_default()))
        });
        let shown = |roles: &[&str]| {
            let (column, value) = self.value(sample, roles)?;
            Some((number(value), column.unit.clone().unwrap_or_default()))
        };
        let is_over = self.news.as_ref().is_some_and(|news| matches!(news.phase, "stopping" | "ended"));
        let given = given.or_else(|| shown(&["setpoint-ramp", "setpoint-bus"]).filter(|_| !is_over));
        let actual = shown(&["actual-frequency", "stator-frequency", "encoder-frequency", "actual-speed"]);
        let text = match (given, actual) {
            (Some((given, unit)), Some((actual, of))) if unit == of => format!("{given} -> {actual} {of}"),
            (Some((given, unit)), Some((actual, of))) => format!("{given} {unit} -> {actual} {of}"),
            (Some((given, unit)), None) if self.has("position") => format!("{given} {unit}"),
            (Some((given, unit)), None) if sample.error.is_none() => format!("{given} {unit} -> {GAP}"),
            (Some(_), None) => return None,
            (None, Some((actual, of))) => format!("{actual} {of}"),
            (None, None) => return None,
        };
        Some(text.trim_end().to_owned())
    }

    fn left(&self, sample: &Sample) -> Option<String> {
        let left = left(self.news.as_ref()?, sample.t)?;
        Some(self.lang.pick("{} s left", "noch {} s").replace("{}", &left))
    }

    /// How it is stopped, or that it is.
    fn end(&self) -> Option<String> {
        let news = self.news.as_ref()?;
        Some(match (news.phase, news.stop) {
            ("stopping", stop) => format!("{}: {stop}", self.lang.pick("stopping", "hält an")),
            (_, "keep") => self.lang.pick("Ctrl-C leaves: keep", "Strg-C verlässt: keep").to_owned(),
            (_, stop) => format!("{}: {stop}", self.lang.pick("Ctrl-C stops", "Strg-C")),
        })
    }

    /// As much of it as fits, whole parts only.
    fn line(&self, sample: &Sample, width: usize) -> String {
        let mut parts = self.parts(sample);
        loop {
            let line: Vec<String> = parts.iter().map(|(_, part)| clean(part)).collect();
            let line = line.join("  ");
            let last = parts.iter().enumerate().max_by_key(|(_, (weight, _))| *weight).map(|(index, _)| index);
            match last {
                Some(last) if line.width() > width => drop(parts.remove(last)),
                _ => return line,
            }
        }
    }
}

/// Seconds that a part of a run has left, with one decimal.
pub(super) fn left(news: &RunNews, t: Decimal) -> Option<String> {
    let left = news.ends?.raw.saturating_sub(t.raw).max(0);
    Some(format_decimal(left / 100_000, 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::failure::{Class, Failure};
    use crate::outcome::{ErrorDoc, SampleValue, State, StreamStart, WatchedDrive};
    use crate::text::Text;

    const RAW: i64 = 0x20;

    fn column(role: &'static str, unit: &str) -> Column {
        let unit = (!unit.is_empty()).then(|| unit.to_owned());
        let (slug, name) = (role.to_owned(), Text::name(role));
        Column {
            param: role.len() as u32,
            data_set: 0,
            store: "ram",
            slug,
            name,
            unit,
            role: Some(role),
            scaled: true,
            is_word: false,
        }
    }

    fn columns() -> Vec<Column> {
        vec![column("stator-frequency", "Hz"), column("current", "A"), column("warnings", "")]
    }

    fn value(column: Column, raw: i64) -> SampleValue {
        let t = Decimal { raw: 0, decimals: 6 };
        let is_number = column.role != Some("warnings");
        let value = Value {
            address: 1,
            node: 0,
            drive: "acu".to_owned(),
            param: column.param,
            index: None,
            slug: column.slug,
            name: column.name,
            data_set: 0,
            store: "ram",
            raw: Some(raw),
            value: is_number.then_some(Decimal { raw, decimals: 2 }),
            decimals: Some(2),
            unit: column.unit,
            text: (!is_number).then(|| Text::new("controller limits", "Regler begrenzt")),
            word: None,
            kind: None,
            origin: String::new(),
            unconfirmed: Vec::new(),
            expected: None,
            error: None,
            hex: false,
        };
        SampleValue { t, value }
    }

    fn line(lang: Lang, phase: &'static str, warnings: i64, width: usize) -> String {
        let t = Decimal { raw: 0, decimals: 6 };
        let mut line = RunLine::new(lang);
        let drives = vec![WatchedDrive {
            address: 1,
            node: 0,
            called: None,
            drive: "acu".to_owned(),
            title: None,
            columns: columns(),
        }];
        let (schema, tool, command, protocol) = (1, "antrieb", "sollwert", "rtu");
        let start = StreamStart {
            t,
            schema,
            tool,
            command,
            port: String::new(),
            begun: None,
            line: String::new(),
            protocol,
            interval: Some(t),
            waits: None,
            drives,
        };
        assert_eq!(line.record(&Record::Start(start)), None);
        let ends = Some(Decimal { raw: 12_345_678, decimals: 6 });
        let setpoint = (phase == "held").then_some(Decimal { raw: 2_500, decimals: 2 });
        let news =
            RunNews { t, address: 1, phase, setpoint, unit: Some("Hz".to_owned()), ends, stop: "ramp", keys: None };
        assert_eq!(line.record(&Record::Run(news)), None);
        let values =
            columns().into_iter().zip([2_493, 320, warnings]).map(|(column, raw)| value(column, raw)).collect();
        let name = Text::new("Operation enabled", "Betrieb freigegeben");
        let state = Some(State { slug: "operation-enabled".to_owned(), name });
        let t = Decimal { raw: 2_000_000, decimals: 6 };
        line.line(
            &Sample {
                t,
                n: 0,
                port: None,
                address: 1,
                node: 0,
                called: None,
                drive: "acu".to_owned(),
                state,
                values,
                error: None,
                line: None,
            },
            width,
        )
    }

    #[test]
    fn it_fits_into_80_columns_in_both_languages() {
        let whole = "Operation enabled  25.00 -> 24.93 Hz  3.20 A  10.3 s left  Ctrl-C stops: ramp";
        assert_eq!(line(Lang::En, "held", 0, 79), whole);
        let german = "Betrieb freigegeben  25.00 -> 24.93 Hz  3.20 A  noch 10.3 s  Strg-C: ramp";
        assert_eq!(line(Lang::De, "held", 0, 79), german);
        assert_eq!(line(Lang::De, "held", 0, 70), german.replace("  3.20 A", ""), "the current goes first");
    }

    #[test]
    fn what_does_not_fit_is_left_out_as_a_whole_and_a_warning_is_shown() {
        let warned = line(Lang::En, "held", RAW, 79);
        assert_eq!(warned, "Operation enabled  25.00 -> 24.93 Hz  warnings: controller limits");
        assert_eq!(line(Lang::En, "held", 0, 60), "Operation enabled  25.00 -> 24.93 Hz  Ctrl-C stops: ramp");
        assert_eq!(line(Lang::En, "held", 0, 40), "Operation enabled  25.00 -> 24.93 Hz");
        assert_eq!(line(Lang::En, "held", 0, 20), "Operation enabled");
        for width in 0..120 {
            assert!(line(Lang::De, "held", RAW, width).width() <= width, "{width}");
        }
    }

    #[test]
    fn behind_the_run_no_setpoint_is_shown_that_nobody_gives_any_more() {
        assert_eq!(
            line(Lang::En, "stopping", 0, 79),
            "Operation enabled  24.93 Hz  3.20 A  10.3 s left  stopping: ramp"
        );
    }

    #[test]
    fn a_drive_that_is_silent_is_said_to_be_and_for_how_long() {
        let at = |raw| Decimal { raw, decimals: 6 };
        let mut line = RunLine { answered: Some(at(2_000_000)), ..RunLine::new(Lang::De) };
        let failure = Failure::new(Class::Silence, "silence.no_reply", Text::name("no reply"));
        let gap = Sample {
            t: at(5_250_000),
            n: 7,
            port: None,
            address: 1,
            node: 0,
            called: None,
            drive: "acu".to_owned(),
            state: None,
            values: Vec::new(),
            error: Some(ErrorDoc::from(&failure)),
            line: None,
        };
        assert_eq!(line.record(&Record::Sample(gap)).as_deref(), Some("\rKEINE ANTWORT seit 3.2 s"));
        let news = |stop| {
            let (setpoint, unit) = (None, None);
            RunNews { t: at(5_300_000), address: 1, phase: "stopping", setpoint, unit, ends: None, stop, keys: None }
        };
        // The stop that is under way is told at once, whatever the drive answers.
        for stop in ["ramp", "coast"] {
            let shown = line.record(&Record::Run(news(stop))).unwrap();
            assert_eq!(shown.trim_end(), format!("\rKEINE ANTWORT seit 3.2 s  hält an: {stop}"));
        }
    }

    #[test]
    fn it_is_wiped_once() {
        let mut line = RunLine { shown: 3, ..RunLine::new(Lang::En) };
        assert_eq!((line.wiped().as_deref(), line.wiped()), (Some("\r   \r"), None));
    }
}
