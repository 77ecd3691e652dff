"""Rows a second and peak memory of batches of moves, against nc-gcode-interpreter (PyPI) on the same SINUMERIK files.

    python bench/batches.py [--lines 1000000] [--rounds 3]

partc runs twice: programs checked in front, and in one run (`checked=False`). All run in turns, each in a process of its own; what counts is the time from the first call to the last batch, and the largest
resident set of the process, less that of one which only imports the package. The peer wants Python 3.13.
"""

from __future__ import annotations

import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROWS = 65_536


def straight(lines: int) -> str:
    """A finishing cut as a CAM system writes it."""
    body = (f"N{n * 10} G1 X{math.sin(n / 50) * 40:.3f} Y{n % 500 * 0.1:.3f} Z{math.cos(n / 90) * 3:.3f} F1200" for n in range(lines))
    return "\n".join(["G17 G90 G54 G71", "T1 D1", "M6", "S8000 M3", "G0 X0 Y0 Z50", *body, "G0 Z50", "M30", ""])


def mixed(lines: int) -> str:
    """Lines and arcs, and a feed that changes."""
    body = []
    for n in range(lines // 4):
        y = n % 200
        body += [f"G1 X10 Y{y} F{800 + n % 300}", f"G2 X20 Y{y + 10} I10 J0", f"G1 X30.{n % 10}", f"G0 X0 Y{y}"]
    return "\n".join(["G17 G90 G54 G71", "T1 D1", "M6", "S8000 M3", "G0 X0 Y0 Z5", *body, "M30", ""])


def peak_memory() -> int:
    """Of this process alone, KiB; that of ``getrusage`` is inherited from the one that started it."""
    status = pathlib.Path("/proc/self/status").read_text()
    return next(int(line.split()[1]) for line in status.splitlines() if line.startswith("VmHWM:"))


def consume(which: str, path: str) -> None:
    """In a process of its own: prints rows, seconds and the peak of memory in MiB."""
    if which.startswith("partc"):
        import partc as package
    else:
        import nc_gcode_interpreter as package
    idle = peak_memory()
    begin, rows = time.perf_counter(), 0
    if which.startswith("partc"):
        made = package.trace_batches(path, rows=ROWS, config=package.Config(), checked=which == "partc")
        rows = sum(batch.num_rows for batch in made)
    elif which == "peer":
        rows = sum(frame.height for frame in package.nc_to_batches(pathlib.Path(path), batch_size=ROWS, iteration_limit=2**31 - 1))
    seconds = time.perf_counter() - begin
    peak = peak_memory()
    print(json.dumps({"rows": rows, "seconds": seconds, "peak": peak / 1024, "grown": (peak - idle) / 1024}))


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--lines", type=int, default=1_000_000)
    arguments.add_argument("--rounds", type=int, default=3)
    asked = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("straight", straight(asked.lines)), ("mixed", mixed(asked.lines))):
            path = pathlib.Path(folder, f"{name}.MPF")
            path.write_text(text)
            found: dict[str, list[dict[str, float]]] = {"partc": [], "partc-once": [], "peer": []}
            for _ in range(asked.rounds):
                for which, list_of in found.items():
                    words = [sys.executable, __file__, "--consume", which, str(path)]
                    made = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, timeout=900, text=True, check=True)
                    list_of.append(json.loads(made.stdout))
            speed = {}
            for which, list_of in found.items():
                speeds = [one["rows"] / one["seconds"] for one in list_of]
                speed[which] = statistics.median(speeds)
                print(
                    f"{name:9} {which:10} {list_of[0]['rows']:9} rows, {speed[which] / 1e6:6.3f} million rows/s "
                    f"({min(speeds) / 1e6:.3f} to {max(speeds) / 1e6:.3f}), peak {max(one['peak'] for one in list_of):6.0f} MiB, "
                    f"{max(one['grown'] for one in list_of):6.0f} MiB of it by the run"
                )
            for which in ("partc", "partc-once"):
                print(f"{name:9} {which}: {speed[which] / speed['peer']:.1f} times as many rows a second")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--consume"]:
        consume(*sys.argv[2:4])
    else:
        main()
