#include "search.h"

#include <pybind11/stl.h>

#include "beside.h"
#include "mesh.h"
#include "rectilin/base/printable.h"
#include "rectilin/search/approximate.h"
#include "rectilin/search/database.h"
#include "rectilin/search/describe.h"
#include "rectilin/search/duplicates.h"
#include "rectilin/search/index.h"
#include "rectilin/search/nearest.h"
#include "threads.h"

namespace rectilin::python {
namespace {

/// rectilin.Database: what of a file can be found, in memory. Nothing changes it.
struct LoadedDatabase {
  std::string file, descriptor;
  std::vector<search::Member> members;  ///< those with a signature, in the order of `nearest`
  std::vector<std::pair<std::string, std::string>> failed;
  std::vector<retrieval::DescriptorPointer> terms;
  search::NearestSearch nearest;
  /// For approximate=True; made at the first such search, while the GIL is held.
  mutable std::shared_ptr<const search::ApproximateSearch> graph = {};
};

struct Neighbours {
  std::vector<std::string> names;
  std::vector<std::int64_t> members;
  std::vector<double> distances;
};

/// OSError for what the house throws as a runtime_error: files that cannot be read or written, or are of another kind.
template <class Work>
auto as_os_error(const Work& work) {
  try {
    return work();
  } catch (const MeshError&) {
    throw;
  } catch (const ParameterError&) {
    throw;
  } catch (const py::error_already_set&) {
    throw;
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const std::runtime_error& e) {
    PyErr_SetString(PyExc_OSError, printable(e.what()).c_str());
    throw py::error_already_set();
  }
}

std::shared_ptr<LoadedDatabase> open_database(py::handle given) {
  const std::string file = source_of(given);
  return as_os_error([&] {
    std::shared_ptr<LoadedDatabase> loaded;
    const py::gil_scoped_release release;
    search::Database database{std::filesystem::path(file)};
    loaded = std::make_shared<LoadedDatabase>(LoadedDatabase{file,
                                                             database.descriptor(),
                                                             {},
                                                             {},
                                                             search::make_terms(database.descriptor()),
                                                             search::NearestSearch(database.descriptor())});
    loaded->nearest.reserve(database.described());
    database.for_each_signature([&](search::Member&& member, search::Parts&& parts) {
      loaded->nearest.add(parts);
      loaded->members.push_back(std::move(member));
    });
    for (const search::Member& member : database.members())
      if (member.status == search::MemberStatus::kFailed) loaded->failed.emplace_back(member.name, member.error);
    return loaded;
  });
}

/// A member by its name or its place.
std::size_t member_of(const LoadedDatabase& database, py::handle given) {
  if (py::isinstance<py::str>(given)) {
    const std::string name = source_of(given);
    const auto found = std::ranges::lower_bound(database.members, name, {}, &search::Member::name);
    if (found != database.members.end() && found->name == name)
      return static_cast<std::size_t>(found - database.members.begin());
    for (const auto& [failed, error] : database.failed)
      if (failed == name) throw py::key_error(database.file + ": no member '" + name + "' with a signature: " + error);
    throw py::key_error(database.file + ": no member '" + name + "'");
  }
  const std::uint64_t place = whole_number(given, "like", 0).value();
  if (place >= database.members.size())
    throw py::index_error("like is " + std::to_string(place) + ", but there are " +
                          std::to_string(database.members.size()) + " members");
  return static_cast<std::size_t>(place);
}

/// A bool for each member; empty for None.
std::vector<bool> mask_of(py::handle given, std::size_t members) {
  if (given.is_none()) return {};
  const py::array mask = py::array::ensure(given);
  if (!mask) {
    PyErr_Clear();
    throw py::type_error("keep is no array of bools");
  }
  if (mask.dtype().kind() != 'b') throw py::type_error("keep is an array of bools, one for each member");
  if (mask.ndim() != 1 || static_cast<std::size_t>(mask.shape(0)) != members)
    throw py::value_error("keep has to be a bool for each of the " + std::to_string(members) + " members");
  const auto bools = py::array_t<bool>(mask).unchecked<1>();
  std::vector<bool> keep(members);
  for (std::size_t i = 0; i < members; ++i) keep[i] = bools(static_cast<py::ssize_t>(i));
  return keep;
}

/// The graph in the file beside the database, or built now. Ctrl-C stops that; the next call goes on.
std::shared_ptr<const search::ApproximateSearch> graph_of(const LoadedDatabase& database) {
  if (database.graph) return database.graph;
  std::string note;
  std::shared_ptr<const search::ApproximateSearch> graph = as_os_error([&] {
    return with_progress(py::none(), [&](const LoopControl& control) {
      return search::open_approximate(database.nearest, database.members, search::graph_file(database.file), control,
                                      note);
    });
  });
  if (!note.empty() && PyErr_WarnEx(PyExc_RuntimeWarning, printable(note).c_str(), 1) < 0)
    throw py::error_already_set();
  database.graph = graph;
  return graph;
}

Neighbours find(const LoadedDatabase& database, py::handle vertices, py::handle faces, py::handle like,
                py::handle count, py::handle keep, bool collection, bool approximate, py::handle threads) {
  if (vertices.is_none() == like.is_none())
    throw ParameterError("search for a mesh or, with like=, for what is like a member");
  const std::size_t n = whole_number(count, "count", 1).value_or(20);
  const std::vector<bool> kept = mask_of(keep, database.members.size());
  const auto limit = limit_threads(threads);
  std::optional<std::size_t> member;
  std::optional<Mesh> mesh;
  if (like.is_none()) mesh = GivenMesh(vertices, faces).copy();
  else member = member_of(database, like);
  Neighbours result;
  const auto graph = approximate ? graph_of(database) : nullptr;
  const py::gil_scoped_release release;
  const search::Parts query = member ? database.nearest.parts_of(*member)
                                     : search::describe_model(retrieval::Model(std::move(*mesh)), database.terms).parts;
  const auto wanted = [&](std::size_t i) { return (!member || *member != i) && (kept.empty() || kept[i]); };
  const auto found = search::find_nearest(database.nearest, graph.get(), query, n, wanted, collection);
  for (const search::Neighbour& neighbour : found) {
    result.names.push_back(database.members[neighbour.member].name);
    result.members.push_back(static_cast<std::int64_t>(neighbour.member));
    result.distances.push_back(neighbour.distance);
  }
  return result;
}

py::dict index(py::handle sources, py::handle out, const std::optional<std::string>& descriptor, py::handle threads,
               py::object progress) {
  const std::vector<std::string> names = sources_of(sources);
  const std::string file = source_of(out);
  const auto limit = limit_threads(threads);
  const search::IndexSummary done = as_os_error([&] {
    return with_progress(std::move(progress), [&](const LoopControl& control) {
      search::Database database(file, descriptor.value_or(""));
      return search::update_index(database, names, control);
    });
  });
  return py::dict(py::arg("added") = done.added, py::arg("changed") = done.changed, py::arg("moved") = done.moved,
                  py::arg("copied") = done.copied, py::arg("removed") = done.removed,
                  py::arg("unchanged") = done.unchanged, py::arg("errors") = names_to_python(done.errors));
}

py::dict duplicates(py::handle file, double tolerance, py::handle neighbours, py::handle threads, py::object progress) {
  search::DuplicateOptions options;
  if (!(tolerance > 0 && std::isfinite(tolerance))) throw ParameterError("tolerance is not a positive number");
  options.tolerance = tolerance;
  options.neighbours = whole_number(neighbours, "neighbours", 1).value_or(options.neighbours);
  const std::string path = source_of(file);
  const auto limit = limit_threads(threads);
  const search::Duplicates found = as_os_error([&] {
    return with_progress(std::move(progress), [&](const LoopControl& control) {
      search::Database database{std::filesystem::path(path)};
      return search::find_duplicates(database, options, control);
    });
  });
  py::list groups;
  for (const search::DuplicateGroup& group : found.groups) {
    py::list names, mirrored, evidence;
    for (std::size_t k = 0; k < group.members.size(); ++k) {
      names.append(name_to_python(found.members[group.members[k]].name));
      mirrored.append(static_cast<bool>(group.mirrored[k]));
    }
    for (const search::DuplicateEvidence& e : group.evidence)
      evidence.append(py::dict(py::arg("first") = name_to_python(found.members[e.first].name),
                               py::arg("second") = name_to_python(found.members[e.second].name),
                               py::arg("same_bytes") = e.same_bytes, py::arg("mirrored") = e.mirrored,
                               py::arg("descriptor_distance") = e.descriptor_distance,
                               py::arg("surface_distance") = e.surface_distance, py::arg("scale") = e.scale));
    groups.append(py::dict(py::arg("names") = names, py::arg("mirrored") = mirrored, py::arg("evidence") = evidence));
  }
  return py::dict(py::arg("groups") = groups, py::arg("errors") = names_to_python(found.errors),
                  py::arg("pairs_looked_at") = found.pairs_looked_at);
}

template <class Number, class Get>
py::array_t<Number> column(const LoadedDatabase& database, const Get& get) {
  py::array_t<Number> array(static_cast<py::ssize_t>(database.members.size()));
  Number* out = array.mutable_data();
  for (const search::Member& member : database.members) *out++ = static_cast<Number>(get(member));
  return array;
}

std::vector<std::string> texts_of(const LoadedDatabase& database, std::string search::Member::*field) {
  std::vector<std::string> texts;
  for (const search::Member& member : database.members) texts.push_back(member.*field);
  return texts;
}

py::array_t<std::uint8_t> signature_of(const LoadedDatabase& database, py::handle member) {
  std::vector<std::uint8_t> bytes;
  for (const retrieval::Signature& part : database.nearest.parts_of(member_of(database, member)))
    bytes.insert(bytes.end(), part.begin(), part.end());
  return py::array_t<std::uint8_t>(static_cast<py::ssize_t>(bytes.size()), bytes.data());
}

}  // namespace

void bind_search(py::module_& m) {
  py::class_<Neighbours>(m, "Neighbours", "What search() found, nearest first. Its length is how many there are.")
      .def_property_readonly(
          "names", [](const Neighbours& n) { return names_to_python(n.names); }, "Names of the members, a list of str.")
      .def_property_readonly(
          "members", [](const Neighbours& n) { return py::array(py::cast(n.members)).attr("astype")("int64"); },
          "(k,) int64: their places in the database's arrays.")
      .def_property_readonly(
          "distances",
          [](const Neighbours& n) {
            return py::array_t<double>(static_cast<py::ssize_t>(n.distances.size()), n.distances.data());
          },
          "(k,) float64: how far each is from the query; comparable within one database only.")
      .def("__len__", [](const Neighbours& n) { return n.names.size(); })
      .def("__repr__", [](const Neighbours& n) {
        return "<rectilin.Neighbours: " + std::to_string(n.names.size()) +
               (n.names.empty() ? "" : ", the nearest " + printable(n.names.front())) + ">";
      });

  py::class_<LoadedDatabase, std::shared_ptr<LoadedDatabase>>(m, "Database", R"(A database of shapes, read into memory.

Database(file): what index() made. It stays as it was when it was read. Members are those that have a signature, in the
order of their names; all arrays are in this order. Raises OSError if the file cannot be read or is another kind of file.

    >>> _ = rectilin.index(['shape:box', 'shape:torus'], 'shapes.db', descriptor='d2')
    >>> shapes = rectilin.Database('shapes.db')
    >>> shapes.names
    ['shape:box', 'shape:torus'])")
      .def(py::init(&open_database), py::arg("file"))
      .def_property_readonly("file", [](const LoadedDatabase& d) { return name_to_python(d.file); })
      .def_readonly("descriptor", &LoadedDatabase::descriptor, "What its shapes are compared by, see descriptors().")
      .def_property_readonly(
          "names", [](const LoadedDatabase& d) { return texts_of(d, &search::Member::name); }, "A list of str.")
      .def_property_readonly(
          "sources", [](const LoadedDatabase& d) { return texts_of(d, &search::Member::source); },
          "A list of str: where each mesh lies, for load().")
      .def_property_readonly(
          "rectilinearity",
          [](const LoadedDatabase& d) { return column<double>(d, [](const auto& row) { return row.rectilinearity; }); },
          "(n,) float64: R, certified to 1e-6.")
      .def_property_readonly(
          "faces",
          [](const LoadedDatabase& d) { return column<std::int64_t>(d, [](const auto& row) { return row.faces; }); },
          "(n,) int64: number of triangles.")
      .def_property_readonly(
          "size", [](const LoadedDatabase& d) { return column<double>(d, [](const auto& row) { return row.size; }); },
          "(n,) float64: longest side of the box around each, in its file's unit.")
      .def_property_readonly(
          "failed",
          [](const LoadedDatabase& d) {
            py::dict failed;
            for (const auto& [name, error] : d.failed) failed[name_to_python(name)] = name_to_python(error);
            return failed;
          },
          "A dict: files that have no signature, with the reason.")
      .def("signature", &signature_of, py::arg("member"),
           "A member's signature, (bytes,) uint8, for distance(); member: a name or a place.")
      .def("search", &find, py::arg("V") = py::none(), py::arg("F") = py::none(), py::kw_only(),
           py::arg("like") = py::none(), py::arg("count") = 20, py::arg("keep") = py::none(),
           py::arg("collection") = false, py::arg("approximate") = false, py::arg("threads") = py::none(),
           "As rectilin.search().")
      .def("__len__", [](const LoadedDatabase& d) { return d.members.size(); })
      .def("__repr__", [](const LoadedDatabase& d) {
        return "<rectilin.Database '" + printable(d.file) + "': " + std::to_string(d.members.size()) + " shapes by " +
               d.descriptor + ">";
      });

  m.def("index", &index, py::arg("sources"), py::arg("out"), py::kw_only(), py::arg("descriptor") = py::none(),
        py::arg("threads") = py::none(), py::arg("progress") = py::none(),
        R"(Describes the shapes of folders in a database to search: a file, made if it does not exist.

sources: folders, mesh files, archives, lists of them; one or a list. Files that are in the database and have the same
bytes are not read again; what is gone from the sources is removed. out: the database. descriptor: what shapes are
compared by, see descriptors(); fixed when the database is made (default: 'best'). progress: called now and then with
(done, total, text). Ctrl-C stops it; the same call goes on.

Returns a dict: how many members were added, changed, moved, copied, removed, unchanged; errors, a line for each file
that has no signature. Raises ParameterError for a database of another descriptor, OSError for one that cannot be
written.

    >>> rectilin.index(['shape:box', 'shape:torus'], 'two.db', descriptor='d2')['added']
    2)");
  m.def(
      "search",
      [](py::handle database, py::handle vertices, py::handle faces, py::handle like, py::handle count, py::handle keep,
         bool collection, bool approximate, py::handle threads) {
        if (py::isinstance<LoadedDatabase>(database))
          return find(database.cast<const LoadedDatabase&>(), vertices, faces, like, count, keep, collection,
                      approximate, threads);
        return find(*open_database(database), vertices, faces, like, count, keep, collection, approximate, threads);
      },
      py::arg("database"), py::arg("V") = py::none(), py::arg("F") = py::none(), py::kw_only(),
      py::arg("like") = py::none(), py::arg("count") = 20, py::arg("keep") = py::none(), py::arg("collection") = false,
      py::arg("approximate") = false, py::arg("threads") = py::none(),
      R"(Finds the shapes of a database that are most like a mesh, in any position, rotation and scale.

database: a Database or the name of its file, which is then read for this call alone. V, F: see measure(). like: instead
of a mesh a member, by its name or its place. count: how many to find. keep: (n,) bools, which members may be found, such
as database.rectilinearity > 0.8. collection: rank by diffusion through the collection; what lies between two shapes
makes them alike. The result is exact: the same as if the query were compared with every member. approximate: search by
a graph that is kept in a file beside the database and built at the first such search, ten minutes for a million shapes;
some of the nearest may be missed.

Returns Neighbours. Raises MeshError for a mesh without a signature, KeyError or IndexError if there is no such member,
OSError if the file cannot be read.

    >>> _ = rectilin.index(['shape:box', 'shape:torus'], 'shapes.db', descriptor='d2')
    >>> rectilin.search('shapes.db', 'shape:box?x=1.2&rotate=random', count=1).names
    ['shape:box'])");
  m.def("duplicates", &duplicates, py::arg("database"), py::kw_only(),
        py::arg("tolerance") = search::DuplicateOptions().tolerance,
        py::arg("neighbours") = search::DuplicateOptions().neighbours, py::arg("threads") = py::none(),
        py::arg("progress") = py::none(),
        R"(Finds files of a database that hold one shape, whatever their format, pose, scale and tessellation.

database: name of its file; the meshes of candidates are read again. tolerance: root mean square distance of the surfaces
up to which they are one shape, in radii. neighbours: of each shape so many are looked at. progress: as for index().

Returns a dict: groups, each with names, mirrored (whether each is a mirror image of the first) and evidence, a dict for
each pair that holds the group together; errors, a line for each file that cannot be read any more; pairs_looked_at.

    >>> _ = rectilin.index(['shape:lshape', 'shape:lshape?rotate=random', 'shape:torus'], 'three.db', descriptor='d2')
    >>> [len(group['names']) for group in rectilin.duplicates('three.db')['groups']]
    [2])");
}

}  // namespace rectilin::python
