#include "core/pipeline.h"

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
  for (const auto& stage : stages_) all = together(all, stage->capabilities());
  return all;
}

void Pipeline::run(Evaluator& evaluator, const Domain& domain, Random& random) const {
  for (std::size_t i = 0; i < stages_.size() && !evaluator.exhausted(); ++i) {
    // The random numbers of a stage must not depend on how many the stages before it drew.
    Random own = random.fork(i);
    stages_[i]->run(evaluator, domain, own);
  }
}

}  // namespace rectilin
