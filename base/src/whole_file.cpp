#include "rectilin/base/whole_file.h"

#include <fstream>
#include <stdexcept>
#include <string>

namespace rectilin {
namespace {

namespace fs = std::filesystem;

bool write(const fs::path& file, std::string_view content) {
  std::ofstream out(file, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  return !out.fail();
}

}  // namespace

void write_whole_file(const fs::path& file, std::string_view content) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file, error);
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  const fs::path begun = in_place ? file : fs::path(file.string() + ".new");
  bool done = write(begun, content);
  if (!in_place) {
    if (done) {
      fs::rename(begun, file, error);
      done = !error;
    }
    if (!done) fs::remove(begun, error);
  }
  if (!done) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace rectilin
