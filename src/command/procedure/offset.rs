//! The offset of a resolver (EM-RES-03 manual 6.4.1): tries that are each a bounded run of `sollwert`, asked with its bounds, coasted to
//! a stop and proven. What a try sets, it sets in RAM and gives back, whatever ends it; the EEPROM is written once, when it is found.

use super::aim::{Aim, Params, current_decimals, run};
use super::guide::{Deed, Guide, Turn};
use super::search::{Look, Next, STEPS, Search, Seen, Trial, Turn as Whole};
use crate::args::StopArg;
use crate::command::sollwert::Led;
use crate::drive::job;
use crate::drive::motion::{Motor, working};
use crate::failure::{Class, Failure};
use crate::gate::Question;
use crate::profile::value::{self, format_decimal};
use crate::profile::{Param, Sets};
use crate::text::{Text, both};
use crate::tick::Span;
use std::cell::Cell;

/// How long a shaft may take to come up: slowly, and to half of its rated frequency.
const COMES_UP: Span = Span::from_secs(10);
const COMES_UP_HALF: Span = Span::from_secs(60);
/// How long a try may take behind that.
const SEARCHES: Span = Span::from_secs(90);
/// The output frequency is above the switch-off limit (CM-485 manual 12.2).
const OVERSPEED: i64 = 0x1100;
/// The try has come to its end.
const SEEN: &str = "seen";
/// It has run away.
const RAN_AWAY: &str = "no.runaway";

/// What is sought with what: the parameters, and what stands in the drive.
struct Hunt {
    params: Params,
    aim: Aim,
    whole: Whole,
    /// The offset that stands in the drive, and its rated frequency.
    stands: i64,
    rated: i64,
    /// The data set of what has four.
    set: u8,
}

/// One try: its look-by-look judge, and what is set for it.
struct Attempt {
    trial: Trial,
    raw: i64,
    patience: Span,
    stop: StopArg,
    settings: Vec<(Param, i64)>,
    told: Vec<Text>,
}

