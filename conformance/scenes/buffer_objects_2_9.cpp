// Meshes whose arrays and indices lie in buffer objects. [GL1.5 §2.9]
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(bytes));
}

/// Positions and normals of a sphere, one array after the other; rows of points as strips of indices.
struct Sphere {
  std::vector<float> positions, normals;
  std::vector<std::vector<GLushort>> strips;

  Sphere() {
    const Surface surface = sphere(1.2f, 30, 40);
    for (const Surface::Point& point : surface.points) {
      positions.insert(positions.end(), point.position.begin(), point.position.end());
      normals.insert(normals.end(), point.normal.begin(), point.normal.end());
    }
    for (int row = 0; row + 1 < surface.rows; ++row) {
      std::vector<GLushort>& strip = strips.emplace_back();
      for (int column = 0; column < surface.columns; ++column) {
        strip.push_back(static_cast<GLushort>((row + 1) * surface.columns + column));
        strip.push_back(static_cast<GLushort>(row * surface.columns + column));
      }
    }
  }
};

void prepare(const GlTable& gl) {
  clear_background(gl);
  look(gl, {});
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {2, 3, 4, 1});
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.3f, 0.6f, 0.9f, 1});
  gl.Enable(GL_DEPTH_TEST);
}

void draw_from_buffers(const GlTable& gl, bool mapped) {
  const Sphere mesh;
  prepare(gl);
  std::array<GLuint, 2> names{};
  gl.GenBuffers(2, names.data());
  const std::size_t bytes = mesh.positions.size() * sizeof(float);
  gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(2 * bytes), nullptr, GL_STATIC_DRAW);
  if (mapped) {
    auto* const store = static_cast<char*>(gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY));
    if (store == nullptr) return;
    std::memcpy(store, mesh.positions.data(), bytes);
    std::memcpy(store + bytes, mesh.normals.data(), bytes);
    gl.UnmapBuffer(GL_ARRAY_BUFFER);
  } else {
    gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes), mesh.positions.data());
    gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(bytes), static_cast<GLsizeiptr>(bytes),
                     mesh.normals.data());
  }
  gl.VertexPointer(3, GL_FLOAT, 0, offset(0));
  gl.NormalPointer(GL_FLOAT, 0, offset(bytes));
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);

  const std::size_t strip_bytes = mesh.strips[0].size() * sizeof(GLushort);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(strip_bytes * mesh.strips.size()), nullptr,
                GL_STATIC_DRAW);
  for (std::size_t i = 0; i < mesh.strips.size(); ++i) {
    gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(i * strip_bytes),
                     static_cast<GLsizeiptr>(strip_bytes), mesh.strips[i].data());
  }
  for (std::size_t i = 0; i < mesh.strips.size(); ++i) {
    gl.DrawElements(GL_TRIANGLE_STRIP, static_cast<GLsizei>(mesh.strips[i].size()), GL_UNSIGNED_SHORT,
                    offset(i * strip_bytes));
  }
  gl.DeleteBuffers(2, names.data());
}

// The second triangle is drawn from what BufferSubData wrote after the first draw.
void changed_between_draws(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 64);
  constexpr std::array<float, 6> left = {4.2f, 5.4f, 60.3f, 12.1f, 22.6f, 58.7f};
  constexpr std::array<float, 6> right = {70.1f, 50.9f, 98.8f, 6.2f, 122.3f, 44.4f};
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(GL_ARRAY_BUFFER, name);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof left, left.data(), GL_DYNAMIC_DRAW);
  gl.VertexPointer(2, GL_FLOAT, 0, offset(0));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.Color3f(1, 0.5f, 0.25f);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, sizeof right, right.data());
  gl.Color3f(0.25f, 0.5f, 1);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_DYNAMIC_DRAW);
}

}  // namespace

SceneList buffer_object_scenes() {
  constexpr auto section = "§2.9";
  return {
      {.name = "buffer_objects",
       .section = section,
       .shows = "A lit sphere: arrays in one buffer object, indices in another.",
       .draw = [](const GlTable& gl) { draw_from_buffers(gl, false); }},
      {.name = "buffer_objects_mapped",
       .section = section,
       .shows = "The same sphere, its arrays written through MapBuffer.",
       .draw = [](const GlTable& gl) { draw_from_buffers(gl, true); }},
      {.name = "buffer_changed_between_draws",
       .section = section,
       .shows = "Two different triangles from one buffer that changed in between.",
       .width_px = 128,
       .height_px = 64,
       .draw = changed_between_draws},
  };
}

}  // namespace gouraud::conformance
