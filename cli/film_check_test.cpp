// A film from which even one byte is missing is no film.
#include "cli/film_check.hpp"

#include "cli/encoder.hpp"
#include "files/testing.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace carom::cli
{

namespace
{

constexpr scenes::Viewport film_size{64, 48};
constexpr int pictures = 5;

/// Noise, so that every picture takes bytes.
void make_film(const std::filesystem::path& file, AnimationFormat format)
{
    Encoder encoder(file, format, film_size, 30);
    std::vector<std::byte> pixels(std::size_t{4} * film_size.width * film_size.height);
    unsigned noise = 1;
    for (int i = 0; i < pictures; ++i)
    {
        for (std::byte& byte : pixels) byte = static_cast<std::byte>((noise = noise * 1664525u + 1013904223u) >> 24);
        encoder.add_frame(pixels);
    }
    encoder.finish();
}

} // namespace

TEST(FilmCheck, a_film_is_whole_or_it_is_told)
{
    if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
    const files::testing::TemporaryFolder folder("film_check_test");
    for (const AnimationFormat format : {AnimationFormat::Mp4, AnimationFormat::Webm, AnimationFormat::Gif})
    {
        const std::filesystem::path file = folder / "film";
        make_film(file, format);
        EXPECT_EQ(film_problem(file, format, pictures), "");
        EXPECT_EQ(film_problem(file, format, pictures + 1), "of 6 pictures that it was given, the file that it wrote holds 5");
        for (const auto cut : {1, 2, 10, 300, 1000})
        {
            std::filesystem::resize_file(file, std::filesystem::file_size(file) - static_cast<std::uintmax_t>(cut));
            EXPECT_NE(film_problem(file, format, pictures), "") << static_cast<int>(format) << " without " << cut;
        }
        std::ofstream(file, std::ios::trunc).flush();
        EXPECT_NE(film_problem(file, format, pictures), "") << "an empty file";
    }
}

} // namespace carom::cli