impl Guide<'_> {
    /// Seeks the offset, tries it at half of the rated frequency, and writes it.
    pub(super) async fn offset(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let hunt = self.hunt().await?;
        let found = self.seek(turn, deed, &hunt).await?;
        let attempt = self.half(&hunt, found);
        let (offset, voltage) = match self.attempt(turn, deed, &hunt, attempt).await? {
            Seen::Found(offset, voltage) => (offset, voltage),
            _ => return Err(self.not_found()),
        };
        deed.found.push(told_found(&hunt, hunt.rated / 2, offset, voltage));
        let (param, kind) = (hunt.params.offset.clone(), hunt.params.offset.kind);
        let set = if param.sets == Some(Sets::Four) { hunt.set } else { 0 };
        self.write(turn, deed, vec![job::Step { param, set, raw: offset, kind, at: None }]).await
    }

    /// What is sought with what.
    async fn hunt(&mut self) -> Result<Hunt, Failure> {
        let mut target = self.known().await?;
        let params = Params::of(&target.family)?;
        let aim = Aim::of(self.given, &params)?;
        self.allow();
        let mut read = [0; 6];
        for (param, read) in
            [&params.motor_pairs, &params.resolver_pairs, &params.offset, &params.rated, &params.limit, &params.current]
                .into_iter()
                .zip(&mut read)
        {
            *read = working(&mut self.session, &mut target, param).await?.ok_or_else(|| untold(param))?;
        }
        let [motor_pairs, resolver_pairs, stands, rated, limit, current] = read;
        // Of both no manual prints the decimals, so neither may become more than it is.
        for (param, now, low) in [(&params.limit, limit, aim.limit), (&params.current, current, aim.current)] {
            if now > 0 && low > now {
                return Err(raises(param, now, low));
            }
        }
        let set = self.active_set(&mut target).await?;
        Ok(Hunt { whole: Whole::of(motor_pairs, resolver_pairs), params, aim, stands, rated, set })
    }

    /// Try by try, until the shaft turns and P.235 has come to 0.
    async fn seek(&mut self, turn: Turn<'_>, deed: &mut Deed, hunt: &Hunt) -> Result<i64, Failure> {
        let mut search = Search::new(hunt.stands, hunt.whole);
        for nth in 1..=Search::TRIES {
            let offset = search.offset;
            let seen = self.attempt(turn, deed, hunt, self.slow(hunt, offset, nth)).await?;
            let shown = shown_offset(hunt, offset);
            match search.after(seen) {
                Next::Found(offset, voltage) => {
                    deed.found.push(told_found(hunt, hunt.aim.setpoint, offset, voltage));
                    return Ok(offset);
                }
                Next::GiveUp => break,
                Next::ExchangePhases => {
                    deed.found.push(both!("try {nth}, {shown}: it stands", "Versuch {nth}, {shown}: sie steht"));
                    self.confirm(turn, &exchange_phases(hunt)).await?;
                }
                Next::Try if seen == Seen::Stands => {
                    deed.found.push(both!("try {nth}, {shown}: it stands", "Versuch {nth}, {shown}: sie steht"));
                }
                Next::Try => {
                    deed.found.push(both!(
                        "try {nth}, {shown}: it ran away and was stopped",
                        "Versuch {nth}, {shown}: sie ging durch und wurde angehalten"
                    ));
                    self.after_racing(turn, deed).await?;
                }
            }
        }
        Err(self.not_found())
    }

    /// Acknowledges the fault of a shaft that ran away, if the drive has tripped.
    async fn after_racing(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let tripped = deed.motions.last().and_then(|motion| motion.to.as_ref());
        if !tripped.is_some_and(|state| state.slug.starts_with("fault")) {
            return Ok(());
        }
        let told = both!(
            "The shaft ran away and the drive has tripped. It is acknowledged once, when the 15 s of its lock are over, and tried \
             with another offset. Check the wires of the resolver and their contacts before.",
            "Die Welle ging durch, und der Antrieb hat abgeschaltet. Das wird einmal quittiert, wenn die 15 s der Sperre um sind, und \
             mit einem anderen Offset wiederholt. Vorher die Resolverleitungen und ihre Kontakte prüfen."
        );
        self.acknowledge(turn, deed, vec![told]).await
    }

    /// A slow try, with both limits low.
    fn slow(&self, hunt: &Hunt, offset: i64, nth: u8) -> Attempt {
        let Hunt { params, aim, whole, .. } = hunt;
        let settings = [(&params.limit, aim.limit), (&params.current, aim.current), (&params.offset, offset)];
        let bounds = (aim.setpoint, aim.limit);
        let low = format_decimal(aim.current, current_decimals(params));
        let (of, shown) = (Search::TRIES, shown_offset(hunt, offset));
        let (limit, current) = (params.limit.label(), params.current.label());
        let (limit_raw, current_raw, fast) = (aim.limit, aim.current, frequency(params, aim.limit));
        let told = vec![
            both!(
                "Try {nth} of at most {of}: {shown}. For the try, in RAM: {limit} = {limit_raw} ({fast}), {current} = {current_raw} \
                 ({low} A). No manual prints the decimals of these two; they are taken as those of other frequencies and of P.211.",
                "Versuch {nth} von höchstens {of}: {shown}. Für den Versuch, im RAM: {limit} = {limit_raw} ({fast}), {current} = \
                 {current_raw} ({low} A). Die Nachkommastellen der beiden druckt kein Handbuch; angenommen sind die anderer \
                 Frequenzen und die von P.211."
            ),
            both!(
                "If it turns as it is told, the offset is moved in at most {STEPS} steps while it turns; above {fast} or the wrong way \
                 it is coasted at once.",
                "Dreht sie wie vorgegeben, wird der Offset im Lauf in höchstens {STEPS} Schritten verstellt; über {fast} oder falsch \
                 herum läuft sie sofort frei aus."
            ),
        ];
        Attempt {
            trial: Trial::coarse(offset, *whole, bounds, COMES_UP.as_micros()),
            raw: aim.setpoint,
            patience: COMES_UP,
            stop: StopArg::Coast,
            settings: settings.map(|(param, raw)| (param.clone(), raw)).to_vec(),
            told,
        }
    }

    /// The last one, at half of the rated frequency and with the limits as they stand in the drive.
    fn half(&self, hunt: &Hunt, offset: i64) -> Attempt {
        let raw = hunt.rated / 2;
        let (shown, fast) = (shown_offset(hunt, offset), frequency(&hunt.params, raw));
        let told = both!(
            "Fine adjustment at {fast}, half of the rated frequency, with P.417 and P.728 as they stand in the drive: {shown} is moved in \
             at most {STEPS} steps while it turns.",
            "Feineinstellung bei {fast}, halber Bemessungsfrequenz, mit P.417 und P.728, wie sie im Antrieb stehen: {shown} wird im Lauf \
             in höchstens {STEPS} Schritten verstellt."
        );
        Attempt {
            trial: Trial::fine(offset, hunt.whole, (raw, raw + raw / 5), COMES_UP_HALF.as_micros()),
            raw,
            patience: COMES_UP_HALF,
            stop: StopArg::Ramp,
            settings: vec![(hunt.params.offset.clone(), offset)],
            told: vec![told],
        }
    }

    /// It was not found; what stands otherwise than before is named.
    fn not_found(&self) -> Failure {
        let message = both!("the offset was not found", "der Offset wurde nicht gefunden");
        let left: Vec<Text> = self.record.lent.iter().map(|lent| Text::name(&lent.name)).collect();
        let left = match left.is_empty() {
            true => both!("P.417, P.728 and P.382 are as they were", "P.417, P.728 und P.382 sind, wie sie waren"),
            false => {
                let left = Text::join(&left, ", ");
                both!("NOT as it was: {left}", "NICHT, wie es war: {left}", left)
            }
        };
        Failure::new(Class::No, "no.offset", message).hint(both!(
            "check pole pairs, the wires of the resolver and the load; {left}",
            "Polpaarzahlen, Resolverleitungen und Last prüfen; {left}",
            left
        ))
    }

    /// One run. That the shaft ran away is an answer only where it was stopped and stands.
    async fn attempt(
        &mut self,
        turn: Turn<'_>,
        deed: &mut Deed,
        hunt: &Hunt,
        attempt: Attempt,
    ) -> Result<Seen, Failure> {
        let args = run(attempt.raw, &hunt.params, attempt.stop, self.given)?;
        let details = turn.details().into_iter().chain(attempt.told.clone()).collect();
        let question = Question { hazards: Vec::new(), title: turn.title(), details };
        let seen = Cell::new(None);
        let led = Led { args: &args, question, settings: &attempt.settings, keeps: None };
        let ended = self
            .leads(turn, deed, led, async |motor: &mut Motor<'_, '_>| {
                let come = watch(motor, &hunt.params, &attempt).await?;
                seen.set(Some(come));
                if come == Seen::RunsAway { Err(ran_away()) } else { Ok(()) }
            })
            .await;
        let last = deed.motions.last();
        let stands = last.and_then(|motion| motion.standing) == Some(true);
        let given_back = last.is_some_and(|motion| motion.changed.iter().all(|change| change.restored));
        match (seen.get(), ended) {
            (Some(Seen::RunsAway), Err(failure)) if stands && given_back && is_racing(&failure) => Ok(Seen::RunsAway),
            // Who interrupted its stop wants no other try.
            (Some(Seen::RunsAway), Err(failure)) if self.session.is_interrupted() => {
                Err(Failure { class: Class::Interrupted, code: "interrupted".into(), ..failure })
            }
            (_, Err(failure)) if failure.code == "forbidden.fault" => Err(failure.hint(set_up_first())),
            (_, Err(failure)) => Err(failure),
            (seen, Ok(())) => Ok(seen.unwrap_or(Seen::Unsettled)),
        }
    }
}

