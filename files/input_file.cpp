// Opens and reads files, and words why that failed.
#include "files/input_file.hpp"

#include "files/text.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

namespace carom::files
{

namespace
{

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why)
{
    throw CannotRead("can't read " + quoted(path) + ": " + why);
}

} // namespace

std::ifstream open_input(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) fail(path, "it is a folder; give a file"); // a folder opens, but can't be read
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, errno != 0 ? std::strerror(errno) : "it can't be opened");
    return file;
}

std::string read_text(const std::filesystem::path& path, std::size_t most_bytes)
{
    std::ifstream file = open_input(path);
    std::string text;
    std::vector<char> part(1 << 16);
    errno = 0;
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())), file.gcount() > 0)
    {
        text.append(part.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > most_bytes) fail(path, "it is longer than " + std::to_string(most_bytes >> 20) + " MiB");
    }
    if (file.bad()) fail(path, errno != 0 ? std::strerror(errno) : "reading failed");
    return text;
}

} // namespace carom::files
