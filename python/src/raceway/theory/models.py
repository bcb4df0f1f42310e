# SPDX-License-Identifier: GPL-2.0-or-later
"""Models of the contacts: their names in decks and options, the default model, and the results that
each model does not include."""

from collections.abc import Iterable

PAPER, DEFAULT = "paper", "full"
STATICS = ("paper", "full", "eyring")  # runs also have "film": films of full, friction of paper
CAPACITANCE = ("paper", "full")  # the films of eyring are those of full
# In the publication, the friction between balls and raceways only keeps the balls rolling. The
# torque includes neither rolling resistance nor slip within a contact patch nor drag: it is 29 uN m
# where the makers' formulas give 146 mN m (main deck).
WITHOUT_LOSSES = ("paper", "film")
LOSSES = ("friction_torque_N_m", "power_loss_W", "losses_W", "asperity_share")
HEADLINES = ("friction_torque_N_m",)  # if one of these is absent, a table shows the reason instead


def absent(models: str | None, keys: Iterable[str]) -> dict[str, str]:
    """Return {key: reason} for those of `keys` that the `models` do not compute. The dict is empty
    if they compute all of them, and for models defined by a user (None or another name).

    >>> absent("paper", ["friction_torque_N_m", "q_max_N"])
    {'friction_torque_N_m': 'not in models paper'}
    """
    if models not in WITHOUT_LOSSES:
        return {}
    return {key: f"not in models {models}" for key in keys if key in LOSSES}
