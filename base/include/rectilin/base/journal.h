// A file with one JSON value a line, appended to while work is done. It stays readable if the program ends at any
// moment: at worst its last line is cut off.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "rectilin/base/parameters.h"

namespace rectilin {

/// Reads the values of a journal's lines; none if there is no file. If the last line was cut off, it is removed from
/// the file, so that new lines can be appended. Throws std::runtime_error for any other line that is not JSON.
std::vector<Json> recover_journal(const std::filesystem::path& file);

/// Calls `use(value)` for each value of a journal, in order. If `use` throws Json::exception or std::out_of_range,
/// because the value is not of the form that it expects, that becomes a std::runtime_error that names the file and
/// the line.
template <class Use>
void for_each_line(const std::filesystem::path& file, const std::vector<Json>& values, const Use& use) {
  std::size_t line = 0;
  const auto place = [&] { return file.string() + ":line " + std::to_string(line) + ": "; };
  for (const Json& value : values) {
    ++line;
    try {
      use(value);
    } catch (const Json::exception&) {
      throw std::runtime_error(place() + "not a line that this program writes");
    } catch (const std::out_of_range& e) {
      throw std::runtime_error(place() + e.what());
    }
  }
}

/// Appends lines to a journal. Not thread safe.
class Journal {
 public:
  /// Throws std::runtime_error if the file cannot be opened.
  explicit Journal(const std::filesystem::path& file);

  /// Appends one line and hands it to the operating system at once. Throws std::runtime_error if that fails.
  void append(const Json& value);

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace rectilin
