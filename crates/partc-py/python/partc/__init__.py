"""Part programs of CNC controls as plain G-code, findings, pictures and tables.

What is wrong with a *program* is no exception: the result is not ``ok`` and has diagnostics. ``ConfigError`` says that the call or the
configuration cannot be used, ``InternalError`` that partc is at fault.
"""

from __future__ import annotations

import json
from typing import Optional

from . import _partc
from ._config import Config
from ._partc import Batch, Batches, ConfigError, InternalError, ProgramError, __version__
from ._results import Call, Checked, Diagnostic, Difference, Explanation, Picture, Result, Target, findings
from ._tables import Trace, compile_batch, compile_table, map_batches, trace_batches
from ._run import ConfigLike, Files, Program, job

__all__ = [
    "Batch",
    "Batches",
    "Call",
    "Checked",
    "Config",
    "ConfigError",
    "Diagnostic",
    "Difference",
    "Explanation",
    "InternalError",
    "Picture",
    "ProgramError",
    "Result",
    "Target",
    "Trace",
    "__version__",
    "check",
    "compile",
    "compile_batch",
    "compile_table",
    "diff",
    "explain",
    "map_batches",
    "plot",
    "targets",
    "trace",
    "trace_batches",
]


def compile(
    program: Program,
    *,
    files: Optional[Files] = None,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    name: Optional[str] = None,
) -> Result:
    """Compiles a program: ``bytes``, or a path as ``str`` or ``PathLike``.

    A path is compiled as on the command line: the nearest ``partc.toml`` holds unless ``config`` is given, and called
    programs are looked for beside it. Of ``bytes``, and wherever ``files`` is given, nothing but the program itself is
    read from disk: called programs and tables come from ``files``.
    """
    made = job(program, files=files, config=config, dialect=dialect, target=target, name=name)
    gcode, found, dropped, stats = made.compile()
    return Result(gcode, findings(found), json.loads(stats) if stats else None, dropped, made)


def check(
    program: Program,
    *,
    files: Optional[Files] = None,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    name: Optional[str] = None,
) -> Checked:
    """Everything there is to say of a program, also of blocks that never run."""
    made = job(program, files=files, config=config, dialect=dialect, target=target, name=name)
    found, dropped = made.check()
    return Checked(findings(found), dropped)


def trace(
    program: Program,
    *,
    files: Optional[Files] = None,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    name: Optional[str] = None,
    rows: int = 65_536,
) -> Trace:
    """The moves of a program as a table of Arrow, made as they are pulled, ``rows`` at a time."""
    made = job(program, files=files, config=config, dialect=dialect, target=target, name=name)
    return Trace._of(made, rows)


def plot(
    program: Program,
    *,
    files: Optional[Files] = None,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    name: Optional[str] = None,
    view: Optional[str] = None,
    dimensions: bool = False,
) -> Picture:
    """The resolved path as SVG; ``view`` is ``xy``, ``xz``, ``yz`` or ``iso``."""
    made = job(program, files=files, config=config, dialect=dialect, target=target, name=name)
    picture, found = made.plot(view, dimensions)
    return Picture(picture, findings(found))


def diff(
    a: Program,
    b: Program,
    *,
    files: Optional[Files] = None,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    names: tuple[str, str] = ("a", "b"),
    tolerance: float = 0.001,
) -> Difference:
    """Two programs, of any languages or plain G-code, compared as motion."""
    if isinstance(names, str) or len(names) != 2:
        raise TypeError("names are two: of the first program and of the second one")
    jobs = [
        job(program, files=files, config=config, dialect=dialect, target=target, name=name)
        for program, name in zip((a, b), names)
    ]
    ok, compared, text, found = _partc.diff(jobs[0], jobs[1], tolerance)
    return Difference(ok, json.loads(compared), text, findings(found))


def explain(code: str) -> Explanation:
    """What a diagnostic code means, and how to mend it; ``ConfigError`` where there is none of this name."""
    return Explanation(**json.loads(_partc.explain(code)))


def targets() -> list[Target]:
    """The receivers of G-code, and what each can say."""
    return [Target(**target) for target in json.loads(_partc.targets())]
