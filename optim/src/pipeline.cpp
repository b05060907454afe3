#include "pipeline.h"

namespace rectilin {

std::string Pipeline::name() const {
  std::string name;
  for (const auto& stage : stages_) name += (name.empty() ? "" : "+") + stage->name();
  return name;
}

Json Pipeline::parameters() const {
  Json all = Json::array();
  for (const auto& stage : stages_) all.push_back(stage->parameters());
  return all;
}

Capabilities Pipeline::capabilities() const {
  Capabilities all = stages_.front()->capabilities();
  for (const auto& stage : stages_) {
    const Capabilities one = stage->capabilities();
    all.deterministic &= one.deterministic;
    all.uses_chart |= one.uses_chart;
    all.uses_random |= one.uses_random;
    all.batches |= one.batches;
    all.needs_cuts |= one.needs_cuts;
    all.certifies |= one.certifies;
    all.local &= one.local;
  }
  return all;
}

void Pipeline::run(Evaluator& evaluator, const Chart& chart, Random& random) const {
  for (std::size_t i = 0; i < stages_.size() && !evaluator.exhausted(); ++i) {
    // A stage's random numbers do not depend on how many the stages before it drew.
    Random own = random.fork(i);
    stages_[i]->run(evaluator, chart, own);
  }
}

}  // namespace rectilin
