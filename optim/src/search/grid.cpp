// Exhaustive search (paper, section 4.3, note 3), refined where the values are best.
#include <algorithm>

#include "rectilin/optim/registry.h"

namespace rectilin {
namespace {

/// First `points`^3 nodes spread over the domain's box, ends included. Then, `levels` times, a grid of `refine`^3 nodes
/// over the neighbourhood (one spacing to each side) of each of the `keep` best nodes so far. The defaults use the
/// 10,000 evaluations of the genetic algorithm. The third coordinate runs fastest: on the Euler domains all nodes of
/// such a line have the same third axis, and the objective computes its h only once.
struct GridOptions {
  int points = 20;
  int levels = 2;
  int keep = 8;
  int refine = 5;

  void bind(Parameters& table);
};

struct Node {
  Eigen::Vector3d x;
  double value;
};

/// The best nodes so far in ascending order of their values; among equals the earlier one comes first.
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

/// Evaluates n^3 nodes over the box [lower, upper], one plane of the first coordinate at a time.
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

void GridOptions::bind(Parameters& table) {
  table.integer("points", points, 2, 2000, "nodes along each coordinate of the domain")
      .integer("levels", levels, 0, 100, "how often the grid is refined")
      .integer("keep", keep, 1, 1000000, "number of best nodes that are refined at each level")
      .integer("refine", refine, 3, 1000, "nodes along each coordinate of a refined neighbourhood");
}

void search_grid(const GridOptions& options, Evaluator& evaluator, const Domain& domain, Random&) {
  const Eigen::Vector3d lower = domain.lower(), upper = domain.upper();
  BestNodes best(options.keep);
  search_box(lower, upper, options.points, domain, evaluator, best);

  Eigen::Vector3d spacing = (upper - lower) / (options.points - 1);
  for (int level = 0; level < options.levels && !evaluator.exhausted(); ++level) {
    // A copy: the neighbourhoods of this level are those of the best nodes before it.
    for (const Node& node : std::vector<Node>(best.nodes()))
      search_box((node.x - spacing).cwiseMax(lower), (node.x + spacing).cwiseMin(upper), options.refine, domain,
                 evaluator, best);
    spacing *= 2.0 / (options.refine - 1);
  }
}

}  // namespace

void add_grid(Registry& registry) {
  registry.add(
      GlobalMethod<GridOptions>{.name = "grid",
                                .help = "exhaustive search of a domain's box, then finer grids around the best points",
                                .capabilities = {.uses_random = false, .batches = true},
                                .run = search_grid});
}

}  // namespace rectilin
