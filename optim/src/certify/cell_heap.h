// The cells that are open.
#pragma once

#include <algorithm>
#include <vector>

#include "certify/cell.h"

namespace rectilin::certification {

/// A priority queue, least bound first. The heap holds handles: cells are large, and stay where they are.
class CellHeap {
 public:
  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }

  double least_bound() const { return heap_.empty() ? std::numeric_limits<double>::infinity() : heap_.front().bound; }

  void push(const Cell& cell) {
    std::uint32_t at = static_cast<std::uint32_t>(cells_.size());
    if (free_.empty()) {
      cells_.push_back(cell);
    } else {
      at = free_.back();
      free_.pop_back();
      cells_[at] = cell;
    }
    heap_.push_back({cell.bound, at});
    std::ranges::push_heap(heap_, std::ranges::greater(), &Entry::bound);
  }

  Cell pop() {
    std::ranges::pop_heap(heap_, std::ranges::greater(), &Entry::bound);
    const std::uint32_t at = heap_.back().at;
    heap_.pop_back();
    free_.push_back(at);
    return cells_[at];
  }

 private:
  struct Entry {
    double bound;
    std::uint32_t at;
  };
  std::vector<Entry> heap_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> free_;
};

}  // namespace rectilin::certification
