#include "io/signature.h"

#include <algorithm>
#include <array>

#include "io/text.h"

namespace rectilin {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view beginning, kind;
};

constexpr std::array kBinary = {
    Signature{"\x7F"
              "ELF"sv,
              "a program (ELF)"},
    Signature{"PK\x03\x04"sv, "a ZIP archive (3MF, for one)"},
    Signature{"PK\x05\x06"sv, "an empty ZIP archive"},
    Signature{"\x1F\x8B"sv, "compressed by gzip"},
    Signature{"BZh"sv, "compressed by bzip2"},
    Signature{"\xFD"
              "7zXZ"sv,
              "compressed by xz"},
    Signature{"\x28\xB5\x2F\xFD"sv, "compressed by zstd"},
    Signature{"7z\xBC\xAF"sv, "a 7z archive"},
    Signature{"Rar!"sv, "a RAR archive"},
    Signature{"\x89PNG"sv, "a picture (PNG)"},
    Signature{"\xFF\xD8\xFF"sv, "a picture (JPEG)"},
    Signature{"GIF8"sv, "a picture (GIF)"},
    Signature{"%PDF"sv, "a PDF document"},
    Signature{"glTF"sv, "a glTF file"},
    Signature{"Kaydara FBX"sv, "an FBX file"},
    Signature{"BLENDER"sv, "a Blender file"},
    Signature{"\0\x05\x16\x07"sv, "a resource fork of macOS (AppleDouble)"},
    Signature{"\0\x05\x16\0"sv, "a resource fork of macOS (AppleSingle)"},
    Signature{"SQLite format 3"sv, "a data base (SQLite)"},
    Signature{"\xFF\xFE"sv, "UTF-16 text, which is not supported"},
    Signature{"\xFE\xFF"sv, "UTF-16 text, which is not supported"},
};

// White space may precede these, and their letters may be large or small.
constexpr std::array kText = {
    Signature{"version https://git-lfs", "a pointer of Git LFS, not the file itself"},
    Signature{"/annex/objects/", "a pointer of git-annex, not the file itself"},
    Signature{"iso-10303-21", "a STEP file"},
    Signature{"<!doctype html", "a web page (HTML)"},
    Signature{"<html", "a web page (HTML)"},
    Signature{"<?xml", "an XML document"},
    Signature{"<svg", "a picture (SVG)"},
    Signature{"#vrml", "a VRML file"},
    Signature{"{\"", "a JSON document"},
};

bool begins_with(std::string_view text, std::string_view small_letters) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return text.size() >= small_letters.size() && std::equal(small_letters.begin(), small_letters.end(), text.begin(),
                                                           [&](char expected, char c) { return lower(c) == expected; });
}

// Letters with a NUL beside each, and no mark at the beginning that says so.
bool is_utf16_without_mark(std::string_view bytes) {
  constexpr std::size_t kLooked = 32;
  if (bytes.size() < kLooked) return false;
  for (const std::size_t nul : {0, 1}) {
    bool found = true;
    for (std::size_t i = 0; i < kLooked && found; ++i) {
      const auto byte = static_cast<unsigned char>(bytes[i]);
      found = i % 2 == nul ? byte == 0 : byte >= '\t' && byte < 0x7F;
    }
    if (found) return true;
  }
  return false;
}

}  // namespace

std::string_view foreign_kind(std::string_view bytes) {
  constexpr std::size_t kTarPlace = 257;
  if (bytes.size() > kTarPlace && bytes.substr(kTarPlace).starts_with("ustar")) return "a TAR archive";
  if (is_utf16_without_mark(bytes)) return "UTF-16 text, which is not supported";
  for (const Signature& s : kBinary)
    if (bytes.starts_with(s.beginning)) return s.kind;
  bytes = without_byte_order_mark(bytes);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  for (const Signature& s : kText)
    if (begins_with(bytes, s.beginning)) return s.kind;
  return {};
}

}  // namespace rectilin
