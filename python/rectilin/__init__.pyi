"""Types of the package rectilin; help(rectilin) teaches it."""

import os
from typing import Any, Callable, Dict, Iterable, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
# A Mesh, an object with .vertices and .faces (also .points, .triangles, .cells_dict), or the name of a file or shape.
MeshLike = Any
Progress = Callable[[int, float, float, float], Any]
Search = Callable[["Evaluator", int, np.random.Generator], None]

__version__: str

class MeshError(ValueError): ...
class ParameterError(ValueError): ...
class Exhausted(BaseException): ...

class Mesh:
    vertices: Floats
    faces: NDArray[np.uint32]
    name: str
    report: Dict[str, Any]
    def __init__(self, V: Union[ArrayLike, MeshLike], F: Optional[ArrayLike] = None, name: str = "") -> None: ...

class Rectilinearity:
    rectilinearity: float
    lower: Optional[float]
    upper: Optional[float]
    rotation: Floats
    angles: Floats
    faces: int
    directions: int
    area: float
    optima: List[Dict[str, Any]]
    parallel_faces: List[Dict[str, Any]]
    proof: Optional[str]
    outcome: str
    evaluations: int
    seconds: float
    trace: Dict[str, NDArray[Any]]
    def to_dict(self) -> Dict[str, Any]: ...

class Verdict:
    accepted: bool
    reason: str
    lower: float
    upper: float
    leaves: int
    cuts: int
    def __bool__(self) -> bool: ...

class Domain:
    name: str
    lower: Floats
    upper: Floats
    covers: bool
    def rotation(self, x: ArrayLike) -> Floats: ...
    def coordinates(self, rotation: ArrayLike, form: Optional[str] = None) -> Floats: ...

