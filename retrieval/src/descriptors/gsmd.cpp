#include "descriptors/gsmd.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "features/view_features.h"
#include "matching/byte_distance.h"
#include "rectilin/render/view_sphere.h"
#include "rectilin/retrieval/poses.h"

namespace rectilin::retrieval {
namespace {

enum class Match { kAll, kTurns, kOne };
enum class Curve { kLinear, kRoot };

struct GsmdOptions {
  std::string pose = "rectilinear";
  int views = 66, size = 256;
  Match match = Match::kAll;
  ViewFeatureOptions features;
  bool unit = true;
  Curve curve = Curve::kLinear;
  double fourier = 1, shape = 1;

  void bind(Parameters& parameters) {
    bind_pose(parameters, pose);
    parameters
        .custom(
            "views", "6 | 18 | 66 | 258",
            [this](const Json& value) {
              for (const int n : {6, 18, 66, 258})
                if (value == n) return views = n, true;
              return false;
            },
            [this] { return Json(views); }, "pictures, from the vertices of a geodesic sphere")
        .integer("size", size, 16, 1024, "pixels in a row of a picture")
        .choice(
            "match", match, {{"all", Match::kAll}, {"turns", Match::kTurns}, {"one", Match::kOne}},
            "rotations of one model's frame that are tried: all 24, the 4 that keep the axes' order, none but its own");
    features.bind(parameters);
    parameters.flag("unit", unit, "bring each picture's numbers to an L1 norm of 1, as the paper does")
        .choice("curve", curve, {{"linear", Curve::kLinear}, {"root", Curve::kRoot}},
                "numbers are rounded to 8 bits as they are, or their square roots")
        .real("fourier", fourier, 0, 4, "factor of the Fourier coefficients")
        .real("shape", shape, 0, 4, "factor of eccentricity and compactness");
  }
};

/// Section 7.1. Numbers and order of the pictures as in render::ViewSphere; each picture's are in kRow bytes.
class Gsmd final : public Descriptor {
 public:
  explicit Gsmd(GsmdOptions options)
      : options_(std::move(options)), sphere_(render::ViewSphere::of_size(static_cast<std::size_t>(options_.views))) {
    const auto symmetries = frame_symmetries();
    for (std::size_t i = 0; i < symmetries.size(); ++i) {
      const Eigen::Matrix3d& d = symmetries[i].matrix();
      const bool diagonal = d.diagonal().cwiseAbs().sum() > 2.5;
      const bool identity = d.diagonal().sum() > 2.5;
      if ((options_.match == Match::kTurns && !diagonal) || (options_.match == Match::kOne && !identity)) continue;
      for (const std::uint32_t k : sphere_.permutations()[i]) permutations_.push_back(static_cast<std::uint16_t>(k));
    }
  }

  Signature describe(const Model& model) const override {
    const Mesh& mesh = model.posed(options_.pose);
    render::ViewRenderer renderer(mesh, render::Ball{Vector3::Zero(), 1}, {.size = options_.size});
    Signature signature(bytes());
    for (std::size_t k = 0; k < sphere_.size(); ++k) {
      const std::size_t opposite = sphere_.opposite()[k];
      if (opposite < k) continue;
      const auto [front, back] = renderer.render_both(render::frame_towards(sphere_.directions()[k]));
      write(view_numbers(front, options_.features), signature.data() + k * kRow);
      write(view_numbers(back, options_.features), signature.data() + opposite * kRow);
    }
    return signature;
  }

  double distance(SignatureView a, SignatureView b) const override {
    return least_distance(a.data(), b.data(), sphere_.size(), permutations_) /
           (255.0 * static_cast<double>(kViewNumbers * sphere_.size()));
  }

  double typical_distance() const override { return 0.08; }
  std::size_t bytes() const override { return sphere_.size() * kRow; }
  std::string distance_in_words() const override {
    return "mean difference of a number, least over the rotations tried (eq. 33)";
  }
  std::string invariant_to() const override { return "as the pose: rotation, scale, position"; }

 private:
  void write(ViewNumbers numbers, std::uint8_t* row) const {
    if (options_.unit) {
      float sum = 0;
      for (const float x : numbers) sum += x;
      if (sum > 0)
        for (float& x : numbers) x *= 6 / sum;  // the largest of 47 numbers is about a sixth of their sum
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      double x = static_cast<double>(numbers[i]);
      if (options_.curve == Curve::kRoot) x = std::sqrt(x);
      if (i >= kZernike) x *= i < kZernike + kFourier ? options_.fourier : options_.shape;
      row[i] = static_cast<std::uint8_t>(std::lround(255 * std::min(1.0, x)));
    }
  }

  GsmdOptions options_;
  render::ViewSphere sphere_;
  std::vector<std::uint16_t> permutations_;
};

}  // namespace

void add_gsmd(DescriptorFactory& factory) {
  factory.add("gsmd", "geodesic sphere based multi-view descriptor: 47 numbers of each view (section 7.1)",
              GsmdOptions(), [](GsmdOptions o) { return std::make_shared<Gsmd>(std::move(o)); });
}

}  // namespace rectilin::retrieval
