//! Where samples come from: a session with the drives of a line, or a slave that exchanges data with us.

use super::Watch;
use super::station::{Haul, Station, terse};
use crate::drive::{Reader, Session, Terms, describe};
use crate::exchange::Tally;
use crate::failure::{Class, Failure};
use crate::outcome::{Event, SampleValue};
use crate::profile::Param;
use crate::tick::{Span, Tick};

/// Where samples come from.
pub(in crate::drive) trait Source {
    fn now(&self) -> Tick;
    /// The port, as it is called now.
    fn port(&self) -> String;
    /// Line and protocol.
    fn speaks(&self, terms: &Terms<'_>) -> (String, &'static str);
    /// Time since 1970 of the moment 0, where a clock tells.
    fn since_1970(&self) -> Option<Span>;
    /// What the line has come to.
    fn tally(&self) -> Tally;
    fn tell(&mut self, event: Event);
    /// Reads what is watched of a drive.
    async fn read(&mut self, station: &mut Station, watch: &Watch<'_>) -> Result<Haul, Failure>;
    /// Lets time pass.
    async fn rest(&mut self, span: Span) -> Result<(), Failure>;
    /// Waits for something else, until a moment at most; then `None`.
    async fn during_until<T>(
        &mut self,
        wait: impl Future<Output = T>,
        until: Option<Tick>,
    ) -> Result<Option<T>, Failure>;
    /// Opens a port that was lost anew.
    async fn reopen(&mut self) -> Result<(), Failure>;
}

impl Source for Session<'_> {
    fn now(&self) -> Tick {
        Session::now(self)
    }

    fn port(&self) -> String {
        Session::port(self).to_owned()
    }

    fn speaks(&self, terms: &Terms<'_>) -> (String, &'static str) {
        (terms.line.to_string(), terms.speech.protocol.name())
    }

    fn since_1970(&self) -> Option<Span> {
        Session::since_1970(self)
    }

    fn tally(&self) -> Tally {
        Session::tally(self)
    }

    fn tell(&mut self, event: Event) {
        Session::tell(self, event);
    }

    /// A drive that was silent is asked once, so that it does not hold up the others.
    async fn read(&mut self, station: &mut Station, watch: &Watch<'_>) -> Result<Haul, Failure> {
        self.asks_on();
        let retries = self.set_retries(0);
        if station.silent.is_none() {
            self.set_retries(retries);
        }
        let haul = asked(self, station, watch).await;
        self.set_retries(retries);
        haul
    }

    async fn rest(&mut self, span: Span) -> Result<(), Failure> {
        Session::rest(self, span).await.map_err(|error| error.failure(0, None))
    }

    async fn during_until<T>(
        &mut self,
        wait: impl Future<Output = T>,
        until: Option<Tick>,
    ) -> Result<Option<T>, Failure> {
        Session::during_until(self, wait, until).await.map_err(|error| error.failure(0, None))
    }

    async fn reopen(&mut self) -> Result<(), Failure> {
        Session::reopen(self).await.map_err(|error| error.failure(0, None))
    }
}

/// Recognises the drive if that was not done yet, then reads what is watched. A silent drive is not asked further.
async fn asked(session: &mut Session<'_>, station: &mut Station, watch: &Watch<'_>) -> Result<Haul, Failure> {
    if station.target.is_none() {
        let shows_register = station.items.iter().any(|item| item.param().slug == "error-register");
        let target = watch.terms.target(session, station.place.address, shows_register).await?;
        let chosen = (watch.select)(&target.family)?;
        station.is(target, chosen);
    }
    let mut haul = Haul::default();
    let Some(target) = &mut station.target else { return Ok(haul) };
    let family = target.family.clone();
    let mut reader = Reader::new(session, target);
    reader.asked_widths = std::mem::take(&mut station.asked_widths);
    // What lies next to each other comes in one telegram, where the family has such.
    let mut together: Vec<Param> =
        station.items.iter().filter(|item| item.is_plain()).map(|item| item.param().clone()).collect();
    together.sort_by_key(|param| param.id);
    // Who was silent is asked once.
    if station.silent.is_none() {
        reader.fetch(&together).await?;
    }
    let mut silence: Option<Failure> = None;
    for item in &mut station.items {
        let rows = match silence.as_ref().or(item.refused.as_ref()) {
            Some(failure) => item.unread(station.place.address, &family, failure),
            None => {
                let rows = item.read(&mut reader).await?;
                silence = item.failure.clone().filter(|failure| failure.class == Class::Silence && item.failed);
                rows
            }
        };
        if item.failed || item.refused.is_some() {
            haul.failure = haul.failure.or_else(|| item.failure.clone());
        }
        let t = watch.seconds(reader.session.now());
        haul.values.extend(rows.into_iter().map(|value| SampleValue { t, value: terse(value) }));
    }
    let word = haul.values.iter().find_map(|row| row.value.word.as_ref().filter(|word| word.state.is_some()));
    let shown = family.role("fault").is_some_and(|fault| station.items.iter().any(|item| item.param().id == fault.id));
    if let Some(word) = word.filter(|word| !shown && station.memory.is_new(word.state.as_ref())) {
        // It trips, and nobody watches what ails it: it is asked once.
        let code = reader.role("fault").await?.and_then(|value| u32::try_from(value.raw?).ok());
        let code = code.and_then(|code| family.present_fault(Some(word.raw), code));
        station.fault = code.and_then(|code| describe::fault(&family, code));
    }
    haul.warnings = std::mem::take(&mut reader.warnings);
    station.asked_widths = reader.asked_widths;
    Ok(haul)
}
