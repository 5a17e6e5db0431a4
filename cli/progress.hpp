// Says on a terminal how far a long run is and how long it will still take.
#pragma once

#include <chrono>
#include <ostream>
#include <string>

namespace carom::cli
{

/// One line that is written over and over, and wiped at the end.
class Progress
{
public:
    /// @param is_terminal when false nothing is ever written
    Progress(std::ostream& out, bool is_terminal, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more of the total is done.
    void advance();
    /// Wipes the line, so that other output can follow.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    std::ostream& out_;
    bool is_terminal_;
    int total_;
    int done_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_ = start_;
    bool has_line_ = false;
};

/// "12 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

} // namespace carom::cli
