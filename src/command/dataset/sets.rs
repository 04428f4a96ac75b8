//! The four data sets of a drive: show, select, copy, compare.

use super::only_one;
use crate::command::read::select_failure;
use crate::command::write::permit;
use crate::command::{
    Context, Reader, addresses_to_read, addresses_to_write, check_sets, connect, offline_family, plan, read_question,
    role_questions, summary, target, target_to_change, terms,
};
use crate::drive::job::{self, Job, Step};
use crate::drive::{Session, Target, Terms};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Dataset, DatasetRow, Outcome, Value, Warning, WriteResult};
use crate::profile::{DataSets, Param, Selector, Sets, Store, Type};
use crate::text::both;
use clap::Subcommand;

#[derive(Clone, Debug, Subcommand)]
pub(super) enum Action {
    /// Show parameters in all four data sets side by side
    Show {
        /// Parameters, ranges, groups [default: all switchable]
        #[arg(value_name = "PARAMETER")]
        params: Vec<String>,
    },
    /// Show the data set in use (P.249), and what selects it (P.414)
    Active,
    /// Select a data set (P.414): 1-4, or 0 for the digital inputs
    Select {
        /// 0-4
        #[arg(value_parser = clap::value_parser!(u8).range(0..=4))]
        set: u8,
        /// Select in RAM only, until power-off
        #[arg(long)]
        ram: bool,
    },
    /// Copy the values of one data set into another
    Copy {
        /// 1-4
        #[arg(value_parser = clap::value_parser!(u8).range(1..=4))]
        from: u8,
        /// 1-4
        #[arg(value_parser = clap::value_parser!(u8).range(1..=4))]
        to: u8,
        /// Parameters, ranges, groups [default: all switchable]
        #[arg(value_name = "PARAMETER")]
        params: Vec<String>,
        /// Copy into RAM only, until power-off
        #[arg(long)]
        ram: bool,
    },
    /// Two data sets beside each other, where they differ.
    #[command(skip)]
    Diff { pair: [(u8, Store); 2], params: Vec<String> },
}

/// All four, as they are stored.
const ALL: [(u8, Store); 4] = [(1, Store::Eeprom), (2, Store::Eeprom), (3, Store::Eeprom), (4, Store::Eeprom)];

/// Works on the data sets of one drive.
pub(super) async fn run(action: &Action, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let writes = matches!(action, Action::Select { .. } | Action::Copy { .. });
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let addresses = if writes { addresses_to_write(settings)? } else { addresses_to_read(settings, *observe)? };
    let address = only_one(&addresses)?;
    different_sets(action)?;
    if settings.dry_run {
        return dry_run(action, context, address);
    }
    if let Action::Show { params } | Action::Copy { params, .. } | Action::Diff { params, .. } = action {
        // Names are checked before the port is opened.
        Work { target: Target::new(address, offline_family(settings, registry)?), terms: terms(settings, registry)? }
            .params(params)?;
    }
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let target = match writes {
        true => target_to_change(&mut session, settings, registry, address).await?,
        false => target(&mut session, settings, registry, address, false).await?,
    };
    let mut work = Work { target, terms: terms(settings, registry)? };
    check_sets(&work.target.family, DataSets::All(Store::Eeprom))?;
    let session = &mut session;
    match action {
        Action::Show { params } => work.show(session, params, &ALL).await,
        Action::Active => work.active(session).await,
        Action::Select { set, ram } => {
            let step = work.selection(*set, *ram)?;
            work.write(session, vec![step], *ask).await
        }
        Action::Copy { from, to, params, ram } => {
            let store = if *ram { Store::Ram } else { Store::Eeprom };
            work.copy(session, *from, *to, store, params, *ask).await
        }
        Action::Diff { pair, params } => work.diff(session, *pair, params).await,
    }
}

fn different_sets(action: &Action) -> Result<(), Failure> {
    match action {
        Action::Copy { from, to, .. } if from != to => Ok(()),
        Action::Diff { pair: [a, b], .. } if a != b => Ok(()),
        Action::Copy { .. } | Action::Diff { .. } => Err(Failure::new(
            Class::Usage,
            "usage.data_set",
            both!("expected two different data sets", "erwartet: zwei verschiedene Datensätze"),
        )),
        _ => Ok(()),
    }
}

