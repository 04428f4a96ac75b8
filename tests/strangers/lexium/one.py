"""One command beside one drive, everything shown:  one.py "--late 300 --control7 brakes" -a 1 identify"""

import argparse
import shlex
import sys

import judge
from lexium05 import Readings
from wire import Disturbances, add_options, taken

parser = argparse.ArgumentParser()
add_options(parser, Readings)
add_options(parser, Disturbances)
parser.add_argument("--quiet", action="store_true")
parser.add_argument("--limit", type=float, default=40)
parser.add_argument("--after", type=float, default=1.0)
parser.add_argument("--auto", action="store_true", help="do not name the family")
parser.add_argument("--signals", default="", help="1.0:SIGINT,1.5:SIGINT after operation enabled")
parser.add_argument("--signal-from", default="enabled")
options = parser.parse_args(shlex.split(sys.argv[1]))
signals = tuple((float(t), getattr(judge.signal, s)) for t, s in
                (pair.split(":") for pair in options.signals.split(",") if pair))
readings, wrong = taken(options, Readings), taken(options, Disturbances)
trial = judge.Trial("one", sys.argv[2:], vars(readings), vars(wrong), exits=(), limit=options.limit,
                    drive=None if options.auto else "lxm05", after=options.after, signals=signals,
                    signal_from=options.signal_from)
outcome = judge.run(trial, log=None if options.quiet else sys.stdout)
print(outcome.out)
print(outcome.err)
print(f"exit {outcome.code} after {outcome.seconds:.2f} s; at end {outcome.at_end}, later {outcome.later['state']} "
      f"{outcome.later['speed']:.1f} 1/min, peak {outcome.device.peak:.0f}")
for when, text in outcome.device.events:
    print(f"  {when:8.3f} {text}")
for when, kind, text in outcome.device.sins:
    print(f"  {when:8.3f} SIN {kind}: {text}")
for complaint in judge.verdict(outcome):
    print("  !!", complaint)
