# SPDX-License-Identifier: GPL-2.0-or-later
"""Every bearing or ring quantity is the sum or the extreme value over its contacts. The power
supplied by shaft and loads equals the losses plus the rate of energy storage. Both statements hold
for all models, bearing types, integrators and hosts."""

import numpy as np
import pytest
import xarray as xr
from host import BOX, frames, run
from raceway import core
from scipy.interpolate import CubicSpline

TABLES = core.table("columns")
CONTACTS = [row["name"] for row in TABLES["contact"]]
PLATES = {"capacitance", "capacitance_total"}  # film columns, which do not exist for a dry bearing
LOSSES = [name for name in CONTACTS if name.endswith("_power")]

OIL = "lubricant 0.04 22e-9 roughness 1.0e-7 0 "
FRICTION = (
    "friction mixed 0.12 0.05 {slip} rolling 0.047 0.134 1.0 rolling_hysteresis 0.01 drag 870 0.1"
)
ROLLING = FRICTION.format(slip="heathcote 1.0e-4") + " spin 1.0"
GAP = "gap 1 film_damping branch inlet_shear murch 0.047 0.134 "
DRY = "friction constant 0.1 "
LAWS = {
    "dry": DRY + "smoothed 0.01",
    "dry, spring": DRY,
    "dry, rolling": DRY + "heathcote 1.0e-4 rolling_hysteresis 0.01 spin 1.0",
    "dry, slices": DRY + "slices 1.0e-4 1.0 rolling_hysteresis 0.01",
    "paper": OIL + "friction stribeck 0.12 0.05 smoothed 0.01",
    "paper, spring": OIL + "friction stribeck 0.12 0.05",
    "film": OIL + ROLLING,
    "full": OIL + GAP + ROLLING,
    "full, slices": OIL + GAP + FRICTION.format(slip="slices 1.0e-4 1.0"),
    "full, no differential slip": OIL + GAP + FRICTION.format(slip="smoothed 0.01"),
    "full, no friction": OIL + GAP,
}
RADIAL = "x free y free"
COMBINED = "x free y free z free rx free ry free"
LOADS = {RADIAL: (0, -2000, 0), COMBINED: (0, -1000, 3000)}  # N
MASS, TRANSVERSE = 0.2, 6.5e-5  # kg, kg m^2 of the inner ring
RING = "x y z vx vy vz tilt_1 tilt_2 mz spin".split()
# {type: (motion of inner ring, distance of the grooves from the mid-plane, cage, bearings)}
KINDS = {
    "radial": (RADIAL, 0.0, False, 1),
    "cage": (RADIAL, 0.0, True, 1),
    "thrown cage": (RADIAL, 0.0, True, 1),
    "angular contact": (COMBINED, 0.0, False, 1),
    "four-point": (COMBINED, 0.1e-3, False, 1),
    "two bearings": (RADIAL, 0.0, True, 2),
}
# law, type, integrator, host, ranks
SCENES = [
    *((law, "radial", "implicit", "liggghts", 1) for law in LAWS if "spring" not in law),
    *((law, "radial", "verlet", "liggghts", 1) for law in ("dry, spring", "paper, spring", "full")),
    *(
        ("full", kind, "implicit", "liggghts", 1)
        for kind in KINDS
        if kind not in ("radial", "thrown cage")
    ),
    ("paper", "cage", "implicit", "liggghts", 1),
    ("dry, spring", "four-point", "verlet", "liggghts", 1),
    ("full", "two bearings", "implicit", "liggghts", 2),
    ("full", "two bearings", "verlet", "lammps", 1),
    ("full", "two bearings", "implicit", "wheel", 1),
]
SAMPLE, SAMPLES = 2.5e-5, 100  # s
FINER = {
    "dry": 2,
    "dry, spring": 2,
    "paper, spring": 2,
    "full, no friction": 2,
}  # the losses of a falling dry ring have sharp peaks, and the branch returns its stored energy


def test_every_loss_of_a_contact_is_one_of_bearings_and_rings():
    for section in ("ring", "total", "bearing"):
        assert set(LOSSES) <= {row["name"] for row in TABLES[section]}, section


