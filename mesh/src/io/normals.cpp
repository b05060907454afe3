#include "rectilin/mesh/normals.h"

#include <array>
#include <cmath>
#include <optional>

#include "io/bytes.h"
#include "io/ply_header.h"
#include "rectilin/base/whole_file.h"

namespace rectilin {
namespace {

using namespace ply;

double read_binary(ByteReader& data, Type type) {
  switch (type) {
    case Type::kInt8:
      return data.read<std::int8_t>();
    case Type::kUint8:
      return data.read<std::uint8_t>();
    case Type::kInt16:
      return data.read<std::int16_t>();
    case Type::kUint16:
      return data.read<std::uint16_t>();
    case Type::kInt32:
      return data.read<std::int32_t>();
    case Type::kUint32:
      return data.read<std::uint32_t>();
    case Type::kFloat32:
      return data.read<float>();
    case Type::kFloat64:
      break;
  }
  return data.read<double>();
}

std::optional<std::size_t> find(const Element& element, std::string_view name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (element.properties[i].name == name && !element.properties[i].count_type) return i;
  return std::nullopt;
}

/// Where a point's normal and weight stand in its record.
struct Layout {
  std::array<std::size_t, 3> normal;
  std::optional<std::size_t> weight;
};

Layout layout_of(const Element& points, const LineReader& text) {
  for (const Property& property : points.properties)
    if (property.count_type) text.fail(points.line, "points with lists are not read for normals");
  Layout layout{};
  constexpr std::array<const char*, 3> kNames = {"nx", "ny", "nz"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto place = find(points, kNames[k]);
    if (!place) text.fail(points.line, "the vertices have no normals (nx, ny and nz)");
    layout.normal[k] = *place;
  }
  layout.weight = find(points, "weight");
  if (!layout.weight) layout.weight = find(points, "area");
  return layout;
}

/// `begin_point()` goes to the next record and `read(type)` gives its values one by one.
template <class BeginPoint, class Read, class Fail>
WeightedNormals read_points(const Element& points, const Layout& layout, BeginPoint begin_point, Read read, Fail fail) {
  WeightedNormals cloud;
  cloud.points = points.count;
  std::vector<double> record(points.properties.size());
  for (std::size_t i = 0; i < points.count; ++i) {
    begin_point();
    for (std::size_t k = 0; k < record.size(); ++k) record[k] = read(points.properties[k].type);
    const Vector3 normal(record[layout.normal[0]], record[layout.normal[1]], record[layout.normal[2]]);
    const double weight = layout.weight ? record[*layout.weight] : 1;
    if (!(std::isfinite(weight) && weight >= 0)) fail("a weight that is negative or not finite");
    if (!normal.allFinite() || normal.isZero(0)) {
      ++cloud.dropped;
      continue;
    }
    cloud.normals.push_back(normal);
    cloud.weights.push_back(weight);
  }
  return cloud;
}

WeightedNormals read_text(LineReader& text, const Element& points, const Layout& layout) {
  return read_points(
      points, layout,
      [&] {
        if (!text.next_line()) text.fail("the file ends where more points should follow");
      },
      [&](Type) { return text.number("a number"); }, [&](const std::string& reason) { text.fail(reason); });
}

WeightedNormals read_binary(ByteReader data, const Element& points, const Layout& layout) {
  std::size_t size = 0;
  for (const Property& property : points.properties) size += size_of(property.type);
  if (points.count > data.remaining() / size)
    data.fail("the header claims " + std::to_string(points.count) + " points, more than the file can hold");
  return read_points(
      points, layout, [] {}, [&](Type type) { return read_binary(data, type); },
      [&](const std::string& reason) { data.fail(reason); });
}

}  // namespace

WeightedNormals read_normals(std::string_view bytes, const std::string& name) {
  LineReader text(bytes, name);
  if (bytes.substr(0, 3) != "ply") throw MeshError(name + ": point clouds with normals are read from PLY files only");
  const PlyHeader header = read_ply_header(text);
  if (header.elements.empty() || header.elements.front().name != "vertex")
    text.fail("the first element is not 'vertex'");
  const Element& points = header.elements.front();
  const Layout layout = layout_of(points, text);
  WeightedNormals cloud;
  if (header.encoding == Encoding::kText) {
    cloud = read_text(text, points, layout);
  } else {
    const std::endian order = header.encoding == Encoding::kBigEndian ? std::endian::big : std::endian::little;
    cloud = read_binary(ByteReader(bytes, body_offset(text, bytes), order, name), points, layout);
  }
  if (cloud.normals.empty()) throw MeshError(name + ": no point has a normal");
  return cloud;
}

WeightedNormals read_normals(const std::filesystem::path& file) {
  std::string bytes;
  try {
    bytes = read_whole_file(file);
  } catch (const std::runtime_error& e) {
    throw MeshError(e.what());
  }
  return read_normals(bytes, file.string());
}

}  // namespace rectilin
