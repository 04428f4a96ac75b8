"""Stops of drives on several ports, while somebody else sets one of them going again.

The drives, and what happens to them, are a judge's who had not seen our code (tests/strangers/foreign): each script says in its first line
what its words mean, and ends with a line that tells how our program ended, how long before that the drive was set going, and whether exit 0
came beside a shaft that turns. The ports run side by side in real time, so no test in virtual time can hold this.
"""

import os
import re
import subprocess
import sys
import tempfile

from harness import BINARY, PATIENCE_S, ROOT, TRAIL, Failed, environment, group

case = group("several ports")

SCRIPTS = ROOT / "tests/strangers/foreign"
# A look at a shaft may be as old as this when a run ends: whoever sets a drive going behind it is seen by nobody.
BLIND_S = 0.35

TOLD = {
    "one of two that stands, LXM05": ("ml.py", "lx", "qs", "1.0"),
    "one of two that stands, ACU": ("ml.py", "acu", "disable", "1.0"),
    "beside a port that loses every other reply": ("ml14.py", "lx", "disable", "2", "alt", "0.3", "1"),
    "beside a port with late replies": ("ml14.py", "rtu", "qs", "2", "lat", "0.3", "1"),
    "beside a port with two settings": ("ml10.py", "rtu", "qs", "1", "2", "0.5"),
    "twice, one behind the other": ("ml2.py", "lx", "qs", "0.3", "0.5", "1"),
}


def judged(script, *words):
    """What the judge's script says at its end."""
    with tempfile.TemporaryDirectory(prefix="antrieb-peers-") as directory:
        os.mkdir(f"{directory}/out")
        done = subprocess.run(
            [sys.executable, SCRIPTS / script, *words],
            cwd=directory,
            env={**environment(), "ANTRIEB": str(BINARY), "PYTHONDONTWRITEBYTECODE": "1"},
            capture_output=True,
            text=True,
            timeout=4 * PATIENCE_S,
        )
    TRAIL.append(f"$ {script} {' '.join(words)}\n{done.stdout}{done.stderr}")
    if done.returncode:
        raise Failed(f"{script} ended with {done.returncode}")
    return done.stdout


@case("who is set going again while others are stopped is seen: {}", each=TOLD)
def _(script, *words):
    told = judged(script, *words)
    gaps = [float(gap) for gap in re.findall(r"gap[AB]?\d? '?([0-9.]+)", told)]
    if not gaps or min(gaps) < 0:
        raise Failed(f"nobody was set going before the end: {told}")
    if "FALSE0" in told and min(gaps) > BLIND_S:
        raise Failed(f"exit 0 beside a shaft that turns: {told}")


SETTINGS = {
    "quick-stop of LXM05": ("lx", "qs", ".3", "0"),
    "disable of ACU": ("rtu", "disable", ".25", "0"),
    "a setpoint of 0 to ACU, SIGTERM": ("rtu", "zero", ".1", "0", "term"),
    "disable of LXM05, beside another port": ("lx", "disable", ".31", ".15", "other"),
}


@case("who interrupts the stop of a port's first setting stops its second one: {}", each=SETTINGS)
def _(*words):
    told = judged("tw2.py", *words)
    writes = re.search(r"d2 writes (\d+)", told)
    if "alive True" not in told:
        raise Failed(f"it was over before the signal: {told}")
    if not writes or int(writes[1]) == 0:
        raise Failed(f"the second drive has heard no stop: {told}")
