// Compensated summation (Neumaier 1974; Ogita, Rump and Oishi 2005, algorithm Sum2).
#pragma once

#include <cmath>

namespace rectilin {

/// A running sum whose error is only that of rounding the final result, up to second order in the number of terms. It
/// is left uninitialised, so that arrays of it cost nothing until they are used.
struct TwoSum {
  double sum, error;

  void add(double term) {
    const double next = sum + term;
    const double rounded = next - sum;
    error += (sum - (next - rounded)) + (term - rounded);
    sum = next;
  }
  double value() const { return sum + error; }
};

}  // namespace rectilin
