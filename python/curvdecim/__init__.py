# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the command curvdecim begins; the filters are in pymeshlab_curvdecim."""
