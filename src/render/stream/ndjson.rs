//! One object a line, flushed.

use super::Form;
use crate::outcome::Record;
use crate::render::spoken::spoken;
use crate::text::Lang;
use std::io::{self, Write};

pub(super) struct Ndjson<'a> {
    out: Box<dyn Write + 'a>,
    lang: Lang,
}

impl<'a> Ndjson<'a> {
    pub(super) fn new(out: Box<dyn Write + 'a>, lang: Lang) -> Self {
        Ndjson { out, lang }
    }
}

impl Form for Ndjson<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        // In one piece: a line must not be cut in two by whoever reads while it is written.
        let mut line = serde_json::to_vec(&spoken(record, self.lang)?)?;
        line.push(b'\n');
        self.out.write_all(&line)?;
        self.out.flush()
    }
}
