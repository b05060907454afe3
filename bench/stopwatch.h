// Times that stand up to others using the machine.
#pragma once

#include <time.h>

#include <algorithm>
#include <vector>

namespace rectilin::bench {

/// Processor time of this thread: the time it really ran.
inline double thread_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Wall-clock time.
inline double wall_seconds() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Of the calls of one kind. The median passes over calls into which somebody else's broke.
class Stopwatch {
 public:
  using Clock = double (*)();
  explicit Stopwatch(Clock clock) : clock_(clock) {}

  /// Runs a call and returns its time.
  template <class Call>
  double time(const Call& call) {
    const double start = clock_();
    call();
    times_.push_back(clock_() - start);
    return times_.back();
  }

  double median() const { return median_of(times_); }

  /// Of this watch's calls over the other's, turn by turn: what slows the machine for a while
  /// strikes both.
  double over(const Stopwatch& other) const {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < times_.size(); ++i) ratios.push_back(times_[i] / other.times_[i]);
    return median_of(std::move(ratios));
  }

 private:
  static double median_of(std::vector<double> numbers) {
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
  }

  Clock clock_;
  std::vector<double> times_;
};

}  // namespace rectilin::bench
