//! A spreadsheet of a site or a supplier, as rows of a catalogue.

use super::cells::{self, Kind};
use super::draft::{Draft, ImportError, Imported, LeftOut, Wishes};
use super::export::RAW;
use super::heading::{self, Head, Whom};
use super::sheet::{self, Record};
use crate::profile::link::INPUTS;
use crate::profile::param::{Access, Type};
use crate::profile::paramfile::ranges;
use crate::text::{Text, both};
use odd::Odd;
use std::ops::RangeInclusive;

mod odd;
mod words;

/// Registers as they are printed, holding registers with a 4 in front and input registers with a 3, of five digits or of six: 40001 is holding
/// register 0 and 30001 input register 0, or so most makers mean it.
const PRINTED: [[RangeInclusive<u32>; 2]; 2] = [[40_001..=49_999, 30_001..=39_999], [400_001..=465_536, INPUTS]];

/// Fields with numbers that may have decimals.
const NUMBERS: [&str; 5] = ["scale", "range", "min", "max", "default"];
/// Lines of a list: a catalogue of 4 MB has room for fewer.
const MOST_ROWS: usize = 50_000;
/// Cells of a line.
const MOST_COLUMNS: usize = 1_000;

/// Reads a list.
pub fn table(bytes: &[u8], wishes: &Wishes) -> Result<Imported, ImportError> {
    let (text, encoding) = sheet::text_of(bytes);
    let Some(separator) = wishes.separator.or_else(|| sheet::separator_of(&text)) else {
        let why = both!(
            "no table: no line has two cells parted by ; , or a tab",
            "keine Tabelle: keine Zeile hat zwei Zellen, die ; , oder ein Tabulator trennt"
        );
        return Err(ImportError::at(0, why).hint(both!(
            "say what parts the cells: --separator ';'",
            "angeben, was die Zellen trennt: --separator ';'"
        )));
    };
    let records: Vec<Record> =
        sheet::records(&text, separator).filter(|record| !record.is_empty()).take(MOST_ROWS + 1).collect();
    check_size(&records)?;
    let head = heading::find(&records, wishes)?;
    if head.column("id").is_none() {
        let why = both!("no column has the numbers of parameters", "keine Spalte enthält die Nummern von Parametern");
        return Err(ImportError::at(head.line, why)
            .hint(both!("say which one: --column id=HEADING", "angeben, welche: --column id=ÜBERSCHRIFT")));
    }
    let heads = records.get(head.rows_from - 1).map(|record| record.cells.clone()).unwrap_or_default();
    let is_free = |column: usize| head.columns.iter().all(|taken| taken.column != column + 1);
    let unused = heads.iter().enumerate().filter(|(column, cell)| is_free(*column) && !cell.is_empty());
    let unused = unused.map(|(_, cell)| cell.clone()).collect();
    let records = records.get(head.rows_from..).unwrap_or(&[]);
    let all = || records.iter().flat_map(|record| &record.cells);
    let has = |mark: char| all().any(|cell| cells::has_decimal(cell, mark));
    let commas = wishes.commas.unwrap_or_else(|| has(','));
    head.check_wishes(records, wishes)?;
    let wide = List::has_short(records, &head);
    let mut list = List { head: &head, wishes, commas, wide, width: heads.len(), odd: Vec::new() };
    list.check_base(records)?;
    let (mut drafts, mut left_out) = (Vec::new(), Vec::new());
    for record in records {
        match list.draft(record) {
            Ok(draft) => drafts.push(draft),
            Err(why) => left_out.push(LeftOut { line: record.line, why }),
        }
    }
    if wishes.commas.is_none() && has('.') == has(',') {
        list.notes_guessed(records);
    }
    let notes = list.odd.iter().map(Odd::told).chain(list.open_access()).collect();
    let (format, separator, columns, head) = ("table", Some(separator), head.columns.clone(), head.line);
    let own = Default::default();
    let found = Imported { format, encoding, separator, head, columns, unused, drafts, left_out, notes, own };
    found.check_twins()?;
    Ok(found)
}

