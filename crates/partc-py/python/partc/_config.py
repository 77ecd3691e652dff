"""A configuration as a value."""

from __future__ import annotations

import operator
import os
from collections.abc import Mapping
from typing import Any, Optional, Union

from . import _partc


class Config:
    """What a ``partc.toml`` says, with the tables that it names.

    Two configurations that say the same are equal, whatever their order, comments and blanks. A configuration can be pickled,
    and then needs no file of the machine it comes from but the programs below its ``[include] roots``.
    """

    __slots__ = ("_settings", "_tables", "_toml")

    _settings: _partc.Settings
    _tables: tuple[tuple[str, bytes], ...]
    _toml: str

    def __init__(self, toml: str = "", *, tables: Optional[Mapping[str, bytes]] = None) -> None:
        """From the text of a ``partc.toml``; ``tables`` holds the tool and datum tables that it names, by name.

        Raises ``partc.ConfigError`` for unknown keys and values that do not fit.
        """
        if not isinstance(toml, str):
            raise TypeError("the text of a configuration is a str; Config.from_dict and Config.from_file take others")
        text_of("the configuration", toml)
        named = tuple(sorted((text_of("the name", name), bytes_of(name, table)) for name, table in (tables or {}).items()))
        # Places in messages are those of the text as it was written.
        self._settings = _partc.Settings(toml, named)
        self._toml = _partc.canonical(toml)
        self._tables = named

    @classmethod
    def from_file(cls, path: Union[str, os.PathLike[str]]) -> Config:
        """From a ``partc.toml`` with what it extends; the tables that it names are read now."""
        os.stat(path)
        toml, tables = _partc.load(path)
        return cls(toml, tables=dict(tables))

    @classmethod
    def from_dict(cls, sections: Mapping[str, Any], *, tables: Optional[Mapping[str, bytes]] = None) -> Config:
        """From sections as dictionaries: ``{"output": {"target": "grbl"}}``."""
        lines = []
        for name, section in sections.items():
            if isinstance(section, Mapping):
                lines.append(f"[{_string(name)}]")
                lines.extend(f"{_string(key)} = {_value(value)}" for key, value in section.items())
            else:
                raise _partc.ConfigError(f"`{name}` is a table: a dictionary of keys")
        return cls("\n".join(lines), tables=tables)

    @property
    def toml(self) -> str:
        """The text in one form, for comparison and for a file."""
        return self._toml

    @property
    def tables(self) -> dict[str, bytes]:
        """The tables that were handed over or read."""
        return dict(self._tables)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Config):
            return NotImplemented
        return (self._toml, self._tables) == (other._toml, other._tables)

    def __hash__(self) -> int:
        return hash((self._toml, self._tables))

    def __repr__(self) -> str:
        tables = f", tables={{{', '.join(f'{name!r}: ...' for name, _ in self._tables)}}}" if self._tables else ""
        return f"Config({self._toml!r}{tables})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self._toml, self._tables)


def text_of(what: str, text: object) -> str:
    """The text, where it is one that can be written down."""
    if not isinstance(text, str):
        raise TypeError(f"{what} {text!r} is a {type(text).__name__}, and no str")
    try:
        text.encode()
    except UnicodeEncodeError:
        raise _partc.ConfigError(f"{what} {ascii(text)} holds half a character: it is no text") from None
    return text


def bytes_of(name: object, text: object) -> bytes:
    """The bytes of a file; ``bytes`` itself would make so many zeros of a number."""
    if isinstance(text, str):
        return text_of("the text", text).encode()
    if not isinstance(text, (bytes, bytearray, memoryview)):
        raise TypeError(f"the file {name!r} is a {type(text).__name__}, and neither bytes nor str")
    return bytes(text)


def _again(toml: str, tables: tuple[tuple[str, bytes], ...]) -> Config:
    return Config(toml, tables=dict(tables))


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        # Those of NumPy are floats, and call themselves otherwise.
        return float.__repr__(value)
    if hasattr(value, "__index__"):
        return repr(operator.index(value))
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_string(key)} = {_value(inner)}" for key, inner in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(inner) for inner in value) + "]"
    raise _partc.ConfigError(f"{value!r} has no place in a configuration")


def _string(text: str) -> str:
    if not isinstance(text, str):
        text = str(text)
    plain = (letter if letter >= " " and letter not in '"\\\x7f' else f"\\u{ord(letter):04x}" for letter in text)
    return '"' + "".join(plain) + '"'
