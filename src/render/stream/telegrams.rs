//! One line a telegram as it comes, for people.

use super::Form;
use crate::outcome::{Record, TelegramDoc};
use crate::profile::value::format_decimal;
use crate::render::clean;
use crate::render::finding::direction;
use crate::text::Lang;
use std::io::{self, Write};

/// Milliseconds of a day, with three places.
const TIME: usize = 12;
/// Eight bytes, the usual question of Modbus RTU.
const BYTES: usize = 23;

pub(super) struct Telegrams<'a> {
    out: &'a mut dyn Write,
    lang: Lang,
}

impl<'a> Telegrams<'a> {
    pub(super) fn new(out: &'a mut dyn Write, lang: Lang) -> Self {
        Telegrams { out, lang }
    }

    fn line(&mut self, doc: &TelegramDoc) -> io::Result<()> {
        let at = doc.at_us.map_or_else(String::new, |us| format_decimal(us as i64, 3));
        let (sign, meaning) = (direction(doc), clean(doc.meaning.get(self.lang)));
        writeln!(self.out, "{at:>TIME$}  {sign}  {:<BYTES$}  {meaning}", doc.hex)?;
        self.out.flush()
    }
}

impl Form for Telegrams<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Telegram(telegram) => self.line(telegram),
            _ => Ok(()),
        }
    }
}
