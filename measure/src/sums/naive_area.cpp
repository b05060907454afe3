#include "rectilin/measure/naive_area.h"

#include <cmath>

namespace rectilin {

double naive_value(const AreaVectors& vectors, const Vector3& u) {
  const double *x = vectors.x.data(), *y = vectors.y.data(), *z = vectors.z.data();
  const double a = u.x(), b = u.y(), c = u.z();
  double sum = 0;
  for (std::size_t i = 0; i < vectors.size(); ++i) sum += std::abs(a * x[i] + b * y[i] + c * z[i]);
  return sum;
}

void NaiveArea::values(std::span<const Rotation> rotations, std::span<double> values) const {
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    values[i] = 0;
    for (int k = 0; k < 3; ++k) values[i] += naive_value(vectors_, rotations[i].axis(k));
    values[i] /= vectors_.total;
  }
}

}  // namespace rectilin
