// The keyword `threads`.
#pragma once

#include <tbb/global_control.h>

#include <memory>

#include "arrays.h"

namespace rectilin::python {

/// Keeps TBB to so many threads while it lives; to as many as there are for None.
inline std::unique_ptr<tbb::global_control> limit_threads(py::handle threads) {
  const auto count = whole_number(threads, "threads", 1);
  if (!count) return nullptr;
  return std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, *count);
}

}  // namespace rectilin::python
