// Frame by frame: events, steps, the picture, the panels.
#include "gallery/app.hpp"

#include "files/output_file.hpp"
#include "files/text.hpp"
#include "gallery/failure.hpp"
#include "gallery/grid.hpp"
#include "gallery/keys.hpp"
#include "gallery/moment_words.hpp"
#include "gallery/overlay_names.hpp"
#include "gallery/panels.hpp"
#include "gallery/text_painter.hpp"

#include <SDL.h>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <imgui.h>
#include <nlohmann/json.hpp>
#include <ostream>
#include <thread>

namespace carom::gallery
{

namespace
{

constexpr double ms = 1000;                // in a second
constexpr double counted_frame = 1 / 60.0; // what a frame stands for when frames are counted [s]

constexpr std::chrono::milliseconds shortest_frame{4};

/// A panel that has just appeared takes a few frames to find its size.
constexpr int settling_frames = 4;

double ms_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b)
{
    return ms * std::chrono::duration<double>(b - a).count();
}

WindowOptions window_options(const Options& options)
{
    WindowOptions window;
    window.title = "Carom";
    window.width = options.width;
    window.height = options.height;
    window.vsync = options.frames == 0; // who counts frames does not wait for the screen
    return window;
}

Modifiers modifiers()
{
    const SDL_Keymod held = SDL_GetModState();
    return {.shift = (held & KMOD_SHIFT) != 0, .ctrl = (held & KMOD_CTRL) != 0};
}

std::optional<Button> button_of(std::uint8_t button)
{
    switch (button)
    {
    case SDL_BUTTON_LEFT: return Button::Left;
    case SDL_BUTTON_MIDDLE: return Button::Middle;
    case SDL_BUTTON_RIGHT: return Button::Right;
    default: return std::nullopt;
    }
}

Vec2 point_of(int x, int y) { return {static_cast<float>(x), static_cast<float>(y)}; }

nlohmann::json json_of(const FrameTimes& t)
{
    return {{"step", t.step},       {"draw", t.draw},         {"panels", t.panels},
            {"present", t.present}, {"draw_gpu", t.draw_gpu}, {"panels_gpu", t.panels_gpu},
            {"whole", t.whole}};
}

} // namespace

App::App(const Options& options)
    : options_(options),
      window_(window_options(options)),
      gallery_(options.file ? *options.file : find_source(options.scene), options.values, options.seed),
      last_frame_(SteadyClock::now())
{
    gallery_.theme = options.theme;
    gallery_.palette = options.palette;
    gallery_.shows_panels = options.has_panels;
    gallery_.shows_status = options.has_panels;
    gallery_.wanted_tab = options.tab;
    for (const std::string& name : options.shown) gallery_.draw.*find_overlay(name) = true;
    if (!options.widgets.empty()) gallery_.widgets.want(options.widgets);
    theme_ = Theme(gallery_.theme, gallery_.palette);
    apply_to_imgui(gallery_.theme, window_.ui_scale());
}

void App::run()
{
    while (!gallery_.wants_quit && (options_.frames == 0 || frame_ < options_.frames))
    {
        frame();
        ++frame_;
    }
}

double App::elapsed(SteadyClock::time_point now)
{
    const double seconds = std::chrono::duration<double>(now - std::exchange(last_frame_, now)).count();
    return options_.frames > 0 ? counted_frame : seconds;
}

void App::frame()
{
    const SteadyClock::time_point start = SteadyClock::now();
    FrameTimes times;
    times.whole = ms_between(last_frame_, start);
    const double seconds = elapsed(start);
    const bool is_last = options_.frames > 0 && frame_ + 1 == options_.frames;

    handle_events();
    advance(seconds, times);
    show(times);
    if (is_last && !options_.screenshot.empty()) write_png(window_.read_back(), options_.screenshot);
    update_window();
    const SteadyClock::time_point complete = SteadyClock::now();
    window_.present();
    times.present = ms_between(complete, SteadyClock::now());
    if (frame_ > 0) gallery_.frames.add(times); // the first one waits for fonts and shaders
    gallery_.widgets.end_frame();
    // A screen that does not hold the frames back would have the processor draw thousands of them a second.
    if (options_.frames == 0) std::this_thread::sleep_until(start + shortest_frame);
}

