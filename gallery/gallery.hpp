// All that the program is about between its frames: panels read and change it.
#pragma once

#include "gallery/file_dialog.hpp"
#include "gallery/frame_meter.hpp"
#include "gallery/hand.hpp"
#include "gallery/panel_layout.hpp"
#include "gallery/session.hpp"
#include "gallery/theme.hpp"
#include "gallery/view.hpp"
#include "gallery/widget_map.hpp"

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace carom::gallery
{

struct Gallery
{
    Gallery(const SceneSource& source, const scenes::ParameterValues& values, std::uint64_t seed)
        : session(source, values, seed),
          hand(session, view)
    {
    }
    Gallery(std::string_view scene, const scenes::ParameterValues& values, std::uint64_t seed) : Gallery(find_source(scene), values, seed)
    {
    }
    Gallery(const Gallery&) = delete;
    Gallery& operator=(const Gallery&) = delete;

    Session session;
    View view;
    Hand hand;
    DrawOptions draw;
    FrameMeter frames;
    WidgetMap widgets;

    ThemeKind theme = ThemeKind::Dark;
    Palette palette = Palette::Scene;
    bool shows_panels = true;
    bool shows_status = true; ///< the line at the bottom: times, counts, the pointer's place
    bool shows_help = false;
    PanelLayout layout;
    Vec2 window_size = {1280, 720}; ///< as it was laid out last [points]
    float ui_scale = 1;             ///< how large letters are, 1 on a common screen
    FileDialog dialog;
    std::vector<Rect> floating;        ///< places of the windows over the scene, as they were laid out last
    std::string wanted_tab;            ///< that is to be opened; empty for none
    std::string search;                ///< in the list of scenes
    std::set<std::string> folded;      ///< groups of the list of scenes whose scenes are hidden
    std::string listed;                ///< the scene to which the list was scrolled last
    std::optional<Vec2> pointer_place; ///< in the world, while the pointer is over the scene [m]
    /// A parameter that is being edited and acts by a restart: it waits until the person lets it go.
    std::optional<std::pair<std::string, scenes::ParameterValue>> edited;
    bool wants_quit = false;
    bool wants_full_screen = false;
    std::string wants_screenshot; ///< the file to which the next frame goes; empty for none

    /// The body that the inspector shows: the picked one, or else the one under the pointer.
    BodyId inspected() const { return hand.selected() ? hand.selected() : hand.hovered(); }
    void toggle_follow();
    /// Turns the view to what is seen now, once a frame. Another scene begins with its own camera; a body that is gone is followed no more.
    /// @param window of the program [points]
    /// @param free   the part that no panel covers
    void look(scenes::Viewport window, const Rect& free);

private:
    std::string scene_;  ///< of the last look()
    int generation_ = 0; ///< of the session, at the last look()
};

} // namespace carom::gallery