/// What is larger is no list of a drive; it would take minutes to look through, and be too much for a catalogue in the end.
fn check_size(records: &[Record]) -> Result<(), ImportError> {
    if let Some(wide) = records.iter().find(|record| record.cells.len() > MOST_COLUMNS) {
        let why = both!(
            "{cells} cells in a line; a list has at most {MOST_COLUMNS}",
            "{cells} Zellen in einer Zeile; eine Liste hat höchstens {MOST_COLUMNS}",
            cells = wide.cells.len()
        );
        return Err(ImportError::at(wide.line, why));
    }
    match records.get(MOST_ROWS) {
        None => Ok(()),
        Some(last) => {
            let why = both!("a list has at most {MOST_ROWS} lines", "eine Liste hat höchstens {MOST_ROWS} Zeilen");
            Err(ImportError::at(last.line, why))
        }
    }
}

/// The register that a printed number names, where the base is such a number.
fn printed(number: u32, base: u32) -> Option<u32> {
    let [holding, inputs] = PRINTED.iter().find(|areas| areas.iter().any(|area| *area.start() == base))?;
    match number {
        number if holding.contains(&number) => Some(number - holding.start()),
        number if inputs.contains(&number) => Some(number - inputs.start() + INPUTS.start()),
        _ => None,
    }
}

/// A list while it is read.
struct List<'a> {
    head: &'a Head,
    wishes: &'a Wishes,
    /// Its decimal point is a comma.
    commas: bool,
    /// Its `int` may have 32 bits.
    wide: bool,
    /// So many headings.
    width: usize,
    odd: Vec<Odd>,
}

