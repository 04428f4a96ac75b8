//! The file of a bench: TOML. Unknown keys are refused, with line and column.
//!
//! Times are written with their unit: `"750us"`, `"10ms"`, `"2s"`. Times of scripts count from the start of the bench.
//!
//! ```toml
#![doc = include_str!("bench.toml")]
//! ```

mod scenes;
mod servo;
mod tables;

use super::Bench;
use super::active::Active;
use super::disturb::Disturber;
use super::drive::Drive;
use super::setup::{BAUD_RATES, Model, PARITIES, REPLY_DELAY, Setup, Spoken};
use super::shaft::Ramps;
use super::vabus::Node;
use crate::profile::value::{check_width, parse_decimal};
use crate::profile::{Family, Registry, Sets, Type};
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::LAST_STATION;
use crate::protocol::vabus::{Address, Data, SystemNode};
use crate::tick::Span;
use std::collections::BTreeMap;
use std::ops::Range;
use tables::{DriveTable, File, NodeTable, RampTable};
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
/// Reply time under high load: any time above 500 ms (CM-485 manual 6.8).
const SLOW: Span = Span::from_millis(700);
/// Steepest ramp, 0.01 Hz/s: the range of P.424 and P.425 (CM-485 manual 11.2).
const STEEPEST: i64 = 999_999;
/// Heaviest load, percent of the rated torque.
const HEAVIEST: i64 = 1_000;

