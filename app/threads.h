// The option --threads and what it does.
#pragma once

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <string>

namespace rectilin::app {

/// `note` ends the option's help.
inline void add_threads_option(CLI::App& command, int& threads, const std::string& note) {
  command.add_option("-t,--threads", threads, "Threads (default: all); " + note)->check(CLI::PositiveNumber);
}

/// Keeps TBB to so many threads while it lives; to all if 0.
inline tbb::global_control limit_threads(int threads) {
  constexpr auto kLimit = tbb::global_control::max_allowed_parallelism;
  return {kLimit, threads > 0 ? static_cast<std::size_t>(threads) : tbb::global_control::active_value(kLimit)};
}

}  // namespace rectilin::app
