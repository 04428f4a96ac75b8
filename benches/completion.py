#!/usr/bin/env python3
"""How long a completion takes: benches/completion.py target/release/antrieb [ROUNDS]. Aim: below 30 ms."""
import statistics
import subprocess
import sys
import time

TYPED = ["read rated-sp", "read @", "write 395=", "--drive lxm05 read _p", "-a p", "-p ", "sollwert --mode "]


def main(program, rounds=20):
    for typed in TYPED:
        words = typed.split(" ")
        times = []
        for _ in range(rounds):
            begun = time.perf_counter()
            subprocess.run([program, "complete", "zsh", "--", *words], stdout=subprocess.DEVNULL, check=True)
            times.append((time.perf_counter() - begun) * 1000)
        print(f"{typed!r:28} median {statistics.median(times):6.1f} ms, longest {max(times):6.1f} ms")


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:3]))
