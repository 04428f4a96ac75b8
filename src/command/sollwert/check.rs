//! Holding a setpoint against what the drive says.

use super::Args;
use super::wanted::Wanted;
use crate::drive::motion::{Situation, no_control, role_raw, working};
use crate::drive::{Session, Target};
use crate::failure::{Class, Failure};
use crate::outcome::Event;
use crate::profile::value::check_range;
use crate::profile::{Lang, Param, setpoint};

/// Holds a setpoint against what the drive says, before anybody is asked.
pub(super) struct Check<'c, 's> {
    pub(super) args: &'c Args,
    pub(super) session: &'c mut Session<'s>,
    pub(super) target: &'c mut Target,
    pub(super) before: &'c Situation,
    pub(super) lang: Lang,
}

impl Check<'_, '_> {
    pub(super) async fn run(
        &mut self,
        mut wanted: Wanted,
        enable: bool,
        needs_control: bool,
    ) -> Result<Wanted, Failure> {
        if needs_control && let Some(failure) = no_control(self.before, self.target, self.lang) {
            return Err(failure);
        }
        if wanted.start.is_some() && !enable && self.before.state != "operation-enabled" {
            let text =
                self.lang.pick("the drive is not enabled, so nothing can start", "der Antrieb ist nicht freigegeben");
            let hint = self.lang.pick("add --enable", "--enable angeben");
            return Err(Failure::new(Class::Forbidden, "forbidden.not_enabled", text).hint(hint));
        }
        if wanted.by_speed {
            let pairs = self.pole_pairs().await?;
            wanted.schedule = wanted.schedule.map(|raw| setpoint::frequency_of_speed(raw, pairs));
            wanted.by_speed = false;
        }
        for raw in wanted.schedule.values().filter(|_| !self.args.force) {
            check_range(raw, &wanted.param).map_err(|error| {
                Failure::new(Class::Data, "data.range", format!("{}: {error}", wanted.param.label()))
                    .with("param", wanted.param.id)
            })?;
        }
        let source = self.source(&wanted).await?;
        self.limit(&wanted).await?;
        self.floor(&wanted, source).await?;
        Ok(wanted)
    }

    async fn pole_pairs(&mut self) -> Result<i64, Failure> {
        let pairs = role_raw(self.session, self.target, "pole-pairs", self.lang).await?;
        pairs.filter(|&pairs| pairs > 0).ok_or_else(|| {
            let label = self.target.family.role("pole-pairs").map_or_else(|| "-".to_owned(), Param::label);
            let text = match self.lang {
                Lang::En => format!("the drive does not tell its pole pairs ({label})"),
                Lang::De => format!("der Antrieb nennt seine Polpaarzahl ({label}) nicht"),
            };
            Failure::new(Class::Data, "data.pole_pairs", text)
                .hint(self.lang.pick("give the setpoint in Hz", "den Sollwert in Hz angeben"))
        })
    }

    /// What the drive works with, or will in this run; refused if the setpoint is ignored then.
    async fn source(&mut self, wanted: &Wanted) -> Result<Option<i64>, Failure> {
        let Some(source) = &wanted.mode.source else { return Ok(None) };
        let present = self.will_be(source.param, wanted).await?;
        if present != Some(source.ignored) {
            return Ok(present);
        }
        let ways: Vec<_> = source.choices.iter().map(|row| format!("--source {} ({})", row.slug, row.value)).collect();
        let (or, sets) =
            self.lang.pick(("or", "sets it in RAM for the run"), ("oder", "stellt es für den Lauf im RAM um"));
        let hint = format!("{} {sets}", ways.join(&format!(" {or} ")));
        Err(Failure::new(Class::Forbidden, "forbidden.ramp_setpoint", source.why.get(self.lang)).hint(hint))
    }

    async fn limit(&mut self, wanted: &Wanted) -> Result<(), Failure> {
        let Some(id) = wanted.mode.limit.filter(|_| !self.args.force) else { return Ok(()) };
        let (param, peak) = (self.target.family.param_or_unknown(id), wanted.schedule.peak());
        let Some(limit) = self.will_be(id, wanted).await?.filter(|&limit| peak > limit) else { return Ok(()) };
        let family = &self.target.family;
        let (peak, limit) = (wanted.shown(peak, family, self.lang), wanted.shown(limit, family, self.lang));
        let (name, label) = (param.name(self.lang), param.label());
        let text = match self.lang {
            Lang::En => format!("{peak} is above the limit {label} = {limit} ({name})"),
            Lang::De => format!("{peak} liegt über der Grenze {label} = {limit} ({name})"),
        };
        let hint =
            self.lang.pick("--force sends it; the drive limits it", "--force sendet ihn; der Antrieb begrenzt ihn");
        Err(Failure::new(Class::Data, "data.range", text).hint(hint))
    }

    async fn floor(&mut self, wanted: &Wanted, source: Option<i64>) -> Result<(), Failure> {
        let Some(floor) = wanted.mode.floor.as_ref().filter(|floor| source == Some(floor.source)) else {
            return Ok(());
        };
        let Some(least) = self.will_be(floor.param, wanted).await?.filter(|&least| least > 0) else { return Ok(()) };
        if wanted.schedule.values().any(|raw| raw.abs() < least) {
            let least = wanted.shown(least, &self.target.family, self.lang);
            self.session.tell(Event::Note(floor.why.get(self.lang).replace("{}", &least)));
        }
        Ok(())
    }

    /// The value that a parameter will have in this run.
    async fn will_be(&mut self, id: u32, wanted: &Wanted) -> Result<Option<i64>, Failure> {
        if let Some((_, raw)) = wanted.settings.iter().find(|(param, _)| param.id == id) {
            return Ok(Some(*raw));
        }
        let param = self.target.family.param_or_unknown(id);
        working(self.session, self.target, &param, self.lang).await
    }
}
