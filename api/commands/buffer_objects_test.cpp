// Buffer objects hold what they are given, and nothing beyond their ends is read [GL1.5 §2.9]. For the sanitizers, too.
#include "api/commands/buffer_objects.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "api/commands/attribute_stacks.h"
#include "api/commands/draw_arrays.h"
#include "api/commands/vertex_arrays.h"

namespace gouraud::api {
namespace {

constexpr GLenum no_error = GL_NO_ERROR;

const void* offset(std::uintptr_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

struct Positions : pipeline::DrawObserver {
  std::vector<std::array<float, 4>> seen;
  void target_changed(const pipeline::Framebuffer&) override {}
  void clear(const pipeline::ClearState&) override {}
  void draw(const pipeline::DrawState&, const pipeline::VertexBatch& batch) override {
    const auto& p = batch.position_object;
    pipeline::for_each_named_vertex(batch, [&](std::int32_t vertex) {
      const auto i = static_cast<std::size_t>(vertex);
      seen.push_back({p[0][i], p[1][i], p[2][i], p[3][i]});
    });
  }
};

class BufferObjects : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(c.set_window_size(8, 8, pipeline::ColorFormat::rgba8));
    c.renderer().set_observer(&positions);
  }
  void TearDown() override { EXPECT_EQ(c.take_error(), no_error); }

  GLuint buffer(GLenum target, std::size_t size, const void* data) {
    GLuint name = 0;
    GenBuffers(c, 1, &name);
    BindBuffer(c, target, name);
    BufferData(c, target, static_cast<GLsizeiptr>(size), data, GL_STATIC_DRAW);
    return name;
  }
  std::vector<std::array<float, 4>> drawn() {
    c.flush_vertices();
    return std::exchange(positions.seen, {});
  }
  GLint parameter(GLenum target, GLenum pname) {
    GLint value = -1;
    GetBufferParameteriv(c, target, pname, &value);
    return value;
  }
  void expect_error(GLenum error, int line) { EXPECT_EQ(c.take_error(), error) << "line " << line; }

  Positions positions;
  Context c{{}, nullptr};
};

constexpr std::array<float, 8> four_points = {1, 2, 3, 4, 5, 6, 7, 8};  // as VertexPointer(2, ...)

TEST_F(BufferObjects, NamesExistOnceTheyAreBound) {
  GLuint names[3] = {};
  BindBuffer(c, GL_ARRAY_BUFFER, 2);  // a name of the program's own
  GenBuffers(c, 3, names);
  EXPECT_EQ((std::array{names[0], names[1], names[2]}), (std::array<GLuint, 3>{1, 3, 4}));
  EXPECT_TRUE(IsBuffer(c, 2));
  EXPECT_FALSE(IsBuffer(c, 1));
  EXPECT_FALSE(IsBuffer(c, 0));
  BindBuffer(c, GL_ELEMENT_ARRAY_BUFFER, 1);
  EXPECT_TRUE(IsBuffer(c, 1));
  const GLuint gone[] = {1, 0, 77, 2};
  DeleteBuffers(c, 4, gone);
  EXPECT_FALSE(IsBuffer(c, 1));
  EXPECT_EQ(c.state.vertex_arrays.array_buffer, nullptr);
  EXPECT_EQ(c.state.vertex_arrays.element_array_buffer, nullptr);
}

TEST_F(BufferObjects, KeepAndGiveBackBytes) {
  std::array<std::uint8_t, 10> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i);
  buffer(GL_ARRAY_BUFFER, bytes.size(), bytes.data());
  BufferSubData(c, GL_ARRAY_BUFFER, 3, 2, "ab");
  BufferSubData(c, GL_ARRAY_BUFFER, 10, 0, nullptr);
  std::array<std::uint8_t, 4> part{};
  GetBufferSubData(c, GL_ARRAY_BUFFER, 2, 4, part.data());
  EXPECT_EQ(part, (std::array<std::uint8_t, 4>{2, 'a', 'b', 5}));
  auto* const mapped = static_cast<std::uint8_t*>(MapBuffer(c, GL_ARRAY_BUFFER, GL_READ_ONLY));
  ASSERT_NE(mapped, nullptr);
  EXPECT_EQ(mapped[9], 9);
  EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED), GL_TRUE);
  EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_ACCESS), GL_READ_ONLY);
  void* pointer = nullptr;
  GetBufferPointerv(c, GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
  EXPECT_EQ(pointer, mapped);
  EXPECT_TRUE(UnmapBuffer(c, GL_ARRAY_BUFFER));
  GetBufferPointerv(c, GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
  EXPECT_EQ(pointer, nullptr);
  MapBuffer(c, GL_ARRAY_BUFFER, GL_WRITE_ONLY);
  BufferData(c, GL_ARRAY_BUFFER, 5, nullptr, GL_STREAM_COPY);  // unmaps
  EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_SIZE), 5);
  EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_USAGE), GL_STREAM_COPY);
  EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_ACCESS), GL_READ_WRITE);
  EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED), GL_FALSE);
}

