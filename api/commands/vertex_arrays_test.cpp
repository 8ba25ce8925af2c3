// Drawing from arrays gives the pipeline the same vertices as Begin and End do, whatever the arrays are made of
// [GL1.5 §2.8, §2.9].
#include "api/commands/vertex_arrays.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "api/commands/test_screen.h"
#include "api/context/context.h"

namespace gouraud::api {
namespace {

struct SeenVertex {
  std::array<float, 4> position, color;
  std::array<float, 3> normal;
  bool operator==(const SeenVertex&) const = default;
};

struct Recorder : pipeline::DrawObserver {
  std::vector<SeenVertex> vertices;
  std::vector<pipeline::PrimitiveMode> modes;
  void target_changed(const pipeline::Framebuffer&) override {}
  void clear(const pipeline::ClearState&) override {}
  void draw(const pipeline::DrawState&, const pipeline::VertexBatch& batch) override {
    for (const pipeline::PrimitiveRange& range : batch.primitives) modes.push_back(range.mode);
    pipeline::for_each_named_vertex(batch, [&](std::int32_t vertex) {
      const auto i = static_cast<std::size_t>(vertex);
      const auto &p = batch.position_object, &c = batch.color;
      const auto& n = batch.normal_object;
      vertices.push_back(
          {{p[0][i], p[1][i], p[2][i], p[3][i]}, {c[0][i], c[1][i], c[2][i], c[3][i]}, {n[0][i], n[1][i], n[2][i]}});
    });
  }
};

using Pointer = void (*)(GLint size, GLenum type, GLsizei stride, const void* pointer);
struct Form {
  GLenum array;
  GLint size;
  GLenum type;
  GLsizei bytes;
  Pointer pointer;
  void (*vector)(const void* values);  // the command that ArrayElement stands for
};

void normal_pointer(GLint, GLenum type, GLsizei stride, const void* pointer) {
  glNormalPointer(type, stride, pointer);
}
void index_pointer(GLint, GLenum type, GLsizei stride, const void* pointer) {
  glIndexPointer(type, stride, pointer);
}
void fog_pointer(GLint, GLenum type, GLsizei stride, const void* pointer) {
  glFogCoordPointer(type, stride, pointer);
}
void edge_pointer(GLint, GLenum, GLsizei stride, const void* pointer) {
  glEdgeFlagPointer(stride, pointer);
}

template <class T>
constexpr GLenum type_name() {
  if (std::is_same_v<T, GLbyte>) return GL_BYTE;
  if (std::is_same_v<T, GLubyte>) return GL_UNSIGNED_BYTE;
  if (std::is_same_v<T, GLshort>) return GL_SHORT;
  if (std::is_same_v<T, GLushort>) return GL_UNSIGNED_SHORT;
  if (std::is_same_v<T, GLint>) return GL_INT;
  if (std::is_same_v<T, GLuint>) return GL_UNSIGNED_INT;
  return std::is_same_v<T, GLfloat> ? GL_FLOAT : GL_DOUBLE;
}

template <class T, void (*command)(const T*)>
Form form(GLenum array, GLint size, Pointer pointer) {
  return {array, size, type_name<T>(), size * static_cast<GLsizei>(sizeof(T)), pointer,
          [](const void* values) { command(static_cast<const T*>(values)); }};
}

const std::vector<Form>& drawn_forms() {
  static const std::vector<Form> forms = {
      form<GLshort, glVertex2sv>(GL_VERTEX_ARRAY, 2, glVertexPointer),
      form<GLint, glVertex2iv>(GL_VERTEX_ARRAY, 2, glVertexPointer),
      form<GLfloat, glVertex2fv>(GL_VERTEX_ARRAY, 2, glVertexPointer),
      form<GLdouble, glVertex2dv>(GL_VERTEX_ARRAY, 2, glVertexPointer),
      form<GLshort, glVertex3sv>(GL_VERTEX_ARRAY, 3, glVertexPointer),
      form<GLint, glVertex3iv>(GL_VERTEX_ARRAY, 3, glVertexPointer),
      form<GLfloat, glVertex3fv>(GL_VERTEX_ARRAY, 3, glVertexPointer),
      form<GLdouble, glVertex3dv>(GL_VERTEX_ARRAY, 3, glVertexPointer),
      form<GLshort, glVertex4sv>(GL_VERTEX_ARRAY, 4, glVertexPointer),
      form<GLint, glVertex4iv>(GL_VERTEX_ARRAY, 4, glVertexPointer),
      form<GLfloat, glVertex4fv>(GL_VERTEX_ARRAY, 4, glVertexPointer),
      form<GLdouble, glVertex4dv>(GL_VERTEX_ARRAY, 4, glVertexPointer),
      form<GLbyte, glNormal3bv>(GL_NORMAL_ARRAY, 3, normal_pointer),
      form<GLshort, glNormal3sv>(GL_NORMAL_ARRAY, 3, normal_pointer),
      form<GLint, glNormal3iv>(GL_NORMAL_ARRAY, 3, normal_pointer),
      form<GLfloat, glNormal3fv>(GL_NORMAL_ARRAY, 3, normal_pointer),
      form<GLdouble, glNormal3dv>(GL_NORMAL_ARRAY, 3, normal_pointer),
      form<GLbyte, glColor3bv>(GL_COLOR_ARRAY, 3, glColorPointer),
      form<GLubyte, glColor3ubv>(GL_COLOR_ARRAY, 3, glColorPointer),
      form<GLshort, glColor3sv>(GL_COLOR_ARRAY, 3, glColorPointer),
      form<GLushort, glColor3usv>(GL_COLOR_ARRAY, 3, glColorPointer),
      form<GLint, glColor3iv>(GL_COLOR_ARRAY, 3, glColorPointer),
      form<GLuint, glColor3uiv>(GL_COLOR_ARRAY, 3, glColorPointer),
      form<GLfloat, glColor3fv>(GL_COLOR_ARRAY, 3, glColorPointer),
      form<GLdouble, glColor3dv>(GL_COLOR_ARRAY, 3, glColorPointer),
      form<GLbyte, glColor4bv>(GL_COLOR_ARRAY, 4, glColorPointer),
      form<GLubyte, glColor4ubv>(GL_COLOR_ARRAY, 4, glColorPointer),
      form<GLshort, glColor4sv>(GL_COLOR_ARRAY, 4, glColorPointer),
      form<GLushort, glColor4usv>(GL_COLOR_ARRAY, 4, glColorPointer),
      form<GLint, glColor4iv>(GL_COLOR_ARRAY, 4, glColorPointer),
      form<GLuint, glColor4uiv>(GL_COLOR_ARRAY, 4, glColorPointer),
      form<GLfloat, glColor4fv>(GL_COLOR_ARRAY, 4, glColorPointer),
      form<GLdouble, glColor4dv>(GL_COLOR_ARRAY, 4, glColorPointer),
  };
  return forms;
}

const std::vector<Form>& other_forms() {
  static const std::vector<Form> forms = {
      form<GLbyte, glSecondaryColor3bv>(GL_SECONDARY_COLOR_ARRAY, 3, glSecondaryColorPointer),
      form<GLubyte, glSecondaryColor3ubv>(GL_SECONDARY_COLOR_ARRAY, 3, glSecondaryColorPointer),
      form<GLshort, glSecondaryColor3sv>(GL_SECONDARY_COLOR_ARRAY, 3, glSecondaryColorPointer),
      form<GLushort, glSecondaryColor3usv>(GL_SECONDARY_COLOR_ARRAY, 3, glSecondaryColorPointer),
      form<GLint, glSecondaryColor3iv>(GL_SECONDARY_COLOR_ARRAY, 3, glSecondaryColorPointer),
      form<GLuint, glSecondaryColor3uiv>(GL_SECONDARY_COLOR_ARRAY, 3, glSecondaryColorPointer),
      form<GLfloat, glSecondaryColor3fv>(GL_SECONDARY_COLOR_ARRAY, 3, glSecondaryColorPointer),
      form<GLdouble, glSecondaryColor3dv>(GL_SECONDARY_COLOR_ARRAY, 3, glSecondaryColorPointer),
      form<GLubyte, glIndexubv>(GL_INDEX_ARRAY, 1, index_pointer),
      form<GLshort, glIndexsv>(GL_INDEX_ARRAY, 1, index_pointer),
      form<GLint, glIndexiv>(GL_INDEX_ARRAY, 1, index_pointer),
      form<GLfloat, glIndexfv>(GL_INDEX_ARRAY, 1, index_pointer),
      form<GLdouble, glIndexdv>(GL_INDEX_ARRAY, 1, index_pointer),
      form<GLfloat, glFogCoordfv>(GL_FOG_COORD_ARRAY, 1, fog_pointer),
      form<GLdouble, glFogCoorddv>(GL_FOG_COORD_ARRAY, 1, fog_pointer),
      form<GLboolean, glEdgeFlagv>(GL_EDGE_FLAG_ARRAY, 1, edge_pointer),
      form<GLshort, glTexCoord1sv>(GL_TEXTURE_COORD_ARRAY, 1, glTexCoordPointer),
      form<GLint, glTexCoord2iv>(GL_TEXTURE_COORD_ARRAY, 2, glTexCoordPointer),
      form<GLfloat, glTexCoord3fv>(GL_TEXTURE_COORD_ARRAY, 3, glTexCoordPointer),
      form<GLdouble, glTexCoord4dv>(GL_TEXTURE_COORD_ARRAY, 4, glTexCoordPointer),
  };
  return forms;
}

class VertexArrays : public ::testing::Test {
 protected:
  static constexpr int elements = 40;

