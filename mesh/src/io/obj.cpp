// Wavefront OBJ (Wavefront Advanced Visualizer manual, appendix B1): the statements v and f, and which of the others
// say nothing of polygons.
#include <algorithm>
#include <array>

#include "io/left_over.h"
#include "io/soup.h"
#include "io/text.h"

namespace rectilin {
namespace {

// Names, groups, materials, how things are shown, other data of vertices, points, lines and curves: without area.
// Those of free-form surfaces are here for all but the surfaces. "vw" and "t" are extensions: weights and tags.
constexpr std::array<std::string_view, 38> kHarmless = {
    "vt",        "vn",     "vp",     "vw",     "t",      "g",     "s",        "mg",       "o",    "l",
    "p",         "usemtl", "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod",  "shadow_obj",
    "trace_obj", "cstype", "deg",    "bmat",   "step",   "parm",  "trim",     "hole",     "scrv", "sp",
    "end",       "con",    "curv",   "curv2",  "ctech",  "stech", "res",      "cdc"};

// Free-form surfaces and patches: area that is not read.
constexpr std::array<std::string_view, 4> kSurfaces = {"surf", "bsp", "bzp", "cdp"};

// The largest vertex index any face uses, and where. Faces may come before their vertices, so that
// only the end of the file tells whether it was good.
struct LargestIndex {
  std::int64_t index = -1;
  std::size_t line = 0;
};

// What follows the coordinates are a weight or a colour: numbers, or two statements have got into one line.
Vector3 read_vertex(LineReader& text) {
  const double x = text.number("a coordinate");
  const double y = text.number("a coordinate");
  const double z = text.number("a coordinate");
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    double ignored = 0;
    if (!parse_number(word, ignored)) text.fail_expected("a number or the end of the line", word);
  }
  return {x, y, z};
}

// The vertex of a corner, which is v, v/vt, v//vn or v/vt/vn.
std::string_view vertex_of(std::string_view corner) { return corner.substr(0, corner.find('/')); }

// A vertex counts from 1, or back from the last vertex if negative.
std::int64_t parse_corner(const LineReader& text, std::string_view word, std::int64_t vertices) {
  std::int64_t number = 0;
  if (!parse_integer(vertex_of(word), number)) text.fail_expected("a vertex index", word);
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

bool is_number_or_corner(std::string_view word) {
  double number = 0;
  std::int64_t index = 0;
  return parse_number(word, number) || parse_integer(vertex_of(word), index);
}

// Whether a statement that is not known may be a vertex or a face whose keyword is missing ("0 1 0"), mistyped ("V",
// "vertex", "v:"), glued to its first number ("v0 1 0", also where that is mistyped, "vO 1 0") or to all of them by
// what is not blank ("v,0,1,0"): numbers make up all of it but the keyword, three at least, or two behind a word in v
// or f.
bool looks_like_data(LineReader& text, std::string_view keyword) {
  constexpr std::string_view kSeparators = ",;:=()[]{}\"'|";
  std::size_t numbers = 0, others = 0;
  const auto count = [&](std::string_view word) {
    while (!word.empty()) {
      const std::size_t size = std::min(word.find_first_of(kSeparators), word.size());
      if (size > 0) is_number_or_corner(word.substr(0, size)) ? ++numbers : ++others;
      word.remove_prefix(std::min(size + 1, word.size()));
    }
  };
  count(keyword);
  for (std::string_view word = text.word(); !word.empty() && others <= 1; word = text.word()) count(word);
  const bool like_v_or_f = std::string_view("vVfF").find(keyword[0]) != std::string_view::npos;
  return others <= 1 && numbers >= (like_v_or_f ? 2 : 3);
}

void pass_other(LineReader& text, std::string_view keyword, MeshReport& report) {
  if (std::ranges::find(kHarmless, keyword) != kHarmless.end()) return;
  const std::size_t line = text.line();
  const bool surface = std::ranges::find(kSurfaces, keyword) != kSurfaces.end();
  if (keyword == "call") text.fail("the statement 'call' asks for another file, which is not read");
  if (!surface && looks_like_data(text, keyword))
    text.fail(line, "expected v, f or another statement, found " + quoted(keyword) + " before numbers");
  if (report.unknown_statements++ == 0) report.first_unknown = quoted(keyword) + " in line " + std::to_string(line);
}

}  // namespace

bool looks_like_obj(std::string_view bytes) {
  LineReader text(bytes, {});
  if (!text.next_line()) return false;
  const std::string_view keyword = text.word();
  return keyword == "v" || keyword == "f" || std::ranges::find(kHarmless, keyword) != kHarmless.end();
}

PolygonSoup read_obj(std::string_view bytes, const std::string& name) {
  PolygonSoup soup;
  LineReader text(without_padding(bytes, soup.report), name, LineReader::Continuation::kBackslash);
  LargestIndex largest;
  while (text.next_line()) {
    const std::string_view keyword = text.word();
    if (keyword == "v") {
      soup.vertices.push_back(read_vertex(text));
    } else if (keyword == "f" || keyword == "fo") {  // its name in versions before 3
      read_face(text, soup, largest);
    } else if (!keyword.empty()) {  // empty: a backslash that leads nowhere
      pass_other(text, keyword, soup.report);
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
