#include "io/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "rectilin/mesh/mesh.h"

namespace rectilin {
namespace {

/// What a character is to a reader of words. One look in a table a character: files are mostly such looks.
enum class Kind : unsigned char { kInWord, kBlank, kLineEnd, kHash };

constexpr std::array<Kind, 256> kKinds = [] {
  std::array<Kind, 256> kinds{};
  for (const unsigned char c : {' ', '\t', '\v', '\f'}) kinds[c] = Kind::kBlank;
  for (const unsigned char c : {'\n', '\r'}) kinds[c] = Kind::kLineEnd;
  kinds[static_cast<unsigned char>('#')] = Kind::kHash;
  return kinds;
}();

Kind kind_of(char c) { return kKinds[static_cast<unsigned char>(c)]; }

// from_chars knows no leading plus.
std::string_view without_plus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return plus ? word.substr(1) : word;
}

// What a number means that from_chars finds out of range: it is either too large or too close to 0.
double out_of_range_value(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  const bool tiny =
      exponent != std::string_view::npos ? word[exponent + 1] == '-' : word.find_first_of("123456789") > word.find('.');
  return tiny ? 0.0 : std::numeric_limits<double>::infinity();
}

// The rest of "1.#INF", "1.#IND", "1.#QNAN" or "1.#SNAN", as Windows long wrote what is not finite.
bool is_windows_nonfinite(std::string_view rest) {
  return rest.starts_with("#INF") || rest.starts_with("#IND") || rest.starts_with("#QNAN") || rest.starts_with("#SNAN");
}

}  // namespace

std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c > 0x7E; }, '?');
  return "'" + text + (word.size() > kLongest ? "...'" : "'");
}

bool is_keyword(std::string_view word, std::string_view keyword) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [&](char c, char expected) { return lower(c) == expected; });
}

bool parse_number(std::string_view word, double& value) {
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value);
  if (result.ec == std::errc::invalid_argument) return false;
  if (result.ec == std::errc::result_out_of_range) value = out_of_range_value(digits);
  if (result.ptr == end) return true;
  value = std::numeric_limits<double>::quiet_NaN();
  return is_windows_nonfinite(std::string_view(result.ptr, end));
}

bool parse_integer(std::string_view word, std::int64_t& value) {
  constexpr std::size_t kSafeDigits = 18;  // which fit, so that nothing has to be checked but that they are digits
  if (!word.empty() && word.size() <= kSafeDigits) {
    std::uint64_t sum = 0;
    bool digits_only = true;
    for (const char c : word) {
      const unsigned digit = static_cast<unsigned char>(c) - static_cast<unsigned>('0');
      digits_only = digits_only && digit < 10;
      sum = 10 * sum + digit;
    }
    if (digits_only) {
      value = static_cast<std::int64_t>(sum);
      return true;
    }
  }
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

LineReader::LineReader(std::string_view text, std::string_view name, Continuation continuation)
    : text_(text), name_(name), continuation_(continuation) {
  position_ = text.size() - without_byte_order_mark(text).size();
}

LineReader LineReader::within(std::string_view text) const {
  LineReader reader = *this;
  reader.text_ = text;
  return reader;
}

bool LineReader::at_line_end() const {
  return position_ == text_.size() || kind_of(text_[position_]) == Kind::kLineEnd;
}

void LineReader::skip_blanks() {
  std::size_t at = position_;
  while (at < text_.size() && kind_of(text_[at]) == Kind::kBlank) ++at;
  position_ = at;
}

void LineReader::skip_to_line_end() {
  std::size_t at = position_;
  while (at < text_.size() && kind_of(text_[at]) != Kind::kLineEnd) ++at;
  position_ = at;
}

void LineReader::skip_line_ending() {
  const bool two = text_.substr(position_, 2) == "\r\n";
  position_ += two ? 2 : 1;
  line_ending_ = text_[position_ - 1];
  if (position_ < text_.size()) ++line_;  // the last line's ending begins no line
}

bool LineReader::next_line() {
  // The rest of the current line goes first, then lines that are empty or all comment.
  bool skip = started_;
  started_ = true;
  while (true) {
    if (!skip) skip_blanks();
    if (!skip && !at_line_end() && text_[position_] != '#') return true;
    skip_to_line_end();
    if (position_ == text_.size()) return false;
    skip_line_ending();
    skip = false;
  }
}

std::string_view LineReader::word() {
  skip_blanks();
  const std::size_t begin = position_;
  std::size_t at = begin;
  for (; at < text_.size(); ++at) {
    const Kind kind = kind_of(text_[at]);
    if (kind == Kind::kInWord) continue;
    if (kind != Kind::kHash || at == begin || text_[at - 1] != '.') break;  // "1.#IND" goes on
  }
  position_ = at;
  const std::string_view found(text_.data() + begin, at - begin);
  if (continuation_ == Continuation::kBackslash && found.ends_with('\\')) {
    const std::string_view before = found.substr(0, found.size() - 1);
    if (!before.empty()) {
      unread(1);
      return before;
    }
    skip_blanks();
    if (!at_line_end()) fail_expected("a line end after a backslash", text_.substr(position_, 1));
    if (position_ == text_.size()) return {};
    skip_line_ending();
    return word();
  }
  return found;
}

std::string_view LineReader::next_word() {
  std::string_view found = word();
  while (found.empty() && next_line()) found = word();
  return found;
}

double LineReader::number(std::string_view what) { return number_of(word(), what); }
double LineReader::next_number(std::string_view what) { return number_of(next_word(), what); }

double LineReader::number_of(std::string_view found, std::string_view what) const {
  double value = 0;
  if (!parse_number(found, value)) fail_expected(what, found);
  return value;
}

std::int64_t LineReader::integer(std::string_view what) {
  const std::string_view found = word();
  std::int64_t value = 0;
  if (!parse_integer(found, value)) fail_expected(what, found);
  return value;
}

void LineReader::fail(std::size_t line, const std::string& reason) const {
  throw MeshError(std::string(name_) + ":line " + std::to_string(line) + ": " + reason);
}

void LineReader::fail_expected(std::string_view what, std::string_view found) const {
  const std::string end = remaining() == 0 ? "the end of the file" : "the end of the line";
  fail("expected " + std::string(what) + ", found " + (found.empty() ? end : quoted(found)));
}

}  // namespace rectilin
