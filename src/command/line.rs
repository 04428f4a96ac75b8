//! `line`: speed, parity and address of a drive. What `protocol` shares with it is here too.

use super::again::one_of;
use super::asking::denied;
use super::lines::OverLines;
use super::profibus::SlaveArgs;
use super::verb::{Verb, Working};
use super::{Context, addresses_to_write, connect, offline_family, plan, read, target_to_change};
use crate::args::Takes;
use crate::drive::Upper;
use crate::drive::relocate::{self, Course, Wish};
use crate::failure::{Class, Failure};
use crate::gate::{self, Hazard, Question};
use crate::outcome::{Data, Document, OrRead, Outcome, Relocation};
use crate::text::{Wrong, both};
use crate::tick::Span;
use clap::{Arg, Args as ClapArgs, Subcommand};

/// Changes speed, parity or address of a drive, and follows it.
///
/// Options before `line` say how the drive is reached now; those behind `set` say what is to be:
///
///   antrieb -a 1 line set --baud 115200 --parity odd --address 5
///
/// ACTIVE: a new address holds at once; speed (P.10) and parity (P.1375) hold after a restart (P.34 = 123), which is done
/// too. LXM05: speed and format hold when it is switched on the next time; for the address its manual does not say, so it
/// is looked for at both. On a CAN bus (--protocol sdo) node (P.900) and bit rate (P.903, in bit/s) are changed so, and looked for at both too;
/// the rate only where nobody else is on the bus.
/// After every step the drive has to answer at its new place. If it does not, but still answers at the old one,
/// everything is put back. The way back is printed.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    what: What,
}

#[derive(Clone, Debug, Subcommand)]
enum What {
    /// Speed, parity, addresses as stored; on a CAN bus node, rate, channels
    Show,
    /// Brings the drive to another speed, parity or address
    #[command(arg = present("baud", "now-baud"), arg = present("parity", "now-parity"), arg = present("address", "now-address"))]
    Set {
        /// New speed in baud
        ///
        /// ACTIVE: 2400, 4800, 9600, 19200, 57600 or 115200, LXM05: 9600, 19200 or 38400; CAN: 50000 to 1000000
        #[arg(id = "new_baud", short = 'b', long = "baud", value_name = "BAUD")]
        baud: Option<u32>,
        /// New parity of Modbus: even, odd, none
        #[arg(id = "new_parity", long = "parity", value_name = "PARITY")]
        parity: Option<String>,
        /// New address: Modbus 1-247, VABus 1-30, CAN 1-63
        ///
        /// Of Modbus P.1376, MBadr; of VABus P.394; on a CAN bus P.900.
        #[arg(id = "new_address", short = 'a', long = "address", value_name = "ADDRESS")]
        address: Option<u32>,
    },
}

/// Takes the place of an option of every verb, so that its flag is free for the new setting. It takes no value itself:
/// how the drive is reached now is said before `line`.
fn present(option: &'static str, flag: &'static str) -> Arg {
    let refuse = |_: &str| Err::<String, _>("the present setting is given before `line`");
    Arg::new(option).long(flag).hide(true).value_parser(refuse)
}

impl Verb for Args {
    const NAME: &'static str = "line";
    const TAKES: Takes = Takes::WRITES;
    const SDO: bool = true;
    const EXAMPLES: &'static [&'static str] =
        &["antrieb --port sim -a 1 line show", "antrieb --port sim -a 1 line set --baud 57600 --dry-run"];
    const UPPER: Upper = Upper::drive(120).besides(Span::from_secs(60));
    type Prints = Document<OrRead<Relocation>>;

    fn over_lines(&self) -> OverLines {
        if matches!(self.what, What::Show) { OverLines::Each } else { OverLines::One(None) }
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Shows or changes it.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    match &args.what {
        What::Show => show(context).await,
        What::Set { baud, parity, address } => {
            let parity = parity.as_ref().map(|text| text.parse()).transpose();
            let parity = parity.map_err(|why: Wrong| {
                Failure::new(Class::Usage, "usage.parity", both!("--parity: {why}", "--parity: {why}", why = why.0))
            })?;
            let wish = Wish { baud: *baud, parity, address: *address, ..Wish::default() };
            if wish == Wish::default() {
                let message = both!(
                    "expected at least one of --baud, --parity, --address behind `line set`",
                    "hinter `line set` wird mindestens eines von --baud, --parity, --address erwartet"
                );
                return Err(Failure::new(Class::Usage, "usage.nothing_to_set", message)
                    .hint(both!("for example `line set --baud 57600`", "zum Beispiel `line set --baud 57600`")));
            }
            move_drive(wish, context).await
        }
    }
}

