//! What is known of a line and its drives without asking, because somebody said it.

use super::{Session, Target, decode, introduce, recognise};
use crate::failure::{Class, Failure};
use crate::outcome::Evidence;
use crate::profile::{Family, Registry};
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::WordOrder;
use crate::text::{Text, both};
use std::rc::Rc;

/// What somebody said.
#[derive(Clone, Debug)]
pub struct Terms<'a> {
    /// Catalogues.
    pub registry: &'a Registry,
    /// The family of the drives; `None` to ask them.
    pub named: Option<Rc<Family>>,
    /// Which half of a value in two registers goes first; `None` to ask the drive.
    pub word_order: Option<WordOrder>,
    /// Speed and format of the line.
    pub line: LineSetting,
    /// What is spoken.
    pub speech: decode::Reader<'static>,
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
    /// Takes telegrams of this family apart.
    pub fn telegrams<'f>(&self, family: &'f Family) -> decode::Reader<'f> {
        decode::Reader { family: Some(family), ..self.speech }
    }

    /// The family that was named, or the presumed one.
    pub fn usual(&self) -> Option<Rc<Family>> {
        self.named.clone().or_else(|| self.registry.presumed())
    }

    /// The drive at an address: of the family that was named, or asked. `shows_register`: the error register is going to be
    /// read, so asking must not lose it.
    ///
    /// # Errors
    /// Nobody answers, or who answers is no drive that we know.
    pub async fn target(
        &self,
        session: &mut Session<'_>,
        address: u8,
        shows_register: bool,
    ) -> Result<Target, Failure> {
        if let Some(family) = &self.named {
            return Ok(Target::new(address, family.clone()).in_word_order(self.word_order));
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
            let target = Target::new(address, family.clone()).in_word_order(self.word_order);
            let given = Evidence {
                asked: Text::name("--drive"),
                answered: Text::name(&family.drive),
                tells: both!("as given", "so angegeben"),
            };
            return Ok(Recognised { target, evidence: vec![given], product: None });
        }
        let presumed = self.registry.presumed();
        let finding = recognise(session, self.registry, address, shows_register)
            .await
            .map_err(|error| error.failure(address, presumed.as_deref()))?;
        let target = finding.target(address, self.registry);
        let evidence = finding.evidence.clone();
        let recognised = |target: Target| {
            let (target, product) = (target.in_word_order(self.word_order), finding.product.clone());
            Recognised { target, evidence, product }
        };
        target.map(recognised).ok_or_else(|| {
            let row = |row: &Evidence| {
                let Evidence { asked, answered, tells } = row;
                both!("{asked}: {answered} ({tells})", "{asked}: {answered} ({tells})", asked, answered, tells)
            };
            let told: Vec<Text> = finding.evidence.iter().map(row).collect();
            unknown(address, finding.busy, &Text::join(&told, "; "))
        })
    }
}

impl Terms<'_> {
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
        let usual = self.registry.presumed();
        let tells_nothing =
            family.link.product.is_none() && usual.as_ref().is_none_or(|usual| usual.family != family.family);
        let is_believed = |failure: &Failure| match failure.code.as_str() {
            "data.unknown_drive" => tells_nothing || self.named.is_some(),
            "refused.busy" => self.named.is_some(),
            _ => false,
        };
        match asking.recognised(session, address, false).await {
            Err(failure) if is_believed(&failure) => {
                let target = Target::new(address, family.clone()).in_word_order(self.word_order);
                Ok(Recognised { target, evidence: Vec::new(), product: None })
            }
            told => told,
        }
    }
}

/// Who answers is no drive that we know, or has no time to say so.
fn unknown(address: u8, busy: bool, told: &Text) -> Failure {
    let failure = match busy {
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
    let behind = if node == 0 { String::new() } else { format!(".{node}") };
    both!("drive {address}{behind} ({drive})", "Antrieb {address}{behind} ({drive})")
}
