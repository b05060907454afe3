#include "rectilin/laboratory/ioh.h"

#include <algorithm>
#include <cstdio>

#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/plots.h"

namespace rectilin::laboratory {
namespace {

constexpr const char* kVersion = "0.3.17";  // of the format: readers look for at least 0.3.3

struct LoggedPoint {
  double evaluations, gap;
};

/// What the data file says of a run: it begins with evaluation 1 and ends with the last one.
std::vector<LoggedPoint> logged_points(const RunResult& run) {
  std::vector<LoggedPoint> points = {{1, run.trace.worst}};
  for (std::size_t i = 0; i < run.trace.gap.size(); ++i) {
    if (run.trace.evaluations[i] <= points.back().evaluations) points.back().gap = run.trace.gap[i];
    else points.push_back({run.trace.evaluations[i], run.trace.gap[i]});
  }
  if (run.evaluations > points.back().evaluations) points.push_back({run.evaluations, run.trace.final_gap()});
  return points;
}

std::string data_text(const std::vector<LoggedPoint>& points) {
  std::string text = "evaluations raw_y\n";
  for (const LoggedPoint& point : points) {
    char row[64];
    std::snprintf(row, sizeof row, "%.0f %.17g\n", point.evaluations, point.gap);
    text += row;
  }
  return text;
}

Json run_json(const RunResult& run, const std::vector<LoggedPoint>& points) {
  const Eigen::Quaterniond q = run.rotation.quaternion();
  const auto best = std::ranges::min_element(points, {}, &LoggedPoint::gap);
  return {{"instance", run.run + 1},
          {"evals", static_cast<std::uint64_t>(points.back().evaluations)},
          {"best",
           {{"evals", static_cast<std::uint64_t>(best->evaluations)},
            {"y", best->gap},
            {"x", {q.x() / q.w(), q.y() / q.w(), q.z() / q.w()}}}}};
}

/// `name` stands for the mesh.
void export_function(std::size_t mesh, const std::string& name, const Entry& entry,
                     const std::vector<const RunResult*>& runs, const std::filesystem::path& folder) {
  const std::string id = "f" + std::to_string(mesh + 1);
  const std::string data_folder = "data_" + id + "_" + name;
  const std::string data_file = data_folder + "/IOHprofiler_" + id + "_DIM3.dat";
  std::string data;
  Json run_list = Json::array();
  for (const RunResult* run : runs) {
    const std::vector<LoggedPoint> points = logged_points(*run);
    data += data_text(points);
    run_list.push_back(run_json(*run, points));
  }
  const Json scenario = {{"dimension", 3}, {"path", data_file}, {"runs", run_list}};
  const Json info = {{"version", kVersion},
                     {"suite", "rectilin"},
                     {"function_id", mesh + 1},
                     {"function_name", name},
                     {"maximization", false},
                     {"algorithm", {{"name", entry.label}, {"info", entry.spec + " on " + entry.domain}}},
                     {"attributes", {"evaluations", "raw_y"}},
                     {"scenarios", Json::array({scenario})}};
  std::filesystem::create_directories(folder / data_folder);
  write_whole_file(folder / data_file, data);
  write_whole_file(folder / ("IOHprofiler_" + id + "_" + name + ".json"), info.dump(1, '\t') + '\n');
}

}  // namespace

void export_ioh(const Results& results, const std::filesystem::path& folder) {
  std::vector<std::string> titles;
  for (const MeshResult& mesh : results.meshes) titles.push_back(mesh.title);
  const std::vector<std::string> names = unique_slugs(titles);
  for (std::size_t e = 0; e < results.plan.entries.size(); ++e) {
    const Entry& entry = results.plan.entries[e];
    // Labels may differ in signs only, which a slug drops.
    const std::filesystem::path own = folder / (std::to_string(e + 1) + "-" + slug(entry.label));
    for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) {
      const auto runs = results.of(mesh, e);
      if (!runs.empty()) export_function(mesh, names[mesh], entry, runs, own);
    }
  }
}

}  // namespace rectilin::laboratory
