// Contexts of several threads at once, which share display lists, textures and buffers: each draws what one thread alone
// draws. What the pictures do not show the preset tsan does.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "api/osmesa/testing/drivers.h"

namespace gouraud::api::testing {
namespace {

constexpr int side = 300, thread_count = 4;  // 25 tiles: enough for each context to wake threads of its own
constexpr std::uint32_t red = 0xFF0000FF, green = 0xFF00FF00;

/// A context of this thread with a picture, current until it is destroyed.
class Stage {
 public:
  explicit Stage(OSMesaContext share_with = nullptr)
      : context_(ours().CreateContextExt(OSMESA_RGBA, 24, 8, 0, share_with), {&ours()}) {
    enter();
  }
  ~Stage() { leave(); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void enter() {
    EXPECT_TRUE(ours().MakeCurrent(context_.get(), picture_.data(), GL_UNSIGNED_BYTE, side, side));
  }
  static void leave() { ours().MakeCurrent(nullptr, nullptr, 0, 0, 0); }
  OSMesaContext context() const { return context_.get(); }
  const std::vector<std::uint32_t>& finished_picture() const {
    ours().gl.Finish();
    return picture_;
  }

 private:
  std::vector<std::uint32_t> picture_ = std::vector<std::uint32_t>(side * side);
  OwnedContext context_;
};

/// Calls work(0) ... work(thread_count - 1), each in a thread, all at once.
void in_threads(const std::function<void(int)>& work) {
  std::vector<std::jthread> threads;
  for (int i = 0; i < thread_count; ++i) threads.emplace_back(work, i);
}

struct SharedObjects {
  GLuint texture = 0, buffer = 0, list = 0;
};

/// A texture with mipmaps, a buffer of 64 triangles, and a list of lit quads, in the current context.
SharedObjects make_objects() {
  const GlTable& gl = ours().gl;
  SharedObjects objects;
  gl.GenTextures(1, &objects.texture);
  gl.BindTexture(GL_TEXTURE_2D, objects.texture);
  std::vector<std::uint32_t> texels(64 * 64);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint32_t>(i * 2654435761u) | 0xFF000000u;
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());

  std::vector<std::array<float, 3>> corners;
  for (int i = 0; i < 64; ++i) {
    const float x = static_cast<float>(i % 8) / 4 - 1, y = static_cast<float>(i / 8) / 4 - 1;
    corners.insert(corners.end(), {{x, y, 0.5f}, {x + 0.2f, y, -0.5f}, {x, y + 0.2f, 0.0f}});
  }
  gl.GenBuffers(1, &objects.buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, objects.buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof corners[0]), corners.data(), GL_STATIC_DRAW);

  objects.list = gl.GenLists(1);
  gl.NewList(objects.list, GL_COMPILE);
  gl.Begin(GL_QUADS);
  for (int i = 0; i < 10; ++i) {
    const float z = static_cast<float>(i) / 10;
    gl.Normal3f(z, 0, 1);
    gl.TexCoord2f(0, z);
    gl.Vertex3f(-1, -1, z);
    gl.TexCoord2f(3, 0);
    gl.Vertex3f(1, -z, -z);
    gl.TexCoord2f(3, 3);
    gl.Vertex3f(z, 1, z);
    gl.TexCoord2f(0, 3);
    gl.Vertex3f(-1, z, -z);
  }
  gl.End();
  gl.EndList();
  gl.Finish();
  return objects;
}

/// Lit, textured (by what is bound, if the texture is 0), blended, from a list and from a buffer; `turn` makes pictures
/// that differ.
void draw_objects(const SharedObjects& objects, int turn) {
  const GlTable& gl = ours().gl;
  gl.ClearColor(0.2f, 0.1f, 0.3f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const GLenum capability : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE, GL_TEXTURE_2D, GL_BLEND}) gl.Enable(capability);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  if (objects.texture != 0) gl.BindTexture(GL_TEXTURE_2D, objects.texture);
  gl.LoadIdentity();
  gl.Rotatef(static_cast<float>(turn * 20), 0, 0, 1);
  gl.CallList(objects.list);
  gl.Disable(GL_LIGHTING);
  gl.Color4f(1, 0.5f, 0, 0.5f);
  gl.BindBuffer(GL_ARRAY_BUFFER, objects.buffer);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  gl.DrawArrays(GL_TRIANGLES, 0, 3 * 64);
}

TEST(ContextsInThreads, DrawTheSamePicturesFromSharedObjects) {
  constexpr int turns = 6;
  Stage owner;
  const SharedObjects objects = make_objects();
  std::vector<std::vector<std::uint32_t>> expected;
  for (int turn = 0; turn < turns; ++turn) {
    draw_objects(objects, turn);
    expected.push_back(owner.finished_picture());
  }
  EXPECT_NE(expected[0], expected[1]);
  Stage::leave();
  in_threads([&](int thread) {
    for (int round = 0; round < 2; ++round) {
      const Stage stage(owner.context());
      for (int i = 0; i < turns; ++i) {
        const int turn = (i + thread) % turns;
        draw_objects(objects, turn);
        ASSERT_EQ(stage.finished_picture(), expected[static_cast<std::size_t>(turn)]) << "thread " << thread << ", turn " << turn;
      }
    }
  });
}

