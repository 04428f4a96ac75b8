//! The way through a procedure: step by step, each asked, done, proven and kept before the next.

use super::given::Given;
use super::record;
use crate::args::Settings;
use crate::command::{asking, terms};
use crate::drive::job::{self, Job};
use crate::drive::{Interrupt, Session, Target, describe};
use crate::failure::{Class, Failure};
use crate::gate::{Answer, Ask, Denied, Permit, Question, Writing};
use crate::outcome::{
    Data, ErrorDoc, Event, KeptStep, Motion, Outcome, Procedure as Told, ProcedureRecord, ProcedureStep, StepFate,
    Stored, WriteResult, Written,
};
use crate::profile::procedure::{Act, Procedure, Step};
use crate::profile::{Registry, cited};
use crate::text::{Text, both};
use futures_util::future::LocalBoxFuture;
use std::path::{Path, PathBuf};

/// A procedure on its way.
pub(super) struct Guide<'g> {
    pub(super) settings: &'g Settings,
    pub(super) registry: &'g Registry,
    pub(super) interrupt: &'g Interrupt,
    pub(super) ask: &'g mut dyn Ask,
    pub(super) session: Session<'g>,
    /// The drive, once it was asked who it is.
    pub(super) target: Option<Target>,
    pub(super) procedure: &'g Procedure,
    pub(super) given: &'g Given,
    pub(super) record: ProcedureRecord,
    pub(super) path: PathBuf,
    pub(super) again: bool,
    /// Whether the drive was met in this run, and has back what another one had left in it.
    pub(super) met: bool,
    /// Who has confirmed what the step asks.
    pub(super) said: Option<Text>,
}

/// A step as it is done: which of how many.
#[derive(Clone, Copy)]
pub(super) struct Turn<'s> {
    pub(super) step: &'s Step,
    nth: usize,
    of: usize,
}

/// What a step has found so far, whatever becomes of it.
#[derive(Default)]
pub(super) struct Deed {
    pub(super) found: Vec<Text>,
    pub(super) motions: Vec<Motion>,
}

