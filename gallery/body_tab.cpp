// The inspector: what the body under the pointer is, and its properties to change while it moves.
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>

namespace carom::gallery
{

namespace
{

constexpr const char* const what_to_do = "Move the pointer over a body. Ctrl and a click pick it, so that it stays here.";

/// A number that can be dragged or typed.
bool number(const char* label, float& value, float speed, const char* format)
{
    return is_meant(ImGui::DragFloat(label, &value, speed, 0, 0, format));
}

void motion(Gallery& gallery, Body body)
{
    Vec2 position = body.position();
    float angle = body.angle();
    Vec2 velocity = body.linear_velocity();
    float spin = body.angular_velocity();
    bool is_moved = is_meant(ImGui::DragFloat2("position", &position.x, 0.05f, 0, 0, "%.3f m"));
    gallery.widgets.note("body position");
    is_moved = number("angle", angle, 0.01f, "%.3f rad") || is_moved;
    if (is_moved) try_edit(gallery, [&] { body.set_transform(position, angle); });
    if (body.type() == BodyType::Static) return;
    if (is_meant(ImGui::DragFloat2("velocity", &velocity.x, 0.1f, 0, 0, "%.3f m/s")))
        try_edit(gallery, [&] { body.set_linear_velocity(velocity); });
    gallery.widgets.note("body velocity");
    if (number("spin", spin, 0.05f, "%.3f rad/s")) try_edit(gallery, [&] { body.set_angular_velocity(spin); });
}

void nature(Gallery& gallery, Body body)
{
    constexpr std::array types = {"static", "kinematic", "dynamic"};
    auto type = static_cast<int>(body.type());
    if (ImGui::Combo("type", &type, types.data(), static_cast<int>(types.size())))
        try_edit(gallery, [&] { body.set_type(static_cast<BodyType>(type)); });
    float gravity_scale = body.gravity_scale();
    float linear = body.linear_damping();
    float angular = body.angular_damping();
    if (number("gravity scale", gravity_scale, 0.02f, "%.2f")) try_edit(gallery, [&] { body.set_gravity_scale(gravity_scale); });
    gallery.widgets.note("body gravity scale");
    if (number("damping", linear, 0.02f, "%.2f /s")) try_edit(gallery, [&] { body.set_linear_damping(linear); });
    if (number("spin damping", angular, 0.02f, "%.2f /s")) try_edit(gallery, [&] { body.set_angular_damping(angular); });
}

void marks(Gallery& gallery, Body body)
{
    bool is_awake = body.is_awake();
    bool is_bullet = body.is_bullet();
    bool can_sleep = body.can_sleep();
    bool is_enabled = body.is_enabled();
    MotionLocks locks = body.locks();
    if (ImGui::Checkbox("awake", &is_awake)) try_edit(gallery, [&] { body.set_awake(is_awake); });
    ImGui::SameLine();
    if (ImGui::Checkbox("may sleep", &can_sleep)) try_edit(gallery, [&] { body.set_can_sleep(can_sleep); });
    ImGui::SameLine();
    if (ImGui::Checkbox("bullet", &is_bullet)) try_edit(gallery, [&] { body.set_is_bullet(is_bullet); });
    if (checkbox(gallery, "enabled", is_enabled)) try_edit(gallery, [&] { body.set_enabled(is_enabled); });
    ImGui::SameLine();
    ImGui::TextDisabled("locks");
    ImGui::SameLine();
    bool is_locked = ImGui::Checkbox("x", &locks.x);
    ImGui::SameLine();
    is_locked = ImGui::Checkbox("y", &locks.y) || is_locked;
    ImGui::SameLine();
    is_locked = ImGui::Checkbox("turn", &locks.rotation) || is_locked;
    if (is_locked) try_edit(gallery, [&] { body.set_locks(locks); });
}

const char* kind_of(const Geometry& geometry)
{
    constexpr std::array names = {"circle", "capsule", "segment", "polygon"};
    static_assert(std::variant_size_v<Geometry> == names.size());
    static_assert(std::is_same_v<std::variant_alternative_t<0, Geometry>, Circle> &&
                  std::is_same_v<std::variant_alternative_t<1, Geometry>, Capsule> &&
                  std::is_same_v<std::variant_alternative_t<2, Geometry>, Segment>);
    return names[geometry.index()];
}

void shape_rows(Gallery& gallery, Shape shape)
{
    ImGui::TextDisabled("%s%s", kind_of(shape.geometry()), shape.is_sensor() ? ", a sensor" : "");
    Material material = shape.material();
    float density = shape.density();
    bool is_changed = number("friction", material.friction, 0.01f, "%.2f");
    gallery.widgets.note("shape friction");
    is_changed = number("restitution", material.restitution, 0.01f, "%.2f") || is_changed;
    is_changed = number("rolling resistance", material.rolling_resistance, 0.002f, "%.3f") || is_changed;
    is_changed = number("belt speed", material.tangent_speed, 0.05f, "%.2f m/s") || is_changed;
    if (is_changed) try_edit(gallery, [&] { shape.set_material(material); });
    if (number("density", density, 0.02f, "%.3f kg/m2")) try_edit(gallery, [&] { shape.set_density(density); });
}

void shapes(Gallery& gallery, const Body& body)
{
    constexpr std::size_t most = 8; // shapes that are listed
    const std::vector<ShapeId> ids = body.shapes();
    for (std::size_t i = 0; i < std::min(ids.size(), most); ++i)
    {
        ImGui::PushID(static_cast<int>(i));
        shape_rows(gallery, gallery.session.scene().world().shape(ids[i]));
        ImGui::PopID();
    }
    if (ids.size() > most) muted("and " + std::to_string(ids.size() - most) + " more");
}

} // namespace

void body_tab(Gallery& gallery)
{
    const std::optional<Body> found = gallery.session.scene().world().find_body(gallery.inspected());
    if (!found) return muted(what_to_do);
    const Body body = *found;
    const std::string name = body.name().empty() ? "Body" : std::string(body.name());
    heading((name + " #" + std::to_string(body.id().index)).c_str());
    muted(gallery.hand.selected() ? "picked; Esc lets it go" : "under the pointer; Ctrl and a click pick it");
    const MassData mass = body.mass_data();
    ImGui::Text("mass %.4g kg, inertia %.4g kg m2", static_cast<double>(mass.mass), static_cast<double>(mass.inertia));
    ImGui::Text("%zu joints", gallery.session.scene().world().joints_of(body.id()).size());
    ImGui::PushItemWidth(-8 * ImGui::GetFontSize());
    motion(gallery, body);
    nature(gallery, body);
    marks(gallery, body);
    heading("Shapes");
    shapes(gallery, body);
    ImGui::PopItemWidth();
}

} // namespace carom::gallery
