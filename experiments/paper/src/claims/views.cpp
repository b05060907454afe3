#include "claims/views.h"

#include <cmath>
#include <set>

#include "rectilin/render/view_sphere.h"
#include "tables/table_1.h"

namespace rectilin::paper::claims {
namespace {

constexpr double kGsmdViews = 66, kLfdViews = 100;

}  // namespace

std::vector<Finding> check_table_1(Random) {
  std::set<tables::Permutation> ours;
  const render::ViewSphere octahedron(0);
  for (const auto& p : octahedron.permutations()) {
    tables::Permutation own{};
    for (std::size_t k = 0; k < 6; ++k) own[k] = static_cast<int>(p[k]);
    ours.insert(own);
  }
  const std::set<tables::Permutation> printed(tables::kTable1.begin(), tables::kTable1.end());
  int missing = 0;
  for (const auto& p : printed) missing += !ours.contains(p);
  const int repeated = 24 - static_cast<int>(printed.size());
  return {{static_cast<double>(-missing - repeated),
           "Table 1",
           nullptr,
           {},
           std::to_string(printed.size()) + " different, " + std::to_string(missing) + " no rotation"}};
}

std::vector<Finding> check_sphere_sizes(Random) {
  std::vector<Finding> findings;
  double vertices = 6, faces = 8;
  for (int level = 0; level <= 4; ++level) {
    const render::ViewSphere sphere(level);
    findings.push_back({-std::abs(static_cast<double>(sphere.size()) - vertices),
                        "level " + std::to_string(level),
                        nullptr,
                        {},
                        std::to_string(sphere.size()) + " views"});
    vertices += faces * 3 / 2;
    faces *= 4;
  }
  return findings;
}

std::vector<Finding> check_permutations(Random) {
  std::vector<Finding> findings;
  for (int level = 0; level <= 3; ++level) {
    const render::ViewSphere sphere(level);
    double worst = 0;
    for (std::size_t i = 0; i < 24; ++i)
      for (std::size_t k = 0; k < sphere.size(); ++k) {
        const Vector3 there = frame_symmetries()[i].matrix() * sphere.directions()[sphere.permutations()[i][k]];
        worst = std::max(worst, (there - sphere.directions()[k]).norm());
      }
    findings.push_back({-worst, "level " + std::to_string(level), nullptr, {}, ""});
  }
  return findings;
}

std::vector<Finding> check_storage(Random) {
  const double less = 1 - kGsmdViews / kLfdViews;
  return {{-std::abs(less - 0.44),
           "66 views against 100, 47 numbers each",
           nullptr,
           {},
           "it is " + std::to_string(100 * less) + " % less"}};
}

std::vector<Finding> check_view_pairs(Random) {
  const double lfd = 60.0 * 10 * 10 * 2 * 10, gsmd = 24 * kGsmdViews;
  return {{0.1 - std::abs(lfd / gsmd / 70 - 1),
           "60 x 10 x 10 x 20 pairs against 24 x 66",
           nullptr,
           {},
           std::to_string(lfd / gsmd) + " times as many"}};
}

}  // namespace rectilin::paper::claims
