#include "rectilin/mesh/mesh_io.h"

namespace rectilin {

Json to_json(const MeshReport& r) {
  Json json = {{"vertices", r.vertices},
               {"polygons", r.polygons},
               {"triangulated", r.triangulated},
               {"nonfinite_vertices", r.nonfinite_vertices},
               {"dropped_nonfinite", r.dropped_nonfinite},
               {"dropped_short", r.dropped_short},
               {"degenerate", r.degenerate},
               {"duplicate_vertices", r.duplicate_vertices},
               {"unreferenced_vertices", r.unreferenced_vertices}};
  if (r.scene.metres_per_unit > 0)
    json["scene"] = {
        {"metres_per_unit", r.scene.metres_per_unit}, {"instances", r.scene.instances}, {"skipped", r.scene.skipped}};
  return json;
}

}  // namespace rectilin
