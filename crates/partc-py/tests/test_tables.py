"""Traces and tables in the libraries that read them."""

from __future__ import annotations

import gc
import json
import os
import pathlib
import sys
from typing import Any

import partc
import pytest
from conftest import MILL, WRONG

duckdb = pytest.importorskip("duckdb")
pandas = pytest.importorskip("pandas")
polars = pytest.importorskip("polars")
pyarrow = pytest.importorskip("pyarrow")

# More rows than are kept, in several batches.
LONG = b"G17 G90 G54\nG0 X0 Y0 Z0\n" + b"".join(b"G1 X%d Y%d F500\n" % (n % 90, n % 11) for n in range(1, 150_001)) + b"M30\n"


def test_all_libraries_read_the_same(command: Any, tmp_path: Any) -> None:
    trace = partc.trace(MILL, name="PART.H")
    assert trace.ok
    rows = trace.to_rows()
    table = pyarrow.table(trace)
    assert table.to_pylist() == rows
    assert polars.DataFrame(trace).to_dicts() == rows
    relation = duckdb.sql("SELECT kind, x, y, feed, length, line FROM trace")
    keys = ("kind", "x", "y", "feed", "length", "line")
    assert [tuple(row[key] for key in keys) for row in rows] == relation.fetchall()
    frame = pandas.DataFrame.from_arrow(trace) if hasattr(pandas.DataFrame, "from_arrow") else table.to_pandas()
    assert frame["length"].fillna(-1).tolist() == [-1 if row["length"] is None else row["length"] for row in rows]
    # The moves of the command line.
    (tmp_path / "PART.H").write_bytes(MILL)
    lines = command("trace", "PART.H", "--isolated", cwd=tmp_path).stdout.decode().splitlines()
    assert len(lines) == len(rows)
    for line, row in zip(map(json.loads, lines), rows):
        for axis in "xyz":
            said = line["end"].get(axis.upper())
            assert (said is None) == (row[axis] is None) and (said is None or abs(said - row[axis]) < 1e-9)
        assert (line["kind"], line["line"]) == (row["kind"], row["line"])


def test_the_schema_is_known_before_a_move() -> None:
    trace = partc.trace(MILL, name="PART.H")
    schema = pyarrow.schema(trace)
    assert schema == pyarrow.table(trace).schema
    assert schema.metadata[b"partc.trace"] == b"1" and schema.field("x").metadata == {b"unit": b"mm"}


def test_long_traces_are_made_as_they_are_pulled() -> None:
    trace = partc.trace(LONG, name="A.MPF", rows=10_000)
    sizes = [batch.num_rows for batch in trace.batches()]
    assert sum(sizes) == 150_001 and sizes[:2] == [10_000, 10_000]
    for _ in range(2):
        assert pyarrow.table(trace).num_rows == 150_001
    assert polars.DataFrame(trace)["length"].sum() == pytest.approx(partc.compile(LONG, name="A.MPF").stats["cutting_mm"])
    # Whoever stops early stops the run.
    for _ in range(20):
        assert next(iter(trace.batches(1000))).num_rows == 1000
    gc.collect()
    reader = pyarrow.RecordBatchReader.from_stream(trace)
    assert reader.read_next_batch().num_rows == 10_000
    del reader


def test_batches_can_be_taken_once() -> None:
    batches = partc.trace(MILL, name="PART.H").batches()
    assert pyarrow.table(batches).num_rows > 0
    with pytest.raises(ValueError, match="taken"):
        pyarrow.table(batches)
    unused = partc.trace(MILL, name="PART.H").batches().__arrow_c_stream__()
    del unused
    for batch in partc.trace(MILL, name="PART.H").batches(3):
        assert pyarrow.record_batch(batch).to_pylist() == batch.to_rows() and len(batch) == batch.num_rows
        assert batch.column_names[0] == "kind"


def test_no_move_of_a_program_with_errors_gets_out() -> None:
    wrong = b"G17 G90\nG0 X0 Y0 Z0\nG1 X10 F100\nG1 X<20\nM30\n"
    trace = partc.trace(wrong, name="A.MPF")
    assert not trace.ok and trace.diagnostics
    for ask in (trace.to_rows, trace.batches, lambda: pyarrow.table(trace), lambda: polars.DataFrame(trace)):
        with pytest.raises(partc.ProgramError, match="A.MPF:4"):
            ask()
    with pytest.raises(partc.ProgramError, match="A.MPF:4"):
        list(partc.trace_batches([("A.MPF", wrong)]))
    with pytest.raises(partc.ConfigError):
        partc.trace(MILL, name="PART.H", rows=0)


