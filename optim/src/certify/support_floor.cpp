#include "certify/support_floor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "rectilin/base/symmetric.h"

namespace rectilin::certification {
namespace {

constexpr double kLeastRadius = 0.01;              // radians; on smaller sweeps cuts alone are good enough
constexpr int kFirstLevel = 3;                     // first level whose triangles are bounded: edges of 0.2 radians
constexpr int kFinestLevel = 20;                   // edges of 1e-6 radians
constexpr double kStartEdge = 2, kEndEdge = 0.03;  // edges of the triangles that cover a sweep, in its radii
constexpr int kMostDivisions = 400;                // of triangles, for one box
constexpr std::size_t kMostBlocks = 1'000'000;
constexpr double kRounding = 0x1p-44;  // of everything but the sums over generators, relative to S
constexpr double kMostBytes = 1e8;     // for lists of generators

double edge_of(int level) { return std::numbers::pi / 2 / (1 << level); }

int level_of_edge(double edge) {
  int level = kFirstLevel;
  while (level < kFinestLevel && edge_of(level) > edge) ++level;
  return level;
}

/// The part of second degree of h in spherical harmonics, |t| = 1/2 + 5/8 P_2(t) + ..., plus just enough of the unit
/// matrix to make it positive. Zero where h varies too much for least_on().
Eigen::Matrix3d quadratic_part(const Eigen::Matrix3d& second, double total) {
  const Eigen::Matrix3d part = 15.0 / 16 * second;
  const Eigen::Vector3d values = symmetric_eigen(part).values;
  if (values[2] - values[0] > 0.15 * total) return Eigen::Matrix3d::Zero();
  const Eigen::Matrix3d form = part - values[0] * Eigen::Matrix3d::Identity();
  return 0.5 * (form + form.transpose());
}

/// Publishes an object that several threads may have made at once: all get the object of the first thread. Also says
/// whether that was this one.
template <class T>
std::pair<T*, bool> install(std::atomic<T*>& place, std::unique_ptr<T> made) {
  T* before = nullptr;
  if (place.compare_exchange_strong(before, made.get())) return {made.release(), true};
  return {before, false};
}

}  // namespace

/// A triangle of the subdivision.
struct SupportFloor::Node {
  /// The generators whose great circles may meet the triangle, and the signed sum of all others.
  struct Faces {
    GeneratorList list;
    Eigen::Vector3d settled = Eigen::Vector3d::Zero();
  };

  Triangle3 corners;
  int level = 0;
  const Node* above = nullptr;
  Eigen::Vector3d centre;
  double value = std::numeric_limits<double>::infinity();  // h less the quadratic form, at the centre
  mutable double bound = -1e9;                             // lower bound of h less the form on the triangle
  mutable std::atomic<Block*> parts = nullptr;
  mutable std::atomic<Faces*> faces = nullptr;

  ~Node() {
    delete parts.load();
    delete faces.load();
  }
};

SupportFloor::SupportFloor(const Generators& generators, double margin, std::function<bool()> stop)
    : stop_(std::move(stop)) {
  double total = 0;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const Eigen::Vector3d v = generators[i];
    if (!(v.norm() > 0)) continue;
    total += v.norm();
    second += v * v.transpose() / v.norm();
  }
  form_ = quadratic_part(second, total);
  // A sum of K terms, in whatever order, errs by at most K roundoffs times the sum of the lengths.
  rounding_ = total * (static_cast<double>(generators.size()) * 0x1p-52 + kRounding) + margin;
  // A triangle with edges e meets a fraction of 3 e / 2 pi of all great circles.
  kept_levels_ = std::clamp(std::ilogb(kMostBytes / (3 * 24 * static_cast<double>(generators.size())) + 1), 0, 5);

  const GeneratorList all(generators);
  octants_ = std::make_unique<Block>();
  for (std::size_t i = 0; i < 4; ++i) {
    Node& octant = (*octants_)[i];
    octant.corners = upper_octants()[i];
    auto faces = std::make_unique<Node::Faces>();
    faces->settled = all.split(octant.corners, faces->list);
    octant.faces = faces.release();
  }
}

SupportFloor::~SupportFloor() = default;

/// A list that holds all generators whose great circles meet the triangle, and the signed sum of the others: the
/// triangle's own list or, below the levels that keep lists, that of a larger triangle.
const GeneratorList& SupportFloor::faces_over(const Node& node, Eigen::Vector3d& settled) const {
  if (node.level > kept_levels_) return faces_over(*node.above, settled);
  Node::Faces* faces = node.faces.load();
  if (!faces) {
    auto made = std::make_unique<Node::Faces>();
    Eigen::Vector3d above;
    const GeneratorList& list = faces_over(*node.above, above);
    thread_local GeneratorList own;
    made->settled = above + list.split(node.corners, own);
    made->list = own.compact();
    faces = install(node.faces, std::move(made)).first;
  }
  settled = faces->settled;
  return faces->list;
}

