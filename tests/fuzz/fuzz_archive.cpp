// Fuzzes archives as sources (libFuzzer): every mesh of an archive is listed and loaded. The first byte picks the kind.
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "check_mesh.h"
#include "rectilin/mesh/source.h"

namespace {

/// A file for this process, in memory where there is such a place.
std::string file_of_kind(int kind) {
  constexpr const char* kNames[] = {"zip", "7z", "tar", "tar.gz", "tar.xz", "off.gz"};
  const std::filesystem::path memory = "/dev/shm";
  const auto folder = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  return folder / ("rectilin-fuzz-" + std::to_string(getpid()) + "." + kNames[kind % 6]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string file = file_of_kind(data[0]);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data) + 1, static_cast<std::streamsize>(size - 1));
  for (const std::string& source : rectilin::expand_folders({file}))
    rectilin::fuzz::check_reader([&] { return rectilin::load_mesh(source); });
  std::filesystem::remove(file);
  return 0;
}
