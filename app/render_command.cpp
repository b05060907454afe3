// rectilin render: pictures of meshes from directions spread over a sphere.
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>

#include "commands.h"
#include "options.h"
#include "output_names.h"
#include "rectilin/base/batch.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/source.h"
#include "rectilin/render/png.h"
#include "rectilin/render/rasterizer.h"
#include "rectilin/render/shaded.h"
#include "rectilin/report/contact_sheet.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

enum class Picture { kDepth, kSilhouette, kShaded };

struct RenderCommand {
  std::vector<std::string> sources;
  std::size_t views = 66;
  render::RenderOptions render;
  Picture picture = Picture::kDepth;
  bool touched = false, up_z = false;
  int bits = 8;
  std::string out;
  int threads = 0;
};

std::vector<std::uint8_t> in_eight_bits(const render::DepthImage& image) {
  std::vector<std::uint8_t> values;
  for (const std::uint16_t d : image.depth)
    values.push_back(static_cast<std::uint8_t>(d == 0 ? 0 : std::max(1, d >> 8)));
  return values;
}

std::string file_of(const render::DepthImage& image, const RenderCommand& options) {
  if (options.picture == Picture::kSilhouette) {
    std::vector<std::uint8_t> values;
    for (const std::uint16_t d : image.depth) values.push_back(d == 0 ? 0 : 255);
    return render::grey_png(values, image.size);
  }
  return options.bits == 16 ? render::grey_png(image.depth, image.size)
                            : render::grey_png(in_eight_bits(image), image.size);
}

std::string label(const Vector3& d) {
  return "(" + fixed(d.x(), 2) + " " + fixed(d.y(), 2) + " " + fixed(d.z(), 2) + ")";
}

struct Rendered {
  std::size_t faces;
  MeshReport report;
};

/// Renders all views of one mesh, and a sheet of them, into a folder of their own.
Rendered render_source(const std::string& source, const std::filesystem::path& folder, const render::ViewSphere& sphere,
                       const RenderCommand& options, const std::stop_token& stop) {
  const LoadedMesh loaded = load_mesh(source);
  const Mesh& mesh = loaded.mesh;
  const render::Ball ball = render::ball_around(mesh);
  std::vector<report::SheetCell> cells(sphere.size());
  const auto keep = [&](std::size_t k, std::string png) {
    cells[k] = {std::move(png), std::to_string(k), label(sphere.directions()[k])};
  };
  if (options.picture == Picture::kShaded) {
    for (std::size_t k = 0; k < sphere.size() && !stop.stop_requested(); ++k) {
      const Rotation frame = render::frame_towards(sphere.directions()[k], options.render.up);
      keep(k, render::grey_png(render::shaded(mesh, ball, frame, options.render.size), options.render.size));
    }
  } else {
    render::visit_views(mesh, ball, sphere, options.render, {}, [&](std::size_t k, const render::DepthImage& image) {
      if (!stop.stop_requested()) keep(k, file_of(image, options));
    });
  }
  if (stop.stop_requested()) throw Stopped();
  std::filesystem::create_directories(folder);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::string number = std::to_string(k);
    write_whole_file(
        folder / ("view-" + std::string(4 - std::min<std::size_t>(4, number.size()), '0') + number + ".png"),
        cells[k].png);
  }
  write_whole_file(folder / "sheet.svg", report::contact_sheet(cells, sphere.size() < 12 ? 3 : 11).svg);
  return {mesh.triangles.size(), loaded.report};
}

