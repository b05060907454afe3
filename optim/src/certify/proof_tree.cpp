#include "certify/proof_tree.h"

namespace rectilin::certification {

std::uint32_t ProofTree::halve(std::uint32_t node, int axis) {
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {static_cast<char>('x' + axis), first};
  nodes_.resize(nodes_.size() + 2);
  return first;
}

void ProofTree::set_leaf(std::uint32_t node, const std::array<Cell::Bundle, 3>& bundles, const PerCut<double>& weight) {
  nodes_[node] = {'l', static_cast<std::uint32_t>(leaves_.size())};
  Certificate::Leaf& leaf = leaves_.emplace_back();
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < bundles[k].size; ++j)
      if (weight[k][j] > 0) leaf.axes[k].push_back({bundles[k].cuts[j], weight[k][j]});
}

void ProofTree::set_floor_leaf(std::uint32_t node, const std::array<double, 3>& floors) {
  nodes_[node] = {'h', static_cast<std::uint32_t>(floors_.size())};
  floors_.push_back(floors);
}

void ProofTree::add_cuts(const Rotation& rotation) {
  for (int k = 0; k < 3; ++k) directions_.push_back(rotation.axis(k));
}

Certificate ProofTree::certificate() const {
  Certificate result;
  result.form = form_;
  constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> place(directions_.size(), kUnused);
  std::vector<std::uint32_t> open = {0};
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    result.tree += node.kind;
    if (node.kind == 'l') {
      Certificate::Leaf& leaf = result.leaves.emplace_back(leaves_[node.next]);
      for (auto& terms : leaf.axes)
        for (Certificate::Term& term : terms) {
          std::uint32_t& at = place[term.direction];
          if (at == kUnused) {
            at = static_cast<std::uint32_t>(result.directions.size());
            result.directions.push_back(directions_[term.direction]);
          }
          term.direction = at;
        }
    } else if (node.kind == 'h') {
      result.floors.push_back(floors_[node.next]);
    } else if (node.kind != 'o') {
      open.push_back(node.next + 1);
      open.push_back(node.next);
    }
  }
  return result;
}

}  // namespace rectilin::certification
