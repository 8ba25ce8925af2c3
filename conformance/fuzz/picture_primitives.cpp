// The primitives of random pictures, and the ways in which they reach the GL.
#include <array>

#include "conformance/fuzz/pictures.h"

namespace gouraud::conformance {
namespace {

struct Vertex {
  float texture[4], color[4], normal[3], position[4], secondary[3], fog;
  GLboolean edge;
};

/// Which attributes come with a vertex; the others keep their current values.
struct Sent {
  bool color, normal, texture, secondary, fog, edge;
};

class Primitives {
 public:
  explicit Primitives(Brush& brush) : b_(brush), gl_(brush.gl) {}

  void draw() {
    gl_.EdgeFlag(GL_TRUE);
    choose();
    switch (b_.below(8)) {
      case 0: return by_list();
      case 1: return by_arrays(false);
      case 2: return by_arrays(true);
      case 3: return by_elements();
      case 4: return by_mesh();
      case 5: return by_rectangle();
      default: return by_begin_end();
    }
  }

 private:
  void choose() {
    mode_ = b_.chance(4) ? b_.one_of({GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP})
                         : b_.one_of({GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON});
    sent_ = {!b_.chance(4), !b_.chance(3), !b_.chance(4), b_.chance(2), b_.chance(2), b_.chance(4)};
    // Mesa looks at the flags of strips and fans, too.
    if (mode_ != GL_TRIANGLES && mode_ != GL_QUADS && mode_ != GL_POLYGON) sent_.edge = false;
    // Distances of Mesa's are not divided by w.
    const bool homogeneous = b_.chance(6) && gl_.IsEnabled(GL_LIGHTING) == GL_FALSE && gl_.IsEnabled(GL_FOG) == GL_FALSE;
    vertices_.resize(static_cast<std::size_t>(4 + b_.below(9)));  // Mesa's lists draw incomplete quads
    for (Vertex& vertex : vertices_) {
      const Brush::Four color = b_.color(), secondary = b_.color();
      vertex.position[0] = b_.range(-1.1f, 1.1f);
      vertex.position[1] = b_.range(-1.1f, 1.1f);
      vertex.position[2] = b_.range(-0.95f, 0.95f);
      vertex.position[3] = homogeneous ? b_.range(0.6f, 2.0f) : 1.0f;
      for (int i = 0; i < 4; ++i) {
        vertex.color[i] = color.v[i];
        vertex.texture[i] = i == 3 ? 1.0f : b_.range(-0.5f, 1.5f);
      }
      for (int i = 0; i < 3; ++i) {
        vertex.normal[i] = b_.range(-1.0f, 1.0f);
        vertex.secondary[i] = secondary.v[i];
      }
      vertex.fog = b_.range(0.0f, 1.5f);
      vertex.edge = static_cast<GLboolean>(!b_.chance(3));
    }
  }

  void send(const Vertex& vertex) {
    if (sent_.color) gl_.Color4fv(vertex.color);
    if (sent_.normal) gl_.Normal3fv(vertex.normal);
    if (sent_.texture) {
      gl_.TexCoord4fv(vertex.texture);
      gl_.MultiTexCoord2f(GL_TEXTURE1, vertex.texture[1], vertex.texture[0]);
    }
    if (sent_.secondary) gl_.SecondaryColor3fv(vertex.secondary);
    if (sent_.fog) gl_.FogCoordf(vertex.fog);
    if (sent_.edge) gl_.EdgeFlag(vertex.edge);
    if (vertex.position[3] == 1.0f) {
      gl_.Vertex3fv(vertex.position);
    } else {
      gl_.Vertex4fv(vertex.position);
    }
  }

  void by_begin_end() {
    gl_.Begin(mode_);
    for (const Vertex& vertex : vertices_) send(vertex);
    gl_.End();
  }

