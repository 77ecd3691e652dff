"""Throughput of Dask, Ray and Spark in local mode against the command line, all on two cores.

    python bench/engines.py [--programs 4000] [--rounds 3]

The command line is that of the same wheel, `python -m partc`. The engines run warm: their workers are up, and each has compiled one batch. Tables go in and come out of memory; the command line reads and
writes files.
"""

from __future__ import annotations

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time
from typing import Any, Callable

EXAMPLES = str(pathlib.Path(__file__).resolve().parents[1] / "examples")
sys.path.insert(0, EXAMPLES)
# Workers are of this interpreter, and find the same modules.
os.environ["PYTHONPATH"] = EXAMPLES
os.environ.setdefault("PYSPARK_PYTHON", sys.executable)
import folder  # noqa: E402


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--programs", type=int, default=4000)
    arguments.add_argument("--rounds", type=int, default=3)
    asked = arguments.parse_args()
    with tempfile.TemporaryDirectory() as space:
        source, out = pathlib.Path(space, "in"), pathlib.Path(space, "out")
        source.mkdir()
        folder.generate(source, asked.programs)
        table = folder.programs(source)

        def command() -> None:
            words = [sys.executable, "-m", "partc", "compile", str(source), "--out-dir", str(out), "--jobs", "2", "--quiet", "--isolated", "--exit-zero"]
            subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, timeout=600, check=False)

        runs: dict[str, Callable[[], Any]] = {"command": command}
        import dask_partitions

        runs["dask"] = lambda: dask_partitions.compile_all(table)
        import ray
        import ray_data

        ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
        ray.data.DataContext.get_current().enable_progress_bars = False
        runs["ray"] = lambda: ray_data.compile_all(table)
        import spark_map_in_arrow
        from pyspark.sql import SparkSession

        builder = SparkSession.builder.master("local[2]").config("spark.ui.enabled", "false")
        session = builder.config("spark.driver.bindAddress", "127.0.0.1").getOrCreate()
        runs["spark"] = lambda: spark_map_in_arrow.compile_all(session, table).write.format("noop").mode("overwrite").save()
        seconds: dict[str, list[float]] = {name: [] for name in runs}
        for turn in range(asked.rounds + 1):
            for name, run in runs.items():
                begin = time.perf_counter()
                run()
                if turn:
                    seconds[name].append(time.perf_counter() - begin)
        reference = statistics.median(seconds["command"])
        for name, list_of in seconds.items():
            middle = statistics.median(list_of)
            print(f"{name:8} {asked.programs / middle:8.0f} programs/s, {reference / middle:5.2f} of the command line ({min(list_of):.2f} to {max(list_of):.2f} s)")
        session.stop()
        ray.shutdown()


if __name__ == "__main__":
    main()
