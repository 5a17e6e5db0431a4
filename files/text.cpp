// Decodes UTF-8 and escapes what should not reach a terminal.
#include "files/text.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace carom::files
{

namespace
{

constexpr std::string_view digits = "0123456789abcdef";

/// One code point at the start of a text.
struct CodePoint
{
    std::uint32_t value = 0;
    std::size_t bytes = 0; ///< 0 when the text does not begin with valid UTF-8
};

/// Refuses overlong forms, surrogates and what lies beyond U+10FFFF, as the Unicode standard asks (table 3-7).
CodePoint decode(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    const std::uint32_t first = byte(0);
    if (first < 0x80) return {first, 1};
    const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return {};
    std::uint32_t value = first & (0xFFu >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i)
    {
        if ((byte(i) & 0xC0) != 0x80) return {};
        value = value << 6 | (byte(i) & 0x3F);
    }
    constexpr std::array<std::uint32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = value >= 0xD800 && value <= 0xDFFF;
    if (value < least[bytes] || value > 0x10FFFF || is_surrogate) return {};
    return {value, bytes};
}

/// Whether a terminal would act on the character, or show the rest of the line in another order.
bool is_obeyed(std::uint32_t c)
{
    const bool is_control = c < 0x20 || (c >= 0x7F && c <= 0x9F);
    const bool reorders = (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0x200E || c == 0x200F || c == 0x061C;
    const bool ends_line = c == 0x2028 || c == 0x2029;
    return is_control || reorders || ends_line;
}

void append_escape(std::string& out, std::uint32_t value, bool is_byte)
{
    out += is_byte ? "\\x" : "\\u";
    for (int shift = is_byte ? 4 : 12; shift >= 0; shift -= 4) out += digits[value >> shift & 15];
}

/// @param is_kept says which of the obeyed characters stay as they are
template <class IsKept>
std::string escaped(std::string_view text, const IsKept& is_kept)
{
    std::string out;
    out.reserve(text.size());
    while (!text.empty())
    {
        const CodePoint c = decode(text);
        const std::size_t bytes = c.bytes == 0 ? 1 : c.bytes;
        if (c.bytes == 0)
            append_escape(out, static_cast<unsigned char>(text[0]), true);
        else if (is_obeyed(c.value) && !is_kept(c.value))
            append_escape(out, c.value, c.value < 0x80);
        else
            out += text.substr(0, bytes);
        text.remove_prefix(bytes);
    }
    return out;
}

} // namespace

std::string printable(std::string_view text)
{
    return escaped(text, [](std::uint32_t c) { return c == '\n' || c == '\t'; });
}

std::string printable_line(std::string_view text)
{
    std::string marked;
    for (const char c : text)
    {
        if (c == '\n')
            marked += "\\n";
        else if (c == '\t')
            marked += "\\t";
        else
            marked += c;
    }
    return escaped(marked, [](std::uint32_t) { return false; });
}

std::string quoted(const std::filesystem::path& name)
{
    std::string marked;
    for (const char c : name.native())
    {
        if (c == '"' || c == '\\') marked += '\\';
        marked += c;
    }
    return '"' + printable_line(marked) + '"';
}

} // namespace carom::files
