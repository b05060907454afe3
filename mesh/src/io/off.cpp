// The Object File Format (Geomview manual, "OFF Files"), as text.
#include <optional>

#include "io/left_over.h"
#include "io/soup.h"
#include "io/text.h"

namespace rectilin {
namespace {

struct Keyword {
  bool homogeneous = false;    // '4': each vertex has a fourth coordinate that divides the others
  bool any_dimension = false;  // 'n': the number of coordinates precedes the counts
  std::size_t size = 0;
};

// The keyword [ST][C][N][4][n]OFF at the start of a word, in capitals or small letters. ModelNet glues the first count
// to it. Small letters cannot tell N (normals) from n (dimensions), so that "noff" is none.
std::optional<Keyword> parse_keyword(std::string_view word) {
  Keyword keyword;
  const auto take = [&](std::string_view part) {
    const bool found = is_keyword(word.substr(keyword.size, part.size()), part);
    if (found) keyword.size += part.size();
    return found;
  };
  take("st");
  take("c");
  const bool large = word.substr(keyword.size).starts_with("N") && take("n");
  keyword.homogeneous = take("4");
  const bool small = word.substr(keyword.size).starts_with("n") && take("n");
  keyword.any_dimension = small;
  const bool capitals = word.substr(keyword.size).starts_with("O");
  const bool found = take("off") && !(small && !capitals) && !(large && !capitals);
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

// The number of edges, which nobody needs: on the line of the other counts, or alone on the next one, where a vertex
// would have more numbers. Nothing else may follow the counts on their line.
void pass_edges(LineReader& text) {
  std::string_view word = text.word();
  if (word.empty()) {
    LineReader ahead = text;
    std::int64_t edges = 0;
    const bool alone = ahead.next_line() && parse_integer(ahead.word(), edges) && ahead.word().empty();
    if (alone) text = ahead;
    return;
  }
  std::int64_t edges = 0;
  if (!parse_integer(word, edges)) text.fail_expected("the number of edges", word);
  word = text.word();
  if (!word.empty()) text.fail_expected("the end of the line of counts", word);
}

// Without a keyword a file is OFF if it begins with the counts.
Keyword read_keyword(LineReader& text) {
  const std::string_view word = text.word();
  std::int64_t vertices = 0;
  std::optional<Keyword> keyword = parse_keyword(word);
  if (!keyword && parse_integer(word, vertices)) keyword = Keyword();
  if (!keyword) text.fail_expected("the keyword OFF", word);
  text.unread(word.size() - keyword->size);
  return *keyword;
}

OffHeader read_off_header(LineReader& text) {
  text.next_line();
  const Keyword keyword = read_keyword(text);
  const std::string_view second = text.word();
  if (is_keyword(second, "binary")) text.fail("OFF BINARY is not supported, only OFF as text");
  text.unread(second.size());
  if (keyword.any_dimension && header_integer(text, "the number of dimensions") != 3) {
    text.fail("only vertices of three dimensions are supported");
  }

  OffHeader header{keyword.homogeneous, 0, 0};
  header.vertices = header_integer(text, "the number of vertices");
  header.faces = header_integer(text, "the number of faces");
  constexpr std::size_t kShortestVertex = 6, kShortestFace = 2;  // "0 0 0\n" and "0\n"
  const std::size_t most = text.remaining() + 1;
  if (static_cast<std::size_t>(header.vertices) > most / kShortestVertex ||
      static_cast<std::size_t>(header.faces) > most / kShortestFace) {
    text.fail("the header claims " + std::to_string(header.vertices) + " vertices and " + std::to_string(header.faces) +
              " faces, more than the file can hold");
  }
  pass_edges(text);
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

// What follows the corners on their line is a colour. Not so where the corners go over several
// lines: there it rather says that the face has fewer corners than it claims.
void read_face(LineReader& text, std::int64_t vertices, PolygonSoup& soup) {
  const std::int64_t corners = text.integer("the number of corners");
  if (corners < 0) text.fail("a face of " + std::to_string(corners) + " corners");
  const std::size_t first_line = text.line();
  for (std::int64_t i = 0; i < corners; ++i) {
    const std::string_view word = text.next_word();
    std::int64_t index = 0;
    if (!parse_integer(word, index)) text.fail_expected("a vertex index", word);
    if (index < 0 || index >= vertices) {
      text.fail("vertex index " + std::to_string(index) + " is not in 0.." + std::to_string(vertices - 1));
    }
    soup.corners.push_back(static_cast<std::uint32_t>(index));
  }
  const std::string_view rest = text.line() > first_line ? text.word() : std::string_view();
  if (!rest.empty()) text.fail_expected("the end of a face that began on a line above", rest);
  soup.close_polygon();
}

}  // namespace

bool looks_like_off(std::string_view bytes) {
  LineReader text(bytes, {});
  return text.next_line() && parse_keyword(text.word()).has_value();
}

PolygonSoup read_off(std::string_view bytes, const std::string& name) {
  PolygonSoup soup;
  LineReader text(without_padding(bytes, soup.report), name);
  const OffHeader header = read_off_header(text);
  soup.vertices.reserve(static_cast<std::size_t>(header.vertices));
  for (std::int64_t i = 0; i < header.vertices; ++i) {
    next_record(text, "vertices", i, header.vertices);
    soup.vertices.push_back(read_vertex(text, header.homogeneous));
  }
  soup.ends.reserve(static_cast<std::size_t>(header.faces));
  for (std::int64_t i = 0; i < header.faces; ++i) {
    next_record(text, "faces", i, header.faces);
    read_face(text, header.vertices, soup);
  }
  report_left_over(text, soup.report);
  return soup;
}

}  // namespace rectilin