  void SetUp() override {
    ASSERT_TRUE(context.set_window_size(16, 16, pipeline::ColorFormat::rgba8));
    make_current(&context);
    context.renderer().set_observer(&recorder);
    glEnable(GL_LIGHTING);  // so that normals and colours are demanded
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glColor3f(0.25f, 0.5f, 0.75f);
    glNormal3f(0.0f, 0.6f, 0.8f);
  }
  void TearDown() override {
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    make_current(nullptr);
  }

  // `elements` elements of finite values.
  std::vector<std::byte> random_array(const Form& form, GLsizei stride) {
    std::vector<std::byte> bytes(static_cast<std::size_t>(stride) * elements);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() & 0xFF);
    for (std::size_t e = 0; e < elements; ++e) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(form.size); ++c) {
        std::byte* const at = bytes.data() + e * static_cast<std::size_t>(stride);
        const double value = static_cast<double>(random() % 2000) / 777.0 - 1.3;
        const auto as_float = static_cast<float>(value);
        if (form.type == GL_FLOAT) std::memcpy(at + c * sizeof as_float, &as_float, sizeof as_float);
        if (form.type == GL_DOUBLE) std::memcpy(at + c * sizeof value, &value, sizeof value);
      }
    }
    return bytes;
  }
  static void call(const Form& form, const std::vector<std::byte>& bytes, GLsizei stride, GLuint element) {
    alignas(32) std::array<std::byte, 32> aligned{};
    std::memcpy(aligned.data(), bytes.data() + element * static_cast<GLuint>(stride),
                static_cast<std::size_t>(form.bytes));
    form.vector(aligned.data());
  }
  std::vector<SeenVertex> seen() {
    context.flush_vertices();
    return std::exchange(recorder.vertices, {});
  }

  Recorder recorder;
  Context context{{}, nullptr};
  std::minstd_rand random{7};
};

