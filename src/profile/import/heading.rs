//! Which column is which: by its heading in German or English, by its contents where a word means two things.

use super::cells::{self, dense};
use super::draft::{ColumnTaken, ImportError, Wishes};
use super::export::COLUMNS;
use super::sheet::Record;
use crate::text::both;

/// Words of headings: field, words that mean it, words that may mean it if none of the first stands there.
const WORDS: &[(&str, &str, &str)] = &[
    (
        "id",
        "nr nummer no number num param parameter parameternr parameternummer parameterno parameternumber pnr pno register \
         registernr registernummer registeradresse registeraddress registernumber modbusadresse modbusaddress modbusregister \
         adresse address addr adr reg parnr",
        "code index pos position",
    ),
    ("de", "deutsch german namede bezeichnungde namedeutsch bezeichnungdeutsch", ""),
    ("en", "english englisch nameen bezeichnungen nameenglish nameenglisch bezeichnungenglisch", ""),
    (
        "name",
        "name bezeichnung benennung parametername parameterbezeichnung titel title designation label text signal variable \
         klartext parameter param",
        "beschreibung description funktion function bedeutung meaning",
    ),
    ("short", "kurzname kurzbezeichnung shortname kuerzel mnemonic", ""),
    ("unit", "einheit units dim dimension eh phyeinheit masseinheit", ""),
    ("type", "typ datentyp datatype datenformat dataformat", "format"),
    (
        "decimals",
        "nachkommastellen dezimalstellen dezimalen kommastellen decimalplaces nk",
        "komma nachkomma dezimal precision genauigkeit",
    ),
    ("scale", "skalierung faktor factor scaling scalefactor multiplikator multiplier", "aufloesung resolution"),
    ("range", "bereich wertebereich einstellbereich range valuerange settingrange", ""),
    ("min", "minimum minwert minimalwert untergrenze von lower minvalue lowerlimit", ""),
    ("max", "maximum maxwert maximalwert obergrenze bis upper maxvalue upperlimit", ""),
    (
        "default",
        "werk werkseinstellung werkeinstellung werkseinst werkseinstellungen werkswert abwerk voreinstellung standard standardwert factory factorysetting \
         defaultvalue",
        "",
    ),
    (
        "access",
        "zugriff zugriffsart rw lesenschreiben readwrite berechtigung accessright",
        "schreibbar beschreibbar veraenderbar writable writeable attribut attribute",
    ),
    ("sets", "datensatz datensaetze datasets dataset", ""),
    ("values", "werte auswahl auswahlwerte enum enumeration choices options optionen", ""),
    ("group", "gruppe kategorie category menu menue rubrik", ""),
    (
        "note",
        "bemerkung bemerkungen hinweis hinweise kommentar anmerkung anmerkungen remark remarks notes comment comments info",
        "beschreibung description erlaeuterung funktion function",
    ),
    ("source", "quelle", ""),
];

/// Names of fields that a heading or an option can have.
pub(super) fn fields() -> Vec<&'static str> {
    let mut all: Vec<&'static str> = COLUMNS.to_vec();
    all.extend(WORDS.iter().map(|row| row.0).filter(|field| !COLUMNS.contains(field)));
    all
}

/// The columns of a list.
#[derive(Clone, Debug, Default)]
pub(super) struct Head {
    pub(super) columns: Vec<ColumnTaken>,
    /// Records before the first row.
    pub(super) rows_from: usize,
    pub(super) line: usize,
}

impl Head {
    pub(super) fn column(&self, field: &str) -> Option<usize> {
        self.columns.iter().find(|taken| taken.field == field).map(|taken| taken.column - 1)
    }

