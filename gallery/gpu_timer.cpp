// A ring of OpenGL's queries of elapsed time.
#include "gallery/gpu_timer.hpp"

#include <epoxy/gl.h>

namespace carom::gallery
{

GpuTimer::GpuTimer() { glGenQueries(static_cast<GLsizei>(ring_size), queries_.data()); }

GpuTimer::~GpuTimer()
{
    end();
    glDeleteQueries(static_cast<GLsizei>(ring_size), queries_.data());
}

void GpuTimer::begin()
{
    collect();
    if (is_running_ || asked_ - answered_ == ring_size) return;
    begins_[asked_ % ring_size] = Clock::now();
    glBeginQuery(GL_TIME_ELAPSED, queries_[asked_ % ring_size]);
    is_running_ = true;
}

void GpuTimer::end()
{
    if (!is_running_) return;
    glEndQuery(GL_TIME_ELAPSED);
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
        const std::size_t place = answered_ % ring_size;
        GLint is_there = GL_FALSE;
        glGetQueryObjectiv(queries_[place], GL_QUERY_RESULT_AVAILABLE, &is_there);
        if (!is_there) return;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(queries_[place], GL_QUERY_RESULT, &nanoseconds);
        const double milliseconds = 1e-6 * static_cast<double>(nanoseconds);
        const std::chrono::duration<double, std::milli> since = Clock::now() - begins_[place];
        if (milliseconds <= since.count()) latest_ms_ = milliseconds;
        ++answered_;
    }
}

} // namespace carom::gallery
