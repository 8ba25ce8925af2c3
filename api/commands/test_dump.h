// For tests: all that the queries of the GL tell about the current context, to compare before and after a call.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/enables.h"
#include "api/commands/state_table.h"
#include "api/commands/vertex_arrays.h"
#include "api/context/context.h"

namespace gouraud::api {

/// What was asked for -> the values that came.
using StateDump = std::map<std::string, std::vector<double>>;

/// Every cap of Enable or EnableClientState.
inline const std::vector<GLenum>& all_capabilities() {
  static const std::vector<GLenum> caps = [] {
    std::vector<GLenum> found;
    State state;
    for (GLenum cap = 0; cap < 0x10000; ++cap) {
      if (find_capability(state, cap).flag != nullptr || find_array(state.vertex_arrays, cap) != nullptr) {
        found.push_back(cap);
      }
    }
    return found;
  }();
  return caps;
}

namespace dump {

template <class Get>
void add(StateDump& dump, const std::string& name, int count, Get get) {
  std::array<GLfloat, 64> values{};
  get(values.data());
  dump[name].assign(values.begin(), values.begin() + count);
}

inline void add_rows(StateDump& dump) {
  for (const StateRow& row : state_rows()) {
    std::array<GLdouble, max_components> values{};
    glGetDoublev(row.pname, values.data());
    dump["glGet " + std::to_string(row.pname)].assign(values.begin(), values.begin() + row.count);
  }
  for (const GLenum cap : all_capabilities()) {
    dump["glIsEnabled " + std::to_string(cap)] = {static_cast<double>(glIsEnabled(cap))};
  }
}

inline void add_lighting(StateDump& dump) {
  for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light) {
    for (GLenum pname = GL_AMBIENT; pname <= GL_QUADRATIC_ATTENUATION; ++pname) {
      add(dump, "light " + std::to_string(light) + " " + std::to_string(pname), 4,
          [=](GLfloat* v) { glGetLightfv(light, pname, v); });
    }
  }
  for (const GLenum face : {GL_FRONT, GL_BACK}) {
    for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES}) {
      add(dump, "material " + std::to_string(face) + " " + std::to_string(pname), 4,
          [=](GLfloat* v) { glGetMaterialfv(face, pname, v); });
    }
  }
  for (int i = 0; i < max_clip_planes; ++i) {
    std::array<GLdouble, 4> plane{};
    glGetClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), plane.data());
    dump["clip plane " + std::to_string(i)].assign(plane.begin(), plane.end());
  }
}

inline void add_texture_objects(StateDump& dump, const std::string& unit) {
  for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP}) {
    const std::string name = unit + std::to_string(target) + " ";
    for (const GLenum pname :
         {GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
          GL_TEXTURE_WRAP_R, GL_TEXTURE_PRIORITY, GL_TEXTURE_RESIDENT, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD,
          GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_LOD_BIAS, GL_DEPTH_TEXTURE_MODE,
          GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC, GL_GENERATE_MIPMAP, GL_TEXTURE_MAX_ANISOTROPY_EXT}) {
      add(dump, name + std::to_string(pname), 4, [=](GLfloat* v) { glGetTexParameterfv(target, pname, v); });
    }
    const GLenum image = target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
    for (const GLenum pname : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_BORDER,
                               GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_COMPRESSED}) {
      for (int level = 0; level < 3; ++level) {
        add(dump, name + "level " + std::to_string(level) + " " + std::to_string(pname), 1,
            [=](GLfloat* v) { glGetTexLevelParameterfv(image, level, pname, v); });
      }
    }
  }
}

inline void add_texture_units(StateDump& dump) {
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (int i = 0; i < max_texture_units; ++i) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    const std::string unit = "unit " + std::to_string(i) + " ";
    for (const GLenum pname :
         {GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR, GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SRC0_RGB, GL_SRC1_RGB,
          GL_SRC2_RGB, GL_SRC0_ALPHA, GL_SRC1_ALPHA, GL_SRC2_ALPHA, GL_OPERAND0_RGB, GL_OPERAND1_RGB, GL_OPERAND2_RGB,
          GL_OPERAND0_ALPHA, GL_OPERAND1_ALPHA, GL_OPERAND2_ALPHA, GL_RGB_SCALE, GL_ALPHA_SCALE}) {
      add(dump, unit + std::to_string(pname), 4, [=](GLfloat* v) { glGetTexEnvfv(GL_TEXTURE_ENV, pname, v); });
    }
    add(dump, unit + "bias", 1, [](GLfloat* v) { glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, v); });
    for (const GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
      for (const GLenum pname : {GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE}) {
        add(dump, unit + std::to_string(coordinate) + " " + std::to_string(pname), 4,
            [=](GLfloat* v) { glGetTexGenfv(coordinate, pname, v); });
      }
    }
    if (i < 2) add_texture_objects(dump, unit);
  }
  glActiveTexture(static_cast<GLenum>(active));
}

inline void add_maps(StateDump& dump) {
  for (const GLenum first : {GL_MAP1_COLOR_4, GL_MAP2_COLOR_4}) {
    for (GLenum map = first; map < first + 9; ++map) {
      for (const GLenum pname : {GL_ORDER, GL_DOMAIN, GL_COEFF}) {
        add(dump, "map " + std::to_string(map) + " " + std::to_string(pname), 16,
            [=](GLfloat* v) { glGetMapfv(map, pname, v); });
      }
    }
  }
  for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_A_TO_A; ++map) {
    std::array<GLfloat, 256> values{};
    glGetPixelMapfv(map, values.data());
    dump["pixel map " + std::to_string(map)].assign(values.begin(), values.end());
  }
}

inline void add_pointers(StateDump& dump) {
  for (const GLenum pname :
       {GL_VERTEX_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER, GL_INDEX_ARRAY_POINTER,
        GL_TEXTURE_COORD_ARRAY_POINTER, GL_EDGE_FLAG_ARRAY_POINTER, GL_SECONDARY_COLOR_ARRAY_POINTER,
        GL_FOG_COORD_ARRAY_POINTER, GL_FEEDBACK_BUFFER_POINTER, GL_SELECTION_BUFFER_POINTER}) {
    void* pointer = nullptr;
    glGetPointerv(pname, &pointer);
    dump["pointer " + std::to_string(pname)] = {static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer))};
  }
  GLint query = 0;
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &query);
  dump["query"] = {static_cast<double>(query)};
}

}  // namespace dump

/// Records no error; changes nothing.
inline StateDump dump_state() {
  StateDump result;
  dump::add_rows(result);
  dump::add_lighting(result);
  dump::add_texture_units(result);
  dump::add_maps(result);
  dump::add_pointers(result);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "a query of the dump";
  return result;
}

/// What differs between two dumps; empty if nothing does.
inline std::string difference(const StateDump& a, const StateDump& b) {
  std::string text;
  for (const auto& [name, values] : a) {
    if (b.at(name) != values) text += name + "; ";
  }
  return text;
}

}  // namespace gouraud::api
