//! From the project file to open lines with their drives.

use crate::args::{Place, Settings, places, project_path, typed_ports};
use crate::command::dataset::load::read_all;
use crate::command::dataset::opened::Opened;
use crate::command::lines::{named, one_recording};
use crate::command::{Context, named_family, open};
use crate::drive::job::Step;
use crate::drive::plant::{Line, Member};
use crate::drive::transaction::{Choice, UndoPlace};
use crate::drive::{Interrupt, Port, Terms, open_port};
use crate::failure::{Class, Failure};
use crate::gate::Ask;
use crate::outcome::{Event, NotLoaded, Warning, addressed};
use crate::profile::Registry;
use crate::text::{Text, both};
use futures_util::future::join_all;
use std::cell::RefCell;

/// A drive, and what its parameter files want.
#[derive(Debug)]
pub(in crate::command) struct Wanted {
    pub(in crate::command) place: Place,
    /// Who says so.
    pub(in crate::command) said: Said,
    /// What its files say, later ones over earlier ones.
    pub(in crate::command) opened: Opened,
    pub(in crate::command) steps: Vec<Step>,
    pub(in crate::command) left_out: Vec<NotLoaded>,
    pub(in crate::command) undo: UndoPlace,
    /// Why it cannot have all of it.
    pub(in crate::command) unsettled: Option<Failure>,
}

/// Who says what a drive shall have.
#[derive(Debug)]
pub(in crate::command) enum Said {
    /// This project file.
    Project(String),
    /// This plan of a system bus.
    Plan(String),
    /// Whoever typed drive and files.
    Typed,
}

impl Wanted {
    /// What is typed behind `-a` for it.
    pub(super) fn typed(&self) -> String {
        match self.said {
            Said::Plan(_) if !self.place.settings.typed.names_address() => {
                addressed(self.place.address, self.place.settings.node)
            }
            _ => self.place.name.clone(),
        }
    }

    pub(super) fn files(&self) -> Vec<String> {
        self.place.files.iter().map(|file| file.display().to_string()).collect()
    }

    /// Its port as it is told.
    pub(super) fn port(&self) -> String {
        self.place.settings.port.as_ref().map_or_else(|| "-".to_owned(), ToString::to_string)
    }

    /// What is odd about its files.
    pub(super) fn doubts(&self) -> Vec<Warning> {
        self.opened.doubts((self.place.address, self.place.settings.node))
    }

    fn member<'a>(&self, registry: &'a Registry) -> Result<Member<'a>, Failure> {
        let terms = terms(&self.place.settings, registry)?;
        Ok(Member {
            name: self.place.name.clone(),
            address: self.place.address,
            family: self.opened.family.clone(),
            family_at: self.opened.file.family_at.clone(),
            product: self.place.product.clone(),
            terms,
            steps: self.steps.clone(),
            undo: self.undo.clone(),
            lang: self.place.settings.lang,
            elsewhere: self.elsewhere(),
            another: self.another(),
            found: None,
            left: None,
            applied: None,
        })
    }

    /// What a drive shall have is this, now that it was seen.
    pub(super) fn gives(&self, member: &mut Member<'_>) {
        member.steps.clone_from(&self.steps);
    }

    /// What to do where its undo file cannot be left.
    fn elsewhere(&self) -> Text {
        match self.said {
            Said::Project(_) => both!(
                "the undo files of a plant go beside its project file, so that folder must take new files",
                "die Dateien zum Zurücknehmen kommen neben die Projektdatei, also muss dieser Ordner neue Dateien annehmen"
            ),
            Said::Plan(_) => both!(
                "the undo files go beside the plan, so that folder must take new files",
                "die Dateien zum Zurücknehmen kommen neben den Plan, also muss dieser Ordner neue Dateien annehmen"
            ),
            Said::Typed => both!("--undo-file names another place", "--undo-file nennt einen anderen Ort"),
        }
    }

    /// What to do where another drive stands at its address.
    fn another(&self) -> Text {
        match self.said {
            Said::Project(_) => both!(
                "if this drive is meant, say so in the project file; else look for the right one with `antrieb scan`",
                "ist dieser Antrieb gemeint, es in der Projektdatei sagen; sonst den richtigen mit `antrieb scan` suchen"
            ),
            Said::Plan(_) => both!(
                "look for the right one with `antrieb scan`; --drive says of which family the drives of the plan are",
                "den richtigen mit `antrieb scan` suchen; --drive sagt, von welcher Familie die Antriebe des Plans sind"
            ),
            Said::Typed => both!(
                "take a file that was saved from such a drive, or leave this one out",
                "eine Datei nehmen, die von einem solchen Antrieb gesichert wurde, oder diesen weglassen"
            ),
        }
    }
}

