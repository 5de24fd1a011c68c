# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbers in words, for lines that a person reads."""

import time


def duration(seconds):
    if seconds < 60:
        return f"{seconds:.0f} s"
    if seconds < 6000:
        return f"{seconds / 60:.0f} min"
    return f"{seconds / 3600:.0f} h" if seconds < 72 * 3600 else f"{seconds / 86400:.0f} days"


def clock(moment):
    """A time of today by the clock, a later one by its day."""
    near = moment - time.time() < 20 * 3600
    return time.strftime("%H:%M" if near else "%A %d %B, %H:%M", time.localtime(moment))


def size(number):
    """A number of bytes."""
    for unit in ("B", "kB", "MB", "GB"):
        if number < 1000:
            return f"{number:.3g} {unit}"
        number /= 1000
    return f"{number:.3g} TB"
