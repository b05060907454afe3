// The loop that all commands use for many sources: items run in parallel, results come in order, and an item that fails
// costs only itself.
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

/// Thrown by work that was asked to stop before it had a result.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

/// Called from any thread, one call at a time: `done` of `total` items are finished; `text` names the one being
/// worked on.
using OnProgress = std::function<void(std::size_t done, std::size_t total, const std::string& text)>;

/// The result of one item: a value or, if it failed, one line that says why.
template <class Result>
struct Outcome {
  std::optional<Result> value;
  std::string error;
};

/// How a caller stops such a loop, and how it hears of its progress.
struct LoopControl {
  std::stop_token stop = {};
  OnProgress on_progress = {};
};

/// `what` as one line that begins with `name`. The name is not repeated if `what` begins with it already.
std::string error_about(const std::string& name, const std::string& what);

/// The loop of for_each_in_order() without its template parameters: `work(i)` runs in parallel, `deliver(i, result)` in
/// order and one at a time. Returns how many items were delivered, which is `names.size()` unless the loop was stopped.
std::size_t run_in_order(std::span<const std::string> names,
                         const std::function<std::shared_ptr<void>(std::size_t)>& work,
                         const std::function<void(std::size_t, void*)>& deliver, const LoopControl& control);

/// Calls `work(i) -> Result` for each name, several at a time, and `deliver(i, Outcome<Result>&&)` in the order of the
/// names, one at a time. If `work` throws, the message becomes that item's Outcome::error; only Stopped ends the loop
/// and is passed on to the caller, as is anything that `deliver` throws. After a stop no new item is begun, but those
/// already begun are finished and delivered. Items are isolated from each other: a thread that waits for a parallel
/// loop inside one item does not begin another one meanwhile, so the time and memory of an item are its own. Returns
/// how many items were delivered.
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
