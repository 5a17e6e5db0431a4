// What the pointer does: acts in the scene, drags bodies, throws new ones, moves and scales the picture.
#pragma once

#include "gallery/session.hpp"
#include "gallery/view.hpp"
#include "scenes/grabber.hpp"

#include <optional>

namespace carom::gallery
{

enum class Button
{
    Left,
    Middle,
    Right
};

/// Keys that are held while the pointer acts.
struct Modifiers
{
    bool shift = false; ///< left: a new body; wheel: for the scene
    bool ctrl = false;  ///< left: the inspector looks at this body
};

/// What Shift and the left button make.
struct SpawnOptions
{
    enum class Kind
    {
        Circle,
        Box,
        Capsule,
        Polygon
    };
    Kind kind = Kind::Box;
    float size = 1; ///< across [m]
    float density = 1;
    float friction = 0.6f;
    float restitution = 0.2f;
};

/// A click on a body is the scene's, a drag of a body moves it; what is pressed where no dynamic body is, and in scenes that drag bodies
/// themselves, goes to the scene at once. The right button acts in the scene when it is let go where it was pressed, and moves the picture otherwise.
/// In a step that is looked into, the picture is all that moves. Places are in points of the window.
class Hand
{
public:
    Hand(Session& session, View& view) : session_(session), view_(view) {}

    void press(Button button, Vec2 at, Modifiers modifiers);
    void move(Vec2 to);
    void release(Button button, Vec2 at);
    /// @param notches positive away from the person
    void wheel(float notches, Vec2 at, Modifiers modifiers);
    /// Bodies move under a pointer that rests: sees which one is there now. Once a frame, while the pointer is over the scene.
    void look();
    /// Drops what is held, as when the window loses the keyboard: the button may come up where nobody tells.
    void let_go();

    bool is_busy() const { return doing_ != Doing::Nothing; } ///< something is held: the pointer is its until it is let go

    void draw(scenes::DrawList& list) const;

    BodyId hovered() const { return hovered_; }   ///< the body under the pointer; the last one while the pointer is elsewhere
    BodyId selected() const { return selected_; } ///< that was picked to be looked at; null for none
    void select(BodyId body) { selected_ = body; }
    SpawnOptions spawn;

private:
    enum class Doing
    {
        Nothing,
        Scene,   ///< the scene has the button
        Waiting, ///< pressed on a body: a click or a drag?
        Dragging,
        Throwing,
        WaitingRight, ///< a click or a move of the picture?
        Panning
    };

    std::optional<BodyId> body_at(Vec2 at, bool only_dynamic) const;
    void notice_changes(); ///< of the session: another scene, a look inside
    void to_scene(scenes::PointerEvent::Action action, scenes::PointerEvent::Button button, Vec2 at, float wheel = 0);
    void to_grabber(scenes::PointerEvent::Action action, Vec2 place);
    void take_hold();
    void drop();
    void throw_body(Vec2 at);

    Session& session_;
    View& view_;
    scenes::Grabber grabber_;
    Doing doing_ = Doing::Nothing;
    Vec2 pressed_at_; ///< [points]
    Vec2 last_;       ///< [points]
    BodyId held_;     ///< that was pressed on
    Vec2 held_at_;    ///< where, in its frame [m]: it moves on until the press turns out to be a drag
    BodyId hovered_;
    BodyId selected_;
    int generation_ = 0; ///< of the session, to which the ids belong
};

} // namespace carom::gallery
