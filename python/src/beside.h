// Work on a thread of its own, while the caller's thread looks after Python.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "interrupt.h"
#include "rectilin/base/batch.h"

namespace rectilin::python {

/// Calls `work` on a thread of its own and, until it has ended, `look` on this one, every 50 ms, with the GIL.
template <class Work, class Look>
void beside(const Work& work, const Look& look) {
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  std::exception_ptr error;
  std::thread thread([&] {
    try {
      work();
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard lock(mutex);
    done = true;
    ended.notify_all();
  });
  for (;;) {
    {
      const py::gil_scoped_release release;
      std::unique_lock lock(mutex);
      ended.wait_for(lock, std::chrono::milliseconds(50), [&] { return done; });
      if (done) break;
    }
    look();
  }
  thread.join();
  if (error) std::rethrow_exception(error);
}

/// `work(control)` for the loops of base/batch.h: Ctrl-C stops it, and `progress(done, total, text)`, if it is not
/// None, is called now and then. What either raises is raised when the work has ended.
template <class Work>
auto with_progress(py::object progress, const Work& work) {
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0) throw py::type_error("progress is not callable");
  Interrupt interrupt{py::none()};
  std::mutex mutex;
  std::size_t done = 0, total = 0, told = 0;
  std::string text;
  const LoopControl control{interrupt.token(), [&](std::size_t d, std::size_t t, const std::string& name) {
                              const std::lock_guard lock(mutex);
                              done = d;
                              total = t;
                              text = name;
                            }};
  std::optional<decltype(work(control))> result;
  try {
    beside([&] { result.emplace(work(control)); },
           [&] {
             interrupt.poll();
             if (progress.is_none() || interrupt.token().stop_requested()) return;
             std::size_t d = 0, t = 0;
             std::string name;
             {
               const std::lock_guard lock(mutex);
               d = done;
               t = total;
               name = text;
             }
             if (t == 0 || d == told) return;
             told = d;
             try {
               progress(d, t, name);
             } catch (py::error_already_set&) {
               interrupt.raise_later(std::current_exception());
             }
           });
  } catch (...) {  // what was raised is the reason of whatever failed after it
    interrupt.rethrow();
    throw;
  }
  interrupt.rethrow();
  return std::move(*result);
}

}  // namespace rectilin::python
