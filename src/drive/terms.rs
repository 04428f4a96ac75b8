//! What is known of a line and its drives without asking, because somebody said it.

use super::{Finding, Session, Target, decode, introduce, recognise};
use crate::failure::{Class, Failure};
use crate::outcome::{Event, Evidence, Warning, addressed};
use crate::profile::{Family, HazardKind, Param, Registry, Role};
use crate::protocol::Protocol;
use crate::protocol::can::SdoChannel;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::WordOrder;
use crate::text::{Text, both};
use std::rc::Rc;

/// What somebody said.
#[derive(Clone, Debug)]
pub struct Terms<'a> {
    /// Catalogues.
    pub registry: &'a Registry,
    /// The family of the drives by who types it (`--drive`), and so knows; `None` to ask them.
    pub named: Option<Rc<Family>>,
    /// What a file says of it: asked all the same, because another drive may stand there by now.
    pub stated: Option<Stated>,
    /// Which half of a value in two registers goes first; `None` to ask the drive.
    pub word_order: Option<WordOrder>,
    /// Speed and format of the line.
    pub line: LineSetting,
    /// What is spoken.
    pub speech: decode::Reader<'static>,
}

/// The role of the address under which a drive is reached with a protocol; a node has another place on its bus than on its serial
/// line.
fn own_address(protocol: Protocol) -> Option<Role> {
    match protocol {
        Protocol::Modbus(_) => Some(Role::Address),
        Protocol::Vabus => Some(Role::NodeId),
        Protocol::Sdo(_) | Protocol::Pkw => None,
    }
}

impl Session<'_> {
    /// The role of the address under which the drives of this line are reached.
    pub fn own_address(&self) -> Option<Role> {
        own_address(self.protocol())
    }
}

/// A family that a file states.
#[derive(Clone, Debug)]
pub struct Stated {
    /// The family.
    pub family: Rc<Family>,
    /// Where that stands.
    pub whence: Text,
    /// A drive of another family is refused, because it is to be written to or moved; otherwise it is told.
    pub refuses: bool,
}

/// The place of a node on the system bus: node, bit rate, the identifiers of SDO1, whether SDO2 is there (EM-RES-03 manual 5.4, 5.5,
/// 5.9.4).
const PLACE_ON_BUS: [u32; 5] = [900, 903, 921, 922, 923];

/// What of a drive can cut it off, by the way that it is asked.
#[derive(Debug, PartialEq)]
struct Cut {
    /// What its catalogue says of its serial plug: P.10, 394, 395, 1375, 1376 (CM-485 manual 11.2).
    plug: bool,
    /// Of its place on the system bus.
    place: &'static [u32],
}

/// Each way to a drive. What does not lie on it is a setting like any other: P.395 of a node settles its own plug, and nothing that is
/// asked over the bus goes there.
fn cut_on(protocol: Protocol, node: u8) -> Cut {
    let (plug, place): (bool, &[u32]) = match protocol {
        Protocol::Modbus(_) | Protocol::Vabus if node == 0 => (true, &[]),
        // The master asks the SDO1 of its nodes as well (EM-RES-03 manual 5.8.4, 5.9.4).
        Protocol::Modbus(_) | Protocol::Vabus | Protocol::Sdo(SdoChannel::One) => (false, &[900, 903, 921, 922]),
        Protocol::Sdo(SdoChannel::Two) => (false, &[900, 903, 923]),
        Protocol::Pkw => (false, &[]),
    };
    Cut { plug, place }
}

/// What of its place on the system bus cuts off a drive that is asked over that bus.
pub fn cut_by(protocol: Protocol) -> &'static [u32] {
    cut_on(protocol, 0).place
}

/// Whether it is of the place of a node on the system bus.
pub(super) fn is_place_on_bus(param: &Param) -> bool {
    PLACE_ON_BUS.contains(&param.id)
}

/// A drive, and what told that it is this one.
#[derive(Debug)]
pub struct Recognised {
    /// The drive.
    pub target: Target,
    /// What it answered that tells its family.
    pub evidence: Vec<Evidence>,
    /// What it calls itself, if it does.
    pub product: Option<String>,
}

