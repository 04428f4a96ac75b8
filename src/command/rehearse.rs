//! `--dry-run` of what moves a drive: every telegram of the run in its order, as far as it can be told without asking
//! anybody. What depends on answers is shown for the usual case, and the notes say on which.

use super::telegram_reader;
use crate::args::{MotionArgs, Settings, StopArg};
use crate::drive::motion::watchdog_raw;
use crate::drive::{Cell, Inquiry, decode};
use crate::failure::Failure;
use crate::outcome::{Data, Outcome, Plan, TelegramDoc};
use crate::profile::{DataSets, DriveState, Facts, Family, Param, Sets, Type, value};
use crate::text::{Text, both};

/// A run that is only told.
pub(super) struct Rehearsal<'r> {
    reader: decode::Reader<'r>,
    family: &'r Family,
    address: u8,
    plan: Plan,
    /// What was changed for the run and is given back, by name.
    changed: Vec<String>,
}

/// Where a walk begins that nobody can look up.
const FROM: &str = "switch-on-disabled";
/// The active data set that is taken where nobody can be asked.
const ACTIVE_SET: u8 = 1;

impl<'r> Rehearsal<'r> {
    /// Begins with what every run reads first.
    pub(super) fn new(settings: &Settings, family: &'r Family, address: u8) -> Self {
        let mut told = Self::empty(settings, family, address);
        told.looks();
        told
    }

    /// Begins with a command that only takes motion away: it goes out before anything is read that it does not need.
    pub(super) fn stopping(settings: &Settings, family: &'r Family, address: u8, slug: &str) -> Self {
        let mut told = Self::empty(settings, family, address);
        if let (Some(control), true) = (family.motion.control, slug == "disable") {
            family.role("control-word").into_iter().for_each(|param| told.read(param, 0));
            if let Some(param) = family.role("control-mode") {
                let (label, contacts) = (param.label(), control.contacts);
                told.note(both!(
                    "where that word lacks a bit of disable {label} decides: with {contacts} only the start contacts \
                     open; where neither is told in time the quick stop goes out in place of disable",
                    "fehlt diesem Wort ein Bit des Sperrens, entscheidet {label}: bei {contacts} öffnen nur die \
                     Startkontakte; wird beides nicht rechtzeitig gesagt, geht der Schnellhalt statt des Sperrens \
                     hinaus"
                ));
            }
        }
        if let (Some(command), Some(param)) = (family.machine.command(slug), family.role("control-word")) {
            told.write(param, 0, command.word.into());
        }
        told.goes_first();
        told.looks_at_the_stop();
        told
    }

    /// Begins with a setpoint of zero, which goes out before anything is read that it does not need.
    pub(super) fn zeroing(settings: &Settings, family: &'r Family, address: u8, zero: &Param, is_added: bool) -> Self {
        let mut told = Self::empty(settings, family, address);
        let roles = if is_added { ["setpoint-internal", "setpoint-bus"] } else { ["mode-active", ""] };
        roles.into_iter().filter_map(|role| family.role(role)).for_each(|param| told.read(param, 0));
        if is_added {
            told.note(both!(
                "it goes out at once unless the internal setpoint has the other sign, which would then be left \
                 alone; with none, only the first is read",
                "sie geht sofort hinaus, außer der interne Sollwert hat das andere Vorzeichen und bliebe dann allein \
                 übrig; ist er 0, wird nur er gelesen"
            ));
        }
        told.write(zero, 0, 0);
        told.goes_first();
        told.looks();
        told
    }

    fn goes_first(&mut self) {
        self.note(both!(
            "what takes motion away goes out first, up to five times until it is acknowledged; then the drive is \
             looked at and the word goes out that fits its state",
            "was Bewegung wegnimmt, geht zuerst hinaus, bis zu fünfmal, bis es bestätigt ist; dann wird der Antrieb \
             angesehen, und das Wort geht hinaus, das zu seinem Zustand passt"
        ));
        if self.family.role("word-order").is_some() {
            self.note(both!(
                "where nobody names the word order, a word that is not 0 goes out in both",
                "wo niemand die Wortfolge nennt, geht ein Wort, das nicht 0 ist, in beiden hinaus"
            ));
        }
    }

