"""mbpoll (Debian, on libmodbus) as master: reads and writes the simulated drives on the pty, RTU, 19200 8E1."""

from harness import bench, expect, expect_text, group, run
from vendor_codes import address_word

case = group("mbpoll")

ACT, ACU = 1, 2
ILLEGAL_ADDRESS = "Illegal data address"
DEVICE_FAILURE = "Slave device or server failure"
TIMED_OUT = "Connection timed out"


def mbpoll(served, station, param, data_set=0, *, write=None, count=1, baud=19_200, parity="even"):
    """One question; `-0` counts registers from 0, as the telegram does."""
    line = ["-m", "rtu", "-b", baud, "-P", parity, "-o", "0.7"]
    what = ["-a", station, "-0", "-t", "4", "-r", address_word(param, data_set), "-c", count, "-1"]
    if write is None:
        return run("mbpoll", *line, *what, served.port)
    what = what[:-3]  # neither count nor "once" when writing
    return run("mbpoll", *line, *what, served.port, write)


def read(served, *what, **how):
    """The value of a register that must be readable."""
    polled = mbpoll(served, *what, **how).exits(0)
    return int(polled.out.split("]:")[1].split()[0])


@case("code 3 reads P.372 of data set 2, of both drives")
def _():
    with bench() as served:
        expect("ACT", read(served, ACT, 372, 2), 1_390)
        expect("ACU", read(served, ACU, 372, 2), 1_390)
    expect("answered", served.counts["answered"], 2)


@case("code 6 writes P.376 of data set 4 to the EEPROM")
def _():
    with bench() as served:
        other = read(served, ACT, 376, 3)
        mbpoll(served, ACT, 376, 4, write=22).exits(0)
        expect("data set 4", read(served, ACT, 376, 4), 22)
        expect("data set 3", read(served, ACT, 376, 3), other)
    expect("EEPROM writes", served.counts["eeprom_writes"], 1)


@case("code 6 writes data set 9, the RAM behind 4, and spares the EEPROM")
def _():
    with bench() as served:
        stored = read(served, ACT, 376, 4)
        mbpoll(served, ACT, 376, 9, write=22).exits(0)
        expect("RAM", read(served, ACT, 376, 9), 22)
        expect("EEPROM", read(served, ACT, 376, 4), stored)
    expect("EEPROM writes", served.counts["eeprom_writes"], 0)


REFUSALS = {
    "two registers at once: exception 2": ((372, 2), dict(count=2), ILLEGAL_ADDRESS, 0),
    "data set 10: exception 4, P.11 = 2": ((372, 10), {}, DEVICE_FAILURE, 2),
    "an unknown parameter: exception 4, P.11 = 11": ((1_600, 2), {}, DEVICE_FAILURE, 11),
    "a value out of range: exception 4, P.11 = 1": ((376, 2), dict(write=0), DEVICE_FAILURE, 1),
    "a write to the status word: exception 4, P.11 = 4": ((411,), dict(write=1), DEVICE_FAILURE, 4),
    "a word of a 32-bit parameter: exception 4, P.11 = 14": ((481,), {}, DEVICE_FAILURE, 14),
}


@case("refused: {}", each=REFUSALS)
def _(what, how, told, cause):
    with bench() as served:
        expect_text("mbpoll", mbpoll(served, ACT, *what, **how).exits(1).err, told)
        expect("P.11", read(served, ACT, 11), cause)
        expect("P.11, read again", read(served, ACT, 11), 0)


SILENCES = {
    "to an address that nobody has": (3, {}),
    "to 9600 baud": (ACT, dict(baud=9_600)),
    "to odd parity": (ACT, dict(parity="odd")),
    "to no parity": (ACT, dict(parity="none")),
}


@case("silent {}, and there again with the right setting", each=SILENCES)
def _(station, how):
    with bench() as served:
        expect_text("mbpoll", mbpoll(served, station, 372, 2, **how).exits(1).err, TIMED_OUT)
        expect("with the right setting", read(served, ACT, 372, 2), 1_390)
    expect("answered", served.counts["answered"], 1)
