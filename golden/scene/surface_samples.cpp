#include "golden/scene/surface_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "golden/effects/effect.h"
#include "golden/geometry/direction.h"
#include "golden/scene/camera.h"
#include "golden/scene/obj_file.h"
#include "golden/scene/placed_object.h"

namespace ptm::golden {
namespace {

/// A ray's hit as seen: with the side that the normal looks to.
struct Seen {
  const PlacedObject* object = nullptr;
  SurfacePlace place;
  SurfacePoint point;
  double t = 0;
  double side = 1;  ///< -1: the surface's back is seen
};

struct LocalLight {
  std::array<double, 2> uv{};
  bool lit = true;
};

/// A point's own axes, in the world.
struct Frame {
  Vec3 tangent, up, normal;
  [[nodiscard]] Vec3 local(const Vec3& v) const {
    return {v.dot(tangent), v.dot(up), v.dot(normal)};
  }
};

Frame frame_at(const SurfacePoint& point, double side) {
  const Vec3 facing = side * point.normal;
  // The side seen is the geometry's to say: a file's normals may look either way.
  const Vec3 n = std::copysign(1.0, point.shading.dot(facing)) * point.shading;
  const auto within = [&](const Vec3& direction) { return Vec3(direction - direction.dot(n) * n); };
  const Vec3 along = brought_near_one(point.along_u);
  Vec3 tangent = within(along);
  if (!(tangent.norm() > 1e-12 * along.norm())) tangent = n.unitOrthogonal();
  tangent.normalize();
  Vec3 up = n.cross(tangent);
  if (up.dot(point.along_v) > 0) up = -up;
  return {tangent, up, n};
}

/// Toward a light of the world, not of unit length; a lamp in the surface itself is at 0.
Vec3 toward_light(const LightSpec& light, const Vec3& position) {
  return light.kind == LightKind::point ? Vec3(light.vector - position) : light.vector;
}

LocalLight local_light(const LightSpec& light, const SurfacePoint& point, double side) {
  if (light.kind == LightKind::local) return {{light.vector.x(), light.vector.y()}, true};
  const Vec3 toward = toward_light(light, point.position);
  // A lamp in the surface itself shines from nowhere.
  if (toward.isZero(0)) return {{0, 0}, false};
  const Vec3 l = frame_at(point, side).local(unit(toward));
  return {{l.x(), l.y()}, l.z() > 0};
}

/// Between light and camera, unit vectors in the point's frame; what is too short to have a
/// direction is (0, 0).
std::array<double, 2> local_half(const LightSpec& light, const Camera& camera,
                                 const SurfacePoint& point, double side) {
  const Frame frame = frame_at(point, side);
  Vec3 l = light.vector;
  if (light.kind == LightKind::local) {
    const double across = std::hypot(l.x(), l.y());
    // Beyond the disc no direction has these parts: the one on the horizon that leans the same way.
    if (across > 1) l /= across;
    l.z() = std::sqrt(std::max(0.0, 1 - l.x() * l.x() - l.y() * l.y()));
  } else {
    l = toward_light(light, point.position);
    if (l.isZero(0)) return {0, 0};
    l = frame.local(unit(l));
  }
  const Vec3 sum = l + frame.local(camera.toward(point.position));
  constexpr double shortest = 1e-9;
  if (!(sum.norm() > shortest)) return {0, 0};
  const Vec3 h = sum.normalized();
  return {h.x(), h.y()};
}

/// What a draw's effects do at its samples.
struct SampleEffects {
  bool half = false;
  std::vector<std::pair<const Effect*, const EffectSpec*>> lights;
};
SampleEffects sample_effects(const DrawSpec& draw) {
  SampleEffects found;
  for (const EffectSpec& spec : draw.effects) {
    const Effect* effect = find_effect(spec.effect);
    if (!effect) continue;
    found.half = found.half || effect->half;
    if (effect->light) found.lights.emplace_back(effect, &spec);
  }
  return found;
}

/// Change of the hit with the tangent plane.
Vec3 moved(const Seen& seen, const Ray& ray, const Ray& change) {
  const Vec3 shift = change.origin + seen.t * change.direction;
  const Vec3& n = seen.point.normal;
  const double least = kGrazingCosine * ray.direction.norm();
  double cosine = n.dot(ray.direction);
  if (std::abs(cosine) < least) cosine = std::copysign(least, cosine);
  return shift - n.dot(shift) / cosine * ray.direction;
}

void set_derivatives(const Seen& seen, const PixelRay& ray, SurfaceSample& sample) {
  const ObjectSpec& spec = seen.object->spec();
  const double turn = seen.object->turn().value_or(kLargestDerivative);
  // A sum of parts beyond all numbers, of both signs, is steep in some direction.
  const auto limited = [](double d, double most) {
    return std::isnan(d) ? most : std::clamp(d, -most, most);
  };
  const auto du = [&](const Vec3& dp) {
    const double d = limited(seen.point.gradient_u.dot(dp), turn) * spec.uv_scale[0];
    return limited(d, kLargestDerivative);
  };
  const auto dv = [&](const Vec3& dp) {
    return limited(seen.point.gradient_v.dot(dp) * spec.uv_scale[1], kLargestDerivative);
  };
  const Vec3 right = moved(seen, ray.ray, ray.dx), down = moved(seen, ray.ray, ray.dy);
  sample.dudx = du(right);
  sample.dvdx = dv(right);
  sample.dudy = du(down);
  sample.dvdy = dv(down);
}

void set_footprint(const LoadedTexture& texture, int most_probes, SurfaceSample& sample) {
  const double dx = std::hypot(texture.width * sample.dudx, texture.height * sample.dvdx);
  const double dy = std::hypot(texture.width * sample.dudy, texture.height * sample.dvdy);
  const double major = std::max(dx, dy), minor = std::max(1.0, std::min(dx, dy));
  int probes = 1;
  sample.probes_log2 = 0;
  while (probes < most_probes && probes * minor < major) {
    probes *= 2;
    ++sample.probes_log2;
  }
  sample.lod = std::log2(std::max(major, kSmallestFootprint) / probes);
  sample.axis_u = (dx >= dy ? sample.dudx : sample.dudy) / probes;
  sample.axis_v = (dx >= dy ? sample.dvdx : sample.dvdy) / probes;
}

class Sampler {
 public:
  Sampler(const UnitScene& scene, const LoadedTextures& textures, int frame)
      : scene_(scene),
        textures_(textures),
        light_(scene.lights.at(static_cast<std::size_t>(frame))),
        frame_(frame),
        camera_(scene.camera, scene.size) {
    for (const ObjectSpec& spec : scene.objects) objects_.emplace_back(spec);
    for (const DrawSpec& draw : scene.draws) effects_.push_back(sample_effects(draw));
  }