def test_many_programs_are_one_table() -> None:
    programs = [(f"{n}.H", MILL) for n in range(5)]
    batches = list(partc.trace_batches(programs, rows=3))
    rows = [row for batch in batches for row in batch.to_rows()]
    assert [row["file"] for row in rows[:: len(rows) // 5]] == [name for name, _ in programs]
    assert rows[: len(rows) // 5] == partc.trace(MILL, name="0.H").to_rows()


def test_a_stream_that_is_not_checked_ends_at_the_first_error() -> None:
    moves = b"".join(b"G1 X%d F100\n" % n for n in range(10))
    sound = b"G17 G90\nG0 X0 Y0 Z0\n" + moves + b"M30\n"
    whole = [batch.to_rows() for batch in partc.trace_batches([("A.MPF", sound)], rows=4)]
    assert [batch.to_rows() for batch in partc.trace_batches([("A.MPF", sound)], rows=4, checked=False)] == whole
    given = []
    with pytest.raises(partc.ProgramError, match=r"A\.MPF:10:\d+: error\[[A-Z]\d+\]: .*none of the program's moves"):
        for batch in partc.trace_batches([("A.MPF", sound.replace(b"X7", b"X<7"))], rows=4, checked=False):
            given.append(batch.to_rows())
    assert given == whole[: len(given)] and 0 < len(given) < len(whole)
    with pytest.raises(partc.ConfigError):
        list(partc.trace_batches(sound, rows=0, checked=False))


def programs(count: int) -> dict[str, list[Any]]:
    texts = [WRONG if n % 7 == 0 else MILL.replace(b"F200", b"F%d" % (200 + n)) for n in range(count)]
    return {"name": [f"P{n}.H" for n in range(count)], "program": texts}


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_table_is_compiled(jobs: int) -> None:
    source = programs(50)
    made = pyarrow.table(partc.compile_table(pyarrow.table(source), jobs=jobs, target="grbl"))
    for row, name, program in zip(made.to_pylist(), source["name"], source["program"]):
        one = partc.compile(program, name=name, target="grbl")
        assert (row["name"], row["ok"], row["gcode"]) == (name, one.ok, one.gcode)
        assert [found["code"] for found in row["diagnostics"]] == [found.code for found in one.diagnostics]
        assert row["errors"] == sum(found.severity == "error" for found in one.diagnostics)
        assert row["trouble"] is None and row["moves"] == (one.stats["moves"] if one.stats else None)
    assert pyarrow.schema(partc.compile_table(pyarrow.table(source))) == made.schema


def test_tables_come_in_any_form() -> None:
    source = programs(20)
    text = {"name": source["name"], "program": [program.decode() for program in source["program"]]}
    wanted = pyarrow.table(partc.compile_table(pyarrow.table(source)))["gcode"].to_pylist()
    frame = polars.DataFrame(text)
    assert partc.compile_batch(frame)["gcode"].to_list() == wanted
    assert partc.compile_batch(polars.DataFrame(source))["gcode"].to_list() == wanted
    made = partc.compile_batch(pandas.DataFrame(text))
    assert [code if isinstance(code, str) else None for code in made["gcode"]] == wanted
    assert pyarrow.table(partc.compile_table(duckdb.sql("FROM frame").arrow()))["gcode"].to_pylist() == wanted
    batches = pyarrow.table(text).to_batches(max_chunksize=6)
    out = list(partc.map_batches(iter(batches)))
    assert [len(batch) for batch in out] == [6, 6, 6, 2] and isinstance(out[0], pyarrow.RecordBatch)
    assert pyarrow.Table.from_batches(out)["gcode"].to_pylist() == wanted
    empty = partc.compile_batch(batches[0].slice(0, 0))
    assert len(empty) == 0 and empty.schema == out[0].schema


def test_rows_bring_files_and_configuration() -> None:
    main = b"0 BEGIN PGM MAIN MM\n1 L X+0 Y+0 Z+0 R0 FMAX\n2 CALL PGM SUB\n3 END PGM MAIN MM\n"
    sub = b"0 BEGIN PGM SUB MM\n1 L X+7 F200\n2 END PGM SUB MM\n"
    columns = {
        "name": ["A.H", "B.H", "C", "D.H"],
        "program": [main, main, b"\x00", main],
        "config": ["[output]\ntarget = 'grbl'\n", None, None, "[output]\ntraget = 1\n"],
    }
    files = [[("SUB.H", sub)], None, None, [("SUB.H", sub)]]
    for kind in (pyarrow.map_(pyarrow.string(), pyarrow.binary()),
                 pyarrow.list_(pyarrow.struct([("name", pyarrow.string()), ("bytes", pyarrow.binary())]))):
        pairs: Any = files if "map" in str(kind) else [
            pair and [{"name": name, "bytes": text} for name, text in pair] for pair in files
        ]
        table = pyarrow.table({**columns, "files": pyarrow.array(pairs, type=kind)})
        made = pyarrow.table(partc.compile_table(table)).to_pylist()
        assert [row["ok"] for row in made] == [True, False, False, False]
        assert made[0]["gcode"] == partc.compile(main, name="A.H", files={"SUB.H": sub}, target="grbl").gcode
        assert made[1]["diagnostics"] and "which language" in made[2]["trouble"] and "target" in made[3]["trouble"]
    with pytest.raises(partc.ConfigError, match="program"):
        partc.compile_table(pyarrow.table({"name": ["A.H"]}))
    with pytest.raises(partc.ConfigError, match="__arrow_c_stream__"):
        partc.compile_table([1, 2])
    with pytest.raises(partc.ConfigError, match="neither text"):
        list(partc.compile_table(pyarrow.table({"program": [1]})))


def test_nothing_else_is_imported() -> None:
    code = (
        "import sys, partc; partc.trace(b'G17 G90\\nG0 X0 Y0 Z0\\nG1 X1 F100\\nM30\\n', name='A.MPF').to_rows();"
        "print(sorted({'pyarrow', 'polars', 'pandas', 'numpy', 'duckdb'} & set(sys.modules)))"
    )
    import subprocess

    made = subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=60, stdin=subprocess.DEVNULL)
    assert made.stdout.decode().strip() == "[]", made.stderr


def test_a_program_that_changes_behind_its_check(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "A.H"
    body = "".join(f"{n} L X+{n % 90} Y+{n % 7} F200\n" for n in range(3, 70_000))
    text = "0 BEGIN PGM A MM\n1 TOOL CALL 3 Z S2000\n2 L X+0 Y+0 Z+10 R0 FMAX M3\n" + body + "70000 END PGM A MM\n"
    path.write_text(text)
    trace = partc.trace(path)
    assert sum(batch.num_rows for batch in trace.batches()) > 65_536
    path.write_text(text.replace("500 L X+50", "500 L X+51"))
    with pytest.raises(partc.ProgramError, match=r"A\.H: the program has changed"):
        list(trace.batches())
    path.write_text(text)
    assert sum(batch.num_rows for batch in trace.batches()) > 65_536


FORKED = """
import os, signal, sys, partc
program = b"G17 G90\\nG0 X0 Y0 Z0\\n" + b"".join(b"G1 X%d F100\\n" % (n % 90) for n in range(50_000)) + b"M30\\n"
def rows(): return sum(map(len, partc.trace_batches([("A.MPF", program)])))
whole = rows()
begun = partc.trace_batches([("A.MPF", program)], rows=10, checked=False)
first = len(next(begun))
child = os.fork()
if child == 0:
    signal.alarm(30)
    try:
        list(begun)
    except partc.ConfigError as error:
        assert "another process" in str(error)
        os._exit(7 if rows() == whole else 8)
    os._exit(9)
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
assert first == 10 and first + sum(map(len, begun)) == whole == 50_000
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_batches_of_a_process_are_not_pulled_in_its_fork() -> None:
    import subprocess

    made = subprocess.run([sys.executable, "-W", "ignore", "-c", FORKED], capture_output=True, timeout=90, stdin=subprocess.DEVNULL)
    assert made.returncode == 0, made.stderr.decode()


def test_columns_of_words_that_are_kept_once() -> None:
    names = pyarrow.array(["A.H", None, "B.H", "A.H"]).dictionary_encode()
    program = pyarrow.array([MILL, MILL, b"?", None], pyarrow.binary()).dictionary_encode()
    plain = pyarrow.table({"name": names.cast(pyarrow.string()), "program": program.cast(pyarrow.binary())})
    assert partc.compile_batch(pyarrow.table({"name": names, "program": program})) == partc.compile_batch(plain)
    assert partc.compile_batch(plain)["ok"].to_pylist() == [True, True, False, False]


def test_columns_that_say_two_things_are_refused() -> None:
    twice = pyarrow.Table.from_arrays([pyarrow.array([b"?"]), pyarrow.array([MILL])], names=["program", "program"])
    with pytest.raises(partc.ConfigError, match="two columns `program`"):
        partc.compile_batch(twice)
    pair = pyarrow.struct([("bytes", pyarrow.binary()), ("name", pyarrow.string())])
    files = pyarrow.array([[{"bytes": b"", "name": "HOLE.H"}]], pyarrow.list_(pair))
    with pytest.raises(partc.ConfigError, match="the name behind the bytes"):
        list(partc.compile_table(pyarrow.table({"program": [MILL], "files": files})))
    with pytest.raises(partc.ConfigError, match="at least one thread"):
        partc.compile_batch(twice, jobs=0)
