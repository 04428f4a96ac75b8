//! Reading the parameters of one drive into rows, whatever a verb wants of them.

use super::motion::working;
use super::transfer::is_alike;
use super::{AccessError, Reading, Session, Target, describe};
use crate::failure::{Class, Failure};
use crate::outcome::{Event, Value, Warning};
use crate::profile::{DataSets, Param, Store};
use crate::text::{Text, both};
use std::collections::BTreeMap;

/// So many questions in a row that a drive leaves without an answer, each repeated as often as is set, tell that nobody is
/// there: two may be a bad line or parameters that it does not care to answer.
const NOBODY_AFTER: usize = 3;

/// Reads parameters of one drive into rows, remembering the parameters that the names of bits depend on.
#[derive(Debug)]
pub struct Reader<'t, 'o> {
    /// The line.
    pub session: &'t mut Session<'o>,
    /// The drive.
    pub target: &'t mut Target,
    modes: BTreeMap<u32, i64>,
    /// Values that came with their neighbours.
    fetched: BTreeMap<u32, Reading>,
    /// Not every drive has everything: what it does not know is a row with an error, but no failure of the verb.
    pub lenient: bool,
    /// Values that were read.
    good: usize,
    /// Questions without an answer since the last one that had one.
    silences: usize,
    /// Refusals that are no failures, unless nothing else came.
    pub forgiven: Vec<Failure>,
    /// Why values are missing.
    pub failures: Vec<Failure>,
    /// What is odd about values that were read.
    pub warnings: Vec<Warning>,
    /// Parameters whose width was found out by asking, and told.
    pub asked_widths: Vec<u32>,
}

impl<'t, 'o> Reader<'t, 'o> {
    /// Reads from this drive.
    pub fn new(session: &'t mut Session<'o>, target: &'t mut Target) -> Self {
        Reader {
            session,
            target,
            modes: BTreeMap::new(),
            fetched: BTreeMap::new(),
            lenient: false,
            good: 0,
            silences: 0,
            forgiven: Vec::new(),
            failures: Vec::new(),
            warnings: Vec::new(),
            asked_widths: Vec::new(),
        }
    }

    /// What failed. Refusals of single parameters are forgiven, but not if the drive refused everything.
    pub fn into_failures(mut self) -> (Vec<Failure>, usize) {
        for warning in self.warnings.drain(..) {
            self.session.tell(Event::Note(warning.message));
        }
        if self.good == 0 && self.failures.is_empty() {
            self.failures.extend(self.forgiven.into_iter().next());
        }
        (self.failures, self.good)
    }