    /// What a row says of a field.
    pub(super) fn cell<'r>(&self, record: &'r Record, field: &str) -> Option<&'r str> {
        self.column(field).map(|column| record.cell(column)).filter(|cell| !cell.is_empty())
    }

    /// A row or a word that does not occur is a slip of the pen.
    pub(super) fn check_wishes(&self, records: &[Record], wishes: &Wishes) -> Result<(), ImportError> {
        let occurs = |whom: Whom<'_>| match whom {
            Whom::Every(_) => true,
            Whom::Row(id, _) => records.iter().any(|record| self.cell(record, "id").and_then(cells::id) == Some(id)),
            Whom::Word(field, word) => {
                records.iter().any(|record| self.cell(record, field).is_some_and(|cell| cells::is_same(word, cell)))
            }
        };
        let Some((key, word)) = wishes.sets.iter().find(|set| !Whom::of(&set.0).is_some_and(occurs)) else {
            return Ok(());
        };
        Err(ImportError::at(
            0,
            both!(
                "--set {key}={word}: the list has no such row, and no such word in that column",
                "--set {key}={word}: die Liste hat keine solche Zeile und kein solches Wort in der Spalte"
            ),
        ))
    }
}

/// Headings over a yes or a no: whether it can be written.
pub(super) fn asks_whether_written(heading: &str) -> bool {
    ["schreibbar", "beschreibbar", "veraenderbar", "writable", "writeable"].contains(&&*dense(heading))
}

/// How surely a heading means a field: 0 it is its name, 1 a word for it, 2 perhaps.
fn fits(field: &str, heading: &str) -> Option<u8> {
    let typed = dense(heading);
    if typed == dense(field) {
        return Some(0);
    }
    let (_, sure, perhaps) = WORDS.iter().find(|row| row.0 == field)?;
    let among = |words: &str| words.split_whitespace().any(|word| word == typed);
    if among(sure) { Some(1) } else { among(perhaps).then_some(2) }
}

impl Wishes {
    /// What every row says of a field that says nothing of it itself.
    pub(super) fn of_every(&self, field: &str) -> Option<&str> {
        self.said(|whom| whom == Whom::Every(field))
    }

