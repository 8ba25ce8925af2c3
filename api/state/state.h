// The state of a GL context in the specification's own shape: one assignable struct per attribute group, initial
// values from the tables [GL1.5 §6.2]. Group names are those of PushAttrib's bits.
#pragma once

#include <GL/gl.h>

#include "api/state/buffer_object.h"
#include "api/state/current.h"
#include "api/state/evaluators.h"
#include "api/state/fog.h"
#include "api/state/framebuffer.h"
#include "api/state/lighting.h"
#include "api/state/limits.h"
#include "api/state/pixel.h"
#include "api/state/pixel_store.h"
#include "api/state/rasterization.h"
#include "api/state/render_mode.h"
#include "api/state/texture.h"
#include "api/state/texture_generation.h"
#include "api/state/transform.h"
#include "api/state/vertex_arrays.h"

namespace gouraud::api {

/// Attribute group HINT_BIT [GL1.5 §5.6].
struct HintGroup {
  GLenum perspective_correction = GL_DONT_CARE;
  GLenum point_smooth = GL_DONT_CARE;
  GLenum line_smooth = GL_DONT_CARE;
  GLenum polygon_smooth = GL_DONT_CARE;
  GLenum fog = GL_DONT_CARE;
  GLenum generate_mipmap = GL_DONT_CARE;
  GLenum texture_compression = GL_DONT_CARE;
  bool operator==(const HintGroup&) const = default;
};

/// Attribute group TEXTURE_BIT, to which the parameters of the bound objects belong as well.
struct TextureGroup {
  int active_unit = 0;  ///< in [0, max_texture_units)
  std::array<TextureUnit, max_texture_units> units;
  bool seamless_enabled = false;  ///< TEXTURE_CUBE_MAP_SEAMLESS
  bool operator==(const TextureGroup&) const = default;
};

/// Attribute group LIST_BIT [GL1.5 §5.4].
struct ListGroup {
  GLuint base = 0;
  bool operator==(const ListGroup&) const = default;
};

/// What PushAttrib can save [GL1.5 §6.1.14]: one member a group.
struct AttributeGroups {
  CurrentGroup current;
  TransformGroup transform;
  ViewportGroup viewport;
  LightingGroup lighting;
  FogGroup fog;
  PointGroup point;
  LineGroup line;
  PolygonGroup polygon;
  PolygonStippleGroup polygon_stipple;
  MultisampleGroup multisample;
  ScissorGroup scissor;
  DepthGroup depth;
  StencilGroup stencil;
  AccumGroup accum;
  ColorBufferGroup color_buffer;
  PixelGroup pixel;
  TextureGroup texture;
  TextureGenerationGroup texture_generation;
  HintGroup hint;
  EvalGroup eval;
  ListGroup list;
  bool operator==(const AttributeGroups&) const = default;
};

/// What PushClientAttrib can save.
struct ClientAttributeGroups {
  PixelStore pack, unpack;
  BufferBinding pack_buffer, unpack_buffer;
  VertexArrayGroup vertex_arrays;
  bool operator==(const ClientAttributeGroups&) const = default;
};

struct State : AttributeGroups, ClientAttributeGroups {
  MatrixStacks matrices;
  EvaluatorMaps maps;
  PixelMaps pixel_maps;
  RenderModeState render_mode;
  GLuint current_query = 0;  ///< the occlusion query being counted, 0: none [GL1.5 §4.1.7]
  bool operator==(const State&) const = default;
};

}  // namespace gouraud::api
