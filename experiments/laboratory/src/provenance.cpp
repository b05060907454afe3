#include "rectilin/laboratory/provenance.h"

#include <tbb/global_control.h>
#include <tbb/version.h>

#include <Eigen/Core>
#include <ctime>
#include <fstream>

#include "rectilin/base/version.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/optim/adapters/all_optimizers.h"

namespace rectilin::laboratory {
namespace {

std::string dotted(int a, int b, int c) {
  return std::to_string(a) + '.' + std::to_string(b) + '.' + std::to_string(c);
}

Json libraries() {
  Json all = {
      {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"oneTBB", dotted(TBB_VERSION_MAJOR, TBB_VERSION_MINOR, TBB_VERSION_PATCH)},
      {"nlohmann_json", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
  all.update(optimizer_libraries());
  return all;
}

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace

Json provenance(const std::string& command_line) {
  return {{"date", now()},
          {"command_line", command_line},
          {"version", version()},
          {"compiler", compiler()},
          {"build", build_type()},
          {"libraries", libraries()},
          {"processor", processor()},
          {"threads", tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)}};
}

void record_start(const Plan& plan, const Registry& registry, const std::filesystem::path& folder,
                  const std::string& command_line) {
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / "provenance.json";
  Json starts = Json::array();
  const Json earlier = read_json_or_null(file);
  if (earlier.is_object() && earlier.contains("starts")) starts = earlier["starts"];
  starts.push_back(provenance(command_line));
  Json optimizers = Json::array();
  for (const Entry& entry : plan.entries) {
    const auto optimizer = registry.make(entry.spec);
    optimizers.push_back({{"label", entry.label},
                          {"name", optimizer->name()},
                          {"parameters", optimizer->parameters()},
                          {"domain", optimizer->capabilities().uses_domain ? Json(entry.domain) : Json(nullptr)}});
  }
  const Json all = {{"plan", to_json(plan)}, {"optimizers", optimizers}, {"starts", starts}};
  write_whole_file(file, to_text(all, 2) + '\n');
}

}  // namespace rectilin::laboratory
