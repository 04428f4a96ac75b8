//! Values of an inverter by PKW, and what is to be known before it is let go.

use super::exchange::{Exchange, LOST, Lent, TO_TERMINALS};
use super::run::STOPS;
use super::trouble;
use crate::drive::describe;
use crate::drive::transfer::Reading;
use crate::exchange::dp::Place;
use crate::failure::{Class, Failure};
use crate::outcome::Value;
use crate::profile::{Family, Param, Registry, Type, value};
use crate::text::{Text, both};
use std::rc::Rc;

/// What was read so far, and what came of the rest.
#[derive(Debug, Default)]
pub struct Haul {
    /// One entry a parameter.
    pub values: Vec<Value>,
    /// Why some of them are missing.
    pub failures: Vec<Failure>,
}

/// Which series it is (SJ2-PB manual 5.3), with the words of `--drive`.
pub(in crate::drive) const SERIES: Place = Place { pnu: 624, element: None };
const NAMES: [(u32, &str); 3] = [(0x10, "sj200"), (0x20, "l200"), (0x40, "x200")];
/// By whose names is spoken where nothing tells.
const PRESUMED: &str = "l200";
/// Where it is 0, no other parameter may be accessed (5.1).
pub const UNLOCKS: u32 = 927;
/// What decides on the motor once nobody exchanges data: P.703, P.620 (Basic mode; whether it counts here, no source tells), A002, A001
/// (5.2, 5.3; 5.5 index 89, 88).
const BEHIND: [u32; 4] = [703, 620, 89, 88];

impl Exchange<'_, '_> {
    /// The family of the inverter: the one that was named, or what P.624 tells. In Basic mode nothing tells it.
    pub async fn family(&mut self, named: Option<Rc<Family>>, registry: &Registry) -> Result<Rc<Family>, Failure> {
        let is_mute = !self.mode().has_pkw();
        if is_mute {
            self.meets().await?;
        }
        let told = self.read(SERIES).await?;
        let presumed = || registry.family(PRESUMED).filter(|_| is_mute);
        if let Some(family) = named.or_else(presumed) {
            let found = told.ok().and_then(series_named).filter(|found| is_series(&family) && *found != family.drive);
            return found
                .map_or(Ok(family.clone()), |found| Err(trouble::other_series(self.address(), &family, found)));
        }
        let series = match told {
            // Where all others are locked, P.927 is not.
            Err(failure) if failure.class == Class::Refused && self.is_locked().await? => {
                return Err(trouble::is_locked(self.address()));
            }
            told => told?,
        };
        series_named(series).and_then(|name| registry.family(name)).ok_or_else(|| {
            let message = both!(
                "P.624 tells {series:02X}h, which is no series that is known: expected 10h, 20h or 40h",
                "P.624 nennt {series:02X}h, keine bekannte Serie: erwartet 10h, 20h oder 40h"
            );
            Failure::new(Class::Data, "data.unknown_drive", message)
                .hint(both!("name it: --drive l200, sj200, x200", "sie nennen: --drive l200, sj200, x200"))
        })
    }

    async fn is_locked(&mut self) -> Result<bool, Failure> {
        Ok(self.read(Place::of(UNLOCKS, None)).await?.is_ok_and(|told| told & 0xFF == 0))
    }

    /// Reads a parameter, or an element of it, into the haul. Fails only if the exchange is over.
    pub async fn value(
        &mut self,
        family: &Family,
        wanted: &(Param, Option<u8>),
        haul: &mut Haul,
    ) -> Result<(), Failure> {
        let (value, failure) = self.one(family, wanted).await?;
        haul.values.push(value);
        haul.failures.extend(failure);
        Ok(())
    }

    /// The same alone, with why it did not come.
    pub(super) async fn one(
        &mut self,
        family: &Family,
        (param, element): &(Param, Option<u8>),
    ) -> Result<(Value, Option<Failure>), Failure> {
        let address = self.address();
        let (value, failure) = match self.read(Place::of(param.id, *element)).await? {
            Ok(bits) => {
                let kind = param.kind.unwrap_or(Type::Word);
                let raw = value::from_wire(bits, kind, param.min);
                let reading = Reading { set: 0, raw, text: None, kind, corrected: false };
                (describe::value(address, family, param, reading, &|_| None), None)
            }
            Err(failure) => (describe::unread(address, family, param, 0, &failure), Some(failure)),
        };
        Ok((Value { index: *element, ..value }, failure))
    }

    /// What decides on the motor once the slave is let go.
    pub async fn parting(&mut self, family: &Family) -> Result<Text, Failure> {
        if self.mode().is_basic() {
            return Ok(trouble::terminals_have_it());
        }
        let mut values = Vec::new();
        for param in BEHIND.into_iter().filter_map(|id| family.params.get(&id)) {
            values.push((param, self.read(Place::of(param.id, None)).await?.ok()));
        }
        let is_lost = |param: &Param| param.id == u32::from(LOST);
        self.behind = values.iter().find(|(param, _)| is_lost(param)).and_then(|(_, raw)| Some((*raw)? & 0xFF));
        let found = parted(family, &values);
        values.iter_mut().filter(|(param, _)| is_lost(param)).for_each(|(_, raw)| *raw = Some(STOPS.into()));
        self.parting = Some([found.clone(), parted(family, &values)]);
        Ok(found)
    }

    /// The same at the end: P.703 may stand as it was lent.
    pub(super) fn parting_now(&mut self) -> Option<Text> {
        let stands = |lent: &Lent| lent.place.pnu == LOST && !lent.restored && self.behind == Some(lent.new.into());
        let is_lent = self.lent.iter().any(stands);
        self.parting.take().map(|[found, lent]| if is_lent { lent } else { found })
    }
}

/// By which parameters an inverter goes on without us.
fn parted(family: &Family, values: &[(&Param, Option<u32>)]) -> Text {
    let each = values.iter().map(|(param, raw)| {
        let (id, name) = (param.id, &param.name);
        let Some(raw) = raw else {
            return both!("{name} (P.{id}) is not told", "{name} (P.{id}) wird nicht genannt", name);
        };
        match family.text_of(param, i64::from(*raw)) {
            Some(text) => both!("{name} (P.{id}) = {raw}: {text}", "{name} (P.{id}) = {raw}: {text}", name, text),
            None => both!("{name} (P.{id}) = {raw}", "{name} (P.{id}) = {raw}", name),
        }
    });
    let to_terminals = |row: &&(&Param, Option<u32>)| {
        row.0.id == u32::from(LOST) && row.1.is_some_and(|raw| raw & 0xFF == TO_TERMINALS)
    };
    let warned = values.iter().find(to_terminals).map(|_| trouble::to_terminals());
    let told = Text::join(&each.chain(warned).collect::<Vec<_>>(), "; ");
    both!(
        "the inverter goes on without us by these: {told}",
        "der Umrichter arbeitet ohne uns weiter nach: {told}",
        told
    )
}

/// Whether a family is one of which P.624 tells.
fn is_series(family: &Family) -> bool {
    NAMES.iter().any(|(_, name)| *name == family.drive)
}

/// The word of a series, as P.624 tells it.
pub(in crate::drive) fn series_named(told: u32) -> Option<&'static str> {
    NAMES.iter().find(|row| row.0 == told & 0xFF).map(|row| row.1)
}
