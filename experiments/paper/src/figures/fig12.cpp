// Fig. 12: noise and changes of topology.
#include <algorithm>
#include <array>
#include <cmath>

#include "figures/chair.h"
#include "figures/experiments.h"
#include "figures/sample.h"
#include "rectilin/mesh/edits.h"

namespace rectilin::paper::figures {
namespace {

constexpr std::array kNoise = {0.0003, 0.001, 0.003, 0.01};  // standard deviations, in largest extents
constexpr std::size_t kSmall = 1;                            // the noise that is spoken of

/// The mesh with round holes: without the faces near some of its faces, chosen at random.
Mesh with_holes(const Mesh& mesh, int holes, double radius, Random random) {
  const auto middle = [&](const Triangle& t) {
    return Vector3((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3);
  };
  std::vector<Vector3> centres;
  for (int i = 0; i < holes; ++i) centres.push_back(middle(mesh.triangles[random.below(mesh.triangles.size())]));
  const double reach = radius * largest_extent(mesh);
  Mesh rest = mesh;
  std::erase_if(rest.triangles, [&](const Triangle& t) {
    return std::ranges::any_of(centres, [&](const Vector3& c) { return (middle(t) - c).norm() < reach; });
  });
  return rest;
}

/// A mesh and what becomes of it; the numbers are indices into the list of samples.
struct Family {
  std::string title;
  std::size_t original;
  std::vector<std::size_t> topology, noise;
};

struct Disturbances {
  int holes = 8, finest = 50'000;
  double radius = 0.04;
  UpAxis pose;

  void bind(Parameters& parameters) {
    parameters.integer("holes", holes, 1, 1000, "number of holes")
        .real("radius", radius, 0, 1, "of a hole, in largest extents")
        .integer("finest", finest, 1000, 10'000'000, "triangles of the finest of three built-in chairs, about");
    pose.bind(parameters);
  }

  ExperimentResult run(const ExperimentContext& context) const {
    ExperimentResult result;
    std::vector<Sample> samples;
    std::vector<Family> families;
    if (context.meshes.empty()) {
      for (const int faces : {finest / 100, finest / 10, finest}) {
        const auto mesh = std::make_shared<const Mesh>(chair({.faces = faces}));
        const std::string title = std::to_string(mesh->triangles.size()) + " faces";
        families.push_back(family({title, "shape: a chair of " + title, mesh}, context.seed, samples));
        families.back().topology.push_back(samples.size());
        samples.push_back({title + ", slats", "the chair of " + title + " with slats and stretchers",
                           [faces] { return chair({.slats = 6, .stretchers = true, .faces = faces}); }, Up::kZ});
      }
    } else {
      for (const Model& model : load_models(context, {}, result.errors))
        families.push_back(family(model, context.seed, samples));
    }
    const std::vector<Measured> results = measure_all(samples, context);
    result.says = claim(families, results);
    result.data = to_json(samples, results);
    result.plots = {curves(families, results)};
    result.sheets = {sheet("fig12-meshes", "Noise is given in percent of the largest extent.", samples, results,
                           static_cast<int>(samples.size() / families.size()))};
    for (std::string& error : errors(results)) result.errors.push_back(std::move(error));
    return result;
  }

 private:
  /// Adds the mesh itself, with holes and with noise.
  Family family(const Model& model, std::uint64_t seed, std::vector<Sample>& samples) const {
    const auto add = [&](const std::string& change, std::function<Mesh()> make) {
      samples.push_back({model.title + change, model.source + change, std::move(make), pose.of(model.source)});
      return samples.size() - 1;
    };
    Family family{model.title, add("", [mesh = model.mesh] { return *mesh; }), {}, {}};
    for (const double amount : kNoise)
      family.noise.push_back(add(", noise " + number(100 * amount) + " %", [mesh = model.mesh, amount, seed] {
        return with_noise(*mesh, amount, Random(seed));
      }));
    family.topology.push_back(add(", holes", [count = holes, reach = radius, mesh = model.mesh, seed] {
      return with_holes(*mesh, count, reach, Random(seed));
    }));
    return family;
  }

  static std::string claim(const std::vector<Family>& families, const std::vector<Measured>& results) {
    double topology = 0;
    std::string noise;
    for (const Family& family : families) {
      const auto change = [&](std::size_t i) {
        return std::abs(results[i].result.value - results[family.original].result.value);
      };
      for (const std::size_t i : family.topology) topology = std::max(topology, change(i));
      noise.append(noise.empty() ? "" : ", ").append(four_digits(change(family.noise[kSmall])));
      noise.append(" (").append(family.title).append(")");
    }
    return "R changes by at most " + four_digits(topology) + " with other topology; noise of " +
           number(100 * kNoise[kSmall]) + " % of the extent changes it by " + noise + " (paper: robust to both)";
  }

  static report::NamedPlot curves(const std::vector<Family>& families, const std::vector<Measured>& results) {
    std::vector<std::string> columns = {"noise"};
    for (const Family& family : families) columns.push_back(family.title);
    report::Csv csv(columns);
    for (std::size_t i = 0; i <= kNoise.size(); ++i) {
      std::vector<report::Csv::Cell> row = {i == 0 ? 0 : 100 * kNoise[i - 1]};
      for (const Family& family : families) {
        const Measured& r = results[i == 0 ? family.original : family.noise[i - 1]];
        row.emplace_back(r.error.empty() ? r.result.value : NAN);
      }
      csv.row(row);
    }
    report::Panel panel{
        .title = "", .x = {.label = "noise, % of the extent"}, .y = {.label = "R"}, .bands = {}, .curves = {}};
    for (int m = 0; m < static_cast<int>(families.size()); ++m)
      panel.curves.push_back({.y = 2 + m, .label = families[m].title, .style = {.colour = m}, .points = true});
    return {"fig12",
            "What noise does depends on the faces: it turns them by about its size over the length "
            "of their edges.",
            report::Plot("R with noise", csv, {panel})};
  }
};

}  // namespace

Experiment fig12() {
  return make_experiment<Disturbances>("fig12", "Noise and changes of topology",
                                       "meshes (default: a chair it makes itself)", "finest=1000");
}

}  // namespace rectilin::paper::figures
