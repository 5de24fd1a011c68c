# SPDX-License-Identifier: GPL-2.0-or-later
"""Reads the table of a study and refuses, with file and line, what it cannot mean."""

import difflib
import itertools
import re
from dataclasses import dataclass

import yaml

from deck import DeckError
from naming import case_name

SET_BY_THE_WORKFLOW = ("out", "resume", "preset", "seed")
RESTARTS = ("end", "all", "none")
# Where the table says nothing: longer than a run, so that its final frame alone is dumped.
STUDY_DEFAULTS = {"output_interval": "100"}
# Columns that are no parameters of the deck.
OWN_COLUMNS = ("repetitions", "seeds", "ranks", "keep_restarts")
CASE_KEYS = OWN_COLUMNS + ("run", "each")
TABLE_KEYS = ("title", "defaults", "cases") + OWN_COLUMNS


class TableError(Exception):
    """One line for the user: file, line, key, value, expectation."""


@dataclass
class Case:
    name: str
    line: int
    parameters: dict  # deck parameter -> text, the defaults of the table included
    values: dict  # all that follows from them: Deck.evaluate()
    seeds: list
    ranks: int
    keep_restarts: str


@dataclass
class Table:
    file: str
    title: str
    cases: list
    columns: list  # deck parameters that the table names


class Reader:
    """The YAML tree with its line numbers; texts stay as they were written."""

    def __init__(self, file, deck):
        self.file, self.deck = file, deck

    def fail(self, node, message):
        raise TableError(f"{self.file}:{node.start_mark.line + 1}: {message}")

    def mapping(self, node, what, known=None):
        """{key: (node of the key, node of the value)}; refuses keys that come twice or are unknown."""
        if not isinstance(node, yaml.MappingNode):
            self.fail(node, f"{what}: expected 'name: value' pairs, got {text_of(node)}")
        pairs = {}
        for key, value in node.value:
            name = key.value if isinstance(key, yaml.ScalarNode) else text_of(key)
            if name in pairs:
                first = pairs[name][0].start_mark.line + 1
                self.fail(key, f"{what}: '{name}' is there twice, first in line {first}")
            if known is not None and name not in known:
                self.unknown(key, what, name, known)
            pairs[name] = (key, value)
        return pairs

    def unknown(self, key, what, name, known):
        if name in SET_BY_THE_WORKFLOW:
            instead = {
                "seed": "give seeds: [...] or repetitions:",
                "out": "give OUT=... to run.sh",
                "preset": "name the parameters themselves",
            }
            hint = instead.get(name, "runs that were interrupted go on by themselves")
            self.fail(key, f"{what}: '{name}' is set by the workflow: {hint}")
        near = difflib.get_close_matches(name, known, n=1)
        elsewhere = difflib.get_close_matches(name, self.deck.parameters, n=1)
        others = [word for word in known if word not in self.deck.parameters]
        hint = "expected " + (f"one of: {' '.join(others)}" if others else "a parameter of the deck")
        if near:
            hint = f"did you mean '{near[0]}'?"
        elif elsewhere:
            hint = f"did you mean '{elsewhere[0]}', under defaults: or a case?"
        elif others and len(others) < len(known):
            hint += " or a parameter of the deck"
        self.fail(key, f"{what}: unknown key '{name}', {hint}")

    def parameter(self, name, node):
        """The text of a deck parameter's value."""
        parameter = self.deck.parameters[name]
        try:
            if not isinstance(node, yaml.ScalarNode):
                raise ValueError
            parameter.value(node.value)
        except ValueError:
            self.fail(node, f"{name}: expected {parameter.expected()}, got {text_of(node)}")
        return node.value

    def text(self, name, node):
        if not isinstance(node, yaml.ScalarNode):
            self.fail(node, f"{name}: expected a text, got {text_of(node)}")
        return node.value

    def integer(self, name, node):
        if not isinstance(node, yaml.ScalarNode) or not re.fullmatch(r"[1-9]\d*", node.value):
            self.fail(node, f"{name}: expected an integer, 1 or more, got {text_of(node)}")
        return int(node.value)

    def sequence(self, name, node):
        if not isinstance(node, yaml.SequenceNode) or not node.value:
            self.fail(node, f"{name}: expected a list such as [1, 2, 3], got {text_of(node)}")
        return node.value

    def own_columns(self, pairs, inherited):
        """Seeds, ranks and restart files to keep, those that `pairs` lacks as inherited."""
        seeds, ranks, keep = inherited
        if "repetitions" in pairs and "seeds" in pairs:
            self.fail(pairs["repetitions"][0], "repetitions and seeds: expected one of the two")
        if "repetitions" in pairs:
            seeds = list(range(1, self.integer("repetitions", pairs["repetitions"][1]) + 1))
        if "seeds" in pairs:
            seeds = []
            for item in self.sequence("seeds", pairs["seeds"][1]):
                seed = self.integer("seeds", item)
                if seed in seeds:
                    self.fail(item, f"seeds: {seed} is there twice, expected every seed once")
                seeds.append(seed)
        if "ranks" in pairs:
            ranks = self.integer("ranks", pairs["ranks"][1])
        if "keep_restarts" in pairs:
            node = pairs["keep_restarts"][1]
            keep = self.text("keep_restarts", node)
            if keep not in RESTARTS:
                self.fail(node, f"keep_restarts: expected one of: {' '.join(RESTARTS)}, got '{keep}'")
        return seeds, ranks, keep