impl Guide<'_> {
    /// Does what is left of it.
    pub(super) async fn go(&mut self) -> Outcome {
        let steps = self.procedure.steps_of(&self.record.drive);
        let (mut rows, mut failure) = (Vec::new(), None);
        for (index, step) in steps.iter().enumerate() {
            let kept = self.record.step(&step.slug).cloned();
            let mut row = row(step, kept.as_ref());
            if row.result != StepFate::Done && failure.is_none() {
                let turn = Turn { step, nth: index + 1, of: steps.len() };
                failure = self.take(turn, &mut row, kept.is_some()).await;
            }
            rows.push(row);
        }
        let told = told(&self.record, rows, &self.path);
        Outcome { data: Some(told), warnings: Vec::new(), failure }
    }

    /// Does one step and keeps what came of it.
    async fn take(&mut self, turn: Turn<'_>, row: &mut ProcedureStep, was_begun: bool) -> Option<Failure> {
        let mut deed = Deed::default();
        let done = match self.begins(turn, was_begun, &mut deed).await {
            Ok(()) => self.act(turn, &mut deed).await,
            Err(failure) => Err(failure),
        };
        self.is_free_again();
        deed.found.splice(0..0, self.said.take());
        (row.found, row.motions, row.earlier, row.time) = (deed.found, deed.motions, false, self.session.utc());
        let failure = done.err();
        row.error = failure.as_ref().map(ErrorDoc::from);
        if failure.as_ref().is_some_and(|failure| UNTOUCHED.contains(&failure.code.as_str())) {
            // Nothing has happened: it is as it was before, or at a run before the question.
            row.result = self.record.step(&turn.step.slug).map_or(StepFate::Open, |kept| kept.result);
            return failure.map(|failure| self.goes_on(failure, turn));
        }
        row.result = if failure.is_some() { StepFate::Failed } else { StepFate::Done };
        let error = failure.as_ref().map(Failure::told);
        let kept = self.keep(turn.step, row.result, &row.found, error);
        // What was done and could not be kept would be done again.
        failure.map(|failure| self.goes_on(failure, turn)).or(kept.err())
    }

    /// Behind a run: the line is used without an end, and whoever interrupts is heard.
    pub(super) fn is_free_again(&mut self) {
        self.session.end_at(None);
        self.session.heed(self.interrupt.clone());
    }

    /// Notes what has become of a step, on the disk.
    pub(super) fn keep(
        &mut self,
        step: &Step,
        result: StepFate,
        found: &[Text],
        error: Option<Text>,
    ) -> Result<(), Failure> {
        let (title, turns, time) = (step.title.clone(), step.act.turns(), self.session.utc());
        let found = found.to_vec();
        self.record.keep(KeptStep { step: step.slug.clone(), title, turns, result, time, found, error });
        record::save(&self.path, &self.record)
    }

    /// What stands before a step: whoever goes on meets the drive again, and what an earlier run has left goes back, whether or not the
    /// step is done then.
    fn begins<'f>(
        &'f mut self,
        turn: Turn<'f>,
        was_begun: bool,
        deed: &'f mut Deed,
    ) -> LocalBoxFuture<'f, Result<(), Failure>> {
        Box::pin(async move {
            if !self.met && turn.step.act != Act::Confirm {
                self.meets_again().await?;
                if !(self.record.lent.is_empty() && self.record.left.is_empty()) {
                    self.give_back(turn, deed).await?;
                }
                self.met = true;
            }
            self.may_begin(turn, was_begun)
        })
    }

    fn may_begin(&mut self, turn: Turn<'_>, was_begun: bool) -> Result<(), Failure> {
        if self.session.is_interrupted() {
            return Err(asking::interrupted());
        }
        if !(turn.step.act.turns() && was_begun && !self.again) {
            return Ok(());
        }
        let message = both!(
            "step '{title}' moves the shaft and was begun before, but did not end as it should; it is not repeated unasked",
            "Schritt '{title}' bewegt die Welle und wurde schon begonnen, endete aber nicht, wie er sollte; er wird nicht \
             ungefragt wiederholt",
            title = turn.step.title
        );
        Err(Failure::new(Class::Forbidden, NOT_AGAIN, message)
            .hint(both!("--again repeats it", "--again wiederholt ihn")))
    }

    /// What is done in a step: on the heap, or each step would bear the size of all of them.
    fn act<'f>(&'f mut self, turn: Turn<'f>, deed: &'f mut Deed) -> LocalBoxFuture<'f, Result<(), Failure>> {
        match turn.step.act {
            Act::Confirm => Box::pin(self.confirm(turn, &[])),
            Act::Identify => Box::pin(self.identify(turn, deed)),
            Act::Line => Box::pin(self.line(turn, deed)),
            Act::Watchdog => Box::pin(self.watchdog(turn, deed)),
            Act::Nameplate => Box::pin(std::future::ready(self.nameplate(turn, deed))),
            Act::Store => Box::pin(self.store(turn, deed)),
            Act::Direction => Box::pin(self.direction(turn, deed)),
            Act::Ramp => Box::pin(self.ramp(turn, deed)),
            Act::Stop => Box::pin(self.stop(turn, deed)),
            Act::Silence => Box::pin(self.silence(turn, deed)),
            Act::Reset => Box::pin(self.reset(turn, deed)),
            Act::Motor => Box::pin(self.motor(turn, deed)),
            Act::Resolver => Box::pin(self.resolver(turn, deed)),
            Act::Hand => Box::pin(self.hand(turn, deed)),
            Act::Offset => Box::pin(self.offset(turn, deed)),
            Act::Zero => Box::pin(self.zero(turn, deed)),
            Act::Full => Box::pin(self.full(turn, deed)),
        }
    }

    /// Somebody says that it is so.
    pub(super) async fn confirm(&mut self, turn: Turn<'_>, more: &[Text]) -> Result<(), Failure> {
        let unasked = self.settings.drive.is_none() && !self.record.asked && !turn.step.drives.is_empty();
        let more = more.iter().cloned().chain(unasked.then(|| of_family(turn.step, &self.record.drive)));
        let question = turn.question(more.collect());
        let answer = self.session.during(self.ask.ask(&question)).await;
        match answer.map_err(|error| error.failure(self.record.address, None)) {
            Ok(Answer::Yes) => {
                self.said = Some(match self.settings.yes {
                    true => both!("nobody was asked: --yes was given", "niemand wurde gefragt: --yes war angegeben"),
                    false => both!("said at the terminal", "am Terminal bestätigt"),
                });
                Ok(())
            }
            Ok(Answer::No) => {
                let message =
                    both!("not confirmed: the procedure ends here", "nicht bestätigt: die Prozedur endet hier");
                Err(Failure::new(Class::Forbidden, "forbidden.not_confirmed", message))
            }
            Ok(Answer::Nobody) => Err(asking::denied(Denied::Nobody)),
            Err(failure) if failure.class == Class::Interrupted => Err(asking::interrupted()),
            Err(failure) => Err(failure),
        }
    }

    /// Says what is done now, where nobody needs to be asked.
    pub(super) fn tell(&mut self, turn: Turn<'_>) {
        let Question { title, details, .. } = turn.question(Vec::new());
        self.session.tell(Event::Note(title));
        details.into_iter().for_each(|detail| self.session.tell(Event::Note(detail)));
    }

    /// Allows so many questions from now on.
    pub(super) fn allow(&mut self) {
        self.session.allow(self.session.now(), <super::Args as crate::command::Verb>::UPPER.drive);
    }

    /// The drive, asked who it is if that is not known yet.
    pub(super) async fn known(&mut self) -> Result<Target, Failure> {
        if let Some(target) = &self.target {
            return Ok(Target::new(target.address, target.family.clone()).in_word_order(self.settings.word_order));
        }
        let terms = terms(self.settings, self.registry)?;
        let target = terms.target(&mut self.session, self.record.address, false).await?;
        self.meets(&target)?;
        let again = Target::new(target.address, target.family.clone()).in_word_order(self.settings.word_order);
        self.target = Some(target);
        Ok(again)
    }

    /// Who answers must be who was meant.
    pub(super) fn meets(&mut self, target: &Target) -> Result<(), Failure> {
        let (drive, meant) = (target.family.drive.clone(), self.record.drive.clone());
        let is_named =
            |step: &KeptStep| !self.procedure.steps.iter().any(|row| row.slug == step.step && row.act == Act::Confirm);
        let is_done = |step: &KeptStep| step.result == StepFate::Done && is_named(step);
        let was_another = drive != meant && (self.record.asked || self.record.steps.iter().any(is_done));
        if !was_another {
            describes(self.procedure, &drive)?;
        }
        if was_another || self.procedure.steps_of(&drive) != self.procedure.steps_of(&meant) {
            let message = both!(
                "a drive of the family {drive} answers, but the steps so far were for the family {meant}",
                "es antwortet ein Antrieb der Familie {drive}, die Schritte bisher galten aber der Familie {meant}"
            );
            return Err(Failure::new(Class::Data, "data.other_drive", message).hint(both!(
                "`--drive {drive} --force` begins anew with it; --record names another record",
                "`--drive {drive} --force` beginnt mit ihm von vorn; --record nennt eine andere Aufzeichnung"
            )));
        }
        (self.record.drive, self.record.asked) = (drive, true);
        Ok(())
    }

    /// Asks, writes and proves values. What stands there already is not written.
    pub(super) async fn write(
        &mut self,
        turn: Turn<'_>,
        deed: &mut Deed,
        steps: Vec<job::Step>,
    ) -> Result<(), Failure> {
        self.put(turn, deed, (steps, false)).await
    }

    /// The same, also of what stands there already: the write itself does something.
    pub(super) async fn write_anyway(
        &mut self,
        turn: Turn<'_>,
        deed: &mut Deed,
        steps: Vec<job::Step>,
    ) -> Result<(), Failure> {
        self.put(turn, deed, (steps, true)).await
    }

    async fn put(
        &mut self,
        turn: Turn<'_>,
        deed: &mut Deed,
        (steps, anyway): (Vec<job::Step>, bool),
    ) -> Result<(), Failure> {
        let mut target = self.known().await?;
        self.allow();
        let terms = terms(self.settings, self.registry)?;
        let rows = job::prepare(&mut self.session, &mut target, &terms, &steps, anyway).await?;
        let mut jobs = vec![Job { target, steps, rows }];
        if let Some(asked) = job::question(&jobs, self.session.own_address()) {
            let question = Question { hazards: asked.hazards, ..turn.question(asked.details) };
            self.session.end_at(None);
            let permit: Permit<Writing> = asking::on_line(&mut self.session, self.ask, &question).await?;
            self.allow();
            let mut failures = Vec::new();
            for job in &mut jobs {
                job::carry_out(&mut self.session, job, &terms, &permit, &mut failures).await;
            }
            if let Some(failure) = failures.into_iter().next() {
                deed.found.extend(jobs.iter().flat_map(|job| &job.rows).map(written));
                return Err(failure);
            }
        }
        if !anyway {
            let rows = jobs.iter().flat_map(|job| &job.rows).filter(|row| row.store == "eeprom");
            let stored = |row: &Written| Stored { param: row.param, data_set: row.data_set, raw: row.raw };
            self.record.store(rows.map(stored));
        }
        deed.found.extend(jobs.iter().flat_map(|job| &job.rows).map(written));
        Ok(())
    }

    /// The failure with what goes on from there.
    fn goes_on(&self, failure: Failure, turn: Turn<'_>) -> Failure {
        if NEVER.contains(&failure.code.as_str()) {
            return failure;
        }
        let (nth, of, name) = (turn.nth, turn.of, &self.procedure.slug);
        let goes_on = match turn.step.act.turns() && self.record.step(&turn.step.slug).is_some() {
            true => both!(
                "the same command with --again repeats step {nth} of {of} ({name}) and goes on",
                "derselbe Befehl mit --again wiederholt Schritt {nth} von {of} ({name}) und macht weiter"
            ),
            false => both!(
                "the same command goes on with step {nth} of {of} ({name})",
                "derselbe Befehl macht mit Schritt {nth} von {of} weiter ({name})"
            ),
        };
        let mut failure = failure;
        let hints: Vec<Text> = failure.hint.take().map(|hint| *hint).into_iter().chain([goes_on]).collect();
        failure.hint(Text::join(&hints, "; "))
    }
}

