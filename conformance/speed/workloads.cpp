#include "conformance/speed/workloads.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "conformance/speed/mirror_workload.h"
#include "conformance/speed/pixel_workloads.h"
#include "conformance/speed/state_workloads.h"
#include "conformance/speed/texture_workloads.h"

namespace gouraud::speed {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr int full_hd_width_px = 1920, full_hd_height_px = 1080;
constexpr GLbitfield color_and_depth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;

using Vec3 = std::array<float, 3>;
using Vec4 = std::array<float, 4>;

/// Numbers in [0, 1), the same in every process: a 32-bit linear congruential generator.
class Random {
 public:
  float next() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<float>(state_ >> 8) / 16777216.0f;
  }
  float between(float low, float high) { return low + (high - low) * next(); }

 private:
  std::uint32_t state_ = 1;
};

Vec3 unit(const Vec3& v) {
  const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

struct LitVertex {
  Vec3 normal, position;
};

void set_camera(const GlTable& gl) {
  const double aspect = static_cast<double>(full_hd_width_px) / full_hd_height_px;
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-0.5 * aspect, 0.5 * aspect, -0.5, 0.5, 1.0, 10.0);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
}

void set_material(const GlTable& gl, const Vec4& diffuse, float shininess) {
  const Vec4 specular{0.6f, 0.6f, 0.6f, 1.0f};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse.data());
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular.data());
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
}

void enable_light(const GlTable& gl, GLenum light, const Vec4& position, const Vec4& diffuse) {
  gl.Lightfv(light, GL_POSITION, position.data());
  gl.Lightfv(light, GL_DIFFUSE, diffuse.data());
  gl.Lightfv(light, GL_SPECULAR, diffuse.data());
  gl.Enable(light);
}

/// 200,000 triangles of a few pixels each, one directional light, every vertex with its own normal.
Frame small_triangles(const GlTable& gl) {
  constexpr int triangles = 200'000;
  std::vector<LitVertex> vertices;
  Random random;
  for (int i = 0; i < triangles; ++i) {
    const Vec3 center{random.between(-3.4f, 3.4f), random.between(-1.9f, 1.9f), random.between(-5.0f, -4.0f)};
    for (int corner = 0; corner < 3; ++corner) {
      const float angle = random.between(0.0f, 2.0f * pi);
      const float radius = random.between(0.006f, 0.012f);
      const Vec3 normal = unit({random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f), random.between(0.2f, 1.0f)});
      vertices.push_back(
          {normal, {center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle), center[2]}});
    }
  }
  set_camera(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  set_material(gl, {0.3f, 0.6f, 0.9f, 1.0f}, 0.0f);
  enable_light(gl, GL_LIGHT0, {0.3f, 0.5f, 1.0f, 0.0f}, {1.0f, 1.0f, 1.0f, 1.0f});
  return [vertices = std::move(vertices)](const GlTable& table) {
    table.Clear(color_and_depth);
    table.Begin(GL_TRIANGLES);
    for (const LitVertex& vertex : vertices) {
      table.Normal3fv(vertex.normal.data());
      table.Vertex3fv(vertex.position.data());
    }
    table.End();
  };
}

constexpr int stacks = 224, slices = 224;

/// Of the unit sphere: normals and positions at once.
std::vector<Vec3> sphere_points() {
  std::vector<Vec3> points;
  for (int stack = 0; stack <= stacks; ++stack) {
    const float latitude = pi * (static_cast<float>(stack) / stacks - 0.5f);
    for (int slice = 0; slice <= slices; ++slice) {
      const float longitude = 2.0f * pi * static_cast<float>(slice) / slices;
      points.push_back({std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                        std::cos(latitude) * std::sin(longitude)});
    }
  }
  return points;
}

