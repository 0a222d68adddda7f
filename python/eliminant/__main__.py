"""The command `eliminant`: `python -m eliminant --help`."""

import sys

from ._eliminant import run_command


def main() -> int:
    """Runs the command with the arguments of this process. Returns its exit status."""
    status, output, errors = run_command(["eliminant", *sys.argv[1:]])
    sys.stdout.write(output)
    sys.stderr.write(errors)
    return status


if __name__ == "__main__":
    sys.exit(main())
