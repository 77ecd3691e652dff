"""Compiles a folder of part programs with Ray Data: `python ray_data.py FOLDER`."""

from __future__ import annotations

import sys

import partc
import pyarrow
import ray
import ray.data
from folder import programs


def compile_all(table: pyarrow.Table, blocks: int = 8, **asked: object) -> pyarrow.Table:
    """A row for each program; `asked` goes to `partc.compile_batch`: config, dialect, target."""
    source = ray.data.from_arrow(table).repartition(blocks)
    made = source.map_batches(partc.compile_batch, batch_format="pyarrow", batch_size=None, fn_kwargs=asked)
    return pyarrow.concat_tables(ray.get(made.to_arrow_refs())).sort_by("name")


if __name__ == "__main__":
    ray.init(num_cpus=2, include_dashboard=False)
    results = compile_all(programs(sys.argv[1]))
    print(f"{results.num_rows} programs, {results['ok'].to_pylist().count(False)} refused")
