// One mesh from every command that draws from arrays, and the layouts of arrays. [GL1.5 §2.8]
#include <array>
#include <cstddef>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

/// A lit torus: GL_TRIANGLES by their corners in a shared array of points.
struct Mesh {
  Surface surface = torus(0.9f, 0.4f, 40, 24);
  std::vector<GLuint> indices;

  Mesh() {
    for (int row = 0; row + 1 < surface.rows; ++row) {
      for (int column = 0; column + 1 < surface.columns; ++column) {
        const auto corner = static_cast<GLuint>(row * surface.columns + column);
        const auto above = corner + static_cast<GLuint>(surface.columns);
        for (const GLuint index : {corner, corner + 1, above, above, corner + 1, above + 1}) indices.push_back(index);
      }
    }
  }
  GLsizei count() const { return static_cast<GLsizei>(indices.size()); }
};

void prepare(const GlTable& gl) {
  clear_background(gl);
  look(gl, {});
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {2, 3, 4, 1});
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.9f, 0.6f, 0.2f, 1});
  gl.Enable(GL_DEPTH_TEST);
}

void enable_mesh(const GlTable& gl, const Mesh& mesh) {
  gl.VertexPointer(3, GL_FLOAT, sizeof(Surface::Point), mesh.surface.points[0].position.data());
  gl.NormalPointer(GL_FLOAT, sizeof(Surface::Point), mesh.surface.points[0].normal.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
}

void draw_elements(const GlTable& gl) {
  const Mesh mesh;
  prepare(gl);
  enable_mesh(gl, mesh);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, mesh.indices.data());
}

void draw_elements_of_shorts(const GlTable& gl) {
  const Mesh mesh;
  const std::vector<GLushort> indices(mesh.indices.begin(), mesh.indices.end());
  prepare(gl);
  enable_mesh(gl, mesh);
  const auto last = static_cast<GLuint>(mesh.surface.points.size() - 1);
  gl.DrawRangeElements(GL_TRIANGLES, 0, last, mesh.count(), GL_UNSIGNED_SHORT, indices.data());
}

void array_elements(const GlTable& gl) {
  const Mesh mesh;
  prepare(gl);
  enable_mesh(gl, mesh);
  gl.Begin(GL_TRIANGLES);
  for (const GLuint index : mesh.indices) gl.ArrayElement(static_cast<GLint>(index));
  gl.End();
}

// Each strip is made of the points of two neighbouring rows.
void multi_draw_strips(const GlTable& gl) {
  const Mesh mesh;
  prepare(gl);
  enable_mesh(gl, mesh);
  std::vector<std::vector<GLuint>> strips;
  for (int row = 0; row + 1 < mesh.surface.rows; ++row) {
    std::vector<GLuint>& strip = strips.emplace_back();
    for (int column = 0; column < mesh.surface.columns; ++column) {
      strip.push_back(static_cast<GLuint>((row + 1) * mesh.surface.columns + column));
      strip.push_back(static_cast<GLuint>(row * mesh.surface.columns + column));
    }
  }
  std::vector<GLsizei> counts;
  std::vector<const void*> lists;
  for (const auto& strip : strips) {
    counts.push_back(static_cast<GLsizei>(strip.size()));
    lists.push_back(strip.data());
  }
  gl.MultiDrawElements(GL_TRIANGLE_STRIP, counts.data(), GL_UNSIGNED_INT, lists.data(),
                       static_cast<GLsizei>(counts.size()));
}

// Every mode from DrawArrays, in a grid of cells.
void modes(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  constexpr std::array<float, 16> corners = {4.3f, 5.1f,  44.2f, 8.4f,  46.1f, 40.7f, 26.4f, 56.3f,
                                             8.9f, 44.2f, 2.2f,  28.8f, 1.3f,  14.6f, 2.9f,  7.1f};
  constexpr std::array<GLubyte, 24> colors = {255, 0,   0,   0,   255, 0,   0,   0,   255, 255, 255, 0,
                                              0,   255, 255, 255, 0,   255, 128, 200, 60,  40,  90,  220};
  gl.VertexPointer(2, GL_FLOAT, 0, corners.data());
  gl.ColorPointer(3, GL_UNSIGNED_BYTE, 0, colors.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  constexpr std::array<GLenum, 6> filled = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                                            GL_QUADS,     GL_QUAD_STRIP,     GL_POLYGON};
  for (std::size_t i = 0; i < filled.size(); ++i) {
    load_model_view(gl, translation(static_cast<float>(i % 4) * 64, static_cast<float>(i / 4) * 64, 0));
    gl.DrawArrays(filled[i], static_cast<GLint>(i % 2), 7);
  }
}

