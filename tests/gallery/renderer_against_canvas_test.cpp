// The gallery and the command line draw the same pictures: OpenGL's are held against Cairo's, scene by scene.
#include "cli/render.hpp"
#include "gallery/testing.hpp"
#include "scenes/registry.hpp"

#include <cmath>
#include <string>

namespace carom::gallery
{

namespace
{

constexpr scenes::Viewport size{640, 360};

class EveryScene : public OffscreenTest
{
protected:
    void SetUp() override { open(size); }
};

/// Without its captions, whose letters differ.
scenes::DrawList drawn_by(const scenes::Scene& scene)
{
    scenes::DrawList all;
    scene.draw(all);
    scenes::DrawList list;
    list.background = all.background;
    for (int i = 0; i < scenes::layer_count; ++i)
    {
        const auto layer = static_cast<scenes::Layer>(i);
        for (const scenes::DrawnShape& s : all.layer(layer).shapes) list.shape(layer, s.geometry, s.transform, s.paint);
        for (const scenes::DrawnLine& l : all.layer(layer).lines) list.line(layer, l.from, l.to, l.color, l.width);
    }
    return list;
}

struct Comparison
{
    double mean_difference = 0; ///< of a channel, 0 to 255
    double different = 0;       ///< share of the pixels that differ by more than a quarter of the range
    double shown = 0;           ///< share of the pixels that are not the background
};

Comparison compared(const Picture& picture, std::span<const std::byte> canvas)
{
    Comparison result;
    const std::size_t count = picture.rgba.size() / 4;
    for (std::size_t i = 0; i < count; ++i)
    {
        int most = 0;
        for (std::size_t k = 0; k < 3; ++k) // Cairo keeps blue first
        {
            const int difference = std::abs(static_cast<int>(picture.rgba[4 * i + k]) - static_cast<int>(canvas[4 * i + 2 - k]));
            result.mean_difference += difference / (3.0 * static_cast<double>(count));
            most = std::max(most, difference);
        }
        result.different += (most > 64) / static_cast<double>(count);
        result.shown += !std::equal(&picture.rgba[4 * i], &picture.rgba[4 * i + 3], picture.rgba.data()) / static_cast<double>(count);
    }
    return result;
}

} // namespace

TEST_F(EveryScene, looks_as_the_command_line_draws_it)
{
    for (const scenes::SceneInfo& info : scenes::all_scenes())
    {
        const auto scene = scenes::make_scene(info.name);
        for (int i = 0; i < 60; ++i) scene->step();
        const scenes::DrawList list = drawn_by(*scene);
        cli::Canvas canvas(size);
        canvas.draw(list, scene->camera());
        const Comparison c = compared(drawn(list, {scene->camera(), size}), canvas.pixels());
        RecordProperty(info.name, std::to_string(c.mean_difference) + " " + std::to_string(c.different));
        EXPECT_LT(c.mean_difference, 1.0) << info.name;
        EXPECT_LT(c.different, 0.001) << info.name;
        EXPECT_GT(c.shown, 0.003) << info.name << " shows nothing";
    }
}

} // namespace carom::gallery