TEST(ContextsInThreads, GetNamesThatNoOtherHas) {
  constexpr int rounds = 100;
  const Stage owner;
  std::array<std::vector<GLuint>, thread_count> lists, textures, buffers;
  in_threads([&](int thread) {
    const Stage stage(owner.context());
    const GlTable& gl = ours().gl;
    for (int i = 0; i < rounds; ++i) {
      const GLuint list = gl.GenLists(2);
      gl.NewList(list, GL_COMPILE);
      gl.EndList();
      gl.DeleteLists(list + 1, 1);
      std::array<GLuint, 2> texture{}, buffer{};
      gl.GenTextures(2, texture.data());
      gl.BindTexture(GL_TEXTURE_2D, texture[0]);
      gl.DeleteTextures(1, &texture[1]);
      gl.GenBuffers(2, buffer.data());
      gl.BindBuffer(GL_ARRAY_BUFFER, buffer[0]);
      gl.DeleteBuffers(1, &buffer[1]);
      lists[static_cast<std::size_t>(thread)].push_back(list);
      textures[static_cast<std::size_t>(thread)].push_back(texture[0]);
      buffers[static_cast<std::size_t>(thread)].push_back(buffer[0]);
    }
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  });
  for (const auto& names : {lists, textures, buffers}) {
    std::set<GLuint> all;
    for (const std::vector<GLuint>& of_thread : names) all.insert(of_thread.begin(), of_thread.end());
    EXPECT_EQ(all.size(), static_cast<std::size_t>(thread_count * rounds));
  }
  EXPECT_TRUE(ours().gl.IsList(lists[0].front()));
  EXPECT_TRUE(ours().gl.IsTexture(textures[1].back()));
  EXPECT_TRUE(ours().gl.IsBuffer(buffers[2].back()));
}

TEST(ContextsInThreads, CallAListWholeWhileAnotherRedefinesIt) {
  const Stage owner;
  const GlTable& gl = ours().gl;
  const GLuint list = gl.GenLists(1);
  const auto define = [&](float red_part, float green_part) {
    gl.NewList(list, GL_COMPILE);
    gl.Color3f(red_part, green_part, 0);
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= 100; ++i) {
      gl.Vertex2f(static_cast<float>(i) / 50 - 1, -1);
      gl.Vertex2f(static_cast<float>(i) / 50 - 1, 1);
    }
    gl.End();
    gl.EndList();
  };
  define(1, 0);
  std::atomic<int> callers{thread_count - 1};
  in_threads([&](int thread) {
    const Stage stage(owner.context());
    if (thread == 0) {
      for (int i = 0; callers > 0; ++i) define(static_cast<float>(i % 2), static_cast<float>((i + 1) % 2));
      return;
    }
    for (int i = 0; i < 20; ++i) {
      gl.Clear(GL_COLOR_BUFFER_BIT);
      gl.CallList(list);
      const std::vector<std::uint32_t>& picture = stage.finished_picture();
      EXPECT_TRUE(picture[0] == red || picture[0] == green) << std::hex << picture[0];
      EXPECT_TRUE(std::ranges::all_of(picture, [&](std::uint32_t pixel) { return pixel == picture[0]; }));
    }
    --callers;
  });
}

TEST(ContextsInThreads, KeepABoundTextureThatAnotherDeletes) {
  const Stage owner;
  const SharedObjects objects = make_objects();
  draw_objects(objects, 1);
  const std::vector<std::uint32_t> expected = owner.finished_picture();
  std::atomic<int> bound{0};
  in_threads([&](int thread) {
    const Stage stage(owner.context());
    ours().gl.BindTexture(GL_TEXTURE_2D, objects.texture);
    ++bound;
    while (bound < thread_count) std::this_thread::yield();
    if (thread == 0) return ours().gl.DeleteTextures(1, &objects.texture);
    for (int i = 0; i < 5; ++i) {
      draw_objects({0, objects.buffer, objects.list}, 1);  // to bind the name again might make a new texture
      EXPECT_EQ(stage.finished_picture(), expected);
    }
  });
  EXPECT_FALSE(ours().gl.IsTexture(objects.texture));
}

TEST(ContextsInThreads, GoFromThreadToThread) {
  Stage stage;
  const SharedObjects objects = make_objects();
  draw_objects(objects, 2);
  const std::vector<std::uint32_t> expected = stage.finished_picture();
  for (int i = 0; i < 3; ++i) {
    draw_objects(objects, i);  // left to be finished by leaving
    Stage::leave();
    std::jthread([&] {
      stage.enter();
      draw_objects(objects, 2);
      EXPECT_EQ(stage.finished_picture(), expected);
      Stage::leave();
    }).join();
    stage.enter();
  }
}

}  // namespace
}  // namespace gouraud::api::testing
