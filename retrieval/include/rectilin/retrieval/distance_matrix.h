// Distances between all pairs of models, and the `.matrix` files that hold them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace rectilin::retrieval {

/// Square, row-major, single precision as in the file. Row i has the distances from query i; smaller is more alike.
class DistanceMatrix {
 public:
  DistanceMatrix() = default;
  explicit DistanceMatrix(std::size_t size) : size_(size), values_(size * size) {}

  std::size_t size() const { return size_; }
  float& at(std::size_t i, std::size_t j) { return values_[i * size_ + j]; }
  float at(std::size_t i, std::size_t j) const { return values_[i * size_ + j]; }
  const float* row(std::size_t i) const { return values_.data() + i * size_; }
  const std::vector<float>& values() const { return values_; }
  std::vector<float>& values() { return values_; }

 private:
  std::size_t size_ = 0;
  std::vector<float> values_;
};

/// Fills a matrix from a function that is symmetric and thread safe, each pair once and in parallel; the diagonal is
/// zero. The result does not depend on the number of threads.
DistanceMatrix symmetric_matrix(std::size_t size, const std::function<double(std::size_t, std::size_t)>& distance);

/// The files of the Princeton Shape Benchmark: size * size numbers of four bytes (IEEE 754, least byte first), row by
/// row, nothing else.
void write_matrix(const std::filesystem::path& file, const DistanceMatrix& matrix);

/// Only their order counts, so that negative distances (similarities less) and infinite ones are as good as others.
/// Throws std::runtime_error, "FILE: reason", if the file has not the bytes of size * size numbers, or "FILE:byte N" if
/// one is not a number.
DistanceMatrix read_matrix(const std::filesystem::path& file, std::size_t size);

}  // namespace rectilin::retrieval
