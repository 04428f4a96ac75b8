//! Steps that ask a drive who it is, how its line is, and what it does when nobody talks to it.

use super::guide::{Deed, Guide, Turn};
use crate::command::{identify, terms};
use crate::drive::motion::{watchdog_raw, watchdog_seconds, watchdog_words};
use crate::drive::{Reader, check_line, job};
use crate::failure::{Class, Failure};
use crate::outcome::{Answered, Identity, LinkTest, Stored, Value};
use crate::profile::value::{format_decimal, written};
use crate::profile::{Family, Role};
use crate::text::{Text, both};

/// Questions of the link test.
const COUNT: u64 = 100;

impl Guide<'_> {
    /// Asks who answers, and how its line is set.
    pub(super) async fn identify(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        self.tell(turn);
        let (identity, failures) = self.who().await?;
        let Some(target) = &self.target else { return Ok(()) };
        let (address, family) = (target.address, target.family.clone());
        let one = self.session.demand_one_drive(address);
        one.map_err(|error| error.failure(address, Some(&family)))?;
        self.record.answered = Some(answered(&identity));
        let product = identity.product.unwrap_or_default();
        let title = identity.title;
        deed.found.push(if product.is_empty() {
            title
        } else {
            both!("{title}: {product}", "{title}: {product}", title)
        });
        deed.found
            .extend(identity.values.iter().filter(|value| value.error.is_none()).map(|value| shown(value, &family)));
        deed.found
            .extend(identity.modules.iter().filter(|module| module.present).map(|module| Text::name(&module.name)));
        self.fits_its_limits().await?;
        failures.into_iter().next().map_or(Ok(()), Err)
    }

    /// What the drive at the address tells of itself; it must be one for which the steps so far were.
    async fn who(&mut self) -> Result<(Identity, Vec<Failure>), Failure> {
        self.allow();
        let terms = terms(self.settings, self.registry)?;
        let mut known = terms.recognised(&mut self.session, self.record.address, false).await?;
        self.meets(&known.target)?;
        let (identity, failures, _) = identify::told(&mut self.session, self.registry, &mut known).await?;
        self.target = Some(known.target);
        Ok((identity, failures))
    }

    /// Whoever goes on with a record asks again who answers: what was proven of one drive is no proof of another at its address, and
    /// nothing of the one is written into the other.
    pub(super) async fn meets_again(&mut self) -> Result<(), Failure> {
        let Some(before) = self.record.answered.clone() else { return Ok(()) };
        let (identity, _) = self.who().await?;
        let now = answered(&identity);
        let mut other = Vec::new();
        if let (Some(before), Some(now)) = (&before.product, &now.product)
            && before != now
        {
            other.push(both!("it is {now} (was {before})", "es ist {now} (war {before})"));
        }
        if before.modules != now.modules {
            let [before, now] = [before.modules, now.modules].map(|modules| match modules.is_empty() {
                true => "-".to_owned(),
                false => modules.join(", "),
            });
            other.push(both!("option modules: {now} (were: {before})", "Optionsmodule: {now} (waren: {before})"));
        }
        if other.is_empty() {
            // Only of the same make: another one may not know a parameter that was stored.
            other.extend(self.stands_as_stored().await?);
        }
        if other.is_empty() { Ok(()) } else { Err(another(&Text::join(&other, ", "))) }
    }

    /// What its steps had stored and stands otherwise now.
    async fn stands_as_stored(&mut self) -> Result<Vec<Text>, Failure> {
        let mut target = self.known().await?;
        self.allow();
        let mut other = Vec::new();
        for Stored { param, data_set, raw } in self.record.stored.clone() {
            let param = target.family.param_or_unknown(param);
            let told = target.read_set(&mut self.session, &param, data_set).await;
            let now = told.map_err(|error| error.failure(target.address, Some(&target.family)))?.raw;
            if now != raw {
                let (label, now, before) = (param.label(), written(&param, now), written(&param, raw));
                other.push(both!(
                    "{label}@{data_set} is {now} (was written: {before})",
                    "{label}@{data_set} ist {now} (geschrieben wurde {before})"
                ));
            }
        }
        Ok(other)
    }

    /// Measures the line.
    pub(super) async fn line(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        self.tell(turn);
        self.allow();
        let target = self.known().await?;
        let (check, failures) = check_line(&mut self.session, vec![target], &[], COUNT).await;
        let test = check.drives.iter().find_map(|drive| drive.test.as_ref());
        deed.found.extend(test.map(measured));
        deed.found.extend(check.advice.iter().map(|advice| advice.text.clone()));
        if let Some(failure) = failures.into_iter().next() {
            return Err(failure);
        }
        let is_fine = test.is_some_and(|test| test.replies == test.asked && test.strays == 0 && test.garbled == 0);
        if is_fine {
            return Ok(());
        }
        let message = both!(
            "the line is not good enough: questions were not answered, or not rightly and once",
            "die Leitung ist nicht gut genug: Fragen blieben unbeantwortet oder wurden nicht richtig und genau einmal beantwortet"
        );
        let hint = both!(
            "check termination, shield and GND; `antrieb diag line` measures it again",
            "Abschluss, Schirm und GND prüfen; `antrieb diag line` misst noch einmal"
        );
        Err(Failure::new(Class::No, "no.line", message).hint(hint))
    }

    /// Looks at the drive's own watchdog, and sets it if a time was given.
    pub(super) async fn watchdog(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let mut target = self.known().await?;
        let family = target.family.clone();
        match (self.given.span("watchdog")?, family.role(Role::Watchdog)) {
            (Some(span), Some(param)) => {
                let raw = watchdog_raw(&family, span)?;
                let step = job::Step { param: param.clone(), set: 0, raw, kind: param.kind, at: None };
                self.write(turn, deed, vec![step]).await?;
            }
            _ => self.tell(turn),
        }
        self.allow();
        let mut reader = Reader::new(&mut self.session, &mut target);
        let value = reader.in_force(Role::Watchdog).await?.value;
        let (failures, _) = reader.into_failures();
        let raw = value.as_ref().and_then(|value| value.raw);
        deed.found.push(watchdog_words(&family, raw.map(|raw| watchdog_seconds(&family, raw))));
        failures.into_iter().next().map_or(Ok(()), Err)
    }
}

