// SPDX-License-Identifier: MIT
#include "render/surface.h"

#include "render/gl.h"
#include "render/shaders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <new>
#include <span>

namespace bedmix {

namespace {

/// A buffer that grows but is never made anew.
struct Buffer {
  GLuint name = 0;
  std::size_t capacity = 0;
};

/// One field of a vertex or an instance.
struct Attribute {
  int components;
  GLenum type;  // of bytes: read as 0 to 1
  std::size_t offset;
};

/// A kind of shape: its program, its vertex layout and the buffer its instances are streamed through.
struct Pipeline {
  GLuint program = 0;
  GLint size = -1;  // the uniform
  GLuint layout = 0;
  Buffer buffer;
};

struct TriangleVertex {
  Vec2f at;
  Rgba color;
};

}  // namespace

struct Surface::State {
  std::unique_ptr<GlContext> context;
  Gl gl;
  Pipeline triangles, points, discs, lines, ui;
  Buffer uiIndices;
  std::array<GLuint, 2> glyphs{};  // textures, by Ui
  GLuint canvas = 0, pixels = 0;   // what is drawn into, and its memory
  Size canvasSize;
  Image* image = nullptr;
  float largestPoint = 0.0f;  // px, side of the largest square OpenGL draws as a point
  std::vector<TriangleVertex> corners;

  GLuint compile(GLenum kind, const char* source);
  Pipeline makePipeline(const char* vertex, const char* fragment, std::size_t stride, bool instanced,
                        std::initializer_list<Attribute> attributes);
  bool makePipelines();
  void makeCanvas(Size size);
  void fill(Buffer& buffer, GLenum target, const void* data, std::size_t bytes);
  void clip(const Box& box);
  /// Binds the pipeline with `items` in its buffer; false when there is nothing to draw.
  template <class T>
  bool use(Pipeline& pipeline, std::span<const T> items);
  bool isPoint(const Disc& disc) const;
  void draw(std::span<const Disc> discs);
};

GLuint Surface::State::compile(GLenum kind, const char* source) {
  const GLuint shader = gl.CreateShader(kind);
  const char* parts[] = {shaders::version, kind == GL_VERTEX_SHADER ? shaders::vertexTools : "", source};
  gl.ShaderSource(shader, 3, parts, nullptr);
  gl.CompileShader(shader);
  return shader;
}

Pipeline Surface::State::makePipeline(const char* vertex, const char* fragment, std::size_t stride,
                                      bool instanced, std::initializer_list<Attribute> attributes) {
  Pipeline pipeline;
  pipeline.program = gl.CreateProgram();
  for (const GLuint shader : {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)}) {
    gl.AttachShader(pipeline.program, shader);
    gl.DeleteShader(shader);
  }
  gl.LinkProgram(pipeline.program);
  pipeline.size = gl.GetUniformLocation(pipeline.program, "size");

  gl.GenVertexArrays(1, &pipeline.layout);
  gl.BindVertexArray(pipeline.layout);
  gl.GenBuffers(1, &pipeline.buffer.name);
  gl.BindBuffer(GL_ARRAY_BUFFER, pipeline.buffer.name);
  GLuint location = 0;
  for (const Attribute& a : attributes) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, a.components, a.type, a.type == GL_UNSIGNED_BYTE,
                           static_cast<GLsizei>(stride), reinterpret_cast<const void*>(a.offset));
    gl.VertexAttribDivisor(location, instanced ? 1 : 0);
    ++location;
  }
  return pipeline;
}

