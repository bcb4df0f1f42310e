# SPDX-License-Identifier: GPL-2.0-or-later
"""Read YAML files written by users. Every value is text or None, so that 6208 is a name, and yes is
text rather than a boolean. It is an error if a file contains duplicate keys or references."""

from pathlib import Path
from typing import Any

import yaml

from raceway.errors import InputError, RacewayError
from raceway.files import FilePath

LARGEST = 1 << 18  # characters; parsing a file of this size already takes seconds


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
    try:
        return yaml.load(text, Loader=_Loader)
    except yaml.YAMLError as error:
        raise ValueError(str(error)) from None
    except RecursionError:
        raise ValueError("nested too deeply") from None


def read(path: FilePath, error: type[RacewayError] = InputError) -> Any:
    """Apply `parse` to the file at `path`. Raises `error` if the file cannot be read or parsed."""
    try:
        with open(Path(path), encoding="utf-8") as file:
            return parse(file.read(LARGEST + 1))
    except (OSError, ValueError) as problem:
        why = getattr(problem, "strerror", None) or problem
        raise error(f"cannot read {path}: {why}") from None


def number(value: Any) -> float:
    """Convert a text to a number; a number is returned as a float. Raises `ValueError` for any
    other value, including texts such as 1_000."""
    if isinstance(value, str) and "_" not in value or type(value) in (int, float):
        return float(value)
    raise ValueError("not a number")
