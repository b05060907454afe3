// What the machine can do at best, measured.
#pragma once

#include <cstddef>
#include <string>

#include "rectilin/measure/flat_sum.h"

namespace rectilin::bench {

/// (Face, direction) pairs that one core can add in a second if nothing but arithmetic counts: the
/// flat kernel's instructions on registers, without loads, loops over blocks or sums of lanes. Zero
/// if there is no such loop for this instruction set (a name of flat_sum_targets()).
double peak_pairs(const std::string& target, Precision precision);

/// Runs that loop once over about `rounds` times eight vectors; returns the pairs.
using RegisterLoop = double (*)(std::size_t rounds);
RegisterLoop register_loop(const std::string& target, Precision precision);

/// Reads three arrays of `size` doubles with the widest loads there are.
double read_arrays(const double* x, const double* y, const double* z, std::size_t size);

}  // namespace rectilin::bench
