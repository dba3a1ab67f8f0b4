# SPDX-License-Identifier: GPL-3.0-or-later
"""The other decimators, measured side by side with ours; bench/compare_peers.py is the command."""
