// A mesh under test, with what most claims need of it.
#pragma once

#include <memory>
#include <string>

#include "rectilin/base/rotation.h"
#include "rectilin/measure/projected_area.h"

namespace rectilin::paper::claims {

/// Certified bounds of the least P/S: it is `found` at `rotation`, and no rotation has less than
/// `lower`.
struct Enclosure {
  Rotation rotation = {};
  double found = 0;
  double lower = 0;

  double least_r() const { return rectilinearity(found); }
  double greatest_r() const { return rectilinearity(lower); }
};

/// Boxes of rotations that a search may look at. Ordinary meshes need some thousands; nearly round
/// ones (R < 0.01) keep the bounds reached until then, which are proved all the same.
inline constexpr int kCells = 30'000;

/// Encloses the least P/S by branch and bound, R to within `gap`.
Enclosure enclose(const ProjectedArea& objective, double gap = 1e-6, int cells = kCells);
Enclosure enclose(const Mesh& mesh, double gap = 1e-6);

/// Least distance between a number of the one interval of R and one of the other: 0 if they
/// overlap.
double distance(const Enclosure& a, const Enclosure& b);

struct TestMesh {
  std::string source;
  std::shared_ptr<const Mesh> mesh;  ///< scaled by a power of two so that coordinates are below 1
  std::shared_ptr<const ProjectedArea> objective;
  Enclosure best;

  const AreaVectors& vectors() const { return objective->vectors(); }
};

/// Throws what load_mesh() and area_vectors() throw.
TestMesh make_test_mesh(const std::string& source);
TestMesh make_test_mesh(Mesh mesh, std::string name);

/// The source of a built-in shape ("box?x=2") in a random pose.
std::string posed(const std::string& shape, Random& random);

/// Error of P/S where area vectors have been computed in double precision: the rounding of edges
/// and cross products over S. Large only for meshes of slivers. With `moved`, that of coordinates
/// rounded anew (after a rotation) as well: large for a mesh far from the origin.
double coordinate_rounding(const Mesh& mesh, double area, bool moved = false);

/// How far R can move if the area vectors change by eta S in total, eta < 1: at most 3 (1 +
/// sqrt(3)) eta / (1 - eta) (papers/closed-forms.md, "Stability"). Infinite from eta = 1 on.
double r_change_bound(double eta);

}  // namespace rectilin::paper::claims