    fn empty(settings: &Settings, family: &'r Family, address: u8) -> Self {
        let reader = telegram_reader(settings, family);
        let plan = Plan { dry_run: true, telegrams: Vec::new(), notes: Vec::new() };
        let mut told = Rehearsal { reader, family, address, plan, changed: Vec::new() };
        if settings.drive.is_none() {
            told.note(both!(
                "taken for '{drive}': without --drive the drive is recognised first (code 43, P.411, code 100)",
                "angenommen ist '{drive}': ohne --drive wird der Antrieb zuerst erkannt (Code 43, P.411, Code 100)",
                drive = family.drive
            ));
        }
        told
    }

    /// What is read to prove a stop, and to know what the control word is.
    fn looks_at_the_stop(&mut self) {
        let family = self.family;
        for role in ["status-word", "active-set", "control-mode"] {
            if let Some(param) = family.role(role).filter(|_| role == "status-word" || family.motion.control.is_some())
            {
                let set = if role == "control-mode" { self.ram(param) } else { 0 };
                self.read(param, set);
            }
        }
    }

    /// What every run reads first.
    fn looks(&mut self) {
        let family = self.family;
        let told = self;
        let interlocks = family.motion.interlocks.iter().filter_map(|row| row.setting.as_ref());
        let settings: Vec<_> = interlocks.map(|setting| setting.role.as_str()).collect();
        for role in ["status-word", "watchdog", "active-set", "control-mode", "fault", "digital-inputs"]
            .into_iter()
            .chain(settings)
        {
            if let Some(param) = family.role(role) {
                let set = if role == "control-mode" { told.ram(param) } else { 0 };
                told.read(param, set);
            }
        }
        told.note(both!(
            "a reply that does not come is asked for again; behind it a harmless question (code 8, counter 11) may \
             part old from new replies",
            "bleibt eine Antwort aus, wird noch einmal gefragt; danach trennt eine harmlose Frage (Code 8, Zähler \
             11) alte von neuen Antworten"
        ));
    }

    fn note(&mut self, text: Text) {
        self.plan.notes.push(text);
    }

    fn ask(&mut self, inquiry: Inquiry) {
        self.plan.telegrams.extend(self.reader.question(self.address, inquiry));
    }

    /// The data set on the wire in which a setting is changed for a run.
    fn ram(&self, param: &Param) -> u8 {
        let set = if param.sets == Some(Sets::Four) { ACTIVE_SET } else { 0 };
        if self.family.link.route.has_data_sets() { set + DataSets::RAM_OFFSET } else { 0 }
    }

    pub(super) fn read(&mut self, param: &Param, set: u8) {
        self.ask(Inquiry::Read(Cell { number: param.id, set }, param.kind.unwrap_or(Type::Word)));
    }

    /// A write; in a run it is proven by what the drive does, not by reading it back.
    pub(super) fn write(&mut self, param: &Param, set: u8, raw: i64) {
        let kind = param.kind.unwrap_or(Type::Long);
        let Ok(bits) = value::to_wire(raw, self.family.link.route.carried(kind)) else { return };
        let cell = Cell { number: param.id, set };
        self.ask(Inquiry::Write(cell, kind, bits));
    }

    /// A setting that is changed for the run, in RAM, and given back at its end.
    pub(super) fn change(&mut self, param: &Param, raw: i64) {
        let set = self.ram(param);
        self.read(param, set);
        self.write(param, set, raw);
        self.changed.push(param.label());
        if param.sets == Some(Sets::Four) {
            let label = param.label();
            self.note(both!(
                "{label} goes to RAM of the active data set; here of set {ACTIVE_SET}, P.249 tells which",
                "{label} geht in das RAM des aktiven Datensatzes; hier Satz {ACTIVE_SET}, P.249 sagt welcher"
            ));
        }
    }

    /// A setpoint that stands there afterwards as before.
    pub(super) fn given_back(&mut self, param: &Param) {
        self.read(param, 0);
        self.changed.push(param.label());
    }

    /// What the options set before anything moves.
    pub(super) fn bounds(&mut self, motion: &MotionArgs, needs_control: bool) -> Result<(), Failure> {
        let family = self.family;
        if let (Some(span), Some(param)) = (motion.watchdog, family.role("watchdog")) {
            self.change(param, watchdog_raw(family, span)?);
        }
        let control = family.motion.control.filter(|_| motion.take_control && needs_control);
        if let (Some(control), Some(param)) = (control, family.role("control-mode")) {
            self.change(param, control.obeys);
        }
        Ok(())
    }

