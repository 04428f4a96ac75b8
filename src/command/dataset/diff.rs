//! `dataset diff`: data sets, files, drives and factory settings against each other.

use super::opened::Opened;
use super::weighing::{Weighed, Weight, told};
use super::which::Which;
use crate::command::read::select_failure;
use crate::command::verb::Verb;
use crate::command::{Context, addresses_to_read, connect, terms};
use crate::drive::paramfile::Wanted;
use crate::drive::{Session, Target, Terms, is_over};
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::profile::paramfile::Scope;
use crate::profile::{Family, Param, Selector, Sets, Store};
use crate::text::both;
use clap::Args as ClapArgs;
use std::collections::BTreeSet;
use std::rc::Rc;

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// 1-4, 1ram-4ram, FILE, factory, drive, or drive:ADDRESS
    #[arg(value_name = "A")]
    pub(super) a: Which,
    /// The same
    #[arg(value_name = "B")]
    pub(super) b: Which,
    /// Parameters, ranges, groups [default: all]
    #[arg(value_name = "PARAMETER")]
    pub(super) params: Vec<String>,
    /// Show the differences as lines of both files
    #[arg(long)]
    pub(super) unified: bool,
}

impl Options {
    /// Whether a drive is asked.
    pub(super) fn is_live(&self) -> bool {
        [&self.a, &self.b].iter().any(|which| matches!(which, Which::Set(..) | Which::Drive(_)))
    }

    /// Two data sets of one drive, if that is what is compared.
    pub(super) fn sets(&self) -> Option<[(u8, Store); 2]> {
        match (&self.a, &self.b) {
            (&Which::Set(a, a_store), &Which::Set(b, b_store)) => Some([(a, a_store), (b, b_store)]),
            _ => None,
        }
    }
}

pub(super) async fn run(options: &Options, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let sides = [&options.a, &options.b];
    if options.a == options.b {
        let message = both!("expected two different sides", "erwartet: zwei verschiedene Seiten");
        return Err(Failure::new(Class::Usage, "usage.sides", message));
    }
    let named = context.settings.named_drive();
    let mut files = Vec::new();
    for which in sides {
        files.push(match which {
            Which::File(path) => Some(Opened::read(path, context.registry, named)?),
            _ => None,
        });
    }
    let needs_address = sides.iter().any(|which| matches!(which, Which::Set(..) | Which::Drive(None)));
    let addresses: Vec<Option<u8>> = match needs_address {
        true => {
            let addresses = addresses_to_read(context.settings, context.observe)?;
            super::not_everybody(&addresses)?;
            addresses.into_iter().map(Some).collect()
        }
        false => vec![None],
    };
    let is_live = options.is_live();
    let Context { settings, registry, interrupt, observe, .. } = context;
    let terms = terms(settings, registry)?;
    let mut session = match is_live {
        true => Some(connect(settings, registry, interrupt, *observe).await?),
        false => None,
    };
    let mut weighed = Vec::new();
    for &address in &addresses {
        let one = weigh(options, &files, session.as_mut(), &terms, address).await;
        let one = match (one, address) {
            (Err(failure), Some(address)) if addresses.len() > 1 => {
                Weighed::unasked(sides, files.iter().map(Option::as_ref), address, failure)
            }
            (one, _) => one?,
        };
        let over = one.failure.as_ref().is_some_and(is_over);
        weighed.push(one);
        if over {
            break;
        }
    }
    Ok(told(weighed))
}

