// 3D Manufacturing Format (3MF Consortium, 3MF Core Specification, 2018): a zip of XML, parsed by lib3mf.
#include <Model/COM/NMR_DLLInterfaces.h>

#include <Eigen/Geometry>
#include <memory>
#include <unordered_map>

#include "io/scene.h"
#include "io/soup.h"
#include "io/text.h"
#include "io/three_mf_parts.h"

namespace rectilin {
namespace {

using Eigen::Affine3d;
using namespace NMR;

constexpr int kMaxDepth = 64;  // of components in components

struct Release {
  void operator()(PLib3MFBase* object) const { lib3mf_release(object); }
};
using Handle = std::unique_ptr<PLib3MFBase, Release>;

/// Metres in the unit of a model.
double metres_of(DWORD unit) {
  switch (unit) {
    case MODELUNIT_MICROMETER:
      return 1e-6;
    case MODELUNIT_CENTIMETER:
      return 1e-2;
    case MODELUNIT_INCH:
      return 0.0254;
    case MODELUNIT_FOOT:
      return 0.3048;
    case MODELUNIT_METER:
      return 1;
    default:
      return 1e-3;  // what the format takes a model without a unit for
  }
}

class Package {
 public:
  Package(std::string_view bytes, const std::string& name) : name_(name) {
    model_ = made([&](auto** out) { return lib3mf_createmodel(out); }, "the library has no model");
    const Handle reader = made([&](auto** out) { return lib3mf_model_queryreader(model_.get(), "3mf", out); },
                               "the library has no reader");
    // The library does not write into what it reads from.
    auto* data = reinterpret_cast<BYTE*>(const_cast<char*>(bytes.data()));
    if (lib3mf_reader_readfrombuffer(reader.get(), data, bytes.size()) != 0) {
      DWORD code = 0;
      LPCSTR message = nullptr;
      lib3mf_getlasterror(reader.get(), &code, &message);
      fail(std::string("not valid 3MF") + (message && *message ? ": " + rectilin::quoted(message) : ""));
    }
  }

  PolygonSoup place_all() {
    DWORD unit = MODELUNIT_MILLIMETER;
    check(lib3mf_model_getunit(model_.get(), &unit), "it has no unit");
    metres_ = metres_of(unit);
    std::uint64_t placed = 0;
    for_each_item([&](PLib3MFBase* object, const Affine3d&) { placed = SceneCost::sum(placed, cost_of(object, 0)); });
    SceneCost::check(placed, stored_, name_);
    const Affine3d to_metres(Eigen::Scaling(metres_));
    for_each_item([&](PLib3MFBase* object, const Affine3d& transform) { place(object, to_metres * transform); });
    soup_.scene.metres_per_unit = metres_;
    count_unplaced();
    return std::move(soup_);
  }

 private:
  template <class Make>
  Handle made(const Make& make, const std::string& otherwise) const {
    PLib3MFBase* object = nullptr;
    const LIB3MFRESULT result = make(&object);
    Handle handle(object);
    check(result, otherwise);
    if (!handle) fail(otherwise);
    return handle;
  }

  void count_unplaced() {
    const Handle meshes =
        made([&](auto** out) { return lib3mf_model_getmeshobjects(model_.get(), out); }, "its objects are missing");
    for (BOOL more = 0; lib3mf_resourceiterator_movenext(meshes.get(), &more) == 0 && more;) {
      const Handle mesh = made([&](auto** out) { return lib3mf_resourceiterator_getcurrent(meshes.get(), out); },
                               "an object is missing");
      soup_.scene.unplaced += !costs_.contains(id_of(mesh.get())) && counts_of(mesh.get()).second > 0;
    }
  }

  static Affine3d affine(const MODELTRANSFORM& transform) {
    Affine3d affine = Affine3d::Identity();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) affine(i, j) = static_cast<double>(transform.m_fFields[i][j]);
    return affine;
  }

  /// What is to be built, but for the supports that only the printer needs.
  template <class Take>
  void for_each_item(const Take& take) const {
    const Handle items =
        made([&](auto** out) { return lib3mf_model_getbuilditems(model_.get(), out); }, "it has no build");
    for (BOOL more = 0; lib3mf_builditemiterator_movenext(items.get(), &more) == 0 && more;) {
      const Handle item =
          made([&](auto** out) { return lib3mf_builditemiterator_getcurrent(items.get(), out); }, "an item is missing");
      const Handle object =
          made([&](auto** out) { return lib3mf_builditem_getobjectresource(item.get(), out); }, "an object is missing");
      DWORD type = MODELOBJECTTYPE_MODEL;
      check(lib3mf_object_gettype(object.get(), &type), "an object has no type");
      if (type == MODELOBJECTTYPE_SUPPORT || type == MODELOBJECTTYPE_SOLIDSUPPORT) continue;
      BOOL has = 0;
      MODELTRANSFORM transform{};
      check(lib3mf_builditem_hasobjecttransform(item.get(), &has), "an item is malformed");
      if (has) check(lib3mf_builditem_getobjecttransform(item.get(), &transform), "an item is malformed");
      take(object.get(), has ? affine(transform) : Affine3d::Identity());
    }
  }

