#include "rectilin/search/index_worker.h"

#include <cmath>
#include <stdexcept>

namespace rectilin::search {
namespace {

double number_in(const Json& result, const char* key) {
  const Json& x = result.at(key);
  return x.is_number() ? x.get<double>() : std::nan("");  // JSON has no infinite numbers
}

}  // namespace

corpus::Work make_index_work(const Json& settings) {
  return [terms = make_terms(settings.at("descriptor").get<std::string>())](const NamedSource&,
                                                                            const LoadedMesh& loaded) {
    const DescribedMesh described = describe_model(retrieval::Model(loaded.mesh), terms);
    const Member& m = described.member;
    corpus::WorkResult done;
    done.result = {{"faces", m.faces}, {"rectilinearity", m.rectilinearity}, {"size", m.size}, {"seconds", m.seconds}};
    for (const retrieval::Signature& part : described.parts) done.bytes.append(part.begin(), part.end());
    return done;
  };
}

DescribedMesh described_mesh(const corpus::Answer& answer, const std::vector<retrieval::DescriptorPointer>& terms) {
  DescribedMesh described;
  Member& m = described.member;
  m.status = MemberStatus::kDone;
  answer.result.at("faces").get_to(m.faces);
  m.rectilinearity = number_in(answer.result, "rectilinearity");
  m.size = number_in(answer.result, "size");
  m.seconds = number_in(answer.result, "seconds");
  auto at = answer.bytes.begin();
  for (const auto& term : terms) {
    const auto size = static_cast<std::ptrdiff_t>(term->bytes());
    if (answer.bytes.end() - at < size) throw std::runtime_error("a worker sent too short a signature");
    described.parts.emplace_back(at, at + size);
    at += size;
  }
  return described;
}

}  // namespace rectilin::search
