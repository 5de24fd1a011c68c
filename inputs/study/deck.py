# SPDX-License-Identifier: GPL-2.0-or-later
"""The parameters of the deposition deck, read from the deck itself.

The deck's `parameter` lines are the only text of names, types, choices, limits and units; its
`variable ... equal` lines the only text of what follows from them (width of the container, times).
"""

import math
import re
import shlex
from dataclasses import dataclass, field
from pathlib import Path

DECK = Path(__file__).resolve().parent.parent / "deposition" / "in.deposition"

BOUNDS = {  # keyword of the deck -> (what holds, in words)
    "minimum": (lambda x, bound: x >= bound, "at least"),
    "above": (lambda x, bound: x > bound, "above"),
    "maximum": (lambda x, bound: x <= bound, "at most"),
    "below": (lambda x, bound: x < bound, "below"),
}


class DeckError(Exception):
    """What the deck would refuse, in its words."""


@dataclass
class Parameter:
    name: str
    type: str  # real, integer, choice or text
    default: str  # as written: a number, or an expression of other variables
    choices: list = field(default_factory=list)
    bounds: list = field(default_factory=list)  # (keyword, number)
    unit: str = ""

    @property
    def key(self):
        """Its key in parameters.json."""
        return f"{self.name}_{self.unit}" if self.unit else self.name

    def expected(self):
        """What a value has to be, in words."""
        if self.type == "choice":
            return "one of: " + " ".join(self.choices)
        if self.type == "text":
            return "a text"
        words = "an integer" if self.type == "integer" else "a number"
        if self.unit:
            words += " in " + self.unit.replace("_", "/", 1)
        limits = [f"{BOUNDS[keyword][1]} {bound:g}" for keyword, bound in self.bounds]
        return words + (", " + " and ".join(limits) if limits else "")

    def value(self, text):
        """The value that `text` stands for. @throws ValueError when the deck would refuse it."""
        if self.type == "text":
            return text
        if self.type == "choice":
            if text not in self.choices:
                raise ValueError(text)
            return text
        # Python reads 1_000 and nan, too; the deck does not.
        if not re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", text):
            raise ValueError(text)
        number = int(text) if self.type == "integer" else float(text)
        if not all(BOUNDS[keyword][0](number, bound) for keyword, bound in self.bounds):
            raise ValueError(text)
        return number


def commands(text):
    """The commands of a deck as lists of words: comments gone, continued lines joined."""
    text = re.sub(r"[ \t]*&[ \t]*\n", " ", text)
    for line in text.splitlines():
        # A quoted comment sign does not occur in this deck.
        words = shlex.split(line, comments=True)
        if words:
            yield words


def parameter_of(words):
    name, kind = words[1:3]
    if kind == "choice":
        return Parameter(name, kind, words[3], choices=words[3:])
    parameter = Parameter(name, kind, words[3])
    for keyword, value in zip(words[4::2], words[5::2]):
        if keyword == "unit":
            parameter.unit = value
        elif keyword != "auto":  # the step under mass scaling, which LIGGGHTS alone works out
            parameter.bounds.append((keyword, float(value)))
    return parameter


class Deck:
    """What in.deposition declares and computes before it builds its world."""

    def __init__(self, file=DECK):
        self.file = Path(file)
        self.commands = list(self._commands(self.file))
        self.parameters = {
            words[1]: parameter_of(words)
            for words in self.commands
            if words[0] == "parameter" and len(words) > 3
        }

    def _commands(self, file):
        for words in commands(file.read_text()):
            if words[:2] == ["parameter", "include"]:
                yield from self._commands(self.file.parent / words[2])
            else:
                yield words

    def evaluate(self, given):
        """All that follows from the given parameters, {name: text}, the others at their default.

        Returns {name: number or text} of parameters and of the deck's `equal` variables that need
        nothing but parameters. @throws DeckError with the deck's message for what it refuses.
        """
        variables = {name: str(text) for name, text in given.items()}
        values = {}
        for words in self.commands:
            if words[0] == "parameter" and len(words) > 3:
                self._declare(words, variables, values)
            elif words[0] == "variable" and words[2] == "equal":
                number = _number(words[3], variables)
                if number is not None:
                    variables[words[1]], values[words[1]] = repr(number), number
            elif words[0] == "if" and _number(words[1], variables):
                _follow(words[3:], variables)
        return values

    def _declare(self, words, variables, values):
        parameter = self.parameters[words[1]]
        text = variables.get(parameter.name)
        if text is None:
            text = _substitute(parameter.default, variables)
        try:
            value = parameter.value(_integer_text(text) if parameter.type == "integer" else text)
        except ValueError:
            raise DeckError(
                f"parameter {parameter.name}: expected {parameter.expected()}, got {text}"
            ) from None
        variables[parameter.name], values[parameter.name] = text, value
        for choice in parameter.choices:
            variables[f"{parameter.name}_is_{choice}"] = "1" if choice == value else "0"
        if parameter.type == "text":
            variables[parameter.name + "_given"] = "0" if text == parameter.default else "1"


def _integer_text(text):
    return text[:-2] if text.endswith(".0") else text


def _substitute(text, variables):
    return re.sub(r"\$\{(\w+)\}", lambda match: variables.get(match[1], match[0]), text)


def _number(expression, variables):
    """Value of a LIGGGHTS formula; None when it needs what only a simulation knows."""
    text = _substitute(expression, variables).replace("^", "**")
    text = text.replace("&&", " and ").replace("||", " or ")
    names = set(re.findall(r"[A-Za-z_]\w*", re.sub(r"\d[\d.]*[eE][+-]?\d+", "0", text)))
    if "$" in text or not names <= {"ceil", "sqrt", "and", "or"}:
        return None
    number = eval(text, {"__builtins__": {}}, {"ceil": math.ceil, "sqrt": math.sqrt})
    return float(number)


def _follow(branch, variables):
    """The commands of an `if` that holds: presets, and what the deck refuses."""
    for command in branch:
        if command == "else":
            return
        words = shlex.split(command)
        if words[0] == "variable" and words[2] == "index":
            variables.setdefault(words[1], words[3])
        elif words[0] == "print" and words[1].startswith("ERROR: "):
            raise DeckError(_substitute(words[1][len("ERROR: "):], variables))
