"""Compiles a folder of part programs with Dask: `python dask_partitions.py FOLDER`."""

from __future__ import annotations

import sys

import dask
import partc
import pyarrow
from folder import programs


def compile_all(table: pyarrow.Table, partitions: int = 8, **asked: object) -> pyarrow.Table:
    """A row for each program; `asked` goes to `partc.compile_batch`: config, dialect, target."""
    rows = max(1, -(-table.num_rows // partitions))
    parts = [table.slice(at, rows) for at in range(0, table.num_rows, rows)]
    work = [dask.delayed(partc.compile_batch)(part, **asked) for part in parts]
    # Threads do: the lock of the interpreter is free while partc works.
    return pyarrow.concat_tables(dask.compute(*work, scheduler="threads", num_workers=2))


if __name__ == "__main__":
    results = compile_all(programs(sys.argv[1]))
    print(f"{results.num_rows} programs, {results['ok'].to_pylist().count(False)} refused")
