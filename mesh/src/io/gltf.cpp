// glTF 2.0, text (.gltf) and binary (.glb): Khronos Group, glTF 2.0 Specification, 2021. Parsed by tinygltf, which is
// kept from files and images; everything it does not check is checked here.
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "io/bytes.h"
#include "io/gltf_accessor.h"
#include "io/left_over.h"
#include "io/scene.h"
#include "io/soup.h"
#include "io/text.h"

namespace rectilin {
namespace {

using Eigen::Affine3d;

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kMostBrackets = 64;                      // of brackets in the JSON: parsers recurse
constexpr std::uint64_t kMaxBuffers = std::uint64_t{1} << 31;  // bytes of all buffers together
constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// The JSON of a file: all of a text file, the first chunk of a binary one.
std::string_view json_text(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(kMagic)) return bytes;
  constexpr std::size_t kHeader = 20;
  if (bytes.size() < kHeader) throw MeshError(name + ": the file ends within the header");
  const std::size_t length = ByteReader(bytes, 12, std::endian::little, name).read<std::uint32_t>();
  if (length > bytes.size() - kHeader)
    throw MeshError(name + ":byte 12: a chunk of " + std::to_string(length) + " bytes, the file holds " +
                    std::to_string(bytes.size() - kHeader));
  return bytes.substr(kHeader, length);
}

/// Parsers and what they make recurse; a file of brackets must not end the program.
void check_depth(std::string_view json, const std::string& name) {
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (quoted) {
      if (c == '\\') ++i;
      else if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMostBrackets)
        throw MeshError(name + ":byte " + std::to_string(i) + ": the JSON is nested too deep");
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
}

/// Bytes written as %41; some decoders take '+' for a blank, too.
std::string decoded_uri(std::string_view uri, bool plus_is_blank) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      text += static_cast<char>(byte);
      i += 2;
    } else {
      text += plus_is_blank && uri[i] == '+' ? ' ' : uri[i];
    }
  }
  return text;
}

/// The files that the buffers are in, and nothing else: images are not even looked for.
struct BufferFiles {
  std::map<std::string, std::string> path_of;  ///< by the path as tinygltf decodes it
  const ReadBeside* beside;

  static bool exists(const std::string& path, void* self) {
    return static_cast<BufferFiles*>(self)->path_of.contains(path);
  }
  static std::string expand(const std::string& path, void*) { return path; }
  static bool read(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* self) {
    const auto& files = *static_cast<BufferFiles*>(self);
    const auto found = files.path_of.find(path);
    if (found == files.path_of.end()) return false;
    if (!*files.beside) {
      *error = "nothing is read beside this file";
      return false;
    }
    const std::string bytes = (*files.beside)(found->second);
    out->assign(bytes.begin(), bytes.end());
    return true;
  }
  static bool write(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }
};

/// Looks at the buffers before they are made: their sizes, which are only claimed, and their files.
BufferFiles check_buffers(std::string_view json, bool binary, const ReadBeside& beside, const std::string& name) {
  using Event = nlohmann::json::parse_event_t;
  const auto only_buffers = [](int depth, Event event, nlohmann::json& value) {
    return depth != 1 || event != Event::key || value == "buffers";
  };
  const nlohmann::json root = nlohmann::json::parse(json, only_buffers, false);
  if (root.is_discarded() || !root.is_object()) throw MeshError(name + ": the JSON is malformed");
  BufferFiles files{{}, &beside};
  const auto buffers = root.find("buffers");
  if (buffers == root.end() || !buffers->is_array()) return files;
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < buffers->size(); ++i) {
    const nlohmann::json& buffer = (*buffers)[i];
    const std::string what = name + ":buffer " + std::to_string(i) + ": ";
    if (!buffer.is_object()) throw MeshError(what + "not an object");
    const auto length = buffer.find("byteLength");
    if (length == buffer.end() || !length->is_number_unsigned() || *length == 0)
      throw MeshError(what + "its byteLength is not a positive whole number");
    total = SceneCost::sum(total, length->get<std::uint64_t>());
    if (total > kMaxBuffers)
      throw MeshError(what + "the buffers claim more than " + std::to_string(kMaxBuffers) + " bytes");
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) {
      if (!binary || i > 0) throw MeshError(what + "it has no data");
    } else if (!uri->is_string()) {
      throw MeshError(what + "its uri is not a string");
    } else if (const auto& text = uri->get_ref<const std::string&>(); !text.starts_with("data:")) {
      files.path_of[decoded_uri(text, true)] = decoded_uri(text, false);
    }
  }
  return files;
}

