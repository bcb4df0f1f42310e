# SPDX-License-Identifier: GPL-2.0-or-later
"""With velocity Verlet, speeds relative to an outer ring that moves are those at the end of the
step on every rank, whichever rank owns the ring."""

import pytest
from host import deck_file, named_bearing, same_files, succeed

DECK = (
    named_bearing(every=1)
    + """create_bearing b centre 0.002 0.001 0 speed 300 0
fix outer outer bearing/ring mass 1.5 x free y free support x 1e8 2000 support y 2e8 3000
fix inner inner bearing/ring mass 0.3 x free y free spin speed 300 force 800 -1800 0
fix cage cage bearing/cage b
fix move moving nve/sphere
compute ball balls bearing/ball orbit
compute total all bearing/total
dump balls balls custom 100 ${out}/balls.dump id c_ball
dump_modify balls ${dump_format} "%d %.17g" sort id
variable cage equal c_total[8]
variable now equal step
fix total all print 100 "${now} ${cage}" file ${out}/total.txt screen no
fix record all bearing/record 100 ${out} overwrite yes
timestep 1.0e-7
run 1000
"""
)


@pytest.mark.parametrize("ranks", [2, 4])
def test_bits(tmp_path, ranks):
    for count in (1, ranks):
        folder = tmp_path / str(count)
        folder.mkdir()
        succeed(deck_file(folder, DECK), ranks=count, out=folder)
    names = ("record.nc", "balls.dump", "total.txt")
    same_files(tmp_path / "1", tmp_path / str(ranks), *names)
