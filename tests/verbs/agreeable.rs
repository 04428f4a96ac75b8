//! Somebody who says yes to everything, and the permits that come of it.

use antrieb::gate::{self, Answer, Ask, Kind, Permit, Question, Reply};
use antrieb::text::Text;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

pub(crate) struct Agreeable;

impl Ask for Agreeable {
    fn ask<'a>(&'a mut self, _: &'a Question) -> Reply<'a> {
        Box::pin(async { Answer::Yes })
    }
    fn is_there(&self) -> bool {
        true
    }
}

/// A permit of one kind.
pub(crate) fn permit<K: Kind>() -> Permit<K> {
    let question = Question { hazards: vec![K::HAZARD], title: Text::default(), details: Vec::new() };
    let mut agreeable = Agreeable;
    let mut asked = pin!(gate::ask(&mut agreeable, &question));
    let Poll::Ready(permit) = asked.as_mut().poll(&mut Context::from_waker(Waker::noop())) else {
        unreachable!("the answer is there at once")
    };
    permit.unwrap()
}