impl<'s> Turn<'s> {
    /// Something else in the place of this step.
    pub(super) fn with(self, step: &Step) -> Turn<'_> {
        Turn { step, ..self }
    }

    /// Which step it is, what is done, what the manual warns of.
    pub(super) fn question(self, more: Vec<Text>) -> Question {
        let (title, details) = (self.title(), self.details().into_iter().chain(more).collect());
        Question { hazards: Vec::new(), title, details }
    }

    /// Which step it is.
    pub(super) fn title(self) -> Text {
        let Turn { step, nth, of } = self;
        both!("[{nth}/{of}] {title}", "[{nth}/{of}] {title}", title = step.title)
    }

    /// What is done, what the manual warns of, and where it does.
    pub(super) fn details(self) -> Vec<Text> {
        let source = both!("({source})", "({source})", source = cited(&self.step.source));
        let mut details = vec![self.step.does.clone()];
        details.extend(self.step.warning.clone());
        details.push(source);
        details
    }
}

/// What is told of a procedure that was done or begun.
pub(super) fn told(record: &ProcedureRecord, steps: Vec<ProcedureStep>, path: &Path) -> Data {
    Data::Procedure(Box::new(Told {
        dry_run: false,
        procedure: record.procedure.clone(),
        title: record.title.clone(),
        address: record.address,
        drive: record.known_drive().to_owned(),
        record: (!record.steps.is_empty()).then(|| path.display().to_string()),
        complete: steps.iter().all(|row| row.result == StepFate::Done),
        given: record.given.clone(),
        steps,
        notes: record.stays(),
    }))
}

