// Which key does what.
#include "gallery/keys.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <ctime>
#include <exception>

namespace carom::gallery
{

namespace
{

Vec2 middle_of(const View& view) { return 0.5f * (view.free().min + view.free().max); }

void toggle_pause(Gallery& g)
{
    if (g.session.is_inside()) g.session.leave_inside();
    g.session.clock().set_paused(!g.session.clock().is_paused());
}

void step_once(Gallery& g)
{
    g.session.leave_inside();
    g.session.clock().request_step();
}

void toggle_inside(Gallery& g)
{
    if (g.session.is_inside())
        g.session.leave_inside();
    else
        g.session.look_inside();
}

void toggle_side(Gallery& g, PanelSide side) { g.layout.toggle(side, g.window_size, g.ui_scale); }

void change_speed(Gallery& g, double factor) { g.session.clock().set_speed(factor * g.session.clock().speed()); }

/// "carom-planets-20260102-030405.png"
std::string screenshot_name(const Gallery& g)
{
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm local{};
    localtime_r(&now, &local);
    char text[32];
    std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &local);
    const SceneSource& source = g.session.source();
    const std::string name = source.file().empty() ? source.info().name : source.file().stem().string();
    return "carom-" + name + "-" + text + ".png";
}

constexpr float zoom_step = 1.25f;

constexpr std::array actions = {
    KeyAction{SDLK_p, false, "P", "pause, and go on", toggle_pause},
    KeyAction{SDLK_o, false, "O", "a single step", step_once},
    KeyAction{SDLK_r, false, "R", "restart the scene", [](Gallery& g) { g.session.restart(); }},
    KeyAction{SDLK_LEFTBRACKET, false, "[", "the scene before", [](Gallery& g) { g.session.open_neighbor(-1); }},
    KeyAction{SDLK_RIGHTBRACKET, false, "]", "the next scene", [](Gallery& g) { g.session.open_neighbor(1); }},
    KeyAction{SDLK_COMMA, false, ",", "slower", [](Gallery& g) { change_speed(g, 0.5); }},
    KeyAction{SDLK_PERIOD, false, ".", "faster", [](Gallery& g) { change_speed(g, 2); }},
    KeyAction{SDLK_i, false, "I", "look inside the next step; again to leave", toggle_inside},
    KeyAction{SDLK_v, false, "V", "follow the body under the pointer, or stop following", [](Gallery& g) { g.toggle_follow(); }},
    KeyAction{SDLK_HOME, false, "Home", "the camera as it was",
              [](Gallery& g)
{
    g.session.watch({});
    g.view.reset();
}},
    KeyAction{SDLK_EQUALS, false, "+", "nearer", [](Gallery& g) { g.view.zoom_at(middle_of(g.view), zoom_step); }},
    KeyAction{SDLK_MINUS, false, "-", "farther", [](Gallery& g) { g.view.zoom_at(middle_of(g.view), 1 / zoom_step); }},
    KeyAction{SDLK_TAB, false, "Tab", "hide or show the panels", [](Gallery& g) { g.shows_panels = !g.shows_panels; }},
    KeyAction{SDLK_F1, false, "F1", "this help", [](Gallery& g) { g.shows_help = !g.shows_help; }},
    KeyAction{SDLK_F2, false, "F2", "fold or open the list of scenes", [](Gallery& g) { toggle_side(g, PanelSide::Left); }},
    KeyAction{SDLK_F3, false, "F3", "fold or open the tabs", [](Gallery& g) { toggle_side(g, PanelSide::Right); }},
    KeyAction{SDLK_F4, false, "F4", "fold or open the bar of time", [](Gallery& g) { g.layout.is_bar_folded = !g.layout.is_bar_folded; }},
    KeyAction{SDLK_F5, false, "F5", "hide or show the status line", [](Gallery& g) { g.shows_status = !g.shows_status; }},
    KeyAction{SDLK_F6, false, "F6", "hide or show the grid", [](Gallery& g) { g.draw.grid = !g.draw.grid; }},
    KeyAction{SDLK_F11, false, "F11", "full screen", [](Gallery& g) { g.wants_full_screen = !g.wants_full_screen; }},
    KeyAction{SDLK_F12, false, "F12", "a picture of the window, into the current folder",
              [](Gallery& g) { g.wants_screenshot = screenshot_name(g); }},
    KeyAction{SDLK_o, true, "Ctrl O", "open a scene file", [](Gallery& g) { g.dialog.open(); }},
    KeyAction{SDLK_q, true, "Ctrl Q", "quit", [](Gallery& g) { g.wants_quit = true; }},
};

constexpr std::array pointer_actions = {
    PointerHelp{"left, on a body", "drag it; a click does what the scene says below"},
    PointerHelp{"left, elsewhere", "what the scene says below: mostly a new body"},
    PointerHelp{"Shift left", "a new body; pull back to throw it"},
    PointerHelp{"Ctrl left", "look at this body in the inspector"},
    PointerHelp{"right or middle, dragged", "move the picture"},
    PointerHelp{"right, clicked", "what the scene says below"},
    PointerHelp{"wheel", "nearer or farther, at the pointer"},
    PointerHelp{"Shift wheel", "what the scene says below: mostly a size"},
};

/// While a step is looked into, arrows walk through it.
bool walk_inside(Session& session, SDL_Keycode key)
{
    if (!session.is_inside()) return false;
    if (key == SDLK_RIGHT)
        session.next_moment();
    else if (key == SDLK_LEFT)
        session.previous_moment();
    else
        return false;
    return true;
}

SDL_Keycode without_keypad(SDL_Keycode key)
{
    if (key == SDLK_KP_PLUS || key == SDLK_PLUS) return SDLK_EQUALS;
    return key == SDLK_KP_MINUS ? SDLK_MINUS : key;
}

} // namespace

std::span<const KeyAction> key_actions() { return actions; }

std::span<const PointerHelp> pointer_help() { return pointer_actions; }

std::string scene_key(SDL_Keycode key)
{
    switch (key)
    {
    case SDLK_UP: return "up";
    case SDLK_DOWN: return "down";
    case SDLK_LEFT: return "left";
    case SDLK_RIGHT: return "right";
    case SDLK_SPACE: return "space";
    default: break;
    }
    const bool is_plain = key > 0 && key < 128 && std::isalnum(static_cast<int>(key));
    return is_plain ? std::string(1, static_cast<char>(key)) : std::string();
}

void press_key(Gallery& gallery, SDL_Keycode key, bool has_ctrl, bool is_repeat)
{
    if (walk_inside(gallery.session, key)) return;
    const SDL_Keycode plain = without_keypad(key);
    if (plain == SDLK_ESCAPE)
    {
        gallery.shows_help = false;
        gallery.dialog.close();
        gallery.hand.select({});
        return gallery.session.leave_inside();
    }
    for (const KeyAction& action : actions)
    {
        if (action.key != plain || action.needs_ctrl != has_ctrl) continue;
        // Stepping, speed and zoom go on while the key is held; what switches does not.
        const bool repeats = (plain == SDLK_o && !has_ctrl) || plain == SDLK_EQUALS || plain == SDLK_MINUS;
        if (!is_repeat || repeats) action.act(gallery);
        return;
    }
    const std::string name = scene_key(key);
    if (name.empty() || has_ctrl || is_repeat || gallery.session.is_inside()) return;
    try
    {
        gallery.session.scene().key(name);
    }
    catch (const std::exception& error)
    {
        gallery.session.say(error.what());
    }
}

} // namespace carom::gallery
