//! Telegrams to bytes and back, for both sides (sources A2).

use super::{ACK, Address, Data, ENQ, EOT, ETX, Header, NAK, STX, TelegramError, bcc};

/// What a master asks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Request {
    /// Reads a parameter: `EOT ADR SYS ds n n n ENQ`.
    Enquiry {
        /// Whom.
        address: Address,
        /// What.
        header: Header,
    },
    /// Writes a parameter: `EOT ADR STX SYS ds n n n a a w..w ETX BCC`.
    Select {
        /// Whom.
        address: Address,
        /// What.
        header: Header,
        /// The value.
        data: Data,
    },
}

/// What a drive answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    /// The value that was asked for: `ADR STX SYS ds n n n a a w..w ETX BCC`.
    Value {
        /// Who answers.
        address: Address,
        /// What it is; the data set is 0-4.
        header: Header,
        /// The value.
        data: Data,
    },
    /// Written: `ADR ACK`.
    Ack {
        /// Who answers.
        address: Address,
    },
    /// Refused: `ADR NAK`.
    Nak {
        /// Who answers.
        address: Address,
    },
}

/// Anything that is heard on a line of VABus.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Telegram {
    /// From the master.
    Request(Request),
    /// From a drive.
    Reply(Reply),
    /// The master ends an exchange: `EOT` alone.
    End,
}

impl Request {
    /// Whom it is for.
    pub fn address(&self) -> Address {
        match self {
            Request::Enquiry { address, .. } | Request::Select { address, .. } => *address,
        }
    }

    /// What it is about.
    pub fn header(&self) -> Header {
        match self {
            Request::Enquiry { header, .. } | Request::Select { header, .. } => *header,
        }
    }

    /// The bytes, with the EOT before them.
    pub fn encode(&self) -> Vec<u8> {
        let mut bytes = vec![EOT, self.address().character()];
        match self {
            Request::Enquiry { header, .. } => {
                bytes.extend(header.characters());
                bytes.push(ENQ);
            }
            Request::Select { header, data, .. } => put_text(&mut bytes, *header, data),
        }
        bytes
    }

    /// Takes exactly one whole telegram of a master, EOT included, apart.
    pub fn decode(bytes: &[u8]) -> Result<Self, TelegramError> {
        whole(bytes, request)
    }

    /// Whether this is an answer to it: from the same drive and about the same parameter. An ACK or NAK names no
    /// parameter; that it belongs to this question and to no earlier one has to be known otherwise.
    pub fn is_answered_by(&self, reply: &Reply) -> bool {
        if self.address() != reply.address() {
            return false;
        }
        match (self, reply) {
            (_, Reply::Nak { .. }) | (Request::Select { .. }, Reply::Ack { .. }) => true,
            (Request::Enquiry { header: asked, .. }, Reply::Value { header, .. }) => header.answers(*asked),
            (Request::Enquiry { .. }, Reply::Ack { .. }) | (Request::Select { .. }, Reply::Value { .. }) => false,
        }
    }
}

impl Reply {
    /// Who answers.
    pub fn address(&self) -> Address {
        match self {
            Reply::Value { address, .. } | Reply::Ack { address } | Reply::Nak { address } => *address,
        }
    }

    /// The bytes.
    pub fn encode(&self) -> Vec<u8> {
        let mut bytes = vec![self.address().character()];
        match self {
            Reply::Value { header, data, .. } => put_text(&mut bytes, *header, data),
            Reply::Ack { .. } => bytes.push(ACK),
            Reply::Nak { .. } => bytes.push(NAK),
        }
        bytes
    }

    /// Takes exactly one whole telegram of a drive apart.
    pub fn decode(bytes: &[u8]) -> Result<Self, TelegramError> {
        whole(bytes, reply)
    }
}

impl Telegram {
    /// Takes the telegram apart that `bytes` begin with, and tells how many of them it has. An EOT is taken as the end
    /// of an exchange only if no address follows it, so one at the very end of `bytes` is still open.
    pub(super) fn parse(bytes: &[u8]) -> Parsed<Telegram> {
        let mut cursor = Cursor::new(bytes);
        match bytes {
            [EOT, next, ..] if Address::from_character(*next).is_err() => Ok((Telegram::End, 1)),
            [EOT, ..] => request(&mut cursor).map(|request| (Telegram::Request(request), cursor.taken)),
            _ => reply(&mut cursor).map(|reply| (Telegram::Reply(reply), cursor.taken)),
        }
    }
}

