"""What the commands give: plain values that can be compared and pickled."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from html import escape
from typing import Any, Optional

from . import _partc

# Findings that a notebook shows.
_SHOWN = 50


@dataclass(frozen=True)
class Call:
    """The block of a call."""

    file: str
    line: int


@dataclass(frozen=True)
class Diagnostic:
    """What was found at a place; lines and columns count from 1, columns in characters."""

    code: str
    name: str
    severity: str
    message: str
    help: Optional[str]
    file: str
    line: int
    column: int
    end_line: int
    end_column: int
    block: Optional[str]
    stack: tuple[Call, ...]
    """The calls that led there, the innermost first."""
    times: int = 1
    """How often the same was found at the same place."""

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}: {self.severity}[{self.code}]: {self.message}"


def findings(text: str) -> tuple[Diagnostic, ...]:
    """From the JSON of the native half."""
    return tuple(_finding(found) for found in json.loads(text))


def _finding(found: dict[str, Any]) -> Diagnostic:
    stack = tuple(Call(call["file"], call["line"]) for call in found["stack"])
    keys = ("code", "name", "severity", "message", "help", "file", "line", "column", "end_line", "end_column", "block", "times")
    return Diagnostic(**{key: found[key] for key in keys}, stack=stack)


def _no_errors(diagnostics: tuple[Diagnostic, ...]) -> bool:
    return not any(found.severity == "error" for found in diagnostics)


def _table(diagnostics: tuple[Diagnostic, ...], dropped: int) -> str:
    if not diagnostics:
        return "<p>No findings.</p>"
    rows = "".join(
        f"<tr><td>{escape(found.code)}</td><td>{escape(found.severity)}</td><td>{escape(found.file)}:{found.line}</td>"
        f"<td style='text-align:left'>{escape(found.message)}"
        + (f"<br><small>{escape(found.help)}</small>" if found.help else "")
        + "</td></tr>"
        for found in diagnostics[:_SHOWN]
    )
    more = len(diagnostics) - _SHOWN + dropped if len(diagnostics) > _SHOWN else dropped
    rest = f"<p>{more} more findings.</p>" if more else ""
    return f"<table><tr><th>code</th><th></th><th>block</th><th>finding</th></tr>{rows}</table>{rest}"


@dataclass(frozen=True)
class Checked:
    """Findings of a program."""

    diagnostics: tuple[Diagnostic, ...]
    dropped: int = 0
    """Findings that were left out because there are very many."""

    @property
    def ok(self) -> bool:
        """No errors."""
        return _no_errors(self.diagnostics)

    def _repr_html_(self) -> str:
        return _table(self.diagnostics, self.dropped)


@dataclass(frozen=True)
class Result:
    """A compiled program."""

    gcode: Optional[str]
    """``None`` where the program has errors."""
    diagnostics: tuple[Diagnostic, ...]
    stats: Optional[dict[str, Any]]
    """The figures of ``partc stats``; ``None`` where the program has errors."""
    dropped: int = 0
    """Findings that were left out because there are very many."""
    _job: Optional[_partc.Job] = field(default=None, repr=False, compare=False)

    @property
    def ok(self) -> bool:
        """The program has no errors, and there is G-code."""
        return self.gcode is not None

    def __hash__(self) -> int:
        return hash((self.gcode, self.diagnostics))

    def __repr__(self) -> str:
        lines = "no G-code" if self.gcode is None else f"{self.gcode.count(chr(10))} lines"
        return f"<partc.Result ok={self.ok}, {lines}, {len(self.diagnostics)} diagnostics>"

    def __getstate__(self) -> dict[str, Any]:
        # The program stays behind: a result on its way between machines is what was made of it.
        return {**self.__dict__, "_job": None}

    def _repr_html_(self) -> str:
        """Picture and findings for a notebook; after pickling there is no picture."""
        picture = self._job.plot(None, False)[0] if self.ok and self._job is not None else None
        shown = f"<div style='max-width:640px'>{_drawn(picture)}</div>" if picture else ""
        return f"<div>{shown}{_table(self.diagnostics, self.dropped)}</div>"


def _drawn(svg: str) -> str:
    """The picture inside HTML: what stands in front of the root element has no place there."""
    return svg[max(svg.find("<svg"), 0) :]


@dataclass(frozen=True)
class Picture:
    """A path as SVG."""

    svg: Optional[str]
    """``None`` where the program has errors."""
    diagnostics: tuple[Diagnostic, ...] = ()

    @property
    def ok(self) -> bool:
        return self.svg is not None

    def __str__(self) -> str:
        return self.svg or ""

    def __repr__(self) -> str:
        return f"<partc.Picture ok={self.ok}, {len(self.diagnostics)} diagnostics>"

    def _repr_html_(self) -> str:
        return _drawn(self.svg) if self.svg else _table(self.diagnostics, 0)


@dataclass(frozen=True)
class Difference:
    """What two programs do differently."""

    ok: bool
    """Both could be compared: neither has errors."""
    data: Optional[dict[str, Any]]
    """The document of ``partc diff --format json``, without its version."""
    text: str
    """The same for people."""
    diagnostics: tuple[Diagnostic, ...] = ()

    @property
    def same(self) -> bool:
        """Both were compared, and do the same."""
        return self.data is not None and bool(self.data["same"])

    @property
    def largest(self) -> Optional[float]:
        """Largest distance of two places that belong together, mm or degrees."""
        return None if self.data is None else float(self.data["largest"])

    def __hash__(self) -> int:
        return hash(self.text)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<partc.Difference ok={self.ok}, same={self.same}>"


@dataclass(frozen=True)
class Explanation:
    """A diagnostic code."""

    code: str
    name: str
    severity: str
    title: str
    text: str
    example: Optional[str]

    def __str__(self) -> str:
        return f"{self.code} {self.name}: {self.title}\n\n{self.text}"


@dataclass(frozen=True)
class Target:
    """A receiver of G-code."""

    name: str
    about: str
    extension: str
    abilities: dict[str, str] = field(hash=False)
