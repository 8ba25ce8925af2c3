// The draw state that is brought up to date part by part, against one taken anew: after any sequence of commands both
// are equal, so that no command forgets a dirty bit and no part forgets what it depends on.
#include <gtest/gtest.h>

#include <random>

#include "api/commands/begin_end.h"
#include "api/commands/enables.h"
#include "api/commands/framebuffer_control.h"
#include "api/commands/lighting.h"
#include "api/commands/matrices.h"
#include "api/commands/rasterization.h"
#include "api/commands/viewport.h"
#include "api/context/context.h"
#include "api/snapshot/lighting_snapshot.h"

namespace gouraud::api {
namespace {

class RandomCommands {
 public:
  explicit RandomCommands(Context& context) : context_(context) {}

  void run_one() {
    Context& c = context_;
    const GLfloat vector[4] = {number(), number(), number(), number()};
    switch (integer(24)) {
      case 0:
        return MatrixMode(c, one_of({GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}));
      case 1:
        return Rotatef(c, 90 * number(), number(), number(), 1);
      case 2:
        return integer(2) == 0 ? PushMatrix(c) : PopMatrix(c);
      case 3:
        return LoadIdentity(c);
      case 4:
        return Translatef(c, number(), number(), number());
      case 5:
        return Viewport(c, integer(3), integer(3), 10 + integer(3), 10);
      case 6:
        return DepthRange(c, integer(2), integer(2));
      case 7:
      case 8:
        return enable_or_disable();
      case 9:
        return Lightfv(c, light(), one_of({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION}), vector);
      case 10:
        return Lightfv(c, light(), one_of({GL_SPOT_CUTOFF, GL_SPOT_EXPONENT, GL_LINEAR_ATTENUATION}), vector);
      case 11:
        return LightModelfv(c, GL_LIGHT_MODEL_AMBIENT, vector);
      case 12:
        return LightModelfv(c, one_of({GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_LOCAL_VIEWER}), vector);
      case 13:
      case 14:
        return Materialfv(c, face(), one_of({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_SHININESS}), vector);
      case 15:
        return ColorMaterial(c, face(), one_of({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}));
      case 16:
        return ShadeModel(c, one_of({GL_FLAT, GL_SMOOTH}));
      case 17:
        return FrontFace(c, one_of({GL_CW, GL_CCW}));
      case 18:
        return CullFace(c, face());
      case 19:
        return PolygonMode(c, face(), one_of({GL_POINT, GL_LINE, GL_FILL}));
      case 20:
        return Scissor(c, integer(9), integer(9), integer(9), 5);
      case 21:
        return DepthFunc(c, GL_NEVER + static_cast<GLenum>(integer(8)));
      case 22:
        return DepthMask(c, static_cast<GLboolean>(integer(2)));
      default: {
        const auto flag = static_cast<GLboolean>(integer(2));
        return ColorMask(c, flag, flag, flag, flag);
      }
    }
  }
  int integer(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  float number() { return static_cast<float>(integer(3)) * 0.5f; }
  GLenum one_of(std::initializer_list<GLenum> values) {
    return *(values.begin() + integer(static_cast<int>(values.size())));
  }
  GLenum light() { return GL_LIGHT0 + static_cast<GLenum>(integer(3)); }
  GLenum face() { return one_of({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}); }
  void enable_or_disable() {
    const GLenum cap = one_of({GL_LIGHTING, GL_LIGHTING, GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_COLOR_MATERIAL,
                               GL_CULL_FACE, GL_DEPTH_TEST, GL_NORMALIZE, GL_RESCALE_NORMAL, GL_SCISSOR_TEST});
    integer(3) == 0 ? Disable(context_, cap) : Enable(context_, cap);
  }

  Context& context_;
  std::mt19937 random_{11};
};

TEST(Refresh, GivesWhatASnapshotTakenAnewGives) {
  Context context({}, nullptr);
  RandomCommands commands(context);
  for (int round = 0; round < 20000; ++round) {
    if (round % 500 == 0) {
      const int size = 8 + round / 500;
      ASSERT_TRUE(context.set_window_size(size, size, pipeline::ColorFormat::rgba8));
    }
    for (int i = commands.integer(4); i >= 0; --i) commands.run_one();
    Begin(context, GL_POINTS);
    Vertex4f(context, 0, 0, 0, 1);
    End(context);

    pipeline::DrawState expected;
    update_draw_state(context.state, context.target_info(), dirty_all, expected);
    expected.lighting.material = canonical_material(context.state.lighting, expected.lighting);
    pipeline::DrawState found = context.draw_state();
    found.lighting.material = context.immediate.material;
    ASSERT_EQ(found, expected) << "round " << round;
    ASSERT_EQ(context.plan(), pipeline::make_plan(expected, context.target_info().format)) << "round " << round;
  }
}

}  // namespace
}  // namespace gouraud::api
