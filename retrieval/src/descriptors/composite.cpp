// Weighted sums of descriptors.
#include <charconv>
#include <cmath>

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {
namespace {

class Composite final : public Descriptor {
 public:
  struct Part {
    double weight;
    DescriptorPointer descriptor;
  };
  explicit Composite(std::vector<Part> parts) : parts_(std::move(parts)) {
    for (const Part& part : parts_) {
      total_ += part.weight;
      bytes_ += part.descriptor->bytes();
    }
  }

  Signature describe(const Model& model) const override {
    Signature all;
    for (const Part& part : parts_) {
      const Signature own = part.descriptor->describe(model);
      all.insert(all.end(), own.begin(), own.end());
    }
    return all;
  }

  double distance(SignatureView a, SignatureView b) const override {
    double sum = 0;
    std::size_t begin = 0;
    for (const Part& part : parts_) {
      const std::size_t size = part.descriptor->bytes();
      sum += part.weight / total_ / part.descriptor->typical_distance() *
             part.descriptor->distance(a.subspan(begin, size), b.subspan(begin, size));
      begin += size;
    }
    return sum;
  }

  double typical_distance() const override { return 1; }
  std::size_t bytes() const override { return bytes_; }
  std::string distance_in_words() const override {
    return "weighted mean of the parts' distances, each over its typical one";
  }
  std::string invariant_to() const override { return "what all parts are invariant to"; }

 private:
  std::vector<Part> parts_;
  double total_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace

std::vector<Term> parse_composite(const std::string& text) {
  std::vector<Term> terms;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('+', begin), text.size());
    std::string part = text.substr(begin, end - begin);
    begin = end + 1;
    Term term;
    const std::size_t star = part.find('*');
    if (star != std::string::npos) {
      const auto [stop, error] = std::from_chars(part.data(), part.data() + star, term.weight);
      if (error != std::errc() || stop != part.data() + star || !(term.weight > 0) || !std::isfinite(term.weight))
        throw ParameterError("'" + text + "': '" + part.substr(0, star) + "' is not a positive weight");
      part.erase(0, star + 1);
    }
    if (part.empty()) throw ParameterError("'" + text + "': a term without a descriptor");
    descriptors().make(part);
    term.spec = std::move(part);
    terms.push_back(std::move(term));
  }
  return terms;
}

DescriptorPointer make_descriptor(const std::string& text) {
  const std::vector<Term> terms = parse_composite(text);
  if (terms.size() == 1) return descriptors().make(terms[0].spec);
  std::vector<Composite::Part> parts;
  for (const Term& term : terms) parts.push_back({term.weight, descriptors().make(term.spec)});
  return std::make_shared<Composite>(std::move(parts));
}

}  // namespace rectilin::retrieval
