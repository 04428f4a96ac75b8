//! Steps before the offset of a resolver is sought: the data of the motor, its pole pairs, and the way in which the resolver counts.

use super::aim::{Aim, Params};
use super::contact::shown;
use super::guide::{Deed, Guide, Turn};
use crate::drive::motion::{has_power, look, working};
use crate::drive::{Reader, Target, job};
use crate::failure::{Class, Failure};
use crate::profile::{DataSets, Param, Role, Sets};
use crate::text::{Text, both};
use crate::tick::Span;

/// How long somebody may take to turn the shaft, how often it is looked at, and how often in a row it must be the same way.
const BY_HAND: Span = Span::from_secs(60);
const LOOKS: Span = Span::from_millis(500);
const IN_A_ROW: u8 = 3;
/// P.766: the resolver tells the actual speed (EM-RES-03 manual 6.4.2).
pub(super) const ENCODER_2: i64 = 2;
/// What is known of the motor.
const MOTOR: [&str; 5] = ["configuration", "rated-speed", "pole-pairs", "rated-frequency", "rated-mechanical-power"];

impl Guide<'_> {
    /// Shows the data of the motor as they stand in the drive, and asks whether they are those of its nameplate.
    pub(super) async fn motor(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let mut target = self.known().await?;
        self.allow();
        let family = target.family.clone();
        let mut reader = Reader::new(&mut self.session, &mut target);
        let mut rows = Vec::new();
        for slug in MOTOR {
            let Some(param) = family.params.values().find(|param| param.slug == slug) else { continue };
            rows.extend(reader.rows(param, DataSets::Unnamed).await?);
        }
        deed.found.extend(rows.iter().map(|value| shown(value, &family)));
        self.session.end_at(None);
        self.confirm(turn, &deed.found.clone()).await
    }

    /// Writes the pole pairs of the resolver, which must divide those of the motor, and makes it tell the actual speed.
    pub(super) async fn resolver(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let mut target = self.known().await?;
        self.allow();
        let params = Params::of(&target.family)?;
        let aim = Aim::of(self.given, &params)?;
        let motor = working(&mut self.session, &mut target, &params.motor_pairs).await?.unwrap_or(0);
        let (pairs, label) = (aim.resolver_pairs, params.motor_pairs.label());
        if motor < 1 || motor % pairs != 0 {
            let message = both!(
                "{label} = {motor} pole pairs of the motor are no whole multiple of the {pairs} of the resolver",
                "{label} = {motor} Polpaare des Motors sind kein ganzes Vielfaches der {pairs} des Resolvers"
            );
            return Err(Failure::new(Class::Data, "data.pole_pairs", message).hint(both!(
                "the ratio must be whole (EM-RES-03 manual 6.4): check both on nameplate and data sheet",
                "das Verhältnis muss ganzzahlig sein (EM-RES-03-Anleitung 6.4): beide auf Typenschild und Datenblatt prüfen"
            )));
        }
        let active = self.active_set(&mut target).await?;
        let step = |param: &Param, raw| {
            let set = if param.sets == Some(Sets::Four) { active } else { 0 };
            job::Step { param: param.clone(), set, raw, kind: param.kind, at: None }
        };
        let steps = vec![step(&params.resolver_pairs, pairs), step(&params.source, ENCODER_2)];
        self.write(turn, deed, steps).await
    }

    /// The data set in which the drive works.
    pub(super) async fn active_set(&mut self, target: &mut Target) -> Result<u8, Failure> {
        let active = Reader::new(&mut self.session, target).vital_role(Role::ActiveSet).await?;
        Ok(active.and_then(|value| value.raw).and_then(|raw| u8::try_from(raw).ok()).unwrap_or(1).clamp(1, 4))
    }

    /// Somebody turns the shaft clockwise by hand, and the resolver must show that.
    pub(super) async fn hand(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let mut target = self.known().await?;
        self.allow();
        self.is_dead(&mut target).await?;
        self.session.end_at(None);
        self.confirm(turn, &[]).await?;
        let param = Params::of(&target.family)?.resolver;
        let label = param.label();
        self.allow();
        let begun = self.session.now();
        let (mut way, mut row) = (0, 0);
        while self.session.now().since(begun) < BY_HAND {
            let raw = working(&mut self.session, &mut target, &param).await?.unwrap_or(0);
            row = if raw.signum() != 0 && raw.signum() == way { row + 1 } else { 1 };
            way = raw.signum();
            if way != 0 && row >= IN_A_ROW {
                break;
            }
            let rested = self.session.rest(LOOKS).await;
            rested.map_err(|error| error.failure(target.address, Some(&target.family)))?;
        }
        match way {
            1 => {
                deed.found.push(both!(
                    "turned clockwise by hand: {label} is positive",
                    "von Hand rechtsherum: {label} ist positiv"
                ));
                Ok(())
            }
            0 => {
                let message = both!("{label} shows no turning", "{label} zeigt keine Drehung");
                Err(Failure::new(Class::No, "no.turning", message).hint(both!(
                    "turn the shaft by hand while it is watched; check the wires of the resolver",
                    "die Welle von Hand drehen, solange zugesehen wird; die Resolverleitungen prüfen"
                )))
            }
            _ => Err(wrong_way(&label)),
        }
    }

    /// What is done now needs a drive without power.
    pub(super) async fn is_dead(&mut self, target: &mut Target) -> Result<(), Failure> {
        let state = look(&mut self.session, target).await?.state;
        if has_power(&state) == Some(false) {
            return Ok(());
        }
        let message = both!(
            "the drive is not without power (now '{state}')",
            "der Antrieb ist nicht spannungslos am Motor (jetzt '{state}')"
        );
        Err(Failure::new(Class::Forbidden, "forbidden.powered", message).hint(both!(
            "`antrieb statemachine disable-voltage` takes it",
            "`antrieb statemachine disable-voltage` nimmt sie"
        )))
    }
}

fn wrong_way(label: &str) -> Failure {
    let message = both!(
        "clockwise, {label} is negative: the resolver counts the other way round",
        "rechtsherum ist {label} negativ: der Resolver zählt andersherum"
    );
    let hint: Text = both!(
        "with the inverter off and dead exchange SIN+ and SIN- at X410A; for a motor of another maker P.492 = 1 may be meant",
        "bei ausgeschaltetem, spannungsfreiem Umrichter SIN+ und SIN- an X410A tauschen; bei Motoren anderer Hersteller kann \
         P.492 = 1 gemeint sein"
    );
    Failure::new(Class::No, "no.direction", message).hint(hint)
}
