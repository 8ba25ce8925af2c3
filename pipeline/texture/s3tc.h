// S3TC images: blocks of 4x4 texels in 8 or 16 bytes [EXT_texture_compression_s3tc, EXT_texture_compression_dxt1].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gouraud::pipeline {

enum class S3tcFormat : std::uint8_t { dxt1_rgb, dxt1_rgba, dxt3, dxt5 };

constexpr std::size_t bytes_per_block(S3tcFormat format) {
  return format == S3tcFormat::dxt1_rgb || format == S3tcFormat::dxt1_rgba ? 8 : 16;
}

/// 16 texels R, G, B, A, row after row.
using TexelBlock = std::array<std::uint8_t, 64>;

TexelBlock decode_block(S3tcFormat format, const std::byte* block);

/// The ends of the range are the extremes along the block's principal axis; each texel takes the nearest step between.
/// Texels of dxt1_rgba with alpha below 128 become transparent black.
void encode_block(S3tcFormat format, const TexelBlock& texels, std::byte* block);

}  // namespace gouraud::pipeline
