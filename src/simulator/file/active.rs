//! What a bench file says of an ACT or ACU, and of a foreign slave.

use super::reader::{BenchFile, Model, PARITIES, decimal, from_to, one_of, quoted};
use super::tables::{DriveTable, EventTable, NodeTable, RampTable};
use crate::profile::value::check_width;
use crate::profile::{Broken, Family, Param, Sets, Type};
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::vabus::{Data, SystemNode};
use crate::simulator::device::active::line::BAUD_RATES;
use crate::simulator::device::active::setup::Setup;
use crate::simulator::device::active::{Active, Node};
use crate::simulator::device::contract::{Action, CellFault, Fault, NodeSetting};
use crate::simulator::device::shaft::Ramps;
use crate::simulator::line::speech::Spoken;
use crate::simulator::station::script::Event;
use crate::text::{Text, both};
use std::collections::BTreeMap;
use std::ops::Range;
use toml::{Spanned, Value};

/// The node on the system bus (EM-RES-03 manual 5.5).
const NODE_ID: u32 = 900;
/// Steepest ramp, 0.01 Hz/s: the range of P.424 and P.425 (CM-485 manual 11.2).
const STEEPEST: i64 = 999_999;
/// Heaviest load, percent of the rated torque.
const HEAVIEST: i64 = 1_000;

