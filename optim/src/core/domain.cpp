#include "rectilin/optim/domain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "rectilin/base/factory.h"

namespace rectilin {
namespace {

constexpr double kPi = std::numbers::pi;

/// Euler angles in [0, alpha_max] x [0, pi/2] x [0, pi/2].
class EulerDomain final : public Domain {
 public:
  EulerDomain(std::string_view name, double alpha_max, bool covers)
      : name_(name), upper_(alpha_max, kPi / 2, kPi / 2), covers_(covers) {}

  std::string_view name() const override { return name_; }
  Eigen::Vector3d lower() const override { return Eigen::Vector3d::Zero(); }
  Eigen::Vector3d upper() const override { return upper_; }
  bool covers() const override { return covers_; }

  Rotation rotation(const Eigen::Vector3d& x) const override { return rotation_from_euler(x[0], x[1], x[2]); }

  Eigen::Vector3d coordinates(const Rotation& rotation) const override {
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    double best_distance = std::numeric_limits<double>::infinity();
    for (const Rotation& d : frame_symmetries()) {
      const Eigen::Vector3d angles = euler_from_rotation(d * rotation);
      const Eigen::Vector3d inside = angles.cwiseMax(lower()).cwiseMin(upper_);
      const double distance = (angles - inside).norm();
      if (distance < best_distance) best_distance = distance, best = inside;
    }
    return best;
  }

 private:
  std::string_view name_;
  Eigen::Vector3d upper_;
  bool covers_;
};

class ZoneDomain final : public Domain {
 public:
  std::string_view name() const override { return "zone"; }
  Eigen::Vector3d lower() const override { return Eigen::Vector3d::Constant(-kZoneHalfEdge); }
  Eigen::Vector3d upper() const override { return Eigen::Vector3d::Constant(kZoneHalfEdge); }
  bool covers() const override { return true; }

  Rotation rotation(const Eigen::Vector3d& x) const override { return rotation_from_rodrigues(x); }

  Eigen::Vector3d coordinates(const Rotation& rotation) const override {
    const Eigen::Quaterniond q = reduce_to_zone(rotation).quaternion();
    return (q.vec() / q.w()).cwiseMax(lower()).cwiseMin(upper());
  }
};

}  // namespace

const Domain& paper_domain() {
  static const EulerDomain domain("paper", kPi / 2, false);
  return domain;
}

const Domain& covering_domain() {
  static const EulerDomain domain("covering", kPi, true);
  return domain;
}

const Domain& zone_domain() {
  static const ZoneDomain domain;
  return domain;
}

const Domain& domain_by_name(std::string_view name) {
  std::vector<std::string> known;
  for (const Domain* domain : {&paper_domain(), &covering_domain(), &zone_domain()}) {
    if (domain->name() == name) return *domain;
    known.emplace_back(domain->name());
  }
  throw_unknown_name("domain", name, known);
}

}  // namespace rectilin
