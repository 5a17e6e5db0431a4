// A window opens without a display, draws panels in the right place, and says what is missing when it can't.
#include "gallery/gpu_timer.hpp"
#include "gallery/testing.hpp"
#include "gallery/theme.hpp"

#include <SDL.h>
#include <imgui.h>
#include <optional>
#include <string>

namespace carom::gallery
{

using WindowTest = OffscreenTest;

TEST_F(WindowTest, has_the_size_that_was_asked_for)
{
    EXPECT_EQ(window_->size().width, 320);
    EXPECT_EQ(window_->size().height, 200);
    EXPECT_EQ(window_->pixels().width, 320);
    EXPECT_EQ(window_->pixels_per_point(), 1);
    EXPECT_EQ(window_->ui_scale(), 1);
    EXPECT_FALSE(window_->is_full_screen());
}

TEST_F(WindowTest, panels_cover_the_picture_where_they_are_and_leave_the_rest)
{
    apply_to_imgui(ThemeKind::Light, window_->ui_scale());
    scenes::DrawList list = black_list();
    list.disc(scenes::Layer::Bodies, {-100, 0}, 40, {.fill = red, .line = {}});
    Picture picture;
    for (int i = 0; i < 2; ++i) // Dear ImGui shows a new window from its second frame on
    {
        window_->begin_frame();
        renderer_->draw(list, view(), Theme());
        ImGui::SetNextWindowPos({200, 50});
        ImGui::SetNextWindowSize({100, 100});
        ImGui::SetNextWindowBgAlpha(1);
        ImGui::Begin("panel");
        ImGui::End();
        window_->end_panels();
        picture = window_->read_back();
        window_->present();
    }
    EXPECT_GT(picture.at(250, 120).g, 0.8f);
    EXPECT_EQ(picture.at(60, 100), red);
    EXPECT_EQ(picture.at(310, 100), black);
    EXPECT_EQ(picture.at(250, 160), black);

    // The panels changed the state of OpenGL; the picture after them is as before.
    EXPECT_EQ(drawn(list).at(60, 100), red);
    EXPECT_EQ(drawn(list).at(250, 120), black);
}

TEST_F(WindowTest, events_reach_the_panels)
{
    SDL_Event event{};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.y = 1;
    window_->handle(event);
    EXPECT_EQ(ImGui::GetIO().MouseWheel, 1);
}

TEST_F(WindowTest, letters_are_there_in_two_sizes_and_no_file_is_left_behind)
{
    window_->begin_frame();
    EXPECT_GT(window_->title_font()->FontSize, ImGui::GetFont()->FontSize);
    EXPECT_EQ(ImGui::GetFontSize(), 15);
    EXPECT_EQ(nearest_font(15), ImGui::GetFont());
    EXPECT_EQ(nearest_font(1000)->FontSize, 35);
    EXPECT_EQ(ImGui::GetIO().IniFilename, nullptr);
    window_->end_panels();
}

TEST_F(WindowTest, the_card_says_how_long_it_worked)
{
    GpuTimer timer;
    EXPECT_FALSE(timer.latest_ms());
    timer.end(); // nothing was begun
    scenes::DrawList list = black_list();
    for (int i = 0; i < 20; ++i) list.disc(scenes::Layer::Bodies, {}, 90, {.fill = with_alpha(red, 0.1f), .line = {}});
    for (int i = 0; i < 8; ++i)
    {
        timer.begin();
        renderer_->draw(list, view(), Theme());
        timer.end();
        window_->read_back(); // waits for the card
    }
    ASSERT_TRUE(timer.latest_ms());
    EXPECT_GT(*timer.latest_ms(), 0);
    EXPECT_LT(*timer.latest_ms(), 10000);
}

namespace
{

/// Sets a variable of the environment for as long as this lives; null takes it away.
class Variable
{
public:
    Variable(const char* name, const char* value) : name_(name)
    {
        if (const char* const before = std::getenv(name)) before_ = before;
        set(value);
    }
    ~Variable() { set(before_ ? before_->c_str() : nullptr); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    void set(const char* value) const
    {
        if (value)
            ::setenv(name_, value, 1);
        else
            ::unsetenv(name_);
    }

    const char* name_;
    std::optional<std::string> before_;
};

std::string failure_without_display(const char* driver)
{
    const Variable sdl("SDL_VIDEODRIVER", driver);
    const Variable x11("DISPLAY", nullptr);
    const Variable wayland("WAYLAND_DISPLAY", nullptr);
    const Variable sockets("XDG_RUNTIME_DIR", nullptr);
    try
    {
        const Window window({});
    }
    catch (const Failure& failure)
    {
        return failure.what();
    }
    return "";
}

} // namespace

TEST(Window, without_a_display_says_what_helps)
{
    for (const char* driver : {static_cast<const char*>(nullptr), "x11", "nonsense"})
    {
        const std::string words = failure_without_display(driver);
        for (const char* part : {"no display: ", "DISPLAY", "SDL_VIDEODRIVER=offscreen"})
            EXPECT_NE(words.find(part), std::string::npos) << (driver ? driver : "no driver asked for") << ": " << words;
    }
}

} // namespace carom::gallery
