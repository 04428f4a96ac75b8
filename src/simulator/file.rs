//! The file of a bench: TOML. Unknown keys are refused, with line and column.
//!
//! Times are written with their unit: `"750us"`, `"10ms"`, `"2s"`. Times of scripts count from the start of the bench.
//!
//! ```toml
//! [line]                   # the bus; all keys optional
//! seed = 7                 # for jitter and flipped bits; the same seed gives the same run
//! echo = false             # true: the master's adapter hears its own bytes
//!
//! [[drive]]
//! model = "acu"            # act | acu | foreign (a plain Modbus slave that is no drive of ours)
//! address = 2              # 1-247, default 1
//! protocol = "rtu"         # rtu (default) | ascii | vabus (P.395 = 0: silent on Modbus)
//! baud = 19200             # 2400, 4800, 9600, 19200 (default), 57600, 115200
//! parity = "even"          # even (default) | odd | none
//! data_bits = 8            # default 8; ASCII 7 (8 allowed)
//! reply_delay = "10ms"     # from the last bit of the request on; default 10 ms (CM-485 manual 6.8)
//! jitter = "0ms"           # up to this much more, by chance
//! load = "normal"          # high: replies after 700 ms (over 500 ms at CPU load above 90 %, CM-485 manual 6.8)
//! slow = "700ms"           # the same with a time of your own
//! strict_silence = false   # true: deaf to telegrams less than t3.5 after its own reply
//! enable = true            # S1IND, or STOA and STOB
//! start_right = true       # S2IND
//! start_left = false       # S3IND
//! mains = true             # false: an ACU lives on 24 V, an ACT is off
//! modules = ["EM-RES-03"]  # option modules; their parameters are unknown without them
//! # Values at power-on, in human units, "0x…" is raw. A switchable parameter gets all four data sets, or one by "@".
//! # A value for an actual value holds it still; P.228 is the internal setpoint.
//! set = { "372@2" = 1390, "376" = "1.5", "412" = 1 }
//!
//! [[drive.event]]          # script of this drive: `at`, and one or more of
//! at = "2s"
//! fault = "F0500"          # a fault
//! warning = 0x0082         # the warning word P.270
//! power_cycle = true       # mains off and on: 3 s off the bus
//! silent = "3s"            # off the bus, but it goes on working
//! mains = false            # and enable, start_right, start_left: contacts
//!
//! [[drive]]
//! model = "foreign"
//! address = 9
//! registers = { "0" = 17, "1" = 42 }   # holding registers; all others are exception 2
//!
//! [[disturb]]              # the line, not a drive: exactly one of `every`, `once`, `at`
//! every = 5                # every 5th reply; once = 5: only the 5th; at = "1s": the first one from then on
//! kind = "late"            # late (by) | lost | garbled (a bit flipped) | truncated (last third missing)
//!                          # | noise (a byte before it) | echo (of the request) | doubled | foreign (another station's)
//! by = "150ms"             # only with late
//! # byte = 0x00            # only with noise
//! address = 2              # only replies of this station; default all
//! ```

use super::Bench;
use super::active::Contacts;
use super::disturb::{Disturber, Kind, Rule, When};
use super::drive::Drive;
use super::setup::{Action, BAUD_RATES, Event, Model, PARITIES, Setup};
use crate::profile::value::{check_width, parse_decimal};
use crate::profile::{Family, Registry, Sets};
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::{Framing, LAST_STATION};
use crate::tick::{Span, Tick};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::ops::Range;
use toml::{Spanned, Value};

/// Why a bench file is refused, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{path}:{line}:{column}: {message}")]
pub struct BenchError {
    /// The file.
    pub path: String,
    /// Line, from 1.
    pub line: usize,
    /// Column, from 1.
    pub column: usize,
    /// What is wrong, and what was expected.
    pub message: String,
}

