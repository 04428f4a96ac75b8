"""A plant of three ports with four drives each: found, planned, applied, and a drift that mbpoll makes is told."""

import re
import tempfile
from contextlib import ExitStack, contextmanager
from pathlib import Path

from harness import BINARY, bench, expect, group, run
from mbpoll_master import mbpoll, read

case = group("plant")

PORTS = ["left", "middle", "right"]
STATIONS = [1, 2, 3, 4]
DRIVES = "".join(f'[[drive]]\nmodel = "act"\naddress = {station}\n' for station in STATIONS)
SETTINGS = 'antrieb = 1\n[drive]\nfamily = "act"\n[values]\n"372@2" = 1450\n"480@1" = "20 Hz"\n'


class Plant:
    """The project file beside its parameter files, and the benches behind its ports."""

    def __init__(self, directory, benches):
        self.directory, self.benches = directory, benches
        self.file = directory / "antrieb.toml"
        (directory / "all.toml").write_text(SETTINGS)

    def antrieb(self, *words):
        return run(BINARY, "--config", self.file, "--json", *words)

    def init(self):
        """Writes the project file, and says which settings its drives shall have."""
        ports = [word for served in self.benches for word in ("-p", served.port)]
        found = run(BINARY, "--no-config", "--json", *ports, "-a", "1-4", "init", self.file).exits(0)
        text = self.file.read_text()
        self.file.write_text(re.sub(r"# files = .*", 'files = ["all.toml"]', text))
        return found.data


@contextmanager
def plant():
    with ExitStack() as stack:
        directory = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="antrieb-plant-")))
        yield Plant(directory, [stack.enter_context(bench(DRIVES)) for _ in PORTS])


def states(done):
    return {drive["state"] for drive in done.data["drives"]}


@case("3 ports x 4 drives: init, plan, apply, a drift made by mbpoll, check tells it")
def _():
    with plant() as here:
        expect("found", len(here.init()["drives"]), len(PORTS) * len(STATIONS))
        expect("planned", states(here.antrieb("plan").exits(1)), {"planned"})
        expect("applied", states(here.antrieb("apply", "--yes").exits(0)), {"done"})
        for served in here.benches:
            for station in STATIONS:
                expect(f"drive {station}", read(served, station, 372, 2), 1_450)
        here.antrieb("check").exits(0)
        expect("nothing to do", states(here.antrieb("plan").exits(0)), {"same"})
        mbpoll(here.benches[1], 3, 372, 2, write=1_440).exits(0)
        drifted = here.antrieb("check").exits(1).data["drives"]
        rows = [(row["address"], row["port"], row["differences"]) for row in drifted if row["differences"]]
        expect("drives that differ", [row[:2] for row in rows], [(3, here.benches[1].port)])
        expect("their rows", [(row["param"], row["data_set"], row["b_raw"]) for row in rows[0][2]], [(372, 2, 1_440)])
        expect("brought back", states(here.antrieb("apply", "--yes").exits(0)), {"same", "done"})
        here.antrieb("check").exits(0)


@case("a port that is lost stops none of the others")
def _():
    with plant() as here:
        here.init()
        here.benches[0].stop()
        told = here.antrieb("apply", "--yes").exits(9).data["drives"]
        gone = {row["state"] for row in told if row["port"] == here.benches[0].port}
        expect("on the lost port", gone, {"skipped"})
        expect("on the others", {row["state"] for row in told if row["port"] != here.benches[0].port}, {"done"})
