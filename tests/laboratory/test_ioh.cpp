// The IOHprofiler export against the layout its readers document.
#include <algorithm>
#include <cmath>

#include "comparison_fixtures.h"
#include "rectilin/laboratory/ioh.h"
#include "support/catch.h"

namespace rectilin::laboratory {
namespace {

using test::mesh_with;
using test::run_with;
using test::ScratchFolder;
using test::text_of;

/// Blocks of a data file: (evaluations, raw_y) after each header.
std::vector<std::vector<std::pair<double, double>>> blocks(const std::filesystem::path& file) {
  std::vector<std::vector<std::pair<double, double>>> result;
  std::istringstream in(text_of(file));
  for (std::string line; std::getline(in, line);) {
    if (line == "evaluations raw_y") {
      result.emplace_back();
      continue;
    }
    REQUIRE_FALSE(result.empty());
    std::istringstream numbers(line);
    std::string evaluations, gap;
    numbers >> evaluations >> gap;
    result.back().emplace_back(std::stod(evaluations), std::stod(gap));
  }
  return result;
}

bool at_least(const std::string& version, std::vector<int> least) {
  std::istringstream in(version);
  std::vector<int> parts;
  for (std::string part; std::getline(in, part, '.');) parts.push_back(std::stoi(part));
  return !std::ranges::lexicographical_compare(parts, least);
}

TEST_CASE("IOHprofiler files") {
  const double third = 1.0 / 3;
  Results results;
  results.plan.meshes = {"odd name/(x).off"};
  results.plan.entries = {{"ga@zone", "ga", "zone"}, {"idle", "idle", "covering"}};
  results.meshes = {mesh_with("odd name/(x).off", 0.5, 0.5)};
  results.runs = {run_with(0, 0, 0, {1, 30, 40}, {0.5, third, 1e-12}, 100),
                  run_with(0, 0, 1, {20, 20, 60}, {0.4, 0.35, third}, 60),  // the first cost 20, and two at one cost
                  run_with(0, 0, 2, {}, {}, 0)};                            // failed before it evaluated anything
  const ScratchFolder scratch;
  export_ioh(results, scratch.path());

  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) folders.push_back(entry.path());
  REQUIRE(folders.size() == 1);  // `idle` has no runs
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folders.front()))
    if (entry.is_regular_file()) files.push_back(entry.path());
  REQUIRE(files.size() == 1);
  const std::string name = files.front().filename().string();
  CHECK(name.starts_with("IOHprofiler_f1_"));
  CHECK(name.find_first_of(" ()/") == std::string::npos);

  const Json info = Json::parse(text_of(files.front()));
  CHECK(at_least(info.at("version"), {0, 3, 3}));
  CHECK(info.at("suite").is_string());
  CHECK(info.at("function_id") == 1);
  CHECK(name == "IOHprofiler_f1_" + info.at("function_name").get<std::string>() + ".json");
  CHECK(info.at("maximization") == false);
  CHECK(info.at("algorithm").at("name") == "ga@zone");
  CHECK(info.at("algorithm").at("info").is_string());
  CHECK(info.at("attributes") == Json({"evaluations", "raw_y"}));
  REQUIRE(info.at("scenarios").size() == 1);
  const Json& scenario = info.at("scenarios").front();
  CHECK(scenario.at("dimension") == 3);
  CHECK(scenario.at("path") == "data_f1_" + info.at("function_name").get<std::string>() + "/IOHprofiler_f1_DIM3.dat");

  const auto data = blocks(folders.front() / scenario.at("path").get<std::string>());
  REQUIRE(data.size() == 3);
  REQUIRE(scenario.at("runs").size() == 3);
  for (std::size_t i = 0; i < data.size(); ++i) {
    const Json& run = scenario.at("runs")[i];
    CHECK(run.at("instance") == i + 1);
    CHECK(run.at("best").at("x").size() == 3);
    // Readers tell runs apart by evaluation 1: it must be there once.
    CHECK(data[i].front().first == 1);
    CHECK(std::ranges::adjacent_find(data[i], [](auto a, auto b) { return a.first >= b.first; }) == data[i].end());
    CHECK(data[i].back().first == run.at("evals").get<double>());
    CHECK(run.at("best").at("y").get<double>() == data[i].back().second);
  }
  CHECK(data[0].size() == 4);
  CHECK(data[0][1] == std::pair(30.0, third));  // all digits
  CHECK(data[0].back() == std::pair(100.0, 1e-12));
  CHECK(scenario.at("runs")[0].at("best").at("evals") == 40);
  CHECK(data[1].front() == std::pair(1.0, 1.25));  // nothing is known before evaluation 20
  CHECK(data[1][1] == std::pair(20.0, 0.35));
  CHECK(data[2].size() == 1);
}

}  // namespace
}  // namespace rectilin::laboratory
