//! A page for people, aligned and without borders, one row a line when piped; and what several kinds of findings show alike.

use super::narrow::{GAP, has_room, hold_words_together};
use crate::outcome::{Bit, Decimal, Fault, Value, Word, addressed, numbered};
use crate::profile::Lang;
use crate::profile::value::format_decimal;
use crate::render::clean;
use crate::render::words::word;
use crate::render::wrap::wrap;
use crate::text::Text;
use comfy_table::{CellAlignment, ContentArrangement, Table};

/// How a page is written.
#[derive(Clone, Copy)]
pub(in crate::render) struct Page {
    pub(in crate::render) lang: Lang,
    /// Columns of the terminal, if it is one.
    pub(in crate::render) width: Option<u16>,
    /// Everything that was found, not only what matters first.
    pub(in crate::render) full: bool,
    /// Node of the system bus behind every drive that is told of; 0 is the drive itself.
    pub(in crate::render) node: u8,
}

impl Page {
    pub(super) fn word(self, english: &str) -> &str {
        word(self.lang, english)
    }

    /// A text in the language of the page.
    pub(super) fn say(self, text: &Text) -> String {
        text.get(self.lang).to_owned()
    }

    /// A text that may be missing.
    pub(super) fn say_or_not(self, text: Option<&Text>) -> String {
        text.map_or_else(String::new, |text| self.say(text))
    }

    /// A family, or that nobody knows it.
    pub(super) fn family(self, drive: &str) -> &str {
        if drive == "unknown" { self.word(drive) } else { drive }
    }

    /// What a bit is called; its number where nobody named it.
    pub(super) fn bit(self, bit: &Bit) -> String {
        bit.name.as_ref().map_or_else(|| format!("{} {}", self.word("bit"), bit.bit), |name| self.say(name))
    }

    pub(super) fn each<T>(self, items: &[T], one: impl Fn(Page, &T) -> String) -> String {
        items.iter().map(|item| one(self, item)).collect::<Vec<_>>().join("\n")
    }

    /// A table in which columns give way, those named first, as long as the line has no room for every word of the others. One that was to be
    /// whole (`=`) and is named without that gives way by being broken.
    pub(super) fn yielding(self, head: &[&str], mut rows: Vec<Vec<String>>, gives_way: &[&str]) -> String {
        let mut head = head.to_vec();
        for name in gives_way {
            if self.full || self.has_room(&head, &rows) {
                break;
            }
            if let Some(whole) = head.iter_mut().find(|column| column.strip_prefix('=') == Some(*name)) {
                *whole = *name;
            } else if let Some(at) = head.iter().position(|column| column == name) {
                head.remove(at);
                rows.iter_mut().filter(|row| at < row.len()).for_each(|row| drop(row.remove(at)));
            }
        }
        self.table(&head, rows)
    }

    /// Whether a line has room for every word of a table.
    pub(super) fn has_room(self, head: &[&str], rows: &[Vec<String>]) -> bool {
        let names: Vec<_> = self.names(head).collect();
        self.width.is_none_or(|width| has_room(&names, rows, head, width))
    }

