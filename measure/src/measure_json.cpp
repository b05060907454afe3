#include <nlohmann/json.hpp>

#include "rectilin/measure/measure.h"

namespace rectilin {
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

Json to_json(const std::array<ParallelFaces, 3>& axes) {
  Json lists = Json::array();
  for (const ParallelFaces& axis : axes) lists.push_back({{"count", axis.count}, {"faces", axis.first}});
  return lists;
}

}  // namespace

Json to_json(const Rectilinearity& result) {
  Json json = {{"faces", result.faces},
               {"directions", result.directions},
               {"area", result.area},
               {"rectilinearity", result.value},
               {"lower", result.bounds ? Json(result.bounds->lower) : Json(nullptr)},
               {"upper", result.bounds ? Json(result.bounds->upper) : Json(nullptr)},
               {"rotation", to_json(result.rotation)}};
  const Json run = to_json(result.run);
  for (const char* key : {"optimizer", "parameters", "domain", "seed", "outcome", "evaluations", "values", "cuts",
                          "smooths", "turns", "seconds", "cpu_seconds", "threads", "digest"})
    json[key] = run.at(key);
  if (result.proof) {
    json["cells"] = result.proof->cells;
    json["parallel_faces"] = to_json(result.parallel_faces);
    if (!result.proof->optima.empty()) json["optima"] = to_json(result.proof->optima);
  }
  return json;
}

}  // namespace rectilin
