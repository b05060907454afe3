#include "search_domain.h"

#include <algorithm>
#include <cmath>

#include "paper_box.h"
#include "rectilin/measure/source.h"

namespace rectilin::claims_detail {

std::optional<Finding> check_paper_box(const Specimen& specimen, Random) {
  Finding finding{0, specimen.source, nullptr, specimen.best.rotation, {}};
  // Where the box holds the best frame of all there is nothing to search.
  if (in_paper_box(specimen.best.rotation)) return finding;
  const Enclosure on_box = enclose_on_paper_box(*specimen.objective);
  finding.margin = std::min(on_box.greatest_r() - specimen.best.least_r(), 0.0);
  finding.note = "R = " + std::to_string(specimen.best.least_r()) + ", on the box at most " +
                 std::to_string(on_box.greatest_r());
  return finding;
}

std::vector<Finding> check_cubes_on_paper_box(Random random) {
  constexpr int kCubes = 100;
  std::vector<Finding> findings;
  int below = 0;
  for (int i = 0; i < kCubes; ++i) {
    const std::string source = "shape:box?rotate=random&seed=" + std::to_string(random.below(1'000'000));
    findings.push_back(*check_paper_box(make_specimen(source), random));
    below += findings.back().margin < -1e-6;
  }
  for (Finding& finding : findings)
    finding.note += "; " + std::to_string(below) + " of " + std::to_string(kCubes) + " cubes in random poses below 1";
  return findings;
}

std::vector<Finding> check_three_quarters(Random random) {
  constexpr int kFrames = 100'000;
  int inside = 0;
  for (int i = 0; i < kFrames; ++i) inside += in_paper_box(random_rotation(random));
  const double share = static_cast<double>(inside) / kFrames;
  return {{-std::abs(share - 0.75), "random frames", nullptr, {}, "share " + std::to_string(share)}};
}

Finding check_chart_on_mesh(const Specimen& specimen, Random random, const Chart& chart) {
  Finding finding{.where = specimen.source};
  for (int i = 0; i < 8; ++i) {
    const Rotation wanted = i == 0 ? specimen.best.rotation : random_rotation(random);
    const Rotation reached = chart.rotation(chart.coordinates(wanted));
    const double margin = -std::abs(ratio_at(*specimen.objective, reached) - ratio_at(*specimen.objective, wanted));
    if (margin < finding.margin) finding.margin = margin, finding.rotation = wanted;
  }
  return finding;
}

Finding check_chart(Random random, const Chart& chart) {
  Finding finding{.where = "random frames"};
  for (int i = 0; i < 10'000; ++i) {
    const Rotation wanted = random_rotation(random);
    const double margin = -frame_angle(wanted, chart.rotation(chart.coordinates(wanted)));
    if (margin < finding.margin) finding.margin = margin, finding.rotation = wanted;
  }
  return finding;
}

}  // namespace rectilin::claims_detail
