// A file of one JSON value a line that grows while work is done and survives an end at any moment.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "rectilin/base/parameters.h"

namespace rectilin {

/// The values of the file's lines; none if there is no file. A last line that was cut off is removed from the
/// file. Throws std::runtime_error for any other line that is not JSON.
std::vector<Json> recover_journal(const std::filesystem::path& file);

/// Calls `use(value)` for each value of a journal, in order. Json::exception and std::out_of_range, which say that a
/// line is of another kind, become std::runtime_error with the file and the line.
template <class Use>
void for_each_line(const std::filesystem::path& file, const std::vector<Json>& values, const Use& use) {
  std::size_t line = 0;
  const auto place = [&] { return file.string() + ":line " + std::to_string(line) + ": "; };
  for (const Json& value : values) {
    ++line;
    try {
      use(value);
    } catch (const Json::exception&) {
      throw std::runtime_error(place() + "not what this program writes there");
    } catch (const std::out_of_range& e) {
      throw std::runtime_error(place() + e.what());
    }
  }
}

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
