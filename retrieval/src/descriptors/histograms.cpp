// Histograms over random points of the surface. All of them are invariant to rotation, scale and position.
#include "descriptors/histograms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "descriptors/numbers.h"
#include "features/surface_samples.h"

namespace rectilin::retrieval {
namespace {

enum class Scale { kMean, kMax };

/// The unit of distances, and what the last bin ends at.
double range_of(Scale scale, const std::vector<double>& distances) {
  if (scale == Scale::kMax) return *std::ranges::max_element(distances);
  double sum = 0;
  for (const double d : distances) sum += d;
  return 3 * sum / static_cast<double>(distances.size());
}

std::size_t bin_of(double x, double range, int bins) {
  const double place = range > 0 ? x / range * bins : 0;
  return static_cast<std::size_t>(std::clamp(place, 0.0, bins - 1.0));
}

struct Pair {
  SurfacePoint first, second;
};

/// Calls `use(pair)` for pairs of independent points.
template <class Use>
void for_each_pair(const SurfaceSampler& surface, int count, const Use& use) {
  const SpreadNumbers<6> numbers;
  for (int i = 0; i < count; ++i) {
    const auto x = numbers.at(static_cast<std::size_t>(i));
    use(Pair{surface.at(x[0], x[1], x[2]), surface.at(x[3], x[4], x[5])});
  }
}

class Histogram : public Descriptor {
 public:
  Histogram(std::size_t bins, double typical) : bins_(bins), typical_(typical) {}
  double distance(SignatureView a, SignatureView b) const override { return l1(a, b, 0, 0, bins_) / 2; }
  double typical_distance() const override { return typical_; }
  std::size_t bytes() const override { return 4 * bins_; }
  std::string distance_in_words() const override { return "half the L1 distance of histograms of sum 1"; }
  std::string invariant_to() const override { return "rotation, scale, position"; }

 protected:
  Signature from_counts(std::vector<float> counts) const {
    to_unit_l1(counts);
    return signature_of(counts);
  }

 private:
  std::size_t bins_;
  double typical_;
};

/// What d1 and d2 leave to choose.
struct DistanceOptions {
  int bins = 64, samples = 65'536;
  Scale scale = Scale::kMean;
  void bind(Parameters& parameters) {
    parameters.integer("bins", bins, 2, 4096, "bins of the histogram")
        .integer("samples", samples, 1, 100'000'000, "points, or pairs of points")
        .choice("scale", scale, {{"mean", Scale::kMean}, {"max", Scale::kMax}},
                "the last bin ends at three times the mean distance, or at the largest");
  }
};

class DistanceHistogram final : public Histogram {
 public:
  enum class Kind { kFromCentre, kPairs };
  DistanceHistogram(Kind kind, DistanceOptions options)
      : Histogram(static_cast<std::size_t>(options.bins), kind == Kind::kPairs ? 0.16 : 0.3),
        kind_(kind),
        options_(options) {}

  Signature describe(const Model& model) const override {
    const Mesh mesh = transformed(model.mesh(), surface_frame(model.mesh()));
    const SurfaceSampler surface(mesh);
    std::vector<double> distances;
    distances.reserve(static_cast<std::size_t>(options_.samples));
    if (kind_ == Kind::kPairs) {
      for_each_pair(surface, options_.samples,
                    [&](const Pair& p) { distances.push_back((p.first.position - p.second.position).norm()); });
    } else {
      const SpreadNumbers<3> numbers;
      for (int i = 0; i < options_.samples; ++i) {
        const auto x = numbers.at(static_cast<std::size_t>(i));
        distances.push_back(surface.at(x[0], x[1], x[2]).position.norm());
      }
    }
    const double range = range_of(options_.scale, distances);
    std::vector<float> counts(static_cast<std::size_t>(options_.bins));
    for (const double d : distances) ++counts[bin_of(d, range, options_.bins)];
    return from_counts(std::move(counts));
  }

 private:
  Kind kind_;
  DistanceOptions options_;
};

/// Ohbuchi, Minamitani and Takei 2005: pairs of points by their distance and by the angle between the lines of their
/// normals, which does not ask which side of a face is outside.
struct AngleDistanceOptions {
  int distances = 64, angles = 8, samples = 65'536;
  Scale scale = Scale::kMean;
  void bind(Parameters& parameters) {
    parameters.integer("distances", distances, 1, 1024, "bins of the distance")
        .integer("angles", angles, 1, 64, "bins of |n1 . n2|, of equal width")
        .integer("samples", samples, 1, 100'000'000, "pairs of points")
        .choice("scale", scale, {{"mean", Scale::kMean}, {"max", Scale::kMax}}, "as for d2");
  }
};

class AngleDistance final : public Histogram {
 public:
  explicit AngleDistance(AngleDistanceOptions options)
      : Histogram(static_cast<std::size_t>(options.distances) * static_cast<std::size_t>(options.angles), 0.4),
        options_(options) {}