/// The four parts of a triangle, which is divided if it was not. Null if no more divisions are allowed.
const SupportFloor::Block* SupportFloor::parts_of(const Node& node) const {
  if (const Block* known = node.parts.load()) return known;
  if (full_ || node.level == kFinestLevel || stop_()) return nullptr;
  auto made = std::make_unique<Block>();
  const std::array<Triangle3, 4> corners = quarters(node.corners);
  for (std::size_t i = 0; i < 4; ++i) {
    Node& part = (*made)[i];
    part.corners = corners[i];
    part.level = node.level + 1;
    part.above = &node;
    part.centre = centre_of(corners[i]);
    part.bound = node.bound;
  }
  if (node.level + 1 >= kFirstLevel) {
    thread_local GeneratorList own;
    Eigen::Vector3d settled;
    const GeneratorList* faces = &faces_over(node, settled);
    if (node.level > kept_levels_) {
      settled += faces->split(node.corners, own);
      faces = &own;
    }
    for (Node& part : *made) {
      const Eigen::Vector3d gradient = settled + faces->cut(part.centre);  // a cut is nowhere above h
      part.value = gradient.dot(part.centre) - part.centre.dot(form_ * part.centre);
      part.bound = std::max(node.bound, least_on(part.corners, gradient, form_) - rounding_);
    }
  }
  const auto [parts, mine] = install(node.parts, std::move(made));
  if (mine) blocks_.push_back(&node);
  return parts;
}

void SupportFloor::update() {
  for (; known_ < blocks_.size(); ++known_)
    for (const Node* node = blocks_[known_]; node; node = node->above) {
      double least = std::numeric_limits<double>::infinity();
      for (const Node& part : *node->parts.load()) least = std::min(least, part.bound);
      if (least <= node->bound) break;
      node->bound = least;
    }
  full_ = blocks_.size() > kMostBlocks;
}

/// The triangles that cover a sweep, ordered by bound, least first.
class SupportFloor::Front {
 public:
  void start(const SupportFloor& floor, const Sweep& sweep) {
    sweep_ = &sweep;
    entries_.clear();
    value_ = std::numeric_limits<double>::infinity();
    begin_ = level_of_edge(kStartEdge * sweep.radius());
    end_ = level_of_edge(kEndEdge * sweep.radius());
    for (const Node& octant : *floor.octants_)
      for (const double mirror : {1.0, -1.0}) {  // h is even: the mirror image counts as well
        const Triangle3& p = octant.corners;
        if (sweep.may_meet(sweep.place(p[0]), sweep.place(p[1]), sweep.place(p[2]), mirror)) add(floor, octant, mirror);
      }
  }

  double bound() const { return entries_.front().bound; }
  int level() const { return entries_.front().node->level; }
  double value() const { return value_; }

  /// Divides the triangle with the least bound; false if that is not possible.
  bool divide(const SupportFloor& floor) {
    const Entry entry = entries_.front();
    if (entry.node->level >= end_) return false;
    const Block* parts = floor.parts_of(*entry.node);
    if (!parts) return false;
    std::ranges::pop_heap(entries_, std::ranges::greater(), &Entry::bound);
    entries_.pop_back();
    for_each_meeting(*parts, entry.mirror, [&](const Node& part) { push(part, entry.mirror); });
    return !entries_.empty();
  }

 private:
  struct Entry {
    double bound;
    const Node* node;
    double mirror;
  };

  /// The parts, among the four, that may meet the sweep. The parts share corners, see quarters().
  template <class F>
  void for_each_meeting(const Block& parts, double mirror, const F& f) const {
    const auto place = [&](int part, int corner) { return sweep_->place(parts[part].corners[corner]); };
    const Sweep::Place a = place(0, 0), b = place(0, 1), c = place(0, 2), p = place(1, 0), q = place(2, 1),
                       r = place(3, 2);
    if (sweep_->may_meet(a, b, c, mirror)) f(parts[0]);
    if (sweep_->may_meet(p, c, b, mirror)) f(parts[1]);
    if (sweep_->may_meet(c, q, a, mirror)) f(parts[2]);
    if (sweep_->may_meet(b, a, r, mirror)) f(parts[3]);
  }

  void push(const Node& node, double mirror) {
    if (node.value < value_ && sweep_->holds(mirror * node.centre)) value_ = node.value;
    entries_.push_back({node.bound, &node, mirror});
    std::ranges::push_heap(entries_, std::ranges::greater(), &Entry::bound);
  }

  void add(const SupportFloor& floor, const Node& node, double mirror) {
    const Block* parts = node.level < begin_ ? floor.parts_of(node) : nullptr;
    if (!parts) return push(node, mirror);
    for_each_meeting(*parts, mirror, [&](const Node& part) { add(floor, part, mirror); });
  }

  const Sweep* sweep_ = nullptr;
  std::vector<Entry> entries_;
  double value_ = 0;  // least value at the centres that are in the sweep
  int begin_ = 0, end_ = 0;
};

std::optional<std::array<double, 3>> SupportFloor::prove(const std::array<Sweep, 3>& sweeps, double enough) const {
  enough -= form_.trace();
  const double radius = std::max({sweeps[0].radius(), sweeps[1].radius(), sweeps[2].radius()});
  if (!std::isfinite(radius) || radius < kLeastRadius) return std::nullopt;
  thread_local std::array<Front, 3> fronts;
  for (int k = 0; k < 3; ++k) fronts[k].start(*this, sweeps[k]);
  for (int division = 0; division < kMostDivisions; ++division) {
    if (fronts[0].bound() + fronts[1].bound() + fronts[2].bound() >= enough)
      return std::array<double, 3>{fronts[0].bound(), fronts[1].bound(), fronts[2].bound()};
    if (fronts[0].value() + fronts[1].value() + fronts[2].value() < enough) return std::nullopt;
    Front& coarsest = *std::ranges::min_element(fronts, {}, &Front::level);
    if (!coarsest.divide(*this)) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace rectilin::certification