impl BenchFile<'_> {
    /// An ACT or ACU without its line.
    pub(crate) fn active(&self, row: &DriveTable, model: Model, family: Option<&Family>) -> Result<Setup, Broken> {
        self.active_with(row, model, family, &[])
    }

    /// The same with these option modules at least.
    pub(crate) fn active_with(
        &self,
        row: &DriveTable,
        model: Model,
        family: Option<&Family>,
        modules: &[&str],
    ) -> Result<Setup, Broken> {
        let mut setup = Setup::plain(model == Model::Acu);
        setup.modules = modules.iter().map(|&module| module.to_owned()).collect();
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
        setup.resolver = row.resolver.as_ref().map(|table| self.resolver(table)).transpose()?;
        setup.analog = row.analog.as_ref().map_or(Ok(setup.analog), |table| self.analog(table))?;
        setup.four.clone_from(&row.four);
        setup.other_width.clone_from(&row.other_width);
        self.equip(&row.modules, &row.set, family, &mut setup)?;
        setup.faulty = self.faulty(&row.eeprom, family, &setup)?;
        Ok(setup)
    }

    /// Cells of the EEPROM, and how each takes a write.
    fn faulty(
        &self,
        table: &BTreeMap<String, Spanned<String>>,
        family: Option<&Family>,
        setup: &Setup,
    ) -> Result<Vec<(u32, u8, Option<CellFault>)>, Broken> {
        let mut faulty = Vec::new();
        for (key, word) in table {
            let (param, set) = self.cell(key, word.span(), family, setup)?;
            if set >= RAM_OFFSET {
                let message =
                    both!("eeprom \"{key}\": expected no RAM", "eeprom \"{key}\": hier wird kein RAM erwartet");
                return Err(self.error(word.span(), message));
            }
            faulty.push((param.id, set, self.word("eeprom", word, FAULTS)?));
        }
        Ok(faulty)
    }

    /// The drives behind it, on the system bus.
    pub(crate) fn nodes(&self, row: &DriveTable, master: Model) -> Result<Vec<Node>, Broken> {
        let mut nodes = Vec::new();
        for node in &row.nodes {
            nodes.push(self.node(node, master, &nodes)?);
        }
        Ok(nodes)
    }

    /// Its option modules and the rows of `set`.
    fn equip(
        &self,
        modules: &[Spanned<String>],
        set: &BTreeMap<String, Spanned<Value>>,
        family: Option<&Family>,
        setup: &mut Setup,
    ) -> Result<(), Broken> {
        setup.modules.extend(modules.iter().map(|module| module.get_ref().clone()));
        for module in modules {
            self.check_module(module, family)?;
        }
        self.values(set, family, setup)
    }

    /// A drive behind this one, on the system bus.
    fn node(&self, table: &Spanned<NodeTable>, master: Model, others: &[Node]) -> Result<Node, Broken> {
        let row = table.get_ref();
        let refuse = |span, message: Text| Err(self.error(span, message));
        let Some(id) = SystemNode::new(row.id).filter(|id| *id != SystemNode::SELF).map(SystemNode::id) else {
            return Err(self.unfit("id", table.span(), &row.id, &from_to(1, SystemNode::LAST)));
        };
        if others.iter().any(|other| other.id == id) {
            return refuse(table.span(), both!("node {id} is there already", "den Knoten {id} gibt es schon"));
        }
        let drives = [("act", Model::Act), ("acu", Model::Acu)];
        if !drives.iter().any(|row| row.1 == master) {
            let message = both!(
                "only an ACT or ACU is master of a system bus",
                "nur ein ACT oder ACU ist Master eines Systembus"
            );
            return refuse(table.span(), message);
        }
        let model = self.word("model", &row.model, &drives)?;
        let family = self.registry.family(model.name());
        let mut setup = Setup::plain(model == Model::Acu);
        setup.values.push((NODE_ID, 0, id.into()));
        self.equip(&row.modules, &row.set, family.as_deref(), &mut setup)?;
        let place = NodeSetting { address: 1, spoken: Spoken::RTU, line: LineSetting::rtu(19_200, Parity::Even) };
        Ok(Node::new(id, Active::new(&setup, place, family.as_deref())))
    }

    /// The rows of `set`.
    fn values(
        &self,
        set: &BTreeMap<String, Spanned<Value>>,
        family: Option<&Family>,
        setup: &mut Setup,
    ) -> Result<(), Broken> {
        for (key, value) in set {
            let param = key.parse().ok().and_then(|number| family?.param(number));
            match param.filter(|param| param.kind == Some(Type::String)) {
                Some(param) => {
                    let text = value.get_ref().as_str().and_then(|text| Data::text(text.as_bytes()).ok());
                    let message = || {
                        both!(
                            "set \"{key}\": expected a text of 1 to {most} ASCII characters",
                            "set \"{key}\": erwartet wird ein Text von 1 bis {most} ASCII-Zeichen",
                            most = Data::MOST
                        )
                    };
                    let text = text.filter(|text| text.characters().is_ascii());
                    let text = text.ok_or_else(|| self.error(value.span(), message()))?;
                    setup.texts.insert(param.id, text.characters().to_vec());
                }
                None => {
                    let row = self.value(key, value, family, setup)?;
                    setup.values.push(row);
                }
            }
        }
        Ok(())
    }

    /// A setting of a line, of what was written of it; 19200 baud, even parity.
    pub(crate) fn setting(
        &self,
        baud: Option<&Spanned<i64>>,
        parity: Option<&Spanned<String>>,
        spoken: Spoken,
    ) -> Result<LineSetting, Broken> {
        let baud = match baud {
            None => 19_200,
            Some(got) => {
                let known = BAUD_RATES.iter().find(|rate| i64::from(rate.1) == *got.get_ref());
                let rates: Vec<_> = BAUD_RATES.iter().map(|rate| rate.1.to_string()).collect();
                let expected = one_of(&rates.join(", "));
                known.ok_or_else(|| self.unfit("baud", got.span(), got.get_ref(), &expected))?.1
            }
        };
        let words = PARITIES.map(|parity| (parity.name(), parity));
        let parity = parity.map_or(Ok(Parity::Even), |got| self.word("parity", got, &words))?;
        Ok(match spoken {
            Spoken::ASCII => LineSetting::ascii(baud, parity),
            Spoken::Vabus => LineSetting { parity, ..LineSetting::vabus(baud) },
            Spoken::Modbus(_) | Spoken::PBus => LineSetting::rtu(baud, parity),
        })
    }

    pub(crate) fn line(&self, row: &DriveTable, spoken: Spoken) -> Result<LineSetting, Broken> {
        let line = self.setting(row.baud.as_ref(), row.parity.as_ref(), spoken)?;
        match row.data_bits.as_ref().map(|got| (*got.get_ref(), got)) {
            None => Ok(line),
            Some((8, _)) => Ok(LineSetting { data_bits: 8, ..line }),
            Some((7, _)) if line.data_bits == 7 => Ok(line),
            Some((bits, got)) => {
                let expected = both!("8, or 7 with protocol ascii or vabus", "8, oder 7 mit protocol ascii oder vabus");
                Err(self.unfit("data_bits", got.span(), &bits, &expected))
            }
        }
    }

    fn check_module(&self, module: &Spanned<String>, family: Option<&Family>) -> Result<(), Broken> {
        let rows = family.into_iter().flat_map(|family| family.params.values());
        let mut known: Vec<&str> = rows.filter_map(|param| param.module.as_deref()).collect();
        known.sort_unstable();
        known.dedup();
        if known.contains(&module.get_ref().as_str()) {
            return Ok(());
        }
        Err(self.unfit("module", module.span(), &quoted(module), &one_of(&known.join(", "))))
    }

    /// An ACT has one input for the enable (CM-485 manual 9).
    fn check_sto(&self, got: &Spanned<bool>, model: Model) -> Result<(), Broken> {
        match model {
            Model::Acu => Ok(()),
            _ => {
                let message = both!(
                    "only an ACU has STOA and STOB; expected enable",
                    "nur ein ACU hat STOA und STOB; erwartet: enable"
                );
                Err(self.error(got.span(), message))
            }
        }
    }

    fn torque(&self, got: &Spanned<i64>) -> Result<i64, Broken> {
        let torque = Some(*got.get_ref()).filter(|torque| (0..=HEAVIEST).contains(torque));
        let expected = both!("0 to {HEAVIEST} % of the rated torque", "0 bis {HEAVIEST} % des Bemessungsdrehmoments");
        torque.ok_or_else(|| self.unfit("torque", got.span(), got.get_ref(), &expected))
    }

    fn ramps(&self, table: &RampTable, ramps: &mut Ramps) -> Result<(), Broken> {
        for (got, slope) in [
            (&table.up_right, &mut ramps.up_right),
            (&table.down_right, &mut ramps.down_right),
            (&table.up_left, &mut ramps.up_left),
            (&table.down_left, &mut ramps.down_left),
        ] {
            let Some(got) = got else { continue };
            let raw = decimal(got.get_ref(), 2).map_err(|message| self.error(got.span(), message))?;
            let known = Some(raw).filter(|raw| (1..=STEEPEST).contains(raw));
            let message = || {
                both!(
                    "{slope} Hz/s; expected 0.01 to 9999.99",
                    "{slope} Hz/s; erwartet: 0.01 bis 9999.99",
                    slope = got.get_ref()
                )
            };
            *slope = known.ok_or_else(|| self.error(got.span(), message()))?;
        }
        Ok(())
    }

    /// A parameter with its data set, 5-9 in the RAM, as the keys of `set` name them.
    fn cell<'f>(
        &self,
        key: &str,
        span: Range<usize>,
        family: Option<&'f Family>,
        setup: &Setup,
    ) -> Result<(&'f Param, u8), Broken> {
        let refuse = |why: Text| self.error(span.clone(), both!("set \"{key}\": {why}", "set \"{key}\": {why}", why));
        let (number, set) = match key.split_once('@') {
            None => (key, Some(0)),
            Some((number, text)) => {
                let ram = text.strip_suffix("ram");
                let set = ram.unwrap_or(text).parse().ok().filter(|set| (1..=4u8).contains(set));
                (number, set.map(|set| if ram.is_some() { set + RAM_OFFSET } else { set }))
            }
        };
        let set = set.ok_or_else(|| {
            refuse(both!(
                "expected data set 1 to 4 after @, or 1ram to 4ram",
                "erwartet wird hinter @ Datensatz 1 bis 4 oder 1ram bis 4ram"
            ))
        })?;
        let param = number.parse().ok().and_then(|number| family?.param(number));
        let param = param.filter(|param| param.module.as_ref().is_none_or(|module| setup.modules.contains(module)));
        let param = param.ok_or_else(|| {
            refuse(both!(
                "this drive has no such parameter; expected its number",
                "diesen Parameter hat der Antrieb nicht; erwartet wird seine Nummer"
            ))
        })?;
        if set != 0 && param.sets != Some(Sets::Four) && !setup.four.contains(&param.id) {
            let why = both!("exists once; expected no data set", "gibt es nur einmal; hier steht kein Datensatz");
            return Err(refuse(why));
        }
        Ok((param, set))
    }

    /// A row of `set`: number, data set, raw value.
    fn value(
        &self,
        key: &str,
        value: &Spanned<Value>,
        family: Option<&Family>,
        setup: &Setup,
    ) -> Result<(u32, u8, i64), Broken> {
        let refuse = |why: Text| self.error(value.span(), both!("set \"{key}\": {why}", "set \"{key}\": {why}", why));
        let (param, set) = self.cell(key, value.span(), family, setup)?;
        let decimals = param.decimals_or_zero();
        let raw = match value.get_ref() {
            Value::String(text) => match text.strip_prefix("0x") {
                Some(hex) => i64::from_str_radix(hex, 16)
                    .map_err(|_| refuse(both!("'{text}' is no number", "'{text}' ist keine Zahl")))?,
                None => decimal(value.get_ref(), decimals).map_err(refuse)?,
            },
            number => decimal(number, decimals).map_err(refuse)?,
        };
        let kind = param.kind.unwrap_or(Type::Long);
        check_width(raw, kind, decimals).map_err(|error| refuse(error.text()))?;
        Ok((param.id, set, raw))
    }

    /// What an event does.
    pub(crate) fn active_events(
        &self,
        table: &Spanned<EventTable>,
        model: Model,
        family: Option<&Family>,
        setup: &Setup,
    ) -> Result<Vec<Event>, Broken> {
        let row = table.get_ref();
        let trigger = self.trigger(table)?;
        if row.class.is_some() || row.qualifier.is_some() {
            let message =
                both!("class and qualifier are for model lxm05", "class und qualifier gehören zu model lxm05");
            return Err(self.error(table.span(), message));
        }
        let mut actions = Vec::new();
        if let Some(fault) = &row.fault {
            actions.push(Action::Fault(Fault { number: self.fault(fault)?, ..Fault::default() }));
        }
        actions.extend(row.warning.map(Action::Warning));
        if let Some(silent) = &row.silent {
            actions.push(Action::Silent(self.time("silent", silent)?));
        }
        if let Some(span) = &row.bus_off {
            actions.push(Action::BusOff(self.time("bus_off", span)?));
        }
        for (key, value) in &row.set {
            let (number, set, raw) = self.value(key, value, family, setup)?;
            actions.push(Action::Set(number, set, raw));
        }
        let faulty = self.faulty(&row.eeprom, family, setup)?;
        actions.extend(faulty.into_iter().map(|(number, set, fault)| Action::Eeprom(number, set, fault)));
        actions.extend(row.refuses.map(Action::Refuses));
        actions.extend(row.ignores.map(Action::Ignores));
        actions.extend(row.power_cycle.filter(|&cycle| cycle).map(|_| Action::PowerCycle));
        actions.extend(row.mains.map(Action::Mains));
        actions.extend(row.enable.into_iter().flat_map(|on| match model {
            Model::Acu => vec![Action::StoA(on), Action::StoB(on)],
            _ => vec![Action::StoA(on)],
        }));
        for (sto, action) in [(&row.stoa, Action::StoA as fn(bool) -> Action), (&row.stob, Action::StoB)] {
            let Some(sto) = sto else { continue };
            self.check_sto(sto, model)?;
            actions.push(action(*sto.get_ref()));
        }
        actions.extend(row.start_right.map(Action::StartRight));
        actions.extend(row.start_left.map(Action::StartLeft));
        if let Some(torque) = &row.torque {
            actions.push(Action::Torque(self.torque(torque)?));
        }
        actions.extend(row.dragged.map(Action::Dragged));
        actions.extend(self.module_actions(row)?);
        if actions.is_empty() {
            let message = both!(
                "nothing happens in this event; expected fault, warning, power_cycle, silent, set, eeprom, refuses, ignores, mains, enable, stoa, stob, start_right, start_left, torque, dragged, exchange_phases, hand or analog",
                "in diesem event geschieht nichts; erwartet: fault, warning, power_cycle, silent, set, eeprom, refuses, ignores, mains, enable, stoa, stob, start_right, start_left, torque, dragged, exchange_phases, hand oder analog"
            );
            return Err(self.error(table.span(), message));
        }
        let lasts = row.lasts.as_ref().map(|got| self.time("for", got)).transpose()?;
        if let Some(got) = row.lasts.as_ref().filter(|_| actions.iter().any(|action| action.opposite().is_none())) {
            let message = both!(
                "for goes only with mains, enable, stoa, stob, start_right, start_left, dragged",
                "for gehört nur zu mains, enable, stoa, stob, start_right, start_left, dragged"
            );
            return Err(self.error(got.span(), message));
        }
        Ok(actions.into_iter().map(|action| Event { trigger, action, lasts }).collect())
    }

    fn fault(&self, got: &Spanned<String>) -> Result<u16, Broken> {
        let digits = got.get_ref().strip_prefix('F').filter(|digits| digits.len() == 4);
        let code = digits.and_then(|digits| u16::from_str_radix(digits, 16).ok()).filter(|&code| code != 0);
        let expected = both!("F and 4 digits, such as \"F0500\"", "F und 4 Ziffern wie \"F0500\"");
        code.ok_or_else(|| self.unfit("fault", got.span(), &quoted(got), &expected))
    }
}

/// How an EEPROM takes a write.
const FAULTS: &[(&str, Option<CellFault>)] = &[
    ("takes", None),
    ("refuses", Some(CellFault::Refuses)),
    ("keeps", Some(CellFault::Keeps)),
    ("not-in-force", Some(CellFault::NotInForce)),
];
/// RAM data sets are numbered 5 above their EEPROM twins (CM-485 manual 7).
const RAM_OFFSET: u8 = 5;
