// What tests of comparisons share: folders that vanish, optimizers with known ends, results made by hand.
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "rectilin/experiments/results.h"
#include "rectilin/optim/registry.h"

namespace rectilin::test {

/// A new folder, removed with its content.
class ScratchFolder {
 public:
  ScratchFolder() {
    static std::atomic<int> count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("rectilin-test-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct NoOptions {
  void bind(Parameters&) {}
};

/// Proves what is known of the built-in box and pyramid: the pose they are made in is the best one.
class KnownOptimum final : public OptimizerWith<NoOptions> {
 public:
  using Options = NoOptions;
  static constexpr const char* kName = "known";
  explicit KnownOptimum(Options options = {}) : OptimizerWith(options) {}
  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_chart = false, .uses_random = false, .certifies = true}; }
  void run(Evaluator& evaluator, const Chart&, Random&) const override {
    evaluator.raise_lower_bound(evaluator.value(Rotation()) * (1 - 1e-11));
  }
};

/// Throws after a few evaluations.
class Crash final : public OptimizerWith<NoOptions> {
 public:
  using Options = NoOptions;
  static constexpr const char* kName = "crash";
  explicit Crash(Options options = {}) : OptimizerWith(options) {}
  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_chart = false}; }
  void run(Evaluator& evaluator, const Chart&, Random& random) const override {
    for (int i = 0; i < 3; ++i) evaluator.value(random_rotation(random));
    throw std::runtime_error("it <crashed>");
  }
};

inline Registry test_registry() {
  Registry registry = builtin_optimizers();
  registry.add<KnownOptimum>("").add<Crash>("");
  return registry;
}

/// A run that had the gaps `gap` after `evaluations`, and ended after `spent`.
inline RunResult run_with(std::size_t mesh, std::size_t entry, int index, std::vector<double> evaluations,
                          std::vector<double> gap, double spent) {
  RunResult run;
  run.mesh = mesh;
  run.entry = entry;
  run.run = index;
  run.evaluations = spent;
  run.trace.worst = 1.25;
  run.trace.seconds = evaluations;
  run.trace.evaluations = std::move(evaluations);
  run.trace.gap = std::move(gap);
  run.record = {{"values", spent}, {"cuts", 0}, {"smooths", 0}, {"turns", 0}};
  return run;
}

inline MeshResult mesh_with(const std::string& name, double lower, double upper) {
  MeshResult mesh;
  mesh.name = mesh.title = name;
  mesh.lower = lower;
  mesh.upper = upper;
  return mesh;
}

}  // namespace rectilin::test