    /// The parameter that plays a role, read in its own data set; `None` if the family has none.
    pub async fn role(&mut self, role: impl AsRef<str>) -> Result<Option<Value>, Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(None) };
        self.lenient = true;
        Ok(self.rows(&param, DataSets::Unnamed).await?.into_iter().next())
    }

    /// The parameter that plays a role as the drive works with it, and the stored one where that differs. A drive without
    /// data sets has one value.
    pub async fn in_force(&mut self, role: impl AsRef<str>) -> Result<InForce, Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(InForce::default()) };
        self.lenient = true;
        if !self.target.family.link.route.has_data_sets() || param.is_volatile() {
            let value = self.rows(&param, DataSets::Unnamed).await?.into_iter().next();
            return Ok(InForce { value, stored: None });
        }
        let set = self.target.working_set(self.session, &param).await;
        let set = set.map_err(|error| error.failure(self.target.address, Some(&self.target.family)))?;
        let forgiven = self.forgiven.len();
        let working = self.rows(&param, DataSets::One(set, Store::Ram)).await?.into_iter().next();
        let stored = self.rows(&param, DataSets::One(set, Store::Eeprom)).await?.into_iter().next();
        let Some(working) = working.filter(|value| value.error.is_none()) else {
            // It does not show its RAM: what it stores is all that there is to know.
            self.forgiven.truncate(forgiven);
            return Ok(InForce { value: stored, stored: None });
        };
        let stored = stored.filter(|stored| stored.error.is_none() && stored.raw != working.raw);
        Ok(InForce { value: Some(working), stored })
    }

    /// Like [`Reader::role`], but a refusal is a failure: the verb is about this value.
    pub async fn vital_role(&mut self, role: impl AsRef<str>) -> Result<Option<Value>, Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(None) };
        self.lenient = false;
        Ok(self.rows(&param, DataSets::Unnamed).await?.into_iter().next())
    }

    /// Reads in few telegrams what lies next to each other; [`Reader::rows`] takes it from there.
    pub async fn fetch(&mut self, params: &[Param]) -> Result<(), Failure> {
        let (readings, end) = self.target.neighbours(self.session, params).await;
        self.fetched.extend(readings);
        end.map_err(|error| error.failure(self.target.address, Some(&self.target.family)))
    }

    /// One row per data set. Refusals are rows with an error; what ends the session is an error.
    pub async fn rows(&mut self, param: &Param, sets: DataSets) -> Result<Vec<Value>, Failure> {
        if let Some(silence) = self.nobody() {
            return Ok(sets.wire().into_iter().map(|set| self.unread(param, set, silence.clone())).collect());
        }
        self.learn_modes(param).await?;
        if let Some(reading) = self.fetched.remove(&param.id).filter(|_| sets == DataSets::Unnamed) {
            return Ok(vec![self.row(param, 0, Ok(reading))?]);
        }
        let mut rows = Vec::new();
        for (set, result) in self.target.read(self.session, param, sets).await {
            rows.push(Value { node: self.session.node(), ..self.row(param, set, result)? });
        }
        Ok(rows)
    }

    fn row(&mut self, param: &Param, set: u8, result: Result<Reading, AccessError>) -> Result<Value, Failure> {
        let address = self.target.address;
        match result {
            Ok(reading) => {
                self.good += 1;
                self.silences = 0;
                if param.kind.is_none() && !self.asked_widths.contains(&param.id) {
                    self.asked_widths.push(param.id);
                    let bits = reading.kind.bits().unwrap_or(0);
                    let found = match self.target.is_untold(param.id) {
                        true => both!(
                            "parameter {param}: width not known, SDO does not tell it; --type names it",
                            "Parameter {param}: Breite nicht bekannt, SDO nennt sie nicht; --type gibt sie an",
                            param = param.id
                        ),
                        false => both!(
                            "parameter {param}: {bits} bits wide, found out by asking",
                            "Parameter {param}: {bits} Bit breit, durch Fragen ermittelt",
                            param = param.id
                        ),
                    };
                    // Of a number that no catalogue knows nobody else says how it was read.
                    if self.session.is_verbose() || !param.is_known() {
                        self.session.tell(Event::Note(found));
                    }
                }
                if reading.corrected {
                    self.warnings.push(Warning {
                        code: "catalogue.width".to_owned(),
                        message: both!(
                            "parameter {param}: the catalogue says {told} (unconfirmed), drive {address} uses {used}",
                            "Parameter {param}: der Katalog nennt {told} (unbestätigt), Antrieb {address} benutzt \
                             {used}",
                            param = param.id,
                            told = param.kind.map_or("-", |kind| kind.name()),
                            used = reading.kind.name()
                        ),
                    });
                }
                let lookup = |id: u32| self.modes.get(&id).copied();
                let is_raw = self.target.is_untold(param.id) && !is_alike(reading.raw);
                let value = describe::value(address, &self.target.family, param, reading, &lookup);
                let value = if is_raw { Value { kind: None, value: None, ..value } } else { value };
                self.warnings.extend(implausible(&value, param));
                Ok(value)
            }
            Err(error) => {
                let failure = error.failure(address, Some(&self.target.family)).with("param", param.id);
                if error.is_fatal() {
                    return Err(failure);
                }
                self.silences = if failure.class == Class::Silence { self.silences + 1 } else { 0 };
                Ok(self.unread(param, set, failure))
            }
        }
    }

    /// The row of a value that did not come.
    fn unread(&mut self, param: &Param, set: u8, failure: Failure) -> Value {
        let row = describe::unread(self.target.address, &self.target.family, param, set, &failure);
        match failure.class == Class::Refused && self.lenient {
            true => self.forgiven.push(failure),
            false => self.failures.push(failure),
        }
        row
    }

    /// Why nothing more is asked: nobody has answered anything.
    fn nobody(&self) -> Option<Failure> {
        let silence = self.failures.last().filter(|failure| failure.class == Class::Silence);
        let unheard = self.good == 0 && self.forgiven.is_empty();
        silence.filter(|_| unheard && self.silences >= NOBODY_AFTER).cloned()
    }

    /// Reads the parameters that decide what this one's bits are called.
    async fn learn_modes(&mut self, param: &Param) -> Result<(), Failure> {
        for when in &param.bits_when {
            if self.modes.contains_key(&when.param) {
                continue;
            }
            let deciding = self.target.family.param_or_unknown(when.param);
            // What is in force decides, not what is stored.
            if let Some(raw) = working(self.session, self.target, &deciding).await? {
                self.modes.insert(when.param, raw);
            }
        }
        Ok(())
    }
}

/// The warning about a value that the catalogue says cannot be.
fn implausible(value: &Value, param: &Param) -> Option<Warning> {
    let (expected, raw) = (value.expected.as_ref()?, value.raw?);
    let (label, address) = (param.label(), value.address);
    let message = both!(
        "drive {address}: {label} reads as {raw}, expected {expected}: two drives at one address, a disturbed reply, \
             or a drive of another kind (--drive)?",
        "Antrieb {address}: {label} liest sich als {raw}, erwartet {expected}: zwei Antriebe mit einer Adresse, eine \
             gestörte Antwort oder ein Antrieb anderer Art (--drive)?"
    );
    Some(Warning { code: "value.implausible".to_owned(), message })
}

/// A setting as the drive works with it, and as it is stored where that is another value.
#[derive(Debug, Default)]
pub struct InForce {
    /// As the drive works with it.
    pub value: Option<Value>,
    /// As it is stored, where that is another value.
    pub stored: Option<Value>,
}

impl InForce {
    /// One row, or two that differ; the second says that it is only stored.
    pub fn rows(self) -> impl Iterator<Item = Value> {
        let stored = self.stored.map(|value| {
            let only = both!("stored, not in force", "gespeichert, nicht wirksam");
            let texts: Vec<Text> = value.text.into_iter().chain([only]).collect();
            Value { text: Some(Text::join(&texts, "; ")), ..value }
        });
        self.value.into_iter().chain(stored)
    }
}
