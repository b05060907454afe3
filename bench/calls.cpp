// The calls of python_calls.py in C++: calls WHAT COUNT prints seconds a call.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "rectilin/measure/measure.h"
#include "rectilin/mesh/source.h"

int main(int argc, char** argv) {
  using namespace rectilin;
  if (argc != 3) return 2;
  const std::string_view what = argv[1];
  const int count = std::atoi(argv[2]);
  const Mesh mesh = load_mesh(what == "large" ? "shape:blob?faces=100000" : "shape:pyramid").mesh;
  const ProjectedArea objective(area_vectors(mesh));
  const std::vector<Rotation> rotations(50);
  std::vector<double> values(50);
  double sum = 0;  // so that nothing is left out
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) {
    if (what == "values") objective.values(rotations, values), sum += values.front();
    else sum += measure(mesh).value;
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  std::printf("%.9g\n", time.count() / count);
  return sum > 0 ? 0 : 1;
}
