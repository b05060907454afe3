#include "rectilin/search/overlay.h"

#include <algorithm>

#include "rectilin/render/png.h"
#include "rectilin/render/shaded.h"
#include "rectilin/retrieval/model.h"

namespace rectilin::search {

std::string overlay_picture(const Mesh& first, const Mesh& second, const Placement& placement, int size) {
  constexpr double kMargin = 0.03;
  const retrieval::Model model(first);
  const retrieval::Frame& frame = model.frame("rectilinear");
  const Mesh& below = model.posed("rectilinear");
  // From one file to the other and into the frame at once: in between, coordinates may be of any size.
  const Eigen::Matrix3d linear = frame.scale * frame.rotation.matrix() * placement.linear;
  const Vector3 shift = frame.scale * (frame.rotation.matrix() * (placement.shift - frame.centre));
  Mesh above = second;
  for (Vector3& v : above.vertices) v = linear * v + shift;

  const Rotation view = render::frame_towards({0.45, -0.8, 0.4}, Vector3::UnitZ());
  Mesh both = below;
  const auto base = static_cast<std::uint32_t>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), above.vertices.begin(), above.vertices.end());
  for (Triangle t : above.triangles) {
    for (std::uint32_t& corner : t) corner += base;
    both.triangles.push_back(t);
  }
  const render::Ball ball = render::ball_fitting(both, view, kMargin);
  const auto lower = render::shaded(below, ball, view, size), upper = render::shaded(above, ball, view, size);
  std::vector<std::uint8_t> colours;
  for (std::size_t i = 0; i < lower.size(); ++i) {
    // Ink of the first is taken from red, ink of the second from blue, what both have from green, too.
    const std::uint8_t darker = std::min(lower[i], upper[i]), lighter = std::max(lower[i], upper[i]);
    colours.push_back(lower[i]);
    colours.push_back(static_cast<std::uint8_t>((darker + lighter) / 2));
    colours.push_back(upper[i]);
  }
  return render::colour_png(colours, size);
}

}  // namespace rectilin::search
