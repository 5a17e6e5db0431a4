// What CMake knows of the build.
#include "lab/build_info.hpp"

#include <array>
#include <cstdio>
#include <memory>

namespace carom::lab::build_info
{

namespace
{

/// First line of what a command writes; empty when it fails.
std::string line_of(const std::string& command)
{
    struct Close
    {
        void operator()(std::FILE* file) const { ::pclose(file); }
    };
    const std::unique_ptr<std::FILE, Close> pipe(::popen((command + " 2>/dev/null").c_str(), "r"));
    std::array<char, 256> buffer{};
    if (!pipe || !std::fgets(buffer.data(), buffer.size(), pipe.get())) return {};
    std::string line(buffer.data());
    while (!line.empty() && line.back() == '\n') line.pop_back();
    return line;
}

} // namespace

const char* const compiler = CAROM_COMPILER;
const char* const flags = CAROM_FLAGS;

std::string commit()
{
    const std::string git = std::string("git -C '") + CAROM_SOURCE_FOLDER + "' ";
    const std::string name = line_of(git + "rev-parse --short=10 HEAD");
    if (name.empty()) return {};
    return name + (line_of(git + "status --porcelain --untracked-files=no").empty() ? "" : "+");
}

} // namespace carom::lab::build_info
