# SPDX-License-Identifier: GPL-2.0-or-later
"""Rewrite a deck in equivalent forms, whose results must be bitwise identical."""

import re


def formula(lines, draw):
    """Replace the value of a load, a speed or a position by an equal-style variable."""
    found, out = 0, []
    for line in lines:
        if line.startswith("fix ring_"):

            def variable(match):
                nonlocal found
                found += 1
                out.append(f"variable f{found} equal {match.group(2)}")
                return f"{match.group(1)}v_f{found}"

            line = re.sub(r"((?:speed|position|force) )(-?\d\S*)", variable, line)
        out.append(line)
    return out


def own_keywords(lines, draw):
    """Repeat the keywords of pair_style in the pair_coeff command of each raceway."""
    style = next(line for line in lines if line.startswith("pair_style"))
    law = style.split("overlap_limit")[1].split(None, 1)[1:]
    if not law or " gap" in style or "branch" in style:  # these keywords apply to all raceways
        return None
    return [f"{line} {law[0]}" if re.match("pair_coeff 1 [34]", line) else line for line in lines]


def upto(lines, draw):
    return [re.sub(r"^run (\d+)$", r"run \1 upto", line) for line in lines]


def every(lines, draw):
    return [re.sub(r"^run (\d+)$", r'run \1 every 3 "print here"', line) for line in lines]


def order(lines, draw):
    """Write the fixes for flaws, rings and motion in a different order."""
    at = [k for k, line in enumerate(lines) if re.match("fix (flaw|ring_|move)", line)]
    moved = draw.sample(at, len(at))
    return [lines[moved[at.index(k)]] if k in at else line for k, line in enumerate(lines)]


def twice(lines, draw):
    """Define rings and flaws, delete them, and define them again."""
    out = []
    for line in lines:
        out.append(line)
        if re.match("fix (ring_|flaw|cap|move)", line):
            out += [f"unfix {line.split()[1]}", line]
    return out


def skin(lines, draw):
    """Change the neighbour skin and the neighbour search method."""
    return [
        re.sub(r"^neighbor (\S+) bin", lambda m: f"neighbor {2 * float(m.group(1)):g} nsq", line)
        for line in lines
    ]


def box(lines, draw):
    """Enlarge the box."""
    return [
        "region box block "
        + " ".join(
            f"{float(v) + (0.01 if k % 2 else -0.02):.17g}" for k, v in enumerate(line.split()[3:9])
        )
        + " units box"
        if line.startswith("region box")
        else line
        for line in lines
    ]


REWRITES = {f.__name__: f for f in (formula, own_keywords, upto, every, order, twice, skin, box)}
