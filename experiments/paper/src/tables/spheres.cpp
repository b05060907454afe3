// Table 1 and Fig. 21: the 24 permutations of an octahedron's views, and the spheres that grow from it.
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include "figures/experiments.h"
#include "rectilin/base/rotation.h"
#include "rectilin/render/view_sphere.h"
#include "tables/table_1.h"

namespace rectilin::paper::figures {
namespace {

using tables::Permutation;

std::set<Permutation> of_rotations() {
  std::set<Permutation> all;
  const render::ViewSphere octahedron(0);
  for (const auto& p : octahedron.permutations()) {
    Permutation own{};
    for (std::size_t k = 0; k < 6; ++k) own[k] = static_cast<int>(p[k]);
    all.insert(own);
  }
  return all;
}

struct Table1 {
  void bind(Parameters&) {}
  ExperimentResult run(const ExperimentContext&) const {
    const std::set<Permutation> ours = of_rotations(), printed(tables::kTable1.begin(), tables::kTable1.end());
    ExperimentResult result;
    int found = 0;
    for (const Permutation& p : tables::kTable1) {
      found += ours.contains(p);
      result.data.push_back({{"permutation", p}, {"is_a_rotation", ours.contains(p)}});
    }
    result.says = std::to_string(ours.size()) + " rotations take the octahedron's views to each other; " +
                  std::to_string(found) + " of the paper's " + std::to_string(printed.size()) +
                  " permutations are among them (paper: 24)";
    return result;
  }
};

/// The sphere's edges as seen from a little above; those behind are left out.
std::string drawn(const render::ViewSphere& sphere, double x, double radius) {
  const Rotation view = rotation_from_euler(-1.2, 0, 0.4);
  std::ostringstream svg;
  svg.precision(2);
  svg << std::fixed;
  for (const Triangle& t : sphere.faces()) {
    std::array<Vector3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = view.matrix() * sphere.directions()[t[i]];
    const double facing = (p[1] - p[0]).cross(p[2] - p[0]).z();
    if (facing <= 0) continue;
    svg << "<polygon fill=\"#eef3f8\" stroke=\"#0072b2\" stroke-width=\"1\" stroke-linejoin=\"round\" points=\"";
    for (const Vector3& q : p) svg << x + radius * q.x() << ',' << 10 + radius - radius * q.y() << ' ';
    svg << "\"/>\n";
  }
  return svg.str();
}

struct Figure21 {
  int levels = 4;
  void bind(Parameters& parameters) { parameters.integer("levels", levels, 1, 5, "spheres, from the octahedron on"); }
  ExperimentResult run(const ExperimentContext&) const {
    ExperimentResult result;
    report::Csv data({"level", "views", "edges", "faces"});
    constexpr int kRadius = 90, kStep = 210;
    std::ostringstream svg;
    const int width = kStep * levels;
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << " 235\" font-family=\"sans-serif\" "
        << "font-size=\"15\" text-anchor=\"middle\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    result.says = "views";
    for (int level = 0; level < levels; ++level) {
      const render::ViewSphere sphere(level);
      const std::size_t faces = sphere.faces().size(), edges = faces * 3 / 2;
      data.row({level, sphere.size(), edges, faces});
      result.data.push_back({{"level", level}, {"views", sphere.size()}, {"edges", edges}, {"faces", faces}});
      const int middle = kStep * level + kStep / 2;
      svg << drawn(sphere, middle, kRadius) << "<text x=\"" << middle << "\" y=\"222\">" << sphere.size()
          << " views</text>\n";
      result.says += (level > 0 ? ", " : " ") + std::to_string(sphere.size());
    }
    svg << "</svg>\n";
    result.says += " (paper: 6, 18, 66, 258)";
    result.sheets.push_back(
        {"fig21", "The octahedron and the spheres made of it by halving edges.", std::move(data), svg.str(), width});
    return result;
  }
};

}  // namespace

Experiment table1() {
  return make_experiment<Table1>("table1", "Table 1: the 24 ways to match two models' views", "", "");
}
Experiment fig21() {
  return make_experiment<Figure21>("fig21", "Geodesic spheres made from an octahedron", "", "levels=2");
}

}  // namespace rectilin::paper::figures