TEST_F(BufferObjects, ArraysRememberTheirBuffer) {
  const GLuint name = buffer(GL_ARRAY_BUFFER, sizeof four_points, four_points.data());
  VertexPointer(c, 2, GL_FLOAT, 0, offset(8));
  EnableClientState(c, GL_VERTEX_ARRAY);
  BindBuffer(c, GL_ARRAY_BUFFER, 0);
  const GLubyte indices[] = {2, 0};
  DrawElements(c, GL_POINTS, 2, GL_UNSIGNED_BYTE, indices);
  EXPECT_EQ(drawn(), (std::vector<std::array<float, 4>>{{7, 8, 0, 1}, {3, 4, 0, 1}}));
  EXPECT_EQ(name_of(c.state.vertex_arrays.at(array_vertex).buffer), name);
  const GLushort shorts[] = {9, 1, 2};
  buffer(GL_ELEMENT_ARRAY_BUFFER, sizeof shorts, shorts);
  DrawElements(c, GL_POINTS, 2, GL_UNSIGNED_SHORT, offset(2));
  EXPECT_EQ(drawn(), (std::vector<std::array<float, 4>>{{5, 6, 0, 1}, {7, 8, 0, 1}}));
}

TEST_F(BufferObjects, NothingBeyondTheirEndsIsRead) {
  buffer(GL_ARRAY_BUFFER, sizeof four_points, four_points.data());
  VertexPointer(c, 2, GL_FLOAT, 0, nullptr);
  EnableClientState(c, GL_VERTEX_ARRAY);
  const std::array<float, 4> zero = {0, 0, 0, 1}, last = {7, 8, 0, 1};
  const GLuint far[] = {3, 4, 0x7FFFFFFF, 0xFFFFFFFF};
  DrawElements(c, GL_POINTS, 4, GL_UNSIGNED_INT, far);
  EXPECT_EQ(drawn(), (std::vector{last, zero, zero, zero}));
  DrawArrays(c, GL_POINTS, 3, std::numeric_limits<GLsizei>::max());
  EXPECT_EQ(drawn(), (std::vector{last}));
  DrawArrays(c, GL_POINTS, std::numeric_limits<GLint>::max(), std::numeric_limits<GLsizei>::max());
  EXPECT_TRUE(drawn().empty());
  const GLuint name = buffer(GL_ELEMENT_ARRAY_BUFFER, sizeof far, far);
  DrawElements(c, GL_POINTS, std::numeric_limits<GLsizei>::max(), GL_UNSIGNED_INT, nullptr);
  EXPECT_EQ(drawn().size(), 4u);
  DrawElements(c, GL_POINTS, 9, GL_UNSIGNED_INT, offset(13));  // no whole index left
  DrawElements(c, GL_POINTS, 9, GL_UNSIGNED_INT, offset(std::numeric_limits<std::uintptr_t>::max()));
  EXPECT_TRUE(drawn().empty());
  BindBuffer(c, GL_ELEMENT_ARRAY_BUFFER, 0);
  DeleteBuffers(c, 1, &name);

  // Every odd place and stride of every array.
  for (const GLsizei stride : {0, 1, 7, std::numeric_limits<GLsizei>::max()}) {
    for (const std::uintptr_t at : {std::uintptr_t{0}, std::uintptr_t{25}, std::uintptr_t{32}, std::uintptr_t{33},
                                    std::numeric_limits<std::uintptr_t>::max()}) {
      VertexPointer(c, 4, GL_DOUBLE, stride, offset(at));
      ColorPointer(c, 4, GL_DOUBLE, stride, offset(at));
      EnableClientState(c, GL_COLOR_ARRAY);
      DrawElements(c, GL_TRIANGLES, 4, GL_UNSIGNED_INT, far);
      DrawArrays(c, GL_TRIANGLES, 0, 40);
      for (const GLint i : {0, 1, 31, 0x7FFFFFFF}) ArrayElement(c, i);
    }
  }
}

