// The parameters of the state, each with a change of it and with when the picture can show that: from the specification,
// independently of the snapshot's code.
#pragma once

#include <functional>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "api/snapshot/lighting_snapshot.h"
#include "api/snapshot/snapshot.h"

namespace gouraud::api {

using Random = std::mt19937;

inline pipeline::DrawState snapshot_of(const State& state, const TargetInfo& target) {
  pipeline::DrawState result;
  update_draw_state(state, target, dirty_all, result);
  result.lighting.material = canonical_material(state.lighting, result.lighting);
  return result;
}

inline int pick(Random& random, int count) {
  return static_cast<int>(random() % static_cast<unsigned>(count));
}
inline bool coin(Random& random) {
  return pick(random, 2) == 0;
}
inline float number(Random& random) {
  return 0.01f + static_cast<float>(pick(random, 1000000)) * 1e-6f;
}
inline glm::vec4 color(Random& random) {
  return {number(random), number(random), number(random), number(random)};
}

inline glm::vec4 color_or_black(Random& random) {
  return pick(random, 3) == 0 ? glm::vec4(0, 0, 0, number(random)) : color(random);
}

inline GLenum other(Random& random, GLenum now, std::initializer_list<GLenum> values) {
  for (;;) {
    const GLenum value = *(values.begin() + pick(random, static_cast<int>(values.size())));
    if (value != now) return value;
  }
}

inline bool is_black(const glm::vec4& c) {
  return c.x == 0.0f && c.y == 0.0f && c.z == 0.0f;
}

// What the picture can show.
struct View {
  const State& state;
  const TargetInfo& target;

  bool colors() const {
    const ColorBufferGroup& c = state.color_buffer;
    return writes_colors() || (c.alpha_test_enabled && c.alpha_func != GL_ALWAYS && c.alpha_func != GL_NEVER);
  }
  bool writes_rgb() const {
    const auto& mask = state.color_buffer.write_enabled;
    return target.format.color != pipeline::ColorFormat::none && (mask[0] || mask[1] || mask[2]);
  }
  bool writes_alpha() const {
    return target.format.color != pipeline::ColorFormat::none && state.color_buffer.write_enabled[3];
  }
  bool can_blend() const {
    return state.color_buffer.blend.enabled && !state.color_buffer.logic_op_enabled && writes_colors();
  }
  bool takes_factors() const {
    const Blending& b = state.color_buffer.blend;
    const auto takes = [](GLenum equation) { return equation != GL_MIN && equation != GL_MAX; };
    return can_blend() && takes(b.equation_rgb) && b.equation_alpha == b.equation_rgb;
  }
  /// Blending that would leave another color than replacing, were it on.
  bool would_blend() const {
    const Blending& b = state.color_buffer.blend;
    const bool factors = b.equation_rgb == GL_FUNC_ADD;
    return (writes_rgb() && !(factors && b.source_rgb == GL_ONE && b.destination_rgb == GL_ZERO)) ||
           (writes_alpha() && !(factors && b.source_alpha == GL_ONE && b.destination_alpha == GL_ZERO));
  }
  bool operates() const {
    return writes_colors() && target.format.color != pipeline::ColorFormat::rgba32f;
  }
  bool writes_colors() const {
    const auto& mask = state.color_buffer.write_enabled;
    return target.format.color != pipeline::ColorFormat::none && (mask[0] || mask[1] || mask[2] || mask[3]);
  }
  bool depth() const {
    return target.format.depth != pipeline::DepthFormat::none && state.depth.test_enabled &&
           (state.depth.func != GL_ALWAYS || state.depth.write_enabled);
  }
  bool fog() const { return state.fog.enabled && writes_rgb(); }
  bool lit() const { return colors() && state.lighting.enabled; }
  bool shines(const Light& light) const {
    return lit() && light.enabled && !(is_black(light.ambient) && is_black(light.diffuse) && is_black(light.specular));
  }
  bool any(glm::vec4 Light::*part) const {
    for (const Light& light : state.lighting.lights) {
      if (shines(light) && !is_black(light.*part)) return true;
    }
    return false;
  }
  bool normals() const {
    for (const Light& light : state.lighting.lights) {
      if (shines(light)) return true;
    }
    return false;
  }
  bool specular() const { return any(&Light::specular); }
  bool ambient() const { return lit() && (!is_black(state.lighting.model_ambient) || any(&Light::ambient)); }
  bool front() const { return !state.polygon.cull_enabled || state.polygon.cull_face == GL_BACK; }
  bool back() const { return !state.polygon.cull_enabled || state.polygon.cull_face == GL_FRONT; }
  bool draws(GLenum mode) const {
    return (front() && state.polygon.front_mode == mode) || (back() && state.polygon.back_mode == mode);
  }
  bool has_offset() const {
    const PolygonGroup& p = state.polygon;
    return p.offset_factor != 0.0f || p.offset_units != 0.0f || p.offset_bias != 0.0f;
  }
  bool two_sided() const { return lit() && state.lighting.model_two_side && back(); }
  bool follows(GLenum parameter, GLenum face) const {
    const LightingGroup& l = state.lighting;
    const bool both = l.color_material_parameter == GL_AMBIENT_AND_DIFFUSE;
    return l.color_material_enabled && (l.color_material_face == face || l.color_material_face == GL_FRONT_AND_BACK) &&
           (l.color_material_parameter == parameter || (both && (parameter == GL_AMBIENT || parameter == GL_DIFFUSE)));
  }
  bool face_lit(int face) const { return face == 0 ? lit() : two_sided(); }
  bool material(int face, GLenum parameter) const {
    return face_lit(face) && !follows(parameter, face == 0 ? GL_FRONT : GL_BACK);
  }
};

struct Parameter {
  std::string name;
  std::function<void(State&, Random&)> change;
  std::function<bool(const View&)> shows;
};

inline bool always(const View&) {
  return true;
}
inline bool never(const View&) {
  return false;
}

}  // namespace gouraud::api
