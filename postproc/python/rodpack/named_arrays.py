# SPDX-License-Identifier: GPL-2.0-or-later
"""What frames, tables and fields have in common: arrays that are found by their names."""

from collections.abc import Mapping


class NamedArrays(Mapping):
    """A mapping whose keys are `names`, in their order; a name that is not there is no error to ask for.

    Mapping itself would look a name up to see whether it is there, and expect a KeyError.
    """

    names = ()

    def __contains__(self, name):
        return name in self.names

    def __iter__(self):
        return iter(self.names)

    def __len__(self):
        return len(self.names)