bool Surface::State::makePipelines() {
  triangles = makePipeline(
      shaders::triangleVertex, shaders::triangleFragment, sizeof(TriangleVertex), false,
      {{2, GL_FLOAT, offsetof(TriangleVertex, at)}, {4, GL_UNSIGNED_BYTE, offsetof(TriangleVertex, color)}});
  const std::initializer_list<Attribute> disc{{2, GL_FLOAT, offsetof(Disc, at)},
                                              {1, GL_FLOAT, offsetof(Disc, radius)},
                                              {4, GL_UNSIGNED_BYTE, offsetof(Disc, color)}};
  points = makePipeline(shaders::pointVertex, shaders::discFragment, sizeof(Disc), false, disc);
  discs = makePipeline(shaders::discVertex, shaders::discFragment, sizeof(Disc), true, disc);
  static_assert(offsetof(Line, head) == offsetof(Line, width) + sizeof(float));
  lines = makePipeline(shaders::lineVertex, shaders::lineFragment, sizeof(Line), true,
                       {{2, GL_FLOAT, offsetof(Line, from)},
                        {2, GL_FLOAT, offsetof(Line, to)},
                        {2, GL_FLOAT, offsetof(Line, width)},
                        {4, GL_UNSIGNED_BYTE, offsetof(Line, color)}});
  ui = makePipeline(shaders::uiVertex, shaders::uiFragment, sizeof(UiVertex), false,
                    {{2, GL_FLOAT, offsetof(UiVertex, at)},
                     {2, GL_FLOAT, offsetof(UiVertex, uv)},
                     {4, GL_UNSIGNED_BYTE, offsetof(UiVertex, color)}});
  gl.GenBuffers(1, &uiIndices.name);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, uiIndices.name);  // belongs to the ui's layout from here on
  for (const Pipeline* pipeline : {&triangles, &points, &discs, &lines, &ui}) {
    GLint linked = 0;
    gl.GetProgramiv(pipeline->program, GL_LINK_STATUS, &linked);
    if (!linked) return false;
  }
  return true;
}

/// Pictures have one size, as a rule.
void Surface::State::makeCanvas(Size size) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, canvas);
  if (size == canvasSize) return;
  gl.BindRenderbuffer(GL_RENDERBUFFER, pixels);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) throw std::bad_alloc();
  canvasSize = size;
}

void Surface::State::fill(Buffer& buffer, GLenum target, const void* data, std::size_t bytes) {
  gl.BindBuffer(target, buffer.name);
  if (bytes > buffer.capacity) {
    buffer.capacity = 2 * bytes;
    gl.BufferData(target, static_cast<GLsizeiptr>(buffer.capacity), nullptr, GL_STREAM_DRAW);
  }
  gl.BufferSubData(target, 0, static_cast<GLsizeiptr>(bytes), data);
}

void Surface::State::clip(const Box& box) {
  const int left = static_cast<int>(std::floor(box.left)), right = static_cast<int>(std::ceil(box.right));
  const int top = static_cast<int>(std::floor(box.top)), bottom = static_cast<int>(std::ceil(box.bottom));
  gl.Scissor(left, top, std::max(0, right - left), std::max(0, bottom - top));
}

template <class T>
bool Surface::State::use(Pipeline& pipeline, std::span<const T> items) {
  if (items.empty()) return false;
  gl.BindVertexArray(pipeline.layout);
  fill(pipeline.buffer, GL_ARRAY_BUFFER, items.data(), items.size_bytes());
  gl.UseProgram(pipeline.program);
  gl.Uniform2f(pipeline.size, static_cast<float>(image->size.width), static_cast<float>(image->size.height));
  return true;
}

/// A point costs about half as much as two triangles, but is not drawn at all where its middle is outside the
/// picture.
bool Surface::State::isPoint(const Disc& disc) const {
  constexpr float rounding = 1.0f;  // px, more than that of any OpenGL
  return 2.0f * (disc.radius + rounding) <= largestPoint && disc.at.x >= rounding && disc.at.y >= rounding &&
         disc.at.x <= static_cast<float>(image->size.width) - rounding &&
         disc.at.y <= static_cast<float>(image->size.height) - rounding;
}

/// One after the other in runs of a kind; nearly always there is one run.
void Surface::State::draw(std::span<const Disc> all) {
  while (!all.empty()) {
    const bool point = isPoint(all.front());
    const auto other =
        std::find_if(all.begin(), all.end(), [&](const Disc& d) { return isPoint(d) != point; });
    const auto run = all.first(static_cast<std::size_t>(other - all.begin()));
    const auto count = static_cast<GLsizei>(run.size());
    use(point ? points : discs, run);
    if (point)
      gl.DrawArrays(GL_POINTS, 0, count);
    else
      gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    all = all.subspan(run.size());
  }
}

Surface::Surface(std::unique_ptr<State> state) : state_(std::move(state)) {}
Surface::~Surface() = default;
Surface::Surface(Surface&&) noexcept = default;
Surface& Surface::operator=(Surface&&) noexcept = default;

