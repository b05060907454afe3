// Reads runs of other programs into a comparison.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "rectilin/base/journal.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/results.h"
#include "rectilin/laboratory/suite.h"

namespace rectilin::laboratory {
namespace {

namespace fs = std::filesystem;

struct Refused {
  std::string reason;
};

const Json& field(const Json& line, const char* name) {
  if (!line.contains(name)) throw Refused{std::string("'") + name + "' is missing"};
  return line.at(name);
}

std::string text_field(const Json& line, const char* name) {
  const Json& value = field(line, name);
  if (!value.is_string() || value.get<std::string>().empty()) throw Refused{std::string("'") + name + "' is no text"};
  return value.get<std::string>();
}

std::vector<double> numbers(const Json& list, const char* name) {
  if (!list.is_array()) throw Refused{std::string("'") + name + "' is not a list of numbers"};
  std::vector<double> result;
  for (const Json& x : list) {
    if (!x.is_number()) throw Refused{std::string("'") + name + "' is not a list of numbers"};
    result.push_back(x.get<double>());
  }
  return result;
}

/// Refuses a list unless each element is less (sign -1) or greater (sign 1) than the one before.
void require_monotonic(const std::vector<double>& list, int sign, const char* name) {
  for (std::size_t i = 1; i < list.size(); ++i)
    if (!(sign * (list[i] - list[i - 1]) > 0))
      throw Refused{std::string("'") + name + "' does not " + (sign > 0 ? "rise" : "fall") + " at element " +
                    std::to_string(i)};
}

Rotation rotation_field(const Json& line) {
  const Json& rows = field(line, "rotation");
  Eigen::Matrix3d m;
  bool good = rows.is_array() && rows.size() == 3;
  for (int i = 0; good && i < 3; ++i) {
    good = rows[i].is_array() && rows[i].size() == 3;
    for (int j = 0; good && j < 3; ++j) {
      good = rows[i][j].is_number();
      if (good) m(i, j) = rows[i][j].get<double>();
    }
  }
  if (!good || !((m * m.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-8) ||
      !(m.determinant() > 0))
    throw Refused{"'rotation' is not three orthonormal, right-handed rows"};
  return Rotation::from_matrix(m);
}

class ForeignReader {
 public:
  ForeignReader(const Results& results, const std::set<std::string>& own,
                const std::function<ComparedMesh(const std::string& mesh)>& load)
      : results_(results), own_(own), load_(load) {}

  /// Checks a line and returns it as runs.jsonl would have it.
  Json read(const Json& line) {
    if (!line.is_object()) throw Refused{"not a JSON object"};
    const MeshResult& mesh = mesh_named(text_field(line, "problem"));
    const std::string label = text_field(line, "optimizer");
    if (own_.contains(label)) throw Refused{"the comparison has an optimizer '" + label + "' of its own"};
    const Json& run = field(line, "run");
    if (!run.is_number_unsigned() || run.get<std::uint64_t>() > 1'000'000'000)
      throw Refused{"'run' is not a whole number of 0 or more"};

    const std::vector<double> evaluations = numbers(field(line, "evaluations"), "evaluations");
    const std::vector<double> value = numbers(field(line, "value"), "value");
    std::vector<double> seconds(evaluations.size(), 0.0);
    if (line.contains("seconds")) seconds = numbers(line["seconds"], "seconds");
    if (evaluations.empty() || evaluations.size() != value.size() || evaluations.size() != seconds.size())
      throw Refused{"'evaluations', 'value' and 'seconds' are not lists of the same length with at least one element"};
    require_monotonic(evaluations, 1, "evaluations");
    require_monotonic(value, -1, "value");
    if (!(evaluations.front() >= 1) || std::ranges::any_of(evaluations, [](double x) { return x != std::floor(x); }))
      throw Refused{"'evaluations' are not whole numbers of 1 or more"};
    if (!std::ranges::is_sorted(seconds) || !(seconds.front() >= 0))
      throw Refused{"'seconds' must not be negative and must not fall"};
    const double total = line.contains("total_evaluations") && line["total_evaluations"].is_number()
                             ? line["total_evaluations"].get<double>()
                             : evaluations.back();
    if (!(total >= evaluations.back())) throw Refused{"'total_evaluations' is less than the last of 'evaluations'"};

    const Rotation rotation = rotation_field(line);
    const double true_value = objective(mesh.name).value(rotation);
    if (!(std::abs(true_value - value.back()) < 1e-9))
      throw Refused{"the rotation does not have the last value, " + std::to_string(value.back()) + ", but " +
                    std::to_string(true_value)};
    if (!(value.back() > 1 - 1e-9)) throw Refused{"a value is below 1, which no rotation can have"};

    Json merit = Json::array();
    for (const double v : value) merit.push_back(rectilinearity(v));
    return {{"mesh", mesh.name},
            {"entry", label},
            {"run", run},
            {"objective", mesh.name},
            {"optimizer", label},
            {"parameters", Json::object()},
            {"domain", "-"},
            {"seed", 0},
            {"outcome", "finished"},
            {"error", ""},
            {"value", value.back()},
            {"value_bound", nullptr},
            {"merit", rectilinearity(value.back())},
            {"rotation", to_json(rotation)},
            {"evaluations", total},
            {"values", total},
            {"cuts", 0},
            {"smooths", 0},
            {"turns", 0},
            {"seconds", seconds.back()},
            {"cpu_seconds", seconds.back()},
            {"threads", 1},
            {"digest", ""},
            {"instance", to_json(Rotation())},
            {"trace", {{"evaluations", evaluations}, {"seconds", seconds}, {"merit", merit}}}};
  }

 private:
  const MeshResult& mesh_named(const std::string& name) const {
    for (const MeshResult& mesh : results_.meshes)
      if ((mesh.name == name || mesh.title == name) && mesh.error.empty()) return mesh;
    throw Refused{"the comparison has no problem '" + name + "'"};
  }

  const ProjectedArea& objective(const std::string& name) {
    auto& made = objectives_[name];
    if (!made) made = std::make_unique<ProjectedArea>(load_(name).vectors, name);
    return *made;
  }

  const Results& results_;
  const std::set<std::string>& own_;
  const std::function<ComparedMesh(const std::string& mesh)>& load_;
  std::map<std::string, std::unique_ptr<ProjectedArea>> objectives_;
};

}  // namespace

std::size_t add_foreign_runs(const fs::path& folder, std::string_view text, const std::string& name,
                             const std::function<ComparedMesh(const std::string& mesh)>& load) {
  const Results results = load_results(folder);
  std::set<std::string> own;
  for (const Entry& entry : results.plan.entries)
    if (!is_foreign(entry)) own.insert(entry.label);
  ForeignReader reader(results, own, load);

  std::map<std::tuple<std::string, std::string, std::uint64_t>, Json> lines;
  const auto keep = [&](Json line) {
    const std::tuple key(line.at("mesh").get<std::string>(), line.at("entry").get<std::string>(),
                         line.at("run").get<std::uint64_t>());
    lines[key] = std::move(line);
  };
  for (Json& line : recover_journal(folder / kForeignFile)) keep(std::move(line));
  std::size_t count = 0, number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const auto refuse = [&](const std::string& reason) {
      throw ParameterError(name + ":line " + std::to_string(number) + ": " + reason);
    };
    try {
      keep(reader.read(parse_json(line)));
      ++count;
    } catch (const Refused& refused) {
      refuse(refused.reason);
    } catch (const Json::exception&) {
      refuse("not a JSON object");
    }
  }
  if (count == 0) throw ParameterError(name + ": contains no runs");
  std::string content;
  for (const auto& [key, line] : lines) content += to_text(line) + '\n';
  write_whole_file(folder / kForeignFile, content);
  return count;
}

}  // namespace rectilin::laboratory
