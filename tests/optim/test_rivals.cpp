// The lists of cuts among which the sieve chooses: nothing that may win on a box is missing from them.
#include <algorithm>
#include <cmath>

#include "certify/rivals.h"
#include "rectilin/base/rotation.h"
#include "rectilin/measure/flat_sum.h"
#include "support/catch.h"
#include "support/random_meshes.h"

using namespace rectilin;
using namespace rectilin::certification;

namespace {

/// Cuts of no objective: any rows do, as lists are about products only.
Cut random_cut(Random& random) {
  Cut cut;
  for (int k = 0; k < 3; ++k) cut.gradient.row(k) = test::random_vector(random).transpose();
  return cut;
}

bool holds(const CutList& list, std::uint32_t row) {
  const auto end = list.row.begin() + static_cast<std::ptrdiff_t>(list.size);
  return std::find(list.row.begin(), end, row) != end;
}

}  // namespace

TEST_CASE("a list holds the cuts that were taken at a box's corners and exceed its first one there", "[certify]") {
  Random random(11);
  int present = 0, left_out = 0;
  double worst = 0;  // of the differences to first order, in units of half the square of the angle
  for (const std::string& name : instruction_sets()) {
    INFO(name);
    const ScopedInstructionSet set(name);
    for (int trial = 0; trial < 300; ++trial) {
      Cell cell;
      for (int i = 0; i < 3; ++i) {
        const double centre = random.uniform(-0.3, 0.3), half = std::pow(10.0, random.uniform(-6, -1));
        cell.box.lower[i] = centre - half, cell.box.upper[i] = centre + half;
      }
      CutTable table;
      std::vector<Rotation> corners;
      for (int c = 0; c < 8; ++c) {
        Eigen::Vector3d rho;
        for (int i = 0; i < 3; ++i) rho[i] = (c >> i & 1 ? cell.box.upper : cell.box.lower)[i];
        corners.push_back(rotation_from_rodrigues(rho));
        table.add(corners.back(), random_cut(random));
      }
      const Rotation middle = rotation_from_rodrigues(cell.box.centre());
      for (std::uint32_t k = 0; k < 3; ++k) cell.bundles[k].add(table.size() + k, Cell::kMaxBundle);
      table.add(middle, random_cut(random));
      CutLists lists;
      find_rivals(cell, table, middle, lists);

      const double angle = angle_between(middle, corners[0]);
      for (std::uint32_t k = 0; k < 3; ++k) {
        const CutList& list = lists[k];
        const Eigen::Vector3d first = table[list.row[0]];
        REQUIRE(list.row[0] == 24 + k);
        for (std::uint32_t c = 0; c < 8; ++c) {
          const std::uint32_t row = 3 * c + k;
          const double excess = (table[row] - first).dot(corners[c].axis(static_cast<int>(k)));
          const double doubt = (table[row] - first).norm() * (angle * angle + 1e-6 * angle);
          if (excess > doubt) REQUIRE(holds(list, row));
          ++(holds(list, row) ? present : left_out);
        }
        for (std::size_t j = 0; j < list.size; ++j)
          for (int c = 0; c < 8; ++c) {
            const Eigen::Vector3d more = table[list.row[j]] - first;
            double predicted = list.lead[j];
            for (int i = 0; i < 3; ++i) predicted += (c >> i & 1 ? 1 : -1) * list.along[i][j];
            const double error = std::abs(predicted - more.dot(corners[c].axis(static_cast<int>(k))));
            REQUIRE(error <= more.norm() * (angle * angle + 1e-6));
            if (angle > 0.1) worst = std::max(worst, error / (0.5 * more.norm() * angle * angle));
          }
      }
    }
  }
  CAPTURE(present, left_out, worst);
  REQUIRE(present > 1000);
  REQUIRE(left_out > 1000);
  REQUIRE(worst > 0.5);  // the bound is not idle
}

TEST_CASE("a list with more rivals than it has room for is full, no more", "[certify]") {
  Random random(12);
  Cell cell;
  cell.box = Box::zone();
  CutTable table;
  const Rotation middle;
  Cut low;
  low.gradient = Eigen::Matrix3d::Constant(-10);
  for (std::uint32_t k = 0; k < 3; ++k) cell.bundles[k].add(k, Cell::kMaxBundle);
  table.add(middle, low);
  for (int i = 0; i < 1000; ++i) table.add(middle, random_cut(random));
  for (const std::string& name : instruction_sets()) {
    INFO(name);
    const ScopedInstructionSet set(name);
    CutLists lists;
    find_rivals(cell, table, middle, lists);
    for (const CutList& list : lists) {
      REQUIRE(list.size == CutList::kMost - 1);
      REQUIRE(list.row[list.size] == list.row[0]);
      REQUIRE(std::ranges::all_of(list.row.begin(), list.row.begin() + CutList::kMost,
                                  [&](std::uint32_t row) { return row < table.size(); }));
    }
  }
}
