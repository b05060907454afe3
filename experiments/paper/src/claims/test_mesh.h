// A mesh on which claims are tested, with what most of them need.
#pragma once

#include <memory>
#include <string>

#include "rectilin/base/rotation.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/mesh_report.h"

namespace rectilin::paper::claims {

/// Certified bounds of the least P/S: `rotation` has `found`, and no rotation has less than `lower`.
struct Enclosure {
  Rotation rotation = {};
  double found = 0;
  double lower = 0;

  double least_r() const { return rectilinearity(found); }
  double greatest_r() const { return rectilinearity(lower); }
};

/// How many boxes of rotations a search may use. Ordinary meshes need some thousands; for nearly round ones (R < 0.01)
/// the bounds reached by then are used, which are proved all the same.
inline constexpr int kCells = 30'000;

/// Encloses the least P/S by branch and bound until R is known to within `gap`.
Enclosure enclose(const ProjectedArea& objective, double gap = 1e-6, int cells = kCells);
Enclosure enclose(const Mesh& mesh, double gap = 1e-6);

/// The distance between two intervals of R: 0 if they overlap.
double distance(const Enclosure& a, const Enclosure& b);

struct TestMesh {
  std::string source;
  std::shared_ptr<const Mesh> mesh;  ///< scaled by a power of two so that coordinates are below 1
  std::shared_ptr<const ProjectedArea> objective;
  Enclosure best;

  const AreaVectors& vectors() const { return objective->vectors(); }
};

/// Loads a mesh and measures it. Throws what load_mesh() and area_vectors() throw.
TestMesh make_test_mesh(const std::string& source, LossLog* losses = nullptr);
TestMesh make_test_mesh(Mesh mesh, std::string name);

/// The source of a built-in shape ("box?x=2") in a random pose.
std::string posed(const std::string& shape, Random& random);

/// The error of P/S if area vectors are computed in double precision: the rounding of edges and cross products, divided
/// by S. It is large only for meshes of slivers. With `moved` it includes the rounding of coordinates by a rotation,
/// which is large for a mesh far from the origin.
double coordinate_rounding(const Mesh& mesh, double area, bool moved = false);

/// The most that R can change if the area vectors change by eta S in total, eta < 1: 3 (1 + sqrt(3)) eta / (1 - eta)
/// (papers/closed-forms.md, "Stability"). Infinite for eta >= 1.
double r_change_bound(double eta);

}  // namespace rectilin::paper::claims
