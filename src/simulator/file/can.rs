//! What a bench file says of a CAN bus.

use super::reader::{BenchFile, Model, from_to, one_of};
use super::tables::DriveTable;
use crate::profile::{Broken, Registry, stumbled};
use crate::protocol::can::candump::{What, what};
use crate::protocol::can::{Frame, LAST_DRIVE};
use crate::protocol::line::LineSetting;
use crate::simulator::can::adapter::Quirks;
use crate::simulator::can::bus::{Can, Foreign, RATE, Setup};
use crate::simulator::can::node::{Node, RATES};
use crate::simulator::can::readings::{Reading, Readings};
use crate::simulator::device::active;
use crate::simulator::device::contract::NodeSetting;
use crate::simulator::device::readings::Reading as _;
use crate::simulator::line::speech::Spoken;
use crate::simulator::station::script::Script;
use crate::text::both;
use crate::tick::{Span, Tick};
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    bus: BusTable,
    #[serde(default)]
    adapter: AdapterTable,
    #[serde(default)]
    readings: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    drive: Vec<Spanned<DriveTable>>,
    #[serde(default)]
    foreign: Vec<ForeignTable>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct BusTable {
    rate: Option<Spanned<u32>>,
    #[serde(default)]
    seed: u64,
    #[serde(default)]
    losses: u64,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct AdapterTable {
    acknowledges: Option<bool>,
    listens: Option<bool>,
    bell: Option<Spanned<String>>,
    latency: Option<Spanned<String>>,
    lacks: Option<u8>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ForeignTable {
    frame: Spanned<String>,
    every: Spanned<String>,
}

/// Parameters of a place on the bus (manual 7.2).
const NODE_ID: u32 = 900;
const BIT_RATE: u32 = 903;
const SDO2_ACTIVE: u32 = 923;
/// Where the system bus comes from.
const MODULE: &str = "EM-RES-03";
/// How long a drive takes for an answer, if the file does not say; not printed.
const REPLY_DELAY: Span = Span::from_millis(1);

impl Can {
    /// ACUs as nodes 1 and 2, no master, 500 kbit/s.
    pub fn standard(registry: &Registry) -> Self {
        let nodes = [1, 2].map(|id| {
            let mut setup = active::setup::Setup::plain(true);
            setup.modules.push(MODULE.to_owned());
            setup.values = place(id, RATE);
            node(&setup, registry, Model::Acu, Script::new(Vec::new()), Readings::default(), REPLY_DELAY)
        });
        let setup = Setup { rate: RATE, quirks: Quirks::default(), foreign: Vec::new(), losses: 0, seed: 0 };
        Can::new(setup, nodes.into())
    }

    /// The bus of a file; `path` is only for the messages.
    pub fn from_toml(path: &str, text: &str, registry: &Registry) -> Result<Self, Broken> {
        let reader = BenchFile { path, text, registry };
        let file: File = toml::from_str(text).map_err(|error| {
            let (at, why) = stumbled(&error);
            reader.error(at..at, why)
        })?;
        if file.drive.is_empty() {
            let message = both!("no [[drive]]; expected at least one", "kein [[drive]]; erwartet: mindestens eines");
            return Err(reader.error(0..0, message));
        }
        let rate = match &file.bus.rate {
            Some(got) if !RATES.iter().any(|row| row.0 == *got.get_ref()) => {
                let known = RATES.map(|row| row.0.to_string()).join(", ");
                return Err(reader.unfit("rate", got.span(), got.get_ref(), &one_of(&known)));
            }
            got => got.as_ref().map_or(RATE, |got| *got.get_ref()),
        };
        let mut readings = Readings::default();
        for (key, word) in &file.readings {
            let message =
                || both!("readings: a bus has no question \"{key}\"", "readings: ein Bus hat keine Frage \"{key}\"");
            let question = Reading::question(key).ok_or_else(|| reader.error(word.span(), message()))?;
            if let Some(reading) = reader.word(key, word, question.words)? {
                readings.add(reading);
            }
        }
        let quirks = reader.quirks(&file.adapter)?;
        let foreign = file.foreign.iter().map(|row| reader.foreign(row)).collect::<Result<_, _>>()?;
        let nodes = file.drive.iter().map(|table| reader.on_bus(table, rate, readings)).collect::<Result<_, _>>()?;
        let BusTable { losses, seed, .. } = file.bus;
        Ok(Can::new(Setup { rate, quirks, foreign, losses, seed }, nodes))
    }
}

impl BenchFile<'_> {
    fn quirks(&self, table: &AdapterTable) -> Result<Quirks, Broken> {
        let usual = Quirks::default();
        Ok(Quirks {
            acknowledges: table.acknowledges.unwrap_or(usual.acknowledges),
            listens: table.listens.unwrap_or(usual.listens),
            bell: self.time_or("bell", table.bell.as_ref(), usual.bell)?,
            latency: self.time_or("latency", table.latency.as_ref(), usual.latency)?,
            lacks: table.lacks,
        })
    }

    fn foreign(&self, row: &ForeignTable) -> Result<Foreign, Broken> {
        let frame: Option<Frame> = match what(row.frame.get_ref()) {
            Ok(What::Frame(frame)) => Some(frame),
            _ => None,
        };
        let expected = both!("a frame such as \"641#409B010000000000\"", "ein Frame wie \"641#409B010000000000\"");
        let frame = frame.ok_or_else(|| self.unfit("frame", row.frame.span(), &row.frame.get_ref(), &expected))?;
        let every = self.time("every", &row.every)?;
        if every < Span::from_millis(1) {
            let expected = both!("1ms or more", "mindestens 1ms");
            return Err(self.unfit("every", row.every.span(), &every, &expected));
        }
        Ok(Foreign { frame, every, at: Tick::ZERO + every })
    }

    /// A drive on the bus: as on a serial line, with its node in place of its address.
    fn on_bus(&self, table: &Spanned<DriveTable>, rate: u32, readings: Readings) -> Result<Node, Broken> {
        let row = table.get_ref();
        let model = self.word("model", &row.model, &[("act", Model::Act), ("acu", Model::Acu)])?;
        let id = row.address.as_ref().map_or(Ok(1), |got| {
            let id = u8::try_from(*got.get_ref()).ok().filter(|id| *id <= LAST_DRIVE);
            id.ok_or_else(|| self.unfit("address", got.span(), got.get_ref(), &from_to(0, LAST_DRIVE)))
        })?;
        let reply_delay = self.time_or("reply_delay", row.reply_delay.as_ref(), REPLY_DELAY)?;
        let family = self.registry.family(model.name());
        let mut setup = self.active_with(row, model, family.as_deref(), &[MODULE])?;
        let own = std::mem::replace(&mut setup.values, place(id, rate));
        setup.values.extend(own);
        for (key, value) in &row.sources {
            let source = key.parse().ok().filter(|source| *source < u16::MAX);
            let expected = || both!("the number of a source and its value", "die Nummer einer Quelle und ihr Wert");
            let source = source.ok_or_else(|| self.unfit("sources", value.span(), key, &expected()))?;
            setup.sources.insert(source, *value.get_ref());
        }
        let mut events = Vec::new();
        for event in &row.event {
            events.extend(self.active_events(event, model, family.as_deref(), &setup)?);
        }
        Ok(node(&setup, self.registry, model, Script::new(events), readings, reply_delay))
    }
}

/// The parameters of a place on the bus, with SDO2 switched on, of which no factory setting is printed.
fn place(id: u8, rate: u32) -> Vec<(u32, u8, i64)> {
    let code = RATES.iter().find(|row| row.0 == rate).map_or(0, |row| row.1);
    vec![(NODE_ID, 0, id.into()), (BIT_RATE, 0, code), (SDO2_ACTIVE, 0, 1)]
}

fn node(
    setup: &active::setup::Setup,
    registry: &Registry,
    model: Model,
    script: Script,
    readings: Readings,
    reply_delay: Span,
) -> Node {
    let place = NodeSetting {
        address: 1,
        spoken: Spoken::RTU,
        line: LineSetting::rtu(19_200, crate::protocol::line::Parity::Even),
    };
    let family = registry.family(model.name());
    let device = active::Drive::new(setup, place, Vec::new(), family.as_deref());
    Node::new(Box::new(device), script, readings, reply_delay)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulator::device::readings::are_told;

    const EXAMPLE: &str = include_str!("../can.toml");

    fn bus(text: &str) -> Result<Can, String> {
        let registry = Registry::open(&[]).unwrap();
        Can::from_toml("bus.toml", text, &registry).map_err(|error| error.to_string())
    }

    #[test]
    fn the_example_is_a_bus_and_tells_every_reading() {
        let nodes: Vec<_> = bus(EXAMPLE).unwrap().nodes().collect();
        assert_eq!(nodes, [("acu", Some(5), 500_000), ("acu", Some(0), 500_000)]);
        are_told::<Reading>(EXAMPLE);
    }

    #[test]
    fn a_node_may_have_another_bit_rate_than_its_bus() {
        let text =
            "[[drive]]\nmodel = \"acu\"\naddress = 1\n[[drive]]\nmodel = \"acu\"\naddress = 2\nset = { \"903\" = 8 }\n";
        let rates: Vec<_> = bus(text).unwrap().nodes().map(|row| row.2).collect();
        assert_eq!(rates, [500_000, 1_000_000]);
    }

    #[test]
    fn refusals_say_where_and_what_was_expected() {
        let drive = |rest: &str| bus(&format!("[[drive]]\nmodel = \"acu\"\n{rest}\n")).unwrap_err();
        assert_eq!(drive("address = 64"), "bus.toml:3:11: address = 64; expected 0 to 63");
        assert!(bus("[bus]\nrate = 10000\n[[drive]]\nmodel = \"acu\"").unwrap_err().contains("50000"));
        assert!(bus("[[drive]]\nmodel = \"lxm05\"").unwrap_err().contains("expected one of: act, acu"));
        assert!(drive("[[foreign]]\nframe = \"641\"\nevery = \"1s\"").contains("a frame such as"));
        assert!(drive("[[foreign]]\nframe = \"080#\"\nevery = \"1us\"").contains("1ms"));
        assert!(drive("[readings]\ncolour = \"red\"").contains("no question"));
        assert!(bus("").unwrap_err().contains("at least one"));
    }
}