impl Terms<'_> {
    /// The role of the address under which the drives are reached.
    pub fn own_address(&self) -> Option<Role> {
        own_address(self.speech.protocol)
    }

    /// Takes telegrams of this family apart.
    pub fn telegrams<'f>(&self, family: &'f Family) -> decode::Reader<'f> {
        decode::Reader { family: Some(family), ..self.speech }
    }

    /// A parameter as it is on this line: what settles a plug or a place that nothing of this goes over is a setting like any other.
    pub fn on_line(&self, family: &Family, param: &Param) -> Param {
        let cut = cut_on(self.speech.protocol, self.speech.node);
        let is_of_bus = is_place_on_bus(param) && family.group("systembus").is_some_and(|bus| bus.contains(&param.id));
        let hazard = match param.hazard {
            _ if is_of_bus => cut.place.contains(&param.id).then_some(HazardKind::Line),
            Some(HazardKind::Line) => cut.plug.then_some(HazardKind::Line),
            other => other,
        };
        Param { hazard, ..param.clone() }
    }

    /// The family that somebody said.
    pub fn said(&self) -> Option<Rc<Family>> {
        self.named.clone().or_else(|| Some(self.stated.as_ref()?.family.clone()))
    }

    /// The same, or the presumed one.
    pub fn usual(&self) -> Option<Rc<Family>> {
        self.said().or_else(|| self.registry.presumed())
    }

    /// The drive at an address: of the family that was named, or asked. `shows_register`: the error register is going to be
    /// read, so asking must not lose it.
    ///
    /// # Errors
    /// Nobody answers, who answers is no drive that we know, or it is to be written to and of another family than stated.
    pub async fn target(
        &self,
        session: &mut Session<'_>,
        address: u8,
        shows_register: bool,
    ) -> Result<Target, Failure> {
        if let Some(family) = &self.named {
            return Ok(self.given(address, family));
        }
        Ok(self.recognised(session, address, shows_register).await?.target)
    }

    /// The same with what told which drive it is.
    ///
    /// # Errors
    /// As [`Terms::target`].
    pub async fn recognised(
        &self,
        session: &mut Session<'_>,
        address: u8,
        shows_register: bool,
    ) -> Result<Recognised, Failure> {
        if let Some(family) = &self.named {
            let given = evidence(Text::name("--drive"), family, both!("as given", "so angegeben"));
            return Ok(Recognised { target: self.given(address, family), evidence: vec![given], product: None });
        }
        let told = self.inquired(session, address, shows_register).await?;
        told.map_err(|finding| unknown(address, &finding))
    }

    /// What a drive is by what it answers, whoever has named it; what it said instead if that is no drive that we know.
    ///
    /// # Errors
    /// As [`Terms::target`], but for drives that we do not know.
    pub async fn inquired(
        &self,
        session: &mut Session<'_>,
        address: u8,
        shows_register: bool,
    ) -> Result<Result<Recognised, Finding>, Failure> {
        let presumed = self.registry.presumed();
        let mut finding = recognise(session, self.registry, address, shows_register)
            .await
            .map_err(|error| error.failure(address, presumed.as_deref()))?;
        let target = match (finding.target(address, self.registry), &self.stated) {
            (Some(target), stated) => {
                let other = stated.as_ref().filter(|stated| stated.family.drive != target.family.drive);
                other.map_or(Ok(()), |stated| stated.is_contradicted(session, &target))?;
                target
            }
            (None, Some(stated)) if finding.busy || self.tells_nothing(&stated.family) => {
                let tells =
                    both!("as it stands there; nothing it answers tells", "so steht es dort; keine Antwort sagt es");
                finding.evidence.push(evidence(stated.whence.clone(), &stated.family, tells));
                Target::new(address, stated.family.clone())
            }
            (None, _) => return Ok(Err(finding)),
        };
        let Finding { evidence, product, .. } = finding;
        Ok(Ok(Recognised { target: target.in_word_order(self.word_order), evidence, product }))
    }

    /// A drive that nobody asks what it is.
    fn given(&self, address: u8, family: &Rc<Family>) -> Target {
        Target::new(address, family.clone()).in_word_order(self.word_order)
    }

    /// Whether no question tells a drive of this family.
    fn tells_nothing(&self, family: &Family) -> bool {
        let usual = self.registry.presumed();
        family.link.product.is_none() && usual.is_none_or(|usual| usual.family != family.family)
    }

    /// The drive at an address, asked also where its family was named: a number means another thing in another family, so nobody's
    /// word brings the values of one into a drive that says that it is another. A family that no question can tell is believed,
    /// and so is `--drive` of a drive that tells nothing.
    ///
    /// # Errors
    /// Nobody answers, or who answers is no drive that we know.
    pub async fn asked(
        &self,
        session: &mut Session<'_>,
        address: u8,
        family: &Rc<Family>,
    ) -> Result<Recognised, Failure> {
        let asking = Terms { named: None, ..self.clone() };
        let is_believed = |failure: &Failure| match failure.code.as_str() {
            "data.unknown_drive" => self.tells_nothing(family) || self.named.is_some(),
            "refused.busy" => self.named.is_some(),
            _ => false,
        };
        match asking.recognised(session, address, false).await {
            Err(failure) if is_believed(&failure) => {
                Ok(Recognised { target: self.given(address, family), evidence: Vec::new(), product: None })
            }
            told => told,
        }
    }
}