/// Longest bench file that is read.
const MAX_FILE: usize = 1 << 20;
/// Earliest reply (CM-485 manual 6.8).
const REPLY_DELAY: Span = Span::from_millis(10);
/// Reply time under high load: any time above 500 ms (CM-485 manual 6.8).
const SLOW: Span = Span::from_millis(700);
/// The wires of a drive that may run.
const CONTACTS: Contacts = Contacts { enable: true, right: true, left: false, mains: true };

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    line: LineTable,
    #[serde(default)]
    drive: Vec<Spanned<DriveTable>>,
    #[serde(default)]
    disturb: Vec<Spanned<DisturbTable>>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct LineTable {
    #[serde(default)]
    seed: u64,
    #[serde(default)]
    echo: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DriveTable {
    model: Spanned<String>,
    address: Option<Spanned<i64>>,
    protocol: Option<Spanned<String>>,
    baud: Option<Spanned<i64>>,
    parity: Option<Spanned<String>>,
    data_bits: Option<Spanned<i64>>,
    reply_delay: Option<Spanned<String>>,
    jitter: Option<Spanned<String>>,
    load: Option<Spanned<String>>,
    slow: Option<Spanned<String>>,
    #[serde(default)]
    strict_silence: bool,
    enable: Option<bool>,
    start_right: Option<bool>,
    start_left: Option<bool>,
    mains: Option<bool>,
    #[serde(default)]
    modules: Vec<Spanned<String>>,
    #[serde(default)]
    set: BTreeMap<String, Spanned<Value>>,
    #[serde(default)]
    registers: BTreeMap<String, Spanned<i64>>,
    #[serde(default)]
    event: Vec<Spanned<EventTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EventTable {
    at: Spanned<String>,
    fault: Option<Spanned<String>>,
    warning: Option<u16>,
    power_cycle: Option<bool>,
    silent: Option<Spanned<String>>,
    mains: Option<bool>,
    enable: Option<bool>,
    start_right: Option<bool>,
    start_left: Option<bool>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DisturbTable {
    every: Option<Spanned<u64>>,
    once: Option<Spanned<u64>>,
    at: Option<Spanned<String>>,
    kind: Spanned<String>,
    by: Option<Spanned<String>>,
    byte: Option<u8>,
    address: Option<Spanned<i64>>,
}

pub(super) fn standard(registry: &Registry) -> Bench {
    let drive = |model, address, modules: &[&str]| {
        let setup = Setup {
            modules: modules.iter().map(|&module| module.to_owned()).collect(),
            ..plain(model, address, LineSetting::rtu(19_200, Parity::Even))
        };
        Drive::new(setup, registry.family(model.name()).as_deref())
    };
    let drives = vec![drive(Model::Act, 1, &[]), drive(Model::Acu, 2, &["EM-RES-03"])];
    Bench::new(drives, Disturber::new(Vec::new(), false, 0))
}

/// A station with nothing special about it.
fn plain(model: Model, address: u8, line: LineSetting) -> Setup {
    Setup {
        model,
        address,
        framing: Some(Framing::Rtu),
        line,
        delay: REPLY_DELAY,
        jitter: Span::ZERO,
        strict_silence: false,
        contacts: CONTACTS,
        modules: Vec::new(),
        values: Vec::new(),
        registers: BTreeMap::new(),
        script: Vec::new(),
        seed: address.into(),
    }
}

pub(super) fn read(path: &str, text: &str, registry: &Registry) -> Result<Bench, BenchError> {
    let reader = Reader { path, text, registry };
    if text.len() > MAX_FILE {
        return Err(reader.error(0..0, format!("{} bytes; a bench file has at most {MAX_FILE}", text.len())));
    }
    let file: File = toml::from_str(text)
        .map_err(|error| reader.error(error.span().unwrap_or(0..0), error.message().replace('\n', " ")))?;
    if file.drive.is_empty() {
        return Err(reader.error(0..0, "no [[drive]]; expected at least one".to_owned()));
    }
    let drives = file.drive.iter().map(|table| reader.drive(table, file.line.seed)).collect::<Result<_, _>>()?;
    let rules = file.disturb.iter().map(|table| reader.rule(table)).collect::<Result<_, _>>()?;
    Ok(Bench::new(drives, Disturber::new(rules, file.line.echo, file.line.seed)))
}

struct Reader<'a> {
    path: &'a str,
    text: &'a str,
    registry: &'a Registry,
}

impl Reader<'_> {
    fn error(&self, span: Range<usize>, message: String) -> BenchError {
        let before = self.text.get(..span.start).unwrap_or("");
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        BenchError { path: self.path.to_owned(), line, column, message }
    }

    /// One of the words of a table.
    fn word<T: Copy>(&self, key: &str, got: &Spanned<String>, words: &[(&str, T)]) -> Result<T, BenchError> {
        let found = words.iter().find(|(word, _)| word == got.get_ref());
        found.map(|(_, value)| *value).ok_or_else(|| {
            let known: Vec<_> = words.iter().map(|row| row.0).collect();
            let message = format!("{key} = \"{}\"; expected one of: {}", got.get_ref(), known.join(", "));
            self.error(got.span(), message)
        })
    }

    fn time(&self, key: &str, got: &Spanned<String>) -> Result<Span, BenchError> {
        span(got.get_ref()).ok_or_else(|| {
            let message = format!("{key} = \"{}\"; expected a time with unit, such as \"10ms\", \"2s\"", got.get_ref());
            self.error(got.span(), message)
        })
    }

    fn time_or(&self, key: &str, got: Option<&Spanned<String>>, default: Span) -> Result<Span, BenchError> {
        got.map_or(Ok(default), |got| self.time(key, got))
    }

    fn station(&self, got: &Spanned<i64>) -> Result<u8, BenchError> {
        let station = u8::try_from(*got.get_ref()).ok().filter(|station| (1..=LAST_STATION).contains(station));
        let message = || format!("address = {}; expected 1 to {LAST_STATION}", got.get_ref());
        station.ok_or_else(|| self.error(got.span(), message()))
    }

    fn drive(&self, table: &Spanned<DriveTable>, seed: u64) -> Result<Drive, BenchError> {
        let row = table.get_ref();
        let model = self.word("model", &row.model, &Model::NAMES)?;
        let address = row.address.as_ref().map_or(Ok(1), |got| self.station(got))?;
        let protocols = [("rtu", Some(Framing::Rtu)), ("ascii", Some(Framing::Ascii)), ("vabus", None)];
        let framing =
            row.protocol.as_ref().map_or(Ok(Some(Framing::Rtu)), |got| self.word("protocol", got, &protocols))?;
        let family = self.registry.family(model.name());
        if family.is_none() && model != Model::Foreign {
            return Err(self.error(row.model.span(), format!("no catalogue describes model '{}'", model.name())));
        }
        if model != Model::Foreign && !row.registers.is_empty() {
            return Err(self.error(table.span(), "registers are for model foreign; expected set".to_owned()));
        }
        let mut setup = plain(model, address, self.line(row, framing)?);
        setup.framing = framing;
        setup.delay = self.delay(row)?;
        setup.jitter = self.time_or("jitter", row.jitter.as_ref(), Span::ZERO)?;
        setup.strict_silence = row.strict_silence;
        setup.contacts = Contacts {
            enable: row.enable.unwrap_or(CONTACTS.enable),
            right: row.start_right.unwrap_or(CONTACTS.right),
            left: row.start_left.unwrap_or(CONTACTS.left),
            mains: row.mains.unwrap_or(CONTACTS.mains),
        };
        setup.seed = seed.wrapping_mul(256).wrapping_add(address.into());
        setup.modules = row.modules.iter().map(|module| module.get_ref().clone()).collect();
        for module in &row.modules {
            self.check_module(module, family.as_deref())?;
        }
        for (key, value) in &row.set {
            setup.values.push(self.value(key, value, family.as_deref(), &setup.modules)?);
        }
        for (key, value) in &row.registers {
            let fits = |number: i64| u16::try_from(number).ok();
            let register = key.parse().ok().and_then(fits).zip(fits(*value.get_ref()));
            let message = || format!("register \"{key}\" = {}; both expected 0 to 65535", value.get_ref());
            let (number, value) = register.ok_or_else(|| self.error(value.span(), message()))?;
            setup.registers.insert(number, value);
        }
        for event in &row.event {
            self.event(event, &mut setup.script)?;
        }
        Ok(Drive::new(setup, family.as_deref()))
    }

    fn line(&self, row: &DriveTable, framing: Option<Framing>) -> Result<LineSetting, BenchError> {
        let baud = match &row.baud {
            None => 19_200,
            Some(got) => {
                let known = BAUD_RATES.iter().find(|rate| i64::from(rate.1) == *got.get_ref());
                let rates: Vec<_> = BAUD_RATES.iter().map(|rate| rate.1.to_string()).collect();
                let message = || format!("baud = {}; expected one of: {}", got.get_ref(), rates.join(", "));
                known.ok_or_else(|| self.error(got.span(), message()))?.1
            }
        };
        let words = PARITIES.map(|(_, parity)| (parity.name(), parity));
        let parity = row.parity.as_ref().map_or(Ok(Parity::Even), |got| self.word("parity", got, &words))?;
        let ascii = framing == Some(Framing::Ascii);
        let line = if ascii { LineSetting::ascii(baud, parity) } else { LineSetting::rtu(baud, parity) };
        match row.data_bits.as_ref().map(|got| (*got.get_ref(), got)) {
            None => Ok(line),
            Some((8, _)) => Ok(LineSetting { data_bits: 8, ..line }),
            Some((7, _)) if ascii => Ok(line),
            Some((bits, got)) => {
                let message = format!("data_bits = {bits}; expected 8, or 7 with protocol ascii");
                Err(self.error(got.span(), message))
            }
        }
    }

    fn delay(&self, row: &DriveTable) -> Result<Span, BenchError> {
        if let Some(slow) = &row.slow {
            return self.time("slow", slow);
        }
        let high = row.load.as_ref().map(|got| self.word("load", got, &[("normal", false), ("high", true)]));
        match high.transpose()? {
            Some(true) => Ok(SLOW),
            _ => self.time_or("reply_delay", row.reply_delay.as_ref(), REPLY_DELAY),
        }
    }

    fn check_module(&self, module: &Spanned<String>, family: Option<&Family>) -> Result<(), BenchError> {
        let rows = family.into_iter().flat_map(|family| family.params.values());
        let mut known: Vec<&str> = rows.filter_map(|param| param.module.as_deref()).collect();
        known.sort_unstable();
        known.dedup();
        if known.contains(&module.get_ref().as_str()) {
            return Ok(());
        }
        let message = format!("module \"{}\"; expected one of: {}", module.get_ref(), known.join(", "));
        Err(self.error(module.span(), message))
    }

    /// A row of `set`: number, data set, raw value.
    fn value(
        &self,
        key: &str,
        value: &Spanned<Value>,
        family: Option<&Family>,
        modules: &[String],
    ) -> Result<(u32, u8, i64), BenchError> {
        let refuse = |message: String| self.error(value.span(), format!("set \"{key}\": {message}"));
        let (number, set) = match key.split_once('@') {
            None => (key, Some(0)),
            Some((number, set)) => (number, set.parse().ok().filter(|set| (1..=4u8).contains(set))),
        };
        let set = set.ok_or_else(|| refuse("expected data set 1 to 4 after @".to_owned()))?;
        let param = number.parse().ok().and_then(|number| family?.param(number));
        let param = param.filter(|param| param.module.as_ref().is_none_or(|module| modules.contains(module)));
        let param = param.ok_or_else(|| refuse("this drive has no such parameter; expected its number".to_owned()))?;
        if set != 0 && param.sets != Some(Sets::Four) {
            return Err(refuse("exists once; expected no data set".to_owned()));
        }
        let decimals = param.decimals_or_zero();
        let raw = match value.get_ref() {
            Value::String(text) => match text.strip_prefix("0x") {
                Some(hex) => i64::from_str_radix(hex, 16).map_err(|_| refuse(format!("'{text}' is no number")))?,
                None => parse_decimal(text, decimals).map_err(|error| refuse(error.to_string()))?,
            },
            Value::Integer(number) => {
                parse_decimal(&number.to_string(), decimals).map_err(|error| refuse(error.to_string()))?
            }
            Value::Float(number) => {
                parse_decimal(&number.to_string(), decimals).map_err(|error| refuse(error.to_string()))?
            }
            other => return Err(refuse(format!("{} given; expected a number", other.type_str()))),
        };
        let kind = param.kind.unwrap_or(crate::profile::Type::Long);
        check_width(raw, kind, decimals).map_err(|error| refuse(error.to_string()))?;
        Ok((param.id, set, raw))
    }

    fn event(&self, table: &Spanned<EventTable>, script: &mut Vec<Event>) -> Result<(), BenchError> {
        let row = table.get_ref();
        let at = Tick::ZERO + self.time("at", &row.at)?;
        let mut actions = Vec::new();
        if let Some(fault) = &row.fault {
            let digits = fault.get_ref().strip_prefix('F').filter(|digits| digits.len() == 4);
            let code = digits.and_then(|digits| u16::from_str_radix(digits, 16).ok());
            let message = || format!("fault = \"{}\"; expected F and 4 digits, such as \"F0500\"", fault.get_ref());
            actions.push(Action::Fault(code.ok_or_else(|| self.error(fault.span(), message()))?));
        }
        actions.extend(row.warning.map(Action::Warning));
        if let Some(silent) = &row.silent {
            actions.push(Action::Silent(self.time("silent", silent)?));
        }
        actions.extend(row.power_cycle.filter(|&cycle| cycle).map(|_| Action::PowerCycle));
        actions.extend(row.mains.map(Action::Mains));
        actions.extend(row.enable.map(Action::Enable));
        actions.extend(row.start_right.map(Action::StartRight));
        actions.extend(row.start_left.map(Action::StartLeft));
        if actions.is_empty() {
            let message = "nothing happens in this event; expected fault, warning, power_cycle, silent, mains, \
                           enable, start_right or start_left";
            return Err(self.error(table.span(), message.to_owned()));
        }
        script.extend(actions.into_iter().map(|action| Event { at, action }));
        Ok(())
    }

    fn rule(&self, table: &Spanned<DisturbTable>) -> Result<Rule, BenchError> {
        let row = table.get_ref();
        let positive = |got: &Spanned<u64>| match *got.get_ref() {
            0 => Err(self.error(got.span(), "0 hits nothing; expected 1 or more".to_owned())),
            count => Ok(count),
        };
        let when = match (&row.every, &row.once, &row.at) {
            (Some(every), None, None) => When::Every(positive(every)?),
            (None, Some(once), None) => When::Once(positive(once)?),
            (None, None, Some(at)) => When::From(Tick::ZERO + self.time("at", at)?),
            _ => return Err(self.error(table.span(), "expected exactly one of: every, once, at".to_owned())),
        };
        let by = self.time_or("by", row.by.as_ref(), Span::from_millis(150))?;
        let kinds = [
            ("late", Kind::Late(by)),
            ("lost", Kind::Lost),
            ("garbled", Kind::Garbled),
            ("truncated", Kind::Truncated),
            ("noise", Kind::Noise(row.byte.unwrap_or(0))),
            ("echo", Kind::Echo),
            ("doubled", Kind::Doubled),
            ("foreign", Kind::Foreign),
        ];
        let kind = self.word("kind", &row.kind, &kinds)?;
        if let Some(by) = row.by.as_ref().filter(|_| !matches!(kind, Kind::Late(_))) {
            return Err(self.error(by.span(), "by goes only with kind = \"late\"".to_owned()));
        }
        if row.byte.is_some() && !matches!(kind, Kind::Noise(_)) {
            return Err(self.error(table.span(), "byte goes only with kind = \"noise\"".to_owned()));
        }
        let station = row.address.as_ref().map(|got| self.station(got)).transpose()?;
        Ok(Rule::new(when, kind, station))
    }
}

/// Reads `750us`, `10ms`, `1.5s`.
fn span(text: &str) -> Option<Span> {
    let text = text.trim();
    let units = [("us", 0), ("ms", 3), ("s", 6)];
    let (number, decimals) = units.iter().find_map(|(unit, decimals)| Some((text.strip_suffix(unit)?, *decimals)))?;
    let micros = parse_decimal(number.trim(), decimals).ok()?;
    Some(Span::from_micros(u64::try_from(micros).ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bench(text: &str) -> Result<Bench, BenchError> {
        read("bench.toml", text, &Registry::open(&[]).unwrap())
    }

    fn refused(text: &str) -> String {
        bench(text).unwrap_err().to_string()
    }

    /// The example of the module's comment, as it stands there.
    fn example() -> String {
        let lines = include_str!("file.rs").lines().map_while(|line| line.strip_prefix("//!"));
        let lines = lines.skip_while(|line| line.trim() != "```toml").skip(1).take_while(|line| line.trim() != "```");
        lines.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn the_example_of_the_manual_page_is_a_bench() {
        let bench = bench(&example()).unwrap();
        let models: Vec<_> = bench.drives().map(|drive| (drive.model(), drive.address())).collect();
        assert_eq!(models, [("acu", 2), ("foreign", 9)]);
        let acu = bench.drive(2).unwrap();
        assert_eq!((acu.ram(376, 3), acu.ram(412, 0), acu.eeprom_writes()), (Some(15), Some(1), 0));
    }

    #[test]
    fn settings_of_the_line_are_those_of_the_parameters() {
        let text = "[[drive]]\nmodel = \"act\"\naddress = 7\nprotocol = \"ascii\"\nbaud = 9600\nparity = \"none\"";
        let bench = bench(text).unwrap();
        let drive = bench.drive(7).unwrap();
        assert_eq!(drive.line().to_string(), "9600 7N2");
        assert_eq!((drive.ram(10, 0), drive.ram(1375, 0), drive.ram(395, 0)), (Some(3), Some(2), Some(3)));
    }

    #[test]
    fn refusals_say_where_and_what_was_expected() {
        let drive = |rest: &str| refused(&format!("[[drive]]\nmodel = \"act\"\n{rest}\n"));
        assert_eq!(drive("address = 248"), "bench.toml:3:11: address = 248; expected 1 to 247");
        assert_eq!(drive("parity = \"mark\""), "bench.toml:3:10: parity = \"mark\"; expected one of: even, odd, none");
        assert!(drive("colour = 1").starts_with("bench.toml:3:1: unknown field `colour`"), "{}", drive("colour = 1"));
        assert!(drive("set = { \"372@5\" = 1 }").contains("expected data set 1 to 4"));
        assert!(drive("set = { \"1\" = 1 }").contains("no such parameter"));
        assert!(drive("set = { \"376\" = \"1.55\" }").contains("more decimals"));
        assert!(drive("set = { \"900\" = 1 }").contains("no such parameter"));
        assert!(drive("modules = [\"X\"]").contains("expected one of: EM-RES-03"));
        assert!(drive("reply_delay = \"10\"").contains("a time with unit"));
        assert!(drive("[[drive.event]]\nat = \"1s\"").contains("nothing happens"));
        assert!(drive("[[drive.event]]\nat = \"1s\"\nfault = \"500\"").contains("F and 4 digits"));
        assert!(drive("[[disturb]]\nkind = \"lost\"").contains("exactly one of"));
        assert!(refused("").contains("at least one"));
    }

    #[test]
    fn times_need_a_unit() {
        assert_eq!(span("1.5s"), Some(Span::from_millis(1_500)));
        assert_eq!(span("750 us"), Some(Span::from_micros(750)));
        assert_eq!(span("-1s").or(span("3")).or(span("s")), None);
    }
}
