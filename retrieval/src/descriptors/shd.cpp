#include "descriptors/shd.h"

#include <algorithm>
#include <array>

#include "descriptors/numbers.h"
#include "features/radial_extent.h"
#include "features/spherical_harmonics.h"
#include "rectilin/retrieval/poses.h"

namespace rectilin::retrieval {
namespace {

struct ShdOptions {
  std::string pose = "rectilinear";
  int grid = 64, bandwidth = 16;
  void bind(Parameters& parameters) {
    bind_pose(parameters, pose);
    parameters.integer("grid", grid, 8, 512, "directions each way on the sphere")
        .integer("bandwidth", bandwidth, 1, 32, "degrees l below this");
  }
};

/// Section 7.2. Of the complex coefficients the magnitudes for m >= 0 are kept: they do not change under turns about
/// the polar axis and under reflections, so of the 24 rotations of a frame only the order of its axes remains, 6
/// matches.
class Shd final : public Descriptor {
 public:
  explicit Shd(ShdOptions options) : options_(std::move(options)), transform_(options_.grid, options_.bandwidth) {}

  Signature describe(const Model& model) const override {
    const Mesh& mesh = model.posed(options_.pose);
    std::vector<float> numbers;
    for (int pole = 0; pole < 3; ++pole) {
      std::vector<float> block;
      for (const double x : transform_.magnitudes(radial_extent(mesh, options_.grid, pole)))
        block.push_back(static_cast<float>(x));
      to_unit_l1(block);
      numbers.insert(numbers.end(), block.begin(), block.end());
    }
    return signature_of(numbers);
  }

  double distance(SignatureView a, SignatureView b) const override {
    const std::size_t n = transform_.size();
    double blocks[3][3];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) blocks[i][j] = l1(a, b, i * n, j * n, n);
    std::array<int, 3> order{0, 1, 2};
    double least = 6;
    do {
      std::array<double, 3> terms{blocks[0][order[0]], blocks[1][order[1]], blocks[2][order[2]]};
      std::ranges::sort(terms);  // so that (a, b) and (b, a) add the same numbers in the same order
      least = std::min(least, terms[0] + terms[1] + terms[2]);
    } while (std::ranges::next_permutation(order).found);
    return least / 6;
  }

  double typical_distance() const override { return 0.39; }
  std::size_t bytes() const override { return 12 * transform_.size(); }
  std::string distance_in_words() const override { return "mean of three L1 distances over 2, least of six orders"; }
  std::string invariant_to() const override { return "as the pose: rotation, scale, position; reflection"; }

 private:
  ShdOptions options_;
  HarmonicTransform transform_;
};

}  // namespace

void add_shd(DescriptorFactory& factory) {
  factory.add("shd", "spherical harmonics of the surface's extent about three axes (section 7.2)", ShdOptions(),
              [](ShdOptions o) { return std::make_shared<Shd>(std::move(o)); });
}

}  // namespace rectilin::retrieval
