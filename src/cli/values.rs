//! What could stand in each place, for completion: from the catalogues, the project file, and the ports of this machine.

use crate::args::{Environment, Globals, Settings, named_drives, named_groups, ports_there};
use crate::command::VERBS;
use crate::command::profibus::PRESUMED;
use crate::profile::procedure::Procedure;
use crate::profile::{Family, Param, Registry, Sets, fold};
use crate::text::Lang;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::rc::Rc;

/// Where something is typed.
#[derive(Debug)]
pub(super) struct Place<'w> {
    /// Behind which verb; nothing before it.
    pub(super) verb: String,
    /// Which argument.
    pub(super) value: String,
    /// What the argument itself says that it can be.
    pub(super) possible: Vec<String>,
    /// What of it is typed.
    pub(super) word: &'w str,
    /// What was typed before it that is no option.
    pub(super) row: Vec<&'w str>,
    /// Options that were typed, by their names.
    pub(super) said: BTreeMap<String, Vec<&'w str>>,
    /// Whether a file can stand there.
    pub(super) file: bool,
}

/// A candidate, and what it is.
type Candidate = (String, String);

/// What fits, in a useful order, nothing twice.
pub(super) fn fitting(place: &Place<'_>, environment: &Environment) -> Vec<Candidate> {
    let globals = place.globals();
    let mut found = match (place.verb.as_str(), place.value.as_str()) {
        (_, "port") => ports(),
        (_, "address") => addresses(place, &globals, environment),
        ("procedure", "name" | "values") => of_procedures(place, lang_of(&globals, environment)),
        ("dataset", "set") => "1 2 3 4 0".split(' ').map(bare).collect(),
        ("dataset", "from" | "to") => "1 2 3 4".split(' ').map(bare).collect(),
        ("schema" | "man", "verb") => VERBS.iter().map(|verb| bare(verb.name)).collect(),
        (_, name) => match WORDS.iter().find(|row| row.0 == name) {
            Some((_, words)) => words.split(' ').map(bare).collect(),
            None if !place.possible.is_empty() => place.possible.iter().map(|word| bare(word)).collect(),
            None => of_catalogues(place, &globals, environment),
        },
    };
    let typed = place.word.to_lowercase();
    found.retain(|(value, _)| value.to_lowercase().starts_with(&typed));
    let mut seen = std::collections::BTreeSet::new();
    found.retain(|(value, _)| seen.insert(value.clone()));
    found
}

/// Arguments whose values are words that no catalogue changes.
const WORDS: &[(&str, &str)] = &[
    ("baud", "auto 2400 4800 9600 19200 38400 57600 115200"),
    ("new_baud", "2400 4800 9600 19200 38400 57600 115200"),
    ("parity", "auto even odd none"),
    ("new_parity", "even odd none"),
    ("stop_bits", "1 2"),
    ("data_bits", "7 8"),
    ("protocol", "auto rtu ascii vabus mbtcp sdo sdo1 dp"),
    ("to", "rtu ascii vabus"),
    ("rs485", "auto kernel rts adapter"),
    ("format", "table json ndjson csv"),
    ("lang", "en de"),
    ("kind", "uint int word long"),
    ("start", "absolute relative"),
    ("state", "switch-on-disabled ready-to-switch-on switched-on operation-enabled quick-stop-active"),
    ("contacts", "S1IND S2IND S3IND S4IND S5IND S6IND MFI1D EM-S1IND EM-S2IND EM-S3IND"),
];

fn bare(word: &str) -> Candidate {
    (word.to_owned(), String::new())
}

impl Place<'_> {
    /// The options of every verb that matter here.
    fn globals(&self) -> Globals {
        let last = |option: &str| self.said.get(option).and_then(|said| said.last()).map(|&text| text.to_owned());
        let files = self.said.get("catalogue").into_iter().flatten().map(PathBuf::from).collect();
        Globals {
            address: last("address"),
            drive: last("drive"),
            protocol: last("protocol"),
            lang: last("lang").and_then(|lang| lang.parse().ok()),
            config: last("config").map(PathBuf::from),
            catalogue: files,
            ..Globals::default()
        }
    }
}

fn ports() -> Vec<Candidate> {
    let there = ports_there().into_iter();
    there.chain([("sim".to_owned(), "the built-in bench".to_owned())]).collect()
}