void App::advance(double seconds, FrameTimes& times)
{
    if (options_.inside >= 0 && frame_ + 1 == std::max(options_.frames - settling_frames, 1))
    {
        gallery_.session.look_inside();
        gallery_.session.show_moment(static_cast<std::size_t>(options_.inside));
    }
    const SteadyClock::time_point start = SteadyClock::now();
    gallery_.session.advance(seconds);
    times.step = ms * gallery_.session.step_seconds();
    times.draw = ms_between(start, SteadyClock::now()) - times.step; // seeing where motion begins
}

void App::show(FrameTimes& times)
{
    const SteadyClock::time_point stepped = SteadyClock::now();
    window_.begin_frame();
    gallery_.widgets.begin_frame();
    lay_out();
    const SteadyClock::time_point laid_out = SteadyClock::now();
    draw_scene();
    const SteadyClock::time_point drawn = SteadyClock::now();
    panel_timer_.begin();
    window_.end_panels();
    panel_timer_.end();
    const SteadyClock::time_point done = SteadyClock::now();

    times.panels = ms_between(stepped, laid_out) + ms_between(drawn, done);
    times.draw += ms_between(laid_out, drawn);
    times.draw_gpu = draw_timer_.latest_ms().value_or(0);
    times.panels_gpu = panel_timer_.latest_ms().value_or(0);
}

void App::handle_events()
{
    SDL_Event event;
    while (SDL_PollEvent(&event))
    {
        window_.handle(event);
        handle(event);
    }
}

void App::handle(const SDL_Event& event)
{
    Hand& hand = gallery_.hand;
    switch (event.type)
    {
    case SDL_QUIT: gallery_.wants_quit = true; break;
    case SDL_MOUSEBUTTONDOWN:
        if (const auto button = button_of(event.button.button); button && !is_over_panel(point_of(event.button.x, event.button.y)))
            hand.press(*button, point_of(event.button.x, event.button.y), modifiers());
        break;
    case SDL_MOUSEBUTTONUP:
        if (const auto button = button_of(event.button.button)) hand.release(*button, point_of(event.button.x, event.button.y));
        break;
    case SDL_MOUSEMOTION:
        pointer_ = point_of(event.motion.x, event.motion.y);
        if (hand.is_busy() || !is_over_panel(pointer_)) hand.move(pointer_);
        break;
    case SDL_MOUSEWHEEL:
    {
        int x = 0;
        int y = 0;
        SDL_GetMouseState(&x, &y);
        if (!is_over_panel(point_of(x, y))) hand.wheel(event.wheel.preciseY, point_of(x, y), modifiers());
        break;
    }
    case SDL_KEYDOWN:
        // While a person types into a panel, letters are the panel's.
        if (!ImGui::GetIO().WantTextInput)
            press_key(gallery_, event.key.keysym.sym, (event.key.keysym.mod & KMOD_CTRL) != 0, event.key.repeat != 0);
        break;
    case SDL_DROPFILE:
        gallery_.session.open_file(event.drop.file);
        SDL_free(event.drop.file);
        break;
    case SDL_WINDOWEVENT:
        if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) hand.let_go();
        break;
    default: break;
    }
}

/// By places, not by what Dear ImGui found in the frame before: a click that follows a quick motion must not fall through a panel.
bool App::is_over_panel(Vec2 point) const
{
    if (!gallery_.view.free().contains(point)) return true;
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return true;
    const auto holds = [point](const Rect& place) { return place.contains(point); };
    return std::any_of(gallery_.floating.begin(), gallery_.floating.end(), holds);
}

void App::lay_out()
{
    if (!is_over_panel(pointer_)) gallery_.hand.look();
    const Rect free = draw_panels(gallery_, window_.size(), window_.ui_scale());
    gallery_.look(window_.size(), free);
    gallery_.pointer_place = is_over_panel(pointer_) ? std::nullopt : std::optional(gallery_.view.to_world(pointer_));
}

