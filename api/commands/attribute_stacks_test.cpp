// Every group comes back when its bit was pushed, and only then [GL1.5 §6.1.14].
#include "api/commands/attribute_stacks.h"

#include <gtest/gtest.h>

#include "api/commands/accumulation.h"
#include "api/commands/begin_end.h"
#include "api/commands/buffer_selection.h"
#include "api/commands/current_values.h"
#include "api/commands/enables.h"
#include "api/commands/evaluators.h"
#include "api/commands/flush_and_hints.h"
#include "api/commands/framebuffer_control.h"
#include "api/commands/lighting.h"
#include "api/commands/matrices.h"
#include "api/commands/pixel_store.h"
#include "api/commands/raster_position.h"
#include "api/commands/rasterization.h"
#include "api/commands/stencil.h"
#include "api/commands/vertex_arrays.h"
#include "api/commands/viewport.h"
#include "api/snapshot/snapshot.h"

namespace gouraud::api {
namespace {

constexpr GLenum no_error = GL_NO_ERROR;

struct Change {
  GLbitfield bit;
  bool enable;  // an enable, which ENABLE_BIT restores as well
  void (*change)(Context& c);
};

const Change changes[] = {
    {GL_CURRENT_BIT, false, [](Context& c) { Color4f(c, 0, 0.5f, 1, 0); }},
    {GL_CURRENT_BIT, false, [](Context& c) { MultiTexCoord4f(c, GL_TEXTURE3, 1, 2, 3, 4); }},
    {GL_CURRENT_BIT, false, [](Context& c) { EdgeFlag(c, GL_FALSE); }},
    {GL_POINT_BIT, false, [](Context& c) { PointSize(c, 7); }},
    {GL_LINE_BIT, false, [](Context& c) { LineWidth(c, 7); }},
    {GL_POLYGON_BIT, false, [](Context& c) { PolygonMode(c, GL_FRONT, GL_LINE); }},
    {GL_POLYGON_BIT, true, [](Context& c) { Enable(c, GL_CULL_FACE); }},
    {GL_LIGHTING_BIT, false, [](Context& c) { ShadeModel(c, GL_FLAT); }},
    {GL_LIGHTING_BIT, true, [](Context& c) { Enable(c, GL_LIGHTING); }},
    {GL_LIGHTING_BIT, true, [](Context& c) { Enable(c, GL_LIGHT5); }},
    {GL_LIGHTING_BIT, true, [](Context& c) { Enable(c, GL_COLOR_MATERIAL); }},
    {GL_DEPTH_BUFFER_BIT, false, [](Context& c) { DepthFunc(c, GL_GREATER); }},
    {GL_DEPTH_BUFFER_BIT, true, [](Context& c) { Enable(c, GL_DEPTH_TEST); }},
    {GL_POINT_BIT, false, [](Context& c) { c.state.point.coord_replace ^= 1; }},
    {GL_STENCIL_BUFFER_BIT, false, [](Context& c) { ClearStencil(c, 3); }},
    {GL_STENCIL_BUFFER_BIT, false, [](Context& c) { StencilFunc(c, GL_LESS, 1, 2); }},
    {GL_STENCIL_BUFFER_BIT, false, [](Context& c) { StencilOpSeparateATI(c, GL_BACK, GL_ZERO, GL_INCR, GL_DECR_WRAP); }},
    {GL_STENCIL_BUFFER_BIT, false, [](Context& c) { ActiveStencilFaceEXT(c, GL_BACK); }},
    {GL_STENCIL_BUFFER_BIT, true, [](Context& c) { Enable(c, GL_STENCIL_TEST); }},
    {GL_STENCIL_BUFFER_BIT, true, [](Context& c) { Enable(c, GL_STENCIL_TEST_TWO_SIDE_EXT); }},
    {GL_ACCUM_BUFFER_BIT, false, [](Context& c) { ClearAccum(c, 1, 0, -1, 0); }},
    {GL_VIEWPORT_BIT, false, [](Context& c) { Viewport(c, 1, 2, 3, 4); }},
    {GL_VIEWPORT_BIT, false, [](Context& c) { DepthRange(c, 0.5, 0.25); }},
    {GL_TRANSFORM_BIT, false, [](Context& c) { MatrixMode(c, GL_TEXTURE); }},
    {GL_TRANSFORM_BIT, true, [](Context& c) { Enable(c, GL_NORMALIZE); }},
    {GL_COLOR_BUFFER_BIT, false, [](Context& c) { ColorMask(c, GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE); }},
    {GL_COLOR_BUFFER_BIT, true, [](Context& c) { Disable(c, GL_DITHER); }},
    {GL_HINT_BIT, false, [](Context& c) { Hint(c, GL_FOG_HINT, GL_NICEST); }},
    {GL_EVAL_BIT, false, [](Context& c) { MapGrid1f(c, 7, 0, 1); }},
    {GL_EVAL_BIT, true, [](Context& c) { Enable(c, GL_AUTO_NORMAL); }},
    {GL_CURRENT_BIT, false, [](Context& c) { WindowPos3f(c, 1, 2, 3); }},
    {GL_TEXTURE_BIT, false, [](Context& c) { ActiveTexture(c, GL_TEXTURE2); }},
    {GL_SCISSOR_BIT, false, [](Context& c) { Scissor(c, 1, 2, 3, 4); }},
    {GL_SCISSOR_BIT, true, [](Context& c) { Enable(c, GL_SCISSOR_TEST); }},
    {GL_MULTISAMPLE_BIT, false, [](Context& c) { SampleCoverage(c, 0.5f, GL_TRUE); }},
    {GL_MULTISAMPLE_BIT, true, [](Context& c) { Disable(c, GL_MULTISAMPLE); }},
};

TEST(PushAttrib, KeepsTheDrawBufferAndTheReadBuffer) {
  Context context({}, nullptr);
  ASSERT_TRUE(context.set_window_size(4, 4, pipeline::ColorFormat::rgba8));
  for (const GLbitfield mask : {GL_COLOR_BUFFER_BIT, GL_PIXEL_MODE_BIT}) {
    DrawBuffer(context, GL_FRONT);
    ReadBuffer(context, GL_FRONT);
    PushAttrib(context, mask);
    DrawBuffer(context, GL_NONE);
    ReadBuffer(context, GL_FRONT_LEFT);
    GLint red_bits = 0;
    make_current(&context);
    glGetIntegerv(GL_RED_BITS, &red_bits);
    EXPECT_EQ(red_bits, 8);
    PopAttrib(context);
    const bool draw = mask == GL_COLOR_BUFFER_BIT;
    EXPECT_EQ(context.framebuffers.draw->draw_buffer, GLenum(draw ? GL_FRONT : GL_NONE));
    EXPECT_EQ(context.framebuffers.read->read_buffer, GLenum(draw ? GL_FRONT_LEFT : GL_FRONT));
  }
}

TEST(AttributeStack, RestoresAGroupIfAndOnlyIfItsBitWasPushed) {
  for (const Change& change : changes) {
    for (int bit = 0; bit < 32; ++bit) {
      const GLbitfield mask = GLbitfield{1} << bit;
      Context context({}, nullptr);
      ASSERT_TRUE(context.set_window_size(8, 8, pipeline::ColorFormat::rgba8));
      const GLfloat white[] = {1, 1, 1, 1};  // as the current colour, so that ColorMaterial changes no parameter
      Materialfv(context, GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, white);
      const State before = context.state;
      PushAttrib(context, mask);
      EXPECT_TRUE(context.state == before);
      change.change(context);
      const State changed = context.state;
      ASSERT_FALSE(changed == before);
      context.refresh();
      PopAttrib(context);
      const bool restores = mask == change.bit || (mask == GL_ENABLE_BIT && change.enable);
      EXPECT_TRUE(context.state == (restores ? before : changed)) << mask << " for " << change.bit;
      EXPECT_EQ(context.take_error(), no_error);

      context.refresh();
      pipeline::DrawState anew = context.draw_state();
      update_draw_state(context.state, context.target_info(), dirty_all, anew);
      EXPECT_TRUE(anew == context.draw_state());
    }
  }
}

TEST(AttributeStack, AllBitsRestoreAll) {
  Context context({}, nullptr);
  const State before = context.state;
  PushAttrib(context, GL_ALL_ATTRIB_BITS);
  for (const Change& change : changes) change.change(context);
  PopAttrib(context);
  EXPECT_TRUE(context.state == before);
}

TEST(AttributeStack, OverflowsAtItsDepthAndUnderflowsWhenEmpty) {
  Context context({}, nullptr);
  PopAttrib(context);
  EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_STACK_UNDERFLOW));
  for (int i = 0; i < max_attrib_stack_depth; ++i) {
    LineWidth(context, static_cast<float>(i + 1));
    PushAttrib(context, GL_LINE_BIT);
  }
  EXPECT_EQ(context.take_error(), no_error);
  PushAttrib(context, GL_LINE_BIT);
  EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_STACK_OVERFLOW));
  for (int i = max_attrib_stack_depth; i > 0; --i) {
    PopAttrib(context);
    EXPECT_EQ(context.state.line.width_px, static_cast<float>(i));
  }
  EXPECT_EQ(context.take_error(), no_error);
}

