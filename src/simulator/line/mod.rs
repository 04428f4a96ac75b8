//! The line: the pair of wires, what is spoken on it, and what disturbs it.

pub(crate) mod babble;
pub(crate) mod disturb;
pub(crate) mod port;
pub(crate) mod speech;
pub(crate) mod wire;
