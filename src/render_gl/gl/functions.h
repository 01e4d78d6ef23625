// The functions of OpenGL that the renderer calls, as a table of pointers that belongs to one context. All
// are in OpenGL ES 3.0 (and so in WebGL 2), and in OpenGL 3.3 with two extensions that are part of 4.2.
//
// Errors: OpenGL keeps the first error until it is asked. check() asks, once per frame and after everything
// that may run out of memory. In debug builds, it also asks for the driver's messages (KHR_debug), so that no
// error is ignored.
#pragma once

#include <GLES3/gl3.h>
// Needs the one above.
#include <GLES2/gl2ext.h>

#include <functional>
#include <string>

#include "base/result.h"

namespace temblor::render_gl {

// The address of a function by its name; null if the driver lacks it.
using FunctionFinder = std::function<void*(const char* name)>;

#define TEMBLOR_GL_FUNCTIONS(X)                                \
  X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                     \
  X(PFNGLATTACHSHADERPROC, AttachShader)                       \
  X(PFNGLBEGINQUERYPROC, BeginQuery)                           \
  X(PFNGLBINDBUFFERPROC, BindBuffer)                           \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                 \
  X(PFNGLBINDTEXTUREPROC, BindTexture)                         \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                 \
  X(PFNGLBLENDFUNCPROC, BlendFunc)                             \
  X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)             \
  X(PFNGLBUFFERDATAPROC, BufferData)                           \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)   \
  X(PFNGLCLEARPROC, Clear)                                     \
  X(PFNGLCLEARCOLORPROC, ClearColor)                           \
  X(PFNGLCLEARDEPTHFPROC, ClearDepthf)                         \
  X(PFNGLCOLORMASKPROC, ColorMask)                             \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                     \
  X(PFNGLCOPYTEXSUBIMAGE2DPROC, CopyTexSubImage2D)             \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                     \
  X(PFNGLCREATESHADERPROC, CreateShader)                       \
  X(PFNGLCULLFACEPROC, CullFace)                               \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                     \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)           \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                     \
  X(PFNGLDELETEQUERIESPROC, DeleteQueries)                     \
  X(PFNGLDELETESHADERPROC, DeleteShader)                       \
  X(PFNGLDELETETEXTURESPROC, DeleteTextures)                   \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)           \
  X(PFNGLDEPTHFUNCPROC, DepthFunc)                             \
  X(PFNGLDEPTHMASKPROC, DepthMask)                             \
  X(PFNGLDEPTHRANGEFPROC, DepthRangef)                         \
  X(PFNGLDISABLEPROC, Disable)                                 \
  X(PFNGLDRAWARRAYSPROC, DrawArrays)                           \
  X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced)         \
  X(PFNGLDRAWELEMENTSPROC, DrawElements)                       \
  X(PFNGLENABLEPROC, Enable)                                   \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray) \
  X(PFNGLENDQUERYPROC, EndQuery)                               \
  X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)       \
  X(PFNGLFRAMEBUFFERTEXTURELAYERPROC, FramebufferTextureLayer) \
  X(PFNGLGENBUFFERSPROC, GenBuffers)                           \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                 \
  X(PFNGLGENQUERIESPROC, GenQueries)                           \
  X(PFNGLGENTEXTURESPROC, GenTextures)                         \
  X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                 \
  X(PFNGLGETERRORPROC, GetError)                               \
  X(PFNGLGETINTEGERVPROC, GetIntegerv)                         \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)             \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                       \
  X(PFNGLGETQUERYOBJECTUIVPROC, GetQueryObjectuiv)             \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)               \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)                         \
  X(PFNGLGETSTRINGPROC, GetString)                             \
  X(PFNGLGETSTRINGIPROC, GetStringi)                           \
  X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)           \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                         \
  X(PFNGLPIXELSTOREIPROC, PixelStorei)                         \
  X(PFNGLREADPIXELSPROC, ReadPixels)                           \
  X(PFNGLSCISSORPROC, Scissor)                                 \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                       \
  X(PFNGLTEXPARAMETERIPROC, TexParameteri)                     \
  X(PFNGLTEXSTORAGE2DPROC, TexStorage2D)                       \
  X(PFNGLTEXSTORAGE3DPROC, TexStorage3D)                       \
  X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                     \
  X(PFNGLTEXSUBIMAGE3DPROC, TexSubImage3D)                     \
  X(PFNGLUNIFORM1FPROC, Uniform1f)                             \
  X(PFNGLUNIFORM1IPROC, Uniform1i)                             \
  X(PFNGLUNIFORM1UIPROC, Uniform1ui)                           \
  X(PFNGLUNIFORM2FPROC, Uniform2f)                             \
  X(PFNGLUNIFORM2IPROC, Uniform2i)                             \
  X(PFNGLUNIFORM3FPROC, Uniform3f)                             \
  X(PFNGLUNIFORM4FPROC, Uniform4f)                             \
  X(PFNGLUNIFORM4FVPROC, Uniform4fv)                           \
  X(PFNGLUNIFORM4IPROC, Uniform4i)                             \
  X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)               \
  X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)               \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                           \
  X(PFNGLVERTEXATTRIBDIVISORPROC, VertexAttribDivisor)         \
  X(PFNGLVERTEXATTRIBIPOINTERPROC, VertexAttribIPointer)       \
  X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)         \
  X(PFNGLVIEWPORTPROC, Viewport)

struct Functions {
#define TEMBLOR_GL_MEMBER(Type, Name) Type Name = nullptr;
  TEMBLOR_GL_FUNCTIONS(TEMBLOR_GL_MEMBER)
#undef TEMBLOR_GL_MEMBER
  // An extension (EXT_clip_control), and null without it. With it, depth keeps its precision far away.
  PFNGLCLIPCONTROLEXTPROC ClipControl = nullptr;
  // Whether textures have the parameter of EXT_texture_filter_anisotropic.
  bool has_anisotropy = false;
  // Whether queries have GL_TIME_ELAPSED_EXT. Drivers in software have it, too, but only measure parts.
  bool has_timer = false;
  bool has_disjoint_timer = false;  // GL_GPU_DISJOINT_EXT tells whether times are wrong
  // Tells whether a context that asked for it is lost (KHR_robustness); null if the driver cannot tell.
  PFNGLGETGRAPHICSRESETSTATUSKHRPROC GetGraphicsResetStatus = nullptr;
  // The messages of a debug context (KHR_debug); null in release builds and in other contexts.
  PFNGLGETDEBUGMESSAGELOGKHRPROC GetDebugMessageLog = nullptr;

  // Fails with kIo, and a line that begins with `doing`, if an error occurred since the last call, or if the
  // driver reported one of high severity.
  base::Status check(const char* doing) const;
  // Fails with kIo if the driver reports that the context is lost. Asking may take some time, so once per
  // frame is enough.
  base::Status check_context() const;
};

// The functions of the current context. Fails with kUnsupported if one is missing, or if the context is older
// than OpenGL ES 3.0 or OpenGL 3.3.
base::Result<Functions> load_functions(const FunctionFinder& find);

// Driver and version, for a person: "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL ES 3.2 Mesa 22.3.6".
std::string describe_driver(const Functions& gl);

}  // namespace temblor::render_gl
