#include "page_files.h"

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "rectilin/base/fnv1a.h"

namespace rectilin::serve {
namespace {

namespace fs = std::filesystem;

/// A folder beside the program's: where CMake puts the page when it builds, and when it installs.
constexpr const char* kPlaces[] = {"../serve/page", RECTILIN_PAGE_FROM_BIN};

std::string type_of(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".html") return "text/html; charset=utf-8";
  if (extension == ".css") return "text/css; charset=utf-8";
  if (extension == ".js") return "text/javascript; charset=utf-8";
  if (extension == ".svg") return "image/svg+xml";
  return "text/plain; charset=utf-8";
}

fs::path page_folder() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : kPlaces)
    if (const fs::path folder = program / place; fs::exists(folder / "index.html")) return folder;
  throw std::runtime_error("the page's files are not beside the program (" + (program / kPlaces[1]).string() + ")");
}

}  // namespace

PageFiles load_page_files() {
  const fs::path folder = page_folder();
  PageFiles page;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw std::runtime_error(entry.path().string() + ": cannot be read");
    std::ostringstream tag;
    tag << '"' << std::hex << Fnv1a().add(text.str()).value() << '"';
    const std::string path = "/" + entry.path().lexically_relative(folder).generic_string();
    page.files[path == "/index.html" ? "/" : path] = {type_of(entry.path()), to_bytes(text.str()), tag.str()};
  }
  page.viewer = page.files.contains("/three/three.module.js") && page.files.contains("/three/three.core.js");
  return page;
}

}  // namespace rectilin::serve