TEST_F(BufferObjects, DrawsFromADeletedBufferReadNothing) {
  const GLuint name = buffer(GL_ARRAY_BUFFER, sizeof four_points, four_points.data());
  VertexPointer(c, 2, GL_FLOAT, 0, offset(8));
  EnableClientState(c, GL_VERTEX_ARRAY);
  PushClientAttrib(c, GL_CLIENT_VERTEX_ARRAY_BIT);
  DeleteBuffers(c, 1, &name);
  DrawArrays(c, GL_POINTS, 0, 2);
  EXPECT_TRUE(drawn().empty());
  PopClientAttrib(c);
  DrawArrays(c, GL_POINTS, 0, 1);
  EXPECT_EQ(drawn(), (std::vector<std::array<float, 4>>{{3, 4, 0, 1}}));
}

TEST_F(BufferObjects, MappedBuffersAreNotDrawnFrom) {
  buffer(GL_ARRAY_BUFFER, sizeof four_points, four_points.data());
  VertexPointer(c, 2, GL_FLOAT, 0, nullptr);
  EnableClientState(c, GL_VERTEX_ARRAY);
  MapBuffer(c, GL_ARRAY_BUFFER, GL_WRITE_ONLY);
  const GLubyte index = 0;
  DrawArrays(c, GL_POINTS, 0, 1);
  expect_error(GL_INVALID_OPERATION, __LINE__);
  DrawElements(c, GL_POINTS, 1, GL_UNSIGNED_BYTE, &index);
  expect_error(GL_INVALID_OPERATION, __LINE__);
  ArrayElement(c, 0);
  expect_error(GL_INVALID_OPERATION, __LINE__);
  UnmapBuffer(c, GL_ARRAY_BUFFER);
  buffer(GL_ELEMENT_ARRAY_BUFFER, 1, &index);
  MapBuffer(c, GL_ELEMENT_ARRAY_BUFFER, GL_READ_WRITE);
  DrawElements(c, GL_POINTS, 1, GL_UNSIGNED_BYTE, nullptr);
  expect_error(GL_INVALID_OPERATION, __LINE__);
  DrawArrays(c, GL_POINTS, 0, 1);
  EXPECT_EQ(drawn().size(), 1u);
}

TEST_F(BufferObjects, AreSharedBetweenContexts) {
  const GLuint name = buffer(GL_ARRAY_BUFFER, 12, nullptr);
  Context other({}, &c);
  EXPECT_TRUE(IsBuffer(other, name));
  BindBuffer(other, GL_ARRAY_BUFFER, name);
  DeleteBuffers(c, 1, &name);
  BufferSubData(other, GL_ARRAY_BUFFER, 0, 12, four_points.data());
  EXPECT_EQ(other.take_error(), no_error);
}

