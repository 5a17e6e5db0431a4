// Walks the fields of each part and writes those that are not at their defaults.
#include "scene_file/writer.hpp"

#include "files/output_file.hpp"
#include "scene_file/check.hpp"
#include "scene_file/json_values.hpp"

#include <nlohmann/json.hpp>
#include <sstream>
#include <type_traits>

namespace carom::scene_file
{

using nlohmann::ordered_json;

namespace
{

/// Text that is not UTF-8 gets a mark where it is not, rather than an exception.
std::string line_of(const ordered_json& json) { return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace); }

/// Writes the whole, one element of a list a line.
class FileWriter
{
public:
    FileWriter(std::ostream& out, const SceneFile& file) : out_(out), file_(file) {}

    template <class M>
    void operator()(const char* name, M SceneFile::* member, const Rule& rule)
    {
        M needs;
        const M& value = with_needs(member, needs);
        if (!rule.is_required && are_same(value, defaults_.*member)) return;
        out_ << (is_first_ ? "{\n" : ",\n") << '"' << name << "\": ";
        is_first_ = false;
        write(value);
    }
    void finish() { out_ << "\n}\n"; }

private:
    /// The value of a field; of `needs` what needs_of() has it.
    template <class M>
    const M& with_needs(M SceneFile::* member, M& needs)
    {
        if constexpr (std::is_same_v<M, std::vector<std::string>>)
        {
            if (member == &SceneFile::needs) return needs = needs_of(file_);
        }
        return file_.*member;
    }

    template <class T>
    void write(const T& value)
    {
        out_ << line_of(json_of(value));
    }
    void write(const std::vector<std::string>& list) { out_ << line_of(json_of(list)); }
    template <class T>
    void write(const std::vector<T>& list)
    {
        for (std::size_t i = 0; i < list.size(); ++i) out_ << (i == 0 ? "[\n" : ",\n") << line_of(json_of(list[i]));
        out_ << (list.empty() ? "[]" : "\n]");
    }

    std::ostream& out_;
    const SceneFile& file_;
    const SceneFile defaults_ = {};
    bool is_first_ = true;
};

} // namespace

void write_scene_file(std::ostream& out, const SceneFile& file)
{
    FileWriter writer(out, file);
    Fields<SceneFile>::visit(writer);
    writer.finish();
}

std::string scene_file_text(const SceneFile& file)
{
    std::ostringstream out;
    write_scene_file(out, file);
    return std::move(out).str();
}

void write_scene_file(const std::filesystem::path& path, const SceneFile& file)
{
    try
    {
        files::OutputFile out("", path == "-" ? "./-" : path); // a library does not print
        write_scene_file(out.stream(), file);
        out.commit();
    }
    catch (const files::FileError& error)
    {
        const std::string_view text = error.what(); // can't write "level.json": No space left on device
        const std::size_t reason = text.find("\": ");
        throw SceneFileError(
            {.source = path.string(),
             .message = "can't be written: " + std::string(reason == std::string_view::npos ? text : text.substr(reason + 3))});
    }
}

} // namespace carom::scene_file
