// Which method finds the axes of models whose axes are known?
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <numbers>
#include <set>

#include "figures/experiments.h"
#include "figures/pose_scores.h"
#include "figures/sample.h"
#include "rectilin/base/batch.h"
#include "rectilin/laboratory/results.h"
#include "rectilin/mesh/source.h"
#include "rectilin/pose/pose.h"
#include "rectilin/pose/roundness.h"

namespace rectilin::paper::figures {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr std::array kWithin = {2.0, 5.0, 10.0};
constexpr double kRight = 10;    // degrees
constexpr double kRound = 0.15;  // of unroundness()
constexpr int kCurve = 45;       // degrees, of the picture

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::string part;
  for (const char c : text + ",") {
    if (c != ',') part += c;
    else if (!part.empty()) parts.push_back(std::exchange(part, {}));
  }
  return parts;
}

/// Degrees between an axis and the nearest axis of a frame, as lines.
double nearest_axis(const Rotation& frame, const Vector3& axis) {
  double best = 90;
  for (int k = 0; k < 3; ++k)
    best = std::min(best, kDegrees * std::atan2(frame.axis(k).cross(axis).norm(), std::abs(frame.axis(k).dot(axis))));
  return best;
}

struct Accuracy {
  std::string methods = "pca,vertex-pca,normal-pca,rectilinear,hull,box,symmetry,cpn,composite";
  std::string classes, apart;
  int turns = 1;

  void bind(Parameters& parameters) {
    const auto text = [&](const std::string& name, std::string& target, const std::string& accepts,
                          const std::string& help) {
      parameters.custom(
          name, accepts,
          [&target](const Json& value) {
            if (value.is_string()) target = value.get<std::string>();
            return value.is_string();
          },
          [&target] { return Json(target); }, help);
    };
    text("methods", methods, "names separated by commas", "methods of 'rectilin pose' to be compared");
    text("classes", classes, "a file", "classes of the models, as a .cla file of the Princeton Shape Benchmark");
    text("apart", apart, "names separated by commas", "classes whose given axes are wrong: results without them, too");
    parameters.integer("turns", turns, 1, 1000, "random rotations of each model");
  }

  struct Outcome {
    std::string error;
    std::vector<std::vector<ScoredPose>> poses;  ///< [method][turn]
    std::vector<std::vector<std::string>> chosen;
    int round_axis = -1;
  };

  Outcome measure(const std::string& source, std::size_t index, const std::string& group,
                  const std::vector<pose::PoseMethod>& compared, std::uint64_t seed) const {
    Outcome outcome;
    const Mesh given = load_mesh(source).mesh;
    double roundest = kRound;
    for (int k = 0; k < 3; ++k)
      if (const double found = pose::unroundness(given, Vector3::Unit(k)); found < roundest)
        roundest = found, outcome.round_axis = k;
    outcome.poses.resize(compared.size());
    outcome.chosen.resize(compared.size());
    Random random = Random(seed).fork(index);
    for (int turn = 0; turn < turns; ++turn) {
      const Rotation turned = random_rotation(random);
      Mesh mesh = given;
      for (Vector3& v : mesh.vertices) v = turned.matrix() * v;
      for (std::size_t m = 0; m < compared.size(); ++m) {
        const pose::Pose found = compared[m](mesh);
        ScoredPose scored;
        scored.model = index;
        scored.group = group;
        scored.frame = found.rotation * turned;
        scored.angle = kDegrees * frame_angle(scored.frame, Rotation());
        scored.revolved_angle = scored.angle;
        if (outcome.round_axis >= 0)
          scored.revolved_angle = std::min(scored.angle, nearest_axis(scored.frame, Vector3::Unit(outcome.round_axis)));
        scored.confidence = found.confidence;
        outcome.poses[m].push_back(scored);
        outcome.chosen[m].push_back(found.chosen);
      }
    }
    return outcome;
  }

