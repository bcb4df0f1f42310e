# SPDX-License-Identifier: GPL-2.0-or-later
"""Compare the cost of a record with that of the host's text dumps and with that of runs without
output. The comparison covers samples within long steps, complete runs of the program, and a hundred
bearings. Write build/bench/record.rst.

    .venv/bin/python tests/bench/record.py [ROUNDS] [--print]     --print: do not write the page

The runs of a round are made one after another, so that a drift in the speed of the machine affects
all of them. Ratios are formed within each round, and their medians are used. The exit code is 1 if
a ratio exceeds its limit.
"""

import re
import statistics
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

from deck_runs import MAIN, ROOT, cost, factor, run_deck
from machine import count_asked, csv_table, publish

# {rpm: required real-time factor of the main deck}
SPEEDS = {47.75: 200.0, 477.5: 20.0, 9549.0: 0.6}
HEADS = [f"{rpm:g} rpm" for rpm in SPEEDS]
# output settings of the main deck, with one sample or ten samples per host step
TEXT = {"record": "none", "dumps": "yes", "within": 1}
RECORD, NOTHING = ({"record": record, "dumps": "no", "within": 1} for record in ("all", "none"))
OUTPUTS = {
    "text": TEXT,
    "record": RECORD,
    "no output": NOTHING,
    "record, 10 samples per step": {**RECORD, "within": 10},
    "no output, a tenth of the steps": {**NOTHING, "within": 10},
}
PASSES, TEXT_PASSES = 400, 40
AS_IT_STANDS = "record, 10 samples per step"  # this is the default of the main deck
SHORT, SHORT_PASSES = "make run", 4  # key for `make run`, i.e. the main deck without any -var
FASTER, FASTER_WITHIN, COST = 8.0, {47.75: 15.0, 477.5: 15.0, 9549.0: 12.0}, 2.0
MANY, MANY_COST = 100, 1.3
PAGE = """\
The main deck was run at 5000 N with 200 samples per ball pass, for {text_passes} passes with text
output and for {passes} passes otherwise. *text* refers to dumps of the host for contacts and balls,
and its table for the ring. *record* is :doc:`../fix_bearing_record` with all columns. The motion is
bitwise identical in the first three rows. The values are medians over {rounds} rounds.

The times in the next two tables include writing the last sample to the operating system.

Microseconds per sample, with the real-time factor in brackets:

{rows}

{ratios}

The main deck with its defaults is timed both from the start of the measured passes and from the
start of the program. The latter time includes starting the program, settling and closing the files.
``make run`` is the row with {short} passes at 477.5 rpm. Without summary and picture, it takes
{short_wall:.2f} s from the start to the end of the program, including {short_loop:.0f} ms for the
measured passes. {passes} passes at 477.5 rpm take {long_wall:.2f} s from start to end.

Real-time factor of the measured passes:

{whole}

With a hundred bearings in one box on one rank (:doc:`many`), a run with a record takes {many:.2f}
times as long as a run without one. The limit is {many_cost}.

{machine}
"""


class Taken(NamedTuple):
    """The times of one run of the main deck."""

    sample: float  # s per sample in the measured passes
    factor: float  # real-time factor of the measured passes
    loop: float  # s, duration of the measured passes
    wall: float  # s, from the start to the end of the program
    whole: float  # real-time factor based on `wall`


def main_deck(folder, rpm, output):
    """Run the main deck and return its `Taken`."""
    passes = {"text": TEXT_PASSES, SHORT: SHORT_PASSES}.get(output, PASSES)
    start = time.perf_counter()
    variables = OUTPUTS.get(output, {})
    run_deck(MAIN, out=folder, rpm=rpm, passes=passes, overwrite="yes", **variables)
    wall = time.perf_counter() - start
    found = cost(folder)
    return Taken(
        found["wall_s"] / (200 * passes),
        factor(folder),
        found["wall_s"],
        wall,
        found["simulated_s"] / wall,
    )


def many(folder, record):
    """Return the loop time (s) of a run with a hundred bearings, with or without a record."""
    text = (ROOT / "inputs" / "in.many").read_text()
    text, count = re.subn(r"(?m)^dump(_modify)? table (.*&\n)*.*\n", "", text)
    assert count == 2, "in.many writes one table"
    deck = folder / "in.many"
    deck.write_text(text)
    words = dict(models="paper", record="all" if record else "none", overwrite="yes")
    printed = run_deck(deck, out=folder / "run", bearings=MANY, columns=10, **words)
    return float(re.findall(r"Loop time of (\S+)", printed)[-1])


