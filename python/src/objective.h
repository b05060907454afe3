// What Problem and Evaluator have in common: asking for values, cuts, smooth values and turns.
#pragma once

#include <vector>

#include "arrays.h"
#include "rectilin/optim/objective.h"

namespace rectilin::python {

/// Calls `work` without the GIL if it takes long enough for others to profit: `terms` are the face vectors it goes
/// through. For less the price is higher than the gain: who gives the GIL away may wait long to have it back.
template <class Work>
void release_if_long(std::size_t terms, const Work& work) {
  constexpr std::size_t kLong = 50'000;  // about 20 us
  if (terms < kLong) {
    work();
  } else {
    const py::gil_scoped_release release;
    work();
  }
}

/// `asked` has the members of Objective and of Evaluator that are named here; `size` is the number of its directions.
template <class Asked>
py::object values(Asked& asked, std::size_t size, const Rotations& rotations) {
  std::vector<double> result(rotations.items.size());
  release_if_long(size * result.size(), [&] { asked.values(rotations.items, result); });
  return to_python(result, rotations.one);
}

/// Values, and gradients of shape (n, 3, 3).
template <class Asked>
py::tuple cuts(Asked& asked, std::size_t size, const Rotations& rotations) {
  std::vector<Cut> result(rotations.items.size());
  release_if_long(2 * size * result.size(), [&] { asked.cuts(rotations.items, result); });
  std::vector<double> value_list;
  for (const Cut& cut : result) value_list.push_back(cut.value);
  return py::make_tuple(to_python(value_list, rotations.one),
                        to_array(result.size(), rotations.one,
                                 [&](std::size_t i) -> const Eigen::Matrix3d& { return result[i].gradient; }));
}

template <class Asked>
py::tuple smooth(Asked& asked, std::size_t size, const Rotation& rotation, double width) {
  if (!(width > 0 && width < 10)) throw ParameterError("width is not a positive angle in radians");
  SmoothValue result;
  release_if_long(5 * size, [&] { result = asked.smooth(rotation, width); });
  return py::make_tuple(result.value, to_array(result.gradient));
}

inline void require_axis(int axis) {
  if (axis < 0 || axis > 2) throw ParameterError("axis is " + std::to_string(axis) + ", not 0, 1 or 2");
}

}  // namespace rectilin::python
