// Walks the containers of films, and counts their pictures with ffmpeg.
#include "cli/film_check.hpp"

#include "files/input_file.hpp"
#include "lab/process.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

namespace carom::cli
{

namespace
{

using Offset = std::uint64_t;

/// Big-endian numbers of a file, from anywhere in it.
class Bytes
{
public:
    explicit Bytes(const std::filesystem::path& path) : file_(files::open_input(path)), size_(std::filesystem::file_size(path)) {}

    Offset size() const { return size_; }
    /// @param count of bytes, at most 8
    /// @return empty beyond the end
    std::optional<Offset> number(Offset at, int count)
    {
        file_.clear();
        file_.seekg(static_cast<std::streamoff>(at));
        Offset value = 0;
        for (int i = 0; i < count; ++i) value = value << 8 | static_cast<unsigned char>(file_.get());
        return file_ ? std::optional(value) : std::nullopt;
    }

private:
    std::ifstream file_;
    Offset size_;
};

/// ISO 14496-12: boxes in a row, each with its size in 32 bits or, behind a 1, in 64; among them the index `moov`.
bool is_whole_mp4(Bytes& file)
{
    constexpr Offset index_name = 0x6D6F6F76; // "moov"
    bool has_index = false;
    Offset at = 0;
    while (at < file.size())
    {
        std::optional<Offset> size = file.number(at, 4);
        const std::optional<Offset> name = file.number(at + 4, 4);
        if (size == 1) size = file.number(at + 8, 8);
        if (!size || !name || *size < 8 || *size > file.size() - at) return false;
        has_index = has_index || name == index_name;
        at += *size;
    }
    return has_index;
}

/// A number of EBML (RFC 8794): the zeros before its first one tell how many bytes follow.
struct EbmlNumber
{
    Offset value = 0;
    int bytes = 0; ///< 0 when there is none
    bool is_unknown = false;
};

EbmlNumber ebml_number(Bytes& file, Offset at)
{
    const std::optional<Offset> first = file.number(at, 1);
    if (!first || *first == 0) return {};
    int bytes = 1;
    while ((*first << bytes & 0x100) == 0) ++bytes;
    const std::optional<Offset> whole = file.number(at, bytes);
    if (!whole) return {};
    const Offset mask = (Offset{1} << 7 * bytes) - 1;
    return {.value = *whole & mask, .bytes = bytes, .is_unknown = (*whole & mask) == mask};
}

/// Matroska (RFC 9559): a header, and a segment that holds the rest of the file.
bool is_whole_webm(Bytes& file)
{
    Offset at = 0;
    for (const Offset id : {Offset{0x1A45DFA3}, Offset{0x18538067}})
    {
        if (file.number(at, 4) != id) return false;
        const EbmlNumber size = ebml_number(file, at + 4);
        if (size.bytes == 0 || size.is_unknown) return false; // the size is filled in when all else is written
        at += 4 + static_cast<Offset>(size.bytes) + size.value;
    }
    return at == file.size();
}

/// GIF89a: the last byte is the trailer.
bool is_whole_gif(Bytes& file)
{
    constexpr Offset trailer = 0x3B;
    return file.size() > 0 && file.number(file.size() - 1, 1) == trailer;
}

bool is_whole(const std::filesystem::path& path, AnimationFormat format)
{
    Bytes file(path);
    switch (format)
    {
    case AnimationFormat::Mp4: return is_whole_mp4(file);
    case AnimationFormat::Webm: return is_whole_webm(file);
    case AnimationFormat::Gif: return is_whole_gif(file);
    }
    return false;
}

/// Counts the lines that are no comments.
class LineCounter
{
public:
    void add(std::string_view text)
    {
        for (const char c : text)
        {
            if (is_start_) is_comment_ = c == '#';
            is_start_ = c == '\n';
            if (is_start_ && !is_comment_) ++count_;
        }
    }
    int count() const { return count_; }

private:
    bool is_start_ = true;
    bool is_comment_ = false;
    int count_ = 0;
};

} // namespace

std::string film_problem(const std::filesystem::path& file, AnimationFormat format, int pictures)
{
    if (!is_whole(file, format)) return "the file that it wrote is cut off";
    LineCounter lines;                // `framecrc` writes one for each picture
    constexpr double patience = 3600; // [s]; pictures are found without being decoded
    const lab::ProcessResult read = lab::run_process(
        {"ffmpeg", "-v", "error", "-xerror", "-i", "file:" + file.string(), "-map", "0:v", "-c", "copy", "-f", "framecrc", "-"}, patience,
        {}, [&](std::string_view text) { lines.add(text); });
    if (read.status == 0 && lines.count() == pictures) return {};
    return "of " + std::to_string(pictures) + " pictures that it was given, the file that it wrote holds " + std::to_string(lines.count()) +
           (read.errors.empty() ? "" : ": " + read.errors);
}

} // namespace carom::cli
