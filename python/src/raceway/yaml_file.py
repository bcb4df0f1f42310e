# SPDX-License-Identifier: GPL-2.0-or-later
"""Read YAML files written by users. Every value is text or None, so that 6208 is a name, and yes is
text rather than a boolean. It is an error if a file contains duplicate keys or references."""

import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml

from raceway.errors import InputError, RacewayError, unreadable
from raceway.files import FilePath

LARGEST = 1 << 18  # characters; parsing a file of this size already takes seconds
# A line of a flat file whose key is a plain scalar and whose value is another one, without any
# character that is special in YAML, or is in quotes. Runs and sweeps write such files, and PyYAML
# takes 7 ms for one of them.
WORDS = r"-?[A-Za-z0-9.+][\w.+/=,;()-]*(?: [\w.+/=,;()-]+)*"
PLAIN = re.compile(rf"([A-Za-z_]\w*): (?:({WORDS})|'([^'\x00-\x1f\x7f]*)')", re.ASCII)


class _Loader(yaml.BaseLoader):
    def compose_node(self, parent, index):
        if self.check_event(yaml.events.AliasEvent):
            raise yaml.composer.ComposerError(
                None, None, "references (*name) are not supported", self.peek_event().start_mark
            )
        return super().compose_node(parent, index)

    def construct_scalar(self, node):
        text = super().construct_scalar(node)
        return None if node.style is None and text in ("", "~", "null") else text

    def construct_mapping(self, node, deep=False):
        seen = set()
        for key, _ in node.value:
            if str(key.value) in seen:
                raise yaml.constructor.ConstructorError(
                    None, None, f"{key.value} is given twice", key.start_mark
                )
            seen.add(str(key.value))
        return super().construct_mapping(node, deep)


def parse(text: str) -> Any:
    """Parse `text` into lists, dicts and strings. Raises `ValueError` for invalid input."""
    if len(text) > LARGEST:
        raise ValueError(f"longer than {LARGEST} characters")
    if (flat := _flat(text)) is not None:
        return flat
    try:
        return yaml.load(text, Loader=_Loader)
    except yaml.YAMLError as error:
        raise ValueError(str(error)) from None
    except RecursionError:
        raise ValueError("nested too deeply") from None


def _flat(text):
    """Return the dict in a file of plain lines `key: value`, or None for any other file."""
    found = [PLAIN.fullmatch(line) for line in text.removesuffix("\n").split("\n")]
    if not all(found):
        return None
    values = {line[1]: line[3] if line[2] is None else line[2] for line in found}
    plain = len(values) == len(found) and "null" not in {*values, *(line[2] for line in found)}
    return values if plain else None


def dump(values: Mapping[str, str]) -> str:
    """Return the text of a file from which `parse` reads `values`."""
    text = "".join(f"{name}: '{value}'\n" for name, value in values.items())
    return text if _flat(text) == values else yaml.safe_dump(dict(values), sort_keys=False)


def read(path: FilePath, error: type[RacewayError] = InputError) -> Any:
    """Apply `parse` to the file at `path`. Raises `error` if the file cannot be read or parsed."""
    try:
        with open(Path(path), encoding="utf-8") as file:
            return parse(file.read(LARGEST + 1))
    except (OSError, ValueError) as problem:
        raise error(unreadable(path, problem)) from None


def number(value: Any) -> float:
    """Convert a text to a number; a number is returned as a float. Raises `ValueError` for any
    other value, including texts such as 1_000."""
    if isinstance(value, str) and "_" not in value or type(value) in (int, float):
        return float(value)
    raise ValueError("not a number")


def number_within(
    value: Any, what: str, low: float, high: float, error: type[Exception] = InputError
) -> float:
    """Convert a value as in `number`. Raises `error`, which names `what`, if it is not a number
    from `low` to `high`."""
    try:
        found = number(value)
    except ValueError:
        found = math.nan
    if low <= found <= high:
        return found
    kind = "a number without a unit, " if math.isnan(found) else ""
    raise error(f"{what} is {str(value)[:100]}, must be {kind}from {low:g} to {high:g}")
