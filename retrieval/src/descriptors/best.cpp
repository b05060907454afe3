#include "descriptors/best.h"

#include "rectilin/retrieval/best.h"

namespace rectilin::retrieval {
namespace {

struct BestOptions {
  void bind(Parameters&) {}
};

}  // namespace

const std::string& best_descriptor() {
  static const std::string text = "views+0.85*words+0.25*extents";
  return text;
}

void add_best(DescriptorFactory& factory) {
  factory.add("best", "the most discriminating sum of those: " + best_descriptor(), BestOptions(),
              [](BestOptions) { return make_descriptor(best_descriptor()); });
}

}  // namespace rectilin::retrieval
