// Poses as JSON.
#pragma once

#include "rectilin/pose/pose.h"

namespace rectilin::pose {

/// `method`, `chosen`, `reason`, `rotation` (three rows: the new axes in the mesh's coordinates), `centre`, `scale`,
/// `unique`, `uniqueness`, `free_axis` ("x", "y", "z" or null), `alternatives`, `confidence`, and `candidates`, best
/// first: `name`, `rotation`, `projected_area` and `silhouette_area` in the square of the mesh's unit, `volume`,
/// `mirror_defects`, `flat_share`, `score`. What was not measured, or is beyond double's range, is null. `area` is that
/// of the mesh's surface, in the square of its unit.
Json to_json(const Pose& pose, double area);

}  // namespace rectilin::pose
