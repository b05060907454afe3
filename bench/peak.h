// What the machine can do at best, measured.
#pragma once

#include <cstddef>
#include <string>

#include "rectilin/measure/flat_sum.h"

namespace rectilin::bench {

/// The flat kernel's instructions on registers, without loads, loops over blocks or sums of lanes,
/// for about `rounds` times sixteen vectors; returns the (face, direction) pairs. What one core
/// could do if nothing but arithmetic counted.
using RegisterLoop = double (*)(std::size_t rounds);

/// Null if there is no such loop for this instruction set (a name of instruction_sets()).
RegisterLoop register_loop(const std::string& target, Precision precision);

/// Reads three arrays of `size` doubles with the widest loads there are, requested ahead.
double read_arrays(const double* x, const double* y, const double* z, std::size_t size);

}  // namespace rectilin::bench
