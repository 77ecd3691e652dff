"""Moves and results as tables. No library for tables is imported here; what comes in says what goes out."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator
from typing import Any, Optional, TypeVar, Union, cast

from . import _partc
from ._results import Diagnostic, findings
from ._run import ConfigLike, Files, Program, job, settings

_Table = TypeVar("_Table")
Named = Union[Program, "tuple[str, Program]"]


class Trace:
    """The moves of a program, a row each, for anything that takes streams of Arrow.

    ``polars.DataFrame(trace)``, ``pyarrow.table(trace)``, ``pandas.DataFrame.from_arrow(trace)``, ``duckdb.sql("FROM trace")``. Each
    use begins with the first move. A program with errors has no rows, for its moves end where nobody knows: whoever asks for them gets
    ``ProgramError``. ``ok`` and ``diagnostics`` say it before.
    """

    def __init__(self, *_: Any) -> None:
        raise TypeError("partc.trace makes these")

    _traced: _partc.Traced
    _rows: int
    _diagnostics: tuple[Diagnostic, ...]

    @classmethod
    def _of(cls, made: _partc.Job, rows: int) -> Trace:
        if rows < 1:
            raise _partc.ConfigError("a batch has at least one row")
        trace = object.__new__(cls)
        trace._traced = made.trace(rows)
        trace._rows = rows
        trace._diagnostics = findings(trace._traced.findings)
        return trace

    @property
    def ok(self) -> bool:
        """The program has no errors."""
        return self._traced.ok

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        return self._diagnostics

    def batches(self, rows: Optional[int] = None) -> _partc.Batches:
        """The moves from the first one on, so many rows at a time."""
        if rows is not None and rows < 1:
            raise _partc.ConfigError("a batch has at least one row")
        if not self.ok:
            first = next(found for found in self.diagnostics if found.severity == "error")
            raise _partc.ProgramError(str(first))
        return self._traced.batches(rows or self._rows)

    def to_rows(self) -> list[dict[str, Any]]:
        """A dictionary for each move, all in memory."""
        return [row for batch in self.batches() for row in batch.to_rows()]

    def __arrow_c_stream__(self, requested_schema: Optional[object] = None) -> object:
        return self.batches().__arrow_c_stream__(requested_schema)

    def __arrow_c_schema__(self) -> object:
        return _partc.trace_schema()

    def __repr__(self) -> str:
        return f"<partc.Trace ok={self.ok}, {len(self.diagnostics)} diagnostics>"


def trace_batches(
    programs: Union[Program, Iterable[Named]],
    *,
    rows: int = 65_536,
    files: Optional[Files] = None,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    checked: bool = True,
) -> Iterator[_partc.Batch]:
    """The moves of a program, or of many behind each other, as batches; memory does not grow with them.

    Of many programs each is a path, ``bytes``, or a pair of name and program; the column ``file`` tells them apart. One with errors
    raises ``ProgramError`` before any of its moves is given: each program runs twice for that, unless it is short. With
    ``checked=False`` it runs once, and ``ProgramError`` comes behind the batches that were full before the first error: what was
    made of them is to be thrown away.
    """
    if rows < 1:
        raise _partc.ConfigError("a batch has at least one row")
    alone = isinstance(programs, (bytes, bytearray, memoryview, str, os.PathLike))
    for program in cast("Iterable[Named]", [programs] if alone else programs):
        name, text = program if isinstance(program, tuple) else (None, program)
        made = job(text, files=files, config=config, dialect=dialect, name=name)
        yield from Trace._of(made, rows).batches() if checked else made.stream(rows)


def compile_table(
    table: object,
    *,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    jobs: int = 1,
) -> _partc.Batches:
    """Compiles each row of a table: columns ``program`` (text or bytes), and where there are such ``name``, ``files`` and ``config``.

    The results have the columns name, ok, gcode, diagnostics, errors, warnings, moves, cutting_mm, rapid_mm, time_s and
    trouble, and are made batch by batch as they are pulled, on so many threads. A row that cannot be used – a language that nobody
    knows, a configuration that does not fit – is not ok, and its ``trouble`` says why.
    """
    if jobs < 1:
        raise _partc.ConfigError("a table is compiled by at least one thread")
    return _partc.compile_table(table, settings(config), dialect, target, jobs)


def compile_batch(
    batch: _Table,
    *,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    jobs: int = 1,
) -> _Table:
    """As ``compile_table``; the results are of the kind that came: a table or batch of PyArrow, a frame of Polars or pandas."""
    return cast(_Table, _like(batch, compile_table(batch, config=config, dialect=dialect, target=target, jobs=jobs)))


def map_batches(
    batches: Iterable[_Table],
    *,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    jobs: int = 1,
) -> Iterator[_Table]:
    """``compile_batch`` for each: what ``mapInArrow`` of Spark calls."""
    for batch in batches:
        yield compile_batch(batch, config=config, dialect=dialect, target=target, jobs=jobs)


def _like(sample: Any, made: _partc.Batches) -> Any:
    arrow = sys.modules.get("pyarrow")
    if arrow is not None and isinstance(sample, arrow.RecordBatch):
        whole = arrow.table(made).combine_chunks().to_batches()
        return whole[0] if whole else arrow.RecordBatch.from_pylist([], schema=arrow.schema(made))
    if arrow is not None and isinstance(sample, arrow.Table):
        return arrow.table(made)
    polars = sys.modules.get("polars")
    if polars is not None and isinstance(sample, polars.DataFrame):
        return polars.DataFrame(made)
    pandas = sys.modules.get("pandas")
    if pandas is not None and isinstance(sample, pandas.DataFrame):
        # pandas itself needs PyArrow for this.
        import pyarrow

        return pyarrow.table(made).to_pandas()
    return made
