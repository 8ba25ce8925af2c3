// Shared parts of scenes: numbers, matrices, meshes. Everything is computed in double and rounded once to float, so
// that all drivers on all hosts get the same numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gl_table.h"

namespace gouraud::conformance {

/// A small deterministic generator (xorshift32). One call an argument list: compilers evaluate arguments in any order.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed) {}
  std::uint32_t next();
  /// Uniform in [lowest, highest), a multiple of 2^-24 of the range.
  float range(float lowest, float highest);
  /// One of 0 .. count - 1.
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint32_t>(count)); }

 private:
  std::uint32_t state_;
};

/// Column-major, as glLoadMatrixf takes it.
using Matrix = std::array<float, 16>;

Matrix multiply(const Matrix& left, const Matrix& right);
Matrix translation(float x, float y, float z);
Matrix scaling(float x, float y, float z);
/// By `angle_deg` about the axis 0 (x), 1 (y) or 2 (z), counterclockwise as glRotate turns.
Matrix rotation(float angle_deg, int axis);
Matrix perspective(float fov_y_deg, float aspect, float near, float far);

/// Loads `matrix` as the projection or as the model-view matrix, and leaves GL_MODELVIEW the current mode.
void load_projection(const GlTable& gl, const Matrix& matrix);
void load_model_view(const GlTable& gl, const Matrix& matrix);

/// Object coordinates are window coordinates; z runs from -1 (near) to 1 (far). For pictures of this size.
void pixel_space(const GlTable& gl, int width_px, int height_px);

/// A perspective camera that looks at the origin, turned by `yaw_deg` about y, then looking down by `pitch_deg`.
struct Orbit {
  float distance = 4, pitch_deg = 25, yaw_deg = 33;
  float aspect = 1, fov_y_deg = 40, near = 1, far = 20;
};
/// Loads the camera as projection and model-view; returns the model-view matrix for what stands elsewhere.
Matrix look(const GlTable& gl, const Orbit& orbit);

/// Clears colour and depth, to a violet of alpha 0: fragments have other colours or another alpha.
void clear_background(const GlTable& gl);

void color_of(const GlTable& gl, Random& random);

/// A rectangle of points with normals, `rows` x `columns`, drawn as strips; counterclockwise from the normals' side.
struct Surface {
  struct Point {
    std::array<float, 3> position{}, normal{};
    float u = 0, v = 0;  ///< 0 .. 1 along the columns and the rows
  };
  int rows = 0, columns = 0;
  std::vector<Point> points;
  const Point& at(int row, int column) const { return points[static_cast<std::size_t>(row * columns + column)]; }
};

Surface sphere(float radius, int stacks, int slices);
Surface torus(float ring_radius, float tube_radius, int rings, int sides);
/// A square in the plane y = 0, centred on the origin, normals up.
Surface floor_grid(float size, int cells);
/// An open half of a cylinder's wall about the z axis (the side y < 0), normals inward.
Surface half_pipe(float radius, float length, int rows, int columns);

/// Draws a surface as one triangle strip a row; `before_vertex(point)` sets what else each vertex has.
template <class BeforeVertex>
void draw_surface(const GlTable& gl, const Surface& surface, BeforeVertex before_vertex) {
  const auto vertex = [&](const Surface::Point& point) {
    before_vertex(point);
    gl.Normal3fv(point.normal.data());
    gl.Vertex3fv(point.position.data());
  };
  for (int row = 0; row + 1 < surface.rows; ++row) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int column = 0; column < surface.columns; ++column) {
      vertex(surface.at(row + 1, column));
      vertex(surface.at(row, column));
    }
    gl.End();
  }
}
void draw_surface(const GlTable& gl, const Surface& surface);
/// As triangles, each cut into cuts * cuts, with positions and normals between its corners'.
void draw_cut_surface(const GlTable& gl, const Surface& surface, int cuts);
/// A floor's checks, each of two triangles; green is random.
void draw_checks(const GlTable& gl, const Surface& ground, Random& random);

/// A unit-less box about the origin, of six faces with their normals, as triangles.
void draw_box(const GlTable& gl, float width, float height, float depth);

/// An axis-parallel rectangle of one z, as two triangles in the current colour.
void draw_rectangle(const GlTable& gl, float left, float bottom, float right, float top, float z);

using Four = std::array<float, 4>;
void light(const GlTable& gl, GLenum light, GLenum pname, const Four& value);
void material(const GlTable& gl, GLenum face, GLenum pname, const Four& value);
/// Turns everything black that glLight, glMaterial and glLightModel have by default, then enables lighting and `lights`
/// lights: a scene adds the terms it shows.
void black_lighting(const GlTable& gl, int lights);

/// Two polygons of so many corners, one in the other, in a space of 256 x 256 pixels.
void polygon_rings(const GlTable& gl, int corners);

}  // namespace gouraud::conformance