  Signature describe(const Model& model) const override {
    const Mesh mesh = transformed(model.mesh(), surface_frame(model.mesh()));
    const SurfaceSampler surface(mesh);
    std::vector<double> distances, cosines;
    for_each_pair(surface, options_.samples, [&](const Pair& p) {
      distances.push_back((p.first.position - p.second.position).norm());
      cosines.push_back(std::abs(surface.normal(p.first.triangle).dot(surface.normal(p.second.triangle))));
    });
    const double range = range_of(options_.scale, distances);
    std::vector<float> counts(bytes() / 4);
    const auto angles = static_cast<std::size_t>(options_.angles);
    for (std::size_t i = 0; i < distances.size(); ++i)
      ++counts[bin_of(distances[i], range, options_.distances) * angles + bin_of(cosines[i], 1, options_.angles)];
    return from_counts(std::move(counts));
  }
  std::string invariant_to() const override { return "rotation, scale, position, reflection, orientation of faces"; }

 private:
  AngleDistanceOptions options_;
};

/// Wahl, Hillenbrand and Hirzinger 2003: the four numbers that place one oriented point in the frame of another.
struct SurfletOptions {
  int bins = 5, samples = 65'536;
  Scale scale = Scale::kMax;
  void bind(Parameters& parameters) {
    parameters.integer("bins", bins, 1, 12, "bins of each of the four numbers")
        .integer("samples", samples, 1, 100'000'000, "pairs of points")
        .choice("scale", scale, {{"mean", Scale::kMean}, {"max", Scale::kMax}}, "as for d2");
  }
};

class SurfletPairs final : public Histogram {
 public:
  explicit SurfletPairs(SurfletOptions options)
      : Histogram(static_cast<std::size_t>(options.bins * options.bins * options.bins * options.bins), 0.55),
        options_(options) {}

  Signature describe(const Model& model) const override {
    const Mesh mesh = transformed(model.mesh(), surface_frame(model.mesh()));
    const SurfaceSampler surface(mesh);
    std::vector<double> distances;
    std::vector<std::array<double, 3>> angles;
    for_each_pair(surface, options_.samples, [&](const Pair& p) {
      Vector3 between = p.second.position - p.first.position;
      const double distance = between.norm();
      if (distance == 0) return;
      between /= distance;
      Vector3 n1 = surface.normal(p.first.triangle), n2 = surface.normal(p.second.triangle);
      // The point whose normal is nearer to the line between them is the origin, so that the order does not matter.
      if (std::abs(n1.dot(between)) < std::abs(n2.dot(between))) {
        std::swap(n1, n2);
        between = -between;
      }
      const Vector3 across = between.cross(n1);
      if (across.norm() < 1e-9) return;  // no frame: the line is the normal
      const Vector3 v = across.normalized(), w = n1.cross(v);
      distances.push_back(distance);
      angles.push_back({std::atan2(w.dot(n2), n1.dot(n2)) + std::numbers::pi, v.dot(n2) + 1, n1.dot(between) + 1});
    });
    std::vector<float> counts(bytes() / 4);
    if (distances.empty()) return from_counts(std::move(counts));
    const double range = range_of(options_.scale, distances);
    const auto bins = static_cast<std::size_t>(options_.bins);
    for (std::size_t i = 0; i < distances.size(); ++i) {
      std::size_t at = bin_of(angles[i][0], 2 * std::numbers::pi, options_.bins);
      at = at * bins + bin_of(angles[i][1], 2, options_.bins);
      at = at * bins + bin_of(angles[i][2], 2, options_.bins);
      ++counts[at * bins + bin_of(distances[i], range, options_.bins)];
    }
    return from_counts(std::move(counts));
  }

 private:
  SurfletOptions options_;
};

}  // namespace

void add_histograms(DescriptorFactory& factory) {
  using Kind = DistanceHistogram::Kind;
  factory.add("d1", "distances of surface points from the surface's centre of mass (Ankerst et al. 1999)",
              DistanceOptions(),
              [](DistanceOptions o) { return std::make_shared<DistanceHistogram>(Kind::kFromCentre, o); });
  factory.add("d2", "distances between pairs of surface points (Osada et al. 2002)", DistanceOptions(),
              [](DistanceOptions o) { return std::make_shared<DistanceHistogram>(Kind::kPairs, o); });
  factory.add("aad", "pairs of surface points: distance and absolute angle of normals (Ohbuchi et al. 2005)",
              AngleDistanceOptions(), [](AngleDistanceOptions o) { return std::make_shared<AngleDistance>(o); });
  factory.add("sprh", "pairs of oriented surface points: distance and three angles (Wahl et al. 2003)",
              SurfletOptions(), [](SurfletOptions o) { return std::make_shared<SurfletPairs>(o); });
}

}  // namespace rectilin::retrieval