TEST_F(BufferObjects, BadArgumentsGiveTheError) {
  std::array<char, 16> bytes{};
  void* pointer = nullptr;
  GLint value = 0;
  GenBuffers(c, -1, nullptr);
  expect_error(GL_INVALID_VALUE, __LINE__);
  DeleteBuffers(c, -1, nullptr);
  expect_error(GL_INVALID_VALUE, __LINE__);
  BindBuffer(c, GL_TEXTURE_2D, 1);
  expect_error(GL_INVALID_ENUM, __LINE__);
  for (const GLenum error : {GLenum{GL_INVALID_ENUM}, GLenum{GL_INVALID_OPERATION}}) {  // no target, nothing bound
    const GLenum target = error == GL_INVALID_ENUM ? GLenum{GL_TEXTURE_2D} : GLenum{GL_ARRAY_BUFFER};
    BufferData(c, target, 4, nullptr, GL_STATIC_DRAW);
    expect_error(error, __LINE__);
    BufferSubData(c, target, 0, 4, bytes.data());
    expect_error(error, __LINE__);
    GetBufferSubData(c, target, 0, 4, bytes.data());
    expect_error(error, __LINE__);
    EXPECT_EQ(MapBuffer(c, target, GL_READ_ONLY), nullptr);
    expect_error(error, __LINE__);
    EXPECT_FALSE(UnmapBuffer(c, target));
    expect_error(error, __LINE__);
    GetBufferParameteriv(c, target, GL_BUFFER_SIZE, &value);
    expect_error(error, __LINE__);
    GetBufferPointerv(c, target, GL_BUFFER_MAP_POINTER, &pointer);
    expect_error(error, __LINE__);
  }
  buffer(GL_ARRAY_BUFFER, 8, nullptr);
  BufferData(c, GL_ARRAY_BUFFER, 4, nullptr, GL_READ_ONLY);
  expect_error(GL_INVALID_ENUM, __LINE__);
  BufferData(c, GL_ARRAY_BUFFER, -4, nullptr, GL_STATIC_DRAW);
  expect_error(GL_INVALID_VALUE, __LINE__);
  EXPECT_THROW(BufferData(c, GL_ARRAY_BUFFER, GLsizeiptr{1} << 40, nullptr, GL_STATIC_DRAW), std::bad_alloc);
  EXPECT_EQ(parameter(GL_ARRAY_BUFFER, GL_BUFFER_SIZE), 8);
  constexpr auto most = std::numeric_limits<GLintptr>::max();
  const struct {
    GLintptr offset;
    GLsizeiptr size;
  } ranges[] = {{-1, 2}, {0, -1}, {0, 9}, {8, 1}, {9, 0}, {most, most}, {1, most}};
  for (const auto& range : ranges) {
    BufferSubData(c, GL_ARRAY_BUFFER, range.offset, range.size, bytes.data());
    expect_error(GL_INVALID_VALUE, __LINE__);
    GetBufferSubData(c, GL_ARRAY_BUFFER, range.offset, range.size, bytes.data());
    expect_error(GL_INVALID_VALUE, __LINE__);
  }
  EXPECT_EQ(MapBuffer(c, GL_ARRAY_BUFFER, GL_STATIC_DRAW), nullptr);
  expect_error(GL_INVALID_ENUM, __LINE__);
  EXPECT_FALSE(UnmapBuffer(c, GL_ARRAY_BUFFER));
  expect_error(GL_INVALID_OPERATION, __LINE__);
  MapBuffer(c, GL_ARRAY_BUFFER, GL_READ_ONLY);
  EXPECT_EQ(MapBuffer(c, GL_ARRAY_BUFFER, GL_READ_ONLY), nullptr);
  expect_error(GL_INVALID_OPERATION, __LINE__);
  BufferSubData(c, GL_ARRAY_BUFFER, 0, 4, bytes.data());
  expect_error(GL_INVALID_OPERATION, __LINE__);
  GetBufferSubData(c, GL_ARRAY_BUFFER, 0, 4, bytes.data());
  expect_error(GL_INVALID_OPERATION, __LINE__);
  GetBufferParameteriv(c, GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &value);
  expect_error(GL_INVALID_ENUM, __LINE__);
  GetBufferPointerv(c, GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &pointer);
  expect_error(GL_INVALID_ENUM, __LINE__);
  buffer(GL_ARRAY_BUFFER, 0, nullptr);
  EXPECT_EQ(MapBuffer(c, GL_ARRAY_BUFFER, GL_READ_ONLY), nullptr);
  expect_error(GL_OUT_OF_MEMORY, __LINE__);
}

}  // namespace
}  // namespace gouraud::api