TEST_F(VertexArrays, EveryFormDrawsAsItsCommand) {
  const std::vector<float> positions(elements * 3, 0.5f);
  const std::vector<GLuint> order = {3, 1, 4, 1, 5, 9, 2, 6, 5, 39, 0, 8};
  for (const Form& form : drawn_forms()) {
    for (const GLsizei stride : {0, form.bytes + 1, 64}) {
      SCOPED_TRACE(std::to_string(form.array) + " type " + std::to_string(form.type) + " size " +
                   std::to_string(form.size) + " stride " + std::to_string(stride));
      const GLsizei step = stride != 0 ? stride : form.bytes;
      const auto bytes = random_array(form, step);
      const bool is_position = form.array == GL_VERTEX_ARRAY;
      glColor3f(0.25f, 0.5f, 0.75f);
      glNormal3f(0.0f, 0.6f, 0.8f);
      glBegin(GL_TRIANGLES);
      for (const GLuint element : order) {
        call(form, bytes, step, element);
        if (!is_position) glVertex3f(0.5f, 0.5f, 0.5f);
      }
      glEnd();
      const std::vector<SeenVertex> expected = seen();
      ASSERT_EQ(expected.size(), order.size());

      glColor3f(0.25f, 0.5f, 0.75f);
      glNormal3f(0.0f, 0.6f, 0.8f);
      if (!is_position) {
        glVertexPointer(3, GL_FLOAT, 0, positions.data());
        glEnableClientState(GL_VERTEX_ARRAY);
      }
      form.pointer(form.size, form.type, stride, bytes.data());
      glEnableClientState(form.array);
      const auto count = static_cast<GLsizei>(order.size());
      const CurrentGroup before = context.state.current;
      glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, order.data());
      EXPECT_TRUE(context.state.current == before);
      EXPECT_TRUE(is_position || seen() == expected);
      if (is_position) {
        const auto drawn = seen();
        ASSERT_EQ(drawn.size(), expected.size());
        for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_EQ(drawn[i].position, expected[i].position);
      }
      glBegin(GL_TRIANGLES);
      for (const GLuint element : order) glArrayElement(static_cast<GLint>(element));
      glEnd();
      const auto one_by_one = seen();
      ASSERT_EQ(one_by_one.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(one_by_one[i].position, expected[i].position);
        EXPECT_TRUE(form.array != GL_NORMAL_ARRAY || one_by_one[i].normal == expected[i].normal);
        EXPECT_TRUE(form.array != GL_COLOR_ARRAY || one_by_one[i].color == expected[i].color);
      }
      glDisableClientState(form.array);
      glDisableClientState(GL_VERTEX_ARRAY);
    }
  }
}

