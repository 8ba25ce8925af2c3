// The canonical snapshot as a property: for random states and targets, changing a parameter that the picture cannot
// show leaves the DrawState equal, changing one that it can show makes it differ. `shows` says when, from the
// specification, independently of the snapshot's code.
#include "api/snapshot/snapshot.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "api/snapshot/lighting_snapshot.h"

namespace gouraud::api {
namespace {

using Random = std::mt19937;

pipeline::DrawState snapshot_of(const State& state, const TargetInfo& target) {
  pipeline::DrawState result;
  update_draw_state(state, target, dirty_all, result);
  result.lighting.material = canonical_material(state.lighting, result.lighting);
  return result;
}

int pick(Random& random, int count) {
  return static_cast<int>(random() % static_cast<unsigned>(count));
}
bool coin(Random& random) {
  return pick(random, 2) == 0;
}
float number(Random& random) {
  return 0.01f + static_cast<float>(pick(random, 1000000)) * 1e-6f;
}
glm::vec4 color(Random& random) {
  return {number(random), number(random), number(random), number(random)};
}

glm::vec4 color_or_black(Random& random) {
  return pick(random, 3) == 0 ? glm::vec4(0, 0, 0, number(random)) : color(random);
}

GLenum other(Random& random, GLenum now, std::initializer_list<GLenum> values) {
  for (;;) {
    const GLenum value = *(values.begin() + pick(random, static_cast<int>(values.size())));
    if (value != now) return value;
  }
}

bool is_black(const glm::vec4& c) {
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
  bool has_offset() const { return state.polygon.offset_factor != 0.0f || state.polygon.offset_units != 0.0f; }
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

bool always(const View&) {
  return true;
}
bool never(const View&) {
  return false;
}

void add_transform(std::vector<Parameter>& list) {
  list.push_back({"modelview", [](State& s, Random& r) { s.matrices.modelview.top()[1][2] += number(r); }, always});
  list.push_back({"projection", [](State& s, Random& r) { s.matrices.projection.top()[0][1] += number(r); }, always});
  list.push_back({"texture matrix", [](State& s, Random& r) { s.matrices.texture[0].top()[0][1] = number(r); }, never});
  list.push_back({"matrix mode", [](State& s, Random&) { s.transform.matrix_mode = GL_TEXTURE; }, never});
  list.push_back({"active texture", [](State& s, Random&) { s.texture.active_unit ^= 1; }, never});
  list.push_back({"normalize", [](State& s, Random&) { s.transform.normalize_enabled ^= true; },
                  [](const View& v) { return v.normals(); }});
  list.push_back({"rescale", [](State& s, Random&) { s.transform.rescale_normal_enabled ^= true; },
                  [](const View& v) { return v.normals() && !v.state.transform.normalize_enabled; }});
  list.push_back({"viewport x", [](State& s, Random&) { s.viewport.x += 1; }, always});
  list.push_back({"viewport height", [](State& s, Random&) { s.viewport.height_px += 1; }, always});
  list.push_back({"depth near", [](State& s, Random&) { s.viewport.depth_near = 1.0 - s.viewport.depth_near; },
                  [](const View& v) { return v.depth(); }});
  list.push_back(
      {"depth far", [](State& s, Random&) { s.viewport.depth_far *= 0.5; }, [](const View& v) { return v.depth(); }});
}

void add_light(std::vector<Parameter>& list, std::size_t i) {
  const std::string name = "light " + std::to_string(i) + " ";
  const auto light = [i](const View& v) -> const Light& { return v.state.lighting.lights[i]; };
  const auto shines = [light](const View& v) { return v.shines(light(v)); };
  const auto on = [light](const View& v) { return v.lit() && light(v).enabled; };
  const auto add = [&](const char* part, std::function<void(Light&, Random&)> change,
                       std::function<bool(const View&)> shows) {
    list.push_back({name + part, [i, change](State& s, Random& r) { change(s.lighting.lights[i], r); }, shows});
  };
  add(
      "enabled", [](Light& l, Random&) { l.enabled ^= true; },
      [light](const View& v) {
        const Light& l = light(v);
        return v.lit() && !(is_black(l.ambient) && is_black(l.diffuse) && is_black(l.specular));
      });
  add(
      "ambient", [](Light& l, Random& r) { l.ambient = color(r); }, on);
  add(
      "diffuse", [](Light& l, Random& r) { l.diffuse = color(r); }, on);
  add(
      "specular", [](Light& l, Random& r) { l.specular = color(r); }, on);
  add(
      "alpha", [](Light& l, Random& r) { l.ambient.w = l.diffuse.w = l.specular.w = number(r); }, never);
  add(
      "position", [](Light& l, Random& r) { l.position_eye.x += number(r); }, shines);
  const auto spot = [light](const View& v) { return v.shines(light(v)) && light(v).spot_cutoff_deg != 180.0f; };
  add(
      "spot direction", [](Light& l, Random& r) { l.spot_direction_eye.y += number(r); }, spot);
  add(
      "spot exponent", [](Light& l, Random& r) { l.spot_exponent += number(r); }, spot);
  add(
      "spot cutoff", [](Light& l, Random& r) { l.spot_cutoff_deg = 80.0f * number(r); }, shines);
  const auto near = [light](const View& v) { return v.shines(light(v)) && light(v).position_eye.w != 0.0f; };
  add(
      "constant attenuation", [](Light& l, Random& r) { l.constant_attenuation += number(r); }, near);
  add(
      "linear attenuation", [](Light& l, Random& r) { l.linear_attenuation += number(r); }, near);
  add(
      "quadratic attenuation", [](Light& l, Random& r) { l.quadratic_attenuation += number(r); }, near);
}

void add_material(std::vector<Parameter>& list, int face) {
  const std::string name = face == 0 ? "front " : "back ";
  const auto add = [&](const char* part, std::function<void(MaterialFace&, Random&)> change,
                       std::function<bool(const View&)> shows) {
    list.push_back(
        {name + part,
         [face, change](State& s, Random& r) { change(s.lighting.material[static_cast<std::size_t>(face)], r); },
         shows});
  };
  add(
      "ambient", [](MaterialFace& m, Random& r) { m.ambient = color(r); },
      [face](const View& v) { return v.material(face, GL_AMBIENT) && v.ambient(); });
  add(
      "diffuse", [](MaterialFace& m, Random& r) { m.diffuse = color(r); },
      [face](const View& v) { return v.material(face, GL_DIFFUSE); });
  add(
      "diffuse alpha", [](MaterialFace& m, Random& r) { m.diffuse.w += number(r); },
      [face](const View& v) { return v.material(face, GL_DIFFUSE); });
  add(
      "specular", [](MaterialFace& m, Random& r) { m.specular = color(r); },
      [face](const View& v) { return v.material(face, GL_SPECULAR) && v.specular(); });
  add(
      "emission", [](MaterialFace& m, Random& r) { m.emission = color(r); },
      [face](const View& v) { return v.material(face, GL_EMISSION); });
  add(
      "other alphas", [](MaterialFace& m, Random& r) { m.ambient.w = m.specular.w = m.emission.w = number(r); }, never);
  add(
      "shininess", [](MaterialFace& m, Random& r) { m.shininess += number(r); },
      [face](const View& v) { return v.face_lit(face) && v.specular(); });
  add(
      "colour indexes", [](MaterialFace& m, Random& r) { m.color_indexes.x = number(r); }, never);
}

void add_lighting(std::vector<Parameter>& list) {
  list.push_back(
      {"lighting", [](State& s, Random&) { s.lighting.enabled ^= true; }, [](const View& v) { return v.colors(); }});
  list.push_back(
      {"shade model",
       [](State& s, Random&) { s.lighting.shade_model = s.lighting.shade_model == GL_FLAT ? GL_SMOOTH : GL_FLAT; },
       [](const View& v) { return v.colors(); }});
  list.push_back({"model ambient", [](State& s, Random& r) { s.lighting.model_ambient = color(r); },
                  [](const View& v) { return v.lit(); }});
  list.push_back({"model ambient alpha", [](State& s, Random& r) { s.lighting.model_ambient.w += number(r); }, never});
  list.push_back({"local viewer", [](State& s, Random&) { s.lighting.model_local_viewer ^= true; },
                  [](const View& v) { return v.specular(); }});
  list.push_back({"two side", [](State& s, Random&) { s.lighting.model_two_side ^= true; },
                  [](const View& v) { return v.lit() && v.back(); }});
  list.push_back({"color control",
                  [](State& s, Random& r) {
                    s.lighting.model_color_control =
                        other(r, s.lighting.model_color_control, {GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR});
                  },
                  [](const View& v) { return v.specular(); }});
  list.push_back({"color material", [](State& s, Random&) { s.lighting.color_material_enabled ^= true; },
                  [](const View& v) {
                    State enabled = v.state;
                    enabled.lighting.color_material_enabled = true;
                    const View w{enabled, v.target};
                    bool shown = false;
                    for (int face = 0; face < 2; ++face) {
                      const GLenum name = face == 0 ? GL_FRONT : GL_BACK;
                      shown |= w.face_lit(face) && (w.follows(GL_DIFFUSE, name) || w.follows(GL_EMISSION, name) ||
                                                    (w.follows(GL_AMBIENT, name) && w.ambient()) ||
                                                    (w.follows(GL_SPECULAR, name) && w.specular()));
                    }
                    return shown;
                  }});
  for (std::size_t i = 0; i < 3; ++i) add_light(list, i);
  for (int face = 0; face < 2; ++face) add_material(list, face);
}

void add_rasterization(std::vector<Parameter>& list) {
  list.push_back({"front face",
                  [](State& s, Random& r) {
                    s.polygon.front_face = other(r, s.polygon.front_face, {GL_CW, GL_CCW});
                  },
                  [](const View& v) {
                    const PolygonGroup& p = v.state.polygon;
                    return v.front() != v.back() || (v.front() && p.front_mode != p.back_mode) ||
                           (v.front() && v.two_sided()) ||
                           (v.front() && v.back() && v.state.stencil.test_enabled && v.target.stencil_mask != 0);
                  }});
  list.push_back({"cull face",
                  [](State& s, Random& r) {
                    s.polygon.cull_face = other(r, s.polygon.cull_face, {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
                  },
                  [](const View& v) { return v.state.polygon.cull_enabled; }});
  list.push_back({"cull", [](State& s, Random&) { s.polygon.cull_enabled ^= true; }, always});
  list.push_back({"front mode",
                  [](State& s, Random& r) {
                    s.polygon.front_mode = other(r, s.polygon.front_mode, {GL_POINT, GL_LINE, GL_FILL});
                  },
                  [](const View& v) { return v.front(); }});
  list.push_back({"back mode",
                  [](State& s, Random& r) {
                    s.polygon.back_mode = other(r, s.polygon.back_mode, {GL_POINT, GL_LINE, GL_FILL});
                  },
                  [](const View& v) { return v.back(); }});
}

void add_points_and_lines(std::vector<Parameter>& list) {
  const auto another = [](float size) { return size < 20.0f ? size + 2.0f : 2.0f; };
  list.push_back({"point size", [=](State& s, Random&) { s.point.size_px = another(s.point.size_px); }, always});
  list.push_back({"point smooth", [](State& s, Random&) { s.point.smooth_enabled ^= true; },
                  [](const View& v) { return !v.state.point.sprite_enabled; }});
  list.push_back({"point sprite", [](State& s, Random&) { s.point.sprite_enabled ^= true; }, always});
  list.push_back({"point attenuation",
                  [](State& s, Random& r) { s.point.distance_attenuation = glm::vec3(2.0f, number(r), number(r)); }, always});
  list.push_back({"point fade threshold", [](State& s, Random&) { s.point.fade_threshold_px += 1.0f; },
                  [](const View&) { return false; }});
  list.push_back({"line width", [=](State& s, Random&) { s.line.width_px = another(s.line.width_px); }, always});
  list.push_back({"line smooth", [](State& s, Random&) { s.line.smooth_enabled ^= true; }, always});
  list.push_back({"line stipple", [](State& s, Random&) { s.line.stipple_enabled ^= true; },
                  [](const View& v) { return v.state.line.stipple_pattern != 0xFFFF; }});
  list.push_back({"line stipple pattern",
                  [](State& s, Random& r) {
                    s.line.stipple_pattern = s.line.stipple_pattern != 0xFFFF ? 0xFFFF : static_cast<GLushort>(pick(r, 0xFFFF));
                  },
                  [](const View& v) { return v.state.line.stipple_enabled; }});
  list.push_back({"line stipple factor", [](State& s, Random& r) { s.line.stipple_factor += 1 + pick(r, 8); },
                  [](const View& v) {
                    const LineGroup& line = v.state.line;
                    return line.stipple_enabled && line.stipple_pattern != 0xFFFF && line.stipple_pattern != 0;
                  }});
}

void add_polygons(std::vector<Parameter>& list) {
  list.push_back({"polygon smooth", [](State& s, Random&) { s.polygon.smooth_enabled ^= true; },
                  [](const View& v) { return v.draws(GL_FILL); }});
  list.push_back({"polygon stipple", [](State& s, Random&) { s.polygon.stipple_enabled ^= true; },
                  [](const View& v) { return v.state.polygon_stipple != PolygonStippleGroup{}; }});
  list.push_back({"polygon stipple pattern", [](State& s, Random& r) { s.polygon_stipple.rows[7] ^= 1u + static_cast<std::uint32_t>(pick(r, 1000)); },
                  [](const View& v) { return v.state.polygon.stipple_enabled; }});
  list.push_back({"polygon offset fill", [](State& s, Random&) { s.polygon.offset_fill_enabled ^= true; },
                  [](const View& v) { return v.depth() && v.has_offset() && v.draws(GL_FILL); }});
  list.push_back({"polygon offset line", [](State& s, Random&) { s.polygon.offset_line_enabled ^= true; },
                  [](const View& v) { return v.depth() && v.has_offset() && v.draws(GL_LINE); }});
  list.push_back({"polygon offset point", [](State& s, Random&) { s.polygon.offset_point_enabled ^= true; },
                  [](const View& v) { return v.depth() && v.has_offset() && v.draws(GL_POINT); }});
  const auto is_offset = [](const View& v) {
    const PolygonGroup& p = v.state.polygon;
    return v.depth() && ((p.offset_fill_enabled && v.draws(GL_FILL)) || (p.offset_line_enabled && v.draws(GL_LINE)) ||
                         (p.offset_point_enabled && v.draws(GL_POINT)));
  };
  list.push_back({"polygon offset factor", [](State& s, Random& r) { s.polygon.offset_factor += number(r); }, is_offset});
  list.push_back({"polygon offset units", [](State& s, Random& r) { s.polygon.offset_units += number(r); }, is_offset});
}

void add_framebuffer(std::vector<Parameter>& list) {
  list.push_back({"scissor box", [](State& s, Random&) { s.scissor.x += 1; },
                  [](const View& v) { return v.state.scissor.enabled; }});
  list.push_back({"scissor test", [](State& s, Random&) { s.scissor.enabled ^= true; }, always});
  list.push_back({"depth test", [](State& s, Random&) { s.depth.test_enabled ^= true; },
                  [](const View& v) {
                    return v.target.format.depth != pipeline::DepthFormat::none &&
                           (v.state.depth.func != GL_ALWAYS || v.state.depth.write_enabled);
                  }});
  list.push_back({"depth func",
                  [](State& s, Random& r) {
                    s.depth.func = other(r, s.depth.func, {GL_NEVER, GL_LESS, GL_ALWAYS});
                  },
                  [](const View& v) {
                    return v.target.format.depth != pipeline::DepthFormat::none && v.state.depth.test_enabled;
                  }});
  list.push_back({"depth mask", [](State& s, Random&) { s.depth.write_enabled ^= true; },
                  [](const View& v) {
                    return v.target.format.depth != pipeline::DepthFormat::none && v.state.depth.test_enabled &&
                           v.state.depth.func != GL_NEVER;
                  }});
  list.push_back({"color mask", [](State& s, Random&) { s.color_buffer.write_enabled[2] ^= true; },
                  [](const View& v) { return v.target.format.color != pipeline::ColorFormat::none; }});
}

void add_fog(std::vector<Parameter>& list) {
  const auto fog = [](const View& v) { return v.fog(); };
  const auto linear = [](const View& v) { return v.fog() && v.state.fog.mode == GL_LINEAR; };
  list.push_back({"fog", [](State& s, Random&) { s.fog.enabled ^= true; }, [](const View& v) { return v.writes_rgb(); }});
  list.push_back({"fog mode", [](State& s, Random& r) { s.fog.mode = other(r, s.fog.mode, {GL_LINEAR, GL_EXP, GL_EXP2}); }, fog});
  list.push_back({"fog density", [](State& s, Random& r) { s.fog.density += number(r); },
                  [](const View& v) { return v.fog() && v.state.fog.mode != GL_LINEAR; }});
  list.push_back({"fog start", [](State& s, Random& r) { s.fog.start += number(r); }, linear});
  list.push_back({"fog end", [](State& s, Random& r) { s.fog.end += number(r); }, linear});
  list.push_back({"fog color", [](State& s, Random& r) { s.fog.color.y += number(r); }, fog});
  list.push_back({"fog alpha", [](State& s, Random& r) { s.fog.color.w += number(r); }, never});
  list.push_back({"fog index", [](State& s, Random& r) { s.fog.index += number(r); }, never});
  list.push_back({"fog coordinates",
                  [](State& s, Random& r) {
                    s.fog.coordinate_source = other(r, s.fog.coordinate_source, {GL_FOG_COORD, GL_FRAGMENT_DEPTH});
                  },
                  fog});
  list.push_back({"color sum", [](State& s, Random&) { s.fog.color_sum_enabled ^= true; },
                  [](const View& v) { return !v.state.lighting.enabled && v.writes_rgb(); }});
}

void add_clip_planes(std::vector<Parameter>& list) {
  list.push_back({"clip plane", [](State& s, Random&) { s.transform.clip_planes[6].enabled ^= true; }, always});
  list.push_back({"clip plane equation", [](State& s, Random& r) { s.transform.clip_planes[6].plane_eye.z += number(r); },
                  [](const View& v) { return v.state.transform.clip_planes[6].enabled; }});
}

void add_alpha_test(std::vector<Parameter>& list) {
  list.push_back({"alpha test", [](State& s, Random&) { s.color_buffer.alpha_test_enabled ^= true; },
                  [](const View& v) { return v.state.color_buffer.alpha_func != GL_ALWAYS; }});
  list.push_back({"alpha func",
                  [](State& s, Random& r) {
                    s.color_buffer.alpha_func = other(r, s.color_buffer.alpha_func, {GL_NEVER, GL_LESS, GL_ALWAYS});
                  },
                  [](const View& v) { return v.state.color_buffer.alpha_test_enabled; }});
  list.push_back({"alpha reference", [](State& s, Random& r) { s.color_buffer.alpha_reference = number(r); },
                  [](const View& v) {
                    return v.state.color_buffer.alpha_test_enabled && v.state.color_buffer.alpha_func == GL_LESS;
                  }});
}

void add_blending(std::vector<Parameter>& list) {
  const auto factor = [&list](const char* name, GLenum Blending::*which, bool (View::*written)() const) {
    list.push_back({name,
                    [which](State& s, Random& r) {
                      GLenum& now = s.color_buffer.blend.*which;
                      now = other(r, now, {GL_ONE, GL_ZERO, GL_SRC_ALPHA, GL_DST_ALPHA, GL_CONSTANT_ALPHA});
                    },
                    [written](const View& v) { return v.takes_factors() && (v.*written)(); }});
  };
  factor("source rgb", &Blending::source_rgb, &View::writes_rgb);
  factor("destination rgb", &Blending::destination_rgb, &View::writes_rgb);
  factor("source alpha", &Blending::source_alpha, &View::writes_alpha);
  factor("destination alpha", &Blending::destination_alpha, &View::writes_alpha);
  list.push_back({"blend equation",
                  [](State& s, Random& r) {
                    Blending& b = s.color_buffer.blend;
                    b.equation_rgb = b.equation_alpha = other(r, b.equation_rgb, {GL_FUNC_ADD, GL_MIN, GL_MAX});
                  },
                  [](const View& v) { return v.can_blend(); }});
  list.push_back({"blend color", [](State& s, Random& r) { s.color_buffer.blend.constant = color(r); },
                  [](const View& v) {
                    const Blending& b = v.state.color_buffer.blend;
                    const auto constant = [](GLenum s, GLenum d) {
                      return s == GL_CONSTANT_ALPHA || d == GL_CONSTANT_ALPHA;
                    };
                    return v.takes_factors() && ((v.writes_rgb() && constant(b.source_rgb, b.destination_rgb)) ||
                                                 (v.writes_alpha() && constant(b.source_alpha, b.destination_alpha)));
                  }});
  list.push_back({"blend", [](State& s, Random&) { s.color_buffer.blend.enabled ^= true; },
                  [](const View& v) { return !v.state.color_buffer.logic_op_enabled && v.would_blend(); }});
}

void add_logic_op(std::vector<Parameter>& list) {
  list.push_back({"logic op", [](State& s, Random&) { s.color_buffer.logic_op_enabled ^= true; },
                  [](const View& v) {
                    const bool blends = v.state.color_buffer.blend.enabled && v.would_blend();
                    return blends || (v.operates() && v.state.color_buffer.logic_op != GL_COPY);
                  }});
  list.push_back({"logic op mode",
                  [](State& s, Random& r) {
                    s.color_buffer.logic_op = other(r, s.color_buffer.logic_op, {GL_COPY, GL_XOR, GL_NOOP});
                  },
                  [](const View& v) { return v.state.color_buffer.logic_op_enabled && v.operates(); }});
  list.push_back(
      {"index logic op", [](State& s, Random&) { s.color_buffer.index_logic_op_enabled ^= true; }, never});
}

// Every side compares and writes (random_state), so its parameters show where it is tested at all.
void add_stencil(std::vector<Parameter>& list) {
  const auto exists = [](const View& v) { return v.target.stencil_mask != 0 && v.state.stencil.test_enabled; };
  const auto add = [&](const std::string& side, StencilSide StencilGroup::*which, const std::function<bool(const View&)>& used) {
    list.push_back({side + " func", [which](State& s, Random& r) {
                      GLenum& now = (s.stencil.*which).func;
                      now = other(r, now, {GL_EQUAL, GL_LESS, GL_GREATER});
                    }, used});
    list.push_back({side + " reference", [which](State& s, Random&) { (s.stencil.*which).reference ^= 1; }, used});
    list.push_back({side + " compare mask", [which](State& s, Random&) { (s.stencil.*which).compare_mask ^= 8; }, used});
    list.push_back({side + " write mask", [which](State& s, Random&) { (s.stencil.*which).write_mask ^= 8; }, used});
    list.push_back({side + " masks beyond the buffer", [which](State& s, Random&) {
                      (s.stencil.*which).compare_mask ^= 0x100;
                      (s.stencil.*which).write_mask ^= 0x100;
                    }, never});
    list.push_back({side + " fail", [which](State& s, Random& r) {
                      GLenum& now = (s.stencil.*which).fail;
                      now = other(r, now, {GL_INVERT, GL_INCR, GL_REPLACE});
                    }, used});
  };
  add("front stencil", &StencilGroup::front, exists);
  add("back stencil", &StencilGroup::separate_back,
      [exists](const View& v) { return exists(v) && v.back() && !v.state.stencil.two_side_enabled; });
  add("two-side stencil", &StencilGroup::two_side_back,
      [exists](const View& v) { return exists(v) && v.back() && v.state.stencil.two_side_enabled; });
  list.push_back({"stencil depth fail", [](State& s, Random& r) {
                    s.stencil.front.depth_fail = other(r, s.stencil.front.depth_fail, {GL_KEEP, GL_ZERO, GL_INCR_WRAP});
                  },
                  [exists](const View& v) { return exists(v) && v.depth() && v.state.depth.func != GL_ALWAYS; }});
  list.push_back({"stencil depth pass", [](State& s, Random& r) {
                    s.stencil.front.depth_pass = other(r, s.stencil.front.depth_pass, {GL_KEEP, GL_ZERO, GL_DECR});
                  },
                  [exists](const View& v) { return exists(v) && !(v.depth() && v.state.depth.func == GL_NEVER); }});
  list.push_back({"two-side stencil", [](State& s, Random&) { s.stencil.two_side_enabled ^= true; },
                  [exists](const View& v) { return exists(v) && v.back(); }});
  list.push_back({"occlusion query", [](State& s, Random&) { s.current_query ^= 1; }, always});
  list.push_back({"stencil test", [](State& s, Random&) { s.stencil.test_enabled ^= true; },
                  [](const View& v) { return v.target.stencil_mask != 0; }});
}

void add_what_no_draw_reads(std::vector<Parameter>& list) {
  list.push_back({"current color", [](State& s, Random& r) { s.current.color = color(r); }, never});
  list.push_back({"current normal", [](State& s, Random& r) { s.current.normal_object.x = number(r); }, never});
  list.push_back({"clear color", [](State& s, Random& r) { s.color_buffer.clear_color = color(r); }, never});
  list.push_back({"clear depth", [](State& s, Random& r) { s.depth.clear_value = number(r); }, never});
  list.push_back({"clear stencil", [](State& s, Random&) { s.stencil.clear_value = 4; }, never});
  list.push_back({"clear accum", [](State& s, Random& r) { s.accum.clear_value = color(r); }, never});
  list.push_back({"active stencil face", [](State& s, Random&) { s.stencil.active_face = GL_BACK; }, never});
  list.push_back({"dither", [](State& s, Random&) { s.color_buffer.dither_enabled ^= true; }, never});
  list.push_back({"multisample", [](State& s, Random&) { s.multisample.coverage_enabled ^= true; }, never});
  list.push_back({"hint", [](State& s, Random&) { s.hint.fog = GL_NICEST; }, never});
  list.push_back({"pack", [](State& s, Random&) { s.pack.alignment = 1; }, never});
}

/// Of a target with four samples, or without.
bool changes(int samples, void (*change)(State&)) {
  State state;
  TargetInfo target;
  target.width_px = target.height_px = 8;
  target.format = {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::none};
  target.samples = samples;
  const pipeline::DrawState before = snapshot_of(state, target);
  change(state);
  return snapshot_of(state, target) != before;
}

TEST(Multisample, ItsStateIsThatOfTargetsWithSamples) {
  const auto expect = [](void (*change)(State&), bool of_many, bool of_one) {
    EXPECT_EQ(changes(4, change), of_many);
    EXPECT_EQ(changes(0, change), of_one);
  };
  expect([](State& s) { s.multisample.alpha_to_coverage_enabled = true; }, true, false);
  expect([](State& s) { s.multisample.alpha_to_one_enabled = true; }, true, false);
  expect([](State& s) { s.multisample.enabled = false; }, true, false);
  expect([](State& s) { s.multisample.coverage_enabled = true, s.multisample.coverage_value = 0.5f; }, true, false);
  expect([](State& s) { s.point.fade_threshold_px = 3.0f; }, true, false);
  expect([](State& s) { s.point.fade_threshold_px = 0.5f; }, false, false);
  expect([](State& s) { s.point.smooth_enabled = true; }, false, true);
  expect([](State& s) { s.line.smooth_enabled = true; }, false, true);
  expect([](State& s) { s.polygon.smooth_enabled = true; }, false, true);
  expect([](State& s) { s.line.width_px = 1.25f; }, true, false);
}

std::vector<Parameter> all_parameters() {
  std::vector<Parameter> list;
  add_transform(list);
  add_lighting(list);
  add_rasterization(list);
  add_points_and_lines(list);
  add_polygons(list);
  add_framebuffer(list);
  add_fog(list);
  add_clip_planes(list);
  add_alpha_test(list);
  add_blending(list);
  add_logic_op(list);
  add_stencil(list);
  add_what_no_draw_reads(list);
  return list;
}

State random_state(Random& r, const std::vector<Parameter>& parameters) {
  State s;
  s.viewport = {3, 4, 50, 40, 0.125, 0.75};
  s.scissor = {coin(r), 5 + pick(r, 9), 6, 20, 21};
  s.lighting.enabled = pick(r, 4) != 0;
  s.depth.test_enabled = coin(r);
  s.stencil.front = {GL_EQUAL, 4, 0xFF, GL_INVERT, GL_KEEP, GL_KEEP, 0xFF};
  s.stencil.separate_back = {GL_EQUAL, 8, 0xFF, GL_INVERT, GL_KEEP, GL_KEEP, 0xFF};
  s.stencil.two_side_back = {GL_EQUAL, 16, 0xFF, GL_INVERT, GL_KEEP, GL_KEEP, 0xFF};
  for (Light& light : s.lighting.lights) {
    light.enabled = coin(r);
    light.ambient = color_or_black(r);
    light.diffuse = color_or_black(r);
    light.specular = color_or_black(r);
    light.position_eye = {number(r), number(r), number(r), coin(r) ? 0.0f : number(r)};
    if (coin(r)) light.spot_cutoff_deg = 90.0f * number(r);
  }
  if (coin(r)) s.lighting.model_ambient = glm::vec4(0);
  s.lighting.color_material_face = other(r, 0, {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
  s.lighting.color_material_parameter = other(r, 0, {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION});
  if (coin(r)) s.lighting.color_material_parameter = GL_AMBIENT_AND_DIFFUSE;
  if (pick(r, 4) == 0) s.color_buffer.write_enabled = {false, false, coin(r), false};
  for (const Parameter& parameter : parameters) {
    if (coin(r)) parameter.change(s, r);
  }
  return s;
}

TargetInfo random_target(Random& r) {
  constexpr pipeline::ColorFormat colors[] = {pipeline::ColorFormat::none, pipeline::ColorFormat::rgba8,
                                              pipeline::ColorFormat::rgba8, pipeline::ColorFormat::rgba32f};
  constexpr pipeline::DepthFormat depths[] = {pipeline::DepthFormat::none, pipeline::DepthFormat::z16,
                                              pipeline::DepthFormat::z24s8, pipeline::DepthFormat::z24s8};
  return {100, 80, {colors[pick(r, 4)], depths[pick(r, 4)]}, coin(r) ? 255u : 0u};
}

TEST(Snapshot, DiffersExactlyWhereThePictureCanShowTheParameter) {
  const std::vector<Parameter> parameters = all_parameters();
  Random random(7);
  std::vector<int> shown(parameters.size()), hidden(parameters.size());
  for (int round = 0; round < 3000; ++round) {
    const State state = random_state(random, parameters);
    const TargetInfo target = random_target(random);
    const pipeline::DrawState before = snapshot_of(state, target);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      State changed = state;
      parameters[i].change(changed, random);
      const bool shows = parameters[i].shows({state, target});
      ASSERT_EQ(snapshot_of(changed, target) != before, shows) << parameters[i].name << ", round " << round;
      ++(shows ? shown : hidden)[i];
    }
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) EXPECT_GT(shown[i] + hidden[i], 0) << parameters[i].name;
}

TEST(Snapshot, InSelectionHoldsWhatFindsPrimitivesAndNothingElse) {
  const std::vector<Parameter> parameters = all_parameters();
  Random random(9);
  for (int round = 0; round < 500; ++round) {
    State state = random_state(random, parameters);
    state.render_mode.mode = GL_SELECT;
    const TargetInfo target = random_target(random);
    const pipeline::DrawState before = snapshot_of(state, target);
    EXPECT_TRUE(before.report.enabled);
    EXPECT_FALSE(before.report.colors);
    EXPECT_EQ(before.raster.color_write_mask, 0);
    State changed = state;
    changed.color_buffer.clear_color = color(random);
    changed.lighting.enabled = !changed.lighting.enabled;
    changed.lighting.shade_model = GL_FLAT;
    changed.color_buffer.write_enabled = {true, false, true, false};
    changed.depth.test_enabled = !changed.depth.test_enabled;
    changed.polygon.front_mode = GL_LINE;
    changed.scissor.enabled = !changed.scissor.enabled;
    EXPECT_EQ(snapshot_of(changed, target), before);
    changed.viewport.depth_near = 0.375;
    EXPECT_NE(snapshot_of(changed, target), before);
  }
}

TEST(Snapshot, OfTheInitialStateIsTheInitialDrawState) {
  const TargetInfo target{0, 0, {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::z24s8}, 255};
  EXPECT_EQ(snapshot_of(State(), target), pipeline::DrawState());
}

TEST(Snapshot, ScissorBoxIsIntersectedWithTheTarget) {
  const TargetInfo target{64, 32, {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::none}, 0};
  State state;
  EXPECT_EQ(snapshot_of(state, target).raster.scissor, (pipeline::PixelRect{0, 0, 64, 32}));
  constexpr GLint most = std::numeric_limits<GLint>::max(), least = std::numeric_limits<GLint>::min();
  state.scissor = {true, -5, -5, most, most};
  EXPECT_EQ(snapshot_of(state, target).raster.scissor, (pipeline::PixelRect{0, 0, 64, 32}));
  state.scissor = {true, 60, 30, most, 1};
  EXPECT_EQ(snapshot_of(state, target).raster.scissor, (pipeline::PixelRect{60, 30, 64, 31}));
  for (const ScissorGroup outside : {ScissorGroup{true, 64, 0, 9, 9}, ScissorGroup{true, most, most, most, most},
                                     ScissorGroup{true, least, least, 9, 9}, ScissorGroup{true, 3, 3, 0, 9}}) {
    state.scissor = outside;
    EXPECT_EQ(snapshot_of(state, target).raster.scissor, pipeline::PixelRect());
  }
}

TEST(PreparedLight, IsInEyeSpaceAndOfUnitDirection) {
  Light light;
  light.position_eye = {0, 3, 4, 0};
  light.diffuse = glm::vec4(1);
  light.linear_attenuation = 5;
  const pipeline::PreparedLight directional = prepare_light(light);
  EXPECT_FALSE(directional.positional);
  EXPECT_EQ(directional.position_eye, glm::vec3(0, 0.6f, 0.8f));
  EXPECT_EQ(directional.attenuation, glm::vec3(1, 0, 0));
  EXPECT_FALSE(directional.spot);

  light.position_eye = {2, 4, 6, 2};
  light.spot_cutoff_deg = 90;
  light.spot_direction_eye = {0, 0, -7};
  const pipeline::PreparedLight spot = prepare_light(light);
  EXPECT_TRUE(spot.positional && spot.spot);
  EXPECT_EQ(spot.position_eye, glm::vec3(1, 2, 3));
  EXPECT_EQ(spot.attenuation, glm::vec3(1, 5, 0));
  EXPECT_EQ(spot.spot_direction_eye, glm::vec3(0, 0, -1));
  EXPECT_EQ(spot.spot_cutoff_cosine, 0.0f);
  light.spot_cutoff_deg = 60;
  EXPECT_EQ(prepare_light(light).spot_cutoff_cosine, 0.5f);
}

TEST(PreparedLight, WithoutADirectionIsZero) {
  Light light;
  const float infinity = std::numeric_limits<float>::infinity();
  for (const glm::vec4 position : {glm::vec4(0, 0, 0, 0), glm::vec4(infinity, 0, 0, 0)}) {
    light.position_eye = position;
    EXPECT_EQ(prepare_light(light).position_eye, glm::vec3(0));
  }
}

TEST(ClearState, LeavesOutWhatIsMaskedOrMissing) {
  State state;
  state.stencil.clear_value = 0x1FF;
  const GLbitfield everything = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  const TargetInfo full{8, 8, {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::z24s8}, 255};
  const pipeline::ClearState all = clear_state(state, full, everything);
  EXPECT_TRUE(all.color && all.depth && all.stencil);
  EXPECT_EQ(all.clear_stencil, 255u);

  state.depth.write_enabled = false;
  state.stencil.front.write_mask = 0xF00;
  state.color_buffer.write_enabled = {false, false, false, false};
  const pipeline::ClearState masked = clear_state(state, full, everything);
  EXPECT_FALSE(masked.color || masked.depth || masked.stencil);
  const pipeline::ClearState bare = clear_state(State(), {8, 8, {}, 0}, everything);
  EXPECT_FALSE(bare.color || bare.depth || bare.stencil);
}

constexpr TargetInfo stencil_target{8, 8, {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::z24s8}, 255};

TEST(StencilSnapshot, IsAbsentWhereItPassesAllAndChangesNothing) {
  State state;
  state.stencil.test_enabled = true;
  EXPECT_EQ(snapshot_of(state, stencil_target), snapshot_of(State(), stencil_target));
  state.stencil.front.fail = state.stencil.separate_back.fail = GL_INCR;  // nothing fails
  EXPECT_FALSE(snapshot_of(state, stencil_target).raster.stencil.enabled);
  state.stencil.front.depth_pass = GL_ZERO;
  state.stencil.front.write_mask = 0xFF00;
  EXPECT_FALSE(snapshot_of(state, stencil_target).raster.stencil.enabled);
}

TEST(StencilSnapshot, ComparesNothingUnderAnEmptyMaskAndClampsTheReference) {
  State state;
  state.stencil.test_enabled = true;
  state.stencil.front = {GL_LESS, 3, 0, GL_REPLACE, GL_KEEP, GL_KEEP, 0xFF};
  EXPECT_EQ(snapshot_of(state, stencil_target).raster.stencil.front.func, pipeline::CompareFunc::never);
  state.stencil.front = {GL_EQUAL, 3, 0x100, GL_REPLACE, GL_KEEP, GL_KEEP, 0xFF};
  EXPECT_EQ(snapshot_of(state, stencil_target).raster.stencil.front, pipeline::StencilFace());
  for (const auto& [reference, clamped] : {std::pair{300, 255}, std::pair{-7, 0}, std::pair{77, 77}}) {
    state.stencil.front = {GL_GEQUAL, reference, ~0u, GL_KEEP, GL_KEEP, GL_KEEP, 0xFF};
    EXPECT_EQ(snapshot_of(state, stencil_target).raster.stencil.front.reference, clamped);
  }
}

TEST(AccumSnapshot, BoundsTheValue) {
  const float infinity = std::numeric_limits<float>::infinity();
  const State state;
  EXPECT_EQ(accum_state(state, stencil_target, GL_ADD, 3.0f).value, 1.0f);
  EXPECT_EQ(accum_state(state, stencil_target, GL_MULT, -infinity).value, -1.0f);
  EXPECT_EQ(accum_state(state, stencil_target, GL_LOAD, 3.0f).value, 3.0f);
  EXPECT_EQ(accum_state(state, stencil_target, GL_RETURN, infinity).value, std::numeric_limits<float>::max());
  EXPECT_EQ(accum_state(state, stencil_target, GL_ACCUM, std::numeric_limits<float>::quiet_NaN()).value, 0.0f);
}

}  // namespace
}  // namespace gouraud::api
