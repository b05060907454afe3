// Stereolithography files (3D Systems, StereoLithography Interface Specification, 1989).
#include <array>

#include "io/bytes.h"
#include "io/soup.h"
#include "io/text.h"

namespace rectilin {
namespace {

constexpr std::size_t kHeaderSize = 80, kPrefixSize = 84, kTriangleSize = 50;

bool starts_with_solid(std::string_view bytes) {
  LineReader text(bytes, {});
  return text.next_line() && is_keyword(text.word(), "solid");
}

// How many triangles a binary file claims. The file must have a whole prefix.
std::size_t claimed_triangles(std::string_view bytes) {
  return ByteReader(bytes, kHeaderSize, std::endian::little, {}).read<std::uint32_t>();
}

// Exporters write "solid" into binary headers too; only the size tells.
bool has_binary_size(std::string_view bytes) {
  return bytes.size() >= kPrefixSize && bytes.size() == kPrefixSize + kTriangleSize * claimed_triangles(bytes);
}

void append_corner(PolygonSoup& soup, const Vector3& position) {
  soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
  soup.vertices.push_back(position);
}

PolygonSoup read_binary(std::string_view bytes, const std::string& name) {
  ByteReader data(bytes, std::min(kHeaderSize, bytes.size()), std::endian::little, name);
  const std::size_t triangles = data.read<std::uint32_t>();
  if (triangles > data.remaining() / kTriangleSize) {
    data.fail("the header claims " + std::to_string(triangles) + " triangles, the file holds " +
              std::to_string(data.remaining() / kTriangleSize));
  }
  PolygonSoup soup;
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

// Between "facet" and "endfacet" come lines of one vertex each; "outer loop" and "endloop" say
// nothing.
void read_facet(LineReader& text, PolygonSoup& soup) {
  while (text.next_line()) {
    const std::string_view keyword = text.word();
    if (is_keyword(keyword, "vertex")) {
      const double x = text.number("a coordinate");
      const double y = text.number("a coordinate");
      const double z = text.number("a coordinate");
      append_corner(soup, Vector3(x, y, z));
    } else if (is_keyword(keyword, "endfacet")) {
      soup.close_polygon();
      return;
    } else if (!is_keyword(keyword, "outer") && !is_keyword(keyword, "endloop")) {
      text.fail_expected("a vertex or endfacet", keyword);
    }
  }
  text.fail("the file ends within a facet");
}

PolygonSoup read_text(std::string_view bytes, const std::string& name) {
  LineReader text(bytes, name);
  PolygonSoup soup;
  soup.weld = true;
  bool in_solid = false;
  while (text.next_line()) {
    const std::string_view keyword = text.word();
    if (in_solid && is_keyword(keyword, "facet")) {
      read_facet(text, soup);
    } else if (is_keyword(keyword, in_solid ? "endsolid" : "solid")) {
      in_solid = !in_solid;
    } else {
      text.fail_expected(in_solid ? "facet or endsolid" : "solid", keyword);
    }
  }
  if (in_solid) text.fail("the file ends before endsolid");
  return soup;
}

}  // namespace

bool looks_like_stl(std::string_view bytes) { return has_binary_size(bytes) || starts_with_solid(bytes); }

PolygonSoup read_stl(std::string_view bytes, const std::string& name) {
  const bool text = !has_binary_size(bytes) && starts_with_solid(bytes);
  return text ? read_text(bytes, name) : read_binary(bytes, name);
}

}  // namespace rectilin
