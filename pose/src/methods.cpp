#include "methods.h"

#include <cmath>

#include "rectilin/measure/projected_area.h"
#include "rectilin/optim/registry.h"
#include "working_frame.h"

namespace rectilin::pose {

void CertifiedOptions::bind(Parameters& table) {
  table.real("gap", gap, 0, 10, "width to which the rectilinearity is certified")
      .integer("cells", cells, 0, 2'000'000'000, "boxes of rotations looked at, at most; 0: no limit")
      .flag("optima", optima, "look for other poses as good: is it unique?");
}

void BoxOptions::bind(Parameters& table) {
  table.integer("directions", directions, 1, 1'000'000, "directions of the hemisphere tried as an axis of the box");
}

void SymmetryOptions::bind(Parameters& table) { table.integer("planes", planes, 1, 100, "mirror planes looked for"); }

void SilhouetteOptions::bind(Parameters& table) {
  table.real("tolerance", tolerance, 1e-12, 0.1, "relative width to which silhouettes are known")
      .integer("evaluations", evaluations, 1, 10'000'000, "frames looked at")
      .custom(
          "optimizer", "an optimizer of the library",
          [this](const Json& value) {
            if (!value.is_string()) return false;
            builtin_optimizers().make(value.get<std::string>());  // throws for what there is not
            optimizer = value.get<std::string>();
            return true;
          },
          [this] { return Json(optimizer); }, "what searches, from the better of PCA and rectilinear");
}

void CpnOptions::bind(Parameters& table) {
  table
      .flag("pixels", pixels,
            "count pixels, as the paper does; false: enclose the areas until they are told apart, to 1e-6 if need be")
      .integer("size", size, 16, 4096, "pixels along an edge of the pictures")
      .real("gap", gap, 0, 10, "width to which the rectilinearity is certified");
}

void CompositeOptions::bind(Parameters& table) {
  table.real("symmetry", symmetry, 0, 100, "weight of the mirror defects beside the projected area")
      .real("flat", flat, 0, 100, "weight of flat sides to stand on")
      .integer("planes", planes, 1, 100, "mirror planes that frames are made from")
      .real("gap", gap, 0, 10, "width to which the rectilinearity is certified");
}

namespace {

/// What all methods have in common: the centre, the scale, P/S of the candidates; and an axis that is free because the
/// mesh is a body of revolution.
Pose finished(Pose pose, const Surface& surface, const std::string& method) {
  pose.method = method;
  pose.centre = surface.centre;
  pose.scale = std::ldexp(1 / surface.radius, -surface.exponent);
  if (!std::isfinite(pose.scale) || !(pose.scale > 0))
    throw MeshError("its size is beyond the range in which a mesh can be scaled to size one");
  const ProjectedArea objective(area_vectors(surface.mesh));
  for (PoseCandidate& candidate : pose.candidates)
    objective.values({&candidate.rotation, 1}, {&candidate.projected, 1});
  return pose;
}

template <class Options, class Find>
void add(Factory<PoseMethod>& table, const std::string& name, std::string help, Find find) {
  table.add(name, std::move(help), Options(), [name, find](const Options& options) -> PoseMethod {
    return [name, find, options](const Mesh& mesh) {
      const Surface surface = make_surface(mesh);
      return finished(find(surface, options), surface, name);
    };
  });
}

/// The same for a method that looks from directions of its own, or takes the first of several frames that are as good:
/// it gets the surface in its working frame.
template <class Options, class Find>
void add_turning(Factory<PoseMethod>& table, const std::string& name, std::string help, Find find) {
  add<Options>(table, name, std::move(help), [find](const Surface& surface, const Options& options) {
    const Rotation work = working_frame(surface);
    return turned_back(find(turned(surface, work), options), work);
  });
}

}  // namespace

const Factory<PoseMethod>& pose_methods() {
  static const Factory<PoseMethod> methods = [] {
    Factory<PoseMethod> table("pose method");
    add<NoOptions>(table, "pca", "principal axes of the surface, exactly integrated",
                   [](const Surface& s, NoOptions) { return pca_pose(s); });
    add<NoOptions>(table, "vertex-pca", "principal axes of the vertices",
                   [](const Surface& s, NoOptions) { return vertex_pca_pose(s); });
    add<NoOptions>(table, "normal-pca", "principal axes of the faces' normals, weighted by area",
                   [](const Surface& s, NoOptions) { return normal_pca_pose(s); });
    add_turning<CertifiedOptions>(table, "rectilinear", "the pose of R(M): least projected area, certified",
                                  rectilinear_pose);
    add_turning<CertifiedOptions>(table, "hull", "the same of the convex hull: least silhouettes of the hull",
                                  hull_pose);
    add_turning<BoxOptions>(table, "box", "the axes of the box of least volume found", box_pose);
    add_turning<SymmetryOptions>(
        table, "symmetry", "the best mirror plane or axis of revolution, then the best turn about it", symmetry_pose);
    add_turning<SilhouetteOptions>(table, "silhouette", "least silhouettes of the mesh itself, by search",
                                   silhouette_pose);
    add_turning<CpnOptions>(table, "cpn",
                            "the paper's: PCA or rectilinear, whichever has the smaller three silhouettes", cpn_pose);
    add_turning<CompositeOptions>(table, "composite",
                                  "the best of all by projected area, mirror symmetry and flat sides", composite_pose);
    return table;
  }();
  return methods;
}

}  // namespace rectilin::pose
