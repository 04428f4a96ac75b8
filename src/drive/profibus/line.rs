//! An open PROFIBUS line with us as its only master: listened to first, asked afterwards.

use super::trouble;
use crate::drive::decode::dp::Reader;
use crate::drive::opening::{Opening, cut_recording, open_trace};
use crate::drive::pump;
use crate::drive::{AccessError, Interrupt};
use crate::exchange::dp::{Asked, Fdl, Heard, Listening, MASTER, Reply, Timing, Unanswered};
use crate::exchange::{Conversation, Record, Tally, Verdict};
use crate::failure::Failure;
use crate::outcome::Event;
use crate::profile::Registry;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::Hex;
use crate::text::both;
use crate::tick::{Span, Tick};
use crate::transport::{Link, Port, Wake};

/// An open PROFIBUS line.
pub struct Line<'a> {
    name: String,
    setting: String,
    link: Link,
    pub(super) fdl: Fdl,
    interrupt: Interrupt,
    observe: &'a mut dyn FnMut(Event),
    verbose: bool,
    /// As they were asked for.
    slot: Option<Span>,
    retries: Option<u8>,
}

impl std::fmt::Debug for Line<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Line").field("link", &self.link).field("fdl", &self.fdl).finish_non_exhaustive()
    }
}

impl<'a> Line<'a> {
    /// Opens the line and listens on it. Fails if somebody else asks there: nothing was sent then.
    pub async fn open(
        opening: Opening<'_>,
        slot: Option<Span>,
        registry: &Registry,
        interrupt: Interrupt,
        observe: &'a mut dyn FnMut(Event),
    ) -> Result<Self, Failure> {
        let Opening { port, line, rs485, trace, verbose, retries, .. } = opening;
        // PROFIBUS is always 8E1 (IEC 61158-4-3).
        let line = LineSetting::rtu(line.baud, Parity::Even);
        let mut link = match port {
            Port::Sim(file) => {
                let bus = crate::drive::bench::profibus(file.as_deref(), registry)?;
                Link::open_profibus(bus, line)
            }
            port => tokio::select! {
                link = Link::open(port, line, rs485) => link.map_err(|error| trouble::link(&error))?,
                () = interrupt.raised() => return Err(trouble::interrupted()),
            },
        };
        if let Some(recording) = trace {
            link.record_to(open_trace(recording, &format!("{line}, dp"))?);
        }
        for deviation in link.deviations() {
            observe(Event::Note(both!("{port}: {deviation}", "{port}: {deviation}", deviation)));
        }
        let fdl = Fdl::new(MASTER, line, timing(line, slot, retries), link.now());
        let (name, setting) = (port.to_string(), line.to_string());
        let mut opened = Line { name, setting, link, fdl, interrupt, observe, verbose, slot, retries };
        opened.listen(line).await?;
        Ok(opened)
    }

    /// Listens whether somebody else asks. Fails if so: nothing was sent then.
    async fn listen(&mut self, line: LineSetting) -> Result<(), Failure> {
        let mut listening = Listening::new(self.link.now());
        let heard = pump::run(&mut listening, &mut self.link, &self.interrupt, None).await;
        match heard.map_err(|error| AccessError::from(error).failure(0, None))? {
            Heard::Nobody => Ok(()),
            Heard::Master(master) => Err(trouble::other_master(master)),
            Heard::Somebody => Err(trouble::somebody(line)),
        }
    }

    /// Another speed from now on. It is listened to first, as when a line is opened.
    pub async fn retune(&mut self, baud: u32) -> Result<(), Failure> {
        let line = LineSetting::rtu(baud, Parity::Even);
        self.link.set_line(line).await.map_err(|error| trouble::link(&error))?;
        self.setting = line.to_string();
        self.fdl = Fdl::new(MASTER, line, timing(line, self.slot, self.retries), self.link.now());
        self.listen(line).await
    }

    /// Port and setting.
    pub fn name(&self) -> (String, String) {
        (self.name.clone(), self.setting.clone())
    }

    /// Tells whoever watches.
    pub fn tell(&mut self, event: Event) {
        (self.observe)(event);
    }

    /// The time of the line.
    pub fn now(&self) -> Tick {
        self.link.now()
    }

    /// Waits without asking anything; what comes is nobody's answer, but may show another master.
    pub(super) async fn rest(&mut self, until: Tick) -> Result<(), Failure> {
        while self.link.now() < until {
            let heard = pump::hear(&mut self.link, &self.interrupt, until).await;
            self.tell_of_recording();
            if let Wake::Bytes(bytes) = heard.map_err(|error| AccessError::from(error).failure(0, None))? {
                self.fdl.feed(self.link.now(), &bytes);
            }
        }
        Ok(())
    }

    /// Time since 1970 of the moment 0, where a clock tells.
    pub(super) fn since_1970(&self) -> Option<Span> {
        self.link.since_1970()
    }

    /// What it has come to.
    pub(super) fn tally(&self) -> Tally {
        self.fdl.tally()
    }

    /// Who interrupts.
    pub(super) fn interrupt(&self) -> Interrupt {
        self.interrupt.clone()
    }

    /// Whether its time goes on by waiting on it alone.
    pub(super) fn stands_still(&self) -> bool {
        self.link.stands_still()
    }

    /// Lets the time of the bench follow the wall clock from now on.
    pub fn pace(&mut self) {
        self.link.pace();
    }

    /// Takes note of who interrupted so far, and tells how often since: the line is used on, for what must still go out.
    pub(super) fn note_interrupts(&mut self) -> u32 {
        let before = self.interrupt.presses();
        self.interrupt.note();
        self.interrupt.presses() - before
    }

    /// Asks a station once, with its repeats.
    pub(super) async fn ask(
        &mut self,
        station: u8,
        asked: Asked,
        retries: Option<u8>,
    ) -> Result<Result<Reply, Unanswered>, Failure> {
        self.fdl.ask(station, asked, retries, self.link.now());
        let outcome = pump::run(&mut self.fdl, &mut self.link, &self.interrupt, None).await;
        self.tell_of_recording();
        self.show();
        outcome.map_err(|error| AccessError::from(error).failure(0, None))
    }

    fn tell_of_recording(&mut self) {
        if let Some(cut) = cut_recording(&mut self.link) {
            (self.observe)(cut);
        }
    }

    /// Tells every telegram, where that is wanted.
    fn show(&mut self) {
        let records = self.fdl.take_records();
        if self.verbose {
            records.iter().for_each(|record| (self.observe)(told(record)));
        }
    }
}

/// What was asked for, else what is usual at this speed.
fn timing(line: LineSetting, slot: Option<Span>, retries: Option<u8>) -> Timing {
    let usual = Timing::of(line);
    Timing { slot: slot.unwrap_or(usual.slot), retries: retries.unwrap_or(usual.retries) }
}

fn told(record: &Record) -> Event {
    let direction = match record.verdict {
        Verdict::Request | Verdict::Fence | Verdict::Farewell => '>',
        Verdict::Reply => '<',
        Verdict::Echo | Verdict::Copy | Verdict::Stray { .. } | Verdict::Garbage => '~',
    };
    let reader = Reader { family: None, cyclic: None };
    let said = reader.telegram(&record.bytes).meaning;
    let meaning = match record.verdict {
        Verdict::Echo => both!("echo of the adapter: {said}", "Echo des Adapters: {said}", said),
        _ => said,
    };
    Event::Telegram { at_us: record.at.as_micros(), direction, hex: Hex(&record.bytes).to_string(), meaning }
}
