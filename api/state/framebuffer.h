// Per-fragment operations and the framebuffer [GL1.5 §4.1, §4.2, Tables 6.19 and 6.20].
#pragma once

#include <array>

#include <GL/gl.h>
#include <glm/glm.hpp>

namespace gouraud::api {

/// Attribute group SCISSOR_BIT. The context sets width and height when it gets its first target.
struct ScissorGroup {
  bool enabled = false;
  GLint x = 0, y = 0;
  GLsizei width_px = 0, height_px = 0;
  bool operator==(const ScissorGroup&) const = default;
};

/// Attribute group MULTISAMPLE_BIT [GL1.5 Table 6.14]. Without sample buffers none of it has an effect.
struct MultisampleGroup {
  bool enabled = true;
  bool alpha_to_coverage_enabled = false;
  bool alpha_to_one_enabled = false;
  bool coverage_enabled = false;
  float coverage_value = 1.0f;  ///< in [0, 1]
  bool coverage_inverted = false;
  bool operator==(const MultisampleGroup&) const = default;
};

/// Attribute group DEPTH_BUFFER_BIT.
struct DepthGroup {
  bool test_enabled = false;
  bool write_enabled = true;
  GLenum func = GL_LESS;
  double clear_value = 1.0;  ///< in [0, 1]
  bool operator==(const DepthGroup&) const = default;
};

/// One side's stencil test [GL1.5 §4.1.5].
struct StencilSide {
  GLenum func = GL_ALWAYS;
  GLint reference = 0;  ///< as given: clamped to the stencil buffer's range where it is used
  GLuint compare_mask = ~0u;
  GLenum fail = GL_KEEP, depth_fail = GL_KEEP, depth_pass = GL_KEEP;
  GLuint write_mask = ~0u;
  bool operator==(const StencilSide&) const = default;
};

/// Attribute group STENCIL_BUFFER_BIT. Two extensions give back faces a test of their own, each with state of its own:
/// EXT_stencil_two_side, in force while STENCIL_TEST_TWO_SIDE_EXT is enabled, and otherwise ATI_separate_stencil, whose
/// back side follows all that is set for the front by the plain commands (as in Mesa).
struct StencilGroup {
  bool test_enabled = false;
  bool two_side_enabled = false;
  GLenum active_face = GL_FRONT;  ///< the side that the plain commands set: FRONT, or BACK (two_side_back)
  StencilSide front, separate_back, two_side_back;
  GLint clear_value = 0;
  const StencilSide& back() const { return two_side_enabled ? two_side_back : separate_back; }
  bool operator==(const StencilGroup&) const = default;
};

/// Attribute group ACCUM_BUFFER_BIT.
struct AccumGroup {
  glm::vec4 clear_value{0.0f};  ///< in [-1, 1]
  bool operator==(const AccumGroup&) const = default;
};

/// How colours are blended [GL1.5 §4.1.8]; part of attribute group COLOR_BUFFER_BIT.
struct Blending {
  bool enabled = false;
  GLenum source_rgb = GL_ONE, destination_rgb = GL_ZERO;
  GLenum source_alpha = GL_ONE, destination_alpha = GL_ZERO;
  GLenum equation_rgb = GL_FUNC_ADD, equation_alpha = GL_FUNC_ADD;
  glm::vec4 constant{0.0f};  ///< in [0, 1]
  bool operator==(const Blending&) const = default;
};

/// Attribute group COLOR_BUFFER_BIT.
struct ColorBufferGroup {
  GLenum draw_buffer = GL_FRONT;  ///< of a saved group; in force is the draw buffer of the framebuffer that is bound
  std::array<bool, 4> write_enabled{true, true, true, true};  ///< R, G, B, A
  glm::vec4 clear_color{0.0f};                                ///< in [0, 1]
  bool alpha_test_enabled = false;
  GLenum alpha_func = GL_ALWAYS;
  float alpha_reference = 0.0f;  ///< in [0, 1]
  Blending blend;
  bool logic_op_enabled = false;
  bool index_logic_op_enabled = false;  ///< kept, but there is no color index mode
  GLenum logic_op = GL_COPY;
  GLuint index_write_mask = ~0u;  ///< of colour index mode, as clear_index: kept, but there is no such mode
  float clear_index = 0.0f;
  /// choice: dithering never changes a value, whether enabled or not; Mesa's does neither [GL1.5 §4.1.9].
  bool dither_enabled = true;
  bool operator==(const ColorBufferGroup&) const = default;
};

}  // namespace gouraud::api
