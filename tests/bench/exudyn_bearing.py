# SPDX-License-Identifier: GPL-2.0-or-later
"""Run Exudyn's ball bearing with the dimensions of a 6208:

    python exudyn_bearing.py SETTINGS

SETTINGS is a JSON object with these keys: stiffness (N/m^exponent), exponent, damping (N s/m),
friction, zone (sliding speed in m/s at which friction is fully developed), load (N, towards -y),
speed (rad/s), step, ramp, settle and window (all in s), sampling (period in s, a multiple of step),
and folder, which is the folder for the sensor files, or "" to write no files if only the time
matters. The program prints one line of JSON. It contains the wall seconds of the time loop, the
simulated seconds and, for each sample of the window, the position of the ring (m), the positions of
the balls (m) and their inner loads (N). If the solver stops, the line contains its error and the
time (s) that it reached.
"""

import json
import sys
import time
import warnings

import exudyn as exu
import numpy as np
from exudyn.machines import CreateBallBearing, GetBallBearingData
from exudyn.utilities import MarkerBodyRigid, RigidBodyInertia, SensorBody, SensorObject

BALL, INNER, OUTER, GROOVE = 6.3e-3, 24.0e-3, 36.6e-3, 6.552e-3  # m, radii of inputs/bearings/6208
RING_MASS, RING_INERTIA = 0.2, (6.5e-5, 6.5e-5, 1.2e-4)  # kg, kg m^2


def model(case):
    """Return (system, inner contacts, bodies of the balls and the inner ring). The outer ring is
    fixed; the inner ring is driven and free to move in its plane."""
    system = exu.SystemContainer().AddSystem()
    pitch = (INNER + OUTER) / 2
    data = GetBallBearingData(
        [0, 0, 1],
        0.080,
        0.040,
        0.018,
        9,
        radiusBalls=BALL,
        radiusCage=pitch,
        innerGrooveRadius=GROOVE,
        outerGrooveRadius=GROOVE,
    )
    ring = system.CreateRigidBody(
        inertia=RigidBodyInertia(mass=RING_MASS, inertiaTensor=np.diag(RING_INERTIA)),
        nodeType=exu.NodeType.RotationRxyz,
        initialAngularVelocity=[0, 0, case["speed"]],
    )
    system.CreateCoordinateConstraint(
        bodyNumbers=[ring, None], coordinates=[5, None], velocityLevel=True, offset=case["speed"]
    )
    for held in (2, 3, 4):  # the displacement along z and both tilts
        system.CreateCoordinateConstraint(bodyNumbers=[ring, None], coordinates=[held, None])
    orbit = case["speed"] * INNER / (2 * pitch)
    made = CreateBallBearing(
        system,
        data,
        system.AddMarker(MarkerBodyRigid(bodyNumber=ring)),
        system.AddMarker(MarkerBodyRigid(bodyNumber=system.CreateGround())),
        7800.0,
        1100.0,
        cageInitialAngularVelocity=[0, 0, orbit],
        ballsInitialAngularVelocity=[0, 0, orbit * (1 - OUTER / BALL)],
        springStiffnessCage=1e5,
        springDampingCage=1e2,  # as in Exudyn's test model; with zero, there would be no cage
        contactParametersRingBalls={
            "contactStiffness": case["stiffness"],
            "contactDamping": case["damping"],
            "contactStiffnessExponent": case["exponent"],
            "dynamicFriction": case["friction"],
            "frictionProportionalZone": case["zone"],
        },
    )
    system.CreateForce(
        bodyNumber=ring,
        loadVectorUserFunction=lambda mbs, t, v: [0, -case["load"] * min(1.0, t / case["ramp"]), 0],
    )
    return system, made["innerRingBallContacts"], [*made["objectsBalls"], ring]


def sensors(system, contacts, bodies, folder):
    """Return (contact force files, body position files); both are empty if no folder is given."""
    kinds, files = exu.OutputVariableType, ([], [])
    if not folder:
        return files
    for n in contacts:
        files[0].append(f"{folder}/force{n}.txt")
        system.AddSensor(
            SensorObject(objectNumber=n, fileName=files[0][-1], outputVariableType=kinds.Force)
        )
    for n in bodies:
        files[1].append(f"{folder}/place{n}.txt")
        system.AddSensor(
            SensorBody(bodyNumber=n, fileName=files[1][-1], outputVariableType=kinds.Position)
        )
    return files


def table(file):
    """Return the rows (time, x, y, z) written by a sensor."""
    return np.loadtxt(file, delimiter=",", comments="#")


def run(case):
    """Return the results described in the docstring of the module as a dict."""
    system, contacts, bodies = model(case)
    forces, places = sensors(system, contacts, bodies, case["folder"])
    system.Assemble()
    end = case["settle"] + case["window"]
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = case["period"]
    settings.timeIntegration.endTime = end
    settings.timeIntegration.numberOfSteps = round(end / case["step"])
    settings.timeIntegration.newton.absoluteTolerance = (
        1e-8  # these settings and the solver are those of Exudyn's bearing test model
    )
    settings.timeIntegration.newton.relativeTolerance = 1e-6
    settings.timeIntegration.newton.useModifiedNewton = True
    settings.timeIntegration.verboseMode = 0
    settings.linearSolverType = exu.LinearSolverType.EigenSparse
    settings.parallel.numberOfThreads = 1
    start = time.perf_counter()
    try:
        system.SolveDynamic(settings)
    except Exception as error:  # Exudyn's exceptions have no common base class
        reached = system.systemData.GetTime()
        return {"error": f"{type(error).__name__}: {error}", "reached": reached}
    wall = time.perf_counter() - start
    if not case["folder"]:
        return {"wall": wall, "simulated": end}
    system.Reset()  # this closes the files
    load = np.linalg.norm([table(file)[:, 1:] for file in forces], axis=2).T
    place = np.array([table(file)[:, 1:3] for file in places]).swapaxes(0, 1)
    late = table(places[0])[:, 0] > case["settle"] + case["period"] / 2
    return {
        "wall": wall,
        "simulated": end,
        "shift": place[late, -1].tolist(),
        "balls": place[late, :-1].tolist(),
        "loads": load[late].tolist(),
    }


if __name__ == "__main__":
    # Exudyn's own examples still use deprecated names of settings
    warnings.simplefilter("ignore", DeprecationWarning)
    print(json.dumps(run(json.loads(sys.argv[1]))))