  ExperimentResult run(const ExperimentContext& context) const {
    const std::vector<std::string> names = split(methods);
    std::vector<pose::PoseMethod> finders;
    for (const std::string& name : names) finders.push_back(pose::pose_methods().make(name));
    if (finders.empty()) throw ParameterError("pose-accuracy: no methods");
    std::map<std::string, std::string> groups;
    if (!classes.empty()) groups = classes_by_model(retrieval::read_classification(classes));
    std::vector<std::string> sources = context.meshes;
    if (sources.empty())
      sources = {"shape:box?x=1&y=2&z=3", "shape:pyramid", "shape:cylinder?sides=32", "shape:cut-cube"};

    ExperimentResult result;
    std::vector<std::vector<ScoredPose>> poses(names.size());
    std::size_t models = 0, round = 0;
    const std::vector<std::string> labels = laboratory::titles(sources);
    const auto deliver = [&](std::size_t i, rectilin::Outcome<Outcome>&& item) {
      if (!item.value) {
        result.errors.push_back(item.error);
        return;
      }
      ++models;
      round += item.value->round_axis >= 0;
      Json row = {{"model", labels[i]}, {"origin", sources[i]}};
      row["class"] = class_of(sources[i], groups).value_or("");
      row["axis_of_revolution"] =
          item.value->round_axis < 0 ? Json(nullptr) : Json("xyz"[item.value->round_axis] + std::string());
      for (std::size_t m = 0; m < names.size(); ++m) {
        Json of_method = Json::array();
        for (std::size_t t = 0; t < item.value->poses[m].size(); ++t) {
          const ScoredPose& pose = item.value->poses[m][t];
          of_method.push_back({{"angle", pose.angle},
                               {"revolved", pose.revolved_angle},
                               {"confidence", pose.confidence},
                               {"chosen", item.value->chosen[m][t]}});
          poses[m].push_back(pose);
        }
        row["poses"][names[m]] = of_method;
      }
      result.data.push_back(std::move(row));
    };
    const std::size_t done = for_each_in_order<Outcome>(
        sources,
        [&](std::size_t i) {
          return measure(sources[i], i, class_of(sources[i], groups).value_or("all"), finders, context.seed);
        },
        deliver, context.loop());
    if (done < sources.size()) throw Stopped();
    if (models == 0) throw MeshError(result.errors.empty() ? "no models" : result.errors.front());
    Json rows = summary(names, poses);
    for (Json& row : result.data) rows.push_back(std::move(row));
    result.data = std::move(rows);
    result.says = says(names, poses, models, round);
    result.plots = {curves(names, poses)};
    if (!classes.empty()) result.plots.push_back(by_class(names, poses));
    return result;
  }

 private:
  static Json to_json(const Share& share) {
    return {{"share", share.value()}, {"lower", share.lower()}, {"upper", share.upper()}, {"of", share.of}};
  }

  /// A row a method: what came out, with 95 % intervals; once more without the classes that are to be kept apart.
  Json summary(const std::vector<std::string>& names, const std::vector<std::vector<ScoredPose>>& poses) const {
    const std::vector<std::string> separate = split(apart);
    Json rows = Json::array();
    for (std::size_t m = 0; m < names.size(); ++m) {
      std::vector<ScoredPose> rest;
      std::ranges::copy_if(poses[m], std::back_inserter(rest), [&](const ScoredPose& pose) {
        return std::ranges::find(separate, pose.group) == separate.end();
      });
      Json row = {{"method", names[m]}};
      using Part = std::pair<const char*, const std::vector<ScoredPose>*>;
      for (const auto& [key, of] : {Part{"all", &poses[m]}, Part{"without_apart", &rest}}) {
        if (of == &rest && separate.empty()) continue;
        Json part;
        for (const double degrees : kWithin) {
          const std::string within = "within_" + number(degrees);
          part[within] = to_json(share_within(*of, degrees, Rule::kPlain));
          part[within + "_revolved"] = to_json(share_within(*of, degrees, Rule::kRevolved));
        }
        part["surer_half_revolved"] = to_json(surer_half(*of, kRight, Rule::kRevolved));
        if (!classes.empty()) part["consistent_pairs"] = to_json(consistency(*of, kRight));
        row[key] = std::move(part);
      }
      rows.push_back(std::move(row));
    }
    return rows;
  }

