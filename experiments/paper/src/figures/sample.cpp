#include "figures/sample.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <cstdio>
#include <mutex>

#include "rectilin/laboratory/results.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/run_record.h"

namespace rectilin::figures {
namespace {

Measured measure(const Sample& sample, const ExperimentContext& context) {
  Measured result;
  try {
    const Mesh mesh = sample.make();
    if (sample.pictured) result.picture = thumbnail(mesh, *sample.pictured);
    const ProjectedArea objective(area_vectors(mesh));
    RunSettings settings;
    settings.stop = context.stop;
    const RunRecord run = run_optimizer(Certify({.gap = context.gap}), objective, settings);
    if (run.outcome == RunRecord::Outcome::kStopped) throw Stopped();
    if (!run.error.empty()) throw MeshError(run.error);
    result.faces = objective.vectors().faces;
    result.directions = objective.vectors().size();
    result.rectilinearity = run.merit;
    result.lower = rectilinearity(run.incumbent.value + 3 * objective.cut_bounds().error);
    result.upper = rectilinearity(run.lower.value());
    result.rotation = run.incumbent.rotation;
  } catch (const MeshError& e) {
    result.error = e.what();
  }
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
    const std::vector<std::string> names = titles(context.meshes);
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
  std::vector<Measured> results(samples.size());
  std::mutex mutex;
  std::size_t done = 0;
  const auto report = [&](std::size_t finished, const std::string& text) {
    const std::lock_guard lock(mutex);
    done += finished;
    if (context.on_progress) context.on_progress(done, samples.size(), text);
  };
  tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
    if (context.stop.stop_requested()) throw Stopped();
    report(0, samples[i].label);
    // A thread that waits for the loops inside one measurement must not begin another: memory would
    // grow.
    tbb::this_task_arena::isolate([&] { results[i] = measure(samples[i], context); });
    report(1, samples[i].label);
  });
  return results;
}

Json to_json(const std::vector<Sample>& samples, const std::vector<Measured>& results) {
  Json list = Json::array();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Measured& r = results[i];
    Json row = {{"label", samples[i].label}, {"origin", samples[i].origin}};
    if (!r.error.empty()) row["error"] = r.error;
    else
      row.update({{"faces", r.faces},
                  {"directions", r.directions},
                  {"rectilinearity", r.rectilinearity},
                  {"lower", r.lower},
                  {"upper", r.upper}});
    list.push_back(std::move(row));
  }
  return list;
}

Sheet sheet(std::string name, std::string caption, const std::vector<Sample>& samples,
            const std::vector<Measured>& results, int columns) {
  Csv csv({"label", "origin", "error", "faces", "directions", "R", "lower", "upper"});
  std::vector<SheetCell> cells;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Measured& r = results[i];
    const bool known = r.error.empty();
    const auto number = [known](double x) { return known ? x : NAN; };
    csv.row({samples[i].label, samples[i].origin, r.error, r.faces, r.directions, number(r.rectilinearity),
             number(r.lower), number(r.upper)});
    if (samples[i].pictured && known) cells.push_back({r.picture, samples[i].label, four_digits(r.rectilinearity)});
  }
  ContactSheet drawn = contact_sheet(cells, columns);
  return {std::move(name), std::move(caption), std::move(csv), std::move(drawn.svg), drawn.width};
}

std::vector<std::string> errors(const std::vector<Sample>& samples, const std::vector<Measured>& results) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::string &error = results[i].error, &origin = samples[i].origin;
    if (error.empty()) continue;
    lines.push_back(error.starts_with(origin) ? error : origin + ": " + error);
  }
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

}  // namespace rectilin::figures
