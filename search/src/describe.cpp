#include "rectilin/search/describe.h"

#include <time.h>

#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/source.h"

namespace rectilin::search {
namespace {

double seconds_of_thread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::vector<retrieval::DescriptorPointer> make_terms(const std::string& descriptor) {
  std::vector<retrieval::DescriptorPointer> terms;
  for (const retrieval::Term& term : retrieval::parse_composite(descriptor))
    terms.push_back(retrieval::descriptors().make(term.spec));
  return terms;
}

DescribedMesh describe_model(const retrieval::Model& model, const std::vector<retrieval::DescriptorPointer>& terms) {
  const double begin = seconds_of_thread();
  DescribedMesh described;
  for (const auto& term : terms) described.parts.push_back(term->describe(model));
  Member& m = described.member;
  m.status = MemberStatus::kDone;
  m.faces = model.mesh().triangles.size();
  m.rectilinearity = model.rectilinearity();
  m.size = largest_extent(model.mesh());
  m.seconds = seconds_of_thread() - begin;
  return described;
}

DescribedMesh describe_source(const std::string& source, const std::vector<retrieval::DescriptorPointer>& terms) {
  return describe_model(retrieval::Model(load_mesh(source).mesh), terms);
}

}  // namespace rectilin::search
