#include "rectilin/base/printable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace rectilin {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t size = 0;  // in bytes; 0 where the text is not valid UTF-8
};

/// The first character of a text, which must not be empty (RFC 3629: no overlong forms, surrogates or code points
/// above U+10FFFF).
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {};
  std::uint32_t code = lead & (0x7Fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[size] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
  return {code, size};
}

struct Range {
  std::uint32_t first, last;
};

template <std::size_t n>
bool is_in(const std::array<Range, n>& ranges, std::uint32_t code) {
  return std::ranges::any_of(ranges, [code](const Range& r) { return r.first <= code && code <= r.last; });
}

/// Characters that are invisible but change how others are shown, or that XML may not contain.
constexpr std::array<Range, 8> kHidden = {{{0x00, 0x1F},
                                           {0x7F, 0x9F},
                                           {0x200E, 0x200F},
                                           {0x2028, 0x202E},
                                           {0x2066, 0x2069},
                                           {0xFEFF, 0xFEFF},
                                           {0xFFF9, 0xFFFB},
                                           {0xFFFE, 0xFFFF}}};

/// Marks that are drawn over the character before them.
constexpr std::array<Range, 14> kCombining = {{{0x0300, 0x036F},
                                               {0x0483, 0x0489},
                                               {0x0591, 0x05BD},
                                               {0x0610, 0x061A},
                                               {0x064B, 0x065F},
                                               {0x0900, 0x0902},
                                               {0x0E34, 0x0E3A},
                                               {0x0E47, 0x0E4E},
                                               {0x1AB0, 0x1AFF},
                                               {0x1DC0, 0x1DFF},
                                               {0x200B, 0x200D},
                                               {0x20D0, 0x20FF},
                                               {0xFE00, 0xFE0F},
                                               {0xFE20, 0xFE2F}}};

constexpr std::array<Range, 11> kWide = {{{0x1100, 0x115F},
                                          {0x2E80, 0x303E},
                                          {0x3041, 0xA4CF},
                                          {0xA960, 0xA97F},
                                          {0xAC00, 0xD7A3},
                                          {0xF900, 0xFAFF},
                                          {0xFE30, 0xFE6F},
                                          {0xFF00, 0xFF60},
                                          {0xFFE0, 0xFFE6},
                                          {0x1F300, 0x1FAFF},
                                          {0x20000, 0x3FFFD}}};

std::size_t width_of(std::uint32_t code) { return is_in(kCombining, code) ? 0 : is_in(kWide, code) ? 2 : 1; }

std::string escaped(const Character& character, unsigned char byte) {
  if (byte == '\n') return "\\n";
  if (byte == '\r') return "\\r";
  if (byte == '\t') return "\\t";
  char text[16];
  if (character.size <= 1) std::snprintf(text, sizeof text, "\\x%02X", static_cast<unsigned>(byte));
  else std::snprintf(text, sizeof text, "\\u{%X}", static_cast<unsigned>(character.code));
  return text;
}

/// A character with its combining marks: the unit at which text may be cut.
struct Piece {
  std::string_view text;
  std::size_t width;
};

std::vector<Piece> pieces(std::string_view text) {
  std::vector<Piece> all;
  for (std::size_t at = 0; at < text.size();) {
    const Character character = first_character(text.substr(at));
    const std::size_t size = std::max<std::size_t>(character.size, 1), columns = width_of(character.code);
    if (columns == 0 && !all.empty()) {
      const std::size_t before = all.back().text.size();
      all.back().text = text.substr(at - before, before + size);
    } else {
      all.push_back({text.substr(at, size), columns});
    }
    at += size;
  }
  return all;
}

/// The end of the text: as many whole characters as fit into `columns` columns.
std::string_view end_of(std::string_view text, const std::vector<Piece>& all, std::size_t columns) {
  std::size_t taken = 0, bytes = 0;
  for (auto piece = all.rbegin(); piece != all.rend() && taken + piece->width <= columns; ++piece) {
    taken += piece->width;
    bytes += piece->text.size();
  }
  return text.substr(text.size() - bytes);
}

constexpr std::string_view kCut = "..";

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t size = std::max<std::size_t>(character.size, 1);
    if (character.size > 0 && !is_in(kHidden, character.code)) result += text.substr(0, size);
    else result += escaped(character, static_cast<unsigned char>(text.front()));
    text.remove_prefix(size);
  }
  return result;
}

bool is_printable(std::string_view text) { return printable(text) == text; }

std::size_t width(std::string_view text) {
  std::size_t columns = 0;
  for (const Piece& piece : pieces(text)) columns += piece.width;
  return columns;
}

std::string shortened(std::string_view text, std::size_t columns) {
  const std::string shown = printable(text);
  const std::vector<Piece> all = pieces(shown);
  if (width(shown) <= columns) return shown;
  const std::size_t room = columns - kCut.size(), head_room = columns * 3 / 5;
  std::string head;
  std::size_t taken = 0;
  for (const Piece& piece : all) {
    if (taken + piece.width > head_room) break;
    taken += piece.width;
    head += piece.text;
  }
  return head.append(kCut).append(end_of(shown, all, room - taken));
}

std::string shortened_to_end(std::string_view text, std::size_t columns) {
  const std::string shown = printable(text);
  if (width(shown) <= columns) return shown;
  return std::string(kCut).append(end_of(shown, pieces(shown), columns - kCut.size()));
}

}  // namespace rectilin
