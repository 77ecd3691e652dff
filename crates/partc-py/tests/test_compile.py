"""compile, check, plot, diff, explain, and what they give."""

from __future__ import annotations

import multiprocessing
import os
import pathlib
import pickle
import random
import subprocess
import sys
import threading
import time

import partc
import pytest
from conftest import MILL, ROOT, WRONG


def test_bytes_are_compiled() -> None:
    result = partc.compile(MILL, name="PART.H")
    assert result.ok and result.gcode is not None and "G1 X10 F200" in result.gcode
    assert result.stats is not None and result.stats["moves"] == 7
    assert result.stats["tools"][0]["tool"] == 1
    assert partc.compile(MILL, name="PART.H") == result


def test_errors_of_a_program_are_no_exceptions() -> None:
    result = partc.compile(WRONG, name="WRONG.H")
    assert not result.ok and result.gcode is None and result.stats is None
    found = result.diagnostics[0]
    assert (found.severity, found.file, found.line) == ("error", "WRONG.H", 2)
    assert found.code in repr(found) and f"[{found.code}]" in str(found)
    with pytest.raises(AttributeError):
        found.line = 3  # type: ignore[misc]
    assert partc.explain(found.code).code == found.code


def test_usage_and_configuration_are_exceptions() -> None:
    with pytest.raises(partc.ConfigError, match="no dialect"):
        partc.compile(MILL, dialect="fanuc")
    with pytest.raises(partc.ConfigError, match="no target"):
        partc.compile(MILL, target="nobody")
    with pytest.raises(partc.ConfigError, match="which language"):
        partc.compile(b"\x00\x01")
    with pytest.raises(partc.ConfigError, match="did you mean"):
        partc.Config("[output]\ntraget = 'grbl'\n")
    with pytest.raises(partc.ConfigError):
        partc.explain("X0000")
    with pytest.raises(FileNotFoundError):
        partc.compile("no such file.H")
    with pytest.raises(IsADirectoryError):
        partc.compile(os.curdir)
    with pytest.raises(TypeError):
        partc.compile(12)  # type: ignore[arg-type]
    assert issubclass(partc.ConfigError, ValueError)


def test_golden_cases_are_those_of_the_library(cases: list[dict[str, object]]) -> None:
    compared = differing = 0
    for case in cases:
        program, config = str(case["program"]).encode("latin-1"), str(case["config"])
        called = {name: text.encode("latin-1") for name, text in case["called"]}  # type: ignore[attr-defined]
        name, dialect = str(case["file"]), str(case["dialect"])
        result = partc.compile(program, name=name, files=called, config=partc.Config(config), dialect=dialect)
        if str(case["name"]).startswith("errors/") and result.ok != (case["gcode"] is not None):
            differing += 1  # A check found it.
            continue
        assert result.gcode == case["gcode"], case["name"]
        compared += 1
    assert compared > 2000 and differing < compared // 20, (compared, differing)


def test_results_are_those_of_the_command_line(cases, command, tmp_path) -> None:  # type: ignore[no-untyped-def]
    compared = 0
    for case in [case for case in cases if not case["name"].startswith("errors/")][::40]:
        folder = tmp_path / str(compared)
        folder.mkdir()
        for name, text in [(case["file"], case["program"]), *case["called"]]:
            (folder / name).write_bytes(text.encode("latin-1"))
        (folder / "partc.toml").write_text(case["config"], encoding="utf-8", newline="\n")
        path = folder / case["file"]
        made = command("compile", path, "-o", "-", "--dialect", case["dialect"])
        result = partc.compile(path, dialect=case["dialect"])
        assert (result.gcode or "").encode() == made.stdout, case["name"]
        assert result.ok == (made.returncode == 0), case["name"]
        compared += 1
    assert compared > 20


def test_the_module_is_the_command_line(command) -> None:  # type: ignore[no-untyped-def]
    words = [sys.executable, "-m", "partc", "targets"]
    made = subprocess.run(words, capture_output=True, timeout=60, stdin=subprocess.DEVNULL, check=False)
    assert (made.returncode, made.stdout) == (0, command("targets").stdout)
    assert [target.name for target in partc.targets()][0] in made.stdout.decode()


