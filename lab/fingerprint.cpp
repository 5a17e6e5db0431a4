// The FNV-1a hash.
#include "lab/fingerprint.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <span>
#include <vector>

namespace carom::lab
{

namespace
{

constexpr std::uint64_t fnv_start = 0xCBF29CE484222325; // G. Fowler, L. C. Noll, K.-P. Vo; RFC 9923
constexpr std::uint64_t fnv_prime = 0x100000001B3;

std::uint64_t hash_on(std::uint64_t hash, std::span<const char> bytes)
{
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * fnv_prime;
    return hash;
}

std::string text_of(std::uint64_t hash)
{
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

} // namespace

std::string fingerprint_of(std::string_view bytes) { return text_of(hash_on(fnv_start, bytes)); }

std::string fingerprint_of_file(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::uint64_t hash = fnv_start;
    std::vector<char> part(1 << 16);
    bool is_empty = true;
    while (in.read(part.data(), static_cast<std::streamsize>(part.size())), in.gcount() > 0)
    {
        hash = hash_on(hash, std::span(part).first(static_cast<std::size_t>(in.gcount())));
        is_empty = false;
    }
    return is_empty ? std::string() : text_of(hash);
}

} // namespace carom::lab
