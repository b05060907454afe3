// A quotient rounded up.
#pragma once

#include <cstddef>

namespace rectilin {

constexpr std::size_t ceil_div(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace rectilin
