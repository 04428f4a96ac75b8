//! What is said of cells: what is said of many is one note.

use super::ranges;
use crate::text::{Text, both};

/// What is said of some cells, and these with their lines.
pub(super) struct Odd {
    pub(super) what: Text,
    pub(super) cells: Vec<(usize, String)>,
}

impl Odd {
    /// So many cells are shown.
    const SHOWN: usize = 3;

    pub(super) fn told(&self) -> Text {
        let mut cells: Vec<&str> = Vec::new();
        for (_, cell) in &self.cells {
            if !cells.contains(&&**cell) {
                cells.push(cell);
            }
        }
        let more = if cells.len() > Self::SHOWN { ", …" } else { "" };
        let cells = cells.iter().take(Self::SHOWN).map(|cell| format!("'{cell}'")).collect::<Vec<_>>().join(", ");
        let (what, count) = (&self.what, self.cells.len());
        let lines = ranges(self.cells.iter().filter_map(|(line, _)| u32::try_from(*line).ok()));
        if count == 1 {
            return both!("line {lines}: {cells}: {what}", "Zeile {lines}: {cells}: {what}", lines, cells, what);
        }
        let (line, zeile) = if lines.contains([',', '-']) { ("lines", "Zeilen") } else { ("line", "Zeile") };
        both!(
            "{line} {lines}, {count} cells ({cells}{more}): {what}",
            "{zeile} {lines}, {count} Zellen ({cells}{more}): {what}",
            what
        )
    }
}