  /// A rectangle's samples in scan lines.
  void add(int x0, int y0, int x1, int y1, std::vector<SurfaceSample>& samples) const {
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const PixelRay ray = camera_.ray(x, y);
        if (const auto seen = look(ray.ray)) samples.push_back(sample_at(x, y, ray, *seen));
      }
    }
  }

 private:
  [[nodiscard]] std::optional<Seen> look(const Ray& ray) const {
    std::optional<Seen> nearest;
    for (const PlacedObject& object : objects_) {
      const auto hit = object.intersect(ray);
      if (!hit || (nearest && nearest->t <= hit->t)) continue;
      nearest = Seen{.object = &object, .place = hit->place, .point = {}, .t = hit->t};
    }
    if (!nearest) return std::nullopt;
    nearest->point = nearest->object->at(nearest->place);
    nearest->side = nearest->point.normal.dot(ray.direction) > 0 ? -1 : 1;
    return nearest;
  }

  [[nodiscard]] SurfaceSample sample_at(int x, int y, const PixelRay& ray, const Seen& seen) const {
    const ObjectSpec& spec = seen.object->spec();
    SurfaceSample sample{.x = x, .y = y};
    sample.object = static_cast<int>(seen.object - objects_.data());
    sample.draw = spec.draw;
    sample.u = spec.uv_offset[0] + spec.uv_scale[0] * seen.point.u;
    sample.v = spec.uv_offset[1] + spec.uv_scale[1] * seen.point.v;
    set_derivatives(seen, ray, sample);
    const DrawSpec& draw = scene_.draws[static_cast<std::size_t>(spec.draw)];
    set_footprint(textures_[static_cast<std::size_t>(draw.main_texture())], draw.probes, sample);
    set_light(seen, sample);
    const SampleEffects& effects = effects_[static_cast<std::size_t>(spec.draw)];
    if (effects.half) set_half(seen, sample);
    for (const auto& [effect, keys] : effects.lights) {
      effect->light(*keys, frame_, sample.light, sample.lit);
      effect->light(*keys, frame_, sample.light_vertex, sample.lit);
    }
    return sample;
  }