/// Shows what would be sent. Copying depends on what is read, so it cannot be shown.
fn dry_run(action: &Action, context: &mut Context<'_>, address: u8) -> Result<Outcome, Failure> {
    let settings = context.settings;
    let target = Target::new(address, offline_family(settings, context.registry)?);
    let work = Work { target, terms: terms(settings, context.registry)? };
    let (params, sets): (_, &[(u8, Store)]) = match action {
        Action::Show { params } => (params, &ALL),
        Action::Diff { pair, params } => (params, pair),
        Action::Active => {
            let family = &work.target.family;
            return plan(context, family, &role_questions(family, &["active-set", "set-selection"]));
        }
        Action::Select { set, ram } => {
            let step = work.selection(*set, *ram)?;
            return crate::command::write::plan_only(&work.terms, &[address], &work.target.family, &[step]);
        }
        Action::Copy { .. } => {
            let message = both!(
                "what a copy writes depends on what it reads, and a dry run opens nothing",
                "was eine Kopie schreibt, hängt von dem ab, was sie liest, und ein Probelauf öffnet nichts"
            );
            return Err(Failure::new(Class::Usage, "usage.dry_run", message).hint(both!(
                "`dataset diff FROM TO` shows what a copy would change",
                "`dataset diff VON NACH` zeigt, was eine Kopie ändern würde"
            )));
        }
    };
    let wire: Vec<u8> = sets.iter().flat_map(|&(set, store)| DataSets::One(set, store).wire()).collect();
    let params = work.params(params)?;
    let questions: Vec<_> =
        params.iter().flat_map(|param| wire.iter().map(move |&set| read_question(param, set))).collect();
    plan(context, &work.target.family, &questions)
}

struct Work<'s> {
    target: Target,
    terms: Terms<'s>,
}

