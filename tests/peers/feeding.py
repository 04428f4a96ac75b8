"""What `monitor` hands to other tools, read by parsers that we did not write: Prometheus' own for OpenMetrics and for its
older text, and one for InfluxDB lines."""

import time
from pathlib import Path
from tempfile import TemporaryDirectory

from harness import BINARY, bench, expect, group, run
from line_protocol_parser import parse_line
from prometheus_client.openmetrics.parser import text_string_to_metric_families as openmetrics
from prometheus_client.parser import text_string_to_metric_families as older_text

case = group("feeding")


def watched(port, *words):
    """Two rounds of two drives."""
    return run(BINARY, "--no-config", "--port", port, "-a", "1,2", "monitor", "--count", "2", "--interval", "0", *words).exits(0)


def reachable(families):
    samples = [sample for family in families for sample in family.samples if sample.name == "antrieb_reachable"]
    return {(sample.labels["address"], sample.labels["family"]): sample.value for sample in samples}


@case("a text file is whole, in Prometheus' text format")
def _():
    with TemporaryDirectory(prefix="antrieb-peers-") as directory, bench() as served:
        file = Path(directory) / "drives.prom"
        watched(served.port, "--textfile", file)
        families = list(older_text(file.read_text()))
    expect("drives", reachable(families), {("1", "act"): 1.0, ("2", "acu"): 1.0})
    counted = [sample for family in families for sample in family.samples if sample.name == "antrieb_line_silences_total"]
    expect("silences", [sample.value for sample in counted], [0.0])
    counters = {family.name for family in families if family.type == "counter"}
    expect("counters", counters, {f"antrieb_line_{name}" for name in ("telegrams", "repeats", "silences", "garbled")})


@case("every round on stdout is OpenMetrics")
def _():
    with bench() as served:
        rounds = watched(served.port, "--format", "openmetrics").out.split("# EOF\n")
    expect("rounds", (len(rounds), rounds[-1]), (3, ""))
    for told in rounds[:-1]:
        expect("drives", len(reachable(openmetrics(told + "# EOF\n"))), 2)


@case("InfluxDB lines bear the time of their sample")
def _():
    began = time.time_ns()
    with bench() as served:
        lines = [parse_line(line) for line in watched(served.port, "--format", "influx").out.splitlines()]
    expect("drives", [line["tags"]["address"] for line in lines], ["1", "2", "1", "2"])
    expect("reachable", {line["fields"]["reachable"] for line in lines}, {True})
    times = [line["time"] for line in lines]
    expect("in order", times, sorted(times))
    expect("of today", began < times[0] and times[-1] < time.time_ns(), True)
