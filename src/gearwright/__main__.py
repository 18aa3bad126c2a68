"""What the command `gearwright` and ``python -m gearwright`` begin with.

Until the commands are loaded, which takes a moment, Ctrl-C ends the process without a word.
"""

import signal


def main() -> None:
    """Load the commands and run the one that is asked for."""
    heard = signal.getsignal(signal.SIGINT)
    if heard is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    from gearwright.cli import main as run

    signal.signal(signal.SIGINT, heard)
    run()


if __name__ == "__main__":
    main()
