//! What a sheet of paper holds, whatever it is written in. Everything is text of one language; nothing is markup yet.

use crate::outcome::Logo;

/// A report, part by part.
#[derive(Debug, Default)]
pub(super) struct Paper {
    /// `en`, `de`.
    pub(super) lang: &'static str,
    pub(super) title: String,
    pub(super) logo: Option<Logo>,
    pub(super) blocks: Vec<Block>,
    /// What stands at the foot.
    pub(super) foot: String,
}

/// A part.
#[derive(Debug)]
pub(super) enum Block {
    /// A heading; of the first level each begins a sheet but the first.
    Heading(u8, String),
    /// Names, and what belongs to them.
    Facts(Vec<(String, String)>),
    Table(Table),
    Text(String),
    /// Items of a list.
    List(Vec<String>),
    /// Something that nobody may overlook.
    Alarm(String),
    /// A picture in SVG, and what it shows.
    Picture(String, String),
    /// Lines to write on, each with what goes there.
    Lines(Vec<[String; 3]>),
}

/// A table.
#[derive(Debug, Default)]
pub(super) struct Table {
    /// Names of the columns; those that are aligned to the right.
    pub(super) head: Vec<(String, bool)>,
    pub(super) rows: Vec<Vec<Cell>>,
}

/// A cell.
#[derive(Debug)]
pub(super) struct Cell {
    pub(super) text: String,
    /// Over so many columns.
    pub(super) span: usize,
    /// It differs from what is usual.
    pub(super) is_marked: bool,
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Cell { text, span: 1, is_marked: false }
    }
}
