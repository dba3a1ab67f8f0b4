# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours that all pictures share."""

BACKGROUND, INK, FAINT_INK, FAINT = "#fbfaf7", "#22262b", "#6a7078", "#a9adb3"
EDGES = "#2b2420"
COLUMNS = ("#d8cfc0", "#e0a458", "#8fb3c9")  # of the meshes in a row
DENSE = 20_000  # faces from which edges are drawn fainter, so that the shape stays visible
