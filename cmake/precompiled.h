// The large headers that most sources include, compiled once. Sources still include what they use, because the project
// also builds with RECTILIN_PRECOMPILE=OFF.
#pragma once

#include <tbb/cache_aligned_allocator.h>
#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <stop_token>
#include <string>
#include <vector>
