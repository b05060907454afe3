// Descriptors whose distances can be bounded from below at a fraction of their price.
#pragma once

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

/// A descriptor may be one, too (dynamic_cast): signatures then have coarse ones of coarse_bytes() each, made from them
/// alone, and bound(coarse(a), coarse(b)) <= distance(a, b), up to rounding in the last bits. Thread safe.
class Bounded {
 public:
  virtual ~Bounded() = default;
  virtual std::size_t coarse_bytes() const = 0;
  virtual Signature coarse(SignatureView signature) const = 0;
  virtual double bound(SignatureView coarse_a, SignatureView coarse_b) const = 0;
};

}  // namespace rectilin::retrieval
