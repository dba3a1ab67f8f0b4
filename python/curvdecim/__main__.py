# SPDX-License-Identifier: GPL-3.0-or-later
"""The curvdecim command, also as python -m curvdecim.

It stands outside of the package, whose import alone needs PyMeshLab and the plugin: what is wrong
with them is one line, too.
"""

import sys


def main(arguments=None):
    """Ends the program with a message where the package cannot be used."""
    try:
        from pymeshlab_curvdecim import command_line
    except ImportError as error:
        sys.exit(f"curvdecim: {error}")
    command_line.main(arguments)


if __name__ == "__main__":
    main()