def ring_columns(wet):
    names = [row["name"] for row in TABLES["ring"]]
    names = ["ring", *names[names.index("az") + 1 :]]
    return [n for n in names if wet or n not in PLATES | {"h_min", "lambda"}]


def deck(law, kind, integrator, out, finer):
    wet = law.startswith("lubricant")
    inner, arch, cage, number = KINDS[kind]
    gap = 6.552e-3 - 6.3e-3
    high = np.sqrt(gap**2 - arch**2)  # distance of a groove's centre above the pitch circle
    grooves = f"gothic_arch {arch}" if arch else ""
    radii = (
        (30.3e-3 + high - 6.552e-3, 30.3e-3 - high + 6.552e-3 - 2e-6) if arch else (24e-3, 36.6e-3)
    )
    substeps = 1 if integrator == "implicit" else 50
    total = ["step"] + [f"c_total[{k}]" for k in range(1, len(TABLES["total"]) + 1)]
    rings = ring_columns(wet)
    values = " ".join(f"c_sides[{k}]" for k in range(1, len(rings) + 1))
    power = "c_springs c_motion c_turning".split()
    if integrator == "implicit":
        power += "f_move[7] f_move[8] f_move[9] f_move[10]".split()
    line = " ".join(f"${{w{k}}}" for k in range(len(total + power)))
    box = BOX.replace("spheres", "bearings").replace(
        "0.06 -0.06 0.06 -0.06", "0.26 -0.06 0.06 -0.06"
    )
    return "\n".join(
        [
            box.replace("every 20", "every 1"),
            f"pair_style bearing/{'ehd' if wet else 'hertz'} {law}",
            f"pair_coeff 1 3 inner {radii[0]} 6.552e-3 {grooves}",
            f"pair_coeff 1 4 outer {radii[1]} 6.552e-3 {grooves}",
            "pair_coeff 1 2 sphere 210e9 0.3 3.3e9 0.41" if cage else "",
            *(
                f"create_bearing 1 {'2' if cage else 'none'} 3 4 balls 9 diameter 12.6e-3"
                " speed 50 0"
                f" {'cage 8.446e-3' if cage else ''} centre {0.1 * k} 0 0 phase {0.1 * k}"
                for k in range(number)
            ),
            "group balls type 1\ngroup cage type 2\ngroup inner type 3\ngroup moving type 1 2",
            "group rings type 3 4",
            "fix rails cage bearing/cage 4" if cage else "",
            "velocity cage set NULL NULL 0.1 units box" if kind == "thrown cage" else "",
            "fix move all bearing/implicit energy yes tolerance 1e-9 largest 2.5e-5"
            if integrator == "implicit"
            else "fix move moving nve/sphere",
            f"fix inner inner bearing/ring mass {MASS} inertia 1.2e-4 {TRANSVERSE} {inner}"
            f" spin speed 50 force {' '.join(map(str, LOADS[inner]))} ramp 1.0e-3",
            f"fix plates balls bearing/capacitance {substeps} permittivity 2.2 surroundings flooded"
            if wet
            else "",
            "compute sides rings bearing/ring " + " ".join(rings),
            "compute total all bearing/total",
            "compute springs all pe pair\ncompute motion moving ke",
            "compute turning moving erotate/sphere",
            *(f"variable w{k} equal {word}" for k, word in enumerate(total + power)),
            f'fix totals all print {substeps} "{line}" file {out}/totals.txt screen no title none',
            f"fix record all bearing/record {substeps} {out} overwrite yes contacts all",
            f"dump sides all local {substeps} {out}/sides.dump {values}",
            f'dump_modify sides ${{dump_format}} "{" ".join(["%.17g"] * len(rings))}"',
            "thermo_style custom step",
            f"timestep {SAMPLE / substeps / finer}",
            f"run {SAMPLES * substeps * finer}",
        ]
    )


