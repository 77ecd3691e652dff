"""A folder of part programs as a table: what all engines begin with."""

from __future__ import annotations

import pathlib

import pyarrow


def programs(folder: str | pathlib.Path) -> pyarrow.Table:
    """The columns `name` and `program`, in the order of the names."""
    paths = sorted(path for path in pathlib.Path(folder).iterdir() if path.suffix.upper() in {".H", ".MPF", ".NC", ".NPG"})
    return pyarrow.table({"name": [path.name for path in paths], "program": [path.read_bytes() for path in paths]})


def generate(folder: str | pathlib.Path, count: int) -> None:
    """Programs that differ, to try an engine with; each tenth one has an error."""
    for number in range(count):
        points = "".join(
            f"N{10 * step} G1 X={step}*R1 Y{(step * 7 + number) % 50}.{number % 10} F{100 + number}\n" for step in range(1, 40)
        )
        bore = f"MCALL CYCLE81(10,0,2,-{number % 9 + 1})\nX5 Y5\nX15 Y{number % 20}\nMCALL\n"
        wrong = "G1 X<10\n" if number % 10 == 0 else ""
        text = f"G17 G90 G54 G71\nT1 D1\nM6\nS{1000 + number} M3\nR1={number % 13 + 1}\nG0 X0 Y0 Z5\n{points}{bore}{wrong}G0 Z50\nM30\n"
        (pathlib.Path(folder) / f"P{number:05}.MPF").write_text(text, newline="\n")