int run(RenderCommand options) {
  const render::ViewSphere sphere = [&] {
    try {
      return render::ViewSphere::of_size(options.views);
    } catch (const std::invalid_argument& e) {
      throw ParameterError(std::string("--views: ") + e.what());
    }
  }();
  if (options.bits == 16 && options.picture != Picture::kDepth) throw ParameterError("--bits 16 is for --depth");
  if (options.picture == Picture::kShaded && options.touched) throw ParameterError("--touched is not for --shaded");
  if (options.picture == Picture::kShaded && options.render.size > render::kLargestPicture / 3)
    throw ParameterError("--size: a shaded picture has at most " + std::to_string(render::kLargestPicture / 3) +
                         " pixels in a row");
  options.render.coverage = options.touched ? render::Coverage::kTouched : render::Coverage::kCentre;
  options.render.up = options.up_z ? Vector3::UnitZ() : Vector3::UnitY();
  const std::vector<std::string> sources = expand_folders(options.sources);
  if (std::filesystem::exists(options.out) && !std::filesystem::is_directory(options.out))
    throw ParameterError("--out " + options.out + " is a file, not a folder");

  const auto limit = limit_threads(options.threads);
  const std::stop_token stop = stop_on_interrupt();
  const std::vector<std::string> names = output_names(sources);
  const Table table({{"mesh", 24}, {"faces", 8}, {"views", 5}});
  std::cout << table.header() << "  folder\n";
  std::size_t failed = 0;
  Progress progress(sources.size());
  const auto work = [&](std::size_t i) {
    return render_source(sources[i], std::filesystem::path(options.out) / names[i], sphere, options, stop);
  };
  const auto deliver = [&](std::size_t i, Outcome<Rendered>&& outcome) {
    progress.clear();
    if (outcome.value) {
      complain_of_loss(sources[i], outcome.value->report);
      std::cout << table.row({sources[i], std::to_string(outcome.value->faces), std::to_string(sphere.size())}) << "  "
                << printable((std::filesystem::path(options.out) / names[i]).string()) << '\n';
      check_output();
    } else {
      ++failed;
      complain(outcome.error);
    }
  };
  std::size_t delivered = 0;
  try {
    delivered = for_each_in_order<Rendered>(
        sources, work, deliver,
        {stop, [&](std::size_t done, std::size_t, const std::string& text) { progress.show(done, text); }});
  } catch (const Stopped&) {
    progress.clear();
    complain("stopped: the files written so far are complete");
    return 1;
  }
  if (delivered < sources.size())
    complain("stopped: " + std::to_string(sources.size() - delivered) + " meshes are not rendered");
  return failed > 0 || delivered < sources.size() ? 1 : 0;
}

}  // namespace

void add_render_command(CLI::App& app, int& status) {
  auto options = std::make_shared<RenderCommand>();
  CLI::App* command = app.add_subcommand("render", "Draw meshes from a sphere of directions, as PNG files");
  command->add_option("source", options->sources, "Mesh files, folders of them, built-in shapes (shape:NAME?key=value)")
      ->required();
  command->add_option("-O,--out", options->out, "Folder to write to; each mesh gets a folder in it")->required();
  command->add_option("-v,--views", options->views, "Directions: 6, 18, 66, 258, ... of a geodesic sphere")
      ->check(count())
      ->capture_default_str();
  command->add_option("-s,--size", options->render.size, "Pixels in a row")
      ->check(number_check<int>("a number of pixels from 1 to " + std::to_string(render::kLargestPicture),
                                [](int n) { return 1 <= n && n <= render::kLargestPicture; }))
      ->capture_default_str();
  CLI::Option_group* kind = command->add_option_group("picture");
  kind->require_option(0, 1);
  kind->add_flag_callback(
      "--depth", [options] { options->picture = Picture::kDepth; },
      "Depths, nearer is brighter, 0 is background (default)");
  kind->add_flag_callback(
      "--silhouette", [options] { options->picture = Picture::kSilhouette; }, "White where something is seen");
  kind->add_flag_callback(
      "--shaded", [options] { options->picture = Picture::kShaded; }, "Shaded, with creases and outlines");
  command->add_option("--bits", options->bits, "Bits of a depth: 8 or 16")
      ->check(CLI::IsMember({8, 16}))
      ->capture_default_str();
  command->add_flag("--touched", options->touched, "Draw every pixel that is touched, so that thin parts are kept");
  command->add_flag("--z-up", options->up_z, "Upward is z, not y");
  add_threads_option(*command, options->threads, "the pictures are the same for any");
  command->footer(
      "The middle of the mesh's box is in the middle of each picture, and the mesh fits into it from every side.\n"
      "Parallel projection. sheet.svg in each folder shows all views with their directions.\n"
      "Example: rectilin render chair.off meshes/ --views 18 --size 512 --shaded -O pictures");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace rectilin::app
