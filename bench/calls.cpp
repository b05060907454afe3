// The calls of python_calls.py in C++: calls WHAT COUNT prints seconds of processor time a call.
#include <cstdio>
#include <cstdlib>
#include <ctime>
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
  Random random(1);
  std::vector<Rotation> rotations;
  for (int i = 0; i < 50; ++i) rotations.push_back(random_rotation(random));  // no two share a row
  std::vector<double> values(50);
  double sum = 0;  // so that nothing is left out
  const std::clock_t begin = std::clock();
  for (int i = 0; i < count; ++i) {
    if (what == "values") objective.values(rotations, values), sum += values.front();
    else sum += measure(mesh).value;
  }
  std::printf("%.9g\n", static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / count);
  return sum > 0 ? 0 : 1;
}
