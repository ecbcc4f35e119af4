// SPDX-License-Identifier: MIT
#pragma once

// GLSL 3.30. Positions are pixels from the top left; edges are smoothed by the part of a pixel that a shape
// covers, so no multisampling is needed. Vertex shaders multiply colours by their alpha, fragment shaders all
// four by what is covered: the blending that costs least.

namespace bedmix::shaders {

inline constexpr const char* version = "#version 330 core\n";

/// What vertex shaders share. px to clip space; `size` is the picture's. OpenGL's lowest row is the picture's
/// top one, which comes first when it is read back.
inline constexpr const char* vertexTools = R"(
uniform vec2 size;
vec4 toClip(vec2 px) { return vec4(2.0 * px / size - 1.0, 0.0, 1.0); }
vec4 timesAlpha(vec4 color) { return vec4(color.rgb * color.a, color.a); }
)";

inline constexpr const char* triangleVertex = R"(
layout(location = 0) in vec2 at;
layout(location = 1) in vec4 color;
flat out vec4 fill;
void main() {
  fill = timesAlpha(color);
  gl_Position = toClip(at);
}
)";
inline constexpr const char* triangleFragment = R"(
flat in vec4 fill;
out vec4 pixel;
void main() { pixel = fill; }
)";

/// A disc as a square of two triangles, and as a point. No pixel whose middle is more than half a pixel
/// outside the disc is covered; 1/32 px more makes up for the rounding of the square's corners.
inline constexpr const char* discVertex = R"(
layout(location = 0) in vec2 at;
layout(location = 1) in float radius;
layout(location = 2) in vec4 color;
flat out vec3 disc;
flat out vec4 fill;
void main() {
  disc = vec3(at, radius + 0.5);
  fill = timesAlpha(color);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  gl_Position = toClip(at + corner * (disc.z + 0.03125));
}
)";
inline constexpr const char* pointVertex = R"(
layout(location = 0) in vec2 at;
layout(location = 1) in float radius;
layout(location = 2) in vec4 color;
flat out vec3 disc;
flat out vec4 fill;
void main() {
  disc = vec3(at, radius + 0.5);
  fill = timesAlpha(color);
  gl_PointSize = 2.0 * (disc.z + 0.03125);
  gl_Position = toClip(at);
}
)";
/// Both; the middle of the pixel is in the coordinates of the picture.
inline constexpr const char* discFragment = R"(
flat in vec3 disc;
flat in vec4 fill;
out vec4 pixel;
void main() { pixel = fill * clamp(disc.z - distance(gl_FragCoord.xy, disc.xy), 0.0, 1.0); }
)";

/// `place` is px along the line from its tail, and px beside it.
inline constexpr const char* lineVertex = R"(
layout(location = 0) in vec2 from;
layout(location = 1) in vec2 to;
layout(location = 2) in vec2 widthAndHead;
layout(location = 3) in vec4 color;
out vec2 place;
flat out vec3 shape;
flat out vec4 fill;
void main() {
  float len = distance(from, to);
  vec2 along = len > 0.0 ? (to - from) / len : vec2(1.0, 0.0);
  vec2 beside = vec2(-along.y, along.x);
  float halfWidth = 0.5 * widthAndHead.x;
  // Beyond these nothing is covered: see the fragment shader.
  float shaftReach = halfWidth + 0.55, headReach = widthAndHead.y > 0.0 ? 0.4 * widthAndHead.y + 0.8 : 0.0;
  float reach = max(shaftReach, headReach), tip = max(shaftReach, headReach > 0.0 ? 1.4 : 0.0);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  place = vec2(mix(-shaftReach, len + tip, corner.x), mix(-reach, reach, corner.y));
  shape = vec3(len, halfWidth, widthAndHead.y);
  fill = timesAlpha(color);
  gl_Position = toClip(from + along * place.x + beside * place.y);
}
)";
inline constexpr const char* lineFragment = R"(
in vec2 place;
flat in vec3 shape;
flat in vec4 fill;
out vec4 pixel;
void main() {
  float len = shape.x, halfWidth = shape.y, head = shape.z;
  float shaft = len - head;
  float past = place.x - clamp(place.x, 0.0, shaft);
  float cover = clamp(halfWidth + 0.5 - length(vec2(past, place.y)), 0.0, 1.0);
  if (head > 0.0) {
    // Half the head's width is 0.4 of the way to its tip; 0.928 makes a distance of that, square to the edge.
    float slant = ((len - place.x) * 0.4 - abs(place.y)) * 0.928;
    cover = max(cover, clamp(min(slant, place.x - shaft) + 0.5, 0.0, 1.0));
  }
  pixel = fill * cover;
}
)";

/// The user interface: triangles whose coverage comes from the glyphs' texture.
inline constexpr const char* uiVertex = R"(
layout(location = 0) in vec2 at;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
out vec2 glyph;
out vec4 fill;
void main() {
  glyph = uv;
  fill = timesAlpha(color);
  gl_Position = toClip(at);
}
)";
inline constexpr const char* uiFragment = R"(
uniform sampler2D glyphs;
in vec2 glyph;
in vec4 fill;
out vec4 pixel;
void main() { pixel = fill * texture(glyphs, glyph).r; }
)";

}  // namespace bedmix::shaders
