// What the vertex stages read: transformation and lighting [GL1.5 §2.11, §2.14].
#pragma once

#include <vector>

#include "api/snapshot/test_parameters.h"

namespace gouraud::api {

inline void add_transform(std::vector<Parameter>& list) {
  list.push_back({"modelview", [](State& s, Random& r) { s.matrices.modelview.top()[1][2] += number(r); }, always});
  list.push_back({"projection", [](State& s, Random& r) { s.matrices.projection.top()[0][1] += number(r); }, always});
  list.push_back({"texture matrix", [](State& s, Random& r) { s.matrices.texture[0].top()[0][1] = number(r); }, never});
  list.push_back({"matrix mode", [](State& s, Random&) { s.transform.matrix_mode = GL_TEXTURE; }, never});
  list.push_back({"active texture", [](State& s, Random&) { s.texture.active_unit ^= 1; }, never});
  list.push_back({"normalize", [](State& s, Random&) { s.transform.normalize_enabled ^= true; },
                  [](const View& v) { return v.normals(); }});
  list.push_back({"rescale", [](State& s, Random&) { s.transform.rescale_normal_enabled ^= true; },
                  [](const View& v) { return v.normals() && !v.state.transform.normalize_enabled; }});
  list.push_back({"clip origin", [](State& s, Random&) { s.transform.clip_origin ^= GL_LOWER_LEFT ^ GL_UPPER_LEFT; }, always});
  list.push_back({"clip depth mode",
                  [](State& s, Random&) { s.transform.clip_depth_mode ^= GL_NEGATIVE_ONE_TO_ONE ^ GL_ZERO_TO_ONE; }, always});
  list.push_back({"viewport x", [](State& s, Random&) { s.viewport.x += 1; }, always});
  list.push_back({"viewport height", [](State& s, Random&) { s.viewport.height_px += 1; }, always});
  list.push_back({"depth near", [](State& s, Random&) { s.viewport.depth_near = 1.0 - s.viewport.depth_near; },
                  [](const View& v) { return v.depth(); }});
  list.push_back(
      {"depth far", [](State& s, Random&) { s.viewport.depth_far *= 0.5; }, [](const View& v) { return v.depth(); }});
}

inline void add_light(std::vector<Parameter>& list, std::size_t i) {
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

inline void add_material(std::vector<Parameter>& list, int face) {
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

inline void add_lighting(std::vector<Parameter>& list) {
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

}  // namespace gouraud::api
