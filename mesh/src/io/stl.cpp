// Stereolithography files (3D Systems, StereoLithography Interface Specification, 1989).
#include <algorithm>
#include <utility>

#include "io/bytes.h"
#include "io/left_over.h"
#include "io/soup.h"
#include "io/text.h"

namespace rectilin {
namespace {

constexpr std::size_t kHeaderSize = 80, kPrefixSize = 84, kTriangleSize = 50;

// How many triangles a binary file claims. The file must have a whole prefix.
std::size_t claimed_triangles(std::string_view bytes) {
  return ByteReader(bytes, kHeaderSize, std::endian::little, {}).read<std::uint32_t>();
}

std::size_t binary_size(std::size_t triangles) { return kPrefixSize + kTriangleSize * triangles; }

// Exporters write "solid" into binary headers too; only the size tells.
bool has_binary_size(std::string_view bytes) {
  return bytes.size() >= kPrefixSize && bytes.size() == binary_size(claimed_triangles(bytes));
}

bool is_text(std::string_view bytes) {
  MeshReport ignored;
  LineReader text(bytes, {});
  if (!text.next_line() || !is_keyword(text.word(), "solid")) return false;
  if (without_padding(bytes, ignored).find('\0') == std::string_view::npos) return true;
  // Binary files may begin so, too; text that somebody has damaged goes on as text.
  for (int i = 0; i < 64; ++i)
    if (is_keyword(text.next_word(), "facet")) return true;
  return false;
}

void append_corner(PolygonSoup& soup, const Vector3& position) {
  soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
  soup.vertices.push_back(position);
}

// Why a file is not of the size its count of triangles demands: each is something that happens to files.

// Copied as text to a system whose lines end with CR LF.
bool is_text_mode_copy(std::string_view bytes) {
  std::string before;
  before.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] == '\n' && (before.empty() || before.back() != '\r')) return false;
    if (bytes[i] == '\n') before.back() = '\n';
    else before += bytes[i];
  }
  return before.size() < bytes.size() && has_binary_size(before);
}

// How many whole files stand one behind the other; 0 if that is not what the bytes are.
std::size_t count_files(std::string_view bytes) {
  std::size_t files = 0;
  while (!bytes.empty()) {
    if (bytes.size() < kPrefixSize || bytes.size() < binary_size(claimed_triangles(bytes))) return 0;
    bytes.remove_prefix(binary_size(claimed_triangles(bytes)));
    ++files;
  }
  return files;
}

// Whether so many bytes as each triangle's last two say follow it.
bool has_payloads(std::string_view bytes) {
  std::size_t place = kPrefixSize;
  for (std::size_t left = claimed_triangles(bytes); left > 0; --left) {
    place += kTriangleSize;
    if (place > bytes.size()) return false;
    place += ByteReader(bytes, place - sizeof(std::uint16_t), std::endian::little, {}).read<std::uint16_t>();
  }
  return place == bytes.size();
}

bool is_all_text(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(),
                     [](unsigned char c) { return (c >= 0x20 && c != 0x7F) || (c >= '\t' && c <= '\r'); });
}

// Accounts for every byte of a file that is not of the size it should have: returns if what is too much is padding.
void explain_size(std::string_view bytes, const std::string& name, MeshReport& report) {
  const auto refuse = [&](const std::string& reason) { throw MeshError(name + ": " + reason); };
  if (is_all_text(bytes.substr(0, 512))) refuse("neither text that begins with 'solid' nor a binary STL file");
  const std::size_t claimed = claimed_triangles(bytes), held = (bytes.size() - kPrefixSize) / kTriangleSize;
  if (is_text_mode_copy(bytes)) refuse("a binary STL file that was copied as text: there is a CR before every LF");
  if (claimed > held) {
    throw MeshError(name + ":byte " + std::to_string(kPrefixSize) + ": the header claims " + std::to_string(claimed) +
                    " triangles, the file holds " + std::to_string(held));
  }
  const std::string_view rest = bytes.substr(binary_size(claimed));
  if (claimed > 0 && is_padding(rest)) return report_left_over(rest, binary_size(claimed), report);
  if (const std::size_t files = claimed > 0 ? count_files(bytes) : 0; files > 1)
    refuse(std::to_string(files) + " binary STL files one behind the other");
  if (claimed > 0 && has_payloads(bytes)) refuse("a binary STL file with more data behind each triangle");
  throw MeshError(name + ":byte " + std::to_string(binary_size(claimed)) + ": the header claims " +
                  std::to_string(claimed) + " triangles, but " + std::to_string(rest.size()) + " bytes follow them");
}

PolygonSoup read_binary(std::string_view bytes, const std::string& name) {
  PolygonSoup soup;
  ByteReader data(bytes, std::min(kHeaderSize, bytes.size()), std::endian::little, name);
  const std::size_t triangles = data.read<std::uint32_t>();
  if (!has_binary_size(bytes)) explain_size(bytes, name, soup.report);
  soup.weld = true;
  soup.vertices.reserve(3 * triangles);
  soup.corners.reserve(3 * triangles);
  soup.ends.reserve(triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    data.skip(3 * sizeof(float));  // the normal
    for (int corner = 0; corner < 3; ++corner) {
      const float x = data.read<float>(), y = data.read<float>(), z = data.read<float>();
      append_corner(soup, Vector3(x, y, z));
    }
    data.skip(sizeof(std::uint16_t));  // attributes
    soup.close_polygon();
  }
  return soup;
}

// Reads STL as text: words in a fixed order, wherever lines end. Only names end with their line.
class TextFile {
 public:
  TextFile(std::string_view bytes, const std::string& name) : text_(without_padding(bytes, soup_.report), name) {
    soup_.weld = true;
  }

