#include <iostream>
#include <numbers>

#include "measure_row.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/mesh_report.h"

namespace rectilin::app {
namespace {

const char* to_string(Optimum::Kind kind) {
  switch (kind) {
    case Optimum::Kind::kPoint:
      return "point";
    case Optimum::Kind::kContinuum:
      return "continuum";
    case Optimum::Kind::kPossible:
      return "possible";
  }
  return "";
}

Json to_json(const std::vector<Optimum>& optima) {
  Json list = Json::array();
  for (const Optimum& optimum : optima)
    list.push_back({{"kind", to_string(optimum.kind)},
                    {"rectilinearity", rectilinearity(optimum.value)},
                    {"rotation", rectilin::to_json(optimum.rotation)}});
  return list;
}

Json to_json(const Row& row) {
  if (!row.error.empty()) return {{"name", row.name}, {"error", row.error}};
  const RunRecord& run = row.run;
  const bool certified = run.lower.has_value();
  Json line = {{"name", row.name},
               {"faces", row.faces},
               {"directions", row.directions},
               {"area", row.area},
               {"rectilinearity", run.merit},
               {"lower", certified ? Json(rectilinearity(run.incumbent.value + row.value_error)) : Json(nullptr)},
               {"upper", certified ? Json(rectilinearity(*run.lower)) : Json(nullptr)},
               {"rotation", rectilin::to_json(run.incumbent.rotation)}};
  const Json details = rectilin::to_json(run);
  for (const char* key : {"optimizer", "parameters", "domain", "seed", "outcome", "evaluations", "values", "cuts",
                          "smooths", "turns", "seconds", "cpu_seconds", "threads", "digest"})
    line[key] = details[key];
  if (row.certified) {
    line["cells"] = row.certified->cells;
    line["parallel_faces"] = row.parallel_faces;
    if (!row.certified->optima.empty()) line["optima"] = to_json(row.certified->optima);
  }
  line["report"] = rectilin::to_json(row.report);
  return line;
}

std::vector<Table::Column> columns(const std::vector<std::string>& sources) {
  return {{"name", widest(sources)}, {"faces", 8},  {"directions", 8}, {"area", 11}, {"R", 12},
          {"at most", 12},           {"alpha", 8},  {"beta", 8},       {"gamma", 8}, {"optimizer", 9},
          {"evaluations", 8},        {"seconds", 8}};
}

std::vector<std::string> cells(const Row& row) {
  const Eigen::Vector3d degrees = euler_from_rotation(row.run.incumbent.rotation) * (180 / std::numbers::pi);
  return {row.name,
          std::to_string(row.faces),
          std::to_string(row.directions),
          general(row.area, 6),
          fixed(row.run.merit, 10),
          row.run.lower ? fixed(rectilinearity(*row.run.lower), 10) : "-",
          fixed(degrees[0], 3),
          fixed(degrees[1], 3),
          fixed(degrees[2], 3),
          row.run.optimizer,
          std::to_string(row.run.costs.evaluations()),
          fixed(row.run.seconds, 3)};
}

}  // namespace

Printer::Printer(const std::vector<std::string>& sources, bool json)
    : json_(json), progress_(sources.size()), table_(columns(sources)) {
  if (!json_) std::cout << table_.header() << '\n' << std::flush;
  if (!sources.empty()) progress_.show(0, sources.front());
}

void Printer::print(const Row& row) {
  progress_.clear();
  ++done_;
  if (!row.error.empty()) {
    ++failed_;
    // Errors of files begin with the file's name; the others do not.
    complain(row.error.starts_with(row.name) ? row.error : row.name + ": " + row.error);
  }
  if (row.error.empty()) complain_of_loss(row.name, row.report);
  if (json_) std::cout << to_text(to_json(row)) << '\n';
  else if (row.error.empty()) std::cout << table_.row(cells(row)) << '\n';
  check_output();
  progress_.show(done_, row.name);
}

}  // namespace rectilin::app