/// A step as its record tells it, or as one whose turn has not come.
pub(super) fn row(step: &Step, kept: Option<&KeptStep>) -> ProcedureStep {
    ProcedureStep {
        step: step.slug.clone(),
        title: step.title.clone(),
        does: step.does.clone(),
        warning: step.warning.clone(),
        source: step.source.clone(),
        turns: step.act.turns(),
        result: kept.map_or(StepFate::Open, |kept| kept.result),
        earlier: kept.is_some(),
        time: kept.and_then(|kept| kept.time.clone()),
        found: kept.map_or_else(Vec::new, |kept| kept.found.clone()),
        motions: Vec::new(),
        telegrams: Vec::new(),
        error: None,
    }
}

/// Refuses a drive for which no manual describes the procedure.
///
/// # Errors
/// It is such a drive.
pub(super) fn describes(procedure: &Procedure, drive: &str) -> Result<(), Failure> {
    if procedure.drives.iter().any(|known| known == drive) {
        return Ok(());
    }
    let message = both!(
        "no manual describes {name} for the family {drive} (only for {known})",
        "kein Handbuch beschreibt {name} für die Familie {drive} (nur für {known})",
        name = procedure.slug,
        known = procedure.drives.join(", ")
    );
    Err(Failure::new(Class::Data, "data.procedure", message))
}

