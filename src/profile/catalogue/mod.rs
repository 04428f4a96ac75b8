//! The one catalogue format, for what we ship and for what users bring: TOML, one inline table per parameter.
//!
//! A catalogue is refused as a whole, with file, line and column, if it has unknown keys, duplicate ids, control
//! characters, dangling references or limits that do not fit its decimals.

mod format;
mod merge;
mod place;

use super::broken::{Broken, shorten, stumbled};
use super::family::Family;
use crate::text::{Text, both};
use format::{Body, Head, SCHEMA};
use place::{Origin, Position};
use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Largest catalogue that is read at all.
const MAX_FILE: usize = 4 << 20;
/// The word for a drive that is asked what it is.
const AUTO: &str = "auto";
/// The catalogues that we ship: family, and `data/*.toml` as two lines of JSON, which are read in a tenth of the time:
/// the keys of [`Head`], then everything. `UPDATE=1 cargo test --test generated` writes them.
const BUILT_IN: &[(&str, &str)] = &[
    ("active", include_str!("../data/active.ndjson")),
    ("lexium05", include_str!("../data/lexium05.ndjson")),
    ("hitachi", include_str!("../data/hitachi.ndjson")),
];

/// A catalogue of the user: where it stands and what is in it.
#[derive(Clone, Debug)]
pub struct CatalogueFile {
    /// Shown in errors and as the origin of rows.
    pub path: String,
    /// TOML.
    pub text: String,
}

/// Every drive that the catalogues describe.
#[derive(Debug)]
pub struct Registry {
    files: Vec<Catalogue>,
    /// Families that were asked for.
    families: RefCell<BTreeMap<String, Rc<Family>>>,
}

/// A drive's id and title.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DriveTitle {
    /// Word for `--drive` and JSON: `act`.
    pub id: String,
    /// For people.
    pub title: Text,
}

impl Registry {
    /// Reads the shipped catalogues and those of the user, in this order; later files may replace rows of earlier ones.
    pub fn open(user: &[CatalogueFile]) -> Result<Self, Broken> {
        let mut files = Vec::new();
        for (family, text) in BUILT_IN {
            files.push(Catalogue::shipped(family, text)?);
        }
        for file in user {
            let catalogue = Catalogue::read(&file.path, &file.text)?;
            catalogue.may_join(&files)?;
            files.push(catalogue);
        }
        let registry = Registry { files, families: RefCell::default() };
        // The shipped catalogues are proved by our tests; what users bring must be proved now.
        if !user.is_empty() {
            for drive in registry.drives() {
                registry.load(&drive.id)?;
            }
        }
        Ok(registry)
    }

    /// Id and title of every drive, in the order of the catalogues.
    pub fn drives(&self) -> Vec<DriveTitle> {
        let rows = self.files.iter().flat_map(|file| &file.head.drives);
        rows.map(|row| DriveTitle { id: row.id.clone(), title: row.title() }).collect()
    }

    /// Every drive, in the order of the catalogues; each is read when its turn comes.
    pub fn families(&self) -> impl Iterator<Item = Rc<Family>> {
        self.drives().into_iter().filter_map(|drive| self.family(&drive.id))
    }

    /// The drive that a device is taken for as long as nobody knows what it is.
    pub fn presumed(&self) -> Option<Rc<Family>> {
        self.family(self.files.iter().find_map(|file| file.head.presumed.as_deref())?)
    }

    /// What a drive is; `None` if no catalogue describes it.
    pub fn family(&self, drive: &str) -> Option<Rc<Family>> {
        if let Some(known) = self.families.borrow().get(drive) {
            return Some(known.clone());
        }
        let family = Rc::new(self.load(drive).ok().flatten()?);
        self.families.borrow_mut().insert(drive.to_owned(), family.clone());
        Some(family)
    }

