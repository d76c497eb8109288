// Marker: the printed square markers that things can carry, so that a camera can identify them: black squares of 6 by 6
// cells, the inner 4 by 4 of them a code, black or white. Scene and part files name them, the camera draws them,
// recognition reads them (with OpenCV's dictionary of this name; a test reads all that the camera draws).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace race::services {

/// OpenCV's predefined dictionary of 50 codes; any two, however turned, differ in four cells at least.
inline constexpr std::string_view kMarkerDictionary = "DICT_4X4_50";

/// The code of each id: a bit for each inner cell, 1 is white, by rows from the top left, the highest bit first.
inline constexpr std::array<std::uint16_t, 50> kMarkerCodes{
    0xB532, 0x0F9A, 0x332D, 0x9946, 0x549E, 0x79CD, 0x9E2E, 0xC4F2, 0xFEDA, 0xCF56, 0xF991, 0x11A7, 0x0EB7,
    0x2A0F, 0x24B1, 0x263E, 0x4665, 0x6600, 0x6C5E, 0x76AF, 0x868B, 0xB02B, 0xCCD5, 0xDD82, 0xFE47, 0x9471,
    0xACE4, 0xA554, 0x2123, 0x346F, 0x4415, 0x57B2, 0x9ECF, 0xF0CB, 0x08AE, 0x0929, 0x1875, 0x04FF, 0x0DF6,
    0x1C5A, 0x1718, 0x2A28, 0x328C, 0x38B2, 0x24E8, 0x2EEB, 0x2D3F, 0x4B64, 0x502E, 0x5013};

inline constexpr int kMarkerIds = static_cast<int>(kMarkerCodes.size());
inline constexpr int kMarkerInner = 4;  // cells of the code along an edge
inline constexpr int kMarkerCells = 6;  // with the black rim

/// Whether the inner cell (row, column) is white. Requires 0 <= id < kMarkerIds, 0 <= row, column < kMarkerInner.
constexpr bool is_white(int id, int row, int column) {
  const int bit = kMarkerInner * kMarkerInner - 1 - (kMarkerInner * row + column);
  return (kMarkerCodes[static_cast<std::size_t>(id)] >> bit & 1) != 0;
}

}  // namespace race::services
