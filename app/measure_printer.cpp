#include "measure_printer.h"

#include <iostream>
#include <numbers>

#include "rectilin/mesh/mesh_report.h"

namespace rectilin::app {
namespace {

Json to_json(const std::string& name, const Outcome<MeasuredMesh>& row) {
  Json line = {{"name", name}};
  if (!row.value) {
    line["error"] = row.error;
    return line;
  }
  line.update(rectilin::to_json(row.value->result));
  line["report"] = rectilin::to_json(row.value->report);
  return line;
}

std::vector<Table::Column> columns(const std::vector<std::string>& sources) {
  return {{"name", widest(sources)}, {"faces", 8},  {"directions", 8}, {"area", 11}, {"R", 12},
          {"at most", 12},           {"alpha", 8},  {"beta", 8},       {"gamma", 8}, {"optimizer", 9},
          {"evaluations", 8},        {"seconds", 8}};
}

std::vector<std::string> cells(const std::string& name, const Rectilinearity& r) {
  const Eigen::Vector3d degrees = euler_from_rotation(r.rotation) * (180 / std::numbers::pi);
  return {name,
          std::to_string(r.faces),
          std::to_string(r.directions),
          general(r.area, 6),
          fixed(r.value, 10),
          r.bounds ? fixed(r.bounds->upper, 10) : "-",
          fixed(degrees[0], 3),
          fixed(degrees[1], 3),
          fixed(degrees[2], 3),
          r.run.optimizer,
          std::to_string(r.run.costs.evaluations()),
          fixed(r.run.seconds, 3)};
}

}  // namespace

MeasurePrinter::MeasurePrinter(const std::vector<std::string>& sources, bool json)
    : json_(json), table_(columns(sources)) {
  if (json_) return;
  std::cout << table_.header() << '\n';
  check_output();
}

void MeasurePrinter::print(const std::string& name, const Outcome<MeasuredMesh>& row) {
  if (!row.value) {
    ++failed_;
    complain(row.error);
  } else {
    complain_of_loss(name, row.value->report);
  }
  if (json_) std::cout << to_text(to_json(name, row)) << '\n';
  else if (row.value) std::cout << table_.row(cells(name, row.value->result)) << '\n';
  check_output();
}

}  // namespace rectilin::app
