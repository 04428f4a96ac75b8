"""Exception replies, as the cases in which a pymodbus client is the master tell of them."""

from harness import Failed, expect


class Refused(Exception):
    """An exception reply."""

    def __init__(self, code):
        super().__init__(f"exception {code}")
        self.code = code


def expect_refused(code, ask):
    try:
        came = ask()
    except Refused as refused:
        return expect("exception code", refused.code, code)
    raise Failed(f"expected exception {code}, got {came!r}")
