# SPDX-License-Identifier: GPL-2.0-or-later
"""Choose the best setting of a program for peers.py: the cheapest in a short list whose results are
within 1e-3 of those with the program's finest setting."""

import statistics
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from peer_runs import Failure, Outcome

ALLOWED = 1e-3
RUNS = 3  # number of runs with an accurate setting; their median cost is used


class Setting(NamedTuple):
    """A time step or a tolerance for a program."""

    words: str
    call: Callable[..., Outcome]  # called with output=True or output=False


class Peer(NamedTuple):
    """A program whose results converge, with a list of settings and its finest setting, which
    serves as the reference."""

    name: str
    settings: Sequence[Setting]
    finest: Setting


class Tried(NamedTuple):
    """The outcome of trying one setting."""

    words: str
    error: float  # relative to the finest setting; inf if the run failed or cannot be compared
    cost: float  # wall seconds per simulated second, with output


class Choice(NamedTuple):
    """The chosen setting, and the outcomes of all settings that were tried."""

    setting: Setting
    tried: list[Tried]


def error(found: Outcome, truth: Outcome) -> float:
    """Return the largest difference between inner loads over all balls and samples, as a fraction
    of the largest load."""
    if found.loads is None or truth.loads is None or found.loads.shape != truth.loads.shape:
        return np.inf
    return float(np.abs(found.loads - truth.loads).max() / truth.loads.max())


def choose(peer: Peer) -> Choice:
    """Return the cheapest setting of a peer whose error is at most ALLOWED, or the finest setting
    if all errors are larger."""
    truth = peer.finest.call()
    tried = []
    for setting in peer.settings:
        try:
            found = setting.call()
        except Failure:
            tried.append(Tried(setting.words, np.inf, np.nan))
        else:
            miss = error(found, truth)
            costs = [found.cost]
            if miss <= ALLOWED:
                costs += [setting.call().cost for _ in range(RUNS - 1)]
            tried.append(Tried(setting.words, miss, statistics.median(costs)))
    good = [(one.cost, k) for k, one in enumerate(tried) if one.error <= ALLOWED]
    return Choice(peer.settings[min(good)[1]] if good else peer.finest, tried)
