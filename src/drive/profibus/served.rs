//! A slave that a conversation of the other lines asks: whoever keeps it going takes its questions out of a mailbox, one after the other,
//! so that reading, writing with proof and transactions are the same as everywhere.

use super::exchange::Exchange;
use crate::exchange::dp::{Place, Request, Told};
use crate::failure::{Class, Failure};
use crate::protocol::dp::pkw::{self, Pkw, Task};
use crate::transport::Mailbox;
use std::convert::Infallible;
use std::pin::pin;

/// Answers as a slave gives them (SJ2-PB manual 4.1.1): a value, the element of an array, no, no right.
const VALUE: u8 = 2;
const ELEMENT: u8 = 5;
const REFUSED: u8 = 7;
const NO_RIGHT: u8 = 8;

impl Exchange<'_, '_> {
    /// The port that it is behind, for work that asks through it.
    pub fn mailbox(&self) -> Mailbox {
        Mailbox::new(self.line.name().0, self.line.now())
    }

    /// Keeps the slave going as long as the work lasts, and puts to it what the work asks. What was done, and why the exchange ended before
    /// it: then the work was told that the port is lost, or the slave. Who interrupts means the work.
    pub async fn serve<T>(&mut self, mailbox: &Mailbox, work: impl Future<Output = T>) -> (T, Option<Failure>) {
        let mut work = pin!(work);
        let mut lost = None;
        self.insists = true;
        let done = {
            let mut kept = pin!(self.keep(mailbox));
            loop {
                tokio::select! {
                    biased;
                    done = &mut work => break done,
                    Err(why) = &mut kept, if lost.is_none() => {
                        match why.class {
                            Class::Port => mailbox.lose(),
                            _ => mailbox.fall_silent(why.told()),
                        }
                        lost = Some(why);
                    }
                }
            }
        };
        self.insists = false;
        self.pkw = Pkw::default();
        (done, lost)
    }

    async fn keep(&mut self, mailbox: &Mailbox) -> Result<Infallible, Failure> {
        loop {
            // The time of a bench that is not paced passes for who waits for it.
            if self.line.stands_still() {
                mailbox.wanted().await;
            }
            match mailbox.take() {
                Some(question) => {
                    if let Some(answer) = self.answer(&question).await? {
                        mailbox.put(answer);
                    }
                }
                None => drop(self.cycle().await?),
            }
            mailbox.passes(self.line.now());
        }
    }

    /// What comes of a question; nothing where the slave is silent.
    async fn answer(&mut self, question: &[u8]) -> Result<Option<Vec<u8>>, Failure> {
        let block = question.split_first().and_then(|(_, block)| <&[u8; pkw::LENGTH]>::try_from(block).ok());
        let Some(asked) = block.map(Pkw::decode) else { return Ok(None) };
        let task = Task::of(asked.ak);
        let at = Place::of(asked.pnu.into(), task.has_element().then(|| asked.sub_index()));
        let request = match task.writes() {
            true => Request::write(at, asked.pwe as u16, self.line.now()),
            false => Request::read(at, self.line.now()),
        };
        let (ak, pwe) = match self.request(request).await? {
            Told::Value(bits) => (if task.has_element() { ELEMENT } else { VALUE }, bits),
            Told::Refused(pwe) => (REFUSED, pwe),
            Told::NoRight => (NO_RIGHT, 0),
            Told::Silence => return Ok(None),
        };
        let said = Pkw { ak, pnu: asked.pnu, ind: asked.ind, pwe, ..Pkw::default() };
        Ok(Some([&[self.address()], &said.encode()[..]].concat()))
    }
}
