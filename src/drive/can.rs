//! A CAN bus as a line of a session: the channel of an adapter is opened, the bus is listened to, and what would disturb others ends it
//! before anything is sent.

pub(super) mod trouble;

use super::interrupt::Interrupt;
use super::pump;
use super::{AccessError, Opening};
use crate::exchange::can::{Channel, Ear, Opened, Opening as Conversation, Overheard, Traffic, Unopened};
use crate::failure::Failure;
use crate::outcome::Event;
use crate::protocol::can::slcan::Word;
use crate::protocol::can::{MASTER_STATION, SdoChannel};
use crate::text::{Text, both};
use crate::transport::{Ailing, Between, Link, LinkError};
use std::cell::RefCell;
use std::rc::Rc;

/// Opens the bus behind an adapter for SDOs over one of their channels.
pub(super) async fn open(
    link: &mut Link,
    opening: &Opening<'_>,
    channel: SdoChannel,
    interrupt: &Interrupt,
    observe: &mut dyn FnMut(Event),
) -> Result<Heard, Failure> {
    let (port, bit_rate) = (opening.port.to_string(), opening.line.baud);
    let rate = number(bit_rate).ok_or_else(|| trouble::bit_rate(bit_rate))?;
    let opened = opened(&mut Conversation::new(rate), link, interrupt).await;
    let opened = opened.map_err(|error| error.failure(0, None))?;
    let opened = opened.map_err(|why| trouble::unopened(&port, bit_rate, &why))?;
    let masters = (channel == SdoChannel::One).then(|| {
        both!(
            "SDO1 is the master's (EM-RES-03 5.9.4): it is used because nobody was heard who could be one",
            "SDO1 gehört dem Master (EM-RES-03 5.9.4): benutzt wird er, weil keiner zu hören war"
        )
    });
    for note in notes(&port, &opened).into_iter().chain(masters) {
        observe(Event::Note(note));
    }
    let why = forbidden(&opened.traffic, channel);
    let heard = Rc::new(RefCell::new(opened.traffic));
    link.put_between(Box::new(Channel::new(channel, heard.clone())));
    if let Some(why) = why {
        link.part();
        return Err(why);
    }
    Ok(heard)
}

/// Carries an opening through. Whatever ends it early (a signal, a bit rate that is another one) leaves no channel open: an adapter whose
/// program is gone would go on to take part in the bus.
async fn opened(
    opening: &mut Conversation,
    link: &mut Link,
    interrupt: &Interrupt,
) -> Result<Result<Opened, Unopened>, AccessError> {
    let end = pump::run(opening, link, interrupt, None).await;
    if !matches!(end, Ok(Ok(_))) {
        close(link);
    }
    Ok(end?)
}

/// Closes the channel of an adapter where nothing speaks over it so far.
pub(super) fn close(link: &mut Link) {
    link.push(Channel::farewell());
}

/// Opens the bus behind an adapter to listen only.
pub(super) async fn listen(
    link: &mut Link,
    opening: &Opening<'_>,
    interrupt: &Interrupt,
    observe: &mut dyn FnMut(Event),
) -> Result<Ears, Failure> {
    let (port, bit_rate) = (opening.port.to_string(), opening.line.baud);
    let rate = number(bit_rate).ok_or_else(|| trouble::bit_rate(bit_rate))?;
    let opened = opened(&mut Conversation::listening(rate), link, interrupt).await;
    let opened = opened.map_err(|error| error.failure(0, None))?;
    let opened = opened.map_err(|why| trouble::unopened(&port, bit_rate, &why))?;
    notes(&port, &opened).into_iter().for_each(|note| observe(Event::Note(note)));
    let overheard = Ears::default();
    link.put_between(Box::new(Ear::new(overheard.clone())));
    Ok(overheard)
}

/// What is heard where nobody is asked.
pub(super) type Ears = Rc<RefCell<Overheard>>;

/// What is heard on a bus, from before the first question on.
pub(super) type Heard = Rc<RefCell<Traffic>>;

/// Opens it again behind an adapter that was lost, where the same holds.
pub(super) async fn reopen(
    link: &mut Link,
    bit_rate: u32,
    channel: SdoChannel,
    interrupt: &Interrupt,
) -> Result<(), AccessError> {
    link.part();
    link.reopen().await?;
    let again = match number(bit_rate) {
        Some(rate) => opened(&mut Conversation::new(rate), link, interrupt).await?.ok(),
        None => None,
    };
    if again.is_none_or(|opened| forbidden(&opened.traffic, channel).is_some()) {
        close(link);
        return Err(LinkError::Unsent(link.adapter().name).into());
    }
    link.put_between(Box::new(Channel::new(channel, Heard::default())));
    Ok(())
}

