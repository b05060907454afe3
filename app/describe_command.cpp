// rectilin describe: signatures of meshes as files, for other programs.
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.h"
#include "options.h"
#include "output_names.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/source.h"
#include "rectilin/retrieval/descriptor.h"
#include "rectilin/retrieval/lfd_files.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

namespace fs = std::filesystem;

struct DescribeOptions {
  std::vector<std::string> sources;
  std::string descriptor = "gsmd", out;
  bool json = false;
  int threads = 0;
};

struct Described {
  retrieval::Signature signature;
  MeshReport report;
};

bool is_lfd_of_its_authors(const std::string& descriptor) {
  const std::vector<retrieval::Term> terms = retrieval::parse_composite(descriptor);
  return terms.size() == 1 && terms.front().spec.substr(0, terms.front().spec.find('?')) == "lfd:ntu";
}

std::string hexadecimal(const retrieval::Signature& signature) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : signature) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

int describe(const DescribeOptions& options) {
  if (options.out.empty() && !options.json) throw ParameterError("a folder for the files is needed (-O), or --json");
  const retrieval::DescriptorPointer descriptor = retrieval::make_descriptor(options.descriptor);
  const bool lfd = is_lfd_of_its_authors(options.descriptor);
  if (fs::exists(options.out) && !fs::is_directory(options.out))
    throw ParameterError("--out " + options.out + " is a file, not a folder");
  const std::vector<std::string> sources = expand_folders(options.sources);
  const std::vector<std::string> names = output_names(sources);
  if (!options.out.empty()) fs::create_directories(options.out);

  const auto limit = limit_threads(options.threads);
  const std::stop_token stop = stop_on_interrupt();
  const Table table({{"mesh", 24}, {"bytes", 6}});
  if (!options.json) std::cout << table.header() << "  file\n";
  bool failed = false;
  Progress progress(sources.size());
  const auto work = [&](std::size_t i) {
    LoadedMesh loaded = load_mesh(sources[i]);
    return Described{descriptor->describe(retrieval::Model(std::move(loaded.mesh))), loaded.report};
  };
  const auto deliver = [&](std::size_t i, Outcome<Described>&& outcome) {
    progress.clear();
    if (!outcome.value) {
      failed = true;
      complain(outcome.error);
      return;
    }
    const retrieval::Signature& signature = outcome.value->signature;
    complain_of_loss(sources[i], outcome.value->report);
    if (!options.out.empty()) {
      const fs::path base = fs::path(options.out) / names[i];
      if (lfd) retrieval::write_lfd_files(base, signature);
      else write_whole_file(base.string() + ".signature", std::string(signature.begin(), signature.end()));
      if (!options.json)
        std::cout << table.row({sources[i], std::to_string(signature.size())}) << "  "
                  << printable(base.string() + (lfd ? ".{art,fd,cir,ecc}" : ".signature")) << '\n';
    }
    if (options.json)
      std::cout << to_text({{"name", sources[i]},
                            {"descriptor", options.descriptor},
                            {"bytes", signature.size()},
                            {"signature", hexadecimal(signature)}})
                << '\n';
    check_output();
  };
  if (for_each_in_order<Described>(sources, work, deliver, {stop, progress.shown()}) < sources.size()) {
    complain("stopped");
    return 1;
  }
  return failed ? 1 : 0;
}

}  // namespace

void add_describe_command(CLI::App& app, int& status) {
  auto options = std::make_shared<DescribeOptions>();
  CLI::App* command = app.add_subcommand("describe", "Write what descriptors make of meshes, for other programs");
  command->add_option("mesh", options->sources, "Mesh files, folders of them, shapes")->required();
  command
      ->add_option("-d,--descriptor", options->descriptor,
                   "A descriptor or a weighted sum of them, as 'rectilin evaluate' takes it")
      ->capture_default_str();
  command->add_option("-O,--out", options->out, "Folder for the files");
  command->add_flag("-j,--json", options->json,
                    "A JSON object a line for each mesh, the signature in hexadecimal digits");
  add_threads_option(*command, options->threads, "the signatures are the same for any");
  command->footer(
      "OUT/NAME.signature holds the bytes, in the order of a sum's terms. lfd:ntu writes OUT/NAME.art, .fd, .cir and\n"
      ".ecc instead, as the light field descriptor's own program does; 'rectilin evaluate --lfd' reads them.\n"
      "Examples: rectilin describe chair.off -d 'gsmd?views=66' --json\n"
      "          rectilin describe meshes/ -d lfd:ntu -O features");
  command->callback([options, &status] { status = describe(*options); });
}

}  // namespace rectilin::app
