//! The four data sets of a drive: show, select, copy, compare.

use super::not_everybody;
use super::of_each::{Planned, Told, blank, selection, told, write};
use crate::command::read::select_failure;
use crate::command::{
    Context, InForce, Reader, addresses_to_read, addresses_to_write, check_sets, connect, offline_family, plan,
    read_question, role_questions, summary, target, target_to_change, terms,
};
use crate::drive::job::Step;
use crate::drive::{Session, Target, Terms};
use crate::failure::{Class, Failure};
use crate::outcome::{Dataset, DatasetRow, Event, Outcome, Value, Warning, numbered};
use crate::profile::{DataSets, Family, Param, Selector, Sets, Store, Type};
use crate::text::{Text, both};
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

/// The sets of a drive: four, or the main and the second set of an inverter, whose parameters have numbers of their own.
fn all(family: &Family) -> &'static [(u8, Store)] {
    if family.link.route.has_data_sets() { &ALL } else { &ALL[..2] }
}

/// Refuses what the family has not: any sets, or this one, or a memory of its own for what is in force.
fn check(family: &Family, sets: &[(u8, Store)]) -> Result<(), Failure> {
    if !family.has_sets() {
        return check_sets(family, DataSets::All(Store::Eeprom));
    }
    let Some((set, store)) = sets.iter().find(|set| !family.link.route.has_data_sets() && !all(family).contains(set))
    else {
        return Ok(());
    };
    let place = DataSets::One(*set, *store);
    let message = both!(
        "there is no set {place}: this inverter has 1 (main set) and 2 (second set)",
        "einen Satz {place} gibt es nicht: dieser Umrichter hat 1 (Hauptparametersatz) und 2 (zweiter Parametersatz)"
    );
    Err(Failure::new(Class::Data, "data.no_data_sets", message))
}

/// What an action names of sets.
fn named(action: &Action) -> Vec<(u8, Store)> {
    match action {
        Action::Diff { pair, .. } => pair.to_vec(),
        Action::Copy { from, to, ram, .. } => {
            vec![(*from, Store::Eeprom), (*to, if *ram { Store::Ram } else { Store::Eeprom })]
        }
        Action::Select { set, ram } => vec![(*set, if *ram { Store::Ram } else { Store::Eeprom })],
        Action::Show { .. } | Action::Active => Vec::new(),
    }
}

/// Works on the data sets of every drive that was named.
pub(super) async fn run(action: &Action, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let writes = matches!(action, Action::Select { .. } | Action::Copy { .. });
    let Context { settings, registry, observe, .. } = context;
    let addresses = if writes { addresses_to_write(settings)? } else { addresses_to_read(settings, *observe)? };
    not_everybody(&addresses)?;
    different_sets(action)?;
    if settings.dry_run {
        return dry_run(action, context, &addresses);
    }
    if let Action::Show { params } | Action::Copy { params, .. } | Action::Diff { params, .. } = action {
        // Names are checked before the port is opened.
        let target = Target::new(0, offline_family(settings, registry)?);
        if !target.family.link.route.has_data_sets() {
            check(&target.family, &named(action))?;
        }
        Work { target, terms: terms(settings, registry)? }.params(params)?;
    }
    if writes { change(action, context, addresses).await } else { look(action, context, addresses).await }
}

/// Reads of every drive what is wanted; one that cannot be asked costs the others nothing.
async fn look(action: &Action, context: &mut Context<'_>, addresses: Vec<u8>) -> Result<Outcome, Failure> {
    let Context { settings, registry, interrupt, observe, .. } = context;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let mut drives = Vec::new();
    for &address in &addresses {
        let of_one = async |session: &mut Session<'_>| {
            let target = target(session, settings, registry, address, false).await?;
            check(&target.family, &named(action))?;
            let mut work = Work { target, terms: terms(settings, registry)? };
            match action {
                Action::Show { params } => {
                    let sets = all(&work.target.family);
                    work.show(session, params, sets).await
                }
                Action::Diff { pair, params } => work.diff(session, *pair, params).await,
                _ => work.report(session, Vec::new()).await,
            }
        };
        match of_one(&mut session).await {
            Err(failure) if addresses.len() == 1 => return Err(failure),
            one => drives.push(one.unwrap_or_else(|failure| Told::nothing(address, failure))),
        }
        if drives.last().is_some_and(Told::is_over) {
            break;
        }
    }
    Ok(told(drives, addresses.len()))
}