TEST_F(VertexArrays, ArrayElementSetsEveryCurrentValue) {
  for (const Form& form : other_forms()) {
    SCOPED_TRACE(std::to_string(form.array) + " type " + std::to_string(form.type));
    const auto bytes = random_array(form, form.bytes + 3);
    form.pointer(form.size, form.type, form.bytes + 3, bytes.data());
    glEnableClientState(form.array);
    for (const GLuint element : {0u, 17u, 39u}) {
      const CurrentGroup before = context.state.current;
      call(form, bytes, form.bytes + 3, element);
      const CurrentGroup expected = context.state.current;
      context.state.current = before;
      glArrayElement(static_cast<GLint>(element));
      EXPECT_TRUE(context.state.current == expected);
    }
    glDisableClientState(form.array);
  }
}

TEST_F(VertexArrays, TextureCoordinatesHaveAnArrayAUnit) {
  const std::array<float, 2> first = {1, 2}, second = {3, 4};
  glTexCoordPointer(2, GL_FLOAT, 0, first.data());
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glClientActiveTexture(GL_TEXTURE5);
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
  glTexCoordPointer(2, GL_FLOAT, 0, second.data());
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  EXPECT_TRUE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
  GLint unit = 0;
  glGetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &unit);
  EXPECT_EQ(unit, GL_TEXTURE5);
  glArrayElement(0);
  EXPECT_EQ(context.state.current.texture_coordinates[0], glm::vec4(1, 2, 0, 1));
  EXPECT_EQ(context.state.current.texture_coordinates[5], glm::vec4(3, 4, 0, 1));
  void* pointer = nullptr;
  glGetPointerv(GL_TEXTURE_COORD_ARRAY_POINTER, &pointer);
  EXPECT_EQ(pointer, second.data());
}

// All ways to name the same vertices, in counts that fill many batches, for all modes.
TEST_F(VertexArrays, EveryDrawCommandGivesTheSamePrimitives) {
  constexpr GLsizei count = 5000;
  std::vector<float> positions;
  std::vector<GLubyte> colors;
  std::vector<GLushort> shorts;
  std::vector<GLuint> ints;
  for (GLsizei i = 0; i < count + 7; ++i) {
    for (int c = 0; c < 3; ++c) positions.push_back(static_cast<float>(random() % 1000) / 500.0f - 1.0f);
    for (int c = 0; c < 4; ++c) colors.push_back(static_cast<GLubyte>(random() & 0xFF));
  }
  for (GLsizei i = 0; i < count; ++i) {
    shorts.push_back(static_cast<GLushort>(i + 7));
    ints.push_back(static_cast<GLuint>(i + 7));
  }
  glVertexPointer(3, GL_FLOAT, 0, positions.data());
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
    glBegin(mode);
    for (std::size_t i = 7; i < count + 7; ++i) {
      glColor4ubv(&colors[4 * i]);
      glVertex3fv(&positions[3 * i]);
    }
    glEnd();
    const auto expected = seen();
    glDrawArrays(mode, 7, count);
    EXPECT_TRUE(seen() == expected) << mode;
    glDrawElements(mode, count, GL_UNSIGNED_SHORT, shorts.data());
    EXPECT_TRUE(seen() == expected) << mode;
    glDrawRangeElements(mode, 7, count + 6, count, GL_UNSIGNED_INT, ints.data());
    EXPECT_TRUE(seen() == expected) << mode;
    const GLint first[] = {0, 7, -1};
    const GLsizei counts[] = {0, count, 0};
    glMultiDrawArrays(mode, first, counts, 3);
    EXPECT_TRUE(seen() == expected) << mode;
    const void* const lists[] = {nullptr, ints.data(), nullptr};
    glMultiDrawElements(mode, counts, GL_UNSIGNED_INT, lists, 3);
    EXPECT_TRUE(seen() == expected) << mode;
  }
}