    fn names<'h>(self, head: &'h [&'h str]) -> impl Iterator<Item = &'h str> {
        let names = head.iter().map(|name| name.trim_start_matches(['>', '=']));
        names.map(move |name| if name.starts_with('@') { name } else { word(self.lang, name) })
    }

    /// A table; columns whose name starts with `>` are aligned to the right, those with `=` are never broken. What starts with `@`
    /// is no word, but a data set.
    pub(super) fn table(self, head: &[&str], rows: Vec<Vec<String>>) -> String {
        if rows.is_empty() {
            return String::new();
        }
        let mut table = Table::new();
        table.load_style(comfy_table::presets::NOTHING).set_content_arrangement(ContentArrangement::Disabled);
        let names: Vec<_> = self.names(head).collect();
        if names.iter().any(|name| !name.is_empty()) {
            table.set_header(names.clone());
        }
        let cells = |row: Vec<String>| row.iter().map(|cell| clean(cell)).collect();
        let mut rows: Vec<Vec<String>> = rows.into_iter().map(cells).collect();
        let constraints = self.width.map_or_else(Vec::new, |width| hold_words_together(&names, &mut rows, head, width));
        table.add_rows(rows);
        if let Some(width) = self.width {
            table.set_content_arrangement(ContentArrangement::Dynamic).set_width(width);
        }
        for (column, constraint) in table.column_iter_mut().zip(constraints) {
            column.set_constraint(constraint);
        }
        for (index, column) in table.column_iter_mut().enumerate() {
            column.set_padding((0, GAP));
            if head.get(index).is_some_and(|name| name.starts_with('>')) {
                column.set_cell_alignment(CellAlignment::Right);
            }
        }
        let lines: Vec<String> = table.lines().map(|line| line.trim_end().to_owned()).collect();
        let indent =
            lines.iter().filter(|line| !line.is_empty()).map(|line| line.len() - line.trim_start().len()).min();
        let indent = indent.unwrap_or(0);
        lines.iter().map(|line| format!("{}\n", line.get(indent..).unwrap_or(""))).collect()
    }

    /// Names at the left, what belongs to them at the right.
    pub(super) fn pairs(self, rows: Vec<(&'static str, String)>) -> String {
        self.table(&["", ""], rows.into_iter().map(|(name, text)| vec![self.word(name).to_owned(), text]).collect())
    }

    /// A line of prose, ours or of a drive, in as many lines as the terminal needs.
    pub(super) fn prose(self, text: &str) -> String {
        format!("{}\n", wrap(&clean(text), self.width))
    }

    pub(super) fn heading(self, address: u8, drive: &str) -> String {
        format!("{} {} ({})\n", self.word("drive"), self.address(address), clean(self.family(drive)))
    }

    /// An address as it is typed: `3`, and with a node of the system bus behind it `3.17`.
    pub(super) fn address(self, address: u8) -> String {
        addressed(address, self.node)
    }

    /// One row a value; the address only if there are several drives.
    pub(super) fn values(self, values: &[Value]) -> String {
        self.values_of(&values.iter().map(|value| (None, value)).collect::<Vec<_>>())
    }

    /// The same of drives that have names: these, where there are any, and not the addresses.
    pub(super) fn values_of(self, values: &[(Option<&str>, &Value)]) -> String {
        let named = values.iter().any(|(called, _)| called.is_some());
        let several = values.iter().any(|(_, value)| Some(value.address) != values.first().map(|(_, one)| one.address));
        let several = several || named;
        let rows = values.iter().map(|&(called, value)| {
            let drive = || called.map_or_else(|| self.address(value.address), str::to_owned);
            let mut row = if several { vec![drive()] } else { Vec::new() };
            // Beside its copy in the EEPROM.
            let cell = |called, value: &Value| (called, value.address, value.param, value.data_set);
            let of = |(other, one): &(_, &Value)| cell(*other, one) == cell(called, value) && one.store != value.store;
            let is_copy = values.iter().any(of);
            let is_ram = is_copy && value.data_set == 0 && value.store == "ram";
            row.extend([
                numbered(value.param, value.index),
                if is_ram { "ram".to_owned() } else { set_name(value.data_set, value.store) },
                self.say(&value.name),
                number(value),
                unit(value).to_owned(),
                self.meaning(value),
            ]);
            row
        });
        let drive = if named { "drive" } else { ">addr" };
        let head = [drive, ">param", "set", "name", ">value", "unit", "meaning"];
        self.table(head.get(usize::from(!several)..).unwrap_or_default(), rows.collect())
    }

    /// A value in a few words: number, unit, meaning.
    pub(super) fn short(self, value: &Value) -> String {
        let unit = unit(value);
        let meaning = match (self.meaning(value), &value.error) {
            (meaning, _) if meaning.is_empty() => meaning,
            (meaning, Some(_)) => return meaning,
            (meaning, None) => format!("({meaning})"),
        };
        let words = [number(value), unit.to_owned(), meaning];
        words.into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
    }

    /// What a value stands for: the error, the text, the state and set bits.
    pub(super) fn meaning(self, value: &Value) -> String {
        if let Some(error) = &value.error {
            return error.message.get(self.lang).to_owned();
        }
        let mut parts = Vec::new();
        parts.extend(value.text.as_ref().map(|text| self.say(text)));
        if let Some(word) = &value.word {
            parts.extend(word.state.as_ref().map(|state| self.say(&state.name)));
            parts.push(self.set_bits(word));
        }
        if let Some(expected) = &value.expected {
            parts.push(format!("({}: {} {expected})", self.word("raw, implausible"), self.word("expected")));
        } else if is_unscaled(value) {
            let unit = value.unit.as_ref().map_or_else(String::new, |unit| format!(": {unit}"));
            let why = if value.kind.is_none() { "raw, width not known" } else { "raw, decimals unknown" };
            parts.push(format!("({}{unit})", self.word(why)));
        }
        if value.unconfirmed.iter().any(|field| field == "row") {
            parts.push(format!("({})", self.word("unconfirmed")));
        }
        parts.join(": ")
    }

    pub(super) fn fault(self, fault: &Fault) -> Vec<(&'static str, String)> {
        let mut rows = vec![("fault", self.say(&fault.told()))];
        rows.extend(fault.group.iter().map(|group| ("group", self.say(group))));
        rows.extend(fault.node.iter().map(|node| ("node", node.to_string())));
        rows.extend(fault.cause.iter().map(|cause| ("cause", self.say(cause))));
        rows.extend(fault.remedy.iter().map(|remedy| ("remedy", self.say(remedy))));
        rows
    }

    /// The fault that is present, that there is none, or that nobody can say.
    pub(super) fn fault_or_none(self, fault: Option<&Fault>, code: Option<i64>) -> Vec<(&'static str, String)> {
        match (fault, code) {
            (Some(fault), _) => self.fault(fault),
            (None, Some(_)) => vec![("fault", self.word("none").to_owned())],
            (None, None) => vec![("fault", self.word("could not be read").to_owned())],
        }
    }

    /// What keeps a drive from running.
    pub(super) fn missing(self, missing: &[Text]) -> Vec<(&'static str, String)> {
        let label = |index| if index == 0 { "missing" } else { "" };
        missing.iter().enumerate().map(|(index, text)| (label(index), self.say(text))).collect()
    }

    /// The bits of a word that are set, by their names; a dash where none is.
    pub(super) fn set_bits(self, word: &Word) -> String {
        let set: Vec<_> = word.bits.iter().filter(|bit| bit.set).map(|bit| self.bit(bit)).collect();
        if set.is_empty() { "-".to_owned() } else { set.join(", ") }
    }

    /// Of names with commas between them the first, and how many others there are; on a full page all.
    pub(super) fn first_of(self, names: &str) -> String {
        match names.split_once(", ").filter(|_| !self.full) {
            Some((first, others)) => format!("{first} +{}", others.split(", ").count()),
            None => names.to_owned(),
        }
    }

    pub(super) fn bits(self, bits: &Word) -> String {
        let rows = bits.bits.iter().map(|bit| {
            let unknown = || self.word("unknown").to_owned();
            let name = bit.name.as_ref().map_or_else(unknown, |name| self.say(name));
            vec![bit.bit.to_string(), u8::from(bit.set).to_string(), name]
        });
        self.table(&[">bit", ">value", "name"], rows.collect())
    }
}

pub(super) fn shown(number: Decimal, hex: bool) -> String {
    if hex && (0..=0xFFFF).contains(&number.raw) {
        return format!("0x{:04X}", number.raw);
    }
    format_decimal(number.raw, number.decimals)
}

pub(super) fn number(value: &Value) -> String {
    match (value.value, value.raw) {
        (Some(number), _) => shown(number, value.hex),
        // The bits of a floating point are no number that anybody reads.
        (None, Some(raw)) if value.kind != Some(FLOAT) => raw.to_string(),
        (None, _) => "-".to_owned(),
    }
}

/// A raw number whose decimals nobody knows.
pub(super) fn is_unscaled(value: &Value) -> bool {
    value.value.is_none() && value.raw.is_some() && value.kind != Some(FLOAT)
}

/// The type whose raw integer is its bits.
const FLOAT: &str = "float";

/// The unit of the number that is shown; a raw one is in none.
pub(super) fn unit(value: &Value) -> &str {
    value.unit.as_deref().filter(|_| !is_unscaled(value)).unwrap_or("")
}

/// `2`, or `2ram`; volatile parameters have no EEPROM set.
pub(super) fn set_name(set: u8, store: &str) -> String {
    if store == "ram" && set > 0 { format!("{set}ram") } else { set.to_string() }
}
