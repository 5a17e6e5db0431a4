// Files hold what the picture holds, and come whole or not at all.
#include "gallery/picture.hpp"

#include "files/testing.hpp"
#include "gallery/failure.hpp"

#include <cairo.h>
#include <fstream>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace carom::gallery
{

namespace
{

namespace fs = std::filesystem;

const Picture two_by_three{
    .width = 2, .height = 3, .rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 10, 20, 30, 255, 255, 255, 255, 255, 0, 0, 0, 255}};

class PictureTest : public ::testing::Test
{
protected:
    void SetUp() override
    {
        folder_ = fs::path(::testing::TempDir()) /
                  ("carom_picture_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    int files() const
    {
        int count = 0;
        for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++count;
        return count;
    }

    fs::path folder_;
};

std::string failure_of(const fs::path& path)
{
    try
    {
        write_png(two_by_three, path);
    }
    catch (const Failure& failure)
    {
        return failure.what();
    }
    return "";
}

} // namespace

TEST_F(PictureTest, a_file_holds_every_pixel)
{
    const fs::path path = folder_ / "picture.png";
    write_png(two_by_three, path);
    EXPECT_EQ(files(), 1);
    cairo_surface_t* const surface = cairo_image_surface_create_from_png(path.c_str());
    ASSERT_EQ(cairo_image_surface_get_width(surface), 2);
    ASSERT_EQ(cairo_image_surface_get_height(surface), 3);
    const unsigned char* const rows = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < 3; ++y)
    {
        for (int x = 0; x < 2; ++x)
        {
            for (int k = 0; k < 3; ++k) // Cairo keeps blue first
                EXPECT_EQ(rows[y * stride + 4 * x + 2 - k], two_by_three.rgba[static_cast<std::size_t>(4 * (2 * y + x) + k)]);
        }
    }
    cairo_surface_destroy(surface);
}

TEST_F(PictureTest, a_file_that_was_there_is_replaced)
{
    const fs::path path = folder_ / "picture.png";
    std::ofstream(path) << "old";
    write_png(two_by_three, path);
    EXPECT_EQ(files(), 1);
    EXPECT_GT(fs::file_size(path), 20u);
}

TEST_F(PictureTest, a_full_disk_keeps_the_earlier_picture)
{
    fs::create_directory(folder_ / "disk");
    const files::testing::SmallDisk disk(folder_ / "disk");
    if (!disk.is_mounted()) GTEST_SKIP() << "only root can mount a small disk";
    const fs::path path = folder_ / "disk" / "picture.png";
    std::ofstream(path) << "old";
    Picture noise{.width = 256, .height = 256};
    unsigned state = 1;
    for (int i = 0; i < 4 * 256 * 256; ++i) noise.rgba.push_back(static_cast<std::uint8_t>((state = state * 1664525u + 1013904223u) >> 24));
    EXPECT_THROW(write_png(noise, path), Failure);
    EXPECT_EQ(files::testing::contents(path), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "disk"), {}), 1);
}

TEST_F(PictureTest, a_place_that_can_not_be_written_is_named)
{
    EXPECT_NE(failure_of(folder_ / "nowhere" / "picture.png").find("there is no folder"), std::string::npos);
    EXPECT_NE(failure_of(folder_ / "nowhere" / "picture.png").find("nowhere"), std::string::npos);
    EXPECT_NE(failure_of(folder_).find("it is a folder"), std::string::npos);
    EXPECT_NE(failure_of("").find("give the name of a file"), std::string::npos);
    EXPECT_NE(failure_of("/proc/picture.png").find("/proc/picture.png"), std::string::npos);
    EXPECT_EQ(files(), 0);
}

TEST(Picture, pixels_are_counted_from_the_top_left)
{
    EXPECT_EQ(two_by_three.at(0, 0), scenes::rgb(1, 0, 0));
    EXPECT_EQ(two_by_three.at(1, 0), scenes::rgb(0, 1, 0));
    EXPECT_EQ(two_by_three.at(0, 2), scenes::rgb(1, 1, 1));
    EXPECT_THROW(two_by_three.at(2, 0), std::out_of_range);
    EXPECT_THROW(two_by_three.at(0, -1), std::out_of_range);
}

} // namespace carom::gallery
