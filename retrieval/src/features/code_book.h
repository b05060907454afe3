// A vocabulary of local features, and a model's use of it in a few numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "features/local_features.h"

namespace rectilin::retrieval {

/// Vectors of locally aggregated descriptors (Jegou et al. 2012). A local feature is projected on the main components
/// of local features and belongs to the nearest word; each word sums up how its features lie about it; these residuals
/// are projected on their own main components in turn. Learned without labels from the training half of the Princeton
/// Shape Benchmark by rectilin_make_words, which wrote data/words.bin.
struct CodeBook {
  int words = 0;    ///< size of the vocabulary
  int dims = 0;     ///< components of a local feature
  int numbers = 0;  ///< components of a model

  std::vector<float> mean;        ///< of local features: kLocal
  std::vector<float> components;  ///< dims rows of kLocal
  std::vector<float> centres;     ///< words rows of dims
  std::vector<float> offset;      ///< mean of residuals: words * dims
  std::vector<float> scale;       ///< of each row below
  std::vector<std::int8_t> rows;  ///< numbers rows of words * dims, to be multiplied by scale

  std::size_t residuals() const { return static_cast<std::size_t>(words) * static_cast<std::size_t>(dims); }

  /// The file's bytes. Throws std::runtime_error for bytes that are not a code book.
  static CodeBook parse(std::span<const std::uint8_t> bytes);
  std::string to_bytes() const;

  /// The one that is compiled in.
  static const CodeBook& built_in();
};

/// A model's residuals, to which its local features are added one by one.
class Residuals {
 public:
  explicit Residuals(const CodeBook& book) : book_(book), sums_(book.residuals()) {}
  void add(const LocalFeature& feature);

  /// Each word's sum at unit length, then square roots with signs, then all at unit length: so that neither frequent
  /// words nor large sums rule (Arandjelovic and Zisserman 2013). words * dims numbers.
  std::vector<float> finished() const;

 private:
  const CodeBook& book_;
  std::vector<float> sums_;
};

/// The components of finished residuals, at unit length.
std::vector<float> project(const CodeBook& book, std::span<const float> residuals);

/// A local feature's components.
void project(const CodeBook& book, const LocalFeature& feature, std::span<float> components);

}  // namespace rectilin::retrieval
