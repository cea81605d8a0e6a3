// Where the taps of sampled percentage-closer filtering lie: a fixed disc of points, turned from
// texel to texel. All of it is integers, so that every processor finds the same texels.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace umbra::pcf {

struct Offset {
  int x = 0, y = 0;
};

inline constexpr int largestTapCount = 64;
inline constexpr int rotationCount = 64;

// Points in 1/1024 of the disc's radius. Each is, among many candidates, the one farthest from all
// points before it (Mitchell 1991), so that any number of the first ones covers the disc evenly.
inline constexpr std::array<Offset, largestTapCount> discPoints{
    {{0, 0},       {399, 921},   {-790, -619}, {-910, 422},  {874, -494}, {71, -998},   {944, 321},
     {-350, 930},  {-567, -60},  {304, -485},  {-247, -518}, {390, 367},  {-323, 409},  {593, -93},
     {-981, -203}, {35, 678},    {570, -825},  {-448, -898}, {722, 664},  {998, -70},   {-658, 704},
     {30, 343},    {-617, 261},  {-556, -385}, {-9, 1001},   {21, -322},  {-274, -192}, {30, -680},
     {310, 56},    {-947, 109},  {662, 217},   {-284, 113},  {584, -389}, {331, 647},   {292, -786},
     {348, -213},  {-172, -871}, {-258, 673},  {-511, -643}, {814, -245}, {-797, -366}, {616, 449},
     {-548, 491},  {663, -613},  {789, 23},    {-793, -75},  {182, 849},  {188, 488},   {-111, 517},
     {521, 747},   {449, -648},  {215, 246},   {-317, -722}, {143, -155}, {-116, 824},  {820, 483},
     {-164, 277},  {-451, 751},  {466, 181},   {-481, 118},  {995, 129},  {-742, 526},  {-751, 121},
     {107, -501}}};

// Cosine and sine of the multiples of 1/64 of a full turn, in 1/1024.
const std::array<Offset, rotationCount>& rotations();

// The number of the rotation that the disc about texel (x, y) of a map has: a hash, so that
// neighbours look unlike each other and a texel always looks the same.
constexpr std::uint32_t rotationOf(std::uint32_t x, std::uint32_t y) {
  std::uint32_t hash = x * 0x9E3779B1u ^ y * 0x85EBCA77u;
  hash ^= hash >> 15;
  hash *= 0x2C1B3C6Du;
  hash ^= hash >> 13;
  return hash >> 26;
}

// The texel that tap `tap` about texel (x, y) compares, relative to it: at most reachX and reachY
// texels away along either axis.
Offset tapOffset(int tap, int x, int y, int reachX, int reachY);

// Points and rotations as GLSL constants `umbraDiscPoints` and `umbraDiscRotations`, ivec2[64].
std::string discTables();

}  // namespace umbra::pcf
