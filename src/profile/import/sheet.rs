//! A file of a spreadsheet: bytes to text, text to cells (RFC 4180, and what Excel makes of it).

use std::borrow::Cow;

/// A line of cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Record {
    /// Line in the file where it begins, from 1.
    pub(super) line: usize,
    pub(super) cells: Vec<String>,
}

impl Record {
    pub(super) fn cell(&self, column: usize) -> &str {
        self.cells.get(column).map_or("", String::as_str)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.cells.iter().all(String::is_empty)
    }
}

/// The characters 0x80 to 0x9F of Windows-1252; the rest of it is Latin-1.
const WINDOWS: &str = "€\u{FFFD}‚ƒ„…†‡ˆ‰Š‹Œ\u{FFFD}Ž\u{FFFD}\u{FFFD}‘’“”•–—˜™š›œ\u{FFFD}žŸ";

/// The text of a file, and how it was written. What is no UTF-8 is what Excel writes in western Europe; where lines end as on old
/// Macs, which Excel still writes, they end as everywhere.
pub(super) fn text_of(bytes: &[u8]) -> (Cow<'_, str>, &'static str) {
    let (text, encoding) = decoded(bytes);
    match text.contains('\r') && !text.contains('\n') {
        true => (Cow::Owned(text.replace('\r', "\n")), encoding),
        false => (text, encoding),
    }
}

fn decoded(bytes: &[u8]) -> (Cow<'_, str>, &'static str) {
    let wide = |bytes: &[u8], word: fn([u8; 2]) -> u16| {
        let words: Vec<u16> = bytes.chunks_exact(2).map(|pair| word([pair[0], pair[1]])).collect();
        (Cow::Owned(String::from_utf16_lossy(&words)), "UTF-16")
    };
    match bytes {
        [0xFF, 0xFE, rest @ ..] => return wide(rest, u16::from_le_bytes),
        [0xFE, 0xFF, rest @ ..] => return wide(rest, u16::from_be_bytes),
        _ => {}
    }
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => (Cow::Borrowed(text), "UTF-8"),
        Err(_) => (Cow::Owned(bytes.iter().map(|&byte| western(byte)).collect()), "Windows-1252"),
    }
}

fn western(byte: u8) -> char {
    match byte {
        0x80..=0x9F => WINDOWS.chars().nth(usize::from(byte) - 0x80).unwrap_or('\u{FFFD}'),
        _ => char::from(byte),
    }
}

/// What parts the cells: said by the file (`sep=;`), or what parts most lines into the same number of cells.
pub(super) fn separator_of(text: &str) -> Option<char> {
    if let Some(said) = text.lines().next().and_then(|line| line.strip_prefix("sep=")) {
        return said.chars().next();
    }
    let alike = |separator: char| {
        let mut counts = std::collections::BTreeMap::<usize, usize>::new();
        for record in records(text, separator).take(200).filter(|record| !record.is_empty()) {
            *counts.entry(record.cells.len()).or_default() += 1;
        }
        counts.into_iter().filter(|(cells, _)| *cells > 1).map(|(_, lines)| lines).max().unwrap_or(0)
    };
    let best = [',', '\t', ';'].into_iter().max_by_key(|separator| alike(*separator))?;
    (alike(best) > 0).then_some(best)
}

/// The lines of cells. Line ends, tabs and other control characters inside quotes are blanks: nothing of a cell may break out
/// of where it is shown.
pub(super) fn records(text: &str, separator: char) -> impl Iterator<Item = Record> + '_ {
    let mut letters = text.chars().peekable();
    let mut line = 1;
    let said = text.starts_with("sep=");
    let lines = std::iter::from_fn(move || {
        letters.peek()?;
        let mut record = Record { line, cells: Vec::new() };
        let (mut cell, mut quoted) = (String::new(), false);
        loop {
            let letter = letters.next();
            line += usize::from(letter == Some('\n'));
            match letter {
                Some('"') if quoted && letters.peek() == Some(&'"') => cell.extend(letters.next()),
                Some('"') if quoted => quoted = false,
                Some('"') if cell.trim().is_empty() => (quoted, cell) = (true, String::new()),
                Some(letter) if letter == separator && !quoted => record.cells.push(tidy(&std::mem::take(&mut cell))),
                Some('\n') | None if !quoted || letter.is_none() => {
                    record.cells.push(tidy(&cell));
                    return Some(record);
                }
                Some(letter) => cell.push(letter),
                None => return None,
            }
        }
    });
    lines.skip(usize::from(said))
}

/// A text without blanks around it, control characters, the blanks that no keyboard has, and what nobody sees.
pub(super) fn tidy(cell: &str) -> String {
    let unseen = |letter: &char| matches!(letter, '\u{AD}' | '\u{200B}'..='\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2060}'..='\u{206F}' | '\u{FEFF}');
    let plain = |letter: char| if letter.is_control() || letter.is_whitespace() { ' ' } else { letter };
    cell.chars().filter(|letter| !unseen(letter)).map(plain).collect::<String>().trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(text: &str, separator: char) -> Vec<(usize, Vec<String>)> {
        records(text, separator).map(|record| (record.line, record.cells)).collect()
    }

    #[test]
    fn quotes_hold_separators_quotes_and_line_ends() {
        let told = cells("a;b\r\n\"x;\"\"y\"\"\";\"two\nlines\"\n\nlast;", ';');
        let expected = [(1, vec!["a", "b"]), (2, vec!["x;\"y\"", "two lines"]), (4, vec![""]), (5, vec!["last", ""])];
        assert_eq!(told, expected.map(|(line, cells)| (line, cells.into_iter().map(str::to_owned).collect())));
        assert_eq!(cells("\"never closed;1\n2", ';').len(), 1);
        assert_eq!(cells("sep=;\na;b\n", ';'), [(2, vec!["a".to_owned(), "b".to_owned()])]);
    }

    #[test]
    fn bytes_are_what_excel_writes() {
        assert_eq!(text_of(b"\xEF\xBB\xBFa"), ("a".into(), "UTF-8"));
        assert_eq!(text_of(b"W\xE4rme \x80 \x96"), ("Wärme € –".into(), "Windows-1252"));
        assert_eq!(text_of(b"\xFF\xFEa\0;\0"), ("a;".into(), "UTF-16"));
    }

    #[test]
    fn what_parts_the_cells_is_what_parts_all_lines_alike() {
        assert_eq!(separator_of("Liste, Stand 1,2\nNr;Wert\n1;0,5\n2;1,5\n"), Some(';'));
        assert_eq!(separator_of("id,name\n1,x\n"), Some(','));
        assert_eq!(separator_of("id\tname\n1\tx, y\n2\tz\n"), Some('\t'));
        assert_eq!(separator_of("sep=|\n1|2"), Some('|'));
        assert_eq!(separator_of("one\ntwo\n"), None);
    }
}