class Ran:
    """A completed run of a scene: its record, and the output of computes and the energy balance for
    each step."""

    def __init__(self, folder, text, wet=False, host="liggghts", ranks=1):
        self.wet = wet
        folder.joinpath("in.deck").write_text(text)
        done = run(folder / "in.deck", host=host, ranks=ranks)
        assert done.code == 0, done.text[-3000:]
        with xr.open_dataset(folder / "record.nc") as data:
            self.record = data.load()
        # arrays, because access to an element of a Dataset takes a hundred times as long
        self.values = {n: column.to_numpy() for n, column in self.record.variables.items()}
        self.steps = self.values["step"].astype(int).tolist()
        lines = [
            [float(word) for word in line.split()]
            for line in (folder / "totals.txt").read_text().splitlines()
            if line.strip() and line.split()[0][0].isdigit()
        ]
        self.totals = {int(line[0]): line[1:] for line in lines}
        names = ring_columns(self.wet)
        self.sides = {
            step: [dict(zip(names, map(float, row.split()))) for row in rows]
            for step, rows in frames(folder / "sides.dump").items()
        }

    def contacts(self, step):
        """Return {column: array (raceway, ball)}. Where there is no contact, values are NaN, except
        that losses and loads are 0."""
        at = self.steps.index(step)
        over_time = [n for n in CONTACTS if n in self.values and self.values[n].ndim == 3]
        return {n: self.values[n][at] for n in over_time}

    def inner(self):
        return np.array([str(name).startswith("inner") for name in self.values["raceway"]])


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Return {scene: its run}, computed on first use."""

    class Runs(dict):
        def __missing__(self, scene):
            law, kind, integrator, *where = scene
            words, folder = LAWS[law], tmp_path_factory.mktemp("sums")
            text = deck(words, kind, integrator, folder, FINER.get(law, 1))
            self[scene] = Ran(folder, text, words.startswith("lubricant"), *where)
            return self[scene]

    return Runs()


def scenes(which):
    return pytest.mark.parametrize("scene", which, ids=lambda scene: ", ".join(map(str, scene)))


@pytest.fixture
def ran(scene, runs):
    return runs[scene]


def same(one, other, terms=()):
    """Return True if the values agree within 1e-13 of the value or of its largest term."""
    scale = max([abs(one), abs(other), *(abs(term) for term in np.ravel(terms))])
    return one == other or abs(one - other) <= 1e-13 * scale or (np.isnan(one) and np.isnan(other))


def figures(contacts, inner, balls, wet):
    """Return {name: (result, its terms)} for the contacts of `balls`, as the columns are
    defined."""
    c = {name: values[:, balls] for name, values in contacts.items()}
    live = c["load"] > 0
    found = {"contacts": (live.sum(), ())}
    found["loaded_balls"] = (live[inner].any(0) & live[~inner].any(0)).sum(), ()
    for name in ("load", "pressure"):
        for side, rows in (("inner", inner), ("outer", ~inner)):
            found[f"{name}_{side}"] = np.where(live, c[name], 0.0)[rows].max(), ()
    for name in LOSSES:
        terms = np.where(live, c[name], 0.0)
        found[name] = terms.sum(), terms
    top = np.unravel_index(np.argmax(np.where(live, c["load"], -1)[inner]), live[inner].shape)
    names = ["entrainment"]
    if wet:
        for name in ("h_min", "lambda"):
            found[name] = c[name][live].min() if live.any() else np.nan, ()
        for name in sorted(PLATES):
            whole = name == "capacitance_total"
            terms = np.where(live | whole, c[name], 0.0)
            one, other = terms[inner].sum(0), terms[~inner].sum(0)
            series = [a * b / (a + b) if a > 0 and b > 0 else 0.0 for a, b in zip(one, other)]
            found[name] = sum(series), series
            found[f"{name}_top"] = max(series), ()
        names += ["h_min", "lambda", "h_c", "asperity_share"]
    if live[inner].any():
        found.update({f"{name}_top": (c[name][inner][top], ()) for name in names})
    return found


@scenes(SCENES)
def test_a_record_has_the_sums_of_its_contacts(ran):
    data, inner, checked = ran.values, ran.inner(), set()
    for at, step in enumerate(ran.steps):
        contacts = ran.contacts(step)
        for k, bearing in enumerate(data["bearing"]):
            balls = data["ball_bearing"] == bearing
            for name, (value, terms) in figures(contacts, inner, balls, ran.wet).items():
                if f"bearing_{name}" not in data:
                    assert name in LOSSES and not np.any(terms) or name == "asperity_share_top", (
                        name
                    )
                    continue
                told = data[f"bearing_{name}"][at, k]
                assert same(told, value, terms), (step, name, told, value)
                checked.add(name)
    assert len(checked) >= 9


@scenes(SCENES)
def test_compute_ring_has_the_sums_of_its_contacts(ran):
    data, inner = ran.values, ran.inner()
    wanted = sorted(set(ran.sides) & set(ran.steps))
    assert len(wanted) >= SAMPLES
    for step in wanted:
        contacts = ran.contacts(step)
        rows = {int(row["ring"]): row for row in ran.sides[step]}
        for tag, bearing, raceway in zip(data["ring"], data["ring_bearing"], data["ring_raceway"]):
            balls = data["ball_bearing"] == bearing
            both = figures(contacts, inner, balls, ran.wet)
            on = inner if raceway == 0 else ~inner
            apart = {n: np.where(on[:, None], v, 0.0) for n, v in contacts.items()}
            own = figures(apart, inner, balls, ran.wet)
            side = "inner" if raceway == 0 else "outer"
            wanted = {n: own[n] for n in ("contacts", *LOSSES) if n in own}
            wanted |= {n: own[f"{n}_{side}"] for n in ("load", "pressure")}
            wanted["balls"] = both["loaded_balls"]
            if ran.wet:
                wanted |= {n: both[n] for n in PLATES}
                live = apart["load"][:, balls] > 0
                for n in ("h_min", "lambda"):
                    films = contacts[n][:, balls][live]
                    wanted[n] = films.min() if len(films) else 0.0, ()
            for name in wanted.keys() & rows[tag].keys():
                (value, terms), told = wanted[name], rows[tag][name]
                assert same(told, value, terms), (step, tag, name, told, value)


@scenes(SCENES)
def test_compute_total_has_the_sums_of_all_bearings(ran):
    data, names = ran.values, [row["name"] for row in TABLES["total"]]
    whole = {n: data[f"bearing_{n}"] for n in names if f"bearing_{n}" in data}
    steps = sorted(set(ran.totals) & set(ran.steps))
    assert len(steps) >= SAMPLES - 1
    for step in steps:
        told, contacts = dict(zip(names, ran.totals[step])), ran.contacts(step)
        wanted = figures(contacts, ran.inner(), slice(None), ran.wet)
        wanted["pressure"] = max(wanted["pressure_inner"][0], wanted["pressure_outer"][0]), ()
        at = ran.steps.index(step)
        for n in ("loaded_balls", "cage_power"):
            if n in whole:
                wanted[n] = whole[n][at].sum(), whole[n][at]
        if "cage_force" in whole:
            wanted["cage_force"] = whole["cage_force"][at].max(), ()
        balls = np.array([(data["ball_bearing"] == b).sum() for b in data["bearing"]])
        speeds = whole["cage_speed"][at] * balls / balls.sum()
        wanted["cage_speed"] = speeds.sum(), speeds
        for name in names:
            if name not in wanted:
                continue
            value, terms = wanted[name]
            value = 0.0 if np.isnan(value) else value  # no contact
            assert same(float(f"{value:.15g}"), told[name], terms) or abs(
                told[name] - value
            ) <= 1e-14 * max(abs(value), *np.abs(np.ravel(terms)), 0.0), (
                step,
                name,
                told[name],
                value,
            )


@scenes([scene for scene in SCENES if "drag" in LAWS[scene[0]]])
def test_each_ball_has_one_drag(ran):
    """The drag of a ball counts once, on the outer ring, for any number of grooves."""
    inner, several = ran.inner(), 0
    for step in ran.steps:
        c = ran.contacts(step)
        held = (c["load"][~inner] > 0).sum(0)
        assert ((np.nan_to_num(c["drag_power"]) > 0).sum(0) == (held > 0)).all(), step
        several += (held > 1).sum()
    assert (several > 0) == (len(inner) > 2)


def losses(data):
    """Return the losses in W for each sample."""
    names = [f"bearing_{row['name']}" for row in TABLES["bearing"]]
    names = [name for name in names if name.endswith("_power") and name in data]
    return sum(data[name].sum("bearing").to_numpy() for name in names)


def latter_half(data):
    """Return the first and the last sample of the latter half; they are 4 n samples apart."""
    last = len(data["time"]) - 1
    return last - last // 8 * 4, last


def integrals(data, power, every):
    """Return the energies in J over the latter half of the samples, computed with every n-th sample
    for each n in `every`."""
    first, last = latter_half(data)
    time = data["time"].to_numpy()
    return [np.trapezoid(power[first : last + 1 : n], time[first : last + 1 : n]) for n in every]


@scenes([scene for scene in SCENES if scene[2] == "verlet"])
def test_power_in_is_losses_plus_what_the_host_stores(ran, scene):
    """Under velocity Verlet, the host computes the stored energy. The work of constant loads is
    computed from the displacement."""
    data, steps = ran.record, ran.steps
    moves = data["ring_raceway"] == 0
    ring = {name: data[f"ring_{name}"][:, moves].to_numpy() for name in RING}
    first, last = latter_half(data)
    lost, of_losses = integrals(data, losses(data), (1, 2))
    driven, of_drive = integrals(data, -(ring["mz"] * ring["spin"]).sum(1), (1, 2))
    error = abs(lost - of_losses) + abs(driven - of_drive)
    force = LOADS[KINDS[scene[1]][0]]
    work = sum(f * (ring[k][last] - ring[k][first]).sum() for f, k in zip(force, "xyz"))
    motion = 0.5 * MASS * sum(ring[f"v{k}"] ** 2 for k in "xyz")
    for tilt in ("tilt_1", "tilt_2"):
        path = CubicSpline(data["time"], ring[tilt])
        motion += 0.5 * TRANSVERSE * path(data["time"], 1) ** 2
    energy = motion.sum(1)
    stored = energy[last] - energy[first]
    stored += sum(ran.totals[steps[last]][-3:]) - sum(ran.totals[steps[first]][-3:])
    assert abs(work + driven - stored - lost) <= error
    assert error <= 0.1 * lost, "the estimate is too inaccurate"


@scenes([scene for scene in SCENES if scene[2] == "implicit"])
def test_power_in_is_losses_plus_what_is_stored(ran):
    """The energies are those in the energy balance of fix bearing/implicit. The error of a sum over
    samples is the difference between sums over every second and every fourth sample. The error of
    the integrator is `missing` in the balance."""
    data, steps = ran.record, ran.steps
    first, last = latter_half(data)
    sums = integrals(data, losses(data), (1, 2, 4))
    lost = sums[0]
    work, taken, stored, missing = np.array(ran.totals[steps[last]][-4:]) - np.array(
        ran.totals[steps[first]][-4:]
    )
    error = np.abs(np.diff(sums)).max() + abs(missing)
    assert lost > 0
    assert abs(taken - lost) <= error
    assert abs(work - stored - lost) <= error
    assert error <= 0.1 * lost, "the estimate is too inaccurate"


@pytest.mark.parametrize("integrator", ["implicit", "verlet"])
def test_a_thrown_cage_loses_its_energy_at_the_rails(tmp_path, integrator):
    law = LAWS["dry" if integrator == "implicit" else "dry, spring"]
    text = deck(law, "thrown cage", integrator, tmp_path, 8)
    for word in ("speed 50 0", "spin speed 50"):
        assert word in text
        text = text.replace(word, word.replace("50", "0"))
    ran = Ran(tmp_path, text.replace("force 0 -2000 0", "force 0 0 0"))
    first, last = (sum(ran.totals[ran.steps[at]][len(TABLES["total"]) :][:3]) for at in (1, -1))
    lost = np.trapezoid(losses(ran.record)[1:], ran.record["time"][1:])
    assert lost == pytest.approx(first - last, rel=0.01)
