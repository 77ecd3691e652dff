"""The blocks of docs/python.md run, and print what stands under them. PARTC_UPDATE_DOCS=1 writes what they print."""

from __future__ import annotations

import contextlib
import io
import os
import re

import pytest
from conftest import ROOT

BLOCK = re.compile(r"```python\n(.*?)```\n(?:\n```text\n(.*?)```\n)?", re.DOTALL)


def test_the_guide_is_true(monkeypatch: pytest.MonkeyPatch) -> None:
    polars = pytest.importorskip("polars")
    polars.Config.set_tbl_formatting("ASCII_MARKDOWN").set_tbl_hide_dataframe_shape(True).set_tbl_hide_column_data_types(True)
    polars.Config.set_tbl_width_chars(200).set_fmt_str_lengths(120).set_tbl_cols(20)
    monkeypatch.chdir(ROOT)
    path = ROOT / "docs/python.md"
    text = path.read_text(encoding="utf-8")
    names: dict[str, object] = {}

    def printed(found: "re.Match[str]") -> str:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(found[1], str(path), "exec"), names)
        if found[2] is None:
            assert not out.getvalue()
            return found[0]
        return f"```python\n{found[1]}```\n\n```text\n{out.getvalue()}```\n"

    made = BLOCK.sub(printed, text)
    if os.environ.get("PARTC_UPDATE_DOCS"):
        path.write_text(made, encoding="utf-8", newline="\n")
    else:
        assert made == text
