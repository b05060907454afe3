#include "rectilin/optim/grid.h"

#include <algorithm>

namespace rectilin {
namespace {

struct Node {
  Eigen::Vector3d x;
  double value;
};

/// The best nodes seen, ascending in value; of equals the earlier stays ahead.
class BestNodes {
 public:
  explicit BestNodes(std::size_t capacity) : capacity_(capacity) {}

  void offer(const Node& node) {
    if (nodes_.size() == capacity_ && !(node.value < nodes_.back().value)) return;
    nodes_.insert(std::ranges::upper_bound(nodes_, node.value, {}, &Node::value), node);
    if (nodes_.size() > capacity_) nodes_.pop_back();
  }

  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  std::size_t capacity_;
  std::vector<Node> nodes_;
};

/// Evaluates n^3 nodes over the box [lower, upper], a plane of the first coordinate at a time.
void search_box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper, int n, const Domain& domain,
                Evaluator& evaluator, BestNodes& best) {
  const Eigen::Vector3d step = (upper - lower) / (n - 1);
  const std::size_t plane = static_cast<std::size_t>(n) * n;
  std::vector<Eigen::Vector3d> nodes(plane);
  std::vector<Rotation> rotations(plane);
  std::vector<double> values(plane);
  for (int i = 0; i < n && !evaluator.exhausted(); ++i) {
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const std::size_t at = static_cast<std::size_t>(j) * n + k;
        nodes[at] = lower + step.cwiseProduct(Eigen::Vector3d(i, j, k));
        rotations[at] = domain.rotation(nodes[at]);
      }
    evaluator.values(rotations, values);
    for (std::size_t at = 0; at < plane; ++at) best.offer({nodes[at], values[at]});
  }
}

}  // namespace

void GridOptions::bind(Parameters& table) {
  table.integer("points", points, 2, 2000, "nodes along each coordinate of the domain")
      .integer("levels", levels, 0, 100, "times the grid is refined")
      .integer("keep", keep, 1, 1000000, "best nodes refined at each level")
      .integer("refine", refine, 3, 1000, "nodes along each coordinate of a refined neighbourhood");
}

void GridSearch::run(Evaluator& evaluator, const Domain& domain, Random&) const {
  const Eigen::Vector3d lower = domain.lower(), upper = domain.upper();
  BestNodes best(options_.keep);
  search_box(lower, upper, options_.points, domain, evaluator, best);

  Eigen::Vector3d spacing = (upper - lower) / (options_.points - 1);
  for (int level = 0; level < options_.levels && !evaluator.exhausted(); ++level) {
    // A copy: the neighbourhoods of this level are those of the best nodes before it.
    for (const Node& node : std::vector<Node>(best.nodes()))
      search_box((node.x - spacing).cwiseMax(lower), (node.x + spacing).cwiseMin(upper), options_.refine, domain,
                 evaluator, best);
    spacing *= 2.0 / (options_.refine - 1);
  }
}

}  // namespace rectilin