/// A part of a telegram and the number of its bytes, or why there is none.
pub(super) type Parsed<T> = Result<(T, usize), Stop>;

/// Why no telegram stands there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// It may still become one.
    Short,
    /// It is none. `len` bytes belong to what is spoilt: nothing within them may be taken for another telegram.
    Bad { error: TelegramError, len: usize },
}

/// Anything wrong before the length is known: the next telegram may begin at the next byte.
impl From<TelegramError> for Stop {
    fn from(error: TelegramError) -> Self {
        Stop::Bad { error, len: 1 }
    }
}

fn put_text(bytes: &mut Vec<u8>, header: Header, data: &Data) {
    bytes.push(STX);
    let text: Vec<u8> = [&header.characters()[..], &data.length(), data.characters()].concat();
    bytes.extend(&text);
    bytes.extend([ETX, bcc(&text)]);
}

fn whole<T>(bytes: &[u8], part: fn(&mut Cursor<'_>) -> Result<T, Stop>) -> Result<T, TelegramError> {
    let mut cursor = Cursor::new(bytes);
    match part(&mut cursor) {
        Ok(telegram) if cursor.rest.is_empty() => Ok(telegram),
        Ok(_) => Err(TelegramError::TooLong { extra: cursor.rest.len() }),
        Err(Stop::Short) => Err(TelegramError::TooShort { len: bytes.len() }),
        Err(Stop::Bad { error, .. }) => Err(error),
    }
}

fn request(cursor: &mut Cursor<'_>) -> Result<Request, Stop> {
    let got = cursor.byte()?;
    if got != EOT {
        return Err(TelegramError::Control { expected: "EOT", got }.into());
    }
    let address = Address::from_character(cursor.byte()?)?;
    if cursor.rest.first() == Some(&STX) {
        let (header, data) = cursor.text()?;
        return Ok(Request::Select { address, header, data });
    }
    let header = cursor.header()?;
    match cursor.byte()? {
        ENQ => Ok(Request::Enquiry { address, header }),
        got => Err(TelegramError::Control { expected: "ENQ", got }.into()),
    }
}

fn reply(cursor: &mut Cursor<'_>) -> Result<Reply, Stop> {
    let address = Address::from_character(cursor.byte()?)?;
    match cursor.rest.first() {
        None => Err(Stop::Short),
        Some(&STX) => {
            let (header, data) = cursor.text()?;
            Ok(Reply::Value { address, header, data })
        }
        Some(&ACK) => cursor.byte().map(|_| Reply::Ack { address }),
        Some(&NAK) => cursor.byte().map(|_| Reply::Nak { address }),
        Some(&got) => Err(TelegramError::Control { expected: "STX, ACK or NAK", got }.into()),
    }
}

/// Reads bytes one part after the other.
struct Cursor<'a> {
    rest: &'a [u8],
    taken: usize,
}

impl<'a> Cursor<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Cursor { rest: bytes, taken: 0 }
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], Stop> {
        let (&part, rest) = self.rest.split_first_chunk::<N>().ok_or(Stop::Short)?;
        self.rest = rest;
        self.taken += N;
        Ok(part)
    }

    fn byte(&mut self) -> Result<u8, Stop> {
        self.array::<1>().map(|[byte]| byte)
    }

    /// Wrong characters are told as soon as they are there.
    fn header(&mut self) -> Result<Header, Stop> {
        Ok(Header::from_characters(self.array()?)?)
    }

    /// `STX SYS ds n n n a a w..w ETX BCC`. The end is counted, because the check character may look like anything.
    fn text(&mut self) -> Result<(Header, Data), Stop> {
        let [_stx] = self.array()?;
        let start = self.rest;
        let header = self.header()?;
        let len = Data::length_from(self.array()?)?;
        let (characters, rest) = self.rest.split_at_checked(len).ok_or(Stop::Short)?;
        (self.rest, self.taken) = (rest, self.taken + len);
        let [etx, got] = self.array()?;
        let spoilt = |error| Stop::Bad { error, len: self.taken };
        if etx != ETX {
            return Err(spoilt(TelegramError::Control { expected: "ETX", got: etx }));
        }
        let data = Data::text(characters).map_err(spoilt)?;
        let expected = bcc(start.get(..Header::LEN + 2 + len).unwrap_or_default());
        if expected != got {
            return Err(spoilt(TelegramError::Check { expected, got }));
        }
        Ok((header, data))
    }
}
