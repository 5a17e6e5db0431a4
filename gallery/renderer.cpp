// One draw call for a whole picture: OpenGL blends instances in their order, and that is the order of the draw list.
#include "gallery/renderer.hpp"

#include "gallery/failure.hpp"
#include "gallery/shaders.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <epoxy/gl.h>
#include <string>

namespace carom::gallery
{

namespace
{

/// Triangles between the outer rectangle 0..3 and the inner one 4..7; the bits of a corner say right and up.
constexpr std::array<GLubyte, 24> frame = {0, 1, 5, 0, 5, 4, 1, 3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6};

std::string words_of(GLuint object, decltype(glGetShaderiv) get, decltype(glGetShaderInfoLog) get_words)
{
    GLint size = 0;
    get(object, GL_INFO_LOG_LENGTH, &size);
    std::string words(static_cast<std::size_t>(std::max(size, 1)), '\0');
    get_words(object, size, nullptr, words.data());
    return words.c_str();
}

class Shader
{
public:
    /// @throws Failure
    Shader(GLenum kind, const char* source) : name_(glCreateShader(kind))
    {
        glShaderSource(name_, 1, &source, nullptr);
        glCompileShader(name_);
        GLint is_good = GL_FALSE;
        glGetShaderiv(name_, GL_COMPILE_STATUS, &is_good);
        if (is_good) return;
        const std::string words = words_of(name_, glGetShaderiv, glGetShaderInfoLog);
        glDeleteShader(name_);
        throw Failure("the graphics driver refuses a shader: " + words + " Update the driver.");
    }
    ~Shader() { glDeleteShader(name_); } // it lives on in the programs that hold it
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    GLuint name() const { return name_; }

private:
    GLuint name_;
};

/// @throws Failure
GLuint linked(const Shader& vertex, const Shader& fragment)
{
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex.name());
    glAttachShader(program, fragment.name());
    glLinkProgram(program);
    GLint is_good = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &is_good);
    if (is_good) return program;
    const std::string words = words_of(program, glGetProgramiv, glGetProgramInfoLog);
    glDeleteProgram(program);
    throw Failure("the graphics driver refuses a program: " + words + " Update the driver.");
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

/// Attribute `place` advances by one instance at a time.
void attribute(GLuint place, GLenum type, GLboolean is_normalized, std::size_t bytes)
{
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, 4, type, is_normalized, sizeof(ShapeInstance), offset(bytes));
    glVertexAttribDivisor(place, 1);
}

bool can_show(const Renderer::View& view)
{
    const scenes::Camera& camera = view.camera;
    return std::isfinite(camera.height) && camera.height > 0 && is_finite(camera.center) && view.viewport.width > 0 &&
           view.viewport.height > 0;
}

} // namespace

Renderer::Renderer() : program_(linked({GL_VERTEX_SHADER, vertex_shader}, {GL_FRAGMENT_SHADER, fragment_shader}))
{
    half_picture_ = glGetUniformLocation(program_, "half_picture");
    make_buffers();
}

Renderer::~Renderer()
{
    glDeleteBuffers(1, &instance_buffer_);
    glDeleteBuffers(1, &frame_indices_);
    glDeleteVertexArrays(1, &vertex_array_);
    glDeleteProgram(program_);
}

void Renderer::make_buffers()
{
    glGenVertexArrays(1, &vertex_array_);
    glGenBuffers(1, &frame_indices_);
    glGenBuffers(1, &instance_buffer_);
    glBindVertexArray(vertex_array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, frame_indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(frame), frame.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, instance_buffer_);
    for (GLuint i = 0; i < 4; ++i) attribute(i, GL_FLOAT, GL_FALSE, offsetof(ShapeInstance, corners) + 4 * sizeof(float) * i);
    attribute(4, GL_FLOAT, GL_FALSE, offsetof(ShapeInstance, radius));
    attribute(5, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ShapeInstance, fill));
    attribute(6, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ShapeInstance, line));
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
}

void Renderer::draw(const scenes::DrawList& list, const View& view, const Theme& theme)
{
    instances_.clear();
    if (can_show(view))
    {
        InstanceMaker maker(view.camera, view.viewport, theme);
        for (const scenes::DrawnLayer& layer : list.layers()) maker.add(layer, instances_);
    }
    last_ = {.draw_calls = instances_.empty() ? 0 : 1, .instances = static_cast<int>(instances_.size())};

    glViewport(0, 0, view.viewport.width, view.viewport.height);
    glDisable(GL_SCISSOR_TEST);
    const scenes::Color ground = theme(list.background);
    glClearColor(ground.r, ground.g, ground.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (instances_.empty()) return;

    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(program_);
    glUniform2f(half_picture_, 0.5f * static_cast<float>(view.viewport.width), 0.5f * static_cast<float>(view.viewport.height));
    glBindVertexArray(vertex_array_);
    upload();
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(frame.size()), GL_UNSIGNED_BYTE, nullptr, last_.instances);
    glBindVertexArray(0);
    glUseProgram(0);
    assert(glGetError() == GL_NO_ERROR);
}

/// Gives the old memory up before the new is filled, so that the card may still read the last frame's.
void Renderer::upload()
{
    const auto capacity = static_cast<GLsizeiptr>(instances_.capacity() * sizeof(ShapeInstance));
    glBindBuffer(GL_ARRAY_BUFFER, instance_buffer_);
    glBufferData(GL_ARRAY_BUFFER, capacity, nullptr, GL_STREAM_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(instances_.size() * sizeof(ShapeInstance)), instances_.data());
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

} // namespace carom::gallery
