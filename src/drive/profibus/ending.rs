//! The only end of an exchange: the stop word with control kept until the frequency is 0, then what was lent is given back, then zero
//! outputs, Clear, Unlock. Zero outputs alone are no stop.
//!
//! Outputs of zero give start and setpoint to the terminals: in Basic mode always (3.2.2), in ProfiDrive mode perhaps (bit 10, 4.1.2.1). So
//! in Basic mode a motor that turned before we had it gets none, and one that zero outputs start is stopped again: such a slave is let go under
//! the stop word, and that is a failure.

use super::exchange::{Exchange, LOST, Lent, RIGHT, TO_TERMINALS};
use super::mode::{Seen, Words};
use super::trouble;
use crate::drive::panel::Lingering;
use crate::drive::{Panel, Stays, last_told};
use crate::exchange::dp::{Cycle, Place, Request};
use crate::failure::Failure;
use crate::outcome::{Change, Event, Warning};
use crate::protocol::dp::pkw::Pkw;
use crate::text::Text;
use crate::tick::{Span, Tick};

/// So long a frequency may stay as it is before something stronger is done, and then before the stop is given up.
const STUCK: Span = Span::from_secs(10);
/// A frequency that stays for so long is told, because somebody may have to stop the motor otherwise.
const DEAF: Span = Span::from_secs(3);
/// So often what goes back is said again where nothing was answered.
const SAID_AGAIN: u8 = 2;
/// So long at least the stop of a motor goes out where nobody is heard.
pub(super) const INSISTED: Span = Span::from_secs(6);
/// So long a slave that is ours is led to its first exchange, so that the stop word comes to it.
const LED: Span = Span::from_secs(2);
/// So long a motor is watched whose control was given back.
const WATCHED: Span = Span::from_millis(500);
/// The output frequency, 0.01 Hz (5.3).
const FREQUENCY: Place = Place { pnu: 614, element: None };

/// How an exchange ended.
#[derive(Debug, Default)]
pub struct Ending {
    /// The stop word went out until the frequency was 0.
    pub is_dark: bool,
    /// Whether the shaft stands; `None` where nothing tells.
    pub standing: Option<bool>,
    /// OFF3 went out.
    pub coasted: bool,
    /// Somebody interrupted the own end of a run.
    pub hastened: bool,
    /// A frequency was seen.
    pub has_turned: bool,
    /// What was changed for its time.
    pub changed: Vec<Change>,
    /// What came under the stop word last.
    pub seen: Option<Seen>,
    /// Nothing has come since: what the motor does now is not known.
    pub is_lost: bool,
    /// What is to be known of it besides.
    pub notes: Vec<Text>,
    /// What decides on the motor without us, as it stands now.
    pub parting: Option<Text>,
    /// Another master was active on the line.
    pub beside: Option<Warning>,
    /// Why it is no good end.
    pub failure: Option<Failure>,
}

impl Ending {
    /// What is to be known of it besides, behind what decides on the motor once the slave is let go.
    pub fn warnings(&self, parting: Option<Text>) -> Vec<Warning> {
        let parting = parting.map(|message| Warning { code: "profibus.let_go".to_owned(), message });
        parting.into_iter().chain(self.beside.clone()).collect()
    }
}

impl Exchange<'_, '_> {
    /// Who else was heard on the line, and what went out beside him.
    fn told_beside(&self) -> Option<Warning> {
        self.line.fdl.beside().map(|master| self.beside.told(master))
    }

