// SPDX-License-Identifier: MIT
#pragma once

#include "render/gl_context.h"

#include <GL/glcorearb.h>

namespace bedmix {

/// The OpenGL functions the surface uses, taken from its context and never from a libGL.
#define BEDMIX_GL_FUNCTIONS(X)                        \
  X(ATTACHSHADER, AttachShader)                       \
  X(BINDBUFFER, BindBuffer)                           \
  X(BINDFRAMEBUFFER, BindFramebuffer)                 \
  X(BINDRENDERBUFFER, BindRenderbuffer)               \
  X(BINDTEXTURE, BindTexture)                         \
  X(BINDVERTEXARRAY, BindVertexArray)                 \
  X(BLENDFUNC, BlendFunc)                             \
  X(BUFFERDATA, BufferData)                           \
  X(BUFFERSUBDATA, BufferSubData)                     \
  X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)   \
  X(CLEAR, Clear)                                     \
  X(CLEARCOLOR, ClearColor)                           \
  X(COMPILESHADER, CompileShader)                     \
  X(CREATEPROGRAM, CreateProgram)                     \
  X(CREATESHADER, CreateShader)                       \
  X(DELETESHADER, DeleteShader)                       \
  X(DISABLE, Disable)                                 \
  X(DRAWARRAYS, DrawArrays)                           \
  X(DRAWARRAYSINSTANCED, DrawArraysInstanced)         \
  X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex)   \
  X(ENABLE, Enable)                                   \
  X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) \
  X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer) \
  X(GENBUFFERS, GenBuffers)                           \
  X(GENFRAMEBUFFERS, GenFramebuffers)                 \
  X(GENRENDERBUFFERS, GenRenderbuffers)               \
  X(GENTEXTURES, GenTextures)                         \
  X(GENVERTEXARRAYS, GenVertexArrays)                 \
  X(GETFLOATV, GetFloatv)                             \
  X(GETPROGRAMIV, GetProgramiv)                       \
  X(GETSTRING, GetString)                             \
  X(GETUNIFORMLOCATION, GetUniformLocation)           \
  X(LINKPROGRAM, LinkProgram)                         \
  X(PIXELSTOREI, PixelStorei)                         \
  X(READPIXELS, ReadPixels)                           \
  X(RENDERBUFFERSTORAGE, RenderbufferStorage)         \
  X(SCISSOR, Scissor)                                 \
  X(SHADERSOURCE, ShaderSource)                       \
  X(TEXIMAGE2D, TexImage2D)                           \
  X(TEXPARAMETERI, TexParameteri)                     \
  X(UNIFORM2F, Uniform2f)                             \
  X(USEPROGRAM, UseProgram)                           \
  X(VERTEXATTRIBDIVISOR, VertexAttribDivisor)         \
  X(VERTEXATTRIBPOINTER, VertexAttribPointer)         \
  X(VIEWPORT, Viewport)

struct Gl {
#define BEDMIX_GL_DECLARE(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
  BEDMIX_GL_FUNCTIONS(BEDMIX_GL_DECLARE)
#undef BEDMIX_GL_DECLARE

  /// False where the context lacks one of them.
  bool load(const GlContext& context) {
    bool all = true;
#define BEDMIX_GL_LOAD(TYPE, NAME)                                          \
  NAME = reinterpret_cast<PFNGL##TYPE##PROC>(context.function("gl" #NAME)); \
  all = all && NAME;
    BEDMIX_GL_FUNCTIONS(BEDMIX_GL_LOAD)
#undef BEDMIX_GL_LOAD
    return all;
  }
};

}  // namespace bedmix