// All fourteen formats of InterleavedArrays, stride 0, with the same triangle.
void interleaved(const GlTable& gl) {
  struct Format {
    GLenum name;
    int texture, color, normal, vertex;
    bool bytes = false;
  };
  constexpr std::array<Format, 14> formats = {{{GL_V2F, 0, 0, 0, 2},
                                               {GL_V3F, 0, 0, 0, 3},
                                               {GL_C4UB_V2F, 0, 4, 0, 2, true},
                                               {GL_C4UB_V3F, 0, 4, 0, 3, true},
                                               {GL_C3F_V3F, 0, 3, 0, 3},
                                               {GL_N3F_V3F, 0, 0, 3, 3},
                                               {GL_C4F_N3F_V3F, 0, 4, 3, 3},
                                               {GL_T2F_V3F, 2, 0, 0, 3},
                                               {GL_T4F_V4F, 4, 0, 0, 4},
                                               {GL_T2F_C4UB_V3F, 2, 4, 0, 3, true},
                                               {GL_T2F_C3F_V3F, 2, 3, 0, 3},
                                               {GL_T2F_N3F_V3F, 2, 0, 3, 3},
                                               {GL_T2F_C4F_N3F_V3F, 2, 4, 3, 3},
                                               {GL_T4F_C4F_N3F_V4F, 4, 4, 3, 4}}};
  constexpr float corners[3][4] = {{5.2f, 6.1f, 0.25f, 1}, {57.4f, 15.3f, 0.25f, 1}, {21.6f, 58.9f, 0.25f, 1}};
  constexpr float colors[3][4] = {{1, 0.2f, 0, 1}, {0, 1, 0.4f, 1}, {0.2f, 0, 1, 1}};
  clear_background(gl);
  pixel_space(gl, 256, 256);
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const Format& format = formats[i];
    std::vector<GLubyte> data;
    const auto put_float = [&data](float value) {
      const auto* const bytes = reinterpret_cast<const GLubyte*>(&value);
      data.insert(data.end(), bytes, bytes + sizeof value);
    };
    for (int corner = 0; corner < 3; ++corner) {
      for (int c = 0; c < format.texture; ++c) put_float(0.5f);
      for (int c = 0; c < format.color; ++c) {
        if (format.bytes) {
          data.push_back(static_cast<GLubyte>(colors[corner][c] * 255));
        } else {
          put_float(colors[corner][c]);
        }
      }
      for (int c = 0; c < format.normal; ++c) put_float(1);
      for (int c = 0; c < format.vertex; ++c) put_float(corners[corner][c]);
    }
    load_model_view(gl, translation(static_cast<float>(i % 4) * 64, static_cast<float>(i / 4) * 64, 0));
    gl.Color3f(0.9f, 0.9f, 0.3f);
    gl.InterleavedArrays(format.name, 0, data.data());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
  }
}

}  // namespace

SceneList vertex_array_scenes() {
  constexpr auto section = "§2.8";
  return {
      {.name = "draw_elements", .section = section, .shows = "A lit torus from DrawElements.", .draw = draw_elements},
      {.name = "draw_range_elements",
       .section = section,
       .shows = "The same torus from DrawRangeElements with short indices.",
       .draw = draw_elements_of_shorts},
      {.name = "array_elements",
       .section = section,
       .shows = "The same torus from ArrayElement.",
       .draw = array_elements},
      {.name = "multi_draw_elements",
       .section = section,
       .shows = "The same torus as strips from one MultiDrawElements.",
       .draw = multi_draw_strips},
      {.name = "draw_arrays_modes",
       .section = section,
       .shows = "Seven vertices with seven colours in each of the six filled modes.",
       .width_px = 256,
       .height_px = 128,
       .draw = modes},
      {.name = "interleaved_arrays",
       .section = section,
       .shows = "Fourteen equal triangles, from the formats of InterleavedArrays; those without colours are yellow.",
       .draw = interleaved},
  };
}

}  // namespace gouraud::conformance
