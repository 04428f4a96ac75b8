"""docs/scripting.md as its reader would try it: the scripts on it as files, its commands by bash and jq, on the built-in bench."""

import re
import subprocess
import tempfile
from pathlib import Path

from harness import BINARY, PATIENCE_S, ROOT, environment, expect, expect_below, group

PAGE = ROOT / "docs/scripting.md"

case = group("scripts")


def blocks(kind):
    return re.findall(rf"^```{kind}\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)


def commands():
    """What is typed, and what the page says that it prints."""
    for block in blocks("console"):
        yield from re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, re.MULTILINE)


@case("every command of docs/scripting.md prints what the page says")
def _():
    tried = 0
    with tempfile.TemporaryDirectory() as place:
        for script in blocks("sh"):
            Path(place, re.search(r"^# (\S+\.sh)\b", script, re.MULTILINE)[1]).write_text(script)
        Path(place, "antrieb").symlink_to(BINARY.resolve())
        around = environment() | {"HOME": place, "XDG_CONFIG_HOME": f"{place}/none", "ANTRIEB_PORT": "sim"}
        around["PATH"] = f"{place}:{around['PATH']}"
        for typed, printed in commands():
            done = subprocess.run(
                ["bash", "-c", typed], cwd=place, env=around, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=PATIENCE_S
            )
            expect(typed, done.stdout, printed)
            tried += 1
    expect_below("commands on the page", 10, tried)
