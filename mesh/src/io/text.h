// Words and numbers of a text file in memory, and errors that name the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rectilin {

/// Walks over the lines of a text and the words of a line. Lines end with LF, CRLF or CR; a word
/// ends at a blank or at '#', which hides the rest of its line (but not in "1.#IND"). A UTF-8 byte
/// order mark is skipped. Refers to the text and the name without copying them.
class LineReader {
 public:
  enum class Continuation { kNone, kBackslash };

  LineReader(std::string_view text, std::string_view name, Continuation continuation = Continuation::kNone);

  /// Goes to the next line that has a word; false at the end of the text.
  bool next_line();

  /// The next word of the line, empty at its end. After a backslash at the end of a line (if that
  /// continues it) words come from the line below.
  std::string_view word();

  /// The next word on this line or one below; empty at the end of the text.
  std::string_view next_word();

  /// The next word as a number. "nan", "inf", "1.#IND" and the like are numbers, and so is what
  /// only overflows a double. `what` completes the error "expected ..., found ...".
  double number(std::string_view what);
  /// The same, on this line or one below.
  double next_number(std::string_view what);
  std::int64_t integer(std::string_view what);

  /// The same place in a text that ends earlier, but not before it.
  LineReader within(std::string_view text) const;

  /// Gives back the last `characters` of the word just read.
  void unread(std::size_t characters) { position_ -= characters; }

  /// Byte offset of the next character, and how many there are from it on.
  std::size_t offset() const { return position_; }
  std::size_t remaining() const { return text_.size() - position_; }
  /// All from the next character on.
  std::string_view rest() const { return text_.substr(position_); }
  /// The last character of the line ending before this line: CR in files that know nothing else.
  char line_ending() const { return line_ending_; }
  std::size_t line() const { return line_; }

  /// Throws MeshError with the current line, or another one.
  [[noreturn]] void fail(const std::string& reason) const { fail(line_, reason); }
  [[noreturn]] void fail(std::size_t line, const std::string& reason) const;
  [[noreturn]] void fail_expected(std::string_view what, std::string_view found) const;

 private:
  double number_of(std::string_view found, std::string_view what) const;
  bool at_line_end() const;
  void skip_blanks();
  void skip_to_line_end();
  void skip_line_ending();

  std::string_view text_;
  std::string_view name_;
  Continuation continuation_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  char line_ending_ = '\n';
  bool started_ = false;
};

/// The text behind the mark that some programs write in front of UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// A word in quotes as fit for a one-line error: shortened, without control characters.
std::string quoted(std::string_view word);

/// Whether a word is a keyword given in lower case, whatever the word's case.
bool is_keyword(std::string_view word, std::string_view keyword);

/// Parses a number as LineReader::number() understands it; false if the word is none.
bool parse_number(std::string_view word, double& value);

/// Parses an optional sign and an integer that makes up the whole word; false if it is none.
bool parse_integer(std::string_view word, std::int64_t& value);

}  // namespace rectilin
