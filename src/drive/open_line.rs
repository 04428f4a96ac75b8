//! What all who talk over one line have in common: its link, what the master knows of its stations, and what is told of it.

use super::account::Account;
use super::interrupt::Interrupt;
use super::opening::cut_recording;
use super::pump::{self, PumpError};
use crate::exchange::{Answer, Conversation, ExchangeError, Limits, Master, Question, Record, Verdict};
use crate::tick::Tick;
use crate::transport::{Link, Wake};

/// Strange telegrams that are kept until somebody asks for them.
const MOST_OVERHEARD: usize = 4_096;

/// A line, whoever talks over it.
pub(super) struct OpenLine<'a> {
    pub(super) link: Link,
    pub(super) master: Master,
    pub(super) account: Account<'a>,
    /// Telegrams and garbage that were not for the master, if anybody wants them.
    overheard: Option<Vec<Record>>,
}

impl<'a> OpenLine<'a> {
    pub(super) fn new(link: Link, master: Master, account: Account<'a>) -> Self {
        OpenLine { link, master, account, overheard: None }
    }

    /// Asks a station, and tells what came.
    pub(super) async fn put(
        &mut self,
        station: u8,
        (question, limits): (Question, Limits),
        interrupt: &Interrupt,
        ends_at: Option<Tick>,
    ) -> Result<Result<Answer, ExchangeError>, PumpError> {
        pump::drain(&mut self.master, &mut self.link).await?;
        self.master.ask_within(station, question, limits, self.link.now());
        let outcome = pump::run(&mut self.master, &mut self.link, interrupt, ends_at).await;
        self.tell_of_recording();
        let records = self.master.take_records();
        let outcome = outcome.map_err(|error| match error {
            PumpError::TimeUp(_) => PumpError::TimeUp(cut_short(&records)),
            error => error,
        });
        self.account.show(self.master.protocol(), &records, Some(station));
        self.keep(records);
        if self.master.answers_twice(station) {
            self.account.tell_twice(station);
        }
        if self.master.differs(station) && matches!(outcome, Ok(Ok(_))) {
            self.account.tell_differing(station);
        }
        outcome
    }

    /// Carries a conversation on until it has something to tell.
    pub(super) async fn carry<C: Conversation>(
        &mut self,
        conversation: &mut C,
        records: impl FnOnce(&mut C) -> Vec<Record>,
        interrupt: &Interrupt,
    ) -> Result<C::End, PumpError> {
        let outcome = pump::run(conversation, &mut self.link, interrupt, None).await;
        self.tell_of_recording();
        self.account.show(self.master.protocol(), &records(conversation), None);
        outcome
    }

    /// Waits until bytes come or the time is over; they go to nobody else.
    pub(super) async fn hear(&mut self, until: Tick, interrupt: &Interrupt) -> Result<Wake, PumpError> {
        let heard = pump::hear(&mut self.link, interrupt, until).await;
        self.tell_of_recording();
        heard
    }

    fn tell_of_recording(&mut self) {
        if let Some(cut) = cut_recording(&mut self.link) {
            self.account.tell(cut);
        }
    }

    /// Says something that nobody answers.
    pub(super) async fn say(&mut self, telegram: &[u8]) -> Result<(), PumpError> {
        self.link.send(telegram).await?;
        let said = Record { at: self.link.now(), verdict: Verdict::Request, bytes: telegram.to_vec() };
        self.account.show(self.master.protocol(), &[said], None);
        Ok(())
    }

    /// Waits without asking anything.
    pub(super) async fn rest(&mut self, until: Tick, interrupt: &Interrupt) -> Result<(), PumpError> {
        pump::rest(&mut self.master, &mut self.link, interrupt, until).await
    }

    fn keep(&mut self, records: Vec<Record>) {
        let Some(overheard) = &mut self.overheard else { return };
        let is_answer = |record: &Record| matches!(record.verdict, Verdict::Reply | Verdict::Echo | Verdict::Copy);
        let room = MOST_OVERHEARD.saturating_sub(overheard.len());
        overheard.extend(records.into_iter().filter(|record| !is_answer(record)).take(room));
    }

    /// What came since the last call and was no answer to a question, and what was sent; kept from the first call on.
    pub(super) fn overheard(&mut self) -> Vec<Record> {
        std::mem::take(self.overheard.get_or_insert_default())
    }
}

/// What came of a question whose time was over.
fn cut_short(records: &[Record]) -> ExchangeError {
    let count = |ours: &[Verdict]| records.iter().filter(|record| ours.contains(&record.verdict)).count();
    let asked = u8::try_from(count(&[Verdict::Request])).unwrap_or(u8::MAX);
    match count(&[Verdict::Request, Verdict::Fence, Verdict::Farewell, Verdict::Echo]) == records.len() {
        true => ExchangeError::NoTime { asked },
        false => ExchangeError::Unproven { asked },
    }
}

/// A drive that answers late may still owe a reply. Nobody else gets the line before it has come or cannot come any
/// more: the next program would take it for the answer to its own question. Costs nothing unless a reply is missing.
impl Drop for OpenLine<'_> {
    fn drop(&mut self) {
        if let Some(until) = self.master.owes_until(self.link.now()) {
            self.link.outlast(until);
        }
        self.link.part();
    }
}
