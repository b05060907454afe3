#include "claims/search_domain.h"

#include <algorithm>
#include <cmath>

#include "claims/paper_box.h"
#include "rectilin/mesh/source.h"

namespace rectilin::paper::claims {

namespace {

/// What the box loses for an objective whose least value is enclosed by `best`.
Finding loss_on_paper_box(const ProjectedArea& objective, const Enclosure& best) {
  Finding finding{.margin = 0, .rotation = best.rotation};
  // Where the box holds the best frame of all there is nothing to search.
  if (in_paper_box(best.rotation)) return finding;
  // This search is a plain one. On large meshes, whose bounds cost more, it may end early with an
  // upper bound that proves less of a loss, or none.
  const auto cells = static_cast<int>(std::clamp(2e9 / static_cast<double>(objective.vectors().size()), 2e3, 2e5));
  const Enclosure on_box = enclose_on_paper_box(objective, 1e-6, cells);
  finding.margin = std::min(on_box.greatest_r() - best.least_r(), 0.0);
  finding.note = "R = " + std::to_string(best.least_r()) + ", on the box from " + std::to_string(on_box.least_r()) +
                 " to " + std::to_string(on_box.greatest_r());
  return finding;
}

}  // namespace

Finding check_paper_box(const TestMesh& tested) {
  Finding finding = loss_on_paper_box(*tested.objective, tested.best);
  finding.where = tested.source;
  return finding;
}

Finding check_paper_box_in_another_pose(const TestMesh& tested, Random random) {
  const Rotation pose = random_rotation(random);
  const ProjectedArea posed(rotated(tested.vectors(), pose));
  Enclosure best = tested.best;
  best.rotation = best.rotation * pose.inverse();
  Finding finding = loss_on_paper_box(posed, best);
  finding.where = tested.source + ", turned";
  auto mesh = std::make_shared<Mesh>(*tested.mesh);
  for (Vector3& p : mesh->vertices) p = pose.matrix() * p;
  finding.mesh = std::move(mesh);
  return finding;
}

std::vector<Finding> check_cubes_on_paper_box(Random random) {
  std::vector<Finding> findings;
  for (int i = 0; i < 400; ++i) findings.push_back(check_paper_box(make_test_mesh(posed("box", random))));
  return findings;
}

std::vector<Finding> check_three_quarters(Random random) {
  constexpr int kFrames = 100'000;
  int inside = 0;
  for (int i = 0; i < kFrames; ++i) inside += in_paper_box(random_rotation(random));
  const double share = static_cast<double>(inside) / kFrames;
  return {{-std::abs(share - 0.75), "random frames", nullptr, {}, "share " + std::to_string(share)}};
}

Finding check_domain_on_mesh(const TestMesh& tested, Random random, const Domain& domain) {
  Finding finding{.where = tested.source};
  for (int i = 0; i < 8; ++i) {
    const Rotation wanted = i == 0 ? tested.best.rotation : random_rotation(random);
    const Rotation reached = domain.rotation(domain.coordinates(wanted));
    const double margin = -std::abs(tested.objective->value(reached) - tested.objective->value(wanted));
    if (margin < finding.margin) finding.margin = margin, finding.rotation = wanted;
  }
  return finding;
}

Finding check_chart(Random random, const Domain& domain) {
  Finding finding{.where = "random frames"};
  for (int i = 0; i < 10'000; ++i) {
    const Rotation wanted = random_rotation(random);
    const double margin = -frame_angle(wanted, domain.rotation(domain.coordinates(wanted)));
    if (margin < finding.margin) finding.margin = margin, finding.rotation = wanted;
  }
  return finding;
}

}  // namespace rectilin::paper::claims