def test_files_of_a_call_are_all_there_is(tmp_path, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    main = b"0 BEGIN PGM MAIN MM\n1 L X+0 Y+0 Z+0 R0 FMAX\n2 CALL PGM SUB\n3 END PGM MAIN MM\n"
    sub = b"0 BEGIN PGM SUB MM\n1 L X+7 F200\n2 END PGM SUB MM\n"
    (tmp_path / "SUB.H").write_bytes(sub)
    (tmp_path / "MAIN.H").write_bytes(main)
    (tmp_path / "partc.toml").write_text("[output]\ntarget = 'grbl'\n")
    monkeypatch.chdir(tmp_path)
    assert partc.compile("MAIN.H").ok
    for program in (main, "MAIN.H"):
        assert not partc.compile(program, name="MAIN.H", files={}).ok
        result = partc.compile(program, name="MAIN.H", files={"sub.h": sub.replace(b"X+7", b"X+8")})
        assert result.gcode is not None and "X8" in result.gcode
    assert not partc.compile(main, name="MAIN.H").ok
    result = partc.compile(main, name="MAIN.H", files={"SUB.H": sub.replace(b"X+7", b"X+")})
    stack = next(found.stack for found in result.diagnostics if found.stack)
    assert stack == (partc.Call("MAIN.H", 3),)


def test_a_tool_table_comes_with_the_files() -> None:
    config = partc.Config("[tools]\ntable = 'tool.tbl'\n")
    program = MILL.replace(b"R0 FMAX M3", b"RL F200 M3").replace(b"4 L IX+10", b"4 L IX+10 RL")
    with pytest.raises(partc.ConfigError, match="tool.tbl"):
        partc.compile(MILL, config=config, name="PART.H")
    assert partc.compile(MILL, config=config, name="PART.H", files={"tool.tbl": b"T1 P1 D10 Z50 ;MILL\n"}).ok
    whole = partc.Config(config.toml, tables={"tool.tbl": b"T1 P1 D10 Z50 ;MILL\n"})
    assert partc.compile(MILL, config=pickle.loads(pickle.dumps(whole)), name="PART.H").ok
    assert program != MILL


def test_configurations_are_values(tmp_path) -> None:  # type: ignore[no-untyped-def]
    text = "# a comment\n[output]\ntarget = 'grbl'\ndecimals = 3\n[machine]\nkind = 'mill'\n[datums]\nG54 = { X = 1.0 }\n"
    one = partc.Config(text)
    other = partc.Config.from_dict(
        {"machine": {"kind": "mill"}, "output": {"decimals": 3, "target": "grbl"}, "datums": {"G54": {"X": 1.0}}}
    )
    assert one == other and hash(one) == hash(other) and one != partc.Config()
    assert pickle.loads(pickle.dumps(one)) == one and eval(repr(one), {"Config": partc.Config}) == one
    (tmp_path / "base.toml").write_text(text)
    (tmp_path / "partc.toml").write_text("extend = 'base.toml'\n[tools]\ntable = 'tool.tbl'\n")
    (tmp_path / "tool.tbl").write_text("T1 P1 D10 Z50 ;MILL\n")
    file = partc.Config.from_file(tmp_path / "partc.toml")
    assert list(file.tables.values()) == [b"T1 P1 D10 Z50 ;MILL\n"] and "grbl" in file.toml
    by_path = partc.compile(MILL, config=str(tmp_path / "partc.toml"), name="PART.H")
    assert by_path == partc.compile(MILL, config=file, name="PART.H") != partc.compile(MILL, name="PART.H")
    with pytest.raises(partc.ConfigError, match="extend"):
        partc.Config("extend = 'base.toml'")


def test_pictures_and_pages(tmp_path, command) -> None:  # type: ignore[no-untyped-def]
    picture = partc.plot(MILL, name="PART.H")
    (tmp_path / "PART.H").write_bytes(MILL)
    assert command("plot", "PART.H", "-o", "-", "--isolated", cwd=tmp_path).stdout.decode() == picture.svg
    assert not partc.plot(WRONG, name="WRONG.H").ok
    result = partc.compile(MILL, name="<script>.H")
    page = result._repr_html_()
    assert "<svg" in page and "<script>" not in page
    wrong = partc.compile(b"0 BEGIN PGM A MM\n1 L X+1 <b>&\n2 END PGM A MM\n", name="<b>.H")
    assert "<b>" not in wrong._repr_html_() and "&lt;b&gt;" in wrong._repr_html_()
    with pytest.raises(partc.ConfigError, match="view"):
        partc.plot(MILL, view="side")


def test_programs_are_compared_as_motion() -> None:
    gcode = partc.compile(MILL, name="PART.H").gcode
    assert gcode is not None
    assert partc.diff(MILL, gcode.encode(), names=("PART.H", "PART.ngc")).same
    other = partc.diff(MILL, MILL.replace(b"IX+10", b"IX+11"), names=("A.H", "B.H"))
    assert other.ok and not other.same and other.largest is not None and other.largest > 0.9
    assert not partc.diff(MILL, WRONG, names=("A.H", "B.H")).ok


def test_a_check_finds_more() -> None:
    found = partc.check(WRONG, name="WRONG.H")
    assert not found.ok and partc.check(MILL, name="PART.H").ok
    assert found == pickle.loads(pickle.dumps(found))


def _in_process(program: bytes) -> partc.Result:
    return partc.compile(program, name="PART.H", config=partc.Config("[output]\ndecimals = 3\n"))


def test_results_travel_between_processes() -> None:
    programs = [MILL.replace(b"F200", b"F%d" % feed) for feed in range(200, 216)] + [WRONG]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        made = pool.map_async(_in_process, programs).get(timeout=120)
    assert made == [_in_process(program) for program in programs]
    assert "<table" in made[-1]._repr_html_() and made[0]._repr_html_()


def test_other_threads_go_on() -> None:
    lines = b"".join(b"%d L X+%d Y+%d F200\n" % (n, n % 100, n % 7) for n in range(1, 120_000))
    program = b"0 BEGIN PGM A MM\n" + lines + b"120000 END PGM A MM\n"
    done = threading.Event()
    worker = threading.Thread(target=lambda: (partc.compile(program, name="A.H"), done.set()))
    turns = 0
    worker.start()
    while not done.is_set():
        turns += 1
        time.sleep(0.001)
    worker.join()
    assert turns > 20, turns


def test_damaged_programs_do_no_harm() -> None:
    tries = int(os.environ.get("PARTC_TRIES", "10000"))
    chance = random.Random(17)
    seeds = [MILL, WRONG, (ROOT / "examples/flange.H").read_bytes()[:600], b"G17 G90\nG1 X10 F100\nCYCLE83(10,0,2,-5)\nM30\n"]
    names = ["A.H", "A.MPF", "A.nc", "A.npg", "A", "\x00", "ä<.H"]
    dialects = [None, "klartext", "sinumerik", "heidenhain-turning", "mtc200"]
    for _ in range(tries):
        text = bytearray(chance.choice(seeds))
        for _ in range(chance.randrange(1, 8)):
            at = chance.randrange(len(text))
            text[at : at + chance.randrange(3)] = bytes(chance.randrange(256) for _ in range(chance.randrange(4)))
        try:
            result = partc.compile(bytes(text), name=chance.choice(names), dialect=chance.choice(dialects))
        except partc.ConfigError:
            continue
        assert result.ok or any(found.severity == "error" for found in result.diagnostics)


def test_paths_are_paths(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "PART.H"
    path.write_bytes(MILL)
    one, other = partc.compile(path), partc.compile(str(path))
    assert one == other and one.ok


def test_names_that_are_no_text(tmp_path: pathlib.Path) -> None:
    for call in (
        lambda: partc.compile(MILL, name="\udcff.H"),
        lambda: partc.compile(MILL, name="A.H", dialect="\udcff"),
        lambda: partc.compile(MILL, name="A.H", target="\udcff"),
        lambda: partc.compile(MILL, name="A.H", files={"\udcff.H": MILL}),
        lambda: partc.compile(MILL, name="A.H", files={"B.H": "\udcff"}),
    ):
        with pytest.raises(partc.ConfigError, match="udcff"):
            call()
    # A file may have such a name where the system lets it.
    path = os.path.join(os.fsencode(tmp_path), b"PART\xe4.H")
    try:
        with open(path, "wb") as file:
            file.write(MILL)
    except OSError:
        return
    moves = partc.compile(MILL, name="PART.H").gcode
    assert moves is not None
    for made in (partc.compile(os.fsdecode(path)), partc.compile(os.fsdecode(path), files={})):
        assert made.gcode is not None and made.gcode.splitlines()[3:] == moves.splitlines()[3:]


def test_arguments_of_another_kind() -> None:
    for call in (
        lambda: partc.compile(MILL, files={"HOLE.H": 5}),  # type: ignore[dict-item]
        lambda: partc.compile(MILL, files={"HOLE.H": [48, 32]}),  # type: ignore[dict-item]
        lambda: partc.compile(MILL, files={5: MILL}),  # type: ignore[dict-item]
        lambda: partc.compile(MILL, files=["HOLE.H"]),  # type: ignore[arg-type]
        lambda: partc.compile(MILL, name=5),  # type: ignore[arg-type]
        lambda: partc.check(MILL, dialect=5),  # type: ignore[arg-type]
        lambda: partc.compile(MILL, target=5),  # type: ignore[arg-type]
        lambda: partc.Config("", tables={"T.TBL": 5}),  # type: ignore[dict-item]
        lambda: partc.diff(MILL, MILL, names="AB"),  # type: ignore[arg-type]
        lambda: partc.diff(MILL, MILL, names=("A",)),  # type: ignore[arg-type]
    ):
        with pytest.raises(TypeError):
            call()
    with pytest.raises(partc.ConfigError, match="udcff"):
        partc.Config("# \udcff")


def test_numbers_of_numpy_are_numbers_of_a_configuration() -> None:
    numpy = pytest.importorskip("numpy")
    plain, other = (
        partc.Config.from_dict({"output": {"decimals": {"length": places}, "arc_fallback_tolerance": way}})
        for places, way in ((4, 0.25), (numpy.int64(4), numpy.float64(0.25)))
    )
    assert other == plain