  template <class Take>
  void for_each_component(PLib3MFBase* object, const Take& take) const {
    DWORD count = 0;
    check(lib3mf_componentsobject_getcomponentcount(object, &count), "components are malformed");
    for (DWORD i = 0; i < count; ++i) {
      const Handle component = made([&](auto** out) { return lib3mf_componentsobject_getcomponent(object, i, out); },
                                    "a component is missing");
      const Handle part = made([&](auto** out) { return lib3mf_component_getobjectresource(component.get(), out); },
                               "an object is missing");
      BOOL has = 0;
      MODELTRANSFORM transform{};
      check(lib3mf_component_hastransform(component.get(), &has), "a component is malformed");
      if (has) check(lib3mf_component_gettransform(component.get(), &transform), "a component is malformed");
      take(part.get(), has ? affine(transform) : Affine3d::Identity());
    }
  }

  bool is_mesh(PLib3MFBase* object) const {
    BOOL mesh = 0;
    check(lib3mf_object_ismeshobject(object, &mesh), "an object is neither mesh nor components");
    return mesh != 0;
  }

  DWORD id_of(PLib3MFBase* object) const {
    DWORD id = 0;
    check(lib3mf_resource_getresourceid(object, &id), "an object has no number");
    return id;
  }

  std::pair<DWORD, DWORD> counts_of(PLib3MFBase* mesh) const {
    DWORD vertices = 0, triangles = 0;
    check(lib3mf_meshobject_getvertexcount(mesh, &vertices), "a mesh is malformed");
    check(lib3mf_meshobject_gettrianglecount(mesh, &triangles), "a mesh is malformed");
    return {vertices, triangles};
  }

  /// Of placing the object once. Each object's is found once, however often components repeat it.
  std::uint64_t cost_of(PLib3MFBase* object, int depth) {
    const DWORD id = id_of(object);
    if (const auto known = costs_.find(id); known != costs_.end()) return known->second;
    if (depth > kMaxDepth) fail("components are nested too deep");
    std::uint64_t cost = SceneCost::kInstance;
    if (is_mesh(object)) {
      const auto [vertices, triangles] = counts_of(object);
      cost += std::uint64_t{vertices} + triangles;
      stored_ = SceneCost::sum(stored_, cost);
    } else {
      for_each_component(
          object, [&](PLib3MFBase* part, const Affine3d&) { cost = SceneCost::sum(cost, cost_of(part, depth + 1)); });
    }
    return costs_[id] = cost;
  }

  void place(PLib3MFBase* object, const Affine3d& to_world) {
    if (!is_mesh(object)) {
      for_each_component(object,
                         [&](PLib3MFBase* part, const Affine3d& transform) { place(part, to_world * transform); });
      return;
    }
    ++soup_.scene.instances;
    const auto [vertices, triangles] = counts_of(object);
    if (vertices == 0 || triangles == 0) return;
    const std::size_t begin = soup_.vertices.size();
    std::vector<MODELMESHVERTEX> positions(vertices);
    std::vector<MODELMESHTRIANGLE> corners(triangles);
    DWORD count = 0;
    check(lib3mf_meshobject_getvertices(object, positions.data(), vertices, &count), "a mesh is malformed");
    check(lib3mf_meshobject_gettriangleindices(object, corners.data(), triangles, &count), "a mesh is malformed");
    for (const MODELMESHVERTEX& v : positions)
      soup_.vertices.push_back(to_world *
                               Eigen::Vector3f(v.m_fPosition[0], v.m_fPosition[1], v.m_fPosition[2]).cast<double>());
    for (const MODELMESHTRIANGLE& triangle : corners) {
      for (const DWORD corner : {triangle.m_nIndices[0], triangle.m_nIndices[1], triangle.m_nIndices[2]}) {
        if (corner >= vertices)
          fail("index " + std::to_string(corner) + " of " + std::to_string(vertices) + " vertices");
        soup_.corners.push_back(static_cast<std::uint32_t>(begin + corner));
      }
      soup_.close_polygon();
    }
  }

  void check(LIB3MFRESULT result, const std::string& otherwise) const {
    if (result != 0) fail(otherwise);
  }
  [[noreturn]] void fail(const std::string& reason) const { throw MeshError(name_ + ": " + reason); }

  const std::string& name_;
  Handle model_;
  double metres_ = 1e-3;
  std::unordered_map<DWORD, std::uint64_t> costs_;  ///< by the number of the object
  std::uint64_t stored_ = 0;
  PolygonSoup soup_;
};

}  // namespace

bool looks_like_3mf(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") && bytes.find("3D/3dmodel.model") != std::string_view::npos;
}

PolygonSoup read_3mf(std::string_view bytes, const std::string& name) {
  check_3mf_parts(bytes, name);
  return Package(bytes, name).place_all();
}

}  // namespace rectilin
