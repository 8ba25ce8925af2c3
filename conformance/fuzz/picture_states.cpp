// Features of random pictures: matrices, lighting, rasterization and fragment operations.
#include <array>

#include "conformance/fuzz/pictures.h"

namespace gouraud::conformance {
namespace {

void model_view(Brush& b) {
  if (b.chance(3)) in_order(b.gl.Translatef, std::tuple{b.range(-0.4f, 0.4f), b.range(-0.4f, 0.4f), b.range(-0.2f, 0.2f)});
  in_order(b.gl.Rotatef, std::tuple{b.range(-180.0f, 180.0f), b.range(-1.0f, 1.0f), b.range(-1.0f, 1.0f), b.range(0.1f, 1.0f)});
  if (b.chance(2)) in_order(b.gl.Scalef, std::tuple{b.range(0.4f, 1.3f), b.range(0.4f, 1.3f), b.range(0.4f, 1.0f)});
}

void perspective(Brush& b) {
  b.gl.MatrixMode(GL_PROJECTION);
  b.gl.LoadIdentity();
  b.gl.Frustum(-0.7, 0.7, -0.7, 0.7, 1.0, 6.0);
  b.gl.Translatef(0.0f, 0.0f, b.range(-3.0f, -1.5f));
  b.gl.MatrixMode(GL_MODELVIEW);
}

void viewport(Brush& b) {
  in_order(b.gl.Viewport, std::tuple{b.below(30) - 10, b.below(30) - 10, 20 + b.below(60), 20 + b.below(60)});
  in_order(b.gl.DepthRange, std::tuple{b.level(), b.level()});
}

void material_of(Brush& b, GLenum face) {
  b.gl.Materialfv(face, GL_AMBIENT, b.color().v);
  b.gl.Materialfv(face, GL_DIFFUSE, b.color().v);
  b.gl.Materialfv(face, GL_SPECULAR, b.color().v);
  if (b.chance(3)) b.gl.Materialfv(face, GL_EMISSION, b.color().v);
  b.gl.Materialf(face, GL_SHININESS, static_cast<float>(b.below(60)));
}

void one_light(Brush& b, GLenum light) {
  const GlTable& gl = b.gl;
  gl.Enable(light);
  gl.Lightfv(light, GL_AMBIENT, b.color().v);
  gl.Lightfv(light, GL_DIFFUSE, b.color().v);
  gl.Lightfv(light, GL_SPECULAR, b.color().v);
  Brush::Four position = b.point();
  position.v[2] += 1.5f;
  position.v[3] = b.chance(2) ? 0.0f : 1.0f;
  gl.Lightfv(light, GL_POSITION, position.v);
  if (b.chance(3)) {
    Brush::Four direction = b.point();
    direction.v[2] -= 1.5f;
    gl.Lightfv(light, GL_SPOT_DIRECTION, direction.v);
    gl.Lightf(light, GL_SPOT_CUTOFF, b.range(20.0f, 80.0f));
    gl.Lightf(light, GL_SPOT_EXPONENT, static_cast<float>(b.below(20)));
  }
  if (b.chance(3)) {
    gl.Lightf(light, GL_CONSTANT_ATTENUATION, b.range(0.2f, 1.0f));
    gl.Lightf(light, GL_LINEAR_ATTENUATION, b.range(0.0f, 1.0f));
    gl.Lightf(light, GL_QUADRATIC_ATTENUATION, b.range(0.0f, 1.0f));
  }
}

void lighting(Brush& b) {
  const GlTable& gl = b.gl;
  gl.Enable(GL_LIGHTING);
  for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 3; ++light) {
    if (light == GL_LIGHT0 || b.chance(3)) one_light(b, light);
  }
  if (b.chance(2)) gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, b.color().v);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, b.below(2));
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, b.below(2));
  material_of(b, GL_FRONT);
  material_of(b, GL_BACK);
  if (!b.chance(3)) gl.Enable(b.chance(4) ? GL_RESCALE_NORMAL : GL_NORMALIZE);
}

