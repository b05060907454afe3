// Options that several commands have: checks of numbers, and --threads.
#pragma once

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace rectilin::app {

/// A check that accepts text which is a `Number` as a whole and satisfies `accepts`; for other text the message is that
/// the value `is not what`.
template <class Number, class Accepts>
CLI::Validator number_check(const std::string& what, Accepts accepts) {
  return {[what, accepts](const std::string& text) {
            Number x{};
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
            const bool whole = error == std::errc() && end == text.data() + text.size();
            return whole && accepts(x) ? std::string() : "'" + text + "' is not " + what;
          },
          ""};
}

inline CLI::Validator positive_number() {
  return number_check<double>("a positive number", [](double x) { return std::isfinite(x) && x > 0; });
}
inline CLI::Validator width_of_interval() {
  return number_check<double>("a width from 0 to 10", [](double x) { return x >= 0 && x <= 10; });
}
inline CLI::Validator count() {
  return number_check<std::uint64_t>("a whole number from 1", [](std::uint64_t x) { return x > 0; });
}
inline CLI::Validator seed() {
  return number_check<std::uint64_t>("a whole number from 0", [](std::uint64_t) { return true; });
}

/// Adds the option --threads; its help ends with `note`.
inline void add_threads_option(CLI::App& command, int& threads, const std::string& note) {
  command.add_option("-t,--threads", threads, "Threads (default: all); " + note)
      ->check(number_check<int>("a number of threads from 1 to 4096", [](int n) { return 1 <= n && n <= 4096; }));
}

/// Limits TBB to that many threads as long as it lives; 0 means no limit.
inline tbb::global_control limit_threads(int threads) {
  constexpr auto kLimit = tbb::global_control::max_allowed_parallelism;
  return {kLimit, threads > 0 ? static_cast<std::size_t>(threads) : tbb::global_control::active_value(kLimit)};
}

}  // namespace rectilin::app