/// The settings of the line as they are stored in every drive that was named.
pub(super) async fn show(context: &mut Context<'_>) -> Result<Outcome, Failure> {
    // On a bus that is the place on it, not the line at its serial plug (EM-RES-03 manual 5.4, 5.5, 5.9.4).
    let what: &[&str] = if context.settings.is_can() { &["900", "903", "921-923"] } else { &["@line"] };
    let params = what.iter().map(|word| (*word).to_owned()).collect();
    read::run(&read::Args { params, kind: None, decimals: None, slave: SlaveArgs::default() }, context).await
}

/// Moves one drive to what is wished for.
pub(super) async fn move_drive(wish: Wish, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let addresses = addresses_to_write(context.settings)?;
    let [address] = addresses[..] else {
        let message = both!(
            "expected one address: drives are moved one by one",
            "erwartet: eine Adresse; Antriebe werden einzeln umgestellt"
        );
        return Err(one_of(Failure::new(Class::Usage, "usage.one_address", message), &addresses));
    };
    if address == 0 {
        let message = both!(
            "address 0 is everybody: drives are moved one by one",
            "Adresse 0 meint alle: Antriebe werden einzeln umgestellt"
        );
        return Err(Failure::new(Class::Usage, "usage.one_address", message).hint(super::name_one()));
    }
    let families = match &context.settings.drive {
        Some(name) => vec![super::named_family(context.settings, context.registry, name)?],
        None => context.registry.families().filter(|family| family.link.is_asked_on_a_line()).collect(),
    };
    wish.check(&families, context.settings.protocol)?;
    if context.settings.dry_run {
        let family = offline_family(context.settings, context.registry)?;
        let orders = relocate::orders(&wish, context.settings.protocol, &family);
        let mut outcome = plan(context, &family, &orders)?;
        if let Some(Data::Plan(plan)) = &mut outcome.data {
            plan.notes.push(both!(
                "before them the stored settings are read, and whether somebody answers at the new place already; \
                 after each the drive is looked for where it can be. What stands there already is not written",
                "davor werden die gespeicherten Einstellungen gelesen, und ob am neuen Ort schon jemand antwortet; \
                 nach jedem wird der Antrieb gesucht, wo er sein kann. Was schon so steht, wird nicht geschrieben"
            ));
        }
        return Ok(outcome);
    }
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    gate::somebody(*ask).map_err(denied)?;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let mut target = target_to_change(&mut session, settings, registry, address).await?;
    let course = relocate::course(&mut session, &mut target, &wish).await?;
    if course.is_done() {
        return Ok(Outcome::of(Data::Relocation(course.told(&target))));
    }
    course.check_free(&mut session, &mut target).await?;
    let permit = super::asking::on_line(&mut session, *ask, &question(&course)).await?;
    let (relocation, failure) = course.go(&mut session, &mut target, &permit).await;
    Ok(Outcome { data: Some(Data::Relocation(relocation)), warnings: Vec::new(), failure })
}

fn question(course: &Course) -> Question {
    let mut hazards = vec![Hazard::Write, Hazard::Wear, Hazard::Line];
    hazards.extend(course.restarts().then_some(Hazard::Reset));
    let title = both!("move the drive to other line settings", "die Leitung des Antriebs umstellen");
    let mut details = course.details();
    details.push(both!(
        "LINE: the line follows the drive; if it does not answer there, everything is put back as far as it \
             answers here",
        "LEITUNG: die Leitung folgt dem Antrieb; antwortet er dort nicht, wird alles zurückgestellt, solange er \
             hier antwortet"
    ));
    Question { hazards, title, details }
}
