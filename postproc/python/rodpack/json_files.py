# SPDX-License-Identifier: GPL-2.0-or-later
"""JSON of runs and analyses: parameters.json, result.json, summary.json, ensemble.json."""

import json
import math

from .errors import FormatError, first_repeated, shortened
from .text import open_regular

# The "format" of a summary.json whose numbers mean what the page of this version says.
SUMMARY_FORMAT = "rodpack-analysis 3"


def read_json(file):
    """Reads a JSON object as a dict, keys in their order. FormatError, with the line where there is one: not
    JSON, cut short, no object, a key twice in an object, nan, a number that no double can hold."""
    def refuse(message):
        raise FormatError(file, None, message)

    def unique(pairs):
        result = dict(pairs)
        if len(result) != len(pairs):
            twice = first_repeated(name for name, _ in pairs)
            refuse(f"expected each key once in an object, found '{shortened(twice)}' twice")
        return result

    def finite(text):
        value = float(text)
        if not math.isfinite(value):
            refuse(f"expected finite numbers, found {shortened(text)}")
        return value

    def whole(text):
        finite(text)
        return int(text)

    with open_regular(file) as stream:
        content = stream.read()
    try:
        result = json.loads(content, object_pairs_hook=unique, parse_float=finite, parse_int=whole,
                            parse_constant=finite)
    except FormatError:
        raise
    except json.JSONDecodeError as error:
        raise FormatError(file, error.lineno,
                          f"expected a JSON object, found an error in it here: {error.msg}") from None
    except (ValueError, RecursionError) as error:  # not UTF-8, a number of thousands of digits, too deep
        refuse(f"expected a JSON object, found {shortened(str(error))}")
    if not isinstance(result, dict):
        refuse('expected a JSON object { "key": value, ... }')
    return result


def read_summary(file):
    """Reads analysis/summary.json as a dict; None for a number that could not be taken ("notes" say why).
    FormatError as read_json(), and for another "format" than SUMMARY_FORMAT, since names may mean others."""
    summary = read_json(file)
    if summary.get("format") != SUMMARY_FORMAT:
        raise FormatError(file, None, f"key 'format': expected '{SUMMARY_FORMAT}', found "
                                      f"'{shortened(str(summary.get('format')))}': analyse the run again")
    return summary
