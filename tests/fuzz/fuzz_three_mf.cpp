// Fuzzes the reader of 3MF (libFuzzer).
#include <cstdint>
#include <string_view>

#include "check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  rectilin::fuzz::check_reader([&] { return rectilin::read_mesh(bytes, rectilin::MeshFormat::k3mf, "fuzz"); });
  return 0;
}
