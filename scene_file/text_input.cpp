// Follows strings, numbers and lines as the characters pass.
#include "scene_file/text_input.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <istream>
#include <memory>
#include <utility>

namespace carom::scene_file
{

namespace
{

constexpr std::size_t most_string_bytes = 6 * most_text_bytes; // as it stands in the file, where \u0001 is one character
constexpr std::size_t most_word_bytes = 1024;                  // of a number; a float needs 9 digits, and its longest exact decimal has 150

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_punctuation(char c) { return c == '{' || c == '}' || c == '[' || c == ']' || c == ',' || c == ':'; }

[[noreturn]] void fail_to_read(const std::string& name, int error)
{
    const std::string reason = error == EISDIR ? "it is a folder; give a file" : std::strerror(error);
    throw SceneFileError({.source = name, .message = "can't be read: " + reason});
}

/// The encoding that the first bytes of a text show, when it is another than UTF-8; else null. A scene begins with '{', so without a mark
/// the zero bytes beside it tell.
/// @source RFC 4627, section 3
const char* other_encoding(std::string_view start)
{
    using namespace std::string_view_literals;
    if (start.starts_with("\xff\xfe\0\0"sv) || start.starts_with("\0\0\xfe\xff"sv)) return "UTF-32";
    if (start.starts_with("\xff\xfe"sv) || start.starts_with("\xfe\xff"sv)) return "UTF-16";
    if (start.size() < 4) return nullptr;
    const auto is_zero = [&](std::size_t i) { return start[i] == '\0'; };
    if (is_zero(0) != is_zero(3) && is_zero(1) && is_zero(2)) return "UTF-32";
    if (is_zero(0) != is_zero(1) && is_zero(0) == is_zero(2) && is_zero(1) == is_zero(3)) return "UTF-16";
    return nullptr;
}

} // namespace

BlockSource file_source(const std::filesystem::path& path)
{
    errno = 0;
    const std::shared_ptr<std::FILE> file(std::fopen(path.c_str(), "rb"), [](std::FILE* f) { f ? std::fclose(f) : 0; });
    if (!file) fail_to_read(path.string(), errno);
    return [file, name = path.string()](std::span<char> block)
    {
        errno = 0;
        const std::size_t count = std::fread(block.data(), 1, block.size(), file.get());
        if (count == 0 && std::ferror(file.get())) fail_to_read(name, errno);
        return count;
    };
}

BlockSource stream_source(std::istream& stream, const std::string& name)
{
    return [&stream, name](std::span<char> block) -> std::size_t
    {
        if (stream.eof()) return 0;
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        if (stream.bad() || (stream.fail() && !stream.eof()))
            throw SceneFileError({.source = name, .message = "can't be read: the stream has failed"});
        return static_cast<std::size_t>(stream.gcount());
    };
}

BlockSource text_source(std::string_view text)
{
    return [text](std::span<char> block) mutable
    {
        const std::size_t count = text.copy(block.data(), block.size());
        text.remove_prefix(count);
        return count;
    };
}

TextInput::TextInput(BlockSource source, std::string name) : source_(std::move(source)), name_(std::move(name))
{
    while (filled_ < 4 && refill()) // a pipe may give its first bytes one by one
    {
    }
    require_utf8();
    if (is_at_end()) fail({}, "the file is empty; write {\"carom_scene\": 1, ...}");
}

void TextInput::require_utf8()
{
    const std::string_view start(block_.data(), filled_);
    if (const char* encoding = other_encoding(start)) fail({1, 1}, std::string("the file is ") + encoding + "; save it as UTF-8");
    if (start.starts_with("\xef\xbb\xbf")) next_ = 3;
}

/// Adds the next bytes of the source to the block, or starts it anew when all of it was read.
bool TextInput::refill()
{
    if (next_ == filled_) next_ = filled_ = 0;
    const std::size_t count = source_(std::span(block_).subspan(filled_));
    bytes_ += count;
    filled_ += count;
    if (bytes_ > most_file_bytes)
        fail(here_, "the file is longer than " + std::to_string(most_file_bytes >> 20) + " MiB; make the scene smaller");
    return count > 0;
}

/// Passes over spaces that follow another one.
/// @return whether there is a character after them
bool TextInput::skipped_spaces()
{
    while (has_next())
    {
        if (!was_space_ || !is_space(block_[next_])) return true;
        follow(block_[next_++]);
    }
    return false;
}

void TextInput::advance()
{
    const char c = block_[next_++];
    if (c == '\0') fail(here_, "syntax error: a NUL byte; a scene file is text");
    last_ = here_;
    if (!is_in_string_)
        follow_outside(c);
    else if (is_escaped_)
        is_escaped_ = false;
    else if (c == '\\')
        is_escaped_ = true;
    else if (c == '"')
        is_in_string_ = false;
    if (is_in_string_ || is_in_word_) count_token_byte();
    was_space_ = !is_in_string_ && is_space(c);
    follow(c);
}

/// Keeps line and column. A column is a character, however many bytes it has.
void TextInput::follow(char c)
{
    if (c == '\n')
        here_ = {here_.line + 1, 1};
    else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80)
        ++here_.column;
}

void TextInput::follow_outside(char c)
{
    const bool was_in_word = std::exchange(is_in_word_, !is_space(c) && !is_punctuation(c) && c != '"');
    is_in_string_ = c == '"';
    if (!is_in_string_ && (!is_in_word_ || was_in_word)) return;
    value_start_ = here_;
    token_bytes_ = 0;
}

void TextInput::count_token_byte()
{
    const std::size_t most = is_in_string_ ? most_string_bytes : most_word_bytes;
    if (++token_bytes_ <= most + 1) return; // one for the quote
    if (is_in_string_) fail(value_start_, "a text is longer than " + std::to_string(most_text_bytes >> 10) + " KiB; make it shorter");
    fail(value_start_, "a number or word is longer than " + std::to_string(most) + " characters; make it shorter");
}

void TextInput::fail(const Place& place, std::string message) const
{
    throw SceneFileError({.source = name_, .line = place.line, .column = place.column, .message = std::move(message)});
}

} // namespace carom::scene_file
