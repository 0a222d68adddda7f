"""The command `eliminant`: `python -m eliminant --help`."""

import signal
import sys

from ._eliminant import run_command


def main() -> int:
    """Runs the command with the arguments of this process. Returns its exit status."""
    status, output, errors = run_command(["eliminant", *sys.argv[1:]])
    sys.stdout.write(output)
    sys.stderr.write(errors)
    return status


if __name__ == "__main__":
    # The interpreter would wait for the end of the command. A search sets a handler of its own.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(main())
