// What a shape descriptor is: a short list of bytes for a model, and a distance between two of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rectilin/base/factory.h"
#include "rectilin/retrieval/model.h"

namespace rectilin::retrieval {

/// All that is kept of a model. Numbers of several bytes are in the machine's order, least byte first.
using Signature = std::vector<std::uint8_t>;
using SignatureView = std::span<const std::uint8_t>;

/// Immutable; all members are thread safe, and their results are the same bits for any number of threads and any
/// instruction set.
class Descriptor {
 public:
  virtual ~Descriptor() = default;

  /// The model's signature, of bytes() bytes. Throws MeshError if the model has none (no area, no extent).
  virtual Signature describe(const Model& model) const = 0;

  /// From 0 (equal signatures) to 1 (as different as can be), symmetric; of sums, `best` among them, it may be more
  /// than 1. Both signatures are of bytes() bytes.
  virtual double distance(SignatureView a, SignatureView b) const = 0;

  /// The distance of two models that have nothing in common, about: the mean over the training half of the Princeton
  /// Shape Benchmark. A fixed number, by which weighted sums bring distances to one scale.
  virtual double typical_distance() const = 0;

  virtual std::size_t bytes() const = 0;

  /// What the distance is, and what it does not depend on, each in one line for tables.
  virtual std::string distance_in_words() const = 0;
  virtual std::string invariant_to() const = 0;
};

using DescriptorPointer = std::shared_ptr<const Descriptor>;
using DescriptorFactory = Factory<DescriptorPointer>;

/// Every descriptor by name, with its parameters: `gsmd?views=66&image=depth`.
const DescriptorFactory& descriptors();

/// A weighted sum of distances.
struct Term {
  double weight = 1;
  std::string spec;  ///< of descriptors()
};

/// Reads `gsmd+0.3*shd+0.1*r`: terms joined by '+', each a descriptor with a weight and '*' before it (1 if left out).
/// Every distance is divided by its typical_distance() first, so weights are comparable, and a sum needs no knowledge
/// of the collection. Throws ParameterError for weights that are not positive numbers and for descriptors that cannot
/// be made.
std::vector<Term> parse_composite(const std::string& text);

/// The descriptor of such a text: signatures one after the other; the distance is the weighted mean of the terms'
/// scaled ones, which is not bounded by 1.
DescriptorPointer make_descriptor(const std::string& text);

}  // namespace rectilin::retrieval
