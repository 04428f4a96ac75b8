//! `identify`: what is at an address, and how does it want to be talked to?

use super::lines::OverLines;
use super::profibus::{self, SlaveArgs};
use super::verb::{Verb, Working};
use super::{Context, Reader, Row, each_drive, finish, plan, role_questions, terms};
use crate::args::{Settings, Takes};
use crate::drive::{AccessError, Finding, Inquiry, Recognised, Session, Terms, Upper, introduce};
use crate::failure::Failure;
use crate::outcome::{Data, Document, ErrorDoc, Evidence, Identify, Identity, Module, OrLines, OrPlan, Outcome};
use crate::profile::{DataSets, Family, Registry, Role};
use crate::text::{Text, both};
use clap::Args as ClapArgs;

/// Tells what a drive is, and how it is set up for talking to it.
///
/// Shows the family with the evidence for it, protocol, baud rate, parity, address, watchdog, control mode,
/// configuration, active data set, and which option modules answer. Nothing in the drive is changed.
///
/// Over PROFIBUS (--protocol dp) a slave is taken for it, held by the stop word, and let go: its ident number, the name in its GSD (--gsd),
/// P.964, P.624, P.800, P.801, P.251 and the address of its switches.
#[derive(Clone, Debug, Default, ClapArgs)]
pub struct Args {
    /// How a slave of PROFIBUS is taken.
    #[command(flatten)]
    pub slave: SlaveArgs,
}

/// Roles whose values matter for talking to a drive, in the order in which they are shown.
const ROLES: [Role; 9] = [
    Role::Address,
    Role::Protocol,
    Role::BaudRate,
    Role::Parity,
    Role::Watchdog,
    Role::ControlMode,
    Role::Configuration,
    Role::ActiveSet,
    Role::SetSelection,
];

/// What is often changed in RAM alone: shown as it holds now. The others of [`ROLES`] wait for a restart anyway.
const IN_FORCE: [Role; 2] = [Role::Watchdog, Role::ControlMode];

impl Verb for Args {
    const NAME: &'static str = "identify";
    const TAKES: Takes = Takes::READS;
    const SDO: bool = true;
    const PROFIBUS: bool = true;
    const EXAMPLES: &'static [&'static str] =
        &["antrieb --port sim -a 1 identify", "antrieb --port sim -a 1,2 identify --json"];
    const UPPER: Upper = Upper::drive(60);
    type Prints = Document<OrPlan<OrLines<Identify>>>;

    fn over_lines(&self) -> OverLines {
        OverLines::Each
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Identifies every drive that was named.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if args.slave.is_meant(context.settings)? {
        return profibus::identify(&args.slave, context).await;
    }
    if context.settings.dry_run {
        let family = super::offline_family(context.settings, context.registry)?;
        return plan(context, &family, &looks(&family));
    }
    let (drives, failures, succeeded) = each_drive(
        context,
        <Args as Verb>::UPPER.drive,
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            identify(session, settings, registry, address).await
        },
        |address, failure: &Failure| Identity {
            address,
            node: 0,
            drive: "unknown".to_owned(),
            title: Text::default(),
            product: None,
            evidence: Vec::new(),
            modules: Vec::new(),
            values: Vec::new(),
            error: Some(ErrorDoc::from(failure)),
        },
    )
    .await?;
    Ok(finish(Data::Identify(Identify { drives }), failures, succeeded, Vec::new()))
}

/// What is asked of every drive, beside what tells its family.
pub(super) fn looks(family: &Family) -> Vec<Inquiry> {
    role_questions(family, &ROLES)
}

async fn identify(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
) -> Result<Row<Identity>, Failure> {
    let terms = terms(settings, registry)?;
    let known = match &terms.named {
        Some(_) => Ok(as_named(session, &terms, address).await?),
        None => terms.inquired(session, address, false).await?,
    };
    let mut known = match known {
        Ok(known) => known,
        Err(Finding { evidence, product, .. }) => return Ok((stranger(address, evidence, product), Vec::new(), 1)),
    };
    told(session, registry, &mut known).await
}

/// A drive whose family was typed, with what it tells of itself.
async fn as_named(session: &mut Session<'_>, terms: &Terms<'_>, address: u8) -> Result<Recognised, Failure> {
    let Recognised { target, mut evidence, .. } = terms.recognised(session, address, false).await?;
    let told = introduce(session, terms.registry, &target).await.map_err(|error| error.failure(address, None))?;
    let Finding { evidence: more, product, .. } = told.unwrap_or_default();
    evidence.extend(more);
    Ok(Recognised { target, evidence, product })
}

/// Somebody answers, and it is no drive that we know.
fn stranger(address: u8, evidence: Vec<Evidence>, product: Option<String>) -> Identity {
    Identity {
        address,
        node: 0,
        drive: "unknown".to_owned(),
        title: both!("Modbus device, no known drive", "Modbus-Gerät, kein bekannter Antrieb"),
        product,
        evidence,
        modules: Vec::new(),
        values: Vec::new(),
        error: None,
    }
}

/// What a drive tells of itself whose family is known.
pub(super) async fn told(
    session: &mut Session<'_>,
    registry: &Registry,
    known: &mut Recognised,
) -> Result<Row<Identity>, Failure> {
    let Recognised { target, evidence, product } = known;
    let address = target.address;
    let title = registry.drives().into_iter().find(|drive| drive.id == target.family.drive);
    let title = title.map_or_else(Text::default, |drive| drive.title.clone());
    let mut reader = Reader::new(session, target);
    let mut values = Vec::new();
    for role in ROLES {
        match IN_FORCE.contains(&role) {
            true => values.extend(reader.in_force(role).await?.rows()),
            false => values.extend(reader.role(role).await?),
        }
    }
    let modules = modules(&mut reader).await?;
    let drive = reader.target.family.drive.clone();
    let (failures, good) = reader.into_failures();
    let (evidence, product) = (evidence.clone(), product.clone());
    Ok((Identity { address, node: 0, drive, title, product, evidence, modules, values, error: None }, failures, good))
}

/// Asks one parameter of every option module that the catalogue knows: an unknown parameter means no module.
async fn modules(reader: &mut Reader<'_, '_>) -> Result<Vec<Module>, Failure> {
    let mut probes = std::collections::BTreeMap::new();
    for param in reader.target.family.params.values().filter(|param| param.access.reads()) {
        if let Some(module) = &param.module {
            probes.entry(module.clone()).or_insert_with(|| param.clone());
        }
    }
    let mut modules = Vec::new();
    for (name, param) in probes {
        let answers = reader.target.read(reader.session, &param, DataSets::Unnamed).await;
        let mut present = false;
        for (_, answer) in answers {
            match answer {
                Ok(_) => present = true,
                Err(error) if error.is_fatal() => {
                    return Err(error.failure(reader.target.address, None));
                }
                Err(AccessError::Refused(refusal)) => present |= refusal.cause.is_some_and(|cause| cause != 11),
                Err(_) => {}
            }
        }
        let param = param.id;
        let evidence = match present {
            true => both!("P.{param} answers", "P.{param} antwortet"),
            false => both!("P.{param} is unknown to the drive", "P.{param} kennt der Antrieb nicht"),
        };
        modules.push(Module { name, present, evidence });
    }
    Ok(modules)
}
