// A ring of OpenGL's queries of the time. Two timestamps, since a query of elapsed time that holds a clear gives nonsense on Mesa's software renderer.
#include "gallery/gpu_timer.hpp"

#include <epoxy/gl.h>

namespace carom::gallery
{

namespace
{

GLuint64 answer_of(unsigned query)
{
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    return nanoseconds;
}

bool is_there(unsigned query)
{
    GLint there = GL_FALSE;
    glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &there);
    return there != GL_FALSE;
}

} // namespace

GpuTimer::GpuTimer()
{
    for (Pair& pair : queries_)
    {
        glGenQueries(1, &pair.begin);
        glGenQueries(1, &pair.end);
    }
}

GpuTimer::~GpuTimer()
{
    for (const Pair& pair : queries_)
    {
        glDeleteQueries(1, &pair.begin);
        glDeleteQueries(1, &pair.end);
    }
}

void GpuTimer::begin()
{
    collect();
    if (is_running_ || asked_ - answered_ == ring_size) return;
    glQueryCounter(queries_[asked_ % ring_size].begin, GL_TIMESTAMP);
    is_running_ = true;
}

void GpuTimer::end()
{
    if (!is_running_) return;
    glQueryCounter(queries_[asked_ % ring_size].end, GL_TIMESTAMP);
    is_running_ = false;
    ++asked_;
}

std::optional<double> GpuTimer::latest_ms()
{
    collect();
    return latest_ms_;
}

void GpuTimer::collect()
{
    while (answered_ < asked_)
    {
        const Pair& pair = queries_[answered_ % ring_size];
        if (!is_there(pair.end)) return;
        const GLuint64 begin = answer_of(pair.begin);
        const GLuint64 end = answer_of(pair.end);
        if (end >= begin) latest_ms_ = 1e-6 * static_cast<double>(end - begin);
        ++answered_;
    }
}

} // namespace carom::gallery
