// What rasterization and fragments read [GL1.5 §3, §4], and what no draw reads.
#pragma once

#include <vector>

#include "api/snapshot/test_parameters.h"

namespace gouraud::api {

inline void add_rasterization(std::vector<Parameter>& list) {
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

inline void add_points_and_lines(std::vector<Parameter>& list) {
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

inline void add_polygons(std::vector<Parameter>& list) {
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
  list.push_back({"polygon offset bias", [](State& s, Random& r) { s.polygon.offset_bias += number(r); }, is_offset});
}

inline void add_framebuffer(std::vector<Parameter>& list) {
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

inline void add_fog(std::vector<Parameter>& list) {
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

inline void add_clip_planes(std::vector<Parameter>& list) {
  list.push_back({"clip plane", [](State& s, Random&) { s.transform.clip_planes[6].enabled ^= true; }, always});
  list.push_back({"clip plane equation", [](State& s, Random& r) { s.transform.clip_planes[6].plane_eye.z += number(r); },
                  [](const View& v) { return v.state.transform.clip_planes[6].enabled; }});
}

inline void add_alpha_test(std::vector<Parameter>& list) {
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

inline void add_blending(std::vector<Parameter>& list) {
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

inline void add_logic_op(std::vector<Parameter>& list) {
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
inline void add_stencil(std::vector<Parameter>& list) {
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

inline void add_what_no_draw_reads(std::vector<Parameter>& list) {
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

}  // namespace gouraud::api
