//! What a device tells of itself: code 43 (V1.1b3 6.21).

use super::{Inquest, missing, said, told};
use crate::drive::access::AccessError;
use crate::drive::route::no;
use crate::exchange::{ExchangeError, Limits, Said};
use crate::protocol::modbus::pdu::{Identification, Reply, Request, identification};
use crate::text::{Text, both};

impl Inquest<'_, '_> {
    /// Code 43, once, before anything else: tells the drive if the answer comes. If none comes, nothing is noted, because
    /// [`Inquest::identification`] asks again where it matters. Whether nothing came at all.
    pub(super) async fn introduction(&mut self) -> Result<bool, AccessError> {
        let once = Limits { retries: 0, ..self.session.limits() };
        let answer = self.session.ask_within(self.route.address, describe_yourself(identification::VENDOR_NAME), once);
        let answer = said(answer.await)?;
        let is_silent = matches!(answer, Err(ExchangeError::Silence { .. }));
        if let Ok(Said::Modbus(Reply::Identification(first))) = answer {
            let told = self.rest_of(first).await?;
            self.described(&told);
        }
        Ok(is_silent)
    }

    /// Asks the device for its own description, code 43: the family whose product code it begins with. A lost reply is
    /// asked for again, and a garbled one tells nothing: neither makes a stranger of a drive.
    pub(super) async fn identification(&mut self) -> Result<(), AccessError> {
        let answered = match self.ask_for(identification::VENDOR_NAME).await? {
            Ok(Said::Modbus(Reply::Identification(first))) => {
                let told = self.rest_of(first).await?;
                self.described(&told);
                return Ok(());
            }
            Ok(said) => no(&said).map_or_else(|| Text::name("-"), told),
            Err(error @ ExchangeError::Silence { .. }) => missing(&error),
            Err(error) => return Err(AccessError::Exchange(error)),
        };
        let tells = both!("does not describe itself", "beschreibt sich nicht");
        self.finding.note(asked_for_itself(), answered, tells);
        Ok(())
    }

    /// What the description tells.
    fn described(&mut self, described: &Identification) {
        let product = text(described, identification::PRODUCT_CODE);
        let mut families = self.registry.families();
        let family = families
            .find(|family| family.link.product.as_ref().is_some_and(|start| product.starts_with(start.as_str())));
        let tells = match &family {
            Some(family) => family.title.clone(),
            None => both!("a product that we do not know", "ein Produkt, das wir nicht kennen"),
        };
        let objects = described.objects.iter().filter(|object| !object.value.is_empty());
        let words: Vec<_> = objects.map(|object| String::from_utf8_lossy(&object.value)).collect();
        let mut answered = Text::name(if words.is_empty() { "-".to_owned() } else { words.join(", ") });
        if described.next.is_some() {
            answered = both!(
                "{answered} … (cut off: it says again and again that more follows)",
                "{answered} … (abgebrochen: es meldet immer wieder, dass noch etwas folgt)",
                answered
            );
        }
        self.finding.note(asked_for_itself(), answered, tells);
        self.finding.drive = family.map(|family| family.drive.clone());
        self.finding.product = Some(product).filter(|product| !product.is_empty());
        self.introduced = true;
    }

    /// What the device tells of itself, in several telegrams if it takes them: every one names a later object to go on
    /// with. Where it would go on without end, `next` stays set.
    async fn rest_of(&mut self, first: Identification) -> Result<Identification, AccessError> {
        let mut described = first;
        let mut asked = identification::VENDOR_NAME;
        for _ in 0..MOST_PIECES {
            let Some(next) = described.next.filter(|next| *next > asked) else { break };
            asked = next;
            match self.ask_for(next).await? {
                Ok(Said::Modbus(Reply::Identification(more))) => {
                    described.next = more.next;
                    described.objects.extend(more.objects);
                }
                // Without its product code nobody knows what it is.
                Err(error) if described.object(identification::PRODUCT_CODE).is_none() => {
                    return Err(AccessError::Exchange(error));
                }
                // What came before the missing piece counts.
                _ => {
                    described.next = None;
                    break;
                }
            }
        }
        Ok(described)
    }

    async fn ask_for(&mut self, object: u8) -> Result<Result<Said, ExchangeError>, AccessError> {
        said(self.session.ask(self.route.address, describe_yourself(object)).await)
    }
}

/// Code 43: asks for the basic objects from this one on.
pub(super) fn describe_yourself(object: u8) -> Request {
    Request::ReadIdentification { category: identification::BASIC, object }
}

/// Telegrams that a description may take behind the first. The basic objects are three (V1.1b3, 6.21), so that each may
/// come alone, with room for a maker's own.
const MOST_PIECES: usize = 8;

fn asked_for_itself() -> Text {
    both!("code 43, identification", "Code 43, Identifikation")
}

fn text(described: &Identification, object: u8) -> String {
    described.object(object).map_or_else(String::new, |value| String::from_utf8_lossy(value).into_owned())
}
