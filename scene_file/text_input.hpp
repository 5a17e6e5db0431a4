// The text of a scene file, a block at a time, with the place of each character. Refuses what no scene file holds before it is stored: another
// encoding, a NUL byte, a text or a number without end, too many bytes.
#pragma once

#include "scene_file/model.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

namespace carom::scene_file
{

/// Fills a part of the block and returns how many bytes it wrote; 0 at the end.
/// @throws SceneFileError when the source fails
using BlockSource = std::function<std::size_t(std::span<char>)>;

/// @throws SceneFileError with the reason when the file can't be opened
BlockSource file_source(const std::filesystem::path& path);
/// The stream must outlive the source.
BlockSource stream_source(std::istream& stream, const std::string& name);
/// The text must outlive the source.
BlockSource text_source(std::string_view text);

/// A stream of characters for a JSON parser that reads one character after the other. Runs of spaces outside of strings are one space.
class TextInput
{
public:
    /// @param name of the source, for messages
    /// @throws SceneFileError when the text is empty or in another encoding than UTF-8
    TextInput(BlockSource source, std::string name);
    TextInput(const TextInput&) = delete;
    TextInput& operator=(const TextInput&) = delete;

    bool is_at_end() { return has_ended_ = !skipped_spaces(); }
    bool has_ended() const { return has_ended_; } ///< whether the parser has come to the end
    char peek() { return skipped_spaces() ? block_[next_] : '\0'; }
    void advance();

    Place last() const { return last_; }               ///< of the character that was read last
    Place next_place() const { return here_; }         ///< of the character that comes next
    Place value_start() const { return value_start_; } ///< of the text, number or word that was read last
    std::size_t bytes() const { return bytes_; }       ///< read so far
    const std::string& name() const { return name_; }

private:
    bool has_next() { return next_ < filled_ || refill(); }
    bool refill();
    bool skipped_spaces();
    void require_utf8();
    void follow(char c);
    void follow_outside(char c);
    void count_token_byte();
    [[noreturn]] void fail(const Place& place, std::string message) const;

    BlockSource source_;
    std::string name_;
    std::array<char, 1 << 16> block_;
    std::size_t next_ = 0;
    std::size_t filled_ = 0;
    std::size_t bytes_ = 0;
    Place here_ = {1, 1};
    Place last_ = {1, 1};
    Place value_start_ = {1, 1};
    std::size_t token_bytes_ = 0;
    bool is_in_string_ = false;
    bool is_in_word_ = false; ///< a number, true, false or null
    bool has_ended_ = false;
    bool is_escaped_ = false; ///< a backslash came right before
    bool was_space_ = true;   ///< so that spaces at the start are passed over
};

/// Walks a TextInput, as the parser's interface asks for.
class TextIterator
{
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;

    TextIterator() = default; ///< the end
    explicit TextIterator(TextInput& input) : input_(&input) {}

    char operator*() const { return input_->peek(); }
    TextIterator& operator++()
    {
        input_->advance();
        return *this;
    }
    void operator++(int) { input_->advance(); }
    friend bool operator==(const TextIterator& a, const TextIterator& b) { return a.is_at_end() == b.is_at_end(); }

private:
    bool is_at_end() const { return !input_ || input_->is_at_end(); }

    TextInput* input_ = nullptr;
};

} // namespace carom::scene_file
