// The loops over generators against sums one by one, on every instruction set.
#include <algorithm>
#include <array>
#include <vector>

#include "certify/generator_kernels.h"
#include "rectilin/measure/flat_sum.h"
#include "support/catch.h"
#include "support/random_meshes.h"

using namespace rectilin;
using namespace rectilin::certification;

namespace {

using Vectors = std::vector<Eigen::Vector3d>;

std::array<std::vector<double>, 3> components(const Vectors& vectors) {
  const std::size_t size = (vectors.size() + kGeneratorLanes - 1) / kGeneratorLanes * kGeneratorLanes;
  std::array<std::vector<double>, 3> result;
  for (int c = 0; c < 3; ++c) {
    for (const Eigen::Vector3d& v : vectors) result[c].push_back(v[c]);
    result[c].resize(size);
  }
  return result;
}

}  // namespace

TEST_CASE("generators with both signs at a triangle's corners are copied in order, the others summed", "[certify]") {
  Random random(17);
  std::size_t copied = 0, all = 0;
  for (const std::string& name : instruction_sets()) {
    INFO(name);
    const ScopedInstructionSet set(name);
    for (std::size_t size = 0; size < 70; ++size) {
      Vectors vectors(size);
      for (Eigen::Vector3d& v : vectors) v = random.chance(0.1) ? Eigen::Vector3d::Zero() : test::random_vector(random);
      const Eigen::Vector3d centre = test::random_vector(random).normalized();
      Triangle3 corners;
      const double width = random.uniform(0.01, 2);
      for (Eigen::Vector3d& corner : corners) corner = (centre + width * test::random_vector(random)).normalized();
      Vectors unsettled;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& v : vectors) {
        const std::array<double, 3> at = {v.dot(corners[0]), v.dot(corners[1]), v.dot(corners[2])};
        const auto [least, most] = std::minmax_element(at.begin(), at.end());
        if (*least < 0 && *most > 0) unsettled.push_back(v);
        else sum += *least < 0 ? -v : v;
      }

      const auto c = components(vectors);
      std::array<std::vector<double>, 3> out;
      for (auto& o : out) o.resize(c[0].size() + kGeneratorLanes);
      Eigen::Vector3d settled = Eigen::Vector3d::Zero();
      const std::size_t count = copy_unsettled({c[0].data(), c[1].data(), c[2].data(), c[0].size()}, corners,
                                               {out[0].data(), out[1].data(), out[2].data()}, settled);
      REQUIRE(count == unsettled.size());
      for (std::size_t i = 0; i < count; ++i) REQUIRE(Eigen::Vector3d(out[0][i], out[1][i], out[2][i]) == unsettled[i]);
      REQUIRE((settled - sum).norm() <= 1e-12);
      copied += count, all += size;
    }
  }
  REQUIRE(copied > all / 5);
  REQUIRE(copied < all / 5 * 4);
}