    fn load(&self, drive: &str) -> Result<Option<Family>, Broken> {
        let rows = self.files.iter().flat_map(|file| file.head.drives.iter().map(move |row| (file, row)));
        let Some((home, row)) = rows.into_iter().find(|(_, row)| row.id.eq_ignore_ascii_case(drive)) else {
            return Ok(None);
        };
        let title = home.head.title.clone().unwrap_or_else(|| row.title());
        let drive = row.id.as_str();
        let mut family = Family::empty(&home.head.family, drive, title);
        family.siblings = home.head.drives.iter().map(|row| row.id.clone()).collect();
        for file in self.files.iter().filter(|file| file.head.family == home.head.family) {
            file.origin.pour(file.rows()?.into_owned(), &mut family)?;
        }
        family.motion.keep(drive);
        Ok(Some(family))
    }
}

/// One catalogue file.
#[derive(Debug)]
struct Catalogue {
    origin: Origin,
    head: Head,
    rows: Rows,
}

/// The rows of a catalogue.
#[derive(Debug)]
enum Rows {
    /// JSON that is read when the family is asked for.
    Shipped(&'static str),
    Read(Box<Body>),
}

impl Catalogue {
    /// A catalogue of ours; its rows are left for later.
    fn shipped(family: &str, text: &'static str) -> Result<Self, Broken> {
        let origin = Origin::Shipped { path: format!("built-in {family}.toml") };
        let (head, rows) = text.split_once('\n').unwrap_or((text, ""));
        let head = origin.parse(head)?;
        Ok(Catalogue { origin, head, rows: Rows::Shipped(rows) })
    }

    fn read(path: &str, text: &str) -> Result<Self, Broken> {
        let origin = Origin::File { path: path.to_owned(), text: text.to_owned() };
        if text.len() > MAX_FILE {
            let message = both!(
                "{bytes} bytes; a catalogue has at most {MAX_FILE}",
                "{bytes} Byte; ein Katalog hat höchstens {MAX_FILE}",
                bytes = text.len()
            );
            return Err(origin.error(Position::File, message));
        }
        let body: Body = toml::from_str(text).map_err(|error| {
            let (at, why) = stumbled(&error);
            origin.error(Position::Offset(at), why)
        })?;
        if body.schema != SCHEMA {
            let message = both!(
                "schema {schema}; this program reads schema {SCHEMA}",
                "Schema {schema}; dieses Programm liest Schema {SCHEMA}",
                schema = body.schema
            );
            return Err(origin.error(Position::File, message));
        }
        let Body { family, title, presumed, drives, .. } = body.clone();
        let head = Head { family, title, presumed, drives };
        Ok(Catalogue { origin, head, rows: Rows::Read(Box::new(body)) })
    }

    /// Whether a user's catalogue may stand behind those that are there: with rows for a family that is known, or with a
    /// family of its own, which can be read and written, but not moved.
    fn may_join(&self, known: &[Catalogue]) -> Result<(), Broken> {
        let refuse = |message: Text| Err(self.origin.error(Position::File, message));
        let (rows, name) = (self.rows()?, &self.head.family);
        if known.iter().any(|known| known.head.family == *name) {
            return match rows.founding_key() {
                Some(key) => refuse(both!(
                    "{key} stands in the catalogue that brings the family '{name}'",
                    "{key} steht in dem Katalog, der die Familie '{name}' mitbringt"
                )),
                None => Ok(()),
            };
        }
        if rows.link.is_none() || self.head.drives.is_empty() {
            let families: BTreeSet<_> = known.iter().map(|known| known.head.family.as_str()).collect();
            let families = families.into_iter().collect::<Vec<_>>().join(", ");
            return refuse(both!(
                "unknown family '{name}' (expected: {families}; one that is new says in `[link]` how it is reached, and in `drives` what belongs to it)",
                "unbekannte Familie '{name}' (erwartet: {families}; eine neue sagt in `[link]`, wie sie erreicht wird, und in `drives`, was zu ihr gehört)"
            ));
        }
        if let Some(key) = rows.moving_key() {
            return refuse(both!(
                "{key}: a family from a catalogue of one's own can be read and written, not moved",
                "{key}: eine Familie aus einem eigenen Katalog lässt sich lesen und schreiben, nicht bewegen"
            ));
        }
        for row in &self.head.drives {
            [&row.en, &row.de].into_iter().try_for_each(|text| self.origin.check_text(Position::File, text))?;
            if row.id.is_empty() || !row.id.bytes().all(|byte| matches!(byte, b'a'..=b'z' | b'0'..=b'9' | b'-' | b'_'))
            {
                let id = shorten(&row.id);
                return refuse(both!(
                    "the id of a drive is made of a-z, 0-9, - and _; got '{id}'",
                    "die Kennung eines Antriebs besteht aus a-z, 0-9, - und _; dort steht '{id}'"
                ));
            }
        }
        let mut ids: BTreeSet<_> = known.iter().flat_map(|known| &known.head.drives).map(|row| &row.id).collect();
        match self.head.drives.iter().find(|row| row.id == AUTO || !ids.insert(&row.id)) {
            Some(row) => refuse(both!(
                "the id of a drive, '{id}', is taken",
                "die Kennung '{id}' eines Antriebs ist vergeben",
                id = row.id
            )),
            None => Ok(()),
        }
    }