    /// A control word, and the look that proves what it did.
    pub(super) fn control(&mut self, word: u16) {
        if let Some(param) = self.family.role("control-word") {
            self.write(param, 0, word.into());
        }
        if let Some(param) = self.family.role("status-word") {
            self.read(param, 0);
        }
    }

    pub(super) fn command(&mut self, slug: &str) {
        let Some(command) = self.family.machine.command(slug) else { return };
        if command.edge {
            self.control(command.word & !command.mask);
        }
        self.control(command.word);
        if command.edge {
            self.control(command.word & !command.mask);
        }
    }

    /// The way to a state.
    pub(super) fn walk(&mut self, goal: &str) {
        let family = self.family;
        let begin = family.motion.begin.as_ref().filter(|_| goal == "operation-enabled");
        begin.into_iter().for_each(|slug| self.command(slug));
        let way = family.machine.plan(FROM, goal, &Facts::default()).unwrap_or_default();
        way.iter().filter_map(|transition| transition.command.as_ref()).for_each(|slug| self.command(slug));
        let from = family.states.iter().find(|row| row.slug == FROM).map_or_else(|| Text::name(FROM), DriveState::text);
        self.note(both!(
            "the control words are those from '{from}' on; from another state it is another way",
            "die Steuerwörter gelten ab '{from}'; von einem anderen Zustand aus ist der Weg ein anderer",
            from
        ));
    }

    /// The end: of a held run the stop; then what is given back, or stays. `stops`: nothing runs on behind it, held or not.
    pub(super) fn end(&mut self, motion: &MotionArgs, zeroed: Option<&Param>, stops: bool) {
        let family = self.family;
        let slug = match motion.on_exit {
            StopArg::Ramp => "ramp",
            StopArg::QuickStop => "quick-stop",
            StopArg::Coast => "coast",
            StopArg::Keep => "keep",
        };
        if motion.hold {
            self.note(both!(
                "--hold: until the stop the status word is read and the setpoint given again and again",
                "--hold: bis zum Halt wird immer wieder das Statuswort gelesen und der Sollwert gegeben"
            ));
            let row = family.motion.stop(slug);
            let other = row.and_then(|row| row.otherwise.as_ref()).filter(|_| zeroed.is_none());
            let row = other.and_then(|slug| family.motion.stop(slug)).or(row);
            if let (Some(param), true) = (zeroed, row.is_some_and(|row| row.zero)) {
                self.write(param, 0, 0);
            }
            row.iter().flat_map(|row| &row.commands).for_each(|slug| self.command(slug));
        }
        let gives_back = stops || motion.ends_in_a_stop();
        if gives_back && family.motion.control.is_some() && motion.take_control {
            // So that no contact closes when control goes back.
            self.control(0);
        }
        let changed = std::mem::take(&mut self.changed).join(", ");
        if !changed.is_empty() {
            self.note(match gives_back {
                true => both!(
                    "at the end what was read before is written back: {changed}",
                    "am Ende wird zurückgeschrieben, was zuvor gelesen wurde: {changed}"
                ),
                false => both!("what is changed stays so: {changed}", "was geändert wird, bleibt so: {changed}"),
            });
        }
    }

    /// What goes to each of several drives, told as one.
    pub(super) fn of_all(settings: &Settings, plans: Vec<Plan>) -> Outcome {
        let mut plans = plans.into_iter();
        let Some(mut plan) = plans.next() else { return Outcome::default() };
        plan.telegrams.extend(plans.flat_map(|other| other.telegrams));
        if !settings.lines.is_empty() {
            let each = settings.lines.iter().map(|line| {
                let addresses = line.addresses.named().iter().map(u8::to_string).collect::<Vec<_>>().join(", ");
                let port = line.port.as_ref().map_or_else(|| "-".to_owned(), ToString::to_string);
                format!("{port} ({addresses})")
            });
            let each = each.collect::<Vec<_>>().join(", ");
            plan.notes.push(both!(
                "the lines hear it side by side, here one behind the other: {each}",
                "die Leitungen hören es nebeneinander, hier steht eine nach der anderen: {each}"
            ));
        }
        Outcome::of(Data::Plan(plan))
    }

    pub(super) fn planned(self) -> Plan {
        self.plan
    }

    pub(super) fn telegrams(self) -> Vec<TelegramDoc> {
        self.plan.telegrams
    }

    pub(super) fn told(self) -> Outcome {
        Outcome::of(Data::Plan(self.plan))
    }
}