class Problem:
    name: str
    faces: int
    directions: int
    area: float
    vectors: Floats
    def __init__(self, V: Union[ArrayLike, MeshLike], F: Optional[ArrayLike] = None, name: Optional[str] = None) -> None: ...
    @staticmethod
    def from_normals(N: ArrayLike, weights: Optional[ArrayLike] = None, name: str = "normals") -> "Problem": ...
    def values(self, rotations: ArrayLike, form: Optional[str] = None) -> Any: ...
    def cuts(self, rotations: ArrayLike, form: Optional[str] = None) -> Tuple[Any, Floats]: ...
    def smooth(self, rotation: ArrayLike, width: float, form: Optional[str] = None) -> Tuple[float, Floats]: ...
    def best_turn(self, rotation: ArrayLike, axis: int, form: Optional[str] = None) -> Tuple[Floats, float]: ...
    def measure(
        self,
        *,
        gap: float = 1e-6,
        optimizer: str = "certify",
        optima: bool = False,
        domain: str = "covering",
        seed: int = 1,
        budget: Optional[int] = None,
        seconds: Optional[float] = None,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> Rectilinearity: ...

class Evaluator:
    name: str
    directions: int
    domain: Domain
    remaining: int
    evaluations: int
    exhausted: bool
    best: Tuple[Floats, float]
    def values(self, rotations: ArrayLike, form: Optional[str] = None) -> Any: ...
    def cuts(self, rotations: ArrayLike, form: Optional[str] = None) -> Tuple[Any, Floats]: ...
    def smooth(self, rotation: ArrayLike, width: float, form: Optional[str] = None) -> Tuple[float, Floats]: ...
    def best_turn(self, rotation: ArrayLike, axis: int, form: Optional[str] = None) -> Tuple[Floats, float]: ...

class Run:
    optimizer: str
    parameters: Any
    domain: str
    seed: int
    outcome: str
    value: float
    rectilinearity: float
    rotation: Floats
    value_bound: Optional[float]
    evaluations: int
    seconds: float
    trace: Dict[str, NDArray[Any]]
    def to_dict(self) -> Dict[str, Any]: ...

class Comparison:
    folder: str
    page: str
    failed_runs: int
    mesh_errors: List[str]
    losses: List[str]
    troubles: List[str]
    summary: Dict[str, Any]
    runs: List[Dict[str, Any]]

def load(source: Union[str, os.PathLike[str]]) -> Mesh: ...
def save(file: Union[str, os.PathLike[str]], V: Union[ArrayLike, MeshLike], F: Optional[ArrayLike] = None, *, binary: bool = True) -> None: ...
def shape(spec: str) -> Mesh: ...
def shapes() -> List[Dict[str, Any]]: ...
def sources(names: Iterable[str]) -> List[str]: ...
def measure(
    V: Union[ArrayLike, MeshLike],
    F: Optional[ArrayLike] = None,
    *,
    gap: float = 1e-6,
    optimizer: str = "certify",
    optima: bool = False,
    proof: bool = False,
    domain: str = "covering",
    seed: int = 1,
    budget: Optional[int] = None,
    seconds: Optional[float] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Rectilinearity: ...
def measure_normals(
    N: ArrayLike,
    weights: Optional[ArrayLike] = None,
    *,
    gap: float = 1e-6,
    optimizer: str = "certify",
    optima: bool = False,
    proof: bool = False,
    domain: str = "covering",
    seed: int = 1,
    budget: Optional[int] = None,
    seconds: Optional[float] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Rectilinearity: ...
def read_normals(file: Union[str, os.PathLike[str]]) -> Tuple[Floats, Floats]: ...
def verify(proof: str, V: Union[ArrayLike, MeshLike], F: Optional[ArrayLike] = None) -> Verdict: ...
def rectilinearity(value: Any) -> Any: ...
def domain(name: str) -> Domain: ...
def optimizers() -> List[Dict[str, Any]]: ...
def optimize(
    problem: Union[Problem, MeshLike],
    optimizer: Union[str, Search],
    *,
    budget: Optional[int] = 10000,
    seconds: Optional[float] = None,
    seed: int = 1,
    domain: str = "covering",
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Run: ...
def compare(
    problems: Any,
    optimizers: Any,
    *,
    runs: int = 15,
    budget: int = 10000,
    seed: int = 1,
    domain: str = "covering",
    certificate: str = "certify?gap=1e-10",
    out: Union[str, os.PathLike[str]] = "comparison",
    threads: Optional[int] = None,
    patience: float = 60.0,
    progress: Optional[Callable[[int, int, str], Any]] = None,
) -> Comparison: ...
def suites() -> List[Dict[str, Any]]: ...
def suite(name: str) -> Dict[str, Problem]: ...
def export(problem: Union[Problem, MeshLike], file: Union[str, os.PathLike[str]], *, gap: float = 1e-9) -> None: ...
def read_traces(
    folder: Union[str, os.PathLike[str]], file: Union[str, os.PathLike[str]], problems: Optional[Dict[str, Any]] = None
) -> int: ...
def render(
    V: Union[ArrayLike, MeshLike],
    F: Optional[ArrayLike] = None,
    *,
    direction: Optional[ArrayLike] = None,
    rotation: Optional[ArrayLike] = None,
    size: int = 256,
) -> NDArray[np.uint16]: ...
def shaded(
    V: Union[ArrayLike, MeshLike],
    F: Optional[ArrayLike] = None,
    *,
    direction: Optional[ArrayLike] = None,
    rotation: Optional[ArrayLike] = None,
    size: int = 256,
) -> NDArray[np.uint8]: ...
def silhouette_area(
    V: Union[ArrayLike, MeshLike],
    F: Optional[ArrayLike] = None,
    *,
    directions: ArrayLike = (0, 0, 1),
    tolerance: float = 1e-6,
    threads: Optional[int] = None,
) -> Tuple[Any, Any]: ...
def views(count: int) -> Floats: ...

class Pose:
    method: str
    chosen: str
    reason: str
    rotation: Floats
    centre: Floats
    scale: float
    uniqueness: str
    free_axis: Optional[int]
    alternatives: Floats
    confidence: float
    def to_dict(self) -> Dict[str, Any]: ...
    def normalized(self, V: Union[ArrayLike, MeshLike], F: Optional[ArrayLike] = None) -> Mesh: ...

def pose(
    V: Union[ArrayLike, MeshLike], F: Optional[ArrayLike] = None, *, method: str = "composite", threads: Optional[int] = None
) -> Pose: ...
def poses() -> List[Dict[str, Any]]: ...
def resolve_axes(
    V: Union[ArrayLike, MeshLike], F: Optional[ArrayLike] = None, *, rotation: ArrayLike, rule: str = "definite"
) -> Tuple[Floats, bool]: ...
def describe(V: Union[ArrayLike, MeshLike], F: Optional[ArrayLike] = None, *, descriptor: str = "gsmd") -> NDArray[np.uint8]: ...
def distance(a: NDArray[np.uint8], b: NDArray[np.uint8], *, descriptor: str = "gsmd") -> float: ...
def descriptors() -> List[Dict[str, Any]]: ...

class Neighbours:
    names: List[str]
    members: NDArray[np.int64]
    distances: Floats
    def __len__(self) -> int: ...

class Database:
    file: str
    descriptor: str
    names: List[str]
    sources: List[str]
    rectilinearity: Floats
    faces: NDArray[np.int64]
    size: Floats
    failed: Dict[str, str]
    def __init__(self, file: Union[str, os.PathLike[str]]) -> None: ...
    def __len__(self) -> int: ...
    def signature(self, member: Union[str, int]) -> NDArray[np.uint8]: ...
    def search(
        self,
        V: Optional[Union[ArrayLike, MeshLike]] = None,
        F: Optional[ArrayLike] = None,
        *,
        like: Optional[Union[str, int]] = None,
        count: int = 20,
        keep: Optional[ArrayLike] = None,
        collection: bool = False,
        threads: Optional[int] = None,
    ) -> Neighbours: ...

def index(
    sources: Union[str, os.PathLike[str], Iterable[Union[str, os.PathLike[str]]]],
    out: Union[str, os.PathLike[str]],
    *,
    descriptor: Optional[str] = None,
    threads: Optional[int] = None,
    progress: Optional[Callable[[int, int, str], Any]] = None,
) -> Dict[str, Any]: ...
def search(
    database: Union[Database, str, os.PathLike[str]],
    V: Optional[Union[ArrayLike, MeshLike]] = None,
    F: Optional[ArrayLike] = None,
    *,
    like: Optional[Union[str, int]] = None,
    count: int = 20,
    keep: Optional[ArrayLike] = None,
    collection: bool = False,
    threads: Optional[int] = None,
) -> Neighbours: ...
def duplicates(
    database: Union[str, os.PathLike[str]],
    *,
    tolerance: float = 0.015,
    neighbours: int = 10,
    threads: Optional[int] = None,
    progress: Optional[Callable[[int, int, str], Any]] = None,
) -> Dict[str, Any]: ...
