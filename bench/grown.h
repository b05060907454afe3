// Collections as large as wanted, made from the signatures of a database.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "rectilin/base/random.h"
#include "rectilin/search/nearest.h"

namespace rectilin::bench {

constexpr int kNoise = 6;  // each byte moves by up to so much: about what remeshing does

inline search::Parts perturbed(search::Parts parts, Random& random, int noise = kNoise) {
  for (auto& part : parts)
    for (std::uint8_t& byte : part) {
      const int moved = byte + static_cast<int>(random.below(static_cast<std::uint64_t>(2 * noise + 1))) - noise;
      byte = static_cast<std::uint8_t>(std::clamp(moved, 0, 255));
    }
  return parts;
}

struct Originals {
  std::string descriptor;
  std::vector<search::Parts> parts;

  explicit Originals(const std::string& file) {
    search::Database database{std::filesystem::path(file)};
    descriptor = database.descriptor();
    database.for_each_signature([&](search::Member&&, search::Parts&& own) { parts.push_back(std::move(own)); });
    if (parts.empty()) throw std::runtime_error(file + ": has no signatures");
  }
};

/// Members between a model and others near it, so that the collection fills the space between its originals instead of
/// being a heap of copies of each: each is mixed from three, in shares at random.
class Between {
 public:
  explicit Between(const Originals& originals) : originals_(originals), near_(originals.parts.size()) {
    search::NearestSearch all(originals.descriptor);
    for (const search::Parts& parts : originals.parts) all.add(parts);
    for (std::size_t i = 0; i < near_.size(); ++i)
      for (const search::Neighbour& n : all.nearest(originals.parts[i], 20, [&](std::size_t j) { return j != i; }))
        near_[i].push_back(n.member);
  }

  search::Parts make(std::uint64_t seed) const {
    Random random(seed);
    const std::size_t a = random.below(near_.size());
    const std::size_t b = near_[a][random.below(near_[a].size())], c = near_[a][random.below(near_[a].size())];
    const double first = random.uniform(), second = 0.7 * random.uniform();
    return perturbed(mixed(mixed(originals_.parts[a], originals_.parts[b], first), originals_.parts[c], second), random,
                     kNoise / 2);
  }

 private:
  static search::Parts mixed(search::Parts a, const search::Parts& b, double share) {
    for (std::size_t k = 0; k < a.size(); ++k)
      for (std::size_t i = 0; i < a[k].size(); ++i)
        a[k][i] = static_cast<std::uint8_t>(std::lround(a[k][i] * (1 - share) + b[k][i] * share));
    return a;
  }

  const Originals& originals_;
  std::vector<std::vector<std::size_t>> near_;
};

}  // namespace rectilin::bench
