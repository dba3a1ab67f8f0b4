# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours that all pictures share."""

BACKGROUND, INK, FAINT_INK, FAINT = "#fbfaf7", "#22262b", "#6a7078", "#a9adb3"
