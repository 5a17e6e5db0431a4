// Where the panels lie: which are folded, how wide they are, and what is left for the scene.
#pragma once

#include "gallery/view.hpp"

#include <array>

namespace carom::gallery
{

enum class PanelSide
{
    Left, ///< scenes and parameters
    Right ///< the tabs
};

/// Two panels beside the scene, and below all of them the bar of time and the status line. A person folds the panels and drags their edges. As long as
/// nobody has dragged one, the scene keeps half of the window's width: panels get narrower, and then the one that was opened
/// first folds by itself.
class PanelLayout
{
public:
    struct Places
    {
        std::array<Rect, 2> sides; ///< by PanelSide; a folded one is a strip with a button
        Rect bar;
        Rect status;
        Rect scene;
    };
    /// What lies below the panels [points]; 0 for what is hidden.
    struct Heights
    {
        float bar = 0;
        float status = 0;
    };

    /// @param window its size [points]
    /// @param scale  how large letters are, 1 on a common screen
    Places places(Vec2 window, float scale, const Heights& below) const;

    bool is_folded(PanelSide side, Vec2 window, float scale) const;
    /// Folds the panel, or opens it; where both do not fit, the other one folds.
    void toggle(PanelSide side, Vec2 window, float scale);
    /// A person drags the panel's edge.
    /// @param width [points], kept within what the panel and the scene need
    void drag(PanelSide side, float width, Vec2 window, float scale);

    bool is_bar_folded = false;
    float bar_height = 0; ///< that the bar of time needs at the window's width; 0 before it was laid out [points]

private:
    struct Panel
    {
        float width = 0; ///< at a scale of 1 [points]
        float least = 0; ///< at a scale of 1 [points]
        bool is_folded = false;
    };
    Panel& panel(PanelSide side) { return panels_[static_cast<std::size_t>(side)]; }
    const Panel& panel(PanelSide side) const { return panels_[static_cast<std::size_t>(side)]; }
    float scene_share() const { return was_dragged_ ? 0.3f : 0.5f; }
    std::array<float, 2> widths(Vec2 window, float scale) const;
    bool has_room_for_both(Vec2 window, float scale) const;

    std::array<Panel, 2> panels_ = {Panel{260, 180}, Panel{400, 320}};
    PanelSide last_opened_ = PanelSide::Left;
    bool was_dragged_ = false;
};

} // namespace carom::gallery
