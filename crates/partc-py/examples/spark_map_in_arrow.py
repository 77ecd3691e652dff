"""Compiles a folder of part programs with Spark's `mapInArrow`: `python spark_map_in_arrow.py FOLDER`."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import pyarrow
from folder import programs
from pyspark.sql import DataFrame, SparkSession

FINDING = (
    "struct<code:string,name:string,severity:string,message:string,help:string,file:string,line:bigint,column:bigint,"
    "end_line:bigint,end_column:bigint,block:string,call_path:string>"
)
RESULT = (
    f"name string, ok boolean, gcode string, diagnostics array<{FINDING}>, errors bigint, warnings bigint, moves bigint, "
    "cutting_mm double, rapid_mm double, time_s double, trouble string"
)


def compiled(batches: Iterator[pyarrow.RecordBatch]) -> Iterator[pyarrow.RecordBatch]:
    """Runs in the workers: the package is installed there, no file of this machine is needed."""
    import partc

    return partc.map_batches(batches)


def compile_all(spark: SparkSession, table: pyarrow.Table, partitions: int = 8) -> DataFrame:
    """A row for each program."""
    rows = list(zip(table["name"].to_pylist(), map(bytearray, table["program"].to_pylist())))
    source = spark.createDataFrame(rows, "name string, program binary").repartition(partitions)
    return source.mapInArrow(compiled, RESULT)


if __name__ == "__main__":
    session = SparkSession.builder.master("local[2]").appName("partc").getOrCreate()
    results = compile_all(session, programs(sys.argv[1])).cache()
    print(f"{results.count()} programs, {results.where('not ok').count()} refused")
    session.stop()