pub(super) fn standard(registry: &Registry) -> Bench {
    let drive = |model, address, modules: &[&str]| {
        let setup = Setup {
            modules: modules.iter().map(|&module| module.to_owned()).collect(),
            ..Setup::plain(model, address)
        };
        Drive::new(setup, registry.family(model.name()).as_deref())
    };
    let drives = vec![drive(Model::Act, 1, &[]), drive(Model::Acu, 2, &["EM-RES-03"])];
    Bench::new(drives, Disturber::new(Vec::new(), false, 0))
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
    let drives = file.drive.iter().map(|table| reader.drive(table, file.line.seed));
    let drives: Vec<Drive> = drives.collect::<Result<_, _>>()?;
    let spoken = drives.first().map_or(Spoken::RTU, Drive::spoken);
    let (mut rules, mut babblers) = (Vec::new(), Vec::new());
    for table in &file.disturb {
        match reader.babbler(table, spoken)? {
            Some(babbler) => babblers.push(babbler),
            None => rules.push(reader.rule(table)?),
        }
    }
    let mut disturber = Disturber::new(rules, file.line.echo, file.line.seed);
    disturber.babblers = babblers;
    Ok(Bench::new(drives, disturber))
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
        if model == Model::Lxm05 {
            return self.servo(table, address, seed);
        }
        if row.servo.is_some() || row.stop_bits.is_some() {
            return Err(self.error(table.span(), "servo and stop_bits are for model lxm05".to_owned()));
        }
        let protocols = [Spoken::RTU, Spoken::ASCII, Spoken::Vabus].map(|spoken| (spoken.name(), spoken));
        let spoken = row.protocol.as_ref().map_or(Ok(Spoken::RTU), |got| self.word("protocol", got, &protocols))?;
        let out_of_range = spoken == Spoken::Vabus && Address::drive(address).is_none();
        if let Some(got) = row.address.as_ref().filter(|_| out_of_range) {
            let message = format!("address = {address}; expected 1 to {} with protocol vabus", Address::LAST);
            return Err(self.error(got.span(), message));
        }
        let family = self.registry.family(model.name());
        if family.is_none() && model != Model::Foreign {
            return Err(self.error(row.model.span(), format!("no catalogue describes model '{}'", model.name())));
        }
        if model != Model::Foreign && !row.registers.is_empty() {
            return Err(self.error(table.span(), "registers are for model foreign; expected set".to_owned()));
        }
        let mut setup = Setup::plain(model, address);
        setup.line = self.line(row, spoken)?;
        setup.spoken = spoken;
        setup.delay = self.delay(row)?;
        setup.jitter = self.time_or("jitter", row.jitter.as_ref(), Span::ZERO)?;
        setup.strict_silence = row.strict_silence;
        setup.readings = self.readings(row, model)?;
        setup.strict_remote = row.strict_remote;
        for sto in [&row.stoa, &row.stob].into_iter().flatten() {
            self.check_sto(sto, model)?;
        }
        let contacts = &mut setup.contacts;
        contacts.sto_a = *row.stoa.as_ref().map_or(&row.enable, Spanned::get_ref);
        contacts.sto_b = model != Model::Acu || *row.stob.as_ref().map_or(&row.enable, Spanned::get_ref);
        contacts.right = row.start_right.unwrap_or(contacts.right);
        contacts.left = row.start_left.unwrap_or(contacts.left);
        contacts.mains = row.mains.unwrap_or(contacts.mains);
        if let Some(torque) = &row.torque {
            setup.torque = self.torque(torque)?;
        }
        if let Some(ramps) = &row.ramps {
            self.ramps(ramps, &mut setup.ramps)?;
        }
        setup.seed = own_seed(seed, address);
        setup.modules = row.modules.iter().map(|module| module.get_ref().clone()).collect();
        for module in &row.modules {
            self.check_module(module, family.as_deref())?;
        }
        self.values(&row.set, family.as_deref(), &mut setup)?;
        for node in &row.nodes {
            setup.nodes.push(self.node(node, model, &setup.nodes)?);
        }
        for (key, value) in &row.registers {
            let fits = |number: i64| u16::try_from(number).ok();
            let register = key.parse().ok().and_then(fits).zip(fits(*value.get_ref()));
            let message = || format!("register \"{key}\" = {}; both expected 0 to 65535", value.get_ref());
            let (number, value) = register.ok_or_else(|| self.error(value.span(), message()))?;
            setup.registers.insert(number, value);
        }
        for event in &row.event {
            self.event(event, model, &mut setup.script)?;
        }
        Ok(Drive::new(setup, family.as_deref()))
    }

    /// A drive behind this one, on the system bus.
    fn node(&self, table: &Spanned<NodeTable>, master: Model, others: &[Node]) -> Result<Node, BenchError> {
        let row = table.get_ref();
        let refuse = |span, message: &str| Err(self.error(span, message.to_owned()));
        let Some(id) = SystemNode::new(row.id).filter(|id| *id != SystemNode::SELF).map(SystemNode::id) else {
            return refuse(table.span(), &format!("id = {}; expected a node 1 to {}", row.id, SystemNode::LAST));
        };
        if others.iter().any(|other| other.id == id) {
            return refuse(table.span(), &format!("node {id} is there already"));
        }
        let drives = [("act", Model::Act), ("acu", Model::Acu)];
        if !drives.iter().any(|row| row.1 == master) {
            return refuse(table.span(), "only an ACT or ACU is master of a system bus");
        }
        let model = self.word("model", &row.model, &drives)?;
        let family = self.registry.family(model.name());
        let mut setup = Setup::plain(model, 1);
        setup.modules = row.modules.iter().map(|module| module.get_ref().clone()).collect();
        for module in &row.modules {
            self.check_module(module, family.as_deref())?;
        }
        self.values(&row.set, family.as_deref(), &mut setup)?;
        Ok(Node::new(id, Active::new(&setup, family.as_deref())))
    }

    /// The rows of `set`.
    fn values(
        &self,
        set: &BTreeMap<String, Spanned<Value>>,
        family: Option<&Family>,
        setup: &mut Setup,
    ) -> Result<(), BenchError> {
        for (key, value) in set {
            let param = key.parse().ok().and_then(|number| family?.param(number));
            match param.filter(|param| param.kind == Some(Type::String)) {
                Some(param) => {
                    let text = value.get_ref().as_str().and_then(|text| Data::text(text.as_bytes()).ok());
                    let message = || format!("set \"{key}\": expected a text of 1 to {} ASCII characters", Data::MOST);
                    let text = text.filter(|text| text.characters().is_ascii());
                    let text = text.ok_or_else(|| self.error(value.span(), message()))?;
                    setup.texts.insert(param.id, text.characters().to_vec());
                }
                None => setup.values.push(self.value(key, value, family, &setup.modules)?),
            }
        }
        Ok(())
    }

    fn line(&self, row: &DriveTable, spoken: Spoken) -> Result<LineSetting, BenchError> {
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
        let line = match spoken {
            Spoken::ASCII => LineSetting::ascii(baud, parity),
            Spoken::Vabus => LineSetting { parity, ..LineSetting::vabus(baud) },
            Spoken::Modbus(_) | Spoken::PBus => LineSetting::rtu(baud, parity),
        };
        match row.data_bits.as_ref().map(|got| (*got.get_ref(), got)) {
            None => Ok(line),
            Some((8, _)) => Ok(LineSetting { data_bits: 8, ..line }),
            Some((7, _)) if line.data_bits == 7 => Ok(line),
            Some((bits, got)) => {
                let message = format!("data_bits = {bits}; expected 8, or 7 with protocol ascii or vabus");
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

    /// An ACT has one input for the enable (CM-485 manual 9).
    fn check_sto(&self, got: &Spanned<bool>, model: Model) -> Result<(), BenchError> {
        match model {
            Model::Acu => Ok(()),
            _ => Err(self.error(got.span(), "only an ACU has STOA and STOB; expected enable".to_owned())),
        }
    }

    fn torque(&self, got: &Spanned<i64>) -> Result<i64, BenchError> {
        let torque = Some(*got.get_ref()).filter(|torque| (0..=HEAVIEST).contains(torque));
        let message = || format!("torque = {}; expected 0 to {HEAVIEST} % of the rated torque", got.get_ref());
        torque.ok_or_else(|| self.error(got.span(), message()))
    }

    fn ramps(&self, table: &RampTable, ramps: &mut Ramps) -> Result<(), BenchError> {
        for (got, slope) in [
            (&table.up_right, &mut ramps.up_right),
            (&table.down_right, &mut ramps.down_right),
            (&table.up_left, &mut ramps.up_left),
            (&table.down_left, &mut ramps.down_left),
        ] {
            let Some(got) = got else { continue };
            let raw = decimal(got.get_ref(), 2).map_err(|message| self.error(got.span(), message))?;
            let known = Some(raw).filter(|raw| (1..=STEEPEST).contains(raw));
            let message = || format!("{} Hz/s; expected 0.01 to 9999.99", got.get_ref());
            *slope = known.ok_or_else(|| self.error(got.span(), message()))?;
        }
        Ok(())
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
            Some((number, text)) => {
                let ram = text.strip_suffix("ram");
                let set = ram.unwrap_or(text).parse().ok().filter(|set| (1..=4u8).contains(set));
                (number, set.map(|set| if ram.is_some() { set + RAM_OFFSET } else { set }))
            }
        };
        let set = set.ok_or_else(|| refuse("expected data set 1 to 4 after @, or 1ram to 4ram".to_owned()))?;
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
                None => decimal(value.get_ref(), decimals).map_err(refuse)?,
            },
            number => decimal(number, decimals).map_err(refuse)?,
        };
        let kind = param.kind.unwrap_or(crate::profile::Type::Long);
        check_width(raw, kind, decimals).map_err(|error| refuse(error.to_string()))?;
        Ok((param.id, set, raw))
    }
}

