#include "rectilin/render/thumbnail.h"

#include "rectilin/render/png.h"
#include "rectilin/render/shaded.h"

namespace rectilin::render {

std::string thumbnail(const Mesh& mesh, Up up) {
  constexpr int kPixels = 280;  // twice what is shown, for print and fine screens
  constexpr double kMargin = 0.03;
  const Rotation frame = up == Up::kY ? frame_towards({0.45, 0.4, 0.8}, Vector3::UnitY())
                                      : frame_towards({0.45, -0.8, 0.4}, Vector3::UnitZ());
  return grey_png(shaded(mesh, ball_fitting(mesh, frame, kMargin), frame, kPixels), kPixels);
}

}  // namespace rectilin::render
