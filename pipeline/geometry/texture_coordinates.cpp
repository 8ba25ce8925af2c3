// Takes vertices with eye positions and normals, gives texture coordinates as they are interpolated [GL1.5 §2.11.4] and
// fog coordinates [GL1.5 §3.10]. In double up to the one rounding to float: near the rim of a sphere map the formula
// divides a small number by a small number.
#include "pipeline/geometry/texture_coordinates.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/geometry/texture_coordinates.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using F = hn::Rebind<float, D>;
using V = hn::Vec<D>;

HWY_INLINE V set(double value) { return hn::Set(D(), value); }
HWY_INLINE V load(const float* from) { return hn::PromoteTo(D(), hn::Load(F(), from)); }

/// ((x a + y b) + z c) + w d.
HWY_INLINE V dot4(const glm::vec4& plane, V x, V y, V z, V w) {
  const V xy = hn::Add(hn::Mul(x, set(plane.x)), hn::Mul(y, set(plane.y)));
  return hn::Add(hn::Add(xy, hn::Mul(z, set(plane.z))), hn::Mul(w, set(plane.w)));
}
HWY_INLINE V dot3(V x, V y, V z, V a, V b, V c) {
  return hn::Add(hn::Add(hn::Mul(x, a), hn::Mul(y, b)), hn::Mul(z, c));
}

/// The vector by which a view of the vertex is reflected: r = u - 2 n (n . u), u from the eye to the vertex.
struct Reflection {
  V x, y, z;
};
HWY_INLINE Reflection reflect(const ProcessedVertices& vertices, std::size_t i) {
  const V nx = load(&vertices.normal_eye[0][i]), ny = load(&vertices.normal_eye[1][i]), nz = load(&vertices.normal_eye[2][i]);
  V ux = load(&vertices.position_eye[0][i]), uy = load(&vertices.position_eye[1][i]), uz = load(&vertices.position_eye[2][i]);
  const V length = hn::Sqrt(dot3(ux, uy, uz, ux, uy, uz));
  const auto somewhere = hn::Gt(length, hn::Zero(D()));  // a vertex in the eye is seen along no direction
  ux = hn::IfThenElseZero(somewhere, hn::Div(ux, length));
  uy = hn::IfThenElseZero(somewhere, hn::Div(uy, length));
  uz = hn::IfThenElseZero(somewhere, hn::Div(uz, length));
  const V twice = hn::Mul(set(2), dot3(nx, ny, nz, ux, uy, uz));
  return {hn::Sub(ux, hn::Mul(nx, twice)), hn::Sub(uy, hn::Mul(ny, twice)), hn::Sub(uz, hn::Mul(nz, twice))};
}

/// r / m + 1/2 with m = 2 sqrt(rx^2 + ry^2 + (rz + 1)^2); the one direction that has no place in the map gives 1/2.
HWY_INLINE V on_sphere(V component, const Reflection& r) {
  const V z = hn::Add(r.z, set(1));
  const V m = hn::Mul(set(2), hn::Sqrt(dot3(r.x, r.y, z, r.x, r.y, z)));
  return hn::Add(hn::IfThenElseZero(hn::Gt(m, hn::Zero(D())), hn::Div(component, m)), set(0.5));
}

/// Component c of the coordinates before the matrix.
HWY_INLINE V generate(const TextureCoordinateSource& source, std::size_t c, const VertexArray<4>& given,
                      const VertexBatch& batch, const ProcessedVertices& vertices, const Reflection& r, std::size_t i) {
  const auto dot_position = [&](const auto& position) HWY_ATTR {
    return dot4(source.plane[c], load(&position[0][i]), load(&position[1][i]), load(&position[2][i]), load(&position[3][i]));
  };
  switch (source.mode[c]) {
    case TexgenMode::given: return load(&given[c][i]);
    case TexgenMode::object_linear: return dot_position(batch.position_object);
    case TexgenMode::eye_linear: return dot_position(vertices.position_eye);
    case TexgenMode::sphere_map: return on_sphere(c == 0 ? r.x : r.y, r);
    case TexgenMode::normal_map: return load(&vertices.normal_eye[std::min<std::size_t>(c, 2)][i]);
    case TexgenMode::reflection_map: return c == 0 ? r.x : c == 1 ? r.y : r.z;
  }
  return hn::Zero(D());
}

HWY_INLINE bool reflects(TexgenMode mode) { return mode == TexgenMode::sphere_map || mode == TexgenMode::reflection_map; }

