// Tells clicks from drags, and gives each to whom it is for.
#include "gallery/hand.hpp"

#include "scenes/helpers.hpp"

#include <array>
#include <cmath>
#include <exception>
#include <utility>

namespace carom::gallery
{

namespace
{

using scenes::PointerEvent;

constexpr float click_distance = 4; // farther than this a press becomes a drag [points]

PointerEvent::Button button_of(Button button)
{
    switch (button)
    {
    case Button::Left: return PointerEvent::Button::Left;
    case Button::Middle: return PointerEvent::Button::Middle;
    case Button::Right: return PointerEvent::Button::Right;
    }
    return PointerEvent::Button::None;
}

Geometry geometry_of(const SpawnOptions& options)
{
    const float size = options.size;
    switch (options.kind)
    {
    case SpawnOptions::Kind::Circle: return circle(0.5f * size);
    case SpawnOptions::Kind::Box: return box(size, size);
    case SpawnOptions::Kind::Capsule: return capsule({-0.25f * size, 0}, {0.25f * size, 0}, 0.25f * size);
    case SpawnOptions::Kind::Polygon: break;
    }
    std::array<Vec2, 5> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const SinCos v = sin_cos(2 * pi * static_cast<float>(i) / static_cast<float>(corners.size()) + 0.5f * pi);
        corners[i] = {0.5f * size * v.cos, 0.5f * size * v.sin};
    }
    return convex_hull(corners);
}

/// Farther out nothing is done; false also for what is not finite.
bool is_near(Vec2 place) { return std::abs(place.x) <= scenes::farthest_pointer && std::abs(place.y) <= scenes::farthest_pointer; }

/// How fast a body is thrown by a drag: a metre of it is so many metres a second.
constexpr float throw_rate = 4; // [1/s]

} // namespace

std::optional<BodyId> Hand::body_at(Vec2 at, bool only_dynamic) const
{
    const World& world = session_.scene().world();
    const Vec2 point = view_.to_world(at);
    if (!is_near(point)) return std::nullopt;
    std::optional<BodyId> found;
    bool is_found_dynamic = false;
    const auto visit = [&](ShapeId shape)
    {
        const BodyId body = world.shape(shape).body();
        const bool is_dynamic = world.body(body).type() == BodyType::Dynamic;
        if (is_found_dynamic || (only_dynamic && !is_dynamic)) return;
        found = body;
        is_found_dynamic = is_dynamic;
    };
    try
    {
        world.visit_shapes_at(point, visit);
    }
    catch (const UsageError&)
    {
        return std::nullopt; // an error stopped the world in the middle of a step, and the session has said so
    }
    return found;
}

void Hand::notice_changes()
{
    if (generation_ != session_.generation())
    {
        generation_ = session_.generation();
        grabber_ = {};
        held_ = hovered_ = selected_ = {};
        doing_ = Doing::Nothing;
    }
    const bool moves_picture = doing_ == Doing::WaitingRight || doing_ == Doing::Panning;
    if (session_.is_inside() && !moves_picture) drop(); // what is looked into stands still
}

void Hand::to_scene(PointerEvent::Action action, PointerEvent::Button button, Vec2 at, float wheel)
{
    try
    {
        session_.scene().pointer({action, button, view_.to_world(at), wheel});
    }
    catch (const std::exception& error)
    {
        session_.say(error.what());
    }
}

void Hand::to_grabber(PointerEvent::Action action, Vec2 place)
{
    if (action != PointerEvent::Action::Up && !is_near(place)) return;
    try
    {
        grabber_.on_pointer(session_.scene().world(), {action, PointerEvent::Button::Left, place, 0});
    }
    catch (const std::exception& error)
    {
        session_.say(error.what());
    }
}

void Hand::take_hold()
{
    doing_ = Doing::Dragging;
    const std::optional<BodyView> body = std::as_const(session_).scene().world().find_body(held_);
    if (body) to_grabber(PointerEvent::Action::Down, body->transform() * held_at_);
}

void Hand::press(Button button, Vec2 at, Modifiers modifiers)
{
    notice_changes();
    if (doing_ != Doing::Nothing) return; // one thing at a time
    pressed_at_ = last_ = at;
    if (button == Button::Middle)
        doing_ = Doing::Panning;
    else if (button == Button::Right)
        doing_ = Doing::WaitingRight;
    else if (session_.is_inside())
        return;
    else if (modifiers.ctrl)
        selected_ = body_at(at, false).value_or(BodyId{});
    else if (modifiers.shift)
        doing_ = Doing::Throwing;
    else if (const auto body = session_.scene().info().drags_bodies ? std::nullopt : body_at(at, true))
    {
        doing_ = Doing::Waiting;
        held_ = *body;
        held_at_ = inverse_transform(session_.scene().world().body(held_).transform(), view_.to_world(at));
    }
    else
    {
        doing_ = Doing::Scene;
        to_scene(PointerEvent::Action::Down, button_of(button), at);
    }
}