    /// Stops the motor, proves it, and lets the slave go. Nobody's interrupt from before keeps it from that; one that comes
    /// meanwhile lets a motor that we have started coast.
    pub async fn leave(mut self) -> Ending {
        self.insists();
        self.line.note_interrupts();
        self.words = self.mode().coast().filter(|_| self.still.coasts).unwrap_or(self.mode().stop());
        self.pkw = Pkw::default();
        if !self.station.is_owned() {
            return Ending { beside: self.told_beside(), ..Ending::default() };
        }
        self.comes_to("stopping", None);
        let mut stopped = match self.stop().await {
            Err(why) if self.ours && why.code != trouble::NOT_STILL => {
                Err(trouble::unreached(why, self.mode(), self.behind))
            }
            done => done,
        };
        if let Some((panel, stays, why)) = self.stays.take()
            && (stopped.is_ok() || is_turning(&stopped))
        {
            let told = match (&stopped, self.still.standing()) {
                (Err(failure), _) => Failure { alarm: true, ..failure.clone() }.told_whole(),
                (Ok(()), None) => trouble::off(),
                (Ok(()), standing) => last_told(standing == Some(true)),
            };
            // The danger first.
            let mut told: Vec<Text> = why.into_iter().chain([told]).collect();
            if stopped.is_err() {
                told.reverse();
            }
            let told = Text::join(&told, "; ");
            self.lingers(Lingering::new(panel, stays, self.line.now()), told).await;
            // Meanwhile it may have begun to turn. Who is lost behind a stop that was proven is told as lost by what comes next.
            if stopped.is_ok()
                && let Err(why) = self.stop().await
                && why.code == trouble::NOT_STILL
            {
                stopped = Err(why);
            }
        }
        let returned = if stopped.is_ok() { self.give_back().await } else { Ok(()) };
        let seen = self.seen;
        let released = self.release(stopped.is_ok()).await;
        // Whoever was started as he was let go, and did not stop again, turns.
        let is_dark = [&stopped, &released].iter().all(|done| !is_turning(done)) && stopped.is_ok();
        let is_lost = self.is_lost;
        let standing = self.still.standing().filter(|stands| if *stands { is_dark } else { !is_lost });
        Ending {
            is_dark: is_dark && seen.is_some(),
            standing,
            coasted: self.still.coasts,
            hastened: self.hastened,
            has_turned: self.still.has_turned(),
            changed: self.lent.iter().map(changed).collect(),
            seen,
            is_lost,
            notes: std::mem::take(&mut self.notes),
            parting: self.parting_now(),
            beside: self.told_beside(),
            failure: stopped.and(returned).and(released).err(),
        }
    }

    /// The view of the run stays behind its end, under the stop word, for whoever looks at it. `why` is what went wrong with it.
    pub fn stays(&mut self, panel: Panel, stays: Stays, why: Option<Text>) {
        self.stays = Some((panel, stays, why));
    }

    /// From here on the end goes out, for a while also where nobody is heard.
    pub(super) fn insists(&mut self) {
        (self.insists, self.ends) = (true, None);
        if self.ours {
            self.at_least = self.line.now() + INSISTED;
            self.line.fdl.insist();
        }
    }

    async fn release(&mut self, is_still: bool) -> Result<(), Failure> {
        // Outputs that were never ours are not set to zero either.
        let is_still = is_still && self.seen.is_some();
        let handed = if is_still { self.hand_over().await? } else { Ok(()) };
        self.station.release(is_still && handed.is_ok());
        while self.cycle().await? != Cycle::Released {}
        handed
    }

    /// Outputs of zero. The inner failure: the terminals would have the motor turn, and the stop word stands instead.
    async fn hand_over(&mut self) -> Result<Result<(), Failure>, Failure> {
        let is_basic = self.mode().is_basic();
        if is_basic && self.driven {
            return Ok(Err(trouble::kept_from_terminals(self.address())));
        }
        self.words = Words { stw: 0, hsw: 0 };
        if !is_basic && !self.ours && !self.driven {
            // Nobody had it turn.
            self.cycle().await?;
        } else if self.starts_by_itself().await? {
            self.words = self.mode().stop();
            self.stop().await?;
            return Ok(Err(trouble::started_by_terminals(self.address())));
        }
        Ok(Ok(()))
    }

    /// Proves under the stop word that the output is off, by HIW and by P.614, where that is told.
    pub(super) async fn stop(&mut self) -> Result<(), Failure> {
        if !self.is_reached().await {
            self.notes.push(trouble::never_reached(self.address()));
            return Ok(());
        }
        let mut moved: (Option<i32>, Tick) = (None, self.line.now());
        // What P.614 tells where HIW is 0, and whether it was told that the frequency stays.
        let (mut told, mut is_told) = (None, false);
        loop {
            let Cycle::Inputs(_) = self.cycle().await? else { continue };
            let now = self.line.now();
            if self.still.is_dark(now) {
                told = self.told_frequency().await?;
                if told.is_none_or(|frequency| frequency == 0) {
                    return Ok(());
                }
            }
            let frequency = self.seen.map(|seen| seen.hiw);
            if moved.0 != frequency {
                moved = (frequency, now);
            } else if now.since(moved.1) > STUCK {
                let unproven = trouble::unproven(self.address(), self.seen, told);
                if !self.ours || self.still.coasts || self.mode().is_basic() {
                    return Err(unproven);
                }
                self.take_power();
                let message = Text::join([&trouble::coasts_instead(), &unproven.message], "; ");
                self.tell(Event::Note(Failure { message, ..unproven }.told_whole()));
                moved.1 = now;
            } else if self.ours && now.since(moved.1) > DEAF && !std::mem::replace(&mut is_told, true) {
                self.tell(Event::Note(trouble::unproven(self.address(), self.seen, told).told_whole()));
            }
        }
    }

