// Takes hold of bodies, moves them and lets them go.
#include "scenes/grabber.hpp"

#include "scenes/helpers.hpp"

namespace carom::scenes
{

bool Grabber::on_pointer(World& world, const PointerEvent& event)
{
    constexpr Spring spring{.hertz = 4, .damping_ratio = 1};
    constexpr float accelerations = 600; // how hard it pulls at most [m/s^2]
    const bool is_held = holds(world);
    if (event.action == PointerEvent::Action::Move && is_held)
    {
        MouseJoint mouse = std::get<MouseJoint>(world.joint(joint_).spec());
        mouse.target = event.position;
        world.joint(joint_).set_spec(mouse);
        return true;
    }
    if (event.button != PointerEvent::Button::Left) return false;
    if (event.action == PointerEvent::Action::Up && is_held)
    {
        world.destroy_joint(joint_);
        return true;
    }
    if (event.action != PointerEvent::Action::Down) return false;
    const std::optional<ShapeId> shape = shape_at(world, event.position);
    if (!shape) return false;
    if (is_held) world.destroy_joint(joint_);
    const BodyId body = world.shape(*shape).body();
    const float force = accelerations * world.body(body).mass_data().mass;
    joint_ = world.create_joint(world.joint_at({}, body, event.position), MouseJoint{event.position, spring, force});
    return true;
}

void Grabber::draw(const World& world, DrawList& list) const
{
    const std::optional<JointView> joint = world.find_joint(joint_);
    if (!joint) return;
    constexpr Color color = rgb(1, 0.85f, 0.4f);
    const Vec2 target = std::get<MouseJoint>(joint->spec()).target;
    list.line(Layer::Marks, world.body(joint->body_b()).transform() * joint->frame_b().p, target, color, 2);
}

} // namespace carom::scenes
