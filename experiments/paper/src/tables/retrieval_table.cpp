#include "tables/retrieval_table.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <set>

#include "rectilin/base/random.h"
#include "rectilin/mesh/source.h"
#include "rectilin/retrieval/features.h"

namespace rectilin::paper::tables {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A collection of built-in shapes: the models of a class have different proportions and poses.
retrieval::Collection built_in(int models, std::uint64_t seed) {
  const char* const kKinds[] = {"box", "pyramid", "stairs", "lshape", "torus", "ellipsoid", "cylinder"};
  retrieval::Collection collection;
  Random random(seed);
  for (const std::string kind : kKinds) {
    const std::size_t c = collection.classes.classes.size();
    collection.classes.classes.push_back({kind, {}, {}});
    for (int i = 0; i < models; ++i) {
      const std::string turn = "rotate=random&seed=" + std::to_string(random.below(1'000'000));
      std::string own;
      if (kind == "torus") own = "minor=" + to_text(random.uniform(0.3, 0.5));
      else if (kind == "ellipsoid")
        own = "a=" + to_text(random.uniform(1.5, 2.5)) + "&b=1&c=" + to_text(random.uniform(0.6, 1));
      else if (kind == "cylinder") own = "sides=" + std::to_string(20 + random.below(40));
      else own = "x=" + to_text(random.uniform(1.2, 2)) + "&y=" + to_text(random.uniform(0.8, 1.2));
      std::string spec = "shape:" + kind + "?" + own + "&" + turn;
      try {
        load_mesh(spec);
      } catch (const ParameterError&) {  // this shape has no proportions
        spec = "shape:" + kind + "?" + turn;
      }
      collection.classes.classes[c].models.push_back(collection.classes.models.size());
      collection.classes.class_of.push_back(c);
      collection.classes.models.push_back(kind + std::to_string(i));
      collection.files.push_back(spec);
    }
  }
  return collection;
}

/// A folder for signatures. If it is a temporary one it is removed at the end.
class Cache {
 public:
  explicit Cache(const std::string& given) : path_(given), ours_(given.empty()) {
    if (ours_) path_ = fs::temp_directory_path() / ("rectilin-tables-" + std::to_string(getpid()));
  }
  ~Cache() {
    std::error_code ignored;
    if (ours_) fs::remove_all(path_, ignored);
  }
  Cache(const Cache&) = delete;
  Cache& operator=(const Cache&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  bool ours_;
};

std::string with_size(std::string text, int size) {
  for (std::size_t at; (at = text.find("$size")) != std::string::npos;) text.replace(at, 5, std::to_string(size));
  return text;
}

std::string percent(double x) {
  if (std::isnan(x)) return "-";
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", x);
  return text;
}

PaperScores ours(const retrieval::Measures& m) {
  return {100 * m.nearest, 100 * m.first_tier, 100 * m.second_tier, 100 * m.dcg};
}

void add_intervals(ScoredRow& row, const retrieval::Classification& classes, std::uint64_t seed) {
  std::array<std::vector<double>, 4> values;
  std::vector<std::size_t> group;
  for (std::size_t q = 0; q < classes.models.size(); ++q) {
    if (!row.scores.queries[q].counts) continue;
    const PaperScores own = ours(row.scores.queries[q].measures);
    for (std::size_t k = 0; k < own.size(); ++k) values[k].push_back(own[k]);
    group.push_back(classes.class_of[q]);
  }
  for (std::size_t k = 0; k < values.size() && !group.empty(); ++k)
    row.intervals[k] = retrieval::mean_interval(values[k], group, seed);
}

/// "71.8 (67.0 to 76.1)".
std::string with_interval(double x, const retrieval::Interval& interval) {
  return percent(x) + " (" + percent(interval.low) + " to " + percent(interval.high) + ")";
}

}  // namespace

void TableSettings::bind(Parameters& parameters) {
  const auto text = [&](const char* name, std::string& target, const char* help) {
    parameters.custom(
        name, "a path",
        [&target](const Json& value) {
          if (!value.is_string()) return false;
          target = value.get<std::string>();
          return true;
        },
        [&target] { return Json(target); }, help);
  };
  text("folder", folder, "folder of meshes, needs `classes`; without both a small collection of built-in shapes");
  text("classes", classes, "classification of the folder's models, a .cla file");
  text("cache", cache, "folder in which signatures are kept from run to run");
  parameters.integer("models", models, 3, 1000, "models of each class of the built-in collection")
      .integer("size", size, 16, 1024, "width and height of a picture in pixels");
}

ScoredTable score(const std::vector<Row>& rows, const TableSettings& settings, const ExperimentContext& context) {
  if (settings.folder.empty() != settings.classes.empty())
    throw ParameterError("folder and classes are needed together, or neither");
  const bool given = !settings.folder.empty();
  retrieval::Collection collection =
      given ? retrieval::find_collection(settings.folder, retrieval::read_classification(settings.classes))
            : built_in(settings.models, context.seed);
  ScoredTable table;
  std::set<std::string> specs;
  for (const Row& row : rows) {
    if (row.descriptor.empty()) continue;
    for (const auto& term : retrieval::parse_composite(with_size(row.descriptor, settings.size)))
      specs.insert(term.spec);
  }
  const Cache cache(settings.cache);
  retrieval::Features features = retrieval::compute_features(collection, {specs.begin(), specs.end()}, cache.path(),
                                                             {context.stop, context.on_progress});
  if (!features.complete) throw Stopped();
  table.errors = features.errors;
  for (const std::string& loss : features.losses) context.losses->add_line(loss);
  std::vector<bool> kept(collection.files.size(), true);
  for (const std::string& model : features.failed)
    kept[static_cast<std::size_t>(std::ranges::find(collection.classes.models, model) -
                                  collection.classes.models.begin())] = false;
  const retrieval::Classification classes = collection.classes.subset(kept);
  table.class_of = classes.class_of;
  table.collection = given ? std::to_string(classes.models.size()) + " models of " + settings.classes
                           : std::to_string(classes.models.size()) + " built-in shapes";

  for (const Row& row : rows) {
    ScoredRow& scored = table.rows.emplace_back(ScoredRow{row, {}, {}, 0, 0, 0});
    if (row.descriptor.empty()) continue;
    if (context.stop.stop_requested()) throw Stopped();
    const std::string text = scored.row.descriptor = with_size(row.descriptor, settings.size);
    const retrieval::DescriptorPointer descriptor = retrieval::make_descriptor(text);
    scored.bytes = descriptor->bytes();
    std::vector<retrieval::Signature> signatures(classes.models.size());
    for (const auto& term : retrieval::parse_composite(text)) {
      const retrieval::FeatureTable& own = features.tables.at(term.spec);
      scored.describe_seconds += own.seconds;
      std::size_t at = 0;
      for (std::size_t i = 0; i < kept.size(); ++i) {
        if (!kept[i]) continue;
        signatures[at].insert(signatures[at].end(), own.signatures[i].begin(), own.signatures[i].end());
        ++at;
      }
    }
    const Clock::time_point begin = Clock::now();
    const std::size_t sample = std::min<std::size_t>(signatures.size() - 1, 100);
    for (std::size_t i = 0; i < sample; ++i) descriptor->distance(signatures[i], signatures[i + 1]);
    scored.compare_seconds = std::chrono::duration<double>(Clock::now() - begin).count() /
                             static_cast<double>(std::max<std::size_t>(1, sample));
    scored.scores = retrieval::evaluate(
        retrieval::symmetric_matrix(
            signatures.size(),
            [&](std::size_t i, std::size_t j) { return descriptor->distance(signatures[i], signatures[j]); }),
        classes);
    add_intervals(scored, classes, context.seed);
  }
  return table;
}

ExperimentResult present(const std::string& name, const std::string& title, const ScoredTable& table) {
  ExperimentResult result;
  result.errors = table.errors;
  result.says = "DCG on " + table.collection + " (paper, on the benchmark's test half):";
  report::Csv data({"row",
                    "label",
                    "NN",
                    "FT",
                    "ST",
                    "DCG",
                    "DCG_low",
                    "DCG_high",
                    "paper_NN",
                    "paper_FT",
                    "paper_ST",
                    "paper_DCG",
                    "bytes",
                    "describe_seconds",
                    "compare_seconds",
                    "NN_low",
                    "NN_high",
                    "FT_low",
                    "FT_high",
                    "ST_low",
                    "ST_high"});
  result.table.push_back({"", "NN", "FT", "ST", "DCG", "paper: NN", "FT", "ST", "DCG", "bytes"});
  int index = 0;
  for (const ScoredRow& r : table.rows) {
    const bool cited = r.row.descriptor.empty();
    const PaperScores own = cited ? PaperScores{kNone, kNone, kNone, kNone} : ours(r.scores.micro);
    const PaperScores& paper = r.row.paper;
    std::array<retrieval::Interval, 4> in = r.intervals;
    if (cited) in.fill({kNone, kNone});
    data.row({++index,           r.row.label, own[0],     own[1],    own[2],     own[3],    in[3].low,
              in[3].high,        paper[0],    paper[1],   paper[2],  paper[3],   r.bytes,   r.describe_seconds,
              r.compare_seconds, in[0].low,   in[0].high, in[1].low, in[1].high, in[2].low, in[2].high});
    std::vector<std::string> cells{r.row.label};
    for (std::size_t k = 0; k < own.size(); ++k) cells.push_back(cited ? "-" : with_interval(own[k], in[k]));
    for (const double x : paper) cells.push_back(percent(x));
    cells.push_back(cited ? "-" : std::to_string(r.bytes));
    result.table.push_back(std::move(cells));
    result.says += (index > 1 ? ", " : " ") + r.row.label + " " + percent(own[3]) + " (" + percent(paper[3]) + ")";
    const auto list = [](const PaperScores& s) {
      Json json = Json::array();
      for (const double x : s) json.push_back(std::isnan(x) ? Json(nullptr) : Json(x));
      return json;
    };
    Json intervals = Json::array();
    for (const retrieval::Interval& interval : r.intervals)
      intervals.push_back(cited ? Json(nullptr) : Json{interval.low, interval.high});
    result.data.push_back({{"row", r.row.label},
                           {"descriptor", cited ? "cited" : r.row.descriptor},
                           {"nn_ft_st_dcg", list(own)},
                           {"intervals_95", intervals},
                           {"paper_nn_ft_st_dcg", list(paper)},
                           {"bytes", r.bytes},
                           {"describe_seconds", r.describe_seconds},
                           {"compare_seconds", r.compare_seconds}});
  }
  report::Panel panel;
  panel.x = {.label = "row", .lower = 0.5, .upper = index + 0.5, .step = 1};
  panel.y = {.label = "DCG, percent"};
  panel.bands.push_back({.x = 1, .low = 7, .high = 8, .style = {}});
  panel.curves.push_back({.x = 1, .y = 6, .label = "ours, 95 %", .style = {}, .points = true});
  panel.curves.push_back({.x = 1, .y = 12, .label = "the paper's, test half", .style = {1, 0}, .points = true});
  std::string caption;
  for (int i = 0; i < index; ++i)
    caption +=
        (i > 0 ? ", " : "Rows: ") + std::to_string(i + 1) + " " + table.rows[static_cast<std::size_t>(i)].row.label;
  result.table_says =
      "Percent, micro averages. In brackets 95 % intervals from a bootstrap over classes: what other classes like "
      "these "
      "would give. The paper's figures are of the benchmark's test half.";
  result.plots.push_back({name, caption + ".", report::Plot(title, std::move(data), {panel})});
  return result;
}

}  // namespace rectilin::paper::tables
