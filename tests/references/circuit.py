# SPDX-License-Identifier: GPL-2.0-or-later
"""Reference solution for the circuit of a bearing. Balls and inner ring are nodes of dense systems,
from which no nodes are eliminated. Charges are integrated by a two-stage SDIRK method; failed films
are conductors with an unknown charge."""

import numpy as np

STAGE = 1 - np.sqrt(0.5)


def matrix(films, ring):
    """Return the (Z + 1, Z + 1) matrix for `films` (2, Z), where `ring` connects the last node to
    the frame."""
    inner, outer = films
    made = np.diag([*(inner + outer), inner.sum() + ring])
    made[:-1, -1] = made[-1, :-1] = -inner
    return made


def voltages(made, right, driving=None, broken=()):
    """Solve `made` v = `right`. The ring is at `driving` unless this is None, and the voltage
    across the films `broken` (side, ball) is zero. A node that is not connected has 0 V."""
    made, right, n = made.copy(), right.copy(), len(right)
    alone = np.flatnonzero(~made.any(axis=1))
    made[alone, alone], right[alone] = 1.0, 0.0
    if driving is not None:
        made[-1], right[-1] = np.eye(n)[-1], driving
    scale = np.abs(made).max(axis=1)
    made, right = made / scale[:, None], right / scale
    bordered = np.zeros((n + len(broken),) * 2)
    bordered[:n, :n] = made
    for row, (side, ball) in enumerate(broken, n):
        bordered[row, ball], bordered[ball, row] = 1.0, 1.0
        if side == 0:
            bordered[row, n - 1], bordered[n - 1, row] = -1.0, -scale[ball] / scale[n - 1]
    return np.linalg.lstsq(bordered, np.r_[right, np.zeros(len(broken))], rcond=1e-14)[0][:n]


def energy(capacitance, beside, coupling, driving, v):
    whole = matrix(capacitance, beside)
    return 0.5 * (v @ whole @ v + coupling * (v[-1] - driving) ** 2)


def discharge(capacitance, limit, outer, charge, v):
    """Return (charges, voltages, failures) at one point. A failure is a row of side, ball, film
    voltage, bearing voltage before and after, film energy, and total energy. `outer` is (parallel,
    coupling, driving)."""
    beside, coupling, driving = outer
    whole, push = matrix(capacitance, beside + coupling), np.zeros(len(v))
    push[-1] = coupling * driving
    broken, rows = [], []
    while True:
        film = np.stack([v[-1] - v[:-1], v[:-1]])
        load = np.abs(film) / limit
        for place in broken:
            load[place] = 0.0
        place = np.unravel_index(np.argmax(load), load.shape)
        if not load[place] > 1:
            break
        broken.append(place)
        after = voltages(whole, charge + push, broken=broken)
        given = coupling * driving * (v[-1] - after[-1])
        lost = energy(capacitance, *outer, v) - energy(capacitance, *outer, after) + given
        own = 0.5 * capacitance[place] * film[place] ** 2
        rows.append([*place, film[place], v[-1], after[-1], own, lost])
        v = after
    if broken:
        charge = whole @ v - push
    return charge, v, rows


def solve(time, capacitance, conductance, limit, outer, start):
    """Solve the circuit for films (n, 2, Z), where `outer` (n, 4) contains parallel, coupling,
    conductance and driving. Return the voltages (n, Z + 1), with the ring last; the charge (n,)
    that flows into the ring's films in each step; and the failures, each preceded by the index of
    its point."""
    stiff = np.isinf(outer[0, 2])
    n, _, z = capacitance.shape
    found, flown, failures = np.zeros((n, z + 1)), np.zeros(n), []

    def at(k, share):
        def mix(values):
            return values[k - 1] + share * (values[k] - values[k - 1]) if k else values[0]

        beside, coupling, source, driving = (mix(outer[:, i]) if i in (0, 3) else outer[0, i]
                                             for i in range(4))  # fmt: skip
        coupling, source = (0.0, 0.0) if stiff else (coupling, source)
        return mix(capacitance), mix(conductance), beside, coupling, source, driving

    def held(driving):
        return driving if stiff else None

    for k in range(n):
        c, _, beside, coupling, _, driving = at(k, 1.0)
        last, push = np.eye(z + 1)[-1], coupling * driving * np.eye(z + 1)[-1]
        whole = matrix(c, beside + coupling)
        if k == 0:
            series = np.divide(c[0] * c[1], c.sum(0), out=np.zeros(z), where=c.sum(0) > 0).sum()
            charge = last * start * (series + beside + coupling)
            v = voltages(whole, charge + push, held(driving))
        else:
            length, flows, first = time[k] - time[k - 1], [], found[k - 1]
            inside = capacitance[k - 1][0] @ (first[-1] - first[:-1])
            for share, weight in ((STAGE, 0.0), (1.0, 1 - STAGE)):
                cs, gs, bs, ks, source, drive = at(k, share)
                leaks, leak = matrix(gs, source), last * source * drive
                system = matrix(cs, bs + ks) + STAGE * length * leaks
                known = charge + last * ks * drive + STAGE * length * leak
                known = known + sum(weight * length * flow for flow, _ in flows)
                v = voltages(system, known, held(drive))
                flows.append((leak - leaks @ v, gs[0] @ (v[-1] - v[:-1])))
            moved = [(1 - STAGE) * length * a + STAGE * length * b for a, b in zip(*flows)]
            charge = charge + moved[0]
            flown[k] = c[0] @ (v[-1] - v[:-1]) - inside + moved[1]
        if stiff:
            charge = whole @ v - push
        charge, v, rows = discharge(c, limit[k], (beside, coupling, driving), charge, v)
        failures += [[k, *row] for row in rows]
        found[k] = v
    return found, flown, failures
