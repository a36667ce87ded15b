#include "golden/scene/image_stack.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "golden/fit/light_solver.h"

namespace ptm::golden {

LoadedTexture fit_stack(const TextureSpec& spec, const std::vector<StackPicture>& pictures) {
  LoadedTexture texture;
  texture.width = spec.size[0];
  texture.height = spec.size[1];
  texture.polynomials = 3;
  texture.coef.resize(texture.texels() * 18);
  const int count = static_cast<int>(pictures.size());
  std::vector<std::array<double, 3>> places;
  for (int n = 0; n < count; ++n) places.push_back({2.0 * n / (count - 1) - 1, 0, 0});
  const LightSolver solver = solve_lights(places);
  tbb::parallel_for(std::size_t{0}, texture.texels() * 3, [&](std::size_t i) {
    Eigen::VectorXd values(count);
    for (int n = 0; n < count; ++n) values[n] = pictures[static_cast<std::size_t>(n)][i];
    const Eigen::Matrix<double, 6, 1> a = solver.inverse * values;
    std::copy(a.begin(), a.end(), &texture.coef[i * 6]);
  });
  return texture;
}

LoadedTexture make_focus_stack(const TextureSpec& spec) {
  return fit_stack(spec, focus_pictures(spec));
}

LoadedTexture make_tide(const TextureSpec& spec) { return fit_stack(spec, tide_pictures(spec)); }

}  // namespace ptm::golden
