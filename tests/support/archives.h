// Archives made for tests.
#pragma once

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rectilin::test {

using Members = std::vector<std::pair<std::string, std::string>>;  ///< names and contents

/// Writes an archive of the kind that the file's extensions tell: .zip, .7z, .tar, .tar.gz, .tar.xz; or, for .gz and
/// .xz, one compressed file.
inline void write_archive(const std::filesystem::path& file, const Members& members) {
  static const locale_t utf8 = newlocale(LC_CTYPE_MASK, "C.UTF-8", locale_t{});
  const locale_t before = uselocale(utf8);
  archive* a = archive_write_new();
  const std::string name = file.string();
  const bool packed = name.ends_with(".gz") || name.ends_with(".xz");
  if (!packed) {
    archive_write_set_format_filter_by_ext(a, name.c_str());
  } else if (name.find(".tar.") != std::string::npos) {
    archive_write_set_format_pax_restricted(a);
  } else {
    archive_write_set_format_raw(a);
  }
  if (packed) (name.ends_with(".gz") ? archive_write_add_filter_gzip : archive_write_add_filter_xz)(a);
  bool good = archive_write_open_filename(a, name.c_str()) == ARCHIVE_OK;
  for (const auto& [path, content] : members) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname_utf8(entry, path.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    good = good && archive_write_header(a, entry) >= ARCHIVE_WARN;
    good = good && archive_write_data(a, content.data(), content.size()) == static_cast<la_ssize_t>(content.size());
    archive_entry_free(entry);
  }
  good = archive_write_close(a) == ARCHIVE_OK && good;
  archive_write_free(a);
  uselocale(before);
  if (!good) throw std::runtime_error(name + ": the test's archive cannot be written");
}

}  // namespace rectilin::test
