// The Object File Format (Geomview manual, "OFF Files"), as text.
#include <optional>

#include "io/soup.h"
#include "io/text.h"

namespace rectilin {
namespace {

struct Keyword {
  bool homogeneous = false;    // '4': each vertex has a fourth coordinate that divides the others
  bool any_dimension = false;  // 'n': the number of coordinates precedes the counts
  std::size_t size = 0;
};

// The keyword [ST][C][N][4][n]OFF at the start of a word. ModelNet glues the first count to it.
std::optional<Keyword> parse_keyword(std::string_view word) {
  Keyword keyword;
  const auto take = [&](std::string_view part) {
    const bool found = word.substr(keyword.size, part.size()) == part;
    if (found) keyword.size += part.size();
    return found;
  };
  take("ST");
  take("C");
  take("N");
  keyword.homogeneous = take("4");
  keyword.any_dimension = take("n");
  const bool found = take("OFF");
  const std::string_view rest = word.substr(keyword.size);
  if (!found || rest.find_first_not_of("0123456789") != std::string_view::npos) return {};
  return keyword;
}

struct OffHeader {
  bool homogeneous;
  std::int64_t vertices;
  std::int64_t faces;
};

// The next integer of the header, which may be on this line or the next one.
std::int64_t header_integer(LineReader& text, std::string_view what) {
  std::string_view word = text.word();
  if (word.empty() && text.next_line()) word = text.word();
  std::int64_t value = 0;
  if (!parse_integer(word, value) || value < 0) text.fail_expected(what, word);
  return value;
}

OffHeader read_off_header(LineReader& text) {
  text.next_line();
  const std::string_view word = text.word();
  const std::optional<Keyword> keyword = parse_keyword(word);
  if (!keyword) text.fail_expected("the keyword OFF", word);
  text.unread(word.size() - keyword->size);

  const std::string_view second = text.word();
  if (second == "BINARY") text.fail("OFF BINARY is not supported, only OFF as text");
  text.unread(second.size());
  if (keyword->any_dimension && header_integer(text, "the number of dimensions") != 3) {
    text.fail("only vertices of three dimensions are supported");
  }

  OffHeader header{keyword->homogeneous, 0, 0};
  header.vertices = header_integer(text, "the number of vertices");
  header.faces = header_integer(text, "the number of faces");
  constexpr std::size_t kShortestVertex = 6, kShortestFace = 2;  // "0 0 0\n" and "0\n"
  const std::size_t most = text.remaining() + 1;
  if (static_cast<std::size_t>(header.vertices) > most / kShortestVertex ||
      static_cast<std::size_t>(header.faces) > most / kShortestFace) {
    text.fail("the header claims " + std::to_string(header.vertices) + " vertices and " + std::to_string(header.faces) +
              " faces, more than the file can hold");
  }
  return header;
}

void next_record(LineReader& text, std::string_view what, std::int64_t index, std::int64_t count) {
  if (text.next_line()) return;
  text.fail("the file ends after " + std::to_string(index) + " of " + std::to_string(count) + " " + std::string(what));
}

// What follows the coordinates on their line are normals, colours and texture coordinates.
Vector3 read_vertex(LineReader& text, bool homogeneous) {
  const double x = text.number("a coordinate");
  const double y = text.number("a coordinate");
  const double z = text.number("a coordinate");
  return Vector3(x, y, z) / (homogeneous ? text.number("a fourth coordinate") : 1.0);
}

// The next corner of a face, which may be on a line further down.
std::string_view next_corner(LineReader& text, bool& continued) {
  std::string_view word = text.word();
  while (word.empty() && text.next_line()) {
    continued = true;
    word = text.word();
  }
  return word;
}

// What follows the corners on their line is a colour. Not so where the corners go over several
// lines: there it rather says that the face has fewer corners than it claims.
void read_face(LineReader& text, std::int64_t vertices, PolygonSoup& soup) {
  const std::int64_t corners = text.integer("the number of corners");
  if (corners < 0) text.fail("a face of " + std::to_string(corners) + " corners");
  bool continued = false;
  for (std::int64_t i = 0; i < corners; ++i) {
    const std::string_view word = next_corner(text, continued);
    std::int64_t index = 0;
    if (!parse_integer(word, index)) text.fail_expected("a vertex index", word);
    if (index < 0 || index >= vertices) {
      text.fail("vertex index " + std::to_string(index) + " is not in 0.." + std::to_string(vertices - 1));
    }
    soup.corners.push_back(static_cast<std::uint32_t>(index));
  }
  const std::string_view rest = continued ? text.word() : std::string_view();
  if (!rest.empty()) text.fail_expected("the end of a face that began on a line above", rest);
  soup.close_polygon();
}

}  // namespace

bool looks_like_off(std::string_view bytes) {
  LineReader text(bytes, {});
  return text.next_line() && parse_keyword(text.word()).has_value();
}

PolygonSoup read_off(std::string_view bytes, const std::string& name) {
  LineReader text(bytes, name);
  const OffHeader header = read_off_header(text);
  PolygonSoup soup;
  soup.vertices.reserve(static_cast<std::size_t>(header.vertices));
  for (std::int64_t i = 0; i < header.vertices; ++i) {
    next_record(text, "vertices", i, header.vertices);
    soup.vertices.push_back(read_vertex(text, header.homogeneous));
  }
  for (std::int64_t i = 0; i < header.faces; ++i) {
    next_record(text, "faces", i, header.faces);
    read_face(text, header.vertices, soup);
  }
  return soup;
}

}  // namespace rectilin
