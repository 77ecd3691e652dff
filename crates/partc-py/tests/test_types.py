"""The types of the package, and of its native half."""

from __future__ import annotations

import pathlib
import subprocess
import sys

import partc
import pytest

PACKAGE = pathlib.Path(__file__).resolve().parents[1] / "python" / "partc"


def run(*words: str) -> str:
    made = subprocess.run(
        [sys.executable, "-m", *words], capture_output=True, timeout=300, stdin=subprocess.DEVNULL, text=True, check=False
    )
    assert made.returncode == 0, made.stdout + made.stderr
    return made.stdout


def test_the_package_is_typed() -> None:
    pytest.importorskip("mypy")
    assert (pathlib.Path(partc.__file__).parent / "py.typed").exists()
    run("mypy", "--strict", "--ignore-missing-imports", str(PACKAGE))


def test_the_stubs_are_those_of_the_module() -> None:
    pytest.importorskip("mypy")
    run("mypy.stubtest", "partc._partc", "--ignore-missing-stub", "--ignore-disjoint-bases")


def test_a_user_is_told(tmp_path: pathlib.Path) -> None:
    pytest.importorskip("mypy")
    (tmp_path / "user.py").write_text(
        "import partc\nresult = partc.compile(b'')\nreveal_type(result.gcode)\nreveal_type(result.diagnostics[0].line)\n"
    )
    told = run("mypy", "--strict", str(tmp_path / "user.py"))
    assert "str | None" in told.replace("builtins.", "") and '"int"' in told.replace("builtins.", "")