    /// Whether words of ours come to the slave. One that is ours since a moment ago may have a motor that turns from before, so it is led
    /// to its first exchange.
    async fn is_reached(&mut self) -> bool {
        let until = self.line.now() + LED;
        while self.seen.is_none() && self.line.now() < until && self.cycle().await.is_ok() {}
        self.seen.is_some()
    }

    /// What P.614 tells. Where it is refused, HIW alone has told.
    async fn told_frequency(&mut self) -> Result<Option<u32>, Failure> {
        Ok(self.read(FREQUENCY).await?.ok().map(|frequency| frequency & 0xFFFF))
    }

    /// Changes a parameter for the time of the exchange.
    pub(super) async fn lend(&mut self, index: u16, new: u16) -> Result<(), Failure> {
        self.lend_place(Place { pnu: index, element: None }, new).await
    }

    /// The same of an element.
    pub(super) async fn lend_place(&mut self, place: Place, new: u16) -> Result<(), Failure> {
        let index = place.pnu;
        let old = self.read(place).await??;
        let old = u16::try_from(old & 0xFFFF).unwrap_or_default();
        if old == new {
            return Ok(());
        }
        // From here on it is to be given back, whatever becomes of it.
        let stays = index == RIGHT && !self.still.is_dark(self.line.now());
        self.lent.push(Lent { place, old, new, restored: false, stays });
        self.set(place, new).await?;
        if index == LOST {
            self.behind = Some(new.into());
        }
        Ok(())
    }

    /// Gives back what was lent, the last of it first.
    async fn give_back(&mut self) -> Result<(), Failure> {
        for at in (0..self.lent.len()).rev() {
            let Some(&Lent { place, old, new, stays, .. }) = self.lent.get(at) else { continue };
            if stays {
                self.notes.push(trouble::right_stays());
                continue;
            }
            // Who would start it as soon as he may, may as soon as it is let go.
            if place.pnu == LOST && u32::from(old) == TO_TERMINALS && self.keeps_right() {
                self.notes.push(trouble::loss_stays(new));
                continue;
            }
            self.sets_back(place, old).await?;
            let starts = place.pnu == RIGHT && self.starts_by_itself().await?;
            if starts {
                self.notes.push(trouble::right_again());
                self.set(place, new).await?;
                self.stop().await?;
            }
            self.lent.iter_mut().skip(at).take(1).for_each(|lent| lent.restored = !starts);
            if place.pnu == LOST {
                self.behind = Some(old.into());
            }
        }
        match self.lent.iter().any(|lent| !lent.restored) {
            true => Err(trouble::not_given_back(self.address(), self.behind)),
            false => Ok(()),
        }
    }

    /// Whether P.928 is not given back.
    fn keeps_right(&self) -> bool {
        self.lent.iter().any(|lent| lent.place.pnu == RIGHT && !lent.restored)
    }

    /// Whether somebody else starts the motor as soon as he may.
    async fn starts_by_itself(&mut self) -> Result<bool, Failure> {
        let begun = self.line.now();
        while self.line.now().since(begun) < WATCHED {
            if let Cycle::Inputs(_) = self.cycle().await?
                && self.seen.is_some_and(Seen::is_driven)
            {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Writes a value and reads it back.
    pub(super) async fn set(&mut self, place: Place, word: u16) -> Result<(), Failure> {
        let told = self.request(Request::write(place, word, self.line.now())).await?;
        let written = trouble::told(self.address(), place, told);
        match self.read(place).await? {
            Ok(bits) if bits & 0xFFFF == u32::from(word) => Ok(()),
            Ok(bits) => Err(written.err().unwrap_or_else(|| trouble::differs(self.address(), place, bits))),
            Err(unread) => Err(written.err().unwrap_or(unread)),
        }
    }

    /// The same for what goes back: said again where nothing was answered, which a port that took no bytes for a while keeps back.
    async fn sets_back(&mut self, place: Place, word: u16) -> Result<(), Failure> {
        for _ in 0..SAID_AGAIN {
            match self.set(place, word).await {
                Err(failure) if failure.code == trouble::MUTE => {}
                done => return done,
            }
        }
        self.set(place, word).await
    }
}

fn is_turning(done: &Result<(), Failure>) -> bool {
    done.as_ref().is_err_and(|why| why.code == trouble::NOT_STILL)
}

fn changed(lent: &Lent) -> Change {
    Change {
        param: lent.place.pnu.into(),
        name: trouble::label(lent.place),
        data_set: 0,
        old: lent.old.into(),
        new: lent.new.into(),
        restored: lent.restored,
    }
}
