// Lists folders, and tells folders from files.
#include "gallery/file_dialog.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace carom::gallery
{

namespace
{

std::filesystem::path with_home(const std::string& name)
{
    const char* const home = std::getenv("HOME");
    if (home && (name == "~" || name.starts_with("~/")))
        return std::filesystem::path(home) / name.substr(std::min<std::size_t>(2, name.size()));
    return name;
}

bool comes_before(const FileDialog::Entry& a, const FileDialog::Entry& b)
{
    return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
}

} // namespace

void FileDialog::open()
{
    is_open_ = true;
    error.clear();
    std::error_code ignored;
    enter(folder_.empty() ? std::filesystem::current_path(ignored) : folder_);
}

void FileDialog::enter(const std::filesystem::path& folder)
{
    std::error_code problem;
    std::vector<Entry> entries;
    std::filesystem::directory_iterator next(folder, problem);
    for (const std::filesystem::directory_iterator end; !problem && next != end; next.increment(problem))
    {
        std::error_code ignored; // a link that leads nowhere is no folder
        const bool is_folder = next->is_directory(ignored);
        const std::string name = next->path().filename().string();
        if (!name.starts_with(".") && (is_folder || next->path().extension() == ".json")) entries.push_back({name, is_folder});
    }
    if (problem)
    {
        error = "can't read \"" + folder.string() + "\": " + problem.message();
        return;
    }
    std::sort(entries.begin(), entries.end(), comes_before);
    folder_ = folder;
    entries_ = std::move(entries);
    typed.clear();
}

std::optional<std::filesystem::path> FileDialog::choose(const std::string& name)
{
    error.clear();
    if (name.empty()) return std::nullopt;
    const std::filesystem::path path = (folder_ / with_home(name)).lexically_normal();
    std::error_code problem;
    const std::filesystem::file_status status = std::filesystem::status(path, problem);
    if (std::filesystem::is_directory(status))
        enter(path);
    else if (std::filesystem::exists(status))
        return path;
    else
        error = "can't read \"" + path.string() + "\": " + (problem ? problem.message() : "there is no such file");
    return std::nullopt;
}

} // namespace carom::gallery
