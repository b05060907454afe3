#include "descriptors/rectilinearity.h"

#include <cmath>

#include "descriptors/numbers.h"

namespace rectilin::retrieval {
namespace {

struct RectilinearityOptions {
  void bind(Parameters&) {}
};

class RectilinearityDescriptor final : public Descriptor {
 public:
  Signature describe(const Model& model) const override {
    const float value[] = {static_cast<float>(model.rectilinearity())};
    return signature_of(value);
  }
  double distance(SignatureView a, SignatureView b) const override { return l1(a, b, 0, 0, 1); }
  double typical_distance() const override { return 0.34; }
  std::size_t bytes() const override { return 4; }
  std::string distance_in_words() const override { return "difference of R"; }
  std::string invariant_to() const override { return "rotation, scale, position, reflection"; }
};

}  // namespace

void add_rectilinearity(DescriptorFactory& factory) {
  factory.add("r", "rectilinearity R(M), certified to 1e-6 (the paper's eq. 27)", RectilinearityOptions(),
              [](RectilinearityOptions) { return std::make_shared<RectilinearityDescriptor>(); });
}

}  // namespace rectilin::retrieval
