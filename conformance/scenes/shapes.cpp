#include "conformance/scenes/shapes.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace gouraud::conformance {
namespace {

constexpr double pi = std::numbers::pi;

float rounded(double value) {
  return static_cast<float>(value);
}

// Angle of a step of a closed circle; the last step is the first one again, bit for bit.
double circle_angle(int step, int steps) {
  return 2 * pi * (step % steps) / steps;
}

Surface make_surface(int rows, int columns, const std::function<Surface::Point(int row, int column)>& point) {
  Surface surface{.rows = rows, .columns = columns, .points = {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) surface.points.push_back(point(row, column));
  }
  return surface;
}

}  // namespace

std::uint32_t Random::next() {
  state_ ^= state_ << 13;
  state_ ^= state_ >> 17;
  state_ ^= state_ << 5;
  return state_;
}

float Random::range(float lowest, float highest) {
  const double unit = (next() >> 8) / 16777216.0;
  return rounded(lowest + unit * (static_cast<double>(highest) - lowest));
}

Matrix multiply(const Matrix& left, const Matrix& right) {
  Matrix product{};
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 4; ++row) {
      double sum = 0;
      for (std::size_t i = 0; i < 4; ++i) sum += static_cast<double>(left[4 * i + row]) * right[4 * column + i];
      product[4 * column + row] = rounded(sum);
    }
  }
  return product;
}

Matrix translation(float x, float y, float z) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

Matrix scaling(float x, float y, float z) {
  return {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1};
}

Matrix rotation(float angle_deg, int axis) {
  const double angle = angle_deg * pi / 180;
  const float c = rounded(std::cos(angle)), s = rounded(std::sin(angle));
  const auto first = static_cast<std::size_t>((axis + 1) % 3), second = static_cast<std::size_t>((axis + 2) % 3);
  Matrix matrix = translation(0, 0, 0);
  matrix[5 * first] = matrix[5 * second] = c;
  matrix[4 * first + second] = s;
  matrix[4 * second + first] = -s;
  return matrix;
}

Matrix perspective(float fov_y_deg, float aspect, float near, float far) {
  const double scale = 1 / std::tan(fov_y_deg * pi / 360);
  const double near_d = near, far_d = far;
  Matrix matrix{};
  matrix[0] = rounded(scale / aspect);
  matrix[5] = rounded(scale);
  matrix[10] = rounded((far_d + near_d) / (near_d - far_d));
  matrix[11] = -1;
  matrix[14] = rounded(2 * far_d * near_d / (near_d - far_d));
  return matrix;
}

void load_projection(const GlTable& gl, const Matrix& matrix) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadMatrixf(matrix.data());
  gl.MatrixMode(GL_MODELVIEW);
}

void load_model_view(const GlTable& gl, const Matrix& matrix) {
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadMatrixf(matrix.data());
}

void pixel_space(const GlTable& gl, int width_px, int height_px) {
  Matrix matrix = scaling(rounded(2.0 / width_px), rounded(2.0 / height_px), 1);
  matrix[12] = matrix[13] = -1;
  load_projection(gl, matrix);
}

Matrix look(const GlTable& gl, const Orbit& orbit) {
  load_projection(gl, perspective(orbit.fov_y_deg, orbit.aspect, orbit.near, orbit.far));
  const Matrix turned = multiply(rotation(orbit.pitch_deg, 0), rotation(orbit.yaw_deg, 1));
  const Matrix view = multiply(translation(0, 0, -orbit.distance), turned);
  load_model_view(gl, view);
  return view;
}