/// Four positional lights with highlights.
void light_sphere(const GlTable& gl) {
  set_camera(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  set_material(gl, {0.7f, 0.7f, 0.7f, 1.0f}, 32.0f);
  enable_light(gl, GL_LIGHT0, {4.0f, 3.0f, 1.0f, 1.0f}, {0.8f, 0.2f, 0.2f, 1.0f});
  enable_light(gl, GL_LIGHT1, {-4.0f, 3.0f, 1.0f, 1.0f}, {0.2f, 0.8f, 0.2f, 1.0f});
  enable_light(gl, GL_LIGHT2, {0.0f, -4.0f, 1.0f, 1.0f}, {0.2f, 0.2f, 0.8f, 1.0f});
  enable_light(gl, GL_LIGHT3, {0.0f, 0.0f, 4.0f, 1.0f}, {0.4f, 0.4f, 0.4f, 1.0f});
  gl.Translatef(0.0f, 0.0f, -3.5f);
}

/// A sphere of 224 strips with 448 triangles each.
Frame lit_sphere(const GlTable& gl) {
  light_sphere(gl);
  return [points = sphere_points()](const GlTable& table) {
    table.Clear(color_and_depth);
    for (std::size_t stack = 0; stack < stacks; ++stack) {
      const Vec3* const lower = &points[stack * (slices + 1)];
      const Vec3* const upper = lower + slices + 1;
      table.Begin(GL_TRIANGLE_STRIP);
      for (std::size_t slice = 0; slice <= slices; ++slice) {
        table.Normal3fv(upper[slice].data());
        table.Vertex3fv(upper[slice].data());
        table.Normal3fv(lower[slice].data());
        table.Vertex3fv(lower[slice].data());
      }
      table.End();
    }
  };
}

/// The sphere of lit_sphere, 100,352 triangles in 224 strips, as one display list under one light.
Frame display_list(const GlTable& gl) {
  const Frame sphere = lit_sphere(gl);
  for (const GLenum light : {GL_LIGHT1, GL_LIGHT2, GL_LIGHT3}) gl.Disable(light);
  gl.NewList(1, GL_COMPILE);
  sphere(gl);
  gl.EndList();
  return [](const GlTable& table) { table.CallList(1); };
}

/// The same sphere as one DrawElements of separate triangles, six of them around most points.
Frame indexed_sphere(const GlTable& gl) {
  std::vector<GLuint> indices;
  for (GLuint stack = 0; stack < stacks; ++stack) {
    for (GLuint slice = 0; slice < slices; ++slice) {
      const GLuint lower = stack * (slices + 1) + slice, upper = lower + slices + 1;
      for (const GLuint index : {lower, upper, lower + 1, lower + 1, upper, upper + 1}) indices.push_back(index);
    }
  }
  light_sphere(gl);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  return [points = sphere_points(), indices = std::move(indices)](const GlTable& table) {
    table.Clear(color_and_depth);
    table.VertexPointer(3, GL_FLOAT, 0, points.data());
    table.NormalPointer(GL_FLOAT, 0, points.data());
    table.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, indices.data());
  };
}

struct ColoredVertex {
  Vec3 color, position;
};