/// A step that is another one for another drive, before anybody has asked which one is there.
fn of_family(step: &Step, drive: &str) -> Text {
    let drives = step.drives.join(", ");
    both!(
        "This is the step for {drives}: nobody has asked the drive yet, and '{drive}' is taken for granted. Another family is named by \
         --drive.",
        "Dies ist der Schritt für {drives}: den Antrieb hat noch niemand gefragt, angenommen ist '{drive}'. Eine andere Familie nennt \
         --drive."
    )
}

/// What became of a value.
fn written(row: &Written) -> Text {
    let (old, new, unit) = describe::change(row);
    let old = old.unwrap_or_else(|| "?".to_owned());
    let fate = match row.result {
        WriteResult::Unchanged => both!("was so before", "war schon so"),
        WriteResult::Verified => both!("written, read back", "geschrieben, zurückgelesen"),
        WriteResult::Written => both!("written, cannot be read back", "geschrieben, nicht zurücklesbar"),
        _ => both!("not proven", "nicht belegt"),
    };
    let (param, set, name) = (row.param, row.data_set, &row.name);
    both!(
        "P.{param}@{set} {name}: {old} -> {new}{unit}, {fate}",
        "P.{param}@{set} {name}: {old} -> {new}{unit}, {fate}",
        name,
        unit,
        fate
    )
}

/// Failures before which nothing has happened.
const UNTOUCHED: [&str; 5] =
    ["forbidden.not_confirmed", "forbidden.no_terminal", "interrupted.question", "data.other_drive", NOT_AGAIN];
/// Failures of a drive for which it is not: the same command comes to the same end.
const NEVER: [&str; 3] = ["data.procedure", "data.other_drive", "data.no_input"];
/// A step that moves was begun before.
const NOT_AGAIN: &str = "forbidden.again";
