#include "rectilin/laboratory/suite.h"

#include <filesystem>
#include <set>

#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/plots.h"
#include "rectilin/laboratory/results.h"
#include "rectilin/mesh/source.h"

namespace rectilin::laboratory {
namespace {

Suite landscapes() {
  return {
      "landscapes-1",
      "built-in shapes of every kind of landscape",
      {
          {"box", "shape:box?x=1&y=2&z=3&rotate=random&seed=1",
           "three directions at right angles, one much weaker: R = 1 at a sharp corner"},
          {"lshape", "shape:lshape?rotate=random&seed=2", "the same with other weights"},
          {"pyramid", "shape:pyramid?rotate=random&seed=3", "five directions, several local minima"},
          {"prism", "shape:prism?rotate=random&seed=4", "four directions: one axis is plain, the turn about it is not"},
          {"cut-cube", "shape:cut-cube?rotate=random&seed=5",
           "four directions: a sharp minimum beside others nearly as good"},
          {"stairs", "shape:stairs?rotate=random&seed=6", "three directions at right angles, nearly equal weights"},
          {"stepped-pyramid", "shape:stepped-pyramid?steps=20&rotate=random&seed=7", "the same of many small faces"},
          {"filleted-cube", "shape:filleted-cube?rotate=random&seed=8", "a smooth, wide basin"},
          {"noisy-cube", "shape:filleted-cube?noise=0.01&rotate=random&seed=9", "a basin with small ripples"},
          {"cylinder", "shape:cylinder?sides=64&rotate=random&seed=10", "nearly a circle of minima"},
          {"torus", "shape:torus?rotate=random&seed=11", "shallow, nearly a circle of minima"},
          {"ellipsoid", "shape:ellipsoid?rotate=random&seed=12", "smooth and shallow"},
          {"blob", "shape:blob?faces=5000&rotate=random&seed=13", "smooth, many local minima"},
          {"blob-coarse", "shape:blob?faces=200&rotate=random&seed=14", "many local minima with corners"},
          {"soup", "shape:soup?rotate=random&seed=15", "many random directions: flat with many minima"},
      }};
}

/// Bounds of the optimum, with the mesh they are of.
Rectilinearity certified(const ComparedMesh& mesh, const std::string& name, double gap, const LoopControl& control) {
  MeasureOptions options;
  options.certify.gap = gap;
  options.run.stop = control.stop;
  Rectilinearity optimum = measure(ProjectedArea(mesh.vectors, name), options);
  if (optimum.run.outcome == RunRecord::Outcome::kStopped) throw Stopped();
  return optimum;
}

}  // namespace

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {landscapes()};
  return all;
}

const Suite& suite_by_name(std::string_view name) {
  std::vector<std::string> known;
  for (const Suite& suite : suites()) {
    if (suite.name == name) return suite;
    known.push_back(suite.name);
  }
  throw_unknown_name("suite", name, known);
}

Suite suite_of(const std::vector<std::string>& sources) {
  const std::vector<std::string> all = expand_folders(sources);
  if (all.empty()) throw ParameterError("there is no mesh for a suite");
  const std::vector<std::string> names = unique_slugs(titles(all));
  Suite suite{"own", "meshes of one's own", {}};
  for (std::size_t i = 0; i < all.size(); ++i) suite.problems.push_back({names[i], all[i], ""});
  return suite;
}

Json problem_json(const std::string& name, const std::string& source, const ComparedMesh& mesh,
                  const Rectilinearity& optimum) {
  Json vectors = Json::array();
  const AreaVectors& v = mesh.vectors;
  for (std::size_t i = 0; i < v.size(); ++i) vectors.push_back({v.x[i] / v.total, v.y[i] / v.total, v.z[i] / v.total});
  const auto end = [&](double Interval::*member) {
    return optimum.bounds ? Json((*optimum.bounds).*member) : Json(nullptr);
  };
  return {{"format", "rectilin problem"},
          {"version", 1},
          {"name", name},
          {"source", source},
          {"digest", mesh.digest},
          {"faces", mesh.faces},
          {"directions", v.size()},
          {"value", optimum.run.incumbent.value},
          {"value_lower", optimum.run.value_bound ? Json(*optimum.run.value_bound) : Json(nullptr)},
          {"rectilinearity", optimum.value},
          {"lower", end(&Interval::lower)},
          {"upper", end(&Interval::upper)},
          {"rotation", to_json(optimum.rotation)},
          {"vectors", vectors}};
}

void export_suite(const Suite& suite, const std::filesystem::path& folder, double gap, const LoopControl& control) {
  std::filesystem::create_directories(folder);
  std::vector<std::string> names;
  for (const SuiteProblem& problem : suite.problems) names.push_back(problem.source);
  const auto work = [&](std::size_t i) {
    const SuiteProblem& problem = suite.problems[i];
    const ComparedMesh mesh = load_compared_mesh(problem.source);
    return problem_json(problem.name, problem.source, mesh, certified(mesh, problem.name, gap, control));
  };
  Json list = Json::array();
  const auto write = [&](std::size_t i, Outcome<Json>&& problem) {
    if (!problem.value) throw MeshError(problem.error);
    const SuiteProblem& what = suite.problems[i];
    write_whole_file(folder / (what.name + ".json"), to_text(*problem.value) + '\n');
    Json entry = std::move(*problem.value);
    entry.erase("vectors");
    entry.erase("format");
    entry.erase("version");
    entry["landscape"] = what.landscape;
    list.push_back(std::move(entry));
  };
  if (for_each_in_order<Json>(names, work, write, control) < names.size()) throw Stopped();
  const Json json = {
      {"format", "rectilin suite"}, {"version", 1}, {"name", suite.name}, {"help", suite.help}, {"problems", list}};
  write_whole_file(folder / "suite.json", to_text(json, 2) + '\n');
}

}  // namespace rectilin::laboratory