impl Stated {
    /// Another drive answers than the one of which the file tells.
    fn is_contradicted(&self, session: &mut Session<'_>, found: &Target) -> Result<(), Failure> {
        let Stated { family, whence, refuses } = self;
        let (address, of, found) = (found.address, &family.drive, &found.family.drive);
        if !refuses {
            let message = both!(
                "{whence} says that drive {address} is of the family '{of}'; it answers as '{found}', which is taken",
                "{whence} nennt für Antrieb {address} die Familie '{of}'; er antwortet als '{found}', und so wird er genommen",
                whence
            );
            session.tell(Event::Warned(Warning { code: "drive.other_family".to_owned(), message }));
            return Ok(());
        }
        let message = both!(
            "{whence}: expected a drive of the family '{of}', address {address} is of the family '{found}'; nothing was \
             changed",
            "{whence}: erwartet wird ein Antrieb der Familie '{of}', Adresse {address} ist von der Familie '{found}'; \
             geändert wurde nichts",
            whence
        );
        let hint = both!(
            "if this drive is meant: --drive {found}, and put it into the file; else look for the right one with `antrieb scan`",
            "ist dieser Antrieb gemeint: --drive {found}, und ihn so in die Datei schreiben; sonst den richtigen mit \
             `antrieb scan` suchen"
        );
        Err(Failure::new(Class::Data, "data.other_family", message)
            .hint(hint)
            .with("address", address)
            .of_family(found))
    }
}

/// What tells a family without an answer of the drive.
fn evidence(asked: Text, family: &Family, tells: Text) -> Evidence {
    Evidence { asked, answered: Text::name(&family.drive), tells }
}

/// Who answers is no drive that we know, or has no time to say so.
fn unknown(address: u8, finding: &Finding) -> Failure {
    let row = |row: &Evidence| {
        let Evidence { asked, answered, tells } = row;
        both!("{asked}: {answered} ({tells})", "{asked}: {answered} ({tells})", asked, answered, tells)
    };
    let told = Text::join(&finding.evidence.iter().map(row).collect::<Vec<_>>(), "; ");
    let failure = match finding.busy {
        true => {
            let text = both!(
                "address {address} answers, but is too busy to say what it is",
                "Adresse {address} antwortet, ist aber zu beschäftigt, um zu sagen, was sie ist"
            );
            let hint = both!(
                "{told}; try again later, or name the family with --drive",
                "{told}; später noch einmal versuchen, oder die Familie mit --drive angeben",
                told
            );
            Failure::new(Class::Refused, "refused.busy", text).hint(hint)
        }
        false => {
            let text = both!(
                "address {address} is no drive that we know",
                "unter Adresse {address} antwortet kein bekannter Antrieb"
            );
            let hint = both!(
                "{told}; name the family with --drive if you know better",
                "{told}; ist sie bekannt, die Familie mit --drive angeben",
                told
            );
            Failure::new(Class::Data, "data.unknown_drive", text).hint(hint)
        }
    };
    failure.with("address", address)
}

impl Terms<'_> {
    /// What a drive calls itself. One whose family was named (`--drive`) has not been asked yet.
    ///
    /// # Errors
    /// The session is over.
    pub async fn product(&self, session: &mut Session<'_>, drive: &Recognised) -> Result<Option<String>, Failure> {
        let Recognised { target, product, .. } = drive;
        if product.is_some() || self.named.is_none() {
            return Ok(product.clone());
        }
        let asked = introduce(session, self.registry, target).await;
        let found = asked.map_err(|error| error.failure(target.address, Some(&target.family)))?.unwrap_or_default();
        Ok(found.product)
    }
}

/// Whom a question to the user names: `drive 3 (acu)`; with a node of the system bus behind it `drive 3.17 (acu)`.
pub fn who(address: u8, node: u8, drive: &str) -> Text {
    let at = addressed(address, node);
    both!("drive {at} ({drive})", "Antrieb {at} ({drive})")
}
