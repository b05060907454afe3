// A file of one JSON value a line that grows while work is done and survives an end at any moment.
#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "rectilin/base/parameters.h"

namespace rectilin {

/// The values of the file's lines; none if there is no file. A last line that was cut off is removed from the
/// file. Throws std::runtime_error for any other line that is not JSON.
std::vector<Json> recover_journal(const std::filesystem::path& file);

/// Appends lines. Not thread safe.
class Journal {
 public:
  /// Throws std::runtime_error if the file cannot be opened.
  explicit Journal(const std::filesystem::path& file);

  /// Writes the line through to the operating system. Throws std::runtime_error if that fails.
  void append(const Json& value);

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace rectilin
