#include "rectilin/base/journal.h"

#include <cerrno>
#include <stdexcept>
#include <string>

#include "rectilin/base/system_reason.h"

namespace rectilin {

std::vector<Json> recover_journal(const std::filesystem::path& file) {
  std::vector<Json> values;
  std::uintmax_t whole = 0;  // size of all complete lines, in bytes
  {
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (!in && errno != ENOENT) throw std::runtime_error(file.string() + ": " + system_reason(errno));
    for (std::string line; std::getline(in, line) && !in.eof();) {  // eof(): the line has no newline, so it was cut off
      values.push_back(parse_json_or_null(line));
      if (values.back().is_null())
        throw std::runtime_error(file.string() + ":line " + std::to_string(values.size()) + ": not JSON");
      whole += line.size() + 1;
    }
  }
  if (std::filesystem::exists(file) && std::filesystem::file_size(file) > whole)
    std::filesystem::resize_file(file, whole);
  return values;
}

Journal::Journal(const std::filesystem::path& file) : file_(file), stream_(file, std::ios::app | std::ios::binary) {
  if (!stream_) throw std::runtime_error(file.string() + ": cannot be written: " + system_reason(errno));
}

void Journal::append(const Json& value) {
  errno = 0;
  stream_ << to_text(value) + '\n' << std::flush;
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written: " + system_reason(errno));
}

}  // namespace rectilin
