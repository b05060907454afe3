// The large headers that most sources include, compiled once. Sources include what they use all the same: the project
// also builds with RECTILIN_PRECOMPILE=OFF.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>