/// The language in which something is said of candidates.
fn lang_of(globals: &Globals, environment: &Environment) -> Lang {
    Settings::resolve(globals, environment).map_or(Lang::En, |settings| settings.lang)
}

/// Guided work, or, behind its name, what it must know; what is known of that (`power=`) knows only who types.
fn of_procedures(place: &Place<'_>, lang: Lang) -> Vec<Candidate> {
    let all = Procedure::all();
    if place.value == "name" {
        let names = all.into_iter().map(|one| (one.slug, one.title.get(lang).to_owned()));
        return names.chain([("list".to_owned(), String::new())]).collect();
    }
    let named = all.into_iter().find(|one| place.row.first() == Some(&one.slug.as_str()));
    let is_said = |key: &str| place.row.iter().any(|word| word.split_once('=').is_some_and(|(said, _)| said == key));
    let named = named.filter(|_| !place.word.contains('='));
    let wanted = named.into_iter().flat_map(|one| one.values).filter(|value| !is_said(&value.key));
    wanted.map(|value| (format!("{}=", value.key), value.what.get(lang).to_owned())).collect()
}

/// The drives and groups of the project file; behind a comma another one.
fn addresses(place: &Place<'_>, globals: &Globals, environment: &Environment) -> Vec<Candidate> {
    let before = place.word.rfind(',').map_or("", |comma| place.word.get(..=comma).unwrap_or_default());
    let drives = named_drives(globals, environment).into_iter().map(|(name, address)| (name, address.to_string()));
    let is_said = |name: &str| before.split(',').any(|said| said == name);
    let all = drives.chain(named_groups(globals, environment)).filter(|(name, _)| !is_said(name));
    all.map(|(name, about)| (format!("{before}{name}"), about)).collect()
}

fn of_catalogues(place: &Place<'_>, globals: &Globals, environment: &Environment) -> Vec<Candidate> {
    let settings = Settings::resolve(globals, environment).ok();
    let files = settings.as_ref().map_or(&[][..], |settings| &settings.catalogues);
    let Ok(registry) = Registry::open(files).or_else(|_| Registry::open(&[])) else { return Vec::new() };
    if place.value == "drive" {
        let drives = registry.drives().into_iter().map(|drive| (drive.id, drive.title));
        let lang = settings.map_or(Lang::En, |settings| settings.lang);
        return [bare("auto")].into_iter().chain(drives.map(|(id, title)| (id, title.get(lang).to_owned()))).collect();
    }
    // Over PROFIBUS the same family is presumed as there.
    let presumed = settings.as_ref().and_then(|settings| settings.profibus.then(|| PRESUMED.to_owned()));
    let (lang, drive) = settings.map_or((Lang::En, None), |settings| (settings.lang, settings.drive));
    let named = drive.or_else(|| globals.drive.clone()).or(presumed).and_then(|drive| registry.family(&drive));
    let families = named.map_or_else(|| registry.families().collect(), |family| vec![family]);
    families.iter().flat_map(|family| of_family(place, family, lang)).collect()
}

fn of_family(place: &Place<'_>, family: &Rc<Family>, lang: Lang) -> Vec<Candidate> {
    match place.value.as_str() {
        "mode" if place.verb == "sollwert" => family.modes.iter().map(|mode| bare(&mode.slug)).collect(),
        "params" => parameters(place.word, family, lang, &|param| param.access.reads()),
        "fault_code" => {
            // A range of codes is called by its letters (`F17nn`), which is none of them.
            let single = family.faults.iter().filter(|row| row.last.is_none());
            single.map(|row| (row.key.clone(), row.text().get(lang).to_owned())).collect()
        }
        "search" => parameters(place.word, family, lang, &|_| true),
        "only" | "except" => listed(place.word, family, lang),
        "assignments" | "options" => match (place.word.split_once('='), open(&place.row)) {
            (Some((name, begun)), _) => values(&format!("{name}="), name, begun, family, lang),
            // The space form: the value behind its parameter.
            (None, Some(name)) if place.value == "assignments" => values("", name, place.word, family, lang),
            (None, _) => {
                let names = parameters(place.word, family, lang, &|param| param.access.writes());
                let names = names.into_iter().filter(|(name, _)| !name.starts_with('@'));
                names.map(|(name, about)| (format!("{name}="), about)).collect()
            }
        },
        _ => Vec::new(),
    }
}