  PolygonSoup read() {
    if (const std::size_t nul = text_.rest().find('\0'); nul != std::string_view::npos) {
      const std::string_view before = text_.rest().substr(0, nul);
      text_.fail(1 + static_cast<std::size_t>(std::ranges::count(before, text_.line_ending())),
                 "a NUL character within the text");
    }
    bool in_solid = false;
    for (std::string_view word = keyword(); !word.empty(); word = keyword()) {
      if (in_solid && is_keyword(word, "facet")) {
        read_facet();
      } else if (!in_solid && is_keyword(word, "solid")) {
        in_solid = true;
        pass_name();
      } else if (in_solid && is_keyword(word, "endsolid")) {
        in_solid = false;
        pass_name();
      } else {
        text_.fail_expected(in_solid ? "facet or endsolid" : "solid", word);
      }
    }
    if (in_solid) text_.fail("the file ends before endsolid");
    return std::move(soup_);
  }

 private:
  // The next word; "end solid", "end facet", "end loop" and "outer loop" as one.
  std::string_view keyword() {
    const std::string_view word = text_.next_word();
    if (is_keyword(word, "outer")) {
      pass_if([](std::string_view next) { return is_keyword(next, "loop"); });
      return word;
    }
    if (!is_keyword(word, "end")) return word;
    const std::string_view what = text_.next_word();
    if (is_keyword(what, "solid")) return "endsolid";
    if (is_keyword(what, "facet")) return "endfacet";
    if (is_keyword(what, "loop")) return "endloop";
    text_.fail_expected("solid, facet or loop after end", what);
  }

  std::string_view ahead() const {
    LineReader copy = text_;
    return copy.next_word();
  }

  // Passes over the next word if it is one of those.
  template <class Is>
  bool pass_if(const Is& is) {
    LineReader behind = text_;
    if (!is(behind.next_word())) return false;
    text_ = behind;
    return true;
  }

  // The rest of the line is a name, but for what can only be the next facet, the end or the next solid, where all
  // stands on one line.
  void pass_name() {
    find_last_marker();
    while (true) {
      LineReader next = text_;
      const std::string_view word = next.word();
      if (word.empty()) return;
      const bool marker_follows = next.offset() <= last_marker_;
      if (marker_follows && (is_keyword(word, "endsolid") || is_keyword(word, "solid") || begins_facet(word, next)))
        return;
      text_ = next;
    }
  }

  static bool begins_facet(std::string_view word, LineReader behind) {
    return is_keyword(word, "facet") && is_keyword(behind.word(), "normal");
  }

  // Sets last_marker_ to the end of the last word on this line that begins a facet or ends a solid. Once for each line,
  // however many names it has.
  void find_last_marker() {
    if (text_.line() == marked_line_) return;
    marked_line_ = text_.line();
    last_marker_ = 0;
    LineReader next = text_;
    for (std::string_view word = next.word(); !word.empty(); word = next.word())
      if (is_keyword(word, "endsolid") || begins_facet(word, next)) last_marker_ = next.offset();
  }

  void read_facet() {
    const auto is_normal = [](std::string_view word) { return is_keyword(word, "normal"); };
    const auto is_part = [](std::string_view word) { return !begins_corners(word); };  // whatever it says
    int parts = 0;
    if (pass_if(is_normal))
      while (parts < 3 && pass_if(is_part)) ++parts;
    const std::size_t before = soup_.ends.size();
    while (true) {
      const std::string_view word = keyword();
      if (is_keyword(word, "vertex")) {
        read_vertices();
      } else if (is_keyword(word, "endfacet")) {
        break;
      } else if (is_keyword(word, "endloop")) {
        close_loop();
      } else if (word.empty()) {
        text_.fail("the file ends within a facet");
      } else if (!is_keyword(word, "outer") && !is_keyword(word, "outerloop")) {
        text_.fail_expected("a vertex or endfacet", word);
      }
    }
    if (corners_since_loop() > 0 || soup_.ends.size() == before) close_loop();
  }

  std::size_t corners_since_loop() const { return soup_.corners.size() - (soup_.ends.empty() ? 0 : soup_.ends.back()); }

  // Each loop is a polygon: a facet has one as a rule.
  void close_loop() {
    soup_.report.odd_facets += corners_since_loop() != 3;
    soup_.close_polygon();
  }

  static bool begins_corners(std::string_view word) {
    return word.empty() || is_keyword(word, "outer") || is_keyword(word, "outerloop") || is_keyword(word, "vertex");
  }

  // One vertex, or all three behind one keyword.
  void read_vertices() {
    read_vertex();
    double number = 0;
    if (!parse_number(ahead(), number)) return;
    read_vertex();
    read_vertex();
  }

  void read_vertex() {
    const double x = text_.next_number("a coordinate");
    const double y = text_.next_number("a coordinate");
    const double z = text_.next_number("a coordinate");
    append_corner(soup_, Vector3(x, y, z));
  }

  PolygonSoup soup_;
  LineReader text_;
  std::size_t marked_line_ = 0, last_marker_ = 0;
};

}  // namespace

bool looks_like_stl(std::string_view bytes) { return has_binary_size(bytes) || is_text(bytes); }

bool is_binary_stl(std::string_view bytes) { return has_binary_size(bytes); }

PolygonSoup read_stl(std::string_view bytes, const std::string& name) {
  return !has_binary_size(bytes) && is_text(bytes) ? TextFile(bytes, name).read() : read_binary(bytes, name);
}

}  // namespace rectilin
