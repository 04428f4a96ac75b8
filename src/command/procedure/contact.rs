//! Steps that ask a drive who it is, how its line is, and what it does when nobody talks to it.

use super::guide::{Deed, Guide, Turn};
use crate::command::{identify, terms};
use crate::drive::motion::{watchdog_raw, watchdog_seconds, watchdog_words};
use crate::drive::{Reader, check_line, job};
use crate::failure::{Class, Failure};
use crate::outcome::{LinkTest, Value};
use crate::profile::value::format_decimal;
use crate::profile::{Family, Role};
use crate::text::{Text, both};

/// Questions of the link test.
const COUNT: u64 = 100;

impl Guide<'_> {
    /// Asks who answers, and how its line is set.
    pub(super) async fn identify(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        self.tell(turn);
        self.allow();
        let address = self.record.address;
        let terms = terms(self.settings, self.registry)?;
        let mut known = terms.recognised(&mut self.session, address, false).await?;
        self.meets(&known.target)?;
        let told = identify::told(&mut self.session, self.registry, &mut known).await?;
        let (identity, failures, _) = told;
        let one = self.session.demand_one_drive(address);
        one.map_err(|error| error.failure(address, Some(&known.target.family)))?;
        let product = identity.product.unwrap_or_default();
        let title = identity.title;
        deed.found.push(if product.is_empty() {
            title
        } else {
            both!("{title}: {product}", "{title}: {product}", title)
        });
        let family = &known.target.family;
        deed.found
            .extend(identity.values.iter().filter(|value| value.error.is_none()).map(|value| shown(value, family)));
        deed.found
            .extend(identity.modules.iter().filter(|module| module.present).map(|module| Text::name(&module.name)));
        self.target = Some(known.target);
        failures.into_iter().next().map_or(Ok(()), Err)
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