fn is_racing(failure: &Failure) -> bool {
    [RAN_AWAY, "forbidden.fault"].contains(&failure.code.as_str())
}

/// Holds the run, looks, and moves the offset, until the try has come to something.
async fn watch(motor: &mut Motor<'_, '_>, params: &Params, attempt: &Attempt) -> Result<Seen, Failure> {
    let Attempt { mut trial, raw, patience, .. } = *attempt;
    let mut come = None;
    let held = motor
        .hold(Some(patience + SEARCHES), async |motor: &mut Motor<'_, '_>, gone| {
            motor.refresh(&params.setpoint, raw).await?;
            motor.adjust(&params.offset, trial.offset()).await?;
            let look = Look {
                stator: motor.told(&params.stator).await?,
                resolver: motor.told(&params.resolver).await?,
                voltage: motor.told(&params.voltage).await?,
            };
            come = trial.see(gone.as_micros(), look);
            if come.is_some() { Err(Failure::new(Class::No, SEEN, Text::default())) } else { Ok(()) }
        })
        .await;
    match (held, come) {
        (_, Some(come)) => Ok(come),
        (Ok(()), None) => Ok(Seen::Unsettled),
        (Err(failure), None) if failure.code == "forbidden.fault" => match motor.look().await?.fault {
            Some(OVERSPEED) => Ok(Seen::RunsAway),
            _ => Err(failure),
        },
        (Err(failure), None) => Err(failure),
    }
}

