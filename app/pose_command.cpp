// rectilin pose: the poses of meshes, and meshes written in their pose.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <set>

#include "commands.h"
#include "corpus_run.h"
#include "options.h"
#include "poser.h"
#include "rectilin/base/batch.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"
#include "rectilin/pose/json.h"
#include "rectilin/pose/pose.h"
#include "rectilin/pose/views.h"
#include "rectilin/report/contact_sheet.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSheetLimit = 500;  // largest number of meshes on a contact sheet

struct PoseOptions {
  std::vector<std::string> sources;
  PoseSettings settings;
  std::string write, format = "off", sheet;
  int threads = 0;
  bool json = false;
  std::optional<double> seconds;
  CorpusArguments corpus;
};

/// The file to write for each source: `target` itself for a single source if it has the extension of a mesh, otherwise
/// a file in that folder.
std::vector<std::string> targets(const PoseOptions& options, const std::vector<std::string>& sources) {
  if (options.write.empty()) return std::vector<std::string>(sources.size());
  if (format_of_extension(options.write) && !fs::is_directory(options.write)) {
    if (sources.size() > 1)
      throw ParameterError("--write " + options.write + ": one file for several meshes; name a folder");
    return {options.write};
  }
  if (!format_of_extension("mesh." + options.format))
    throw ParameterError("no meshes are written as ." + options.format);
  fs::create_directories(options.write);
  std::vector<std::string> files;
  std::set<std::string> taken;
  for (const std::string& source : sources) {
    std::string stem = fs::path(source).stem().string();
    if (source.starts_with("shape:"))
      stem = source.substr(6, source.find('?') == std::string::npos ? std::string::npos : source.find('?') - 6);
    std::string name = stem;
    for (int n = 2; !taken.insert(name).second; ++n) name = stem + "-" + std::to_string(n);
    files.push_back((fs::path(options.write) / (name + "." + options.format)).string());
  }
  return files;
}

/// Refuses to write a mesh over the file it was read from, or over another source that is still to be read.
void check_targets(const std::vector<std::string>& targets, const std::vector<std::string>& sources) {
  for (const std::string& target : targets)
    for (const std::string& source : sources) {
      std::error_code ignored;
      if (!target.empty() && fs::equivalent(target, source, ignored))
        throw ParameterError("--write would replace " + source + "; name another folder or file");
    }
}

std::string uniqueness(const Posed& posed) {
  const pose::Pose& pose = posed.pose;
  switch (pose.uniqueness) {
    case pose::Uniqueness::kUnique:
      return posed.resolved ? "yes" : "axes?";
    case pose::Uniqueness::kSeveral:
      return std::to_string(pose.alternatives.size() + 1) + " poses";
    case pose::Uniqueness::kContinuum:
      return std::string("round ") + "xyz"[pose.free_axis];
    case pose::Uniqueness::kNone:
      return "no pose";
  }
  return "";
}

Posed pose_source(const Poser& poser, const std::string& source, const std::string& target, bool pictures) {
  const LoadedMesh loaded = load_mesh(source);
  Posed posed = poser(loaded);
  if (pictures) posed.pictures = pose::three_views(loaded.mesh, posed.pose.rotation);
  if (!target.empty()) {
    write_mesh(target, pose::normalized(loaded.mesh, posed.pose));
    posed.file = target;
  }
  return posed;
}

class Printer {
 public:
  Printer(const std::vector<std::string>& sources, bool json) : json_(json), table_(columns(sources)) {
    if (json_) return;
    std::cout << table_.header() << '\n';
    check_output();
  }

  void print(const std::string& name, const Posed& posed) const {
    if (json_) {
      Json line = {{"name", name}};
      line.update(pose::to_json(posed.pose, posed.area));
      line["report"] = to_json(posed.report);
      if (!posed.file.empty()) line["file"] = posed.file;
      std::cout << to_text(line) << '\n';
    } else {
      const pose::Pose& pose = posed.pose;
      const pose::PoseCandidate& best = pose.candidates.front();
      const double turn = frame_angle(pose.rotation, Rotation()) * (180 / std::numbers::pi);
      const auto other = std::ranges::find_if(
          pose.candidates, [&](const auto& c) { return frame_angle(c.rotation, best.rotation) > 1e-3; });
      std::cout << table_.row({name, pose.chosen, fixed(best.projected, 6), fixed(best.silhouette.value_or(0), 6),
                               other == pose.candidates.end() ? "-" : other->name,
                               other == pose.candidates.end() ? "-" : fixed(other->silhouette.value_or(0), 6),
                               fixed(turn, 3), uniqueness(posed), fixed(pose.confidence, 3)})
                << '\n';
    }
    check_output();
  }

  void print_error(const std::string& name, const std::string& error) const {
    complain(error);
    if (json_) std::cout << to_text(Json{{"name", name}, {"error", error}}) << '\n';
    check_output();
  }

 private:
  static std::vector<Table::Column> columns(const std::vector<std::string>& sources) {
    return {{"name", widest(sources)}, {"chosen", 22},   {"P/S", 9},    {"silhouettes", 11}, {"next", 22},
            {"silhouettes", 11},       {"turned by", 9}, {"unique", 8}, {"confidence", 6}};
  }

