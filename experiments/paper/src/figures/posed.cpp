#include "figures/posed.h"

#include <algorithm>
#include <cstdio>

#include "rectilin/base/batch.h"
#include "rectilin/laboratory/results.h"
#include "rectilin/mesh/source.h"
#include "rectilin/pose/axes.h"
#include "rectilin/pose/summed_silhouette.h"
#include "rectilin/pose/views.h"

namespace rectilin::paper::figures {
namespace {

constexpr double kTolerance = 1e-5;  // of silhouettes

PosedModel pose_one(const std::string& title, const std::string& source, const std::vector<std::string>& methods,
                    bool silhouettes, Up up) {
  PosedModel model{title, source, "", {}};
  const Mesh mesh = load_mesh(source).mesh;
  const pose::SummedSilhouette objective(mesh, kTolerance);
  for (const std::string& method : methods) {
    PosedModel::ByMethod of{method, pose::pose_methods().make(method)(mesh), 0, "", {}};
    of.pose.rotation = pose::resolve_axes(mesh, of.pose.rotation, pose::AxisRule::kFree).rotation;
    objective.values({&of.pose.rotation, 1}, {&of.silhouettes, 1});
    of.picture = thumbnail(pose::normalized(mesh, of.pose), up);
    if (silhouettes) {
      const auto views = pose::three_silhouettes(mesh, of.pose.rotation);
      of.views.assign(views.begin(), views.end());
    }
    model.poses.push_back(std::move(of));
  }
  return model;
}

void check(const std::vector<PosedModel>& models) {
  if (std::ranges::all_of(models, [](const PosedModel& m) { return !m.error.empty(); }))
    throw MeshError(models.empty() ? "no meshes" : models.front().error);
}

report::Csv table(const std::vector<PosedModel>& models) {
  report::Csv csv({"model", "origin", "method", "chosen", "silhouettes", "projected", "confidence"});
  for (const PosedModel& model : models)
    for (const auto& of : model.poses)
      csv.row({model.title, model.source, of.method, of.pose.chosen, of.silhouettes,
               of.pose.candidates.front().projected, of.pose.confidence});
  return csv;
}

}  // namespace

Defaults sources_of(const ExperimentContext& context, const Defaults& defaults) {
  if (context.meshes.empty()) return defaults;
  Defaults wanted;
  const std::vector<std::string> names = laboratory::titles(context.meshes);
  for (std::size_t i = 0; i < names.size(); ++i) wanted.emplace_back(names[i], context.meshes[i]);
  return wanted;
}

std::vector<PosedModel> pose_all(const Defaults& sources, const std::vector<std::string>& methods, bool silhouettes,
                                 Up up, const ExperimentContext& context) {
  std::vector<std::string> names;
  for (const auto& [title, source] : sources) names.push_back(source);
  std::vector<PosedModel> models;
  const std::size_t done = for_each_in_order<PosedModel>(
      names, [&](std::size_t i) { return pose_one(sources[i].first, names[i], methods, silhouettes, up); },
      [&](std::size_t i, Outcome<PosedModel>&& outcome) {
        models.push_back(outcome.value ? std::move(*outcome.value)
                                       : PosedModel{sources[i].first, names[i], outcome.error, {}});
      },
      context.loop());
  if (done < names.size()) throw Stopped();
  check(models);
  return models;
}

Sheet sheet_by_method(std::string name, std::string caption, const std::vector<PosedModel>& models) {
  std::vector<SheetCell> cells;
  std::size_t methods = 0;
  int columns = 0;
  for (const PosedModel& model : models) {
    methods = std::max(methods, model.poses.size());
    columns += model.error.empty();
  }
  for (std::size_t m = 0; m < methods; ++m)
    for (const PosedModel& model : models)
      if (model.error.empty())
        cells.push_back({model.poses[m].picture, model.title + ", " + model.poses[m].method,
                         "silhouettes " + four_digits(model.poses[m].silhouettes)});
  ContactSheet drawn = contact_sheet(cells, std::max(columns, 1));
  return {std::move(name), std::move(caption), table(models), std::move(drawn.svg), drawn.width};
}

Sheet sheet_of_silhouettes(std::string name, std::string caption, const std::vector<PosedModel>& models) {
  std::vector<SheetCell> cells;
  for (const PosedModel& model : models)
    for (const auto& of : model.poses) {
      cells.push_back({of.picture, model.title + ", " + of.method, "silhouettes " + four_digits(of.silhouettes)});
      for (std::size_t k = 0; k < of.views.size(); ++k)
        cells.push_back({of.views[k], std::string("along ") + "xyz"[k], ""});
    }
  ContactSheet drawn = contact_sheet(cells, 4);
  return {std::move(name), std::move(caption), table(models), std::move(drawn.svg), drawn.width};
}

Json to_json(const std::vector<PosedModel>& models) {
  Json rows = Json::array();
  for (const PosedModel& model : models) {
    Json row = {{"label", model.title}, {"origin", model.source}};
    if (!model.error.empty()) row["error"] = model.error;
    for (const auto& of : model.poses)
      row["poses"][of.method] = {{"chosen", of.pose.chosen},
                                 {"reason", of.pose.reason},
                                 {"silhouettes", of.silhouettes},
                                 {"projected", of.pose.candidates.front().projected},
                                 {"uniqueness", pose::to_string(of.pose.uniqueness)},
                                 {"confidence", of.pose.confidence}};
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::string> errors(const std::vector<PosedModel>& models) {
  std::vector<std::string> lines;
  for (const PosedModel& model : models)
    if (!model.error.empty()) lines.push_back(model.error);
  return lines;
}

}  // namespace rectilin::paper::figures
