// Wavefront OBJ (Wavefront Advanced Visualizer manual, appendix B1): the statements v and f.
#include "io/soup.h"
#include "io/text.h"

namespace rectilin {
namespace {

// The largest vertex index any face uses, and where. Faces may come before their vertices, so that
// only the end of the file tells whether it was good.
struct LargestIndex {
  std::int64_t index = -1;
  std::size_t line = 0;
};

Vector3 read_vertex(LineReader& text) {
  const double x = text.number("a coordinate");
  const double y = text.number("a coordinate");
  const double z = text.number("a coordinate");
  return {x, y, z};
}

// A corner is v, v/vt, v//vn or v/vt/vn; v counts from 1, or back from the last vertex if negative.
std::int64_t parse_corner(const LineReader& text, std::string_view word, std::int64_t vertices) {
  std::int64_t number = 0;
  if (!parse_integer(word.substr(0, word.find('/')), number)) {
    text.fail_expected("a vertex index", word);
  }
  const std::int64_t index = number > 0 ? number - 1 : vertices + number;
  if (number == 0) text.fail("vertex index 0, but the first vertex is 1");
  if (index < 0) {
    text.fail("vertex index " + std::to_string(number) + ", but only " + std::to_string(vertices) +
              " vertices precede it");
  }
  return index;
}

void read_face(LineReader& text, PolygonSoup& soup, LargestIndex& largest) {
  const auto vertices = static_cast<std::int64_t>(soup.vertices.size());
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    const std::int64_t index = parse_corner(text, word, vertices);
    if (index > largest.index) largest = {index, text.line()};
    soup.corners.push_back(static_cast<std::uint32_t>(index));
  }
  soup.close_polygon();
}

}  // namespace

PolygonSoup read_obj(std::string_view bytes, const std::string& name) {
  LineReader text(bytes, name, LineReader::Continuation::kBackslash);
  PolygonSoup soup;
  LargestIndex largest;
  while (text.next_line()) {
    const std::string_view keyword = text.word();
    if (keyword == "v") {
      soup.vertices.push_back(read_vertex(text));
    } else if (keyword == "f") {
      read_face(text, soup, largest);
    }
  }
  const auto vertices = static_cast<std::int64_t>(soup.vertices.size());
  if (largest.index >= vertices) {
    text.fail(largest.line, "vertex index " + std::to_string(largest.index + 1) + ", but there are " +
                                std::to_string(vertices) + " vertices");
  }
  return soup;
}

}  // namespace rectilin
