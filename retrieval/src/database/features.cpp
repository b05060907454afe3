#include "rectilin/retrieval/features.h"

#include <tbb/parallel_for.h>
#include <time.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include "rectilin/base/fnv1a.h"
#include "rectilin/base/journal.h"
#include "rectilin/base/version.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"

namespace rectilin::retrieval {
namespace {

namespace fs = std::filesystem;

std::string hexadecimal(SignatureView bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes) text.append({kDigits[byte >> 4], kDigits[byte & 15]});
  return text;
}

/// Empty if it is not what hexadecimal() writes of so many bytes.
Signature from_hexadecimal(const std::string& text, std::size_t size) {
  const auto digit = [](char c) { return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1; };
  if (text.size() != 2 * size) return {};
  Signature bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    const int high = digit(text[2 * i]), low = digit(text[2 * i + 1]);
    if (high < 0 || low < 0) return {};
    bytes[i] = static_cast<std::uint8_t>(16 * high + low);
  }
  return bytes;
}

std::string hash_text(std::uint64_t hash) {
  std::ostringstream text;
  text << std::hex << hash;
  return text.str();
}

/// Of a built-in shape, whose text is all there is to it, that text.
std::string bytes_digest(const std::string& file) {
  if (file.starts_with("shape:")) return hash_text(Fnv1a().add(file).value());
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return hash_text(Fnv1a().add(bytes.view()).value());
}

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A descriptor with its file and what came from there.
struct Source {
  std::string spec;
  DescriptorPointer descriptor;
  std::vector<Signature> signatures;
  std::vector<double> seconds;
  std::vector<std::string> left_out;  ///< of each model, by its reader
  std::unique_ptr<Journal> journal;

  Source(const std::string& text, const Collection& collection, const std::vector<std::string>& digests,
         const fs::path& folder)
      : spec(text), descriptor(descriptors().make(text)) {
    const std::size_t n = collection.files.size();
    signatures.resize(n);
    seconds.resize(n);
    left_out.resize(n);
    const std::string full = full_spec(text);
    const std::string key = hash_text(Fnv1a().add(full).add(version()).value());
    const fs::path file = folder / (Spec::parse(text).name + "-" + key + ".jsonl");
    std::map<std::string, std::size_t> number;
    for (std::size_t i = 0; i < n; ++i) number.emplace(collection.classes.models[i], i);
    const std::vector<Json> lines = recover_journal(file);
    for (const Json& line : lines) {
      if (!line.contains("model")) continue;
      const auto model = number.find(line.value("model", ""));
      if (model == number.end() || line.value("digest", "") != digests[model->second]) continue;
      signatures[model->second] = from_hexadecimal(line.value("signature", ""), descriptor->bytes());
      seconds[model->second] = line.value("seconds", 0.0);
      left_out[model->second] = line.value("left_out", "");
    }
    journal = std::make_unique<Journal>(file);
    if (lines.empty()) journal->append({{"descriptor", full}, {"bytes", descriptor->bytes()}, {"version", version()}});
  }
};

struct Described {
  std::vector<std::pair<Signature, double>> made;  ///< for each source; no bytes if it was there already
  std::string left_out;
};

}  // namespace

std::string full_spec(const std::string& spec) {
  const Spec parsed = Spec::parse(spec);
  Json settings = Json::object();
  for (const auto& parameter : descriptors().find(parsed.name).parameters) settings[parameter.name] = parameter.value;
  settings.update(parsed.settings);
  return parsed.name + to_text(settings);
}

Features compute_features(const Collection& collection, const std::vector<std::string>& specs, const fs::path& folder,
                          const LoopControl& control) {
  fs::create_directories(folder);
  const std::size_t n = collection.files.size();
  std::vector<std::string> digests(n);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) { digests[i] = bytes_digest(collection.files[i]); });
  std::vector<Source> sources;
  for (const std::string& spec : specs) sources.emplace_back(spec, collection, digests, folder);

  std::vector<std::size_t> todo;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < n; ++i) {
    if (std::ranges::none_of(sources, [&](const Source& s) { return s.signatures[i].empty(); })) continue;
    todo.push_back(i);
    names.push_back(collection.files[i]);
  }
  Features features;
  const auto work = [&](std::size_t k) {
    const std::size_t i = todo[k];
    LoadedMesh loaded = load_mesh(collection.files[i]);
    const Model model(std::move(loaded.mesh));
    Described described;
    described.left_out = summary(loaded.report);
    for (const Source& source : sources) {
      described.made.emplace_back();
      if (!source.signatures[i].empty()) continue;
      const double begin = thread_seconds();
      described.made.back().first = source.descriptor->describe(model);
      described.made.back().second = thread_seconds() - begin;
    }
    return described;
  };
  const auto deliver = [&](std::size_t k, Outcome<Described>&& outcome) {
    const std::size_t i = todo[k];
    if (!outcome.value) {
      features.failed.push_back(collection.classes.models[i]);
      features.errors.push_back(outcome.error);
      return;
    }
    for (std::size_t s = 0; s < sources.size(); ++s) {
      auto& [signature, seconds] = outcome.value->made[s];
      if (signature.empty()) continue;
      Json line = {{"model", collection.classes.models[i]},
                   {"digest", digests[i]},
                   {"seconds", seconds},
                   {"signature", hexadecimal(signature)}};
      if (!outcome.value->left_out.empty()) line["left_out"] = outcome.value->left_out;
      sources[s].journal->append(line);
      sources[s].left_out[i] = outcome.value->left_out;
      sources[s].signatures[i] = std::move(signature);
      sources[s].seconds[i] = seconds;
    }
  };
  features.complete = for_each_in_order<Described>(names, work, deliver, control) == names.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto found = std::ranges::find_if(sources, [&](const Source& s) { return !s.left_out[i].empty(); });
    if (found != sources.end()) features.losses.push_back(collection.files[i] + ": " + found->left_out[i]);
  }
  for (Source& source : sources) {
    double sum = 0;
    for (const double seconds : source.seconds) sum += seconds;
    features.tables[source.spec] = {std::move(source.signatures), n > 0 ? sum / static_cast<double>(n) : 0};
  }
  return features;
}

}  // namespace rectilin::retrieval
