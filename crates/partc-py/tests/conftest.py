"""Programs for the tests."""

from __future__ import annotations

import json
import os
import pathlib
import subprocess
from typing import Any, Callable

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]

MILL = b"""0 BEGIN PGM PART MM
1 TOOL CALL 1 Z S1000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 LBL 1
4 L IX+10 F200
5 CC IX+0 IY+5
6 CP IPA+90 DR+ F150
7 CALL LBL 1 REP 2
8 L Z+100 R0 FMAX M30
9 END PGM PART MM
"""

WRONG = b"0 BEGIN PGM WRONG MM\n1 L X+10 F<200\n2 FN 0: Q1 = \n3 END PGM WRONG MM\n"


@pytest.fixture(scope="session")
def cases() -> list[dict[str, Any]]:
    """The golden cases, as `PARTC_CASES` names them."""
    path = os.environ.get("PARTC_CASES")
    if path is None:
        pytest.skip("PARTC_CASES names no file: crates/partc-py/ci writes it")
    return [json.loads(line) for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines()]


@pytest.fixture(scope="session")
def command() -> Callable[..., "subprocess.CompletedProcess[bytes]"]:
    """The command line of partc."""
    binary = os.environ.get("PARTC_BINARY", str(ROOT / "target/debug/partc"))
    if not pathlib.Path(binary).exists():
        pytest.skip("the binary is not built")

    def run(*arguments: object, cwd: Any = None) -> "subprocess.CompletedProcess[bytes]":
        words = [binary, *map(str, arguments)]
        return subprocess.run(words, capture_output=True, timeout=120, stdin=subprocess.DEVNULL, cwd=cwd, check=False)

    return run
