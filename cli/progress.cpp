// The line that tells how far a run is.
#include "cli/progress.hpp"

#include <cmath>

namespace carom::cli
{

namespace
{

constexpr std::chrono::milliseconds between_lines(200); // quick enough to look alive, rare enough to cost nothing

} // namespace

Progress::Progress(std::ostream& out, bool is_terminal, int total) : out_(out), is_terminal_(is_terminal), total_(total) {}

Progress::~Progress() { clear(); }

void Progress::clear()
{
    if (has_line_) out_ << "\r\033[K" << std::flush;
    has_line_ = false;
}

void Progress::advance()
{
    ++done_;
    if (!is_terminal_) return;
    const Clock::time_point now = Clock::now();
    if (now - shown_ < between_lines) return;
    shown_ = now;
    has_line_ = true;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double left = elapsed * (total_ - done_) / done_;
    const long percent = std::lround(100.0 * done_ / total_);
    out_ << "\r\033[K" << percent << "%  step " << done_ << " of " << total_ << ", " << duration_text(left) << " left" << std::flush;
}

std::string duration_text(double seconds)
{
    const long whole = std::lround(std::ceil(seconds));
    const long minutes = whole / 60;
    if (whole < 60) return std::to_string(whole) + " s";
    if (minutes < 60) return std::to_string(minutes) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

} // namespace carom::cli