/// Writes to every drive behind one question; all of them are looked at before it.
async fn change(action: &Action, context: &mut Context<'_>, addresses: Vec<u8>) -> Result<Outcome, Failure> {
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let mut planned = Vec::new();
    for &address in &addresses {
        let target = target_to_change(&mut session, settings, registry, address).await?;
        check(&target.family, &named(action))?;
        let mut work = Work { target, terms: terms(settings, registry)? };
        let (steps, warnings) = match action {
            Action::Copy { from, to, params, ram } => {
                let store = if *ram { Store::Ram } else { Store::Eeprom };
                work.copies(&mut session, *from, (*to, store), params).await?
            }
            Action::Select { set, ram } => (vec![work.selection(*set, *ram)?], Vec::new()),
            _ => (Vec::new(), Vec::new()),
        };
        planned.push(Planned { target: work.target, steps, warnings });
    }
    write(&mut session, *ask, &terms(settings, registry)?, planned).await
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
fn dry_run(action: &Action, context: &mut Context<'_>, addresses: &[u8]) -> Result<Outcome, Failure> {
    let settings = context.settings;
    let target = Target::new(0, offline_family(settings, context.registry)?);
    let work = Work { target, terms: terms(settings, context.registry)? };
    let (params, sets): (_, &[(u8, Store)]) = match action {
        Action::Show { params } => (params, all(&work.target.family)),
        Action::Diff { pair, params } => (params, pair),
        Action::Active => {
            let family = &work.target.family;
            return plan(context, family, &role_questions(family, &["active-set", "set-selection"]));
        }
        Action::Select { set, ram } => {
            let step = work.selection(*set, *ram)?;
            return crate::command::write::plan_only(&work.terms, addresses, &work.target.family, &[step]);
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
    if work.target.family.has_sets() {
        check(&work.target.family, &named(action))?;
    }
    let params = work.params(params)?;
    let of_one = |param: &Param| {
        let places = sets.iter().map(|&(set, store)| work.in_set(param, set, store));
        let each =
            |(param, sets): (Param, DataSets)| sets.wire().into_iter().map(move |set| read_question(&param, set));
        places.flat_map(each).collect::<Vec<_>>()
    };
    let questions: Vec<_> = params.iter().flat_map(of_one).collect();
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
        let kind = param.kind;
        if !self.target.family.link.route.has_data_sets() {
            // The first of two sets has the number 0 on the wire (SJ2-PB manual 5.3).
            return Ok(Step { param, set: 0, raw: i64::from(set) - 1, kind, at: None });
        }
        let place = DataSets::One(0, if ram { Store::Ram } else { Store::Eeprom });
        Ok(Step { param, set: place.wire().first().copied().unwrap_or(0), raw: set.into(), kind, at: None })
    }

    /// The parameters that the user means, or every switchable one.
    fn params(&self, texts: &[String]) -> Result<Vec<Param>, Failure> {
        let family = &self.target.family;
        if texts.is_empty() {
            let four = family.params.values().filter(|param| self.is_in_sets(param) && param.access.reads());
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
            let fitting = selections.into_iter().filter(|one| match family.link.route.has_data_sets() {
                true => !one.of_group || self.is_in_sets(&one.param),
                false => self.is_in_sets(&one.param),
            });
            params.extend(fitting.map(|selection| selection.param));
        }
        if params.is_empty() {
            let message = both!(
                "nothing of {what} exists in four data sets",
                "nichts von {what} gibt es in vier Datensätzen",
                what = texts.join(" ")
            );
            return Err(Failure::new(Class::Data, "data.no_switchable", message)
                .hint(both!("`read` shows what exists once", "`read` zeigt, was es einmal gibt")));
        }
        params.iter().try_for_each(|param| crate::command::check_number(family, param))?;
        Ok(params)
    }

    /// Whether a parameter exists in every set, as far as is known.
    fn is_in_sets(&self, param: &Param) -> bool {
        param.sets == Some(Sets::Four) || self.target.family.in_second_set(param).is_some()
    }

    /// A parameter in one set: under its own number, or under that which it has in the second set of an inverter.
    fn in_set(&self, param: &Param, set: u8, store: Store) -> (Param, DataSets) {
        match self.target.family.in_second_set(param) {
            Some(second) if set == 2 => (second.clone(), DataSets::Unnamed),
            Some(_) => (param.clone(), DataSets::Unnamed),
            None => (param.clone(), DataSets::One(set, store)),
        }
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
        let places = |param: Param| {
            let in_sets: Vec<_> = sets.iter().map(|&(set, store)| (set, self.in_set(&param, set, store))).collect();
            (param, in_sets)
        };
        let params: Vec<_> = self.params(texts)?.into_iter().map(places).collect();
        let mut reader = Reader::new(session, &mut self.target);
        for (param, places) in params {
            let mut values = Vec::new();
            for (set, (param, sets)) in places {
                let read = reader.rows(&param, sets).await?;
                // By its own number it is in no data set to the drive.
                let is_apart = sets == DataSets::Unnamed;
                values.extend(read.into_iter().map(|value| match is_apart {
                    true => Value { data_set: set, ..value },
                    false => value,
                }));
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

    async fn report(&mut self, session: &mut Session<'_>, rows: Vec<DatasetRow>) -> Result<Told, Failure> {
        let (active, selection) = selection(session, &mut self.target).await?;
        let InForce { value: selection, stored: selection_stored } = selection;
        let report = Dataset {
            active,
            selection,
            selection_stored,
            rows,
            ..blank(self.target.address, &self.target.family.drive)
        };
        Ok(Told { report, failure: None, warnings: Vec::new() })
    }

    async fn show(
        &mut self,
        session: &mut Session<'_>,
        texts: &[String],
        sets: &[(u8, Store)],
    ) -> Result<Told, Failure> {
        let (rows, failures, warnings) = self.rows(session, texts, sets).await?;
        let good = rows.iter().flat_map(|row| &row.values).filter(|value| value.error.is_none()).count();
        let told = self.report(session, rows).await?;
        Ok(Told { failure: summary(failures, good), warnings, ..told })
    }

    async fn diff(
        &mut self,
        session: &mut Session<'_>,
        pair: [(u8, Store); 2],
        texts: &[String],
    ) -> Result<Told, Failure> {
        let [a, b] = pair.map(|(set, store)| DataSets::One(set, store));
        let mut told = self.show(session, texts, &pair).await?;
        let compared = told.report.rows.len();
        told.report.rows.retain(|row| !row.equal);
        let count = told.report.rows.len();
        if count == 0 && told.failure.is_none() {
            let all = Text::count(compared as u64, ["parameter", "parameters"], ["Parameter", "Parametern"]);
            session.tell(Event::Note(both!(
                "data sets {a} and {b} are equal in {all}",
                "Datensatz {a} und {b} sind in {all} gleich",
                all
            )));
        }
        let message = match count {
            1 => both!(
                "data sets {a} and {b} differ in 1 parameter",
                "Datensatz {a} und {b} unterscheiden sich in 1 Parameter"
            ),
            _ => both!(
                "data sets {a} and {b} differ in {count} parameters",
                "Datensatz {a} und {b} unterscheiden sich in {count} Parametern"
            ),
        };
        let differ = (count > 0).then(|| Failure::new(Class::No, "no.differences", message));
        Ok(Told { failure: told.failure.or(differ), ..told })
    }

    /// What a parameter of one set of an inverter is called in the other.
    fn counterpart(&self, param: Param, to: u8) -> Param {
        let family = &self.target.family;
        let other = match to {
            2 => family.in_second_set(&param),
            _ => family
                .params
                .values()
                .find(|main| family.in_second_set(main).is_some_and(|second| second.id == param.id)),
        };
        other.cloned().unwrap_or(param)
    }

    /// The writes that copy one data set into another.
    async fn copies(
        &mut self,
        session: &mut Session<'_>,
        from: u8,
        (to, store): (u8, Store),
        texts: &[String],
    ) -> Result<(Vec<Step>, Vec<Warning>), Failure> {
        let (rows, failures, warnings) = self.rows(session, texts, &[(from, Store::Eeprom)]).await?;
        if let Some(failure) = failures.into_iter().next() {
            let value = rows.iter().flat_map(|row| &row.values).find(|value| value.error.is_some());
            return Err(value.map_or(failure.clone(), |value| not_to_be_copied(failure, value)));
        }
        let to = DataSets::One(to, store).wire().first().copied().unwrap_or(to);
        let mut steps = Vec::new();
        for value in rows.iter().flat_map(|row| &row.values) {
            let param = self.target.family.param_or_unknown(value.param);
            let apart = self.target.family.has_sets() && !self.target.family.link.route.has_data_sets();
            let (param, set) = match apart {
                true => (self.counterpart(param, to), 0),
                false => (param, to),
            };
            if let Some(raw) = value.raw.filter(|_| param.access.writes()) {
                let kind = value.kind.and_then(|name| name.parse::<Type>().ok());
                steps.push(Step { param, set, raw, kind, at: None });
            }
        }
        Ok((steps, warnings))
    }
}

/// The failure of the first value that could not be read, with whose it is.
fn not_to_be_copied(failure: Failure, value: &Value) -> Failure {
    let place = numbered(value.param, value.index) + "@" + &value.data_set.to_string();
    let message = both!(
        "nothing was copied, because {place} could not be read: {why}",
        "nichts wurde kopiert, denn {place} ließ sich nicht lesen: {why}",
        why = failure.message
    );
    Failure { message, ..failure }
}
