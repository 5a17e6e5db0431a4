// Words for what does not fit, and the path to it.
#include "scene_file/reading.hpp"

#include "files/text.hpp"

#include <array>
#include <cstdio>
#include <utility>

namespace carom::scene_file
{

std::string shortened(std::string_view text)
{
    constexpr std::size_t most = 200;
    if (text.size() <= most) return files::printable_line(text);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end; // not within a character
    return files::printable_line(text.substr(0, end)) + "...";
}

std::string number_text(double value)
{
    std::array<char, 40> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.7g", value);
    return buffer.data();
}

std::string Scalar::shown() const
{
    switch (kind)
    {
    case Kind::Null: return "null";
    case Kind::Bool: return number != 0 ? "true" : "false";
    case Kind::Whole: return is_negative ? std::to_string(static_cast<std::int64_t>(bits)) : std::to_string(bits);
    case Kind::Number: return shortened(text);
    case Kind::Text: return '"' + shortened(text) + '"';
    }
    return {};
}

void ValueReader::read(Reading& reading, const Slot& slot, const Scalar& value) const { reading.fail("is " + value.shown(), remedy(slot)); }

void ValueReader::begin(Reading& reading, const Slot& slot, bool is_list) const
{
    reading.fail(is_list ? "is a list" : "is an object", remedy(slot));
}

// Of types that are neither an object nor a list; begin() has refused both.
Slot ValueReader::field(Reading&, Frame&) const { return {}; }
Slot ValueReader::element(Reading&, Frame&) const { return {}; }
void ValueReader::end(Reading&, Frame&) const {}

void Reading::count(const Total& total)
{
    if (counts_[total.index]++ < static_cast<std::size_t>(total.most)) return;
    fail_at("", "holds more than " + std::to_string(total.most) + " " + total.what, "make the scene smaller");
}

void Reading::fail_inside(const std::string& field, const std::string& problem, const std::string& remedy)
{
    place = frames.back().start;
    std::string at = path(frames.size() - 1);
    if (!field.empty()) at += (at.empty() ? "" : ".") + field;
    fail_at(std::move(at), problem, remedy);
}

std::string Reading::path(std::size_t depth) const
{
    std::string text;
    for (std::size_t i = 0; i < depth; ++i)
    {
        const Frame& frame = frames[i];
        if (frame.is_list)
            text += "[" + std::to_string(frame.count - 1) + "]";
        else
            text += (text.empty() ? "" : ".") + shortened(frame.key);
    }
    return text;
}

void Reading::fail_at(std::string path, const std::string& problem, const std::string& remedy) const
{
    const std::string subject = path.empty() ? "the file " : "";
    throw SceneFileError({.source = name_,
                          .line = place.line,
                          .column = place.column,
                          .field = std::move(path),
                          .message = subject + problem + "; " + remedy});
}

} // namespace carom::scene_file
