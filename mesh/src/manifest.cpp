#include "manifest.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "io/text.h"
#include "rectilin/base/whole_file.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& file, std::size_t line, const std::string& reason) {
  throw MeshError(file + ":line " + std::to_string(line) + ": " + reason);
}

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(kBlank) - begin + 1));
}

/// A row of a CSV text (RFC 4180), with the number of the line that it begins in.
struct Row {
  std::size_t line;
  std::vector<std::string> cells;
};

std::vector<Row> csv_rows(std::string_view text, const std::string& file) {
  std::vector<Row> rows;
  Row row{1, {}};
  std::string cell;
  std::size_t line = 1;
  bool quoted = false;
  const auto end_row = [&] {
    row.cells.push_back(std::move(cell));
    cell.clear();
    if (row.cells.size() > 1 || !trimmed(row.cells[0]).empty()) rows.push_back(std::move(row));
    row = {line, {}};
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    line += c == '\n';
    if (quoted) {
      if (c != '"') cell += c;
      else if (i + 1 < text.size() && text[i + 1] == '"') cell += text[++i];
      else quoted = false;
    } else if (c == '"' && cell.empty()) {
      quoted = true;
    } else if (c == ',') {
      row.cells.push_back(std::move(cell));
      cell.clear();
    } else if (c == '\n') {
      end_row();
    } else if (c != '\r') {
      cell += c;
    }
  }
  if (quoted) fail(file, row.line, "a quotation that does not end");
  end_row();
  return rows;
}

std::optional<std::size_t> column_of(const Row& header, std::initializer_list<std::string_view> names) {
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    std::string title = trimmed(header.cells[i]);
    std::ranges::transform(title, title.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::ranges::find(names, title) != names.end()) return i;
  }
  return std::nullopt;
}

std::vector<NamedSource> from_csv(std::string_view text, const std::string& file) {
  const std::vector<Row> rows = csv_rows(text, file);
  if (rows.empty()) throw MeshError(file + ": the list is empty");
  const auto source = column_of(rows[0], {"source", "path", "file"});
  const auto name = column_of(rows[0], {"name", "id"}), group = column_of(rows[0], {"class", "category", "label"});
  if (!source) fail(file, 1, "expected the titles of columns, one of them 'source', 'path' or 'file'");
  std::vector<NamedSource> entries;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto cell = [&](std::optional<std::size_t> column) {
      return column && *column < rows[i].cells.size() ? trimmed(rows[i].cells[*column]) : std::string();
    };
    NamedSource entry{cell(name), cell(source), cell(group)};
    if (entry.source.empty()) fail(file, rows[i].line, "no source in this row");
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// Reads one source a line, with its class after a tab. A # at the beginning of a word starts a comment.
std::vector<NamedSource> from_text(std::string_view text, const std::string&) {
  std::vector<NamedSource> entries;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
      if (at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t') line = line.substr(0, at);
    }
    const std::size_t tab = line.find('\t');
    NamedSource entry{{}, trimmed(line.substr(0, tab)), tab == std::string_view::npos ? "" : trimmed(line.substr(tab))};
    if (!entry.source.empty()) entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace

bool is_manifest_name(std::string_view file) {
  const std::string extension = fs::path(file).extension().string();
  return extension == ".txt" || extension == ".lst" || extension == ".csv";
}

std::vector<NamedSource> read_manifest(const std::string& file) {
  std::string content;
  try {
    content = read_whole_file(file);
  } catch (const std::runtime_error& e) {
    throw MeshError(e.what());
  }
  std::string_view text = content;
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw MeshError(file + ": a list in UTF-16 is not supported, only UTF-8");
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
    fail(file, 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, nul), '\n')),
         "a NUL character in a list");
  text = without_byte_order_mark(text);
  auto entries = fs::path(file).extension() == ".csv" ? from_csv(text, file) : from_text(text, file);
  const fs::path folder = fs::path(file).parent_path();
  for (NamedSource& entry : entries) {
    if (entry.name.empty()) entry.name = entry.source;
    if (!is_shape_source(entry.source)) entry.source = (folder / entry.source).string();
  }
  return entries;
}

}  // namespace rectilin