TEST(AttributeStack, MaterialFollowsTheColorUpToThePush) {
  Context context({}, nullptr);
  Enable(context, GL_COLOR_MATERIAL);
  Color4f(context, 0.25f, 0, 0, 1);
  PushAttrib(context, GL_LIGHTING_BIT);
  Disable(context, GL_COLOR_MATERIAL);
  const GLfloat green[] = {0, 1, 0, 1};
  Materialfv(context, GL_FRONT_AND_BACK, GL_DIFFUSE, green);
  PopAttrib(context);
  Disable(context, GL_COLOR_MATERIAL);
  EXPECT_EQ(context.state.lighting.material[0].diffuse, glm::vec4(0.25f, 0, 0, 1));
}

TEST(ClientAttributeStack, RestoresPixelStoreAndVertexArrays) {
  for (const GLbitfield mask : {GLbitfield{GL_CLIENT_PIXEL_STORE_BIT}, GLbitfield{GL_CLIENT_VERTEX_ARRAY_BIT},
                                GLbitfield{GL_CLIENT_ALL_ATTRIB_BITS}, GLbitfield{0}}) {
    Context context({}, nullptr);
    PushClientAttrib(context, mask);
    PixelStorei(context, GL_PACK_ALIGNMENT, 1);
    PixelStorei(context, GL_UNPACK_ROW_LENGTH, 9);
    EnableClientState(context, GL_NORMAL_ARRAY);
    ClientActiveTexture(context, GL_TEXTURE4);
    PopClientAttrib(context);
    const bool pixels = (mask & GL_CLIENT_PIXEL_STORE_BIT) != 0, arrays = (mask & GL_CLIENT_VERTEX_ARRAY_BIT) != 0;
    EXPECT_EQ(context.state.pack == PixelStore{}, pixels);
    EXPECT_EQ(context.state.unpack == PixelStore{}, pixels);
    EXPECT_EQ(context.state.vertex_arrays == VertexArrayGroup{}, arrays);
    EXPECT_EQ(context.take_error(), no_error);
  }
}

TEST(ClientAttributeStack, OverflowsAtItsDepthAndUnderflowsWhenEmpty) {
  Context context({}, nullptr);
  PopClientAttrib(context);
  EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_STACK_UNDERFLOW));
  for (int i = 0; i < max_client_attrib_stack_depth; ++i) PushClientAttrib(context, ~0u);
  EXPECT_EQ(context.take_error(), no_error);
  PushClientAttrib(context, ~0u);
  EXPECT_EQ(context.take_error(), static_cast<GLenum>(GL_STACK_OVERFLOW));
}

}  // namespace
}  // namespace gouraud::api
