#include "rectilin/report/csv.h"

#include <charconv>
#include <cmath>

#include "rectilin/base/printable.h"
#include "rectilin/base/whole_file.h"

namespace rectilin::report {

Csv::Csv(std::vector<std::string> columns) : columns_(std::move(columns)) { line(columns_); }

Csv::Cell::Cell(double x) {
  if (!std::isfinite(x)) return;
  char digits[32];
  text.assign(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
}

void Csv::row(const std::vector<Cell>& cells) {
  if (cells.size() != columns_.size()) throw std::logic_error("a row of another width than its table");
  std::vector<std::string> texts;
  for (const Cell& cell : cells) texts.push_back(cell.text);
  line(texts);
}

void Csv::line(const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text_ += ',';
    const std::string cell = printable(cells[i]);
    if (cell.find_first_of(",\"") == std::string::npos) {
      text_ += cell;
      continue;
    }
    text_ += '"';
    for (const char c : cell) text_ += c == '"' ? std::string("\"\"") : std::string(1, c);
    text_ += '"';
  }
  text_ += '\n';
}

void Csv::write(const std::filesystem::path& file) const { write_whole_file(file, text_); }

}  // namespace rectilin::report
