"""How rectilinear is a 3D mesh? A certified answer, and a laboratory for optimizers.

R(M) = 3 (max S/P - 2/3), where S is the surface area, P the sum of the areas projected on three orthogonal planes, and
the maximum runs over all rotations of the planes (Lian, Rosin and Sun, IJCV 2010). R is 1 exactly for meshes whose faces
all meet at right angles, and tends to 0 for spheres. The rotation that attains it is a natural pose of the object.

Measure
    >>> import rectilin
    >>> r = rectilin.measure('shape:pyramid')        # or 'chair.off', V and F, a mesh of trimesh, Open3D, meshio
    >>> r.lower <= r.rectilinearity <= r.upper       # proved to 1e-6
    True
    >>> r.rotation.shape                             # its rows are the axes of the pose
    (3, 3)

Optimize
    >>> problem = rectilin.Problem('shape:pyramid')  # P/S as a function of rotations
    >>> problem.values(r.rotation) < problem.values([0.1, 0.2, 0.3, 1])
    True
    >>> run = rectilin.optimize(problem, 'ga', budget=2000)
    >>> run.rectilinearity <= r.upper
    True

Compare, your own optimizers among others
    >>> def dice(problem, budget, rng):
    ...     problem.values(rng.normal(size=(budget, 4)))    # random quaternions
    >>> rectilin.compare([problem], {'ga': 'ga', 'dice': dice}, runs=2, budget=500, out=folder).failed_runs
    0

Meshes        load, save, shape, shapes, sources, Mesh
Measuring     measure, measure_normals, read_normals, verify, rectilinearity, Rectilinearity, Verdict
Posing        pose, poses, resolve_axes, Pose
Looking       render, shaded, silhouette_area, views
Retrieving    describe, distance, descriptors
Searching     index, search, duplicates, Database, Neighbours
Optimizing    Problem, optimize, optimizers, domain, Run, Evaluator, Domain
Comparing     compare, Comparison; suites, suite, export, read_traces
Exceptions    MeshError and ParameterError, both ValueErrors of one line; Exhausted, which ends an optimizer

Arrays are numpy's, in C order: vertices (n, 3) float64, faces (m, 3) integers, rotations (3, 3) or (n, 3, 3) with the
frame's axes as rows. Angles are in radians. Everything is safe to call from several threads; the same seed gives the
same bits for any number of threads, the bits of the command `rectilin`.
"""

from ._rectilin import (
    Comparison,
    Database,
    Domain,
    Evaluator,
    Exhausted,
    Mesh,
    MeshError,
    Neighbours,
    ParameterError,
    Pose,
    Problem,
    Rectilinearity,
    Run,
    Verdict,
    __version__,
    compare,
    describe,
    descriptors,
    distance,
    domain,
    duplicates,
    export,
    index,
    load,
    measure,
    measure_normals,
    optimize,
    optimizers,
    pose,
    poses,
    read_normals,
    read_traces,
    rectilinearity,
    render,
    resolve_axes,
    save,
    search,
    shaded,
    shape,
    shapes,
    silhouette_area,
    sources,
    suite,
    suites,
    verify,
    views,
)

__all__ = [name for name in dir() if not name.startswith("_")] + ["__version__"]
