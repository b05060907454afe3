#include "rectilin/laboratory/results.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "rectilin/base/journal.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/measure/projected_area.h"

namespace rectilin::laboratory {
namespace {

namespace fs = std::filesystem;

double number(const Json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Rotation rotation_from_json(const Json& rows) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = rows.at(i).at(j).get<double>();
  return Rotation::from_matrix(m);
}

MeshResult mesh_from_json(const Json& line) {
  MeshResult mesh;
  mesh.name = line.at("mesh").get<std::string>();
  if (line.contains("error")) {
    mesh.error = line.at("error").get<std::string>();
    return mesh;
  }
  mesh.left_out = line.value("left_out", "");
  line.at("faces").get_to(mesh.faces);
  line.at("directions").get_to(mesh.directions);
  mesh.area = number(line.at("area"));                  // null if out of range
  const bool proved = line.contains("rectilinearity");  // otherwise the best value of a search, for another objective
  const double found = number(line.at(proved ? "rectilinearity" : "merit")), upper = number(line.at("upper"));
  mesh.upper = std::isnan(upper) ? 1.0 : std::min(upper, 1.0);  // because S <= P for any mesh
  mesh.lower = std::isnan(found) ? rectilinearity(std::sqrt(3.0)) : std::min(found, mesh.upper);
  if (!proved) mesh.upper = mesh.lower = found;
  mesh.rotation = rotation_from_json(line.at("rotation"));
  mesh.evaluations = number(line.at("evaluations"));
  mesh.seconds = number(line.at("seconds"));
  return mesh;
}

Trace trace_from_json(const Json& json, const MeshResult& mesh, bool proves) {
  Trace trace;
  trace.worst =
      mesh.upper + (proves ? -rectilinearity(std::sqrt(3.0)) : std::sqrt(3.0));  // because no value exceeds sqrt(3)
  json.at("evaluations").get_to(trace.evaluations);
  json.at("seconds").get_to(trace.seconds);
  for (const Json& merit : json.at("merit"))
    trace.gap.push_back(std::max(mesh.upper - merit.get<double>(), mesh.width()));
  return trace;
}

RunResult run_from_json(Json line, const Results& results) {
  RunResult run;
  const auto index = [](const auto& list, auto member, const Json& name) {
    const auto found = std::ranges::find(list, name.get<std::string>(), member);
    if (found == list.end()) throw std::out_of_range(to_text(name) + " is not in the plan");
    return static_cast<std::size_t>(found - list.begin());
  };
  run.mesh = index(results.meshes, &MeshResult::name, line.at("mesh"));
  run.entry = index(results.plan.entries, &Entry::label, line.at("entry"));
  line.at("run").get_to(run.run);
  run.failed = line.at("outcome") == "failed";
  run.merit = number(line.at("merit"));
  // What was found on the turned mesh is turned back: R (Q v) = (R Q) v.
  run.rotation = reduce_to_zone(rotation_from_json(line.at("rotation")) * rotation_from_json(line.at("instance")));
  run.evaluations = number(line.at("evaluations"));
  run.seconds = number(line.at("seconds"));
  run.cpu_seconds = number(line.at("cpu_seconds"));
  run.trace = trace_from_json(line.at("trace"), results.meshes[run.mesh], results.plan.proves());
  line.erase("trace");
  run.record = std::move(line);
  return run;
}

}  // namespace

double MeshResult::width() const { return std::max(upper - lower, kLeastGap); }

double Trace::gap_after(Cost unit, double spent) const {
  const std::vector<double>& steps = cost(unit);
  const auto after = std::ranges::upper_bound(steps, spent);
  return after == steps.begin() ? worst : gap[static_cast<std::size_t>(after - steps.begin()) - 1];
}

double Trace::cost_to(Cost unit, double target) const {
  const auto step = std::ranges::find_if(gap, [&](double g) { return g <= target; });
  if (step == gap.end()) return std::numeric_limits<double>::infinity();
  return cost(unit)[static_cast<std::size_t>(step - gap.begin())];
}

std::vector<const RunResult*> Results::of(std::size_t mesh, std::size_t entry) const {
  std::vector<const RunResult*> found;
  for (const RunResult& run : runs)
    if (run.mesh == mesh && run.entry == entry) found.push_back(&run);
  return found;
}

std::vector<std::string> titles(const std::vector<std::string>& sources) {
  std::vector<std::string> result;
  std::map<std::string, int> count;
  for (const std::string& source : sources) {
    const bool shape = source.starts_with("shape:");
    result.push_back(shape ? source.substr(6) : fs::path(source).stem().string());
    ++count[result.back()];
  }
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (count[result[i]] > 1) result[i] = sources[i];
  return result;
}

Results load_results(const fs::path& folder) {
  Results results;
  const fs::path plan = folder / "plan.json";
  std::error_code unknown;  // read_whole_file() will say what is wrong
  if (fs::status(plan, unknown).type() == fs::file_type::not_found)
    throw std::runtime_error(folder.string() + ": holds no comparison (there is no plan.json)");
  try {
    results.plan = plan_from_json(parse_json(read_whole_file(plan)));
  } catch (const Json::exception&) {
    throw std::runtime_error(plan.string() + ": is not the plan of a comparison");
  }

  const std::vector<std::string> title = titles(results.plan.meshes);
  std::map<std::string, MeshResult> known;
  const fs::path meshes = folder / "meshes.jsonl", runs = folder / "runs.jsonl";
  for_each_line(meshes, recover_journal(meshes), [&](const Json& line) {
    MeshResult mesh = mesh_from_json(line);
    known[mesh.name] = mesh;
  });
  for (std::size_t i = 0; i < title.size(); ++i) {
    MeshResult mesh = known[results.plan.meshes[i]];
    if (mesh.name.empty()) mesh.error = "not measured yet";
    mesh.name = results.plan.meshes[i];
    mesh.title = title[i];
    results.meshes.push_back(std::move(mesh));
  }
  // Without a proof the best known value takes the place of the bound.
  if (!results.plan.proves()) {
    for_each_line(runs, recover_journal(runs), [&](const Json& line) {
      const auto mesh = std::ranges::find(results.meshes, line.at("mesh").get<std::string>(), &MeshResult::name);
      const double merit = number(line.at("merit"));
      if (mesh != results.meshes.end() && merit > mesh->upper) mesh->upper = merit;
    });
    for (MeshResult& mesh : results.meshes) mesh.lower = mesh.upper - kLeastKnownGap;
  }
  std::set<std::tuple<std::size_t, std::size_t, int>> seen;
  const auto take = [&](const Json& line) {
    RunResult run = run_from_json(line, results);
    if (seen.emplace(run.mesh, run.entry, run.run).second) results.runs.push_back(std::move(run));
  };
  for_each_line(runs, recover_journal(runs), take);
  const fs::path foreign = folder / kForeignFile;
  for_each_line(foreign, recover_journal(foreign), [&](const Json& line) {
    const std::string label = line.at("entry").get<std::string>();
    if (std::ranges::find(results.plan.entries, label, &Entry::label) == results.plan.entries.end())
      results.plan.entries.push_back({label, "foreign:" + label, "-"});
    take(line);
  });
  std::ranges::sort(results.runs, {}, [](const RunResult& r) { return std::tuple(r.mesh, r.entry, r.run); });
  std::vector<double> best;  // a run can find a better rotation than the proof of the bounds did
  for (const MeshResult& mesh : results.meshes) best.push_back(mesh.lower);
  for (const RunResult& run : results.runs) {
    if (!(run.merit > best[run.mesh])) continue;
    best[run.mesh] = run.merit;
    results.meshes[run.mesh].rotation = run.rotation;
  }
  return results;
}

}  // namespace rectilin::laboratory