/// Beside the project file the undo file of a drive is left, under its name.
fn undo(place: &Place) -> UndoPlace {
    UndoPlace::Beside(project_path(&place.settings).with_file_name(format!("{}.toml", plain(&place.name))))
}

/// The name of a drive as one of a file.
pub(in crate::command) fn plain(name: &str) -> String {
    let is_plain = |letter: char| letter.is_alphanumeric() || matches!(letter, '-' | '_' | ' ');
    name.chars().map(|letter| if is_plain(letter) { letter } else { '_' }).collect()
}

/// What is known of a drive without asking. What the project file says of its family is asked all the same: it may be another drive.
pub(super) fn terms<'a>(settings: &Settings, registry: &'a Registry) -> Result<Terms<'a>, Failure> {
    let drive = settings.named_drive().map(ToOwned::to_owned);
    crate::command::terms(&Settings { drive, ..settings.clone() }, registry)
}

/// The drives that are meant, with all that their files say; line by line. Nothing is opened.
pub(super) fn wanted(context: &mut Context<'_>, choice: &Choice) -> Result<Vec<Wanted>, Failure> {
    let Context { settings, registry, observe, .. } = context;
    let (mut files, mut wanted) = (Vec::new(), Vec::new());
    let (placed, bare): (Vec<Place>, Vec<Place>) =
        places(settings)?.into_iter().partition(|place| !place.files.is_empty());
    if let Some(note) = without_files(&bare) {
        if placed.is_empty() {
            return Err(no_files(settings, note));
        }
        observe(Event::Note(note));
    }
    for mut place in placed {
        if place.settings.port.is_none() {
            let port = open_port(None, *observe)?;
            place.settings = Settings { port: Some(port.clone()), ports: vec![port], ..place.settings };
        }
        place.settings.check_one_line()?;
        place.settings.verbose = settings.verbose;
        let opened = read_all(&place.files, &place.settings, registry)?;
        is_of_files(&place.settings, &opened, registry)?;
        files.push((place, opened));
    }
    let families = files.iter().map(|(_, opened)| opened.family.clone()).collect();
    let choice = Choice { families, ..choice.clone() };
    for (place, opened) in files {
        let (steps, left_out) = choice.steps(&opened.settings, &opened.family)?;
        let (said, undo) = (Said::Project(project_path(settings).display().to_string()), undo(&place));
        wanted.push(Wanted { place, said, opened, steps, left_out, undo, unsettled: None });
    }
    by_line(settings, &mut wanted)?;
    let typed = typed_ports(settings)?;
    if !typed.is_empty() {
        let ports = typed.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        observe(Event::Note(both!("only the drives at {ports}", "nur die Antriebe an {ports}")));
    }
    Ok(wanted)
}