/// 20 screens of four random colours, at z_of(layer, x).
std::vector<ColoredVertex> screens(float (*z_of)(int layer, float x)) {
  constexpr int layers = 20;
  std::vector<ColoredVertex> vertices;
  Random random;
  for (int layer = 0; layer < layers; ++layer) {
    for (const auto& [x, y] : {std::array{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
      vertices.push_back({{random.next(), random.next(), random.next()}, {x, y, z_of(layer, x)}});
    }
  }
  return vertices;
}

Frame draw_quads(const GlTable& gl, std::vector<ColoredVertex> vertices) {
  gl.Enable(GL_DEPTH_TEST);
  return [vertices = std::move(vertices)](const GlTable& table) {
    table.Clear(color_and_depth);
    table.Begin(GL_QUADS);
    for (const ColoredVertex& vertex : vertices) {
      table.Color3fv(vertex.color.data());
      table.Vertex3fv(vertex.position.data());
    }
    table.End();
  };
}

/// Every layer passes the depth test.
Frame layers_back_to_front(const GlTable& gl) {
  return draw_quads(gl, screens([](int layer, float) { return 0.9f - 0.09f * static_cast<float>(layer); }));
}

/// Only the first layer passes.
Frame layers_front_to_back(const GlTable& gl) {
  return draw_quads(gl, screens([](int layer, float) { return -0.9f + 0.09f * static_cast<float>(layer); }));
}

/// The same, but w varies over the screen, so that colours are divided at every pixel; back to front.
Frame layers_in_perspective(const GlTable& gl) {
  // w = 1 - z/2; each quad leans by 1 in z from one side to the other, and is large enough to fill the screen.
  const std::array<float, 16> projection{1.0f, 0, 0, 0, 0, 1.0f, 0, 0, 0, 0, -0.5f, -0.5f, 0, 0, 0, 1.0f};
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadMatrixf(projection.data());
  gl.MatrixMode(GL_MODELVIEW);
  std::vector<ColoredVertex> quads = screens([](int layer, float x) {
    return -1.5f + 0.06f * static_cast<float>(layer) + 0.5f * (1.0f - x);
  });
  for (ColoredVertex& vertex : quads) {
    vertex.position[0] *= 2.0f;
    vertex.position[1] *= 2.0f;
  }
  return draw_quads(gl, std::move(quads));
}

/// Draws `vertices` in the order given, between one Begin and End, depth tested.
Frame colored_frame(GLenum mode, std::vector<ColoredVertex> vertices) {
  return [mode, vertices = std::move(vertices)](const GlTable& table) {
    table.Clear(color_and_depth);
    table.Begin(mode);
    for (const ColoredVertex& vertex : vertices) {
      table.Color3fv(vertex.color.data());
      table.Vertex3fv(vertex.position.data());
    }
    table.End();
  };
}

Vec3 random_color(Random& random) {
  const float red = random.next(), green = random.next();
  return {red, green, random.next()};
}

/// 100,000 lines of width 1 and 10 to 40 pixels, in every direction.
Frame lines(const GlTable& gl) {
  constexpr int count = 100'000;
  std::vector<ColoredVertex> vertices;
  Random random;
  for (int i = 0; i < count; ++i) {
    const float x = random.between(-3.4f, 3.4f), y = random.between(-1.9f, 1.9f), z = random.between(-5.0f, -4.0f);
    const float angle = random.between(0.0f, 2.0f * pi), length = random.between(0.04f, 0.16f);
    vertices.push_back({random_color(random), {x, y, z}});
    vertices.push_back({random_color(random), {x + length * std::cos(angle), y + length * std::sin(angle), z}});
  }
  set_camera(gl);
  gl.Enable(GL_DEPTH_TEST);
  return colored_frame(GL_LINES, std::move(vertices));
}

/// 500,000 points of size 1 all over the picture, each of its own colour and depth.
Frame points(const GlTable& gl) {
  constexpr int count = 500'000;
  std::vector<ColoredVertex> vertices;
  Random random;
  for (int i = 0; i < count; ++i) {
    const float x = random.between(-3.4f, 3.4f), y = random.between(-1.9f, 1.9f);
    vertices.push_back({random_color(random), {x, y, random.between(-5.0f, -4.0f)}});
  }
  set_camera(gl);
  gl.Enable(GL_DEPTH_TEST);
  return colored_frame(GL_POINTS, std::move(vertices));
}

/// 20,000 lit triangles, a change of state before each: of material, matrix, depth function or shade model in turn.
Frame state_changes(const GlTable& gl) {
  constexpr int draws = 20'000;
  std::vector<Vec3> centers;
  Random random;
  for (int i = 0; i < draws; ++i) {
    centers.push_back({random.between(-3.0f, 3.0f), random.between(-1.8f, 1.8f), random.between(-4.8f, -4.0f)});
  }
  set_camera(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  set_material(gl, {0.3f, 0.6f, 0.9f, 1.0f}, 0.0f);
  enable_light(gl, GL_LIGHT0, {0.3f, 0.5f, 1.0f, 0.0f}, {1.0f, 1.0f, 1.0f, 1.0f});
  return [centers = std::move(centers)](const GlTable& table) {
    table.Clear(color_and_depth);
    for (std::size_t i = 0; i < centers.size(); ++i) {
      const bool odd = (i / 4) % 2 != 0;
      switch (i % 4) {
        case 0: {
          const Vec4 diffuse{odd ? 0.9f : 0.3f, 0.6f, odd ? 0.3f : 0.9f, 1.0f};
          table.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse.data());
          break;
        }
        case 1:
          table.LoadIdentity();
          table.Translatef(odd ? 0.1f : -0.1f, 0.0f, 0.0f);
          break;
        case 2: table.DepthFunc(odd ? GL_LESS : GL_LEQUAL); break;
        default: table.ShadeModel(odd ? GL_SMOOTH : GL_FLAT); break;
      }
      const Vec3& center = centers[i];
      table.Begin(GL_TRIANGLES);
      table.Normal3f(0.0f, 0.6f, 0.8f);
      table.Vertex3f(center[0] - 0.02f, center[1] - 0.02f, center[2]);
      table.Normal3f(0.6f, 0.0f, 0.8f);
      table.Vertex3f(center[0] + 0.02f, center[1] - 0.02f, center[2]);
      table.Normal3f(0.0f, 0.0f, 1.0f);
      table.Vertex3f(center[0], center[1] + 0.02f, center[2]);
      table.End();
    }
  };
}

}  // namespace

const std::vector<Workload>& all_workloads() {
  static const std::vector<Workload> workloads = [] {
    std::vector<Workload> all{
        {"small_triangles", "200,000 small lit triangles", full_hd_width_px, full_hd_height_px, small_triangles},
        {"lit_sphere", "100,352-triangle sphere, 4 lights", full_hd_width_px, full_hd_height_px, lit_sphere},
        {"display_list", "the sphere as a display list, 1 light", full_hd_width_px, full_hd_height_px, display_list},
        {"indexed_sphere", "the same sphere by one DrawElements", full_hd_width_px, full_hd_height_px, indexed_sphere},
        {"layers_back_to_front", "20 Gouraud layers, back to front", full_hd_width_px, full_hd_height_px,
         layers_back_to_front},
        {"layers_front_to_back", "20 Gouraud layers, front to back", full_hd_width_px, full_hd_height_px,
         layers_front_to_back},
        {"layers_in_perspective", "20 Gouraud layers, perspective", full_hd_width_px, full_hd_height_px,
         layers_in_perspective},
        {"lines", "100,000 lines of width 1", full_hd_width_px, full_hd_height_px, lines},
        {"points", "500,000 points of size 1", full_hd_width_px, full_hd_height_px, points},
        {"state_changes", "20,000 draws, a state change each", full_hd_width_px, full_hd_height_px, state_changes},
    };
    for (const auto& more : {state_workloads(), texture_workloads(), pixel_workloads(), mirror_workload()}) {
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }();
  return workloads;
}

void draw_first_frame(const GlTable& gl) {
  gl.Enable(GL_DEPTH_TEST);
  gl.Clear(color_and_depth);
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(1.0f, 0.0f, 0.0f);
  gl.Vertex3f(-0.8f, -0.8f, 0.0f);
  gl.Color3f(0.0f, 1.0f, 0.0f);
  gl.Vertex3f(0.8f, -0.8f, 0.5f);
  gl.Color3f(0.0f, 0.0f, 1.0f);
  gl.Vertex3f(0.0f, 0.8f, -0.5f);
  gl.End();
}

}  // namespace gouraud::speed
