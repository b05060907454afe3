// glTF 2.0, text (.gltf) and binary (.glb): Khronos Group, glTF 2.0 Specification, 2021. From the file's nodes and
// meshes, none of which can be trusted, to triangles.
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "io/bytes.h"
#include "io/gltf_accessor.h"
#include "io/gltf_file.h"
#include "io/left_over.h"
#include "io/scene.h"
#include "io/soup.h"

namespace rectilin {
namespace {

using Eigen::Affine3d;

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

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

PolygonSoup read_gltf(std::string_view bytes, const ReadBeside& beside, const std::string& name) {
  const tinygltf::Model model = parse_gltf(bytes, beside, name);
  PolygonSoup soup = Scene(model, name).place_all();
  if (looks_like_glb(bytes)) {  // which says how long it is
    const std::size_t length = ByteReader(bytes, 8, std::endian::little, name).read<std::uint32_t>();
    if (length < bytes.size()) report_left_over(bytes.substr(length), length, soup.report);
  }
  return soup;
}

}  // namespace rectilin