/// What of it does not change.
fn answered(identity: &Identity) -> Answered {
    let modules = identity.modules.iter().filter(|module| module.present).map(|module| module.name.clone());
    Answered { product: identity.product.clone(), modules: modules.collect() }
}

fn another(told: &Text) -> Failure {
    let message = both!(
        "this is not the drive of the record, or somebody has changed it since: {told}; nothing was sent that writes",
        "das ist nicht der Antrieb der Aufzeichnung, oder jemand hat ihn seitdem geändert: {told}; es wurde nichts geschrieben",
        told
    );
    Failure::new(Class::Data, "data.other_drive", message).hint(both!(
        "see which drive answers at this address; where the values were changed, set them as the record has them; --force begins anew \
         with what answers, --record names another record",
        "nachsehen, welcher Antrieb unter dieser Adresse antwortet; wurden Werte geändert, sie wie in der Aufzeichnung stellen; --force \
         beginnt mit dem, der antwortet, von vorn; --record nennt eine andere Aufzeichnung"
    ))
}

/// A value in a line.
pub(super) fn shown(value: &Value, family: &Family) -> Text {
    let number = match (value.value, value.raw) {
        (Some(number), _) => format_decimal(number.raw, number.decimals),
        (None, Some(raw)) => raw.to_string(),
        (None, None) => "-".to_owned(),
    };
    let unit = value.unit.as_ref().map_or_else(String::new, |unit| format!(" {unit}"));
    let meaning = value.text.as_ref().map_or_else(Text::default, |text| both!(" ({text})", " ({text})", text));
    let (param, name) = (family.param_or_unknown(value.param).label(), &value.name);
    both!("{param} {name}: {number}{unit}{meaning}", "{param} {name}: {number}{unit}{meaning}", name, meaning)
}

fn measured(test: &LinkTest) -> Text {
    let median = test.median_us.map_or_else(|| "-".to_owned(), |us| format_decimal(us as i64, 3));
    let LinkTest { asked, replies, silent, garbled, strays, .. } = test;
    both!(
        "{replies} of {asked} answered, {silent} silent, {garbled} garbled, {strays} strays, median {median} ms",
        "{replies} von {asked} beantwortet, {silent} stumm, {garbled} gestört, {strays} fremde, Median {median} ms"
    )
}
