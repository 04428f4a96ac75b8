"""The adapter is pulled at every byte of a transaction: one clear error at once, and nothing else."""

import os
import pty
import select
import time
import tty

from harness import Running, expect_below, expect_in, group, our

case = group("unplug")

REQUEST = bytes.fromhex("010321740001CE2C")
REPLY = bytes.fromhex("010302056E3AF8")
# A line that is gone: a user must not be left waiting.
PROMPT_S = 1.0
PATIENCE_S = 5.0


def pulled_after(count):
    """Runs a read on a line that ends after so many bytes, of the request first and then of the reply."""
    master, slave = pty.openpty()
    tty.setraw(master)
    words = ["--parity", "none", "--drive", "act", "-a", "1", "read", "372@2"]
    with Running(our(os.ttyname(slave), *words)) as running:
        asked, until = 0, time.monotonic() + PATIENCE_S
        while asked < min(max(count, 1), len(REQUEST)) and time.monotonic() < until:
            if select.select([master], [], [], 0.1)[0]:
                asked += len(os.read(master, 1)) if count else 1
        os.write(master, REPLY[: max(0, count - len(REQUEST))])
        os.close(slave)
        os.close(master)
        pulled = time.monotonic()
        return running.end(), time.monotonic() - pulled


@case("after {} bytes of a read", each={str(count): (count,) for count in range(len(REQUEST) + len(REPLY))})
def _(count):
    done, seconds = pulled_after(count)
    done.exits(3)
    expect_below("seconds until the end", seconds, PROMPT_S)
    expect_in("error", done.error["code"], ["port.lost"])
