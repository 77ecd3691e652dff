"""A call as a job of the native half."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Optional, Union

from . import _partc
from ._config import Config, bytes_of, text_of

Program = Union[bytes, bytearray, memoryview, str, "os.PathLike[str]"]
Files = Mapping[str, Union[bytes, str]]
ConfigLike = Union[Config, Mapping[str, Any], str, "os.PathLike[str]"]


def configured(config: Optional[ConfigLike]) -> Optional[Config]:
    """A ``str`` is a path, as it is for a program."""
    if config is None or isinstance(config, Config):
        return config
    if isinstance(config, Mapping):
        return Config.from_dict(config)
    if isinstance(config, (str, os.PathLike)):
        return Config.from_file(config)
    raise TypeError("a configuration is a Config, a dictionary, or the path of a partc.toml")


def settings(config: Optional[ConfigLike]) -> Optional[_partc.Settings]:
    made = configured(config)
    return None if made is None else made._settings


def job(
    program: Program,
    *,
    files: Optional[Files] = None,
    config: Optional[ConfigLike] = None,
    dialect: Optional[str] = None,
    target: Optional[str] = None,
    name: Optional[str] = None,
) -> _partc.Job:
    if files is not None and not isinstance(files, Mapping):
        raise TypeError(f"files is a {type(files).__name__}, and no dictionary of names and bytes")
    called = None if files is None else [(text_of("the name", called), bytes_of(called, text)) for called, text in files.items()]
    language = None if dialect is None or dialect == "auto" else text_of("the dialect", dialect)
    if name is not None:
        text_of("the name", name)
    if target is not None:
        text_of("the target", target)
    if isinstance(program, (bytes, bytearray, memoryview)):
        return _partc.Job(None, name or "program", bytes(program), called, settings(config), language, target)
    if not isinstance(program, (str, os.PathLike)):
        raise TypeError("a program is bytes, or a path as str or PathLike")
    path = os.fspath(program)
    if not isinstance(path, str):
        path = os.fsdecode(path)
    if os.path.isdir(path):
        raise IsADirectoryError(f"{path} is a folder")
    if called is None:
        os.stat(path)
        # The name of a file need not be text.
        return _partc.Job(path, "", None, None, settings(config), language, target)
    with open(path, "rb") as file:
        text = file.read()
    shown = name or os.fsencode(os.path.basename(path)).decode(errors="replace")
    return _partc.Job(None, shown, text, called, settings(config), language, target)
