"""The command line: ``python -m partc compile part.H``."""

from __future__ import annotations

import signal
import sys

from . import _partc


def main() -> int:
    # The compiler does not come back to the interpreter before it is done.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    if hasattr(signal, "SIGPIPE"):
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    return _partc.command_line(["partc", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
