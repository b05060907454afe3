// Work on a mesh that may be hostile, in a process of its own: one that crashes, hangs or takes too much memory costs
// one request.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rectilin::serve {

struct ChildLimits {
  std::chrono::seconds time{30};      ///< on the clock
  std::uint64_t memory = 3u << 30;    ///< bytes of data
  std::uint64_t output = 512u << 20;  ///< bytes of the answer
};

/// The child failed as a whole; what() is why, without a name.
class ChildError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a command with `input` as its standard input and returns its standard output. The child ends with this program.
/// Throws ChildError, also if `stop` becomes true.
std::string run_child(const std::vector<std::string>& command, const std::string& input, const ChildLimits& limits,
                      const std::function<bool()>& stop);

/// To be called first in such a child: sets its limits for good.
void limit_this_process(const ChildLimits& limits);

}  // namespace rectilin::serve