impl List<'_> {
    /// What a row says of a field, or every row.
    fn get<'r>(&'r self, record: &'r Record, field: &str) -> Option<&'r str> {
        let number = self.head.cell(record, "id").and_then(cells::id);
        let of_row = self.wishes.said(|whom| matches!(whom, Whom::Row(id, of) if Some(id) == number && of == field));
        let means = |cell: &'r str| {
            self.wishes
                .said(|whom| matches!(whom, Whom::Word(of, word) if of == field && cells::is_same(word, cell)))
                .unwrap_or(cell)
        };
        let cell = || self.head.cell(record, field).map(means);
        of_row.or_else(cell).or_else(|| self.wishes.of_every(field))
    }

    /// Whether it calls 16 bits short, so that its int may well have 32.
    fn has_short(records: &[Record], head: &Head) -> bool {
        let column = head.column("type");
        records.iter().any(|record| column.is_some_and(|column| cells::is_short(record.cell(column))))
    }

    fn text(&self, record: &Record, field: &str) -> Option<String> {
        self.get(record, field).map(str::to_owned)
    }

    /// What is said of a cell; what is said of many is one note.
    fn note(&mut self, line: usize, what: Text, cell: &str) {
        match self.odd.iter_mut().find(|odd| odd.what == what) {
            Some(odd) => odd.cells.push((line, cell.to_owned())),
            None => self.odd.push(Odd { what, cells: vec![(line, cell.to_owned())] }),
        }
    }

    /// Register 40001 may be register 0 or register 40001, and 30001 an input register: nobody but the maker knows.
    fn check_base(&self, records: &[Record]) -> Result<(), ImportError> {
        let ids = || records.iter().filter_map(|record| cells::id(self.get(record, "id")?));
        let is_of = |areas: &&[RangeInclusive<u32>; 2]| ids().all(|id| areas.iter().any(|area| area.contains(&id)));
        let areas = PRINTED.iter().find(is_of).into_iter().flatten();
        // Of input registers alone six digits are our own way to name them.
        let first = areas.filter(|area| **area != INPUTS).find(|area| ids().any(|id| area.contains(&id)));
        let Some(first) = first.map(RangeInclusive::start).filter(|_| self.wishes.own && self.wishes.base.is_none())
        else {
            return Ok(());
        };
        let inputs = PRINTED.iter().map(|[_, inputs]| inputs).find(|inputs| ids().any(|id| inputs.contains(&id)));
        if let Some(inputs) = inputs {
            let inputs = inputs.start();
            let above = if first == inputs { first.to_string() } else { format!("{first}, {inputs}") };
            let why = both!(
                "the numbers lie above {above}: that may be the printed names of registers, those with a 3 of input registers, or \
                 holding registers themselves",
                "die Nummern liegen ab {above}: das können die gedruckten Namen von Registern sein, die mit 3 von Eingangsregistern, \
                 oder selbst Halteregister",
                above
            );
            return Err(ImportError::at(self.head.line, why).hint(both!(
                "--base {first} takes those above {inputs} as input registers, --base 0 every number as a holding register",
                "--base {first} nimmt die ab {inputs} als Eingangsregister, --base 0 jede Nummer als Halteregister"
            )));
        }
        let why = both!(
            "every number lies above {first}: it may be the printed name of register 0, or a register itself",
            "alle Nummern liegen ab {first}: das kann der gedruckte Name von Register 0 sein oder ein Register selbst"
        );
        Err(ImportError::at(self.head.line, why).hint(both!(
            "say which number register 0 has: --base {first}, or --base 0",
            "angeben, welche Nummer Register 0 hat: --base {first} oder --base 0",
            first
        )))
    }

    fn draft(&mut self, record: &Record) -> Result<Draft, Text> {
        if let Some(last) = record.cells.iter().rposition(|cell| !cell.is_empty()).filter(|last| *last >= self.width) {
            return Err(both!(
                "{cells} cells under {width} headings: a comma in a number, without quotes?",
                "{cells} Zellen unter {width} Überschriften: ein Komma in einer Zahl, ohne Anführungszeichen?",
                cells = last + 1,
                width = self.width
            ));
        }
        let id = self.id(record)?;
        let mut draft = Draft::new(record.line, id, self.name(record, id));
        draft.slug = self.text(record, "slug");
        draft.short = self.text(record, "short");
        draft.unit = self.text(record, "unit").filter(|unit| !matches!(unit.as_str(), "-" | "–" | "—"));
        self.kind(record, &mut draft)?;
        self.decimals(record, &mut draft);
        self.limits(record, &mut draft);
        self.float(record, &mut draft)?;
        self.within(record.line, &mut draft);
        self.fit(record, &mut draft);
        self.access(record, &mut draft);
        self.words(record, &mut draft);
        draft.enumeration = (self.text(record, "enum"), self.names(record, ["values_en", "values_de"], "values"));
        draft.bits = (self.text(record, "bits"), self.names(record, ["bits_en", "bits_de"], "bits_names"));
        Ok(draft)
    }

    fn id(&self, record: &Record) -> Result<u32, Text> {
        let cell = self.get(record, "id").unwrap_or_default();
        if cell.is_empty() {
            return Err(both!("no number", "keine Nummer"));
        }
        let shown: String = cell.chars().take(40).collect();
        let number = cells::id(cell).ok_or_else(|| {
            both!("'{shown}' is no number of a parameter", "'{shown}' ist keine Nummer eines Parameters")
        })?;
        let base = self.wishes.base.unwrap_or(0);
        if let Some(id) = printed(number, base).filter(|_| self.wishes.own) {
            return Ok(id);
        }
        let id = number.checked_sub(base);
        let is_register = |id: &u32| *id <= u16::MAX.into() || base == 0 && INPUTS.contains(id);
        id.filter(|id| !self.wishes.own || is_register(id)).ok_or_else(|| {
            both!(
                "{number} is no register: {base} is register 0, the last one 65535",
                "{number} ist kein Register: {base} ist Register 0, das letzte 65535"
            )
        })
    }

    fn name(&self, record: &Record, id: u32) -> Text {
        let any = self.text(record, "name").unwrap_or_else(|| format!("Parameter {id}"));
        let [en, de] = ["en", "de"].map(|field| self.text(record, field));
        match (en, de) {
            (Some(en), Some(de)) => Text { en: en.into(), de: de.into() },
            (Some(one), None) if self.get(record, "name").is_none() => Text::name(one),
            (None, Some(one)) if self.get(record, "name").is_none() => Text::name(one),
            (en, de) => Text { en: en.unwrap_or_else(|| any.clone()).into(), de: de.unwrap_or(any).into() },
        }
    }

    fn kind(&mut self, record: &Record, draft: &mut Draft) -> Result<(), Text> {
        let Some(word) = self.text(record, "type") else { return Ok(()) };
        if self.wide && cells::is_plain_int(&word) {
            let what = both!(
                "beside 'short' this may have 16 bits or 32, so it stays open: --set type.WORD=int16 (uint16, int32, uint32) says which",
                "neben 'short' können das 16 oder 32 Bit sein, es bleibt offen: --set type.WORT=int16 (uint16, int32, uint32) sagt es"
            );
            self.note(record.line, what, &word);
            return Ok(());
        }
        match cells::kind(&word) {
            Kind::Is(Type::String) if self.wishes.own => return Err(cells::cannot(&word)),
            Kind::Cannot => return Err(cells::cannot(&word)),
            Kind::Is(kind) => draft.kind = Some(kind),
            Kind::Unsigned32 => {
                draft.kind = Some(Type::Long);
                draft.limits[0] = Some("0".to_owned());
            }
            Kind::Unknown => {
                let what = both!(
                    "this type is not known, so it stays open; --set type.WORD=int says what it means",
                    "dieser Typ ist unbekannt und bleibt offen; --set type.WORT=int sagt, was er heißt"
                );
                self.note(record.line, what, &word);
            }
        }
        Ok(())
    }

    fn decimals(&mut self, record: &Record, draft: &mut Draft) {
        if let Some(cell) = self.text(record, "decimals") {
            draft.decimals = cells::number(&cell, self.commas).and_then(|number| number.parse().ok());
            if draft.decimals.is_none() {
                let what = both!("so many decimals there are not", "so viele Nachkommastellen gibt es nicht");
                self.note(record.line, what, &cell);
            }
        }
        let is_open = draft.decimals.is_none() && draft.kind != Some(Type::Float);
        let Some(cell) = self.text(record, "scale").filter(|_| is_open) else { return };
        draft.decimals = cells::number(&cell, self.commas).and_then(|scale| cells::decimals(&scale));
        if draft.decimals.is_none() {
            let what = both!(
                "a scale that is not 1, 0.1, 0.01 …, so the value is shown raw",
                "eine Skalierung, die nicht 1, 0.1, 0.01 … ist; der Wert wird roh gezeigt"
            );
            self.note(record.line, what, &cell);
            // Without a unit a raw number would pass for the value.
            draft.unit.get_or_insert_with(|| format!("× {cell}"));
        }
    }

    /// A default beyond its limits is not taken.
    fn within(&mut self, line: usize, draft: &mut Draft) {
        let number = |limit: &Option<String>| limit.as_ref().and_then(|limit| limit.parse::<f64>().ok());
        let [min, max, default] = draft.limits.each_ref().map(number);
        let is_beyond = |default: f64| min.is_some_and(|min| default < min) || max.is_some_and(|max| default > max);
        if default.is_some_and(is_beyond) {
            let cell = draft.limits[2].take().unwrap_or_default();
            let what = both!(
                "this default lies beyond its limits, so it is not taken",
                "diese Werkseinstellung liegt außerhalb ihrer Grenzen, sie wird nicht übernommen"
            );
            self.note(line, what, &cell);
        }
    }

    /// A type that its own limits do not fit is not the type.
    fn fit(&mut self, record: &Record, draft: &mut Draft) {
        let holds = match draft.kind {
            Some(Type::Int) => -32_768.0..=32_767.0,
            Some(Type::Uint) => 0.0..=65_535.0,
            _ => return,
        };
        let scale = 10f64.powi(draft.decimals.unwrap_or(0).into());
        let raw = |limit: &String| limit.parse::<f64>().ok().map(|limit| (limit * scale).round());
        if draft.limits.iter().flatten().filter_map(raw).all(|raw| holds.contains(&raw)) {
            return;
        }
        draft.kind = None;
        let what = both!(
            "the limits do not fit into this type, so it stays open",
            "die Grenzen passen nicht in diesen Typ, er bleibt offen"
        );
        let word = self.text(record, "type").unwrap_or_default();
        self.note(record.line, what, &word);
    }

    /// A floating point has its decimals in itself, and no limits here.
    fn float(&mut self, record: &Record, draft: &mut Draft) -> Result<(), Text> {
        if draft.kind != Some(Type::Float) {
            return Ok(());
        }
        let scale = self.text(record, "scale").filter(|_| self.text(record, "decimals").is_none());
        let scale = scale.and_then(|cell| cells::number(&cell, self.commas).or(Some(cell)));
        if scale.is_some_and(|scale| cells::decimals(&scale) != Some(0)) {
            return Err(cells::scaled_float());
        }
        draft.decimals = None;
        for limit in std::mem::take(&mut draft.limits).into_iter().flatten() {
            let what = both!(
                "a float is not held against limits here, so they are not taken",
                "eine Gleitkommazahl wird hier nicht an Grenzen gemessen; sie werden nicht übernommen"
            );
            self.note(record.line, what, &limit);
        }
        Ok(())
    }

    fn limits(&mut self, record: &Record, draft: &mut Draft) {
        let mut typed = ["min", "max", "default"].map(|field| self.text(record, field));
        if let Some(range) = self.text(record, "range").and_then(|cell| cells::range(&cell, self.commas)) {
            typed = [typed[0].take().or(Some(range.0)), typed[1].take().or(Some(range.1)), typed[2].take()];
        }
        for (place, cell) in typed.into_iter().enumerate() {
            let Some(cell) = cell.filter(|cell| !matches!(cell.as_str(), "-" | "–" | "—")) else { continue };
            let number = cells::number(&cell, self.commas);
            let has_scale = draft.decimals.is_some() || draft.unit.is_none() || cell.ends_with(RAW);
            let is_scaled = |number: &String| draft.decimals.is_some() || !number.contains('.');
            match number {
                Some(number) if has_scale && is_scaled(&number) => draft.limits[place] = Some(number),
                Some(_) => {
                    let what = both!(
                        "not taken, because nothing tells the decimals (--set decimals=N)",
                        "nicht übernommen, denn nichts nennt die Nachkommastellen (--set decimals=N)"
                    );
                    self.note(record.line, what, &cell);
                }
                None => {
                    let what = both!("not taken, because it is no number", "nicht übernommen, denn es ist keine Zahl");
                    self.note(record.line, what, &cell);
                }
            }
        }
    }

    fn access(&mut self, record: &Record, draft: &mut Draft) {
        let Some(cell) = self.text(record, "access") else { return };
        let heading = self.head.columns.iter().find(|taken| taken.field == "access");
        let is_asked = heading.is_some_and(|taken| heading::asks_whether_written(&taken.heading));
        match cells::access(&cell).or_else(|| is_asked.then(|| cells::writable(&cell)).flatten()) {
            Some(access) => draft.access = access,
            None => {
                let what = both!(
                    "this access is not known, taken as r (read only); --set access.WORD=rw says what it means",
                    "dieser Zugriff ist unbekannt, genommen wird r (nur lesen); --set access.WORT=rw sagt, was es heißt"
                );
                self.note(record.line, what, &cell);
            }
        }
    }

    /// Nothing in the list told whether a point, or a comma, parts thousands or decimals.
    fn notes_guessed(&mut self, records: &[Record]) {
        let (mark, other) = if self.commas { (',', '.') } else { ('.', ',') };
        for record in records {
            for cell in
                NUMBERS.iter().filter_map(|field| self.head.cell(record, field)).filter(|cell| cells::is_open(cell))
            {
                let what = both!(
                    "nothing tells whether these have thousands or decimals: '{mark}' was taken for the decimal mark; --decimal '{mark}' or '{other}' says it",
                    "nichts sagt, ob das Tausender oder Nachkommastellen sind: '{mark}' gilt als Dezimalzeichen; --decimal '{mark}' oder '{other}' sagt es"
                );
                self.note(record.line, what, cell);
            }
        }
    }

    /// Nobody said who may write.
    fn open_access(&self) -> Option<Text> {
        let is_open = self.head.column("access").is_none() && self.wishes.of_every("access").is_none();
        let read = Access::Read.name();
        is_open.then(|| {
            both!(
                "no column tells the access, so every row is read only ({read}); --set access=rw says otherwise",
                "keine Spalte nennt den Zugriff, daher ist alles nur lesbar ({read}); --set access=rw sagt es anders"
            )
        })
    }
}