  void set_half(const Seen& seen, SurfaceSample& sample) const {
    sample.half = local_half(light_, camera_, seen.point, seen.side);
    for (const WeightedCorner& corner : seen.object->corners(seen.place)) {
      const auto there = local_half(light_, camera_, seen.object->at(corner.place), seen.side);
      for (std::size_t k = 0; k < 2; ++k) sample.half_vertex[k] += corner.weight * there[k];
    }
  }

  void set_light(const Seen& seen, SurfaceSample& sample) const {
    const LocalLight here = local_light(light_, seen.point, seen.side);
    sample.light = sample.light_vertex = here.uv;
    sample.lit = here.lit;
    if (light_.kind == LightKind::local) return;
    sample.light_vertex = {0, 0};
    for (const WeightedCorner& corner : seen.object->corners(seen.place)) {
      const LocalLight there = local_light(light_, seen.object->at(corner.place), seen.side);
      for (std::size_t k = 0; k < 2; ++k) {
        sample.light_vertex[k] += corner.weight * there.uv[k];
      }
    }
  }

  const UnitScene& scene_;
  const LoadedTextures& textures_;
  const LightSpec& light_;
  int frame_;
  Camera camera_;
  std::vector<PlacedObject> objects_;
  std::vector<SampleEffects> effects_;  ///< one a draw
};

}  // namespace

std::vector<SurfaceSample> make_samples(const UnitScene& scene, const LoadedTextures& textures,
                                        int frame) {
  const Sampler sampler(scene, textures, frame);
  const bool tiled = scene.traversal == Traversal::tiles;
  const int wide = tiled ? scene.tile : scene.size[0], high = tiled ? scene.tile : 1;
  const int across = (scene.size[0] + wide - 1) / wide, down = (scene.size[1] + high - 1) / high;
  std::vector<std::vector<SurfaceSample>> parts(static_cast<std::size_t>(across) *
                                                static_cast<std::size_t>(down));
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    const int x = static_cast<int>(n % static_cast<std::size_t>(across)) * wide;
    const int y = static_cast<int>(n / static_cast<std::size_t>(across)) * high;
    sampler.add(x, y, std::min(x + wide, scene.size[0]), std::min(y + high, scene.size[1]),
                parts[n]);
  });
  std::vector<SurfaceSample> samples;
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  samples.reserve(count);
  for (const auto& part : parts) samples.insert(samples.end(), part.begin(), part.end());
  return samples;
}

std::vector<std::string> mesh_notes(const UnitScene& scene) {
  std::set<std::filesystem::path> seen;
  std::vector<std::string> notes;
  for (const ObjectSpec& object : scene.objects) {
    if (!object.mesh || !seen.insert(object.file).second) continue;
    const ObjMesh mesh = read_obj(object.file);
    notes.insert(notes.end(), mesh.notes.begin(), mesh.notes.end());
  }
  return notes;
}

std::optional<SurfaceSample> sample_pixel(const UnitScene& scene, const LoadedTextures& textures,
                                          int frame, int x, int y) {
  const Sampler sampler(scene, textures, frame);
  std::vector<SurfaceSample> samples;
  sampler.add(x, y, x + 1, y + 1, samples);
  if (samples.empty()) return std::nullopt;
  return samples.front();
}

double color_lod(const DrawSpec& draw, const LoadedTextures& textures) {
  if (draw.map < 0 || draw.color < 0) return 0;
  const LoadedTexture& map = textures[static_cast<std::size_t>(draw.map)];
  const LoadedTexture& color = textures[static_cast<std::size_t>(draw.color)];
  return std::log2(std::max(static_cast<double>(color.width) / map.width,
                            static_cast<double>(color.height) / map.height));
}

}  // namespace ptm::golden
