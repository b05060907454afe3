// Integer division that rounds up: ceil_div(7, 3) is 3.
#pragma once

#include <cstddef>

namespace rectilin {

constexpr std::size_t ceil_div(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace rectilin
