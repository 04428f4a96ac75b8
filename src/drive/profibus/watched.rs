//! A slave that is watched: status word, setpoint and frequency come with every exchange, so nothing is asked for them; everything else
//! is read over PKW, behind the stop word like any other parameter.

use super::exchange::Exchange;
use super::looked::fault;
use super::mode::Mode;
use super::state;
use super::words::FULL;
use crate::drive::describe;
use crate::drive::transfer::Reading;
use crate::drive::watch::{self, Chosen, Item, Place, Rounds, Signal, Source, Station, Watch, terse};
use crate::drive::{Target, Terms};
use crate::exchange::Tally;
use crate::exchange::dp::Cycle;
use crate::failure::{Class, Failure};
use crate::outcome::{Decimal, Event, Outcome, SampleValue, Value};
use crate::profile::{Family, Type};
use crate::tick::{Span, Tick};
use std::pin::pin;
use std::rc::Rc;

/// Words of PROFIdrive, with the numbers under which the module tells them as well: STW, ZSW (5.1), HSW, HIW (5.2).
const STW: u32 = 967;
const ZSW: u32 = 968;
const HSW: u32 = 700;
const HIW: u32 = 701;
/// Their decimals: 0.01 Hz, or 0.01 %.
const DECIMALS: u8 = 2;
/// Setpoint and frequency in Hz (5.3), which the Basic block tells.
const SETPOINT: u32 = 611;
const FREQUENCY: u32 = 614;

/// A family as the words of a cycle tell it: of HSW and HIW the catalogue knows no scale, because P.700 and P.701 have another one in the
/// manual (5.2) than the words (4.1.2.3).
pub fn by_words(family: &Family, mode: Mode) -> Family {
    let mut family = family.clone();
    for id in [HSW, HIW] {
        if let Some(param) = family.params.get_mut(&id) {
            let unit = if mode.is_basic() { "Hz" } else { "%" };
            (param.unit, param.decimals) = (Some(unit.to_owned()), Some(DECIMALS));
        }
    }
    family
}

impl Exchange<'_, '_> {
    /// Watches the slave until the count or the time is over, or somebody ends it. It must be left afterwards. What is chosen was chosen of
    /// the family [`by_words`].
    pub async fn watch(&mut self, family: &Rc<Family>, terms: &Terms<'_>, rounds: Rounds, chosen: Chosen) -> Outcome {
        let chosen = self.of_words(family, chosen);
        if self.mode().further() > 0
            && let Err(failure) = self.map(&chosen).await
        {
            return Outcome { data: None, warnings: Vec::new(), failure: Some(failure) };
        }
        let waited_for = chosen.waited_for.clone();
        let mut station = Station::new(Place { address: self.address(), called: None }, Vec::new());
        station.is(Target::new(self.address(), family.clone()), chosen);
        self.watches = true;
        let choose = |_: &_| Ok(Chosen::default());
        let outcome = watch::watch_stations(self, terms, rounds, vec![station], (&waited_for, &choose)).await;
        self.watches = false;
        outcome
    }

    /// What is watched, as the words of a cycle tell it.
    fn of_words(&self, family: &Family, chosen: Chosen) -> Chosen {
        let Chosen { items, mut waited_for } = chosen;
        let items = items.into_iter().filter_map(|item| self.by_word(family, item)).collect();
        for condition in &mut waited_for {
            if let Signal::Value(item, _) = &mut condition.signal
                && let Some(known) = self.by_word(family, Item::clone(item))
            {
                **item = known;
            }
        }
        Chosen { items, waited_for }
    }

    /// HSW and HIW are parts of A004 (4.1.2.3); in Basic mode they are told in Hz, and its status word has no number.
    fn by_word(&self, family: &Family, item: Item) -> Option<Item> {
        let to = |id| item.clone().moved_to(family.param_or_unknown(id));
        match (self.mode().is_basic(), item.param().id) {
            (false, HSW | HIW) => Some(item.part_of(FULL)),
            (true, HSW) => Some(to(SETPOINT)),
            (true, HIW) => Some(to(FREQUENCY)),
            (true, ZSW) => None,
            _ => Some(item),
        }
    }

