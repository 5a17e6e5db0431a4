// A slider's number must be readable whatever its value.
#include "gallery/testing.hpp"
#include "gallery/widgets.hpp"

#include <array>

namespace carom::gallery
{

namespace
{

/// What of a picture has the colour of the accent: blue far above red.
bool is_accent(scenes::Color c) { return c.b > 0.5f && c.b - c.r > 0.25f; }

class Sliders : public OffscreenTest
{
protected:
    /// A window that holds a slider of this value from 0 to 1, 200 points wide, at (20, 20).
    Picture drawn_slider(float value)
    {
        apply_to_imgui(ThemeKind::Dark, 1);
        window_->begin_frame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({300, 120});
        ImGui::Begin("slider", nullptr, ImGuiWindowFlags_NoDecoration);
        ImGui::SetCursorPos({20, 20});
        ImGui::PushItemWidth(200);
        slider("##value", value, 0, 1, "%.2f");
        ImGui::PopItemWidth();
        height_ = ImGui::GetFrameHeight();
        ImGui::End();
        drawn(black_list()); // the ground
        window_->end_panels();
        return window_->read_back();
    }

    int accents(const Picture& picture, float from, float to) const
    {
        int count = 0;
        for (int y = static_cast<int>(20 + from * height_); y < static_cast<int>(20 + to * height_); ++y)
            for (int x = 20; x < 220; ++x) count += is_accent(picture.at(x, y));
        return count;
    }

    float height_ = 0; ///< of the slider [points]
};

} // namespace

TEST_F(Sliders, mark_their_value_below_the_number)
{
    for (const float value : {0.0f, 0.3f, 0.5f, 0.55f, 1.0f})
    {
        const Picture picture = drawn_slider(value);
        EXPECT_EQ(accents(picture, 0.15f, 0.7f), 0) << "nothing may lie where the number is, at " << value;
        EXPECT_GT(accents(picture, 0.7f, 1.05f), 20) << "the value must be marked, at " << value;
    }
    EXPECT_GT(accents(drawn_slider(0.9f), 0.7f, 1.05f), 2 * accents(drawn_slider(0.2f), 0.7f, 1.05f));
}

} // namespace carom::gallery
