// One loop for work on many sources: in parallel, with results in order, where a failure costs one item.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>

namespace rectilin {

/// Thrown by work that was asked to stop and has nothing to show for it.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

/// Called from any thread, one call at a time: `done` of `total` items are finished, and `text` says what is in work.
using OnProgress = std::function<void(std::size_t done, std::size_t total, const std::string& text)>;

/// What an item came to: a value, or one line that says why there is none.
template <class Result>
struct Outcome {
  std::optional<Result> value;
  std::string error;
};

/// What a loop over many items listens to and reports to.
struct LoopControl {
  std::stop_token stop = {};
  OnProgress on_progress = {};
};

/// An error in one line that begins with the name of what it is about, once.
std::string error_about(const std::string& name, const std::string& what);

/// The loop below without types: `work(i)` runs in parallel, `deliver(i, result)` in order, one at a time. Returns how
/// many items were delivered, which is `names.size()` unless the loop was stopped.
std::size_t run_in_order(std::span<const std::string> names,
                         const std::function<std::shared_ptr<void>(std::size_t)>& work,
                         const std::function<void(std::size_t, void*)>& deliver, const LoopControl& control);

/// Calls `work(i) -> Result` for each name, several at a time, and `deliver(i, Outcome<Result>&&)` in the order of the
/// names, one at a time. An exception of `work` becomes the outcome's error, but for Stopped, which ends the loop and
/// is thrown on; so is what `deliver` throws. After a stop no item is begun, and those in work are still delivered.
/// Each item is isolated: a thread that waits for a parallel loop inside one item does not begin another, so that
/// neither its time nor its memory is charged to the first. Returns how many items were delivered.
template <class Result, class Work, class Deliver>
std::size_t for_each_in_order(std::span<const std::string> names, const Work& work, const Deliver& deliver,
                              const LoopControl& control = {}) {
  return run_in_order(
      names,
      [&](std::size_t i) -> std::shared_ptr<void> {
        auto outcome = std::make_shared<Outcome<Result>>();
        try {
          outcome->value.emplace(work(i));
        } catch (const Stopped&) {
          throw;
        } catch (const std::exception& e) {
          outcome->error = error_about(names[i], e.what());
        }
        return outcome;
      },
      [&](std::size_t i, void* outcome) { deliver(i, std::move(*static_cast<Outcome<Result>*>(outcome))); }, control);
}

}  // namespace rectilin
