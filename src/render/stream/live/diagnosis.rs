//! The diagnosis of a run: everything that the last looks told, in words, and what was said on the way. It asks nothing.

use super::past::Drive;
use super::screen::Screen;
use crate::render::clean;
use crate::render::stream::cells::{Board, GAP, find, long, number, short};
use crate::render::wrap::wrap;
use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::widgets::Paragraph;

impl Screen {
    pub(super) fn diagnosis(&self, frame: &mut Frame<'_>, area: Rect, drive: &Drive) {
        let value = |role: &str| {
            let column = drive.about.columns.iter().find(|column| column.role == Some(role))?;
            Some((column, find(column, drive.last.as_ref()?)?))
        };
        let state = drive.last.as_ref().and_then(|sample| sample.state.as_ref());
        let state = state.map_or(GAP, |state| state.name.get(self.lang)).to_owned();
        let mut rows = vec![(self.word("state"), state)];
        let board = Board { columns: drive.about.columns.clone() };
        let drawn: Vec<_> = drive.drawn.iter().filter_map(|index| board.columns.get(*index)).collect();
        let labels: Vec<String> = drawn.iter().map(|column| board.label(column, self.lang)).collect();
        for (column, label) in drawn.into_iter().zip(&labels) {
            let value = drive.last.as_ref().and_then(|sample| find(column, sample)).map_or(GAP.to_owned(), number);
            let unit = column.unit.as_deref().unwrap_or("");
            rows.push((label, format!("{value} {unit}").trim_end().to_owned()));
        }
        for role in ["fault", "warnings"] {
            rows.extend(value(role).map(|(column, value)| (self.word(role), long(column, value, self.lang))));
        }
        if let Some((column, status)) = value("status-word") {
            let set = status.word.iter().flat_map(|word| &word.bits).filter(|bit| bit.set);
            let name = |bit: &crate::outcome::Bit| {
                bit.name.as_ref().map_or_else(|| bit.bit.to_string(), |name| name.get(self.lang).to_owned())
            };
            let set: Vec<_> = set.map(name).collect();
            rows.push((
                self.word("status word"),
                format!("{}  {}", short(column, Some(status), self.lang), set.join(", ")),
            ));
        }
        let rows = rows.into_iter().map(|(label, text)| format!(" {label}: {text}"));
        // The last one stands below.
        let said = self.notes.iter().rev().filter(|note| **note != self.note && **note != self.alarm);
        let notes = said.map(|note| format!(" {note}"));
        let shown = rows.chain([String::new()]).chain(notes).map(|line| wrap(&clean(&line), Some(area.width)));
        frame.render_widget(Paragraph::new(shown.collect::<Vec<_>>().join("\n")), area);
    }
}
