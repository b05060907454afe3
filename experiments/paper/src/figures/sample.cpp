#include "figures/sample.h"

#include <cmath>
#include <cstdio>

#include "rectilin/laboratory/results.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/run_record.h"

namespace rectilin::paper::figures {
namespace {

Measured measured(const Sample& sample, const ExperimentContext& context) {
  Measured result;
  const Mesh mesh = sample.make();
  if (sample.pictured) result.picture = thumbnail(mesh, *sample.pictured);
  result.result = measure(mesh, {.certify = {.gap = context.gap}, .run = {.stop = context.stop}});
  if (result.result.run.outcome == RunRecord::Outcome::kStopped) throw Stopped();
  return result;
}

}  // namespace

Sample sample(std::string label, const std::string& source) {
  return {std::move(label), source, [source] { return load_mesh(source).mesh; }};
}

void UpAxis::bind(Parameters& parameters) {
  parameters.choice("up", which, {{"auto", Which::kAuto}, {"y", Which::kY}, {"z", Which::kZ}},
                    "the axis that points up in pictures; auto: z for built-in shapes, y for files");
}

Up UpAxis::of(const std::string& source) const {
  if (which == Which::kAuto) return source.starts_with("shape:") ? Up::kZ : Up::kY;
  return which == Which::kZ ? Up::kZ : Up::kY;
}

Defaults made_and_scanned(int faces) {
  return {{"torus", "shape:torus?slices=80&stacks=40"},
          {"rough blob", "shape:blob?noise=0.0003&faces=" + std::to_string(faces)}};
}

std::vector<Model> load_models(const ExperimentContext& context, const Defaults& defaults,
                               std::vector<std::string>& errors) {
  Defaults wanted = defaults;
  if (!context.meshes.empty()) {
    wanted.clear();
    const std::vector<std::string> names = laboratory::titles(context.meshes);
    for (std::size_t i = 0; i < names.size(); ++i) wanted.emplace_back(names[i], context.meshes[i]);
  }
  std::vector<Model> models;
  for (const auto& [title, source] : wanted) {
    try {
      models.push_back({title, source, std::make_shared<const Mesh>(load_mesh(source).mesh)});
    } catch (const MeshError& e) {
      errors.push_back(e.what());
    }
  }
  if (models.empty()) throw MeshError(errors.front());
  return models;
}

std::vector<Measured> measure_all(const std::vector<Sample>& samples, const ExperimentContext& context) {
  std::vector<std::string> names;
  for (const Sample& sample : samples) names.push_back(sample.origin);
  std::vector<Measured> results(samples.size());
  const std::size_t done = for_each_in_order<Measured>(
      names, [&](std::size_t i) { return measured(samples[i], context); },
      [&](std::size_t i, Outcome<Measured>&& outcome) {
        if (outcome.value) results[i] = std::move(*outcome.value);
        else results[i].error = outcome.error;
      },
      context.loop());
  if (done < samples.size()) throw Stopped();
  return results;
}

Json to_json(const std::vector<Sample>& samples, const std::vector<Measured>& results) {
  Json list = Json::array();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Measured& r = results[i];
    Json row = {{"label", samples[i].label}, {"origin", samples[i].origin}};
    if (!r.error.empty()) row["error"] = r.error;
    else
      row.update({{"faces", r.result.faces},
                  {"directions", r.result.directions},
                  {"rectilinearity", r.result.value},
                  {"lower", r.lower()},
                  {"upper", r.upper()}});
    list.push_back(std::move(row));
  }
  return list;
}

Sheet sheet(std::string name, std::string caption, const std::vector<Sample>& samples,
            const std::vector<Measured>& results, int columns) {
  report::Csv csv({"label", "origin", "error", "faces", "directions", "R", "lower", "upper"});
  std::vector<SheetCell> cells;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Measured& r = results[i];
    const bool known = r.error.empty();
    csv.row({samples[i].label, samples[i].origin, r.error, r.result.faces, r.result.directions,
             known ? r.result.value : NAN, known ? r.lower() : NAN, known ? r.upper() : NAN});
    if (samples[i].pictured && known) cells.push_back({r.picture, samples[i].label, four_digits(r.result.value)});
  }
  ContactSheet drawn = contact_sheet(cells, columns);
  return {std::move(name), std::move(caption), std::move(csv), std::move(drawn.svg), drawn.width};
}

std::vector<std::string> errors(const std::vector<Measured>& results) {
  std::vector<std::string> lines;
  for (const Measured& result : results)
    if (!result.error.empty()) lines.push_back(result.error);
  return lines;
}

std::string four_digits(double rectilinearity) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", rectilinearity);
  return text;
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

}  // namespace rectilin::paper::figures
