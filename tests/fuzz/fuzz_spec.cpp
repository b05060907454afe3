// Any text either is a ParameterError or makes a valid mesh.
#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "rectilin/mesh/shapes.h"

namespace {

/// Settings that would only make a mesh larger, and the fuzzer slower.
bool is_large(const rectilin::Spec& spec) {
  return std::any_of(spec.settings.items().begin(), spec.settings.items().end(), [](const auto& item) {
    const double cap = item.key() == "subdivisions" ? 4 : 64;
    return item.value().is_number() && item.value().template get<double>() > cap;
  });
}

bool is_valid(const rectilin::Mesh& mesh) {
  return !mesh.triangles.empty() &&
         std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const auto& p) { return p.allFinite(); }) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const auto& t) { return *std::max_element(t.begin(), t.end()) < mesh.vertices.size(); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto spec = rectilin::Spec::parse({reinterpret_cast<const char*>(data), size});
    if (!is_large(spec) && !is_valid(rectilin::make_shape(spec))) std::abort();
  } catch (const rectilin::ParameterError&) {
  }
  return 0;
}