def measure(rounds):
    """Return a list with a dict {(rpm, output): `Taken`, "many": ratio} for each round."""
    results = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for k in range(rounds):
            one = {}
            for rpm in SPEEDS:
                for output in (*OUTPUTS, SHORT):
                    one[rpm, output] = main_deck(folder / "run", rpm, output)
            one["many"] = many(folder, True) / many(folder, False)
            results.append(one)
            print(f"round {k + 1} of {rounds}", flush=True)
    return results


def middle(results, rpm, output, what):
    """Return the median over the rounds of a field of `Taken`."""
    return statistics.median(getattr(one[rpm, output], what) for one in results)


def from_start(results):
    """Return the rows of the table in which the times include the start of the program."""
    rows = []
    for output, passes in ((AS_IT_STANDS, PASSES), (SHORT, SHORT_PASSES)):
        for what, said in (("factor", "measured passes"), ("whole", "start to end of the program")):
            found = [f"{middle(results, rpm, output, what):.3g}" for rpm in SPEEDS]
            rows.append((f"{passes} passes, {said}", *found))
    return rows


def ratios(results):
    """Return a list of (name, {rpm: ratio}, {rpm: limit}, whether it is a lower limit)."""

    def ratio(slow, fast):
        return {
            rpm: statistics.median(one[rpm, slow].sample / one[rpm, fast].sample for one in results)
            for rpm in SPEEDS
        }

    factor = {rpm: middle(results, rpm, AS_IT_STANDS, "factor") for rpm in SPEEDS}
    faster, most = dict.fromkeys(SPEEDS, FASTER), dict.fromkeys(SPEEDS, COST)
    within = ratio(AS_IT_STANDS, "no output, a tenth of the steps")
    text, ten = "text relative to record", ", 10 samples per step"
    return [
        (text, ratio("text", "record"), faster, True),
        (text + ten, ratio("text", AS_IT_STANDS), FASTER_WITHIN, True),
        ("record relative to no output", ratio("record", "no output"), most, False),
        ("record relative to no output" + ten, within, most, False),
        (f"real-time factor of the main deck, {PASSES} passes", factor, SPEEDS, True),
    ]


def main():
    """Measure, print the results and write the page."""
    results = measure(count_asked(5))
    rows = []
    for output in OUTPUTS:
        cells = [output]
        for rpm in SPEEDS:
            micro = 1e6 * middle(results, rpm, output, "sample")
            cells.append(f"{micro:.1f} ({middle(results, rpm, output, 'factor'):.3g})")
        rows.append(cells)
    missed, table = [], []
    for name, found, limit, least in ratios(results):
        limits = sorted({*limit.values()}, reverse=True)
        said = ", ".join(f"{value:g}" for value in limits)
        cells = (f"{found[rpm]:.3g}" for rpm in SPEEDS)
        table.append((name, *cells, f"{'>=' if least else '<='} {said}"))
        missed += [
            f"{name} at {rpm:g} rpm: {found[rpm]:.3g}, required {limit[rpm]:g}"
            for rpm in SPEEDS
            if (found[rpm] < limit[rpm] if least else found[rpm] > limit[rpm])
        ]
    hundred = statistics.median(one["many"] for one in results)
    if hundred > MANY_COST:
        missed.append(f"a hundred bearings: {hundred:.2f}, required {MANY_COST:g}")
    publish(
        "Cost of a record",
        PAGE,
        text_passes=TEXT_PASSES,
        passes=PASSES,
        rounds=len(results),
        rows=csv_table(("output", *HEADS), rows),
        whole=csv_table(("main deck", *HEADS), from_start(results)),
        short=SHORT_PASSES,
        short_wall=middle(results, 477.5, SHORT, "wall"),
        short_loop=1e3 * middle(results, 477.5, SHORT, "loop"),
        long_wall=middle(results, 477.5, AS_IT_STANDS, "wall"),
        ratios=csv_table(("ratio", *HEADS, "required"), table),
        many=hundred,
        many_cost=MANY_COST,
    )
    for line in missed:
        print("missed:", line)
    return int(bool(missed))


if __name__ == "__main__":
    sys.exit(main())
