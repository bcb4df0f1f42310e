# SPDX-License-Identifier: GPL-2.0-or-later
"""Models of the contacts: their names in decks and options, the default model, and the results that
each model does not provide."""

from collections.abc import Iterable

PAPER, DEFAULT = "paper", "full"
# runs also offer "film", i.e. films of full with friction of paper
STATICS = ("paper", "full", "eyring")
CAPACITANCE = ("paper", "full")  # eyring has the same films as full
# In the paper, the only role of friction between balls and raceways is to keep the balls
# rolling. The torque includes neither rolling resistance nor slip within a contact patch nor drag.
# In the main deck it is 29 uN m, whereas the makers' formulas give 146 mN m.
WITHOUT_LOSSES = ("paper", "film")
LOSSES = ("friction_torque_N_m", "power_loss_W", "losses_W", "asperity_share")
# if one of these is absent, a table shows the reason instead
HEADLINES = ("friction_torque_N_m", "load_parameter")


def absent(models: str | None, keys: Iterable[str]) -> dict[str, str]:
    """Return {key: reason} for those of the `keys` that the `models` do not compute. The dict is
    empty if they compute all keys, and also for user-defined models (None or another name).

    >>> absent("paper", ["friction_torque_N_m", "q_max_N"])
    {'friction_torque_N_m': 'not in models paper'}
    """
    if models not in WITHOUT_LOSSES:
        return {}
    return {key: f"not in models {models}" for key in keys if key in LOSSES}