TEST_F(VertexArrays, InterleavedArraysAreThoseOfTheTable) {
  struct Layout {
    GLenum format;
    int texture, color, normal, vertex;  // values
    GLenum color_type;
    std::uintptr_t color_at, normal_at, vertex_at;  // bytes
    GLsizei stride;
  };
  const Layout layouts[] = {
      {GL_V2F, 0, 0, 0, 2, 0, 0, 0, 0, 8},
      {GL_V3F, 0, 0, 0, 3, 0, 0, 0, 0, 12},
      {GL_C4UB_V2F, 0, 4, 0, 2, GL_UNSIGNED_BYTE, 0, 0, 4, 12},
      {GL_C4UB_V3F, 0, 4, 0, 3, GL_UNSIGNED_BYTE, 0, 0, 4, 16},
      {GL_C3F_V3F, 0, 3, 0, 3, GL_FLOAT, 0, 0, 12, 24},
      {GL_N3F_V3F, 0, 0, 3, 3, 0, 0, 0, 12, 24},
      {GL_C4F_N3F_V3F, 0, 4, 3, 3, GL_FLOAT, 0, 16, 28, 40},
      {GL_T2F_V3F, 2, 0, 0, 3, 0, 0, 0, 8, 20},
      {GL_T4F_V4F, 4, 0, 0, 4, 0, 0, 0, 16, 32},
      {GL_T2F_C4UB_V3F, 2, 4, 0, 3, GL_UNSIGNED_BYTE, 8, 0, 12, 24},
      {GL_T2F_C3F_V3F, 2, 3, 0, 3, GL_FLOAT, 8, 0, 20, 32},
      {GL_T2F_N3F_V3F, 2, 0, 3, 3, 0, 0, 8, 20, 32},
      {GL_T2F_C4F_N3F_V3F, 2, 4, 3, 3, GL_FLOAT, 8, 24, 36, 48},
      {GL_T4F_C4F_N3F_V4F, 4, 4, 3, 4, GL_FLOAT, 16, 32, 44, 60},
  };
  const auto expect = [&](ArrayName name, int size, GLenum type, std::uintptr_t at, GLsizei stride) {
    const VertexArray& array = context.state.vertex_arrays.at(name);
    EXPECT_EQ(array.enabled, size > 0);
    if (size == 0) return;
    EXPECT_EQ(array.size, size);
    EXPECT_EQ(array.type, type);
    EXPECT_EQ(array.stride, stride);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.pointer), 4096 + at);
  };
  for (const Layout& layout : layouts) {
    for (const GLsizei stride : {0, 128}) {
      SCOPED_TRACE(layout.format);
      glEnableClientState(GL_EDGE_FLAG_ARRAY);
      glEnableClientState(GL_FOG_COORD_ARRAY);
      glInterleavedArrays(layout.format, stride, reinterpret_cast<const void*>(std::uintptr_t{4096}));
      const GLsizei step = stride != 0 ? stride : layout.stride;
      expect(array_texture_coordinates, layout.texture, GL_FLOAT, 0, step);
      expect(array_color, layout.color, layout.color_type, layout.color_at, step);
      expect(array_normal, layout.normal, GL_FLOAT, layout.normal_at, step);
      expect(array_vertex, layout.vertex, GL_FLOAT, layout.vertex_at, step);
      EXPECT_FALSE(glIsEnabled(GL_EDGE_FLAG_ARRAY));
      EXPECT_FALSE(glIsEnabled(GL_FOG_COORD_ARRAY));
    }
  }
}