/// RAM data sets are numbered 5 above their EEPROM twins (CM-485 manual 7).
const RAM_OFFSET: u8 = 5;

/// What a drive throws its dice with.
fn own_seed(seed: u64, address: u8) -> u64 {
    seed.wrapping_mul(256).wrapping_add(address.into())
}

/// Reads a number, written as one or as text.
fn decimal(value: &Value, decimals: u8) -> Result<i64, String> {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Integer(number) => number.to_string(),
        Value::Float(number) => number.to_string(),
        other => return Err(format!("{} given; expected a number", other.type_str())),
    };
    parse_decimal(&text, decimals).map_err(|error| error.to_string())
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

    #[test]
    fn the_example_of_the_manual_page_is_a_bench() {
        let bench = bench(include_str!("bench.toml")).unwrap();
        let models: Vec<_> = bench.drives().map(|drive| (drive.model(), drive.address())).collect();
        assert_eq!(models, [("acu", 2), ("lxm05", 3), ("foreign", 9)]);
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
        for fault in ["500", "F50", "F0000", "F-123"] {
            let text = format!("[[drive.event]]\nat = \"1s\"\nfault = \"{fault}\"");
            assert!(drive(&text).contains("F and 4 digits"), "{fault}");
        }
        assert!(drive("[[drive.event]]\nfault = \"F0500\"").contains("exactly one of: at, when, after_writes"));
        assert!(drive("[[drive.event]]\nat = \"1s\"\nwhen = \"running\"\nmains = false").contains("exactly one of"));
        for when in ["standing", "above", "above Hz", "above -3Hz", "above 20"] {
            let text = format!("[[drive.event]]\nwhen = \"{when}\"\nmains = false");
            assert!(drive(&text).contains("\"above 20Hz\""), "{when}");
        }
        assert!(drive("[[drive.event]]\nafter_writes = 0\nmains = false").contains("1 or more"));
        assert!(drive("[[drive.event]]\nat = \"1s\"\nstob = false").contains("only an ACU"));
        assert!(drive("stoa = false").contains("only an ACU"));
        assert!(drive("torque = 1001").contains("expected 0 to 1000"));
        assert!(drive("ramps = { up_right = 0 }").contains("0.01 to 9999.99"));
        assert!(drive("ramps = { up_right = 1.234 }").contains("more decimals"));
        assert!(drive("ramps = { up = 1 }").contains("unknown field `up`"));
        assert!(drive("[[disturb]]\nkind = \"lost\"").contains("exactly one of"));
        assert!(drive("[[disturb]]\nkind = \"babble\"\nevery = 3").contains("only with at, by"));
        assert!(drive("[[disturb]]\nkind = \"babble\"\npattern = \"5\"").contains("bytes in hex"));
        assert!(drive("[[disturb]]\nevery = 1\nkind = \"twin\"\nfor = \"1s\"").contains("only with kind = \"babble\""));
        assert!(refused("").contains("at least one"));
    }

    #[test]
    fn times_need_a_unit() {
        assert_eq!(span("1.5s"), Some(Span::from_millis(1_500)));
        assert_eq!(span("750 us"), Some(Span::from_micros(750)));
        assert_eq!(span("-1s").or(span("3")).or(span("s")), None);
    }
}
