#include "io/left_over.h"

namespace rectilin {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kSpace = " \t\v\f\r\n";
constexpr std::string_view kPadding = " \t\v\f\r\n\0\x1A"sv;

std::string_view without_tail(std::string_view bytes, std::string_view tail) {
  return bytes.substr(0, bytes.find_last_not_of(tail) + 1);
}

}  // namespace

bool is_padding(std::string_view bytes) { return without_tail(bytes, kPadding).empty(); }

std::string_view without_padding(std::string_view text, MeshReport& report) {
  const std::string_view rest = text.substr(without_tail(text, kPadding).size());
  const std::size_t first = rest.find_first_not_of(kSpace);  // the end of the last line is part of the text
  if (first == std::string_view::npos) return text;
  report.padding_bytes = rest.size() - first;
  return text.substr(0, text.size() - report.padding_bytes);
}

void report_left_over(LineReader& text, MeshReport& report) {
  if (!text.next_line()) return;
  report.left_over_bytes = without_tail(text.rest(), kSpace).size();
  report.left_over_place = "line " + std::to_string(text.line());
}

void report_left_over(std::string_view bytes, std::size_t place, MeshReport& report) {
  if (bytes.empty()) return;
  if (is_padding(bytes)) {
    report.padding_bytes = bytes.size();
    return;
  }
  report.left_over_bytes = bytes.size();
  report.left_over_place = "byte " + std::to_string(place);
}

}  // namespace rectilin