    fn rows(&self) -> Result<Cow<'_, Body>, Broken> {
        match &self.rows {
            Rows::Shipped(json) => self.origin.parse(json).map(Cow::Owned),
            Rows::Read(body) => Ok(Cow::Borrowed(body)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn open(text: &str) -> Result<Registry, Broken> {
        Registry::open(&[CatalogueFile { path: "mine.toml".to_owned(), text: text.to_owned() }])
    }

    fn refused(text: &str) -> String {
        open(text).unwrap_err().to_string()
    }

    const HEAD: &str = "schema = 1\nfamily = \"active\"\n";

    /// What we ship goes through everything that a user's catalogue goes through, and its JSON says the same.
    #[test]
    fn shipped_catalogues_are_proved() {
        let shipped = Registry::open(&[]).unwrap();
        let texts = [
            include_str!("../data/active.toml"),
            include_str!("../data/lexium05.toml"),
            include_str!("../data/hitachi.toml"),
        ];
        for text in texts {
            let mut read = Catalogue::read("mine.toml", text).unwrap();
            if let Origin::File { path, .. } = &mut read.origin {
                *path = format!("built-in {}.toml", read.head.family);
            }
            let registry = Registry { files: vec![read], families: RefCell::default() };
            for drive in registry.drives() {
                let [read, shipped] = [&registry, &shipped].map(|registry| registry.load(&drive.id).unwrap().unwrap());
                assert!(
                    format!("{read:?}") == format!("{shipped:?}"),
                    "{}: UPDATE=1 cargo test --test generated",
                    drive.id
                );
            }
        }
    }

    #[test]
    fn a_row_of_the_user_joins_the_family() {
        let registry = open(&format!(
            "{HEAD}params = [\n  {{ id = 1500, de = \"Förderhöhe\", en = \"Head\", unit = \"m\", decimals = 2, min = -999.99, access = \"rw\" }},\n]\n"
        ));
        let family = registry.unwrap().family("acu").unwrap();
        let param = family.param(1500).unwrap();
        assert_eq!((param.slug.as_str(), param.min, param.origin.as_str()), ("head", Some(-99_999), "mine.toml"));
    }

    #[test]
    fn errors_name_file_line_and_column() {
        let row = |rest: &str| {
            format!("{HEAD}params = [\n  {{ id = 1500, de = \"x\", en = \"x\", access = \"r\"{rest} }},\n]\n")
        };
        assert!(refused(&row(", colour = 1")).starts_with("mine.toml:4:"), "{}", refused(&row(", colour = 1")));
        assert!(refused(&row(", min = 2, max = 1")).starts_with("mine.toml:4:3: parameter 1500: `min` is above `max`"));
        assert!(refused(&row(", enum = \"no\"")).contains("there is no table `[enums.no]`"));
        assert!(refused(&row(", decimals = 1, min = 0.25")).contains("more decimals"));
        assert!(refused(&row(", decimals = 40")).contains("at most 9"));
        assert!(refused("schema = 1\nfamily = \"x").starts_with("mine.toml:2:"));
        assert!(refused("schema = 2\nfamily = \"active\"").contains("reads schema 1"));
        assert!(refused("schema = 1\nfamily = \"toaster\"").contains("unknown family 'toaster' (expected: active"));
    }

    #[test]
    fn duplicates_are_refused_unless_they_replace() {
        let row = |rest: &str| {
            format!(
                "{HEAD}params = [{{ id = 372, slug = \"rated-speed\", de = \"x\", en = \"x\", access = \"r\"{rest} }}]"
            )
        };
        assert!(refused(&row("")).contains("already in built-in active.toml; add `replace = true`"));
        assert_eq!(open(&row(", replace = true")).unwrap().family("act").unwrap().param(372).unwrap().name.en, "x");
        let twice = format!(
            "{HEAD}params = [\n{{ id = 1501, de = \"x\", en = \"x\", access = \"r\" }},\n{{ id = 1501, de = \"x\", en = \"x\", access = \"r\" }}]"
        );
        assert!(refused(&twice).starts_with("mine.toml:5:1: parameter 1501 stands twice"));
    }

    #[test]
    fn rows_of_other_tables_must_replace_openly_too() {
        let fault = |rest: &str| {
            format!(
                "{HEAD}faults = [\n  {{ code = 0x0500, key = \"F0500\", en = \"x\", de = \"x\", cause = {{ en = \"x\", de = \"x\" }}, remedy = {{ en = \"x\", de = \"x\" }}{rest} }}]"
            )
        };
        assert!(
            refused(&fault("")).starts_with("mine.toml:4:3: fault 0x0500 is there already"),
            "{}",
            refused(&fault(""))
        );
        assert_eq!(open(&fault(", replace = true")).unwrap().family("act").unwrap().fault(0x500).unwrap().en, "x");
        let value = format!("{HEAD}[enums.modbus-parity]\n0 = {{ en = \"x\", de = \"x\" }}\n");
        assert!(refused(&value).starts_with("mine.toml:4:5: table 'modbus-parity', 0 is there already"));
        let bit = format!("{HEAD}[bits.mine]\n0 = {{ slug = \"x\", en = \"\\u001b\", de = \"x\" }}\n");
        assert!(refused(&bit).starts_with("mine.toml:4:5: control character"));
    }

    #[test]
    fn hostile_texts_are_refused() {
        let row = |name: &str| format!("{HEAD}params = [{{ id = 1500, de = \"x\", en = \"{name}\", access = \"r\" }}]");
        assert!(refused(&row("\\u001b[31m")).contains("control character U+001B"));
        assert!(refused(&row(&"a".repeat(1 << 20))).contains("at most 2000"));
        assert!(refused(&"#".repeat(MAX_FILE + 1)).contains("at most"));
    }

    /// 20 Hz that somebody agreed to would be sent as 200.
    #[test]
    fn what_moves_a_shaft_keeps_its_scale() {
        let row = |rest: &str| {
            format!(
                "{HEAD}params = [{{ id = 484, slug = \"frequency-setpoint\", de = \"Mein\", en = \"Mine\", access = \"rw\", replace = true{rest} }}]"
            )
        };
        for rest in [
            "",
            ", type = \"long\", decimals = 3, unit = \"Hz\"",
            ", type = \"int\", decimals = 2, unit = \"Hz\"",
            ", type = \"long\", decimals = 2, unit = \"%\"",
        ] {
            assert!(refused(&row(rest)).contains("type, decimals and unit stay"), "{rest}");
        }
        let kept = open(&row(", type = \"long\", decimals = 2, unit = \"Hz\"")).unwrap();
        assert_eq!(kept.family("act").unwrap().param(484).unwrap().name.en, "Mine");
    }
}
