# SPDX-License-Identifier: GPL-2.0-or-later
"""Models of the contacts: their names in decks and options, the default model, and the figures that
each model omits."""

from collections.abc import Iterable

PAPER, DEFAULT = "paper", "full"
STATICS = ("paper", "full", "eyring")  # runs also have "film": film of full, friction of paper
CAPACITANCE = ("paper", "full")  # eyring has the films of full
# The publication's friction between balls and raceways keeps the balls rolling. Its torque has no
# rolling resistance, no slip within a contact patch and no drag: 29 uN m where the makers' formulas
# give 146 mN m (main deck).
WITHOUT_LOSSES = ("paper", "film")
LOSSES = ("friction_torque_N_m", "power_loss_W", "losses_W", "asperity_share")
HEADLINES = ("friction_torque_N_m",)  # if absent, a table shows the reason instead


def absent(models: str | None, keys: Iterable[str]) -> dict[str, str]:
    """{key: reason} for the figures among `keys` that `models` omits; empty if it omits none of
    them, and for a user's own models (None or another name).

    >>> absent("paper", ["friction_torque_N_m", "q_max_N"])
    {'friction_torque_N_m': 'not in models paper'}
    """
    if models not in WITHOUT_LOSSES:
        return {}
    return {key: f"not in models {models}" for key in keys if key in LOSSES}