fn frequency(params: &Params, raw: i64) -> String {
    format!("{} Hz", value::written(&params.setpoint, raw))
}

/// The offset as it is read at the keypad.
fn shown_offset(hunt: &Hunt, raw: i64) -> String {
    let param = &hunt.params.offset;
    format!("{} = {}°", param.label(), format_decimal(raw, param.decimals_or_zero()))
}

fn told_found(hunt: &Hunt, speed: i64, offset: i64, voltage: i64) -> Text {
    let (shown, fast, label) =
        (shown_offset(hunt, offset), frequency(&hunt.params, speed), hunt.params.voltage.label());
    both!(
        "at {fast} it turns as it is told: {shown}, {label} = {voltage}",
        "bei {fast} dreht sie wie vorgegeben: {shown}, {label} = {voltage}"
    )
}

/// What somebody must do whose shaft stands.
fn exchange_phases(hunt: &Hunt) -> Vec<Text> {
    let (motor, resolver) = (hunt.params.motor_pairs.label(), hunt.params.resolver_pairs.label());
    vec![
        both!(
            "The shaft stands, or has only jumped to another place. Check {motor} and {resolver} first. If they are right: switch the \
             inverter off, secure it, wait some minutes until it is dead, and exchange two motor phases (U and V) at the inverter. \
             Then switch it on again.",
            "Die Welle steht oder ist nur in eine andere Lage gesprungen. Zuerst {motor} und {resolver} prüfen. Stimmen sie: den \
             Umrichter ausschalten, sichern, einige Minuten warten, bis er spannungsfrei ist, und zwei Motorphasen (U und V) am \
             Umrichter tauschen. Dann wieder einschalten."
        ),
        both!(
            "WARNING: terminals of mains, DC link and motor stay dangerous behind switching off, until the capacitors are empty.",
            "WARNUNG: Netz-, Zwischenkreis- und Motorklemmen bleiben nach dem Ausschalten gefährlich, bis die Kondensatoren leer sind."
        ),
    ]
}

fn ran_away() -> Failure {
    let message = both!("the shaft ran away", "die Welle ging durch");
    Failure::new(Class::No, RAN_AWAY, message)
}

fn set_up_first() -> Text {
    both!(
        "at an overcurrent or overload run the guided set-up at the keypad first, and confirm the data of motor and resolver; it \
         overwrites P.728",
        "bei Überstrom oder Überlast zuerst die geführte Inbetriebnahme an der Bedieneinheit durchführen und die Daten von Motor und \
         Resolver bestätigen; sie überschreibt P.728"
    )
}

fn untold(param: &Param) -> Failure {
    let label = param.label();
    let message = both!("the drive does not tell {label}", "der Antrieb nennt {label} nicht");
    Failure::new(Class::Data, "data.untold", message).with("param", param.id)
}

fn raises(param: &Param, now: i64, low: i64) -> Failure {
    let label = param.label();
    let message = both!(
        "{label} is {now} and would become {low} for the search: it must only be lowered",
        "{label} ist {now} und würde für die Suche {low}: sie darf nur gesenkt werden"
    );
    Failure::new(Class::Data, "data.value", message).with("param", param.id)
}