void App::draw_scene()
{
    const Renderer::View view = {gallery_.view.camera(), window_.pixels()};
    const float height = view.camera.height;
    scenes::DrawList& list = gallery_.session.picture(gallery_.draw, height);
    if (gallery_.draw.grid) draw_grid(gallery_.view, list);
    draw_marks(list);
    draw_timer_.begin();
    renderer_.draw(list, view, theme_);
    draw_timer_.end();
    const Rect& free = gallery_.view.free();
    paint_texts(list, view, theme_, window_.pixels_per_point(), {free.min.x, free.min.y}, {free.max.x, free.max.y});
}

void App::draw_marks(scenes::DrawList& list) const
{
    gallery_.hand.draw(list);
    if (gallery_.session.is_inside()) return;
    constexpr scenes::Color picked = scenes::rgb(1, 0.85f, 0.4f);
    draw_outline(gallery_.session.scene().world(), gallery_.hand.selected(), picked, list);
}

void App::update_window()
{
    if (theme_.kind() != gallery_.theme || theme_.palette() != gallery_.palette)
    {
        theme_ = Theme(gallery_.theme, gallery_.palette);
        apply_to_imgui(gallery_.theme, window_.ui_scale());
    }
    if (window_.is_full_screen() != gallery_.wants_full_screen) window_.set_full_screen(gallery_.wants_full_screen);
    if (!gallery_.wants_screenshot.empty())
    {
        const std::string file = std::exchange(gallery_.wants_screenshot, {});
        try
        {
            write_png(window_.read_back(), file);
            gallery_.session.mention("Wrote " + file);
        }
        catch (const Failure& failure)
        {
            gallery_.session.say(failure.what());
        }
    }
    const Session& session = gallery_.session;
    std::string title =
        "Carom - " + session.scene().info().title + " - " + std::to_string(session.scene().world().body_count()) + " bodies";
    if (session.is_inside())
        title += " - inside step " + std::to_string(session.film().step()) + ", " + title_of(session.film().moments()[session.moment()]);
    else if (gallery_.session.clock().is_paused())
        title += " - paused";
    if (title == title_) return;
    title_ = title;
    window_.set_title(title);
}

void App::report(std::ostream& out) const
{
    const FrameTimes t = gallery_.frames.mean();
    const scenes::Scene& scene = gallery_.session.scene();
    if (options_.is_json)
    {
        const nlohmann::json json = {{"scene", gallery_.session.source().info().name},
                                     {"frames", frame_},
                                     {"steps", scene.world().step_count()},
                                     {"bodies", scene.world().body_count()},
                                     {"instances", renderer_.last().instances},
                                     {"draw_calls", renderer_.last().draw_calls},
                                     {"frame_ms", json_of(t)}};
        out << json.dump(2) << "\n";
        return;
    }
    char text[320];
    std::snprintf(text, sizeof text,
                  "%s: %d frames, %llu steps, %d bodies, %d shapes and lines in %d draw calls\n"
                  "mean of a frame: steps %.3f ms, drawing %.3f ms (GPU %.3f ms), panels %.3f ms (GPU %.3f ms), present %.3f ms, frame to "
                  "frame %.3f ms\n",
                  gallery_.session.source().info().name.c_str(), frame_, static_cast<unsigned long long>(scene.world().step_count()),
                  scene.world().body_count(), renderer_.last().instances, renderer_.last().draw_calls, t.step, t.draw, t.draw_gpu, t.panels,
                  t.panels_gpu, t.present, t.whole);
    out << text;
}

int run_gallery(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err)
{
    const auto report = [&err](const std::exception& error, int status)
    {
        err << "carom-gallery: " << files::printable(error.what()) << "\n";
        return status;
    };
    try
    {
        const std::optional<Options> options = read_options(arguments, out);
        if (options)
        {
            App app(*options);
            app.run();
            const bool is_out_taken = files::is_standard_output(options->screenshot) || files::is_standard_output(options->widgets);
            if (options->frames > 0) app.report(is_out_taken ? err : out);
        }
        if (!out.flush()) throw Failure("can't write the output");
        return 0;
    }
    catch (const BadUsage& error)
    {
        return report(error, 2);
    }
    catch (const scenes::SceneError& error)
    {
        return report(error, 2);
    }
    catch (const std::exception& error)
    {
        return report(error, 1);
    }
}

} // namespace carom::gallery
