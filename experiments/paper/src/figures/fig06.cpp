// Fig. 6: how the paper's genetic algorithm converges, against the certified R. The paper: "usually
// the stable value of rectilinearity measure can be found after approximately 150 evolution
// generations."
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "figures/experiments.h"
#include "figures/sample.h"
#include "rectilin/laboratory/statistics.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/optim/genetic.h"
#include "rectilin/optim/run_record.h"

namespace rectilin::paper::figures {
namespace {

constexpr int kStable = 150;        // generations after which the paper calls the value stable
constexpr double kReached = 0.001;  // that near to the certified R counts as found

/// R of the best individual so far after each generation.
std::vector<double> course(const RunRecord& run, const GeneticOptions& options) {
  std::vector<double> best(options.generations, NAN);
  auto next = run.trace.begin();
  double value = NAN;
  for (int g = 0; g < options.generations; ++g) {
    const auto spent = static_cast<std::uint64_t>(options.population) * static_cast<std::uint64_t>(g + 1);
    for (; next != run.trace.end() && next->evaluations <= spent; ++next) value = next->value;
    best[g] = rectilinearity(value);
  }
  return best;
}

struct Convergence {
  int runs = 20;
  GeneticOptions genetic;
  std::string domain = "paper";

  void bind(Parameters& parameters) {
    parameters.integer("runs", runs, 1, 10'000, "runs on each mesh, each with random numbers of its own")
        .integer("generations", genetic.generations, 1, 100'000, "generations of each run")
        .custom(
            "domain", "paper | covering | zone",
            [this](const Json& value) {
              if (value != "paper" && value != "covering" && value != "zone") return false;
              domain = value.get<std::string>();
              return true;
            },
            [this] { return Json(domain); }, "box of rotations that is searched");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    ExperimentResult result;
    const std::vector<Model> models = load_models(context,
                                                  {{"pyramid", "shape:pyramid?rotate=random"},
                                                   {"cylinder", "shape:cylinder?rotate=random"},
                                                   {"ellipsoid", "shape:ellipsoid?rotate=random"},
                                                   {"blob", "shape:blob?faces=5000"}},
                                                  result.errors);
    std::vector<Sample> samples;
    for (const Model& model : models)
      samples.push_back({model.title, model.source, [mesh = model.mesh] { return *mesh; }});
    const std::vector<Measured> certified = measure_all(samples, context);
    result.data = to_json(samples, certified);
    for (std::string& error : errors(certified)) result.errors.push_back(std::move(error));

    std::vector<Course> courses;
    for (std::size_t m = 0; m < models.size(); ++m) {
      if (!certified[m].error.empty()) continue;
      courses.push_back({models[m].title, certified[m].upper(), run_all(*models[m].mesh, context)});
      result.data[m]["final"] = finals(courses.back());
    }
    if (courses.empty()) throw MeshError(result.errors.front());
    result.says = claim(courses);
    result.plots = {curves(courses)};
    return result;
  }

 private:
  struct Course {
    std::string title;
    double upper;                           ///< certified
    std::vector<std::vector<double>> runs;  ///< [run][generation]

    std::vector<double> at(int generation) const {
      std::vector<double> values;
      for (const auto& run : runs) values.push_back(run[generation - 1]);
      return values;
    }
  };

  std::vector<std::vector<double>> run_all(const Mesh& mesh, const ExperimentContext& context) const {
    const ProjectedArea objective(area_vectors(mesh));
    std::vector<std::vector<double>> all(runs);
    tbb::parallel_for(0, runs, [&](int run) {
      if (context.stop.stop_requested()) throw Stopped();
      RunSettings settings;
      settings.domain = &domain_by_name(domain);
      settings.seed = Random(context.seed).fork(static_cast<std::uint64_t>(run)).seed();
      all[run] =
          figures::course(run_optimizer(*make_optimizer(genetic_algorithm(), genetic), objective, settings), genetic);
    });
    return all;
  }

  Json finals(const Course& course) const { return course.at(genetic.generations); }

  std::string claim(const std::vector<Course>& courses) const {
    const int stable = std::min(kStable, genetic.generations);
    std::size_t all = 0, settled = 0, reached = 0;
    for (const Course& course : courses)
      for (const auto& run : course.runs) {
        ++all;
        settled += run.back() - run[stable - 1] < kReached;
        reached += course.upper - run.back() < kReached;
      }
    const auto percent = [all](std::size_t count) {
      return std::to_string(std::lround(100 * static_cast<double>(count) / static_cast<double>(all))) + " %";
    };
    return percent(settled) + " of the runs gain less than " + number(kReached) + " after generation " +
           std::to_string(stable) + " (paper: stable after about 150); " + percent(reached) + " end within " +
           number(kReached) + " of the certified R";
  }

  /// With few tics, for panels are small.
  static report::Axis vertical(const Course& course) {
    double low = course.upper;
    for (const auto& run : course.runs) low = std::min(low, run.front());
    const double span = std::max(1e-6, course.upper - low), decade = std::pow(10, std::floor(std::log10(span / 2)));
    const double step = span / decade > 10 ? 5 * decade : span / decade > 4 ? 2 * decade : decade;
    return {.label = "R",
            .lower = step * std::floor(low / step),
            .upper = step * std::ceil(course.upper / step),
            .step = step};
  }

  report::NamedPlot curves(const std::vector<Course>& courses) const {
    std::vector<std::string> columns = {"generation"};
    for (const Course& course : courses)
      for (const char* what : {"median", "q10", "q90", "certified"}) columns.push_back(course.title + " " + what);
    report::Csv csv(columns);
    for (int g = 1; g <= genetic.generations; ++g) {
      std::vector<report::Csv::Cell> row = {g};
      for (const Course& course : courses) {
        const std::vector<double> values = course.at(g);
        for (const double x : {laboratory::median(values), laboratory::quantile(values, 0.1),
                               laboratory::quantile(values, 0.9), course.upper})
          row.emplace_back(x);
      }
      csv.row(row);
    }
    std::vector<report::Panel> panels;
    for (int m = 0; m < static_cast<int>(courses.size()); ++m) {
      const int first = 2 + 4 * m;
      report::Panel& panel = panels.emplace_back();
      panel.title = courses[m].title;
      panel.x = {
          .label = "generation", .upper = static_cast<double>(genetic.generations), .step = genetic.generations / 4.0};
      panel.y = vertical(courses[m]);
      panel.bands = {{.low = first + 1, .high = first + 2, .style = {}}};
      panel.curves = {{.y = first + 3, .label = "", .style = {.colour = 1, .dash = 1}},
                      {.y = first, .label = "", .style = {}}};
    }
    return {"fig6",
            "R of the best individual so far: median and 10 % to 90 % quantiles of " + std::to_string(runs) +
                " runs; dashed: the certified R.",
            report::Plot("Convergence of the genetic algorithm", csv, panels, courses.size() == 1 ? 1 : 2)};
  }
};

}  // namespace

Experiment fig6() {
  return make_experiment<Convergence>("fig6", "Convergence of the genetic algorithm",
                                      "meshes (default: four built-in shapes)", "runs=4&generations=20");
}

}  // namespace rectilin::paper::figures