Result<Surface> Surface::create(int threads, GlSource source) {
  Result<std::unique_ptr<GlContext>> context = createGlContext(threads, source);
  if (!context) return context.problems;
  auto state = std::make_unique<State>();
  state->context = std::move(*context);
  if (!state->context->makeCurrent() || !state->gl.load(*state->context) || !state->makePipelines())
    return Diagnostic{
        {}, "this OpenGL cannot run bedmix's shaders; Mesa's llvmpipe can", Trouble::unavailable};
  const Gl& gl = state->gl;
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  float pointSizes[2]{};
  gl.GetFloatv(GL_POINT_SIZE_RANGE, pointSizes);
  state->largestPoint = pointSizes[1];
  gl.GenTextures(static_cast<GLsizei>(state->glyphs.size()), state->glyphs.data());
  gl.GenFramebuffers(1, &state->canvas);
  gl.GenRenderbuffers(1, &state->pixels);
  state->context->release();
  return Surface(std::move(state));
}

void Surface::setGlyphs(const GlyphSheet& sheet, Ui ui) {
  state_->context->makeCurrent();
  const Gl& gl = state_->gl;
  gl.BindTexture(GL_TEXTURE_2D, state_->glyphs[static_cast<std::size_t>(ui)]);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, sheet.size.width, sheet.size.height, 0, GL_RED, GL_UNSIGNED_BYTE,
                sheet.coverage.data());
  state_->context->release();
}

void Surface::begin(Image& image, Rgba ground) {
  state_->image = &image;
  state_->context->makeCurrent();
  state_->makeCanvas(image.size);
  const Gl& gl = state_->gl;
  gl.Viewport(0, 0, image.size.width, image.size.height);
  gl.Scissor(0, 0, image.size.width, image.size.height);
  gl.ClearColor(ground.r / 255.0f, ground.g / 255.0f, ground.b / 255.0f, 1.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

void Surface::draw(const DrawList& list) {
  State& s = *state_;
  s.clip(list.clip);
  s.corners.clear();
  for (const Triangle& t : list.triangles)
    for (const Vec2f& at : {t.a, t.b, t.c}) s.corners.push_back({at, t.color});
  if (s.use<TriangleVertex>(s.triangles, s.corners))
    s.gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(s.corners.size()));
  s.draw(list.discs);
  if (s.use<Line>(s.lines, list.lines))
    s.gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(list.lines.size()));
}

void Surface::draw(const UiMesh& mesh, Ui ui) {
  State& s = *state_;
  if (!s.use<UiVertex>(s.ui, mesh.vertices)) return;
  s.gl.BindTexture(GL_TEXTURE_2D, s.glyphs[static_cast<std::size_t>(ui)]);
  s.fill(s.uiIndices, GL_ELEMENT_ARRAY_BUFFER, mesh.indices.data(),
         mesh.indices.size() * sizeof(mesh.indices[0]));
  for (const UiCommand& command : mesh.commands) {
    s.clip(command.clip);
    s.gl.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.count), GL_UNSIGNED_SHORT,
                                reinterpret_cast<const void*>(command.first * sizeof(mesh.indices[0])),
                                static_cast<GLint>(command.base));
  }
}

void Surface::end() {
  Image& image = *state_->image;
  state_->gl.ReadPixels(0, 0, image.size.width, image.size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.rgba.data());
  state_->context->release();  // the next picture may be another thread's
}

std::string Surface::description() const {
  state_->context->makeCurrent();
  const auto text = [&](GLenum name) { return reinterpret_cast<const char*>(state_->gl.GetString(name)); };
  std::string description =
      fmt::format("{}, {}, OpenGL {}", state_->context->name(), text(GL_RENDERER), text(GL_VERSION));
  state_->context->release();
  return description;
}

Result<std::string> probeSurface(GlSource source) {
  const Result<Surface> surface = Surface::create(0, source);
  if (!surface) return surface.problems;
  return surface->description();
}

std::vector<Diagnostic> sizeProblems(Size size) {
  const auto fits = [](int side) { return side >= smallestSide && side <= largestSide; };
  if (fits(size.width) && fits(size.height)) return {};
  return {{{},
           fmt::format("a picture of {}x{} cannot be drawn: each side must have {} to {} pixels", size.width,
                       size.height, smallestSide, largestSide)}};
}

}  // namespace bedmix