/// Component c (4 at most, s, t, r, q) of the unit goes to out.varying[target[c]]; those that are -1 are not made.
void make_coordinates(const TextureCoordinateSource& source, const std::array<int, 4>& target, const VertexArray<4>& given,
          const VertexBatch& batch, ProcessedVertices& out) {
  const D d;
  const F f;
  const V largest = set(std::numeric_limits<float>::max());
  const bool any_reflection = std::any_of(source.mode.begin(), source.mode.end(), reflects);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); i += hn::Lanes(d)) {
    Reflection r{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    if (any_reflection) r = reflect(out, i);
    V in[4];
    for (std::size_t c = 0; c < 4; ++c) {
      const bool needed = source.transformed || target[c] >= 0;
      in[c] = needed ? generate(source, c, given, batch, out, r, i) : hn::Zero(d);
    }
    for (std::size_t c = 0; c < 4; ++c) {
      if (target[c] < 0) continue;
      const int row = static_cast<int>(c);
      const glm::vec4 factors(source.matrix[0][row], source.matrix[1][row], source.matrix[2][row], source.matrix[3][row]);
      const V value = source.transformed ? dot4(factors, in[0], in[1], in[2], in[3]) : in[c];
      // Targets disagree about what infinity becomes as a float.
      const V finite = hn::IfThenElseZero(hn::Le(hn::Abs(value), largest), value);
      hn::Store(hn::DemoteTo(f, finite), f, &out.varying[static_cast<std::size_t>(target[c])][i]);
    }
  }
}

/// |z_eye| by the modelview's third row, with the bits of transform_to_eye.
void fog_distances(const TransformState& of_all, const VertexBatch& batch, float* out) {
  const hn::CappedTag<float, 16> d;
  const auto& p = batch.position_object;
  for_each_transform(of_all, batch, [&](const TransformState& state, std::size_t first, std::size_t end) HWY_ATTR {
    const glm::mat4& modelview = state.modelview;
    const auto m0 = hn::Set(d, modelview[0][2]), m1 = hn::Set(d, modelview[1][2]);
    const auto m2 = hn::Set(d, modelview[2][2]), m3 = hn::Set(d, modelview[3][2]);
    for (std::size_t i = first; i < end; i += hn::Lanes(d)) {
      const auto xy = hn::Add(hn::Mul(hn::LoadU(d, &p[0][i]), m0), hn::Mul(hn::LoadU(d, &p[1][i]), m1));
      const auto z = hn::Add(hn::Add(xy, hn::Mul(hn::LoadU(d, &p[2][i]), m2)), hn::Mul(hn::LoadU(d, &p[3][i]), m3));
      hn::StoreU(hn::Abs(z), d, out + i);
    }
  });
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
namespace {

/// q' is q itself.
bool keeps_q(const TextureCoordinateSource& source) {
  const glm::mat4& m = source.matrix;
  return !source.transformed || (m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1);
}

}  // namespace

TextureCoordinateNeeds needs_of(const TextureCoordinateSource& source, int dimensions) {
  TextureCoordinateNeeds needs;
  for (int c = 0; c < 4; ++c) {
    if (!source.transformed && c >= dimensions && c != 3) continue;
    const TexgenMode mode = source.mode[static_cast<std::size_t>(c)];
    const bool reflects = mode == TexgenMode::sphere_map || mode == TexgenMode::reflection_map;
    needs.given |= mode == TexgenMode::given;
    needs.position_eye |= mode == TexgenMode::eye_linear || reflects;
    needs.normal_eye |= mode == TexgenMode::normal_map || reflects;
  }
  return needs;
}

bool q_is_one(const TextureCoordinateSource& source, const VertexBatch& batch, int unit) {
  if (source.mode[3] != TexgenMode::given || !keeps_q(source)) return false;
  const float* q = batch.texture_coordinates[static_cast<std::size_t>(unit)][3].data();
  std::uint32_t different = 0;
  for (std::int32_t i = 0; i < batch.count; ++i) different |= std::bit_cast<std::uint32_t>(q[i]) ^ std::bit_cast<std::uint32_t>(1.0f);
  return different == 0;
}

void make_texture_coordinates(const TextureCoordinateSource& source, const TextureCoordinateLayout& layout, int unit,
                              const VertexBatch& batch, ProcessedVertices& out) {
  const VertexArray<4>& given = batch.texture_coordinates[static_cast<std::size_t>(unit)];
  std::array<int, 4> target{-1, -1, -1, -1};
  bool all_given = !source.transformed;
  int next = layout.first;
  for (std::size_t c = 0; c < 4; ++c) {
    const bool wanted = c < 3 ? static_cast<int>(c) < layout.dimensions : layout.has_q;
    if (!wanted) continue;
    target[c] = next++;
    all_given = all_given && source.mode[c] == TexgenMode::given;
  }
  if (!all_given) return GOURAUD_SIMD_PICK(make_coordinates)(source, target, given, batch, out);
  for (std::size_t c = 0; c < 4; ++c) {
    if (target[c] < 0) continue;
    std::copy_n(given[c].data(), batch.count, out.varying[static_cast<std::size_t>(target[c])].data());
  }
}

void make_fog_coordinates(const TransformState& transform, const FogState& fog, const VertexBatch& batch,
                          std::array<float, processed_stride>& out) {
  if (fog.from_coordinate) {
    std::copy_n(batch.fog_coordinate[0].data(), batch.count, out.data());
  } else {
    GOURAUD_SIMD_PICK(fog_distances)(transform, batch, out.data());
  }
}

}  // namespace gouraud::pipeline
#endif