void color_material(Brush& b) {
  b.gl.ColorMaterial(b.one_of({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}),
                     b.one_of({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE}));
  b.gl.Enable(GL_COLOR_MATERIAL);
  b.gl.Color4fv(b.color().v);  // Mesa takes over the current colour only when it is set again
}

/// Unlit: Mesa's rectangles have the colour of their last vertex, not of a polygon's first [GL1.5 §2.10].
void flat(Brush& b) {
  if (b.gl.IsEnabled(GL_LIGHTING) == GL_FALSE) b.gl.ShadeModel(GL_FLAT);
}

void clip_planes(Brush& b) {
  for (int i = b.below(2); i >= 0; --i) {
    const Brush::Four plane = b.point();
    const double values[4] = {plane.v[0], plane.v[1], plane.v[2], 0.6 * plane.v[3]};
    b.gl.ClipPlane(static_cast<GLenum>(GL_CLIP_PLANE0 + i), values);
    b.gl.Enable(static_cast<GLenum>(GL_CLIP_PLANE0 + i));
  }
}

void polygon_mode(Brush& b) {
  // All inside the window: Mesa draws no edges along its sides.
  b.gl.MatrixMode(GL_PROJECTION);
  b.gl.LoadIdentity();
  b.gl.MatrixMode(GL_MODELVIEW);
  b.gl.Scalef(0.8f, 0.8f, 1.0f);
  in_order(b.gl.PolygonMode, std::tuple{b.one_of({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}), b.one_of({GL_POINT, GL_LINE})});
}

void culling(Brush& b) {
  b.gl.Enable(GL_CULL_FACE);
  b.gl.CullFace(b.one_of({GL_FRONT, GL_BACK}));
  if (b.chance(2)) b.gl.FrontFace(GL_CW);
}

/// Of filled polygons: Mesa's is for all that polygons become.
void polygon_stipple(Brush& b) {
  std::array<GLint, 2> modes{};
  b.gl.GetIntegerv(GL_POLYGON_MODE, modes.data());
  if (modes[0] != GL_FILL || modes[1] != GL_FILL) return;
  std::array<GLubyte, 128> pattern{};
  for (GLubyte& byte : pattern) byte = static_cast<GLubyte>(b.random.next() >> 7);
  b.gl.PolygonStipple(pattern.data());
  b.gl.Enable(GL_POLYGON_STIPPLE);
}

void polygon_offset(Brush& b) {
  b.gl.Enable(GL_POLYGON_OFFSET_FILL);
  in_order(b.gl.PolygonOffset, std::tuple{b.range(-0.2f, 0.2f), b.range(-50.0f, 50.0f)});
}

void line_width(Brush& b) { b.gl.LineWidth(b.range(1.0f, 6.0f)); }

void point_size(Brush& b) {
  b.gl.PointSize(b.range(1.0f, 12.0f));
  if (b.chance(2)) return;
  const float attenuation[3] = {b.range(0.2f, 1.0f), 0.0f, 0.0f};  // distances of Mesa's are along z alone
  b.gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  b.gl.PointParameterf(GL_POINT_SIZE_MIN, b.range(1.0f, 3.0f));
  b.gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, b.range(0.0f, 6.0f));
}

void alpha_test(Brush& b) {
  b.gl.Enable(GL_ALPHA_TEST);
  in_order(b.gl.AlphaFunc, std::tuple{b.comparison(), b.range(0.1f, 0.9f)});
}

void stencil(Brush& b) {
  const GlTable& gl = b.gl;
  gl.Enable(GL_STENCIL_TEST);
  const auto operation = [&b] { return b.one_of({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP}); };
  const GLenum fail = operation(), depth_fail = operation(), pass = operation();
  gl.StencilOp(fail, depth_fail, pass);
  const GLenum compare = b.comparison();
  const int reference = b.below(4);
  gl.StencilFunc(compare, reference, b.chance(3) ? static_cast<GLuint>(b.below(8)) : ~0u);
  if (b.chance(4)) gl.StencilMask(static_cast<GLuint>(b.below(256)));
}