impl Work<'_> {
    /// The write that selects a data set.
    fn selection(&self, set: u8, ram: bool) -> Result<Step, Failure> {
        let param = self.target.family.role("set-selection").cloned();
        let missing = || {
            Failure::new(
                Class::Data,
                "data.role",
                both!("this drive has no data set selection", "dieser Antrieb hat keine Datensatzumschaltung"),
            )
        };
        let param = param.ok_or_else(missing)?;
        let place = DataSets::One(0, if ram { Store::Ram } else { Store::Eeprom });
        let kind = param.kind;
        Ok(Step { param, set: place.wire().first().copied().unwrap_or(0), raw: set.into(), kind })
    }

    /// The parameters that the user means, or every switchable one.
    fn params(&self, texts: &[String]) -> Result<Vec<Param>, Failure> {
        let family = &self.target.family;
        if texts.is_empty() {
            let four = family.params.values().filter(|param| param.sets == Some(Sets::Four) && param.access.reads());
            return Ok(four.cloned().collect());
        }
        let mut params = Vec::new();
        for text in texts {
            let selector: Selector = text.parse().map_err(|error| select_failure(&error))?;
            if selector.names_sets() {
                let message = both!(
                    "'{text}' names a data set, but this verb decides which sets are meant",
                    "'{text}' nennt einen Datensatz, aber welche gemeint sind, bestimmt dieser Befehl"
                );
                return Err(Failure::new(Class::Usage, "usage.data_set", message)
                    .hint(both!("name the parameter without @", "den Parameter ohne @ angeben")));
            }
            let selections = selector.resolve(family).map_err(|error| select_failure(&error))?;
            // Of a group only what may exist in four sets; what was named one by one is asked whatever we know.
            let fitting = selections.into_iter().filter(|one| !one.of_group || one.param.sets == Some(Sets::Four));
            params.extend(fitting.map(|selection| selection.param));
        }
        if params.is_empty() {
            let message = both!(
                "nothing of {what} exists in four data sets",
                "nichts von {what} gibt es in vier Datensätzen",
                what = texts.join(" ")
            );
            return Err(Failure::new(Class::No, "no.switchable", message)
                .hint(both!("`read` shows what exists once", "`read` zeigt, was es einmal gibt")));
        }
        params.iter().try_for_each(|param| crate::command::check_number(family, param))?;
        Ok(params)
    }

    /// Reads parameters in some data sets; what the drive does not have in sets is left out and named.
    async fn rows(
        &mut self,
        session: &mut Session<'_>,
        texts: &[String],
        sets: &[(u8, Store)],
    ) -> Result<(Vec<DatasetRow>, Vec<Failure>, Vec<Warning>), Failure> {
        let mut rows = Vec::new();
        let named = !texts.is_empty();
        let mut missing = Vec::new();
        let params = self.params(texts)?;
        let mut reader = Reader::new(session, &mut self.target);
        for param in params {
            let mut values = Vec::new();
            for &(set, store) in sets {
                values.extend(reader.rows(&param, DataSets::One(set, store)).await?);
            }
            if !named
                && values.iter().all(|value| value.error.as_ref().is_some_and(|error| error.class == Class::Refused))
            {
                // Of a group not every drive has everything: an option module is not fitted, or the row was a guess.
                reader.failures.truncate(reader.failures.len().saturating_sub(values.len()));
                missing.push(param.id.to_string());
                continue;
            }
            let raws: Vec<_> = values.iter().map(|value| value.raw).collect();
            let equal = raws.windows(2).all(|pair| pair.first() == pair.last()) && raws.iter().all(Option::is_some);
            rows.push(DatasetRow {
                param: param.id,
                slug: param.slug.clone(),
                name: param.name.clone(),
                unit: param.unit.clone(),
                equal,
                values,
            });
        }
        let mut warnings = std::mem::take(&mut reader.warnings);
        if !missing.is_empty() {
            warnings.push(Warning {
                code: "dataset.not_there".to_owned(),
                message: both!(
                    "this drive does not have in its data sets: {missing}",
                    "dieser Antrieb hat in seinen Datensätzen nicht: {missing}",
                    missing = missing.join(", ")
                ),
            });
        }
        Ok((rows, reader.failures, warnings))
    }

    async fn header(&mut self, session: &mut Session<'_>) -> Result<(Option<i64>, Option<Value>), Failure> {
        let mut reader = Reader::new(session, &mut self.target);
        let active = reader.vital_role("active-set").await?.and_then(|value| value.raw);
        let selection = reader.vital_role("set-selection").await?;
        match reader.failures.pop() {
            Some(failure) => Err(failure),
            None => Ok((active, selection)),
        }
    }

    async fn report(&mut self, session: &mut Session<'_>, rows: Vec<DatasetRow>) -> Result<Dataset, Failure> {
        let (active, selection) = self.header(session).await?;
        Ok(Dataset {
            address: self.target.address,
            drive: self.target.family.drive.clone(),
            active,
            selection,
            rows,
            written: Vec::new(),
            dry_run: false,
        })
    }

    async fn active(&mut self, session: &mut Session<'_>) -> Result<Outcome, Failure> {
        Ok(Outcome::of(Data::Dataset(self.report(session, Vec::new()).await?)))
    }

    async fn show(
        &mut self,
        session: &mut Session<'_>,
        texts: &[String],
        sets: &[(u8, Store)],
    ) -> Result<Outcome, Failure> {
        let (rows, failures, warnings) = self.rows(session, texts, sets).await?;
        let good = rows.iter().flat_map(|row| &row.values).filter(|value| value.error.is_none()).count();
        let report = self.report(session, rows).await?;
        Ok(Outcome { data: Some(Data::Dataset(report)), warnings, failure: summary(failures, good) })
    }

    async fn diff(
        &mut self,
        session: &mut Session<'_>,
        pair: [(u8, Store); 2],
        texts: &[String],
    ) -> Result<Outcome, Failure> {
        let [a, b] = pair.map(|(set, store)| DataSets::One(set, store));
        let mut outcome = self.show(session, texts, &pair).await?;
        if let Some(Data::Dataset(report)) = &mut outcome.data {
            report.rows.retain(|row| !row.equal);
            if outcome.failure.is_none() && !report.rows.is_empty() {
                let message = match report.rows.len() {
                    1 => both!(
                        "data sets {a} and {b} differ in 1 parameter",
                        "Datensatz {a} und {b} unterscheiden sich in 1 Parameter"
                    ),
                    count => both!(
                        "data sets {a} and {b} differ in {count} parameters",
                        "Datensatz {a} und {b} unterscheiden sich in {count} Parametern"
                    ),
                };
                outcome.failure = Some(Failure::new(Class::No, "no.differences", message));
            }
        }
        Ok(outcome)
    }

    async fn copy(
        &mut self,
        session: &mut Session<'_>,
        from: u8,
        to: u8,
        store: Store,
        texts: &[String],
        ask: &mut dyn crate::gate::Ask,
    ) -> Result<Outcome, Failure> {
        let (rows, failures, warnings) = self.rows(session, texts, &[(from, Store::Eeprom)]).await?;
        if let Some(failure) = failures.into_iter().next() {
            return Err(failure);
        }
        let to = DataSets::One(to, store).wire().first().copied().unwrap_or(to);
        let mut steps = Vec::new();
        for value in rows.iter().flat_map(|row| &row.values) {
            let param = self.target.family.param_or_unknown(value.param);
            if let Some(raw) = value.raw.filter(|_| param.access.writes()) {
                let kind = value.kind.and_then(|name| name.parse::<Type>().ok());
                steps.push(Step { param, set: to, raw, kind });
            }
        }
        let mut outcome = self.write(session, steps, ask).await?;
        outcome.warnings.extend(warnings);
        Ok(outcome)
    }

    /// Writes, after asking, and reports; in a dry run only says what would be written.
    async fn write(
        &mut self,
        session: &mut Session<'_>,
        steps: Vec<Step>,
        ask: &mut dyn crate::gate::Ask,
    ) -> Result<Outcome, Failure> {
        let rows = job::prepare(session, &mut self.target, &self.terms, &steps, false).await?;
        let target = Target::new(self.target.address, self.target.family.clone());
        let mut job = Job { target: std::mem::replace(&mut self.target, target), steps, rows };
        let mut failures = Vec::new();
        let jobs = [job];
        let permit = permit(session, ask, &jobs).await?;
        [job] = jobs;
        if let Some(permit) = permit {
            job::carry_out(session, &mut job, &self.terms, &permit, &mut failures).await;
        }
        let good = job.rows.iter().filter(|row| row.error.is_none() && row.result != WriteResult::Skipped).count();
        let mut report = self.report(session, Vec::new()).await?;
        report.written = job.rows;
        Ok(Outcome { data: Some(Data::Dataset(report)), warnings: Vec::new(), failure: summary(failures, good) })
    }
}