    /// What a cycle told of it.
    pub(super) fn word(&self, id: u32) -> Option<i64> {
        let seen = self.seen()?;
        let setpoint = self.words.hsw;
        Some(match (self.mode().is_basic(), id) {
            (false, STW) => self.words.stw.into(),
            (false, ZSW) => seen.zsw.into(),
            (false, HSW) => setpoint.cast_signed().into(),
            (true, SETPOINT) => setpoint.into(),
            (false, HIW) | (true, FREQUENCY) => seen.hiw.into(),
            _ => return None,
        })
    }

    /// One value, and why it did not come.
    async fn item(&mut self, family: &Family, item: &Item) -> Result<(Value, Option<Failure>), Failure> {
        let Some(raw) = self.word(item.param().id).or_else(|| self.mapped_word(item.param())) else {
            return self.one(family, &(item.param().clone(), None)).await;
        };
        let reading =
            Reading { set: 0, raw, text: None, kind: item.param().kind.unwrap_or(Type::Int), corrected: false };
        let mut value = describe::value(self.address(), family, item.param(), reading, &|_| None);
        if let Some(full) = item.full() {
            value.value = Some(Decimal { raw: raw * 10_000 / full, decimals: DECIMALS });
        }
        if let Some(word) = value.word.as_mut().filter(|_| item.param().id == ZSW) {
            word.state = self.seen().and_then(state::of);
        }
        Ok((value, None))
    }
}

/// Who is not heard between two samples is a gap in the next.
fn heard(kept: Result<(), Failure>) -> Result<(), Failure> {
    kept.or_else(|why| if why.is_unheard() { Ok(()) } else { Err(why) })
}

impl Source for Exchange<'_, '_> {
    fn now(&self) -> Tick {
        self.line.now()
    }

    fn port(&self) -> String {
        self.line.name().0
    }

    fn speaks(&self, _terms: &Terms<'_>) -> (String, &'static str) {
        (self.line.name().1, "dp")
    }

    fn since_1970(&self) -> Option<Span> {
        self.line.since_1970()
    }

    fn tally(&self) -> Tally {
        self.line.tally()
    }

    fn tell(&mut self, event: Event) {
        self.line.tell(event);
    }

    /// One exchange, and what it did not tell over PKW.
    async fn read(&mut self, station: &mut Station, watch: &Watch<'_>) -> Result<watch::Haul, Failure> {
        let mut haul = watch::Haul::default();
        let Some(family) = station.target.as_ref().map(|target| target.family.clone()) else { return Ok(haul) };
        while !matches!(self.cycle().await?, Cycle::Inputs(_)) {}
        haul.state = self.seen().and_then(state::of);
        // A bit of ZSW names no cause.
        station.fault = self.seen().filter(|_| self.mode().is_basic()).and_then(fault);
        for item in &mut station.items {
            let (value, failure) = self.item(&family, item).await?;
            let is_lacking = failure.as_ref().is_some_and(|failure| failure.class == Class::Refused && item.lenient);
            let (failure, forgiven) = if is_lacking { (None, failure) } else { (failure, None) };
            item.came(std::slice::from_ref(&value), failure.clone(), forgiven);
            haul.failure = haul.failure.or(failure);
            let t = watch.seconds(self.line.now());
            haul.values.push(SampleValue { t, value: terse(value) });
        }
        Ok(haul)
    }

    async fn rest(&mut self, span: Span) -> Result<(), Failure> {
        let until = self.line.now() + span;
        while self.line.now() < until {
            heard(self.cycle().await.map(|_| ()))?;
        }
        Ok(())
    }

    async fn during_until<T>(
        &mut self,
        wait: impl Future<Output = T>,
        until: Option<Tick>,
    ) -> Result<Option<T>, Failure> {
        let mut wait = pin!(wait);
        loop {
            match Exchange::during_until(self, wait.as_mut(), until).await {
                Err(failure) => heard(Err(failure))?,
                done => return done,
            }
        }
    }

    /// Whoever has lost the port has lost the slave, which its watchdog lets go.
    async fn reopen(&mut self) -> Result<(), Failure> {
        Err(super::trouble::interrupted())
    }
}
