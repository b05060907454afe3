#include "rectilin/base/batch.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <mutex>

namespace rectilin {

std::string error_about(const std::string& name, const std::string& what) {
  if (what.empty()) return name + ": failed, and gave no reason";
  return what.starts_with(name) ? what : name + ": " + what;
}

std::size_t run_in_order(std::span<const std::string> names,
                         const std::function<std::shared_ptr<void>(std::size_t)>& work,
                         const std::function<void(std::size_t, void*)>& deliver, const LoopControl& control) {
  const std::size_t at_once = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  std::mutex mutex;
  std::size_t next = 0, done = 0;
  const auto report = [&](std::size_t finished, std::size_t i) {
    const std::lock_guard lock(mutex);
    done += finished;
    if (control.on_progress) control.on_progress(done, names.size(), names[i]);
  };
  using Item = std::pair<std::size_t, std::shared_ptr<void>>;
  const auto take = [&](tbb::flow_control& flow) {
    if (next < names.size() && !control.stop.stop_requested()) return next++;
    flow.stop();
    return next;
  };
  const auto run = [&](std::size_t i) {
    report(0, i);
    Item item(i, nullptr);
    tbb::this_task_arena::isolate([&] { item.second = work(i); });
    return item;
  };
  const auto hand_over = [&](const Item& item) {
    deliver(item.first, item.second.get());
    report(1, item.first);
  };
  tbb::parallel_pipeline(at_once, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
                                      tbb::make_filter<std::size_t, Item>(tbb::filter_mode::parallel, run) &
                                      tbb::make_filter<Item, void>(tbb::filter_mode::serial_in_order, hand_over));
  return done;
}

}  // namespace rectilin
