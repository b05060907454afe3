#pragma once

#include <cstdint>

#include "rectilin/base/rotation.h"

namespace rectilin {

/// Point i of a super-Fibonacci spiral of `count` rotations (Alexa 2022), 0 <= i < count.
Rotation super_fibonacci(std::uint64_t i, std::uint64_t count);

}  // namespace rectilin
