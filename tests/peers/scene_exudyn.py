"""Scenes without touches in Exudyn: mass points, spring-dampers, and one object for air and pressure."""
import exudyn
import numpy
from exudyn.itemInterface import (MarkerNodePosition, NodePoint, NodePointGround, ObjectConnectorSpringDamper, ObjectGenericODE2)

SAMPLES = 10
STEPS = [1 / 160, 1 / 320, 1e-3, 5e-4, 2e-4, 1e-4]
TOLERANCES = [1e-3, 1e-5, 1e-7, 1e-9]


def built(scene):
    """The system; coordinates are displacements of the points that are not fixed."""
    mbs = exudyn.SystemContainer().AddSystem()
    nodes = [mbs.AddNode(NodePointGround(referenceCoordinates=x) if fixed else NodePoint(referenceCoordinates=x))
             for x, fixed in zip(scene.x.tolist(), scene.fixed)]
    markers = [mbs.AddMarker(MarkerNodePosition(nodeNumber=node)) for node in nodes]
    for (tail, head), rest in zip(scene.springs, scene.rest):
        mbs.AddObject(ObjectConnectorSpringDamper(markerNumbers=[markers[tail], markers[head]], stiffness=scene.stiffness, referenceLength=rest))
    moving = numpy.flatnonzero(~scene.fixed)
    n, x = 3 * len(moving), scene.x.copy()

    def force(mbs, t, item, q, q_t):
        x[moving] = scene.x[moving] + numpy.array(q).reshape(-1, 3)
        return (scene.blown(x)[moving] - scene.drag * numpy.array(q_t).reshape(-1, 3) - [0, 0, scene.gravity]).ravel()

    mass = exudyn.MatrixContainer()
    diagonal = numpy.arange(n)
    mass.SetWithSparseMatrix(numpy.column_stack([diagonal, diagonal, numpy.ones(n)]), n, n)
    mbs.AddObject(ObjectGenericODE2(nodeNumbers=[nodes[i] for i in moving], massMatrix=mass, forceUserFunction=force))
    mbs.Assemble()
    return mbs, moving


def solver(scene, kind, control, seconds):
    mbs, moving = built(scene)
    settings = exudyn.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.verboseMode = 0
    settings.linearSolverType = exudyn.LinearSolverType.EigenSparse
    integration, interval = settings.timeIntegration, seconds / SAMPLES
    integration.automaticStepSize = "tolerance" in control
    if integration.automaticStepSize:
        integration.relativeTolerance = integration.absoluteTolerance = control["tolerance"]
    integration.numberOfSteps = 1 if integration.automaticStepSize else round(interval / control["step"])
    zero = numpy.zeros(3 * len(moving))

    def solve():
        q, q_t, samples = zero, zero, []
        for k in range(SAMPLES):
            mbs.systemData.SetODE2Coordinates(q, exudyn.ConfigurationType.Initial)
            mbs.systemData.SetODE2Coordinates_t(q_t, exudyn.ConfigurationType.Initial)
            integration.startTime, integration.endTime = k * interval, (k + 1) * interval
            if not mbs.SolveDynamic(settings, solverType=getattr(exudyn.DynamicSolverType, kind)):
                raise RuntimeError("its solver failed")
            q, q_t = mbs.systemData.GetODE2Coordinates(), mbs.systemData.GetODE2Coordinates_t()
            x = scene.x.copy()
            x[moving] += q.reshape(-1, 3)
            samples.append(x.ravel())
        return numpy.array(samples), None

    return solve


def solvers(scene, seconds):
    """(method, its control, what solves or why nothing can) of every point."""
    if scene.has_ground:
        yield "Exudyn", None, "its contacts are penalties; steps split at events from outside: not built"
        return
    for step in STEPS:
        yield "Exudyn RK44", {"step": step}, solver(scene, "RK44", {"step": step}, seconds)
    for tolerance in TOLERANCES:
        yield "Exudyn DOPRI5", {"tolerance": tolerance}, solver(scene, "DOPRI5", {"tolerance": tolerance}, seconds)