    /// What is said of it, the last word first.
    pub(super) fn said(&self, is_it: impl Fn(Whom<'_>) -> bool) -> Option<&str> {
        self.sets.iter().rev().find(|set| Whom::of(&set.0).is_some_and(&is_it)).map(|set| set.1.as_str())
    }
}

/// What a wish is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Whom<'w> {
    /// A field of every row that says nothing of it.
    Every(&'w str),
    /// A field of the row with this number, as the list has it.
    Row(u32, &'w str),
    /// A word that stands in a field.
    Word(&'w str, &'w str),
}

impl<'w> Whom<'w> {
    /// `access`, `370.type`, `P.370.type`, `type.int`; `None` where no field is named.
    pub(super) fn of(key: &'w str) -> Option<Self> {
        let is_field = |word: &str| fields().contains(&word);
        if is_field(key) {
            return Some(Whom::Every(key));
        }
        let row = key.rsplit_once('.').filter(|(_, field)| is_field(field));
        let row = row.and_then(|(number, field)| Some(Whom::Row(cells::id(number)?, field)));
        row.or_else(|| {
            key.split_once('.').filter(|(field, _)| is_field(field)).map(|(field, word)| Whom::Word(field, word))
        })
    }
}

/// Finds the headings, wherever they stand below a title, and takes the columns for what they are.
pub(super) fn find(records: &[Record], wishes: &Wishes) -> Result<Head, ImportError> {
    let columns_of_none = wishes.columns.iter().filter(|wish| !fields().contains(&wish.0.as_str()));
    let sets_of_none = wishes.sets.iter().filter(|wish| Whom::of(&wish.0).is_none());
    if let Some((wrong, _)) = columns_of_none.chain(sets_of_none).next() {
        let known = fields().join(", ");
        return Err(ImportError::at(
            0,
            both!(
                "there is no field '{wrong}' (expected: {known})",
                "ein Feld '{wrong}' gibt es nicht (erwartet: {known})"
            ),
        ));
    }
    let recognised = |record: &Record| {
        let said = |cell: &str| wishes.columns.iter().any(|wish| same(&wish.1, cell));
        record
            .cells
            .iter()
            .filter(|cell| said(cell) || fields().iter().any(|field| fits(field, cell).is_some()))
            .count()
    };
    let best = records.iter().take(30).map(recognised).max().unwrap_or(0);
    let at = records.iter().position(|record| recognised(record) == best).filter(|_| best >= 2);
    let (Some(at), Some(head)) = (at, at.and_then(|at| records.get(at))) else {
        let why = both!(
            "no line of headings was found: two of them at least must be known",
            "keine Kopfzeile gefunden: mindestens zwei Überschriften müssen bekannt sein"
        );
        return Err(ImportError::at(0, why).hint(both!(
            "say which column is which: --column id=HEADING --column name=HEADING",
            "die Spalten benennen: --column id=ÜBERSCHRIFT --column name=ÜBERSCHRIFT"
        )));
    };
    let rows = records.get(at + 1..).unwrap_or(&[]);
    let columns = columns(head, rows, wishes)?;
    Ok(Head { columns, rows_from: at + 1, line: head.line })
}

fn same(wish: &str, heading: &str) -> bool {
    !wish.is_empty() && (wish.trim() == heading || dense(wish) == dense(heading) && !dense(wish).is_empty())
}

fn columns(head: &Record, rows: &[Record], wishes: &Wishes) -> Result<Vec<ColumnTaken>, ImportError> {
    let mut taken: Vec<ColumnTaken> = Vec::new();
    let take = |field: &'static str, column: usize, said: bool| ColumnTaken {
        field,
        heading: head.cell(column).to_owned(),
        column: column + 1,
        said,
    };
    for field in fields() {
        let Some((_, wish)) = wishes.columns.iter().rev().find(|wish| wish.0 == field) else { continue };
        let fitting: Vec<usize> = (0..head.cells.len()).filter(|&column| same(wish, head.cell(column))).collect();
        match fitting.as_slice() {
            _ if wish.is_empty() => {}
            [column] => taken.push(take(field, *column, true)),
            [] => return Err(no_heading(head, wish)),
            _ => return Err(two(head, field, &fitting)),
        }
    }
    // What is surely a field is taken before what may be one.
    for surely in 0..3 {
        for field in fields() {
            let is_settled =
                wishes.columns.iter().any(|wish| wish.0 == field) || taken.iter().any(|row| row.field == field);
            if is_settled {
                continue;
            }
            let is_free = |column: &usize| taken.iter().all(|row| row.column != column + 1);
            let fitting: Vec<usize> = (0..head.cells.len())
                .filter(is_free)
                .filter(|&column| fits(field, head.cell(column)) == Some(surely) && may_hold(field, rows, column))
                .collect();
            match fitting.as_slice() {
                [] => {}
                [column] => taken.push(take(field, *column, false)),
                _ => return Err(two(head, field, &fitting)),
            }
        }
    }
    taken.sort_by_key(|row| row.column);
    Ok(taken)
}

/// Whether the contents can be those of the field: numbers of parameters are numbers, names are none.
fn may_hold(field: &str, rows: &[Record], column: usize) -> bool {
    let filled = || rows.iter().map(|row| row.cell(column)).filter(|cell| !cell.is_empty());
    let numbers = filled().filter(|cell| cells::id(cell).is_some()).count();
    match field {
        "id" => numbers * 2 > filled().count(),
        "name" => numbers * 2 <= filled().count(),
        _ => true,
    }
}

fn no_heading(head: &Record, wish: &str) -> ImportError {
    let known = head.cells.iter().filter(|cell| !cell.is_empty()).cloned().collect::<Vec<_>>().join(", ");
    ImportError::at(
        head.line,
        both!(
            "there is no heading '{wish}' (found: {known})",
            "eine Überschrift '{wish}' gibt es nicht (gefunden: {known})"
        ),
    )
}

fn two(head: &Record, field: &str, fitting: &[usize]) -> ImportError {
    let headings: Vec<String> = fitting.iter().map(|&column| format!("'{}'", head.cell(column))).collect();
    let (found, first) = (headings.join(", "), fitting.first().map_or("", |&column| head.cell(column)));
    let why = both!(
        "several columns can be the field {field}: {found}",
        "mehrere Spalten können das Feld {field} sein: {found}"
    );
    ImportError::at(head.line, why)
        .hint(both!("say which one: --column '{field}={first}'", "angeben, welche: --column '{field}={first}'"))
}