/// Groups and parameters; behind a comma another one.
fn listed(word: &str, family: &Family, lang: Lang) -> Vec<Candidate> {
    let (before, word) = word.rsplit_once(',').map_or(("", word), |(before, word)| (before, word));
    let head = if before.is_empty() { String::new() } else { format!("{before},") };
    let names = parameters(word, family, lang, &|param| param.access.writes());
    names.into_iter().map(|(name, about)| (format!("{head}{}", name.trim_start_matches('@')), about)).collect()
}

/// Parameters by slug, short name or number; behind an `@` the data sets, or the groups.
fn parameters(word: &str, family: &Family, lang: Lang, fits: &dyn Fn(&Param) -> bool) -> Vec<Candidate> {
    if let Some((name, _)) = word.rsplit_once('@').filter(|(name, _)| !name.is_empty()) {
        let four = name.starts_with('@') || find(name, family).is_none_or(|param| param.sets != Some(Sets::One));
        let sets = if four { "0 1 2 3 4 all ram 1ram 2ram 3ram 4ram allram" } else { "0 ram" };
        return sets.split(' ').map(|set| bare(&format!("{name}@{set}"))).collect();
    }
    let params = || family.params.values().filter(|param| fits(param));
    if word.starts_with(|letter: char| letter.is_ascii_digit()) {
        let numbers = params().map(|param| (param.id.to_string(), param.name(lang).to_owned()));
        return with_typed(word, numbers.collect());
    }
    let groups = family.group_names().map(|group| bare(&format!("@{group}")));
    let names = params().flat_map(|param| {
        let about = format!("{} {}", param.id, param.name(lang));
        let local = localized(param, word, family, lang);
        let names = [Some(param.slug.clone()), param.short.clone(), local];
        names.into_iter().flatten().map(move |name| (name, about.clone()))
    });
    groups.chain(names).collect()
}

/// What is typed of a number stands among those that begin with it, so that no shell makes another number of it.
fn with_typed(word: &str, mut numbers: Vec<Candidate>) -> Vec<Candidate> {
    numbers.retain(|(number, _)| number.starts_with(word));
    if numbers.len() > 1 || numbers.iter().any(|(number, _)| number != word) {
        numbers.insert(0, bare(word));
    }
    numbers
}

/// The name in the language of the person, where that begins as it is typed and means nothing else.
fn localized(param: &Param, word: &str, family: &Family, lang: Lang) -> Option<String> {
    let name = fold(param.name(lang)).replace(' ', "-");
    let begun = lang != Lang::En && !word.is_empty() && name.starts_with(&word.to_lowercase());
    (begun && family.find(&name).is_ok_and(|found| found.id == param.id)).then_some(name)
}

/// The named values of a parameter, as they can be typed.
fn values(head: &str, name: &str, begun: &str, family: &Family, lang: Lang) -> Vec<Candidate> {
    let name = name.rsplit_once('@').map_or(name, |(name, _)| name);
    let Some(param) = find(name, family) else { return Vec::new() };
    let choices = family.choices(param).into_iter().map(|(raw, [en, de])| (raw, lang.pick(en, de).to_owned()));
    let choices: Vec<_> = choices.map(|(raw, text)| (raw, fold(&text).replace(' ', "-"), text)).collect();
    let told = |value: &str, raw: i64, text: &str| (format!("{head}{value}"), format!("{raw} = {text}"));
    let is_word = |name: &str| name.starts_with(|letter: char| letter.is_alphabetic());
    let names = choices.iter().filter(|(_, name, _)| is_word(name)).map(|(raw, name, text)| told(name, *raw, text));
    // Between names that begin alike a shell would type their beginning: a value that nobody chose.
    let numbers = choices.iter().filter(|_| begun.is_empty()).map(|(raw, _, text)| told(&raw.to_string(), *raw, text));
    names.chain(numbers).collect()
}

/// The parameter whose value comes next, where both are words of their own.
fn open<'r>(row: &[&'r str]) -> Option<&'r str> {
    row.iter().fold(None, |open, word| if open.is_some() || word.contains('=') { None } else { Some(word) })
}

fn find<'f>(name: &str, family: &'f Family) -> Option<&'f Param> {
    match name.parse() {
        Ok(number) => family.param(number),
        Err(_) => family.find(name).ok(),
    }
}
