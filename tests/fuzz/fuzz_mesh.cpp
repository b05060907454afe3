// Fuzzes the mesh readers (libFuzzer). The first byte picks the format, the rest is the file. A
// reader either throws MeshError with one line, or keeps the promises of Mesh and MeshReport.
#include <cstdint>
#include <string_view>

#include "check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  rectilin::fuzz::check_reader(
      [&] { return rectilin::read_mesh(bytes, static_cast<rectilin::MeshFormat>(data[0] % 4), "fuzz"); });
  return 0;
}
