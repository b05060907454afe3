// rectilin silhouette: certified intervals for the areas of projections.
#include <charconv>
#include <iostream>
#include <memory>

#include "commands.h"
#include "options.h"
#include "rectilin/base/batch.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/run_record.h"
#include "rectilin/render/png.h"
#include "rectilin/render/rasterizer.h"
#include "rectilin/render/silhouette_area.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

constexpr int kDigits = 12;
constexpr double kOutward = 6e-12;  // relative; more than rounding to the printed digits can change

struct SilhouetteCommand {
  std::vector<std::string> sources, directions;
  std::size_t views = 0;
  double tolerance = 1e-6;
  bool json = false;
  std::string picture;
  int size = 512;
  int threads = 0;
};

/// The result for one mesh.
struct Areas {
  std::vector<render::AreaInterval> areas;  ///< one for each direction
  MeshReport report;
};

/// Reads a direction x,y,z: three finite numbers that are not all zero.
Vector3 parse_direction(const std::string& text) {
  Vector3 direction;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int k = 0; k < 3; ++k) {
    if (k > 0 && (at == end || *at++ != ',')) break;
    const auto [next, error] = std::from_chars(at, end, direction[k]);
    if (error != std::errc()) break;
    at = next;
    if (k == 2 && at == end && direction.allFinite() && direction != Vector3::Zero()) return direction;
  }
  throw ParameterError("--direction: '" + text + "' is not x,y,z, three numbers that are not all zero");
}

std::vector<Vector3> directions_of(const SilhouetteCommand& options) {
  std::vector<Vector3> directions;
  for (const std::string& text : options.directions) directions.push_back(parse_direction(text));
  if (options.views > 0) {
    try {
      const render::ViewSphere sphere = render::ViewSphere::of_size(options.views);
      directions.assign(sphere.directions().begin(), sphere.directions().end());
    } catch (const std::invalid_argument& e) {
      throw ParameterError(std::string("--views: ") + e.what());
    }
  }
  if (directions.empty()) directions = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  return directions;
}

void write_picture(const Mesh& mesh, const Vector3& direction, const SilhouetteCommand& options) {
  const render::RenderOptions render{.size = options.size};
  const render::DepthImage image =
      render::ViewRenderer(mesh, render::ball_around(mesh), render).render(render::frame_towards(direction));
  std::vector<std::uint8_t> values;
  for (const std::uint16_t d : image.depth) values.push_back(d == 0 ? 255 : 0);
  write_whole_file(options.picture, render::grey_png(values, image.size));
}

std::string text_of(const Vector3& d) { return general(d.x(), 4) + "," + general(d.y(), 4) + "," + general(d.z(), 4); }

int run(const SilhouetteCommand& options) {
  const std::vector<Vector3> directions = directions_of(options);
  const std::vector<std::string> sources = expand_folders(options.sources);
  if (!options.picture.empty()) {
    if (sources.size() != 1 || directions.size() != 1)
      throw ParameterError("--picture is for one mesh and one direction");
    if (format_of_extension(options.picture))
      throw ParameterError("--picture " + options.picture + ": the picture would look like a mesh");
  }

  const auto limit = limit_threads(options.threads);
  const std::stop_token stop = stop_on_interrupt();
  const Table table({{"mesh", 24}, {"direction", 22}, {"at least", 18}, {"at most", 18}});
  if (!options.json) std::cout << table.header() << '\n';
  std::size_t failed = 0;
  Progress progress(sources.size());
  const auto work = [&](std::size_t i) {
    const LoadedMesh loaded = load_mesh(sources[i]);
    Areas areas{render::Silhouette(loaded.mesh).areas(directions, options.tolerance), loaded.report};
    if (!options.picture.empty()) write_picture(loaded.mesh, directions.front(), options);
    return areas;
  };
  const auto deliver = [&](std::size_t i, Outcome<Areas>&& outcome) {
    progress.clear();
    if (!outcome.value) {
      ++failed;
      complain(outcome.error);
      if (options.json) std::cout << to_text({{"name", sources[i]}, {"error", outcome.error}}) << '\n';
      return;
    }
    complain_of_loss(sources[i], outcome.value->report);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const Vector3& d = directions[k];
      const auto& [lower, upper] = outcome.value->areas[k];
      if (options.json)
        std::cout << to_text({{"name", sources[i]},
                              {"direction", {d.x(), d.y(), d.z()}},
                              {"lower", lower},
                              {"upper", upper},
                              {"tolerance", options.tolerance},
                              {"report", to_json(outcome.value->report)}})
                  << '\n';
      else std::cout << table.row({sources[i], text_of(d), general(lower, 12), general(upper, 12)}) << '\n';
    }
    check_output();
  };
  const auto on_progress = [&](std::size_t done, std::size_t, const std::string& text) { progress.show(done, text); };
  const std::size_t delivered = for_each_in_order<Areas>(sources, work, deliver, {stop, on_progress});
  if (delivered < sources.size())
    complain("stopped: " + std::to_string(sources.size() - delivered) + " meshes are not measured");
  return failed > 0 || delivered < sources.size() ? 1 : 0;
}

}  // namespace

void add_silhouette_command(CLI::App& app, int& status) {
  auto options = std::make_shared<SilhouetteCommand>();
  CLI::App* command = app.add_subcommand("silhouette", "Enclose the areas of meshes' silhouettes");
  command->add_option("source", options->sources, "Mesh files, folders of them, built-in shapes (shape:NAME?key=value)")
      ->required();
  auto* directions = command->add_option("-d,--direction", options->directions,
                                         "Direction of the projection, x,y,z of any length; may be given again "
                                         "(default: the three axes)");
  command->add_option("-v,--views", options->views, "Directions of a geodesic sphere: 6, 18, 66, 258, ...")
      ->check(count())
      ->excludes(directions);
  command->add_option("--tolerance", options->tolerance, "Width of the interval, relative to its upper end")
      ->check(number_check<double>("a tolerance from 0 to 1", [](double x) { return 0 <= x && x <= 1; }))
      ->capture_default_str();
  command->add_flag("-j,--json", options->json, "One JSON object a line instead of the table");
  command->add_option("-p,--picture", options->picture, "PNG file for the silhouette; one mesh, one direction");
  command->add_option("-s,--size", options->size, "Pixels in a row of the picture")
      ->check(number_check<int>("a number of pixels from 1 to " + std::to_string(render::kLargestPicture),
                                [](int n) { return 1 <= n && n <= render::kLargestPicture; }))
      ->capture_default_str();
  add_threads_option(*command, options->threads, "the answer is the same for any");
  command->footer(
      "The area of the union of the projected triangles surely lies between the two numbers, in the square of the\n"
      "mesh's unit; rounding is accounted for. Any mesh will do, open, crossing itself, oriented or not.\n"
      "Examples: rectilin silhouette chair.off --direction 0,0,1 --picture shadow.png\n"
      "          rectilin silhouette --json --views 66 meshes/ > areas.jsonl");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace rectilin::app
