#include "certify/generator_list.h"

#include <algorithm>

namespace rectilin::certification {
namespace {

std::size_t rounded_up(std::size_t size) { return (size + kGeneratorLanes - 1) / kGeneratorLanes * kGeneratorLanes; }

}  // namespace

GeneratorList::GeneratorList(const Generators& generators) {
  make_room(generators.size());
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const Eigen::Vector3d v = generators[i];
    x_[i] = v.x(), y_[i] = v.y(), z_[i] = v.z();
  }
  size_ = generators.size();
}

GeneratorSpan GeneratorList::span() const { return {x_.data(), y_.data(), z_.data(), rounded_up(size_)}; }

void GeneratorList::make_room(std::size_t size) {
  const std::size_t padded = rounded_up(size) + kGeneratorLanes;
  if (x_.size() >= padded) return;
  for (std::vector<double>* component : {&x_, &y_, &z_}) component->resize(padded, 0.0);
}

Eigen::Vector3d GeneratorList::cut(const Eigen::Vector3d& u) const { return signed_sum(span(), u); }

Eigen::Vector3d GeneratorList::split(const Triangle3& corners, GeneratorList& active) const {
  active.make_room(size_);
  Eigen::Vector3d settled = Eigen::Vector3d::Zero();
  active.size_ = copy_unsettled(span(), corners, {active.x_.data(), active.y_.data(), active.z_.data()}, settled);
  for (std::vector<double>* component : {&active.x_, &active.y_, &active.z_})
    std::fill_n(component->data() + active.size_, rounded_up(active.size_) - active.size_, 0.0);
  return settled;
}

GeneratorList GeneratorList::compact() const {
  GeneratorList copy;
  const auto end = static_cast<std::ptrdiff_t>(rounded_up(size_));
  copy.x_.assign(x_.begin(), x_.begin() + end);
  copy.y_.assign(y_.begin(), y_.begin() + end);
  copy.z_.assign(z_.begin(), z_.begin() + end);
  copy.size_ = size_;
  return copy;
}

}  // namespace rectilin::certification