/// Speaks over another channel, or at another bit rate, from now on. At another rate the adapter is closed and the bus listened to before
/// anything is sent; what was heard so far counts no more. [`LinkError::Unacknowledged`] where errors and no frame are heard there: then it
/// is somebody else's rate, and the channel is closed.
pub(super) async fn retune(
    link: &mut Link,
    channel: SdoChannel,
    bit_rate: Option<u32>,
    heard: &Heard,
    interrupt: &Interrupt,
) -> Result<(), AccessError> {
    let mut why = None;
    if let Some(bit_rate) = bit_rate {
        link.part();
        let rate = number(bit_rate).ok_or(AccessError::Unspeakable)?;
        match opened(&mut Conversation::new(rate), link, interrupt).await? {
            Ok(opened) => *heard.borrow_mut() = opened.traffic,
            Err(told) => {
                let port = link.adapter().name;
                why = Some(match told {
                    Unopened::Errors(flags) => LinkError::Unacknowledged { port, flags },
                    _ => LinkError::Unsent(port),
                });
            }
        }
    }
    link.put_between(Box::new(Channel::new(channel, heard.clone())));
    why.map_or(Ok(()), |why| Err(why.into()))
}

/// Whether a station stands for the drive that is the master, which has node 0.
pub(super) fn is_master(station: u8) -> bool {
    station == MASTER_STATION
}

/// The number of a bit rate in SLCAN.
fn number(bit_rate: u32) -> Option<u8> {
    match Word::rate(bit_rate) {
        Some(Word::Rate(number)) => Some(number),
        _ => None,
    }
}

/// What is to be known of the adapter.
fn notes(port: &str, opened: &Opened) -> Vec<Text> {
    let mute = opened.is_mute.then(|| {
        both!(
            "{port}: the adapter acknowledges nothing; if nobody answers, perhaps it is none that speaks SLCAN",
            "{port}: der Adapter bestätigt nichts; antwortet niemand, so ist er vielleicht keiner, der SLCAN spricht"
        )
    });
    let acknowledged = opened.acknowledged.then(|| {
        both!(
            "{port}: the adapter cannot only listen, so it took part in the bus while it was listened to",
            "{port}: der Adapter kann nicht nur zuhören und nahm deshalb schon beim Zuhören am Bus teil"
        )
    });
    mute.into_iter().chain(acknowledged).collect()
}

/// Why nobody may be asked over a channel, if so: it belongs to who was heard.
pub(super) fn forbidden(traffic: &Traffic, channel: SdoChannel) -> Option<Failure> {
    match channel {
        SdoChannel::Two if traffic.asks(channel) => Some(trouble::other_tool()),
        SdoChannel::One if traffic.asks(channel) || traffic.has_master => Some(trouble::other_master()),
        _ => None,
    }
}

impl Between for Ear {
    fn put(&mut self, _telegram: &[u8]) -> Vec<u8> {
        Ear::asks()
    }

    fn take(&mut self, said: &[u8]) -> Vec<u8> {
        Ear::take(self, said)
    }

    fn ailing(&mut self) -> Option<Ailing> {
        None
    }

    fn farewell(&self) -> &'static [u8] {
        Channel::farewell()
    }
}

impl Between for Channel {
    fn put(&mut self, telegram: &[u8]) -> Vec<u8> {
        Channel::put(self, telegram)
    }

    fn take(&mut self, said: &[u8]) -> Vec<u8> {
        Channel::take(self, said)
    }

    fn ailing(&mut self) -> Option<Ailing> {
        match self.refused() {
            true => Some(Ailing::Unsent),
            false => self.ails().map(Ailing::Unacknowledged),
        }
    }

    fn farewell(&self) -> &'static [u8] {
        Channel::farewell()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;
    use crate::simulator::Can;
    use crate::transport::witness;

    /// An adapter whose channel stays open takes part in the bus for nobody.
    #[test]
    fn a_channel_is_closed_whenever_its_opening_is_interrupted() {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        let registry = Registry::open(&[]).unwrap();
        let mut was_open = false;
        witness::call(true);
        for moment in 0..40 {
            runtime.block_on(async {
                let mut link = Link::open_can(Can::standard(&registry));
                let interrupt = Interrupt::default();
                let signal = async {
                    for _ in 0..moment {
                        tokio::task::yield_now().await;
                    }
                    interrupt.raise();
                };
                let mut opening = Conversation::new(6);
                let (end, ()) = tokio::join!(opened(&mut opening, &mut link, &interrupt), signal);
                match end {
                    Err(AccessError::Interrupted) => {}
                    end => {
                        was_open = true;
                        end.unwrap().unwrap();
                        close(&mut link);
                    }
                }
            });
            assert!(!witness::left_can().unwrap().is_open(), "{moment}");
        }
        assert!(was_open, "none was over before it was interrupted");
    }
}
