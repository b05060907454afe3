// The box of least volume round a mesh.
//
// O'Rourke (1985) finds it exactly in cubic time. Here one axis of the box is searched, over the hemisphere, and the
// two others are exact for it: they are the sides of the rectangle of least area round the projection, one of which
// lies along an edge of the projection's outline (Freeman and Shapira 1975). The best directions of a scan, and the
// normals of the hull's largest faces, on which boxes often lie, are moved to a minimum by pattern search; then the box
// is turned about its axes in turn, each time to the exact best, as Chang, Gorissen and Melchior (2011) end theirs.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "frames.h"
#include "methods.h"
#include "rectilin/pose/convex_hull.h"
#include "roundness_of.h"

namespace rectilin::pose {
namespace {

constexpr std::size_t kFaces = 64;    // of the hull, that are tried as sides
constexpr std::size_t kRefined = 10;  // boxes that are moved to a minimum
constexpr int kTilts = 6;             // directions of a step

struct Box {
  Rotation rotation;
  double volume = std::numeric_limits<double>::infinity();
};

using Point = Eigen::Vector2d;

double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners of the convex outline, counterclockwise (Andrew's monotone chain, 1979).
std::vector<Point> outline(std::vector<Point> points) {
  std::ranges::sort(points,
                    [](const Point& a, const Point& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Point> chain;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = chain.size();
    for (const Point& p : points) {
      while (chain.size() >= first + 2 &&
             cross(chain.back() - chain[chain.size() - 2], p - chain[chain.size() - 2]) <= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::ranges::reverse(points);
  }
  return chain;
}

/// The direction of a side of the rectangle of least area round a convex polygon, by rotating calipers; and that area.
std::pair<Point, double> least_rectangle(const std::vector<Point>& polygon) {
  const std::size_t n = polygon.size();
  std::pair<Point, double> best{Point(1, 0), std::numeric_limits<double>::infinity()};
  std::size_t right = 0, top = 0, left = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point edge = polygon[(i + 1) % n] - polygon[i];
    if (!(edge.squaredNorm() > 0)) continue;
    const Point along = edge.normalized(), up(-along.y(), along.x());
    const auto climb = [&](std::size_t& at, const Point& direction) {
      for (std::size_t steps = 0; steps < n; ++steps) {
        const std::size_t next = (at + 1) % n;
        if ((polygon[next] - polygon[at]).dot(direction) < 0) break;
        at = next;
      }
    };
    if (i == 0) right = 0;
    climb(right, along);
    if (i == 0) top = right;
    climb(top, up);
    if (i == 0) left = top;
    climb(left, -along);
    const double area = (polygon[right] - polygon[left]).dot(along) * (polygon[top] - polygon[i]).dot(up);
    if (area < best.second) best = {along, area};
  }
  return best;
}

double extent(const std::vector<Vector3>& points, const Vector3& direction) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const Vector3& p : points) {
    lower = std::min(lower, p.dot(direction));
    upper = std::max(upper, p.dot(direction));
  }
  return upper - lower;
}

/// The best turn of the frame about its axis k.
Box turned_best(const std::vector<Vector3>& points, const Rotation& frame, int k) {
  const Vector3 x = frame.axis((k + 1) % 3), y = frame.axis((k + 2) % 3);
  std::vector<Point> flat;
  for (const Vector3& p : points) flat.emplace_back(p.dot(x), p.dot(y));
  const auto [side, area] = least_rectangle(outline(std::move(flat)));
  // Rows are axes: that of x becomes the side, cos x + sin y, if the matrix on the left turns the other way.
  const Vector3 turn = -std::atan2(side.y(), side.x()) * Vector3::Unit(k);
  const Rotation rotation = Rotation::from_quaternion((rotation_from_vector(turn) * frame).quaternion());
  return {rotation, area * extent(points, frame.axis(k))};
}

Box descend(const std::vector<Vector3>& points, Rotation start) {
  Box best{start};
  for (int since = 0, k = 0; since < 3; k = (k + 1) % 3) {
    const Box found = turned_best(points, best.rotation, k);
    const bool better = found.volume < best.volume * (1 - 1e-9) || !std::isfinite(best.volume);
    since = better ? 0 : since + 1;
    if (better) best = found;
  }
  return best;
}

/// The best box that has this axis.
Box box_along(const std::vector<Vector3>& points, const Vector3& axis) {
  return turned_best(points, frame_about(axis), 2);
}

/// Tilts the axis until no small step makes the box smaller.
Box refined(const std::vector<Vector3>& points, Box best) {
  for (double step = 0.04; step > 1e-7;) {
    const Box start = best;
    for (int i = 0; i < kTilts; ++i) {
      const double turn = i * 2 * std::numbers::pi / kTilts;
      const Vector3 axis = (start.rotation.axis(2) +
                            step * (std::cos(turn) * start.rotation.axis(0) + std::sin(turn) * start.rotation.axis(1)))
                               .normalized();
      if (const Box found = box_along(points, axis); found.volume < best.volume) best = found;
    }
    if (!(best.volume < start.volume * (1 - 1e-12))) step /= 2;
  }
  return descend(points, best.rotation);
}

/// The normals of the largest faces, no two nearly alike.
std::vector<Vector3> large_faces(const Mesh& hull, std::size_t count) {
  std::vector<std::pair<double, Vector3>> faces;
  for (const Triangle& t : hull.triangles) {
    const Vector3 n = (hull.vertices[t[1]] - hull.vertices[t[0]]).cross(hull.vertices[t[2]] - hull.vertices[t[0]]);
    if (n.norm() > 0) faces.emplace_back(n.norm(), n.normalized());
  }
  std::ranges::stable_sort(faces, std::greater(), &std::pair<double, Vector3>::first);
  std::vector<Vector3> normals;
  for (const auto& [area, normal] : faces) {
    if (normals.size() == count) break;
    const auto alike = [&n = normal](const Vector3& other) { return std::abs(other.dot(n)) > 1 - 1e-6; };
    if (std::ranges::none_of(normals, alike)) normals.push_back(normal);
  }
  return normals;
}

}  // namespace

Pose box_pose(const Surface& surface, const BoxOptions& options) {
  const Mesh hull = convex_hull(surface.mesh);
  std::vector<std::pair<std::string, Box>> scanned;
  for (const Vector3& normal : large_faces(hull, kFaces))
    scanned.emplace_back("face of the hull", box_along(hull.vertices, normal));
  for (int k = 0; k < 3; ++k) scanned.emplace_back("principal axis", box_along(hull.vertices, Vector3::Unit(k)));
  for (int i = 0; i < options.directions; ++i)
    scanned.emplace_back("search", box_along(hull.vertices, hemisphere_point(i, options.directions)));
  std::ranges::stable_sort(scanned, {}, [](const auto& s) { return s.second.volume; });
  if (scanned.size() > kRefined) scanned.resize(kRefined);
  for (auto& [name, box] : scanned) box = refined(hull.vertices, box);
  std::ranges::stable_sort(scanned, {}, [](const auto& s) { return s.second.volume; });

  Pose pose;
  const double unit = std::pow(surface.area, 1.5), best = scanned.front().second.volume;
  for (const auto& [name, box] : scanned) {
    const auto same = [&r = box.rotation](const PoseCandidate& c) { return frame_angle(c.rotation, r) < 1e-3; };
    if (std::ranges::any_of(pose.candidates, same)) continue;
    PoseCandidate candidate;
    candidate.name = name;
    candidate.rotation = box.rotation;
    candidate.volume = candidate.score = box.volume / unit;
    if (!pose.candidates.empty() && box.volume <= best * (1 + 1e-6)) {
      pose.uniqueness = Uniqueness::kSeveral;
      pose.alternatives.push_back(box.rotation);
    }
    pose.candidates.push_back(std::move(candidate));
  }
  choose(pose, 0);
  pose.reason = "least volume of " + std::to_string(scanned.size()) + " local minima";
  note_roundness(pose, surface, hull);
  return pose;
}

}  // namespace rectilin::pose