  void by_list() {
    gl_.NewList(7, b_.chance(3) ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
    by_begin_end();
    gl_.EndList();
    if (b_.chance(2)) gl_.Rotatef(b_.range(-40.0f, 40.0f), 0.0f, 0.0f, 1.0f);
    gl_.CallList(7);
  }

  void point_at(const std::uint8_t* base) {
    const auto at = [base](std::size_t offset) { return static_cast<const void*>(base + offset); };
    constexpr GLsizei stride = sizeof(Vertex);
    const auto array = [this](GLenum name, bool sent) {
      if (sent) gl_.EnableClientState(name);
    };
    gl_.VertexPointer(vertices_[0].position[3] == 1.0f ? 3 : 4, GL_FLOAT, stride, at(offsetof(Vertex, position)));
    gl_.ColorPointer(4, GL_FLOAT, stride, at(offsetof(Vertex, color)));
    gl_.NormalPointer(GL_FLOAT, stride, at(offsetof(Vertex, normal)));
    gl_.SecondaryColorPointer(3, GL_FLOAT, stride, at(offsetof(Vertex, secondary)));
    gl_.FogCoordPointer(GL_FLOAT, stride, at(offsetof(Vertex, fog)));
    gl_.EdgeFlagPointer(stride, at(offsetof(Vertex, edge)));
    gl_.TexCoordPointer(4, GL_FLOAT, stride, at(offsetof(Vertex, texture)));
    array(GL_VERTEX_ARRAY, true);
    array(GL_COLOR_ARRAY, sent_.color);
    array(GL_NORMAL_ARRAY, sent_.normal);
    array(GL_SECONDARY_COLOR_ARRAY, sent_.secondary);
    array(GL_FOG_COORD_ARRAY, sent_.fog);
    array(GL_EDGE_FLAG_ARRAY, sent_.edge);
    array(GL_TEXTURE_COORD_ARRAY, sent_.texture);
  }

  void by_arrays(bool in_buffer) {
    gl_.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    const auto* base = reinterpret_cast<const std::uint8_t*>(vertices_.data());
    if (in_buffer) {
      gl_.BindBuffer(GL_ARRAY_BUFFER, 5);
      gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), base, GL_STATIC_DRAW);
      base = nullptr;
    }
    point_at(base);
    const auto count = static_cast<GLsizei>(vertices_.size());
    if (b_.chance(3)) {
      gl_.Begin(mode_);
      for (GLint i = 0; i < count; ++i) gl_.ArrayElement(i);
      gl_.End();
    } else {
      gl_.DrawArrays(mode_, 0, count);
    }
    if (in_buffer) gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl_.PopClientAttrib();
  }

  void by_elements() {
    gl_.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    point_at(reinterpret_cast<const std::uint8_t*>(vertices_.data()));
    std::array<GLushort, 16> indices{};
    const int count = 3 + b_.below(13);
    for (GLushort& index : indices) index = static_cast<GLushort>(b_.below(static_cast<int>(vertices_.size())));
    gl_.DrawElements(mode_, count, GL_UNSIGNED_SHORT, indices.data());
    gl_.PopClientAttrib();
  }

  void by_rectangle() {
    if (sent_.color) gl_.Color4fv(vertices_[0].color);
    gl_.Rectf(vertices_[0].position[0], vertices_[0].position[1], vertices_[1].position[0], vertices_[1].position[1]);
  }

  void by_mesh() {
    constexpr int order = 3;
    std::array<std::array<float, 4>, order * order> points{}, colors{}, normals{}, textures{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float x = static_cast<float>(i % order) - 1.0f, y = static_cast<float>(i / order) - 1.0f;
      points[i] = {0.8f * x + b_.range(-0.2f, 0.2f), 0.8f * y + b_.range(-0.2f, 0.2f), b_.range(-0.9f, 0.9f), 1.0f};
      const Brush::Four color = b_.color();
      for (std::size_t j = 0; j < 4; ++j) colors[i][j] = color.v[j];
      normals[i] = {b_.range(-1.0f, 1.0f), b_.range(-1.0f, 1.0f), b_.range(0.2f, 1.0f), 0.0f};
      textures[i] = {b_.range(0.0f, 1.0f), b_.range(0.0f, 1.0f), 0.0f, 1.0f};
    }
    gl_.PushAttrib(GL_EVAL_BIT | GL_ENABLE_BIT | GL_LIGHTING_BIT | GL_POLYGON_BIT);
    gl_.ShadeModel(GL_SMOOTH);  // Mesa's meshes are of triangles, which shows here
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    const auto map = [this](GLenum target, const std::array<std::array<float, 4>, order * order>& values) {
      gl_.Map2f(target, 0.0f, 1.0f, 4, order, 0.0f, 1.0f, 4 * order, order, values[0].data());
      gl_.Enable(target);
    };
    map(b_.chance(2) ? GL_MAP2_VERTEX_3 : GL_MAP2_VERTEX_4, points);
    if (sent_.color) map(GL_MAP2_COLOR_4, colors);
    if (sent_.normal) {
      map(GL_MAP2_NORMAL, normals);
    } else {
      gl_.Enable(GL_AUTO_NORMAL);
    }
    if (sent_.texture) map(GL_MAP2_TEXTURE_COORD_2, textures);
    gl_.MapGrid2f(4, 0.0f, 1.0f, 3, 0.0f, 1.0f);
    gl_.EvalMesh2(b_.chance(4) ? GL_LINE : GL_FILL, 0, 4, 0, 3);
    gl_.PopAttrib();
    // Mesa's evaluators leave their values behind as the current ones, against the specification [GL1.5 §5.1].
    gl_.Color4f(1.0f, 1.0f, 1.0f, 1.0f);
    gl_.Normal3f(0.0f, 0.0f, 1.0f);
    gl_.TexCoord3f(0.3f, 0.6f, 0.8f);
  }

  Brush& b_;
  const GlTable& gl_;
  GLenum mode_ = 0;
  Sent sent_{};
  std::vector<Vertex> vertices_;
};

}  // namespace

void draw_primitives(Brush& brush) {
  for (int i = brush.below(3); i >= 0; --i) Primitives(brush).draw();
}

}  // namespace gouraud::conformance
