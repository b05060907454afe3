// Tables as comma-separated files (RFC 4180). Text is made printable, so that each row is one line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rectilin::report {

class Csv {
 public:
  explicit Csv(std::vector<std::string> columns);

  /// A cell: text, or a number with all its digits. Numbers that are not finite make empty cells.
  struct Cell {
    std::string text;
    Cell(std::string t) : text(std::move(t)) {}
    Cell(const char* t) : text(t) {}
    Cell(double x);
    Cell(int x) : text(std::to_string(x)) {}
    Cell(std::size_t x) : text(std::to_string(x)) {}
  };

  /// As many cells as there are columns.
  void row(const std::vector<Cell>& cells);

  const std::vector<std::string>& columns() const { return columns_; }
  const std::string& text() const { return text_; }

  /// Throws std::runtime_error if the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  void line(const std::vector<std::string>& cells);
  std::vector<std::string> columns_;
  std::string text_;
};

}  // namespace rectilin::report