  bool json_;
  Table table_;
};

int pose_into_store(const PoseOptions& options) {
  if (options.json || !options.write.empty() || !options.sheet.empty())
    throw ParameterError("--json, --write and --sheet cannot be used with a store");
  const Poser check(options.settings);  // throws for wrong options before any workers are started
  return work_into_store(expand_sources(options.sources), pose_task(options.settings), options.corpus,
                         worker_options(options.corpus, options.seconds, options.threads));
}

int pose_meshes(const PoseOptions& options) {
  if (!options.corpus.store.empty()) return pose_into_store(options);
  options.corpus.check();
  if (options.seconds) throw ParameterError("--seconds needs a store: -O FILE.db");
  const Poser poser(options.settings);
  const std::vector<std::string> sources = expand_folders(options.sources);
  if (sources.empty()) throw MeshError("the list of files is empty");
  const std::vector<std::string> files = targets(options, sources);
  check_targets(files, sources);
  const auto limit = limit_threads(options.threads);
  const std::stop_token stop = stop_on_interrupt();

  const Printer printer(sources, options.json);
  Progress progress(sources.size());
  std::vector<report::SheetCell> cells;
  std::size_t failed = 0;
  const auto deliver = [&](std::size_t i, Outcome<Posed>&& outcome) {
    progress.clear();
    if (!outcome.value) {
      ++failed;
      printer.print_error(sources[i], outcome.error);
      return;
    }
    complain_of_loss(sources[i], outcome.value->report);
    printer.print(sources[i], *outcome.value);
    if (options.sheet.empty() || cells.size() >= 3 * kSheetLimit) return;
    const pose::Pose& pose = outcome.value->pose;
    const std::array<std::string, 3> values = {pose.chosen, "unique? " + uniqueness(*outcome.value),
                                               "confidence " + fixed(pose.confidence, 3)};
    for (std::size_t k = 0; k < 3; ++k)
      cells.push_back(
          {outcome.value->pictures[k], fs::path(sources[i]).filename().string() + " from " + "xyz"[k], values[k]});
  };
  const std::size_t done = for_each_in_order<Posed>(
      sources, [&](std::size_t i) { return pose_source(poser, sources[i], files[i], !options.sheet.empty()); }, deliver,
      {.stop = stop, .on_progress = progress.shown()});
  progress.clear();
  if (!options.sheet.empty()) write_whole_file(options.sheet, report::contact_sheet(cells, 6).svg);
  if (done < sources.size()) complain("stopped: " + std::to_string(sources.size() - done) + " meshes have no pose");
  return failed > 0 || done < sources.size() ? 1 : 0;
}

}  // namespace

void add_pose_command(CLI::App& app, int& status) {
  auto options = std::make_shared<PoseOptions>();
  CLI::App* command = app.add_subcommand("pose", "Find the pose of meshes, and write them in it");
  command
      ->add_option(
          "source", options->sources,
          "Mesh files, folders and archives of them, lists (.txt, .csv), built-in shapes (shape:NAME?key=value)")
      ->required();
  command
      ->add_option("-m,--method", options->settings.method,
                   "Method, with settings: composite?planes=12 (see 'rectilin poses')")
      ->capture_default_str();
  command
      ->add_option("-a,--axes", options->settings.axes,
                   "Order and directions of the axes: free (as near to the given ones as can be), ordered or pca4 (by "
                   "second moments, x the longest), definite (x and y also point to the larger half of the area)")
      ->check(CLI::IsMember({"free", "ordered", "pca4", "definite"}))
      ->capture_default_str();
  command->add_option("-w,--write", options->write,
                      "Folder for the meshes in their pose, or a file for one: centre of mass at the origin, largest "
                      "polar distance 1. Vertices and faces only: colours and textures are not kept");
  command->add_option("-f,--format", options->format, "Format of meshes written into a folder")->capture_default_str();
  command->add_option("--sheet", options->sheet,
                      "SVG file for a contact sheet: three views of each, 500 meshes at most");
  add_threads_option(*command, options->threads, "the answer is the same for any");
  add_corpus_options(*command, options->corpus, "-o,-O,--out", "; with a store, like all that follows");
  add_seconds_option(*command, options->seconds);
  command->add_flag("-j,--json", options->json, "One JSON object a line instead of the table");
  command->footer(
      "The table: the candidate taken, its projected area P and its three silhouettes over the surface's area S, the\n"
      "next candidate with its silhouettes, the angle in degrees between the pose and the given axes (the nearest of "
      "the\n"
      "24 ways to name them), whether the pose is the only one, and how clear the choice was, from 0 to 1.\n"
      "A file that has no pose costs its own row and the exit status (1).\n"
      "Examples: rectilin pose chair.off\n"
      "          rectilin pose meshes/ --write posed --axes definite --sheet posed.svg\n"
      "          rectilin pose --method cpn --json meshes/ > poses.jsonl\n"
      "          rectilin pose abc.zip -o abc-poses.db --seconds 60 --memory 4G");
  command->callback([options, &status] { status = pose_meshes(*options); });
}

}  // namespace rectilin::app
