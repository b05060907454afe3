// The Stanford polygon file format (Turk 1994), as text and as binary data of both byte orders.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "io/bytes.h"
#include "io/left_over.h"
#include "io/ply_header.h"
#include "io/soup.h"

namespace rectilin {
namespace {

using namespace ply;

// Both sources give values one by one; all types fit into a double.
class TextSource {
 public:
  explicit TextSource(LineReader& text) : text_(text) {}

  void begin_item() {
    if (!text_.next_line()) fail("the file ends where more elements should follow");
  }
  // An element may go over several lines. One that lacks a number takes it from the next, which then does not end
  // where its line does, or leaves one element too few.
  double read(Type) { return text_.next_number("a number"); }
  void end_item() {
    const std::string_view word = text_.word();
    if (!word.empty()) text_.fail_expected("the end of the line", word);
  }
  std::size_t remaining() const { return text_.remaining(); }
  void report_left_over(MeshReport& report) { rectilin::report_left_over(text_, report); }
  static std::size_t smallest_size(Type) { return 2; }  // a digit and what separates it
  [[noreturn]] void fail(const std::string& reason) const { text_.fail(reason); }

 private:
  LineReader& text_;
};

class BinarySource {
 public:
  explicit BinarySource(const ByteReader& data) : data_(data) {}

  void begin_item() {}
  double read(Type type) {
    switch (type) {
      case Type::kInt8:
        return data_.read<std::int8_t>();
      case Type::kUint8:
        return data_.read<std::uint8_t>();
      case Type::kInt16:
        return data_.read<std::int16_t>();
      case Type::kUint16:
        return data_.read<std::uint16_t>();
      case Type::kInt32:
        return data_.read<std::int32_t>();
      case Type::kUint32:
        return data_.read<std::uint32_t>();
      case Type::kFloat32:
        return data_.read<float>();
      case Type::kFloat64:
        break;
    }
    return data_.read<double>();
  }
  void end_item() {}
  std::size_t remaining() const { return data_.remaining(); }
  void report_left_over(MeshReport& report) { rectilin::report_left_over(data_.rest(), data_.position(), report); }
  static std::size_t smallest_size(Type type) { return size_of(type); }
  [[noreturn]] void fail(const std::string& reason) const { data_.fail(reason); }

 private:
  ByteReader data_;
};

// Reads the elements in the order of the header into a soup.
template <class Source>
class BodyReader {
 public:
  BodyReader(Source source, const PlyHeader& header, const LineReader& header_text, MeshReport report)
      : source_(std::move(source)), header_(header), header_text_(header_text) {
    soup_.report = std::move(report);
  }

  PolygonSoup read() {
    for (const Element& element : header_.elements) {
      if (element.name == "vertex") vertices_ += element.count;
    }
    for (const Element& element : header_.elements) {
      check_count(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        read_faces(element);
      } else {
        report_unknown(element);
        skip(element);
      }
    }
    source_.report_left_over(soup_.report);
    return std::move(soup_);
  }

 private:
  [[noreturn]] void fail_header(const Element& element, const std::string& reason) const {
    header_text_.fail(element.line, reason);
  }

  void check_count(const Element& element) const {
    std::size_t smallest = 0;
    for (const Property& property : element.properties) {
      smallest += Source::smallest_size(property.count_type.value_or(property.type));
    }
    // One more, since the last line of a text need not end.
    if (smallest > 0 && element.count > (source_.remaining() + 1) / smallest) {
      fail_header(element, "the header claims " + std::to_string(element.count) + " of the element " +
                               quoted(element.name) + ", more than the file can hold");
    }
  }

  // Where a property stands in its element.
  std::optional<std::size_t> find(const Element& element, std::string_view name, bool list) const {
    const auto& properties = element.properties;
    const auto found = std::find_if(properties.begin(), properties.end(), [&](const Property& p) {
      return p.name == name && p.count_type.has_value() == list;
    });
    if (found == properties.end()) return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
  }

  // Reads one element and hands each of its values to `use`, with its property's number.
  template <class Use>
  void read_item(const Element& element, Use use) {
    source_.begin_item();
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      const std::size_t count = property.count_type ? read_list_count(property) : 1;
      for (std::size_t k = 0; k < count; ++k) use(i, source_.read(property.type));
    }
    source_.end_item();
  }

  std::size_t read_list_count(const Property& property) {
    const std::int64_t count = to_integer(source_.read(*property.count_type));
    if (count < 0) source_.fail("a list of negative length");
    return static_cast<std::size_t>(count);
  }

  std::int64_t to_integer(double value) const {
    constexpr double kExact = 9007199254740992.0;  // 2^53
    if (!(std::abs(value) < kExact) || value != std::trunc(value)) {
      source_.fail("a list's length or an index is not an integer");
    }
    return static_cast<std::int64_t>(value);
  }