tinygltf::Model parse(std::string_view bytes, const ReadBeside& beside, const std::string& name) {
  if (bytes.size() > std::numeric_limits<unsigned>::max()) throw MeshError(name + ": larger than 4 GiB");
  const bool binary = bytes.starts_with(kMagic);
  const std::string_view json = json_text(bytes, name);
  check_depth(json, name);
  BufferFiles files = check_buffers(json, binary, beside, name);
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({&BufferFiles::exists, &BufferFiles::expand, &BufferFiles::read, &BufferFiles::write, &files});
  parser.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return true; },
                        nullptr);
  tinygltf::Model model;
  std::string error, warning;
  bool done = false;
  const auto size = static_cast<unsigned>(bytes.size());
  try {
    done = binary ? parser.LoadBinaryFromMemory(&model, &error, &warning,
                                                reinterpret_cast<const unsigned char*>(bytes.data()), size)
                  : parser.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, "");
  } catch (const MeshError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (!done || !error.empty()) {
    const std::string reason = error.substr(0, error.find_first_of("\r\n"));
    throw MeshError(name + ": not valid glTF" + (reason.empty() ? "" : ": " + rectilin::quoted(reason)));
  }
  for (const std::string& extension : model.extensionsRequired) {
    // All others that change the geometry compress it; those for materials and lights do not matter here.
    if (extension.find("compression") != std::string::npos)
      throw MeshError(name + ": it needs the extension " + rectilin::quoted(extension) + ", which is not read");
  }
  return model;
}

/// A file's scene put into one soup, in the world's coordinates.
class Scene {
 public:
  Scene(const tinygltf::Model& model, const std::string& name) : model_(model), name_(name) {}

  PolygonSoup place_all() {
    find_costs();
    find_nodes();
    for (const Node& node : nodes_) {
      if (node.instances.empty()) place(node.mesh, node.to_world);
      for (const Affine3d& instance : node.instances) place(node.mesh, node.to_world * instance);
    }
    soup_.scene.metres_per_unit = 1;
    return std::move(soup_);
  }

 private:
  /// Nodes with surface that the scene does not reach, and meshes that no node has.
  void count_unplaced(const std::vector<char>& met) {
    std::vector<char> known(model_.meshes.size(), 0);
    const auto has_surface = [&](std::size_t mesh) {
      return std::ranges::any_of(model_.meshes[mesh].primitives, has_triangles);
    };
    for (const Node& node : nodes_) known[node.mesh] = 1;
    for (std::size_t i = 0; i < met.size(); ++i) {
      const int mesh = model_.nodes[i].mesh;
      if (mesh < 0 || static_cast<std::size_t>(mesh) >= known.size()) continue;
      known[static_cast<std::size_t>(mesh)] = 1;
      soup_.scene.unplaced += !met[i] && has_surface(static_cast<std::size_t>(mesh));
    }
    for (std::size_t mesh = 0; mesh < known.size(); ++mesh) soup_.scene.unplaced += !known[mesh] && has_surface(mesh);
  }

  struct Node {
    std::size_t mesh;
    Affine3d to_world;
    std::vector<Affine3d> instances;  ///< of the extension for instances; none: one
  };