  static std::string says(const std::vector<std::string>& names, const std::vector<std::vector<ScoredPose>>& poses,
                          std::size_t models, std::size_t round) {
    std::string text = std::to_string(models) + " models, " + std::to_string(round) +
                       " of revolution; within 10 degrees (revolution-aware):";
    for (std::size_t m = 0; m < names.size(); ++m) {
      char part[96];
      std::snprintf(part, sizeof part, "%s %s %.3f (%.3f)", m == 0 ? "" : ",", names[m].c_str(),
                    share_within(poses[m], kRight, Rule::kPlain).value(),
                    share_within(poses[m], kRight, Rule::kRevolved).value());
      text += part;
    }
    return text + "; the paper's 39 judges accepted 98.2 % of the Princeton models in the pose of cpn";
  }

  /// A row a degree: the share within it, by each method.
  static report::NamedPlot curves(const std::vector<std::string>& names,
                                  const std::vector<std::vector<ScoredPose>>& poses) {
    std::vector<std::string> columns = {"degrees"};
    for (const std::string& name : names) columns.push_back(name);
    report::Csv csv(columns);
    for (int degrees = 0; degrees <= kCurve; ++degrees) {
      std::vector<report::Csv::Cell> row = {degrees};
      for (const auto& of_method : poses) row.emplace_back(share_within(of_method, degrees, Rule::kRevolved).value());
      csv.row(row);
    }
    report::Panel panel{.title = "",
                        .x = {.label = "degrees", .lower = 0, .upper = kCurve},
                        .y = {.label = "share of poses within", .lower = 0, .upper = 1},
                        .bands = {},
                        .curves = {}};
    for (int m = 0; m < std::ssize(names); ++m)
      panel.curves.push_back({.y = m + 2,
                              .label = names[static_cast<std::size_t>(m)],
                              .style = {.colour = m, .dash = m / report::LineStyle::kColours}});
    return {"pose-accuracy", "Angle to the nearest of the 24 right frames; of bodies of revolution, to their axis.",
            report::Plot("How often is the pose right?", csv, {panel})};
  }

  static report::NamedPlot by_class(const std::vector<std::string>& names,
                                    const std::vector<std::vector<ScoredPose>>& poses) {
    std::set<std::string> groups;
    for (const ScoredPose& pose : poses.front()) groups.insert(pose.group);
    report::HeatMap map{
        .title = "Share within 10 degrees by class", .scale = "share", .rows = {}, .columns = names, .values = {}};
    std::vector<std::string> columns = {"class"};
    columns.insert(columns.end(), names.begin(), names.end());
    report::Csv csv(columns);
    for (const std::string& group : groups) {
      std::vector<report::Csv::Cell> row = {group};
      std::vector<double> values;
      for (const auto& of_method : poses) {
        std::vector<ScoredPose> own;
        std::ranges::copy_if(of_method, std::back_inserter(own), [&](const ScoredPose& p) { return p.group == group; });
        values.push_back(share_within(own, kRight, Rule::kRevolved).value());
        row.emplace_back(values.back());
      }
      csv.row(row);
      map.rows.push_back(group);
      map.values.push_back(values);
    }
    return {"pose-accuracy-classes", "Revolution-aware. Where no method is right the given axes may be wrong.",
            report::Plot(csv, map)};
  }
};

}  // namespace

Experiment pose_accuracy() {
  return make_experiment<Accuracy>("pose-accuracy", "Which method finds the axes of models whose axes are right?",
                                   "models whose axes are right", "methods=pca,rectilinear,cpn,composite");
}

}  // namespace rectilin::paper::figures
