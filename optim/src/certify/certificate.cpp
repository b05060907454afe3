#include "rectilin/optim/certificate.h"

#include "rectilin/base/parameters.h"

namespace rectilin {
namespace {

Json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// One list for each axis: [[direction, weight, direction, weight, ...], ...].
Json to_json(const Certificate::Leaf& leaf) {
  Json axes = Json::array();
  for (const auto& terms : leaf.axes) {
    Json list = Json::array();
    for (const Certificate::Term& term : terms) {
      list.push_back(term.direction);
      list.push_back(term.weight);
    }
    axes.push_back(std::move(list));
  }
  return axes;
}

}  // namespace

Json to_json(const Certificate& certificate, const std::string& mesh) {
  Json rotation = Json::array(), directions = Json::array(), leaves = Json::array(), floors = Json::array(),
       form = Json::array();
  for (int k = 0; k < 3; ++k) rotation.push_back(to_json(certificate.rotation.axis(k)));
  for (const Eigen::Vector3d& u : certificate.directions) directions.push_back(to_json(u));
  for (const Certificate::Leaf& leaf : certificate.leaves) leaves.push_back(to_json(leaf));
  for (int i = 0; i < 3; ++i) form.push_back(to_json(Eigen::Vector3d(certificate.form.row(i).transpose())));
  for (const std::array<double, 3>& f : certificate.floors) floors.push_back({f[0], f[1], f[2]});
  return {{"format", "rectilin certificate"},
          {"version", 1},
          {"mesh", mesh},
          {"rotation", std::move(rotation)},
          {"value", certificate.value},
          {"lower", certificate.lower},
          {"tree", certificate.tree},
          {"directions", std::move(directions)},
          {"leaves", std::move(leaves)},
          {"floors", std::move(floors)},
          {"form", std::move(form)}};
}

}  // namespace rectilin
