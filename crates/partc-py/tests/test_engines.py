"""The worked scripts in the real engines, in local mode: results equal to those of the command line."""

from __future__ import annotations

import os
import pathlib
import shutil
import sys
from typing import Any

import pytest

pyarrow = pytest.importorskip("pyarrow")

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
sys.path.insert(0, str(EXAMPLES))
# Workers import `folder` and the scripts, too.
os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, [str(EXAMPLES), os.environ.get("PYTHONPATH")]))
COUNT = 1000


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory, command: Any) -> tuple[Any, dict[str, "str | None"]]:
    """Programs as a table, and what the command line makes of each."""
    import folder

    programs, outputs = tmp_path_factory.mktemp("programs"), tmp_path_factory.mktemp("outputs")
    folder.generate(programs, COUNT)
    command("compile", programs, "--out-dir", outputs, "--quiet", "--isolated")
    made = {path.stem: path.read_bytes().decode() for path in outputs.rglob("*.ngc")}
    table = folder.programs(programs)
    names = table["name"].to_pylist()
    assert len(names) == COUNT and len(made) == COUNT - COUNT // 10
    return table, {name: made.get(name.removesuffix(".MPF")) for name in names}


def same(results: Any, wanted: "dict[str, str | None]") -> None:
    assert len(results) == COUNT
    for row in results:
        assert row["gcode"] == wanted[row["name"]], row["name"]
        assert row["ok"] == (row["gcode"] is not None) and (row["ok"] or row["diagnostics"])


def test_dask(source: Any) -> None:
    pytest.importorskip("dask")
    import dask_partitions

    same(dask_partitions.compile_all(source[0]).to_pylist(), source[1])


def test_ray(source: Any) -> None:
    ray = pytest.importorskip("ray")
    import ray_data

    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False, configure_logging=False)
    try:
        same(ray_data.compile_all(source[0]).to_pylist(), source[1])
    finally:
        ray.shutdown()


def test_spark(source: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    spark = pytest.importorskip("pyspark.sql")
    if shutil.which("java") is None:
        pytest.skip("Spark needs Java")
    import spark_map_in_arrow

    monkeypatch.setenv("PYSPARK_PYTHON", sys.executable)
    monkeypatch.setenv("SPARK_LOCAL_IP", "127.0.0.1")
    builder = spark.SparkSession.builder.master("local[2]").config("spark.ui.enabled", "false")
    session = builder.config("spark.driver.bindAddress", "127.0.0.1").getOrCreate()
    try:
        made = spark_map_in_arrow.compile_all(session, source[0]).collect()
        same([row.asDict(recursive=True) for row in made], source[1])
    finally:
        session.stop()
