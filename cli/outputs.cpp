// Opens outputs side by side.
#include "cli/outputs.hpp"

#include "cli/errors.hpp"
#include "files/text.hpp"

#include <algorithm>

namespace carom::cli
{

files::OutputFile& Outputs::open(const std::string& option, const std::string& path)
{
    auto file = std::make_unique<files::OutputFile>(option, path, files::OutputOptions{.standard_output = &surroundings_.out});
    const auto is_taken = [&](const auto& other) { return file->has_same_target(*other); };
    if (std::any_of(files_.begin(), files_.end(), is_taken))
        throw BadUsage(option + ": another option writes " + files::quoted(path) + " too; give each a file of its own");
    return *files_.emplace_back(std::move(file));
}

files::OutputFile* Outputs::open(const std::string& option, const std::optional<std::string>& path)
{
    return path ? &open(option, *path) : nullptr;
}

std::ostream& Outputs::words() const
{
    const auto is_out = [](const auto& file) { return files::is_standard_output(file->path()); };
    return std::any_of(files_.begin(), files_.end(), is_out) ? surroundings_.err : surroundings_.out;
}

} // namespace carom::cli