def text_of(node):
    """A node as the user would recognise it, on one line."""
    return f"'{_flow(node)}'"


def _flow(node):
    if isinstance(node, yaml.SequenceNode):
        return "[" + ", ".join(_flow(item) for item in node.value) + "]"
    if isinstance(node, yaml.MappingNode):
        return "{" + ", ".join(f"{_flow(key)}: {_flow(value)}" for key, value in node.value) + "}"
    return node.value


def read_table(file, deck):
    """The study that `file` describes. @throws TableError"""
    try:
        with open(file, encoding="utf-8") as stream:
            root = yaml.compose(stream, Loader=yaml.SafeLoader)
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "no UTF-8 text"
        raise TableError(f"{file}: {reason}, expected the table of a study") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f":{mark.line + 1}" if mark else ""
        reason = getattr(error, "problem", None) or "not YAML"
        raise TableError(f"{file}{where}: {reason}, expected YAML") from None
    if root is None:
        raise TableError(f"{file}: empty, expected the table of a study")
    return _read_root(Reader(file, deck), root)


def _read_root(reader, root):
    columns = [name for name in reader.deck.parameters if name not in SET_BY_THE_WORKFLOW]
    pairs = reader.mapping(root, "table", TABLE_KEYS)
    if "cases" not in pairs:
        reader.fail(root, "table: no 'cases:', expected the table of cases")
    defaults = dict(STUDY_DEFAULTS)
    if "defaults" in pairs:
        for name, (_, node) in reader.mapping(pairs["defaults"][1], "defaults", columns).items():
            defaults[name] = reader.parameter(name, node)
    inherited = reader.own_columns(pairs, ([1], 1, "end"))
    cases = []
    for key, (key_node, node) in reader.mapping(pairs["cases"][1], "cases").items():
        cases += _read_cases(reader, key, key_node, node, defaults, inherited, columns)
    _check_names(reader.file, cases)
    if not cases:
        reader.fail(root, "cases: none to run, expected one or more")
    title = reader.text("title", pairs["title"][1]) if "title" in pairs else "study"
    named = {name for case in cases for name in case.parameters}
    return Table(reader.file, title, cases, [name for name in columns if name in named])


def _read_cases(reader, key, key_node, node, defaults, inherited, columns):
    """The cases of one entry: itself, or all combinations of its lists."""
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", key):
        reader.fail(key_node, f"cases: name '{key}', expected letters, digits, and . _ -")
    pairs = reader.mapping(node, key, columns + list(CASE_KEYS))
    own = reader.own_columns(pairs, inherited)
    fixed, lists = {}, []
    for name, (_, value) in pairs.items():
        if name in OWN_COLUMNS or name == "run":
            continue
        if name == "each":
            lists.append([_read_each(reader, key, item, columns) for item in reader.sequence(name, value)])
        elif isinstance(value, yaml.SequenceNode):
            items = reader.sequence(name, value)
            lists.append([{name: reader.parameter(name, item)} for item in items])
        else:
            fixed[name] = reader.parameter(name, value)
    wanted = reader.text("run", pairs["run"][1]) if "run" in pairs else "yes"
    if wanted not in ("yes", "no"):
        reader.fail(pairs["run"][1], f"run: expected yes or no, got '{wanted}'")
    if wanted == "no":
        return []
    cases = []
    for combination in itertools.product(*lists):
        parameters = {**defaults, **fixed}
        for part in combination:
            parameters.update(part)
        try:
            values = reader.deck.evaluate(parameters)
            name = case_name(parameters, values, reader.deck.evaluate(defaults)) if lists else key
        except (DeckError, ValueError, ZeroDivisionError, OverflowError) as error:
            reader.fail(key_node, f"{key}: {error}")
        cases.append(Case(name, key_node.start_mark.line + 1, parameters, values, *own))
    return cases


def _read_each(reader, key, item, columns):
    pairs = reader.mapping(item, f"{key}: each", columns)
    return {name: reader.parameter(name, node) for name, (_, node) in pairs.items()}


def _check_names(file, cases):
    lines = {}
    for case in cases:
        if case.name in lines:
            raise TableError(
                f"{file}:{case.line}: two cases of one name, '{case.name}': expected another one"
                f" than that of line {lines[case.name]}, or what sets them apart as a column"
            )
        lines[case.name] = case.line