  // Elements of other names may be anything, a camera or the program's settings; but those that list vertices may be
  // surface, such as fans of triangles.
  void report_unknown(const Element& element) {
    if (element.count == 0 || !find_indices(element)) return;
    if (soup_.report.unknown_statements == 0)
      soup_.report.first_unknown = "the element " + quoted(element.name) + " in line " + std::to_string(element.line);
    soup_.report.unknown_statements += element.count;
  }

  std::optional<std::size_t> find_indices(const Element& element) const {
    const auto indices = find(element, "vertex_indices", true);
    return indices ? indices : find(element, "vertex_index", true);
  }

  void skip(const Element& element) {
    if (element.properties.empty()) return;  // no data, and no bound on the count
    for (std::size_t i = 0; i < element.count; ++i) {
      read_item(element, [](std::size_t, double) {});
    }
  }

  void read_vertices(const Element& element) {
    const auto x = find(element, "x", false), y = find(element, "y", false), z = find(element, "z", false);
    if (!x || !y || !z) fail_header(element, "the vertices have no x, y and z");
    soup_.vertices.reserve(soup_.vertices.size() + element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      Vector3 vertex = Vector3::Zero();
      read_item(element, [&](std::size_t property, double value) {
        if (property == *x) vertex.x() = value;
        if (property == *y) vertex.y() = value;
        if (property == *z) vertex.z() = value;
      });
      soup_.vertices.push_back(vertex);
    }
  }

  // Faces, or strips of triangles, by their lists of vertex indices.
  void read_faces(const Element& element) {
    if (element.count == 0) return;
    const bool strips = element.name == "tristrips";
    const auto indices = find_indices(element);
    if (!indices) fail_header(element, "the faces have no list vertex_indices or vertex_index");
    for (std::size_t i = 0; i < element.count; ++i) {
      strip_length_ = 0;
      read_item(element, [&](std::size_t property, double value) {
        if (property != *indices) return;
        const std::int64_t index = to_integer(value);
        strips ? append_to_strip(index) : soup_.corners.push_back(checked(index));
      });
      if (!strips) soup_.close_polygon();
    }
  }

  std::uint32_t checked(std::int64_t index) const {
    if (index < 0 || static_cast<std::size_t>(index) >= vertices_) {
      source_.fail("vertex index " + std::to_string(index) + ", but there are " + std::to_string(vertices_) +
                   " vertices");
    }
    return static_cast<std::uint32_t>(index);
  }

  // Each index from a strip's third on makes a triangle with the two before it, turned the other
  // way every second time; -1 starts a new strip.
  void append_to_strip(std::int64_t index) {
    if (index == -1) {
      strip_length_ = 0;
      return;
    }
    const std::uint32_t corner = checked(index);
    if (strip_length_ >= 2) {
      const bool turned = strip_length_ % 2 == 1;
      const auto [a, b] = strip_end_;
      soup_.corners.insert(soup_.corners.end(), {turned ? b : a, turned ? a : b, corner});
      soup_.close_polygon();
    }
    strip_end_ = {strip_end_[1], corner};
    ++strip_length_;
  }

  Source source_;
  const PlyHeader& header_;
  const LineReader& header_text_;  // for errors that blame the header
  PolygonSoup soup_;
  std::size_t vertices_ = 0;
  std::array<std::uint32_t, 2> strip_end_{};
  std::size_t strip_length_ = 0;
};

// Copied as text to a system whose lines end with CR LF: then there are more bytes than the header counts.
bool was_copied_as_text(std::string_view bytes) {
  for (std::size_t i = 0; (i = bytes.find('\n', i)) != std::string_view::npos; ++i)
    if (i == 0 || bytes[i - 1] != '\r') return false;
  return true;
}

}  // namespace

bool looks_like_ply(std::string_view bytes) {
  LineReader text(bytes, {});
  return text.next_line() && text.word() == "ply";
}

PolygonSoup read_ply(std::string_view bytes, const std::string& name) {
  LineReader text(bytes, name);
  const PlyHeader header = read_ply_header(text);
  if (header.encoding == Encoding::kText) {
    MeshReport report;
    LineReader body = text.within(without_padding(bytes, report));
    return BodyReader(TextSource(body), header, text, report).read();
  }
  const std::endian order = header.encoding == Encoding::kBigEndian ? std::endian::big : std::endian::little;
  const std::size_t body = body_offset(text, bytes);
  const ByteReader data(bytes, body, order, name);
  PolygonSoup soup = BodyReader(BinarySource(data), header, text, {}).read();
  if (soup.report.left_over_bytes > 0 && was_copied_as_text(bytes))
    throw MeshError(name + ": a binary PLY file that was copied as text: there is a CR before every LF");
  return soup;
}

}  // namespace rectilin