void Hand::move(Vec2 to)
{
    notice_changes();
    const bool is_drag = distance(to, pressed_at_) > click_distance;
    if (doing_ == Doing::Waiting && is_drag) take_hold();
    if (doing_ == Doing::WaitingRight && is_drag) doing_ = Doing::Panning;
    if (doing_ == Doing::Dragging) to_grabber(PointerEvent::Action::Move, view_.to_world(to));
    if (doing_ == Doing::Panning) view_.pan(to - last_);
    if (doing_ == Doing::Nothing || doing_ == Doing::Scene)
    {
        if (!session_.is_inside()) to_scene(PointerEvent::Action::Move, PointerEvent::Button::None, to);
    }
    last_ = to;
    look();
}

void Hand::look()
{
    notice_changes();
    if (doing_ != Doing::Nothing && doing_ != Doing::Scene) return;
    if (const auto body = body_at(last_, false)) hovered_ = *body;
}

void Hand::release(Button button, Vec2 at)
{
    notice_changes();
    const bool is_mine = button == Button::Left
                             ? doing_ == Doing::Waiting || doing_ == Doing::Dragging || doing_ == Doing::Throwing || doing_ == Doing::Scene
                         : button == Button::Right ? doing_ == Doing::WaitingRight || doing_ == Doing::Panning
                                                   : doing_ == Doing::Panning;
    if (!is_mine) return;
    const Doing done = std::exchange(doing_, Doing::Nothing);
    switch (done)
    {
    case Doing::Waiting:
    case Doing::WaitingRight:
        if (session_.is_inside()) return;
        to_scene(PointerEvent::Action::Down, button_of(button), at);
        return to_scene(PointerEvent::Action::Up, button_of(button), at);
    case Doing::Scene: return to_scene(PointerEvent::Action::Up, button_of(button), at);
    case Doing::Dragging: return to_grabber(PointerEvent::Action::Up, view_.to_world(at));
    case Doing::Throwing: return throw_body(at);
    case Doing::Panning:
    case Doing::Nothing: return;
    }
}

void Hand::wheel(float notches, Vec2 at, Modifiers modifiers)
{
    notice_changes();
    if (modifiers.shift) return to_scene(PointerEvent::Action::Wheel, PointerEvent::Button::None, at, notches);
    constexpr float factor = 1.15f; // of a notch
    view_.zoom_at(at, std::pow(factor, notches));
}

void Hand::let_go()
{
    notice_changes();
    drop();
}

void Hand::drop()
{
    if (doing_ == Doing::Dragging) to_grabber(PointerEvent::Action::Up, view_.to_world(last_));
    if (doing_ == Doing::Scene) to_scene(PointerEvent::Action::Up, PointerEvent::Button::Left, last_);
    doing_ = Doing::Nothing;
}

void Hand::throw_body(Vec2 at)
{
    const Vec2 place = view_.to_world(pressed_at_);
    const Vec2 velocity = distance(at, pressed_at_) > click_distance ? throw_rate * (place - view_.to_world(at)) : Vec2{};
    const ShapeDef shape{.density = spawn.density, .material = {.friction = spawn.friction, .restitution = spawn.restitution}};
    try
    {
        session_.scene().add_guest({.position = place, .linear_velocity = velocity, .name = "guest"}, geometry_of(spawn), shape);
    }
    catch (const std::exception& error)
    {
        session_.say(error.what());
    }
}

void Hand::draw(scenes::DrawList& list) const
{
    if (generation_ != session_.generation()) return;
    grabber_.draw(session_.scene().world(), list);
    if (doing_ != Doing::Throwing) return;
    // A sling: the body flies to the other side of where the pointer is.
    constexpr scenes::Color color = scenes::rgb(1, 0.85f, 0.4f);
    const Vec2 place = view_.to_world(pressed_at_);
    list.shape(scenes::Layer::Marks, geometry_of(spawn), {.p = place, .q = {}}, {.fill = with_alpha(color, 0.25f), .line = color});
    list.line(scenes::Layer::Marks, place, view_.to_world(last_), color, 2);
}

} // namespace carom::gallery