/// Holds the sides against each other; `address` is that of the drive that they mean.
async fn weigh(
    options: &Options,
    files: &[Option<Opened>],
    mut session: Option<&mut Session<'_>>,
    terms: &Terms<'_>,
    address: Option<u8>,
) -> Result<Weighed, Failure> {
    let sides = [&options.a, &options.b];
    let mut targets = Vec::new();
    for which in sides {
        targets.push(match (which.address(address), &mut session) {
            (Some(address), Some(session)) => {
                session.allow(session.now(), <super::Args as Verb>::UPPER.drive);
                Some(terms.target(session, address, false).await?)
            }
            _ => None,
        });
    }
    let family = common(files, &targets)?;
    let (mut weights, of_all) = (Vec::new(), sides.iter().all(|which| matches!(which, Which::File(_))));
    for ((which, file), target) in sides.into_iter().zip(files).zip(targets) {
        weights.push(Weight::of(which, file.as_ref(), target, &family)?);
    }
    let chosen = chosen(&options.params, &family)?;
    let [mut a, mut b] = <[Weight; 2]>::try_from(weights).map_err(|_| nothing())?;
    for one in [&mut a, &mut b] {
        one.settings.retain(|setting| is_chosen(chosen.as_ref(), setting.param.id));
    }
    if let Some(session) = session {
        read(session, &mut a, &mut b, chosen.as_ref()).await?;
    }
    Ok(Weighed::of(a, b, of_all, options.unified))
}

/// The family of all sides.
fn common(files: &[Option<Opened>], targets: &[Option<Target>]) -> Result<Rc<Family>, Failure> {
    let of_file = files.iter().flatten().map(|file| &file.family);
    let of_drive = targets.iter().flatten().map(|target| &target.family);
    for file in files.iter().flatten() {
        of_file.clone().try_for_each(|family| file.fits_file(&family.drive))?;
        of_drive.clone().try_for_each(|family| file.fits(&family.drive))?;
    }
    let families: Vec<_> = of_file.chain(of_drive).collect();
    match families.as_slice() {
        [] => Err(nothing()),
        [first, others @ ..] if others.iter().all(|other| other.drive == first.drive) => Ok(Rc::clone(first)),
        _ => {
            let message = both!("the drives are of different families", "die Antriebe sind von verschiedenen Familien");
            Err(Failure::new(Class::Data, "data.other_family", message))
        }
    }
}

fn nothing() -> Failure {
    let message =
        both!("expected a file or a drive on one side", "erwartet: auf einer Seite eine Datei oder ein Antrieb");
    Failure::new(Class::Usage, "usage.sides", message)
}

/// The parameters that are meant, if any are named.
fn chosen(texts: &[String], family: &Family) -> Result<Option<BTreeSet<u32>>, Failure> {
    let mut chosen = BTreeSet::new();
    for text in texts {
        let selector: Selector = text.parse().map_err(|error| select_failure(&error))?;
        let found = selector.resolve(family).map_err(|error| select_failure(&error))?;
        chosen.extend(found.into_iter().map(|one| one.param.id));
    }
    Ok((!texts.is_empty()).then_some(chosen))
}

fn is_chosen(chosen: Option<&BTreeSet<u32>>, number: u32) -> bool {
    chosen.is_none_or(|chosen| chosen.contains(&number))
}

/// Reads the sides that are drives: each is asked for what the other side names.
async fn read(
    session: &mut Session<'_>,
    a: &mut Weight,
    b: &mut Weight,
    chosen: Option<&BTreeSet<u32>>,
) -> Result<(), Failure> {
    if a.set().is_some() && b.set().is_some() {
        let family = a.family.clone();
        let params = family.params.values().filter(|param| param.sets == Some(Sets::Four) && param.access.reads());
        let params: Vec<&Param> = params.filter(|param| is_chosen(chosen, param.id)).collect();
        a.ask_set(session, &params).await;
        b.ask_set(session, &params).await;
        return Ok(());
    }
    if a.live.is_some() && b.live.is_some() {
        // One of two drives is read whole, and the other is asked for the same.
        let (whole, in_sets) = if a.set().is_some() { (&mut *b, true) } else { (&mut *a, b.set().is_some()) };
        let mut wanted = Wanted::of(Scope::Settings, &whole.family)?.asked;
        wanted.retain(|one| is_chosen(chosen, one.param.id) && (!in_sets || one.param.sets == Some(Sets::Four)));
        whole.ask(session, &wanted).await;
    }
    a.fill(session, b).await;
    b.fill(session, a).await;
    Ok(())
}
