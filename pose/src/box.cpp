// The box of least volume round a mesh.
//
// O'Rourke (1985) finds it exactly in cubic time. Here each of many frames is improved by turning it about its own axes
// in turn until that gains nothing, each time to the exact best: the rectangle of least area round the projection, one
// of whose sides lies along an edge of the projection's outline (Freeman and Shapira 1975). Chang, Gorissen and
// Melchior (2011) found that such descents from few starts nearly always end at the optimum.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "frames.h"
#include "methods.h"
#include "rectilin/pose/convex_hull.h"
#include "roundness_of.h"
#include "working_frame.h"

namespace rectilin::pose {
namespace {

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
  const Vector3 turn = std::atan2(side.y(), side.x()) * Vector3::Unit(k);
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

}  // namespace

Pose box_pose(const Surface& given, const BoxOptions& options) {
  const Rotation work = working_frame(given);
  const Surface surface = turned(given, work);
  const Mesh hull = convex_hull(surface.mesh);
  std::vector<std::pair<std::string, Box>> found;
  const auto offer = [&](std::string name, const Rotation& start) {
    found.emplace_back(std::move(name), descend(hull.vertices, start));
  };
  // The sides of the best box often lie on large faces of the hull.
  std::vector<std::pair<double, Vector3>> faces;
  for (const Triangle& t : hull.triangles) {
    const Vector3 n = (hull.vertices[t[1]] - hull.vertices[t[0]]).cross(hull.vertices[t[2]] - hull.vertices[t[0]]);
    if (n.norm() > 0) faces.emplace_back(n.norm(), n.normalized());
  }
  std::ranges::stable_sort(faces, std::greater(), &std::pair<double, Vector3>::first);
  offer("principal axes", Rotation());
  for (std::size_t i = 0; i < std::min<std::size_t>(faces.size(), 64); ++i)
    offer("face of the hull", frame_about(faces[i].second));
  Random random(1);
  for (int i = 0; i < options.starts; ++i) offer("search", random_rotation(random));

  Pose pose;
  const double unit = std::pow(surface.area, 1.5);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [name, box] : found) least = std::min(least, box.volume);
  std::ranges::stable_sort(found, {}, [](const auto& f) { return f.second.volume; });
  for (const auto& [name, box] : found) {
    const Rotation rotation = box.rotation * work;
    if (std::ranges::any_of(pose.candidates, [&](const auto& c) { return frame_angle(c.rotation, rotation) < 1e-3; }))
      continue;
    if (box.volume > least * 1.2 + 1e-12) break;
    PoseCandidate candidate;
    candidate.name = name;
    candidate.rotation = rotation;
    candidate.volume = candidate.score = box.volume / unit;
    pose.candidates.push_back(std::move(candidate));
  }
  choose(pose, 0);
  pose.reason = "least volume of " + std::to_string(found.size()) + " descents";
  const double best = *pose.candidates.front().volume;
  for (const PoseCandidate& other : pose.candidates)
    if (&other != &pose.candidates.front() && *other.volume <= best * (1 + 1e-6))
      pose.uniqueness = Uniqueness::kSeveral, pose.alternatives.push_back(other.rotation);
  note_roundness(pose, given, convex_hull(given.mesh));
  return pose;
}

}  // namespace rectilin::pose
