// The objective's inner loop: h(u) = sum_i |u . v_i| for many directions u, summed over every face.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/measure/area_vectors.h"

namespace rectilin {

struct FlatKernels;
template <class T>
struct FlatFaces;
enum FlatQuantity : int;

enum class Precision { kSingle, kDouble };

/// Sums over all area vectors, for many directions in each pass, with the widest vector instructions of the processor.
///
/// h is even, convex and positively homogeneous: the support function of the mesh's projection body (Schneider, Convex
/// Bodies: The Brunn-Minkowski Theory, section 10.9). For a rotation with rows r1, r2, r3 the objective is P = h(r1) +
/// h(r2) + h(r3).
///
/// A result depends on its direction, the area vectors and the instruction set alone, bit for bit: neither on the
/// number of threads nor on the other directions in the call. Directions need not have unit length; lengths in [2^-600,
/// 2^600] are fine, and the zero vector gives zero.
///
/// Const and thread safe. Small calls neither allocate nor start tasks; large ones use TBB's current arena.
class FlatSum {
 public:
  /// In double precision it reads `vectors` in place: they must outlive this object, unchanged. In single precision it
  /// keeps a copy of half the size. Uses the instruction set that is in force when it is made.
  explicit FlatSum(const AreaVectors& vectors, Precision precision = Precision::kDouble);

  /// h[k] = h(u[k]); both spans have the same size. The error is at most relative_error_bound() |u| S, where S =
  /// sum |v_i|.
  void values(std::span<const Vector3> u, std::span<double> h) const;

  /// g[k] = sum_i sign(u[k] . v_i) v_i, a subgradient of h at u[k]: h(w) >= g . w for every w, with equality at w =
  /// u[k], both up to relative_error_bound() |w| S. Where u . v_i is zero the sign may be either.
  void cuts(std::span<const Vector3> u, std::span<Vector3> g) const;

  /// The largest possible rounding error of values() relative to |u| S, for any instruction set. It does not grow with
  /// the number of faces: faces are summed in blocks, and the sums of blocks are combined with compensation.
  static double relative_error_bound(Precision precision);

  std::size_t size() const { return vectors_->size(); }
  std::size_t bytes() const;  ///< memory used by this object, without the area vectors
  Precision precision() const { return precision_; }

 private:
  FlatFaces<float> single_faces() const;
  FlatFaces<double> double_faces() const;
  template <class Result, class Finish>
  void evaluate(FlatQuantity quantity, std::span<const Vector3> u, std::span<Result> results,
                const Finish& finish) const;

  const AreaVectors* vectors_;
  Precision precision_;
  const FlatKernels* kernels_;
  CacheAligned<float> single_;        // x, y, z, each padded with zeros
  std::array<double, 24> tail_ = {};  // the last vectors, padded with zeros so that no lane reads past the end
  Vector3 total_ = Vector3::Zero();   // sum of the v_i with the signs they are stored with
};

/// The instruction sets that this processor has and the library was built for, best first, e.g. {"AVX3", "AVX2"}.
std::vector<std::string> instruction_sets();

/// While it lives, FlatSum and DirectionTree objects that are made use the given one of instruction_sets(). For tests
/// and benchmarks: no other thread may make such objects meanwhile. Throws std::invalid_argument for a name that is not
/// in the list.
class ScopedInstructionSet {
 public:
  explicit ScopedInstructionSet(std::string_view name);
  ~ScopedInstructionSet();
  ScopedInstructionSet(const ScopedInstructionSet&) = delete;
  ScopedInstructionSet& operator=(const ScopedInstructionSet&) = delete;
};

}  // namespace rectilin
