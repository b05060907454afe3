// Random numbers that are the same on every platform.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace rectilin {

/// A seeded source of random numbers. The C++ standard fixes the bits of mt19937_64 but not those of its distributions,
/// so the few distributions that are needed are defined here. Not thread safe: give each task a generator of its own,
/// made by fork().
class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed), engine_(mix(seed)) {}

  /// An independent stream for task `index`. It depends on the seed and the index alone, never on how many numbers were
  /// drawn before.
  Random fork(std::uint64_t index) const { return Random(mix(seed_ + 1) ^ mix(~index)); }

  std::uint64_t bits() { return engine_(); }

  /// Uniform on [0, 1), 53 bits.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  /// Uniform on [lower, upper).
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }

  /// Uniform on {0, ..., count-1}; count >= 1.
  std::uint64_t below(std::uint64_t count) {
    const std::uint64_t reject = (~count + 1) % count;  // 2^64 mod count
    for (;;) {
      const std::uint64_t x = engine_();
      if (x >= reject) return x % count;
    }
  }

  bool chance(double probability) { return uniform() < probability; }

  /// Standard normal (Box-Muller, which makes one value for each call here).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log1p(-uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

  std::uint64_t seed() const { return seed_; }

 private:
  /// The finalizer of splitmix64 (Steele, Lea, Flood 2014): turns neighbouring seeds into unrelated ones.
  static std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

}  // namespace rectilin
