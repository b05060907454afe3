#include "certify/generator_list.h"

#include <algorithm>

namespace rectilin::bounding {

GeneratorList::GeneratorList(const Generators& generators) {
  make_room(generators.size());
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const Eigen::Vector3d v = generators[i];
    x_[i] = v.x(), y_[i] = v.y(), z_[i] = v.z();
  }
  size_ = generators.size();
}

void GeneratorList::make_room(std::size_t size) {
  const std::size_t padded = (size + 2 * kLanes) / kLanes * kLanes;
  if (x_.size() >= padded) return;
  for (std::vector<double>* component : {&x_, &y_, &z_}) component->resize(padded, 0.0);
}

// The loops run over lanes so that compilers turn them into vector instructions without being allowed to reorder
// sums.

Eigen::Vector3d GeneratorList::cut(const Eigen::Vector3d& u) const {
  double sum[3][kLanes] = {};
  const double a = u[0], b = u[1], c = u[2];
  for (std::size_t i = 0; i < size_; i += kLanes) {
    const double *x = &x_[i], *y = &y_[i], *z = &z_[i];
    double sign[kLanes];
    for (std::size_t l = 0; l < kLanes; ++l) sign[l] = a * x[l] + b * y[l] + c * z[l] < 0 ? -1.0 : 1.0;
    for (std::size_t l = 0; l < kLanes; ++l) sum[0][l] += sign[l] * x[l];
    for (std::size_t l = 0; l < kLanes; ++l) sum[1][l] += sign[l] * y[l];
    for (std::size_t l = 0; l < kLanes; ++l) sum[2][l] += sign[l] * z[l];
  }
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    for (std::size_t l = 0; l < kLanes; ++l) total[k] += sum[k][l];
  return total;
}

Eigen::Vector3d GeneratorList::split(const Triangle3& corners, GeneratorList& active) const {
  active.make_room(size_);
  double *out_x = active.x_.data(), *out_y = active.y_.data(), *out_z = active.z_.data();
  std::size_t count = 0;
  double sum[3][kLanes] = {};
  const Eigen::Vector3d p = corners[0], q = corners[1], r = corners[2];
  for (std::size_t i = 0; i < size_; i += kLanes) {
    const double *x = &x_[i], *y = &y_[i], *z = &z_[i];
    double sign[kLanes];  // zero: active
    for (std::size_t l = 0; l < kLanes; ++l) {
      const double at_p = p[0] * x[l] + p[1] * y[l] + p[2] * z[l];
      const double at_q = q[0] * x[l] + q[1] * y[l] + q[2] * z[l];
      const double at_r = r[0] * x[l] + r[1] * y[l] + r[2] * z[l];
      const double least = std::min(at_p, std::min(at_q, at_r)), most = std::max(at_p, std::max(at_q, at_r));
      sign[l] = least >= 0 ? 1.0 : most <= 0 ? -1.0 : 0.0;
    }
    for (std::size_t l = 0; l < kLanes; ++l) sum[0][l] += sign[l] * x[l];
    for (std::size_t l = 0; l < kLanes; ++l) sum[1][l] += sign[l] * y[l];
    for (std::size_t l = 0; l < kLanes; ++l) sum[2][l] += sign[l] * z[l];
    for (std::size_t l = 0; l < kLanes; ++l) {  // written always, kept if active: no branch to mispredict
      out_x[count] = x[l], out_y[count] = y[l], out_z[count] = z[l];
      count += sign[l] == 0;
    }
  }
  active.size_ = count;
  for (std::size_t i = count; i < (count + kLanes - 1) / kLanes * kLanes; ++i) out_x[i] = out_y[i] = out_z[i] = 0;
  Eigen::Vector3d settled = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    for (std::size_t l = 0; l < kLanes; ++l) settled[k] += sum[k][l];
  return settled;
}

}  // namespace rectilin::bounding
