//! VABus: what is understood is the same again when it is sent, and a stream of anything is cut into what it holds.
#![no_main]

use antrieb::protocol::vabus::{Receiver, Reply, Request, arrival};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(request) = Request::decode(bytes) {
        assert_eq!(Request::decode(&request.encode()).as_ref(), Ok(&request));
        arrival(&request, bytes);
    }
    if let Ok(reply) = Reply::decode(bytes) {
        assert_eq!(Reply::decode(&reply.encode()).as_ref(), Ok(&reply));
    }
    let mut receiver = Receiver::default();
    for piece in bytes.chunks(3) {
        receiver.feed(piece);
    }
    receiver.silence();
    assert!(receiver.pending().is_empty());
});
