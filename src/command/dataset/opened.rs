//! A parameter file that the user named: read, and taken by the catalogue of its family.

use crate::command::again::word;
use crate::drive::paramfile::broken;
use crate::drive::transaction::Choice;
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::Warning;
use crate::profile::paramfile::{At, Head, ParamFile, Provenance, SavedDrive, Settings};
use crate::profile::{Family, Registry};
use crate::text::{Lang, Text, both};
use std::collections::BTreeMap;
use std::path::Path;
use std::rc::Rc;

/// A parameter file.
#[derive(Debug)]
pub(in crate::command) struct Opened {
    pub(in crate::command) file: ParamFile,
    pub(in crate::command) family: Rc<Family>,
    pub(in crate::command) settings: Settings,
    /// Whether it was edited, if only some of it is left.
    edited: Option<bool>,
    /// The files that were changed since they were saved.
    changed: Vec<Rc<str>>,
    /// The drives that the files say they are of: path, address, node of the system bus.
    of: Vec<(Rc<str>, u8, u8)>,
}

impl Opened {
    /// Reads a file; of another family than `named`, if one was, it is refused.
    pub(in crate::command) fn read(path: &Path, registry: &Registry, named: Option<&str>) -> Result<Self, Failure> {
        let shown = path.display().to_string();
        let bad = |code: &str, why: Text| Failure::new(Class::Data, code, why);
        let text = files::read(path, files::TEXT).map_err(|error| bad("data.parameter_file", error.of(path)))?;
        let file = ParamFile::parse(&shown, &text).map_err(|fault| broken(&fault))?;
        let word = &file.head.drive.family;
        let family = registry.family(word).ok_or_else(|| {
            let known: Vec<_> = registry.drives().into_iter().map(|drive| drive.id).collect();
            let why = both!(
                "{at}: no catalogue knows the family '{word}' (expected: {known})",
                "{at}: kein Katalog kennt die Familie '{word}' (erwartet: {known})",
                at = file.family_at,
                known = known.join(", ")
            );
            bad("data.unknown_family", why).hint(both!(
                "--catalogue FILE brings a family of your own",
                "--catalogue DATEI bringt eine eigene Familie mit"
            ))
        })?;
        let settings = file.settings(&family).map_err(|fault| broken(&fault))?;
        let SavedDrive { address, node, .. } = file.head.drive;
        let of = address.map(|address| (file.path.clone(), address, node.unwrap_or(0))).into_iter().collect();
        let mut opened = Opened { file, family, settings, edited: None, changed: Vec::new(), of };
        opened.changed.extend((opened.is_edited() == Some(true)).then(|| opened.file.path.clone()));
        named.map_or(Ok(()), |named| opened.fits(named))?;
        Ok(opened)
    }

    /// What a plan of a bus wants of a drive, as if a file held it.
    pub(in crate::command) fn planned(path: &str, family: Rc<Family>, settings: Settings, lang: Lang) -> Self {
        let path: Rc<str> = path.into();
        let drive = SavedDrive { family: family.drive.clone(), ..SavedDrive::default() };
        let saved = Provenance { complete: true, ..Provenance::default() };
        let head = Head { drive, saved, not_held: BTreeMap::new(), types: BTreeMap::new(), lang };
        let family_at = At { path: path.clone(), line: 0, column: 0 };
        let file = ParamFile { path, head, family_at, lines: Vec::new(), undo: None };
        Opened { file, family, settings, edited: None, changed: Vec::new(), of: Vec::new() }
    }

    /// Refuses a drive of another family.
    pub(in crate::command) fn fits(&self, drive: &str) -> Result<(), Failure> {
        self.is_of(drive, |at, own| {
            both!(
                "{at}: the file is for drives of the family {own}, the drive is of the family {drive}",
                "{at}: die Datei ist für Antriebe der Familie {own}, der Antrieb ist von der Familie {drive}"
            )
        })
    }

    /// Refuses another file that is for another family.
    pub(super) fn fits_file(&self, drive: &str) -> Result<(), Failure> {
        self.is_of(drive, |at, own| {
            both!(
                "{at}: the file is for drives of the family {own}, the other file is for the family {drive}",
                "{at}: die Datei ist für Antriebe der Familie {own}, die andere Datei für die Familie {drive}"
            )
        })
    }

    fn is_of(&self, drive: &str, wrong: impl Fn(&At, &str) -> Text) -> Result<(), Failure> {
        let own = &self.file.head.drive.family;
        // As the registry knows them.
        if own.eq_ignore_ascii_case(drive) {
            return Ok(());
        }
        let message = wrong(&self.file.family_at, own);
        Err(Failure::new(Class::Data, "data.other_family", message).hint(both!(
            "take a file that was saved from such a drive",
            "eine Datei nehmen, die von einem solchen Antrieb gesichert wurde"
        )))
    }

    /// Puts another file of the same family over it.
    pub(super) fn lay_over(&mut self, over: Opened) -> Result<(), Failure> {
        over.fits_file(&self.family.drive)?;
        self.settings.lay_over(over.settings);
        self.of.extend(over.of);
        self.changed.extend(over.changed);
        self.file.path = format!("{}, {}", self.file.path, over.file.path).into();
        // What two files are together nobody has signed.
        self.file.head.saved.signature = None;
        Ok(())
    }

    /// What is odd about the files for the drive at this address and node: one that names another drive (the file of the other
    /// pump is a common slip), one that was changed since it was saved (by hand, or half of it is missing).
    pub(in crate::command) fn doubts(&self, at: (u8, u8)) -> Vec<Warning> {
        let shown = |address: u8, node: u8| if node == 0 { format!("{address}") } else { format!("{address}.{node}") };
        let others = self.of.iter().filter(|(_, address, node)| (*address, *node) != at);
        let told = others.map(|(path, address, node)| Warning {
            code: "load.other_address".to_owned(),
            message: both!(
                "{path} names address {of} in its head, this drive has {at}; a file for several drives names none",
                "{path} nennt im Kopf die Adresse {of}, dieser Antrieb hat {at}; eine Datei für mehrere Antriebe nennt keine",
                of = shown(*address, *node),
                at = shown(at.0, at.1)
            ),
        });
        told.chain(self.changed.iter().map(|path| edited(&Text::name(path)))).collect()
    }

    /// The command that completes what an interrupted save has left.
    pub(super) fn completes(&self) -> Text {
        let path = self.file.path.strip_suffix(".part").unwrap_or(&self.file.path);
        let address = self.file.head.drive.address.map_or_else(String::new, |address| format!("-a {address} "));
        both!(
            "`antrieb {address}dataset save {file} --resume` completes it",
            "`antrieb {address}dataset save {file} --resume` vervollständigt sie",
            file = word(path)
        )
    }

    /// Keeps of it what is meant; whether it was edited is told of the whole.
    pub(in crate::command) fn pick(&mut self, choice: &Choice) -> Result<(), Failure> {
        self.edited = self.is_edited();
        choice.pick(&mut self.settings, &self.family)
    }

    /// Whether it was changed since it was saved; `None` if it carries no signature.
    pub(super) fn is_edited(&self) -> Option<bool> {
        let saved = self.file.head.saved.signature.as_ref()?;
        self.edited.or_else(|| Some(*saved != self.settings.signature(&self.family.drive).to_string()))
    }
}

/// A file is not what it was when it was saved.
pub(super) fn edited(name: &Text) -> Warning {
    Warning {
        code: "file.edited".to_owned(),
        message: both!(
            "{name} was changed since it was saved: its signature is another one",
            "{name} wurde seit dem Sichern geändert: die Signatur ist eine andere",
            name
        ),
    }
}