void clear_background(const GlTable& gl) {
  gl.ClearColor(0.25f, 0.05f, 0.35f, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void color_of(const GlTable& gl, Random& random) {
  const float red = random.range(0, 1), green = random.range(0, 1);
  gl.Color3f(red, green, random.range(0, 1));
}

Surface sphere(float radius, int stacks, int slices) {
  return make_surface(stacks + 1, slices + 1, [=](int row, int column) {
    const double latitude = pi * row / stacks - pi / 2, longitude = circle_angle(column, slices);
    const bool pole = row == 0 || row == stacks;
    const double across = pole ? 0 : std::cos(latitude);
    const std::array<double, 3> n = {across * std::sin(longitude), std::sin(latitude), across * std::cos(longitude)};
    Surface::Point point{.u = rounded(1.0 * column / slices), .v = rounded(1.0 * row / stacks)};
    for (std::size_t i = 0; i < 3; ++i) {
      point.normal[i] = rounded(n[i]);
      point.position[i] = rounded(radius * n[i]);
    }
    return point;
  });
}

Surface torus(float ring_radius, float tube_radius, int rings, int sides) {
  return make_surface(sides + 1, rings + 1, [=](int row, int column) {
    const double around = circle_angle(column, rings), tube = circle_angle(row, sides);
    const double distance = ring_radius + tube_radius * std::cos(tube);
    Surface::Point point{.u = rounded(1.0 * column / rings), .v = rounded(1.0 * row / sides)};
    point.normal = {rounded(std::cos(tube) * std::sin(around)), rounded(std::sin(tube)),
                    rounded(std::cos(tube) * std::cos(around))};
    point.position = {rounded(distance * std::sin(around)), rounded(tube_radius * std::sin(tube)),
                      rounded(distance * std::cos(around))};
    return point;
  });
}

Surface floor_grid(float size, int cells) {
  return make_surface(cells + 1, cells + 1, [=](int row, int column) {
    const double u = 1.0 * column / cells, v = 1.0 * row / cells;
    return Surface::Point{.position = {rounded((u - 0.5) * size), 0, rounded((0.5 - v) * size)},
                          .normal = {0, 1, 0},
                          .u = rounded(u),
                          .v = rounded(v)};
  });
}

Surface half_pipe(float radius, float length, int rows, int columns) {
  return make_surface(rows + 1, columns + 1, [=](int row, int column) {
    const double u = 1.0 * column / columns, v = 1.0 * row / rows;
    const double x = -std::cos(pi * u), y = -std::sin(pi * u);
    return Surface::Point{.position = {rounded(radius * x), rounded(radius * y), rounded((0.5 - v) * length)},
                          .normal = {rounded(-x), rounded(-y), 0},
                          .u = rounded(u),
                          .v = rounded(v)};
  });
}

void draw_surface(const GlTable& gl, const Surface& surface) {
  draw_surface(gl, surface, [](const Surface::Point&) {});
}

void draw_cut_surface(const GlTable& gl, const Surface& surface, int cuts) {
  const auto vertex = [&](const Surface::Point& a, const Surface::Point& b, const Surface::Point& c, int i, int j) {
    const double v = 1.0 * i / cuts, w = 1.0 * j / cuts, u = 1 - v - w;
    std::array<float, 3> normal, position;
    for (std::size_t k = 0; k < 3; ++k) {
      normal[k] = static_cast<float>(u * a.normal[k] + v * b.normal[k] + w * c.normal[k]);
      position[k] = static_cast<float>(u * a.position[k] + v * b.position[k] + w * c.position[k]);
    }
    gl.Normal3fv(normal.data());
    gl.Vertex3fv(position.data());
  };
  const auto triangle = [&](const Surface::Point& a, const Surface::Point& b, const Surface::Point& c) {
    for (int i = 0; i < cuts; ++i) {
      for (int j = 0; i + j < cuts; ++j) {
        vertex(a, b, c, i, j);
        vertex(a, b, c, i + 1, j);
        vertex(a, b, c, i, j + 1);
        if (i + j + 1 >= cuts) continue;
        vertex(a, b, c, i + 1, j);
        vertex(a, b, c, i + 1, j + 1);
        vertex(a, b, c, i, j + 1);
      }
    }
  };
  gl.Begin(GL_TRIANGLES);
  for (int row = 0; row + 1 < surface.rows; ++row) {
    for (int column = 0; column + 1 < surface.columns; ++column) {
      triangle(surface.at(row, column), surface.at(row, column + 1), surface.at(row + 1, column + 1));
      triangle(surface.at(row, column), surface.at(row + 1, column + 1), surface.at(row + 1, column));
    }
  }
  gl.End();
}

void draw_checks(const GlTable& gl, const Surface& ground, Random& random) {
  gl.Begin(GL_TRIANGLES);
  for (int row = 0; row + 1 < ground.rows; ++row) {
    for (int column = 0; column + 1 < ground.columns; ++column) {
      const float shade = (row + column) % 2 == 0 ? 0.8f : 0.2f;
      const int corners[6][2] = {{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}};
      for (const auto& [r, c] : corners) {
        gl.Color3f(shade, random.range(0.2f, 0.6f), 1 - shade);
        gl.Vertex3fv(ground.at(row + r, column + c).position.data());
      }
    }
  }
  gl.End();
}

void draw_box(const GlTable& gl, float width, float height, float depth) {
  const std::array<float, 3> half = {width / 2, height / 2, depth / 2};
  gl.Begin(GL_TRIANGLES);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
    for (const float side : {1.0f, -1.0f}) {
      std::array<float, 3> normal{}, corner{};
      normal[axis] = side;
      gl.Normal3fv(normal.data());
      // Counterclockwise from outside: the second axis runs backwards on the negative side.
      constexpr std::array<std::array<float, 2>, 6> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}};
      for (const auto& [u, v] : corners) {
        corner[axis] = side * half[axis];
        corner[first] = u * half[first];
        corner[second] = v * side * half[second];
        gl.Vertex3fv(corner.data());
      }
    }
  }
  gl.End();
}

void draw_rectangle(const GlTable& gl, float left, float bottom, float right, float top, float z) {
  gl.Begin(GL_TRIANGLE_STRIP);
  gl.Vertex3f(left, bottom, z);
  gl.Vertex3f(right, bottom, z);
  gl.Vertex3f(left, top, z);
  gl.Vertex3f(right, top, z);
  gl.End();
}

void light(const GlTable& gl, GLenum light, GLenum pname, const Four& value) {
  gl.Lightfv(light, pname, value.data());
}

void material(const GlTable& gl, GLenum face, GLenum pname, const Four& value) {
  gl.Materialfv(face, pname, value.data());
}

void black_lighting(const GlTable& gl, int lights) {
  constexpr Four black = {0, 0, 0, 1};
  for (GLenum i = 0; i < static_cast<GLenum>(lights); ++i) {
    for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) light(gl, GL_LIGHT0 + i, pname, black);
    gl.Enable(GL_LIGHT0 + i);
  }
  for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
    material(gl, GL_FRONT_AND_BACK, pname, black);
  }
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, black.data());
  gl.Enable(GL_LIGHTING);
}

void polygon_rings(const GlTable& gl, int corners) {
  for (int ring = 0; ring < 2; ++ring) {
    gl.Begin(GL_POLYGON);
    gl.Color4f(0.88f, ring == 0 ? 0.6f : 0.9f, 0.2f, 0.7f);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * pi * k / corners, radius = ring == 0 ? 119.3 : 61.7;
      gl.Vertex2f(static_cast<float>(126.3 + radius * std::cos(angle)), static_cast<float>(129.1 + radius * std::sin(angle)));
    }
    gl.End();
  }
}

}  // namespace gouraud::conformance