void depth_test(Brush& b) {
  b.gl.Enable(GL_DEPTH_TEST);
  b.gl.DepthFunc(b.chance(2) ? GL_LESS : b.comparison());
  if (b.chance(4)) b.gl.DepthMask(GL_FALSE);
}

GLenum blend_factor(Brush& b) {
  return b.one_of({GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA,
                   GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR,
                   GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA});
}

void blending(Brush& b) {
  const GlTable& gl = b.gl;
  gl.Enable(GL_BLEND);
  in_order(gl.BlendColor, std::tuple{b.level(), b.level(), b.level(), b.level()});
  const GLenum source = b.chance(6) ? GL_SRC_ALPHA_SATURATE : blend_factor(b), destination = blend_factor(b);
  if (b.chance(3)) {
    const GLenum source_alpha = blend_factor(b), destination_alpha = blend_factor(b);
    gl.BlendFuncSeparate(source, destination, source_alpha, destination_alpha);
  } else {
    gl.BlendFunc(source, destination);
  }
  if (b.chance(3)) gl.BlendEquation(b.one_of({GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX}));
}

void logic_op(Brush& b) {
  b.gl.Enable(GL_COLOR_LOGIC_OP);
  b.gl.LogicOp(b.one_of({GL_CLEAR, GL_COPY, GL_NOOP, GL_SET, GL_COPY_INVERTED, GL_INVERT}));
}

void color_mask(Brush& b) {
  const auto flag = [&b] { return static_cast<GLboolean>(b.below(2)); };
  const GLboolean red = flag(), green = flag(), blue = flag(), alpha = flag();
  b.gl.ColorMask(red, green, blue, alpha);
}

void scissor(Brush& b) {
  b.gl.Enable(GL_SCISSOR_TEST);
  in_order(b.gl.Scissor, std::tuple{b.below(30), b.below(30), 10 + b.below(50), 10 + b.below(50)});
}

void multisample_state(Brush& b) {
  b.gl.Disable(GL_MULTISAMPLE);
  b.gl.Enable(b.one_of({GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE}));
  in_order(b.gl.SampleCoverage, std::tuple{b.level(), static_cast<GLboolean>(b.below(2))});
}

void pushed_attributes(Brush& b) {
  b.gl.PushAttrib(b.chance(2) ? GL_ALL_ATTRIB_BITS : static_cast<GLbitfield>(b.random.next() & 0xFFFFF));
  b.gl.Enable(b.one_of({GL_LIGHTING, GL_FOG, GL_CULL_FACE, GL_TEXTURE_2D, GL_SCISSOR_TEST}));
  b.gl.ShadeModel(GL_FLAT);
  b.gl.PopAttrib();
}

constexpr Feature features[] = {
    {"viewport", viewport},
    {"perspective", perspective},
    {"model_view", model_view},
    {"lighting", lighting},
    {"color_material", color_material},
    {"flat", flat},
    {"clip_planes", clip_planes},
    {"polygon_mode", polygon_mode},
    {"culling", culling},
    {"polygon_stipple", polygon_stipple},
    {"polygon_offset", polygon_offset},
    {"line_width", line_width},
    {"point_size", point_size},
    {"alpha_test", alpha_test},
    {"stencil", stencil},
    {"depth_test", depth_test},
    {"blending", blending},
    {"logic_op", logic_op},
    {"color_mask", color_mask},
    {"scissor", scissor},
    {"multisample_state", multisample_state},
    {"pushed_attributes", pushed_attributes},
};

}  // namespace

std::span<const Feature> state_features() { return features; }

}  // namespace gouraud::conformance
