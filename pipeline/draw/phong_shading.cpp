// Takes a block with interpolated normals and eye positions, gives it with lit colours [GL1.5 §2.14.1].
//
// The normal is interpolated, made a unit vector again, and lit: by the very stage that lights vertices, which gets the 64 fragments of
// the block as if they were vertices. So the equations are the same, and only the place differs: a highlight in the middle of a
// triangle is there, which Gouraud's shading loses, and a spot's edge is round on a coarse mesh. Every fragment costs what a vertex costs.
// Silhouettes stay polygons. A normal that the program has not made a unit vector is taken for its direction alone, and a material that
// changes inside Begin and End takes effect with the next primitive.
// Source: B. T. Phong, "Illumination for computer generated pictures", 1975.
#include "pipeline/draw/phong_shading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>

#include "pipeline/draw/method_state.h"
#include "pipeline/geometry/lighting.h"
#include "pipeline/geometry/lighting_methods.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {
namespace {

constexpr std::size_t normal_at = 0, position_at = 3, color_at = 6;

bool follows_color(const LightingState& lighting) {
  return (lighting.color_material_front | lighting.color_material_back) != material_none;
}

/// A block as the lighting stage wants it. One a thread, made when a thread first lights a fragment.
struct Fragments {
  VertexBatch batch;
  ProcessedVertices vertices;
};

Fragments* fragments_of_thread() {
  thread_local std::unique_ptr<Fragments> fragments(new (std::nothrow) Fragments);
  return fragments.get();
}

void shade(FragmentBlock& block, const TileTarget&) {
  const RasterBinding& binding = *block.primitive->binding;
  const MethodState& method = *binding.method;
  const auto first = static_cast<std::size_t>(binding.varyings.lighting);
  Fragments* const fragments = fragments_of_thread();
  if (fragments == nullptr) {  // without memory fragments are black
    for (auto& channel : block.color) channel.fill(0.0f);
    return;
  }
  fragments->batch.count = 64;
  ProcessedVertices& lit = fragments->vertices;
  for (std::size_t lane = 0; lane < 64; ++lane) {
    const auto varying = [&](std::size_t k) { return block.varying[first + k][lane]; };
    const float x = varying(normal_at), y = varying(normal_at + 1), z = varying(normal_at + 2);
    const float length = std::sqrt((x * x + y * y) + z * z), scale = length > 0 ? 1.0f / length : 0.0f;
    lit.normal_eye[0][lane] = x * scale;
    lit.normal_eye[1][lane] = y * scale;
    lit.normal_eye[2][lane] = z * scale;
    for (std::size_t k = 0; k < 3; ++k) lit.position_eye[k][lane] = varying(position_at + k);
    lit.position_eye[3][lane] = 1.0f;
  }
  if (follows_color(method.lighting)) {
    for (std::size_t k = 0; k < 4; ++k) std::ranges::copy(block.varying[first + color_at + k], fragments->batch.color[k].begin());
  }
  if (method.methods.lights_plainly()) {
    light_vertices(method.lighting, method.methods.highlight, fragments->batch, lit);
  } else {
    light_vertices(method.lighting, fragments->batch, lit);
  }

  const bool back = block.primitive->back && method.lighting.two_sided, separate = method.lighting.separate_specular;
  const auto& color = back ? lit.color_back : lit.color_front;
  const auto& specular = back ? lit.specular_back : lit.specular_front;
  const std::int8_t secondary = binding.varyings.secondary_color;
  for (std::size_t lane = 0; lane < 64; ++lane) {
    Rgba c = color[lane];
    const Rgba s = separate ? specular[lane] : Rgba{};
    if (secondary >= 0) {
      const auto at = static_cast<std::size_t>(secondary);
      block.varying[at][lane] = s.r;
      block.varying[at + 1][lane] = s.g;
      block.varying[at + 2][lane] = s.b;
    } else if (separate) {
      c = {std::min(c.r + s.r, 1.0f), std::min(c.g + s.g, 1.0f), std::min(c.b + s.b, 1.0f), c.a};
    }
    block.color[0][lane] = c.r * method.color_scale;
    block.color[1][lane] = c.g * method.color_scale;
    block.color[2][lane] = c.b * method.color_scale;
    block.color[3][lane] = c.a * method.color_scale;
  }
}

}  // namespace

int lighting_varyings(const LightingState& lighting) { return follows_color(lighting) ? 10 : 6; }

void make_lighting_varyings(const LightingState& lighting, const VaryingLayout& layout, const VertexBatch& batch, ProcessedVertices& vertices) {
  const auto first = static_cast<std::size_t>(layout.lighting), count = static_cast<std::size_t>(batch.count);
  for (std::size_t i = 0; i < count; ++i) {
    const float w = vertices.position_eye[3][i], scale = 1.0f / (w != 0 ? w : 1.0f);
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.varying[first + normal_at + k][i] = vertices.normal_eye[k][i];
      vertices.varying[first + position_at + k][i] = vertices.position_eye[k][i] * scale;
    }
    if (!follows_color(lighting)) continue;
    for (std::size_t k = 0; k < 4; ++k) vertices.varying[first + color_at + k][i] = batch.color[k][i];
  }
}

FragmentPass phong_shading_pass() { return shade; }

}  // namespace gouraud::pipeline