  static bool has_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode == -1 ||
           (primitive.mode >= TINYGLTF_MODE_TRIANGLES && primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN);
  }

  GltfAccessor positions(const tinygltf::Primitive& primitive) const {
    return {model_, primitive.attributes.at("POSITION"), 3, name_};
  }

  /// What placing each mesh once costs. A primitive and a replaced number count, too, so that meshes of a thousand
  /// empty primitives are not free.
  void find_costs() {
    for (const tinygltf::Mesh& mesh : model_.meshes) {
      std::uint64_t cost = SceneCost::kInstance;
      std::set<int> seen;
      for (const tinygltf::Primitive& primitive : mesh.primitives) {
        ++cost;
        if (!has_triangles(primitive)) continue;
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end()) continue;
        const GltfAccessor points = positions(primitive);
        if (seen.insert(position->second).second) cost = SceneCost::sum(cost, points.size() + points.replaced());
        cost = SceneCost::sum(
            cost, primitive.indices < 0 ? points.size() : GltfAccessor(model_, primitive.indices, 1, name_).size());
      }
      costs_.push_back(cost);
      stored_ = SceneCost::sum(stored_, cost);
    }
  }

  /// Counts a mesh placed `count` times, before anything is made of it.
  void charge(std::size_t mesh, std::uint64_t count) {
    const std::uint64_t cost = costs_[mesh];
    placed_ = SceneCost::sum(placed_, count > SceneCost::kTooMuch / cost ? SceneCost::kTooMuch : cost * count);
    SceneCost::check(placed_, stored_, name_);
  }

  /// The nodes of the scene that have meshes. Each is met once, as the specification demands: no loops, no shared
  /// parts.
  void find_nodes() {
    std::vector<std::pair<int, Affine3d>> open;
    std::vector<char> met(model_.nodes.size(), 0);
    if (!model_.scenes.empty()) {
      const int shown = std::max(0, model_.defaultScene);
      if (static_cast<std::size_t>(shown) >= model_.scenes.size()) fail("the scene to show does not exist");
      for (const int root : model_.scenes[static_cast<std::size_t>(shown)].nodes)
        open.emplace_back(root, Affine3d::Identity());
    } else {  // a library of meshes: all that are placed, or all there are
      std::vector<char> is_child(model_.nodes.size(), 0);
      for (const tinygltf::Node& node : model_.nodes)
        for (const int child : node.children)
          if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
            is_child[static_cast<std::size_t>(child)] = 1;
      for (std::size_t i = 0; i < model_.nodes.size(); ++i)
        if (!is_child[i]) open.emplace_back(static_cast<int>(i), Affine3d::Identity());
      if (model_.nodes.empty())
        for (std::size_t i = 0; i < model_.meshes.size(); ++i) {
          charge(i, 1);
          nodes_.push_back({i, Affine3d::Identity(), {}});
        }
    }
    std::ranges::reverse(open);
    while (!open.empty()) {
      const auto [index, parent] = open.back();
      open.pop_back();
      const auto i = static_cast<std::size_t>(index);
      if (index < 0 || i >= model_.nodes.size()) fail("node " + std::to_string(index) + " does not exist");
      if (met[i]++) fail("node " + std::to_string(index) + " has two parents, or is its own ancestor");
      const tinygltf::Node& node = model_.nodes[i];
      const Affine3d to_world = parent * transform_of(node);
      if (node.mesh >= 0) {
        if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size())
          fail("mesh " + std::to_string(node.mesh) + " does not exist");
        const auto mesh = static_cast<std::size_t>(node.mesh);
        charge(mesh, 1);
        nodes_.push_back({mesh, to_world, instances_of(node)});
        const auto has_targets = [](const tinygltf::Primitive& p) { return !p.targets.empty(); };
        soup_.scene.deformed += node.skin >= 0 || std::ranges::any_of(model_.meshes[mesh].primitives, has_targets);
      }
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        open.emplace_back(*child, to_world);
    }
    count_unplaced(met);
  }

  static Affine3d transform_of(const tinygltf::Node& node) {
    Affine3d transform = Affine3d::Identity();
    if (node.matrix.size() == 16) {
      transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
      return transform;
    }
    if (node.translation.size() == 3) transform.translate(Eigen::Map<const Vector3>(node.translation.data()));
    if (node.rotation.size() == 4)
      transform.rotate(
          Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]).normalized());
    if (node.scale.size() == 3) transform.scale(Eigen::Map<const Vector3>(node.scale.data()));
    return transform;
  }

  /// The places that the extension EXT_mesh_gpu_instancing gives to the node's mesh.
  std::vector<Affine3d> instances_of(const tinygltf::Node& node) {
    const auto extension = node.extensions.find(kInstancing);
    if (extension == node.extensions.end()) return {};
    if (!extension->second.IsObject() || !extension->second.Get("attributes").IsObject())
      fail(std::string(kInstancing) + " has no attributes");
    const tinygltf::Value& attributes = extension->second.Get("attributes");
    std::optional<std::size_t> count;
    std::vector<Vector3> moves, scales;
    std::vector<Eigen::Quaterniond> turns;
    for (const auto& [key, components] :
         {std::pair("TRANSLATION", 3u), std::pair("ROTATION", 4u), std::pair("SCALE", 3u)}) {
      if (!attributes.Has(key)) continue;
      const tinygltf::Value& index = attributes.Get(key);
      if (!index.IsInt()) fail(std::string(kInstancing) + ": an accessor is not a number");
      const GltfAccessor accessor(model_, index.GetNumberAsInt(), components, name_);
      if (count && *count != accessor.size()) fail(std::string(kInstancing) + ": the attributes differ in length");
      count = accessor.size();
      charge(static_cast<std::size_t>(node.mesh), SceneCost::sum(accessor.size(), accessor.replaced()));
      moves.resize(*count, Vector3::Zero());
      turns.resize(*count, Eigen::Quaterniond::Identity());
      scales.resize(*count, Vector3::Ones());
      accessor.for_each([&, key = std::string_view(key)](std::size_t i, const std::array<double, 4>& x) {
        if (key == "ROTATION") turns[i] = Eigen::Quaterniond(x[3], x[0], x[1], x[2]).normalized();
        else (key == "SCALE" ? scales : moves)[i] = Vector3(x[0], x[1], x[2]);
      });
    }
    if (!count) return {};
    if (*count == 0) fail(std::string(kInstancing) + ": no instances");
    std::vector<Affine3d> instances(*count, Affine3d::Identity());
    for (std::size_t i = 0; i < *count; ++i) instances[i].translate(moves[i]).rotate(turns[i]).scale(scales[i]);
    return instances;
  }

  void place(std::size_t mesh_index, const Affine3d& to_world) {
    const tinygltf::Mesh& mesh = model_.meshes[mesh_index];
    std::map<int, std::uint32_t> begin_of;  // accessors that primitives of the mesh share
    ++soup_.scene.instances;
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      const auto position = primitive.attributes.find("POSITION");
      if (!has_triangles(primitive) || position == primitive.attributes.end()) {
        ++soup_.scene.skipped;
        continue;
      }
      const GltfAccessor points = positions(primitive);
      const auto [begin, is_new] =
          begin_of.try_emplace(position->second, static_cast<std::uint32_t>(soup_.vertices.size()));
      if (is_new) {
        soup_.vertices.resize(soup_.vertices.size() + points.size());
        points.for_each([&, first = begin->second](std::size_t i, const std::array<double, 4>& x) {
          soup_.vertices[first + i] = to_world * Vector3(x[0], x[1], x[2]);
        });
      }
      append_triangles(primitive, begin->second, points.size());
    }
  }

  void append_triangles(const tinygltf::Primitive& primitive, std::uint32_t begin, std::size_t points) {
    std::vector<std::uint32_t> corners(primitive.indices < 0 ? points : 0);
    if (primitive.indices < 0) {
      for (std::size_t i = 0; i < points; ++i) corners[i] = begin + static_cast<std::uint32_t>(i);
    } else {
      const GltfAccessor indices(model_, primitive.indices, 1, name_);
      if (indices.size() > 0 && !indices.is_integer()) fail("indices are not whole numbers");
      corners.resize(indices.size());
      indices.for_each([&](std::size_t i, const std::array<double, 4>& x) {
        if (!(x[0] >= 0 && x[0] < static_cast<double>(points)))
          fail("index " + std::to_string(static_cast<std::int64_t>(x[0])) + " of " + std::to_string(points) +
               " vertices");
        corners[i] = begin + static_cast<std::uint32_t>(x[0]);
      });
    }
    const bool strip = primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP,
               fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    const std::size_t step = strip || fan ? 1 : 3;
    std::size_t i = 0;
    for (; i + 2 < corners.size(); i += step) {
      soup_.corners.insert(soup_.corners.end(), {corners[fan ? 0 : i], corners[i + 1], corners[i + 2]});
      soup_.close_polygon();
    }
    const bool is_short = step == 3 ? i < corners.size() : corners.size() > 0 && corners.size() < 3;
    if (!is_short) return;  // what is left over makes no triangle
    soup_.corners.insert(soup_.corners.end(), corners.begin() + static_cast<std::ptrdiff_t>(i), corners.end());
    soup_.close_polygon();
  }

  [[noreturn]] void fail(const std::string& reason) const { throw MeshError(name_ + ": " + reason); }

  const tinygltf::Model& model_;
  const std::string& name_;
  std::vector<std::uint64_t> costs_;  ///< of each mesh
  std::uint64_t stored_ = 0, placed_ = 0;
  std::vector<Node> nodes_;
  PolygonSoup soup_;
};

}  // namespace

bool looks_like_glb(std::string_view bytes) { return bytes.starts_with(kMagic); }

PolygonSoup read_gltf(std::string_view bytes, const ReadBeside& beside, const std::string& name) {
  const tinygltf::Model model = parse(bytes, beside, name);
  PolygonSoup soup = Scene(model, name).place_all();
  if (looks_like_glb(bytes)) {  // which says how long it is
    const std::size_t length = ByteReader(bytes, 8, std::endian::little, name).read<std::uint32_t>();
    if (length < bytes.size()) report_left_over(bytes.substr(length), length, soup.report);
  }
  return soup;
}

}  // namespace rectilin