TEST_F(VertexArrays, NullPointersDrawNothing) {
  glEnableClientState(GL_VERTEX_ARRAY);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const GLuint indices[3] = {0, 1, 2};
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, indices);
  EXPECT_TRUE(seen().empty());
  const std::array<float, 9> positions{};
  glVertexPointer(3, GL_FLOAT, 0, positions.data());
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, nullptr);
  EXPECT_TRUE(seen().empty());
  glEnableClientState(GL_COLOR_ARRAY);  // null: the current colour
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const auto drawn = seen();
  ASSERT_EQ(drawn.size(), 3u);
  EXPECT_EQ(drawn[2].color, (std::array<float, 4>{0.25f, 0.5f, 0.75f, 1.0f}));
}

TEST_F(VertexArrays, BadArgumentsGiveTheErrorAndChangeNothing) {
  const GLuint indices[3] = {0, 1, 2};
  const std::array<float, 9> positions{};
  glVertexPointer(3, GL_FLOAT, 0, positions.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  const auto expect_error = [&](GLenum error, const auto& call, int line) {
    const State before = context.state;
    call();
    EXPECT_EQ(glGetError(), error) << "line " << line;
    EXPECT_TRUE(context.state == before) << "line " << line;
    EXPECT_FALSE(context.inside_begin_end());
    EXPECT_TRUE(seen().empty()) << "line " << line;
  };
  const GLenum bad_enum = GL_INVALID_ENUM, bad_value = GL_INVALID_VALUE;
  for (const GLint size : {-1, 0, 1, 5}) {
    expect_error(bad_value, [&] { glVertexPointer(size, GL_FLOAT, 0, nullptr); }, __LINE__);
  }
  for (const GLint size : {0, 2, 5}) {
    expect_error(bad_value, [&] { glColorPointer(size, GL_FLOAT, 0, nullptr); }, __LINE__);
    expect_error(bad_value, [&] { glSecondaryColorPointer(size, GL_FLOAT, 0, nullptr); }, __LINE__);
  }
  for (const GLint size : {0, 5}) {
    expect_error(bad_value, [&] { glTexCoordPointer(size, GL_FLOAT, 0, nullptr); }, __LINE__);
  }
  for (const GLenum type : {GL_BYTE, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_2_BYTES, 0}) {
    expect_error(bad_enum, [&] { glVertexPointer(3, type, 0, nullptr); }, __LINE__);
    expect_error(bad_enum, [&] { glTexCoordPointer(3, type, 0, nullptr); }, __LINE__);
    expect_error(bad_enum, [&] { glFogCoordPointer(type, 0, nullptr); }, __LINE__);
    if (type != GL_BYTE) expect_error(bad_enum, [&] { glNormalPointer(type, 0, nullptr); }, __LINE__);
    if (type != GL_UNSIGNED_BYTE) expect_error(bad_enum, [&] { glIndexPointer(type, 0, nullptr); }, __LINE__);
  }
  expect_error(bad_enum, [] { glColorPointer(4, GL_2_BYTES, 0, nullptr); }, __LINE__);
  expect_error(bad_enum, [] { glSecondaryColorPointer(3, GL_BITMAP, 0, nullptr); }, __LINE__);
  expect_error(bad_value, [] { glVertexPointer(3, GL_FLOAT, -1, nullptr); }, __LINE__);
  expect_error(bad_value, [] { glNormalPointer(GL_FLOAT, -1, nullptr); }, __LINE__);
  expect_error(bad_value, [] { glEdgeFlagPointer(-1, nullptr); }, __LINE__);
  expect_error(bad_value, [] { glInterleavedArrays(GL_V3F, -1, nullptr); }, __LINE__);
  expect_error(bad_enum, [] { glInterleavedArrays(GL_V2F - 1, 0, nullptr); }, __LINE__);
  expect_error(bad_enum, [] { glInterleavedArrays(GL_T4F_C4F_N3F_V4F + 1, 0, nullptr); }, __LINE__);
  expect_error(bad_enum, [] { glEnableClientState(GL_LIGHTING); }, __LINE__);
  expect_error(bad_enum, [] { glDisableClientState(GL_LIGHTING); }, __LINE__);
  expect_error(bad_enum, [] { glClientActiveTexture(GL_TEXTURE8); }, __LINE__);
  void* pointer;
  expect_error(bad_enum, [&] { glGetPointerv(GL_VERTEX_ARRAY, &pointer); }, __LINE__);
  expect_error(bad_value, [] { glArrayElement(-1); }, __LINE__);
  expect_error(bad_enum, [] { glDrawArrays(GL_POLYGON + 1, 0, 3); }, __LINE__);
  expect_error(bad_value, [] { glDrawArrays(GL_TRIANGLES, -1, 3); }, __LINE__);
  expect_error(bad_value, [] { glDrawArrays(GL_TRIANGLES, 0, -1); }, __LINE__);
  expect_error(bad_enum, [&] { glDrawElements(GL_POLYGON + 1, 3, GL_UNSIGNED_INT, indices); }, __LINE__);
  expect_error(bad_enum, [&] { glDrawElements(GL_TRIANGLES, 3, GL_INT, indices); }, __LINE__);
  expect_error(bad_value, [&] { glDrawElements(GL_TRIANGLES, -3, GL_UNSIGNED_INT, indices); }, __LINE__);
  expect_error(bad_value, [&] { glDrawRangeElements(GL_TRIANGLES, 2, 1, 3, GL_UNSIGNED_INT, indices); }, __LINE__);
  expect_error(bad_enum, [&] { glDrawRangeElements(GL_TRIANGLES, 0, 2, 3, GL_FLOAT, indices); }, __LINE__);
  expect_error(bad_value, [] { glMultiDrawArrays(GL_TRIANGLES, nullptr, nullptr, -1); }, __LINE__);
  expect_error(bad_enum, [] { glMultiDrawArrays(GL_POLYGON + 1, nullptr, nullptr, 0); }, __LINE__);
  expect_error(bad_enum, [] { glMultiDrawElements(GL_TRIANGLES, nullptr, GL_INT, nullptr, 0); }, __LINE__);
  expect_error(bad_value, [] { glMultiDrawElements(GL_TRIANGLES, nullptr, GL_UNSIGNED_INT, nullptr, -1); }, __LINE__);
  expect_error(bad_value, [] { glLockArraysEXT(-1, 3); }, __LINE__);
  expect_error(bad_value, [] { glLockArraysEXT(0, 0); }, __LINE__);
  expect_error(GL_INVALID_OPERATION, [] { glUnlockArraysEXT(); }, __LINE__);
}

TEST_F(VertexArrays, InitialValuesAreThoseOfTheTable) {
  const struct {
    GLenum pname;
    GLint value;
  } initial[] = {{GL_VERTEX_ARRAY, 0},           {GL_VERTEX_ARRAY_SIZE, 4},    {GL_VERTEX_ARRAY_TYPE, GL_FLOAT},
                 {GL_VERTEX_ARRAY_STRIDE, 0},    {GL_COLOR_ARRAY_SIZE, 4},     {GL_SECONDARY_COLOR_ARRAY_SIZE, 3},
                 {GL_TEXTURE_COORD_ARRAY_SIZE, 4}, {GL_NORMAL_ARRAY_TYPE, GL_FLOAT}, {GL_INDEX_ARRAY_TYPE, GL_FLOAT},
                 {GL_FOG_COORD_ARRAY_TYPE, GL_FLOAT}, {GL_EDGE_FLAG_ARRAY_STRIDE, 0},
                 {GL_CLIENT_ACTIVE_TEXTURE, GL_TEXTURE0}, {GL_ARRAY_BUFFER_BINDING, 0},
                 {GL_ELEMENT_ARRAY_BUFFER_BINDING, 0},  {GL_VERTEX_ARRAY_BUFFER_BINDING, 0},
                 {GL_MAX_ELEMENTS_VERTICES, 3000}, {GL_MAX_ELEMENTS_INDICES, 3000}};
  for (const auto& [pname, value] : initial) {
    GLint got = -1;
    glGetIntegerv(pname, &got);
    EXPECT_EQ(got, value) << pname;
  }
}

TEST(CountedArrays, RememberTheirCountUntilAPointerWithoutOneComes) {  // [EXT_vertex_array]
  Screen screen;
  const GLfloat vertices[6] = {};
  GLint count = -1;
  glVertexPointerEXT(2, GL_FLOAT, 0, 3, vertices);
  glVertexPointerEXT(2, GL_FLOAT, 0, -1, vertices);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  glGetIntegerv(GL_VERTEX_ARRAY_COUNT_EXT, &count);
  EXPECT_EQ(count, 3);
  glVertexPointer(2, GL_FLOAT, 0, vertices);
  glGetIntegerv(GL_VERTEX_ARRAY_COUNT_EXT, &count);
  EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace gouraud::api