/// Puts those together that are on one line, and refuses what does not do for several.
pub(in crate::command) fn by_line(settings: &Settings, wanted: &mut [Wanted]) -> Result<(), Failure> {
    let mut lines: Vec<Option<String>> = Vec::new();
    for one in wanted.iter() {
        let line = one.place.line();
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    one_recording(settings, lines.len())?;
    wanted.sort_by_key(|one| lines.iter().position(|line| *line == one.place.line()));
    Ok(())
}

/// The family that the project file states must be one that there is, and that of the parameter files.
fn is_of_files(settings: &Settings, opened: &Opened, registry: &Registry) -> Result<(), Failure> {
    let Some(name) = settings.drive.as_deref().filter(|_| settings.named_drive().is_none()) else { return Ok(()) };
    let stated = named_family(settings, registry, name)?;
    let (own, at) = (&opened.family.drive, &opened.file.family_at);
    if stated.drive == *own {
        return Ok(());
    }
    let why = both!(
        "'{name}' is stated, and {at} is for the family '{own}'",
        "angegeben ist '{name}', und {at} ist für die Familie '{own}'"
    );
    let hint = both!(
        "one of both is wrong: state '{own}', or take a file that was saved from such a drive",
        "eines von beiden stimmt nicht: '{own}' angeben, oder eine Datei nehmen, die von einem solchen Antrieb gesichert wurde"
    );
    let in_file = settings.wrong_in_file("drive", &why);
    Err(in_file.unwrap_or_else(|| Failure::new(Class::Data, "data.other_family", why)).hint(hint))
}

/// The drives for which nothing is to be done.
fn without_files(bare: &[Place]) -> Option<Text> {
    let names = bare.iter().map(|place| place.name.as_str()).collect::<Vec<_>>().join(", ");
    (!bare.is_empty()).then(|| {
        both!("no parameter files, and not looked at: {names}", "ohne Parameterdateien und nicht angesehen: {names}")
    })
}

fn no_files(settings: &Settings, note: Text) -> Failure {
    let project = project_path(settings);
    let message = both!("{file}: {note}", "{file}: {note}", file = project.display(), note);
    Failure::new(Class::Data, "data.no_files", message).hint(both!(
        "say which it shall have: `files = [\"pump.toml\"]` in its `[drives.NAME]`; `antrieb dataset save` writes one",
        "sagen, welche er haben soll: `files = [\"pump.toml\"]` in `[drives.NAME]`; `antrieb dataset save` schreibt eine"
    ))
}

/// Opens the lines of these drives, all at once, and works on them. The lines stand in the order of the drives.
pub(in crate::command) async fn on_lines<R>(
    context: &mut Context<'_>,
    wanted: Vec<Wanted>,
    work: impl AsyncFnOnce(&mut [Line<'_>], Vec<Wanted>, &mut dyn Ask) -> R,
) -> Result<R, Failure> {
    let Context { registry, interrupt, observe, ask, .. } = context;
    let groups: Vec<&[Wanted]> = wanted.chunk_by(|one, other| one.place.line() == other.place.line()).collect();
    let (several, observe, registry) = (groups.len() > 1, RefCell::new(observe), *registry);
    let interrupt = &*interrupt;
    let mut opening = Vec::new();
    for group in groups {
        let members = group.iter().map(|one| one.member(registry)).collect::<Result<Vec<_>, _>>()?;
        let settings = group.first().map(|one| one.place.settings.clone());
        if let Some((settings, port)) = settings.and_then(|settings| Some((settings.clone(), settings.port?))) {
            let (name, observe) = (port.to_string(), &observe);
            let tell = move |event| (observe.borrow_mut())(if several { named(&name, event) } else { event });
            opening.push((settings, port, members, tell));
        }
    }
    let opened = opening.iter_mut().map(|(settings, port, members, tell)| {
        let members = std::mem::take(members);
        async move { line(port, settings, members, (registry, interrupt), tell).await }
    });
    let mut lines = join_all(opened).await;
    Ok(work(&mut lines, wanted, *ask).await)
}

/// Why nothing of a file goes over a line of PROFIBUS.
fn unspoken() -> Failure {
    let message = both!(
        "the files of a plant do not go over PROFIBUS-DP yet",
        "die Dateien einer Anlage gehen noch nicht über PROFIBUS-DP"
    );
    Failure::new(Class::Usage, "usage.profibus", message).hint(both!(
        "one slave at a time they do: `antrieb -a NAME dataset load FILE`, and `dataset check FILE`",
        "ein Slave nach dem anderen schon: `antrieb -a NAME dataset load DATEI` und `dataset check DATEI`"
    ))
}

/// A line, open if it can be opened.
async fn line<'a>(
    port: &Port,
    settings: &Settings,
    mut members: Vec<Member<'a>>,
    (registry, interrupt): (&'a Registry, &Interrupt),
    tell: &'a mut dyn FnMut(Event),
) -> Line<'a> {
    let session = match settings.profibus {
        true => Err(unspoken()),
        false => open(port, settings, registry, interrupt, tell).await,
    };
    if let Err(failure) = &session {
        members.iter_mut().for_each(|member| member.left = Some(failure.clone()));
    }
    Line { session: session.ok(), members }
}
