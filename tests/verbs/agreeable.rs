//! Somebody who says yes to everything, and the permit that comes of it.

use antrieb::gate::{self, Answer, Ask, Hazard, Permit, Question, Reply};
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

/// A permit for one hazard.
pub(crate) fn permit(hazard: Hazard) -> Permit {
    let question = Question { hazards: vec![hazard], title: String::new(), details: Vec::new() };
    let mut agreeable = Agreeable;
    let mut asked = pin!(gate::ask(&mut agreeable, &question));
    let Poll::Ready(permit) = asked.as_mut().poll(&mut Context::from_waker(Waker::noop())) else {
        unreachable!("the answer is there at once")
    };
    permit.unwrap()
}
